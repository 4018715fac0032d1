"""What is known of a noun's parts before one looks: how flat and how round they are."""

from collections.abc import Collection, Sequence
from typing import NamedTuple

from core.geometry.parts.fitting import Faces

LEAST_FLAT = 0.05  # of a part's surface, from which its pieces may have flat faces
# Of a part's surface, what is flat of blocks and discs in the mean, at least; and of sharp ones.
BLOCK, SHARP = 0.58, 0.78
STRAY = 0.06  # of the area of a part's least piece, what is none of it at most


class Forms(NamedTuple):
    """What the parts are like, in the mean over a noun's objects."""

    flat: Sequence[float]  # of each, the fraction of its surface that is flat
    round: Sequence[Sequence[float]]  # and the same all around, along x, along y, along z
    cornered: Collection[int] = ()  # parts of corners that are too many to be told from round
    # Of each the area of its least piece, as a fraction of its largest one's; 0 where that is not
    # known.
    least: Sequence[float] = ()

    def may_be_flat(self, part: int) -> bool:
        """Whether pieces of the part may have flat faces; of what is small or was never seen the
        table knows nothing."""
        known = self.flat[part] or any(axis[part] for axis in self.round)
        return not known or self.flat[part] >= LEAST_FLAT

    def is_stray(self, part: int, share: float) -> bool:
        """Whether a piece is far smaller than any that the part has; ``share``: its area, as a
        fraction of the largest one's."""
        return part < len(self.least) and share < STRAY * self.least[part]

    def faces(self, part: int) -> Faces:
        """What is known of the faces of the part's pieces."""
        flat = self.flat[part]
        return Faces(self.may_be_flat(part), flat >= BLOCK, flat >= SHARP, part in self.cornered)
