"""Struts between separate components: one closed solid, the strut where a mast would be."""

import math
from dataclasses import replace

import numpy as np
import pytest
import torch

from core.config import DRAFT, PAPER, STANDARD
from core.geometry.mesh import health
from core.geometry.sdf_net import SdfNet, Surface, surface
from core.geometry.struts import capsule, joined_by_struts, struts
from core.geometry.tet_grid import tet_grid
from core.stages.geometry import final_mesh

GRID = tet_grid(32)
KEEP = 0.08


def ball(x: float, radius: float) -> torch.Tensor:
    return (GRID.tet_verts - torch.tensor([x, 0.0, 0.0])).norm(dim=1) - radius


def drawn(*solids: torch.Tensor) -> Surface:
    return surface(torch.stack(solids).amin(0), GRID.tet_verts, GRID)


def test_two_balls_apart_become_one_closed_solid_of_little_more_volume():
    apart = drawn(ball(-0.5, 0.3), ball(0.5, 0.25))
    one = joined_by_struts(apart, GRID, KEEP)
    before, after = health(apart.verts, apart.faces), health(one.verts, one.faces)
    assert before["components"] == 2
    assert (after["components"], after["closed"], after["manifold"]) == (1, True, True)
    assert after["genus"] == 0
    radius = 1.5 * GRID.cell
    thickest = math.pi * radius**2 * (0.45 + 2 * radius)
    assert 0 < after["volume"] - before["volume"] < thickest


def test_what_is_in_one_component_comes_back_as_it_is():
    whole = drawn(ball(0.0, 0.5))
    assert joined_by_struts(whole, GRID, KEEP) is whole


def test_three_in_a_row_are_all_joined():
    one = joined_by_struts(drawn(ball(-0.6, 0.2), ball(0.0, 0.2), ball(0.6, 0.2)), GRID, KEEP)
    assert health(one.verts, one.faces)["components"] == 1


def test_crumbs_and_voids_get_no_strut():
    crumb = drawn(ball(-0.3, 0.5), ball(0.6, 0.1))
    assert joined_by_struts(crumb, GRID, KEEP) is crumb
    shell = surface(torch.maximum(ball(0.0, 0.6), -ball(0.0, 0.4)), GRID.tet_verts, GRID)
    assert health(shell.verts, shell.faces)["components"] == 2
    assert joined_by_struts(shell, GRID, KEEP) is shell


def test_nothing_at_all_stays_nothing():
    empty = drawn(torch.ones(len(GRID.tet_verts)))
    assert joined_by_struts(empty, GRID, KEEP) is empty


class TwoBalls(SdfNet):
    """Ψ that has learned two balls."""

    def forward(self, points: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        left, right = ((points - torch.tensor([x, 0.0, 0.0])).norm(dim=1) for x in (-0.5, 0.5))
        return torch.minimum(left, right) - 0.3, torch.zeros_like(points)


@pytest.mark.parametrize(("join", "components"), [(True, 1), (False, 2)])
def test_the_finished_mesh_is_joined_where_the_config_states_so(join, components):
    verts, faces = final_mesh(TwoBalls(GRID.cell), GRID, replace(DRAFT.geometry, join=join))
    assert health(verts, faces)["components"] == components


def test_a_sail_stands_on_the_middle_of_its_deck():
    x = np.linspace(-0.5, 0.5, 21)
    sail = np.array([[u, 0.0, 0.3 + h * (1 - 2 * abs(u))] for u in x for h in (0.0, 0.6)])
    deck = np.array([[u, v, 0.1] for u in x for v in (-0.2, 0.0, 0.2)])
    ((p, q),) = struts(sail, deck)
    np.testing.assert_allclose(p, [0, 0, 0.3], atol=0.051)
    np.testing.assert_allclose(q, [0, 0, 0.1], atol=0.051)


def test_a_handle_is_joined_where_it_ends():
    turn = np.linspace(0, np.pi, 40)
    bow = np.stack([np.cos(turn), 0 * turn, np.sin(turn)], 1)
    rim = np.stack([np.cos(2 * turn), np.sin(2 * turn), 0 * turn - 0.05], 1)
    ((p, q),) = struts(bow, rim)
    assert abs(p[2]) < 0.1
    assert np.linalg.norm(p - q) < 0.1


def test_a_back_over_a_seat_stands_on_two_posts():
    x = np.linspace(-0.5, 0.5, 41)
    back = np.array([[u, 0.4, 0.1 + h] for u in x for h in np.linspace(0, 0.5, 11)])
    seat = np.array([[u, v, 0.0] for u in x for v in np.linspace(-0.4, 0.4, 17)])
    left, right = sorted(struts(back, seat), key=lambda ends: ends[0][0])
    for x, (p, q) in zip((-0.38, 0.38), (left, right), strict=True):
        np.testing.assert_allclose(p, [x, 0.4, 0.1], atol=0.026)
        np.testing.assert_allclose(q, [p[0], 0.4, 0.0], atol=1e-6)
    # A strut that is as near in one place alone is there.
    assert len(struts(back + np.array([0, 0, 1.0]) * np.abs(back[:, :1]), seat)) == 1


def test_a_capsules_distances():
    ends = torch.tensor([[0.0, 0, 0], [1.0, 0, 0]])
    points = torch.tensor([[0.5, 0.3, 0.0], [2.0, 0, 0], [-0.5, 0, 0], [0.5, 0, 0]])
    torch.testing.assert_close(
        capsule(points, ends, 0.1), torch.tensor([0.2, 0.9, 0.4, -0.1]), atol=1e-6, rtol=0
    )
    same = capsule(points, ends[:1].expand(2, 3), 0.1)  # a segment of no length is a point
    torch.testing.assert_close(same, points.norm(dim=1) - 0.1)


@pytest.mark.parametrize(("config", "joins"), [(DRAFT, True), (STANDARD, False), (PAPER, False)])
def test_only_the_priors_own_preset_joins(config, joins):
    """Another guidance may be asked for a pair of shoes."""
    assert config.geometry.join is joins
