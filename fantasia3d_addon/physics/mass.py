"""The mass of an object: its volume times its density."""

from __future__ import annotations

import bmesh
import bpy

from ..asset.origin import density_of

WOOD = 400.0  # kg/m³: light wood, of what has no density of its own


def mass_of(obj: bpy.types.Object, hulls: float) -> float:
    """Kilograms. ``hulls`` is the volume of its convex parts in m³, for a mesh that is open."""
    return density_of(obj, WOOD) * (volume_of(obj) or hulls)


def volume_of(obj: bpy.types.Object) -> float:
    """M³ in the world, of the mesh with its modifiers; 0 where it is not closed."""
    bm = bmesh.new()
    try:
        bm.from_object(obj, bpy.context.evaluated_depsgraph_get())
        bm.transform(obj.matrix_world)
        is_closed = bool(bm.edges) and all(edge.is_manifold for edge in bm.edges)
        return abs(bm.calc_volume()) if is_closed else 0.0
    finally:
        bm.free()
