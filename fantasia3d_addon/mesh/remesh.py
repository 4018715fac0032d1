"""Levels of detail that keep the UVs, and quad meshes with the maps baked onto new UVs."""

from __future__ import annotations

import math
import tempfile
from pathlib import Path

import bpy

from .. import options
from ..asset.material_nodes import build_material
from ..background.thread import ReportProgress, ignore_progress
from ..blender.mesh_arrays import apply_modifiers, baked_mesh, mesh_object
from ..blender.names import data_name
from ..errors import AddonError
from ..material.edit import principled
from . import health, maps
from .quads import to_quads

QUADS_FRACTION = 0.3  # of the time; the bake of the maps is the rest
EDGE = math.radians(60.0)  # between two faces, whose shading is then apart
MIN_FACES = 50  # below it nothing keeps its shape
REACH = 0.02  # of the object's size, at least: how far from the quads the surface is looked for
FARTHER = 1.2  # times the greatest distance between the two


def make_lods(
    obj: bpy.types.Object, levels: int = 3, ratio: float = 0.5, max_faces: int = 0
) -> list[bpy.types.Object]:
    """``levels`` objects, each with ``ratio`` of the faces of the one before, the UVs kept.

    With ``max_faces`` it is one of at most so many triangles instead.

    They share the material and the place of ``obj``, and are hidden in a collection of their own:
    "NAME LODs" with "NAME LOD1" and so on.

    Raises:
        AddonError: a number is out of range, or the object is no mesh.
    """
    mesh_object(obj)
    if not (options.LEVELS.allows(levels) and options.RATIO.allows(ratio)):
        raise AddonError(
            f"{levels} levels with a ratio of {ratio:g} can't be made.",
            f"Use {options.LEVELS.range} levels, and a ratio of {options.RATIO.range}.",
        )
    # Of the original each time: decimating a decimated mesh adds up its errors.
    fractions = [ratio**level for level in range(1, levels + 1)]
    if max_faces:
        fractions = [_fraction(obj, max_faces)]
    collection = bpy.data.collections.new(data_name(obj.name, " LODs"))
    bpy.context.scene.collection.children.link(collection)
    made = []
    for level, fraction in enumerate(fractions, 1):
        lod = _decimated(obj, data_name(obj.name, f" LOD{level}"), fraction, collection)
        if max_faces and len(lod.data.polygons) > max_faces:  # the modifier rounds up
            fewer = fraction * max_faces / len(lod.data.polygons) * 0.99
            mesh = lod.data
            bpy.data.objects.remove(lod)
            bpy.data.meshes.remove(mesh)
            lod = _decimated(obj, data_name(obj.name, f" LOD{level}"), fewer, collection)
        if max_faces and (count := len(lod.data.polygons)) > max_faces:
            bpy.data.batch_remove([lod.data, lod, collection])
            raise AddonError(
                f"{max_faces} faces can't be made of {obj.name}: {count} are left.",
                "Use more faces, or remove small components under Mesh Health.",
            )
        _shade_apart(lod)
        hide(lod)
        made.append(lod)
    return made


def _fraction(obj: bpy.types.Object, max_faces: int) -> float:
    """The fraction of the triangles of ``obj``, with its modifiers, that ``max_faces`` are."""
    mesh = baked_mesh(obj)
    mesh.calc_loop_triangles()
    present = len(mesh.loop_triangles)
    bpy.data.meshes.remove(mesh)
    if not MIN_FACES <= max_faces < present:
        raise AddonError(
            f"{max_faces} faces can't be made of {obj.name}, which has {present} triangles.",
            f"Use {MIN_FACES} or more, and fewer than it has.",
        )
    return max_faces / present


def _decimated(
    obj: bpy.types.Object, name: str, fraction: float, collection: bpy.types.Collection
) -> bpy.types.Object:
    """A copy of ``obj`` as it looks with that fraction of its triangles, the UVs kept."""
    lod = bpy.data.objects.new(name, baked_mesh(obj))
    lod.data.name = name
    lod.matrix_world = obj.matrix_world
    collection.objects.link(lod)
    # So that the fraction is one of triangles.
    if any(len(polygon.vertices) > 3 for polygon in lod.data.polygons):
        lod.modifiers.new("triangles", "TRIANGULATE")
    fewer = lod.modifiers.new("fewer", "DECIMATE")
    fewer.ratio, fewer.use_collapse_triangulate = fraction, True
    bpy.context.view_layer.update()
    apply_modifiers(lod)
    for slot, own in zip(lod.material_slots, obj.material_slots, strict=False):
        if own.link == "OBJECT":  # shown instead of the mesh's own
            slot.link, slot.material = "OBJECT", own.material
    return lod


def _shade_apart(lod: bpy.types.Object) -> None:
    """Normals of the large faces, apart at edges.

    A mean of all faces about a corner would tilt the shading of a whole side, and the maps, which
    are those of the fine mesh, level only the narrow faces along its edges.
    """
    lod.data.set_sharp_from_angle(angle=EDGE)
    weighted = lod.modifiers.new("large faces", "WEIGHTED_NORMAL")
    weighted.mode, weighted.keep_sharp = "FACE_AREA", True
    bpy.context.view_layer.update()
    apply_modifiers(lod)


def quad_remesh(
    obj: bpy.types.Object,
    faces: int = 4000,
    size: int = 0,
    progress: ReportProgress = ignore_progress,
) -> bpy.types.Object:
    """A new object that looks like ``obj``, of ``faces`` quads or fewer, with UVs and maps.

    ``size``: texels along a side; 0 is that of the present maps. ``obj`` is kept, hidden.
    ``progress`` is called for the quads and for each map, which take seconds.

    Raises:
        AddonError: the mesh is not closed and manifold, or the remesher found none.
    """
    mesh_object(obj)
    quads = bpy.data.objects.new(data_name(obj.name, " quads"), baked_mesh(obj))
    quads.data.name = quads.name
    place_like(quads, obj)
    try:
        _check(quads, obj.name)
        progress("Quads", 0.0)
        reach = max(REACH, FARTHER * to_quads(quads, faces))
        quads.data.set_sharp_from_angle(angle=EDGE)
        health.unwrap(quads)
        _bake_material(obj, quads, size, reach, progress)
    except BaseException:
        mesh = quads.data
        bpy.data.objects.remove(quads)
        bpy.data.meshes.remove(mesh)
        raise
    hide(obj)
    return quads


def _check(quads: bpy.types.Object, name: str) -> None:
    report = health.examine(quads)
    if not (report.closed and report.manifold):
        raise AddonError(
            f"The mesh of {name} is not closed and manifold: it has {report.open_edges} open "
            f"and {report.nonmanifold} non-manifold edges or vertices.",
            "Press Repair All under Mesh Health first.",
        )


def place_like(quads: bpy.types.Object, obj: bpy.types.Object) -> None:
    """Link ``quads`` to the collections of ``obj``, at the same place."""
    for collection in obj.users_collection:
        collection.objects.link(quads)
    quads.matrix_world = obj.matrix_world
    bpy.context.view_layer.update()


def hide(obj: bpy.types.Object) -> None:
    """Hide ``obj`` in the viewport and in renders."""
    obj.hide_set(True)
    obj.hide_render = True


def _bake_material(
    source: bpy.types.Object,
    target: bpy.types.Object,
    size: int,
    reach: float,
    progress: ReportProgress,
) -> None:
    """Bake the maps of ``source`` into a new material of ``target``, packed."""
    own = [principled(slot.material) for slot in source.material_slots]
    if not own or None in own:
        raise AddonError(
            f"{source.name} has a material without a Principled BSDF.", "Use one that has it."
        )
    if not size:
        size = max((max(w, h) for _, w, h in health.textures_of(source)), default=1024)

    def report(channel: str, fraction: float) -> None:
        title = channel.replace("_", " ").capitalize()
        progress(title, QUADS_FRACTION + (1 - QUADS_FRACTION) * fraction)

    found = maps.bake_maps(source, target, size, reach, report)
    material = bpy.data.materials.new(target.name)
    with tempfile.TemporaryDirectory() as folder:
        paths = maps.save_images(found, Path(folder), "quads")
        images = maps.load_images(paths, pack=True)
    for role, image in images.items():
        image.name = data_name(target.name, f" {role.replace('_', ' ')}")
    uv_map = target.data.uv_layers.active.name
    build_material(material, images, own[0].distribution, uv_map, found.light)
    target.data.materials.clear()
    target.data.materials.append(material)
