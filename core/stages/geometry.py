"""The paper's first training: Ψ learns the shape from normals (§4.2, Eqs. 4, 5)."""

import math

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.camera import Cameras
from core.config import GeometryConfig, PhaseConfig
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import drop_floaters, polished
from core.geometry.ray_sdf import ray_min_sdf
from core.geometry.sdf_net import SdfNet, extract, sdf_on_grid
from core.geometry.tet_grid import TetGrid, tet_grid
from core.guidance.guidance import Embedding, Guidance, Views, coarse_latent
from core.guidance.sds import NotFiniteError
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.run_folder import RunFolder, Training
from core.stages.distill import Draw, decayed, distill, phase_of
from core.stages.guard import MIN_COVERAGE, Guard, healthy_gradients
from core.stages.preview import ShapePreview

RAY_PICTURE = 32  # side of the picture whose rays are followed through the lattice
RAY_SAMPLES = 40
FLOATER_SHARE = 0.02  # a piece smaller than this share of the largest is dropped


def learn_geometry(
    net: SdfNet,
    guidance: Guidance,
    embedding: Embedding,
    config: GeometryConfig,
    run: RunFolder,
    generator: torch.Generator,
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """Train Ψ by score distillation; the mesh that its surface has in the end.

    Coarse phase: [n, o] itself is the latent. Fine phase: the normals are encoded.
    """
    device = next(net.parameters()).device
    grids = [tet_grid(n, device=device) for n in config.resolution]
    optimizer = torch.optim.AdamW(net.parameters(), betas=(0.9, 0.99), eps=1e-15, weight_decay=0.0)
    training = Training(run, "geometry", net, optimizer, generator)
    training.resume()
    guard, preview = Guard(training), ShapePreview(run)
    steps = config.coarse.steps + config.fine.steps

    for step in run.steps("geometry", training.step, steps):
        phase, share = phase_of(step.index, config.coarse, config.fine)
        coarse = phase is config.coarse
        rate = decayed(config.learning_rate, config.learning_rate_end, step.share) * guard.rate
        for group in optimizer.param_groups:
            group["lr"] = rate
        optimizer.zero_grad()
        try:
            grid = grids[0 if coarse else 1]
            net.cell = grid.cell
            batch = Batch(net, grid, config, step.share, generator)
            step.loss = batch.backward(guidance, embedding, phase, share, coarse)
            trouble = batch.trouble(net)
        except NotFiniteError as error:
            trouble = error.text
        if trouble:
            guard.recover(trouble)
            continue
        guard.remember(step.index)
        if config.gradient_clip > 0:
            torch.nn.utils.clip_grad_norm_(net.parameters(), config.gradient_clip)
        optimizer.step()
        preview.show(batch.verts.detach(), batch.faces)
        training.checkpoint(step.index + 1, force=run.cancelled or step.last)
        run.check_cancelled()
    return final_mesh(net, grids[1], config.polish)


class Batch:
    """The views of one step. The net is left alone until all views have had their say.

    The gradient gathers in the vertices (and the lattice's SDF), however many views there are, so
    that memory grows with ``views_at_once`` only; one pass then carries it into Ψ.
    """

    def __init__(
        self,
        net: SdfNet,
        grid: TetGrid,
        config: GeometryConfig,
        share: float,
        generator: torch.Generator,
    ) -> None:
        self.config, self.grid, self.generator = config, grid, generator
        self.follow_rays = share < config.ray_mask_share
        self.sharpness = 10 + 50 * share  # of the mask along the rays, 1 / training unit
        if self.follow_rays or config.eikonal > 0:
            self._sdf, positions = sdf_on_grid(net, grid)
            self._verts, self.faces = marching_tets(positions, self._sdf, grid)
            self.sdf = self._sdf.detach().requires_grad_()
        else:
            surface = extract(net, grid)
            self._verts, self.faces = surface.verts, surface.faces
            self._sdf = self.sdf = None
        self.verts = self._verts.detach().requires_grad_()
        self.coverage = 0.0

    def backward(
        self,
        guidance: Guidance,
        embedding: Embedding,
        phase: PhaseConfig,
        share: float,
        coarse: bool,
    ) -> float:
        """Gather the gradient of all views and of the regularisers into Ψ; the mean loss."""
        config, total = self.config, 0.0
        draw = Draw.of(config.views, config.cameras, guidance, phase, share, self.generator)
        if len(self.faces) == 0:
            return math.nan
        for part in draw.split(config.views_at_once, self.verts.device):
            loss = self._view_loss(part, guidance, embedding, phase, coarse) / config.views
            loss.backward()
            total += loss.item()
        regular = self._regularisers()
        if regular.requires_grad:
            regular.backward()
        leaves = [(self._verts, self.verts)] + (
            [(self._sdf, self.sdf)] if self.sdf is not None else []
        )
        pairs = [(out, leaf.grad) for out, leaf in leaves if leaf.grad is not None]
        torch.autograd.backward([out for out, _ in pairs], [grad for _, grad in pairs])
        return total

    def trouble(self, net: SdfNet) -> str:
        """Why this step must not be taken; empty when all is well."""
        if len(self.faces) == 0 or self.coverage < MIN_COVERAGE:
            return "The surface had nearly vanished"
        if not healthy_gradients(net):
            return "The gradient was not finite"
        return ""

    def _view_loss(
        self,
        draw: Draw,
        guidance: Guidance,
        embedding: Embedding,
        phase: PhaseConfig,
        coarse: bool,
    ) -> Tensor:
        cameras, cap = draw.cameras, self.config.gradient_cap
        n, o = render_normals(self.verts, self.faces, cameras, phase.size, guidance.normal_frame)
        self.coverage += float(o.detach().mean()) * len(cameras) / self.config.views
        if not coarse:
            z = guidance.encode_normals(n, o)
            return distill(guidance, z, embedding, Views(cameras), draw, phase, cap)[0]
        if self.config.rotate_normals and guidance.normal_frame == "camera":
            n = n @ random_rotations(len(n), self.generator).to(n)[:, None]
        z = coarse_latent(n, o, guidance.latent_size)
        loss, grad = distill(guidance, z, embedding, Views(cameras), draw, phase, cap)
        if self.follow_rays:
            loss = loss + self._ray_mask_loss(grad[:, 3], cameras)
        return loss

    def _ray_mask_loss(self, mask_grad: Float[Tensor, "b s s"], cameras: Cameras) -> Tensor:
        """Send the mask's score through the nearest miss of each ray too.

        A silhouette only moves where there is surface, so thin parts would not grow out of
        nothing: m = 2 sigmoid(-k min sdf) - 1 along the ray has a gradient in empty space.
        """
        size = min(RAY_PICTURE, mask_grad.shape[-1])
        pool = mask_grad.shape[-1] // size
        grad = torch.nn.functional.avg_pool2d(mask_grad[:, None], pool)[:, 0] * pool**2
        nearest = ray_min_sdf(self.sdf, self.grid, cameras, size, RAY_SAMPLES, self.generator)
        mask = 2 * torch.sigmoid(-self.sharpness * nearest) - 1
        return (grad * mask).sum()

    def _regularisers(self) -> Tensor:
        loss = torch.zeros((), device=self.verts.device)
        if self.config.eikonal > 0:
            loss = loss + self.config.eikonal * eikonal(self.sdf, self.grid)
        if self.config.smooth_normals > 0:
            loss = loss + self.config.smooth_normals * bending(self.verts, self.faces)
        return loss


def final_mesh(
    net: SdfNet, grid: TetGrid, polish: int = 0
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """Ψ's surface without small floating pieces, smoothed by ``polish`` rounds."""
    with torch.no_grad():
        surface = extract(net, grid)
    verts, faces = drop_floaters(surface.verts, surface.faces, FLOATER_SHARE)
    return polished(verts, faces, polish), faces


def random_rotations(n: int, generator: torch.Generator) -> Float[Tensor, "n 3 3"]:
    """Rotations, uniform over SO(3), as matrices for row vectors.

    From four normal deviates as a quaternion (Shoemake 1992).
    """
    w, x, y, z = torch.nn.functional.normalize(torch.randn(n, 4, generator=generator), dim=1).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return torch.stack([torch.stack(row, -1) for row in rows], 1)


def eikonal(sdf: Float[Tensor, " nt"], grid: TetGrid) -> Float[Tensor, ""]:
    """Mean of (|∇s| - 1)² over the lattice's inner nodes, by central differences."""
    s = sdf.view(grid.shape)
    inner = slice(1, -1)
    gradient = torch.stack(
        [
            s[2:, inner, inner] - s[:-2, inner, inner],
            s[inner, 2:, inner] - s[inner, :-2, inner],
            s[inner, inner, 2:] - s[inner, inner, :-2],
        ],
        -1,
    ) / (2 * grid.cell)
    length = (gradient.square().sum(-1) + 1e-12).sqrt()  # the root has no slope at 0
    return (length - 1).square().mean()


def bending(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Float[Tensor, ""]:
    """Mean of 1 - cos of the angle between neighbouring faces."""
    a, b, c = (verts.index_select(0, faces[:, k]) for k in range(3))
    n = torch.nn.functional.normalize(torch.linalg.cross(b - a, c - a), dim=-1, eps=1e-12)
    pairs = edge_table(faces).faces
    pairs = pairs[(pairs >= 0).all(1)]
    n0, n1 = n.index_select(0, pairs[:, 0]), n.index_select(0, pairs[:, 1])
    return (1 - (n0 * n1).sum(-1)).mean()
