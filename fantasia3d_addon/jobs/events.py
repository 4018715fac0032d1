"""The events of a run and the stages of a job, as the core writes them. No bpy.

The core has the same names in its own code; blender_tests/test_vocabulary.py compares the two.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from ..blender.input_file import parse_json
from .untrusted import has_types, is_inside, is_number, is_text, is_whole

EVENTS = ("started", "progress", "preview", "warning", "error", "done", "cancelled", "paused")
END_EVENTS = (
    "done",
    "error",
    "cancelled",
    "paused",
)  # exactly one of these ends a session of the core

STAGES = {  # in the order in which they run: the core's name, and the name in the panel
    "fit": "First shape",  # the ellipsoid or the guide mesh, as a signed distance field
    "geometry": "Shape",
    "unwrap": "UV map",
    "start": "Present colour",  # of "texture": the material starts from the mesh's own colour
    "appearance": "Material",
    "bake": "Textures",
}


KINDS: Mapping[str, Callable[[object], bool]] = {  # what each field of an event holds
    **dict.fromkeys(("type", "stage", "text", "fix"), is_text),
    **dict.fromkeys(("step", "steps"), is_whole),
    "time": is_number,
    **dict.fromkeys(("loss", "seconds_left"), lambda value: value is None or is_number(value)),
    "path": is_inside,
    # A signal to 1 may reach every process of the user's, and one to a negative number a group.
    "pid": lambda value: is_whole(value) and value != 1 and value < 2**31,
}


@dataclass(frozen=True, kw_only=True)
class Event:
    """One line of events.jsonl; fields that do not apply are empty."""

    type: str  # one of EVENTS
    time: float = 0.0  # seconds since the epoch
    stage: str = ""  # one of STAGES
    step: int = 0
    steps: int = 0
    loss: float | None = None
    seconds_left: float | None = None
    text: str = ""  # one sentence for the user
    fix: str = ""  # what the user can do about it
    path: str = ""  # relative to the run folder
    pid: int = 0  # of the core's process

    @property
    def ends(self) -> bool:
        """Whether nothing follows it until the run is resumed."""
        return self.type in END_EVENTS


def parse_event(line: bytes) -> Event:
    """One line of events.jsonl; a line that can't be read becomes a warning."""
    data = event_object(line)
    if data is None:
        return Event(
            type="warning",
            text="A line of events.jsonl can't be read.",
            fix="Install the add-on and the core of the same release.",
        )
    # A newer core may write more fields: what is unknown here is left out.
    known = {field.name for field in dataclasses.fields(Event)}
    return Event(**{key: value for key, value in data.items() if key in known})


def event_object(line: bytes) -> dict[str, Any] | None:
    """The JSON object of one line of events.jsonl; None where it is not an event."""
    try:
        data = parse_json(line)
    except ValueError:
        return None
    is_event = isinstance(data, dict) and "type" in data and has_types(data, KINDS)
    return data if is_event else None


def stages_of(job: Mapping[str, Any]) -> tuple[str, ...]:
    """The stages that a job goes through, in order."""
    skipped = {"start"}
    if job.get("command") == "texture":
        # The shape is given; its own UV map may be kept, and its colour may be the start.
        skipped = {"fit", "geometry"}
        skipped |= {"unwrap"} if job.get("uv") == "keep" else set()
        skipped |= set() if job.get("base_color") else {"start"}
        if job.get("reshape"):  # of a region; its material stays unless it is asked for
            skipped = set(STAGES) - {"geometry"} if not job.get("retexture") else skipped
            skipped -= {"geometry"}
    return tuple(stage for stage in STAGES if stage not in skipped)
