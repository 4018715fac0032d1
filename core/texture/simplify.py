"""Fewer faces before the unwrap: edge collapse by quadric error.

Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997, as libigl has it.
Every collapse is tested to leave a manifold, so a closed mesh stays closed, with its genus and
its components, and collapses that would push the surface through itself are refused. A few
collapses in ten thousand leave a fold nevertheless, a dark speck on a smooth ball: they are spread
out again over the surface.
"""

from collections.abc import Callable

import igl
import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.faces import agree, agreeing, areas_and_normals
from core.geometry.mesh import health, mean_around
from core.geometry.signed_distance import facing_outward

# A mesh of more faces than so many, and than so many times what is asked for, is halved first.
MANY, MANY_TIMES = 200_000, 10
FARTHER, NEAR = 1.5, 0.05  # times as far from the surface, and of a face's size: still as near
FOLDED = 0.3  # cosine between a face and the surface below it, under which it is folded
UNFOLD_ROUNDS = 10
NONE = np.zeros(3)  # the normal of a face without an area


def simplify(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    max_faces: int,
    check: Callable[[], None] = lambda: None,
) -> tuple[Float[Tensor, "v2 3"], Int[Tensor, "f2 3"]]:
    """The same surface with ``max_faces`` faces or fewer; within the budget it is left untouched.

    More faces than asked for come back only where no edge is left that may collapse: a closed
    component keeps at least 4 faces. Neighbours that look to opposite sides are turned first
    (:func:`oriented`). ``check`` is called now and then; what it raises stops the work.

    Raises UserError for a mesh where three faces share an edge: it has no collapse that is safe.
    """
    if len(faces) <= max_faces:
        return verts, faces
    verts, faces = oriented(verts, faces)
    used, compact = np.unique(faces.cpu().numpy(), return_inverse=True)
    points = verts.detach().cpu().double().numpy()[used]
    triangles = compact.reshape(-1, 3)
    new_verts, new_faces = _within(points, triangles, max_faces, check)
    if not len(new_faces) and not health(verts, faces)["nonmanifold_edges"]:
        # Where two holes meet in a vertex libigl finds no collapse at all: each has its own then.
        points, apart, _ = igl.split_nonmanifold(points, triangles)
        points, triangles = np.asarray(points), np.asarray(apart).astype(np.int64)
        new_verts, new_faces = _within(points, triangles, max_faces, check)
    if not len(new_faces):
        raise UserError(
            f"The mesh has {len(faces):,} faces and cannot be given fewer: "
            "somewhere three faces share an edge.",
            "Repair it (Blender: Select > All by Trait > Non Manifold), or raise --max-faces.",
        )
    spread = unfolded(new_verts, new_faces, points, triangles)
    # At a step of united parts a face that looks another way is no fold, and spreading such a
    # place over and over would wear the shape away.
    off = [_off(places, new_faces, points, triangles) for places in (spread, new_verts)]
    new_verts = spread if off[0] < FARTHER * off[1] + NEAR else new_verts
    return torch.from_numpy(new_verts).to(verts), torch.from_numpy(new_faces).to(faces)


def oriented(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "f 3"]]:
    """The same surface, turned outward where neighbours look to opposite sides; else untouched.

    Collapses of such a mesh never end. A surface with a single side (Möbius) is cut open.
    """
    triangles = faces.cpu().numpy().astype(np.int64)
    if agree(triangles):
        return verts, faces
    points = np.ascontiguousarray(verts.detach().cpu().double().numpy())
    triangles, _ = facing_outward(points, agreeing(points, triangles)[0])
    if not agree(triangles):
        points, triangles, _ = igl.split_nonmanifold(points, triangles)
    return torch.from_numpy(points).to(verts), torch.from_numpy(triangles).to(faces)


def _within(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    max_faces: int,
    check: Callable[[], None],
) -> tuple[Float[np.ndarray, "v2 3"], Int[np.ndarray, "f2 3"]]:
    """The surface with ``max_faces`` faces, as far as it may be; no faces where it can't."""
    fine = _halved(verts, faces, max(MANY, MANY_TIMES * max_faces), check)
    found = collapsed(*fine, max_faces, apart=True)
    check()
    if len(found[1]) > max_faces:
        # Parts that were united touch all along, and hardly a collapse there keeps them apart.
        found = collapsed(*fine, max_faces, apart=False)
        check()
    return found


def _halved(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    many: int,
    check: Callable[[], None],
) -> tuple[Float[np.ndarray, "v2 3"], Int[np.ndarray, "f2 3"]]:
    """The surface with ``many`` faces or fewer, by collapses not tested for going through it.

    The test takes nine tenths of the time of millions of faces, and what is so fine that its edges
    are a third as long as those asked for has no room to go through itself.
    """
    while len(faces) > many:
        check()
        before = len(faces)
        verts, faces = collapsed(verts, faces, max(before // 2, many), apart=False)
        if not 0 < len(faces) < before:  # none is left that may collapse
            break
    return verts, faces


def collapsed(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], max_faces: int, *, apart: bool
) -> tuple[Float[np.ndarray, "v2 3"], Int[np.ndarray, "f2 3"]]:
    """libigl's collapses; ``apart``: none that would push the surface through itself.

    No faces where it can't: three share an edge, or two holes a vertex.
    """
    if not len(faces):
        return verts, faces
    out = igl.qslim(verts, faces, max_m=max_faces, block_intersections=apart)
    triangles = np.asarray(out[1]).astype(np.int64).reshape(-1, 3)
    return np.ascontiguousarray(out[0]).reshape(-1, 3), triangles


def _off(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    surface_verts: Float[np.ndarray, "w 3"],
    surface_faces: Int[np.ndarray, "g 3"],
) -> float:
    """Root mean square distance of the faces' middles from a surface, in the faces' mean size."""
    if not len(faces):
        return np.inf
    away, _, _ = igl.point_mesh_squared_distance(verts[faces].mean(1), surface_verts, surface_faces)
    size = float(areas_and_normals(verts, faces)[0].mean())
    return float(np.sqrt(np.mean(np.asarray(away)) / max(size, 1e-300)))


def unfolded(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    surface_verts: Float[np.ndarray, "w 3"],
    surface_faces: Int[np.ndarray, "g 3"],
) -> Float[np.ndarray, "v 3"]:
    """``verts`` without folds: no face looks away from the surface that they were taken from.

    Around a face that does, each vertex goes to the nearest point of that surface from the mean of
    its neighbours, over and over. The rest stays, and all of it where that does not help.
    """
    normals = igl.per_face_normals(surface_verts, surface_faces, NONE)
    mean = mean_around(faces, len(verts))
    spread, folded = verts, _folded(verts, faces, surface_verts, surface_faces, normals)
    before = len(folded)
    for _ in range(UNFOLD_ROUNDS):
        if not len(folded):
            break
        # Neighbours of the folded faces' corners, the corners themselves among them.
        around = np.unique(mean[np.unique(faces[folded])].indices)
        means = mean[around] @ spread
        _, _, nearest = igl.point_mesh_squared_distance(means, surface_verts, surface_faces)
        spread = spread.copy()
        spread[around] = nearest
        folded = _folded(spread, faces, surface_verts, surface_faces, normals)
    return spread if len(folded) < before else verts


def _folded(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    surface_verts: Float[np.ndarray, "w 3"],
    surface_faces: Int[np.ndarray, "g 3"],
    surface_normals: Float[np.ndarray, "g 3"],
) -> Int[np.ndarray, " n"]:
    """The faces that look away from the surface at their middle."""
    middles = verts[faces].mean(1)
    _, nearest, _ = igl.point_mesh_squared_distance(middles, surface_verts, surface_faces)
    cosine = (igl.per_face_normals(verts, faces, NONE) * surface_normals[nearest]).sum(1)
    return (cosine < FOLDED).nonzero()[0]
