"""Where a preview or an asset comes: the free place nearest to its target, or exactly there."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np

from ..asset.asset_folder import AssetFolder
from ..scene import view
from ..scene.free_place import free_place
from .target import EXACT, FREE, Target

FREE_PLACE, IN_VIEW, CURSOR = "free", "view", "cursor"  # what a user may choose


def requested(context: bpy.types.Context) -> dict[str, object]:
    """The target's location and place by the panel's setting, as it is now."""
    scene = context.scene
    choice = scene.fantasia3d.placement
    where = view.focus(scene, context.area) if choice == IN_VIEW else scene.cursor.location
    return {"location": tuple(where), "place": EXACT if choice == CURSOR else FREE}


def place_of(
    scene: bpy.types.Scene,
    target: Target,
    bounds: np.ndarray,
    near: Sequence[float] | None = None,
    ignored: Sequence[bpy.types.Object] = (),
) -> tuple[float, float, float]:
    """The location for an object with ``bounds`` (2,3) about its origin.

    ``near``: where its preview is; None: the target's location.
    """
    if target.place == EXACT:
        return target.location
    if near:  # of its preview: there it stays, unless something else has come there
        return free_place(scene, bounds, near, ignored)
    return free_place(scene, bounds, target.location, ignored, view.eye(scene))


def bounds_of(asset: AssetFolder) -> np.ndarray:
    """The lowest and the highest corner (2,3) of an asset about its origin."""
    return np.stack([asset.verts.min(0), asset.verts.max(0)]).astype(np.float64)


def scene_of(target: Target) -> bpy.types.Scene:
    """The scene that the asset was requested in; the present one where that was removed."""
    return bpy.data.scenes.get(target.scene) or bpy.context.scene
