"""The settings of one job: its preset, with what its own options change."""

from dataclasses import replace

from core.appearance.material_ranges import LocalRanges, MaterialRanges
from core.config import DRAFT, AppearanceConfig, Config, PhaseConfig, preset
from core.geometry.sdf_net import SdfNetConfig
from core.guidance.guidance import Areas
from core.io.job import Job
from core.settings import check, with_settings

BUILTIN = "builtin"  # the guidance of that name
SEEN = 64  # pixels of the built-in prior's pictures
# Scale of the lattice that holds what Ψ lacks of a guide: it then moves a tenth as fast as Ψ.
GUIDE_RESIDUAL = 0.1

START_RESIDUAL = 0.1  # the same, of a solid that the guidance draws
START_REACH = 0.012  # of the sharpening: a third of a fine cell, where growing is off by more
START_POLISH = 2  # rounds: what is drawn is smooth, and more would take its details

# Settings of the geometry's training that belong to the built-in prior, not to a preset. The
# learning rate is not among them: it belongs to Ψ's encoding.
OF_THE_PRIOR = (
    "cameras",
    "learning_rate_end",
    "gradient_cap",
    "gradient_clip",
    "ray_mask_share",
    "eikonal",
    "smooth_normals",
)


def config_of(job: Job) -> Config:
    """The preset with the guidance's ranges and the job's own sizes and settings."""
    config = preset(job.preset)
    if job.guidance == BUILTIN:
        config = with_builtin(config)
    if job.texture_size:
        config = replace(config, texture=replace(config.texture, size=job.texture_size))
    if job.max_faces:
        config = replace(config, texture=replace(config.texture, max_faces=job.max_faces))
    config = started(config, job)
    # Before what a strength shortens: it then shortens what the user has set, too.
    config = with_settings(config, job.settings)
    check(config)
    if is_kept(job):  # whatever the settings are: a drawn solid would be used as the shape
        config = replace(config, geometry=replace(config.geometry, start="ellipsoid"))
    if job.base_color:
        config = retouching(config, job.guide_strength)
    if job.guide_mesh:
        config = shortened(config, job.guide_strength)
    learned = job.command == "generate" and not is_kept(job)
    return trained_together(config) if learned else config


def is_kept(job: Job) -> bool:
    """Whether the guide itself is the shape: nothing is drawn then, and nothing learned of it."""
    return bool(job.guide_mesh) and job.guide_strength == 1


def started(config: Config, job: Job) -> Config:
    """``config`` for the geometry's start: a drawn solid, where the job can have one.

    Then nothing is left to distil, to grow, to refine and to sharpen, and the solid itself
    becomes the mesh, unless the job's own settings differ; then the fine lattice holds what Ψ
    lacks of the solid.
    """
    g, asked = config.geometry, with_settings(config, job.settings).geometry
    # An ablation learns the shape in another way, which is what it is there to show.
    able = job.guidance == BUILTIN and not is_kept(job) and asked.pictures == "normals"
    if asked.start != "learned" or not able:
        return replace(config, geometry=replace(g, start="ellipsoid"))
    less = replace(
        g,
        coarse=replace(g.coarse, steps=0),
        grow=replace(g.grow, rounds=0),
        refine=replace(g.refine, rounds=0),
        net=replace(g.net, residual=g.net.residual or START_RESIDUAL),
        polish=min(g.polish, START_POLISH),
        sharpen=replace(g.sharpen, rounds=0, close_rounds=1, reach=START_REACH),
    )
    return replace(config, geometry=less)


def trained_together(config: Config) -> Config:
    """``config`` without the appearance's phases where Γ is learned with the shape."""
    if config.geometry.pictures != "entangled":
        return config
    a = config.appearance
    early, late = replace(a.early, steps=0), replace(a.late, steps=0)
    less = replace(a, early=early, late=late, refine=replace(a.refine, rounds=0))
    return replace(config, appearance=less)


def with_builtin(config: Config) -> Config:
    """``config`` with what the built-in prior was tuned for: pictures, noise, scales, rates, caps.

    A guidance scale of 100 without a cap, right for Stable Diffusion, makes its surfaces vanish.
    Steps, views, lattices, rates of Ψ, networks but for their finest level and the phases stay the
    preset's.
    """
    g, a = DRAFT.geometry, DRAFT.appearance
    refine = config.appearance.refine
    # Where fitting has the last word, the pictures are as small as the prior sees them.
    small = {"size": SEEN} if refine.rounds else {}
    return replace(
        config,
        geometry=replace(
            config.geometry,
            coarse=replace(g.coarse, steps=config.geometry.coarse.steps),
            fine=replace(g.fine, steps=config.geometry.fine.steps),
            net=no_finer_than(config.geometry.net, config.geometry.resolution[1]),
            **{name: getattr(g, name) for name in OF_THE_PRIOR},
        ),
        appearance=replace(
            config.appearance,
            early=replace(a.early, steps=config.appearance.early.steps, **small),
            late=replace(a.late, steps=config.appearance.late.steps, **small),
            refine=replace(refine, **small),
            cameras=a.cameras,
            learning_rate=a.learning_rate,
            learning_rate_end=a.learning_rate_end,
            gradient_cap=a.gradient_cap,
        ),
    )


def no_finer_than(net: SdfNetConfig, resolution: int) -> SdfNetConfig:
    """``net`` without levels of its hash grid that are finer than the lattice.

    There each node has features of its own, and few noisy pictures of 64² crumple the surface: in
    a short run of ``standard`` to a genus of 166, with these levels out to 0.
    """
    return replace(net, finest=min(net.finest, resolution)) if net.encoding == "hash" else net


def shortened(config: Config, strength: float) -> Config:
    """``config`` for a guide mesh: less of what decides the shape, which is noise and length.

    ``strength`` 0 leaves all as it is; towards 1 all steps go to 0, and with them what smooths and
    cleans up. What is apart in the guide stays apart.
    """
    g, keep = config.geometry, 1 - strength
    steps, rounds = round(g.coarse.steps * keep), round(g.grow.rounds * keep)
    coarse = replace(_calmed(g.coarse, strength), steps=steps)
    grow = replace(g.grow, rounds=rounds, t=_calmer(g.grow.t, strength))
    fine = replace(g.fine, steps=round(g.fine.steps * keep))
    less = round(g.refine.steps * keep)
    refine = replace(g.refine, steps=less, t=_calmer(g.refine.t, strength))
    rate = g.learning_rate * (0.05 + 0.95 * keep)
    shorter = replace(g, coarse=coarse, grow=grow, fine=fine, refine=refine, learning_rate=rate)
    floaters, polish = g.floaters * keep, round(g.polish * keep)
    kept = replace(shorter, floaters=floaters, polish=polish, join=g.join and strength == 0)
    net = replace(g.net, residual=GUIDE_RESIDUAL) if strength > 0 else g.net
    return replace(config, geometry=replace(kept, net=net))


def retouching(config: Config, strength: float) -> Config:
    """``config`` for a base colour to start from: less of what paints over it.

    ``strength`` 0 leaves all as it is; at 1 the late phase alone touches up.
    """
    a, keep = config.appearance, 1 - strength
    early = replace(a.early, steps=round(a.early.steps * keep))
    steps = max(1, round(a.late.steps * (0.2 + 0.8 * keep)))
    late = replace(_calmed(a.late, strength), steps=steps)
    rounds, fewer = (a.refine.rounds if keep else 0), max(1, round(a.refine.steps * keep))
    refine = replace(a.refine, rounds=rounds, steps=fewer, t=_calmer(a.refine.t, strength))
    rate = a.learning_rate * (0.02 + 0.98 * keep)
    less = replace(a, early=early, late=late, refine=refine, learning_rate=rate)
    return replace(config, appearance=less)


def within(config: AppearanceConfig, bounds: MaterialRanges | None) -> AppearanceConfig:
    """``config`` with the bounds that the words set; without a specular layer it is matte."""
    if config.shading == "diffuse":
        # The asset cannot express it otherwise: Blender's specular layer is weakest there.
        return replace(config, roughness_range=(1.0, 1.0), metallic_range=(0.0, 0.0))
    if bounds is None:
        return config
    return replace(config, roughness_range=bounds.roughness, metallic_range=bounds.metallic)


def local_ranges(config: AppearanceConfig, areas: Areas | None) -> LocalRanges | None:
    """Each area's own bounds; None where the areas are unknown, or all is matte."""
    if areas is None or config.shading == "diffuse":
        return None
    return LocalRanges(areas.nearest(), [one.ranges for one in areas.each], config.kd_range)


def _calmed(phase: PhaseConfig, strength: float) -> PhaseConfig:
    """``phase`` with calmer noise, and the least of it no more than that."""
    high = _calmer(phase.t_high, strength)
    return replace(phase, t_high=high, t_low=min(phase.t_low, *high))


def _calmer(t: tuple[float, float], strength: float) -> tuple[float, float]:
    """Half the noise at ``strength`` 1: what was there before shows through it."""
    return t[0] * (1 - strength / 2), t[1] * (1 - strength / 2)
