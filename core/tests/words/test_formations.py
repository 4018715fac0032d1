"""Pairs and circles of a thing: in words, and their places."""

from dataclasses import replace

import pytest
import torch

from core.guidance.builtin.composition.placing.copies import copies_of
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import box, several


@pytest.mark.parametrize(
    ("prompt", "thing", "count", "order"),
    [
        ("a pair of crossed swords", "sword", 2, "crossed"),
        ("crossed axes", "axe", 2, "crossed"),
        ("two crossed hockey sticks", "hockey stick", 2, "crossed"),
        ("two swords crossing each other", "sword", 2, "crossed"),
        ("two cats back to back", "cat", 2, "back to back"),
        ("two elephants facing away from each other", "elephant", 2, "back to back"),
        ("two cats facing each other", "cat", 2, "face to face"),
        ("two rabbits nose to nose", "rabbit", 2, "face to face"),
        ("three turtles stacked on top of each other", "turtle", 3, "stack"),
        ("five chairs in a circle", "chair", 5, "circle"),
        ("seven chairs in a circle", "chair", 7, "circle"),
        ("stones in a circle", "boulder", 6, "circle"),
        ("a circle of stones", "boulder", 6, "circle"),
        ("a ring of mushrooms", "mushroom", 6, "circle"),
        ("candles in a row", "candle", 3, "row"),
        # As before.
        ("a pile of crossed bones", "bone", 7, "heap"),
        ("three cats back to back", "cat", 3, "row"),
        ("a ring of diamonds", "ring", 1, "row"),
        ("a gold ring", "ring", 1, "row"),
        ("three stacked crates", "crate", 3, "stack"),
    ],
)
def test_an_order_is_understood(prompt: str, thing: str, count: int, order: str):
    words = parse(prompt)
    assert (words.noun, words.count, words.order) == (thing, count, order)


def ways(count: int, order: str) -> list[tuple[torch.Tensor, torch.Tensor]]:
    """Where the front of each copy of a box looks, and from where."""
    thing = box((-0.3, -0.4, -0.2), (0.3, 0.4, 0.2))
    thing = replace(thing, words=replace(thing.words, count=count, order=order))
    forward = torch.tensor([0.0, -1.0, 0.0])
    return [(at.turn @ forward, thing.placed(at).box.mean(0)) for at in copies_of(thing)]


def test_two_look_at_each_other_or_away():
    for order, sign in (("face to face", -1), ("back to back", 1)):
        for way, at in ways(2, order):
            assert sign * float(way @ at) > 0


def test_in_a_circle_they_look_at_the_middle_from_as_far():
    each = ways(5, "circle")
    away = torch.stack([at[:2].norm() for _, at in each])
    assert len(each) == 5 and float(away.std()) < 1e-4
    for way, at in each:
        assert float(way[:2] @ at[:2]) == pytest.approx(-float(at[:2].norm()), abs=1e-4)


@pytest.mark.parametrize(
    ("prompt", "count", "order"), [("a boulder", 6, "circle"), ("a cat", 2, "back to back")]
)
def test_neighbours_touch(prompt: str, count: int, order: str):
    thing, copies, _ = several(prompt, count, order)
    first, second = (place.out(thing.verts)[::4] for place in copies[:2])
    assert float(torch.cdist(first, second).min()) < 0.06 * thing.longest


@pytest.mark.parametrize("prompt", ["a sword", "an axe", "a bone"])
def test_crossed_things_lean_apart_and_do_not_pass_through_each_other(prompt: str):
    thing, copies, _ = several(prompt, 2, "crossed")
    front, back = (place.out(thing.verts) for place in copies)
    middle = torch.cat([front, back])
    middle = (middle.amin(0) + middle.amax(0)) / 2
    near = [
        one[(one - middle)[:, [0, 2]].norm(dim=1) < 0.1 * thing.longest, 1] for one in (front, back)
    ]
    # Where they cross, one is in front of the other.
    overlap = float(near[0].amax() - near[1].amin())
    assert 0 < overlap < 0.25 * float(near[0].amax() - near[0].amin())
    assert float((front.amax(0) - back.amax(0))[2].abs()) < 0.15 * thing.longest
    assert float(front[front[:, 2].argmax(), 0] * back[back[:, 2].argmax(), 0]) < 0
