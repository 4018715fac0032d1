"""The 3D views of the open windows: what they show, framing, local view."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
import numpy as np
from mathutils import Matrix, Vector

SENSOR = 36.0  # millimetres; a view is as wide as a lens on twice the sensor of a camera
MIN_SIZE = 0.1  # of the view's height or width: in what is smaller no shape is seen
MAX_SIZE = 2.0
FRAMED = 0.6  # of the view that a framed object covers
TOO_FAR = 3.0  # view distances


def areas(scene: bpy.types.Scene) -> Iterator[tuple[bpy.types.Window, bpy.types.Area]]:
    """The 3D views that show ``scene``, the largest first."""
    found = [
        (window, area)
        for window in bpy.context.window_manager.windows
        if window.scene == scene
        for area in window.screen.areas
        if area.type == "VIEW_3D"
    ]
    yield from sorted(found, key=lambda item: -item[1].width * item[1].height)


def frame_if_unseen(scene: bpy.types.Scene, obj: bpy.types.Object) -> bool:
    """Turn the largest 3D view to ``obj`` where no view shows it; whether one was turned.

    A view through a camera stays: it is a picture that the user composed.
    """
    center, radius = _sphere(obj)
    found = [area for _, area in areas(scene)]
    if any(_sees(area, center, radius) for area in found):
        return False
    free = [area for area in found if _region_3d(area).view_perspective != "CAMERA"]
    if free:
        _frame(free[0], center, radius)
    return bool(free)


def focus(scene: bpy.types.Scene, area: bpy.types.Area | None = None) -> Vector:
    """The point of the ground, or else of the air, that the view is centred on.

    ``area`` is the 3D view; None: the largest one. The cursor's location where there is none.
    """
    if area is None or area.type != "VIEW_3D":
        area = next((found for _, found in areas(scene)), None)
    if area is None:
        return scene.cursor.location.copy()
    region_3d = _region_3d(area)
    center, distance = region_3d.view_location.copy(), region_3d.view_distance
    forward = region_3d.view_rotation @ Vector((0, 0, -1))
    start = center - distance * forward
    down = -start.z / forward.z if abs(forward.z) > 1e-6 else -1.0
    ground = start + down * forward
    return ground if 0 < down < TOO_FAR * distance else center


def eye(scene: bpy.types.Scene) -> Vector | None:
    """Where the largest 3D view looks from; None where there is none, or a camera's view."""
    area = next((area for _, area in areas(scene)), None)
    if area is None or _region_3d(area).view_perspective == "CAMERA":
        return None
    region_3d = _region_3d(area)
    back = region_3d.view_rotation @ Vector((0, 0, 1))
    return region_3d.view_location + region_3d.view_distance * back


def hides_colors(space: bpy.types.Space | None) -> bool:
    """Whether a 3D view shows grey where an asset has its colours."""
    if space is None or space.type != "VIEW_3D":
        return False
    shading = space.shading
    return shading.type == "WIREFRAME" or (
        shading.type == "SOLID" and shading.color_type != "TEXTURE"
    )


def show_colors(space: bpy.types.SpaceView3D, in_solid: bool = False) -> None:
    """Show the materials in a 3D view; ``in_solid``: only the base colour, in Solid shading."""
    space.shading.type = "SOLID" if in_solid else "MATERIAL"
    if in_solid:
        space.shading.color_type = "TEXTURE"


def toggle_local_view(
    area: bpy.types.Area, window: bpy.types.Window, obj: bpy.types.Object
) -> None:
    """Show ``obj`` alone in ``area``, or everything again."""
    if area.spaces.active.local_view:
        _local_view(window, area)
        return
    layer = window.view_layer
    active, selected = layer.objects.active, list(layer.objects.selected)
    hidden = obj.hide_select
    for other in selected:
        other.select_set(False, view_layer=layer)
    try:
        obj.hide_select = False  # the operator shows what is selected, and a preview can't be
        layer.update()  # or it still can't
        obj.select_set(True, view_layer=layer)
        _local_view(window, area)
    finally:
        obj.select_set(False, view_layer=layer)
        obj.hide_select = hidden
        for other in selected:
            other.select_set(True, view_layer=layer)
        layer.objects.active = active


def leave_local_views(obj: bpy.types.Object) -> None:
    """Show everything again where nothing but ``obj`` is shown: it will be removed."""
    for scene in obj.users_scene:
        for window, area in areas(scene):
            space, others = area.spaces.active, set(window.view_layer.objects) - {obj}
            if space.local_view and not any(is_shown(other, space) for other in others):
                _local_view(window, area)


def is_shown(obj: bpy.types.Object, space: bpy.types.SpaceView3D) -> bool:
    """Whether a 3D view shows ``obj``, local view considered."""
    # The evaluated object alone knows; local_view_get() is false for all objects (4.3, 4.5).
    graph = bpy.context.evaluated_depsgraph_get()
    return obj.evaluated_get(graph).visible_in_viewport_get(space)


def _local_view(window: bpy.types.Window, area: bpy.types.Area) -> None:
    """Enter local view with what is selected, framed; or leave it, to where the view was before."""
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.view3d.localview(frame_selected=True)


def _region_3d(area: bpy.types.Area) -> bpy.types.RegionView3D:
    return area.spaces.active.region_3d


def _half_view(area: bpy.types.Area) -> np.ndarray:
    """Half of the view's width and height at a distance of 1 (Blender's lens on twice SENSOR)."""
    region = next(region for region in area.regions if region.type == "WINDOW")
    size = np.array([max(region.width, 1), max(region.height, 1)], np.float64)
    return SENSOR / area.spaces.active.lens * size / size.max()


def _sees(area: bpy.types.Area, center: Vector, radius: float) -> bool:
    """Whether the sphere's centre is in the view, neither tiny nor larger than the view."""
    region_3d, space = _region_3d(area), area.spaces.active
    if region_3d.view_perspective == "CAMERA" and space.camera:
        return _camera_sees(area, center)
    back = region_3d.view_rotation @ Vector((0, 0, 1))
    eye = region_3d.view_location + region_3d.view_distance * back
    turn = region_3d.view_rotation.to_matrix().transposed()
    x, y, z = turn @ (center - eye)
    # Orthographic: as large everywhere as at the view's distance.
    depth = -z if region_3d.view_perspective == "PERSP" else region_3d.view_distance
    if depth <= 0:
        return False
    half = depth * _half_view(area)
    size = radius / half.min()
    return bool(abs(x) < 0.9 * half[0] and abs(y) < 0.9 * half[1] and MIN_SIZE < size < MAX_SIZE)


def _camera_sees(area: bpy.types.Area, center: Vector) -> bool:
    camera = area.spaces.active.camera
    graph = bpy.context.evaluated_depsgraph_get()
    matrix: Matrix = camera.calc_matrix_camera(graph, x=1920, y=1080)
    point = matrix @ camera.matrix_world.inverted() @ center.to_4d()
    return point.w > 0 and abs(point.x) < point.w and abs(point.y) < point.w


def _frame(area: bpy.types.Area, center: Vector, radius: float) -> None:
    region_3d = _region_3d(area)
    region_3d.view_location = center
    region_3d.view_distance = radius / (FRAMED * float(_half_view(area).min()))


def _sphere(obj: bpy.types.Object) -> tuple[Vector, float]:
    corners = [obj.matrix_world @ Vector(corner) for corner in obj.bound_box]
    center = sum(corners, Vector()) / 8
    return center, max((corner - center).length for corner in corners)
