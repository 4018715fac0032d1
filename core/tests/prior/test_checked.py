"""While the tests run, each call's types and shapes are checked, a function's in a function too."""

from dataclasses import dataclass

import pytest
import torch
from jaxtyping import Float, TypeCheckError, jaxtyped
from torch import Tensor

from core.prior.solids import box
from core.tests import checked


def scaled(kind):
    @jaxtyped(typechecker=checked.once)
    def by(value: kind, factor: int) -> kind:
        return value * factor if factor else None

    return by


@pytest.mark.parametrize(
    ("kind", "made", "right", "wrong"),
    [
        (Tensor, 0, torch.ones(5, 3), 1.0),
        (Float[Tensor, "n 3"], 0, torch.ones(5, 3), torch.ones(5, 4)),
        (Float[Tensor, "n 2"], 0, torch.ones(5, 2), torch.ones(5, 3)),
        (bytes, 2, b"a", "a"),  # other classes have checks of their own: arguments, result
    ],
)
def test_a_check_is_made_once_for_functions_with_equal_signatures(kind, made, right, wrong):
    scaled(Tensor)(torch.ones(1), 1)
    before = len(checked._made)
    functions = scaled(kind), scaled(kind)
    assert all(len(function(right, 2)) in (2, 5) for function in functions)
    assert len(checked._made) == before + made
    for function in functions:
        for arguments in ((wrong, 2), (right, 1.5), (right, 0)):
            with pytest.raises(TypeCheckError):
                function(*arguments)


def test_the_cores_functions_are_checked_and_those_within_them():
    for _ in range(2):
        solid = box((0, 0, 0), (1.0, 1, 1))  # an int is accepted as a float
        assert solid(torch.zeros(1, 3)) == -1
        with pytest.raises(TypeCheckError):
            solid([0.0, 0.0, 0.0])
    with pytest.raises(TypeCheckError):
        box((0, 0), (1, 1, 1))


@checked.jaxtyped(typechecker=checked.once)
def doubled(value: Tensor) -> object:
    return 2 * value


@checked.jaxtyped(typechecker=checked.once)
@dataclass(frozen=True)
class Kept:
    value: Tensor


@pytest.mark.parametrize("doubled", [doubled, Kept])
def test_what_is_called_often_is_still_checked_now_and_then(doubled):
    assert doubled(torch.ones(1)) is not None
    checked.forget_calls()

    def refused(calls: int) -> int:
        count = 0
        for _ in range(calls):
            try:
                doubled(1.0)
            except TypeCheckError:
                count += 1
        return count

    assert refused(checked.ALL) == checked.ALL
    assert refused(5 * checked.THEN) == 5
    refused(checked.MANY)
    assert refused(5 * checked.THEN**2) == 5
    checked.forget_calls()  # as at the next test's begin
    assert refused(1) == 1


def test_a_result_is_held_to_the_arguments_sizes():
    @jaxtyped(typechecker=checked.once)
    def rest(points: Float[Tensor, "n 3"], first: int) -> Float[Tensor, "n 3"]:
        return points[first:]

    assert len(rest(torch.ones(5, 3), 0)) == 5
    with pytest.raises(TypeCheckError, match="the return value"):
        rest(torch.ones(5, 3), 1)
