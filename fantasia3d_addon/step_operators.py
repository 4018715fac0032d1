"""Operators that take a while: in a window they go on a step at a time, Escape stops them."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from . import physics, remesh
from .errors import AddonError
from .tool_operators import UNDO, allowed, told
from .tool_properties import KINDS


class FANTASIA3D_OT_simulate(bpy.types.Operator):
    """Simulate the active asset and bake it; what lies under it holds it up"""

    bl_idname = "fantasia3d.simulate"
    bl_label = "Simulate"
    bl_options = UNDO

    kind: EnumProperty(name="Simulation", items=KINDS)
    frames: IntProperty(name="Frames", default=60, min=2, max=5000)
    height: FloatProperty(name="Height", default=0.5, min=0.0, subtype="DISTANCE")
    convex: BoolProperty(name="One Convex Hull")
    softness: FloatProperty(name="Softness", default=0.5, min=0.0, max=1.0, subtype="FACTOR")
    self_collision: BoolProperty(name="Self Collision")

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def chosen(self) -> physics.Options:
        """The operator's properties."""
        return physics.Options(
            frames=self.frames, height=self.height, convex=self.convex, softness=self.softness,
            self_collision=self.self_collision,
        )  # fmt: skip

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: physics.simulate(context.active_object, self.kind, self.chosen()))

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        self._steps: Iterator[float] = physics.steps(
            context.active_object, self.kind, self.chosen()
        )
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self._timer = manager.event_timer_add(0.01, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        """One frame for each tick of the timer."""
        if event.type == "ESC":
            self._steps.close()
            return self._end(context, {"CANCELLED"})
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}
        try:
            share = next(self._steps)
        except StopIteration:
            return self._end(context, {"FINISHED"})
        except AddonError as error:
            self.report({"ERROR"}, str(error))
            return self._end(context, {"CANCELLED"})
        context.window_manager.progress_update(100 * share)
        context.workspace.status_text_set(f"Simulating {share:.0%}    Esc: stop")
        return {"RUNNING_MODAL"}

    def _end(self, context: bpy.types.Context, status: set[str]) -> set[str]:
        context.workspace.status_text_set(None)
        context.window_manager.progress_end()
        context.window_manager.event_timer_remove(self._timer)
        return status


class FANTASIA3D_OT_clear_simulation(bpy.types.Operator):
    """Take the simulation away, and what was made for it; the asset stands as before"""

    bl_idname = "fantasia3d.clear_simulation"
    bl_label = "Remove Simulation"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        obj = context.active_object
        simulated = obj is not None and physics.is_simulated(obj)
        return allowed(cls, context, "" if simulated else "It is not simulated.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: physics.clear(context.active_object))


class FANTASIA3D_OT_quad_remesh(bpy.types.Operator):
    """Make a mesh of quads like the active asset, with UVs of its own and the maps baked over"""

    bl_idname = "fantasia3d.quad_remesh"
    bl_label = "Quad Remesh"
    bl_options = UNDO

    faces: IntProperty(name="Quads", default=4000, min=100)
    texture_size: IntProperty(name="Texture Size", description="0: as now", default=0, min=0)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object

        def make() -> None:
            quads = remesh.quad_remesh(obj, self.faces, self.texture_size)
            obj.select_set(False)
            quads.select_set(True)
            context.view_layer.objects.active = quads

        return told(self, make)


CLASSES = (
    FANTASIA3D_OT_simulate,
    FANTASIA3D_OT_clear_simulation,
    FANTASIA3D_OT_quad_remesh,
)
