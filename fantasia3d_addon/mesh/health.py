"""The health of a mesh and its textures, and repairs that keep the UVs."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass

import bmesh
import bpy
import numpy as np
from mathutils import Matrix, Vector
from mathutils.bvhtree import BVHTree

from ..blender.mesh_arrays import (
    acting,
    corner_uv,
    is_shared,
    mesh_object,
    move_kept_shape,
    triangles,
    values,
    verts_of,
)
from ..errors import AddonError
from ..material.edit import image_of, principled

WELD = 1e-5  # of the size: vertices closer than that are one
SMALL = 0.01  # of the faces: a connected component with fewer is removed as small
GRID = 128  # samples along a side of the UV square


@dataclass(frozen=True)
class Report:
    """The result of :func:`examine`; counts unless stated otherwise."""

    verts: int
    faces: int
    triangles: int
    components: int  # connected by edges
    small_components: int  # with less than SMALL of the faces
    loose: int  # vertices without a face
    doubled: int  # vertices on open borders at the place of another
    degenerate: int  # faces with an area of 0
    open_edges: int
    nonmanifold: int  # edges of three faces or more, and vertices where two surfaces touch
    inverted: bool  # normals inward, or not consistent
    scaled: bool  # its scale is not 1, which modifiers and simulations do not expect
    uv_fill: float | None  # covered fraction of the UV square; None without UVs
    uv_overlap: float  # fraction of the square that is covered more than once
    texel_density: float | None  # texels per metre
    textures: tuple[tuple[str, int, int], ...]  # name, width, height

    @property
    def closed(self) -> bool:
        """Whether it has no open edge."""
        return self.open_edges == 0 and self.faces > 0

    @property
    def manifold(self) -> bool:
        """Whether each edge has two faces and each vertex one fan."""
        return self.nonmanifold == 0 and self.open_edges == 0

    @property
    def faults(self) -> tuple[str, ...]:
        """The repairs that would change something, in the order in which they are made."""
        wrong = {
            "LOOSE": self.loose > 0,
            "DEGENERATE": self.degenerate > 0,
            "WELD": self.doubled > 0,
            "NONMANIFOLD": self.nonmanifold > 0,
            "SPECKS": self.small_components > 0,
            "HOLES": self.open_edges > 0,
            "NORMALS": self.inverted,
            "SCALE": self.scaled,
            "UV": self.uv_fill is None,
        }
        return tuple(name for name, is_wrong in wrong.items() if is_wrong)


REPAIRS = {
    "LOOSE": ("Remove Loose Vertices", "Remove vertices that no face has"),
    "DEGENERATE": ("Dissolve Degenerate Faces", "Dissolve faces with an area of 0"),
    "WELD": ("Weld", "Merge vertices at the same place; UV seams stay"),
    "NONMANIFOLD": ("Split Non-Manifold", "Separate surfaces that share an edge or a vertex"),
    "SPECKS": (
        "Remove Small Components",
        "Remove connected components with less than 1 % of the faces",
    ),
    "HOLES": ("Fill Holes", "Close open borders with new faces"),
    "NORMALS": ("Recalculate Normals", "Make all normals point outward"),
    "SCALE": ("Apply Scale", "Set the scale to 1; nothing visible moves"),
    "UV": ("Create UVs", "Unwrap a mesh without UVs"),
}


def examine(obj: bpy.types.Object) -> Report:
    """The report on the mesh of ``obj``, without its modifiers.

    Raises:
        AddonError: it is no mesh with faces.
    """
    mesh = mesh_object(obj).data
    # BMesh knows which faces an edge has; a Mesh does not.
    bm = bmesh.new()
    bm.from_mesh(mesh)
    size = _size(mesh)
    components = _components(bm)
    fill, overlap, uv_area = _uv_cover(mesh)
    textures = textures_of(obj)
    found = Report(
        verts=len(bm.verts),
        faces=len(bm.faces),
        triangles=sum(len(face.verts) - 2 for face in bm.faces),
        components=len(components),
        small_components=sum(len(part) < SMALL * len(bm.faces) for part in components),
        loose=sum(not vert.link_faces for vert in bm.verts),
        # Of borders alone: see _borders.
        doubled=len(bmesh.ops.find_doubles(bm, verts=_borders(bm), dist=WELD * size)["targetmap"]),
        degenerate=sum(face.calc_area() <= 1e-12 * size**2 for face in bm.faces),
        open_edges=sum(len(edge.link_faces) == 1 for edge in bm.edges),
        nonmanifold=sum(len(edge.link_faces) > 2 for edge in bm.edges)
        + sum(_touches(vert) for vert in bm.verts),
        inverted=_inverted(bm),
        scaled=any(abs(s - 1) > 1e-4 for s in obj.scale),
        uv_fill=fill,
        uv_overlap=overlap,
        texel_density=_density(obj, bm, uv_area, textures),
        textures=textures,
    )
    bm.free()
    return found


# By the mesh's session_uid: its counts when it was examined, and the report.
_reports: dict[int, tuple[tuple[int, int], Report]] = {}


def update_report(obj: bpy.types.Object) -> Report:
    """:func:`examine`, kept for :func:`cached_report`: a panel is drawn many times a second."""
    report = examine(obj)
    _reports[obj.data.session_uid] = ((len(obj.data.vertices), len(obj.data.polygons)), report)
    return report


def cached_report(obj: bpy.types.Object) -> Report | None:
    """The last report on ``obj``; None if its mesh has other counts of vertices or faces now."""
    counts, report = _reports.get(obj.data.session_uid, (None, None))
    return report if counts == (len(obj.data.vertices), len(obj.data.polygons)) else None


def repair(obj: bpy.types.Object, what: str | None = None) -> tuple[str, ...]:
    """Apply the repair ``what`` of REPAIRS, or all that are needed; the names of those applied.

    Among all, the scale is left where other objects share the mesh: it would change them too.

    Raises:
        AddonError: there is no such repair, the mesh has shape keys, or it is shared and ``what``
            is its scale.
    """
    mesh = mesh_object(obj).data
    if what is not None and what not in REPAIRS:
        raise AddonError(f"There is no repair {what!r}.", f"Use one of {', '.join(REPAIRS)}.")
    # BMesh operators would leave the keys with other counts of vertices.
    if mesh.shape_keys:
        raise AddonError(f"{obj.name} has shape keys.", "Apply or remove them first.")
    if what == "SCALE" and is_shared(mesh):
        raise AddonError(
            f"Other objects share the mesh of {obj.name}, and a scale would change them too.",
            "Make it single-user first: Object, Relations, Make Single User.",
        )
    done: list[str] = []
    # In this order: a weld makes edges that only then are seen as non-manifold.
    for name in (what,) if what else REPAIRS:
        if name in examine(obj).faults and not (name == "SCALE" and is_shared(mesh)):
            _apply_repair(obj, name)
            done.append(name)
    return tuple(done)


def textures_of(obj: bpy.types.Object) -> tuple[tuple[str, int, int], ...]:
    """Name, width and height of the pictures that feed the materials of ``obj``."""
    images = {}
    for slot in obj.material_slots:
        bsdf = principled(slot.material)
        for socket in bsdf.inputs if bsdf else ():
            found = image_of(socket)
            if found:
                images[found[0].name] = tuple(found[0].size)
    return tuple((name, *size) for name, size in sorted(images.items()))


def _apply_repair(obj: bpy.types.Object, what: str) -> None:
    if what == "SCALE":
        scale = Matrix.Diagonal((*obj.scale, 1.0))
        corners = tuple(obj.data.polygons[0].vertices)
        with acting(obj):
            bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
        move_kept_shape(obj.data, scale)
        # A mirrored object: keep the normals outward, where Blender has not done so.
        if scale.determinant() < 0 and tuple(obj.data.polygons[0].vertices) == corners:
            obj.data.flip_normals()
        return
    if what == "UV":
        unwrap(obj)
        return
    mesh = obj.data
    bm = bmesh.new()
    bm.from_mesh(mesh)
    _REPAIR_FUNCTIONS[what](bm, _size(mesh))
    bm.to_mesh(mesh)
    bm.free()
    mesh.update()


def unwrap(obj: bpy.types.Object) -> None:
    """Create UVs by Blender's Smart UV Project, packed by the islands' outlines with a margin."""
    if obj.data.uv_layers.active is None:
        obj.data.uv_layers.new(name="UVMap")
    with acting(obj), _nothing_hidden(obj.data):
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.uv.smart_project(angle_limit=1.15, island_margin=0.0, area_weight=0.0)
        # Its own packing, by boxes, fills half of the square; outlines fill two thirds. With a
        # SCALED margin a few islands take five times as long.
        bpy.ops.uv.select_all(action="SELECT")
        bpy.ops.uv.pack_islands(
            rotate_method="CARDINAL", shape_method="CONCAVE", margin_method="ADD", margin=0.002
        )
        bpy.ops.object.mode_set(mode="OBJECT")


@contextlib.contextmanager
def _nothing_hidden(mesh: bpy.types.Mesh) -> Iterator[None]:
    """Show what was hidden in Edit Mode, whose operators skip it; hide it again afterwards."""
    parts = (mesh.vertices, mesh.edges, mesh.polygons)
    hidden = [values(part, "hide", 1, bool).ravel() for part in parts]
    for part in parts:
        part.foreach_set("hide", np.zeros(len(part), bool))
    try:
        yield
    finally:
        # Again from the mesh: Edit Mode has rewritten all of it.
        parts = (mesh.vertices, mesh.edges, mesh.polygons)
        for part, was in zip(parts, hidden, strict=True):
            part.foreach_set("hide", was)


def _loose(bm: bmesh.types.BMesh, _size: float) -> None:
    bmesh.ops.delete(bm, geom=[v for v in bm.verts if not v.link_faces], context="VERTS")


def _degenerate(bm: bmesh.types.BMesh, size: float) -> None:
    bmesh.ops.dissolve_degenerate(bm, dist=1e-6 * size, edges=bm.edges[:])
    _loose(bm, size)


def _weld(bm: bmesh.types.BMesh, size: float) -> None:
    bmesh.ops.remove_doubles(bm, verts=_borders(bm), dist=WELD * size)


def _split(bm: bmesh.types.BMesh, _size: float) -> None:
    """Separate faces at edges of three or more, then fans at the vertices where they touch."""
    edges = [edge for edge in bm.edges if len(edge.link_faces) > 2]
    if edges:
        bmesh.ops.split_edges(bm, edges=edges)
    for vert in [vert for vert in bm.verts if _touches(vert)]:
        bmesh.utils.vert_separate(vert, [])


def _borders(bm: bmesh.types.BMesh) -> list[bmesh.types.BMVert]:
    """Vertices on open borders: closed components that touch are no fault, and stay separate."""
    return [vert for vert in bm.verts if vert.is_boundary]


def _small(bm: bmesh.types.BMesh, size: float) -> None:
    least = SMALL * len(bm.faces)
    faces = [face for part in _components(bm) if len(part) < least for face in part]
    bmesh.ops.delete(bm, geom=faces, context="FACES")
    _loose(bm, size)


def _holes(bm: bmesh.types.BMesh, _size: float) -> None:
    """Fill holes; new faces get the UVs of adjacent corners, and the material of adjacent faces."""
    layer = bm.loops.layers.uv.active
    made = bmesh.ops.holes_fill(bm, edges=[e for e in bm.edges if e.is_boundary], sides=0)
    # A filled hole is one polygon, which is rarely flat.
    made = set(bmesh.ops.triangulate(bm, faces=made["faces"])["faces"])
    for face in made:
        face.smooth = True
        near = next((f for e in face.edges for f in e.link_faces if f not in made), None)
        face.material_index = near.material_index if near else 0
        for loop in face.loops if layer else ():
            old = [other for other in loop.vert.link_loops if other.face not in made]
            if old:
                loop[layer].uv = old[0][layer].uv


def _outward(bm: bmesh.types.BMesh, _size: float) -> None:
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces[:])


_REPAIR_FUNCTIONS = {
    "LOOSE": _loose, "DEGENERATE": _degenerate, "WELD": _weld, "NONMANIFOLD": _split,
    "SPECKS": _small, "HOLES": _holes, "NORMALS": _outward,
}  # fmt: skip


def _size(mesh: bpy.types.Mesh) -> float:
    return float(np.ptp(verts_of(mesh), axis=0).max())


def _components(bm: bmesh.types.BMesh) -> list[set[bmesh.types.BMFace]]:
    """The faces of each component that is connected by edges."""
    left, components = set(bm.faces), []
    while left:
        front = [left.pop()]  # flood fill from any face
        component = set(front)
        while front:
            near = {f for e in front.pop().edges for f in e.link_faces} & left
            left -= near
            component |= near
            front.extend(near)
        components.append(component)
    return components


def _touches(vert: bmesh.types.BMVert) -> bool:
    """Whether surfaces that are manifold by themselves meet in this vertex alone."""
    return (
        not vert.is_manifold
        and len(vert.link_faces) > 1
        and all(len(edge.link_faces) in (1, 2) for edge in vert.link_edges)
    )


def _inverted(bm: bmesh.types.BMesh) -> bool:
    """Whether a closed surface has a negative volume, or adjacent faces opposite normals."""
    if any(len(e.link_faces) == 2 and not e.is_contiguous for e in bm.edges):
        return True
    closed = not any(edge.is_boundary for edge in bm.edges)
    return closed and len(bm.faces) > 3 and bm.calc_volume(signed=True) < 0


def _uv_cover(mesh: bpy.types.Mesh) -> tuple[float | None, float, float]:
    """Covered fraction of the UV square, the fraction covered twice, the sum of all areas."""
    uv = corner_uv(mesh)
    if uv is None:
        return None, 0.0, 0.0
    _, corners = triangles(mesh)
    points = uv[corners]  # (T,3,2)
    a, b = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    areas = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
    # A degenerate triangle covers nothing, and disturbs the tree.
    kept = points[areas > 1e-12]
    if not len(kept):
        return 0.0, 0.0, 0.0
    flat = np.concatenate([kept.reshape(-1, 2), np.zeros((3 * len(kept), 1))], 1)
    faces = np.arange(3 * len(kept)).reshape(-1, 3)
    # Blender's ray cast on the flat UV triangles: is there one above the sample?
    tree = BVHTree.FromPolygons(flat.tolist(), faces.tolist(), all_triangles=True)
    # Rays onto a grid of samples: the union of overlapping triangles has no simple formula.
    down, at = Vector((0, 0, -1)), (np.arange(GRID) + 0.5) / GRID
    hits = sum(tree.ray_cast((x, y, 1.0), down)[2] is not None for y in at for x in at)
    fill, total = hits / GRID**2, float(areas.sum())
    # 0.03: the samples' error along the islands' borders is no overlap.
    overlap = total - fill if total > fill + 0.03 else 0.0
    return fill, overlap, total


def _density(
    obj: bpy.types.Object,
    bm: bmesh.types.BMesh,
    uv_area: float,
    textures: tuple[tuple[str, int, int], ...],
) -> float | None:
    if not textures or not uv_area:
        return None
    # BMesh has local units; texels per metre are in the world.
    scale = float(np.mean(np.abs(obj.scale)))
    area = sum(face.calc_area() for face in bm.faces) * scale**2
    texels = max(width * height for _, width, height in textures)
    return float(np.sqrt(uv_area * texels / area)) if area else None
