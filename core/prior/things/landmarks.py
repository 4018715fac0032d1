"""Landmarks, and what stands at a street."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    join,
    lathe,
    moved,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
)


def bridge(draw: Draw) -> Parts:
    """Of stone, along x, its road over one arch or two."""
    long, y, low, hump = 1.5, draw(0.38, 0.5), draw(0.68, 0.8), draw(0.18, 0.36)
    xs = [long * (k / 6 - 1) for k in range(13)]
    rise = [low + hump * math.cos(x / long * math.pi / 2) for x in xs]
    top = list(zip(xs, rise, strict=True))
    count = 1 + draw.which(2)
    spans = (((0.0, 0.8),), ((-0.62, 0.48), (0.62, 0.48)))
    # One span is a flat arch: the middle of its circle is below the ground.
    down = 0.16 if count == 1 else 0.0
    holes = [
        tube((x, -1, r * 0.15 - down), (x, 1, r * 0.15 - down), r + down / 2)
        for x, r in spans[count - 1]
    ]
    wall = [*((x, z - 0.05) for x, z in top), *((x, z + 0.2) for x, z in reversed(top))]
    posts = box((long - 0.1, y - 0.09, low / 2 + 0.16), (0.14, 0.15, low / 2 + 0.16), 0.02)
    return {
        "body": cut(prism([*top, (long, 0), (-long, 0)], 1, y), *holes),
        "walls": join(*(prism(wall, 1, 0.1, side * (y - 0.07)) for side in (-1, 1))),
        "road": prism(
            [*((x, z - 0.1) for x, z in top), *((x, z + 0.03) for x, z in top[::-1])], 1, y - 0.1
        ),
        "posts": both(posts, 0, 1),
    }


def windmill(draw: Draw) -> Parts:
    """A tapered tower with a cap, its four sails to the front."""
    low, top, high = draw(0.52, 0.62), draw(0.34, 0.4), draw(1.55, 1.72)
    reach, wide, z, y = draw(1.08, 1.2), draw(0.19, 0.24), high + 0.12, -low - 0.3
    sail = box((reach * 0.62, 0.0, 0), (reach * 0.38, 0.085, wide * 1.1))
    spar = box((reach * 0.5, -0.03, 0), (reach * 0.5, 0.1, 0.08))
    sails, spars = (
        moved(join(*(turned(part, 1, 45 + 90 * k) for k in range(4))), (0, y, z))
        for part in (sail, spar)
    )
    level = lathe([(low * 1.14, 0.0), (low * 1.08, high * 0.24)], 0.03)
    pane = box((0, -(low * 0.45 + top * 0.55), high * 0.55), (0.12, 0.08, 0.15), 0.02)
    return {
        "walls": lathe([(low, 0.1), (top, high)], 0.01),
        "roof": lathe(
            smooth_curve([(top + 0.1, high), (top * 0.85, high + 0.28), (0.05, high + 0.5)]), 0.03
        ),
        "sails": sails,
        "spars": join(spars, tube((0, y - 0.16, z), (0, 0, z), 0.13, 0.03)),
        "base": level,
        "door": box((0, -low * 1.02, 0.27), (0.18, 0.11, 0.27), 0.03),
        "windows": pane,
    }


def _merlons(x: float, y: float, z: float, *places: tuple[float, float]) -> Solid:
    """Blocks of half sizes x, y on a wall that ends at z, mirrored to all four sides."""
    return both(join(*(box((a, b, z + 0.08), (x, y, 0.2)) for a, b in places)), 0, 1)


def castle(draw: Draw) -> Parts:
    """Walls between four round towers, a gate in front, a keep within."""
    half, wall, r, high = draw(0.95, 1.02), draw(0.66, 0.76), draw(0.3, 0.34), draw(1.15, 1.28)
    keep, top, gate = draw(0.42, 0.48), draw(1.6, 1.78), draw(0.38, 0.42)
    spire, front, arch = draw(0.62, 0.76), -half - 0.3, draw(0.21, 0.25)
    tower = tube((half, half, 0), (half, half, high), r)
    crown = tube((half, half, high - 0.2), (half, half, high + 0.04), r + 0.08)
    over, corner = wall + 0.26, keep - 0.13
    opening = join(
        box((0, front, 0.18), (arch, 0.06, 0.18)),
        tube((0, front - 0.06, 0.36), (0, front + 0.06, 0.36), arch),
    )
    pane = box((half, half + r - 0.06, high * 0.6), (0.12, 0.1, 0.17))
    return {
        "walls": join(
            box((0, 0, wall / 2), (half, half, wall / 2)),
            _merlons(0.12, 0.16, wall, (0.25, half - 0.16)),
            _merlons(0.16, 0.12, wall, (half - 0.16, 0.25)),
            box((0, 0, top / 2), (keep, keep, top / 2)),
            _merlons(0.13, 0.13, top, (corner, corner)),
            both(join(tower, crown), 0, 1),
            box((0, (front - keep) / 2, over / 2), (gate, (-front - keep) / 2, over / 2)),
            both(box((gate - 0.12, front + 0.17, over + 0.08), (0.12, 0.17, 0.2))),
        ),
        "roof": both(lathe([(r + 0.18, high), (0.04, high + spire)], 0.03, (half, half)), 0, 1),
        "door": opening,
        "windows": join(both(pane, 0, 1), both(box((0, keep, top - 0.3), (0.13, 0.05, 0.18)), 1)),
    }


def fountain(draw: Draw) -> Parts:
    """A round pool with a column, a bowl on it, and water that falls from its rim."""
    r, rim, bowl, high = draw(1.1, 1.3), draw(0.34, 0.42), draw(0.56, 0.68), draw(1.1, 1.3)
    side = smooth_curve([(r * 0.9, 0.1), (r, rim * 0.6), (r * 0.98, rim)])
    shell = smooth_curve([(0.2, high - 0.3), (bowl * 0.72, high - 0.18), (bowl, high + 0.08)])
    out = bowl + draw(0.06, 0.16)
    fall = join(
        capsule((bowl - 0.12, 0, high + 0.06), (out, 0, high + 0.02), 0.08),
        capsule((out, 0, high + 0.02), (out + 0.08, 0, high - 0.2), 0.08),
        capsule((out + 0.08, 0, high - 0.2), (out + 0.12, 0, rim - 0.1), 0.08),
    )
    jet = taper((0, 0, high), (0, 0, high + draw(0.4, 0.6)), 0.17, 0.09)
    return {
        "basin": join(
            cut(lathe([(r * 0.9, 0), *side], 0.03), tube((0, 0, rim - 0.16), (0, 0, 3), r - 0.17)),
            tube((0, 0, 0), (0, 0, 0.13), r * 1.06, 0.03),
        ),
        "column": lathe([(0.34, 0.1), (0.3, 0.4), (0.17, 0.62), (0.16, high)], 0.02),
        "bowl": lathe(shell, 0.03),
        "water": join(
            tube((0, 0, 0.14), (0, 0, rim - 0.07), r - 0.1),
            tube((0, 0, high - 0.06), (0, 0, high + 0.11), bowl - 0.09),
            around(5 + draw.chance(0.5), fall, 20),
            jet,
        ),
    }


def pyramid(draw: Draw) -> Parts:
    """Smooth as at Giza, or stepped, with stairs up the front."""
    half, high = draw(1.15, 1.3), draw(1.35, 1.65)
    if draw.chance(0.65):
        tip, door = draw(0.2, 0.28), draw(0.13, 0.17)
        y = -half + 0.12
        return {
            "body": around(4, prism([(0, 0), (half, 0), (0, high)], 1, 2)),
            "top": around(
                4,
                prism(
                    [
                        (0, high * (1 - tip)),
                        (half * tip + 0.03, high * (1 - tip)),
                        (0, high + 0.05),
                    ],
                    1,
                    2,
                ),
            ),
            "door": box((0, y, door), (door, 0.16, door)),
        }
    steps, shrine = 5 + draw.which(2), draw(0.26, 0.32)
    levels = [
        box((0, 0, high * (k + 0.5) / steps), (s, s, high / steps / 2 + 0.01), 0.02)
        for k in range(steps)
        for s in (half - (half - shrine - 0.1) * k / (steps - 1),)
    ]
    ramp = [(-half - 0.16, 0), (-shrine - 0.02, high), (0, high), (0, 0)]
    top = high + 0.4
    return {
        "body": join(*levels),
        "top": join(
            box((0, 0, high + 0.14), (shrine, shrine, 0.18)),
            box((0, 0, top), (shrine + 0.08, shrine + 0.08, 0.09), 0.02),
        ),
        "door": box((0, -shrine, high + 0.14), (0.12, 0.06, 0.16)),
        "stairs": prism(ramp, 0, draw(0.2, 0.26)),
    }


def pagoda(draw: Draw) -> Parts:
    """Storeys with wide roofs whose corners turn up, a spire on top."""
    count = 3 + draw.chance(0.4)
    room, step, over = draw(0.6, 0.68), draw(2.15, 2.35) / count, draw(0.27, 0.33)
    shrink = draw(0.1, 0.14)
    walls, roofs, panes = [], [], []
    for k in range(count):
        r, z = room - shrink * k, 0.16 + step * k
        eave = z + step * 0.62
        side = [(r + over, eave - 0.05), (r + over, eave + 0.08), (r, eave + 0.17)]
        side += [(r * 0.74, eave + step * 0.42), (0, eave + step * 0.42), (0, eave - 0.05)]
        corner = (r + over) * 2**0.5
        tips = taper((corner - 0.24, 0, eave + 0.04), (corner + 0.08, 0, eave + 0.2), 0.11, 0.07)
        walls.append(box((0, 0, z + step / 2), (r, r, step / 2)))
        roofs += [around(4, prism(side, 1, 2)), around(4, tips, 45)]
        panes.append(both(box((r * 0.52, r, z + step * 0.32), (r * 0.2, 0.05, step * 0.17)), 0, 1))
        panes.append(both(box((r, 0, z + step * 0.32), (0.05, r * 0.3, step * 0.17)), 0))
    top = 0.16 + step * count
    knobs = [ball((0, 0, top + h), 0.12) for h in (0.12, 0.3)]
    return {
        "walls": join(*walls),
        "roof": join(*roofs),
        "spire": join(taper((0, 0, top - 0.2), (0, 0, top + draw(0.42, 0.52)), 0.11, 0.08), *knobs),
        "base": join(
            box((0, 0, 0.09), (room + 0.24, room + 0.24, 0.09), 0.02),
            box((0, -room - 0.24, 0.05), (0.26, 0.18, 0.05)),
        ),
        "door": box((0, -room, 0.16 + step * 0.26), (room * 0.24, 0.07, step * 0.26)),
        "windows": join(*panes),
    }


def traffic_light(draw: Draw) -> Parts:
    """A case with three lights under hoods, on a post."""
    x, y, r, post = draw(0.32, 0.38), draw(0.22, 0.28), draw(0.19, 0.22), draw(0.7, 1.3)
    pitch = 2 * r + 0.12
    low = post + pitch / 2 + 0.08
    lamps = [
        tube((0, -y - 0.05, low + pitch * k), (0, 0, low + pitch * k), r, 0.03) for k in range(3)
    ]
    # A hood is the upper half of a short pipe.
    pipe = cut(
        tube((0, -y - 0.26, 0), (0, -y + 0.05, 0), r + 0.08),
        tube((0, -2, 0), (0, -y, 0), r - 0.01),
        box((0, -y - 0.2, -1.02), (1, 1, 1)),
    )
    middle = (post + low + 2.5 * pitch + 0.08) / 2
    return {
        "body": box((0, 0, middle), (x, y, middle - post), draw(0.04, 0.12)),
        "reds": lamps[2],
        "yellows": lamps[1],
        "greens": lamps[0],
        "hoods": join(*(moved(pipe, (0, 0, low + pitch * k)) for k in range(3))),
        "pole": join(
            tube((0, 0, 0.05), (0, 0, post + 0.1), 0.1),
            tube((0, 0, 2 * middle - post - 0.05), (0, 0, 2 * middle - post + 0.09), 0.13, 0.03),
        ),
        "base": lathe([(0.3, 0.0), (0.3, 0.1), (0.16, 0.22)], 0.02),
    }


def fire_hydrant(draw: Draw) -> Parts:
    """A post with a dome, two outlets at its sides and one in front."""
    r, high = draw(0.34, 0.4), draw(1.15, 1.35)
    z, front, small = high * draw(0.62, 0.67), draw(0.18, 0.21), draw(0.15, 0.18)
    dome = smooth_curve([(r + 0.06, high + 0.02), (r * 0.86, high + 0.26), (0.13, high + 0.42)])
    side = tube((0, 0, z), (r + 0.2, 0, z), small)
    return {
        "body": lathe([(r + 0.02, 0.1), (r, high)], 0.01),
        "dome": lathe(dome, 0.02),
        "rings": join(
            tube((0, 0, high - 0.1), (0, 0, high + 0.05), r + 0.13, 0.03),
            tube((0, 0, 0.0), (0, 0, 0.17), r + 0.2, 0.04),
            tube((0, 0, 0.14), (0, 0, 0.3), r + 0.1, 0.03),
        ),
        "outlets": join(both(side), tube((0, -r - 0.14, z - 0.1), (0, 0, z - 0.1), front)),
        "caps": join(
            both(tube((r + 0.12, 0, z), (r + 0.3, 0, z), small + 0.08, 0.03)),
            both(tube((r + 0.2, 0, z), (r + 0.42, 0, z), 0.09, 0.02)),
            tube((0, -r - 0.24, z - 0.1), (0, -r - 0.06, z - 0.1), front + 0.07, 0.03),
            tube((0, -r - 0.36, z - 0.1), (0, -r - 0.1, z - 0.1), 0.1, 0.02),
            tube((0, 0, high + 0.3), (0, 0, high + 0.56), 0.12, 0.03),
        ),
    }


def traffic_cone(draw: Draw) -> Parts:
    """On a square foot, with one or two white stripes."""
    low, top, high, foot = draw(0.46, 0.54), draw(0.12, 0.15), draw(1.5, 1.75), draw(0.66, 0.76)
    foot_z, two = 0.17, draw.chance(0.6)

    def radius(z: float) -> float:
        return low + (top - low) * (z - foot_z) / (high - foot_z)

    def stripe(share: float, wide: float) -> Solid:
        a, b = high * (share - wide), high * (share + wide)
        return lathe([(radius(a) + 0.05, a), (radius(b) + 0.05, b)], 0.02)

    return {
        "body": join(
            lathe([(low + 0.1, foot_z - 0.03), (low, foot_z + 0.06), (top, high)], 0.01),
            tube((0, 0, high - 0.1), (0, 0, high + 0.03), top + 0.02, 0.03),
        ),
        "stripes": join(stripe(0.36, 0.1), stripe(0.7, 0.09)) if two else stripe(0.55, 0.13),
        "base": box((0, 0, foot_z / 2), (foot, foot, foot_z / 2), 0.05),
    }


LANDMARKS = {
    "bridge": bridge,
    "windmill": windmill,
    "castle": castle,
    "fountain": fountain,
    "pyramid": pyramid,
    "pagoda": pagoda,
    "traffic light": traffic_light,
    "fire hydrant": fire_hydrant,
    "traffic cone": traffic_cone,
}
