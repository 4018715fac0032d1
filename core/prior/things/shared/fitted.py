"""A wrapper for families whose objects would exceed the bounds of a family."""

from collections.abc import Callable

from core.prior.draw import Draw
from core.prior.solids import Parts, Solid


def fitted(family: Callable[[Draw], Parts]) -> Callable[[Draw], Parts]:
    """``family`` made smaller and moved back, so that a long animal stays within the bounds."""

    def smaller(solid: Solid) -> Solid:
        return lambda p: solid((p - p.new_tensor((0, 0.2, -0.4))) / 0.72) * 0.72

    return lambda draw: {name: smaller(solid) for name, solid in family(draw).items()}
