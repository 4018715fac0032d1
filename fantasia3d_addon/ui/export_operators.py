"""The operators for files of other programs and for entries of the Asset Browser."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty

from .. import options
from ..background import blender_process
from ..blender.mesh_arrays import mesh_object
from ..jobs import print_export
from ..jobs.paths import Paths
from ..mesh import asset_browser, engines, export
from .modal_operator import ModalTask, reason_to_wait, wait_for
from .operator_helpers import UNDO, can_run, run_and_report
from .option_properties import option_property


class FANTASIA3D_OT_export(bpy.types.Operator):
    """Export the active asset as one file for another program, with its textures"""

    bl_idname = "fantasia3d.export"
    bl_label = "Export"

    filepath: StringProperty(
        name="File", description="The file; its extension sets the format", subtype="FILE_PATH"
    )
    filter_glob: StringProperty(
        default="*.glb;*.usd;*.usdc;*.usda;*.usdz;*.fbx;*.obj;*.stl;*.3mf;*.urdf;*.xml",
        options={"HIDDEN"},
    )
    # Blender's file browser then warns of a file that would be replaced.
    check_existing: BoolProperty(default=True, options={"HIDDEN"})
    format: option_property(options.FORMAT, description="For a file name without an extension")
    flip_normal_y: option_property(options.FLIP_NORMAL_Y)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, changes=False)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        name = bpy.path.clean_name(context.active_object.name)
        # An engine's files go into a folder of that name.
        ending = print_export.BODIES.get(self.format, f".{self.format}")
        self.filepath = name if self.format in engines.ENGINES else f"{name}{ending}"
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        path = Path(bpy.path.abspath(self.filepath))
        # No file was named in it. Not Path.is_dir, which raises for a name that is too long.
        if os.path.isdir(path) and self.format not in engines.ENGINES:  # noqa: PTH112
            path /= bpy.path.clean_name(context.active_object.name)
        return run_and_report(self, lambda: self._export(context.active_object, path))

    def _export(self, obj: bpy.types.Object, path: Path) -> None:
        if self.format in engines.ENGINES and not path.suffix:
            engines.export_for(obj, path, self.format)
            return
        kind = print_export.kind_of(path, self.format)
        if kind:
            path = path.with_suffix(print_export.BODIES[kind])
            print_export.export_body(obj, path, kind, Paths(bpy.context).core)
            return
        path = path if path.suffix else path.with_suffix(f".{self.format}")
        if path.suffix.lower() in print_export.FORMATS:
            print_export.export_print(obj, path, Paths(bpy.context).core)
        else:
            export.export_object(obj, path, self.flip_normal_y)


class FANTASIA3D_OT_mark_asset(ModalTask, bpy.types.Operator):
    """Add the active asset to the Asset Browser, with a thumbnail and tags"""

    bl_idname = "fantasia3d.mark_asset"
    bl_label = "Mark as Asset"
    bl_options = UNDO
    title, pause, shares_window = "Thumbnail", 0.1, True

    tags: option_property(options.TAGS)
    library: StringProperty(
        name="Library", description="Folder of an asset library to save it into; empty: only in "
        "this file", subtype="DIR_PATH",
    )  # fmt: skip
    thumbnail: BoolProperty(
        name="Render Thumbnail", description="Render a picture for the Asset Browser", default=True
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return can_run(cls, context, reason_to_wait())

    def execute(self, context: bpy.types.Context) -> set[str]:
        obj = context.active_object

        def mark() -> None:
            asset_browser.mark_asset(obj, self.tags.split(","), thumbnail=self.thumbnail)
            self._save(obj)

        return run_and_report(self, mark)

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        name = context.active_object.name
        asset_browser.mark_asset(context.active_object, self.tags.split(","), thumbnail=False)
        if self.thumbnail:
            task = blender_process.start(context.active_object, "thumbnail")
            yield from wait_for(task)
            picture = blender_process.load_pixels(task.result)
            # By name: meanwhile the user may have removed the object, or undone a step.
            asset_browser.set_preview(mesh_object(bpy.data.objects.get(name)), picture)
        self._save(mesh_object(bpy.data.objects.get(name)))

    def _save(self, obj: bpy.types.Object) -> None:
        if self.library:
            asset_browser.save_to_library(obj, Path(bpy.path.abspath(self.library)))


CLASSES = (FANTASIA3D_OT_export, FANTASIA3D_OT_mark_asset)
