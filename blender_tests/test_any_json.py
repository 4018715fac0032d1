"""Any JSON in the files that the add-on reads: a value, or an AddonError, never another error."""

import contextlib
import json
import shutil
from pathlib import Path

import pytest

pytest.importorskip("hypothesis", reason="not in this Python")
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from blender_tests.asset_fixture import write_asset
from fantasia3d_addon.asset.asset_folder import read_asset, read_info
from fantasia3d_addon.errors import AddonError
from fantasia3d_addon.jobs import events, history, job_file, progress
from fantasia3d_addon.jobs.process import Run
from fantasia3d_addon.jobs.target import Target

TEXT = st.text(max_size=20) | st.text(st.characters(categories=["Cs", "Cc", "L"]), max_size=5)
NUMBER = st.integers() | st.floats() | st.sampled_from([10**30, -(10**400), 1e308, 2**63, True])
JSON = st.recursive(
    st.none() | NUMBER | TEXT | st.sampled_from(["../x", "/etc/passwd", "C:\\x", "mesh", "done"]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(TEXT, inner, max_size=3),
    max_leaves=4,
)
JOB = {"version": 1, "prompt": "a red cube", "command": "generate", "seed": 3, "settings": {}}
FIELDS = [*job_file.KINDS, "ignore_unknown_words", "more"]
quick = settings(
    max_examples=60,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)


@pytest.fixture
def run(tmp_path: Path) -> Path:
    (tmp_path / "run").mkdir()
    return tmp_path / "run"


@quick
@given(field=st.sampled_from(FIELDS), value=JSON)
def test_any_job_is_an_entry_of_the_history_or_none(run, field, value):
    (run / "job.json").write_text(json.dumps(JOB | {field: value}), encoding="utf-8")
    job = job_file.read_job(run)
    assert job in ({}, JOB | {field: value})
    events.stages_of(job)
    entry = history.read_entry(run)
    assert (entry is None) == (not job)
    if entry is not None:
        entry.prompt.encode()
        with contextlib.suppress(AddonError):
            again, _ = history.copy_of_job(entry, history.other_seed(entry.job.get("seed", 0)))
            json.dumps(job_file.with_own_paths(again, run))


@quick
@given(st.lists(st.tuples(st.sampled_from([*events.KINDS, "more"]), JSON), max_size=4))
def test_any_event_is_an_event_or_a_warning(run, changes):
    event = {"type": "progress", "stage": "geometry", "step": 1, "steps": 9} | dict(changes)
    line = json.dumps(event).encode() + b"\n"
    (run / "job.json").write_text(json.dumps(JOB), encoding="utf-8")
    (run / "events.jsonl").write_bytes(line)
    entry = history.read_entry(run)
    assert entry is not None
    assert entry.seconds >= 0
    followed = progress.FollowedRun(Run.attach(run), Target(), None, 0)
    followed.poll()
    assert followed.progress.line.encode() and followed.progress.detail is not None
    for path in (followed.shape, followed.picture):
        assert path is None or path.resolve().is_relative_to(run.resolve())
    assert followed.run.pid >= 0


@quick
@given(field=st.sampled_from(["file", "scene", "location", "object", "assign", "x"]), value=JSON)
def test_any_target_is_a_target(run, field, value):
    (run / "target.json").write_text(json.dumps({field: value}), encoding="utf-8")
    target = Target.read(run)
    assert len(target.location) == 3
    assert all(isinstance(number, int | float) for number in target.location)
    target.object.encode()


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_asset(tmp_path_factory.mktemp("small") / "asset", size=8)


def changed(asset: Path, to: Path, place: tuple[str, ...], value: object) -> Path:
    """A copy of ``asset`` whose asset.json has ``value`` in ``place``."""
    shutil.rmtree(to, ignore_errors=True)
    shutil.copytree(asset, to)
    info = json.loads((to / "asset.json").read_text("utf-8"))
    inner = info
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    (to / "asset.json").write_text(json.dumps(info), encoding="utf-8")
    return to


PLACES = [
    *((name,) for name in ("version", "prompt", "mesh", "files", "distribution", "light", "x")),
    *(("mesh", name) for name in ("verts", "faces")),
    *(("files", name) for name in ("mesh.obj", "normal.png", "x", "../x.png", "/etc/passwd")),
    *(("files", "normal.png", name) for name in ("role", "color_space", "convention")),
]


@quick
@given(place=st.sampled_from(PLACES), value=JSON)
def test_any_asset_json_is_an_asset_or_a_sentence(small, tmp_path, place, value):
    folder = changed(small, tmp_path / "asset", place, value)
    with contextlib.suppress(AddonError):
        read_info(folder)
        asset = read_asset(folder)
        assert isinstance(asset.prompt, str) and isinstance(asset.distribution, str)
        for picture in asset.pictures.values():
            assert picture.path.resolve().parent == folder.resolve()


@settings(quick, max_examples=25)
@given(place=st.sampled_from(PLACES), value=JSON)
def test_any_asset_json_is_imported_or_leaves_nothing(small, tmp_path, place, value):
    bpy = pytest.importorskip("bpy")
    from fantasia3d_addon.asset.import_asset import import_asset

    bpy.ops.wm.read_factory_settings(use_empty=True)
    folder = changed(small, tmp_path / "asset", place, value)
    try:
        obj = import_asset(bpy.context.scene, folder)
    except AddonError:
        assert not (bpy.data.objects or bpy.data.meshes or bpy.data.images or bpy.data.materials)
    else:
        assert len(obj.data.polygons)


def fields(panel) -> dict[str, object]:
    """What was entered: from Blender 5.0 on a group's items() have no declared property."""
    names = [p.identifier for p in panel.bl_rna.properties if not p.is_readonly]
    return {name: getattr(panel, name) for name in names if panel.is_property_set(name)}


@quick
@given(field=st.sampled_from(FIELDS), value=JSON)
def test_any_job_is_shown_in_the_panel_or_changes_nothing(addon, field, value):
    bpy = pytest.importorskip("bpy")
    from fantasia3d_addon.jobs.job_settings import apply_job

    panel = bpy.context.scene.fantasia3d
    panel.prompt = "mine"
    before = fields(panel)
    job = JOB | {field: value}
    if not job_file.has_types(job, job_file.KINDS):
        return  # the history shows no such job
    try:
        apply_job(panel, job)
    except AddonError:
        assert fields(panel) == before
