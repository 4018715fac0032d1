"""Light, turntable, Cornell box and placement by buttons. Each operator calls one function."""

from __future__ import annotations

import math
from pathlib import Path

import bpy
from bpy.props import (
    EnumProperty,
    FloatProperty,
    IntProperty,
    StringProperty,
)

from ..scene import cornell_box, placement, relight
from .operator_helpers import UNDO, allowed, rendering, told
from .tool_properties import TURNS


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


class FANTASIA3D_OT_drop(bpy.types.Operator):
    """Move the active asset down until it stands on what lies under it, or on the ground"""

    bl_idname = "fantasia3d.drop"
    bl_label = "Drop"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: placement.drop(context.active_object))


class FANTASIA3D_OT_origin_to_base(bpy.types.Operator):
    """Put the origin below the asset's middle, at its lowest point"""

    bl_idname = "fantasia3d.origin_to_base"
    bl_label = "Origin to Base"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: placement.origin_to_base(context.active_object))


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
    FANTASIA3D_OT_cornell_box,
    FANTASIA3D_OT_remove_cornell_box,
    FANTASIA3D_OT_drop,
    FANTASIA3D_OT_origin_to_base,
)
