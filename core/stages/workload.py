"""How long a run takes on a CPU, reported before it starts: a full-size checkpoint takes days."""

import time
from typing import Final, NamedTuple

import torch

from core.config import Config, PhaseConfig, RefineConfig
from core.guidance.guidance import Work

WORTH_TELLING: Final = 3600.0  # seconds
_TRIAL: Final = (320, 64)  # channels and side of a convolution as Stable Diffusion has them
_SLOWEST: Final = 1e9  # operations a second that every CPU reaches


class Calls(NamedTuple):
    """How often a run calls the guidance, counted in views."""

    predictions: int
    encodings: int  # with their gradient


def calls_of(config: Config, command: str) -> Calls:
    """The work of a whole run with ``config``."""
    g, a = config.geometry, config.appearance
    phases = [(a.early, a.views, True), (a.late, a.views, True)]
    rounds = [a.refine]
    if command == "generate":
        # The coarse phase's latent is the normals themselves: nothing is encoded (§4.2). A shaded
        # picture is.
        phases += [(g.coarse, g.views, g.pictures != "normals"), (g.fine, g.views, True)]
        rounds += [g.grow, g.refine]
    predictions = sum(phase.steps * views * _of_a_step(phase) for phase, views, _ in phases)
    encodings = sum(phase.steps * views for phase, views, encoded in phases if encoded)
    fits = [_of_rounds(refine) for refine in rounds]
    return Calls(
        predictions + sum(fit.predictions for fit in fits),
        encodings + sum(fit.encodings for fit in fits),
    )


def _of_a_step(phase: PhaseConfig) -> int:
    return 1 + (phase.inversion_steps if phase.distillation == "sdi" else 0)


def _of_rounds(refine: RefineConfig) -> Calls:
    """A round's pictures are denoised once; each of its steps encodes some of them again."""
    rounds = refine.rounds if refine.steps else 0  # a guide may leave a phase without steps
    fitted = refine.steps * min(refine.batch, refine.views)
    return Calls(rounds * refine.views * refine.denoise_steps, rounds * fitted)


def cpu_notice(work: Work | None, config: Config, command: str) -> str:
    """A sentence on the run's time on this CPU; empty where it is short."""
    if work is None:
        return ""
    calls = calls_of(config, command)
    total = calls.predictions * work.prediction + calls.encodings * work.encoding
    if total / _SLOWEST < WORTH_TELLING:  # nothing needs to be measured
        return ""
    speed = operations_per_second()
    seconds = total / speed
    if seconds < WORTH_TELLING:
        return ""
    view = (work.prediction + work.encoding) / speed
    return (
        f"On this CPU the run will take about {spoken(seconds)}: {calls.predictions:,} views to "
        f"predict, {calls.encodings:,} to encode, about {spoken(view)} each. Use a GPU "
        "(--device cuda), fewer steps or views, or the built-in model. It can be stopped and "
        "resumed at any time."
    )


def operations_per_second() -> float:
    """Floating-point operations of a convolution in a second on this CPU."""
    channels, side = _TRIAL
    x, w = torch.ones(1, channels, side, side), torch.ones(channels, channels, 3, 3)
    times = []
    for _ in range(3):
        start = time.perf_counter()
        torch.nn.functional.conv2d(x, w, padding=1)
        times.append(time.perf_counter() - start)
    return 2 * channels**2 * 9 * side**2 / min(times)


def spoken(seconds: float) -> str:
    """A time in its largest unit: "40 s", "5 minutes", "3 hours", "12 days"."""
    for length, unit in ((86400, "days"), (3600, "hours"), (60, "minutes")):
        if seconds >= 2 * length:
            return f"{seconds / length:.0f} {unit}"
    return f"{seconds:.0f} s"
