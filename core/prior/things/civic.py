"""Civic buildings, from a hut to a hospital."""

from collections.abc import Iterable

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    both,
    box,
    capsule,
    join,
    lathe,
    moved,
    prism,
    ring,
    tube,
    turned,
    within,
)
from core.prior.things.animals import fitted


def _row(at: Iterable[float], z: float, half: tuple[float, float, float], y: float) -> Solid:
    """Boxes side by side along x, at the height ``z``, in the plane ``y``."""
    return join(*(box((u, y, z), half, 0.02) for u in at))


def _hip(x: float, y: float, low: float, high: float) -> Solid:
    """A roof of four slopes, as steep at its ends as at its sides."""
    ridge = max(x - y, 0.05)
    return within(
        prism([(-x, low), (x, low), (x, low + 0.1), (ridge, high), (-ridge, high),
               (-x, low + 0.1)], 1, y),
        prism([(-y, low), (y, low), (y, low + 0.1), (0.03, high), (-0.03, high),
               (-y, low + 0.1)], 0, x),
    )  # fmt: skip


def mansion(draw: Draw) -> Parts:
    """A great house: a portico of four columns with a pediment, two wings, rows of windows."""
    x, y, high = draw(1.5, 1.56), draw(0.5, 0.54), draw(0.98, 1.04)
    mid, front = draw(0.56, 0.6), -y - 0.42
    top = high + 0.14
    wing = [x * 0.54, x * 0.83]
    both_rows = [s * u for u in wing for s in (-1, 1)]
    half = (0.11, y + 0.06, 0.15)
    gable = [(-mid - 0.14, top), (mid + 0.14, top), (0, top + 0.38)]
    inner = [(-mid * 0.62, top + 0.1), (mid * 0.62, top + 0.1), (0, top + 0.28)]
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y, high / 2)),
            box((0, 0, high / 2), (mid, y + 0.08, high / 2)),
            prism(inner, 1, 0.3, front + 0.24),
        ),
        "roof": join(
            _hip(x + 0.1, y + 0.1, high - 0.04, high + 0.64),
            prism([(u * 1.16, v + 0.1) for u, v in gable], 1, (y + 0.3) / 2, -(y + 0.16) / 2),
        ),
        "columns": join(
            *(tube((u, front + 0.12, 0), (u, front + 0.12, top), 0.1, 0.01)
              for u in (-mid, -mid * 0.36, mid * 0.36, mid)),
            prism(gable, 1, 0.3, front + 0.3),
            box((0, front + 0.3, top - 0.02), (mid + 0.16, 0.32, 0.08)),
            box((0, front + 0.26, 0.06), (mid + 0.18, 0.4, 0.09)),
            box((0, front - 0.1, 0.03), (mid * 0.6, 0.22, 0.08)),
            box((0, 0, 0.05), (x + 0.06, y + 0.06, 0.08)),
        ),
        "windows": join(
            *(_row(both_rows, z, half, 0) for z in (high * 0.3, high * 0.74)),
            *(box((0, 0, z), (x + 0.06, 0.14, 0.15), 0.02) for z in (high * 0.3, high * 0.74)),
            _row((-mid * 0.68, 0, mid * 0.68), high * 0.8, (0.11, y + 0.14, 0.14), 0),
            _row((-mid * 0.68, mid * 0.68), high * 0.32, (0.11, y + 0.14, 0.14), 0),
        ),
        "door": box((0, -y, 0.28), (0.16, 0.16, 0.28), 0.02),
        "chimney": both(box((x * 0.62, 0.12, high + 0.5), (0.12, 0.12, 0.34), 0.02)),
    }  # fmt: skip


def hut(draw: Draw) -> Parts:
    """A round hut of mud under a tall cone of thatch in layers, a dark door in a wooden frame."""
    r, high, reach = draw(0.86, 0.92), draw(1.06, 1.14), draw(1.14, 1.2)
    tall, low = draw(1.24, 1.32), high - 0.14
    layers = []
    for k in range(3):
        out, z = reach * (1 - 0.27 * k), low + tall * 0.27 * k
        layers.append(lathe([(out - 0.16, z), (out, z), (out - 0.02, z + 0.13),
                             (out * 0.4, z + tall * 0.42)], 0.03))  # fmt: skip
    peak = low + tall
    crown = [(0.3, peak - 0.34), (0.15, peak - 0.08), (0.24, peak + 0.16), (0.08, peak + 0.18)]
    wide, front = 0.33, -r - 0.05

    def aside(solid: Solid) -> Solid:
        """What is made at +X, turned to the front beside the door."""
        return turned(solid, 2, -34)

    post = capsule((wide, front + 0.06, 0.05), (wide, front + 0.06, 0.78), 0.1)
    return {
        "walls": lathe([(r + 0.02, 0), (r + 0.04, 0.3), (r, high + 0.1)], 0.02),
        "roof": join(*layers, lathe(crown, 0.02)),
        "door": box((0, front + 0.12, 0.4), (0.28, 0.14, 0.4), 0.02),
        "frame": join(
            both(join(post, aside(ring((r + 0.02, 0, 0.6), 0.2, 0.09, 0)))),
            capsule((-0.43, front + 0.06, 0.8), (0.43, front + 0.06, 0.8), 0.1),
        ),
        "windows": both(aside(tube((r - 0.1, 0, 0.6), (r + 0.06, 0, 0.6), 0.18))),
        "base": tube((0, 0, 0), (0, 0, 0.2), r + 0.12, 0.04),
        "band": tube((0, 0, peak - 0.13), (0, 0, peak + 0.03), 0.25, 0.04),
    }


def school(draw: Draw) -> Parts:
    """A long house of red brick, over its door a tower with a clock and a bell, a flag on top."""
    x, y, high = draw(1.36, 1.42), draw(0.47, 0.5), draw(0.96, 1.0)
    half, tall = draw(0.43, 0.45), draw(1.52, 1.56)
    front = -y - 0.14
    mid, roof, clock = front + half, tall + 0.58, tall - 0.32
    cols = [s * u for u in (half + 0.28, x - 0.27) for s in (-1, 1)]
    rows = (high * 0.36, high * 0.76)
    post = box((half - 0.07, half - 0.07, tall + 0.28), (0.09, 0.09, 0.34))
    bell = lathe([(0.23, tall + 0.16), (0.17, tall + 0.28), (0.14, tall + 0.44),
                  (0.1, roof + 0.04)], 0.02)  # fmt: skip
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y, high / 2)),
            box((0, mid, tall / 2), (half, half, tall / 2)),
        ),
        "roof": join(
            _hip(x + 0.12, y + 0.12, high - 0.04, high + 0.38),
            moved(_hip(half + 0.12, half + 0.12, roof - 0.04, roof + 0.42), (0, mid, 0)),
        ),
        "trim": join(
            box((0, mid, tall), (half + 0.09, half + 0.09, 0.09), 0.02),
            moved(both(post, 0, 1), (0, mid, 0)),
            tube((0, front - 0.08, clock), (0, front + 0.2, clock), 0.3, 0.02),
            box((0, 0, 0.06), (x + 0.08, y + 0.08, 0.08)),
            box((0, front - 0.12, 0.07), (half, 0.3, 0.1)),
            box((0, front, 0.78), (0.34, 0.18, 0.08), 0.02),
            tube((0, mid, roof + 0.3), (0, mid, roof + 0.96), 0.08),
        ),
        "windows": join(
            *(_row(cols, z, (0.14, y + 0.08, 0.13), 0) for z in rows),
            *(_row((-0.24, 0.24), z, (0.14, 0.1, 0.13), y) for z in rows),
            *(box((0, 0, z), (x + 0.08, 0.2, 0.13), 0.02) for z in rows),
        ),
        "door": join(
            box((0, front, 0.4), (0.23, 0.1, 0.36), 0.02),
            box((0.36, mid, roof + 0.76), (0.36, 0.075, 0.22), 0.02),
        ),
        "bell": moved(bell, (0, mid, 0)),
        "hands": join(
            capsule((0, front - 0.1, clock), (0, front - 0.1, clock + 0.18), 0.065),
            capsule((0, front - 0.1, clock), (0.14, front - 0.1, clock), 0.065),
        ),
    }


def hospital(draw: Draw) -> Parts:
    """A white block with a great red cross, rows of blue windows, a canopy over the entrance."""
    x, y, high = draw(0.74, 0.8), draw(0.54, 0.58), draw(1.8, 1.9)
    wide, low = draw(1.4, 1.46), draw(0.9, 0.96)
    front = -y - 0.1
    size, arm, z = draw(0.4, 0.42), 0.14, high - 0.5
    cols = [s * (x + (wide - x) * 0.5) for s in (-1, 1)]
    rows = (low * 0.36, low * 0.74)
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y + 0.1, high / 2), 0.02),
            box((0, 0.04, low / 2), (wide, y - 0.06, low / 2), 0.02),
        ),
        "roof": join(
            box((0, 0, high), (x + 0.07, y + 0.17, 0.07), 0.02),
            box((0, 0.04, low), (wide + 0.07, y + 0.01, 0.07), 0.02),
            box((0, 0, 0.04), (wide + 0.07, y + 0.14, 0.08), 0.02),
        ),
        "windows": join(
            *(_row(cols, v, (0.22, y + 0.04, 0.12), 0) for v in rows),
            *(box((0, 0.04, v), (wide + 0.06, 0.28, 0.12), 0.02) for v in rows),
            _row((-x * 0.62, 0, x * 0.62), low * 0.92, (0.17, y + 0.16, 0.11), 0),
            *(box((0, 0, v), (x + 0.06, 0.34, 0.11), 0.02) for v in (high * 0.66, high * 0.84)),
            both(box((x * 0.64, front, low * 0.36), (0.15, 0.06, 0.15), 0.02)),
        ),
        "cross": both(join(
            box((0, -front + 0.02, z), (size, 0.08, arm)),
            box((0, -front + 0.02, z), (arm, 0.08, size)),
        ), 1),
        "canopy": join(
            box((0, front - 0.22, 0.64), (0.42, 0.3, 0.08), 0.02),
            both(tube((0.33, front - 0.42, 0), (0.33, front - 0.42, 0.64), 0.07)),
            box((0, front - 0.24, 0.03), (0.42, 0.3, 0.07), 0.02),
        ),
        "door": box((0, front, 0.3), (0.24, 0.08, 0.3), 0.02),
    }  # fmt: skip


def torii_gate(draw: Draw) -> Parts:
    """Two red pillars that lean inwards, a curved red lintel under a black one, a second beam."""
    x, high, r = draw(0.8, 0.86), draw(1.9, 2.0), draw(0.165, 0.175)
    reach, rise = draw(1.42, 1.48), draw(0.24, 0.28)
    us = [k / 6 - 1 for k in range(13)]

    def beam(low: float, tall: float, half: float, span: float) -> Solid:
        """Curved upwards to its ends, from ``low`` in the middle."""
        under = [(span * u, low + rise * abs(u) ** 2.4) for u in us]
        over = [(span * u * 1.04, low + tall + rise * abs(u) ** 2.4) for u in us[::-1]]
        return prism([*under, *over], 1, half)

    return {
        "pillars": join(
            both(tube((x, 0, 0), (x - 0.08, 0, high + 0.1), r, 0.01)),
            box((0, 0, high * 0.76), (x + 0.36, 0.1, 0.1)),
            beam(high - 0.06, 0.2, 0.16, reach - 0.1),
            box((0, 0, high * 0.9), (0.09, 0.09, high * 0.16)),
        ),
        "lintel": beam(high + 0.1, 0.17, 0.22, reach),
        "feet": both(join(
            tube((x, 0, 0), (x, 0, 0.24), r + 0.1, 0.03),
            box((x, 0, 0.02), (r + 0.2, r + 0.2, 0.08), 0.02),
        )),
        "plaque": box((0, 0, high * 0.885), (0.16, 0.17, 0.17), 0.02),
    }  # fmt: skip


CIVIC = {
    "mansion": fitted(mansion),
    "hut": hut,
    "school": fitted(school),
    "hospital": fitted(hospital),
    "torii gate": torii_gate,
}
