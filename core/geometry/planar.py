"""The planes of a mesh: which faces were meant to lie in one, and where it is.

Regions grow from the flattest faces over neighbours that lie near the region's plane, which is
fitted again as it grows (Rabbani, van den Heuvel and Vosselman, "Segmentation of Point Clouds using
Smoothness Constraint", 2006); a surface that bends all over is no plane, however shallow. Planes
nearly along an axis are aligned with it, nearly equal ones merged (Li et al., "GlobFit", 2011). All
lengths here are in cells of the lattice that the mesh comes from: its errors are of that size.
"""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from core.kernels.regions import connected, relabel

REFITS = 5  # of a plane while its region grows
SPAN = 1.7  # standard deviations to the end of an even distribution
ALONG_AXIS = np.cos(np.radians(8.0))
SAME = 0.6  # cells between two parallel planes of a part that are one
SLIGHT_DEG = 8.0  # of bend: a long plane may do so and wave by more
# Cells of half width and of half length: of a beam, where the rounding reaches to the middle.
NARROW, LONG = 3.0, 4.5
JOINED = np.cos(np.radians(22.0))  # least cosine between neighbours that may be one plane
JOINED_OFF = 0.8  # cells off the common plane, of 95 % of the faces
MIRRORED, MIRRORED_AREA = 0.4, 15.0  # of a plane's area, in its mirror image; square cells
SPREAD_ROUNDS = 4
SPREAD_OFF, SPREAD_COSINE = 1.2, np.cos(np.radians(65.0))
COSTS = np.array([0.35, 1.2, 1.0, 0.5, 0.35])  # of ``relabel``
RELABEL_ROUNDS = 20


class Limits(NamedTuple):
    """The limits of a region, and its least size."""

    angle_deg: float  # between a face and the plane
    far: float  # cells off it
    least: float  # square cells
    sagitta: float  # cells that it bends over its half width, at most
    bend_deg: float  # between its middle and its end, at most


# First what is surely flat; then, in the directions that these have, also what is wavy. Of a part
# that is mostly round only what does not bend at all and is square to an axis, such as a mug's rim.
SURE = Limits(30.0, 0.6, 9.0, 0.45, 15.0)
WAVY = Limits(42.0, 1.1, 6.0, 0.9, 24.0)
STRICT = Limits(25.0, 0.6, 25.0, 0.35, 8.0)
MOSTLY_FLAT, HARDLY_FLAT = 0.53, 0.12  # fractions of a part's surface
WAVY_AXIS, WAVY_PARALLEL = np.cos(np.radians(12.0)), np.cos(np.radians(8.0))


@dataclass
class Patch:
    """A mesh's faces, as their middles have it."""

    faces: Int[np.ndarray, "f 3"]
    middle: Float[np.ndarray, "f 3"]  # cells
    unbent: Float[np.ndarray, "f 3"]  # the middles before bilateral filtering, which makes facets
    normal: Float[np.ndarray, "f 3"]  # unit, without ripples
    area: Float[np.ndarray, " f"]  # square cells
    part: Int[np.ndarray, " f"]
    adjacent: Int[np.ndarray, "f 3"]  # across the edge from corner i to i + 1; -1 at a border
    length: Float[np.ndarray, "f 3"]  # cells, of that edge
    flatness: Float[np.ndarray, " f"]  # the flat fraction of its part's surface


@dataclass
class Planes:
    """Planes n · x = d, and the faces of each."""

    label: Int[np.ndarray, " f"]  # -1: of none
    normal: list[Float[np.ndarray, " 3"]] = field(default_factory=list)
    offset: list[float] = field(default_factory=list)  # cells
    part: list[int] = field(default_factory=list)

    @property
    def table(self) -> Float[np.ndarray, "p 4"]:
        """Normal and offset of each."""
        return np.c_[np.reshape(self.normal, (-1, 3)), self.offset]


def planes_of(patch: Patch) -> Planes:
    """The planes of a mesh; each face has at most one."""
    planes = Planes(np.full(len(patch.faces), -1))
    flat = patch.flatness >= MOSTLY_FLAT
    ends = ~flat & (patch.flatness >= HARDLY_FLAT)
    grow(patch, planes, STRICT, ends, directions=np.zeros((0, 3)))
    grow(patch, planes, SURE, flat)
    join(patch, planes)
    grow(patch, planes, WAVY, flat, directions=np.array(planes.normal).reshape(-1, 3))
    join(patch, planes)
    if not planes.normal:
        return planes
    align(patch, planes)
    mirror(patch, planes)
    spread(patch, planes)
    part = np.array(planes.part)
    state = (patch.normal, patch.middle, patch.area, patch.part, part, patch.adjacent, patch.length)
    relabel(planes.label, planes.table, COSTS, *state, RELABEL_ROUNDS)
    align(patch, planes)
    return planes


def grow(
    patch: Patch,
    planes: Planes,
    limits: Limits,
    among: Bool[np.ndarray, " f"],
    directions: np.ndarray | None = None,
) -> None:
    """Add the planes of faces ``among`` which have none yet; with ``directions`` only along these
    or an axis."""
    least, count = np.cos(np.radians(limits.angle_deg)), len(patch.faces)
    mark, queue, stamp = np.zeros(count, np.int64), np.zeros(count, np.int64), 0
    tried = ~among
    state = (patch.normal, patch.middle, patch.part, planes.label, patch.adjacent)
    for seed in np.argsort(-flatness(patch), kind="stable"):
        if planes.label[seed] >= 0 or tried[seed]:
            continue
        plane, whole = np.r_[patch.normal[seed], patch.middle[seed] @ patch.normal[seed]], False
        for refit in range(REFITS):
            stamp += 1
            found = connected(seed, plane, least, limits.far, *state, mark, stamp, queue)
            region = queue[:found].copy()
            if patch.area[region].sum() < limits.least / 2:
                break
            plane, _ = fitted(patch, patch.middle, region)
            off = abs(patch.middle[seed] @ plane[:3] - plane[3])
            if patch.normal[seed] @ plane[:3] < least or off > limits.far:
                break
            whole = refit > 0
        tried[region[: max(1, found // 4)]] = True  # breadth first: those around the seed
        if whole and is_flat(patch, region, limits) and _in_line(plane[:3], directions):
            planes.label[region] = len(planes.normal)
            planes.normal.append(plane[:3])
            planes.offset.append(float(plane[3]))
            planes.part.append(int(patch.part[seed]))


def flatness(patch: Patch) -> Float[np.ndarray, " f"]:
    """The least cosine between faces that touch, three faces around."""
    itself = np.arange(len(patch.faces))[:, None]
    around = np.where(patch.adjacent < 0, itself, patch.adjacent)
    flat = (patch.normal[around] * patch.normal[:, None]).sum(-1).min(1)
    for _ in range(2):
        flat = np.minimum(flat, flat[around].min(1))
    return flat


def fitted(patch: Patch, middle: np.ndarray, region: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The plane (4,) nearest to the middles, and its axes (3, 3), the longer one last."""
    weight = patch.area[region] / patch.area[region].sum()
    centre = weight @ middle[region]
    apart = middle[region] - centre
    _, axes = np.linalg.eigh((apart * weight[:, None]).T @ apart)
    normal = axes[:, 0] * np.sign(axes[:, 0] @ (weight @ patch.normal[region]))
    return np.r_[normal, centre @ normal], axes


def is_flat(patch: Patch, region: Int[np.ndarray, " n"], limits: Limits) -> bool:
    """Whether a region is large enough, and bends as a whole no more than a wavy plane may."""
    if patch.area[region].sum() < limits.least:
        return False
    half, sagitta, bend = paraboloid(patch, patch.unbent, region)
    if half.min() < 1:  # a strip of a cell's width shows no direction across
        return False
    beam = half.min() < NARROW and half.max() > LONG
    if beam and patch.flatness[region[0]] >= MOSTLY_FLAT:
        half, sagitta, bend = paraboloid(patch, patch.middle, region)
    shallow = sagitta <= limits.sagitta or bend <= SLIGHT_DEG
    return bool(shallow and bend <= limits.bend_deg)


def paraboloid(
    patch: Patch, middle: Float[np.ndarray, "f 3"], region: Int[np.ndarray, " n"]
) -> tuple[Float[np.ndarray, " 2"], float, float]:
    """A region's half length and half width; the most that the paraboloid through it rises from the
    middle to an end, and how far it turns there, degrees.

    A cap of a ball rises, a rippled plane does not.
    """
    area = patch.area[region]
    plane, axes = fitted(patch, middle, region)
    weight = np.sqrt(area)
    across = middle[region] @ axes[:, [2, 1]]
    across -= (area @ across) / area.sum()
    half = SPAN * np.sqrt((area @ across**2) / area.sum()) + 1e-9
    u, v = (across / half).T
    terms = np.stack([np.ones_like(u), u, v, u * u, u * v, v * v], 1) * weight[:, None]
    height = (middle[region] @ plane[:3] - plane[3]) * weight
    *_, uu, uv, vv = np.linalg.lstsq(terms, height, rcond=None)[0]
    # Along its own axes: a cone's are askew in the region.
    curvature, way = np.linalg.eigh(np.array([[2 * uu, uv], [uv, 2 * vv]]) / np.outer(half, half))
    reach = np.linalg.norm(half[:, None] * way, axis=0)
    turn = np.abs(curvature) * reach
    return half, float((turn * reach / 2).max()), float(np.degrees(turn.max()))


def _in_line(normal: np.ndarray, directions: np.ndarray | None) -> bool:
    if directions is None:
        return True
    parallel = (np.abs(directions @ normal) > WAVY_PARALLEL).any()
    return bool(np.abs(normal).max() > WAVY_AXIS or parallel)


def join(patch: Patch, planes: Planes) -> None:
    """Neighbouring planes of one part become one where that fits both."""
    found = True
    while found:
        found = False
        one = np.repeat(planes.label, 3)
        other = np.where(patch.adjacent >= 0, planes.label[patch.adjacent], -1).reshape(-1)
        touch = (one >= 0) & (one < other)
        for a, b in np.unique(np.stack([one[touch], other[touch]], 1), axis=0):
            parallel = planes.normal[a] @ planes.normal[b] > JOINED
            if planes.part[a] != planes.part[b] or not parallel:
                continue
            region = np.flatnonzero((planes.label == a) | (planes.label == b))
            plane, _ = fitted(patch, patch.middle, region)
            off = np.abs(patch.middle[region] @ plane[:3] - plane[3])
            limits = Limits(0.0, 0.0, 0.0, SURE.sagitta, WAVY.bend_deg)
            if np.quantile(off, 0.95) < JOINED_OFF and is_flat(patch, region, limits):
                planes.label[region] = a
                planes.normal[a], planes.offset[a] = plane[:3], float(plane[3])
                found = True
                break


def mirror(patch: Patch, planes: Planes) -> None:
    """Where a plane's mirror image has faces without a plane, these get it: things are the same on
    the left and the right, and one half may be too wavy to find its planes."""
    for k in range(len(planes.normal)):
        area = patch.area[planes.label == k].sum()
        normal = planes.normal[k] * np.array([-1.0, 1.0, 1.0])
        off = np.abs(patch.middle @ normal - planes.offset[k])
        near = (off < WAVY.far) & (patch.normal @ normal > np.cos(np.radians(WAVY.angle_deg)))
        near &= (planes.label < 0) & (patch.part == planes.part[k])
        region = largest(near, patch)
        if area > MIRRORED_AREA and patch.area[region].sum() > MIRRORED * area:
            planes.label[region] = len(planes.normal)
            planes.normal.append(normal)
            planes.offset.append(planes.offset[k])
            planes.part.append(planes.part[k])


def largest(there: Bool[np.ndarray, " f"], patch: Patch) -> Int[np.ndarray, " n"]:
    """The largest connected region of some faces."""
    face, side = np.nonzero((patch.adjacent >= 0) & there[:, None])
    other = patch.adjacent[face, side]
    face, other = face[there[other]], other[there[other]]
    graph = coo_array((np.ones(len(face), np.int8), (face, other)), shape=(len(there),) * 2)
    component = connected_components(graph, directed=False)[1]
    area = np.bincount(component, patch.area * there)
    return np.flatnonzero(there & (component == area.argmax()))


def spread(patch: Patch, planes: Planes) -> None:
    """Faces without a plane take that of a neighbour, the one that fits best, if one does."""
    table, part = planes.table, np.array(planes.part)
    for _ in range(SPREAD_ROUNDS):
        free = np.flatnonzero(planes.label < 0)
        next_to = patch.adjacent[free]
        label = np.where(next_to >= 0, planes.label[next_to], -1)
        plane = table[label]
        off = np.abs((patch.middle[free][:, None] * plane[..., :3]).sum(-1) - plane[..., 3])
        cosine = (patch.normal[free][:, None] * plane[..., :3]).sum(-1)
        fits = (label >= 0) & (off < SPREAD_OFF) & (cosine > SPREAD_COSINE)
        fits &= part[label] == patch.part[free][:, None]
        cost = np.where(fits, off + 1 - cosine, np.inf)
        best = cost.argmin(1)
        every = np.arange(len(free))
        planes.label[free] = np.where(np.isfinite(cost[every, best]), label[every, best], -1)


def align(patch: Patch, planes: Planes) -> None:
    """Normals along an axis where they nearly are, offsets by the faces, nearly equal ones one."""
    total = np.zeros(len(planes.normal))
    for k, normal in enumerate(planes.normal):
        mine = planes.label == k
        axis = np.abs(normal).argmax()
        if abs(normal[axis]) > ALONG_AXIS:
            planes.normal[k] = np.sign(normal[axis]) * np.eye(3)[axis]
        total[k] = patch.area[mine].sum()
        if total[k] > 0:
            heights = patch.middle[mine] @ planes.normal[k]
            planes.offset[k] = float(patch.area[mine] @ heights / total[k])
    left = [int(k) for k in np.argsort(-total, kind="stable")]
    while left:
        first = left[0]
        same = [
            k
            for k in left
            if planes.part[k] == planes.part[first]
            and planes.normal[k] @ planes.normal[first] > 1 - 1e-9
            and abs(planes.offset[k] - planes.offset[first]) < SAME
        ]
        weight = total[same] + 1e-12
        offset = float(weight @ np.array(planes.offset)[same] / weight.sum())
        for k in same:
            planes.offset[k] = offset
            planes.label[planes.label == k] = first
        left = [k for k in left if k not in same]
