"""Replacement materials: metals with their measured colour, wood, stone, …

They need no UVs: their patterns are solid textures in object space, and have no seams.
"""

from __future__ import annotations

from collections.abc import Callable

import bpy

from ..blender import compat

# Linear Rec. 709; the metals' colours are their reflectance at normal incidence
# (physicallybased.info).
PLAIN: dict[str, dict[str, object]] = {
    "gold": {"Base Color": (1.0, 0.773, 0.307, 1), "Metallic": 1.0, "Roughness": 0.18},
    "silver": {"Base Color": (0.962, 0.949, 0.922, 1), "Metallic": 1.0, "Roughness": 0.12},
    "copper": {"Base Color": (0.926, 0.721, 0.504, 1), "Metallic": 1.0, "Roughness": 0.22},
    "iron": {"Base Color": (0.531, 0.512, 0.496, 1), "Metallic": 1.0, "Roughness": 0.38},
    "porcelain": {"Base Color": (0.87, 0.86, 0.83, 1), "Roughness": 0.08, "Coat Weight": 0.5},
    "clay": {"Base Color": (0.48, 0.19, 0.10, 1), "Roughness": 0.92},
    "plastic": {"Base Color": (0.04, 0.22, 0.56, 1), "Roughness": 0.28},
    "rubber": {"Base Color": (0.022, 0.021, 0.020, 1), "Roughness": 0.7},
    "glass": {"Base Color": (1, 1, 1, 1), "Roughness": 0.0, "Transmission Weight": 1.0, "IOR": 1.5},
}
Painter = Callable[[bpy.types.NodeTree, bpy.types.Node, float], None]


def build(material: bpy.types.Material, name: str, size: float) -> bpy.types.Node:
    """Create the nodes of ``name`` in the new ``material``; its Principled node.

    ``size`` is the object's longest side in its own units: the patterns scale with it.
    """
    tree = compat.empty_nodes(material)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    bsdf = tree.nodes.new("ShaderNodeBsdfPrincipled")
    tree.links.new(bsdf.outputs["BSDF"], output.inputs["Surface"])
    if name in PLAIN:
        for socket, value in PLAIN[name].items():
            bsdf.inputs[socket].default_value = value
    else:
        SOLID[name](tree, bsdf, size)
    compat.deselect_nodes(tree)
    return bsdf


def _wood(tree: bpy.types.NodeTree, bsdf: bpy.types.Node, size: float) -> None:
    """Year rings around an upright trunk whose axis is off the centre, and fibres along it."""
    place = _coordinates(tree, size, (1.0, 1.0, 0.16))
    wobble = _noise(tree, place, scale=1.4, detail=3.0)
    rings = tree.nodes.new("ShaderNodeTexWave")
    rings.location = (-500, 0)
    rings.wave_type, rings.rings_direction = "RINGS", "Z"
    rings.wave_profile = "SAW"
    rings.inputs["Scale"].default_value = 1.9
    rings.inputs["Distortion"].default_value = 7.0
    rings.inputs["Detail"].default_value = 3.0
    rings.inputs["Detail Scale"].default_value = 0.45
    tree.links.new(place, rings.inputs["Vector"])
    fibres = _noise(tree, _coordinates(tree, size, (60.0, 60.0, 2.2)), scale=1.0, detail=6.0)
    grain = _mixed(
        tree, rings.outputs["Factor" if "Factor" in rings.outputs else "Fac"], fibres, 0.35
    )
    grain = _mixed(tree, grain, wobble, 0.25)
    light, dark = (0.5, 0.262, 0.105, 1), (0.235, 0.1, 0.036, 1)
    tree.links.new(_ramp(tree, grain, dark, light, (0.3, 0.7)), bsdf.inputs["Base Color"])
    rough = _ramp(tree, grain, (0.62,) * 3 + (1,), (0.42,) * 3 + (1,), (0.0, 1.0))
    tree.links.new(rough, bsdf.inputs["Roughness"])
    _bump(tree, bsdf, fibres, 0.12, size)


def _marble(tree: bpy.types.NodeTree, bsdf: bpy.types.Node, size: float) -> None:
    """Thin grey veins in white: the narrow dark end of a distorted wave."""
    place = _coordinates(tree, size, (1.0, 1.0, 1.0))
    vein = tree.nodes.new("ShaderNodeTexWave")
    vein.location = (-500, 0)
    vein.bands_direction = "DIAGONAL"
    vein.inputs["Scale"].default_value = 0.9
    vein.inputs["Distortion"].default_value = 14.0
    vein.inputs["Detail"].default_value = 8.0
    vein.inputs["Detail Scale"].default_value = 1.3
    tree.links.new(place, vein.inputs["Vector"])
    wave = vein.outputs["Factor" if "Factor" in vein.outputs else "Fac"]
    dark, light = (0.2, 0.21, 0.23, 1), (0.84, 0.83, 0.81, 1)
    tree.links.new(_ramp(tree, wave, dark, light, (0.0, 0.22)), bsdf.inputs["Base Color"])
    bsdf.inputs["Roughness"].default_value = 0.16


def _stone(tree: bpy.types.NodeTree, bsdf: bpy.types.Node, size: float) -> None:
    """Grey grains with a rough surface."""
    place = _coordinates(tree, size, (1.0, 1.0, 1.0))
    coarse = _noise(tree, place, scale=5.0, detail=10.0)
    fine = _noise(tree, place, scale=70.0, detail=4.0)
    grain = _mixed(tree, coarse, fine, 0.45)
    dark, light = (0.12, 0.115, 0.105, 1), (0.46, 0.44, 0.41, 1)
    tree.links.new(_ramp(tree, grain, dark, light, (0.35, 0.68)), bsdf.inputs["Base Color"])
    bsdf.inputs["Roughness"].default_value = 0.86
    _bump(tree, bsdf, grain, 0.5, size)


SOLID: dict[str, Painter] = {"wood": _wood, "marble": _marble, "stone": _stone}
NAMES = ("wood", "gold", "silver", "copper", "iron", "marble", "stone", "clay", "porcelain",
         "glass", "plastic", "rubber")  # fmt: skip


def _coordinates(
    tree: bpy.types.NodeTree, size: float, scale: tuple[float, float, float]
) -> bpy.types.NodeSocket:
    """Object space, scaled so that the longest side is 2, then by ``scale``."""
    place = tree.nodes.new("ShaderNodeTexCoord")
    place.location = (-1100, 0)
    mapping = tree.nodes.new("ShaderNodeMapping")
    mapping.location = (-900, 0)
    mapping.inputs["Scale"].default_value = [2 * s / max(size, 1e-9) for s in scale]
    mapping.inputs["Location"].default_value = (
        2.3,
        1.4,
        0.11,
    )  # the trunk's axis is outside the object
    tree.links.new(place.outputs["Object"], mapping.inputs["Vector"])
    return mapping.outputs["Vector"]


def _noise(
    tree: bpy.types.NodeTree, place: bpy.types.NodeSocket, scale: float, detail: float
) -> bpy.types.NodeSocket:
    noise = tree.nodes.new("ShaderNodeTexNoise")
    noise.location = (-700, -200)
    noise.inputs["Scale"].default_value = scale
    noise.inputs["Detail"].default_value = detail
    tree.links.new(place, noise.inputs["Vector"])
    return noise.outputs[0]


def _mixed(
    tree: bpy.types.NodeTree, a: bpy.types.NodeSocket, b: bpy.types.NodeSocket, fraction: float
) -> bpy.types.NodeSocket:
    mix = tree.nodes.new("ShaderNodeMix")
    mix.location = (-350, -100)
    sockets = {socket.identifier: socket for socket in mix.inputs}
    sockets["Factor_Float"].default_value = fraction
    tree.links.new(a, sockets["A_Float"])
    tree.links.new(b, sockets["B_Float"])
    return next(s for s in mix.outputs if s.identifier == "Result_Float")


def _ramp(
    tree: bpy.types.NodeTree,
    value: bpy.types.NodeSocket,
    low: tuple[float, ...],
    high: tuple[float, ...],
    span: tuple[float, float],
) -> bpy.types.NodeSocket:
    """``value`` as a colour: ``low`` up to the first of ``span``, ``high`` from the second."""
    ramp = tree.nodes.new("ShaderNodeValToRGB")
    ramp.location = (-250, 0)
    first, last = ramp.color_ramp.elements
    first.position, first.color = span[0], low
    last.position, last.color = span[1], high
    tree.links.new(value, ramp.inputs[0])
    return ramp.outputs["Color"]


def _bump(
    tree: bpy.types.NodeTree,
    bsdf: bpy.types.Node,
    height: bpy.types.NodeSocket,
    strength: float,
    size: float,
) -> None:
    bump = tree.nodes.new("ShaderNodeBump")
    bump.location = (-200, -400)
    bump.inputs["Strength"].default_value = strength
    # 1 % of the size: a relief, not a displacement.
    bump.inputs["Distance"].default_value = 0.01 * size
    tree.links.new(height, bump.inputs["Height"])
    tree.links.new(bump.outputs["Normal"], bsdf.inputs["Normal"])
