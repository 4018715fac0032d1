"""What is installed, what is missing, and how to fix it: ``run.py doctor``, the panel's "Check"."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from . import machine, paths
from .blender_program import find_blender, has_module
from .files import of_variable
from .given import named_python
from .machine import SetupError

ANSWER_SECONDS = 120  # torch may load from a cold disk
OLDEST = min(machine.PYTHONS)
OK, MISSING, NOTE = "ok", "MISSING", "-"

# Run by the environment's own Python; its arguments are the pinned requirements.
PROBE = """
import importlib.metadata, importlib.util, json, sys
from pathlib import Path
facts = {"python": sys.version.split()[0], "wrong": []}
for pin in sys.argv[1:]:
    name, _, wanted = pin.partition("==")
    try:
        found = importlib.metadata.version(name.partition("[")[0])
    except importlib.metadata.PackageNotFoundError:
        found = "none"
    if found.partition("+")[0] != wanted:
        facts["wrong"].append(f"{name} {found} (wanted {wanted})")
    if name == "bpy" and found != "none":
        facts["bpy"] = found
        folder = Path(importlib.util.find_spec("bpy").origin).parent
        facts["lights"] = len(list(folder.glob("*/datafiles/studiolights/world/*")))
if importlib.util.find_spec("torch"):
    import torch
    facts["torch"], facts["threads"] = torch.__version__, torch.get_num_threads()
    if torch.cuda.is_available():
        free, total = (n / 1e9 for n in torch.cuda.mem_get_info())
        facts["gpu"] = f"{torch.cuda.get_device_name()}, {free:.0f} of {total:.0f} GB free"
    elif torch.backends.mps.is_available():
        facts["gpu"] = "Apple GPU (mps)"
print(json.dumps(facts))
"""


class Line(NamedTuple):
    """One finding: its ``state`` is "ok", "MISSING" (the main job cannot run) or "-"."""

    name: str
    state: str
    text: str


def examine(root: Path, folder: Path | None = None, python: Path | None = None) -> list[Line]:
    """All findings; takes a few seconds, because torch is loaded in the environment's Python.

    ``folder`` is that of the environment where it is not the project's own choice; ``python`` an
    interpreter that is used instead of one. Inside Blender its own module counts, and the
    environment needs none.
    """
    # Priority: the interpreter that is given, the variable, the environment.
    named = named_python() if python is None else str(python)
    given = named if folder is None or python else ""
    folder = folder or paths.env_folder(root)
    return [*_python(root, folder, given), *_environment(root, folder, given), *_data(root)]


def _python(root: Path, folder: Path, given: str) -> list[Line]:
    lines = [Line("launcher", NOTE, f"Python {sys.version.split()[0]}, {root}")]
    if "bpy" in sys.modules:
        lines.append(Line("Blender", OK, sys.modules["bpy"].app.version_string))
    try:
        python = machine.find_python()
        return [*lines, Line("Python", OK, f"{machine.version_of(python)}, {python}")]
    except SetupError as error:
        needed = "core" in paths.lacking(folder, root) and not given
        return [*lines, Line("Python", MISSING if needed else NOTE, str(error))]


def _environment(root: Path, folder: Path, given: str) -> list[Line]:
    groups, make = ["blender"], "generate creates it, and so does: python3 run.py setup blender"
    if "bpy" in sys.modules:
        groups, make = [], 'press "Install"'
    python = Path(given) if given else paths.env_python(folder)
    version = machine.version_of(python) if python.exists() or given else ""
    elsewhere: list[Line] = []
    if groups and not given and not has_module(root, version):
        groups, elsewhere = [], [_installed_blender(version)]
    lacking = [] if given else paths.lacking(folder, root, groups)
    if "core" in lacking:
        return [Line("environment", MISSING, f"{folder} does not exist yet; {make}")]
    lines = [Line("environment", OK, given or str(folder))]
    if lacking:
        lines.append(Line("Blender module", MISSING, f"it is not in the environment yet; {make}"))
    present = [group for group in ("core", *groups) if group not in lacking]
    # A given interpreter that does not answer is reported by what follows.
    pins = [p for group in present for p in paths.requirements(root, group, version or OLDEST)]
    return lines + elsewhere + _packages(str(python), pins, bool(given))


def _installed_blender(version: str) -> Line:
    """The Blender that is used where the environment's Python can have no bpy module."""
    try:
        return Line("Blender", OK, f"{' '.join(find_blender(version))} (no bpy for {version})")
    except SetupError as error:
        return Line("Blender", NOTE, str(error))


def _packages(python: str, pins: Sequence[str], given: bool = False) -> list[Line]:
    """The report of the environment's own Python, or a ``given`` one, on packages and the GPU."""
    fix = "fix it with: python3 run.py setup --renew blender"
    if given:  # which the set-up leaves alone
        fix = "name a Python with this project's packages (FANTASIA3D_PYTHON, preferences), or none"
    elif "bpy" in sys.modules:
        fix = 'press "Reinstall" under Installation'
    try:
        # In the environment's own Python: this one may have other packages.
        done = subprocess.run(
            [python, "-c", machine.NOT_FROM_HERE + PROBE, *pins],
            stdin=subprocess.DEVNULL,
            env=machine.piped_environ(),
            capture_output=True,
            timeout=ANSWER_SECONDS,
        )
    except OSError as error:
        return [Line("packages", MISSING, f"{python} does not run ({error.strerror}); {fix}")]
    except subprocess.TimeoutExpired:
        return [Line("packages", MISSING, f"{python} does not answer; {fix}")]
    if done.returncode:
        lines = done.stderr.decode("utf-8", "replace").strip().splitlines() or ["no output"]
        return [Line("packages", MISSING, f"{lines[-1]}; {fix}")]
    try:
        facts = json.loads(done.stdout.decode("utf-8").splitlines()[-1])
    except (ValueError, IndexError):
        return [Line("packages", MISSING, f"{python} is not a Python; {fix}")]
    lines = [Line("packages", OK, f"as pinned, under Python {facts['python']}")]
    if facts["wrong"]:
        lines = [Line("packages", MISSING, f"{', '.join(facts['wrong'])}; {fix}")]
    lines.append(Line("torch", OK if "torch" in facts else MISSING, facts.get("torch", fix)))
    gpu = facts.get("gpu") or f"none; the CPU is used, with {facts.get('threads', 1)} threads"
    if "gpu" not in facts and machine.has_nvidia():
        gpu = f"there is one, but torch does not see it; {fix}"
    lines.append(Line("GPU", NOTE, gpu))
    if "bpy" in facts:
        lines.append(Line("Blender module", OK, f"bpy {facts['bpy']}"))
        lines.append(Line("studio lights", NOTE, f"{facts['lights']} of Blender's"))
    return lines


def _data(root: Path) -> list[Line]:
    weights = sorted((root / "core" / "guidance" / "builtin").glob("*.safetensors"))
    size = sum(path.stat().st_size for path in weights) / 1e6
    names = ", ".join(path.name for path in weights)
    data = paths.data_folder()
    # The folder itself may not exist yet.
    place = next(path for path in (data, *data.parents) if path.exists())
    free = shutil.disk_usage(str(place)).free / 1e9
    own = "none in the hub's cache; optional: choose a diffusers folder as the model"
    if "bpy" not in sys.modules:
        own = "none in the hub's cache; optional: --guidance FOLDER accepts any diffusers folder"
    return [
        Line("built-in weights", OK, f"{names} ({size:.1f} MB)")
        if weights
        else Line("built-in weights", MISSING, "there are none; install again"),
        Line("Stable Diffusion", NOTE, _hub_models() or own),
        Line("disk", NOTE, f"{free:.0f} GB free at {place}"),
    ]  # fmt: skip


def _hub_models() -> str:
    """The diffusers models in the hub's cache on this machine."""
    caches = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    home = os.environ.get("HF_HOME") or f"{caches}/huggingface"
    hub = Path(of_variable(os.environ.get("HF_HUB_CACHE") or f"{home}/hub"))
    found = hub.glob("models--*/snapshots/*/model_index.json")
    return ", ".join(sorted({p.parents[2].name[8:].replace("--", "/") for p in found}))
