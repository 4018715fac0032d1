"""Figures on two legs in the poses that a prompt states."""

import math
from dataclasses import replace
from functools import cache

import pytest
import torch

from core.geometry.parts.assembly import assembled
from core.guidance.builtin.composition.composed import Composed
from core.guidance.builtin.composition.placing.holding import HANDED, held
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.poses import posed as poses
from core.guidance.builtin.composition.poses.figure_poses import HIDDEN, POSES, STRAIGHT, Figure
from core.guidance.builtin.composition.poses.legs import legs_of
from core.guidance.builtin.composition.poses.limbs import CLOTHED, PADDED, Limb, both_poses, degrees
from core.guidance.builtin.composition.poses.posing import Bone, Posed, PosedParts
from core.guidance.builtin.composition.poses.sitting import ROBED
from core.guidance.builtin.words.phrases.poses import FIGURES, FOUR_LEGGED, OF_FIGURES, pose_of
from core.guidance.builtin.words.vocabulary import parse, understood
from core.tests.drawn_things import body, composed, shipped_prior

DOWN = torch.tensor([0.0, 0.0, -1.0])
TRUNK, THIGH, SHIN = 0, (1, 3), (2, 4)  # bones; the left leg's, the right one's


@cache
def figure(prompt: str) -> Figure:
    drawn = shipped_prior().prompted(prompt, "").of_object(0)
    found = Figure.of(drawn, Body.of(drawn.words, drawn.solid, drawn.parts()))
    assert found is not None
    return found


def posed(prompt: str) -> tuple[Posed, Body]:
    """The posed first thing of a prompt, and its body."""
    first = composed(prompt).made.things[0]
    assert isinstance(first, Posed)
    return first, first.pose.body(body(first.words.noun))


def forward(bone: Bone) -> float:
    """By how many degrees what hangs down from it is forward."""
    way = bone.place.turn @ DOWN
    return math.degrees(math.atan2(-float(way[1]), -float(way[2])))


def of_bone(prompt: str, *bones: int) -> torch.Tensor:
    first, there = posed(prompt)
    owner = first.pose.owner(body(first.words.noun).verts)
    return there.verts[torch.isin(owner, torch.tensor(bones))]


@pytest.mark.slow
@pytest.mark.parametrize("noun", sorted(FIGURES))
def test_all_that_are_posed_have_two_legs(noun):
    for seed in range(2):
        drawn = shipped_prior().prompted(noun, "").of_object(seed)
        assert legs_of(Body.of(drawn.words, drawn.solid), drawn.parts()) is not None, seed


def test_the_figures_of_the_words_are_figures_with_legs():
    assert FIGURES <= HANDED
    assert not FIGURES & (ROBED | FOUR_LEGGED)
    assert set(OF_FIGURES) == {*POSES, *STRAIGHT}


@pytest.mark.parametrize(
    ("prompt", "pose"),
    [
        ("a running boy", "running"),
        ("a boy running", "running"),
        ("a man running a marathon", "running"),
        ("a walking skeleton", "walking"),
        ("a man walking with a walking stick", "walking"),
        ("a sitting man", "sitting"),
        ("a man sitting on a bench", "sitting"),
        ("a kneeling knight", "kneeling"),
        ("a knight on one knee", "kneeling"),
        ("a man down on his knees", "kneeling"),
        ("a jumping ninja", "leaping"),
        ("a dancing robot", "dancing"),
        ("a squatting goblin", "crouching"),
        ("a person lying on his back", "lying"),
        ("a man sleeping on a sofa", "sleeping"),
        ("a sleeping astronaut", "sleeping"),
        ("two kneeling knights", "kneeling"),
        ("a knight holding a torch, walking", "walking"),
        ("a bronze statue of a running man", "running"),
        ("a standing man", ""),  # as it is drawn
        ("a standing robot", ""),
    ],
)
def test_a_pose_is_understood_and_its_word_is_not_left_out(prompt, pose):
    words = parse(prompt)
    assert words.pose == pose and understood(prompt)["pose"] == (pose or None)
    assert not any("ing" in word for word in words.left_out if " " not in word)


@pytest.mark.parametrize(
    "prompt",
    [
        "a boy wearing running shoes",
        "a man in running shoes",
        "a man in a sleeping bag",
        "a man with a walking stick",
        "a girl with a sleeping mask",
        "a man doing jumping jacks",
        "a knight riding a horse",
        "a walking dead zombie",
        "a man with a curled mustache",
    ],
)
def test_what_something_else_is_for_is_no_pose(prompt):
    assert parse(prompt).pose == ""


def test_running_a_shop_is_no_pose():
    assert pose_of("person", "a woman running a shop") == ("", [])
    assert pose_of("person", "a woman running a race") == ("running", ["running"])


@pytest.mark.parametrize(
    ("prompt", "left"),
    [
        ("a sitting king", "sitting"),
        ("a running princess", "running"),
        ("a kneeling witch", "kneeling"),
        ("a sleeping ghost", "sleeping"),
        ("a robot that is not running", "running"),
        ("a grazing knight", "grazing"),
    ],
)
def test_what_it_cannot_do_is_left_out_with_a_note(prompt, left):
    words = parse(prompt)
    assert words.pose == "" and left in words.left_out
    assert any(f"'{left}'" in note for note in words.notes)


@pytest.mark.slow
def test_the_feet_of_who_runs_are_one_before_the_other():
    first, there = posed("a running man")
    left, right = (of_bone("a running man", bone) for bone in SHIN)
    stride = float(right[:, 1].mean() - left[:, 1].mean())
    assert stride > 0.35 * float(there.sides[2])
    assert [forward(first.pose.bones[k]) for k in THIGH] == pytest.approx([64, -28], abs=0.1)
    assert [forward(first.pose.bones[k]) for k in SHIN] == pytest.approx([-6, -82], abs=0.1)
    assert forward(first.pose.bones[TRUNK]) == pytest.approx(-14, abs=0.1)  # its head is forward


@pytest.mark.slow
def test_who_walks_has_a_shorter_stride_than_who_runs():
    strides = []
    for prompt in ("a walking man", "a running man"):
        left, right = (of_bone(prompt, bone)[:, 1].mean() for bone in SHIN)
        strides.append(float(right - left) / float(posed(prompt)[1].sides[2]))
    assert 0.1 < strides[0] < 0.8 * strides[1]


def test_the_trunk_of_who_kneels_is_as_it_was():
    first, there = posed("a kneeling man")
    place = first.pose.bones[TRUNK].place
    torch.testing.assert_close(place.turn, torch.eye(3))
    man = body("a man")
    own = first.pose.owner(man.verts) == TRUNK
    torch.testing.assert_close(
        there.verts[own], man.verts[own] * place.scale + place.shift, atol=1e-5, rtol=0
    )


@pytest.mark.slow
def test_who_kneels_rests_on_a_knee_and_on_the_other_foot():
    first, there = posed("a kneeling man")
    foot, shin = (of_bone("a kneeling man", bone) for bone in SHIN)
    radius = figure("a person").legs.radius * first.pose.bones[TRUNK].place.scale
    ground = float(there.box[0, 2])
    assert float(foot[:, 2].amin()) == pytest.approx(ground, abs=radius)
    assert float(shin[:, 2].amin()) == pytest.approx(ground, abs=radius)
    assert float(shin[:, 1].mean()) > float(foot[:, 1].mean()) + 2 * radius
    assert forward(first.pose.bones[SHIN[0]]) == pytest.approx(0, abs=0.1)
    assert forward(first.pose.bones[SHIN[1]]) <= -90


def test_who_sits_has_straight_legs_before_it_on_the_ground():
    first, there = posed("a sitting man")
    assert len(first.pose.bones) == 3
    for bone in first.pose.bones[1:]:
        assert forward(bone) == pytest.approx(87, abs=0.2)
    trunk, legs = of_bone("a sitting man", TRUNK), of_bone("a sitting man", 1, 2)
    assert float(legs[:, 1].amin()) < float(trunk[:, 1].amin())
    low = float(there.box[0, 2])
    tall = float(there.sides[2])
    assert float(trunk[:, 2].amin()) < low + 0.1 * tall
    assert float(legs[:, 2].amax()) < low + tall / 2


@pytest.mark.parametrize("prompt", ["a sitting man", "a crouching man"])
def test_both_sides_are_alike_where_both_legs_are(prompt):
    first, _ = posed(prompt)
    _, *limbs = first.pose.bones
    half = len(limbs) // 2
    flip = torch.diag(torch.tensor([-1.0, 1.0, 1.0]))
    for left, right in zip(limbs[:half], limbs[half:], strict=True):
        torch.testing.assert_close(flip @ left.place.turn @ flip, right.place.turn)
        start, end = (one.out(torch.zeros(1, 3)) for one in (left, right))
        middle = first.pose.bones[TRUNK].out(torch.zeros(1, 3))[0, 0]
        assert float(start[0, 0] + end[0, 0]) == pytest.approx(2 * float(middle), abs=0.05)


def test_who_crouches_is_lower_than_who_stands_with_its_feet_under_it():
    first, there = posed("a crouching man")
    scale = first.pose.bones[TRUNK].place.scale
    assert float(there.sides[2]) < 0.95 * scale * float(body("a man").sides[2])
    shins, trunk = of_bone("a crouching man", *SHIN), of_bone("a crouching man", TRUNK)
    assert float(trunk[:, 1].amin()) - 0.3 < float(shins[:, 1].mean()) < float(trunk[:, 1].amax())


@pytest.mark.parametrize(
    "prompt", ["a lying man", pytest.param("a sleeping man", marks=pytest.mark.slow)]
)
def test_who_lies_is_on_its_back_and_of_one_bone(prompt):
    first, there = posed(prompt)
    (whole,) = first.pose.bones
    up = whole.place.turn @ torch.tensor([0.0, 0.0, 1.0])
    face = whole.place.turn @ torch.tensor([0.0, -1.0, 0.0])
    assert up[1] > 0.85 and face[2] > 0.85
    assert there.sides[1] > there.sides[2]


def test_who_lies_is_as_low_as_it_gets():
    _, there = posed("a lying man")
    middle = float(there.verts.mean(0)[2] - there.box[0, 2])
    for degree in (-6, 6):
        turn = torch.tensor(math.radians(degree))
        y, z = there.verts[:, 1], there.verts[:, 2]
        height = turn.sin() * y + turn.cos() * z
        assert middle < float(height.mean() - height.amin())


@pytest.mark.slow
def test_who_sleeps_has_closed_eyes():
    first, _ = posed("a sleeping man")
    assert first.rest.areas().each != composed("a lying man").made.things[0].rest.areas().each


@pytest.mark.slow
def test_a_leg_stays_at_its_hip_and_a_shin_at_its_knee():
    for prompt in ("a running man", "a dancing robot"):
        first, _ = posed(prompt)
        legs = figure(f"a {first.words.noun}").legs
        trunk, *limbs = first.pose.bones
        for side, (thigh, shin) in zip((1, -1), (limbs[:2], limbs[2:]), strict=True):
            flip = torch.tensor([[float(side), 1.0, 1.0]])
            knee = legs.halfway * flip
            torch.testing.assert_close(thigh.out(knee), shin.out(knee), atol=1e-5, rtol=0)
            hip = legs.hip * flip
            away = float((thigh.out(hip) - trunk.out(hip)).norm()) / trunk.place.scale
            assert away < 2 * legs.radius  # out of the coat, along itself


@pytest.mark.slow
def test_legs_that_are_alike_come_out_equally_far_and_others_each_by_itself():
    one = figure("a chef")
    alike = Limb(degrees(60), degrees(0))
    bare, clothed = both_poses(one.legs, (alike, alike), Placement.of(), one.distances)
    shifts = [bare.bones[k].out(one.legs.hip[None])[0, 1:] for k in (1,)]
    other = bare.bones[3].out((one.legs.hip * torch.tensor([-1.0, 1.0, 1.0]))[None])[0, 1:]
    torch.testing.assert_close(shifts[0], other)
    upright = Limb(degrees(0), degrees(0))
    bare, _ = both_poses(one.legs, (alike, upright), Placement.of(), one.distances)
    right = one.legs.hip * torch.tensor([-1.0, 1.0, 1.0])
    torch.testing.assert_close(bare.bones[3].out(right[None])[0], right)
    assert len(clothed.bones) == 5


@pytest.mark.slow
def test_a_hem_stays_on_the_trunk():
    for noun in ("doll", "chef"):
        one = figure(f"a {noun}")
        plain = legs_of(body(noun), _parts(noun))
        assert one.legs.box[1, 2] < plain.box[1, 2]
        assert replace(one.legs, box=plain.box).crotch == plain.crotch
        assert one.legs.box[1, 2] > plain.crotch - HIDDEN * (plain.crotch - plain.sole)
    own = posed("a running doll")[0].pose.owner(body("doll").verts)
    assert bool((own[body("doll").among("dress", "apron")] == TRUNK).all())


def _parts(noun: str):
    return shipped_prior().prompted(noun, "").of_object(0).parts()


@pytest.mark.parametrize(
    "prompt",
    [
        "a running man",
        pytest.param("a kneeling man", marks=pytest.mark.slow),
        pytest.param("a sleeping man", marks=pytest.mark.slow),
    ],
)
def test_a_posed_figure_is_known_where_its_surface_is(prompt):
    first, there = posed(prompt)
    parts = first.parts()
    assert isinstance(parts, PosedParts)
    away = parts.distances(there.verts).amin(1).abs()
    assert float((away < 0.02).float().mean()) > 0.93  # all but what is hidden at joints


@pytest.mark.parametrize(
    "prompt", ["a running man", pytest.param("a crouching man", marks=pytest.mark.slow)]
)
def test_a_posed_figure_is_closed_and_of_one_component(prompt):
    import trimesh

    verts, faces = assembled(composed(prompt).parts(), True, 0.01, lambda _: None)
    mesh = trimesh.Trimesh(verts.numpy(), faces.numpy(), process=False)
    assert mesh.is_watertight
    assert sum(one.volume > 1e-4 for one in mesh.split(only_watertight=False)) == 1


@pytest.mark.slow
def test_shoes_go_with_the_legs_and_a_shirt_with_the_trunk():
    boy, *worn = composed("a running boy wearing blue sneakers and a red jacket").made.things
    assert isinstance(boy, Posed) and {one.words.noun for one in worn} == {"sneaker", "jacket"}
    for one in worn:
        assert isinstance(one, Posed)
        for own, other in zip(boy.pose.bones, one.pose.bones, strict=True):
            torch.testing.assert_close(own.place.turn, other.place.turn)
            torch.testing.assert_close(own.place.shift, other.place.shift)
        wide = one.pose.bones[1].regions[0].box[1] - boy.pose.bones[1].regions[0].box[1]
        beyond = CLOTHED if one.words.noun == "sneaker" else 0.0
        assert float(wide[0]) == pytest.approx(beyond, abs=1e-6)
        ball = one.pose.bones[2].regions[0].capsules[0][2]
        own = boy.pose.bones[2].regions[0].capsules[0][2]
        assert (ball > own + 0.9 * PADDED) == (one.words.noun == "sneaker")


@pytest.mark.slow
def test_in_a_dress_one_does_not_run_but_sleeps():
    guidance = composed("a woman in a red dress running")
    assert [one.words.noun for one in guidance.made.things] == ["person", "dress"]
    assert not any(isinstance(one, Posed) for one in guidance.made.things)
    assert guidance.left_out()[-1] == f"person running: {poses.IN_DRESS}"
    asleep = composed("a sleeping woman wearing a red dress and a cowboy hat")
    assert [isinstance(one, Posed) for one in asleep.made.things] == [True, True, False]
    assert not any(poses.IN_DRESS in note for note in asleep.left_out())


def test_without_two_legs_the_pose_is_left_out_with_a_note(monkeypatch):
    monkeypatch.setattr(Figure, "of", classmethod(lambda cls, thing, body: None))
    drawn = shipped_prior().prompted("a running man", "").of_object(0)
    assert isinstance(drawn, Composed)
    assert drawn.left_out() == (f"person running: {poses.UNPOSED}",)
    assert "four" not in poses.UNPOSED
    assert not isinstance(drawn.made.things[0], Posed)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("prompt", "plain"),
    [
        ("a man sitting on a chair", "a man on a chair"),
        ("a running knight riding a horse", "a knight riding a horse"),
    ],
)
def test_who_sits_on_something_or_rides_it_is_posed_once(prompt, plain):
    own, other = composed(prompt), composed(plain)
    first, expected = own.made.things[0], other.made.things[0]
    assert isinstance(first, Posed) and not isinstance(first.rest, Posed)
    for one, two in zip(first.pose.bones, expected.pose.bones, strict=True):
        assert torch.equal(one.place.turn, two.place.turn)
        assert torch.equal(one.place.shift, two.place.shift)
    for one, two in zip(own.made.places, other.made.places, strict=True):
        assert torch.equal(one[0].shift, two[0].shift)
    note = f"knight running: {poses.SEATED}"
    assert (note in own.left_out()) == ("running" in prompt)
    assert not any(poses.SEATED in text for text in own.left_out() if text != note)


@pytest.mark.slow
def test_who_lies_on_a_bed_does_not_sit_there():
    man, bed = composed("a man lying on a bed").made.things
    assert isinstance(man, Posed) and len(man.pose.bones) == 1
    assert bed.words.noun == "bed"


@pytest.mark.slow
def test_on_a_sofa_one_lies_from_left_to_right():
    man, sofa = composed("a man lying on a sofa").made.things
    assert isinstance(man, Posed) and sofa.words.noun == "sofa"
    (whole,) = man.pose.bones
    assert float((whole.place.turn @ -DOWN)[0].abs()) > 0.85
    bed = composed("a man lying on a bed").made.things[0]
    assert float((bed.pose.bones[0].place.turn @ -DOWN)[0].abs()) < 1e-6


@pytest.mark.slow
def test_in_a_bathtub_one_is_as_before_with_a_note():
    guidance = composed("a man sitting in a bathtub")
    assert not any(isinstance(one, Posed) for one in guidance.made.things)
    assert guidance.left_out() == (f"person sitting: {poses.WITHIN}",)


@pytest.mark.slow
def test_what_is_held_or_worn_on_the_head_goes_with_the_trunk():
    guidance = composed("a sleeping knight holding a torch")
    knight, torch_ = guidance.made.things
    assert isinstance(knight, Posed)
    ((own,), (there,)) = guidance.made.places
    rest = body("a knight")
    plain = held(Body.of(torch_.words, torch_.solid, torch_.parts()), rest)
    expected = own.of_copy(knight.pose.bones[TRUNK].place).of_copy(plain)
    torch.testing.assert_close(there.turn, expected.turn)
    torch.testing.assert_close(there.shift, expected.shift, atol=0.05, rtol=0)
    assert abs(float((there.turn @ DOWN)[1])) > 0.85  # the torch lies, too
    guidance = composed("a sleeping woman wearing a red dress and a cowboy hat")
    hat = guidance.made.places[2][0]
    assert float((hat.turn @ -DOWN)[1]) > 0.85


@pytest.mark.slow
def test_several_are_in_one_pose():
    guidance = composed("two kneeling knights")
    (knight,), (places,) = guidance.made.things, guidance.made.places
    assert isinstance(knight, Posed) and len(places) == 2


def test_a_carried_body_is_placed_with_what_it_carries():
    first = body("a man")
    lying = Placement(2.0, torch.tensor([0.1, 0.2, 0.3]), torch.eye(3)[[0, 2, 1]] * -1)
    there = replace(first, verts=lying.out(first.verts), standing=first, carried=lying)
    by = Placement(0.5, torch.tensor([1.0, 0.0, -1.0]), torch.eye(3)[[1, 0, 2]] * -1)
    moved = there.placed(by)
    torch.testing.assert_close(moved.carried.out(moved.standing.verts), moved.verts)
