"""Candidates: runs that pause at a first look; the user finishes one of them. No bpy."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from .job_file import write_json
from .untrusted import has_types, is_text, read_object

NAME = "candidate.json"
SHAPE, COLOR = "shape", "color"  # what a first look is at, as the core names it
KINDS: Mapping[str, Callable[[object], bool]] = {
    "group": is_text,
    "until": lambda value: value in ("", SHAPE, COLOR),
}


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """The data of a candidate run."""

    group: str = ""  # the same for all that were requested together; empty: it is none
    until: str = ""  # where it pauses; empty: it was chosen, and is finished

    @property
    def is_open(self) -> bool:
        """Whether it is one and was not chosen yet."""
        return bool(self.group and self.until)


def write(path: Path, candidate: Candidate) -> None:
    """Write ``candidate`` as the file ``path``; OSError where that can't be written."""
    write_json(path, dataclasses.asdict(candidate))


def read(run: Path) -> Candidate:
    """That of a run folder; an empty one where there is none."""
    try:
        data = read_object(run / NAME)
        known = {field.name for field in dataclasses.fields(Candidate)}
        given = {key: value for key, value in data.items() if key in known}
        return Candidate(**given) if has_types(given, KINDS) else Candidate()
    except (OSError, ValueError):
        return Candidate()
