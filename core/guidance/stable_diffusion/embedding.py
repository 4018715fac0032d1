"""Textual inversions on top of a checkpoint: new words, each some vectors (Gal et al. 2022)."""

from pathlib import Path
from typing import Final

from safetensors.torch import load_file
from torch import Tensor

from core.errors import UserError
from core.guidance.stable_diffusion.header import kind_of, read_header
from core.guidance.stable_diffusion.networks import readable

_NAMES: Final = ("emb_params", "clip_l", "clip_g")  # of tensors whose names are no word


def read_embedding(path: Path, widths: list[int]) -> tuple[set[str], list[Tensor]]:
    """The words of an embedding and its vectors, (n, width) for each text encoder.

    Its word is the file's name without the ending; diffusers' files hold one of their own, too.

    Raises:
        UserError: no textual inversion, or one for other text encoders.
    """
    kind = kind_of(read_header(path))
    if kind != "textual inversion":
        raise UserError(f'"{path}" is no textual inversion: it is {kind}.', "Give its own file.")
    with readable(path):
        tensors = load_file(path)
    names = ["clip_l", "clip_g"] if len(widths) == 2 else list(tensors)[:1]
    vectors = [tensors[name].float() for name in names if name in tensors]
    vectors = [v[None] if v.ndim == 1 else v for v in vectors]
    if [v.shape[-1] if v.ndim == 2 else None for v in vectors] != widths:
        found = " and ".join(str(tuple(t.shape)) for t in tensors.values())
        raise UserError(
            f'"{path}" is for other text encoders: its vectors are {found}, and this checkpoint\'s '
            f"are {' and '.join(map(str, widths))} wide.",
            "Use it with a checkpoint of the version it was trained for (1.x, 2.x or XL).",
        )
    lengths = {len(v) for v in vectors}
    if len(lengths) != 1 or 0 in lengths:
        has = "two lengths" if len(lengths) > 1 else "no vectors"
        raise UserError(f'"{path}" has {has}.', "Download it again.")
    return {path.stem, *(set(names) - set(_NAMES))}, vectors
