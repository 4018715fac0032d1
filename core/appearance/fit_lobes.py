"""Fits the lobes of :mod:`core.appearance.lobes`; run once, its result is ``lobes.safetensors``.

    python -m core.appearance.fit_lobes

At each node of a grid over roughness and n·v, K von Mises-Fisher lobes in the plane of incidence
and one cosine lobe about the normal stand for the specular reflectance times n·l, as a function of
the light's direction. Places and widths are common to three Fresnel terms, weights are not.
"""

import math
from pathlib import Path
from typing import NamedTuple

import torch
from jaxtyping import Float
from safetensors.torch import save_file
from torch import Tensor

from core.appearance.brdf import (
    fresnel_dielectric,
    ggx_d,
    hammersley,
    schlick_weight,
    smith_g2,
    smith_lambda,
    visible_normals,
)

FILE = Path(__file__).with_name("lobes.safetensors")
LOBES = 6
ROUGHNESS = (0.05, 1.0, 14)  # first, last, number of nodes
ROOT_COS = (0.12, 1.0, 20)  # of sqrt(n·v), which spreads out the grazing angles
STEPS = 1500
SAMPLES = 256
# Share of the peak that is added to the density by which errors are divided: below it they count
# as absolute errors, above as relative ones.
FLOOR = 0.1
# Of the three Fresnel terms: what counts most in a picture.
KIND_WEIGHT = (1.0, 0.05, 0.3)
SMOOTHNESS = 0.02


class Target(NamedTuple):
    """The reflectance at C nodes and S directions, in the frame where v = (sin, 0, cos)."""

    light: Float[Tensor, "c s 3"]
    value: Float[Tensor, "c s 3"]  # for each Fresnel term, each with integral 1
    density: Float[Tensor, "c s"]  # of the directions
    peak: Float[Tensor, "c 1"]


def nodes() -> tuple[Float[Tensor, "c 1"], Float[Tensor, "c 1"]]:
    """Roughness and n·v at the grid's nodes, roughness slowest."""
    roughness, root = torch.meshgrid(
        torch.linspace(*ROUGHNESS), torch.linspace(*ROOT_COS), indexing="ij"
    )
    return roughness.reshape(-1, 1), root.reshape(-1, 1).square()


def target(cos_v: Float[Tensor, "c 1"], alpha: Float[Tensor, "c 1"]) -> Target:
    """Samples of the reflectance: mirrored visible normals, and the whole sphere evenly."""
    view = torch.stack([(1 - cos_v.square()).clamp(min=0).sqrt(), 0 * cos_v, cos_v], -1)
    h = visible_normals(cos_v, alpha, hammersley(SAMPLES))
    mirrored = 2 * (h * view).sum(-1, keepdim=True) * h - view
    u = hammersley(SAMPLES // 2)
    z, phi = 1 - 2 * u[:, 1], 2 * math.pi * u[:, 0]
    ring = (1 - z * z).sqrt()
    even = torch.stack([ring * phi.cos(), ring * phi.sin(), z], -1).expand(len(cos_v), -1, -1)
    light = torch.cat([mirrored, even], 1)

    h = torch.nn.functional.normalize(light + view, dim=-1)
    cos_h, cos_l, cos_d = h[..., 2], light[..., 2], (h * view).sum(-1).clamp(0, 1)
    d = ggx_d(cos_h, alpha) * (cos_h > 0) / (4 * cos_v)
    visible = d / (1 + smith_lambda(cos_v, alpha))
    density = (2 * visible + 1 / (4 * math.pi)) / 3
    value = d * smith_g2(cos_v, cos_l.clamp(min=1e-4), alpha) * (cos_l > 0)
    schlick = schlick_weight(cos_d)
    kinds = torch.stack([1 - schlick, schlick, fresnel_dielectric(cos_d)], -1) * value[..., None]
    total = (kinds / density[..., None]).mean(1, keepdim=True)
    return Target(light, kinds / total, density, visible.amax(1, keepdim=True))


class Mixture(NamedTuple):
    """K lobes and the cosine lobe at C nodes."""

    offset: Float[Tensor, "c k"]  # angle from the mirror direction, in alpha sin(v)
    log_width: Float[Tensor, "c k"]  # natural logarithm of the width, in alpha
    logits: Float[Tensor, "c k+1 3"]


def start(cos_v: Float[Tensor, "c 1"], alpha: Float[Tensor, "c 1"]) -> Mixture:
    """Lobes side by side, of mixed widths, narrower towards grazing."""
    spread = torch.linspace(-1.5, 1.5, LOBES)
    widths = torch.linspace(math.log(0.5), math.log(2), LOBES)
    widths = widths[torch.randperm(LOBES, generator=torch.Generator().manual_seed(3))]
    logits = torch.zeros(len(cos_v), LOBES + 1, 3)
    logits[:, LOBES] = torch.log(0.5 * alpha + 1e-3)
    return Mixture(
        spread.expand(len(cos_v), -1).clone(), widths + torch.log(0.25 + 0.75 * cos_v), logits
    )


def evaluate(
    mixture: Mixture, cos_v: Float[Tensor, "c 1"], alpha: Float[Tensor, "c 1"], goal: Target
) -> Float[Tensor, "c s 3"]:
    """The mixture at the goal's directions."""
    sin_v = (1 - cos_v.square()).clamp(min=0).sqrt()
    angle = torch.atan2(sin_v, cos_v) + alpha * sin_v * mixture.offset
    kappa = 1 / (alpha * mixture.log_width.exp()).clamp(3e-4, 1.5).square()[:, None]
    light = goal.light
    cos = -angle.sin()[:, None] * light[..., :1] + angle.cos()[:, None] * light[..., 2:]
    lobes = kappa / (2 * math.pi * (1 - torch.exp(-2 * kappa))) * torch.exp(kappa * (cos - 1))
    lobes = torch.cat([lobes, light[..., 2:].clamp(min=0) / math.pi], -1)
    return torch.bmm(lobes, mixture.logits.softmax(1))


def fit(steps: int = STEPS) -> Float[Tensor, "channels rows columns"]:
    """Offsets, log widths, and weights (kind slowest) over roughness (rows) and sqrt(n·v)."""
    roughness, cos_v = nodes()
    alpha = roughness.square()
    goal = target(cos_v, alpha)
    mixture = Mixture(*(x.requires_grad_() for x in start(cos_v, alpha)))
    rates = zip(mixture, (0.03, 0.04, 0.06), strict=True)
    optimizer = torch.optim.Adam([{"params": [x], "lr": rate} for x, rate in rates])
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, steps, eta_min=1e-4)
    scale = goal.density * (goal.density + FLOOR * goal.peak)
    for step in range(steps):
        error = (evaluate(mixture, cos_v, alpha, goal) - goal.value).square() / scale[..., None]
        loss = (error * torch.tensor(KIND_WEIGHT)).sum(-1).mean()
        grid = torch.cat([mixture[0], mixture[1], 0.3 * mixture[2].flatten(1)], 1)
        grid = grid.view(ROUGHNESS[2], ROOT_COS[2], -1)
        rough = grid.diff(dim=0).square().mean() + grid.diff(dim=1).square().mean()
        optimizer.zero_grad()
        (loss + SMOOTHNESS * rough).backward()
        optimizer.step()
        schedule.step()
        if step % 100 == 0 or step == steps - 1:
            print(f"step {step}: loss {float(loss.detach()):.4f}", flush=True)
    weights = mixture.logits.detach().softmax(1).transpose(1, 2).flatten(1)
    table = torch.cat([mixture.offset.detach(), mixture.log_width.detach(), weights], 1)
    return table.view(ROUGHNESS[2], ROOT_COS[2], -1).permute(2, 0, 1).contiguous()


def main() -> None:
    """Fits and writes the file beside this one."""
    save_file({"lobes": fit()}, FILE)


if __name__ == "__main__":
    main()
