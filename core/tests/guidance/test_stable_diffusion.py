"""On tiny random-weight checkpoints, written with diffusers' own API and loaded offline."""

from functools import cache

import pytest
import torch

from core.camera import Cameras
from core.command_line import job_of, parse
from core.config import GuidanceConfig
from core.errors import MemoryShortError, UserError
from core.generate import config_of, prepare
from core.guidance import sds
from core.guidance.guidance import Views
from core.guidance.sds import predict_eps
from core.guidance.stable_diffusion.clip_files import CONFIGURATIONS
from core.guidance.stable_diffusion.fit import MOST_ON_CPU, chunk_that_fits, estimate_memory
from core.guidance.stable_diffusion.guidance import StableDiffusion
from core.guidance.stable_diffusion.memory import peak_bytes
from core.guidance.stable_diffusion.prompts import DEFAULT_NEGATIVE_PROMPT, PromptCutWarning
from core.guidance.stable_diffusion.source import Checkpoint
from core.io.job import Job


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
    from diffusers import StableDiffusionPipeline  # it takes seconds

    pipeline = StableDiffusionPipeline.from_pretrained(checkpoints[kind], local_files_only=True)
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
    ours = predict_eps(guidance.prompted("a red chair", "the x"), z_t, t, views([90.0]), 7.5)
    torch.testing.assert_close(ours[0], out, rtol=1e-4, atol=1e-4)
    torch.testing.assert_close(guidance.alpha_bar[700], alpha_bar)


def test_the_latent_is_the_scaled_mean_of_the_encoder(checkpoints):
    from diffusers import StableDiffusionPipeline  # it takes seconds

    pipeline = StableDiffusionPipeline.from_pretrained(checkpoints["1.x"], local_files_only=True)
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
    prompted = guidance.prompted("a chair", "")
    z_t, t = noise(1).expand(4, -1, -1, -1), torch.full((4,), 600)
    eps = predict_eps(prompted, z_t, t, views([0.0, 90.0, 180.0, -90.0]), 1.0)
    torch.testing.assert_close(eps[1], eps[3], rtol=1e-4, atol=1e-5)  # both sides
    for i, j in ((0, 1), (0, 2), (1, 2)):
        assert difference(eps[i], eps[j]) > 1e-3
    above = predict_eps(prompted, z_t[:1], t[:1], views([0.0], 80.0), 1.0)
    assert difference(above[0], eps[0]) > 1e-3


def test_soft_views_change_the_noise_between_two_sides(checkpoints):
    soft = StableDiffusion.load(
        str(checkpoints["1.x"]), "cpu", config=GuidanceConfig(soft_views=True)
    )
    z_t, t = noise(1).expand(3, -1, -1, -1), torch.full((3,), 600)
    eps = predict_eps(soft.prompted("a chair", ""), z_t, t, views([0.0, 20.0, 40.0]), 1.0)
    assert difference(eps[1], eps[0]) > 1e-4
    assert difference(eps[2], eps[0]) > difference(eps[1], eps[0])


def test_the_negative_prompt_is_used_only_by_guidance(guidance):
    z_t, t, cameras = noise(2), torch.tensor([300, 800]), views([0.0, 90.0])
    eps = [
        [
            predict_eps(guidance.prompted("a chair", negative), z_t, t, cameras, scale)
            for negative in ("", "red", "the overhead x")
        ]
        for scale in (1.0, 7.5)
    ]
    assert difference(eps[0][0], eps[0][1]) == 0
    assert difference(eps[1][0], eps[1][1]) > 1e-3
    assert difference(eps[1][1], eps[1][2]) > 1e-3


def test_an_empty_negative_prompt_is_the_default_text_or_none_at_all(checkpoints):
    """With ``default_negative`` off the comparison is CLIP's empty text: a true unconditional."""
    folder = str(checkpoints["1.x"])
    usual = StableDiffusion.load(folder, "cpu")
    none = StableDiffusion.load(folder, "cpu", config=GuidanceConfig(default_negative=False))
    empty = usual.texts.encode([usual.texts.tokens("", "")[0]])[0]
    default = usual.texts.encode([usual.texts.tokens(DEFAULT_NEGATIVE_PROMPT, "")[0]])[0]
    torch.testing.assert_close(usual.prompted("a chair", "").negative, default)
    torch.testing.assert_close(none.prompted("a chair", " ").negative, empty)
    assert difference(default, empty) > 1e-3
    written = [guidance.prompted("a chair", "red").negative for guidance in (usual, none)]
    assert torch.equal(*written)


@pytest.mark.parametrize(
    ("options", "default"),
    [
        ([], True),
        (["--negative", ""], False),
        (["--negative", "red"], True),
        (["--negative", "", "--set", "guidance.default_negative=true"], True),
    ],
)
def test_an_empty_negative_prompt_that_is_given_means_none(options, default):
    """job.json of earlier versions has an empty one where none was given: the default text."""
    job = job_of(parse(["generate", "a chair", *options]))
    assert config_of(Job.from_json(job.to_json())).guidance.default_negative is default


def test_the_view_settings_of_a_job_reach_the_checkpoint(checkpoints):
    settings = {"guidance.soft_views": "true", "guidance.perp_neg": "1.5"}
    job = Job(prompt="a chair", guidance=str(checkpoints["1.x"]), settings=settings)
    guidance = prepare(job).guidance
    found = guidance.predict(noise(2), torch.tensor([500, 900]), views([180.0, 90.0]))
    assert found.opposing.shape == (3, 2, 4, 8, 8)
    # Behind the object all of front and side is away; at the side all of front and back.
    torch.testing.assert_close(
        found.opposing_weight, torch.tensor([[1.5, 1.5], [1.5, 0.0], [0.0, 1.5]]), atol=1e-5, rtol=0
    )


@pytest.mark.parametrize("name", ["soft_views", "perp_neg"])
def test_the_built_in_prior_refuses_settings_of_view_texts(name):
    job = Job(prompt="a chair", settings={f"guidance.{name}": {"perp_neg": 1.0}.get(name, True)})
    with pytest.raises(UserError, match=f"takes no guidance.{name}"):
        prepare(job)


def test_the_prompt_is_used(guidance):
    z_t, t, cameras = noise(1), torch.tensor([800]), views([0.0])
    chair, red = (guidance.prompted(prompt, "") for prompt in ("a chair", "the red"))
    first = predict_eps(chair, z_t, t, cameras, 1.0)
    assert difference(first, predict_eps(red, z_t, t, cameras, 1.0)) > 1e-3


@pytest.mark.parametrize("perp_neg", [0.0, 1.0])
def test_the_negative_prompt_s_noise_comes_apart_from_that_of_no_words(checkpoints, perp_neg):
    """As csd's negative prompt needs it; Perp-Neg's other views stay."""
    config = GuidanceConfig(perp_neg=perp_neg, default_negative=False)
    guidance = StableDiffusion.load(str(checkpoints["1.x"]), "cpu", config=config)
    z_t, t, cameras = noise(2), torch.tensor([300, 800]), views([0.0, 60.0])
    given = guidance.prompted("a chair", "a cup")
    wordless = guidance.prompted("a chair", "").predict(z_t, t, cameras).uncond
    plain, apart = given.predict(z_t, t, cameras), given.predict(z_t, t, cameras, apart=True)
    for found, expected in (
        (apart.cond, plain.cond),
        (apart.uncond, wordless),
        (apart.negative, plain.uncond),
    ):
        torch.testing.assert_close(found, expected, rtol=1e-4, atol=1e-5)
    assert plain.negative is None
    assert difference(apart.negative, apart.uncond) > 1e-3
    assert (apart.opposing is None) == (perp_neg == 0)
    if perp_neg:
        torch.testing.assert_close(apart.opposing, plain.opposing, rtol=1e-4, atol=1e-5)
        torch.testing.assert_close(apart.opposing_weight, plain.opposing_weight)


def test_perp_neg_steers_away_from_other_views_but_not_from_the_prompt(checkpoints):
    plain, perp = (
        StableDiffusion.load(
            str(checkpoints["1.x"]), "cpu", config=GuidanceConfig(perp_neg=w)
        ).prompted("a chair", "x")
        for w in (0.0, 1.0)
    )
    z_t, t, cameras = noise(2), torch.tensor([500, 900]), views([180.0, 90.0])
    cond, uncond = (predict_eps(plain, z_t, t, cameras, scale) for scale in (1.0, 0.0))
    guided = [predict_eps(guidance, z_t, t, cameras, 5.0) for guidance in (perp, plain)]
    change = guided[0] - guided[1]
    cosine = torch.cosine_similarity(change.flatten(1), (cond - uncond).flatten(1))
    assert change.abs().max() > 1e-3
    torch.testing.assert_close(cosine, torch.zeros(2), atol=1e-3, rtol=0)


def test_chunks_do_not_change_the_result(checkpoints):
    n, o = picture(5)
    z_t, t, cameras = noise(5), torch.arange(100, 600, 100), views([0.0, 80.0, 160.0, 240.0, 320.0])
    results = []
    for chunk in (1, 2, 8):
        guidance = StableDiffusion.load(str(checkpoints["2.x"]), "cpu", chunk=chunk)
        eps = predict_eps(guidance.prompted("a chair", ""), z_t, t, cameras, 7.5)
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
    prompted = own.prompted("a red chair", "x")
    grad = sds.sds_grad(
        prompted, z.float(), views([30.0]), torch.tensor([500]), noise(1), "sigma2", 100.0
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
        prompted = one.prompted(long, "")
    tokens, _ = one.texts.tokens(long, ", back view")
    assert len(tokens) == 77
    assert one.texts.tokenizer.decode(tokens[1:-1]).strip().endswith(", back view")
    z_t, t = noise(1).expand(2, -1, -1, -1), torch.full((2,), 600)
    eps = predict_eps(prompted, z_t, t, views([0.0, 180.0]), 1.0)
    assert difference(eps[0], eps[1]) > 1e-4


def test_a_tokenizer_that_states_no_length_has_the_encoders(own):
    """Saved without one, transformers states 10³⁰."""
    tokens, _ = own.texts.tokens("a chair", "")
    own.texts.tokenizer.model_max_length = int(1e30)
    assert own.texts.tokens("a chair", "")[0] == tokens


def test_a_long_negative_prompt_warns_for_itself(one):
    with pytest.warns(PromptCutWarning, match="The negative prompt is too long"):
        one.prompted("a chair", "very " * 90)


def test_any_script_is_embedded(one):
    assert one.prompted("一把红色的椅子 🦊", "").views.isfinite().all()


@pytest.mark.parametrize("prompt", ["", "  ", "x" * 5000, "a\x00b"])
def test_what_is_no_prompt_is_refused(one, prompt):
    with pytest.raises(UserError):
        one.prompted(prompt, "")


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


def test_a_view_of_what_was_there_before_takes_nothing():
    """A linear layer transposes its weight: it is not there a second time."""
    layer = torch.nn.Linear(1000, 1000, device="meta").requires_grad_(False)
    assert peak_bytes(lambda: layer(torch.empty(1, 1000))) == 8000  # in and out


def test_the_estimate_grows_with_the_chunk_and_knows_the_weights(checkpoints, one):
    sizes = [
        estimate_memory(Checkpoint(checkpoints["1.x"]), chunk=c, dtype=torch.float32)
        for c in (1, 4)
    ]
    weights = sum(p.nbytes for m in (one.unet, one.vae.encoder) for p in m.parameters())
    assert weights < sizes[0] < sizes[1] < 4 * sizes[0]
    half = estimate_memory(Checkpoint(checkpoints["1.x"]), chunk=1, dtype=torch.float16)
    assert half == pytest.approx(sizes[0] / 2, rel=0.05)


def test_the_chunk_shrinks_to_what_fits_and_too_little_memory_is_an_error(checkpoints, monkeypatch):
    folder = checkpoints["1.x"]
    one_view = estimate_memory(Checkpoint(folder), chunk=1, dtype=torch.float32)
    name = "core.guidance.stable_diffusion.fit.available_bytes"
    monkeypatch.setattr(name, lambda _: one_view)
    assert StableDiffusion.load(str(folder), "cpu").chunk == 1
    monkeypatch.setattr(name, lambda _: one_view - 1)
    with pytest.raises(MemoryShortError, match=r"needs about 0\.0 GB of 0\.0 GB") as error:
        StableDiffusion.load(str(folder), "cpu")
    assert error.value.status == 4


@pytest.mark.parametrize(
    ("gigabytes", "least", "chunk"),
    [
        (6, 1, 1),
        (8, 1, 2),
        (12, 1, 4),
        (24, 1, 8),
        (80, 1, 24),
        (12, 4, 4),
        (24, 4, 8),
        (80, 4, 24),
    ],
)
def test_a_gpus_memory_says_how_many_pictures_go_together(gigabytes, least, chunk, monkeypatch):
    """At Stable Diffusion 1.5's true size, in 16 bit, from its shipped configuration."""
    fit = "core.guidance.stable_diffusion.fit."
    monkeypatch.setattr(fit + "available_bytes", lambda _: gigabytes * 1e9)
    monkeypatch.setattr(fit + "estimate_memory", of_sd15)
    gpu, cpu = torch.device("cuda"), torch.device("cpu")
    checkpoint, given = Checkpoint(CONFIGURATIONS / "sd15"), {"texts": 2, "least": least}
    assert chunk_that_fits(checkpoint, gpu, torch.float16, **given) == chunk
    assert chunk_that_fits(checkpoint, cpu, torch.float16, **given) == min(chunk, MOST_ON_CPU)


def test_pictures_that_go_together_stay_together(checkpoints):
    checkpoint, cpu = Checkpoint(checkpoints["1.x"]), torch.device("cpu")
    assert chunk_that_fits(checkpoint, cpu, torch.float32, 6, texts=2, least=4) == 4


@cache
def of_sd15(checkpoint, **given):
    return estimate_memory(checkpoint, **given)


def test_perp_negs_other_predictions_are_in_the_estimate(checkpoints, monkeypatch):
    """Five predictions of a picture run together; a small U-Net needs more to outdo the encoder."""
    folder = checkpoints["1.x"]
    sizes = [
        estimate_memory(Checkpoint(folder), chunk=4, dtype=torch.float32, texts=n)
        for n in (2, 5, 50)
    ]
    assert sizes[0] <= sizes[1] < sizes[2]
    asked = []

    def estimate(*_, texts, **__):
        asked.append(texts)
        return 0

    monkeypatch.setattr("core.guidance.stable_diffusion.fit.estimate_memory", estimate)
    for weight in (0.0, 1.0):
        StableDiffusion.load(str(folder), "cpu", config=GuidanceConfig(perp_neg=weight))
    assert asked == [2, 5]


def test_running_out_of_memory_is_a_sentence_and_other_faults_are_not(own, monkeypatch):
    prompted = own.prompted("a chair", "")
    n, o = picture(1)

    def fail_with(error):
        def forward(*_, **__):
            raise error

        forward.dtype = torch.float32
        monkeypatch.setattr(own, "unet", forward)
        monkeypatch.setattr(own.vae, "encode", forward)

    fail_with(torch.cuda.OutOfMemoryError("CUDA out of memory"))
    with pytest.raises(MemoryShortError, match="U-Net"):
        predict_eps(prompted, noise(1), torch.tensor([5]), views([0.0]), 7.5)
    with pytest.raises(MemoryShortError, match="encoder"):
        own.encode_normals(n, o)
    fail_with(RuntimeError("a fault of ours"))
    with pytest.raises(RuntimeError, match="a fault of ours"):
        own.encode_normals(n, o)
