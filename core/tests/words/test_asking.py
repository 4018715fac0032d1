"""What people write before what they ask for."""

import pytest

from core.guidance.builtin.words.asking import asked_for
from core.guidance.builtin.words.vocabulary import parse


@pytest.mark.parametrize(
    ("prompt", "left"),
    [
        ("can you make a red fire truck", "a red fire truck"),
        ("Hi, could you please make me a blue vase", "a blue vase"),
        ("could i get a desk", "a desk"),
        ("can we do some apples", "some apples"),
        ("I'd like a chair", "a chair"),
        ("I’d love to have a chair", "a chair"),
        ("i would like to see a chair", "a chair"),
        ("let's try a dragon", "a dragon"),
        ("I am looking for a rusty barrel", "a rusty barrel"),
        ("im trying to make a barrel", "a barrel"),
        ("i'm making a fantasy game, need a potion", "a potion"),
        ("We're doing a kitchen render and we need a wooden spoon", "a wooden spoon"),
        ("its for a diorama, a small bridge", "a small bridge"),
        ("It is for my son's birthday. I need a big cake", "a big cake"),
        ("hi there, can you make four chairs", "four chairs"),
        ("can you make dragons", "dragons"),
        ("can you make it a red chair", "a red chair"),
    ],
)
def test_what_is_asked_for_begins_behind_the_asking(prompt, left):
    assert asked_for(prompt) == left


@pytest.mark.parametrize(
    "prompt",
    [
        "a can of soup",
        "can opener",
        "a robot looking for a key",
        "a cat that is for a child, a small one",
        "i'm making a chair and a table",
        'a sign that says "can you make a cake"',
        "it's a chair, a red one",
        "i'm making a chair and want a red cushion on it",
        "I'm making a red chair and I want the legs golden",
        'i\'m making a sign that says "sorry, need a hug"',
        "it's for a castle, a bridge",
        'i am making a thingy that says "sorry, need a hug"',
    ],
)
def test_other_prompts_stay(prompt):
    assert asked_for(prompt) == prompt


def test_can_is_a_verb_there_and_a_thing_elsewhere():
    assert parse("can you make a fire truck").noun == "fire truck"
    assert parse("can i have a soda can").noun == "can"
