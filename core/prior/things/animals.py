"""Four-legged animals."""

from collections.abc import Callable

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    capsule,
    egg,
    join,
    prism,
    taper,
    tube,
)


def fitted(family: Callable[[Draw], Parts]) -> Callable[[Draw], Parts]:
    """``family`` made smaller and set back, so that a long beast stays within the bounds."""

    def smaller(solid: Solid) -> Solid:
        return lambda p: solid((p - p.new_tensor((0, 0.2, -0.4))) / 0.72) * 0.72

    return lambda draw: {name: smaller(solid) for name, solid in family(draw).items()}


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
        """All but ears, tail and face."""
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
        """At the muzzle's end."""
        return ball((0, self.y - self.head - reach, self.z - 0.03), size)

    def tail(self, back: float, up: float, first: float = 0.1, last: float = 0.1) -> Solid:
        """From the rump, its end ``back`` and ``up`` from there."""
        y, z = self.long * 0.85, self.belly + self.wide * 0.3
        return taper((0, y, z), (0, y + back, z + up), first, last)


def cat(draw: Draw) -> Parts:
    """Triangular ears, a long raised tail, a short muzzle."""
    b = Beast(draw, 0.32, 0.68, 0.42, 0.4, (0.14, 0.42))
    h, y, z = b.head, b.y, b.z
    ear = prism([(0.06, z + h * 0.7), (h, z + h * 0.3), (h * 0.9, z + h + 0.24)], 1, 0.07, y)
    back, up, bend = b.long * 0.85, b.belly + 0.1, draw(0.2, 0.4)
    tail = join(
        taper((0, back, up), (0, back + bend, up + 0.35), 0.12, 0.11),
        taper((0, back + bend, up + 0.35), (0, back + bend, up + draw(0.7, 1.0)), 0.11, 0.11),
    )
    cheeks = both(egg((0.11, y - h * 0.88, z - 0.14), (0.16, 0.13, 0.12)))
    return {
        "body": join(b.trunk(0.22), both(ear), tail),
        "muzzle": cheeks,
        "eyes": both(egg((h * 0.45, y - h * 0.86, z + 0.1), (0.09, 0.07, 0.11))),
        "nose": ball((0, y - h - 0.06, z - 0.05), 0.08),
    }


def dog(draw: Draw) -> Parts:
    """Hanging or raised ears, a long muzzle."""
    b = Beast(draw, 0.36, 0.72, 0.5, 0.34, (0.22, 0.5))
    h, hang = b.head, draw.chance(0.6)
    low = taper((h * 0.8, b.y, b.z + h * 0.5), (h * 1.1, b.y, b.z - 0.22), 0.12, 0.14)
    return {
        "body": join(b.trunk(0.22), b.tail(0.35, draw(0.2, 0.5), 0.11, 0.09)),
        "ears": both(low) if hang else b.ears(0.16, 0.14, 0.05),
        "muzzle": b.muzzle(0.16, 0.16),
        "eyes": b.eyes(),
        "nose": b.nose(0.28, 0.1),
    }


def wolf(draw: Draw) -> Parts:
    """Pointed ears, a bushy tail that hangs."""
    b = Beast(draw, 0.38, 0.8, 0.55, 0.34, (0.28, 0.4))
    return {
        "body": join(b.trunk(0.28), b.ears(0.2, 0.14, 0.04)),
        "muzzle": b.muzzle(0.2, 0.14),
        "eyes": b.eyes(),
        "nose": b.nose(0.3, 0.09),
        "tail": b.tail(0.3, draw(-0.5, -0.3), 0.13, 0.15),
    }


def fox(draw: Draw) -> Parts:
    """Large ears, a thick tail with a tip."""
    b = Beast(draw, 0.3, 0.66, 0.42, 0.33, (0.22, 0.36))
    y, z = b.long * 0.85, b.belly + 0.1
    up = draw(-0.05, 0.3)
    return {
        "body": join(
            b.trunk(0.2),
            b.ears(0.24, 0.16, 0.04),
            taper((0, y - 0.1, z), (0, y + 0.45, z + up), 0.11, 0.21),
        ),
        "tail tip": taper((0, y + 0.5, z + up), (0, y + 0.8, z + up * 1.4), 0.2, 0.07),
        "muzzle": b.muzzle(0.18, 0.11),
        "eyes": b.eyes(),
        "nose": b.nose(0.26, 0.085),
    }


def bear(draw: Draw) -> Parts:
    """Heavy, with round ears."""
    b = Beast(draw, 0.55, 0.85, 0.35, 0.4, (0.2, 0.25))
    ear = ball((b.head * 0.72, b.y, b.z + b.head * 0.75), 0.15)
    return {
        "body": join(b.trunk(0.38), both(ear), ball((0, b.long, b.belly + 0.1), 0.14)),
        "muzzle": b.muzzle(0.08, 0.18),
        "eyes": b.eyes(),
        "nose": b.nose(0.22, 0.11),
    }


def lion(draw: Draw) -> Parts:
    """A mane, a tail with a tuft."""
    b = Beast(draw, 0.4, 0.8, 0.45, 0.36, (0.25, 0.36))
    y, z, up = b.long * 0.85, b.belly + 0.12, draw(-0.2, 0.3)
    mane = egg((0, b.y + 0.2, b.z - 0.02), (0.6, 0.34, draw(0.58, 0.66)))
    return {
        "body": join(b.trunk(0.28), b.tail(0.5, up)),
        "mane": join(mane, ball((0, y + 0.52, z + up), 0.16)),
        "muzzle": b.muzzle(0.02, 0.18),
        "eyes": b.eyes(),
        "nose": b.nose(0.18, 0.1),
    }


def _patches(draw: Draw, b: Beast) -> Solid:
    """Raised spots on the flanks and the back."""
    # Eggs a little inside the body's own: what stands out of it is a spot.
    side = both(egg((b.wide * 0.7, b.long * draw(-0.3, 0), b.belly), (0.18, 0.26, 0.24)))
    back = egg((0.1, b.long * draw(0.3, 0.5), b.belly + b.wide * 0.5), (0.36, 0.28, 0.3))
    face = egg((b.head * 0.5, b.y - b.head * 0.5, b.z + b.head * 0.35), (0.2, 0.22, 0.2))
    return join(side, back, face)


def cow(draw: Draw) -> Parts:
    """Horns, a broad muzzle, an udder."""
    b = Beast(draw, 0.46, 0.85, 0.5, 0.33, (0.25, 0.35))
    h, y, z = b.head, b.y, b.z
    ear = taper((h * 0.7, y, z + 0.08), (h + 0.25, y, z + 0.1), 0.1, 0.1)
    horn = taper((h * 0.5, y, z + h * 0.7), (h * 0.95, y, z + h + draw(0.15, 0.25)), 0.11, 0.07)
    return {
        "body": join(b.trunk(0.28), both(ear), b.tail(0.12, -0.5)),
        "muzzle": b.muzzle(0.12, 0.21),
        "horns": both(horn),
        "eyes": b.eyes(),
        "udder": ball((0, b.long * 0.35, b.belly - b.wide * 0.85), 0.2),
        "patches": _patches(draw, b),
    }


def sheep(draw: Draw) -> Parts:
    """A barrel of wool with a dark face and legs, the eyes on the face's front."""
    wide, long, z = draw(0.52, 0.62), draw(0.3, 0.42), draw(0.92, 1.04)
    y, up, head = -long - wide * 0.72, z + 0.34, draw(0.3, 0.35)
    leg = tube((0.3, long * 0.9, 0), (0.3, long * 0.9, z), 0.15)
    return {
        "wool": join(
            capsule((0, -long, z), (0, long, z), wide),
            ball((0, y + 0.06, up + head * 0.85), 0.26),
            ball((0, long + wide, z + 0.2), 0.18),
        ),
        "head": join(
            ball((0, y, up), head),
            capsule((0, y, up - 0.05), (0, y - 0.24, up - 0.14), 0.22),
            both(capsule((0.2, y + 0.05, up + 0.14), (0.52, y + 0.05, up + 0.02), 0.11)),
        ),
        "legs": both(leg, 0, 1),
        "eyes": both(ball((head * 0.5, y - head * 0.78, up + head * 0.34), 0.12)),
        "pupils": both(ball((head * 0.54, y - head * 0.78 - 0.08, up + head * 0.34), 0.09)),
    }


def elephant(draw: Draw) -> Parts:
    """A trunk, big ears, tusks."""
    b = Beast(draw, 0.58, 0.82, 0.45, 0.42, (0.15, 0.3))
    y, z, h = b.y, b.z, b.head
    nose = (0, y - h - 0.22, z - 0.5)
    tusk = taper((0.2, y - h * 0.7, z - 0.2), (0.26, y - h - 0.35, z - 0.22), 0.1, 0.07)
    return {
        "body": join(
            b.trunk(0.36),
            taper((0, y - h * 0.6, z - 0.05), nose, 0.2, 0.14),
            taper(nose, (0, nose[1] - draw(0, 0.2), 0.2), 0.14, 0.11),
            b.tail(0.15, -0.4),
        ),
        "ears": both(egg((h + 0.22, y + 0.15, z), (0.4, 0.11, draw(0.42, 0.52)))),
        "tusks": both(tusk),
        "eyes": b.eyes(),
    }


def giraffe(draw: Draw) -> Parts:
    """A very long neck, two horns."""
    b = Beast(draw, 0.34, 0.58, 0.8, 0.22, (0.2, 1.3))
    return {
        "body": join(b.trunk(0.15), b.tail(0.12, -0.4)),
        "muzzle": b.muzzle(0.2, 0.14),
        "horns": b.ears(0.16, 0.09, 0.1),
        "eyes": both(ball((b.head * 0.75, b.y - 0.12, b.z + 0.08), 0.08)),
    }


ANIMALS = {
    "cat": fitted(cat),
    "dog": fitted(dog),
    "wolf": fitted(wolf),
    "fox": fitted(fox),
    "bear": fitted(bear),
    "lion": fitted(lion),
    "cow": fitted(cow),
    "sheep": fitted(sheep),
    "elephant": fitted(elephant),
    "giraffe": fitted(giraffe),
}
