import math

import pytest
import torch

from core.camera import Cameras
from core.ops import dot
from core.render.antialias import edge_table
from core.render.normals import face_normals, render_normals, vertex_normals
from core.tests.meshes import sphere, torus

CAMERAS = Cameras.orbit([0.0, 120.0], [0.0, 35.0])


def test_normals_of_a_sphere_are_its_points() -> None:
    verts, faces = sphere(4)
    normal = vertex_normals(verts, faces)
    assert float((normal - verts / 0.8).norm(dim=1).max()) < 0.01


def test_face_normals_are_as_long_as_twice_the_area_and_point_out() -> None:
    verts, faces = sphere(4)
    normal = face_normals(verts, faces)
    assert float(normal.norm(dim=1).sum() / 2) == pytest.approx(4 * math.pi * 0.64, rel=0.01)
    assert (dot(normal, verts[faces].mean(1)) > 0).all()


def test_normals_are_unit_on_the_finest_mesh() -> None:
    verts, faces = sphere(2)
    fine = vertex_normals(verts * 1e-4, faces)
    assert torch.allclose(fine, vertex_normals(verts, faces), atol=1e-3)


def test_vertices_without_area_have_a_normal_and_no_gradient() -> None:
    verts = torch.zeros(4, 3, requires_grad=True)
    normal = vertex_normals(verts, torch.tensor([[0, 1, 2]]))
    assert torch.equal(normal, torch.tensor([0.0, 0, 1]).expand(4, 3))
    normal.sum().backward()
    assert torch.isfinite(verts.grad).all()


def test_picture_is_the_normal_times_coverage() -> None:
    verts, faces = sphere(4)
    n, o = render_normals(verts, faces, CAMERAS, 48)
    inside = o > 0.999
    length = n.norm(dim=-1, keepdim=True)[inside]
    assert torch.allclose(length, torch.ones_like(length), atol=1e-3)
    assert float(o.min()) >= 0
    assert float(o.max()) <= 1 + 1e-6
    assert float((n.norm(dim=-1, keepdim=True) - o).max()) < 1e-3
    # The ball's outline: an ellipse of known half-angle.
    area = math.pi * (math.tan(math.asin(0.8 / 3)) / math.tan(math.radians(20))) ** 2 / 4
    assert float(o.mean()) == pytest.approx(area, rel=0.01)


def test_object_frame_shows_the_front_as_minus_y_and_camera_frame_as_plus_z() -> None:
    verts, faces = sphere(4)
    middle = (slice(None), 23, 23)
    n, _ = render_normals(verts, faces, CAMERAS, 47)
    assert torch.allclose(n[middle], CAMERAS.back, atol=0.01)
    n, _ = render_normals(verts, faces, CAMERAS, 47, frame="camera")
    assert torch.allclose(n[middle], torch.tensor([0.0, 0, 1]).expand(2, 3), atol=0.01)
    assert float(n[0, 23, 35, 0]) > 0.3  # right is x
    assert float(n[0, 11, 23, 1]) > 0.3  # up is y


def test_frames_differ_by_the_cameras_rotation() -> None:
    verts, faces = torus()
    n, _ = render_normals(verts, faces, CAMERAS, 32)
    seen, _ = render_normals(verts, faces, CAMERAS, 32, frame="camera")
    back = torch.einsum("bji,bhwj->bhwi", CAMERAS.rotation, seen)
    assert torch.allclose(back, n, atol=1e-5)


def test_given_edges_change_nothing() -> None:
    verts, faces = torus()
    pictures = [
        render_normals(verts, faces, CAMERAS, 32, edges=edges)
        for edges in (None, edge_table(faces))
    ]
    assert torch.equal(pictures[0][0], pictures[1][0])


def test_gradient_is_finite_and_reaches_vertices_seen() -> None:
    verts, faces = torus()
    verts = verts.clone().requires_grad_()
    n, o = render_normals(verts, faces, CAMERAS, 32)
    (n.square().sum() + o.sum()).backward()
    assert torch.isfinite(verts.grad).all()
    assert float((verts.grad != 0).any(1).float().mean()) > 0.5


def test_growing_the_shape_grows_the_mask() -> None:
    """One gradient step on the mean coverage makes the shape cover more."""
    verts, faces = sphere(3)
    scale = torch.ones((), requires_grad=True)
    before = render_normals(verts * scale, faces, CAMERAS, 32)[1].mean()
    (slope,) = torch.autograd.grad(before, scale)
    after = render_normals(verts * 1.05, faces, CAMERAS, 32)[1].mean()
    assert float(slope) > 0
    assert float((after - before).detach()) == pytest.approx(0.05 * float(slope), rel=0.15)
