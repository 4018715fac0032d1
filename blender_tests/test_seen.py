"""What is seen at once: colours on arrival, a tool's progress, tidy nodes and collections."""

import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.physics import simulation  # noqa: E402
from fantasia3d_addon.scene import light, view  # noqa: E402
from fantasia3d_addon.ui import modal_operator, tools_panel  # noqa: E402

pytestmark = [pytest.mark.blender]


def test_a_grey_view_is_offered_its_colours(addon):
    bpy.ops.wm.read_factory_settings(use_empty=False)
    ((window, area),) = view.areas(bpy.context.scene)
    space = area.spaces.active
    assert view.hides_colors(space)
    with bpy.context.temp_override(window=window, area=area):
        bpy.ops.fantasia3d.show_colors(shading="TEXTURE")
        assert (space.shading.type, space.shading.color_type) == ("SOLID", "TEXTURE")
        assert not view.hides_colors(space)
        bpy.ops.fantasia3d.show_colors(shading="MATERIAL")
        assert space.shading.type == "MATERIAL"
        assert not view.hides_colors(space)


def test_new_nodes_are_not_selected(empty, asset):
    from fantasia3d_addon.material import edit

    obj = import_asset(bpy.context, asset)
    light.set_world(bpy.context.scene, light.STUDIO_FILE)
    assert selected(obj.active_material) == selected(bpy.context.scene.world) == []
    edit.adjust_material(obj.active_material)
    assert selected(obj.active_material) == []
    for name in ("wood", "gold"):
        assert selected(edit.replace_material(obj, name)) == []


def selected(owner) -> list[str]:
    return [node.name for node in owner.node_tree.nodes if node.select]


@pytest.mark.parametrize("kind", ["RIGID", "CLOTH"])
def test_the_proxies_of_a_simulation_are_in_one_hidden_collection(empty, asset, kind):
    obj = import_asset(bpy.context, asset)
    simulation.simulate(obj, kind, simulation.Options(frames=2))
    collection = bpy.data.collections[simulation.COLLECTION]
    assert collection.hide_render
    assert simulation.owner_of(obj).name in collection.objects
    assert all(made.hide_get() for made in collection.objects)
    assert obj.name not in collection.objects
    simulation.clear(obj)
    assert simulation.COLLECTION not in bpy.data.collections


class Layout:
    """A layout that keeps a progress bar."""

    def __init__(self) -> None:
        self.bars: list[str] = []

    def progress(self, factor: float, text: str) -> None:
        assert 0 <= factor <= 1
        self.bars.append(text)

    def column(self, **_more: object) -> "Layout":
        return self

    def label(self, **_more: object) -> None:
        pass


def test_a_tool_that_works_is_in_the_panel_and_the_others_wait(addon, asset):
    obj = import_asset(bpy.context, asset)
    bpy.context.view_layer.objects.active = obj
    assert bpy.ops.fantasia3d.simulate.poll()
    modal_operator.running[:] = [modal_operator.Running("Quad remesh", "Baking", 0.4)]
    try:
        assert not bpy.ops.fantasia3d.simulate.poll()
        with pytest.raises(RuntimeError, match="“Quad remesh” is running"):
            bpy.ops.fantasia3d.mark_asset()
        layout = Layout()
        assert tools_panel._draw_reason(layout, bpy.context)
        assert layout.bars == ["Quad remesh  40%"]
    finally:
        modal_operator.running.clear()
