"""The menu of the models that are on this machine."""

import bpy
from bpy.props import StringProperty

from ..jobs import models
from ..jobs.session import session
from .operator_helpers import USER_ERRORS, report_error
from .text import in_language


class FANTASIA3D_OT_find_models(bpy.types.Operator):
    """Look again for models in the folders of the preferences; opens no weights"""

    bl_idname = "fantasia3d.find_models"
    bl_label = "Find Models"
    bl_options = {"INTERNAL"}

    def execute(self, _context: bpy.types.Context) -> set[str]:
        try:
            session.find_models()
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_choose_model(bpy.types.Operator):
    """Use this model"""

    bl_idname = "fantasia3d.choose_model"
    bl_label = "Choose Model"
    bl_options = {"UNDO", "INTERNAL"}

    path: StringProperty(name="Model", description="The file or the folder of the model")
    kind: StringProperty(name="Kind", description="What the model is")
    reason: StringProperty(name="Reason", description="Why the model cannot be used")

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.AnyType) -> str:
        return properties.reason or properties.path

    def execute(self, context: bpy.types.Context) -> set[str]:
        settings = context.scene.fantasia3d
        if self.kind == models.LORA:
            settings.lora = self.path
        elif self.kind == models.EMBEDDING:
            settings.embedding = self.path
        else:
            settings.guidance, settings.model_folder = "folder", self.path
        return {"FINISHED"}


class FANTASIA3D_MT_models(bpy.types.Menu):
    """The Stable Diffusion models on this machine, and why some cannot be used"""

    bl_idname = "FANTASIA3D_MT_models"
    bl_label = "Models on This Machine"

    def draw(self, _context: bpy.types.Context) -> None:
        try:
            found = session.found_models()
        except USER_ERRORS as error:
            self.layout.label(text=in_language(str(error)), icon="ERROR", translate=False)
            return
        if found is None:
            self.layout.label(text="Looking for models…")
            return
        if not found:
            self.layout.label(text="No models found")
        fits = models.usable(found)
        for model in [*fits, *(m for m in found if m["reason"])]:
            row = self.layout.row()
            row.enabled = not model["reason"]
            icon = "ERROR" if model["reason"] else "FILE_3D"
            text = models.label(model)
            button = row.operator("fantasia3d.choose_model", text=text, icon=icon, translate=False)
            button.path, button.kind, button.reason = model["path"], model["kind"], model["reason"]
        self.layout.separator()
        self.layout.operator("fantasia3d.find_models", icon="FILE_REFRESH")


CLASSES = (FANTASIA3D_OT_find_models, FANTASIA3D_OT_choose_model, FANTASIA3D_MT_models)
