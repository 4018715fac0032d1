"""Usual sizes and densities: every noun has them, and what is made has the size and the mass."""

import pytest

from core.command_line import job_of, parse
from core.errors import UserError
from core.guidance.builtin.nouns import GROUPS, NOUNS
from core.guidance.builtin.physical import usual_of
from core.guidance.builtin.words.tables.sizes import DENSITIES, UNKNOWN
from core.guidance.builtin.words.tables.words import MATERIALS
from core.prior.masses import PAGE, cell, usual_mass


def test_every_noun_has_one_group_and_every_material_its_density():
    nouns = [noun for group in GROUPS.values() for noun in group]
    assert sorted(nouns) == sorted(NOUNS)
    usuals = [noun.usual for noun in NOUNS.values()]
    assert set(DENSITIES) == set(MATERIALS)
    assert all(0 < u.filled <= 1 and 0.02 <= u.size_m <= 300 for u in usuals)
    assert all(100 < density < 20000 for density in DENSITIES.values())


@pytest.mark.parametrize(
    ("prompt", "size_m"),
    [
        ("a blue ceramic mug", 0.1),
        ("a red wooden chair", 0.9),
        ("a rusty sports car", 4.5),
        ("a tall stone house without a chimney", 8.0),
        ("a grey rock", 1.2),
        ("two nouns: a chair or a car", UNKNOWN.size_m),
        ("a steampunk astrolabe", UNKNOWN.size_m),
    ],
)
def test_a_prompt_has_the_usual_size_of_its_thing(prompt, size_m):
    assert usual_of(prompt)[0] == size_m


# What a person expects of an ordinary specimen, kg.
@pytest.mark.parametrize(
    ("noun", "low", "high"),
    [
        ("car", 900, 2000),
        ("bus", 8000, 16000),
        ("apple", 0.1, 0.3),
        ("chair", 4, 12),
        ("table", 20, 60),
        ("mug", 0.2, 0.6),
        ("sword", 0.9, 2.5),
        ("chest", 10, 40),
        ("crown", 0.5, 2),
        ("bowling pin", 1.2, 1.8),
        ("ball", 0.3, 0.6),
        ("anvil", 50, 120),
        ("sofa", 40, 100),
        ("house", 50e3, 200e3),
        ("person", 50, 110),
        ("pencil", 0.003, 0.012),
        ("submarine", 100e3, 400e3),
    ],
)
def test_the_mass_is_that_of_an_ordinary_specimen(noun, low, high):
    assert low < usual_mass(noun) < high


def test_chess_pieces_are_of_one_set():
    pieces = ("chess king", "chess knight", "chess rook", "pawn")
    sizes = [NOUNS[name].usual.size_m for name in pieces]
    assert sizes == sorted(set(sizes), reverse=True)
    assert sizes[-1] == pytest.approx(sizes[0] / 2, rel=0.1)  # as Staunton's


def test_the_page_of_sizes_has_every_thing_as_it_is_now():
    text = PAGE.read_text(encoding="utf-8")
    for noun, row in NOUNS.items():
        assert f"| {noun} | {row.usual.size_m:g} m | " in text
    for noun in list(NOUNS)[::20]:  # their masses; all take a minute
        assert f"| {cell(noun)} |" in text


def test_the_material_of_the_prompt_decides_the_density_and_the_thing_how_hollow_it_is():
    _, gold = usual_of("a golden mug")
    _, clay = usual_of("a ceramic mug")
    assert gold / clay == pytest.approx(DENSITIES["golden"] / DENSITIES["ceramic"])


def test_a_size_of_the_users_is_in_the_job():
    assert job_of(parse(["generate", "a mug", "--size", "0.3"])).size_m == 0.3
    assert job_of(parse(["generate", "a mug"])).size_m == 0
    for wrong in ("0", "-1", "nan", "1e9"):
        with pytest.raises(UserError, match="size is"):
            job_of(parse(["generate", "a mug", f"--size={wrong}"]))
