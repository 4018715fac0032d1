"""Imports an asset folder into the scene as one object."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import bpy
import numpy as np

from ..blender.names import data_name
from ..errors import AssetError
from .asset_folder import AssetFolder, Picture, read_asset
from .material_nodes import UV_MAP, build_material
from .origin import set_origin


def import_asset(
    where: bpy.types.Context | bpy.types.Scene | bpy.types.LayerCollection,
    folder: Path | AssetFolder,
    location: Sequence[float] = (0.0, 0.0, 0.0),
) -> bpy.types.Object:
    """The asset in ``folder`` as one object in the collection of ``where``, base at ``location``.

    ``folder`` may be an AssetFolder that was read already. The object is upright, its front to -Y,
    in metres; welded, smooth or flat as it was made, with a Principled material and packed maps.
    The user's selection and mode stay as they are. Where the collection is another file's, it goes
    into the scene's own.

    Raises:
        AssetError: the folder is not an asset, or not a complete one; the file is left unchanged.
    """
    asset = folder if isinstance(folder, AssetFolder) else read_asset(Path(folder))
    name = data_name(asset.prompt)
    made: list[bpy.types.ID] = []  # for the removal if a later step fails
    try:
        material = _make_material(asset, name, UV_MAP, made)
        mesh = bpy.data.meshes.new(name)
        made.append(mesh)
        _fill_mesh(mesh, asset)
        mesh.materials.append(material)
        obj = bpy.data.objects.new(name, mesh)
        made.append(obj)
        obj.location = location
        set_origin(obj, asset.info)
        scene = where.scene if isinstance(where, bpy.types.Context) else where.id_data
        own = where.collection
        (own if can_link(own) else scene.collection).objects.link(obj)
    except BaseException:
        bpy.data.batch_remove(made)
        raise
    return obj


def can_link(collection: bpy.types.Collection) -> bool:
    """Whether an object can be put into ``collection``: it is not linked from another file."""
    return collection.is_editable and not collection.override_library


def import_material(folder: Path | AssetFolder, uv_map: str) -> bpy.types.Material:
    """The material of the asset in ``folder`` alone, for a mesh that has ``uv_map``.

    Raises:
        AssetError: as :func:`import_asset`.
    """
    asset = folder if isinstance(folder, AssetFolder) else read_asset(Path(folder))
    made: list[bpy.types.ID] = []
    try:
        return _make_material(asset, data_name(asset.prompt), uv_map, made)
    except BaseException:
        bpy.data.batch_remove(made)
        raise


def load_images(folder: Path | AssetFolder, name: str) -> dict[str, bpy.types.Image]:
    """The maps of the asset in ``folder`` alone, packed, by role; ``name`` is before each role's.

    Raises:
        AssetError: as :func:`import_asset`.
    """
    asset = folder if isinstance(folder, AssetFolder) else read_asset(Path(folder))
    made: list[bpy.types.ID] = []
    try:
        return _load_images(asset, name, made)
    except BaseException:
        bpy.data.batch_remove(made)
        raise


def _make_material(
    asset: AssetFolder, name: str, uv_map: str, made: list[bpy.types.ID]
) -> bpy.types.Material:
    """The material with its pictures.

    Every new datablock is added to ``made`` at once, so that a failure can remove it.
    """
    images = _load_images(asset, asset.prompt, made)
    material = bpy.data.materials.new(name)
    made.append(material)
    build_material(material, images, asset.distribution, uv_map, asset.light)
    set_origin(material, asset.info)
    return material


def _fill_mesh(mesh: bpy.types.Mesh, asset: AssetFolder) -> None:
    faces = asset.faces
    mesh.vertices.add(len(asset.verts))
    mesh.vertices.foreach_set("co", asset.verts.ravel())
    mesh.loops.add(faces.size)
    mesh.loops.foreach_set("vertex_index", faces.ravel())
    mesh.polygons.add(len(faces))
    mesh.polygons.foreach_set("loop_start", np.arange(0, faces.size, 3, dtype=np.int32))
    uv = mesh.uv_layers.new(name=UV_MAP, do_init=False)
    uv.uv.foreach_set("vector", asset.corner_uv.ravel())
    mesh.update(calc_edges=True)
    # validate() repairs what would crash Blender; a mesh of ours has nothing to repair.
    if mesh.validate():
        raise AssetError(
            f"The mesh of {asset.path} has faces that repeat a vertex or another face.",
            "Generate it again.",
        )
    _mark_seams(mesh, asset.corner_uv.reshape(-1, 2))
    mesh.shade_flat() if asset.flat else mesh.shade_smooth()


def _load_images(
    asset: AssetFolder, name: str, made: list[bpy.types.ID]
) -> dict[str, bpy.types.Image]:
    return {
        role: _load_image(picture, data_name(name, f" {role.replace('_', ' ')}"), made)
        for role, picture in asset.pictures.items()
    }


def _mark_seams(mesh: bpy.types.Mesh, corner_uv: np.ndarray) -> None:
    """A seam on each edge whose faces are apart in the UV map: Unwrap then makes these islands."""
    count = len(mesh.loops)
    edge, vert = np.empty(count, np.int32), np.empty(count, np.int32)
    mesh.loops.foreach_get("edge_index", edge)
    mesh.loops.foreach_get("vertex_index", vert)
    following = np.arange(count).reshape(-1, 3)[:, [1, 2, 0]].ravel()
    # Both uv of a corner's edge, that of the lower vertex first: the faces run along it both ways.
    ends = np.stack([corner_uv, corner_uv[following]], 1)
    forward = (vert < vert[following])[:, None, None]
    ends = np.where(forward, ends, ends[:, ::-1])
    low = np.full((len(mesh.edges), 2, 2), np.inf)
    high = np.full((len(mesh.edges), 2, 2), -np.inf)
    np.minimum.at(low, edge, ends)
    np.maximum.at(high, edge, ends)
    mesh.edges.foreach_set("use_seam", (low != high).any((1, 2)))


def _load_image(picture: Picture, name: str, made: list[bpy.types.ID]) -> bpy.types.Image:
    try:
        image = bpy.data.images.load(str(picture.path.resolve()), check_existing=False)
    except RuntimeError as error:
        raise AssetError(f"{picture.path} can't be read ({error}).", "Generate it again.") from None
    made.append(image)
    image.name = name  # not the file's: every asset has a normal.png
    _set_color_space(image, picture)
    image.pack()
    return image


def _set_color_space(image: bpy.types.Image, picture: Picture) -> None:
    if picture.color_space == "Non-Color":
        # By role: the name of the data colour space depends on the OpenColorIO configuration.
        image.colorspace_settings.is_data = True
        return
    try:
        image.colorspace_settings.name = picture.color_space
    except (TypeError, ValueError):  # ValueError: text that UTF-8 cannot hold
        raise AssetError(
            f"{picture.path} is in the color space {picture.color_space!r}, "
            "which this Blender does not have.",
            "Unset OCIO, or add that space to its configuration.",
        ) from None
