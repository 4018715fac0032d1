"""Several of a thing: rows, heaps, stacks, bunches."""

from dataclasses import replace

import pytest
import torch

from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.bunches import TOGETHER, bunched
from core.guidance.builtin.composition.placing.resting import (
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
    one, copies, bunch = several("a tulip", 5, "heap")
    foot = torch.stack([*one.verts[one.verts[:, 2] < -0.7][:, :2].mean(0), one.box[0, 2]])
    feet = torch.stack([place.out(foot[None])[0] for place in copies])
    stems = torch.stack([place.turn[:, 2] for place in copies])
    low = one.box[0, 2] + TOGETHER * one.sides[2]
    to = torch.stack([foot[0] * 0, foot[1] * 0, low]) - feet
    off = (to - (to * stems).sum(1, keepdim=True) * stems).norm(dim=1)
    assert float(off.max()) < 0.05  # all of them go through one point
    assert float(bunch.sides[:2].max()) > 1.5 * float(one.sides[:2].max())
    tops = torch.stack([place.out(one.verts)[:, 2].max() for place in copies])
    assert float(tops.max() - tops.min()) > 0.15 * float(one.sides[2])  # some are higher


def test_kinds_of_flowers_are_in_one_bunch_in_turn():
    tulips, daisies = (
        replace(one, words=replace(one.words, count=3, order="heap"))
        for one in (body("a tulip"), body("a flower"))
    )
    first, second = bunched([tulips, daisies])
    tops = torch.stack([p.out(torch.zeros(1, 3))[0] for p in (*first, *second)])
    assert (len(first), len(second)) == (3, 3) and float(torch.pdist(tops).min()) > 0.1


def test_a_vase_has_its_mouth_where_the_stems_cross():
    flowers = replace(body("a tulip"), words=replace(body("a tulip").words, count=5, order="heap"))
    places, (vase,) = arranged(flowers, [("in", body("a vase"))])
    there = body("a vase").placed(vase)
    heads = torch.cat([place.out(flowers.verts) for place in places])
    rim = float(there.box[1, 2])
    assert float(heads[:, 2].min()) < rim < float(heads[:, 2].quantile(0.4))
    assert float(there.sides[2]) > 0.4 * float(heads[:, 2].max() - heads[:, 2].min())


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
