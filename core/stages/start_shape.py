"""Ψ's start: an ellipsoid, or the user's guide mesh (Eq. 3)."""

import torch

from core.config import GeometryConfig
from core.geometry.init_shape import ellipsoid, fit, mesh_shape
from core.geometry.mesh import Mesh
from core.geometry.residual import Residual
from core.geometry.sdf_net import SdfNet
from core.geometry.tet_grid import EXTENT
from core.io.progress import Progress
from core.stages.state import Training


def sdf_net(config: GeometryConfig, generator: torch.Generator) -> SdfNet:
    """Ψ, random, for the coarse phase's lattice."""
    net = SdfNet(2 * EXTENT / config.resolution[0], config.net, EXTENT, generator)
    if config.net.residual > 0:
        net.residual = Residual(config.resolution[1], EXTENT, config.net.residual)
    return net


def fit_start_shape(
    training: Training[SdfNet], config: GeometryConfig, guide: Mesh | None, progress: Progress
) -> None:
    """Fit Ψ to ``guide`` or, without one, to the config's ellipsoid (Eq. 3)."""
    start = mesh_shape(guide) if guide else ellipsoid(config.radii)
    steps = config.fit_steps
    with progress.timed("fit"):
        fit(
            training.module,
            start,
            steps,
            training.generator,
            lambda step, _: progress.advance("fit", step, steps),
        )
