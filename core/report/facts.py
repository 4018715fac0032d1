"""The facts in a run folder: job, settings, curves, film, warnings, health, timings."""

import dataclasses
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from core.errors import UserError
from core.io.input_file import own_file
from core.io.job import LAST, Job, read_events
from core.io.json_file import read_object
from core.io.run_folder import RunFolder
from core.job_config import config_of
from core.settings import setting_names

REMAKE = "Make the asset again, or report on another run."
STAGES = ("fit", "geometry", "sharpen", "start", "unwrap", "appearance", "bake")


@dataclass(frozen=True)
class Curve:
    """The reports of one stage, by step; a step that was taken twice counts once, the last time."""

    stage: str
    loss: dict[int, float] = field(default_factory=dict)
    coverage: dict[int, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Facts:
    """A run, as far as it has come."""

    folder: Path
    job: Job
    settings: dict[str, Any]  # all of them, as they were in force
    end: str  # one of LAST, or "running or broken off"
    sessions: int
    curves: list[Curve]
    warnings: list[str]
    film: list[tuple[str, Path]]  # stage and picture, in the order of time
    asset: dict[str, Any]  # asset.json; empty where there is none yet
    seconds: dict[str, float]  # by stage

    @property
    def glb(self) -> bytes:
        """The asset's file for the viewer; empty without an asset.

        Raises UserError for an asset whose file is not there or no GLB.
        """
        if not self.asset:
            return b""
        path = own_file(self.folder / "asset" / "asset.glb", self.folder, REMAKE)
        data = path.read_bytes() if path.is_file() else b""
        if data[:4] != b"glTF":
            raise UserError(f"{path} is not a GLB file.", REMAKE)
        return data


def facts_of(folder: Path) -> Facts:
    """Read a run folder; UserError for one that is none or holds what no run has written."""
    run = RunFolder.open(folder)
    job, events, found = run.job, _events(folder), folder / "asset" / "asset.json"
    asset = read_object(own_file(found, folder, REMAKE), REMAKE) if found.is_file() else {}
    ends = [event["type"] for event in events if event["type"] in LAST]
    return Facts(
        folder,
        job,
        _settings(job),
        ends[-1] if ends and events[-1]["type"] in LAST else "running or broken off",
        sum(event["type"] == "started" for event in events),
        _curves(events),
        [f"{e.get('text')} {e.get('fix') or ''}".strip() for e in events if e["type"] == "warning"],
        [(stage, own_file(path, folder, REMAKE)) for stage, path in _film(folder / "preview")],
        asset,
        _seconds(asset, events),
    )


def _events(folder: Path) -> list[dict[str, Any]]:
    try:
        events = read_events(folder)
    except ValueError:
        events = [None]
    if not all(map(_is_event, events)):
        raise UserError(f"{folder / 'events.jsonl'} holds a line that is not an event.", REMAKE)
    return events


def _is_event(event: Any) -> bool:
    return (
        isinstance(event, dict)
        and isinstance(event.get("time"), int | float)
        and isinstance(event.get("type"), str)
    )


def _settings(job: Job) -> dict[str, Any]:
    config, values = config_of(job), {}
    for key in setting_names(config):
        value: Any = config
        for name in key.split("."):
            value = getattr(value, name)
        values[key] = ", ".join(map(str, value)) if isinstance(value, tuple) else value
    return values


def _curves(events: list[dict[str, Any]]) -> list[Curve]:
    curves: dict[str, Curve] = {}
    for event in events:
        stage, step = event.get("stage"), event.get("step")
        if event["type"] != "progress" or not isinstance(stage, str) or not isinstance(step, int):
            continue
        curve = curves.setdefault(stage, Curve(stage))
        for name in ("loss", "coverage"):
            if isinstance(event.get(name), int | float):
                getattr(curve, name)[step] = float(event[name])
    return [curve for curve in curves.values() if curve.loss or curve.coverage]


def _film(folder: Path) -> list[tuple[str, Path]]:
    """The kept frames; of a run without any, the last preview of each stage."""
    frames = sorted((folder / "film").glob("*.png"), key=lambda path: path.stem.split("-")[-1])
    if frames:
        return [(path.stem.split("-")[0], path) for path in frames]
    last = (("geometry", "normals.png"), ("appearance", "color.png"))
    return [(stage, folder / name) for stage, name in last if (folder / name).is_file()]


def _seconds(asset: dict[str, Any], events: list[dict[str, Any]]) -> dict[str, float]:
    """The asset's own timings, which leave out breaks; else from the events of each stage."""
    timings = asset.get("timings")
    if isinstance(timings, dict):
        return {str(k): float(v) for k, v in timings.items() if isinstance(v, int | float)}
    times: dict[str, list[float]] = {}
    for event in events:
        if event["type"] == "progress" and isinstance(event.get("stage"), str):
            times.setdefault(event["stage"], []).append(float(event["time"]))
    return {stage: round(max(t) - min(t), 1) for stage, t in times.items()}


def fields_of(job: Job) -> dict[str, Any]:
    """The job's own fields, without those that were left as they are."""
    shown = {}
    for f in dataclasses.fields(job):
        value = getattr(job, f.name)
        plain = None if f.default is dataclasses.MISSING else f.default
        if f.name not in ("version", "settings") and value != plain:
            shown[f.name] = value
    return shown | job.settings
