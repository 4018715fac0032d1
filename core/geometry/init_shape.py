"""The start: Ψ is fitted to the SDF of an ellipsoid, a cylinder or the user's mesh (Eq. 3).

    L_SDF = Σ_{p in P} (s(p; ψ) - SDF(p))²

P as in the released code: 5000 points of the surface, the same moved by N(0, 0.05), and 3000
uniform in the cube. All distances here are true ones; the released code's ellipsoid is not.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.adam import Adam
from core.geometry.mesh import Mesh, face_areas, normalise
from core.geometry.sdf_net import SdfNet
from core.geometry.signed_distance import SolidMesh
from core.geometry.tet_grid import EXTENT

SURFACE_POINTS, UNIFORM_POINTS, SPREAD = 5000, 3000, 0.05
# Sets P that the steps take in turn: the distances to a large mesh are then found once.
POINT_SETS = 8
# A fit that ends by itself looks every so many steps at points that it is not fitted to. Where
# their error fell to no less than GAIN of the best, it halves its rate; below LEAST_RATE of the
# first rate, or after MOST_STEPS, it ends.
LOOK_STEPS, GAIN, LEAST_RATE, MOST_STEPS = 50, 0.97, 1 / 32, 2000
LEARNING_RATE = 3e-3
# Weight of (2 offset / cell)²: the nodes start where they are, free to move both ways.
OFFSET_WEIGHT = 1e-4


@dataclass(frozen=True)
class Shape:
    """A solid to start from."""

    sdf: Callable[[Tensor], Tensor]  # points (N, 3) to their signed distance (N,)
    surface: Callable[[int, torch.Generator], Tensor]  # that many points (N, 3), uniform by area


def ellipsoid(radii: tuple[float, float, float]) -> Shape:
    """An ellipsoid about the origin, its half axes along x, y, z."""
    r = torch.tensor(radii, dtype=torch.float32)

    def surface(count: int, generator: torch.Generator) -> Tensor:
        # The sphere's points, stretched; the area that each represents grows with |n / r|.
        # 8 candidates for each point: they are picked with replacement, and few come twice.
        n = torch.randn(8 * count, 3, generator=generator)
        n = n / n.norm(dim=1, keepdim=True)
        picked = torch.multinomial((n / r).norm(dim=1), count, True, generator=generator)
        return n[picked] * r

    return Shape(lambda points: ellipsoid_sdf(points, r.to(points)), surface)


def cylinder(radius: float, half_height: float) -> Shape:
    """A cylinder about the z axis."""

    def surface(count: int, generator: torch.Generator) -> Tensor:
        turn, place, kind = torch.rand(3, count, generator=generator)
        # The wall's area is 4π r h, that of both caps 2π r²: its fraction is 2h / (2h + r).
        round_part = kind < 2 * half_height / (2 * half_height + radius)
        # ``place`` picks the cap by its half; within the half it is uniform, and used again below.
        top = torch.where(place < 0.5, -half_height, half_height)
        z = torch.where(round_part, (2 * place - 1) * half_height, top)
        fraction = (2 * place % 1).sqrt()  # by the disc's area
        r = torch.where(round_part, radius, radius * fraction)
        angle = 2 * torch.pi * turn
        return torch.stack([r * angle.cos(), r * angle.sin(), z], 1)

    return Shape(lambda points: cylinder_sdf(points, radius, half_height), surface)


def mesh_shape(mesh: Mesh) -> Shape:
    """The user's mesh, normalised. Raises UserError where it has no area or no inside."""
    verts, _, _ = normalise(mesh.verts)
    solid = SolidMesh(verts, mesh.faces)
    return Shape(solid.sdf, lambda n, generator: sample_surface(verts, mesh.faces, n, generator))


def ellipsoid_sdf(points: Float[Tensor, "n 3"], radii: Float[Tensor, " 3"]) -> Float[Tensor, " n"]:
    """Distance to the ellipsoid Σ (x_i / r_i)² = 1, negative inside.

    The nearest point is x_i = r_i² p_i / (t + r_i²), where t is the largest root of
    Σ (r_i p_i / (t + r_i²))² = 1 (Eberly 2013); found by bisection in float64.
    """
    r = radii.double()
    # Off the coordinate planes by a hair: on them the root may sit on the pole.
    p = points.double().abs().clamp(min=1e-9 * float(r.min()))
    smallest = r.square().min()
    # u = t + min r²: no difference of nearly equal numbers is left in the denominators.
    above = r.square() - smallest
    # Bounds of the root u: at ``low`` the smallest axis' term alone is 1, at ``high`` the sum is 1
    # without ``above``.
    low = r.min() * p[:, r.argmin()]
    high = (r * p).norm(dim=1)
    # More halvings than a float64 has bits (53).
    for _ in range(64):
        u = (low + high) / 2
        outside = ((r * p) / (u[:, None] + above)).square().sum(1) > 1
        low, high = torch.where(outside, u, low), torch.where(outside, high, u)
    nearest = r.square() * p / ((low + high)[:, None] / 2 + above)
    distance = (p - nearest).norm(dim=1)
    inside = (p / r).square().sum(1) < 1
    return torch.where(inside, -distance, distance).to(points.dtype)


def cylinder_sdf(
    points: Float[Tensor, "n 3"], radius: float, half_height: float
) -> Float[Tensor, " n"]:
    """Distance to a capped cylinder about the z axis, negative inside."""
    d = torch.stack([points[:, :2].norm(dim=1) - radius, points[:, 2].abs() - half_height], 1)
    # Inside: to the nearer of wall and cap. Outside: both excesses together, 0 for the one within.
    return d.amax(1).clamp(max=0) + d.clamp(min=0).norm(dim=1)


def sample_surface(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    count: int,
    generator: torch.Generator,
) -> Float[Tensor, "n 3"]:
    """``count`` points of a mesh, uniform by area (Turk 1990)."""
    picked = torch.multinomial(face_areas(verts, faces), count, True, generator=generator)
    a, b, c = verts[faces[picked]].unbind(1)
    s, t = torch.rand(2, count, 1, generator=generator, dtype=verts.dtype)
    # The root makes them even by area: lines across the triangle are shorter near corner a.
    s = s.sqrt()
    return (1 - s) * a + s * (1 - t) * b + s * t * c


def sample_points(shape: Shape, extent: float, generator: torch.Generator) -> Float[Tensor, "n 3"]:
    """One set P of Eq. 3, within the cube [-extent, extent]³."""
    on = shape.surface(SURFACE_POINTS, generator)
    near = on + SPREAD * torch.randn(on.shape, generator=generator)
    anywhere = (2 * torch.rand(UNIFORM_POINTS, 3, generator=generator) - 1) * extent
    # The moved points may leave the cube, which the lattice does not reach beyond.
    return torch.cat([on, near, anywhere]).clamp(-extent, extent)


def fit(
    net: SdfNet,
    shape: Shape,
    steps: int,
    generator: torch.Generator,
    progress: Callable[[int, float], None] | None = None,
    *,
    learning_rate: float = LEARNING_RATE,
    extent: float = EXTENT,
) -> float:
    """Fit Ψ to ``shape`` (Eq. 3); the root mean square of the SDF's error in the last step.

    ``progress``: called with the steps done and that error. The rate falls to 0 along a cosine.
    """
    pairs = _pairs(net, shape, min(POINT_SETS, steps), extent, generator)
    optimizer = _optimizer(net, learning_rate)
    error = float("nan")
    for step in range(steps):
        optimizer.rate = learning_rate * (1 + math.cos(math.pi * step / steps)) / 2
        error = _step(net, optimizer, *pairs[step % len(pairs)])
        if progress is not None:
            progress(step + 1, error)
    return error


def fit_until_still(
    net: SdfNet,
    shape: Shape,
    generator: torch.Generator,
    progress: Callable[[int, float], None] | None = None,
    *,
    extent: float = EXTENT,
) -> float:
    """Fit Ψ to ``shape`` (Eq. 3) until the error at points that it has not seen stops falling.

    Returns their root mean square error at the end; they are about the surface. ``progress``: as
    in :func:`fit`, of MOST_STEPS at most.
    """
    # One set more than is trained on, to measure with.
    pairs = _pairs(net, shape, POINT_SETS + 1, extent, generator)
    # Of that set the points on and near the surface; the uniform ones come last.
    points, target = (x[: 2 * SURFACE_POINTS] for x in pairs.pop())
    optimizer, rate, best = _optimizer(net, LEARNING_RATE), LEARNING_RATE, float("inf")
    error = float("nan")
    for step in range(MOST_STEPS):
        last = _step(net, optimizer, *pairs[step % len(pairs)])
        if progress is not None:
            progress(step + 1, last)
        if (step + 1) % LOOK_STEPS:
            continue
        with torch.no_grad():
            error = float((net(points)[0] - target).square().mean().sqrt())
        rate = rate if error < GAIN * best else rate / 2
        best = min(best, error)
        if rate < LEAST_RATE * LEARNING_RATE:
            break
        optimizer.rate = rate
    return error


def _pairs(
    net: SdfNet, shape: Shape, count: int, extent: float, generator: torch.Generator
) -> list[tuple[Tensor, Tensor]]:
    """Sets P with their distances, where Ψ is."""
    device = next(net.parameters()).device
    sets = [sample_points(shape, extent, generator) for _ in range(count)]
    return [(points.to(device), shape.sdf(points).to(device)) for points in sets]


def _optimizer(net: SdfNet, learning_rate: float) -> Adam:
    # Müller et al. 2022, §4: the tiny epsilon is for table rows whose gradients are rare and weak.
    return Adam(net.parameters(), learning_rate, (0.9, 0.99), 1e-15)


def _step(net: SdfNet, optimizer: Adam, points: Tensor, target: Tensor) -> float:
    """One step of Eq. 3; the root mean square error before it."""
    sdf, offset = net(points)
    loss = (sdf - target).square().mean()
    still = (offset * (2 / net.cell)).square().mean()
    optimizer.zero_grad()
    (loss + OFFSET_WEIGHT * still).backward()
    optimizer.step()
    return float(loss.detach().sqrt())
