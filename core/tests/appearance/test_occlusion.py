"""What an object hides from itself, against closed forms; Cycles in blender_tests."""

import math

import igl
import pytest
import torch
from torch import Tensor

from core.appearance import occlusion
from core.appearance.environment import Environment
from core.appearance.latlong import directions
from core.appearance.occlusion import (
    CHANNELS,
    VertexVisibility,
    clear_directions,
    harmonics,
    occluded,
    spread,
)
from core.appearance.shade import shade
from core.ops import dot, normalize
from core.tests.meshes import sphere

UP = torch.tensor([[0.0, 0, 1]])


def plate_under_a_disk(radius: float, height: float) -> tuple[Tensor, Tensor]:
    """A triangle that looks up (its corners first), and a round plate that looks down on it."""
    angle = torch.arange(400) * (2 * math.pi / 400)
    rim = torch.stack([radius * angle.cos(), radius * angle.sin(), angle * 0 + height], 1)
    low = 1e-3 * torch.tensor([[1.0, 0, 0], [-0.5, 0.8, 0], [-0.5, -0.8, 0]])
    i = 3 + torch.arange(400)
    fan = torch.stack([torch.full_like(i, 3), i.roll(1), i], 1)[2:]
    return torch.cat([low, rim]), torch.cat([torch.tensor([[0, 1, 2]]), fan])


@pytest.fixture(scope="module")
def even() -> Environment:
    return Environment.of(torch.ones(16, 32, 3))


@pytest.fixture(scope="module")
def sky() -> Environment:
    x, y, z = directions(64, 128).unbind(-1)
    return Environment.of(torch.stack([1 + z, 1 + 0.5 * x, 1 + 0.5 * y], -1))


@pytest.mark.parametrize(("radius", "height"), [(1.0, 0.5), (1.0, 1.0), (0.5, 1.0)])
def test_a_plate_closes_its_form_factor(even: Environment, radius: float, height: float) -> None:
    """R² / (R² + h²) of a small patch below a round plate's middle."""
    closed = VertexVisibility.of(*plate_under_a_disk(radius, height), 2048).occlusion(even)[:3, 3]
    assert torch.allclose(closed, torch.full((3,), radius**2 / (radius**2 + height**2)), atol=0.015)


def test_under_even_light_what_is_not_closed_comes_through(even: Environment) -> None:
    occlusion = VertexVisibility.of(*plate_under_a_disk(1.0, 0.5)).occlusion(even)[:3]
    assert torch.allclose(occlusion[:, :3], 1 - occlusion[:, 3:4].expand(-1, 3), atol=2e-3)


def test_a_ball_hides_nothing_from_itself(sky: Environment) -> None:
    occlusion = VertexVisibility.of(*sphere(3)).occlusion(sky)
    assert torch.allclose(occlusion[:, :3], torch.ones(len(occlusion), 3), atol=1e-3)
    assert float(occlusion[:, 3].max()) < 1e-3
    normal = normalize(torch.randn(50, 3, generator=torch.Generator().manual_seed(0)))
    one = torch.ones(50, 1)
    given = (normal, normal, 0.6 * one.expand(-1, 3), 0.4 * one, 0.5 * one)
    bare = shade(*given, sky)
    assert torch.allclose(shade(*given, sky, occlusion[:50]), bare, rtol=0.02)


def test_white_stays_white_in_a_hollow_under_even_light(even: Environment) -> None:
    """The furnace: what a white object hides of an even light, it gives back."""
    occlusion = VertexVisibility.of(*plate_under_a_disk(1.0, 0.5)).occlusion(even)[:3]
    change, _ = occluded(
        occlusion, UP.expand(3, 3), UP.expand(3, 3), torch.ones(3, 3), torch.ones(3, 1)
    )
    assert torch.allclose(change, torch.ones(3, 3), atol=0.01)
    dark, _ = occluded(
        occlusion, UP.expand(3, 3), UP.expand(3, 3), torch.zeros(3, 3), torch.ones(3, 1)
    )
    assert torch.allclose(dark, occlusion[:, :3])


def test_a_mirror_under_a_plate_shows_the_plate(even: Environment) -> None:
    occlusion = VertexVisibility.of(*plate_under_a_disk(1.0, 0.3), 1024).occlusion(even)[:1]
    slanted = normalize(torch.tensor([[1.0, 0, 0.25]]))
    kd, smooth = torch.full((1, 3), 0.5), torch.full((1, 1), 0.2)
    up = occluded(occlusion, UP, UP, kd, smooth)[1]
    tilted = occluded(occlusion, UP, slanted, kd, smooth)[1]
    assert float(up) < 0.1
    assert float(tilted) > 0.45  # soft, as sixteen harmonics are


def test_a_mirror_shows_the_object_in_the_objects_colour(even: Environment) -> None:
    """A metal that sees nothing but the object: kd of the light that arrives, times its own kd."""
    occlusion = torch.zeros(1, CHANNELS)
    occlusion[:, :3] = 0.4
    kd, one = torch.tensor([[0.9, 0.5, 0.2]]), torch.ones(1, 1)
    color = shade(UP, UP, kd, 0.2 * one, one, even, occlusion)
    assert torch.allclose(color, kd * 0.4 * kd, atol=0.01)


def test_a_suns_light_is_all_there_or_not(even: Environment) -> None:
    """A sun above the plate is hidden, one from the side is not."""
    mesh = plate_under_a_disk(0.5, 0.5)
    for way, seen in (((0.05, 0.02, 1.0), False), ((1.0, 0.3, 0.4), True)):
        toward = normalize(torch.tensor([way]))
        d = directions(256, 512)
        lamp = Environment.of(1e-3 + 2e4 * (d @ toward[0] > 0.9995)[..., None].expand(-1, -1, 3))
        assert len(lamp.lamps.power) > 0
        fraction = VertexVisibility.of(*mesh).occlusion(lamp)[:3, :3]
        assert bool((fraction > 0.9).all()) if seen else bool((fraction < 0.1).all())


def test_it_turns_with_the_light(sky: Environment) -> None:
    mesh = plate_under_a_disk(1.0, 0.5)
    angle = 1.1
    c, s = math.cos(angle), math.sin(angle)
    turn = torch.tensor([[c, -s, 0.0], [s, c, 0], [0, 0, 1]])
    still = VertexVisibility.of(*mesh, 1024).occlusion(sky)[:3, :3]
    both = VertexVisibility.of(mesh[0] @ turn.T, mesh[1], 1024).occlusion(sky.rotated(angle))[
        :3, :3
    ]
    assert torch.allclose(both, still, atol=0.02)


def test_harmonics_are_orthonormal() -> None:
    y = harmonics(spread(4096))
    assert torch.allclose(y.t() @ y * (4 * math.pi / 4096), torch.eye(16), atol=5e-3)


def test_directions_are_even() -> None:
    d = spread(256)
    assert torch.allclose(d.norm(dim=1), torch.ones(256), atol=1e-6)
    assert torch.allclose((d.t() @ d) / 256, torch.eye(3) / 3, atol=5e-3)
    nearest = (d @ d.t() - 2 * torch.eye(256)).amax(1).acos()
    assert float(nearest.min()) > 0.6 * math.sqrt(4 * math.pi / 256)


def test_rays_are_those_of_embree() -> None:
    trimesh = pytest.importorskip("trimesh")
    pytest.importorskip("embreex")
    balls = [sphere(3, radius=0.4)[0] + torch.tensor([x, 0.0, 0.0]) for x in (-0.45, 0.45)]
    verts, faces = torch.cat(balls), sphere(3)[1]
    faces = torch.cat([faces, faces + len(balls[0])])
    normals = normalize(torch.cat([balls[0] + torch.tensor([0.45, 0, 0]), balls[1] * 0 + 1]))
    ways = spread(64)
    free = clear_directions(verts, faces, normals, ways)
    mesh = trimesh.Trimesh(verts.numpy(), faces.numpy(), process=False)
    at, k = ((normals @ ways.t()) > 0).nonzero(as_tuple=True)
    start = verts + 2e-3 * 1.7 * normals
    hit = mesh.ray.intersects_any(start[at].numpy(), ways[k].numpy())
    assert 0.02 < hit.mean() < 0.9
    assert float((torch.from_numpy(hit) == free[at, k]).float().mean()) < 0.01
    assert bool(free[(normals @ ways.t()) <= 0].all())


def test_a_large_mesh_casts_its_rays_in_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    cast = []

    class Counted(igl.AABB):
        def intersect_ray_first(self, *given):
            cast.append(len(given[2]))
            return super().intersect_ray_first(*given)

    verts, faces = sphere(3, bump=0.3)
    whole = clear_directions(verts, faces, normalize(verts), spread(64))
    assert not whole.all()
    monkeypatch.setattr(occlusion, "CHUNK", 50)
    monkeypatch.setattr(igl, "AABB", Counted)
    assert torch.equal(clear_directions(verts, faces, normalize(verts), spread(64)), whole)
    assert max(cast) <= 50 * 64 / 2 * 1.2
    assert sum(cast) == int((normalize(verts) @ spread(64).t() > 0).sum())


def test_shading_with_shadows_has_exact_gradients(sky: Environment) -> None:
    generator = torch.Generator().manual_seed(0)
    normal = normalize(torch.randn(4, 3, generator=generator))
    view = normalize(normal + 0.4 * torch.randn(4, 3, generator=generator))
    occlusion = torch.rand(4, CHANNELS, generator=generator) * 0.2 + 0.3
    rough = torch.tensor([[0.234], [0.433], [0.567], [0.871]])
    kd, metal = torch.rand(4, 3, generator=generator), torch.rand(4, 1, generator=generator)
    open_ = occluded(occlusion, normal, view, kd, rough)[1]
    assert bool(((open_ > 0) & (open_ < 1)).any())
    assert float(dot(normal, view).min()) > 0
    given = tuple(x.double().requires_grad_() for x in (normal, view, kd, rough, metal))
    assert torch.autograd.gradcheck(
        lambda *x: shade(*x, sky, occlusion.double()), given, eps=1e-7, atol=1e-4, rtol=1e-3
    )
