"""LoRA files and textual inversions over a checkpoint, against the sums by hand."""

import json
import struct

import pytest
import torch
from safetensors.torch import save_file

from core.command_line import job_of, parse
from core.errors import UserError
from core.generate import prepare
from core.guidance.guidance import PromptWarning
from core.guidance.stable_diffusion.embedding import read_embedding
from core.guidance.stable_diffusion.guidance import StableDiffusion
from core.guidance.stable_diffusion.lora import read_pairs
from core.guidance.stable_diffusion.source import Additions
from core.io.job import Job
from core.provenance import recorded

QUERY = "down_blocks.0.attentions.0.transformer_blocks.0.attn1.to_q"
CONV = "down_blocks.0.resnets.0.conv1"
TEXT = "encoder.layers.1.self_attn.q_proj"
RANK = 2


def load(folder, loras=None, embeddings=()):
    given = Additions({str(k): v for k, v in (loras or {}).items()}, tuple(map(str, embeddings)))
    return StableDiffusion.load(str(folder), "cpu", additions=given)


def weights(guidance, encoder=0):
    model = guidance.texts.encoders[encoder].model
    text = dict(getattr(model, "text_model", model).named_parameters())
    return dict(guidance.unet.named_parameters()), text


def pair(weight, seed=0, rank=RANK):
    """A and B of a layer, as files hold them."""
    g = torch.Generator().manual_seed(seed)
    down = torch.randn(rank, *weight.shape[1:], generator=g)
    up = torch.randn(len(weight), rank, *(1,) * (weight.ndim - 2), generator=g)
    return down, up


def product(down, up):
    """B A, entry by entry."""
    return torch.einsum("or,r...->o...", up.flatten(1), down)


LAYOUTS = {
    # layout: names of the query, the convolution, the text layer; of A and B
    "kohya": ("lora_unet_{u}", "lora_te_text_model_{t}", "lora_down.weight", "lora_up.weight"),
    "peft": ("unet.{u}", "text_encoder.text_model.{t}", "lora_A.weight", "lora_B.weight"),
}


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("kind", ["1.x", "2.x"])
def test_the_weights_are_w_and_strength_alpha_by_rank_b_a(layout, kind, checkpoints, tmp_path):
    plain = load(checkpoints[kind])
    unet, text = weights(plain)
    of_unet, of_text, a, b = LAYOUTS[layout]
    tensors, expected, alpha = {}, {}, 1.5
    for number, name in enumerate((QUERY, CONV, TEXT)):
        table, form = (text, of_text) if name == TEXT else (unet, of_unet)
        weight = table[f"{name}.weight"]
        down, up = pair(weight, number)
        written = name.replace(".", "_") if layout == "kohya" else name
        key = form.format(u=written, t=written)
        tensors |= {f"{key}.{a}": down, f"{key}.{b}": up, f"{key}.alpha": torch.tensor(alpha)}
        expected[name] = weight + 0.7 * alpha / RANK * product(down, up)
    path = tmp_path / "style.safetensors"
    save_file(tensors, path)
    changed_unet, changed_text = weights(load(checkpoints[kind], {path: 0.7}))
    for name in unet:
        wanted = expected.get(name.removesuffix(".weight"), unet[name])
        torch.testing.assert_close(changed_unet[name], wanted, rtol=1e-6, atol=1e-6)
    for name in text:
        wanted = expected.get(name.removesuffix(".weight"), text[name])
        torch.testing.assert_close(changed_text[name], wanted, rtol=1e-6, atol=1e-6)


def test_older_names_and_a_stated_alpha_are_read(checkpoints, tmp_path):
    """diffusers' attention processors without an alpha, and peft's alpha in the metadata."""
    unet, _ = weights(load(checkpoints["1.x"]))
    name = QUERY.replace("to_q", "to_out.0")
    down, up = pair(unet[f"{name}.weight"])
    old = "unet." + QUERY.replace("to_q", "processor.to_out_lora")
    save_file({f"{old}.down.weight": down, f"{old}.up.weight": up}, tmp_path / "old.safetensors")
    new = {f"unet.{name}.lora_A.weight": down, f"unet.{name}.lora_B.weight": up}
    stated = json.dumps({"unet.lora_alpha": 6.0, "unet.r": RANK})
    path = tmp_path / "new.safetensors"
    save_file(new, path, metadata={"lora_adapter_metadata": stated})
    for file, scale in ((tmp_path / "old.safetensors", 1.0), (path, 6.0 / RANK)):
        changed, _ = weights(load(checkpoints["1.x"], {file: 1.0}))
        wanted = unet[f"{name}.weight"] + scale * product(down, up)
        torch.testing.assert_close(changed[f"{name}.weight"], wanted, rtol=1e-6, atol=1e-6)


def test_sdxls_loras_name_compvis_blocks_and_two_text_encoders(checkpoints, tmp_path):
    plain = load(checkpoints["xl"])
    name = "down_blocks.1.attentions.0.transformer_blocks.1.attn2.to_k"
    weight = dict(plain.unet.named_parameters())[f"{name}.weight"]
    _, second = weights(plain, 1)
    key = "lora_unet_input_blocks_3_1_transformer_blocks_1_attn2_to_k"
    key_2 = f"lora_te2_text_model_{TEXT.replace('.', '_')}"
    one, two = pair(weight), pair(second[f"{TEXT}.weight"], 1)
    path = tmp_path / "xl.safetensors"
    tensors = {f"{key}.lora_down.weight": one[0], f"{key}.lora_up.weight": one[1]}
    tensors |= {f"{key_2}.lora_down.weight": two[0], f"{key_2}.lora_up.weight": two[1]}
    save_file(tensors, path)
    changed = load(checkpoints["xl"], {path: -1.0})
    found = dict(changed.unet.named_parameters())[f"{name}.weight"]
    torch.testing.assert_close(found, weight - product(*one), rtol=1e-6, atol=1e-6)
    _, found = weights(changed, 1)
    wanted = second[f"{TEXT}.weight"] - product(*two)
    torch.testing.assert_close(found[f"{TEXT}.weight"], wanted, rtol=1e-6, atol=1e-6)


def lora(key, down, up):
    return {f"{key}.lora_down.weight": down, f"{key}.lora_up.weight": up}


@pytest.mark.parametrize(
    ("tensors", "says"),
    [
        (lora("lora_unet_nowhere", torch.zeros(1, 2), torch.zeros(2, 1)), "another kind of model"),
        (lora(f"unet.{QUERY}", torch.zeros(1, 999), torch.zeros(16, 1)), "another version"),
        ({f"unet.{QUERY}.lora_A.weight": torch.zeros(1, 16)}, "one half"),
        ({"x.hada_w1_a": torch.zeros(1)}, "holds LoHa"),
        ({"x.lora_A.weight": torch.zeros(1), "x.dora_scale": torch.zeros(1)}, "holds DoRA"),
        ({"emb_params": torch.zeros(1, 16)}, "is textual inversion"),
        # What was not read was once left out in silence.
        (
            {f"unet.{QUERY}.lora_{x}.default.weight": torch.zeros(1, 1) for x in "AB"},
            "layout that is not known here: 2 of its 2",
        ),
        (
            lora("x", *torch.zeros(2, 1, 1)) | {"x.lora_up.bias": torch.zeros(1)},
            "layout that is not known here: 1 of its 3",
        ),
        (lora("x", torch.zeros(1, 2), torch.zeros(2, 3)), "have no product"),
        (lora("x", torch.zeros(0, 2), torch.zeros(2, 0)), "have no product"),
        (lora("x", torch.zeros(()), torch.zeros(())), "have no product"),
        (lora("x", *torch.zeros(2, 1, 1)) | {"x.alpha": torch.zeros(3)}, "have no product"),
    ],
)
def test_what_is_no_lora_for_this_checkpoint_is_refused(tensors, says, checkpoints, tmp_path):
    save_file(tensors, tmp_path / "x.safetensors")
    with pytest.raises(UserError, match=says):
        load(checkpoints["1.x"], {tmp_path / "x.safetensors": 1.0})


# ---- textual inversion


@pytest.mark.parametrize("name", ["emb_params", "<my-chair>"])
def test_an_embedding_is_its_vectors_in_the_place_of_its_word(name, checkpoints, tmp_path):
    """The text encoder's own embedding table, with the vectors of two words it knows."""
    plain = load(checkpoints["1.x"])
    table = plain.texts.encoders[0].model.get_input_embeddings().weight
    ids, _ = plain.texts.tokens("red x", "")
    path = tmp_path / "MyStyle.safetensors"
    save_file({name: table[ids[1:3]].clone()}, path)
    made = load(checkpoints["1.x"], embeddings=[path])
    for word in ("mystyle", "MyStyle") if name == "emb_params" else (name,):
        found = made.prompted(f"a {word}, chair", "").views
        torch.testing.assert_close(found, plain.prompted("a red x, chair", "").views)
    # Part of another word it is not.
    assert made.texts.tokens("mystyles", "")[0] == plain.texts.tokens("mystyles", "")[0]


def test_sdxl_takes_vectors_for_both_encoders(checkpoints, tmp_path):
    plain = load(checkpoints["xl"])
    tables = [e.model.get_input_embeddings().weight for e in plain.texts.encoders]
    number = plain.texts.tokens("red", "")[0][1]
    path = tmp_path / "thing.safetensors"
    rows = {n: t[[number]].clone() for n, t in zip(("clip_l", "clip_g"), tables, strict=True)}
    save_file(rows, path)
    made = load(checkpoints["xl"], embeddings=[path])
    found, wanted = (g.prompted(f"a {w}", "").views for g, w in ((made, "thing"), (plain, "red")))
    torch.testing.assert_close(found, wanted)


def test_an_embedding_that_is_not_written_warns_and_one_too_wide_is_refused(checkpoints, tmp_path):
    path = tmp_path / "glow.safetensors"
    save_file({"emb_params": torch.zeros(1, 16)}, path)
    with pytest.warns(PromptWarning, match='"glow" is not used'):
        load(checkpoints["1.x"], embeddings=[path]).prompted("a chair", "")
    load(checkpoints["1.x"], embeddings=[path]).prompted("a chair", "glow")  # warnings are errors
    save_file({"emb_params": torch.zeros(1, 768)}, path)
    with pytest.raises(UserError, match="for other text encoders.*768"):
        load(checkpoints["1.x"], embeddings=[path])


@pytest.mark.parametrize(
    ("tensors", "says"),
    [
        ({"emb_params": torch.zeros(0, 16)}, "has no vectors"),
        ({"emb_params": torch.zeros(1, 1, 16)}, "for other text encoders"),
        ({"emb_params": torch.zeros(())}, "for other text encoders"),
    ],
)
def test_an_embedding_that_is_no_table_is_refused(tensors, says, checkpoints, tmp_path):
    save_file(tensors, tmp_path / "x.safetensors")
    with pytest.raises(UserError, match=says):
        load(checkpoints["1.x"], embeddings=[tmp_path / "x.safetensors"])


@pytest.mark.parametrize("name", ["x.lora_A.weight", "emb_params"])
def test_a_file_whose_header_alone_is_whole_is_refused(name, tmp_path):
    """Its entry has a shape of 16 numbers and the bytes of one."""
    entry = {name: {"dtype": "F32", "shape": [1, 16], "data_offsets": [0, 4]}}
    text = json.dumps(entry).encode()
    path = tmp_path / "x.safetensors"
    path.write_bytes(struct.pack("<Q", len(text)) + text + bytes(4))
    with pytest.raises(UserError, match="cannot be loaded"):
        read_embedding(path, [16]) if name == "emb_params" else read_pairs(path)


# ---- the job


def test_the_command_line_names_them_with_a_strength(tmp_path):
    text = ["generate", "a chair", "--lora", f"{tmp_path}/a.safetensors:0.5"]
    text += ["--lora", f"{tmp_path}/b.safetensors", "--embedding", f"{tmp_path}/c.safetensors"]
    job = job_of(parse(text))
    assert job.loras == {f"{tmp_path}/a.safetensors": 0.5, f"{tmp_path}/b.safetensors": 1.0}
    assert Job.from_json(job.to_json()) == job
    assert recorded(job)["loras"] == {"a.safetensors": 0.5, "b.safetensors": 1.0}
    assert recorded(job)["embeddings"] == ["c.safetensors"]


def test_a_job_takes_them_over_a_checkpoint_alone(checkpoints, tmp_path):
    with pytest.raises(UserError, match="built-in model takes no LoRA"):
        prepare(Job(prompt="a chair", loras={"x.safetensors": 1.0}))
    unet, _ = weights(load(checkpoints["1.x"]))
    down, up = pair(unet[f"{QUERY}.weight"])
    path = tmp_path / "x.safetensors"
    save_file(lora(f"unet.{QUERY}", down, up), path)
    job = Job(prompt="a chair", guidance=str(checkpoints["1.x"]), loras={str(path): 0.25})
    changed = prepare(job).guidance._guidance.unet.state_dict()[f"{QUERY}.weight"]
    wanted = unet[f"{QUERY}.weight"] + 0.25 * product(down, up)
    torch.testing.assert_close(changed, wanted, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize(
    "fields",
    [{"loras": {"a": 9.0}}, {"loras": {"a": float("nan")}}, {"loras": {"a": "x"}},
     {"loras": {"": 1.0}}, {"embeddings": [1]}, {"embeddings": "a"}],
)  # fmt: skip
def test_a_job_checks_them(fields):
    with pytest.raises(UserError):
        Job(prompt="a chair", **fields)
