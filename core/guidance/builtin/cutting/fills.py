"""The look of a thing's inside, where it is cut."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.cutting.places import HOLLOW, Extent
from core.guidance.builtin.substances import CLASS_OF, METAL, ROUGHNESS
from core.guidance.builtin.words.tables.colors import Color

WHITE = (1.0, 1.0, 1.0)
FACE_WAY = (0.5, -0.866, 0.0)  # towards which a halved fruit's face looks

# How far inside a part points are, and the points themselves; positive in the fill.
Margin = Callable[[Float[Tensor, "n 3"], Float[Tensor, " n"]], Float[Tensor, " n"]]


@dataclass(frozen=True)
class Fill:
    """One colour inside a part."""

    color: Color  # sRGB
    kind: str  # one of core.texture.detail.kinds
    margin: Margin | None = None  # None: all of it


def mixed(color: Color, other: Color, much: float) -> Color:
    """``color`` with so much of another one."""
    r, g, b = ((1 - much) * x + much * y for x, y in zip(color, other, strict=True))
    return r, g, b


def rgb(text: str) -> Color:
    """From hexadecimal digits."""
    r, g, b = (int(text[k : k + 2], 16) / 255 for k in (0, 2, 4))
    return r, g, b


PALE_WOOD, CREAM_FLESH, CRUMB, SPONGE = map(rgb, ("dfb583", "fdf8e4", "f2dca8", "efcf8e"))
FROSTING = rgb("fbf1e2")
SEED = rgb("4a2a16")
# By the kind of a part: the kind of its inside, its colour, and how much of that is mixed in.
OF_KIND: dict[str, tuple[str, Color, float]] = {
    "wooden": ("wooden", PALE_WOOD, 0.75),
    "bark": ("wooden", PALE_WOOD, 0.85),
    "ceramic": ("clay", rgb("f0e6d6"), 0.8),
    "clay": ("clay", rgb("e9b08c"), 0.55),
    "stone": ("stone", WHITE, 0.14),
    "marble": ("stone", WHITE, 0.3),
    "masonry": ("stone", WHITE, 0.1),
    "brick": ("brick", WHITE, 0.1),
    "concrete": ("stone", WHITE, 0.1),
    "peel": ("flesh", CREAM_FLESH, 0.9),
    "crust": ("crumb", CRUMB, 0.85),
    "crumb": ("crumb", WHITE, 0.12),
    "leaf": ("flesh", rgb("c9dda0"), 0.6),
}
AS_IT_IS = {"cream", "flesh", "glass", "plastic", "rubber", "liquid", "bone", "leather", "fabric"}
PAINTED_WOOD = {"fence", "pencil", "signpost", "mask", "rowboat", "pawn", "tower"}


def of_nature(noun: str, kind: str, color: Color) -> Fill:
    """The inside of a part by its outside's kind and colour."""
    if kind in OF_KIND:
        inner, other, much = OF_KIND[kind]
        return Fill(mixed(color, other, much), inner)
    if CLASS_OF.get(kind) == METAL:
        return Fill(mixed(color, (0.78, 0.79, 0.81), 0.4), "metal")
    if kind in AS_IT_IS:
        return Fill(color, kind)
    if noun in PAINTED_WOOD:
        return Fill(PALE_WOOD, "wooden")
    return Fill(mixed(color, WHITE, 0.15), kind if kind in ROUGHNESS else "stone")


def below_ellipsoid(fills: list[Fill], box: Extent) -> list[Fill]:
    """The fills of a fruit that is one with another: at their depths below the ellipsoid in its
    box."""
    middle, half = torch.from_numpy(box.middle), torch.from_numpy(box.half)

    def below(points: Tensor) -> Tensor:
        off = (points - middle.to(points)) / half.to(points)
        return (1 - off.norm(dim=1)) * float(half.min())

    def moved(margin: Margin) -> Margin:
        return lambda points, _: margin(points, below(points))

    return [replace(one, margin=one.margin and moved(one.margin)) for one in fills]


def within(low: float, high: float) -> Margin:
    """Between two depths below a part's surface, training units."""
    return lambda _, depth: torch.minimum(depth - low, high - depth)


def _local(points: Float[Tensor, "n 3"], box: Extent, normal: tuple[float, ...]) -> Tensor:
    """Points in the plane of a cut face, in half sizes of the box: to the right, and up."""
    x, y, z = normal
    long = math.hypot(x, y)
    across = torch.tensor([-y / long, x / long, 0.0]).to(points)
    along = torch.tensor([x, y, z]).to(points)
    along = along / along.norm()
    up = torch.linalg.cross(along, across)
    middle, half = (torch.from_numpy(one).to(points) for one in (box.middle, box.half))
    off = points - middle
    sizes = [(half * way.abs()).norm() for way in (across, up)]
    return torch.stack([off @ across / sizes[0], off @ up / sizes[1]], 1)


def citrus(skin: Color, flesh: Color, box: Extent, normal: tuple[float, ...]) -> list[Fill]:
    """Skin, white pith, segments with white between them."""
    pith, size = rgb("fbf3dc"), float(box.half.min())
    rim, wall, core, count = 0.1 * size, 0.022 * size, 0.09 * size, 10

    def segments(points: Tensor, depth: Tensor) -> Tensor:
        flat = _local(points, box, normal) * size
        far = flat.norm(dim=1)
        angle = torch.atan2(flat[:, 1], flat[:, 0]) * count / (2 * math.pi)
        off = (angle - angle.round()).abs()  # 0 in the middle of a segment, half a turn at a wall
        between = (0.5 - off) * (2 * math.pi / count) * far - wall
        return torch.stack([between, far - core, depth - rim]).amin(0)

    return [
        Fill(pith, "flesh"),
        Fill(skin, "peel", within(-1.0, 0.028 * size)),
        Fill(flesh, "flesh", segments),
    ]


def dots(places: list[tuple[float, float]], radius: float, long: float, box: Extent) -> Margin:
    """Seeds on a face towards the front: ellipses at places in half sizes of the box."""

    def at(points: Tensor, _depth: Tensor) -> Tensor:
        flat = _local(points, box, FACE_WAY)
        each = [radius - torch.hypot(flat[:, 0] - x, (flat[:, 1] - y) / long) for x, y in places]
        return torch.stack(each).amax(0) * float(box.half.min())

    return at


def of_pome(box: Extent) -> list[Fill]:
    """An apple's and a pear's core with its seeds."""
    low = -0.1
    core = dots([(-0.1, low), (0.1, low)], 0.15, 1.7, box)
    seeds = dots([(-0.13, low), (0.13, low)], 0.055, 1.9, box)
    return [
        Fill(CREAM_FLESH, "flesh"),
        Fill(mixed(CREAM_FLESH, rgb("d9c27c"), 0.6), "flesh", core),
        Fill(SEED, "peel", seeds),
    ]


def of_watermelon(box: Extent, normal: tuple[float, ...]) -> list[Fill]:
    """Rind, a white rim, red flesh, rings of seeds."""
    size = float(box.half.min())
    rings = [(0.42, 8, 0.0), (0.66, 13, 0.2)]
    places = [
        (
            far * math.cos(2 * math.pi * (k + turn) / count),
            far * math.sin(2 * math.pi * (k + turn) / count),
        )
        for far, count, turn in rings
        for k in range(count)
    ]

    def seeds(points: Tensor, _depth: Tensor) -> Tensor:
        flat = _local(points, box, normal)
        x, y = (flat[:, k, None] - torch.tensor([p[k] for p in places]).to(points) for k in (0, 1))
        return (0.038 - torch.hypot(x, y * 1.2).amin(1)) * size

    return [
        Fill(rgb("e2343f"), "flesh"),
        Fill(rgb("2f7d36"), "peel", within(-1.0, 0.03 * size)),
        Fill(rgb("dfeec4"), "flesh", within(0.03 * size, 0.14 * size)),
        Fill(rgb("1c1512"), "peel", lambda p, d: torch.minimum(seeds(p, d), d - 0.2 * size)),
    ]


def of_cake(color: Color, box: Extent) -> list[Fill]:
    """Sponge in layers with cream between them."""
    low, high = float(box.low[2]), float(box.high[2])
    levels = [low + (high - low) * part for part in (0.3, 0.58)]
    thick = 0.026 * (high - low)

    def cream(points: Tensor, _depth: Tensor) -> Tensor:
        return torch.stack([thick - (points[:, 2] - z).abs() for z in levels]).amax(0)

    return [Fill(mixed(color, SPONGE, 0.35), "crumb"), Fill(FROSTING, "cream", cream)]


def of_egg(shell: Color, box: Extent) -> list[Fill]:
    """A white skin, and on its level the white with the yolk."""
    level = float(box.low[2] + HOLLOW["egg"][1] * 2 * box.half[2])
    wide = float(box.half[0])
    middle = torch.from_numpy(box.middle)

    def around(points: Tensor) -> Tensor:
        return (points - middle.to(points))[:, :2].norm(dim=1)

    def on_level(points: Tensor) -> Tensor:
        return 0.03 - (points[:, 2] - level).abs()

    return [
        Fill(mixed(shell, WHITE, 0.7), "bone"),
        Fill(
            rgb("f3ead0"),
            "liquid",
            lambda p, _: torch.minimum(on_level(p), 0.82 * wide - around(p)),
        ),
        Fill(
            rgb("f5a91c"),
            "liquid",
            lambda p, _: torch.minimum(on_level(p), 0.42 * wide - around(p)),
        ),
    ]


def ring_inside(outer: Fill, inner: Fill, deep: float) -> list[Fill]:
    """A rim of one look around another."""
    return [inner, Fill(outer.color, outer.kind, within(-1.0, deep))]


def stone_in(box: Extent, color: Color) -> list[Fill]:
    """A peach's stone in its flesh."""
    stone = dots([(0.0, -0.02)], 0.34, 1.2, box)
    return [Fill(color, "flesh"), Fill(rgb("8a5a34"), "bark", stone)]


def fills_of(
    noun: str, part: str, kind: str, color: Color, box: Extent, normal: tuple[float, ...]
) -> list[Fill]:
    """The looks inside one part of a thing, the first one everywhere where no other one is."""
    if part in ("body", "rind"):
        if noun == "lemon":
            return citrus(color, rgb("f7e27a"), box, normal)
        if noun == "orange fruit":
            return below_ellipsoid(citrus(color, rgb("f59a2e"), box, normal), box)
        if noun in ("apple", "pear"):
            return of_pome(box)
        if noun == "peach":
            return stone_in(box, rgb("f7c878"))
        if noun == "watermelon":
            return below_ellipsoid(of_watermelon(box, normal), box)
        if noun == "cake":
            return of_cake(color, box)
        if noun == "strawberry":
            return ring_inside(Fill(color, "flesh"), Fill(rgb("f6b8ae"), "flesh"), 0.22)
        if noun == "tomato":
            return ring_inside(Fill(color, "flesh"), Fill(rgb("ec6a4c"), "flesh"), 0.1)
        if noun == "pumpkin":
            return ring_inside(Fill(rgb("f3a640"), "flesh"), Fill(rgb("e08a2a"), "crumb"), 0.16)
    if noun == "egg":
        return of_egg(color, box)
    if noun == "hamburger" and part == "patty":
        return [Fill(mixed(color, rgb("8a4a35"), 0.5), "crumb")]
    return [of_nature(noun, kind, color)]
