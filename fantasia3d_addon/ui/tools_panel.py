"""The tab's panels for what comes after an asset: light, material, scene, physics, mesh, export."""

from __future__ import annotations

import bpy

from ..jobs.job_settings import FILE
from ..material import edit as material_edit
from ..mesh import health
from ..physics import simulation
from ..scene import cornell_box, light
from .operator_helpers import reason_against
from .text import TAB, sentence


class ToolPanel:
    """Where they all stand; folded at first."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_options = {"DEFAULT_CLOSED"}


class FANTASIA3D_PT_light(ToolPanel, bpy.types.Panel):
    """Relighting and the turntable."""

    bl_idname = "FANTASIA3D_PT_light"
    bl_label = "Light"
    bl_order = 20

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        layout.prop(tools, "light")
        if tools.light == FILE:
            layout.prop(tools, "light_file")
        press = layout.operator("fantasia3d.relight", icon="LIGHT_SUN")
        press.light = tools.light_file if tools.light == FILE else tools.light
        world = context.scene.world
        background = light.light_node(world, "Background")
        if background:
            press.strength = background.inputs["Strength"].default_value
            turn = light.light_node(world, "Mapping").inputs["Rotation"]
            press.rotation = -turn.default_value[2]
            column = layout.column(align=True)
            column.prop(background.inputs["Strength"], "default_value", text="Strength")
            column.prop(turn, "default_value", index=2, text="Rotation")
        column = layout.column()
        column.separator()
        column.prop(tools, "turn")
        column.prop(tools, "turn_frames")
        column.prop(tools, "turn_size")
        table = column.operator("fantasia3d.turntable", icon="RENDER_ANIMATION")
        table.turn, table.frames, table.size = tools.turn, tools.turn_frames, tools.turn_size


class FANTASIA3D_PT_material(ToolPanel, bpy.types.Panel):
    """Another material, and the edits of this one."""

    bl_idname = "FANTASIA3D_PT_material"
    bl_label = "Material"
    bl_order = 21

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _refused(layout, context):
            return
        layout.prop(tools, "material")
        layout.prop(tools, "own_material")
        layout.prop(tools, "keep_normals")
        row = layout.row(align=True)
        press = row.operator("fantasia3d.replace_material", text="Replace", icon="MATERIAL")
        press.material = tools.own_material.name if tools.own_material else tools.material
        press.keep_normals = tools.keep_normals
        row.operator("fantasia3d.restore_material", text="Go Back", icon="LOOP_BACK")
        material = context.active_object.active_material
        nodes = material_edit.edit_nodes(material) if material else []
        if not nodes:
            layout.operator("fantasia3d.adjust_material", icon="MODIFIER")
            return
        column = layout.column(align=True)
        for node, name in zip(nodes, ("Tint", "Roughness", "Metallic"), strict=True):
            column.prop(material_edit.factor(node), "default_value", text=name)
        layout.operator("fantasia3d.reset_material", icon="LOOP_BACK")


class FANTASIA3D_PT_scene(ToolPanel, bpy.types.Panel):
    """Where the asset stands."""

    bl_idname = "FANTASIA3D_PT_scene"
    bl_label = "Scene"
    bl_order = 22

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        row = layout.row(align=True)
        row.operator("fantasia3d.drop", icon="TRIA_DOWN_BAR")
        row.operator("fantasia3d.origin_to_base", icon="OBJECT_ORIGIN")
        if cornell_box.box_of(context.scene):
            layout.operator("fantasia3d.remove_cornell_box", icon="X")
        else:
            layout.operator("fantasia3d.cornell_box", icon="MESH_CUBE")


class FANTASIA3D_PT_physics(ToolPanel, bpy.types.Panel):
    """One click each."""

    bl_idname = "FANTASIA3D_PT_physics"
    bl_label = "Physics"
    bl_order = 23

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _refused(layout, context):
            return
        layout.prop(tools, "kind")
        layout.prop(tools, "frames")
        layout.prop(tools, "height")
        own = {"RIGID": "convex", "SOFT": "softness"}.get(tools.kind, "self_collision")
        layout.prop(tools, own)
        press = layout.operator("fantasia3d.simulate", icon="PHYSICS")
        for name in ("kind", "frames", "height", "convex", "softness", "self_collision"):
            setattr(press, name, getattr(tools, name))
        if simulation.is_simulated(context.active_object):
            layout.operator("fantasia3d.clear_simulation", icon="X")


class FANTASIA3D_PT_health(ToolPanel, bpy.types.Panel):
    """What is right and wrong with the mesh."""

    bl_idname = "FANTASIA3D_PT_health"
    bl_label = "Mesh Health"
    bl_order = 24

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        if _refused(layout, context):
            return
        obj = context.active_object
        layout.operator("fantasia3d.check_mesh", icon="VIEWZOOM")
        report = health.known(obj)
        if report is None:
            return
        column = layout.column(align=True)
        for text, good in lines(report):
            column.label(text=text, icon="CHECKMARK" if good else "ERROR")
        for name, width, height in report.textures:
            role = name.removeprefix(plain_name(obj)).strip() or name
            column.label(text=f"{role}: {width} × {height}", icon="TEXTURE")
        column = layout.column(align=True)
        for fault in report.faults:
            press = column.operator(
                "fantasia3d.repair_mesh", text=health.REPAIRS[fault][0], icon="TOOL_SETTINGS"
            )
            press.what = fault
        if len(report.faults) > 1:
            column.operator("fantasia3d.repair_mesh", icon="TOOL_SETTINGS").what = "ALL"


class FANTASIA3D_PT_mesh(ToolPanel, bpy.types.Panel):
    """Fewer faces."""

    bl_idname = "FANTASIA3D_PT_mesh"
    bl_label = "Levels of Detail"
    bl_order = 25

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _refused(layout, context):
            return
        layout.prop(tools, "levels")
        layout.prop(tools, "ratio")
        press = layout.operator("fantasia3d.make_lods", icon="MOD_DECIM")
        press.levels, press.ratio = tools.levels, tools.ratio
        layout.separator()
        layout.prop(tools, "quads")
        layout.operator("fantasia3d.quad_remesh", icon="MOD_REMESH").faces = tools.quads


class FANTASIA3D_PT_export(ToolPanel, bpy.types.Panel):
    """Out of this file."""

    bl_idname = "FANTASIA3D_PT_export"
    bl_label = "Export"
    bl_order = 26

    def draw(self, context: bpy.types.Context) -> None:
        layout, tools = _split(self), context.scene.fantasia3d_tools
        if _refused(layout, context):
            return
        layout.prop(tools, "format")
        if tools.format in ("fbx", "obj"):
            layout.prop(tools, "flip_normal_y")
        press = layout.operator("fantasia3d.export", icon="EXPORT")
        press.format = tools.format
        press.flip_normal_y = tools.flip_normal_y and tools.format in ("fbx", "obj")
        layout.separator()
        layout.prop(tools, "tags")
        layout.operator("fantasia3d.mark_asset", icon="ASSET_MANAGER").tags = tools.tags


def many(number: int, one: str, more: str = "") -> str:
    """1 face, 20,000 faces."""
    return f"{number:,} {one if number == 1 else more or one + 's'}"


def plain_name(obj: bpy.types.Object) -> str:
    """Without Blender's ".001": the pictures of an asset begin with it."""
    return obj.name.rpartition(".")[0] if obj.name[-4:-3] == "." else obj.name


def lines(report: health.Report) -> list[tuple[str, bool]]:
    """What the report says, a line at a time, and whether it is as it should be."""
    told = [
        (f"{many(report.faces, 'face')}, {many(report.verts, 'vertex', 'vertices')}", True),
        (many(report.pieces, "piece"), report.specks == 0),
        ("Closed" if report.closed else many(report.open_edges, "open edge"), report.closed),
        (
            many(report.nonmanifold, "non-manifold place") if report.nonmanifold else "Manifold",
            not report.nonmanifold,
        ),
        (
            many(report.doubled, "doubled vertex", "doubled vertices")
            if report.doubled
            else "Welded",
            not report.doubled,
        ),
        ("Faces outward" if not report.inverted else "Faces turned inward", not report.inverted),
    ]  # fmt: skip
    if report.uv_fill is None:
        return [*told, ("No UVs", False)]
    told.append((f"UVs fill {report.uv_fill:.0%}", report.uv_fill > 0))
    if report.uv_overlap:
        told.append((f"UVs overlap on {report.uv_overlap:.0%}", False))
    if report.texel_density:
        told.append((f"{report.texel_density:.0f} texels per metre", True))
    return told


def _split(panel: bpy.types.Panel) -> bpy.types.UILayout:
    layout = panel.layout
    layout.use_property_split = True
    layout.use_property_decorate = False
    return layout


def _refused(layout: bpy.types.UILayout, context: bpy.types.Context) -> bool:
    """Says why there is nothing to act on."""
    reason = reason_against(context)
    if reason:
        sentence(layout, context, reason, "INFO", quiet=True)
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
