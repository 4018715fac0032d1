"""Castles, towers, temples and a pyramid."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
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


def tower(draw: Draw) -> Parts:
    """A castle's round tower with six battlements."""
    radius, high, rise = draw(0.5, 0.6), draw(1.55, 1.85), draw(0.26, 0.34)
    rim, deck = radius + 0.16, high + 0.3
    slit = box((0, 0.05 - radius, high * 0.66), (0.1, 0.1, 0.2))
    side = [(radius + 0.1, 0), (radius + 0.1, 0.2), (radius, 0.2), (radius, high), (rim, high)]
    return {
        "walls": lathe([*side, (rim, deck)]),
        "door": join(
            box((0, 0.02 - radius, 0.25), (0.22, 0.16, 0.25)),
            tube((0, -radius - 0.14, 0.5), (0, -radius + 0.18, 0.5), 0.22),
        ),
        "windows": join(slit, both(turned(slit, 2, 90))),
        "battlements": around(6, box((rim - 0.13, 0, deck + rise / 2), (0.13, 0.2, rise / 2)), -90),
    }


def lighthouse(draw: Draw) -> Parts:
    """A tapered tower with a gallery and a lantern."""
    low, high, top = draw(0.46, 0.54), draw(1.55, 1.8), draw(0.3, 0.34)
    shape = [(low, 0.1), (top + 0.04, high * 0.6), (top, high)]
    return {
        "tower": lathe(shape, 0.01),
        "lantern": tube((0, 0, high + 0.1), (0, 0, high + 0.48), top * 0.72),
        "roof": lathe([(top + 0.06, high + 0.45), (0.02, high + 0.45 + draw(0.3, 0.4))], 0.04),
        "base": join(
            tube((0, 0, 0), (0, 0, 0.16), draw(0.66, 0.76), 0.04),
            tube((0, 0, high - 0.03), (0, 0, high + 0.14), top + 0.18, 0.03),
        ),
        "door": box((0, -low, 0.4), (0.15, 0.13, 0.25), 0.02),
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


def temple(draw: Draw) -> Parts:
    """Greek: steps, columns around, a beam and a gabled roof."""
    x, y, high = draw(0.84, 0.92), draw(1.08, 1.16), draw(0.88, 1.02)
    r, gable, step = draw(0.13, 0.155), draw(0.4, 0.5), 0.13
    low = 2 * step
    top, beam = low + high, 0.2
    across, along = [-x, -x / 3, x / 3, x], [-y, -y / 2, 0, y / 2, y]
    places = [(u, v) for u in across for v in along if abs(u) == x or abs(v) == y]
    columns = []
    for u, v in places:
        shaft = [(r * 1.08, low), (r * 0.86, top - 0.08), (r * 1.25, top - 0.02)]
        columns += [lathe(shaft, 0, (u, v)), box((u, v, top - 0.05), (r * 1.3, r * 1.3, 0.06))]
    wide, deep, eave = x + 0.26, y + 0.26, top + beam
    roof = [(-wide - 0.06, eave - 0.02), (wide + 0.06, eave - 0.02), (wide + 0.06, eave + 0.06)]
    roof += [(0, eave + gable + 0.14), (-wide - 0.06, eave + 0.06)]
    hall = y - 0.42
    return {
        "base": join(
            *(
                box((0, 0, step * (k + 0.5)), (x + d, y + d, step / 2 + 0.005))
                for k, d in enumerate((0.42, 0.26))
            )
        ),
        "columns": join(*columns),
        "walls": box((0, 0, low + high / 2), (x - 0.36, hall, high / 2 + 0.02)),
        "beam": join(
            box((0, 0, top + beam / 2), (x + 0.19, y + 0.19, beam / 2)),
            prism([(-wide + 0.1, eave), (wide - 0.1, eave), (0, eave + gable)], 1, deep + 0.03),
        ),
        "roof": prism(roof, 1, deep - 0.04),
        "door": box((0, -hall, low + high * 0.36), (x * 0.22, 0.06, high * 0.36)),
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


def gazebo(draw: Draw) -> Parts:
    """Six posts with rails between on a floor, open in front, a pointed roof."""
    r, high, rise = draw(0.95, 1.08), draw(1.0, 1.15), draw(0.55, 0.7)
    over, low, post, rail = draw(0.2, 0.28), 0.2, 0.095, draw(0.4, 0.48)
    flat, eave = r * math.cos(math.pi / 6), low + high
    tip = eave + rise
    cap = [(0, eave), (flat + over, eave), (flat + over, eave + 0.1), (0.06, tip), (0, tip)]
    bars = join(
        box((flat, 0, low + rail), (0.085, r / 2, 0.075)),
        box((flat, 0, low + rail * 0.4), (0.06, r / 2, 0.065)),
    )
    step = [(-0.34, 0), (-0.34, low * 0.5), (-0.16, low * 0.5), (-0.16, low), (0, low), (0, 0)]
    front = flat + 0.14
    return {
        "base": join(
            around(6, box((0, 0, low / 2), (front, 2, low / 2)), -90),
            prism([(u - front + 0.02, v) for u, v in step], 0, r * 0.32),
        ),
        "posts": around(6, tube((r - 0.06, 0, low), (r - 0.06, 0, eave + 0.02), post), 0),
        "rails": cut(
            around(6, bars, -90), box((0, -1.5, low + 0.5), (r / 2 - post - 0.02, 1.2, 0.6))
        ),
        "roof": around(6, prism(cap, 1, 2), -90),
        "beam": cut(
            around(6, box((0, 0, eave - 0.06), (flat + 0.06, 2, 0.1)), -90),
            around(6, box((0, 0, eave - 0.1), (flat - 0.12, 2, 0.12)), -90),
        ),
        "finial": join(
            tube((0, 0, tip - 0.12), (0, 0, tip + 0.12), 0.09), ball((0, 0, tip + 0.18), 0.14)
        ),
    }


def _merlon_ring(count: int, r: float, z: float) -> Solid:
    return around(count, box((r - 0.08, 0, z), (0.09, 0.085, 0.1)))


def sandcastle(draw: Draw) -> Parts:
    """Round towers with battlements, two with cones, a keep with a flag, a gate, on a heap."""
    wide, r, high = draw(0.66, 0.74), draw(0.25, 0.29), draw(0.72, 0.86)
    keep, tall, heap = draw(0.33, 0.37), draw(1.1, 1.25), 0.18
    tower = lathe([(r * 1.16, 0), (r, high)], 0.0, (wide, wide))
    crown = moved(_merlon_ring(5, r + 0.03, high + 0.06), (wide, wide, 0))
    cone = lathe([(r * 1.3, high), (r * 1.3, high + 0.08), (0.05, high + 0.56)], 0.02, (wide, wide))
    curtain = box((0, wide, 0.24), (wide, 0.13, 0.26))
    teeth = [box((u, wide, 0.52), (0.085, 0.13, 0.1)) for u in (0.0, 0.34)]
    walls = join(curtain, both(join(*teeth)))
    back = both(cut(cone, box((0, 0, high - 1), (3, 3, 1))))
    top = high + tall - 0.7
    flag = [(0.02, top + 0.52), (0.46, top + 0.4), (0.02, top + 0.26)]
    return {
        "towers": moved(
            join(
                both(tower, 0, 1),
                *(turned(walls, 2, 90 * k) for k in range(4)),
                both(moved(crown, (0, -2 * wide, 0))),
                lathe([(keep * 1.14, 0), (keep, top)]),
                _merlon_ring(6, keep + 0.03, top + 0.06),
            ),
            (0, 0, heap),
        ),
        "cones": moved(back, (0, 0, heap)),
        "gate": moved(
            join(
                box((0, -wide - 0.1, 0.12), (0.16, 0.07, 0.14)),
                tube((0, -wide - 0.17, 0.26), (0, -wide - 0.03, 0.26), 0.16),
            ),
            (0, 0, heap),
        ),
        "heap": lathe([(wide * 2.0, 0), (wide * 1.72, heap)], 0.03),
        "flag": moved(
            join(prism(flag, 1, 0.075), tube((0, 0, top - 0.1), (0, 0, top + 0.54), 0.075)),
            (0, 0, heap),
        ),
    }


LANDMARKS_BUILDINGS = {
    "castle": castle,
    "tower": tower,
    "lighthouse": lighthouse,
    "windmill": windmill,
    "temple": temple,
    "pagoda": pagoda,
    "pyramid": pyramid,
    "gazebo": gazebo,
    "sandcastle": sandcastle,
}
