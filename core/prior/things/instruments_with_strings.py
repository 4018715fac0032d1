"""Musical instruments with strings."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Point,
    Solid,
    both,
    box,
    capsule,
    egg,
    grown,
    join,
    lathe,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    tube,
)

# From the strap's end at the floor to a horn's tip, and from there to the neck.
EVEN_SIDE = ((0.0, 0.0), (0.34, 0.03), (0.62, 0.18), (0.71, 0.46), (0.58, 0.8), (0.54, 1.0),
             (0.63, 1.24), (0.62, 1.5))  # fmt: skip
EVEN_HORN = ((0.62, 1.5), (0.42, 1.38), (0.31, 1.24), (0.2, 1.14))
LEFT_SIDE = ((0.0, 0.0), (-0.4, 0.03), (-0.68, 0.22), (-0.7, 0.52), (-0.54, 0.86), (-0.58, 1.2),
             (-0.6, 1.6))  # fmt: skip
LEFT_HORN = ((-0.6, 1.6), (-0.42, 1.44), (-0.3, 1.27), (-0.2, 1.14))
RIGHT_SIDE = ((0.0, 0.0), (0.4, 0.0), (0.7, 0.16), (0.75, 0.46), (0.57, 0.8), (0.55, 1.02),
              (0.62, 1.42))  # fmt: skip
RIGHT_HORN = ((0.62, 1.42), (0.42, 1.31), (0.3, 1.2), (0.2, 1.1))


def guitar(draw: Draw) -> Parts:
    """Upright, its strings to the front; two pegs on either side of its head."""
    low, half, neck = draw(0.54, 0.6), draw(0.16, 0.18), draw(0.76, 0.86)
    waist, up, high = low * draw(0.64, 0.69), low * draw(0.76, 0.82), draw(1.32, 1.42)
    right = [(0, 0), (low * 0.62, 0.04), (low, 0.38), (waist, 0.82), (up, 1.1), (up * 0.5, high)]
    side = smooth_curve([*right, (0, high + 0.02)], 6)
    top, front, z = high + neck, -half, high * 0.64
    head = mirrored([(0.12, top), (0.22, top + 0.14), (0.2, top + 0.75)])
    rows = (top + 0.18, top + 0.58)
    pegs = (capsule((0.27, front, v), (0.37, front, v), 0.09) for v in rows)
    return {
        "body": prism(mirrored(side), 1, half),
        "neck": join(
            box((0, front - 0.01, (z + 0.24 + top) / 2), (0.12, 0.12, (top - z - 0.16) / 2)),
            prism(head, 1, 0.11, front),
            tube((0, front - 0.05, z), (0, 0, z), 0.27),
        ),
        "hole": tube((0, front - 0.1, z), (0, 0, z), draw(0.15, 0.17)),
        "bridge": box((0, front, 0.34), (0.26, 0.1, 0.075), 0.02),
        "pegs": both(join(*pegs)),
    }


def _bent(*rows: tuple[Point, ...]) -> list[Point]:
    return [point for row in rows for point in smooth_curve(list(row))]


def electric_guitar(draw: Draw) -> Parts:
    """Upright, its strings to the front: even horns and pegs on both sides, or uneven and a row."""
    even, wide, thick = draw.chance(0.5), draw(0.97, 1.03), draw(0.15, 0.18)
    top, head = draw(1.94, 2.02), draw(0.86, 0.92)
    front, edge = -thick, 0.05
    rows = (top + 0.22, top + 0.7)
    tuners = join(*(capsule((0.28, front, v), (0.37, front, v), 0.105) for v in rows))
    if even:
        outline = mirrored(_bent(EVEN_SIDE, EVEN_HORN))
        plate = mirrored([(0.1, 0.4), (0.36, 0.4), (0.4, 0.6), (0.36, 0.86), (0.42, 1.14),
                          (0.1, 1.14)])  # fmt: skip
        nut = mirrored([(0.13, top), (0.24, top + 0.14), (0.22, top + head), (0.08, top + head)])
        pegs = both(tuners)
    else:
        left, right = _bent(LEFT_SIDE, LEFT_HORN), _bent(RIGHT_SIDE, RIGHT_HORN)
        outline = [*left, *reversed(right)]
        plate = [(-0.3, 0.42), (0.24, 0.34), (0.36, 0.14), (0.6, 0.2), (0.6, 0.5), (0.44, 0.8),
                 (0.46, 1.1), (-0.44, 1.28), (-0.42, 0.9)]  # fmt: skip
        nut = [(0.13, top), (0.22, top + 0.12), (0.22, top + head - 0.06), (0.1, top + head + 0.04),
               (-0.06, top + head), (-0.2, top + head - 0.2), (-0.13, top)]  # fmt: skip
        pegs = tuners
    knobs = ((0.48, 0.67), (0.44, 0.28))
    controls = (tube((x, front - 0.2, z), (x, front, z), 0.125, 0.02) for x, z in knobs)
    return {
        "body": grown(prism([(x * wide, z) for x, z in outline], 1, thick - edge), edge),
        "neck": join(
            box((0, front - 0.04, (1.08 + top) / 2), (0.13, 0.13, (top - 1.08) / 2 + 0.04), 0.02),
            prism(nut, 1, 0.12, front - 0.01),
        ),
        "pickguard": prism([(x * wide, z) for x, z in plate], 1, 0.1, front + 0.03),
        "pickups": join(
            *(box((0, front - 0.09, z), (0.23, 0.12, 0.09), 0.02) for z in (0.84, 0.53))
        ),
        "bridge": box((0, front - 0.06, 0.22), (0.18, 0.13, 0.1), 0.02),
        "knobs": join(pegs, *controls),
    }


def _pegs(x: float, z: float, rows: int, r: float = 0.085) -> Solid:
    pegs = (tube((-x, 0, z + 0.22 * k), (x, 0, z + 0.22 * k), r, 0.02) for k in range(rows))
    return join(*pegs)


def banjo(draw: Draw) -> Parts:
    """A round drum with a long neck."""
    r, half, neck = draw(0.56, 0.66), draw(0.16, 0.22), draw(1.15, 1.4)
    top = 2 * r + neck
    head = [(-0.13, top - 0.05), (0.13, top - 0.05), (0.22, top + 0.38), (0, top + 0.46)]
    return {
        "body": join(
            tube((0, -half, r), (0, half, r), r, 0.03), ring((0, -half + 0.03, r), r, 0.09, axis=1)
        ),
        "skin": tube((0, -half - 0.03, r), (0, 0, r), r - 0.1),
        "neck": join(
            box((0, -half + 0.02, (r * 1.75 + top) / 2), (0.12, 0.13, (top - r * 1.75) / 2), 0.02),
            prism([*head, (-0.22, top + 0.38)], 1, 0.1, -half + 0.04),
        ),
        "bridge": box((0, -half - 0.04, r * 0.72), (0.24, 0.09, 0.07), 0.02),
        "pegs": moved(_pegs(0.34, top + 0.08, 2, 0.07), (0, -half + 0.04, 0)),
    }


def ukulele(draw: Draw) -> Parts:
    """A small guitar with a short neck and four pegs."""
    low, high, half, neck = draw(0.44, 0.5), draw(1.12, 1.24), draw(0.14, 0.17), draw(0.68, 0.78)
    top, front = high + neck, -half - 0.02
    foot = high * 0.76
    head = [(-0.1, top - 0.02), (0.1, top - 0.02), (0.17, top + 0.4), (-0.17, top + 0.4)]
    right = [(0, 0), (low * 0.62, high * 0.03), (low, high * 0.27), (low * 0.7, high * 0.57)]
    right += [(low * 0.78, high * 0.79), (low * 0.43, high * 0.98), (0, high)]
    return {
        "body": prism(mirrored(smooth_curve(right, 6)), 1, half),
        "neck": join(
            box((0, -half + 0.02, (foot + top) / 2), (0.085, 0.085, (top - foot) / 2)),
            prism(head, 1, 0.07, -half + 0.04),
        ),
        "hole": tube((0, front, high * 0.6), (0, 0, high * 0.6), 0.17),
        "bridge": box((0, -half - 0.02, high * 0.24), (0.2, 0.06, 0.06), 0.02),
        "pegs": moved(_pegs(0.26, top + 0.1, 2, 0.07), (0, -half + 0.04, 0)),
    }


def violin(draw: Draw) -> Parts:
    """Upright, its front to the front: a waist between four corners, a scroll, four pegs."""
    wide, high, half, neck = draw(0.95, 1.05), draw(1.36, 1.46), draw(0.15, 0.18), draw(0.8, 0.9)
    top, front, edge = high + neck, -half, 0.04
    bouts = [(0, 0), (0.34, 0.02), (0.57, 0.14), (0.61, 0.3), (0.52, 0.42), (0.54, 0.46)]
    waist = [(0.54, 0.46), (0.39, 0.5), (0.34, 0.59), (0.37, 0.69), (0.48, 0.73)]
    upper = [(0.48, 0.73), (0.46, 0.77), (0.5, 0.86), (0.4, 0.95), (0.2, 0.99), (0, 1)]
    right = [*smooth_curve(bouts), *smooth_curve(waist), *smooth_curve(upper)]
    side = [(max(u * wide - edge, 0), edge + v * (high - 2 * edge)) for u, v in right]
    tail = mirrored([(0.08, -0.02), (0.13, high * 0.27)])
    hole = capsule((0.4, front, high * 0.34), (0.28, front, high * 0.51), 0.07)
    low, x, y = high * 0.63, 0.36, front - 0.04
    pegs = (tube((-x, y, top - v), (x, y, top - v), 0.08, 0.02) for v in (0.64, 0.31))
    return {
        "body": grown(prism(mirrored(side), 1, half - edge), edge),
        "neck": join(
            box((0, front - 0.04, (low + top) / 2), (0.11, 0.12, (top - low) / 2), 0.02),
            tube((-0.15, front - 0.02, top + 0.06), (0.15, front - 0.02, top + 0.06), 0.19, 0.04),
            prism(tail, 1, 0.1, front),
        ),
        "holes": both(hole),
        "bridge": box((0, front - 0.05, high * 0.43), (0.13, 0.14, 0.07), 0.02),
        "pegs": join(*pegs),
        "chinrest": egg((-0.43, front, 0.13), (0.2, 0.13, 0.15)),
    }


def harp(draw: Draw) -> Parts:
    """Its pillar at the left, its neck above, its sound box slanting down from the right."""
    high, reach, foot = draw(2.2, 2.4), draw(0.66, 0.76), draw(0.34, 0.4)
    left, low, dip = -0.72, 0.22, draw(0.24, 0.32)
    right = left + 2 * reach
    top = high * 0.86
    thick = 0.12
    neck = [
        (left - 0.06, high),
        (left + reach * 0.5, high - dip),
        (right - reach * 0.5, top - 0.06),
    ]
    neck += [(right + 0.16, top + 0.02)]
    line = smooth_curve(neck, 4)
    slab = [*((a, b + 0.11) for a, b in line), *((a, b - 0.13) for a, b in reversed(line))]
    chest = [(left + 0.1, low), (left + 0.52, low), (right + 0.26, top), (right - 0.08, top)]
    strings = []
    for k in range(5):
        x = left + 0.27 + (2 * reach - 0.42) * (k + 0.2) / 5
        # Where the sound box's upper side is below x.
        z = low + (top - low) * (x - left - 0.16) / (right - left - 0.18)
        strings.append(tube((x, 0, max(z, low)), (x, 0, top + 0.02), 0.055))
    return {
        "body": prism(chest, 1, draw(0.2, 0.26)),
        "neck": prism(slab, 1, thick + 0.03),
        "pillar": join(
            lathe([(0.1, low), (0.1, high - 0.1)], 0.02, (left, 0)),
            *(lathe([(0.17, v), (0.17, v + 0.12)], 0.02, (left, 0)) for v in (0.36, high - 0.2)),
        ),
        "strings": join(*strings),
        "base": box((left + 0.28, 0, low / 2 + 0.02), (0.46, foot * 0.9, low / 2 + 0.02), 0.04),
        "crown": lathe(
            smooth_curve([(0.12, high - 0.02), (0.2, high + 0.14), (0.06, high + 0.26)]),
            0.02,
            (left, 0),
        ),
    }


INSTRUMENTS_WITH_STRINGS = {
    "guitar": guitar,
    "electric guitar": electric_guitar,
    "banjo": banjo,
    "ukulele": ukulele,
    "violin": violin,
    "harp": harp,
}
