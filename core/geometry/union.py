"""The union of closed meshes as one closed mesh; the only file that imports manifold3d.

Its result is a manifold whatever the meshes' positions are (Smith, "Towards robust inexact
geometric computation", 2009).
"""

import itertools
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import manifold3d
import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.struts import MOST_STRUTS, struts

ROUND = 16  # segments of a strut's ends, and of a ball that rounds edges
PLANE = 2e-3  # how far an eroded surface may be off, training units
JOINT = 48  # of a joint's
WHOLE = 1 - 1e-6  # of a mesh's volume: nothing is cut off


def union(
    meshes: Sequence[tuple[Tensor, Tensor]], strut: float, off: float = 0.0
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """All of ``meshes`` (vertices, faces), closed and facing outwards, as one; what does not touch
    is joined.

    Args:
        strut: radius of the capsules between components that do not touch; 0 leaves them apart.
        off: how far a surface of fewer faces may be off; 0: all faces stay.
    """
    whole = manifold3d.Manifold.batch_boolean([_solid(*m) for m in meshes], manifold3d.OpType.Add)
    for _ in range(MOST_STRUTS if strut else 0):
        # The wall of a void comes as a component of its own, inside out.
        solid = [component for component in whole.decompose() if component.volume() > 0]
        components = sorted(solid, key=lambda component: component.volume())
        if len(components) < 2:
            break
        for ends in struts(_verts(components[0]), np.concatenate([*map(_verts, components[1:])])):
            whole = whole + _capsule(*ends, strut)
    made = (whole.simplify(off) if off else whole).to_mesh()
    verts, faces = made.vert_properties[:, :3], made.tri_verts.astype(np.int64)
    first, _ = meshes[0]
    return torch.from_numpy(np.array(verts)).to(first), torch.from_numpy(faces).to(first.device)


class Region(NamedTuple):
    """A box, and capsules, each from one point to another with a radius; their union."""

    box: tuple[Float[Tensor, " 3"], Float[Tensor, " 3"]]  # the lowest and the highest corner
    capsules: Sequence[tuple[Float[Tensor, " 3"], Float[Tensor, " 3"], float]] = ()

    def moved(self, by: Float[Tensor, " 3"]) -> "Region":
        """Farther by so much."""
        low, high = self.box
        capsules = [(start + by, end + by, radius) for start, end, radius in self.capsules]
        return Region((low + by, high + by), capsules)


def clipped(
    mesh: tuple[Tensor, Tensor], regions: Sequence[Region], within: bool, least: float = 0.0
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """The part of a closed mesh within regions, or outside all of them; maybe nothing. What is cut
    off and has less than the volume ``least`` is left out."""
    solid, room = _solid(*mesh), _added(map(_room, regions))
    cut = (solid ^ room) if within else (solid - room)
    if least and cut.volume() < WHOLE * solid.volume():
        cut = _added(one for one in cut.decompose() if one.volume() >= least)
    made = cut.to_mesh()
    verts, faces = made.vert_properties[:, :3], made.tri_verts.astype(np.int64)
    return torch.from_numpy(np.array(verts)).to(mesh[0]), torch.from_numpy(faces).to(mesh[1].device)


def less(
    mesh: tuple[Tensor, Tensor], other: tuple[Tensor, Tensor]
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """A closed mesh without what is inside another one; maybe nothing."""
    return _like(mesh, _solid(*mesh) - _solid(*other))


def common(
    mesh: tuple[Tensor, Tensor], other: tuple[Tensor, Tensor]
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """What is inside both of two closed meshes; maybe nothing."""
    return _like(mesh, _solid(*mesh) ^ _solid(*other))


def eroded(
    mesh: tuple[Tensor, Tensor], radius: float
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """What is farther inside a closed mesh than ``radius``; maybe nothing. A face takes some
    milliseconds."""
    solid = _solid(*mesh).minkowski_difference(manifold3d.Manifold.sphere(radius, ROUND))
    return _like(mesh, solid.simplify(PLANE))


def dilated(
    mesh: tuple[Tensor, Tensor], radius: float
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """A closed mesh and all that is nearer to it than ``radius``."""
    return _like(mesh, _solid(*mesh).minkowski_sum(manifold3d.Manifold.sphere(radius, ROUND)))


def refined(
    mesh: tuple[Tensor, Tensor], edge: float
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """A closed mesh with edges of about ``edge`` at most: the old ones are divided so."""
    return _like(mesh, _solid(*mesh).refine_to_length(edge))


def joined_to_largest(
    meshes: Sequence[tuple[Tensor, Tensor]], gap: float, least: float
) -> list[tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]]:
    """Of each mesh what belongs to the largest component of the union of all, or is nearer to that
    than ``gap``; what has less than the volume ``least`` by itself is left out."""
    solids = [_solid(*mesh) for mesh in meshes]
    whole = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)
    each = sorted(whole.decompose(), key=lambda one: -one.volume())
    near = [one for one in each[1:] if one.volume() > 0 and each[0].min_gap(one, gap) < gap]
    kept = _added([each[0], *near])
    found = []
    for mesh, solid in zip(meshes, solids, strict=True):
        pieces = [one for one in solid.decompose() if one.volume() > least]
        mine = [one for one in pieces if (one ^ kept).volume() > one.volume() / 2]
        found.append(_like(mesh, _added(mine)) if len(mine) < len(pieces) else mesh)
    return found


def volume(mesh: tuple[Tensor, Tensor]) -> float:
    """Of a closed mesh."""
    return _solid(*mesh).volume()


def _like(
    mesh: tuple[Tensor, Tensor], solid: manifold3d.Manifold
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """A solid as a mesh of the same type as another one."""
    made = solid.to_mesh()
    verts, faces = made.vert_properties[:, :3], made.tri_verts.astype(np.int64)
    return torch.from_numpy(np.array(verts)).to(mesh[0]), torch.from_numpy(faces).to(mesh[1].device)


def _room(region: Region) -> manifold3d.Manifold:
    low, high = (end.double().numpy() for end in region.box)
    box = manifold3d.Manifold.cube([float(side) for side in high - low])
    ends = [
        _capsule(start.double().numpy(), end.double().numpy(), radius, JOINT)
        for start, end, radius in region.capsules
    ]
    return _added([box.translate([float(x) for x in low]), *ends])


def rounded_box(
    half: Float[np.ndarray, " 3"], rim: float, edge: float, segments: int
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """A box of half sizes about the origin, its edges rounded by ``rim``; no edge of the mesh is
    longer than ``edge``."""
    inner = [float(side) for side in 2 * (half - rim)]
    if not rim:
        return _refined(manifold3d.Manifold.cube(inner, center=True), edge)
    corners = [
        manifold3d.Manifold.sphere(float(rim), segments).translate([x / 2 for x in at])
        for at in itertools.product(*((-side, side) for side in inner))
    ]
    return _refined(manifold3d.Manifold.batch_hull(corners), edge)


def ball(
    radii: Float[np.ndarray, " 3"], edge: float, segments: int
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """An ellipsoid about the origin."""
    sphere = manifold3d.Manifold.sphere(1.0, segments)
    return _refined(sphere.scale([float(radius) for radius in radii]), edge)


def lathe(
    profile: Float[np.ndarray, "k 2"], edge: float, segments: int
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """A profile of radius and height, counter-clockwise, turned about the z axis."""
    return _refined(_outline([profile]).revolve(segments), edge)


def hull(
    corners: Float[np.ndarray, "k 3"], edge: float
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The convex solid that has these corners."""
    return _refined(manifold3d.Manifold.hull_points(corners.tolist()), edge)


Layers = Sequence[tuple[float, float, Sequence[Float[np.ndarray, "k 2"]]]]


def prisms(layers: Layers, edge: float) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The union of flat outlines, each from one height along z to another; the inside is on the
    left of each loop."""
    return _refined(_added(_prism(*layer) for layer in layers), edge)


def rolled(
    layers: Layers, radius: float, edge: float
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The same laid once around the z axis, and what goes on beyond that left out: x is the way
    around at ``radius``, 0 in front, y the height, z the distance from the axis."""

    def laid(verts: np.ndarray) -> np.ndarray:
        angle, height, far = verts[:, 0] / radius, verts[:, 1], verts[:, 2]
        return np.stack([far * np.sin(angle), -far * np.cos(angle), height], 1)

    flat = _added(_prism(*layer) for layer in layers)
    left, right = flat.split_by_plane((1.0, 0.0, 0.0), 0.0)
    seam = np.pi * radius
    sides = left.trim_by_plane((1.0, 0.0, 0.0), -seam), right.trim_by_plane((-1.0, 0.0, 0.0), -seam)
    return _refined(_added(side.refine_to_length(edge).warp_batch(laid) for side in sides), np.inf)


Loops = Sequence[Float[np.ndarray, "k 2"]]


def area_of(loops: Loops) -> tuple[float, float]:
    """The area within an outline, and the length of all its loops."""
    sides = [np.linalg.norm(loop - np.roll(loop, 1, 0), axis=1).sum() for loop in loops]
    return float(_outline(loops).area()), float(np.sum(sides))


def inset(loops: Loops, by: float) -> list[Float[np.ndarray, "_ 2"]]:
    """An outline narrower by so much on each side, its corners as they are."""
    made = _outline(loops).offset(-by, manifold3d.JoinType.Miter)
    return [np.array(loop) for loop in made.to_polygons()]


def room_within(profile: Float[np.ndarray, "k 2"], wall: float) -> Float[np.ndarray, "_ 2"]:
    """The profile of the room that a turned solid of this profile is around, where it is hollow and
    its wall so thick; both of radius and height, counter-clockwise."""
    across = np.concatenate([profile, (profile * (-1, 1))[::-1]])
    low, high = profile[:, 1].min(), profile[:, 1].max()
    half = manifold3d.CrossSection.square([float(profile[:, 0].max()), float(high - low)])
    made = _outline([across]).offset(-wall, manifold3d.JoinType.Miter)
    loops = (made ^ half.translate((0.0, float(low)))).to_polygons()
    return np.array(max(loops, key=len))


def _outline(loops: Loops) -> manifold3d.CrossSection:
    corners = [[(float(x), float(y)) for x, y in loop] for loop in loops]
    return manifold3d.CrossSection(corners, manifold3d.FillRule.Positive)


def _prism(low: float, high: float, loops: Sequence[np.ndarray]) -> manifold3d.Manifold:
    return _outline(loops).extrude(high - low).translate((0.0, 0.0, low))


def _added(solids: Iterable[manifold3d.Manifold]) -> manifold3d.Manifold:
    return manifold3d.Manifold.batch_boolean(list(solids), manifold3d.OpType.Add)


def is_solid(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> bool:
    """Whether a mesh can be united with others: closed, manifold and oriented."""
    return not _solid(verts, faces).is_empty()


def profile(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], angles: int, off: float
) -> Float[np.ndarray, "k 2"] | None:
    """Radius and height of a closed mesh that is the same all around the z axis: the outline of its
    sections through the axis, of that with the median area; None where it is not one loop.

    Args:
        angles: how many sections.
        off: how far a corner may be from the outline without it.
    """
    solid = _solid(verts, faces).rotate((-90.0, 0.0, 0.0))  # z to y
    low, high = np.array(solid.bounding_box()).reshape(2, 3)[:, :2] * 1.01 - (0.01, 0.01)
    size = [float(high[0]) + 0.02, float(high[1] - low[1]) + 0.02]
    half = manifold3d.CrossSection.square(size).translate((0.0, float(low[1])))
    sections = []
    for index in range(angles):
        turned = solid.rotate((0.0, 360.0 * (index + 0.5) / angles, 0.0))
        sections.append((turned.slice(0.0) ^ half).simplify(off))
    middle = sorted(sections, key=lambda section: section.area())[angles // 2]
    loops = middle.to_polygons()
    return np.array(loops[0]) if len(loops) == 1 else None


def _refined(
    solid: manifold3d.Manifold, edge: float
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    made = (solid.refine_to_length(edge) if np.isfinite(edge) else solid).to_mesh()
    faces = torch.from_numpy(made.tri_verts.astype(np.int64))
    return torch.from_numpy(np.array(made.vert_properties[:, :3])), faces


def _solid(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> manifold3d.Manifold:
    """As manifold3d has it; nothing, where it is no closed mesh."""
    places, corners = verts.detach().cpu().numpy(), faces.cpu().numpy()
    mesh = manifold3d.Mesh(places.astype(np.float32), corners.astype(np.uint32))
    return manifold3d.Manifold(mesh)


def _verts(solid: manifold3d.Manifold) -> Float[np.ndarray, "v 3"]:
    return np.asarray(solid.to_mesh().vert_properties, np.float64)[:, :3]


def _capsule(
    start: Float[np.ndarray, " 3"],
    end: Float[np.ndarray, " 3"],
    radius: float,
    segments: int = ROUND,
) -> manifold3d.Manifold:
    """All points within ``radius`` of a line from one point to another."""
    ball = manifold3d.Manifold.sphere(radius, segments)
    ends = [ball.translate([float(x) for x in at]) for at in (start, end)]
    return manifold3d.Manifold.batch_hull(ends)
