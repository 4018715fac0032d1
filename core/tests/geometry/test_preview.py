"""The light mesh that is shown while the shape grows."""

import numpy as np
import pytest
import torch
import trimesh

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
    assert float((radii - 0.9).abs().max()) < 0.02
    assert signed_volume(light, fewer) == pytest.approx(signed_volume(verts, faces), rel=0.08)
    assert component_labels(fewer, len(light))[0] == 1
    assert len(fewer.sort(1).values.unique(dim=0)) == len(fewer)  # none coincides with another


def test_a_lighter_box_keeps_its_edges_and_corners():
    box = trimesh.creation.box((1.4, 1.0, 0.8))
    for _ in range(5):
        box = box.subdivide()
    verts, faces = torch.tensor(box.vertices).float(), torch.tensor(box.faces)
    light, fewer = lighter(verts, faces, len(faces) // 5)
    assert len(fewer) <= len(faces) // 5
    half = verts.amax(0)
    corners = torch.cartesian_prod(*torch.stack([-half, half], 1))
    assert float(torch.cdist(corners, light).amin(1).max()) < 0.002
    for points in (light, light[fewer].mean(1)):  # none is beyond a side, no edge is cut off
        assert float((points.abs() - half).amax(1).abs().max()) < 0.002


def test_the_file_is_read_without_pickle(tmp_path):
    verts, faces = sphere(8)
    write_shape(tmp_path / "shape.npz", verts.requires_grad_(), faces)
    with np.load(tmp_path / "shape.npz", allow_pickle=False) as file:
        assert (file["verts"].dtype, file["faces"].dtype) == (np.float32, np.int32)
        np.testing.assert_array_equal(file["verts"], verts.detach())
        np.testing.assert_array_equal(file["faces"], faces)
    assert not list(tmp_path.glob("*.tmp"))
