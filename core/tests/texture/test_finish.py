"""The normal map keeps the surface from before the simplification."""

import math

import pytest
import torch
from torch import Tensor

from core.appearance.shade import perturb
from core.appearance.shaded import UvMesh
from core.geometry.mesh import Mesh
from core.geometry.tangents import smooth_normals
from core.guidance.builtin.areas import SolidAreas
from core.ops import dot, normalize
from core.tests.texture_shapes import area, one_material, torus, torus_uv
from core.texture.bake import bake
from core.texture.fine_surface import FineSurface, turned
from core.texture.finish import Finish, detail_of, in_tangent_space
from core.texture.texels import footprint

PLAIN = one_material((0.5, 0.5, 0.5))


def unit(count: int, seed: int) -> Tensor:
    return normalize(torch.randn(count, 3, generator=torch.Generator().manual_seed(seed)))


def test_the_least_turn_takes_one_direction_to_the_other_and_keeps_angles():
    start, end, one, two = (unit(100, seed) for seed in range(4))
    torch.testing.assert_close(turned(start, start, end), end, atol=1e-4, rtol=0)
    torch.testing.assert_close(
        dot(turned(one, start, end), turned(two, start, end)), dot(one, two), atol=1e-4, rtol=0
    )
    axis = normalize(torch.linalg.cross(start, end))
    torch.testing.assert_close(turned(axis, start, end), axis, atol=1e-4, rtol=0)


def test_tangent_space_is_the_inverse_of_what_the_renderer_does():
    normal = unit(200, 1)
    across = normalize(torch.linalg.cross(normal, unit(200, 2)))
    sign = torch.where(torch.arange(200)[:, None] % 2 == 0, 1.0, -1.0)
    # As interpolated: shorter than unit.
    normal, tangent = 0.9 * normal, torch.cat([0.8 * across, sign], 1)
    kn = normalize(unit(200, 3) * 0.5 + torch.tensor([0.0, 0, 1]))
    kn = kn[kn[:, 2] > 0.1]
    normal, tangent = normal[: len(kn)], tangent[: len(kn)]
    found = in_tangent_space(perturb(normal, tangent, kn), normal, tangent)
    torch.testing.assert_close(found, kn, atol=1e-4, rtol=0)


def sheet(count: int, height: float) -> Mesh:
    """A unit square of a wave z = height sin(4 π x), its uv = (x, y)."""
    i, j = torch.meshgrid(torch.arange(count + 1), torch.arange(count + 1), indexing="ij")
    x, y = i.reshape(-1) / count, j.reshape(-1) / count
    verts = torch.stack([x, y, height * torch.sin(4 * math.pi * x)], 1)
    at = lambda p, q: (p * (count + 1) + q).reshape(-1)  # noqa: E731
    p, q = i[:-1, :-1], j[:-1, :-1]
    a, b, c, d = at(p, q), at(p + 1, q), at(p + 1, q + 1), at(p, q + 1)
    faces = torch.cat([torch.stack([a, b, c], 1), torch.stack([a, c, d], 1)])
    return Mesh(verts, faces, verts[:, :2].clone(), faces.clone())


def test_a_flat_sheets_normal_map_is_the_slope_of_the_fine_one():
    """z = h sin(4 π x) has the normal (-4 π h cos(4 π x), 0, 1), up to its length."""
    height = 0.01
    flat, fine = UvMesh.of(sheet(4, 0.0)), FineSurface(sheet(200, height))
    maps = bake(flat.mesh, PLAIN, 128, finish=Finish(flat, fine))
    x = (torch.arange(128) + 0.5) / 128
    want = torch.stack([-4 * math.pi * height * torch.cos(4 * math.pi * x), 0 * x, 1 + 0 * x], 1)
    inner = slice(4, -4)
    want = normalize(want)[inner].expand(120, 120, 3)
    torch.testing.assert_close(maps.normal[inner, inner], want, atol=0.01, rtol=0)


@pytest.mark.parametrize("strength", [1.0, 0.5])
def test_a_flat_sheets_normal_map_is_the_slope_of_what_stands_out_of_it(strength):
    """As of the fine sheet, where everywhere is near a border."""
    flat, high = UvMesh.of(sheet(4, 0.0)), 0.01
    field = lambda points: (points[:, 2], torch.zeros(len(points), 2))  # noqa: E731
    wave = lambda points, _: high * torch.sin(4 * math.pi * points[:, 0])  # noqa: E731
    uneven = area()._replace(level=False)
    areas = SolidAreas(field, (uneven, uneven), heights=wave, cells=20)
    options = {"strength": strength, "size": 128, "seed": 0}
    detail = detail_of(flat, PLAIN, (areas.each[0].surface,), areas, **options)
    level, wavy = (
        bake(flat.mesh, PLAIN, 128, finish=Finish(flat, None, detail, known), areas=areas).normal
        for known in (None, areas)
    )
    x = (torch.arange(128) + 0.5) / 128
    slope = strength * 4 * math.pi * high * torch.cos(4 * math.pi * x)
    inner = slice(4, -4)  # the substance has a relief of its own, which stays
    more = (level[..., :2] / level[..., 2:] - wavy[..., :2] / wavy[..., 2:])[inner, inner]
    torch.testing.assert_close(more[..., 0], slope[inner].expand(120, 120), atol=0.01, rtol=0)
    assert more[..., 1].abs().max() < 0.01


def test_a_coarse_torus_gets_the_fine_ones_normals():
    """The same surface with 64 times the faces: the map is shown as its normals."""
    coarse = UvMesh.of(Mesh(*torus(24, 12), *torus_uv(24, 12)))
    fine = Mesh(*torus(192, 96))
    maps = bake(coarse.mesh, PLAIN, 128, finish=Finish(coarse, FineSurface(fine)))
    finish = Finish(coarse)
    middle = finish.attributes.mean(1)
    normal, tangent = middle[:, 3:6], middle[:, 6:10]
    at = coarse.uv[coarse.face_uvs].mean(1)
    row, column = ((1 - at[:, 1]) * 128).long(), (at[:, 0] * 128).long()
    shown = perturb(normal, tangent, maps.normal[row, column])
    truth_at = torch.cdist(middle[:, :3], fine.verts).argmin(1)
    truth = smooth_normals(fine.verts, fine.faces)[truth_at]
    wrong, before = ((dot(n, truth).clamp(-1, 1)).acos().mean() for n in (shown, normalize(normal)))
    assert wrong < 0.5 * before


def test_the_same_surface_gives_a_flat_map_and_a_thin_parts_other_side_none_of_its_own():
    mesh = UvMesh.of(Mesh(*torus(), *torus_uv()))
    maps = bake(mesh.mesh, PLAIN, 64, finish=Finish(mesh, FineSurface(mesh.mesh)))
    torch.testing.assert_close(
        maps.normal, torch.tensor([0.0, 0, 1]).expand(64, 64, 3), atol=0.03, rtol=0
    )
    below = sheet(8, 0.0)
    behind = FineSurface(Mesh(below.verts - torch.tensor([0.0, 0, 1e-3]), below.faces.flip(1)))
    up = torch.tensor([[0.0, 0, 1]])
    assert torch.equal(behind.normals(torch.tensor([[0.5, 0.5, 0.0]]), up), up)


def test_a_texels_side_on_the_surface():
    assert abs(footprint(UvMesh.of(sheet(4, 0.0)).mesh, 128) - 1 / 128) < 1e-6


def test_normals_turn_at_an_edge_of_the_fine_surface_and_not_before():
    corners = torch.tensor([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = torch.tensor([f for a, b, c, d in sides for f in ((a, b, c), (a, c, d))])
    points = torch.tensor([[1.0, 0.02, 0.5], [0.98, 0.0, 0.5], [0.5, 0.97, 1.0]])
    wanted = torch.tensor([[1.0, 0, 0], [0, -1, 0], [0, 0, 1]])
    found = FineSurface(Mesh(corners, faces)).normals(points, wanted)
    torch.testing.assert_close(found, wanted)
