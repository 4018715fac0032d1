"""Relighting and the turntable."""

import math
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.pictures import add_ball, lobe, paint_white, read, render, write_hdr  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.errors import AddonError, LightError, OutputError  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.scene import light, relight  # noqa: E402
from fantasia3d_addon.scene import render as scene_render  # noqa: E402
from fantasia3d_addon.ui import scene_operators  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def side(picture: np.ndarray) -> float:
    """How much brighter the right half of the ball is than the left: -1 to 1."""
    left, right = picture[16:48, 16:32].mean(), picture[16:48, 32:48].mean()
    return float((right - left) / (right + left))


@pytest.fixture
def lights(tmp_path):
    """Three files: from the left, from the front, from the right."""
    places = {"left": (-1, -0.5, 0), "front": (0, -1, 0), "right": (1, -0.5, 0)}
    return {name: write_hdr(tmp_path / f"{name}.hdr", lobe(to)) for name, to in places.items()}


def test_three_lights_shade_the_sides_that_they_face(lights, tmp_path):
    ball = add_ball()
    paint_white(ball)
    sides = {}
    for name, path in lights.items():
        relight.relight(bpy.context.scene, str(path))
        sides[name] = side(render(ball, tmp_path))
    assert sides["left"] < -0.2
    assert abs(sides["front"]) < 0.03
    assert sides["right"] == pytest.approx(-sides["left"], abs=0.05)


def test_turning_the_light_is_as_good_as_another(lights, tmp_path):
    ball = add_ball()
    paint_white(ball)
    relight.relight(bpy.context.scene, str(lights["left"]))
    left = render(ball, tmp_path)
    # From (-1, -.5) to (1, -.5): counter-clockwise by 180° less twice the angle to the left.
    turn = 180 - 2 * math.degrees(math.atan2(0.5, 1))
    relight.turn_light(bpy.context.scene.world, 1.0, turn)
    turned = render(ball, tmp_path)
    relight.relight(bpy.context.scene, str(lights["right"]))
    right = render(ball, tmp_path)
    assert np.abs(turned - right).mean() < 0.02 < np.abs(turned - left).mean()


def test_the_users_own_world_outlives_saving(lights, tmp_path):
    own = bpy.data.worlds.new("mine")
    bpy.context.scene.world = own
    relight.relight(bpy.context.scene, str(lights["left"]))
    scene_render.save_blend(tmp_path / "x.blend")
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "x.blend"))
    assert "mine" in bpy.data.worlds


def test_a_world_of_the_users_is_not_turned():
    bpy.context.scene.world = bpy.data.worlds.new("mine")
    with pytest.raises(AddonError, match="not lit by this add-on"):
        relight.turn_light(bpy.context.scene.world, 1.0, 90)


def counts() -> dict[str, int]:
    kinds = ("scenes", "objects", "meshes", "worlds", "cameras", "images", "actions")
    found = {kind: len(getattr(bpy.data, kind)) for kind in kinds}
    return found | {"images": found["images"] - ("Render Result" in bpy.data.images)}


@pytest.fixture
def table(lights, monkeypatch):
    """A ball with a light from the left and pictures of 32 pixels."""
    ball = add_ball((1, 2, 3))
    paint_white(ball)
    bpy.context.view_layer.update()
    relight.relight(bpy.context.scene, str(lights["left"]))
    output = relight._output

    def small(made, out, video):
        output(made, out, video)
        made.cycles.use_denoising = False
        made.world.cycles.sampling_method = "MANUAL"
        made.world.cycles.sample_map_resolution = 32

    monkeypatch.setattr(relight, "_output", small)
    return ball


@pytest.mark.parametrize(
    ("turn", "changes"), [("CAMERA", True), ("LIGHT", True), ("OBJECT", False)]
)
def test_a_turntable_is_png_files_of_one_turn_and_leaves_nothing(table, tmp_path, turn, changes):
    """A ball looks the same from all sides: its shading shows what rotates."""
    before = counts()
    out = relight.turntable(table, tmp_path / "turn", frames=4, turn=turn, size=64, samples=4)
    names = sorted(path.name for path in out.iterdir())
    assert names == [f"frame_000{i}.png" for i in (1, 2, 3, 4)]
    sides = [side(read(out / name)) for name in names]
    assert (np.ptp(sides) > 0.3) == changes
    assert counts() == before
    assert sorted(p.name for p in tmp_path.iterdir() if p.name.startswith(".")) == []


def test_a_turntable_is_an_mp4_file(table, tmp_path):
    if not compat.has_video():
        pytest.skip("this build writes no video")
    out = relight.turntable(table, tmp_path / "turn.mp4", frames=3, size=32, samples=1)
    assert out.read_bytes()[4:8] == b"ftyp"
    clip = bpy.data.images.load(str(out))
    assert (clip.source, tuple(clip.size), clip.frame_duration) == ("MOVIE", (32, 32), 3)


def picture_world(path) -> bpy.types.World:
    """A world of the user's: a picture without a Mapping node."""
    world = bpy.data.worlds.new("mine")
    tree = compat.empty_nodes(world)
    nodes = [tree.nodes.new(f"ShaderNode{x}") for x in ("TexEnvironment", "Background")]
    output = tree.nodes.new("ShaderNodeOutputWorld")
    nodes[0].image = bpy.data.images.load(str(path))
    tree.links.new(nodes[0].outputs["Color"], nodes[1].inputs["Color"])
    tree.links.new(nodes[1].outputs["Background"], output.inputs["Surface"])
    return world


@pytest.mark.parametrize("has_world", [True, False])
def test_a_turntable_in_the_default_scene_has_the_studio_light_and_leaves_the_world(has_world):
    bpy.ops.wm.read_factory_settings(use_empty=False)
    scene, cube = bpy.context.scene, bpy.data.objects["Cube"]
    if not has_world:
        bpy.data.worlds.remove(scene.world)
    own, before = scene.world, counts()
    made = relight.turntable_scene(cube, Path("x"), frames=4, turn="LIGHT")
    assert light.environment_image(made.world).name == f"{relight.TABLE} light"
    assert scene.world == own
    relight.remove_turntable_scene(made)
    assert (scene.world, counts()) == (own, before)


def test_a_turntable_is_under_the_users_own_picture_which_stays(table, lights, tmp_path):
    scene = bpy.context.scene
    relight.relight(scene, str(lights["left"]))
    ours = relight.turntable(table, tmp_path / "ours", frames=4, turn="LIGHT", size=64, samples=4)
    scene.world = own = picture_world(lights["left"])
    nodes, before = len(own.node_tree.nodes), counts()
    mine = relight.turntable(table, tmp_path / "mine", frames=4, turn="LIGHT", size=64, samples=4)
    for i in (1, 2, 3, 4):
        name = f"frame_000{i}.png"
        assert side(read(mine / name)) == pytest.approx(side(read(ours / name)), abs=0.02)
    assert (scene.world, len(own.node_tree.nodes), counts()) == (own, nodes, before)


@pytest.mark.parametrize(("turn", "changes"), [("LIGHT", True), ("OBJECT", False)])
def test_the_sun_of_a_sky_turns_too(table, tmp_path, turn, changes):
    bpy.context.scene.world = world = picture_world(next(tmp_path.glob("*.hdr")))
    tree = world.node_tree
    sky = tree.nodes.new("ShaderNodeTexSky")
    sky.sun_elevation, sky.sun_rotation = 0.3, 1.0
    background = next(n for n in tree.nodes if n.bl_idname == "ShaderNodeBackground")
    background.inputs["Strength"].default_value = 0.004
    tree.links.new(sky.outputs["Color"], background.inputs["Color"])
    out = relight.turntable(table, tmp_path / "turn", frames=4, turn=turn, size=64, samples=16)
    sides = [side(read(out / f"frame_000{i}.png")) for i in (1, 2, 3, 4)]
    assert (np.ptp(sides) > 0.3) == changes
    assert changes or np.ptp(sides) < 0.05


@pytest.mark.parametrize("ending", ["complete", "cancelled", "nothing"])
def test_a_turntable_in_a_window_replaces_the_older_one_only_when_it_is_whole(
    table, tmp_path, monkeypatch, ending
):
    out, before = tmp_path / "turn.mp4", counts()
    out.write_bytes(b"older")

    def start(name: str) -> None:
        made = bpy.data.scenes[name]
        if ending != "nothing":
            Path(made.render.filepath).write_bytes(b"newer")
        for handler in bpy.app.handlers.render_complete if ending != "cancelled" else ():
            handler(made)

    states = iter([True, False])
    monkeypatch.setattr(scene_operators, "_start_render", start)
    monkeypatch.setattr(scene_operators, "rendering", lambda: next(states))
    timers = []
    monkeypatch.setattr(bpy.app.timers, "register", lambda go_on, **_: timers.append(go_on))
    monkeypatch.setattr(session, "error", None)
    scene_operators._render_in_window(table, out, frames=2, size=32, samples=1)
    assert out.read_bytes() == b"older"
    assert [timers[0](), timers[0]()] == [0.5, None]
    assert out.read_bytes() == (b"newer" if ending == "complete" else b"older")
    assert bool(session.error) == (ending == "nothing")
    assert (counts(), [p.name for p in tmp_path.glob(".*")]) == (before, [])
    assert not [h for h in bpy.app.handlers.render_complete if "scene_operators" in h.__module__]


@pytest.mark.parametrize(
    ("out", "options", "error", "message"),
    [
        ("x.avi", {}, OutputError, "is not an MP4"),
        ("x", {"frames": 1}, AddonError, "1 frames"),
        ("x", {"turn": "HEAD"}, AddonError, "HEAD"),
    ],
)
def test_a_turntable_that_cannot_be_is_refused(table, tmp_path, out, options, error, message):
    before = counts()
    with pytest.raises(error, match=message):
        relight.turntable(table, tmp_path / out, **options)
    assert counts() == before


def test_the_operator_is_the_function(addon, lights):
    target = bpy.context.scene
    world = relight.relight(target, str(lights["left"]), 2.0, 30.0)
    function = [list(light.light_node(world, "Mapping").inputs["Rotation"].default_value),
                light.light_node(world, "Background").inputs["Strength"].default_value]  # fmt: skip
    assert bpy.ops.fantasia3d.relight(
        light=str(lights["left"]), strength=2.0, rotation=math.radians(30)
    ) == {"FINISHED"}
    world = target.world
    operator = [list(light.light_node(world, "Mapping").inputs["Rotation"].default_value),
                light.light_node(world, "Background").inputs["Strength"].default_value]  # fmt: skip
    np.testing.assert_allclose(np.hstack(operator), np.hstack(function), atol=1e-6)
    with pytest.raises(RuntimeError, match="There is no light 'nowhere'"):
        bpy.ops.fantasia3d.relight(light="nowhere")
    with pytest.raises(LightError):
        relight.relight(target, "nowhere")


def test_a_film_may_have_any_name_and_its_object_may_be_hidden(table, tmp_path):
    """Blender takes # for the number of the frame, and since 4.5 braces for a template."""
    if not compat.has_video():
        pytest.skip("this build writes no video")
    table.hide_render = True
    film = tmp_path / "{films}" / "turn #1.mp4"
    assert relight.turntable(table, film, frames=2, size=32, samples=1).is_file()
    out = relight.turntable(table, tmp_path / "{turn} #2", frames=2, size=32, samples=1)
    assert read(out / "frame_0001.png").std() > 0.02
    assert table.hide_render
