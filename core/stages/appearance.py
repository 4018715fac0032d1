"""The paper's second training: Γ learns the material from shaded pictures (§4.3, Eqs. 6 to 9)."""

import math

import numpy as np
import torch
from jaxtyping import UInt8
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.material import Material, MaterialNet
from core.camera import Cameras
from core.config import AppearanceConfig, PhaseConfig
from core.guidance.guidance import Embedding, Guidance, Views, coarse_latent
from core.guidance.sds import NotFiniteError
from core.render.shaded import UvMesh, render_shaded
from core.run_folder import RunFolder, Training
from core.stages.distill import Draw, decayed, distill, phase_of
from core.stages.guard import Guard, healthy_gradients
from core.stages.preview import SIZE, VIEW, ColorPreview, over_grey

SMOOTH_REACH = 0.01  # training units: how far apart "neighbouring points" are


def learn_appearance(
    net: MaterialNet,
    mesh: UvMesh,
    environment: Environment,
    guidance: Guidance,
    embedding: Embedding,
    run: RunFolder,
    generator: torch.Generator,
) -> None:
    """Train Γ by score distillation on the finished shape."""
    config = net.config
    optimizer = torch.optim.AdamW(net.parameters(), betas=(0.9, 0.99), eps=1e-15, weight_decay=0.0)
    training = Training(run, "appearance", net, optimizer, generator)
    training.resume()
    guard, preview = Guard(training), ColorPreview(run)
    steps = config.early.steps + config.late.steps

    for step in run.steps("appearance", training.step, steps):
        phase, share = phase_of(step.index, config.early, config.late)
        rate = decayed(config.learning_rate, config.learning_rate_end, step.share) * guard.rate
        for group in optimizer.param_groups:
            group["lr"] = rate
        optimizer.zero_grad()
        lit = environment.rotated(_turn(config, generator))
        draw = Draw.of(config.views, config.cameras, guidance, phase, share, generator)
        step.loss, trouble = 0.0, ""
        try:
            for part in draw.split(config.views_at_once, mesh.verts.device):
                loss = _view_loss(net, mesh, lit, guidance, embedding, part, phase, generator)
                loss = loss / config.views
                loss.backward()
                step.loss += loss.item()
        except NotFiniteError as error:
            trouble = error.text
        if trouble or not healthy_gradients(net):
            guard.recover(trouble or "The gradient was not finite")
            continue
        guard.remember(step.index)
        optimizer.step()
        if preview.due:
            preview.show(picture_of(net, mesh, environment))
        training.checkpoint(step.index + 1, force=run.cancelled or step.last)
        run.check_cancelled()


def _turn(config: AppearanceConfig, generator: torch.Generator) -> float:
    """A rotation of the light about the vertical, radians."""
    share = float(torch.rand(1, generator=generator))
    return 2 * math.pi * share if config.rotate_light else 0.0


def _view_loss(
    net: MaterialNet,
    mesh: UvMesh,
    lit: Environment,
    guidance: Guidance,
    embedding: Embedding,
    draw: Draw,
    phase: PhaseConfig,
    generator: torch.Generator,
) -> Tensor:
    cameras = draw.cameras
    shaded = render_shaded(mesh, net, cameras, phase.size, lit)
    z = guidance.encode_color(shaded.srgb, shaded.o)
    normals = coarse_latent(shaded.n, shaded.o, guidance.latent_size)
    views, cap = Views(cameras, normals), net.config.gradient_cap
    loss, _ = distill(guidance, z, embedding, views, draw, phase, cap)
    if net.config.smooth > 0:
        loss = loss + net.config.smooth * len(cameras) * _roughening(
            net, shaded.points, shaded.material, generator
        )
    return loss


def _roughening(
    net: MaterialNet, points: Tensor, material: Material, generator: torch.Generator
) -> Tensor:
    """Mean change of the material over a short way."""
    way = torch.randn(points.shape, generator=generator).to(points) * SMOOTH_REACH
    there = net(points + way)
    return sum((a - b).abs().mean() for a, b in zip(material, there, strict=True))


@torch.no_grad()
def picture_of(
    net: MaterialNet, mesh: UvMesh, environment: Environment, size: int = SIZE
) -> UInt8[np.ndarray, "{size} {size} 3"]:
    """The asset from a fixed side, as it is lit."""
    cameras = Cameras.orbit(**VIEW).to(mesh.verts.device)
    shaded = render_shaded(mesh, net, cameras, size, environment)
    return over_grey(shaded.srgb[0], shaded.o[0])
