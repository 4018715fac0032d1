"""The scene's settings as a job of the core, and back."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import bpy

from ..environment.files import expanded, is_file
from ..errors import AddonError
from ..scene import light

FILE = "FILE"  # the value of the light's enum for a file of the user's own
SMALLEST, FEWEST = 0.001, 100  # metres, triangles: as core/io/job.py takes them
Settings = bpy.types.PropertyGroup  # FANTASIA3D_PG_settings, which ui/ declares


def job_of(settings: Settings, command: str = "generate") -> dict[str, Any]:
    """job.json for ``settings``, without the files that its run folder gets.

    Raises:
        AddonError: a required field is empty, or the light does not exist.
    """
    job = {
        "version": 1,
        "command": command,
        "prompt": settings.prompt.strip(),
        "negative_prompt": settings.negative_prompt.strip(),
        "seed": settings.seed,
        "preset": settings.preset,
        "guidance": guidance_of(settings),
        **additions_of(settings),
        "light": light_of(settings),
        "texture_size": int(settings.texture_size),
        "max_faces": max_faces_of(settings),
        "device": settings.device,
        "ignore_unknown_words": settings.ignore_unknown,
        "settings": overrides_of(settings),
    }
    # Blender holds single precision: 0.7 would be written as 0.699999988079071.
    if command == "generate":
        more = {"guide_strength": round(settings.guide_strength, 4), "size_m": size_of(settings)}
        return job | more
    return job | {"guide_strength": round(settings.color_strength, 4), "uv": "keep"}


def apply_job(settings: Settings, job: Mapping[str, Any]) -> None:
    """Set the panel's fields to those of a job of the history, but for its objects.

    Raises:
        AddonError: a value that the panel does not take; the fields stay as they are.
    """
    # Not settings.items(): from Blender 5.0 on they have no declared property.
    names = [p.identifier for p in settings.bl_rna.properties if not p.is_readonly]
    before = {name: getattr(settings, name) for name in names if settings.is_property_set(name)}
    try:
        _apply(settings, job)
    except (TypeError, ValueError, OverflowError) as error:
        for name in names:
            if name not in before:
                settings.property_unset(name)
            elif getattr(settings, name) != before[name]:
                setattr(settings, name, before[name])
        raise AddonError(
            f"The job has a value that the panel does not take ({error}).",
            "Set the fields yourself, or repeat the job as it is.",
        ) from None


def _apply(settings: Settings, job: Mapping[str, Any]) -> None:
    settings.task = job.get("command", "generate")
    for name in ("prompt", "negative_prompt", "seed", "preset", "max_faces", "device"):
        if name in job:
            setattr(settings, name, job[name])
    settings.texture_size = str(job.get("texture_size", 0))
    settings.size = job.get("size_m", 0.0)
    settings.ignore_unknown = job.get("ignore_unknown_words", False)
    # The core has one strength for both commands, the panel one for each.
    strength = "color_strength" if settings.task == "texture" else "guide_strength"
    setattr(settings, strength, job.get("guide_strength", 0.5))
    settings.use_present_color = bool(job.get("base_color"))
    settings.overrides = " ".join(f"{k}={_text_of(v)}" for k, v in job.get("settings", {}).items())
    _apply_guidance(settings, str(job.get("guidance", "builtin")))
    _apply_additions(settings, job)
    _apply_light(settings, str(job.get("light", light.STUDIO)))


def _text_of(value: Any) -> str:
    """A setting's value as a word: numbers with commas, and no spaces."""
    return "".join((",".join(map(str, value)) if isinstance(value, list) else str(value)).split())


def light_of(settings: Settings) -> str:
    """The light as the core takes it: "studio", or a file's path."""
    if settings.light == light.STUDIO:
        return light.STUDIO
    if settings.light == FILE and not settings.light_file.strip():
        raise AddonError("No light is chosen.", "Choose an HDR or EXR file.")
    name = settings.light_file if settings.light == FILE else settings.light
    return str(light.light_file(name))


def size_of(settings: Settings) -> float:
    """The longest side in metres; 0: as stated in the prompt, or the usual size."""
    size = float(f"{settings.size:.4g}")
    if 0 < size < SMALLEST:
        raise AddonError("The size is too small.", "Enter 1 mm or more, or 0 for the usual size.")
    return size


def max_faces_of(settings: Settings) -> int:
    """The face budget; 0: as the quality has it."""
    if 0 < settings.max_faces < FEWEST:
        raise AddonError("Max Faces is too low.", "Enter 100 or more, or 0 for the quality's own.")
    return settings.max_faces


def guidance_of(settings: Settings) -> str:
    """The guidance as the core takes it: "builtin", a folder, or a hub id."""
    if settings.guidance == "builtin":
        return "builtin"
    if settings.guidance == "hub":
        if not settings.hub_id.strip():
            raise AddonError("No model is chosen.", "Enter its hub id: owner/name.")
        return settings.hub_id.strip()
    path = expanded(bpy.path.abspath(settings.model_folder.strip()), AddonError)
    is_one = path.suffix.lower() == ".safetensors" and is_file(path)
    is_folder = is_file(path / "model_index.json")
    if not settings.model_folder.strip() or not (is_one or is_folder):
        raise AddonError(
            "The chosen file or folder is not a Stable Diffusion model.",
            "Choose a .safetensors file, or the folder that contains model_index.json.",
        )
    return str(path.resolve())


def additions_of(settings: Settings) -> dict[str, Any]:
    """The LoRA and the embedding over a Stable Diffusion model, as job.json has them.

    Raises:
        AddonError: a file that is not there or of another kind.
    """
    found: dict[str, Any] = {}
    if settings.guidance == "builtin":
        return found
    if settings.lora.strip():
        strength = round(settings.lora_strength, 4)
        found["loras"] = {str(_safetensors(settings.lora, "LoRA")): strength}
    if settings.embedding.strip():
        found["embeddings"] = [str(_safetensors(settings.embedding, "embedding"))]
    return found


def _safetensors(text: str, what: str) -> Path:
    path = expanded(bpy.path.abspath(text.strip()), AddonError)
    if path.suffix.lower() != ".safetensors" or not is_file(path):
        raise AddonError(f"There is no {what} “{path.name}”.", "Choose a .safetensors file.")
    return path.resolve()


def overrides_of(settings: Settings) -> dict[str, str]:
    """The settings ``stage.field=value`` that the user wrote."""
    found = {}
    for word in settings.overrides.split():
        key, equals, value = word.partition("=")
        if not (key and equals and value):
            raise AddonError(
                f"The setting {word!r} has no value.", "Write it as geometry.fine.steps=100."
            )
        found[key] = value
    return found


def _apply_guidance(settings: Settings, name: str) -> None:
    if name == "builtin":
        settings.guidance = "builtin"
    elif Path(name).is_absolute():
        settings.guidance, settings.model_folder = "folder", name
    else:
        settings.guidance, settings.hub_id = "hub", name


def _apply_additions(settings: Settings, job: Mapping[str, Any]) -> None:
    loras, embeddings = dict(job.get("loras") or {}), list(job.get("embeddings") or [])
    if len(loras) > 1 or len(embeddings) > 1:
        raise ValueError("several LoRA files or embeddings; it takes one of each")
    settings.lora, settings.lora_strength = next(iter(loras.items()), ("", 1.0))
    settings.embedding = next(iter(embeddings), "")


def _apply_light(settings: Settings, name: str) -> None:
    named = {str(path): f"blender:{key}" for key, path in light.blender_lights().items()}
    if name == light.STUDIO:
        settings.light = light.STUDIO
    elif name in named:
        settings.light = named[name]
    else:
        settings.light, settings.light_file = FILE, name
