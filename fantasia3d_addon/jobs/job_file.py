"""job.json in a run folder: what was requested, written once. No bpy."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from ..blender.names import data_name
from ..environment.files import write_text
from ..errors import JobError
from .untrusted import has_types, is_number, is_settings, is_text, is_whole, read_object

NAME = "job.json"
IMPORTED = "taken"  # an empty file in a run folder whose asset came into a scene
# The user's files that a job refers to, and the names of their copies in the run folder.
FILES = {
    "guide_mesh": "guide.obj",
    "mesh": "mesh.obj",
    "base_color": "base_color.png",
    "region": "faces.txt",
}
KEPT = "kept/asset"  # the folder of the copy of an asset whose region a job edits


KINDS: Mapping[str, Callable[[object], bool]] = {  # what each field of a job holds
    **dict.fromkeys(
        ("command", "prompt", "negative_prompt", "preset", "guidance", "guide_mesh", "mesh", "uv",
         "base_color", "kept_asset", "region", "light", "device"),
        is_text,
    ),
    **dict.fromkeys(("seed", "color_seed", "texture_size", "max_faces", "version"), is_whole),
    "guide_strength": is_number,
    "settings": is_settings,
}  # fmt: skip


def new_run_folder(runs: Path, prompt: str) -> Path:
    """A new, empty folder for a run in ``runs``, named by the time and the prompt's words.

    Raises:
        JobError: it can't be created.
    """
    words = "".join(c if c.isalnum() else " " for c in data_name(prompt).lower()).split()
    name = "-".join([time.strftime("%Y%m%d-%H%M%S"), *words])
    number = 1
    while True:  # mkdir is the test: two Blenders may ask for the same name in the same second
        folder = runs / (name if number == 1 else f"{name}-{number}")
        try:
            folder.mkdir(parents=True)
        except FileExistsError:
            number += 1
        except OSError as error:
            raise JobError(
                f"{folder} can't be created ({error.strerror}).",
                "Choose another folder for runs in the add-on's preferences.",
            ) from None
        else:
            return folder


def write_job(folder: Path, job: Mapping[str, Any]) -> None:
    """Write ``job`` as job.json into the new run folder ``folder``; nothing is started.

    Raises:
        JobError: the folder holds another run or can't be written.
    """
    if (folder / NAME).exists():
        raise JobError(f"{folder} holds a run already.", "Resume that run, or use another folder.")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        write_json(folder / NAME, job)
    except OSError as error:
        raise unwritable(folder, error) from None


def read_job(folder: Path) -> Mapping[str, Any]:
    """job.json of a run folder; empty where it can't be read, or has values of other types."""
    try:
        job = read_object(folder / NAME)
    except (OSError, ValueError):
        return {}
    return job if has_types(job, KINDS) else {}


def with_own_paths(job: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """``job`` with the full paths of its own files in the run folder ``folder``."""
    # The core takes paths relative to its working folder, which is not the run folder.
    names = {**FILES, "kept_asset": KEPT}
    own = {
        key: str((folder / name).resolve()) for key, name in names.items() if job.get(key) == name
    }
    return dict(job) | own


def write_json(path: Path, data: Mapping[str, Any]) -> None:
    """Write a small JSON file in one step."""
    write_text(path, json.dumps(data, ensure_ascii=False, indent=1) + "\n")


def unwritable(folder: Path, error: OSError) -> JobError:
    """The error for a run folder that can't be written."""
    return JobError(
        f"{folder} can't be written ({error.strerror}).",
        "Choose another run folder in the add-on's preferences.",
    )
