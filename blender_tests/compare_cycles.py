"""The same asset, light and camera in Cycles and in the core, for the tests that compare pixels.

Pixels are points in both: no filter, no antialias. This file may import both sides of the border.
"""

import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import bpy
import numpy as np
import torch
from jaxtyping import Bool, Float
from torch import Tensor

from core.appearance.brdf import (
    MIN_ALPHA,
    fresnel_dielectric,
    ggx_d,
    hammersley,
    schlick_weight,
    smith_g2,
    smith_lambda,
    visible_normals,
)
from core.appearance.environment import Environment
from core.appearance.lamps import split_lamps
from core.appearance.latlong import Levels, convolve, resample
from core.appearance.lights import load_light
from core.appearance.occlusion import VertexVisibility
from core.appearance.shade import shade
from core.appearance.shaded import UvMesh, surface_at
from core.camera import Cameras
from core.io.asset import read_asset
from core.io.exr import read_exr
from core.ops import dot, linear_to_srgb, normalize
from core.render.rasterizer import interpolate, rasterize
from core.texture.look_up import maps_source
from fantasia3d_addon.asset.import_asset import import_asset
from fantasia3d_addon.scene import light, render

CAMERA = Cameras.orbit([35.0], [25.0])
KD = (0.8, 0.35, 0.1)
RADIUS = 0.9


def empty_scene(
    lit_by: Path, size: int, samples: int, bounces: int = 1, seen_by: Cameras = CAMERA
) -> None:
    """A new file with a light and a camera, as the add-on sets it up but for pixels."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    here = bpy.context.scene
    render.set_up_cycles(here, size, samples)
    cycles = here.cycles
    cycles.use_denoising = cycles.use_adaptive_sampling = False
    cycles.max_bounces = bounces
    cycles.sample_clamp_indirect = cycles.sample_clamp_direct = cycles.blur_glossy = 0
    cycles.pixel_filter_type, cycles.filter_width = "BLACKMAN_HARRIS", 0.01
    here.render.threads_mode, here.render.threads = "FIXED", 1
    here.render.film_transparent = True
    world = light.set_world(here, lit_by)
    # A quarter as wide a map as Cycles' own takes 1.9 s less, and the noise hardly grows.
    world.cycles.sampling_method, world.cycles.sample_map_resolution = "MANUAL", 1024
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    here.collection.objects.link(camera)
    camera.data.sensor_fit, camera.data.angle = "VERTICAL", float(seen_by.fovy)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = seen_by.rotation[0].T.numpy(), seen_by.eye[0].numpy()
    camera.matrix_world = matrix.T.tolist()  # as columns, which is how bpy takes a flat matrix
    here.camera = camera


def add_ball(roughness: float, metallic: float) -> None:
    """A ball of radius RADIUS and colour KD."""
    mesh = bpy.data.meshes.new("ball")
    verts, faces = ball_mesh(256, 128)
    mesh.from_pydata(verts, (), faces)
    mesh.shade_smooth()
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("ball", mesh))
    material = bpy.data.materials.new("ball")
    material.use_nodes = True
    principled = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    principled.distribution = "GGX"
    principled.inputs["Base Color"].default_value = (*KD, 1)
    principled.inputs["Roughness"].default_value = roughness
    principled.inputs["Metallic"].default_value = metallic
    mesh.materials.append(material)


def ball_mesh(around: int, rings: int) -> tuple[np.ndarray, list[list[int]]]:
    """Vertices and faces of four corners, at the poles of three. Blender's own takes 18 s."""
    up, turn = np.pi * np.arange(1, rings) / rings, 2 * np.pi * np.arange(around) / around
    u, w = np.meshgrid(up, turn, indexing="ij")
    points = np.stack([np.sin(u) * np.cos(w), np.sin(u) * np.sin(w), np.cos(u)], -1)
    verts = RADIUS * np.concatenate([points.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    here = np.arange((rings - 1) * around).reshape(rings - 1, around)
    after = np.roll(here, -1, 1)
    sides = np.stack([here[:-1], here[1:], after[1:], after[:-1]], -1).reshape(-1, 4)
    pole = np.full(around, len(verts) - 2)
    top = np.stack([pole, here[0], after[0]], -1)
    bottom = np.stack([pole + 1, after[-1], here[-1]], -1)
    return verts, [*sides.tolist(), *top.tolist(), *bottom.tolist()]


@cache
def prefiltered(light: str) -> Environment:
    """A light of ``load_light``; made once, which takes a second."""
    return Environment.of(load_light(light))


def add_asset(folder: Path) -> None:
    """The asset in ``folder`` as the add-on imports it, its middle where the camera looks."""
    import_asset(bpy.context.scene, folder, location=(-middle_of(folder)).tolist())


def middle_of(folder: Path) -> Float[Tensor, "3"]:
    """Of the bounding box."""
    verts = read_asset(folder).mesh.verts
    return (verts.amin(0) + verts.amax(0)) / 2


def cycles_pixels(path: Path) -> tuple[Float[Tensor, "h w 3"], Bool[Tensor, "h w"]]:
    """Linear colours of the open scene, and where a surface is seen; written to ``path``."""
    here = bpy.context.scene
    here.render.image_settings.file_format = "OPEN_EXR"
    here.render.image_settings.color_depth = "32"
    here.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    pixels = torch.tensor(np.array(image.pixels[:], dtype=np.float32)).view(height, width, 4)
    pixels = pixels.flip(0)
    assert torch.equal(read_exr(path), pixels[..., :3]), "the core reads what Blender wrote"
    return pixels[..., :3], pixels[..., 3] > 0.5


def ball_points(
    size: int,
) -> tuple[Bool[Tensor, "s s"], Float[Tensor, "p 3"], Float[Tensor, "p 3"]]:
    """Where CAMERA sees the ball; there, the normals and the directions to the eye."""
    at = (torch.arange(size, dtype=torch.float64) + 0.5) / size * 2 - 1
    y, x = torch.meshgrid(-at, at, indexing="ij")
    back = torch.linalg.inv(CAMERA.mvp[0].double())
    far = torch.stack([x, y, torch.ones_like(x), torch.ones_like(x)], -1) @ back.T
    eye = CAMERA.eye[0].double()
    ray = normalize(far[..., :3] / far[..., 3:] - eye)
    along = ray @ eye
    inside = along.square() - eye @ eye + RADIUS**2
    seen = inside > 0
    point = (eye + ray * (-along - inside.clamp(min=0).sqrt())[..., None])[seen]
    return seen, normalize(point).float(), normalize(eye - point).float()


def asset_pixels(
    folder: Path,
    size: int,
    environment: Environment,
    self_shadow: bool = False,
    seen_by: Cameras = CAMERA,
) -> tuple[Float[Tensor, "h w 3"], Bool[Tensor, "h w"]]:
    """The core's picture of an asset, and where it is."""
    asset = read_asset(folder)
    mesh = UvMesh.of(replace(asset.mesh, verts=asset.mesh.verts - middle_of(folder)))
    fragments = rasterize(mesh.verts, mesh.faces, seen_by.mvp, size, size, cull=mesh.closed)
    surface = surface_at(mesh, fragments, seen_by)
    m = maps_source(asset.maps)(surface.points, surface.uv)
    occlusion = None
    if self_shadow:
        occlusion = interpolate(
            VertexVisibility.of(mesh.verts, mesh.faces).occlusion(environment), fragments
        )
    color = shade(surface.shading_normal(m.kn), surface.to_eye, *m[:3], environment, occlusion)
    picture = torch.zeros(size * size, 3).index_copy(0, fragments.pixel, color)
    return picture.view(size, size, 3), fragments.face_id[0] >= 0


def inner(seen: Bool[Tensor, "h w"]) -> Bool[Tensor, "h w"]:
    """Without the outline's pixels, where the two round differently."""
    outside = (~seen).float()[None, None]
    return torch.nn.functional.max_pool2d(outside, 3, 1, 1)[0, 0] < 0.5


def psnr(a: Float[Tensor, "*b 3"], b: Float[Tensor, "*b 3"]) -> float:
    """Peak signal-to-noise ratio of linear colours as the Standard view shows them, dB."""
    a, b = (linear_to_srgb(x.clamp(0, 1)) for x in (a, b))
    return float(-10 * torch.log10((a - b).square().mean()))


class Exact:
    """Eqs. 7 and 8 integrated point by point over 1024 visible normals; slow.

    A sample reads the light as blurred as the sample's part of the sphere is wide, so that 1024
    are enough; what is too small for that, the lamps, is shaded as it is.
    """

    SIGMA = 2 * math.pi / 1024  # of level k: SIGMA * 2**k radians

    def __init__(self, image: Float[Tensor, "h w 3"], samples: int = 1024) -> None:
        rest, self.lamps = split_lamps(resample(image, 512, 1024))
        small = resample(rest, 128, 256)
        self.irradiance = Levels.of([convolve(small, lambda cos: cos.clamp(min=0))])
        blurred = []
        for level, rows in enumerate((256, 256, 128, 128, 64, 64, 64, 64), start=1):
            # The texels' own width and that of reading between them are in it already.
            width = (self.SIGMA * 2**level) ** 2 - (math.pi / rows) ** 2 / 4
            blurred.append(
                convolve(resample(rest, rows, 2 * rows), lambda c, w=width: ((c - 1) / w).exp())
            )
        self.maps = Levels.of([rest, *blurred])
        self.samples = hammersley(samples)

    def shade(
        self,
        normal: Float[Tensor, "p 3"],
        view: Float[Tensor, "p 3"],
        kd: Float[Tensor, "p 3"],
        roughness: Float[Tensor, "p 1"],
        metallic: Float[Tensor, "p 1"],
    ) -> Float[Tensor, "p 3"]:
        """As :func:`core.appearance.shade.shade`."""
        parts = zip(*(x.split(256) for x in (normal, view, roughness)), strict=True)
        kinds = torch.cat([self.specular(*part) for part in parts])
        albedo, kinds = kinds[..., 3:], kinds[..., :3]
        lamp = self.lamps.reflected(normal, view, dot(normal, view).clamp(min=1e-3), roughness)
        base, schlick, coat = (kinds.transpose(0, 1) + lamp).unbind(0)
        passed = 1 - albedo[:, 2] / (albedo[:, 0] + albedo[:, 1])
        diffuse = kd * passed * (self.irradiance.read(normal) + self.lamps.irradiance(normal))
        return metallic * (kd * base + schlick) + (1 - metallic) * (diffuse + coat)

    def specular(
        self, normal: Float[Tensor, "p 3"], view: Float[Tensor, "p 3"], roughness: Tensor
    ) -> Float[Tensor, "p 3 4"]:
        """Reflected light, and under a light of 1, for the three Fresnel terms; without lamps."""
        alpha = roughness.square().clamp(min=MIN_ALPHA)
        cos_v = dot(normal, view).clamp(1e-3, 1)
        sin_v = (1 - cos_v.square()).sqrt()
        along = normalize(view - cos_v * normal, 1e-20)
        across = torch.linalg.cross(normal, along)
        h = visible_normals(cos_v, alpha, self.samples)
        cos_d = sin_v * h[..., 0] + cos_v * h[..., 2]
        x, y, z = (
            2 * cos_d * h[..., 0] - sin_v,
            2 * cos_d * h[..., 1],
            2 * cos_d * h[..., 2] - cos_v,
        )
        masked = 1 + smith_lambda(cos_v, alpha)
        weight = masked * smith_g2(cos_v, z.clamp(min=1e-5), alpha) * (z > 0)
        density = ggx_d(h[..., 2], alpha) / (4 * masked * cos_v)
        width = (1 / (len(self.samples) * density * 2 * math.pi)).sqrt()
        light = x[..., None] * along[:, None] + y[..., None] * across[:, None]
        light = light + z[..., None] * normal[:, None]
        level = (width / self.SIGMA).log2().clamp(min=0).reshape(-1)
        radiance = self.maps.read(light.reshape(-1, 3), level).view_as(light)
        cos_d = cos_d.clamp(0, 1)
        schlick = schlick_weight(cos_d)
        kinds = torch.stack([1 - schlick, schlick, fresnel_dielectric(cos_d)], 1) * weight[:, None]
        reflected = torch.cat([radiance, torch.ones_like(radiance[..., :1])], -1)
        return torch.bmm(kinds, reflected) / len(self.samples)
