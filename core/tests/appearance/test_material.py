"""Γ: its ranges, its tangent-space normal, the paper's specular term."""

from dataclasses import replace

import pytest
import torch

from core.appearance.material import Material, MaterialNet, specular_color, to_ranges
from core.appearance.material_ranges import LocalRanges, MaterialRanges
from core.config import AppearanceConfig, preset
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.areas import SolidAreas
from core.guidance.builtin.palette import looks
from core.guidance.load import make_guidance
from core.job_config import local_ranges, within
from core.ops import linear_to_srgb, srgb_to_linear
from core.tests.drawn_things import shipped_prior
from core.tests.texture_shapes import area

CONFIG = AppearanceConfig(log2_hash_size=10, finest=32)


def test_the_ends_of_the_sigmoids_are_the_ends_of_the_ranges():
    raw = torch.full((1, 8), 40.0)
    for sign, end in ((-1, 0), (1, 1)):
        srgb = to_ranges(sign * raw, replace(CONFIG, kd_curve="srgb"))
        m = to_ranges(sign * raw, CONFIG)
        torch.testing.assert_close(srgb.kd, torch.full((1, 3), CONFIG.kd_range[end]))
        torch.testing.assert_close(m.kd, torch.full((1, 3), CONFIG.kd_range[end]))
        torch.testing.assert_close(m.roughness, torch.full((1, 1), CONFIG.roughness_range[end]))
        torch.testing.assert_close(m.metallic, torch.full((1, 1), CONFIG.metallic_range[end]))


def test_the_normal_is_unit_and_never_points_into_the_surface():
    raw = 5 * torch.randn(500, 8, generator=torch.Generator().manual_seed(0))
    kn = to_ranges(raw, CONFIG).kn
    torch.testing.assert_close(kn.norm(dim=1), torch.ones(500))
    assert float(kn[:, 2].min()) > 0
    flat = to_ranges(raw, replace(CONFIG, bump=0.0)).kn
    torch.testing.assert_close(flat, torch.tensor([[0.0, 0, 1]]).expand(500, 3))


def test_a_seed_gives_the_same_material_and_another_seed_another():
    points = torch.rand(20, 3, generator=torch.Generator().manual_seed(1))
    a, b, c = (
        MaterialNet(CONFIG, torch.Generator().manual_seed(seed)).raw(points) for seed in (1, 1, 2)
    )
    assert torch.equal(a, b)
    assert not torch.equal(a, c)


def test_kd_runs_over_linear_light_as_the_papers_does_or_over_srgb_as_the_drafts():
    middle = torch.zeros(1, 8)
    paper, draft = preset("paper").appearance, preset("draft").appearance
    torch.testing.assert_close(to_ranges(middle, paper).kd, torch.full((1, 3), 0.5))
    of_srgb = srgb_to_linear(linear_to_srgb(torch.tensor(draft.kd_range)).mean())
    torch.testing.assert_close(to_ranges(middle, draft).kd, of_srgb.expand(1, 3))


def test_it_starts_grey_half_rough_and_as_metallic_as_asked():
    config = replace(CONFIG, metallic_start=0.1, kd_curve="srgb")
    m = MaterialNet(config, torch.Generator().manual_seed(0))(torch.zeros(1, 3))
    middle = linear_to_srgb(torch.tensor(CONFIG.kd_range)).mean()  # of what the eye sees
    torch.testing.assert_close(linear_to_srgb(m.kd), middle.expand(1, 3), atol=0.01, rtol=0)
    torch.testing.assert_close(m.roughness, torch.tensor([[0.49]]), atol=0.01, rtol=0)
    torch.testing.assert_close(m.metallic, torch.tensor([[0.1]]), atol=0.01, rtol=0)


@pytest.mark.parametrize(("m", "ks"), [(0.0, 0.04), (1.0, 0.6), (0.5, 0.32)])
def test_the_specular_term_is_the_papers(m, ks):
    material = Material(torch.full((1, 3), 0.6), torch.ones(1, 1), torch.full((1, 1), m),
                        torch.tensor([[0.0, 0, 1]]))  # fmt: skip
    torch.testing.assert_close(specular_color(material), torch.full((1, 3), ks))


def test_the_words_bound_the_material():
    """The built-in prior knows what its words are made of; others leave all open."""
    guidance = make_guidance("builtin", "cpu")
    for prompt, metallic in (
        ("a red wooden chair", (0.0, 0.02)),
        ("a golden mug", (0.98, 1.0)),
        ("a lamp", (0.0, 1.0)),  # its pole is golden by nature
        ("a chair with golden legs", (0.0, 1.0)),
        ("a golden car", (0.98, 1.0)),  # of its wheels no more is known than of its body
    ):
        bounds = guidance.prompted(prompt, "").ranges()
        assert bounds.metallic == pytest.approx(metallic)
        config = within(CONFIG, bounds)
        assert config.metallic_range == bounds.metallic
        assert 0 < config.roughness_range[0] < config.roughness_range[1] < 1
    rough = guidance.prompted("a rubber ball", "").ranges().roughness
    assert rough[0] > guidance.prompted("a metal ball", "").ranges().roughness[1]
    assert within(CONFIG, None) == CONFIG


def halves() -> LocalRanges:
    """Rough at x < 0, smooth metal at x > 0; between 0.2 and 0.4 of y it follows z."""
    side = torch.linspace(-EXTENT, EXTENT, 22)
    areas = (side > 0).long()[:, None, None].repeat(1, 22, 22)
    band = (side > 0.2) & (side < 0.4)
    areas[:, band] = (side > 0).long()[None, None].expand(22, int(band.sum()), 22)
    ranges = [MaterialRanges((0.8, 0.9), (0.0, 0.0)), MaterialRanges((0.1, 0.2), (1.0, 1.0))]
    return LocalRanges(areas, ranges, CONFIG.kd_range)


def test_each_place_has_its_areas_ranges():
    net = MaterialNet(CONFIG, torch.Generator().manual_seed(0), halves())
    x, y, z = torch.tensor([[-0.5, 0, 0.6], [0.5, 0, -0.6], [-0.5, 0.3, 0.6], [0.5, 0.3, -0.6]]).T
    m = net(torch.stack([x, y, z], 1))
    torch.testing.assert_close(m.roughness[:, 0], torch.tensor([0.85, 0.15, 0.15, 0.85]))
    assert m.metallic[:, 0].tolist() == [0, 1, 1, 0]
    known = net(torch.stack([x, y, z], 1), area=torch.tensor([1, 0, 0, 1]))
    assert known.metallic[:, 0].tolist() == [1, 0, 0, 1]
    close = net(torch.tensor([[0.03, 0, 0], [-0.03, 0, 0]]))  # the nearest nodes are at 0.05
    assert close.metallic[:, 0].tolist() == [1, 0]
    far = net(torch.tensor([[9.0, 0, 0], [-9.0, 0, 0]]))  # outside of the cube too
    assert far.metallic[:, 0].tolist() == [1, 0]


def test_an_areas_colour_stays_in_its_range():
    red = ((0.2, 0.04, 0.04), (0.5, 0.05, 0.06))
    ranges = [MaterialRanges((0.5, 0.5), (0.0, 0.0), red), MaterialRanges((0.5, 0.5), (0.0, 0.0))]
    local = LocalRanges(torch.zeros(2, 2, 2, dtype=torch.long), ranges, CONFIG.kd_range)
    points = torch.rand(64, 3, generator=torch.Generator().manual_seed(0)) - 0.5
    raw = torch.linspace(-9, 9, 64)[:, None].expand(64, 8)
    for curve in ("linear", "srgb"):
        config = replace(CONFIG, kd_curve=curve)
        kd = to_ranges(raw, config, local(points)).kd
        low, high = map(torch.tensor, red)
        assert ((kd > low - 1e-6) & (kd < high + 1e-6)).all()
        torch.testing.assert_close(kd[[0, -1]], torch.stack([low, high]), atol=1e-3, rtol=0)
        other = to_ranges(raw, config, local(points, torch.ones(64, dtype=torch.long))).kd
        torch.testing.assert_close(other, to_ranges(raw, config).kd)


def test_a_drawn_parts_colour_is_looked_for_around_the_words_own():
    builtin = shipped_prior()
    areas = builtin.prompted("a snowman with a green scarf", "").of_object(0).areas()
    names = list(looks("snowman"))
    hat, scarf = (areas.each[names.index(part)].ranges.color for part in ("hat", "scarf"))
    assert max(hat[1]) < 0.03  # black, without a tinge of green
    assert scarf[0][1] > 3 * scarf[1][0]  # its green is far above its red
    both = builtin.prompted("a red and white striped mug", "").of_object(0).areas()
    red, white = (both.each[k].ranges.color for k in (0, 1))
    assert red[1][1] < 0.2 < min(white[0])
    config = replace(CONFIG, kd_range=(0.1, 0.4))  # the job's own bounds hold there too
    drawn = local_ranges(config, both)(torch.zeros(2, 3), torch.tensor([0, 1])).color
    assert torch.stack(drawn).aminmax() == (torch.tensor(0.1), torch.tensor(0.4))
    arch = builtin.prompted("an arch", "").of_object(0).areas()
    assert not all(one.plain for one in arch.each)  # its bricks are learnt
    assert all((one.ranges.color is None) == (not one.plain) for one in arch.each)


def test_the_ranges_of_places_are_not_kept_in_checkpoints_and_go_to_the_device():
    net = MaterialNet(CONFIG, torch.Generator().manual_seed(0), halves())
    plain = MaterialNet(CONFIG, torch.Generator().manual_seed(0))
    assert net.state_dict().keys() == plain.state_dict().keys()
    assert net.to("meta").local.areas.device.type == "meta"


def test_what_is_matte_stays_matte_and_without_areas_there_are_no_ranges_of_places():
    areas = SolidAreas(lambda p: (p[:, 0], p[:, :1]), (area(),), cells=4)
    assert local_ranges(replace(CONFIG, shading="diffuse"), areas) is None
    assert local_ranges(CONFIG, areas).areas.shape == (5, 5, 5)
    assert local_ranges(CONFIG, None) is None
