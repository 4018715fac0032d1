"""The differences between Blender 4.2 and 5.2, in one place."""

from __future__ import annotations

from pathlib import Path

import bpy

ALWAYS_HAS_NODES = bpy.app.version >= (5, 0, 0)  # use_nodes is deprecated, and goes in 6.0
EEVEE = "BLENDER_EEVEE" if bpy.app.version >= (5, 0, 0) else "BLENDER_EEVEE_NEXT"


def empty_nodes(owner: bpy.types.Material | bpy.types.World) -> bpy.types.NodeTree:
    """The node tree of a new material or world, without any node."""
    if not ALWAYS_HAS_NODES:
        owner.use_nodes = True
    tree = owner.node_tree
    tree.nodes.clear()
    return tree


def has_nodes(owner: bpy.types.Material | bpy.types.World) -> bool:
    """Whether it shows its nodes; they may be switched off before 5.0."""
    return bool(owner.node_tree) and (ALWAYS_HAS_NODES or owner.use_nodes)


def deselect_nodes(tree: bpy.types.NodeTree) -> None:
    """Deselect all nodes: Blender selects each new one, and a drag would move them all."""
    for node in tree.nodes:
        node.select = False


def has_cycles() -> bool:
    """Whether Cycles is part of this build and enabled."""
    return hasattr(bpy.types.Scene, "cycles")


def has_denoiser() -> bool:
    """Whether this build of Cycles has OpenImageDenoise; Debian's builds have not."""
    try:
        import _cycles
    except ImportError:
        return False
    return bool(getattr(_cycles, "with_openimagedenoise", False))


def set_opengl_convention(node: bpy.types.ShaderNodeNormalMap) -> None:
    """Set the OpenGL convention (green points up); before 5.1 there was no other."""
    if "convention" in node.bl_rna.properties:
        node.convention = "OPENGL"


def render_path(path: Path) -> str:
    """``path`` for a render to write to: since 4.5 braces mark a template there."""
    text, name = str(path), bpy.types.RenderSettings.bl_rna.properties["filepath"]
    templates = getattr(name, "is_path_supports_templates", False)
    return text.replace("{", "{{").replace("}", "}}") if templates else text


def set_video(scene: bpy.types.Scene) -> None:
    """Render to an MP4 file: H.264 in a form that every player reads."""
    settings = scene.render.image_settings
    if "media_type" in settings.bl_rna.properties:  # since 5.0 it limits the formats below
        settings.media_type = "VIDEO"
    settings.file_format = "FFMPEG"
    ffmpeg = scene.render.ffmpeg
    ffmpeg.format, ffmpeg.codec = "MPEG4", "H264"
    ffmpeg.constant_rate_factor, ffmpeg.audio_codec = "HIGH", "NONE"


def show_through(material: bpy.types.Material) -> None:
    """Let EEVEE show what is behind the material, where it has the option."""
    if "use_raytrace_refraction" in material.bl_rna.properties:
        material.use_raytrace_refraction = True


def has_video() -> bool:
    """Whether this build writes MP4."""
    return bool(bpy.app.build_options.codec_ffmpeg)


def has_usd() -> bool:
    """Whether this build writes USD; Debian's do not."""
    return bool(bpy.app.build_options.usd)


def usd_textures() -> dict[str, object]:
    """The option of the USD exporter that writes pictures into a folder next to the file."""
    properties = bpy.ops.wm.usd_export.get_rna_type().properties
    mode = "export_textures_mode" in properties
    return {"export_textures_mode": "NEW"} if mode else {"export_textures": True}


def has_operator(group: str, name: str) -> bool:
    """Whether an operator exists: some of Blender's exporters are add-ons that may be disabled."""
    return name in dir(getattr(bpy.ops, group))


def text_field(
    layout: bpy.types.UILayout, data: bpy.types.bpy_struct, name: str, placeholder: str
) -> None:
    """A text property without its label; of several lines where Blender has those (5.2)."""
    if "textbox" in bpy.types.UILayout.bl_rna.functions:
        layout.textbox(data, name, initial_visible_lines=2, placeholder=placeholder)
    else:
        layout.prop(data, name, text="", placeholder=placeholder)
