"""The operators for simulations."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import bpy

from .. import options
from ..physics import simulation
from .modal_operator import ModalTask, reason_to_wait
from .operator_helpers import UNDO, can_run, run_and_report
from .option_properties import option_property
from .text import in_language


class FANTASIA3D_OT_simulate(ModalTask, bpy.types.Operator):
    """Simulate the active asset and bake it; it falls onto what is below it"""

    bl_idname = "fantasia3d.simulate"
    bl_label = "Simulate"
    bl_options = UNDO
    title = "Simulating"

    kind: option_property(options.KIND)
    frames: option_property(options.FRAMES)
    height: option_property(options.HEIGHT)
    convex: option_property(options.CONVEX)
    softness: option_property(options.SOFTNESS)
    self_collision: option_property(options.SELF_COLLISION)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, reason_to_wait())

    def settings(self) -> simulation.Options:
        """The operator's properties."""
        return simulation.Options(
            **{option.name: getattr(self, option.name) for option in options.SIMULATION}
        )

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object

        def simulate() -> None:
            simulation.simulate(obj, self.kind, self.settings())
            self.report_note(obj)

        return run_and_report(self, simulate)

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        steps = simulation.steps(context.active_object, self.kind, self.settings())
        with contextlib.closing(steps):  # cancelled, it removes what it has made
            for fraction in steps:
                yield self.kind.capitalize(), fraction
        self.report_note(context.active_object)

    def report_note(self, obj: bpy.types.Object) -> None:
        note = simulation.note_of(obj, self.kind, self.settings())
        if note:
            self.report({"INFO"}, in_language(note))


class FANTASIA3D_OT_clear_simulation(bpy.types.Operator):
    """Remove the simulation and what was made for it; the asset is as before"""

    bl_idname = "fantasia3d.clear_simulation"
    bl_label = "Remove Simulation"
    bl_options = UNDO

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        obj = context.active_object
        simulated = obj is not None and simulation.is_simulated(obj)
        return can_run(cls, context, "" if simulated else "It is not simulated.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        return run_and_report(self, lambda: simulation.clear(context.active_object))


CLASSES = (FANTASIA3D_OT_simulate, FANTASIA3D_OT_clear_simulation)
