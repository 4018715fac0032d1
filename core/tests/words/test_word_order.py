"""Words that come in another order than that in which they are read."""

import pytest

from core.errors import UserError
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.vocabulary import parse, understood


def read(prompt: str) -> dict:
    return understood(prompt, known=SLOTS)


def parts(prompt: str) -> dict[str, dict[str, str]]:
    """What the prompt says of each part, without what it says of nothing."""
    names = ("part_colours", "part_materials", "part_sheens", "part_patterns")
    return {name: told for name in names if (told := read(prompt).get(name))}


@pytest.mark.parametrize(
    ("prompt", "said"),
    [
        ("a car with wheels in black", {"part_colours": {"wheels": "black"}}),
        ("a mirror with red and gold bands", {}),  # stripes, of the whole
        ("a chest with gold and iron bands", {"part_materials": {"bands": "iron"}}),
        ("a castle with blue roofs", {"part_colours": {"roof": "blue"}}),
        ("a car with wheels that are black", {"part_colours": {"wheels": "black"}}),
        ("hammer with a handle made of wood", {"part_materials": {"handle": "wooden"}}),
        ("a table with legs made out of steel", {"part_materials": {"legs": "metal"}}),
        ("a table, legs painted white", {"part_colours": {"legs": "white"}}),
        ("a car whose wheels are black", {"part_colours": {"wheels": "black"}}),
        ("A car. The wheels are black.", {"part_colours": {"wheels": "black"}}),
        ("a robot and its eyes are yellow", {"part_colours": {"eyes": "yellow"}}),
        ("a robot with its head blue", {"part_colours": {"head": "blue"}}),
        ("knife with handle wooden", {"part_materials": {"handle": "wooden"}}),
        ("a teapot, make the lid gold", {"part_materials": {"lid": "golden"}}),
        ("a teapot, the lid should be gold", {"part_materials": {"lid": "golden"}}),
        ("a car, wheels silver", {"part_materials": {"wheels": "silver"}}),  # no car wheel
        ("a table whose top is marble", {"part_materials": {"top": "marble"}}),
        (
            "a robot whose eyes glow yellow",
            {"part_colours": {"eyes": "yellow"}, "part_sheens": {"eyes": "glowing"}},
        ),
        ("bicycle with a frame painted in red", {"part_colours": {"frame": "red"}}),
        ("lamp with a shade in signal orange", {"part_colours": {"shade": "orange"}}),
        (
            "lamp with a shade in a cream linen",
            {"part_colours": {"shade": "cream"}, "part_materials": {"shade": "linen"}},
        ),
        (
            "desk lamp, base in satin black, shade in dark green",
            {
                "part_colours": {"base": "black", "shade": "dark green"},
                "part_sheens": {"base": "satin"},
            },
        ),
        (
            "a chair with legs of brushed brass and a seat in blue velvet",
            {
                "part_colours": {"seat": "blue"},
                "part_materials": {"legs": "brass", "seat": "velvet"},
            },
        ),
        (
            "a longship with a striped red and white sail",
            {
                "part_colours": {"sail": "red"},
                "part_patterns": {"sail": "striped with white"},
            },
        ),
    ],
)
def test_what_is_said_behind_a_part_is_the_parts(prompt: str, said: dict) -> None:
    assert parts(prompt) == said
    assert not read(prompt)["colours"] and not read(prompt)["materials"]


@pytest.mark.parametrize(
    ("prompt", "same"),
    [
        ("a robot, head in blue", "a robot with a blue head"),
        ("a teapot with a spout in gold", "a teapot with a golden spout"),
        ("a mug with stripes in red", "a mug with red stripes"),
        ("a king size bed with a headboard in beige", "a bed with a beige headboard"),
    ],
)
def test_it_is_the_same_before_and_behind(prompt: str, same: str) -> None:
    assert parts(prompt) == parts(same)
    assert read(prompt)["colours"] == read(same)["colours"]


@pytest.mark.parametrize(
    ("prompt", "color", "material"),
    [
        ("a red chair made of oak", "red", "oak"),
        ("a horse statue in bronze", "", "bronze"),
        ("a car in black", "black", ""),
        ("a powder coated mustard chair", "mustard", ""),
        ("a bear with a red scarf in blue", "blue", ""),  # whose scarf is red already
        ("an oak wardrobe with doors, in white", "white", "oak"),
        ("a dragon in green with wings in gold", "green", ""),
        ("a vase of roses in blue glass", "blue", "glass"),  # not what it is full of
        ("the car is red and the wheels are black", "red", ""),
        ("an armchair upholstered in green velvet", "green", "velvet"),
        ("a dining table in light oak with tapered legs", "", "light oak"),
    ],
)
def test_what_is_said_of_the_thing_stays_the_things(prompt: str, color: str, material: str) -> None:
    got = read(prompt)
    assert got["colours"] == ([color] if color else [])
    assert got["materials"] == ([material] if material else [])


@pytest.mark.parametrize(
    ("prompt", "other"),
    [
        ("penguins near a block of ice", "block"),
        ("a man near a horse in black", "horse"),
        ("a chair with a lamp made of gold", "lamp"),
    ],
)
def test_what_is_said_of_something_else_is_left_out_with_it(prompt: str, other: str) -> None:
    got = read(prompt)
    assert not got["colours"] and not got["materials"]
    assert other in got["left_out"]
    assert any(note.split(":")[0].endswith(f" {other}") for note in got["notes"])


@pytest.mark.parametrize(
    ("prompt", "thing", "weather"),
    [
        ("a stack of old books", "stack of books", ["worn"]),
        ("a stack of dusty leather bound books tied with twine", "stack of books", ["dusty"]),
        ("a slice of juicy red watermelon", "watermelon slice", []),
    ],
)
def test_a_name_may_have_words_within(prompt: str, thing: str, weather: list[str]) -> None:
    got = read(prompt)
    assert (got["thing"], got["weather"]) == (thing, weather)


def test_of_two_materials_of_a_part_the_one_that_says_more_is_its_own() -> None:
    got = read("sunglasses, tortoiseshell acetate frame")
    assert got["part_materials"] == {"frame": "tortoiseshell"} and got["materials"] == []
    assert "acetate" in got["left_out"]
    assert parts("a chair with gold metal legs") == {"part_materials": {"legs": "golden"}}


def test_the_coffee_is_black_not_the_cup() -> None:
    assert read("a cup of hot black coffee")["colours"] == []


def test_a_robot_dog_is_of_metal_where_nothing_else_is_said() -> None:
    assert read("a robot dog")["materials"] == ["metal"]
    assert "robot" not in read("a robot dog")["left_out"]
    assert read("a golden robot dog")["materials"] == ["golden"]
    assert read("a robot dog that is silver")["materials"] == ["silver"]


def test_a_part_cannot_be_mossy_by_itself() -> None:
    got = read("a stone well with a mossy roof")
    assert got["weather"] == [] and got["materials"] == ["stone"]
    assert "mossy: left out, as only the whole thing can be mossy." in got["notes"]
    assert read("a mossy stone well with a roof")["weather"] == ["mossy"]


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("the life cycle of a frog", "frog"),
        ("a music box", "chest"),
        ("a shoji screen", "door"),
        ("a tumbler", "goblet"),
        ("a mooring bollard", "column"),
        ("low key just want a fat pigeon", "bird"),
    ],
)
def test_what_people_type(prompt: str, thing: str) -> None:
    assert read(prompt)["thing"] == thing


def test_a_long_list_of_colours_is_read_in_time_that_grows_with_it() -> None:
    """Look-ups of what the words mean, not seconds: with each of 600 colours 1,200 before it were
    looked up, and it took 40 s."""
    count = 0

    class Counting(dict):
        def get(self, *key):
            nonlocal count
            count += 1
            return super().get(*key)

        __getitem__ = get

    known = Counting(SLOTS)
    counts = []
    for colors in (50, 100):
        count = 0
        understood("a chair " + "red " * colors, known=known)
        counts.append(count)
    assert 0 < counts[1] < 2.2 * counts[0]


def test_the_words_between_a_part_and_its_look_are_not_reported() -> None:
    got = read("a teapot, the lid should be gold")
    assert got["part_materials"] == {"lid": "golden"} and not got["left_out"] and not got["notes"]


def test_what_a_thing_is_for_is_a_part_of_its_name():
    assert read("the lamp for desk with a red base")["thing"] == "desk lamp"
    assert read("a house for the birds")["thing"] == "birdhouse"
    assert read("a table for coffee in oak")["thing"] == "coffee table"
    assert read("a mug for coffee")["thing"] == "mug"
    assert read("a lamp, for desk lovers")["thing"] == "lamp"


def test_looks_behind_what_a_thing_is_for_are_the_things():
    assert read("helmet for motorbike black and neon green pls")["colours"] == [
        "black",
        "neon green",
    ]
    assert read("a helmet for a biker in black")["colours"] == ["black"]
    assert read("a chest for gold coins")["materials"] == []
    assert read("a helmet for me, black")["colours"] == ["black"]


def test_bands_of_two_colours_are_stripes_where_a_thing_has_no_bands():
    told = read("lighthouse with red and white bands on a small rock")
    assert (told["pattern"], told["colours"]) == ("striped", ["red", "white"])
    assert "materials" not in told or not told["materials"]
    assert read("a chest with red and blue bands")["part_colours"] == {"bands": "blue"}


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("car sports like that but purple", "sports car"),
        ("a chair office black", "office chair"),
        ("a table coffee of oak", "coffee table"),
        ("a lamp, desk with it", "lamp"),
        ("a cat robot", "robot"),
        ("a lamp post", "street lamp"),
    ],
)
def test_what_qualifies_a_thing_may_come_last(prompt, thing):
    assert read(prompt)["thing"] == thing


@pytest.mark.parametrize(
    ("prompt", "materials"),
    [
        ("an egyptian pyramid, sandstone blocks, with a small entrance", ["sandstone"]),
        ("a fireplace made of granite slabs and a wooden mantel", ["granite"]),
        ("a fireplace of blue ceramic tiles", ["ceramic"]),
        ("a fireplace of red bricks", ["brick"]),
        ("a house with slate tiles", []),  # these are its roof's
        ("a red car with carbon fiber panels", []),
    ],
)
def test_what_a_material_comes_in_is_no_thing(prompt: str, materials: list[str]) -> None:
    assert understood(prompt)["materials"] == materials


def test_pieces_that_a_thing_has_are_its_part() -> None:
    assert understood("a door of glass panels")["part_materials"] == {"panels": "glass"}


@pytest.mark.parametrize(
    ("prompt", "thing", "pot", "color"),
    [
        ("a terracotta plant pot with a monstera", "potted plant", "terracotta", []),
        ("white ceramic flower pot containing a small cactus", "cactus", "ceramic", []),
        ("a handmade copper plant pot with a green cactus", "cactus", "copper", ["green"]),
        # What a cactus's pot has not.
        ("a tall ceramic plant pot with a cactus", "flower pot", None, []),
        ("a ceramic plant pot with a cactus, blue rim", "flower pot", None, []),
    ],
)
def test_a_pot_with_a_plant_is_the_plant(
    prompt: str, thing: str, pot: str | None, color: list[str]
) -> None:
    read = understood(prompt)
    assert (read["thing"], read["part_materials"].get("pot")) == (thing, pot)
    assert read["colours"] == color


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("my daughter wants a purple butterfly", "butterfly"),
        ("our client would like to have an armchair", "armchair"),
        ("my kids want a robot", "robot"),
        ("my boyfriend really wants a sports car", "sports car"),
    ],
)
def test_who_it_is_for_is_not_read(prompt: str, thing: str) -> None:
    assert understood(prompt)["thing"] == thing


def test_a_thing_that_wants_another_is_not_left_out_silently() -> None:
    with pytest.raises(UserError):
        understood("a dragon needs a knight")


@pytest.mark.parametrize(
    ("prompt", "thing", "color"),
    [
        ("a pumpkin orange with a green stem", "pumpkin", ["orange"]),
        ("an apple green", "apple", ["green"]),
        ("a periwinkle blue jay", "bird", ["periwinkle"]),
        ("a coral red stapler", "stapler", ["coral red"]),
        ("a stapler in glossy coral red", "stapler", ["coral red"]),
    ],
)
def test_a_shade_that_is_a_things_name(prompt: str, thing: str, color: list[str]) -> None:
    read = understood(prompt)
    assert (read["thing"], read["colours"]) == (thing, color)


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("a modern white house", "modern house"),
        ("modern two storey house with flat roof, white plaster walls", "modern house"),
        ("a spiral stone staircase", "spiral staircase"),
        ("an electric red guitar", "electric guitar"),
        ("a red torii gate", "torii gate"),
        ("a wooden gate", "gate"),
        ("a king bed", "bed"),
    ],
)
def test_a_name_may_have_looks_within(prompt: str, thing: str) -> None:
    assert understood(prompt)["thing"] == thing


@pytest.mark.parametrize(
    ("prompt", "said"),
    [
        ("the seat is red and the legs are white, chair", {"seat": "red", "legs": "white"}),
        ("the handle is black, the pan is copper", {"handle": "black"}),
        ("white legs and red seat, a stool", {"legs": "white", "seat": "red"}),
        ("black wheels, a red car", {"wheels": "black"}),
        ("yellow eyes, a black cat", {"eyes": "yellow"}),
        ("red roof, white walls, a house", {"roof": "red", "walls": "white"}),
        ("red lid white teapot", {"lid": "red"}),
        ("green shade brass desk lamp", {"shade": "green"}),
        ("a red chair", {}),
    ],
)
def test_parts_may_come_before_their_thing(prompt: str, said: dict[str, str]) -> None:
    found = read(prompt)
    assert found["part_colours"] == said
    assert found["pattern"] is None


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("a red window, like in a house", "window"),
        ("a red hat, wizard style", "hat"),
        ("a door, a house", "door"),
        ("a red door, a house", "house"),
    ],
)
def test_a_thing_before_another_is_its_part_where_a_look_is_said_of_it(
    prompt: str, thing: str
) -> None:
    assert read(prompt)["thing"] == thing


def test_another_things_part_is_a_part_and_its_look() -> None:
    assert read("a typewriter with black keys")["part_colours"] == {"keys": "black"}
    piano = read("a white piano with red black keys")
    assert piano["part_colours"] == {"black keys": "red"}


def test_dots_on_a_part_are_the_parts() -> None:
    found = parts("a lamp with a red shade with white dots")
    shade = {"part_colours": {"shade": "red"}, "part_patterns": {"shade": "spotted with white"}}
    assert found == shade
    assert read("a mug with white dots")["pattern"] == "spotted"


@pytest.mark.parametrize(
    ("prompt", "color"),
    [
        ("a mushroom, red cap with white spots", ""),
        ("a green mushroom, red and white spotted cap", "green"),
        ("a mushroom, red, and a white spotted cap", "red"),
    ],
)
def test_two_colours_of_a_part_are_its_own_behind_a_comma_too(prompt: str, color: str) -> None:
    words = parse(prompt, known=SLOTS)
    assert words.color == color
    both = {"cap": "spotted with white"} if color != "red" else {"cap": "spotted"}
    assert words.part_patterns() == both


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("a pirate ship figurehead shaped like a mermaid", "mermaid"),
        ("a trinket in the shape of a golden turtle", "turtle"),
        ("a brass doorstop shaped like a dog", "dog"),
        ("a mug shaped like a skull", "mug"),
        ("a necklace in the form of a snake", "necklace"),
    ],
)
def test_what_is_not_known_is_made_as_what_it_is_shaped_like(prompt: str, thing: str) -> None:
    assert parse(prompt, known=SLOTS).noun == thing


def test_the_numbers_and_dots_of_dice_are_their_pips() -> None:
    for said in ("gold numbers", "gold dots", "gold spots"):
        assert parse(f"red dice with {said}", known=SLOTS).part_materials() == {"pips": "golden"}
