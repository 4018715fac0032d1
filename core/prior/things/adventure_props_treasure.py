"""Adventure props: chests, treasure, barrels, graves, and a ship's wheel."""

import math

from torch import Tensor, atan2, stack

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    cut,
    egg,
    grown,
    join,
    lathe,
    limb,
    mirrored,
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


def chest(draw: Draw) -> Parts:
    """A treasure chest: a box under half a barrel, iron bands, a lock."""
    x, y, low = draw(0.95, 1.2), draw(0.6, 0.75), draw(0.6, 0.8)
    lid = cut(tube((-x, 0, low), (x, 0, low), y, 0.02), box((0, 0, low - 1), (2, 2, 1.0)))
    band = join(
        box((x * 0.6, 0, low / 2), (0.12, y + 0.09, low / 2)),
        cut(
            tube((x * 0.6 - 0.12, 0, low), (x * 0.6 + 0.12, 0, low), y + 0.09),
            box((0, 0, -1), (2, 2, 1 + low / 2)),
        ),
    )
    return {
        "body": box((0, 0, low / 2), (x, y, low / 2), 0.02),
        "lid": lid,
        "bands": join(both(band), box((0, 0, low), (x + 0.09, y + 0.09, 0.09))),
        "lock": box((0, -y - 0.1, low - 0.03), (0.17, 0.14, 0.2)),
    }


def open_chest(draw: Draw) -> Parts:
    """A treasure chest, its half barrel of a lid thrown back, heaped with coins."""
    x, y, low, wall = draw(1.02, 1.16), draw(0.62, 0.7), draw(0.72, 0.82), 0.15
    angle, at, some = draw(-112, -104), (0.0, y - 0.04, low + 0.02), draw.arranged()

    def barrel(half: float, radius: float) -> Solid:
        return tube((-half, -y, 0), (half, -y, 0), radius, 0.02)

    def opened(solid: Solid) -> Solid:
        return tilted(cut(solid, barrel(x - wall, y - wall), box((0, 0, -1), (2, 2, 1))), angle, at)

    def coin(k: int) -> Solid:
        """The k-th of the coins that lie half sunk on the heap, about a spiral."""
        turn, out = 137.5 * k + some(-20, 20), math.sqrt((k + 0.4) / 11)
        u, v = out * math.cos(math.radians(turn)), out * math.sin(math.radians(turn))
        lean = some(58, 72) if k % 4 == 3 else some(4, 14) + 26 * out
        rest = turned(tube((0, 0, -0.075), (0, 0, 0.075), 0.22, 0.02), 0, lean)
        up = low + 0.37 * math.sqrt(1 - 0.8 * out * out)
        return moved(turned(rest, 2, turn + 90), (u * (x - 0.3), v * (y - 0.26), up))

    hoop = join(
        *(moved(barrel(0.12, y + 0.09), (u, 0, 0)) for u in (-x * 0.6, x * 0.6)),
    )
    hollow = box((0, 0, low + 0.2), (x - wall, y - wall, low))
    heap = egg((0, 0, low - 0.04), (x - 0.06, y - 0.06, 0.42))
    return {
        "body": cut(box((0, 0, low / 2), (x, y, low / 2), 0.02), hollow),
        "lid": opened(barrel(x, y)),
        "bands": join(
            cut(
                join(
                    both(box((x * 0.6, 0, low / 2), (0.12, y + 0.09, low / 2))),
                    box((0, 0, low - 0.06), (x + 0.09, y + 0.09, 0.09)),
                ),
                hollow,
            ),
            opened(hoop),
        ),
        "lock": box((0, -y - 0.1, low - 0.1), (0.18, 0.14, 0.2), 0.03),
        "coins": join(within(heap, grown(hollow, 0.05)), *(coin(k) for k in range(11))),
    }


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


def coin(draw: Draw) -> Parts:
    """Upright, with a raised rim and a star on it."""
    r, thick, star = draw(0.9, 1.0), draw(0.11, 0.15), draw(0.54, 0.62)
    rim = cut(
        tube((0, -thick - 0.09, r), (0, thick + 0.09, r), r), tube((0, -2, r), (0, 2, r), r * 0.8)
    )
    points = [
        (long * r * math.sin(k * math.pi / 5), r + long * r * math.cos(k * math.pi / 5))
        for k in range(10)
        for long in (star if k % 2 == 0 else star * 0.48,)
    ]
    return {
        "face": tube((0, -thick, r), (0, thick, r), r * 0.95),
        "rim": rim,
        "emblem": prism(points, 1, thick + 0.09),
    }


def gem(draw: Draw) -> Parts:
    """A cut stone, point down."""
    count, r, low, high = int(draw(6, 9)), draw(0.85, 1.0), draw(0.9, 1.15), draw(0.35, 0.5)
    table = r * draw(0.5, 0.62)
    side = [(0.02, 0.0), (r, low), (table, low + high)]

    solid, step = lathe(side), 2 * math.pi / count

    def facets(p: Tensor) -> Tensor:
        # A regular polygon's distance from its middle in place of a circle's.
        angle = atan2(p[:, 1], p[:, 0]).remainder(step) - step / 2
        across = p[:, :2].norm(dim=1) * angle.cos()
        return solid(stack([across, across.new_zeros(len(p)), p[:, 2]], 1)) * 0.8

    return {"stone": facets}


def key(draw: Draw) -> Parts:
    """Upright, its bow above."""
    r, high, thick = draw(0.4, 0.5), draw(1.5, 1.8), draw(0.12, 0.14)
    bow = ring((0, 0, high + r), r, thick, 1)
    # Each as long as from the shaft's other side: what is short comes off it.
    teeth = [
        box((0.2, 0, 0.13 + 0.36 * k), (0.32, thick, 0.12)) for k in range(2 + draw.chance(0.4))
    ]
    return {
        "bow": bow,
        "shaft": join(
            tube((0, 0, 0), (0, 0, high + 0.1), thick, 0.02),
            tube((0, 0, high - 0.28), (0, 0, high - 0.08), thick + 0.08, 0.03),
        ),
        "teeth": join(*teeth),
    }


def skull(draw: Draw) -> Parts:
    """It looks forward: a round cranium, cheeks, a jaw with teeth, deep eyes."""
    wide, high = draw(0.68, 0.78), draw(0.66, 0.76)
    dome = egg((0, 0.12, 1.25), (wide, draw(0.8, 0.9), high))
    cheeks = box((0, -0.3, 0.62), (wide * 0.62, 0.36, 0.34), 0.16)
    jaw = box((0, -0.36, 0.18), (wide * draw(0.46, 0.56), 0.3, 0.22), 0.1)
    eye, nose = egg((0.29, -0.72, 1.02), (0.2, 0.3, 0.2)), egg((0, -0.72, 0.68), (0.1, 0.25, 0.14))
    gap = box((0, -0.6, 0.36), (wide * 0.4, 0.12, 0.05))
    sockets = join(
        both(egg((0.29, -0.5, 1.02), (0.19, 0.22, 0.19))), egg((0, -0.5, 0.68), (0.09, 0.2, 0.13))
    )
    return {"bone": cut(blend(0.12, dome, cheeks, jaw), both(eye), nose, gap), "eyes": sockets}


def tombstone(draw: Draw) -> Parts:
    """A slab, round above, on a plinth; a cross on it."""
    x, thick, high = draw(0.6, 0.75), draw(0.16, 0.22), draw(1.0, 1.3)
    slab = join(
        box((0, 0, high / 2), (x, thick, high / 2)), tube((0, -thick, high), (0, thick, high), x)
    )
    cross = join(
        box((0, -thick, high * 0.95), (0.09, 0.08, 0.42)),
        box((0, -thick, high * 1.05), (0.28, 0.08, 0.09)),
    )
    return {
        "slab": slab,
        "base": box((0, 0, 0.08), (x + draw(0.12, 0.2), thick + 0.18, 0.16), 0.02),
        "cross": cross,
    }


def sarcophagus(draw: Draw) -> Parts:
    """Upright, in the shape of a mummy: a striped headdress, a face, crossed arms with crooks,
    bands of gold and blue."""
    wide, deep, high = draw(0.68, 0.72), draw(0.3, 0.33), 2.14
    z, r, y = 2.56, draw(0.36, 0.38), -deep - 0.04
    half = [(0.44, 0), (0.44, 0.26), (0.34, 0.4), (0.5, 1.0), (wide, 1.6), (wide, 1.84),
            (wide - 0.2, high - 0.06), (0.24, high)]  # fmt: skip
    body = grown(prism(mirrored(half), 1, deep - 0.1), 0.08)
    hood = mirrored([(r + 0.26, 1.96), (r + 0.3, 2.14), (r + 0.14, z + 0.16), (r - 0.08, z + 0.38),
                     (0.14, z + 0.46)])  # fmt: skip
    cloth = grown(prism(hood, 1, deep - 0.07), 0.08)
    bands = [within(grown(body, 0.06), box((0, 0, v), (2, 2, e)))
             for v, e in ((0.14, 0.14), (0.56, 0.1), (0.94, 0.1))]  # fmt: skip
    folds = [within(grown(cloth, 0.05), box((0, 0, v), (2, 2, 0.075)))
             for v in (2.02, 2.32, 2.62, 2.94)]  # fmt: skip
    arm = [(wide - 0.02, y + 0.08, 1.66), (wide - 0.1, y, 1.34), (-0.16, y - 0.05, 1.66)]
    crook = [(0.14, y - 0.14, 1.36), (0.32, y - 0.16, 1.84), (0.42, y - 0.14, 2.02),
             (0.6, y - 0.12, 2.02), (0.66, y - 0.1, 1.86)]  # fmt: skip
    return {
        "body": body,
        "headdress": cloth,
        "stripes": join(*folds, egg((0, -deep - 0.08, z + 0.36), (0.11, 0.14, 0.17))),
        "face": egg((0, -deep + 0.02, z - 0.02), (r, 0.26, r + 0.06)),
        "eyes": both(egg((0.15, -deep - 0.2, z + 0.04), (0.115, 0.1, 0.09))),
        "arms": both(limb(arm, 0.13, 0.13)),
        "crooks": join(
            both(limb(crook, 0.085, 0.085)),
            taper((0, y - 0.12, z - 0.34), (0, y - 0.16, z - 0.62), 0.09, 0.12),
        ),
        "bands": join(*bands),
    }


def ship_wheel(draw: Draw) -> Parts:
    """Upright: a flat rim with turned spokes that end in handles, a hub with a cap of brass."""
    r, count, reach = draw(0.7, 0.78), 6 + 2 * draw.chance(0.65), draw(0.44, 0.52)
    wide, hub = draw(0.11, 0.14), draw(0.24, 0.3)
    end = r + reach
    spin = [(0.08, hub), (0.085, r * 0.5), (0.125, r * 0.66), (0.08, r * 0.8), (0.08, r + 0.1)]
    hold = [
        (0.075, r + wide),
        (0.08, r + 0.18),
        (0.13, end - 0.14),
        (0.115, end - 0.04),
        (0.05, end),
    ]

    def spoke(profile: list[tuple[float, float]]) -> Solid:
        return turned(lathe(smooth_curve(profile, 3)), 1, 90)

    def standing(solid: Solid) -> Solid:
        return moved(turned(solid, 0, 90), (0, 0, end))

    def hoop(out: float, within_: float, half: float) -> Solid:
        return cut(
            tube((0, 0, -half), (0, 0, half), out, 0.02), tube((0, 0, -1), (0, 0, 1), within_)
        )

    peg = both(ball((r, 0, 0.14), 0.075), 2)
    return {
        "rim": standing(hoop(r + wide, r - wide, 0.12)),
        "spokes": standing(around(count, spoke(spin))),
        "handles": standing(around(count, spoke(hold))),
        "hub": standing(tube((0, 0, -0.18), (0, 0, 0.18), hub, 0.03)),
        "cap": standing(both(egg((0, 0, 0.17), (hub * 0.62, hub * 0.62, 0.13)), 2)),
        "pegs": standing(around(count, peg, 180 / count)),
    }


ADVENTURE_PROPS_TREASURE = {
    "chest": chest,
    "open chest": open_chest,
    "barrel": barrel,
    "crate": crate,
    "coin": coin,
    "gem": gem,
    "key": key,
    "skull": skull,
    "tombstone": tombstone,
    "sarcophagus": sarcophagus,
    "ship wheel": ship_wheel,
}
