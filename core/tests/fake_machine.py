"""A machine of its own for a test: stand-ins for Python and pip, no network, no torch."""

import json
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

import run
from run import environment

machine = sys.modules[environment.find_python.__module__]

# A Python that answers the probe, makes "environments" of itself, and plays pip. Each call is a
# line in CALLS: what it was, and its last words. FAKE_OUTPUT is the end of an installation that
# fails, FAKE_SECONDS is how long one takes.
FAKE = """#!{python} -S
import os, shutil, sys, time

args = sys.argv[1:]

def call(kind):
    with open({calls!r}, "a", encoding="utf-8") as file:
        print(kind, *args[-2:], file=file)

if args[0] == "-c" and "path if path" in args[1]:
    lacks = "|" + os.environ.get("FAKE_LACKS", "") if "find_spec" in args[1] else ""
    print({python_version!r} + lacks)
    sys.exit()
if args[:3] != ["-I", "-X", "utf8"]:
    sys.exit("not isolated: " + " ".join(args))
del args[:3]
if args[:2] == ["-m", "venv"]:
    call("venv")
    os.makedirs(args[2] + "/bin", exist_ok=True)
    shutil.copy(sys.argv[0], args[2] + "/bin/python")
    with open(args[2] + "/pyvenv.cfg", "w") as file:
        file.write("version = " + {python_version!r} + ".7")
elif args[:1] == ["-c"]:
    print({probe!r} if "version_info" in args[1] else "loads")
elif "--version" in args:
    print("pip 26.3 from somewhere")
elif "config" in args:
    print("global.find-links='/wheels'")
elif "--report" in args:
    call("report")
    with open(args[args.index("--report") + 1], "w") as file:
        exact = os.environ.get("FAKE_EXACT_REPORT") if "===" in args[-1] else None
        file.write(exact or os.environ.get("FAKE_REPORT", {report!r}))
elif "--target" in args:
    call("target")
    folder = args[args.index("--target") + 1] + "/bin"
    os.makedirs(folder)
    with open(folder + "/uv", "w") as file:
        file.write("#!/bin/sh\\n" + os.environ["FAKE_UV"])
    os.chmod(folder + "/uv", 0o755)
elif "install" in args:
    if not {{"--require-hashes", "--only-binary", "-r"}} <= set(args):
        sys.exit("not by the lock file: " + " ".join(args))
    with open(args[-1], encoding="utf-8") as file:
        args[-2:] = [line.split()[0] for line in file]
    call("install")
    time.sleep(float(os.environ.get("FAKE_SECONDS", 0)))
    if os.environ.get("FAKE_OUTPUT"):
        sys.exit(os.environ["FAKE_OUTPUT"])
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
        self.be("3.11")
        monkeypatch.delitem(sys.modules, "bpy", raising=False)  # the launcher, not Blender
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
        self.messages: list[str] = []

    def be(self, version: str) -> None:
        """Make the machine's one Python be of this version."""
        probe = f"{version}|True|True|{self.python}"
        self.python.write_text(self.source(probe, version), encoding="utf-8")
        self.python.chmod(0o755)

    def source(self, probe: str, version: str = "3.11") -> str:
        return FAKE.format(
            python=sys.executable,
            calls=str(self.calls),
            python_version=version,
            probe=probe,
            report=json.dumps(CPU),
        )

    def pin(
        self,
        *core: str,
        blender: str = "bpy==4.5.15",
        torch: Sequence[str] = ("torch==2.13.0+cpu",),
    ) -> None:
        """Write a pyproject.toml with these requirements, and its lock file."""
        text = f"[project]\ndependencies = {list(core)}\n[project.optional-dependencies]\n"
        text += f"blender = [{json.dumps(blender)}]\ntest = ['pytest==9']\n"
        text += "setup = ['uv==1', 'pip==26']\n"
        (self.root / "pyproject.toml").write_text(text)
        groups = {"core": core, "blender": [blender], "test": ["pytest==9"], "torch": torch}
        groups["setup"] = ["uv==1", "pip==26"]
        lock = "".join(
            f"# [{name}]\n" + "".join(f"{pin} \\\n    --hash=sha256:00\n" for pin in pins)
            for name, pins in groups.items()
        )
        (self.root / "requirements.lock").write_text(lock)

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
        def show(text: str, fraction: float) -> None:
            assert 0 <= fraction <= 1
            self.messages.append(text)

        return environment.ensure(self.root, groups, show, **options)
