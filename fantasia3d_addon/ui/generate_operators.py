"""The main panel's operators: each reads properties, calls one function, and reports."""

from __future__ import annotations

import random
from pathlib import Path

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty

from ..blender.mesh_arrays import EDIT_MODE
from ..jobs import history, live_preview, submit
from ..jobs.import_result import mark_imported
from ..jobs.session import session
from ..scene import view
from .operator_helpers import (
    USER_ERRORS,
    allowed,
    import_and_select,
    needs,
    queue_job,
    report_error,
)


class FANTASIA3D_OT_generate(bpy.types.Operator):
    """Generate a textured mesh from the prompt, in the background"""

    bl_idname = "fantasia3d.generate"
    bl_label = "Generate with the Panel's Prompt"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return allowed(cls, submit.reason_against_generate(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        return queue_job(self, lambda: submit.generate(context))


class FANTASIA3D_OT_generate_prompt(bpy.types.Operator):
    """Enter a prompt and generate its textured mesh, with the panel's other settings"""

    bl_idname = "fantasia3d.generate_prompt"
    bl_label = "Generate from Text"

    prompt: StringProperty(name="Prompt", description="What to make, such as: a red wooden chair")

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return allowed(cls, submit.reason_against_jobs(context))

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        self.prompt = context.scene.fantasia3d.prompt
        return context.window_manager.invoke_props_dialog(self, width=400)

    def execute(self, context: bpy.types.Context) -> set[str]:
        context.scene.fantasia3d.prompt = self.prompt or context.scene.fantasia3d.prompt
        return queue_job(self, lambda: submit.generate(context))


class FANTASIA3D_OT_texture(bpy.types.Operator):
    """Generate a material for the active mesh from the prompt, in the background"""

    bl_idname = "fantasia3d.texture"
    bl_label = "Texture Selected Mesh"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return allowed(cls, submit.reason_against_texture(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        return queue_job(self, lambda: submit.texture(context))


class FANTASIA3D_OT_cancel(bpy.types.Operator):
    """Stop after the present step; the run can be resumed"""

    bl_idname = "fantasia3d.cancel"
    bl_label = "Cancel Job"

    run: StringProperty(name="Run", description="Name of the run folder; empty: the first run")

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, session.running, "No job is running.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        session.cancel(self.run)
        return {"FINISHED"}


class FANTASIA3D_OT_local_view(bpy.types.Operator):
    """Show the preview of the running job alone in this view, or everything again"""

    bl_idname = "fantasia3d.local_view"
    bl_label = "Preview in Local View"

    run: StringProperty(name="Run", description="Name of the run folder; empty: the first run")

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        reason = "" if live_preview.any_shown() else "There is no preview."
        if context.area is None or context.area.type != "VIEW_3D":
            reason = "Use it in a 3D view."
        return allowed(cls, reason)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = live_preview.find(self.run) or live_preview.any_shown()
        view.toggle_local_view(context.area, context.window, obj)
        return {"FINISHED"}


class FANTASIA3D_OT_show_colors(bpy.types.Operator):
    """Show the assets' materials in this view, which is in Solid shading without their colours"""

    bl_idname = "fantasia3d.show_colors"
    bl_label = "Show Colors"
    bl_options = {"UNDO"}

    shading: EnumProperty(
        name="Shading",
        description="How the view shows the materials",
        items=(
            ("MATERIAL", "Material Preview", "The whole material under a studio light"),
            ("TEXTURE", "Texture Color", "Solid shading with the base colour: faster"),
        ),
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        is_view = context.area is not None and context.area.type == "VIEW_3D"
        return needs(cls, is_view, "Use it in a 3D view.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        view.show_colors(context.space_data, in_solid=self.shading == "TEXTURE")
        return {"FINISHED"}


class FANTASIA3D_OT_stop_now(bpy.types.Operator):
    """End a process whose cancel takes long; the run resumes from its last checkpoint"""

    bl_idname = "fantasia3d.stop_now"
    bl_label = "Stop Job Now"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        is_cancelled = any(followed.progress.cancelling for followed in session.running)
        return needs(cls, is_cancelled, "Press Cancel first.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        session.kill()
        return {"FINISHED"}


class FANTASIA3D_OT_dismiss(bpy.types.Operator):
    """Hide the message"""

    bl_idname = "fantasia3d.dismiss"
    bl_label = "Dismiss Message"

    def execute(self, context: bpy.types.Context) -> set[str]:
        session.error, session.last, session.asset = None, None, ""
        for entry in session.missed:
            mark_imported(entry.folder)  # it is not offered again at the next start
        session.missed.clear()
        return {"FINISHED"}


class FANTASIA3D_OT_import_asset(bpy.types.Operator):
    """Import an asset folder into the scene"""

    bl_idname = "fantasia3d.import_asset"
    bl_label = "Import Asset"
    bl_options = {"REGISTER", "UNDO"}

    directory: StringProperty(
        name="Folder", description="An asset folder, or the run folder around it",
        subtype="DIR_PATH",
    )  # fmt: skip
    filter_folder: BoolProperty(default=True, options={"HIDDEN"})  # the file browser's own filter

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, context.mode == "OBJECT", EDIT_MODE)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            import_and_select(context, Path(bpy.path.abspath(self.directory)))
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_new_seed(bpy.types.Operator):
    """Choose another seed at random"""

    bl_idname = "fantasia3d.new_seed"
    bl_label = "New Seed"
    bl_options = {"UNDO"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        context.scene.fantasia3d.seed = random.randrange(history.SEEDS)
        return {"FINISHED"}


class FANTASIA3D_OT_guide_from_selection(bpy.types.Operator):
    """Use the active mesh as the shape to start from"""

    bl_idname = "fantasia3d.guide_from_selection"
    bl_label = "Use Selected Mesh as Guide"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        obj = context.active_object
        return needs(cls, obj is not None and obj.type == "MESH", "Select a mesh.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        context.scene.fantasia3d.guide = context.active_object
        return {"FINISHED"}


class FANTASIA3D_OT_open_log(bpy.types.Operator):
    """Open the log of the last run"""

    bl_idname = "fantasia3d.open_log"
    bl_label = "Open Job's Log"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, session.log is not None, "There is no log yet.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        return bpy.ops.wm.path_open(filepath=str(session.log))


CLASSES = (
    FANTASIA3D_OT_generate,
    FANTASIA3D_OT_generate_prompt,
    FANTASIA3D_OT_texture,
    FANTASIA3D_OT_cancel,
    FANTASIA3D_OT_local_view,
    FANTASIA3D_OT_show_colors,
    FANTASIA3D_OT_stop_now,
    FANTASIA3D_OT_dismiss,
    FANTASIA3D_OT_import_asset,
    FANTASIA3D_OT_new_seed,
    FANTASIA3D_OT_guide_from_selection,
    FANTASIA3D_OT_open_log,
)
