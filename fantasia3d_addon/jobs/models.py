"""The Stable Diffusion models on this machine, asked of the core in the background. No bpy.

The core reads headers and configurations alone (``python -m core models --json``, which needs no
package). It is asked once, and again when the user asks for it.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ..background.thread import Task
from ..environment import piped_environ
from .process import Core

TIMEOUT = 120.0  # seconds: a folder may be on a slow disk
LORA, EMBEDDING = "LoRA", "textual inversion"

Model = Mapping[str, Any]  # path, kind, bytes, reason


class Models:
    """The found models; None until the core has been asked."""

    def __init__(self) -> None:
        self.found: Sequence[Model] | None = None
        self._task: Task | None = None

    @property
    def pending(self) -> bool:
        """Whether the core is looking."""
        return self._task is not None

    def look(self, core: Core, folder: Path | None = None) -> None:
        """Have the core look at the models' folder, and at another tool's; never blocks."""
        if self._task is None:
            self._task = Task("Models", lambda _progress: ask_all(core, folder))

    def tick(self) -> None:
        """Take an answer."""
        if self._task and not self._task.running:
            answer, self._task = self._task.result, None
            self.found = answer if isinstance(answer, list) else []


def ask_all(core: Core, folder: Path | None) -> list[Model]:
    """The models in the models' folder, and in another tool's if there is one."""
    return [*ask(core), *(ask(core, folder) if folder else ())]


def ask(core: Core, folder: Path | None = None) -> Any:
    """The core's answer for a folder, or for the models' own; an empty list where it gives none."""
    # Any Python will do, also before the installation: Blender's own.
    python = core.python if core.python.exists() else sys.executable
    try:
        done = subprocess.run(
            [str(python), "-m", "core", "models", "--json", *([str(folder)] if folder else [])],
            cwd=core.root,
            env=piped_environ() | dict(core.environ),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=TIMEOUT,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),  # Windows: no console opens
        )
        return json.loads(done.stdout)
    except (OSError, ValueError, subprocess.TimeoutExpired):
        return []


def usable(models: Sequence[Model]) -> list[Model]:
    """Those that can be used, checkpoints first."""
    fits = [model for model in models if not model["reason"]]
    return sorted(fits, key=lambda model: (model["kind"] in (LORA, EMBEDDING), model["path"]))


def label(model: Model) -> str:
    """A model in a menu: its name, kind and size."""
    path = Path(model["path"])
    # The hub's folders are named by a hash, in that of the model.
    named = next((p.name[8:] for p in path.parents if p.name.startswith("models--")), path.name)
    size = model["bytes"] / 1e9
    return f"{named.replace('--', '/')} ({model['kind']}, {size:.1f} GB)"
