"""Files for other programs and entries of the Asset Browser by buttons."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    StringProperty,
)

from ..background import blender_process
from ..blender.mesh_arrays import mesh_object
from ..mesh import asset_browser, export
from .modal_operator import Stepwise, until_done
from .operator_helpers import UNDO, allowed, told
from .tool_properties import FORMATS


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
        return told(self, lambda: export.export_object(obj, path, self.flip_normal_y))


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
            work = blender_process.send(context.active_object, "thumbnail")
            yield from until_done(work)
            picture = blender_process.pixels(work.result)
            asset_browser.set_preview(mesh_object(bpy.data.objects.get(name)), picture)
        self._save(mesh_object(bpy.data.objects.get(name)))

    def _save(self, obj: bpy.types.Object) -> None:
        if self.library:
            asset_browser.save_to_library(obj, Path(bpy.path.abspath(self.library)))


CLASSES = (
    FANTASIA3D_OT_export,
    FANTASIA3D_OT_mark_asset,
)
