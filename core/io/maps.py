"""An asset's texture set and its files; emission and transmission only where they are needed."""

from pathlib import Path
from typing import Any, NamedTuple

from jaxtyping import Float
from torch import Tensor

from core.errors import UserError
from core.io import png as images

EMISSION_STRENGTH = 5.0  # times emission.png: the radiance
IOR = 1.45  # of what transmission.png lets light through
OPTIONAL = ("emission", "transmission")  # roles; in the order of :class:`Maps`
REMAKE = "Name the folder that holds asset.json, or make the asset again."
TO_PIXELS = {
    "base_color": images.srgb_bytes,
    "orm": images.unit_bytes,
    "normal": images.normal_words,
    "emission": images.srgb_bytes,
    "transmission": images.unit_bytes,
}
TO_VALUES = {
    "base_color": images.colors,
    "orm": images.units,
    "normal": images.normals,
    "emission": images.colors,
    "transmission": images.units,
}


class Maps(NamedTuple):
    """A square texture set; row 0 is the top. All values linear."""

    base_color: Float[Tensor, "s s 3"]  # linear Rec.709, in [0, 1]
    orm: Float[Tensor, "s s 3"]  # occlusion, roughness, metallic
    normal: Float[Tensor, "s s 3"]  # unit, tangent space, OpenGL: y along growing v
    emission: Float[Tensor, "s s 3"] | None = None  # times EMISSION_STRENGTH; None: nothing glows
    transmission: Float[Tensor, "s s 1"] | None = None  # its weight; None: nothing is clear


def write_maps(folder: Path, maps: Maps) -> None:
    """The maps' pictures; an optional one only where some of it is not zero."""
    for role, values in maps._asdict().items():
        pixels = None if values is None else TO_PIXELS[role](values)
        if pixels is not None and (role not in OPTIONAL or pixels.any()):
            images.write_png(folder / f"{role}.png", pixels)


def read_maps(folder: Path, info: dict[str, Any]) -> Maps:
    """Those that asset.json, ``info``, lists. Raises UserError for a broken one."""
    stated = info.get("files")
    there = stated if isinstance(stated, dict) else {}
    roles = [role for role in Maps._fields if role not in OPTIONAL or f"{role}.png" in there]
    found = {role: images.read_png(folder / f"{role}.png") for role in roles}
    for role, image in found.items():
        least = 1 if role == "transmission" else 3
        if image.shape[2] < least or image.shape[:2] != found["base_color"].shape[:2]:
            channels = {1: "a channel", 3: "three channels"}[least]
            raise UserError(
                f"{role}.png of {folder} has the shape {image.shape}, not {channels} and "
                "the size of base_color.png.",
                REMAKE,
            )
        found[role] = image[..., :least]
    return Maps(**{role: TO_VALUES[role](image) for role, image in found.items()})
