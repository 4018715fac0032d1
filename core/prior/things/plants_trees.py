"""Trees and a bush."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    box,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    taper,
    tube,
    turned,
)
from core.prior.things.shared.ropes import bent, smooth_bar


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


def _crown(draw: Draw, wide: float, high: float, z: float, count: int = 9) -> Solid:
    """Round tufts about a middle, more above than below; of few arrangements."""
    own = draw.arranged()
    tufts: list[Solid] = [egg((0, 0, z), (wide * 0.8, wide * 0.8, high * 0.85))]
    for k in range(count):
        angle, level = 2.4 * k + own(-0.3, 0.3), -0.35 + 1.15 * k / count
        reach = wide * 0.72 * math.sqrt(max(0.1, 1 - level * level))
        size = wide * own(0.36, 0.46)
        at = (reach * math.cos(angle), reach * math.sin(angle), z + high * 0.75 * level)
        tufts.append(ball(at, size))
    return join(*tufts)


def oak_tree(draw: Draw) -> Parts:
    """A broad round crown on a stout trunk with boughs and roots."""
    wide, high, top = draw(0.95, 1.15), draw(0.65, 0.85), draw(0.95, 1.2)
    z, trunk, count = top + high * 0.75, draw(0.2, 0.26), 10
    bough = taper((0.04, 0, top * 0.62), (wide * 0.55, 0, z - 0.15), trunk * 0.65, 0.1)
    root = taper((0.1, 0, 0.22), (trunk + 0.28, 0, 0.06), 0.15, 0.08)
    lobes = around(6, ball((wide * 0.68, 0, z - high * 0.3), wide * 0.36), 15)
    return {
        "leaves": join(_crown(draw, wide, high, z, count), lobes),
        "trunk": join(
            taper((0, 0, 0.1), (0, 0, z), trunk * 1.15, trunk * 0.8),
            around(4, bough, 45),
            around(5, root, 18),
        ),
    }


def palm(draw: Draw) -> Parts:
    """A bare trunk and drooping leaves."""
    top, lean, count = draw(1.7, 2.0), draw(-0.2, 0.2), 6 + draw.chance(0.5)
    rise, reach, fall = draw(0.15, 0.25), draw(0.55, 0.65), draw(0.25, 0.4)
    leaf = join(
        taper((0.05, 0, 0), (reach, 0, rise), 0.12, 0.15),
        taper((reach, 0, rise), (reach + 0.42, 0, rise - fall), 0.15, 0.07),
    )
    nut = ball((0.17, 0, -0.12), 0.14)
    trunk = join(
        taper((0, 0, 0), (lean * 0.35, 0, top * 0.55), 0.21, 0.16),
        taper((lean * 0.35, 0, top * 0.55), (lean, 0, top), 0.16, 0.13),
    )
    return {
        "leaves": moved(around(count, leaf, 15), (lean, 0, top)),
        "trunk": join(trunk, egg((0, 0, 0.05), (0.45, 0.45, 0.12))),
        "nuts": moved(around(3, nut, -90), (lean, 0, top)),
    }


def christmas_tree(draw: Draw) -> Parts:
    """A fir of four tiers in a tub, with baubles of two colours, a chain of beads and a star."""
    wide, layout = draw(0.82, 0.94), draw.arranged(2)
    low, step, tiers = 0.72, draw(0.34, 0.38), 4
    boughs, reds, golds, beads = [], [], [], []
    for k in range(tiers):
        r, z = wide * (1 - 0.2 * k), low + step * k
        boughs.append(
            lathe([(r - 0.05, z + 0.05), (r, z + 0.09), (r * 0.3, z + step * 1.45)], 0.02)
        )
        count, turn = (9, 7, 6, 5)[k], layout(0, 1) + 0.5 * k
        for i in range(count):
            a = math.tau * (i + turn) / count
            hung = ball((r * math.cos(a), r * math.sin(a), z + 0.02), 0.1)
            (reds if (i + k) % 2 else golds).append(hung)
        ends = [(wide * (0.8 - 0.2 * k) * 0.78, z + 0.33)]
        beads += [ring((0, 0, h), r, 0.07) for r, h in ends if k < tiers - 1]
    top = low + step * (tiers + 0.45) - 0.02
    point = taper((0.04, 0, 0), (0.25, 0, 0), 0.12, 0.06)
    star = moved(turned(around(5, point, 90), 0, 90), (0, 0, top + 0.18))
    return {
        "leaves": join(*boughs),
        "trunk": tube((0, 0, 0.2), (0, 0, low + 0.2), 0.17),
        "baubles": join(*reds),
        "beads": join(*golds, *beads),
        "star": star,
        "tub": lathe([(0.34, 0.0), (0.42, 0.24), (0.46, 0.25), (0.46, 0.33)], 0.02),
    }


def willow_tree(draw: Draw) -> Parts:
    """A stout trunk under a crown from which curtains of leaves hang almost to the ground."""
    wide, top, low = draw(1.1, 1.16), draw(2.2, 2.3), draw(0.86, 0.94)

    def strand(out: float, drop: float, thick: float) -> Solid:
        """Flows over the crown's rim and hangs to a point."""
        return smooth_bar([(out * 0.56, top + 0.42, thick * 0.8), (out * 0.98, top + 0.04, thick),
                           (out * 1.06, (top + drop) * 0.5, thick), (out, drop, 0.085)],
                          across=True)  # fmt: skip

    root = taper((0.14, 0, 0.3), (0.56, 0, 0.1), 0.2, 0.12)
    return {
        "leaves": join(
            blend(0.2, egg((0, 0, top + 0.1), (wide * 0.98, wide * 0.98, 0.5)),
                  egg((0, 0, top + 0.36), (0.72, 0.72, 0.5))),
            around(9, strand(wide * 0.9, low + 0.42, 0.22), 20),
        ),
        "strands": around(9, strand(wide, low, 0.2)),
        "trunk": join(taper((0, 0, 0.16), (0, 0, 1.9), 0.34, 0.26), around(5, root, 18)),
    }  # fmt: skip


def bonsai(draw: Draw) -> Parts:
    """A crooked trunk in a shallow tray, foliage in clouds."""
    side = 1 if draw.chance(0.5) else -1
    lean, top = side * draw(0.3, 0.45), draw(1.35, 1.6)
    tray = join(
        box((0, 0, 0.2), (0.85, 0.55, 0.18), 0.05),
        box((0, 0, 0.36), (0.92, 0.62, 0.07), 0.03),
        box((0, 0, 0.03), (0.65, 0.4, 0.08), 0.02),
    )
    bend = (lean, 0.0, 0.95)
    tip, left = (-lean * 0.3, 0.0, top), (-lean * 1.9, -0.05, draw(1.0, 1.15))
    right = (lean * 2.1, 0.05, draw(1.2, 1.35))
    trunk = join(
        bent([(-lean * 0.4, 0, 0.35), bend, tip], [0.22, 0.17, 0.12]),
        taper((lean * 0.3, 0, 0.72), left, 0.12, 0.1),
        taper(bend, right, 0.12, 0.1),
    )

    def cloud(at: tuple[float, float, float], size: float) -> Solid:
        tufts = around(6, egg((size * 0.6, 0, 0), (size * 0.5, size * 0.5, size * 0.42)))
        return moved(join(tufts, egg((0, 0, 0.06), (size * 0.75, size * 0.75, size * 0.6))), at)

    clouds = [cloud((tip[0], 0, top + 0.12), draw(0.52, 0.62)), cloud(left, draw(0.4, 0.48))]
    return {
        "leaves": join(*clouds, cloud(right, draw(0.42, 0.5))),
        "trunk": trunk,
        "tray": tray,
        "moss": egg((0, 0, 0.4), (0.78, 0.48, 0.12)),
    }


def bush(draw: Draw) -> Parts:
    """Tufts down to the ground, sometimes with berries."""
    wide, high = draw(0.95, 1.1), draw(0.65, 0.9)
    crown = _crown(draw, wide, high, high * 0.85, 9)
    low = around(7, ball((wide * 0.72, 0, 0.32), 0.38), 10)
    stems = join(around(3, taper((0.15, 0, -0.2), (0.2, 0, 0.4), 0.16, 0.1)))
    return {"leaves": cut(join(crown, low), box((0, 0, -2), (3, 3, 2))), "stems": stems}


def bamboo(draw: Draw) -> Parts:
    """Three straight stalks with rings from a clump of earth, flat leaves at their joints."""
    tall, r = draw(2.3, 2.6), draw(0.17, 0.21)
    outline = [(0, 0.09), (0.45, 0.22), (1.0, 0), (0.45, -0.22), (0, -0.09)]
    blade = turned(prism(outline, 1, 0.08), 1, -28)
    stalks, rings, leaves = [], [], []
    for x, y, joints, turns in (
        (0, 0.14, 4, (15, 165)),
        (0.42, -0.1, 3, (-20, 60)),
        (-0.42, -0.14, 2, (200, 270)),
    ):
        high = tall * joints / 4
        stalks.append(tube((x, y, 0), (x, y, high), r))
        for j in range(1, joints + 1):
            z = tall * j / 4 - 0.16
            rings.append(tube((x, y, z - 0.08), (x, y, z + 0.08), r + 0.06))
        for j, turn in enumerate(turns):
            leaves.append(moved(turned(blade, 2, turn), (x, y, high - 0.1 - 0.24 * j)))
    return {
        "stalks": join(*stalks),
        "rings": join(*rings),
        "leaves": join(*leaves),
        "ground": lathe([(0.82, 0), (0.74, 0.2)]),
    }


PLANTS_TREES = {
    "tree": tree,
    "oak tree": oak_tree,
    "palm": palm,
    "christmas tree": christmas_tree,
    "willow tree": willow_tree,
    "bonsai": bonsai,
    "bush": bush,
    "bamboo plant": bamboo,
}
