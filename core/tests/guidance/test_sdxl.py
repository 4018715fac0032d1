"""Stable Diffusion XL against diffusers' own pipeline: two texts, a pooled one, and sizes."""

import pytest
import torch

from core.camera import Cameras
from core.config import GuidanceConfig
from core.guidance.guidance import Views
from core.guidance.sds import predict_eps
from core.guidance.stable_diffusion.guidance import StableDiffusion


@pytest.fixture(scope="module")
def pipeline(checkpoints):
    from diffusers import StableDiffusionXLPipeline  # it takes seconds

    return StableDiffusionXLPipeline.from_pretrained(
        checkpoints["xl"], local_files_only=True, add_watermarker=False
    )


@pytest.mark.parametrize("negative", ["the x", ""])
def test_the_noise_is_what_diffusers_own_parts_predict(negative, pipeline, checkpoints):
    """An empty negative prompt is zeros in SDXL; 700 is any time step."""
    z_t = torch.randn(1, 4, 8, 8, generator=torch.Generator().manual_seed(0))
    with torch.no_grad():
        cond, uncond, pooled, pooled_uncond = pipeline.encode_prompt(
            "a red chair, side view",
            device="cpu",
            do_classifier_free_guidance=True,
            negative_prompt=negative or None,
        )
        ids = pipeline._get_add_time_ids(
            (64, 64), (0, 0), (64, 64), torch.float32, text_encoder_projection_dim=20
        )
        added = {"text_embeds": torch.cat([pooled, pooled_uncond]), "time_ids": ids.repeat(2, 1)}
        out = pipeline.unet(
            z_t.repeat(2, 1, 1, 1),
            700,
            encoder_hidden_states=torch.cat([cond, uncond]),
            added_cond_kwargs=added,
        ).sample
    expected = out[1] + 7.5 * (out[0] - out[1])
    config = GuidanceConfig(default_negative=False)
    guidance = StableDiffusion.load(str(checkpoints["xl"]), "cpu", config=config)
    views = Views(Cameras.orbit([90.0], [0.0]))
    prompted = guidance.prompted("a red chair", negative)
    ours = predict_eps(prompted, z_t, torch.tensor([700]), views, 7.5)
    torch.testing.assert_close(ours[0], expected, rtol=1e-4, atol=1e-4)


def test_the_pooled_text_and_the_sizes_make_a_difference(checkpoints):
    guidance = StableDiffusion.load(str(checkpoints["xl"]), "cpu")
    text = guidance.prompted("a red chair", "").views[:1]
    z_t, t = torch.ones(1, 4, 8, 8), torch.tensor([500])
    plain = guidance.eps(z_t, t, text)
    other = text.clone()
    other[:, -1] += 1
    assert (guidance.eps(z_t, t, other) - plain).abs().max() > 1e-4
    guidance.latent_size = 16
    assert (guidance.eps(z_t, t, text) - plain).abs().max() > 1e-4


def test_the_latent_has_sdxls_scale(pipeline, checkpoints):
    guidance = StableDiffusion.load(str(checkpoints["xl"]), "cpu")
    picture = torch.rand(1, 64, 64, 3, generator=torch.Generator().manual_seed(1))
    with torch.no_grad():
        posterior = pipeline.vae.encode(picture.permute(0, 3, 1, 2) * 2 - 1).latent_dist
    found = guidance.encode_color(picture, torch.ones(1, 64, 64, 1))
    torch.testing.assert_close(found, posterior.mode() * 0.13025, rtol=1e-4, atol=1e-5)
