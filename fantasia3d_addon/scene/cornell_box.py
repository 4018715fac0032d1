"""A Cornell box around assets: the original's proportions, colours and light.

Source: the Cornell box data, www.graphics.cornell.edu/online/box/data.html (552.8 x 548.8 x 559.2,
the light 130 x 105 and closed at the front by nothing); its reflectances and emission as linear
Rec. 709, as most renderers' copies have them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import bpy
import numpy as np
from mathutils import Vector

from ..blender import compat
from ..blender.mesh_arrays import mesh_object, world_verts
from ..errors import AddonError

NAME = "Cornell box"
WIDTH, HEIGHT, DEPTH = 552.8 / 548.8, 1.0, 559.2 / 548.8  # in heights of the box
LIGHT = 130 / 548.8, 105 / 548.8  # width and depth
COLORS = {
    "white": (0.725, 0.71, 0.68),
    "red": (0.63, 0.065, 0.05),
    "green": (0.14, 0.45, 0.091),
}
EMISSION = (17.0, 12.0, 4.0)  # radiance
EXPOSURE = 1.6  # stops, for a bright picture on a screen
ROOM = 0.55  # fraction of the box's width, depth and height for the assets: as its blocks have
BACK = 0.16  # of the box's depth: behind the lamp, or it would light the back of what is seen
FOVY = math.radians(39.3077)  # the original's camera: 35 mm lens, 25 mm film


def build(
    scene: bpy.types.Scene, objs: Sequence[bpy.types.Object], height: float = 0.0
) -> bpy.types.Collection:
    """A box around ``objs``, placed on its floor in a row; its camera becomes the scene's.

    ``height`` is the box's, in metres; 0 fits it to the objects. The open side is the front (-Y).
    The world is black until :func:`remove`, so that the box's light is the only one.

    Raises:
        AddonError: there is a box already, or no object, or the objects do not fit ``height``.
    """
    if box_of(scene):
        raise AddonError("This scene has a Cornell box already.", "Remove it first.")
    if not objs:
        raise AddonError("No object is selected.", "Select the objects for the box.")
    for obj in objs:
        mesh_object(obj)
    bpy.context.view_layer.update()
    places, size = _places(objs)
    # The height of a box whose floor, depth and height have room for the row.
    fit = max(size[0] / (ROOM * WIDTH), size[1] / (ROOM * DEPTH), size[2] / ROOM)
    if height and height < fit * ROOM:
        raise AddonError(
            f"The objects do not fit into a box of {height:g} m.", f"Use {fit:.2f} m or more."
        )
    height = height or fit
    collection = bpy.data.collections.new(NAME)
    scene.collection.children.link(collection)
    # Kept in the file, so that remove() works after it was saved and opened again.
    collection["fantasia3d_before"] = {"world": scene.world, "camera": scene.camera}
    collection["fantasia3d_places"] = {o.name: [*o.matrix_world.translation] for o in objs}
    # Parents first: each moves its children.
    for obj, place in sorted(zip(objs, places, strict=True), key=lambda pair: _depth(pair[0])):
        obj.matrix_world.translation += Vector(place)
        # No further than the back wall, for a box of the user's own height.
        free = (1 - size[1] / (DEPTH * height)) / 2
        obj.matrix_world.translation.y += max(0.0, min(BACK, free)) * DEPTH * height
    _walls(collection, height)
    _light(collection, height)
    _camera(scene, collection, height)
    scene.world = bpy.data.worlds.new(NAME)
    _darken(scene.world)
    bpy.context.view_layer.update()
    return collection


def remove(scene: bpy.types.Scene) -> None:
    """Remove the box; the objects, the world and the camera are as before.

    Raises:
        AddonError: there is none.
    """
    collection = box_of(scene)
    if collection is None:
        raise AddonError("This scene has no Cornell box.", "Build one first.")
    before = collection["fantasia3d_before"].to_dict()
    places = collection["fantasia3d_places"].to_dict()
    for obj in sorted((obj for obj in scene.objects if obj.name in places), key=_depth):
        obj.matrix_world.translation = places[obj.name]
    dark = scene.world
    scene.world, scene.camera = before.get("world"), before.get("camera")
    made: set[bpy.types.ID] = {obj for obj in collection.objects if obj.get("fantasia3d_box")}
    meshes = {obj.data for obj in made if obj.type == "MESH"}
    made |= {obj.data for obj in made}
    materials = {material for mesh in meshes for material in mesh.materials if material}
    if dark and dark.name.startswith(NAME):
        made.add(dark)
    bpy.data.batch_remove(made)
    bpy.data.batch_remove([m for m in materials if not m.users])  # another scene's box has them too
    for obj in list(collection.objects):  # what the user has added since
        scene.collection.objects.link(obj)
    bpy.data.collections.remove(collection)


def box_of(scene: bpy.types.Scene) -> bpy.types.Collection | None:
    """The box that :func:`build` made for ``scene``."""
    return next((c for c in scene.collection.children if "fantasia3d_before" in c), None)


def _depth(obj: bpy.types.Object) -> int:
    """How many parents are above ``obj``."""
    return 1 + _depth(obj.parent) if obj.parent else 0


def flux(height: float) -> np.ndarray:
    """The light's power (3,) in watts: radiance times pi times its area."""
    area = LIGHT[0] * LIGHT[1] * height**2
    return np.array(EMISSION) * math.pi * area


def _places(objs: Sequence[bpy.types.Object]) -> tuple[list[np.ndarray], np.ndarray]:
    """How far each object moves to a row about the centre, at y = 0; and the row's size."""
    boxes = [(points.min(0), points.max(0)) for points in map(world_verts, objs)]
    sizes = np.array([high - low for low, high in boxes])
    gap = 0.08 * sizes.max()  # between two objects
    row = sizes[:, 0].sum() + gap * (len(objs) - 1)
    starts = np.cumsum([0, *(sizes[:-1, 0] + gap)]) - row / 2
    moves = [
        np.array([start - low[0], -(low[1] + high[1]) / 2, -low[2]])
        for start, (low, high) in zip(starts, boxes, strict=True)
    ]
    return moves, np.array([row, sizes[:, 1].max(), sizes[:, 2].max()])


def _walls(collection: bpy.types.Collection, height: float) -> None:
    x, y, z = WIDTH * height / 2, DEPTH * height / 2, height
    corners = [(i * x, j * y, k * z) for k in (0, 1) for j in (-1, 1) for i in (-1, 1)]
    walls = {  # corners in the order in which the normals point inward
        "floor": ("white", (0, 1, 3, 2)),
        "ceiling": ("white", (4, 6, 7, 5)),
        "back wall": ("white", (2, 3, 7, 6)),
        "left wall": ("red", (0, 2, 6, 4)),
        "right wall": ("green", (1, 5, 7, 3)),
    }
    for part, (color, face) in walls.items():
        obj = _quad(collection, part, [corners[i] for i in face])
        obj.data.materials.append(_diffuse(color))


def _light(collection: bpy.types.Collection, height: float) -> None:
    """An area light, and an emissive pane above it for the camera alone: EEVEE draws no lights."""
    power = flux(height)
    lamp = bpy.data.lights.new(f"{NAME} light", "AREA")
    lamp.shape = "RECTANGLE"
    lamp.size, lamp.size_y = LIGHT[0] * height, LIGHT[1] * height
    # Blender's light has a power and a colour, whose largest channel is 1 here.
    lamp.energy, lamp.color = float(power.max()), tuple(power / power.max())
    obj = _add(collection, lamp.name, lamp)
    obj.location = (0, 0, height * 0.998)  # below the ceiling, or it would light nothing
    obj.visible_camera = False
    x, y, z = LIGHT[0] * height / 2, LIGHT[1] * height / 2, height * 0.999
    pane = _quad(collection, "pane", [(-x, -y, z), (-x, y, z), (x, y, z), (x, -y, z)])
    material = _material("pane", EMISSION)
    pane.data.materials.append(material)
    # The pane is visible to the camera alone: the light itself is the lamp.
    for rays in ("diffuse", "glossy", "transmission", "volume_scatter", "shadow"):
        setattr(pane, f"visible_{rays}", False)


def _camera(scene: bpy.types.Scene, collection: bpy.types.Collection, height: float) -> None:
    data = bpy.data.cameras.new(f"{NAME} camera")
    data.sensor_fit, data.angle = "VERTICAL", FOVY
    camera = _add(collection, data.name, data)
    distance = (0.5 * height * 1.01) / math.tan(FOVY / 2) + DEPTH * height / 2
    camera.location = (0, -distance, height / 2)
    camera.rotation_euler = (math.pi / 2, 0, 0)
    data.clip_start, data.clip_end = distance / 100, distance * 100
    scene.camera = camera


def _quad(
    collection: bpy.types.Collection, part: str, corners: Sequence[Sequence[float]]
) -> bpy.types.Object:
    mesh = bpy.data.meshes.new(f"{NAME} {part}")
    mesh.from_pydata(list(corners), [], [(0, 1, 2, 3)])
    return _add(collection, mesh.name, mesh)


def _add(collection: bpy.types.Collection, name: str, data: bpy.types.ID) -> bpy.types.Object:
    obj = bpy.data.objects.new(name, data)
    obj["fantasia3d_box"] = True
    collection.objects.link(obj)
    return obj


def _diffuse(color: str) -> bpy.types.Material:
    name = f"{NAME} {color}"
    # Three walls have one material.
    known = bpy.data.materials.get(name)
    return known or _material(color, None)


def _material(name: str, emission: Sequence[float] | None) -> bpy.types.Material:
    material = bpy.data.materials.new(f"{NAME} {name}")
    tree = compat.empty_nodes(material)
    kind = "Emission" if emission else "BsdfDiffuse"
    node = tree.nodes.new(f"ShaderNode{kind}")
    node.inputs["Color"].default_value = (*(emission or COLORS[name]), 1)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(node.outputs[0], output.inputs["Surface"])
    return material


def _darken(world: bpy.types.World) -> None:
    tree = compat.empty_nodes(world)
    node = tree.nodes.new("ShaderNodeBackground")
    node.inputs["Color"].default_value = (0, 0, 0, 1)
    output = tree.nodes.new("ShaderNodeOutputWorld")
    tree.links.new(node.outputs["Background"], output.inputs["Surface"])
