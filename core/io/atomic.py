"""Files that are whole or not there: written to a temporary file, then renamed."""

import errno
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from core.errors import UserError

FULL = (errno.ENOSPC, errno.EDQUOT)
LOST = (errno.EIO, errno.ENAMETOOLONG, errno.ESTALE, errno.ELOOP)
FORBIDDEN = (errno.EACCES, errno.EPERM, errno.EROFS)


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """Give a temporary path next to ``path``; it takes the name at the end, or is removed.

    Raises UserError for a full disk, a place that may not be written, a folder that is not there.
    """
    temporary = path.with_name(path.name + ".tmp")
    try:
        with disk_errors(path):
            yield temporary
            temporary.replace(path)
    except BaseException:
        with suppress(OSError):  # what went wrong first is what counts
            temporary.unlink()
        raise


def check_target(path: Path) -> None:
    """Refuse before the work a ``path`` that no file can be written to after it.

    Raises:
        UserError: it is a folder, or its folder is none, is not there or may not be written.
    """
    with disk_errors(path):
        if path.is_dir():
            raise UserError(f"{path} is a folder.", "Name a file.")
        # Each as the system says it: not there, no folder, a name that is too long.
        if not stat.S_ISDIR(path.parent.stat().st_mode):
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
        as_it_is = os.access in os.supports_effective_ids
        if not os.access(path.parent, os.W_OK, effective_ids=as_it_is):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        with suppress(FileNotFoundError):
            path.with_name(path.name + ".tmp").lstat()


@contextmanager
def disk_errors(path: Path) -> Iterator[None]:
    """Turn what the file system refuses into a UserError that names ``path``."""
    try:
        yield
    except OSError as error:
        if error.errno in FULL:
            raise UserError(f"The disk is full: {path} was not written.", "Make room.") from error
        if error.errno in FORBIDDEN:
            raise UserError(f"{path} may not be written.", "Choose another folder.") from error
        if isinstance(error, FileNotFoundError | NotADirectoryError | IsADirectoryError):
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
