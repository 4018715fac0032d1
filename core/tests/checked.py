"""beartype's checks of signatures, made once for those that are alike (``conftest.py``)."""

from collections.abc import Callable
from typing import Any

from beartype import BeartypeConf, beartype
from jaxtyping import AbstractArray

# An int may stand for a float, as PEP 484 has it.
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
