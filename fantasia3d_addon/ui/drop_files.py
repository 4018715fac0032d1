"""Files that are dragged onto the viewport: an asset's asset.json or GLB, an HDR or EXR light."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import StringProperty

from ..blender import compat
from ..blender.mesh_arrays import EDIT_MODE
from ..errors import AddonError
from .operator_helpers import UNDO, USER_ERRORS, import_and_select, needs, report_error


class FANTASIA3D_OT_import_file(bpy.types.Operator):
    """Import the asset that this asset.json or GLB belongs to; or a GLB of another program"""

    bl_idname = "fantasia3d.import_file"
    bl_label = "Import Asset File"
    bl_options = UNDO | {"INTERNAL"}

    filepath: StringProperty(
        name="File", description="asset.json or a GLB", subtype="FILE_PATH", options={"SKIP_SAVE"}
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, context.mode == "OBJECT", EDIT_MODE)

    def execute(self, context: bpy.types.Context) -> set[str]:
        path = Path(bpy.path.abspath(self.filepath))
        try:
            # The asset next to a GLB of ours has more: a closed mesh and 16-bit normals.
            if path.suffix.lower() == ".glb" and not path.with_name("asset.json").is_file():
                _import_gltf(path)
            else:
                import_and_select(context, path.parent)
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


def _import_gltf(path: Path) -> None:
    if not compat.has_operator("import_scene", "gltf"):
        raise AddonError(
            "Blender's glTF add-on is disabled.", "Enable it: Preferences, Add-ons, glTF."
        )
    try:
        bpy.ops.import_scene.gltf(filepath=str(path))
    except RuntimeError as error:
        raise AddonError(f"{path} can't be imported ({str(error).strip()}).") from None


class _InViewport:
    """Mixin: takes files that are dropped onto a 3D view."""

    @classmethod
    def poll_drop(cls, context: bpy.types.Context) -> bool:
        return context.area is not None and context.area.type == "VIEW_3D"


class FANTASIA3D_FH_asset(_InViewport, bpy.types.FileHandler):
    """Assets."""

    bl_idname = "FANTASIA3D_FH_asset"
    bl_label = "Fantasia3D Asset"
    bl_import_operator = "fantasia3d.import_file"
    bl_file_extensions = ".json;.glb"


class FANTASIA3D_FH_light(_InViewport, bpy.types.FileHandler):
    """Light pictures."""

    bl_idname = "FANTASIA3D_FH_light"
    bl_label = "Fantasia3D Light"
    bl_import_operator = "fantasia3d.relight"
    bl_file_extensions = ".hdr;.exr"


CLASSES = (FANTASIA3D_OT_import_file, FANTASIA3D_FH_asset, FANTASIA3D_FH_light)
