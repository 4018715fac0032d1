"""The core's pictures against Cycles: the same light, camera and material give the same picture.

This file may import both sides of the border.
"""

import math
from pathlib import Path

import numpy as np
import pytest
import torch

bpy = pytest.importorskip("bpy")

from core.appearance.environment import Environment  # noqa: E402
from core.appearance.latlong import directions  # noqa: E402
from core.appearance.lights import load_light  # noqa: E402
from core.camera import Cameras  # noqa: E402
from core.exr import read_exr, write_exr  # noqa: E402
from core.ops import linear_to_srgb, normalize  # noqa: E402
from core.render.normals import vertex_normals  # noqa: E402
from core.render.rasterizer import interpolate, rasterize  # noqa: E402
from core.render.shade import shade  # noqa: E402

pytestmark = pytest.mark.blender

SIZE = 64
CAMERA = Cameras.orbit([35.0], [25.0])
KD = (0.8, 0.35, 0.1)


@pytest.fixture(scope="module")
def light_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Coloured lights in unlike directions: no turned or mirrored map looks the same."""
    d = directions(256, 512)
    image = torch.full_like(d, 0.15)
    for axis, color, sharpness in (
        ((1, 0, 0.2), (3, 0.3, 0.3), 12),
        ((0, 1, 0.5), (0.2, 3, 0.2), 20),
        ((-0.3, -1, 0.1), (0.3, 0.5, 4), 30),
        ((0.2, -0.6, 1), (4, 4, 3), 40),
        ((-1, 0.3, -0.6), (2, 0, 2), 8),
    ):
        axis = normalize(torch.tensor(axis, dtype=torch.float32))
        lobe = torch.exp(sharpness * (d @ axis - 1))
        image = image + lobe[..., None] * torch.tensor(color)
    path = tmp_path_factory.mktemp("light") / "light.exr"
    write_exr(path, image)
    return path


def blender_scene(light: Path, roughness: float, metallic: float):
    """A ball of radius 0.9 under ``light``, seen by CAMERA; returns its mesh."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 96, False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = 1
    scene.cycles.sample_clamp_indirect = scene.cycles.sample_clamp_direct = 0
    scene.cycles.blur_glossy = 0
    # Pixels as points, as the core shades them.
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BLACKMAN_HARRIS", 0.01
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.film_transparent = True
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"

    bpy.ops.mesh.primitive_uv_sphere_add(segments=192, ring_count=96, radius=0.9)
    bpy.ops.object.shade_smooth()
    ball = bpy.context.object
    material = bpy.data.materials.new("ball")
    material.use_nodes = True
    principled = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    principled.distribution = "GGX"
    principled.inputs["Base Color"].default_value = (*KD, 1)
    principled.inputs["Roughness"].default_value = roughness
    principled.inputs["Metallic"].default_value = metallic
    ball.data.materials.append(material)

    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    tree = scene.world.node_tree
    texture = tree.nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(str(light))
    background = next(n for n in tree.nodes if n.type == "BACKGROUND")
    tree.links.new(texture.outputs["Color"], background.inputs["Color"])

    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.data.sensor_fit, camera.data.angle = "VERTICAL", float(CAMERA.fovy)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = CAMERA.rotation[0].T.numpy(), CAMERA.eye[0].numpy()
    camera.matrix_world = matrix.T.tolist()  # as columns, which is how bpy takes a flat matrix
    scene.camera = camera
    return ball.data


def cycles_picture(path: Path) -> tuple[torch.Tensor, torch.Tensor]:
    """Colour and coverage of the current scene."""
    bpy.context.scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    pixels = torch.tensor(np.array(image.pixels[:], dtype=np.float32)).view(SIZE, SIZE, 4).flip(0)
    assert torch.equal(read_exr(path), pixels[..., :3]), "the core reads what Blender wrote"
    return pixels[..., :3], pixels[..., 3]


def core_picture(mesh, environment: Environment, roughness: float, metallic: float):
    """Colour and coverage of the same ball in the core."""
    mesh.calc_loop_triangles()
    faces = np.empty(len(mesh.loop_triangles) * 3, np.int32)
    mesh.loop_triangles.foreach_get("vertices", faces)
    verts = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", verts)
    verts = torch.from_numpy(verts).view(-1, 3)
    faces = torch.from_numpy(faces.astype(np.int64)).view(-1, 3)
    fragments = rasterize(verts, faces, CAMERA.mvp, SIZE, SIZE)
    normal = normalize(interpolate(vertex_normals(verts, faces), fragments))
    view = normalize(CAMERA.eye - interpolate(verts, fragments))
    like = torch.ones_like(normal[:, :1])
    color = shade(
        normal, view, torch.tensor(KD) * like, roughness * like, metallic * like, environment
    )
    image = torch.zeros(SIZE * SIZE, 3).index_copy(0, fragments.pixel, color)
    return image.view(SIZE, SIZE, 3), (fragments.face_id[0] >= 0).float()


def psnr(a: torch.Tensor, b: torch.Tensor) -> float:
    """Peak signal-to-noise ratio in sRGB, dB."""
    a, b = (linear_to_srgb(x.clamp(0, 1)) for x in (a, b))
    return float(-10 * torch.log10((a - b).square().mean()))


# What the core reaches under this light, less 2 dB.
@pytest.mark.parametrize(
    ("roughness", "metallic", "least"),
    [(0.05, 1.0, 34), (0.3, 0.0, 40), (0.5, 1.0, 41), (0.8, 0.0, 41)],
)
def test_ball_looks_as_in_cycles(
    light_file: Path, tmp_path: Path, roughness: float, metallic: float, least: float
) -> None:
    mesh = blender_scene(light_file, roughness, metallic)
    theirs, their_cover = cycles_picture(tmp_path / "cycles.exr")
    environment = Environment.of(load_light(light_file))
    ours, our_cover = core_picture(mesh, environment, roughness, metallic)
    # Cycles traces the ray, the core rounds the outline's pixels on its own.
    assert float((our_cover - their_cover).abs().sum()) < 0.005 * SIZE * SIZE
    both = (our_cover > 0.5) & (their_cover > 0.5)
    result = psnr(ours[both], theirs[both])
    turned = core_picture(mesh, environment.rotated(math.pi), roughness, metallic)[0]
    assert psnr(turned[both], theirs[both]) < result - 10
    print(f"roughness {roughness} metallic {metallic}: {result:.1f} dB")
    assert result > least
