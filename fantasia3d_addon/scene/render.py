"""A scene to look at an asset: the camera, the render, and the saved file."""

from __future__ import annotations

import contextlib
import math
import tempfile
from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

from ..blender import compat
from ..blender.mesh_arrays import moved, verts_of
from ..errors import AddonError, OutputError
from . import light

CAMERA = "Fantasia3D camera"
FOVY = math.radians(24)  # a long lens: little distortion, as in product photographs
MARGIN = 1.12  # of the picture over the object's bounding sphere
BACKDROP = 0.8  # linear grey
WHITE = 0.9  # linear; what a white surface shows at its brightest
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
    """A camera that sees all of ``obj``; azimuth 0 stands at -Y and grows towards +X."""
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
    distance = MARGIN * radius / math.sin(FOVY / 2)
    camera.location = center + distance * back
    camera.rotation_euler = back.to_track_quat("Z", "Y").to_euler()
    data.clip_start, data.clip_end = distance / 100, distance * 100
    scene.camera = camera
    return camera


def save_blend(path: Path) -> None:
    """Save the open file as ``path``, aside and then renamed; its pictures are packed already.

    Raises:
        OutputError: the place can't be written.
    """
    with _aside(path) as aside:
        _save(aside)


def _save(path: Path) -> None:
    bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True)


def render_still(path: Path, obj: bpy.types.Object, backdrop: bool = True) -> None:
    """Render ``obj`` through the scene's camera, with the scene's own settings.

    ``backdrop`` hides the world from the camera behind a neutral ground that takes the shadow;
    it is gone again afterwards.

    Raises:
        OutputError: the place can't be written, or the picture's type is none of FORMATS.
    """
    scene = bpy.context.scene
    if path.suffix.lower() not in FORMATS:
        raise OutputError(f"{path} is no picture.", f"Its name ends in {', '.join(FORMATS)}.")
    with _aside(path) as aside, _backdrop(scene, obj) if backdrop else contextlib.nullcontext():
        scene.render.image_settings.file_format = FORMATS[path.suffix.lower()]
        scene.render.use_file_extension = False
        scene.render.filepath = str(aside)
        bpy.ops.render.render(write_still=True)
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
    """A ground under ``obj`` that shows its shadow alone, before an even grey.

    The scene's world becomes a copy that the camera does not see.
    """
    center, radius = bounding_sphere(obj)
    low = min((obj.matrix_world @ Vector(corner)).z for corner in obj.bound_box)
    half = 50 * radius
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
    """Give ``scene`` a copy of its world that the camera does not see: it sees an even grey."""
    scene.world = scene.world.copy()
    _hide_from_camera(scene.world.node_tree)


def _hide_from_camera(tree: bpy.types.NodeTree) -> None:
    """Put an even grey before the world that ``tree`` shows, for rays from the camera alone."""
    output = next(n for n in tree.nodes if n.bl_idname == "ShaderNodeOutputWorld")
    surface = output.inputs["Surface"]
    light_path = tree.nodes.new("ShaderNodeLightPath")
    grey = tree.nodes.new("ShaderNodeBackground")
    grey.inputs["Color"].default_value = (BACKDROP, BACKDROP, BACKDROP, 1)
    mix = tree.nodes.new("ShaderNodeMixShader")
    tree.links.new(light_path.outputs["Is Camera Ray"], mix.inputs[0])  # "Fac", later "Factor"
    tree.links.new(surface.links[0].from_socket, mix.inputs[1])
    tree.links.new(grey.outputs["Background"], mix.inputs[2])
    tree.links.new(mix.outputs["Shader"], surface)


def expose(scene: bpy.types.Scene, obj: bpy.types.Object) -> None:
    """Set the world's strength so that white on ``obj`` is just not clipped.

    Measured on two matt surfaces: one that faces up, one that faces the scene's camera.
    """
    center, _ = bounding_sphere(obj)
    towards = (scene.camera.matrix_world.translation - center).normalized()
    image = light.environment_image(scene.world)
    brightest = max(light.irradiance(image, normal) for normal in (towards, (0, 0, 1)))
    background = next(
        n for n in scene.world.node_tree.nodes if n.bl_idname == "ShaderNodeBackground"
    )
    background.inputs["Strength"].default_value = WHITE / max(brightest, 1e-6)


def set_up_cycles(scene: bpy.types.Scene, size: int = 640, samples: int | None = None) -> None:
    """Cycles on the CPU, a square picture, and colours as they are.

    ``samples`` is the most that one pixel gets; None is enough for a clean picture, which without
    a denoiser takes more.

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
    render.dither_intensity = 0.0
    cycles.device = "CPU"
    cycles.samples = samples or (48 if denoise else 160)
    cycles.use_adaptive_sampling = True
    cycles.adaptive_threshold = 0.04 if denoise else 0.01  # the even backdrop is done at once
    cycles.use_denoising = denoise
    cycles.max_bounces = 6
    view.view_transform = "Standard"  # AgX would shift the material's own colours
    view.look, view.exposure, view.gamma = "None", 0.0, 1.0


@contextlib.contextmanager
def _aside(path: Path) -> Iterator[Path]:
    """A file in a folder of its own beside ``path``, which takes its place at the end."""
    path = path.expanduser().absolute()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".fantasia3d-", dir=path.parent) as folder:
            aside = Path(folder) / path.name
            yield aside
            if not aside.is_file() or not aside.stat().st_size:
                raise OSError(0, "Blender wrote nothing")
            aside.replace(path)
    except (OSError, RuntimeError) as error:  # RuntimeError: what Blender's operators report
        reason = getattr(error, "strerror", None) or str(error).strip()
        raise OutputError(f"{path} can't be written ({reason}).", "Choose another place.") from None
