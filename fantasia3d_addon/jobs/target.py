"""Where a run's asset goes: kept beside the job, so that a later Blender knows it too. No bpy."""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass
from pathlib import Path

from .process import write_json

FILE = "target.json"


@dataclass(frozen=True, kw_only=True)
class Target:
    """A place in a Blender file, or an object of it whose material is made."""

    file: str = ""  # the .blend; empty for one that was not saved
    scene: str = ""
    location: tuple[float, float, float] = (0.0, 0.0, 0.0)  # of the asset's base
    object: str = ""  # its material is made; empty for a new object
    uv_map: str = ""  # of that object: where the maps lie
    assign: str = "slot"  # "slot": in a new slot; "object": shown on the whole object

    def write(self, run: Path) -> None:
        """Keep it in the run folder; OSError where that can't be written."""
        write_json(run / FILE, dataclasses.asdict(self))

    @classmethod
    def read(cls, run: Path) -> Target:
        """That of a run folder; one with nothing in it where there is none."""
        try:
            data = json.loads((run / FILE).read_text("utf-8"))
            known = {field.name for field in dataclasses.fields(cls)}
            told = {key: value for key, value in data.items() if key in known}
            return cls(**told | {"location": tuple(told.get("location", (0.0, 0.0, 0.0)))})
        except (OSError, ValueError, TypeError, AttributeError):
            return cls()
