"""An asset as a game engine's importer expects it: axes, scale, names, channels, LODs, colliders.

Godot 4: GLB; objects "-convcolonly" become convex collision shapes; it makes LODs by itself.
Unity: FBX in metres; "_LOD0", "_LOD1" make a LOD group; the mask map is R metallic, G occlusion,
A smoothness. It knows no colliders by name: each "_Collider" takes a convex Mesh Collider.
Unreal: FBX in centimetres, the front along +X; a node of type LodGroup holds the LODs; "UCX_" and
the mesh's name make a collider; R occlusion, G roughness, B metallic; normal maps of DirectX.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix

from ..blender.mesh_arrays import acting, mesh_object
from ..blender.output import temporary_output
from ..blender.png import to_bytes, write_png
from ..environment.files import expanded
from ..errors import OutputError
from . import export, maps, proxy, remesh

LODS = 3  # beyond the full mesh, each with half of the faces
CAGE_FACES = 600  # of the mesh that is cut into colliders
CORNERS = 128  # of a collider: 252 triangles; Unity takes 255


@dataclass(frozen=True)
class Engine:
    """The format that an engine's importer expects."""

    kind: str  # of export.py
    collider: str  # name of a collider: {name} of the mesh, {i} its number
    mesh: str = "{name}"
    turn: float = 0.0  # about Z, radians, to the engine's forward
    lods: int = LODS
    scale: str = ""  # the FBX exporter's: FBX_SCALE_ALL metres, FBX_SCALE_NONE centimetres


ENGINES = {
    "godot": Engine("GLB", "{name}_{i:02}-convcolonly", lods=0),
    "unity": Engine("FBX", "{name}_Collider_{i:02}", "{name}_LOD0", scale="FBX_SCALE_ALL"),
    "unreal": Engine(
        "FBX", "UCX_{name}_LOD0_{i:02}", "{name}_LOD0", math.pi / 2, scale="FBX_SCALE_NONE"
    ),
}


def export_for(obj: bpy.types.Object, folder: Path, engine: str, size: int = 0) -> Path:
    """Write ``obj`` into ``folder`` for ``engine``: NAME.glb or NAME.fbx, with its pictures.

    It is at the origin, its rotation and scale applied. ``size``: as of ``export_object``.

    Raises:
        AddonError: as ``export_object``.
    """
    if engine not in ENGINES:
        raise OutputError(f"There is no engine {engine!r}.", f"Use one of {', '.join(ENGINES)}.")
    preset = ENGINES[engine]
    name = plain_name(mesh_object(obj).name)
    path = expanded(folder, OutputError).absolute() / f"{name}.{preset.kind.lower()}"
    export.check_format(path, False)
    with temporary_output(path) as temporary:
        found = maps.maps_of(obj, size)
        paths = _pictures(found, temporary.parent, name, engine)
        copied = export.plain_copy(obj, paths, found.light)
        with copied as copy, _models(copy, name, preset) as models:
            _write(models, temporary, preset)
        if preset.kind == "GLB":  # which holds them
            for picture in paths.values():
                picture.unlink()
    return path


def plain_name(title: str) -> str:
    """``title`` in letters that file systems and engines take: a_red_wooden_chair."""
    words = "".join(c if c.isascii() and c.isalnum() else " " for c in title).split()
    return "_".join(words)[:48] or "asset"


def _pictures(found: maps.Maps, folder: Path, name: str, engine: str) -> dict[str, Path]:
    """Written under the engine's names; those that its importer connects by itself."""
    if engine == "godot":
        return maps.save_images(found, folder, name)
    flip = (1, -1, 1) if engine == "unreal" else (1, 1, 1)  # DirectX: 1 - y
    normal = found.normal * flip + ((0, 1, 0) if engine == "unreal" else 0)
    if engine == "unreal":
        names = {"base_color": f"T_{name}_BC", "normal": f"T_{name}_N", "packed": f"T_{name}_ORM"}
        packed = found.orm
    else:
        names = {"base_color": "BaseMap", "normal": "Normal", "packed": "MaskMap"}
        names = {role: f"{name}_{word}" for role, word in names.items()}
        one, zero = np.ones_like(found.metallic), np.zeros_like(found.metallic)
        packed = np.stack([found.metallic, one, zero, 1 - found.roughness], -1)
    paths = {role: folder / f"{word}.png" for role, word in names.items()}
    write_png(paths["base_color"], to_bytes(found.base_color))
    write_png(paths["normal"], to_bytes(normal, 16))
    write_png(paths.pop("packed"), to_bytes(packed))
    optional = {"emission": found.emission, "transmission": found.transmission}
    for role, values in optional.items():
        if values is not None:
            word = f"T_{name}_{role[0].upper()}" if engine == "unreal" else f"{name}_{role.title()}"
            paths[role] = folder / f"{word}.png"
            write_png(paths[role], to_bytes(np.atleast_3d(values) * np.ones(3)))
    return paths


@contextlib.contextmanager
def _models(copy: bpy.types.Object, name: str, preset: Engine) -> Iterator[list[bpy.types.Object]]:
    """The mesh, its LODs and its colliders, at the origin; removed again."""
    place = Matrix.Rotation(preset.turn, 4, "Z") @ copy.matrix_world
    place.translation = (0, 0, 0)
    copy.data.transform(place)
    if place.determinant() < 0:
        copy.data.flip_normals()
    copy.matrix_world = Matrix.Identity(4)
    copy.name = copy.data.name = preset.mesh.format(name=name)
    copy.active_material.name = name
    bpy.context.view_layer.update()
    made: list[bpy.types.ID] = []
    try:
        lods = _lods(copy, name, preset, made)
        hulls = _colliders(copy, name, preset, made)
        yield [copy, *lods, *hulls]
    finally:
        bpy.data.batch_remove([x.data for x in made if getattr(x, "type", "") == "MESH"] + made)


def _lods(
    copy: bpy.types.Object, name: str, preset: Engine, made: list[bpy.types.ID]
) -> list[bpy.types.Object]:
    if not preset.lods:
        return []
    lods = remesh.make_lods(copy, preset.lods)
    made += [*lods, lods[0].users_collection[0]]
    for level, lod in enumerate(lods, 1):
        lod.name = lod.data.name = f"{name}_LOD{level}"
        lod.hide_set(False)
    if preset.scale != "FBX_SCALE_NONE":  # Unity groups them by their names
        return lods
    group = bpy.data.objects.new(name, None)
    group["fbx_type"] = "LodGroup"  # Blender's exporter writes it as the node's type
    bpy.context.scene.collection.objects.link(group)
    made.append(group)
    for each in (copy, *lods):
        each.parent = group
    return [group, *lods]


def _colliders(
    copy: bpy.types.Object, name: str, preset: Engine, made: list[bpy.types.ID]
) -> list[bpy.types.Object]:
    cage = proxy.cage(copy, CAGE_FACES)
    parts = proxy.convex_parts(cage)
    bpy.data.meshes.remove(cage)
    hulls = []
    for i, points in enumerate(parts):
        title = preset.collider.format(name=name, i=i)
        hull = bpy.data.objects.new(title, proxy.hull_mesh(title, points, CORNERS)[0])
        bpy.context.scene.collection.objects.link(hull)
        made.append(hull)
        hulls.append(hull)
    bpy.context.view_layer.update()
    return hulls


def _write(models: list[bpy.types.Object], path: Path, preset: Engine) -> None:
    with acting(models[0]), bpy.context.temp_override(selected_objects=models):
        for model in models:
            model.select_set(True)
        if preset.kind == "GLB":
            export.write_glb(str(path))
            return
        bpy.ops.export_scene.fbx(
            filepath=str(path), use_selection=True, object_types={"MESH", "EMPTY"},
            path_mode="STRIP", mesh_smooth_type="FACE", use_tspace=True, bake_anim=False,
            use_custom_props=False, apply_unit_scale=True, apply_scale_options=preset.scale,
            bake_space_transform=True,
        )  # fmt: skip
