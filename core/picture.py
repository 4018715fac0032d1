"""The ``render`` command: a picture of an asset under a light, shaded as in the training."""

import math
from dataclasses import replace
from pathlib import Path

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.environment import Environment, load_light
from core.appearance.seen_through import render_clear
from core.appearance.shaded import UvMesh, surface_at
from core.camera import Cameras
from core.errors import UserError
from core.geometry.mesh import normalise
from core.io.asset import Asset, check_output, read_asset
from core.io.exr import write_exr
from core.io.png import write_png
from core.ops import linear_to_srgb, srgb_to_linear
from core.render.antialias import antialias
from core.render.normals import render_normals
from core.render.rasterizer import rasterize, scatter
from core.stages.preview import over_grey
from core.texture.look_up import emission_source, maps_source, transmission_source

MAPS = ("shaded", "normal", "base_color", "roughness", "metallic", "mask")
FRAMING = 3.0  # training units: the distance that shows the whole asset


def render_asset(
    folder: Path,
    out: Path,
    *,
    map: str = "shaded",
    light: str = "studio",
    azimuth_deg: float = 30.0,
    elevation_deg: float = 20.0,
    fovy_deg: float = 40.0,
    distance: float | None = None,
    size: int = 512,
) -> None:
    """Write a picture of the asset in ``folder`` to a PNG or EXR file.

    Args:
        map: one of MAPS; normals are in the object's frame.
        distance: metres from the asset's middle; None shows all of it.
        size: pixels along a side.

    Raises:
        UserError: no asset, an unknown map or file type, numbers out of range.
    """
    _check(out, map, distance, size)
    check_output(out)
    _check_angles(azimuth_deg, elevation_deg, fovy_deg)
    asset = read_asset(folder)
    verts, _, scale = normalise(asset.mesh.verts)
    far = FRAMING if distance is None else distance * scale
    cameras = Cameras.orbit([azimuth_deg], [elevation_deg], far, fovy_deg)
    picture, o = _draw(asset, verts, cameras, map=map, size=size, light=light)
    if out.suffix.lower() == ".exr":
        write_exr(out, torch.cat([picture.expand(-1, -1, 3), o], -1))
    else:
        write_png(out, over_grey(encoded(picture, o, map), o))


def _check(out: Path, map: str, distance: float | None, size: int) -> None:
    if map not in MAPS:
        raise UserError(f"There is no map {map!r}.", f"Use one of {', '.join(MAPS)}.")
    if out.suffix.lower() not in (".png", ".exr"):
        raise UserError(f"{out} is not a PNG or EXR file.", "Use a name that ends in .png or .exr.")
    if distance is not None and not 0 < distance < math.inf:
        raise UserError(f"The distance is {distance} m.", "Use more than 0.")
    if not 1 <= size <= 8192:
        raise UserError(f"The size is {size}.", "Use 1 to 8192 pixels.")


def _check_angles(azimuth_deg: float, elevation_deg: float, fovy_deg: float) -> None:
    if not -36000 <= azimuth_deg <= 36000:  # false for NaN too; beyond, float32 loses the degree
        raise UserError(f"The azimuth is {azimuth_deg}°.", "Use -36000 to 36000.")
    if not -90 <= elevation_deg <= 90:
        raise UserError(f"The elevation is {elevation_deg}°.", "Use -90 to 90.")
    if not 1 <= fovy_deg <= 170:
        raise UserError(f"The field of view is {fovy_deg}°.", "Use 1 to 170.")


@torch.no_grad()
def _draw(
    asset: Asset, verts: Tensor, cameras: Cameras, *, map: str, size: int, light: str
) -> tuple[Float[Tensor, "h w c"], Float[Tensor, "h w 1"]]:
    """The map over black, weighted by coverage, linear; and the coverage."""
    mesh = UvMesh.of(replace(asset.mesh, verts=verts))
    if map in ("normal", "mask"):
        n, o = render_normals(mesh.verts, mesh.faces, cameras, size, "object")
        return (n if map == "normal" else o)[0], o[0]
    source = maps_source(asset.maps)
    if map == "shaded":
        environment = Environment.of(load_light(light))
        emission, clear = emission_source(asset.maps), transmission_source(asset.maps)
        seen = render_clear(mesh, source, clear, cameras, size, environment, emission)
        return srgb_to_linear(seen.srgb[0]), seen.o[0]
    # A map alone, without light: the material's values, antialiased together with their coverage.
    fragments = rasterize(mesh.verts, mesh.faces, cameras.mvp, size, size, cull=mesh.closed)
    surface = surface_at(mesh, fragments, cameras)
    material = source(surface.points, surface.uv)
    values = material.kd if map == "base_color" else getattr(material, map).expand(-1, 3)
    values = torch.cat([values, torch.ones_like(values[:, :1])], -1)
    picture = antialias(scatter(values, fragments), fragments, mesh.faces, mesh.edges)[0]
    return picture[..., :3], picture[..., 3:]


def encoded(picture: Float[Tensor, "h w c"], o: Float[Tensor, "h w 1"], map: str) -> Tensor:
    """The picture as a PNG shows it, over black: colours in sRGB, normals as 0.5 + 0.5 n."""
    if map == "normal":
        return (picture + o) / 2
    if map in ("shaded", "base_color"):
        return linear_to_srgb(picture)
    return picture.expand(-1, -1, 3)
