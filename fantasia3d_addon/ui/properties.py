"""What the user asks for, kept in the scene; and the job that it makes."""

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
from ..scene import light
from . import icons

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
_light_items: list[tuple[str, str, str, int, int]] = []  # Blender keeps no reference to its texts


def _lights(_self: Any, _context: bpy.types.Context | None) -> list[tuple[str, str, str, int, int]]:
    if _light_items:
        return _light_items
    named = [(f"blender:{name}", name) for name in light.blender_lights()]
    items = [(light.STUDIO, "Neutral Studio", "A soft grey studio", "neutral")]
    items += [(key, name.title(), "A light that comes with Blender", name) for key, name in named]
    _light_items[:] = [
        (key, label, about, icons.light_icon(picture), _number(key))
        for key, label, about, picture in items
    ]
    about = "A lat-long HDR or EXR picture"
    _light_items.append((FILE, "File", about, icons.light_icon("file"), _number(FILE)))
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


CLASSES = (FANTASIA3D_PG_settings, FANTASIA3D_PG_entry, FANTASIA3D_PG_jobs)
