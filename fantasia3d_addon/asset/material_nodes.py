"""The nodes of an asset's Principled material, with its maps."""

from __future__ import annotations

from collections.abc import Mapping

import bpy

from ..blender import compat
from .asset_folder import USUAL, Light

UV_MAP = "UVMap"
LABELS = {
    "base_color": "Base Color",
    "orm": "Occlusion, Roughness, Metallic",
    "normal": "Normal",
    "emission": "Emission",
    "transmission": "Transmission",
}


def build_material(
    material: bpy.types.Material,
    images: Mapping[str, bpy.types.Image],
    distribution: str,
    uv_map: str = UV_MAP,
    light: Light = USUAL,
) -> None:
    """Create the nodes of the new ``material``.

    ``images`` by role: ``base_color``; ``orm`` (R occlusion, which a path tracer computes itself
    and which stays unconnected, G roughness, B metallic); ``normal`` (tangent space, OpenGL); and
    where there are these, ``emission`` and ``transmission``, taken with ``light``.
    """
    tree = compat.empty_nodes(material)
    output = _node(tree, "ShaderNodeOutputMaterial", 300, 0)
    bsdf = _node(tree, "ShaderNodeBsdfPrincipled", 0, 0)
    bsdf.distribution = distribution
    _link(tree, bsdf, "BSDF", output, "Surface")

    maps = add_pictures(tree, images, uv_map)
    _link(tree, maps["base_color"], "Color", bsdf, "Base Color")

    # The layout of glTF: green is roughness, blue is metallic.
    split = _node(tree, "ShaderNodeSeparateColor", -300, -200)
    _link(tree, maps["orm"], "Color", split, "Color")
    _link(tree, split, "Green", bsdf, "Roughness")
    _link(tree, split, "Blue", bsdf, "Metallic")

    # The tangents come from the same UV map that the normals were baked over.
    bump = _node(tree, "ShaderNodeNormalMap", -300, -500)
    bump.space = "TANGENT"
    bump.uv_map = uv_map
    compat.set_opengl_convention(bump)
    _link(tree, maps["normal"], "Color", bump, "Color")
    _link(tree, bump, "Normal", bsdf, "Normal")
    connect_light(material, bsdf, maps, light)
    compat.deselect_nodes(tree)


def connect_light(
    material: bpy.types.Material,
    bsdf: bpy.types.Node,
    maps: Mapping[str, bpy.types.Node],
    light: Light,
) -> None:
    """Connect the picture nodes of what glows and of what is clear, where ``maps`` has them."""
    tree = material.node_tree
    if "emission" in maps:
        _link(tree, maps["emission"], "Color", bsdf, "Emission Color")
        bsdf.inputs["Emission Strength"].default_value = light.strength
    if "transmission" in maps:
        _link(tree, maps["transmission"], "Color", bsdf, "Transmission Weight")
        bsdf.inputs["IOR"].default_value = light.ior
        compat.show_through(material)


def add_pictures(
    tree: bpy.types.NodeTree, images: Mapping[str, bpy.types.Image], uv_map: str
) -> dict[str, bpy.types.Node]:
    """The picture nodes by role, over the UV map ``uv_map``."""
    # An explicit UV map: the material must not depend on which one is active.
    uv = _node(tree, "ShaderNodeUVMap", -1000, -200)
    uv.uv_map = uv_map
    maps = {}
    for row, (role, label) in enumerate(LABELS.items()):
        if role not in images:
            continue
        maps[role] = _node(tree, "ShaderNodeTexImage", -700, 100 - 300 * row)
        maps[role].image = images[role]
        maps[role].label = label
        _link(tree, uv, "UV", maps[role], "Vector")
    return maps


def _node(tree: bpy.types.NodeTree, kind: str, x: float, y: float) -> bpy.types.Node:
    node = tree.nodes.new(kind)
    node.location = (x, y)
    return node


def _link(
    tree: bpy.types.NodeTree, source: bpy.types.Node, out: str, sink: bpy.types.Node, into: str
) -> None:
    tree.links.new(source.outputs[out], sink.inputs[into])
