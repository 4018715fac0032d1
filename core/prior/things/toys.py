"""Instruments, toys and games."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    grown,
    join,
    lathe,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)


def _pegs(x: float, z: float, rows: int, r: float = 0.085) -> Solid:
    pegs = (tube((-x, 0, z + 0.22 * k), (x, 0, z + 0.22 * k), r, 0.02) for k in range(rows))
    return join(*pegs)


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


def trumpet(draw: Draw) -> Parts:
    """It lies along x: the bell to the left, three valves in the middle."""
    z, gap, bell, reach = 0.6, draw(0.17, 0.22), draw(0.42, 0.52), draw(1.15, 1.35)
    flare = [(0.1, -0.1), (0.11, 0.35), (0.2, 0.62), (bell, 0.85), (bell, 0.92)]
    horn = cut(lathe(smooth_curve(flare, 4), 0.02), lathe([(0.03, 0.5), (bell * 0.86, 0.98)], 0))
    left = moved(turned(horn, 1, -90), (-reach + 0.88, 0, z + gap))
    bends = (
        cut(ring((x, 0, z), gap, 0.1, axis=1), box((x - s, 0, z), (1, 1, 2)))
        for x, s in ((0.6, 1), (-0.35, -1))
    )
    valves = (tube((x, 0, z - 0.42), (x, 0, z + 0.38), 0.13, 0.03) for x in (-0.16, 0.13, 0.42))
    caps = (
        join(
            tube((x, 0, z + 0.3), (x, 0, z + 0.58), 0.08),
            tube((x, 0, z + 0.54), (x, 0, z + 0.66), 0.13, 0.03),
        )
        for x in (-0.16, 0.13, 0.42)
    )
    pipe = join(
        capsule((-0.5, 0, z + gap), (0.6, 0, z + gap), 0.1),
        capsule((-0.35, 0, z - gap), (reach, 0, z - gap), 0.1),
    )
    parts = {
        "body": join(left, pipe, *bends),
        "valves": join(*valves),
        "buttons": join(*caps),
        "mouthpiece": taper((reach - 0.1, 0, z - gap), (reach + 0.15, 0, z - gap), 0.1, 0.17),
    }
    return {name: moved(solid, (-0.13, 0, 0)) for name, solid in parts.items()}


def saxophone(draw: Draw) -> Parts:
    """Upright: the bell turns up at the left, the mouthpiece to the right."""
    high, bend, bell = draw(1.9, 2.2), draw(0.36, 0.42), draw(0.42, 0.5)
    x, low = 0.2, 0.58
    left, mouth = x - 2 * bend, draw(1.1, 1.3)
    bow = cut(ring((x - bend, 0, low), bend, 0.2, axis=1), box((0, 0, low + 1), (2, 2, 1)))
    flare = [(0.2, low - 0.05), (0.24, low + 0.3), (bell, mouth)]
    horn = cut(
        lathe(smooth_curve(flare, 3), 0.02, (left, 0)),
        lathe([(0.08, low + 0.25), (bell - 0.1, mouth + 0.04)], 0.0, (left, 0)),
    )
    neck = join(
        capsule((x, 0, high), (x + 0.12, 0, high + 0.2), 0.1),
        capsule((x + 0.12, 0, high + 0.2), (x + 0.45, 0, high + 0.16), 0.1),
    )
    keys = (
        tube((x - 0.02, -0.26, z), (x - 0.02, 0, z), 0.12, 0.03)
        for z in (0.75, 1.02, 1.29, 1.56, 1.83)
        if z < high - 0.1
    )
    return {
        "body": join(taper((x, 0, low), (x, 0, high), 0.2, 0.11), bow, horn, neck),
        "keys": join(*keys, tube((left, -0.36, low + 0.1), (left, 0, low + 0.1), 0.14, 0.03)),
        "mouthpiece": taper((x + 0.4, 0, high + 0.16), (x + 0.68, 0, high + 0.06), 0.14, 0.09),
    }


def xylophone(draw: Draw) -> Parts:
    """Bars of falling length on two rails, with a mallet on top."""
    count, pitch, long, short = 6 + draw.which(3), 0.3, draw(0.7, 0.85), draw(0.36, 0.46)
    x = count * pitch / 2
    bars = [
        box(((k + 0.5) * pitch - x, 0, 0.3), (0.11, long + (short - long) * k / count, 0.09), 0.03)
        for k in range(count)
    ]
    slope = [(-x - 0.05, 0), (-x - 0.05, long * 0.72), (x + 0.05, short * 0.78), (x + 0.05, 0)]
    inner = [(-x + 0.15, -1), (-x + 0.15, long * 0.72 - 0.2), (x - 0.15, short * 0.78 - 0.2)]
    rail = cut(prism(slope, 2, 0.13, 0.13), prism([*inner, (x - 0.15, -1)], 2, 1))
    start, end = (-x * 0.7, -0.25, 0.46), (x * 0.5, 0.05, 0.46)
    return {
        "frame": both(rail, 1),
        "bars": join(*bars[::2]),
        "slats": join(*bars[1::2]),
        "mallet": capsule(start, end, 0.085),
        "tip": ball(end, 0.16),
    }


def rocking_horse(draw: Draw) -> Parts:
    """A wooden horse on two runners, its head to the front."""
    long, high, r = draw(0.62, 0.72), draw(1.05, 1.2), draw(0.29, 0.34)
    head = (0, -long - 0.3, high + draw(0.55, 0.7))
    bow, w = draw(1.9, 2.3), 0.32
    arc = cut(ring((w, 0, bow), bow - 0.1, 0.11, axis=0), box((0, 0, bow + 0.5), (3, 3, bow)))
    legs = both(
        join(
            capsule((0.2, -long * 0.7, high - 0.1), (w, -long * 0.95, 0.25), 0.12),
            capsule((0.2, long * 0.7, high - 0.1), (w, long * 0.95, 0.25), 0.12),
        )
    )
    body = blend(
        0.12,
        egg((0, 0, high), (r, long + 0.15, r)),
        taper((0, -long * 0.7, high + 0.05), head, r * 0.8, 0.2),
        taper(head, (0, head[1] - 0.34, head[2] - 0.2), 0.21, 0.14),
    )
    mane = join(
        capsule((0, head[1] + 0.14, head[2] + 0.16), (0, -long * 0.62, high + 0.38), 0.13),
        both(
            taper((0.1, head[1] + 0.05, head[2] + 0.14), (0.13, head[1], head[2] + 0.34), 0.1, 0.05)
        ),
    )
    return {
        "body": join(body, legs),
        "mane": mane,
        "tail": taper((0, long, high + 0.12), (0, long + 0.35, high - 0.3), 0.15, 0.09),
        "saddle": cut(
            egg((0, 0.02, high + 0.06), (r + 0.05, 0.3, r + 0.06)),
            box((0, 0, high - 1.1), (2, 2, 1)),
        ),
        "rockers": join(
            both(arc), *(box((0, s * long * 0.6, 0.18 + 0.03), (w, 0.1, 0.09)) for s in (-1, 1))
        ),
        "eyes": both(ball((0.17, head[1] - 0.08, head[2] + 0.06), 0.07)),
    }


def spinning_top(draw: Draw) -> Parts:
    """A top on its point."""
    wide, low, high, stem = draw(0.75, 0.95), draw(0.65, 0.85), draw(0.35, 0.5), draw(0.45, 0.65)
    top = low + high
    shape = [(0.14, 0.2), (wide * 0.55, low * 0.6), (wide, low), (wide * 0.6, low + high * 0.7)]
    return {
        "body": lathe(smooth_curve([*shape, (0.12, top)], 4), 0.02),
        "stripe": tube((0, 0, low - 0.1), (0, 0, low + 0.1), wide + 0.05, 0.05),
        "stem": join(
            tube((0, 0, top - 0.1), (0, 0, top + stem), 0.11), ball((0, 0, top + stem), 0.17)
        ),
        "tip": lathe([(0.02, 0.0), (0.18, 0.32)], 0.04),
    }


def lego_brick(draw: Draw) -> Parts:
    """A building brick, two studs deep, and four wide or two."""
    across = 4 if draw.chance(0.7) else 2
    pitch, high = 0.6, draw(0.66, 0.76)
    x, y = across * pitch / 2, pitch
    studs = (
        tube(
            ((k + 0.5) * pitch - x, s * pitch / 2, high - 0.1),
            ((k + 0.5) * pitch - x, s * pitch / 2, high + 0.15),
            0.19,
            0.02,
        )
        for k in range(across)
        for s in (-1, 1)
    )
    return {
        "body": box((0, 0, high / 2), (x - 0.01, y - 0.01, high / 2), 0.02),
        "studs": join(*studs),
    }


def puzzle_cube(draw: Draw) -> Parts:
    """A cube of three by three by three with coloured stickers, solved or not."""
    size, half, pitch = 0.96, draw(0.2, 0.22), 0.63
    solved, layout = draw.chance(0.4), draw.arranged(2)
    faces: list[list[Solid]] = [[] for _ in range(5)]
    for side in range(6):
        axis, sign = side // 2, 1 if side % 2 else -1
        for a in (-1, 0, 1):
            for b in (-1, 0, 1):
                center = [a * pitch, b * pitch]
                center.insert(axis, sign * size)
                halves = [half, half]
                halves.insert(axis, 0.05)
                by_chance = layout.which(5)
                color = min(side, 4) if solved or a == b == 0 else by_chance
                faces[color].append(box(tuple(center), tuple(halves), 0.02))
    names = ("reds", "blues", "greens", "whites", "yellows")
    parts = {"body": box((0, 0, 0), (size, size, size), 0.08)}
    parts |= {name: join(*face) for name, face in zip(names, faces, strict=True)}
    return {name: moved(part, (0, 0, 1)) for name, part in parts.items()}


def basketball_hoop(draw: Draw) -> Parts:
    """A board with its ring and net on a pole."""
    x, half, z, r = draw(0.75, 0.9), draw(0.46, 0.55), draw(2.2, 2.4), draw(0.34, 0.4)
    low, y = z - half * 0.6, -0.2
    front = y - 0.1 - r
    net = cut(
        lathe([(r * 0.55, low - 0.55), (r + 0.02, low)], 0.02, (0, front)),
        lathe([(r * 0.55 - 0.11, low - 0.7), (r - 0.1, low + 0.1)], 0, (0, front)),
    )
    slots = around(8, box((0.3, 0, 0), (0.4, 0.045, 0.2), 0.02), 22.5)
    net = cut(net, moved(slots, (0, front, low - 0.25)))
    return {
        "board": box((0, y, z), (x, 0.1, half), 0.02),
        "ring": join(
            ring((0, front, low), r, 0.09), box((0, y - 0.08, low), (0.14, 0.12, 0.1), 0.02)
        ),
        "net": net,
        "pole": join(
            capsule((0, 0.35, 0.1), (0, 0.35, z - 0.35), 0.13),
            capsule((0, 0.35, z - 0.35), (0, y, z), 0.12),
            box((0, 0.3, 0.08), (0.55, 0.5, 0.1), 0.04),
        ),
        "square": cut(
            box((0, y - 0.02, z + 0.02), (x * 0.42, 0.11, half * 0.5)),
            box((0, y, z + 0.02), (x * 0.42 - 0.1, 1, half * 0.5 - 0.1)),
        ),
    }


def slide(draw: Draw) -> Parts:
    """A playground slide: it runs down to the front, the ladder stands at the back."""
    high, w, back, front = draw(1.3, 1.6), draw(0.34, 0.42), draw(0.65, 0.8), -draw(1.15, 1.35)
    top = [(back, high), (back * 0.45, high), (front * 0.7, 0.24), (front, 0.18)]
    line = smooth_curve(top, 4)
    sheet = prism([*line, *((u, v - 0.18) for u, v in reversed(line))], 0, w)
    rail = prism(
        [*((u, v + 0.17) for u, v in line), *((u, v - 0.2) for u, v in reversed(line))], 0, 0.09, w
    )
    steps = 3 + draw.chance(0.5)
    post = capsule((w, back + 0.35, 0.1), (w, back - 0.02, high), 0.1)
    rungs = (
        capsule(
            (-w, back + 0.35 - 0.37 * t, 0.1 + (high - 0.1) * t),
            (w, back + 0.35 - 0.37 * t, 0.1 + (high - 0.1) * t),
            0.09,
        )
        for t in ((k + 0.6) / steps for k in range(steps))
    )
    hoop = join(
        capsule((w, back - 0.02, high), (w, back - 0.02, high + 0.45), 0.1),
        capsule((w, back - 0.02, high + 0.45), (w, back * 0.35, high + 0.1), 0.1),
    )
    leg = capsule((w, back * 0.3, high - 0.1), (w, back * 0.1, 0.1), 0.1)
    return {
        "slide": sheet,
        "sides": both(rail),
        "ladder": join(both(post), *rungs),
        "rails": both(join(hoop, leg)),
    }


def trampoline(draw: Draw) -> Parts:
    """A round mat in a padded ring on legs; some have posts with a rail around."""
    r, high, count = draw(1.0, 1.2), draw(0.45, 0.65), 6
    leg = join(
        capsule((r - 0.02, 0, high), (r - 0.02, 0, 0.1), 0.1),
        capsule((r - 0.02, -0.18, 0.1), (r - 0.02, 0.18, 0.1), 0.1),
    )
    pad = cut(
        tube((0, 0, high - 0.04), (0, 0, high + 0.14), r + 0.08, 0.06),
        tube((0, 0, 0), (0, 0, 3), r - 0.2),
    )
    parts = {
        "mat": tube((0, 0, high - 0.1), (0, 0, high + 0.07), r - 0.1),
        "pad": pad,
        "legs": around(count, leg, 45),
    }
    if draw.has("rail", 0.4):
        tall = high + draw(0.7, 0.9)
        post = capsule((r - 0.02, 0, high), (r - 0.02, 0, tall), 0.1)
        parts |= {"rail": join(around(count, post, 45), ring((0, 0, tall), r - 0.02, 0.1))}
    return parts


TOYS = {
    "violin": violin,
    "trumpet": trumpet,
    "xylophone": xylophone,
    "banjo": banjo,
    "ukulele": ukulele,
    "saxophone": saxophone,
    "rocking horse": rocking_horse,
    "spinning top": spinning_top,
    "lego brick": lego_brick,
    "puzzle cube": puzzle_cube,
    "basketball hoop": basketball_hoop,
    "slide": slide,
    "trampoline": trampoline,
}
