"""Jobs on a Ray cluster: the same panel, preview, cancel and asset as on this machine."""

import sys
import time
from types import SimpleNamespace

import bpy
import pytest

from blender_tests.conftest import FAKE_CORE
from core.batch.attempt import ROOT
from core.tests.ray_jobs_server import Cluster
from fantasia3d_addon import environment
from fantasia3d_addon.errors import JobError
from fantasia3d_addon.jobs import history, paths, submit
from fantasia3d_addon.jobs.session import session

SECRET = "s3cret-of-the-cluster"


@pytest.fixture
def preferences(ready, monkeypatch):
    """The preferences choose a cluster; Blender allows the network."""
    given = SimpleNamespace(jobs_place="RAY", ray_address="", ray_token=SECRET)
    monkeypatch.setattr(
        paths.Paths, "__init__", lambda self, _context: setattr(self, "_preferences", given)
    )
    monkeypatch.setattr(environment, "project_root", lambda: ROOT)  # the relay is the real core's
    system = bpy.context.preferences.system
    before, system.use_online_access = system.use_online_access, True
    yield given
    system.use_online_access = before


@pytest.fixture
def cluster(preferences, tmp_path):
    (tmp_path / "cluster").mkdir()
    fake = (str(FAKE_CORE / "core" / "__main__.py"), "resume")
    made = Cluster(tmp_path / "cluster", SECRET, command=fake)
    preferences.ray_address = made.url
    yield made
    made.close()


def test_an_asset_is_made_on_the_cluster_and_comes_into_the_scene(cluster, wait, tmp_path):
    bpy.context.scene.fantasia3d.prompt = "brief"
    folder = submit.generate(bpy.context)
    (followed,) = session.running
    seen = set()
    wait(lambda: bool(seen.add(followed.progress.fraction)))
    assert session.error is None, (session.error, (folder / "log.txt").read_text())
    assert len(cluster.jobs) == 1
    assert session.asset in bpy.data.objects
    assert len(seen) > 1  # it was followed while it ran
    assert history.read_entry(folder).state == history.DONE
    written = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert not [path for path in written if SECRET.encode() in path.read_bytes()]


def test_the_token_is_in_no_command_line(cluster):
    core = paths.Paths(bpy.context).job_core
    assert core.options == ("--ray-jobs", cluster.url)
    assert core.environ["RAY_AUTH_TOKEN"] == SECRET
    assert "RAY_AUTH_TOKEN" not in paths.Paths(bpy.context).core.environ  # of words and models


def test_cancel_reaches_the_cluster(cluster, wait):
    bpy.context.scene.fantasia3d.prompt = "show"
    folder = submit.generate(bpy.context)
    wait(lambda: bool(cluster.jobs) and (folder / "preview" / "shape.npz").exists())
    session.cancel()
    wait()
    assert history.read_entry(folder).state == history.CANCELLED
    deadline = time.monotonic() + 20
    while any(job.poll() is None for job in cluster.jobs.values()):
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_a_wrong_token_is_a_sentence_in_the_panel(cluster, preferences, wait):
    preferences.ray_token = "wrong"
    submit.generate(bpy.context)
    wait()
    assert session.error and "does not accept this token" in session.error[0]
    assert not cluster.jobs


@pytest.mark.parametrize("address", ["", "192.0.2.1:8265", "http://me:secret@host", "http://h?t=1"])
def test_a_wrong_address_is_refused_at_once(address, preferences):
    preferences.ray_address = address
    with pytest.raises(JobError, match="address of the Ray cluster is not valid") as caught:
        submit.generate(bpy.context)
    assert "secret" not in str(caught.value)


def test_blenders_own_switch_forbids_it(cluster):
    bpy.context.preferences.system.use_online_access = False
    with pytest.raises(JobError, match="online access is off"):
        submit.generate(bpy.context)


def test_this_machine_is_the_default(preferences):
    preferences.jobs_place = "LOCAL"
    assert paths.Paths(bpy.context).job_core.options == ()
    assert sys.executable == str(paths.Paths(bpy.context).job_core.python)
