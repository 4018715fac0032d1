"""Types of what a run folder's JSON files hold: anybody may have written them. No bpy."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

from ..blender.input_file import parse_json, require_file

LARGEST = 2**63  # of a whole number: what the core takes as a seed


def read_object(path: Path) -> dict[str, Any]:
    """The JSON object in ``path``.

    Raises:
        ValueError: it is not a JSON object, or holds text that UTF-8 cannot.
        OSError: it can't be read.
    """
    require_file(path)
    data = parse_json(path.read_text("utf-8"))
    if not isinstance(data, dict):
        raise ValueError("no object")
    return data


def is_number(value: object) -> bool:
    """Whether ``value`` is a finite number of a size that can be computed with."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return -1e15 < value < 1e15 and math.isfinite(value)


def is_whole(value: object) -> bool:
    """Whether ``value`` is a whole number from 0 on."""
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < LARGEST


def is_text(value: object) -> bool:
    """Whether ``value`` is text that UTF-8 can hold."""
    try:
        return isinstance(value, str) and bool(value.encode() or True) and "\0" not in value
    except UnicodeEncodeError:
        return False


def is_inside(value: object) -> bool:
    """Whether ``value`` is a path that stays below the folder it is relative to, on any system."""
    if not isinstance(value, str) or not is_text(value):
        return False
    paths = PurePosixPath(value), PureWindowsPath(value)
    return not any(path.is_absolute() or path.drive or ".." in path.parts for path in paths)


def is_settings(value: object) -> bool:
    """Whether ``value`` are settings by name."""
    return isinstance(value, Mapping) and all(is_text(key) for key in value)


def has_types(data: Mapping[str, Any], kinds: Mapping[str, Any]) -> bool:
    """Whether each value of ``data`` passes the check of its name; other names are left alone."""
    return all(check(data[name]) for name, check in kinds.items() if name in data)
