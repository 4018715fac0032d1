"""Mesh health, levels of detail and quads by buttons. Each operator calls one function."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
from bpy.props import (
    EnumProperty,
    FloatProperty,
    IntProperty,
)

from ..background import blender_process
from ..blender.mesh_arrays import mesh_object
from ..mesh import health, remesh
from .modal_operator import Stepwise, until_done
from .operator_helpers import UNDO, allowed, told


class FANTASIA3D_OT_check_mesh(bpy.types.Operator):
    """Look at the active mesh, its UVs and its textures"""

    bl_idname = "fantasia3d.check_mesh"
    bl_label = "Check Mesh"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: health.remember(context.active_object))


class FANTASIA3D_OT_repair_mesh(bpy.types.Operator):
    """Mend the active mesh; the UVs stay"""

    bl_idname = "fantasia3d.repair_mesh"
    bl_label = "Repair All"
    bl_options = UNDO

    what: EnumProperty(
        name="Repair",
        items=[
            ("ALL", "All", "Everything that is wrong"),
            *((name, *about) for name, about in health.REPAIRS.items()),
        ],
    )

    @classmethod
    def description(
        cls, context: bpy.types.Context, properties: bpy.types.OperatorProperties
    ) -> str:
        """What the button would mend."""
        return health.REPAIRS.get(properties.what, ("", cls.__doc__))[1]

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object
        what = None if self.what == "ALL" else self.what

        def mend() -> None:
            done = health.repair(obj, what)
            names = ", ".join(health.REPAIRS[name][0] for name in done)
            self.report({"INFO"}, f"Done: {names}." if names else "There was nothing to mend.")
            health.remember(obj)

        return told(self, mend)


class FANTASIA3D_OT_make_lods(bpy.types.Operator):
    """Make levels of detail with fewer and fewer faces, the UVs kept"""

    bl_idname = "fantasia3d.make_lods"
    bl_label = "Make LODs"
    bl_options = UNDO

    levels: IntProperty(name="Levels", default=3, min=1, max=8)
    ratio: FloatProperty(name="Ratio", default=0.5, min=0.05, max=0.95, subtype="FACTOR")

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object
        return told(self, lambda: remesh.make_lods(obj, self.levels, self.ratio))


class FANTASIA3D_OT_quad_remesh(Stepwise, bpy.types.Operator):
    """Make a mesh of quads like the active asset, with UVs of its own and the maps baked over"""

    bl_idname = "fantasia3d.quad_remesh"
    bl_label = "Quad Remesh"
    bl_options = UNDO
    word, pause, shares_window = "Quad remesh", 0.1, True

    faces: IntProperty(name="Quads", default=4000, min=100)
    texture_size: IntProperty(name="Texture Size", description="0: as now", default=0, min=0)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object

        def make() -> None:
            _choose(context, remesh.quad_remesh(obj, self.faces, self.texture_size), obj)

        return told(self, make)

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        name = context.active_object.name
        options = {"faces": self.faces, "size": self.texture_size}
        work = blender_process.send(context.active_object, "quads", **options)
        yield from until_done(work)
        quads = blender_process.objects(work.result)[0]
        obj = mesh_object(bpy.data.objects.get(name))
        remesh.put_beside(quads, obj)
        _choose(context, quads, obj)
        remesh.hide(obj)


def _choose(context: bpy.types.Context, new: bpy.types.Object, old: bpy.types.Object) -> None:
    """Select ``new`` instead of ``old``."""
    old.select_set(False)
    new.select_set(True)
    context.view_layer.objects.active = new


CLASSES = (
    FANTASIA3D_OT_check_mesh,
    FANTASIA3D_OT_repair_mesh,
    FANTASIA3D_OT_make_lods,
    FANTASIA3D_OT_quad_remesh,
)
