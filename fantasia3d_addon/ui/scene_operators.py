"""The operators for light, turntable, Cornell box and placement. Each calls one function."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import bpy
from bpy.props import BoolProperty, StringProperty

from .. import options
from ..errors import AddonError
from ..jobs.panels import redraw
from ..jobs.session import session
from ..scene import cornell_box, placement, relight
from .operator_helpers import UNDO, can_run, needs, rendering, run_and_report
from .option_properties import option_property


class FANTASIA3D_OT_relight(bpy.types.Operator):
    """Light the scene by an HDR or EXR picture; the scene's own world stays in the file"""

    bl_idname = "fantasia3d.relight"
    bl_label = "Apply Lighting"
    bl_options = UNDO

    light: StringProperty(
        name="Light", description="studio, one of Blender's by name, or a file", default="studio"
    )
    filepath: StringProperty(
        name="File", description="An HDR or EXR picture instead of the named light",
        subtype="FILE_PATH", options={"SKIP_SAVE"},
    )  # fmt: skip
    strength: option_property(options.STRENGTH)
    rotation: option_property(options.ROTATION)

    def execute(self, context: bpy.types.Context) -> set[str]:
        turn, name = math.degrees(self.rotation), bpy.path.abspath(self.filepath) or self.light
        return run_and_report(
            self, lambda: relight.relight(context.scene, name, self.strength, turn)
        )


class FANTASIA3D_OT_turntable(bpy.types.Operator):
    """Render the active asset in one full turn: an MP4 file, or PNG files in a folder"""

    bl_idname = "fantasia3d.turntable"
    bl_label = "Render Turntable"

    filepath: StringProperty(
        name="File", description="An MP4 file, or a folder for PNG files", subtype="FILE_PATH",
        default="//turntable.mp4",
    )  # fmt: skip
    filter_glob: StringProperty(default="*.mp4", options={"HIDDEN"})
    # Blender's file browser then warns of a file that would be replaced.
    check_existing: BoolProperty(default=True, options={"HIDDEN"})
    frames: option_property(options.TURN_FRAMES)
    turn: option_property(options.TURN)
    size: option_property(options.SIZE)
    samples: option_property(options.SAMPLES)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, "A render is running." if rendering() else "", changes=False)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        out, obj = Path(bpy.path.abspath(self.filepath)), context.active_object
        settings = {name: getattr(self, name) for name in ("frames", "turn", "size", "samples")}
        render = relight.turntable if bpy.app.background else _render_in_window
        return run_and_report(self, lambda: render(obj, out, **settings))


class FANTASIA3D_OT_cornell_box(bpy.types.Operator):
    """Build a Cornell box around the selected assets, with its own light and camera"""

    bl_idname = "fantasia3d.cornell_box"
    bl_label = "Cornell Box"
    bl_options = UNDO

    height: option_property(options.BOX_HEIGHT)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        built = cornell_box.box_of(context.scene) is not None
        return can_run(cls, context, "This scene has a Cornell box already." if built else "")

    def execute(self, context: bpy.types.Context) -> set[str]:
        meshes = [obj for obj in context.selected_objects if obj.type == "MESH"]
        return run_and_report(self, lambda: cornell_box.build(context.scene, meshes, self.height))


class FANTASIA3D_OT_remove_cornell_box(bpy.types.Operator):
    """Remove the Cornell box; the assets, the world and the camera are as before"""

    bl_idname = "fantasia3d.remove_cornell_box"
    bl_label = "Remove Cornell Box"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(
            cls, cornell_box.box_of(context.scene) is not None, "This scene has no Cornell box."
        )

    def execute(self, context: bpy.types.Context) -> set[str]:
        return run_and_report(self, lambda: cornell_box.remove(context.scene))


class FANTASIA3D_OT_drop(bpy.types.Operator):
    """Move the active asset down onto the surface below it, or onto the ground at z = 0"""

    bl_idname = "fantasia3d.drop"
    bl_label = "Drop to Surface"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return run_and_report(self, lambda: placement.drop(context.active_object))


class FANTASIA3D_OT_origin_to_base(bpy.types.Operator):
    """Set the origin to the lowest point, below the asset's centre"""

    bl_idname = "fantasia3d.origin_to_base"
    bl_label = "Set Origin to Base"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return run_and_report(self, lambda: placement.origin_to_base(context.active_object))


def _render_in_window(obj: bpy.types.Object, out: Path, **settings: object) -> None:
    """Render as a job of Blender, which leaves the window responsive, and clean up afterwards."""
    steps = _window_steps(obj, out, settings)
    next(steps)  # an error before the render is the operator's

    def go_on() -> float | None:
        try:
            next(steps)
        except StopIteration:
            return None
        except AddonError as error:
            session.error = (error.text, error.fix)
            redraw()
            return None
        return 0.5

    # 2 s: the job must have started before it is looked at.
    bpy.app.timers.register(go_on, first_interval=2.0, persistent=True)


def _window_steps(obj: bpy.types.Object, out: Path, settings: dict[str, Any]) -> Iterator[None]:
    """Yields while the job runs. A cancelled one leaves an older file as it is."""
    ended: list[bool] = []  # whether the job has come to its end

    def on_end(*_: object) -> None:
        ended.append(True)

    with contextlib.suppress(_CancelledError), relight.whole_turntable(out) as temporary:
        name = relight.turntable_scene(obj, temporary, **settings).name
        handlers = bpy.app.handlers.render_complete
        handlers.append(on_end)
        try:
            _start_render(name)
            yield
            while rendering():
                yield
        finally:
            # Another file that was opened meanwhile has removed it.
            with contextlib.suppress(ValueError):
                handlers.remove(on_end)
            # By name: a reference to a datablock does not survive an undo.
            scene = bpy.data.scenes.get(name)
            if scene:
                relight.remove_turntable_scene(scene)
        if not ended:
            raise _CancelledError


class _CancelledError(Exception):
    """The user has cancelled the render, or Blender could not write it."""


def _start_render(name: str) -> None:
    bpy.ops.render.render("INVOKE_DEFAULT", animation=True, scene=name)


CLASSES = (
    FANTASIA3D_OT_relight,
    FANTASIA3D_OT_turntable,
    FANTASIA3D_OT_cornell_box,
    FANTASIA3D_OT_remove_cornell_box,
    FANTASIA3D_OT_drop,
    FANTASIA3D_OT_origin_to_base,
)
