"""A drawn thing in another pose than its rest pose: bones, each a region that is moved.

A bone has the part of the rest pose in its region, moved rigidly or bent about an axis; both have
an exact inverse, so that the posed thing's distances are known everywhere. The regions of
neighbours overlap at their joint in a ball, so that it is filled.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.appearance.material_ranges import MaterialRanges
from core.geometry.fan import Fan
from core.geometry.init_shape import Shape
from core.geometry.mesh import Mesh
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import Component
from core.geometry.union import Region, clipped
from core.guidance.builtin.areas import AreaFields, Field, Heights, SolidAreas
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.solid import Solid
from core.guidance.guidance import Predictions, Surface, Views

CRUMB = 1.5e-4  # cubic training units: what is cut off and smaller belongs to a neighbour
NOWHERE = 9.0  # training units: the distance from no region at all
KNOWN = 0.12  # training units: what is farther from a bone's region is not looked at

Distances = Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n p"]]


@dataclass(frozen=True)
class Bone:
    """The part of the rest pose inside some regions, or outside all of them, and its motion."""

    regions: tuple[Region, ...]
    place: Placement
    within: bool = True
    bend: Fan | None = None  # of the rest pose, before it is placed
    top: float = math.inf  # z in the rest pose; above it is as at this height

    def moved(self, by: Float[Tensor, " 3"]) -> "Bone":
        """The bone of a thing moved by so much."""
        back = by - self.place.turn @ by * self.place.scale
        regions = tuple(region.moved(by) for region in self.regions)
        bend = self.bend and self.bend.moved(by)
        top = self.top + float(by[2])
        return replace(self, regions=regions, place=self.place.moved(back), bend=bend, top=top)

    def out(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points of the rest pose in the pose."""
        return self.place.out(self.bend.out(points) if self.bend else points)

    def into(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points of the pose in the rest pose."""
        points = self.place.into(points)
        return self.bend.into(points) if self.bend else points

    def like(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points of the rest pose, or those which they are like."""
        return torch.cat([points[:, :2], points[:, 2:].clamp_max(self.top)], 1)

    def seen(self, surface: Float[Tensor, "b 7 s s"]) -> Float[Tensor, "b 7 s s"]:
        """The pictures' normals and points in the rest pose."""
        found = seen_from(surface, self.place)
        return _unbent(found, self.bend) if self.bend else found

    def gap(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Signed distances of points of the rest pose from the bone's region."""
        each = [_distance(region, points) for region in self.regions]
        gap = torch.stack(each).amin(0) if each else torch.full_like(points[:, 0], NOWHERE)
        return gap if self.within else -gap


def _distance(region: Region, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
    """The distance from a box and its capsules."""
    low, high = (end.to(points) for end in region.box)
    beyond = torch.maximum(low - points, points - high)
    found = beyond.clamp_min(0).norm(dim=1) + beyond.amax(1).clamp_max(0)
    for start, end, radius in region.capsules:
        way, from_start = (end - start).to(points), points - start.to(points)
        fraction = ((from_start @ way) / way.square().sum().clamp_min(1e-12)).clamp(0, 1)
        found = torch.minimum(found, (from_start - fraction[:, None] * way).norm(dim=1) - radius)
    return found


@dataclass(frozen=True)
class Pose:
    """The bones of a thing, the trunk first."""

    bones: tuple[Bone, ...]

    def owner(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """The bone of each point of the rest pose."""
        gaps = torch.stack([bone.gap(points) for bone in self.bones], 1)
        inside = (gaps <= 0).long()  # of several the first
        return torch.where(inside.any(1), inside.argmax(1), gaps.argmin(1))

    def out(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Points of the rest pose in the pose."""
        owner, found = self.owner(points), points.clone()
        for index, bone in enumerate(self.bones):
            mine = owner == index
            found[mine] = bone.out(points[mine])
        return found

    def moved(self, by: Float[Tensor, " 3"]) -> "Pose":
        """The pose of a thing moved by so much."""
        return Pose(tuple(bone.moved(by) for bone in self.bones))

    def then(self, scale: float, shift: Float[Tensor, " 3"]) -> "Pose":
        """The posed thing scaled around the origin, then moved."""
        return Pose(
            tuple(replace(bone, place=bone.place.then(scale, shift)) for bone in self.bones)
        )

    def body(self, body: Body) -> Body:
        """The posed body of a drawn thing."""
        return replace(
            body, verts=self.out(body.verts), metres=body.metres / self.bones[0].place.scale
        )

    def distances(self, known: Distances) -> Distances:
        """Distances of parts in the pose, from those in the rest pose."""

        def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
            return torch.stack(self._each(known, points)).amin(0)

        return at

    def field(self, known: Field) -> Field:
        """Areas in the pose, from those in the rest pose."""
        posed = self.distances(in_one(known))

        def at(points: Float[Tensor, "n 3"]) -> tuple[Float[Tensor, " n"], Float[Tensor, "n a"]]:
            found = posed(points)
            return found[:, 0], -found[:, 1:]

        return at

    def heights(self, rest: AreaFields) -> Heights:
        """Heights of the areas in the pose, from those in the rest pose."""
        known = in_one(rest.near)

        def at(points: Float[Tensor, "n 3"], area: Int[Tensor, " n"]) -> Float[Tensor, " n"]:
            found, bone = torch.zeros_like(points[:, 0]), self.bone_at(known, points)
            for index, one in enumerate(self.bones):
                here = (bone == index).nonzero().squeeze(1)
                own = rest.heights(one.like(one.into(points[here])), area[here])
                found[here] = own * one.place.scale
            return found

        return at

    def bone_at(self, known: Distances, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """The bone whose surface each point of the posed thing is on."""
        return torch.stack([one.amin(1) for one in self._each(known, points)], 1).argmin(1)

    def _each(self, known: Distances, points: Float[Tensor, "n 3"]) -> list[Tensor]:
        """The distances from each bone's parts."""
        found = []
        for bone in self.bones:
            rest = bone.into(points)
            gap = bone.gap(rest)
            near = gap < KNOWN
            own = known(bone.like(rest[near]))
            whole = gap[:, None].expand(-1, own.shape[1]).clone()
            whole[near] = torch.maximum(own, gap[near, None])
            found.append(whole * bone.place.scale)
        return found


class PosedParts(KnownParts):
    """The parts of a thing in a pose."""

    def __init__(self, rest: KnownParts, pose: Pose) -> None:
        super().__init__(pose.distances(rest.distances), rest.forms)
        self.rest, self.pose = rest, pose
        self._cut_off: dict[tuple[int, int, bool], tuple[Tensor, Tensor]] = {}

    @cached_property
    def components(self) -> list[Component]:
        """Each component's fraction in each bone, in the rest pose."""
        return [self.rest.components[index] for index, _ in self._cut]

    def surface_of(self, index: int, exact: bool = True) -> tuple[Tensor, Tensor]:
        """A bone's part of a component's surface."""
        return self._of_bone(*self._cut[index], exact)

    def near(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances from their exact surfaces."""
        return self.pose.distances(self.rest.near)(points)

    @cached_property
    def _cut(self) -> list[tuple[int, int]]:
        """The components and their bones."""
        bones = range(len(self.pose.bones))
        pairs = [(k, bone) for k in range(len(self.rest.components)) for bone in bones]
        return [pair for pair in pairs if len(self._of_bone(*pair, exact=True)[1])]

    def _of_bone(self, component: int, index: int, exact: bool) -> tuple[Tensor, Tensor]:
        key = (component, index, exact)
        if key not in self._cut_off:
            bone = self.pose.bones[index]
            surface = self.rest.surface_of(component, exact)
            verts, faces = clipped(surface, bone.regions, bone.within, CRUMB)
            self._cut_off[key] = bone.out(verts), faces
        return self._cut_off[key]


class Posed:
    """A drawn thing in a pose."""

    def __init__(self, rest: Thing, pose: Pose) -> None:
        self.rest, self.pose = rest, pose
        self.words, self.solid = rest.words, rest.solid

    def of_object(self, seed: int) -> Thing:
        """A new object in its rest pose."""
        return self.rest.of_object(seed)

    def with_solid(self, solid: Solid) -> Thing:
        """The same with another solid, in its rest pose."""
        return self.rest.with_solid(solid)

    def in_proportion(self, guide: Mesh, strength: float, least: float) -> Thing:
        """In the proportions of a guide, which has a pose of its own."""
        return self.rest.in_proportion(guide, strength, least)

    def start_shape(self) -> Shape | None:
        """In the rest pose."""
        return self.rest.start_shape()

    def parts(self) -> KnownParts | None:
        """In the pose."""
        return self._parts

    @cached_property
    def _parts(self) -> KnownParts | None:
        rest = self.rest.parts()
        return rest and PosedParts(rest, self.pose)

    def area_fields(self) -> AreaFields | None:
        """In the pose."""
        rest = self.rest.area_fields()
        if rest is None:
            return None
        drawn, near = (self.pose.field(field) for field in (rest.drawn, rest.near))
        return AreaFields(drawn, near, rest.each, self.pose.heights(rest))

    def areas(self) -> SolidAreas | None:
        """The same on a lattice."""
        fields = self.area_fields()
        return fields and SolidAreas(fields.drawn, fields.each, fields.near, fields.heights)

    def ranges(self) -> MaterialRanges:
        """As in the rest pose."""
        return self.rest.ranges()

    def surfaces(self) -> tuple[Surface, ...]:
        """As in the rest pose."""
        return self.rest.surfaces()

    def style(self) -> str:
        """As in the rest pose."""
        return self.rest.style()

    def left_out(self) -> tuple[str, ...]:
        """Notes."""
        return self.rest.left_out()

    def restore(
        self, pictures: Float[Tensor, "b 4 s s"], views: Views
    ) -> Float[Tensor, "b 4 s s"] | None:
        """As in the rest pose."""
        return self.rest.restore(pictures, views)

    def predict(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        views: Views,
        *,
        cond_only: bool = False,
        apart: bool = False,
    ) -> Predictions:
        """Each place as seen in the rest pose."""
        parts = self.rest.parts()
        if views.surface is not None and parts is not None:
            views = Views(views.cameras, self._at_rest(views.surface, parts))
        return self.rest.predict(z_t, t, views, cond_only=cond_only, apart=apart)

    def _at_rest(
        self, surface: Float[Tensor, "b 7 s s"], parts: KnownParts
    ) -> Float[Tensor, "b 7 s s"]:
        """The pictures' normals and points in the rest pose of their bones."""
        seen, points = points_of(surface)
        owner = torch.zeros_like(seen, dtype=torch.long)
        owner[seen] = self.pose.bone_at(parts.distances, points[seen])
        at_rest = surface
        for index, bone in enumerate(self.pose.bones):
            mine = (owner == index)[:, None]
            at_rest = torch.where(mine, bone.seen(surface), at_rest)
        return at_rest


def in_one(field: Field) -> Distances:
    """A field's distance and distances from each area."""

    def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, "n a"]:
        distance, depths = field(points)
        return torch.cat([distance[:, None], -depths], 1)

    return at


def points_of(
    surface: Float[Tensor, "b 7 s s"],
) -> tuple[Bool[Tensor, "b s s"], Float[Tensor, "b s s 3"]]:
    """A mask of the object in the pictures, and its points."""
    covered = (surface[:, 3] + 1) / 2
    points = surface[:, 4:] / covered[:, None].clamp_min(1e-3)
    return surface[:, 3] > -1, points.permute(0, 2, 3, 1)


def seen_from(surface: Float[Tensor, "b 7 s s"], place: Placement) -> Float[Tensor, "b 7 s s"]:
    """The pictures' normals and points in the coordinates of a placed thing."""
    rows = surface.permute(0, 2, 3, 1)
    normals, mask, points = rows[..., :3], rows[..., 3:4], rows[..., 4:]
    turn, shift = place.turn.to(surface), place.shift.to(surface)
    points = (points - shift * (mask + 1) / 2) @ turn / place.scale  # they are weighted by coverage
    return torch.cat([normals @ turn, mask, points], -1).permute(0, 3, 1, 2)


def _unbent(surface: Float[Tensor, "b 7 s s"], bend: Fan) -> Float[Tensor, "b 7 s s"]:
    """The pictures' normals and points before the bend."""
    _, bent = points_of(surface)
    shape = bent.shape[:-1]
    points, by = bend.into(bent.reshape(-1, 3)).view(bent.shape), bend.turn_at(bent.reshape(-1, 3))
    cos, sin = by.view(shape).cos(), by.view(shape).sin()
    x, y, z, mask = surface[:, :4].unbind(1)
    covered = (mask + 1) / 2
    normals = torch.stack([x, cos * y - sin * z, cos * z + sin * y, mask], 1)
    return torch.cat([normals, (points * covered[..., None]).permute(0, 3, 1, 2)], 1)


def joint(
    at: Float[Tensor, " 3"], turn: Float[Tensor, "3 3"], to: Float[Tensor, " 3"]
) -> Placement:
    """A rotation about a joint of the rest pose, which is moved to ``to``."""
    return Placement(1.0, to - turn @ at, turn)
