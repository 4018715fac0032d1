"""The stable names for scripts, as docs/recipes.md uses them.

Everything else in this package may move. Functions raise :class:`AddonError` (a sentence and its
fix) for what the user can repair.
"""

from .asset.import_asset import import_asset
from .errors import AddonError
from .jobs import environment_setup, history, submit
from .jobs.paths import Paths
from .jobs.session import session
from .material import edit as material_edit
from .mesh import asset_browser, engines, export, health, remesh
from .physics import simulation
from .scene import cornell_box, placement, relight

__all__ = [
    "AddonError",
    "Paths",
    "asset_browser",
    "cornell_box",
    "engines",
    "environment_setup",
    "export",
    "health",
    "history",
    "import_asset",
    "material_edit",
    "placement",
    "relight",
    "remesh",
    "session",
    "simulation",
    "submit",
]
