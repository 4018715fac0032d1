"""What is behind glass is seen in the core's own pictures."""

import numpy as np
import pytest
import torch
import trimesh

from core.appearance.environment import Environment, load_light
from core.appearance.material import Material
from core.appearance.seen_through import glass_faces, render_clear
from core.appearance.shaded import UvMesh, render_shaded
from core.camera import Cameras
from core.geometry.mesh import Mesh

GLASS, RED, GREEN = 0.25, 0.75, (0.7, 0.95, 0.7)


@pytest.fixture(scope="module")
def jar() -> UvMesh:
    """A ball of glass around a red one; by u: glass at the left of the atlas."""
    outer, inner = trimesh.creation.icosphere(3, 0.8), trimesh.creation.icosphere(3, 0.3)
    verts = torch.tensor(np.concatenate([outer.vertices, inner.vertices])).float()
    faces = torch.tensor(np.concatenate([outer.faces, inner.faces + len(outer.vertices)])).long()
    uv = torch.tensor([[GLASS, 0.4], [GLASS + 0.02, 0.4], [GLASS, 0.42]])
    uv = torch.cat([uv, uv + torch.tensor([RED - GLASS, 0.0])])
    first = torch.tensor([0, 1, 2])
    own = torch.cat([first.expand(len(outer.faces), 3), first.expand(len(inner.faces), 3) + 3])
    return UvMesh.of(Mesh(verts, faces, uv, own))


def source(_points, uv) -> Material:
    red = (uv[:, :1] > 0.5).float()
    kd = red * torch.tensor([0.8, 0.05, 0.05]) + (1 - red) * torch.tensor(GREEN)
    rough = torch.full_like(red, 0.5)
    return Material(kd, rough, 0 * rough, torch.tensor([[0.0, 0.0, 1.0]]).expand(len(uv), 3))


def clear(uv):
    return (uv[:, :1] < 0.5).float()


def drawn(jar, transmission):
    light = Environment.of(load_light("studio"))
    return render_clear(jar, source, transmission, Cameras.orbit([0.0], [0.0]), 64, light)


def test_the_ball_in_the_glass_is_seen_where_it_is_and_the_ground_around_it(jar):
    seen = drawn(jar, clear)
    middle, aside = seen.srgb[0, 32, 32], seen.srgb[0, 32, 17]
    assert middle[0] > 1.4 * middle[1]  # red, though all around it is green
    assert aside[1] > aside[0]
    assert float(seen.o[0, 32, 32]) == pytest.approx(1.0, abs=1e-4)
    assert 0.1 < float(seen.o[0, 32, 17]) < 0.5  # nothing is behind it


def test_glass_is_less_clear_at_its_rim(jar):
    seen = drawn(jar, clear)
    row = seen.o[0, 32, :, 0]
    edge = int((row > 0.05).nonzero()[0])
    assert float(row[edge + 1]) > float(row[17])


def test_without_glass_it_is_the_usual_picture(jar):
    light, cameras = Environment.of(load_light("studio")), Cameras.orbit([0.0], [0.0])
    usual = render_shaded(jar, source, cameras, 64, light)
    seen = drawn(jar, None)
    assert torch.equal(seen.srgb, usual.srgb) and torch.equal(seen.o, usual.o)


def test_the_faces_of_glass_are_those_of_the_clear_texels(jar):
    outer = trimesh.creation.icosphere(3, 0.8)
    glass = glass_faces(jar, clear)
    assert glass[: len(outer.faces)].all() and not glass[len(outer.faces) :].any()


def test_a_thing_all_of_glass_shows_the_ground(jar):
    seen = drawn(jar, lambda uv: torch.ones_like(uv[:, :1]))
    assert float(seen.o[0, 32, 32]) < 0.5
