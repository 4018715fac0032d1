"""Markings in rows: what is built of boards, woven, strung, sown or printed."""

import math
from functools import partial

import numpy as np
import pytest
import torch
from scipy import ndimage

from core.guidance.builtin.markings.forms import lattices, lines, pictures, planks, rings, spots
from core.guidance.builtin.markings.markings import unfit_markings
from core.guidance.builtin.markings.rows.food_and_plants import YEARS
from core.guidance.builtin.markings.rows.props_and_arms import SCRIPT
from core.guidance.builtin.palette import darker, looks, painted
from core.guidance.builtin.patterns import MARGINS
from core.guidance.builtin.surfaces import surface_of
from core.guidance.builtin.variants import VARIANTS
from core.guidance.builtin.words.vocabulary import parse
from core.ops import srgb_to_linear
from core.tests.drawn_things import shipped_prior

HALF = torch.tensor([0.5, 0.3, 0.8])
CELLS = 400


def front(marks, half=HALF, side=-1.0, cells=CELLS):
    """Where the front of a box is marked, by rows."""
    x, z = (torch.linspace(-1, 1, cells) * 0.999 * reach for reach in (half[0], half[2]))
    points = torch.cartesian_prod(z, x)
    points = torch.stack([points[:, 1], side * half[1].expand(len(points)), points[:, 0]], 1)
    return (marks(points, half) > 0).view(cells, cells).numpy()


def top(marks, half=HALF):
    """The same of its top."""
    y, x = (torch.linspace(-1, 1, CELLS) * 0.999 * reach for reach in (half[1], half[0]))
    points = torch.cartesian_prod(y, x)
    points = torch.stack([points[:, 1], points[:, 0], half[2].expand(len(points))], 1)
    return (marks(points, half) > 0).view(CELLS, CELLS).numpy()


def around(marks, up, radius=0.5):
    """The same along a circle about the vertical."""
    turn = torch.linspace(0.01, math.tau + 0.01, 5000)
    points = radius * torch.stack([turn.sin(), -turn.cos(), 0 * turn], 1)
    points[:, 2] = up
    return (marks(points, torch.tensor([0.5, 0.5, 0.8])) > 0).numpy()


def pieces(marked):
    return ndimage.label(marked)[1]


def runs(marked):
    """How many there are along a closed line."""
    return int((marked & ~np.roll(marked, 1)).sum())


@pytest.mark.parametrize(("count", "axis"), [(4, 2), (7, 2), (6, 0)])
def test_between_planks_are_seams_of_one_width(count, axis):
    seams = front(partial(planks.planks, count=count, axis=axis))
    assert pieces(seams) == count - 1
    first = np.flatnonzero(seams.any(1 if axis == 2 else 0))
    places = first[np.flatnonzero(np.diff(first, prepend=-9) > 1)] / CELLS
    assert np.allclose(np.diff(places), 1 / count, atol=0.01)
    assert np.isclose(places[0], 1 / count, atol=0.02)


def test_a_barrel_has_staves_around_and_boards_across_its_lid():
    assert runs(around(planks.staves, 0.1)) == 14
    half = torch.tensor([0.5, 0.5, 0.8])
    lid = top(planks.staves, half)[CELLS // 2 - 60 : CELLS // 2 + 60, CELLS // 4 : -CELLS // 4]
    assert (lid == lid[0]).all()  # straight
    assert pieces(lid[0]) == 4  # of six those that are so near to the middle


def test_frets_are_on_the_front_below_the_head():
    marks = front(planks.frets)
    rows = marks.any(1)
    assert not front(planks.frets, side=1.0).any()
    assert not rows[int(0.82 * CELLS) :].any()
    assert pieces(marks) == 10


@pytest.mark.parametrize("aside", [False, True])
def test_boards_stand_upright_on_all_four_walls(aside):
    order = [1, 0, 2] if aside else [0, 1, 2]

    def turned(points, half):
        return planks.boarding(points[:, order], half[order])

    half = HALF[order] * 0.97
    seams = front(turned, half)
    assert pieces(seams[CELLS // 2]) == round(2 * float(half[0]) / 0.1)
    assert (seams == seams[0]).all()


def test_a_weave_goes_over_and_under():
    strands = [around(lattices.weave, up) for up in (0.05, 0.25)]
    assert [runs(one) for one in strands] == [12, 12]
    assert (strands[0] != strands[1]).mean() > 0.98


def test_between_strings_are_squares():
    holes = front(lattices.net_gaps)
    assert pieces(holes[40:-40, 40:-40]) > 100
    assert holes.mean() == pytest.approx(0.7**2, abs=0.03)


def test_a_mesh_is_as_fine_on_all_sides_of_its_ball():
    shares = []
    for axis in range(3):
        way = torch.nn.functional.normalize(torch.rand(20000, 3) - 0.5, dim=1)
        near = way[way[:, axis].abs() > 0.8]
        shares.append((lattices.mesh_gaps(near, torch.ones(3)) > 0).float().mean())
    assert max(shares) - min(shares) < 0.03
    assert shares[0] == pytest.approx(0.6**2, abs=0.04)


def test_a_speaker_has_seven_slots_within_its_round():
    slots = front(lattices.slots, torch.tensor([0.4, 0.1, 0.4]))
    assert pieces(slots) == 7
    assert not front(lattices.slots, torch.tensor([0.4, 0.1, 0.4]), side=1.0).any()
    wide = [row.sum() for row in slots if row.any()]
    assert max(wide) == wide[len(wide) // 2] > 1.5 * wide[0]


@pytest.mark.parametrize(("up", "count"), [(2, 36), (1, 60)])
def test_seeds_are_as_many_as_they_say_and_apart(up, count):
    half = torch.tensor([0.5, 0.5, 0.5])
    seen = (top if up == 2 else front)(partial(spots.seeds, count=count, up=up, size=0.035), half)
    assert pieces(seen) == count
    if up == 2:  # none on the lower bun
        low = partial(spots.seeds, count=count, up=up)
        points = torch.rand(5000, 3) - 0.5
        points[:, 2] = -0.4
        assert (low(points, half) < 0).all()


def test_a_phone_has_rows_of_four_icons_and_four_below():
    icons = front(pictures.icons, torch.tensor([0.4, 0.05, 0.8]))
    assert pieces(icons) == 4 * (5 + 1)
    gaps = np.diff(np.flatnonzero(icons.any(1)))
    assert gaps.max() > 3 * np.median(gaps[gaps > 1])  # the lowest row is apart


def test_a_scroll_is_written_on_from_above():
    script = front(partial(lines.ruled, lines=SCRIPT, ends=(-0.52, 0.5)))
    assert pieces(script) == len(SCRIPT) == 7
    wide = [int(row.sum()) for row in script if row.any()]
    assert max(wide) > 1.15 * min(wide)


def test_a_stump_has_rings_about_its_middle():
    grown = top(partial(rings.rings, spans=YEARS, axis=2), torch.tensor([0.5, 0.5, 0.2]))
    assert pieces(grown) == len(YEARS)
    assert pieces(grown[CELLS // 2]) == 2 * len(YEARS)
    assert np.array_equal(grown[CELLS // 2], grown[:, CELLS // 2])


@pytest.mark.parametrize(
    ("prompt", "there"),
    [
        ("a chest", True),
        ("an oak chest", True),
        ("a blue chest", True),
        ("an iron chest", False),
        ("a stone barn", False),
        ("a barn", True),
        ("a metal rowboat", False),
        ("a rusty barrel", False),
        ("a rusty barn", False),
    ],
)
def test_seams_are_of_wood(prompt, there):
    noun = parse(prompt).noun
    materials = {part.name: part.material for part in painted(noun, parse(prompt))}
    assert unfit_markings(noun, materials) == (set() if there else {"seams"})


@pytest.mark.parametrize(
    ("noun", "part", "on"),
    [("barrel", "seams", "body"), ("basket", "weave", "body"), ("mummy", "folds", "bandages")],
)
def test_seams_are_a_shade_of_what_they_are_in(noun, part, on):
    for prompt in (f"a {noun}", f"a blue {noun}"):
        colors = {one.name: one.color for one in painted(noun, parse(prompt))}
        assert sum(colors[part]) < 0.95 * sum(colors[on])
        assert max(range(3), key=lambda k: colors[part][k]) == max(
            range(3), key=lambda k: colors[on][k]
        )


@pytest.mark.parametrize(("prompt", "wood"), [("an oak chest", "oak"), ("an ebony chest", "ebony")])
def test_seams_are_a_shade_of_a_narrower_wood_too(prompt, wood):
    words = parse(prompt)
    body, seams = (
        surface_of(words, one) for one in painted("chest", words) if one.name in ("body", "seams")
    )
    wanted = torch.tensor([VARIANTS[wood].color, darker(VARIANTS[wood].color)])
    for surface, color in zip((body, seams), srgb_to_linear(wanted), strict=True):
        is_of = srgb_to_linear(torch.tensor(surface.color)) * torch.tensor(surface.factor)
        torch.testing.assert_close(is_of, color, atol=1e-4, rtol=0)


@pytest.mark.parametrize(
    ("prompt", "there"),
    [pytest.param("a barrel", True, marks=pytest.mark.slow), ("a rusty barrel", False)],
)
def test_what_is_drawn_has_seams_where_it_is_of_wood(prompt, there):
    fields = shipped_prior().prompted(prompt, "").of_object(0).area_fields()
    assert fields
    ring = torch.linspace(0, math.tau, 2000)
    points = torch.stack([0.5 * ring.sin(), -0.5 * ring.cos(), torch.zeros(2000)], 1)
    seams = fields.drawn(points)[1].argmax(1) == list(looks("barrel")).index("seams")
    assert bool(seams.any()) is there


def test_a_pineapple_has_eight_lines_each_way():
    turn = torch.linspace(0.01, math.tau + 0.01, 5000)
    points = 0.5 * torch.stack(
        [turn.sin(), -turn.cos(), 0 * turn + 0.185], 1
    )  # half way between two crossings
    assert runs((MARGINS["scales"](points) > 0).numpy()) == 16
