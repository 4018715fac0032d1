"""Operators that take seconds: simulations, quads, the entry of the Asset Browser."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from . import asset_browser, errand, physics, remesh
from .mesh_data import mesh_object
from .stepwise import Stepwise, until_done
from .tool_operators import UNDO, allowed, told
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

    def chosen(self) -> physics.Options:
        """The operator's properties."""
        return physics.Options(
            frames=self.frames, height=self.height, convex=self.convex, softness=self.softness,
            self_collision=self.self_collision,
        )  # fmt: skip

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: physics.simulate(context.active_object, self.kind, self.chosen()))

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        steps = physics.steps(context.active_object, self.kind, self.chosen())
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
        simulated = obj is not None and physics.is_simulated(obj)
        return allowed(cls, context, "" if simulated else "It is not simulated.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        return told(self, lambda: physics.clear(context.active_object))


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
        work = errand.send(context.active_object, "quads", **options)
        yield from until_done(work)
        quads = errand.objects(work.result)[0]
        obj = mesh_object(bpy.data.objects.get(name))
        remesh.put_beside(quads, obj)
        _choose(context, quads, obj)
        remesh.hide(obj)


class FANTASIA3D_OT_mark_asset(Stepwise, bpy.types.Operator):
    """Make the active asset an entry of the Asset Browser, with a thumbnail and tags"""

    bl_idname = "fantasia3d.mark_asset"
    bl_label = "To Asset Browser"
    bl_options = UNDO
    word, pause, shares_window = "Thumbnail", 0.1, True

    tags: StringProperty(name="Tags", description="With commas between", default="generated")
    library: StringProperty(
        name="Library", description="A library's folder to save it into; empty for this file alone",
        subtype="DIR_PATH",
    )  # fmt: skip
    thumbnail: BoolProperty(name="Render Thumbnail", default=True)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object

        def mark() -> None:
            asset_browser.mark_asset(obj, self.tags.split(","), thumbnail=self.thumbnail)
            self._save(obj)

        return told(self, mark)

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        name = context.active_object.name
        asset_browser.mark_asset(context.active_object, self.tags.split(","), thumbnail=False)
        if self.thumbnail:
            work = errand.send(context.active_object, "thumbnail")
            yield from until_done(work)
            picture = errand.pixels(work.result)
            asset_browser.set_preview(mesh_object(bpy.data.objects.get(name)), picture)
        self._save(mesh_object(bpy.data.objects.get(name)))

    def _save(self, obj: bpy.types.Object) -> None:
        if self.library:
            asset_browser.save_to_library(obj, Path(bpy.path.abspath(self.library)))


def _choose(context: bpy.types.Context, new: bpy.types.Object, old: bpy.types.Object) -> None:
    """Select ``new`` instead of ``old``."""
    old.select_set(False)
    new.select_set(True)
    context.view_layer.objects.active = new


CLASSES = (
    FANTASIA3D_OT_simulate,
    FANTASIA3D_OT_clear_simulation,
    FANTASIA3D_OT_quad_remesh,
    FANTASIA3D_OT_mark_asset,
)
