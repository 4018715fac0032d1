"""The maps have the material's values at every point of the surface."""

import pytest
import torch
from torch import Tensor

from core.appearance.material import Material
from core.errors import Cancelled, UserError
from core.geometry.mesh import Mesh
from core.tests.texture_shapes import area, one_material, smooth_material, square, torus, torus_uv
from core.texture import bake as module
from core.texture.bake import bake
from core.texture.texels import footprint

SIZE = 128


def torus_mesh() -> tuple[Tensor, Tensor, Tensor, Tensor]:
    return *torus(), *torus_uv()


def look_up(image: Tensor, uv: Tensor) -> Tensor:
    """Bilinear, (0, 0) at the bottom left: what Blender's Image Texture node does."""
    grid = torch.stack([2 * uv[:, 0] - 1, 1 - 2 * uv[:, 1]], -1)[None, None]
    found = torch.nn.functional.grid_sample(
        image.permute(2, 0, 1)[None], grid, align_corners=False, padding_mode="border"
    )
    return found[0, :, 0].T


def edge_points(face_uvs: Tensor) -> tuple[Tensor, Tensor]:
    """Face and weights of points on the island's border edges."""
    edges = torch.stack([face_uvs, face_uvs.roll(-1, 1)], -1).reshape(-1, 2)
    key = edges.sort(1).values
    _, index, count = key.unique(dim=0, return_inverse=True, return_counts=True)
    border = (count[index] == 1).nonzero().squeeze(1)
    face, corner = border // 3, border % 3
    weights = torch.zeros(len(border), 3)
    rows = torch.arange(len(border))
    weights[rows, corner], weights[rows, (corner + 1) % 3] = 0.3, 0.7
    return face, weights


def test_bilinear_look_up_on_island_edges_is_the_surfaces_value() -> None:
    """No background bleeds in: the error is that of half a texel of a slow material."""
    verts, faces, uv, face_uvs = torus_mesh()
    maps = bake(Mesh(verts, faces, uv, face_uvs), smooth_material, SIZE)
    face, weights = edge_points(face_uvs)
    assert len(face) > 20
    points = torch.einsum("nk,nkc->nc", weights, verts[faces[face]])
    at = torch.einsum("nk,nkc->nc", weights, uv[face_uvs[face]])
    want = smooth_material(points)
    assert (look_up(maps.base_color, at) - want.kd).abs().max() < 0.03
    orm = look_up(maps.orm, at)
    assert (orm[:, 1:2] - want.roughness).abs().max() < 0.03
    assert (orm[:, 2:3] - want.metallic).abs().max() < 0.03
    assert (look_up(maps.normal, at) - want.kn).abs().max() < 0.03


def test_inside_an_island_the_texel_is_the_value_at_its_centre() -> None:
    verts, faces, uv, face_uvs = square()
    maps = bake(Mesh(verts, faces, uv, face_uvs), smooth_material, 32)
    i = (torch.arange(32) + 0.5) / 32
    z, x = torch.meshgrid(1 - i, i, indexing="ij")
    points = torch.stack([x, torch.zeros_like(x), z], -1).reshape(-1, 3)
    want = smooth_material(points)
    torch.testing.assert_close(maps.base_color.view(-1, 3), want.kd, atol=2e-4, rtol=0)
    torch.testing.assert_close(maps.normal.view(-1, 3), want.kn, atol=2e-4, rtol=0)


def test_one_color_fills_everything() -> None:
    """Also the border texels, which islands cover in part only, keep their full value."""
    maps = bake(Mesh(*torus_mesh()), one_material((0.2, 0.5, 0.7)), SIZE)
    torch.testing.assert_close(
        maps.base_color, torch.tensor([0.2, 0.5, 0.7]).expand(SIZE, SIZE, 3), atol=1e-6, rtol=0
    )
    torch.testing.assert_close(
        maps.orm, torch.tensor([1.0, 0.3, 0.2]).expand(SIZE, SIZE, 3), atol=1e-6, rtol=0
    )
    assert torch.equal(maps.normal, torch.tensor([0.0, 0, 1]).expand(SIZE, SIZE, 3))


def test_checks_below_a_texel_are_averaged() -> None:
    """Stripes of half a texel: 4 points a texel give their mean, one point aliases."""

    def stripes(points: Tensor) -> Material:
        on = ((points[:, :1] * 64).floor() % 2).expand(-1, 3)
        ones = torch.ones_like(points[:, :1])
        return Material(on, ones, ones, torch.tensor([[0.0, 0, 1]]) * ones)

    mean = bake(Mesh(*square()), stripes, 32, samples=4).base_color
    torch.testing.assert_close(mean, torch.full_like(mean, 0.5))
    assert (bake(Mesh(*square()), stripes, 32, samples=1).base_color - 0.5).abs().min() == 0.5


def test_where_no_border_is_near_a_texel_is_asked_for_once_and_else_at_each_point() -> None:
    """Checks far finer than a texel: their mean at x < 0, one of the two colours beyond."""
    asked: list[Tensor] = []

    class Halves:
        each = (area(), area())

        def of(self, points):
            return (points[:, 0] > 0).long()

        def certain(self, points, reach):
            assert reach == pytest.approx(footprint(Mesh(*mesh[:2], **uv), 128))
            return self.of(points), points[:, 0] > 0

        def inside(self, points, _area):
            raise NotImplementedError

        nearest = slope = inside

    def checks(points: Tensor, which: Tensor | None = None) -> Material:
        assert which is None or torch.equal(which, Halves().of(points))
        asked.append(points)
        odd = (points * 4096).floor().sum(1, keepdim=True).remainder(2)
        return Material(odd.expand(-1, 3), odd, odd, torch.tensor([[0.0, 0.0, 1.0]]) + 0 * points)

    mesh = torus_mesh()
    uv = {"uv": mesh[2], "face_uvs": mesh[3]}
    whole = bake(Mesh(*mesh[:2], **uv), checks, 128)
    count = sum(len(points) for points in asked)
    asked.clear()
    maps = bake(Mesh(*mesh[:2], **uv), checks, 128, areas=Halves())
    asked_left = sum(int((points[:, 0] < 0).sum()) for points in asked)
    assert 0.55 * count < sum(len(points) for points in asked) < 0.7 * count
    assert asked_left > 0.45 * count
    between = (maps.base_color[..., 0] > 0.01) & (maps.base_color[..., 0] < 0.99)
    blurred = (whole.base_color[..., 0] > 0.01) & (whole.base_color[..., 0] < 0.99)
    assert 0.3 < between.float().mean() / blurred.float().mean() < 0.7


def test_normals_are_unit() -> None:
    maps = bake(Mesh(*torus_mesh()), smooth_material, 64)
    torch.testing.assert_close(maps.normal.norm(dim=-1), torch.ones(64, 64))


def test_chunks_change_nothing(monkeypatch) -> None:
    whole = bake(Mesh(*torus_mesh()), smooth_material, 64)[:3]
    monkeypatch.setattr(module, "CHUNK", 777)
    for a, b in zip(whole, bake(Mesh(*torus_mesh()), smooth_material, 64)[:3], strict=True):
        torch.testing.assert_close(a, b)


def test_what_glows_and_what_is_clear_is_padded_as_the_others_are() -> None:
    """Made of the base colour alone, they are it, out to the picture's corners."""

    class Glow:
        lights = True

        def __init__(self, mesh: Mesh) -> None:
            self.attributes = mesh.verts[mesh.faces]

        def __call__(self, _attributes, values, _area=None):
            return torch.cat([values, values[:, :3], values[:, :1]], 1)

    mesh = Mesh(*torus_mesh())
    maps = bake(mesh, smooth_material, 64, finish=Glow(mesh))
    assert torch.equal(maps.emission, maps.base_color)
    assert torch.equal(maps.transmission, maps.base_color[..., :1])
    assert maps.emission.min() > 0


def test_progress_grows_and_can_stop() -> None:
    seen: list[float] = []
    bake(Mesh(*torus_mesh()), smooth_material, 64, seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 1

    def stop(_: float) -> None:
        raise Cancelled("Stopped.")

    with pytest.raises(Cancelled):
        bake(Mesh(*torus_mesh()), smooth_material, 64, stop)


def test_uv_without_area_are_reported() -> None:
    verts, faces, uv, face_uvs = torus_mesh()
    with pytest.raises(UserError, match="No texel"):
        bake(Mesh(verts, faces, uv * 0 + 0.5, face_uvs), smooth_material, 64)
