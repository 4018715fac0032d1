"""What is said once of two parts, and what is done to a part: "framed in gold"."""

import pytest

from core.guidance.builtin.words.vocabulary import parse, understood

LEGS_SEAT_BACK = ("legs", "seat", "back")


@pytest.mark.parametrize(
    ("prompt", "colors", "materials"),
    [
        ("a wizard with purple hat and robe", {"hat": "purple", "robe": "purple"}, {}),
        ("a house with a red roof and door", {"roof": "red", "door": "red"}, {}),
        ("a horse with a black mane and hooves", {"mane": "black", "hooves": "black"}, {}),
        ("a teapot with golden handle and spout", {}, {"handle": "golden", "spout": "golden"}),
        ("a teapot with handle and spout in gold", {}, {"handle": "golden", "spout": "golden"}),
        ("a chair whose legs and back are chrome", {}, {"legs": "chrome", "back": "chrome"}),
        ("a chair, the legs and the back are black", {"legs": "black", "back": "black"}, {}),
        ("a bench with cast iron armrests and legs", {}, {"legs": "cast iron"}),
        ("a robot with silver head and arms", {}, {"head": "silver", "limbs": "silver"}),
        ("a knight with silver armor and shield", {}, {"armour": "silver", "shield": "silver"}),
        ("a bench with a red cushion and legs", {"seat": "red", "legs": "red"}, {}),
        (
            "a chair with red legs and seat and back",
            dict.fromkeys(("legs", "seat", "back"), "red"),
            {},
        ),
    ],
)
def test_what_is_said_of_two_joined_parts_is_of_both(prompt, colors, materials):
    words = parse(prompt)
    assert (words.part_shades(), words.part_materials()) == (colors, materials)
    assert (words.color, words.material) == ("", "")


@pytest.mark.parametrize(
    ("prompt", "colors", "materials"),
    [
        ("a house with red roof and green door", {"roof": "red", "door": "green"}, {}),
        ("a teapot with a golden handle and a spout", {}, {"handle": "golden"}),
        ("a teapot with a lid and a handle of wood", {}, {"handle": "wooden"}),
        ("a chair with leather seat and legs", {}, {"seat": "leather"}),
        ("a table with a glass top and legs", {}, {"top": "glass"}),
        ("a house with red roof and windows", {"roof": "red"}, {}),
        ("a crab with red claws and eyes", {"claws": "red"}, {}),
        ("a king with red robe and crown", {"robe": "red"}, {}),
        ("a cat with green eyes and muzzle", {"eyes": "green"}, {}),
        ("an axe with a wooden handle and head", {}, {"handle": "wooden"}),
        ("a knife with a wooden handle and blade", {}, {"handle": "wooden"}),
        ("a spoon with a wooden handle and bowl", {}, {"handle": "wooden"}),
        ("a sword with a stone grip and guard", {}, {"grip": "stone"}),
        ("a gnome with a red hat and beard", {"hat": "red"}, {}),
        ("a mermaid with a red tail and hair", {"tail": "red"}, {}),
        ("a watch with a leather strap and dial", {}, {"strap": "leather"}),
        ("a car without black wheels and windows", {}, {}),
        ("a desk with legs and drawers made of walnut", {}, {"drawers": "walnut"}),
    ],
)
def test_a_part_that_has_its_own_or_cannot_be_so_takes_nothing(prompt, colors, materials):
    words = parse(prompt)
    assert (words.part_shades(), words.part_materials()) == (colors, materials)


def test_a_pattern_of_two_colours_is_on_both_parts():
    words = parse("a pirate ship with red and white striped sails and flag")
    assert words.part_patterns() == dict.fromkeys(("sails", "flag"), "striped with white")
    assert words.part_shades() == {"sails": "red", "flag": "red"}


@pytest.mark.parametrize(
    ("prompt", "materials"),
    [
        ("a mirror framed in gold", {"frame": "golden"}),
        ("a table topped with green marble", {"top": "green marble"}),
        ("a barrel banded in iron", {"hoops": "iron"}),
        ("a spear tipped with bronze", {"head": "bronze"}),
        ("a rocking chair whose seat is woven from straw", {"seat": "straw"}),
        ("a knife with a handle carved from bone", {"handle": "from bone"}),
        ("a knife with a bone handle", {"handle": "of bone"}),
        ("a lamp whose shade is knitted from wool", {"shade": "wool"}),
        ("a lamp with legs cast in bronze", {"foot": "bronze"}),
        ("a stool with three legs made of oak", {"legs": "oak"}),
    ],
)
def test_how_a_part_was_made_is_of_the_part(prompt, materials):
    words = parse(prompt)
    assert (words.part_materials(), words.material) == (materials, "")


@pytest.mark.parametrize(
    ("prompt", "materials", "parts"),
    [
        ("a basket woven from straw", ["straw"], {}),
        ("a woven basket", [], {}),
        ("a door carved from oak", ["oak"], {}),
        ("a gold jewelled crown", ["golden"], {}),
        ("a sword with a golden jewelled handle", [], {"grip": "golden"}),
        ("a park bench with cast iron ends", [], {"legs": "cast iron"}),
        ("a wooden bench with a black metal frame", ["wooden"], {"legs": "black metal"}),
        ("a lantern with frosted glass panes", [], {"glass": "frosted glass"}),
    ],
)
def test_a_material_is_of_what_it_is_said_of(prompt, materials, parts):
    found = understood(prompt)
    assert (found["materials"], found["part_materials"]) == (materials, parts)


def test_a_thing_calls_its_own_parts_as_it_likes():
    assert parse("a drum kit with a red bass drum").part_shades() == {"shells": "red"}
    assert parse("a castle with a red gate").part_shades() == {"door": "red"}
    assert parse("a flashlight with a black switch").part_shades() == {"button": "black"}
    assert parse("a staff topped with a green orb").part_shades() == {"crystal": "green"}
    assert parse("a laptop with a black keyboard").part_shades() == {"keys": "black"}
    assert parse("a helmet with gold trim and a red plume").part_materials() == {"rim": "golden"}
    assert parse("a red jewelled crown").part_shades() == {"gems": "red"}


@pytest.mark.parametrize(
    ("prompt", "glowing"),
    [
        ("a wooden staff, purple crystal on top, glowing", {"crystal": "glowing"}),
        ("a lantern with green glass, glowing", {"glass": "glowing"}),
        ("a sword, red blade, glowing", {}),
        ("a glass vase, glowing", {}),
    ],
)
def test_what_glows_is_what_light_comes_through(prompt, glowing):
    words = parse(prompt)
    assert words.of_parts("sheen") == glowing
    assert words.sheen == (() if glowing else ("glowing",))


@pytest.mark.parametrize("prompt", ["a table edged in brass", "a mirror edged with gold"])
def test_what_has_no_edge_by_itself_is_no_other_part(prompt):
    assert not parse(prompt).part_materials()


@pytest.mark.parametrize(
    ("prompt", "color", "others"),
    [
        ("a chocolate and vanilla ice cream", "chocolate brown", ["vanilla"]),
        ("a vanilla and chocolate ice cream", "cream white", ["chocolate"]),
        ("vanilla, chocolate and mint ice cream", "cream white", ["chocolate", "mint"]),
        ("strawberry and lemon and vanilla ice cream", "strawberry pink", ["lemon", "vanilla"]),
    ],
)
def test_of_two_tastes_the_first_is_taken_and_the_other_told(prompt, color, others):
    words = parse(prompt)
    assert (words.noun, words.color_form, words.material) == ("ice cream", color, "")
    assert list(words.notes) == [f"{one}: left out, as one taste is taken." for one in others]


@pytest.mark.parametrize("prompt", ["a table edged in brass", "a table trimmed with brass"])
def test_what_edges_a_thing_without_edges_is_not_all_of_it(prompt):
    words = parse(prompt)
    assert (words.material, words.left_out) == ("", ("brass edges",))


@pytest.mark.parametrize(
    ("prompt", "thing", "colors", "materials"),
    [
        (
            "a canopy bed with mahogany posts and cream curtains",
            "four-poster bed",
            {"curtains": "cream"},
            {"frame": "mahogany"},
        ),
        ("a hot air balloon with a wicker gondola", "hot air balloon", {}, {"basket": "wicker"}),
        ("an arcade cabinet with purple sides", "arcade machine", {"body": "purple"}, {}),
        (
            "a rifle with white panels and blue accents",  # its trim is not all of it
            "rifle",
            {"body": "white", "barrel": "blue", "magazine": "blue", "scope": "blue"},
            {},
        ),
        ("a briefcase with gold clasps", "briefcase", {}, {"latches": "golden"}),
        ("a bubble tea with black tapioca", "bubble tea", {"pearls": "black"}, {}),
        (  # what the first said of all its trim the second cannot say again
            "a rifle with blue trim and red accents",
            "rifle",
            {"barrel": "blue", "magazine": "blue", "scope": "blue"},
            {},
        ),
        ("a farmhouse dining table with white legs", "table", {"legs": "white"}, {}),
    ],
)
def test_a_part_goes_by_its_own_things_names(prompt, thing, colors, materials):
    found = understood(prompt)
    assert found["thing"] == thing
    assert (found["part_colours"], found["part_materials"]) == (colors, materials)


@pytest.mark.parametrize("prompt", ["a silver candelabra", "a silver bar"])
def test_what_is_of_silver_is_not_of_gold(prompt):
    assert understood(prompt)["materials"] == ["silver"]


def test_what_finds_its_parts_taken_is_said():
    (note,) = understood("a rifle with blue trim and red accents")["notes"]
    assert note.startswith("red accents: left out")


def test_a_gargoyle_may_be_old_and_a_kind_has_its_colours():
    assert understood("an old stone gargoyle")["weather"] == ["worn"]
    found = understood("a lemonade")
    assert (found["thing"], found["colours"]) == ("bubble tea", ["yellow"])
    assert understood("ski goggles")["notes"] == ["ski goggles: made as goggles."]
