"""A part of an object whose maps a job changes: its faces, the asset that is kept, the new maps."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

from ..asset.asset_folder import ROLES, VERSION, AssetFolder
from ..asset.export_shape import asset_obj_text
from ..asset.import_asset import load_images
from ..asset.material_nodes import add_pictures, connect_light
from ..asset.origin import origin_of, set_origin
from ..blender.mesh_arrays import reason_against_mesh, triangles, values
from ..environment.files import write_text
from ..errors import AddonError
from ..material.edit import image_of, keep_materials, principled, show_in_slot

IN_GROUP = 0.5  # a vertex of this weight or more belongs to the part
INPUTS = {  # of the Principled, by role
    "base_color": "Base Color",
    "orm": "Roughness",
    "normal": "Normal",
    "emission": "Emission Color",
    "transmission": "Transmission Weight",
}
FILES = {
    "mesh.obj": {"role": "mesh"},
    "base_color.png": {"role": "base_color", "color_space": "sRGB"},
    "orm.png": {"role": "orm", "color_space": "Non-Color"},
    "normal.png": {"role": "normal", "color_space": "Non-Color", "convention": "OpenGL"},
    "emission.png": {"role": "emission", "color_space": "sRGB"},
    "transmission.png": {"role": "transmission", "color_space": "Non-Color"},
}


@dataclass(frozen=True)
class Look:
    """The baked maps that an object shows."""

    slot: int  # of the object's materials
    images: Mapping[str, bpy.types.Image]  # by role
    uv_map: str


def look_of(obj: bpy.types.Object) -> Look | None:
    """The maps of the first of its materials that has them; None where none has."""
    for number, slot in enumerate(obj.material_slots):
        bsdf = principled(slot.material)
        found = {role: image_of(bsdf.inputs[name]) for role, name in INPUTS.items()} if bsdf else {}
        images = {role: pair[0] for role, pair in found.items() if pair}
        if bsdf and images.keys() >= set(ROLES):
            uv_map = getattr(bsdf.inputs["Normal"].links[0].from_node, "uv_map", "")
            return Look(number, images, uv_map)
    return None


def reason_against(obj: bpy.types.Object | None) -> str:
    """Why no part of ``obj`` can be edited; empty if one can."""
    reason = reason_against_mesh(obj)
    if obj is None or reason:
        return reason
    if obj.mode not in ("OBJECT", "EDIT"):
        return "Use it in Object Mode or in Edit Mode."
    if obj.library or obj.data.library:
        return f"“{obj.name}” is linked from another file. Make it local first."
    look = look_of(obj)
    if look is None:
        return "It does not show the baked maps of an asset."
    if look.uv_map not in obj.data.uv_layers:
        return "The UV map of its maps was removed."
    sizes = {tuple(image.size) for image in look.images.values()}
    if len(sizes) > 1 or any(width != height or not width for width, height in sizes):
        return "Its maps are not square, or not of one size."
    return ""


def reason_against_part(obj: bpy.types.Object, group: str = "") -> str:
    """Why no faces of ``obj`` are chosen; empty if some are. ``group``: see :func:`faces_of`."""
    if obj.mode == "EDIT":
        return "" if obj.data.total_face_sel else "Select the faces to edit."
    if group and group not in obj.vertex_groups:
        return f"“{obj.name}” has no vertex group “{group}”."
    return "" if obj.vertex_groups else "Select faces in Edit Mode, or add a vertex group."


def faces_of(obj: bpy.types.Object, group: str = "") -> np.ndarray:
    """The numbers of the chosen faces among the triangles of the mesh.

    In Edit Mode the selected ones, which must be in the mesh already (``update_from_editmode``);
    else those whose vertices are all in the vertex group ``group``, or in the active one.

    Raises:
        AddonError: none is chosen.
    """
    mesh = obj.data
    if obj.mode == "EDIT":
        chosen = values(mesh.polygons, "select", 1, bool)[:, 0]
        fix = "Select the faces to edit."
    else:
        chosen = _in_group(obj, group)
        fix = "Assign the faces' vertices to the vertex group."
    verts, _ = triangles(mesh)
    polygons = values(mesh.loop_triangles, "polygon_index", 1, np.int32)[:, 0]
    faces = np.arange(len(verts))[chosen[polygons]]
    if not len(faces):
        raise AddonError("No faces are chosen.", fix)
    return faces


def _in_group(obj: bpy.types.Object, name: str) -> np.ndarray:
    """For each polygon whether all its vertices are in the vertex group."""
    group = obj.vertex_groups.get(name) if name else obj.vertex_groups.active
    if group is None:
        raise AddonError("There is no such vertex group.", "Choose one, or select faces.")
    mesh, index = obj.data, group.index
    inside = np.array(
        [any(g.group == index and g.weight >= IN_GROUP for g in v.groups) for v in mesh.vertices]
    )
    starts = values(mesh.polygons, "loop_start", 1, np.int32)[:, 0]
    corners = inside[values(mesh.loops, "vertex_index", 1, np.int32)[:, 0]]
    return np.logical_and.reduceat(corners, starts)


def write_kept(obj: bpy.types.Object, folder: Path) -> dict[str, Path]:
    """Write what ``obj`` shows as an asset into ``folder``; its files by name.

    The maps are the files that were imported, byte for byte, unless they were painted on since.
    """
    look = look_of(obj)
    assert look is not None  # reason_against was asked
    folder.mkdir(parents=True, exist_ok=True)
    shown = {"mesh", *look.images}
    files = {name: entry for name, entry in FILES.items() if entry["role"] in shown}
    paths = {name: folder / name for name in files}
    for role, image in look.images.items():
        paths[f"{role}.png"].write_bytes(_png(image))
    mesh = obj.data.copy()  # in Edit Mode the mesh itself hides its UVs
    try:
        verts, faces = _write_mesh(mesh, look.uv_map, paths["mesh.obj"])
    finally:
        bpy.data.meshes.remove(mesh)
    origin = origin_of(obj) or origin_of(obj.material_slots[look.slot].material)
    info = {"version": VERSION, "files": files, "mesh": {"verts": verts, "faces": faces}}
    write_text(folder / "asset.json", json.dumps(info | {"prompt": origin.get("prompt", "")}))
    return paths | {"asset.json": folder / "asset.json"}


def _write_mesh(mesh: bpy.types.Mesh, uv_map: str, path: Path) -> tuple[int, int]:
    """The triangles of ``mesh`` in its own space, their UVs welded; how many verts and faces."""
    faces, corners = triangles(mesh)
    uv = values(mesh.uv_layers[uv_map].uv, "vector", 2)
    # Of each vertex the equal ones are one: the islands are what they were.
    keys = np.concatenate([faces.reshape(-1, 1), uv[corners.reshape(-1)]], 1, dtype=np.float64)
    unique, index = np.unique(keys, axis=0, return_inverse=True)
    face_uvs = index.reshape(faces.shape)
    write_text(path, asset_obj_text(mesh, unique[:, 1:], faces, face_uvs))
    return len(mesh.vertices), len(faces)


def _png(image: bpy.types.Image) -> bytes:
    if image.is_dirty:  # painted on: what is seen counts
        image.pack()
    if image.packed_file:
        return bytes(image.packed_file.data)
    path = Path(bpy.path.abspath(image.filepath))
    try:
        return path.read_bytes()
    except OSError:
        raise AddonError(
            f"The map “{image.name}” has no file.", "Restore the file, or import the asset again."
        ) from None


def show_maps(obj: bpy.types.Object, asset: AssetFolder, name: str) -> bpy.types.Material:
    """Show the maps of ``asset`` instead of those of ``obj``, in a copy of its material.

    The rest of the material stays, adjustments too; :func:`edit.restore_material` shows the maps
    from before the first edit again.

    Raises:
        AddonError: it shows other materials now, or the asset is broken.
    """
    reason = reason_against(obj)
    if reason:
        raise AddonError(reason, "Undo that change, then import the job's asset from the history.")
    look = look_of(obj)
    assert look is not None
    images = load_images(asset, name)
    old = obj.material_slots[look.slot].material
    material = old.copy()
    set_origin(material, asset.info)
    new = {image: images.get(role) for role, image in look.images.items()}
    for node in list(material.node_tree.nodes):
        if node.type == "TEX_IMAGE" and node.image in new:
            if new[node.image]:
                node.image = new[node.image]
            else:
                material.node_tree.nodes.remove(node)
    bsdf = principled(material)
    if "emission" in look.images and "emission" not in images:
        bsdf.inputs["Emission Strength"].default_value = 0
    added = {role: image for role, image in images.items() if role not in look.images}
    if added:
        nodes = add_pictures(material.node_tree, added, look.uv_map)
        connect_light(material, bsdf, nodes, asset.light)
    keep_materials(obj)
    show_in_slot(obj, obj.material_slots[look.slot], material)
    return material
