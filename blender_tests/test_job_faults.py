"""A job's files fail in Blender, or its folder goes: a sentence, and the next job runs."""

import errno
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from core.tests.file_operations import Operations  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.jobs import process, submit  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_each_operation_of_a_request_fails_once(ready, tmp_path, monkeypatch):
    """job.json, target.json, the follower's lock, the log: a sentence, and no folder is left."""
    monkeypatch.setattr(process, "_spawn", lambda *_: subprocess.Popen(["true"]))
    runs = tmp_path / "runs"

    def request(fails: int | None, number: int = 0) -> list[str]:
        with Operations(tmp_path, fails, number).watched() as operations:
            submit.generate(bpy.context)
        return operations.log

    def forget() -> None:
        for followed in session.running:
            followed.run._process.wait()
        session.close()

    done = request(None)
    assert {"open job.json.tmp", "open target.json.tmp", "open follower", "open log.txt"} <= {*done}
    for i, name in enumerate(done):
        forget()
        shutil.rmtree(runs, ignore_errors=True)
        try:
            request(i, (errno.ENOSPC, errno.EACCES)[i % 2])
        except AddonError as error:
            sentences = error.text, error.fix
            assert all(text.endswith(".") for text in sentences), name
            left = [path.name for path in runs.iterdir()] if runs.exists() else []
            assert (left, session.running, session.waiting) == ([], [], []), name
        else:
            assert session.running, name
    forget()


@pytest.mark.parametrize("then", ["nothing", "a file"])
def test_a_run_folder_that_goes_meanwhile_is_reported(ready, wait, tmp_path, then):
    ready.prompt = "long"
    folder = submit.generate(bpy.context)
    wait(until=lambda: session.running[0].progress.fraction > 0)
    folder.rename(tmp_path / "elsewhere")
    if then == "a file":
        folder.write_text("of the user")
    session.cancel()
    assert "can't be written" in session.error[0]
    assert session.running[0].progress.cancelling  # it can be ended by force
    wait()
    assert session.error[0] == f"The run's folder {folder} no longer exists."
    assert then == "nothing" or folder.read_text() == "of the user"
    ready.prompt = "another"
    bpy.ops.fantasia3d.generate()
    wait()
    assert session.error is None and len(bpy.data.objects) == 1


def test_a_cancel_that_cannot_be_written_is_a_job_error(tmp_path):
    with pytest.raises(AddonError, match="can't be written"):
        process.Run(Path(tmp_path / "gone")).cancel()
