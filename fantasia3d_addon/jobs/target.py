"""Where a run's asset goes: kept in the run folder, so that a later Blender knows it. No bpy."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from .job_file import write_json
from .untrusted import has_types, is_number, is_text, read_object

NAME = "target.json"
FREE, EXACT = "free", "exact"  # of a Target's place
MAPS, SHAPE, BOTH = "maps", "shape", "both"  # of a Target's assign: what of a region changes
REGION = (MAPS, SHAPE, BOTH)


KINDS: Mapping[str, Callable[[object], bool]] = {  # what each field of a target holds
    **dict.fromkeys(("file", "scene", "object", "uv_map"), is_text),
    "assign": lambda value: value in ("slot", "object", *REGION),
    "location": lambda value: (
        isinstance(value, list) and len(value) == 3 and all(map(is_number, value))
    ),
}


@dataclass(frozen=True, kw_only=True)
class Target:
    """A place in a Blender file, or an object in it that receives a material."""

    file: str = ""  # the .blend; empty for one that was not saved
    scene: str = ""
    location: tuple[float, float, float] = (0.0, 0.0, 0.0)  # of the asset's base
    place: str = FREE  # the free place nearest to ``location``; EXACT: there, whatever is there
    object: str = ""  # that receives the material; empty for a new object
    uv_map: str = ""  # of that object: the map that the textures use
    assign: str = "slot"  # "slot": in a new slot; "object": shown on the whole object;
    # MAPS: its maps alone, in the material that the object has; SHAPE: its vertices; or BOTH

    def write(self, run: Path) -> None:
        """Write it into the run folder; OSError where that can't be written."""
        write_json(run / NAME, dataclasses.asdict(self))

    @classmethod
    def read(cls, run: Path) -> Target:
        """That of a run folder; an empty one where there is none."""
        try:
            data = read_object(run / NAME)
            # A newer add-on may have written more fields: what is unknown here is left out.
            known = {field.name for field in dataclasses.fields(cls)}
            given = {key: value for key, value in data.items() if key in known}
            if not has_types(given, KINDS):
                return cls()
            location = tuple(given.get("location", (0.0, 0.0, 0.0)))  # JSON has lists alone
            return cls(**given | {"location": location})
        except (OSError, ValueError):
            return cls()
