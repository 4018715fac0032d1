"""The operators and the panel of a region's new material or shape."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, StringProperty

from ..jobs import edit_region
from ..jobs.target import MAPS
from ..material import edit as material_edit
from ..mesh import new_shape
from .operator_helpers import UNDO, allowed, can_run, queue_job, run_and_report
from .text import wrapped_label
from .tool_properties import CHANGE, CHANGES
from .tools_panel import ToolPanel

WORDS = "What the faces become, such as: red velvet"
LIMIT = "Repairs and smooths the faces toward the words; it adds no parts."
GROUP = "The vertex group whose faces are edited in Object Mode; empty: the active one"


class FANTASIA3D_OT_edit_region(bpy.types.Operator):
    """Generate another material or repair the shape of the selected faces; the rest stays"""

    bl_idname = "fantasia3d.edit_region"
    bl_label = "Edit Region"

    # SKIP_SAVE: from a menu it asks for the words, and does not take those of the last time.
    words: StringProperty(name="Words", description=WORDS, options={"SKIP_SAVE"})
    vertex_group: StringProperty(name="Vertex Group", description=GROUP, options={"SKIP_SAVE"})
    change: EnumProperty(name="Change", description=CHANGE, items=CHANGES, options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return allowed(cls, edit_region.reason_against(context))

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if self.properties.is_property_set("words") and self.words.strip():
            return self.execute(context)  # the panel's button: they were entered there
        tools = context.scene.fantasia3d_tools
        self.words, self.change = tools.region_words, tools.region_change
        return context.window_manager.invoke_props_dialog(self, width=400)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return queue_job(
            self,
            lambda: edit_region.edit_region(context, self.words, self.vertex_group, self.change),
        )


class FANTASIA3D_OT_restore_shape(bpy.types.Operator):
    """Move the vertices back to where they were before Edit Region moved some"""

    bl_idname = "fantasia3d.restore_shape"
    bl_label = "Restore Shape"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, new_shape.reason_against_restore(context.active_object))

    def execute(self, context: bpy.types.Context) -> set[str]:
        return run_and_report(self, lambda: new_shape.restore_shape(context.active_object))


class FANTASIA3D_PT_edit_region(ToolPanel, bpy.types.Panel):
    """Words for a part of an asset, and the way back."""

    bl_idname = "FANTASIA3D_PT_edit_region"
    bl_label = "Edit Region"
    bl_order = 21

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools, obj = self.layout, context.scene.fantasia3d_tools, context.active_object
        layout.use_property_split = True
        layout.use_property_decorate = False
        row = layout.row()
        row.use_property_split = False  # the three words fit in the whole width alone
        row.prop(tools, "region_change", expand=True)
        layout.prop(tools, "region_words", placeholder="red velvet")
        in_object_mode = obj is not None and obj.type == "MESH" and obj.mode == "OBJECT"
        if in_object_mode:
            layout.prop_search(tools, "region_group", obj, "vertex_groups")
        group = tools.region_group if in_object_mode else ""
        row = layout.row()
        row.enabled = bool(tools.region_words.strip())
        button = row.operator("fantasia3d.edit_region", icon="FACESEL")
        button.words, button.vertex_group = tools.region_words, group
        button.change = tools.region_change
        reason = edit_region.reason_against(context, group, tools.region_change)
        if reason:
            wrapped_label(layout, context, reason, "INFO", dimmed=True)
        elif tools.region_change != MAPS:
            wrapped_label(layout, context, LIMIT, "INFO", dimmed=True)
        if obj is not None and obj.mode == "OBJECT":
            _draw_restore(layout, obj)


def _draw_restore(layout: bpy.types.UILayout, obj: bpy.types.Object) -> None:
    """The ways back, where there is something to go back to."""
    column = layout.column(align=True)
    if obj.get(material_edit.KEPT) is not None:
        column.operator("fantasia3d.restore_material", text="Restore Material", icon="LOOP_BACK")
    if not new_shape.reason_against_restore(obj):
        column.operator("fantasia3d.restore_shape", icon="LOOP_BACK")


CLASSES = (FANTASIA3D_OT_edit_region, FANTASIA3D_OT_restore_shape, FANTASIA3D_PT_edit_region)
