"""A path's ~, and small files that are never seen half-written. Standard library only."""

from __future__ import annotations

import contextlib
import os
import secrets
from collections.abc import Callable
from pathlib import Path


def expanded(path: str | Path, error: Callable[[str, str], Exception]) -> Path:
    """``path`` with its ~ replaced by the home folder.

    Raises:
        error: of the caller's kind, by a text and its fix: there is no such home.
    """
    try:
        return Path(path).expanduser()
    except RuntimeError:
        raise error(*no_home(path)) from None


def of_variable(value: str) -> str:
    """``value``, which a variable names, with its ~ expanded; as it is where there is no such home.

    Its user reports what is wrong with it.
    """
    return os.path.expanduser(value)  # noqa: PTH111 - Path's own raises for an unknown ~user


def no_home(path: str | Path) -> tuple[str, str]:
    """The fault of ``path``, which starts with a home folder that does not exist, and the fix."""
    text = f"There is no home folder {Path(path).parts[0]!r}, as in {str(path)!r}."
    return text, f"Name the whole path, or ./{path} for a name that starts so."


def is_file(path: str | Path) -> bool:
    """Whether ``path`` is a file; Path.is_file raises for a name that is too long."""
    return os.path.isfile(path)  # noqa: PTH113


def write_text(path: Path, text: str) -> None:
    """Write ``text`` to a temporary file next to ``path``, then rename: readers see old or new.

    Its name is hidden and no other file's (as in core/io/atomic.py): PATH.tmp may be the user's.
    """
    temporary = path.with_name(f".fantasia3d-{secrets.token_hex(8)}-{path.name[:40]}.tmp")
    try:
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):  # what went wrong first is what counts
            temporary.unlink()
        raise
