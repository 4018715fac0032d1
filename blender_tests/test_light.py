"""The world's light: its direction, its brightness, and what a name means."""

import math
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.pictures import (  # noqa: E402
    add_ball,
    linear,
    lobe,
    paint_white,
    render,
    set_light,
    write_hdr,
)
from fantasia3d_addon.errors import LightError  # noqa: E402
from fantasia3d_addon.scene import light  # noqa: E402
from fantasia3d_addon.scene import render as render_settings  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def brightest(picture: np.ndarray) -> tuple[float, float]:
    """Where the middle of the light on a ball is: to the right and up, from -1 to 1."""
    shine = picture.mean(-1) ** 4
    y, x = np.mgrid[1:-1:64j, -1:1:64j]
    return (shine * x).sum() / shine.sum(), (shine * y).sum() / shine.sum()


@pytest.mark.parametrize(
    ("direction", "rotation_deg", "x", "y"),
    [
        ((1, -0.5, 0), 0, 0.4, 0.0),
        ((-1, -0.5, 0), 0, -0.4, 0.0),
        ((0, -0.5, 1), 0, 0.0, 0.4),
        ((-0.5, -1, 0), 45, 0.2, 0.0),  # counter-clockwise seen from above: from left to right
    ],
)
def test_the_light_is_where_its_picture_has_it(tmp_path, direction, rotation_deg, x, y):
    set_light(tmp_path, direction, rotation_deg=rotation_deg)
    found = brightest(render(add_ball(), tmp_path))
    assert found == pytest.approx((x, y), abs=0.12)


def test_strength_is_linear(tmp_path):
    ball = add_ball()
    set_light(tmp_path, (0, -1, 0), strength=0.1)
    once = render(ball, tmp_path, samples=32)
    set_light(tmp_path, (0, -1, 0), strength=0.2)
    twice = render(ball, tmp_path, samples=32)
    ratio = linear(twice[32, 32]) / linear(once[32, 32])
    np.testing.assert_allclose(ratio, 2, rtol=0.05)


def test_irradiance_in_closed_form(tmp_path):
    half = np.zeros((64, 128, 3))
    half[:32] = 1.0  # the upper half of the sky
    image = bpy.data.images.load(str(write_hdr(tmp_path / "half.hdr", half)))
    for normal, value in (((0, 0, 1), 1), ((0, 0, -1), 0), ((1, 0, 0), 0.5), ((0.6, 0, 0.8), 0.9)):
        assert light.irradiance(image, normal) == pytest.approx(value, abs=0.01)


def test_irradiance_agrees_with_cycles(tmp_path):
    """A white matt ball shows it in its middle."""
    image = bpy.data.images.load(str(write_hdr(tmp_path / "x.hdr", 0.2 * lobe((0.5, -1, 0.3)))))
    expected = light.irradiance(image, (0, -1, 0))
    light.set_world(bpy.context.scene, tmp_path / "x.hdr")
    ball = add_ball()
    paint_white(ball)
    picture = render(ball, tmp_path, samples=64)[30:34, 30:34].mean()
    assert linear(picture) == pytest.approx(expected, rel=0.05)


def test_names_and_files(tmp_path):
    path = write_hdr(tmp_path / "my light.hdr", lobe((0, 0, 1)))
    assert light.light_file(str(path)) == path.resolve()
    city = light.light_file("blender:city")
    assert city == light.light_file("city")
    assert city.name == "city.exr"
    assert light.light_file("studio") == Path(light.__file__).with_name("studio.exr")
    assert light.light_file("blender:studio") != light.light_file("studio")


@pytest.mark.parametrize("name", ["", "nowhere", "blender:nowhere", "/no/such.hdr"])
def test_a_light_that_is_not_there_is_refused_with_those_that_are(name):
    with pytest.raises(LightError, match=r"There is no light .*studio, city"):
        light.light_file(name)


def test_a_file_that_is_no_picture_leaves_nothing(tmp_path):
    (tmp_path / "light.exr").write_text("no picture")
    with pytest.raises(LightError, match="is not a picture"):
        light.set_world(bpy.context.scene, tmp_path / "light.exr")
    assert not bpy.data.images
    assert not bpy.data.worlds


def test_the_light_travels_with_the_file(tmp_path):
    set_light(tmp_path, (0, 0, 1))
    assert light.environment_image(bpy.context.scene.world).packed_file


@pytest.mark.parametrize(
    ("name", "given"), [("studio", ("MANUAL", 1024)), ("city", ("AUTOMATIC",))]
)
def test_the_map_of_bright_places_is_no_finer_than_the_picture_needs(name, given):
    """Cycles' own is 4096 wide for any picture, 1 s of a core for each frame. ``city``, of 1024,
    has a sun, which takes all of it."""
    light.set_world(bpy.context.scene, light.light_file(name))
    cycles = bpy.context.scene.world.cycles
    assert (cycles.sampling_method, cycles.sample_map_resolution)[: len(given)] == given


def test_a_new_light_takes_the_place_of_the_old(tmp_path):
    own = bpy.data.worlds.new("the user's own")
    bpy.context.scene.world = own
    set_light(tmp_path, (0, 0, 1))
    set_light(tmp_path, (1, 0, 0))
    assert len(bpy.data.images) == 1
    assert own in bpy.data.worlds.values()
    assert len(bpy.data.worlds) == 2


def test_the_studio_is_the_cores():
    """If it differs: run.py python -c "from core.io.exr import write_exr;
    from core.appearance.lights import studio;
    write_exr('fantasia3d_addon/scene/studio.exr', studio(128))".
    """
    pytest.importorskip("torch")
    from core.appearance.lights import studio

    image = bpy.data.images.load(str(light.STUDIO_FILE))
    pixels = np.empty(128 * 256 * 4, np.float32)
    image.pixels.foreach_get(pixels)
    shipped = pixels.reshape(128, 256, 4)[::-1, :, :3]
    np.testing.assert_allclose(shipped, studio(128).numpy(), atol=1e-5)


def test_of_blenders_lights_the_sunset_alone_is_an_evening():
    def glow(path):
        return light.glow_of(bpy.data.images.load(str(path)))

    evenings = {name for name, path in light.blender_lights().items() if glow(path)}
    assert evenings == {"sunset"} and glow(light.STUDIO_FILE) is None
    found = glow(light.blender_lights()["sunset"])
    assert found.horizon[0] > 3 * found.horizon[2] and found.sky[2] > found.sky[0]


def test_a_sunsets_sun_stands_to_the_side_and_other_lights_stay():
    scene = bpy.context.scene
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.location, camera.rotation_euler = (0, -3, 0), (math.pi / 2, 0, 0)
    scene.camera = camera
    for name, turned in (("sunset", True), ("city", False)):
        light.set_world(scene, light.light_file(name))
        render_settings.turn_low_sun(scene)
        turn = -light.light_node(scene.world, "Mapping").inputs["Rotation"].default_value[2]
        assert (abs(turn) > 1e-3) == turned
        if turned:  # the camera is at -Y, that is -90 degrees
            sun = light.glow_of(light.environment_image(scene.world)).azimuth + turn
            assert math.degrees(sun) == pytest.approx(-90 + 75, abs=1)


@pytest.mark.parametrize("what", ["node", "picture"])
def test_a_light_without_its_picture_is_replaced(tmp_path, what):
    world = set_light(tmp_path, (0, 0, 1)) or bpy.context.scene.world
    if what == "node":
        world.node_tree.nodes.remove(light.light_node(world, "TexEnvironment"))
    else:
        bpy.data.images.remove(light.environment_image(world))
    set_light(tmp_path, (1, 0, 0))
    assert light.environment_image(bpy.context.scene.world)
    assert len(bpy.data.worlds) == 1
