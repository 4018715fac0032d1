"""A solid made of cubes, as voxel art is: a closed manifold mesh, each square of which has a place
of its own in the UV."""

from itertools import product
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.ndimage import label
from scipy.sparse import coo_array
from scipy.sparse.csgraph import minimum_spanning_tree
from torch import Tensor

from core.geometry.mesh import Mesh, component_labels
from core.geometry.signed_distance import SolidMesh

FULL = 0.2  # cubes: one whose middle is no farther outside belongs to the solid
NEAR = 1.5  # cubes outside, through which components of the solid are linked
INSET = 0.2  # of a square's place in the UV: the room between it and the next ones
FEWEST = 4  # cubes along the longest side
TOUCHING = np.ones((3, 3, 3))  # cubes that share a face, an edge or a corner
CORNERS = np.array(list(product((0, 1), repeat=3)))  # the eight cubes around a node of the lattice

Cells = Bool[np.ndarray, "x y z"]


class Lattice(NamedTuple):
    """Cubes of side ``cell`` from the corner ``start`` on; ``outside``: the signed distances of
    their middles from a solid, in ``cell``."""

    start: Float[np.ndarray, " 3"]
    cell: float
    outside: Float[np.ndarray, "x y z"]

    @classmethod
    def around(cls, mesh: Mesh, count: int) -> "Lattice":
        """``count`` cubes along the longest side, from the ground of the mesh's box and about its
        middle, so that mirrored sides stay so."""
        verts = mesh.verts.detach().cpu().double().numpy()
        low, high = verts.min(0), verts.max(0)
        cell = float((high - low).max()) / count
        shape = np.maximum(np.ceil((high - low) / cell - 1e-3).astype(int), 1)
        start = (low + high) / 2 - shape * cell / 2
        start[2] = low[2]
        axes = [start[k] + (np.arange(shape[k]) + 0.5) * cell for k in range(3)]
        middles = torch.from_numpy(np.stack(np.meshgrid(*axes, indexing="ij"), -1)).float()
        solid = SolidMesh(mesh.verts.detach().cpu(), mesh.faces.cpu())
        outside = solid.sdf(middles.view(-1, 3)).double().numpy() / cell
        return cls(start, cell, outside.reshape(shape))


def voxelised(mesh: Mesh, count: int, most_faces: int) -> Mesh:
    """The closed ``mesh`` made of cubes, ``count`` along its longest side, or so many fewer that
    there are no more than ``most_faces`` faces.

    What is thinner than a cube becomes a cube thick, and what would fall apart is linked. Two faces
    that follow each other are a square (:func:`squares_of`). Shaded flat.
    """
    _, of_face = component_labels(mesh.faces, len(mesh.verts))
    while True:
        lattice = Lattice.around(mesh, count)
        full = manifold(linked(lattice.outside, int(of_face.max()) + 1), lattice.outside)
        nodes, squares = surface(full)
        if 2 * len(squares) <= most_faces or count <= FEWEST:
            break
        count = max(int(0.9 * count), FEWEST)
    verts = torch.from_numpy(lattice.start + nodes * lattice.cell).to(mesh.verts)
    faces = torch.from_numpy(squares[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)).to(mesh.faces)
    uv, face_uvs = atlas(len(squares))
    return Mesh(verts, faces, uv.to(mesh.verts), face_uvs.to(mesh.faces), flat=True)


def linked(outside: Float[np.ndarray, "x y z"], components: int) -> Cells:
    """The cubes of the solid, and where they are more than ``components``, those that link them:
    on the paths of a minimum spanning tree, on which they are least outside."""
    full = outside < max(FULL, outside.min() + FULL)  # of what is thinner than a cube: some
    if _components(full, TOUCHING) <= components:
        return full
    near = np.argwhere(outside < NEAR)
    number = np.full(outside.shape, -1)
    number[tuple(near.T)] = np.arange(len(near))
    cost = np.maximum(outside[tuple(near.T)], 0) + 1e-6
    number = np.pad(number, 1, constant_values=-1)
    links = []
    for step in product((-1, 0, 1), repeat=3):
        if step > (0, 0, 0):  # each pair once
            other = number[tuple((near + step + 1).T)]
            links.append(np.stack([np.arange(len(near)), other], 1)[other >= 0])
    one, other = np.concatenate(links).T
    graph = coo_array((cost[one] + cost[other], (one, other)), shape=(len(near), len(near)))
    tree = minimum_spanning_tree(graph).tocoo()
    edges, kept = np.stack([tree.row, tree.col], 1), full[tuple(near.T)]
    while True:  # what is on the way to nothing
        degree = np.bincount(edges.ravel(), minlength=len(near))
        loose = (~kept & (degree == 1))[edges].any(1)
        if not loose.any():
            break
        edges = edges[~loose]
    full[tuple(near[np.unique(edges)].T)] = True
    return full


def manifold(full: Cells, outside: Float[np.ndarray, "x y z"]) -> Cells:
    """``full`` and as many other cubes as it takes that its surface is a manifold.

    It is one where around each node of the lattice the full cubes are linked by faces, and the
    empty ones too (L. Latecki, "3D Well-Composed Pictures", 1997). Elsewhere the cube that is
    least outside is added, over and over.
    """
    full, outside = np.pad(full, 1), np.pad(outside, 1, constant_values=np.inf)
    broken = np.array([_is_broken(code) for code in range(256)])
    while True:
        around = np.lib.stride_tricks.sliding_window_view(full, (2, 2, 2)).reshape(
            *(n - 1 for n in full.shape), 8
        )
        at = np.argwhere(broken[around @ (1 << np.arange(8))])
        if not len(at):
            return full[1:-1, 1:-1, 1:-1]
        cells = tuple(np.moveaxis(at[:, None] + CORNERS, -1, 0))
        least = np.where(full[cells], np.inf, outside[cells]).argmin(1)
        full[tuple((at + CORNERS[least]).T)] = True


def _is_broken(code: int) -> bool:
    """Whether eight cubes about a node, full where ``code`` has a bit, have no disc between full
    and empty ones."""
    full = (code >> np.arange(8) & 1).astype(bool).reshape(2, 2, 2)
    return _components(full) > 1 or _components(~full) > 1


def _components(full: Cells, touching: np.ndarray | None = None) -> int:
    """How many components the cells are; those that share a face are one, or that ``touching``
    links."""
    labels = np.empty(full.shape, np.int32)
    label(full, touching, labels)
    return int(labels.max())


def surface(full: Cells) -> tuple[Int[np.ndarray, "v 3"], Int[np.ndarray, "q 4"]]:
    """The nodes of the squares between full and empty cubes, and each square's, counter-clockwise
    seen from the empty one."""
    full, found = np.pad(full, 1), []
    for axis, side in product(range(3), (1, -1)):
        at = np.argwhere(full & ~np.roll(full, -side, axis)) - 1
        across, up = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
        first = at + np.eye(3, dtype=int)[axis] * (side > 0)
        square = np.stack([first, first + across, first + across + up, first + up], 1)
        found.append(square if side > 0 else square[:, ::-1])
    nodes, index = np.unique(np.concatenate(found).reshape(-1, 3), axis=0, return_inverse=True)
    return nodes, index.reshape(-1, 4)


def atlas(count: int) -> tuple[Float[Tensor, "u 2"], Int[Tensor, "f 3"]]:
    """The uv of ``count`` squares in rows, and its indices by the squares' pairs of faces."""
    side = int(np.ceil(np.sqrt(count)))
    row, column = np.divmod(np.arange(count), side)
    low, high = INSET, 1 - INSET
    inside = np.array([[low, low], [high, low], [high, high], [low, high]])
    uv = (np.stack([column, row], 1)[:, None] + inside) / side
    corners = 4 * np.arange(count)[:, None, None] + np.array([[0, 1, 2], [0, 2, 3]])
    return torch.from_numpy(uv.reshape(-1, 2)).float(), torch.from_numpy(corners.reshape(-1, 3))


def squares_of(mesh: Mesh) -> tuple[Float[Tensor, "q 3"], Float[Tensor, "q 3"]]:
    """The middles of a voxelised mesh's squares, and their outward unit normals times a cube's
    side."""
    a, b, c = mesh.verts[mesh.faces[::2]].unbind(1)
    across = torch.linalg.cross(b - a, c - b)
    return (a + c) / 2, across / (b - a).norm(dim=1, keepdim=True)
