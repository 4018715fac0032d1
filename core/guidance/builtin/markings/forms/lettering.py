"""Letters and signs on fronts, sides, ribs and balls."""

import torch
import torch.nn.functional as F

from core.guidance.builtin.markings.forms.frames import arch
from core.guidance.builtin.markings.forms.stripes import on_four_sides
from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Points,
    Way,
    all_of,
    any_of,
    in_front,
)
from core.guidance.builtin.markings.outlines import Disc, Emblem, laid
from core.guidance.builtin.markings.shapes import shape_margin
from core.guidance.builtin.markings.stencils import lettering

GLYPHS = ("sun", "leaf", "ring", "moon", "diamond", "crown", "arrow")  # of an obelisk, from below


def lettered(
    points: Points, half: Half, text: str, high: float, bold: float = 0.03, at: float = 0.0
) -> Margin:
    """Letters across the front.

    Args:
        high: a capital's height in halves of the width.
        bold: how much wider the strokes are than the font's, of a capital's height.
        at: the height of the letters' middle in halves.
    """
    size = high * half[0]
    place = torch.stack([points[:, 0], points[:, 2] - at * half[2]], 1) / size
    return all_of((lettering(place, text) + bold) * size, in_front(points))


def on_sides(points: Points, half: Half, text: str, high: float, at: tuple[float, float]) -> Margin:
    """Letters on the left and the right side; ``high`` in halves of the length, ``at`` (back and
    up) in halves of the length and the height."""
    size, right = high * half[1], points[:, 0].sign()
    y, z = points[:, 1] - at[0] * half[1], points[:, 2] - at[1] * half[2]
    letters = (lettering(torch.stack([right * y, z], 1) / size, text) + 0.05) * size
    return all_of(letters, points[:, 0].abs() - 0.6 * half[0])


def written_up(
    points: Points, half: Half, text: str, high: float, at: float, bold: float = 0.05
) -> Margin:
    """Letters on the front, read upwards: their height in halves of the width, the place of their
    middle in halves of the height."""
    size = high * half[0]
    place = torch.stack([points[:, 2] - at * half[2], -points[:, 0]], 1) / size
    return all_of((lettering(place, text) + bold) * size, in_front(points))


def number_on(points: Points, half: Half, text: str, way: Way, high: float) -> Margin:
    """Upright letters on a ball around a direction, ``high`` in radii."""
    ahead = F.normalize(points.new_tensor(way), dim=0)
    right = F.normalize(torch.linalg.cross(points.new_tensor([0.0, 0, 1]), -ahead), dim=0)
    up = torch.linalg.cross(-ahead, right)
    on = F.normalize(points, dim=1)
    at = torch.stack([on @ right, on @ up], 1) / high
    return all_of((lettering(at, text) + 0.04) * high, on @ ahead) * half.mean()


def race_number(points: Points, half: Half, text: str, disc: Disc) -> Margin:
    """A disc on the top without the number on it."""
    size = 0.22 if len(text) == 1 else 0.17
    return laid(points, half, top=(disc, Emblem(disc.at, size, text=text, gap=True)), deep=-0.2)


def rib_letters(points: Points, half: Half, text: str = "CARGO") -> Margin:
    """A letter on each rib on both sides of a container, given the box of its body."""
    pitch, size = 0.392 * half[1], 0.2 * half[1]
    along, up = points[:, 1] * points[:, 0].sign(), points[:, 2]
    margins = []
    for k, letter in enumerate(text):
        away = along - (k - (len(text) - 1) / 2) * pitch
        margins.append(lettering(torch.stack([away, up], 1) / size, letter) + 0.05)
    return all_of(any_of(*margins) * size, points[:, 0].abs() - 0.7 * half[0])


def reel_sevens(points: Points, half: Half) -> Margin:
    """A seven on each of three reels in a row, given the box of all or of one."""
    pitch = float(half[0]) / (1.42 if half[0] > 0.9 * half[2] else 0.42)
    x = points[:, 0] / pitch
    size = 0.62 * pitch
    place = torch.stack([(x - x.round()) * pitch, points[:, 2]], 1) / size
    return all_of((lettering(place, "7") + 0.05) * size, in_front(points))


def epitaph(points: Points, half: Half) -> Margin:
    """The letters of a tombstone and the border around them."""
    letters = laid(points, half, front=(Emblem((0, -0.5), 0.21, text="RIP"),), deep=0.5)
    return any_of(letters, arch(points, half))


def glyphs(points: Points, half: Half) -> Margin:
    """Signs one above the other on the four sides of an obelisk."""
    across, wide = on_four_sides(points, half, 1.0, 0.66)
    pitch = 1.5 * float(half[2]) / len(GLYPHS)
    size = 0.4 * pitch
    margins = []
    for k, shape in enumerate(GLYPHS):
        up = points[:, 2] - (k - (len(GLYPHS) - 1) / 2) * pitch
        margins.append(shape_margin(torch.stack([across, up], 1) / size, shape) * size)
    return all_of(any_of(*margins), 0.9 * wide - across.abs())
