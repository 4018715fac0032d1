"""On tiny random-weight checkpoints, written with diffusers' own API and loaded offline."""

import json
import shutil

import huggingface_hub
import pytest
import torch
from diffusers import AutoencoderKL, DDIMScheduler, UNet2DConditionModel
from diffusers import StableDiffusionPipeline as Pipeline
from safetensors.torch import load_file, save_file
from transformers import CLIPTextConfig, CLIPTextModel, CLIPTokenizer

from core.camera import Cameras
from core.errors import MemoryShortError, MissingError, UserError
from core.guidance import sds
from core.guidance.checkpoint import find_checkpoint, weight_variant
from core.guidance.guidance import Views, make_guidance
from core.guidance.memory import peak_bytes
from core.guidance.prompts import PromptCutWarning
from core.guidance.stable_diffusion import StableDiffusion, estimate_memory

WORDS = ("a", "the", "red", "chair", ",", "front", "side", "back", "view", "very", "x")


def write_tokenizer(folder):
    """CLIP's byte-level alphabet with a few whole words."""
    printable = [*range(33, 127), *range(161, 173), *range(174, 256)]
    alphabet = [chr(b) for b in printable] + [chr(256 + i) for i in range(256 - len(printable))]
    vocabulary = alphabet + [c + "</w>" for c in alphabet]
    merges = []
    for word in WORDS:
        symbols = [*word[:-1], word[-1] + "</w>"]
        while len(symbols) > 1:
            merges.append(f"{symbols[0]} {symbols[1]}")
            symbols[:2] = [symbols[0] + symbols[1]]
            vocabulary.append(symbols[0])
    vocabulary = list(dict.fromkeys([*vocabulary, "<|startoftext|>", "<|endoftext|>"]))
    folder.mkdir(parents=True)
    vocab = {token: index for index, token in enumerate(vocabulary)}
    (folder / "vocab.json").write_text(json.dumps(vocab))
    lines = ["#version: 0.2", *dict.fromkeys(merges), ""]
    (folder / "merges.txt").write_text("\n".join(lines))
    return CLIPTokenizer.from_pretrained(folder, model_max_length=77)


def write_checkpoint(folder, *, prediction_type, two):
    """A Stable Diffusion 2.x (``two``) or 1.x in small, with random weights."""
    torch.manual_seed(0)
    tokenizer = write_tokenizer(folder.with_name(folder.name + "_tokenizer"))
    width, end = 16, tokenizer.eos_token_id
    text_encoder = CLIPTextModel(
        CLIPTextConfig(
            vocab_size=len(tokenizer),
            hidden_size=width,
            intermediate_size=32,
            num_hidden_layers=2,
            num_attention_heads=2,
            bos_token_id=tokenizer.bos_token_id,
            eos_token_id=end,
            pad_token_id=end,
            hidden_act="gelu" if two else "quick_gelu",
        )
    )
    # Text must make a difference that a test can see; CLIP's initialisation is nearly none.
    torch.nn.init.normal_(text_encoder.get_input_embeddings().weight, std=1.0)
    unet = UNet2DConditionModel(
        sample_size=8,
        block_out_channels=(16, 32),
        layers_per_block=1,
        down_block_types=("CrossAttnDownBlock2D", "DownBlock2D"),
        up_block_types=("UpBlock2D", "CrossAttnUpBlock2D"),
        cross_attention_dim=width,
        attention_head_dim=[2, 4] if two else 2,
        use_linear_projection=two,
        norm_num_groups=8,
    )
    vae = AutoencoderKL(
        down_block_types=("DownEncoderBlock2D",) * 4,
        up_block_types=("UpDecoderBlock2D",) * 4,
        block_out_channels=(8, 8, 16, 16),
        norm_num_groups=4,
        sample_size=64,
    )
    scheduler = DDIMScheduler(
        beta_start=0.00085,
        beta_end=0.012,
        beta_schedule="scaled_linear",
        clip_sample=False,
        steps_offset=1,
        prediction_type=prediction_type,
    )
    Pipeline(
        vae=vae,
        text_encoder=text_encoder,
        tokenizer=tokenizer,
        unet=unet,
        scheduler=scheduler,
        safety_checker=None,
        feature_extractor=None,
        requires_safety_checker=False,
    ).save_pretrained(folder)
    return folder


@pytest.fixture(scope="session")
def checkpoints(tmp_path_factory):
    root = tmp_path_factory.mktemp("checkpoints")
    return {
        "1.x": write_checkpoint(root / "one", prediction_type="epsilon", two=False),
        "2.x": write_checkpoint(root / "two", prediction_type="v_prediction", two=True),
    }


@pytest.fixture(scope="session", params=["1.x", "2.x"])
def guidance(request, checkpoints):
    return StableDiffusion.load(str(checkpoints[request.param]), "cpu")


@pytest.fixture(scope="session")
def one(checkpoints):
    return StableDiffusion.load(str(checkpoints["1.x"]), "cpu")


@pytest.fixture
def own(checkpoints):
    """A guidance that the test may spoil."""
    return StableDiffusion.load(str(checkpoints["1.x"]), "cpu")


@pytest.fixture
def broken(checkpoints, tmp_path):
    return shutil.copytree(checkpoints["1.x"], tmp_path / "broken")


def views(azimuth_deg, elevation_deg=0.0):
    return Views(Cameras.orbit(azimuth_deg, [elevation_deg] * len(azimuth_deg)))


def noise(n, seed=0):
    return torch.randn(n, 4, 8, 8, generator=torch.Generator().manual_seed(seed))


def picture(n, size=64):
    generator = torch.Generator().manual_seed(1)
    rgb = torch.rand(n, size, size, 3, generator=generator)
    o = torch.rand(n, size, size, 1, generator=generator)
    return (2 * rgb - 1) * o, o


def difference(a, b):
    return (a - b).abs().max().item()


# ---- what it computes


@pytest.mark.parametrize("kind", ["1.x", "2.x"])
def test_the_noise_is_what_diffusers_own_parts_predict(kind, checkpoints):
    """A second opinion: the pipeline's tokenizer, text encoder, U-Net and scheduler by hand."""
    pipeline = Pipeline.from_pretrained(checkpoints[kind], local_files_only=True)
    pipeline.set_progress_bar_config(disable=True)
    prompts = ["a red chair, side view", "the x"]
    tokens = pipeline.tokenizer(prompts, padding="max_length", max_length=77, return_tensors="pt")
    guidance = StableDiffusion.load(str(checkpoints[kind]), "cpu")
    z_t, t = noise(1), torch.tensor([700])
    with torch.no_grad():
        text = pipeline.text_encoder(tokens.input_ids)[0]
        out = pipeline.unet(z_t.repeat(2, 1, 1, 1), 700, encoder_hidden_states=text).sample
    out = out[1] + 7.5 * (out[0] - out[1])
    alpha_bar = pipeline.scheduler.alphas_cumprod[700]
    if kind == "2.x":
        out = alpha_bar.sqrt() * out + (1 - alpha_bar).sqrt() * z_t[0]
    ours = guidance.eps_hat(z_t, t, guidance.embed("a red chair", "the x"), views([90.0]), 7.5)
    torch.testing.assert_close(ours[0], out, rtol=1e-4, atol=1e-4)
    torch.testing.assert_close(guidance.alpha_bar[700], alpha_bar)


def test_the_latent_is_the_scaled_mean_of_the_encoder(checkpoints):
    pipeline = Pipeline.from_pretrained(checkpoints["1.x"], local_files_only=True)
    guidance = StableDiffusion.load(str(checkpoints["1.x"]), "cpu")
    n, o = picture(1)
    shown = (n + o) / 2 + (1 - o) * 0.5
    with torch.no_grad():
        posterior = pipeline.vae.encode(shown.permute(0, 3, 1, 2) * 2 - 1).latent_dist
    expected = posterior.mode() * pipeline.vae.config.scaling_factor
    torch.testing.assert_close(guidance.encode_normals(n, o), expected, rtol=1e-4, atol=1e-5)


def test_backgrounds_are_grey_for_normals_and_white_for_colour(one):
    nothing, empty = torch.zeros(1, 64, 64, 3), torch.zeros(1, 64, 64, 1)
    full = torch.ones(1, 64, 64, 1)
    white = one.encode_color(nothing, empty)
    torch.testing.assert_close(white, one.encode_color(nothing + 1, full))
    grey = one.encode_normals(nothing, empty)
    torch.testing.assert_close(grey, one.encode_color(nothing + 0.5, full))
    assert difference(white, grey) > 1e-3


def test_a_larger_picture_is_brought_to_the_models_size(one):
    n, o = picture(2, 96)
    assert one.encode_normals(n, o).shape == (2, 4, 8, 8)


def test_view_words_follow_the_camera(guidance):
    embedding = guidance.embed("a chair", "")
    z_t, t = noise(1).expand(4, -1, -1, -1), torch.full((4,), 600)
    eps = guidance.eps_hat(z_t, t, embedding, views([0.0, 90.0, 180.0, -90.0]), 1.0)
    torch.testing.assert_close(eps[1], eps[3], rtol=1e-4, atol=1e-5)  # both sides
    for i, j in ((0, 1), (0, 2), (1, 2)):
        assert difference(eps[i], eps[j]) > 1e-3
    above = guidance.eps_hat(z_t[:1], t[:1], embedding, views([0.0], 80.0), 1.0)
    assert difference(above[0], eps[0]) > 1e-3


def test_soft_views_change_the_noise_between_two_sides(checkpoints):
    soft = StableDiffusion.load(str(checkpoints["1.x"]), "cpu", soft_views=True)
    z_t, t = noise(1).expand(3, -1, -1, -1), torch.full((3,), 600)
    eps = soft.eps_hat(z_t, t, soft.embed("a chair", ""), views([0.0, 20.0, 40.0]), 1.0)
    assert difference(eps[1], eps[0]) > 1e-4
    assert difference(eps[2], eps[0]) > difference(eps[1], eps[0])


def test_the_negative_prompt_is_used_only_by_guidance(guidance):
    z_t, t, cameras = noise(2), torch.tensor([300, 800]), views([0.0, 90.0])
    eps = [
        [
            guidance.eps_hat(z_t, t, guidance.embed("a chair", negative), cameras, scale)
            for negative in ("", "red", "the overhead x")
        ]
        for scale in (1.0, 7.5)
    ]
    assert difference(eps[0][0], eps[0][1]) == 0
    assert difference(eps[1][0], eps[1][1]) > 1e-3
    assert difference(eps[1][1], eps[1][2]) > 1e-3


def test_the_prompt_is_used(guidance):
    z_t, t, cameras = noise(1), torch.tensor([800]), views([0.0])
    chair, red = (guidance.embed(prompt, "") for prompt in ("a chair", "the red"))
    first = guidance.eps_hat(z_t, t, chair, cameras, 1.0)
    assert difference(first, guidance.eps_hat(z_t, t, red, cameras, 1.0)) > 1e-3


def test_perp_neg_steers_away_from_other_views_but_not_from_the_prompt(checkpoints):
    plain, perp = (
        StableDiffusion.load(str(checkpoints["1.x"]), "cpu", perp_neg_weight=w) for w in (0.0, 1.0)
    )
    z_t, t, cameras = noise(2), torch.tensor([500, 900]), views([180.0, 90.0])
    embedding = plain.embed("a chair", "x")
    cond = plain.eps_hat(z_t, t, embedding, cameras, 1.0)
    uncond = plain.eps_hat(z_t, t, embedding, cameras, 0.0)
    change = perp.eps_hat(z_t, t, embedding, cameras, 5.0) - plain.eps_hat(
        z_t, t, embedding, cameras, 5.0
    )
    cosine = torch.cosine_similarity(change.flatten(1), (cond - uncond).flatten(1))
    assert change.abs().max() > 1e-3
    torch.testing.assert_close(cosine, torch.zeros(2), atol=1e-3, rtol=0)


def test_chunks_do_not_change_the_result(checkpoints):
    n, o = picture(5)
    z_t, t, cameras = noise(5), torch.arange(100, 600, 100), views([0.0, 80.0, 160.0, 240.0, 320.0])
    results = []
    for chunk in (1, 2, 8):
        guidance = StableDiffusion.load(str(checkpoints["2.x"]), "cpu", chunk=chunk)
        eps = guidance.eps_hat(z_t, t, guidance.embed("a chair", ""), cameras, 7.5)
        results.append((eps, guidance.encode_normals(n, o)))
    for eps, z in results[1:]:
        torch.testing.assert_close(eps, results[0][0], rtol=1e-4, atol=1e-4)
        torch.testing.assert_close(z, results[0][1], rtol=1e-4, atol=1e-5)


# ---- gradients


@pytest.mark.parametrize("encode", ["encode_normals", "encode_color"])
def test_sds_gradient_in_the_picture_is_the_slope_of_its_product_with_the_latent(encode, own):
    """d<grad, z(x)>/dx against central differences, in double, along random directions."""
    own.vae = own.vae.double()
    n, o = (x.double().requires_grad_() for x in picture(1))
    z = getattr(own, encode)(n, o)
    assert z.dtype == torch.float64
    embedding = own.embed("a red chair", "x")
    grad = sds.sds_grad(
        own, z.float(), embedding, views([30.0]), torch.tensor([500]), noise(1), "sigma2", 100.0
    ).double()
    sds.sds_loss(z, grad).backward()
    assert n.grad.isfinite().all()
    assert n.grad.abs().max() > 0
    for seed, x in ((0, n), (1, o)):
        generator = torch.Generator().manual_seed(seed)
        d = torch.randn(x.shape, generator=generator, dtype=torch.float64)
        h = 1e-5
        with torch.no_grad():
            ahead, behind = (
                (
                    grad * getattr(own, encode)(*(y + s * h * d if y is x else y for y in (n, o)))
                ).sum()
                for s in (1, -1)
            )
        slope = ((ahead - behind) / (2 * h)).item()
        assert (x.grad * d).sum().item() == pytest.approx(slope, rel=1e-5)


def test_small_gradients_survive_a_16_bit_encoder(own):
    """SDS's gradient a pixel is below what 16 bit can hold; the encoder works at unit size."""
    n, o = picture(1)
    grad = 1e-9 * noise(1)
    assert not grad.half().any()
    grads = []
    for dtype in (torch.float32, torch.float16):
        torch.nn.Module.to(own.vae, dtype)
        x = n.clone().requires_grad_()
        sds.sds_loss(own.encode_normals(x, o), grad).backward()
        grads.append(x.grad.flatten() / 1e-9)  # cosine_similarity's epsilon is 1e-8
    assert torch.cosine_similarity(*grads, 0) > 0.999
    assert grads[1].norm() / grads[0].norm() == pytest.approx(1, abs=0.01)


def test_a_gradient_of_nothing_is_nothing(one):
    n, o = picture(1)
    n.requires_grad_()
    sds.sds_loss(one.encode_normals(n, o), torch.zeros(1, 4, 8, 8)).backward()
    assert torch.equal(n.grad, torch.zeros_like(n))


# ---- prompts


def test_a_long_prompt_is_cut_with_a_warning_and_keeps_its_view_words(one):
    long = "very " * 80 + "red"
    with pytest.warns(PromptCutWarning, match='the text encoder.*"very very.*red"'):
        embedding = one.embed(long, "")
    tokens, _ = one._tokens(long, ", back view")
    assert len(tokens) == 77
    assert one._tokenizer.decode(tokens[1:-1]).strip().endswith(", back view")
    z_t, t = noise(1).expand(2, -1, -1, -1), torch.full((2,), 600)
    eps = one.eps_hat(z_t, t, embedding, views([0.0, 180.0]), 1.0)
    assert difference(eps[0], eps[1]) > 1e-4


def test_a_long_negative_prompt_warns_for_itself(one):
    with pytest.warns(PromptCutWarning, match="The negative prompt is too long"):
        one.embed("a chair", "very " * 90)


def test_any_script_is_embedded(one):
    assert one.embed("一把红色的椅子 🦊", "").views.isfinite().all()


@pytest.mark.parametrize("prompt", ["", "  ", "x" * 5000, "a\x00b"])
def test_what_is_no_prompt_is_refused(one, prompt):
    with pytest.raises(UserError):
        one.embed(prompt, "")


# ---- what is no checkpoint


def load(path):
    return StableDiffusion.load(str(path), "cpu")


def edit(path, **changes):
    path.write_text(json.dumps({**json.loads(path.read_text()), **changes}))


def test_make_guidance_takes_a_folder(checkpoints):
    guidance = make_guidance(str(checkpoints["1.x"]), "cpu")
    assert isinstance(guidance, StableDiffusion)
    assert guidance.latent_size == 8
    assert guidance.normal_frame == "camera"


def test_a_folder_that_is_no_checkpoint_is_refused(tmp_path):
    with pytest.raises(UserError, match=r"no checkpoint: it has no model_index\.json"):
        load(tmp_path)


def test_a_single_file_is_refused_with_the_conversion(tmp_path):
    (tmp_path / "model.safetensors").write_bytes(b"x")
    with pytest.raises(UserError, match="is a file") as error:
        load(tmp_path / "model.safetensors")
    assert "from_single_file" in error.value.fix


@pytest.mark.parametrize("spec", ["/no/such/folder", "./no", "~/no-such-folder-there"])
def test_a_missing_folder_is_missing(spec):
    with pytest.raises(MissingError, match="no folder") as error:
        load(spec)
    assert error.value.status == 3


@pytest.mark.parametrize("spec", ["builtn", "a b/c", "one/two/three", ""])
def test_what_names_nothing_is_refused(spec, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UserError, match=r"is no guidance|no checkpoint"):
        load(spec)


@pytest.mark.parametrize(("offline", "local"), [(None, True), ("1", True), ("0", False)])
def test_the_hub_is_asked_only_where_the_user_allows_it(offline, local, monkeypatch, checkpoints):
    monkeypatch.delenv("HF_HUB_OFFLINE", raising=False)
    if offline is not None:
        monkeypatch.setenv("HF_HUB_OFFLINE", offline)
    asked = {}

    def download(hub_id, **options):
        asked.update(options, hub_id=hub_id)
        return str(checkpoints["1.x"])

    monkeypatch.setattr(huggingface_hub, "snapshot_download", download)
    assert find_checkpoint("someone/something") == checkpoints["1.x"]
    assert asked["hub_id"] == "someone/something"
    assert asked["local_files_only"] is local


def test_a_hub_id_that_is_not_in_the_cache_names_the_download(monkeypatch, tmp_path):
    monkeypatch.delenv("HF_HUB_OFFLINE", raising=False)
    monkeypatch.setattr(huggingface_hub.constants, "HF_HUB_CACHE", str(tmp_path))
    with pytest.raises(MissingError, match=r"someone/something.*not on this machine") as error:
        load("someone/something")
    assert "hf download someone/something" in error.value.fix


def test_pickled_weights_are_never_opened(broken):
    for path in (broken / "unet").glob("*.safetensors"):
        path.unlink()
    (broken / "unet" / "diffusion_pytorch_model.bin").write_bytes(b"pickle")
    with pytest.raises(UserError, match="only pickled weights") as error:
        load(broken)
    assert "safetensors" in error.value.fix


def test_a_part_without_weights_is_refused(broken):
    for path in (broken / "vae").glob("*.safetensors"):
        path.unlink()
    with pytest.raises(UserError, match=r"vae.*holds no weights"):
        load(broken)


@pytest.mark.parametrize("part", ["unet", "vae", "text_encoder"])
def test_a_file_cut_short_is_refused(broken, part):
    (path,) = (broken / part).glob("*.safetensors")
    path.write_bytes(path.read_bytes()[:1000])
    with pytest.raises(UserError, match=f"{part}.*cannot be loaded"):
        load(broken)


@pytest.mark.parametrize("part", ["unet", "vae", "text_encoder"])
def test_missing_tensors_are_not_filled_with_noise(broken, part):
    (path,) = (broken / part).glob("*.safetensors")
    tensors = load_file(path)
    tensors.pop(max(tensors))
    save_file(tensors, path, metadata={"format": "pt"})
    with pytest.raises(UserError, match=f"{part}.*incomplete: 1 of its weights"):
        load(broken)


def test_weights_of_another_shape_are_refused(broken):
    edit(broken / "unet" / "config.json", cross_attention_dim=24)
    with pytest.raises(UserError, match="unet"):
        load(broken)


@pytest.mark.parametrize("name", ["model_index.json", "unet/config.json", "vae/config.json"])
def test_broken_json_is_refused_by_file(broken, name):
    (broken / name).write_text("{")
    with pytest.raises(UserError, match="cannot be read"):
        load(broken)


def test_a_missing_tokenizer_is_refused(broken):
    shutil.rmtree(broken / "tokenizer")
    with pytest.raises(UserError, match=r"tokenizer.*cannot be loaded"):
        load(broken)


def test_sdxl_inpainting_and_sample_prediction_are_refused_by_name(broken):
    index = json.loads((broken / "model_index.json").read_text())
    edit(broken / "model_index.json", text_encoder=["transformers", "T5EncoderModel"])
    with pytest.raises(UserError, match="text_encoder is T5EncoderModel; expected CLIPTextModel"):
        load(broken)
    edit(broken / "model_index.json", **index)
    edit(broken / "scheduler" / "scheduler_config.json", prediction_type="sample")
    with pytest.raises(UserError, match="predicts sample; expected epsilon or v_prediction"):
        load(broken)
    edit(broken / "unet" / "config.json", in_channels=9)
    with pytest.raises(UserError, match=r"inpainting.*9 channels"):
        load(broken)


@pytest.mark.parametrize(
    ("files", "half", "variant"),
    [
        (["m.safetensors"], True, None),
        (["m.safetensors", "m.fp16.safetensors"], True, "fp16"),
        (["m.safetensors", "m.fp16.safetensors"], False, None),
        (["m.fp16.safetensors"], False, "fp16"),
        (["m-00001-of-00002.safetensors", "m-00002-of-00002.safetensors"], True, None),
        (["m.fp16-00001-of-00002.safetensors", "m.non_ema.safetensors", "m.bin"], False, "fp16"),
    ],
)
def test_the_weights_in_the_wanted_precision_are_chosen(tmp_path, files, half, variant):
    (tmp_path / "unet").mkdir()
    for name in files:
        (tmp_path / "unet" / name.replace("m", "diffusion_pytorch_model", 1)).touch()
    assert weight_variant(tmp_path, "unet", half=half) == variant


def test_a_16_bit_variant_loads(broken):
    pipeline = Pipeline.from_pretrained(broken, local_files_only=True)
    pipeline.set_progress_bar_config(disable=True)
    folder = broken.with_name("half")
    pipeline.to(torch.float16).save_pretrained(folder, variant="fp16")
    guidance = load(folder)
    assert guidance.unet.dtype == torch.float32
    assert guidance.embed("a chair", "").views.isfinite().all()


# ---- memory


def test_peak_bytes_of_a_sum_by_hand():
    """x, then x + 1, then both and their sum; the first is freed before the last."""

    def call():
        x = torch.empty(1000)  # 4000 bytes
        y = x + 1  # 8000
        del x
        z = y * 2  # 8000
        del y
        return z.sum()

    assert peak_bytes(call) == 8000


def test_the_estimate_grows_with_the_chunk_and_knows_the_weights(checkpoints, one):
    sizes = [estimate_memory(checkpoints["1.x"], chunk=c, dtype=torch.float32) for c in (1, 4)]
    weights = sum(p.nbytes for m in (one.unet, one.vae.encoder) for p in m.parameters())
    assert weights < sizes[0] < sizes[1] < 4 * sizes[0]
    half = estimate_memory(checkpoints["1.x"], chunk=1, dtype=torch.float16)
    assert half == pytest.approx(sizes[0] / 2, rel=0.05)


def test_the_chunk_shrinks_to_what_fits_and_too_little_memory_is_an_error(checkpoints, monkeypatch):
    folder = checkpoints["1.x"]
    one_view = estimate_memory(folder, chunk=1, dtype=torch.float32)
    name = "core.guidance.stable_diffusion.available_bytes"
    monkeypatch.setattr(name, lambda _: one_view)
    assert load(folder)._chunk == 1
    monkeypatch.setattr(name, lambda _: one_view - 1)
    with pytest.raises(MemoryShortError, match=r"needs about 0\.0 GB of 0\.0 GB") as error:
        load(folder)
    assert error.value.status == 4


def test_running_out_of_memory_is_a_sentence_and_other_faults_are_not(own, monkeypatch):
    embedding = own.embed("a chair", "")
    n, o = picture(1)

    def fail_with(error):
        def forward(*_, **__):
            raise error

        forward.dtype = torch.float32
        monkeypatch.setattr(own, "unet", forward)
        monkeypatch.setattr(own.vae, "encode", forward)

    fail_with(torch.cuda.OutOfMemoryError("CUDA out of memory"))
    with pytest.raises(MemoryShortError, match="U-Net"):
        own.eps_hat(noise(1), torch.tensor([5]), embedding, views([0.0]), 7.5)
    with pytest.raises(MemoryShortError, match="encoder"):
        own.encode_normals(n, o)
    fail_with(RuntimeError("a fault of ours"))
    with pytest.raises(RuntimeError, match="a fault of ours"):
        own.encode_normals(n, o)
