"""Marching tetrahedra and Ψ, forward and backward."""

import torch

from core.benchmarks import least_ms, row
from core.geometry.marching_tets import marching_tets
from core.geometry.sdf_net import FOURIER, HASH, SdfNet, extract
from core.geometry.tet_grid import tet_grid


def rows() -> list[dict]:
    """The draft's lattice and the paper's 128-class one."""
    lines = []
    for n, target in ((40, None), (64, None), (128, 20.0)):
        grid = tet_grid(n)
        sdf = (grid.tet_verts.norm(dim=1) - 0.6).requires_grad_()
        positions = grid.tet_verts.clone().requires_grad_()

        def tets(positions=positions, sdf=sdf, grid=grid) -> None:
            marching_tets(positions, sdf, grid)[0].sum().backward()

        lines.append(row(f"marching tets, {n}³ cubes", least_ms(tets), "ms", target))
    for name, config, n, target in (("Fourier", FOURIER, 64, None), ("hash", HASH, 64, 1000.0)):
        grid = tet_grid(n)
        net = SdfNet(grid.cell, config, generator=torch.Generator().manual_seed(0))

        def field(net=net, grid=grid) -> None:
            extract(net, grid).positions.square().sum().backward()

        lines.append(row(f"Ψ on {n}³ cubes, {name}, two passes", least_ms(field), "ms", target))
    return lines
