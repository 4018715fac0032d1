"""Things under another, and who rides a broom."""

from dataclasses import replace

import pytest
import torch

from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.placement import Body, joined
from core.guidance.builtin.composition.placing.resting import under
from core.guidance.builtin.composition.placing.sheltering import sheltered
from core.tests.drawn_things import body, box


def table() -> Body:
    """A table: a top on four legs, of points as close as a thing's are."""
    legs = [
        box((x, y, -0.5), (x + 0.1, y + 0.1, 0.4), "table")
        for x in (-0.9, 0.8)
        for y in (-0.5, 0.4)
    ]
    whole = joined([box((-0.9, -0.5, 0.4), (0.9, 0.5, 0.5), "table"), *legs])
    verts = dense(whole)
    none = torch.zeros(0, 3, dtype=torch.long)
    return Body(whole.words, verts, none, torch.zeros(len(verts), dtype=torch.long))


def dense(one: Body) -> torch.Tensor:
    """Points all over a surface of triangles."""
    fractions = [(i / 20, j / 20, 1 - (i + j) / 20) for i in range(21) for j in range(21 - i)]
    corners = one.verts[one.faces]
    return torch.einsum("kc,fcd->fkd", torch.tensor(fractions), corners).reshape(-1, 3)


def small(side: float) -> Body:
    return box((0.0, 0.0, 0.0), (side, side, side), "crate")


def test_a_cat_is_under_the_table_on_the_ground_and_touches_a_leg():
    roof = table()
    thing = small(0.5)
    (place,) = sheltered(thing, roof, roof, 1)
    there = thing.placed(place)
    assert float(there.box[0, 2]) == pytest.approx(-0.5, abs=1e-4)
    assert float(there.box[1, 2]) < 0.42
    assert (there.box[0, :2] > roof.box[0, :2] - 0.1).all()
    assert (there.box[1, :2] < roof.box[1, :2] + 0.1).all()
    grown = there.box + torch.tensor([[-0.01] * 3, [0.01] * 3])
    assert ((roof.verts > grown[0]) & (roof.verts < grown[1])).all(1).any()


def test_what_is_too_tall_is_at_the_foot():
    roof = table()
    tall = box((0.0, 0.0, 0.0), (0.4, 0.4, 3.0), "crate")
    (place,) = sheltered(tall, roof, roof, 1)
    there = tall.placed(place)
    inner = (roof.verts > there.box[0] + 0.03) & (roof.verts < there.box[1] - 0.03)
    assert not inner.all(1).any()
    assert float(there.box[0, 2]) == pytest.approx(-0.5, abs=1e-4)


def test_several_presents_do_not_meet():
    tree, present = body("a christmas tree"), body("a gift")
    three = replace(present, words=replace(present.words, count=3))
    _, presents = arranged(tree, [("below", three)])
    boxes = [present.placed(place).box for place in presents]
    for k, one in enumerate(boxes):
        for other in boxes[:k]:
            apart = torch.maximum(one[0] - other[1], other[0] - one[1]).amax()
            assert float(apart) > -0.06 * float((one[1] - one[0]).amax())
    lows = torch.stack([one[0, 2] for one in boxes])
    assert float(lows.max() - lows.min()) < 1e-3


def test_a_broom_is_level_with_its_handle_in_front_of_who_is_on_it():
    cat, broom = body("a cat"), body("a broom")
    below = broom.placed(under(cat, broom))
    assert below.sides[1] > 3 * below.sides[[0, 2]].max()
    handle, bristles = (below.of_parts(name).mean(0) for name in ("handle", "bristles"))
    assert handle[1] < cat.box.mean(0)[1] < bristles[1]
    assert abs(float(handle[2] - cat.box[0, 2])) < 0.06
