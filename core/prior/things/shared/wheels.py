"""Wheels of vehicles."""

from collections.abc import Iterable

from core.prior.solids import Point, Solid, both, cut, join, tube


def wheels(x: float, axles: Iterable[Point], half: float) -> tuple[Solid, Solid]:
    """Tyres on the floor at ±``x``, one a side for each axle (y, radius); and their hubs."""
    tyres, hubs = [], []
    for y, r in axles:
        hollow = tube((x + half - 0.05, y, r), (x + half + 1, y, r), r * 0.64)
        tyres.append(cut(tube((x - half, y, r), (x + half, y, r), r, 0.05), hollow))
        hubs.append(tube((x - half, y, r), (x + half + 0.02, y, r), r * 0.5, 0.03))
    return both(join(*tyres)), both(join(*hubs))


def disc_wheel(x: float, y: float, z: float, radius: float, thick: float = 0.12) -> Solid:
    """A wheel about (x, y, z), its axle along x, ``thick`` to each side."""
    return tube((x - thick, y, z), (x + thick, y, z), radius, 0.04)


def disc_wheels(x: float, ys: tuple[float, ...], radius: float, thick: float = 0.12) -> Solid:
    """Pairs of wheels on axles along x, standing on the floor."""
    return both(join(*(disc_wheel(x, y, radius, radius, thick) for y in ys)))


def rimmed_wheel(x: float, y: float, radius: float, half: float = 0.11) -> tuple[Solid, Solid]:
    """A tyre on the floor with a hollow outer side, its axle along x; and its hub."""
    face = x + half
    hollow = tube((face - 0.06, y, radius), (face + 1, y, radius), radius * 0.66)
    tyre = cut(tube((x - half, y, radius), (face, y, radius), radius, 0.04), hollow)
    return tyre, tube((x, y, radius), (face - 0.02, y, radius), radius * 0.5, 0.03)
