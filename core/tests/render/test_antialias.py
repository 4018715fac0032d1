import math
from functools import cache

import pytest
import torch
from torch import Tensor

from core.benchmarks import ball
from core.benchmarks.bench_gradients import GradientError, gradient_error, two_balls
from core.camera import Cameras
from core.render import antialias as module
from core.render import normals as normals_module
from core.render.antialias import antialias, edge_table
from core.render.rasterizer import Fragments, rasterize, scatter
from core.tests.meshes import sphere, torus

SIZE = 32
EYE = torch.eye(4)[None]
SQUARE = (
    torch.tensor([[-0.5, -0.5, 0.0], [0.5, -0.5, 0], [0.5, 0.5, 0], [-0.5, 0.5, 0]]),
    torch.tensor([[0, 1, 2], [0, 2, 3]]),
)


def mask(fragments: Fragments, faces: Tensor, value: float = 1.0) -> Tensor:
    ones = torch.full((len(fragments.pixel), 1), value, device=faces.device)
    return antialias(scatter(ones, fragments), fragments, faces, edge_table(faces))


def turned(angle: float) -> Tensor:
    c, s = math.cos(angle), math.sin(angle)
    return SQUARE[0] @ torch.tensor([[c, s, 0.0], [-s, c, 0], [0, 0, 1]])


def test_edge_table_of_a_square() -> None:
    table = edge_table(SQUARE[1])
    pairs = zip(table.verts.tolist(), table.faces.tolist(), strict=True)
    found = {tuple(sorted(edge)): owners for edge, owners in pairs}
    first = {(0, 1): [0, -1], (1, 2): [0, -1], (0, 2): [0, 1]}
    assert found == first | {(2, 3): [1, -1], (0, 3): [1, -1]}
    inner = table.verts.sort(1).values.tolist().index([0, 2])
    assert table.opposite[inner].tolist() == [1, 3]


def test_edge_table_of_a_closed_surface_pairs_all_faces() -> None:
    faces = torus()[1]
    table = edge_table(faces)
    assert len(table.verts) == len(faces) * 3 // 2
    assert (table.faces >= 0).all()
    for k in (0, 1):
        corners = torch.cat([table.verts, table.opposite[:, k : k + 1]], 1).sort(1).values
        assert torch.equal(corners, faces[table.faces[:, k]].sort(1).values)


def test_edge_table_splits_edges_with_more_than_two_faces() -> None:
    fan = torch.tensor([[0, 1, 2], [0, 1, 3], [1, 0, 4]])
    table = edge_table(fan)
    shared = (table.verts.sort(1).values == torch.tensor([0, 1])).all(1)
    assert sorted(table.faces[shared].tolist()) == [[0, 1], [2, -1]]
    assert len(edge_table(torch.zeros(0, 3, dtype=torch.int64)).verts) == 0


def area_and_slope(angle: float) -> tuple[float, float]:
    """Covered area, and its derivative as the square moves along and grows; NDC."""
    a = torch.zeros((), requires_grad=True)
    verts = turned(angle) * (1 + a) + torch.tensor([0.013, 0.007, 0])
    fragments = rasterize(verts, SQUARE[1], EYE, SIZE, SIZE)
    area = mask(fragments, SQUARE[1]).sum() * (2 / SIZE) ** 2
    return float(area.detach()), float(torch.autograd.grad(area, a)[0])


# A multiple of no pixel; along an axis, diagonal, and between.
@pytest.mark.parametrize("angle_deg", [0.0, 13.0, 30.0, 45.0, 77.0])
def test_growing_square_gains_its_perimeter(angle_deg: float) -> None:
    """d(area) / d(scale) = 2 area = 2; up to the corners' pixels."""
    area, slope = area_and_slope(math.radians(angle_deg))
    assert area == pytest.approx(1, abs=0.01)
    assert slope == pytest.approx(2, rel=0.04)


def test_without_the_axis_weight_slanted_edges_count_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    original = module.crossings

    def unweighted(*arguments):
        found = original(*arguments)
        return found._replace(weight=torch.ones_like(found.weight))

    monkeypatch.setattr(module, "crossings", unweighted)
    assert area_and_slope(math.radians(45))[1] == pytest.approx(4, rel=0.08)


def test_blend_is_linear_in_the_crossing_and_continuous() -> None:
    """A straight vertical edge that wanders over three pixels: the coverage is its place."""
    # Not quite on a pixel's centre, which either side may own.
    for place in torch.linspace(10.01, 13.01, 31).tolist():
        x = place / SIZE * 2 - 1
        verts = torch.tensor([[-2.0, -2, 0], [x, -2, 0], [x, 2, 0], [-2, 2, 0]])
        fragments = rasterize(verts, SQUARE[1], EYE, SIZE, SIZE)
        row = mask(fragments, SQUARE[1])[0, 16, :, 0]
        assert float(row.sum()) == pytest.approx(place, abs=1e-4)
        assert float(row.min()) >= 0
        assert float(row.max()) <= 1


def test_any_number_of_channels_and_a_background_blend_the_same() -> None:
    verts, faces = sphere(2)
    cameras = Cameras.orbit([5.0, 95.0], [10.0, 20.0])
    fragments = rasterize(verts, faces, cameras.mvp, 20, 28)
    o = mask(fragments, faces)
    color, background = torch.rand(7), torch.rand(7)
    image = scatter(color.expand(len(fragments.pixel), 7), fragments, background)
    out = antialias(image, fragments, faces, edge_table(faces))
    assert torch.allclose(out, background + o * (color - background), atol=1e-5)


def test_a_hidden_silhouette_blends_nothing() -> None:
    """A small square behind a large one leaves the picture as it is; before it, it does not."""
    faces = torch.cat([SQUARE[1], SQUARE[1] + 4])
    for depth, changes in ((0.5, False), (-0.5, True)):
        verts = torch.cat([SQUARE[0] * 1.5, SQUARE[0] * 0.41 + torch.tensor([0.02, 0.01, depth])])
        fragments = rasterize(verts, faces, EYE, SIZE, SIZE)
        color = (fragments.face >= 2).float()[:, None]
        image = scatter(color, fragments)
        out = antialias(image, fragments, faces, edge_table(faces))
        assert bool((out != image).any()) == changes


def test_gradient_reaches_the_image_through_the_blend() -> None:
    verts, faces = sphere(2)
    fragments = rasterize(verts, faces, Cameras.orbit([5.0], [10.0]).mvp, 8, 8)
    table = edge_table(faces)
    image = torch.rand(1, 8, 8, 1, dtype=torch.float64, requires_grad=True)
    assert torch.autograd.gradcheck(lambda x: antialias(x, fragments, faces, table), image)


def test_edges_behind_the_camera_are_left_out() -> None:
    verts, faces = sphere(3)
    verts = verts.clone().requires_grad_()
    mvp = Cameras.orbit([0.0], [0.0], distance=0.85).mvp
    fragments = rasterize(verts, faces, mvp, 16, 16, cull=False)
    out = mask(fragments, faces)
    out.sum().backward()
    assert torch.isfinite(out).all()
    assert torch.isfinite(verts.grad).all()


def test_open_surface_has_a_rim_from_both_sides() -> None:
    for angle in (0.0, math.pi):  # from the front, from behind
        c, s = math.cos(angle), math.sin(angle)
        verts = turned(0.3) @ torch.tensor([[c, 0.0, s], [0, 1, 0], [-s, 0, c]])
        fragments = rasterize(verts, SQUARE[1], EYE, SIZE, SIZE, cull=False)
        area = float(mask(fragments, SQUARE[1]).sum()) * (2 / SIZE) ** 2
        assert area == pytest.approx(1, abs=0.01)


# ---- through the whole renderer, against hard pictures of many times the resolution ----

# Turned, as finite differences of hard pictures are poor where edges follow the grid.
TURN = Cameras.orbit([25.0], [35.0]).rotation[0]
SHAPES = {
    "smooth ball": sphere(4),
    "rough ball": sphere(5, bump=0.12, noise=0.0015),
    "ring": (torus(96, 48)[0] @ TURN, torus(96, 48)[1]),
}


@cache
def found(name: str) -> GradientError:
    return gradient_error(*SHAPES[name], size=64, fine=1024)


@pytest.mark.parametrize("name", SHAPES)
def test_gradient_has_slope_1(name: str) -> None:
    outline, normals, interior = vars(found(name)).values()
    assert outline.slope == pytest.approx(1, abs=0.02)
    assert outline.error < 0.02
    assert normals.slope == pytest.approx(1, abs=0.02)
    assert interior.slope == pytest.approx(1, abs=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("size", [64, 512])
@pytest.mark.parametrize("faces", [5_000, 20_000, 80_000])
def test_gradient_at_any_fineness(faces: int, size: int) -> None:
    for bump in (0.0, 0.05):
        verts, triangles = ball(faces, bump)
        result = gradient_error(verts @ TURN, triangles, size, places=max(1600 // size, 5))
        assert result.outline.slope == pytest.approx(1, abs=0.02)
        assert result.outline.error < 0.02
        if size == 512:  # at 64² the waves' own folds are as small as a pixel
            assert result.normals.slope == pytest.approx(1, abs=0.02)
            assert max(result.normals.error, result.interior.error) < 0.02


@pytest.mark.slow
def test_gradient_of_a_body_before_another() -> None:
    verts, faces = two_balls()
    result = gradient_error(verts @ TURN, faces, 512)
    assert result.outline.slope == pytest.approx(1, abs=0.02)
    assert result.normals.slope == pytest.approx(1, abs=0.02)
    assert max(result.outline.error, result.normals.error) < 0.02


def test_without_the_outermost_rule_folds_count_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "outermost", lambda *given: given[2].nonzero().squeeze(1))
    assert gradient_error(*SHAPES["rough ball"], size=64, fine=1024).outline.slope > 1.08


def test_without_the_rim_normals_change_in_jumps(monkeypatch: pytest.MonkeyPatch) -> None:
    original = module.antialias
    monkeypatch.setattr(normals_module, "antialias", lambda *given, **_: original(*given))
    assert gradient_error(*SHAPES["smooth ball"], size=64, fine=1024).normals.slope > 1.05
