"""Stable Diffusion in small: random weights, written with diffusers' own API."""

import json

import torch
from diffusers import AutoencoderKL, DDIMScheduler, StableDiffusionXLPipeline, UNet2DConditionModel
from diffusers import StableDiffusionPipeline as Pipeline
from transformers import (
    CLIPTextConfig,
    CLIPTextModel,
    CLIPTextModelWithProjection,
    CLIPTokenizer,
)

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
    if two:  # 2.x fills with another token than its end
        own = folder.with_name(folder.name + "_tokenizer")
        tokenizer = CLIPTokenizer.from_pretrained(own, model_max_length=77, pad_token="!")
    text_encoder = CLIPTextModel(
        CLIPTextConfig(
            vocab_size=len(tokenizer),
            hidden_size=width,
            intermediate_size=32,
            num_hidden_layers=2,
            num_attention_heads=2,
            bos_token_id=tokenizer.bos_token_id,
            eos_token_id=end,
            pad_token_id=tokenizer.pad_token_id,
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


def write_xl_checkpoint(folder):
    """Stable Diffusion XL in small: two text encoders, transformers of several layers."""
    torch.manual_seed(1)
    tokenizer = write_tokenizer(folder.with_name(folder.name + "_tokenizer"))
    second = CLIPTokenizer.from_pretrained(
        folder.with_name(folder.name + "_tokenizer"), model_max_length=77, pad_token="!"
    )
    end = tokenizer.eos_token_id
    numbers = {"vocab_size": len(tokenizer), "num_hidden_layers": 3, "num_attention_heads": 2}
    numbers |= {"bos_token_id": tokenizer.bos_token_id, "intermediate_size": 32}
    encoders = [
        CLIPTextModel(
            CLIPTextConfig(hidden_size=16, eos_token_id=end, pad_token_id=end, **numbers)
        ),
        CLIPTextModelWithProjection(
            CLIPTextConfig(
                hidden_size=24,
                projection_dim=20,
                hidden_act="gelu",
                eos_token_id=end,
                pad_token_id=second.pad_token_id,
                **numbers,
            )
        ),
    ]
    for encoder in encoders:
        torch.nn.init.normal_(encoder.get_input_embeddings().weight, std=1.0)
    unet = UNet2DConditionModel(
        sample_size=8,
        block_out_channels=(16, 32),
        layers_per_block=1,
        down_block_types=("DownBlock2D", "CrossAttnDownBlock2D"),
        up_block_types=("CrossAttnUpBlock2D", "UpBlock2D"),
        transformer_layers_per_block=[1, 2],
        cross_attention_dim=40,
        attention_head_dim=[2, 4],
        use_linear_projection=True,
        norm_num_groups=8,
        addition_embed_type="text_time",
        addition_time_embed_dim=8,
        projection_class_embeddings_input_dim=6 * 8 + 20,
    )
    vae = AutoencoderKL(
        down_block_types=("DownEncoderBlock2D",) * 4,
        up_block_types=("UpDecoderBlock2D",) * 4,
        block_out_channels=(8, 8, 16, 16),
        norm_num_groups=4,
        sample_size=64,
        scaling_factor=0.13025,
    )
    scheduler = DDIMScheduler(
        beta_start=0.00085,
        beta_end=0.012,
        beta_schedule="scaled_linear",
        clip_sample=False,
        steps_offset=1,
    )
    StableDiffusionXLPipeline(
        vae=vae,
        text_encoder=encoders[0],
        text_encoder_2=encoders[1],
        tokenizer=tokenizer,
        tokenizer_2=second,
        unet=unet,
        scheduler=scheduler,
        force_zeros_for_empty_prompt=True,
        add_watermarker=False,
    ).save_pretrained(folder)
    return folder
