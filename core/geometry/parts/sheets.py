"""Sheets of any form made thinner: a wing, a brim, a blade that is no primitive."""

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.faces import normals_of, unit
from core.geometry.lattice import Lattice
from core.geometry.mesh import mean_around, taubin
from core.geometry.union import is_solid

STEP, FARTHEST = 0.5, 28  # cells, of a search across; how many
EVEN = 1.25  # times the median thickness, at most, of what is a sheet
MOST = 0.25  # of its size, a sheet's thickness
FILLED, SMOOTH, POLISH = 16, 3, 3  # rounds


def thinned_sheet(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], lattice: Lattice, by: float
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """A component's surface moved towards its middle, so that it is ``by`` times as thick; as it is
    where it is no sheet.

    Args:
        lattice: of its distances.
    """
    if by == 1.0:
        return verts, faces
    places, corners = verts.double().numpy(), faces.numpy()
    normals = unit(normals_of(places, corners))
    across = thickness(places, normals, lattice)
    usual = np.median(across)
    even = across < EVEN * usual
    if usual > MOST * np.ptp(places, axis=0).max():
        return verts, faces
    mean = mean_around(corners, len(places))
    inwards = -normals * np.where(even, (1 - by) / 2 * across, 0.0)[:, None]
    for _ in range(FILLED):  # at its edge both sides' moves cancel
        inwards[~even] = (mean @ inwards)[~even]
    for _ in range(SMOOTH):
        inwards = mean @ inwards
    moved = torch.from_numpy(taubin(places + inwards, corners, POLISH)).to(verts)
    return (moved, faces) if is_solid(moved, faces) else (verts, faces)


def thickness(
    places: Float[np.ndarray, "v 3"], normals: Float[np.ndarray, "v 3"], lattice: Lattice
) -> Float[np.ndarray, " v"]:
    """The way through the solid from each place of its surface, against its normal; the farthest
    that is searched where that is longer."""
    steps = np.arange(1, FARTHEST + 1) * STEP * lattice.cell
    values = np.stack([lattice.near(places - far * normals) for far in steps], 1)
    out = (values >= 0) & (steps > lattice.cell)
    out[:, -1] = True
    first = out.argmax(1).clip(min=1)
    row = np.arange(len(places))
    inner, outer = values[row, first - 1], values[row, first]
    part = np.where(outer > 0, -inner / (outer - inner).clip(1e-9), 1.0).clip(0, 1)
    return steps[first - 1] + part * (steps[first] - steps[first - 1])
