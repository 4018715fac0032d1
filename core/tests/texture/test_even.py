"""The learnt material made even within the areas of one colour."""

import pytest
import torch

from core.appearance.material import Material
from core.appearance.shaded import UvMesh
from core.geometry.mesh import Mesh
from core.tests.texture_shapes import area, torus, torus_uv
from core.texture.even import evened

MESH = UvMesh.of(Mesh(*torus(), *torus_uv()))


class Halves:
    """Two areas: x below 0, which is plain, and x above; what is near the border moves off it."""

    each = tuple(area(plain) for plain in (True, False))

    def of(self, points):
        return (points[:, 0] > 0).long()

    def nearest(self):
        raise NotImplementedError

    certain = slope = nearest

    def inside(self, points, area):
        way = torch.where(area > 0, 0.1, -0.1)
        away = torch.where(points[:, 0].abs() < 0.1, way, points[:, 0])
        return torch.cat([away[:, None], points[:, 1:]], 1)


def learnt(points, _area=None):
    """Blotches by y; a border at x = 0 that fades; roughness and metallic by z."""
    fade = (points[:, :1] / 0.1).clamp(-1, 1)
    blotch = 0.2 * (9 * points[:, 1:2]).sin()
    kd = (0.5 + 0.2 * fade + blotch).expand(-1, 3)
    side = 0.5 + points[:, 2:]
    kn = torch.nn.functional.normalize(points, dim=1)
    return Material(kd, side, side / 2, kn)


def some():
    points = (torch.rand(500, 3, generator=torch.Generator().manual_seed(0)) - 0.5) * 1.6
    return points, points[:, 0] > 0


def even(points, evenness, material=learnt):
    return evened(material, Halves(), MESH, evenness)(points, Halves().of(points))


def test_a_plain_area_loses_what_varies_and_another_keeps_it():
    points, right = some()
    there = learnt(Halves().inside(points, right))
    all_of_it = even(points, 1.0)
    assert all_of_it.kd[~right].std(0).max() < 1e-6
    assert all_of_it.kd[~right].mean().item() == pytest.approx(0.3, abs=0.02)
    assert all_of_it.roughness[~right].std() < 1e-6 and all_of_it.metallic[~right].std() < 1e-6
    torch.testing.assert_close(all_of_it.kd[right], there.kd[right])
    torch.testing.assert_close(all_of_it.kn, there.kn)  # relief stays
    part = even(points, 0.75)
    ratio = part.kd[~right].std(0) / there.kd[~right].std(0)
    torch.testing.assert_close(ratio, torch.full((3,), 0.25), atol=1e-3, rtol=0)


def test_a_border_is_sharp_where_it_was_learnt_to_fade():
    points = torch.zeros(2, 3) + torch.tensor([[-0.001, 0.3, 0.2], [0.001, 0.3, 0.2]])
    faded, sharp = learnt(points).kd, even(points, 0.0).kd
    assert (faded[1] - faded[0]).max() < 0.01
    torch.testing.assert_close(sharp[1] - sharp[0], torch.full((3,), 0.4))


def test_what_is_learnt_is_asked_for_in_the_area_of_the_place():
    def by_area(points, area):
        return learnt(points)._replace(metallic=area[:, None].float())

    points, right = some()
    metallic = even(points, 0.5, by_area).metallic[:, 0]
    assert torch.equal(metallic, right.float())
