"""The whole method: text in, an asset folder out (docs/architecture.md, "Data flow").

Every stage leaves its result in the run folder's checkpoint, so a resumed run goes on in the
middle of the stage where it stopped.
"""

import math
import warnings
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.environment import Environment, load_light
from core.appearance.material import MaterialNet
from core.appearance.shaded import UvMesh
from core.config import AppearanceConfig, Config, GeometryConfig, preset, with_settings
from core.errors import MissingError, UserError
from core.geometry.init_shape import ellipsoid, fit, mesh_shape
from core.geometry.mesh import Mesh, normalise
from core.geometry.sdf_net import SdfNet
from core.geometry.tet_grid import EXTENT
from core.guidance.guidance import MaterialRanges, PromptedGuidance, PromptWarning
from core.guidance.load import make_guidance
from core.io.asset import place, write_asset
from core.io.job import Job
from core.io.mesh_file import load_mesh
from core.io.run_folder import RunFolder
from core.stages.appearance import learn_appearance, picture_of
from core.stages.geometry import learn_geometry
from core.stages.start_color import STEPS, fit_base_color, start_picture
from core.stages.texturing import bake_maps, unwrap_shape

PREVIEW_SIZE = 512  # pixels, of the asset's picture


@dataclass(frozen=True)
class Inputs:
    """Everything that a job names, loaded and checked before the first file is written."""

    config: Config
    device: torch.device
    guidance: PromptedGuidance
    light: Tensor  # lat-long, linear
    shape: Mesh | None  # the guide mesh, or the mesh to texture
    start: Tensor | None = None  # the base colour that the material starts from, linear
    warnings: tuple[str, ...] = ()  # what the user should know of the prompts, such as a cut


def prepare(job: Job) -> Inputs:
    """Load what ``job`` names; UserError for the first thing that is not right."""
    config = config_of(job)
    device = device_of(job.device)
    path = job.mesh or job.guide_mesh
    shape = load_mesh(Path(path)) if path else None
    start = start_picture(job.base_color, shape) if job.base_color and shape else None
    light = load_light(job.light)
    guidance = make_guidance(
        job.guidance, device, ignore_unknown=job.ignore_unknown_words, config=config.guidance
    )
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", PromptWarning)
        prompted = guidance.prompted(job.prompt, job.negative_prompt)
    said = tuple(str(w.message) for w in caught)
    return Inputs(config, device, prompted, light, shape, start, said)


def generate(run: RunFolder, inputs: Inputs) -> Path:
    """Carry out the run from where it stands; the path of its asset folder."""
    job, config, device = run.job, inputs.config, inputs.device
    run.check_cancelled()
    for text in inputs.warnings:
        run.say("warning", text=text)

    # GEOMETRY: Ψ learns the shape, from an ellipsoid or from the guide mesh
    mesh = load_unwrapped(run)
    if mesh is None and job.command == "generate":
        generator = torch.Generator().manual_seed(job.seed)
        net = sdf_net(config.geometry, generator).to(device)
        if not run.has("geometry"):
            start = mesh_shape(inputs.shape) if inputs.shape else ellipsoid(config.geometry.radii)
            with run.timed("fit"):
                steps = config.geometry.fit_steps
                fit(net, start, steps, generator, lambda step, _: run.advance("fit", step, steps))
        verts, faces = learn_geometry(net, inputs.guidance, config.geometry, run, generator)
        shape = Mesh(verts.cpu(), faces.cpu())
    else:
        shape = inputs.shape

    # UNWRAP: once, within the face budget
    if mesh is None:
        assert shape is not None  # a job of "texture" has a mesh
        verts, _, _ = normalise(shape.verts)
        own = replace(shape, verts=verts)
        mesh = unwrap_shape(own, config.texture, run, keep_uv=job.uv == "keep")
        save_unwrapped(run, mesh)
    mesh = mesh.to(device)

    # APPEARANCE: Γ learns the material
    generator = torch.Generator().manual_seed(job.seed + 1)
    bounds = inputs.guidance.ranges()
    material = MaterialNet(within(config.appearance, bounds), generator).to(device)
    if inputs.start is not None and inputs.shape and not run.has("appearance"):
        own = replace(inputs.shape, verts=normalise(inputs.shape.verts)[0])
        with run.timed("start"):
            fit_base_color(
                material, own, inputs.start, generator, lambda n: run.advance("start", n, STEPS)
            )
    environment = Environment.of(inputs.light, config.appearance.shading).to(device)
    learn_appearance(material, mesh, environment, inputs.guidance, run, generator)

    # TEXTURING: Γ on the texels, edge padding, the asset folder
    maps = bake_maps(mesh, material, config.texture, run)
    verts = mesh.verts.cpu()
    verts = place(verts) if job.command == "generate" else back(verts, inputs.shape)
    picture = picture_of(material, mesh, environment, PREVIEW_SIZE)
    parts = (verts, mesh.faces, mesh.uv, mesh.face_uvs)
    return write_asset(run.asset, *parts, maps, info_of(job, run), picture)


def sdf_net(config: GeometryConfig, generator: torch.Generator) -> SdfNet:
    """Ψ for the coarse phase's lattice."""
    return SdfNet(2 * EXTENT / config.resolution[0], config.net, EXTENT, generator)


def config_of(job: Job) -> Config:
    """The preset with the job's own sizes and settings."""
    config = preset(job.preset)
    if job.texture_size:
        config = replace(config, texture=replace(config.texture, size=job.texture_size))
    if job.max_faces:
        config = replace(config, texture=replace(config.texture, max_faces=job.max_faces))
    config = with_settings(config, job.settings)
    if job.base_color:
        config = retouching(config, job.guide_strength)
    return shortened(config, job.guide_strength) if job.guide_mesh else config


def shortened(config: Config, strength: float) -> Config:
    """``config`` for a guide mesh: less of what decides the shape, which is noise and length.

    ``strength`` 0 leaves all as it is; at 1 there is no coarse phase, and the rest touches up. What
    stands apart in the guide stays so.
    """
    g, keep = config.geometry, 1 - strength

    def calmer(t: tuple[float, float]) -> tuple[float, float]:
        return t[0] * (1 - strength / 2), t[1] * (1 - strength / 2)

    steps, rounds = round(g.coarse.steps * keep), round(g.grow.rounds * keep)
    coarse = replace(g.coarse, steps=steps, t_high=calmer(g.coarse.t_high))
    grow = replace(g.grow, rounds=rounds, t=calmer(g.grow.t))
    fine = replace(g.fine, steps=math.ceil(g.fine.steps * (0.2 + 0.8 * keep)))
    refine = replace(g.refine, t=calmer(g.refine.t))
    rate = g.learning_rate * (0.05 + 0.95 * keep)
    shorter = replace(g, coarse=coarse, grow=grow, fine=fine, refine=refine, learning_rate=rate)
    return replace(config, geometry=replace(shorter, join=g.join and strength == 0))


def retouching(config: Config, strength: float) -> Config:
    """``config`` for a base colour to start from: less of what paints over it.

    ``strength`` 0 leaves all as it is; at 1 the late phase alone touches up.
    """
    a, keep = config.appearance, 1 - strength
    early = replace(a.early, steps=round(a.early.steps * keep))
    late = replace(
        a.late,
        steps=max(1, round(a.late.steps * (0.2 + 0.8 * keep))),
        t_high=tuple(t * (1 - strength / 2) for t in a.late.t_high),
    )
    refine = replace(
        a.refine,
        rounds=round(a.refine.rounds * keep),
        t=tuple(t * (1 - strength / 2) for t in a.refine.t),
    )
    rate = a.learning_rate * (0.02 + 0.98 * keep)
    less = replace(a, early=early, late=late, refine=refine, learning_rate=rate)
    return replace(config, appearance=less)


def device_of(name: str) -> torch.device:
    """The torch device ``name``; "auto" is the first GPU, or else the CPU."""
    found = {"cuda": torch.cuda.is_available(), "mps": torch.backends.mps.is_available()}
    if name == "auto":
        return torch.device(next((kind for kind, here in found.items() if here), "cpu"))
    kind = name.split(":")[0]
    if kind not in ("cpu", *found):
        raise UserError(f"There is no device {name!r}.", "Take auto, cpu, cuda or mps.")
    if not found.get(kind, True):
        raise MissingError(f"This torch finds no {kind} device.", "Take --device auto or cpu.")
    return torch.device(name)


def back(verts: Float[Tensor, "v 3"], mesh: Mesh | None) -> Float[Tensor, "v 3"]:
    """From the training's cube to where the user's ``mesh`` stands."""
    assert mesh is not None
    if len(verts) == len(mesh.verts):  # not simplified: to the last bit
        return mesh.verts
    _, center, scale = normalise(mesh.verts)
    return verts / scale + center


def within(config: AppearanceConfig, bounds: MaterialRanges | None) -> AppearanceConfig:
    """``config`` with the bounds that the words set."""
    if bounds is None:
        return config
    return replace(config, roughness_range=bounds.roughness, metallic_range=bounds.metallic)


def load_unwrapped(run: RunFolder) -> UvMesh | None:
    """The unwrapped mesh of an earlier session of this run."""
    found = run.load("mesh")
    return (
        UvMesh.of(*(found[0][k] for k in ("verts", "faces", "uv", "face_uvs"))) if found else None
    )


def save_unwrapped(run: RunFolder, mesh: UvMesh) -> None:
    """Keep the unwrapped mesh: from here on the geometry is not trained again."""
    parts = {"verts": mesh.verts, "faces": mesh.faces, "uv": mesh.uv, "face_uvs": mesh.face_uvs}
    run.save("mesh", parts, {})


def info_of(job: Job, run: RunFolder) -> dict:
    """What asset.json says about the making."""
    told = ("prompt", "negative_prompt", "seed", "preset", "guidance", "command", "light")
    job_told = {key: value for key, value in asdict(job).items() if key in told}
    timings = {stage: round(seconds, 2) for stage, seconds in run.timings.items()}
    return job_told | {"timings": timings, "distribution": "GGX"}
