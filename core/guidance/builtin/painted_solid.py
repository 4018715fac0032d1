"""A drawn solid as it is painted: its parts, their markings, and the prompt's emblems on it."""

import math
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, partial

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.forms import Forms
from core.guidance.builtin.areas import AreaFields, depths, patterned
from core.guidance.builtin.bent import BentSolid
from core.guidance.builtin.bodywork import bodywork_of
from core.guidance.builtin.composition.clothes.clothing import Garment
from core.guidance.builtin.composition.placing.placement import EYES
from core.guidance.builtin.constructed.solid import ConstructedSolid
from core.guidance.builtin.counted_solid import CountedSolid, counted_solid
from core.guidance.builtin.cutting.cut_solid import Cut, cut_out_of
from core.guidance.builtin.markings.emblems.drawn_emblem import Drawn, drawn_on
from core.guidance.builtin.markings.emblems.portraits import Portrait, portrait_of
from core.guidance.builtin.markings.expressions import MOUTH, expression
from core.guidance.builtin.markings.heights import GROOVE
from core.guidance.builtin.markings.markings import (
    NUMBER,
    Marked,
    bearer_of,
    has_markings,
    is_marking,
    unfit_markings,
)
from core.guidance.builtin.markings.overlay import Overlay
from core.guidance.builtin.nouns import solid_of
from core.guidance.builtin.palette import Painted, looks, painted
from core.guidance.builtin.part_forms import CORNERED, CURVED, part_forms_table
from core.guidance.builtin.patterns import ALONG, LINES, MARGINS, Laid, axis_of
from core.guidance.builtin.slender import slender_parts
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.stretch import AS_IT_IS, known_wider
from core.guidance.builtin.surfaces import ranges_of, surface_of
from core.guidance.builtin.words.phrases.emblems import METALS, Emblem
from core.guidance.builtin.words.phrases.moods import has_face, is_lively
from core.guidance.builtin.words.phrases.slots import GEOMETRY_SLOTS, Words
from core.guidance.builtin.words.tables.words import PART_LENGTHS, PART_SCALES, PART_WIDTHS
from core.guidance.guidance import Area

SOFT = 0.01  # flat fraction of a part's surface where it is not known
EVEN = 0.02  # tolerance of the scales along two axes for a circle to stay one
LONG = 4  # digits: a number by nature has fewer
BEARS = "it stays, as markings are on it."
IN_EYES = "pupils", "glints", "whites"
FACES = "head", "face"
LID = 0.7  # sRGB, of the colour around it
UNCUT = "left out, as only what the built-in prior puts together itself is cut."
UNSIZED = "left out, as parts get sizes only on what the built-in prior puts together itself."
FIXED = "left out, as the parts of this thing keep their thickness."
UNCOUNTED = "left out, as parts are counted only on what the built-in prior puts together itself."
UNFIT_COUNT = "left out, as that many do not fit there."
NO_ROOM = "left out, as the thing has no room for it."


def product(factors: Mapping[str, float], words: Iterable[str]) -> float:
    """Of the words that have one."""
    return math.prod(factors.get(word, 1.0) for word in words)


def stated_sizes(words: Words) -> dict[str, tuple[float, float]]:
    """Of the parts that have another size: how many times as large, and of that how many times as
    long."""
    sizes = {name: size.split() for name, size in words.part_sizes}
    each = {n: (product(PART_SCALES, w), product(PART_LENGTHS, w)) for n, w in sizes.items()}
    return {name: by for name, by in each.items() if by != (1.0, 1.0)}


class PaintedSolid:
    """One object of the words."""

    def __init__(self, words: Words, solid: Solid, whole: bool = True) -> None:
        """``whole``: it is put together of its parts, so that these may be thinner or of another
        size than they are drawn."""
        self.words, self.solid, self.whole = words, solid, whole
        paints = list(painted(words.noun, words))
        self.asleep = whole and words.pose == "sleeping"
        self.paints = [*_closed(paints)] if self.asleep else paints

    @cached_property
    def parts(self) -> KnownParts:
        """Its parts; a part that an adjective makes oval is not round."""
        noun = self.words.noun
        if isinstance(self.solid, ConstructedSolid):
            return self.solid.known
        flat, around, least = part_forms_table()[noun]
        if isinstance(self.solid, Garment):  # it has its wearer's form
            soft = Forms((SOFT,) * len(flat), ((0.0,) * len(flat),) * 3)
            return KnownParts(self.solid.distances, soft)
        x, y, z = self.solid.frame.scale
        even = (math.isclose(a, b, rel_tol=EVEN) for a, b in ((y, z), (z, x), (x, y)))
        kept = tuple(tuple(x * here for x in row) for row, here in zip(around, even, strict=True))
        # A guide may be as wide as the cube, the limit of the search.
        is_guided = isinstance(self.solid, BentSolid)
        wider = AS_IT_IS if is_guided else known_wider(solid_of(noun))
        names = list(looks(noun))
        cornered, curved = (
            [part for part, name in enumerate(names) if name in known.get(solid_of(noun), ())]
            for known in (CORNERED, CURVED)
        )
        own = dict(self.words.part_sizes) if self.whole else {}
        sizes = [own.get(name, "").split() for name in names]
        stated = stated_sizes(self.words) if self.whole else {}
        slender = slender_parts(noun, names) if self.whole else [1.0] * len(names)
        each = zip(slender, sizes, strict=True)
        thick = [by * product(PART_WIDTHS, words) for by, words in each]
        changed = {part: stated[name] for part, name in enumerate(names) if name in stated}
        forms = Forms(flat, kept, cornered, least, thick, bodywork_of(noun, names), curved)
        return KnownParts(self.solid.distances, forms, wider, changed)

    @cached_property
    def cut(self) -> Cut | None:
        """What is cut out of it; None where it is whole."""
        if not self.words.cut or not self.whole or isinstance(self.solid, Garment):
            return None
        return cut_out_of(self.words, self.parts, self.paints)

    @property
    def made(self) -> KnownParts:
        """Its parts, cut if the words state a cut."""
        return self.cut.parts if self.cut else self.parts

    def counted(self) -> "PaintedSolid":
        """The same with the stated numbers of its parts' components."""
        if not self.words.part_counts:
            return self
        names = list(looks(self.words.noun))
        counts = {names.index(name): count for name, count in self.words.part_counts}
        made = counted_solid(self.solid, self.parts.drawn(), counts)
        return PaintedSolid(self.words, made, self.whole)

    def fitting(self) -> "PaintedSolid":
        """The same within the cube again, where some of its parts got another size."""
        if not self.parts.sizes:
            return self
        count = len(self.parts.components)
        verts = torch.cat([self.parts.surface_of(index)[0] for index in range(count)])
        return PaintedSolid(self.words, self.solid.framing(verts))

    @cached_property
    def emblems(self) -> list[Drawn]:
        """The prompt's emblems on it."""
        others = [one for one in self.words.emblems if not self._is_number(one)]
        return drawn_on(self.words.noun, others, self.parts, self.paints, self._portrait)

    def _portrait(self, emblem: Emblem) -> Portrait:
        """The picture of another thing."""
        color = ("", "") if emblem.color in METALS else (emblem.color, emblem.color_form)
        words = Words(emblem.shape, color=color[0], color_form=color[1])
        row = torch.tensor([words.indices(GEOMETRY_SLOTS)])
        drawn = Solid.drawn(self.solid.net, row, torch.Generator().manual_seed(0)).placed()
        other = PaintedSolid(words, drawn)
        colors = [paint.color for paint in other.paints]

        def area_of(points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
            return other.shown(points)[:, : len(colors)].argmin(1)

        return portrait_of(*drawn.mesh, area_of, colors)

    @cached_property
    def drawn(self) -> list[Drawn | Overlay]:
        """All that is drawn on it, each over those before."""
        layers = (layer for emblem in self.emblems for layer in emblem.layers())
        return [*self.emblems, *layers, *self.expression]

    @cached_property
    def expression(self) -> list[Overlay]:
        """The lids, the brows and the mouth of its mood, and the reflections in its eyes."""
        words, noun = self.words, self.words.noun
        if self.asleep or not has_face(noun):
            return []
        marked, count = self._marked_without(set()), len(self.paints)

        def distances(points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
            return marked(self.solid.distances(points), points)[:, :count]

        lively = not words.is_statue and is_lively(noun)
        if not words.mood and not lively:
            return []
        known = list(looks(noun)), self.parts.boxes(), marked.bearers, distances, self.paints
        return expression(words.mood, lively, *known)

    @cached_property
    def number(self) -> str:
        """The stated text of the number that the thing has by nature."""
        return next((one.text for one in self.words.emblems if self._is_number(one)), "")

    def _is_number(self, emblem: Emblem) -> bool:
        elsewhere = emblem.on or emblem.side or emblem.color
        short = emblem.text.isdecimal() and len(emblem.text) < LONG
        return short and not elsewhere and is_marking(self.words.noun, NUMBER)

    @cached_property
    def marked(self) -> Marked:
        """The markings among its parts."""
        redrawn = {one.paint.name for one in self.expression}
        return self._marked_without(redrawn & {MOUTH})

    def _marked_without(self, redrawn: set[str]) -> Marked:
        """``redrawn``: those that an expression replaces."""
        noun = self.words.noun
        gone = redrawn | {name for name in self.words.absent if not bears(self.words, name)}
        gone |= unfit_markings(noun, {part.name: part.material for part in self.paints})
        gone |= {part.name for part in self.paints if part.look.asked and not part.apart}
        gone |= set(IN_EYES) if self.asleep else set()
        if any(one.emblem.text and not one.emblem.on for one in self.emblems):
            gone |= {"letters", NUMBER}  # the prompt's own replace them
        if self.words.emblems and is_marking(noun, "badge"):
            taken = {self.paints[one.on].name for one in self.emblems if one.has_place}
            gone |= {"badge"} if bearer_of(noun, "badge") in taken else set()
        names = ["" if name in gone else name for name in looks(noun)]
        if not has_markings(noun):
            return Marked(noun, names, ())
        boxes, every = self.parts.boxes(), self.parts.component_boxes()
        return Marked(noun, names, boxes, self.number, every)

    @cached_property
    def axes(self) -> tuple[int, ...]:
        """For each part, the axis along which stripes follow one another; none without a striped
        part."""
        if not ALONG.intersection(one.pattern for one in self.paints):
            return ()
        extents, names = self.parts.extents(), [one.name for one in self.paints]
        borne = (names.index(bearer_of(self.words.noun, name)) for name in names)
        return tuple(axis_of(extents[part]) for part in borne)

    def shown(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The drawn distances with the markings among the parts."""
        return self.marked(self.solid.distances(points), points)

    def area_fields(self, axes: Sequence[int]) -> AreaFields:
        """The parts in the colours of their patterns, in space, with the properties of each area.

        ``axes``: ``self.axes``, or () for none.
        """
        along = axes or (2,) * len(self.paints)
        laid = [Laid(part.pattern, axis) for part, axis in zip(self.paints, along, strict=True)]
        each, shown_on = [], []  # the part of each area, or the one below it
        for index, (part, pattern) in enumerate(zip(self.paints, laid, strict=True)):
            # The places of some patterns' colours are learnt, such as those of a tower's bricks.
            plain = pattern.colors > 1 or part.pattern in ("", part.finish.pattern)
            colors = [part.colors()[k] if plain else None for k in range(pattern.colors)]
            surface = surface_of(self.words, part)
            uneven = [index in self.marked.uneven] * len(colors)
            if part.pattern in LINES:
                uneven[1] = True
            pairs = zip(colors, uneven, strict=True)
            each += [Area(plain, ranges_of(part.finish, one), surface, not x) for one, x in pairs]
            shown_on += [index] * len(colors)
        margins = [pattern.margins() for pattern in laid]
        fields = [self.shown, lambda points: self.marked(self.parts.near(points), points)]
        for drawn in self.drawn:
            fields = [partial(_with, drawn, len(margins), field) for field in fields]
            paint = drawn.paint
            surface = surface_of(self.words, paint)
            level = drawn.on not in self.marked.uneven
            each.append(Area(True, ranges_of(paint.finish, paint.color), surface, level))
            margins.append(None)
            shown_on.append(drawn.on)
        if self.cut:
            fields = [partial(self.cut.shown, field, count=len(margins)) for field in fields]
            each += self.cut.areas
            margins += [None] * len(self.cut.areas)
            shown_on += [part for part, _ in self.cut.fills]
        drawn, near = (patterned(depths(of, len(margins)), margins) for of in fields)
        parts = torch.tensor(shown_on)
        return AreaFields(drawn, near, tuple(each), lambda at, of: self._height(at, parts[of]))

    def _height(self, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"]) -> Float[Tensor, " n"]:
        """How far the surface stands out at points of the parts; the lines of a pattern that
        belongs to the thing's form are sunk, such as a basketball's seams."""
        found = self.marked.height(points, part)
        for index, paint in enumerate(self.paints):
            if paint.pattern in LINES:
                here = (part == index).nonzero().squeeze(1)
                found[here] += GROOVE.at(MARGINS[paint.pattern](points[here]))
        return found

    def left_out(self) -> tuple[str, ...]:
        """A note on each emblem without room on the thing, on each part that stays, and on each
        part that keeps its size."""
        stay = (part for part in self.words.absent if bears(self.words, part))
        no_room = (one.emblem for one in self.emblems if not one.has_place)
        drawn = self.whole and not isinstance(self.solid, Garment)
        sized = stated_sizes(self.words) if isinstance(self.solid, ConstructedSolid) else None
        return (
            *(f"no {part}: {BEARS}" for part in stay),
            *(f"{emblem}: {NO_ROOM}" for emblem in no_room),
            *self.uncounted(),
            *(() if drawn and sized is None else unsized(self.words, sized if drawn else None)),
            *(() if drawn else uncut(self.words)),
        )

    def uncounted(self) -> Iterator[str]:
        """A note on each part whose number is left out."""
        if not isinstance(self.solid, CountedSolid):
            yield from uncounted_of(self.words)
            return
        names = list(looks(self.words.noun))
        unfit = {names[part] for part in self.solid.unfit}
        stated = (one for one in self.words.part_counts if one[0] in unfit)
        yield from (f"{count} {part}: {UNFIT_COUNT}" for part, count in stated)


def _closed(paints: Sequence[Painted]) -> Iterator[Painted]:
    """With eyelids, in a shade of what is around them, over the eyes."""
    face = next((one for one in paints if one.name in FACES), paints[0])
    lid = face._replace(color=tuple(LID * x for x in face.color), pattern="")
    shut = (*EYES, *IN_EYES)
    return (lid._replace(name=one.name) if one.name in shut else one for one in paints)


def unsized(words: Words, sized: Container[str] | None = None) -> Iterator[str]:
    """A note on each part whose size is left out; ``sized``: the parts of what is put together
    that have theirs."""
    why, there = (UNSIZED, ()) if sized is None else (FIXED, sized)
    return (f"{size} {part}: {why}" for part, size in words.part_sizes if part not in there)


def uncounted_of(words: Words) -> Iterator[str]:
    """A note on each part whose number is left out."""
    return (f"{count} {part}: {UNCOUNTED}" for part, count in words.part_counts)


def uncut(words: Words) -> Iterator[str]:
    """A note on a cut that is left out."""
    if words.cut:
        yield f"{words.noun} {words.cut}: {UNCUT}"


def bears(words: Words, part: str) -> bool:
    """Whether the part stays for the markings on it, which are at least half of the thing's parts:
    a door goes with its panels, a rug's border stays under its lozenges."""
    noun = words.noun
    present = [name for name in looks(noun) if name not in words.absent]
    laid = [name for name in present if is_marking(noun, name) and bearer_of(noun, name) == part]
    return bool(laid) and 2 * len(laid) >= len(present)


def _with(
    drawn: Drawn | Overlay,
    count: int,
    field: Callable[[Tensor], Tensor],
    points: Float[Tensor, "n 3"],
) -> Float[Tensor, "n p"]:
    """The distances of the first ``count`` areas, and that of what is drawn on them."""
    return drawn(field(points)[:, :count], points)
