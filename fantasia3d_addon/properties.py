"""What the user asks for, kept in the scene; and the job that it makes."""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from . import light, thumbnails
from .errors import AddonError

TASKS = (
    ("generate", "New Asset", "A textured mesh from words", "MESH_MONKEY", 0),
    ("texture", "Selected Mesh", "A material for the mesh that is selected", "MATERIAL", 1),
)
PRESETS = (
    ("draft", "Draft", "Minutes on a CPU, with the built-in prior"),
    ("standard", "Standard", "The paper's method on one GPU"),
    ("paper", "Paper", "The paper's own settings: hours on one GPU"),
)
GUIDANCE = (
    ("builtin", "Built-in", "The small prior that comes with the add-on: a few nouns and colours"),
    ("folder", "Stable Diffusion Folder", "A Stable Diffusion model in a folder of yours"),
    ("hub", "Hub Model", "A Stable Diffusion model by its id on the Hugging Face hub"),
)
SIZES = (
    ("0", "Automatic", "1024 for a draft, else 2048"),
    *((str(2**n), f"{2**n}", "") for n in range(9, 14)),
)
DEVICES = (
    ("auto", "Automatic", "The GPU where there is one"),
    ("cpu", "CPU", ""),
    ("cuda", "CUDA", "An NVIDIA GPU"),
    ("mps", "Metal", "An Apple GPU"),
)
UV_MODES = (
    ("keep", "Keep", "The active UV map takes the textures; a mesh without one gets a new one"),
    ("new", "New", "A new UV map “Fantasia3D”, beside those that the mesh has"),
)
ASSIGN = (
    ("slot", "New Slot", "The slots that are there stay as they are; assign the new one yourself"),
    ("object", "All Slots", "Every slot shows it; the mesh keeps its own materials underneath"),
)
FILE = "FILE"
_light_items: list[tuple[str, str, str, int, int]] = []  # Blender keeps no reference to its texts


def _lights(_self: Any, _context: bpy.types.Context | None) -> list[tuple[str, str, str, int, int]]:
    if _light_items:
        return _light_items
    named = [(f"blender:{name}", name) for name in light.blender_lights()]
    items = [(light.STUDIO, "Neutral Studio", "A soft grey studio", "neutral")]
    items += [(key, name.title(), "A light that comes with Blender", name) for key, name in named]
    _light_items[:] = [
        (key, label, about, thumbnails.light_icon(picture), _number(key))
        for key, label, about, picture in items
    ]
    about = "A lat-long HDR or EXR picture"
    _light_items.append((FILE, "File", about, thumbnails.light_icon("file"), _number(FILE)))
    return _light_items


def forget_lights() -> None:
    """Have the lights and their pictures looked for anew."""
    _light_items.clear()


def _number(key: str) -> int:
    """The same for a light in every Blender, whichever others it has; 0 is the studio."""
    return 0 if key == light.STUDIO else zlib.crc32(key.encode()) & 0x3FFFFFFF


class FANTASIA3D_PG_settings(bpy.types.PropertyGroup):
    """The fields of the panel."""

    task: EnumProperty(name="Task", items=TASKS)
    prompt: StringProperty(name="Prompt", description="What to make, such as: a red wooden chair")
    negative_prompt: StringProperty(name="Without", description="What it should not look like")
    preset: EnumProperty(name="Quality", items=PRESETS)
    seed: IntProperty(name="Seed", description="Another seed gives another asset", min=0)
    guidance: EnumProperty(name="Guidance", items=GUIDANCE)
    model_folder: StringProperty(
        name="Folder",
        description="The folder of a Stable Diffusion model: model_index.json lies in it",
        subtype="DIR_PATH",
    )
    hub_id: StringProperty(name="Hub id", description="owner/name of a Stable Diffusion model")
    guide: PointerProperty(
        name="Guide",
        description="A mesh whose shape the geometry starts from",
        type=bpy.types.Object,
        poll=lambda _self, obj: obj.type == "MESH",
    )
    guide_strength: FloatProperty(
        name="Strength",
        description="0: the guide is a start only; 1: its shape is kept",
        default=0.5,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
    )
    light: EnumProperty(
        name="Light", description="The light that the material is learned under", items=_lights
    )
    light_file: StringProperty(
        name="File", description="A lat-long HDR or EXR picture", subtype="FILE_PATH"
    )
    texture_size: EnumProperty(name="Texture", description="Texels along a side", items=SIZES)
    max_faces: IntProperty(
        name="Faces",
        description="The mesh is simplified to this many triangles; 0 is the quality's own number",
        min=0,
        max=2_000_000,
    )
    device: EnumProperty(name="Device", items=DEVICES)
    overrides: StringProperty(
        name="Settings",
        description="More settings of the method, with spaces between, such as: "
        "geometry.fine.steps=100 appearance.views=4",
    )
    uv: EnumProperty(name="UV Map", items=UV_MODES)
    use_present_color: BoolProperty(
        name="Start from its Colour",
        description="The material begins with the base colour that the mesh has now",
    )
    color_strength: FloatProperty(
        name="Strength",
        description="0: the colour is a start only; 1: it is kept",
        default=0.5,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
    )
    assign: EnumProperty(name="Material", items=ASSIGN)


class FANTASIA3D_PG_entry(bpy.types.PropertyGroup):
    """One run of the history; its name is its folder's path."""


class FANTASIA3D_PG_jobs(bpy.types.PropertyGroup):
    """The history as the panel's list has it."""

    entries: CollectionProperty(type=FANTASIA3D_PG_entry)
    index: IntProperty(name="Run")


def light_of(settings: FANTASIA3D_PG_settings) -> str:
    """The light as the core takes it: "studio", or a file's path."""
    if settings.light == light.STUDIO:
        return light.STUDIO
    if settings.light == FILE and not settings.light_file.strip():
        raise AddonError("No light is named.", "Choose an HDR or EXR file.")
    name = settings.light_file if settings.light == FILE else settings.light
    return str(light.light_file(name))


def guidance_of(settings: FANTASIA3D_PG_settings) -> str:
    """The guidance as the core takes it: "builtin", a folder, or a hub id."""
    if settings.guidance == "builtin":
        return "builtin"
    if settings.guidance == "hub":
        if not settings.hub_id.strip():
            raise AddonError("No model is named.", "Write its hub id: owner/name.")
        return settings.hub_id.strip()
    folder = Path(bpy.path.abspath(settings.model_folder.strip())).expanduser()
    if not settings.model_folder.strip() or not (folder / "model_index.json").is_file():
        raise AddonError(
            "The guidance's folder is no Stable Diffusion model.",
            "Choose the folder that holds model_index.json.",
        )
    return str(folder.resolve())


def overrides_of(settings: FANTASIA3D_PG_settings) -> dict[str, str]:
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


def job_of(settings: FANTASIA3D_PG_settings, command: str = "generate") -> dict[str, Any]:
    """job.json for ``settings``, without the files that its run folder gets.

    Raises:
        AddonError: a field is wanted that is empty, or a light is not there.
    """
    job = {
        "version": 1,
        "command": command,
        "prompt": settings.prompt.strip(),
        "negative_prompt": settings.negative_prompt.strip(),
        "seed": settings.seed,
        "preset": settings.preset,
        "guidance": guidance_of(settings),
        "light": light_of(settings),
        "texture_size": int(settings.texture_size),
        "max_faces": settings.max_faces,
        "device": settings.device,
        "settings": overrides_of(settings),
    }
    if command == "generate":
        return job | {"guide_strength": round(settings.guide_strength, 4)}
    return job | {"guide_strength": round(settings.color_strength, 4), "uv": "keep"}


def take_job(settings: FANTASIA3D_PG_settings, job: Mapping[str, Any]) -> None:
    """Set the panel's fields to those of a job of the history; its objects excepted."""
    settings.task = job.get("command", "generate")
    for name in ("prompt", "negative_prompt", "seed", "preset", "max_faces", "device"):
        if name in job:
            setattr(settings, name, job[name])
    settings.texture_size = str(job.get("texture_size", 0))
    strength = "color_strength" if settings.task == "texture" else "guide_strength"
    setattr(settings, strength, job.get("guide_strength", 0.5))
    settings.use_present_color = bool(job.get("base_color"))
    settings.overrides = " ".join(f"{k}={v}" for k, v in job.get("settings", {}).items())
    _take_guidance(settings, str(job.get("guidance", "builtin")))
    _take_light(settings, str(job.get("light", light.STUDIO)))


def _take_guidance(settings: FANTASIA3D_PG_settings, name: str) -> None:
    if name == "builtin":
        settings.guidance = "builtin"
    elif Path(name).is_absolute():
        settings.guidance, settings.model_folder = "folder", name
    else:
        settings.guidance, settings.hub_id = "hub", name


def _take_light(settings: FANTASIA3D_PG_settings, name: str) -> None:
    named = {str(path): f"blender:{key}" for key, path in light.blender_lights().items()}
    if name == light.STUDIO:
        settings.light = light.STUDIO
    elif name in named:
        settings.light = named[name]
    else:
        settings.light, settings.light_file = FILE, name


CLASSES = (FANTASIA3D_PG_settings, FANTASIA3D_PG_entry, FANTASIA3D_PG_jobs)
