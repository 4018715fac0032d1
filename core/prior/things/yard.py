"""Props that stand outdoors, and what is carried there."""

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
    join,
    lathe,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
)


def barrel(draw: Draw) -> Parts:
    """Staves that bulge, hoops."""
    r, high, bulge = draw(0.62, 0.75), draw(1.7, 2.1), draw(1.15, 1.3)
    side = smooth_curve(
        [
            (r, 0.0),
            (r * (1 + bulge) / 2 * 1.04, high * 0.22),
            (r * bulge, high / 2),
            (r * (1 + bulge) / 2 * 1.04, high * 0.78),
            (r, high),
        ]
    )
    body = cut(lathe(side), tube((0, 0, high - 0.1), (0, 0, high + 1), r * 0.84))
    body = cut(body, tube((0, 0, -1), (0, 0, 0.1), r * 0.84))
    at = (0.13, 0.36, 0.64, 0.87)
    wide = [r * (1 + (bulge - 1) * (1 - (2 * k - 1) ** 2)) for k in at]
    hoops = (
        tube((0, 0, high * k - 0.08), (0, 0, high * k + 0.08), w + 0.05, 0.02)
        for k, w in zip(at, wide, strict=True)
    )
    inside = tube((0, 0, -1), (0, 0, high + 1), r * 0.8)
    return {"body": body, "hoops": cut(join(*hoops), inside)}


def crate(draw: Draw) -> Parts:
    """Planks in a frame, a brace across each side."""
    x, y, z = draw(0.8, 0.95), draw(0.75, 0.95), draw(0.72, 0.95)
    edge = draw(0.15, 0.18)  # half the frame's
    holes = (
        box((0, 0, z), (x - 2 * edge, 2, z - 2 * edge)),
        box((0, 0, z), (2, y - 2 * edge, z - 2 * edge)),
        box((0, 0, z), (x - 2 * edge, y - 2 * edge, 2)),
    )
    v = z - edge * 1.2

    def brace(half: float) -> list[tuple[float, float]]:
        u, wide = half - edge * 1.2, edge * 0.8
        return [(-u - wide, z - v), (-u + wide, z - v), (u + wide, z + v), (u - wide, z + v)]

    return {
        "planks": box((0, 0, z), (x - 0.13, y - 0.13, z - 0.13)),
        "frame": cut(box((0, 0, z), (x, y, z)), *holes),
        "braces": join(
            *(prism(brace(x), 1, 0.05, k * (y - 0.09)) for k in (-1, 1)),
            *(prism(brace(y), 0, 0.05, k * (x - 0.09)) for k in (-1, 1)),
        ),
    }


def well(draw: Draw) -> Parts:
    """A round wall of stones, two posts, a roof."""
    r, high = draw(0.72, 0.85), draw(0.6, 0.72)
    wall = cut(tube((0, 0, 0), (0, 0, high), r, 0.03), tube((0, 0, 0.3), (0, 0, 3), r - 0.24))
    top = draw(1.75, 2.0)
    slope = [(-r - 0.2, top), (r + 0.2, top), (0, top + draw(0.5, 0.65))]
    roof = prism(slope, 1, r * 0.8)
    return {
        "wall": wall,
        "roof": roof,
        "posts": join(
            both(box((r - 0.12, 0, top / 2 + 0.1), (0.1, 0.12, top / 2))),
            tube((-r, 0, high + 0.55), (r, 0, high + 0.55), 0.1),
        ),
        "water": tube((0, 0, 0.05), (0, 0, high * 0.6), r - 0.1),
    }


def tent(draw: Draw) -> Parts:
    """A ridge tent, its door in front."""
    x, y, high = draw(0.85, 1.05), draw(1.0, 1.25), draw(1.05, 1.3)
    body = prism([(-x, 0), (x, 0), (0, high)], 1, y)
    door = prism([(-x * 0.36, -0.1), (x * 0.36, -0.1), (0, high * 0.66)], 1, 0.3, -y)
    inside = prism([(-x * 0.34, 0.0), (x * 0.34, 0.0), (0, high * 0.62)], 1, 0.1, -y + 0.25)
    ridge = capsule((0, -y - 0.06, high), (0, y + 0.06, high), 0.09)
    return {"canvas": cut(body, door), "door": inside, "poles": ridge}


def campfire(draw: Draw) -> Parts:
    """Logs leant together, stones around, a flame."""
    count, flame = int(draw(6, 9)), draw(1.0, 1.3)
    stones = around(count, egg((0.95, 0, 0.14), (0.24, 0.26, 0.2)))
    logs = around(5, capsule((0.72, 0, 0.14), (0.08, 0, 0.6), 0.13), 20)
    fire = smooth_curve([(0.25, 0.3), (0.36, 0.6), (0.2, flame), (0.02, flame + 0.35)])
    ground = tube((0, 0, 0), (0, 0, 0.1), 0.95, 0.03)
    return {"flame": lathe(fire, 0.04), "logs": logs, "stones": stones, "ash": ground}


def signpost(draw: Draw) -> Parts:
    """A post with one or two arrow boards."""
    high, wide = draw(1.9, 2.2), draw(0.75, 0.9)

    def board(z: float, side: float) -> Solid:
        half = 0.22
        corners = [
            (-wide * 0.8, z - half),
            (wide * 0.7, z - half),
            (wide, z),
            (wide * 0.7, z + half),
            (-wide * 0.8, z + half),
        ]
        return prism([(side * u, v) for u, v in corners], 1, 0.09, -0.12)

    boards = [board(high - 0.35, 1)] + ([board(high - 0.95, -1)] if draw.chance(0.6) else [])
    return {
        "boards": join(*boards),
        "post": box((0, 0, high / 2), (0.12, 0.12, high / 2), 0.02),
        "base": tube((0, 0, 0), (0, 0, 0.12), 0.4, 0.03),
    }


def ladder(draw: Draw) -> Parts:
    """Two rails, rungs."""
    x, high, count = draw(0.4, 0.5), draw(2.0, 2.4), int(draw(4, 7))
    rungs = (
        tube((-x, 0, high * (k + 0.5) / count), (x, 0, high * (k + 0.5) / count), 0.09)
        for k in range(count)
    )
    return {"rails": both(box((x, 0, high / 2), (0.1, 0.1, high / 2), 0.02)), "rungs": join(*rungs)}


def fence(draw: Draw) -> Parts:
    """Pickets on two rails."""
    count, high, half = int(draw(4, 6)), draw(1.1, 1.4), draw(0.15, 0.18)
    step = 2.8 / count
    corners = [(-half, 0), (half, 0), (half, high - 0.2), (0, high), (-half, high - 0.2)]
    pickets = (
        prism([(u + step * (k - (count - 1) / 2), v) for u, v in corners], 1, 0.09)
        for k in range(count)
    )
    rails = join(*(box((0, 0.12, high * k), (1.4, 0.09, 0.11)) for k in (0.25, 0.72)))
    return {"pickets": join(*pickets), "rails": rails}


def mailbox(draw: Draw) -> Parts:
    """A tunnel-shaped box on a post, a flag at its side."""
    r, y, high = draw(0.4, 0.48), draw(0.7, 0.85), draw(1.2, 1.5)
    tunnel = join(
        tube((0, -y, high + r), (0, y, high + r), r, 0.02), box((0, 0, high + r / 2), (r, y, r / 2))
    )
    return {
        "box": tunnel,
        "door": join(
            tube((0, -y - 0.08, high + r), (0, -y, high + r), r * 0.86),
            box((0, -y - 0.04, high + r / 2), (r * 0.86, 0.04, r / 2)),
        ),
        "flag": join(
            box((r + 0.06, -0.1, high + r + 0.2), (0.08, 0.08, 0.35)),
            box((r + 0.06, -0.26, high + r + 0.45), (0.08, 0.2, 0.14)),
        ),
        "post": box((0, 0, high / 2), (0.14, 0.14, high / 2 + 0.05), 0.02),
    }


def gift(draw: Draw) -> Parts:
    """A box with a lid, a ribbon and a bow."""
    x, y, z = draw(0.7, 0.9), draw(0.7, 0.9), draw(0.5, 0.75)
    top = 2 * z + 0.14
    ribbon = join(
        box((0, 0, top / 2), (0.13, y + 0.1, top / 2 + 0.05)),
        box((0, 0, top / 2), (x + 0.1, 0.13, top / 2 + 0.05)),
    )
    loop = ring((0.26, 0, top + 0.22), 0.19, 0.1, 1)
    return {
        "box": box((0, 0, z), (x, y, z)),
        "lid": box((0, 0, 2 * z), (x + 0.06, y + 0.06, 0.16), 0.01),
        "ribbon": ribbon,
        "bow": join(both(loop), ball((0, 0, top + 0.12), 0.14)),
    }


def basket(draw: Draw) -> Parts:
    """A woven basket with a high handle."""
    r, high = draw(0.75, 0.9), draw(0.65, 0.85)
    body = cut(
        lathe([(r * 0.72, 0), (r, high)], 0.02), lathe([(r * 0.56, 0.14), (r * 0.86, high + 0.2)])
    )
    return {
        "body": body,
        "handle": cut(ring((0, 0, high), r * 0.94, 0.1, 1), box((0, 0, high - 1.1), (2, 2, 1))),
        "rim": ring((0, 0, high), r * 0.94, 0.12),
    }


def balloon(draw: Draw) -> Parts:
    """A toy balloon with its knot and a bit of string."""
    wide, high = draw(0.75, 0.85), draw(0.9, 1.05)
    body = blend(
        0.2, egg((0, 0, 1.5), (wide, wide, high)), taper((0, 0, 0.9), (0, 0, 0.55), 0.35, 0.1)
    )
    return {
        "body": body,
        "knot": lathe([(0.2, 0.32), (0.09, 0.52)], 0.02),
        "string": capsule((0, 0, -0.3), (0, 0, 0.4), 0.09),
    }


def umbrella(draw: Draw) -> Parts:
    """Open: a canopy, a stick, a crook."""
    r, top, crook = draw(1.1, 1.3), draw(1.7, 1.9), 0.2
    dome = cut(egg((0, 0, top - 0.6), (r, r, 0.85)), box((0, 0, top - 2.55), (3, 3, 2.0)))
    dome = cut(dome, egg((0, 0, top - 0.72), (r - 0.1, r - 0.1, 0.8)))
    hook = cut(ring((crook, 0, 0.1), crook, 0.09, 1), box((0, 0, 2.1), (3, 3, 2.0)))
    return {
        "canopy": dome,
        "stick": capsule((0, 0, 0.1), (0, 0, top + 0.35), 0.09),
        "handle": join(hook, capsule((0, 0, 0.1), (0, 0, 0.45), 0.1)),
    }


def arrow(draw: Draw) -> Parts:
    """Point up, feathers below."""
    high = draw(2.2, 2.5)
    head = prism([(-0.14, high), (0.14, high), (0, high + 0.5)], 1, 0.05)
    feather = prism([(0.0, 0.1), (0.18, 0.0), (0.18, 0.5), (0.0, 0.72)], 1, 0.04)
    return {
        "head": head,
        "shaft": capsule((0, 0, 0.1), (0, 0, high + 0.1), 0.052),
        "feathers": around(4, feather),
    }


def flag(draw: Draw) -> Parts:
    """A flag on a pole with a foot."""
    high, wide, tall = draw(2.2, 2.5), draw(1.0, 1.25), draw(0.6, 0.75)
    waves = [(0.0, 0.0), (wide * 0.35, 0.09), (wide * 0.7, -0.09), (wide, 0.05)]
    curve = smooth_curve(waves)
    outline = [(u, v + 0.09) for u, v in curve] + [(u, v - 0.09) for u, v in reversed(curve)]
    return {
        "cloth": prism(outline, 2, tall / 2, high - tall / 2 - 0.1),
        "pole": capsule((0, 0, 0.1), (0, 0, high), 0.09),
        "knob": ball((0, 0, high + 0.08), 0.16),
        "base": tube((0, 0, 0), (0, 0, 0.14), 0.38, 0.03),
    }


YARD = {
    "barrel": barrel,
    "crate": crate,
    "well": well,
    "tent": tent,
    "campfire": campfire,
    "signpost": signpost,
    "ladder": ladder,
    "fence": fence,
    "mailbox": mailbox,
    "gift": gift,
    "basket": basket,
    "balloon": balloon,
    "umbrella": umbrella,
    "arrow": arrow,
    "flag": flag,
}
