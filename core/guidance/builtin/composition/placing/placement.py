"""Placements of a composition's things, and the form that placing needs to know."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.cut import CutParts
from core.guidance.builtin.constructed.solid import ConstructedSolid
from core.guidance.builtin.palette import looks
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.words.phrases.slots import Words

EYES = ("eyes", "whites", "glasses", "visor")
NEAR = 0.03  # training units
FLAT = 0.6  # times as thick as wide
LONG = 1.5  # times as long as wide: two stand one behind the other
# Quarter turns: about the horizontal axes and the vertical.
Z_TO_BACK = torch.tensor([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])  # -y is in front
Z_TO_X = torch.tensor([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
X_TO_Y = torch.tensor([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


@dataclass(frozen=True)
class Placement:
    """From a thing's own points to the composition's: scale * turn @ p + shift."""

    scale: float
    shift: Float[Tensor, " 3"]
    turn: Float[Tensor, "3 3"]  # a rotation

    @classmethod
    def of(cls, scale: float = 1.0, turn: Float[Tensor, "3 3"] | None = None) -> "Placement":
        """A placement around the origin."""
        return cls(scale, torch.zeros(3), torch.eye(3) if turn is None else turn)

    def moved(self, shift: Float[Tensor, " 3"]) -> "Placement":
        """The placement moved by ``shift``."""
        return replace(self, shift=self.shift + shift)

    def then(self, scale: float, shift: Float[Tensor, " 3"]) -> "Placement":
        """The placement scaled around the origin, then moved."""
        return Placement(self.scale * scale, self.shift * scale + shift, self.turn)

    def of_copy(self, copy: "Placement") -> "Placement":
        """The placement of a copy in a group with this placement."""
        return Placement(
            self.scale * copy.scale, self.out(copy.shift[None])[0], self.turn @ copy.turn
        )

    def inverted(self) -> "Placement":
        """From the composition's points to the thing's own."""
        turn = self.turn.T
        return Placement(1 / self.scale, -self.shift @ turn.T / self.scale, turn)

    def out(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points of the thing in the composition."""
        return self.scale * points @ self.turn.T.to(points) + self.shift.to(points)

    def into(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points of the composition in the thing's own coordinates."""
        return (points - self.shift.to(points)) @ self.turn.to(points) / self.scale


@dataclass(frozen=True)
class Body:
    """A drawn thing as points of its surface, about evenly spread, each with its part."""

    words: Words
    verts: Float[Tensor, "v 3"]
    faces: Int[Tensor, "f 3"]
    part: Int[Tensor, " v"]
    metres: float = 1.0  # metres of a training unit
    rests: Placement | None = None  # of its seat or mount; of a filling, its own
    standing: "Body | None" = None  # before it sits, its trunk in the same place
    carried: Placement | None = None  # if its trunk is not there: from there to where it is

    @classmethod
    def of(cls, words: Words, solid: Solid, parts: KnownParts | None = None) -> "Body":
        """From the thing's network; ``parts``: what is made of it, which may be thinner."""
        verts, faces = (of.cpu() for of in solid.mesh)
        if isinstance(solid, ConstructedSolid):
            return cls(words, verts, faces, solid.part_of_mesh)._of_usual_size()
        distances = solid.distances(verts)
        part = distances.argmin(1)
        # A part inside a face, such as a figure's eyes, has no vertex of its own.
        for small in (k for k, name in enumerate(looks(words.noun)) if name in EYES):
            part[distances[:, small] < NEAR] = small
        verts = verts if parts is None else parts.settled(verts, part)
        body = cls(words, verts, faces, part)
        if words.cut == "slice" and isinstance(parts, CutParts):
            body = body._of_verts(parts.tool.distance(verts) > 0)
        return body._of_usual_size()

    def _of_usual_size(self) -> "Body":
        size = self.words.size
        longest = size.longest(self.sides.tolist()) if size else self.words.usual()[0]
        return replace(self, metres=longest / self.longest)

    def placed(self, placement: Placement) -> "Body":
        """The thing at a placement."""
        metres = self.metres / placement.scale
        standing, carried = self.standing and self.standing.placed(placement), self.carried
        if carried is not None:
            carried = placement.of_copy(carried).of_copy(placement.inverted())
        posed = {"standing": standing, "carried": carried}
        return replace(self, verts=placement.out(self.verts), metres=metres, **posed)

    def group(self, copies: "Sequence[Placement]") -> "Body":
        """Several copies of the thing as one."""
        return joined([self.placed(copy) for copy in copies])

    @cached_property
    def box(self) -> Float[Tensor, "2 3"]:
        """Its lowest and highest corner."""
        return torch.stack([self.verts.amin(0), self.verts.amax(0)])

    @property
    def sides(self) -> Float[Tensor, " 3"]:
        """The box's extents along x, y and z."""
        return self.box[1] - self.box[0]

    @property
    def longest(self) -> float:
        """The longest extent."""
        return float(self.sides.max())

    @property
    def usual(self) -> float:
        """The longest extent in metres."""
        return self.metres * self.longest

    def cell(self, index: int, count: int) -> "Body":
        """One of ``count`` cells seen from above, in rows from the back to the front, or in one row
        of a long thing; the rest is flattened."""
        x, y = self.sides[:2].tolist()
        columns = count if x > LONG * y else 1 if y > LONG * x else math.ceil(math.sqrt(count))
        rows = math.ceil(count / columns)
        row, column = divmod(index, columns)
        own = min(columns, count - row * columns)  # the last row may have fewer
        low, high = (
            torch.tensor([column / own, 1 - (row + 1) / rows]),
            torch.tensor([(column + 1) / own, 1 - row / rows]),
        )
        start, sides = self.box[0, :2], self.sides[:2]
        verts = self.verts.clone()
        verts[:, :2] = verts[:, :2].clamp(start + low * sides, start + high * sides)
        return replace(self, verts=verts)

    def bare(self, *names: str) -> "Body":
        """The thing without the faces of the named parts."""
        gone = self.among(*names)[self.faces].any(1)
        return replace(self, faces=self.faces[~gone])

    def only(self, *names: str) -> "Body":
        """The named parts alone; the whole thing where it has none of them."""
        return self._of_verts(self.among(*names))

    def _of_verts(self, verts: Bool[Tensor, " v"]) -> "Body":
        """The faces between these vertices alone; the whole thing where there are none."""
        kept = verts[self.faces].all(1)
        if not kept.any():
            return self
        used, faces = self.faces[kept].unique(return_inverse=True)
        return replace(self, verts=self.verts[used], part=self.part[used], faces=faces)

    def of_parts(self, *names: str) -> Float[Tensor, "n 3"]:
        """The points of the named parts."""
        return self.verts[self.among(*names)]

    def without(self, *names: str) -> Float[Tensor, "n 3"]:
        """The points of all other parts; all points without others."""
        rest = self.verts[~self.among(*names)]
        return rest if len(rest) else self.verts

    def among(self, *names: str) -> Bool[Tensor, " v"]:
        """Which points belong to the named parts."""
        rows = [k for k, name in enumerate(looks(self.words.noun)) if name in names]
        return torch.isin(self.part, torch.tensor(rows, dtype=self.part.dtype))


def joined(bodies: Sequence[Body]) -> Body:
    """All of them as one thing, with the first one's words."""
    starts = [sum(len(body.verts) for body in bodies[:k]) for k in range(len(bodies))]
    faces = [body.faces + start for body, start in zip(bodies, starts, strict=True)]
    verts, part = (torch.cat([getattr(body, of) for body in bodies]) for of in ("verts", "part"))
    return replace(bodies[0], verts=verts, faces=torch.cat(faces), part=part)


def sized(thing: Body, other: Body, least: float, most: float) -> float:
    """The factor on ``thing`` for the usual ratio of its size to ``other``'s; its longest side
    becomes ``least`` to ``most`` times the other's, so that it stays visible."""
    wanted = min(max(thing.usual / other.usual, least), most)
    return wanted * other.longest / thing.longest


def laid_down(thing: Body, high: float) -> Float[Tensor, "3 3"]:
    """The rotation that lays down a flat thing, such as a coin, or one that is more than ``high``
    times as high as wide."""
    x, y, z = thing.sides.tolist()
    if min(x, y) < FLAT * z and min(x, y) < FLAT * max(x, y):
        return about_x(-math.pi / 2) if y < x else Z_TO_X
    return about_x(-math.pi / 2) if z > high * max(x, y) else torch.eye(3)


def about_z(angle: float) -> Float[Tensor, "3 3"]:
    """A rotation about the vertical."""
    c, s = math.cos(angle), math.sin(angle)
    return torch.tensor([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def about_x(angle: float) -> Float[Tensor, "3 3"]:
    """A rotation about the axis from left to right."""
    c, s = math.cos(angle), math.sin(angle)
    return torch.tensor([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


def about_y(angle: float) -> Float[Tensor, "3 3"]:
    """A rotation about the axis from the front to the back."""
    c, s = math.cos(angle), math.sin(angle)
    return torch.tensor([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
