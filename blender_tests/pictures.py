"""Small renders and their pixels, for the tests."""

from pathlib import Path

import bpy
import numpy as np

from fantasia3d_addon.blender import compat
from fantasia3d_addon.scene import light
from fantasia3d_addon.scene import render as scene_render


def write_hdr(path: Path, picture: np.ndarray) -> Path:
    """``picture`` (H,W,3), linear, row 0 at the top, as Radiance RGBE without compression."""
    height, width, _ = picture.shape
    mantissa, exponent = np.frexp(picture.max(-1))
    scale = np.where(picture.max(-1) > 1e-32, mantissa * 256 / picture.max(-1).clip(1e-32), 0)
    rgbe = np.concatenate([picture * scale[..., None], (exponent + 128)[..., None]], -1)
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode()
    path.write_bytes(header + rgbe.clip(0, 255).astype(np.uint8).tobytes())
    return path


def lobe(direction: tuple[float, float, float], height: int = 32) -> np.ndarray:
    """A lat-long light (H,2H,3) that comes from ``direction``; Blender's orientation."""
    azimuth = (0.5 - (np.arange(2 * height) + 0.5) / (2 * height)) * 2 * np.pi
    elevation = (0.5 - (np.arange(height)[:, None] + 0.5) / height) * np.pi
    flat = np.cos(elevation)
    z = np.broadcast_to(np.sin(elevation), (height, 2 * height))
    d = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), z], -1)
    axis = np.array(direction) / np.linalg.norm(direction)
    return np.repeat(20 * np.exp(30 * (d @ axis - 1))[..., None], 3, -1)


def add_ball(at: tuple[float, float, float] = (0, 0, 0)) -> bpy.types.Object:
    """A white, matt ball of radius 0.5."""
    verts, faces = [(0, 0, 0.5)], []
    rings, around = 24, 32
    for i in range(1, rings):
        for j in range(around):
            t, p = np.pi * i / rings, 2 * np.pi * j / around
            verts.append(
                (0.5 * np.sin(t) * np.cos(p), 0.5 * np.sin(t) * np.sin(p), 0.5 * np.cos(t))
            )
    verts.append((0, 0, -0.5))
    last = len(verts) - 1
    for j in range(around):
        k = (j + 1) % around
        faces.append((0, 1 + j, 1 + k))
        faces.append((last, last - around + k, last - around + j))
        for i in range(rings - 2):
            a = 1 + i * around
            faces.append((a + j, a + around + j, a + around + k, a + k))
    mesh = bpy.data.meshes.new("Ball")
    mesh.from_pydata(verts, [], faces)
    mesh.shade_smooth()
    obj = bpy.data.objects.new("Ball", mesh)
    obj.location = at
    bpy.context.scene.collection.objects.link(obj)
    return obj


def paint_white(obj: bpy.types.Object) -> None:
    """A white, matt material."""
    material = bpy.data.materials.new("white")
    tree = compat.empty_nodes(material)
    white = tree.nodes.new("ShaderNodeBsdfDiffuse")
    white.inputs["Color"].default_value = (1, 1, 1, 1)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(white.outputs["BSDF"], output.inputs["Surface"])
    obj.data.materials.append(material)


def linear(srgb: np.ndarray) -> np.ndarray:
    """sRGB above its toe as linear light."""
    return ((srgb + 0.055) / 1.055) ** 2.4


def render(
    obj: bpy.types.Object,
    folder: Path,
    azimuth_deg: float = 0.0,
    elevation_deg: float = 0.0,
    size: int = 64,
    samples: int = 8,
    backdrop: bool = False,
) -> np.ndarray:
    """The picture (H,W,3) as sRGB from 0 to 1, row 0 at the top, without the denoiser."""
    target = bpy.context.scene
    bpy.context.view_layer.update()
    scene_render.add_camera(target, obj, azimuth_deg, elevation_deg)
    bpy.context.view_layer.update()
    scene_render.set_up_cycles(target, size, samples)
    return shoot(obj, folder / "picture.png", backdrop)


def shoot(obj: bpy.types.Object, path: Path, backdrop: bool = False) -> np.ndarray:
    """The same with the camera and the settings that are there."""
    target = bpy.context.scene
    target.cycles.use_denoising = False
    target.cycles.use_adaptive_sampling = False
    target.world.cycles.sampling_method = "MANUAL"  # a small map: the tests' lights are smooth
    target.world.cycles.sample_map_resolution = 64
    target.render.threads_mode, target.render.threads = "FIXED", 1
    scene_render.render_still(path, obj, backdrop)
    return read(path)


def read(path: Path) -> np.ndarray:
    """The pixels (H,W,3) of a picture file, unconverted, row 0 at the top."""
    image = bpy.data.images.load(str(path), check_existing=False)
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)[::-1, :, :3]


def set_light(folder: Path, direction: tuple[float, float, float], **options: float) -> None:
    """Light the scene from ``direction`` alone."""
    path = write_hdr(folder / "light.hdr", lobe(direction))
    light.set_world(bpy.context.scene, path, **options)
