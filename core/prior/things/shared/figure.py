"""A standing human figure, sturdy and with a large head, for the people of stories."""

from typing import NamedTuple

from core.prior.draw import Draw
from core.prior.solids import Solid, Vector, ball, both, box, cut, egg, join, taper, tube


class Figure(NamedTuple):
    """The measures of a standing person, and its basic solids."""

    leg: float
    wide: float  # half the shoulders
    top: float  # the height of the shoulders
    head: float  # its radius
    hand: Vector  # the left one

    @property
    def z(self) -> float:
        """The height of the head's middle."""
        return self.top + self.head * 0.78

    def face(self, up: float = 0.0, out: float = 0.0) -> Vector:
        """A point on the middle of the face."""
        return (0, -self.head * 0.97 - out, self.z + up * self.head)

    def trunk(self, grown: float = 0.0) -> Solid:
        """The trunk from the hips to the shoulders."""
        low, high = self.wide * 0.8 + grown, self.wide * 0.88 + grown
        return taper((0, 0, self.leg + 0.1), (0, 0, self.top - 0.26), low, high)

    def sleeves(self, grown: float = 0.0) -> Solid:
        """Both arms to the wrists."""
        shoulder = (self.wide * 0.84, 0, self.top - 0.2)
        return both(taper(shoulder, self.hand, 0.16 + grown, 0.14 + grown))

    def hands(self, radius: float = 0.17) -> Solid:
        """Both hands, as balls."""
        return both(ball(self.hand, radius))

    def legs(self, grown: float = 0.0) -> Solid:
        """Both legs to the ankles."""
        x = self.wide * 0.5
        return both(taper((x, 0, self.leg + 0.1), (x, 0, 0.14), 0.2 + grown, 0.17 + grown))

    def shoes(self, high: float = 0.24) -> Solid:
        """Two shoes, each a foot and a shaft to the height ``high``."""
        x = self.wide * 0.5
        foot = egg((x, -0.13, 0.11), (0.2, 0.33, 0.13))
        return both(join(foot, tube((x, 0, 0.04), (x, 0, high), 0.22, 0.04)))

    def skull(self) -> Solid:
        """A round head with a nose."""
        return join(ball((0, 0, self.z), self.head), ball(self.face(-0.08, 0.02), 0.09))

    def eyes(self) -> Solid:
        """A pair of upright ovals, far enough apart not to look like spectacles."""
        at = (self.head * 0.42, -self.head * 0.88, self.z + 0.06)
        return both(egg(at, (0.07, 0.07, 0.098)))


def figure_with_hand(draw: Draw, hand: Vector) -> Figure:
    """A random figure; ``hand``: the left hand, relative to the side of the left shoulder."""
    leg, wide, head = draw(0.62, 0.67), draw(0.4, 0.43), draw(0.39, 0.42)
    top = leg + draw(0.74, 0.8)
    return Figure(leg, wide, top, head, (wide + hand[0], hand[1], top + hand[2]))


def figure(draw: Draw) -> Figure:
    """A random figure."""
    leg, wide, head = draw(0.52, 0.74), draw(0.36, 0.46), draw(0.36, 0.43)
    top = leg + draw(0.68, 0.84)
    return Figure(leg, wide, top, head, (wide + draw(0.2, 0.34), -0.12, top - draw(0.56, 0.68)))


def hair(f: Figure, down: float = 0.0) -> Solid:
    """A cap of hair that leaves the face free; ``down``: how far it falls behind, in heads."""
    face = box((0, -f.head, f.z - f.head * 0.55), (2, f.head * 0.86, f.head * 0.85))
    cap = cut(ball((0, 0.03, f.z + 0.04), f.head * 1.12), face)
    if not down:
        return cap
    return join(
        cap,
        egg(
            (0, f.head * 0.52, f.z - down * f.head * 0.5),
            (f.head * 0.98, f.head * 0.5, f.head * (0.8 + down * 0.5)),
        ),
    )
