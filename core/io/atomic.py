"""Files that are whole or not there: written to a temporary file, then renamed."""

import errno
import os
import re
import secrets
import shutil
import stat
from collections.abc import Collection, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from core.errors import UserError

OURS = re.compile(r"\.fantasia3d-[0-9a-f]{16}-.*\.(tmp|old)", re.DOTALL)  # names of temporary()
ENOUGH = 40  # characters of a name, so that with ours it stays below the systems' 255 bytes

FULL = (errno.ENOSPC, errno.EDQUOT)
LOST = (errno.EIO, errno.ENAMETOOLONG, errno.ESTALE, errno.ELOOP)
MISPLACED = (FileExistsError, FileNotFoundError, NotADirectoryError, IsADirectoryError)
FORBIDDEN = (errno.EACCES, errno.EPERM, errno.EROFS)


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """Give a temporary path next to ``path``; it takes the name at the end, or is removed.

    A killed process leaves it behind, hidden; in a run folder the next session removes it.

    Raises UserError for a full disk, a place that may not be written, a folder that is not there.
    """
    made = temporary(path)
    try:
        with disk_errors(path):
            yield made
            made.replace(path)
    except BaseException:
        with suppress(OSError):  # what went wrong first is what counts
            made.unlink()
        raise


def temporary(path: Path, kind: str = "tmp") -> Path:
    """A hidden name next to ``path`` that no other file has: PATH.tmp may be the user's own.

    ``kind``: tmp, or old for what is to be replaced.
    """
    return path.with_name(f".fantasia3d-{secrets.token_hex(8)}-{path.name[:ENOUGH]}.{kind}")


def left_over(folder: Path, kind: str = "tmp", of: str = "") -> list[Path]:
    """The temporary files and folders in ``folder`` for the name ``of``, or for any."""
    end = f"-{of[:ENOUGH]}.{kind}" if of else f".{kind}"
    found = sorted(folder.iterdir()) if folder.is_dir() else []
    return [x for x in found if OURS.fullmatch(x.name) and x.name.endswith(end)]


def check_target(path: Path) -> None:
    """Refuse before the work a ``path`` that no file can be written to after it.

    Raises:
        UserError: it is a folder, or its folder is none, is not there or may not be written.
    """
    with disk_errors(path):
        if path.is_dir():
            raise UserError(f"{path} is a folder.", "Name a file.")
        # Each as the system reports it: not there, not a folder, a name that is too long.
        _check_writable(path.parent)
        with suppress(FileNotFoundError):
            path.lstat()


def _check_writable(folder: Path) -> None:
    if not stat.S_ISDIR(folder.stat().st_mode):
        raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
    as_it_is = os.access in os.supports_effective_ids
    if not os.access(folder, os.W_OK, effective_ids=as_it_is):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))


def check_folder(path: Path) -> None:
    """Refuse before the work a folder ``path``, there or to be made, that it cannot be put into.

    Raises:
        UserError: it is a file, or cannot be made or written.
    """
    with disk_errors(path):
        place = path.absolute()
        while not os.path.lexists(place) and place != place.parent:  # the first that is there
            place = place.parent
        _check_writable(place)


@contextmanager
def disk_errors(path: Path) -> Iterator[None]:
    """Turn what the file system refuses into a UserError that names ``path``."""
    try:
        yield
    except OSError as error:
        if error.errno in FULL:
            raise UserError(f"The disk is full: {path} was not written.", "Make room.") from error
        if error.errno in FORBIDDEN:
            raise UserError(
                f"{path} cannot be written: {os.strerror(error.errno).lower()}.",
                "Choose another folder.",
            ) from error
        if isinstance(error, MISPLACED):
            raise UserError(
                f"{path} cannot be written: {error.strerror}.", "Choose another folder."
            ) from error
        if error.errno in LOST:
            raise UserError(
                f"{path} cannot be written: {os.strerror(error.errno)}.", "Choose another place."
            ) from error
        raise


def flush_folder(folder: Path) -> None:
    """Wait until the files of ``folder`` are on the disk."""
    for path in folder.iterdir():
        with path.open("rb+") as file:
            os.fsync(file.fileno())


def take_place(new: Path, folder: Path) -> None:
    """Give the folder ``new`` the name ``folder``; the older one is removed only then.

    Whole after a power cut too. After a failure the older one gets its name back.
    """
    old = temporary(folder, "old")
    flush_folder(new)
    try:
        if folder.exists():
            folder.rename(old)
        new.rename(folder)
    finally:
        restore(folder, old)


def restore(folder: Path, old: Path) -> None:
    """After an end between two renames ``old`` gets the name of ``folder`` back.

    Where there is a newer one it goes: it would block the next rename.
    """
    if old.exists() and not folder.exists():
        old.rename(folder)
    shutil.rmtree(old, ignore_errors=True)


def refuse_foreign_files(
    folder: Path, ours: Collection[str], fix: str = "Move it elsewhere."
) -> None:
    """Only the files named ``ours`` and temporary ones may be replaced: else it is somebody's work.

    Raises:
        UserError: what else is there, or that ``folder`` is none.
    """
    if folder.is_symlink() or (folder.exists() and not folder.is_dir()):
        raise UserError(f"{folder} is not a folder of this run.", fix)
    for found in folder.iterdir() if folder.exists() else ():
        if not (found.name in ours or OURS.fullmatch(found.name)) or found.is_dir():
            raise UserError(f"{found} is not a file of an asset, and would be lost.", fix)
