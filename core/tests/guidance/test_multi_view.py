"""MVDream's U-Net against a forward pass written here in plain torch, by CompVis' names."""

import json
import math
import shutil

import pytest
import torch
from safetensors.torch import load_file, save_file
from torch.nn import functional as F

from core.camera import CameraConfig, Cameras, sample_cameras, sample_groups
from core.config import PRESETS, GuidanceConfig
from core.errors import UserError
from core.generate import prepare
from core.guidance.guidance import Views
from core.guidance.sds import predict_eps
from core.guidance.stable_diffusion import libraries, networks, single_file
from core.guidance.stable_diffusion.clip_files import CONFIGURATIONS
from core.guidance.stable_diffusion.guidance import StableDiffusion
from core.guidance.stable_diffusion.header import kind_of, read_header
from core.guidance.stable_diffusion.keys import UNET, unet_key
from core.guidance.stable_diffusion.multi_view import MultiViewUNet, camera_numbers
from core.guidance.stable_diffusion.networks import unet_config
from core.guidance.stable_diffusion.source import Additions, Checkpoint
from core.io.job import Job
from core.settings import with_settings
from core.stages.distill import require_groups
from core.tests.one_file import write_configurations, write_one_file

# As the published folders state it, in small: attention at the first of two levels.
CONFIG = {
    "image_size": 8,
    "in_channels": 4,
    "out_channels": 4,
    "model_channels": 32,
    "channel_mult": [1, 2],
    "num_res_blocks": 1,
    "attention_resolutions": [1],
    "num_heads": -1,
    "num_head_channels": 16,
    "context_dim": 16,
    "transformer_depth": 1,
    "camera_dim": 16,
}


@pytest.fixture(scope="module")
def weights():
    """Random ones, by the names that the published files have."""
    with torch.device("meta"):
        model = MultiViewUNet(libraries.UNet2DConditionModel.from_config(unet_config(CONFIG)))
    g, out = torch.Generator().manual_seed(0), {}
    for name, value in model.state_dict().items():
        plain = name.removeprefix("unet.")
        key = name if plain == name else unet_key(plain, model.config)
        out[key] = torch.randn(value.shape, generator=g) * 0.1
    return out


@pytest.fixture(scope="module")
def folder(weights, checkpoints, tmp_path_factory):
    to = tmp_path_factory.mktemp("models") / "mvdream"
    shutil.copytree(checkpoints["2.x"], to)
    shutil.rmtree(to / "unet")
    (to / "unet").mkdir()
    (to / "unet" / "config.json").write_text(json.dumps(CONFIG))
    save_file(weights, to / "unet" / "diffusion_pytorch_model.safetensors")
    index = json.loads((to / "model_index.json").read_text())
    index |= {"_class_name": "MVDreamPipeline", "unet": ["mv_unet", "MultiViewUNetModel"]}
    (to / "model_index.json").write_text(json.dumps(index))
    scheduler = to / "scheduler" / "scheduler_config.json"
    state = json.loads(scheduler.read_text()) | {"prediction_type": "epsilon"}
    scheduler.write_text(json.dumps(state))
    return to


@pytest.fixture(scope="module")
def guidance(folder):
    return StableDiffusion.load(str(folder), "cpu")


# ---- the independent forward pass


class Plain:
    """The network, layer by layer, as the paper and its code lay it out."""

    def __init__(self, weights):
        self.w = weights

    def linear(self, x, name):
        return F.linear(x, self.w[f"{name}.weight"], self.w.get(f"{name}.bias"))

    def conv(self, x, name, **options):
        return F.conv2d(x, self.w[f"{name}.weight"], self.w[f"{name}.bias"], **options)

    def group(self, x, name, eps=1e-5):
        return F.group_norm(x, 32, self.w[f"{name}.weight"], self.w[f"{name}.bias"], eps)

    def layer(self, x, name):
        return F.layer_norm(x, x.shape[-1:], self.w[f"{name}.weight"], self.w[f"{name}.bias"])

    def resnet(self, x, emb, name):
        h = F.silu(self.group(x, f"{name}.in_layers.0"))
        h = self.conv(h, f"{name}.in_layers.2", padding=1)
        h = h + self.linear(F.silu(emb), f"{name}.emb_layers.1")[:, :, None, None]
        h = F.silu(self.group(h, f"{name}.out_layers.0"))
        h = self.conv(h, f"{name}.out_layers.3", padding=1)
        skip = f"{name}.skip_connection"
        return h + (self.conv(x, skip) if f"{skip}.weight" in self.w else x)

    def attention(self, x, context, name):
        heads = x.shape[-1] // CONFIG["num_head_channels"]
        q, k, v = (
            self.linear(y, f"{name}.to_{n}").unflatten(-1, (heads, -1)).transpose(1, 2)
            for n, y in (("q", x), ("k", context), ("v", context))
        )
        share = (q @ k.transpose(-1, -2) / math.sqrt(q.shape[-1])).softmax(-1)
        return self.linear((share @ v).transpose(1, 2).flatten(2), f"{name}.to_out.0")

    def transformer(self, x, text, name):
        b, c, height, width = x.shape
        tokens = self.group(x, f"{name}.norm", 1e-6).flatten(2).transpose(1, 2)
        y, block = self.linear(tokens, f"{name}.proj_in"), f"{name}.transformer_blocks.0"
        # All four views' pixels in one sequence.
        normed = self.layer(y, f"{block}.norm1")
        joined = torch.stack([torch.cat(list(part)) for part in normed.split(4)])
        y = y + self.attention(joined, joined, f"{block}.attn1").reshape(y.shape)
        y = y + self.attention(self.layer(y, f"{block}.norm2"), text, f"{block}.attn2")
        hidden, gate = self.linear(self.layer(y, f"{block}.norm3"), f"{block}.ff.net.0.proj").chunk(
            2, -1
        )
        y = y + self.linear(hidden * F.gelu(gate), f"{block}.ff.net.2")
        y = self.linear(y, f"{name}.proj_out").transpose(1, 2).reshape(b, c, height, width)
        return x + y

    def __call__(self, z, t, text, cameras):
        half = 16
        freqs = torch.exp(-math.log(10000) * torch.arange(half) / half)
        angle = t[:, None] * freqs
        emb = torch.cat([angle.cos(), angle.sin()], -1)
        emb = self.linear(F.silu(self.linear(emb, "time_embed.0")), "time_embed.2")
        emb = emb + self.linear(F.silu(self.linear(cameras, "camera_embed.0")), "camera_embed.2")
        h = self.conv(z, "input_blocks.0.0", padding=1)
        kept = [h]
        h = self.resnet(h, emb, "input_blocks.1.0")
        h = self.transformer(h, text, "input_blocks.1.1")
        kept.append(h)
        h = self.conv(h, "input_blocks.2.0.op", stride=2, padding=1)
        kept.append(h)
        h = self.resnet(h, emb, "input_blocks.3.0")
        kept.append(h)
        h = self.resnet(h, emb, "middle_block.0")
        h = self.transformer(h, text, "middle_block.1")
        h = self.resnet(h, emb, "middle_block.2")
        for number in range(4):
            h = self.resnet(torch.cat([h, kept.pop()], 1), emb, f"output_blocks.{number}.0")
            if number == 1:
                h = F.interpolate(h, scale_factor=2)
                h = self.conv(h, "output_blocks.1.1.conv", padding=1)
            if number > 1:
                h = self.transformer(h, text, f"output_blocks.{number}.1")
        return self.conv(F.silu(self.group(h, "out.0")), "out.2", padding=1)


def group(elevation=15.0, start=0.0, n=1):
    azimuth = torch.tensor([start + 90.0 * i for i in range(4)] * n)
    return Cameras.orbit(azimuth, torch.full((4 * n,), elevation))


@pytest.mark.parametrize("n", [1, 2])
def test_four_views_are_predicted_as_by_the_plain_network(n, guidance, weights):
    g = torch.Generator().manual_seed(3)
    z, t = torch.randn(4 * n, 4, 8, 8, generator=g), torch.arange(n).repeat_interleave(4) * 300 + 50
    text = torch.randn(4 * n, 77, 16, generator=g)
    cameras = camera_numbers(group(start=30.0, n=n))
    found = guidance.eps(z, t, text, cameras)
    expected = Plain(weights)(z, t, text, cameras)
    torch.testing.assert_close(found, expected, rtol=1e-4, atol=1e-4)


def test_a_guided_prediction_holds_groups_and_cameras_together(guidance, weights):
    """Two groups, a prompt and a negative one: each with its own cameras, at any chunk."""
    g = torch.Generator().manual_seed(3)
    z, t = torch.randn(8, 4, 8, 8, generator=g), torch.full((8,), 400)
    cameras = Cameras.orbit(
        torch.tensor([0.0, 90.0, 180.0, 270.0, 45.0, 135.0, 225.0, 315.0]), torch.tensor([10.0] * 8)
    )
    prompted = guidance.prompted("a red chair", "the x")
    found = predict_eps(prompted, z, t, Views(cameras), 7.5)
    plain, numbers = Plain(weights), camera_numbers(cameras)
    # One text for all views: no words of sides.
    assert torch.equal(prompted.views, prompted.views[:1].expand_as(prompted.views))
    cond, uncond = (
        plain(z, t, text.expand(8, -1, -1), numbers)
        for text in (prompted.views[0], prompted.negative)
    )
    expected = uncond + 7.5 * (cond - uncond)
    torch.testing.assert_close(found, expected, rtol=1e-3, atol=1e-3)


def test_a_lora_changes_the_network_within(folder, guidance, tmp_path):
    """Its names are those of the network without cameras."""
    name = "down_blocks.0.attentions.0.transformer_blocks.0.attn1.to_q"
    before = guidance.unet.state_dict()[f"unet.{name}.weight"]
    up, down = torch.randn(len(before), 1), torch.randn(1, before.shape[1])
    path = tmp_path / "x.safetensors"
    save_file({f"unet.{name}.lora_A.weight": down, f"unet.{name}.lora_B.weight": up}, path)
    additions = Additions({str(path): 0.5})
    changed = StableDiffusion.load(str(folder), "cpu", additions=additions).unet.state_dict()
    torch.testing.assert_close(changed[f"unet.{name}.weight"], before + 0.5 * up @ down)


def test_a_view_sees_the_others_and_its_camera(guidance):
    z = torch.randn(4, 4, 8, 8, generator=torch.Generator().manual_seed(1))
    t = torch.full((4,), 300)
    text, cameras = torch.zeros(4, 77, 16), camera_numbers(group())
    plain = guidance.eps(z, t, text, cameras)
    other = z.clone()
    other[3] += 1
    assert (guidance.eps(other, t, text, cameras)[0] - plain[0]).abs().max() > 1e-5
    turned = camera_numbers(group(elevation=60.0))
    assert (guidance.eps(z, t, text, turned) - plain).abs().max() > 1e-4


def test_a_camera_is_its_matrix_at_distance_1_turned_to_mvdreams_front():
    """Written out for the front, which MVDream sees from +X: right +Y, up +Z, back +X."""
    numbers = camera_numbers(Cameras.orbit([0.0, 90.0], [0.0, 0.0], distance=2.5)).view(2, 4, 4)
    front = torch.tensor([[0.0, 0, 1, 1], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    torch.testing.assert_close(numbers[0], front, atol=1e-6, rtol=0)
    # 90 degrees on: from +Y, and it sees its right at -X.
    side = torch.tensor([[-1.0, 0, 0, 0], [0, 0, 1, 1], [0, 1, 0, 0], [0, 0, 0, 1]])
    torch.testing.assert_close(numbers[1], side, atol=1e-6, rtol=0)


def test_cameras_come_in_groups_a_quarter_turn_apart():
    config = CameraConfig()
    cameras = sample_groups(12, 4, config, torch.Generator().manual_seed(0))
    for part in range(0, 12, 4):
        of = cameras[slice(part, part + 4)]
        for value in (of.elevation, of.distance, of.fovy):
            assert (value == value[0]).all()
        steps = (of.azimuth - of.azimuth[0]) / (math.pi / 2)
        torch.testing.assert_close(steps, torch.arange(4.0), atol=1e-5, rtol=0)
    assert len(cameras.elevation.unique()) == 3
    alone = sample_groups(5, 1, config, torch.Generator().manual_seed(0))
    usual = sample_cameras(5, config, torch.Generator().manual_seed(0))
    assert torch.equal(alone.azimuth, usual.azimuth)


def test_settings_that_tear_a_group_apart_are_refused(folder, guidance):
    standard = PRESETS["standard"]
    require_groups(standard, 4, "generate")
    require_groups(PRESETS["draft"], 1, "generate")
    with pytest.raises(UserError, match=r"appearance.views is 6.*4 views together"):
        require_groups(with_settings(standard, {"appearance.views": 6}), 4, "texture")
    with pytest.raises(UserError, match="views_at_once is 2"):
        require_groups(with_settings(standard, {"geometry.views_at_once": 2}), 4, "generate")
    with pytest.raises(UserError, match="predicts 4 views"):
        prepare(Job(prompt="a chair", guidance=str(folder)))  # the draft's 6 views
    with pytest.raises(UserError, match="takes the cameras themselves"):
        StableDiffusion.load(str(folder), "cpu", config=GuidanceConfig(perp_neg=1.0))
    assert guidance.views_together == 4
    assert guidance.chunk % 4 == 0
    small = StableDiffusion.load(str(folder), "cpu", chunk=2)
    assert small.chunk == 4


def test_imagedream_and_other_multi_view_models_are_refused(folder, tmp_path):
    other = shutil.copytree(folder, tmp_path / "other")
    for change, says in (({"ip_dim": 16}, "ImageDream"), ({"camera_dim": 12}, "another kind")):
        (other / "unet" / "config.json").write_text(json.dumps(CONFIG | change))
        with pytest.raises(UserError, match=says):
            StableDiffusion.load(str(other), "cpu")


# ---- one file


@pytest.fixture
def one_file(weights, folder, checkpoints, tmp_path, monkeypatch):
    """The folder's weights in the layout of the released file, and its configuration in small."""
    path = write_one_file(checkpoints["2.x"], tmp_path / "mvdream.safetensors")
    kept = {k: v for k, v in load_file(path).items() if not k.startswith(UNET)}
    save_file(kept | {f"{UNET}{k}": v for k, v in weights.items()}, path)
    known = write_configurations(tmp_path / "configurations", {"sd21_base": checkpoints["2.x"]})
    (known / "mvdream").mkdir()
    for part in ("unet", "vae", "text_encoder", "scheduler"):
        shutil.copytree(folder / part, known / "mvdream" / part)
    for module in (networks, single_file):
        monkeypatch.setattr(module, "CONFIGURATIONS", known)
    return path


def test_one_file_predicts_as_the_folder_does_to_the_bit(one_file, guidance):
    assert kind_of(read_header(one_file)) == "MVDream"
    single = StableDiffusion.load(str(one_file), "cpu")
    z_t = torch.randn(4, 4, 8, 8, generator=torch.Generator().manual_seed(3))
    picture = torch.rand(4, 64, 64, 3, generator=torch.Generator().manual_seed(1))
    views, t = Views(group()), torch.full((4,), 300)
    found, expected = (
        (
            predict_eps(g.prompted("a red chair", "the x"), z_t, t, views, 7.5),
            g.encode_color(picture, torch.ones(4, 64, 64, 1)),
            g.alpha_bar,
        )
        for g in (single, guidance)
    )
    assert all(torch.equal(a, b) for a, b in zip(found, expected, strict=True))
    assert single.views_together == 4


def test_a_file_without_a_camera_layer_or_of_another_base_is_refused(one_file, tmp_path):
    whole, bad = load_file(one_file), tmp_path / "bad.safetensors"
    save_file({k: v for k, v in whole.items() if not k.endswith("camera_embed.2.weight")}, bad)
    with pytest.raises(UserError, match=r"incomplete: 1 of its weights.*camera_embed\.2\.weight"):
        StableDiffusion.load(str(bad), "cpu")
    names = {k.replace("cond_stage_model.model.", "cond_stage_model.transformer.") for k in whole}
    save_file({name: torch.zeros(1, 4) for name in names}, bad)
    with pytest.raises(UserError, match="MVDream of Stable Diffusion 1"):
        StableDiffusion.load(str(bad), "cpu")


def test_the_shipped_configuration_is_stable_diffusion_2_with_cameras():
    """The paper's network is SD 2.1 base and the camera's two layers (16 to 1280 to 1280)."""
    model, _ = networks.empty_networks(Checkpoint(CONFIGURATIONS / "mvdream", family="mvdream"))
    base, _ = networks.empty_networks(Checkpoint(CONFIGURATIONS / "sd21_base"))
    shapes = [{k: v.shape for k, v in unet.state_dict().items()} for unet in (model, base)]
    assert shapes[0] == shapes[1]
    assert model.config.attention_head_dim == base.config.attention_head_dim
    camera = MultiViewUNet(model).camera_embed
    assert [layer.weight.shape for layer in (camera[0], camera[2])] == [(1280, 16), (1280, 1280)]
    assert model.config.sample_size == 32  # 256 pixels
