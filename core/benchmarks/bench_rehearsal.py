"""``bench guidance --architecture NAME``: the paper's steps with a network of random weights.

What a step costs does not depend on the weights: so a machine can be measured, and the whole
schedule foretold, before a checkpoint of gigabytes is there.
"""

import json
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import torch
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.shaded import UvMesh, render_shaded
from core.benchmarks import ball, machine, row, table_line, wall_ms
from core.camera import Cameras, sample_cameras
from core.config import PAPER, Config
from core.device import device_of
from core.errors import UserError
from core.geometry.init_shape import ellipsoid, fit
from core.geometry.mesh import Mesh
from core.geometry.sdf_net import FOURIER
from core.geometry.tet_grid import tet_grid
from core.guidance.guidance import Views
from core.guidance.stable_diffusion import libraries
from core.guidance.stable_diffusion.checkpoint import read_json
from core.guidance.stable_diffusion.clip_files import CONFIGURATIONS
from core.guidance.stable_diffusion.conditions import takes_pooled
from core.guidance.stable_diffusion.guidance import PromptedStableDiffusion, StableDiffusion
from core.guidance.stable_diffusion.multi_view import MultiViewUNet
from core.guidance.stable_diffusion.multi_view_names import TOGETHER
from core.guidance.stable_diffusion.multi_view_names import unet_config as of_multi_view
from core.guidance.stable_diffusion.networks import Networks
from core.guidance.stable_diffusion.texts import Encoder
from core.io.job import Job
from core.io.progress import Step
from core.io.run_folder import RunFolder
from core.stages.appearance import LitObject, appearance_phases
from core.stages.geometry import geometry_phases
from core.stages.start_shape import sdf_net
from core.stages.state import Training
from core.stages.training import Phase, Setup, gradient_of

TOKENS = 77
STEPS = 3  # of each phase that are timed, after one that is not
FIT_STEPS = 40  # of the shape
FACES = 20_000  # of the mesh that the appearance is learned on
PHASES = ("coarse", "fine", "appearance")
# The shipped configuration of each architecture.
ARCHITECTURES = {"sd15": "sd15", "sd21": "sd21_base", "sdxl": "sdxl", "mvdream": "mvdream"}
SCALES = ("full", "tiny")


@dataclass(frozen=True)
class Rehearsal:
    """The settings of a rehearsal."""

    architecture: str
    scale: str = "full"
    batch: int = 24  # views of a step
    chunk: int = 4  # pictures that go through a network at a time
    device: str = "auto"

    def __post_init__(self) -> None:
        for name, known in (("architecture", ARCHITECTURES), ("scale", SCALES)):
            if getattr(self, name) not in known:
                raise UserError(
                    f"There is no {name} {getattr(self, name)!r} to rehearse.",
                    f"Use one of {', '.join(known)}.",
                )
        least = TOGETHER if self.architecture == "mvdream" else 1
        for name in ("batch", "chunk"):
            given = getattr(self, name)
            if given < 1 or given % least:
                takes = f"a multiple of {least}" if least > 1 else "1 or more"
                raise UserError(f"--{name} is {given}.", f"Use {takes}.")


def bench_rehearsal(rehearsal: Rehearsal, out: Path | None = None) -> list[dict]:
    """Time a step of each kind, print a table, and write it as JSON to ``out``."""
    device = device_of(rehearsal.device)
    guidance, config = random_guidance(rehearsal, device), config_of(rehearsal)
    lines, found = [], {}
    with tempfile.TemporaryDirectory() as folder:
        run = RunFolder.create(Path(folder), Job(prompt="a rehearsal"))
        steps = phases_of(guidance, config, run, device)
        for name, (setup, phase) in steps.items():
            found[name] = parts_ms(setup, phase, device)
            for part, ms in found[name].items():
                title = f"{name}: {part}, {rehearsal.batch} views"
                lines.append(row(title, ms, "ms") | {"part": rehearsal.architecture})
                print(table_line(lines[-1]), flush=True)
    for title, minutes in schedule(found, rehearsal.batch).items():
        lines.append(row(title, minutes, "min") | {"part": rehearsal.architecture})
        print(table_line(lines[-1]), flush=True)
    if out:
        text = {"machine": machine(), "rehearsal": vars(rehearsal), "rows": lines}
        out.write_text(json.dumps(text, indent=1) + "\n", encoding="utf-8")
    return lines


def random_guidance(rehearsal: Rehearsal, device: torch.device) -> PromptedStableDiffusion:
    """The architecture with random weights, in the precision that a checkpoint would have."""
    dtype = torch.float16 if device.type == "cuda" else torch.float32
    unet_config, vae_config = configurations(rehearsal)
    unet_kind, vae_kind = libraries.UNet2DConditionModel, libraries.AutoencoderKL
    with torch.device(device):
        unet: Any = unet_kind.from_config(unet_config)
        if rehearsal.architecture == "mvdream":
            unet = MultiViewUNet(unet)
        vae: Any = vae_kind.from_config(vae_config)
    vae.decoder = None
    torch.nn.Module.to(unet, device, dtype)
    # SDXL's encoder overflows in 16 bit.
    torch.nn.Module.to(vae, device, torch.float32 if rehearsal.architecture == "sdxl" else dtype)
    schedule = libraries.DDPMScheduler(
        beta_start=8.5e-4, beta_end=0.012, beta_schedule="scaled_linear"
    )
    networks = Networks(unet, vae, schedule, (Encoder(None, None),))
    model = StableDiffusion(networks, chunk=rehearsal.chunk)
    # The sides of the object, the negative prompt, no words; a row more holds SDXL's pooled text.
    length = TOKENS + takes_pooled(unet.config)
    texts = torch.randn(7, length, unet.config["cross_attention_dim"]).to(device, dtype)
    return PromptedStableDiffusion(model, texts[:5], texts[5], texts[6])


def configurations(rehearsal: Rehearsal) -> tuple[dict[str, Any], dict[str, Any]]:
    """Configurations of U-Net and VAE: the shipped ones, or the same blocks with small widths."""
    folder = CONFIGURATIONS / ARCHITECTURES[rehearsal.architecture]
    unet, vae = (read_json(folder / part / "config.json") for part in ("unet", "vae"))
    if rehearsal.architecture == "mvdream":
        unet = of_multi_view(unet)
    if rehearsal.scale == "full":
        return unet, vae
    blocks = len(unet["block_out_channels"])
    small = {"norm_num_groups": 4, "sample_size": 8}
    unet |= small | {"block_out_channels": [16] * blocks, "cross_attention_dim": 16}
    unet |= {"attention_head_dim": 4, "transformer_layers_per_block": 1}
    if unet.get("addition_time_embed_dim"):  # six numbers, and a pooled text of 16
        unet |= {"addition_time_embed_dim": 8, "projection_class_embeddings_input_dim": 64}
    return unet, vae | small | {"block_out_channels": [8, 8, 16, 16], "sample_size": 64}


def config_of(rehearsal: Rehearsal) -> Config:
    """The paper's preset with the rehearsal's views; small pictures where the network is."""
    g, a = PAPER.geometry, PAPER.appearance
    some = {"views": rehearsal.batch, "views_at_once": rehearsal.chunk}
    if rehearsal.scale == "full":
        return replace(PAPER, geometry=replace(g, **some), appearance=replace(a, **some))
    small = {name: replace(getattr(g, name), size=64) for name in ("coarse", "fine")}
    painted = {name: replace(getattr(a, name), size=64) for name in ("early", "late")}
    some_shape = {"net": FOURIER, "resolution": (12, 12)}
    return replace(
        PAPER,
        geometry=replace(g, **some, **small, **some_shape),
        appearance=replace(a, **some, **painted, log2_hash_size=10),
    )


def phases_of(
    guidance: PromptedStableDiffusion, config: Config, run: RunFolder, device: torch.device
) -> dict[str, tuple[Setup, Phase]]:
    """A coarse, a fine and an appearance phase, each with its training."""
    generator = torch.Generator().manual_seed(0)
    net = sdf_net(config.geometry, generator)
    fit(net, ellipsoid((0.6, 0.6, 0.6)), FIT_STEPS, generator)
    shape = Setup(Training("geometry", net.to(device), generator, run), guidance, config.geometry)
    coarse, fine = (tet_grid(n, device=device) for n in config.geometry.resolution)
    phases = {phase.name: (shape, phase) for phase in geometry_phases(shape, coarse, fine)}

    material = MaterialNet(config.appearance, generator).to(device)
    training = Training("appearance", material, generator, run)
    painted = Setup(training, guidance, config.appearance)
    light = Environment.of(torch.ones(4, 8, 3), config.appearance.shading).to(device)
    subject = LitObject(painted_ball(device), light, None)
    phases["appearance"] = (painted, appearance_phases(painted, subject)[0])
    return {name: phases[name] for name in PHASES}


def painted_ball(device: torch.device) -> UvMesh:
    """A closed mesh with a uv of its own for each face; what it costs does not depend on them."""
    verts, faces = ball(FACES)
    uv = torch.tensor([[0.1, 0.1], [0.9, 0.1], [0.1, 0.9]])
    face_uvs = torch.arange(3).expand(len(faces), 3).contiguous()
    return UvMesh.of(Mesh(verts, faces, uv, face_uvs)).to(device)


def parts_ms(setup: Setup, phase: Phase, device: torch.device) -> dict[str, float]:
    """Wall milliseconds of a step, and of its parts by themselves; the field's is what is left."""
    guidance, views = setup.guidance, setup.config.views
    assert isinstance(guidance, PromptedStableDiffusion)
    cameras = sample_cameras(views, setup.config.cameras, torch.Generator().manual_seed(0))
    cameras = cameras.to(device)

    def step() -> None:
        gradient_of(setup, phase, Step(0, 1, 1, last=False))
        setup.training.optimizer.step()

    parts = {"a step": step, "U-Net": lambda: predict(guidance, cameras)}
    size = setup.config.early.size if phase.name == "early" else setup.config.fine.size
    if phase.name != "coarse":  # whose latents are the normals themselves
        parts["VAE"] = lambda: encode(guidance, views, size, setup.config.views_at_once)
    parts["renderer"] = lambda: draw(setup, phase, cameras, size)
    found = {name: wall_ms(run, device, STEPS) for name, run in parts.items()}
    rest = found["a step"] - sum(ms for name, ms in found.items() if name != "a step")
    return found | {"field and the rest": max(rest, 0.0)}


def predict(guidance: PromptedStableDiffusion, cameras: Cameras) -> None:
    """The noise prediction with guidance for each view."""
    size = guidance.latent_size
    z = torch.zeros(len(cameras), 4, size, size, device=cameras.eye.device)
    guidance.predict(z, torch.full((len(z),), 500, device=z.device), Views(cameras))


def encode(guidance: PromptedStableDiffusion, views: int, size: int, at_once: int) -> None:
    """The encoder with its gradient, for each view."""
    device = guidance.views.device
    for part in torch.zeros(views, size, size, 3, device=device).split(at_once):
        n = part.requires_grad_()
        guidance.encode_normals(n, torch.ones_like(n[..., :1])).sum().backward()


def draw(setup: Setup, phase: Phase, cameras: Cameras, size: int) -> None:
    """The pictures with their gradient, without the network that the shape or material is."""
    scene: Any = phase.begin(1)[0]
    for start in range(0, len(cameras), setup.config.views_at_once):
        part = cameras[slice(start, start + setup.config.views_at_once)]
        if phase.name == "early":
            shaded = render_shaded(scene.mesh, grey, part, size, scene.lit)
            (shaded.srgb.sum() * 1.0).backward()
        else:
            n, o = scene.render(part, size)
            (n.sum() + o.sum()).backward()


def grey(points: Tensor, uv: Tensor) -> Any:
    """A material without a network."""
    from core.appearance.material import Material

    del uv
    one = torch.full_like(points[:, :1], 0.5).requires_grad_()
    up = points.new_tensor([0.0, 0.0, 1.0]).expand_as(points)
    return Material(one.expand_as(points), one, one, up)


def schedule(found: dict[str, dict[str, float]], batch: int) -> dict[str, float]:
    """Minutes of the paper's 3,000 and 2,000 steps of 24 views, on the device that was timed.

    What is of the views grows with them; the field does not.
    """
    g, a = PAPER.geometry, PAPER.appearance
    steps = {"coarse": g.coarse.steps, "fine": g.fine.steps}
    steps["appearance"] = a.early.steps + a.late.steps
    minutes = {}
    for name, parts in found.items():
        fixed = parts["field and the rest"]
        ms = (parts["a step"] - fixed) * g.views / batch + fixed
        minutes[f"{name}: {steps[name]:,} steps of {g.views} views"] = steps[name] * ms / 6e4
    return minutes | {"the paper's whole schedule": sum(minutes.values())}
