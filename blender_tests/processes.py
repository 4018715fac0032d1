"""Another Blender of the same kind as this one."""

import sys
from pathlib import Path

import bpy

ROOT = Path(__file__).parents[1]


def blender_command(code: str) -> list[str]:
    """The command that runs ``code`` with bpy and this tree in a process of its own."""
    code = f"import sys\nsys.path.insert(0, {str(ROOT)!r})\n{code}"
    binary = bpy.app.binary_path  # empty where bpy is a module
    if binary:
        return [binary, "-b", "--factory-startup", "--python-expr", code]
    return [sys.executable, "-c", code]
