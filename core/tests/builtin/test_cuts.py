"""What is bitten, cut or broken: its words, the tools, the parts that are left and their inside."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import torch

from core.geometry.mesh import health
from core.geometry.parts.assembly import KnownParts, assembled
from core.geometry.parts.cut import CutParts
from core.geometry.parts.forms import Forms
from core.geometry.signed_distance import SolidMesh
from core.geometry.tools import beyond, both, capsule, joined, larger, outside, rough
from core.geometry.union import volume
from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.cutting import places
from core.guidance.builtin.cutting.cut_solid import Cut, cut_out_of
from core.guidance.builtin.cutting.fills import Fill, within
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.palette import painted
from core.guidance.builtin.words.phrases import cuts
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse, understood
from core.tests.drawn_things import shipped_prior

CAKES = "a cake", "a slice of cake"
UP = np.array([0.0, 0.0, 1.0])
RADIUS = 0.5


@pytest.mark.parametrize(
    ("prompt", "noun", "cut"),
    [
        ("an apple with a bite taken out of it", "apple", "bitten"),
        ("a red apple with a leaf and a bite taken out of it", "apple", "bitten"),
        ("a hamburger with a bite", "hamburger", "bitten"),
        ("a half-eaten donut", "donut", "half-eaten"),
        ("a pizza with a slice missing", "pizza", "slice missing"),
        ("a birthday cake with a missing slice", "cake", "slice missing"),
        ("a slice of chocolate cake", "cake", "slice"),
        ("a piece of birthday cake with a cherry on top", "cake", "slice"),
        ("a slice of pizza", "pizza", ""),  # one is drawn
        ("half an orange", "orange fruit", "halved"),
        ("a watermelon cut in half", "watermelon", "halved"),
        ("a cracked egg", "egg", "broken"),
        ("a shattered pot", "flower pot", "broken"),
        ("a broken marble statue of a lion", "lion", "broken"),
        ("a broken tower", "tower", "ruined"),
        ("the ruins of a castle", "castle", "ruined"),
        ("a sliced avocado", "avocado", ""),  # drawn so
        ("a watermelon with a slice cut out", "watermelon", ""),
    ],
)
def test_a_cut_is_read_and_nothing_of_it_is_left_out(prompt, noun, cut):
    words = parse(prompt)
    assert (words.noun, words.cut, words.left_out) == (noun, cut, ())
    assert understood(prompt)["cut"] == (cut or None)


@pytest.mark.parametrize(
    ("prompt", "left"),
    [
        ("a car with a bite taken out of it", "bitten"),
        ("a broken robot", "broken"),
        ("a chair with a broken leg", "broken"),
        ("an unbroken sword", "unbroken"),
        ("a half orange half white cat", "half"),
    ],
)
def test_what_cannot_be_cut_so_is_whole(prompt, left):
    words = parse(prompt)
    assert words.cut == "" and left in words.left_out


def test_a_cut_is_that_of_its_thing():
    words = parse("a squirrel holding a bitten cookie")
    assert (words.cut, [one.words.cut for one in words.companions]) == ("", ["bitten"])
    assert parse('a mug that says "half-eaten"').cut == ""
    assert parse("half a dozen eggs").cut == ""


def test_the_tables_name_known_things():
    tables = [cuts.EATEN, cuts.HALVED, cuts.SLICED, cuts.BROKEN, cuts.RUINED]
    tables += [places.SPARED, places.PAIRS, places.ACROSS, places.HOLLOW, places.UPRIGHT]
    assert not set().union(*tables) - set(NOUNS)


def _tools():
    tilted = places.way(30, 0.5)
    ball = outside(np.array([0.1, 0.0, 0.0]), np.full(3, 0.6))
    heights = np.random.default_rng(0).uniform(-0.02, 0.02, (21, 21))
    egg = capsule(0.2 * UP, 0.4 * UP, 0.3)
    half = [np.array([1.0, 0.8, 0.5]), np.array([0.0, 0.1, 0.0])]
    return {
        "capsule": egg,
        "plane": beyond(tilted, 0.1),
        "outside a ball": ball,
        "rough": rough(tilted, 0.1, heights, 1.5, (0.1, 0.0)),
        "larger": larger((egg.verts, egg.faces), egg.distance, np.zeros(3), *half),
        "joined": joined([egg, beyond(tilted, 0.3)]),
        "both": both([egg, beyond(tilted, 0.3)]),
    }


@pytest.mark.parametrize(("name", "tool"), _tools().items())
def test_a_tools_distance_is_its_meshs(name, tool):
    points = 2 * torch.rand(400, 3, generator=torch.Generator().manual_seed(0)) - 1
    away, exact = tool.distance(points), SolidMesh(tool.verts, tool.faces).sdf(points)
    clear = exact.abs() > 0.004  # a ball's mesh has flat faces
    assert torch.equal(away[clear] < 0, exact[clear] < 0)
    near = exact.abs() < 0.05
    assert (away - exact)[near].abs().max() < (0.03 if name == "larger" else 0.01)


@cache
def _ball_with_a_stick() -> KnownParts:
    """A ball, and a stick that stands on its front half."""

    def distances(points):
        ball = points.norm(dim=1) - RADIUS
        off = (points - points.new_tensor([0.0, -0.2, 0.6])).abs()
        stick = (off - off.new_tensor([0.06, 0.06, 0.22])).amax(1)
        return torch.stack([ball, stick], 1)

    return KnownParts(distances, Forms((0.0, 1.0), ((0.0, 0.0),) * 3))


def test_what_is_left_is_closed_and_in_one_piece():
    whole = _ball_with_a_stick()
    normal = np.array([0.0, -1.0, 0.0])
    front = beyond(normal, 0.02)  # and the stick, all of it
    half = CutParts(whole, front, (), ())
    verts, faces = assembled(half, True, 0.05, lambda _: None)
    found = health(verts, faces)
    assert (found["closed"], found["manifold"], found["components"]) == (True, True, 1)
    assert volume((verts, faces)) == pytest.approx(0.54 * 4 / 3 * np.pi * RADIUS**3, rel=0.05)
    belt = both([beyond(UP, 0.2), beyond(-UP, -0.45)])
    lower = CutParts(whole, belt, (), ())
    verts, _ = assembled(lower, True, 0.05, lambda _: None)
    assert float(verts[:, 2].max()) < 0.21  # the upper end is not joined to the rest


def test_what_is_brittle_is_whole_or_missing_and_what_is_spared_is_whole():
    whole = _ball_with_a_stick()
    top = beyond(UP, 0.6)  # through the stick
    places_of = lambda parts: [one.place.part for one in parts.components]  # noqa: E731
    assert places_of(CutParts(whole, top, (), ())) == [0, 1]
    assert places_of(CutParts(whole, top, (), (1,))) == [0]
    spared = CutParts(whole, top, (1,), (1,))
    assert torch.equal(spared.surface_of(1)[0], whole.surface_of(1)[0])


@pytest.mark.parametrize(
    ("cut", "noun"),
    [
        ("bitten", "apple"),
        ("half-eaten", "donut"),
        ("halved", "pear"),
        ("slice missing", "cake"),
        ("broken", "boulder"),
        ("broken", "wall"),
        ("broken", "bust"),
        ("ruined", "castle"),
    ],
)
def test_a_cut_is_in_what_the_camera_sees(cut, noun):
    whole = _ball_with_a_stick()
    tool = places.tool_of(cut, noun, whole, ["body", "stalk"], "stone")
    points = 2 * torch.rand(4000, 3, generator=torch.Generator().manual_seed(0)) - 1
    ball = points[points.norm(dim=1) < RADIUS]
    gone = ball[tool.distance(ball) < 0]
    assert 0.02 < len(gone) / len(ball) < 0.75
    camera = torch.from_numpy(places.way(30, 0.35)).float()
    assert float(gone.mean(0) @ camera) > 0.05


def test_a_slice_alone_has_a_cut_face_in_front_and_no_plate():
    whole = _ball_with_a_stick()
    tool = places.tool_of("slice", "cake", whole, ["body", "stalk"], "stone")
    points = 2 * torch.rand(4000, 3, generator=torch.Generator().manual_seed(0)) - 1
    ball = points[points.norm(dim=1) < RADIUS]
    left = ball[tool.distance(ball) > 0]
    assert len(left) / len(ball) == pytest.approx(places.SLICE / 360, abs=0.03)
    camera = torch.from_numpy(places.way(30)).float()
    beside = left + 0.2 * camera  # out of the slice, through its face
    assert (tool.distance(beside) < 0).float().mean() > 0.6
    words = Words("cake", cut="slice")
    names = ["body", "plate"]
    paints = [next(painted("cake", words))._replace(name=name) for name in names]
    assert cut_out_of(words, whole, paints).parts.spared == []
    assert cut_out_of(replace(words, cut="halved"), whole, paints).parts.spared == [1]


def test_the_inside_has_areas_of_its_own():
    whole = _ball_with_a_stick()
    parts = CutParts(whole, beyond(np.array([0.0, -1.0, 0.0]), 0.0), (), (1,))
    white, red = Fill((1.0, 1.0, 1.0), "flesh"), Fill((1.0, 0.0, 0.0), "peel", within(-1, 0.1))
    cut = Cut(parts, ((0, white), (0, red)), ())
    points = torch.tensor([[0.0, 0.0, 0.0], [0.46, 0.0, 0.0], [0.0, 0.5, 0.0], [0.3, 0.0, 0.4]])
    for shift in (-1e-4, 1e-4):  # on both sides of the face
        found = cut.shown(whole.distances, points + torch.tensor([0.0, shift, 0.0]), 2)
        assert found.argmin(1).tolist()[:2] == [2, 3]
        assert found.argmin(1)[2] == 0
    middle = cut.shown(whole.distances, torch.tensor([[0.0, -0.1, 0.0]]), 2)
    assert middle.amin() > 0  # nothing is there


@pytest.mark.slow
def test_a_slice_has_half_the_size_and_bears_things_where_it_is():
    whole, one = (shipped_prior().prompted(text, "").of_object(0) for text in CAKES)
    assert one.words.usual()[0] == pytest.approx(whole.words.usual()[0] / 2)
    parts = one.parts()
    body = Body.of(one.words, one.solid, parts)
    assert (parts.tool.distance(body.verts) > 0).all()
    assert float(body.sides[:2].max()) < 0.8 * float(Body.of(whole.words, whole.solid).sides.max())
