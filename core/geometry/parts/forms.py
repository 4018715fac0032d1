"""Prior knowledge of a noun's parts: how flat and how round they are."""

from collections.abc import Collection, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from core.geometry.parts.bodywork import Bodywork
from core.geometry.parts.fitting import Faces

LEAST_FLAT = 0.05  # of a part's surface, from which its components may have flat faces
# Of a part's surface, what is flat of blocks and discs in the mean, at least; and of sharp ones.
BLOCK, SHARP = 0.58, 0.78
STRAY = 0.06  # of the area of a part's least component, what is none of it at most


class Forms(NamedTuple):
    """The forms of the parts, in the mean over a noun's objects."""

    flat: Sequence[float]  # of each, the fraction of its surface that is flat
    round: Sequence[Sequence[float]]  # and the same all around, along x, along y, along z
    cornered: Collection[int] = ()  # parts with so many corners that they look round
    # Each part's smallest component's area, as a fraction of its largest one's; 0: not known.
    least: Sequence[float] = ()
    # How thick the real part is, by that of what is drawn; (): all as they are drawn.
    slender: Sequence[float] = ()
    bodywork: Mapping[int, Bodywork] = MappingProxyType({})  # of the parts that get it
    curved: Collection[int] = ()  # parts that a stack of flat outlines is near, and is not

    def may_be_flat(self, part: int) -> bool:
        """Whether components of the part may have flat faces. The table knows nothing of what is
        small or was never seen."""
        known = self.flat[part] or any(axis[part] for axis in self.round)
        return not known or self.flat[part] >= LEAST_FLAT

    def is_stray(self, part: int, fraction: float) -> bool:
        """Whether a component is far smaller than any that the part has; ``fraction``: its area, as
        a fraction of the largest one's."""
        return part < len(self.least) and fraction < STRAY * self.least[part]

    def thickness(self, part: int) -> float:
        """How many times as thick as it is drawn the part is."""
        return self.slender[part] if part < len(self.slender) else 1.0

    def faces(self, part: int) -> Faces:
        """The prior knowledge of the faces of the part's components."""
        flat = self.flat[part]
        return Faces(self.may_be_flat(part), flat >= BLOCK, flat >= SHARP, part in self.cornered)
