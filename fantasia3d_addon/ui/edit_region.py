"""The operator and the panel of a region's new material."""

from __future__ import annotations

import bpy
from bpy.props import StringProperty

from ..jobs import edit_region
from .operator_helpers import queue_job
from .text import wrapped_label
from .tools_panel import ToolPanel

WORDS = "What the faces become, such as: red velvet"
GROUP = "The vertex group whose faces are edited in Object Mode; empty: the active one"


class FANTASIA3D_OT_edit_region(bpy.types.Operator):
    """Generate another material for the selected faces, or for a vertex group; the rest stays"""

    bl_idname = "fantasia3d.edit_region"
    bl_label = "Edit Region"

    # SKIP_SAVE: from a menu it asks for the words, and does not take those of the last time.
    words: StringProperty(name="Words", description=WORDS, options={"SKIP_SAVE"})
    vertex_group: StringProperty(name="Vertex Group", description=GROUP, options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        reason = edit_region.reason_against(context)
        cls.poll_message_set(reason)
        return not reason

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if self.properties.is_property_set("words") and self.words.strip():
            return self.execute(context)  # the panel's button: they were entered there
        self.words = context.scene.fantasia3d_tools.region_words
        return context.window_manager.invoke_props_dialog(self, width=400)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return queue_job(
            self, lambda: edit_region.edit_region(context, self.words, self.vertex_group)
        )


class FANTASIA3D_PT_edit_region(ToolPanel, bpy.types.Panel):
    """Words for a part of an asset."""

    bl_idname = "FANTASIA3D_PT_edit_region"
    bl_label = "Edit Region"
    bl_order = 21

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools, obj = self.layout, context.scene.fantasia3d_tools, context.active_object
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(tools, "region_words", placeholder="red velvet")
        in_object_mode = obj is not None and obj.type == "MESH" and obj.mode == "OBJECT"
        if in_object_mode:
            layout.prop_search(tools, "region_group", obj, "vertex_groups")
        group = tools.region_group if in_object_mode else ""
        row = layout.row()
        row.enabled = bool(tools.region_words.strip())
        button = row.operator("fantasia3d.edit_region", icon="FACESEL")
        button.words, button.vertex_group = tools.region_words, group
        reason = edit_region.reason_against(context, group)
        if reason:
            wrapped_label(layout, context, reason, "INFO", dimmed=True)


CLASSES = (FANTASIA3D_OT_edit_region, FANTASIA3D_PT_edit_region)
