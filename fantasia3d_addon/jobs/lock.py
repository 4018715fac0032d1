"""Which Blender follows a run: a lock in the run folder, so that several never mix. No bpy."""

from __future__ import annotations

from pathlib import Path
from typing import IO

from ..environment import try_lock


class Claim:
    """Held by the one Blender that follows a run; the system lets it go when that Blender dies."""

    def __init__(self, file: IO[bytes]) -> None:
        self._file = file

    @classmethod
    def take(cls, folder: Path) -> Claim | None:
        """The claim on the run in ``folder``; None while another Blender has it."""
        try:
            file = (folder / "follower").open("ab")
        except OSError:  # a folder that can only be read is followed by nobody
            return None
        if try_lock(file):
            return cls(file)
        file.close()
        return None

    def release(self) -> None:
        """Let another Blender follow the run."""
        self._file.close()
