"""Paint: every part has a colour, words change the parts they are about, and light is kept."""

import colorsys

import pytest
import torch

from core.guidance.builtin.nouns import GROUPS, PART_NAMES
from core.guidance.builtin.nouns import NOUNS as KNOWN
from core.guidance.builtin.palette import (
    COLOR_VALUES,
    FINISHES,
    METAL_LEFT,
    SWATCHES,
    Painted,
    companion,
    darker,
    looks,
    painted,
    swatches,
)
from core.guidance.builtin.patterns import Place
from core.guidance.builtin.substances import (
    CLEAR,
    GLOW,
    OF_A_GROUP,
    OF_A_PART,
    OF_A_THING,
    OF_THE_REST,
    ROUGHNESS,
)
from core.guidance.builtin.surfaces import SMOOTH, surface_of
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.tables.colors import color_value
from core.guidance.builtin.words.tables.part_tables import FRAMES
from core.guidance.builtin.words.tables.words import COLORS, MATERIALS, PATTERNS
from core.guidance.builtin.words.vocabulary import parse
from core.ops import linear_to_srgb, srgb_to_linear
from core.prior.colored import Painter, lumpy
from core.prior.data import NOUNS, make
from core.prior.draw import Draw
from core.prior.natural_patterns import ALL_PATTERNS as PAINTED
from core.prior.paint import Caption, coat, paint
from core.texture.detail.kinds import KINDS


def _draw(seed: int = 0) -> Draw:
    return Draw(torch.Generator().manual_seed(seed))


def _index(noun: str, part: str) -> int:
    return list(looks(noun)).index(part)


def test_all_words_have_paint():
    assert list(COLOR_VALUES) == list(COLORS)
    assert list(FINISHES) == ["", *MATERIALS]
    assert list(PAINTED)[: len(PATTERNS)] == list(PATTERNS)


def test_every_noun_has_a_main_part_and_known_patterns():
    for noun in NOUNS:
        parts = looks(noun).values()
        assert any(look.role == "*" for look in parts), noun
        assert all(look.role in "*+&-" for look in parts), noun
        assert all(look.pattern in ("", *PAINTED) for look in parts), noun


def test_a_colour_word_paints_the_main_parts_only():
    blue = coat("snowman", Caption("blue"), _draw())
    body, nose = (blue.color[_index("snowman", part)] for part in ("body", "nose"))
    assert body.argmax() == 2
    assert body[2] > 3 * body[0]
    assert nose.argmax() == 0
    assert nose[0] > 2 * nose[2]


def test_a_red_mug_has_a_red_handle_until_a_second_colour_is_stated():
    red = coat("mug", Caption("red"), _draw()).color
    assert torch.equal(red[0], red[1])
    both = coat("mug", Caption("red", "", "two-tone", "blue"), _draw()).color
    assert torch.equal(both[0], red[0])
    assert both[1].argmax() == 2


def test_a_metal_is_a_metal_and_a_wood_has_grain():
    golden = coat("ball", Caption("", "golden"), _draw())
    assert golden.metallic.item() == 1
    assert golden.color[0, 0] > golden.color[0, 2] * 2
    wooden = coat("ball", Caption("red", "wooden"), _draw())
    assert list(PAINTED)[wooden.pattern[0]] == "grain"
    assert wooden.metallic.item() == 0
    assert wooden.color[0, 0] > 3 * wooden.color[0, 1]


def test_a_material_is_that_of_all_parts_but_those_that_keep_their_nature():
    golden = coat("car", Caption("", "golden"), _draw())
    metallic = dict(zip(looks("car"), golden.metallic[:, 0].tolist(), strict=True))
    own = ("windows", "wheels", "lamps", "trim", "tail lamps", "number plates")
    assert metallic == {"body": 1, "hubs": 1} | dict.fromkeys(own, 0)


@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_pattern_shows_both_colours_in_fair_fractions(pattern):
    points = torch.nn.functional.normalize(torch.randn(4000, 3, generator=_draw().generator), dim=1)
    stated = coat("ball", Caption("red", "", pattern, "blue"), _draw())
    kd, _, _ = paint(stated, torch.zeros(4000, dtype=torch.long), points * 0.8, points)
    red = (kd[:, 0] > kd[:, 2]).float().mean().item()
    assert 0.35 < red < 0.85
    assert len(kd.unique(dim=0)) == 2


def test_the_second_colour_of_a_pattern_alone_stands_out():
    for value in COLOR_VALUES.values():
        other = torch.tensor(companion(value))
        assert (other - torch.tensor(value)).abs().max() > 0.25


@pytest.mark.parametrize("name", PAINTED)
def test_a_pattern_is_the_same_for_every_order_of_points(name):
    points = _draw().generator
    point = torch.rand(50, 3, generator=points) * 2 - 1
    normal = torch.nn.functional.normalize(point, dim=1)
    color, second = torch.full((50, 3), 0.4), torch.full((50, 3), 0.9)
    whole = PAINTED[name](color, second, Place(point, normal))
    tail = PAINTED[name](color[20:], second[20:], Place(point[20:], normal[20:]))
    torch.testing.assert_close(whole[20:], tail)
    assert whole.isfinite().all()


def test_jitter_stays_within_the_word():
    """No draw is nearer to another colour word than to its own."""
    values = torch.tensor([COLOR_VALUES[name] for name in COLORS])
    for color in COLORS:
        for seed in range(20):
            drawn = coat("ball", Caption(color), _draw(seed)).color[0]
            assert list(COLORS)[int((values - drawn).norm(dim=1).argmin())] == color, color


def test_patterns_repaint_only_their_own_parts():
    mushroom = coat("mushroom", Caption(), _draw())
    up = torch.tensor([[0.0, 0.0, 1.0]]).expand(2, 3)
    part = torch.tensor([_index("mushroom", "cap"), _index("mushroom", "stem")])
    kd, roughness, metallic = paint(mushroom, part, torch.zeros(2, 3), up)
    assert kd[0].min() > 0.7  # a white spot on top of the cap
    torch.testing.assert_close(linear_to_srgb(kd[1]), mushroom.color[part[1]], atol=1e-5, rtol=0)
    assert roughness.shape == metallic.shape == (2, 1)


def test_a_painted_picture_has_the_colour_of_its_word_and_nothing_around():
    samples = make(11, 6)
    painter = Painter()
    index = torch.arange(len(samples))
    stated = torch.tensor([[1 + list(COLORS).index("green"), 0, 0, 0, 0]]).expand(len(samples), -1)
    x = painter.pictures(samples, index, stated, _draw())
    assert x.shape == (len(samples), 4, 64, 64)
    coverage = samples.coverage.float() / 255
    torch.testing.assert_close(x[:, 3:], 2 * coverage - 1)
    assert (x[:, :3].abs() * (coverage == 0)).max() == 0
    for row in range(0, len(samples), 4):
        noun = NOUNS[int(samples.noun[row])]
        main = torch.tensor([look.role in "*&" for look in looks(noun).values()])
        seen = (coverage[row, 0] == 1) & main[samples.part[row].long().clamp_min(0)]
        if seen.sum() > 20:
            hue, _, _ = colorsys.rgb_to_hsv(*(x[row, :3, seen].mean(1) * 0.5 + 0.5).tolist())
            assert 0.25 < hue < 0.45, noun


def test_captions_are_drawn_from_all_words_and_a_second_colour_needs_a_place():
    nouns = torch.arange(len(NOUNS)).repeat_interleave(300)
    words = Painter().words(nouns, _draw().generator)
    for slot, name in enumerate(("color", "material", "pattern", "second")):
        assert words[:, slot].unique().tolist() == list(range(len(SLOTS[name]) + 1))
    color, _, pattern, second, target = words.unbind(1)
    assert ((pattern > 0) ^ (target > 0))[second > 0].all()
    assert (second != color)[second > 0].all()
    assert (second > 0)[target > 0].all()


def test_a_captions_part_is_one_of_its_noun_and_each_part_is_drawn():
    for noun in ("teapot", "robot", "ball"):
        nouns = torch.full((2000,), NOUNS.index(noun))
        targets = Painter().words(nouns, _draw().generator)[:, 4].unique().tolist()
        parts = [1 + PART_NAMES.index(name) for name in KNOWN[noun].looks]
        assert targets == ([0] if len(parts) == 1 else sorted([0, *parts]))


def test_a_part_takes_the_second_colour_and_the_others_keep_theirs():
    parts = {
        p.name: p.color for p in painted("robot", Caption("blue", second="yellow", target="eyes"))
    }
    before = {p.name: p.color for p in painted("robot", Caption("blue"))}
    assert parts.pop("eyes") == COLOR_VALUES["yellow"] != before.pop("eyes")
    assert parts == before


def test_swatches_are_the_colours_that_are_stated():
    slots = ("noun", "color", "material", "pattern", "second")
    prompts = ("a blue golden mug", "a golden mug", "a mug", "a red and blue mug")
    words = torch.tensor([parse(prompt).indices(slots) for prompt in prompts])
    seen = swatches(words)
    assert seen.shape == (4, SWATCHES)
    blue, gold, none, two = seen
    color = lambda rgb: torch.tensor([2 * c - 1 for c in rgb] + [1.0])  # noqa: E731
    torch.testing.assert_close(blue[:4], color(COLOR_VALUES["blue"]))
    torch.testing.assert_close(gold[:4], color(FINISHES["golden"].color))
    torch.testing.assert_close(two[:4], color(COLOR_VALUES["red"]))
    torch.testing.assert_close(two[4:], color(COLOR_VALUES["blue"]))
    assert (none == 0).all()
    assert (blue[4:] == 0).all()


def test_where_only_a_pattern_is_stated_the_second_swatch_goes_with_the_first():
    slots = ("noun", "color", "material", "pattern", "second")
    prompts = ("a striped red mug", "a striped stone mug", "a striped mug", "a striped white ball")
    words = torch.tensor([parse(prompt).indices(slots) for prompt in prompts])
    red, stone, none, white = swatches(words)[:, 4:]
    color = lambda rgb: torch.tensor([2 * c - 1 for c in rgb] + [1.0])  # noqa: E731
    torch.testing.assert_close(red, color(companion(COLOR_VALUES["red"])))
    torch.testing.assert_close(stone, color(companion(FINISHES["stone"].color)))
    torch.testing.assert_close(white, color(companion(COLOR_VALUES["white"])))
    assert (none == 0).all()


def test_dents_are_soft_and_leave_the_weight_of_the_normals():
    weight = torch.rand(64, 1, 32, 32, generator=torch.Generator().manual_seed(0))
    flat = torch.tensor([0.0, 0.6, 0.8])[:, None, None] * weight
    dented = lumpy(flat, torch.Generator().manual_seed(1))
    torch.testing.assert_close(dented.norm(dim=1, keepdim=True), weight, atol=1e-5, rtol=1e-4)
    cos = (dented * flat).sum(1) / weight[:, 0].square()
    touched = (cos < 1 - 1e-4).flatten(1).any(1)
    assert 0.3 < touched.float().mean() < 0.7  # half of the pictures
    assert cos[touched].mean() > 0.9
    unit = dented / weight
    step = (unit[..., 1:] - unit[..., :-1]).norm(dim=1)
    assert step[touched].mean() < 0.1  # of neighbouring pixels


def test_each_substance_is_of_something_that_there_is_and_has_its_detail():
    pairs = {f"{noun} {part}" for noun, row in KNOWN.items() for part in row.looks}
    parts = {part for row in KNOWN.values() for part in row.looks}
    tables = ((OF_A_THING, pairs), (OF_A_PART, parts), (OF_THE_REST, set(KNOWN)))
    for table, known in (*tables, (CLEAR, pairs), (GLOW, pairs)):
        names = [name for text in table.values() for name in text.split(", ")]
        assert len(names) == len(set(names)) and not set(names) - known
    assert not set(OF_A_GROUP) - set(GROUPS)
    kinds = {k for table, _ in tables for k in table} | set(OF_A_GROUP.values()) | set(ROUGHNESS)
    assert not kinds - set(KINDS)


def test_what_a_row_leaves_open_is_told_by_the_part_the_thing_or_its_group():
    def kind(noun, part):
        return looks(noun)[part].material

    assert kind("sword", "blade") == "metal"  # the row's own finish
    assert kind("bench", "seat") == "wooden"  # by its pattern
    assert kind("mouse", "ears") == "skin"  # a part of this thing
    assert kind("corgi", "eyes") == "eye"  # a part of any
    assert kind("frog", "body") == "wet skin"  # the thing
    assert kind("corgi", "body") == "fur"  # its group
    assert kind("cube", "body") == ""
    rough = {part: look.finish.roughness for part, look in looks("corgi").items()}
    assert rough["eyes"] < 0.1 < 0.8 < rough["body"]
    bare = [(n, p) for n in KNOWN for p, look in looks(n).items() if not look.material]
    assert len(bare) < 20


def test_a_natural_metals_colour_is_lighter_than_it_is_seen():
    text = KNOWN["sword"].looks["blade"]
    blade = looks("sword")["blade"]
    assert blade.finish.metallic == 1
    for at, made in zip((1, 3, 5), blade.color, strict=True):
        seen = int(text[at : at + 2], 16) / 255
        assert 1 - made == pytest.approx(METAL_LEFT * (1 - seen))


def test_what_a_part_has_of_its_own_is_painted_on_it_and_on_nothing_else():
    words = parse("a rusty sword with a red velvet grip and a blue guard")
    whole = {part.name: part for part in painted("sword", parse("a rusty sword"))}
    parts = {part.name: part for part in painted("sword", words)}
    grip, guard = parts["grip"], parts["guard"]
    assert grip.finish == FINISHES["fabric"] and grip.color == COLOR_VALUES["red"]
    assert (grip.material, grip.material_form, grip.colored) == ("fabric", "velvet", True)
    assert guard.color == COLOR_VALUES["blue"] and guard.material == "rusty"
    assert parts["blade"]._replace(second=()) == whole["blade"]._replace(second=())
    kinds = {part.name: surface_of(words, part).kind for part in parts.values()}
    own = {"fuller": "rusted paint", "wraps": "rusty"}
    own |= {"blade": "rusty", "guard": "rusted paint", "grip": "velvet", "pommel": "rusty"}
    assert kinds == own
    # A part that no material of the whole is about takes its own.
    car = {part.name: part for part in painted("car", parse("a golden car with wooden wheels"))}
    assert car["wheels"].finish == FINISHES["wooden"] and not car["wheels"].colored
    assert car["windows"].finish == FINISHES["glass"]


def test_a_pattern_leaves_a_part_that_has_its_own_colour():
    words = parse("a red and white striped mug with a blue handle")
    mug = {part.name: part for part in painted("mug", words)}
    assert (mug["body"].pattern, mug["handle"].pattern) == ("striped", "")
    assert mug["handle"].color == COLOR_VALUES["blue"]


def test_the_metal_fittings_of_what_is_no_metal_stay_of_metal():
    def finishes(prompt):
        words = parse(prompt)
        return {part.name: part.finish for part in painted(words.noun, words)}

    chest = finishes("a wooden treasure chest")
    assert chest["bands"].metallic == 1 and chest["bands"] == looks("chest")["bands"].finish
    assert finishes("a rusty treasure chest")["bands"] == FINISHES["rusty"]
    assert finishes("a wooden sword")["guard"] == FINISHES["wooden"]
    assert finishes("a chest with wooden bands")["bands"] == FINISHES["wooden"]


def test_a_material_that_a_thing_is_of_by_nature_says_nothing_of_what_else_it_has():
    for prompt, part, own in (
        ("a glass bottle", "cap", "plastic"),
        ("a metal cannon", "carriage", "wooden"),
        ("a wooden pirate ship", "sails", "fabric"),
    ):
        words = parse(prompt)
        of = {part.name: part.material or part.look.material for part in painted(words.noun, words)}
        assert of[part] == own and words.material in of.values()


def test_of_a_coloured_metal_the_metal_parts_are_too():
    def of(prompt: str) -> dict[str, str]:
        words = parse(prompt)
        return {part.name: part.material for part in painted(words.noun, words)}

    assert of("a brass floor lamp")["pole"] == "golden"
    assert of("a rusty train")["wheels"] == "rusty"
    assert of("a metal train")["wheels"] == ""  # stay of the one that they are
    assert of("a wooden car")["wheels"] == ""
    assert of("a golden backpack")["buckles"] == "golden"
    assert of("a golden safe with a metal dial")["dial"] == "metal"


def test_a_golden_medal_has_a_ribbon_of_cloth():
    medal = {part.name: part.finish for part in painted("medal", parse("a golden medal"))}
    assert medal["ribbon"].metallic == 0 and 1 in {finish.metallic for finish in medal.values()}


def test_a_part_is_coloured_by_a_word_that_is_about_it():
    lamp = {part.name: part for part in painted("lamp", parse("a blue brass lamp"))}
    assert lamp["shade"].colored and not lamp["foot"].colored
    assert surface_of(parse("a blue brass lamp"), lamp["foot"]).factor != (1.0, 1.0, 1.0)


def lights(prompt: str) -> dict[str, tuple[float, float]]:
    """How much each part glows and is clear."""
    words = parse(prompt)
    found = {part.name: surface_of(words, part) for part in painted(words.noun, words)}
    return {name: (surface.glow, surface.clear) for name, surface in found.items()}


def test_what_is_said_to_be_of_glass_is_clear_and_what_is_glossy_is_not():
    assert lights("a glass vase")["body"][1] > 0.9
    assert lights("a crystalline vase")["body"][1] > 0.9
    assert lights("a glossy vase")["body"] == lights("a vase")["body"] == (0, 0)
    table = lights("a coffee table with a glass top")
    assert table.pop("seams") == table["top"]  # they lie on it, and are of wood alone
    assert table.pop("top")[1] > 0.9 and set(table.values()) == {(0, 0)}
    # Its name says it; a stated material says more.
    assert lights("a drinking glass")["cup"][1] > 0.9
    assert lights("a wooden drinking glass")["cup"] == lights("a goblet")["cup"] == (0, 0)


def test_by_nature_one_looks_through_a_flask_and_not_through_a_cars_windows():
    assert lights("a flask")["glass"][1] > 0.9
    for prompt, part in (("a car", "windows"), ("a laptop", "screen"), ("a camera", "lens")):
        assert lights(prompt)[part] == (0, 0)
    assert lights("a metal bottle")["body"] == (0, 0)  # the word says what it is of


def test_flames_and_lamps_glow_whatever_the_rest_is_of():
    assert lights("a golden candle")["flame"] == lights("a candle")["flame"] == (1, 0)
    assert lights("a wooden lantern")["glass"][0] > 0
    assert lights("a glass light bulb")["bulb"][0] > 0
    assert lights("a stone light bulb")["bulb"] == (0, 0)
    assert lights("a candle")["wax"] == (0, 0)


def test_a_wall_of_clear_glass_is_smoother_than_what_mirrors():
    words = parse("a bottle")
    body, cap = [surface_of(words, part) for part in painted("bottle", words)][:2]
    assert (body.roughness, cap.roughness) == (-SMOOTH, 0.0)


def test_no_snow_lies_on_a_flame_nor_dust_on_an_eye():
    for prompt, part in (("a snow covered candle", "flame"), ("a dusty dinosaur", "eyes")):
        words = parse(prompt)
        weather = {one.name: surface_of(words, one).weather for one in painted(words.noun, words)}
        assert weather.pop(part) == ()
        assert set(weather.values()) == {words.weather} and words.weather


def test_clear_glass_without_a_colour_is_white_and_a_stated_colour_tints_it():
    def color(prompt):
        words = parse(prompt)
        (part,) = painted(words.noun, words)
        factor = surface_of(words, part).factor
        return srgb_to_linear(torch.tensor(part.color)) * torch.tensor(factor)

    assert color("a glass vase").min() > 0.85
    torch.testing.assert_close(
        color("a red glass vase"), srgb_to_linear(torch.tensor(COLOR_VALUES["red"]))
    )


@pytest.mark.parametrize(
    ("prompt", "part", "stripes"),
    [
        ("a longship with a red and white striped sail", ("sail", "red"), "white"),
        ("a longship with a striped blue sail", ("sail", "blue"), ""),
        ("a market stall with a green and yellow striped awning", ("awning", "green"), "yellow"),
        ("a striped blue and orange scarf", ("wool", "blue"), "orange"),
        ("a striped tiger", ("body", ""), ""),
    ],
)
def test_what_is_striped_by_nature_has_no_other_stripes(prompt, part, stripes):
    """They were laid over its own: a sail was tartan."""
    words = parse(prompt)
    found = {one.name: one for one in painted(words.noun, words)}
    assert not any(one.pattern == "striped" for one in found.values())
    for name, color in (part, ("stripes", stripes)):
        wanted = COLOR_VALUES[color] if color else looks(words.noun)[name].color
        assert found[name].color == pytest.approx(wanted), name


def test_other_stripes_than_its_own_are_drawn():
    for prompt, part in (
        ("a longship with a striped red hull", "hull"),
        ("a striped red and white longship", "hull"),
        ("a striped red and white boat", "hull"),
    ):
        words = parse(prompt)
        found = {one.name: one for one in painted(words.noun, words)}
        assert found[part].pattern == "striped", prompt


@pytest.mark.parametrize(
    ("noun", "part", "pattern", "second"),
    [
        ("lighthouse", "tower", "hoops", (0.76, 0.14, 0.12)),
        ("mushroom", "cap", "dots", (0.95, 0.93, 0.88)),
    ],
)
def test_a_pattern_by_nature_has_a_second_colour_until_a_colour_is_stated(
    noun, part, pattern, second
):
    parts = {one.name: one for one in painted(noun, Caption())}
    own = parts[part]
    assert own.pattern == pattern
    assert own.second == second
    red = next(one for one in painted(noun, Caption("blue")) if one.name == part)
    assert red.pattern == "" and red.color == color_value("blue")
    spotted = next(
        one for one in painted(noun, Caption("blue", pattern="checkered")) if one.name == part
    )
    assert spotted.pattern == "checkered"


@pytest.mark.parametrize(
    ("noun", "part", "pattern", "second"),
    [
        ("pineapple", "body", "scales", 0.6),  # of its own colour, but darker
        ("turtle", "shell", "plates", 0.5),
        ("basketball", "ball", "seams", (0.13, 0.10, 0.09)),
    ],
)
@pytest.mark.parametrize("stated", [{}, {"color": "blue"}, {"material": "golden"}])
def test_lines_that_are_of_a_things_form_stay(noun, part, pattern, second, stated):
    own = _part(noun, part, **stated)
    assert own.pattern == pattern
    dark = second if isinstance(second, tuple) else tuple(second * x for x in own.color)
    assert own.second == pytest.approx(dark)
    # Of a finish with a pattern of its own, too; not under a pattern that is stated.
    assert _part(noun, part, material="wooden").pattern == pattern
    assert _part(noun, part, pattern="spotted").pattern == "spotted"
    assert _part(noun, part, color="red", color_form="rainbow").pattern == "rainbow"


def test_two_colours_of_a_basketball_are_its_own_and_its_seams():
    own = _part("basketball", "ball", color="black", pattern="two-tone", second="white")
    assert (own.pattern, own.second) == ("seams", color_value("white"))
    # Black lines on black are none.
    assert min(_part("basketball", "ball", color="black").second) > 0.8


def _part(noun: str, part: str, **stated: str) -> Painted:
    return next(one for one in painted(noun, Caption(**stated)) if one.name == part)


@pytest.mark.parametrize(
    ("noun", "part", "kind"),
    [
        ("mug", "handle", "ceramic"),
        ("microphone", "handle", "plastic"),
        ("penguin", "feet", "hide"),
        ("rocket", "nose", "paint"),
        ("tiger", "stripes", "fur"),
        ("pawn", "collar", "wooden"),
        ("gift", "box", "paper"),
        ("knife", "handle", "wooden"),
    ],
)
def test_what_a_part_is_of_goes_by_the_thing_before_the_parts_name(noun, part, kind):
    """Handles are mostly of wood, and a nose is mostly wet."""
    assert looks(noun)[part].material == kind


def test_spots_lie_on_what_has_a_colour_of_its_own_where_that_is_all() -> None:
    cap = next(
        part
        for part in painted("mushroom", parse("a mushroom with a red cap and white spots"))
        if part.name == "cap"
    )
    assert (cap.pattern, cap.color) == ("spotted", color_value("red", "red"))
    assert cap.second == color_value("white", "white")
    body, handle = (
        next(p for p in painted("mug", parse("a mug with a red handle and stripes")) if p.name == n)
        for n in ("body", "handle")
    )
    assert (body.pattern, handle.pattern) == ("striped", "")


def test_white_wood_shows_little_of_its_grain() -> None:
    def depth(prompt: str) -> float:
        words = parse(prompt)
        parts = [part for part in painted(words.noun, words) if part.look.material != "fabric"]
        parts = [part for part in parts if part.name != "seams"]  # dark lines on white
        return max(surface_of(words, part).depth for part in parts)

    assert depth("a white wooden chair") < 0.4
    assert depth("a red wooden chair") == depth("a birch chair") == 1
    (frame,) = (part for part in painted("window", parse("a window")) if part.name == "frame")
    assert surface_of(parse("a window"), frame).depth < 0.4  # white by nature


def test_a_bed_is_its_frame_and_its_sheets_are_cloth() -> None:
    plain = {part.name: part for part in painted("bed", parse("a wooden bed"))}
    assert (plain["frame"].material, plain["blanket"].material) == ("wooden", "")
    white = {part.name: part for part in painted("bed", parse("a white bed with blue sheets"))}
    assert white["frame"].color == color_value("white", "white")
    assert white["blanket"].color == color_value("blue", "blue")


def test_what_a_covered_thing_is_painted_is_what_lies_below() -> None:
    cake = {part.name: part for part in painted("cake", parse("a white cake with pink icing"))}
    assert cake["body"].color == color_value("white", "white")
    bare = {part.name: part for part in painted("cake", parse("a white cake"))}
    assert bare["icing"].color == color_value("white", "white")
    assert bare["body"].color == bare["body"].look.color


def test_somebody_of_wood_is_carved_and_his_staff_alone_is_not() -> None:
    assert parse("a wooden king").is_statue
    assert not parse("a wizard with a wooden staff").is_statue


def test_what_is_of_cloth_on_a_wooden_thing_stays_so_and_an_animal_is_carved() -> None:
    boat = {part.name: part for part in painted("boat", parse("a wooden boat"))}
    assert (boat["hull"].material, boat["sails"].material) == ("wooden", "")
    owl = {part.name: part for part in painted("owl", parse("a wooden owl"))}
    assert owl["belly"].material == "wooden"


@pytest.mark.parametrize(
    ("prompt", "hard"),
    [
        ("a wooden lamp", {"pole", "foot"}),
        ("a brass floor lamp", {"pole", "foot"}),
        ("a wooden market stall", {"counter", "posts", "shelf"}),
        ("a stone throne", {"frame", "knobs", "step"}),
        ("a wooden armchair", {"arms", "legs"}),
        ("a metal tent", {"poles"}),
    ],
)
def test_a_hard_material_is_that_of_the_frame_alone(prompt, hard):
    words = parse(prompt)
    of = {part.name for part in painted(words.noun, words) if part.material == words.material}
    assert of == hard


def test_a_soft_material_is_that_of_the_cloth():
    words = parse("a velvet armchair")
    of = {part.name for part in painted(words.noun, words) if part.material == "fabric"}
    assert {"cushion", "back", "arms"} <= of and "legs" not in of


def test_frames_are_of_parts_that_there_are():
    for noun, parts in FRAMES.items():
        assert parts < looks(noun).keys()


def test_what_is_of_glass_stays_of_glass():
    words = parse("a golden staff")
    of = {part.name: part.material for part in painted(words.noun, words)}
    assert of == {"shaft": "golden", "crystal": "", "fork": "golden"}


def test_a_marking_in_a_shade_goes_with_what_it_lies_on():
    def house(prompt):
        return {part.name: part for part in painted("house", parse(prompt))}

    plain, red = house("a house"), house("a house with a red door")
    assert red["panels"].color == darker(red["door"].color) != plain["panels"].color
    assert red["seams"].color == plain["seams"].color, "those are the roof's"
    yellow = house("a house with a red door and yellow panels")["panels"]
    assert yellow.color == house("a house with a yellow roof")["roof"].color
    striped = house("a house with a striped door")
    assert (striped["door"].pattern, striped["panels"].pattern) == ("striped", "")


def test_a_creature_of_lava_or_snow_keeps_its_eyes():
    for prompt, kept in (
        ("a lava golem", True),
        ("a dragon made of snow", True),
        ("a dragon made of ice", False),
        ("a gummy bear", False),
    ):
        words = parse(prompt)
        of = {part.name: part.material for part in painted(words.noun, words)}
        assert (of["eyes"] == "") is kept, prompt
        assert of["body"]
    words = parse("a red lava golem")
    eyes = next(part for part in painted("golem", words) if part.name == "eyes")
    assert eyes.color == eyes.look.color  # the red is the lava's
    words = parse("a lava golem with green eyes")
    eyes = next(part for part in painted("golem", words) if part.name == "eyes")
    assert eyes.color != eyes.look.color
