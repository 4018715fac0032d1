"""Tangents follow the uv, group by group; blender_tests compares them with Blender's own."""

import math

import numpy as np
import torch
from torch import Tensor

from core.geometry.mesh import Mesh
from core.geometry.tangents import corner_tangents, shading_normals, smooth_normals
from core.tests.texture_shapes import square, torus, torus_uv


def tangents_of(verts: Tensor, faces: Tensor, uv: Tensor, face_uvs: Tensor) -> Tensor:
    mesh = Mesh(verts, faces, uv, face_uvs)
    return corner_tangents(mesh, shading_normals(mesh).corners)


def test_a_plane_has_the_axis_of_u() -> None:
    """On the square uv = (x, z), so u grows along x; the bitangent -1·... closes to v along z."""
    verts, faces, uv, face_uvs = square()
    tangent = tangents_of(verts, faces, uv, face_uvs)
    torch.testing.assert_close(tangent, torch.tensor([1.0, 0, 0, 1]).expand(2, 3, 4))
    normal = smooth_normals(verts, faces)[0]
    torch.testing.assert_close(normal, torch.tensor([0.0, -1, 0]))
    bitangent = torch.linalg.cross(normal, tangent[0, 0, :3]) * tangent[0, 0, 3]
    torch.testing.assert_close(bitangent, torch.tensor([0.0, 0, 1]))


def test_mirrored_uv_turn_the_tangent_and_the_sign() -> None:
    verts, faces, uv, face_uvs = square()
    tangent = tangents_of(verts, faces, uv * torch.tensor([-1.0, 1]), face_uvs)
    torch.testing.assert_close(tangent, torch.tensor([-1.0, 0, 0, -1]).expand(2, 3, 4))


def test_turned_uv_turn_the_tangent() -> None:
    """u along (cos a, sin a) of the plane."""
    verts, faces, uv, face_uvs = square()
    c, s = math.cos(0.7), math.sin(0.7)
    tangent = tangents_of(verts, faces, uv @ torch.tensor([[c, -s], [s, c]]), face_uvs)
    torch.testing.assert_close(tangent, torch.tensor([c, 0, s, 1.0]).expand(2, 3, 4))


def test_across_the_normal_and_of_length_one() -> None:
    verts, faces = torus()
    normals = smooth_normals(verts, faces)
    tangent = tangents_of(verts, faces, *torus_uv())
    torch.testing.assert_close(tangent[..., :3].norm(dim=-1), torch.ones(len(faces), 3))
    assert (tangent[..., :3] * normals[faces]).sum(-1).abs().max() < 1e-6
    assert torch.equal(tangent[..., 3].abs(), torch.ones(len(faces), 3))


def slow_tangents(verts: Tensor, faces: Tensor, uv: Tensor, face_uvs: Tensor) -> np.ndarray:
    """Corner by corner: walk the fan of faces joined by edges whose uv agree on both sides."""
    normals = smooth_normals(verts, faces).double().numpy()
    p, t, f, fu = verts.double().numpy(), uv.double().numpy(), faces.numpy(), face_uvs.numpy()
    unit = lambda x: x / max(np.linalg.norm(x), 1e-30)  # noqa: E731
    edges: dict = {}
    sides = np.zeros(len(f))
    along = np.zeros((len(f), 3))
    for i in range(len(f)):
        for k in range(3):
            ends = [(f[i, c % 3], fu[i, c % 3]) for c in (k, k + 1)]
            edges[tuple(ends)] = (i, k)
        jacobian = np.stack([t[fu[i, 1]] - t[fu[i, 0]], t[fu[i, 2]] - t[fu[i, 0]]], 1)
        sides[i] = np.sign(np.linalg.det(jacobian))
        both = np.stack([p[f[i, 1]] - p[f[i, 0]], p[f[i, 2]] - p[f[i, 0]]], 1)
        along[i] = (both @ np.linalg.inv(jacobian))[:, 0]  # dp/du
    out = np.zeros((len(f), 3, 4))
    for i in range(len(f)):
        for k in range(3):
            fan, todo = {(i, k)}, [(i, k)]
            while todo:
                a, c = todo.pop()
                here = (f[a, c], fu[a, c])
                ahead, back = ((f[a, (c + d) % 3], fu[a, (c + d) % 3]) for d in (1, 2))
                for key, shift in (((ahead, here), 1), ((here, back), 0)):
                    if key in edges:
                        b, e = edges[key]
                        new = (b, (e + shift) % 3)
                        if sides[b] == sides[i] and new not in fan:
                            fan.add(new)
                            todo.append(new)
            n, total = normals[f[i, k]], np.zeros(3)
            for a, c in fan:
                at = p[f[a, c]]
                x, y = (unit((q := p[f[a, (c + d) % 3]] - at) - n * (q @ n)) for d in (1, 2))
                total += np.arccos(np.clip(x @ y, -1, 1)) * unit(along[a] - n * (along[a] @ n))
            out[i, k] = [*unit(total), sides[i]]
    return out


def test_slow_reference() -> None:
    """Seams, and a half whose uv are mirrored without a cut."""
    verts, faces = torus(10, 6)
    uv, face_uvs = torus_uv(10, 6)
    for folded in (uv, torch.stack([(uv[:, 0] - 0.5).abs(), uv[:, 1]], -1)):
        got = tangents_of(verts, faces, folded, face_uvs)
        assert (got[..., 3] < 0).any() == (folded is not uv)
        torch.testing.assert_close(
            got.double(), torch.from_numpy(slow_tangents(verts, faces, folded, face_uvs)),
            atol=1e-5, rtol=0,
        )  # fmt: skip


def test_a_seam_splits_and_a_smooth_edge_does_not() -> None:
    verts, faces = torus()
    uv, face_uvs = torus_uv()
    tangent = tangents_of(verts, faces, uv, face_uvs)
    per_uv = torch.zeros(len(uv), 4)
    per_uv[face_uvs.reshape(-1)] = tangent.reshape(-1, 4)
    assert torch.equal(per_uv[face_uvs], tangent)  # one tangent for each uv
    first, last = per_uv[: 12 + 1], per_uv[-13:]  # the two sides of the cut: same vertices
    assert (first - last).abs().max() > 1e-3


def test_faces_without_uv_area_take_their_neighbours_tangent() -> None:
    verts, faces = torus()
    uv, face_uvs = torus_uv()
    broken = face_uvs.clone()
    broken[7] = broken[7, 0]
    tangent = tangents_of(verts, faces, uv, broken)
    assert tangent.isfinite().all()
    torch.testing.assert_close(tangent[..., :3].norm(dim=-1), torch.ones(len(faces), 3))
    owner = (broken == broken[7, 0]).nonzero()
    other = owner[owner[:, 0] != 7][0]
    assert torch.equal(tangent[7, 0, :3], tangent[other[0], other[1], :3])


def test_unwelded_vertices_are_one() -> None:
    """Corners with equal position, normal and uv share a tangent whatever their indices."""
    verts, faces = torus()
    uv, face_uvs = torus_uv()
    normals = smooth_normals(verts, faces)[faces]
    want = corner_tangents(Mesh(verts, faces, uv, face_uvs), normals)
    loose = torch.arange(3 * len(faces)).view(-1, 3)
    unwelded = Mesh(verts[faces].reshape(-1, 3), loose, uv[face_uvs].reshape(-1, 2), loose)
    got = corner_tangents(unwelded, normals)
    torch.testing.assert_close(got, want)


def test_a_flat_mesh_has_its_faces_normals_and_tangents() -> None:
    """Each face by itself: as if it had no neighbours."""
    verts, faces = torus()
    uv, face_uvs = torus_uv()
    mesh = Mesh(verts, faces, uv, face_uvs, flat=True)
    found = shading_normals(mesh)
    a, b, c = verts[faces].unbind(1)
    across = torch.nn.functional.normalize(torch.linalg.cross(b - a, c - a), dim=1)
    torch.testing.assert_close(found.each, across)
    torch.testing.assert_close(found.corners, across[:, None].expand(-1, 3, -1))
    loose = torch.arange(3 * len(faces)).view(-1, 3)
    apart = Mesh(verts[faces].reshape(-1, 3), loose, uv[face_uvs].reshape(-1, 2), loose)
    alone = corner_tangents(apart, shading_normals(apart).corners)
    torch.testing.assert_close(corner_tangents(mesh, found.corners), alone)


def test_a_flat_face_without_an_area_has_a_normal() -> None:
    verts = torch.tensor([[1.0, 0, 0], [1, 0, 1], [1, 0, 2]])
    mesh = Mesh(verts, torch.tensor([[0, 1, 2]]), flat=True)
    torch.testing.assert_close(shading_normals(mesh).each.norm(dim=1), torch.ones(1))


def test_smooth_normals_do_not_depend_on_the_triangulation() -> None:
    """A cube's corner: its normal is the diagonal, however many triangles each side has there."""
    corner = torch.tensor([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 1, 1]])
    faces = torch.tensor([[0, 2, 1], [0, 1, 3], [0, 3, 4], [0, 4, 2]])  # x = 0 is cut in two
    normal = smooth_normals(corner, faces)[0]
    torch.testing.assert_close(normal, torch.full((3,), -(3**-0.5)))


def test_normals_of_loose_vertices_are_finite() -> None:
    verts, faces = torus()
    loose = torch.cat([verts, torch.zeros(1, 3), torch.ones(1, 3)])
    assert smooth_normals(loose, faces).isfinite().all()
