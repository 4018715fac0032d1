"""A part of a finished mesh reshaped, beyond the paper: it follows the guidance's pictures.

Rounds as in :mod:`core.stages.refine`: pictures of the whole mesh, denoised from less noise each
time, and descent on the part's vertices alone (:mod:`core.geometry.large_steps`). Faces and UVs
stay, so no hole is closed and no part split off; what it does is to move a surface to where the
prompt has it: dents, bumps and cuts go, a roughly sculpted part becomes clean.
"""

from typing import NamedTuple

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.camera import sample_cameras
from core.config import GeometryConfig
from core.errors import UserError
from core.geometry.bilateral import flattened
from core.geometry.large_steps import SmoothVertices
from core.geometry.mesh import Mesh
from core.guidance.guidance import PromptedGuidance, Views
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.stages.preview import show_shape
from core.stages.refine import Targets, cleaned, fit_loss
from core.stages.scene import portions

RATE_END = 0.2  # fraction of the rate at a round's last step
STAGE = "geometry"  # of the progress events


class Part(NamedTuple):
    """A mesh with a free part."""

    verts: Float[Tensor, "v 3"]  # in the training's cube
    faces: Int[Tensor, "f 3"]
    free: Bool[Tensor, " v"]  # may move


def free_verts(mesh: Mesh, region: Bool[Tensor, " f"]) -> Bool[Tensor, " v"]:
    """The vertices that may move: at least two edges from any face outside of ``region``.

    Not those next to the border: its normals depend on them, and the shading outside on these.
    """
    faces = mesh.faces
    fixed = torch.zeros(len(mesh.verts), dtype=torch.bool)
    fixed[faces[~region].reshape(-1)] = True
    touching = fixed[faces].any(1)
    fixed[faces[touching].reshape(-1)] = True
    free = torch.zeros_like(fixed)
    free[faces.reshape(-1)] = True  # a vertex of no face is in no picture
    return free & ~fixed


def reshaped(
    run: RunFolder,
    config: GeometryConfig,
    guidance: PromptedGuidance,
    part: Part,
    progress: Progress,
) -> Float[Tensor, "v 3"]:
    """The vertices of ``part`` after ``config.reshape``; those that are not free as they were.

    Raises UserError where none may move.
    """
    verts, faces, free = part
    if not bool(free.any()):
        raise UserError(
            "The region has no vertex that is two edges or more from its border.",
            "Choose more faces.",
        )
    generator, rounds = torch.Generator().manual_seed(run.job.seed), config.reshape
    for number in range(rounds.rounds):
        targets = _targets(config, guidance, part._replace(verts=verts), number, generator)
        smooth = SmoothVertices(verts, faces, config.sharpen.stiffness, free)
        edges = edge_table(faces)
        for step in range(rounds.steps):
            progress.check_cancelled()
            some = targets.some(rounds.batch, generator)
            frame = guidance.normal_frame
            n, o = render_normals(smooth.verts(), faces, some.cameras, rounds.size, frame, edges)
            rate = rounds.learning_rate * (1 - (1 - RATE_END) * step / rounds.steps)
            smooth.step(fit_loss(guidance.encode_normals(n, o), some.z), rate)
            progress.advance(STAGE, number * rounds.steps + step, rounds.rounds * rounds.steps)
        verts = smooth.verts().detach()
        show_shape(run, verts, faces)
    # What the pictures disagree in are ripples.
    smoothed = flattened(verts, faces, config.flatten, config.flatten_sigma)
    return torch.where(free[:, None], smoothed, verts)


@torch.no_grad()
def _targets(
    config: GeometryConfig,
    guidance: PromptedGuidance,
    part: Part,
    number: int,
    generator: torch.Generator,
) -> Targets:
    """The round's pictures of the whole mesh, denoised."""
    rounds = config.reshape
    cameras = sample_cameras(rounds.views, config.cameras, generator).to(part.verts.device)
    mesh, frame = (part.verts, part.faces), guidance.normal_frame
    pictures = [
        guidance.encode_normals(*render_normals(*mesh, cameras[some], rounds.size, frame))
        for some in portions(len(cameras), config.views_at_once)
    ]
    z = torch.cat(pictures)
    clean = cleaned(z, guidance, Views(cameras), rounds, number, generator=generator)
    return Targets(cameras, clean)
