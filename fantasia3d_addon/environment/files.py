"""Small files that are never seen half-written. Standard library only."""

from __future__ import annotations

import contextlib
import secrets
from pathlib import Path


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
