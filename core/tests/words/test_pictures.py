"""What a prompt says of a picture or of a file of the thing, which is no part of the thing."""

import pytest

from core.guidance.builtin.words.phrases.pictures import of_no_picture
from core.guidance.builtin.words.vocabulary import parse


@pytest.mark.parametrize(
    ("prompt", "left"),
    [
        ("a zoomed out DSLR photo of a hippo", "a hippo"),
        ("a wide angle DSLR photo of a cat", "a cat"),
        ("A tilt-shift photograph of a car", "a car"),
        ("extreme close-up of a strawberry", "a strawberry"),
        ("a bird's eye view of a castle", "a castle"),
        ("concept art of a spaceship", "a spaceship"),
        ("a matte painting of a castle", "a castle"),
        ("stl file of a vase", "a vase"),
        ("turntable render of two apples", "two apples"),
        ("a red fox, 4k, trending on artstation", "a red fox"),
        ("a rocket, unreal engine 5, 8k, octane render", "a rocket"),
        ("8k, photorealistic, a house, with a red door", "a house, with a red door"),
        ("a lamp, rendered in blender", "a lamp"),
        ("a typewriter, isometric, blender 3d", "a typewriter"),
        ("a dress. Studio lighting, high quality, high resolution", "a dress."),
        ("a shoe, product shot on white", "a shoe"),
        ("a shoe, on a plain grey background", "a shoe"),
    ],
)
def test_what_is_of_a_picture_is_passed_over(prompt, left):
    assert of_no_picture(prompt) == left


@pytest.mark.parametrize(
    "prompt",
    [
        "a vase of flowers",
        "vases of flowers",
        "a scale model of a car",  # a small one
        "a picture frame of gold",
        "a portrait of a king",
        "a red car, white",
        "a car, on white wheels",
        "a toaster, blender",
        "a train, steam engine",
        "a cup, light blue",
        'a sign that says "hello, 4k, photo"',
        "a poster with a photo of a cat",
        "4k, octane render",  # nothing would be left
    ],
)
def test_what_is_of_the_thing_stays(prompt):
    assert of_no_picture(prompt) == prompt


@pytest.mark.parametrize(
    ("prompt", "noun"),
    [
        ("an isometric house", "house"),
        ("a house in octane render", "house"),
        ("a close up red rose", "rose"),
        ("the cutest hamster ever", "hamster"),
        ("an adorable, delicious cupcake", "cupcake"),
        ("a majestic and gorgeous lion", "lion"),
        ("an epic sword, awesome", "sword"),
        ("a stylized cartoon fox", "fox"),  # as all that is made is
        ("a chibi knight", "knight"),
    ],
)
def test_words_of_a_picture_and_praise_ask_for_nothing_that_is_missing(prompt, noun):
    words = parse(prompt)
    assert (words.noun, words.notes, words.left_out) == (noun, (), ())


@pytest.mark.parametrize("prompt", ["an anime cat", "a high poly cat", "a cat in vivid colors"])
def test_a_style_that_would_be_seen_is_still_reported(prompt):
    assert parse(prompt).left_out and parse(prompt).notes


@pytest.mark.parametrize(
    ("prompt", "noun", "companions"),
    [
        ("a pot of gold", "cauldron", ["coin"]),
        ("a tea set", "teapot", ["teacup"]),
        ("a tea set on a silver tray", "plate", ["teapot", "teacup"]),
        ("a giant mushroom with a red door and windows", "mushroom house", []),
        ("a mushroom with white spots", "mushroom", []),
        ("a tank of fish", "aquarium", []),
        ("a hot dog stand", "market stall", []),
        ("a surfboard leaning against a palm tree", "surfboard", ["palm"]),
        ("an umbrella propped up against a fence", "umbrella", ["fence"]),
    ],
)
def test_names_of_several_words_mean_what_is_known(prompt, noun, companions):
    words = parse(prompt)
    assert (words.noun, [one.words.noun for one in words.companions]) == (noun, companions)
    assert words.left_out == ()


def test_what_is_written_on_a_thing_stays_as_it_is():
    for prompt, text in (
        ('a mug that says "pot of gold"', "pot of gold"),
        ('a wooden sign that reads "made out of lava"', "made out of lava"),
        ('a mug that says "tank of fish" next to a tank of fish', "tank of fish"),
    ):
        words = parse(prompt)
        emblems = [*words.emblems, *(e for one in words.companions for e in one.words.emblems)]
        assert [one.text for one in emblems] == [text], prompt
