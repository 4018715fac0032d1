"""Even triangles: the same surface and topology, its sharp edges kept, faces near equilateral."""

import itertools
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import torch
import trimesh

from core.config import TextureConfig
from core.geometry.faces import areas_and_normals
from core.geometry.mesh import Mesh, health
from core.geometry.parts.primitives import Primitive
from core.geometry.union import union
from core.io.job import Job
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.kernels.quadrics import add_planes, best_place
from core.stages import texturing
from core.stages.texturing import unwrap_shape
from core.tests.meshes import sphere
from core.tests.texture.test_simplify import chair  # noqa: F401  (a fixture)
from core.tests.texture_shapes import torus
from core.texture import packing
from core.texture.charts import charts
from core.texture.remesh import across_of, even, even_in_charts
from core.texture.simplify import simplify
from core.texture.texels import uv_faults
from core.texture.unwrap import at_unit_size, unwrap


def quality(verts: torch.Tensor, faces: torch.Tensor) -> np.ndarray:
    """Twice the inscribed circle's radius by the circumscribed one's; 1 is equilateral."""
    p = verts[faces].double().numpy()
    a, b, c = (np.linalg.norm(p[:, i - 1] - p[:, i - 2], axis=1) for i in range(3))
    area = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2
    return 16 * area**2 / ((a + b + c) * a * b * c)


def box(size: tuple = (1.0, 0.7, 0.3)) -> Mesh:
    """Of 12,288 uneven triangles, its sharp edges among them."""
    solid = trimesh.creation.box(size)
    for _ in range(5):
        solid = solid.subdivide()
    return Mesh(torch.tensor(solid.vertices).float(), torch.tensor(solid.faces))


@pytest.fixture(scope="module")
def evened(chair) -> Callable[[int], tuple[torch.Tensor, torch.Tensor]]:  # noqa: F811
    """The chair of even faces, of each number once."""
    return cache(lambda budget: even(Mesh(*chair), budget))


@pytest.mark.parametrize("budget", [6000, 1500, 300])
def test_topology_stays_and_faces_are_even(chair, evened, budget: int) -> None:  # noqa: F811
    before, coarse = health(*chair), simplify(*chair, budget)
    verts, faces = evened(budget)
    after = health(verts, faces)
    assert 0.85 * budget < len(faces) <= budget
    for key in ("closed", "manifold", "oriented", "genus", "components", "loose_verts"):
        assert after[key] == before[key], key
    assert after["degenerate_faces"] == 0
    # Edges as long as a leg is thick cut its corners.
    lost = 0.02 if budget > 3000 else 0.05
    assert after["volume"] == pytest.approx(before["volume"], rel=lost)
    # Of 300 faces most have a corner on a sharp edge: no more than nearly as good as simplified.
    gained = 0.1 if budget > 1000 else -0.05
    assert quality(verts, faces).mean() > quality(*coarse).mean() + gained
    assert np.percentile(quality(verts, faces), 5) > np.percentile(quality(*coarse), 5)


def test_a_ball_is_of_equilateral_triangles() -> None:
    verts, faces = even(Mesh(*sphere(5)), 4000)
    assert quality(verts, faces).mean() > 0.95
    assert np.percentile(quality(verts, faces), 5) > 0.85
    assert (verts.norm(dim=1) - sphere(5)[0].norm(dim=1).mean()).abs().max() < 2e-3


def test_of_many_faces_what_is_round_has_more():
    """A robot's antenna was a polygon, and its flat sides and sharp edges had the faces."""
    slab, ball = box((2.0, 2.0, 0.3)), sphere(5)
    round_part = 0.25 * ball[0] + torch.tensor([0.0, 0.0, 1.0])
    verts = torch.cat([slab.verts, round_part])
    faces = torch.cat([slab.faces, ball[1] + len(slab.verts)])
    verts, faces = even(Mesh(verts, faces), 12_000)
    corners = verts[faces]
    sides = torch.linalg.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    of_ball = corners[:, 0, 2] > 0.5
    area = sides.norm(dim=1)
    fraction = area[of_ball].sum() / area.sum()
    assert of_ball.float().mean() > 2.5 * fraction


@pytest.mark.parametrize("budget", [2000, 400])
def test_the_edges_of_a_box_stay_sharp(budget: int) -> None:
    """All twelve, in their whole length and in their places; the corners too."""
    shape = box()
    verts, faces = even(shape, budget)
    solid = trimesh.Trimesh(verts.numpy(), faces.numpy(), process=False)
    sharp = solid.face_adjacency_edges[np.degrees(solid.face_adjacency_angles) > 80]
    ends = solid.vertices[sharp]
    length = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum()
    assert length == pytest.approx(4 * (1.0 + 0.7 + 0.3), rel=0.02)
    assert solid.volume == pytest.approx(0.21, rel=1e-3)
    assert np.abs(solid.bounds * 2) == pytest.approx(np.array([[1.0, 0.7, 0.3]] * 2), abs=2e-3)


def test_an_open_border_stays_where_it_is() -> None:
    verts, faces = sphere(5)
    faces = faces[(verts[faces][..., 2] < 0.4).all(1)]
    new_verts, new_faces = even(Mesh(verts, faces), 1500)
    before, after = health(verts, faces), health(new_verts, new_faces)
    for key in ("manifold", "oriented", "components", "euler", "closed"):
        assert after[key] == before[key], key
    assert not after["closed"]
    rim = trimesh.Trimesh(new_verts.numpy(), new_faces.numpy(), process=False)
    ends = rim.edges[trimesh.grouping.group_rows(rim.edges_sorted, require_count=1)]
    assert rim.vertices[ends][..., 2].min() > 0.3
    assert after["area"] == pytest.approx(before["area"], rel=0.01)


def turning(verts: torch.Tensor, faces: torch.Tensor, chart: np.ndarray) -> float:
    """Mean angle in degrees between two edges that follow each other along a border."""
    f, points = faces.numpy(), verts.double().numpy()
    across = across_of(f)
    cut = chart[np.arange(f.size) // 3] != chart[across // 3]
    ends = np.stack([np.roll(f, -1, 1), np.roll(f, 1, 1)], -1).reshape(-1, 2)[cut]
    after = {}
    for a, b in ends.tolist():
        after.setdefault(a, set()).add(b)
    pairs = [(v, *near) for v, near in after.items() if len(near) == 2]
    v, a, b = np.array(pairs).T
    one, two = points[v] - points[a], points[b] - points[v]
    length = np.linalg.norm(one, axis=1) * np.linalg.norm(two, axis=1)
    return np.degrees(np.arccos(((one * two).sum(1) / length).clip(-1, 1))).mean()


def test_borders_of_charts_are_smooth() -> None:
    shape = Mesh(*sphere(5))
    verts, faces = even(shape, 6000)
    jagged = charts(at_unit_size(verts.double().numpy()), faces.numpy())
    smooth_verts, smooth_faces, chart = even_in_charts(shape, 6000)
    assert chart is not None
    assert np.array_equal(chart, jagged)
    before, after = turning(verts, faces, jagged), turning(smooth_verts, smooth_faces, chart)
    assert after < 0.6 * before
    old, new = health(verts, faces), health(smooth_verts, smooth_faces)
    for key in ("closed", "manifold", "oriented", "genus", "components", "faces"):
        assert new[key] == old[key], key
    assert quality(smooth_verts, smooth_faces).mean() > 0.75
    atlas = unwrap(smooth_verts, smooth_faces, 1024, chart=chart)
    assert uv_faults(*atlas) == []


def test_never_more_faces_than_the_shape_has() -> None:
    verts, faces = torus()
    assert len(even(Mesh(verts, faces), 20_000)[1]) <= len(faces)


def test_three_faces_on_an_edge_are_left_as_they_are() -> None:
    verts, faces = torus()
    fin = torch.cat([faces, torch.tensor([[0, 12, 30]])])
    assert even(Mesh(verts, fin), 20_000)[1] is fin


def test_same_twice(chair, evened) -> None:  # noqa: F811
    first, second = evened(1500), even(Mesh(*chair), 1500)
    assert torch.equal(first[0], second[0])
    assert torch.equal(first[1], second[1])


def test_across_is_its_own_inverse() -> None:
    _, faces = torus()
    across, f = across_of(faces.numpy()), faces.numpy().reshape(-1)
    corner = np.arange(len(across))
    assert (across[across] == corner).all()
    following = corner - corner % 3 + (corner + 1) % 3
    preceding = corner - corner % 3 + (corner + 2) % 3
    assert (f[following[across]] == f[preceding]).all()


def test_the_best_place_of_three_planes_is_their_corner() -> None:
    owner, normals = np.zeros(3, np.int64), np.eye(3)
    points = np.diag([1.0, 2.0, 3.0])
    quadric, nothing = add_planes(owner, points, normals, np.ones(3), 1)[0], np.zeros(11)
    place = np.array([1.1, 2.1, 3.1])
    best_place(quadric, nothing, place)
    # A third of the weight each, against HOLD: most of the way.
    assert np.abs(place - [1, 2, 3]).max() < 0.02
    flat = add_planes(owner[:1], points[:1], normals[:1], np.ones(1), 1)[0]
    place = np.array([1.0, 5.0, 7.0])
    best_place(flat, nothing, place)
    assert place == pytest.approx(np.array([1.0, 5.0, 7.0]))


def test_the_budget_decides_and_a_users_mesh_is_kept(
    chair,  # noqa: F811
    tmp_path,
    monkeypatch,
) -> None:
    monkeypatch.setattr(packing, "PASSES", 8)  # how well it fills is not looked at
    monkeypatch.setattr(packing, "CLOSER_PASSES", 1)
    progress = Progress(RunFolder.create(tmp_path / "run", Job(prompt="a chair")))
    shape, config = Mesh(*chair), TextureConfig(size=512, max_faces=1500)
    made = unwrap_shape(shape, config, progress)
    assert quality(made.mesh.verts, made.mesh.faces).mean() > 0.75
    assert made.fine is shape
    # The others' triangles alone are looked at.
    monkeypatch.setattr(texturing, "unwrap", lambda _, faces, *__: (torch.zeros(1, 2), faces * 0))
    uneven = unwrap_shape(shape, replace(config, even_faces=0), progress)
    assert quality(uneven.mesh.verts, uneven.mesh.faces).mean() < 0.7
    own = unwrap_shape(shape, replace(config, max_faces=20_000), progress, keep_faces=True)
    assert torch.equal(own.mesh.faces, shape.faces)
    assert own.fine is None


@pytest.mark.parametrize(
    ("max_faces", "way"), [(500, "even"), (100_000, "even"), (100_001, "fewer")]
)
def test_triangles_are_even_up_to_a_hundred_thousand(
    max_faces: int, way: str, tmp_path, monkeypatch
) -> None:
    def stop(name: str):
        def stopped(*_: object) -> None:
            raise InterruptedError(name)

        return stopped

    monkeypatch.setattr(texturing, "even_in_charts", stop("even"))
    monkeypatch.setattr(texturing, "simplify", stop("fewer"))
    progress = Progress(RunFolder.create(tmp_path / "run", Job(prompt="a chair")))
    ball = trimesh.creation.icosphere(1)
    shape = Mesh(torch.from_numpy(ball.vertices.copy()), torch.from_numpy(ball.faces.copy()))
    with pytest.raises(InterruptedError, match=way):
        unwrap_shape(shape, TextureConfig(max_faces=max_faces), progress)


def test_steps_of_a_thousandth_leave_no_slivers() -> None:
    """Boxes that nearly meet in planes: a strip between two sharp lines is not kept."""
    legs = ((-0.4748, -0.451), (0.355, -0.4511), (-0.4732, 0.334), (0.3532, 0.333))
    boxes = [((x, y, -0.6), (x + 0.12, y + 0.12, 0.02)) for x, y in legs]
    boxes += [((-0.4742, -0.452, -0.1318), (0.4747, 0.4527, 0.0))]
    boxes += [((-0.4735, 0.36, -0.128), (0.4741, 0.4541, 0.66))]
    solids = []
    for low, high in np.array(boxes):
        lengths = np.append((high - low) / 2, 0.0)
        solids.append(Primitive("box", (low + high) / 2, np.zeros(3), lengths).mesh(0.03))
    shape = Mesh(*union(solids, 0.03))
    verts, faces = even(shape, 2000)
    assert np.percentile(quality(verts, faces), 5) > 0.1  # 0.001 where they are kept
    before, after = health(shape.verts, shape.faces), health(verts, faces)
    for key in ("closed", "manifold", "oriented", "genus", "components"):
        assert after[key] == before[key], key
    assert after["volume"] == pytest.approx(before["volume"], rel=0.01)


@pytest.mark.parametrize(
    ("rows", "columns", "cell", "budget", "least"),
    # Of the second one face has no area on the way.
    [(5, 3, 0.03, 4000, -0.5), (10, 4, 0.02, 20_000, -0.8)],
)
def test_many_boxes_on_a_slab_leave_no_folds(
    rows: int, columns: int, cell: float, budget: int, least: float
) -> None:
    """A face folded back is thin, and a dark speck: all normals around it are turned."""
    boxes = [((-0.8, -0.4, -0.06), (0.8, 0.4, 0.06))]
    wide, deep = 0.5 / rows, 0.25 / columns
    for i, j in itertools.product(range(rows), range(columns)):
        x, y = -0.6 + 1.2 / (rows - 1) * i + 0.001 * j, -0.25 + 0.5 / (columns - 1) * j
        z = 0.09 + 0.001 * i
        boxes.append(((x - wide, y - deep, z - 0.06), (x + wide, y + deep, z + 0.06)))
    solids = []
    for low, high in np.array(boxes):
        lengths = np.append((high - low) / 2, 0.0)
        solids.append(Primitive("box", (low + high) / 2, np.zeros(3), lengths).mesh(cell))
    verts, faces = (x.numpy() for x in even(Mesh(*union(solids, cell)), budget))
    normal = areas_and_normals(verts, faces)[1]
    across = across_of(faces)
    turned = (normal[np.arange(faces.size) // 3] * normal[across // 3]).sum(1)
    assert turned.min() > least  # -1 where folds stay


def test_a_large_face_next_to_small_ones_is_no_fold() -> None:
    """A plate of two triangles a side, and finely meshed cones on it."""
    lengths = np.array([0.9, 0.6, 0.05, 0.0])
    solids = [Primitive("box", np.zeros(3), np.zeros(3), lengths).mesh(np.inf)]
    for x, y in itertools.product((-0.6, 0.0, 0.6), (-0.35, 0.35)):
        cone = Primitive(
            "frustum", np.array([x, y, 0.1]), np.zeros(3), np.array([0.1, 0.1, 0.05, 0])
        )
        solids.append(cone.mesh(0.008))
    shape = Mesh(*union(solids, 0.0))
    verts, faces = even(shape, 8000)
    before, after = health(shape.verts, shape.faces), health(verts, faces)
    assert after["volume"] == pytest.approx(before["volume"], rel=0.02)  # 0.78 of it was left
    assert after["area"] == pytest.approx(before["area"], rel=0.02)
