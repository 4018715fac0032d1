"""The operators for materials. Each calls one function."""

from __future__ import annotations

import bpy
from bpy.props import FloatVectorProperty

from .. import options
from ..material import edit as material_edit
from ..material import library as material_library
from .operator_helpers import UNDO, can_run, run_and_report
from .option_properties import option_property


class FANTASIA3D_OT_replace_material(bpy.types.Operator):
    """Show the asset in another material; its own materials and baked maps are kept"""

    bl_idname = "fantasia3d.replace_material"
    bl_label = "Replace Material"
    bl_options = UNDO

    material: option_property(options.MATERIAL)
    keep_normals: option_property(options.KEEP_NORMALS)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        # A name of the library comes first; else a material of the file, or an error by name.
        name, obj = self.material, context.active_object
        given = name if name in material_library.NAMES else bpy.data.materials.get(name, name)
        return run_and_report(
            self, lambda: material_edit.replace_material(obj, given, self.keep_normals)
        )


class FANTASIA3D_OT_restore_material(bpy.types.Operator):
    """Show the asset in its own material again"""

    bl_idname = "fantasia3d.restore_material"
    bl_label = "Restore Original"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        obj = context.active_object
        replaced = obj is not None and obj.get(material_edit.KEPT) is not None
        return can_run(cls, context, "" if replaced else "It shows its own material.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        return run_and_report(self, lambda: material_edit.restore_material(context.active_object))


class FANTASIA3D_OT_adjust_material(bpy.types.Operator):
    """Add nodes that tint the material and scale its roughness and metallic; the maps stay"""

    bl_idname = "fantasia3d.adjust_material"
    bl_label = "Add Adjustment Nodes"
    bl_options = UNDO

    tint: FloatVectorProperty(
        name="Tint", description="Colour that multiplies the base colour", subtype="COLOR",
        default=(1, 1, 1), min=0, max=1,
    )  # fmt: skip
    roughness_scale: option_property(options.ROUGHNESS_SCALE)
    metallic_scale: option_property(options.METALLIC_SCALE)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, _reason_against_adjusting(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        values = self.tint, self.roughness_scale, self.metallic_scale
        material = context.active_object.active_material
        return run_and_report(self, lambda: material_edit.adjust_material(material, *values))


class FANTASIA3D_OT_reset_material(bpy.types.Operator):
    """Remove the adjustment nodes"""

    bl_idname = "fantasia3d.reset_material"
    bl_label = "Remove Adjustment Nodes"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, _reason_against_adjusting(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        material = context.active_object.active_material
        return run_and_report(self, lambda: material_edit.reset_material(material))


def _reason_against_adjusting(context: bpy.types.Context) -> str:
    material = context.active_object and context.active_object.active_material
    if material_edit.principled(material) is None:
        return "Its material has no Principled BSDF."
    if material.library:
        return "Its material is linked from another file. Make it local first."
    return ""


CLASSES = (
    FANTASIA3D_OT_replace_material,
    FANTASIA3D_OT_restore_material,
    FANTASIA3D_OT_adjust_material,
    FANTASIA3D_OT_reset_material,
)
