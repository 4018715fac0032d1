"""A drawn solid takes the guide's proportions: by its box, by bending, and by the leash."""

from dataclasses import replace
from functools import cache
from pathlib import Path
from unittest import mock

import pytest
import torch

from core.generate import (
    Inputs,
    generate,
    in_proportion,
    learned_shape,
    of_seed,
    prepare,
)
from core.geometry.bend import CONTROLS, Bend, basis, bend_to, bending, stiffness_of
from core.geometry.guide import guide_leash, guide_shape
from core.geometry.init_shape import ellipsoid, sample_surface
from core.geometry.leash import reach_of
from core.geometry.mesh import Mesh, health, normalise
from core.geometry.parts import components
from core.geometry.residual import lattice_nodes
from core.geometry.signed_distance import SolidMesh
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.bent import MOST_RADIUS, in_box
from core.guidance.load import make_guidance
from core.io.job import Job
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.job_config import config_of
from core.reproduce.guides import bus, seat

LEAST = 0.02

pytestmark = pytest.mark.usefixtures("once")  # one chair is drawn


def seeded() -> torch.Generator:
    return torch.Generator().manual_seed(0)


def points_in_cube(count: int = 400) -> torch.Tensor:
    return (2 * torch.rand(count, 3, generator=seeded()) - 1) * EXTENT


def knots() -> torch.Tensor:
    """Where the control points are."""
    side = torch.linspace(-1, 1, CONTROLS - 2) * EXTENT
    cell = side[1] - side[0]
    side = torch.cat([side[:1] - cell, side, side[-1:] + cell])
    return torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1)


def test_the_splines_give_any_affine_map_exactly() -> None:
    """And nothing bends under it."""
    points = points_in_cube()
    matrix = torch.tensor([[0.2, 0.1, 0.0], [-0.3, 0.1, 0.2], [0.0, 0.1, -0.2]])
    controls = knots() @ matrix + torch.tensor([0.1, 0.2, -0.3])
    expected = points + points @ matrix + torch.tensor([0.1, 0.2, -0.3])
    torch.testing.assert_close(Bend(controls)(points), expected, atol=1e-5, rtol=0)
    assert float(bending(controls)) < 1e-9


def test_the_weights_are_products_of_cubic_b_splines() -> None:
    """At a control point (1, 4, 1) / 6 along each axis."""
    at = knots()[3, 4, 2][None]
    expected = torch.zeros(CONTROLS, CONTROLS, CONTROLS)
    row = torch.tensor([1.0, 4.0, 1.0]) / 6
    expected[2:5, 3:6, 1:4] = torch.einsum("a,b,c->abc", row, row, row)
    torch.testing.assert_close(basis(at, CONTROLS)[0], expected.flatten(), atol=1e-6, rtol=0)


def test_a_quadratic_displacement_bends_by_its_second_derivative() -> None:
    """u = x² / 2 along z: its second differences are cell² everywhere, in units of the cell."""
    controls = torch.zeros(CONTROLS, CONTROLS, CONTROLS, 3)
    controls[..., 2] = knots()[..., 0].square() / 2
    cell = 2 * EXTENT / (CONTROLS - 3)
    fraction = (CONTROLS - 2) / CONTROLS  # of the control points, that have one on either side
    assert float(bending(controls)) == pytest.approx(fraction * cell**2, rel=1e-4)


def differ(bend: Bend, solid, target) -> float:
    """How much of the target's surroundings is on another side."""
    nodes = lattice_nodes(32, EXTENT)
    nodes = nodes[target(nodes).abs() < 0.2]
    return float(((solid(bend(nodes)) < 0) != (target(nodes) < 0)).float().mean())


def test_a_softer_solid_comes_nearer_and_an_unending_stiffness_leaves_it() -> None:
    bends = [_to_a_pear(stiffness) for stiffness in (float("inf"), 1.0, 0.02, 0.002)]
    off = [differ(bend, _egg, _pear) for bend in bends]
    bent = [float(bending(bend.controls)) for bend in bends]
    assert off == sorted(set(off), reverse=True)
    assert bent == sorted(set(bent))
    assert off[3] < 0.3 * off[0]
    assert float(bends[0].controls.abs().max()) == 0


_egg = ellipsoid((0.6, 0.5, 0.7)).sdf


@cache
def _to_a_pear(stiffness: float) -> Bend:
    return bend_to(_egg, _pear, stiffness)


def _pear(points: torch.Tensor) -> torch.Tensor:
    """Two balls, the upper one smaller."""
    low, high = (points - torch.tensor([0.0, 0.0, z]) for z in (-0.3, 0.4))
    return (low.norm(dim=1) - 0.5).minimum(high.norm(dim=1) - 0.3)


def test_what_is_alike_on_both_sides_stays_so() -> None:
    bend = _to_a_pear(0.002)
    points = points_in_cube()
    other = torch.tensor([-1.0, 1.0, 1.0])
    torch.testing.assert_close(bend(points * other), bend(points) * other, atol=1e-4, rtol=0)


def test_the_stiffness_falls_with_the_strength_and_flat_things_are_stiffer() -> None:
    some = [stiffness_of(s / 10, 0.5) for s in range(11)]
    assert some == sorted(some, reverse=True)
    assert some[0] == float("inf")
    assert some[10] == 0
    assert stiffness_of(0.5, 1.0) > 3 * stiffness_of(0.5, 0.0)


@pytest.fixture(scope="module")
def chair():
    """What the prior draws for a chair."""
    return make_guidance("builtin", "cpu").prompted("a wooden chair", "").of_object(0)


def test_a_solid_fills_the_guide_s_box(chair) -> None:
    guide = normalise(bus().verts)[0]
    made = in_box(chair.solid, guide, LEAST).mesh[0]
    cell = 2 * EXTENT / 64
    torch.testing.assert_close(made.amax(0), guide.amax(0), atol=cell, rtol=0)
    torch.testing.assert_close(made.amin(0), guide.amin(0), atol=cell, rtol=0)


def test_a_flat_guide_and_a_ball_s_box_leave_a_solid_that_is_seen(chair) -> None:
    flat = torch.tensor([[-0.5, 0.0, -0.7], [0.5, 0.0, -0.7], [0.0, 0.0, 0.7]])
    made = in_box(chair.solid, flat, LEAST).mesh[0]
    assert len(made)
    ball = 0.9 * torch.cat([torch.eye(3), -torch.eye(3)])
    made = in_box(chair.solid, ball, LEAST).mesh[0]
    assert float(made.norm(dim=1).max()) < MOST_RADIUS + 0.03


def test_where_nothing_is_drawn_a_guide_changes_no_guidance() -> None:
    prompted = make_guidance("builtin", "cpu").prompted("a wooden chair", "")
    assert prompted.in_proportion(seat(), 0.5, LEAST) is prompted


def made_of(strength: float, run: Path) -> tuple[Inputs, Mesh]:
    """A chair by the guide of a chair; the guidance knows where its parts are."""
    with mock.patch.object(components, "SEARCH", 40):  # its parts are found in a fifth of the time
        return _made_of(strength, run)


def _made_of(strength: float, run: Path) -> tuple[Inputs, Mesh]:
    job = Job(prompt="a wooden chair", guide_mesh="seat.obj", guide_strength=strength)
    folder = RunFolder.create(run, job)
    prompted = make_guidance("builtin", "cpu").prompted(job.prompt, "")
    inputs = Inputs(config_of(job), torch.device("cpu"), prompted, torch.zeros(2, 4, 3), seat())
    inputs = in_proportion(of_seed(inputs, job), job)
    mesh = learned_shape(folder, inputs, Progress(folder))
    assert mesh is not None
    return inputs, mesh


def apart(mesh: Mesh, guide: Mesh) -> float:
    """The mean of the ways to the other surface, of the guide's longest side."""
    whole = Mesh(normalise(guide.verts)[0], guide.faces)
    side = float((whole.verts.amax(0) - whole.verts.amin(0)).max())
    ways = [
        float(SolidMesh(b.verts, b.faces).distance(sampled(a)).mean())
        for a, b in ((mesh, whole), (whole, mesh))
    ]
    return sum(ways) / 2 / side


def sampled(mesh: Mesh) -> torch.Tensor:
    return sample_surface(mesh.verts.float(), mesh.faces, 4000, seeded())


@pytest.fixture(scope="module")
def leashed(tmp_path_factory: pytest.TempPathFactory) -> tuple[Inputs, Mesh]:
    """Of strength 0.7."""
    return made_of(0.7, tmp_path_factory.mktemp("leashed") / "run")


def test_a_guide_s_chair_is_a_chair_of_its_proportions(leashed) -> None:
    inputs, mesh = leashed
    report = health(mesh.verts, mesh.faces)
    assert report["closed"]
    assert report["components"] == 1
    assert report["genus"] == 1  # the gap over the seat that the words' chair has
    assert apart(mesh, seat()) < 0.01  # by fitting to pictures it was 0.02
    guide = normalise(seat().verts)[0]
    far = SolidMesh(guide, seat().faces).distance(mesh.verts)
    assert float(far.max()) < reach_of(0.7) + 1e-6
    # The colours of the parts are where the parts are.
    parts = inputs.guidance.parts()
    assert parts is not None
    off = parts.distances(mesh.verts).amin(1).abs()
    assert float(off.quantile(0.9)) < 0.02


def test_a_stronger_guide_is_nearer(leashed, tmp_path) -> None:
    free, strict = (made_of(strength, tmp_path / str(strength)) for strength in (0.0, 0.99))
    off = [apart(mesh, seat()) for _, mesh in (free, leashed, strict)]
    assert off[0] > 1.5 * off[1]
    assert off[1] > 1.5 * off[2]
    assert off[2] < 0.003
    assert health(strict[1].verts, strict[1].faces)["genus"] == 0  # as the guide


def test_the_words_parts_end_with_the_leash_and_the_guide_s_inside_stays(chair) -> None:
    guide = bus()
    shape = guide_shape(guide, LEAST)
    leash = guide_leash(guide, shape, 0.5, 32, EXTENT)
    points = points_in_cube(4000)
    g = shape.sdf(points)
    slack = 0.25 * leash.cell  # g is trilinear between nodes
    for wanted in (-1.0, 1.0):  # full, and empty
        parts = leash.parts(lambda p, w=wanted: torch.full((len(p), 2), w), 2)(points)
        assert parts.shape == (4000, 3)
        inside = parts.amin(1) < 0
        assert not inside[g > leash.reach + slack].any()
        assert inside[g < -leash.reach - slack].all()
        # Between the two the words decide.
        between = g.abs() < leash.reach - slack
        assert bool((inside[between] == (wanted < 0)).all())


class Seen(Exception):  # noqa: N818
    """Ends a run at the unwrap, with the vertices that came there."""


@pytest.mark.parametrize("start", ["learned", "ellipsoid"])
def test_a_drawn_mesh_stays_where_its_parts_are_known(tmp_path, monkeypatch, start) -> None:
    """It is not brought into the cube once more, or all colours would be off; others are."""
    job = Job(prompt="a wooden chair", settings={"geometry.start": start})
    made = replace(seat(), verts=normalise(seat().verts)[0] * 0.9 + 0.05)

    def stop(mesh: Mesh, *_: object, **__: object) -> None:
        raise Seen(mesh.verts)

    monkeypatch.setattr("core.generate.learned_shape", lambda *_, **__: made)
    monkeypatch.setattr("core.generate.unwrap_shape", stop)
    run = RunFolder.create(tmp_path / "run", job)
    with pytest.raises(Seen) as caught:
        generate(run, prepare(job), Progress(run))
    expected = made.verts if start == "learned" else normalise(made.verts)[0]
    assert torch.equal(caught.value.args[0], expected)
