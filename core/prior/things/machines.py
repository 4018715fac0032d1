"""Vehicles and machines of less common kinds."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    both,
    box,
    chain,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    taper,
    tube,
    turned,
)


def longship(draw: Draw) -> Parts:
    """Of vikings: a slim hull with high curled ends, shields along it, one striped sail."""
    x, y, deep, high = draw(0.36, 0.42), draw(1.06, 1.16), draw(0.42, 0.5), draw(1.6, 1.8)
    wide, tall, deck = draw(0.62, 0.72), draw(0.38, 0.44), 0.52
    body = cut(egg((0, 0, deck), (x, y + 0.1, deep)), box((0, 0, deck + 1), (2, 2, 1)))
    inner = egg((0, 0, deck + 0.1), (x - 0.13, y - 0.2, deep - 0.12))
    end = y * 0.9
    neck = [((0, end, 0.36), 0.14), ((0, end + 0.24, 0.74), 0.12), ((0, end + 0.26, 1.04), 0.11)]
    head = [((0, -end - 0.26, 1.06), 0.15), ((0, -end - 0.42, 1.02), 0.1)]
    tail = [
        ((0, end + 0.26, 1.04), 0.11),
        ((0, end + 0.1, 1.24), 0.1),
        ((0, end - 0.08, 1.14), 0.09),
    ]
    sail = high - tall - 0.08
    # Each at the hull's side, which is an ellipse.
    shields = [
        tube((side - 0.12, v, deck - 0.05), (side + 0.08, v, deck - 0.05), 0.16)
        for v in (-0.6, -0.2, 0.2, 0.6)
        for side in (x * math.sqrt(1 - (v / (y + 0.1)) ** 2),)
    ]
    half = wide / 5
    return {
        "hull": cut(body, inner),
        "prows": join(both(chain(neck), 1), chain(head), chain(tail)),
        "mast": join(
            tube((0, 0, 0.2), (0, 0, high + 0.12), 0.08),
            tube((-wide - 0.08, 0.02, high - 0.06), (wide + 0.08, 0.02, high - 0.06), 0.075),
        ),
        "sail": join(*(box((half * 2 * k, -0.07, sail), (half, 0.07, tall)) for k in (-2, 0, 2))),
        "stripes": both(box((half * 2, -0.07, sail), (half, 0.07, tall))),
        "shields": both(join(*shields)),
    }


def biplane(draw: Draw) -> Parts:
    """Two wings one above the other with struts, an engine, a propeller, wheels, a tail."""
    span, chord, r, tail = draw(1.2, 1.35), draw(0.26, 0.31), draw(0.22, 0.26), draw(1.1, 1.25)
    z, gap, nose = 0.62, draw(0.62, 0.7), -0.72
    low, top = z - 0.12, z - 0.12 + gap
    fin = [(tail - 0.34, z), (tail - 0.14, z + 0.5), (tail + 0.08, z + 0.5), (tail + 0.08, z)]
    flat = [(0, tail - 0.32), (0.42, tail - 0.16), (0.42, tail + 0.06), (0, tail + 0.06)]
    strut = [box((span * 0.66, v, (low + top) / 2), (0.065, 0.065, gap / 2)) for v in (-0.5, -0.16)]
    cabane = box((0.13, -0.33, (z + top) / 2), (0.065, 0.065, (top - z) / 2))
    blade = box((0.28, 0, 0), (0.28, 0.1, 0.06))
    wheel = 0.2
    return {
        "body": join(
            tube((0, nose + 0.2, z), (0, 0.1, z), r),
            taper((0, 0.1, z), (0, tail, z + 0.04), r, 0.09),
            prism(fin, 0, 0.07),
            both(prism(flat, 2, 0.065, z + 0.05)),
        ),
        "wings": join(
            box((0, -0.33, low), (span * 0.92, chord, 0.075), 0.03),
            box((0, -0.33, top), (span, chord, 0.075), 0.03),
        ),
        "struts": both(
            join(*strut, cabane, box((0.28, -0.42, low / 2 + 0.1), (0.065, 0.09, low / 2 - 0.06)))
        ),
        "engine": moved(
            turned(lathe([(r + 0.06, 0), (r + 0.06, 0.2), (r * 0.7, 0.32)], 0.02), 0, 90),
            (0, nose + 0.24, z),
        ),
        "propeller": moved(
            turned(
                join(around(2, blade, 90), lathe([(0.12, -0.1), (0.12, 0.04), (0.04, 0.18)])), 0, 90
            ),
            (0, nose - 0.1, z),
        ),
        "wheels": join(
            both(tube((0.2, -0.42, wheel), (0.4, -0.42, wheel), wheel)),
            tube((0, tail - 0.1, z - 0.22), (0, tail - 0.1, z), 0.08),
        ),
    }


def blimp(draw: Draw) -> Parts:
    """A long balloon with a nose cap and a band, four fins, a cabin with windows, two engines."""
    r, y, cabin = draw(0.55, 0.62), draw(1.4, 1.5), draw(0.42, 0.5)
    z, size, deep = 1.0, draw(0.42, 0.5), draw(0.16, 0.2)
    low = z - r
    hull = egg((0, 0, z), (r, y, r))
    coat = egg((0, 0, z), (r + 0.035, y + 0.03, r + 0.035))
    middle = box((0, 0, z), (2, 0.17, 2))
    nose = box((0, -y - 0.62, z), (2, 0.9, 2))
    cover = join(cut(coat, lambda p: -middle(p)), cut(coat, lambda p: -nose(p)))
    fin = [(0.1, y * 0.5), (r * 0.72 + size * 0.5, y * 0.82), (r * 0.72 + size * 0.5, y + 0.06)]
    fin.append((0.1, y * 0.92))
    fins = join(*(turned(prism(fin, 2, 0.075), 1, 45 + 90 * k) for k in range(4)))
    return {
        "balloon": hull,
        "band": cover,
        "fins": moved(fins, (0, 0, z)),
        "cabin": box((0, -0.1, low - deep + 0.12), (0.24, cabin, deep + 0.08), 0.08),
        "windows": both(box((0.18, -0.16, low - deep + 0.12), (0.1, cabin - 0.14, 0.085))),
        "engines": both(
            join(
                tube((0.36, 0.02, low - 0.02), (0.36, 0.38, low - 0.02), 0.11),
                box((0.26, 0.2, low - 0.02), (0.14, 0.07, 0.07)),
            )
        ),
    }


MACHINES = {
    "longship": longship,
    "biplane": biplane,
    "blimp": blimp,
}
