"""The preferences: where the core's Python, the runs and the models are on this machine."""

from __future__ import annotations

import bpy
from bpy.app.translations import pgettext_iface as translated
from bpy.props import BoolProperty, EnumProperty, StringProperty

from .. import PACKAGE, environment
from . import shortcut
from .setup_panel import draw_set_up


class FANTASIA3D_AddonPreferences(bpy.types.AddonPreferences):
    """Settings of this machine, kept in the user's preferences; ``jobs/paths.py`` reads them."""

    bl_idname = PACKAGE

    environment_folder: StringProperty(
        name="Environment Folder",
        description="Where Install creates the method's Python; empty: your data folder",
        subtype="DIR_PATH",
    )
    base_python: StringProperty(
        name="Base Python",
        description=f"The Python {environment.ANY_PYTHON} that Install makes the environment from; "
        "empty: the first that is found",
        subtype="FILE_PATH",
    )
    wheels_folder: StringProperty(
        name="Wheels Folder",
        description="A folder of wheels, for an installation without a network; empty: the "
        "package registry",
        subtype="DIR_PATH",
    )
    python: StringProperty(
        name="Existing Python",
        description="A Python that has the method's packages, used instead of Install's",
        subtype="FILE_PATH",
    )
    runs_folder: StringProperty(
        name="Runs",
        description="Where runs and their assets are kept; empty: Blender's user folder",
        subtype="DIR_PATH",
    )
    models_folder: StringProperty(
        name="Models",
        description="Where downloaded Stable Diffusion models are kept; empty: the hub's own cache",
        subtype="DIR_PATH",
    )
    tool_folder: StringProperty(
        name="Other Tool",
        description="The folder of ComfyUI, Stable Diffusion web UI or another tool, whose models "
        "are offered too",
        subtype="DIR_PATH",
    )
    download_models: BoolProperty(
        name="Download models",
        description="Allow the method to download a model that is named by its hub id",
    )

    jobs_place: EnumProperty(
        name="Jobs Run On",
        description="Where assets are made",
        items=[
            ("LOCAL", "This Machine", "In a process of this machine"),
            ("RAY", "Ray Cluster", "On a cluster, by its Jobs interface; the asset comes back"),
        ],
    )
    ray_address: StringProperty(
        name="Address",
        description="The cluster's dashboard, such as http://192.0.2.10:8265",
    )
    ray_token: StringProperty(
        name="Token",
        description="The cluster's token; Blender keeps it in its preferences, unencrypted",
        subtype="PASSWORD",
    )

    use_pie: BoolProperty(
        name="Pie Menu",
        description=f"Open a pie menu of the tools in the 3D view by {shortcut.TEXT}",
        update=lambda self, _context: shortcut.update(self.use_pie),
    )

    def draw(self, context: bpy.types.Context) -> None:
        """The installation first: nothing runs without it."""
        layout = self.layout
        draw_set_up(layout, context)
        layout.use_property_split = True
        column = layout.column(heading="Installation")
        for name in ("environment_folder", "base_python", "wheels_folder", "python"):
            column.prop(self, name)
        column = layout.column()
        for name in ("runs_folder", "models_folder", "tool_folder"):
            column.prop(self, name)
        row = column.row()
        row.active = bpy.app.online_access
        row.prop(self, "download_models")
        column = layout.column()
        column.prop(self, "jobs_place")
        if self.jobs_place == "RAY":
            column.prop(self, "ray_address")
            column.prop(self, "ray_token")
        text = f"{translated('Pie Menu')} ({shortcut.TEXT})"
        column.prop(self, "use_pie", text=text, translate=False)


def uses_pie() -> bool:
    """Whether the user wants the pie menu's shortcut."""
    addon = bpy.context.preferences.addons.get(PACKAGE)
    return bool(addon and addon.preferences and addon.preferences.use_pie)


CLASSES = (FANTASIA3D_AddonPreferences,)
