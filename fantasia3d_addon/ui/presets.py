"""Settings that the user saves under a name: Blender's own presets."""

from __future__ import annotations

import bpy
from bl_operators.presets import AddPresetBase
from bl_ui.utils import PresetPanel

FOLDER = "fantasia3d"
SAVED = (  # what a preset holds: everything but the prompt, the seed and the objects
    "negative_prompt",
    "preset",
    "guidance",
    "model_folder",
    "hub_id",
    "lora",
    "lora_strength",
    "embedding",
    "guide_strength",
    "light",
    "light_file",
    "texture_size",
    "max_faces",
    "ignore_unknown",
    "size",
    "placement",
    "candidates",
    "device",
    "overrides",
    "uv",
    "use_present_color",
    "color_strength",
    "assign",
)


class FANTASIA3D_OT_preset_add(AddPresetBase, bpy.types.Operator):
    """Save the present settings under a name, or remove a saved preset"""

    bl_idname = "fantasia3d.preset_add"
    bl_label = "Save Preset"
    preset_menu = "FANTASIA3D_PT_presets"
    preset_defines = ["settings = bpy.context.scene.fantasia3d"]
    preset_values = [f"settings.{name}" for name in SAVED]
    preset_subdir = FOLDER


class FANTASIA3D_PT_presets(PresetPanel, bpy.types.Panel):
    """Saved settings."""

    bl_label = "Presets"
    preset_subdir = FOLDER
    preset_operator = "script.execute_preset"
    preset_add_operator = "fantasia3d.preset_add"


CLASSES = (FANTASIA3D_OT_preset_add, FANTASIA3D_PT_presets)
