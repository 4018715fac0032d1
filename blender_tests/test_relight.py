"""Relighting and the turntable."""

import math

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.pictures import add_ball, lobe, paint_white, read, render, write_hdr  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.errors import AddonError, LightError, OutputError  # noqa: E402
from fantasia3d_addon.scene import light, relight  # noqa: E402
from fantasia3d_addon.scene import render as scene_render  # noqa: E402

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


@pytest.mark.parametrize(
    ("out", "options", "error", "message"),
    [
        ("x.avi", {}, OutputError, "is no MP4"),
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
