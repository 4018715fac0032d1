"""Paint for the families: what colour each part has by nature, and what the words change.

Colours are written as sRGB in [0, 1], the way one picks them, and become linear kd in ``paint``.
Patterns live in the object's space or on its normals, so that they are the same in every view.
"""

from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.ops import srgb_to_linear
from core.prior.families import FAMILIES, Draw

Color = tuple[float, float, float]

COLOR_VALUES: dict[str, Color] = {
    "red": (0.80, 0.08, 0.08),
    "orange": (0.95, 0.45, 0.05),
    "yellow": (0.95, 0.82, 0.10),
    "green": (0.12, 0.55, 0.15),
    "cyan": (0.10, 0.70, 0.75),
    "blue": (0.10, 0.20, 0.75),
    "purple": (0.45, 0.12, 0.65),
    "pink": (0.95, 0.45, 0.65),
    "brown": (0.42, 0.24, 0.12),
    "black": (0.05, 0.05, 0.05),
    "white": (0.92, 0.92, 0.90),
    "grey": (0.48, 0.48, 0.49),
}
WOOD: Color = (0.56, 0.36, 0.19)


@dataclass(frozen=True)
class Finish:
    """A material word: its own colour unless a colour is said, and how it shines."""

    color: Color | None
    roughness: float
    metallic: float
    pattern: str = ""


PLAIN = Finish(None, 0.5, 0.0)
FINISHES: dict[str, Finish] = {
    "": PLAIN,
    "wooden": Finish(WOOD, 0.6, 0.0, "grain"),
    "metal": Finish((0.74, 0.75, 0.77), 0.3, 1.0),
    "golden": Finish((1.0, 0.78, 0.34), 0.25, 1.0),
    "plastic": Finish(None, 0.25, 0.0),
    "rubber": Finish((0.13, 0.13, 0.14), 0.85, 0.0),
    "stone": Finish((0.55, 0.53, 0.50), 0.9, 0.0, "mottle"),
}

# By nature: each part's colour; a name after it is a pattern, a third entry its finish.
NATURE: dict[str, dict[str, tuple]] = {
    "ball": {"body": ((0.85, 0.40, 0.12),)},
    "cube": {"body": ((0.62, 0.60, 0.56),)},
    "torus": {"body": ((0.72, 0.47, 0.22), "icing")},
    "cylinder": {"body": ((0.35, 0.48, 0.60),)},
    "cone": {"body": ((0.93, 0.38, 0.06), "band")},
    "table": {"top": (WOOD, "grain"), "legs": ((0.46, 0.29, 0.15), "grain")},
    "chair": {"seat": (WOOD, "grain"), "back": (WOOD, "grain"), "legs": ((0.46, 0.29, 0.15),)},
    "armchair": {
        "cushion": ((0.62, 0.32, 0.24),),
        "back": ((0.54, 0.26, 0.19),),
        "arms": ((0.54, 0.26, 0.19),),
    },
    "mug": {"body": ((0.88, 0.86, 0.82),), "handle": ((0.88, 0.86, 0.82),)},
    "vase": {"body": ((0.72, 0.38, 0.24), "band")},
    "bottle": {"body": ((0.12, 0.40, 0.22),), "cap": ((0.20, 0.17, 0.15),)},
    "lamp": {
        "shade": ((0.93, 0.86, 0.68),),
        "pole": ((1.0, 0.78, 0.34), "", "golden"),
        "foot": ((0.25, 0.20, 0.17),),
    },
    "snowman": {
        "body": ((0.93, 0.94, 0.96),),
        "hat": ((0.07, 0.07, 0.08),),
        "nose": ((0.95, 0.45, 0.05),),
        "buttons": ((0.05, 0.05, 0.05),),
    },
    "mushroom": {"cap": ((0.80, 0.10, 0.07), "spots"), "stem": ((0.90, 0.85, 0.74),)},
    "house": {
        "walls": ((0.90, 0.82, 0.64),),
        "roof": ((0.62, 0.20, 0.13),),
        "chimney": ((0.48, 0.26, 0.20),),
        "door": ((0.40, 0.24, 0.13),),
        "windows": ((0.55, 0.75, 0.90),),
    },
    "dumbbell": {"weights": ((0.14, 0.14, 0.15),), "bar": ((0.74, 0.75, 0.77), "", "metal")},
    "rocket": {
        "hull": ((0.90, 0.90, 0.91),),
        "nose": ((0.80, 0.10, 0.08),),
        "fins": ((0.80, 0.10, 0.08),),
        "nozzle": ((0.30, 0.30, 0.32), "", "metal"),
    },
    "tree": {"leaves": ((0.13, 0.42, 0.16),), "trunk": ((0.38, 0.24, 0.13),)},
}
# The parts that a colour or material word is about; all others keep their nature.
MAIN: dict[str, tuple[str, ...]] = {
    "bottle": ("body",),
    "lamp": ("shade",),
    "snowman": ("body",),
    "mushroom": ("cap",),
    "house": ("walls",),
    "dumbbell": ("weights",),
    "rocket": ("hull",),
    "tree": ("leaves",),
}
PATTERNS = ("", "grain", "mottle", "icing", "band", "spots")
JITTER = 0.06  # spread of a colour's channels between objects, and of its brightness


@cache
def part_names(noun: str) -> tuple[str, ...]:
    """The family's parts, in the order of the pictures' part index."""
    return tuple(FAMILIES[noun](Draw(torch.Generator())))


def finishes_of(noun: str, material: str) -> list[Finish]:
    """The finish of every part of ``noun``, where the word ``material`` ("" for none) is said."""
    main = MAIN.get(noun, tuple(NATURE[noun]))
    nature = {part: FINISHES[(*look, "", "")[2]] for part, look in NATURE[noun].items()}
    said = FINISHES[material]
    return [said if material and part in main else nature[part] for part in NATURE[noun]]


class Place(NamedTuple):
    """Where on the object: what patterns are made of."""

    point: Float[Tensor, "p 3"]
    normal: Float[Tensor, "p 3"]


@dataclass(frozen=True)
class Coat:
    """Paint of K parts."""

    color: Float[Tensor, "k 3"]  # sRGB
    roughness: Float[Tensor, "k 1"]
    metallic: Float[Tensor, "k 1"]
    pattern: Int[Tensor, " k"]  # index into PATTERNS


def coat(noun: str, color: str, material: str, draw: Draw) -> Coat:
    """The paint of one object whose caption says these words; empty is not said."""
    rows = []
    for part in part_names(noun):
        own, pattern, finish_name = (*NATURE[noun][part], "", "")[:3]
        finish = FINISHES[finish_name]
        if part in MAIN.get(noun, part_names(noun)):
            if material:
                finish = FINISHES[material]
                own, pattern = finish.color or own, finish.pattern
            if color:
                own, pattern = COLOR_VALUES[color], finish.pattern
        rows.append((own, finish, PATTERNS.index(pattern)))
    shift = 1 + draw(-JITTER, JITTER)
    tint = torch.tensor([draw(-JITTER, JITTER) / 2 for _ in range(3)])
    colors = (torch.tensor([row[0] for row in rows]) * shift * (1 + tint)).clamp(0.02, 1)
    gloss = draw(-0.05, 0.05)
    return Coat(
        colors,
        torch.tensor([[row[1].roughness + gloss] for row in rows]),
        torch.tensor([[row[1].metallic] for row in rows]),
        torch.tensor([row[2] for row in rows]),
    )


def paint(
    coat: Coat, part: Int[Tensor, " p"], point: Float[Tensor, "p 3"], normal: Float[Tensor, "p 3"]
) -> tuple[Float[Tensor, "p 3"], Float[Tensor, "p 1"], Float[Tensor, "p 1"]]:
    """kd (linear), roughness and metallic of points of the parts."""
    color = coat.color[part]
    pattern = coat.pattern[part]
    for index, name in enumerate(PATTERNS):
        if name and bool((coat.pattern == index).any()):
            painted = PATTERN_FUNCTIONS[name](color, Place(point, normal))
            color = torch.where((pattern == index)[:, None], painted, color)
    return srgb_to_linear(color.clamp(0, 1)), coat.roughness[part], coat.metallic[part]


def grain(color: Tensor, place: Place) -> Tensor:
    """Wood: dark veins along the longest way of the object's height."""
    x, y, z = place.point.unbind(1)
    veins = (26 * x + 9 * y + 2.5 * (3 * z).sin()).sin()
    return color * (1 + 0.13 * veins)[:, None]


def mottle(color: Tensor, place: Place) -> Tensor:
    """Stone: soft blotches."""
    x, y, z = place.point.unbind(1)
    blotch = (11 * x + 2 * (7 * y).sin()).sin() * (12 * z + 2 * (8 * x).sin()).sin()
    return color * (1 + 0.2 * blotch * (10 * y + 1).cos())[:, None]


def icing(color: Tensor, place: Place) -> Tensor:
    """A doughnut's pink upper side, with a wavy edge."""
    angle = torch.atan2(place.point[:, 1], place.point[:, 0])
    iced = place.normal[:, 2] > 0.12 + 0.22 * (6 * angle).sin()
    return torch.where(iced[:, None], color.new_tensor([0.95, 0.55, 0.70]), color)


def band(color: Tensor, place: Place) -> Tensor:
    """A light band about the middle."""
    inside = (place.point[:, 2] + 0.08).abs() < 0.13
    return torch.where(inside[:, None], color.new_tensor([0.94, 0.93, 0.90]), color)


def spots(color: Tensor, place: Place) -> Tensor:
    """White spots where the normal points to one of a few directions; none below."""
    turns = torch.arange(6) * (torch.pi / 3)
    low = torch.stack([turns.cos() * 0.8, turns.sin() * 0.8, torch.full((6,), 0.6)], 1)
    axes = torch.cat([torch.tensor([[0.0, 0.0, 1.0]]), low]).to(color)
    spotted = (place.normal @ axes.T).amax(1) > 0.965
    return torch.where(spotted[:, None], color.new_tensor([0.95, 0.93, 0.88]), color)


PATTERN_FUNCTIONS = {
    "grain": grain,
    "mottle": mottle,
    "icing": icing,
    "band": band,
    "spots": spots,
}
