"""The paper's first training: Ψ learns the shape from normals (§4.2, Eqs. 4, 5)."""

import math
from collections.abc import Iterator
from dataclasses import replace

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.config import GeometryConfig, PhaseConfig, RefineConfig
from core.errors import NoSurfaceError
from core.geometry.bilateral import flattened
from core.geometry.crisp import crisp
from core.geometry.leash import Leash
from core.geometry.mesh import Mesh, drop_floaters, polished
from core.geometry.parts.assembly import KnownParts, assembled
from core.geometry.parts.components import ERROR
from core.geometry.parts.forms import Forms
from core.geometry.ray_sdf import ray_min_sdf
from core.geometry.revolved import revolved
from core.geometry.sdf_net import Band, SdfNet, band_about, extract
from core.geometry.struts import joined_by_struts
from core.geometry.tet_grid import EXTENT, TetGrid, tet_grid
from core.guidance.guidance import Views, coarse_latent
from core.guidance.sds import anneal
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.stages.distill import Draw, distill
from core.stages.lit_shape import LitShape
from core.stages.preview import show_shape
from core.stages.refine import Targets, fit_loss, round_targets
from core.stages.regularisers import bending, eikonal, strays
from core.stages.room import LIT, NORMALS
from core.stages.shape_scene import ShapeScene, use_lattice
from core.stages.sharpen import sharpened
from core.stages.training import Phase, Setup, decayed, fraction, train

RAY_PICTURE = 32  # side of the picture whose rays distilling follows through the lattice
# The mask's gradient reaches about 1 / sharpness: a tenth of a unit at first, which starts parts
# far from the surface, a third of a coarse cell at last, which places them.
SHARPNESS = (10.0, 60.0)  # of the mask along the rays, 1 / training unit, first and at last
RAY_SAMPLES = 40  # one for each cell of the draft's coarse lattice
EARLY_ROUNDS = 0.5  # fraction of growing's rounds that a first look at the shape takes
BAND = 4  # cells to either side that a surface may move in one round of refining

ShapeSetup = Setup[SdfNet, GeometryConfig]


def learn_geometry(
    setup: ShapeSetup, progress: Progress, lit: LitShape | None = None, *, early: bool = False
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]] | None:
    """Train Ψ by score distillation; the mesh that its surface has in the end.

    ``lit``: from shaded pictures, an ablation; None: from normals, the paper's way. ``early``: only
    so far that one recognises the shape, which is then the preview too. Of several processes the
    first one alone makes the mesh; the others get None.
    """
    training, config = setup.training, setup.config
    training.resume()
    sizes = (part.size for part in (config.coarse, config.grow, config.fine, config.refine))
    setup.fit(NORMALS if lit is None else LIT, sizes)
    coarse, fine = (tet_grid(n, device=training.device) for n in config.resolution)
    phases = geometry_phases(setup, coarse, fine, lit)
    stop = early_steps(config) if early else None
    train(setup, phases, progress, config.gradient_clip, stop)
    if not setup.ranks.first:
        return None
    if early:
        # What a solid is drawn with is held by the fine lattice.
        grid = coarse if training.module.residual is None else fine
        verts, faces = final_mesh(training.module, grid, config)
        show_shape(training.run, verts, faces)
        return verts, faces
    verts, faces = final_mesh(training.module, fine, config)
    show_shape(training.run, verts, faces)
    with progress.timed("sharpen"):
        sharp = sharpened(config, setup.guidance, verts, faces, progress)
        if training.module.leash is not None:
            sharp = training.module.leash.hold(sharp)
        parts = setup.guidance.parts() if config.forms else None
        if parts is None:
            return sharp, faces
        of, cell = parts.distances(sharp).argmin(1), 2 * EXTENT / config.resolution[1]
        sharp = revolved(sharp, faces, of, parts.forms.round, cell)
        return crisp(sharp, faces, verts, of, parts.forms.flat, cell)


def assembled_shape(
    parts: KnownParts,
    config: GeometryConfig,
    run: RunFolder,
    progress: Progress,
    leash: Leash | None = None,
) -> Mesh:
    """The drawn solid's mesh, part by part: where nothing is to be learnt, the solid is the shape.

    ``leash``: of a guide.

    Raises:
        NoSurfaceError: it has no surface.
    """
    exact = config.forms
    if leash is not None:
        parts = leashed(parts, leash)
        exact = exact and leash.reach > max(ERROR)  # or what is made exact strains at it
    with progress.timed("geometry"):
        made = assembled(
            parts,
            exact,
            config.floaters,
            lambda done: progress.advance("geometry", round(100 * done), 100),
        )
        if made is None:
            raise NoSurfaceError("The drawn solid has no surface.", "Use another seed.")
        verts, faces = made
        verts = verts if leash is None else leash.hold(verts)
        show_shape(run, verts, faces)
        progress.complete("geometry")
    return Mesh(verts, faces)


def leashed(parts: KnownParts, leash: Leash) -> KnownParts:
    """``parts`` within the leash, and the guide's inside, which is neither flat nor round."""
    flat, around, cornered, *_ = parts.forms
    distances = leash.parts(parts.distances, len(flat))
    # The leash may cut components small.
    forms = Forms((*flat, 0.0), tuple((*axis, 0.0) for axis in around), cornered)
    return KnownParts(distances, forms, parts.wider)


def learns(config: GeometryConfig) -> bool:
    """Whether there is anything that Ψ or its mesh would learn from pictures."""
    steps = [phase.steps for phase in (config.coarse, config.fine)]
    return any([*steps, config.grow.rounds, config.refine.rounds, config.sharpen.rounds])


def early_steps(config: GeometryConfig) -> int:
    """Steps after which the shape is recognisable: distilling's, and some rounds of growing."""
    rounds = math.ceil(EARLY_ROUNDS * config.grow.rounds)
    return config.coarse.steps + rounds * config.grow.steps


def geometry_phases(
    setup: ShapeSetup, coarse: TetGrid, fine: TetGrid, lit: LitShape | None = None
) -> list[Phase]:
    """The geometry's phases in their order, on the coarse and on the fine lattice."""
    config = setup.config
    return [
        # [n, o] itself is the latent: no encoder, so the rough shape comes quickly (§4.2).
        Distillation(setup, coarse, "coarse", before=0, lit=lit),
        # Beyond the paper: grows what distilling leaves out, such as legs, and opens holes.
        Fitting(setup, coarse, "grow", lit),
        # The normals are encoded as pictures are: the details (§4.2).
        Distillation(setup, fine, "fine", before=config.coarse.steps, lit=lit),
        # Beyond the paper: takes the dents out of planes; the shape moves little.
        Fitting(setup, fine, "refine", lit),
    ]


class Distillation(Phase):
    """Score distillation from normals (Eq. 5): the phases ``coarse`` and ``fine``."""

    def __init__(
        self,
        setup: ShapeSetup,
        grid: TetGrid,
        name: str,
        before: int,
        lit: LitShape | None = None,
    ) -> None:
        """``before``: steps of distillation in earlier phases; rate and rays follow them all."""
        self.setup, self.grid, self.name, self.before = setup, grid, name, before
        self.lit = lit
        # A shaded picture is no [n, o]: it is encoded in the coarse phase too, and has no rays.
        self.coarse = name == "coarse" and lit is None
        self.phase: PhaseConfig = getattr(setup.config, name)
        self.steps = self.phase.steps

    def learning_rate(self, index: int) -> float:
        """It falls over both phases together."""
        config = self.setup.config
        return decayed(config.learning_rate, config.learning_rate_end, self._progress(index))

    def sharpness(self, index: int) -> float:
        """The sharpness of the mask along rays; 0: not used (fine phase, complete shape)."""
        progress = self._progress(index)
        if not self.coarse or progress >= self.setup.config.ray_mask_share:
            return 0.0
        return anneal(*SHARPNESS, progress)

    def begin(self, index: int) -> tuple[ShapeScene, Iterator[Tensor]]:
        """The surface of now, and the losses of its views and of the regularisers."""
        setup = self.setup
        # Rays and the eikonal term read the SDF off the surface; without them only nodes at it are
        # needed.
        lattice = self.sharpness(index) > 0 or setup.config.eikonal > 0
        lit = self.lit and self.lit.turned(setup.training.generator)
        net, guidance = setup.training.module, setup.guidance
        scene = ShapeScene(net, self.grid, guidance, lattice=lattice, lit=lit)
        return scene, self._losses(scene, index)

    def draw(self, index: int) -> Draw:
        """The step's random numbers."""
        setup, generator = self.setup, self.setup.training.generator
        config, guidance = setup.config, setup.guidance
        draw = Draw.of(setup, self.phase, fraction(index, self.steps))
        if not self.coarse:
            return draw
        # §4.2: a latent diffusion model must not read meaning into one direction's colour. A prior
        # that was trained on normals in the object's frame knows them, and is left alone.
        if config.rotate_normals and guidance.normal_frame == "camera":
            draw = replace(draw, rotations=random_rotations(config.views, generator))
        if self.sharpness(index) > 0:
            side = min(RAY_PICTURE, guidance.latent_size)
            shift = torch.rand(config.views, side, side, generator=generator)
            draw = replace(draw, ray_shift=shift)
        return draw

    def _losses(self, scene: ShapeScene, index: int) -> Iterator[Tensor]:
        config = self.setup.config
        ranks = self.setup.ranks
        for part in self.draw(index).split(self.setup.at_once, scene.device, ranks):
            loss = self._coarse(scene, part, index) if self.coarse else self._fine(scene, part)
            yield loss / config.views
        # The same in each process, whose gradients are added up: it counts once.
        yield from (loss / ranks.world for loss in smoothness(scene, config))

    def _coarse(self, scene: ShapeScene, part: Draw, index: int) -> Tensor:
        """z = [n R, 2o - 1], downsampled (§4.2)."""
        n, o = scene.render(part.cameras, self.phase.size)
        # The vectors turn, the picture does not: the silhouette stays the prompt's.
        if part.rotations is not None:
            n = n @ part.rotations[:, None]
        z = coarse_latent(n, o, self.setup.guidance.latent_size)
        loss, grad = distill(self.setup, self.phase, part, z, Views(part.cameras))
        if part.ray_shift is None:
            return loss
        # The fourth channel of the coarse latent is the mask.
        return loss + ray_mask_loss(scene, grad[:, 3], part, self.sharpness(index))

    def _fine(self, scene: ShapeScene, part: Draw) -> Tensor:
        """z = E(n), the encoder's (Eq. 5)."""
        z, views = scene.latents(part.cameras, self.phase.size)
        return distill(self.setup, self.phase, part, z, views)[0]

    def _progress(self, index: int) -> float:
        config = self.setup.config
        return fraction(self.before + index, config.coarse.steps + config.fine.steps)


class Fitting(Phase):
    """Rounds of fitting to denoised pictures: the phases ``grow`` and ``refine``."""

    def __init__(
        self, setup: ShapeSetup, grid: TetGrid, name: str, lit: LitShape | None = None
    ) -> None:
        self.setup, self.grid, self.name, self.lit = setup, grid, name, lit
        self.rounds: RefineConfig = getattr(setup.config, name)
        self.steps = self.rounds.rounds * self.rounds.steps

    def learning_rate(self, index: int) -> float:
        """The same in all steps."""
        del index
        return self.rounds.learning_rate

    def begin(self, index: int) -> tuple[ShapeScene, Iterator[Tensor]]:
        """The surface of now, and the losses of some of the round's pictures."""
        net, guidance = self.setup.training.module, self.setup.guidance
        label = f"{self.name} {index // self.rounds.steps}"
        # Growing follows the rays, so the whole lattice moves. Refining keeps to a band about the
        # surface that its round started from, and evaluates nothing else: the target is near.
        rays = self.rounds.ray_mask > 0
        band = None if rays else self._band(label)
        lit = self.lit and self.lit.turned(self.setup.training.generator)
        scene = ShapeScene(net, self.grid, guidance, lattice=rays, band=band, lit=lit)
        return scene, self._losses(scene, label)

    def _band(self, label: str) -> Band:
        """That of the round's first step, which is in the checkpoints."""
        kept, net = self.setup.training.kept(label), self.setup.training.module
        if kept:
            return Band(*(kept[name] for name in Band._fields))
        use_lattice(net, self.grid)
        return band_about(net, self.grid, BAND)

    def _losses(self, scene: ShapeScene, label: str) -> Iterator[Tensor]:
        setup, rounds, at_once = self.setup, self.rounds, self.setup.at_once
        generator, ranks = setup.training.generator, setup.ranks
        also = scene.band._asdict() if scene.band else {}
        some = round_targets(setup, rounds, scene, label, **also).some(rounds.batch, generator)
        rays, mask = rounds.ray_mask > 0, some.z[:, 3]
        # Drawn for all views at once, as a Draw is.
        shifts = torch.rand(mask.shape, generator=generator) if rays else torch.zeros(mask.shape)
        parts = zip(some.split(at_once, ranks), shifts[ranks.own].split(at_once), strict=True)
        for part, shift in parts:
            z, _ = scene.latents(part.cameras, rounds.size)
            loss = fit_loss(z, part.z)
            if rays:
                loss = loss + rounds.ray_mask * ray_fit(scene, part, shift)
            yield loss / len(some.z)
        if scene.band is None:
            yield from (loss / ranks.world for loss in smoothness(scene, setup.config))
        else:  # the shape is nearly complete, and the pictures determine it; but only in the band
            yield strays(scene.net, self.grid, scene.band, generator) / ranks.world


def smoothness(scene: ShapeScene, config: GeometryConfig) -> Iterator[Tensor]:
    """The regularisers of a lattice that may move everywhere."""
    if config.eikonal > 0 and scene.sdf is not None:
        yield config.eikonal * eikonal(scene.sdf, scene.grid)
    if config.smooth_normals > 0:
        yield config.smooth_normals * bending(scene.verts, scene.faces, scene.edges)


def ray_mask_loss(
    scene: ShapeScene, mask_grad: Float[Tensor, "b s s"], draw: Draw, sharpness: float
) -> Float[Tensor, ""]:
    """Send the mask's score through the nearest miss of each ray too.

    A silhouette only moves where there is surface, so thin parts would not grow out of nothing:
    m = 2 sigmoid(-k min sdf) - 1 along the ray has a gradient in empty space.
    """
    assert scene.sdf is not None and draw.ray_shift is not None
    pool = mask_grad.shape[-1] // draw.ray_shift.shape[-1]
    # Summed over the pixels that share a ray, so that the whole score stays what it was.
    grad = torch.nn.functional.avg_pool2d(mask_grad[:, None], pool)[:, 0] * pool**2
    nearest = ray_min_sdf(scene.sdf, scene.grid, draw.cameras, RAY_SAMPLES, draw.ray_shift)
    # In [-1, 1], the range of the latent's mask, so that the score applies to it as it is.
    mask = 2 * torch.sigmoid(-sharpness * nearest) - 1
    return (grad * mask).sum()


def ray_fit(scene: ShapeScene, part: Targets, shift: Float[Tensor, "b s s"]) -> Float[Tensor, ""]:
    """How far the mask along the rays is from the pictures', summed over these.

    By cross entropy, whose slope does not fade inside of what has to go: so holes open.
    """
    assert scene.sdf is not None
    # A denoised mask may overshoot; cross entropy takes probabilities.
    wanted = ((part.z[:, 3] + 1) / 2).clamp(0, 1)
    nearest = ray_min_sdf(scene.sdf, scene.grid, part.cameras, RAY_SAMPLES, shift)
    # With logits: far from the surface the sigmoid itself is 0 or 1, and its logarithm infinite.
    differ = torch.nn.functional.binary_cross_entropy_with_logits
    return differ(-SHARPNESS[1] * nearest, wanted, reduction="none").mean((1, 2)).sum()


@torch.no_grad()
def final_mesh(
    net: SdfNet, grid: TetGrid, config: GeometryConfig
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """Ψ's surface without small floating components, joined and smoothed as the config has it.

    Raises:
        NoSurfaceError: there is none.
    """
    use_lattice(net, grid)
    surface = extract(net, grid)
    if len(surface.faces) == 0:  # the guard looks before each step, and none follows the last
        raise NoSurfaceError(
            "The surface vanished in the geometry's last step.",
            "Use another seed, a --guide mesh, or a lower --set geometry.learning_rate.",
        )
    if config.join:  # before small components are dropped: a thin part may have come off
        surface = joined_by_struts(surface, grid, config.floaters)
    # Smoothing moves vertices and keeps the faces, so it comes after all that changes these.
    verts, faces = drop_floaters(surface.verts, surface.faces, config.floaters)
    verts = polished(verts, faces, config.polish)
    verts = flattened(verts, faces, config.flatten, config.flatten_sigma)
    return verts if net.leash is None else net.leash.hold(verts), faces


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
