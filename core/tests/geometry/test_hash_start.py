"""The built-in prior's Ψ where it is a hash grid: no finer than the lattice that reads it."""

from dataclasses import replace

import torch

from core.geometry.init_shape import ellipsoid, fit
from core.geometry.mesh import health
from core.geometry.sdf_net import SdfNetConfig, extract
from core.geometry.tet_grid import tet_grid
from core.io.job import Job
from core.job_config import config_of
from core.render.antialias import edge_table
from core.stages.regularisers import bending
from core.stages.start_shape import sdf_net

LATTICE = 20


def roughness(net_config: SdfNetConfig) -> float:
    """Mean 1 - cos between adjacent faces of a ball that a few steps of Eq. 3 have fitted."""
    generator = torch.Generator().manual_seed(0)
    config = replace(config_of(Job(prompt="a mug", preset="standard")).geometry, net=net_config)
    net = sdf_net(replace(config, resolution=(LATTICE, LATTICE)), generator)
    fit(net, ellipsoid((0.6, 0.6, 0.6)), 40, generator)
    with torch.no_grad():
        surface = extract(net, tet_grid(LATTICE))
    assert health(surface.verts, surface.faces)["genus"] == 0
    return float(bending(surface.verts, surface.faces, edge_table(surface.faces)))


def test_levels_finer_than_the_lattice_crumple_the_surface():
    """Each node has features of its own there, which no neighbour shares."""
    own = config_of(Job(prompt="a mug", preset="standard")).geometry.net
    assert own.finest == 64
    own = replace(own, log2_size=15)  # of 19: Adam's steps take as long as the table is large
    assert roughness(own) < 0.7 * roughness(replace(own, finest=4096))
