"""Settings: presets, --set, and the error for a wrong one."""

import dataclasses
from dataclasses import fields, replace

import pytest

from core.config import PRESETS, preset
from core.errors import UserError
from core.io.job import Job
from core.job_config import config_of
from core.ranges import range_of
from core.settings import check, setting_names, with_settings


def test_every_setting_can_be_set_to_its_own_value():
    for name, config in PRESETS.items():
        for key in setting_names(config):
            value = config
            for part in key.split("."):
                value = getattr(value, part)
            text = ",".join(map(str, value)) if isinstance(value, tuple) else str(value)
            assert with_settings(config, {key: text}) == config, (name, key)


def test_a_setting_reaches_its_field_and_no_other():
    config = with_settings(preset("draft"), {"geometry.fine.t_high": "0.7,0.3"})
    assert config.geometry.fine.t_high == (0.7, 0.3)
    back = with_settings(config, {"geometry.fine.t_high": preset("draft").geometry.fine.t_high})
    assert back == preset("draft")


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("geometry.fine.stepps", "3", "Did you mean geometry.fine.steps"),
        ("steps", "3", "Did you mean"),
        ("geometry", "3", "no setting 'geometry'"),
        ("geometry.views.more", "3", "no setting"),
        ("geometry.views", "many", "a whole number"),
        ("geometry.views", "3.5", "a whole number"),
        ("geometry.eikonal", "nan", "geometry.eikonal is nan. Use 0 to"),
        ("geometry.eikonal", "inf", "0 to"),
        ("geometry.eikonal", "much", "a number"),
        ("geometry.resolution", "0,0", "geometry.resolution is 0,0. Use 4 to 512"),
        ("geometry.resolution", "64,100000", "4 to 512"),
        ("geometry.resolution", "inf,64", "2 numbers"),
        ("geometry.radii", "nan,0.5,0.5", "geometry.radii is nan,0.5,0.5. Use 0.05 to 1"),
        ("geometry.radii", "0.5,inf,0.5", "0.05 to 1"),
        ("geometry.coarse.steps", "-3", "geometry.coarse.steps is -3. Use 0 to 1000000"),
        ("geometry.coarse.steps", "1e9", "a whole number"),
        ("geometry.coarse.steps", float("inf"), "a whole number"),
        ("geometry.views", "0", "geometry.views is 0. Use 1 to"),
        ("geometry.views_at_once", "0", "1 to"),
        ("geometry.cameras.distance", "3,2", "1.5 to 9, rising"),
        ("geometry.cameras.fovy_deg", "0,0", "1 to 170"),
        ("geometry.coarse.t_high", "1.5,0.5", "0 to 1"),
        ("geometry.net.width", "0", "1 to"),
        ("appearance.kd_range", "0.9,0.1", "0 to 1, rising"),
        ("appearance.learning_rate", "0", "1e-09 to 1"),
        ("appearance.learning_rate_end", "0", "1e-06 to 1"),  # or only the first step would move
        ("appearance.metallic_start", "0", "0.001 to 0.999"),  # or it would never leave it
        ("texture.size", "0", "texture.size is 0. Use 64 to 8192"),
        ("texture.size", "100000", "64 to 8192"),
        ("texture.max_faces", "-1", "100 to"),
        ("texture.samples", "0", "1 to 64"),
        ("texture.samples", "5", "texture.samples is 5. Use a square number from 1 to 64"),
        ("geometry.net.encoding", "spline", "hash or fourier"),
        ("appearance.rotate_light", "maybe", "true or false"),
        ("geometry.radii", "1,2", "3 numbers"),
    ],
)
def test_a_wrong_setting_is_named_with_its_fix(key, value, words):
    with pytest.raises(UserError, match=words) as caught:
        with_settings(preset("draft"), {key: value})
    assert caught.value.status == 2


def test_the_paper_preset_has_the_papers_values():
    """ "Implementation Details": 24 views, rates, widths, w(t) by phase."""
    paper = preset("paper")
    assert (paper.geometry.views, paper.appearance.views) == (24, 24)
    assert (paper.geometry.learning_rate, paper.appearance.learning_rate) == (1e-3, 1e-2)
    assert (paper.geometry.net.hidden, paper.geometry.net.width) == (2, 32)  # three layers
    assert (paper.appearance.layers, paper.appearance.hidden) == (2, 32)
    assert paper.geometry.coarse.weighting == "sigma2"
    assert paper.geometry.fine.weighting == "sigma2_sqrt"
    assert paper.appearance.early.weighting == "sigma2_sqrt"
    assert paper.appearance.late.weighting == "inv_sigma2"


def test_an_unknown_preset_is_refused():
    with pytest.raises(UserError, match="draft, sds, standard, paper"):
        preset("fast")


def test_shading_model_is_a_setting() -> None:
    draft = preset("draft")
    config = with_settings(draft, {"appearance.shading": "split_sum"})
    assert config.appearance.shading == "split_sum"
    assert draft.appearance.shading == "lobes"
    with pytest.raises(UserError, match="appearance.shading is 'phong'") as caught:
        with_settings(draft, {"appearance.shading": "phong"})
    assert caught.value.fix == "Use lobes or split_sum or diffuse."


def numbers(config, prefix=""):
    """Key and type of every setting that is a number or several."""
    for f in fields(config):
        value = getattr(config, f.name)
        if dataclasses.is_dataclass(value):
            yield from numbers(value, f"{prefix}{f.name}.")
        elif not isinstance(value, bool | str):
            yield prefix + f.name, f.type


def test_every_number_has_a_range_and_refuses_what_is_beyond_it():
    draft = preset("draft")
    for key, kind in numbers(draft):
        allowed = range_of(kind)
        assert allowed, f"{key} has no range"
        value = draft
        for part in key.split("."):
            value = getattr(value, part)
        n = len(value) if isinstance(value, tuple) else 1
        whole = type(value[0] if n > 1 else value) is int
        for wrong in (allowed.low - 1, allowed.high + 1, "nan", "inf", "-inf"):
            text = str(int(wrong) if whole and not isinstance(wrong, str) else wrong)
            with pytest.raises(UserError, match=rf"^{key} is ") as caught:
                with_settings(draft, {key: ",".join([text] * n)})
            assert caught.value.fix.startswith("Use ")


def test_every_preset_is_in_its_ranges():
    for config in PRESETS.values():
        check(config)


def test_a_config_is_checked_as_a_whole():
    draft = preset("draft")
    with pytest.raises(UserError, match="texture.size is 7. Use 64 to 8192"):
        check(replace(draft, texture=replace(draft.texture, size=7)))
    settings = {"geometry.fine.t_low": "0.9", "geometry.fine.t_high": "0.5,0.5"}
    with pytest.raises(UserError, match="geometry.fine.t_low is 0.9. Use no more than"):
        config_of(Job(prompt="a chair", settings=settings))


@pytest.mark.parametrize("name", PRESETS)
def test_the_builtin_prior_brings_its_own_scales_and_caps(name) -> None:
    """A preset is about effort: its steps and views stay."""
    draft, own = preset("draft"), preset(name)
    distilled = {"geometry.start": "ellipsoid"}  # a drawn solid leaves nothing to distil
    own = replace(own, geometry=replace(own.geometry, start="ellipsoid"))
    config = config_of(Job(prompt="a mug", preset=name, settings=distilled))
    for phase in ("coarse", "fine"):
        here = getattr(config.geometry, phase)
        assert here.guidance_scale == getattr(draft.geometry, phase).guidance_scale
        assert here.steps == getattr(own.geometry, phase).steps
    assert config.geometry.gradient_cap == draft.geometry.gradient_cap
    assert config.appearance.late.guidance_scale == draft.appearance.late.guidance_scale
    assert config.geometry.views == own.geometry.views
    hashed = own.geometry.net.encoding == "hash"
    finest = own.geometry.resolution[1] if hashed else own.geometry.net.finest
    assert config.geometry.net == replace(own.geometry.net, finest=finest)
    assert config.geometry.learning_rate == own.geometry.learning_rate
    assert config_of(Job(prompt="a mug", preset=name, guidance="/a/model")) == own
    settings = {"geometry.coarse.guidance_scale": 7}
    set_by_user = config_of(Job(prompt="a mug", preset=name, settings=settings))
    assert set_by_user.geometry.coarse.guidance_scale == 7


def test_sds_is_score_distillation_alone() -> None:
    sds = preset("sds")
    assert sds.geometry.grow.rounds == sds.geometry.refine.rounds == 0
    assert sds.appearance.refine.rounds == 0
    draft = preset("draft")
    distilled = config_of(Job(prompt="a mug", settings={"geometry.start": "ellipsoid"}))
    a = draft.appearance
    # Pictures as small as the prior sees them, where they are fitted to, and there alone.
    phases = {name: replace(getattr(a, name), size=64) for name in ("early", "late", "refine")}
    expected = replace(draft, geometry=replace(draft.geometry, start="ellipsoid"))
    assert distilled == replace(expected, appearance=replace(a, **phases))
    assert config_of(Job(prompt="a mug", preset="sds")).appearance.early.size == 128
