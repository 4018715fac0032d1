"""Files that somebody else may have put there: regular ones, before they are opened."""

from __future__ import annotations

import errno
import json
import math
import os
from pathlib import Path
from typing import Any, NoReturn

from ..environment.files import is_file

MAX_DIGITS = 300  # of a whole number: whatever is computed with it fits a float


def require_file(path: Path) -> None:
    """Raise OSError for what is no regular file; to open a pipe would wait for its writer forever.

    What is not there at all, or not permitted, is for who opens it.
    """
    is_other = os.path.exists(path) and not is_file(path)  # noqa: PTH110
    if is_other:
        number = errno.EISDIR if os.path.isdir(path) else errno.EINVAL  # noqa: PTH112
        text = os.strerror(number) if number == errno.EISDIR else "it is a pipe or a device"
        raise OSError(number, text, str(path))


def parse_json(text: str | bytes) -> Any:
    """The value of JSON from outside.

    Raises:
        ValueError: it is none; is nested too deeply; has a number that no float holds, or text that
            UTF-8 cannot, which Blender's own refuses.
    """
    try:
        data = json.loads(text, parse_constant=_refuse, parse_int=_whole, parse_float=_number)
        # A lone half of a surrogate pair; and a nesting that another reader would not take.
        json.dumps(data, ensure_ascii=False).encode()
    except RecursionError:
        raise ValueError("nested too deeply") from None
    return data


def _refuse(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is not a number in JSON")


def _whole(text: str) -> int:
    if len(text) > MAX_DIGITS:
        raise ValueError(f"a number of {len(text)} digits")
    return int(text)


def _number(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError("a number that is too large")
    return value
