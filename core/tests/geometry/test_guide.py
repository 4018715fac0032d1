"""A guide mesh is kept: all of it at strength 1, nearly all just below, its start at 0."""

import itertools
import subprocess
import sys
from textwrap import dedent

import pytest
import torch
import trimesh

from core.config import DRAFT, preset
from core.generate import Inputs, learned_shape
from core.geometry import init_shape
from core.geometry.guide import fill, guide_leash, guide_shape, kept
from core.geometry.init_shape import (
    MOST_STEPS,
    fit,
    fit_until_still,
    mesh_shape,
    sample_surface,
)
from core.geometry.leash import LEAST_REACH, reach_of
from core.geometry.mesh import Mesh, health, normalise, signed_volume
from core.geometry.residual import Residual
from core.geometry.sdf_net import FOURIER, SdfNet, extract
from core.geometry.signed_distance import SolidMesh
from core.geometry.tet_grid import EXTENT, tet_grid
from core.guidance.guidance import PromptedGuidance
from core.guidance.load import make_guidance
from core.io.job import Job
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.job_config import config_of, shortened
from core.settings import check
from core.texture.simplify import simplify

BOUND = 0.003  # mean distance, of the longest side


def seeded(seed=0):
    return torch.Generator().manual_seed(seed)


def mesh_of(*parts: trimesh.Trimesh, weld: bool = False) -> Mesh:
    whole = trimesh.util.concatenate(list(parts))
    if weld:
        whole.merge_vertices()
    return Mesh(torch.tensor(whole.vertices).float(), torch.tensor(whole.faces).long())


def box(size, center=(0.0, 0.0, 0.0)):
    return trimesh.creation.box(size, trimesh.transformations.translation_matrix(center))


def wild() -> dict[str, Mesh]:
    """Meshes as files have them, each with a fault or a part that no lattice of 64 holds."""
    ball, ring = trimesh.creation.icosphere(3, 1.0), trimesh.creation.torus(1.0, 0.3)
    half = trimesh.Trimesh(ball.vertices, ball.faces[ball.triangles_center[:, 2] > 0])
    inward = trimesh.Trimesh(ring.vertices, ring.faces[:, ::-1], process=False)
    return {
        "open": mesh_of(half),
        "inward": mesh_of(inward),
        "two components": mesh_of(box((1, 1, 1)), box((0.2, 0.2, 0.2), (1.2, 0, 0))),
        "thin plate": mesh_of(box((1, 1, 0.004))),
        "three faces at an edge": mesh_of(box((1, 1, 1)), box((1, 1, 1), (1, 1, 0)), weld=True),
    }


def apart(one: Mesh, other: Mesh) -> float:
    """The larger of the mean distances from one to the other and back, of the longest side."""
    return max(ways(one, other))


def ways(one: Mesh, other: Mesh) -> list[float]:
    """Both of them."""
    side = float((other.verts.amax(0) - other.verts.amin(0)).max())
    found = []
    for a, b in ((one, other), (other, one)):
        points = sample_surface(a.verts, a.faces, 4000, seeded())
        found.append(float(SolidMesh(b.verts, b.faces).distance(points).mean()) / side)
    return found


@pytest.fixture(scope="module")
def guidance() -> PromptedGuidance:
    return make_guidance("builtin", "cpu").prompted("a chair", "")


@pytest.mark.parametrize("name", wild())
def test_strength_1_keeps_any_mesh(name, guidance, tmp_path) -> None:
    guide = wild()[name]
    job = Job(prompt="a chair", guide_mesh="guide.obj", guide_strength=1)
    run = RunFolder.create(tmp_path / "run", job)
    inputs = Inputs(DRAFT, torch.device("cpu"), guidance, torch.zeros(2, 4, 3), guide)
    mesh = learned_shape(run, inputs, Progress(run))
    assert apart(mesh, guide) < BOUND
    assert (tmp_path / "run" / "preview" / "normals.png").exists()
    report = health(mesh.verts, mesh.faces)
    assert report["manifold"]
    assert report["oriented"]
    if health(guide.verts, guide.faces)["closed"]:
        assert signed_volume(mesh.verts, mesh.faces) > 0  # faces look outward


def test_a_guide_of_many_faces_that_is_no_manifold_is_simplified() -> None:
    blocks = [box((1, 1, 1)), box((1, 1, 1), (1, 1, 0))]
    guide = mesh_of(*(b.subdivide().subdivide().subdivide() for b in blocks), weld=True)
    assert not health(guide.verts, guide.faces)["manifold"]
    mesh = kept(guide)
    few = Mesh(*simplify(mesh.verts, mesh.faces, 300))
    assert len(few.faces) <= 300
    assert apart(few, guide) < BOUND


LEAVES = """
    import hashlib
    import numpy as np
    import torch
    import trimesh
    from core.geometry.guide import kept
    from core.geometry.mesh import Mesh

    draw = np.random.default_rng(1)
    trunk = trimesh.creation.cylinder(0.1, 1.5)
    verts, faces = [trunk.vertices], [trunk.faces]
    for k in range(40):  # each as its modeller left it
        leaf = np.array([[-0.15, -0.15, 0], [0.15, -0.15, 0], [0.15, 0.15, 0], [-0.15, 0.15, 0]])
        turn = trimesh.transformations.random_rotation_matrix(draw.random(3))[:3, :3]
        verts.append(leaf @ turn.T + draw.normal(size=3) * 0.3 + [0, 0, 0.8])
        two = np.array([[0, 1, 2], [0, 2, 3]])[:, :: draw.choice([-1, 1])]
        faces.append(two + len(trunk.vertices) + 4 * k)
    mesh = Mesh(torch.tensor(np.concatenate(verts)).float(), torch.tensor(np.concatenate(faces)))
    print(hashlib.sha256(kept(mesh).faces.numpy().tobytes()).hexdigest())
"""


def test_a_guide_of_sheets_is_the_same_in_every_process() -> None:
    command = [sys.executable, "-c", dedent(LEAVES)]
    # libigl's rays are drawn by the second.
    first = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    again = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    assert first.stdout == again.stdout != ""


@pytest.fixture
def few_points(monkeypatch) -> None:
    """Ψ is fitted to an eighth of the points, in as little of the time."""
    monkeypatch.setattr(init_shape, "SURFACE_POINTS", 600)
    monkeypatch.setattr(init_shape, "UNIFORM_POINTS", 350)


def test_the_lattice_gives_what_psi_lacks_by_the_strength(few_points) -> None:
    """Smoothly: at 0 Ψ's own surface, at 1 the guide's."""
    guide = wild()["inward"]
    verts, _, _ = normalise(guide.verts)
    grid = tet_grid(32)
    net = SdfNet(grid.cell, FOURIER, generator=seeded())
    net.residual = Residual(32, EXTENT, 0.1)
    shape = mesh_shape(guide)
    fit(net, shape, 150, seeded(1))  # cut short, so that something is left for the lattice
    found = []
    for strength in (0.0, 0.5, 1.0):
        fill(net.residual, net, shape, strength)
        with torch.no_grad():
            surface = extract(net, grid)
        found.append(apart(Mesh(surface.verts, surface.faces), Mesh(verts, guide.faces)))
    assert found[0] > 2 * found[2]
    assert found[0] > found[1] > found[2]
    assert found[2] < 0.0015


def leashed(guide: Mesh, strength: float, resolution: int = 32) -> SdfNet:
    """A Ψ that knows nothing of the guide, on its leash."""
    net = SdfNet(2 * EXTENT / resolution, FOURIER, generator=seeded())
    shape = guide_shape(guide, 1.2 * EXTENT / resolution)
    net.leash = guide_leash(guide, shape, strength, resolution, EXTENT)
    return net


@pytest.mark.parametrize("strength", [0.99, 0.9, 0.7, 0.5, 0.3])
def test_the_surface_stays_within_the_leash(strength) -> None:
    """Of an inward torus and of a plate that is thinner than a cell, whatever Ψ wants."""
    for name in ("inward", "thin plate"):
        guide = wild()[name]
        net, reach = leashed(guide, strength), max(reach_of(strength), LEAST_REACH)
        solid = SolidMesh(normalise(guide.verts)[0], guide.faces)
        for wanted in (-5.0, 5.0):  # full, and empty
            net.mlp[-1].bias.data[0] += wanted
            surface = extract(net, tet_grid(32))
            # The distance is trilinear between nodes: right to a fraction of a cell.
            slack = (0.25 if name == "inward" else 0.75) * net.cell
            assert float(solid.distance(surface.verts).max()) < reach + slack
            held = net.leash.hold(surface.verts)
            assert float(solid.distance(held).max()) < reach + 1e-6


@pytest.mark.parametrize("name", wild())
def test_just_below_strength_1_nothing_jumps(name) -> None:
    """Sheets and thin plates have a skin of a cell on the lattice, and none in the mesh."""
    guide = wild()[name]
    net = leashed(guide, 0.99, 64)
    with torch.no_grad():
        surface = extract(net, tet_grid(64))
    mesh = Mesh(net.leash.hold(surface.verts), surface.faces)
    whole = Mesh(normalise(guide.verts)[0], guide.faces)
    assert ways(whole, mesh)[0] < BOUND
    if health(guide.verts, guide.faces)["closed"]:  # a hole is closed by a wall of its own
        assert apart(mesh, whole) < BOUND
    assert health(mesh.verts, mesh.faces)["closed"]


def test_the_leash_is_shorter_inwards() -> None:
    """A limb that is thinner than the leash stays, though in places Ψ has none."""
    guide = mesh_of(box((0.2, 0.2, 2.0)))  # half as thick as 0.09 training units
    net = leashed(guide, 0.5)
    assert reach_of(0.5) > 0.09
    net.mlp[-1].bias.data[0] += 5.0
    with torch.no_grad():
        surface = extract(net, tet_grid(32))
    assert float(surface.verts[:, 2].amax() - surface.verts[:, 2].amin()) > 1.6


def test_the_wall_over_a_hole_is_not_drawn_to_its_rim() -> None:
    net = leashed(wild()["open"], 0.9)
    middle = torch.tensor([[0.0, 0.0, -0.45], [0.1, 0.0, -0.4]])
    torch.testing.assert_close(net.leash.hold(middle), middle)


def test_the_leash_grows_smoothly_as_the_strength_falls() -> None:
    reach = [reach_of(s / 100) for s in range(100, 0, -1)]
    assert reach[0] == 0
    assert all(a < b for a, b in itertools.pairwise(reach))
    # Nowhere does a hundredth of the strength change it by more than a tenth of what is there,
    # and a hundredth of a unit.
    steps = zip(reach[1:70], reach[:69], strict=True)
    assert all(b - a < 0.01 + 0.1 * a for b, a in steps)
    assert reach_of(0.0) == float("inf")


def test_without_a_pull_the_leash_gives_the_surface_free() -> None:
    """Within it Ψ's gradient is what it was, and a long leash is none."""
    guide, points = wild()["inward"], torch.rand(200, 3, generator=seeded()) * 2 - 1
    net = leashed(guide, 1e-6)
    held = net(points)
    net.leash = None
    torch.testing.assert_close(held, net(points), atol=2e-5, rtol=0)


def test_a_fit_ends_by_itself_near_the_surface(few_points) -> None:
    """The draft's 200 steps of old left a torus four times as far away."""
    net, seen = SdfNet(2 * EXTENT / 16, FOURIER, generator=seeded()), []
    progress = lambda step, error: seen.append(step)  # noqa: E731
    error = fit_until_still(net, mesh_shape(wild()["inward"]), seeded(1), progress)
    assert error < 0.006
    assert 200 < len(seen) < MOST_STEPS


def test_a_sheet_has_an_inside() -> None:
    """Winding numbers give it none; the lattice needs nodes that are inside."""
    sheet = Mesh(torch.tensor([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]),
                 torch.tensor([[0, 1, 2], [0, 2, 3]]))  # fmt: skip
    middle = torch.tensor([[0.05, 0.02, 0.0], [0.05, 0.02, 0.3]])
    assert bool((mesh_shape(sheet).sdf(middle) >= 0).all())
    torch.testing.assert_close(
        guide_shape(sheet, 0.02).sdf(middle), torch.tensor([-0.02, 0.28]), atol=1e-5, rtol=0
    )


def test_a_thick_guide_is_not_thickened() -> None:
    guide = mesh_of(box((1, 1, 1)))
    points = torch.rand(500, 3, generator=seeded()) * 2 - 1
    assert torch.equal(guide_shape(guide, 0.02).sdf(points), mesh_shape(guide).sdf(points))


@pytest.mark.parametrize("name", ["draft", "standard"])
def test_steps_go_to_none_as_the_strength_goes_to_1(name) -> None:
    steps = [_steps(shortened(preset(name), s).geometry) for s in (0.0, 0.3, 0.6, 0.9, 0.999)]
    assert steps == sorted(steps, reverse=True)
    assert steps[0] == _steps(preset(name).geometry)
    assert steps[3] < 0.2 * steps[0]
    assert steps[4] < 0.002 * steps[0]


def _steps(config) -> int:
    rounds = sum(phase.rounds * phase.steps for phase in (config.grow, config.refine))
    return config.coarse.steps + config.fine.steps + rounds


def test_no_setting_draws_another_shape_than_a_guide_that_is_kept() -> None:
    """The drawn parts would be right only if the guide were in the training's cube already."""
    settings = {"geometry.start": "learned"}
    options = {"prompt": "a chair", "guide_mesh": "guide.obj", "settings": settings}
    assert config_of(Job(**options, guide_strength=1)).geometry.start == "ellipsoid"
    assert config_of(Job(**options, guide_strength=0.9)).geometry.start == "learned"


@pytest.mark.parametrize("strength", [0.3, 0.9])
def test_half_of_the_noise_is_no_empty_range(strength) -> None:
    """The least of it comes down with the most, where that is half of what was set."""
    options = {"prompt": "a chair", "guide_strength": strength}
    coarse = {"geometry.coarse.t_low": 0.4, "geometry.coarse.t_high": "0.5,0.5"}
    late = {"appearance.late.t_low": 0.5}
    check(config_of(Job(**options, guide_mesh="guide.obj", settings=coarse)))
    texture = {"command": "texture", "mesh": "mesh.obj", "base_color": "mesh"}
    check(config_of(Job(**options, **texture, settings=late)))
