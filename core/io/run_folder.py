"""A run on disk: its job, events, previews, checkpoints and asset (docs/architecture.md)."""

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor
from tqdm import tqdm

from core.errors import UserError
from core.io.atomic import OURS, atomic_file, left_over
from core.io.input_file import check_file, check_name, check_size
from core.io.job import EventWriter, Job, write_text
from core.io.json_file import read_object

# What file managers leave in a folder that a user takes for empty.
FILE_MANAGERS = (".DS_Store", "Thumbs.db", "desktop.ini")

# Where a killed session may leave the temporary file of a job, a checkpoint, a preview, a frame.
WRITTEN_INTO = ("", "checkpoint", "preview", "preview/film")

MAX_CHECKPOINT = 4 << 30  # bytes
REMOVE = "Remove it: on resume the stage then starts again."


class RunFolder:
    """One run. Every file appears whole: written to a temporary file, then renamed."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.events = EventWriter(path)
        # Seconds by stage. They are in every checkpoint, so earlier sessions are included.
        self.timings: dict[str, float] = {}
        # Radians about +Z by which its guide is turned; the previews are turned back.
        self.turn = 0.0
        # The asset's longest side in metres, where the guidance gives it.
        self.size_m: float | None = None

    @classmethod
    def create(cls, path: Path, job: Job) -> "RunFolder":
        """A new run folder with its job.json.

        Raises:
            UserError: the folder holds another run or other files, can't be written, or has a name
                that is not text.
        """
        check_name(path)
        if (path / "job.json").exists():
            raise UserError(
                f"{path} holds a run already.",
                f"Use another --out, or continue that run: run.py resume {path}",
            )
        try:
            path.mkdir(parents=True, exist_ok=True)
            # A process that was killed while it wrote job.json leaves a temporary file.
            names = {x.name for x in path.iterdir() if not OURS.fullmatch(x.name)}
            found = sorted(names.difference(FILE_MANAGERS))
            if found:
                raise UserError(
                    f"{path} is not empty: it holds {', '.join(found[:3])}"
                    f"{' and more' if len(found) > 3 else ''}.",
                    "A run needs a folder of its own: choose a new or an empty --out.",
                )
            write_text(path / "job.json", job.to_json())
        except OSError as error:
            raise UserError(
                f"{path} can't be written ({error.strerror}).", "Use another --out."
            ) from None
        return cls(path)

    @classmethod
    def open(cls, path: Path) -> "RunFolder":
        """An earlier run folder."""
        check_name(path)
        if not (path / "job.json").is_file():
            raise UserError(f"{path} is not a run folder: it has no job.json.", "Start a new run.")
        return cls(path)

    def remove_half_written(self) -> None:
        """Remove the temporary files that a killed process left in our own folders."""
        with suppress(OSError):  # they harm nobody; the next session tries again
            for half in [x for name in WRITTEN_INTO for x in left_over(self.path / name)]:
                if half.is_file():  # a half-written asset goes where the next one is written
                    half.unlink()

    @property
    def job(self) -> Job:
        """The user's job."""
        return Job.from_object(read_object(self.path / "job.json", "Start a new run."))

    @property
    def asset(self) -> Path:
        """The asset folder; it exists when it is complete."""
        return self.path / "asset"

    def report(self, type: str, **fields: Any) -> None:
        """Write one event; warnings go to the terminal too."""
        self.events.write(type, **fields)
        if type == "warning":
            with suppress(OSError):  # nobody reads it
                tqdm.write(f"warning: {fields['text']} {fields.get('fix') or ''}".rstrip())

    def has(self, name: str) -> bool:
        """Whether there is a checkpoint of that name."""
        return self._checkpoint(name).is_file()

    def preview_path(self, name: str) -> Path:
        """The file of the preview ``name``; who writes it renames a temporary file to it."""
        folder = self.path / "preview"
        folder.mkdir(exist_ok=True)
        return folder / name

    def save(self, name: str, tensors: dict[str, Tensor], meta: dict[str, Any]) -> None:
        """Write ``checkpoint/NAME.safetensors``, its ``meta`` as JSON inside."""
        folder = self.path / "checkpoint"
        folder.mkdir(exist_ok=True)
        meta = meta | {"timings": self.timings}
        values = {key: value.detach().cpu().contiguous() for key, value in tensors.items()}
        path = folder / f"{name}.safetensors"
        # Not the library's save_file: it writes to a hidden temporary file of its own, which a kill
        # would leave behind.
        content = save(values, metadata={"meta": json.dumps(meta)})
        with atomic_file(path) as temporary, temporary.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())  # a checkpoint survives a power cut

    def load(self, name: str) -> tuple[dict[str, Tensor], dict[str, Any]] | None:
        """A checkpoint's tensors and meta; None where there is none."""
        path = self._checkpoint(name)
        if not path.exists():
            return None
        check_file(path, fix=REMOVE)
        check_size(path, MAX_CHECKPOINT, REMOVE)
        with self.whole_checkpoint(name), safe_open(path, "pt") as file:
            meta = json.loads((file.metadata() or {})["meta"])
            tensors = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
            self.timings |= {str(key): float(value) for key, value in meta["timings"].items()}
        return tensors, meta

    @contextmanager
    def whole_checkpoint(self, name: str) -> Iterator[None]:
        """Turn what a broken checkpoint makes its reader raise into a UserError that names it."""
        try:
            yield
        # Also of what is whole and means nothing: names, shapes and types that no run of ours has.
        except (AttributeError, LookupError, OverflowError, RecursionError, RuntimeError,
                SafetensorError, TypeError, ValueError) as error:  # fmt: skip
            raise UserError(
                f"{self._checkpoint(name)} is broken.",
                REMOVE,
            ) from error

    def _checkpoint(self, name: str) -> Path:
        return self.path / "checkpoint" / f"{name}.safetensors"
