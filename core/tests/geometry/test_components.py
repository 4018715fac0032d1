"""The components of parts: where each is, and those that only one lattice joins."""

import numpy as np
import torch

from core.geometry.parts import components as components_module
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import drawn_in, places_of
from core.geometry.parts.forms import Forms
from core.geometry.tet_grid import EXTENT


def test_a_board_between_the_nodes_is_one_component_and_what_is_only_near_is_none(monkeypatch):
    monkeypatch.setattr(components_module, "SEARCH", 24)
    cell = 2 * EXTENT / 24

    def board(half):
        """It rises slowly through the lattice."""

        def at(points):
            z = points[:, 2] - 0.1 * points[:, 0]
            flat = torch.stack([points[:, 0].abs() - 0.6, points[:, 1].abs() - 0.4])
            return torch.maximum(flat.amax(0), z.abs() - half * cell)[:, None]

        return at

    assert len(list(places_of(board(0.3), 1))) == 1
    assert not list(places_of(lambda points: board(0.0)(points) + 0.1 * cell, 1))
    speck = lambda points: points.norm(dim=1, keepdim=True) - 0.5 * cell  # noqa: E731
    assert not list(places_of(speck, 1))


def boards(gap, *halves):
    """Boards side by side along x, so far apart."""

    def at(points):
        left, each = -sum(halves) - gap * (len(halves) - 1) / 2, []
        for half in halves:
            middle = points.new_tensor([left + half, 0.0, 0.0])
            away = (points - middle).abs() - points.new_tensor([half, 0.3, 0.1])
            each.append(away.clamp(min=0).norm(dim=1) + away.amax(1).clamp(max=0))
            left += 2 * half + gap
        return torch.stack(each).amin(0)[:, None]

    return at


def test_components_that_only_the_lattice_of_all_joins_are_each_drawn():
    # A goat had one horn, a windmill one of four sails: the others were dropped.
    three = boards(0.02, 0.2, 0.2, 0.2)
    (place,) = places_of(three, 1)
    components = list(drawn_in(three, place))
    assert [round(float(component.middle[0]), 2) for component in components] == [-0.42, 0.0, 0.42]
    assert [
        component.place.others(components[1].middle[None]).item() for component in components
    ] == [
        True,
        False,
        True,
    ]
    found = KnownParts(three, Forms((1.0,), ((0,), (0,), (0,)))).components
    assert [component.primitive.form for component in found] == ["box"] * 3
    for component in found:
        np.testing.assert_allclose(component.primitive.lengths[:3], (0.2, 0.3, 0.1), atol=0.01)


def test_a_crumb_next_to_two_components_is_none():
    some = boards(0.016, 0.2, 0.2, 0.03)
    (place,) = places_of(some, 1)
    assert len(list(drawn_in(some, place))) == 2
