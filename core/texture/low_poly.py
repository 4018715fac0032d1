"""A shape of few flat faces, as low poly art is."""

from collections.abc import Callable

import igl
import numpy as np
import torch
from jaxtyping import Float, Int

from core.geometry.mesh import Mesh
from core.texture.simplify import collapsed, oriented, simplify

MOST, FEWEST = 1600, 60  # faces
FEWER = 0.8  # of the faces, from one try to the next
FARTHEST = 0.95  # of the surface is within the error
MEASURED = 4000  # vertices


def low_poly(
    mesh: Mesh, error: float, most_faces: int, check: Callable[[], None] = lambda: None
) -> Mesh:
    """``mesh`` with so few faces that no more than a twentieth of it is off by ``error`` of its
    longest side; shaded flat.

    Collapses that push the surface through itself are allowed: without them thin parts, which have
    no room for large faces, keep their small ones, and the rest is left with next to none.
    ``check`` is called now and then; what it raises stops the work.

    Raises UserError as :func:`core.texture.simplify.simplify`.
    """
    verts, faces = oriented(mesh.verts.detach().cpu(), mesh.faces.cpu())
    fine = verts.double().numpy(), np.ascontiguousarray(faces.numpy().astype(np.int64))
    allowed = error * float(np.ptp(fine[0], axis=0).max())
    current = best = fine
    count = min(MOST, most_faces)
    while count >= FEWEST:
        check()
        current = collapsed(*current, count, apart=False)
        if not len(current[1]):  # three faces share an edge
            break
        if best is not fine and deviation(fine[0], *current) > allowed:
            break
        best, count = current, int(FEWER * count)
    if best is fine and len(faces) > most_faces:
        best = tuple(x.numpy() for x in simplify(verts, faces, most_faces, check))
    verts, faces = (torch.from_numpy(np.ascontiguousarray(x)) for x in best)
    return Mesh(verts.to(mesh.verts), faces.to(mesh.faces), flat=True)


def deviation(
    points: Float[np.ndarray, "n 3"],
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
) -> float:
    """The distance of a surface from nineteen in twenty of ``points`` at the most."""
    some = np.random.default_rng(0).permutation(len(points))[:MEASURED]
    away, _, _ = igl.point_mesh_squared_distance(points[some], verts, faces)
    return float(np.sqrt(np.quantile(np.asarray(away), FARTHEST)))
