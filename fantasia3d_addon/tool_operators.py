"""The tools' operators for light, material and the Cornell box. Each calls one function."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    StringProperty,
)

from . import (
    cornell_box,
    material_edit,
    material_library,
    relight,
)
from .errors import AddonError
from .tool_properties import TURNS

UNDO = {"REGISTER", "UNDO"}


class FANTASIA3D_OT_relight(bpy.types.Operator):
    """Light the scene by an HDR or EXR picture from all sides; its own world stays in the file"""

    bl_idname = "fantasia3d.relight"
    bl_label = "Relight"
    bl_options = UNDO

    light: StringProperty(
        name="Light", description="studio, one of Blender's by name, or a file", default="studio"
    )
    strength: FloatProperty(name="Strength", default=1.0, min=0.0, soft_max=10.0)
    rotation: FloatProperty(name="Rotation", subtype="ANGLE")

    def execute(self, context: bpy.types.Context) -> set[str]:
        turn = math.degrees(self.rotation)
        return told(self, lambda: relight.relight(context.scene, self.light, self.strength, turn))


class FANTASIA3D_OT_turntable(bpy.types.Operator):
    """Render the active asset in one full turn: an MP4 file, or PNG files in a folder"""

    bl_idname = "fantasia3d.turntable"
    bl_label = "Render Turntable"

    filepath: StringProperty(name="File", subtype="FILE_PATH", default="//turntable.mp4")
    filter_glob: StringProperty(default="*.mp4", options={"HIDDEN"})
    frames: IntProperty(name="Frames", default=48, min=2)
    turn: EnumProperty(name="Turn", items=TURNS)
    size: IntProperty(name="Size", default=640, min=16)
    samples: IntProperty(name="Samples", description="0: as many as needed", default=0, min=0)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context, "" if not rendering() else "A render is going on.")

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        out, obj = Path(bpy.path.abspath(self.filepath)), context.active_object
        options = {"frames": self.frames, "turn": self.turn, "size": self.size}
        if bpy.app.background:
            more = options | {"samples": self.samples or None}
            return told(self, lambda: relight.turntable(obj, out, **more))
        return told(self, lambda: _render_in_window(obj, out, self.samples or None, options))


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


class FANTASIA3D_OT_cornell_box(bpy.types.Operator):
    """Build a Cornell box around the selected assets, with its own light and camera"""

    bl_idname = "fantasia3d.cornell_box"
    bl_label = "Cornell Box"
    bl_options = UNDO

    height: FloatProperty(
        name="Height", description="0 fits the assets", subtype="DISTANCE", min=0.0
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        built = cornell_box.box_of(context.scene) is not None
        return allowed(cls, context, "This scene has a Cornell box." if built else "")

    def execute(self, context: bpy.types.Context) -> set[str]:
        meshes = [obj for obj in context.selected_objects if obj.type == "MESH"]
        return told(self, lambda: cornell_box.build(context.scene, meshes, self.height))


class FANTASIA3D_OT_remove_cornell_box(bpy.types.Operator):
    """Take the Cornell box away; the assets, the world and the camera are as before"""

    bl_idname = "fantasia3d.remove_cornell_box"
    bl_label = "Remove Cornell Box"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        cls.poll_message_set("This scene has no Cornell box.")
        return cornell_box.box_of(context.scene) is not None

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: cornell_box.remove(context.scene))


def reason_against(context: bpy.types.Context) -> str:
    """Why no tool can act on the active object; empty if one can."""
    if context.mode != "OBJECT":
        return "Leave the edit mode first."
    obj = context.active_object
    if obj is None or obj.type != "MESH":
        return "Click the mesh object that you mean."
    return "" if len(obj.data.polygons) else "The object has no faces."


def allowed(cls: type[bpy.types.Operator], context: bpy.types.Context, more: str = "") -> bool:
    """A poll that says why not; ``more`` is a reason of the operator's own."""
    reason = reason_against(context) or more
    cls.poll_message_set(reason)
    return not reason


def told(operator: bpy.types.Operator, act: Callable[[], object]) -> set[str]:
    """Do it; what the user can mend is told with its fix."""
    try:
        act()
    except AddonError as error:
        operator.report({"ERROR"}, str(error))
        return {"CANCELLED"}
    return {"FINISHED"}


def rendering() -> bool:
    """Whether a render job of this window is going on."""
    return not bpy.app.background and bpy.app.is_job_running("RENDER")


def _material_reason(context: bpy.types.Context) -> str:
    obj = context.active_object
    has = obj and material_edit.principled(obj.active_material)
    return "" if has else "Its material has no Principled BSDF."


def _render_in_window(
    obj: bpy.types.Object, out: Path, samples: int | None, options: dict[str, object]
) -> None:
    """Render as a job of Blender's, which leaves the window free, and clean up after it."""
    scene = relight.turntable_scene(obj, out, samples=samples, **options)
    name = scene.name
    bpy.ops.render.render("INVOKE_DEFAULT", animation=True, scene=name)

    def clean_up() -> float | None:
        if rendering():
            return 0.5
        made = bpy.data.scenes.get(name)
        if made:
            relight.forget(made)
        return None

    bpy.app.timers.register(clean_up, first_interval=2.0, persistent=True)


CLASSES = (
    FANTASIA3D_OT_relight,
    FANTASIA3D_OT_turntable,
    FANTASIA3D_OT_replace_material,
    FANTASIA3D_OT_restore_material,
    FANTASIA3D_OT_adjust_material,
    FANTASIA3D_OT_reset_material,
    FANTASIA3D_OT_cornell_box,
    FANTASIA3D_OT_remove_cornell_box,
)
