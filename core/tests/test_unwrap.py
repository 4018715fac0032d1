"""The atlas: welded faces keep their places, islands their distance, failures are sentences."""

import numpy as np
import pytest
import torch
from scipy.ndimage import distance_transform_edt

from core.errors import Cancelled, UserError
from core.tests.texture_shapes import torus
from core.texture import unwrap as module
from core.texture.texels import texel_points, uv_faults
from core.texture.unwrap import PADDING, unwrap

SIZE = 256


@pytest.fixture(scope="module")
def atlas() -> tuple:
    verts, faces = torus()
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
    """No texel of one island lies in the padding of another, nor does their padding meet."""
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


def test_same_twice(atlas) -> None:
    again = unwrap(atlas[0], atlas[1], SIZE)
    assert torch.equal(again.uv, atlas[2].uv)
    assert torch.equal(again.face_uvs, atlas[2].face_uvs)


def test_budget_comes_before_the_work(monkeypatch) -> None:
    monkeypatch.setattr(module, "MAX_FACES", 100)
    with pytest.raises(UserError, match="576 faces; the unwrap takes 100") as caught:
        unwrap(*torus(), SIZE)
    assert "--max-faces" in caught.value.fix


def test_time_limit(monkeypatch, tmp_path) -> None:
    slow = tmp_path / "slow.py"
    slow.write_text("import time; time.sleep(60)")
    monkeypatch.setattr(module, "WORKER", slow)
    with pytest.raises(UserError, match="not done after 0 seconds"):
        unwrap(*torus(), SIZE, time_limit=0.3)


def test_progress_can_stop_it(monkeypatch, tmp_path) -> None:
    slow = tmp_path / "slow.py"
    slow.write_text("import time; time.sleep(60)")
    monkeypatch.setattr(module, "WORKER", slow)
    seen = []

    def progress(part: float) -> None:
        seen.append(part)
        if len(seen) == 2:
            raise Cancelled("Stopped.")

    with pytest.raises(Cancelled):
        unwrap(*torus(), SIZE, progress)
    assert 0 <= seen[0] <= seen[1] < 1


def test_a_crash_becomes_a_sentence(monkeypatch, tmp_path) -> None:
    crash = tmp_path / "crash.py"
    crash.write_text("import os; os.abort()")
    monkeypatch.setattr(module, "WORKER", crash)
    with pytest.raises(UserError, match="could not unwrap the mesh"):
        unwrap(*torus(), SIZE)


def test_nothing_to_unwrap() -> None:
    verts, faces = torus()
    with pytest.raises(UserError, match="no faces"):
        unwrap(verts, faces[:0], SIZE)
    with pytest.raises(UserError, match="not finite"):
        unwrap(verts * float("nan"), faces, SIZE)


def test_worker_starts_without_torch() -> None:
    source = module.WORKER.read_text()
    assert "import torch" not in source
    assert "from core" not in source
