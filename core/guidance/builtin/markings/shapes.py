"""Shapes that can be drawn on a thing, as margins; each fills the square from -1 to 1."""

import math
from collections.abc import Callable, Sequence
from functools import cache, partial

import numpy as np
import torch
from jaxtyping import Float
from PIL import Image, ImageDraw
from torch import Tensor

from core.guidance.builtin.markings.stencils import margins_of, read
from core.guidance.builtin.words.phrases.moods import MOODS, Mood

SIDE = 384  # pixels
ROOM = 1.15  # from the middle to the picture's border

At = tuple[float, float]
Pen = ImageDraw.ImageDraw


def shape_margin(at: Float[Tensor, "p 2"], name: str) -> Float[Tensor, " p"]:
    """Positive inside.

    Args:
        at: places to the right of the shape's middle and above it.
    """
    scaled = at / at.new_tensor([ROOM, -ROOM])
    # Beyond the picture there is nothing.
    return read(_field(name), scaled) - (scaled.abs() - 1).clamp_min(0).amax(1)


@cache
def _field(name: str) -> Float[Tensor, "s s"]:
    picture = Image.new("L", (SIDE, SIDE))
    SHAPES[name](ImageDraw.Draw(picture))
    field = margins_of(np.asarray(picture) > 127) * (2 * ROOM / SIDE)
    return torch.from_numpy(field).float()


def _pixel(at: At) -> At:
    return (at[0] / ROOM + 1) * SIDE / 2, (1 - at[1] / ROOM) * SIDE / 2


def _polygon(pen: Pen, corners: Sequence[At], ink: int = 255) -> None:
    pen.polygon([_pixel(at) for at in corners], ink)


def _disc(pen: Pen, middle: At, radius: float, ink: int = 255, flat: float = 1.0) -> None:
    """``flat``: its height over its width."""
    (x, y), (u, v) = middle, (radius, radius * flat)
    pen.ellipse([_pixel((x - u, y + v)), _pixel((x + u, y - v))], ink)


def _stroke(pen: Pen, places: Sequence[At], wide: float, ink: int = 255) -> None:
    """A line with round ends."""
    width = round(wide * SIDE / ROOM)
    pen.line([_pixel(at) for at in places], ink, width, "curve")
    for at in (places[0], places[-1]):
        _disc(pen, at, wide, ink)


def _around(count: int, radius: float, first: float = 90.0) -> list[At]:
    """Places on a circle, from ``first`` degrees on."""
    angles = [math.radians(first + 360 * k / count) for k in range(count)]
    return [(radius * math.cos(a), radius * math.sin(a)) for a in angles]


def _star(pen: Pen) -> None:
    outer, inner = _around(5, 1.0), _around(5, 0.42, 126)
    _polygon(pen, [at for pair in zip(outer, inner, strict=True) for at in pair])


def _heart(pen: Pen) -> None:
    curve = []
    for k in range(64):
        t = math.tau * k / 64
        x = 16 * math.sin(t) ** 3
        y = 13 * math.cos(t) - 5 * math.cos(2 * t) - 2 * math.cos(3 * t) - math.cos(4 * t)
        curve.append((x / 17, (y + 2.5) / 17))
    _polygon(pen, curve)


def _smiley(pen: Pen) -> None:
    _disc(pen, (0, 0), 1.0)
    _disc(pen, (0, 0), 0.88, 0)
    for x in (-0.34, 0.34):
        _disc(pen, (x, 0.28), 0.13, flat=1.5)
    arc = [math.radians(205 + 130 * k / 16) for k in range(17)]
    _stroke(pen, [(0.55 * math.cos(a), 0.55 * math.sin(a) + 0.05) for a in arc], 0.07)


def _skull(pen: Pen, at: At = (0.0, 0.0), size: float = 1.0) -> None:
    x, y = at

    def place(u: float, v: float) -> At:
        return x + u * size, y + v * size

    _disc(pen, place(0, 0.25), 0.72 * size)
    _polygon(
        pen, [place(u, v) for u, v in ((-0.4, -0.2), (0.4, -0.2), (0.36, -0.85), (-0.36, -0.85))]
    )
    for side in (-1, 1):
        _disc(pen, place(0.28 * side, 0.12), 0.19 * size, 0)
        _polygon(
            pen, [place(u, v) for u, v in ((0.12 * side - 0.02, -0.5), (0.12 * side + 0.02, -0.5),
                  (0.12 * side + 0.02, -0.86), (0.12 * side - 0.02, -0.86))], 0
        )  # fmt: skip
    _polygon(pen, [place(u, v) for u, v in ((0, -0.1), (0.1, -0.3), (-0.1, -0.3))], 0)


def _crossbones(pen: Pen) -> None:
    for side in (-1, 1):
        _stroke(pen, [(-0.8 * side, -0.75), (0.8 * side, 0.05)], 0.09)
        for x, y in ((-0.8 * side, -0.75), (0.8 * side, 0.05)):
            _disc(pen, (x, y + 0.1), 0.13)
            _disc(pen, (x, y - 0.1), 0.13)
    _disc(pen, (0, 0.3), 0.66, 0)
    _skull(pen, (0, 0.22), 0.78)


def _bolt(pen: Pen) -> None:
    side = [(0.2, 1.0), (-0.5, -0.1), (-0.06, -0.1), (-0.25, -1.0), (0.5, 0.22), (0.06, 0.22)]
    _polygon(pen, [*side, (0.45, 1.0)])


def _cross(pen: Pen) -> None:
    for x, y in ((0.32, 0.95), (0.95, 0.32)):
        _polygon(pen, [(-x, -y), (x, -y), (x, y), (-x, y)])


def _peace(pen: Pen) -> None:
    _disc(pen, (0, 0), 1.0)
    _disc(pen, (0, 0), 0.82, 0)
    _stroke(pen, [(0, 0.85), (0, -0.85)], 0.085)
    for side in (-1, 1):
        _stroke(pen, [(0, 0), (0.62 * side, -0.62)], 0.085)


def _radiation(pen: Pen) -> None:
    for start in (60, 180, 300):
        arc = [math.radians(start + 60 * k / 12) for k in range(13)]
        _polygon(pen, [(0, 0), *((math.cos(a), math.sin(a)) for a in arc)])
    _disc(pen, (0, 0), 0.32, 0)
    _disc(pen, (0, 0), 0.2)


def _check(pen: Pen) -> None:
    _stroke(pen, [(-0.75, 0.0), (-0.25, -0.55), (0.75, 0.6)], 0.16)


def _note(pen: Pen) -> None:
    for x, y in ((-0.5, -0.7), (0.4, -0.5)):
        _disc(pen, (x, y), 0.28, flat=0.8)
        _stroke(pen, [(x + 0.22, y), (x + 0.22, y + 1.3)], 0.06)
    _polygon(pen, [(-0.34, 0.66), (0.68, 0.88), (0.68, 0.6), (-0.34, 0.38)])


def _paw(pen: Pen) -> None:
    _disc(pen, (0, -0.35), 0.52, flat=0.85)
    for x, y in ((-0.68, 0.12), (-0.26, 0.58), (0.26, 0.58), (0.68, 0.12)):
        _disc(pen, (x, y), 0.21, flat=1.3)


def _moon(pen: Pen) -> None:
    _disc(pen, (-0.1, 0), 0.95)
    _disc(pen, (0.3, 0.12), 0.78, 0)


def _sun(pen: Pen) -> None:
    for x, y in _around(12, 1.0):
        u, v = -y * 0.16, x * 0.16
        _polygon(pen, [(x, y), (0.5 * x + u, 0.5 * y + v), (0.5 * x - u, 0.5 * y - v)])
    _disc(pen, (0, 0), 0.55)


def _flower(pen: Pen) -> None:
    for at in _around(6, 0.58):
        _disc(pen, at, 0.36)
    _disc(pen, (0, 0), 0.4)
    _disc(pen, (0, 0), 0.26, 0)


def _snowflake(pen: Pen) -> None:
    for x, y in _around(6, 1.0):
        _stroke(pen, [(0, 0), (0.92 * x, 0.92 * y)], 0.065)
        for turn in (-1, 1):
            c, s = math.cos(turn * math.pi / 4), math.sin(turn * math.pi / 4)
            u, v = c * x - s * y, s * x + c * y
            _stroke(pen, [(0.55 * x, 0.55 * y), (0.55 * x + 0.3 * u, 0.55 * y + 0.3 * v)], 0.055)


def _arrow(pen: Pen) -> None:
    _polygon(pen, [(-1, 0.2), (0.1, 0.2), (0.1, 0.6), (1, 0), (0.1, -0.6), (0.1, -0.2), (-1, -0.2)])


def _crown(pen: Pen) -> None:
    teeth = [(-0.95, 0.65), (-0.45, 0.05), (0, 0.8), (0.45, 0.05), (0.95, 0.65)]
    _polygon(pen, [(-0.8, -0.7), *teeth, (0.8, -0.7)])
    for at in teeth[::2]:
        _disc(pen, at, 0.12)
    _polygon(pen, [(-0.8, -0.42), (0.8, -0.42), (0.8, -0.5), (-0.8, -0.5)], 0)


def _anchor(pen: Pen) -> None:
    _disc(pen, (0, 0.75), 0.22)
    _disc(pen, (0, 0.75), 0.1, 0)
    _stroke(pen, [(0, 0.55), (0, -0.85)], 0.09)
    _stroke(pen, [(-0.4, 0.32), (0.4, 0.32)], 0.08)
    arc = [math.radians(200 + 140 * k / 16) for k in range(17)]
    _stroke(pen, [(0.8 * math.cos(a), 0.8 * math.sin(a) - 0.05) for a in arc], 0.09)
    for side in (-1, 1):
        _polygon(pen, [(0.95 * side, -0.5), (0.55 * side, -0.25), (0.85 * side, 0.02)])


def _leaf(pen: Pen) -> None:
    arc = [k / 16 for k in range(17)]
    edge = [(0.55 * math.sin(math.pi * t) ** 0.8, 1 - 1.7 * t) for t in arc]
    _polygon(pen, [*edge, *((-x, y) for x, y in reversed(edge))])
    _stroke(pen, [(0, -0.6), (0, -0.95)], 0.05)
    _stroke(pen, [(0, 0.6), (0, -0.6)], 0.025, 0)


def _maple(pen: Pen) -> None:
    right = [
        (0, 1),
        (0.17, 0.68),
        (0.36, 0.76),
        (0.3, 0.34),
        (0.5, 0.53),
        (0.57, 0.4),
        (0.86, 0.44),
    ]
    right += [(0.77, 0.2), (0.93, 0.08), (0.55, -0.24), (0.6, -0.42), (0.07, -0.34), (0.05, -0.95)]
    _polygon(pen, [*right, *((-x, y) for x, y in reversed(right))])


def _flame(pen: Pen) -> None:
    right = [(0.05, 1.0), (0.12, 0.55), (0.42, 0.2), (0.46, 0.42), (0.72, -0.05), (0.7, -0.5)]
    right += [(0.42, -0.88), (0.0, -1.0)]
    left = [(-0.42, -0.88), (-0.7, -0.45), (-0.62, 0.05), (-0.5, 0.38), (-0.38, 0.1)]
    left += [(-0.18, 0.35), (-0.12, 0.75)]
    _polygon(pen, [*right, *left])
    inner = [(0.02, 0.12), (0.3, -0.35), (0.26, -0.66), (0.0, -0.8), (-0.26, -0.66), (-0.28, -0.35)]
    _polygon(pen, inner, 0)


def _ring(pen: Pen) -> None:
    _disc(pen, (0, 0), 0.95)
    _disc(pen, (0, 0), 0.68, 0)


def _face(pen: Pen, mood: Mood) -> None:
    """Two eyes, brows and a mouth."""
    for side in (-1, 1):
        x = 0.66 * side
        if mood == "sleepy":
            arc = [math.radians(200 + 140 * k / 12) for k in range(13)]
            _stroke(pen, [(x + 0.28 * math.cos(a), 0.4 + 0.28 * math.sin(a)) for a in arc], 0.085)
            continue
        _disc(pen, (x, 0.25), 0.24, flat=1.3)
        _disc(pen, (x - 0.06, 0.37), 0.085, 0)
        if curve := FACE_BROWS.get(mood):
            _stroke(pen, [(side * u, v) for u, v in curve], 0.075)
    if mood == "surprised":
        _disc(pen, (0, -0.5), 0.24, flat=1.25)
        return
    up, wide = FACE_MOUTHS[mood]
    arc = [k / 6 for k in range(-6, 7)]
    _stroke(pen, [(wide * t, -0.5 + up * (t * t - 0.5)) for t in arc], 0.075)


FACE_BROWS: dict[Mood, tuple[At, At]] = {
    "angry": ((0.34, 0.6), (0.95, 0.88)),
    "sad": ((0.36, 0.92), (0.95, 0.68)),
}
# How much higher the ends are than the middle, and half the width.
FACE_MOUTHS: dict[Mood, tuple[float, float]] = {
    "happy": (0.26, 0.52),
    "sad": (-0.25, 0.38),
    "angry": (-0.25, 0.38),
    "sleepy": (0.1, 0.36),
}
SHAPES: dict[str, Callable[[Pen], None]] = {
    "heart": _heart,
    "star": _star,
    "smiley": _smiley,
    "skull": _skull,
    "skull and crossbones": _crossbones,
    "flame": _flame,
    "lightning bolt": _bolt,
    "cross": _cross,
    "peace sign": _peace,
    "radiation sign": _radiation,
    "check mark": _check,
    "music note": _note,
    "paw print": _paw,
    "moon": _moon,
    "sun": _sun,
    "flower": _flower,
    "snowflake": _snowflake,
    "arrow": _arrow,
    "crown": _crown,
    "anchor": _anchor,
    "leaf": _leaf,
    "maple leaf": _maple,
    "ring": _ring,
    **{f"{mood} face": partial(_face, mood=mood) for mood in MOODS},
    "diamond": lambda pen: _polygon(pen, [(0, 1), (0.7, 0), (0, -1), (-0.7, 0)]),
    "circle": lambda pen: _disc(pen, (0, 0), 0.9),
    "square": lambda pen: _polygon(pen, [(-0.8, -0.8), (0.8, -0.8), (0.8, 0.8), (-0.8, 0.8)]),
    "triangle": lambda pen: _polygon(pen, _around(3, 1.0)),
}
