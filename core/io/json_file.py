"""JSON files that somebody else may have written or changed. Standard library only."""

import json
import math
from pathlib import Path
from typing import Any

from core.errors import UserError, shown
from core.io.input_file import check_file, check_size

MAX_BYTES = 8 << 20  # job.json and asset.json are a few kilobytes
MAX_DIGITS = 300  # of a whole number: whatever is computed with it fits a float


def read_object(path: Path, fix: str) -> dict[str, Any]:
    """The object in a JSON file.

    Raises:
        UserError: the file cannot be read, is not UTF-8 or not JSON, is nested too deeply, has a
            number beyond any machine's, or holds something other than an object.
    """
    try:
        check_file(path, fix=fix)
        check_size(path, MAX_BYTES, fix)
        return parse_object(path.read_text(encoding="utf-8"), str(path), fix)
    except UnicodeDecodeError:
        raise UserError(f"{path} is not UTF-8 text.", fix) from None
    except OSError as error:
        raise UserError(f"{path} cannot be read ({error.strerror}).", fix) from error


def parse_object(text: str, name: str, fix: str) -> dict[str, Any]:
    """The object in ``text``; ``name``: its name in errors, which are those of read_object."""
    try:
        data = json.loads(text, parse_constant=_refuse, parse_int=_whole, parse_float=_number)
        if "\\u" in text:  # a lone half of a surrogate pair, which no file takes
            json.dumps(data, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        raise UserError(f"{name} holds half of a character.", fix) from None
    except ValueError as error:  # also a number of more digits than Python converts
        raise UserError(f"{name} is not JSON ({str(error).split(';')[0]}).", fix) from None
    except RecursionError:
        raise UserError(f"{name} is nested too deeply.", fix) from None
    if not isinstance(data, dict):
        raise UserError(f"{name} holds no object.", fix)
    return data


def _refuse(constant: str) -> None:
    raise ValueError(f"{constant} is not a number in JSON")


def _whole(text: str) -> int:
    if len(text) > MAX_DIGITS:
        raise ValueError(f"a number of {len(text)} digits")
    return int(text)


def _number(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"{shown(text)} is beyond any number of this machine")
    return value
