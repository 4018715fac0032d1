"""Everything that Blender must know of the add-on, in order."""

from __future__ import annotations

import bpy

from ..jobs import handlers
from ..jobs.session import session
from . import (
    candidates,
    drop_files,
    edit_region,
    export_operators,
    generate_operators,
    generate_panel,
    icons,
    job_operators,
    job_panel,
    material_operators,
    menus,
    mesh_operators,
    models_menu,
    physics_operators,
    preferences,
    presets,
    properties,
    scene_operators,
    setup_operators,
    shortcut,
    tool_properties,
    tools_panel,
    translations,
    words_menu,
)

MODULES = (  # each has its CLASSES
    properties,
    preferences,
    presets,
    generate_operators,
    job_operators,
    candidates,
    setup_operators,
    models_menu,
    words_menu,
    generate_panel,
    job_panel,
    tool_properties,
    scene_operators,
    material_operators,
    physics_operators,
    mesh_operators,
    export_operators,
    drop_files,
    tools_panel,
    edit_region,
    menus,
)
CLASSES = tuple(cls for module in MODULES for cls in module.CLASSES)


def register() -> None:
    """Register all classes, the settings of scenes and of this Blender, and the handlers."""
    translations.register()
    # Before the classes: an enum of lights needs the icons.
    icons.open_collection()
    properties.clear_light_items()
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    pointer = bpy.props.PointerProperty
    bpy.types.Scene.fantasia3d = pointer(type=properties.FANTASIA3D_PG_settings)
    bpy.types.Scene.fantasia3d_tools = pointer(type=tool_properties.FANTASIA3D_PG_tools)
    bpy.types.WindowManager.fantasia3d = pointer(type=properties.FANTASIA3D_PG_jobs)
    menus.append()
    shortcut.update(preferences.uses_pie())
    handlers.add()
    session.open()


def unregister() -> None:
    """Undo :func:`register`, backwards."""
    session.close()
    handlers.remove()
    shortcut.remove()
    menus.remove()
    del bpy.types.Scene.fantasia3d
    del bpy.types.Scene.fantasia3d_tools
    del bpy.types.WindowManager.fantasia3d
    # In reverse order: properties refer to classes that were registered before them.
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
    icons.close_collection()
    translations.unregister()
