"""The paper's second training: Γ learns the material from shaded pictures (§4.3, Eqs. 6 to 9)."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import torch
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.occlusion import VertexVisibility
from core.appearance.shaded import UvMesh
from core.config import AppearanceConfig, PhaseConfig
from core.guidance.sds import NotFiniteError
from core.io.progress import Progress
from core.stages.distill import Draw, distill
from core.stages.lit_scene import LitScene, roughening
from core.stages.refine import fit_loss, round_targets
from core.stages.room import LIT
from core.stages.training import Phase, Setup, decayed, fraction, train

ColorSetup = Setup[MaterialNet, AppearanceConfig]


def learn_appearance(
    setup: ColorSetup,
    mesh: UvMesh,
    environment: Environment,
    progress: Progress,
    *,
    early: bool = False,
) -> None:
    """Train Γ by score distillation on the finished shape.

    ``early``: only so far that one sees the colours, which are then the preview too.
    """
    setup.training.resume()
    config = setup.config
    setup.fit(LIT, (config.early.size, config.late.size, config.refine.size))
    # Once: the shape is final, only the light turns.
    visibility = VertexVisibility.of(mesh.verts, mesh.faces) if config.self_shadow else None
    subject = LitObject(mesh, environment, visibility)
    stop = early_steps(config) if early else None
    train(setup, appearance_phases(setup, subject), progress, stop=stop)
    if early:
        subject.scene(setup).show(setup.training.run)


def early_steps(config: AppearanceConfig) -> int:
    """Steps after which the colours are there: distilling's, and one round of refining."""
    return (
        config.early.steps + config.late.steps + min(1, config.refine.rounds) * config.refine.steps
    )


@dataclass(frozen=True)
class LitObject:
    """The object and its light, before the turn that a step gives to the light."""

    mesh: UvMesh
    environment: Environment
    visibility: VertexVisibility | None  # what the object hides from itself; None: nothing

    def scene(self, setup: ColorSetup) -> LitScene:
        """The object in the light of one step."""
        # Turned at random, or the light's own brightness would end up in kd.
        turn = 2 * math.pi * float(torch.rand(1, generator=setup.training.generator))
        lit = self.environment.rotated(turn if setup.config.rotate_light else 0.0)
        occlusion = self.visibility.occlusion(lit) if self.visibility else None
        net, guidance = setup.training.module, setup.guidance
        return LitScene(net, self.mesh, lit, guidance, still=self.environment, occlusion=occlusion)


def appearance_phases(setup: ColorSetup, subject: LitObject) -> list[Phase]:
    """The appearance's phases in their order."""
    return [
        # Much noise, and w(t) = σ² sqrt(1 - σ²): the colours of the parts (§4.3).
        Distillation(setup, subject, "early", before=0),
        # w(t) = 1 / σ²: little noise counts most, for the details.
        Distillation(setup, subject, "late", before=setup.config.early.steps),
        # Beyond the paper: regression takes the guidance's excess of colour out again.
        Fitting(setup, subject),
    ]


class Distillation(Phase):
    """Score distillation from shaded pictures (Eq. 9): the phases ``early`` and ``late``."""

    def __init__(self, setup: ColorSetup, subject: LitObject, name: str, before: int) -> None:
        """``before``: steps of distillation in earlier phases; the rate falls over them all."""
        self.setup, self.subject, self.name, self.before = setup, subject, name, before
        self.phase: PhaseConfig = getattr(setup.config, name)
        self.steps = self.phase.steps

    def learning_rate(self, index: int) -> float:
        """It falls over both phases together."""
        config = self.setup.config
        progress = fraction(self.before + index, config.early.steps + config.late.steps)
        return decayed(config.learning_rate, config.learning_rate_end, progress)

    def begin(self, index: int) -> tuple[LitScene, Iterator[Tensor]]:
        """The object in a light, and the losses of its views."""
        scene = self.subject.scene(self.setup)
        return scene, self._losses(scene, index)

    def _losses(self, scene: LitScene, index: int) -> Iterator[Tensor]:
        setup, config = self.setup, self.setup.config
        draw = Draw.of(setup, self.phase, fraction(index, self.steps))
        failure: NotFiniteError | None = None
        try:
            for part in draw.split(setup.at_once, scene.device, setup.ranks):
                z, views = scene.latents(part.cameras, self.phase.size)
                yield distill(setup, self.phase, part, z, views)[0] / config.views
        except NotFiniteError as error:
            failure = error
        # Last: it takes the points that the views above have seen. In any case: it counts those of
        # all processes, which wait for this one's.
        yield from roughening(scene, setup.training.generator, config.views, setup.ranks)
        if failure:
            raise failure


class Fitting(Phase):
    """Rounds of fitting to denoised pictures: the phase ``refine``."""

    name = "refine"

    def __init__(self, setup: ColorSetup, subject: LitObject) -> None:
        self.setup, self.subject, self.rounds = setup, subject, setup.config.refine
        self.steps = self.rounds.rounds * self.rounds.steps

    def learning_rate(self, index: int) -> float:
        """It falls once more: at the full rate, the turns of the light leave noise in kd."""
        end, progress = self.setup.config.learning_rate_end, fraction(index, self.steps)
        return decayed(self.rounds.learning_rate, end, progress)

    def begin(self, index: int) -> tuple[LitScene, Iterator[Tensor]]:
        """The object in a light, and the losses of some of the round's pictures."""
        scene = self.subject.scene(self.setup)
        return scene, self._losses(scene, f"{self.name} {index // self.rounds.steps}")

    def _losses(self, scene: LitScene, label: str) -> Iterator[Tensor]:
        setup, rounds, generator = self.setup, self.rounds, self.setup.training.generator
        # A part of the round's pictures in each step: the light turns between steps, the targets
        # stay.
        some = round_targets(setup, rounds, scene, label).some(rounds.batch, generator)
        for part in some.split(setup.at_once, setup.ranks):
            z, _ = scene.latents(part.cameras, rounds.size)
            yield fit_loss(z, part.z) / len(some.z)
        yield from roughening(scene, generator, len(some.z), setup.ranks)
