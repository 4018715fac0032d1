"""OpenEXR pictures, the only file that knows the library. Linear Rec.709, row 0 at the top."""

from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from core.errors import MissingError, UserError
from core.io.atomic import atomic_file
from core.io.input_file import check_file, check_name

# A larger picture is a broken header or an attack on the memory.
MAX_PIXELS = 1 << 27  # a light of 16384 x 8192
MAX_VALUES = 1 << 29  # of all channels and parts, which the library reads all; 2 GB
MAX_RATIO = 40_000  # values for each byte of a file; a flat picture packed by DWAA has 12,000


def read_exr(path: "str | Path") -> Float[Tensor, "h w 3"]:
    """The colours of an EXR file as float32; a single channel is grey; alpha is left out.

    Raises ``MissingError`` if there is no file or no library, ``UserError`` if it cannot be read.
    """
    check_file(Path(path), missing=MissingError)
    check_name(Path(path))
    library = load_library()
    try:
        _check_size(library, path)
        with library.File(str(path), separate_channels=True) as file:
            channels = {name: channel.pixels for name, channel in file.channels().items()}
    except UserError:
        raise
    except Exception as error:  # the library raises whatever its C++ side threw
        reason = str(error).rstrip(". ") or type(error).__name__
        if "Invalid part index" in reason:  # it gives up a part that it cannot decode
            reason = "it is broken or incomplete"
        raise UserError(
            f"{path} cannot be read as OpenEXR: {reason}.", "Save it again as a scanline EXR."
        ) from error
    planes = [find_channel(channels, letter) for letter in "RGB"]
    grey = find_channel(channels, "Y")
    found = [plane for plane in planes if plane is not None]
    if len(found) < 3 and grey is not None:
        found = [grey] * 3
    if len(found) < 3:
        names = ", ".join(sorted(channels)) or "none"
        raise UserError(
            f"{path} has no colour channels R, G, B or Y (it has: {names}).",
            "Save it again as RGB.",
        )
    if len({plane.shape for plane in found}) > 1 or found[0].ndim != 2 or not found[0].size:
        raise UserError(
            f"{path} has colour channels of different sizes, or empty ones.",
            "Save it again as RGB, each channel with all pixels.",
        )
    return torch.from_numpy(np.stack(found, -1).astype(np.float32))


def _check_size(library, path: "str | Path") -> None:
    """Before any memory is taken: the header alone states how much."""
    size = Path(path).stat().st_size
    with library.File(str(path), header_only=True) as file:
        values = 0
        for part in file.parts:
            low, high = part.header["dataWindow"]
            width, height = (int(b) - int(a) + 1 for a, b in zip(low, high, strict=True))
            values += width * height * len(part.header["channels"])
            if width * height > MAX_PIXELS or values > MAX_VALUES:
                raise UserError(
                    f"{path} declares {width} x {height} pixels, in all its channels more than "
                    f"{MAX_VALUES:,} values.",
                    "Make it smaller, or save it again with the colours alone.",
                )
        if values > MAX_RATIO * size:
            raise UserError(
                f"{path} declares {values:,} values, which cannot be in {size:,} bytes.",
                "Save it again.",
            )


def find_channel(channels: dict[str, np.ndarray], letter: str) -> np.ndarray | None:
    """The channel of that letter, in the plain layer or in the first one that has it."""
    names = sorted(name for name in channels if name.rpartition(".")[2].upper() == letter)
    plain = [name for name in names if "." not in name]
    return channels[(plain or names)[0]] if names else None


def write_exr(
    path: "str | Path", image: Float[Tensor, "h w c"] | Float[np.ndarray, "h w c"]
) -> None:
    """Writes 1 (Y), 3 (RGB) or 4 (RGBA) channels as 32-bit floats, whole or not at all."""
    letters = {1: "Y", 3: "RGB", 4: "RGBA"}[image.shape[-1]]
    pixels = torch.as_tensor(image).detach().to("cpu", torch.float32).numpy()
    channels = {letter: np.ascontiguousarray(pixels[..., i]) for i, letter in enumerate(letters)}
    library = load_library()
    header = {"compression": library.ZIP_COMPRESSION, "type": library.scanlineimage}
    check_name(Path(path))
    with atomic_file(Path(path)) as temporary:
        temporary.open("wb").close()  # for the system's own reason, which the library leaves out
        try:
            library.File(header, channels).write(str(temporary))
        except Exception as error:  # as above
            raise UserError(
                f"{path} cannot be written: {error}.", "Check that the disk has room."
            ) from error


def load_library():
    """The OpenEXR module, or a sentence that states how to install it."""
    try:
        import OpenEXR
    except ImportError as error:
        raise MissingError(
            "EXR pictures need the package OpenEXR, which is not installed.",
            "Run `python3 run.py doctor`.",
        ) from error
    return OpenEXR
