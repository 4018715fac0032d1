"""What is no checkpoint is refused by name; what is one is found and loaded, offline."""

import json
import shutil

import huggingface_hub
import pytest
import torch
from safetensors.torch import load_file, save_file

from core.errors import MissingError, UserError
from core.guidance.load import make_guidance
from core.guidance.stable_diffusion.checkpoint import find_checkpoint, weight_variant
from core.guidance.stable_diffusion.guidance import StableDiffusion
from core.guidance.stable_diffusion.models import described


@pytest.fixture
def broken(checkpoints, tmp_path):
    return shutil.copytree(checkpoints["1.x"], tmp_path / "broken")


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


@pytest.mark.parametrize("spec", ["/no/such/folder", "./no", "~/no-such-folder-there"])
def test_a_missing_folder_is_missing(spec):
    with pytest.raises(MissingError, match="no folder") as error:
        load(spec)
    assert error.value.status == 3


@pytest.mark.parametrize(
    "spec", ["builtn", "a b/c", "one/two/three", "", "modèles/rêve", "models/sd--v1", "my/-model"]
)
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
    assert find_checkpoint("someone/something").folder == checkpoints["1.x"]
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


@pytest.mark.parametrize("text", ["{", "[]", "5", '{"n": ' + "9" * 5000 + "}", "[" * 100_000])
@pytest.mark.parametrize("name", ["model_index.json", "unet/config.json", "vae/config.json"])
def test_broken_json_is_refused_by_file(broken, name, text):
    (broken / name).write_text(text)
    with pytest.raises(UserError, match="cannot be read"):
        load(broken)


@pytest.mark.parametrize("entry", [5, "ab", ["diffusers"], ["diffusers", ["x"]], {}])
def test_an_index_without_its_classes_is_refused_and_listed_as_such(broken, entry):
    edit(broken / "model_index.json", unet=entry)
    with pytest.raises(UserError, match="whose unet is missing"):
        find_checkpoint(str(broken))
    assert "whose unet is missing" in described(broken).reason


def test_a_scheduler_s_class_that_is_no_name_is_none_of_the_distilled(broken):
    edit(broken / "scheduler" / "scheduler_config.json", _class_name=["LCMScheduler"])
    assert find_checkpoint(str(broken)).folder == broken


def test_a_unet_of_no_size_is_refused(broken):
    """diffusers' own default: nothing says how large a picture is."""
    edit(broken / "unet" / "config.json", sample_size=None)
    with pytest.raises(UserError, match="sample_size in unet/config.json is None"):
        load(broken)


def test_a_configuration_of_other_types_is_refused(broken):
    edit(broken / "text_encoder" / "config.json", max_position_embeddings=None)
    with pytest.raises(UserError, match="text_encoder.* cannot be loaded"):
        load(broken)


def test_a_missing_tokenizer_is_refused(broken):
    shutil.rmtree(broken / "tokenizer")
    with pytest.raises(UserError, match=r"tokenizer.*cannot be loaded"):
        load(broken)


def test_other_encoders_inpainting_and_sample_prediction_are_refused_by_name(broken):
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


def test_sdxl_without_its_second_tokenizer_and_its_refiner_are_refused(broken):
    """What makes a folder SDXL's must be there whole; a refiner has the second encoder alone."""
    second = ["transformers", "CLIPTextModelWithProjection"]
    edit(broken / "model_index.json", text_encoder_2=second)
    with pytest.raises(UserError, match="tokenizer_2 is missing; expected CLIPTokenizer") as error:
        load(broken)
    assert "Stable Diffusion 1.x, 2.x or XL" in error.value.fix
    edit(broken / "model_index.json", tokenizer_2=["transformers", "CLIPTokenizer"])
    with pytest.raises(UserError, match="U-Net does not fit its text encoders"):
        load(broken)
    edit(broken / "model_index.json", text_encoder=[None, None])
    with pytest.raises(UserError, match="text_encoder is missing"):
        load(broken)
    edit(
        broken / "model_index.json",
        text_encoder=["transformers", "CLIPTextModel"],
        text_encoder_2=[None, None],
    )
    assert find_checkpoint(str(broken)).folder == broken
    # As in SDXL: projection_class_embeddings_input_dim goes with it.
    edit(
        broken / "unet" / "config.json",
        addition_embed_type="text_time",
        addition_time_embed_dim=256,
        projection_class_embeddings_input_dim=2816,
    )
    with pytest.raises(UserError, match="SDXL's refiner"):
        load(broken)


def test_unclip_is_refused_by_its_class_embedding(broken):
    edit(
        broken / "unet" / "config.json",
        class_embed_type="projection",
        projection_class_embeddings_input_dim=2048,
    )
    with pytest.raises(UserError, match="unCLIP, whose U-Net also takes a picture's embedding"):
        load(broken)


def test_models_distilled_to_a_few_steps_are_refused(broken):
    """A latent consistency model by its U-Net or its scheduler, SD-Turbo by its scheduler."""
    path = broken / "scheduler" / "scheduler_config.json"
    edit(path, _class_name="LCMScheduler")
    with pytest.raises(UserError, match=r"latent consistency model.*LCMScheduler.*no score"):
        load(broken)
    edit(path, _class_name="EulerDiscreteScheduler", timestep_spacing="trailing")
    with pytest.raises(UserError, match=r"turbo model.*trailing") as error:
        load(broken)
    assert "DDIMScheduler" in error.value.fix
    edit(path, timestep_spacing="leading")
    edit(broken / "unet" / "config.json", time_cond_proj_dim=256)
    with pytest.raises(UserError, match="LCM"):
        load(broken)


@pytest.mark.parametrize(
    "scheduler",
    [
        {"_class_name": "EulerDiscreteScheduler", "timestep_spacing": "leading"},
        {"_class_name": "EulerAncestralDiscreteScheduler", "timestep_spacing": "linspace"},
        {"_class_name": "DDIMScheduler", "timestep_spacing": "trailing"},
    ],
)
def test_plain_checkpoints_may_have_any_other_scheduler(broken, scheduler):
    edit(broken / "scheduler" / "scheduler_config.json", **scheduler)
    assert load(broken).latent_size == 8


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
    from diffusers import StableDiffusionPipeline  # it takes seconds

    pipeline = StableDiffusionPipeline.from_pretrained(broken, local_files_only=True)
    pipeline.set_progress_bar_config(disable=True)
    folder = broken.with_name("half")
    pipeline.to(torch.float16).save_pretrained(folder, variant="fp16")
    guidance = load(folder)
    assert guidance.unet.dtype == torch.float32
    assert guidance.prompted("a chair", "").views.isfinite().all()
