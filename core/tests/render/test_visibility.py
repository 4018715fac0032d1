import math

import pytest
import torch
from torch import Tensor

from core import kernels
from core.camera import Cameras
from core.render import visibility as module
from core.render.rasterizer import to_clip
from core.render.visibility import on_near_plane, to_screen, visibility
from core.tests.meshes import sphere, torus

# Askew, so that no edge of the symmetric shapes runs through pixel centres, where two
# implementations may differ.
CAMERAS = Cameras.orbit([7.0, 53.0, 201.0], [4.0, 31.0, 84.0])


@pytest.fixture(autouse=True, params=["torch", "compiled"])
def back_end(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Everything here holds for the plain torch and for its compiled version."""
    if request.param == "torch":
        monkeypatch.setattr(kernels, "supports", lambda *_: False)


def slow_reference(clip: Tensor, faces: Tensor, height: int, width: int, cull: bool) -> Tensor:
    """Every pixel against every face, homogeneous (no clipping), in float64."""
    out = torch.full((len(clip), height, width), -1)
    for b, vertices in enumerate(clip.double()):
        for row in range(height):
            for column in range(width):
                x, y = (2 * column + 1) / width - 1, 1 - (2 * row + 1) / height
                corner = vertices[faces]
                xy = corner[..., :2] - corner[..., 3:] * torch.tensor([x, y], dtype=torch.float64)
                weight = torch.linalg.cross(
                    *(torch.nn.functional.pad(xy.roll(-k, 1), (0, 1)) for k in (1, 2))
                )[..., 2]
                # Of the two signs the right one has z >= -w, w > 0 at the point that is hit.
                volume = torch.linalg.det(corner[..., [0, 1, 3]])
                bary = weight / volume[:, None]
                zw = (bary[..., None] * corner[..., 2:]).sum(1)
                depth = zw[:, 0] / zw[:, 1]
                hit = (bary >= 0).all(1) & (depth >= -1) & (zw[:, 1] > 0) & (volume != 0)
                if cull:
                    hit &= volume > 0
                if hit.any():
                    out[b, row, column] = int(torch.where(hit, depth, math.inf).argmin())
    return out


def random_soup(seed: int, count: int, size: float) -> tuple[Tensor, Tensor]:
    generator = torch.Generator().manual_seed(seed)
    middle = torch.rand(count, 1, 3, generator=generator) * 2 - 1
    verts = middle + size * torch.randn(count, 3, 3, generator=generator)
    return verts.view(-1, 3), torch.arange(3 * count).view(-1, 3)


@pytest.mark.parametrize("cull", [True, False])
@pytest.mark.parametrize(
    ("name", "mesh"),
    [("ball", sphere(2)), ("ring", torus(16, 8)), ("soup", random_soup(0, 40, 0.3))],
)
def test_equals_slow_reference(name: str, mesh: tuple[Tensor, Tensor], cull: bool) -> None:
    clip = to_clip(mesh[0], CAMERAS.mvp)
    for height, width in ((16, 16), (9, 20)):
        ours = visibility(clip, mesh[1], height, width, cull)
        theirs = slow_reference(clip, mesh[1], height, width, cull)
        assert (theirs >= 0).any()
        assert torch.equal(ours, theirs), name


@pytest.mark.parametrize("cull", [True, False])
def test_faces_that_reach_behind_the_camera_are_cut(cull: bool) -> None:
    cameras = Cameras.orbit([10.0, 130.0], [20.0, -50.0], distance=0.3)
    verts, faces = random_soup(1, 60, 0.5)
    clip = to_clip(verts, cameras.mvp)
    behind = clip[..., 2] < -clip[..., 3]
    assert set(behind[:, faces].sum(-1).unique().tolist()) == {0, 1, 2, 3}
    ours = visibility(clip, faces, 16, 16, cull)
    assert torch.equal(ours, slow_reference(clip, faces, 16, 16, cull))


def test_cut_is_the_same_from_both_neighbours() -> None:
    a, b = torch.tensor([[0.3, 0.2, 0.5, 0.7]]), torch.tensor([[1.3, -0.9, -2.0, 0.4]])
    p = on_near_plane(a, b)
    assert torch.allclose(p[:, 2], -p[:, 3], atol=1e-6)


def planar_fan(count: int, generator: torch.Generator, reach: float) -> tuple[Tensor, Tensor]:
    """A square cut into thin triangles that meet at a random point of it; all in one plane."""
    side = torch.rand(count, generator=generator).sort().values * 8
    k, t = side.div(2, rounding_mode="floor"), side % 2 - 1
    corners = [(t, -1 + 0 * t), (1 + 0 * t, t), (-t, 1 + 0 * t), (-1 + 0 * t, -t)]
    xy = torch.stack([torch.stack(c, -1) for c in corners])[k.long(), torch.arange(count)]
    xy = torch.cat([xy, torch.tensor([[-1.0, -1], [1, -1], [1, 1], [-1, 1]])])
    xy = xy[torch.atan2(xy[:, 1], xy[:, 0]).argsort()] * reach
    centre = torch.rand(1, 2, generator=generator) * 0.2
    points = torch.cat([xy, centre])
    n = len(xy)
    index = torch.arange(n)
    faces = torch.stack([torch.full((n,), n), index, (index + 1) % n], 1)
    clip = torch.cat([points, torch.zeros(n + 1, 1), torch.ones(n + 1, 1)], 1)
    return clip[None], faces


@pytest.mark.parametrize("reach", [0.7, 1.0, 500.0])
def test_shared_edges_leave_no_gap_and_hit_no_pixel_twice(reach: float) -> None:
    """Slivers and huge triangles included: every centre is drawn exactly once."""
    generator = torch.Generator().manual_seed(3)
    for _ in range(3):
        clip, faces = planar_fan(100, generator, reach)
        alone = [visibility(clip, face[None], 64, 48) >= 0 for face in faces]
        x = (torch.arange(48) + 0.5) / 24 - 1
        y = 1 - (torch.arange(64) + 0.5) / 32
        inside = (x.abs() < reach)[None] & (y.abs() < reach)[:, None]
        assert torch.equal(torch.stack(alone).sum(0)[0], inside.long())


def test_vertices_on_pixel_centres_are_hit_once() -> None:
    """The top-left rule, where rounding cannot help: a grid whose corners are the centres."""
    n = 8
    at = (torch.arange(n) + 0.5) / 4 - 1
    y, x = torch.meshgrid(at, at, indexing="ij")
    clip = torch.stack([x, y, 0 * x, 0 * x + 1], -1).view(1, -1, 4)
    i, j = torch.meshgrid(torch.arange(n - 1), torch.arange(n - 1), indexing="ij")
    a = (i * n + j).reshape(-1)
    halves = ([a, a + 1, a + n + 1], [a, a + n + 1, a + n])
    faces = torch.cat([torch.stack(half, 1) for half in halves])
    face_id = visibility(clip, faces, 8, 8)
    # Tops and lefts belong, bottoms and rights do not: 7 x 7 of the 8 x 8 centres.
    assert int((face_id >= 0).sum()) == 49
    assert (face_id[0, :7, :7] >= 0).all()


def test_at_equal_depth_the_first_face_wins() -> None:
    clip = torch.tensor([[[-1.0, -1, 0, 1], [1, -1, 0, 1], [0, 1, 0, 1]]])
    for order in ([0, 1, 2], [1, 2, 0]):
        faces = torch.tensor([order, [0, 1, 2], [2, 0, 1]])
        assert visibility(clip, faces, 9, 9).unique().tolist() == [-1, 0]


def test_culling_needs_no_open_surface_and_finds_backs_without() -> None:
    clip = torch.tensor([[[-1.0, -1, 0, 1], [1, -1, 0, 1], [0, 1, 0, 1]]])
    back = torch.tensor([[0, 2, 1]])
    assert (visibility(clip, back, 8, 8, cull=True) == -1).all()
    front = visibility(clip, back.flip(1), 8, 8, cull=True)
    assert torch.equal(visibility(clip, back, 8, 8, cull=False), front)
    assert (front >= 0).any()


@pytest.mark.parametrize("views", [0, 2])
def test_nothing_to_draw_is_all_background(views: int) -> None:
    none = visibility(torch.zeros(views, 5, 4), torch.zeros(0, 3, dtype=torch.int64), 4, 6)
    assert none.shape == (views, 4, 6)
    assert (none == -1).all()


def test_broken_vertices_draw_nothing() -> None:
    clip = torch.tensor([[[-1.0, -1, 0, 1], [1, -1, 0, 1], [0, math.nan, 0, 1], [0, 1, 0, 1]]])
    faces = torch.tensor([[0, 1, 2], [0, 1, 3]])
    assert visibility(clip, faces, 9, 9).unique().tolist() == [-1, 1]


def test_picture_does_not_depend_on_the_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    clip = to_clip(sphere(3)[0], CAMERAS.mvp)
    whole = visibility(clip, sphere(3)[1], 50, 40)
    monkeypatch.setattr(module, "CHUNK", 300)
    assert torch.equal(visibility(clip, sphere(3)[1], 50, 40), whole)


def test_screen_has_row_0_at_the_top_and_near_at_0() -> None:
    clip = torch.tensor([[-1.0, 1, -1, 1], [1, -1, 1, 1], [0, 0, 0, 2]])
    expected = torch.tensor([[0.0, 0, 0], [20, 10, 1], [10, 5, 0.5]])
    assert torch.equal(to_screen(clip, 10, 20), expected)
