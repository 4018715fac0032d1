"""Marching tetrahedra and Ψ, forward and backward."""

import torch

from core.benchmarks import least_ms, row
from core.geometry.init_shape import ellipsoid, fit
from core.geometry.marching_tets import marching_tets
from core.geometry.sdf_net import FOURIER, HASH, SdfNet, extract
from core.geometry.tet_grid import tet_grid


def rows() -> list[dict]:
    """The draft's lattice and the paper's 128-class one."""
    lines = []
    for n, target in ((40, None), (64, 20.0), (128, None)):  # 65³ nodes: elsewhere's "128"
        grid = tet_grid(n)
        sdf = (grid.tet_verts.norm(dim=1) - 0.6).requires_grad_()
        positions = grid.tet_verts.clone().requires_grad_()

        def tets(positions=positions, sdf=sdf, grid=grid) -> None:
            marching_tets(positions, sdf, grid)[0].sum().backward()

        lines.append(row(f"marching tets, {n}³ cubes", least_ms(tets), "ms", target))
    grid = tet_grid(64)
    for name, config, target in (("Fourier", FOURIER, None), ("hash", HASH, 1000.0)):
        net = SdfNet(grid.cell, config, generator=torch.Generator().manual_seed(0))
        fit(net, ellipsoid((0.6, 0.6, 0.6)), 40, torch.Generator().manual_seed(0))

        def field(net=net) -> None:
            extract(net, grid).verts.square().sum().backward()

        name = f"Ψ and its ball on {len(grid.tet_verts):,} nodes, {name}, with gradient"
        lines.append(row(name, least_ms(field), "ms", target))
    return lines
