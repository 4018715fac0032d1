"""Animals in the poses that a prompt states."""

import math
from dataclasses import replace

import pytest
import torch

from core.geometry.fan import Fan
from core.geometry.mesh import NORMAL_RADIUS
from core.geometry.parts.assembly import assembled
from core.geometry.union import clipped
from core.guidance.builtin.composition.composed import OWN_POSE, Composed
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.poses import posed as poses
from core.guidance.builtin.composition.poses.animal_poses import FRONT, HIND, POSES, Animal
from core.guidance.builtin.composition.poses.posed import UNPOSED
from core.guidance.builtin.composition.poses.posing import Bone, Pose, Posed, PosedParts
from core.guidance.builtin.composition.poses.quadruped import Quadruped
from core.guidance.builtin.guidance import PromptedBuiltin
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.painted_solid import IN_EYES, LID
from core.guidance.builtin.palette import looks
from core.guidance.builtin.words.phrases.poses import FOUR_LEGGED, GRAZING, LYING, SITTING, pose_of
from core.guidance.builtin.words.vocabulary import parse, understood
from core.render.normals import face_normals, vertex_normals
from core.tests.drawn_things import body, composed, shipped_prior


def at_rest(prompt: str, seed: int = 0) -> PromptedBuiltin:
    """Who is drawn to sit or lie, before that: a network's, whose legs can be folded."""
    prompted = shipped_prior().prompted(prompt, "")
    words = replace(prompted.words, pose="lying")
    return PromptedBuiltin(prompted.builtin, words, prompted.negative).of_object(seed)


def resting(prompt: str) -> Body:
    drawn = at_rest(prompt)
    assert drawn.solid is not None
    return Body.of(drawn.words, drawn.solid)


def animal(prompt: str, folded: bool = False) -> Animal:
    drawn = at_rest(prompt) if folded else shipped_prior().prompted(prompt, "").of_object(0)
    found = Animal.of(drawn, resting(prompt) if folded else body(prompt))
    assert found is not None
    return found


def posed(prompt: str) -> tuple[Posed, Body]:
    """The posed first thing of a prompt, and its body."""
    first = composed(prompt).made.things[0]
    assert isinstance(first, Posed)
    assert first.solid is not None
    return first, first.pose.body(Body.of(first.words, first.solid))


def pitch(bone: Bone) -> float:
    """By how many degrees a bone's front goes up, or a leg forward."""
    return math.degrees(math.atan2(float(bone.place.turn[1, 2]), float(bone.place.turn[2, 2])))


def height(of: Body) -> float:
    return float(of.sides[2] * of.metres)


def four_legs(noun: str, seed: int, folded: bool = True) -> Quadruped | None:
    drawn = at_rest(noun, seed) if folded else shipped_prior().prompted(noun, "").of_object(seed)
    return Quadruped.of(Body.of(drawn.words, drawn.solid), drawn.parts())


@pytest.mark.parametrize(
    "noun",
    [
        "dog",
        "corgi",
        pytest.param("horse", marks=pytest.mark.slow),
        pytest.param("elephant", marks=pytest.mark.slow),
    ],
)
def test_legs_are_found_under_the_trunk(noun):
    found, whole = four_legs(noun, 0), resting(f"a {noun}")
    assert found is not None
    low, high = whole.box.tolist()
    for leg in (found.front, found.hind):
        assert low[2] < leg.hoof <= float(leg.high[2]) < found.spine < high[2]
        assert float(leg.low[0]) < leg.middle[0] < float(leg.high[0]) <= high[0] + 0.05
        assert leg.radius < leg.middle[0] + 0.05
        assert float(leg.high[1] - leg.low[1]) < 3.5 * leg.radius
        assert found.belly < float(leg.joint[2]) < leg.above
    assert found.front.high[1] < found.hind.low[1]
    assert low[1] < found.front.middle[1] < found.hind.middle[1] < high[1]


def test_what_is_around_a_hoof_ends_where_the_belly_hangs_lower_than_the_leg_begins():
    found = four_legs("bear", 0)
    assert found is not None
    assert found.front.hoof < float(found.front.high[2]) - 0.02


@pytest.mark.slow
@pytest.mark.parametrize("noun", sorted(FOUR_LEGGED))
def test_all_that_are_posed_have_four_legs(noun):
    for seed in range(2):
        assert four_legs(noun, seed) is not None, seed
        assert four_legs(noun, seed, folded=False) is not None, seed


def test_what_sits_or_crawls_has_none():
    assert four_legs("rabbit", 0) is None
    assert four_legs("snake", 0) is None


@pytest.mark.parametrize(
    ("prompt", "pose"),
    [
        ("a sitting dog", "sitting"),
        ("a dog that is sitting", "sitting"),
        ("a dog lying down", "lying"),
        ("a sleeping cat on a red cushion", "sleeping"),
        ("a cat asleep on a sofa", "sleeping"),
        ("a cat asleep", "sleeping"),
        ("a dog seated", "sitting"),
        ("a curled up fox", "sleeping"),
        ("a corgi sitting on a skateboard", "sitting"),
        ("a bear standing on its hind legs", "rearing"),
        ("a horse on its hind legs", "rearing"),
        ("a rearing horse", "rearing"),
        ("a galloping horse", "running"),
        ("a walking elephant", "walking"),
        ("a leaping deer", "leaping"),
        ("a howling wolf", "howling"),
        ("a roaring lion", "roaring"),
        ("a grazing cow", "grazing"),
        ("a corgi on a skateboard", ""),
        ("a corgi riding a skateboard", ""),
        ("a standing bear", ""),
        ("a sitting rabbit", ""),  # as it is drawn
        ("a standing owl", ""),
        ("a perched owl", ""),
        ("a flying bat", ""),
        ("a swimming shark", ""),
        ("a flying dragon", "flying"),
    ],
)
def test_a_pose_is_understood_and_nothing_is_left_out(prompt, pose):
    words = parse(prompt)
    assert (words.pose, words.left_out) == (pose, ())
    assert understood(prompt)["pose"] == (pose or None)


@pytest.mark.parametrize(
    ("prompt", "left"),
    [
        ("a jumping dolphin", "jumping"),
        ("a sitting snake", "sitting"),
        ("a grazing lion", "grazing"),
        ("a dog that is not sitting", "sitting"),
        ("a standing rabbit", "standing"),
    ],
)
def test_what_it_cannot_do_is_left_out_with_a_note(prompt, left):
    words = parse(prompt)
    assert words.pose == "" and left in words.left_out
    assert any(f"'{left}'" in note for note in words.notes)


def test_another_thing_s_name_is_no_pose():
    assert parse("running shoes").pose == parse("a dog with a walking stick").pose == ""


def test_a_companion_has_a_pose_of_its_own():
    (horse,) = parse("a knight riding a rearing horse").companions
    assert horse.words.pose == "rearing"
    (dog,) = parse("a cat and a sleeping dog").companions
    assert dog.words.pose == "sleeping"
    assert parse("a cat and a sleeping dog").pose == ""


def test_the_animals_of_the_words_are_animals():
    animals = {*GROUPS["Animals"], *GROUPS["Wild Animals"], "griffin"}
    assert animals >= FOUR_LEGGED | SITTING | LYING and FOUR_LEGGED >= GRAZING
    assert not FOUR_LEGGED & (SITTING | LYING) and not SITTING & LYING
    assert set(POSES) == {pose for pose in POSES if pose_of("pegasus", pose)[0] == pose}


def test_who_sits_is_on_its_rump_and_on_upright_front_legs():
    _, dog = posed("a sitting dog")
    trunk, *legs = composed("a sitting dog").made.things[0].pose.bones
    assert 30 < pitch(trunk) < 65
    assert [round(pitch(leg)) for leg in legs[:2]] == [0, 0]
    assert all(pitch(leg) > 80 for leg in legs[2:])
    owner = composed("a sitting dog").made.things[0].pose.owner(resting("a dog").verts)
    low = [float(dog.verts[owner == k, 2].amin()) for k in range(5)]
    ground, tall = min(low), float(dog.sides[2])
    assert all(z - ground < 0.06 * tall for z in (low[0], *low[1:3]))  # rump and front feet
    assert height(dog) > 1.05 * height(resting("a dog"))


def test_a_front_leg_goes_on_up_to_where_it_comes_out_of_the_trunk():
    trunk, leg, *_ = composed("a sitting dog").made.things[0].pose.bones
    ((_, end, _),) = leg.regions[0].capsules
    shoulder = animal("a dog").pairs[FRONT].joint[None]
    assert float(end[2]) > float(shoulder[0, 2]) + 0.1
    assert float(leg.place.out(end[None])[0, 2]) >= float(trunk.place.out(shoulder)[0, 2])


@pytest.mark.slow
def test_what_comes_out_of_the_trunk_is_as_the_leg_and_not_as_what_is_around_it():
    """The mane and the body are both in the trunk there, and would both end at the leg's rim."""
    first = shipped_prior().prompted("a sitting lion", "").of_object(1).made.things[0]
    lion = Animal.of(first.rest, Body.of(first.words, first.solid))
    assert isinstance(first, Posed) and lion is not None
    leg, bones = lion.pairs[FRONT], first.pose.bones
    angle = torch.linspace(0, 2 * math.pi, 40)
    rim = torch.stack([angle.cos(), angle.sin()], 1) * leg.radius
    up = leg.high[2] + 0.15 * torch.linspace(0, 1, 8).repeat(5)
    points = bones[1].out(torch.cat([leg.middle + rim, up[:, None]], 1))
    own = [list(looks("lion")).index(name) for name in ("body", "mane")]
    open_ended = Pose((bones[0], replace(bones[1], top=math.inf), *bones[2:]))
    for pose, apart in ((first.pose, True), (open_ended, False)):
        found = PosedParts(first.rest.parts(), pose).distances(points)[:, own]
        assert bool((found[:, 1] - found[:, 0] > 0.01).all()) == apart


@pytest.mark.slow
def test_a_mane_around_a_head_goes_with_it_and_one_along_a_neck_is_bent():
    kept = []
    for noun in ("lion", "horse"):
        first, there = posed(f"a howling {noun}")
        whole = body(noun)
        front = whole.verts[:, 1] < animal(f"a {noun}").between  # not the tail's tip
        mane, eyes = whole.among("mane") & front, whole.among("eyes")
        scale = first.pose.bones[0].place.scale
        before, after = (
            torch.cdist(of[mane], of[eyes]) for of in (whole.verts, there.verts / scale)
        )
        kept.append(float((after / before - 1).abs().quantile(0.9)))
    assert kept[0] < 0.02 < kept[1]


def gaze(of: Body) -> float:
    """The pitch from the eyes to the nose, in degrees."""
    way = of.of_parts("nose").mean(0) - of.of_parts("eyes").mean(0)
    return math.degrees(math.atan2(float(way[2]), -float(way[1])))


@pytest.mark.parametrize(("pose", "most"), [("sitting", 22), ("rearing", 35)])
def test_who_is_steep_does_not_look_up_as_steeply(pose, most):
    _, dog = posed(f"a {pose} dog")
    assert 0 < gaze(dog) - gaze(body("a dog")) < most
    assert pitch(composed(f"a {pose} dog").made.things[0].pose.bones[0]) > most + 10


def test_hind_legs_on_the_ground_are_short_and_at_the_sides():
    first, horse = posed("a lying horse")
    hind, scale = animal("a horse", True).pairs[HIND], first.pose.bones[0].place.scale
    mine = first.pose.owner(resting("a horse").verts) == 3
    leg = horse.verts[mine] / scale
    aside = float(leg[:, 0].mean() - hind.middle[0])
    assert 0.4 * hind.radius < aside < 1.2 * hind.radius
    assert float(leg[:, 1].max() - leg[:, 1].min()) < 5 * hind.radius
    verts = clipped(
        (resting("a horse").verts, resting("a horse").faces), first.pose.bones[3].regions, True
    )
    assert float(verts[0][:, 2].max()) < hind.low[2] + 5.5 * hind.radius
    assert float(hind.high[2] - hind.low[2]) > 6 * hind.radius  # at rest


@pytest.mark.slow
def test_a_raised_tail_is_not_bent_with_the_head():
    first, there = posed("a howling cat")
    cat, middle = body("a cat"), animal("a cat").between
    moved = there.verts / first.pose.bones[0].place.scale
    moved = moved - (moved - cat.verts)[cat.verts[:, 2].argmin()]
    behind = cat.verts[:, 1] > middle
    assert float(cat.verts[behind, 2].max()) > animal("a cat").spine + 0.2  # its tail
    torch.testing.assert_close(moved[behind], cat.verts[behind], atol=1e-4, rtol=0)
    assert float((moved - cat.verts).norm(dim=1).max()) > 0.1


def test_both_sides_of_who_sits_are_alike():
    _, dog = posed("a sitting dog")
    _, *legs = composed("a sitting dog").made.things[0].pose.bones
    mirror = torch.diag(torch.tensor([-1.0, 1.0, 1.0]))
    for left, right in (legs[:2], legs[2:]):
        torch.testing.assert_close(mirror @ left.place.turn @ mirror, right.place.turn)
    assert float(dog.box[:, 0].sum()) == pytest.approx(0, abs=0.1)


def test_who_lies_is_on_its_belly():
    _, cat = posed("a lying cat")
    at_rest = animal("a cat", True)
    legs = (at_rest.belly - at_rest.sole) * resting("a cat").metres
    assert height(cat) < height(resting("a cat")) - 0.8 * legs
    trunk, *legs = composed("a lying cat").made.things[0].pose.bones
    assert pitch(trunk) == pytest.approx(0, abs=1e-3)
    assert all(pitch(leg) > 85 for leg in legs)


def test_who_sleeps_has_its_head_down():
    lying, asleep = posed("a lying cat")[1], posed("a sleeping cat")[1]
    eyes = [
        float((of.of_parts("eyes")[:, 2] - of.box[0, 2]).mean() * of.metres)
        for of in (lying, asleep)
    ]
    assert eyes[1] < 0.8 * eyes[0]


@pytest.mark.parametrize(
    ("noun", "eyes", "around"),
    [("cow", "eyes", "body"), ("sheep", "eyes", "head"), ("dragon", "pupils", "body")],
)
def test_who_sleeps_has_closed_eyes(noun, eyes, around):
    asleep = shipped_prior().prompted(f"a sleeping {noun}", "").things[0]
    awake = shipped_prior().prompted(f"a {noun}", "")
    closed, shown = (
        {one.name: one.color for one in drawn.of_object(0).painted.paints}
        for drawn in (asleep, awake)
    )
    assert closed[eyes] == closed["eyes"] == tuple(LID * x for x in closed[around])
    assert shown[eyes] != closed[eyes] and shown[around] == closed[around]


@pytest.mark.slow
def test_what_is_in_an_open_eye_is_not_on_a_closed_one():
    for prompt, shown in (("a horse", True), ("a sleeping horse", False)):
        drawn = shipped_prior().prompted(prompt, "").of_object(0)
        thing = drawn if isinstance(drawn, PromptedBuiltin) else drawn.made.things[0].rest
        laid = [list(looks("horse"))[one.part] for one in thing.painted.marked.laid]
        assert ("glints" in laid) == shown and "blaze" in laid and "glints" in IN_EYES


def test_who_rears_is_high_on_its_hind_legs():
    _, horse = posed("a rearing horse")
    trunk, *legs = composed("a rearing horse").made.things[0].pose.bones
    assert pitch(trunk) == pytest.approx(55, abs=0.1)
    assert all(abs(pitch(leg)) < 10 for leg in legs[2:])
    assert all(pitch(leg) > 40 for leg in legs[:2])
    assert height(horse) > 1.1 * height(body("a horse"))
    assert float(horse.verts.norm(dim=1).max()) == pytest.approx(NORMAL_RADIUS, rel=1e-3)


@pytest.mark.slow
def test_the_legs_of_who_runs_are_apart():
    first, deer = posed("a running deer")
    owner = first.pose.owner(body("a deer").verts)
    feet = [deer.verts[owner == k].mean(0)[1] for k in range(1, 5)]
    at_rest = animal("a deer")
    gap = float(at_rest.pairs[HIND].middle[1] - at_rest.pairs[FRONT].middle[1])
    scale = first.pose.bones[0].place.scale
    assert float(min(feet[2:]) - max(feet[:2])) > 1.2 * gap * scale
    assert feet[0] < feet[1] - 0.02  # the left one is ahead


@pytest.mark.slow
def test_a_howling_wolf_looks_up_on_legs_that_are_as_before():
    howling, wolf = posed("a howling wolf")[0], body("a wolf")
    assert len(howling.pose.bones) == 1
    scale = howling.pose.bones[0].place.scale
    moved = howling.pose.out(wolf.verts) / scale
    moved = moved - (moved - wolf.verts)[wolf.verts[:, 2].argmin()]
    at_rest = animal("a wolf")
    below = wolf.verts[:, 2] < (at_rest.belly + at_rest.sole) / 2
    hind = below & (wolf.verts[:, 1] > at_rest.between)
    torch.testing.assert_close(moved[hind], wolf.verts[hind], atol=1e-5, rtol=0)
    torch.testing.assert_close(moved[below], wolf.verts[below], atol=5e-3, rtol=0)
    assert hind.any()
    nose = wolf.among("nose")
    assert float(moved[nose, 2].mean() - wolf.verts[nose, 2].mean()) > 0.15


@pytest.mark.slow
def test_a_grazing_cow_has_its_muzzle_on_the_ground():
    _, cow = posed("a grazing cow")
    up, down = body("a cow"), cow
    low = [
        float((of.of_parts("muzzle")[:, 2].amin() - of.box[0, 2]) * of.metres) for of in (up, down)
    ]
    assert low[1] < 0.45 * low[0]


@pytest.mark.parametrize(
    "prompt",
    [
        "a sitting dog",
        pytest.param("a rearing horse", marks=pytest.mark.slow),
        pytest.param("a sleeping pig", marks=pytest.mark.slow),
    ],
)
def test_a_posed_animal_is_known_where_its_surface_is(prompt):
    first, there = posed(prompt)
    parts = first.parts()
    assert isinstance(parts, PosedParts)
    away = parts.distances(there.verts).amin(1).abs()
    assert float((away < 0.02).float().mean()) > 0.93  # all but what is hidden at joints
    fields = first.area_fields()
    assert fields is not None
    drawn, _ = fields.drawn(there.verts)
    torch.testing.assert_close(drawn, parts.distances(there.verts).amin(1), atol=0.02, rtol=0)


def test_a_bone_goes_with_what_is_moved():
    bend = Fan(torch.tensor([0.1, 0.0]), -1.4, -0.3, 1.2, 2.9, 0.5)
    turn = animal("a dog").posed(Placement.of(), (), 0).bones[0].place.turn
    bone = Bone((), Placement(0.8, torch.tensor([0.1, 0.2, -0.1]), turn), False, bend, 0.2)
    by, points = torch.tensor([0.3, -0.2, 0.4]), torch.rand(40, 3)
    moved = bone.moved(by)
    torch.testing.assert_close(moved.out(points + by), bone.out(points) + by)
    torch.testing.assert_close(moved.into(bone.out(points) + by), points + by)
    torch.testing.assert_close(moved.like(points + by), bone.like(points) + by)
    assert float(bone.like(points)[:, 2].max()) == pytest.approx(0.2)


@pytest.mark.slow
def test_what_is_around_a_posed_animal_is_as_far_from_it_as_at_rest():
    first, _ = posed("a lying giraffe")
    giraffe, bone = body("a giraffe"), first.pose.bones[0]
    out = vertex_normals(giraffe.verts, giraffe.faces)
    points = giraffe.verts + 0.03 * out / out.norm(dim=1, keepdim=True).clamp_min(1e-9)
    own = first.pose.owner(giraffe.verts) == 0
    own &= giraffe.verts[:, 2] > animal("a giraffe").spine
    rest = first.rest.parts().distances(points[own]).amin(1)
    found = first.parts().distances(bone.out(points[own])).amin(1)
    assert bone.place.scale > 1.06 and float(rest.median()) > 0.02
    near = (found - rest * bone.place.scale).abs() < 1e-4
    assert float(near.float().mean()) > 0.95


@pytest.mark.slow
def test_what_stands_out_of_a_bent_neck_is_as_high_as_at_rest():
    first, there = posed("a howling sheep")
    rest, fields = first.rest.area_fields(), first.area_fields()
    assert rest is not None and fields is not None
    sheep = body("a sheep")
    _, depths = rest.near(sheep.verts)
    area = depths.argmax(1)
    before, after = rest.heights(sheep.verts, area), fields.heights(there.verts, area)
    scale = first.pose.bones[0].place.scale
    curls = before.abs() > 1e-4
    moved = ((there.verts - sheep.verts * scale) / scale).std(0).max()
    assert curls.sum() > 100 and float(moved) > 0.01
    torch.testing.assert_close(after[curls], before[curls] * scale, atol=2e-4, rtol=0.02)


@pytest.mark.parametrize(
    "prompt",
    [
        "a sitting dog",
        pytest.param("a running corgi", marks=pytest.mark.slow),
        pytest.param("a sleeping lion", marks=pytest.mark.slow),
    ],
)
def test_a_posed_animal_is_closed_and_of_one_component(prompt):
    import trimesh

    verts, faces = assembled(composed(prompt).parts(), True, 0.01, lambda _: None)
    mesh = trimesh.Trimesh(verts.numpy(), faces.numpy(), process=False)
    assert mesh.is_watertight
    assert sum(one.volume > 1e-4 for one in mesh.split(only_watertight=False)) == 1


def test_normals_of_a_bent_head_are_seen_at_rest():
    """A picture of the posed thing, taken back to the rest pose, has the rest pose's normals."""
    first, there = posed("a howling wolf")
    wolf = body("a wolf")
    own = wolf.among("nose", "muzzle", "eyes")[wolf.faces].all(1)
    rest, bent = (face_normals(verts, wolf.faces)[own] for verts in (wolf.verts, there.verts))
    rest, bent = (of / of.norm(dim=1, keepdim=True) for of in (rest, bent))
    points = there.verts[wolf.faces[own]].mean(1)
    count = 256
    surface = torch.full((1, 7, 16, 16), -1.0)
    pick = torch.linspace(0, len(points) - 1, count).long()
    surface[0, :3] = bent[pick].T.reshape(3, 16, 16)
    surface[0, 3] = 1.0
    surface[0, 4:] = points[pick].T.reshape(3, 16, 16)
    found = first.pose.bones[0].seen(surface)
    torch.testing.assert_close(
        found[0, 4:].reshape(3, -1).T, wolf.verts[wolf.faces[own]].mean(1)[pick], atol=2e-3, rtol=0
    )
    close = (found[0, :3].reshape(3, -1).T * rest[pick]).sum(1)
    assert float((close > 0.98).float().mean()) > 0.9


@pytest.mark.slow
def test_clothes_go_with_the_pose_that_they_are_worn_in():
    guidance = composed("a dog in a yellow jacket, sitting")
    dog, coat = guidance.made.things
    assert isinstance(dog, Posed) and isinstance(coat, Posed)
    for own, worn in zip(dog.pose.bones, coat.pose.bones, strict=True):
        torch.testing.assert_close(own.place.shift, worn.place.shift)
        torch.testing.assert_close(own.place.turn, worn.place.turn)
    wide = coat.pose.bones[1].regions[0].box[1] - dog.pose.bones[1].regions[0].box[1]
    assert wide[0] == pytest.approx(poses.PADDED) and wide[2] == pytest.approx(0)


@pytest.mark.slow
def test_a_scarf_is_not_on_the_legs():
    _, scarf = composed("a sitting dog wearing a red scarf").made.things
    assert isinstance(scarf, Posed)
    (whole,) = scarf.pose.bones
    assert whole.regions == () and whole.bend is not None


def test_a_stated_height_is_that_of_the_pose():
    stated = composed("a 60 cm tall sitting dog")
    (place,) = stated.made.places[0]
    _, there = posed("a 60 cm tall sitting dog")
    tall = there.placed(place).sides
    assert stated.size_m() * float(tall[2] / tall.max()) == pytest.approx(0.6, rel=0.03)


@pytest.mark.slow
def test_one_rides_a_mount_that_rears():
    guidance = composed("a knight riding a rearing horse")
    knight, horse = guidance.made.things
    assert isinstance(knight, Posed) and isinstance(horse, Posed)
    assert pitch(horse.pose.bones[0]) == pytest.approx(55, abs=0.1)


def test_without_four_legs_the_pose_is_left_out_with_a_note(monkeypatch):
    monkeypatch.setattr(poses.Animal, "of", classmethod(lambda cls, thing, body: None))
    drawn = shipped_prior().prompted("a sitting wolf", "").of_object(0)
    assert isinstance(drawn, Composed)
    assert drawn.left_out() == (f"wolf sitting: {UNPOSED}",)
    assert not isinstance(drawn.made.things[0], Posed)


def test_a_mesh_of_ones_own_keeps_its_pose():
    prompted = shipped_prior().prompted("a sitting dog", "")
    assert prompted.of_object(0, whole=False).left_out() == (f"dog sitting: {OWN_POSE}",)
    assert isinstance(shipped_prior().prompted("a dog", ""), PromptedBuiltin)
