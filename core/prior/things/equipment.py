"""What an office, a clinic, a bank and a workshop are equipped with."""

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
    egg,
    grown,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)


def computer_mouse(draw: Draw) -> Parts:
    """A domed body with two buttons and a wheel at the front, and a fat cable that bends away."""
    wide, long, high = draw(0.54, 0.62), draw(0.92, 1.02), draw(0.6, 0.7)
    reach, side = draw(0.4, 0.5), 1 - 2 * draw.which(2)
    floor = box((0, 0, -0.9), (3, 3, 1))
    split, seam = draw(-0.16, -0.02), 0.075

    def dome(grow: float) -> Solid:
        return egg((0, 0, 0.1), (wide + grow, long + grow, high - 0.1 + grow))

    half = box((1 + seam, split - 1, 1.16 + high * 0.24), (1, 1, 1))
    y = -long * 0.6
    z = 0.1 + (high - 0.1) * 0.8
    path = [(0, -long + 0.06), (0, -long - 0.24), (0.1, -long - reach * 0.8)]
    path += [(0.34, -long - reach), (0.62, -long - reach + 0.04)]
    return {
        "body": cut(dome(0.0), floor),
        "buttons": both(within(dome(0.06), half)),
        "wheel": tube((-0.1, y, z - 0.03), (0.1, y, z - 0.03), 0.22, 0.04),
        "base": cut(within(dome(0.04), box((0, 0, 0.12), (2, 2, 0.08))), floor),
        "cable": limb([(side * u, v, 0.17) for u, v in smooth_curve(path, 3)], 0.085, 0.085),
        "logo": within(dome(0.05), tube((0, long * 0.4, 0), (0, long * 0.4, 2), 0.15)),
    }


def vr_headset(draw: Draw) -> Parts:
    """A visor with cameras, foam behind it, and straps round where a head would be."""
    r, wide, high = draw(0.78, 0.86), draw(0.8, 0.9), draw(0.36, 0.42)
    z, deep, band = draw(0.62, 0.7), draw(0.2, 0.25), draw(0.15, 0.19)
    inner, y = r - 0.14, -r - deep * 0.5
    front = y - deep
    nose = tube((0, -3, z - high - 0.1), (0, 0, z - high - 0.1), 0.26)
    hollow = tube((0, 0, -1), (0, 0, 3), inner)
    round_head = cut(tube((0, 0, z - band), (0, 0, z + band), r, 0.03), hollow)
    over = cut(
        tube((-band, 0, z), (band, 0, z), r + 0.08, 0.03),
        tube((-1, 0, z), (1, 0, z), inner + 0.08),
        box((0, 0, z - 2), (2, 2, 2)),
    )
    lens = tube((wide * 0.6, front - 0.12, z), (wide * 0.6, y, z), 0.17, 0.03)
    return {
        "visor": cut(box((0, y, z), (wide, deep, high), 0.14), nose),
        "foam": cut(
            box((0, y + deep + 0.12, z), (wide * 0.86, 0.2, high * 0.86), 0.08), hollow, nose
        ),
        "straps": join(round_head, over),
        "plate": cut(box((0, front, z), (wide * 0.92, 0.06, high * 0.78), 0.05), nose),
        "cameras": both(join(lens, ball((wide * 0.6, front - 0.1, z), 0.1))),
        "pads": join(
            box((0, r, z), (0.32, 0.13, 0.26), 0.08),
            both(box((r - 0.02, -r * 0.3, z), (0.1, 0.3, band + 0.06), 0.05)),
            box((0, r * 0.1, z + r + 0.05), (band + 0.07, 0.24, 0.1), 0.05),
        ),
    }


def server_rack(draw: Draw) -> Parts:
    """An open cabinet with rows of units, each with drives and lights; vents in its sides."""
    wide, deep, high = draw(0.62, 0.72), draw(0.56, 0.68), draw(2.1, 2.36)
    rows, wall, layout = 4, 0.13, draw.arranged(3)
    step = (high - 0.3 - wall) / rows
    half, x = step / 2 - 0.045, wide - wall
    units, drives, lights, lamps = [], [], [], []
    for k in range(rows):
        z = 0.3 + step * (k + 0.5)
        units.append(box((0, 0, z), (x - 0.02, deep - 0.02, half), 0.02))
        size = min(half - 0.05, 0.12)
        drives += [
            box((x - 0.14 - 0.24 * i, -deep, z), (0.08, 0.05, half - 0.05), 0.01) for i in range(2)
        ]
        on = [lights, lamps, lights] if layout(0, 1) < 0.5 else [lamps, lights, lights]
        for i in range(2):
            on[i].append(tube((0.16 - x + 0.24 * i, -1, z), (0.16 - x + 0.24 * i, 0, z), size))
    back = [box((0, deep, 0.5 + 0.36 * k), (x - 0.1, 0.05, 0.085)) for k in range(5)]
    glow = box((0, -deep, high / 2), (wide, 0.075, high))
    slats = join(*(box((wide, 0, 0.5 + 0.3 * k), (0.05, deep * 0.66, 0.075)) for k in range(3)))
    shell = cut(
        box((0, 0, high / 2 + 0.07), (wide, deep, high / 2 - 0.07), 0.03),
        box((0, -deep, high / 2 + 0.08), (x, 0.26, high / 2 - 0.07 - wall)),
    )
    foot = box((wide - 0.16, deep - 0.16, 0.1), (0.12, 0.12, 0.1))
    top = box((0, 0.05, high + 0.02), (wide * 0.6, deep * 0.6, 0.07), 0.02)
    return {
        "cabinet": join(shell, both(foot, 0, 1)),
        "units": join(*units),
        "drives": join(*drives),
        "lights": within(join(*lights), glow),
        "lamps": within(join(*lamps), glow),
        "vents": join(both(slats), top, *back),
    }


def atm(draw: Draw) -> Parts:
    """A tall case with a sloped screen, a desk of keys, notes that come out, and a sign above."""
    wide, high, deep = draw(0.62, 0.72), draw(2.1, 2.3), draw(0.46, 0.56)
    desk, front, back = high * draw(0.4, 0.44), -deep, 0.3 - deep
    case = [(front + 0.08, 0), (front + 0.08, desk - 0.34), (front - 0.22, desk - 0.14)]
    case += [(front - 0.22, desk), (front + 0.1, desk + 0.12), (back, high - 0.56)]
    case += [(front, high - 0.5), (front, high), (deep, high), (deep, 0)]
    rise = high - 0.68 - desk
    lean = -math.degrees(math.atan2(back - front - 0.1, rise))
    middle = (front + back) / 2 + 0.05, desk + 0.12 + rise / 2
    screen = box((-0.13, 0, 0), (wide - 0.26, 0.06, rise / 2 - 0.06), 0.02)
    card = box((wide - 0.15, 0, 0), (0.085, 0.09, 0.17), 0.02)
    grid = [(i * 0.21, j * 0.17) for i in (-1, 0, 1) for j in (-0.5, 0.5)]
    pad = join(*(box((u, v, 0), (0.075, 0.06, 0.07), 0.01) for u, v in grid))
    z = desk - 0.62
    mouth = box((0, front + 0.08, z), (wide * 0.7, 0.06, 0.15), 0.02)
    base, s = high - 0.41, 0.062

    def stroke(*points: tuple[float, float]) -> Solid:
        return limb([(u * wide, front - 0.07, base + v) for u, v in points], s, s)

    letters = join(
        stroke((-0.8, 0), (-0.56, 0.32), (-0.32, 0)),
        stroke((-0.66, 0.1), (-0.46, 0.1)),
        stroke((-0.26, 0.32), (0.18, 0.32)),
        stroke((-0.04, 0.32), (-0.04, 0)),
        stroke((0.28, 0), (0.3, 0.32), (0.54, 0.1), (0.78, 0.32), (0.8, 0)),
    )
    return {
        "body": prism(case, 0, wide),
        "screen": moved(turned(screen, 0, lean), (0, *middle)),
        "keys": moved(turned(pad, 0, 20.6), (-0.1, front - 0.06, desk + 0.06)),
        "panels": join(
            box((0, front, base + 0.16), (wide + 0.04, 0.07, 0.29), 0.03),
            mouth,
            moved(turned(card, 0, lean), (0, *middle)),
        ),
        "letters": letters,
        "notes": box((0, front - 0.1, z), (wide * 0.48, 0.22, 0.07)),
    }


def gumball_machine(draw: Draw) -> Parts:
    """A globe full of balls on a red foot, with a knob to turn and a flap where they come out."""
    r, high, foot = draw(0.66, 0.74), draw(0.86, 1.0), draw(0.52, 0.6)
    z, size, neck = high + r * 0.86, draw(0.17, 0.2), draw(0.4, 0.44)
    stand = [(foot, 0.0), (foot, 0.12), (neck, 0.2), (neck - 0.03, high * 0.6), (neck, high - 0.1)]
    stand += [(r * 0.76, high + 0.02), (r * 0.76, high + 0.12)]
    top = z + r
    lid = [(0.4, top - 0.12), (0.42, top - 0.02), (0.3, top + 0.1), (0.0, top + 0.16)]
    colors: list[list[Solid]] = [[], [], []]
    count, first = 58, draw.arranged(3)(0, math.tau)
    for k in range(count):
        up = 1 - 2 * (k + 0.5) / count
        if -0.74 < up < 0.8:
            flat, turn = math.sqrt(1 - up * up), first + k * math.pi * (3 - math.sqrt(5))
            x, y = flat * math.cos(turn), flat * math.sin(turn)
            colors[k % 3].append(ball((r * x, r * y, z + r * up), size))
    face, at = -neck + 0.02, high * 0.58
    bar = turned(box((0, 0, 0), (0.22, 0.14, 0.075), 0.03), 1, draw(-40, 40))
    chute = [(-0.19, 0.14), (0.19, 0.14), (0.19, at - 0.3), (-0.19, at - 0.3)]
    reds, blues, yellows = (join(*some) for some in colors)
    return {
        "base": join(lathe(stand), lathe(lid, 0.02), ball((0, 0, top + 0.2), 0.11)),
        "globe": ball((0, 0, z), r + 0.03),
        "gumballs": reds,
        "sweets": blues,
        "candies": yellows,
        "knob": join(
            tube((0, face - 0.1, at), (0, 0, at), 0.22, 0.03),
            moved(bar, (0, face - 0.12, at)),
            prism(chute, 1, 0.12, face),
        ),
    }


def satellite_dish(draw: Draw) -> Parts:
    """A bowl that looks up to the front, its receiver on arms before it, on a mast with a foot."""
    r, deep, wall = draw(0.92, 1.04), draw(0.44, 0.54), 0.17
    lean, z, large = draw(38, 50), draw(1.3, 1.5), draw.chance(0.5)
    shares = [k / 6 for k in range(7)]
    outer = [(r * s, deep * s * s - wall) for s in shares]
    inner = [(r * s, deep * s * s) for s in reversed(shares)]
    focus = draw(0.8, 0.94)
    arm = capsule((r * 0.8, 0, deep * 0.6), (0.06, 0, focus), 0.068)
    # The single arm is at the lower side; three stand evenly.
    arms = around(3, arm, -90) if large else capsule((0, -r * 0.9, 0.2), (0, 0, focus), 0.085)
    horn = join(
        tube((0, 0, focus - 0.24), (0, 0, focus + 0.2), 0.18, 0.04),
        tube((0, 0, focus - 0.26), (0, 0, focus - 0.1), 0.24, 0.03),
    )

    def aimed(solid: Solid) -> Solid:
        return tilted(solid, lean, (0, 0, z))

    tower = lathe([(0.56, 0.0), (0.56, 0.12), (0.26, 0.2), (0.2, z - 0.3)], 0.02, (0, 0.3))
    plate = box((0, 0.3, 0.08), (0.46, 0.42, 0.08), 0.02)
    pole = tube((0, 0.3, 0), (0, 0.3, z - 0.1), 0.12)
    yoke = both(box((0.24, 0.26, z - 0.22), (0.08, 0.18, 0.26), 0.03))
    return {
        "dish": aimed(lathe([*outer, *inner])),
        "rim": aimed(ring((0, 0, deep - wall / 2), r - 0.01, 0.11)),
        "receiver": aimed(horn),
        "arms": aimed(arms),
        "mast": join(tower if large else pole, aimed(tube((0, 0, -0.34), (0, 0, 0), 0.24, 0.03))),
        "foot": join(tube((0, 0.3, 0), (0, 0.3, 0.16), 0.7, 0.03), yoke) if large else plate,
    }


def stethoscope(draw: Draw) -> Parts:
    """Upright like its own sign: two ear pieces, a tube in a Y that curls up to the chest piece."""
    wide, high, fork = draw(0.44, 0.54), draw(1.9, 2.1), draw(0.92, 1.04)
    r, x, drop = 0.088, draw(0.74, 0.86), draw(0.6, 0.72)
    neck = high - 0.62
    side = [(0.0, fork - 0.04), (0.16, fork + 0.14), (wide, fork + 0.34), (wide + 0.04, neck)]
    bow = [(wide + 0.04, neck), (wide, neck + 0.3), (wide * 0.66, high - 0.1), (0.2, high)]
    tail = [(0.0, fork), (0.0, 0.46), (0.1, 0.2), (x * 0.5, 0.09), (x - 0.08, 0.22), (x, drop)]

    def bar(points: list[tuple[float, float]], radius: float) -> Solid:
        return limb([(u, 0, v) for u, v in smooth_curve(points, 3)], radius, radius)

    chest = (x, drop + 0.2)
    (u, v), disc = chest, draw(0.25, 0.3)
    return {
        "tube": join(both(bar(side, r)), bar(tail, r), ball((0, 0, fork), 0.13)),
        "ear tubes": both(bar(bow, 0.075)),
        "tips": both(egg((0.19, 0, high), (0.15, 0.13, 0.13))),
        "chest piece": join(
            tube((u, -0.13, v), (u, 0.12, v), disc, 0.03),
            tube((u, 0, drop - 0.16), (u, 0, v), 0.12),
        ),
        "disc": tube((u, -0.18, v), (u, 0, v), disc - 0.07, 0.02),
        "collars": both(
            tube((wide + 0.04, 0, neck - 0.06), (wide + 0.04, 0, neck + 0.1), 0.12, 0.02)
        ),
    }


def pliers(draw: Draw) -> Parts:
    """Open, upright: toothed jaws above a bolt, and long grips of rubber that bow out."""
    long, wide, reach = draw(0.72, 0.92), draw(0.3, 0.36), draw(0.46, 0.56)
    z, gap, y = draw(1.5, 1.64), draw(0.24, 0.32), 0.15
    tip, up = draw(0.12, 0.16), z + long
    jaw = [(0.0, z - 0.2), (wide * 0.8, z - 0.12), (wide, z + 0.12), (wide * 1.06, z + 0.32)]
    jaw += [(gap + tip, up), (gap, up), (0.06, z + 0.22), (0.0, z + 0.2)]
    high = z - 0.54
    grip = [(reach * 0.7, high), (reach, high * 0.72), (reach * 1.06, high * 0.4)]
    path = [(u, 0, v) for u, v in smooth_curve([*grip, (reach * 0.86, 0.14)], 3)]
    shares = [(k + 1) / 3.4 for k in range(3)]
    places = [(gap * share + 0.06, 0, z + 0.22 + (long - 0.22) * share) for share in shares]
    neck = [(0.1, 0, z), (0.17, 0, z - 0.26), (reach * 0.72, 0, high - 0.04)]
    return {
        "jaws": both(grown(prism(jaw, 1, y - 0.03), 0.03)),
        "handles": both(limb(path, 0.15, 0.15)),
        "necks": both(limb(neck, 0.2, 0.11)),
        "bolt": tube((0, -y - 0.08, z), (0, y + 0.08, z), 0.2, 0.03),
        "teeth": both(join(*(box(at, (0.06, y + 0.05, 0.07)) for at in places))),
        "ends": both(
            taper((reach * 0.68, 0, high + 0.04), (reach * 0.78, 0, high - 0.1), 0.2, 0.18)
        ),
    }


EQUIPMENT = {
    "computer mouse": computer_mouse,
    "vr headset": vr_headset,
    "server rack": server_rack,
    "atm": atm,
    "gumball machine": gumball_machine,
    "satellite dish": satellite_dish,
    "stethoscope": stethoscope,
    "pliers": pliers,
}
