"""Triangles of even size and shape over a surface, its sharp edges kept.

The loop of Botsch and Kobbelt, "A Remeshing Approach to Multiresolution Modeling", 2004, §4: long
edges are halved, short ones made a point, edges turned until six faces meet at a vertex, and
vertices spread over the surface, again and again. A vertex goes where the quadric of the surface
around it is least: on a smooth part that leaves it free to move within the surface, on a sharp edge
only along it, and at a corner not at all. Lines of truly sharp edges are edges for good. Every step
leaves a manifold of the same topology and refuses what would fold.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import igl
import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree
from torch import Tensor

from core.geometry.faces import areas_and_normals, neighbours, normals_of, unit
from core.geometry.mesh import Mesh, compact, health, mean_around
from core.geometry.tangents import smooth_normals
from core.kernels import remesh as loops
from core.kernels.quadrics import add_planes
from core.kernels.thin import take_out_thin
from core.texture.charts import charts
from core.texture.simplify import oriented, simplify
from core.texture.unfold import unfolded
from core.texture.unwrap import at_unit_size

FINER = 4  # times the faces asked for, at which thin faces go first
THIN, THIN_ROUNDS = 0.12, 8  # edge lengths: a face of less height is finer than the mesh can be
ROUNDS = 5
LAST_ROUNDS = 3  # in which no edge comes or goes
# Cosines between two faces: a line of edges that bend by 40 degrees, by 50 somewhere, stays a line.
BENT_DEG = 40.0
BENT, SHARP = np.cos(np.radians(BENT_DEG)), np.cos(np.radians(50.0))
SHORTEST_LINE = 4.0  # edge lengths: what is shorter is a ripple
KINK = np.cos(np.radians(45.0))  # a line that turns by more is held there
FLAT = 0.05  # quality of a sliver, whose direction is meaningless
BORDER_ROUNDS = 8
MARGIN = 0.98  # of the faces asked for: the count at the end is not exact
MANY = 10_000  # faces
# Edges in bent places and in flat ones, times the mean, at most; of many faces and of fewer.
GRADE, COARSE_GRADE = (0.6, 1.5), (1 / 1.5, 1.5)
FITTING = 8  # rounds, to so many faces
SMOOTHING = 4  # rounds, of the curvature
NEAR = 0.7  # edge lengths: the distance that two opposite halves of a right angle are apart
AT_A_PLACE = 12  # faces of the surface that are near a face
AROUND = 0.2  # weight of the neighbours' quadrics: a vertex of few faces has too little of its own


def even(
    shape: Mesh, max_faces: int, check: Callable[[], None] = lambda: None
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The shape with ``max_faces`` even triangles or fewer, and never with more than it has.

    Where three faces share an edge it is only simplified. Neighbours that look to opposite sides
    are turned first. ``check`` is called now and then; what it raises stops the work.
    """
    shape = Mesh(*oriented(shape.verts, shape.faces))
    count = min(max_faces, len(shape.faces))
    fine = simplify(shape.verts, shape.faces, FINER * count, check)
    report = health(*fine)
    if not (report["manifold"] and report["oriented"]):
        return simplify(*fine, count, check)
    area = areas_and_normals(_doubles(fine[0]), fine[1].cpu().numpy())[0].sum()
    thin = THIN * length_of(area, count)
    verts, faces = without_thin(*simplify(*without_thin(*fine, thin), count, check), thin)
    surface = Surface(_doubles(shape.verts), shape.faces.cpu().numpy().astype(np.int64), count)
    check()
    new_verts, new_faces = remesh(_doubles(verts), faces.cpu().numpy(), surface, count)
    check()
    out = torch.from_numpy(new_verts).to(verts), torch.from_numpy(new_faces).to(faces)
    # What is thin may be folded, and turns the shading of all around it: a dark speck.
    verts, faces = without_thin(*simplify(*out, count), thin)
    kept = unfolded(_doubles(verts), faces.cpu().numpy(), surface.against)
    out = compact(verts, torch.from_numpy(kept).to(faces))
    return simplify(*fine, count, check) if health(*out)["degenerate_faces"] else out


def length_of(area: float, count: float) -> float:
    """The edges of ``count`` equilateral triangles over a surface of ``area``."""
    return float(np.sqrt(4 / np.sqrt(3) * area / count))


def without_thin(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], thin: float
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """A manifold without its faces of less height than ``thin``, as far as its topology lets it."""
    points, f = _doubles(verts), faces.cpu().numpy().astype(np.int64)
    corners, across = f.reshape(-1).copy(), across_of(f)
    kept, at = np.zeros(f.size, np.bool_), np.full(len(points), -1)
    at[corners] = np.arange(f.size)
    for _ in range(THIN_ROUNDS):
        if not take_out_thin((corners, across, kept), points, at, len(f), thin):
            break
    rest = corners.reshape(-1, 3)
    used, compact = np.unique(rest[rest[:, 0] >= 0], return_inverse=True)
    out = torch.from_numpy(points[used]), torch.from_numpy(compact.reshape(-1, 3))
    return out[0].to(verts), out[1].to(faces)


def even_in_charts(
    shape: Mesh, max_faces: int, check: Callable[[], None] = lambda: None
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"], Int[np.ndarray, " f"] | None]:
    """:func:`even`, and a chart for each face, the borders smooth; None where it is no manifold."""
    shape = Mesh(*oriented(shape.verts, shape.faces))
    verts, faces = even(shape, max_faces, check)
    report = health(verts, faces)
    if not (report["manifold"] and report["oriented"]) or report["degenerate_faces"]:
        return verts, faces, None
    chart = charts(at_unit_size(_doubles(verts)), faces.cpu().numpy().astype(np.int64))
    return *with_smooth_borders(verts, faces, chart, shape), chart


def with_smooth_borders(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    chart: Int[np.ndarray, " f"],
    shape: Mesh,
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
    """The mesh with the borders between charts drawn smooth over the surface of ``shape``.

    Each face keeps its chart. Sharp edges stay where they are, and where three charts meet.
    """
    points, f = _doubles(verts), faces.cpu().numpy().astype(np.int64)
    length = length_of(areas_and_normals(points, f)[0].sum(), len(f))
    mesh = table_of(points, f, len(f), length)
    surface = Surface(_doubles(shape.verts), shape.faces.cpu().numpy().astype(np.int64))
    corners = slice(0, f.size)
    other = mesh.across[corners]
    cut = (other >= 0) & (chart[np.arange(f.size) // 3] != chart[other // 3])
    pairs = np.unique(np.sort(ends_of_edges(f, cut), 1), axis=0)
    degree = np.bincount(pairs.reshape(-1), minlength=len(points))
    fixed = mesh.kind[: len(points)] != loops.FREE
    mesh.kind[: len(points)] = np.where(degree == 2, loops.LINE, loops.HELD)
    mesh.kind[: len(points)][degree == 0] = loops.FREE
    mesh.kind[: len(points)][fixed] = loops.HELD
    mesh.kept[corners] |= cut
    for _ in range(BORDER_ROUNDS):
        fit(mesh, surface, length)
        places = loops.wanted_places(mesh.links, mesh.verts, mesh.kind, mesh.at, mesh.counts)
        line = mesh.kind[: len(places)] == loops.LINE
        _, _, near = surface.tree.squared_distance(
            surface.verts, surface.faces, np.ascontiguousarray(places[line])
        )
        places[line] = near
        loops.move(mesh.links, mesh.verts, mesh.quadrics, mesh.kind, mesh.at, places)
        loops.flip_edges(mesh.links, mesh.verts, mesh.quadrics, mesh.at, mesh.counts, True)
    out = mesh.verts[: len(points)], mesh.corners[corners].reshape(-1, 3)
    return torch.from_numpy(out[0].copy()).to(verts), torch.from_numpy(out[1].copy()).to(faces)


def _doubles(verts: Float[Tensor, "v 3"]) -> Float[np.ndarray, "v 3"]:
    return np.ascontiguousarray(verts.detach().cpu().double().numpy())


class Surface:
    """The surface of the vertices: the mesh at its full resolution."""

    def __init__(
        self, verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], count: int = MANY
    ) -> None:
        """``count``: of the faces that it is to have."""
        self.verts, self.faces = verts, np.ascontiguousarray(faces)
        self.areas, self.normals = areas_and_normals(verts, faces)
        self.middles = verts[faces].mean(1)
        self.lengths = lengths(verts, faces, self.areas, count >= MANY)
        self.tree = igl.AABB()
        self.tree.init(self.verts, self.faces)

    def against(
        self, points: Float[np.ndarray, "n 3"], normals: Float[np.ndarray, "n 3"]
    ) -> Float[np.ndarray, " n"]:
        """One less the cosine between each normal and the most like it of the faces there."""
        _, face = self.faces_by_place.query(points, min(AT_A_PLACE, len(self.middles)))
        # Of a large face the middle may be far away.
        points = np.ascontiguousarray(points)
        _, own, _ = self.tree.squared_distance(self.verts, self.faces, points)
        there = np.column_stack([np.asarray(k).reshape(len(points), -1) for k in (face, own)])
        return 1 - (normals[:, None] * self.normals[there]).sum(-1).max(1)

    @cached_property
    def faces_by_place(self) -> KDTree:
        """The faces' middles."""
        return KDTree(self.middles)

    def lengths_at(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, " n"]:
        """How long edges are to be there, by the mean length."""
        points = np.ascontiguousarray(points)
        _, face, _ = self.tree.squared_distance(self.verts, self.faces, points)
        return self.lengths[self.faces[np.asarray(face).reshape(-1)]].mean(1)


def lengths(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    areas: Float[np.ndarray, " f"],
    many: bool,
) -> Float[np.ndarray, " v"]:
    """Edge lengths for one distance between chord and arc everywhere, times their mean.

    A sharp edge is a line of the mesh, and bends nothing: each of its sides does by itself. With
    few faces edges are as long as a leg is thick, and short ones at its edges keep it whole.

    Dunyach et al., "Adaptive Remeshing for Real-Time Mesh Deformation", 2013, §2.1.
    """
    least, most = GRADE if many else COARSE_GRADE
    if many:
        sides = np.asarray(igl.per_corner_normals(verts, faces, BENT_DEG)).reshape(-1, 3, 3)
    else:
        sides = smooth_normals(torch.from_numpy(verts), torch.from_numpy(faces)).numpy()[faces]
    a, b = faces.reshape(-1), np.roll(faces, -1, 1).reshape(-1)
    size = np.linalg.norm(verts[a] - verts[b], axis=1)
    bend = np.linalg.norm(sides - np.roll(sides, -1, 1), axis=2).reshape(-1)
    bend = bend / np.maximum(size, 1e-30)
    curvature = np.zeros(len(verts))
    for end in (a, b):
        np.maximum.at(curvature, end, bend)
    mean = mean_around(faces, len(verts))
    for _ in range(SMOOTHING):
        curvature = (curvature + mean @ curvature) / 2
    length = 1 / np.sqrt(np.maximum(curvature, 1e-9 * curvature.max() + 1e-30))
    # So many faces come out as without it: a face's area goes with the length's square.
    weight = np.bincount(faces.reshape(-1), np.repeat(areas, 3), len(verts))
    for again in range(FITTING if many else 1):
        graded = length.clip(least, most) if again else length
        length /= np.sqrt(weight.sum() / (weight / graded**2).sum())
    return length.clip(least, most)


@dataclass
class Table:
    """A corner table with room to grow (:mod:`core.kernels.corner_table`)."""

    corners: Int[np.ndarray, " c"]
    across: Int[np.ndarray, " c"]
    kept: Bool[np.ndarray, " c"]
    verts: Float[np.ndarray, "v 3"]
    quadrics: Float[np.ndarray, "v 11"]
    kind: Int[np.ndarray, " v"]
    at: Int[np.ndarray, " v"]
    want: Float[np.ndarray, " v"]
    counts: Int[np.ndarray, " 2"]

    @property
    def links(self) -> tuple:
        """The loops' table of the faces."""
        return self.corners, self.across, self.kept

    @property
    def faces(self) -> Int[np.ndarray, "f 3"]:
        """The faces that there are."""
        every = self.corners[: 3 * self.counts[1]].reshape(-1, 3)
        return every[every[:, 0] >= 0]


def remesh(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], surface: Surface, count: int
) -> tuple[Float[np.ndarray, "w 3"], Int[np.ndarray, "g 3"]]:
    """About ``count`` even faces over ``surface``, from a manifold mesh of it."""
    length = length_of(areas_and_normals(verts, faces)[0].sum(), MARGIN * count)
    mesh = table_of(verts, faces, count, length)
    state, lines = (mesh.links, mesh.verts, mesh.quadrics), ends_of(mesh)
    for _ in range(ROUNDS):
        used = int(mesh.counts[0])
        mesh.want[:used] = length * surface.lengths_at(mesh.verts[:used])
        fit(mesh, surface, length)
        loops.split_long(*state, mesh.kind, mesh.at, mesh.want, mesh.counts)
        loops.collapse_short(*state, mesh.kind, mesh.at, mesh.want, mesh.counts)
        loops.flip_edges(*state, mesh.at, mesh.counts, False)
        spread(mesh, surface, lines, length)
        length *= np.sqrt(len(mesh.faces) / (MARGIN * count))
    for _ in range(LAST_ROUNDS):
        loops.flip_edges(*state, mesh.at, mesh.counts, True)
        spread(mesh, surface, lines, length)
    loops.flip_edges(*state, mesh.at, mesh.counts, True)
    used, compact = np.unique(mesh.faces, return_inverse=True)
    return mesh.verts[used], compact.reshape(-1, 3).astype(np.int64)


def table_of(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], count: int, length: float
) -> Table:
    """The mesh as a corner table; its open borders and its sharp edges are lines."""
    room = 3 * max(count, len(faces)) + 1000
    corners, across = np.full(3 * room, -1), np.full(3 * room, -1)
    kept, kind, at = np.zeros(3 * room, np.bool_), np.zeros(room, np.int64), np.full(room, -1)
    corners[: faces.size], across[: faces.size] = faces.reshape(-1), across_of(faces)
    lines = sharp(verts, faces, across[: faces.size], SHORTEST_LINE * length)
    kept[: faces.size] = lines | (across[: faces.size] < 0)
    at[faces.reshape(-1)] = np.arange(faces.size)
    kind[: len(verts)] = kinds(verts, ends_of_edges(faces, kept[: faces.size]))
    points, counts = np.zeros((room, 3)), np.array([len(verts), len(faces)])
    points[: len(verts)] = verts
    return Table(
        corners, across, kept, points, np.zeros((room, 11)), kind, at, np.zeros(room), counts
    )


def across_of(faces: Int[np.ndarray, "f 3"]) -> Int[np.ndarray, " c"]:
    """The corner beyond the edge across from each corner; -1 at a border."""
    # Column i of ``neighbours`` is the edge from corner i to i + 1, across from corner i + 2.
    beyond = np.roll(neighbours(faces), -1, 1)
    ends = np.sort(np.stack([np.roll(faces, -1, 1), np.roll(faces, 1, 1)], -1), -1)
    out = np.full(faces.shape, -1)
    face, corner = np.nonzero(beyond >= 0)
    other = beyond[face, corner]
    same = (ends[other] == ends[face, corner][:, None]).all(-1)
    out[face, corner] = 3 * other + same.argmax(1)
    return out.reshape(-1)


def sharp(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    across: Int[np.ndarray, " c"],
    shortest: float,
) -> Bool[np.ndarray, " c"]:
    """The lines of sharp edges, by the corner across: BENT, SHARP somewhere, ``shortest`` long."""
    area, normal = areas_and_normals(verts, faces)
    p = verts[faces]
    squares = np.square(p - np.roll(p, 1, 1)).sum((1, 2))
    sound = 4 * np.sqrt(3) * area > FLAT * squares  # 1 is equilateral
    face, other = np.arange(len(across)) // 3, across // 3
    cosine = (normal[face] * normal[other]).sum(1)
    bent = (across >= 0) & (cosine < BENT) & sound[face] & sound[other]
    ends = ends_of_edges(faces, bent)
    links = coo_array((np.ones(len(ends), np.int8), ends.T), shape=(len(verts),) * 2)
    line = connected_components(links, directed=False)[1][ends[:, 0]]
    size = np.linalg.norm(verts[ends[:, 0]] - verts[ends[:, 1]], axis=1)
    # Each edge is counted from both of its sides.
    long = np.bincount(line, size, len(verts)) > 2 * shortest
    sharp_somewhere = np.bincount(line, cosine[bent] < SHARP, len(verts)) > 0
    out = bent.copy()
    out[bent] = (long & sharp_somewhere)[line]
    return out


def kinds(verts: Float[np.ndarray, "v 3"], ends: Int[np.ndarray, "e 2"]) -> Int[np.ndarray, " v"]:
    """FREE without a kept edge, LINE on two that go on nearly straight, else HELD."""
    pairs = np.unique(np.sort(ends, 1), axis=0)
    both = np.concatenate([pairs, pairs[:, ::-1]])
    degree = np.bincount(both[:, 0], minlength=len(verts))
    way = unit(verts[both[:, 1]] - verts[both[:, 0]])
    total = np.stack([np.bincount(both[:, 0], x, len(verts)) for x in way.T], 1)
    # Two unit vectors at an angle a: their sum's square is 2 + 2 cos a, and straight on is pi.
    straight = np.square(total).sum(1) < 2 - 2 * KINK
    kind = np.full(len(verts), loops.HELD)
    kind[degree == 0] = loops.FREE
    kind[(degree == 2) & straight] = loops.LINE
    return kind


def ends_of_edges(
    faces: Int[np.ndarray, "f 3"], these: Bool[np.ndarray, " c"]
) -> Int[np.ndarray, "e 2"]:
    """The two ends of the edge across from each corner of ``these``."""
    ends = np.stack([np.roll(faces, -1, 1), np.roll(faces, 1, 1)], -1).reshape(-1, 2)
    return ends[these]


def ends_of(mesh: Table) -> tuple[Float[np.ndarray, "s 3"], Float[np.ndarray, "s 3"]]:
    """Where the lines are: both ends of each edge."""
    faces = mesh.corners[: 3 * mesh.counts[1]].reshape(-1, 3)
    ends = ends_of_edges(faces, mesh.kept[: faces.size])
    return mesh.verts[ends[:, 0]], mesh.verts[ends[:, 1]]


def fit(mesh: Table, surface: Surface, length: float) -> None:
    """Each vertex's quadric: of the surface's faces that are nearest to it and look as it does."""
    used, faces = int(mesh.counts[0]), mesh.faces
    live = np.unique(faces)
    normal = unit(normals_of(mesh.verts[:used], faces))
    tree = KDTree(np.c_[mesh.verts[live], NEAR * length * normal[live]])
    _, nearest = tree.query(np.c_[surface.middles, NEAR * length * surface.normals])
    own = add_planes(live[nearest], surface.middles, surface.normals, surface.areas, used)
    mesh.quadrics[:used] = own + AROUND * (mean_around(faces, used) @ own)


def spread(mesh: Table, surface: Surface, lines: tuple, length: float) -> None:
    """Each vertex to the middle of its surroundings, as far as the surface there lets it."""
    fit(mesh, surface, length)
    places = loops.wanted_places(mesh.links, mesh.verts, mesh.kind, mesh.at, mesh.counts)
    line = (mesh.kind[: len(places)] == loops.LINE) & (mesh.at[: len(places)] >= 0)
    places[line] = loops.on_lines(places[line], *lines)
    loops.move(mesh.links, mesh.verts, mesh.quadrics, mesh.kind, mesh.at, places)
