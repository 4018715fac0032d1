"""A base colour that Γ starts from, and a uv that is kept as it is."""

from pathlib import Path

import numpy as np
import pytest
import torch
from PIL import Image

from core.appearance.material import MaterialNet
from core.config import AppearanceConfig, TextureConfig
from core.errors import UserError
from core.geometry.mesh import Mesh
from core.io.job import Job
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.ops import srgb_to_linear
from core.stages.start_color import fit_base_color, sample, start_picture, surface_colors
from core.stages.texturing import unwrap_shape

CORNERS = torch.tensor([[0.0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]])
FACES = torch.tensor([[0, 1, 2], [0, 2, 3]])
WALL = Mesh(CORNERS, FACES, CORNERS[:, [0, 2]].contiguous(), FACES)


def ramp(size: int = 64) -> torch.Tensor:
    """Red grows with u, green with v."""
    at = (torch.arange(size) + 0.5) / size
    u, v = at.expand(size, -1), (1 - at)[:, None].expand(-1, size)
    return torch.stack([u, v, torch.zeros(size, size)], -1)


def test_a_texels_middle_has_its_colour_and_the_picture_repeats():
    uv = torch.tensor([[0.5 / 64, 0.5 / 64], [1 - 0.5 / 64, 0.5 / 64], [1.25, -0.25]])
    expected = torch.tensor([[0.5 / 64, 0.5 / 64], [1 - 0.5 / 64, 0.5 / 64], [0.25, 0.75]])
    torch.testing.assert_close(sample(ramp(), uv)[:, :2], expected, atol=1e-5, rtol=0)


def test_points_of_the_surface_have_the_colour_of_their_place():
    points, colors = surface_colors(WALL, ramp(), 2000, torch.Generator().manual_seed(0))
    inner = (points[:, [0, 2]] - 0.5).abs().amax(1) < 0.49
    torch.testing.assert_close(colors[inner, :2], points[inner][:, [0, 2]], atol=1e-4, rtol=0)


def test_the_material_takes_the_colour_and_nothing_else():
    generator = torch.Generator().manual_seed(0)
    net = MaterialNet(AppearanceConfig(log2_hash_size=14, finest=256), generator)
    with torch.no_grad():
        before = net(CORNERS)
    error = fit_base_color(net, WALL, ramp(), generator, steps=120)
    assert error < 0.04
    points, colors = surface_colors(WALL, ramp(), 500, torch.Generator().manual_seed(1))
    with torch.no_grad():
        found = net(points)
    assert float((found.kd - colors.clamp(0.03, 0.97)).abs().mean()) < 0.04
    assert float((found.roughness - before.roughness.mean()).abs().max()) < 0.08
    assert float((found.metallic - before.metallic.mean()).abs().max()) < 0.1


def test_a_picture_is_read_as_srgb_and_the_meshs_own_is_taken_as_it_is(tmp_path):
    Image.new("RGBA", (2, 2), (255, 128, 0, 255)).save(tmp_path / "a.png")
    picture = start_picture(str(tmp_path / "a.png"), WALL)
    torch.testing.assert_close(picture[0, 0], srgb_to_linear(torch.tensor([1, 128 / 255, 0])))
    Image.fromarray(np.full((2, 2), 128 * 257, np.uint16)).save(tmp_path / "grey.png")  # 16 bit
    grey = start_picture(str(tmp_path / "grey.png"), WALL)
    torch.testing.assert_close(grey[0, 0], srgb_to_linear(torch.full((3,), 128 / 255)))
    Image.fromarray(np.ones((2, 2), np.float32)).save(tmp_path / "float.tif")
    with pytest.raises(UserError, match="no known range"):
        start_picture(str(tmp_path / "float.tif"), WALL)
    own = Mesh(CORNERS, FACES, WALL.uv, FACES, ramp())
    assert start_picture("mesh", own) is own.base_color


@pytest.mark.parametrize(
    ("name", "mesh", "message"),
    [
        ("none.png", WALL, "There is no file"),
        (__file__, WALL, "is not a picture"),
        ("mesh", WALL, "holds no texture"),
        ("mesh", Mesh(CORNERS, FACES), "no UV map"),
    ],
)
def test_a_base_colour_that_is_not_there_is_refused(name, mesh, message):
    with pytest.raises(UserError, match=message):
        start_picture(name, mesh)


def test_a_base_colour_belongs_to_texture():
    with pytest.raises(UserError, match="needs a mesh"):
        Job(prompt="x", base_color="a.png")
    with pytest.raises(UserError, match="no uv mode 'mine'"):
        Job(prompt="x", uv="mine")


def kept(uv: torch.Tensor | None, tmp_path: Path):
    shape = Mesh(CORNERS, FACES, uv, None if uv is None else FACES)
    run = RunFolder.create(tmp_path, Job(prompt="x"))
    return unwrap_shape(shape, TextureConfig(), Progress(run), keep_uv=True).mesh


def test_an_own_uv_that_can_take_no_texture_is_refused(tmp_path):
    with pytest.raises(UserError, match="no UV map to keep"):
        kept(None, tmp_path)
    with pytest.raises(UserError, match="outside the unit square"):
        kept(WALL.uv * 2, tmp_path / "2")
