"""One score distillation of a step's views (Eqs. 1, 5, 9), with all that is random in it."""

from collections.abc import Iterator
from dataclasses import dataclass, fields

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.camera import Cameras, sample_groups
from core.config import Config, PhaseConfig
from core.device import sent
from core.errors import UserError
from core.guidance.guidance import Views
from core.guidance.sds import Method, anneal, sample_t, sds_grad, sds_loss
from core.ranks import ALONE, Ranks
from core.stages.scene import portions
from core.stages.training import Setup


@dataclass(frozen=True)
class Draw:
    """All random numbers of one step, for each of its views.

    Drawn for all views at once and on the CPU: a run is then the same on every device, and however
    many views are rendered together.
    """

    cameras: Cameras
    t: Int[Tensor, " b"]
    eps: Float[Tensor, "b 4 s s"]
    # Of the coarse geometry only: turns of the normals, and where the samples of the rays are.
    rotations: Float[Tensor, "b 3 3"] | None = None
    ray_shift: Float[Tensor, "b r r"] | None = None
    # Of csd only, not random: the annealed weight of the negative prompt.
    negative: Float[Tensor, " b"] | None = None

    @classmethod
    def of(cls, setup: Setup, phase: PhaseConfig, progress: float) -> "Draw":
        """``progress``: of the phase, 0 to 1, for the annealing of t."""
        config, guidance = setup.config, setup.guidance
        views, size, generator = config.views, guidance.latent_size, setup.training.generator
        high = anneal(*phase.t_high, progress)
        # sdi follows one trajectory of DDIM from noise to picture: its t falls, and is not drawn.
        low = high if phase.distillation == "sdi" else phase.t_low
        negative = torch.full((views,), anneal(*phase.csd_negative, progress))
        together = guidance.views_together
        groups = views // together
        # The order is part of every result: a seed means this stream of numbers.
        return cls(
            sample_groups(views, together, config.cameras, generator),
            # Views that are denoised together are at one time.
            sample_t(groups, low, high, len(guidance.alpha_bar), generator).repeat_interleave(
                together
            ),
            torch.randn(views, 4, size, size, generator=generator),
            negative=negative if phase.distillation == "csd" else None,
        )

    def split(
        self, views_at_once: int, device: torch.device, ranks: Ranks = ALONE
    ) -> "Iterator[Draw]":
        """This process's views on ``device``, ``views_at_once`` at a time, the last part less."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        mine = {name: value[ranks.own] for name, value in values.items() if value is not None}
        for part in portions(len(mine["t"]), views_at_once):
            some = {name: value[part] for name, value in mine.items()}
            cameras = some.pop("cameras").to(device)
            yield Draw(cameras, **{name: sent(x, device) for name, x in some.items()})


def require_groups(config: Config, together: int, command: str) -> None:
    """Refuse settings that tear apart views which a guidance predicts together.

    Raises:
        UserError: the first of them, and what it takes.
    """
    stages = {"appearance": config.appearance}
    stages |= {"geometry": config.geometry} if command == "generate" else {}
    for stage, settings in stages.items() if together > 1 else ():
        for name in ("views", "views_at_once"):
            if (value := getattr(settings, name)) % together:
                raise UserError(
                    f"{stage}.{name} is {value}; this checkpoint predicts {together} views "
                    "together.",
                    f"Set it to a multiple of {together}, such as --set {stage}.{name}={together}.",
                )
        rounds = {name: getattr(settings, name, None) for name in ("grow", "refine")}
        for name, part in rounds.items():
            if part and part.rounds:
                raise UserError(
                    f"{stage}.{name} fits to single views; this checkpoint predicts {together} "
                    "together.",
                    f"Use --preset standard, or --set {stage}.{name}.rounds=0.",
                )


def distill(
    setup: Setup,
    phase: PhaseConfig,
    draw: Draw,
    z: Float[Tensor, "b 4 s s"],
    views: Views,
) -> tuple[Float[Tensor, ""], Float[Tensor, "b 4 s s"]]:
    """One step of the phase's distillation: a loss per pixel of ``z``, and its gradient there."""
    grad = sds_grad(
        setup.guidance,
        z,
        views,
        t=draw.t,
        eps=draw.eps.to(z),
        weighting=phase.weighting,
        guidance_scale=phase.guidance_scale,
        cap=setup.config.gradient_cap or None,
        method=Method(phase.distillation, draw.negative, phase.inversion_steps),
    )
    # Per pixel, so that a learning rate or a weight means the same at every size of the latent.
    grad = grad / (z.shape[-1] * z.shape[-2])
    return sds_loss(z, grad), grad
