"""Several things as one object: where each lies, and what is painted where."""

import math
from dataclasses import replace
from functools import cache

import pytest
import torch

from core.camera import Cameras
from core.config import DRAFT
from core.generate import Inputs, of_seed
from core.geometry.assembly import assembled
from core.geometry.mesh import NORMAL_RADIUS, Mesh, component_labels, health
from core.geometry.signed_distance import SolidMesh
from core.guidance.builtin.composition.arranged import arranged
from core.guidance.builtin.composition.composed import Composed, composed_field, seen_from
from core.guidance.builtin.composition.copies import copies_of
from core.guidance.builtin.composition.holding import held
from core.guidance.builtin.composition.placement import Body, Placement, sized
from core.guidance.builtin.composition.resting import (
    TILTED,
    around,
    height_map,
    is_stuck,
    under,
    upon,
)
from core.guidance.builtin.composition.wearing import freed, head_of, worn
from core.guidance.builtin.guidance import PromptedBuiltin, load_builtin
from core.guidance.builtin.palette import looks
from core.guidance.builtin.words.slots import Words
from core.guidance.builtin.words.vocabulary import parse
from core.guidance.guidance import Views
from core.io.job import Job
from core.job_config import config_of

QUARTER = torch.tensor([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


@cache
def body(prompt: str) -> Body:
    drawn = load_builtin("cpu").prompted(prompt, "").of_object(0)
    assert drawn.solid is not None
    return Body.of(drawn.words, drawn.solid)


@cache
def composed(prompt: str) -> Composed:
    found = load_builtin("cpu").prompted(prompt, "").of_object(0)
    assert isinstance(found, Composed) and found.made
    return found


def centered(thing: Body) -> torch.Tensor:
    return thing.box.mean(0)


def box(low, high, noun="crate") -> Body:
    """A box's surface as a thing."""
    low, high = torch.tensor(low), torch.tensor(high)
    corners = torch.tensor([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    faces = "013 032 467 475 045 051 237 276 026 064 157 173".split()
    faces = torch.tensor([[int(corner) for corner in face] for face in faces])
    verts = low + corners * (high - low)
    return Body(Words(noun=noun), verts.float(), faces, torch.zeros(8, dtype=torch.long))


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
    inside = SolidMesh(lower.verts, lower.faces).sdf(upper.verts)
    assert float(inside.min()) < 0  # they touch
    assert float((inside < 0).float().mean()) < 0.2  # and it is not swallowed


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


def test_a_scarf_is_around_the_neck():
    fox = body("a fox")
    scarf = body("a scarf").placed(worn(body("a scarf"), fox))
    middle = head_of(fox).middle
    low, high = scarf.box
    assert float(low[1]) < float(middle[1]) < float(high[1])
    assert float(high[2]) < head_of(fox).top


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
        for thing, (place,) in zip(guidance.things, guidance.made.places, strict=True)
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
    crab = load_builtin("cpu").prompted("a crab without claws", "").of_object(0)
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


def test_a_composition_is_one_closed_piece_of_the_usual_radius():
    parts = composed("a cat on a red cushion").parts()
    assert parts is not None
    made = assembled(parts, True, DRAFT.geometry.floaters, lambda _: None)
    assert made is not None
    verts, faces = made
    report = health(verts, faces)
    assert report["closed"] and component_labels(faces, len(verts))[0] == 1
    middle = (verts.amin(0) + verts.amax(0)) / 2
    assert float((verts - middle).norm(dim=1).max()) == pytest.approx(NORMAL_RADIUS, abs=0.05)


def test_each_place_is_painted_as_the_thing_that_is_there():
    guidance = composed("a cat on a red cushion")
    areas, parts = guidance.areas(), guidance.parts()
    assert areas is not None and parts is not None
    cat, cushion = guidance.things
    assert len(areas.each) >= len(looks("cat")) + len(looks(cushion.words.noun))
    body_of = Body.of(cushion.words, cushion.solid).placed(guidance.made.places[1][0])
    low = body_of.verts[body_of.verts[:, 2] < body_of.verts[:, 2].median()]
    colors = [areas.each[k].surface.color for k in areas.of(low).unique().tolist()]
    assert any(r > 0.5 and r > 2 * max(g, b) for r, g, b in colors), colors
    head = Body.of(cat.words, cat.solid).placed(guidance.made.places[0][0])
    top = head.verts[head.verts[:, 2] > head.verts[:, 2].quantile(0.9)]
    assert (areas.of(top) < len(looks("cat"))).all()


def test_far_from_a_thing_its_network_is_not_asked():
    asked = []

    def field(points):
        asked.append(points)
        return points[:, 0] * 0 - 1.0, points[:, :2] * 0 + 1.0

    at = composed_field([field], [[Placement(0.5, torch.zeros(3), torch.eye(3))]])
    distance, depths = at(torch.tensor([[0.0, 0.0, 0.0], [5.0, 0.0, 0.0]]))
    assert [len(points) for points in asked] == [1]
    assert distance[0] == -0.5 and distance[1] > 3 and (depths[1] < -3).all()
    far = at(torch.tensor([[5.0, 0.0, 0.0]]))  # nothing near at all
    assert far[0] > 3


@pytest.mark.parametrize("negative", ["", "red"])
def test_a_picture_is_predicted_by_the_thing_at_each_place(negative):
    prompted = load_builtin("cpu").prompted("a cat on a red cushion", negative)
    drawn = prompted.of_object(0)
    cameras = Cameras.orbit([20.0], [10.0], 2.75, 40.0)
    surface = torch.zeros(1, 7, 64, 64)
    surface[:, 3] = -1.0
    sides = slice(8, 24), slice(40, 56)  # on the left points of the cat, then of the cushion
    for columns, thing, (place,) in zip(sides, drawn.things, drawn.made.places, strict=True):
        verts = Body.of(thing.words, thing.solid).placed(place).verts
        some = verts[torch.linspace(0, len(verts) - 1, 16 * 16).long()]
        surface[0, 3, 24:40, columns] = 1.0
        surface[0, 4:, 24:40, columns] = some.T.reshape(3, 16, 16)
    z = torch.randn(1, 4, 64, 64, generator=torch.Generator().manual_seed(0))
    t, options = torch.tensor([300]), {"apart": bool(negative)}
    found = drawn.predict(z, t, Views(cameras, surface), **options)
    owner, copy = drawn._owner(surface)
    assert (owner[0, :20] == 0).all() and (copy == 0).all()
    for index, thing in enumerate(drawn.things):
        (place,) = drawn.made.places[index]
        own = thing.predict(z, t, Views(cameras, seen_from(surface, place)), **options)
        mine = owner == index
        assert (mine[0, 24:40, sides[index]]).float().mean() > 0.9
        for of, alone in zip(found, own, strict=True):
            assert (of is None) == (alone is None)
            if of is not None:
                pixels = mine[:, None].expand_as(of)
                torch.testing.assert_close(of[pixels], alone[pixels])
                assert not torch.allclose(of, alone)  # elsewhere it is the other's


def test_an_object_is_as_large_as_it_is_with_what_goes_with_it():
    alone = body("a rabbit").usual
    assert 1.1 * alone < composed("a rabbit on a stack of books").size_m() < 3 * alone
    stated = composed("a 60 cm tall rabbit on a stack of books").size_m()
    assert 0.65 < stated < 1.8
    assert load_builtin("cpu").prompted("a rabbit", "").of_object(0).size_m() is None


def test_a_turned_and_a_grouped_body_keep_their_scale():
    board = body("a 2 m tall surfboard")
    laid = board.placed(Placement.of(1.0, TILTED))
    assert board.usual == pytest.approx(2) and laid.usual == pytest.approx(2, rel=0.05)
    small = board.placed(Placement.of(0.5))
    assert small.usual == pytest.approx(2) and small.longest < board.longest


def test_a_mesh_of_ones_own_and_what_is_distilled_are_of_the_first_thing_alone():
    prompted = load_builtin("cpu").prompted("a wizard wearing a golden crown", "")
    alone = prompted.of_object(0, whole=False)
    for one in (prompted, alone):
        (note,) = one.left_out()
        assert note.startswith("crown: left out")
        assert one.size_m() is None
    wizard = load_builtin("cpu").prompted("a wizard", "").of_object(0)
    assert alone.parts().forms == wizard.parts().forms
    assert alone.alone.words.absent == ()  # it has its hat
    whole = prompted.of_object(0)
    assert whole.left_out() == () and whole.things[0].words.absent == ("hat",)
    assert whole.alone.words.absent == ()
    mesh = Mesh(body("a wizard").verts, body("a wizard").faces)
    guided = alone.in_proportion(mesh, 0.5, 0.02)
    assert guided.left_out() and guided.start_shape() is not None


@pytest.mark.parametrize(
    ("preset", "guide", "whole"),
    [("draft", False, True), ("draft", True, False), ("sds", False, False)],
)
def test_things_are_made_together_without_a_guide_where_nothing_is_distilled(preset, guide, whole):
    job = Job(prompt="a cat on a cushion", preset=preset)
    config = config_of(job)
    config = replace(config, geometry=replace(config.geometry, start="learned"))
    prompted = load_builtin("cpu").prompted(job.prompt, "")
    shape = Mesh(body("a cat").verts, body("a cat").faces) if guide else None
    inputs = Inputs(config, torch.device("cpu"), prompted, torch.zeros(1), shape)
    made = of_seed(inputs, job).guidance
    assert isinstance(made, Composed) and (made.made is not None) == whole
    assert bool(made.left_out()) != whole


def test_a_material_range_spans_all_things():
    wide = composed("a cat on a golden cushion").ranges()
    assert wide.metallic[0] <= 0.02 and wide.metallic[1] >= 0.9
    assert math.isfinite(wide.roughness[0])


def several(prompt: str, count: int, order: str) -> tuple[Body, list[Placement], Body]:
    one = replace(body(prompt), words=replace(body(prompt).words, count=count, order=order))
    copies = copies_of(one)
    return one, copies, one.group(copies)


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


def test_copies_are_painted_each_as_the_thing_itself():
    words = replace(parse("a red apple"), count=3)
    guidance = load_builtin("cpu")
    apple = guidance.prompted("a red apple", "")
    three = Composed(guidance, apple, [replace_words(apple, words)], []).of_object(0)
    (places,) = three.made.places
    assert len(places) == 3
    alone = apple.of_object(0).areas()
    together = three.areas()
    verts = Body.of(words, three.things[0].solid).verts
    for place in places:
        same = together.of(place.out(verts)) == alone.of(verts)
        assert float(same.float().mean()) > 0.95
    assert len(together.each) == len(alone.each)
    assert three.parts().copy(torch.stack([p.shift for p in places]))[1].tolist() == [0, 1, 2]


def replace_words(prompted, words):
    return PromptedBuiltin(prompted.builtin, words, prompted.negative)
