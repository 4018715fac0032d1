"""Removal of an environment of ours; what else is in its folder is refused, never removed."""

from __future__ import annotations

import contextlib
import shutil
from pathlib import Path

from . import paths
from .machine import SetupError

OTHER_FOLDER = "Set FANTASIA3D_ENV to an empty or new folder."


def remove(folder: Path) -> None:
    """Remove an environment of ours, complete or not; nothing else.

    Raises:
        SetupError: ``folder`` contains something that this project did not create.
    """
    if not folder.exists():
        return
    check_folder(folder)
    try:
        _remove(folder)
    except OSError as error:
        raise SetupError(
            f"{error.filename or folder} cannot be removed ({error.strerror or error}).",
            "Close the programs that use it, such as a running job, and check its permissions.",
        ) from None


def _remove(folder: Path) -> None:
    (folder / paths.BUILDING).touch()  # so that an interrupted removal can be continued
    # The marker goes first: from here on the environment counts as incomplete.
    (folder / paths.MARKER).unlink(missing_ok=True)
    for entry in list(folder.iterdir()):
        if entry.name != paths.BUILDING:
            shutil.rmtree(entry) if entry.is_dir() and not entry.is_symlink() else entry.unlink()
    shutil.rmtree(folder)


def check_folder(folder: Path) -> None:
    """Refuse a folder with the user's files.

    Raises:
        SetupError: there are files in ``folder``, and it is no environment of ours.
    """
    ours = (folder / paths.MARKER).exists() or (folder / paths.BUILDING).exists()
    if folder.exists() and not ours and (not folder.is_dir() or any(folder.iterdir())):
        raise SetupError(f"{folder} holds files that are not this project's.", OTHER_FOLDER)


def check_log(log: Path) -> None:
    """Refuse to overwrite a file that is no log of ours.

    Raises:
        SetupError: ``log`` is somebody else's.
    """
    if not _is_our_log(log):
        raise SetupError(f"{log} is not a log of this project.", OTHER_FOLDER)


def _is_our_log(log: Path) -> bool:
    """Whether ``log`` may be overwritten: a log of a set-up starts with a command."""
    if not log.exists():
        return True
    with log.open("rb") as file:
        return file.read(2) in (b"", b"$ ")


def tidy(folder: Path) -> None:
    """Remove the log and the lock of a removed environment too, and the data folder if it is empty.

    Not while another set-up of it is waiting: that holds the lock.
    """
    if folder.exists():
        return
    log, lock = paths.log_file(folder), folder.with_name(folder.name + ".lock")
    if _is_our_log(log):
        log.unlink(missing_ok=True)
    if lock.exists() and not lock.stat().st_size:  # ours is empty: another has this name
        lock.unlink()
    if folder.parent == paths.data_folder():
        with contextlib.suppress(OSError):  # something else is in it
            folder.parent.rmdir()
