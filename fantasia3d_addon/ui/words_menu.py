"""The words of the built-in model: what is understood of the prompt, and menus of known words."""

from __future__ import annotations

import bpy
from bpy.props import StringProperty

from ..jobs import submit, words
from ..jobs.session import session
from .text import length, wrapped_label

MAX_GROUPS = 32  # menus must exist before the groups are known
MAX_NOTES = 3
COLUMN = 21  # words of a group in one column of its menu


class FANTASIA3D_OT_add_word(bpy.types.Operator):
    """Add this word to the prompt; a thing replaces the one that it has"""

    bl_idname = "fantasia3d.add_word"
    bl_label = "Add Word"
    bl_options = {"UNDO", "INTERNAL"}

    word: StringProperty(name="Word", description="The word to add")
    kind: StringProperty(
        name="Kind",
        description="thing, shape, color, material, pattern, mood, style or part",
        default="thing",
    )

    def execute(self, context: bpy.types.Context) -> set[str]:
        settings = context.scene.fantasia3d
        thing = (submit.report_of(settings) or {}).get("thing", "")
        settings.prompt = words.with_word(settings.prompt, self.kind, self.word, thing)
        return {"FINISHED"}


class FANTASIA3D_OT_replace_word(bpy.types.Operator):
    """Replace the unknown word of the prompt by this one"""

    bl_idname = "fantasia3d.replace_word"
    bl_label = "Replace Word"
    bl_options = {"UNDO", "INTERNAL"}

    old: StringProperty(name="Old Word", description="A word of the prompt")
    new: StringProperty(name="New Word", description="What replaces it; empty: nothing")

    def execute(self, context: bpy.types.Context) -> set[str]:
        settings = context.scene.fantasia3d
        settings.prompt = " ".join(words.replaced(settings.prompt, self.old, self.new).split())
        return {"FINISHED"}


class FANTASIA3D_MT_words(bpy.types.Menu):
    """The words that the built-in model knows, by group."""

    bl_idname = "FANTASIA3D_MT_words"
    bl_label = "Words"

    def draw(self, context: bpy.types.Context) -> None:
        groups = session.word_groups()
        if not groups:
            self.layout.label(text="Loading the words…")
        for number, group in enumerate(groups[:MAX_GROUPS]):
            self.layout.menu(f"FANTASIA3D_MT_words_{number}", text=group["name"])


def _draw_group(self: bpy.types.Menu, _context: bpy.types.Context) -> None:
    number = int(self.bl_idname.rpartition("_")[2])
    for group in session.word_groups()[number : number + 1]:
        columns = -(-len(group["words"]) // COLUMN)
        flow = self.layout.column_flow(columns=max(columns, 1))
        for word in group["words"]:
            button = flow.operator("fantasia3d.add_word", text=word, translate=False)
            button.word, button.kind = word, group["kind"]


GROUP_MENUS = tuple(
    type(
        f"FANTASIA3D_MT_words_{number}",
        (bpy.types.Menu,),
        {"bl_idname": f"FANTASIA3D_MT_words_{number}", "bl_label": "Words", "draw": _draw_group},
    )
    for number in range(MAX_GROUPS)
)


def draw_understood(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """The built-in model's reading of the prompt, and buttons for unknown words."""
    settings = context.scene.fantasia3d
    if settings.guidance != "builtin":
        return
    layout.menu("FANTASIA3D_MT_words", icon="OUTLINER_OB_FONT")
    session.word_groups()  # known before the menu is opened
    report = submit.report_of(settings)
    if not report:
        return
    column = layout.column(align=True)
    if "thing" in report:
        _draw_report(column, context, report)
    elif words.unknown(report):
        _draw_unknown(column, words.unknown(report))
        layout.prop(settings, "ignore_unknown")
    else:
        wrapped_label(column, context, report["error"], "ERROR")
    if settings.ignore_unknown and "thing" in report:
        layout.prop(settings, "ignore_unknown")


def _draw_report(
    layout: bpy.types.UILayout, context: bpy.types.Context, report: words.Report
) -> None:
    size = context.scene.fantasia3d.size
    # What the prompt states may be another side than the longest.
    own = "" if size or report["side"] == "length" else f" ({report['side']})"
    text = f"{words.summary(report)}: {length(size or report['size_m'])}{own}"
    wrapped_label(layout, context, text, "CHECKMARK")
    for note in report["notes"][:MAX_NOTES]:
        wrapped_label(layout, context, note, "BLANK1", dimmed=True)


def _draw_unknown(layout: bpy.types.UILayout, unknown: object) -> None:
    for word, nearest in dict(unknown).items():
        row = layout.row(align=True)
        row.label(text=f"“{word}”", icon="QUESTION", translate=False)
        for near in nearest:
            button = row.operator("fantasia3d.replace_word", text=near, translate=False)
            button.old, button.new = word, near
        button = row.operator("fantasia3d.replace_word", text="", icon="X")
        button.old, button.new = word, ""


CLASSES = (FANTASIA3D_OT_add_word, FANTASIA3D_OT_replace_word, FANTASIA3D_MT_words, *GROUP_MENUS)
