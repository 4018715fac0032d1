"""The user's guide mesh: kept triangle by triangle, or the solid that Ψ is fitted to."""

import igl
import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.init_shape import Shape, sample_surface
from core.geometry.leash import Leash, reach_of
from core.geometry.mesh import Mesh, normalise
from core.geometry.residual import Residual, blurred, lattice_nodes
from core.geometry.sdf_net import SdfNet
from core.geometry.signed_distance import SolidMesh

DEBLUR_ROUNDS = 30
CHUNK = 1 << 15  # nodes at a time


def kept(mesh: Mesh) -> Mesh:
    """The guide's own surface, without uv: welded, facing outward, without empty faces.

    No lattice holds what is thinner than its cells, or a sheet without an inside; the triangles
    do. Faces are cut apart where three fraction an edge, since the simplification needs a manifold.
    """
    solid = SolidMesh(mesh.verts, mesh.faces)
    verts, faces, _ = igl.split_nonmanifold(*solid.arrays)
    return Mesh(torch.from_numpy(verts).float(), torch.from_numpy(faces))


def guide_shape(mesh: Mesh, least: float) -> Shape:
    """The guide, normalised, with ``least`` (training units) around its sheets and thin parts.

    Raises UserError where it has no area.
    """
    verts, _, _ = normalise(mesh.verts)
    solid = SolidMesh(verts, mesh.faces)
    # The skin reaches ``least`` to either side of a face: parts thicker than twice that need none.
    skin = solid.thin_part(2 * least)

    def sdf(points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        distance = solid.sdf(points)
        return distance if skin is None else distance.minimum(skin.distance(points) - least)

    return Shape(sdf, lambda n, generator: sample_surface(verts, mesh.faces, n, generator))


def guide_leash(mesh: Mesh, shape: Shape, strength: float, resolution: int, extent: float) -> Leash:
    """How far Ψ's surface may go from the guide; ``shape``: its :func:`guide_shape`."""
    n = resolution + 1
    distance = [shape.sdf(points) for points in lattice_nodes(resolution, extent).split(CHUNK)]
    solid = SolidMesh(normalise(mesh.verts)[0], mesh.faces)
    return Leash(solid, torch.cat(distance).view(1, 1, n, n, n), extent, reach_of(strength))


@torch.no_grad()
def fill(residual: Residual, net: SdfNet, shape: Shape, fraction: float) -> None:
    """Give ``residual`` that much of what Ψ lacks of ``shape`` at the nodes; 1 is all of it."""
    # Zero first: the network adds the residual on its own lattice, and here Ψ alone is wanted.
    residual.values.zero_()
    # The offsets are scaled by the cell, so Ψ is asked as on the residual's lattice.
    net.cell = residual.cell
    n = residual.resolution + 1
    missing = []
    for points in lattice_nodes(residual.resolution, residual.extent).split(CHUNK):
        sdf, offset = net(points.to(residual.values.device))
        # The shape's distances hold at nodes that have not moved, so Ψ's offsets are taken back.
        missing.append(torch.cat([(shape.sdf(points).to(sdf) - sdf)[:, None], -offset], 1))
    # Channels first, as in ``values``; the nodes run along z fastest, as its last axis.
    lacks = torch.cat(missing).T.reshape(1, 4, n, n, n) * (fraction / residual.scale)
    # The residual is read blurred; what the blur takes is put on top, again and again (Van Cittert
    # 1931), or all that is smaller than three cells would be lost.
    for _ in range(DEBLUR_ROUNDS):
        residual.values.add_(lacks - blurred(residual.values))
