import math
import struct
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
import torch
from torch import Tensor

from core.appearance import lights
from core.appearance.environment import Environment, load_light
from core.appearance.latlong import Levels, convolve, directions, resample, solid_angles, to_uv
from core.appearance.shade import shade
from core.appearance.specular import STEP, ggx_kernel
from core.errors import MissingError, UserError
from core.io.exr import read_exr, write_exr
from core.io.hdr import read_hdr
from core.ops import normalize

GENERATOR = torch.Generator().manual_seed(0)
SOME = normalize(torch.randn(500, 3, generator=GENERATOR))


def smooth_light(height: int = 64) -> Tensor:
    """1 + z + x y: with harmonics of degree 0, 1 and 2."""
    x, y, z = directions(height, 2 * height).unbind(-1)
    return (1 + z + x * y)[..., None].expand(-1, -1, 3).contiguous()


def sun(height: int) -> Tensor:
    """One bright texel-sized patch over a dim sky, the same energy at any size."""
    image = torch.full((256, 512, 3), 0.2)
    image[60:64, 100:104] = 2000.0
    return resample(image, height, 2 * height)


MODELS: tuple[Literal["lobes", "split_sum"], ...] = ("lobes", "split_sum")


@pytest.fixture(scope="module")
def smooth() -> Environment:
    """Under the textbook's model, whose answers are known in closed form."""
    return Environment.of(smooth_light(), "split_sum")


# ---- the map of directions ----


def test_texels_and_directions_are_inverse() -> None:
    uv = to_uv(directions(16, 32))
    assert torch.allclose(uv[..., 0], ((torch.arange(32) + 0.5) / 32).expand(16, 32), atol=1e-6)
    assert torch.allclose(uv[..., 1].t(), ((torch.arange(16) + 0.5) / 16).expand(32, 16), atol=1e-6)


def test_orientation_is_blenders() -> None:
    """u = 0.5 - atan2(y, x) / 2 pi from the left, the zenith on top; see also blender_tests."""
    axes = torch.tensor([[1.0, 0, 0], [0, 1, 0], [0, -1, 0], [-1, 1e-5, 0], [0, 0, 1], [0, 0, -1]])
    u, v = to_uv(axes).unbind(1)
    assert torch.allclose(u[:4], torch.tensor([0.5, 0.25, 0.75, 0.0]), atol=1e-5)
    assert torch.allclose(v, torch.tensor([0.5, 0.5, 0.5, 0.5, 0, 1]), atol=1e-5)


def test_the_poles_have_a_finite_gradient() -> None:
    d = torch.tensor([[0.0, 0, 1], [0, 0, -1], [0, 0, 0]], requires_grad=True)
    to_uv(d).sum().backward()
    assert torch.isfinite(d.grad).all()


def test_solid_angles_fill_the_sphere() -> None:
    assert float(solid_angles(17, 31).sum() * 31) == pytest.approx(4 * math.pi)


@pytest.mark.parametrize("size", [(10, 20), (64, 128), (7, 9), (90, 300)])
def test_resampling_keeps_the_energy(size: tuple[int, int]) -> None:
    image = torch.rand(24, 50, 3, generator=GENERATOR)
    other = resample(image, *size)
    for picture in (image, other):
        total = (picture * solid_angles(*picture.shape[:2])[:, None]).sum((0, 1))
        expected = (image * solid_angles(24, 50)[:, None]).sum((0, 1))
        assert torch.allclose(total, expected, rtol=1e-5)
    assert torch.equal(resample(image, 24, 50), image)


def test_convolution_equals_a_slow_reference() -> None:
    image = torch.rand(8, 16, 3, generator=GENERATOR)
    d, area = directions(8, 16), solid_angles(8, 16)

    def kernel(cos: Tensor) -> Tensor:
        return torch.exp(3 * cos)

    expected = torch.empty_like(image)
    for row in range(8):
        for column in range(16):
            weight = kernel(d @ d[row, column]) * area
            expected[row, column] = (image * weight[..., None]).sum((0, 1)) / weight.sum()
    assert torch.allclose(convolve(image, kernel), expected, atol=1e-5)


def test_reading_at_a_texel_gives_the_texel_at_every_level() -> None:
    maps = [torch.rand(h, 2 * h, 3, generator=GENERATOR) for h in (16, 8, 8)]
    levels = Levels.of(maps)
    for k, image in enumerate(maps):
        d = directions(*image.shape[:2]).view(-1, 3)
        found = levels.read(d, torch.full((len(d),), float(k)))
        assert torch.allclose(found, image.view(-1, 3), atol=1e-4)


def test_reading_is_continuous_across_the_seam_and_the_poles() -> None:
    levels = Levels.of([smooth_light(16)])
    across = torch.tensor([[-1.0, 1e-4, 0.2], [-1, -1e-4, 0.2], [1e-4, 0, 1], [-1e-4, 0, 1]])
    a, b, c, d = levels.read(across)
    assert torch.allclose(a, b, atol=1e-3)
    assert torch.allclose(c, d, atol=1e-3)
    exact = 1 + SOME[:, 2] + SOME[:, 0] * SOME[:, 1]
    assert torch.allclose(Levels.of([smooth_light()]).read(SOME)[:, 0], exact, atol=2e-3)


def test_levels_between_are_means() -> None:
    levels = Levels.of([torch.full((4, 8, 3), float(k)) for k in range(3)])
    level = torch.tensor([-1.0, 0.0, 0.25, 1.5, 2.0, 9.0])
    found = levels.read(SOME[:6], level)[:, 0]
    assert torch.allclose(found, torch.tensor([0, 0, 0.25, 1.5, 2, 2]))


def test_rotation_turns_the_light_counter_clockwise_from_above() -> None:
    environment = Environment.of(sun(32))
    angle = 0.7
    c, s = math.cos(angle), math.sin(angle)
    turn = torch.tensor([[c, -s, 0.0], [s, c, 0], [0, 0, 1]])
    turned = environment.rotated(angle)
    for read in (Environment.radiance, Environment.irradiance):
        assert torch.allclose(read(turned, SOME @ turn.t()), read(environment, SOME), atol=2e-3)
    twice = environment.rotated(0.3).rotated(0.4)
    assert torch.allclose(twice.irradiance(SOME), turned.irradiance(SOME), atol=1e-4)


# ---- the split sum ----


@pytest.mark.parametrize("model", MODELS)
def test_constant_light_stays_constant(model: Literal["lobes", "split_sum"]) -> None:
    environment = Environment.of(torch.full((16, 32, 3), 0.7), model)
    lobes = environment.incoming(SOME, SOME.roll(1, 0), torch.rand(500, 1, generator=GENERATOR))
    for light in (environment.radiance(SOME), *lobes):
        assert torch.allclose(light, torch.full((500, 3), 0.7), atol=1e-5)


def test_irradiance_of_harmonics(smooth: Environment) -> None:
    """The cosine lobe scales degree 0, 1, 2 by 1, 2/3, 1/4 (Ramamoorthi and Hanrahan 2001)."""
    x, y, z = SOME.unbind(1)
    exact = 1 + 2 / 3 * z + x * y / 4
    assert torch.allclose(smooth.irradiance(SOME)[:, 1], exact, atol=2e-3)


@pytest.mark.parametrize("roughness", [0.3, 0.6, 1.0])
def test_lobe_of_harmonics(smooth: Environment, roughness: float) -> None:
    """A zonal kernel scales degree l by ∫ k P_l / ∫ k (Funk and Hecke)."""
    cos = torch.linspace(-1, 1, 200001, dtype=torch.float64)
    k = ggx_kernel(cos, roughness**2)
    one, two = ((k * p).sum() / k.sum() for p in (cos, (3 * cos.square() - 1) / 2))
    x, y, z = SOME.unbind(1)
    exact = 1 + float(one) * z + float(two) * x * y
    found = smooth.incoming(SOME, SOME, torch.full((500, 1), roughness)).base[:, 2]
    assert torch.allclose(found, exact, atol=4e-3)


def test_light_is_read_in_the_mirror_direction(smooth: Environment) -> None:
    normal = torch.tensor([[0.0, 0, 1]])
    view = normalize(torch.tensor([[1.0, 0.5, 1]]))
    there = normalize(torch.tensor([[-1.0, -0.5, 1]]))
    found = smooth.incoming(normal, view, torch.zeros(1, 1)).base
    assert torch.allclose(found, smooth.radiance(there), atol=1e-4)


@pytest.fixture(scope="module")
def sunny() -> Environment:
    return Environment.of(sun(256))


@pytest.mark.parametrize("height", [64, 600])
def test_result_does_not_depend_on_the_maps_size(sunny: Environment, height: int) -> None:
    """Even with a sun: the same light at other sizes gives the same picture."""
    reference, other = sunny, Environment.of(sun(height))
    one = torch.ones(500, 1)
    metal = (SOME, SOME, one.expand(-1, 3), 0.5 * one, one)
    for a, b in (
        (reference.irradiance(SOME), other.irradiance(SOME)),
        (shade(*metal, reference), shade(*metal, other)),
    ):
        assert float((a - b).abs().max() / a.abs().max()) < 0.03
        assert float(a.mean()) == pytest.approx(float(b.mean()), rel=0.01)


@pytest.mark.parametrize("model", MODELS)
def test_gradients_are_those_of_finite_differences(model: Literal["lobes", "split_sum"]) -> None:
    environment = Environment.of(sun(128), model)
    view = normalize(SOME + 0.3 * SOME.roll(1, 0))
    way = SOME.roll(2, 0)

    def total(roughness: Tensor, tilt: Tensor) -> Tensor:
        normal = normalize(SOME.double() + tilt * way.double())
        return sum(environment.incoming(normal, view.double(), roughness.expand(500, 1))).mean()

    for at in (0.23, 0.47, 0.81):
        roughness = torch.tensor(at, dtype=torch.float64, requires_grad=True)
        tilt = torch.zeros((), dtype=torch.float64, requires_grad=True)
        gradients = torch.autograd.grad(total(roughness, tilt), (roughness, tilt))
        h = 1e-5
        with torch.no_grad():
            by_roughness = (total(roughness + h, tilt) - total(roughness - h, tilt)) / (2 * h)
            by_tilt = (total(roughness, tilt + h) - total(roughness, tilt - h)) / (2 * h)
        assert float(gradients[0]) == pytest.approx(float(by_roughness), rel=1e-3)
        assert float(gradients[1]) == pytest.approx(float(by_tilt), rel=1e-2)


def test_rougher_is_smoother() -> None:
    light = sun(128)
    environment = Environment.of(light, "split_sum")
    there = directions(128, 256).view(-1, 3)[light[..., 0].argmax()][None]
    peaks = [
        float(environment.incoming(there, there, torch.tensor([[STEP * k]])).base[0, 0])
        for k in (0, 2, 4, 6, 8, 10)
    ]
    assert peaks == sorted(peaks, reverse=True)


# ---- lights and files ----


def test_studio_lets_kd_be_read_off() -> None:
    """A diffuse ball with kd 0.8 reads 0.7 where it is lit best, and the light is grey."""
    light = load_light("studio")
    assert float(light.max()) < 10
    assert float(light.min()) > 0
    assert torch.equal(light[..., 0], light[..., 2])
    irradiance = convolve(resample(light, 64, 128), lambda cos: cos.clamp(min=0))
    assert float(irradiance.max() * 0.8) == pytest.approx(0.7, rel=0.01)


def test_studio_key_is_on_the_front_left_above() -> None:
    light = load_light("studio")
    brightest = directions(*light.shape[:2]).view(-1, 3)[light[..., 0].argmax()]
    assert (brightest * torch.tensor([-1, -1, 1]) > 0).all()


def write_hdr(path: Path, rgbe: np.ndarray, coded: bool) -> None:
    """A Radiance file from (H, W, 4) bytes."""
    height, width, _ = rgbe.shape
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode()
    if not coded:
        path.write_bytes(head + rgbe.tobytes())
        return
    body = b""
    for row in rgbe:
        body += struct.pack(">BBH", 2, 2, width)
        for channel in row.T:
            at = 0
            while at < width:
                run = 1
                while at + run < width and run < 127 and channel[at + run] == channel[at]:
                    run += 1
                if run > 2:
                    body += bytes([128 + run, channel[at]])
                else:
                    run = min(2, width - at)
                    body += bytes([run]) + channel[at : at + run].tobytes()
                at += run
    path.write_bytes(head + body)


@pytest.mark.parametrize("coded", [False, True])
def test_radiance_files_are_read(tmp_path: Path, coded: bool) -> None:
    rng = np.random.default_rng(0)
    rgbe = rng.integers(0, 256, (16, 32, 4), np.uint8)
    rgbe[..., 3] = rng.integers(120, 140, (16, 32))
    rgbe[3:9, 5:30] = (10, 200, 30, 129)  # runs
    rgbe[0, 0] = 0
    write_hdr(tmp_path / "light.hdr", rgbe, coded)
    expected = rgbe[..., :3] * 2.0 ** (rgbe[..., 3:].astype(float) - 136)
    expected[0, 0] = 0
    assert np.allclose(read_hdr(tmp_path / "light.hdr").numpy(), expected, rtol=1e-6, atol=1e-30)
    assert load_light(tmp_path / "light.hdr").shape == (16, 32, 3)


RADIANCE = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"#?RADIANCE\n",
        b"#?RADIANCE\n\n-Y 2 +X 4\n" + bytes(32),  # no FORMAT
        b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 2 +X 4\n" + bytes(32),
        RADIANCE + b"+X 4 -Y 4\n" + bytes(64),
        RADIANCE + b"+Y 2 +X 4\n" + bytes(32),  # upside down
        RADIANCE + b"-Y 99999 +X 4\n",
        RADIANCE + b"-Y 8 +X 16\n" + b"abcd",  # ends before its last pixel
        RADIANCE + b"-Y 8 +X 16\n" + bytes([2, 2, 0, 16, 16, 1]),
        RADIANCE + b"-Y 8 +X 16\n" + bytes([2, 2, 0, 16, 128 + 17, 1]),  # a run over the row
    ],
)
def test_broken_radiance_files_are_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "light.hdr").write_bytes(content)
    with pytest.raises(UserError, match="cannot be read as a Radiance picture: .+"):
        load_light(tmp_path / "light.hdr")


@pytest.mark.parametrize("channels", [1, 3, 4])
def test_exr_comes_back_bit_for_bit(tmp_path: Path, channels: int) -> None:
    image = torch.rand(5, 10, channels, generator=GENERATOR) * 1e4
    write_exr(tmp_path / "a.exr", image)
    back = read_exr(tmp_path / "a.exr")
    assert torch.equal(back, image[..., :3].expand(-1, -1, 3))
    assert [path.name for path in tmp_path.iterdir()] == ["a.exr"]


def test_exr_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="cannot be written"):
        write_exr(tmp_path / "no folder" / "a.exr", torch.zeros(2, 4, 3))
    assert not any(tmp_path.iterdir())


def test_files_that_are_no_light_are_refused_with_a_reason(tmp_path: Path) -> None:
    (tmp_path / "broken.exr").write_bytes(b"no picture")
    (tmp_path / "light.png").write_bytes(b"")
    write_exr(tmp_path / "square.exr", torch.ones(8, 8, 3))
    write_exr(tmp_path / "black.exr", torch.zeros(8, 16, 3))
    write_exr(tmp_path / "nan.exr", torch.full((8, 16, 3), math.nan))
    for name, reason in (
        ("broken.exr", "cannot be read"),
        ("light.png", "neither .exr nor .hdr"),
        ("square.exr", "not twice as wide"),
        ("black.exr", "black"),
        ("nan.exr", "not numbers"),
    ):
        with pytest.raises(UserError, match=reason) as error:
            load_light(tmp_path / name)
        assert error.value.fix
    with pytest.raises(MissingError, match="no file"):
        load_light(tmp_path / "missing.exr")


def test_an_infinite_sun_is_as_bright_as_one_can_be(tmp_path: Path) -> None:
    sky = torch.ones(8, 16, 3)
    sky[2, 3] = math.inf
    write_exr(tmp_path / "sun.exr", sky)
    light = load_light(tmp_path / "sun.exr")
    assert light[2, 3].tolist() == [lights.MAX_RADIANCE] * 3
    assert int((light != 1).any(-1).sum()) == 1


def test_blenders_lights_are_found_by_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "4.5/datafiles/studiolights/world"
    folder.mkdir(parents=True)
    write_exr(folder / "forest.exr", torch.ones(8, 16, 3))
    monkeypatch.setattr(lights, "blender_roots", lambda: [tmp_path])
    assert load_light("forest").shape == (8, 16, 3)
    assert load_light("blender:forest").shape == (8, 16, 3)
    (tmp_path / "elsewhere" / "forest").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "elsewhere")  # a folder of that name is not a light
    assert load_light("forest").shape == (8, 16, 3)
    with pytest.raises(MissingError, match="no light 'desert'") as error:
        load_light("desert")
    assert "forest" in error.value.fix
    monkeypatch.setattr(lights, "blender_roots", list)
    with pytest.raises(MissingError, match="no Blender"):
        load_light("desert")
