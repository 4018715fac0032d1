"""What a prompt lists with a thing: "a desk with a lamp, a laptop and a mug"."""

import pytest
import torch

from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.copies import mixed_heap
from core.guidance.builtin.words.companions.gathering import in_a_row, turned
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import body, box, several


def with_it(prompt: str) -> tuple[str, list[str]]:
    """The thing, and what goes with it, as "bears 2 red candle"."""
    words = parse(prompt)
    return str(words), [
        f"{one.relation} {f'{one.words.count} ' * (one.words.count > 1)}{one.words}"
        for one in words.companions
    ]


@pytest.mark.parametrize(
    ("prompt", "thing", "others"),
    [
        ("a table with a vase", "table", ["bears vase"]),
        (
            "a desk with a red lamp, a laptop and a mug on it",
            "desk",
            ["bears red lamp", "bears laptop", "bears mug"],
        ),
        ("a nightstand with a lamp and a clock", "nightstand", ["bears lamp", "bears alarm clock"]),
        (
            "a desk with a computer, keyboard and mouse",
            "desk",
            ["bears desktop computer", "bears keyboard", "bears computer mouse"],
        ),
        ("a red table with four legs and a blue vase", "red table", ["bears blue vase"]),
        ("a table with two candles", "table", ["bears 2 candle"]),
        ("a stove with a pot and a pan", "stove", ["bears cooking pot", "bears pan"]),
        (
            "a desk with a lamp and a stack of books, low poly",
            "desk",
            ["bears lamp", "bears stack of books"],
        ),
        ("a lamp and a mug on a wooden desk", "wooden desk", ["bears lamp", "bears mug"]),
        ("a tray with three cups", "plate", ["bears 3 mug"]),
        ("a bowl of fruit", "bowl", ["bears 4 apple", "bears 4 orange fruit", "bears 4 banana"]),
        ("a fruit basket", "basket", ["bears 4 apple", "bears 4 orange fruit", "bears 4 banana"]),
        ("a bowl of fruit with apples and pears", "bowl", ["bears 5 apple", "bears 5 pear"]),
        ("a crate of apples and oranges", "crate", ["bears 5 apple", "bears 5 orange fruit"]),
        ("a basket with bread and cheese", "basket", ["bears bread", "bears cheese"]),
        ("a wagon full of hay", "wagon", ["bears hay bale"]),
        ("an apple and a pear in a bowl", "bowl", ["bears apple", "bears pear"]),
        ("a mug with a spoon", "mug", ["bears spoon"]),
        ("a bathtub with a rubber duck in it", "bathtub", ["bears rubber duck"]),
        ("a cup of tea with a cookie", "teacup", ["beside cookie"]),
        ("a house with a tree", "house", ["beside tree"]),
        ("an anvil with a hammer leaning against it", "anvil", ["beside hammer"]),
        ("a tent with a campfire and a log", "tent", ["beside campfire", "beside log"]),
        ("a tree with an owl", "tree", ["bears owl"]),
        ("a table with two chairs", "table", ["beside chair", "beside chair"]),
        ("a table with four chairs", "table", ["beside 2 chair", "beside 2 chair"]),
        ("a table with a chair on each side", "table", ["beside chair", "beside chair"]),
        ("a chair next to a table with a lamp on it", "table", ["bears lamp", "beside chair"]),
        ("a fork, a knife and a spoon", "fork", ["beside knife", "beside spoon"]),
        (
            "an apple, a banana and a pear on a plate",
            "plate",
            ["bears apple", "bears banana", "bears pear"],
        ),
        ("a campfire w/ a pot and a wolf", "campfire", ["bears cooking pot", "beside wolf"]),
        ("a table with apples and a vase", "table", ["bears 7 apple", "bears vase"]),
        ("a table with potions", "table", ["bears 3 potion"]),
        ("a cake topped with strawberries", "cake", ["bears 7 strawberry"]),
        (
            "a desk: a book, crystal ball and potion",
            "desk",
            ["bears book", "bears crystal ball", "bears potion"],
        ),
        ("a shelf holding a bottle and a fern", "shelf", ["bears bottle", "bears fern"]),
        (
            "an altar surrounded by a skeleton and a chest",
            "table",
            ["beside skeleton", "beside chest"],
        ),
        ("a box of apples and oranges", "cardboard box", ["bears 5 apple", "bears 5 orange fruit"]),
        ("a desk with a lamp in red and a mug", "desk", ["bears red lamp", "bears mug"]),
        ("a desk with laptop, lamp and mug", "desk", ["bears laptop", "bears lamp", "bears mug"]),
        ("a piano with a stool", "piano", ["beside stool"]),
        ("a keyboard and a mouse on a desk", "desk", ["bears keyboard", "bears computer mouse"]),
        ("a cactus with a scarf around it", "cactus", ["wears scarf"]),
        ("an island with a tree and a pagoda", "island", ["bears tree", "bears pagoda"]),
        (
            "a well with a bucket and a crow sitting on the edge",
            "well",
            ["beside bucket", "bears black bird"],
        ),
        ("a rocking chair with a cat curled up on the seat", "rocking chair", ["bears cat"]),
        ("a pirate ship with a parrot on the mast", "pirate ship", ["bears parrot"]),
        (
            "a game console with two controllers",
            "game console",
            ["beside game controller", "beside game controller"],
        ),
        (
            "a table with a vase, a mug with hearts and two chairs",
            "table",
            ["bears vase", "bears mug", "beside chair", "beside chair"],
        ),
        ("a table with a lamp with a red shade and a book", "table", ["bears lamp", "bears book"]),
        (
            "a bench with a candle melted over a skull and a mug",
            "bench",
            ["bears candle", "bears mug"],
        ),
    ],
)
def test_what_is_listed_has_its_place(prompt, thing, others):
    assert with_it(prompt) == (thing, others)
    assert not any("one thing is made" in note for note in parse(prompt).notes)


@pytest.mark.parametrize(
    "prompt",
    [
        "a table with a glass top",
        "a desk with three drawers",
        "a bed with two pillows",
        "a table with dragon legs",
        "a table with a flower pattern",
        "a mug with a cat",
        "a mug with strawberries",
        "a crate with a skull",
        "a castle with a tower",
        "a car with a spoiler",
        "a house with a red roof and a door",
        "a bowl of ramen with an egg",
        "a plate with a fried egg",
        "a boat with a flag",
        "a boat with a cabin",
        "a rug with a tiger",
        "a mug with a cat on its side",
        "an axe with a dragon on the blade",
        "a pumpkin carved with a scary face and a candle inside",
        "a cauldron with green potion inside",
        "a cake with no strawberries",
        "a table with no apples",
        "an empty fruit bowl",
        "a monkey with fruit",
    ],
)
def test_a_part_or_a_print_is_no_other_thing(prompt):
    assert parse(prompt).companions == ()


def test_what_is_said_of_one_of_a_list_is_of_that():
    table = parse("a table with a lamp with a red shade and a mug with hearts")
    lamp, mug = (one.words for one in table.companions)
    assert lamp == parse("a lamp with a red shade")
    assert [str(one) for one in mug.emblems] == ["hearts"]
    assert not table.emblems and not table.accents
    _, others = with_it("a table with a basket of apples and oranges and a vase")
    assert others == ["bears basket", "bears vase"]


def test_what_is_said_of_one_and_not_made_is_left_out():
    words = parse("a table with a candle melted over a skull and a mug")
    assert {"melted", "skull"} <= set(words.left_out)


@pytest.mark.parametrize(
    "prompt",
    [
        "a fierce dragon, a golden crown and a purple cape with stars " * 8,
        "a table with " + "a red lamp, " * 60 + "and a mug",
        "a " + "b" * 400 + ", a " + "c d " * 100 + "and a mug with a lid",
        "a cozy cottage, a winding path and a wooden fence at sunset",
        "some colourful mushrooms, a log and a few stones in the style of a cartoon",
    ],
)
def test_a_list_is_read_or_not_without_trying_all_ways(prompt):
    """A word was once split in every way: a hundred seconds for eighty letters."""
    assert turned(prompt) == prompt
    assert not in_a_row(prompt)


def test_three_on_a_desk_stand_apart_with_the_tallest_behind():
    desk = box((-0.5, -0.5, -0.2), (0.5, 0.5, 0.2), "desk")
    low, flat, high = (box((-0.1, -0.1, -z), (0.1, 0.1, z), "mug") for z in (0.1, 0.05, 0.3))
    (own,), *places = arranged(desk, [("bears", one) for one in (low, flat, high)])
    below = desk.placed(own)
    each = [one.placed(at) for one, (at,) in zip((low, flat, high), places, strict=True)]
    for one in each:
        assert abs(float(one.box[0, 2] - below.box[1, 2])) < 0.05
        assert (one.box[0, :2] > below.box[0, :2]).all()
        assert (one.box[1, :2] < below.box[1, :2]).all()
    for k, one in enumerate(each):
        for other in each[k + 1 :]:
            apart = torch.maximum(one.box[0] - other.box[1], other.box[0] - one.box[1])[:2]
            assert float(apart.max()) > -0.02
    assert float(each[2].box[0, 1]) >= float(each[1].box[1, 1]) - 0.02
    # The one that is alone in front is in the middle.
    assert abs(float((each[1].box.mean(0) - below.box.mean(0))[0])) < 0.1 * float(below.sides[0])


def test_two_beside_a_table_are_on_its_two_sides():
    table, chair = body("a table"), body("a chair")
    (own,), (first,), (second,) = arranged(table, [("beside", chair), ("beside", chair)])
    there, right, left = table.placed(own), chair.placed(first), chair.placed(second)
    assert float(right.box[0, 0]) == pytest.approx(float(there.box[1, 0]), abs=0.03)
    assert float(left.box[1, 0]) == pytest.approx(float(there.box[0, 0]), abs=0.03)
    for one in (right, left):
        assert float(one.box[0, 2]) == pytest.approx(float(there.box[0, 2]), abs=1e-4)


def test_two_kinds_fill_a_basket_as_one_heap():
    apple, _, _ = several("an apple", 5, "heap")
    pear, _, _ = several("a pear", 5, "heap")
    apples, pears = mixed_heap([apple, pear])
    assert len(apples) == len(pears) == 5
    shifts = torch.stack([place.shift for place in (*apples, *pears)])
    assert float(torch.pdist(shifts).min()) > 0.2 * float(apple.sides[:2].min())
    # Neither is on one side by itself.
    middles = [torch.stack([p.shift for p in own]).mean(0)[:2] for own in (apples, pears)]
    assert float((middles[0] - middles[1]).norm()) < 0.6 * float(apple.sides[0])
    # Nor is one on the ground, and the other on it.
    high = [float(torch.stack([p.shift for p in own])[:, 2].mean()) for own in (apples, pears)]
    assert abs(high[0] - high[1]) < 0.4 * float(apple.sides[2])
    basket = body("a basket")
    (at,), *places = arranged(basket, [("bears", apple), ("bears", pear)])
    inside = basket.placed(at)
    groups = [thing.group(own) for thing, own in zip((apple, pear), places, strict=True)]
    between = (groups[0].box.mean(0) - groups[1].box.mean(0))[:2].norm()
    assert float(between) < 0.3 * float(groups[0].sides[:2].max())
    for group in groups:
        assert (group.box[0, :2] > inside.box[0, :2]).all()
        assert (group.box[1, :2] < inside.box[1, :2]).all()


def test_a_sword_is_put_down_on_a_table_and_a_vase_stands():
    table = box((-0.6, -0.4, -0.2), (0.6, 0.4, 0.2), "table")
    tall = (-0.08, -0.03, -0.5), (0.08, 0.03, 0.5)
    for noun, lies in (("sword", True), ("vase", False)):
        thing = box(*tall, noun)
        (own,), (at,) = arranged(table, [("bears", thing)])
        sides = thing.placed(at).sides
        assert bool(sides[2] < sides[:2].max()) is lies
        on = thing.placed(at).box[0, 2] - table.placed(own).box[1, 2]
        assert abs(float(on)) < 0.05


def test_what_is_on_an_island_stands_on_its_ground():
    """And not on its palm."""
    island, things = body("an island"), [body(f"a {one}") for one in ("tree", "pagoda", "boat")]
    (own,), *places = arranged(island, [("bears", thing) for thing in things])
    grass = island.placed(own).of_parts("grass")[:, 2].max()
    for thing, (at,) in zip(things, places, strict=True):
        assert float(thing.placed(at).box[0, 2]) < float(grass) + 0.05


def test_a_heap_does_not_look_out_under_a_bowl():
    bowl = body("a bowl")
    kinds = [several(one, 4, "heap")[0] for one in ("an apple", "an orange", "a banana")]
    (own,), *places = arranged(bowl, [("bears", kind) for kind in kinds])
    there = bowl.placed(own)
    low, high, middle = there.box[0, 2], there.sides[2], there.box.mean(0)[:2]

    def up_and_out(verts: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        return (verts[:, 2] - low) / high, (verts[:, :2] - middle).norm(dim=1)

    up, out = up_and_out(there.verts)
    for kind, at in zip(kinds, places, strict=True):
        own_up, own_out = up_and_out(kind.group(at).verts)
        assert float(own_up.min()) > 0
        for step in range(19):
            layer, here = ((of * 20).long() == step for of in (up, own_up))
            if here.any():
                assert float(own_out[here].max()) < float(out[layer].max()) - 0.01
