"""How many views are rendered together."""

from functools import cache

import pytest
import torch

from core import kernels
from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.shaded import UvMesh, render_shaded
from core.camera import CameraConfig, Cameras
from core.config import PAPER
from core.geometry.tangents import smooth_normals
from core.guidance.stable_diffusion.fit import RESERVE, busy_bytes, estimate_memory
from core.guidance.stable_diffusion.memory import _Live
from core.guidance.stable_diffusion.source import Checkpoint
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.stages import room
from core.stages.room import LIT, NORMALS, covered_fraction, render_bytes, views_that_fit
from core.tests.guidance.test_stable_diffusion import CONFIGURATIONS
from core.tests.meshes import sphere

GPU = torch.device("cuda")
CAMERAS = PAPER.geometry.cameras


@pytest.fixture
def plain(monkeypatch):
    """Plain torch, as on a GPU."""
    monkeypatch.setattr(kernels, "supports", lambda *_: False)


def looking(views):
    return Cameras.orbit(torch.arange(views) * 90.0, [20.0] * views)


def test_the_sphere_around_the_object_covers_what_it_should(plain):
    verts, faces = sphere(5, room.HOLDS)
    _, o = render_normals(verts, faces, looking(2), 128)
    assert float(o.mean()) == pytest.approx(covered_fraction(CAMERAS), rel=0.02)
    assert covered_fraction(CameraConfig(distance=(1.5, 3.0), fovy_deg=(20, 40))) == 1


@pytest.mark.parametrize(("views", "size"), [(2, 512), (6, 512)])
def test_the_estimate_of_the_normals_is_within_a_quarter(plain, views, size):
    verts, faces = sphere(6, room.HOLDS)
    verts.requires_grad_()
    edges, cameras = edge_table(faces), looking(views)
    with _Live() as live:
        n, o = render_normals(verts, faces, cameras, size, edges=edges)
        (n.square().sum() + o.sum()).backward()
    assert render_bytes(NORMALS, views, size, CAMERAS) == pytest.approx(live.peak, rel=0.25)


def test_the_estimate_of_lit_pictures_is_within_a_quarter(plain):
    """And shading's part of the paper's 24 views is no longer 9 GB."""
    verts, faces = sphere(6, room.HOLDS)
    up = torch.tensor([1.0, 0, 0, 1]).expand(len(faces), 3, 4)
    normals = smooth_normals(verts, faces)[faces]
    mesh = UvMesh(verts, faces, verts[:, :2], faces, normals, up, edge_table(faces), True)
    net = MaterialNet(PAPER.appearance, torch.Generator().manual_seed(0))
    light = Environment.of(torch.rand(8, 16, 3), "lobes")
    with _Live() as live:
        shaded = render_shaded(mesh, net, looking(2), 512, light)
        shaded.srgb.square().sum().backward()
    assert render_bytes(LIT, 2, 512, CAMERAS) == pytest.approx(live.peak, rel=0.25)
    assert render_bytes(LIT, 24, 512, CAMERAS) < 2e9


@cache
def sd15(chunk=0):
    """Bytes of Stable Diffusion 1.5's weights in 16 bit; of the work on ``chunk`` pictures."""
    checkpoint, given = Checkpoint(CONFIGURATIONS / "sd15"), {"dtype": torch.float16}
    if chunk:
        return busy_bytes(checkpoint, chunk=chunk, **given)
    whole = estimate_memory(checkpoint, chunk=1, **given) / RESERVE
    return whole - busy_bytes(checkpoint, chunk=1, **given)


@pytest.mark.parametrize(("gigabytes", "chunk"), [(6, 1), (8, 2), (12, 4), (24, 8), (80, 24)])
def test_next_to_stable_diffusion_the_papers_views_fit_as_they_are(gigabytes, chunk, monkeypatch):
    """At its true size: the chunk of pictures leaves room for 24 views, rendered at once."""
    monkeypatch.setattr(room, "available_bytes", lambda _: gigabytes * 1e9 - sd15())
    for kind in (NORMALS, LIT):
        fit = views_that_fit(kind, 24, 512, CAMERAS, GPU, busy=sd15(chunk))
        needed = sd15() + sd15(chunk) + render_bytes(kind, fit, 512, CAMERAS)
        assert needed < gigabytes * 1e9
        assert fit >= (24 if kind is NORMALS or gigabytes > 6 else 8)


def test_less_memory_takes_fewer_views_and_groups_stay_together(monkeypatch):
    free = 0.0
    monkeypatch.setattr(room, "available_bytes", lambda _: free)
    fits = []
    for free in (0.0, 0.4e9, 0.6e9, 1e9, 3e9):
        fits.append(views_that_fit(LIT, 24, 512, CAMERAS, GPU))
        together = views_that_fit(LIT, 24, 512, CAMERAS, GPU, together=4)
        assert together == max(fits[-1] // 4 * 4, 4)
        used = render_bytes(LIT, fits[-1], 512, CAMERAS)
        assert used <= free or fits[-1] == 1
    assert fits[0] == 1
    assert fits == sorted(fits)
    assert fits[-1] == 24
    assert views_that_fit(LIT, 5, 512, CAMERAS, GPU) == 5
    free = 0.0  # on a CPU a result does not depend on it
    assert views_that_fit(LIT, 24, 512, CAMERAS, torch.device("cpu")) == 24
