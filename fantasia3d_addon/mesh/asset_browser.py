"""An asset as an entry of Blender's Asset Browser, with a thumbnail and tags."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from pathlib import Path

import bpy
import numpy as np

from ..asset.origin import copy_origin, origin_of
from ..blender.blend_output import temporary_blend
from ..blender.mesh_arrays import mesh_object, shown_copy
from ..environment.files import expanded
from ..errors import AddonError, OutputError
from ..scene import light
from ..scene import render as scene_render
from ..scene.relight import TABLE, remove_turntable_scene

SIZE = 256  # pixels of a thumbnail
SAMPLES = 24


def mark_asset(
    obj: bpy.types.Object,
    tags: Iterable[str] = (),
    description: str = "",
    thumbnail: bool = True,
) -> None:
    """Make ``obj`` an asset of this file, its thumbnail rendered under the studio light.

    Tags are added to the existing ones. ``description``: where empty, the object's name.

    Raises:
        AddonError: it is no mesh, or this Blender has no Cycles for the thumbnail.
    """
    mesh_object(obj)
    if not obj.asset_data:
        obj.asset_mark()
    data = obj.asset_data
    origin = origin_of(obj)
    data.description = description or data.description or origin.get("prompt", obj.name)
    data.author = data.author or origin.get("software", "")
    copy_origin(obj, data)
    for tag in tags:
        if tag.strip():
            data.tags.new(tag.strip(), skip_if_exists=True)
    if thumbnail:
        set_preview(obj, render_thumbnail(obj))


def save_to_library(obj: bpy.types.Object, folder: Path) -> Path:
    """Write ``obj``, with its mesh, material and packed pictures, into an asset library's folder.

    Pictures that are not packed stay where they are, and are found from there.
    The file is NAME.blend; an older one of that name is replaced. Mark ``obj`` as an asset before.

    Raises:
        AddonError: ``obj`` is not an asset yet.
        OutputError: the folder does not exist or can't be written.
    """
    if not obj.asset_data:
        raise AddonError(f"{obj.name} is not marked as an asset.", "Mark it first.")
    folder = expanded(folder, OutputError).absolute()
    # Characters that a file name may have on every system.
    words = "".join(c if c.isalnum() or c in " -_" else "_" for c in obj.name).strip()
    path = folder / f"{words or 'asset'}.blend"
    if not folder.is_dir():
        raise OutputError(f"There is no folder {folder}.", "Choose the folder of an asset library.")
    with temporary_blend(path) as temporary:
        bpy.data.libraries.write(
            str(temporary), {obj}, path_remap="RELATIVE", fake_user=True, compress=True
        )
    return path


def render_thumbnail(obj: bpy.types.Object) -> np.ndarray:
    """(H,W,4) sRGB with a transparent background, row 0 at the bottom."""
    # A scene of its own: the user's camera, world and render settings stay as they are.
    scene = bpy.data.scenes.new(TABLE)
    image = None
    try:
        asset = shown_copy(obj, f"{TABLE} asset")
        scene.collection.objects.link(asset)
        camera = scene_render.add_camera(scene, asset)
        camera.name = camera.data.name = f"{TABLE} camera"
        light.set_world(scene, light.STUDIO_FILE)
        scene.view_layers[0].update()
        scene_render.expose(scene, asset)
        scene_render.set_up_cycles(scene, SIZE, SAMPLES)
        scene.render.film_transparent = True
        scene.render.image_settings.file_format = "PNG"
        scene.render.image_settings.color_mode = "RGBA"
        with tempfile.TemporaryDirectory() as folder:
            scene.render.filepath = str(Path(folder) / "thumbnail.png")
            bpy.ops.render.render(write_still=True, scene=scene.name)
            image = bpy.data.images.load(scene.render.filepath)
            pixels = np.empty(SIZE * SIZE * 4, np.float32)
            image.pixels.foreach_get(pixels)
        return pixels.reshape(SIZE, SIZE, 4)
    finally:
        world_image = light.environment_image(scene.world) if scene.world else None
        remove_turntable_scene(scene)
        for unused in (image, world_image):
            if unused and not unused.users:
                bpy.data.images.remove(unused)


def set_preview(obj: bpy.types.Object, pixels: np.ndarray) -> None:
    """Set the thumbnail of ``obj`` to ``pixels`` of :func:`render_thumbnail`."""
    preview = obj.preview_ensure()
    preview.image_size = (SIZE, SIZE)
    preview.image_pixels_float.foreach_set(np.ascontiguousarray(pixels).ravel())
