"""Materials by buttons. Each operator calls one function."""

from __future__ import annotations

import bpy
from bpy.props import (
    BoolProperty,
    FloatProperty,
    FloatVectorProperty,
    StringProperty,
)

from ..material import edit as material_edit
from ..material import library as material_library
from .operator_helpers import UNDO, allowed, told


class FANTASIA3D_OT_replace_material(bpy.types.Operator):
    """Show the asset in another material; its own and the baked maps are kept"""

    bl_idname = "fantasia3d.replace_material"
    bl_label = "Replace Material"
    bl_options = UNDO

    material: StringProperty(
        name="Material", description="wood, gold, …, or a material of this file", default="wood"
    )
    keep_normals: BoolProperty(name="Keep Baked Detail", default=True)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        name = self.material
        given = name if name in material_library.NAMES else bpy.data.materials.get(name, name)
        obj = context.active_object
        return told(self, lambda: material_edit.replace_material(obj, given, self.keep_normals))


class FANTASIA3D_OT_restore_material(bpy.types.Operator):
    """Go back to the asset's own material"""

    bl_idname = "fantasia3d.restore_material"
    bl_label = "Own Material"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        obj = context.active_object
        kept = obj is not None and obj.get(material_edit.KEPT) is not None
        return allowed(cls, context, "" if kept else "It has its own material.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: material_edit.restore_material(context.active_object))


class FANTASIA3D_OT_adjust_material(bpy.types.Operator):
    """Tint the material, and scale its roughness and metallic; the baked maps stay"""

    bl_idname = "fantasia3d.adjust_material"
    bl_label = "Adjust Material"
    bl_options = UNDO

    tint: FloatVectorProperty(name="Tint", subtype="COLOR", default=(1, 1, 1), min=0, max=1)
    roughness_scale: FloatProperty(name="Roughness", default=1.0, min=0.0, soft_max=2.0)
    metallic_scale: FloatProperty(name="Metallic", default=1.0, min=0.0, soft_max=2.0)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context, _material_reason(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        values = self.tint, self.roughness_scale, self.metallic_scale
        material = context.active_object.active_material
        return told(self, lambda: material_edit.adjust_material(material, *values))


class FANTASIA3D_OT_reset_material(bpy.types.Operator):
    """Take the tint and the scales off again"""

    bl_idname = "fantasia3d.reset_material"
    bl_label = "Reset"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context, _material_reason(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        material = context.active_object.active_material
        return told(self, lambda: material_edit.reset_material(material))


def _material_reason(context: bpy.types.Context) -> str:
    obj = context.active_object
    has = obj and material_edit.principled(obj.active_material)
    return "" if has else "Its material has no Principled BSDF."


CLASSES = (
    FANTASIA3D_OT_replace_material,
    FANTASIA3D_OT_restore_material,
    FANTASIA3D_OT_adjust_material,
    FANTASIA3D_OT_reset_material,
)
