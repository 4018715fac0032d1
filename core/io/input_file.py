"""Files that the user names: there, regular and readable, before a library opens them."""

import errno
import os
import stat
from pathlib import Path

from core.errors import UserError


def check_file(
    path: Path,
    what: str = "file",
    fix: str = "Check the path.",
    missing: type[UserError] = UserError,
) -> None:
    """Refuse what is no file that may be read: opening a pipe would wait for its writer forever.

    Raises:
        UserError: it is a folder, a pipe, a device, or not permitted; ``missing`` where there is
            none, which ``what`` and ``fix`` are about.
    """
    try:
        mode = path.stat().st_mode
    except ValueError:  # a NUL in its name
        raise missing(f"There is no {what} {path}.", fix) from None
    except OSError as error:
        if isinstance(error, FileNotFoundError | NotADirectoryError) or error.errno == errno.ELOOP:
            raise missing(f"There is no {what} {path}.", fix) from None
        if isinstance(error, PermissionError):
            raise _forbidden(path) from None
        raise
    if stat.S_ISDIR(mode):
        raise UserError(f"{path} is a folder.", f"Name a {what}.")
    if not stat.S_ISREG(mode):
        raise UserError(
            f"{path} is a pipe or a device.", "Save its output to a file, and use that file."
        )
    try:
        path.open("rb").close()
    except PermissionError:
        raise _forbidden(path) from None


def expanded(path: "str | Path") -> Path:
    """``path`` with the user's own folder for "~"; an unknown ~user stays as it is."""
    return Path(os.path.expanduser(path))  # noqa: PTH111 - Path's own raises RuntimeError there


def check_name(path: Path) -> None:
    """Refuse a name that is not text: libraries for pictures and checkpoints open none such.

    Raises:
        UserError: UTF-8 cannot hold it, as that of an old archive or disk.
    """
    try:
        str(path).encode()
    except UnicodeEncodeError:
        raise UserError(
            f"{path} has a byte in its name that is not text.",
            "Rename it, or choose another place.",
        ) from None


def own_file(path: Path, folder: Path, fix: str) -> Path:
    """``path`` of our ``folder``; UserError where it is a link that leads out of it.

    A folder may come from anywhere: what is made of it must not hold another file of the user's.
    """
    # Not resolve, which may raise for a link that leads back to itself.
    if not Path(os.path.realpath(path)).is_relative_to(os.path.realpath(folder)):
        raise UserError(f"{path} is a link to another folder.", fix)
    return path


def check_size(path: Path, most: int, fix: str) -> None:
    """Raise UserError for a file of more than ``most`` bytes, before any of it is read."""
    if path.stat().st_size > most:
        raise UserError(f"{path} is larger than {most >> 20} MB.", fix)


def _forbidden(path: Path) -> UserError:
    return UserError(
        f"{path} cannot be read: permission denied.",
        "Change its permissions, or name another file.",
    )
