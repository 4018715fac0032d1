"""Parts of birds and winged figures: wings, claws, toes, a bill."""

from core.prior.draw import Draw
from core.prior.solids import Solid, Vector, capsule, chain, join, prism


def bird_claws(x: float, y: float, z: float, reach: float, thick: float) -> Solid:
    """A bird's foot: three toes to the front, one to the back."""
    toes = [
        capsule((x, y, z), (x + out, y - reach, z), thick) for out in (-0.5 * reach, 0.5 * reach)
    ]
    return join(*toes, capsule((x, y + reach * 0.6, z), (x, y - reach * 1.15, z), thick))


def back_wing(draw: Draw, low: float, tips: list[Vector]) -> Solid:
    """A right wing behind the back; ``tips``: (x, z above ``low``, the notch after it)."""
    span, lift = draw(0.92, 1.08), draw(0.92, 1.08)
    corners = [(0.05, low), (0.05, low + 0.55)]
    for u, v, notch in tips:
        corners.append((u * span, low + v * lift))
        corners.append(((u - notch) * span, low + (v + notch * 0.5) * lift))
    return prism(corners[:-1], 1, 0.085, 0.34)


def hooked_bill(at: tuple[float, float, float], size: float, long: float) -> Solid:
    """A bill at ``at`` that bends down at its end."""
    x, y, z = at
    return chain(
        [
            ((x, y, z), size),
            ((x, y - long, z - size * 0.1), size * 0.8),
            ((x, y - long * 1.35, z - size * 1.5), 0.075),
        ]
    )


def front_toes(x: float, y: float, reach: float, thick: float) -> Solid:
    """Three toes to the front."""
    return join(
        *(capsule((x, y, thick), (x + out, y - reach, thick), thick) for out in (-0.14, 0, 0.14))
    )
