"""Which Blender follows a run: a lock in the run folder, so that two never mix. No bpy."""

from __future__ import annotations

from pathlib import Path
from typing import IO

from ..environment import try_lock

NAME = "follower"  # the lock file in the run folder


class RunLock:
    """Held by the one Blender that follows a run; the system releases it when that Blender dies."""

    def __init__(self, file: IO[bytes]) -> None:
        self._file = file

    @classmethod
    def acquire(cls, folder: Path) -> RunLock | None:
        """The lock of the run in ``folder``; None while another Blender holds it."""
        try:
            file = (folder / NAME).open("ab")
        except OSError:  # a read-only folder: nobody can follow that run
            return None
        if try_lock(file):
            return cls(file)
        file.close()
        return None

    def release(self) -> None:
        """Let another Blender follow the run."""
        self._file.close()  # the lock goes with the open file
