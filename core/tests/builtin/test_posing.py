"""Who sits and who rides: their legs, their pose, and what bears them."""

import math
from dataclasses import replace

import numpy as np
import pytest
import torch

from core.camera import Cameras
from core.geometry.mesh import component_labels, health
from core.geometry.union import Region, clipped, rounded_box, union
from core.guidance.builtin.composition.clothes.clothing import dressed
from core.guidance.builtin.composition.placing.arranged import arranged
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.poses.legs import HANGING, OFF_AXIS, Legs, legs_of
from core.guidance.builtin.composition.poses.posing import Bone, Pose, Posed, joint
from core.guidance.builtin.composition.poses.sitting import posture_of, seated
from core.guidance.builtin.words.vocabulary import parse
from core.guidance.guidance import Views
from core.tests.drawn_things import body, box, composed, shipped_prior

QUARTER = torch.tensor([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])  # down to the front


def legs(prompt: str) -> Legs | None:
    parts = shipped_prior().prompted(prompt, "").of_object(0).parts()
    assert parts is not None
    return legs_of(body(prompt), parts)


def placed(prompt: str) -> tuple[Posed, Body, Body]:
    """Who sits, in the pose and in the composition, and what it sits on."""
    guidance = composed(prompt)
    first, other = guidance.made.things
    assert isinstance(first, Posed)
    (here,), (there,) = guidance.made.places
    own = first.pose.body(Body.of(first.words, first.solid)).placed(here)
    return first, own, Body.of(other.words, other.solid, other.parts()).placed(there)


def angle_of_knee(posed: Posed, side: int) -> float:
    """Between a thigh and its shin, in degrees: 180 is a straight leg."""
    _, *limbs = posed.pose.bones
    thigh, shin = limbs[:2] if side > 0 else limbs[2:]
    down = torch.tensor([0.0, 0.0, -1.0])
    way = float((thigh.place.turn @ down) @ (shin.place.turn @ down))
    return 180 - math.degrees(math.acos(max(min(way, 1), -1)))


@pytest.mark.parametrize(
    "who", ["a person", "an astronaut", "a robot", "a ninja", "a viking", "a clown", "a goblin"]
)
def test_legs_are_found_below_the_trunk(who):
    found, whole = legs(who), body(who)
    assert found is not None
    low, high = whole.box[:, 2].tolist()
    assert low + 0.08 * (high - low) < found.crotch < low + 0.4 * (high - low)
    assert found.sole == pytest.approx(low, abs=1e-4)
    assert 0 < found.middle[0] < found.box[1, 0]
    below = whole.without(*HANGING)
    below = below[below[:, 2] < found.crotch - 0.02]
    inside = (below[:, 0].abs() < found.box[1, 0]) & (below[:, 1] > found.box[0, 1])
    assert float(inside.float().mean()) > 0.7  # the rest are hands and an axe


@pytest.mark.parametrize(
    "who", ["a king", "a princess", "a wizard", "a mermaid", "a cat", "a snowman", "a centaur"]
)
def test_robes_tails_and_animals_have_no_legs_to_bend(who):
    assert legs(who) is None


@pytest.mark.parametrize(
    ("verb", "relation", "noun", "posture"),
    [
        ("sitting", "on", "boulder", "sits"),
        ("", "on", "chair", "sits"),
        ("standing", "on", "chair", ""),
        ("", "on", "boulder", ""),
        ("riding", "on", "horse", "rides"),
        ("standing", "on", "horse", ""),
        ("", "on", "motorcycle", "rides"),
        ("riding", "on", "surfboard", ""),
        ("sitting", "on", "sled", "sits"),
        ("", "in", "boat", "sits"),
        ("sitting", "in", "mug", ""),
        ("", "wears", "hat", ""),
        ("riding", "on", "griffin", "rides"),
        ("riding", "on", "centaur", "rides"),
        ("riding", "on", "pegasus", "rides"),
    ],
)
def test_what_one_does_on_a_thing_is_by_the_word_and_by_the_thing(verb, relation, noun, posture):
    assert posture_of(verb, relation, noun) == posture


def test_a_companion_has_the_word_of_what_one_does_there():
    assert parse("a man sitting on a bench").companions[0].verb == "sitting"
    assert parse("an astronaut riding a horse").companions[0].verb == "riding"
    assert parse("a man on a bench").companions[0].verb == ""


def test_who_drives_what_is_open_sits_in_it():
    for prompt in ("a man driving a golf cart", "a man drives a go-kart"):
        assert parse(prompt).companions[0].relation == "in"
    assert parse("a man riding a golf cart").companions[0].relation == "on"


def test_what_is_on_a_bone_is_found_in_the_rest_pose_again():
    half = torch.tensor([0.1, 0.1, 0.5])
    region = Region((torch.tensor([-0.2, -0.2, -0.6]), torch.tensor([0.2, 0.2, 0.0])))
    turn = joint(torch.zeros(3), QUARTER, torch.zeros(3))
    pose = Pose((Bone((region,), Placement.of(), within=False), Bone((region,), turn)))

    def box(points):
        return ((points.abs() - half).amax(1))[:, None]

    rest = (torch.rand(500, 3, generator=torch.Generator().manual_seed(0)) - 0.5) * 2 * half
    moved = pose.out(rest)
    assert (pose.distances(box)(moved) <= 1e-6).all()
    lower = rest[:, 2] < 0
    torch.testing.assert_close(turn.into(moved[lower]), rest[lower])
    torch.testing.assert_close(moved[~lower], rest[~lower])
    assert float(moved[lower][:, 1].amin()) < -0.4  # it is in front now
    gone = torch.tensor([[0.0, 0.0, -0.4]])
    assert float(pose.distances(box)(gone)) > 0.1 > float(box(gone))
    assert pose.bone_at(box, moved).eq(lower.long()).float().mean() > 0.9


def test_a_mesh_is_cut_by_regions_into_closed_meshes():
    whole = rounded_box(np.array([0.5, 0.5, 0.5]), 0.0, 1.0, 8)
    low, high = torch.tensor([0.0, -1.0, -1.0]), torch.tensor([1.0, 1.0, 1.0])
    ball = (torch.zeros(3), torch.zeros(3), 0.2)
    inside, outside = (clipped(whole, [Region((low, high), (ball,))], one) for one in (True, False))
    for verts, faces in (inside, outside):
        assert health(verts, faces)["closed"]
    assert float(inside[0][:, 0].amin()) == pytest.approx(-0.2, abs=0.01)  # the ball
    assert float(outside[0][:, 0].amax()) == pytest.approx(0.0, abs=0.01)
    far = Region((high + 1, high + 2))
    assert not len(clipped(whole, [far], True)[1])


def test_a_crumb_that_is_cut_off_is_left_out_and_a_small_mesh_is_not():
    crate = box([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])
    far, near = torch.tensor([0.9, 2.0, 2.0]), torch.tensor([-1.0, -1.0, -1.0])
    regions = (Region((near, far)),)  # a slab of a tenth is outside
    for least, left in ((0.05, True), (0.2, False)):
        _, faces = clipped((crate.verts, crate.faces), regions, False, least)
        assert (len(faces) > 0) == left
    _, faces = clipped((crate.verts, crate.faces), regions, True, 0.2)
    assert len(faces)
    beside = (Region((near - 5, near)),)
    _, faces = clipped((crate.verts * 0.1, crate.faces), beside, False, 0.2)
    assert len(faces) == len(crate.faces)


def test_the_bottom_is_on_the_seat_and_the_shins_are_before_it():
    posed, man, bench = placed("a man sitting on a bench")
    found = legs("a man")
    assert found is not None
    for side in (1, -1):
        assert 80 < angle_of_knee(posed, side) < 110
    seat = bench.of_parts("seat")
    top = float(seat[:, 2].amax())
    owner = posed.pose.owner(Body.of(posed.words, posed.solid).verts)
    trunk, shins = man.verts[owner == 0], man.verts[(owner == 2) | (owner == 4)]
    assert float(trunk[:, 2].amin()) == pytest.approx(top, abs=0.05)
    assert bench.box[0, 0] < trunk[:, 0].amin() and trunk[:, 0].amax() < bench.box[1, 0]
    assert float(shins[:, 1].mean()) < float(seat[:, 1].amin())
    assert float(shins[:, 2].amin()) < top - 0.1
    assert float(shins[:, 2].amin()) > float(bench.box[0, 2]) - 0.05  # above the ground
    left, right = (shins[side * shins[:, 0] > 0] for side in (1, -1))
    assert len(left) > 50 and len(right) > 50  # both are there


@pytest.mark.slow
def test_the_legs_of_a_rider_are_on_both_sides_of_the_mount():
    posed, rider, horse = placed("a man riding a horse")
    owner = posed.pose.owner(Body.of(posed.words, posed.solid).verts)
    shins = rider.verts[(owner == 2) | (owner == 4)]
    trunk = rider.verts[owner == 0]
    back = horse.verts[(horse.verts[:, :2].abs() < 0.1).all(1)][:, 2].amax()
    assert float(trunk[:, 2].amin()) == pytest.approx(float(back), abs=0.1)
    assert shins[:, 0].amin() < -0.1 and shins[:, 0].amax() > 0.1
    assert float(shins[:, 2].mean()) < float(back)


@pytest.mark.slow
def test_short_legs_are_straight_before_who_sits():
    posed, _, _ = placed("a gnome sitting on a mushroom")
    assert len(posed.pose.bones) == 3
    for bone in posed.pose.bones[1:]:
        assert float((bone.place.turn @ torch.tensor([0.0, 0.0, -1.0]))[1]) < -0.9


@pytest.mark.slow
def test_who_stands_is_as_before():
    guidance = composed("a ninja standing on a chair")
    assert not any(isinstance(thing, Posed) for thing in guidance.made.things)


@pytest.mark.parametrize(
    "who",
    [
        pytest.param("a king", marks=pytest.mark.slow),
        pytest.param("a queen", marks=pytest.mark.slow),
        pytest.param("a witch", marks=pytest.mark.slow),
    ],
)
def test_in_a_robe_one_is_as_deep_in_a_throne_as_if_one_sat(who: str):
    guidance = composed(f"{who} on a throne")
    sitter, throne = (
        Body.of(thing.words, thing.solid).placed(place)
        for thing, (place,) in zip(guidance.made.things, guidance.made.places, strict=True)
    )
    assert not isinstance(guidance.made.things[0], Posed)
    assert float(sitter.box[0, 2]) < float(throne.of_parts("cushion")[:, 2].amax())
    assert float(sitter.box[0, 1]) < float(throne.of_parts("cushion")[:, 1].amin())


@pytest.mark.slow
def test_a_skirt_is_before_the_seat_that_it_is_sunk_in():
    guidance = composed("a woman in a red dress sitting on a chair")
    assert not any(isinstance(thing, Posed) for thing in guidance.made.things)
    _, dress, chair = (
        Body.of(thing.words, thing.solid).placed(place)
        for thing, (place,) in zip(guidance.made.things, guidance.made.places, strict=True)
    )
    seat = chair.of_parts("seat")
    assert float(dress.box[0, 2]) < float(seat[:, 2].amin())
    assert float(dress.box[0, 1]) < float(seat[:, 1].amin()) < float(dress.box.mean(0)[1])


@pytest.mark.slow
def test_boots_go_with_the_legs_that_wear_them():
    guidance = composed("a robot wearing boots sitting on a bench")
    found, boots = legs("a robot"), next(t for t in guidance.made.things if t.words.noun == "boot")
    assert isinstance(boots, Posed) and found is not None
    verts = Body.of(boots.words, boots.solid).verts
    owner = boots.pose.owner(verts)
    assert len(verts) and not bool((owner[verts[:, 2] < found.crotch] == 0).any())


def test_what_is_worn_is_known_where_it_comes_to_lie():
    guidance = shipped_prior().prompted("a robot wearing boots sitting on a bench", "")
    drawn = [thing.of_object(0) for thing in guidance.things]
    bodies = [Body.of(thing.words, thing.solid) for thing in drawn]
    drawn, bodies, _ = dressed(drawn, bodies, guidance.relations)
    things, forms = seated(drawn, bodies, guidance.relations)
    at = next(k for k, thing in enumerate(things) if thing.words.noun == "boot")
    assert isinstance(things[at], Posed)
    torch.testing.assert_close(forms[at].verts, things[at].pose.out(bodies[at].verts))
    assert not torch.equal(forms[at].verts, bodies[at].verts)


@pytest.mark.slow
def test_who_drives_is_below_the_roof():
    posed, man, cart = placed("a man driving a golf cart")
    assert len(posed.pose.bones) == 3
    assert float(man.box[1, 2]) < float(cart.of_parts("roof")[:, 2].amax())
    assert float(man.box[0, 2]) > float(cart.box[0, 2])


def test_a_heap_in_a_boat_is_not_posed():
    drawn = [shipped_prior().prompted("a man", "").of_object(0)] * 2
    for count in (3, 1):
        words = replace(parse("a man in a boat"), count=count)
        man = replace(body("a man"), words=words)
        things, bodies = seated(drawn, [man, body("a boat")], ["in"])
        assert (things[0] is drawn[0], bodies[0].rests is None) == (count == 3, count == 3)


@pytest.mark.slow
def test_who_waves_has_legs_about_an_axis_of_their_own():
    waving = shipped_prior().prompted("a man sitting on a bench", "").of_object(1)
    man = waving.made.things[0]
    assert isinstance(man, Posed)
    whole = Body.of(man.words, man.solid)
    found = legs_of(whole, man.rest.parts())
    assert found is not None and abs(found.axis) > OFF_AXIS
    owner = man.pose.owner(whole.verts)
    left, right = (whole.verts[(owner == k) | (owner == k + 1), 0] for k in (1, 3))
    assert float(left.amin()) > found.axis - 0.02 and float(right.amax()) < found.axis + 0.02
    for side in (1, -1):
        assert 80 < angle_of_knee(man, side) < 110


def test_a_pose_goes_with_the_thing():
    posed, _, _ = placed("a man sitting on a bench")
    points = Body.of(posed.words, posed.solid).verts
    by = torch.tensor([0.3, -0.1, 0.2])
    torch.testing.assert_close(posed.pose.moved(by).out(points + by), posed.pose.out(points) + by)


def test_a_hand_is_where_it_was_before_one_sat():
    man, flag = body("a man"), body("a flag")
    sunk = replace(man, verts=man.verts * torch.tensor([0.5, 1.0, 0.5]), standing=man)
    (own,), (there,) = arranged(sunk, [("holds", flag)])
    (alone,), (before,) = arranged(man, [("holds", flag)])
    found, expected = there.shift - own.shift, before.shift - alone.shift
    torch.testing.assert_close(found / own.scale, expected / alone.scale)


def test_one_who_sits_is_closed_and_of_one_component_without_a_strut():
    parts = composed("a man sitting on a bench").parts()
    assert parts is not None
    verts, faces = union([parts.surface_of(k) for k in range(len(parts.components))], strut=0.0)
    assert health(verts, faces)["closed"] and component_labels(faces, len(verts))[0] == 1


def test_a_bent_leg_is_painted_as_it_is_in_the_rest_pose():
    posed, _, _ = placed("a man sitting on a bench")
    rest, bent = posed.rest.area_fields(), posed.area_fields()
    assert rest is not None and bent is not None and bent.each == rest.each
    verts = Body.of(posed.words, posed.solid).verts
    inner = torch.stack([bone.gap(verts) for bone in posed.pose.bones], 1).abs().amin(1) > 0.05
    verts = verts[inner]
    before = rest.drawn(verts)[1].argmax(1)
    after = bent.drawn(posed.pose.out(verts))[1].argmax(1)
    assert float((before == after).float().mean()) > 0.97


def test_what_stands_out_of_a_bent_leg_is_as_high_as_in_the_rest_pose():
    posed, _, _ = placed("a man sitting on a bench")
    rest = posed.rest.area_fields()
    assert rest is not None
    high = rest._replace(heights=lambda points, area: points[:, 2] + area)
    verts = Body.of(posed.words, posed.solid).verts
    inner = torch.stack([bone.gap(verts) for bone in posed.pose.bones], 1).abs().amin(1) > 0.05
    verts = verts[inner]
    there = posed.pose.out(verts)
    assert (there - verts).norm(dim=1).max() > 0.2  # some of it moves
    found = posed.pose.heights(high)(there, torch.ones(len(verts)).long())
    right = (found - verts[:, 2] - 1).abs() < 1e-4
    assert float(right.float().mean()) > 0.97


def test_a_picture_of_a_bent_leg_is_seen_in_the_rest_pose():
    posed, _, _ = placed("a man sitting on a bench")
    parts = posed.rest.parts()
    assert parts is not None
    verts = Body.of(posed.words, posed.solid).verts
    owner = posed.pose.owner(verts)
    shin = verts[(owner == 2) & (posed.pose.bones[2].gap(verts) < -0.03)][:64]
    surface = torch.zeros(1, 7, 8, 8)
    surface[:, 3] = 1.0
    surface[0, 4:] = posed.pose.bones[2].place.out(shin).T.reshape(3, 8, 8)
    at_rest = posed._at_rest(surface, parts)[0, 4:].reshape(3, 64).T
    assert float((at_rest - shin).norm(dim=1).quantile(0.9)) < 1e-4
    z, t, cameras = (
        torch.zeros(1, 4, 64, 64),
        torch.tensor([300]),
        Cameras.orbit([0.0], [0.0], 3, 40),
    )
    wide = torch.nn.functional.interpolate(surface, size=64)
    found = posed.predict(z, t, Views(cameras, wide))
    own = posed.rest.predict(z, t, Views(cameras, posed._at_rest(wide, parts)))
    torch.testing.assert_close(found.cond, own.cond)
    assert not torch.allclose(found.cond, posed.rest.predict(z, t, Views(cameras, wide)).cond)
