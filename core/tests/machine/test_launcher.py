"""run.py: what it reads, refuses, hands over and passes through."""

import ast
import json
import os
import shutil
import signal
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import run
from core.errors import Cancelled, NoSurfaceError, UserError
from fantasia3d_addon.cli import parser
from run import environment

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the stand-ins are shell programs")

ROOT = Path(run.__file__).parent


# The command line


@pytest.mark.parametrize(
    ("line", "blender"),
    [
        (["generate", "a chair"], False),
        (
            ["generate", "a chair", "--blend", "c d.blend", "--seed", "3", "--render=ü.png"],
            "import",
        ),
        (["resume", "out/r", "--render", "r.png"], "import"),
        (["export", "a", "--format", "glb", "--out", "f.glb"], False),
        (["export", "a", "--format", "fbx", "--out", "f.fbx"], "alone"),
        (["export", "a", "--format", "glb", "--out", "f.glb", "--material", "gold"], "alone"),
        (["export", "--format=blend", "a/asset", "--out", "f.blend"], "alone"),
        (["relight", "a", "--render", "f.png"], "alone"),
        (["render", "a", "--out", "f.png"], False),
        (["words", "a chair"], False),
    ],
)
def test_each_command_goes_to_the_core_or_to_blender(line, blender):
    args = run.parse(line)
    assert parser.imports_asset(args) == (blender == "import")
    assert parser.runs_in_blender(args) == (blender == "alone")


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        (["generat", "a chair"], "no command 'generat'. Did you mean generate?"),
        (["generate", "a chair", "--blend"], "--blend: expected one argument"),
        (["generate", "a chair", "--blend", "--seed", "3"], "--blend: expected one argument"),
        (["relight", "X", "--ligt", "a"], "Did you mean --light?"),
        (["physics", "X", "--physics", "magic"], "invalid choice: 'magic'"),
        (["physics", "X"], "--physics"),
        (
            ["physics", "X", "--physics", "soft", "--softness", "5"],
            "'5' is not allowed; use 0 to 1",
        ),
        (["generate", "x", "--blend", "a.blend", "--blend", "b.blend"], "twice"),
        (["generate", "x", "--blend", "a.obj"], "ends in .blend"),
        (["generate", "x", "--render", "picture"], "ends in .png"),
        (["texture", "m.obj", "x", "--render", f"{__file__}/x.png"], "cannot be written"),
        (["export", "--format", "blend", "--out", "x.blend"], "required: asset"),
        (["export", "asset", "--format", "blend"], "required: --out"),
        (["export", "asset", "--format", "blend", "--out", "x.obj"], "ends in .blend"),
        (["setup", "everything"], "setup has no 'everything'"),
        (["doctor", "now"], "doctor has no option 'now'"),
        (["package", "--out", __file__], "is not a folder"),
    ],
)
def test_wrong_input_is_one_sentence_and_exit_code_2(box, capsys, line, sentence):
    assert run.main(line) == 2
    output = capsys.readouterr().err
    assert sentence in output
    assert output.startswith("error: ")
    assert output.count("\n") == 1
    assert not box.log, "nothing is set up for a wrong command"


def test_help_needs_no_environment(box, capsys):
    assert run.main(["--help"]) == 0
    assert run.main([]) == 2
    assert "python3 run.py COMMAND" in capsys.readouterr().out
    assert not box.log


def test_help_names_every_command(capsys):
    run.main(["--help"])
    output = capsys.readouterr().out
    names = (*run.parser().names, *run.PASS_ON)
    assert [name for name in names if f"\n    {name} " not in output] == []


def test_the_help_of_a_command_needs_no_environment(box, capsys):
    with pytest.raises(SystemExit) as ended:
        run.main(["generate", "--help"])
    assert ended.value.code == 0
    output = capsys.readouterr().out
    assert "--seed" in output  # the core's
    assert "--blend" in output  # Blender's
    assert not box.log


@pytest.mark.parametrize(
    "path", [ROOT / "run.py", *(ROOT / "fantasia3d_addon" / "environment").glob("*.py")]
)
def test_an_old_python_gets_far_enough_to_say_what_it_needs(path):
    ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 8))


# Handing over


@pytest.mark.parametrize("line", [["generate", "a chair"], ["resume", "RUN"]])
def test_blender_takes_the_asset_that_the_core_made(tmp_path, monkeypatch, line):
    asset = tmp_path / "a chair, ü" / "asset"
    became = []
    monkeypatch.setattr("core.command_line.carry_out", lambda args: asset)
    monkeypatch.setattr(run, "hand_over", lambda command: became.append(command) or 0)
    assert run.main(["--inside", *line, "--blend", "c.blend"]) == 0
    assert became[0][2] == "--finish"
    assert json.loads(became[0][3]) == {"asset": str(asset), "blend": "c.blend"}
    assert run.main(["--core", *line, "--blend", "c.blend"]) == 0
    assert len(became) == 1, "the core alone"


@pytest.mark.parametrize("error", [UserError, NoSurfaceError, Cancelled])
def test_a_failed_job_ends_before_blender_with_its_exit_code(monkeypatch, capsys, error):
    def fail(args):
        raise error("It failed.")

    monkeypatch.setattr("core.command_line.carry_out", fail)
    monkeypatch.setattr(run, "hand_over", lambda _: pytest.fail("Blender was started"))
    assert run.main(["--inside", "generate", "a chair", "--render", "c.png"]) == error.status
    assert "It failed." in capsys.readouterr().err


@pytest.mark.parametrize(("prompt", "code"), [("a red chair", 0), ("a blorb", 2)])
def test_words_are_reported_as_json(capsys, prompt, code):
    assert run.main(["--inside", "words", prompt]) == code
    report = json.loads(capsys.readouterr().out)
    assert report["prompt"] == prompt
    assert report.get("thing") == ("chair" if code == 0 else None)


def launcher(
    *arguments: str, tree: Path = ROOT, cwd: Path | None = None, **environ: str
) -> subprocess.Popen[str]:
    """run.py as a process of its own, under this interpreter as the environment's."""
    return subprocess.Popen(
        [sys.executable, str(tree / "run.py"), *arguments],
        env={**os.environ, "PYTHONPATH": "", "FANTASIA3D_PYTHON": sys.executable, **environ},
        cwd=cwd,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_the_exit_code_passes_through():
    child = launcher("python", "-c", "import sys; sys.exit(7)")
    child.communicate()
    assert child.returncode == 7


def test_a_sentence_of_the_cores_passes_through_with_its_exit_code():
    child = launcher("inspect", "--siez", "3", "x")
    out, err = child.communicate()
    assert child.returncode == 2, err
    assert out == ""
    assert "--siez" in err
    assert "Traceback" not in err


def test_ctrl_c_reaches_the_work_and_ends_it():
    child = launcher("python", "-c", "import time; print('x', flush=True); time.sleep(60)")
    assert child.stdout
    child.stdout.readline()
    child.send_signal(signal.SIGINT)
    child.communicate(timeout=10)
    assert child.returncode in (130, -signal.SIGINT)


@pytest.mark.parametrize("code", ["sys.exit(7)", "os.kill(os.getpid(), 9)"])
def test_where_a_process_cannot_become_another_it_waits_and_returns_the_exit_code(code):
    script = (
        "import sys, types, signal; sys.modules['bpy'] = types.ModuleType('bpy')\n"
        "import run; status = run.hand_over([sys.executable, '-c', sys.argv[1]])\n"
        "print(status, signal.getsignal(signal.SIGINT) is signal.SIG_IGN)"
    )
    program = "import os, signal, sys; print(signal.getsignal(signal.SIGINT), flush=True); " + code
    done = subprocess.run(
        [sys.executable, "-c", script, program],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    theirs, ours = done.stdout.splitlines()
    assert "default_int_handler" in theirs, "the child can be interrupted"
    assert ours == f"{7 if 'exit' in code else 128 + 9} True"


def test_another_pythons_variables_do_not_reach_the_environment():
    code = "import os; print(os.environ.get('PYTHONHOME'), os.environ.get('PYTHONPATH'))"
    child = launcher("python", "-c", code, PYTHONPATH="/nonsense")
    assert child.communicate()[0].split() == ["None", "None"]


def test_doctor_states_what_is_missing_and_how_to_fix_it(tmp_path):
    child = launcher("doctor", FANTASIA3D_PYTHON="", FANTASIA3D_ENV=str(tmp_path / "none"))
    out, err = child.communicate()
    assert child.returncode == 3
    assert err == ""
    assert "run.py setup" in next(line for line in out.splitlines() if line.startswith("environ"))
    assert "environment" in out.splitlines()[-1]


def test_doctor_names_a_package_that_is_not_as_pinned(box, monkeypatch):
    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    box.pin("torch==0.1", "pytest==" + pytest.__version__)
    lines = {line.name: line for line in environment.examine(box.root)}
    assert lines["packages"].state == "MISSING"
    assert "torch 2" in lines["packages"].text
    assert "pytest" not in lines["packages"].text


# Code in the current folder

# Standard modules that the set-up, pip, venv and torch import early, and the core's own names.
TRAPS = ("random", "venv", "pip", "json", "ensurepip", "torch", "bpy", "core", "fantasia3d_addon")


def set_traps(folder: Path) -> Path:
    """Modules there leave a mark when they are run; its path."""
    (folder / "trapped").mkdir()
    mark = folder / "mark"
    for name in TRAPS:
        text = f"import os\nopen({str(mark)!r}, 'a').write({name!r} + ' ')\n"
        (folder / "trapped" / f"{name}.py").write_text(text)
    return mark


@pytest.fixture
def trapped(tmp_path, monkeypatch):
    """The mark of such a current folder."""
    mark = set_traps(tmp_path)
    monkeypatch.chdir(tmp_path / "trapped")
    return mark


def test_doctor_runs_no_code_of_the_current_folder(trapped):
    child = launcher("doctor")
    out, err = child.communicate()
    assert "Python 3.11" in out, err
    assert not trapped.exists(), f"run: {trapped.read_text()}"


def write_wheel(folder: Path, name: str, version: str) -> Path:
    """A wheel with a module of one line."""
    folder.mkdir(exist_ok=True)
    path = folder / f"{name}-{version}-py3-none-any.whl"
    info = f"{name}-{version}.dist-info"
    with zipfile.ZipFile(path, "w") as wheel:
        wheel.writestr(f"{name}.py", "HERE = True\n")
        wheel.writestr(
            f"{info}/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n"
        )
        wheel.writestr(
            f"{info}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
        )
        wheel.writestr(f"{info}/RECORD", "")
    return path


@pytest.fixture(scope="module")
def refused(tmp_path_factory):
    """A set-up by the real venv and the real pip, in a trapped folder; its folder, and its end.

    The user's wheel folder has their own build of torch, which the lock file does not name.
    """
    folder = tmp_path_factory.mktemp("refused")
    write_wheel(folder / "wheels", "torch", "2.13.0+mine")
    tree = folder / "tree"
    tree.mkdir()
    shutil.copy(ROOT / "run.py", tree)
    for name in ("core", "fantasia3d_addon"):
        (tree / name).symlink_to(ROOT / name)
    (tree / "pyproject.toml").write_text("[project]\ndependencies = ['torch==2.13.0']\n")
    (tree / "requirements.lock").write_text(f"# [core]\ntorch==2.13.0 --hash=sha256:{'0' * 64}\n")
    set_traps(folder)
    clean = {"PIP_FIND_LINKS": "", "PIP_CONFIG_FILE": os.devnull, "FANTASIA3D_ENV": ""}
    child = launcher(
        "setup", tree=tree, cwd=folder / "trapped", FANTASIA3D_PYTHON="", **clean,
        FANTASIA3D_WHEELS=str(folder / "wheels"), XDG_DATA_HOME=str(folder / "data"),
    )  # fmt: skip
    out, err = child.communicate()
    return folder, child.returncode, out, err


def test_a_set_up_runs_no_code_of_the_current_folder(refused):
    folder, status, out, err = refused
    assert status == 3 and "torch" in err, err + out
    mark = folder / "mark"
    assert not mark.exists(), f"run: {mark.read_text()}"


def test_a_wheel_of_the_users_that_is_not_the_locked_one_is_refused_in_one_sentence(refused):
    folder, status, out, err = refused
    assert status == 3, err + out
    (error,) = [line for line in err.splitlines() if "error" in line]
    assert "torch-2.13.0+mine-py3-none-any.whl is not the file that the lock file names" in error
    assert "FANTASIA3D_PYTHON" in error
    made = [path.suffix for path in (folder / "data" / "fantasia3d").iterdir()]
    assert sorted(made) == [".lock", ".log"], "no environment"


def test_the_builder_is_found_by_no_code_of_the_current_folder(trapped):
    pytest.importorskip("importlib.metadata").distribution("bpy")
    environment.find_builder(Path(sys.executable))
    assert not trapped.exists(), f"run: {trapped.read_text()}"


@pytest.mark.skipif(sys.platform != "linux", reason="a place where nobody may make a folder")
def test_a_package_that_cannot_be_put_down_is_a_sentence(monkeypatch, capsys):
    monkeypatch.setattr(run.environment, "ensure", lambda *_, **__: Path(sys.executable))
    monkeypatch.setattr(run.environment, "find_builder", lambda _: ["builder"])
    monkeypatch.setattr(run, "fill_package", lambda _: None)
    monkeypatch.setattr(
        run, "use_builder", lambda _, folder: (Path(folder) / "a.zip").write_bytes(b"")
    )
    assert run.main(["package", "--out", "/proc/nowhere"]) == 2
    assert "/proc/nowhere cannot be written" in capsys.readouterr().err


def test_a_package_goes_into_no_file(tmp_path, capsys):
    (tmp_path / "file").touch()
    assert run.main(["package", "--out", str(tmp_path / "file")]) == 2
    assert "which is not a folder" in capsys.readouterr().err


@pytest.mark.parametrize("line", [["inspect", "x"], ["generate", "a chair"], ["doctor"]])
def test_a_program_that_is_no_python_is_a_sentence_and_status_3(line):
    child = launcher(*line, FANTASIA3D_PYTHON="/bin/true")
    out, err = child.communicate()
    assert child.returncode == 3, err
    assert "/bin/true" in out + err
    assert "Traceback" not in err
