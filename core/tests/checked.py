"""Checks of calls while the tests run (``conftest.py``): types by beartype, shapes by jaxtyping.

A check costs about as much as a small function. So a function, and the making of a dataclass, is
checked at its first calls in each test, where a wrong use shows, at one in ten of those after, and
at one in a hundred of more than a thousand; and the checks of equal signatures are made
once.
"""

import dataclasses
import functools
import inspect
from collections.abc import Callable
from typing import Any

import jaxtyping
from beartype import BeartypeConf, beartype
from jaxtyping import AbstractArray

ALL = 20  # calls of a function in a test that are all checked
THEN = 10  # of those after, one in so many is
MANY = 1000  # of those after, one in THEN * THEN

_calls: dict[int, int] = {}  # of a function's code, by its id, in the test that runs
_always = jaxtyping.jaxtyped


def forget_calls() -> None:
    """A test begins: all functions are checked again."""
    _calls.clear()


def jaxtyped(function: Any = None, *, typechecker: Callable) -> Any:
    """``jaxtyping.jaxtyped``, for the import hook, whose checks are those above."""
    if function is None:
        return functools.partial(jaxtyped, typechecker=typechecker)
    if dataclasses.is_dataclass(function):  # checked where it is made
        if getattr(function.__init__, "__globals__", {}).get("__name__") != __name__:
            function.__init__ = jaxtyped(function.__init__, typechecker=typechecker)
        return function
    if not inspect.isfunction(function):
        return _always(function, typechecker=typechecker)
    key, check = id(function.__code__), None

    @functools.wraps(function)
    def checked(*args: Any, **kwargs: Any) -> Any:
        nonlocal check
        count = _calls[key] = _calls.get(key, 0) + 1
        if count > ALL and count % (THEN if count <= MANY else THEN * THEN):
            return function(*args, **kwargs)
        if check is None:  # a function within a function is mostly called less often than defined
            check = _always(function, typechecker=typechecker)
        return check(*args, **kwargs)

    return checked


# An int is accepted as a float, as in PEP 484.
_check = beartype(conf=BeartypeConf(is_pep484_tower=True))
_made: dict[tuple, Callable] = {}


def once(signature: Callable) -> Callable:
    """``signature``, checked.

    What jaxtyping hands over has the signature of a function and no body: first without the result,
    for the arguments before the call, then with it, for the result after the call; the arguments
    need not be checked again. A function within a function is defined at each call of the outer
    one, with the same signature each time.
    """
    result = signature.__annotations__.get("return", Any)
    if result is not Any:
        signature.__annotations__ = {"return": result}
    values = signature.__defaults__ or signature.__kwdefaults__
    if values or not all(map(_lasts, signature.__annotations__.values())):
        return _check(signature)
    key = signature.__module__, signature.__code__, *signature.__annotations__.items()
    if key not in _made:
        _made[key] = _check(signature)
    return _made[key]


def _lasts(annotation: object) -> bool:
    """Whether it is the same object at each definition; a shape is a new class each time."""
    return isinstance(annotation, type) and not issubclass(annotation, AbstractArray)
