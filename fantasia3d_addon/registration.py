"""Everything that Blender must know of the add-on, in order."""

from __future__ import annotations

import bpy

from . import (
    job_operators,
    job_panel,
    live_preview,
    mesh_operators,
    operators,
    panel,
    preferences,
    presets,
    properties,
    setup_operators,
    step_operators,
    thumbnails,
    tool_operators,
    tool_properties,
    tools_panel,
)
from .session import session

MODULES = (  # each has its CLASSES
    properties,
    preferences,
    presets,
    operators,
    job_operators,
    setup_operators,
    panel,
    job_panel,
    tool_properties,
    tool_operators,
    mesh_operators,
    step_operators,
    tools_panel,
)
CLASSES = tuple(cls for module in MODULES for cls in module.CLASSES)


def register() -> None:
    """Register all classes, the settings of scenes and of this Blender, and the handlers."""
    thumbnails.open_collection()
    properties.forget_lights()
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    pointer = bpy.props.PointerProperty
    bpy.types.Scene.fantasia3d = pointer(type=properties.FANTASIA3D_PG_settings)
    bpy.types.Scene.fantasia3d_tools = pointer(type=tool_properties.FANTASIA3D_PG_tools)
    bpy.types.WindowManager.fantasia3d = pointer(type=properties.FANTASIA3D_PG_jobs)
    live_preview.add_handlers()
    session.open()


def unregister() -> None:
    """Undo :func:`register`, backwards."""
    session.close()
    live_preview.remove_handlers()
    del bpy.types.Scene.fantasia3d
    del bpy.types.Scene.fantasia3d_tools
    del bpy.types.WindowManager.fantasia3d
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
    thumbnails.close_collection()
