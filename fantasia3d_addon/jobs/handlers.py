"""Handlers for jobs when a file is saved or opened, and after an undo."""

from __future__ import annotations

import bpy
from bpy.app.handlers import persistent

from . import live_preview
from .session import session


@persistent
def _before_save(*_: object) -> None:
    live_preview.remove()  # a preview is not part of the user's file


@persistent
def _after_save(*_: object) -> None:
    session.show_candidates()  # a run that continues shows its preview again by itself


@persistent
def _after_undo(*_: object) -> None:
    live_preview.remove(keep=session.shown)  # an undo step may hold the preview of an ended run
    session.show_candidates()  # and none of a candidate that came after it


@persistent
def _after_load(*_: object) -> None:
    live_preview.remove()
    session.file_opened()


HANDLERS = (
    (bpy.app.handlers.save_pre, _before_save),
    (bpy.app.handlers.save_post, _after_save),
    (bpy.app.handlers.undo_post, _after_undo),
    (bpy.app.handlers.redo_post, _after_undo),
    (bpy.app.handlers.load_post, _after_load),
)


def add() -> None:
    """Keep previews out of files and undo steps, and inform the session of opened files."""
    for handlers, function in HANDLERS:
        handlers.append(function)


def remove() -> None:
    """Undo :func:`add`."""
    for handlers, function in HANDLERS:
        handlers.remove(function)
