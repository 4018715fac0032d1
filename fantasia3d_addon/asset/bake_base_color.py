"""Bakes the present base colour of an object to a picture, over one of its UV maps.

Cycles bakes it as emission, which is exact; a bake of "diffuse colour" is not (it loses 4 %).
"""

from __future__ import annotations

from pathlib import Path

import bpy

from ..blender import compat
from ..blender.mesh_arrays import baked_mesh
from ..errors import AddonError, OutputError

GREY = (0.8, 0.8, 0.8, 1.0)  # of a face without a material
MARGIN = 8  # texels beyond the islands' borders


def bake(context: bpy.types.Context, obj: bpy.types.Object, uv_map: str, path: Path, size: int):
    """Write the base colour of ``obj`` to the PNG ``path``, ``size`` texels a side.

    A copy of the object is baked in a scene of its own: the object itself stays as it is.

    Raises:
        AddonError: a material's base colour is unknown, or there is no Cycles.
        OutputError: the file can't be written.
    """
    if not compat.has_cycles():
        raise AddonError("This Blender has no Cycles.", "Enable its add-on Cycles Render Engine.")
    made: list[bpy.types.ID] = []  # removed at the end, the last one first
    try:
        image = bpy.data.images.new("Base colour", size, size, alpha=False)
        made.append(image)
        scene, helper = _bake_scene(obj, uv_map, image, made)
        chosen = {
            "scene": scene,
            "view_layer": scene.view_layers[0],
            "object": helper,
            "active_object": helper,
            "selected_objects": [helper],
            "selected_editable_objects": [helper],
        }
        with context.temp_override(**chosen):
            bpy.ops.object.bake(type="EMIT", margin=MARGIN, use_clear=True)
        image.filepath_raw, image.file_format = str(path), "PNG"
        image.save()
    except RuntimeError as error:
        raise OutputError(
            f"The base colour of {obj.name} can't be baked ({str(error).strip()}).",
            "Start from a plain material instead.",
        ) from None
    finally:
        for item in reversed(made):
            _remove(item)


def _bake_scene(
    obj: bpy.types.Object, uv_map: str, image: bpy.types.Image, made: list[bpy.types.ID]
) -> tuple[bpy.types.Scene, bpy.types.Object]:
    """A scene with settings for a fast bake, and a copy of ``obj`` that emits its base colours."""
    mesh = baked_mesh(obj)
    made.append(mesh)
    mesh.uv_layers.active = mesh.uv_layers[uv_map]
    # The object's slots, which may override those of its mesh.
    slots = [slot.material for slot in obj.material_slots] or [None]
    if not mesh.materials:
        mesh.materials.append(None)
    for index, material in enumerate(slots):
        emitting = _emitting(material, image)
        made.append(emitting)
        mesh.materials[index] = emitting
    helper = bpy.data.objects.new("Base colour", mesh)
    made.append(helper)
    scene = bpy.data.scenes.new("Base colour")
    made.append(scene)
    scene.collection.objects.link(helper)
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples = "CPU", 4
    scene.cycles.use_denoising = False  # a build without a denoiser bakes black
    view_layer = scene.view_layers[0]
    view_layer.objects.active = helper
    helper.select_set(True, view_layer=view_layer)
    return scene, helper


def _emitting(material: bpy.types.Material | None, image: bpy.types.Image) -> bpy.types.Material:
    """A copy of ``material`` that emits its base colour, and bakes into ``image``."""
    if material is None or not compat.has_nodes(material):
        emitting = bpy.data.materials.new("Base colour")
        compat.empty_nodes(emitting)
        color = tuple(material.diffuse_color) if material else GREY
    else:
        emitting, color = material.copy(), None
    tree, name = emitting.node_tree, material.name if material else ""
    emission = tree.nodes.new("ShaderNodeEmission")
    output = tree.get_output_node("CYCLES") or tree.nodes.new("ShaderNodeOutputMaterial")
    try:
        _connect(tree, color or _color(tree, output.inputs["Surface"], name), emission)
    except AddonError:
        bpy.data.materials.remove(emitting)
        raise
    tree.links.new(emission.outputs[0], output.inputs["Surface"])
    target = tree.nodes.new("ShaderNodeTexImage")
    target.image = image
    tree.nodes.active = target  # Cycles bakes into the picture of the active node
    return emitting


def _connect(tree: bpy.types.NodeTree, color: object, emission: bpy.types.Node) -> None:
    if isinstance(color, bpy.types.NodeSocket):
        tree.links.new(color, emission.inputs["Color"])
    else:
        emission.inputs["Color"].default_value = color


def _color(tree: bpy.types.NodeTree, surface: bpy.types.NodeSocket, name: str) -> object:
    """The base colour of the shader that leads into ``surface``: a socket, or a constant."""
    if not surface.is_linked:
        return (0.0, 0.0, 0.0, 1.0)  # no shader: Cycles shows black
    node = surface.links[0].from_node
    for key in ("Base Color", "Color"):
        if key in node.inputs:
            socket = node.inputs[key]
            return socket.links[0].from_socket if socket.is_linked else tuple(socket.default_value)
    if node.bl_idname == "ShaderNodeMixShader":
        return _mix(tree, node, name)
    if node.bl_idname == "NodeReroute":
        return _color(tree, node.inputs[0], name)
    raise AddonError(
        f"The base colour of the material “{name}” is unknown: it comes from “{node.name}”.",
        "Start from a plain material, or bake this one to a picture first.",
    )


def _mix(tree: bpy.types.NodeTree, shader: bpy.types.Node, name: str) -> bpy.types.NodeSocket:
    """The two shaders' base colours, mixed as the shaders are."""
    mix = tree.nodes.new("ShaderNodeMix")
    mix.data_type = "RGBA"
    # A mix of shaders becomes the same mix of their colours.
    factor, *shaders = shader.inputs[:3]
    if factor.is_linked:
        tree.links.new(factor.links[0].from_socket, mix.inputs[0])
    else:
        mix.inputs[0].default_value = factor.default_value
    for socket, into in zip(shaders, (mix.inputs[6], mix.inputs[7]), strict=True):
        color = _color(tree, socket, name)
        if isinstance(color, bpy.types.NodeSocket):
            tree.links.new(color, into)
        else:
            into.default_value = color
    return mix.outputs[2]


def _remove(item: bpy.types.ID) -> None:
    """Remove a temporary datablock."""
    kinds = {
        bpy.types.Image: bpy.data.images,
        bpy.types.Mesh: bpy.data.meshes,
        bpy.types.Material: bpy.data.materials,
        bpy.types.Object: bpy.data.objects,
        bpy.types.Scene: bpy.data.scenes,
    }
    next(where for kind, where in kinds.items() if isinstance(item, kind)).remove(item)
