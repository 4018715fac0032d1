"""Small things on a thing in words, and where they are."""

from dataclasses import replace

import pytest
import torch

from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.attaching import (
    at_front,
    behind,
    growing,
    hanging,
    in_coils,
    surrounding,
)
from core.guidance.builtin.composition.placing.resting import upon
from core.guidance.builtin.words.companions.rephrasing import turned_around
from core.guidance.builtin.words.vocabulary import parse, understood
from core.tests.drawn_things import body, box, several


def others(prompt: str) -> list[str]:
    """Each companion as its relation, its number and its thing."""
    read = parse(prompt)
    return [f"{one.relation} {one.words.count} {one.words.noun}" for one in read.companions]


@pytest.mark.parametrize(
    ("prompt", "thing", "found"),
    [
        ("a hat with a feather", "hat", ["front 1 feather"]),
        ("a purple wizard hat with a gold star on top", "wizard hat", ["bears 1 star"]),
        ("a cactus with pink flowers", "cactus", ["growing 3 flower"]),
        ("a log covered in mushrooms", "log", ["growing 5 mushroom"]),
        ("a log with two mushrooms growing on it", "log", ["growing 2 mushroom"]),
        ("a rock with moss and a flower", "boulder", ["growing 1 flower"]),
        ("a tree with lanterns hanging from it", "tree", ["hanging 3 lantern"]),
        ("two lanterns hanging from an oak tree", "oak tree", ["hanging 2 lantern"]),
        ("a swing hanging from a tree", "tree", ["beside 1 swing"]),
        ("a tree with red apples", "tree", ["growing 6 apple"]),
        ("a bird's nest in the branches of a tree", "tree", ["bears 1 nest"]),
        ("an owl in a tree", "tree", ["bears 1 owl"]),
        ("a teapot with a bird on its lid", "teapot", ["bears 1 bird"]),
        ("a parrot on a perch", "parrot", ["on 1 log"]),
        ("a polar bear on an ice floe", "bear", ["on 1 boulder"]),
        ("a baseball glove with a ball in it", "glove", ["front 1 baseball"]),
        ("a journal with a pen", "notebook", ["front 1 pen"]),
        ("a bicycle with a basket on the front", "bicycle", ["front 1 basket"]),
        ("a katana on a wooden stand", "katana", ["on 1 coffee table"]),
        ("a snake coiled around a tree", "snake", ["around 1 tree"]),
        ("a barrel with two crossed swords", "barrel", ["behind 2 sword"]),
        ("a terrarium with a turtle", "aquarium", ["bears 1 turtle"]),
        ("a truck carrying logs", "pickup truck", ["bears 8 log"]),
        ("skull and crossbones", "skull", ["behind 2 bone"]),
        ("two crossed bones under a skull", "skull", ["behind 2 bone"]),
        ("a shield with two crossed swords", "shield", ["behind 2 sword"]),
        ("a snake coiled around a sword", "snake", ["around 1 sword"]),
        ("a snake coiled around an apple", "snake", ["beside 1 apple"]),
        ("a rope wrapped around a barrel", "rope", ["beside 1 barrel"]),
        ("a wooden staff with a green snake coiled around it", "snake", ["around 1 staff"]),
        ("a skull with a snake wrapped around it", "skull", ["beside 1 snake"]),
        ("a red scarf wrapped around a penguin", "penguin", ["wears 1 scarf"]),
        ("a dragon curled around a crystal", "dragon", ["beside 1 crystal"]),
        ("six chairs around a table", "table", ["surrounding 6 chair"]),
        ("ten candles around a skull", "skull", ["surrounding 10 candle"]),
        ("a house with trees around it", "house", ["surrounding 6 tree"]),
        ("a lamp with a bird", "lamp", ["bears 1 bird"]),
        ("a candle with a skull", "candle", ["beside 1 skull"]),
        ("a helmet with two large horns", "viking helmet", []),
        ("a house in a tree", "treehouse", []),
        ("a vine around a column", "column", []),
    ],
)
def test_small_things_have_a_place(prompt: str, thing: str, found: list[str]):
    assert (parse(prompt).noun, others(prompt)) == (thing, found)


@pytest.mark.parametrize(
    "prompt",
    [
        "a wizard hat with stars",
        "a pirate hat with a feather",
        "a mug with flowers",
        "a vase with a bird",
        "a boat with a flag",
        "a violin with a bow",
        "a castle with a tower",
        "a chest with a heart on its lid",
        "a boulder with moss",
        "a hat with a ribbon",
        "a robot with a screen",
        "a cherry tree with pink blossoms",
    ],
)
def test_parts_and_prints_are_no_other_things(prompt: str):
    assert parse(prompt).companions == ()


def test_a_flower_on_a_cactus_has_no_stem():
    (flower,) = parse("a cactus with pink flowers").companions
    (on_rock,) = parse("a rock with moss and a flower").companions
    assert flower.words.absent == ("stalk",) and on_rock.words.absent == ()


def test_what_stands_in_for_another_thing_is_noted():
    assert "perch: made as a log." in understood("a parrot on a perch")["notes"]
    notes = understood("a snake coiled around an apple")["notes"]
    assert "a snake keeps its own form: the apple is next to it." in notes


def test_an_animal_coiled_around_something_sleeps():
    assert parse("a dragon curled around a crystal").pose == "sleeping"


def test_what_grows_is_on_top_and_apart():
    log, small = (
        box((-1, -0.3, -0.3), (1, 0.3, 0.3), "log"),
        box((0, 0, 0), (0.2, 0.2, 0.2), "mushroom"),
    )
    places = growing(small, log, 3)
    grown = [small.placed(place) for place in places]
    for one in grown:
        assert -0.05 < float(one.box[0, 2] - log.box[1, 2]) < 0
    middles = torch.stack([one.box.mean(0) for one in grown])
    assert torch.pdist(middles).min() > grown[0].sides[0]


def test_what_hangs_is_below_the_crown_and_off_the_ground():
    tree, lantern = body("an oak tree"), body("a lantern")
    crown = tree.of_parts("leaves")
    for place in hanging(lantern, tree, 3):
        one = lantern.placed(place)
        assert one.box[0, 2] > tree.box[0, 2]
        assert float(one.box[1, 2]) < float(crown[:, 2].mean())


def test_a_nest_is_in_a_tree_and_an_owl_on_top():
    tree = body("a tree")
    nest, owl = (body(one).placed(upon(body(one), tree)) for one in ("a nest", "an owl"))
    high = float(tree.box[1, 2])
    assert float(tree.of_parts("trunk")[:, 2].min()) < float(nest.box[0, 2])
    assert float(nest.box[1, 2]) < high < float(owl.box[1, 2])
    assert float(nest.box.mean(0)[1]) < float(tree.box.mean(0)[1])


def test_what_is_around_touches_and_looks_at_the_middle():
    table, chair = (
        box((-1, -0.5, -0.4), (1, 0.5, 0.4), "table"),
        box((-0.2, -0.2, -0.4), (0.2, 0.2, 0.4), "chair"),
    )
    for place in surrounding(chair, table, 4):
        one = chair.placed(place)
        forward = place.turn @ torch.tensor([0.0, -1.0, 0.0])
        middle = one.box.mean(0)
        assert float(forward[:2] @ middle[:2]) < 0
        assert float(middle[2] - table.box.mean(0)[2]) == pytest.approx(0.0, abs=1e-3)
        gap = (middle.abs() - table.sides / 2)[:2].amax()
        assert float(gap) < 0.8 * float(one.sides[0])


def test_crossed_things_are_behind_and_stand_out():
    shield, (_, _, both) = body("a shield"), several("a sword", 2, "crossed")
    back = both.placed(behind(both, shield))
    assert back.box[0, 1] > shield.box.mean(0)[1]
    assert back.sides[2] > shield.sides[2]


def test_a_feather_is_at_the_side_of_a_hat_and_a_flower_in_front():
    hat, feather, flower = body("a hat"), body("a feather"), body("a flower")
    side, front = feather.placed(at_front(feather, hat)), flower.placed(at_front(flower, hat))
    assert side.box.mean(0)[0] > 0.15 * hat.sides[0] + hat.box.mean(0)[0]
    assert front.box.mean(0)[1] < hat.box.mean(0)[1] - 0.15 * hat.sides[1]


def test_a_sword_stands_in_a_snakes_coils():
    snake, sword = body("a snake"), body("a sword")
    within = sword.placed(in_coils(sword, snake))
    assert within.box[1, 2] > snake.box[1, 2]
    assert (within.box.mean(0)[:2] > snake.box[0, :2]).all()
    assert (within.box.mean(0)[:2] < snake.box[1, :2]).all()


def test_a_load_is_on_the_bed():
    truck, heap = body("a pickup truck"), several("a pumpkin", 3, "heap")[2]
    load = heap.placed(upon(heap, truck))
    bed = truck.only("bed")
    assert (load.box.mean(0)[:2] > bed.box[0, :2]).all()
    assert (load.box.mean(0)[:2] < bed.box[1, :2]).all()
    assert load.sides[0] < 1.2 * bed.sides[0]


def test_a_sword_lies_along_the_table_that_it_is_on():
    table = box((-1, -0.4, -0.3), (1, 0.4, 0.3), "table")
    sword = body("a sword")
    (own,), (below,) = arranged(sword, [("on", table)])
    laid, under = sword.placed(own), table.placed(below)
    assert laid.sides[0] > 3 * laid.sides[1:].max()
    assert abs(float(laid.box[0, 2] - under.box[1, 2])) < 0.05
    assert abs(float((laid.box.mean(0) - under.box.mean(0))[0])) < 0.1 * float(under.sides[0])


def test_each_of_what_grows_has_its_own_place_in_the_whole():
    log = box((-1, -0.3, -0.3), (1, 0.3, 0.3), "log")
    small = box((0, 0, 0), (0.2, 0.2, 0.2), "mushroom")
    small = replace(small, words=replace(small.words, count=2))
    (own,), places = arranged(log, [("growing", small)])
    assert len(places) == 2
    top = log.placed(own).box[1, 2]
    for place in places:
        assert abs(float(small.placed(place).box[0, 2] - top)) < 0.05


@pytest.mark.parametrize(
    ("prompt", "same"),
    [
        ("a vase with a dragon", "a vase with a dragon on it"),
        ("a mug with a sleeping cat", "a mug with a sleeping cat on it"),
        ("a snow globe with a little house", "a snow globe with a little house inside"),
        ("a jack-o-lantern with a witch hat", "a jack-o-lantern wearing a witch hat"),
        ("a snake around a staff", "a snake coiled around a staff"),
    ],
)
def test_prompts_that_say_the_same_in_other_words(prompt, same):
    assert turned_around(prompt) == same


@pytest.mark.parametrize(
    "prompt",
    [
        "a vase with a rose",
        "a mug with a spoon",
        "a snow globe with a wooden base",
        "a plate with a fish",
        "a skull with a candle",
    ],
)
def test_other_prompts_stay_as_they_are(prompt):
    assert turned_around(prompt) == prompt
