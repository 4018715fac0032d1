"""Another light on the scene, and a turntable that shows an asset from all sides."""

from __future__ import annotations

import contextlib
import math
import shutil
from pathlib import Path

import bpy

from ..blender import compat
from ..blender.mesh_arrays import mesh_object
from ..errors import AddonError, OutputError
from . import light
from . import render as pictures

TABLE = "Fantasia3D turntable"
TURNS = ("CAMERA", "LIGHT", "OBJECT")


def relight(
    scene: bpy.types.Scene, name_or_path: str, strength: float = 1.0, rotation_deg: float = 0.0
) -> bpy.types.World:
    """Light ``scene`` by a light of ``light.light_file``; its own world stays in the file.

    ``rotation_deg`` turns the light counter-clockwise seen from above.

    Raises:
        LightError: there is no such light, or it is no picture.
    """
    return light.set_world(scene, light.light_file(name_or_path), strength, rotation_deg)


def turn_light(world: bpy.types.World | None, strength: float, rotation_deg: float) -> None:
    """Change the light that :func:`relight` set, without reading its picture again.

    Raises:
        AddonError: the world is not of :func:`relight`.
    """
    mapping, background = light.light_node(world, "Mapping"), light.light_node(world, "Background")
    if mapping is None or background is None:
        raise AddonError("The world is not lit by this add-on.", "Press Relight first.")
    mapping.inputs["Rotation"].default_value[2] = -math.radians(rotation_deg)
    background.inputs["Strength"].default_value = strength


def turntable_scene(
    obj: bpy.types.Object,
    out: Path,
    frames: int = 48,
    turn: str = "CAMERA",
    size: int = 640,
    samples: int | None = None,
) -> bpy.types.Scene:
    """A scene of its own that shows ``obj`` under its scene's world in one full turn.

    ``out`` ends in .mp4, or is a folder for frame_0001.png and so on. ``turn``: the camera goes
    round, or the light alone, or the object (camera and light go round it together). Render it and
    give it to :func:`forget`.

    Raises:
        AddonError: no light, no Cycles, or fewer than two frames.
        OutputError: this Blender writes no MP4.
    """
    mesh_object(obj)
    source = bpy.context.scene
    if frames < 2 or turn not in TURNS:
        raise AddonError(
            f"A turntable of {frames} frames that turns {turn!r} can't be.",
            f"Take two frames or more, and one of {', '.join(TURNS)}.",
        )
    video = out.suffix.lower() == ".mp4"
    if not video and out.suffix:
        raise OutputError(f"{out} is no MP4 file.", "Name a file.mp4, or a folder for PNG files.")
    if video and not compat.has_video():
        raise OutputError("This Blender writes no MP4.", "Name a folder for PNG files instead.")
    if light.light_node(source.world, "Mapping") is None:
        relight(source, light.STUDIO)
    scene = bpy.data.scenes.new(TABLE)
    try:
        scene.collection.objects.link(obj)
        scene.world = source.world
        pivot = _camera(scene, obj)
        pictures.add_backdrop(scene, obj).name = f"{TABLE} ground"  # and a copy of the world
        _animate(scene, pivot, frames, turn)
        pictures.set_up_cycles(scene, size, samples)
        _output(scene, out, video)
    except BaseException:
        forget(scene)
        raise
    return scene


def turntable(obj: bpy.types.Object, out: Path, **options: object) -> Path:
    """Render :func:`turntable_scene`, whose options these are, and take the scene away again.

    Raises:
        AddonError, OutputError: as :func:`turntable_scene`; or ``out`` can't be written.
    """
    out = Path(out).expanduser().absolute()
    aside = out.with_name(f".fantasia3d-{out.name}")
    scene = turntable_scene(obj, aside, **options)
    try:
        _render(scene)
        if not aside.exists():
            raise OSError(0, "Blender wrote nothing")
        if aside.is_dir() and out.is_dir():
            for frame in aside.iterdir():
                frame.replace(out / frame.name)
        else:
            aside.replace(out)
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error).strip()
        raise OutputError(f"{out} can't be written ({reason}).", "Choose another place.") from None
    finally:
        shutil.rmtree(aside, ignore_errors=True)
        with contextlib.suppress(OSError):
            aside.unlink(missing_ok=True)
        forget(scene)
    return out


def forget(scene: bpy.types.Scene) -> None:
    """Take a scene of :func:`turntable_scene` out of the file, with all that was made for it."""
    made: set[bpy.types.ID] = {o for o in scene.collection.objects if o.name.startswith(TABLE)}
    made |= {obj.data for obj in made if obj.data}
    world = scene.world
    bpy.data.batch_remove({*made, scene})
    if world and not world.users:
        bpy.data.worlds.remove(world)


def _render(scene: bpy.types.Scene) -> None:
    bpy.ops.render.render(animation=True, scene=scene.name)


def _camera(scene: bpy.types.Scene, obj: bpy.types.Object) -> bpy.types.Object:
    """A still's camera, hung on an empty in the object's middle: the empty, which turns."""
    camera = pictures.add_camera(scene, obj)
    camera.name = camera.data.name = f"{TABLE} camera"
    pivot = bpy.data.objects.new(f"{TABLE} pivot", None)
    scene.collection.objects.link(pivot)
    pivot.location = pictures.bounding_sphere(obj)[0]
    camera.parent = pivot
    camera.location -= pivot.location
    return pivot


def _animate(scene: bpy.types.Scene, pivot: bpy.types.Object, frames: int, turn: str) -> None:
    """One full turn in ``frames``, whose last is one step before the first."""
    scene.frame_start, scene.frame_end = 1, frames
    scene.render.fps = 24
    step = 2 * math.pi / frames
    if turn != "LIGHT":
        _drive(pivot, "rotation_euler", step)
    if turn != "CAMERA":
        mapping = light.light_node(scene.world, "Mapping")
        start = mapping.inputs["Rotation"].default_value[2]
        _drive(mapping.inputs["Rotation"], "default_value", -step, start)


def _drive(owner: bpy.types.bpy_struct, name: str, step: float, start: float = 0.0) -> None:
    """Let the third number of ``name`` grow by ``step`` a frame. A driver is the same in 4.2 and
    5.2, where the curves of an action are not."""
    driver = owner.driver_add(name, 2).driver
    driver.expression = f"{start!r} + {step!r} * (frame - 1)"


def _output(scene: bpy.types.Scene, out: Path, video: bool) -> None:
    if video:
        compat.set_video(scene)
        scene.render.use_file_extension = False
        scene.render.filepath = str(out)
        return
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(out / "frame_")
