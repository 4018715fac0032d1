"""Settings: presets, --set, and what is said about a wrong one."""

import pytest

from core.config import PRESETS, preset, setting_names, with_settings
from core.errors import UserError
from core.io.job import Job
from core.job_config import config_of


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
        ("geometry.eikonal", "nan", "a number"),
        ("geometry.net.encoding", "spline", "hash or fourier"),
        ("appearance.rotate_light", "maybe", "true or false"),
        ("geometry.radii", "1,2", "3 numbers"),
    ],
)
def test_a_wrong_setting_is_named_with_its_fix(key, value, words):
    with pytest.raises(UserError, match=words) as caught:
        with_settings(preset("draft"), {key: value})
    assert caught.value.status == 2


def test_the_paper_preset_says_what_the_paper_says():
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
    assert caught.value.fix == "It takes lobes or split_sum."


@pytest.mark.parametrize("name", PRESETS)
def test_the_builtin_prior_brings_its_own_scales_and_caps(name) -> None:
    """A preset is about effort: its steps and views stay."""
    draft, own = preset("draft"), preset(name)
    config = config_of(Job(prompt="a mug", preset=name))
    for phase in ("coarse", "fine"):
        here = getattr(config.geometry, phase)
        assert here.guidance_scale == getattr(draft.geometry, phase).guidance_scale
        assert here.steps == getattr(own.geometry, phase).steps
    assert config.geometry.gradient_cap == draft.geometry.gradient_cap
    assert config.appearance.late.guidance_scale == draft.appearance.late.guidance_scale
    assert config.geometry.views == own.geometry.views
    assert config.geometry.net == own.geometry.net
    assert config_of(Job(prompt="a mug", preset=name, guidance="/a/model")) == own
    settings = {"geometry.coarse.guidance_scale": 7}
    set_by_user = config_of(Job(prompt="a mug", preset=name, settings=settings))
    assert set_by_user.geometry.coarse.guidance_scale == 7


def test_sds_is_score_distillation_alone() -> None:
    sds = preset("sds")
    assert sds.geometry.grow.rounds == sds.geometry.refine.rounds == 0
    assert sds.appearance.refine.rounds == 0
    assert preset("draft") == config_of(Job(prompt="a mug"))
