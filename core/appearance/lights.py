"""The lights to choose from: a studio made here, Blender's own, and files."""

import importlib.util
import math
import os
import shutil
import sys
from functools import cache
from pathlib import Path

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.latlong import convolve, directions
from core.errors import MissingError, UserError
from core.io.exr import read_exr
from core.io.hdr import read_hdr
from core.ops import normalize

STUDIO = "studio"
SUFFIXES = {".exr": read_exr, ".hdr": read_hdr}
# What a white diffuse surface sends out where the studio lights it best: kd 0.8 then reads 0.7.
STUDIO_BRIGHTEST = 0.7 / 0.8
MAX_RADIANCE = 6e4  # a float16's end: brighter texels are faults or would only be one


def load_light(name_or_path: "str | Path") -> Float[Tensor, "h w 3"]:
    """A lat-long map of linear radiance; orientation as in :mod:`core.appearance.latlong`.

    ``"studio"`` is made here; ``"blender:city"`` or, if there is no file of that name, ``"city"``
    is one of Blender's studio lights, found next to an installed Blender; anything else is a file,
    .exr or .hdr.

    Raises ``MissingError`` or ``UserError``.
    """
    name = str(name_or_path)
    if name == STUDIO:
        return studio()
    path = Path(name)
    if name.startswith("blender:") or not (path.suffix or path.is_file()):
        path = blender_light(name.removeprefix("blender:"))
    reader = SUFFIXES.get(path.suffix.lower())
    if reader is None:
        raise UserError(
            f"The light {path} is neither .exr nor .hdr.",
            "Give a lat-long map of one of these kinds.",
        )
    return checked(reader(path), path)


def checked(image: Float[Tensor, "h w 3"], path: Path) -> Float[Tensor, "h w 3"]:
    """``image`` if it can be a light. Where a half float is infinite, as the sun is in many a file,
    it is as bright as one can be."""
    height, width, _ = image.shape
    if width != 2 * height or height < 2:
        raise UserError(
            f"The light {path} is {width} x {height} pixels, not twice as wide as high.",
            "Give a full lat-long (equirectangular) panorama.",
        )
    if bool(image.isnan().any()):
        raise UserError(f"The light {path} has pixels that are not numbers.", "Save it again.")
    if not bool((image > 0).any()):
        raise UserError(f"The light {path} is black.", "Give a light that lights something.")
    return image.clamp(0, MAX_RADIANCE)


@cache
def studio(height: int = 256) -> Float[Tensor, "{height} 2*{height} 3"]:
    """Neutral light for showing an object: a grey dome, a large key, a weak fill, a rim.

    Everything is grey and soft, so that a material can be recognised in its picture. Seen from the
    front, the key is on the left and above, the rim on the right and behind. A diffuse surface
    with kd 0.8 reads 0.7 where it is lit best; no radiance is above 10.
    """
    d = directions(height, 2 * height)
    z = d[..., 2]
    # Brighter above than below, without an edge at the horizon.
    light = torch.lerp(torch.full_like(z, 0.18), torch.full_like(z, 0.62), smoothstep(-0.5, 0.8, z))
    for azimuth, elevation, radius, radiance in (
        (-40.0, 40.0, 32.0, 3.6),  # key
        (60.0, 15.0, 38.0, 0.8),  # fill
        (150.0, 35.0, 22.0, 2.6),  # rim
    ):
        light = light + radiance * softbox(d, azimuth, elevation, radius)
    # Scaled by the irradiance at the best lit normal: kd 0.8 must read the same whatever the
    # lights.
    brightest = convolve(light[..., None].expand(-1, -1, 3), lambda cos: cos.clamp(min=0)).max()
    return (light * (STUDIO_BRIGHTEST / brightest))[..., None].expand(-1, -1, 3).contiguous()


def softbox(
    d: Float[Tensor, "h w 3"], azimuth_deg: float, elevation_deg: float, radius_deg: float
) -> Float[Tensor, "h w"]:
    """1 inside a round of the sky, falling softly to 0; angles as a camera's."""
    a, e = math.radians(azimuth_deg), math.radians(elevation_deg)
    axis = d.new_tensor([math.sin(a) * math.cos(e), -math.cos(a) * math.cos(e), math.sin(e)])
    angle = torch.rad2deg(torch.acos((normalize(d) @ axis).clamp(-1, 1)))
    return 1 - smoothstep(0.75 * radius_deg, 1.25 * radius_deg, angle)


def smoothstep(low: float, high: float, x: Float[Tensor, "*b"]) -> Float[Tensor, "*b"]:
    """0 below ``low``, 1 above ``high``, a smooth cubic between."""
    t = ((x - low) / (high - low)).clamp(0, 1)
    return t * t * (3 - 2 * t)


def blender_light(name: str) -> Path:
    """The file of one of Blender's studio lights, by its name without suffix."""
    folders = [folder for root in blender_roots() for folder in light_folders(root)]
    for folder in folders:
        if (folder / f"{name}.exr").is_file():
            return folder / f"{name}.exr"
    names = sorted({path.stem for folder in folders for path in folder.glob("*.exr")})
    if names:
        raise MissingError(
            f"There is no light {name!r}.",
            f"Use studio, a .exr or .hdr file, or one of Blender's: {', '.join(names)}.",
        )
    raise MissingError(
        f"There is no light {name!r}, and no Blender was found whose lights could be used.",
        "Use studio or a .exr or .hdr file, or put Blender's folder on PATH.",
    )


def light_folders(root: Path) -> list[Path]:
    """The folders of world lights below a Blender installation, newest version first."""
    tail = Path("datafiles/studiolights/world")
    # Some roots are a version's own folder, others hold one folder for each version.
    found = [root / tail, *sorted(root.glob(f"*/{tail}"), reverse=True)]
    return [folder for folder in found if folder.is_dir()]


def blender_roots() -> list[Path]:
    """Where Blenders live on this machine: bpy's package, PATH, and the systems' usual places."""
    roots = [Path(os.environ[k]) for k in ("BLENDER_SYSTEM_RESOURCES",) if k in os.environ]
    if "BLENDER_SYSTEM_DATAFILES" in os.environ:
        roots.append(Path(os.environ["BLENDER_SYSTEM_DATAFILES"]).parent)
    spec = importlib.util.find_spec("bpy")  # looks, does not import
    if spec and spec.origin:
        roots.append(Path(spec.origin).parent)
    program = shutil.which("blender")
    if program:
        roots.append(Path(program).resolve().parent)
    if sys.platform == "darwin":
        roots.append(Path("/Applications/Blender.app/Contents/Resources"))
    elif sys.platform == "win32":
        base = Path(os.environ.get("PROGRAMFILES", "C:/Program Files"), "Blender Foundation")
        roots += sorted(base.glob("Blender *"), reverse=True)
    else:
        roots += [Path(p, "blender") for p in ("/usr/share", "/usr/local/share", "/opt")]
    return roots
