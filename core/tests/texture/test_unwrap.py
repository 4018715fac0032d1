"""The atlas: welded faces keep their places, islands their distance, failures are sentences."""

import time
from unittest import mock

import numpy as np
import pytest
import torch
import trimesh
from scipy.ndimage import distance_transform_edt

from core.benchmarks.bench_texture import shape
from core.errors import Cancelled, UserError
from core.geometry.mesh import Mesh
from core.geometry.union import union
from core.geometry.uv_health import uv_health
from core.tests.meshes import sphere
from core.tests.texture_shapes import torus
from core.texture import packing
from core.texture import unwrap as module
from core.texture.charts import charts
from core.texture.flatten import at_rest
from core.texture.packing import FEW, triangle_areas
from core.texture.simplify import simplify
from core.texture.texels import texel_points, uv_faults
from core.texture.unwrap import (
    FILL,
    PADDING,
    at_unit_size,
    flat_charts,
    overlapping,
    squashed,
    unwrap,
)

SIZE = 256


@pytest.fixture
def loose(monkeypatch) -> None:
    """How closely the charts are packed is not looked at."""
    monkeypatch.setattr(packing, "CLOSER_PASSES", 6)


@pytest.fixture(scope="module")
def atlas() -> tuple:
    verts, faces = torus()
    with mock.patch.object(packing, "CLOSER_PASSES", 6):
        return verts, faces, unwrap(verts, faces, SIZE)


def islands(face_uvs: torch.Tensor, uv_count: int) -> torch.Tensor:
    """The island of each uv."""
    island = torch.arange(uv_count)
    for _ in range(uv_count):
        low = island[face_uvs].amin(1, keepdim=True).expand(-1, 3)
        new = island.scatter_reduce(0, face_uvs.reshape(-1), low.reshape(-1), "amin")
        if torch.equal(new, island):
            break
        island = new
    return island


def test_uv_fill_the_unit_square(atlas) -> None:
    uv = atlas[2].uv
    assert uv.amin() >= 0
    assert uv.amax() <= 1
    assert (uv.amax(0) - uv.amin(0)).amin() > 0.9
    assert uv_faults(uv, atlas[2].face_uvs) == []


def test_corners_of_a_vertex_are_its_own(atlas) -> None:
    """Each uv belongs to one vertex: the mesh stays welded, only uv are split."""
    _, faces, (uv, face_uvs) = atlas
    owner = torch.full((len(uv),), -1)
    owner[face_uvs.reshape(-1)] = faces.reshape(-1)
    assert torch.equal(owner[face_uvs], faces)
    assert len(uv) > len(atlas[0])


def test_islands_keep_their_distance(atlas) -> None:
    """No texel of one island is in the padding of another, nor does their padding meet."""
    uv, face_uvs = atlas[2]
    texels = texel_points(uv, face_uvs, SIZE, 4)
    owner = torch.full((SIZE * SIZE,), -1)
    owner[texels.index] = islands(face_uvs, len(uv))[face_uvs[texels.face, 0]]
    owner = owner.view(SIZE, SIZE).numpy()
    assert len(np.unique(owner)) > 2
    for island in np.unique(owner[owner >= 0]):
        others = (owner >= 0) & (owner != island)
        gap = distance_transform_edt(~others)[owner == island].min() - 1
        assert gap >= 2 * PADDING - 1  # less the texels that both cover in part


def test_texels_are_evenly_large(atlas) -> None:
    """Area on the surface by area in the atlas is within a factor 2 of its median for 95 %."""
    verts, faces, (uv, face_uvs) = atlas
    p, t = verts[faces], uv[face_uvs]
    area = torch.linalg.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]).norm(dim=1)
    e, f = t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]
    ratio = area / (e[:, 0] * f[:, 1] - e[:, 1] * f[:, 0]).abs()
    ratio = ratio / ratio.median()
    assert ((ratio > 0.5) & (ratio < 2)).float().mean() > 0.95


def test_same_twice(atlas, loose) -> None:
    again = unwrap(atlas[0], atlas[1], SIZE)
    assert torch.equal(again.uv, atlas[2].uv)
    assert torch.equal(again.face_uvs, atlas[2].face_uvs)


def test_budget_comes_before_the_work(monkeypatch) -> None:
    monkeypatch.setattr(module, "MAX_FACES", 100)
    with pytest.raises(UserError, match="576 faces; the unwrap takes 100") as caught:
        unwrap(*torus(), SIZE)
    assert "--max-faces" in caught.value.fix


def test_progress_grows_and_can_stop_it(loose) -> None:
    seen: list[float] = []
    unwrap(*torus(), SIZE, seen.append)
    assert seen == sorted(seen)
    assert 0 <= seen[0] <= seen[-1] < 1
    assert len(seen) > 4

    def cancel(part: float) -> None:
        if part > 0.1:
            raise Cancelled("Stopped.")

    with pytest.raises(Cancelled):
        unwrap(*torus(), SIZE, cancel)


def test_nothing_to_unwrap() -> None:
    verts, faces = torus()
    with pytest.raises(UserError, match="no faces"):
        unwrap(verts, faces[:0], SIZE)
    with pytest.raises(UserError, match="not finite"):
        unwrap(verts * float("nan"), faces, SIZE)


def test_so_many_islands_that_the_gaps_fill_it(monkeypatch) -> None:
    monkeypatch.setattr(packing, "PASSES", 1)
    soup = torch.rand(900, 3, generator=torch.Generator().manual_seed(0))
    with pytest.raises(UserError, match="has 300 UV islands, and a texture of 64 texels") as caught:
        unwrap(soup, torch.arange(900).view(-1, 3), 64)
    assert "Merge" in caught.value.fix


def coiled_steps() -> tuple[torch.Tensor, torch.Tensor]:
    """A stair that winds six times: seen from above it overlaps itself."""
    angle = torch.linspace(0, 12 * torch.pi, 600)
    rails = [torch.stack([r * angle.cos(), r * angle.sin(), 0.1 * angle], 1) for r in (0.2, 1.0)]
    i = 2 * torch.arange(599)
    faces = torch.cat([torch.stack([i, i + 2, i + 1], 1), torch.stack([i + 1, i + 2, i + 3], 1)])
    return torch.stack(rails, 1).view(-1, 3), faces


def bookcase() -> tuple[torch.Tensor, torch.Tensor]:
    """Boards and books, in small faces: more corners than one chart can have."""
    boxes = [((x, 0.0, 0.9), (0.06, 0.3, 0.9)) for x in (-0.7, 0.7)]
    boxes += [((0.0, 0.0, z), (0.7, 0.3, 0.06)) for z in (0.06, 0.62, 1.18, 1.74)]
    boxes += [((0.0, 0.27, 0.9), (0.7, 0.03, 0.9))]
    for shelf in range(3):
        for book in range(4):
            tall = 0.17 + 0.02 * ((book + shelf) % 4)
            at = (-0.52 + 0.27 * book, 0.02, 0.1 + 0.56 * shelf + tall)
            boxes.append((at, (0.135, 0.24, tall)))
    made = [trimesh.creation.box(2 * np.array(half)).apply_translation(at) for at, half in boxes]
    tensors = [(torch.tensor(m.vertices), torch.tensor(m.faces)) for m in made]
    verts, faces = union(tensors, 0.0)
    return tuple(map(torch.tensor, trimesh.remesh.subdivide_to_size(verts, faces, 0.12)))


def inside_out() -> tuple[torch.Tensor, torch.Tensor]:
    """Half of the faces look inwards."""
    verts, faces = sphere(3)
    turned = torch.rand(len(faces), 1, generator=torch.Generator().manual_seed(0)) < 0.5
    return verts, torch.where(turned, faces.flip(1), faces)


@pytest.mark.parametrize(
    "mesh",
    [
        sphere(5, noise=0.02),
        coiled_steps(),
        inside_out(),
        (sphere(4)[0] * torch.tensor([1, 1, 1e-3]), sphere(4)[1]),
        (sphere(4)[0] * 1e4 + 1e5, sphere(4)[1]),
        (sphere(4)[0] * 1e-6, sphere(4)[1]),
        (torch.rand(5, 3), torch.tensor([[0, 1, 2], [0, 1, 3], [0, 1, 4]])),
    ],
    ids=["noise", "coil", "inside out", "flat", "far", "tiny", "three on an edge"],
)
def test_any_mesh_gets_a_sound_uv(mesh: tuple, monkeypatch) -> None:
    monkeypatch.setattr(packing, "PASSES", 4)  # how well it fills is not looked at
    monkeypatch.setattr(packing, "CLOSER_PASSES", 1)
    atlas = unwrap(*mesh, 1024)
    assert uv_faults(*atlas) == []
    report = uv_health(Mesh(*mesh, *atlas))
    assert report["uv_stretch"] < 1.15
    assert report["uv_flat"] == 0


def test_a_chart_is_cut_until_it_does_not_overlap_itself() -> None:
    verts, faces = bookcase()
    p, f = at_unit_size(verts.double().numpy()), faces.long().numpy()
    uv, face_uvs, chart = flat_charts(p, f, charts(p, f), lambda _: None)
    assert not overlapping(uv, face_uvs, chart).any()
    assert chart.max() < FEW


def test_faces_without_area_are_no_fault() -> None:
    needle = torch.tensor([[0.0, 0, 0], [1, 0, 0], [0.5, 1e-7, 0]])
    for verts in (needle, torch.zeros(3, 3)):
        atlas = unwrap(verts, torch.tensor([[0, 1, 2], [0, 0, 1]]), SIZE)
        assert torch.isfinite(atlas.uv).all()
        assert atlas.uv.amin() >= 0
        assert atlas.uv.amax() <= 1


def test_what_overlaps_itself_or_shrank_is_reported() -> None:
    uv = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    apart, over = np.array([[0, 1, 2], [0, 2, 3]]), np.array([[0, 1, 2], [0, 1, 3]])
    assert not overlapping(uv, apart, np.zeros(2, np.int64)).any()
    assert overlapping(uv, over, np.zeros(2, np.int64)).all()
    assert not overlapping(uv, over, np.arange(2)).any()
    down = np.array([[0, 1, 2], [0, 3, 2]])
    assert squashed(uv[down], np.array([0.5, 0.5])).tolist() == [False, True]
    assert squashed(uv[apart], np.array([0.5, 2.1])).tolist() == [False, True]


def test_a_chart_that_folds_to_a_point_is_cut_until_it_is_flat() -> None:
    # A fold of a coarse mesh, closed but for a slit: as one chart all of it is face down.
    tip = [(0.358, -0.328, 0), (0.409, -0.263, 0), (0.342, -0.304, 0.036), (0.366, -0.25, -0.079)]
    verts = np.array([*tip, (0.393, -0.285, 0)])
    faces = np.array([[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 1]])
    uv, face_uvs, chart = flat_charts(verts, faces, np.zeros(4, np.int64), lambda _: None)
    assert not squashed(uv[face_uvs], triangle_areas(at_rest(verts[faces]))).any()
    assert chart.max() > 0


@pytest.mark.slow
def test_a_large_mesh_takes_seconds_and_fills_half(monkeypatch) -> None:
    """100,000 faces as marching tetrahedra leave them, slivers and all."""
    verts, faces = simplify(*shape("chair"), 100_000)
    start = time.process_time()
    atlas = unwrap(verts, faces, 1024)
    assert time.process_time() - start < 60
    report = uv_health(Mesh(verts, faces, *atlas))
    assert report["uv_fill"] > 0.5
    assert report["uv_stretch"] < 1.05
    assert uv_faults(*atlas) == []


def crosses(count: int, steps: int = 6) -> tuple[torch.Tensor, torch.Tensor]:
    """Flat crosses, each a component: five squares of a box of nine."""
    verts, faces = [], []
    for i in range(count):
        for x, y in ((1, 0), (0, 1), (1, 1), (2, 1), (1, 2)):
            for cell in range(steps * steps):
                a, b = x + cell % steps / steps, y + cell // steps / steps
                corners = [(a, b), (a + 1 / steps, b), (a + 1 / steps, b + 1 / steps)]
                corners.append((a, b + 1 / steps))
                start = len(verts)
                verts += [(p + 4 * i, q, 0.0) for p, q in corners]
                faces += [(start, start + 1, start + 2), (start, start + 2, start + 3)]
    welded, index = np.unique(np.round(np.array(verts), 6), axis=0, return_inverse=True)
    faces = index.reshape(-1)[np.array(faces)]
    return torch.from_numpy(welded).float(), torch.from_numpy(faces)


def test_charts_that_leave_much_room_are_cut_until_they_fill_the_square(monkeypatch) -> None:
    mesh = crosses(3)
    cut = uv_health(Mesh(*mesh, *unwrap(*mesh, SIZE)))
    monkeypatch.setattr(module, "CUTS", 0)
    whole = uv_health(Mesh(*mesh, *unwrap(*mesh, SIZE)))
    assert whole["uv_fill"] < FILL
    assert cut["uv_fill"] > whole["uv_fill"] + 0.03
    assert cut["uv_islands"] > whole["uv_islands"]
    assert cut["uv_stretch"] == pytest.approx(1, abs=0.02)
