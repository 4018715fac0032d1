"""What is put up or hung up: a column, a helm, boards with papers, and a kit on the wall."""

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
    tube,
    turned,
)


def column(draw: Draw) -> Parts:
    """A fluted shaft on a round base; a plain, a scrolled or a leafy capital."""
    high, r, kind = draw(2.1, 2.5), draw(0.34, 0.42), draw.which(3)
    low, up, slim = 0.46, high - 0.5, r * draw(0.82, 0.9)
    wide = r * 1.5
    flute = capsule((r + 0.035, 0, low + 0.22), (slim + 0.035, 0, up - 0.12), 0.092)
    shaft = lathe(smooth_curve([(r, low - 0.1), (r * 0.99, (low + up) / 2), (slim, up + 0.1)]))
    square = box((0, 0, 0.11), (wide, wide, 0.11), 0.01)
    bell = [(slim, up), (slim + 0.02, up + 0.1), (wide - 0.08, up + 0.32), (wide - 0.08, up + 0.4)]
    scroll = tube((wide - 0.06, -r * 1.14, up + 0.2), (wide - 0.06, r * 1.14, up + 0.2), 0.22, 0.03)
    eye = tube(
        (wide - 0.06, -r * 1.14 - 0.05, up + 0.2), (wide - 0.06, r * 1.2, up + 0.2), 0.09, 0.02
    )
    pad = box((0, 0, up + 0.28), (wide - 0.1, r * 1.04, 0.1), 0.03)
    # A leaf stands against the bell, its tip rolled outwards.
    roll = slim + 0.2, up + 0.27
    tip = capsule((roll[0], -0.07, roll[1]), (roll[0], 0.07, roll[1]), 0.09)
    leaf = join(egg((slim + 0.05, 0, up + 0.1), (0.12, 0.18, 0.26)), tip)
    fancy = {
        0: ring((0, 0, up - 0.1), slim + 0.02, 0.075),
        1: both(eye),
        2: around(8, leaf),
    }
    return {
        "shaft": cut(shaft, around(12, flute)),
        "base": join(square, ring((0, 0, 0.32), r + 0.05, 0.12)),
        "capital": join(pad, both(scroll)) if kind == 1 else lathe(bell, 0.02),
        "slab": box((0, 0, high - 0.03), (wide, wide, 0.09), 0.01),
        "rings": join(*(ring((0, 0, h), q, 0.08) for h, q in ((low, r), (up, slim)))),
        "ornament": fancy[kind],
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


def notice_board(draw: Draw) -> Parts:
    """Cork in a frame of wood, with notes of three colours that hang from round pins."""
    wide, high, y = draw(1.0, 1.14), draw(0.78, 0.9), 0.07
    layout, rim = draw.arranged(3), 0.075
    colors: list[list[Solid]] = [[], [], []]
    pins = []
    for column_ in range(3):
        for row in range(2):
            u = (column_ - 1) * (wide - rim) * 0.62 + layout(-0.05, 0.05)
            v = high + (row - 0.5) * (high - rim) * 0.92 + layout(-0.03, 0.03)
            half_u, half_v = layout(0.17, 0.22), layout(0.17, 0.23)
            sheet = turned(box((0, 0, 0), (half_u, 0.06, half_v)), 1, layout(-9, 9))
            colors[(column_ + 2 * row) % 3].append(moved(sheet, (u, -y - 0.02, v)))
            pins.append(ball((u, -y - 0.11, v + half_v * 0.62), 0.075))
    frame = cut(
        box((0, 0, high), (wide, 0.13, high), 0.02),
        box((0, -1, high), (wide - 2 * rim, 1, high - 2 * rim)),
    )
    papers, notes, cards = (join(*some) for some in colors)
    return {
        "frame": frame,
        "cork": box((0, 0, high), (wide - rim, y, high - rim)),
        "paper": papers,
        "notes": notes,
        "cards": cards,
        "pins": join(*pins),
    }


def clipboard(draw: Draw) -> Parts:
    """A board that leans back a little, with a ticked list of lines under a clip."""
    wide, high, y = draw(0.72, 0.82), draw(1.96, 2.14), 0.09
    rows, lean = 3 + draw.which(3), draw(6, 14)
    step = (high - 0.62) / rows
    bars, boxes = [], []
    for k in range(rows):
        z = 0.18 + step * (k + 0.5)
        short = 0.16 * (k % 2)
        bars.append(box((0.16 - short / 2, -y - 0.08, z), (wide - 0.42 - short / 2, 0.06, 0.07)))
        boxes.append(box((0.27 - wide, -y - 0.09, z), (0.09, 0.07, 0.09), 0.01))
    hook = cut(
        tube((0, -0.08, high), (0, 0.08, high), 0.24, 0.02),
        tube((0, -1, high + 0.04), (0, 1, high + 0.04), 0.1),
    )
    jaw = [(-0.44, high - 0.3), (0.44, high - 0.3), (0.34, high - 0.04), (-0.34, high - 0.04)]
    parts = {
        "board": box((0, 0, high / 2), (wide, y, high / 2), 0.06),
        "paper": box((0, -y, high / 2 - 0.06), (wide - 0.1, 0.065, high / 2 - 0.16)),
        "lines": join(*bars),
        "boxes": join(*boxes),
        "clip": join(grown(prism(jaw, 1, 0.12, -y - 0.04), 0.03), hook),
        "bar": tube((-0.42, -y - 0.16, high - 0.3), (0.42, -y - 0.16, high - 0.3), 0.09, 0.02),
    }
    return {name: turned(solid, 0, -lean) for name, solid in parts.items()}


def first_aid_kit(draw: Draw) -> Parts:
    """A case that stands, a cross on its front, with a handle, latches and a band."""
    wide, deep, high = draw(0.82, 0.94), draw(0.32, 0.42), draw(0.56, 0.64)
    size, arm, corner = high * draw(0.56, 0.64), draw(0.13, 0.16), draw(0.1, 0.2)
    seam = high * 2 * 0.74
    plus = join(
        *(box((0, 0, high * 0.92), (a, deep + 0.06, b)) for a, b in ((size, arm), (arm, size)))
    )
    grip = [(0.4, 0, 2 * high - 0.06), (0.36, 0, 2 * high + 0.22), (0, 0, 2 * high + 0.25)]
    latch = box((wide * 0.66, -deep - 0.02, seam), (0.12, 0.08, 0.17), 0.02)
    foot = box((wide * 0.74, 0, 0), (0.14, deep * 0.7, 0.07), 0.02)
    return {
        "body": box((0, 0, high), (wide, deep, high), corner),
        "cross": plus,
        "handle": both(limb(grip, 0.09, 0.09)),
        "latches": both(latch),
        "band": cut(
            box((0, 0, seam), (wide + 0.045, deep + 0.045, 0.065), 0.02),
            box((0, -deep, high), (size + 0.09, 0.3, size + 0.09)),
        ),
        "feet": both(foot),
    }


FURNISHINGS = {
    "column": column,
    "ship wheel": ship_wheel,
    "notice board": notice_board,
    "clipboard": clipboard,
    "first aid kit": first_aid_kit,
}
