"""Radiance pictures (.hdr), read by OpenImageIO."""

from pathlib import Path

import torch
from jaxtyping import Float
from torch import Tensor

from core.errors import MissingError, UserError
from core.io.input_file import check_file
from core.io.oiio import UnreadableError, read_pixels


def read_hdr(path: "str | Path") -> Float[Tensor, "h w 3"]:
    """Linear colours of a Radiance RGBE file, row 0 at the top, as Blender reads them.

    Raises ``MissingError`` if there is no file, ``UserError`` if it is no such picture.
    """
    check_file(Path(path), missing=MissingError)
    try:
        return torch.from_numpy(read_pixels(Path(path), "hdr"))
    except UnreadableError as error:
        raise UserError(
            f"{path} cannot be read as a Radiance picture: {error}.",
            "Save it again as .hdr (RGBE, top row first) or as .exr.",
        ) from error
