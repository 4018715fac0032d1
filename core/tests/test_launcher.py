"""run.py and the environment it makes, with stand-ins for Python and pip: no network, no torch."""

import ast
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

import run
from run import environment

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the stand-ins are shell programs")

ROOT = Path(run.__file__).parent
install = sys.modules[environment.ensure.__module__]
layout = sys.modules[environment.env_folder.__module__]
machine = sys.modules[environment.find_python.__module__]
words = sys.modules[environment.ensure.__module__.replace("install", "words")]

# A Python that answers the probe, makes "environments" of itself, and plays pip. Each call is a
# line in CALLS: what it was, and its last words. FAKE_SAYS is the end of an installation that
# fails, FAKE_SECONDS is how long one takes.
FAKE = """#!{python} -S
import os, shutil, sys, time

args = sys.argv[1:]

def call(kind):
    with open({calls!r}, "a", encoding="utf-8") as file:
        print(kind, *args[-2:], file=file)

if args[:2] == ["-m", "venv"]:
    call("venv")
    os.makedirs(args[2] + "/bin", exist_ok=True)
    shutil.copy(sys.argv[0], args[2] + "/bin/python")
elif args[:2] == ["-I", "-c"]:
    print({probe!r} if "version_info" in args[2] else "loads")
elif "--version" in args:
    print("pip 26.3 from somewhere")
elif "config" in args:
    print("global.find-links='/wheels'")
elif "--report" in args:
    call("report")
    with open(args[args.index("--report") + 1], "w") as file:
        file.write(os.environ.get("FAKE_REPORT", {report!r}))
elif "--target" in args:
    call("target")
    folder = args[args.index("--target") + 1] + "/bin"
    os.makedirs(folder)
    with open(folder + "/uv", "w") as file:
        file.write("#!/bin/sh\\n" + os.environ["FAKE_UV"])
    os.chmod(folder + "/uv", 0o755)
elif "install" in args:
    call("install")
    time.sleep(float(os.environ.get("FAKE_SECONDS", 0)))
    if os.environ.get("FAKE_SAYS"):
        sys.exit(os.environ["FAKE_SAYS"])
    open(os.path.join(os.path.dirname(sys.argv[0]), "installed"), "w").close()
"""
CPU = {"install": [{"metadata": {"version": "2.13.0", "requires_dist": ["sympy>=1.13"]}}]}
CUDA = {
    "install": [
        {
            "metadata": {
                "version": "2.13.0",
                "requires_dist": ["sympy", 'nvidia-cudnn-cu13==9; platform_system == "Linux"'],
            }
        }
    ]
}
NO_NETWORK = (
    "WARNING: NewConnectionError('getaddrinfo failed')\n"
    "ERROR: No matching distribution found for torch"
)


class Machine:
    """A machine of its own for one test: a home, a Python, and the calls that were made."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.patch = folder / "ünï cödé", monkeypatch
        self.calls = self.folder / "calls"
        self.python = self.folder / "bin" / "python3.11"
        self.python.parent.mkdir(parents=True)
        self.python.write_text(self.source(f"3.11|True|True|{self.python}"), encoding="utf-8")
        self.python.chmod(0o755)
        for name in ("FANTASIA3D_ENV", "FANTASIA3D_PYTHON", "FANTASIA3D_WHEELS"):
            monkeypatch.delenv(name, raising=False)
        monkeypatch.setenv("XDG_DATA_HOME", str(self.folder / "data"))
        monkeypatch.setattr(machine, "python_candidates", lambda: iter([str(self.python)]))
        monkeypatch.setattr(machine, "has_nvidia", lambda: False)
        monkeypatch.setattr(sys, "platform", "linux")
        # It would put another program in pytest's place.
        monkeypatch.setattr(run, "hand_over", lambda *_: pytest.fail("handed over"))
        self.root = self.folder / "tree"
        (self.root / "core").mkdir(parents=True)
        self.pin("torch==2.13.0")
        self.said: list[str] = []

    def source(self, probe: str) -> str:
        return FAKE.format(
            python=sys.executable, calls=str(self.calls), probe=probe, report=json.dumps(CPU)
        )

    def pin(self, *core: str, blender: str = "bpy==4.5.15") -> None:
        """Write a pyproject.toml with these requirements."""
        text = f"[project]\ndependencies = {list(core)}\n[project.optional-dependencies]\n"
        text += f"blender = ['{blender}']\ntest = ['pytest==9']\nsetup = ['uv==1', 'pip==26']\n"
        (self.root / "pyproject.toml").write_text(text)

    @property
    def env(self) -> Path:
        return environment.env_folder(self.root)

    @property
    def log(self) -> list[str]:
        """The calls that changed something, so far."""
        return self.calls.read_text(encoding="utf-8").splitlines() if self.calls.exists() else []

    def count(self, kind: str) -> int:
        """How many calls of ``kind`` there were."""
        return sum(line.startswith(kind) for line in self.log)

    def ensure(self, *groups: str, **options: bool) -> Path:
        def hear(text: str, share: float) -> None:
            assert 0 <= share <= 1
            self.said.append(text)

        return environment.ensure(self.root, groups, hear, **options)


@pytest.fixture
def box(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Machine:
    return Machine(tmp_path, monkeypatch)


# The command line


@pytest.mark.parametrize(
    ("line", "core", "blender"),
    [
        (["generate", "a chair"], ["generate", "a chair"], {}),
        (
            ["generate", "a chair", "--blend", "c d.blend", "--seed", "3", "--render=ü.png"],
            ["generate", "a chair", "--seed", "3"],
            {"blend": "c d.blend", "render": "ü.png"},
        ),
        (["resume", "out/r", "--render", "r.png"], ["resume", "out/r"], {"render": "r.png"}),
        (["export", "a", "--format", "glb", "--out", "f"],) * 2 + ({},),
        (
            ["export", "--format=blend", "a/asset", "--out", "f.blend"],
            [],
            {"asset": "a/asset", "blend": "f.blend"},
        ),
        (["render", "a", "--out", "f.png"], ["render", "a", "--out", "f.png"], {}),
    ],
)
def test_blender_takes_its_options_and_the_core_the_rest(line, core, blender):
    assert run.split(line) == (core, blender)


@pytest.mark.parametrize(
    ("line", "say"),
    [
        (["generat", "a chair"], "no command 'generat'. Did you mean generate?"),
        (["generate", "a chair", "--blend"], "--blend has no value"),
        (["generate", "a chair", "--blend", "--seed", "3"], "--blend has no value"),
        (["generate", "x", "--blend", "a.blend", "--blend", "b.blend"], "twice"),
        (["generate", "x", "--blend", "a.obj"], "ends in .blend"),
        (["generate", "x", "--render", "picture"], "ends in .png"),
        (["texture", "m.obj", "x", "--render", f"{__file__}/x.png"], "cannot be written"),
        (["export", "--format", "blend", "--out", "x.blend"], "takes one asset"),
        (["export", "asset", "--format", "blend"], "no --out"),
        (["setup", "everything"], "setup has no 'everything'"),
        (["doctor", "now"], "doctor takes no arguments"),
    ],
)
def test_wrong_input_is_one_sentence_and_status_2(box, capsys, line, say):
    assert run.main(line) == 2
    said = capsys.readouterr().err
    assert say in said
    assert said.startswith("error: ")
    assert said.count("\n") == 1
    assert not box.log, "nothing is set up for a wrong command"


def test_help_needs_no_environment(box, capsys):
    assert run.main(["--help"]) == 0
    assert run.main([]) == 2
    assert "python3 run.py COMMAND" in capsys.readouterr().out
    assert not box.log


def test_help_names_every_command(capsys):
    run.main(["--help"])
    said = capsys.readouterr().out
    assert [name for name in (*run.CORE, *run.OWN) if f"\n    {name} " not in said] == []


@pytest.mark.parametrize(
    "path", [ROOT / "run.py", *(ROOT / "fantasia3d_addon" / "environment").glob("*.py")]
)
def test_an_old_python_gets_far_enough_to_say_what_it_needs(path):
    ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 8))


# The folder


def test_the_folder_is_named_by_the_requirements_whatever_their_order(box):
    box.pin("torch==2.13.0", "numpy==1")
    first = box.env
    assert first.parent == box.folder / "data" / "fantasia3d"
    box.pin("numpy==1", "torch==2.13.0")
    assert box.env == first
    box.pin("numpy==2", "torch==2.13.0")
    assert box.env != first


def test_the_data_folder_is_the_systems(box):
    box.patch.setenv("LOCALAPPDATA", "/local")
    box.patch.setattr(Path, "home", lambda: Path("/home/ü"))
    box.patch.delenv("XDG_DATA_HOME")
    found = {}
    for platform in ("linux", "darwin", "win32"):
        box.patch.setattr(sys, "platform", platform)
        found[platform] = environment.data_folder().as_posix()
    assert found == {
        "linux": "/home/ü/.local/share/fantasia3d",
        "darwin": "/home/ü/Library/Application Support/fantasia3d",
        "win32": "/local/fantasia3d",
    }


def test_an_interpreter_may_be_given(box):
    box.patch.setenv("FANTASIA3D_PYTHON", str(box.python))
    assert box.ensure("blender") == box.python
    assert not box.log, "it is used as it is"
    box.patch.setenv("FANTASIA3D_PYTHON", "/no/python")
    with pytest.raises(environment.SetupError, match=r"/no/python, which is no program"):
        box.ensure()


# Python


def test_the_first_python_of_the_right_version_is_taken(box):
    others = []
    for name, probe in (
        ("old", "3.10|True|True|/old"),
        ("narrow", "3.11|False|True|/narrow"),
        ("bare", "3.11|True|False|/bare"),
    ):
        path = box.folder / name
        path.write_text(box.source(probe), encoding="utf-8")
        path.chmod(0o755)
        others.append(str(path))
    candidates = ["", "/not/there", *others, str(box.python)]
    box.patch.setattr(machine, "python_candidates", lambda: iter(candidates))
    assert environment.find_python() == box.python
    box.patch.setattr(machine, "python_candidates", lambda: iter(candidates[:-1]))
    with pytest.raises(environment.SetupError, match=r"bare cannot make .*python3\.11-venv"):
        environment.find_python()
    box.patch.setattr(machine, "python_candidates", lambda: iter(candidates[:3]))
    with pytest.raises(environment.SetupError, match=r"Python 3\.11 is not on this machine"):
        environment.find_python()


def test_pythons_are_sought_on_the_path_and_in_pyenv_and_blenders_own_comes_last(
    tmp_path, monkeypatch
):
    (tmp_path / "versions" / "3.11.9").mkdir(parents=True)
    (tmp_path / "versions" / "3.12.1").mkdir()
    monkeypatch.setenv("PYENV_ROOT", str(tmp_path))
    monkeypatch.setattr(shutil, "which", lambda name: None if name == "uv" else f"/path/{name}")
    monkeypatch.delitem(sys.modules, "bpy", raising=False)
    found = list(machine.python_candidates())
    assert found[:2] == [sys.executable, "/path/python3.11"]
    assert str(tmp_path / "versions" / "3.11.9" / "bin" / "python3.11") in found
    assert not any("3.12" in path for path in found)
    monkeypatch.setitem(sys.modules, "bpy", None)
    found = list(machine.python_candidates())
    assert found[0] == "/path/python3.11"
    assert found[-1] == sys.executable


def test_no_python_is_status_3(box, capsys):
    box.patch.setattr(machine, "python_candidates", lambda: iter(()))
    assert run.main(["setup"]) == 3
    said = capsys.readouterr().err
    assert "Python 3.11 is not on this machine" in said
    assert "Install it" in said
    assert "Traceback" not in said


# The set-up


def test_a_set_up_is_made_once_and_marked(box):
    python = box.ensure("blender")
    assert python == box.env / "bin" / "python"
    assert (python.parent / "installed").exists()
    assert environment.lacking(box.env, box.root, ("blender",)) == []
    assert environment.lacking(box.env, box.root, ("blender", "test")) == ["test"]
    before = box.log
    assert box.ensure("blender") == python
    assert box.log == before, "a warm start asks nothing"


def test_a_group_is_added_to_what_is_there_and_the_cores_pins_hold(box):
    box.ensure()
    before = box.log
    box.ensure("blender")
    assert box.log == [*before, "install torch==2.13.0 bpy==4.5.15"]


def test_a_changed_group_is_installed_again_and_a_changed_core_makes_all_anew(box):
    box.patch.setenv("FANTASIA3D_ENV", str(box.folder / "my env"))
    box.ensure("blender")
    box.pin("torch==2.13.0", blender="bpy==5")
    assert environment.lacking(box.env, box.root, ("blender",)) == ["blender"]
    box.pin("torch==3")
    assert environment.lacking(box.env, box.root, ("blender",)) == ["core", "blender"]
    (box.env / "old").touch()
    box.ensure("blender")
    assert not (box.env / "old").exists()


def test_an_environment_whose_python_has_gone_is_made_anew(box):
    (box.ensure("blender")).unlink()
    assert environment.lacking(box.env, box.root, ("blender",)) == ["core", "blender"]
    assert box.ensure("blender").exists()
    assert box.count("venv") == 2


def test_renew_makes_all_anew(box):
    box.ensure()
    (box.env / "old").touch()
    box.ensure(renew=True)
    assert not (box.env / "old").exists()
    assert environment.lacking(box.env, box.root) == []


def test_a_folder_of_the_users_is_left_alone(box):
    mine = box.folder / "mine"
    mine.mkdir()
    (mine / "thesis.txt").write_text("years")
    box.patch.setenv("FANTASIA3D_ENV", str(mine))
    with pytest.raises(environment.SetupError, match="not this project's"):
        box.ensure()
    assert [path.name for path in mine.iterdir()] == ["thesis.txt"]


@pytest.mark.parametrize(
    ("says", "sentence"),
    [
        (NO_NETWORK, "registry cannot be reached"),
        ("ERROR: No matching distribution found for bpy==4.5.15", "no package bpy==4.5.15"),
        ("OSError: [Errno 28] No space left on device", "disk filled up"),
        ("noise\nERROR: the moon is full\nmore noise", r"ERROR: the moon is full"),
    ],
)
def test_a_failed_set_up_says_why_and_leaves_nothing(box, says, sentence):
    box.patch.setenv("FAKE_SAYS", says)
    with pytest.raises(environment.SetupError, match=sentence) as caught:
        box.ensure()
    assert caught.value.status == 3
    log = environment.log_file(box.env)
    assert str(log) in caught.value.fix
    assert says.splitlines()[0] in log.read_text(encoding="utf-8")
    assert not box.env.exists()
    box.patch.delenv("FAKE_SAYS")
    assert box.ensure().exists(), "and the next one mends it"


def test_a_failed_group_leaves_the_core_whole(box):
    box.ensure()
    box.patch.setenv("FAKE_SAYS", NO_NETWORK)
    with pytest.raises(environment.SetupError):
        box.ensure("blender")
    assert environment.lacking(box.env, box.root, ("blender",)) == ["blender"]


def test_too_little_disk_is_said_before_anything_is_done(box):
    usage = shutil.disk_usage(box.folder)
    box.patch.setattr(shutil, "disk_usage", lambda _: usage._replace(free=10**9))
    with pytest.raises(environment.SetupError, match=r"needs 1\.8 GB; .* has 1\.0 GB") as caught:
        box.ensure()
    assert "FANTASIA3D_ENV" in caught.value.fix
    assert not box.log


def test_a_place_that_cannot_be_written_is_said(box):
    (box.folder / "file").touch()
    box.patch.setenv("FANTASIA3D_ENV", str(box.folder / "file" / "env"))
    with pytest.raises(environment.SetupError, match="cannot be written"):
        box.ensure()


def test_ctrl_c_leaves_nothing_half_made(box):
    def stop(text: str, share: float) -> None:
        if "virtual environment" in text:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        environment.ensure(box.root, (), stop)
    assert not box.env.exists()


def test_a_killed_set_up_is_repaired_and_never_met_by_its_own_ghost(box):
    """SIGKILL ends the set-up, pip goes on: the next set-up waits for it, then begins anew."""
    box.patch.setenv("FAKE_SECONDS", "2")
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); from pathlib import Path\n"
        "from fantasia3d_addon.environment import ensure, machine\n"
        "machine.python_candidates = lambda: iter([sys.argv[3]])\n"
        "ensure(Path(sys.argv[2]), (), lambda text, share: None)"
    )
    command = [sys.executable, "-c", code, str(ROOT), str(box.root), str(box.python)]
    child = subprocess.Popen(command)
    while not box.count("install"):
        time.sleep(0.02)
        assert child.poll() is None
    child.kill()
    child.wait()
    assert (box.env / layout.BUILDING).exists()
    assert environment.lacking(box.env, box.root) == ["core"]
    (box.env / "half-made").touch()
    box.patch.setenv("FAKE_SECONDS", "0")
    box.ensure()
    assert "Another set-up" in box.said[0], "pip still held the lock"
    assert not (box.env / "half-made").exists()
    assert environment.lacking(box.env, box.root) == []


def test_of_two_at_once_one_works_and_both_are_served(box):
    box.patch.setenv("FAKE_SECONDS", "0.5")
    found = []
    threads = [threading.Thread(target=lambda: found.append(box.ensure())) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [box.env / "bin" / "python"] * 2
    assert box.count("venv") == 1


# torch


def test_a_cuda_build_is_not_fetched_where_there_is_no_gpu(box):
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.patch.setenv("FAKE_UV", "echo 'error sending request: dns error'; exit 1")
    with pytest.raises(environment.SetupError, match="3 GB to download") as caught:
        box.ensure()
    assert "--allow-cuda" in caught.value.fix
    assert "registry cannot be reached" in caught.value.text
    assert box.count("install") == 0
    assert not box.env.exists()


def test_the_cpu_build_comes_through_uv_with_pips_sources(box):
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.patch.setenv("FAKE_UV", f'echo "$UV_FIND_LINKS $@" > "{box.folder}/uv-call"')
    box.ensure()
    said = (box.folder / "uv-call").read_text(encoding="utf-8")
    assert said.startswith("/wheels pip install --python ")
    assert "--torch-backend cpu torch==2.13.0" in said


def test_with_leave_the_cuda_build_is_taken_without_a_gpu(box):
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.ensure(allow_cuda=True)
    assert [line.split()[0] for line in box.log] == ["venv", "report", "install"]


def test_with_a_gpu_a_cpu_build_is_the_last_choice(box):
    box.patch.setattr(machine, "has_nvidia", lambda: True)
    box.patch.setenv("FAKE_UV", "exit 1")
    box.ensure()
    assert [text for text in box.said if text.startswith("taking torch's CPU build")]


@pytest.mark.parametrize(
    ("report", "platform", "cuda"),
    [(CPU, "linux", False), (CUDA, "linux", True), (CUDA, "win32", False), (CUDA, "darwin", False)],
)
def test_a_report_tells_whether_cuda_would_come(report, platform, cuda):
    assert words.offers_cuda(report, platform) is cuda


def test_a_local_version_tells_it_too():
    report = {"install": [{"metadata": {"version": "2.13.0+cu130", "requires_dist": []}}]}
    assert words.offers_cuda(report, "win32")


def test_a_wheel_folder_keeps_pip_off_the_network(box):
    box.patch.setenv("FANTASIA3D_WHEELS", "/my wheels")
    box.ensure()
    text = environment.log_file(box.env).read_text(encoding="utf-8")
    installs = [line for line in text.splitlines() if " install " in line]
    assert installs
    assert all("--no-index --find-links /my wheels" in line for line in installs)


# pip's words


@pytest.mark.parametrize(
    ("line", "step"),
    [
        ("  Downloading bpy-4.5.15-cp311-cp311-linux.whl (372.8 MB)", "bpy 4.5.15 (372.8 MB)"),
        ("Downloading https://x/torch-2.13.0-cp311.whl (1.2 GB)", "torch 2.13.0 (1.2 GB)"),
        ("  Downloading tqdm-4.70-py3-none-any.whl (78 kB)", ""),
        ("  Downloading xatlas-0.0.11-cp311.whl (0.2 MB)", ""),
        ("Collecting torch", ""),
    ],
)
def test_large_downloads_are_told(line, step):
    assert words.step_of(line) == (f"downloading {step}" if step else "")


def test_pips_sources_become_uvs():
    config = (
        ":env:.find-links='/a /b'\nglobal.index-url='file:///i'\nglobal.timeout='3'\n"
        "global.extra-index-url='file:///x file:///y'"
    )
    assert words.pip_sources(config) == {
        "UV_FIND_LINKS": "/a,/b",
        "UV_DEFAULT_INDEX": "file:///i",
        "UV_INDEX": "file:///x file:///y",
    }


@pytest.mark.parametrize(
    ("said", "version"), [("pip 23.0.1 from /x", (23, 0)), ("pip 26.3 from", (26, 3)), ("", (0, 0))]
)
def test_pips_version_is_read(said, version):
    assert words.pip_version(said) == version


# Handing over


@pytest.mark.parametrize("line", [["generate", "a chair"], ["resume", "RUN"]])
def test_blender_takes_the_asset_that_the_core_names_last(tmp_path, monkeypatch, capsys, line):
    asset = tmp_path / "a chair, ü" / "asset"
    asset.mkdir(parents=True)
    (asset.parent / "job.json").write_text('{"light": "city.exr"}')
    became = []

    def work(arguments: list[str]) -> int:
        assert arguments == line
        print("geometry 1/2")
        print(asset, flush=True)
        return 0

    monkeypatch.setattr("core.__main__.main", work)
    monkeypatch.setattr(run, "hand_over", lambda command: became.append(command) or 0)
    assert run.main(["--inside", *line, "--blend", "c.blend"]) == 0
    assert capsys.readouterr().out == f"geometry 1/2\n{asset}\n"
    assert became[0][2] == "--finish"
    assert json.loads(became[0][3]) == {
        "asset": str(asset),
        "blend": "c.blend",
        "light": "city.exr",
    }


@pytest.mark.parametrize("status", [2, 5, 130])
def test_a_failed_job_ends_before_blender_with_its_status(monkeypatch, status):
    monkeypatch.setattr("core.__main__.main", lambda _: status)
    monkeypatch.setattr(run, "hand_over", lambda _: pytest.fail("Blender was started"))
    assert run.main(["--inside", "generate", "a chair", "--render", "c.png"]) == status


def launcher(*arguments: str, **environ: str) -> subprocess.Popen[str]:
    """run.py as a process of its own, under this interpreter as the environment's."""
    return subprocess.Popen(
        [sys.executable, str(ROOT / "run.py"), *arguments],
        env={**os.environ, "FANTASIA3D_PYTHON": sys.executable, **environ},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_the_exit_status_passes_through():
    child = launcher("python", "-c", "import sys; sys.exit(7)")
    child.communicate()
    assert child.returncode == 7


def test_a_sentence_of_the_cores_passes_through_with_its_status():
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
def test_where_a_process_cannot_become_another_it_waits_and_tells_the_status(code):
    script = (
        "import sys, types, signal; sys.modules['bpy'] = types.ModuleType('bpy')\n"
        "import run; status = run.hand_over([sys.executable, '-c', sys.argv[1]])\n"
        "print(status, signal.getsignal(signal.SIGINT) is signal.SIG_IGN)"
    )
    told = "import os, signal, sys; print(signal.getsignal(signal.SIGINT), flush=True); " + code
    done = subprocess.run(
        [sys.executable, "-c", script, told], cwd=ROOT, capture_output=True, text=True, check=True
    )
    theirs, ours = done.stdout.splitlines()
    assert "default_int_handler" in theirs, "the child can be interrupted"
    assert ours == f"{7 if 'exit' in code else 128 + 9} True"


def test_another_pythons_variables_do_not_reach_the_environment():
    code = "import os; print(os.environ.get('PYTHONHOME'), os.environ.get('PYTHONPATH'))"
    child = launcher("python", "-c", code, PYTHONPATH="/nonsense")
    assert child.communicate()[0].split() == ["None", "None"]


def test_doctor_says_what_is_missing_and_how_to_mend_it(tmp_path):
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
