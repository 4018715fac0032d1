"""The finished mesh follows crisp pictures: descent on smooth vertices, normals, whole rounds."""

from dataclasses import replace

import pytest
import torch
from torch.nn.functional import normalize

from core.camera import sample_cameras
from core.config import DRAFT, SharpenConfig
from core.errors import Cancelled
from core.geometry.bilateral import following
from core.geometry.large_steps import SmoothVertices
from core.geometry.marching_tets import marching_tets
from core.geometry.tet_grid import tet_grid
from core.guidance.guidance import PromptedGuidance
from core.io.job import Job
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.render.normals import face_normals, render_normals
from core.stages.sharpen import Crisp, seen_normals, sharpened, within_reach

HALF = 0.55  # of the cube's side
SHORT = SharpenConfig(rounds=2, views=16, passes=1, steps=15, batch=8)
CONFIG = replace(DRAFT.geometry, sharpen=SHORT)


def cube_like(power: float):
    """The surface |x|^p + |y|^p + |z|^p = HALF^p: a ball for 2, nearly a cube for 30."""
    grid = tet_grid(24)
    size = grid.tet_verts.abs().clamp_min(1e-6).pow(power).sum(1).pow(1 / power)
    surface = marching_tets(grid.tet_verts, size - HALF, grid)
    return surface[0].float(), surface[1]


@pytest.fixture(scope="module")
def soft():
    return cube_like(5.0)


@pytest.fixture(scope="module")
def crisp():
    return cube_like(40.0)


class Knows(PromptedGuidance):
    """A guidance whose restored pictures are those of another mesh."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.asked = 0

    def predict(self, z_t, t, views, *, cond_only=False):
        raise AssertionError("sharpening predicts no noise")

    def encode_normals(self, n, o):
        picture = torch.cat([n, 2 * o - 1], -1).permute(0, 3, 1, 2)
        return torch.nn.functional.avg_pool2d(picture, 2)

    def restore(self, pictures, views):
        self.asked += 1
        if self.mesh is None:
            return None
        return self.encode_normals(*render_normals(*self.mesh, views.cameras, 128))


def progress_in(folder):
    return Progress(RunFolder.create(folder / "run", Job(prompt="a cube")))


@pytest.fixture
def progress(tmp_path):
    return progress_in(tmp_path)


@pytest.fixture(scope="module")
def flat(soft, crisp, tmp_path_factory):
    """The soft cube after it was sharpened."""
    return sharpened(CONFIG, Knows(crisp), *soft, progress_in(tmp_path_factory.mktemp("flat")))


def off_axis(verts, faces):
    """Mean angle in degrees of the faces, weighted by area, to the nearest axis."""
    cross = face_normals(verts, faces)
    cosine = normalize(cross, dim=1).abs().amax(1).clamp(max=1)
    area = cross.norm(dim=1)
    return float((torch.rad2deg(cosine.acos()) * area).sum() / area.sum())


def test_smooth_vertices_begin_where_they_are_and_reach_a_target(soft):
    verts, faces = soft
    smooth = SmoothVertices(verts, faces, 10.0)
    assert torch.allclose(smooth.verts(), verts, atol=1e-5)
    target = verts * 1.1 + 0.05
    first = last = 0.0
    for step in range(120):
        loss = (smooth.verts() - target).square().sum()
        smooth.step(loss, 0.02 * (1 - step / 120))
        first, last = first or loss.item(), loss.item()
    assert last < 0.02 * first


def test_a_pull_on_one_vertex_moves_its_neighbours(soft):
    verts, faces = soft
    smooth = SmoothVertices(verts, faces, 10.0)
    smooth.step(smooth.verts()[0].sum(), 0.02)
    moved = (smooth.verts().detach() - verts).norm(dim=1)
    around = faces[(faces == 0).any(1)].unique()
    assert moved[around].min() > 0.2 * moved[0]
    assert moved.median() < 0.02 * moved[0]


def test_vertices_follow_given_normals(soft):
    verts, faces = soft
    cross = face_normals(verts, faces)
    axis = cross.abs().argmax(1)
    wanted = torch.zeros_like(cross).scatter(1, axis[:, None], 1.0) * cross.sign()
    after = following(verts, faces, wanted, torch.ones(len(faces)), 0.3)
    assert off_axis(after, faces) < 0.6 * off_axis(verts, faces)
    untrusted = following(verts, faces, -wanted, torch.zeros(len(faces)), 1e-3)
    assert torch.allclose(untrusted, verts, atol=2e-3)


def test_normals_are_read_from_the_pictures_and_not_from_the_mesh(soft, crisp):
    cameras = sample_cameras(16, CONFIG.cameras, torch.Generator().manual_seed(3))
    pictures = Knows(crisp).encode_normals(*render_normals(*crisp, cameras, 128))
    normals, trust = seen_normals(*soft, Crisp(cameras, pictures))
    own = normalize(face_normals(*soft), dim=1)
    away = torch.rad2deg(normals.abs().amax(1).clamp(max=1).acos())
    away_own = torch.rad2deg(own.abs().amax(1).clamp(max=1).acos())
    seen = trust > 0.9
    assert seen.float().mean() > 0.8
    assert (normals * own).sum(1)[seen].median() > 0.8  # the same side, not turned over
    assert away[seen].mean() < 0.5 * away_own[seen].mean()


def test_a_soft_cube_gets_flat_and_stays_the_same_mesh(soft, crisp, flat, progress):
    verts, faces = soft
    after = flat
    assert off_axis(after, faces) < 0.5 * off_axis(verts, faces)
    assert torch.isfinite(after).all()
    outside = after.abs().amax(1)
    assert outside.max() < 1.1 * HALF
    torch.rand(1)  # whatever others drew before
    again = sharpened(CONFIG, Knows(crisp), verts, faces, progress)
    assert torch.equal(after, again)


def test_the_last_rounds_look_closely(soft, crisp, progress):
    guidance = Knows(crisp)
    fields = []
    restore = guidance.restore
    guidance.restore = lambda pictures, views: (
        fields.append(views.cameras.fovy.mean().item()) or restore(pictures, views)
    )
    config = replace(CONFIG, sharpen=replace(SHORT, rounds=3, close_rounds=2))
    sharpened(config, guidance, *soft, progress)
    assert len(fields) == 3
    assert max(fields[1:]) < 0.7 * fields[0]


def test_what_is_crisp_is_left_alone(crisp, progress):
    verts, faces = crisp
    after = sharpened(CONFIG, Knows(crisp), verts, faces, progress)
    assert (after - verts).norm(dim=1).mean() < 0.01


def test_without_a_restorer_or_rounds_nothing_moves(soft, progress):
    verts, faces = soft
    cannot, off = Knows(None), Knows(soft)
    assert torch.equal(sharpened(CONFIG, cannot, verts, faces, progress), verts)
    assert cannot.asked == 1
    none = replace(CONFIG, sharpen=SharpenConfig())
    assert torch.equal(sharpened(none, off, verts, faces, progress), verts)
    assert off.asked == 0


def test_it_can_be_cancelled(soft, progress):
    progress.interrupt()
    with pytest.raises(Cancelled):
        sharpened(CONFIG, Knows(soft), *soft, progress)


def test_no_vertex_goes_beyond_its_reach():
    start = torch.zeros(3, 3)
    verts = torch.tensor([[0.005, 0, 0], [0, 0.3, 0.4], [0, 0, 0]])
    near = within_reach(start, verts, 0.01)
    torch.testing.assert_close(near[0], verts[0])  # nearer than that: where it went
    torch.testing.assert_close(near[1], torch.tensor([0, 0.006, 0.008]))  # on its way
    torch.testing.assert_close(near[2], verts[2])
    assert torch.equal(within_reach(start, verts, 0), verts)


def test_sharpening_keeps_within_its_reach(soft, crisp, flat, progress):
    verts, faces = soft
    config = replace(CONFIG, sharpen=replace(SHORT, reach=0.004))
    away = (sharpened(config, Knows(crisp), verts, faces, progress) - verts).norm(dim=1)
    freely = (flat - verts).norm(dim=1)
    assert away.max() <= 0.004 + 1e-6 < freely.max()
