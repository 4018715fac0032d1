"""Relights the scene, and renders a turntable that shows an asset from all sides."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import bpy

from .. import options
from ..blender import compat
from ..blender.mesh_arrays import mesh_object, shown_copy
from ..blender.output import raise_if_full, temporary_folder, unwritten
from ..environment.files import expanded
from ..errors import AddonError, OutputError
from . import light
from . import render as scene_render

TABLE = "Fantasia3D turntable"
# Nodes, and their outputs that are the direction in which a world is looked at.
DIRECTIONS = {
    "ShaderNodeTexCoord": ("Generated", "Normal", "Object"),
    "ShaderNodeNewGeometry": ("Position", "Normal", "Incoming"),
}


def relight(
    scene: bpy.types.Scene, name_or_path: str, strength: float = 1.0, rotation_deg: float = 0.0
) -> bpy.types.World:
    """Light ``scene`` by a name or file as :func:`light.light_file` takes it.

    The scene's own world stays in the file.

    ``rotation_deg`` turns the light counter-clockwise seen from above.

    Raises:
        LightError: there is no such light, or it is not a picture.
    """
    return light.set_world(scene, light.light_file(name_or_path), strength, rotation_deg)


def turn_light(world: bpy.types.World | None, strength: float, rotation_deg: float) -> None:
    """Change strength and rotation of the light that :func:`relight` set.

    Raises:
        AddonError: the world is not one of :func:`relight`.
    """
    mapping, background = light.light_node(world, "Mapping"), light.light_node(world, "Background")
    if mapping is None or background is None:
        raise AddonError("The world is not lit by this add-on.", "Press Apply Lighting first.")
    mapping.inputs["Rotation"].default_value[2] = -math.radians(rotation_deg)
    background.inputs["Strength"].default_value = strength


def turntable_scene(
    obj: bpy.types.Object,
    out: Path,
    *,
    frames: int = int(options.TURN_FRAMES.default),
    turn: str = str(options.TURN.default),
    size: int = int(options.SIZE.default),
    samples: int | None = None,
) -> bpy.types.Scene:
    """A scene of its own that shows ``obj``, as it looks now, under its scene's world in one turn.

    A world without a picture or a sky is even, and shows no shape: the film has the studio light
    then. The user's own scene and world stay as they are.

    ``out`` ends in .mp4, or is a folder for frame_0001.png and so on. ``turn``: what rotates, the
    camera, the light, or the object (then camera and light rotate around it together). Render it
    and give it to :func:`remove_turntable_scene`.

    Raises:
        AddonError: no Cycles, or fewer than two frames.
        OutputError: this Blender writes no MP4.
    """
    mesh_object(obj)
    _check(out, frames, turn)
    world = bpy.context.scene.world
    scene = bpy.data.scenes.new(TABLE)
    try:
        asset = shown_copy(obj, f"{TABLE} asset")
        scene.collection.objects.link(asset)
        if _is_lit(world):
            scene.world = world
        else:
            world = light.set_world(scene, light.light_file(light.STUDIO))
            light.environment_image(world).name = f"{TABLE} light"
        pivot = _camera(scene, asset)
        # It also gives the scene a copy of the world, which _animate may rotate.
        scene_render.add_backdrop(scene, asset).name = f"{TABLE} ground"
        if not world.users:
            bpy.data.worlds.remove(world)
        _animate(scene, pivot, frames, turn)
        scene_render.set_up_cycles(scene, size, samples)
        _output(scene, out, out.suffix.lower() == ".mp4")
    except BaseException:
        remove_turntable_scene(scene)
        raise
    return scene


def _is_lit(world: bpy.types.World | None) -> bool:
    """Whether a picture or a sky lights ``world``."""
    if world is None or not compat.has_nodes(world):
        return False
    nodes = world.node_tree.nodes
    output = next((n for n in nodes if n.bl_idname == "ShaderNodeOutputWorld"), None)
    return bool(output and output.inputs["Surface"].links and _lights(world.node_tree))


def _lights(tree: bpy.types.NodeTree) -> list[bpy.types.Node]:
    """The nodes with a sky, or a picture that could be read."""
    skies = [node for node in tree.nodes if node.bl_idname == "ShaderNodeTexSky"]
    pictures = [node for node in tree.nodes if node.bl_idname == "ShaderNodeTexEnvironment"]
    return [*skies, *(node for node in pictures if node.image and all(node.image.size))]


def _check(out: Path, frames: int, turn: str) -> None:
    if frames < 2 or turn not in options.TURN.names:
        raise AddonError(
            f"A turntable of {frames} frames that turns {turn!r} is not possible.",
            f"Use two frames or more, and one of {', '.join(options.TURN.names)}.",
        )
    video = out.suffix.lower() == ".mp4"
    if not video and out.suffix:
        raise OutputError(
            f"{out.name} is not an MP4 file.", "Use a file.mp4, or a folder for PNG files."
        )
    if video and not compat.has_video():
        raise OutputError("This Blender writes no MP4.", "Use a folder for PNG files instead.")


def turntable(obj: bpy.types.Object, out: Path, **settings: object) -> Path:
    """Render :func:`turntable_scene`, whose options these are, and remove the scene again.

    Raises:
        AddonError, OutputError: as :func:`turntable_scene`; or ``out`` can't be written.
    """
    with whole_turntable(out) as temporary:
        _render_turntable(obj, temporary, settings)
    return expanded(out, OutputError).absolute()


@contextlib.contextmanager
def whole_turntable(out: Path) -> Iterator[Path]:
    """A temporary path next to ``out``; what is rendered there takes its place at the end.

    A file or a folder, by the kind of ``out``. An error leaves the older one as it is.

    Raises:
        OutputError: ``out`` can't be written, or nothing was rendered.
    """
    out = expanded(out, OutputError).absolute()
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with temporary_folder(out.parent) as folder:
            # Not under its own name, in which Blender takes # for the frame's number.
            temporary = folder / f"turntable{out.suffix}"
            yield temporary
            if not temporary.exists():
                raise OSError(0, "Blender wrote nothing")
            raise_if_full(out.parent)
            _move(temporary, out)
    except (OSError, RuntimeError) as error:
        raise unwritten(out, error) from None


def _render_turntable(obj: bpy.types.Object, out: Path, settings: dict[str, Any]) -> None:
    scene = turntable_scene(obj, out, **settings)
    try:
        _render(scene)
    finally:
        remove_turntable_scene(scene)


def _move(temporary: Path, out: Path) -> None:
    """Give a turntable its place; other files in the user's folder stay."""
    if temporary.is_dir() and out.is_dir():
        for frame in temporary.iterdir():
            frame.replace(out / frame.name)
    else:
        temporary.replace(out)


def remove_turntable_scene(scene: bpy.types.Scene) -> None:
    """Remove a scene of :func:`turntable_scene`, with everything that was made for it."""
    made: set[bpy.types.ID] = {o for o in scene.collection.objects if o.name.startswith(TABLE)}
    made |= {obj.data for obj in made if obj.data}
    world = scene.world
    bpy.data.batch_remove({*made, scene})
    if world and not world.users:
        bpy.data.worlds.remove(world)
    for image in [i for i in bpy.data.images if i.name.startswith(TABLE) and not i.users]:
        bpy.data.images.remove(image)


def _render(scene: bpy.types.Scene) -> None:
    bpy.ops.render.render(animation=True, scene=scene.name)


def _camera(scene: bpy.types.Scene, obj: bpy.types.Object) -> bpy.types.Object:
    """A still's camera, parented to an empty in the object's centre; the empty, which rotates."""
    camera = scene_render.add_camera(scene, obj)
    camera.name = camera.data.name = f"{TABLE} camera"
    pivot = bpy.data.objects.new(f"{TABLE} pivot", None)
    scene.collection.objects.link(pivot)
    pivot.location = scene_render.bounding_sphere(obj)[0]
    # The camera keeps its place relative to the pivot, which is the centre of rotation.
    camera.parent = pivot
    camera.location -= pivot.location
    return pivot


def _animate(scene: bpy.types.Scene, pivot: bpy.types.Object, frames: int, turn: str) -> None:
    """One full turn in ``frames``, the last one step before the first: the film loops."""
    scene.frame_start, scene.frame_end = 1, frames
    scene.render.fps = 24
    step = 2 * math.pi / frames
    if turn != "LIGHT":
        _drive(pivot, "rotation_euler", step)
    if turn != "CAMERA":  # "OBJECT" rotates the camera too, and the light with it
        tree = scene.world.node_tree
        for mapping in _add_mappings(tree):
            _drive(mapping.inputs["Rotation"], "default_value", -step)
        for sky in [node for node in _lights(tree) if _direction(node) is None]:
            _drive(sky, "sun_rotation", -step, -1)


def _add_mappings(tree: bpy.types.NodeTree) -> list[bpy.types.Node]:
    """New nodes that turn the world's light: after each source of a direction.

    The world's own Mapping nodes stay, since they may hold any rotation and scale.
    """
    for vector in filter(None, map(_direction, _lights(tree))):
        if not vector.links:  # its direction is this one, without a link
            direction = tree.nodes.new("ShaderNodeTexCoord").outputs["Generated"]
            tree.links.new(direction, vector)
    added = []
    for output in [o for n in tree.nodes for o in n.outputs if o.links]:
        if output.name in DIRECTIONS.get(output.node.bl_idname, ()):
            mapping = tree.nodes.new("ShaderNodeMapping")
            for link in list(output.links):
                tree.links.new(mapping.outputs["Vector"], link.to_socket)
            tree.links.new(output, mapping.inputs["Vector"])
            added.append(mapping)
    return added


def _direction(node: bpy.types.Node) -> bpy.types.NodeSocket | None:
    """The input for the direction; none at a sky with a sun, which has a rotation of its own."""
    return next((socket for socket in node.inputs if socket.enabled), None)


def _drive(owner: bpy.types.bpy_struct, name: str, step: float, index: int = 2) -> None:
    """Let the third component of ``name`` grow by ``step`` a frame; -1 for a single number.

    A driver is the same in 4.2 and 5.2; the curves of an action are not.
    """
    value = getattr(owner, name)
    start = value if index < 0 else value[index]
    driver = owner.driver_add(name, index).driver
    driver.expression = f"{start!r} + {step!r} * (frame - 1)"


def _output(scene: bpy.types.Scene, out: Path, video: bool) -> None:
    if video:
        compat.set_video(scene)
        # The temporary name ends in .mp4 already.
        scene.render.use_file_extension = False
        scene.render.filepath = compat.render_path(out)
        return
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = compat.render_path(out / "frame_")
