"""Round components that touch, such as eggs: one component, taken apart into ellipsoids."""

from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float
from scipy import ndimage
from torch import Tensor

from core.geometry.parts.components import ALSO, Component

DEPTHS = np.linspace(0.15, 0.8, 14)  # of a component's greatest depth, where it may come apart
LEAST_NODES = 6  # of a core
BORDER = 0.8  # of the way to another core: nearer to that a surface may be both's
ROUND = 0.07  # of the radius: how far a ball's surface is from the drawn one in the mean, at most
LONGEST = 2.2  # of its least radius
EVEN = 1.6  # times the least one's volume's cube root
POINTS = 600  # of a ball's surface


class Ball(NamedTuple):
    """An ellipsoid: ``matrix`` @ (point - ``middle``) is on the unit sphere."""

    middle: Float[np.ndarray, " 3"]
    matrix: Float[np.ndarray, "3 3"]

    def distance(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """About the signed distance, exact on the surface (Quilez, 2008)."""
        matrix = torch.from_numpy(self.matrix).to(points)
        local = (points - torch.from_numpy(self.middle).to(points)) @ matrix.T
        far, slope = local.norm(dim=1), (local @ matrix).norm(dim=1)
        return far * (far - 1) / slope.clamp_min(1e-6)

    def points(self) -> Float[Tensor, "n 3"]:
        """Points of its surface, evenly around it (Vogel, 1979)."""
        k = np.arange(POINTS) + 0.5
        z, angle = 1 - 2 * k / POINTS, np.pi * (1 + 5**0.5) * k
        across = np.sqrt(1 - z * z)
        unit = np.stack([across * np.cos(angle), across * np.sin(angle), z], 1)
        return torch.from_numpy(unit @ np.linalg.inv(self.matrix).T + self.middle).float()


def balls_of(component: Component) -> list[Ball]:
    """The balls that a component consists of; [] where it is anything else."""
    cores = _cores(component)
    if len(cores) < 2:
        return []
    verts = component.verts.double().numpy()
    away = np.linalg.norm(verts[:, None] - cores, axis=2)
    order = np.sort(away, 1)
    clear = order[:, 0] < BORDER * order[:, 1]
    found = []
    for index in range(len(cores)):
        ball = _fitted(verts[clear & (away.argmin(1) == index)])
        if ball is None:
            return []
        found.append(ball)
    sizes = [np.linalg.det(ball.matrix) ** (-1 / 3) for ball in found]
    return found if max(sizes) <= EVEN * min(sizes) else []


def _cores(component: Component) -> Float[np.ndarray, "k 3"]:
    """The middles of what is left of a component where it is deepest, as many as come apart."""
    values, cell = component.lattice.values, component.lattice.cell
    best = np.zeros((0, 3))
    for depth in DEPTHS * -values.min():
        labels = np.zeros(values.shape, np.int32)
        ndimage.label(values < -depth, output=labels)
        nodes = np.bincount(labels.ravel())[1:]
        large = np.flatnonzero(nodes >= max(LEAST_NODES, ALSO * nodes.max(initial=0))) + 1
        if len(large) > len(best):
            middles = np.array(ndimage.center_of_mass(labels > 0, labels, large))
            best = middles * cell + component.lattice.low
    return best


def _fitted(points: Float[np.ndarray, "n 3"]) -> Ball | None:
    """The ellipsoid through points, by its quadric; None where they are on none."""
    if len(points) < 30:
        return None
    middle, by = points.mean(0), np.linalg.norm(points - points.mean(0), axis=1).mean()
    x, y, z = ((points - middle) / by).T
    each = np.stack([x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z, x, y, z], 1)
    for columns in ([0, 1, 2, 3, 4, 5, 6, 7, 8], [0, 1, 2, 6, 7, 8]):
        v = np.zeros(9)
        v[columns] = np.linalg.lstsq(each[:, columns], np.ones(len(each)), rcond=None)[0]
        quadric = np.array([[v[0], v[3], v[4]], [v[3], v[1], v[5]], [v[4], v[5], v[2]]])
        if np.linalg.eigvalsh(quadric).min() <= 0:
            continue
        own = -np.linalg.solve(quadric, v[6:]) / 2
        matrix = np.linalg.cholesky(quadric / (1 + own @ quadric @ own)).T / by
        ball = Ball(middle + by * own, matrix)
        radii = 1 / np.linalg.svd(matrix, compute_uv=False)
        off = ball.distance(torch.from_numpy(points)).abs().mean()
        if radii.max() <= LONGEST * radii.min() and off <= ROUND * radii.mean():
            return ball
    return None
