"""One-file checkpoints: recognised from their tensors, read to the same numbers as the folder."""

import json
import struct

import pytest
import torch
from safetensors.torch import load_file, save_file

from core.camera import Cameras
from core.config import GuidanceConfig
from core.errors import MissingError, UserError
from core.guidance.guidance import Views
from core.guidance.sds import predict_eps
from core.guidance.stable_diffusion import libraries, networks, single_file
from core.guidance.stable_diffusion.checkpoint import find_checkpoint
from core.guidance.stable_diffusion.clip_files import CONFIGURATIONS, END, merges, vocabulary
from core.guidance.stable_diffusion.guidance import StableDiffusion
from core.guidance.stable_diffusion.header import Header, kind_of, read_header
from core.guidance.stable_diffusion.keys import UNET, unet_key
from core.guidance.stable_diffusion.networks import measured_prediction, noise_schedule
from core.guidance.stable_diffusion.source import Checkpoint
from core.guidance.stable_diffusion.texts import Texts
from core.tests.one_file import write_configurations, write_one_file

KINDS = {"1.x": "Stable Diffusion 1", "2.x": "Stable Diffusion 2", "xl": "Stable Diffusion XL"}


@pytest.fixture(scope="session")
def files(checkpoints, tmp_path_factory):
    """Read only: each tiny checkpoint as one file."""
    folder = tmp_path_factory.mktemp("files")
    stated = {"modelspec.prediction_type": "v"}
    return {
        name: write_one_file(
            path, folder / f"{path.name}.safetensors", metadata=stated if name == "2.x" else None
        )
        for name, path in checkpoints.items()
    }


@pytest.fixture(autouse=True)
def small(checkpoints, tmp_path_factory, monkeypatch):
    """The shipped configurations in small."""
    two = checkpoints["2.x"]
    known = {"sd15": checkpoints["1.x"], "sd21_v": two, "sd21_base": two, "sdxl": checkpoints["xl"]}
    folder = write_configurations(tmp_path_factory.mktemp("configurations"), known)
    for module in (networks, single_file):
        monkeypatch.setattr(module, "CONFIGURATIONS", folder)


def load(path, **options):
    return StableDiffusion.load(str(path), "cpu", **options)


def answers(guidance):
    """A guided prediction and a latent."""
    z_t = torch.randn(2, 4, 8, 8, generator=torch.Generator().manual_seed(0))
    views = Views(Cameras.orbit([0.0, 90.0], [0.0, 0.0]))
    prompted = guidance.prompted("a red chair", "the x")
    eps = predict_eps(prompted, z_t, torch.tensor([300, 800]), views, 7.5)
    picture = torch.rand(1, 64, 64, 3, generator=torch.Generator().manual_seed(1))
    return eps, guidance.encode_color(picture, torch.ones(1, 64, 64, 1)), guidance.alpha_bar


@pytest.mark.parametrize("kind", ["1.x", "2.x", "xl"])
def test_one_file_predicts_as_the_folder_does_to_the_bit(kind, files, checkpoints):
    assert kind_of(read_header(files[kind])) == KINDS[kind]
    for found, expected in zip(
        answers(load(files[kind])), answers(load(checkpoints[kind])), strict=True
    ):
        assert torch.equal(found, expected)


@pytest.mark.parametrize("kind", ["1.x", "2.x", "xl"])
def test_the_tests_file_is_in_the_layout_that_diffusers_itself_reads(kind, files, checkpoints):
    """Both maps of this project could share a mistake; diffusers' cannot."""
    from diffusers.loaders import single_file_utils as layouts  # it takes seconds

    file, folder = load_file(files[kind]), checkpoints[kind]

    def weights(part):
        return load_file(next((folder / part).glob("*.safetensors")))

    def config(part):
        return json.loads((folder / part / "config.json").read_text())

    found = layouts.convert_ldm_unet_checkpoint(dict(file), config("unet"))
    expected = weights("unet")
    assert found.keys() == expected.keys()
    assert all(torch.equal(found[name], expected[name]) for name in expected)
    found, expected = layouts.convert_ldm_vae_checkpoint(dict(file), config("vae")), weights("vae")
    encoder = {n for n in expected if not n.startswith(("decoder", "post_quant"))}
    assert encoder == found.keys()
    assert all(torch.equal(found[name].flatten(), expected[name].flatten()) for name in encoder)
    if kind == "1.x":
        text = layouts.convert_ldm_clip_checkpoint(file)
        expected = weights("text_encoder")
    else:
        part = "text_encoder_2" if kind == "xl" else "text_encoder"
        prefix = "conditioner.embedders.1.model." if kind == "xl" else "cond_stage_model.model."
        # Where there is no projection, diffusers takes the width from the model.
        width = config(part)["hidden_size"]
        model = type("M", (), {"config": type("C", (), {"hidden_size": width})})
        if kind == "xl":  # whose square projection diffusers expects
            file = {k: v for k, v in file.items() if not k.endswith("text_projection")}
        text, expected = layouts.convert_open_clip_checkpoint(model, file, prefix), weights(part)
    for name, value in expected.items():
        if name != "text_projection.weight":
            plain = name.removeprefix("text_model.")
            assert torch.equal(text[f"text_model.{plain}"], value)


def test_16_bit_files_and_those_of_newer_tools_are_read(files, tmp_path):
    """Half precision, and a text encoder without the wrapper's name."""
    old, new = "transformer.text_model.", "transformer."
    half = {k.replace(old, new): v.half() for k, v in load_file(files["1.x"]).items()}
    save_file(half, tmp_path / "half.safetensors")
    a, b = (answers(load(path)) for path in (tmp_path / "half.safetensors", files["1.x"]))
    torch.testing.assert_close(a[0], b[0], rtol=0.02, atol=0.02)


@pytest.mark.parametrize(
    ("folder", "tensors", "unet", "parts"),
    [
        ("sd15", 686, 859_520_964, ("cond_stage", 768)),
        ("sd21_base", 686, 865_910_724, ("cond_stage", 1024)),
        ("sd21_v", 686, 865_910_724, ("cond_stage", 1024)),
        ("sdxl", 1680, 2_567_463_684, ("conditioner", 2048)),
    ],
)
def test_the_shipped_configurations_are_of_the_published_networks(folder, tensors, unet, parts):
    """The numbers of tensors and of weights that the published files have."""
    model, vae = networks.empty_networks(Checkpoint(CONFIGURATIONS / folder))
    state = model.state_dict()
    assert len(state) == tensors
    assert sum(x.numel() for x in state.values()) == unet
    assert len({unet_key(name, model.config) for name in state}) == tensors
    assert sum(p.numel() for p in vae.encoder.parameters()) == 34_163_592
    assert model.config.cross_attention_dim == parts[1]


def test_the_shipped_vocabulary_gives_clips_own_tokens():
    """The tokens of OpenAI's CLIP for a sentence of its readme, and its end token."""
    pairs = merges(CONFIGURATIONS / "tokenizer" / "merges.txt")
    words = vocabulary(pairs)
    assert len(words) == 49408
    assert words[END] == 49407
    made = libraries.CLIPTokenizer(vocab=words, merges=pairs, model_max_length=77)
    assert made("a photo of a cat").input_ids == [49406, 320, 1125, 539, 320, 2368, 49407]
    assert made("a diagram").input_ids == [49406, 320, 22697, 49407]


# ---- what it predicts


def test_what_it_predicts_is_stated_by_metadata_a_key_or_a_yaml(files, checkpoints, tmp_path):
    def predicts(name, metadata=None, extra=None, yaml=""):
        path = write_one_file(
            checkpoints["2.x"], tmp_path / f"{name}.safetensors", metadata=metadata, extra=extra
        )
        if yaml:
            path.with_suffix(".yaml").write_text(yaml)
        return find_checkpoint(str(path))

    assert predicts("a", {"modelspec.prediction_type": "v"}).prediction == "v_prediction"
    base = predicts("b", {"modelspec.prediction_type": "epsilon"})
    assert (base.prediction, base.folder.name) == ("epsilon", "sd21_base")
    flags = predicts("c", extra={"v_pred": torch.zeros(1), "ztsnr": torch.zeros(1)})
    assert (flags.prediction, flags.zero_snr) == ("v_prediction", True)
    assert noise_schedule(flags).alphas_cumprod[-1] == 0
    yaml = 'model:\n  params:\n    parameterization: "v"\n'
    assert predicts("d", yaml=yaml).prediction == "v_prediction"
    assert predicts("e", yaml="model:\n").prediction == "epsilon"
    assert predicts("f").prediction is None  # a trial shows it
    assert find_checkpoint(str(files["1.x"])).prediction == "epsilon"


def test_a_trial_shows_whether_a_network_predicts_noise_or_v(files, checkpoints):
    """At the last step the noise is all there is to see; v is the picture behind it."""
    guidance = load(files["2.x"])
    schedule = noise_schedule(Checkpoint(checkpoints["2.x"]))
    alpha_bar = schedule.alphas_cumprod[-1]
    picture = torch.randn(1, 4, 32, 32, generator=torch.Generator().manual_seed(9))

    class Exact:
        dtype = torch.float32

        def __init__(self, kind):
            self.kind = kind

        def __call__(self, z_t, t, encoder_hidden_states):
            assert t.item() == 999
            eps = (z_t - alpha_bar.sqrt() * picture) / (1 - alpha_bar).sqrt()
            v = alpha_bar.sqrt() * eps - (1 - alpha_bar).sqrt() * picture
            return type("Out", (), {"sample": eps if self.kind == "epsilon" else v})

    for kind in ("epsilon", "v_prediction"):
        assert measured_prediction(Exact(kind), guidance.texts, schedule) == kind
    assert isinstance(guidance.texts, Texts)


def test_the_user_may_state_what_it_predicts(files):
    for kind in ("epsilon", "v_prediction"):
        made = load(files["1.x"], config=GuidanceConfig(prediction=kind))
        assert made.prediction_type == kind


# ---- what is refused


def shapes(*names):
    return {name: torch.zeros(1, 4, 1, 1) for name in names}


CONTENTS = {
    "LoRA": shapes("lora_unet_x.lora_down.weight", "lora_unet_x.lora_up.weight"),
    "textual inversion": {"emb_params": torch.zeros(2, 768)},
    "ControlNet": shapes("control_model.input_blocks.0.0.weight"),
    "Flux": shapes("model.diffusion_model.double_blocks.0.img_attn.qkv.weight"),
    "Stable Diffusion 3": shapes("model.diffusion_model.joint_blocks.0.x"),
    "SDXL refiner": shapes(f"{UNET}input_blocks.0.0.weight", "conditioner.embedders.0.model.x"),
    "inpainting or editing model": {f"{UNET}input_blocks.0.0.weight": torch.zeros(1, 9, 1, 1)},
    "U-Net without text encoder": shapes(f"{UNET}input_blocks.0.0.weight"),
    "checkpoint without VAE": shapes(f"{UNET}x", "cond_stage_model.model.x"),
    "VAE": shapes("first_stage_model.encoder.conv_in.weight", "x"),
    "no model that is known": shapes("a.b", "c.d"),
}


@pytest.mark.parametrize("kind", CONTENTS)
def test_other_files_are_refused_by_what_they_are(kind, tmp_path):
    save_file(CONTENTS[kind], tmp_path / "x.safetensors")
    with pytest.raises(UserError, match=kind) as error:
        load(tmp_path / "x.safetensors")
    option = {"LoRA": "--lora", "textual inversion": "--embedding"}.get(kind, "")
    assert option in error.value.fix


@pytest.mark.parametrize("ending", [".ckpt", ".pt", ".bin"])
def test_a_pickle_is_never_opened(ending, tmp_path):
    path = tmp_path / f"x{ending}"
    path.write_bytes(b"\x80\x04cos\nsystem\n(S'touch opened'\ntR.")
    with pytest.raises(UserError, match="never opened") as error:
        load(path)
    assert "safetensors" in error.value.fix


def test_broken_short_and_missing_files_are_refused(files, tmp_path):
    path = tmp_path / "x.safetensors"
    whole = files["1.x"].read_bytes()
    for content, says in (
        (whole[: len(whole) // 2], "cut short"),
        (b"", "no whole safetensors"),
        (b"x" * 100, "no whole safetensors"),
        (struct.pack("<Q", 4) + b"[1]  ", "no whole safetensors"),
        (struct.pack("<Q", 10) + b'{"a": 1}  ', "no whole safetensors"),
        (struct.pack("<Q", 100_000) + b"[" * 100_000, "no whole safetensors"),
        (struct.pack("<Q", 23) + b'{"a":{"shape":[1e999]}}', "no whole safetensors"),
    ):
        path.write_bytes(content)
        with pytest.raises(UserError, match=says):
            load(path)
    with pytest.raises(MissingError, match="no file"):
        load(tmp_path / "none.safetensors")
    (tmp_path / "notes.txt").write_text("x")
    with pytest.raises(UserError, match="another kind"):
        load(tmp_path / "notes.txt")


def test_a_first_layer_without_channels_is_refused(tmp_path):
    save_file({f"{UNET}input_blocks.0.0.weight": torch.zeros(4)}, tmp_path / "one.safetensors")
    with pytest.raises(UserError, match="is a file of inpainting or editing model"):
        find_checkpoint(str(tmp_path / "one.safetensors"))


def test_a_missing_weight_and_one_of_another_shape_are_named(files, tmp_path):
    tensors, path = load_file(files["1.x"]), tmp_path / "x.safetensors"
    name = f"{UNET}time_embed.0.weight"
    save_file({k: v for k, v in tensors.items() if k != name}, path)
    with pytest.raises(UserError, match=f"incomplete: 1 of its weights.*{name}"):
        load(path)
    save_file(tensors | {name: torch.zeros(3, 3)}, path)
    with pytest.raises(UserError, match=r"time_embed\.0\.weight is \(3, 3\), expected"):
        load(path)


@pytest.mark.parametrize("name", ["sd_turbo", "sd_xl_turbo_1.0", "dream-LCM", "XL_lightning_4step"])
def test_files_named_as_distilled_are_refused(name, files, tmp_path):
    path = tmp_path / f"{name}.safetensors"
    path.write_bytes(files["1.x"].read_bytes())
    with pytest.raises(UserError, match="distilled to a few steps") as error:
        load(path)
    assert "rename" in error.value.fix


def test_a_header_knows_what_its_names_hold():
    header = Header({"a.b": (1,), "c": (2, 3)}, {})
    assert header.any(".b", "x") and not header.any("x")
    assert header.starts("a.") and not header.starts("b")
