"""Simulations by buttons: a frame at a time, so that Escape stops them."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
)

from ..physics import simulation
from .modal_operator import Stepwise
from .operator_helpers import UNDO, allowed, told
from .tool_properties import KINDS


class FANTASIA3D_OT_simulate(Stepwise, bpy.types.Operator):
    """Simulate the active asset and bake it; what lies under it holds it up"""

    bl_idname = "fantasia3d.simulate"
    bl_label = "Simulate"
    bl_options = UNDO
    word = "Simulating"

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

    def chosen(self) -> simulation.Options:
        """The operator's properties."""
        return simulation.Options(
            frames=self.frames, height=self.height, convex=self.convex, softness=self.softness,
            self_collision=self.self_collision,
        )  # fmt: skip

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(
            self, lambda: simulation.simulate(context.active_object, self.kind, self.chosen())
        )

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        steps = simulation.steps(context.active_object, self.kind, self.chosen())
        with contextlib.closing(steps):  # given up, it takes back what it began
            for share in steps:
                yield self.kind.capitalize(), share


class FANTASIA3D_OT_clear_simulation(bpy.types.Operator):
    """Take the simulation away, and what was made for it; the asset stands as before"""

    bl_idname = "fantasia3d.clear_simulation"
    bl_label = "Remove Simulation"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        obj = context.active_object
        simulated = obj is not None and simulation.is_simulated(obj)
        return allowed(cls, context, "" if simulated else "It is not simulated.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: simulation.clear(context.active_object))


CLASSES = (
    FANTASIA3D_OT_simulate,
    FANTASIA3D_OT_clear_simulation,
)
