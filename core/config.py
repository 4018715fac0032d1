"""Settings of a run: frozen dataclasses nested by stage, and the presets.

``paper`` is the paper's text with the released code's values where the text is silent;
``standard`` is the same method on one GPU; ``draft`` is for the built-in prior on a CPU, and
``sds`` is the draft by score distillation alone. A preset sets how much work is done;
:func:`core.job_config.with_builtin` puts the built-in prior's own scales and caps into any.
"""

from dataclasses import dataclass, field, replace
from typing import Annotated, Literal

from core.camera import CameraConfig
from core.errors import UserError, shown
from core.geometry.sdf_net import FOURIER, HASH, SdfNetConfig
from core.ranges import (
    Count,
    Fraction,
    Fractions,
    Interval,
    Pixels,
    Range,
    Rate,
    Scale,
    Squares,
    Steps,
    Weight,
)

SPHERE = CameraConfig()
Left = Annotated[float, Range(1e-6, 1)]  # of a rate that falls exponentially: never to 0
Weighting = Literal["sigma2", "sigma2_sqrt", "inv_sigma2"]
Prediction = Literal["auto", "epsilon", "v_prediction"]
Distillation = Literal["sds", "csd", "sdi"]
ShadingModel = Literal["lobes", "split_sum", "diffuse"]
ShapePictures = Literal["normals", "shaded", "entangled"]
Curve = Literal["linear", "srgb"]
Start = Literal["ellipsoid", "learned"]
Style = Literal["stated", "none", "low_poly", "voxels"]


@dataclass(frozen=True, kw_only=True)
class PhaseConfig:
    """One phase of a training: how much noise is added, and how its score is weighed."""

    steps: Steps
    size: Pixels  # side of the rendered picture, pixels
    weighting: Weighting  # w(t)
    t_low: Fraction = 0.02  # fraction of the diffusion's T steps
    t_high: Fractions = (0.5, 0.5)  # at the phase's first and last step
    guidance_scale: Scale = 100.0  # 1 is no guidance
    distillation: Distillation = "sds"  # see core/guidance/sds.py; sdi takes t_high itself for t
    csd_negative: Fractions = (0.0, 0.5)  # weight of csd's negative prompt, first and last step
    inversion_steps: Annotated[int, Range(1, 1000)] = 10  # of sdi: predictions for one noise


@dataclass(frozen=True, kw_only=True)
class RefineConfig:
    """A phase beyond the paper: rounds of regression to denoised pictures."""

    rounds: Steps = 0  # 0 leaves it out
    steps: Count = 40  # of the optimiser, in one round
    views: Count = 20  # pictures of one round
    batch: Count = 10  # of them in one step
    size: Pixels = 128  # side of the rendered picture, pixels
    t: Fractions = (0.5, 0.25)  # noise given to the pictures, first and last round
    ray_mask: Weight = 0.0  # weight of the mask along empty rays; the whole lattice then moves
    denoise_steps: Count = 5
    guidance_scale: Scale = 3.0
    restore: bool = False  # where the guidance can, instead of noise and denoising
    learning_rate: Rate = 2e-3


@dataclass(frozen=True, kw_only=True)
class SharpenConfig:
    """Beyond the paper: the finished mesh follows its own renders made crisp by the guidance."""

    rounds: Steps = 0  # 0 leaves it out
    close_rounds: Steps = 0  # the last ones of these, which look closely at parts
    views: Count = 40  # pictures of one round
    passes: Count = 2  # of the guidance's restoring over each picture
    steps: Count = 30  # of descent on the vertices, in one round
    batch: Count = 10  # pictures of one step
    size: Pixels = 128  # side of the rendered picture, pixels
    learning_rate: Rate = 0.02
    stiffness: Weight = 10.0  # λ of core.geometry.large_steps
    reach: Weight = 0.0  # training units that a vertex may move in all; 0: any way


@dataclass(frozen=True, kw_only=True)
class GeometryConfig:
    """Ψ and its training (§4.1, §4.2)."""

    net: SdfNetConfig = HASH
    # Lattice cubes along an edge, coarse and fine; 65³ nodes are what others call a 128 grid.
    resolution: Annotated[tuple[int, int], Range(4, 512)] = (64, 64)
    # Of Ψ without a guide mesh: the paper's ellipsoid, or a solid that the guidance draws for the
    # prompt (where it can), which leaves nothing to find to the phases coarse and grow.
    start: Start = "ellipsoid"
    # The ellipsoid, training units; the lattice reaches 1.05.
    radii: Annotated[tuple[float, float, float], Range(0.05, 1.0)] = (0.6, 0.6, 0.6)
    fit_steps: Count = 401  # Eq. 3
    # A guide that faces another way than what the guidance knows is turned for the trainings.
    find_front: bool = True
    coarse: PhaseConfig = PhaseConfig(steps=1500, size=512, weighting="sigma2")
    grow: RefineConfig = RefineConfig()  # on the coarse lattice
    fine: PhaseConfig = PhaseConfig(steps=1500, size=512, weighting="sigma2_sqrt")
    refine: RefineConfig = RefineConfig()
    sharpen: SharpenConfig = SharpenConfig()
    # For a region whose shape is edited: from much noise, or a dent is mistaken for a request.
    reshape: RefineConfig = RefineConfig(
        rounds=6, steps=30, views=16, batch=6, t=(0.7, 0.25), learning_rate=0.03
    )
    views: Count = 24  # cameras of one step
    # Cameras rendered together, at most: a GPU takes fewer where its memory is short (room.py).
    views_at_once: Count = 24
    cameras: CameraConfig = SPHERE
    learning_rate: Rate = 1e-3
    learning_rate_end: Left = 1.0  # fraction of the rate that is left at the last step
    rotate_normals: bool = True  # the coarse phase's augmentation (§4.2), for latent diffusion
    # Learned from normals (§4.2), or (ablations) from pictures of clay, or of Γ, learned with it.
    pictures: ShapePictures = "normals"
    gradient_cap: Weight = 0.0  # upper bound of the score's RMS; 0 is none
    gradient_clip: Weight = 0.0  # upper bound of the norm of Ψ's gradient; 0 is none
    # Fraction of all distilling steps, from the first on: the coarse ones among them also move the
    # mask along empty rays.
    ray_mask_share: Fraction = 0.0
    eikonal: Weight = 0.0  # weight of (|∇s| - 1)²
    smooth_normals: Weight = 0.0  # weight of 1 - cos between adjacent faces
    join: bool = False  # struts between the connected components of the finished mesh
    floaters: Fraction = 0.08  # a component of less area than this much of the largest is dropped
    polish: Annotated[int, Range(0, 1000)] = 0  # rounds of Taubin smoothing of the finished mesh
    # Rounds of bilateral filtering of its normals after that.
    flatten: Annotated[int, Range(0, 1000)] = 0
    # How far unit normals may differ and still be of one plane.
    flatten_sigma: Annotated[float, Range(0.01, 2.0)] = 0.3
    forms: bool = True  # of known parts: what was meant to be flat or round is exactly so
    style: Style = "stated"  # of the finished shape; stated: the prompt's, where it has one
    # Low poly: a twentieth of the surface may be off by more, of the longest side.
    facet_error: Annotated[float, Range(1e-4, 0.1)] = 0.005
    voxels: Annotated[int, Range(4, 128)] = 32  # along the longest side


@dataclass(frozen=True, kw_only=True)
class AppearanceConfig:
    """Γ and its training (§4.3)."""

    hidden: Annotated[int, Range(1, 4096)] = 32
    layers: Annotated[int, Range(1, 16)] = 2
    log2_hash_size: Annotated[int, Range(4, 24)] = 19
    finest: Annotated[int, Range(16, 65536)] = 4096
    early: PhaseConfig = PhaseConfig(steps=1000, size=512, weighting="sigma2_sqrt")
    late: PhaseConfig = PhaseConfig(steps=1000, size=512, weighting="inv_sigma2")
    refine: RefineConfig = RefineConfig()
    views: Count = 24
    views_at_once: Count = 24
    cameras: CameraConfig = SPHERE
    learning_rate: Rate = 1e-2
    learning_rate_end: Left = 1.0  # fraction left at the end of distilling and of refining
    gradient_cap: Weight = 0.0
    shading: ShadingModel = "lobes"  # as in Cycles; the paper's split sum; or without a specular
    # The object shadows itself and shines on itself, as in Cycles; the built-in prior's pictures
    # know no such shadows.
    self_shadow: bool = False
    rotate_light: bool = True  # a fixed light bakes into kd
    kd_range: Interval = (0.03, 0.97)
    kd_curve: Curve = "linear"  # what kd's sigmoid runs over
    roughness_range: Interval = (0.08, 0.9)
    metallic_range: Interval = (0.0, 1.0)
    # Fraction of its range that metallic starts at; at an end a sigmoid has no slope.
    metallic_start: Annotated[float, Range(0.001, 0.999)] = 0.5
    bump: Annotated[float, Range(0, 10)] = 1.0  # reach of kn's x and y; 0 leaves the surface smooth
    smooth: Weight = 0.0  # weight of the material's change between neighbouring points
    # Strength of what the bake adds for the materials that a guidance names (grain, rust, a weave);
    # 0 is none. Stable Diffusion paints its own and names none.
    detail: Annotated[float, Range(0, 2)] = 1.0
    # How much of what Γ's colour varies within an area of one colour is taken out at the bake. The
    # pictures' network is unsure there, which shows as blotches.
    evenness: Annotated[float, Range(0, 1)] = 0.8


@dataclass(frozen=True, kw_only=True)
class TextureConfig:
    """The unwrap and the bake (§4.3, "Texturing")."""

    size: Annotated[int, Range(64, 8192)] = 2048  # side of the maps, texels
    # The mesh is simplified to this before the unwrap.
    max_faces: Annotated[int, Range(100, 100_000_000)] = 20000
    # Up to this max_faces the triangles are made even in size and shape; 0: never.
    even_faces: Annotated[int, Range(0, 100_000_000)] = 100_000
    samples: Annotated[int, Squares(1, 64)] = 4  # of one texel
    # Of the edges that stand out, in the normal map, of the longest side; 0: sharp.
    edge_radius: Annotated[float, Range(0, 0.1)] = 0.008
    # Width of the border inside an edited region, of the longest side.
    feather: Annotated[float, Range(0, 1)] = 0.02


@dataclass(frozen=True, kw_only=True)
class GuidanceConfig:
    """How a Stable Diffusion checkpoint is used; the built-in prior takes the camera itself."""

    soft_views: bool = False  # mix the texts of neighbouring views by the camera's angle
    # Weight of Perp-Neg (Armandpour et al. 2023) against several faces; 0 is off, any other costs
    # three more U-Net runs a picture.
    perp_neg: Annotated[float, Range(0, 100)] = 0.0
    default_negative: bool = True  # an empty negative prompt is the default text, not none
    # What the checkpoint predicts; auto: what its files state, or what a trial run shows.
    prediction: Prediction = "auto"


GUIDANCE = GuidanceConfig()


@dataclass(frozen=True, kw_only=True)
class Config:
    """All settings of one run."""

    geometry: GeometryConfig = field(default_factory=GeometryConfig)
    appearance: AppearanceConfig = field(default_factory=AppearanceConfig)
    texture: TextureConfig = field(default_factory=TextureConfig)
    guidance: GuidanceConfig = field(default_factory=GuidanceConfig)


PAPER = Config(
    geometry=GeometryConfig(cameras=CameraConfig(elevation_deg=(-90.0, 90.0))),
    appearance=AppearanceConfig(
        early=PhaseConfig(
            steps=300, size=512, weighting="sigma2_sqrt", t_high=(0.98, 0.98), guidance_scale=50.0
        ),
        late=PhaseConfig(steps=1700, size=512, weighting="inv_sigma2", guidance_scale=50.0),
        cameras=CameraConfig(elevation_deg=(-90.0, 90.0)),
    ),
)

# The released code's cameras: fovy 25.7 to 45 degrees, elevation -10 to 45, jitter ±0.4.
RELEASED_CAMERAS = CameraConfig(
    fovy_deg=(25.7, 45.0), elevation_deg=(-10.0, 45.0), elevation="angle", azimuth_jitter=0.8
)

STANDARD = replace(
    PAPER,
    geometry=replace(PAPER.geometry, views=8, cameras=RELEASED_CAMERAS),
    appearance=replace(PAPER.appearance, views=8, cameras=RELEASED_CAMERAS),
)

# The built-in prior knows views from below; without them a mug has no bottom.
BELOW_TOO = CameraConfig(elevation_deg=(-50.0, 78.0))

DRAFT = Config(
    geometry=GeometryConfig(
        # A tenth of the hash grid's time on a CPU. Three octaves would melt legs and arms; what
        # five let through of the denoised pictures' noise, the sharpening takes out.
        net=replace(FOURIER, octaves=5),
        resolution=(40, 64),
        start="learned",
        fit_steps=200,
        # It only has to find where the shape is: growing gives it its parts.
        coarse=PhaseConfig(
            steps=30, size=64, weighting="sigma2", t_high=(0.98, 0.6), guidance_scale=5.0
        ),
        # From much noise, so that each picture has what the shape still lacks, such as its legs.
        grow=RefineConfig(
            rounds=8,
            steps=25,
            batch=6,
            size=64,
            t=(0.96, 0.6),
            ray_mask=1.0,
            denoise_steps=4,
            learning_rate=4e-3,
        ),
        # No steps: they cut the nose off a rocket, and refining starts where growing ends.
        fine=PhaseConfig(
            steps=0,
            size=128,
            weighting="sigma2_sqrt",
            t_low=0.1,
            t_high=(0.6, 0.4),
            guidance_scale=4.0,
        ),
        refine=RefineConfig(rounds=2, steps=40, learning_rate=3e-3),
        sharpen=SharpenConfig(rounds=6, close_rounds=5),
        views=6,
        views_at_once=6,
        cameras=BELOW_TOO,
        learning_rate=4e-3,
        learning_rate_end=0.3,
        gradient_cap=0.1,
        gradient_clip=1.0,
        ray_mask_share=0.4,
        eikonal=0.05,
        smooth_normals=0.003,
        join=True,  # every noun of the prior's is one connected thing
        polish=8,
    ),
    appearance=AppearanceConfig(
        log2_hash_size=15,
        finest=128,
        early=PhaseConfig(
            steps=20, size=128, weighting="sigma2_sqrt", t_high=(0.98, 0.7), guidance_scale=1.5
        ),
        late=PhaseConfig(
            steps=10, size=128, weighting="inv_sigma2", t_high=(0.7, 0.5), guidance_scale=1.5
        ),
        # The prior saw colours over this very shape and light: one step from much noise is the
        # mean of its pictures under all turns of the light, and more guidance would saturate kd.
        refine=RefineConfig(
            rounds=1,
            steps=40,
            t=(0.95, 0.95),
            batch=6,
            denoise_steps=1,
            guidance_scale=1.0,
            learning_rate=1e-2,
        ),
        kd_curve="srgb",
        kd_range=(0.003, 0.97),  # the paper's 0.03 would make a red of sRGB 0.2 in green and blue
        metallic_start=0.08,
        views=6,
        views_at_once=6,
        cameras=BELOW_TOO,
        learning_rate_end=0.1,
        gradient_cap=0.1,
        bump=0.0,
    ),
    texture=TextureConfig(size=1024),
)

# Score distillation alone, without what the draft has beyond the paper: no rounds of fitting.
SDS = replace(
    DRAFT,
    geometry=replace(
        DRAFT.geometry,
        start="ellipsoid",
        coarse=replace(DRAFT.geometry.coarse, steps=250),
        grow=RefineConfig(),
        fine=replace(DRAFT.geometry.fine, steps=100),
        refine=RefineConfig(),
    ),
    appearance=replace(
        DRAFT.appearance,
        early=replace(DRAFT.appearance.early, steps=100),
        late=replace(DRAFT.appearance.late, steps=50),
        refine=RefineConfig(),
    ),
)

PRESETS: dict[str, Config] = {"draft": DRAFT, "sds": SDS, "standard": STANDARD, "paper": PAPER}


def preset(name: str) -> Config:
    """The preset ``name``; UserError for one that is not there."""
    if name not in PRESETS:
        raise UserError(f"There is no preset {shown(name)}.", f"Use one of {', '.join(PRESETS)}.")
    return PRESETS[name]
