"""Any JSON in job.json, asset.json and the settings: a valid object or a UserError."""

import contextlib
import dataclasses
import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core.appearance.lights import load_light
from core.config import PRESETS, Config, preset
from core.device import device_of
from core.errors import UserError
from core.guidance.stable_diffusion.checkpoint import find_checkpoint
from core.io.asset import inspect
from core.io.job import Job
from core.io.mesh_file import load_mesh
from core.job_config import config_of
from core.settings import check, setting_names, with_settings
from core.stages.start_color import start_picture
from core.terminal import sentence_of
from core.tests.bad_files import make_assets

SURROGATES = st.text(st.characters(categories=["Cs", "Cc", "L"]), max_size=5)
TEXT = st.text(max_size=20) | SURROGATES
NUMBER = st.integers() | st.floats() | st.sampled_from([10**30, -(10**400), 1e308, 2**63, 1e-320])
JSON = st.recursive(
    st.none() | st.booleans() | NUMBER | TEXT,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(TEXT, inner, max_size=3),
    max_leaves=5,
)
# What a user may write after "=", near to what is right.
WORDS = TEXT | st.lists(NUMBER | TEXT, max_size=4).map(lambda parts: ",".join(map(str, parts)))
FIELDS = [field.name for field in dataclasses.fields(Job)]
NAMES = setting_names(Config())
quick = settings(
    max_examples=150,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)


def answered(work: Callable[[], object]) -> object:
    """What ``work`` gives; None where it is refused in words for the user."""
    try:
        return work()
    except (UserError, OSError) as error:  # OSError: such as a name that is too long
        caught = error if isinstance(error, UserError) else sentence_of(error)
    assert caught is not None and caught.text and caught.fix
    return None


@quick
@given(st.dictionaries(st.sampled_from([*FIELDS, "sede"]), JSON, min_size=1, max_size=2))
def test_any_job_is_a_job_or_a_sentence(given_fields):
    text = json.dumps({"version": 1, "prompt": "a red cube"} | given_fields)
    job = answered(lambda: Job.from_json(text))
    if job is not None:
        assert Job.from_json(job.to_json()) == job
        assert answered(lambda: config_of(job)) is None or check(config_of(job)) is None


@quick
@given(text=st.text(max_size=60) | JSON.map(json.dumps))
def test_any_text_of_a_job_is_a_job_or_a_sentence(text):
    answered(lambda: Job.from_json(text))


@quick
@given(key=st.sampled_from(NAMES), value=WORDS | JSON)
def test_any_setting_is_in_its_range_or_a_sentence(key, value):
    config = answered(lambda: with_settings(preset("draft"), {key: value}))
    if config is not None:
        with contextlib.suppress(UserError):  # one setting may contradict another
            check(config)
        new, old = setting(config, key), setting(preset("draft"), key)
        assert type(new) is type(old)
        if isinstance(old, tuple):
            assert [type(x) for x in new] == [type(x) for x in old]


def setting(config: object, key: str) -> object:
    for name in key.split("."):
        config = getattr(config, name)
    return config


@quick
@given(key=TEXT | st.sampled_from([name.rsplit(".", 1)[0] for name in NAMES]), value=JSON)
def test_no_other_name_is_a_setting(key, value):
    if key not in NAMES:
        with pytest.raises(UserError, match="There is no setting"):
            with_settings(preset("draft"), {key: value})


@quick
@given(TEXT)
def test_any_name_of_a_preset_is_one_or_a_sentence(name):
    assert answered(lambda: preset(name)) == PRESETS.get(name)


@pytest.mark.parametrize("name", PRESETS)
@pytest.mark.parametrize("guidance", ["builtin", "some/model"])
def test_every_preset_is_in_its_ranges(name, guidance):
    check(config_of(Job(prompt="a red cube", preset=name, guidance=guidance)))


@quick
@given(TEXT | st.sampled_from(["/", "~", "~nobody", "a\0b", "..", "x" * 300, "cpu:-1", "cuda:1"]))
def test_any_name_of_a_file_or_a_device_is_one_or_a_sentence(name):
    uv_mesh = load_mesh(UV_MESH)
    for read in (load_light, load_mesh, find_checkpoint, device_of):
        answered(lambda read=read: read(name))
    answered(lambda: start_picture(name, uv_mesh))


@pytest.fixture(autouse=True, scope="module")
def offline():
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("HF_HUB_OFFLINE", "1")
        yield


@pytest.fixture(autouse=True, scope="module")
def uv_mesh(tmp_path_factory):
    global UV_MESH
    UV_MESH = tmp_path_factory.mktemp("mesh") / "a.obj"
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"
    UV_MESH.write_text(text)


@pytest.fixture(scope="module")
def asset(tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("asset")
    make_assets(made)
    return made / "asset"


PLACES = [
    *((name,) for name in ("version", "prompt", "mesh", "files", "timings", "size_m", "x")),
    *(("mesh", name) for name in ("verts", "faces", "closed", "bounds")),
    *(("files", name) for name in ("mesh.obj", "../x.png")),
]


@settings(quick, max_examples=60)
@given(place=st.sampled_from(PLACES), value=JSON)
def test_any_asset_json_is_an_asset_or_a_sentence(asset, tmp_path, place, value):
    folder = tmp_path / "asset"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(asset, folder)
    info = json.loads((folder / "asset.json").read_text(encoding="utf-8"))
    inner = info
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    (folder / "asset.json").write_text(json.dumps(info), encoding="utf-8")
    report = answered(lambda: inspect(folder))
    if report is not None:
        json.dumps(report, allow_nan=False)
