"""Parts of furniture: legs, a clock's face."""

from core.prior.solids import Solid, both, box, capsule, join, taper, tube


def corner_legs(x: float, y: float, top: float, thick: float, round_legs: bool) -> Solid:
    """Four legs under the corners (±x, ±y), from the floor to ``top``."""
    corners = [(sx * (x - thick), sy * (y - thick)) for sx in (-1, 1) for sy in (-1, 1)]
    if round_legs:
        return join(*(tube((a, b, 0), (a, b, top), thick, 0.02) for a, b in corners))
    half = (thick, thick, top / 2)
    return join(*(box((a, b, top / 2), half, 0.02) for a, b in corners))


def feet(x: float, y: float, high: float, radius: float) -> Solid:
    """Four round legs from the floor."""
    return both(taper((x, y, radius * 0.8), (x, y, high), radius * 0.8, radius), 0, 1)


def clock_dial(y: float, z: float, r: float) -> tuple[Solid, Solid]:
    """A clock's face looking to the front, and its hands."""
    hands = join(
        capsule((0, y - 0.06, z), (0, y - 0.06, z + r * 0.66), 0.065),
        capsule((0, y - 0.06, z), (r * 0.45, y - 0.06, z - r * 0.2), 0.065),
    )
    return tube((0, y - 0.04, z), (0, y + 0.1, z), r), hands
