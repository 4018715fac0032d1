"""Where Blender's users look: Add, Object, File, the context menu, the pie menu, and F3 over them.

F3 finds what a menu shows: every operator is in one of these, under a name with "Fantasia3D".
"""

from __future__ import annotations

import bpy
from bpy.app.translations import pgettext_iface as translated

from .text import TAB

Entry = tuple[str, str]  # an operator's name without "fantasia3d.", and its icon

ADD: tuple[Entry, ...] = (("generate_prompt", "SHADERFX"), ("import_asset", "IMPORT"))
TOOLS: tuple[tuple[str, tuple[Entry, ...]], ...] = (  # by section
    (
        "Material",
        (
            ("texture", "SHADERFX"),
            ("edit_region", "FACESEL"),
            ("replace_material", "MATERIAL"),
            ("restore_material", "LOOP_BACK"),
            ("restore_shape", "LOOP_BACK"),
            ("adjust_material", "MODIFIER"),
            ("reset_material", "X"),
        ),
    ),
    ("Scene Lighting", (("relight", "LIGHT_SUN"), ("turntable", "RENDER_ANIMATION"))),
    (
        "Placement",
        (
            ("drop", "TRIA_DOWN_BAR"),
            ("origin_to_base", "OBJECT_ORIGIN"),
            ("cornell_box", "MESH_CUBE"),
            ("remove_cornell_box", "X"),
        ),
    ),
    ("Physics", (("simulate", "PHYSICS"), ("clear_simulation", "X"))),
    (
        "Mesh",
        (
            ("check_mesh", "VIEWZOOM"),
            ("repair_mesh", "TOOL_SETTINGS"),
            ("make_lods", "MOD_DECIM"),
            ("quad_remesh", "MOD_REMESH"),
        ),
    ),
    ("Export", (("export", "EXPORT"), ("mark_asset", "ASSET_MANAGER"))),
)
JOBS: tuple[Entry, ...] = (
    ("generate", "SHADERFX"),
    ("explore", "IMGDISPLAY"),
    ("new_seed", "FILE_REFRESH"),
    ("guide_from_selection", "RESTRICT_SELECT_OFF"),
    ("local_view", "HIDE_OFF"),
    ("show_colors", "SHADING_TEXTURE"),
    ("cancel", "CANCEL"),
    ("stop_now", "X"),
    ("dismiss", "X"),
    ("open_log", "TEXT"),
    ("job_import", "IMPORT"),
    ("job_resume", "PLAY"),
    ("job_repeat", "LOOP_BACK"),
    ("recolor", "COLOR"),
    ("finish_candidate", "CHECKMARK"),
    ("discard_candidates", "TRASH"),
    ("job_settings", "COPYDOWN"),
    ("job_folder", "FILE_FOLDER"),
    ("job_remove", "TRASH"),
    ("queue_drop", "X"),
    ("queue_go_on", "PLAY"),
    ("refresh", "FILE_REFRESH"),
)
INSTALLATION: tuple[Entry, ...] = (
    ("set_up", "IMPORT"),
    ("check", "VIEWZOOM"),
    ("find_models", "FILE_REFRESH"),
    ("repair", "FILE_REFRESH"),
    ("remove_environment", "TRASH"),
    ("cancel_set_up", "CANCEL"),
    ("open_set_up_log", "TEXT"),
    ("allow_online_access", "URL"),
    ("choose_wheels", "FILE_FOLDER"),
    ("open_preferences", "PREFERENCES"),
)
CONTEXT: tuple[Entry, ...] = (
    ("texture", "SHADERFX"),
    ("edit_region", "FACESEL"),
    ("relight", "LIGHT_SUN"),
    ("simulate", "PHYSICS"),
    ("check_mesh", "VIEWZOOM"),
)
PIE: tuple[Entry, ...] = (  # west, east, south, north, then the corners
    ("texture", "SHADERFX"),
    ("relight", "LIGHT_SUN"),
    ("drop", "TRIA_DOWN_BAR"),
    ("generate_prompt", "SHADERFX"),
    ("check_mesh", "VIEWZOOM"),
    ("simulate", "PHYSICS"),
    ("export", "EXPORT"),
    ("mark_asset", "ASSET_MANAGER"),
)


def label_of(name: str) -> str:
    """The operator's own name."""
    return getattr(bpy.types, f"FANTASIA3D_OT_{name}").bl_label


def draw_entries(
    layout: bpy.types.UILayout, entries: tuple[Entry, ...], is_qualified: bool = True
) -> None:
    """The operators as buttons of a menu; ``is_qualified`` names the add-on before each."""
    for name, icon in entries:
        text = translated(label_of(name), "Operator")
        text = f"{TAB}: {text}" if is_qualified else text
        layout.operator(f"fantasia3d.{name}", text=text, icon=icon, translate=False)


class FANTASIA3D_MT_add(bpy.types.Menu):
    """The menu of operators that add an object."""

    bl_idname = "FANTASIA3D_MT_add"
    bl_label = TAB

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.operator_context = "INVOKE_DEFAULT"
        draw_entries(self.layout, ADD)


class FANTASIA3D_MT_jobs(bpy.types.Menu):
    """The jobs: what runs, what is queued, what is selected in the history."""

    bl_idname = "FANTASIA3D_MT_jobs"
    bl_label = "Jobs"

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.operator_context = "INVOKE_DEFAULT"
        draw_entries(self.layout, JOBS)


class FANTASIA3D_MT_installation(bpy.types.Menu):
    """The method's Python environment."""

    bl_idname = "FANTASIA3D_MT_installation"
    bl_label = "Installation"

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.operator_context = "INVOKE_DEFAULT"
        draw_entries(self.layout, INSTALLATION)


class FANTASIA3D_MT_object(bpy.types.Menu):
    """Everything that acts on the active object, the jobs and the installation."""

    bl_idname = "FANTASIA3D_MT_object"
    bl_label = TAB

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.operator_context = "INVOKE_DEFAULT"
        for _, entries in TOOLS:
            draw_entries(self.layout, entries)
            self.layout.separator()
        self.layout.menu("FANTASIA3D_MT_jobs")
        self.layout.menu("FANTASIA3D_MT_installation")


class FANTASIA3D_MT_context(bpy.types.Menu):
    """The tools that an artist reaches for first."""

    bl_idname = "FANTASIA3D_MT_context"
    bl_label = TAB

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.operator_context = "INVOKE_DEFAULT"
        draw_entries(self.layout, CONTEXT)


class FANTASIA3D_MT_pie(bpy.types.Menu):
    """The tools around the mouse."""

    bl_idname = "FANTASIA3D_MT_pie"
    bl_label = TAB

    def draw(self, context: bpy.types.Context) -> None:
        pie = self.layout.menu_pie()
        pie.operator_context = "INVOKE_DEFAULT"
        draw_entries(pie, PIE, is_qualified=False)


def _draw_add(self: bpy.types.Menu, _context: bpy.types.Context) -> None:
    self.layout.menu("FANTASIA3D_MT_add", icon="SHADERFX")


def _draw_object(self: bpy.types.Menu, _context: bpy.types.Context) -> None:
    self.layout.separator()
    self.layout.menu("FANTASIA3D_MT_object", icon="SHADERFX")


def _draw_context(self: bpy.types.Menu, context: bpy.types.Context) -> None:
    if context.active_object and context.active_object.type == "MESH":
        self.layout.separator()
        self.layout.menu("FANTASIA3D_MT_context", icon="SHADERFX")


def _draw_edit_context(self: bpy.types.Menu, _context: bpy.types.Context) -> None:
    self.layout.operator_context = "INVOKE_DEFAULT"
    self.layout.separator()
    draw_entries(self.layout, (("edit_region", "FACESEL"),))


def _draw_import(self: bpy.types.Menu, _context: bpy.types.Context) -> None:
    draw_entries(self.layout, (("import_asset", "NONE"),))


ENTRIES = (  # Blender's menus, and what is appended to each
    ("VIEW3D_MT_mesh_add", _draw_add),
    ("VIEW3D_MT_object", _draw_object),
    ("VIEW3D_MT_object_context_menu", _draw_context),
    ("VIEW3D_MT_edit_mesh_context_menu", _draw_edit_context),
    ("VIEW3D_MT_edit_mesh_faces", _draw_edit_context),
    ("TOPBAR_MT_file_import", _draw_import),
)


def append() -> None:
    """Append the entries to Blender's menus."""
    for menu, draw in ENTRIES:
        getattr(bpy.types, menu).append(draw)


def remove() -> None:
    """Undo :func:`append`."""
    for menu, draw in ENTRIES:
        getattr(bpy.types, menu).remove(draw)


CLASSES = (
    FANTASIA3D_MT_add,
    FANTASIA3D_MT_jobs,
    FANTASIA3D_MT_installation,
    FANTASIA3D_MT_object,
    FANTASIA3D_MT_context,
    FANTASIA3D_MT_pie,
)
