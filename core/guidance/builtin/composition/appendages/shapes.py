"""The shapes of appendages, by noun: each part's solids on a mount.

Outlines of wings are in units of the wing's length, from its root outwards and up; what grows on a
head is in units of its width, a tail in units of the body's size.
"""

import itertools
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from core.geometry.parts.pipes import Pipe, packed_pipes
from core.geometry.parts.primitives import Loop, Primitive, packed
from core.guidance.builtin.composition.appendages.mount import Mount, Point
from core.guidance.builtin.constructed.shapes import Parts, closed_curve, curve, turning

Frame = Float[np.ndarray, "3 3"]  # its columns are a plate's axes

# Of a body's size: a wing's length upright, on all fours, and of a thing; a butterfly's.
LENGTH, LENGTH_ON_FOURS, LENGTH_OF_THING, BUTTERFLY = 0.62, 0.52, 0.5, 0.85
# Directions of the right wing's length and of its height.
RAISED = np.array([[0.84, 0.30, 0.45], [-0.45, 0.05, 0.88]])
SPREAD = np.array([[0.93, 0.32, 0.12], [-0.1, 0.05, 1.0]])
FOLDED_BACK = np.array([[0.62, 0.30, 0.72], [0.0, -1.0, 0.25]])
# A feathered wing: the bones that its feathers begin at, and where the longest end.
BONES = ((0.0, 0.05), (0.16, 0.32), (0.38, 0.46), (0.66, 0.44))
TIPS = ((0.1, -0.4), (0.34, -0.46), (0.62, -0.38), (0.88, -0.12), (1.03, 0.3))
# Rows of feathers: how far they reach of the way to the tips, their number, half their width and
# their thickness.
FEATHERS = ((1.0, 9, 0.075, 0.016), (0.64, 8, 0.075, 0.03), (0.34, 7, 0.08, 0.044))
OVERLAP = 0.006  # every other feather is so much thicker, which shows where it ends
ROUNDED = 0.3  # of a feather's length, its end
MEMBRANE, FINGER, ARM = 0.016, 0.02, 0.034
ROOT, WRIST = (0.0, 0.06), (0.4, 0.5)
FINGERS = ((1.0, 0.34), (0.93, -0.22), (0.64, -0.46), (0.3, -0.44))
ARMPIT = (0.0, -0.22)
HANGS = 0.4  # of the way to the wrist, a membrane between two fingers
UPPER = (
    (0.0, 0.02),
    (0.16, 0.4),
    (0.42, 0.72),
    (0.66, 0.78),
    (0.74, 0.56),
    (0.56, 0.2),
    (0.2, 0.0),
)
LOWER = (
    (0.0, 0.02),
    (0.24, 0.06),
    (0.5, -0.04),
    (0.6, -0.26),
    (0.46, -0.5),
    (0.24, -0.5),
    (0.06, -0.2),
)
INSET, RAISED_BY, LOBE = 0.76, 1.35, 0.018
# Curves: x outwards, y to the rear, z up, and the radius.
UPWARD = (
    (0, 0, 0, 0.11),
    (0.15, 0, 0.17, 0.09),
    (0.21, -0.03, 0.38, 0.055),
    (0.12, -0.08, 0.6, 0.012),
)
OUTWARD = (
    (0, 0, 0, 0.12),
    (0.24, 0, 0.08, 0.1),
    (0.42, -0.05, 0.26, 0.065),
    (0.42, -0.1, 0.52, 0.014),
)
BEAM = (
    (0, 0, 0, 0.065),
    (0.2, 0.08, 0.26, 0.055),
    (0.44, 0.12, 0.54, 0.045),
    (0.46, 0.04, 0.92, 0.014),
)
TINES = (
    ((0.14, 0.06, 0.18, 0.045), (0.2, -0.12, 0.34, 0.034), (0.17, -0.18, 0.5, 0.012)),
    ((0.33, 0.11, 0.41, 0.045), (0.22, 0.0, 0.62, 0.034), (0.2, -0.04, 0.8, 0.012)),
    ((0.44, 0.12, 0.54, 0.042), (0.64, 0.06, 0.68, 0.032), (0.74, 0.0, 0.88, 0.012)),
)
APART = 0.26  # of the head's width, from its middle: horns, antlers
CURL, CURLED, CURL_OUT = 0.3, 1.3 * np.pi, 0.36  # a ram's horn: its radius, its turn
IN_HEAD = 0.06  # of its width
POINTED, POINT = 0.8, 0.1  # a unicorn's horn: its length, its radius
TWISTS, TWIST = 4, 0.022
HALO, TUBE, HOVERS, POST = 0.46, 0.05, 0.26, 0.024
EAR = (
    (-0.5, 0),
    (-0.47, 0.3),
    (-0.3, 0.72),
    (-0.07, 1),
    (0.07, 1),
    (0.3, 0.72),
    (0.47, 0.3),
    (0.5, 0),
)
LONG_EAR = (
    (0.0, -0.02),
    (0.38, 0.14),
    (0.5, 0.5),
    (0.36, 0.84),
    (0, 1),
    (-0.36, 0.84),
    (-0.5, 0.5),
    (-0.38, 0.14),
)
EAR_THICK, INNER, INNER_OUT = 0.05, 0.62, 0.018
CAT_TAIL = (
    (0, -0.02, 0, 0.032),
    (0, 0.1, 0.0, 0.03),
    (0, 0.2, 0.1, 0.028),
    (0, 0.22, 0.26, 0.026),
    (0, 0.16, 0.38, 0.022),
)
FOX_TAIL = (
    (0, -0.02, 0, 0.03),
    (0, 0.1, 0.02, 0.055),
    (0, 0.22, 0.1, 0.085),
    (0, 0.28, 0.24, 0.09),
    (0, 0.27, 0.32, 0.075),
)
FOX_TIP = ((0, 0.275, 0.3, 0.074), (0, 0.27, 0.37, 0.055), (0, 0.25, 0.45, 0.012))
DEVIL_TAIL = (
    (0, -0.02, 0, 0.022),
    (0, 0.12, -0.06, 0.018),
    (0, 0.24, 0.02, 0.016),
    (0, 0.26, 0.2, 0.014),
)
SPADE = ((0.0, -0.03), (0.075, -0.02), (0.045, 0.05), (0.0, 0.13), (-0.045, 0.05), (-0.075, -0.02))
SPADE_THICK = 0.014
# What holds them together by themselves, in units of a head's width.
_ARCH = np.linspace(-0.1, 1.1, 9) * np.pi
_BAR = tuple((x, 0.0, 0.4, 0.05) for x in (-APART, APART))
BANDS = {
    "ears": tuple((0.47 * np.cos(a), 0.0, 0.47 * np.sin(a), 0.035) for a in _ARCH),
    "horns": _BAR,
    "antlers": _BAR,
    "wings": ((-0.12, 0.0, 0.0, 0.05), (0.12, 0.0, 0.0, 0.05)),
}


def _feathered(mount: Mount) -> Parts:
    length = _length(mount)
    parts: Parts = {"wings": [], "coverts": []}
    for frame in _frames(mount, RAISED):
        for reach, count, wide, half in FEATHERS:
            loops = _feathers(reach, count, wide)
            each = [(half + OVERLAP * (k % 2), loop) for k, loop in enumerate(loops)]
            parts["coverts" if reach < 0.5 else "wings"].append(_plates(frame, each, length))
        arm = [(x, y, 0, 0.05 - 0.03 * x) for x, y in BONES]
        parts["coverts"].append(_pipe(frame, arm, length))
    return parts


def _feathers(reach: float, count: int, wide: float) -> Iterator[Loop]:
    """The outlines of a row of feathers, from the body outwards."""
    bones, tips = curve(BONES), curve(TIPS)
    t = np.linspace(0, 1, 15)
    round_end = np.sqrt(1 - ((t - 1 + ROUNDED) / ROUNDED).clip(0) ** 2)
    half = wide * round_end * (0.6 + 0.4 * (t / 0.5).clip(max=1))
    for s in np.linspace(0, 1, count):
        (start,), (end,) = _at(bones, np.array([s])), _at(tips, np.array([s]))
        along = reach * (end - start)
        across = np.array([-along[1], along[0]]) / np.linalg.norm(along)
        middle = start + t[:, None] * along
        yield np.concatenate(
            [middle - half[:, None] * across, (middle + half[:, None] * across)[-2::-1]]
        )


def _leathery(mount: Mount) -> Parts:
    length = _length(mount)
    wings, arms = [], []
    for frame in _frames(mount, RAISED):
        ends = [*FINGERS, ARMPIT]
        edge = [curve((ROOT, (0.2, 0.34), WRIST)), curve((WRIST, (0.75, 0.5), FINGERS[0]))]
        for start, end in itertools.pairwise(ends):
            middle = (np.array(start) + end) / 2
            edge.append(
                curve((start, tuple(middle + HANGS * 0.4 * (np.array(WRIST) - middle)), end))
            )
        loop = np.concatenate([one[:-1] for one in edge] + [np.array([ARMPIT])])[::-1]
        wings.append(_plate(frame, loop, MEMBRANE, length))
        bones = [((*ROOT, ARM), (0.2, 0.36, ARM), (*WRIST, 0.9 * ARM))]
        bones += [((*WRIST, FINGER), (*end, 0.4 * FINGER)) for end in FINGERS]
        bones.append(((*WRIST, FINGER), (0.4, 0.62, 0.3 * FINGER)))  # a claw
        arms += [_pipe(frame, [(x, y, 0, r) for x, y, r in bone], length) for bone in bones]
    return {"wings": wings, "arms": arms}


def _lobed(mount: Mount) -> Parts:
    length = BUTTERFLY * _length(mount)
    wings, edges = [], []
    for frame in _frames(mount, SPREAD):
        for lobe in (UPPER, LOWER):
            loop = closed_curve(lobe)
            middle = loop.mean(0)
            edges.append(_plate(frame, loop, LOBE, length))
            inner = middle + INSET * (loop - middle)
            wings.append(_plate(frame, inner, RAISED_BY * LOBE, length))
    return {"wings": wings, "edges": edges}


def _horned(nodes: Sequence[Sequence[float]]) -> Callable[[Mount], Parts]:
    return lambda mount: {"horns": [*_paired(mount, [nodes])]}


def _curled(mount: Mount) -> Parts:
    t = np.linspace(0, 1, 9)
    angle = 0.5 * np.pi - CURLED * t  # from the top to the rear, down and forward
    grown = CURL * (1 - 0.35 * t)
    y, z = grown * np.cos(angle), grown * np.sin(angle) - CURL
    nodes = np.stack([CURL_OUT * t, y, z, 0.12 - 0.105 * t], 1).tolist()
    return {"horns": [*_paired(mount, [nodes])]}


def _antlered(mount: Mount) -> Parts:
    return {"antlers": [*_paired(mount, [BEAM, *TINES])]}


def _one_horned(mount: Mount) -> Parts:
    wide = mount.wide
    x, y = mount.head[0], mount.head[1] - 0.2 * wide
    way = np.array([0.0, -0.42, 0.91])
    start = np.array([x, y, mount.crown(x, y)]) - IN_HEAD * wide * way
    frame = np.stack([np.array([1.0, 0, 0]), np.cross(way, [1.0, 0, 0]), way], 1)
    half = POINTED / 2 * wide
    turn = Rotation.from_matrix(frame).as_rotvec()
    cone = Primitive("frustum", start + half * way, turn, np.array([half, POINT * wide, 0.0, 0.0]))
    t = np.linspace(0.02, 0.93, 12 * TWISTS)
    angle, radius = TWISTS * 2 * np.pi * t, POINT * (1 - t)
    spiral = np.stack(
        [radius * np.cos(angle), radius * np.sin(angle), POINTED * t, TWIST * (1 - 0.8 * t)], 1
    )
    nodes = [tuple(row) for row in spiral]
    return {"horn": [cone], "twist": [_pipe((start, frame), nodes, wide)]}


def _haloed(mount: Mount) -> Parts:
    wide, (x, y, _) = mount.wide, mount.head
    above = np.array([x, y, mount.top + HOVERS * wide])
    ring = Primitive("ring", above, np.zeros(3), wide * np.array([HALO, TUBE]))
    behind = y + 0.25 * wide
    low = np.array([x, behind, mount.crown(x, behind) - IN_HEAD * wide])
    high = above + np.array([0.0, HALO * wide, 0.0])
    bend = np.array([x, high[1], (low[2] + high[2]) / 2])
    nodes = [(*point, POST * wide) for point in (low, bend, high)]
    return {"halo": [ring, _pipe((np.zeros(3), np.eye(3)), nodes, 1.0)]}


def _eared(
    outline: Loop, wide: float, high: float, apart: float, tilt: float
) -> Callable[[Mount], Parts]:
    shape = outline * (wide, high)
    middle = np.array([0.0, 0.42 * high])
    inner = middle + INNER * (shape - middle)

    def made(mount: Mount) -> Parts:
        ears, within = [], []
        for side in (1, -1):
            x, y = mount.head[0] + side * apart * mount.wide, mount.head[1]
            at = np.array([x, y, mount.crown(x, y) - IN_HEAD * mount.wide])
            sine, cosine = side * np.sin(tilt), np.cos(tilt)
            frame = np.array([[cosine, sine, 0.0], [0.0, 0.0, -1.0], [-sine, cosine, 0.0]])
            ears.append(_plate((at, frame), shape, EAR_THICK, mount.wide))
            depth = EAR_THICK - INNER_OUT, EAR_THICK + INNER_OUT
            within.append(_plate((at, frame), inner, depth, mount.wide))
        return {"ears": ears, "inner": within}

    return made


def _tailed(
    tail: Sequence[Sequence[float]], tip: Sequence[Sequence[float]] = ()
) -> Callable[[Mount], Parts]:
    def made(mount: Mount) -> Parts:
        frame = mount.rump, np.eye(3)
        parts = {"tail": [_pipe(frame, tail, mount.size)]}
        return parts | ({"tip": [_pipe(frame, tip, mount.size)]} if tip else {})

    return made


def _spaded(mount: Mount) -> Parts:
    parts = _tailed(DEVIL_TAIL)(mount)
    end = mount.rump + mount.size * np.array(DEVIL_TAIL[-1][:3])
    upright = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    spade = _plate((end, upright), closed_curve(SPADE), SPADE_THICK, mount.size)
    return {"tail": [*parts["tail"], spade]}


def _length(mount: Mount) -> float:
    """A wing's."""
    by = LENGTH_OF_THING if mount.sideways else LENGTH if mount.stands else LENGTH_ON_FOURS
    return by * mount.size


def _frames(mount: Mount, upright: Float[np.ndarray, "2 3"]) -> Iterator[tuple[Point, Frame]]:
    """The root and the axes of the right and of the left wing."""
    along, up = upright if mount.stands or mount.sideways else FOLDED_BACK
    along = along / np.linalg.norm(along)
    up = up - (up @ along) * along
    up = up / np.linalg.norm(up)
    for side in (1.0, -1.0):
        mirror = np.array([side, 1.0, 1.0])
        u, v = along * mirror, up * mirror
        off = mount.shoulder - (mount.head[0], 0, 0)
        at = off * mirror + (mount.head[0], 0, 0)
        yield at, np.stack([u, v, np.cross(u, v)], 1)


def _paired(mount: Mount, curves: Sequence[Sequence[Sequence[float]]]) -> Iterator[Primitive]:
    """Curves on both sides of the head."""
    for side in (1, -1):
        x, y = mount.head[0] + side * APART * mount.wide, mount.head[1]
        at = np.array([x, y, mount.crown(x, y) - IN_HEAD * mount.wide])
        each = [[(side * a, b, c, r) for a, b, c, r in nodes] for nodes in curves]
        pipes = [Pipe(_scaled(nodes, at, mount.wide)) for nodes in each]
        yield Primitive("pipes", np.zeros(3), np.zeros(3), packed_pipes(pipes))


def _plate(
    at: tuple[Point, Frame], loop: Loop, half: float | tuple[float, float], scale: float
) -> Primitive:
    """A flat outline; ``half`` its thickness, or from where to where it goes."""
    origin, frame = at
    low, high = half if isinstance(half, tuple) else (-half, half)
    lengths = packed([(scale * low, scale * high, [scale * turning(loop)])])
    return Primitive("layers", origin, Rotation.from_matrix(frame).as_rotvec(), lengths)


def _plates(at: tuple[Point, Frame], each: Sequence[tuple[float, Loop]], scale: float) -> Primitive:
    """Several outlines, each half as thick as stated."""
    origin, frame = at
    lengths = packed(
        [(-scale * half, scale * half, [scale * turning(loop)]) for half, loop in each]
    )
    return Primitive("layers", origin, Rotation.from_matrix(frame).as_rotvec(), lengths)


def _pipe(at: tuple[Point, Frame], nodes: Sequence[Sequence[float]], scale: float) -> Primitive:
    origin, frame = at
    turn = Rotation.from_matrix(frame).as_rotvec()
    line = Pipe(_scaled(nodes, np.zeros(3), scale))
    return Primitive("pipes", origin, turn, packed_pipes([line]))


def _scaled(nodes: Sequence[Sequence[float]], at: Point, scale: float) -> np.ndarray:
    found = scale * np.array(nodes, float)
    found[:, :3] += at
    return found


def _at(curve: Loop, fraction: Float[np.ndarray, " n"]) -> Loop:
    """The points at fractions of a curve."""
    known = np.linspace(0, 1, len(curve))
    return np.stack([np.interp(fraction, known, curve[:, k]) for k in range(2)], 1)


SHAPES: dict[str, Callable[[Mount], Parts]] = {
    "wings": _feathered,
    "bat wings": _leathery,
    "butterfly wings": _lobed,
    "fairy wings": _lobed,
    "horns": _horned(OUTWARD),
    "devil horns": _horned(UPWARD),
    "ram horns": _curled,
    "antlers": _antlered,
    "unicorn horn": _one_horned,
    "halo": _haloed,
    "cat ears": _eared(np.array(EAR), 0.42, 0.46, 0.3, 0.3),
    "fox ears": _eared(np.array(EAR), 0.42, 0.56, 0.3, 0.3),
    "bunny ears": _eared(closed_curve(LONG_EAR), 0.26, 1.0, 0.2, 0.16),
    "cat tail": _tailed(CAT_TAIL),
    "fox tail": _tailed(FOX_TAIL, FOX_TIP),
    "devil tail": _spaded,
}


def joined_alone(parts: Parts, mount: Mount) -> Parts:
    """The appendages with what keeps them together where there is no body: a band over the head
    for ears, a bar between two horns or wings."""
    first = next(iter(parts))
    if first not in BANDS:
        return parts
    start = np.array([mount.head[0], *mount.shoulder[1:]]) if first == "wings" else mount.head
    band = _pipe((start, np.eye(3)), BANDS[first], mount.wide)
    last = list(parts)[-1] if first == "wings" else first
    return {**parts, last: [*parts[last], band]}
