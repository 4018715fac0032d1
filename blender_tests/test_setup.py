"""The set-up by its buttons, with a simulated Python and registry."""

import json
import os
import sys
import time
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon import environment  # noqa: E402
from fantasia3d_addon.jobs import environment_setup, paths  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty", "addon"),
    pytest.mark.skipif(os.name != "posix", reason="the fake is a shell program"),
]
# A Python that answers the probe, copies itself as an "environment", and simulates pip.
PLAYED = """#!{python} -S
import os, shutil, sys, time
args = sys.argv[1:]
with open({calls!r}, "a", encoding="utf-8") as file:
    print(*args, file=file)
isolated = args[:3] == ["-I", "-X", "utf8"]
if isolated:
    del args[:3]
if args[:2] == ["-m", "venv"]:
    os.makedirs(args[2] + "/bin", exist_ok=True)
    shutil.copy(sys.argv[0], args[2] + "/bin/python")
elif isolated and args[0] == "-c":
    print({probe!r} if "version_info" in args[1] else "loads")
elif args[0] == "-c":
    print({facts!r})
elif "--version" in args:
    print("pip 26.3 from somewhere")
elif "--report" in args:
    with open(args[args.index("--report") + 1], "w") as file:
        file.write({report!r})
elif "install" in args:
    print("Installing collected packages: torch", flush=True)
    time.sleep(float(os.environ.get("PLAYED_SECONDS", 0)))
"""
REPORT = {"install": [{"metadata": {"version": "2.13.0", "requires_dist": []}}]}


class Box:
    """A machine of its own: a tree of the project, a Python, and folders with difficult names."""

    def __init__(self, folder: Path, patch: pytest.MonkeyPatch) -> None:
        self.folder = folder / "ein Ordner ü 文"
        self.calls = self.folder / "calls"
        self.python = self.folder / "python 3.11"
        self.root = self.folder / "tree"
        (self.root / "core").mkdir(parents=True)
        (self.root / "pyproject.toml").write_text(
            "[project]\ndependencies = ['torch==2.13.0']\n"
            "[project.optional-dependencies]\nsetup = ['uv==1', 'pip==26']\n"
        )
        (self.root / "requirements.lock").write_text("# [core]\ntorch==2.13.0 --hash=sha256:00\n")
        text = PLAYED.format(
            python=sys.executable,
            calls=str(self.calls),
            probe=f"3.11|True|True|{self.python}",
            report=json.dumps(REPORT),
            facts=json.dumps({"python": "3.11.9", "wrong": [], "torch": "2.13.0"}),
        )
        self.python.write_text(text, encoding="utf-8")
        self.python.chmod(0o755)
        self.wheels = self.folder / "wheels"
        self.env = self.folder / ("an environment whose name is long " * 4).strip()
        place = environment.Place(self.env, self.python, self.wheels)
        patch.setattr(paths.Paths, "root", self.root)
        patch.setattr(paths.Paths, "environment", self.env)
        patch.setattr(paths.Paths, "place", place)
        machine = sys.modules[environment.find_python.__module__]
        patch.setattr(machine, "has_nvidia", lambda: False)
        patch.setattr(machine, "python_candidates", lambda: iter([str(self.python)]))
        for name in ("FANTASIA3D_PYTHON", "FANTASIA3D_ENV", "FANTASIA3D_WHEELS"):
            patch.delenv(name, raising=False)

    @property
    def installs(self) -> list[str]:
        lines = self.calls.read_text(encoding="utf-8").splitlines() if self.calls.exists() else []
        return [line for line in lines if " install " in line and "--report" not in line]


@pytest.fixture
def box(tmp_path, monkeypatch):
    box = Box(tmp_path, monkeypatch)
    box.wheels.mkdir()
    return box


def done() -> object:
    task = session.task
    task.join(60)
    assert not task.running
    session.tick()
    return task


def test_set_up_repair_and_remove(box):
    assert bpy.ops.fantasia3d.set_up() == {"FINISHED"}
    task = done()
    assert task.error is None
    assert task.result == environment.env_python(box.env)
    assert (task.fraction, task.text) == (1.0, f"Ready: {task.result}")
    assert f"--no-index --find-links {box.wheels}" in box.installs[0]
    assert bpy.ops.fantasia3d.open_set_up_log.poll()
    bpy.ops.fantasia3d.set_up()
    done()
    assert len(box.installs) == 1, "what is there is not made again"
    (box.env / "broken").touch()
    assert bpy.ops.fantasia3d.repair() == {"FINISHED"}
    assert done().error is None
    assert not (box.env / "broken").exists()
    assert len(box.installs) == 2
    assert bpy.ops.fantasia3d.remove_environment("EXEC_DEFAULT") == {"FINISHED"}
    assert done().error is None
    assert list(box.folder.glob("an environment*")) == []  # neither its log nor its lock
    assert not bpy.ops.fantasia3d.remove_environment.poll()


def test_a_set_up_is_cancelled_and_leaves_nothing(box, monkeypatch):
    monkeypatch.setenv("PLAYED_SECONDS", "60")
    bpy.ops.fantasia3d.set_up()
    deadline = time.monotonic() + 30
    while not box.installs:
        assert time.monotonic() < deadline
        time.sleep(0.05)
    assert session.tick() is not None  # the bar moves
    assert not bpy.ops.fantasia3d.set_up.poll()
    assert not bpy.ops.fantasia3d.check.poll()
    begin = time.monotonic()
    assert bpy.ops.fantasia3d.cancel_set_up() == {"FINISHED"}
    assert done().error[0] == "The set-up was cancelled."
    assert time.monotonic() - begin < 10
    assert not box.env.exists()


def test_a_folder_with_the_users_files_is_left_alone(box):
    box.env.mkdir()
    (box.env / "thesis.txt").write_text("years")
    for press in (bpy.ops.fantasia3d.set_up, bpy.ops.fantasia3d.remove_environment):
        press("EXEC_DEFAULT")
        assert "not this project's" in done().error[0]
    assert [path.name for path in box.env.iterdir()] == ["thesis.txt"]


def test_files_of_the_users_next_to_the_folder_are_left_alone(box):
    log, lock = box.env.with_name(box.env.name + ".log"), box.env.with_name(box.env.name + ".lock")
    log.write_text("my own log")
    bpy.ops.fantasia3d.set_up()
    assert "is not a log of this project" in done().error[0]
    assert log.read_text() == "my own log"
    assert not box.env.exists()
    log.unlink()
    lock.write_text("my own pins")
    bpy.ops.fantasia3d.set_up()
    assert done().error is None
    log.write_text("my own log")
    bpy.ops.fantasia3d.remove_environment("EXEC_DEFAULT")
    assert done().error is None
    assert not box.env.exists()
    assert (log.read_text(), lock.read_text()) == ("my own log", "my own pins")


def test_a_refused_set_up_keeps_the_log_of_the_last_one(box):
    box.env.mkdir()
    (box.env / "thesis.txt").write_text("years")
    log = box.env.with_name(box.env.name + ".log")
    log.write_text("$ pip install torch")
    bpy.ops.fantasia3d.set_up()
    assert "not this project's" in done().error[0]
    assert log.read_text() == "$ pip install torch"


def test_a_file_that_is_no_python_is_an_error(box, monkeypatch):
    place = environment.Place(box.env, box.folder / "nothing", box.wheels)
    monkeypatch.setattr(paths.Paths, "place", place)
    bpy.ops.fantasia3d.set_up()
    assert done().error[0].endswith("nothing is not a 64-bit Python 3.11, 3.12 or 3.13.")


def test_network_access_is_required_unless_there_are_wheels(box, monkeypatch):
    assert environment_setup.reason_against() == ""
    box.wheels.rmdir()
    assert "does not exist" in environment_setup.reason_against()
    place = environment.Place(box.env, box.python)
    monkeypatch.setattr(paths.Paths, "place", place)
    online = bpy.app.online_access
    assert environment_setup.reason_against() == (
        "" if online else "The installation needs online access, or a folder of wheels."
    )


def test_check_lists_what_is_missing_and_its_fix(box):
    assert bpy.ops.fantasia3d.check() == {"FINISHED"}
    task = done()
    assert task.text.startswith("Missing: environment")
    found = {line.name: line for line in task.result}
    assert str(box.env) in found["environment"].text
    assert 'press "Install"' in found["environment"].text


def test_check_looks_at_the_python_that_was_chosen(box, monkeypatch):
    monkeypatch.setattr(paths.Paths, "own_python", box.python)
    bpy.ops.fantasia3d.check()
    task = done()
    found = {line.name: line.text for line in task.result}
    assert found["environment"] == str(box.python)
    assert (found["torch"], found["packages"]) == ("2.13.0", "as pinned, under Python 3.11.9")


def test_a_path_that_is_too_long_for_windows_is_an_error(monkeypatch):
    machine = sys.modules[environment.find_python.__module__]
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(machine, "_long_paths", lambda: False)
    machine.check_length(Path("C:/f3d"))
    with pytest.raises(environment.SetupError, match="Windows takes 69 here"):
        machine.check_length(Path("C:/" + 80 * "x"))
    monkeypatch.setattr(machine, "_long_paths", lambda: True)
    machine.check_length(Path("C:/" + 80 * "x"))
