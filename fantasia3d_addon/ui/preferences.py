"""Where the core's Python, the runs and the models lie on this machine."""

from __future__ import annotations

import bpy
from bpy.props import BoolProperty, StringProperty

from .. import PACKAGE, environment
from .setup_panel import draw_set_up


class FANTASIA3D_AddonPreferences(bpy.types.AddonPreferences):
    """Settings of this machine, kept in the user's preferences."""

    bl_idname = PACKAGE

    environment_folder: StringProperty(
        name="Environment",
        description="Where Set Up makes the method's Python; empty for your data folder",
        subtype="DIR_PATH",
    )
    base_python: StringProperty(
        name="Made of",
        description=f"The Python {environment.PYTHON} that Set Up makes the environment of; "
        "empty for the first that is found",
        subtype="FILE_PATH",
    )
    wheels_folder: StringProperty(
        name="Wheels",
        description="A folder of wheels, for a set-up without a network; empty for the registry",
        subtype="DIR_PATH",
    )
    python: StringProperty(
        name="Existing Python",
        description="A Python that has the method's packages, used as it is instead of Set Up's",
        subtype="FILE_PATH",
    )
    runs_folder: StringProperty(
        name="Runs",
        description="Where runs and their assets are kept; empty for Blender's user folder",
        subtype="DIR_PATH",
    )
    models_folder: StringProperty(
        name="Models",
        description="Where downloaded Stable Diffusion models lie; empty for the hub's own cache",
        subtype="DIR_PATH",
    )
    download_models: BoolProperty(
        name="Download models",
        description="Let the method fetch a model that is named by its hub id",
    )

    def draw(self, context: bpy.types.Context) -> None:
        """The set-up first: nothing runs without it."""
        layout = self.layout
        draw_set_up(layout, context)
        layout.use_property_split = True
        column = layout.column(heading="Set-Up")
        for name in ("environment_folder", "base_python", "wheels_folder", "python"):
            column.prop(self, name)
        column = layout.column()
        for name in ("runs_folder", "models_folder"):
            column.prop(self, name)
        row = column.row()
        row.active = bpy.app.online_access
        row.prop(self, "download_models")


CLASSES = (FANTASIA3D_AddonPreferences,)
