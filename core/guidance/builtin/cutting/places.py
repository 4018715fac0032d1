"""Where a thing is bitten, cut or broken: towards a camera that sees it from the front right."""

import math
import zlib
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import torch

from core.geometry.parts.assembly import KnownParts
from core.geometry.tools import (
    Tool,
    Vector,
    beyond,
    both,
    capsule,
    frame_across,
    joined,
    larger,
    outside,
    rough,
)
from core.guidance.builtin.words.phrases.cuts import CutWord

# Degrees around the vertical, counter-clockwise from the front: of a bite, of one in what is
# flat, of a bitten-off half, of a cut face, of a slice's middle.
BITE_AT, RIM_AT, EATEN_AT, FACE_AT, SLICE_AT = 90.0, 66.0, 55.0, 30.0, 26.0
ALONE_AT = -65.0  # of a slice alone: one of its cut faces is in front
FLAT = 0.82  # thickness to width, at most, of what is bitten through
# Of half the width: a bite's radius, its teeth's, how far in its middle is.
BITE, TEETH, DEEP = 0.56, 0.17, 0.02
TEETH_OF = 9  # around a bite
# Of half the width, where a half is bitten off: a tooth's radius, and that of the whole bite.
HALF_TEETH, ROUND = 0.2, 1.1
EATEN = 0.1  # of half the width: how much less than a half is left
SLICE = 42.0  # degrees
TILT = 1.5  # of the face of half a fruit that lies, upwards: the z of its normal
SLENDER = 1.55  # length to width, at least, of what is broken across
# Of the length, what is left: of what is slender, and of what is not, and of a building.
LEFT, STOUT_LEFT, RUIN_LEFT, STATUE_LEFT = 0.62, 0.62, 0.68, 0.74
# Things with an empty inside: a wall's fraction of the radius, and from which height on, of the
# whole. An egg is closed above, and its white fills it up to there.
HOLLOW = {
    "vase": (0.13, 0.05),
    "jug": (0.13, 0.05),
    "bottle": (0.13, 0.05),
    "barrel": (0.12, 0.05),
    "tower": (0.3, 0.42),
    "lighthouse": (0.3, 0.4),
    "egg": (0.07, 0.36),
    "easter egg": (0.07, 0.05),
    "piggy bank": (0.1, 0.05),
    "planet": (0.1, 0.05),
    "christmas bauble": (0.05, 0.05),
}
EGGS = "egg", "easter egg", "piggy bank", "planet", "christmas bauble"
UPRIGHT = "fence", "wall", "gate", "ladder"  # each of their uprights breaks by itself
REACH = 1.6  # training units from the middle, of a rough surface
STALKS = "stalk", "leaf", "stem"
# Parts that are not cut with the rest.
SPARED = {
    "apple": STALKS,
    "pear": STALKS,
    "peach": STALKS,
    "strawberry": ("leaves",),
    "tomato": ("leaves", "stalk"),
    "pumpkin": STALKS,
    "cake": ("plate",),
    "pie": ("dish", "bands", "flutes"),
}
# Parts that are whole or missing.
BRITTLE = frozenset(
    """candles flames topping cherry berries windows frames door stalk leaf leaves nails pegs
    sprinkles strands drops eyes""".split()
)
# Drawn with a half or a slice before them: the part that is the whole fruit.
PAIRS = {"orange fruit": "body", "watermelon": "rind"}
AROUND = 1.03  # times as large as that fruit: what is kept
# The directions of the normals of cut faces that are across a long axis.
ACROSS = {"lemon": (0.8, -0.55, 0.25), "bread": (0.1, -1.0, 0.0)}
# Of the width across the break: a coarse and a fine roughness's spacing, and their heights.
GRAINS: dict[str, tuple[tuple[float, float], tuple[float, float]]] = {
    "wooden": ((0.3, 0.3), (0.11, 0.3)),
    "metal": ((0.5, 0.16), (0.12, 0.03)),
    "ceramic": ((0.34, 0.16), (0.1, 0.012)),
    "stone": ((0.3, 0.13), (0.08, 0.035)),
}
RUBBLE = ((0.28, 0.22), (0.06, 0.03))  # of a building's whole width


class Extent(NamedTuple):
    """The box around what is cut."""

    low: Vector
    high: Vector

    @property
    def middle(self) -> Vector:
        """Its middle."""
        return (self.low + self.high) / 2

    @property
    def half(self) -> Vector:
        """Half of its sides."""
        return (self.high - self.low) / 2


def tool_of(
    cut: CutWord,
    noun: str,
    parts: KnownParts,
    names: Sequence[str],
    grain: str,
    is_statue: bool = False,
) -> Tool:
    """What is cut off a thing, or out of it.

    Args:
        names: of its parts.
        grain: of a break: one of ``GRAINS``.
    """
    box = extent_of(noun, parts, names)
    if cut == "bitten":
        return bite(box, parts)
    if cut == "half-eaten":
        return half_eaten(box)
    if cut == "halved":
        return half(noun, box)
    if cut == "slice missing":
        return slice_of(box)
    if cut == "slice":
        return all_but_slice(box)
    off = ruin(noun, box) if cut == "ruined" else broken(noun, box, grain, parts, is_statue)
    return joined([off, hollow(noun, box, parts)]) if noun in HOLLOW else off


def hollow(noun: str, box: Extent, parts: KnownParts) -> Tool:
    """What is inside a thing's largest part, within its wall."""
    wall, from_below = HOLLOW[noun]
    sizes = [float(np.prod(size)) for size in parts.extents()]
    part = int(np.argmax(sizes))
    index = max(
        (k for k, one in enumerate(parts.components) if one.place.part == part),
        key=lambda k: float(np.prod(np.ptp(parts.surface_of(k)[0].numpy(), axis=0))),
    )
    closed = noun in EGGS
    center = box.middle.copy()
    scale = np.array([1 - wall, 1 - wall, 1 - wall if closed else 1.0])
    if not closed:
        center[2] = box.low[2]
    shift = np.zeros(3) if closed else np.array([0.0, 0.0, from_below * 2 * box.half[2]])
    inner = larger(parts.surface_of(index), lambda p: parts.near(p)[:, part], center, scale, shift)
    if not closed:
        return inner
    level = float(box.low[2] + from_below * 2 * box.half[2])
    return both([inner, beyond(np.array([0.0, 0.0, 1.0]), level)])


def extent_of(noun: str, parts: KnownParts, names: Sequence[str]) -> Extent:
    """The box around all parts that are cut; of a pair the one around the whole fruit."""
    small = {*BRITTLE, *STALKS, *SPARED.get(noun, ())}
    surfaces = [
        parts.surface_of(index)[0]
        for index, component in enumerate(parts.components)
        if names[component.place.part] not in small
    ]
    verts = torch.cat(surfaces or [parts.surface_of(0)[0]]).double()
    low, high = verts.amin(0).numpy(), verts.amax(0).numpy()
    if noun in PAIRS:  # it is behind the other, and higher
        half = (high - low) / 2
        low[1:] = high[1:] - 2 * min(half[0], half[2])
    return Extent(low, high)


def way(around_deg: float, up: float = 0.0) -> Vector:
    """The direction at an angle around the vertical from the front, its z before it has length
    1."""
    angle = math.radians(around_deg)
    found = np.array([math.sin(angle), -math.cos(angle), up])
    return found / np.linalg.norm(found)


def bite(box: Extent, parts: KnownParts) -> Tool:
    """One bite at the rim: a ball with a ring of teeth; through what is flat, all the way."""
    thin = int(box.half.argmin())
    wide = float(np.delete(box.half, thin).min())
    if box.half[thin] > FLAT * box.half.max():  # as thick as wide
        out = way(BITE_AT, 0.12)
        at = _rim(parts, box.middle, out)
        across, up = np.array([-out[1], out[0], 0.0]), np.array([0.0, 0.0, 1.0])
        radius = BITE * wide
        start = at + DEEP * wide * out
        balls = [capsule(start, start, radius)]
        for side in (-1, 0, 1):
            for row in (-1, 1):
                tooth = start - (0.42 - 0.2 * abs(side)) * radius * out
                tooth = tooth + radius * (0.6 * side * across + (0.72 - 0.2 * abs(side)) * row * up)
                balls.append(capsule(tooth, tooth, 0.4 * radius))
        return joined(balls)
    out = way(RIM_AT) if thin == 2 else np.array([0.72, 0.0, 0.69])
    at = _rim(parts, box.middle, out)
    along = np.eye(3)[thin]
    through = (box.half[thin] + 0.1) * along
    across = np.cross(along, out)
    radius, tooth = BITE * wide, TEETH * wide
    start = at + DEEP * wide * out
    middle = start + (box.middle - start) @ along * along
    cylinders = [capsule(middle - through, middle + through, radius)]
    for index in range(TEETH_OF):
        angle = math.pi * (index / (TEETH_OF - 1) - 0.5) * 1.15
        tip = middle + radius * (math.sin(angle) * across - math.cos(angle) * out)
        cylinders.append(capsule(tip - through, tip + through, tooth))
    return joined(cylinders)


def _rim(parts: KnownParts, middle: Vector, out: Vector) -> Vector:
    """Where a thing ends in a direction from its middle."""
    far = torch.linspace(0, 1.2, 240)
    ray = torch.from_numpy(middle).float() + far[:, None] * torch.from_numpy(out).float()
    inside = (parts.distances(ray)[:, : len(parts.forms.flat)].amin(1) < 0).nonzero()
    return middle + float(far[inside.max()] if len(inside) else 0.5) * out


def half_eaten(box: Extent) -> Tool:
    """One side bitten off along a row of teeth."""
    thin = int(box.half.argmin())
    is_flat = box.half[thin] <= FLAT * box.half.max()
    out = np.array([0.72, 0.0, 0.69]) if is_flat and thin == 1 else way(EATEN_AT, 0.0)
    along = np.eye(3)[thin if is_flat else 2]
    wide = float(np.delete(box.half, thin).max())
    across = np.cross(along, out)
    through = (box.half @ np.abs(along) + 0.1) * along
    tooth, round_ = HALF_TEETH * wide, ROUND * wide
    center = box.middle + (EATEN * wide + round_) * out
    tools = [capsule(center - through, center + through, round_)]
    step = 1.4 * tooth / round_
    for index in range(-5, 6):
        way_in = math.cos(index * step) * out - math.sin(index * step) * across
        at = center - round_ * way_in
        tools.append(capsule(at - through, at + through, tooth))
    far = float((box.middle + 0.75 * wide * out) @ out)
    return joined([*tools, beyond(out, far)])


def half(noun: str, box: Extent) -> Tool:
    """The front half; of a pair all but the rear half of the whole fruit."""
    normal = np.array(ACROSS.get(noun, way(FACE_AT)))
    if noun in PAIRS:
        normal = way(FACE_AT, TILT)
    normal = normal / np.linalg.norm(normal)
    front = beyond(normal, float(box.middle @ normal))
    if noun not in PAIRS:
        return front
    return joined([front, outside(box.middle, box.half * AROUND)])


def slice_of(box: Extent) -> Tool:
    """A slice from the middle to the rim."""
    return both([beyond(*side) for side in _sides(box, SLICE_AT)])


def all_but_slice(box: Extent) -> Tool:
    """All but one slice."""
    return joined([beyond(-normal, -offset) for normal, offset in _sides(box, ALONE_AT)])


def _sides(box: Extent, around_deg: float) -> list[tuple[Vector, float]]:
    """The planes at both sides of a slice and at its tip, facing into it."""
    ways = [way(around_deg + turn * (90 - SLICE / 2)) for turn in (-1, 1)]
    return [(inward, float(inward @ box.middle)) for inward in (*ways, way(around_deg))]


def noise(spacing: float, height: float, seed: int, reach: float, nodes: int) -> np.ndarray:
    """Random heights at the nodes of a lattice, linear between those of a coarser one."""
    count = max(2, math.ceil(2 * reach / spacing) + 1)
    coarse = np.random.default_rng(seed).uniform(-1, 1, (1, 1, count, count))
    fine = torch.nn.functional.interpolate(
        torch.from_numpy(coarse), (nodes, nodes), mode="bilinear", align_corners=True
    )
    return height * fine[0, 0].numpy()


def rough_plane(
    noun: str, normal: Vector, at: Vector, grains: Sequence[tuple[float, float]]
) -> Tool:
    """What is beyond a plane through ``at`` with a rough surface; ``grains``: spacings and
    heights, the coarse one first."""
    seed = zlib.crc32(noun.encode())
    reach = min(REACH, 40 * grains[-1][0])
    nodes = max(2, math.ceil(2 * reach / grains[-1][0]) + 1)
    each = [noise(*grain, seed + k, reach, nodes) for k, grain in enumerate(grains)]
    heights, offset = np.sum(each, 0), float(at @ normal)
    across = frame_across(normal)
    # The lattice is around ``at``.
    shift = [float(at @ one) for one in across]
    return rough(normal, offset, heights, reach, shift)


def broken(noun: str, box: Extent, grain: str, parts: KnownParts, is_statue: bool) -> Tool:
    """The upper end of what is long, a corner of what is not."""
    axis = int(box.half.argmax())
    others = np.delete(box.half, axis)
    coarse, fine = GRAINS[grain]
    if noun in UPRIGHT:
        normal = way(90, 3.0)
        at = box.middle.copy()
        at[2] += (2 * RUIN_LEFT - 1) * box.half[2]
        wide, high = float(box.half[0]), float(box.half[2])
        fine_of = 0.06 if grain == "wooden" else 0.12
        return rough_plane(noun, normal, at, [(0.34 * wide, 0.3 * high), (fine_of, fine_of)])
    if noun == "bust" or is_statue:
        normal = way(FACE_AT + 62, 0.75)
        at = box.middle + np.array([0.2, 0.0, 2 * STATUE_LEFT - 1]) * box.half
        wide = float(2 * others.min())
    elif box.half[axis] > SLENDER * others.max():
        normal = 0.28 * way(SLICE_AT) + np.eye(3)[axis] * (-1 if axis == 1 else 1)
        normal = normal / np.linalg.norm(normal)
        at = box.middle.copy()
        at[axis] += (2 * LEFT - 1) * box.half[axis]
        wide = _width(parts, at, axis)
    else:
        normal = way(FACE_AT + 15, 1.3) if noun in HOLLOW else way(FACE_AT + 45, 1.15)
        at = box.middle.copy()
        at[2] += (2 * STOUT_LEFT - 1) * box.half[2]
        at[:2] += 0.12 * float(others.min()) * normal[:2]
        wide = float(2 * box.half.min())
    grains = [(coarse[0] * wide, coarse[1] * wide), (fine[0] * wide, fine[1] * wide)]
    return rough_plane(noun, normal, at, grains)


def _width(parts: KnownParts, at: Vector, axis: int) -> float:
    """About how wide a thing is across an axis at a place."""
    found = []
    for index in range(len(parts.components)):
        verts, faces = parts.surface_of(index)
        along = verts[:, axis][faces]
        cut = faces[(along.amin(1) < at[axis]) & (along.amax(1) > at[axis])]
        if len(cut):
            ends = verts[cut.unique()]
            found.append((ends.amax(0) - ends.amin(0)).numpy())
    if not found:
        return 0.1
    return float(max(np.delete(size, axis).max() for size in found))


def ruin(noun: str, box: Extent) -> Tool:
    """The upper end of a building, at another height everywhere."""
    wide = float(2 * box.half[:2].max())
    normal = way(FACE_AT + 20, 2.6)
    at = box.middle.copy()
    at[2] += (2 * RUIN_LEFT - 1) * box.half[2]
    return rough_plane(noun, normal, at, [(x * wide, y * wide) for x, y in RUBBLE])
