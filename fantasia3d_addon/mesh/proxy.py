"""Simple proxies of a fine mesh for the simulation: a coarse cage, and convex parts."""

from __future__ import annotations

import math

import bmesh
import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from ..blender.mesh_arrays import apply_modifiers, baked_mesh, verts_of

WELD = 1e-5  # of the object's size: vertices closer than that are one
PLANES = 7  # candidate cuts along each axis
LOOSE = 1.12  # the hulls may have this many times the solid's own volume


def cage(obj: bpy.types.Object, faces: int) -> bpy.types.Mesh:
    """A new mesh like ``obj`` with about ``faces`` triangles, welded, in its own space."""
    mesh = baked_mesh(obj)
    mesh.materials.clear()
    # The fine mesh may have split vertices; a cage that tears is useless.
    _weld(mesh)
    mesh.calc_loop_triangles()
    fraction = faces / max(len(mesh.loop_triangles), 1)
    coarse = bpy.data.objects.new("cage", mesh)
    bpy.context.scene.collection.objects.link(coarse)
    try:
        # Decimating quads would leave faces that are not flat.
        coarse.modifiers.new("triangles", "TRIANGULATE")
        if fraction < 1:
            fewer = coarse.modifiers.new("fewer", "DECIMATE")
            fewer.ratio, fewer.use_collapse_triangulate = fraction, True
        bpy.context.view_layer.update()
        apply_modifiers(coarse)
        return coarse.data
    finally:
        bpy.data.objects.remove(coarse)


def add_struts(mesh: bpy.types.Mesh) -> int:
    """Connect each vertex through the solid with the opposite one; the number of new edges.

    They preserve a soft body's volume.
    """
    bm = bmesh.new()
    bm.from_mesh(mesh)
    bm.normal_update()
    bm.faces.ensure_lookup_table()
    tree = BVHTree.FromBMesh(bm)
    before = len(bm.edges)
    for vert in list(bm.verts):
        start = vert.co - 1e-4 * vert.normal  # or the ray hits the vertex's own faces
        hit, _, face, _ = tree.ray_cast(start, -vert.normal)
        if hit is None:
            continue
        # The nearest vertex of the face that the ray hits.
        across = min(bm.faces[face].verts, key=lambda other, at=hit: (other.co - at).length)
        if across is not vert and bm.edges.get((vert, across)) is None:
            bm.edges.new((vert, across))
    made = len(bm.edges) - before
    bm.to_mesh(mesh)
    bm.free()
    return made


def convex_parts(mesh: bpy.types.Mesh, most: int = 12) -> list[np.ndarray]:
    """Points (N,3) of convex hulls that together approximate ``mesh``; at most ``most`` of them.

    Cuts the part with the largest hull by the axis-parallel plane that leaves the least volume in
    the two hulls, until all hulls together have at most LOOSE times the solid's volume. A cut that
    gains nothing is made too: for a torus only the cuts after it gain. One hull for a sheet.
    """
    whole = bmesh.new()
    whole.from_mesh(mesh)
    # A loose vertex would count for the hull, but not for the solid.
    bmesh.ops.delete(whole, geom=[v for v in whole.verts if not v.link_faces], context="VERTS")
    solid = abs(whole.calc_volume())
    parts, volumes = [whole], [_hull_volume(whole)]
    # The part with the largest hull first: it has the most to gain.
    while len(parts) < most and sum(volumes) > LOOSE * solid > 0:
        index = int(np.argmax(volumes))
        cut = _best_cut(parts[index])
        if cut is None:
            break
        halves = [_half(parts[index], *cut, side) for side in (False, True)]
        parts[index].free()
        parts[index : index + 1] = halves
        volumes[index : index + 1] = map(_hull_volume, halves)
    points = [np.array([v.co[:] for v in part.verts], np.float64) for part in parts]
    for part in parts:
        part.free()
    return points


def hull_mesh(
    name: str, points: np.ndarray, corners: int = 0
) -> tuple[bpy.types.Mesh, np.ndarray, float]:
    """The convex hull of ``points`` as a new mesh, its centre of mass (3,) and its volume.

    ``corners``: of the hull, at most; 0: as many as it has.
    """
    bm = bmesh.new()
    for point in points:
        bm.verts.new(point)
    _to_hull(bm)
    if 0 < corners < len(bm.verts):
        few = outermost(np.array([v.co[:] for v in bm.verts]), corners)
        bm.clear()
        for point in few:
            bm.verts.new(point)
        _to_hull(bm)
    bmesh.ops.triangulate(bm, faces=bm.faces[:])
    corners = np.array([[v.co[:] for v in face.verts] for face in bm.faces]).reshape(-1, 3, 3)
    mesh = bpy.data.meshes.new(name)
    bm.to_mesh(mesh)
    bm.free()
    middle = points.mean(0)
    a, b, c = (corners[:, i] - middle for i in range(3))
    # Six times the signed volume of the tetrahedra to the middle, over 6 (Gauss).
    sixth = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    volume = abs(float(sixth.sum()))
    # The division below would fail.
    if volume < 1e-12:  # a sheet
        return mesh, middle, 0.0
    center = middle + ((a + b + c) * sixth[:, None]).sum(0) / 4 / sixth.sum()
    return mesh, center, volume


def outermost(points: np.ndarray, count: int) -> np.ndarray:
    """The points that are outermost along the axes and in directions spread over a ball
    (Fibonacci's); ``count`` at most."""
    spread = np.arange(count - 6)
    turn, z = spread * math.pi * (3 - math.sqrt(5)), 1 - (2 * spread + 1) / len(spread)
    ring = np.sqrt(1 - z * z)
    ball = np.stack([ring * np.cos(turn), ring * np.sin(turn), z])
    ways = np.concatenate([ball, np.eye(3), -np.eye(3)], 1)
    box = np.maximum(np.ptp(points, axis=0), 1e-12)  # or all would see the ends of what is long
    return points[np.unique((points / box @ ways).argmax(0))]


def _weld(mesh: bpy.types.Mesh) -> None:
    points = verts_of(mesh)
    size = float(np.ptp(points, axis=0).max()) if len(points) else 0.0
    bm = bmesh.new()
    bm.from_mesh(mesh)
    bmesh.ops.remove_doubles(bm, verts=bm.verts[:], dist=WELD * size)
    bmesh.ops.delete(bm, geom=[v for v in bm.verts if not v.link_faces], context="VERTS")
    bm.to_mesh(mesh)
    bm.free()


def _best_cut(part: bmesh.types.BMesh) -> tuple[Vector, Vector] | None:
    """A plane's point and its normal; None for a part too simple to cut."""
    points = np.array([v.co[:] for v in part.verts])
    # Fewer than the corners of a box.
    if len(points) < 8:
        return None
    low, high = points.min(0), points.max(0)
    best, least = None, math.inf
    for axis in range(3):
        normal = Vector([float(i == axis) for i in range(3)])
        # Planes in the interior: one at the border cuts nothing.
        for fraction in np.linspace(0, 1, PLANES + 2)[1:-1]:
            at = Vector(low + fraction * (high - low))
            halves = [_half(part, at, normal, side) for side in (False, True)]
            volume = sum(_hull_volume(half) for half in halves)
            empty = any(len(half.verts) < 4 for half in halves)
            for half in halves:
                half.free()
            if not empty and volume < least:
                best, least = (at, normal), volume
    return best


def _half(part: bmesh.types.BMesh, at: Vector, normal: Vector, above: bool) -> bmesh.types.BMesh:
    half = part.copy()
    geometry = [*half.verts, *half.edges, *half.faces]
    bmesh.ops.bisect_plane(
        half, geom=geometry, plane_co=at, plane_no=normal, clear_outer=not above, clear_inner=above
    )
    return half


def _hull_volume(part: bmesh.types.BMesh) -> float:
    hull = bmesh.new()
    for vert in part.verts:
        hull.verts.new(vert.co)
    if len(hull.verts) < 4:
        hull.free()
        return 0.0
    _to_hull(hull)
    volume = abs(hull.calc_volume())
    hull.free()
    return volume


def _to_hull(bm: bmesh.types.BMesh) -> None:
    """Replace ``bm`` by its convex hull, with normals outward."""
    made = bmesh.ops.convex_hull(bm, input=bm.verts[:], use_existing_faces=False)
    inside = {v for v in made["geom_interior"] + made["geom_unused"] if v.is_valid}
    bmesh.ops.delete(bm, geom=[v for v in inside if isinstance(v, bmesh.types.BMVert)])
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces[:])
