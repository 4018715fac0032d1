"""What a prompt is made as, what is left out of it and why: compounds, narrower words, hints."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from core.errors import MissingError, UserError
from core.guidance.builtin import offered
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.offered import WEIGHTS, offered_words, read_metadata
from core.guidance.builtin.words.grammar.lexicon import (
    LEXICON,
    MEANT,
    NARROWER,
    SLOTS,
    nearest_words,
)
from core.guidance.builtin.words.groups import word_groups
from core.guidance.builtin.words.tables.nearest import NEAREST
from core.guidance.builtin.words.vocabulary import (
    UnknownWordsError,
    Words,
    parse,
    understood,
    words_report,
)

ROOT = Path(__file__).parents[3]

# Everyday prompts: what each is made as, and what is left out of it.
EVERYDAY = {
    "an acoustic guitar": ("guitar", ["acoustic"]),
    "an office chair": ("office chair", []),
    "a wine bottle": ("bottle", []),
    "a pirate hat": ("pirate hat", []),
    "a desk lamp": ("desk lamp", []),
    "a kitchen table": ("table", []),
    "a wooden rocking chair": ("rocking chair", []),
    "a police car": ("police car", []),
    "a yellow school bus": ("school bus", []),
    "a pickup truck": ("pickup truck", []),
    "a fire truck": ("fire truck", []),
    "a hot air balloon": ("hot air balloon", []),
    "a street lamp": ("street lamp", []),
    "a birthday cupcake": ("cupcake", ["birthday"]),
    "a halloween pumpkin": ("jack-o-lantern", []),
    "a wizard hat": ("wizard hat", []),
    "a garden bench": ("bench", ["garden"]),
    "a park bench": ("bench", []),
    "a coffee mug": ("mug", []),
    "a coffee table": ("coffee table", []),
    "a picnic table": ("picnic table", []),
    "a tennis ball": ("tennis ball", []),
    "a golf ball": ("golf ball", []),
    "a disco ball": ("disco ball", []),
    "a viking boat": ("longship", []),
    "a house boat": ("boat", []),
    "a tree house": ("treehouse", []),
    "a greek vase": ("vase", ["greek"]),
    "a haunted house": ("house", ["haunted"]),
    "a polar bear": ("bear", []),
    "a king size bed": ("bed", ["king size"]),
    "a leather office chair": ("office chair", []),
    "an oak piano bench": ("bench", ["piano"]),
    "a toy train": ("train", []),
    "a battle axe": ("axe", []),
    "a blue robot with yellow eyes": ("robot", []),
    "a spaceship": ("spaceship", []),
    "a stone castle": ("castle", []),
    "a treasure chest": ("chest", []),
    "a dragon": ("dragon", []),
    "a mushroom soup": ("ramen", ["mushroom"]),
    "an ostrich": ("ostrich", []),
    "a computer mouse": ("computer mouse", []),
    "a small sea horse": ("seahorse", []),
    "a starfish": ("starfish", []),
    "a bird house": ("birdhouse", []),
    "a lumpy grey rock": ("boulder", ["lumpy"]),
    "rocks": ("boulder", []),
    "a table of stone": ("table", []),
    "a stone thing": ("", []),
    "a pile of gold coins": ("coin", []),
}


@pytest.mark.parametrize("prompt", EVERYDAY)
def test_everyday_prompts_are_taken_by_their_head_noun_or_refused(prompt):
    noun, left_out = EVERYDAY[prompt]
    if not noun:
        with pytest.raises(UnknownWordsError):
            understood(prompt)
        return
    found = understood(prompt)
    assert (found["thing"], found["left_out"]) == (noun, left_out)
    for word in left_out:  # nothing is left out silently
        assert any(repr(word) in note and "left out" in note for note in found["notes"])


def test_most_everyday_prompts_are_taken():
    taken = sum(bool(noun) for noun, _ in EVERYDAY.values())
    assert len(EVERYDAY) >= 40
    assert taken / len(EVERYDAY) > 0.85


def test_four_of_five_things_that_people_ask_for_are_known():
    prompts = (Path(__file__).parents[1] / "everyday_prompts.txt").read_text().splitlines()
    taken = [words_report(prompt)[1] == 0 for prompt in prompts]
    assert len(set(prompts)) == 200
    assert sum(taken) >= 160


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a red patio chair", Words("chair", color="red")),
        ("a patio chair, red", Words("chair", color="red")),
        ("a striped beach ball without a handle", Words("beach ball", pattern="striped")),
        ("a new okapi striped chair", Words("chair", pattern="striped")),
        ("a hallway lamp with a red shade", Words("lamp", second="red", target="shade")),
    ],
)
def test_the_rest_of_a_compounds_prompt_is_read_as_ever(prompt, words):
    assert parse(prompt) == words


@pytest.mark.parametrize(
    "prompt",
    [
        "a okapi with a chair",  # another phrase
        "a okapi, chair",
        "a okapi and a chair",
        "a chair okapi",  # the head is the unknown one
        "a chair and a okapi",
        "okapi of a chair",
        "okapi and chair",
        "a okapi wearing a hat",
    ],
)
def test_an_unknown_word_is_left_out_only_right_before_its_noun(prompt):
    with pytest.raises(UnknownWordsError, match="'okapi'"):
        parse(prompt)


@pytest.mark.parametrize(
    ("prompt", "words", "aside"),
    [
        ("a teapot with red pillows", Words("teapot"), "red pillow"),
        ("a jar of red flowers, blue", Words("jar", color="blue"), "red flower"),
        ("a yellow teapot with a wooden sword", Words("teapot", color="yellow"), "wooden sword"),
        ("table with lamp", Words("table"), "lamp"),
    ],
)
def test_what_goes_with_a_thing_is_left_out_with_its_colours_and_reported(prompt, words, aside):
    found = parse(prompt)
    assert found == words
    assert f"{aside}: left out, as one thing is made at a time." in found.notes
    assert " ".join(found.left_out) == aside


def test_the_report_has_what_each_part_is_of_and_how_it_shines():
    found = understood("a teal toaster with matte chrome trim")
    assert found["part_materials"] == {"lever": "chrome", "knob": "chrome"}
    assert found["part_sheens"] == {"lever": "matte", "knob": "matte"}


def test_an_unknown_word_in_what_goes_with_a_thing_is_left_out_and_reported():
    found = parse("a knight in golden xyzzy, red")
    assert found == Words("knight", color="red")
    assert found.left_out == ("xyzzy", "golden")
    # Before a part of the thing the same word only qualifies that.
    assert parse("a teapot with a navy xyzzy lid").second == "navy"
    assert "'xyzzy'" in found.notes[-1]


def test_the_colour_after_with_is_the_things_where_nothing_else_is_there_for_it():
    assert parse("a chair in blue") == Words("chair", color="blue")
    assert parse("a chair of gold") == Words("chair", material="golden")
    assert parse("a teapot with a navy lid").target == "lid"


def test_a_noun_that_says_how_a_thing_is_shaped_is_a_qualifier():
    found = parse("a red heart-shaped box")
    assert (found.noun, found.color, found.left_out) == ("cube", "red", ("heart",))


def test_a_part_alone_is_no_thing():
    with pytest.raises(UnknownWordsError, match=r"'face' \(did you mean bust\?\)"):
        parse("a face")


def test_two_things_are_refused_and_what_is_listed_after_the_thing_is_left_out():
    with pytest.raises(UserError, match="one thing"):
        parse("a table or a lamp")
    words = parse("a red chair, a green lamp")
    assert (words.noun, words.color, words.left_out) == ("chair", "red", ("green", "lamp"))


def test_a_part_of_the_thing_is_no_compound():
    assert parse("a snowman hat").part == "hat"
    assert parse("a snowman hat").noun == "snowman"


@pytest.mark.parametrize(
    ("prompt", "note"),
    [
        ("a pony", "pony: made as a horse."),
        ("woks", "wok: made as a pan."),
        ("a gateway", "gateway: made as an arch."),
        ("a wild boar", "wild boar: made as a pig."),
        ("a grizzly", "grizzly: made as a bear."),
        ("a school desk", "school desk: made as a desk."),
        ("a turret", "turret: made as a tower."),
        ("an iphone", "iphone: made as a phone."),
        ("a vinyl chair", "vinyl: made as plastic."),
        ("a tartan sofa", "tartan: drawn as checkered."),
        ("a long table", "long: made wide."),
    ],
)
def test_a_narrower_word_is_reported(prompt, note):
    assert parse(prompt).notes == (note,)


@pytest.mark.parametrize(
    "prompt",
    ["an oak chair", "a teal mug", "a doughnut", "a couch", "an automobile", "a grey bunny"],
)
def test_a_true_synonym_is_not(prompt):
    assert parse(prompt).notes == ()


def test_a_narrower_word_that_is_left_out_is_not_made_as_anything():
    assert parse("a pony lamp").notes == ("'pony': left out, as it is not drawn.",)


def test_narrower_words_are_known_words_and_no_slot_is_all_narrower():
    assert set(LEXICON) >= NARROWER
    # A part's name may be another thing's: a hot dog's sausage.
    slots = set(SLOTS) - {"target"}
    assert not any(word in NARROWER for slot in slots for word in SLOTS[slot])


def test_a_colour_or_a_material_that_is_left_out_comes_with_the_nearest():
    note = parse("a cement sofa").notes[-1]
    assert note == "The built-in model does not know 'cement' (did you mean stone?): left out."
    assert "(did you mean green?)" in parse("a grren chair").notes[-1]


@pytest.mark.parametrize(
    ("word", "near"),
    [
        ("grail", ["goblet"]),
        ("tornado", ["cone"]),
        ("tornados", ["cone"]),
        ("periscope", ["telescope"]),
        ("minaret", ["tower"]),
        ("slug", ["snail"]),
        ("match", ["candle"]),
        ("brook", []),  # not book
        ("astrolabe", []),  # near to nothing
        ("xyzzy", []),
        ("grren", ["green"]),  # a misspelling
        ("ceramix", ["ceramic"]),
    ],
)
def test_hints_are_near_in_meaning_and_in_letters_only_for_misspellings(word, near):
    assert nearest_words(word) == near


def test_each_unknown_word_has_one_meaning_and_hints_with_it_first():
    forms = [form for row in NEAREST.values() for form in row.split(", ")]
    assert len(forms) == len(set(forms)) == len(MEANT)
    for word, row in NEAREST.items():
        assert all(nearest_words(form)[0] == word for form in row.split(", "))


def test_what_is_understood_is_plain_data():
    found = understood("a tall two-tone oak house without a chimney, red and white")
    assert json.loads(json.dumps(found)) == found == {
        "prompt": "a tall two-tone oak house without a chimney, red and white",
        "thing": "house",
        "style": None,
        "pose": None,
            "mood": None,
        "cut": None,
        "count": 1,
        "order": "row",
        "shape": "tall",
        "parts": ["no chimney"],
        "colours": ["red", "white"],
        "part_colours": {},
        "part_materials": {},
        "part_sizes": {},
        "part_counts": {},
        "part_sheens": {},
        "part_patterns": {},
        "emblems": [],
        "weather": [],
        "sheen": [],
        "companions": [],
        "materials": ["oak"],
        "pattern": "two-tone",
        "size_m": 8.0,
            "side": "length",
            "density": 97.5,
        "left_out": [],
        "notes": [],
    }  # fmt: skip


def test_the_report_of_a_refused_prompt_has_the_nearest_meanings_and_exit_code_2():
    report, code = words_report("a minaret and an astrolabe")
    assert code == 2
    assert report["nearest"] == {"minaret": ["tower"], "astrolabe": []}
    assert "'minaret' (did you mean tower?)" in report["error"]
    assert "--guidance FOLDER" in report["fix"]
    # Of an unknown compound the head noun has the nearest thing.
    assert words_report("a brass minaret")[0]["nearest"] == {"minaret": ["tower"]}
    assert words_report("a cement office minaret")[0]["nearest"] == {
        "cement": ["stone"],
        "office": [],
        "minaret": ["tower"],
    }
    assert words_report("a red chair") == (understood("a red chair"), 0)
    assert words_report("a chair or a table")[1] == 2


def test_the_words_are_read_without_torch_within_two_seconds():
    code = (
        "import sys, json\n"
        "from core.guidance.builtin.words.vocabulary import words_report\n"
        "print(json.dumps([words_report('an office chair'), sorted(sys.modules)]))"
    )
    before = os.times()
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    after = os.times()  # of the processor: others may be busy
    seconds = after.children_user + after.children_system
    seconds -= before.children_user + before.children_system
    (report, exit_code), modules = json.loads(done.stdout)
    assert (report["thing"], exit_code) == ("office chair", 0)
    assert not {"torch", "numpy", "safetensors", "core.prior"} & set(modules)
    assert seconds < 2


@pytest.mark.parametrize("path", sorted(WEIGHTS.glob("*.safetensors")), ids=lambda p: p.stem)
def test_every_shipped_network_has_a_row_for_every_noun(path):
    assert read_metadata(path)["config"]["words"][0] == len(ORDER)


def test_the_offered_words_are_those_of_the_weights():
    found = offered_words()
    assert set(found) == set(SLOTS)
    assert all(set(found[slot]) <= set(SLOTS[slot]) for slot in SLOTS)


def test_broken_weights_are_named(tmp_path, monkeypatch):
    monkeypatch.setattr(offered, "WEIGHTS", tmp_path)
    with pytest.raises(MissingError, match=r"geometry\.safetensors"):
        offered_words()
    for content in (b"short", b"\xff" * 16, (2).to_bytes(8, "little") + b"[}"):
        (tmp_path / "geometry.safetensors").write_bytes(content)
        with pytest.raises(MissingError, match="broken"):
            offered_words()
    (tmp_path / "x").write_bytes((10**6).to_bytes(8, "little"))
    with pytest.raises(ValueError, match="cut"):
        read_metadata(tmp_path / "x")


def test_the_groups_hold_every_offered_word_once():
    known = offered_words()
    groups = word_groups()
    by_kind: dict[str, list[str]] = {}
    for group in groups:
        by_kind.setdefault(group["kind"], []).extend(group["words"])
    assert sorted(by_kind["thing"]) == sorted(known["noun"])
    for slot in ("shape", "color", "material", "pattern", "part"):
        assert by_kind[slot] == list(known[slot])
    assert [parse(f"a {word} chair").style for word in by_kind["style"]] == ["low_poly", "voxels"]
    assert all(group["of"][part] for group in groups if "of" in group for part in group["words"])
    assert max(len(group["words"]) for group in groups) <= 63  # three columns of 21


def test_unknown_words_may_be_ignored_in_a_report():
    report, code = words_report("a red wombat chair, an astrolabe", ignore_unknown=True)
    assert (code, report["thing"], report["colours"]) == (0, "chair", ["red"])


def test_what_a_window_shows_of_a_refused_prompt_is_short_and_has_no_option():
    for prompt in ("a wombat", "red", "a chair or a table"):
        with pytest.raises(UserError) as caught:
            parse(prompt)
        assert 0 < len(caught.value.window_fix) < 80
        assert "--" not in caught.value.window_fix


def test_a_reading_is_the_same_in_every_process():
    prompts = ["battle axe double bladed", "a teapot with a blu lidd", "an axe with a bladed head"]
    code = "import sys; from core.guidance.builtin.words.vocabulary import words_report as f; "
    code += "print([f(prompt) for prompt in sys.argv[1:]])"
    told = {
        subprocess.run(
            [sys.executable, "-c", code, *prompts],
            env=os.environ | {"PYTHONHASHSEED": str(seed)},
            capture_output=True,
            check=True,
        ).stdout
        for seed in range(4)
    }
    assert len(told) == 1


def test_what_is_left_out_is_said_for_its_own_reason():
    notes = understood("a book with three brass gizmos", known=SLOTS)["notes"]
    assert notes == [
        "'brass': left out with the unknown words next to it.",
        "'three': left out, as parts are not counted.",
        "The built-in model does not know 'gizmos': left out.",
    ]


@pytest.mark.parametrize(
    ("prompt", "said"),
    [
        # What follows a part that the thing has not is still the thing's.
        ("an armchair with walnut legs and mustard fabric", {"colours": ["mustard"]}),
        ("an armchair with walnut legs and mustard fabric", {"materials": ["fabric"]}),
        ("a lighthouse, flat shading", {"shape": None}),
        ("a piano, polished black lacquer, lid open", {"colours": ["black"]}),
        ("a chair whit four legs", {"thing": "chair"}),
        ("a key, tarnished bronze", {"weather": ["worn"]}),
        ("a vase in smoked glass", {"materials": ["smoked glass"]}),
        ("a car, cherry red paint, white stripes", {"colours": ["cherry red", "white"]}),
        ("a car with white stripes and a red body", {"colours": ["red", "white"]}),
        ("a car with white stripes and red windows", {"colours": ["white"]}),
        ("a door, oak planks", {"part_materials": {"door": "oak", "panels": "oak"}}),
        ("a knights shield", {"thing": "shield"}),
        ("a pirates ship", {"thing": "pirate ship"}),
        ("perfume, thick clear glass", {"shape": None, "materials": ["clear glass"]}),
        ("a table made of thin steel", {"shape": None}),
        ("a thick wooden table", {"shape": "thick"}),
        ("a crossbow made from scrap metal and car springs", {"materials": ["metal"]}),
        ("a pumpkin with a candle glowing inside", {"sheen": None}),
        ("a pumpkin, glowing", {"sheen": ["glowing"]}),
        ("a lamp with a white linen drum shade", {"part_colours": {"shade": "white"}}),
        ("a bottle with a bamboo screw lid", {"part_materials": {"cap": "bamboo"}}),
        (
            "headphones, tan leather ear cushions, walnut ear cups",
            {"part_materials": {"cushions": "leather", "cups": "walnut"}},
        ),
        ("a samurai in black and red armor", {"colours": None}),
        ("a crate with blue planks", {"part_colours": {"planks": "blue"}}),
        ("a desk lamp with a red dome", {"part_colours": {"shade": "red"}}),
        ("a paper coffee cup with a brown sleeve", {"thing": "paper cup"}),
        ("a kitchen island with a white countertop", {"part_colours": {"top": "white"}}),
        ("a drone with four black propellers", {"part_colours": {"rotors": "black"}}),
    ],
)
def test_prompts_of_six_people_are_read_as_they_are_meant(prompt, said):
    told = understood(prompt, known=SLOTS)
    assert {name: told.get(name) or None for name in said} == said


def test_a_letter_of_the_alphabet_is_no_envelope():
    with pytest.raises(UnknownWordsError, match="letter b"):
        parse("the letter B of wood")
    assert parse("a sealed letter").noun == "envelope"


@pytest.mark.parametrize(
    ("prompt", "weather"),
    [
        ("an old wizard", ()),
        ("an ancient dragon", ()),
        ("an old chair", ("worn",)),
        ("an old doll", ("worn",)),
        ("an old stone lion", ("worn",)),
        ("an old statue of a king", ("worn",)),
    ],
)
def test_age_wears_out_what_is_not_alive(prompt, weather):
    words = parse(prompt)
    assert words.weather == weather
    assert ("old" in words.left_out or "ancient" in words.left_out) != bool(weather)


def test_a_slip_in_a_name_that_begins_like_an_adjective_is_read():
    assert parse("electric gutiar black").noun == "electric guitar"
    assert parse("electric guitar").notes == ()
    assert parse("a racing cart").noun != "race car"  # a cart is a word by itself
    things = ("cartoon box", "lying fox", "sturdy lamp", "smiling boat")
    assert [parse(thing).noun for thing in things] == ["cube", "fox", "lamp", "boat"]


def test_of_rust_and_metal_of_one_part_the_rust_is_taken():
    (roof,) = parse("a barn with a rusted corrugated metal roof").accents
    assert (roof.part, roof.material) == ("roof", "rusty")


def test_a_style_that_begins_like_a_shape_makes_nothing_flat():
    assert parse("low resolution cat").shape == parse("low quality cat").shape == ""
    assert (parse("low detail cat").shape, parse("low wall").shape) == ("", "flat")


def test_a_hand_plane_is_no_airplane():
    assert parse("a hand plane").noun == "wood plane"
