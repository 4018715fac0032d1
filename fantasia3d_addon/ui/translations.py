"""Translations of the interface by Blender's own mechanism, from gettext files in ``locale``."""

from __future__ import annotations

import json
from pathlib import Path

import bpy

from .. import PACKAGE

LOCALE = Path(__file__).with_name("locale")
CODES = {"de": ("de_DE", "de")}  # a file's name, and what Blender's versions call the language
CONTEXTS = ("*", "Operator")  # labels of operators have a context of their own


def read_po(path: Path) -> dict[str, str]:
    """The messages of a gettext file: a line of msgid and a line of msgstr each."""
    messages, msgid = {}, ""
    for line in path.read_text("utf-8").splitlines():
        key, _, text = line.partition(" ")
        if key == "msgid":
            msgid = json.loads(text)
        elif key == "msgstr" and msgid:
            messages[msgid] = json.loads(text)
    return messages


def register() -> None:
    """Give Blender the messages of all languages."""
    messages = {}
    for name, codes in CODES.items():
        found = read_po(LOCALE / f"{name}.po")
        keyed = {(context, key): text for key, text in found.items() for context in CONTEXTS}
        messages |= dict.fromkeys(codes, keyed)
    bpy.app.translations.register(PACKAGE, messages)


def unregister() -> None:
    """Undo :func:`register`."""
    bpy.app.translations.unregister(PACKAGE)
