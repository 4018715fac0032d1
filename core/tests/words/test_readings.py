"""What prompts deny, sizes in words, stones and see-through things, slips: as people type them."""

import random

import pytest

from core.errors import UserError
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.palette import EYES, painted
from core.guidance.builtin.surfaces import CARVED_STONE, surfaces_of
from core.guidance.builtin.variants import VARIANTS, Variant
from core.guidance.builtin.words.grammar.lexicon import LEXICON, PARTS, SLOTS
from core.guidance.builtin.words.grammar.tokens import MADE
from core.guidance.builtin.words.tables.kinds import KINDS, look_of_kind
from core.guidance.builtin.words.tables.words import (
    COUNTS,
    FILLER,
    IGNORED_ADJECTIVES,
    SIZE_WORDS,
    WITHOUT,
)
from core.guidance.builtin.words.vocabulary import parse, understood


def read(prompt: str) -> dict:
    return understood(prompt, known=SLOTS)


@pytest.mark.parametrize(
    ("prompt", "lacks"),
    [
        ("a chair, not wooden", "wooden"),
        ("a bucket that isn't rusty", "rusty"),
        ("a not red apple", "red"),
        ("a chair with no red", "red"),
        ("a table that is not round", "round"),
        ("chair, not made of wood", "wood"),
        ("a chair that is not made of wood but metal", "wood"),
        ("a vase, not red or blue", "blue"),
        ("a non-metallic bucket", "metallic"),
    ],
)
def test_what_it_is_not_is_left_out_and_said(prompt: str, lacks: str) -> None:
    found = read(prompt)
    assert f"not {lacks}: left out, as nothing else is given in its place." in found["notes"]
    assert (found["colours"], found["shape"]) == ([], None)
    assert found["materials"] == (["metal"] if "but" in prompt else [])


@pytest.mark.parametrize(
    "prompt",
    [
        "a house with a door that is not red",
        "a car whose wheels aren't black",
        "a sword with a blade that is not rusty",
        "a chair, legs not black",
    ],
)
def test_a_part_of_which_a_look_is_denied_stays(prompt: str) -> None:
    found = read(prompt)
    assert (found["parts"], found["part_colours"], found["part_materials"]) == ([], {}, {})


@pytest.mark.parametrize(
    ("prompt", "thing", "colours"),
    [
        ("a not shiny red car", "car", ["red"]),
        ("a not too big red car", "car", ["red"]),
        ("a not red or blue car", "car", []),
        ("not a car but a truck", "truck", []),
        ("a red car instead of blue", "car", ["red"]),
        ("no text, a blue mug", "mug", ["blue"]),
        ("a vase without scratches made of glass", "vase", []),
        ("a car without damage in red", "car", ["red"]),
        ("not too shiny, a red ball", "ball", ["red"]),
    ],
)
def test_not_denies_what_is_right_behind_it(prompt: str, thing: str, colours: list[str]) -> None:
    found = read(prompt)
    assert (found["thing"], found["colours"]) == (thing, colours)


@pytest.mark.parametrize("word", MADE)
def test_a_prompt_may_end_with_what_was_done_to_it(word: str) -> None:
    assert read(f"a wooden chair, {word}")["materials"] == ["wooden"]
    assert read(f"a chair {word} red")["colours"] == ["red"]


def test_no_order_of_words_is_a_fault() -> None:
    """Read, or refused in a sentence: "a chair, painted" once was neither."""
    draw = random.Random(0)
    known = FILLER | IGNORED_ADJECTIVES | SIZE_WORDS.keys() | COUNTS
    said = [*sorted(known), *WITHOUT, *MADE, "isn't", "'s", "xyzzy"]
    looks = ["red", "wooden", "dots", "old", "10 mm"]
    tables = (sorted(LEXICON), sorted(PARTS), said, said, looks)
    refused = 0
    for _ in range(300):
        words = [draw.choice(draw.choice(tables)) for _ in range(draw.randint(1, 9))]
        try:
            read(" ".join(word + draw.choice(("", "", "", ",")) for word in words))
        except UserError:
            refused += 1
    assert 0 < refused < 300


def test_what_it_does_not_have_is_lacking() -> None:
    assert read("a snowman that doesn't have a hat")["parts"] == ["no hat"]
    lacked = read("a car without wheels or windows")["parts"]
    assert lacked == ["no wheels", "no hubs", "no windows"]
    assert read("green, not blue, bottle")["colours"] == ["green"]


@pytest.mark.parametrize(
    ("prompt", "times"),
    [
        ("a tiny pumpkin", 0.4),
        ("a small wooden box", 0.7),
        ("a big, grey boulder", 1.5),
        ("a lion, huge", 2.0),
        ("a robot with big eyes", 1.0),
        ("a house with large black windows", 1.0),
        ("a house, not big", 1.0),
        ("a dragon, really big", 1.5),
        ("the car is huge", 2.0),
        ("a big eyed owl", 1.0),
        ("a little rusty car", 1.0),
        ("a big haunted house", 1.5),
        ("a car, big and red", 1.5),
        ("a car, big and red wheels", 1.0),
    ],
)
def test_a_word_for_a_size_is_of_the_whole_thing(prompt: str, times: float) -> None:
    found = read(prompt)
    usual = read(f"a {found['thing']}")["size_m"]
    assert found["size_m"] == pytest.approx(times * usual)
    assert any("its usual size" in note for note in found["notes"]) == (times != 1)


@pytest.mark.parametrize(
    ("prompt", "sizes"),
    [
        ("truck with small black wheels", {"wheels": "small"}),
        ("a chair with long thin legs", {"legs": "long thin"}),
        ("a red mug with a thick blue handle", {"handle": "thick"}),
        ("an elephant with tiny ears and long tusks", {"ears": "tiny", "tusks": "long"}),
        ("a big crab with huge claws", {"claws": "huge"}),
        ("a dragon with large wings, red", {"wings": "large"}),
        ("a little rusty car with a big trunk", {}),
    ],
)
def test_a_size_before_a_part_is_that_part_s(prompt: str, sizes: dict) -> None:
    found = read(prompt)
    assert found["part_sizes"] == sizes
    for part, words in sizes.items():
        assert not set(words.split()) & set(found["left_out"]), part
        assert not any(note.startswith(words) for note in found["notes"])


def test_a_size_of_what_is_no_part_by_itself_is_left_out_and_said() -> None:
    painted = read("a rabbit with big feet")
    assert painted["part_sizes"] == {}
    assert painted["notes"] == ["big: left out, as that is not a separate part here."]
    assert read("a goblin with long ears")["notes"] == [
        "long ear: left out, as that is not a separate part here."
    ]
    found = read("a mug with a round handle")
    assert found["notes"] == ["round: left out, as only the whole thing has a shape."]
    assert read("a big eyed owl")["part_sizes"] == {}
    assert (
        "big: left out, as only the whole thing and its parts have a size."
        in (read("a big eyed owl")["notes"])
    )


def test_a_stated_size_counts_more_than_a_word_for_one() -> None:
    robot = read("a huge robot 2 m tall")
    assert robot["size_m"] == 2
    assert robot["notes"] == ["huge: left out, as another size is stated."]
    assert read("a big toy car")["size_m"] == read("not a toy car, a toy car")["size_m"] == 0.25
    assert read("a robot, not a toy")["size_m"] == read("a robot")["size_m"]
    assert read("a toy sailboat")["notes"] == ["toy: made no longer than 25 cm."]
    assert read("a scale model of a ship")["size_m"] == 0.25


@pytest.mark.parametrize(
    ("prompt", "part"),
    [
        ("floor lamp with a black tripod base", "foot"),
        ("a sofa with black velvet heart cushions", "cushion"),
        ("a dresser with black shell knobs", "handles"),
        ("a teapot with a black bird lid", "lid"),
    ],
)
def test_a_thing_before_a_part_says_what_the_part_is_like(prompt: str, part: str) -> None:
    assert read(prompt)["part_colours"] == {part: "black"}


@pytest.mark.parametrize(
    ("prompt", "gem"),
    [
        ("a silver ring with a blue stone", {"gem": "blue"}),
        ("a crown with red stones", {"gems": "red"}),
        ("a ruby ring", {"gem": "red"}),
        ("a ring in silver, blue stone", {"gem": "blue"}),
        ("a ring with a red stone and a silver band", {"gem": "red"}),
        ("a crown of stone", {}),
    ],
)
def test_a_stone_of_what_has_gems_is_one(prompt: str, gem: dict[str, str]) -> None:
    found = read(prompt)
    assert found["part_colours"] == gem
    assert ("stone" in found["materials"]) == (not gem)


@pytest.mark.parametrize(
    "prompt", ["a see-through vase", "a crystal bowl", "a mug with a transparent handle"]
)
def test_what_is_seen_through_is_of_clear_glass(prompt: str) -> None:
    clear = [surface.clear for surface in surfaces_of(parse(prompt))]
    assert max(clear) > 0.9


def test_a_slip_before_a_thing_is_no_other_thing() -> None:
    found = read("a blak leater sofa")
    assert (found["colours"], found["materials"]) == (["black"], ["leather"])
    assert read("a red buterfly")["thing"] == "butterfly"


@pytest.mark.parametrize(
    ("prompt", "material"),
    [
        ("a golden cat statue", "golden"),
        ("a lion statue", "stone"),
        ("a lion, statue", "stone"),
        ("an eagle cast in bronze", "bronze"),
        ("an owl carved from oak", "oak"),
        ("a wood carving of a bear", "wooden"),
        ("an ice sculpture of a swan", "of ice"),
        ("a horse made of iron", "iron"),
        ("a stone lion", "stone"),
        ("a chocolate bunny", "chocolate"),
        ("a marble angel", "marble"),
        ("a sculpture of a car", "stone"),
        ("an inflatable flamingo", "plastic"),
        ("a terracotta warrior", "terracotta"),
        ("an ice dragon", "of ice"),
        ("a dragon made of ice", "made of ice"),
        ("a dog made of bone", "made of bone"),
        ("a gummy dragon", "made of jelly"),
        ("a gummy bear", "gummy candy"),
        ("an iridescent beetle", "iridescent"),
    ],
)
def test_a_statue_is_of_one_material_eyes_and_all(prompt: str, material: str) -> None:
    words = parse(prompt)
    assert words.named_material() == material
    usual = CARVED_STONE if words.material == "stone" else words.material
    wanted = VARIANTS.get(material, Variant(usual)).kind
    assert {surface.kind for surface in surfaces_of(words)} == {wanted}


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("a cat sculpted from packed snow", "snow"),
        ("a wolf made of molten rock", "lava"),
        ("a lava golem", "lava"),  # and no moss on it
    ],
)
def test_of_snow_and_lava_all_is_but_for_the_eyes(prompt: str, kind: str) -> None:
    words = parse(prompt)
    of = {part.name: part.material for part in painted(words.noun, words)}
    assert {name for name, material in of.items() if material != "stone"} <= set(EYES)
    assert of["eyes"] == ""
    kinds = {surface.kind for surface in surfaces_of(words)}
    assert kind in kinds and len(kinds) > 1


@pytest.mark.parametrize(
    "prompt",
    [
        *("a golden retriever", "a golden lion", "a wooden cat", "a bronze robot", "a stone golem"),
        *("a robot cat", "a picture of a furry cat", "a chocolate labrador"),
        *("a copper coloured dog", "a clay brown horse", "a dragon on stone"),
    ],
)
def test_what_lives_or_moves_keeps_its_eyes(prompt: str) -> None:
    assert "eye" in {surface.kind for surface in surfaces_of(parse(prompt))}


def test_a_statues_part_may_have_a_look_of_its_own() -> None:
    found = read("a gold dragon statue with ruby eyes")
    assert (found["part_colours"], found["materials"]) == ({"eyes": "red"}, ["golden"])


def test_a_statue_of_which_no_material_is_named_says_what_it_is_of() -> None:
    assert "No material is named: made of stone." in read("a statue of a king")["notes"]
    assert "ice: made as ice." in read("an ice sculpture of a swan")["notes"]
    assert "No material is named: made of plush." in read("a shark plushie")["notes"]


@pytest.mark.parametrize(
    ("prompt", "thing", "material", "size"),
    [
        ("a stuffed bunny", "rabbit", "plush", 0.25),
        ("a panda plushie", "panda", "plush", 0.25),
        ("a soft toy elephant", "elephant", "plush", 0.25),
        ("a plush shark", "shark", "plush", 0.25),
        ("a fabric plush horse", "horse", "plush", 0.25),
        ("a wizard plushie", "wizard", "plush", 0.25),
        ("a stuffed animal", "teddy bear", "", 0.4),
    ],
)
def test_a_soft_toy_is_of_plush_and_small_and_has_its_eyes(
    prompt: str, thing: str, material: str, size: float
) -> None:
    words = parse(prompt)
    assert (words.noun, words.named_material()) == (thing, material)
    assert words.usual()[0] == size
    assert "eye" in {surface.kind for surface in surfaces_of(words)}


@pytest.mark.parametrize(
    "prompt",
    [
        "a boy holding a stuffed rabbit",
        "a bear, not stuffed",
        "a boy on an inflatable boat",
        "a soft toy basket",
        "a knitted armchair",
        "a statue of a girl with a stuffed rabbit",
    ],
)
def test_what_is_said_of_another_thing_makes_no_soft_toy(prompt: str) -> None:
    words = parse(prompt, ignore_unknown=True)
    assert not words.is_toy and words.named_material() in ("", "stone", "fabric")


@pytest.mark.parametrize(
    ("prompt", "material"),
    [
        ("an ice castle", ["of ice"]),
        ("an ice bucket", []),
        ("a snow leopard", []),
        ("a stuffed pepper", []),
        ("a bone throne", ["of bone"]),
        ("a bone china teapot", ["ceramic"]),
        ("an origami swan", ["paper"]),
        ("a snow castle", ["made of snow"]),
        ("a snow golem", ["made of snow"]),
        ("a sand golem", ["made of sand"]),
        ("a molten lava golem", ["made of lava"]),
        ("a magma sword", ["made of lava"]),
        ("a molten gold sword", ["golden"]),
        ("a molten chocolate cake", ["chocolate"]),
        ("a jelly cat", ["made of jelly"]),
        ("a candy house", ["made of candy"]),
        ("a house made entirely out of candy", ["made of candy"]),
        ("a moss wall", ["made of moss"]),
        ("a claymation cat", ["claymation"]),
        ("a sequined handbag", ["sequined"]),
        ("an iridescent glass vase", ["glass"]),
        *(
            (prompt, [])
            for prompt in (
                *("a snow globe", "a snow fox", "a snow shovel", "a fox in the snow", "a snowman"),
                *("a sand dollar", "a sandcastle", "a sand dragon", "a bucket of sand"),
                *("a jellyfish", "a jelly donut", "a jar of jelly", "a candy cane", "a candy shop"),
                *("a candy apple red car", "a bowl of candy", "a house made of candy canes"),
                *("a lava lamp", "a volcano with lava", "a lava volcano", "a moss covered rock"),
                *("a moss bear", "a cat on the moss", "a burnt orange car", "a burnt sienna vase"),
            )
        ),
    ],
)
def test_a_word_before_a_thing_may_be_what_it_is_of(prompt: str, material: list[str]) -> None:
    assert read(prompt)["materials"] == material


def test_a_material_behind_made_of_keeps_its_colour_and_its_thing() -> None:
    red = read("a bear made of red jelly wearing a hat")
    assert (red["thing"], red["colours"], red["materials"]) == ("bear", ["red"], ["made of jelly"])
    assert [one["thing"] for one in red["companions"]] == ["hat"]
    assert read("a bear made of moss")["left_out"] == []
    assert read("a molten lava golem")["left_out"] == []
    assert read("a gummy bear")["size_m"] == 0.02
    assert read("a snowball")["materials"] == ["packed snow"]


def test_a_statue_of_what_has_no_colour_of_its_own_is_of_one_colour() -> None:
    painted = {surface.color for surface in surfaces_of(parse("a chocolate bunny"))}
    assert len(painted) == 1


@pytest.mark.parametrize(
    ("prompt", "colours", "parts"),
    [
        ("a crow", ["black"], {"belly": "black", "bill": "charcoal", "legs": "charcoal"}),
        ("a white crow", ["white"], {}),
        (
            "a crow with a yellow bill",
            ["black"],
            {"bill": "yellow", "belly": "black", "legs": "charcoal"},
        ),
        ("a polar bear", ["white"], {"muzzle": "white"}),
        ("a businessman", ["charcoal"], {"trousers": "charcoal", "shoes": "black"}),
        ("a ruby", ["red"], {}),
        ("a balloon dog", ["red"], {}),
        ("a blue balloon dog", ["blue"], {}),
        ("an emerald ring", [], {"gem": "emerald"}),
        ("a ruby heart", ["red"], {}),
        ("a superhero with a red cape", [], {"cape": "red"}),
        ("a woman in a red shirt", [], {"shirt": "red"}),
        ("a man in a black suit", [], {"trousers": "black"}),
        ("a tuxedo", ["black"], {"shirt": "white", "zip": "black"}),
        ("a red tuxedo", ["red"], {}),
    ],
)
def test_a_kind_has_its_own_colours_and_who_wears_something_has_it(
    prompt: str, colours: list[str], parts: dict[str, str]
) -> None:
    found = read(prompt)
    assert (found["colours"], found["part_colours"]) == (colours, parts)


@pytest.mark.parametrize(
    ("prompt", "color", "material"),
    [
        ("a red tuxedo", "red", "fabric"),
        ("a tuxedo", "black", "fabric"),
        ("a leather coat", "navy", "leather"),
        ("a jacket", "", ""),
    ],
)
def test_a_kind_has_its_material_whatever_its_colour(prompt, color, material) -> None:
    words = parse(prompt)
    assert (words.color, words.material) == (color, material)


def test_every_kind_is_a_noun_with_such_parts_and_known_colours() -> None:
    for form in KINDS:
        slot, noun = LEXICON[form]
        whole, parts = look_of_kind(form)
        assert slot in ("noun", "color"), form
        assert {*whole, *parts.values()} <= LEXICON.keys(), form
        assert slot == "color" or parts.keys() <= NOUNS[noun].looks.keys(), form


def test_a_stained_glass_window_has_that_pane_and_a_frame_of_its_own() -> None:
    kinds = {
        part.name: part.material for part in painted("window", parse("a stained glass window"))
    }
    assert {part for part, kind in kinds.items() if kind} == {"glass"}


def test_gold_that_is_a_colour_of_fur_weighs_nothing() -> None:
    lion, golden, cast = (
        parse(prompt).usual()[1] for prompt in ("a lion", "a golden lion", "a lion made of gold")
    )
    assert lion == golden < cast / 10


def test_an_action_figure_is_small() -> None:
    words = parse("an action figure of a robot")
    assert (words.noun, words.is_toy, words.is_statue) == ("robot", True, False)


@pytest.mark.parametrize(
    ("prompt", "thing", "colours", "materials"),
    [
        ("two scoops of ice cream in a waffle cone", "ice cream", [], []),
        ("a scoop of vanilla ice cream in a cone", "ice cream", ["cream white"], []),
        ("strawberry ice cream cone", "ice cream", ["strawberry pink"], []),
        ("a chocolate ice cream", "ice cream", ["chocolate brown"], []),
        ("a Lego-style red brick", "lego brick", ["red"], []),
        ("a tin of sardines", "can", [], []),
        ("an old tin of green paint", "can", [], []),
        ("a cup made of tin", "mug", [], ["tin"]),
        ("a glass of red wine", "wine glass", ["red"], []),
        ("a salt shaker and a pepper mill", "salt shaker", [], []),
        ("a peach armchair", "armchair", ["peach orange"], []),
        ("a lemon cake", "cake", [], []),
        ("an olive drab jeep", "jeep", ["olive drab"], []),
        ("a blue-grey elephant", "elephant", ["blue grey"], []),
        ("a robot that is neither blue nor red", "robot", [], []),
        ("boxes made of cardboard", "cardboard box", [], []),
        ("a lantern made of paper", "paper lantern", [], []),
        ("a man made of snow", "snowman", [], []),
        ("a chair made of wood", "chair", [], ["wooden"]),
        ("a fence that has been painted green", "fence", ["green"], []),
        ("an orange and black tiger stripe sofa", "sofa", ["orange", "black"], []),
        ("a velvet-covered stool", "stool", [], ["velvet"]),
        ("a basket woven from straw", "basket", [], ["straw"]),
    ],
)
def test_a_thing_is_what_its_whole_name_says(
    prompt: str, thing: str, colours: list[str], materials: list[str]
) -> None:
    found = read(prompt)
    assert (found["thing"], found["colours"], found["materials"]) == (thing, colours, materials)


def test_a_shade_before_a_part_is_the_parts() -> None:
    assert read("a sofa with coral cushions")["part_colours"] == {"cushion": "coral orange"}
    found = read("a whitewashed cottage with a brown door")
    assert (found["colours"], found["part_colours"]) == (["whitewashed"], {"door": "brown"})
    names = {part.name: part.color for part in painted("cottage", parse("a whitewashed cottage"))}
    plain = {part.name: part.color for part in painted("cottage", parse("a cottage"))}
    assert names["walls"] != plain["walls"]
    assert {name: names[name] for name in ("roof", "door")} == {
        name: plain[name] for name in ("roof", "door")
    }


@pytest.mark.parametrize(
    ("prompt", "note"),
    [
        (
            "a chair with three legs",
            "three legs: left out, as the legs of a chair are not counted.",
        ),
        ("a sofa with four legs", "four legs: left out, as the legs of a sofa are not counted."),
        (
            "a bookshelf with four shelves",
            "shelves: left out, as that is not a separate part here.",
        ),
        ("a wizard with a big head", "big head: left out, as that is not a separate part here."),
        ("a car with a red roof", "red roof: left out, as that is not a separate part here."),
        ("a vase with three legs", "three legs: left out, as a vase has none here."),
    ],
)
def test_what_the_shape_has_but_no_part_is_said_to_be_none(prompt: str, note: str) -> None:
    assert note in read(prompt)["notes"]


@pytest.mark.parametrize(
    "prompt",
    ["a burning candle", "a lit candle", "a candle, burning", "a blazing torch", "a lit lantern"],
)
def test_what_burns_by_itself_is_lit_without_a_word(prompt: str) -> None:
    found = read(prompt)
    assert (found["sheen"], found["left_out"], found["notes"]) == ([], [], [])


def test_what_does_not_burn_by_itself_is_not() -> None:
    assert read("a burning car")["left_out"] == ["burning"]
    assert read("a lit sphere")["sheen"] == ["glowing"]
    assert read("a glowing candle")["sheen"] == ["glowing"]


@pytest.mark.parametrize(
    ("prompt", "material"),
    [
        ("a glass of orange juice with a straw", []),
        ("a paintbrush above a half-finished canvas", []),
        ("a hat made of straw", ["straw"]),
        ("a bag of canvas", ["fabric"]),
    ],
)
def test_a_straw_and_a_canvas_are_things(prompt: str, material: list[str]) -> None:
    assert read(prompt)["materials"] == material


@pytest.mark.parametrize(
    ("prompt", "thing", "left_out"),
    [
        ("a vibrant, handwoven rug", "rug", ["vibrant", "handwoven"]),
        ("a shaggy, brown dog", "dog", ["shaggy"]),
        ("the lush, dense, green bush", "bush", ["lush", "dense"]),
        ("a red, shiny car", "car", []),
    ],
)
def test_a_comma_between_adjectives_ends_nothing(prompt, thing, left_out) -> None:
    found = read(prompt)
    assert (found["thing"], found["left_out"]) == (thing, left_out)


@pytest.mark.parametrize(
    "prompt", ["an okapi, a zebra", "a friend, red chair", "a fizzy, of a chair"]
)
def test_a_comma_behind_another_things_name_does(prompt: str) -> None:
    with pytest.raises(UserError, match="does not know"):
        read(prompt)


def test_what_a_thing_has_three_of_is_its_own() -> None:
    found = read("a cake with three pink candles")
    assert found["part_colours"] == {"candles": "pink"}
    assert (found["part_counts"], found["notes"]) == ({"candles": 3}, [])


@pytest.mark.parametrize("name", ["roulette wheel", "potters wheel", "wheel of fortune"])
def test_a_wheel_of_another_sort_is_no_cars(name: str) -> None:
    with pytest.raises(UserError, match=f"does not know '{name}'"):
        read(f"a {name}")
    assert read("a wagon wheel")["thing"] == "wheel"


def test_potions_have_their_colours() -> None:
    said = ("a health potion", "mana potion", "a yellow health potion", "a potion")
    assert [read(one)["colours"] for one in said] == [["red"], ["blue"], ["yellow"], []]


def test_a_giants_club_is_no_giant_and_a_dolls_house_is_small() -> None:
    assert read("a giant's club")["size_m"] == read("a club")["size_m"]
    assert read("a doll's house")["size_m"] == read("a dollhouse")["size_m"] < 2


@pytest.mark.parametrize("name", ["truck scale", "postal scale", "shower head"])
def test_an_unknown_thing_is_named_whole(name: str) -> None:
    with pytest.raises(UserError, match=f"does not know '{name}'"):
        read(f"a {name}")
