"""The environment that run.py makes, with stand-ins for Python and pip: no network, no torch."""

import json
import os
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

import run
from core.tests.fake_machine import CPU, CUDA, NO_NETWORK
from run import environment

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the stand-ins are shell programs")

ROOT = Path(run.__file__).parent
paths = sys.modules[environment.env_folder.__module__]
machine = sys.modules[environment.find_python.__module__]
pip_output = sys.modules[environment.ensure.__module__.replace("install", "pip_output")]


# The folder


def test_the_folder_is_named_by_the_lock_file_whatever_its_order(box):
    box.pin("torch==2.13.0", "numpy==1")
    first = box.env
    assert first.parent == box.folder / "data" / "fantasia3d"
    box.pin("numpy==1", "torch==2.13.0")
    assert box.env == first
    box.pin("numpy==2", "torch==2.13.0")
    assert box.env != first
    box.pin("torch==2.13.0", "numpy==1")
    lock = box.root / "requirements.lock"
    lock.write_text(lock.read_text().replace("sha256:00", "sha256:01", 1))
    assert box.env != first, "another file of the same version"


def test_a_tree_without_its_lock_file_is_refused(box):
    (box.root / "requirements.lock").unlink()
    with pytest.raises(environment.SetupError, match=r"There is no requirements\.lock in"):
        box.ensure()


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
    with pytest.raises(environment.SetupError, match=r"/no/python, which is not a program"):
        box.ensure()


@pytest.mark.parametrize(
    ("program", "lacks", "words"),
    [
        ("/bin/true", "", r"/bin/true, which is not a Python; it must be Python 3\.11"),
        ("", "torch, bpy", "which has no torch, bpy"),
    ],
)
def test_an_interpreter_that_cannot_do_the_work_is_refused(box, program, lacks, words):
    box.patch.setenv("FANTASIA3D_PYTHON", program or str(box.python))
    box.patch.setenv("FAKE_LACKS", lacks)
    with pytest.raises(environment.SetupError, match=words):
        box.ensure("blender")


def test_doctor_states_that_a_program_is_no_python(box):
    box.patch.setenv("FANTASIA3D_PYTHON", "/bin/true")
    lines = {line.name: line for line in environment.examine(box.root)}
    assert lines["packages"].state == "MISSING"
    assert "/bin/true is not a Python" in lines["packages"].text
    assert "FANTASIA3D_PYTHON" in lines["packages"].text, "a set-up would not fix it"


def test_a_wheel_folder_that_is_not_there_is_reported_first(box):
    box.patch.setenv("FANTASIA3D_WHEELS", str(box.folder / "none"))
    with pytest.raises(environment.SetupError, match="wheel folder .*none does not exist"):
        box.ensure()
    assert not box.log and not box.env.exists()


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
    with pytest.raises(environment.SetupError, match=r"Python 3\.11, 3\.12 or 3\.13 is not on"):
        environment.find_python()


def interpreter(box, name: str, version: str) -> str:
    """A stand-in of another version, next to the machine's own."""
    path = box.folder / name
    path.write_text(box.source(f"{version}|True|True|{path}", version), encoding="utf-8")
    path.chmod(0o755)
    return str(path)


@pytest.mark.parametrize(
    ("versions", "taken"),
    [
        (["3.13", "3.11"], "3.11"),
        (["3.12", "3.13", "3.14"], "3.13"),
        (["3.10", "3.12"], "3.12"),
        (["3.13"], "3.13"),
    ],
)
def test_of_several_pythons_the_best_tested_is_taken(box, versions, taken):
    candidates = [interpreter(box, f"python{version}", version) for version in versions]
    box.patch.setattr(machine, "python_candidates", lambda: iter(candidates))
    assert environment.find_python().name == f"python{taken}"


def test_blenders_own_python_makes_the_environment_where_there_is_no_other(box):
    own, other = interpreter(box, "blenders", "3.13"), interpreter(box, "other", "3.12")
    box.patch.setitem(sys.modules, "bpy", None)
    box.patch.setattr(sys, "executable", own)
    box.patch.setattr(machine, "python_candidates", lambda: iter([other, own]))
    assert environment.find_python() == Path(other), "it outlives this Blender"
    box.patch.setattr(machine, "python_candidates", lambda: iter([own]))
    assert environment.find_python() == Path(own)


# Blender's module, which is not there for every Python

BPY = "bpy==5; python_version == '3.13'"


def test_a_python_without_a_blender_module_is_refused_before_anything_is_written(box):
    box.pin("torch==2.13.0", blender=BPY)
    box.be("3.12")
    with pytest.raises(environment.SetupError, match=r"no Blender module \(bpy\) for Python 3\.12"):
        box.ensure("blender")
    assert not box.log
    box.ensure()
    with pytest.raises(environment.SetupError, match=r"no Blender module"):
        box.ensure("blender")
    assert environment.lacking(box.env, box.root) == [], "the core stays"


def test_the_same_environment_has_it_where_there_is_a_wheel(box):
    box.pin("torch==2.13.0", blender=BPY)
    box.be("3.13")
    assert environment.module_version(box.root) == ""
    box.ensure("blender")
    assert environment.module_version(box.root) == ""


@pytest.fixture
def blender(box):
    """A stand-in for an installed Blender, which records its command line."""
    path = box.folder / "my blender"
    path.write_text(
        f"#!/bin/sh\necho 'a warning'\necho \"Blender ${{FAKE_BLENDER:-5.2.1}}\"\n"
        f"echo \"$@\" >> '{box.folder}/blender-calls'\n"
    )
    path.chmod(0o755)
    box.patch.setenv("FANTASIA3D_BLENDER", str(path))
    box.pin("torch==2.13.0", blender=BPY)
    box.be("3.12")
    return path


def test_an_installed_blender_is_used_where_there_is_no_module(box, blender):
    box.patch.setattr(run, "ROOT", box.root)
    called = []
    box.patch.setattr(run, "hand_over", lambda command, *_: called.append(command) or 0)
    line = ["generate", "a chair", "--out", str(box.folder / "o"), "--blend", "a.blend"]
    assert run.main(line) == 0
    ((program, *words),) = called
    assert program == str(blender)
    assert words == ["-b", "--python-exit-code", "1", "--python", ROOT / "run.py", "--", *line]
    assert not box.log, "the environment is made by what runs in that Blender"


@pytest.mark.parametrize(
    ("version", "words"), [("3.6.2", "is Blender 3.6"), ("of oats", "is no Blender")]
)
def test_a_program_that_is_no_blender_of_use_is_refused(box, blender, version, words):
    box.patch.setenv("FAKE_BLENDER", version)
    with pytest.raises(environment.SetupError, match=words):
        environment.find_blender("3.12")


def test_without_a_module_and_without_blender_a_sentence_names_what_helps(box, blender, capsys):
    box.patch.setattr(run, "ROOT", box.root)
    box.patch.setenv("FANTASIA3D_BLENDER", "no-such-blender")
    assert run.main(["relight", "asset", "--render", "a.png"]) == 3
    output = capsys.readouterr().err
    assert "no Blender module (bpy) for Python 3.12, and no program no-such-blender" in output
    assert "Install Blender 4.2 or later" in output


def test_doctor_names_the_blender_that_is_used_instead_of_a_module(box, blender):
    box.ensure()
    lines = {line.name: line for line in environment.examine(box.root)}
    assert lines["Python"].text.startswith("3.12, ")
    assert lines["Blender"].text == f"{blender} (no bpy for 3.12)"
    assert "Blender module" not in lines
    box.patch.setenv("FAKE_BLENDER", "4.1.0")
    assert (
        "is Blender 4.1"
        in {line.name: line for line in environment.examine(box.root)}["Blender"].text
    )


def test_pythons_are_sought_on_the_path_and_in_pyenv_and_blenders_own_comes_last(
    tmp_path, monkeypatch
):
    (tmp_path / "versions" / "3.11.9").mkdir(parents=True)
    (tmp_path / "versions" / "3.10.1").mkdir()
    (tmp_path / "versions" / "3.13.2").mkdir()
    monkeypatch.setenv("PYENV_ROOT", str(tmp_path))
    monkeypatch.setattr(shutil, "which", lambda name: None if name == "uv" else f"/path/{name}")
    monkeypatch.delitem(sys.modules, "bpy", raising=False)
    found = list(machine.python_candidates())
    assert found[:2] == [sys.executable, "/path/python3.11"]
    assert str(tmp_path / "versions" / "3.11.9" / "bin" / "python3.11") in found
    assert str(tmp_path / "versions" / "3.13.2" / "bin" / "python3.13") in found
    assert not any("3.10" in path for path in found)
    monkeypatch.setitem(sys.modules, "bpy", None)
    found = list(machine.python_candidates())
    assert found[0] == "/path/python3.11"
    assert found[-1] == sys.executable


def test_no_python_is_status_3(box, capsys):
    box.patch.setattr(machine, "python_candidates", lambda: iter(()))
    assert run.main(["setup"]) == 3
    output = capsys.readouterr().err
    assert "Python 3.11, 3.12 or 3.13 is not on this machine" in output
    assert "Install one" in output
    assert "Traceback" not in output


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


def test_a_changed_group_is_installed_again_and_a_changed_core_makes_all_again(box):
    box.patch.setenv("FANTASIA3D_ENV", str(box.folder / "my env"))
    box.ensure("blender")
    box.pin("torch==2.13.0", blender="bpy==5")
    assert environment.lacking(box.env, box.root, ("blender",)) == ["blender"]
    box.pin("torch==3")
    assert environment.lacking(box.env, box.root, ("blender",)) == ["core", "blender"]
    (box.env / "old").touch()
    box.ensure("blender")
    assert not (box.env / "old").exists()


def test_an_environment_whose_python_has_gone_is_made_again(box):
    (box.ensure("blender")).unlink()
    assert environment.lacking(box.env, box.root, ("blender",)) == ["core", "blender"]
    assert box.ensure("blender").exists()
    assert box.count("venv") == 2


def test_renew_makes_all_again(box):
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
    ("output", "sentence"),
    [
        (NO_NETWORK, "registry cannot be reached"),
        ("ERROR: No matching distribution found for bpy==4.5.15", "no package bpy==4.5.15"),
        (
            "WARNING: Location '/no wheels' is ignored: it is either a non-existing path or lacks a"
            " specific scheme.\nERROR: No matching distribution found for torch",
            "wheel folder /no wheels does not exist",
        ),
        ("OSError: [Errno 28] No space left on device", "disk filled up"),
        (
            "ERROR: THESE PACKAGES DO NOT MATCH THE HASHES FROM THE REQUIREMENTS FILE. If you have "
            "updated the package versions, please update the hashes.\n"
            "    torch==2.13.0 from file:///w/torch-2.13.0%2Brocm-cp311-linux.whl (from -r r):\n"
            "        Expected sha256 00\n             Got        01",
            r"torch-2\.13\.0\+rocm-cp311-linux\.whl is not the file that the lock file names",
        ),
        (
            "error: Failed to download\n  cause: Hash mismatch for `torch==2.13.0+cpu`",
            r"torch==2\.13\.0\+cpu is not the file that the lock file names",
        ),
        (
            "ERROR: In --require-hashes mode, all requirements must have their versions pinned with"
            " ==. These do not:\n    nvidia-cudnn from https://x/y.whl (from torch==2.13.0)",
            "nvidia-cudnn is required, and the lock file does not name it",
        ),
        ("noise\nERROR: the moon is full\nmore noise", r"ERROR: the moon is full"),
    ],
)
def test_a_failed_set_up_states_why_and_leaves_nothing(box, output, sentence):
    box.patch.setenv("FAKE_OUTPUT", output)
    with pytest.raises(environment.SetupError, match=sentence) as caught:
        box.ensure()
    assert caught.value.status == 3
    log = environment.log_file(box.env)
    assert str(log) in caught.value.fix
    assert output.splitlines()[0] in log.read_text(encoding="utf-8")
    assert not box.env.exists()
    box.patch.delenv("FAKE_OUTPUT")
    assert box.ensure().exists(), "and the next one repairs it"


def test_a_failed_group_leaves_the_core_whole(box):
    box.ensure()
    box.patch.setenv("FAKE_OUTPUT", NO_NETWORK)
    with pytest.raises(environment.SetupError):
        box.ensure("blender")
    assert environment.lacking(box.env, box.root, ("blender",)) == ["blender"]


def test_too_little_disk_is_reported_before_anything_is_done(box):
    usage = shutil.disk_usage(box.folder)
    box.patch.setattr(shutil, "disk_usage", lambda _: usage._replace(free=10**9))
    with pytest.raises(environment.SetupError, match=r"needs 1\.8 GB; .* has 1\.0 GB") as caught:
        box.ensure()
    assert "FANTASIA3D_ENV" in caught.value.fix
    assert not box.log


def test_a_place_that_cannot_be_written_is_reported(box):
    (box.folder / "file").touch()
    box.patch.setenv("FANTASIA3D_ENV", str(box.folder / "file" / "env"))
    with pytest.raises(environment.SetupError, match="cannot be written"):
        box.ensure()


def test_ctrl_c_leaves_nothing_half_made(box):
    def stop(text: str, fraction: float) -> None:
        if "virtual environment" in text:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        environment.ensure(box.root, (), stop)
    assert not box.env.exists()


def test_a_killed_set_up_is_repaired_and_never_met_by_its_own_ghost(box):
    """SIGKILL ends the set-up, pip goes on: the next set-up waits for it, then starts again."""
    box.patch.setenv("FAKE_SECONDS", "2")
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); from pathlib import Path\n"
        "from fantasia3d_addon.environment import ensure, machine\n"
        "machine.python_candidates = lambda: iter([sys.argv[3]])\n"
        "ensure(Path(sys.argv[2]), (), lambda text, fraction: None)"
    )
    command = [sys.executable, "-c", code, str(ROOT), str(box.root), str(box.python)]
    child = subprocess.Popen(command)
    while not box.count("install"):
        time.sleep(0.02)
        assert child.poll() is None
    child.kill()
    child.wait()
    assert (box.env / paths.BUILDING).exists()
    assert environment.lacking(box.env, box.root) == ["core"]
    (box.env / "half-made").touch()
    box.patch.setenv("FAKE_SECONDS", "0")
    box.ensure()
    assert "Another set-up" in box.messages[0], "pip still held the lock"
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


def test_a_panel_names_no_command_line(box):
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.patch.setenv("FAKE_UV", "echo 'error sending request: dns error'; exit 1")
    box.patch.setitem(sys.modules, "bpy", None)
    found = []
    with pytest.raises(environment.SetupError) as caught:
        box.ensure()
    found.append(caught.value.fix)
    box.patch.setattr(machine, "python_candidates", lambda: iter(()))
    with pytest.raises(environment.SetupError) as caught:
        box.ensure()
    found.append(caught.value.fix)
    assert "Wheels Folder" in found[0] and "python.org" in found[1]
    assert not [text for text in found if "run.py" in text or "`" in text]


UV = 'for last; do :; done; echo "$UV_OFFLINE $UV_FIND_LINKS $@" | cat - "$last" > "{0}/uv-call"'


def uv_call(box) -> str:
    return (box.folder / "uv-call").read_text(encoding="utf-8")


def test_the_cpu_build_comes_through_uv_with_pips_sources_and_its_hash(box):
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.patch.setenv("FAKE_UV", UV.format(box.folder))
    box.ensure()
    assert uv_call(box).startswith(" /wheels pip install --python ")
    assert "--torch-backend cpu --require-hashes --no-deps -r " in uv_call(box)
    assert uv_call(box).endswith("\ntorch==2.13.0+cpu --hash=sha256:00\n")


def test_uv_stays_off_the_network_where_a_wheel_folder_is_named(box):
    wheels = box.folder / "my wheels"
    wheels.mkdir()
    box.patch.setenv("FANTASIA3D_WHEELS", str(wheels))
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.patch.setenv("FAKE_UV", UV.format(box.folder))
    box.ensure()
    assert uv_call(box).startswith(f"1 {wheels} pip install")


def test_with_leave_the_cuda_build_is_taken_without_a_gpu(box):
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.ensure(allow_cuda=True)
    assert [line.split()[0] for line in box.log] == ["venv", "report", "install"]


@pytest.mark.parametrize("gpu", [True, False])
def test_what_cuda_requires_is_installed_only_where_torch_is_the_cuda_build(box, gpu):
    box.patch.setattr(machine, "has_nvidia", lambda: gpu)
    with (box.root / "requirements.lock").open("a") as lock:
        lock.write("# [cuda]\nnvidia-cudnn==9 --hash=sha256:00\n")
    box.patch.setenv("FAKE_REPORT", json.dumps(CUDA))
    box.patch.setenv("FAKE_UV", "exit 0")
    box.ensure()
    assert box.log[-1].endswith("==2.13.0 nvidia-cudnn==9" if gpu else "==2.13.0+cpu")


def test_with_a_gpu_a_cpu_build_is_the_last_choice(box):
    box.patch.setattr(machine, "has_nvidia", lambda: True)
    box.pin("torch==2.13.0", torch=["torch==2.13.0+cu130"])
    box.patch.setenv("FAKE_UV", "exit 1")
    box.ensure()
    assert [text for text in box.messages if text.startswith("taking torch's CPU build")]
    assert box.count("target") == 1


def test_the_locked_cuda_build_of_torchs_own_index_comes_with_its_hash(box):
    box.patch.setattr(machine, "has_nvidia", lambda: True)
    box.pin("torch==2.13.0", torch=["torch==2.13.0+cu130"])
    box.patch.setenv("FAKE_UV", UV.format(box.folder))
    box.ensure()
    assert "--torch-backend cu130 --require-hashes" in uv_call(box)


@pytest.mark.parametrize("allowed", [False, True])
def test_a_cuda_build_without_a_hash_is_never_taken(box, allowed):
    box.patch.setattr(machine, "has_nvidia", lambda: True)
    box.patch.setenv("FAKE_UV", UV.format(box.folder))
    box.ensure(allow_cuda=allowed)
    (message,) = [text for text in box.messages if text.startswith("taking torch's CPU build")]
    assert "no hash for a +cu build" in message and "FANTASIA3D_PYTHON" in message
    assert box.count("target") == 0, "uv is not even fetched"


def test_with_a_gpu_the_registrys_cuda_build_comes_before_a_cpu_build_of_the_users(box):
    """A +cpu wheel in a folder of wheels is a later version to pip; the registry's has a hash."""
    box.patch.setattr(machine, "has_nvidia", lambda: True)
    box.patch.setenv("FAKE_EXACT_REPORT", json.dumps(CUDA))
    with (box.root / "requirements.lock").open("a") as lock:
        lock.write("# [cuda]\nnvidia-cudnn==9 --hash=sha256:00\n")
    box.ensure()
    assert [line.split()[0] for line in box.log] == ["venv", "report", "report", "install"]
    assert "torch===2.13.0" in box.log[-1] and box.log[-1].endswith(" nvidia-cudnn==9")


@pytest.mark.parametrize(
    ("report", "platform", "cuda"),
    [(CPU, "linux", False), (CUDA, "linux", True), (CUDA, "win32", False), (CUDA, "darwin", False)],
)
def test_a_report_tells_whether_cuda_would_come(report, platform, cuda):
    assert pip_output.offers_cuda(report, platform) is cuda


def test_a_local_version_tells_it_too():
    report = {"install": [{"metadata": {"version": "2.13.0+cu130", "requires_dist": []}}]}
    assert pip_output.offers_cuda(report, "win32")


def test_a_wheel_folder_keeps_pip_off_the_network(box):
    wheels = box.folder / "my wheels"
    wheels.mkdir()
    box.patch.setenv("FANTASIA3D_WHEELS", str(wheels))
    box.ensure()
    text = environment.log_file(box.env).read_text(encoding="utf-8")
    installs = [line for line in text.splitlines() if " install " in line]
    assert installs
    assert all(f"--no-index --find-links {wheels}" in line for line in installs)


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
def test_large_downloads_are_reported(line, step):
    assert pip_output.step_of(line) == (f"downloading {step}" if step else "")


def test_pips_sources_become_uvs():
    config = (
        ":env:.find-links='/a /b'\nglobal.index-url='file:///i'\nglobal.timeout='3'\n"
        "global.extra-index-url='file:///x file:///y'"
    )
    assert pip_output.pip_sources(config) == {
        "UV_FIND_LINKS": "/a,/b",
        "UV_DEFAULT_INDEX": "file:///i",
        "UV_INDEX": "file:///x file:///y",
    }


@pytest.mark.parametrize(
    ("output", "version"),
    [("pip 23.0.1 from /x", (23, 0)), ("pip 26.3 from", (26, 3)), ("", (0, 0))],
)
def test_pips_version_is_read(output, version):
    assert pip_output.pip_version(output) == version


def test_threads_sleep_while_they_wait_unless_the_user_states_otherwise(monkeypatch):
    monkeypatch.setenv("PYTHONPATH", "elsewhere")
    monkeypatch.delenv("OMP_WAIT_POLICY", raising=False)
    environ = environment.clean_environ()
    assert environ["OMP_WAIT_POLICY"] == "PASSIVE"
    assert "PYTHONPATH" not in environ
    monkeypatch.setenv("OMP_WAIT_POLICY", "ACTIVE")
    assert environment.clean_environ()["OMP_WAIT_POLICY"] == "ACTIVE"
