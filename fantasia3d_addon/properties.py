"""What the user asks for, kept in the scene; and the job that it makes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
from bpy.props import (
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from . import light
from .errors import AddonError

PRESETS = (
    ("draft", "Draft", "Minutes on a CPU, with the built-in prior"),
    ("standard", "Standard", "The paper's method on one GPU"),
    ("paper", "Paper", "The paper's own settings: hours on one GPU"),
)
GUIDANCE = (
    ("builtin", "Built-in", "The small prior that comes with the add-on: a few nouns and colours"),
    ("model", "Stable Diffusion", "A Stable Diffusion model, by folder or by hub id"),
)
SIZES = (("0", "Of the preset", ""), *((str(2**n), f"{2**n}", "") for n in range(9, 14)))
FILE = "FILE"
_light_items: list[tuple[str, str, str]] = []  # Blender keeps no reference to an enum's texts


def _lights(_self: Any, _context: bpy.types.Context | None) -> list[tuple[str, str, str]]:
    if not _light_items:
        named = [(f"blender:{name}", name.title(), "") for name in light.blender_lights()]
        _light_items.extend(
            [
                (light.STUDIO, "Neutral Studio", "A soft grey studio"),
                *named,
                (FILE, "File", "A lat-long HDR or EXR picture"),
            ]
        )
    return _light_items


class FANTASIA3D_PG_settings(bpy.types.PropertyGroup):
    """The fields of the panel "Generate from text"."""

    prompt: StringProperty(name="Prompt", description="What to make, such as: a red wooden chair")
    negative_prompt: StringProperty(name="Negative", description="What it should not look like")
    preset: EnumProperty(name="Preset", items=PRESETS)
    seed: IntProperty(name="Seed", description="Another seed gives another asset", min=0)
    guidance: EnumProperty(name="Guidance", items=GUIDANCE)
    model: StringProperty(
        name="Model",
        description="The folder of a Stable Diffusion model, or its hub id",
        subtype="FILE_PATH",
    )
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
    texture_size: EnumProperty(name="Texture Size", description="Texels along a side", items=SIZES)
    max_faces: IntProperty(
        name="Max Faces",
        description="The mesh is simplified to this many triangles; 0 is the preset's own number",
        min=0,
        max=2_000_000,
    )


def light_of(settings: FANTASIA3D_PG_settings) -> str:
    """The light as the core takes it: "studio", or a file's path."""
    if settings.light == light.STUDIO:
        return light.STUDIO
    name = settings.light_file if settings.light == FILE else settings.light
    return str(light.light_file(name))


def job_of(settings: FANTASIA3D_PG_settings, guide_mesh: Path | None = None) -> dict[str, Any]:
    """job.json for ``settings``; ``guide_mesh`` is the file of the guide's shape.

    Raises:
        AddonError: a field is wanted that is empty, or a light is not there.
    """
    model = bpy.path.abspath(settings.model) if settings.model.startswith("//") else settings.model
    if settings.guidance == "model" and not model.strip():
        raise AddonError(
            "No model is named.", "Name the folder of a Stable Diffusion model, or its hub id."
        )
    return {
        "version": 1,
        "command": "generate",
        "prompt": settings.prompt.strip(),
        "negative_prompt": settings.negative_prompt.strip(),
        "seed": settings.seed,
        "preset": settings.preset,
        "guidance": model.strip() if settings.guidance == "model" else "builtin",
        "guide_mesh": str(guide_mesh.resolve()) if guide_mesh else "",
        "guide_strength": round(settings.guide_strength, 4),
        "light": light_of(settings),
        "texture_size": int(settings.texture_size),
        "max_faces": settings.max_faces,
    }
