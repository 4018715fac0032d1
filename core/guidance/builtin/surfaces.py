"""The substance of each part, by a prompt's words and by nature."""

from functools import cache

import torch

from core.appearance.material_ranges import MaterialRanges
from core.guidance.builtin.palette import FINISHES, Finish, Painted, darker, painted
from core.guidance.builtin.substances import BURNING, UNWORN, lights
from core.guidance.builtin.variants import ALL_CLEAR, BUILDINGS, VARIANTS, Variant, split_tone
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.colors import Color, luma, toned
from core.guidance.guidance import Area, Surface
from core.ops import srgb_to_linear

# Roughness by the word; for a metal at least that of a polished one.
SHINES = {"matte": 0.8, "satin": 0.4, "glossy": 0.1}
METAL_SHINE = 0.12
CARVED_STONE = "concrete"  # of even grain: a boulder's speckles hide a face
GLOWING = "glowing"
# Emitted fraction of the colour where a glow is stated: for a part, or for all of a thing.
PART_GLOWS, ALL_GLOWS = 0.8, 0.25
# Between these lumas a colour on wood becomes paint; the last is how much of the grain shows.
PALE, PALE_DEPTH = (0.6, 0.9), 0.35
WHITE = 0.8  # luma of a part painted by nature, such as a window's frame
GLOSS = 0.03  # range of a part's roughness around its finish's
SHADE = 0.06  # range of each channel of a part's colour, sRGB
SMOOTH = 0.05  # how much smoother clear glass is than the finish


def surfaces_of(words: Words) -> tuple[Surface, ...]:
    """The surfaces of the thing's parts, without repeats."""
    found = [surface_of(words, part) for part in painted(words.noun, words)]
    return tuple(dict.fromkeys(found))


def surface_of(words: Words, part: Painted) -> Surface:
    """The substance of one part, and its weathering."""
    new = _shining(part, _lit(words.noun, part, _as_new(words, part)))
    lasting = (name for name in words.weather if name != "worn" or new.kind not in UNWORN)
    spared = new.kind in ("eye", "liquid", *BURNING)
    return new if spared else new._replace(weather=tuple(lasting))


def _as_new(words: Words, part: Painted) -> Surface:
    if not part.material:
        kind = _by_nature(words.noun, part)
        depth = _depth(part.color) if kind == "wooden" and luma(part.color) > WHITE else 1.0
        return Surface(kind, part.color, depth=depth)
    tone, form = split_tone(part.material_form)
    variant = VARIANTS.get(form) or Variant(_kind(words, part))
    wanted = variant.color
    if wanted and part.look.shaded and not part.apart:
        wanted = darker(wanted)
    if tone:
        wanted = toned(wanted or part.color, tone)
    finish = FINISHES[part.material]
    factor = (1.0, 1.0, 1.0)
    # A stated colour is painted as it is; else the wider word's own colour becomes the variant's.
    if wanted and not part.colored:
        factor = _factor(part.color, wanted)
    roughness = 0.0 if variant.roughness is None else variant.roughness - finish.roughness
    depth = _depth(part.color) if part.colored and variant.kind == "wooden" else 1.0
    return Surface(
        variant.kind,
        part.color,
        factor,
        roughness,
        clear=variant.clear,
        depth=depth,
        glow=variant.glow,
    )


def _depth(color: Color) -> float:
    """The depth of the grain under a stated colour: a white part is painted, and shows little of
    it."""
    low, high = PALE
    return 1 - (1 - PALE_DEPTH) * min(max((luma(color) - low) / (high - low), 0), 1)


def _lit(noun: str, part: Painted, new: Surface) -> Surface:
    """``new`` with its glow and transmission by nature; for glass, also where that is stated."""
    if (part.material and not new.clear) or new.clear == ALL_CLEAR:
        return new
    glow, clear = lights(noun, part.name, new.kind)
    # Clear glass is smooth, so that it does not blur.
    smooth = new.roughness - (SMOOTH if clear and not new.clear else 0.0)
    return new._replace(glow=glow, clear=clear or new.clear, roughness=smooth)


def _shining(part: Painted, new: Surface) -> Surface:
    """``new`` with the gloss of the words."""
    if GLOWING in part.sheen:
        new = new._replace(glow=max(new.glow, PART_GLOWS if part.apart else ALL_GLOWS))
    shine = next((SHINES[word] for word in part.sheen if word in SHINES), None)
    if shine is None or new.kind in UNWORN:
        return new
    wanted = max(shine, METAL_SHINE) if part.finish.metallic > 0.5 else shine
    return new._replace(roughness=wanted - part.finish.roughness)


def _kind(words: Words, part: Painted) -> str:
    if part.material == "stone" and words.is_statue:
        return CARVED_STONE
    if part.material == "stone" and words.noun in BUILDINGS:
        return "masonry"
    # Rust has its own colour; with another one it is paint that rusts.
    if part.material == "rusty" and part.color != FINISHES["rusty"].color:
        return "rusted paint"
    return part.material


def _by_nature(noun: str, part: Painted) -> str:
    known = part.look.material or "plain"
    # A train's chimney is no wall.
    return "paint" if known == "brick" and noun not in BUILDINGS else known


@cache
def _factor(known: Color, wanted: Color) -> Color:
    """The linear factor from ``known`` to ``wanted`` (sRGB)."""
    before, after = srgb_to_linear(torch.tensor([known, wanted]))
    red, green, blue = (after / before).tolist()
    return red, green, blue


def ranges_of(finish: Finish, color: Color | None) -> MaterialRanges:
    """The finish itself: pictures of 64² teach no more than how to reach the ends. For a part of
    one ``color`` (sRGB) a range around it: the pictures made black things green."""
    rough = finish.roughness
    low, high = max(rough - GLOSS, 0.05), min(rough + GLOSS, 0.95)
    metallic = (finish.metallic, finish.metallic)
    if color is None:
        return MaterialRanges((low, high), metallic)
    return MaterialRanges((low, high), metallic, shades_of(color))


def unseen(area: Area) -> Area:
    """An area that no picture shows: of one colour, as no other could be learnt."""
    if area.ranges.color is not None:
        return area
    ranges = area.ranges._replace(color=shades_of(area.surface.color))
    return area._replace(plain=True, ranges=ranges)


def shades_of(color: Color) -> tuple[Color, Color]:
    """The least and the greatest linear colour around one, sRGB."""
    around = torch.tensor(color) + torch.tensor([[-SHADE], [SHADE]])
    least, most = srgb_to_linear(around.clamp(0, 1)).tolist()
    return tuple(least), tuple(most)
