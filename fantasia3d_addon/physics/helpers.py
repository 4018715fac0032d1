"""The objects that are made for a simulation: cages, hulls, colliders, a sheet, a ground."""

from __future__ import annotations

import bpy

# Custom property: on the asset, what clear() needs; on objects made for it, the token in that, or
# the asset's name where an earlier version made them.
MARK = "fantasia3d_physics"
# On objects of the user's that were made one for a simulation: the collider of a cloth, a body.
COLLIDER, BODY = f"{MARK}_collider", f"{MARK}_body"
COLLECTION = "Fantasia3D Physics"


def is_simulated(obj: bpy.types.Object) -> bool:
    """Whether ``obj`` was simulated by this add-on."""
    return hasattr(obj.get(MARK), "to_dict")


def made_for(obj: bpy.types.Object) -> list[bpy.types.Object]:
    """The helpers of the simulation of ``obj``; none where it is a copy of a simulated object."""
    helpers = [o for o in bpy.data.objects if is_helper(o)]
    if not (token := token_of(obj)):  # of an earlier version, whose helpers have the name
        return [o for o in helpers if o[MARK] == obj.name]
    # A copy has the token too, and a name that comes later: "chair.001".
    copies = [o for o in bpy.data.objects if token_of(o) == token]
    original = next((o for o in copies if o.name == o[MARK]["name"]), copies[0])
    return [o for o in helpers if o[MARK] == token] if obj == original else []


def token_of(obj: bpy.types.Object) -> str:
    """The token of the object and its simulation's helpers; "" where it is not simulated.

    Not its name, which the user may change, nor a pointer to it, which would keep it when it is
    deleted.
    """
    return obj[MARK].to_dict().get("token", "") if is_simulated(obj) else ""


def is_helper(obj: bpy.types.Object) -> bool:
    return MARK in obj and not is_simulated(obj)


def is_local(obj: bpy.types.Object) -> bool:
    """Whether ``obj`` is this file's own: another's can't be made a collider, or be removed."""
    return not (obj.library or obj.override_library)


def add(
    obj: bpy.types.Object, part: str, mesh: bpy.types.Mesh, hidden: bool = True
) -> bpy.types.Object:
    """A new object for the simulation of ``obj``, in its collections; ``hidden`` in all views."""
    made = bpy.data.objects.new(f"{obj.name} {part}", mesh)
    made[MARK] = token_of(obj)
    own = obj.users_collection or [bpy.context.scene.collection]
    for collection in [_hidden_collection()] if hidden else own:
        collection.objects.link(made)
    if hidden:
        made.hide_render = True
        made.display_type = "WIRE"
        made.hide_set(True)
    return made


def _hidden_collection() -> bpy.types.Collection:
    """The scene's collection of cages, hulls and colliders, which no view shows."""
    scene = bpy.context.scene
    found = next((c for c in scene.collection.children if MARK in c), None)
    if found is None:
        found = bpy.data.collections.new(COLLECTION)
        found[MARK] = True
        scene.collection.children.link(found)
        found.hide_render = True
    return found


def remove(made: bpy.types.Object) -> None:
    mesh, collections = made.data, made.users_collection
    bpy.data.objects.remove(made)
    if not mesh.users:
        bpy.data.meshes.remove(mesh)
    for collection in collections:
        if MARK in collection and not collection.all_objects:
            bpy.data.collections.remove(collection)
