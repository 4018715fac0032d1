"""An emblem of a prompt (``words.phrases.emblems``) on a thing: its place and its colour."""

import colorsys
import textwrap
from collections.abc import Callable, Sequence
from functools import partial

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.guidance.builtin.markings.emblems.portraits import Portrait
from core.guidance.builtin.markings.emblems.scattered import Scattered, scattered_on
from core.guidance.builtin.markings.emblems.windows import HOLES, Window, window_on
from core.guidance.builtin.markings.margins import all_of
from core.guidance.builtin.markings.markings import bearer_of
from core.guidance.builtin.markings.overlay import Overlay
from core.guidance.builtin.markings.shapes import shape_margin
from core.guidance.builtin.markings.stencils import lettering, text_size
from core.guidance.builtin.palette import FINISHES, PAINT, Painted, companion
from core.guidance.builtin.substances import CLASS_OF, GLASS, METAL
from core.guidance.builtin.words.grammar.part_names import own_names
from core.guidance.builtin.words.phrases.emblems import METALS, STRIPES, Emblem
from core.guidance.builtin.words.phrases.moods import MOODS
from core.guidance.builtin.words.tables.colors import Color, color_value
from core.guidance.builtin.words.tables.living import is_creature

FULL = 0.8  # fraction of its place that a text or a shape fills
BOLD = 0.03  # of a capital's height: how much wider its strokes are than the font's
LINE = 10  # letters: a longer text has several lines
# Parts that are made to be written on, and parts without writing.
BOARDS = frozenset(
    """label labels sign board boards plate paper pages page canvas cover covers badge panel panels
    cloth doors door shield sail sticker wrapper sleeve screen belly""".split()
)
TRUNK = ("chest", "torso", "tummy", "breast")
DOORS = ("door", "doors")
NOT_ON = frozenset("wheels hubs tyres windows eyes lamps hair legs feet hands".split())
COLORS: dict[str, Color] = {  # where the prompt names no colour
    "heart": (0.84, 0.10, 0.16),
    "star": (0.96, 0.78, 0.20),
    "flame": (0.95, 0.38, 0.08),
    "lightning bolt": (0.98, 0.83, 0.15),
    "cross": (0.84, 0.10, 0.14),
    "check mark": (0.20, 0.62, 0.25),
    "moon": (0.96, 0.84, 0.42),
    "sun": (0.97, 0.75, 0.12),
    "flower": (0.93, 0.47, 0.66),
    "snowflake": (0.95, 0.97, 0.99),
    "crown": (0.93, 0.73, 0.20),
    "anchor": (0.10, 0.17, 0.36),
    "leaf": (0.25, 0.55, 0.22),
    **{f"{mood} face": (0.09, 0.07, 0.07) for mood in MOODS},
}
UNEVEN = 0.1  # fraction of a face's or a picture's rectangle that may be uneven
INK: Color = (0.11, 0.09, 0.1)  # of the lines of a portrait
MAIN = 0.6  # fraction of the most worth: nothing is scattered on parts of less
CLEAR = 0.3  # least difference of one channel from the colour below
VIVID, SAME_HUE = 0.3, 0.08  # saturation; of the circle
STRIPE, APART = 0.1, 0.24  # half of a racing stripe, and from the middle, in halves of the width


def drawn_on(
    noun: str,
    emblems: Sequence[Emblem],
    parts: KnownParts,
    paints: list[Painted],
    portrait: Callable[[Emblem], Portrait] | None = None,
) -> "list[Drawn]":
    """All emblems of an object; changes paints on which an emblem would not be visible.

    ``portrait``: draws the picture of another thing.
    """
    found: list[Drawn] = []
    for emblem in emblems:
        picture = portrait(emblem) if portrait and emblem.is_portrait else None
        found.append(Drawn(emblem, noun, parts, paints, found, picture))
        found[-1].make_seen(paints)
    return found


class Drawn:
    """An emblem on one object: its paint, and the parts' distances with the emblem's as the
    last."""

    def __init__(
        self,
        emblem: Emblem,
        noun: str,
        parts: KnownParts,
        paints: list[Painted],
        before: "Sequence[Drawn]" = (),
        portrait: Portrait | None = None,
    ) -> None:
        """
        Args:
            before: emblems that are already on the object, at the end of the distances.
            portrait: its picture, if it is one of a thing.
        """
        self.emblem, self.count = emblem, len(paints) + len(before)
        self.portrait = portrait
        self.text = _in_lines(emblem.text)
        wide, high = text_size(self.text) if self.text else (1.0, 1.0)
        self.high = high
        is_face = emblem.shape.endswith(" face")
        side = emblem.side or ("front" if is_face or is_creature(noun) else "")
        on = "body" if emblem.on in TRUNK else emblem.on
        # A marking has no surface of its own.
        asked = [bearer_of(noun, name) for name in own_names(noun, on)] if on else []
        if on in DOORS and not asked:  # a car's doors are lines on its body
            side = side or "side"
        worth = [_worth(paint, asked, emblem) for paint in paints]
        self.window: Window | None = None
        self.stripes: Float[Tensor, "2 3"] | None = None
        self.scattered: Scattered | None = None
        self.over: list[int] = []  # the parts that it is put on
        if emblem.shape == STRIPES:
            self.on = worth.index(max(worth))
            self.stripes = parts.boxes()[self.on]
        elif emblem.is_scattered:
            self.on = worth.index(max(worth))
            self.over = [part for part, much in enumerate(worth) if much >= MAIN * max(worth) > 0]
            self.scattered = scattered_on(parts, self.over)
        else:
            taken = [one.window for one in before if one.window]
            # A face may be on a pumpkin's ribs, a picture go a little around a mug.
            holes = UNEVEN if portrait or is_face else HOLES
            self.window = window_on(parts, worth, wide / high, side, taken, holes)
            if self.window is None and asked:  # without room there, anywhere
                worth = [_worth(paint, [], emblem) for paint in paints]
                self.window = window_on(parts, worth, wide / high, side, taken, holes)
            self.on = self.window.part if self.window else 0
        if self.scattered is None:
            self.over = [self.on]
        self.bears = [part for part, much in enumerate(worth) if much > 0]
        if self.stripes is not None:  # not on helmets and wings
            self.bears = [self.on, *(k for k, x in enumerate(paints) if x.look.role == "*")]
        self.bears += range(len(paints), self.count)
        below = paints[self.on]
        self.paint = (
            _painted(below, emblem._replace(color=""), INK)
            if portrait
            else _painted(below, emblem, _color(below.color, emblem))
        )
        self._below = below

    def layers(self) -> list[Overlay]:
        """The colours of a portrait, on its silhouette."""
        if self.portrait is None or self.window is None:
            return []
        found, silhouette = [], self.count
        for layer in self.portrait.layers:
            color = layer.color
            if self.emblem.color in METALS:
                color = _color(self._below.color, self.emblem)
            paint = _painted(self._below, self.emblem, color)
            margin = partial(self._in_window, of=layer.margin)
            found.append(Overlay(margin, (silhouette,), self.on, paint))
        return found

    @property
    def has_place(self) -> bool:
        """Whether any of it is visible."""
        return any(one is not None for one in (self.window, self.stripes, self.scattered))

    def make_seen(self, paints: list[Painted]) -> None:
        """Change the paints below it that have their natural colour, so that it is visible; a
        portrait is, by its lines."""
        if self.portrait:
            return
        for part in self.over:
            on = paints[part]
            seen = differ(on.color, self.paint.color) and not has_same_hue(
                on.color, self.paint.color
            )
            if not (on.colored or on.material or seen):
                other = companion(self.paint.color)
                paints[part] = on._replace(color=other, second=other, pattern="", colored=True)

    def __call__(
        self, distances: Float[Tensor, "n p"], points: Float[Tensor, "n 3"]
    ) -> Float[Tensor, "n q"]:
        """The parts' distances, and the emblem's."""
        own = Overlay(self._margin, tuple(self.bears), self.on, self.paint)
        return own(distances[:, : self.count], points)

    def _margin(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """How far inside the emblem, training units."""
        if self.stripes is not None:
            low, high = self.stripes.to(points)[:, 0]
            half, x = (high - low) / 2, (points[:, 0] - (low + high) / 2).abs()
            return STRIPE * half - (x - APART * half).abs()
        if self.scattered is not None:
            return self.scattered.margin(points, self.emblem.shape)
        if self.window is None:
            return torch.full_like(points[:, 0], -1.0)
        if self.portrait:
            return self._in_window(points, self.portrait.margin)
        at, half = self.window.at(points) / FULL, self.window.half * FULL
        if not self.text:
            return all_of(shape_margin(at, self.emblem.shape) * half, self.window.before(points))
        letter = self.high / 2  # a capital's height, of half the text's
        margin = (lettering(at * letter, self.text) + BOLD) * half / letter
        return all_of(margin, self.window.before(points))

    def _in_window(
        self, points: Float[Tensor, "n 3"], of: Callable[[Float[Tensor, "n 2"]], Tensor]
    ) -> Float[Tensor, " n"]:
        """The margin ``of`` places of the window, training units."""
        window = self.window
        assert window is not None
        return all_of(of(window.at(points) / FULL) * window.half * FULL, window.before(points))


def _in_lines(text: str) -> str:
    if len(text) <= LINE or " " not in text:
        return text
    longest = max(map(len, text.split()))
    return "\n".join(textwrap.wrap(text, max(longest, LINE, -(-len(text) // 3))))


def _worth(paint: Painted, asked: list[str], emblem: Emblem) -> float:
    """How well it is written on a part."""
    if paint.name in asked:
        return 1.0
    glass = CLASS_OF.get(paint.look.material) == GLASS and paint.look.role != "*"
    if asked or glass or paint.name in NOT_ON:
        return 0.0
    much = 1.6 if paint.name in BOARDS else 1.0 if paint.look.role == "*" else 0.6
    return much if differ(paint.color, _color(paint.color, emblem)) else much / 2


def _painted(on: Painted, emblem: Emblem, color: Color) -> Painted:
    """Its colour on the part below: of the same material where that takes paint, otherwise
    paint."""
    look = on.look._replace(role="+", color=color, pattern="")
    own = on._replace(name="emblem", look=look, color=color, second=color, pattern="", tone="")
    if emblem.color in METALS:
        return own._replace(
            finish=FINISHES[emblem.color], material=emblem.color, material_form=emblem.color_form
        )
    own = own._replace(colored=True, apart=True)
    kind = CLASS_OF.get(on.material or on.look.material, "")
    if kind in (GLASS, METAL) or (on.material or on.look.material) in ("liquid", "paint"):
        return own._replace(
            finish=PAINT, material="", material_form="", look=look._replace(material="paint")
        )
    return own


def _color(on: Color, emblem: Emblem) -> Color:
    if emblem.color in METALS:
        metal = FINISHES[emblem.color].color
        assert metal is not None  # each has one
        return metal
    if emblem.color:
        return color_value(emblem.color, emblem.color_form)
    own = COLORS.get(emblem.shape)
    return own if own and differ(own, on) else companion(on)


def differ(one: Color, other: Color) -> bool:
    """Whether one colour is visible on the other."""
    return max(abs(a - b) for a, b in zip(one, other, strict=True)) > CLEAR


def has_same_hue(one: Color, other: Color) -> bool:
    """Whether both have one hue, such as light blue and navy."""
    (hue, full, _), (hue_2, full_2, _) = (colorsys.rgb_to_hsv(*color) for color in (one, other))
    away = abs(hue - hue_2)
    return min(full, full_2) > VIVID and min(away, 1 - away) < SAME_HUE
