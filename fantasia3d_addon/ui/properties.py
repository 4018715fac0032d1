"""The user's settings, kept in the scene: the fields of the main panel."""

from __future__ import annotations

import zlib
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

from ..jobs.job_settings import FILE
from ..jobs.place import CURSOR, FREE_PLACE, IN_VIEW
from ..scene import light
from . import icons

TASKS = (
    ("generate", "New Asset", "A textured mesh from a prompt", "MESH_MONKEY", 0),
    ("texture", "Selected Mesh", "A material for the active mesh", "MATERIAL", 1),
)
PRESETS = (
    ("draft", "Draft", "Minutes on a CPU, with the built-in model"),
    ("standard", "Standard", "The paper's method on one GPU"),
    ("paper", "Paper", "The paper's own settings: hours on one GPU"),
    # Last: Blender keeps the number of an item in its files.
    (
        "sds",
        "Score Distillation",
        "The draft by score distillation alone, as the paper has it",
    ),
)
GUIDANCE = (
    ("builtin", "Built-in", "The small model that comes with the add-on: some nouns and colours"),
    ("folder", "Folder or File", "A Stable Diffusion model on this machine"),
    ("hub", "Hugging Face", "A Stable Diffusion model by its id on the Hugging Face hub"),
)
SIZES = (
    ("0", "Automatic", "1024 for a draft, else 2048"),
    *((str(2**n), f"{2**n}", f"{2**n} × {2**n} texels") for n in range(9, 14)),
)
DEVICES = (
    ("auto", "Automatic", "The GPU if there is one"),
    ("cpu", "CPU", "The processor, also if there is a GPU"),
    ("cuda", "CUDA", "An NVIDIA GPU"),
    ("mps", "Metal", "An Apple GPU"),
)
UV_MODES = (
    ("keep", "Keep", "Use the active UV map; a mesh without one gets a new one"),
    ("new", "New", "Add a UV map “Fantasia3D” next to those that the mesh has"),
)
ASSIGN = (
    ("slot", "New Slot", "Add the material in a new slot and leave the other slots as they are"),
    ("object", "All Slots", "Show it in every slot; the mesh keeps its own materials underneath"),
)
PLACEMENTS = (
    (FREE_PLACE, "Free Place", "The place nearest to the 3D cursor where nothing else is"),
    (IN_VIEW, "In View", "The free place nearest to what the view is centred on"),
    (CURSOR, "3D Cursor", "Exactly at the 3D cursor, also inside of other objects"),
)
_light_items: list[tuple[str, str, str, int, int]] = []  # Blender keeps no reference to its texts


def light_items(_self: Any, _context: Any) -> list[tuple[str, str, str, int, int]]:
    """The lights of an EnumProperty: the studio, Blender's own, and a file."""
    if _light_items:
        return _light_items
    named = [(f"blender:{name}", name) for name in light.blender_lights()]
    items = [(light.STUDIO, "Neutral Studio", "A soft grey studio", "neutral")]
    items += [(key, name.title(), "A light that comes with Blender", name) for key, name in named]
    _light_items[:] = [
        (key, label, tip, icons.light_icon(picture), _number(key))
        for key, label, tip, picture in items
    ]
    tip = "A lat-long HDR or EXR picture"
    _light_items.append((FILE, "File", tip, icons.light_icon("file"), _number(FILE)))
    return _light_items


def clear_light_items() -> None:
    """Have the lights and their icons collected again."""
    _light_items.clear()


def _number(key: str) -> int:
    """The enum's number of a light; 0 is the studio.

    Files store the number: it must be the same in every Blender, whichever lights that has.
    """
    return 0 if key == light.STUDIO else zlib.crc32(key.encode()) & 0x3FFFFFFF


class FANTASIA3D_PG_settings(bpy.types.PropertyGroup):
    """The fields of the main panel."""

    task: EnumProperty(
        name="Task", description="A new asset, or a material for a mesh", items=TASKS
    )
    prompt: StringProperty(
        name="Prompt",
        description="What to make, such as: a red wooden chair",
        options={"TEXTEDIT_UPDATE"},  # the panel shows what is understood while it is typed
    )
    ignore_unknown: BoolProperty(
        name="Ignore Unknown Words",
        description="Leave out the words that the built-in model does not know",
    )
    negative_prompt: StringProperty(
        name="Negative Prompt", description="What it should not look like"
    )
    preset: EnumProperty(
        name="Quality", description="Steps, resolution and model of the run", items=PRESETS
    )
    seed: IntProperty(
        name="Seed", description="Start of the random numbers: another seed, another asset", min=0
    )
    candidates: IntProperty(
        name="Candidates",
        description="How many quick shapes Explore makes, or how many materials",
        default=4,
        min=2,
        max=8,
    )
    guidance: EnumProperty(
        name="Model", description="The diffusion model that guides the run", items=GUIDANCE
    )
    model_folder: StringProperty(
        name="Path",
        description=(
            "A Stable Diffusion model: one .safetensors file, or a folder that contains "
            "model_index.json"
        ),
        subtype="FILE_PATH",
    )
    lora: StringProperty(
        name="LoRA",
        description="A .safetensors file that changes the model's style or subject",
        subtype="FILE_PATH",
    )
    lora_strength: FloatProperty(
        name="Strength",
        description="How much of the LoRA is added; 1: as it was trained",
        default=1.0,
        min=-5.0,
        max=5.0,
        soft_min=0.0,
        soft_max=1.5,
    )
    embedding: StringProperty(
        name="Embedding",
        description=(
            "A textual inversion, a .safetensors file: write the file's name in the prompt or the "
            "negative prompt"
        ),
        subtype="FILE_PATH",
    )
    hub_id: StringProperty(name="Hub ID", description="owner/name of a Stable Diffusion model")
    guide: PointerProperty(
        name="Guide Mesh",
        description="A mesh whose shape the geometry starts from",
        type=bpy.types.Object,
        poll=lambda _self, obj: obj.type == "MESH",
    )
    guide_strength: FloatProperty(
        name="Strength",
        description="0: the guide mesh is a start only; 1: its shape is kept",
        default=0.5,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
    )
    size: FloatProperty(
        name="Size",
        description="Length of the longest side; 0: as stated in the prompt, or the usual size",
        default=0.0,
        min=0.0,
        max=1000.0,
        soft_max=30.0,
        precision=3,
        subtype="DISTANCE",
    )
    light: EnumProperty(
        name="Light", description="The light that the material is learned under", items=light_items
    )
    light_file: StringProperty(
        name="File", description="A lat-long HDR or EXR picture", subtype="FILE_PATH"
    )
    texture_size: EnumProperty(
        name="Texture Size", description="Texels along a side of the maps", items=SIZES
    )
    max_faces: IntProperty(
        name="Max Faces",
        description="The mesh is simplified to this many triangles; 0: as the quality has it",
        min=0,
        max=2_000_000,
    )
    placement: EnumProperty(
        name="Location", description="Where the preview and the asset appear", items=PLACEMENTS
    )
    device: EnumProperty(name="Device", description="What the run computes on", items=DEVICES)
    overrides: StringProperty(
        name="Overrides",
        description="Settings of the method, separated by spaces, such as: "
        "geometry.fine.steps=100 appearance.views=4",
    )
    uv: EnumProperty(name="UV Map", description="The UV map for the textures", items=UV_MODES)
    use_present_color: BoolProperty(
        name="Use Present Color",
        description="The material starts from the base color that the mesh has now",
    )
    color_strength: FloatProperty(
        name="Strength",
        description="0: the present color is a start only; 1: it is kept",
        default=0.5,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
    )
    assign: EnumProperty(
        name="Material", description="Where the new material is assigned", items=ASSIGN
    )


class FANTASIA3D_PG_entry(bpy.types.PropertyGroup):
    """One run of the history; its name is its folder's path."""


class FANTASIA3D_PG_jobs(bpy.types.PropertyGroup):
    """The history as the panel's list shows it."""

    entries: CollectionProperty(
        name="Runs", description="The runs on this machine, the newest first",
        type=FANTASIA3D_PG_entry,
    )  # fmt: skip
    index: IntProperty(name="Run", description="The selected run")


CLASSES = (FANTASIA3D_PG_settings, FANTASIA3D_PG_entry, FANTASIA3D_PG_jobs)
