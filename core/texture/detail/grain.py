"""The long direction of each part of a mesh, in which wood would be cut for it, and its edges.

A part's length is the axis along which the surface around a vertex spreads most, and what runs on
smoothly is one part: a board's edges are cut with it. Of the three axes of the object one is taken,
as a joiner does who cuts boards and legs to length; the borders are where the parts meet.
"""

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.sparse import csr_array, diags_array
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.mesh import mean_around
from core.geometry.tangents import smooth_normals
from core.texture.detail.survey import spread

SAMPLES = 3000  # points of the surface
CHUNK = 2000  # vertices at a time: of a long object most points are within reach of each
REACH = 0.16  # radius of a vertex's surroundings, of the object's longest side
SMOOTHING = 300  # rounds over neighbouring vertices
FINE = 0.04  # of an edge, of the object's longest side
FACING = 12  # power of the cosine between their normals that is their weight in it
# Where two axes are as long, width before depth before height: a seat's boards, a wall's logs.
PREFERRED = np.array([1.06, 1.0, 0.97])


def lengths(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Float[Tensor, "v 3"]:
    """How long the part around each vertex is along each axis; the three add up to 1."""
    v, f = verts.cpu().double().numpy(), faces.cpu().numpy()
    face, bary = spread(verts, faces, SAMPLES)
    points = np.einsum("nk,nkc->nc", bary.cpu().double().numpy(), v[f[face.numpy()]])
    reach = REACH * float(np.ptp(v[np.unique(f)], axis=0).max())
    tree = KDTree(points)
    chunks = [v[i : i + CHUNK] for i in range(0, len(v), CHUNK)]
    score = PREFERRED * np.concatenate([_spread_around(some, tree, reach) for some in chunks])
    mean = _mean_along(verts, faces)
    for _ in range(SMOOTHING):
        score = mean @ score
    return torch.from_numpy(score / np.maximum(score.sum(1, keepdims=True), 1e-30)).to(verts)


def _spread_around(
    centres: Float[np.ndarray, "n 3"], points: KDTree, reach: float
) -> Float[np.ndarray, "n 3"]:
    """Standard deviation along each axis of the points within ``reach`` of each centre."""
    near = KDTree(centres).sparse_distance_matrix(points, reach, output_type="coo_matrix")
    inside = csr_array((np.ones(near.nnz), (near.row, near.col)), near.shape)
    count = np.maximum(inside.sum(1), 1)[:, None]
    at = points.data
    # The variance along each axis: E[x²] - E[x]².
    variance = (inside @ at**2) / count - ((inside @ at) / count) ** 2
    return np.sqrt(np.maximum(variance, 1e-12))


def convexity(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Float[Tensor, "v 1"]:
    """How far each vertex is out of the middle of its neighbours, along its normal, in lengths
    of the edges there: above 0 on an edge, below 0 in a corner, 0 where it is flat."""
    v, f = verts.cpu().double().numpy(), faces.cpu().numpy()
    out = v - mean_around(f, len(v)) @ v
    normals = smooth_normals(verts, faces).cpu().double().numpy()
    ends = v[f[:, [1, 2, 0]]] - v[f]
    length = np.bincount(f.ravel(), np.linalg.norm(ends, axis=2).ravel(), len(v))
    length = length / np.maximum(np.bincount(f.ravel(), minlength=len(v)), 1)
    height = (out * normals).sum(1) / np.maximum(length, 1e-30)
    # Large triangles are no edges: the value would cover them between their corners.
    height *= np.minimum(1, FINE * float(np.ptp(v[np.unique(f)], axis=0).max()) / length)
    return torch.from_numpy(height[:, None]).to(verts)


def _mean_along(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> csr_array:
    """The mean over a vertex and its neighbours, those most that face the same way."""
    around = mean_around(faces.cpu().numpy(), len(verts)).tocoo()
    n = smooth_normals(verts, faces).cpu().double().numpy()
    similar = np.clip((n[around.row] * n[around.col]).sum(1), 0, 1) ** FACING
    weights = csr_array((around.data * similar, (around.row, around.col)), around.shape)
    weights = weights + diags_array(np.full(len(verts), 0.1))
    return csr_array(weights / weights.sum(1)[:, None])
