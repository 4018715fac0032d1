"""The run folder: events, previews, checkpoints, and the wish to cancel (docs/architecture.md)."""

import json
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save_file
from torch import Tensor
from tqdm import tqdm

from core.errors import Cancelled, UserError
from core.io.atomic import atomic_file
from core.io.job import EventWriter, Job, write_text

CHECKPOINT_SECONDS = 20.0  # between two checkpoints on disk
PREVIEW_SECONDS = 2.0
PROGRESS_SECONDS = 0.2
FILE_MANAGERS = (".DS_Store", "Thumbs.db", "desktop.ini")  # their traces leave a folder empty


class RunFolder:
    """One run. Everything it writes appears whole: written aside, then renamed."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.events = EventWriter(path)
        self.timings: dict[str, float] = {}  # seconds by stage, those of earlier sessions included
        self._interrupted = False
        self._told = 0.0

    @classmethod
    def create(cls, path: Path, job: Job) -> "RunFolder":
        """A new run folder with its job.json.

        Raises:
            UserError: the folder holds another run or other files, or can't be written.
        """
        if (path / "job.json").exists():
            raise UserError(
                f"{path} holds a run already.",
                f"Take another --out, or go on with it: run.py resume {path}",
            )
        try:
            path.mkdir(parents=True, exist_ok=True)
            found = sorted(x.name for x in path.iterdir() if x.name not in FILE_MANAGERS)
            if found:
                raise UserError(
                    f"{path} is not empty: it holds {', '.join(found[:3])}"
                    f"{' and more' if len(found) > 3 else ''}.",
                    "A run needs a folder of its own: choose a new or an empty --out.",
                )
            write_text(path / "job.json", job.to_json())
        except OSError as error:
            raise UserError(
                f"{path} can't be written ({error.strerror}).", "Take another --out."
            ) from None
        return cls(path)

    @classmethod
    def open(cls, path: Path) -> "RunFolder":
        """An earlier run folder."""
        if not (path / "job.json").is_file():
            raise UserError(f"{path} is no run folder: it has no job.json.", "Start a new run.")
        return cls(path)

    @property
    def job(self) -> Job:
        """What the user asked for."""
        return Job.from_json((self.path / "job.json").read_text(encoding="utf-8"))

    @property
    def asset(self) -> Path:
        """The asset folder; it exists when it is complete."""
        return self.path / "asset"

    def say(self, type: str, **fields: Any) -> None:
        """Write one event; warnings go to the terminal too."""
        self.events.write(type, **fields)
        if type == "warning":
            tqdm.write(f"warning: {fields['text']} {fields.get('fix') or ''}".rstrip())

    def interrupt(self) -> None:
        """Ask for a stop after this step, as the file ``cancel`` does."""
        self._interrupted = True

    @property
    def cancelled(self) -> bool:
        """Whether somebody asked for a stop."""
        return self._interrupted or (self.path / "cancel").exists()

    def check_cancelled(self) -> None:
        """Raise Cancelled where somebody asked for a stop."""
        if self.cancelled:
            raise Cancelled("Cancelled.", f"Go on with it: run.py resume {self.path}")

    def steps(self, stage: str, first: int, steps: int) -> "Iterator[Step]":
        """The steps ``first`` to ``steps - 1`` of a stage, with progress on the way."""
        bar = tqdm(total=steps, initial=first, desc=stage, mininterval=0.5, disable=None)
        start, seen, tenth = time.perf_counter(), self.timings.get(stage, 0.0), -1
        with bar:
            for index in range(first, steps):
                step = Step(index, steps)
                yield step
                spent = time.perf_counter() - start
                self.timings[stage] = seen + spent
                left = spent / (index + 1 - first) * (steps - index - 1)
                self.tell(stage, index + 1, steps, step.loss, left)
                bar.update()
                if bar.disable and (index + 1) * 10 // steps > tenth:
                    tenth = (index + 1) * 10 // steps
                    print(f"{stage} {index + 1}/{steps}, {left:.0f} s left", flush=True)

    def advance(self, stage: str, step: int, steps: int) -> None:
        """Tell how far a stage is, and stop it where the user asks for it."""
        self.check_cancelled()
        self.tell(stage, step, steps)

    def tell(
        self,
        stage: str,
        step: int,
        steps: int,
        loss: float | None = None,
        seconds_left: float | None = None,
    ) -> None:
        """A progress event, if the last one is old enough or the stage has ended."""
        now = time.perf_counter()
        if now - self._told < PROGRESS_SECONDS and step < steps:
            return
        self._told = now
        self.say(
            "progress",
            stage=stage,
            step=step,
            steps=steps,
            loss=None if loss is None or loss != loss else round(loss, 5),
            seconds_left=None if seconds_left is None else round(seconds_left, 1),
        )

    @contextmanager
    def timed(self, stage: str) -> Iterator[None]:
        """Adds the time within to the stage's; says on the terminal what goes on."""
        print(f"{stage} …", flush=True)
        start = time.perf_counter()
        yield
        self.timings[stage] = self.timings.get(stage, 0.0) + time.perf_counter() - start

    def has(self, name: str) -> bool:
        """Whether there is a checkpoint of that name."""
        return (self.path / "checkpoint" / f"{name}.safetensors").exists()

    def preview_path(self, name: str) -> Path:
        """Where the preview ``name`` goes; its writer writes it whole."""
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
        with atomic_file(path) as aside:
            try:
                save_file(values, aside, metadata={"meta": json.dumps(meta)})
            except SafetensorError as error:  # it wraps what the disk said
                raise UserError(f"{path} was not written: {error}.", "Make room.") from None
            with aside.open("rb+") as file:
                os.fsync(file.fileno())  # a checkpoint survives a power cut

    def load(self, name: str) -> tuple[dict[str, Tensor], dict[str, Any]] | None:
        """A checkpoint's tensors and meta; None where there is none."""
        path = self.path / "checkpoint" / f"{name}.safetensors"
        if not path.exists():
            return None
        try:
            with safe_open(path, "pt") as file:
                meta = json.loads((file.metadata() or {})["meta"])
                tensors = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
        except (SafetensorError, KeyError, ValueError):
            raise UserError(
                f"{path} is broken.", "Remove it: the stage then starts anew on resume."
            ) from None
        self.timings |= meta["timings"]
        return tensors, meta


class Step:
    """One step of a stage: its place, and the loss that the progress shows."""

    def __init__(self, index: int, steps: int) -> None:
        self.index = index
        self.share = index / max(steps - 1, 1)  # 0 at the first step, 1 at the last
        self.last = index + 1 == steps
        self.loss: float | None = None


class Training:
    """What a training needs to go on where it stopped: parameters, optimiser, randomness, step."""

    def __init__(
        self,
        run: RunFolder,
        name: str,
        module: torch.nn.Module,
        optimizer: torch.optim.Optimizer,
        generator: torch.Generator,
    ) -> None:
        self.run, self.name = run, name
        self.module, self.optimizer, self.generator = module, optimizer, generator
        self.step = 0  # the next one
        self.extra: dict[str, Any] = {}  # small JSON values of the stage
        self.kept: dict[str, Tensor] = {}  # tensors of the stage
        self._saved = time.perf_counter()

    def state(self) -> dict[str, Tensor]:
        """All tensors of the training, by name; copies."""
        tensors = {f"module.{k}": v for k, v in self.module.state_dict().items()}
        for i, p in enumerate(p for g in self.optimizer.param_groups for p in g["params"]):
            for key, value in self.optimizer.state.get(p, {}).items():
                tensors[f"optimizer.{i}.{key}"] = torch.as_tensor(value)
        tensors |= {f"kept.{key}": value for key, value in self.kept.items()}
        tensors["generator"] = self.generator.get_state()
        return {key: value.detach().clone() for key, value in tensors.items()}

    def set_state(self, tensors: dict[str, Tensor]) -> None:
        """Put a :meth:`state` back."""
        split: dict[str, dict[str, Tensor]] = {"module": {}, "optimizer": {}, "kept": {}}
        for key, value in tensors.items():
            if key != "generator":
                kind, name = key.split(".", 1)
                split[kind][name] = value
        self.module.load_state_dict(split["module"])
        device = next(self.module.parameters()).device
        self.kept = {key: value.to(device) for key, value in split["kept"].items()}
        self.optimizer.state.clear()
        parameters = [p for g in self.optimizer.param_groups for p in g["params"]]
        for key, value in split["optimizer"].items():
            i, name = key.split(".", 1)
            p = parameters[int(i)]
            # AdamW counts its steps on the CPU.
            self.optimizer.state[p][name] = value.clone().to("cpu" if name == "step" else p.device)
        self.generator.set_state(tensors["generator"])

    def resume(self) -> None:
        """Take up the checkpoint, where there is one."""
        found = self.run.load(self.name)
        if found is None:
            return
        tensors, meta = found
        self.set_state(tensors)
        self.step, self.extra = meta["step"], meta["extra"]

    def checkpoint(self, next_step: int, force: bool = False) -> None:
        """Write a checkpoint now and then, or at once."""
        self.step = next_step
        now = time.perf_counter()
        if force or now - self._saved >= CHECKPOINT_SECONDS:
            self.run.save(self.name, self.state(), {"step": next_step, "extra": self.extra})
            self._saved = now
