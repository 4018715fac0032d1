"""The front of a guide: the turn about the vertical in which the guidance knows it best.

A guidance that sees normals in the object's frame knows where a thing's front is, and takes a guide
that faces another way for something else. So it is asked first, as a diffusion classifier (Li et
al. 2023, "Your diffusion model is secretly a zero-shot classifier", Alg. 1): under each turn it
predicts the noise in the guide's pictures, and the least error is that of the right one.
"""

import math

import torch
from jaxtyping import Float
from torch import Tensor

from core.camera import Cameras
from core.geometry.guide import kept
from core.geometry.mesh import Mesh, normalise
from core.guidance.guidance import PromptedGuidance, Views
from core.guidance.sds import add_noise
from core.render.normals import render_normals

TURNS = 8
SIZE = 128  # side of the pictures, pixels
ELEVATIONS_DEG = (10.0, 30.0)
TIMES = (0.5, 0.8)  # noise, as fractions of the diffusion's steps
# A turn must fit by this much better than none: what looks the same from all sides stays.
BETTER = 0.9
SEED = 0  # of the noise: a guide faces one way, whatever the run's seed


def front_turn(guide: Mesh, guidance: PromptedGuidance) -> float:
    """The turn about +Z, radians, that brings the guide's front to -Y; 0 where none is better."""
    if guidance.normal_frame != "object":  # the same pictures for every turn
        return 0.0
    errors = turn_errors(guide, guidance)
    best = int(errors.argmin())
    return best * 2 * math.pi / TURNS if errors[best] < BETTER * errors[0] else 0.0


@torch.no_grad()
def turn_errors(guide: Mesh, guidance: PromptedGuidance) -> Float[Tensor, " turns"]:
    """Mean squared error of the noise that the guidance sees in the guide, under each turn.

    The cameras turn with the guide, so that the pictures differ in the normals' directions alone;
    and the noise turns with these. Otherwise its luck would decide (as ``core.prior.evaluate``).
    """
    device = guidance.alpha_bar.device
    angles = torch.arange(TURNS) * (2 * math.pi / TURNS)
    cameras = Cameras.orbit(angles.rad2deg().tolist(), [*ELEVATIONS_DEG] * (TURNS // 2)).to(device)
    n, o = render_normals(*_faceted(guide, device), cameras, SIZE)
    z, generator = guidance.encode_normals(n, o), torch.Generator().manual_seed(SEED)
    total = torch.zeros(TURNS)
    for level in TIMES:
        eps = torch.randn(z.shape, generator=generator).to(z)
        t = torch.full((len(z),), round(level * len(guidance.alpha_bar)), device=device)
        for k, angle in enumerate(angles.tolist()):
            turned_eps = turned_vectors(eps, angle)
            z_t = add_noise(turned_vectors(z, angle), turned_eps, guidance.alpha_bar[t])
            views = Views(turned_cameras(cameras, angle))
            found = guidance.predict(z_t, t, views, cond_only=True).cond
            total[k] += float((found - turned_eps).square().mean())
    return total


def _faceted(guide: Mesh, device: torch.device) -> tuple[Tensor, Tensor]:
    """The guide, normalised, facing outward, each face with corners of its own.

    Few large faces with shared normals would be shaded as if they were round.
    """
    mesh = kept(guide)
    corners = normalise(mesh.verts)[0][mesh.faces].view(-1, 3).to(device)
    return corners, torch.arange(len(corners), device=device).view(-1, 3)


def turned_vectors(z: Float[Tensor, "b 4 s s"], angle: float) -> Float[Tensor, "b 4 s s"]:
    """The first three channels turned about +Z."""
    x, y, *rest = z.unbind(1)
    c, s = math.cos(angle), math.sin(angle)
    return torch.stack([c * x - s * y, s * x + c * y, *rest], 1)


def turned_cameras(cameras: Cameras, angle: float) -> Cameras:
    """The cameras gone round the object by ``angle``."""
    return Cameras(cameras.azimuth + angle, cameras.elevation, cameras.distance, cameras.fovy)
