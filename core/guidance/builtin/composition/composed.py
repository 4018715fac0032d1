"""Several things as one object: the guidance of "a cat on a cushion", "a corgi wearing a beret".

Each thing is drawn, painted and written on by itself, in its own place (``Placement``). The
prediction for an object with several things is, at each place, that for the thing there.
"""

from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import compress
from typing import NamedTuple, TypeVar

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.appearance.material_ranges import MaterialRanges
from core.geometry.init_shape import Shape
from core.geometry.mesh import Mesh
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import Component
from core.geometry.parts.forms import Forms
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.areas import AreaFields, Field, Heights, SolidAreas
from core.guidance.builtin.composition.appendages.appendage import grown
from core.guidance.builtin.composition.clothes.clothing import dressed
from core.guidance.builtin.composition.filling import filled
from core.guidance.builtin.composition.glass.enclosing import enclosed, inside_of
from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.poses.posed import in_poses
from core.guidance.builtin.composition.poses.posing import in_one, points_of, seen_from
from core.guidance.builtin.composition.poses.sitting import seated
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.surfaces import unseen
from core.guidance.builtin.words.companions.search import Relation
from core.guidance.guidance import Guidance, Predictions, PromptedGuidance, Surface, Views

ALONE = (
    "left out, as only what the built-in prior draws itself is combined with other things, not "
    "your mesh or a distilled shape."
)
OWN_POSE = "left out, as only what the built-in prior draws itself gets a pose."
UNFIT = "left out, as the thing has no place for it."

Known = TypeVar("Known", AreaFields, KnownParts)
BEYOND = 0.1  # training units: least distance of a thing from points outside its cube


class Made(NamedTuple):
    """Drawn things and their placements."""

    things: Sequence[Thing]
    places: Sequence[Sequence[Placement]]  # of the copies of each
    size_m: float  # of the whole's longest side, metres
    unfit: Sequence[str] = ()  # notes on garments that do not fit and poses that it cannot have
    contents: Sequence[int] = ()  # indices of the things that are in a vessel


class Composed(PromptedGuidance):
    """The guidance of a thing and its companions; of the thing alone until they are drawn."""

    def __init__(
        self,
        guidance: Guidance,
        alone: Thing,
        things: Sequence[Thing],
        relations: Sequence[Relation],
        made: "Made | None" = None,
    ) -> None:
        """
        Args:
            alone: the first thing without companions.
            things: the first thing with companions, and its companions, not drawn.
            relations: of the first thing to each companion.
            made: the drawn things.
        """
        super().__init__(guidance)
        self.alone, self.things, self.relations, self.made = alone, things, relations, made

    def of_object(self, seed: int, whole: bool = True) -> "Composed":
        """All things drawn and put together; the first alone where not ``whole``."""
        if not whole:
            return self._with(self.alone.of_object(seed, whole))
        drawn = [thing.of_object(seed) for thing in self.things]
        bodies = [Body.of(one.words, one.solid, one.parts()) for one in drawn if one.solid]
        if len(bodies) < len(drawn):  # the weights have no solids
            return self
        drawn, bodies, holds = filled(drawn, bodies, self.relations)
        drawn, bodies, fits = dressed(drawn, bodies, self.relations)
        drawn, bodies = grown(drawn, bodies, self.relations)
        fits = [a and b for a, b in zip(fits, holds, strict=True)]
        drawn, bodies, unposed = in_poses(drawn, bodies, self.relations)
        drawn, bodies = seated(drawn, bodies, self.relations)
        drawn = list(compress(drawn, [True, *fits]))
        bodies = list(compress(bodies, [True, *fits]))
        relations = list(compress(self.relations, fits))
        inside = inside_of(bodies, relations)
        if inside:
            drawn, bodies, places = enclosed(drawn, bodies, relations, inside)
        else:
            places = arranged(bodies[0], list(zip(relations, bodies[1:], strict=True)))
        each = zip(bodies, places, strict=True)
        verts = torch.cat([place.out(body.verts) for body, own in each for place in own])
        sides = verts.amax(0) - verts.amin(0)
        of_size = inside.vessel if inside else 0
        size_m = float(sides.max()) * bodies[of_size].metres / places[of_size][0].scale
        others = zip(self.things[1:], self.relations, fits, strict=True)
        unfit = [
            f"{'filling' if how == 'fills' else thing.words.noun}: {UNFIT}"
            for thing, how, fit in others
            if not fit
        ]
        contents = inside.contents if inside else ()
        return self._with(self.alone, Made(drawn, places, size_m, [*unfit, *unposed], contents))

    def in_proportion(self, guide: Mesh, strength: float, least: float) -> "Composed":
        """The first thing alone: a guide has one thing."""
        return self._with(self.alone.in_proportion(guide, strength, least))

    def _with(self, alone: Thing, made: "Made | None" = None) -> "Composed":
        return Composed(self._guidance, alone, self.things, self.relations, made)

    def size_m(self) -> float | None:
        """The longest side of the whole in metres; the first thing has its usual or its stated
        size."""
        return self.made and self.made.size_m

    def start_shape(self) -> Shape | None:
        """The first thing's: Ψ learns one thing from pictures."""
        return self.alone.start_shape()

    def restore(
        self, pictures: Float[Tensor, "b 4 s s"], views: Views
    ) -> Float[Tensor, "b 4 s s"] | None:
        """The first thing's."""
        return self.alone.restore(pictures, views)

    def parts(self) -> KnownParts | None:
        """The parts of all things in order."""
        return self._parts if self.made else self.alone.parts()

    def areas(self) -> SolidAreas | None:
        """The areas of all things in order."""
        if not self.made:
            return self.alone.areas()
        known = [_known(thing.area_fields()) for thing in self.made.things]
        drawn = composed_field([one.drawn for one in known], self.made.places)
        near = composed_field([one.near for one in known], self.made.places)
        hidden = self.made.contents
        each = tuple(
            unseen(area) if k in hidden else area
            for k, one in enumerate(known)
            for area in one.each
        )
        return SolidAreas(drawn, each, near, composed_heights(known, self.made.places))

    def ranges(self) -> MaterialRanges:
        """The range over all parts of all things."""
        each = [thing.ranges() for thing in self._here]
        rough, metal = ([getattr(one, n) for one in each] for n in ("roughness", "metallic"))
        spans = [(min(low for low, _ in of), max(high for _, high in of)) for of in (rough, metal)]
        return MaterialRanges(*spans)

    def surfaces(self) -> tuple[Surface, ...]:
        """The surfaces of all parts of all things."""
        return tuple(dict.fromkeys(one for thing in self._here for one in thing.surfaces()))

    def style(self) -> str:
        """That of the whole."""
        return self.alone.style()

    def left_out(self) -> tuple[str, ...]:
        """Notes of the things, and on companions and copies that are left out."""
        own = tuple(text for thing in self._here for text in thing.left_out())
        if self.made:
            return (*own, *self.made.unfit)
        first, *others = (thing.words for thing in self.things)
        more = [f"{first.count} × {first.noun}"] if first.count > 1 else []
        posed = (f"{first.noun} {first.pose}: {OWN_POSE}",) if first.pose else ()
        alone = (f"{what}: {ALONE}" for what in (*more, *(one.noun for one in others)))
        return (*own, *posed, *alone)

    @torch.no_grad()
    def predict(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        views: Views,
        *,
        cond_only: bool = False,
        apart: bool = False,
    ) -> Predictions:
        """At each place of the surface the prediction for the thing there."""
        options = {"cond_only": cond_only, "apart": apart}
        surface = views.surface
        if not self.made or surface is None:
            return self.alone.predict(z_t, t, views, **options)
        surface = torch.nn.functional.adaptive_avg_pool2d(surface, self.latent_size)
        owner, copy = self._owner(surface)
        found = []
        for index, (thing, places) in enumerate(self._placed):
            mine = copy * (owner == index)  # elsewhere as seen by the first copy
            seen = torch.stack([seen_from(surface, place) for place in places])
            own = seen.gather(0, mine[None, :, None].expand_as(seen[:1]))[0]
            found.append(thing.predict(z_t, t, Views(views.cameras, own), **options))
        whole = found[0]
        for index, other in enumerate(found[1:], 1):
            mine = owner[:, None] == index
            whole = Predictions(*(_put(a, b, mine) for a, b in zip(whole, other, strict=True)))
        return whole

    def _owner(
        self, surface: Float[Tensor, "b 7 s s"]
    ) -> tuple[Int[Tensor, "b s s"], Int[Tensor, "b s s"]]:
        """The thing at each place of the pictures, and its copy; the first one on the
        background."""
        seen, points = points_of(surface)
        owner = torch.zeros_like(seen, dtype=torch.long)
        copy = torch.zeros_like(owner)
        owner[seen], copy[seen] = self._parts.copy(points[seen])
        return owner, copy

    @property
    def _here(self) -> Sequence[Thing]:
        return self.made.things if self.made else [self.alone]

    @property
    def _placed(self) -> list[tuple[Thing, Sequence[Placement]]]:
        assert self.made is not None
        return list(zip(self.made.things, self.made.places, strict=True))

    @cached_property
    def _parts(self) -> "ComposedParts":
        pairs = [(_known(thing.parts()), places) for thing, places in self._placed]
        return ComposedParts(pairs, self.made.contents if self.made else ())


def _known(of_drawn: Known | None) -> Known:
    """The field or the parts of a drawn thing."""
    assert of_drawn is not None
    return of_drawn


def _put(
    whole: Float[Tensor, "b 4 s s"] | None,
    other: Float[Tensor, "b 4 s s"] | None,
    mine: Bool[Tensor, "b 1 s s"],
) -> Float[Tensor, "b 4 s s"] | None:
    """``other`` under the mask ``mine``, for predictions that all things have or none."""
    return whole if whole is None or other is None else other.where(mine, whole)


class ComposedParts(KnownParts):
    """The parts of several things, with all copies in their places."""

    def __init__(
        self,
        placed: Sequence[tuple[KnownParts, Sequence[Placement]]],
        contents: Sequence[int] = (),
    ) -> None:
        """``contents``: indices of the things that are in a vessel."""
        self.placed, self.contents = placed, contents
        each = [parts.forms for parts, _ in placed]
        flat = tuple(fraction for forms in each for fraction in forms.flat)
        around = tuple(tuple(x for forms in each for x in forms.round[axis]) for axis in range(3))
        counts = [len(forms.flat) for forms in each]
        self.starts = [sum(counts[:k]) for k in range(len(counts))]
        pairs = zip(each, self.starts, strict=True)
        cornered = [k + start for forms, start in pairs for k in forms.cornered]
        slender = [
            parts.forms.thickness(k) for parts, _ in placed for k in range(len(parts.forms.flat))
        ]
        super().__init__(self._distances, Forms(flat, around, cornered, slender=slender))

    @cached_property
    def components(self) -> list[Component]:
        """The components of each copy, with part numbers of the whole."""
        found = []
        for (parts, places), start in zip(self.placed, self.starts, strict=True):
            for component in parts.components * len(places):
                place = component.place._replace(part=component.place.part + start)
                found.append(component._replace(place=place))
        return found

    @cached_property
    def enclosed(self) -> list[list[int]]:
        """The components of each copy of what is in a vessel, and of what floats in that."""
        found, start = [], 0
        for thing, (parts, places) in enumerate(self.placed):
            count = len(parts.components)
            for _ in places:
                own = [range(count)] if thing in self.contents else parts.enclosed
                found += [[start + k for k in one] for one in own]
                start += count
        return found

    def surface_of(self, index: int, exact: bool = True) -> tuple[Tensor, Tensor]:
        """The surface of a component in its place."""
        for parts, places in self.placed:
            for place in places:
                if index < len(parts.components):
                    verts, faces = parts.surface_of(index, exact)
                    return place.out(verts), faces
                index -= len(parts.components)
        raise IndexError(index)

    def near(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """Distances from the exact surfaces of the parts."""
        found = [
            torch.stack([parts.near(place.into(points)) * place.scale for place in places]).amin(0)
            for parts, places in self.placed
        ]
        return torch.cat(found, 1)

    def copy(self, points: Float[Tensor, "n 3"]) -> tuple[Int[Tensor, " n"], Int[Tensor, " n"]]:
        """The thing at each point, and its copy."""
        each = [
            torch.stack([at_place(parts.distances, place, points).amin(1) for place in places], 1)
            for parts, places in self.placed
        ]
        nearest = torch.stack([of.amin(1) for of in each], 1).argmin(1)
        copies = torch.stack([of.argmin(1) for of in each], 1)
        return nearest, copies.gather(1, nearest[:, None])[:, 0]

    def _distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        found = []
        for parts, places in self.placed:
            each = [at_place(parts.distances, place, points) for place in places]
            found.append(torch.stack(each).amin(0)[:, : len(parts.forms.flat)])
        return torch.cat(found, 1)


def at_place(
    field: Callable[[Tensor], Tensor], place: Placement, points: Float[Tensor, "n 3"]
) -> Float[Tensor, "n p"]:
    """A thing's distances in its place; beyond its cube, no less than the distance from the
    cube."""
    own = place.into(points)
    near = (own.abs() <= EXTENT).all(1)
    beyond = (own.abs() - EXTENT).clamp_min(0).norm(dim=1) + BEYOND
    known = field(own[near])
    found = beyond[:, None].expand(-1, known.shape[1]).clone()
    found[near] = known
    return found * place.scale


def composed_field(fields: Sequence[Field], placements: Sequence[Sequence[Placement]]) -> Field:
    """The areas of all things."""

    def at(points: Float[Tensor, "n 3"]) -> tuple[Float[Tensor, " n"], Float[Tensor, "n a"]]:
        distances, depths = [], []
        for field, places in zip(fields, placements, strict=True):
            each = torch.stack([at_place(in_one(field), place, points) for place in places])
            distances.append(each[..., 0].amin(0))
            depths.append(-each[..., 1:].amin(0))
        return torch.stack(distances, 1).amin(1), torch.cat(depths, 1)

    return at


def composed_heights(
    things: Sequence[AreaFields], placements: Sequence[Sequence[Placement]]
) -> Heights:
    """How far the surfaces of all things stand out."""

    def at(points: Float[Tensor, "n 3"], area: Int[Tensor, " n"]) -> Float[Tensor, " n"]:
        found, start = torch.zeros_like(points[:, 0]), 0
        for thing, places in zip(things, placements, strict=True):
            own = area - start
            start += len(thing.each)
            mine = ((own >= 0) & (own < len(thing.each))).nonzero().squeeze(1)
            copy = torch.zeros_like(mine)
            if len(places) > 1:
                field = in_one(thing.near)
                away = [at_place(field, place, points[mine])[:, 0] for place in places]
                copy = torch.stack(away, 1).argmin(1)
            for index, place in enumerate(places):
                here = mine[copy == index]
                found[here] = place.scale * thing.heights(place.into(points[here]), own[here])
        return found

    return at
