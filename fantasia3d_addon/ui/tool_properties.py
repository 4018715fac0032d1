"""The fields of the tools' panels, kept in the scene."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, PointerProperty, StringProperty

from .. import options
from ..jobs.target import BOTH, MAPS, SHAPE
from ..material import library as material_library
from .option_properties import option_property
from .properties import light_items

MATERIALS = tuple(
    (name, name.title(), "A material of the add-on's library") for name in material_library.NAMES
)


# Clear about the shape: vertices move, so nothing new is designed.
CHANGES = (
    (MAPS, "Material", "Their texels alone become another material"),
    (
        SHAPE,
        "Shape",
        "Their vertices move toward the words: dents, bumps and cuts are repaired and smoothed; "
        "no new parts",
    ),
    (BOTH, "Both", "Their shape is repaired first, then they get another material"),
)
CHANGE = "What of the faces changes"


class FANTASIA3D_PG_tools(bpy.types.PropertyGroup):
    """The fields of the tools' panels."""

    light: EnumProperty(name="Light", description="What lights the scene", items=light_items)
    light_file: StringProperty(
        name="File", description="A lat-long HDR or EXR picture", subtype="FILE_PATH"
    )
    turn: option_property(options.TURN)
    turn_frames: option_property(options.TURN_FRAMES)
    turn_size: option_property(options.SIZE)
    region_words: StringProperty(
        name="Words", description="What the faces become, such as: red velvet"
    )
    region_change: EnumProperty(name="Change", description=CHANGE, items=CHANGES)
    region_group: StringProperty(
        name="Vertex Group",
        description="The vertex group whose faces are edited; empty: the active one",
    )
    material: EnumProperty(
        name="Material", description="A material of the add-on's library", items=MATERIALS
    )
    own_material: PointerProperty(
        name="Custom Material",
        description="A material of this file, instead of one of the library",
        type=bpy.types.Material,
    )
    keep_normals: option_property(options.KEEP_NORMALS)
    kind: option_property(options.KIND)
    frames: option_property(options.FRAMES)
    height: option_property(options.HEIGHT)
    convex: option_property(options.CONVEX)
    softness: option_property(options.SOFTNESS)
    self_collision: option_property(options.SELF_COLLISION)
    max_faces: option_property(options.MAX_FACES)
    levels: option_property(options.LEVELS)
    ratio: option_property(options.RATIO)
    quads: option_property(options.QUADS)
    format: option_property(options.FORMAT)
    flip_normal_y: option_property(options.FLIP_NORMAL_Y)
    tags: option_property(options.TAGS)


CLASSES = (FANTASIA3D_PG_tools,)
