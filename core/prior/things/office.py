"""What stands on a desk, in an office and on a stage."""

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
    join,
    lathe,
    moved,
    prism,
    smooth_curve,
    tube,
    turned,
)


def stapler(draw: Draw) -> Parts:
    """Its jaws open to the left, its hinge at the right."""
    long, y, gape = draw(1.15, 1.28), draw(0.24, 0.29), draw(9, 13)
    thick = draw(0.3, 0.36)
    hinge = (long - 0.2, 0.3)
    side = [(-1.98 * long + 0.2, -0.02), (0.26, -0.02), (0.26, thick * 0.8), (0.1, thick * 1.16)]
    side += [(-long * 0.8, thick * 1.24), (-1.8 * long, thick * 0.8)]
    at = (hinge[0], 0, hinge[1])

    def jaw(solid: Solid) -> Solid:
        return moved(turned(solid, 1, gape), at)

    return {
        "body": jaw(prism(smooth_curve(side[2:], 2) + side[:2], 1, y)),
        "magazine": jaw(box((-long * 0.9 + 0.06, 0, -0.1), (long * 0.9, y * 0.72, 0.13), 0.02)),
        "base": box((0, 0, 0.09), (long, y + 0.04, 0.09), 0.04),
        "hinge": join(
            box((hinge[0], 0, 0.26), (0.24, y + 0.03, 0.24), 0.04),
            tube((hinge[0], -y - 0.06, 0.34), (hinge[0], y + 0.06, 0.34), 0.11, 0.02),
        ),
        "plate": box((-long * 0.78, 0, 0.17), (0.17, y * 0.7, 0.06), 0.02),
    }


def safe(draw: Draw) -> Parts:
    """A steel box, a dial and a wheel with handles on its door."""
    x, y, z = draw(0.78, 0.9), draw(0.66, 0.78), draw(0.82, 0.98)
    foot, rim, dial = 0.14, draw(0.15, 0.19), draw(0.17, 0.21)
    middle, front = foot + z, -y - 0.06
    reach = draw(0.3, 0.36)
    spoke = capsule((0, 0, 0), (reach, 0, 0), 0.08)
    wheel = join(
        turned(around(3, spoke, 0), 0, 90),
        turned(around(3, ball((reach, 0, 0), 0.12), 0), 0, 90),
        tube((0, -0.12, 0), (0, 0.14, 0), 0.15, 0.03),
    )
    hinge = tube((-x + 0.04, front, 0), (-x + 0.04, front, 0.3), 0.09, 0.02)
    return {
        "body": box((0, 0, middle), (x, y, z), draw(0.04, 0.09)),
        "door": box((0, -y, middle), (x - rim, 0.1, z - rim), 0.03),
        "dial": join(
            tube((-x * 0.36, front - 0.14, middle), (-x * 0.36, 0, middle), dial, 0.03),
            tube((-x * 0.36, front - 0.24, middle), (-x * 0.36, 0, middle), dial * 0.5, 0.03),
        ),
        "handle": moved(turned(wheel, 1, 30), (x * 0.26, front - 0.16, middle)),
        "hinges": join(
            moved(hinge, (0, 0, middle + z * 0.4)), moved(hinge, (0, 0, middle - z * 0.4 - 0.3))
        ),
        "feet": both(box((x - 0.18, y - 0.18, foot * 0.6), (0.14, 0.14, foot * 0.6), 0.02), 0, 1),
    }


def harp(draw: Draw) -> Parts:
    """Its pillar at the left, its neck above, its sound box slanting down from the right."""
    high, reach, foot = draw(2.2, 2.4), draw(0.66, 0.76), draw(0.34, 0.4)
    left, low, dip = -0.72, 0.22, draw(0.24, 0.32)
    right = left + 2 * reach
    top = high * 0.86
    thick = 0.12
    neck = [
        (left - 0.06, high),
        (left + reach * 0.5, high - dip),
        (right - reach * 0.5, top - 0.06),
    ]
    neck += [(right + 0.16, top + 0.02)]
    line = smooth_curve(neck, 4)
    slab = [*((a, b + 0.11) for a, b in line), *((a, b - 0.13) for a, b in reversed(line))]
    chest = [(left + 0.1, low), (left + 0.52, low), (right + 0.26, top), (right - 0.08, top)]
    strings = []
    for k in range(5):
        x = left + 0.27 + (2 * reach - 0.42) * (k + 0.2) / 5
        # Where the sound box's upper side is below x.
        z = low + (top - low) * (x - left - 0.16) / (right - left - 0.18)
        strings.append(tube((x, 0, max(z, low)), (x, 0, top + 0.02), 0.055))
    return {
        "body": prism(chest, 1, draw(0.2, 0.26)),
        "neck": prism(slab, 1, thick + 0.03),
        "pillar": join(
            lathe([(0.1, low), (0.1, high - 0.1)], 0.02, (left, 0)),
            *(lathe([(0.17, v), (0.17, v + 0.12)], 0.02, (left, 0)) for v in (0.36, high - 0.2)),
        ),
        "strings": join(*strings),
        "base": box((left + 0.28, 0, low / 2 + 0.02), (0.46, foot * 0.9, low / 2 + 0.02), 0.04),
        "crown": lathe(
            smooth_curve([(0.12, high - 0.02), (0.2, high + 0.14), (0.06, high + 0.26)]),
            0.02,
            (left, 0),
        ),
    }


def accordion(draw: Draw) -> Parts:
    """Its bellows between two cases, keys on the left of the picture and buttons on the right."""
    y, high, case = draw(0.42, 0.46), draw(0.94, 1.02), draw(0.3, 0.33)
    count, pitch = 4, draw(0.28, 0.3)
    inner = count * pitch / 2
    right, left = inner + case / 2, -inner - 0.4
    folds = [box((pitch * (k - 1.5), 0, high), (0.085, y, high * 0.92), 0.02) for k in range(count)]
    keys = [
        box((left - 0.17, -y - 0.03, high * (1 + v)), (0.32, 0.15, high * 0.12), 0.03)
        for v in (-0.68, -0.34, 0.0, 0.34, 0.68)
    ]
    buttons = [
        tube((right, -y - 0.11, high * (1 + v)), (right, 0, high * (1 + v)), 0.1)
        for v in (-0.68, -0.34, 0.0, 0.34, 0.68)
    ]
    return {
        "body": join(
            box((right, 0, high), (case / 2 + 0.02, y + 0.03, high), 0.06),
            box((left, 0, high), (0.42, y + 0.03, high), 0.06),
        ),
        "bellows": box((0, 0, high), (inner + 0.04, y - 0.12, high * 0.92 - 0.12)),
        "folds": join(*folds),
        "keys": join(*keys),
        "buttons": join(*buttons),
        "grille": box((-inner - 0.13, -y - 0.03, high), (0.08, 0.08, high * 0.8), 0.02),
    }


def hair_dryer(draw: Draw) -> Parts:
    """Upright on its handle, its nozzle to the left."""
    r, long, high = draw(0.36, 0.42), draw(0.46, 0.54), draw(1.15, 1.3)
    nozzle, lean, grip = draw(0.48, 0.56), draw(0.1, 0.18), draw(0.16, 0.19)
    x = 0.28
    mouth = -x - long - nozzle
    barrel = lathe(smooth_curve([(r * 0.72, -long - 0.1), (r * 0.95, 0), (r, long)]), 0.0)
    cone = lathe([(r * 0.8, 0), (r * 0.62, nozzle * 0.8), (r * 0.68, nozzle)], 0.01)
    at = (x, 0.0, high)
    stem = [(x - 0.16, high), (x + 0.22, high), (x + 0.2 + lean, 0), (x - 0.1 + lean, 0)]
    return {
        "body": join(
            moved(turned(barrel, 1, 90), at), moved(ball((0, 0, 0), r), (x + long, 0, high))
        ),
        "nozzle": cut(
            moved(turned(cone, 1, -90), (x - long + 0.06, 0, high)),
            tube((mouth - 1, 0, high), (mouth + 0.5, 0, high), r * 0.42),
        ),
        "grip": prism(stem, 1, grip),
        "grille": join(
            tube((x + long + r * 0.72, 0, high), (x + long + r + 0.06, 0, high), r * 0.66, 0.03),
        ),
        "buttons": join(
            *(
                box((x - 0.1 + lean * t, 0, high * (1 - t)), (0.14, 0.09, 0.09), 0.03)
                for t in (0.46, 0.66)
            )
        ),
        "ring": tube((x - long - 0.06, 0, high), (x - long + 0.1, 0, high), r * 0.86, 0.03),
    }


def security_camera(draw: Draw) -> Parts:
    """Its lens to the front under a hood, on a post with a round foot."""
    x, y, z = draw(0.34, 0.4), draw(0.74, 0.84), draw(0.32, 0.37)
    foot, post, dip = draw(0.46, 0.54), draw(0.62, 0.76), draw(8, 14)
    middle = post + z + 0.14
    hood = join(
        box((0, -0.14, z + 0.05), (x + 0.14, y + 0.14, 0.08), 0.02),
        both(box((x + 0.07, -0.14, z * 0.5), (0.075, y + 0.14, z * 0.5 + 0.1), 0.02)),
    )

    def aimed(solid: Solid) -> Solid:
        return moved(turned(solid, 0, dip), (0, 0, middle))

    return {
        "body": aimed(box((0, 0, 0), (x, y, z), 0.05)),
        "hood": aimed(hood),
        "lens": aimed(tube((0, -y - 0.12, 0), (0, 0, 0), x * 0.74, 0.03)),
        "glass": aimed(tube((0, -y - 0.15, 0), (0, 0, 0), x * 0.42, 0.02)),
        "stand": join(
            lathe([(foot, 0), (foot, 0.12), (foot * 0.5, 0.2)], 0.02),
            tube((0, 0, 0.1), (0, 0, post), 0.13),
            ball((0, 0, post), 0.21),
        ),
        "light": aimed(ball((x * 0.68, -y, -z * 0.7), 0.075)),
    }


OFFICE = {
    "stapler": stapler,
    "safe": safe,
    "harp": harp,
    "accordion": accordion,
    "hair dryer": hair_dryer,
    "security camera": security_camera,
}
