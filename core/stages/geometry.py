"""The paper's first training: Ψ learns the shape from normals (§4.2, Eqs. 4, 5)."""

import math
from bisect import bisect_right
from collections.abc import Iterator
from itertools import accumulate

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.camera import Cameras, sample_cameras
from core.config import GeometryConfig, PhaseConfig, RefineConfig
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import drop_floaters, polished
from core.geometry.pieces import joined
from core.geometry.ray_sdf import ray_min_sdf
from core.geometry.sdf_net import Band, SdfNet, band_about, extract, sdf_on_grid
from core.geometry.tet_grid import TetGrid, tet_grid
from core.guidance.guidance import PromptedGuidance, Views, coarse_latent
from core.guidance.sds import NotFiniteError, anneal
from core.io.run_folder import RunFolder, Training
from core.render.antialias import EdgeTable, edge_table
from core.render.normals import render_normals
from core.stages.distill import Draw, decayed, distill
from core.stages.guard import MIN_COVERAGE, Guard, healthy_gradients
from core.stages.preview import ShapePreview
from core.stages.refine import Targets, denoised, fit_loss, refine_steps

RAY_PICTURE = 32  # side of the picture whose rays distilling follows through the lattice
SHARPNESS = (10.0, 60.0)  # of the mask along the rays, 1 / training unit, first and at last
RAY_SAMPLES = 40
BAND = 4  # cells to either side that a surface may move in one round of refining
FAR_NODES = 4096  # outside of the band, looked at in one step
FLOATER_SHARE = 0.08  # a piece smaller than this share of the largest is dropped


def learn_geometry(
    net: SdfNet,
    guidance: PromptedGuidance,
    config: GeometryConfig,
    run: RunFolder,
    generator: torch.Generator,
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """Train Ψ by score distillation; the mesh that its surface has in the end.

    Coarse phase: [n, o] itself is the latent. Fine phase: the normals are encoded. Where the
    config has them, rounds of fitting follow each: the first grows what is missing.
    """
    device = next(net.parameters()).device
    grids = [tet_grid(n, device=device) for n in config.resolution]
    optimizer = torch.optim.AdamW(net.parameters(), betas=(0.9, 0.99), eps=1e-15, weight_decay=0.0)
    training = Training(run, "geometry", net, optimizer, generator)
    training.resume()
    guard, preview = Guard(training), ShapePreview(run)
    parts = (config.coarse, config.grow, config.fine, config.refine)
    ends = list(
        accumulate(refine_steps(p) if isinstance(p, RefineConfig) else p.steps for p in parts)
    )
    distilling = config.coarse.steps + config.fine.steps

    for step in run.steps("geometry", training.step, ends[-1]):
        at = bisect_right(ends, step.index)
        part, index = parts[at], step.index - ends[at - 1] * (at > 0)
        grid = grids[at // 2]
        net.cell = grid.cell
        optimizer.zero_grad()
        try:
            if isinstance(part, RefineConfig):
                rate = part.learning_rate
                batch = fitting_batch(training, grid, guidance, config, part, index)
                losses = batch.fitted(guidance, Targets.of(training.kept), part)
            else:
                share = (index + (at > 0) * config.coarse.steps) / max(distilling - 1, 1)
                rate = decayed(config.learning_rate, config.learning_rate_end, share)
                sharpness = anneal(*SHARPNESS, share) if share < config.ray_mask_share else 0.0
                batch = Batch(net, grid, config, generator, sharpness)
                share = index / max(part.steps - 1, 1)
                losses = batch.distilled(guidance, part, share, coarse=at == 0)
            for group in optimizer.param_groups:
                group["lr"] = guard.rate * rate
            step.loss = batch.backward(losses)
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
    return final_mesh(net, grids[1], config)


def fitting_batch(
    training: Training,
    grid: TetGrid,
    guidance: PromptedGuidance,
    config: GeometryConfig,
    rounds: RefineConfig,
    index: int,
) -> "Batch":
    """The batch of a step of fitting, ``index`` among those of all ``rounds``.

    At a round's first step ``training.kept`` gets its pictures and, unless empty rays are followed,
    the band of the lattice.
    """
    net, generator = training.module, training.generator
    assert isinstance(net, SdfNet)
    round, begun = divmod(index, rounds.steps)
    fresh = not begun or not training.kept
    if rounds.ray_mask > 0:
        band, batch = None, Batch(net, grid, config, generator, SHARPNESS[1])
    else:
        names = Band._fields
        band = band_about(net, grid, BAND) if fresh else Band(*(training.kept[n] for n in names))
        batch = Batch(net, grid, config, generator, band=band)
    if fresh:
        targets = batch.targets(guidance, rounds, round)
        training.kept = targets.tensors() | (band._asdict() if band else {})
    return batch


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
        generator: torch.Generator,
        sharpness: float = 0.0,
        band: Band | None = None,
    ) -> None:
        """
        Args:
            sharpness: of the mask along the rays, 1 / training unit; 0 follows none.
            band: of the lattice, to keep to; with it the only regulariser is that nothing comes up
                outside, since the shape is nearly there and the pictures say all.
        """
        self.config, self.grid, self.generator = config, grid, generator
        self.net, self.band, self.sharpness = net, band, sharpness
        if sharpness > 0 or (band is None and config.eikonal > 0):
            self._sdf, positions = sdf_on_grid(net, grid)
            self._verts, self.faces = marching_tets(positions, self._sdf, grid)
            self.sdf = self._sdf.detach().requires_grad_()
        else:
            surface = extract(net, grid, band)
            self._verts, self.faces = surface.verts, surface.faces
            self._sdf = self.sdf = None
        self.verts = self._verts.detach().requires_grad_()
        self.edges = edge_table(self.faces)
        self.coverage = 0.0

    def distilled(
        self,
        guidance: PromptedGuidance,
        phase: PhaseConfig,
        share: float,
        coarse: bool,
    ) -> Iterator[Tensor]:
        """Score distillation (Eq. 5): the losses of the step's views, part by part."""
        config = self.config
        draw = Draw.of(config.views, config.cameras, guidance, phase, share, self.generator)
        for part in draw.split(config.views_at_once, self.verts.device):
            yield self._view_loss(part, guidance, phase, coarse) / config.views

    def targets(self, guidance: PromptedGuidance, rounds: RefineConfig, round: int) -> Targets:
        """The pictures of a round of fitting."""
        at_once = self.config.views_at_once
        cameras = sample_cameras(rounds.views, self.config.cameras, self.generator)
        cameras = cameras.to(self.verts.device)
        with torch.no_grad():
            parts = [slice(k, k + at_once) for k in range(0, rounds.views, at_once)]
            z = torch.cat([self._latent(guidance, cameras[part], rounds.size) for part in parts])
        share = round / max(rounds.rounds - 1, 1)
        return denoised(z, guidance, Views(cameras), rounds, share, self.generator)

    def fitted(
        self, guidance: PromptedGuidance, targets: Targets, rounds: RefineConfig
    ) -> Iterator[Tensor]:
        """Regression to some of the round's pictures: the losses of these, part by part."""
        some = targets.some(rounds.batch, self.generator)
        for part in some.split(self.config.views_at_once):
            loss = fit_loss(self._latent(guidance, part.cameras, rounds.size), part.z)
            if self.sharpness > 0:
                loss = loss + rounds.ray_mask * self._ray_fit(part)
            yield loss / len(some.z)

    def backward(self, losses: Iterator[Tensor]) -> float:
        """Gather the gradient of all views and of the regularisers into Ψ; the views' loss."""
        if len(self.faces) == 0:
            return math.nan
        total = 0.0
        for loss in losses:
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
        guidance: PromptedGuidance,
        phase: PhaseConfig,
        coarse: bool,
    ) -> Tensor:
        cameras, cap = draw.cameras, self.config.gradient_cap
        n, o = self._render(guidance, cameras, phase.size)
        if not coarse:
            z = guidance.encode_normals(n, o)
            return distill(guidance, z, Views(cameras), draw, phase, cap)[0]
        if self.config.rotate_normals and guidance.normal_frame == "camera":
            n = n @ random_rotations(len(n), self.generator).to(n)[:, None]
        z = coarse_latent(n, o, guidance.latent_size)
        loss, grad = distill(guidance, z, Views(cameras), draw, phase, cap)
        if self.sharpness > 0:
            loss = loss + self._ray_mask_loss(grad[:, 3], cameras)
        return loss

    def _render(
        self, guidance: PromptedGuidance, cameras: Cameras, size: int
    ) -> tuple[Tensor, Tensor]:
        """n and o of the views; the largest coverage of any part is remembered."""
        n, o = render_normals(
            self.verts, self.faces, cameras, size, guidance.normal_frame, self.edges
        )
        self.coverage = max(self.coverage, float(o.detach().mean()))
        return n, o

    def _latent(self, guidance: PromptedGuidance, cameras: Cameras, size: int) -> Tensor:
        return guidance.encode_normals(*self._render(guidance, cameras, size))

    def _ray_fit(self, targets: Targets) -> Tensor:
        """How far the mask along the rays is from the pictures', summed over these.

        By cross entropy, whose slope does not fade inside of what has to go: so holes open.
        """
        wanted = ((targets.z[:, 3] + 1) / 2).clamp(0, 1)
        size = wanted.shape[-1]
        nearest = ray_min_sdf(
            self.sdf, self.grid, targets.cameras, size, RAY_SAMPLES, self.generator
        )
        differ = torch.nn.functional.binary_cross_entropy_with_logits
        return differ(-self.sharpness * nearest, wanted, reduction="none").mean((1, 2)).sum()

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
        if self.band is not None:
            return strays(self.net, self.grid, self.band, self.generator)
        loss = torch.zeros((), device=self.verts.device)
        if self.config.eikonal > 0:
            loss = loss + self.config.eikonal * eikonal(self.sdf, self.grid)
        if self.config.smooth_normals > 0:
            loss = loss + self.config.smooth_normals * bending(self.verts, self.faces, self.edges)
        return loss


@torch.no_grad()
def final_mesh(
    net: SdfNet, grid: TetGrid, config: GeometryConfig
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """Ψ's surface without small floating pieces, joined and smoothed as the config has it."""
    surface = extract(net, grid)
    if config.join:
        surface = joined(surface, grid, FLOATER_SHARE)
    verts, faces = drop_floaters(surface.verts, surface.faces, FLOATER_SHARE)
    return polished(verts, faces, config.polish), faces


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


def strays(net: SdfNet, grid: TetGrid, band: Band, generator: torch.Generator) -> Float[Tensor, ""]:
    """How far Ψ falls short, in cells, of the side that nodes outside of the band were on.

    Of ``FAR_NODES`` nodes, drawn at random. The pictures say nothing of them, so that a network
    which is fitted to the band alone may put walls where nothing was.
    """
    outside = torch.ones(len(grid.tet_verts), dtype=torch.bool, device=grid.tet_verts.device)
    outside[band.near] = False
    nodes = outside.nonzero().squeeze(1)
    if not len(nodes):
        return band.sdf.new_zeros(())
    nodes = nodes[torch.randint(len(nodes), (FAR_NODES,), generator=generator).to(nodes.device)]
    kept = band.sdf.index_select(0, nodes)
    sdf, _ = net(grid.tet_verts.index_select(0, nodes))
    return (kept.abs().clamp_max(grid.cell) - sdf * kept.sign()).clamp_min(0).mean() / grid.cell


def bending(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], edges: EdgeTable
) -> Float[Tensor, ""]:
    """Mean of 1 - cos of the angle between neighbouring faces."""
    a, b, c = (verts.index_select(0, faces[:, k]) for k in range(3))
    n = torch.nn.functional.normalize(torch.linalg.cross(b - a, c - a), dim=-1, eps=1e-12)
    pairs = edges.faces
    pairs = pairs[(pairs >= 0).all(1)]
    n0, n1 = n.index_select(0, pairs[:, 0]), n.index_select(0, pairs[:, 1])
    return (1 - (n0 * n1).sum(-1)).mean()
