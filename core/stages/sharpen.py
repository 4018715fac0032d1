"""The finished mesh made crisp, beyond the paper: edges where the guidance sees edges.

Ψ is smooth, and so is its surface, however sharp the pictures are that it is fitted to. Here the
vertices themselves follow pictures: renders of the mesh that the guidance has made crisp
(``PromptedGuidance.restore``). Silhouettes and shading by descent on the vertices
(``core.geometry.large_steps``), then the faces' normals, read from the pictures, by moving the
vertices until they agree (``core.geometry.bilateral``). Nothing here is drawn at random but the
cameras, and these are the same in every run: a resumed run repeats it from the trained Ψ.
"""

from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import grid_sample, normalize

from core.camera import Cameras, aimed, sample_cameras
from core.config import GeometryConfig, SharpenConfig
from core.geometry.bilateral import following, without_folds
from core.geometry.large_steps import SmoothVertices
from core.guidance.guidance import PromptedGuidance, Views
from core.io.progress import Progress
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.render.rasterizer import rasterize
from core.stages.refine import fit_loss
from core.stages.scene import portions

SEED = 0  # of the cameras and of their order
RATE_END = 0.2  # fraction of the rate at a round's last step
FINDER = 64  # side of the pictures that show where the mesh is
SEEN_SIZE = 192  # side of the picture that finds each face's pixels
MEDIAN_ROUNDS = 3  # of reweighting: from the mean towards the median of a face's normals
MEDIAN_FLOOR = 0.1  # difference of unit normals below which all count equally
COVERED = 0.9  # coverage from which a pixel's normal is a surface's
ENOUGH = 4.0  # weight, in pixels seen frontally, from which a face's normal is trusted


class Crisp(NamedTuple):
    """Pictures of one round."""

    cameras: Cameras
    pictures: Float[Tensor, "b 4 s s"]  # [n * o, 2o - 1]


def sharpened(
    config: GeometryConfig,
    guidance: PromptedGuidance,
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    progress: Progress,
) -> Float[Tensor, "v 3"]:
    """The mesh's vertices after ``config.sharpen``; as they are where the guidance cannot."""
    generator = torch.Generator().manual_seed(SEED)
    start = verts = verts.detach()
    for index in range(config.sharpen.rounds):
        progress.check_cancelled()
        cameras = sample_cameras(config.sharpen.views, config.cameras, generator)
        if index >= config.sharpen.rounds - config.sharpen.close_rounds:
            cameras = close_ups(cameras, verts, faces, generator)
        crisp = _crisp(guidance, verts, faces, cameras.to(verts.device), config)
        if crisp is None:
            break
        moved = _fitted(verts, faces, crisp, config.sharpen, generator)
        verts = without_folds(verts, moved, faces)
        verts = following(verts, faces, *seen_normals(verts, faces, crisp), config.flatten_sigma)
        verts = within_reach(start, verts, config.sharpen.reach)
    return verts


def within_reach(
    start: Float[Tensor, "v 3"], verts: Float[Tensor, "v 3"], reach: float
) -> Float[Tensor, "v 3"]:
    """The vertices, no farther than ``reach`` from where they were at the start; 0 is any way.

    A dent is shallow and an edge rounded by less than a cell, so both go. A band that stands out
    by more stays, though in pictures of 64² it is as small as a dent.
    """
    if reach == 0:
        return verts
    moved = verts - start
    return start + moved * (reach / moved.norm(dim=1, keepdim=True).clamp_min(1e-12)).clamp(max=1)


def close_ups(
    cameras: Cameras,
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    generator: torch.Generator,
) -> Cameras:
    """Each camera's picture about a random place of the mesh."""
    with torch.no_grad():
        _, o = render_normals(verts, faces, cameras.to(verts.device), FINDER)
    return aimed(cameras, o[..., 0], generator)


def _crisp(
    guidance: PromptedGuidance,
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    cameras: Cameras,
    config: GeometryConfig,
) -> Crisp | None:
    """Renders of the mesh, restored ``passes`` times; None by a guidance that does not."""
    at_once, size = config.views_at_once, config.sharpen.size
    with torch.no_grad():
        parts = [
            guidance.encode_normals(*render_normals(verts, faces, cameras[part], size))
            for part in portions(len(cameras), at_once)
        ]
    pictures = torch.cat(parts)
    for _ in range(config.sharpen.passes):
        restored = guidance.restore(pictures, Views(cameras))
        if restored is None:
            return None
        pictures = restored
    return Crisp(cameras, pictures)


def _fitted(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    crisp: Crisp,
    config: SharpenConfig,
    generator: torch.Generator,
) -> Float[Tensor, "v 3"]:
    """The vertices moved by the pictures' differences, silhouettes among them."""
    smooth, edges = SmoothVertices(verts, faces, config.stiffness), edge_table(faces)
    size = crisp.pictures.shape[-1]
    for step in range(config.steps):
        some = torch.randperm(len(crisp.pictures), generator=generator)[: config.batch]
        some = some.to(verts.device)
        n, o = render_normals(smooth.verts(), faces, crisp.cameras[some], size, edges=edges)
        seen = torch.cat([n, 2 * o - 1], -1).permute(0, 3, 1, 2)
        rate = config.learning_rate * (1 - (1 - RATE_END) * step / config.steps)
        smooth.step(fit_loss(seen, crisp.pictures[some]), rate)
    return smooth.verts().detach()


def seen_normals(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], crisp: Crisp
) -> tuple[Float[Tensor, "f 3"], Float[Tensor, " f"]]:
    """Each face's unit normal as the pictures have it, and in [0, 1] how far to trust it.

    The median over its pixels in all pictures, by reweighting: at an edge half of the pixels of a
    face show the other side, and a mean would round it.
    """
    views = range(len(crisp.pictures))
    rows = [_seen_in(verts, faces, crisp, view) for view in views]
    face, normal, weight = (torch.cat(part) for part in zip(*rows, strict=True))
    zeros, agree = verts.new_zeros(len(faces), 3), torch.ones_like(weight)
    mean = zeros
    for _ in range(1 + MEDIAN_ROUNDS):
        total = zeros.index_add(0, face, normal * (weight * agree)[:, None])
        mean = normalize(total, dim=1, eps=1e-9)
        agree = 1 / ((normal - mean[face]).norm(dim=1) + MEDIAN_FLOOR)
    trust = zeros[:, 0].index_add(0, face, weight) / ENOUGH
    return mean, trust.clamp(0, 1)


def _seen_in(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], crisp: Crisp, view: int
) -> tuple[Tensor, Tensor, Tensor]:
    """One picture's covered pixels: the face, the picture's normal and its weight at each."""
    camera = crisp.cameras[slice(view, view + 1)]
    fragments = rasterize(verts, faces, camera.mvp, SEEN_SIZE, SEEN_SIZE)
    column, row = fragments.pixel % SEEN_SIZE, fragments.pixel // SEEN_SIZE
    at = (torch.stack([column, row], -1).to(verts) + 0.5) / SEEN_SIZE * 2 - 1
    picture = crisp.pictures[view : view + 1]
    found = grid_sample(picture, at[None, None], align_corners=False, padding_mode="border")
    found = found[0, :, 0].T
    # Between two planes, and where the guidance is unsure, the interpolated normal is short.
    length = found[:, :3].norm(dim=1)
    normal = found[:, :3] / length.clamp_min(1e-6)[:, None]
    frontal = (normal @ camera.rotation[0, 2]).clamp_min(0)
    covered = (found[:, 3] + 1) / 2 > COVERED
    return fragments.face, normal, covered * (0.1 + frontal) * length**4
