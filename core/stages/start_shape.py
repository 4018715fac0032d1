"""Ψ's start: an ellipsoid, what the guidance draws, or the user's guide mesh (Eq. 3)."""

import torch

from core.config import GeometryConfig
from core.geometry.guide import fill, guide_leash, guide_shape
from core.geometry.init_shape import MOST_STEPS, Shape, ellipsoid, fit, fit_until_still
from core.geometry.leash import Leash
from core.geometry.mesh import Mesh
from core.geometry.residual import Residual
from core.geometry.sdf_net import SdfNet
from core.geometry.tet_grid import EXTENT
from core.io.progress import Progress
from core.stages.state import Training

# Half the thickness, cells of the fine lattice, that sheets and thin parts get: a node is inside.
THIN_CELLS = 0.6


def sdf_net(config: GeometryConfig, generator: torch.Generator) -> SdfNet:
    """Ψ, random, for the coarse phase's lattice."""
    # The coarse cell; each phase then sets its own (``use_lattice``).
    net = SdfNet(2 * EXTENT / config.resolution[0], config.net, EXTENT, generator)
    if config.net.residual > 0:
        net.residual = Residual(config.resolution[1], EXTENT, config.net.residual)
    return net


def fit_start_shape(
    training: Training[SdfNet],
    config: GeometryConfig,
    progress: Progress,
    drawn: Shape | None = None,
) -> None:
    """Fit Ψ to the solid that the guidance has ``drawn``, or to the config's ellipsoid (Eq. 3)."""
    steps, net = config.fit_steps, training.module
    with progress.timed("fit"):
        fit(
            net,
            drawn or ellipsoid(config.radii),
            steps,
            training.generator,
            lambda step, _: progress.advance("fit", step, steps),
        )
        if drawn and net.residual is not None:  # so few steps leave the details to the lattice
            fill(net.residual, net, drawn, 1.0)


def fit_guide(
    training: Training[SdfNet], shape: Shape, strength: float, progress: Progress
) -> None:
    """Fit Ψ to the guide's ``shape`` (Eq. 3); its lattice holds ``strength`` of what it lacks."""
    net = training.module
    with progress.timed("fit"):
        fit_until_still(
            net,
            shape,
            training.generator,
            lambda step, _: progress.advance("fit", step, MOST_STEPS),
        )
        if net.residual is not None:
            fill(net.residual, net, shape, strength)
        progress.complete("fit")


def leash_of(guide: Mesh, shape: Shape, config: GeometryConfig, strength: float) -> Leash | None:
    """The leash that keeps a surface as near to ``guide`` as ``strength`` requests; 0: none.

    ``shape``: its :func:`solid_guide`.
    """
    if strength == 0:
        return None
    return guide_leash(guide, shape, strength, config.resolution[1], EXTENT)


def solid_guide(guide: Mesh, config: GeometryConfig) -> Shape:
    """``guide`` as a solid that the fine lattice can hold."""
    return guide_shape(guide, least_of(config))


def least_of(config: GeometryConfig) -> float:
    """Half the thickness, training units, that thin parts of a guide get on the fine lattice."""
    return THIN_CELLS * 2 * EXTENT / config.resolution[1]
