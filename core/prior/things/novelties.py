"""What a shop of novelties sells: toys, a cap, a revolver, and two animals of the sea."""

import math

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
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)


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


def beanie(draw: Draw) -> Parts:
    """A knitted cap with ribs, a folded brim and a bobble."""
    r, high, fold = draw(0.78, 0.86), draw(1.0, 1.16), draw(0.38, 0.46)
    count, bobble = 14, draw(0.3, 0.36)
    base = fold * 0.7
    side = [(r, 0.05), (r * 0.99, high * 0.4), (r * 0.8, high * 0.72), (0.4, high * 0.94)]
    curve = smooth_curve([*side, (0.0, high)])
    rib = limb([(u - 0.02, 0, h) for u, h in curve[2:-1:3]], 0.1, 0.06)
    cuff = [(r + 0.06, 0.04), (r + 0.14, 0.12), (r + 0.14, fold - 0.08), (r + 0.06, fold)]
    ridge = capsule((r + 0.13, 0, 0.11), (r + 0.13, 0, fold - 0.09), 0.075)
    hollow = lathe([(r - 0.16, -0.2), (r - 0.16, high * 0.3), (0.1, high * 0.6)])
    top, size = high + bobble * 0.72, bobble * 0.8

    def tuft(down: float, turn: float) -> Solid:
        out = size * math.sin(down)
        at = (out * math.cos(turn), out * math.sin(turn), top + size * math.cos(down))
        return ball(at, size * 0.5)

    rows = ((0.0, 1), (0.9, 5), (1.7, 7), (2.5, 4))
    tufts = [tuft(down, math.tau * k / n + down) for down, n in rows for k in range(n)]
    return {
        "cap": cut(lathe(curve), hollow),
        "ribs": cut(around(count, rib), box((0, 0, base - 1), (2, 2, 1))),
        "brim": cut(lathe(cuff, 0.03), hollow),
        "ridges": around(2 * count, ridge),
        "pompom": join(*tufts),
    }


def revolver(draw: Draw) -> Parts:
    """Upright, its muzzle to the left: a fluted cylinder, a hammer behind it, a curved grip."""
    long, r, drum = draw(1.02, 1.18), draw(0.13, 0.15), draw(0.27, 0.31)
    z, half = draw(1.0, 1.1), draw(0.25, 0.29)
    muzzle, _low = -half - long, z - 0.06
    flute = tube((-1, drum + 0.05, 0), (half - 0.12, drum + 0.05, 0), 0.11)
    round_bar = tube((-half, 0, 0), (half, 0, 0), drum, 0.03)
    # Turned about its own axis, so that flutes lie at the sides.
    flutes = [turned(flute, 0, 60 * k + 30) for k in range(6)]
    lug = tube((muzzle + 0.3, 0, z - 0.1), (-half, 0, z - 0.1), 0.085)
    bore = tube((muzzle - 1, 0, z + 0.1), (muzzle + 0.25, 0, z + 0.1), 0.075)
    barrel = tube((muzzle, 0, z + 0.1), (-half - 0.05, 0, z + 0.1), r, 0.02)
    sight = box((muzzle + 0.13, 0, z + 0.1 + r + 0.04), (0.1, 0.07, 0.08), 0.02)
    y = 0.16
    back = half + 0.34
    frame = [(-half - 0.12, z + 0.34), (back - 0.06, z + 0.34), (back + 0.06, z + 0.02)]
    frame += [(back + 0.04, z - 0.36), (-half - 0.12, z - 0.42)]
    window = box((0, 0, z), (half + 0.02, 2, drum - 0.04))
    guard = ring((half - 0.14, 0, z - 0.56), 0.24, 0.08, axis=1)
    drop = draw(0.9, 1.02)
    butt = [(half + 0.02, z - 0.2), (back + 0.04, z - 0.1), (back + 0.14, z - 0.34)]
    butt += [(back + 0.28, z - drop * 0.72), (back + 0.5, z - drop), (back + 0.1, z - drop - 0.06)]
    butt += [(half + 0.16, z - drop * 0.66)]
    return {
        "barrel": cut(join(barrel, lug, sight), bore),
        "frame": join(cut(prism(frame, 1, y), window), guard),
        "cylinder": moved(cut(round_bar, *flutes), (0, 0, z)),
        "grip": prism(smooth_curve([*butt, butt[0]], 3)[:-1], 1, y + 0.05),
        "trigger": limb(
            [(half - 0.1, 0, z - 0.3), (half - 0.1, 0, z - 0.46), (half - 0.18, 0, z - 0.6)],
            0.085,
            0.085,
        ),
        "hammer": limb(
            [(back - 0.1, 0, z + 0.2), (back + 0.08, 0, z + 0.44), (back + 0.28, 0, z + 0.46)],
            0.1,
            0.085,
        ),
    }


def starfish(draw: Draw) -> Parts:
    """Upright like a star: five plump arms, each with a row of knobs that shrink to its tip."""
    reach, middle, tip = draw(1.05, 1.2), draw(0.36, 0.42), draw(0.12, 0.15)
    bend = draw(0.22, 0.28)
    arm = limb([(0, 0, 0), (reach * 0.5, 0, 0), (reach, 0, 0)], middle, tip)

    def standing(solid: Solid) -> Solid:
        return moved(turned(around(5, solid, 90), 0, 90), (0, 0, 1.1))

    knobs, dots = [], []
    for k in range(4):
        x = reach * (0.22 + 0.23 * k)
        thick = middle + (tip - middle) * x / reach
        knobs.append(both(ball((x, 0, thick * 0.94), 0.1 - 0.006 * k), 2))
    for k in range(3):
        x = reach * (0.3 + 0.19 * k)
        thick = (middle + (tip - middle) * x / reach) * 0.96
        at = (x, thick * math.sin(0.95), thick * math.cos(0.95))
        dots.append(both(ball(at, 0.08 - 0.004 * k), 1, 2))
    center = both(ball((0, 0, middle * 0.96), bend * 0.5), 2)
    return {
        "body": standing(arm),
        "knobs": standing(join(*knobs)),
        "dots": standing(join(*dots)),
        "center": moved(turned(center, 0, 90), (0, 0, 1.1)),
    }


def lobster(draw: Draw) -> Parts:
    """Its great claws raised, three pairs of legs, a tail of rings that ends in a fan."""
    wide, long, claw = draw(0.4, 0.46), draw(0.5, 0.56), draw(0.29, 0.33)
    z, step = draw(0.46, 0.52), draw(0.16, 0.18)
    shell = taper((0, -long * 0.8, z + 0.02), (0, long * 0.3, z), wide * 0.62, wide)
    beak = taper((0, -long, z + 0.12), (0, -long - 0.4, z + 0.2), 0.17, 0.085)
    links = []
    for k in range(4):
        y, r = long * 0.4 + step * (k + 1), wide * (0.97 - 0.1 * k)
        links.append(egg((0, y, z - 0.05 * k), (r, 0.17, r * 0.8)))
    blade, end = egg((0.25, 0, 0), (0.25, 0.14, 0.09)), long * 0.4 + step * 4 + 0.08
    fan = [moved(turned(blade, 2, 90 + a), (0, end, z - 0.2)) for a in (-60, -30, 0, 30, 60)]
    # A raised claw: the arm, the palm, and two fingers of which the outer one is the thicker.
    x, y, up = draw(0.78, 0.9), -long - 0.16, z + 0.56
    arm = limb([(wide * 0.6, -long * 0.5, z), (x + 0.1, y, z + 0.08), (x, y, up - 0.2)], 0.12, 0.1)
    palm = egg((x, y, up), (claw, 0.2, 0.3))
    thick = limb([(x + 0.14, y, up), (x + 0.2, y, up + 0.4), (x - 0.04, y, up + 0.7)], 0.19, 0.09)
    thin = limb([(x - 0.16, y, up), (x - 0.34, y, up + 0.3), (x - 0.26, y, up + 0.52)], 0.14, 0.09)
    x_foot, legs = wide + 0.5, []
    for q, s in ((-0.2, -0.08), (0.06, 0.02), (0.32, 0.12)):
        knee = (wide + 0.3, q + s, z + 0.1)
        legs.append(limb([(wide * 0.6, q, z - 0.1), knee, (x_foot, q + s, 0.09)], 0.1, 0.09))
    tip = (0.6, -long - 0.72, z + 0.24)
    feeler = limb([(0.14, -long - 0.1, z + 0.16), (0.34, -long - 0.42, z + 0.3), tip], 0.09, 0.09)
    return {
        "body": join(shell, beak),
        "claws": both(join(arm, palm, thick, thin)),
        "tail": join(*links, *fan),
        "legs": both(join(*legs)),
        "eyes": both(ball((0.26, -long + 0.04, z + 0.4), 0.125)),
        "feelers": both(feeler),
    }


NOVELTIES = {
    "piggy bank": piggy_bank,
    "rubber duck": rubber_duck,
    "beanie": beanie,
    "revolver": revolver,
    "starfish": starfish,
    "lobster": lobster,
}
