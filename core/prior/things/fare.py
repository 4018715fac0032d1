"""Fare and plants: a burrito, a cinnamon roll, garlic, a kiwi, a lily pad in flower."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
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
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)


def lily_pad(draw: Draw) -> Parts:
    """A flat round leaf with a notch to the front and a raised rim, a pink lotus in bloom on it."""
    r, rim, notch = draw(1.36, 1.44), draw(0.26, 0.29), draw(15, 17)
    slope = math.tan(math.radians(notch))
    wedge = prism([(0, -0.4), (2 * slope, -2.4), (-2 * slope, -2.4)], 2, 1)
    leaf = lathe([(r - 0.06, 0), (r, 0.1), (r, rim), (r - 0.14, rim), (r - 0.2, 0.16)], 0.02)
    vein = capsule((0.3, 0, 0.14), (r - 0.24, 0, 0.16), 0.08)
    y = 0.26

    def petal(long: float, wide: float, lean: float) -> Solid:
        """It stands at +X, leaning outwards."""
        leaf = egg((0, 0, long), (0.11, wide, long))
        return moved(turned(leaf, 1, lean), (0.12, 0, 0.22))

    bloom = join(
        around(8, petal(0.4, 0.21, 66), 22.5), around(6, petal(0.42, 0.2, 34)),
    )  # fmt: skip
    return {
        "leaf": cut(leaf, wedge),
        "veins": around(7, vein, -90 + 180 / 7),
        "petals": moved(bloom, (0, y, 0)),
        "heart": egg((0, y, 0.42), (0.2, 0.2, 0.22)),
    }


def burrito(draw: Draw) -> Parts:
    """A wrapped roll on end: foil about its lower half, its filling heaped at the open top."""
    r, foil, high = draw(0.54, 0.58), draw(1.1, 1.18), draw(2.16, 2.3)
    facet = prism([(0, 0), (r * 0.7, 0), (r + 0.04, 0.2), (r + 0.14, 0.6), (r + 0.1, 2),
                   (0, 2)], 1, 2)  # fmt: skip
    peak = prism([(-0.5, -1), (0.5, -1), (0.5, foil - 0.36), (0, foil + 0.24),
                  (-0.5, foil - 0.36)], 0, 2)  # fmt: skip
    roll = lathe([(r - 0.1, 0.2), (r, 0.4), (r, high - 0.2), (r - 0.04, high)], 0.02)
    wrap = within(
        lathe([(r, 0.4), (r + 0.08, 0.5), (r + 0.08, high - 0.16), (r + 0.04, high - 0.08)], 0.01),
        moved(turned(box((-1, 0, 0), (1, 2, 3)), 1, 24), (0.08, 0, foil + 0.4)),
    )
    mouth = tube((0, 0, high - 0.2), (0, 0, high + 1), r - 0.14)
    patch = egg((r - 0.01, 0, 0), (0.13, 0.19, 0.12))
    spots = [(-58, 0.5), (-122, 0.42), (-10, 0.62), (50, 0.45), (110, 0.6), (180, 0.5)]
    toast = [moved(turned(patch, 2, a), (0, 0, foil + (high - foil) * v)) for a, v in spots]
    z = high + 0.02
    return {
        "foil": around(8, within(facet, peak), -90),
        "tortilla": cut(join(roll, wrap), mouth),
        "toast": join(*toast),
        "meat": join(
            egg((0, 0, high - 0.14), (r - 0.06, r - 0.06, 0.22)),
            ball((-0.08, 0.2, z + 0.04), 0.21),
            ball((0.3, -0.08, z + 0.02), 0.19),
        ),
        "lettuce": join(
            *(
                egg((u, v, z), (0.22, 0.17, 0.2))
                for u, v in ((-0.36, 0.06), (0.22, 0.34), (0.06, -0.38))
            )
        ),
        "tomato": join(
            *(
                box((u, v, z + 0.08), (0.13, 0.13, 0.13), 0.03)
                for u, v in ((-0.22, -0.28), (0.0, -0.08), (-0.28, 0.4))
            )
        ),
    }


def _wound(t: float, aside: float) -> tuple[float, float]:
    """At ``t`` turns of a roll's spiral, so far outwards of it; its last bit is tucked in."""
    tuck = max(0.0, t - 1.9) / 0.25
    r = 0.14 + 0.48 * t - 0.2 * tuck * tuck + aside * (1 - 0.4 * min(1.0, tuck))
    a = math.tau * t + 1.2
    return r * math.cos(a), r * math.sin(a)


def _band(first: float, last: float, middle: float, half: float) -> list[tuple[float, float]]:
    """The outline of a band that is wound from ``first`` to ``last`` turns."""
    stops = [first + (last - first) * k / 48 for k in range(49)]
    outside = [_wound(t, middle + half) for t in stops]
    return [*outside, *(_wound(t, middle - half) for t in reversed(stops))]


def cinnamon_roll(draw: Draw) -> Parts:
    """A bun wound in a spiral, dark cinnamon between its turns, white icing that runs down it."""
    high, half = draw(0.82, 0.9), draw(0.14, 0.15)

    def wound(band: list[tuple[float, float]], top: float, thick: float, soft: float) -> Solid:
        """``thick`` from the top down, its edges round."""
        return grown(prism(band, 2, thick / 2 - soft, top - thick / 2), soft)

    def drip(turns: float, low: float) -> Solid:
        u, v = _wound(turns, half - 0.01)
        return capsule((u, v, high + 0.02), (u, v, low), 0.12)

    drips = [(1.2, 0.36), (1.36, 0.54), (1.52, 0.3), (1.68, 0.5), (1.84, 0.38)]
    return {
        "bun": join(
            wound(_band(0, 2.15, 0, half - 0.07), high, high, 0.07),
            tube((0, 0, 0), (0, 0, high - 0.04), 0.2, 0.04),
        ),
        "cinnamon": prism(
            _band(0.3, 2.1, -0.24, 0.16), 2, (high - 0.2) / 2, (high - 0.2) / 2 + 0.04
        ),
        "icing": join(
            wound(_band(0, 1.96, 0, half - 0.11), high + 0.1, 0.26, 0.09),
            ball((0.02, 0.02, high - 0.04), 0.2),
            *(drip(turns, low) for turns, low in drips),
        ),
    }


def garlic(draw: Draw) -> Parts:
    """A bulb of plump cloves about a dry neck, purple in its grooves, a disc of roots below."""
    r, high, neck = draw(0.5, 0.54), draw(0.62, 0.67), draw(0.19, 0.21)
    z = high + 0.08
    clove = join(
        egg((r, 0, z), (0.5, 0.34, high)),
        limb(
            [(r * 0.9, 0, z + high * 0.5), (r * 0.56, 0, z + high * 0.92),
             (0.16, 0, z + high * 1.3)],
            0.26, 0.12,
        ),
    )  # fmt: skip
    core = lathe(smooth_curve([(0.3, 0.1), (r * 1.46, z * 0.62), (r * 1.44, z * 1.2),
                               (0.4, z + high * 0.8), (0.16, z + high * 1.1)]))  # fmt: skip
    top = z + high * 1.1
    frond = egg((0, 0, 0.2), (0.1, 0.13, 0.26))
    return {
        "cloves": around(7, clove, -90),
        "grooves": core,
        "neck": join(
            lathe([(neck + 0.1, top - 0.1), (neck, top + 0.3), (neck, top + 0.62)], 0.02),
            around(4, moved(turned(frond, 1, 24), (0.1, 0, top + 0.42))),
        ),
        "roots": join(tube((0, 0, 0), (0, 0, 0.26), 0.46, 0.04),
                      around(8, ball((0.42, 0, 0.1), 0.11))),
    }  # fmt: skip


def kiwi(draw: Draw) -> Parts:
    """Half a kiwi, its green face with a pale middle and a ring of seeds to the front, against a
    whole brown one."""
    r, long = draw(0.94, 1.0), draw(1.2, 1.28)
    lean, deep = draw(14, 17), 0.66
    face = box((0, -2, 0), (3, 2, 3))
    half = cut(egg((0, 0, 0), (r, r * 0.92, r)), face)
    inner = tube((0, -0.05, 0), (0, 0.2, 0), r - 0.11, 0.02)
    seed = egg((0.5 * r, 0, 0), (0.15, 0.075, 0.09))
    ring_of = turned(around(10, seed, 18), 0, 90)

    def leant(solid: Solid) -> Solid:
        return tilted(solid, -lean, (0, -deep, r * 0.98))

    whole = egg((0, 0.42, 0.82), (long, 0.82, 0.82))
    return {
        "skin": join(whole, leant(half)),
        "flesh": leant(inner),
        "middle": leant(moved(egg((0, 0, 0), (0.26 * r, 0.1, 0.3 * r)), (0, -0.05, 0))),
        "seeds": leant(moved(ring_of, (0, -0.06, 0))),
        "tips": join(
            tube((long - 0.06, 0.42, 0.82), (long + 0.1, 0.42, 0.82), 0.15, 0.03),
            tube((-long + 0.06, 0.42, 0.82), (-long - 0.06, 0.42, 0.82), 0.1, 0.03),
        ),
    }


FARE = {
    "lily pad": lily_pad,
    "burrito": burrito,
    "cinnamon roll": cinnamon_roll,
    "garlic": garlic,
    "kiwi": kiwi,
}
