"""Γ's start from a base colour that is there already: the user's own picture over the mesh's uv."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float
from PIL import Image
from torch import Tensor
from torch.nn.functional import grid_sample, mse_loss

from core.adam import Adam
from core.appearance.material import MaterialNet, to_ranges
from core.errors import UserError
from core.geometry.mesh import Mesh, face_areas, normalise
from core.io.input_file import check_file
from core.io.progress import Progress
from core.ops import srgb_to_linear
from core.stages.state import Training

STEPS = 200  # then a smooth picture is within 0.04, linear, which the first distilling steps keep
POINTS = 1 << 12  # of the surface, in one step
STILL = 1e-3  # weight of what holds the rest of the material where it is
OWN = "mesh"  # names the texture in the mesh's own file


def start_picture(name: str, mesh: Mesh) -> Float[Tensor, "h w 3"]:
    """The base colour called ``name``, linear, row 0 = top: a file's, or the mesh's own.

    Raises UserError where there is no such picture, or no uv for it.
    """
    if mesh.uv is None:
        raise UserError("The mesh has no UV map for a base colour.", "Unwrap it, or start plain.")
    if name == OWN:
        if mesh.base_color is None:
            raise UserError("The mesh's file holds no texture.", "Name a picture, or start plain.")
        return mesh.base_color
    check_file(Path(name), fix="Check the base colour's path.")
    try:
        with Image.open(Path(name)) as file:
            srgb = _srgb(file)
    # SyntaxError and ValueError: a broken header, as PIL's readers raise it. Size: PIL's own bound.
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise UserError(f"{name} is not a picture ({error}).", "Use a PNG or a JPEG.") from None
    return srgb_to_linear(torch.from_numpy(srgb))


def _srgb(file: Image.Image) -> Float[np.ndarray, "h w 3"]:
    """A picture's colours in [0, 1]."""
    if file.mode.startswith("I;16"):  # grey, which PIL's own conversion cuts off at 255
        return np.repeat(np.asarray(file, np.float32)[..., None] / 65535, 3, axis=2)
    if file.mode in ("I", "F"):
        raise ValueError("its numbers have no known range")
    return np.asarray(file.convert("RGB"), np.float32) / 255


def fit_start_color(
    training: Training[MaterialNet],
    mesh: Mesh,
    picture: Float[Tensor, "h w 3"],
    progress: Progress,
) -> None:
    """Fit Γ's kd to ``picture`` over the user's ``mesh``."""
    own = replace(mesh, verts=normalise(mesh.verts)[0])
    with progress.timed("start"):
        fit_base_color(
            training.module,
            own,
            picture,
            training.generator,
            lambda step: progress.advance("start", step, STEPS),
        )


def fit_base_color(
    net: MaterialNet,
    mesh: Mesh,
    picture: Float[Tensor, "h w 3"],
    generator: torch.Generator,
    progress: Callable[[int], None] | None = None,
    steps: int = STEPS,
) -> float:
    """Fit kd of Γ to ``picture`` over the uv of ``mesh``, in training units.

    Roughness, metallic and kn are held where they are. Returns the last step's root mean square
    error, linear; ``progress`` is called with the steps done.
    """
    device = next(net.parameters()).device
    optimizer = Adam(net.parameters(), 1e-2)
    low, high = net.config.kd_range
    error = float("nan")
    for step in range(steps):
        points, colors = surface_colors(mesh, picture, POINTS, generator)
        points, colors = points.to(device), colors.to(device)
        raw = net.raw(points)
        # Within kd's range: a target outside would only drive the sigmoids into their flat ends.
        loss = mse_loss(to_ranges(raw, net.config).kd, colors.clamp(low, high))
        # The first three of the eight outputs are kd's.
        still = (raw - net.start)[:, 3:].square().mean()
        optimizer.zero_grad()
        (loss + STILL * still).backward()
        optimizer.step()
        error = float(loss.detach().sqrt())
        if progress is not None:
            progress(step + 1)
    return error


def surface_colors(
    mesh: Mesh, picture: Float[Tensor, "h w 3"], count: int, generator: torch.Generator
) -> tuple[Float[Tensor, "n 3"], Float[Tensor, "n 3"]]:
    """``count`` points of the surface, uniform by area, and the picture's colour there."""
    assert mesh.uv is not None and mesh.face_uvs is not None
    areas = face_areas(mesh.verts, mesh.faces)
    face = torch.multinomial(areas, count, True, generator=generator)
    s, t = torch.rand(2, count, 1, generator=generator)
    s = s.sqrt()  # uniform over the triangle (Turk 1990)
    weights = torch.stack([1 - s, s * (1 - t), s * t], 1)
    points = (weights * mesh.verts[mesh.faces[face]]).sum(1)
    uv = (weights * mesh.uv[mesh.face_uvs[face]]).sum(1)
    return points, sample(picture, uv)


def sample(picture: Float[Tensor, "h w 3"], uv: Float[Tensor, "n 2"]) -> Float[Tensor, "n 3"]:
    """Bilinear, and repeated outside the unit square as Blender's image node does."""
    within = uv - uv.floor()
    # v runs upwards, a picture's rows downwards.
    grid = torch.stack([2 * within[:, 0] - 1, 1 - 2 * within[:, 1]], -1)
    found = grid_sample(
        picture.permute(2, 0, 1)[None], grid[None, None], padding_mode="border", align_corners=False
    )
    return found[0, :, 0].T
