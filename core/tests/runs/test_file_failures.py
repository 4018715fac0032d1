"""Every operation on a file fails once: the older file stays whole, and a sentence gives the cause.

These are the files by themselves, each operation in turn; ``fault_runs`` walks whole runs.
"""

import errno
import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import torch

from core.errors import UserError
from core.geometry.mesh import Mesh
from core.io.asset import export, place, write_asset
from core.io.atomic import check_target, left_over, temporary
from core.io.exr import write_exr
from core.io.job import EventWriter, Job, read_events, write_text
from core.io.lock import run_lock
from core.io.maps import Maps
from core.io.png import write_png
from core.io.run_folder import RunFolder
from core.stages.preview import write_shape
from core.tests.file_operations import Operations
from core.tests.texture_shapes import smooth_material, torus, torus_uv
from core.texture.bake import bake
from fantasia3d_addon.environment import files as of_the_add_on

ERRORS = (errno.ENOSPC, errno.EACCES, errno.EROFS, errno.EIO)  # each operation meets one


@pytest.fixture(scope="module")
def parts() -> tuple[Mesh, Maps]:
    verts, faces = torus(8, 6)
    uv = torus_uv(8, 6)
    return Mesh(place(verts), faces, *uv), bake(Mesh(verts, faces, *uv), smooth_material, 64)


def contents(folder: Path) -> dict[str, bytes]:
    paths = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def walk(folder: Path, work: Callable[[], object], lasting: str = "-") -> list[str]:
    """Do ``work`` once in peace and once for each of its operations, which then fails.

    Whether it ends with a sentence or in spite of the error: the files are then those before it or
    those after it, and nothing is next to them but what begins with ``lasting``. And doing it
    again ends as the first time. The operations.
    """
    before = contents(folder)
    with Operations(folder).watched() as operations:
        work()
    after = contents(folder)
    for i, name in enumerate(operations.log):
        number = ERRORS[i % len(ERRORS)]
        _set(folder, before)
        done = _failed(folder, i, number, work)
        found, wanted = contents(folder), after if done else before
        differ = [x for x in {*found, *wanted} if found.get(x) != wanted.get(x)]
        assert all(x.startswith(lasting) for x in differ), (name, errno.errorcode[number], differ)
        work()
        assert contents(folder) == after, (name, errno.errorcode[number], "again")
    return operations.log


def _failed(folder: Path, i: int, number: int, work: Callable[[], object]) -> bool:
    """Whether ``work`` came to its end although its operation ``i`` failed."""
    try:
        with Operations(folder, i, number).watched():
            work()
    except UserError as error:
        output = error
    else:
        return True
    assert output.status == 2 and output.text.endswith(".") and output.fix.endswith(".")
    return False


def _set(folder: Path, wanted: dict[str, bytes]) -> None:
    for path in folder.rglob("*"):
        if path.is_file() and path.relative_to(folder).as_posix() not in wanted:
            path.unlink()
    for name, content in wanted.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)


def test_a_newer_asset_over_an_older_one(parts, tmp_path: Path) -> None:
    """The four pictures, the mesh, its material, the GLB, asset.json, and the two renames."""
    (tmp_path / "precious.txt").write_text("of the user")
    picture = torch.zeros(8, 8, 3)
    write_asset(tmp_path / "asset", *parts, {"seed": 1}, picture)
    newer = {"seed": 2}
    # Where the older one cannot be removed, the next asset does it.
    done = walk(
        tmp_path, lambda: write_asset(tmp_path / "asset", *parts, newer, picture), ".fantasia3d-"
    )
    assert [x.name for x in tmp_path.iterdir() if x.name.startswith(".")] == []
    assert len(done) > 50 and {"rename asset", "rename asset.tmp", "fsync mesh.obj"} <= {*done}


def test_a_first_asset(parts, tmp_path: Path) -> None:
    assert len(walk(tmp_path, lambda: write_asset(tmp_path / "asset", *parts, {}))) >= 35


@pytest.mark.parametrize("format", ["obj", "glb"])
def test_an_export_over_an_older_one(parts, tmp_path: Path, format: str) -> None:
    """Each file of it is the older or the newer one, never half of one."""
    asset = write_asset(tmp_path / "asset", *parts, {})
    out = tmp_path / "out" / f"chair.{format}"
    out.parent.mkdir()
    export(asset, format, out)
    done = walk(out.parent, lambda: export(asset, format, out), out.stem)
    assert len(done) >= 2


def test_pictures_over_older_ones(tmp_path: Path) -> None:
    black, white = np.zeros((8, 8, 3), np.uint8), np.full((8, 8, 3), 255, np.uint8)
    write_png(tmp_path / "a.png", black)
    assert walk(tmp_path, lambda: write_png(tmp_path / "a.png", white))
    write_exr(tmp_path / "a.exr", torch.zeros(8, 8, 3))
    assert walk(tmp_path, lambda: write_exr(tmp_path / "a.exr", torch.ones(8, 8, 3)))


def test_a_job(tmp_path: Path) -> None:
    """After a failure the same command starts the run: what is left of a try is no user's file."""
    run, job, real = tmp_path / "run", Job(prompt="a red torus"), os.unlink  # not a counted one

    def create() -> None:
        if (run / "job.json").exists():  # a run that began would be resumed
            real(run / "job.json")
        RunFolder.create(run, job)

    assert "listdir run" in walk(tmp_path, create)


def test_a_checkpoint_over_an_older_one(tmp_path: Path) -> None:
    run = RunFolder.create(tmp_path / "run", Job(prompt="a red torus"))
    run.save("geometry", {"x": torch.zeros(4)}, {"step": 1})
    done = walk(run.path, lambda: run.save("geometry", {"x": torch.ones(4)}, {"step": 2}))
    assert "fsync geometry.safetensors.tmp" in done


def test_a_preview_over_an_older_one(parts, tmp_path: Path) -> None:
    run = RunFolder.create(tmp_path / "run", Job(prompt="a red torus"))
    verts, faces = parts[0].verts, parts[0].faces
    write_shape(run.preview_path("shape.npz"), verts, faces)
    done = walk(run.path, lambda: write_shape(run.preview_path("shape.npz"), verts * 2, faces))
    assert "write shape.npz.tmp" in done


def test_an_event_is_written_whole_or_not_at_all(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("time.time", lambda: 1.0)
    EventWriter(tmp_path).write("started", pid=1)
    first = (tmp_path / "events.jsonl").read_bytes()
    for i, number in enumerate((errno.EACCES, errno.ENOSPC)):
        with Operations(tmp_path, i, number).watched(), pytest.raises(OSError, match="events"):
            EventWriter(tmp_path).write("progress", stage="fit", step=1)
        assert (tmp_path / "events.jsonl").read_bytes() == first
    EventWriter(tmp_path).write("cancelled")
    assert [event["type"] for event in read_events(tmp_path)] == ["started", "cancelled"]


def test_half_a_line_of_a_killed_process_does_not_spoil_the_next_one(tmp_path: Path) -> None:
    EventWriter(tmp_path).write("started", pid=1)
    with (tmp_path / "events.jsonl").open("ab") as file:
        file.write(b'{"type": "progr')
    EventWriter(tmp_path).write("started", pid=2)
    assert [event["pid"] for event in read_events(tmp_path)] == [1, 2]


def test_the_lock(tmp_path: Path) -> None:
    def work() -> None:
        with run_lock(tmp_path):
            pass

    assert "write lock" in walk(tmp_path, work, "lock")


def test_half_a_job_is_no_file_of_the_users_and_anything_else_is(tmp_path: Path) -> None:
    job = Job(prompt="a red torus")
    for half in ("", job.to_json()[:7], job.to_json()[:40]):
        folder = tmp_path / f"{len(half)}"
        folder.mkdir()
        temporary(folder / "job.json").write_text(half)
        run = RunFolder.create(folder, job)
        run.remove_half_written()
        assert [p.name for p in run.path.iterdir()] == ["job.json"]
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "job.json.tmp").write_text("mine")
    with pytest.raises(UserError, match=r"not empty: it holds job\.json\.tmp"):
        RunFolder.create(mine, job)


def test_what_a_kill_left_half_written_goes_with_the_next_session(tmp_path: Path) -> None:
    run = RunFolder.create(tmp_path / "run", Job(prompt="a red torus"))
    run.save("geometry", {"x": torch.zeros(4)}, {})
    (run.path / "preview" / "film").mkdir(parents=True)
    for name in ("checkpoint/mesh.safetensors", "preview/color.png", "preview/film/1.png"):
        temporary(run.path / name).touch()
    mine = {"checkpoint/mesh.safetensors.tmp", "preview/mine.txt", "preview/.fantasia3d-a.tmp"}
    for name in mine:
        (run.path / name).touch()
    run.remove_half_written()
    assert set(contents(run.path)) == {"job.json", "checkpoint/geometry.safetensors", *mine}


@pytest.mark.parametrize("fails", [False, True])
@pytest.mark.parametrize("write", [write_text, of_the_add_on.write_text])
def test_a_file_of_the_users_next_to_an_output_stays(tmp_path: Path, write, fails: bool) -> None:
    """NAME.tmp and NAME.old may be theirs, whether the output is written or not."""
    out = tmp_path / "chair.json"
    mine = {f"chair.json{end}": b"precious" for end in (".tmp", ".old", "~", ".part")}
    for name, content in mine.items():
        (tmp_path / name).write_bytes(content)
    if fails:
        out.mkdir()
        with pytest.raises((OSError, UserError)):
            write(out, "text")
    else:
        write(out, "text")
    assert contents(tmp_path) == mine | ({} if fails else {"chair.json": b"text"})


@pytest.mark.parametrize("length", [1, 40, 200, 255])
def test_any_name_that_the_system_takes_can_be_written(tmp_path: Path, length: int) -> None:
    for letter in ("a", "é" if length % 2 == 0 else "a"):
        out = tmp_path / (letter * (length // len(letter.encode())))
        check_target(out)
        write_text(out, "text")
        of_the_add_on.write_text(out, "text")
        assert contents(tmp_path) == {out.name: b"text"}
        out.unlink()


def test_both_sides_name_their_temporary_files_the_same_way(tmp_path: Path, monkeypatch) -> None:
    """The core removes what a killed Blender left of a job.json."""
    seen: list[str] = []
    monkeypatch.setattr(Path, "replace", lambda self, to: seen.append(self.name))
    of_the_add_on.write_text(tmp_path / "job.json", "{}")
    assert [x.name for x in left_over(tmp_path, of="job.json")] == seen
