"""The whole method: text in, an asset folder out (docs/architecture.md, "Data flow").

Every stage leaves its result in the run folder's checkpoint, so a resumed run continues in the
middle of the stage where it stopped.
"""

import math
import warnings
from dataclasses import dataclass, replace
from pathlib import Path

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.environment import Environment, load_light
from core.appearance.material import MaterialNet
from core.appearance.shaded import UvMesh
from core.config import Config
from core.device import device_of
from core.errors import Paused, UserError
from core.geometry.guide import kept
from core.geometry.mesh import Mesh, normalise, turned
from core.guidance.builtin.words.part_words import of_whole
from core.guidance.guidance import PromptedGuidance, PromptWarning
from core.guidance.load import make_guidance
from core.io.asset import Asset, check_asset_folder, place, read_asset, write_asset
from core.io.job import Job
from core.io.mesh_file import Needed, load_mesh
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.job_config import config_of, is_kept, local_ranges, within
from core.provenance import info_of
from core.ranks import ALONE, Ranks
from core.stages.appearance import learn_appearance
from core.stages.distill import require_groups
from core.stages.facing import front_turn
from core.stages.geometry import assembled_shape, learn_geometry, learns
from core.stages.lit_scene import picture_of_maps
from core.stages.lit_shape import lit_shape, take_material
from core.stages.preview import show_shape, size_of
from core.stages.reshape import Part, free_verts, reshaped
from core.stages.start_color import OWN, fit_start_color, start_picture
from core.stages.start_shape import (
    fit_guide,
    fit_start_shape,
    leash_of,
    least_of,
    sdf_net,
    solid_guide,
)
from core.stages.state import Training
from core.stages.styled import NO_STYLE, in_style, plain, style_of, styled, styled_areas
from core.stages.texturing import (
    bake_maps,
    fine_over,
    load_unwrapped,
    save_unwrapped,
    shared_unwrapped,
    unwrap_shape,
)
from core.stages.training import Setup
from core.stages.workload import cpu_notice
from core.texture.region import Region, edited, read_faces

PREVIEW_SIZE = 512  # pixels, of the asset's picture
RESHAPED = "reshaped"  # the checkpoint of a region's new shape
FRONT = "front"  # that of the guide's turn


@dataclass(frozen=True)
class Inputs:
    """Everything that a job names, loaded and checked before the first file is written."""

    config: Config
    device: torch.device
    guidance: PromptedGuidance
    light: Tensor  # lat-long, linear
    shape: Mesh | None  # the guide mesh, or the mesh to texture
    start: Tensor | None = None  # the base colour that the material starts from, linear
    region: Region | None = None  # the part that gets the material; None: all of it
    warnings: tuple[str, ...] = ()  # what the user should know first: a cut prompt, days of work
    ranks: Ranks = ALONE  # the processes that make the asset together


def prepare(job: Job, place: int | None = None) -> Inputs:
    """Load what ``job`` names; UserError for the first thing that is not right.

    ``place``: this process's among those of this machine that make the asset together.
    """
    config = config_of(job)
    device = device_of(job.device, place)
    path = job.mesh or job.guide_mesh
    kept = read_asset(Path(job.kept_asset)) if job.region else None
    # Of the asset itself: a reader of any OBJ may order its faces otherwise.
    shape = kept.mesh if kept else load_mesh(Path(path), needed_of(job)) if path else None
    start = start_picture(job.base_color, shape) if job.base_color and shape else None
    light = load_light(job.light)
    guidance = make_guidance(
        job.guidance,
        device,
        ignore_unknown=job.ignore_unknown_words,
        config=config.guidance,
        loras=job.loras,
        embeddings=job.embeddings,
    )
    require_groups(config, guidance.views_together, job.command)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", PromptWarning)
        prompted = guidance.prompted(prompt_of(job, kept), job.negative_prompt)
    notice = cpu_notice(guidance.work(), config, job.command) if device.type == "cpu" else ""
    texts = tuple(str(w.message) for w in caught) + ((notice,) if notice else ())
    region = region_of(job, kept) if kept else None
    return Inputs(config, device, prompted, light, shape, start, region, texts)


def generate(run: RunFolder, inputs: Inputs, progress: Progress, until: str = "") -> Path:
    """Carry out the run from where it is; the path of its asset folder.

    Of several processes each calls this, with the same job; the first one writes.

    Raises Paused once it has come ``until`` a first look at the "shape" or the "color".
    """
    inputs = styled_inputs(of_seed(inputs, run.job), run.job)
    job, config, device = run.job, inputs.config, inputs.device
    progress.check_cancelled()
    check_asset_folder(run.asset)
    for text in (*inputs.warnings, *unstyled(job, inputs)):
        progress.warn(text)
    ranks = inputs.ranks
    inputs = in_proportion(facing(run, inputs, progress), job)
    guidance = inputs.guidance
    run.size_m = guidance.size_m()
    for text in () if job.region else guidance.left_out():
        progress.warn(text)
    if job.reshape and ranks.first:
        inputs = replace(inputs, shape=reshaped_mesh(run, inputs, progress))
    if job.reshape and not job.retexture:
        return reshaped_asset(run, inputs) if ranks.first else run.asset

    # The first process alone knows the run folder; what it finds is true for all.
    unwrapped = load_unwrapped(run) if ranks.first else None
    if until == "shape" and (unwrapped is not None or job.command == "texture"):
        raise paused(run, until)
    if not ranks.rows([unwrapped is not None])[0].any():
        # GEOMETRY (§4.2): Ψ learns the shape, unless the user brings one to texture
        shape = (
            inputs.shape
            if job.command == "texture"
            else styled_shape(run, inputs, progress, early=until == "shape")
        )
        if until == "shape":
            raise paused(run, until)

        # UNWRAP: once, in the training's cube, within the face budget
        if ranks.first:
            assert shape is not None  # a job of "texture" has a mesh
            if guidance.parts() is None:  # or it is there already, and its parts with it
                shape = replace(shape, verts=normalise(shape.verts)[0])
            own = inputs.shape is not None and (job.command == "texture" or job.guide_strength == 1)
            has_style = config.geometry.style != "none"
            kept = {"keep_uv": job.uv == "keep", "keep_faces": own or has_style}
            unwrapped = unwrap_shape(shape, config.texture, progress, **kept)
            # The kept asset's normals have its relief; of another shape there is none.
            if inputs.region and not job.reshape:
                unwrapped = unwrapped._replace(fine=inputs.region.fine)
            save_unwrapped(run, unwrapped)
    unwrapped = shared_unwrapped(unwrapped, ranks)
    mesh = unwrapped.mesh.to(device)

    # APPEARANCE (§4.3): Γ learns the material, from grey or from the user's base colour
    generator = torch.Generator().manual_seed(job.color_seed or job.seed + 1)
    ranges = within(config.appearance, guidance.ranges())
    areas = styled_areas(guidance.areas(), unwrapped.mesh.mesh, config.geometry)
    net = MaterialNet(ranges, generator, local_ranges(ranges, areas)).to(device)
    training = Training("appearance", net, generator, run)
    if config.geometry.pictures == "entangled":
        take_material(net, run)
    if inputs.start is not None and inputs.shape and not run.has(training.name):
        fit_start_color(training, inputs.shape, inputs.start, progress)
    light = Environment.of(inputs.light, config.appearance.shading).to(device)
    setup = Setup(training, guidance, ranges, ranks)
    learn_appearance(setup, mesh, light, progress, early=until == "color")
    if until == "color":
        raise paused(run, until)
    if not ranks.first:
        return run.asset

    # TEXTURING (§4.3): Γ on the texels, the materials' detail, edge padding, the asset folder
    known = {"surfaces": guidance.surfaces(), "areas": areas}
    seed = job.color_seed or job.seed
    rounded = is_own_shape(job, inputs)
    maps = bake_maps(unwrapped, net, config, progress, seed=seed, rounded=rounded, **known)
    if inputs.region is not None:
        verts = unwrapped.mesh.verts
        feather = config.texture.feather * float((verts.amax(0) - verts.amin(0)).max())
        maps = edited(unwrapped.mesh.mesh, inputs.region, maps, feather, config.texture.samples)
    verts = mesh.verts.cpu()
    generated = job.command == "generate"
    verts = turned(verts, -run.turn) if run.turn else verts
    verts = place(verts, size_of(run, verts)) if generated else back(verts, inputs.shape)
    placed = replace(mesh.mesh, verts=verts)
    picture = picture_of_maps(maps, mesh, light, PREVIEW_SIZE)
    info = info_of(job, run.timings, guidance.parts())
    return write_asset(run.asset, placed, maps, info, picture)


def reshaped_mesh(run: RunFolder, inputs: Inputs, progress: Progress) -> Mesh:
    """The kept asset's mesh with another shape in its region; a resumed run finds it again."""
    mesh, region = inputs.shape, inputs.region
    assert mesh is not None and region is not None
    found = run.load(RESHAPED)
    if found:
        with run.whole_checkpoint(RESHAPED):
            return replace(mesh, verts=found[0]["verts"].reshape(mesh.verts.shape))
    with progress.timed("geometry"):
        free = free_verts(mesh, region.faces)
        cube, center, scale = normalise(mesh.verts)
        parts = [x.to(inputs.device) for x in (cube, mesh.faces, free)]
        made = reshaped(run, inputs.config.geometry, inputs.guidance, Part(*parts), progress)
        verts = torch.where(free[:, None], made.cpu() / scale + center, mesh.verts)
        progress.complete("geometry")
    run.save(RESHAPED, {"verts": verts}, {})
    return replace(mesh, verts=verts)


def reshaped_asset(run: RunFolder, inputs: Inputs) -> Path:
    """The kept asset in its new shape; its UVs and its maps stay."""
    mesh, region = inputs.shape, inputs.region
    assert mesh is not None and region is not None
    light = Environment.of(inputs.light, inputs.config.appearance.shading).to(inputs.device)
    seen = UvMesh.of(replace(mesh, verts=normalise(mesh.verts)[0])).to(inputs.device)
    kept = region.kept
    picture = picture_of_maps(kept, seen, light, PREVIEW_SIZE)
    return write_asset(run.asset, mesh, region.kept, info_of(run.job, run.timings), picture)


def of_seed(inputs: Inputs, job: Job) -> Inputs:
    """``inputs`` for the one object that the seed draws, where the geometry starts from one.

    Not in ``prepare``, whose result serves jobs that differ in their seeds alone.
    """
    if job.command != "generate" or inputs.config.geometry.start != "learned":
        return inputs
    # Pictures and guides are of one thing.
    whole = not learns(inputs.config.geometry) and inputs.shape is None
    return replace(inputs, guidance=inputs.guidance.of_object(job.seed, whole))


def styled_inputs(inputs: Inputs, job: Job) -> Inputs:
    """``inputs`` with the settings of the style that the job sets or the prompt states; without one
    where the shape is the user's. A part of an asset in a style stays in it."""
    made_here = job.command == "generate" and not is_kept(job)
    style = style_of(inputs.config.geometry, inputs.guidance.style()) if made_here else "none"
    config = in_style(inputs.config, style)
    is_flat = inputs.shape is not None and inputs.shape.flat
    return replace(inputs, config=plain(config) if is_flat else config)


def unstyled(job: Job, inputs: Inputs) -> tuple[str, ...]:
    """A note on a style that the prompt states and that is left out, as the mesh is the user's."""
    style = inputs.guidance.style() if job.command == "texture" or is_kept(job) else ""
    return (NO_STYLE.format(style=style.replace("_", " ")),) if style and not job.region else ()


def in_proportion(inputs: Inputs, job: Job) -> Inputs:
    """``inputs`` with what the guidance has drawn in the guide's proportions."""
    guide = inputs.shape
    if guide is None or job.command != "generate":
        return inputs
    least = least_of(inputs.config.geometry)
    guidance = inputs.guidance.in_proportion(guide, job.guide_strength, least)
    return replace(inputs, guidance=guidance)


def facing(run: RunFolder, inputs: Inputs, progress: Progress) -> Inputs:
    """``inputs`` with the guide turned so that its front is where the guidance knows it."""
    guide, ranks = inputs.shape, inputs.ranks
    wanted = run.job.command == "generate" and inputs.config.geometry.find_front
    if guide is None or not wanted:
        return inputs
    # The first process decides, once: a training continues as it was started.
    turn, found = 0.0, run.load(FRONT) if ranks.first else None
    if found:
        with run.whole_checkpoint(FRONT):
            turn = float(found[1]["turn"])
    elif ranks.first and not (run.has("geometry") or run.has("mesh")):  # of an older run
        turn = front_turn(guide, inputs.guidance)
        run.save(FRONT, {}, {"turn": turn})
        if turn:
            progress.warn(
                f"The guide's front seems to be {round(math.degrees(turn))}° off: it is turned for "
                "the training, and the asset back.",
                "--set geometry.find_front=false uses it as it is.",
            )
    turn = float(ranks.rows([turn])[0, 0])
    run.turn = turn
    return replace(inputs, shape=replace(guide, verts=turned(guide.verts, turn)) if turn else guide)


def needed_of(job: Job) -> Needed:
    """The data that ``job`` needs of its mesh file besides the shape."""
    if job.base_color == OWN:
        return "texture"
    return "uv" if job.base_color or job.uv == "keep" else ""


def prompt_of(job: Job, asset: Asset | None) -> str:
    """The guidance's prompt: the whole thing, also where a region's words name a part."""
    if asset is None or job.guidance != "builtin":
        return job.prompt
    return of_whole(job.prompt, str(asset.info.get("prompt", "")))


def region_of(job: Job, asset: Asset) -> Region:
    """The asset that ``job`` keeps, and the faces that it changes."""
    size = len(asset.maps.base_color)
    if config_of(job).texture.size != size:
        raise UserError(
            f"The asset's maps have {size} texels a side.", f"Use --texture-size {size}."
        )
    made = load_unwrapped(RunFolder(asset.folder.parent))
    faces = asset.mesh.faces
    same = made and torch.equal(made.mesh.faces, faces)
    # Its cube need not be this run's, where the asset's mesh is normalised.
    fine = fine_over(made, normalise(asset.mesh.verts)[0]) if made and same else None
    return Region(asset.maps, read_faces(Path(job.region), len(faces)), fine)


def paused(run: RunFolder, until: str) -> Paused:
    """The error that ends a session at its requested pause."""
    what = {"shape": "The shape", "color": "The material"}[until]
    return Paused(f"{what} is ready to look at.", f"Finish it: run.py resume {run.path}")


def styled_shape(
    run: RunFolder, inputs: Inputs, progress: Progress, early: bool = False
) -> Mesh | None:
    """:func:`learned_shape` in its style."""
    shape, config = learned_shape(run, inputs, progress, early), inputs.config
    if shape is None or config.geometry.style == "none":
        return shape
    shape = styled(shape, config, progress.check_cancelled)
    apart = torch.arange(3 * len(shape.faces)).view(-1, 3)  # so that the pictures are flat
    show_shape(run, shape.verts[shape.faces].flatten(0, 1), apart)
    return shape


def learned_shape(
    run: RunFolder, inputs: Inputs, progress: Progress, early: bool = False
) -> Mesh | None:
    """The mesh of Ψ, trained from an ellipsoid or from the guide mesh (§4.2); or the guide; or what
    the guidance has drawn, in the guide's proportions, where nothing of it is left to learn.

    ``early``: as :func:`core.stages.geometry.learn_geometry` has it. None in a process that is not
    the first of several.
    """
    guide, strength = inputs.shape, run.job.guide_strength
    if guide and strength == 1:
        return kept_guide(guide, run, progress) if inputs.ranks.first else None
    config, parts = inputs.config.geometry, inputs.guidance.parts()
    shape = solid_guide(guide, config) if guide else None
    leash = leash_of(guide, shape, config, strength) if guide and shape else None
    if parts and not learns(config):
        first = inputs.ranks.first
        return assembled_shape(parts, config, run, progress, leash) if first else None
    generator = torch.Generator().manual_seed(run.job.seed)
    net = sdf_net(config, generator).to(inputs.device)
    look = within(inputs.config.appearance, inputs.guidance.ranges())
    lit = lit_shape(net, config, look, inputs.light.to(inputs.device), generator)
    training = Training("geometry", net, generator, run)
    drawn = inputs.guidance.start_shape()
    if not run.has(training.name):
        if shape:
            fit_guide(training, drawn or shape, strength, progress)
        else:
            fit_start_shape(training, config, progress, drawn)
    net.leash = leash and leash.to(inputs.device)
    setup = Setup(training, inputs.guidance, config, inputs.ranks)
    learned = learn_geometry(setup, progress, lit, early=early)
    return learned and Mesh(*(x.cpu() for x in learned))


def kept_guide(guide: Mesh, run: RunFolder, progress: Progress) -> Mesh:
    """The guide itself, for a strength of 1: no shape is learned."""
    with progress.timed("geometry"):
        mesh = kept(guide)
        show_shape(run, normalise(mesh.verts)[0], mesh.faces)
        progress.complete("geometry")
    return mesh


def is_own_shape(job: Job, inputs: Inputs) -> bool:
    """Whether the shape was made here; a user's mesh keeps the edges that it was given."""
    if inputs.region is not None:
        return inputs.region.fine is not None
    return job.command == "generate" and (inputs.shape is None or job.guide_strength < 1)


def back(verts: Float[Tensor, "v 3"], mesh: Mesh | None) -> Float[Tensor, "v 3"]:
    """From the training's cube to where the user's ``mesh`` is."""
    assert mesh is not None
    if len(verts) == len(mesh.verts):  # not simplified: to the last bit
        return mesh.verts
    _, center, scale = normalise(mesh.verts)
    return verts / scale + center


def views_of(config: Config) -> dict[str, int]:
    """The number of views of a step, by its setting: no more processes can divide them."""
    views = {}
    for stage, rounds in (("geometry", ("grow", "refine")), ("appearance", ("refine",))):
        settings = getattr(config, stage)
        views[f"{stage}.views"] = settings.views
        for name in rounds:
            one = getattr(settings, name)
            if one.rounds * one.steps:
                views |= {f"{stage}.{name}.{of}": getattr(one, of) for of in ("batch", "views")}
    return views
