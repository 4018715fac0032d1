"""Parts of a face: eyes, a moustache, a beard, and a cone for horns, ears and teeth."""

from core.prior.solids import Solid, Vector, ball, both, capsule, lathe, smooth_curve


def eyes(apart: float, y: float, z: float, radius: float = 0.095) -> Solid:
    """A pair of round eyes."""
    return both(ball((apart, y, z), radius))


def cone(low: Vector, radius: float, high: float) -> Solid:
    """A pointed cone of height ``high`` with its base at ``low``."""
    x, y, z = low
    return lathe([(radius - 0.04, z), (0.02, z + high)], 0.04, (x, y))


def moustache(at: Vector, reach: float) -> Solid:
    """Two tufts under a nose at ``at``."""
    x, y, z = at
    return both(capsule((x + 0.08, y, z), (x + reach + 0.06, y + 0.08, z - 0.07), 0.1))


def pointed_beard(at: Vector, radius: float, long: float) -> Solid:
    """A beard: a cone that hangs from the chin."""
    x, y, z = at
    profile = [(0.03, z - long), (radius * 0.72, z - long * 0.42), (radius, z)]
    return lathe(smooth_curve(profile), 0.04, (x, y))
