"""Bodies and legs of animals with four legs."""

from core.prior.draw import Draw
from core.prior.solids import Parts, Solid, ball, blend, both, egg, join, taper, tube


class Beast:
    """A standing animal's trunk, head and legs; its head to the front."""

    def __init__(
        self, draw: Draw, wide: float, long: float, leg: float, head: float, neck: tuple
    ) -> None:
        self.wide, self.long = wide * draw(0.85, 1.2), long * draw(0.85, 1.15)
        self.belly = leg * draw(0.8, 1.2) + self.wide * 0.8
        self.head = head * draw(0.9, 1.15)
        self.y = -self.long * 0.8 - neck[0] * draw(0.85, 1.2)
        self.z = self.belly + neck[1] * draw(0.85, 1.2)
        self.foot = max(0.13, self.wide * 0.32)

    def trunk(self, neck: float) -> Solid:
        """The body, neck, head and legs, without ears, tail and face."""
        wide, long, y, z = self.wide, self.long, self.y, self.z
        a, b = wide * 0.55, long * 0.66
        body = egg((0, 0, self.belly), (wide, long, wide * 0.95))
        throat = taper((0, -long * 0.6, self.belly), (0, y, z), neck * 1.25, neck)
        leg = taper((a, b, self.belly - 0.1), (a, b, self.foot), self.foot * 1.1, self.foot)
        return join(blend(0.12, body, throat, ball((0, y, z), self.head)), both(leg, 0, 1))

    def feet(self, high: float = 0.14) -> Solid:
        """Hooves: a short tube below each leg."""
        a, b = self.wide * 0.55, self.long * 0.66
        return both(tube((a, b, -0.02), (a, b, high), self.foot * 1.15, 0.02), 0, 1)

    def ears(self, high: float, thick: float = 0.12, tip: float = 0.05, out: float = 0.75) -> Solid:
        """A pair on top of the head."""
        h, y, z = self.head, self.y, self.z
        return both(
            taper((h * 0.55, y + 0.04, z + h * 0.6), (h * out, y, z + h + high), thick, tip)
        )

    def muzzle(self, reach: float, thick: float) -> Solid:
        """The front of the face."""
        y, z, h = self.y, self.z, self.head
        return taper((0, y - h * 0.4, z - 0.06), (0, y - h - reach, z - 0.1), thick * 1.15, thick)

    def eyes(self) -> Solid:
        """A pair at the front of the head."""
        h = self.head
        return both(ball((h * 0.5, self.y - h * 0.78, self.z + h * 0.36), 0.08))

    def nose(self, reach: float, size: float = 0.09) -> Solid:
        """A nose at the muzzle's end."""
        return ball((0, self.y - self.head - reach, self.z - 0.03), size)

    def tail(self, back: float, up: float, first: float = 0.1, last: float = 0.1) -> Solid:
        """A tail from the rump, whose end is ``back`` and ``up`` from there."""
        y, z = self.long * 0.85, self.belly + self.wide * 0.3
        return taper((0, y, z), (0, y + back, z + up), first, last)


def steed(draw: Draw) -> tuple[Beast, Parts]:
    """A horse's body, mane and hooves."""
    b = Beast(draw, 0.36, 0.78, 0.75, 0.23, (0.3, 0.72))
    y, z = b.y, b.z
    crest = taper((0, -b.long * 0.45, b.belly + 0.3), (0, y + 0.18, z + 0.12), 0.13, 0.13)
    lock = taper((0, y + 0.18, z + 0.12), (0, y - 0.08, z + 0.26), 0.13, 0.09)
    back, up, out = b.long * 0.92, b.belly + 0.12, draw(0.25, 0.45)
    tail = join(
        taper((0, back, up), (0, back + out, up - 0.1), 0.11, 0.14),
        taper((0, back + out, up - 0.1), (0, back + out + 0.05, up - draw(0.6, 0.8)), 0.15, 0.08),
    )
    face = taper((0, y, z), (0, y - 0.48, z - 0.3), 0.21, 0.15)
    parts = {
        "body": join(b.trunk(0.19), face, b.ears(0.16, 0.1, 0.05)),
        "mane": join(crest, lock, tail),
        "hooves": b.feet(0.16),
        "eyes": both(ball((0.19, y - 0.12, z + 0.04), 0.08)),
    }
    return b, parts


def four_legs(wide: float, long: float, high: float, thick: float) -> Solid:
    """Four legs from the height ``high`` to the ground."""
    return both(taper((wide, long, high), (wide, long, thick), thick * 1.15, thick), 0, 1)


def sitting(wide: float, z: float, head: float, arm: float) -> tuple[Solid, Solid, Solid]:
    """Trunk with head, arms, and legs of a plump sitting animal."""
    trunk = join(
        egg((0, 0, 0.58), (wide, wide * 0.92, 0.6)), egg((0, 0, z), (head * 1.1, head, head))
    )
    reach = taper((wide * 0.78, -0.1, 0.88), (wide * 0.86, -wide - arm, 0.5), 0.19, 0.17)
    leg = join(
        taper((wide * 0.6, -0.1, 0.24), (wide * 0.88, -wide - 0.2, 0.2), 0.24, 0.2),
        egg((wide * 0.9, -wide - 0.28, 0.28), (0.21, 0.16, 0.27)),
    )
    return trunk, both(reach), both(leg)


def bulk(draw: Draw, wide: float, long: float, leg: float) -> tuple[float, float, float, Solid]:
    """A heavy animal's half width, half length, height of the middle, and trunk with legs."""
    wide, long = wide * draw(0.92, 1.08), long * draw(0.92, 1.08)
    z = leg * draw(0.9, 1.1) + wide * 0.9
    a, c, r = wide * 0.56, long * 0.6, wide * 0.34
    legs = both(tube((a, c, 0), (a, c, z), r, 0.03), 0, 1)
    return wide, long, z, join(egg((0, 0, z), (wide, long, wide * 0.95)), legs)


def nails(wide: float, long: float) -> Solid:
    """Three toes at the front of each foot."""
    a, c, r = wide * 0.56, long * 0.6, wide * 0.34
    toes = [
        ball((a + r * out, s * c - r * 0.86, 0.07), 0.1) for s in (-1, 1) for out in (-0.5, 0.5)
    ]
    return both(join(*toes))
