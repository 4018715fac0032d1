"""Blender's side of a command: the bpy module where there is one, else an installed Blender."""

from __future__ import annotations

import os
import re
import shlex
from pathlib import Path

from . import machine, paths
from .files import is_file
from .given import named_python
from .machine import SetupError

OLDEST = (4, 2)  # as in manifest.toml
NO_MODULE = "There is no Blender module (bpy) for Python {version}"
FIX = (
    "Install Blender 4.2 or later so that `blender` is on the path, or name its program in "
    "FANTASIA3D_BLENDER. Or install Python 3.11 or 3.13, and: run.py setup blender --renew"
)


def has_module(root: Path, version: str) -> bool:
    """Whether the registry has a bpy module for the Python of ``version``; an empty one has."""
    return not version or bool(paths.requirements(root, "blender", version))


def module_version(root: Path) -> str:
    """The Python that the environment has, or would be made from, if it can have no bpy module.

    Empty where it can, and where an interpreter of the user's is used as it is.
    """
    if named_python():
        return ""
    version = paths.env_version(paths.env_folder(root))
    if not version or paths.lacking(paths.env_folder(root), root):
        version = machine.version_of(machine.find_python())
    return "" if has_module(root, version) else version


def find_blender(version: str) -> list[str]:
    """The command of an installed Blender, for what the module of Python ``version`` would do.

    Raises:
        SetupError: there is none, or one that is too old.
    """
    named = os.environ.get("FANTASIA3D_BLENDER") or "blender"
    # A program with spaces in its path, or a command with arguments of its own.
    words = [named] if is_file(named) else _words(named)
    text = NO_MODULE.format(version=version)
    program = words[0] if is_file(words[0]) else machine.which(words[0])
    if not program:
        raise SetupError(f"{text}, and no program {words[0]}.", FIX)
    command = [program, *words[1:]]
    answer = re.search(
        r"^Blender (\d+)\.(\d+)", machine.output([*command, "--version"], timeout=60), re.MULTILINE
    )
    if not answer or (int(answer[1]), int(answer[2])) < OLDEST:
        what = f"Blender {answer[1]}.{answer[2]}" if answer else "no Blender"
        raise SetupError(f"{text}, and {named} is {what}.", FIX)
    return command


def _words(command: str) -> list[str]:
    """The words of a command line; all in one where its quotes do not match, or there is none."""
    try:
        return shlex.split(command) or [command]
    except ValueError:
        return [command]
