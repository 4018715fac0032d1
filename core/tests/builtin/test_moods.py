"""Moods: their words, and what they change on a thing."""

from dataclasses import replace

import pytest
import torch

from core.guidance.builtin.markings.expressions import MOUTH, expression
from core.guidance.builtin.painted_solid import PaintedSolid
from core.guidance.builtin.palette import Painted, looks, painted
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import shipped_prior


@pytest.mark.parametrize(
    ("prompt", "noun", "mood"),
    [
        ("an angry bear", "bear", "angry"),
        ("a grumpy old cat", "cat", "angry"),
        ("a dog with a big smile", "dog", "happy"),
        ("a cat with a sad expression on its face", "cat", "sad"),
        ("a robot with an angry face and red eyes", "robot", "angry"),
        ("a sleepy owl on a branch", "owl", "sleepy"),
        ("a cat that is not happy", "cat", ""),
        ("a knight, furious", "knight", ""),  # behind a visor
    ],
)
def test_the_mood_of_what_has_eyes(prompt, noun, mood):
    words = parse(prompt)
    assert (words.noun, words.mood, words.emblems) == (noun, mood, ())


@pytest.mark.parametrize(
    ("prompt", "face"),
    [
        ("a mushroom with a smiling face", "happy face"),
        ("a kawaii cactus", "happy face"),
        ("an apple with an angry face", "angry face"),
        ("a tree with a scary face", "angry face"),
        ("a sad cloud", "sad face"),
        ("a happy birthday cake", None),
        ("a merry christmas tree", None),
        ("a scary house", None),
    ],
)
def test_a_face_is_drawn_on_what_has_no_eyes(prompt, face):
    words = parse(prompt, ignore_unknown=True)
    assert words.mood == ""
    assert [one.shape for one in words.emblems] == [face] * bool(face)


def test_a_mood_that_is_not_shown_as_such_is_reported():
    assert "evil: shown as angry." in parse("an evil clown").notes
    assert not parse("an angry clown").notes


def eyeball(points):
    """A head of radius .5 at the origin; two eyes with radius .12 on its front; a mouth below."""
    x, y, z = points.unbind(1)
    head = points.norm(dim=1) - 0.5
    eyes = (torch.stack([x.abs() - 0.2, y + 0.42, z - 0.1], 1)).norm(dim=1) - 0.12
    inside = torch.stack([x.abs() - 0.15, (z + 0.2).abs() - 0.04, y], 1).amax(1)
    return torch.stack([torch.maximum(head, -inside), eyes, torch.maximum(head, inside)], 1)


BOXES = [
    torch.tensor([[-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]]),
    torch.tensor([[-0.32, -0.54, -0.02], [-0.08, -0.3, 0.22]]),  # the left one
    None,
]


def drawn(mood):
    paints = list(painted("ghost", Words("ghost")))
    paints = [paints[0]._replace(name="head"), paints[1]._replace(name="eyes"), paints[2]]
    names = ["head", "eyes", MOUTH]
    return expression(mood, False, names, BOXES, [0, 1, 0], eyeball, paints)


def owner(areas, points):
    """The names of the areas at the points, from the parts' distances on."""
    found, names = eyeball(points), ["head", "eyes", ""]
    found[:, 2] = torch.inf  # an expression replaces the mouth
    found[:, 0] = points.norm(dim=1) - 0.5
    for one in areas:
        found, names = one(found, points), [*names, one.paint.name]
    return [names[k] for k in found.argmin(1)]


def test_angry_lids_slope_down_to_the_nose():
    """On both eyes: their inner upper part is covered, their outer one is not."""
    inner, outer, below = (0.12, -0.53, 0.14), (0.28, -0.53, 0.14), (0.2, -0.53, 0.04)
    both = [(side * x, y, z) for side in (1, -1) for x, y, z in (inner, outer, below)]
    found = owner(drawn("angry"), torch.tensor(both))
    assert found == ["lids", "eyes", "eyes"] * 2


def test_sad_lids_slope_down_to_the_outside():
    inner, outer = (0.12, -0.53, 0.14), (0.29, -0.51, 0.14)
    found = owner(drawn("sad"), torch.tensor([inner, outer]))
    assert found == ["eyes", "lids"]


def test_a_mouth_turns_down_where_it_turned_up():
    """The ends of a sad mouth are below its middle, and brows are above the eyes."""
    line = torch.linspace(-0.34, -0.06, 57)
    lowest = {}
    for x in (0.0, 0.13):
        at = torch.stack([torch.full_like(line, x), -(0.25 - x * x - line**2).sqrt(), line], 1)
        heights = line[torch.tensor([one == "mouth" for one in owner(drawn("sad"), at)])]
        lowest[x] = float(heights.min())
    assert lowest[0.13] < lowest[0.0] - 0.02
    names = [one.paint.name for one in drawn("sad")]
    assert names == ["lids", "brows", MOUTH]


def test_a_drawn_thing_shows_its_mood():
    """Lids and brows are areas of an angry cat's surface, and nothing else of it changes."""
    prior = shipped_prior()
    plain, angry = (prior.prompted(text, "").of_object(0) for text in ("a cat", "an angry cat"))
    eye = plain.parts().boxes()[list(looks("cat")).index("eyes")]
    verts = torch.cat(
        [plain.parts().surface_of(k)[0] for k in range(len(plain.parts().components))]
    )
    before, after = (one.area_fields() for one in (plain, angry))
    count = len(before.each)
    assert len(after.each) == count + 2
    was, now = (fields.near(verts)[1].argmax(1) for fields in (before, after))
    changed = was != now
    assert (now[changed] >= len(looks("cat"))).all()
    assert 10 < int(changed.sum()) < 0.1 * len(verts)
    assert (verts[changed, 2] > float(eye[0, 2])).all()


def test_paint_of_lids_is_a_shade_of_the_head():
    lids = next(one.paint for one in drawn("sleepy"))
    head = next(painted("ghost", Words("ghost")))
    assert isinstance(lids, Painted)
    assert all(a < b for a, b in zip(lids.color, head.color, strict=True))


def reflected(eye=(0.05, 0.05, 0.05), names=("body", "eyes", MOUTH)):
    """The reflections in the eyes of a ghost's head."""
    paints = [one._replace(color=eye) for one in painted("ghost", Words("ghost"))]
    return expression("", True, list(names), BOXES, [0, 1, 0], eyeball, paints)


def test_dark_eyes_have_reflections_at_their_upper_and_lower_side():
    (found,) = reflected()
    assert found.paint.color == (1.0, 1.0, 1.0) and found.on == 1
    upper, lower = torch.tensor([0.23, -0.53, 0.15]), torch.tensor([0.164, -0.53, 0.052])
    other = upper * torch.tensor([-1.0, 1.0, 1.0])
    middle, back = torch.tensor([0.2, -0.54, 0.1]), torch.tensor([0.23, 0.5, 0.15])
    seen = found.margin(torch.stack([upper, lower, other, middle, back])) > 0
    assert seen.tolist() == [True, True, True, False, False]


def test_bright_eyes_and_those_with_reflections_get_none():
    assert not reflected(eye=(0.9, 0.8, 0.1))
    assert not reflected(names=("body", "eyes", "glints"))


@pytest.mark.parametrize(
    ("prompt", "alive"), [("a cat", True), ("a gold cat statue", False), ("a skull", False)]
)
@pytest.mark.filterwarnings("ignore")
def test_light_is_reflected_in_living_eyes_alone(prompt, alive):
    one = shipped_prior().prompted(prompt, "").of_object(0)
    assert [layer.paint.name for layer in one.painted.drawn] == ["glints"] * alive
    asleep = PaintedSolid(replace(one.words, pose="sleeping"), one.solid)
    assert asleep.drawn == []
