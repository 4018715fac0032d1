"""Numbers into files and back: the curve, the bits, whole files only."""

import errno
import os
from pathlib import Path

import numpy as np
import pytest
import torch
from PIL import Image

from core.errors import UserError
from core.io import png as images
from core.io.atomic import atomic_file


def test_color_gets_its_curve_before_it_loses_bits() -> None:
    """Fault 2 of the released code cut kd to 8 bits while linear: dark steps of 12 in sRGB."""
    dark = torch.linspace(0, 0.02, 256).view(1, 256, 1).expand(1, 256, 3)
    coded = images.srgb_bytes(dark)
    assert len(np.unique(coded)) == coded.max() + 1  # no step is left out
    assert images.srgb_bytes(torch.full((1, 1, 3), 0.18))[0, 0, 0] == 118


def test_color_round_trip() -> None:
    every = np.arange(256, dtype=np.uint8).reshape(16, 16, 1).repeat(3, 2)
    assert np.array_equal(images.srgb_bytes(images.colors(every)), every)


def test_out_of_range_is_cut_not_wrapped() -> None:
    x = torch.tensor([[[-0.1, 0.5, 1.7]]])
    assert images.srgb_bytes(x)[0, 0].tolist() == [0, 188, 255]
    assert images.unit_bytes(x)[0, 0].tolist() == [0, 128, 255]


def test_normals_below_zero_stay_dark() -> None:
    """Fault 1 of the released code: its normal map wrapped around."""
    n = torch.tensor([[[-1.0, 0, 0], [0, -1.2, 0], [0, 0, 1], [0.6, 0, 0.8]]])
    words = images.normal_words(n)
    assert words[0].tolist() == [
        [0, 32768, 32768], [32768, 0, 32768], [32768, 32768, 65535], [52428, 32768, 58982],
    ]  # fmt: skip


def test_normals_keep_sixteen_bits() -> None:
    n = torch.nn.functional.normalize(torch.randn(8, 8, 3), dim=-1)
    assert (images.normals(images.normal_words(n)) - n).abs().max() < 2 / 65535


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
@pytest.mark.parametrize("channels", [3, 4])
def test_png_round_trip(tmp_path: Path, dtype: type, channels: int) -> None:
    """Every bit comes back, and the file states 16 where it has 16."""
    rng = np.random.default_rng(0)
    image = rng.integers(0, np.iinfo(dtype).max, (5, 7, channels), dtype, endpoint=True)
    images.write_png(tmp_path / "a.png", image)
    back = images.read_png(tmp_path / "a.png")
    assert back.dtype == dtype
    assert np.array_equal(back, image)
    bit_depth = (tmp_path / "a.png").read_bytes()[24]  # of the IHDR chunk
    assert bit_depth == np.dtype(dtype).itemsize * 8


def test_a_tensor_is_written_as_it_is(tmp_path: Path) -> None:
    images.write_png(tmp_path / "a.png", torch.full((2, 3, 3), 0.5))
    with Image.open(tmp_path / "a.png") as picture:
        assert picture.size == (3, 2)
        assert picture.getpixel((0, 0)) == (128, 128, 128)


def test_unreadable_pictures_are_reported(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="no picture"):
        images.read_png(tmp_path / "none.png")
    (tmp_path / "bad.png").write_bytes(b"hello")
    with pytest.raises(UserError, match="is not a readable PNG"):
        images.read_png(tmp_path / "bad.png")
    images.write_png(tmp_path / "cut.png", np.zeros((64, 64, 3), np.uint16))
    whole = (tmp_path / "cut.png").read_bytes()
    (tmp_path / "cut.png").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(UserError, match="is not a readable PNG"):
        images.read_png(tmp_path / "cut.png")


@pytest.mark.parametrize(
    ("number", "words"),
    [(errno.ENOSPC, "disk is full"), (errno.EACCES, "cannot be written: permission denied")],
)
def test_what_the_disk_refuses_is_reported(tmp_path: Path, number: int, words: str) -> None:
    """The older file stays, nothing is next to it."""
    (tmp_path / "a.txt").write_text("old")

    def write() -> None:
        with atomic_file(tmp_path / "a.txt") as temporary:
            temporary.write_text("half")
            raise OSError(number, os.strerror(number))

    with pytest.raises(UserError, match=words):
        write()
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]
    assert (tmp_path / "a.txt").read_text() == "old"


def test_other_faults_keep_their_name(tmp_path: Path) -> None:
    def write() -> None:
        with atomic_file(tmp_path / "a.txt") as temporary:
            temporary.write_text("half")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        write()
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_is_reported(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="cannot be written"):
        images.write_png(tmp_path / "none" / "a.png", np.zeros((2, 2, 3), np.uint8))


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a disk that is always full")
def test_a_full_disk_is_seen_though_the_library_reports_success(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "full.tmp").symlink_to("/dev/full")
    monkeypatch.setattr("core.io.atomic.temporary", lambda _: tmp_path / "full.tmp")
    noise = np.random.default_rng(0).integers(0, 255, (256, 256, 3), np.uint8)
    with pytest.raises(UserError, match="disk is full"):
        images.write_png(tmp_path / "a.png", noise)
    assert not (tmp_path / "a.png").exists()
