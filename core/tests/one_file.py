"""A folder of diffusers' as one file in CompVis' layout: the other way round than the core's map.

The U-Net's and the encoder's names come from a table of prefixes, as in kohya's and diffusers' own
conversion scripts; ``test_single_file.py`` holds the result against diffusers' reader.
"""

import json
import shutil
from pathlib import Path

import torch
from safetensors.torch import load_file, save_file

RESNET = [("in_layers.0", "norm1"), ("in_layers.2", "conv1"), ("out_layers.0", "norm2"),
          ("out_layers.3", "conv2"), ("emb_layers.1", "time_emb_proj"),
          ("skip_connection", "conv_shortcut")]  # fmt: skip
ENDS = [("time_embed.0", "time_embedding.linear_1"), ("time_embed.2", "time_embedding.linear_2"),
        ("input_blocks.0.0", "conv_in"), ("out.0", "conv_norm_out"), ("out.2", "conv_out"),
        ("label_emb.0.0", "add_embedding.linear_1"),
        ("label_emb.0.2", "add_embedding.linear_2")]  # fmt: skip
CLIP = [("resblocks.", "text_model.encoder.layers."), ("ln_1", "layer_norm1"),
        ("ln_2", "layer_norm2"), (".c_fc.", ".fc1."), (".c_proj.", ".fc2."),
        (".attn", ".self_attn"), ("ln_final.", "text_model.final_layer_norm.")]  # fmt: skip
OPEN_CLIP_NAMES = {
    "token_embedding.weight": "text_model.embeddings.token_embedding.weight",
    "positional_embedding": "text_model.embeddings.position_embedding.weight",
}


def write_one_file(folder: Path, path: Path, *, metadata=None, extra=None) -> Path:
    """The checkpoint ``folder`` as the file ``path``."""
    weights = {
        part: load_file(next((folder / part).glob("*.safetensors"))) for part in parts(folder)
    }
    config = json.loads((folder / "unet" / "config.json").read_text())
    out = {f"model.diffusion_model.{k}": v for k, v in unet(weights["unet"], config).items()}
    out |= {f"first_stage_model.{k}": v for k, v in vae(weights["vae"]).items()}
    is_two = config.get("use_linear_projection")
    first = named(weights["text_encoder"])
    if "text_encoder_2" in weights:
        out |= {f"conditioner.embedders.0.transformer.{k}": v for k, v in first.items()}
        second = open_clip(named(weights["text_encoder_2"]))
        out |= {f"conditioner.embedders.1.model.{k}": v for k, v in second.items()}
    elif is_two:
        out |= {f"cond_stage_model.model.{k}": v for k, v in open_clip(first).items()}
    else:
        out |= {f"cond_stage_model.transformer.{k}": v for k, v in first.items()}
        ids = torch.arange(77)[None]
        out["cond_stage_model.transformer.text_model.embeddings.position_ids"] = ids
    whole = {key: value.contiguous() for key, value in (out | (extra or {})).items()}
    save_file(whole, path, metadata=metadata)
    return path


def parts(folder: Path) -> list[str]:
    return [p.parent.name for p in folder.glob("*/*.safetensors")]


def named(weights):
    """The text encoder's weights as they are published: transformers 5 drops the wrapper's name."""
    return {
        k if k.startswith(("text_model.", "text_projection")) else f"text_model.{k}": v
        for k, v in weights.items()
    }


def unet(weights, config):
    layers, blocks = config["layers_per_block"], len(config["block_out_channels"])
    table = []
    for i in range(blocks):
        for j in range(layers):
            number = (layers + 1) * i + j + 1
            table.append((f"input_blocks.{number}.0.", f"down_blocks.{i}.resnets.{j}."))
            table.append((f"input_blocks.{number}.1.", f"down_blocks.{i}.attentions.{j}."))
        last = (layers + 1) * (i + 1)
        table.append((f"input_blocks.{last}.0.op.", f"down_blocks.{i}.downsamplers.0.conv."))
        for j in range(layers + 1):
            number = (layers + 1) * i + j
            table.append((f"output_blocks.{number}.0.", f"up_blocks.{i}.resnets.{j}."))
            table.append((f"output_blocks.{number}.1.", f"up_blocks.{i}.attentions.{j}."))
        place = 2 if any(k.startswith(f"up_blocks.{i}.attentions") for k in weights) else 1
        table.append((f"output_blocks.{last - 1}.{place}.", f"up_blocks.{i}.upsamplers.0."))
    table += [("middle_block.0.", "mid_block.resnets.0."),
              ("middle_block.1.", "mid_block.attentions.0."),
              ("middle_block.2.", "mid_block.resnets.1.")]  # fmt: skip
    out = {}
    for key, value in weights.items():
        name = key
        for theirs, ours in ENDS:
            name = theirs + name[len(ours) :] if name.startswith(f"{ours}.") else name
        if "resnets" in key:
            for theirs, ours in RESNET:
                name = name.replace(ours, theirs)
        for theirs, ours in table:
            name = name.replace(ours, theirs)
        out[name] = value
    return out


def vae(weights):
    out = {}
    for key, value in weights.items():
        if key.startswith(("decoder", "post_quant")):
            continue
        name = key.replace("conv_norm_out", "norm_out").replace("conv_shortcut", "nin_shortcut")
        for i in range(4):
            name = name.replace(f"down_blocks.{i}.resnets.", f"down.{i}.block.")
            name = name.replace(f"down_blocks.{i}.downsamplers.0.", f"down.{i}.downsample.")
        name = name.replace("mid_block.resnets.0", "mid.block_1")
        name = name.replace("mid_block.resnets.1", "mid.block_2")
        if "attentions" in key:
            for theirs, ours in (("norm.", "group_norm."), ("q.", "to_q."), ("k.", "to_k."),
                                 ("v.", "to_v."), ("proj_out.", "to_out.0.")):  # fmt: skip
                name = name.replace(ours, theirs)
            name = name.replace("mid_block.attentions.0", "mid.attn_1")
            # The published files' are convolutions of 1 x 1.
            value = value[:, :, None, None] if value.ndim == 2 else value
        out[name] = value
    return out


def open_clip(weights):
    out, gathered = {}, {}
    for key, value in weights.items():
        if key == "text_projection.weight":
            out["text_projection"] = value.T
            continue
        plain = next((a for a, b in OPEN_CLIP_NAMES.items() if b == key), None)
        if plain:
            out[plain] = value
            continue
        name = key
        for theirs, ours in CLIP:
            name = name.replace(ours, theirs)
        name = f"transformer.{name}" if name.startswith("resblocks") else name
        for number, part in enumerate(("q_proj", "k_proj", "v_proj")):
            if f".{part}." in name:
                block, end = name.split(f".{part}.")
                gathered.setdefault(f"{block}.in_proj_{end}", {})[number] = value
                break
        else:
            out[name] = value
    return out | {k: torch.cat([v[0], v[1], v[2]]) for k, v in gathered.items()}


def write_configurations(folder: Path, checkpoints: dict[str, Path]) -> Path:
    """The shipped configurations in small: those of ``checkpoints``."""
    for name, checkpoint in checkpoints.items():
        for file in checkpoint.glob("*/*config.json"):
            if file.parent.name.startswith("tokenizer"):
                continue
            to = folder / name / file.parent.name
            to.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, to)
        words = checkpoint.with_name(checkpoint.name + "_tokenizer") / "merges.txt"
        (folder / "tokenizer").mkdir(exist_ok=True)
        shutil.copy(words, folder / "tokenizer")
    return folder
