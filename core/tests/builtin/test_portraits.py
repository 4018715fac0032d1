"""Pictures of things on others: their words, and what they look like."""

import pytest
import torch

from core.guidance.builtin.markings.emblems.portraits import Portrait, portrait_of
from core.guidance.builtin.palette import looks
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import shipped_prior

RED, BLUE = (0.9, 0.1, 0.1), (0.1, 0.1, 0.9)


@pytest.mark.parametrize(
    ("prompt", "thing", "picture"),
    [
        ("a white mug with a cat on it", "mug", "cat"),
        ("a wooden shield with a wolf on it", "shield", "wolf"),
        ("a shield with a golden lion", "shield", "golden lion"),
        ("a book with a unicorn on the cover", "book", "unicorn"),
        ("a flag with a red dragon on it", "flag", "red dragon"),
        ("a mug with a corgi print", "mug", "corgi"),
        ("a vase with a dragon painted on it", "vase", "dragon"),
    ],
)
def test_a_thing_on_what_is_printed_is_a_picture(prompt, thing, picture):
    words = parse(prompt)
    assert (words.noun, [str(one) for one in words.emblems]) == (thing, [picture])
    assert words.emblems[0].is_portrait and not words.companions


@pytest.mark.parametrize(
    "prompt",
    [
        "a table with a vase on it",
        "a jar with a lid",
        "a mug with a heart on it",
        "a window with a flower pot",
        "a lantern with a candle inside",
        "a cat on a skateboard",
        "a cat on a skateboard with a hat on its head",
        "a man in a hoodie with a dog",
        "a boy wearing a shirt with a backpack",
        "a bottle with a cork",
    ],
)
def test_a_thing_that_stands_there_is_no_picture(prompt):
    assert not any(one.is_portrait for one in parse(prompt).emblems)


def test_what_is_worn_has_the_picture_and_not_its_wearer():
    words = parse("a cat wearing a t-shirt with a dinosaur on it")
    assert [one.words.noun for one in words.companions] == ["shirt"]
    assert [str(one) for one in words.companions[0].words.emblems] == ["dinosaur"]
    assert words.emblems == ()


def two_balls() -> Portrait:
    """A red ball at the left, and a blue one at the right in front of it."""
    from trimesh.creation import icosphere

    ball = icosphere(3, 0.5)
    left, right = torch.tensor([-0.45, 0.3, 0.0]), torch.tensor([0.45, -0.3, 0.0])
    verts = torch.tensor(ball.vertices).float()
    faces = torch.tensor(ball.faces).long()

    def area_of(points):
        away = [(points - middle).norm(dim=1) for middle in (left, right)]
        return torch.stack(away, 1).argmin(1)

    both = torch.cat([verts + left, verts + right]), torch.cat([faces, faces + len(verts)])
    return portrait_of(*both, area_of, [RED, BLUE])


def test_a_portrait_has_each_area_where_it_is_seen_and_a_line_between_them():
    picture = two_balls()
    assert {layer.color for layer in picture.layers} == {RED, BLUE}
    red, blue = (next(one for one in picture.layers if one.color == c) for c in (RED, BLUE))
    at = torch.tensor([[0.6, -0.1], [-0.7, 0.1], [0.0, 0.0], [0.0, 0.95]])
    assert (blue.margin(at) > 0).tolist() == [True, False, True, False]  # it is in front
    assert (red.margin(at) > 0).tolist() == [False, True, False, False]
    assert (picture.margin(at) > 0).tolist() == [True, True, True, False]
    line = torch.linspace(-0.9, 0.9, 181)
    row = torch.stack([line, torch.zeros_like(line)], 1)
    inks = (picture.margin(row) > 0.08) & (red.margin(row) < 0) & (blue.margin(row) < 0)
    assert inks.any()  # where the one in front ends


@pytest.mark.slow
def test_a_drawn_picture_is_areas_of_its_own_and_a_shields_own_emblem_makes_room():
    drawn = shipped_prior().prompted("a shield with a golden lion", "").of_object(0)
    fields = drawn.area_fields()
    names = list(looks("shield"))
    assert len(fields.each) > len(names) + 1
    verts = torch.cat(
        [drawn.parts().surface_of(k)[0] for k in range(len(drawn.parts().components))]
    )
    area = fields.near(verts)[1].argmax(1)
    assert not (area == names.index("emblem")).any()
    front = area[verts[:, 1] < 0]
    assert 0.04 < float((front >= len(names)).float().mean()) < 0.9
