"""A solid of known parts as a mesh: the surface of each component of each part, made exact, united.

A part by itself is simple: a box, a ball, a board. On a lattice of its own size even a small one
has its form. Most are a primitive (:mod:`core.geometry.parts.fitting`), the same all around an
axis (:mod:`core.geometry.revolved`), or flat outlines one upon another
(:mod:`core.geometry.parts.layered`); of the others planes are found whole
(:mod:`core.geometry.crisp`), and where a component meets others the union has an edge. One lattice
over all of them rounds what is smaller than a cell, and each border between two parts is ragged.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.spatial.transform import Rotation
from torch import Tensor

from core.geometry.bilateral import flattened
from core.geometry.crisp import RIPPLES, crisp
from core.geometry.faces import bending
from core.geometry.mesh import drop_floaters, face_areas, signed_volume
from core.geometry.parts.blade import blade
from core.geometry.parts.bodywork import bodied
from core.geometry.parts.components import (
    Component,
    Distances,
    Mesh,
    drawn_in,
    places_of,
    points_of,
    repeated,
    turned_fraction,
)
from core.geometry.parts.crossed import crossed
from core.geometry.parts.fitting import frames_of
from core.geometry.parts.flush import flush
from core.geometry.parts.forms import Forms
from core.geometry.parts.layered import ends_fraction, layered, wall
from core.geometry.parts.matching import is_drawn, is_same, matched
from core.geometry.parts.mirrored import Mirror, across, mirrored_mesh, mirrored_pairs
from core.geometry.parts.pipe_fitting import piped
from core.geometry.parts.primitives import FRAMES, Primitive
from core.geometry.parts.resized import Resized, resized
from core.geometry.parts.sheets import thinned_sheet
from core.geometry.parts.slender import thinned
from core.geometry.revolved import ROUND, revolved
from core.geometry.signed_distance import SolidMesh
from core.geometry.tet_grid import EXTENT
from core.geometry.union import is_solid, profile, union

WORDY = 0.001  # errors in the mean, for each number of an outline
SECTIONS, OUTLINE = 8, 0.002  # through an axis; training units that its outline is simplified by
FLAT_ENDS = 0.4  # of the area of a component's ends, what of its part is flat in the mean, at least
STRAIGHT = 0.9  # times the bending of what is smooth, at most: planes that gain less are ragged
NEAR = 0.1  # training units
# Mean errors below which a component is surely what it seems; the fraction of that for a blade.
CLEAR, BLADED = 0.06, 0.7
ENDLESS = "wall", "blade", "pipes"  # without ends across an axis
STRUT = 0.03  # radius, training units
# Of what is inside others: faces from which there are fewer, so far off, training units.
MANY_FACES, OFF = 300_000, 3e-4
SETTLED, SETTLED_OFF = 2, 1e-3  # steps onto a surface; how far off it is still on it


class KnownParts:
    """The parts of one object, each a solid of its own, and their connected components."""

    def __init__(
        self,
        distances: Distances,
        forms: Forms,
        wider: tuple[float, float, float] = (1, 1, 1),
        sizes: Mapping[int, tuple[float, float]] = MappingProxyType({}),
    ) -> None:
        """
        Args:
            distances: of each part, at points in training units; columns beyond are none.
            wider: by how much wider the components are looked at than they are, along x, y and z: a
                lattice would miss a slender thing's walls.
            sizes: of the parts that have another size than they are drawn with: how many times as
                large each component is, and of that how many times as long.
        """
        self.distances, self.forms, self.wider, self.sizes = distances, forms, wider, sizes
        self._surfaces: dict[int, Mesh] = {}
        self._solids: dict[int, SolidMesh] = {}
        self._mirrored: dict[int, Mirror] = {}
        self._resized: dict[int, Resized] = {}

    @cached_property
    def components(self) -> list[Component]:
        """All that have a surface, as wide as they are looked at. Equal components of a part are
        exactly equal. A mirror image has no primitive of its own: it uses the other one's."""
        drawn = self._drawn
        found = matched(self._wide, drawn, self.forms)
        self._mirrored = {
            index: mirror
            for index, mirror in mirrored_pairs(self._wide, drawn).items()
            if not is_same(found[index], found[mirror.of])
        }
        known = [
            component if index in self._mirrored else self._as_made(component, one)
            for index, (component, one) in enumerate(zip(drawn, found, strict=True))
        ]
        even = flush([component.primitive for component in known])
        return [
            component._replace(primitive=one and self._thinned(one, component.place.part))
            for component, one in zip(known, even, strict=True)
        ]

    @cached_property
    def _drawn(self) -> list[Component]:
        """All that have a surface, as wide as they are looked at, as they are drawn."""
        places = places_of(self._wide, len(self.forms.flat))
        drawn = [component for place in places for component in drawn_in(self._wide, place)]
        return without_strays(drawn, self.forms)

    def drawn(self) -> list[Component]:
        """The components as they are drawn, in their own width."""
        wider = torch.tensor(self.wider)
        return [one._replace(verts=one.verts / wider) for one in self._drawn]

    @property
    def enclosed(self) -> Sequence[Sequence[int]]:
        """The components of each object that is in a room within others, which it need not
        touch."""
        return ()

    def _thinned(self, one: Primitive, part: int) -> Primitive:
        """As thick as the real part is."""
        return thinned(one, self.forms.thickness(part))

    def _as_made(self, component: Component, one: Primitive | None) -> Component:
        """The component with its primitive, ``one`` or another; without one, made symmetric and
        of layers where it has them."""
        one = self._bladed(component, one or self._turned(component))
        if one is None:
            component = repeated(self._wide, component)
            one = self._layered(component)
        return component._replace(primitive=one)

    def _bladed(self, component: Component, one: Primitive | None) -> Primitive | None:
        """The blade that a mostly flat component is, where that is nearer: a small one is nearly a
        ball too."""
        if one is None or not self.forms.faces(component.place.part).block:
            return one
        points = points_of(component)
        off = one.off(points, component.error)
        if off <= CLEAR or (edged := blade(component)) is None:
            return one
        found = self._best(component, [edged])
        return found if found and found.off(points, component.error) < BLADED * off else one

    def _turned(self, component: Component) -> Primitive | None:
        """The component's solid of revolution, if it is the same all around an axis, or None."""
        if component.place.part in self.forms.cornered:
            return None
        fractions = self.round_fractions(component)
        axis = int(fractions.argmax())
        turned = turned_about(component, axis) if fractions[axis] >= ROUND else None
        return turned if turned and is_drawn(self._wide, turned, component) else None

    def _layered(self, component: Component) -> Primitive | None:
        """What the component is, where it is flat outlines one upon another along an axis, or along
        several, or one around a line."""
        part = component.place.part
        work = self.forms.bodywork.get(part)
        if part in self.forms.curved or (work and work.leans):  # a stepped pyramid is near a cabin
            return None
        frames = [frame @ turned for frame in frames_of(points_of(component)) for turned in FRAMES]
        each = [*(layered(component, frame) for frame in frames), wall(component)]
        if self.forms.faces(component.place.part).block:
            each.append(blade(component))
        flat = [one for one in each if one]
        found = self._best(component, flat)
        for other in (crossed, piped):
            if found is None and (one := other(component)):
                found = self._best(component, [one])
        return found

    def _best(self, component: Component, flat: list[Primitive]) -> Primitive | None:
        """The one of these that fits the component best; None where none does."""
        points = points_of(component)
        # A round tube looks like a flat one here: the noun's objects decide whether there are ends.
        most = self.forms.flat[component.place.part] / FLAT_ENDS
        fits = [one for one in flat if one.form in ENDLESS or ends_fraction(one) <= most]
        fits = [one for one in fits if one.fits(points, component.error)]
        return min(
            (one for one in fits if is_drawn(self._wide, one, component)),
            # Of those that fit about equally well, the one with fewer numbers.
            key=lambda one: one.off(points, component.error) + WORDY * len(one.lengths),
            default=None,
        )

    def round_fractions(self, component: Component) -> Float[np.ndarray, " 3"]:
        """The fraction of the component's surface that is the same all around along x, y, z."""
        # By the noun's objects, or by this component itself: a table's top may be round, though
        # most are not.
        own = [turned_fraction(self._wide, component, axis) for axis in range(3)]
        return np.maximum(own, [axis[component.place.part] for axis in self.forms.round])

    def extents(self) -> list[Float[np.ndarray, " 3"]]:
        """The size of each part's largest component along x, y, z; zeros where it has none."""
        boxes = self.boxes()
        return [np.zeros(3) if box is None else (box[1] - box[0]).numpy() for box in boxes]

    def boxes(self) -> list[Float[Tensor, "2 3"] | None]:
        """The lowest and the highest corner of the box of each part's largest component; None where
        it has no component."""
        each = self.component_boxes()
        return [
            max(own, key=lambda box: float((box[1] - box[0]).norm()), default=None) for own in each
        ]

    def component_boxes(self) -> list[list[Float[Tensor, "2 3"]]]:
        """Those of all components of each part."""
        found: list[list[Float[Tensor, "2 3"]]] = [[] for _ in self.forms.flat]
        for index, component in enumerate(self.components):
            verts, _ = self.surface_of(index)
            box = torch.stack([verts.amin(0), verts.amax(0)]).cpu()
            found[component.place.part].append(box)
        return found

    def surface_of(self, index: int, exact: bool = True) -> Mesh:
        """A component's exact surface, or the one that is drawn."""
        component = self.components[index]
        verts, faces = (
            self._surface(index)
            if exact
            else self._in_size(index, component.verts, component.faces)
        )
        return verts / verts.new_tensor(self.wider), faces

    def _in_size(self, index: int, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Mesh:
        """A component's surface in its own size."""
        size = self._size(index)
        return (verts if size is None else size.moved(verts)), faces

    def _size(self, index: int) -> Resized | None:
        """The change of a component's size; None where it is as it is drawn."""
        component = self.components[index]
        part, verts = component.place.part, component.verts
        if part in self.sizes and index not in self._resized:
            away = self._wide(verts)
            others = [k for k in range(away.shape[1]) if k != part]
            self._resized[index] = resized(verts, away[:, others].amin(1), *self.sizes[part])
        return self._resized.get(index)

    def settled(
        self, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"]
    ) -> Float[Tensor, "n 3"]:
        """Points of the drawn surface, and the part of each, where the exact one is: what stands on
        a table stands on its thin top."""
        found, wider = points.clone(), points.new_tensor(self.wider)
        for index, component in enumerate(self.components if self.sizes else ()):
            if (size := self._size(index)) is not None:
                low, high = (found.new_tensor(end) for end in component.place[1:3])
                wide = found * wider
                here = (part == component.place.part) & ((wide > low) & (wide < high)).all(1)
                found[here] = size.moved(wide[here]) / wider
        if not self.is_thinner:
            return found
        for _ in range(SETTLED):
            off = self._off(found, part)
            here = (off.abs() > SETTLED_OFF) & (off.abs() < NEAR)
            some, own, slope = found[here], part[here], torch.zeros_like(found[here])
            for axis, step in enumerate(SETTLED_OFF * torch.eye(3).to(found)):
                ahead, behind = self._off(some + step, own), self._off(some - step, own)
                slope[:, axis] = (ahead - behind) / (2 * SETTLED_OFF)
            size = slope.square().sum(1, keepdim=True).clamp_min(0.1)
            found[here] = some - off[here, None] * slope / size
        return found

    def _off(self, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"]) -> Float[Tensor, " n"]:
        """The distance of each point from the exact surface of its part."""
        return self.near(points, part).gather(1, part[:, None])[:, 0]

    @property
    def is_thinner(self) -> bool:
        """Whether any component is thinner than it is drawn."""
        if all(self.forms.thickness(part) == 1 for part in range(len(self.forms.flat))):
            return False  # without asking for the components, which takes seconds
        return any(self.forms.thickness(one.place.part) != 1 for one in self.components)

    def near(
        self, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"] | None = None
    ) -> Float[Tensor, "n p"]:
        """The parts' distances from their exact surfaces, of points that are near these; what is
        farther off than ``NEAR`` may come out as ``EXTENT``, and what is not of each point's
        ``part``, where that is given."""
        found = torch.full((len(points), len(self.forms.flat)), EXTENT).to(points)
        wider = points.new_tensor(self.wider)
        points, reach = points * wider, NEAR * wider
        for index, component in enumerate(self.components):
            verts, _ = self._surface(index)
            low, high = verts.amin(0).to(points) - reach, verts.amax(0).to(points) + reach
            here = ((points > low) & (points < high)).all(1)
            if part is not None:
                here &= part == component.place.part
            if not here.any():
                continue
            column = found[:, component.place.part]
            away = self._distance(index)(points[here]) / max(self.wider)
            column[here] = torch.minimum(column[here], away)
        return found

    def _wide(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances as wide as they are looked at."""
        return self.distances(points / points.new_tensor(self.wider)) * max(self.wider)

    def _surface(self, index: int) -> Mesh:
        """A component's exact surface as wide as it is looked at, made once."""
        if index not in self._surfaces:
            component, mirror = self.components[index], self._mirrored.get(index)
            if mirror:
                made = mirrored_mesh(self._surface(mirror.of), mirror.axis)
            else:
                made = self._in_size(index, *exact_surface(self, component))
                made = self._bodied(component, made)
            self._surfaces[index] = made
        return self._surfaces[index]

    def _bodied(self, component: Component, made: tuple[Tensor, Tensor]) -> Mesh:
        """A component's surface with its part's bodywork."""
        work = self.forms.bodywork.get(component.place.part)
        if work is None:
            return made
        of = [k for k, one in enumerate(self.components) if one.place.part == work.wheels]
        return bodied(made, work.radius, [self._surface(k) for k in of], component.cell)

    def _distance(self, index: int) -> Callable[[Tensor], Tensor]:
        """From a component's exact surface, signed."""
        if mirror := self._mirrored.get(index):
            there = self._distance(mirror.of)
            return lambda points: there(across(points, mirror.axis))
        component = self.components[index]
        primitive = component.primitive
        if primitive is not None and component.place.part not in self.forms.bodywork:
            if (size := self._size(index)) is None:
                return primitive.distance
            return lambda points: primitive.distance(size.before(points)) * size.least
        if index not in self._solids:
            self._solids[index] = SolidMesh(*self._surface(index))
        return self._solids[index].sdf


def assembled(
    parts: KnownParts, exact: bool, floaters: float, progress: Callable[[float], None]
) -> Mesh | None:
    """The union of the parts' surfaces; None where there is none.

    Args:
        exact: as primitives, and with planes and profiles; or all as they are drawn.
        floaters: a component of less area than this much of the largest is dropped.
        progress: gets the fraction done; what it raises stops it.
    """
    meshes = []
    progress(0.0)
    for index in range(len(parts.components)):
        progress((index + 1) / (len(parts.components) + 1))
        meshes.append(parts.surface_of(index, exact))
    if not meshes:
        return None
    if not parts.enclosed:
        return drop_floaters(*union(meshes, STRUT), floaters)
    inside = {index for own in parts.enclosed for index in own}
    groups = [[k for k in range(len(meshes)) if k not in inside], *parts.enclosed]
    many = sum(len(meshes[k][1]) for k in inside) > MANY_FACES
    made = [union([meshes[k] for k in own], STRUT, OFF * many) for own in groups]
    return union([drop_floaters(*one, floaters, rooms=True) for one in made], 0.0)


def thinned_by(parts: KnownParts) -> float:
    """How many times as large as made, by volume, the components are as drawn: 1 where none is
    thinner."""
    if not parts.is_thinner:
        return 1.0
    indices = range(len(parts.components))
    drawn, made = (
        sum(signed_volume(*parts.surface_of(k, exact)) for k in indices) for exact in (False, True)
    )
    return round(drawn / made, 3)


def without_strays(components: list[Component], forms: Forms) -> list[Component]:
    """The components without strays: some of a boy's hair was next to each shoe."""
    areas = [float(face_areas(component.verts, component.faces).sum()) for component in components]
    pairs = list(zip(components, areas, strict=True))
    largest: dict[int, float] = {}
    for component, area in pairs:
        largest[component.place.part] = max(area, largest.get(component.place.part, 0.0))
    return [
        component
        for component, area in pairs
        if not forms.is_stray(component.place.part, area / largest[component.place.part])
    ]


def turned_about(component: Component, axis: int) -> Primitive | None:
    """The solid of revolution that the component is, about a line along the axis; or None."""
    of = torch.zeros(len(component.verts), dtype=torch.long)
    fractions = tuple((float(k == axis),) for k in range(3))
    verts = revolved(component.verts, component.faces, of, fractions, component.error)
    upright = np.roll(np.eye(3), axis + 1, 0)  # turns z to the axis
    local = verts.double() @ torch.from_numpy(upright)
    area = face_areas(local, component.faces)
    center = (area @ local[component.faces].mean(1) / area.sum()).numpy() * (1, 1, 0)
    outline = profile(
        (local - torch.from_numpy(center)).float(), component.faces, SECTIONS, OUTLINE
    )
    if outline is None:
        return None
    turn = Rotation.from_matrix(upright).as_rotvec()
    one = Primitive("turned", upright @ center, turn, outline.ravel())
    return one if one.fits(points_of(component), component.error) else None


def exact_surface(parts: KnownParts, component: Component) -> Mesh:
    """That of its primitive; or its own, on its planes or without its ripples, and as thin as the
    real part's."""
    if component.primitive is not None:
        return component.primitive.mesh(component.cell)
    part = component.place.part
    thick = parts.forms.thickness(part)
    verts, faces = thinned_sheet(component.verts, component.faces, component.lattice, thick)
    of, flat = torch.zeros(len(verts), dtype=torch.long), parts.forms.flat[part]
    made = crisp(verts, faces, verts, of, (flat,), component.error, smooth=True)
    smooth = flattened(verts, faces, *RIPPLES), faces
    before, after = (bending(v.double().numpy(), f.numpy()) for v, f in (smooth, made))
    # On what is finer than its errors the planes are wrong, and leave it ragged.
    return made if after < STRAIGHT * before and is_solid(*made) else smooth
