"""Toys and things of a playground."""

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
    chain,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    within,
)


def robot(draw: Draw) -> Parts:
    """A toy of boxes, its face to the front; ears, shoulders and hands are round."""
    x, body, head = draw(0.42, 0.5), draw(0.38, 0.44), draw(0.31, 0.36)
    low, deep = draw(0.5, 0.62), draw(0.28, 0.34)
    top = low + 2 * body
    z = top + head + 0.1
    side, out = head * 1.2, x + 0.19
    shoulder, hand = top - 0.16, top - draw(0.82, 0.9)
    cube = box((0, 0, z), (side, head, head), 0.06)
    drum = tube((0, 0, z - head), (0, 0, z + head), head * 1.12, 0.06)
    round_head, two = draw.chance(0.4), draw.chance(0.4)
    side = head * 1.12 if round_head else side
    rod = join(
        tube((0, 0, z + head - 0.05), (0, 0, z + head + 0.2), 0.085),
        ball((0, 0, z + head + 0.26), 0.13),
    )
    sole = [(0.17, 0.0), (0.17, low + 0.05), (-0.15, low + 0.05), (-0.15, 0.2), (-0.36, 0.2)]
    return {
        "body": box((0, 0, low + body), (x, deep, body), 0.05),
        "head": drum if round_head else cube,
        "limbs": both(
            join(
                box((out, 0, (shoulder + hand) / 2), (0.13, 0.14, (shoulder - hand) / 2), 0.03),
                moved(prism([*sole, (-0.36, 0.0)], 0, 0.16), (x * 0.52, 0, 0)),
            )
        ),
        "eyes": both(
            tube((side * 0.42, -head - 0.07, z + 0.05), (side * 0.42, -head + 0.2, z + 0.05), 0.12)
        ),
        "aerial": both(moved(rod, (head * 0.62, 0, 0))) if two else rod,
        "joints": join(
            tube((0, 0, top - 0.1), (0, 0, z), 0.15),
            both(tube((side - 0.1, 0, z), (side + 0.09, 0, z), 0.15)),
            both(ball((out - 0.03, 0, shoulder), 0.2)),
            both(ball((out, 0, hand - 0.06), 0.185)),
        ),
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


def rubber_duck(draw: Draw) -> Parts:
    """Flat below, a round head with an open bill, its tail up, a wing at either side."""
    wide, long, head = draw(0.62, 0.7), draw(0.84, 0.92), draw(0.44, 0.49)
    y, z = -long * 0.42, draw(1.2, 1.3)
    hull = cut(egg((0, 0, 0.5), (wide, long, 0.54)), box((0, 0, -0.92), (2, 2, 1)))
    tail = taper((0, long * 0.5, 0.55), (0, long + 0.1, 1.06), 0.36, 0.09)
    breast = taper((0, y, 0.55), (0, y, z), 0.42, 0.3)
    back = (wide * 0.98, long * 0.6, 0.86)
    stops = [((wide * 0.84, -0.2, 0.62), 0.2), ((wide * 0.94, 0.2, 0.66), 0.18), (back, 0.075)]
    wing = chain(stops)
    front = y - head
    upper = egg((0, front - 0.08, z - 0.04), (0.25, 0.3, 0.09))
    return {
        "body": blend(0.1, hull, tail, breast, ball((0, y, z), head)),
        "wings": both(wing),
        "bill": join(upper, egg((0, front - 0.02, z - 0.17), (0.19, 0.22, 0.08))),
        "eyes": both(ball((head * 0.5, y - head * 0.76, z + head * 0.36), 0.12)),
        "pupils": both(ball((head * 0.53, y - head * 0.86, z + head * 0.38), 0.085)),
    }


def piggy_bank(draw: Draw) -> Parts:
    """A plump pig with short legs, its snout to the front, half a coin in the slot of its back."""
    r, long = draw(0.72, 0.8), draw(0.84, 0.94)
    z = r + draw(0.2, 0.28)
    x, y, face = r * 0.52, long * 0.46, -long - 0.04
    leg = tube((x, y, 0), (x, y, z * 0.6), 0.2, 0.05)
    ear = taper((r * 0.46, -long * 0.6, z + r * 0.62), (r * 0.66, -long * 0.72, z + r), 0.2, 0.075)
    tail = ring((0, long + 0.08, z + 0.14), 0.14, 0.075, axis=0)
    snout = tube((0, face + 0.2, z - 0.02), (0, face - 0.12, z - 0.02), 0.27, 0.05)
    nostril = ball((0.1, face - 0.12, z - 0.02), 0.075)
    eye = ball((r * 0.42, -long * 0.83, z + r * 0.36), 0.09)
    top = z + r
    return {
        "body": join(egg((0, 0, z), (r, long, r)), both(leg, 0, 1), tail),
        "snout": snout,
        "ears": both(ear),
        "eyes": both(join(eye, nostril)),
        "slot": within(
            egg((0, 0, z), (r + 0.04, long + 0.04, r + 0.04)),
            box((0, 0.05, top), (0.14, 0.44, 0.3)),
        ),
        "coin": tube((-0.075, 0.05, top + 0.1), (0.075, 0.05, top + 0.1), draw(0.28, 0.33), 0.02),
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
    "robot": robot,
    "rocking horse": rocking_horse,
    "spinning top": spinning_top,
    "lego brick": lego_brick,
    "puzzle cube": puzzle_cube,
    "rubber duck": rubber_duck,
    "piggy bank": piggy_bank,
    "slide": slide,
    "trampoline": trampoline,
}
