"""The paper's second training: Γ learns the material from shaded pictures (§4.3, Eqs. 6 to 9)."""

import math
from collections.abc import Iterator

import numpy as np
import torch
from jaxtyping import Float, UInt8
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.material import Material, MaterialNet
from core.appearance.occlusion import Openness
from core.appearance.shaded import Shaded, UvMesh, render_shaded
from core.camera import Cameras, sample_cameras
from core.config import AppearanceConfig
from core.guidance.guidance import PromptedGuidance, Views, coarse_latent
from core.guidance.sds import NotFiniteError
from core.io.run_folder import RunFolder, Training
from core.stages.distill import Draw, decayed, distill, phase_of
from core.stages.guard import Guard, healthy_gradients
from core.stages.preview import SIZE, VIEW, ColorPreview, over_grey
from core.stages.refine import Targets, denoised, fit_loss, refine_steps

SMOOTH_REACH = 0.01  # training units: how far apart "neighbouring points" are


def learn_appearance(
    net: MaterialNet,
    mesh: UvMesh,
    environment: Environment,
    guidance: PromptedGuidance,
    run: RunFolder,
    generator: torch.Generator,
) -> None:
    """Train Γ by score distillation on the finished shape."""
    config = net.config
    optimizer = torch.optim.AdamW(net.parameters(), betas=(0.9, 0.99), eps=1e-15, weight_decay=0.0)
    training = Training(run, "appearance", net, optimizer, generator)
    training.resume()
    guard, preview = Guard(training), ColorPreview(run)
    openness = Openness.of(mesh.verts, mesh.faces) if config.self_shadow else None
    distilling = config.early.steps + config.late.steps

    for step in run.steps("appearance", training.step, distilling + refine_steps(config.refine)):
        refining = step.index >= distilling
        for group in optimizer.param_groups:
            group["lr"] = guard.rate * learning_rate(config, step.index)
        optimizer.zero_grad()
        lit = environment.rotated(_turn(config, generator))
        shares = openness.shares(lit) if openness else None
        scene = Scene(net, mesh, lit, guidance, generator, shares)
        step.loss, trouble = 0.0, ""
        try:
            if refining:
                round, begun = divmod(step.index - distilling, config.refine.steps)
                if not begun or not training.kept:
                    training.kept = scene.targets(round).tensors()
                losses = scene.fitted(Targets.of(training.kept))
            else:
                losses = scene.distilled(step.index)
            for loss in losses:
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


def learning_rate(config: AppearanceConfig, index: int) -> float:
    """That of step ``index``: it falls to ``learning_rate_end`` twice, distilling and refining."""
    distilling, refining = config.early.steps + config.late.steps, refine_steps(config.refine)
    if index < distilling:
        share = index / max(distilling - 1, 1)
        return decayed(config.learning_rate, config.learning_rate_end, share)
    share = (index - distilling) / max(refining - 1, 1)
    return decayed(config.refine.learning_rate, config.learning_rate_end, share)


def _turn(config: AppearanceConfig, generator: torch.Generator) -> float:
    """A rotation of the light about the vertical, radians."""
    share = float(torch.rand(1, generator=generator))
    return 2 * math.pi * share if config.rotate_light else 0.0


class Scene:
    """The object under the light of one step, and who judges its pictures."""

    def __init__(
        self,
        net: MaterialNet,
        mesh: UvMesh,
        lit: Environment,
        guidance: PromptedGuidance,
        generator: torch.Generator,
        shares: Tensor | None = None,
    ) -> None:
        self.shares = shares  # of the light, that the object does not hide from itself
        self.net, self.mesh, self.lit = net, mesh, lit
        self.guidance, self.generator = guidance, generator
        self.config = net.config

    def distilled(self, index: int) -> Iterator[Tensor]:
        """Score distillation (Eq. 9) at step ``index``: the losses of its views, part by part."""
        config = self.config
        phase, share = phase_of(index, config.early, config.late)
        draw = Draw.of(config.views, config.cameras, self.guidance, phase, share, self.generator)
        for part in draw.split(config.views_at_once, self.mesh.verts.device):
            z, views, rough = self._latent(part.cameras, phase.size)
            loss, _ = distill(self.guidance, z, views, part, phase, config.gradient_cap)
            yield (loss + rough) / config.views

    def targets(self, round: int) -> Targets:
        """The pictures of a round of refining."""
        config, at_once = self.config.refine, self.config.views_at_once
        cameras = sample_cameras(config.views, self.config.cameras, self.generator)
        cameras = cameras.to(self.mesh.verts.device)
        with torch.no_grad():
            parts = [slice(k, k + at_once) for k in range(0, config.views, at_once)]
            seen = [self._latent(cameras[part], config.size) for part in parts]
        z = torch.cat([z for z, _, _ in seen])
        surface = torch.cat([views.surface for _, views, _ in seen])
        share = round / max(config.rounds - 1, 1)
        views = Views(cameras, surface)
        return denoised(z, self.guidance, views, config, share, self.generator)

    def fitted(self, targets: Targets) -> Iterator[Tensor]:
        """Regression to some of the round's pictures: the losses of these, part by part."""
        some = targets.some(self.config.refine.batch, self.generator)
        for part in some.split(self.config.views_at_once):
            z, _, rough = self._latent(part.cameras, self.config.refine.size)
            yield (fit_loss(z, part.z) + rough) / len(some.z)

    def _latent(self, cameras: Cameras, size: int) -> tuple[Tensor, Views, Tensor | float]:
        """The views' colours as latents, what the guidance may know of them, the regulariser."""
        shaded = render_shaded(self.mesh, self.net, cameras, size, self.lit, self.shares)
        z = self.guidance.encode_color(shaded.srgb, shaded.o)
        surface = surface_picture(shaded, self.guidance.latent_size)
        rough = 0.0
        if self.config.smooth > 0:
            change = _roughening(self.net, shaded.points, shaded.material, self.generator)
            rough = self.config.smooth * len(cameras) * change
        return z, Views(cameras, surface), rough


def surface_picture(shaded: Shaded, size: int) -> Float[Tensor, "b 7 {size} {size}"]:
    """[n, 2o - 1, p], area-downsampled: the geometry, for a guidance that can use it."""
    normals = coarse_latent(shaded.n, shaded.o, size)
    points = torch.nn.functional.adaptive_avg_pool2d(shaded.p.permute(0, 3, 1, 2), size)
    return torch.cat([normals, points], 1)


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
