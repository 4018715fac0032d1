"""Locks in the run folder: of the Blender that follows the run and of its core. No bpy."""

from __future__ import annotations

from pathlib import Path
from typing import IO

from ..environment import try_lock
from .job_file import unwritable

NAME = "follower"  # the lock file in the run folder
WORKER = "lock"  # the core's own, which contains its pid (core/io/lock.py)
UNKNOWN = "unknown"  # the pid of one that could not write it


def worker(folder: Path) -> str:
    """The pid of the core that works on the run in ``folder``; empty where none does."""
    try:
        file = (folder / WORKER).open("rb+", buffering=0)
    except OSError:  # never started, or read-only
        return ""
    with file:
        if try_lock(file):
            return ""
        file.seek(1)  # Windows forbids reading the first byte, which is the one that is locked
        return file.read(20).decode("ascii", "replace").strip() or UNKNOWN


class RunLock:
    """Held by the one Blender that follows a run; the system releases it when that Blender dies."""

    def __init__(self, file: IO[bytes]) -> None:
        self._file = file

    @classmethod
    def acquire(cls, folder: Path) -> RunLock | None:
        """The lock of the run in ``folder``; None while another Blender holds it.

        Raises:
            JobError: the folder is read-only or gone: nobody can follow that run.
        """
        try:
            file = (folder / NAME).open("ab")
        except OSError as error:
            raise unwritable(folder, error) from None
        if try_lock(file):
            return cls(file)
        file.close()
        return None

    def release(self) -> None:
        """Let another Blender follow the run."""
        self._file.close()  # the lock goes with the open file
