"""The tools' operators for the mesh and for what leaves the file. Each calls one function."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from . import exports, health, placement, remesh
from .tool_operators import UNDO, allowed, told
from .tool_properties import FORMATS


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


class FANTASIA3D_OT_export(bpy.types.Operator):
    """Write the active asset as one file for elsewhere, with textures that open there"""

    bl_idname = "fantasia3d.export"
    bl_label = "Export"

    filepath: StringProperty(name="File", subtype="FILE_PATH")
    filter_glob: StringProperty(
        default="*.glb;*.usd;*.usdc;*.usda;*.usdz;*.fbx;*.obj", options={"HIDDEN"}
    )
    format: EnumProperty(name="Format", description="Where the file has no ending", items=FORMATS)
    flip_normal_y: BoolProperty(name="DirectX Normals")

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        return allowed(cls, context)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        self.filepath = f"{bpy.path.clean_name(context.active_object.name)}.{self.format}"
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        path = Path(bpy.path.abspath(self.filepath))
        path = path if path.suffix else path.with_suffix(f".{self.format}")
        obj = context.active_object
        return told(self, lambda: exports.export_object(obj, path, self.flip_normal_y))


CLASSES = (
    FANTASIA3D_OT_drop,
    FANTASIA3D_OT_origin_to_base,
    FANTASIA3D_OT_make_lods,
    FANTASIA3D_OT_repair_mesh,
    FANTASIA3D_OT_check_mesh,
    FANTASIA3D_OT_export,
)
