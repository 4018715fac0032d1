"""Camera, backdrop, exposure, Cycles settings, still pictures and the saved file."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix, Vector

from ..blender import compat
from ..blender.blend_output import temporary_blend
from ..blender.mesh_arrays import moved, verts_of
from ..blender.output import temporary_output
from ..errors import AddonError, OutputError
from . import light

CAMERA = "Fantasia3D camera"
FOVY = math.radians(24)  # a long lens: little distortion, as in product photographs
MARGIN = 1.12  # the picture's height in diameters of the object's bounding sphere
BACKDROP = 0.8  # linear grey
SIDE = math.radians(75)  # of a low sun from the camera, counter-clockwise from above
SKY = 0.45  # brightness of an evening's upper sky, of the backdrop's
WHITE = 0.9  # linear; the brightest that a white surface should be
FORMATS = {
    ".png": "PNG",
    ".jpg": "JPEG",
    ".jpeg": "JPEG",
    ".exr": "OPEN_EXR",
    ".tif": "TIFF",
    ".tiff": "TIFF",
    ".webp": "WEBP",
}


def bounding_sphere(obj: bpy.types.Object) -> tuple[Vector, float]:
    """Centre and radius, in the world, of the sphere about the middle of the bounding box."""
    return sphere_about(moved(verts_of(obj.data), obj.matrix_world))


def sphere_about(points: np.ndarray) -> tuple[Vector, float]:
    """Centre and radius of the sphere about the middle of the bounding box of ``points`` (N,3)."""
    center = (points.min(0) + points.max(0)) / 2
    return Vector(center), float(np.linalg.norm(points - center, axis=1).max())


def add_camera(
    scene: bpy.types.Scene,
    obj: bpy.types.Object,
    azimuth_deg: float = 32.0,
    elevation_deg: float = 16.0,
) -> bpy.types.Object:
    """A camera that sees all of ``obj``; azimuth 0 is at -Y and grows towards +X."""
    return add_camera_about(scene, *bounding_sphere(obj), azimuth_deg, elevation_deg)


def add_camera_about(
    scene: bpy.types.Scene,
    center: Vector,
    radius: float,
    azimuth_deg: float = 32.0,
    elevation_deg: float = 16.0,
) -> bpy.types.Object:
    """A camera that sees all of the sphere."""
    data = bpy.data.cameras.new(CAMERA)
    data.sensor_fit = "VERTICAL"
    data.angle = FOVY
    camera = bpy.data.objects.new(CAMERA, data)
    scene.collection.objects.link(camera)
    azimuth, elevation = math.radians(azimuth_deg), math.radians(elevation_deg)
    back = Vector(
        (
            math.sin(azimuth) * math.cos(elevation),
            -math.cos(azimuth) * math.cos(elevation),
            math.sin(elevation),
        )
    )
    # The cone of the view touches the sphere: sin, not tan.
    distance = MARGIN * radius / math.sin(FOVY / 2)
    camera.location = center + distance * back
    camera.rotation_euler = back.to_track_quat("Z", "Y").to_euler()
    # By the distance, so that an asset of any size is visible.
    data.clip_start, data.clip_end = distance / 100, distance * 100
    scene.camera = camera
    return camera


def save_blend(path: Path) -> None:
    """Save a copy of the open file as ``path``; an asset's pictures are packed already.

    Whatever the file refers to is found from the folder of ``path`` too.

    Raises:
        OutputError: the place can't be written.
    """
    with temporary_blend(path) as temporary:
        _save(temporary)


def _save(path: Path) -> None:
    bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True, relative_remap=True)


def render_still(path: Path, obj: bpy.types.Object, backdrop: bool = True) -> None:
    """Render ``obj`` through the scene's camera, with the scene's own settings.

    ``backdrop`` hides the world from the camera behind an even grey, with a ground that catches the
    shadow; it is removed again afterwards.

    Raises:
        OutputError: the place can't be written, or the picture's type is none of FORMATS.
    """
    scene = bpy.context.scene
    if path.suffix.lower() not in FORMATS:
        raise OutputError(f"{path} is not a picture.", f"Its name ends in {', '.join(FORMATS)}.")
    in_front = _backdrop(scene, obj) if backdrop else contextlib.nullcontext()
    with temporary_output(path) as temporary, in_front:
        scene.render.image_settings.file_format = FORMATS[path.suffix.lower()]
        # The path has its extension already.
        scene.render.use_file_extension = False
        scene.render.filepath = compat.render_path(temporary)
        bpy.ops.render.render(write_still=True)
        # The temporary path must not stay in the user's scene.
        scene.render.filepath = ""


@contextlib.contextmanager
def _backdrop(scene: bpy.types.Scene, obj: bpy.types.Object) -> Iterator[None]:
    """:func:`add_backdrop` for one picture."""
    world = scene.world
    ground = add_backdrop(scene, obj)
    mesh = ground.data
    try:
        yield
    finally:
        bpy.data.worlds.remove(scene.world)
        scene.world = world
        bpy.data.objects.remove(ground)
        bpy.data.meshes.remove(mesh)


def add_backdrop(scene: bpy.types.Scene, obj: bpy.types.Object) -> bpy.types.Object:
    """A shadow catcher under ``obj``, in front of an even grey.

    The scene's world becomes a copy that the camera does not see.
    """
    center, radius = bounding_sphere(obj)
    low = min((obj.matrix_world @ Vector(corner)).z for corner in obj.bound_box)
    half = 50 * radius  # beyond the picture's edges
    mesh = bpy.data.meshes.new("Ground")
    corners = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
    ground = bpy.data.objects.new("Ground", mesh)
    ground.location = (center.x, center.y, low)
    ground.is_shadow_catcher = True
    scene.collection.objects.link(ground)
    hide_world(scene)
    return ground


def hide_world(scene: bpy.types.Scene) -> None:
    """Give ``scene`` a copy of its world in which the camera sees an even grey."""
    # The user's own world stays as it is.
    scene.world = scene.world.copy()
    _hide_from_camera(scene.world.node_tree)


def _hide_from_camera(tree: bpy.types.NodeTree) -> None:
    """Mix an even grey into the world's ``tree``, for camera rays alone."""
    output = next(n for n in tree.nodes if n.bl_idname == "ShaderNodeOutputWorld")
    surface = output.inputs["Surface"]
    light_path = tree.nodes.new("ShaderNodeLightPath")
    grey = tree.nodes.new("ShaderNodeBackground")
    grey.inputs["Color"].default_value = (BACKDROP, BACKDROP, BACKDROP, 1)
    picture = next((n.image for n in tree.nodes if n.bl_idname == "ShaderNodeTexEnvironment"), None)
    glow = light.glow_of(picture) if picture else None
    if glow:  # an even grey would hide that it is evening
        tree.links.new(_evening_sky(tree, glow), grey.inputs["Color"])
    mix = tree.nodes.new("ShaderNodeMixShader")
    tree.links.new(
        light_path.outputs["Is Camera Ray"], mix.inputs[0]
    )  # by index: "Fac", later "Factor"
    tree.links.new(surface.links[0].from_socket, mix.inputs[1])
    tree.links.new(grey.outputs["Background"], mix.inputs[2])
    tree.links.new(mix.outputs["Shader"], surface)


def _evening_sky(tree: bpy.types.NodeTree, glow: light.Glow) -> bpy.types.NodeSocket:
    """From the picture's lower edge upwards: the light's own horizon, then its sky."""
    place, rows, ramp = (
        tree.nodes.new(f"ShaderNode{kind}") for kind in ("TexCoord", "SeparateXYZ", "ValToRGB")
    )
    scale = BACKDROP / float(glow.horizon.max())
    low, high = ramp.color_ramp.elements
    low.position, high.position = 0.25, 1.0
    low.color = (*(glow.horizon * scale), 1)
    # Its own hue, but brighter: a sky is many times darker than its horizon.
    high.color = (*(glow.sky / glow.sky.max() * BACKDROP * SKY), 1)
    tree.links.new(place.outputs["Window"], rows.inputs[0])
    tree.links.new(rows.outputs["Y"], ramp.inputs[0])
    return ramp.outputs["Color"]


def turn_low_sun(scene: bpy.types.Scene) -> None:
    """Turn the light of a sunset so that its sun is to the side of the scene's camera.

    From behind the camera it casts no shadow that is seen. Any other light stays as it is.
    """
    glow = light.glow_of(light.environment_image(scene.world))
    mapping = light.light_node(scene.world, "Mapping")
    if glow is None or mapping is None:
        return
    bpy.context.view_layer.update()
    x, y, _ = scene.camera.matrix_world.col[2][:3]  # away from what it sees
    turn = math.atan2(y, x) + SIDE - glow.azimuth
    mapping.inputs["Rotation"].default_value[2] = -turn


def expose(scene: bpy.types.Scene, obj: bpy.types.Object) -> None:
    """Set the world's strength so that white on ``obj`` is just not clipped.

    Computed for two white diffuse surfaces: one faces up, one faces the scene's camera.
    """
    center, _ = bounding_sphere(obj)
    towards = (scene.camera.matrix_world.translation - center).normalized()
    image = light.environment_image(scene.world)
    mapping = light.light_node(scene.world, "Mapping")
    if mapping is not None:  # the light's rotation, undone: the picture itself is not turned
        towards = Matrix.Rotation(mapping.inputs["Rotation"].default_value[2], 3, "Z") @ towards
    brightest = max(light.irradiance(image, normal) for normal in (towards, (0, 0, 1)))
    background = next(
        n for n in scene.world.node_tree.nodes if n.bl_idname == "ShaderNodeBackground"
    )
    background.inputs["Strength"].default_value = WHITE / max(brightest, 1e-6)


def set_up_cycles(scene: bpy.types.Scene, size: int = 640, samples: int | None = None) -> None:
    """Cycles on the CPU, a square picture, and colours without a look.

    ``samples`` is the maximum for a pixel; None or 0 is enough for a clean picture, which needs
    more without a denoiser.

    Raises:
        AddonError: this Blender has no Cycles.
    """
    if not compat.has_cycles():
        raise AddonError("This Blender has no Cycles.", "Enable its add-on Cycles Render Engine.")
    render, cycles, view = scene.render, scene.cycles, scene.view_settings
    denoise = compat.has_denoiser()
    render.engine = "CYCLES"
    render.resolution_x = render.resolution_y = size
    render.resolution_percentage = 100
    render.film_transparent = False
    # Dithering adds noise, and an even backdrop shows it.
    render.dither_intensity = 0.0
    cycles.device = "CPU"
    cycles.samples = samples or (24 if denoise else 160)
    cycles.use_adaptive_sampling = True
    cycles.adaptive_threshold = 0.04 if denoise else 0.01  # the even backdrop needs few
    cycles.adaptive_min_samples = 8 if denoise else 0  # 0: of Cycles' own choice, over 40 at .04
    cycles.use_denoising = denoise
    if denoise:  # high quality is a network twice as large: 8 of a chair's 24 s, hardly to be seen
        cycles.denoising_quality = "HIGH" if samples else "BALANCED"
    cycles.max_bounces = 14  # a wall of glass has two surfaces, and a jar two walls
    view.view_transform = "Standard"  # AgX would shift the material's own colours
    view.look, view.exposure, view.gamma = "None", 0.0, 1.0
