"""Exports an object as one file for other programs: GLB, USD, FBX or OBJ, with its textures.

Each exporter supports other parts of a material. What is exported is therefore a copy with the
simplest material: one picture for each socket, with the tint, the scales and everything procedural
baked into it, from files on the disk.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path

import bpy
import numpy as np

from ..asset.asset_folder import OPTIONAL, Light
from ..asset.material_nodes import build_material, connect_light
from ..asset.origin import copy_origin
from ..blender import compat
from ..blender.mesh_arrays import (
    acting,
    baked_mesh,
    evaluated_object,
    mesh_object,
    use_uv_map,
    values,
)
from ..blender.output import temporary_output
from ..environment.files import expanded
from ..errors import OutputError
from ..material.edit import principled
from . import maps

ENDINGS = {".glb": "GLB", ".usd": "USD", ".usdc": "USD", ".usda": "USD", ".usdz": "USD",
           ".fbx": "FBX", ".obj": "OBJ"}  # fmt: skip


def export_object(
    obj: bpy.types.Object, path: Path, flip_normal_y: bool = False, size: int = 0
) -> Path:
    """Export ``obj`` with its modifiers applied to ``path``, whose extension sets the format.

    GLB, FBX and .usdz contain their pictures; OBJ has them in the folder ``NAME_textures``, USD in
    ``textures``, by paths relative to the file. ``flip_normal_y`` writes the normal map for
    DirectX; glTF and USD allow OpenGL's alone. ``size``: texels of maps that must be baked; 0 is
    the size of its pictures.

    Raises:
        AddonError: the object has no faces, UVs or material to export.
        OutputError: the extension is unknown, or this Blender can't write the format or the place.
    """
    path = expanded(path, OutputError).absolute()
    check_format(path, flip_normal_y)
    mesh_object(obj)
    kind = ENDINGS[path.suffix.lower()]
    with temporary_output(path) as temporary:
        textures = temporary.with_name(f"{path.stem}_textures")
        textures.mkdir()
        found = maps.maps_of(obj, size)
        split = kind != "GLB"
        paths = maps.save_images(found, textures, path.stem, flip_normal_y, split=split)
        with plain_copy(obj, paths, found.light) as copy:
            _write(copy, temporary, kind)
        if kind != "OBJ":  # the others hold their pictures, or have written them again
            shutil.rmtree(textures)
    return path


def check_format(path: Path, flip_normal_y: bool) -> None:
    """Raise OutputError for a format that this Blender does not write."""
    kind = ENDINGS.get(path.suffix.lower())
    if kind is None:
        raise OutputError(f"{path} has no known format.", f"Its name ends in {', '.join(ENDINGS)}.")
    if kind == "USD" and not compat.has_usd():
        raise OutputError("This Blender writes no USD.", "Export GLB, or use blender.org's build.")
    if kind == "FBX" and not compat.has_operator("export_scene", "fbx"):
        raise OutputError(
            "Blender's FBX add-on is disabled.", "Enable it: Preferences, Add-ons, FBX."
        )
    if kind == "GLB" and not compat.has_operator("export_scene", "gltf"):
        raise OutputError(
            "Blender's glTF add-on is disabled.", "Enable it: Preferences, Add-ons, glTF."
        )
    if flip_normal_y and kind in ("GLB", "USD"):
        raise OutputError(
            f"{path.suffix} allows OpenGL's normal maps alone.",
            "Leave the green channel as it is, or export FBX or OBJ.",
        )


@contextlib.contextmanager
def plain_copy(
    obj: bpy.types.Object, paths: Mapping[str, Path], light: Light
) -> Iterator[bpy.types.Object]:
    """A copy of ``obj`` with the same name, no modifiers, and the files ``paths`` as its maps."""
    own, uv_map = (obj, obj.data, obj.material_slots[0].material), maps.uv_map_of(obj)
    names = [datablock.name for datablock in own]
    distribution = principled(own[2]).distribution
    images = maps.load_images(paths, pack=False)
    material = bpy.data.materials.new("copy")
    _connect(material, images, uv_map, distribution, light)
    copy = bpy.data.objects.new("copy", baked_mesh(obj))
    copy_origin(obj, copy)
    mesh = copy.data
    mesh.materials.clear()
    mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", np.zeros(len(mesh.polygons), np.int32))
    bpy.context.scene.collection.objects.link(copy)
    with evaluated_object(obj) as evaluated:
        copy.matrix_world = evaluated.matrix_world
    try:
        _put_first(mesh, uv_map)
        # Exporters write the datablocks' names: the copy gets them for as long as it exists.
        for datablocks, titles in ((own, ["own"] * 3), ((copy, mesh, material), names)):
            for datablock, title in zip(datablocks, titles, strict=True):
                _rename(datablock, title)
        yield copy
    finally:
        bpy.data.batch_remove([copy, mesh, material, *images.values()])
        for datablock, title in zip(own, names, strict=True):
            _rename(datablock, title)


def _put_first(mesh: bpy.types.Mesh, uv_map: str) -> None:
    """Move the UV maps before ``uv_map`` behind it: programs show the pictures over the first."""
    use_uv_map(mesh, uv_map)
    while mesh.uv_layers[0].name != uv_map:
        first = mesh.uv_layers[0]
        name, uv = first.name, values(first.uv, "vector", 2)
        mesh.uv_layers.remove(first)
        mesh.uv_layers.new(name=name, do_init=False).uv.foreach_set("vector", uv.ravel())
    use_uv_map(mesh, uv_map)


def _rename(datablock: bpy.types.ID, name: str) -> None:
    if not datablock.library:  # names of another file are in nobody's way
        datablock.name = name


def _connect(
    material: bpy.types.Material,
    images: dict[str, bpy.types.Image],
    uv_map: str,
    distribution: str,
    light: Light,
) -> None:
    """One picture for each socket; ``orm`` by its channels, as in glTF."""
    if "orm" in images:
        # What Blender's exporter knows.
        build_material(material, images, distribution, uv_map, light)
        return
    tree = compat.empty_nodes(material)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    bsdf = tree.nodes.new("ShaderNodeBsdfPrincipled")
    bsdf.distribution = distribution
    tree.links.new(bsdf.outputs["BSDF"], output.inputs["Surface"])
    uv = tree.nodes.new("ShaderNodeUVMap")
    uv.uv_map = uv_map
    pictures = {}
    for role, image in images.items():
        pictures[role] = picture = tree.nodes.new("ShaderNodeTexImage")
        picture.image = image
        tree.links.new(uv.outputs["UV"], picture.inputs["Vector"])
        if role == "normal":
            bump = tree.nodes.new("ShaderNodeNormalMap")
            bump.uv_map = uv_map
            tree.links.new(picture.outputs["Color"], bump.inputs["Color"])
            tree.links.new(bump.outputs["Normal"], bsdf.inputs["Normal"])
        elif role not in OPTIONAL:
            tree.links.new(picture.outputs["Color"], bsdf.inputs[maps.SOCKETS[role]])
    connect_light(material, bsdf, pictures, light)


def _write(obj: bpy.types.Object, path: Path, kind: str) -> None:
    with acting(obj):
        _OPERATORS[kind](str(path))


def write_glb(path: str) -> None:
    """The selected objects as one GLB."""
    bpy.ops.export_scene.gltf(
        filepath=path, export_format="GLB", use_selection=True, export_tangents=True,
        export_animations=False, export_morph=False, export_skins=False, export_extras=True,
    )  # fmt: skip


def _usd(path: str) -> None:
    here = Path.cwd()
    try:
        bpy.ops.wm.usd_export(
            filepath=path, selected_objects_only=True, export_animation=False, relative_paths=True,
            convert_orientation=False, generate_preview_surface=True, evaluation_mode="RENDER",
            **compat.usd_textures(),
        )  # fmt: skip
    finally:
        os.chdir(here)  # Blender 4.5's USDZ leaves the process in another folder


def _fbx(path: str) -> None:
    bpy.ops.export_scene.fbx(
        filepath=path, use_selection=True, object_types={"MESH"}, path_mode="COPY",
        embed_textures=True, mesh_smooth_type="FACE", bake_anim=False,
    )  # fmt: skip


def _obj(path: str) -> None:
    bpy.ops.wm.obj_export(
        filepath=path, export_selected_objects=True, export_pbr_extensions=True,
        path_mode="RELATIVE", export_animation=False,
    )  # fmt: skip
    # Blender calls a normal map map_Bump, for other programs a map of heights; theirs is norm.
    material = Path(path).with_suffix(".mtl")
    text = material.read_text(encoding="utf-8")
    normals = re.sub(r"^map_Bump (?:-bm \S+ )?(.*)$", r"\g<0>\nnorm \1", text, flags=re.MULTILINE)
    material.write_text(normals, encoding="utf-8")


_OPERATORS = {"GLB": write_glb, "USD": _usd, "FBX": _fbx, "OBJ": _obj}
