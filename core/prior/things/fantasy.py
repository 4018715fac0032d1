"""Treasure and gear of games and stories; with signs of the sky and of nature."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    both,
    box,
    join,
    moved,
    prism,
    ring,
    tube,
    turned,
)


def _six_sided(at: Vector, radius: float, high: float, lean: Vector) -> Solid:
    """A six-sided crystal with a pointed top, leant about x, then y, turned about z (degrees)."""
    side = [(0, 0), (radius, 0), (radius * 1.1, high - radius * 1.9), (0, high)]
    stone = around(6, prism(side, 1, 2), 30)
    for axis, degrees in enumerate(lean):
        stone = turned(stone, axis, degrees)
    return moved(stone, at)


def crystal(draw: Draw) -> Parts:
    """A cluster of pointed crystals on a rock: the largest upright, others about it."""
    high, r, side = draw(1.7, 1.95), draw(0.27, 0.32), draw(1.1, 1.3)
    lean, small = draw(24, 32), draw(0.6, 0.75)
    tall = _six_sided((0, 0.1, 0.1), r, high, (0, 0, 0))
    beside = _six_sided((0.32, 0.12, 0.1), r * 0.78, side, (0, lean, 0))
    front = _six_sided((0.24, -0.3, 0.1), r * 0.66, small, (32, 20, 0))
    low = _six_sided((0.6, -0.1, 0.1), r * 0.58, small * 0.9, (10, 52, 0))
    rear = _six_sided((0.22, 0.4, 0.1), r * 0.7, small * 1.2, (-30, 14, 0))
    base = around(9, prism([(0, 0), (0.86, 0), (0.72, 0.2), (0.4, 0.34), (0, 0.34)], 1, 2), 10)
    return {
        "crystals": join(tall, both(beside)),
        "shards": both(join(front, low, rear)),
        "rock": base,
    }


def compass(draw: Draw) -> Parts:
    """Upright like a pocket watch, its dial to the front, the needle's red end to the north."""
    r, y, rim = draw(0.95, 1.05), draw(0.17, 0.22), draw(0.16, 0.2)
    long, wide, lean = r * draw(0.58, 0.66), draw(0.17, 0.21), draw(24, 36)
    z = r + rim
    half = [(-wide, 0), (wide, 0), (0, long)]
    red, pale = (
        moved(turned(prism(half, 1, 0.12, -y), 1, lean + turn), (0, 0, z)) for turn in (0, 180)
    )
    mark = box((0, -y + 0.04, r - 0.2), (0.07, 0.09, 0.1))
    return {
        "case": moved(
            join(
                tube((0, -y + 0.1, 0), (0, y, 0), r + rim, 0.03),
                ring((0, -y, 0), r + rim - 0.13, 0.13, 1),
            ),
            (0, 0, z),
        ),
        "dial": tube((0, -y + 0.02, z), (0, y - 0.1, z), r - 0.02),
        "needle": red,
        "tail": pale,
        "marks": moved(join(*(turned(mark, 1, 90 * k) for k in range(4))), (0, 0, z)),
        "loop": join(
            tube((0, 0, 2 * z - 0.1), (0, 0, 2 * z + 0.16), 0.16, 0.02),
            ring((0, 0, 2 * z + 0.36), draw(0.23, 0.27), 0.1, 1),
        ),
    }


def ingot(draw: Draw) -> Parts:
    """A bar of cast metal along x, narrower at its top, with a raised stamp."""
    x, y, high, slope = draw(1.25, 1.45), draw(0.5, 0.6), draw(0.46, 0.56), draw(0.16, 0.22)
    long = prism([(-x, 0), (x, 0), (x - slope, high), (slope - x, high)], 1, y)
    across = prism([(-y, 0), (y, 0), (y - slope, high), (slope - y, high)], 0, x)
    wide, deep = x * draw(0.5, 0.58), (y - slope) * 0.62
    return {
        "bar": lambda p: long(p).maximum(across(p)),
        "stamp": box((0, 0, high), (wide, deep, 0.08), 0.02),
    }


FANTASY = {"crystal": crystal, "compass": compass, "ingot": ingot}
