"""Where the things of a composition lie."""

from dataclasses import replace

import pytest
import torch

from core.geometry.init_shape import sample_surface
from core.geometry.signed_distance import SolidMesh
from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.holding import held
from core.guidance.builtin.composition.placing.placement import Z_TO_BACK, Body, Placement, sized
from core.guidance.builtin.composition.placing.resting import (
    around,
    beside,
    height_map,
    is_stuck,
    under,
    upon,
)
from core.guidance.builtin.composition.placing.wearing import freed, head_of, worn
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import body, box, centered, composed, shipped_prior

QUARTER = torch.tensor([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def test_a_placement_is_undone():
    place = Placement(0.4, torch.tensor([0.1, -0.2, 0.3]), QUARTER)
    points = torch.randn(20, 3, generator=torch.Generator().manual_seed(0))
    torch.testing.assert_close(place.into(place.out(points)), points)
    torch.testing.assert_close(
        place.out(torch.tensor([[1.0, 0, 0]])), torch.tensor([[0.1, 0.2, 0.3]])
    )
    after = place.then(2.0, torch.tensor([1.0, 0.0, 0.0]))
    torch.testing.assert_close(after.out(points), place.out(points) * 2 + torch.tensor([1.0, 0, 0]))


def test_things_are_as_large_to_each_other_as_they_usually_are_within_limits():
    mouse, elephant = body("a mouse"), body("an elephant")
    assert sized(elephant, mouse, 0.1, 1000) * elephant.longest / mouse.longest == pytest.approx(
        elephant.usual / mouse.usual
    )
    assert sized(elephant, mouse, 0.1, 3.0) * elephant.longest == pytest.approx(3 * mouse.longest)
    assert sized(mouse, elephant, 0.2, 3) * mouse.longest == pytest.approx(0.2 * elephant.longest)


def test_a_stated_size_is_the_things_own():
    small, usual = body("a 5 cm tall robot"), body("a robot")
    assert small.usual < 0.3 * usual.usual


def test_a_height_map_has_the_highest_point_over_each_cell():
    heights = height_map(box((0.0, 0.0, 0.0), (1.0, 2.0, 0.5)))
    assert not heights.isnan().any() and torch.allclose(heights, torch.tensor(0.5), atol=1e-6)


@pytest.mark.parametrize(
    ("thing", "support"),
    [("a cat", "a cushion"), ("an anvil", "a stump"), ("a frog", "a mushroom")],
)
def test_what_is_on_something_touches_it_and_is_above(thing, support):
    upper = body(thing)
    lower = body(support).placed(under(upper, body(support)))
    foot = float(upper.box[0, 2])
    assert float(centered(lower)[2]) < foot
    solid = SolidMesh(lower.verts, lower.faces)
    assert float(solid.sdf(upper.verts).min()) < 0  # they touch
    evenly = sample_surface(upper.verts, upper.faces, 4000, torch.Generator().manual_seed(0))
    assert float((solid.sdf(evenly) < 0).float().mean()) < 0.2  # and it is not swallowed


def test_one_sits_on_the_seat_and_not_on_the_back():
    cat, sofa = body("a cat"), body("a sofa")
    below = sofa.placed(under(cat, sofa))
    assert float(cat.box[0, 2]) < float(below.box[0, 2] + 0.75 * below.sides[2])
    assert float((centered(cat) - centered(below))[0].abs()) < 0.25 * float(below.sides[0])


def test_a_surfboard_lies_under_who_stands_on_it():
    board = body("a surfboard")
    assert board.sides[2] > board.sides[:2].max()  # it is drawn upright
    lying = board.placed(under(body("a penguin"), board))
    assert lying.sides[2] < 0.5 * lying.sides[:2].max()


def test_what_is_in_a_container_stands_out_of_it_and_has_room():
    for thing, holder in (("a tulip", "a vase"), ("a cat", "a cardboard box")):
        upper = body(thing)
        outer = body(holder).placed(around(upper, body(holder)))
        assert outer.box[0, 2] < upper.box[0, 2] < outer.box[1, 2] < upper.box[1, 2]


@pytest.mark.parametrize(("wide", "deep"), [(1.0, 1.0), (0.6, 1.6)])
def test_two_that_are_borne_stand_side_by_side_or_one_behind_the_other(wide, deep):
    table = box((-wide / 2, -deep / 2, -0.2), (wide / 2, deep / 2, 0.2), "table")
    skull, book = (box((-0.2, -0.2, -0.2), (0.2, 0.2, 0.2), noun) for noun in ("skull", "book"))
    (own,), *places = arranged(table, [("bears", skull), ("bears", book)])
    below, axis = table.placed(own), int(deep > wide)
    first, second = (thing.placed(at) for thing, (at,) in zip((skull, book), places, strict=True))
    low, high = sorted((first, second), key=lambda thing: float(thing.box[0, axis]))
    assert low.box[1, axis] < high.box[0, axis] + 0.02
    for thing in (first, second):
        assert abs(float(thing.box[0, 2] - below.box[1, 2])) < 0.05
        assert (thing.box[0, :2] > below.box[0, :2]).all()
        assert (thing.box[1, :2] < below.box[1, :2]).all()


def test_what_a_thing_bears_is_on_its_top_and_no_wider():
    turtle = body("a turtle")
    house = body("a house").placed(upon(body("a house"), turtle))
    assert float(house.box[0, 2]) > float(centered(turtle)[2])
    assert float(house.sides[:2].max()) < float(turtle.sides[:2].max())


@pytest.mark.parametrize("wearer", ["a corgi", "a penguin", "a person", "a horse", "a robot"])
@pytest.mark.parametrize("hat", ["a cowboy hat", "a beanie", "a crown"])
def test_a_hat_is_on_the_head_above_the_eyes(wearer, hat):
    head, one = head_of(body(wearer)), body(hat).placed(worn(body(hat), body(wearer)))
    assert head.eyes < float(one.box[0, 2]) + 0.12 * float(body(wearer).sides[2])
    assert float(one.box[0, 2]) < head.top < float(one.box[1, 2])
    assert 0.8 * head.wide < float(one.sides[0]) < 2.6 * head.wide
    eyes = body(wearer).of_parts("eyes")
    assert abs(float(centered(one)[0] - eyes[:, 0].mean())) < 0.2 * head.wide


def test_a_robots_panel_is_no_pair_of_eyes():
    robot = body("a robot")
    assert head_of(robot).eyes > float(centered(robot)[2])


def test_a_helmet_fits_the_head_and_its_horns_stand_out():
    head, helmet = head_of(body("a bear")), body("a viking helmet")
    there = helmet.placed(worn(helmet, body("a bear")))
    shell = there.without("horns", "sockets")[:, 0]
    assert float(shell.amax() - shell.amin()) == pytest.approx(head.wide, rel=0.2)
    assert float(there.sides[0]) > 1.5 * head.wide


def test_what_has_no_eyes_wears_a_hat_on_its_top():
    pumpkin = body("a pumpkin")
    hat = body("a wizard hat").placed(worn(body("a wizard hat"), pumpkin))
    assert float(hat.box[1, 2]) > float(pumpkin.box[1, 2])
    assert float(hat.sides[0]) < 1.3 * float(pumpkin.sides[0])


def test_glasses_are_before_the_eyes():
    dog = body("a dog")
    glasses = body("sunglasses").placed(worn(body("sunglasses"), dog))
    eyes = dog.of_parts("eyes")
    assert float(glasses.box[0, 1]) <= float(eyes[:, 1].min())
    assert float(centered(glasses)[2]) == pytest.approx(float(eyes[:, 2].mean()), abs=0.08)


def test_a_bow_tie_is_below_the_eyes_and_in_front():
    cat = body("a cat")
    tie = body("a bow tie").placed(worn(body("a bow tie"), cat))
    assert float(tie.box[1, 2]) < head_of(cat).eyes
    assert float(centered(tie)[1]) < 0


def test_headphones_are_over_the_ears_and_a_headset_is_before_the_eyes():
    cat = body("a cat")
    head = head_of(cat)
    phones = body("headphones").placed(worn(body("headphones"), cat))
    assert float(phones.sides[0]) > head.wide and float(phones.box[1, 2]) > head.top
    assert float(phones.box[0, 2]) < head.top
    headset = body("a vr headset").placed(worn(body("a vr headset"), body("a robot")))
    eyes = body("a robot").of_parts("eyes")
    eyes = eyes[eyes[:, 2] > 0]  # not its panel
    assert float(headset.box[0, 1]) < float(eyes[:, 1].min()) - 0.05


def test_a_tie_hangs_down_from_the_neck_before_the_chest():
    person = body("a person")
    tie = body("a necktie").placed(worn(body("a necktie"), person))
    low, high = person.box[:, 2].tolist()
    assert float(tie.box[1, 2]) < head_of(person).eyes
    assert float(tie.box[0, 2]) > low + 0.3 * (high - low)
    assert float(centered(tie)[1]) < 0


def test_a_sword_is_held_by_its_grip_at_the_side():
    person = body("a person")
    sword = body("a sword").placed(held(body("a sword"), person))
    assert float(centered(sword)[0]) < 0.6 * float(person.box[0, 0])
    low, high = person.box[:, 2].tolist()
    grip = sword.of_parts("grip", "hilt", "handle")
    assert low + 0.2 * (high - low) < float(grip[:, 2].mean()) < low + 0.7 * (high - low)
    assert float(sword.box[1, 2]) > float(grip[:, 2].max())  # its blade is up


def test_a_dog_has_a_bone_across_its_mouth():
    dog, bone = body("a dog"), body("a bone")
    there = bone.placed(held(bone, dog))
    assert int(there.sides.argmax()) == 0  # from side to side
    assert float(there.box[0, 1]) < float(dog.box[0, 1]) + 0.3 * float(dog.sides[1])


def test_an_umbrella_is_upright_in_a_mouth():
    there = body("an umbrella").placed(held(body("an umbrella"), body("a raccoon")))
    upright = body("an umbrella").sides
    torch.testing.assert_close(there.sides / there.sides.max(), upright / upright.max())


def test_a_sword_is_in_the_stone_with_its_point():
    guidance = composed("a sword in a stone")
    sword, stone = (
        Body.of(thing.words, thing.solid).placed(place)
        for thing, (place,) in zip(guidance.made.things, guidance.made.places, strict=True)
    )
    blade, grip = sword.of_parts("blade"), sword.of_parts("grip", "hilt", "handle")
    assert float(blade[:, 2].min()) < float(stone.box[1, 2]) < float(blade[:, 2].max())
    assert float(grip[:, 2].min()) > float(blade[:, 2].mean())
    assert is_stuck(body("an axe"), body("a stump")) and not is_stuck(
        body("a cat"), body("a stump")
    )


def test_what_is_stuck_in_the_first_thing_is_upside_down_too():
    place = upon(body("an axe"), body("a stump"))
    assert place.turn[2, 2] == -1
    axe = body("an axe").placed(place)
    assert float(axe.box[0, 2]) < float(body("a stump").box[1, 2]) < float(axe.box[1, 2])


def test_flowers_are_in_the_vase_that_they_are_said_to_be_in():
    vase, tulip = body("a vase"), body("a tulip")
    there = tulip.placed(upon(tulip, vase))
    assert vase.box[0, 2] < there.box[0, 2] < vase.box[1, 2] < there.box[1, 2]


@pytest.mark.parametrize("wearer", ["a person", "a goblin", "a teddy bear"])
def test_a_backpack_is_on_the_back(wearer):
    pack = body("a backpack").placed(worn(body("a backpack"), body(wearer)))
    who = body(wearer)
    assert float(centered(pack)[1]) > 0.5 * float(centered(who)[1] + who.box[1, 1])
    assert float(who.box[0, 2]) < float(pack.box[0, 2]) < float(pack.box[1, 2]) < head_of(who).top


def test_a_pig_bears_its_backpack():
    pack = body("a backpack").placed(worn(body("a backpack"), body("a pig")))
    assert float(centered(pack)[2]) > float(body("a pig").box[1, 2]) - 0.3


def test_each_of_several_wears_a_hat():
    pair = [
        replace(body(p), words=replace(body(p).words, count=n))
        for p, n in (("a penguin", 2), ("a beanie", 1))
    ]
    penguins, hats = arranged(pair[0], [("wears", pair[1])])
    assert len(penguins) == len(hats) == 2
    for penguin, hat in zip(penguins, hats, strict=True):
        there = body("a beanie").placed(hat)
        assert float(centered(there)[0]) == pytest.approx(float(penguin.shift[0]), abs=0.05)
    two = replace(body("a pillow"), words=replace(body("a pillow").words, count=2))
    cats, pillows = arranged(replace(body("a cat"), words=pair[0].words), [("on", two)])
    assert len(pillows) == 2
    apart = [
        float((cat.shift - pillow.shift)[0]) for cat, pillow in zip(cats, pillows, strict=True)
    ]
    assert max(map(abs, apart)) < 0.1


def test_the_second_thing_is_in_the_other_hand():
    robot = body("a robot")
    first, second = (
        body(p).placed(held(body(p), robot, k == 1)) for k, p in enumerate(("a sword", "a flag"))
    )
    assert float(centered(first)[0]) < 0 < float(second.of_parts("pole", "staff")[:, 0].mean())
    places = arranged(robot, [("holds", body("a sword")), ("holds", body("a flag"))])
    assert float(places[1][0].shift[0]) * float(places[2][0].shift[0]) < 0


def test_a_crab_without_claws_holds_something_too():
    crab = shipped_prior().prompted("a crab without claws", "").of_object(0)
    place = held(body("a flag"), Body.of(crab.words, crab.solid))
    assert torch.isfinite(place.shift).all()


@pytest.mark.parametrize("noun", ["a golem", "a minotaur", "a crab", "a butterfly"])
def test_shoulders_and_claws_are_no_head(noun):
    who = body(noun)
    eyes = who.of_parts("eyes")
    assert head_of(who).wide < 0.75 * float(who.sides[0])
    assert head_of(who).wide <= 2 * float(eyes[:, 0].max() - eyes[:, 0].min())


@pytest.mark.parametrize("noun", ["a christmas tree", "a banana", "an acorn"])
def test_a_hat_on_what_is_pointed_is_seen(noun):
    hat = body("a hat").placed(worn(body("a hat"), body(noun)))
    assert float(hat.sides[0]) > 0.25 * float(body(noun).sides[:2].min())


def test_a_hat_goes_over_a_stalk_and_a_leaf():
    for noun, own in (("a pumpkin", "body"), ("an apple", "body")):
        wearer = body(noun)
        hat = body("a wizard hat").placed(worn(body("a wizard hat"), wearer))
        top = float(wearer.of_parts(own)[:, 2].amax())
        assert top - 0.25 < float(hat.box[0, 2]) < top
        high = float(wearer.of_parts("stalk")[:, 2].amax())
        assert high > top + 0.05  # or it would be the head's top
        assert float(hat.box[1, 2]) > high


@pytest.mark.parametrize("noun", ["a mushroom", "a pumpkin"])
def test_glasses_of_what_has_no_eyes_are_before_it(noun):
    wearer = body(noun)
    glasses = body("sunglasses").placed(worn(body("sunglasses"), wearer))
    lenses = glasses.of_parts("glasses")
    low, high = lenses[:, 2].amin(), lenses[:, 2].amax()
    beside = wearer.verts[(wearer.verts[:, 2] > low) & (wearer.verts[:, 2] < high)]
    beside = beside[(beside[:, 0] - lenses[:, 0].mean()).abs() < 0.1]
    assert float(lenses[:, 1].amin()) < float(beside[:, 1].amin()) + 0.05


def test_a_mugs_opening_is_in_the_middle_of_its_cup():
    mug = body("a mug")
    rose = body("a rose").placed(upon(body("a rose"), mug))
    cup = mug.of_parts("body")
    middle = (cup.amin(0) + cup.amax(0)) / 2
    foot = rose.verts[rose.verts[:, 2] < rose.box[0, 2] + 0.1 * rose.sides[2]]
    assert float((foot.mean(0) - middle)[:2].norm()) < 0.15


def test_a_hat_takes_the_place_of_a_hat():
    wizard, crown = parse("a wizard"), parse("a crown")
    assert freed(wizard, [("wears", crown)]).absent == ("hat",)
    assert freed(wizard, [("holds", crown)]).absent == ()
    assert freed(parse("a cat"), [("wears", crown)]).absent == ()
    torch_and_crown = [("holds", parse("a torch")), ("wears", crown)]
    assert freed(parse("a knight"), torch_and_crown).absent == ("shield",)


def test_a_loaded_wagon_has_no_cover():
    hay = parse("hay")
    assert freed(parse("a cart"), [("bears", hay)]).absent == ("cover",)
    assert freed(parse("a cart"), [("beside", hay)]).absent == ()
    assert freed(parse("a table"), [("bears", hay)]).absent == ()


def test_a_turned_and_a_grouped_body_keep_their_scale():
    board = body("a 2 m tall surfboard")
    laid = board.placed(Placement.of(1.0, Z_TO_BACK))
    assert board.usual == pytest.approx(2) and laid.usual == pytest.approx(2, rel=0.05)
    small = board.placed(Placement.of(0.5))
    assert small.usual == pytest.approx(2) and small.longest < board.longest


def test_what_is_beside_stands_on_the_same_ground_and_touches():
    table = body("a table")
    chair = body("a chair").placed(beside(body("a chair"), table, table))
    assert float(chair.box[0, 2]) == pytest.approx(float(table.box[0, 2]), abs=1e-5)
    assert float(chair.box[0, 0]) == pytest.approx(float(table.box[1, 0]) - 0.02, abs=1e-5)
