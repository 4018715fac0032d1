"""Several of a thing: rows, heaps, stacks, bunches."""

from dataclasses import replace

import pytest
import torch

from core.guidance.builtin.composition.arranged import arranged
from core.guidance.builtin.composition.resting import (
    upon,
)
from core.tests.drawn_things import body, several


def test_a_row_is_side_by_side_and_touches():
    one, copies, row = several("a boot", 2, "row")
    assert len(copies) == 2 and 1.9 < float(row.sides[0] / one.sides[0]) < 2
    assert float(row.sides[2]) == pytest.approx(float(one.sides[2]))
    assert row.usual == pytest.approx(one.usual * float(row.longest / one.longest))


def test_coins_are_stacked_flat_and_plates_in_one_another():
    coin, _, stack = several("a coin", 5, "stack")
    thick = float(coin.sides[:2].min())
    assert float(stack.sides[2]) == pytest.approx(5 * thick, rel=0.15)
    plate, _, plates = several("a plate", 5, "stack")
    assert float(plates.sides[2]) < 4 * float(plate.sides[2])


def test_a_heap_is_higher_than_one_and_stands_on_the_ground():
    one, copies, heap = several("a pumpkin", 7, "heap")
    assert len(copies) == 7 and float(heap.sides[2]) > 1.3 * float(one.sides[2])
    assert float(heap.sides[0]) > 1.5 * float(one.sides[0])
    lowest = [float(place.out(one.verts)[:, 2].min()) for place in copies]
    assert sum(low < 0.05 for low in lowest) >= 3  # on the ground, the others on them
    shifts = torch.stack([place.shift for place in copies])
    assert float(torch.pdist(shifts).min()) > 0.4 * float(one.sides[:2].min())


def test_bottles_in_a_heap_lie():
    one, copies, _ = several("a bottle", 4, "heap")
    for place in copies:
        sides = one.placed(place).sides
        assert float(sides[2]) < float(sides[:2].max())


def test_flowers_in_a_bunch_lean_apart_with_their_stems_together():
    one, copies, bunch = several("a tulip", 3, "heap")
    feet = torch.stack(
        [place.out(torch.tensor([[0, 0, float(one.box[0, 2])]])) for place in copies]
    )
    assert float(feet.std(0).max()) < 1e-3
    assert float(bunch.sides[:2].max()) > 1.2 * float(one.sides[:2].max())


def test_apples_fill_a_basket_to_above_its_rim():
    basket = body("a basket")
    _, _, heap = several("an apple", 6, "heap")
    there = heap.placed(upon(heap, basket))
    rim = float(basket.without("handle", "handles")[:, 2].max())
    assert float(there.box[0, 2]) < rim < float(there.box[1, 2])
    assert (there.sides[:2] < basket.sides[:2]).all()


def test_eggs_in_a_basket_lie_in_it_as_they_come():
    eggs = replace(body("an egg"), words=replace(body("an egg").words, count=5))
    places, (basket,) = arranged(eggs, [("in", body("a basket"))])
    there = body("a basket").placed(basket)
    rim = float(there.without("handle", "handles")[:, 2].max())
    points = torch.cat([place.out(eggs.verts) for place in places])
    assert float(points[:, 2].min()) < rim < float(points[:, 2].max())
    assert (points[:, :2].amax(0) < there.box[1, :2]).all()
