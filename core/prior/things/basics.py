"""Plain solids, and the first things that the prior knew."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    cut,
    ellipsoid,
    join,
    lathe,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
)


def a_ball(_: Draw) -> Parts:
    return {"body": ball((0, 0, 0), 1.0)}


def cube(draw: Draw) -> Parts:
    return {"body": box((0, 0, 0), (1, 1, 1), draw(0.02, 0.15))}


def torus(draw: Draw) -> Parts:
    return {"body": ring((0, 0, 0), 1.0, draw(0.32, 0.45))}


def cylinder(draw: Draw) -> Parts:
    half = draw(1.0, 1.4)
    return {"body": tube((0, 0, -half), (0, 0, half), draw(0.75, 0.95), draw(0.02, 0.1))}


def cone(draw: Draw) -> Parts:
    radius, height = draw(0.85, 1.05), draw(1.7, 2.2)
    return {"body": lathe([(0, 0), (radius, 0), (0, height)], 0.04)}


def _legs(x: float, y: float, top: float, thick: float, round_legs: bool) -> Solid:
    """Four legs under the corners (±x, ±y), from the floor to ``top``."""
    corners = [(sx * (x - thick), sy * (y - thick)) for sx in (-1, 1) for sy in (-1, 1)]
    if round_legs:
        return join(*(tube((a, b, 0), (a, b, top), thick, 0.02) for a, b in corners))
    half = (thick, thick, top / 2)
    return join(*(box((a, b, top / 2), half, 0.02) for a, b in corners))


def table(draw: Draw) -> Parts:
    """An oblong or a round board on slim legs with a frame between them, or on one foot."""
    x, top, slim = draw(0.95, 1.15), draw(0.95, 1.15), draw(0.068, 0.073)
    y, disc = x * draw(0.6, 0.8), draw.shaped("round", 0.25)
    if disc:
        x = y = (x + y) / 2
    thick = max(x, top / 2) * slim
    if draw.legs(4, 4, 4, 1) == 1:
        legs = join(
            tube((0, 0, 0), (0, 0, top), thick * 1.4), tube((0, 0, 0), (0, 0, 0.14), x * 0.55, 0.03)
        )
    else:
        # A disc has no corners.
        a, b = (x * 0.6, y * 0.6) if disc else (x - 0.05, y - 0.05)
        frame = box((0, 0, top - 0.05), (a - thick, b - thick, 0.1))
        legs = join(_legs(a, b, top + thick, thick, disc), frame)
    slab = tube((0, 0, top), (0, 0, top + 2 * thick), x, 0.03)
    return {"top": slab if disc else box((0, 0, top + thick), (x, y, thick), 0.02), "legs": legs}


def chair(draw: Draw) -> Parts:
    """Slim legs with bars between them, and a back of two boards, of a slat, or of one panel."""
    x, y, thick = draw(0.5, 0.57), draw(0.48, 0.54), draw(0.075, 0.09)
    seat, plate = draw(0.78, 0.92), draw(0.07, 0.085)
    top, a, b = seat + draw(0.85, 1.05), x - thick, y - thick
    high = (top - seat) / 2
    posts = [box((side * a, b, seat + high), (thick, thick, high), 0.015) for side in (-1, 1)]
    rail = box((0, b, top - 0.13), (a, 0.075, 0.13), 0.02)
    # Four sorts in all, as a noun has kinds: what shares one is drawn as the mean of both.
    arms = draw.has("armrests", 0.12)
    style = 0 if arms else draw.which(3)
    # Gaps narrower than a fifth of the seat would be drawn closed.
    boards = [box((0, b, seat + high * 0.86), (a, 0.07, 0.1), 0.015)]
    slats = [box((0, b, seat + high), (0.15, 0.07, high * 0.9), 0.015)]
    panel = [box((0, b, seat + high * 1.15), (a, 0.07, high * 0.75), 0.015)]
    bars = [box((side * a, 0, seat * 0.4), (0.06, b, 0.06), 0.01) for side in (-1, 1)]
    parts = {
        "seat": box((0, 0, seat), (x, y, plate), 0.03),
        "back": join(*posts, rail, *(boards, slats, panel)[style]),
        "legs": join(_legs(x, y, seat, thick, False), *bars),
    }
    if not arms:
        return parts
    rest = seat + draw(0.36, 0.44)
    arm = join(
        box((a, 0, rest), (0.075, y, 0.06), 0.02),
        box((a, thick - y, (seat + rest) / 2), (0.065, 0.065, (rest - seat) / 2), 0.01),
    )
    return parts | {"arms": both(arm)}


def armchair(draw: Draw) -> Parts:
    """A cushion between arms and a back, on four short legs."""
    x, y, seat = draw(0.8, 1.0), draw(0.7, 0.8), draw(0.6, 0.75)
    arm, arm_top = draw(0.17, 0.24), seat + draw(0.28, 0.4)
    back, back_top = draw(0.17, 0.24), seat + draw(0.75, 0.95)
    soft, low, thick = draw(0.08, 0.15), draw(0.24, 0.32), 0.1

    def block(u: float, v: float, half: float, deep: float, top: float) -> Solid:
        return box((u, v, (low + top) / 2), (half, deep, (top - low) / 2), soft)

    leg = box((x - 0.14, y - 0.14, low / 2 + 0.05), (thick, thick, low / 2 + 0.05))
    return {
        "cushion": block(0, 0, x - arm, y, seat),
        "back": block(0, y - back, x - 0.02, back, back_top),
        "arms": both(block(x - arm, 0, arm, y, arm_top)),
        "legs": both(leg, 0, 1),
    }


def mug(draw: Draw) -> Parts:
    radius, height, wall = draw(0.52, 0.6), draw(1.1, 1.35), draw(0.08, 0.11)
    taper = draw(-0.06, 0.06)
    outer = lathe([(radius - taper - 0.03, 0.03), (radius + taper - 0.03, height - 0.03)], 0.03)
    inner = lathe([(radius - taper - wall, 0.16), (radius + taper - wall, height + 0.5)])
    major, minor = draw(0.32, 0.4), draw(0.09, 0.115)
    handle = ring((radius, 0, height * draw(0.48, 0.54)), major, minor, axis=1)
    parts = {"body": cut(outer, inner)}
    return parts | {"handle": cut(handle, inner)} if draw.has("handle", 1.0) else parts


def vase(draw: Draw) -> Parts:
    belly, neck, lip = draw(0.62, 0.8), draw(0.24, 0.32), draw(0.36, 0.46)
    low, high = draw(0.6, 0.8), draw(1.5, 1.7)
    outline = [(draw(0.34, 0.44), 0), (belly, low), (neck, high), (lip, high + 0.4)]
    hole = [(neck - 0.1, high - 0.5), (neck - 0.1, high), (lip - 0.1, high + 0.41)]
    return {"body": cut(lathe(smooth_curve(outline, 5)), lathe([*hole, (lip - 0.1, high + 0.8)]))}


def bottle(draw: Draw) -> Parts:
    body, neck = draw(0.42, 0.5), draw(0.16, 0.2)
    shoulder, top = draw(1.2, 1.4), draw(2.1, 2.3)
    outline = [
        *((body - 0.08, 0), (body, 0.08), (body, shoulder), (0.5 * (body + neck), shoulder + 0.28)),
        *((neck, shoulder + 0.5), (neck, top)),
    ]
    cap = neck + draw(0.03, 0.06)
    parts = {"body": lathe(outline, 0.02)}
    lid = {"cap": tube((0, 0, top - 0.05), (0, 0, top + 0.22), cap, 0.03)}
    return parts | lid if draw.has("cap", 0.9) else parts


def lamp(draw: Draw) -> Parts:
    pole_top, bottom, top = draw(1.3, 1.5), draw(0.65, 0.8), draw(0.32, 0.45)
    height = draw(0.75, 0.95)
    shade = [(bottom, pole_top), (top, pole_top + height)]
    foot = draw(0.45, 0.55)
    return {
        "shade": lathe(shade, 0.03),
        "pole": tube((0, 0, 0.05), (0, 0, pole_top + 0.1), draw(0.1, 0.13)),
        "foot": tube((0, 0, 0), (0, 0, draw(0.16, 0.22)), foot, 0.05),
    }


def snowman(draw: Draw) -> Parts:
    low, middle, head = draw(0.66, 0.74), draw(0.47, 0.53), draw(0.35, 0.4)
    z1 = low + (low + middle) * draw(0.72, 0.8)
    z2 = z1 + (middle + head) * draw(0.74, 0.82)
    face = -head
    brim = z2 + head * 0.75
    eyes = both(ball((0.15, face * 0.85, z2 + 0.13), 0.085))
    buttons = (ball((0, -middle * 0.97, z1 + d), 0.1) for d in (-0.24, 0.04))
    nose = taper((0, face * 0.85, z2), (0, face - draw(0.3, 0.42), z2 - 0.04), 0.13, 0.06)
    hat = join(
        tube((0, 0, brim - 0.05), (0, 0, brim + 0.07), head * 1.12, 0.03),
        tube((0, 0, brim), (0, 0, brim + draw(0.4, 0.5)), head * 0.72, 0.03),
    )
    neck = (z1 * head + z2 * middle) / (head + middle)
    arm = join(
        capsule((middle * 0.8, 0, z1 + 0.1), (middle + 0.62, -0.08, z1 + 0.5), 0.075),
        capsule((middle + 0.36, -0.05, z1 + 0.33), (middle + 0.66, -0.06, z1 + 0.2), 0.065),
    )
    parts = {
        "body": join(ball((0, 0, low), low), ball((0, 0, z1), middle), ball((0, 0, z2), head)),
        "nose": nose,
        "buttons": join(eyes, *buttons),
        "arms": both(arm),
        "scarf": join(
            ring((0, 0, neck), head * 0.82, 0.13),
            box((head * 0.55, -middle * 0.84, neck - 0.26), (0.12, 0.1, 0.28), 0.05),
        ),
    }
    return parts | {"hat": hat} if draw.has("hat", 0.9) else parts


def mushroom(draw: Draw) -> Parts:
    cap, height, stem = draw(0.85, 1.0), draw(0.85, 1.1), draw(0.24, 0.32)
    dome = draw(0.6, 0.8)
    under = box((0, 0, height - 2), (2, 2, 2))
    return {
        "cap": cut(ellipsoid((0, 0, height), (cap, cap, dome)), under),
        "stem": lathe([(stem * 1.25, 0), (stem, 0.4), (stem * 0.95, height + 0.1)], 0.02),
    }


def house(draw: Draw) -> Parts:
    x, y, wall = draw(0.85, 1.05), draw(0.65, 0.8), draw(0.85, 1.05)
    ridge, eave = wall + draw(0.55, 0.75), draw(0.1, 0.16)
    roof = [(-y - eave, wall - 0.04), (y + eave, wall - 0.04), (0, ridge + 0.04)]
    cx = x * draw(0.45, 0.6)
    frame = 0.16  # the door's depth before the wall: enough for its sides to be seen
    parts = {
        "walls": box((0, 0, wall / 2), (x, y, wall / 2)),
        "roof": prism(roof, 0, x + eave),
        "door": box((0, -y, wall * 0.34), (0.2, frame, wall * 0.34), 0.02),
        "windows": join(
            both(box((x * 0.61, -y, wall * 0.56), (x * 0.21, 0.1, wall * 0.2))),
            both(box((x, 0, wall * 0.56), (0.1, y * 0.42, wall * 0.2))),
        ),
    }
    chimney = {"chimney": box((cx, y * 0.35, ridge - 0.1), (0.13, 0.13, 0.35))}
    return parts | chimney if draw.has("chimney", 0.9) else parts


def dumbbell(draw: Draw) -> Parts:
    grip, bar, inner, outer = draw(0.45, 0.6), draw(0.13, 0.17), draw(0.4, 0.55), draw(0.42, 0.55)
    if draw.chance(0.5):
        ends = [tube((s * grip, 0, 0), (s * (grip + outer), 0, 0), inner, 0.06) for s in (-1, 1)]
    else:
        ends = [ball((s * (grip + inner * 0.8), 0, 0), inner) for s in (-1, 1)]
    return {"weights": join(*ends), "bar": tube((-grip - 0.1, 0, 0), (grip + 0.1, 0, 0), bar)}


def rocket(draw: Draw) -> Parts:
    """A round window in front, four swept fins."""
    radius, shoulder, tip = draw(0.42, 0.48), draw(1.3, 1.45), draw(2.15, 2.4)
    hull = [(radius * 0.72, 0.24), (radius * 0.95, 0.6), (radius, 0.95), (radius, shoulder)]
    split = shoulder + 0.12
    nose = [(radius, shoulder), (radius * 0.75, shoulder + (tip - shoulder) * 0.5), (0.05, tip)]
    reach, high, z = radius + draw(0.36, 0.46), draw(0.78, 0.88), shoulder - draw(0.3, 0.36)
    fin = [(0, 0.26), (radius, 0.26), (reach, 0), (reach, 0.42), (radius - 0.05, high), (0, high)]
    fins = (prism(f, axis, 0.1) for axis in (0, 1) for f in (fin, [(-a, b) for a, b in fin[::-1]]))
    return {
        "hull": lathe(smooth_curve(hull, 4)),
        "nose": cut(lathe(smooth_curve(nose, 5)), box((0, 0, split - 1), (1, 1, 1))),
        "fins": join(*fins),
        "nozzle": lathe([(radius * 0.72, 0), (radius * 0.5, 0.3)]),
        "window": tube((0, -radius - 0.08, z), (0, 0, z), 0.2, 0.03),
        "rim": tube((0, -radius - 0.01, z), (0, 0, z), 0.3),
    }


def tree(draw: Draw) -> Parts:
    wide, trunk, step = draw(0.7, 0.85), draw(0.7, 0.9), draw(0.45, 0.52)
    tiers = (
        lathe([(0, z), (r, z), (0, z + r * 1.15)], 0.03)
        for z, r in ((trunk, wide), (trunk + step, wide * 0.8), (trunk + 2 * step, wide * 0.6))
    )
    return {
        "leaves": join(*tiers),
        "trunk": tube((0, 0, 0), (0, 0, trunk + 0.2), draw(0.17, 0.23), 0.02),
    }


BASICS = {
    "ball": a_ball,
    "cube": cube,
    "torus": torus,
    "cylinder": cylinder,
    "cone": cone,
    "table": table,
    "chair": chair,
    "armchair": armchair,
    "mug": mug,
    "vase": vase,
    "bottle": bottle,
    "lamp": lamp,
    "snowman": snowman,
    "mushroom": mushroom,
    "house": house,
    "dumbbell": dumbbell,
    "rocket": rocket,
    "tree": tree,
}
