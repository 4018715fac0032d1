"""The fit to perfect pictures: the oracle, the scores, and a short form of ``bench fit``."""

from collections.abc import Iterator
from dataclasses import replace
from unittest import mock

import pytest
import torch

from core.benchmarks import ball, fit_scores
from core.benchmarks.bench_fit import fitted, line, misses, solid, summary
from core.benchmarks.fit_scores import Truth, curvature_error, scores
from core.benchmarks.oracle import Oracle
from core.camera import Cameras
from core.config import DRAFT, RefineConfig
from core.geometry.guide import fill
from core.geometry.init_shape import Shape
from core.geometry.marching_tets import marching_tets
from core.geometry.residual import Residual, blurred
from core.geometry.sdf_net import FOURIER
from core.geometry.tet_grid import EXTENT, tet_grid
from core.guidance.denoise import denoise
from core.guidance.guidance import Views
from core.prior.families import normalised
from core.prior.solids import box
from core.prior.tracer import render
from core.stages import geometry
from core.stages.start_shape import sdf_net

SHORT = replace(
    DRAFT.geometry,
    net=FOURIER,
    resolution=(16, 32),
    fit_steps=60,
    coarse=replace(DRAFT.geometry.coarse, steps=0),
    grow=RefineConfig(rounds=0),
    refine=RefineConfig(rounds=2, steps=20, views=8, batch=4, size=40, learning_rate=4e-3),
    sharpen=replace(DRAFT.geometry.sharpen, rounds=0),
)
SHARP = replace(SHORT, net=replace(FOURIER, octaves=5, residual=0.3), polish=0, flatten=2)


@pytest.fixture(scope="module")
def block():
    return normalised({"body": box((0, 0, 0), (0.6, 0.5, 0.4))})


@pytest.fixture(scope="module", autouse=True)
def fewer() -> Iterator[None]:
    """Half of the points, and a block's components and holes on a coarser lattice."""
    with (
        mock.patch.object(fit_scores, "MESH_POINTS", 30_000),
        mock.patch.object(fit_scores, "TRUTH_RESOLUTION", 48),
    ):
        yield


@pytest.fixture(scope="module")
def truth(block):
    return Truth.of(block)


@pytest.fixture(scope="module")
def meshes(block):
    """What is refined with SHORT, by no sharpening and by some."""
    crisp = replace(SHORT, sharpen=replace(SHORT.sharpen, rounds=3, views=12))
    with mock.patch.object(geometry, "sharpened", wraps=geometry.sharpened) as spy:
        sharp = fitted(block, crisp)
    _, _, verts, faces, _ = spy.call_args.args
    return (verts.detach(), faces), sharp


def test_a_lattice_next_to_the_network_reaches_what_three_octaves_miss(
    block, truth, meshes
) -> None:
    """By refining alone, from an ellipsoid."""
    soft, sharp = (scores(*mesh, truth) for mesh in (meshes[0], fitted(block, SHARP)))
    assert {"flat", "crease"} <= set(misses(soft))
    assert misses(sharp) == []
    assert sharp["chamfer"] < 0.7 * soft["chamfer"]


def test_the_sharpening_reaches_it_too(truth, meshes) -> None:
    assert misses(scores(*meshes[1], truth)) == []


def test_the_truth_itself_misses_nothing(block, truth) -> None:
    grid = tet_grid(64)
    found = scores(*marching_tets(grid.tet_verts, block.sdf(grid.tet_verts), grid), truth)
    assert misses(found) == []
    assert found["missing"] == found["extra"] == 0
    assert "MISSES" not in line(found | {"noun": "block", "cpu_s": 1.0})


def test_a_part_that_is_gone_is_missing(block, truth) -> None:
    grid = tet_grid(32)
    sdf = torch.maximum(block.sdf(grid.tet_verts), grid.tet_verts[:, 0])  # half of it
    found = scores(*marching_tets(grid.tet_verts, sdf, grid), truth)
    assert 0.3 < found["missing"] < 0.55
    assert "missing" in misses(found)
    assert summary([found])[-1]["value"] == 0


def test_a_ball_has_the_curvature_of_its_radius() -> None:
    verts, faces = ball(20_000, bump=0.0)
    assert curvature_error(verts, faces, 0.75) < 0.01
    assert curvature_error(verts, faces, 0.6) > 0.1


def test_the_oracle_brings_the_truth_back_from_any_noise(block) -> None:
    guidance, cameras = Oracle(block, 16), Cameras.orbit([10.0, 80.0], [20.0, -10.0])
    noise = torch.randn(2, 4, 16, 16, generator=torch.Generator().manual_seed(0))
    clean = denoise(guidance.prompted(), noise, 900, Views(cameras), 5.0, 3)
    seen = render(block, cameras, 16)
    true = torch.cat([seen.normal, 2 * seen.coverage - 1], 1)
    assert torch.allclose(clean, true, atol=1e-4)


def test_the_oracle_makes_any_picture_the_truth(block) -> None:
    cameras = Cameras.orbit([10.0, 80.0], [20.0, -10.0])
    seen = render(block, cameras, 16)
    made = Oracle(block, 16).prompted().restore(torch.zeros(2, 4, 16, 16), Views(cameras))
    assert torch.allclose(made, torch.cat([seen.normal, 2 * seen.coverage - 1], 1))


def test_nouns_of_the_bench_are_the_same_solids_every_time() -> None:
    points = torch.rand(50, 3, generator=torch.Generator().manual_seed(0)) - 0.5
    assert torch.equal(solid("mug").sdf(points), solid("mug").sdf(points))


def test_a_residual_of_zeros_changes_nothing_and_is_for_the_fine_lattice_alone() -> None:
    def net(residual):
        config = replace(SHORT, net=replace(FOURIER, residual=residual))
        return sdf_net(config, torch.Generator().manual_seed(0))

    plain, more = net(0.0), net(0.3)
    points = tet_grid(8).tet_verts
    coarse, fine = (2 * EXTENT / n for n in SHORT.resolution)
    more.cell = plain.cell = fine
    assert torch.equal(more(points)[0], plain(points)[0])
    with torch.no_grad():
        more.residual.values.fill_(0.1)
    assert torch.allclose(more(points)[0], plain(points)[0] + 0.03, atol=1e-6)
    assert more(points)[1].abs().max().item() <= fine / 2
    more.cell = plain.cell = coarse
    assert torch.equal(more(points)[0], plain(points)[0])


def test_a_residual_is_trilinear_between_its_nodes() -> None:
    residual = Residual(4, 1.0, 2.0)
    nodes = tet_grid(4, extent=1.0).tet_verts
    with torch.no_grad():
        residual.values.normal_(generator=torch.Generator().manual_seed(0))
    at_nodes = 2.0 * blurred(residual.values)[0].flatten(1).T
    assert torch.allclose(residual(nodes), at_nodes, atol=1e-6)
    middle = (at_nodes[0] + at_nodes[1]) / 2
    assert torch.allclose(residual(nodes[:2].mean(0, keepdim=True))[0], middle, atol=1e-6)


def test_a_lattice_is_filled_with_what_is_smaller_than_its_blur() -> None:
    """A plate of two cells: the blur alone would lift its middle by half a cell."""
    config = replace(SHORT, net=replace(SHORT.net, residual=0.1))
    net = sdf_net(config, torch.Generator().manual_seed(0))
    n = config.resolution[1]
    cell, nodes = 2 * EXTENT / n, tet_grid(n).tet_verts
    plate = Shape(lambda points: points[:, 2].abs() - cell, lambda count, generator: nodes[:count])
    assert net.residual
    fill(net.residual, net, plate, 1.0)
    net.cell = net.residual.cell
    with torch.no_grad():
        away = (net(nodes)[0] - plate.sdf(nodes)).abs()
    inner = nodes.abs().amax(1) < 0.8
    assert away[inner].max() < 0.15 * cell


def test_blur_keeps_what_is_the_same_everywhere_and_stops_what_alternates() -> None:
    assert torch.allclose(blurred(torch.ones(1, 4, 5, 5, 5)), torch.ones(1, 4, 5, 5, 5))
    stripes = torch.tensor([1.0, -1.0]).repeat(4)[None, None, :, None, None].expand(1, 1, 8, 8, 8)
    assert float(blurred(stripes)[0, 0, 1:-1].abs().max()) < 1e-6
