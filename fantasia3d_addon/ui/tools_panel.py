"""The panels of the tools: light, material, placement, physics, mesh, export."""

from __future__ import annotations

import bpy

from .. import options
from ..jobs.job_settings import FILE
from ..material import edit as material_edit
from ..mesh import health
from ..physics import simulation
from ..scene import cornell_box, light
from . import modal_operator
from .operator_helpers import reason_against_tool
from .text import TAB, in_language, wrapped_label


class ToolPanel:
    """Mixin: in the sidebar's tab, collapsed at first."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_options = {"DEFAULT_CLOSED"}


class FANTASIA3D_PT_light(ToolPanel, bpy.types.Panel):
    """Relighting and the turntable."""

    bl_idname = "FANTASIA3D_PT_light"
    bl_label = "Scene Lighting"
    bl_order = 20

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        layout.prop(tools, "light")
        if tools.light == FILE:
            layout.prop(tools, "light_file")
        button = layout.operator("fantasia3d.relight", icon="LIGHT_SUN")
        button.light = tools.light_file if tools.light == FILE else tools.light
        kinds = ("Background", "Mapping")  # either may have been deleted
        background, mapping = (light.light_node(context.scene.world, kind) for kind in kinds)
        if background and mapping:  # the world is ours: both are edited in place
            rotation = mapping.inputs["Rotation"]
            button.strength = background.inputs["Strength"].default_value
            button.rotation = -rotation.default_value[2]
            column = layout.column(align=True)
            column.prop(background.inputs["Strength"], "default_value", text="Strength")
            column.prop(rotation, "default_value", index=2, text="Rotation")
        column = layout.column()
        column.separator()
        column.prop(tools, "turn")
        column.prop(tools, "turn_frames")
        column.prop(tools, "turn_size")
        button = column.operator("fantasia3d.turntable", icon="RENDER_ANIMATION")
        button.turn, button.frames, button.size = tools.turn, tools.turn_frames, tools.turn_size


class FANTASIA3D_PT_material(ToolPanel, bpy.types.Panel):
    """Another material, and adjustments of the present one."""

    bl_idname = "FANTASIA3D_PT_material"
    bl_label = "Material"
    bl_order = 21

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _draw_reason(layout, context):
            return
        layout.prop(tools, "material")
        layout.prop(tools, "own_material")
        layout.prop(tools, "keep_normals")
        column = layout.column(align=True)  # in one row their names would be cut
        button = column.operator("fantasia3d.replace_material", text="Apply", icon="MATERIAL")
        button.material = tools.own_material.name if tools.own_material else tools.material
        button.keep_normals = tools.keep_normals
        column.operator("fantasia3d.restore_material", icon="LOOP_BACK")
        material = context.active_object.active_material
        nodes = material_edit.edit_nodes(material) if material else []
        if not nodes:
            layout.operator("fantasia3d.adjust_material", icon="MODIFIER")
            return
        column = layout.column(align=True)
        names = dict(zip(material_edit.EDITS, ("Tint", "Roughness", "Metallic"), strict=True))
        for node in nodes:  # not all three where the user has deleted one
            column.prop(material_edit.factor(node), "default_value", text=names[node.name])
        layout.operator("fantasia3d.reset_material", icon="LOOP_BACK")


class FANTASIA3D_PT_scene(ToolPanel, bpy.types.Panel):
    """Where the asset is."""

    bl_idname = "FANTASIA3D_PT_scene"
    bl_label = "Placement"
    bl_order = 22

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        column = layout.column(align=True)  # in one row their names would be cut
        column.operator("fantasia3d.drop", icon="TRIA_DOWN_BAR")
        column.operator("fantasia3d.origin_to_base", icon="OBJECT_ORIGIN")
        if cornell_box.box_of(context.scene):
            layout.operator("fantasia3d.remove_cornell_box", icon="X")
        else:
            layout.operator("fantasia3d.cornell_box", icon="MESH_CUBE")


class FANTASIA3D_PT_physics(ToolPanel, bpy.types.Panel):
    """Simulations in one click."""

    bl_idname = "FANTASIA3D_PT_physics"
    bl_label = "Physics"
    bl_order = 23

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _draw_reason(layout, context):
            return
        layout.prop(tools, "kind")
        layout.prop(tools, "frames")
        layout.prop(tools, "height")
        layout.prop(tools, options.OF_KIND[tools.kind].name)
        button = layout.operator("fantasia3d.simulate", icon="PHYSICS")
        for option in (options.KIND, *options.SIMULATION):
            setattr(button, option.name, getattr(tools, option.name))
        if simulation.is_simulated(context.active_object):
            layout.operator("fantasia3d.clear_simulation", icon="X")


class FANTASIA3D_PT_health(ToolPanel, bpy.types.Panel):
    """The faults of the mesh, and their repair."""

    bl_idname = "FANTASIA3D_PT_health"
    bl_label = "Mesh Health"
    bl_order = 24

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        if _draw_reason(layout, context, changes=False):
            return
        obj = context.active_object
        layout.operator("fantasia3d.check_mesh", icon="VIEWZOOM")
        report = health.cached_report(obj)
        if report is None:
            return
        column = layout.column(align=True)
        for text, is_good in lines(report):
            icon = "CHECKMARK" if is_good else "ERROR"
            column.label(text=in_language(text), icon=icon, translate=False)
        for name, width, height in report.textures:
            role = name.removeprefix(plain_name(obj)).strip() or name
            column.label(text=f"{role}: {width} × {height}", icon="TEXTURE")
        column = layout.column(align=True)
        for fault in report.faults:
            label = health.REPAIRS[fault][0]
            button = column.operator("fantasia3d.repair_mesh", text=label, icon="TOOL_SETTINGS")
            button.what = fault
        if len(report.faults) > 1:
            column.operator("fantasia3d.repair_mesh", icon="TOOL_SETTINGS").what = "ALL"


class FANTASIA3D_PT_mesh(ToolPanel, bpy.types.Panel):
    """Fewer faces."""

    bl_idname = "FANTASIA3D_PT_mesh"
    bl_label = "LOD & Remesh"
    bl_order = 25

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _draw_reason(layout, context):
            return
        layout.prop(tools, "max_faces")
        column = layout.column()
        column.active = not tools.max_faces  # which takes their place
        column.prop(tools, "levels")
        column.prop(tools, "ratio")
        button = layout.operator("fantasia3d.make_lods", icon="MOD_DECIM")
        button.levels, button.ratio = tools.levels, tools.ratio
        button.max_faces = tools.max_faces
        layout.separator()
        layout.prop(tools, "quads")
        layout.operator("fantasia3d.quad_remesh", icon="MOD_REMESH").faces = tools.quads


class FANTASIA3D_PT_export(ToolPanel, bpy.types.Panel):
    """Files for other programs, and the Asset Browser."""

    bl_idname = "FANTASIA3D_PT_export"
    bl_label = "Export"
    bl_order = 26

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _draw_reason(layout, context, changes=False):
            return
        layout.prop(tools, "format")
        can_flip = tools.format in ("fbx", "obj")  # glTF and USD define the normal map as OpenGL's
        if can_flip:
            layout.prop(tools, "flip_normal_y")
        button = layout.operator("fantasia3d.export", icon="EXPORT")
        button.format = tools.format
        button.flip_normal_y = tools.flip_normal_y and can_flip
        layout.separator()
        layout.prop(tools, "tags")
        layout.operator("fantasia3d.mark_asset", icon="ASSET_MANAGER").tags = tools.tags


def counted(number: int, one: str, more: str = "") -> str:
    """1 face, 20,000 faces."""
    return f"{number:,} {one if number == 1 else more or one + 's'}"


def plain_name(obj: bpy.types.Object) -> str:
    """Without Blender's ".001": the names of an asset's pictures start with it."""
    return obj.name.rpartition(".")[0] if obj.name[-4:-3] == "." else obj.name


def lines(report: health.Report) -> list[tuple[str, bool]]:
    """The report in lines, and whether each is as it should be."""
    found = [
        (f"{counted(report.faces, 'face')}, {counted(report.verts, 'vertex', 'vertices')}", True),
        (counted(report.components, "connected component"), report.small_components == 0),
        ("Closed" if report.closed else counted(report.open_edges, "open edge"), report.closed),
        _line(report.nonmanifold, "Manifold", "non-manifold edge or vertex",
              "non-manifold edges or vertices"),
        _line(report.doubled, "No duplicate vertices", "duplicate vertex", "duplicate vertices"),
        ("Normals point inward" if report.inverted else "Normals point outward",
         not report.inverted),
    ]  # fmt: skip
    if report.uv_fill is None:
        return [*found, ("No UVs", False)]
    found.append((f"UVs cover {report.uv_fill:.0%}", report.uv_fill > 0))
    if report.uv_overlap:
        found.append((f"UVs overlap on {report.uv_overlap:.0%}", False))
    if report.texel_density:
        found.append((f"{report.texel_density:.0f} texels per metre", True))
    return found


def _line(number: int, good: str, one: str, more: str) -> tuple[str, bool]:
    """A line for a count that should be 0."""
    return (counted(number, one, more), False) if number else (good, True)


def _split(panel: bpy.types.Panel) -> bpy.types.UILayout:
    """The panel's layout with labels left of their fields, and no keyframe dots."""
    layout = panel.layout
    layout.use_property_split = True
    layout.use_property_decorate = False
    return layout


def _draw_reason(
    layout: bpy.types.UILayout, context: bpy.types.Context, changes: bool = True
) -> bool:
    """Show why no tool can act on the active object; whether there is a reason.

    A tool that is working is shown by its progress instead.
    """
    if modal_operator.running:
        now = modal_operator.running[0]
        title, step, escape = map(in_language, (now.title, now.step, "Esc: Cancel"))
        layout.progress(factor=now.fraction, text=f"{title}  {now.fraction:.0%}")
        wrapped_label(layout, context, f"{step}  {escape}".strip(), dimmed=True)
        return True
    reason = reason_against_tool(context, changes)
    if reason:
        wrapped_label(layout, context, reason, "INFO", dimmed=True)
    return bool(reason)


CLASSES = (
    FANTASIA3D_PT_light,
    FANTASIA3D_PT_material,
    FANTASIA3D_PT_scene,
    FANTASIA3D_PT_physics,
    FANTASIA3D_PT_health,
    FANTASIA3D_PT_mesh,
    FANTASIA3D_PT_export,
)
