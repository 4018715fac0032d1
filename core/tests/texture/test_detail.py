"""Materials that look like their word: where the detail is, what it keeps, and that it shows."""

import inspect
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import product
from unittest import mock

import numpy as np
import pytest
import torch
from torch import Tensor

from core.appearance.material import Material
from core.appearance.shade import perturb
from core.appearance.shaded import UvMesh
from core.config import DRAFT
from core.errors import UserError
from core.geometry.mesh import Mesh
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.palette import FINISHES
from core.guidance.builtin.surfaces import surfaces_of
from core.guidance.builtin.variants import VARIANTS
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.words import MATERIALS
from core.guidance.builtin.words.vocabulary import parse
from core.guidance.guidance import PromptedGuidance, Surface
from core.guidance.stable_diffusion.guidance import PromptedStableDiffusion
from core.ops import lab, srgb_to_linear
from core.settings import with_settings
from core.tests.texture_shapes import area, one_material, torus, torus_uv
from core.tests.tiny_runs import remembered
from core.texture import finish
from core.texture.bake import bake
from core.texture.detail import grain
from core.texture.detail.detail import DEEP, THIN, Coat, Detail, Spots
from core.texture.detail.grain import lengths
from core.texture.detail.kinds import KINDS
from core.texture.detail.noise import Noise
from core.texture.detail.parts import ByArea, ByColor
from core.texture.detail.place import Layer, Place
from core.texture.finish import Finish, detail_of

SIZE = 256
BROWN = (0.30, 0.14, 0.06)  # linear
NOISE = Noise(seed=3, footprint=1 / 450)


@pytest.fixture(scope="module", autouse=True)
def grain_once() -> Iterator[None]:
    """The torus' grain, which is a third of each test's time, is found once."""
    with mock.patch.object(finish, "lengths", remembered(finish.lengths)):
        yield


def place_at(point: np.ndarray, noise: Noise = NOISE) -> Place:
    """Points of a surface that faces up, of a part along x."""
    n = len(point)
    up = np.tile(np.array([0, 0, 1], np.float32), (n, 1))
    return Place(point.astype(np.float32), up, np.zeros(n, np.int64), noise)


def line(axis: int, count: int = 4000, start: tuple[float, float, float] = (0.1, 0.2, 0.3)):
    """Points along an axis, half a texel apart."""
    points = np.tile(np.array(start), (count, 1))
    points[:, axis] += np.arange(count) * NOISE.footprint / 2
    return points


@cache
def ring() -> UvMesh:
    return UvMesh.of(Mesh(*torus(96, 48), *torus_uv(96, 48)))


def detailed(
    kind: str, color: tuple[float, float, float] = BROWN, size: int = SIZE, strength: float = 1.0
):
    """The torus's maps in one material with the detail of ``kind``."""
    mesh, material = ring(), one_material(color)
    surfaces = (Surface(kind, tuple(torch.tensor(color).pow(1 / 2.2).tolist())),)
    options = {"strength": strength, "size": size, "seed": 1}
    detail = detail_of(mesh, material, surfaces, **options)
    return bake(mesh.mesh, material, size, finish=Finish(mesh, None, detail))


# NOISE


def test_gradient_noise_is_zero_on_its_lattice_and_lipschitz_between():
    nodes = np.stack(np.meshgrid(*[np.arange(-3.0, 4)] * 3), -1).reshape(-1, 3)
    assert np.abs(NOISE.waves(nodes, 1.0, 5)).max() < 1e-6
    values = NOISE.waves(line(0), 8.0, 5)
    assert values.std() > 0.1
    # Its slope is at most about 2.5 a cell.
    assert np.abs(np.diff(values)).max() < 3 * 8 * NOISE.footprint / 2


def test_seeds_and_salts_are_other_fields_and_the_same_ones_repeat():
    points = line(0)
    one = NOISE.waves(points, 8.0, 5)
    assert np.array_equal(one, NOISE.waves(points, 8.0, 5))
    for other in (NOISE.waves(points, 8.0, 6), Noise(4, 1 / 450).waves(points, 8.0, 5)):
        assert abs(np.corrcoef(one, other)[0, 1]) < 0.3


def test_cells_give_the_distance_to_the_nearest_point_and_more_to_the_second():
    near, gap, number = NOISE.cells(line(1), 10.0, 2)
    assert (gap >= 0).all()
    # A distance to a set changes no faster than the place does.
    assert np.abs(np.diff(near)).max() <= 10 * NOISE.footprint / 2 * 1.01
    # A cell's number is the same in all of it, and changes where the two are as near.
    changes = np.flatnonzero(np.diff(number))
    assert 5 < len(changes) < 200
    assert gap[changes].max() < 2 * 10 * NOISE.footprint


def test_what_a_texel_cannot_show_is_left_out():
    assert NOISE.seen(450 / 2) == 0
    assert NOISE.seen(450 / 4) == 1
    assert not NOISE.waves(line(0), 300.0, 1).any()


# KINDS


def test_every_kind_that_the_built_in_prior_names_has_its_detail():
    forms = [(word, "") for word in MATERIALS]
    forms += [(word, form) for form in VARIANTS for word in MATERIALS if form in MATERIALS[word]]
    by_nature = [(noun, ("", "")) for noun in NOUNS]
    # Every noun, and every form: each of a twentieth of the others.
    of_a_word = [(noun, form) for k, noun in enumerate(NOUNS) for form in forms[k % 20 :: 20]]
    for (noun, (material, form)), color in product([*by_nature, *of_a_word], ("", "blue")):
        words = Words(noun=noun, color=color, material=material, material_form=form)
        found = surfaces_of(words)
        assert {surface.kind for surface in found} <= KINDS.keys(), words
    assert {variant.kind for variant in VARIANTS.values()} <= KINDS.keys()
    assert FINISHES.keys() - {""} <= KINDS.keys()


def test_every_variant_is_a_word_of_its_material():
    for form, variant in VARIANTS.items():
        words = parse(f"a {form} cube")
        assert words.material_form == form
        assert surfaces_of(words)[0].kind == variant.kind


def test_a_flame_is_yellow_at_its_root_and_red_at_its_tip():
    """Embers, a sun's rays, are the same all over."""
    points = line(2, 2000)
    rise = np.linspace(0, 1, len(points), dtype=np.float32)
    flame = KINDS["flame"](replace(place_at(points), rise=rise)).ratio
    root, tip = flame[:400].mean(0), flame[-400:].mean(0)
    assert (root > 1.4 * tip).all()
    assert root[1] / root[0] > 1.5 * tip[1] / tip[0], "redder, not only darker"
    embers = KINDS["embers"](replace(place_at(points), rise=rise)).ratio
    assert np.allclose(embers[:400].mean(0), embers[-400:].mean(0), rtol=0.15)


def spread(count: int = 4000) -> Place:
    """Points all over a unit cube, of surfaces that face every way."""
    drawn = np.random.default_rng(0)
    point, normal = drawn.random((count, 3), np.float32), drawn.normal(size=(count, 3))
    normal = (normal / np.linalg.norm(normal, axis=1, keepdims=True)).astype(np.float32)
    return Place(point, normal, np.zeros(count, np.int64), NOISE)


def test_only_the_cracks_of_lava_glow_and_take_the_stated_colour():
    layer = KINDS["lava"](spread())
    crust = layer.cover > 0.9
    assert 0.4 < crust.mean() < 0.9 and (layer.cover < 0.1).mean() > 0.05
    assert layer.over.max() < 0.1 and np.array_equal(layer.apart, layer.cover)
    assert layer.height[crust].mean() > layer.height[layer.cover < 0.1].mean() + 0.004
    point = torch.from_numpy(spread().point)
    zero, one = torch.zeros(len(point), 1), torch.ones(len(point), 1)
    normal = torch.nn.functional.normalize(point - 0.5, dim=1)
    spots = Spots(point, normal, torch.ones_like(point), zero)
    for prompt, channel in (("a lava golem", 0), ("a blue lava golem", 2)):
        surface = next(one for one in surfaces_of(parse(prompt)) if one.kind == "lava")
        coat = Coat(srgb_to_linear(torch.tensor(surface.color)).expand(len(point), 3), one, zero)
        detail = Detail.of(ByColor.of((surface,), coat.kd), NOISE, 1.0, spots, coat)
        made, _ = detail(spots, coat)
        assert made.emission is not None
        assert (made.emission.argmax(1) == channel)[torch.from_numpy(layer.cover) < 0.1].all()
        assert made.emission[torch.from_numpy(crust)].max() < 0.02
        assert made.emission[torch.from_numpy(layer.cover < 0.1), channel].mean() > 0.2


def test_a_film_has_all_hues_by_its_direction_and_nacre_is_pale():
    strong, pale = (KINDS[kind](spread()).ratio for kind in ("iridescent", "pearl"))
    for channel in range(3):
        assert 0.2 < (strong.argmax(1) == channel).mean() < 0.5
    chroma = [float((ratio.max(1) / ratio.min(1)).mean()) for ratio in (strong, pale)]
    assert chroma[0] > 2.5 and 1.1 < chroma[1] < 1.6
    turned = replace(spread(), normal=-spread().normal)
    assert np.abs(KINDS["iridescent"](turned).ratio - strong).mean() > 0.3


def test_sequins_are_of_metal_and_the_cloth_between_them_is_not():
    layer = KINDS["sequins"](spread())
    disc = layer.metallic > 0.9
    assert 0.4 < disc.mean() < 0.95 and (layer.metallic < 0.1).mean() > 0.02
    assert layer.roughness[disc].max() < -0.4
    shades = layer.ratio[disc, 0]
    assert np.percentile(shades, 90) > 2 * np.percentile(shades, 10), "each at another angle"


def test_few_crystals_of_snow_glint_and_candy_is_banded_with_white():
    snow, candy = KINDS["snow"](spread()), KINDS["candy"](spread())
    assert 0.02 < (snow.roughness < -0.4).mean() < 0.12
    assert 0.3 < candy.cover.mean() < 0.6 and candy.over.min() > 0.75


def test_fingers_leave_prints_and_dents_in_plasticine():
    height = KINDS["plasticine"](place_at(line(0))).height
    assert height.std() > 0.0028, "dents"
    turns = (np.diff(np.sign(np.diff(height))) != 0).sum()
    assert turns > 80, "ridges, up and down"


def test_what_burns_rises_from_its_own_foot():
    """A candle's flame is at the top of it."""
    flame, wax = Surface("flame", (1.0, 0.6, 0.1), glow=1.0), Surface("cream", (0.9, 0.9, 0.8))
    z = torch.linspace(-0.5, 0.5, 400)
    area = (z > 0.3).long()
    point = torch.stack([torch.full_like(z, 0.1), torch.zeros_like(z), z], 1)
    normal = torch.tensor([[1.0, 0.0, 0.0]]).expand(400, 3)
    at = Spots(point, normal, torch.ones(400, 3), torch.zeros(400, 1), area)
    coat = Coat(torch.full((400, 3), 0.4), torch.full((400, 1), 0.5), torch.zeros(400, 1))
    detail = Detail.of(ByArea((wax, flame)), NOISE, 1.0, at, coat)
    assert detail.levels[1] == pytest.approx((0.3, 0.5), abs=0.01)
    made, _ = detail(at, coat)
    burning = made.emission[area == 1]
    assert (burning[:15].mean(0) > burning[-15:].mean(0)).all(), "brighter at its foot"
    assert (made.emission[area == 0] == 0).all()


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_shows_in_the_maps_and_keeps_the_mean_colour(kind):
    maps = detailed(kind)
    assert (maps.normal.norm(dim=-1) - 1).abs().max() < 1e-5
    # Not blank: some of it differs by 8 bits' step and more.
    assert float(maps.normal[..., :2].abs().max()) > 1 / 127
    assert float(maps.normal[..., 2].min()) > 0
    mean = maps.base_color.reshape(-1, 3).mean(0)
    if kind not in ("candy", "lava"):  # of which much has a colour of its own
        assert float((lab(mean) - lab(torch.tensor(BROWN))).norm()) < 5
    assert float(maps.orm[..., 1].std()) > 0.002
    for image in maps[:3]:
        assert bool(torch.isfinite(image).all())


def test_the_strength_0_leaves_what_was_learnt_and_so_does_a_guidance_without_surfaces():
    mesh, material = ring(), one_material(BROWN)
    options = {"size": SIZE, "seed": 1}
    surfaces = (Surface("wooden", BROWN),)
    assert detail_of(mesh, material, surfaces, strength=0.0, **options) is None
    assert detail_of(mesh, material, (), strength=1.0, **options) is None


@pytest.mark.parametrize("prompt", ["an ebony table", "a marble vase", "a chrome teapot"])
def test_the_strength_0_takes_no_narrower_material_for_the_wider_one(prompt: str):
    mesh, material, (surface, *_) = ring(), one_material(BROWN), surfaces_of(parse(prompt))
    detail = detail_of(mesh, material, (surface,), strength=0.0, size=SIZE, seed=1)
    assert detail is not None
    maps = bake(mesh.mesh, material, SIZE, finish=Finish(mesh, None, detail))
    learnt = bake(mesh.mesh, material, SIZE)
    wanted = (torch.tensor(BROWN) * torch.tensor(surface.factor)).clamp(0.002, 0.98)
    assert torch.allclose(maps.base_color, wanted.expand_as(maps.base_color), atol=1e-5)
    rough = (learnt.orm[..., 1] + surface.roughness).clamp(0.04, 1)
    assert torch.allclose(maps.orm[..., 1], rough, atol=1e-5)
    assert torch.allclose(maps.normal, learnt.normal, atol=1e-5)


def test_what_is_painted_shows_less_of_what_is_below():
    mesh, material = ring(), one_material(BROWN)
    color = tuple(torch.tensor(BROWN).pow(1 / 2.2).tolist())
    varied = []
    for depth in (1.0, 0.35):
        surfaces = (Surface("wooden", color, depth=depth),)
        detail = detail_of(mesh, material, surfaces, strength=1.0, size=SIZE, seed=1)
        maps = bake(mesh.mesh, material, SIZE, finish=Finish(mesh, None, detail))
        varied.append(float(maps.base_color[..., 0].std()))
    assert 0.2 * varied[0] < varied[1] < 0.5 * varied[0]


def test_stable_diffusion_paints_its_own_detail():
    assert PromptedStableDiffusion.surfaces is PromptedGuidance.surfaces
    assert "return ()" in inspect.getsource(PromptedGuidance.surfaces)


def test_the_strength_is_a_setting_with_a_range():
    assert DRAFT.appearance.detail == 1
    assert with_settings(DRAFT, {"appearance.detail": "0"}).appearance.detail == 0
    with pytest.raises(UserError, match=r"appearance\.detail"):
        with_settings(DRAFT, {"appearance.detail": 3})


def test_the_same_seed_gives_the_same_maps():
    first, second = (detailed("rusty", size=64)[:3] for _ in range(2))
    assert all(map(torch.equal, first, second))


@pytest.mark.parametrize("kind", ["wooden", "leather", "fabric", "brick", "rusty"])
def test_both_sides_of_a_uv_seam_have_the_same_detail(kind):
    """The torus's uv is cut along both rings: a vertex there is in two borders of the island."""
    mesh, material = ring(), one_material(BROWN)
    surfaces = (Surface(kind, BROWN),)
    detail = detail_of(mesh, material, surfaces, strength=1.0, size=1024, seed=0)
    finish = Finish(mesh, None, detail)
    uv_of: dict[int, dict[int, int]] = {}
    for corner, (vert, uv) in enumerate(
        zip(mesh.faces.reshape(-1).tolist(), mesh.face_uvs.reshape(-1).tolist(), strict=True)
    ):
        uv_of.setdefault(vert, {})[uv] = corner
    pairs = torch.tensor([list(c.values())[:2] for c in uv_of.values() if len(c) > 1])
    assert len(pairs) > 100
    learnt = torch.cat([*material(torch.zeros(len(pairs), 3))], 1)
    sides = [finish.attributes.view(-1, 14)[pairs[:, k]] for k in (0, 1)]
    one, two = (finish(at, learnt) for at in sides)
    torch.testing.assert_close(one[:, :5], two[:, :5], atol=1e-4, rtol=0)
    # The normal maps differ, since the tangents do; what they show does not.
    shown = [
        perturb(at[:, 3:6], at[:, 6:10], made[:, 5:])
        for at, made in zip(sides, (one, two), strict=True)
    ]
    torch.testing.assert_close(*shown, atol=1e-3, rtol=0)
    assert one[:, :5].std(0).max() > 0.01


def test_wood_changes_across_the_grain_more_than_along_it():
    def change(axis: int) -> float:
        starts = [(0.1, 0.2 + 0.05 * k, 0.3) for k in range(8)]
        tones = [KINDS["wooden"](place_at(line(axis, start=s))).ratio[:, 1] for s in starts]
        return float(np.mean([np.abs(np.diff(tone)).mean() for tone in tones]))

    assert change(1) > 4 * change(0)
    assert change(2) > 4 * change(0)


def test_rust_is_rough_and_brown_and_bare_metal_is_smooth_and_grey():
    layer: Layer = KINDS["rusty"](place_at(line(0, 20000)))
    bare = layer.metallic > 0.3
    rust = layer.metallic < -0.3
    assert 0.1 < bare.mean() < 0.6
    assert rust.mean() > 0.3
    assert layer.roughness[bare].mean() < layer.roughness[rust].mean() - 0.3
    warm = layer.over[:, 0] / layer.over[:, 2]
    assert warm[bare].mean() < 1.5 < 3 < warm[rust].mean()
    assert np.corrcoef(layer.roughness, layer.metallic)[0, 1] < -0.9


# PARTS


def two_tone(points: Tensor) -> Material:
    """Brown below, white above."""
    material = one_material(BROWN)(points)
    above = points[:, 2:] > 0
    return material._replace(kd=torch.where(above, torch.full_like(material.kd, 0.8), material.kd))


def test_each_colour_gets_its_own_surface_and_keeps_its_mean():
    brown, white = (Surface("wooden", (0.58, 0.41, 0.28)), Surface("glass", (0.91, 0.91, 0.91)))
    mesh = ring()
    detail = detail_of(mesh, two_tone, (brown, white), strength=1.0, size=512, seed=0)
    finish = Finish(mesh, None, detail)
    plain, maps = bake(mesh.mesh, two_tone, 512), bake(mesh.mesh, two_tone, 512, finish=finish)
    above = plain.base_color[..., 0] > 0.7
    tone = (maps.base_color / plain.base_color)[..., 1]
    assert tone[above].std() < 0.05 < 0.15 < tone[~above].std()
    for where in (above, ~above):
        shift = lab(maps.base_color[where].mean(0)) - lab(plain.base_color[where].mean(0))
        assert float(shift.norm()) < 5


def test_where_the_areas_are_known_the_colours_do_not_decide():
    """Two parts of one colour: the lower of wood, the upper of glass."""

    class Areas:
        each = tuple(
            area(surface=Surface(kind, (0.58, 0.41, 0.28))) for kind in ("wooden", "glass")
        )

        def of(self, points):
            return (points[:, 2] > 0).long()

        def certain(self, points, reach):
            return self.of(points), points[:, 2].abs() > 0.1

        def inside(self, points, area):
            raise NotImplementedError

        nearest = slope = inside

    mesh, material = ring(), one_material(BROWN)
    surfaces = (Surface("glass", (0.58, 0.41, 0.28)),)
    options = {"strength": 1.0, "size": 512, "seed": 0}
    detail = detail_of(mesh, material, surfaces, Areas(), **options)
    maps = bake(mesh.mesh, material, 512, finish=Finish(mesh, None, detail), areas=Areas())

    def height(points):
        return Material(points[:, 2:].expand(-1, 3), *(0 * points[:, :1],) * 2, 0 * points + 1)

    z = bake(mesh.mesh, height, 512).base_color[..., 0]
    grain = [
        float((maps.base_color[where] / BROWN[1]).std(0).mean()) for where in (z < -0.02, z > 0.02)
    ]
    assert grain[1] < 0.3 * grain[0] and grain[0] > 0.05
    shift = lab(maps.base_color[z > 0.02].mean(0)) - lab(torch.tensor(BROWN))
    assert float(shift.norm()) < 5  # each keeps its own mean


class Halves:
    """The lower half of the ring of one substance, the upper of another, of the same colour."""

    def __init__(self, low: Surface, high: Surface) -> None:
        self.each = (area(surface=low), area(surface=high))

    def of(self, points):
        return (points[:, 2] > 0).long()

    def certain(self, points, reach):
        return self.of(points), points[:, 2].abs() > 0.1

    def inside(self, points, area):
        raise NotImplementedError

    nearest = slope = inside


def lit_ring(low: Surface, high: Surface, strength: float = 1.0, known: bool = True):
    """Its maps, and the height of what each texel shows."""
    mesh, material = ring(), one_material(BROWN) if known else two_tone
    areas = Halves(low, high) if known else None
    options = {"strength": strength, "size": SIZE, "seed": 0}
    detail = detail_of(mesh, material, (low, high), areas, **options)
    maps = bake(mesh.mesh, material, SIZE, finish=Finish(mesh, None, detail), areas=areas)

    def height(points):
        return Material(points[:, 2:].expand(-1, 3), *(0 * points[:, :1],) * 2, 0 * points + 1)

    return maps, bake(mesh.mesh, height, SIZE).base_color[..., 0]


@pytest.mark.parametrize("strength", [1.0, 0.0])
def test_what_is_stated_to_glow_glows_and_all_else_is_dark(strength):
    """Also where no detail is wanted; padding included."""
    color = (0.58, 0.41, 0.28)
    lamp, glass = Surface("plain", color, glow=0.5), Surface("glass", color, clear=0.9)
    maps, z = lit_ring(lamp, glass, strength)
    low, high = z < -0.03, z > 0.03
    assert not maps.emission[high].any() and not maps.transmission[low].any()
    wanted = 0.5 * torch.tensor(BROWN) ** DEEP
    torch.testing.assert_close(maps.emission[low].mean(0), wanted, rtol=0.1, atol=1e-3)
    assert (maps.transmission[high] == 0.9).all()
    # What light goes through is of one wall's colour, lighter than what is seen of the whole.
    wanted = torch.tensor(BROWN) ** (1 - 0.9 * THIN)
    torch.testing.assert_close(maps.base_color[high].mean(0), wanted, rtol=0.1, atol=1e-3)


def test_without_such_a_substance_there_are_no_such_maps():
    color = (0.58, 0.41, 0.28)
    maps, _ = lit_ring(Surface("wooden", color), Surface("glass", color))
    assert maps.emission is maps.transmission is None


def test_told_by_colour_only_what_is_mostly_of_it_glows():
    lamp, wood = (
        Surface("plain", (0.91, 0.91, 0.91), glow=1.0),
        Surface("wooden", (0.58, 0.41, 0.28)),
    )
    maps, z = lit_ring(wood, lamp, known=False)
    assert maps.emission[z > 0.03].min() > 0.5 and not maps.emission[z < -0.03].any()


def test_what_covers_glass_neither_glows_nor_is_clear():
    color = (0.58, 0.41, 0.28)
    bare = Surface("glass", color, glow=1.0, clear=1.0)
    snowy, z = lit_ring(bare, bare._replace(weather=("snowy",)))
    white = snowy.base_color.amin(-1) > 0.8
    assert white.float().mean() > 0.1 and (z[white] > 0).all()
    below = z < -0.03
    assert snowy.transmission[white].mean() < 0.1 and snowy.transmission[below].min() == 1
    assert snowy.emission[white].mean() < 0.1 * snowy.emission[below].mean()


def test_parts_that_look_alike_are_one():
    near, far = (0.10, 0.10, 0.11), (0.9, 0.9, 0.9)
    surfaces = (Surface("paint", (0.1, 0.1, 0.1)), Surface("glass", near), Surface("rubber", far))
    parts = ByColor.of(surfaces, srgb_to_linear(torch.tensor([[0.1] * 3, [0.9] * 3])))
    assert [surface.kind for surface in parts.surfaces] == ["paint", "rubber"]


def test_the_words_say_what_each_part_is_made_of():
    def kinds(prompt: str) -> list[str]:
        return [surface.kind for surface in surfaces_of(parse(prompt))]

    assert set(kinds("a red wooden chair")) == {"wooden"}
    assert set(kinds("a chair")) == {"wooden"}  # by nature
    assert set(kinds("a hammer")) == {"metal", "wooden", "rubber", "plastic"}
    assert "masonry" in kinds("a stone house") and "glass" in kinds("a stone house")
    assert kinds("a stone bust")[0] == "stone"
    assert kinds("a marble bust")[0] == "marble"
    assert kinds("a rusty robot")[0] == "rusty"
    assert kinds("a blue rusty robot")[0] == "rusted paint"
    assert set(kinds("an apple")) == {"peel", "leaf"}


def test_a_variants_own_colour_is_for_prompts_without_one():
    marble, pink = (surfaces_of(parse(p))[0] for p in ("a marble ball", "a pink marble ball"))
    assert min(marble.factor) > 1.5
    assert pink.factor == (1, 1, 1)
    known = srgb_to_linear(torch.tensor(FINISHES["stone"].color))
    wanted = srgb_to_linear(torch.tensor(VARIANTS["marble"].color))
    torch.testing.assert_close(known * torch.tensor(marble.factor), wanted)


def test_every_noun_has_surfaces_without_words():
    for noun in NOUNS:
        assert surfaces_of(Words(noun=noun))


# GRAIN


def box_mesh(size: tuple[float, float, float], steps: int = 12) -> Mesh:
    """A closed box of small triangles."""
    import trimesh

    box = trimesh.creation.box(size)
    for _ in range(4):
        box = box.subdivide()
    return Mesh(torch.tensor(box.vertices).float(), torch.tensor(box.faces))


def test_a_parts_length_is_its_grain():
    for axis in range(3):
        size = [0.1, 0.1, 0.1]
        size[axis] = 1.0
        box = box_mesh(tuple(size))
        assert (lengths(box.verts, box.faces).argmax(1) == axis).float().mean() > 0.95


def test_lengths_do_not_depend_on_how_many_vertices_are_looked_at_at_once(monkeypatch):
    box = box_mesh((1.0, 0.1, 0.1))
    assert len(box.verts) < grain.CHUNK
    whole = lengths(box.verts, box.faces)
    monkeypatch.setattr(grain, "CHUNK", 100)
    most = 0

    class Points(grain.KDTree):
        def sparse_distance_matrix(self, other, *args, **kwargs):
            nonlocal most
            found = super().sparse_distance_matrix(other, *args, **kwargs)
            most = max(most, found.nnz)
            return found

    monkeypatch.setattr(grain, "KDTree", Points)
    torch.testing.assert_close(lengths(box.verts, box.faces), whole, atol=1e-6, rtol=0)
    assert 0 < most <= 100 * grain.SAMPLES


def test_wicker_closes_around_and_the_finish_knows_the_parts_lengths():
    ends = np.array([[-0.3, y, 0.1] for y in (1e-5, -1e-5)], np.float32)
    one, other = KINDS["wicker"](place_at(ends, Noise(1, 0.013))).height
    assert abs(one - other) < 2e-4
    mesh, material = ring(), one_material(BROWN)
    surfaces = (Surface("wooden", BROWN),)
    detail = detail_of(mesh, material, surfaces, strength=1.0, size=256, seed=0)
    attributes = Finish(mesh, None, detail).attributes[..., 10:13]
    torch.testing.assert_close(attributes, lengths(mesh.verts, mesh.faces)[mesh.faces])
