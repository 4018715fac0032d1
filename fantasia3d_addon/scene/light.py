"""The world's light: an HDR or EXR picture, the core's studio, or one of Blender's lights."""

from __future__ import annotations

import math
import re
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import bpy
import numpy as np

from ..blender import compat
from ..blender.input_file import require_file
from ..environment.files import expanded, is_file
from ..errors import LightError

WORLD = "Fantasia3D light"
STUDIO = "studio"
MAX_PIXELS = 1 << 27  # of a light, 16384 x 8192: as in the core
WARM = 3.0  # red over blue at the horizon of a sunset
CYCLES_MAP = 4096  # texels, the width of Cycles' own map
HEADER = 1 << 16  # bytes in which the size is declared
EXR_WINDOW = b"dataWindow\0box2i\0"  # then the length of the four numbers, and they
# The core's own studio light as a file; blender_tests/test_light.py has the command.
STUDIO_FILE = Path(__file__).with_name("studio.exr")


@cache  # a panel asks for them at each drawing
def blender_lights() -> Mapping[str, Path]:
    """The world lights that come with this Blender, by name."""
    folder = Path(bpy.utils.system_resource("DATAFILES")) / "studiolights" / "world"
    return {path.stem: path for path in sorted(folder.glob("*.exr"))}


def light_file(name_or_path: str) -> Path:
    """The picture of a light; names have the same meaning as in the core.

    ``"studio"`` is the core's; ``"blender:city"`` or ``"city"`` one of Blender's; else a file.

    Raises:
        LightError: there is none.
    """
    if name_or_path == STUDIO:
        return STUDIO_FILE
    # A file comes before a name: "city" may be a file of the user's.
    path = expanded(bpy.path.abspath(name_or_path), LightError)
    if is_file(path):
        return path.resolve()
    named = blender_lights()
    name = name_or_path.removeprefix("blender:")
    if name in named:
        return named[name]
    raise LightError(
        f"There is no light {name_or_path!r}.",
        f"Use an HDR or EXR file, or one of {', '.join([STUDIO, *named])}.",
    )


def set_world(
    scene: bpy.types.Scene,
    path: Path,
    strength: float = 1.0,
    rotation_deg: float = 0.0,
) -> bpy.types.World:
    """Light ``scene`` from all sides by the lat-long picture ``path``, which is packed.

    ``rotation_deg`` turns the light counter-clockwise seen from above. The picture's middle
    column is at +X, its top at +Z.

    Raises:
        LightError: the file is not a picture.
    """
    image = _load(path)
    world = bpy.data.worlds.new(WORLD)
    tree = compat.empty_nodes(world)
    nodes = {
        kind: tree.nodes.new(f"ShaderNode{kind}")
        for kind in ("TexCoord", "Mapping", "TexEnvironment", "Background", "OutputWorld")
    }
    for column, node in enumerate(nodes.values()):
        node.location = (300 * column - 900, 0)
    # The node rotates the direction that is looked up: the light itself turns the other way.
    nodes["Mapping"].inputs["Rotation"].default_value[2] = -math.radians(rotation_deg)
    nodes["TexEnvironment"].image = image
    nodes["Background"].inputs["Strength"].default_value = strength
    for source, out, sink, into in (
        ("TexCoord", "Generated", "Mapping", "Vector"),
        ("Mapping", "Vector", "TexEnvironment", "Vector"),
        ("TexEnvironment", "Color", "Background", "Color"),
        ("Background", "Background", "OutputWorld", "Surface"),
    ):
        tree.links.new(nodes[source].outputs[out], nodes[sink].inputs[into])
    compat.deselect_nodes(tree)
    _map_importance(world, image.size[0])
    # The new world is complete before the old one is touched.
    old, scene.world = scene.world, world
    _remove_unused(old)
    return world


def _map_importance(world: bpy.types.World, width: int) -> None:
    """Cycles finds the bright places by a map, which by itself is 4096 texels wide: of each frame
    a second of a core. Four times the picture's width is as good."""
    if 4 * width < CYCLES_MAP and hasattr(world, "cycles"):  # Cycles may be switched off
        world.cycles.sampling_method = "MANUAL"
        world.cycles.sample_map_resolution = 4 * max(width, 1)


def light_node(world: bpy.types.World | None, kind: str) -> bpy.types.Node | None:
    """The node of :func:`set_world` of ``kind``: "Mapping", "Background", "TexEnvironment"."""
    if world is None or not world.name.startswith(WORLD) or not world.node_tree:
        return None
    return next((n for n in world.node_tree.nodes if n.bl_idname == f"ShaderNode{kind}"), None)


def environment_image(world: bpy.types.World) -> bpy.types.Image:
    """The picture that :func:`set_world` lights ``world`` with."""
    return next(n.image for n in world.node_tree.nodes if n.bl_idname == "ShaderNodeTexEnvironment")


def irradiance(image: bpy.types.Image, normal: Sequence[float]) -> float:
    """The brightness of a white diffuse surface that faces ``normal``, under a lat-long ``image``.

    The mean luminance over the hemisphere about ``normal``, weighted by the cosine with it.
    """
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    # Luminance by Rec. 709.
    luminance = pixels.reshape(height, width, 4)[..., :3] @ np.float32((0.2126, 0.7152, 0.0722))
    azimuth = (0.5 - (np.arange(width) + 0.5) / width) * 2 * math.pi  # from +X, counter-clockwise
    elevation = ((np.arange(height)[:, None] + 0.5) / height - 0.5) * math.pi  # row 0 is the lowest
    x, y, z = normal
    flat = x * np.cos(azimuth) + y * np.sin(azimuth)
    cosine = np.cos(elevation) * flat + np.sin(elevation) * z
    # A lat-long picture's rows shrink towards the poles: cos(elevation) is a texel's area.
    weight = np.cos(elevation) * cosine.clip(0)
    return float((luminance * weight).sum() / weight.sum())


@dataclass(frozen=True)
class Glow:
    """The sky about a low, warm sun; linear colours as the picture has them."""

    azimuth: float  # of the sun, radians from +X, counter-clockwise from above
    horizon: np.ndarray  # (3,) mean colour of the sky just above the horizon, about the sun
    sky: np.ndarray  # (3,) and higher up


def glow_of(image: bpy.types.Image) -> Glow | None:
    """The sunset in a lat-long picture; None for any other light.

    The horizon about its brightest direction is red rather than blue, and much brighter than the
    sky as a whole.
    """
    width, height = image.size
    if not width * height:  # its file is lost
        return None
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    picture = pixels.reshape(height, width, 4)[..., :3]
    above = picture[height // 2 :]  # row 0 is the lowest
    per_degree = height / 180
    low = above[: max(1, round(12 * per_degree))].mean(0)  # (W,3)
    near = max(1, width // 8)  # 45 degrees to each side
    around = np.stack([np.roll(low, shift, 0) for shift in range(-near, near + 1)]).mean(0)
    column = int(around.sum(1).argmax())
    columns = np.arange(column - near, column + near + 1) % width
    high = above[round(25 * per_degree) : max(1, round(45 * per_degree))]
    if not len(high):
        return None
    horizon, sky = around[column], high[:, columns].mean((0, 1))
    is_warm = horizon[0] > WARM * horizon[2]
    if not is_warm or horizon.sum() < 2 * above.mean((0, 1)).sum():
        return None
    azimuth = (0.5 - (column + 0.5) / width) * 2 * math.pi
    return Glow(azimuth, horizon, sky)


def _remove_unused(world: bpy.types.World | None) -> None:
    """Remove an earlier light of ours that no scene uses; keep the user's own world."""
    if world is None:
        return
    if not world.name.startswith(WORLD):
        world.use_fake_user = True  # without users, Blender would not save it
        return
    if world.users:
        return
    node = light_node(world, "TexEnvironment")  # which the user may have removed, or its picture
    image = node.image if node else None
    bpy.data.worlds.remove(world)
    if image and not image.users:
        bpy.data.images.remove(image)


def _check_size(path: Path) -> None:
    """By the header, since Blender takes the memory for any size that a file declares."""
    try:
        require_file(path)
        with path.open("rb") as file:
            head = file.read(HEADER)
    except OSError as error:
        raise LightError(f"{path} can't be read ({error.strerror}).", "Choose another.") from None
    width = height = 0
    if found := re.search(rb"\n[-+][XY] (\d+) [-+][XY] (\d+)\n", head):
        width, height = (int(number[:9]) for number in found.groups())
    elif (start := head.find(EXR_WINDOW)) >= 0 and len(head) >= start + len(EXR_WINDOW) + 20:
        low_x, low_y, high_x, high_y = struct.unpack_from("<4i", head, start + len(EXR_WINDOW) + 4)
        width, height = high_x - low_x + 1, high_y - low_y + 1
    if width * height > MAX_PIXELS:
        raise LightError(f"{path} declares {width} x {height} pixels.", "Use a smaller picture.")


def _load(path: Path) -> bpy.types.Image:
    _check_size(path)
    try:
        image = bpy.data.images.load(str(path), check_existing=False)
    except RuntimeError as error:
        raise LightError(f"{path} can't be read ({error}).", "Use an HDR or EXR file.") from None
    if 0 in image.size:  # Blender loads any file, and reports nothing
        bpy.data.images.remove(image)
        raise LightError(f"{path} is not a picture.", "Use an HDR or EXR file.")
    if not _is_finite(image):
        bpy.data.images.remove(image)
        raise LightError(
            f"{path} holds pixels that are not finite numbers.", "Save it again without them."
        )
    # The .blend must open on another machine.
    image.pack()
    return image


def _is_finite(image: bpy.types.Image) -> bool:
    """Whether all pixels are finite numbers; a NaN would spread over all that it lights."""
    if not image.is_float:
        return True
    pixels = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(pixels)
    return bool(np.isfinite(pixels).all())
