"""One process at a time works on a run: a lock in its folder. Standard library only.

The add-on reads it too (``fantasia3d_addon/jobs/lock.py``).
"""

import errno
import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from core.errors import UserError
from core.io.input_file import own_file

NAME = "lock"  # the file; it stays, because removing one that another process waits for is unsafe
LOCK_TIMEOUT = 0.5  # seconds: the add-on holds the lock for a moment when it checks who holds it
HELD = (errno.EWOULDBLOCK, errno.EAGAIN, errno.EACCES, errno.EDEADLK)


@contextmanager
def run_lock(folder: Path, name: str = NAME) -> Iterator[None]:
    """Hold the lock of the run in ``folder``; the system releases it when this process dies.

    Raises:
        UserError: another process works on the run, or nothing can be written in its folder; a file
            that is written into is a link to another, as in a folder from elsewhere.
    """
    path = folder / name
    try:
        for written in (name, "events.jsonl", "log.txt"):
            own_file(folder / written, folder, "Remove it.")
        # Unbuffered: Windows forbids reading the first byte, which is the one that is locked.
        file = path.open("ab+", buffering=0)
    except OSError as error:
        raise UserError(
            f"{folder} cannot be written ({error.strerror}).",
            "Make room or change its permissions, or copy it to another place and resume it there.",
        ) from None
    with file:
        end = time.monotonic() + LOCK_TIMEOUT
        while not _try_lock(file.fileno()):
            if time.monotonic() > end:
                file.seek(1)
                owner = file.read(20).decode("ascii", "replace").strip() or "unknown"
                raise UserError(
                    f"Another process works on {folder} already (pid {owner}).",
                    "Wait until it ends, or cancel it.",
                )
            time.sleep(LOCK_TIMEOUT / 10)
        with suppress(OSError):  # on a full disk: it is held all the same, by nobody known
            file.truncate(0)
            file.write(f" {os.getpid()}\n".encode())
        yield


def _try_lock(file: int) -> bool:
    """Lock the first byte of ``file`` (Windows) or all of it; False where another holds it."""
    try:
        if sys.platform == "win32":
            import msvcrt

            os.lseek(file, 0, os.SEEK_SET)
            msvcrt.locking(file, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        if error.errno in HELD:
            return False
        # A file system without locks, such as some network folders: no run is refused for that.
    return True
