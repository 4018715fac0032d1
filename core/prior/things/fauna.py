"""Animals with wool, claws or great beaks, and two beasts of legend."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
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
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.animals import fitted
from core.prior.things.characters import eyes


def _hooked(at: tuple[float, float, float], size: float, long: float) -> Solid:
    """A bill at ``at`` that bends down at its end."""
    x, y, z = at
    return chain(
        [
            ((x, y, z), size),
            ((x, y - long, z - size * 0.1), size * 0.8),
            ((x, y - long * 1.35, z - size * 1.5), 0.075),
        ]
    )


def _toes(x: float, y: float, reach: float, thick: float) -> Solid:
    """Three to the front."""
    return join(
        *(capsule((x, y, thick), (x + out, y - reach, thick), thick) for out in (-0.14, 0, 0.14))
    )


def parrot(draw: Draw) -> Parts:
    """A macaw that stands upright: a great hooked beak in a white face, a long tail."""
    wide, long, head = draw(0.4, 0.46), draw(0.92, 1.1), draw(0.34, 0.39)
    z, lean = 1.0, 0.2
    y, up = -lean, z + 0.72
    root = (0, 0.22, z - 0.3)
    tail = [
        taper((x, 0.2, z - 0.3), (x * 1.7, 0.2 + long * 0.9, 0.1 - abs(x) * 0.2), 0.14, 0.1)
        for x in (-0.1, 0.1)
    ]
    wing = moved(turned(egg((0, 0, 0), (0.15, 0.34, 0.62)), 0, 24), (wide * 0.92, 0.16, z - 0.04))
    coverts = moved(turned(egg((0, 0, 0), (0.17, 0.34, 0.3)), 0, 24), (wide * 0.92, 0.03, z + 0.22))
    bill = join(
        _hooked((0, y - head * 0.72, up + 0.06), 0.2, 0.2),
        ball((0, y - head * 0.86, up - 0.18), 0.13),
        both(
            join(
                taper((0.2, -0.06, z - 0.5), (0.2, -0.1, 0.12), 0.13, 0.1),
                _toes(0.2, -0.1, 0.28, 0.09),
            )
        ),
    )
    return {
        "body": join(
            blend(0.12, egg((0, 0, z), (wide, wide * 0.92, 0.66)), ball((0, y, up), head)),
            taper(root, (0, 0.24 + long, 0.1), 0.2, 0.12),
        ),
        "wings": join(both(wing), *tail),
        "coverts": both(coverts),
        "face": both(
            egg((head * 0.52, y - head * 0.42, up + 0.02), (head * 0.5, head * 0.5, head * 0.52))
        ),
        "bill": bill,
        "eyes": eyes(head * 0.82, y - head * 0.56, up + 0.1, 0.1),
    }


def eagle(draw: Draw) -> Parts:
    """A bald eagle that stands with its wings half spread: white head and tail, a hooked beak."""
    wide, head, span = draw(0.42, 0.48), draw(0.31, 0.35), draw(1.2, 1.4)
    z, lift = 1.02, draw(0.5, 0.75)
    y, up = -0.26, z + 0.74
    vane = [(0.1, z + 0.4), (span * 0.5, z + 0.5 + lift), (span, z + 0.34 + lift)]
    vane += [
        (span * 0.98, z - 0.06 + lift * 0.4),
        (span * 0.8, z + 0.1 + lift * 0.2),
        (span * 0.78, z - 0.3 + lift * 0.2),
        (span * 0.58, z - 0.12),
        (span * 0.52, z - 0.46),
        (span * 0.34, z - 0.24),
        (0.1, z - 0.4),
    ]
    fan = [(-0.16, 0.1), (0.16, 0.1), (0.36, 0.86), (-0.36, 0.86)]
    thigh = join(taper((0.24, 0, z - 0.4), (0.24, -0.04, 0.42), 0.24, 0.15))
    return {
        "body": join(egg((0, 0, z), (wide, wide * 0.9, 0.66)), both(thigh)),
        "wings": both(prism(vane, 1, 0.1, 0.12)),
        "head": join(
            blend(
                0.1,
                ball((0, y, up), head),
                taper((0, y, up), (0, -0.1, z + 0.3), head * 0.9, wide * 0.8),
            ),
            tilted(prism(fan, 2, 0.09), -38, (0, 0.1, z - 0.36)),
        ),
        "bill": _hooked((0, y - head * 0.8, up), 0.16, 0.2),
        "legs": both(
            join(tube((0.24, -0.04, 0.1), (0.24, -0.04, 0.5), 0.1), _toes(0.24, 0.0, 0.36, 0.095))
        ),
        "eyes": eyes(head * 0.7, y - head * 0.62, up + 0.1, 0.085),
    }


def gorilla(draw: Draw) -> Parts:
    """On its knuckles: mighty arms and shoulders, a silver back, a high crown, a heavy brow."""
    wide, head, arm = draw(0.54, 0.64), draw(0.36, 0.42), draw(0.24, 0.28)
    z, y = draw(1.2, 1.34), -0.62
    up = z + 0.3
    fist = (wide + 0.26, -0.66, 0.2)
    elbow = (wide + 0.32, -0.4, 0.66)
    reach = chain([((wide * 0.86, -0.36, z), arm + 0.08), (elbow, arm), (fist, arm * 0.84)])
    leg = chain([((0.34, 0.62, 0.7), 0.36), ((0.44, 0.42, 0.4), 0.27), ((0.44, 0.52, 0.16), 0.17)])
    face = y - head * 0.72
    return {
        "body": join(
            blend(
                0.2,
                egg((0, -0.2, z - 0.06), (wide, 0.54, 0.54)),
                egg((0, 0.5, z - 0.42), (wide * 0.86, 0.5, 0.48)),
            ),
            ball((0, y, up), head),
            egg((0, y + 0.12, up + head * 0.66), (head * 0.62, head * 0.78, head * 0.72)),
            both(join(reach, leg)),
            capsule(
                (-head * 0.62, face - 0.02, up + 0.13), (head * 0.62, face - 0.02, up + 0.13), 0.13
            ),
        ),
        "face": join(
            egg((0, face + 0.02, up - 0.16), (head * 0.68, 0.26, head * 0.56)),
            egg((0, face + 0.08, up + 0.02), (head * 0.84, 0.2, 0.2)),
            both(ball((head * 1.0, y + 0.06, up + 0.02), 0.12)),
            both(egg((fist[0] - 0.02, fist[1] - 0.1, 0.16), (0.2, 0.2, 0.16))),
            both(egg((0.44, 0.34, 0.11), (0.18, 0.34, 0.12))),
        ),
        "back": egg((0, 0.46, z - 0.3), (wide * 0.8, 0.5, 0.44)),
        "eyes": eyes(head * 0.36, face - 0.06, up + 0.01, 0.08),
        "nostrils": both(ball((0.1, face - 0.22, up - 0.1), 0.08)),
    }


def llama(draw: Draw) -> Parts:
    """Woolly, a long upright neck, ears like bananas, a bright blanket on its back."""
    wide, long, leg = draw(0.4, 0.47), draw(0.6, 0.7), draw(0.62, 0.76)
    z, tall, head = leg + 0.3, draw(0.95, 1.15), 0.27
    y, up = -long - 0.16, z + tall
    shank = taper((wide * 0.5, long * 0.72, z), (wide * 0.5, long * 0.72, 0.2), 0.24, 0.15)
    tufts = [egg((0, v * long, z + 0.04), (wide, 0.36, 0.42)) for v in (-0.8, -0.25, 0.3, 0.85)]
    neck = [
        ((0.0, -long * 0.8, z + 0.1), 0.34),
        ((0.0, y + 0.02, z + 0.5), 0.25),
        ((0.0, y, up), 0.24),
    ]
    ear = chain(
        [
            ((0.15, y + 0.04, up + 0.16), 0.1),
            ((0.2, y + 0.06, up + 0.38), 0.1),
            ((0.13, y + 0.02, up + 0.56), 0.08),
        ]
    )
    back = tube((0, -long * 0.42, z + 0.02), (0, long * 0.5, z + 0.02), wide + 0.08)
    return {
        "wool": join(
            *tufts,
            chain(neck),
            ball((0, y + 0.02, up + 0.1), head),
            both(
                taper((wide * 0.5, long * 0.72, z), (wide * 0.5, long * 0.72, z - 0.3), 0.28, 0.2),
                0,
                1,
            ),
            taper((0, long + 0.2, z + 0.16), (0, long + 0.4, z + 0.2), 0.18, 0.14),
        ),
        "face": join(
            both(ear),
            taper((0, y - 0.1, up + 0.06), (0, y - 0.4, up - 0.02), 0.22, 0.16),
            both(shank, 0, 1),
        ),
        "blanket": cut(back, box((0, 0, z - 1.1), (2, 2, 1))),
        "fringe": both(box((wide + 0.02, long * 0.04, z - 0.12), (0.09, long * 0.46, 0.1))),
        "hooves": join(
            both(
                tube((wide * 0.5, long * 0.72, 0), (wide * 0.5, long * 0.72, 0.17), 0.17, 0.03),
                0,
                1,
            ),
            egg((0, y - 0.54, up + 0.03), (0.1, 0.09, 0.08)),
        ),
        "eyes": eyes(0.21, y - 0.15, up + 0.16, 0.085),
    }


def sloth(draw: Draw) -> Parts:
    """It hangs below a branch by its long arms; dark marks at its eyes, a broad pale face."""
    wide, long, head = draw(0.38, 0.44), draw(0.5, 0.6), draw(0.38, 0.43)
    z, low, out = 1.6, 0.62, draw(1.1, 1.25)
    x, y, up = -long - 0.12, -0.14, low + 0.2
    face = y - head * 0.7

    def grip(side: float, root: float) -> Solid:
        return taper(
            (root, side * 0.3, low + 0.2), (root * 1.25, side * 0.24, z - 0.06), 0.18, 0.14
        )

    def claws(side: float, at: float) -> Solid:
        return join(
            *(
                capsule((at + u, side * 0.26, z - 0.1), (at + u, side * 0.1, z + 0.16), 0.085)
                for u in (-0.17, 0, 0.17)
            )
        )

    roots = (-long * 0.8, long * 0.8)
    marks = both(
        taper((head * 0.34, face - 0.04, 0.06), (head * 0.8, face + 0.12, -0.06), 0.13, 0.1)
    )
    return {
        "body": join(
            egg((0, 0, low), (long + 0.24, wide, wide)),
            ball((x, y, up), head),
            *(grip(side, root) for side in (-1, 1) for root in roots),
        ),
        "face": egg((x, face + 0.1, up), (head * 0.86, 0.26, head * 0.76)),
        "marks": moved(marks, (x, 0, up + 0.04)),
        "claws": join(*(claws(side, root * 1.25) for side in (-1, 1) for root in roots)),
        "branch": tube((-out, 0, z), (out, 0, z), 0.14, 0.04),
        "eyes": join(
            moved(both(ball((head * 0.38, face - 0.15, 0), 0.085)), (x, 0, up + 0.09)),
            egg((x, face - 0.14, up - 0.08), (0.13, 0.12, 0.085)),
        ),
    }


def griffin(draw: Draw) -> Parts:
    """A lion's body and tail, an eagle's head, chest and claws; raised wings."""
    wide, long, leg = draw(0.36, 0.42), draw(0.66, 0.78), draw(0.62, 0.74)
    z, head, lift = leg + 0.26, draw(0.32, 0.37), draw(0.95, 1.15)
    y, up = -long - 0.32, z + draw(0.6, 0.7)
    hind = chain(
        [
            ((wide * 0.7, long * 0.8, z - 0.05), 0.3),
            ((wide * 0.75, long * 0.98, 0.42), 0.17),
            ((wide * 0.75, long * 0.86, 0.16), 0.15),
        ]
    )
    fore = taper((wide * 0.66, -long * 0.74, z), (wide * 0.7, -long * 0.9, 0.36), 0.25, 0.17)
    vane = [
        (-long * 0.7, z),
        (-long * 0.62, z + lift * 0.75),
        (0.0, z + lift + 0.1),
        (long + 0.42, z + lift),
    ]
    vane += [
        (long + 0.3, z + lift * 0.72),
        (long * 0.9, z + lift * 0.7),
        (long * 0.82, z + lift * 0.44),
        (long * 0.4, z + lift * 0.4),
        (0.12, z),
    ]
    wing = moved(turned(prism(vane, 0, 0.1), 1, 24), (wide * 0.66 - z * 0.42, 0, 0.08))
    tail = [(0, long, z + 0.1), (0, long + 0.5, z - 0.06), (0, long + 0.72, z + 0.36)]
    ear = taper(
        (head * 0.6, y + 0.1, up + head * 0.7),
        (head * 0.85, y + 0.22, up + head * 1.45),
        0.13,
        0.075,
    )
    foot = both(
        join(
            taper((wide * 0.7, -long * 0.9, 0.4), (wide * 0.7, -long * 0.95, 0.13), 0.14, 0.12),
            _toes(wide * 0.7, -long * 0.9, 0.3, 0.095),
        )
    )
    return {
        "body": join(
            blend(
                0.15, egg((0, 0.1, z), (wide, long, wide)), ball((0, long * 0.7, z), wide * 0.95)
            ),
            both(join(hind, egg((wide * 0.75, long * 0.72, 0.12), (0.18, 0.3, 0.13)))),
            limb(tail, 0.1, 0.09),
        ),
        "feathers": join(
            blend(
                0.1,
                ball((0, y, up), head),
                taper(
                    (0, y + 0.06, up - 0.1), (0, -long * 0.7, z + 0.06), head * 0.86, wide + 0.06
                ),
            ),
            both(join(ear, fore)),
        ),
        "wings": both(wing),
        "bill": join(_hooked((0, y - head * 0.76, up - 0.02), 0.18, 0.22), foot),
        "tuft": taper(tail[-1], (0, long + 0.76, z + 0.56), 0.19, 0.1),
        "eyes": eyes(head * 0.72, y - head * 0.6, up + 0.1, 0.09),
    }


def minotaur(draw: Draw) -> Parts:
    """A bull's head with great horns on a mighty man with hooves; a double axe."""
    wide, leg, head = draw(0.62, 0.67), draw(0.64, 0.7), draw(0.44, 0.47)
    top = leg + draw(0.76, 0.82)
    z, y = top + 0.26, -0.2
    face, mouth = y - head - 0.1, z - 0.24
    x, front, hold = wide + 0.4, -0.36, leg + 0.2
    arm = taper((wide * 0.98, 0, top - 0.2), (x, front, hold), 0.28, 0.2)
    shank = taper((wide * 0.5, 0, leg), (wide * 0.56, 0, 0.2), 0.3, 0.2)
    horn = [
        ((head * 0.7, y, z + head * 0.56), 0.17),
        ((head * 1.6, y, z + head * 0.66), 0.15),
        ((head * 1.95, y - 0.06, z + head * 1.1), 0.12),
        ((head * 1.95, y - 0.12, z + head * 1.6), 0.07),
    ]
    mid = leg + 0.92
    blade = [(x, mid + 0.12), (x + 0.36, mid + 0.38), (x + 0.46, mid), (x + 0.36, mid - 0.38)]
    blade += [(x, mid - 0.12)]
    halves = (blade, [(2 * x - a, b) for a, b in blade])
    flap = [(-0.3, leg + 0.1), (0.3, leg + 0.1), (0.24, leg - 0.36), (-0.24, leg - 0.36)]
    return {
        "body": join(
            taper((0, 0, top - 0.26), (0, 0, leg + 0.06), 0.44, 0.36),
            both(egg((wide * 0.46, -0.12, top - 0.28), (wide * 0.54, 0.38, 0.32))),
            both(arm),
            both(ball((x, front, hold), 0.24)),
        ),
        "fur": join(
            ball((0, y, z), head),
            both(taper((head * 0.8, y + 0.06, z), (head * 1.55, y, z - 0.12), 0.14, 0.1)),
            egg((0, 0.2, top), (wide * 0.76, 0.36, 0.36)),
            both(shank),
            both(ball((0.15, face - 0.17, mouth + 0.08), 0.09)),
        ),
        "horns": join(
            both(chain(horn)),
            both(lathe([(0.27, 0), (0.22, 0.24)], 0.02, (wide * 0.56, 0.0))),
            egg((0, face + 0.06, mouth), (0.35, 0.28, 0.26)),
        ),
        "loincloth": join(
            tube((0, 0, leg - 0.04), (0, 0, leg + 0.2), 0.5, 0.03),
            both(prism(flap, 1, 0.1, 0.44), 1),
            tube((x, front, 0.1), (x, front, mid + 0.44), 0.09),
        ),
        "axe": join(*(prism(half, 1, 0.1, front) for half in halves)),
        "eyes": both(ball((head * 0.46, y - head * 0.78, z + head * 0.36), 0.13)),
    }


FAUNA = {
    "parrot": parrot,
    "eagle": eagle,
    "gorilla": gorilla,
    "llama": fitted(llama),
    "griffin": fitted(griffin),
    "minotaur": minotaur,
    "sloth": sloth,
}
