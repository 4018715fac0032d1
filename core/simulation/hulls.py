"""Convex parts that together fill a mesh: what physics engines collide with.

CoACD: X. Wei, M. Liu, Z. Ling, H. Su, "Approximate Convex Decomposition for 3D Meshes with
Collision-Aware Concavity and Tree Search", SIGGRAPH 2022.
"""

from jaxtyping import Float, Int
from torch import Tensor, from_numpy

from core.errors import MissingError, UserError
from core.geometry.mesh import normalise
from core.texture.simplify import simplify

MAX_HULLS = 32
FACES = 1500  # of the mesh that is cut: 20,000 take four times as long for the same hulls
CONCAVITY = 0.05  # CoACD's own threshold: how deep a dent a part may keep, of the size
CORNERS = 48  # of a hull; PhysX allows 64 on a GPU

Hull = tuple[Float[Tensor, "_ 3"], Int[Tensor, "_ 3"]]


def convex_hulls(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], most: int = MAX_HULLS
) -> list[Hull]:
    """``most`` convex parts or fewer, the same ones at each call."""
    try:
        import coacd
    except ImportError as error:
        raise MissingError(
            "The package coacd is not installed.", "Run: python3 run.py setup --renew"
        ) from error
    cube, center, scale = normalise(verts.detach().cpu().double())
    coarse, triangles = simplify(cube, faces.cpu(), FACES)
    coacd.set_log_level("error")
    found = coacd.run_coacd(
        coacd.Mesh(coarse.numpy(), triangles.numpy()), threshold=CONCAVITY, max_convex_hull=most,
        resolution=1000, mcts_nodes=15, mcts_iterations=60, mcts_max_depth=2, decimate=True,
        max_ch_vertex=CORNERS, seed=0,
    )  # fmt: skip
    hulls = [(from_numpy(v) / scale + center, from_numpy(f).long()) for v, f in found]
    if not hulls:
        raise UserError("No convex parts were found for the mesh.", "Repair it (Mesh Health).")
    return hulls
