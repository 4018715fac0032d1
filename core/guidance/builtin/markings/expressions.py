"""Expressions: lids and brows by the eyes of a thing, and its mouth, as its mood has them."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import torch
import torch.nn.functional as F
from jaxtyping import Bool, Float
from torch import Tensor

from core.guidance.builtin.markings.margins import Margin, Pair, all_of, strokes
from core.guidance.builtin.markings.overlay import Overlay
from core.guidance.builtin.palette import EYES, Painted
from core.guidance.builtin.words.phrases.moods import Mood
from core.guidance.builtin.words.tables.colors import luma

MOUTH = "mouth"
CELLS = 40  # of a lattice over the box of a feature's part, along each side
NEAR = 0.6  # cells: a place so near the surface is on it
LEAST = 6  # places of a feature that is there
LID, BROW = 0.85, 0.35  # sRGB, of the colour around an eye
DIM = 0.25  # a face of less luminance has light brows
LIGHT_BROW = 0.55
ASIDE = 0.8  # of an outward normal: beyond, an eye looks aside
AROUND = 1.7  # half a box around an eye, of half the eye's
BY_EYE = 1.4  # halves of an eye: as far from its middle as a lid goes
WIDEST = 0.9  # of the part below: a mouth's width
FACING = 0.1  # least cosine between a surface and its feature's
BROW_WIDE, MOUTH_WIDE = 0.17, 0.1  # half of a line's width: of half an eye's, of half a mouth's
LARGER = 1.25  # a mouth's width, of that by nature

Distances = Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n p"]]

# A lid's edge: how high it is at the inner and the outer corner, in halves of the eye's height.
LIDS: dict[Mood, Pair] = {"angry": (-0.15, 0.8), "sad": (0.85, -0.05), "sleepy": (0.1, 0.05)}
CHEEK: dict[Mood, float] = {"happy": -0.45}  # the edge of a lower lid
# A brow from the inner to the outer corner, in halves of the eye's width and height.
BROWS: dict[Mood, tuple[Pair, ...]] = {
    "angry": ((-0.95, 0.95), (0.2, 1.35), (1.05, 1.75)),
    "sad": ((-0.9, 1.8), (0.1, 1.5), (1.1, 1.05)),
    "surprised": ((-0.8, 1.75), (0.0, 2.0), (0.8, 1.75)),
}
# A cheek's middle, in halves of the eye's width and height, and its radius in halves of the width.
CHEEKS: dict[Mood, tuple[Pair, float]] = {"happy": ((1.1, -1.75), 0.75)}
LARGE = 0.12  # training units: below eyes of this size no cheek is left
BLUSH, BLUSHED = (0.93, 0.36, 0.36), 0.5  # its colour, and how much of it
# A mouth's line, in halves of its width; a happy one is drawn as a smile by nature.
SMILE = tuple(
    (x, 0.5 * x * x - 0.25) for x in (-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0)
)
LINES: dict[Mood, tuple[Pair, ...]] = {
    "sad": tuple((0.8 * x, -y) for x, y in SMILE),
    "angry": ((-0.8, -0.3), (-0.4, 0.05), (0.0, 0.12), (0.4, 0.05), (0.8, -0.3)),
    "sleepy": ((-0.45, 0.0), (0.45, 0.0)),
}
# In an eye: their middles, in its halves, and their radii, in the lesser half.
GLINTS, WHITE, DARK = "glints", (1.0, 1.0, 1.0), 0.3
REFLECTIONS: tuple[tuple[Pair, float], ...] = (((0.26, 0.42), 0.34), ((-0.3, -0.4), 0.17))
OPEN: dict[Mood, Pair] = {"surprised": (0.42, 0.55)}  # an oval's halves


class Feature(NamedTuple):
    """A patch of the surface: an eye, or a mouth."""

    middle: Float[Tensor, " 3"]
    out: Float[Tensor, " 3"]  # outward, length 1
    half: Float[Tensor, " 2"]  # half its width and height
    is_pair: bool  # the one at the right, and its mirror image at x = 0
    is_eye: bool

    def at(self, points: Float[Tensor, "n 3"]) -> tuple[Float[Tensor, "n 2"], Margin]:
        """Places from its inner to its outer corner and upwards, in its halves; and how far in
        front of it each is, training units."""
        if self.is_pair:
            points = torch.cat([points[:, :1].abs(), points[:, 1:]], 1)
        off = points - self.middle.to(points)
        aside = self.is_pair and float(self.out[0]) > ASIDE  # then the front is its inner side
        across = off[:, 1] if aside else off[:, 0]
        front = off[:, 0] if aside else -off[:, 1]
        at = torch.stack([across, off[:, 2]], 1) / self.half.to(points)
        if not self.is_pair and self.is_eye:  # a cyclops' has two halves
            at = torch.stack([2 * at[:, 0].abs() - 1, at[:, 1]], 1)
        return at, front


def expression(
    mood: Mood,
    is_lively: bool,
    names: Sequence[str],
    boxes: Sequence[Float[Tensor, "2 3"] | None],
    bearers: Sequence[int],
    distances: Distances,
    paints: Sequence[Painted],
) -> list[Overlay]:
    """The areas of a mood on one object, and the reflections in a pair of dark eyes, without which
    they look dead.

    Args:
        mood: "" for none.
        is_lively: whether light is reflected in its eyes.
        names: of its parts.
        boxes: of its parts with a solid.
        bearers: for each part the one with the solid below it.
        distances: of the parts with their markings.
    """
    search = _Search(boxes, bearers, distances)
    found: list[Overlay] = []
    own = tuple(part for part, name in enumerate(names) if name in EYES)
    eye = search.feature(own, True)
    if eye and mood:
        found += _by_eye(mood, eye, own, search.around(eye, own), paints)
    if MOUTH in names:
        mouth = names.index(MOUTH)
        below = bearers[mouth]
        box = boxes[below]
        painted = below != mouth and mood in (*LINES, *OPEN)
        feature = search.feature((mouth,), False) if painted else None
        # A robot's comes with the rings at its ears.
        if feature and box is not None and feature.half[0] < WIDEST * (box[1] - box[0])[0] / 2:
            found.append(Overlay(_mouth(mood, feature), (below, mouth), below, paints[mouth]))
    dark = [part for part in own if luma(paints[part].color) <= DARK]
    if is_lively and dark and eye and eye.is_pair and GLINTS not in names:
        white = paints[own[0]]._replace(second=WHITE, pattern="", name=GLINTS, color=WHITE)
        found.append(Overlay(_glint(eye), own, own[0], white))
    return found


def _glint(eye: Feature) -> Callable[[Tensor], Margin]:
    def margin(points: Float[Tensor, "n 3"]) -> Margin:
        at, front = eye.at(points)
        half = eye.half.to(points)
        size = half.min()
        spots = [
            radius * size - ((at - at.new_tensor(middle)) * half).norm(dim=1)
            for middle, radius in REFLECTIONS
        ]
        return all_of(torch.stack(spots).amax(0), front + half.max())

    return margin


def _by_eye(
    mood: Mood, eye: Feature, own: tuple[int, ...], face: list[int], paints: Sequence[Painted]
) -> list[Overlay]:
    """The lids and the brow of one eye, on ``own`` parts of it and on those of the ``face``."""
    if not face:
        return []
    skin, found = paints[face[0]], []
    plain = skin._replace(second=skin.color, pattern="")
    if mood in LIDS or mood in CHEEK:
        lid = plain._replace(color=tuple(LID * x for x in skin.color), name="lids")
        found.append(Overlay(_lid(mood, eye), own, own[0], lid))
    if mood in CHEEKS and eye.half.max() < LARGE:
        pairs = zip(skin.color, BLUSH, strict=True)
        color = tuple(x + BLUSHED * (red - x) for x, red in pairs)
        blush = plain._replace(color=color, name="cheeks")
        found.append(Overlay(_cheek(*CHEEKS[mood], eye), tuple(face), face[0], blush))
    if mood in BROWS:
        dark = luma(skin.color) > DIM
        color = tuple(BROW * x if dark else x + LIGHT_BROW * (1 - x) for x in skin.color)
        brow = plain._replace(color=color, name="brows")
        found.append(Overlay(_brow(BROWS[mood], eye), tuple(face), face[0], brow))
    return found


def _lid(mood: Mood, eye: Feature) -> Callable[[Tensor], Margin]:
    def margin(points: Float[Tensor, "n 3"]) -> Margin:
        at, _ = eye.at(points)
        high = float(eye.half[1])
        if mood in CHEEK:
            covered = CHEEK[mood] - at[:, 1]
        else:
            inner, outer = LIDS[mood]
            covered = at[:, 1] - inner - (outer - inner) * (at[:, 0] + 1) / 2
        return all_of(covered, BY_EYE - at.abs().amax(1)) * high

    return margin


def _brow(curve: Sequence[Pair], eye: Feature) -> Callable[[Tensor], Margin]:
    def margin(points: Float[Tensor, "n 3"]) -> Margin:
        at, front = eye.at(points)
        half = eye.half.to(points)
        line = strokes(at * half, at.new_tensor(curve) * half, BROW_WIDE * float(half[0]))
        return all_of(line, front + 2 * half.max())

    return margin


def _cheek(middle: Pair, radius: float, eye: Feature) -> Callable[[Tensor], Margin]:
    def margin(points: Float[Tensor, "n 3"]) -> Margin:
        at, front = eye.at(points)
        half = eye.half.to(points)
        away = ((at - at.new_tensor(middle)) * half).norm(dim=1)
        return all_of(radius * half[0] - away, front + 2 * half.max())

    return margin


def _mouth(mood: Mood, mouth: Feature) -> Callable[[Tensor], Margin]:
    def margin(points: Float[Tensor, "n 3"]) -> Margin:
        at, front = mouth.at(points)
        wide = LARGER * float(mouth.half[0])
        at = at * mouth.half.to(points) / wide
        if mood in OPEN:
            off = at / at.new_tensor(OPEN[mood])
            line = (1 - off.norm(dim=1)) * min(OPEN[mood])
        else:
            line = strokes(at, at.new_tensor(LINES[mood]), MOUTH_WIDE)
        return all_of(line * wide, front + wide)

    return margin


class _Search:
    """A search for features on the surface of an object."""

    def __init__(
        self,
        boxes: Sequence[Float[Tensor, "2 3"] | None],
        bearers: Sequence[int],
        distances: Distances,
    ) -> None:
        self._boxes, self._bearers, self._distances = boxes, bearers, distances

    def feature(self, own: tuple[int, ...], is_eye: bool) -> Feature | None:
        """The feature of the ``own`` parts; None: nothing of it shows."""
        boxes = [box for part in own if (box := self._boxes[self._bearers[part]]) is not None]
        if not boxes:
            return None
        box = _joined(boxes)
        places, owner = self._surface(box)
        mine = _is_one_of(owner, own)
        right = places[mine & (places[:, 0] > 0)]
        left = places[mine & (places[:, 0] < 0)]
        if len(right) < LEAST:
            return None
        cell = float((box[1] - box[0]).max()) / CELLS
        is_pair = float(right[:, 0].min()) > cell
        places = right if is_pair else torch.cat([left, right])
        normals = self._normals(places, cell)
        out = F.normalize(normals.mean(0), dim=0)
        ahead = places[normals @ out > FACING]
        low, high = ahead.amin(0), ahead.amax(0)
        size = (high - low) / 2
        wide = size[1] if float(out[0]) > ASIDE else size[0]
        return Feature(
            (low + high) / 2, out, torch.stack([wide, size[2]]).clamp_min(cell), is_pair, is_eye
        )

    def around(self, eye: Feature, own: tuple[int, ...]) -> list[int]:
        """The parts around an eye, the largest first."""
        half = AROUND * float(eye.half.max())
        _, owner = self._surface(torch.stack([eye.middle - half, eye.middle + half]))
        others = owner[~_is_one_of(owner, own)]
        parts, counts = others.unique(return_counts=True)
        return parts[counts.argsort(descending=True)].tolist()[:3]

    def _surface(self, box: Float[Tensor, "2 3"]) -> tuple[Float[Tensor, "n 3"], Tensor]:
        """Places in a box on the surface, and the part of each."""
        low, high = box[0] - 0.01, box[1] + 0.01
        sides = [torch.linspace(float(a), float(b), CELLS) for a, b in zip(low, high, strict=True)]
        places = torch.stack(torch.meshgrid(*sides, indexing="ij"), -1).view(-1, 3)
        distances = self._distances(places)
        near = distances.amin(1).abs() < NEAR * float((high - low).max()) / CELLS
        return places[near], distances[near].argmin(1)

    def _normals(self, places: Float[Tensor, "n 3"], step: float) -> Float[Tensor, "n 3"]:
        taps = step * torch.eye(3)
        around = [self._distances(places + tap).amin(1) for tap in (*taps, *-taps)]
        return F.normalize(torch.stack(around[:3], 1) - torch.stack(around[3:], 1), dim=1)


def _joined(boxes: Sequence[Float[Tensor, "2 3"]]) -> Float[Tensor, "2 3"]:
    """The box around all, of each pair that at the right."""
    right = [box if float(box[:, 0].sum()) >= 0 else _mirrored(box) for box in boxes]
    corners = torch.stack(right)
    return torch.stack([corners[:, 0].amin(0), corners[:, 1].amax(0)])


def _mirrored(box: Float[Tensor, "2 3"]) -> Float[Tensor, "2 3"]:
    low, high = box * box.new_tensor([-1.0, 1.0, 1.0])
    return torch.stack([low.minimum(high), low.maximum(high)])


def _is_one_of(owner: Tensor, parts: tuple[int, ...]) -> Bool[Tensor, " n"]:
    return torch.isin(owner, torch.tensor(parts))
