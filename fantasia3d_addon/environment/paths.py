"""The environment's contents and place, and whether it is complete."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from .files import expanded, write_text
from .lock_file import applies, locked_digest
from .machine import SetupError

MARKER = "fantasia3d.json"  # in a complete environment, written last
BUILDING = "fantasia3d.building"  # in one that is being created: it may be removed again


def project_root() -> Path:
    """The folder with ``pyproject.toml`` and ``core``: in the packaged add-on, or this tree."""
    addon = Path(__file__).resolve().parent.parent
    # In the installed extension, and in this repository.
    for root in (addon / "method", addon.parent):
        if (root / "pyproject.toml").is_file() and (root / "core").is_dir():
            return root
    raise SetupError(f"There is no core next to {addon}.", "Install the whole package again.")


def requirements(root: Path, group: str, version: str = "") -> list[str]:
    """The pinned requirements of ``group``: ``core``, or an optional one of pyproject.toml.

    With a Python's ``version``, only what is for that one, and without its marker.
    """
    import tomllib  # not in Python 3.8 to 3.10, under which run.py still starts

    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    core = group == "core"
    pins = project["dependencies"] if core else project["optional-dependencies"].get(group, [])
    if not version:
        return pins
    return [pin.partition(";")[0].strip() for pin in pins if applies(pin, version)]


def data_folder() -> Path:
    """The user's data folder of this project (not created here)."""
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local"
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Application Support"
    else:
        given = os.environ.get("XDG_DATA_HOME", "")
        # Its specification has one that is relative ignored.
        base = given if Path(given).is_absolute() else Path.home() / ".local" / "share"
    return Path(base) / "fantasia3d"


class Place(NamedTuple):
    """Where and from what an environment is created; None is the project's own choice."""

    folder: Path | None = None  # of the environment
    python: Path | None = None  # the interpreter that it is created from
    wheels: Path | None = None  # a folder of wheels, used instead of the registry


def env_folder(root: Path) -> Path:
    """Where the environment of this version's lock file is, or will be.

    FANTASIA3D_ENV names another folder.
    """
    given = os.environ.get("FANTASIA3D_ENV")
    if given:
        return expanded(given, SetupError).absolute()
    return data_folder() / f"env-{locked_digest(root, 'core')}"


def env_python(folder: Path) -> Path:
    """The interpreter of the environment ``folder``."""
    return folder / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")


def log_file(folder: Path) -> Path:
    """The log of the last set-up of ``folder``, next to it."""
    return folder.with_name(folder.name + ".log")


def read_marker(folder: Path) -> dict[str, Any]:
    """The contents of the environment ``folder``; empty while it is not complete."""
    try:
        marker = json.loads((folder / MARKER).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return marker if env_python(folder).exists() else {}


def write_marker(folder: Path, marker: dict[str, Any]) -> None:
    """Record, in one step, what ``folder`` contains."""
    write_text(folder / MARKER, json.dumps(marker, indent=1) + "\n")


def env_version(folder: Path) -> str:
    """The Python of the environment ``folder``, as ``3.11``; empty where there is none."""
    try:
        text = (folder / "pyvenv.cfg").read_text(encoding="utf-8")
    except OSError:
        return ""
    found = re.search(r"^version(?:_info)? = (\d+\.\d+)", text, re.MULTILINE)
    return found[1] if found else ""


def lacking(folder: Path, root: Path, groups: Sequence[str] = ()) -> list[str]:
    """Those of ``core`` and ``groups`` that are not installed as the lock file names them.

    Without the core's packages as locked, nothing in ``folder`` counts.
    """
    done = read_marker(folder).get("groups", {})
    wanted = {group: locked_digest(root, group) for group in ("core", *groups)}
    # Groups are installed on top of the core: with another core they are not valid.
    if done.get("core") != wanted["core"]:
        return list(wanted)
    return [group for group, value in wanted.items() if done.get(group) != value]
