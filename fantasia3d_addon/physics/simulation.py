"""Rigid body, soft body, cloth, and a sheet draped over an asset: one call each, baked.

The fine mesh itself is never simulated. A soft body or cloth is a coarse cage of it, and the asset
follows the cage by a Surface Deform modifier: its vertices stay welded, so no seam can open, and a
bake takes seconds. A rigid body is one convex hull or several, with the true centre of mass, and
the asset is parented to it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil
from uuid import uuid4

import bmesh
import bpy
import numpy as np
from mathutils import Matrix, Vector

from .. import options
from ..blender.mesh_arrays import acting, mesh_object, moved, verts_of, world_verts
from ..errors import AddonError
from ..mesh import health, proxy
from ..scene.placement import shown_verts
from .bake import bake_others, bake_until_stable, cache_of, edge_lengths
from .colliders import GROUND, add_rigid, collide_with, release, supports
from .helpers import (
    BODY,
    COLLECTION,
    COLLIDER,
    MARK,
    add,
    is_helper,
    is_local,
    is_simulated,
    made_for,
    remove,
    token_of,
)
from .mass import mass_of

__all__ = [
    "COLLECTION",
    "GROUND",
    "KINDS",
    "MARK",
    "Options",
    "clear",
    "is_simulated",
    "note_of",
    "owner_of",
    "simulate",
    "steps",
]

KINDS = options.KIND.names
MIN_MASS = 0.001  # kg: Blender's own limit
CAGE_FACES = {"SOFT": 1200, "CLOTH": 3000, "DRAPE": 3000, "RIGID": 400}
# A sheet that moves farther in a substep than it keeps off falls through: of the asset's size.
SUBSTEP = 0.04
FINEST = 80  # substeps a frame: Blender's own limit
_NUMBERS = (options.FRAMES, options.HEIGHT, options.SOFTNESS)  # those with a range


@dataclass(frozen=True)
class Options:
    """The user's options, as ``options.SIMULATION`` describes them; lengths in metres."""

    frames: int = int(options.FRAMES.default)
    height: float = float(options.HEIGHT.default)
    convex: bool = bool(options.CONVEX.default)  # rigid bodies
    softness: float = float(options.SOFTNESS.default)  # soft bodies
    self_collision: bool = bool(options.SELF_COLLISION.default)  # cloth


def simulate(obj: bpy.types.Object, kind: str, settings: Options | None = None) -> None:
    """Make ``obj`` a simulated ``kind`` from the scene's first frame on, and bake it.

    It collides with what is below it; where nothing is, a ground plane is created. An earlier
    simulation of it is removed first, and so is what deleted assets have left.

    Raises:
        AddonError: the mesh can't be simulated (the text names the repair), or the
            simulation is not stable; the object is as before then.
    """
    for _ in steps(obj, kind, settings or Options()):
        pass


def steps(obj: bpy.types.Object, kind: str, settings: Options) -> Iterator[float]:
    """:func:`simulate`, a frame at a time: yields the fraction done."""
    _check(obj, kind, settings)
    had_body = is_simulated(obj) and _clear(obj, is_copy=not made_for(obj))
    had_body |= _remove_all(_left_behind())
    if had_body:
        bake_others(later=kind == "RIGID")
    scene = bpy.context.scene
    token = {"token": uuid4().hex, "name": obj.name}
    obj[MARK] = {"location": list(obj.location), "frame": scene.frame_current} | token
    scene.frame_set(scene.frame_start)  # a simulation starts there, and so must its objects
    try:
        make = {"RIGID": _rigid, "SOFT": _soft, "CLOTH": _cloth, "DRAPE": _drape}[kind]
        if kind != "DRAPE":  # there the sheet falls, not the asset
            _lift(obj, settings.height)
        bpy.context.view_layer.update()
        owner = make(obj, settings)
        yield from bake_until_stable(owner, settings.frames)
    except BaseException:
        if _clear(obj, is_copy=False) or had_body:
            bake_others()
        raise


def clear(obj: bpy.types.Object) -> None:
    """Remove the simulation of ``obj`` and what was made for it; ``obj`` is as before.

    A copy of a simulated object stays where it is, and so does the original's simulation.
    """
    if is_simulated(obj) and _clear(obj, is_copy=not made_for(obj)):
        bake_others()


def _left_behind() -> list[bpy.types.Object]:
    """The helpers of deleted assets: hardly visible, but others collide with them.

    A sheet that was draped over one is the user's own from then on.
    """
    alive = {token_of(o) for o in bpy.data.objects if is_simulated(o) and o.users_scene}
    if "" in alive:  # of an earlier version, whose helpers have a name, which may be another now
        return []
    left = [o for o in _local() if is_helper(o) and o[MARK] not in alive]
    for made in list(left):
        if any(m.type == "CLOTH" for m in made.modifiers) and not made.hide_render:
            del made[MARK]
            left.remove(made)
    return left


def _clear(obj: bpy.types.Object, is_copy: bool) -> bool:
    """:func:`clear`, but for the bake; whether the other bodies must be baked again."""
    before, scene = obj[MARK], bpy.context.scene
    helpers = made_for(obj)
    if not is_copy:
        scene.frame_set(scene.frame_start)
    place = obj.matrix_world.copy()
    for modifier in [m for m in obj.modifiers if m.name == MARK]:
        obj.modifiers.remove(modifier)
    if obj.parent and is_helper(obj.parent):
        obj.parent = None
        obj.matrix_world = place if is_copy else _matrix(before["matrix"])
        parent = bpy.data.objects.get(before.get("parent", ""))
        if parent and not is_copy:
            obj.parent, obj.parent_type = parent, before["type"]
            obj.parent_bone, obj.matrix_parent_inverse = before["bone"], _matrix(before["inverse"])
            obj.matrix_basis = _matrix(before["basis"])
    if not is_copy:
        obj.location = before["location"]
    del obj[MARK]
    had_body = _remove_all(helpers)
    bpy.context.view_layer.update()
    return had_body


def _remove_all(helpers: Sequence[bpy.types.Object]) -> bool:
    """Remove them; whether one was a rigid body."""
    had_body = any(made.rigid_body for made in helpers)
    for made in helpers:
        remove(made)
    _release_colliders()
    return had_body


def _release_colliders() -> None:
    """Several simulations may use one collider: the last one releases it."""
    if not any(is_helper(o) for o in _local()):
        for other in [o for o in _local() if COLLIDER in o or BODY in o]:
            release(other)


def _local() -> list[bpy.types.Object]:
    return [obj for obj in bpy.data.objects if is_local(obj)]


def owner_of(obj: bpy.types.Object) -> bpy.types.Object | None:
    """The object that is simulated in place of ``obj``."""
    return next((o for o in made_for(obj) if cache_of(o)), None)


def _check(obj: bpy.types.Object, kind: str, settings: Options) -> None:
    mesh_object(obj)
    if kind not in KINDS:
        raise AddonError(f"There is no simulation {kind!r}.", f"Use one of {', '.join(KINDS)}.")
    for option in _NUMBERS:
        value = getattr(settings, option.name)
        if not option.allows(value):
            raise AddonError(
                f"{option.label} is {value:g}, which is not possible.", f"Use {option.range}."
            )
    shown_verts(obj)  # an error where there are none
    report = health.examine(obj)
    if kind in ("SOFT", "CLOTH") and report.doubled:
        raise AddonError(
            f"The mesh of {obj.name} is not welded: {report.doubled} vertices have the place of "
            "another, and it would tear there.",
            "Press Weld under Mesh Health first.",
        )
    if kind == "SOFT" and not report.closed:
        raise AddonError(
            f"The mesh of {obj.name} is not closed: it has {report.open_edges} open edges, and no "
            "volume that could keep its shape.",
            "Press Fill Holes under Mesh Health, or use Cloth.",
        )


def _lift(obj: bpy.types.Object, height: float) -> None:
    up = Vector((0, 0, height))
    if obj.parent:  # in whose axes the location is
        axes = (obj.matrix_world @ obj.matrix_basis.inverted_safe()).to_3x3()
        up = axes.inverted_safe() @ up
    obj.location += up


# What is simulated


def _rigid(obj: bpy.types.Object, settings: Options) -> bpy.types.Object:
    """A body with its origin in the centre of mass, to which the asset is parented."""
    matrix, parts = obj.matrix_world.copy(), _parts(obj, settings.convex)
    hulls = [proxy.hull_mesh("hull", moved(points, matrix)) for points in parts]
    mass = mass_of(obj, sum(volume for _, _, volume in hulls))
    # 1e-9: a flat hull must not make the weights zero.
    volumes = np.array([max(volume, 1e-9) for _, _, volume in hulls])
    middle = Vector(np.average([center for _, center, _ in hulls], 0, volumes))
    if len(hulls) == 1:
        body = add(obj, "body", hulls[0][0])
        body.data.transform(Matrix.Translation(-middle))
        children = []
    else:
        # A compound needs a parent with a mesh; its own shape is not used.
        whole, _, _ = proxy.hull_mesh("hull", np.concatenate([moved(p, matrix) for p in parts]))
        whole.transform(Matrix.Translation(-middle))
        body = add(obj, "body", whole)
        children = [add(obj, f"part {i}", hull) for i, (hull, _, _) in enumerate(hulls)]
    body.location = middle
    for child in children:
        child.data.transform(Matrix.Translation(-middle))
        child.parent = body
    bpy.context.view_layer.update()
    # For clear(): the parent changes the matrix.
    obj[MARK] = {**obj[MARK].to_dict(), "matrix": _flat(matrix)} | _parent_of(obj)
    # So that the asset stays where it is while it becomes a child, also of another than before.
    inverse = Matrix.Translation(-middle) @ matrix @ obj.matrix_basis.inverted_safe()
    obj.parent, obj.parent_type = body, "OBJECT"
    obj.matrix_parent_inverse = inverse
    for other in supports(obj):
        add_rigid(other, "PASSIVE", "MESH")
    add_rigid(body, "ACTIVE", "COMPOUND" if children else "CONVEX_HULL")
    for child in children:  # after their parent: or Blender finds a cycle
        add_rigid(child, "ACTIVE", "CONVEX_HULL")
    # The mass changes how it collides with the user's own rigid bodies.
    body.rigid_body.mass = max(mass, MIN_MASS)
    body.rigid_body.friction, body.rigid_body.restitution = 0.6, 0.15
    world = bpy.context.scene.rigidbody_world
    world.substeps_per_frame, world.solver_iterations = 20, 20
    return body


def _parent_of(obj: bpy.types.Object) -> dict[str, object]:
    """The user's own parent by name, and where the object is in it; nothing without one."""
    if obj.parent is None:
        return {}
    where = {"inverse": _flat(obj.matrix_parent_inverse), "basis": _flat(obj.matrix_basis)}
    return {"parent": obj.parent.name, "type": obj.parent_type, "bone": obj.parent_bone} | where


def _parts(obj: bpy.types.Object, convex: bool) -> list[np.ndarray]:
    """The points (N,3) of one hull or of several, in the object's own space."""
    # Of a coarse copy: the decomposition cuts and measures many candidates.
    mesh = proxy.cage(obj, CAGE_FACES["RIGID"])
    parts = [verts_of(mesh)] if convex else proxy.convex_parts(mesh)
    bpy.data.meshes.remove(mesh)
    return parts


def _soft(obj: bpy.types.Object, settings: Options) -> bpy.types.Object:
    cage = _caged(obj, CAGE_FACES["SOFT"])
    # Without struts a closed cage folds flat: springs along its edges keep lengths, not volume.
    proxy.add_struts(cage.data)
    soft = cage.modifiers.new(MARK, "SOFT_BODY").settings
    firm = 0.9 - 0.8 * settings.softness
    # The goal would pin the vertices to where they are.
    soft.use_goal, soft.use_edges = False, True
    soft.pull = soft.push = firm
    soft.bend, soft.damping = firm + 0.1, 2.0
    soft.mass, soft.friction = 1.0, 0.5
    soft.step_min, soft.error_threshold = 5, 0.1
    collide_with(supports(obj), float(max(obj.dimensions)))
    return cage


def _cloth(obj: bpy.types.Object, settings: Options) -> bpy.types.Object:
    cage = _caged(obj, CAGE_FACES["CLOTH"])
    cloth = cage.modifiers.new(MARK, "CLOTH")
    _set_up_cloth(cloth, cage, settings.self_collision)
    cloth.settings.bending_stiffness = 2.0
    collide_with(supports(obj), float(max(obj.dimensions)))
    return cage


def _drape(obj: bpy.types.Object, settings: Options) -> bpy.types.Object:
    """A sheet that falls over the asset, which does not move."""
    points = world_verts(obj)
    low, high = points.min(0), points.max(0)
    # Wide enough to hang down on all sides: the footprint's diagonal and half the height.
    half = 0.62 * float(np.linalg.norm((high - low)[:2])) + 0.5 * float(high[2] - low[2])
    cells = 56
    bm = bmesh.new()
    bmesh.ops.create_grid(bm, x_segments=cells, y_segments=cells, size=half)
    mesh = bpy.data.meshes.new(f"{obj.name} sheet")
    bm.to_mesh(mesh)
    bm.free()
    mesh.shade_smooth()
    sheet = add(obj, "sheet", mesh, hidden=False)
    middle = (low + high) / 2
    rise, substeps = _fall(float((high - low).max()), settings.height)
    sheet.location = (middle[0], middle[1], high[2] + rise)
    cloth = sheet.modifiers.new(MARK, "CLOTH")
    _set_up_cloth(cloth, sheet, settings.self_collision)
    cloth.settings.bending_stiffness = 0.1
    cloth.settings.mass, cloth.settings.quality = 0.1, substeps
    cloth.collision_settings.collision_quality = 2
    smooth = sheet.modifiers.new("smooth", "SUBSURF")
    smooth.levels, smooth.render_levels = 1, 2
    # The fine mesh as a collider would slow each frame down.
    hard = add(obj, "collider", proxy.cage(obj, CAGE_FACES["DRAPE"]))
    hard.parent = obj
    collide_with([hard, *supports(obj)], float(max(obj.dimensions)))
    return sheet


def _fall(size: float, height: float) -> tuple[float, int]:
    """How far above an asset a sheet starts, ``height`` if it can, and the substeps of a frame."""
    scene = bpy.context.scene
    slowest = SUBSTEP * size * scene.render.fps / scene.render.fps_base  # of one substep
    pull = 2 * max(scene.gravity.length, 1e-6)
    # At least a little above it, so that it does not start in contact.
    rise = max(0.05 * size, min(height, (FINEST * slowest) ** 2 / pull))
    return rise, min(max(6, ceil((pull * rise) ** 0.5 / slowest)), FINEST)


def note_of(obj: bpy.types.Object, kind: str, settings: Options) -> str:
    """The deviation from the requested ``settings``; empty if none."""
    if kind != "DRAPE":
        return ""
    rise = _fall(float(np.ptp(shown_verts(obj), axis=0).max()), settings.height)[0]
    if rise >= settings.height:
        return ""
    return f"The sheet starts {rise:.3f} m above it: from higher, it would fall through."


def _set_up_cloth(
    cloth: bpy.types.ClothModifier, obj: bpy.types.Object, self_collision: bool
) -> None:
    """The settings that both kinds of cloth have in common; distances by the mesh's own edges."""
    size = float(max(obj.dimensions))
    settings, collision = cloth.settings, cloth.collision_settings
    settings.quality, settings.mass, settings.air_damping = 8, 0.3, 0.4
    settings.tension_stiffness = settings.compression_stiffness = 25.0
    settings.shear_stiffness = 12.0
    settings.tension_damping = settings.compression_damping = 10.0
    collision.collision_quality = 4
    # Distances follow the size: Blender's default of 15 mm is too large for a small asset.
    collision.distance_min = 0.008 * size
    collision.use_self_collision = self_collision
    # Smaller than nearly all edges, or adjacent vertices repel each other.
    collision.self_distance_min = min(0.3 * float(np.percentile(edge_lengths(obj.data), 5)), 0.1)


def _caged(obj: bpy.types.Object, faces: int) -> bpy.types.Object:
    """The cage of ``obj``, bound so that ``obj`` follows it."""
    cage = add(obj, "cage", proxy.cage(obj, faces))
    cage.matrix_world = obj.matrix_world
    bpy.context.view_layer.update()
    follow = obj.modifiers.new(MARK, "SURFACE_DEFORM")
    follow.target = cage
    with acting(obj):
        # Each fine vertex is bound to the nearest face of the cage.
        bpy.ops.object.surfacedeform_bind(modifier=follow.name)
    if not follow.is_bound:
        raise AddonError(
            f"{obj.name} can't be bound to a coarse copy of itself: its mesh is not manifold.",
            "Press Repair All under Mesh Health, or Quad Remesh.",
        )
    return cage


def _flat(matrix: Matrix) -> list[float]:
    return [value for row in matrix for value in row]


def _matrix(numbers: Sequence[float]) -> Matrix:
    return Matrix([list(numbers[4 * row : 4 * row + 4]) for row in range(4)])
