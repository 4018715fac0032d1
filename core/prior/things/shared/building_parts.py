"""Parts of buildings: a row of windows, a hip roof."""

from collections.abc import Iterable

from core.prior.solids import Solid, box, join, prism, within


def box_row(at: Iterable[float], z: float, half: tuple[float, float, float], y: float) -> Solid:
    """Boxes in a row along x, at the height ``z``, in the plane ``y``."""
    return join(*(box((u, y, z), half, 0.02) for u in at))


def hip_roof(x: float, y: float, low: float, high: float) -> Solid:
    """A roof of four slopes, as steep at its ends as at its sides."""
    ridge = max(x - y, 0.05)
    return within(
        prism([(-x, low), (x, low), (x, low + 0.1), (ridge, high), (-ridge, high),
               (-x, low + 0.1)], 1, y),
        prism([(-y, low), (y, low), (y, low + 0.1), (0.03, high), (-0.03, high),
               (-y, low + 0.1)], 0, x),
    )  # fmt: skip
