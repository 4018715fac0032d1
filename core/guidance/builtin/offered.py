"""The words that the shipped weights offer, read from their files' headers without a library."""

import json
import struct
from pathlib import Path
from typing import Any

from core.errors import MissingError
from core.guidance.builtin.nouns import NOUNS, row_of

WEIGHTS = Path(__file__).parent  # the two networks, next to the code that runs them
NETWORKS = ("geometry", "appearance")  # whose words are offered
PARTS = "parts"  # finds a thing's parts
SOLID = "solid"  # draws the geometry's start; its words are the geometry network's
RESTORER = "restorer"  # has no words of its own; may be missing


def read_metadata(path: Path) -> dict[str, Any]:
    """The metadata of a safetensors file.

    The file begins with the header's length as a 64-bit little-endian number, then the header as
    JSON: https://huggingface.co/docs/safetensors, "Format".

    Raises:
        ValueError: no such header.
    """
    with path.open("rb") as file:
        start = file.read(8)
        if len(start) < 8:
            raise ValueError("it has no header")
        (length,) = struct.unpack("<Q", start)
        # A broken file may state any length: never read more than there is.
        if length > path.stat().st_size:
            raise ValueError("its header is cut")
        header = json.loads(file.read(length))
    return {name: json.loads(text) for name, text in header["__metadata__"].items()}


def offered_words() -> dict[str, list[str]]:
    """The words by slot that the shipped networks know.

    Raises:
        MissingError: the weights are missing or broken.
    """
    words: dict[str, list[str]] = {}
    for name in NETWORKS:
        path = WEIGHTS / f"{name}.safetensors"
        try:
            words |= read_metadata(path)["words"]
        except (FileNotFoundError, ValueError, KeyError) as error:
            raise weights_error(path, error) from error
    known = set(words["noun"])
    more = (n for n, row in NOUNS.items() if row.solid in known or row.constructed)
    words["noun"] += [noun for noun in more if noun not in known]
    return words


def drawn_nouns() -> list[str]:
    """The known things with a solid of their own."""
    return [noun for noun in offered_words()["noun"] if row_of(noun) == noun]


def weights_error(path: Path, error: Exception) -> MissingError:
    """The error for weights that are missing or broken."""
    return MissingError(
        f"The built-in model's weights {path.name} are missing or broken ({error}).",
        "Download the project again, or train them: python -m core.prior train.",
    )
