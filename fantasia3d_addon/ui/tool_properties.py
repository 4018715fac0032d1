"""What the tools' panels keep in the scene."""

from __future__ import annotations

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from ..material import library as material_library
from . import properties

MATERIALS = tuple((name, name.title(), "") for name in material_library.NAMES)
KINDS = (
    ("RIGID", "Rigid Body", "It falls and tumbles as one piece"),
    ("SOFT", "Soft Body", "It squashes and springs back"),
    ("CLOTH", "Cloth", "Its surface falls together like a garment"),
    ("DRAPE", "Drape", "A sheet of cloth falls over it"),
)
TURNS = (
    ("CAMERA", "Camera", "The camera goes round the asset and its light"),
    ("OBJECT", "Asset", "The asset turns under a light that stays"),
    ("LIGHT", "Light", "The light goes round the asset"),
)
FORMATS = (
    ("glb", "glTF (.glb)", "One file: the web, game engines, viewers"),
    ("usdz", "USD (.usdz)", "One file: Apple, Omniverse"),
    ("usdc", "USD (.usdc)", "With its textures beside: film pipelines"),
    ("fbx", "FBX (.fbx)", "One file: Unity, Unreal, Maya"),
    ("obj", "OBJ (.obj)", "With its textures beside: everything else"),
)


class FANTASIA3D_PG_tools(bpy.types.PropertyGroup):
    """The fields of the tools' panels."""

    light: EnumProperty(name="Light", description="What lights the scene", items=properties._lights)
    light_file: StringProperty(
        name="File", description="A lat-long HDR or EXR picture", subtype="FILE_PATH"
    )
    turn: EnumProperty(name="Turn", items=TURNS)
    turn_frames: IntProperty(name="Frames", description="Of one full turn", default=48, min=2)
    turn_size: IntProperty(name="Size", description="Pixels", default=640, min=16, max=8192)
    material: EnumProperty(name="Material", items=MATERIALS)
    own_material: PointerProperty(
        name="Of This File",
        description="A material of this file, instead of one of the list",
        type=bpy.types.Material,
    )
    keep_normals: BoolProperty(
        name="Keep Baked Detail", description="Keep the asset's normal map", default=True
    )
    kind: EnumProperty(name="Simulation", items=KINDS)
    frames: IntProperty(name="Frames", description="To bake", default=60, min=2, max=5000)
    height: FloatProperty(
        name="Height", description="It starts this much higher", default=0.5, min=0.0,
        subtype="DISTANCE",
    )  # fmt: skip
    convex: BoolProperty(
        name="One Convex Hull", description="Faster, but hollows are filled for collisions"
    )
    softness: FloatProperty(name="Softness", default=0.5, min=0.0, max=1.0, subtype="FACTOR")
    self_collision: BoolProperty(name="Self Collision", description="Folds do not pass; slower")
    levels: IntProperty(name="Levels", default=3, min=1, max=8)
    ratio: FloatProperty(
        name="Ratio", description="Of the faces, from each level to the next",
        default=0.5, min=0.05, max=0.95, subtype="FACTOR",
    )  # fmt: skip
    quads: IntProperty(name="Quads", description="About as many", default=4000, min=100)
    format: EnumProperty(name="Format", items=FORMATS)
    flip_normal_y: BoolProperty(
        name="DirectX Normals", description="Flip the green of the normal map (FBX and OBJ)"
    )
    tags: StringProperty(name="Tags", description="With commas between", default="generated")


CLASSES = (FANTASIA3D_PG_tools,)
