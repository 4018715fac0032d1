"""The interface between the core and a window on it: job.json and events.jsonl.

Standard library only. The files are in the run folder (docs/architecture.md).
"""

import dataclasses
import difflib
import errno
import json
import os
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, get_origin

from core.errors import UserError, shown
from core.io.atomic import atomic_file
from core.io.input_file import check_file, check_size
from core.io.json_file import parse_object

VERSION = 1
COMMANDS = ("generate", "texture")
UV_MODES = ("auto", "keep")
EVENTS = ("started", "progress", "preview", "warning", "error", "done", "cancelled", "paused")
LAST = ("done", "error", "cancelled", "paused")  # exactly one of these ends a session
UNTIL = ("shape", "color")  # where a session may pause on request: with a first look at either
MAX_PROMPT = 2000  # characters
MAX_EVENTS = 256 << 20  # bytes of events.jsonl; a day of work writes less than 10 MB
MAX_LINE = 1 << 16  # bytes of an event: far more than any has
MAX_STRENGTH = 5.0  # of a LoRA
SIZES = (0.001, 1000.0)  # metres, of an asset's longest side


@dataclass(frozen=True, kw_only=True)
class Job:
    """One asset, as the user asked for it. Written once, never changed."""

    prompt: str
    command: str = "generate"  # or "texture"
    negative_prompt: str = ""
    seed: int = 0
    color_seed: int = 0  # of the material's training; 0: it follows ``seed``
    preset: str = "draft"
    guidance: str = "builtin"  # or a folder, a .safetensors file, or a hub id
    loras: dict[str, float] = field(default_factory=dict)  # {file: strength}, over a checkpoint
    embeddings: list[str] = field(default_factory=list)  # files; each one's word is its name
    guide_mesh: str = ""  # a file whose shape the geometry starts from; "" is the ellipsoid
    guide_strength: float = 0.5  # 0 is a start only, 1 keeps the shape, or the base colour
    mesh: str = ""  # of "texture": the user's own mesh
    uv: str = "auto"  # of "texture": "keep" takes the mesh's own, even where faces share texels
    base_color: str = ""  # of "texture": a picture over the mesh's uv to start from; or "mesh"
    kept_asset: str = ""  # of "texture": the asset of ``mesh``, whose maps hold outside ``region``
    region: str = ""  # a text file with the faces that get the material, a number a line
    reshape: bool = False  # of a region: its shape changes, and no texel
    retexture: bool = False  # of a region that is reshaped: its material changes too
    light: str = "studio"  # a name or an HDR or EXR file
    texture_size: int = 0  # texels; 0 is the preset's
    max_faces: int = 0  # 0 is the preset's
    size_m: float = 0.0  # of "generate": the longest side, metres; 0: the prompt's or the usual
    device: str = "auto"
    ignore_unknown_words: bool = False  # of "builtin": leave out what it does not know
    settings: dict[str, Any] = field(default_factory=dict)  # {"geometry.fine.steps": 100}
    version: int = VERSION

    def __post_init__(self) -> None:
        _check(self)

    @classmethod
    def from_json(cls, text: str) -> "Job":
        """:meth:`from_object` of the text of a job.json."""
        return cls.from_object(parse_object(text, "job.json", "Start a new run."))

    @classmethod
    def from_object(cls, data: dict[str, Any]) -> "Job":
        """Check ``data``; an unknown key is refused, so that a misspelt one is never ignored."""
        if data.get("version") != VERSION:
            raise UserError(
                f"job.json has version {shown(data.get('version'))}; this core reads {VERSION}.",
                "Install the add-on and the core of the same release.",
            )
        known = [f.name for f in dataclasses.fields(cls)]
        for key in sorted(data.keys() - set(known)):
            near = difflib.get_close_matches(key, known, n=1)
            hint = f"Did you mean {near[0]!r}?" if near else f"Use one of {', '.join(known)}."
            raise UserError(f"job.json has no setting {shown(key)}.", hint)
        if "prompt" not in data:
            raise UserError("job.json has no prompt.", "Describe what to make.")
        return cls(**data)

    def to_json(self) -> str:
        """The text of job.json."""
        return json.dumps(dataclasses.asdict(self), ensure_ascii=False, indent=1) + "\n"


def _check(job: Job) -> None:
    for f in dataclasses.fields(job):
        value = getattr(job, f.name)
        kind = get_origin(f.type) or f.type
        takes = (int, float) if kind is float else kind
        if isinstance(value, bool) != (kind is bool) or not isinstance(value, takes):
            raise UserError(f"{f.name} is {shown(value)}.", f"Use a value of type {kind.__name__}.")
    if not job.prompt.strip():
        raise UserError(
            "The prompt is empty.", 'Describe what to make, such as "a red wooden chair".'
        )
    for f in dataclasses.fields(job):
        _check_text(f.name, getattr(job, f.name))
    for name in ("prompt", "negative_prompt"):
        check_prompt(name, getattr(job, name))
    _check_additions(job)
    if job.command not in COMMANDS:
        raise UserError(
            f"There is no command {shown(job.command)}.", f"Use {' or '.join(COMMANDS)}."
        )
    if job.command == "texture" and not job.mesh:
        raise UserError("There is no mesh to texture.", "Name an OBJ, PLY, GLB or STL file.")
    if job.uv not in UV_MODES:
        raise UserError(f"There is no uv mode {shown(job.uv)}.", f"Use {' or '.join(UV_MODES)}.")
    if job.base_color and job.command != "texture":
        raise UserError("A base colour to start from needs a mesh.", "Use it with texture.")
    if bool(job.region) != bool(job.kept_asset) or (job.region and job.uv != "keep"):
        raise UserError(
            "A region needs the asset that it is a part of, and its UV map.", "Use run.py edit."
        )
    if job.reshape and not job.region:
        raise UserError("Reshaping needs a region.", "Use run.py edit with --faces and --shape.")
    if job.retexture and not job.reshape:
        raise UserError(
            "A region gets its material anyway.", "Use retexture with reshape, or leave it out."
        )
    if not 0 <= job.guide_strength <= 1:  # false for NaN too
        raise UserError(f"The guide strength is {shown(job.guide_strength)}.", "Use 0 to 1.")
    if job.size_m and not SIZES[0] <= job.size_m <= SIZES[1]:
        raise UserError(f"The size is {shown(job.size_m)} m.", "Use {:g} to {:g} m.".format(*SIZES))
    for name in ("seed", "color_seed"):
        if not 0 <= getattr(job, name) < 2**63:
            raise UserError(
                f"The {name.replace('_', ' ')} is {shown(getattr(job, name))}.",
                "Use a whole number from 0 to 2**63 - 1.",
            )
    if job.texture_size and not 64 <= job.texture_size <= 8192:
        raise UserError(f"The texture size is {shown(job.texture_size)}.", "Use 64 to 8192 texels.")
    if job.max_faces and job.max_faces < 100:
        raise UserError(f"The face budget is {shown(job.max_faces)}.", "Use 100 faces or more.")


def _check_additions(job: Job) -> None:
    for path, strength in job.loras.items():
        number = isinstance(strength, int | float) and not isinstance(strength, bool)
        if not number or not -MAX_STRENGTH <= strength <= MAX_STRENGTH:  # false for NaN too
            raise UserError(
                f"The strength of the LoRA {shown(path)} is {shown(strength)}.",
                f"Use {-MAX_STRENGTH:g} to {MAX_STRENGTH:g}; 1 is as it was trained.",
            )
    for path in (*job.loras, *job.embeddings):
        if not isinstance(path, str) or not path.strip():
            raise UserError(f"A file is named {shown(path)}.", "Give the .safetensors file.")


def check_prompt(name: str, text: str) -> None:
    """Raise UserError for a text that UTF-8 cannot hold, or one too long."""
    _check_text(name, text)
    if len(text) > MAX_PROMPT:
        raise UserError(
            f"The {name.replace('_', ' ')} has {len(text)} characters.",
            f"Shorten it to {MAX_PROMPT} or less.",
        )


def _check_text(name: str, value: Any) -> None:
    """Text that UTF-8 cannot hold comes from a terminal of another encoding."""
    try:
        found = str(value).encode("utf-8")
    except UnicodeEncodeError:
        found = b"\0"
    if b"\0" in found:  # which ends a name where the system reads it
        raise UserError(
            f"The {name.replace('_', ' ')} holds a byte that is not text.",
            "Type it again, in a terminal that uses UTF-8.",
        )


class EventWriter:
    """Appends events, one line each; the file is closed between, so a reader sees whole lines."""

    def __init__(self, run: Path) -> None:
        self._path = run / "events.jsonl"
        self._is_whole = False  # nothing of an earlier session's last line is left

    def write(self, type: str, **fields: Any) -> dict[str, Any]:
        """Append one event; fields that are None are left out. Of one that fails nothing stays."""
        assert type in EVENTS, type
        event = {"type": type, "time": round(time.time(), 3)}
        event |= {key: value for key, value in fields.items() if value is not None}
        line = json.dumps(event, ensure_ascii=False).encode() + b"\n"
        # Unbuffered: a line is one write, which a kill does not cut.
        with self._path.open("ab+", buffering=0) as file:
            if not self._is_whole:
                _remove_half_a_line(file)
                self._is_whole = True
            end = file.seek(0, os.SEEK_END)
            try:
                if file.write(line) < len(line):  # what a disk that fills up takes
                    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(self._path))
            except OSError:
                file.truncate(end)
                raise
        return event


def _remove_half_a_line(file: BinaryIO) -> None:
    """The next event would be added to it, and both be lost."""
    end = file.seek(0, os.SEEK_END)
    file.seek(max(0, end - MAX_LINE))
    tail = file.read()
    if tail and not tail.endswith(b"\n"):
        file.truncate(end - len(tail) + tail.rfind(b"\n") + 1)


def read_events(run: Path) -> list[dict[str, Any]]:
    """All whole lines of a run's events.jsonl.

    Raises UserError for a line that is not a JSON object, and for a file too large.
    """
    path = run / "events.jsonl"
    if not path.exists():
        return []
    check_file(path, fix="Start a new run.")
    check_size(path, MAX_EVENTS, "Start a new run.")
    text = path.read_bytes()
    lines = text[: text.rfind(b"\n") + 1].decode("utf-8", "replace").split("\n")[:-1]
    return [parse_object(line, str(path), "Start a new run.") for line in lines]


def write_text(path: Path, text: str) -> None:
    """Write a small text file whole: to a temporary file, then renamed."""
    with atomic_file(path) as temporary, temporary.open("w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())  # it survives a power cut as well
