"""Bakes a simulation a frame at a time, and checks in each frame that it is stable."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
import numpy as np

from ..blender.mesh_arrays import moved, values, verts_of
from ..errors import AddonError

STRETCH = 30.0  # an edge that is this many times as long: the simulation has exploded
TRIES = 3  # each with finer steps


def bake_until_stable(owner: bpy.types.Object, frames: int) -> Iterator[float]:
    """Bake; where it is unstable, again with finer steps. Yields the fraction done."""
    cache, last = cache_of(owner), bpy.context.scene.frame_start + frames - 1
    # All rigid bodies of a scene have one cache: an earlier bake must not be cut off.
    has_others = cache.is_baked
    last = max(last, cache.frame_end if has_others else 0)
    try:
        yield from _tries(owner, cache, last)
    except BaseException:
        if has_others:
            _keep(cache)  # for :func:`bake_others`, which bakes again what is baked
        raise


def _tries(owner: bpy.types.Object, cache: bpy.types.PointCache, last: int) -> Iterator[float]:
    for _ in range(TRIES):
        _unbake(cache)  # or the frames of the earlier bake would be shown again
        wrong = ""
        for fraction, wrong in _bake(owner, cache, last):
            yield fraction
            if wrong:
                break
        if not wrong:
            return
        # Instability is a matter of the time step in most cases.
        _finer(owner)
    raise AddonError(
        f"The simulation is not stable: {wrong} (tried {TRIES} times).",
        "Repair the mesh under Mesh Health, or use a smaller height.",
    )


def _bake(
    owner: bpy.types.Object, cache: bpy.types.PointCache, last: int
) -> Iterator[tuple[float, str]]:
    """Step to the frame ``last``, which fills the cache, and keep it.

    Yields the fraction done, and what is wrong (empty if nothing).
    """
    scene = bpy.context.scene
    first = scene.frame_start
    cache.frame_start, cache.frame_end = first, last
    scene.frame_set(first)
    # The shape at the first frame is the reference for all others.
    lengths = edge_lengths(_shape(owner))
    start = _state(owner)
    for frame in range(first, last + 1):
        scene.frame_set(frame)
        yield (frame - first) / (last - first + 1), _what_is_wrong(owner, lengths, start)
    _keep(cache)
    yield 1.0, ""


def bake_others(later: bool = False) -> None:
    """Bake the scene's rigid bodies again after one was removed.

    Their common cache knows each by its number alone: one would move as the removed one did.
    ``later``: leave it to the bake of the next body, which is one of all of them.
    """
    scene = bpy.context.scene
    world = scene.rigidbody_world
    cache = world.point_cache if world else None
    if cache is None or not cache.is_baked:
        return
    bodies = world.collection.objects if world.collection else ()
    has_others = any(obj.rigid_body and obj.rigid_body.type == "ACTIVE" for obj in bodies)
    if has_others and later:
        return
    _unbake(cache)
    if has_others:
        for frame in range(cache.frame_start, cache.frame_end + 1):
            scene.frame_set(frame)
        _keep(cache)


def _keep(cache: bpy.types.PointCache) -> None:
    """Keep the frames that stepping has filled the cache with, also in the saved file."""
    scene = bpy.context.scene
    with bpy.context.temp_override(scene=scene, point_cache=cache):
        bpy.ops.ptcache.bake_from_cache()
    scene.frame_set(scene.frame_start)


def _what_is_wrong(owner: bpy.types.Object, lengths: np.ndarray, start: np.ndarray) -> str:
    state = _state(owner)
    if not np.isfinite(state).all():
        return "its vertices are not finite"
    size = float(np.ptp(start, axis=0).max())
    if np.ptp(state, axis=0).max() > 4 * size:
        return "it grows to more than four times its size"
    # A rigid body can't stretch.
    if owner.rigid_body is None:
        stretch = float((edge_lengths(_shape(owner)) / lengths.clip(1e-3 * size)).max())
        if stretch > STRETCH:
            return f"an edge becomes {stretch:.0f} times as long"
    return ""


def _finer(owner: bpy.types.Object) -> None:
    for modifier in owner.modifiers:
        if modifier.type == "CLOTH":
            modifier.settings.quality *= 2
        elif modifier.type == "SOFT_BODY":
            modifier.settings.step_min *= 3
            modifier.settings.error_threshold /= 3
    if owner.rigid_body:
        bpy.context.scene.rigidbody_world.substeps_per_frame *= 2


def _unbake(cache: bpy.types.PointCache) -> None:
    scene = bpy.context.scene
    # A cancelled bake leaves frames in the cache, but is not marked as baked.
    if cache.is_baked:
        with bpy.context.temp_override(scene=scene, point_cache=cache):
            bpy.ops.ptcache.free_bake()
    scene.frame_set(scene.frame_start)


def cache_of(obj: bpy.types.Object) -> bpy.types.PointCache | None:
    if obj.rigid_body and obj.rigid_body.type == "ACTIVE":
        return bpy.context.scene.rigidbody_world.point_cache
    return next((m.point_cache for m in obj.modifiers if m.type in ("CLOTH", "SOFT_BODY")), None)


def _shape(obj: bpy.types.Object) -> bpy.types.Mesh:
    """The mesh as it is simulated at the present frame."""
    return obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def _state(obj: bpy.types.Object) -> np.ndarray:
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return moved(verts_of(evaluated.data), evaluated.matrix_world)


def edge_lengths(mesh: bpy.types.Mesh) -> np.ndarray:
    points, ends = verts_of(mesh), values(mesh.edges, "vertices", 2, np.int32)
    return np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
