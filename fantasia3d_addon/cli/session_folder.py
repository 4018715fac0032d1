"""The folder for temporary files that Blender makes at its start and removes at an ordinary end."""

from __future__ import annotations

import os
import re
import shutil
import tempfile
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType

NAME = re.compile(r"blender_[A-Za-z0-9]{6}")


def remove_session_folder(blender: ModuleType) -> None:
    """Remove the session folder of ``blender``, the bpy module, for a process that ends at once."""
    preferred = blender.context.preferences.filepaths.temporary_directory
    folder = Path(blender.app.tempdir)
    if is_session_folder(folder, [preferred]):
        shutil.rmtree(folder, ignore_errors=True)


def is_session_folder(folder: Path, bases: Iterable[str] = ()) -> bool:
    """Whether ``folder`` holds one session's files alone.

    Where Blender can make none it takes the folder for everybody's temporary files itself, one of
    ``bases`` or of the system's; whatever that is called, it is never removed.
    """
    if not NAME.fullmatch(folder.name):
        return False
    named = (os.environ.get(name) for name in ("TMPDIR", "TEMP", "TMP"))
    return not any(_is_same(folder, base) for base in (*bases, *named, tempfile.gettempdir()))


def _is_same(folder: Path, base: str | None) -> bool:
    try:
        return bool(base) and folder.samefile(str(base))
    except OSError:  # one of them is not there
        return False
