"""The light mesh that is shown while the shape grows."""

import numpy as np
import pytest

from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import component_labels, signed_volume
from core.geometry.tet_grid import tet_grid
from core.stages.preview import lighter, write_shape


def sphere(resolution, radius=0.9):
    grid = tet_grid(resolution)
    return marching_tets(grid.tet_verts, grid.tet_verts.norm(dim=1) - radius, grid)


def test_a_mesh_within_the_limit_is_left_as_it_is():
    verts, faces = sphere(12)
    kept = lighter(verts, faces, len(faces))
    assert kept[0] is verts
    assert kept[1] is faces


@pytest.mark.parametrize("limit", [500, 5000])
def test_a_lighter_mesh_is_the_same_shape(limit):
    verts, faces = sphere(40)
    light, fewer = lighter(verts, faces, limit)
    assert limit / 3 < len(fewer) <= limit
    assert int(fewer.max()) < len(light)
    radii = light.norm(dim=1)
    assert float(radii.max()) <= 0.901  # a mean of points of a ball lies in it
    assert float(radii.min()) > 0.85
    assert signed_volume(light, fewer) == pytest.approx(signed_volume(verts, faces), rel=0.08)
    assert component_labels(fewer, len(light))[0] == 1
    assert len(fewer.sort(1).values.unique(dim=0)) == len(fewer)  # none lies on another


def test_the_file_is_read_without_pickle(tmp_path):
    verts, faces = sphere(8)
    write_shape(tmp_path / "shape.npz", verts.requires_grad_(), faces)
    with np.load(tmp_path / "shape.npz", allow_pickle=False) as file:
        assert (file["verts"].dtype, file["faces"].dtype) == (np.float32, np.int32)
        np.testing.assert_array_equal(file["verts"], verts.detach())
        np.testing.assert_array_equal(file["faces"], faces)
    assert not list(tmp_path.glob("*.tmp"))
