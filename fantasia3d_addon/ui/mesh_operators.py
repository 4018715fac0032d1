"""The operators for mesh health, levels of detail and quads."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
from bpy.app.translations import pgettext_iface as translated
from bpy.props import EnumProperty

from .. import options
from ..background import blender_process
from ..blender.mesh_arrays import mesh_object
from ..mesh import health, remesh
from .modal_operator import ModalTask, reason_to_wait, wait_for
from .operator_helpers import UNDO, can_run, run_and_report
from .option_properties import option_property
from .text import in_language

ALL = "ALL"  # of the repairs
NOTHING = "Nothing to repair."
NO_SCALE = "The scale is not applied: other objects share the mesh."


class FANTASIA3D_OT_check_mesh(bpy.types.Operator):
    """Examine the active mesh, its UVs and its textures"""

    bl_idname = "fantasia3d.check_mesh"
    bl_label = "Check Mesh"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, changes=False)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return run_and_report(self, lambda: health.update_report(context.active_object))


class FANTASIA3D_OT_repair_mesh(bpy.types.Operator):
    """Repair the active mesh; the UVs stay"""

    bl_idname = "fantasia3d.repair_mesh"
    bl_label = "Repair All"
    bl_options = UNDO

    what: EnumProperty(
        name="Repair",
        description="What to repair",
        items=[
            (ALL, "All", "Every fault that was found"),
            *((name, *label_and_tip) for name, label_and_tip in health.REPAIRS.items()),
        ],
    )

    @classmethod
    def description(
        cls, context: bpy.types.Context, properties: bpy.types.OperatorProperties
    ) -> str:
        """The tooltip of a button for one repair."""
        return health.REPAIRS.get(properties.what, ("", cls.__doc__))[1]

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object
        what = None if self.what == ALL else self.what

        def repair() -> None:
            done = health.repair(obj, what)
            names = ", ".join(translated(health.REPAIRS[name][0]) for name in done)
            text = f"{translated('Repaired')}: {names}." if names else NOTHING
            if "SCALE" in health.update_report(obj).faults and what is None:
                text += f" {NO_SCALE}"
            self.report({"INFO"}, in_language(text))

        return run_and_report(self, repair)


class FANTASIA3D_OT_make_lods(bpy.types.Operator):
    """Create levels of detail, each with fewer faces; the UVs are kept"""

    bl_idname = "fantasia3d.make_lods"
    bl_label = "Create LODs"
    bl_options = UNDO

    levels: option_property(options.LEVELS)
    ratio: option_property(options.RATIO)
    max_faces: option_property(options.MAX_FACES)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object
        settings = {"levels": self.levels, "ratio": self.ratio, "max_faces": self.max_faces}
        return run_and_report(self, lambda: remesh.make_lods(obj, **settings))


class FANTASIA3D_OT_quad_remesh(ModalTask, bpy.types.Operator):
    """Create a quad mesh of the active asset, with its own UVs and the maps baked onto it"""

    bl_idname = "fantasia3d.quad_remesh"
    bl_label = "Quad Remesh"
    bl_options = UNDO
    title, pause, shares_window = "Quad remesh", 0.1, True

    faces: option_property(options.QUADS)
    texture_size: option_property(options.BAKE_SIZE)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, reason_to_wait())

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object

        def create() -> None:
            _select_instead(context, remesh.quad_remesh(obj, self.faces, self.texture_size), obj)

        return run_and_report(self, create)

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        name = context.active_object.name
        settings = {"faces": self.faces, "size": self.texture_size}
        task = blender_process.start(context.active_object, "quads", **settings)
        yield from wait_for(task)
        quads = blender_process.load_objects(task.result)[0]
        # By name: meanwhile the user may have removed the object, or undone a step.
        obj = mesh_object(bpy.data.objects.get(name))
        remesh.place_like(quads, obj)
        _select_instead(context, quads, obj)
        remesh.hide(obj)


def _select_instead(
    context: bpy.types.Context, new: bpy.types.Object, old: bpy.types.Object
) -> None:
    """Select ``new`` and deselect ``old``."""
    old.select_set(False)
    new.select_set(True)
    context.view_layer.objects.active = new


CLASSES = (
    FANTASIA3D_OT_check_mesh,
    FANTASIA3D_OT_repair_mesh,
    FANTASIA3D_OT_make_lods,
    FANTASIA3D_OT_quad_remesh,
)
