import math

import pytest
import torch
from torch import Tensor

from core.camera import Cameras
from core.render.rasterizer import (
    Fragments,
    Points,
    barycentrics,
    interpolate,
    pixel_centres,
    rasterize,
    scatter,
    to_clip,
)
from core.tests.meshes import sphere, torus

CAMERAS = Cameras.orbit([20.0, 140.0], [10.0, -40.0])


def fragments_of(mesh: tuple[Tensor, Tensor], size: tuple[int, int] = (24, 30)) -> Fragments:
    return rasterize(*mesh, CAMERAS.mvp, *size)


def test_interpolated_positions_project_to_their_pixel_centres() -> None:
    verts, faces = sphere(3)
    fragments = fragments_of((verts, faces))
    points = interpolate(verts, fragments)
    clip = torch.einsum(
        "pij,pj->pi", CAMERAS.mvp[fragments.view], torch.nn.functional.pad(points, (0, 1), value=1)
    )
    centres = pixel_centres(fragments.pixel, 24, 30)
    assert torch.allclose(clip[:, :2] / clip[:, 3:], centres, atol=2e-6)
    depth = fragments.depth.view(-1)[fragments.pixel]
    assert torch.allclose(clip[:, 2] / clip[:, 3] * 0.5 + 0.5, depth, atol=1e-6)


def test_points_are_inside_their_faces_and_on_the_near_side() -> None:
    mesh = sphere(3)
    fragments = fragments_of(mesh)
    assert len(fragments.pixel) > 100
    assert torch.allclose(fragments.bary.sum(1), torch.ones(len(fragments.pixel)), atol=1e-6)
    assert float(fragments.bary.min()) > -1e-4
    points = interpolate(mesh[0], fragments)
    assert ((CAMERAS.back[fragments.view] * points).sum(1) > 0).all()


def test_fragments_follow_the_pictures_order_and_depth_is_infinite_elsewhere() -> None:
    fragments = fragments_of(torus())
    flat = fragments.face_id.view(-1)
    assert torch.equal(fragments.pixel, (flat >= 0).nonzero().squeeze(1))
    assert torch.equal(fragments.face, flat[fragments.pixel])
    assert torch.equal(fragments.view, fragments.pixel // (24 * 30))
    assert torch.equal(torch.isfinite(fragments.depth), fragments.face_id >= 0)


def test_picture_shows_right_on_the_right_and_up_at_the_top() -> None:
    """From the front (-Y), +X is on the right and +Z at the top."""
    verts = sphere(2)[0] * 0.2 + torch.tensor([0.5, 0, 0.3])
    fragments = rasterize(verts, sphere(2)[1], Cameras.orbit([0.0], [0.0]).mvp, 32, 32)
    rows, columns = (fragments.face_id[0] >= 0).nonzero(as_tuple=True)
    assert float(columns.float().mean()) > 18
    assert float(rows.float().mean()) < 14


def test_barycentrics_have_exact_gradients() -> None:
    generator = torch.Generator().manual_seed(0)
    clip = torch.randn(2, 6, 4, generator=generator, dtype=torch.float64)
    clip[..., 3] = clip[..., 3].abs() + 1
    corners = torch.tensor([[0, 1, 2], [3, 4, 5], [1, 3, 5]])
    view = torch.tensor([0, 1, 1])
    # Inside, where sliver faces are not made safe.
    centre = (clip[view[:, None], corners, :2] / clip[view[:, None], corners, 3:]).mean(1)
    column, row = ((centre * torch.tensor([1, -1]) + 1) * 128).long().unbind(1)
    pixel = view * 256 * 256 + row * 256 + column
    clip.requires_grad_()
    assert torch.autograd.gradcheck(lambda c: barycentrics(c, view, corners, pixel, 256, 256), clip)


def test_barycentrics_of_a_sliver_are_finite() -> None:
    clip = torch.tensor([[[0.0, 0, 0, 1], [1, 1, 0, 1], [2, 2, 0, 1]]], requires_grad=True)
    bary = barycentrics(
        clip, *torch.tensor([[0]]), torch.tensor([[0, 1, 2]]), *torch.tensor([[0]]), 1, 1
    )
    assert torch.allclose(bary, torch.full((1, 3), 1 / 3))
    bary.square().sum().backward()
    assert torch.isfinite(clip.grad).all()


def test_moving_the_mesh_moves_the_interpolated_point() -> None:
    """d(position seen at a pixel) / d(vertices) against finite differences of a second drawing."""
    verts, faces = (x.double() if x.is_floating_point() else x for x in sphere(2))
    mvp = CAMERAS.mvp.double()
    way = torch.sin(3 * verts + 1)
    weight = torch.cos(torch.arange(3.0, dtype=torch.float64))

    def seen(a: Tensor) -> tuple[Tensor, Tensor]:
        fragments = rasterize(verts + a * way, faces, mvp, 16, 16)
        return interpolate(verts, fragments) @ weight, fragments.face_id

    a = torch.zeros((), dtype=torch.float64, requires_grad=True)
    value, faces_seen = seen(a)
    (gradient,) = torch.autograd.grad(value.sum(), a)
    h = 1e-6
    (plus, faces_plus), (minus, faces_minus) = seen(a.detach() + h), seen(a.detach() - h)
    assert torch.equal(faces_plus, faces_seen)
    assert torch.equal(faces_minus, faces_seen)
    assert float(gradient) == pytest.approx(float((plus - minus).sum() / (2 * h)), rel=1e-4)


def test_interpolation_has_exact_gradients() -> None:
    generator = torch.Generator().manual_seed(0)
    table = torch.randn(5, 4, generator=generator, dtype=torch.float64, requires_grad=True)
    bary = torch.randn(6, 3, generator=generator, dtype=torch.float64, requires_grad=True)
    corners = torch.randint(0, 5, (6, 3), generator=generator)
    view = torch.zeros(6, dtype=torch.int64)
    assert torch.autograd.gradcheck(
        lambda t, w: interpolate(t, Points(view, corners, w)), (table, bary)
    )
    expected = (table[corners] * bary[..., None]).sum(1)
    assert torch.allclose(interpolate(table, Points(view, corners, bary)), expected)


def test_corner_attributes_equal_vertex_attributes_where_they_agree() -> None:
    verts, faces = sphere(2)
    fragments = fragments_of((verts, faces))
    by_vertex = interpolate(verts, fragments)
    assert torch.allclose(interpolate(verts[faces], fragments), by_vertex, atol=1e-6)


def test_scatter_puts_values_over_the_background() -> None:
    fragments = fragments_of(sphere(2))
    values = torch.rand(len(fragments.pixel), 3, requires_grad=True)
    seen = fragments.face_id >= 0
    for background in (0.25, torch.tensor([0.1, 0.2, 0.3]), torch.rand(2, 24, 30, 3)):
        picture = scatter(values, fragments, background)
        assert torch.equal(picture[seen], values)
        full = torch.as_tensor(background).expand(2, 24, 30, 3)
        assert torch.equal(picture[~seen], full[~seen])
    picture.sum().backward()
    assert torch.equal(values.grad, torch.ones_like(values))


def test_no_faces_is_an_empty_picture_with_gradient() -> None:
    verts = torch.zeros(3, 3, requires_grad=True)
    fragments = rasterize(verts, torch.zeros(0, 3, dtype=torch.int64), CAMERAS.mvp, 8, 8)
    picture = scatter(interpolate(verts, fragments), fragments)
    assert picture.shape == (2, 8, 8, 3)
    assert not picture.detach().any()


def test_inside_the_mesh_nothing_is_infinite() -> None:
    """A camera within the object: vertices behind it, and on its plane."""
    verts, faces = sphere(3)
    verts = verts.clone().requires_grad_()
    mvp = Cameras.orbit([0.0], [0.0], distance=0.0).mvp
    fragments = rasterize(verts, faces, mvp, 16, 16, cull=False)
    assert (fragments.face_id >= 0).all()
    points = interpolate(verts, fragments)
    assert torch.allclose(points.norm(dim=1), torch.full((256,), 0.8), atol=0.02)
    points.sum().backward()
    assert torch.isfinite(verts.grad).all()


def test_clip_is_the_matrix_product() -> None:
    verts = sphere(1)[0]
    homogeneous = torch.nn.functional.pad(verts, (0, 1), value=1)
    expected = torch.einsum("bij,vj->bvi", CAMERAS.mvp, homogeneous)
    assert torch.allclose(to_clip(verts, CAMERAS.mvp), expected, atol=1e-6)
    assert math.isclose(float(expected[0, :, 3].mean()), 3.0, rel_tol=1e-5)
