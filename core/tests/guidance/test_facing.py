"""A guide's front is found by the built-in prior, whichever way it was turned."""

import math
from dataclasses import replace

import numpy as np
import pytest
import torch
import trimesh

from core.command_line import main
from core.config import DRAFT
from core.generate import Inputs, facing
from core.geometry.mesh import Mesh, turned
from core.guidance.guidance import PromptedGuidance
from core.guidance.load import make_guidance
from core.io.asset import read_asset
from core.io.job import Job, read_events
from core.io.obj import write_plain_obj
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.reproduce.guides import seat
from core.stages.facing import front_turn, turned_vectors
from core.tests import tiny_runs

pytestmark = pytest.mark.usefixtures("once")  # more than one test asks of the same pictures


@pytest.fixture(scope="module")
def prior(once):
    return make_guidance("builtin", "cpu")


def quarter(turns: int) -> float:
    return turns * math.pi / 2


@pytest.mark.parametrize("away", [0, 1, 2, 3])
def test_a_chair_is_turned_to_its_front(prior, away) -> None:
    guide = replace(seat(), verts=turned(seat().verts, quarter(away)))
    found = front_turn(guide, prior.prompted("a wooden chair", ""))
    assert math.cos(found + quarter(away)) == pytest.approx(1, abs=1e-6)


def test_what_looks_the_same_from_all_sides_stays(prior) -> None:
    ball = trimesh.creation.icosphere(3, 1.0)
    guide = Mesh(torch.tensor(ball.vertices).float(), torch.tensor(ball.faces).long())
    assert front_turn(guide, prior.prompted("a red ball", "")) == 0


def test_a_guidance_that_sees_normals_in_the_camera_s_frame_is_not_asked(prior) -> None:
    prompted = prior.prompted("a wooden chair", "")
    prompted.normal_frame = "camera"
    sideways = replace(seat(), verts=turned(seat().verts, quarter(1)))
    assert front_turn(sideways, prompted) == 0


def test_a_turn_of_vectors_is_that_of_vertices() -> None:
    z = torch.randn(2, 4, 3, 3, generator=torch.Generator().manual_seed(0))
    vectors = z[:, :3].permute(0, 2, 3, 1).reshape(-1, 3)
    found = turned_vectors(z, 0.7)
    expected = turned(vectors, 0.7)
    torch.testing.assert_close(found[:, :3].permute(0, 2, 3, 1).reshape(-1, 3), expected)
    assert torch.equal(found[:, 3], z[:, 3])


def job_of(**settings: object) -> Job:
    return Job(prompt="a wooden chair", guide_mesh="seat.obj", settings=settings)


def inputs_of(guide: Mesh, guidance: PromptedGuidance, find_front: bool = True) -> Inputs:
    geometry = replace(DRAFT.geometry, find_front=find_front)
    config = replace(DRAFT, geometry=geometry)
    return Inputs(config, torch.device("cpu"), guidance, torch.zeros(2, 4, 3), guide)


def test_a_run_keeps_its_turn_and_tells_of_it(prior, tmp_path, monkeypatch) -> None:
    guide = replace(seat(), verts=turned(seat().verts, quarter(1)))
    run = RunFolder.create(tmp_path / "run", job_of())
    inputs = inputs_of(guide, prior.prompted("a wooden chair", ""))
    first = facing(run, inputs, Progress(run))
    assert first.shape is not None
    torch.testing.assert_close(turned(first.shape.verts, -run.turn), guide.verts)
    assert math.sin(run.turn) == pytest.approx(-1, abs=1e-6)
    (event,) = [e for e in read_events(run.path) if e["type"] == "warning"]
    assert "°" in event["text"] and "find_front" in event["fix"]

    monkeypatch.setattr("core.generate.front_turn", lambda *_: pytest.fail("asked again"))
    again = RunFolder.open(run.path)
    facing(again, inputs, Progress(again))
    assert again.turn == run.turn


def test_a_guide_can_be_taken_as_it_is(prior, tmp_path) -> None:
    guide = replace(seat(), verts=turned(seat().verts, quarter(1)))
    inputs = inputs_of(guide, prior.prompted("a wooden chair", ""), find_front=False)
    run = RunFolder.create(tmp_path / "run", job_of())
    assert facing(run, inputs, Progress(run)).shape is guide
    assert run.turn == 0


def test_the_asset_stands_as_the_user_s_guide_does(tmp_path) -> None:
    guide = replace(seat(), verts=turned(seat().verts, quarter(1)))  # its back is at -x
    path = tmp_path / "guide.obj"
    write_plain_obj(path, guide.verts, guide.faces)
    run = tmp_path / "run"
    argv = ["generate", "a wooden chair", "--guide", str(path), "--guide-strength=1"]
    assert main([*argv, "--out", str(run), *tiny_runs.OPTIONS]) == 0
    texts = [event.get("text", "") for event in read_events(run)]
    assert any("270°" in text for text in texts)
    seen = torch.from_numpy(np.load(run / "preview" / "shape.npz")["verts"])
    for verts in (read_asset(run).mesh.verts, seen):
        low, high = verts.amin(0), verts.amax(0)
        top = verts[verts[:, 2] > low[2] + 0.8 * (high - low)[2]]
        assert bool((top[:, 0] < (low + high)[0] / 2).all())
