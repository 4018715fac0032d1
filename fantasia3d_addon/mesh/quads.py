"""Quads over a closed surface: QuadriFlow's, or pairs of triangles where those lose the shape.

QuadriFlow's rows of even quads flow around a smooth body, but a thin wall comes out with holes and
a sharp edge ragged. Triangles of an edge collapse keep both: two and two become a quad, and each
face is cut from its middle into quads, whose corners go onto the surface.
"""

from __future__ import annotations

import math

import bmesh
import bpy
import numpy as np
from mathutils import Matrix, Vector
from mathutils.bvhtree import BVHTree

from ..blender.mesh_arrays import acting, verts_of
from ..errors import AddonError
from . import proxy

NEAR = 0.01  # of the size: QuadriFlow's quads are taken up to that distance
LARGE = 100.0  # metres: of a mesh's longest side while QuadriFlow has it
POINTS = 5000  # at which distances are looked up
BENT = math.radians(50.0)  # between two triangles: more, and they stay two
TRIES = 5  # until there are no more quads than asked for
FEWER = 0.97  # of what the last try would need
OPPOSITE = 0.3  # cosine between a corner and the surface below it: that is another wall


def to_quads(obj: bpy.types.Object, faces: int) -> float:
    """Replace the mesh of ``obj``, which is closed, by ``faces`` quads or fewer, without UVs.

    Returns their greatest distance from it, of its size. The former mesh is removed.

    Raises:
        AddonError: none were found.
    """
    former, name = obj.data, obj.data.name
    surface = Surface(former)
    flowing = _flowing(obj, faces)
    found = [] if flowing is None else [(surface.distance(flowing), flowing)]
    if not found or found[0][0] > NEAR:
        obj.data = former
        paired = _paired(obj, faces, surface)
        found += [] if paired is None else [(surface.distance(paired), paired)]
    if not found:
        obj.data = former
        raise AddonError(f"No quads were found for {obj.name}.", "Use more faces.")
    away, obj.data = min(found, key=lambda each: each[0])
    for mesh in {former, *(each for _, each in found)} - {obj.data}:
        bpy.data.meshes.remove(mesh)
    obj.data.name = name
    obj.data.shade_smooth()
    return away


class Surface:
    """The options of the quads."""

    def __init__(self, mesh: bpy.types.Mesh) -> None:
        points = verts_of(mesh)
        self.size = max(float(np.ptp(points, axis=0).max()), 1e-9)
        self.points = _some(points)
        self.tree = _tree(mesh)

    def distance(self, mesh: bpy.types.Mesh) -> float:
        """The greatest from the surface to ``mesh`` or back, of the size."""
        tree = _tree(mesh)
        there = max(tree.find_nearest(point)[3] for point in self.points)
        back = max(self.tree.find_nearest(point)[3] for point in _some(verts_of(mesh)))
        return max(there, back) / self.size


def _some(points: np.ndarray) -> np.ndarray:
    return points[:: len(points) // POINTS + 1]


def _tree(mesh: bpy.types.Mesh) -> BVHTree:
    corners = [polygon.vertices[:] for polygon in mesh.polygons]
    return BVHTree.FromPolygons(verts_of(mesh).tolist(), corners)


def _flowing(obj: bpy.types.Object, faces: int) -> bpy.types.Mesh | None:
    """QuadriFlow's quads of the mesh of ``obj``, now that of ``obj``; None where it finds none."""
    former, wanted = obj.data, faces
    # QuadriFlow refuses a mesh with an edge of less than 0.1 mm: a chair of 0.9 m has some.
    larger = LARGE / max(float(np.ptp(verts_of(former), axis=0).max()), 1e-9)
    for _ in range(TRIES):
        obj.data = former.copy()
        # The UVs of the old faces do not fit the new ones.
        while obj.data.uv_layers:
            obj.data.uv_layers.remove(obj.data.uv_layers[0])
        obj.data.transform(Matrix.Scale(larger, 4))
        with acting(obj):
            done = bpy.ops.object.quadriflow_remesh(
                mode="FACES", target_faces=wanted, use_preserve_sharp=False, smooth_normals=True
            )
        mesh = obj.data
        count = len(mesh.polygons)
        sound = done == {"FINISHED"} and count and np.isfinite(verts_of(mesh)).all()
        if sound and count <= faces:
            mesh.transform(Matrix.Scale(1 / larger, 4))
            return mesh
        obj.data = former
        bpy.data.meshes.remove(mesh)
        if not sound:
            return None
        wanted = int(FEWER * wanted * faces / count)
    return None


def _paired(obj: bpy.types.Object, faces: int, surface: Surface) -> bpy.types.Mesh | None:
    """Triangles of the mesh of ``obj``, two and two, each cut into quads; None where too many."""
    wanted = faces / 2  # two triangles make four quads
    for _ in range(TRIES):
        mesh = proxy.cage(obj, int(wanted))
        _pair(mesh)
        count = len(mesh.loops)  # a quad for each corner
        if 0 < count <= faces:
            # More than once where the mesh has few triangles.
            while len(mesh.loops) <= faces:
                verts, quads = _cut(mesh)
                mesh.clear_geometry()
                mesh.from_pydata(verts.tolist(), [], quads)
            _onto(mesh, surface.tree)
            return mesh
        bpy.data.meshes.remove(mesh)
        wanted *= FEWER * faces / max(count, 1)
    return None


def _pair(mesh: bpy.types.Mesh) -> None:
    bm = bmesh.new()
    bm.from_mesh(mesh)
    bmesh.ops.join_triangles(
        bm, faces=bm.faces[:], angle_face_threshold=BENT, angle_shape_threshold=math.pi
    )
    bm.to_mesh(mesh)
    bm.free()


def _cut(mesh: bpy.types.Mesh) -> tuple[np.ndarray, list[tuple[int, ...]]]:
    """Each face cut into quads from its middle to the middles of its edges."""
    points = verts_of(mesh)
    ends = np.array([edge.vertices[:] for edge in mesh.edges])
    middles = np.array([polygon.center[:] for polygon in mesh.polygons])
    verts = np.concatenate([points, points[ends].mean(1), middles])
    quads = []
    for number, polygon in enumerate(mesh.polygons):
        middle = len(points) + len(ends) + number
        loops = [mesh.loops[i] for i in polygon.loop_indices]
        for i, loop in enumerate(loops):  # a loop's edge leads to the next corner
            after, before = (len(points) + each.edge_index for each in (loop, loops[i - 1]))
            quads.append((loop.vertex_index, after, middle, before))
    return verts, quads


def _onto(mesh: bpy.types.Mesh, tree: BVHTree) -> None:
    """Each vertex to the nearest point of the surface, unless that looks the other way."""
    mesh.update()
    for vertex in mesh.vertices:
        place, normal, _, _ = tree.find_nearest(vertex.co)
        if normal.dot(Vector(vertex.normal)) > OPPOSITE:
            vertex.co = place
    mesh.update()
