"""Everything that Blender must know of the add-on, in order."""

from __future__ import annotations

import bpy

from . import operators, panel
from .preferences import FANTASIA3D_AddonPreferences
from .properties import FANTASIA3D_PG_settings
from .session import session

CLASSES = (
    FANTASIA3D_PG_settings,
    FANTASIA3D_AddonPreferences,
    *operators.CLASSES,
    *panel.CLASSES,
)


def register() -> None:
    """Register all classes, then the scene's settings."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.fantasia3d = bpy.props.PointerProperty(type=FANTASIA3D_PG_settings)


def unregister() -> None:
    """Undo :func:`register`, backwards."""
    session.close()
    del bpy.types.Scene.fantasia3d
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
