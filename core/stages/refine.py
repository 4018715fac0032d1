"""Rounds of fitting, beyond the paper: to denoised pictures of the present shape.

Score distillation seeks one shape that suits every noise at once: thin parts, for each of which
every noise means another place, fade, planes stay dented and edges round. A round renders pictures
of the present shape, adds noise and removes it again (SDEdit: Meng et al. 2022), and fits to all of
them by plain regression (the dataset update of Instruct-NeRF2NeRF: Haque et al. 2023, §4.2).
"""

from dataclasses import dataclass, fields

import torch
from jaxtyping import Float
from torch import Tensor

from core.camera import Cameras, sample_cameras
from core.config import RefineConfig
from core.guidance.denoise import denoise
from core.guidance.guidance import PromptedGuidance, Views
from core.guidance.sds import add_noise, anneal
from core.ranks import ALONE, Ranks
from core.stages.scene import Scene, portions
from core.stages.training import Setup, fraction


@dataclass(frozen=True)
class Targets:
    """The pictures that one round is fitted to, as clean latents."""

    cameras: Cameras
    z: Float[Tensor, "b 4 s s"]

    def tensors(self) -> dict[str, Tensor]:
        """For a checkpoint."""
        return {"z": self.z} | self.cameras.tensors()

    @classmethod
    def of(cls, tensors: dict[str, Tensor]) -> "Targets":
        """Back from :meth:`tensors`."""
        names = tensors.keys() & {field.name for field in fields(Cameras)}
        return cls(Cameras(**{name: tensors[name] for name in names}), tensors["z"])

    def some(self, count: int, generator: torch.Generator) -> "Targets":
        """``count`` of them at random, all where there are fewer."""
        # On the CPU, as all random numbers: the same on every device.
        index = torch.randperm(len(self.z), generator=generator)[:count].to(self.z.device)
        return Targets(self.cameras[index], self.z[index])

    def split(self, views_at_once: int, ranks: Ranks = ALONE) -> "list[Targets]":
        """This process's views in parts of ``views_at_once``, the last one smaller."""
        cameras, z = self.cameras[ranks.own], self.z[ranks.own]
        return [Targets(cameras[part], z[part]) for part in portions(len(z), views_at_once)]


def round_targets(
    setup: Setup, rounds: RefineConfig, scene: Scene, label: str, **also: Tensor
) -> Targets:
    """The pictures of the round ``label``, such as "grow 2".

    Made at its first step, and kept in the checkpoints until its last, with ``also``.
    """
    kept = setup.training.kept(label)
    if kept:
        return Targets.of(kept)
    made = _targets(setup, rounds, scene, int(label.split()[1]))
    setup.training.keep(label, made.tensors() | also)
    return made


def _targets(setup: Setup, rounds: RefineConfig, scene: Scene, number: int) -> Targets:
    """Pictures of what there is, cleaned."""
    config, guidance, generator = setup.config, setup.guidance, setup.training.generator
    ranks = setup.ranks

    # PICTURES: of the present shape, all round; those of this process
    cameras = sample_cameras(rounds.views, config.cameras, generator).to(scene.device)
    mine = cameras[ranks.own]
    with torch.no_grad():
        parts = portions(len(mine), setup.at_once)
        seen = [scene.latents(mine[part], rounds.size) for part in parts]
    z = torch.cat([latents for latents, _ in seen])
    surfaces = [views.surface for _, views in seen if views.surface is not None]
    views = Views(mine, torch.cat(surfaces) if surfaces else None)

    clean = cleaned(z, guidance, views, rounds, number, generator=generator, ranks=ranks)
    return Targets(cameras, ranks.whole(clean, rounds.views))


def cleaned(
    z: Float[Tensor, "b 4 s s"],
    guidance: PromptedGuidance,
    views: Views,
    rounds: RefineConfig,
    number: int,
    *,
    generator: torch.Generator,
    ranks: Ranks = ALONE,
) -> Float[Tensor, "b 4 s s"]:
    """The pictures of the round ``number``, restored or denoised by the guidance.

    ``ranks``: those that have the round's other pictures.
    """
    # RESTORED: a guidance with its own network for it gets the pictures as they are
    if rounds.restore and (crisp := guidance.restore(z, views)) is not None:
        return crisp

    # NOISE: less from round to round: first for what is missing, at last for the details
    level = anneal(*rounds.t, fraction(number, rounds.rounds))
    t = min(round(level * len(guidance.alpha_bar)), len(guidance.alpha_bar) - 1)
    count = len(z) if ranks.world == 1 else rounds.views  # drawn for all of the round
    eps = torch.randn(count, *z.shape[1:], generator=generator)[ranks.own].to(z)
    z_t = add_noise(z, eps, guidance.alpha_bar.to(z)[t].expand(len(z)))

    # DENOISED: what the guidance means by them
    return denoise(guidance, z_t, t, views, rounds.guidance_scale, rounds.denoise_steps)


def fit_loss(z: Float[Tensor, "b 4 s s"], target: Float[Tensor, "b 4 s s"]) -> Float[Tensor, ""]:
    """The mean squared difference of each picture, summed over the pictures."""
    return (z - target).square().mean((1, 2, 3)).sum()
