"""Fantasia3D for Blender: text in, a textured mesh in the scene out.

The add-on is a window on ``core``, which runs as a process of its own under its own Python. It
never imports torch or the core; they meet in a run folder (``jobs``) and an asset folder
(``import_asset``). This module imports nothing, so that ``environment`` loads without Blender.
"""

PACKAGE = __package__  # "fantasia3d_addon", or the extension's name in Blender


def register() -> None:
    """Add the panel, the operators and the preferences to Blender."""
    from .ui import registration

    registration.register()


def unregister() -> None:
    """Remove them again; a running job continues by itself."""
    from .ui import registration

    registration.unregister()
