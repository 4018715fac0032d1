"""Replaces an asset's material and restores it; tint and scales over its baked maps."""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from ..blender import compat
from ..blender.mesh_arrays import is_shared, mesh_object
from ..blender.names import data_name
from ..errors import AddonError
from . import library as material_library

KEPT = "fantasia3d_materials"  # custom property: an object's own materials by slot
LINKS = "fantasia3d_links"  # custom property: what each slot was linked to, for the same objects
EDITS = {  # the name of an adjustment node, and the Principled input that it feeds
    "Fantasia3D tint": "Base Color",
    "Fantasia3D roughness": "Roughness",
    "Fantasia3D metallic": "Metallic",
}


def replace_material(
    obj: bpy.types.Object, material: str | bpy.types.Material, keep_normals: bool = True
) -> bpy.types.Material:
    """Show ``material`` instead of all materials of ``obj``, which keeps those for later.

    A name of ``library.NAMES`` creates a new one, with the detail of the baked normal map if
    ``keep_normals``; a material of the file is used unchanged.

    Raises:
        AddonError: there is no such material, or the object is no mesh.
    """
    mesh_object(obj)
    if isinstance(material, str):
        material = _of_library(obj, material, keep_normals)
    if not obj.material_slots:
        obj.data.materials.append(None)
    keep_materials(obj)
    replaced = [slot.material for slot in obj.material_slots]
    # Every slot, so that no face shows the old one.
    for slot in obj.material_slots:
        show_in_slot(obj, slot, material)
    _remove_unused(replaced)
    return material


def show_in_slot(
    obj: bpy.types.Object, slot: bpy.types.MaterialSlot, material: bpy.types.Material
) -> None:
    """Show ``material`` in the slot; other objects that share the mesh keep what they show."""
    if is_shared(obj.data):
        slot.link = "OBJECT"
    slot.material = material


def keep_materials(obj: bpy.types.Object) -> None:
    """Remember the materials of ``obj`` for :func:`restore_material`."""
    if KEPT not in obj:  # a second replacement must not overwrite the originals
        obj[KEPT] = {str(i): slot.material for i, slot in enumerate(obj.material_slots)}
        obj[LINKS] = {str(i): slot.link for i, slot in enumerate(obj.material_slots)}


def restore_material(obj: bpy.types.Object) -> None:
    """Show the own materials of ``obj`` again.

    Raises:
        AddonError: it shows them already.
    """
    if obj.get(KEPT) is None:
        raise AddonError(f"{obj.name} shows its own material.", "There is nothing to restore.")
    others = [slot.material for slot in obj.material_slots]
    kept, links = obj[KEPT].to_dict(), obj.get(LINKS, {})  # none of an earlier version
    for number, slot in enumerate(obj.material_slots):
        if str(number) not in kept:  # a slot that was added since has its own
            continue
        if links.get(str(number), slot.link) != slot.link:
            slot.material, slot.link = None, "DATA"  # what the mesh has is shown again
        if slot.material != kept[str(number)]:
            show_in_slot(obj, slot, kept[str(number)])
    del obj[KEPT]
    obj.pop(LINKS, None)
    _remove_unused(others)


def adjust_material(
    material: bpy.types.Material,
    tint: Sequence[float] = (1.0, 1.0, 1.0),
    roughness_scale: float = 1.0,
    metallic_scale: float = 1.0,
) -> None:
    """Multiply the material's base colour (linear), roughness and metallic; its maps stay.

    Raises:
        AddonError: it has no Principled node.
    """
    nodes = edit_nodes(material, make=True)
    for node, value in zip(nodes, ((*tint[:3], 1.0), roughness_scale, metallic_scale), strict=True):
        factor(node).default_value = value


def reset_material(material: bpy.types.Material) -> None:
    """Remove the nodes of :func:`adjust_material`; the maps feed the material as before."""
    tree = material.node_tree
    for node in edit_nodes(material):
        for link in list(node.outputs[_result(node)].links):
            source = node.inputs[_first(node)]
            if source.links:
                tree.links.new(source.links[0].from_socket, link.to_socket)
        tree.nodes.remove(node)


def edit_nodes(material: bpy.types.Material, make: bool = False) -> list[bpy.types.Node]:
    """The adjustment nodes, in the order of EDITS; empty where there are none and not ``make``.

    Raises:
        AddonError: ``make``, and the material has no Principled node.
    """
    tree = material.node_tree
    found = [tree.nodes[name] for name in EDITS if tree and name in tree.nodes]
    if len(found) == len(EDITS) or not make:
        return found
    bsdf = principled(material)
    if bsdf is None:
        raise AddonError(
            f"{material.name} has no Principled BSDF.", "Choose a material that has one."
        )
    for name, into in EDITS.items():
        if name not in tree.nodes:  # the user may have removed one of them
            _edit_node(tree, bsdf, name, into)
    compat.deselect_nodes(tree)
    return [tree.nodes[name] for name in EDITS]


def principled(material: bpy.types.Material | None) -> bpy.types.Node | None:
    """The Principled node of the material; one that is connected comes first."""
    nodes = material.node_tree.nodes if material and material.node_tree else ()
    found = [node for node in nodes if node.bl_idname == "ShaderNodeBsdfPrincipled"]
    # A material may hold several; the connected one is what is visible.
    shown = [node for node in found if node.outputs["BSDF"].links]
    return (shown or found or [None])[0]


def factor(node: bpy.types.Node) -> bpy.types.NodeSocket:
    """The input of an adjustment node that holds the factor."""
    return _sockets(node.inputs)["B_Color"] if node.type == "MIX" else node.inputs[1]


def image_of(socket: bpy.types.NodeSocket) -> tuple[bpy.types.Image, str] | None:
    """The picture of :func:`picture_of`, and its channel."""
    found = picture_of(socket)
    return (found[0].image, found[1]) if found else None


def picture_of(socket: bpy.types.NodeSocket) -> tuple[bpy.types.Node, str] | None:
    """The node whose picture feeds ``socket``, directly or through our adjustments; its channel.

    "Color" or "Alpha", or "Red", "Green", "Blue" after a Separate Color node.
    """
    # Walks from the socket back to the picture, through what may be in between.
    channel = "Color"
    while socket.links:
        node, out = socket.links[0].from_node, socket.links[0].from_socket
        if node.type == "TEX_IMAGE":
            return (node, "Alpha" if out.name == "Alpha" else channel) if node.image else None
        if node.name in EDITS:
            socket = node.inputs[_first(node)]
        elif node.bl_idname == "ShaderNodeSeparateColor":
            channel, socket = out.name, node.inputs["Color"]
        elif node.bl_idname == "ShaderNodeNormalMap":
            socket = node.inputs["Color"]
        else:
            return None
    return None


def _edit_node(
    tree: bpy.types.NodeTree, bsdf: bpy.types.Node, name: str, into: str
) -> bpy.types.Node:
    socket = bsdf.inputs[into]
    if into == "Base Color":
        node = tree.nodes.new("ShaderNodeMix")
        node.data_type, node.blend_type = "RGBA", "MULTIPLY"
        _sockets(node.inputs)["Factor_Float"].default_value = 1.0
    else:
        node = tree.nodes.new("ShaderNodeMath")
        node.operation, node.use_clamp = "MULTIPLY", True
    node.name = node.label = name
    node.location = (bsdf.location.x - 200, bsdf.location.y - 180 * list(EDITS).index(name))
    first = node.inputs[_first(node)]
    # The constant of the socket becomes the first factor, or the link below does.
    first.default_value = socket.default_value
    factor(node).default_value = (1, 1, 1, 1) if into == "Base Color" else 1.0
    if socket.links:
        tree.links.new(socket.links[0].from_socket, first)
    tree.links.new(node.outputs[_result(node)], socket)
    return node


def _sockets(sockets: bpy.types.bpy_prop_collection) -> dict[str, bpy.types.NodeSocket]:
    return {socket.identifier: socket for socket in sockets}  # a Mix node repeats its names


def _first(node: bpy.types.Node) -> int:
    """The index of the input that a map feeds."""
    return _index(node.inputs, "A_Color") if node.type == "MIX" else 0


def _result(node: bpy.types.Node) -> int:
    return _index(node.outputs, "Result_Color") if node.type == "MIX" else 0


def _index(sockets: bpy.types.bpy_prop_collection, identifier: str) -> int:
    return next(i for i, socket in enumerate(sockets) if socket.identifier == identifier)


def _of_library(obj: bpy.types.Object, name: str, keep_normals: bool) -> bpy.types.Material:
    if name not in material_library.NAMES:
        raise AddonError(
            f"There is no material {name!r}.",
            f"Use one of {', '.join(material_library.NAMES)}, or a material of this file.",
        )
    material = bpy.data.materials.new(data_name(name.title(), f" on {obj.name}"[:40]))
    material["fantasia3d_library"] = name
    # In the object's own units, in which the patterns are: dimensions include the scale.
    size = max(obj.dimensions[i] / (abs(obj.scale[i]) or 1) for i in range(3))
    bsdf = material_library.build(material, name, size)
    own = obj.get(KEPT)
    first = own.to_dict().get("0") if own is not None else obj.active_material
    bump = principled(first)
    image = image_of(bump.inputs["Normal"]) if bump else None
    if keep_normals and image and bump.inputs["Normal"].links[0].from_node.type == "NORMAL_MAP":
        uv_map = bump.inputs["Normal"].links[0].from_node.uv_map
        _add_normal_map(material.node_tree, bsdf, image[0], uv_map)
    return material


def _add_normal_map(
    tree: bpy.types.NodeTree, bsdf: bpy.types.Node, image: bpy.types.Image, uv_map: str
) -> None:
    """Add the baked normal map, before the material's own bump node if it has one."""
    uv, picture, bump = (
        tree.nodes.new(f"ShaderNode{kind}") for kind in ("UVMap", "TexImage", "NormalMap")
    )
    uv.uv_map = bump.uv_map = uv_map
    picture.image = image
    compat.set_opengl_convention(bump)
    for column, node in enumerate((uv, picture, bump)):
        node.location = (300 * column - 1300, -700)
    tree.links.new(uv.outputs["UV"], picture.inputs["Vector"])
    tree.links.new(picture.outputs["Color"], bump.inputs["Color"])
    own = bsdf.inputs["Normal"].links
    into = own[0].from_node.inputs["Normal"] if own else bsdf.inputs["Normal"]
    tree.links.new(bump.outputs["Normal"], into)
    compat.deselect_nodes(tree)


def _remove_unused(materials: Sequence[bpy.types.Material | None]) -> None:
    """Remove those of the library that no object uses."""
    for material in {m for m in materials if m and "fantasia3d_library" in m}:
        if not material.users:
            bpy.data.materials.remove(material)
