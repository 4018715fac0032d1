"""The camera, the picture and the saved file."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from bpy_extras.object_utils import world_to_camera_view  # noqa: E402

from blender_tests.pictures import (  # noqa: E402
    add_ball,
    linear,
    paint_white,
    read,
    render,
    set_light,
    shoot,
)
from blender_tests.processes import blender_command  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.errors import AddonError, OutputError  # noqa: E402
from fantasia3d_addon.scene import light  # noqa: E402
from fantasia3d_addon.scene import render as scene_render  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


@pytest.mark.parametrize(
    ("azimuth", "elevation", "place"),
    [(0, 0, (0, -1, 0)), (90, 0, (1, 0, 0)), (180, 30, (0, 0.866, 0.5)), (0, 90, (0, 0, 1))],
)
def test_the_camera_is_where_its_angles_place_it(azimuth, elevation, place):
    ball = add_ball((1, 2, 3))
    bpy.context.view_layer.update()
    camera = scene_render.add_camera(bpy.context.scene, ball, azimuth, elevation)
    bpy.context.view_layer.update()
    back = camera.location - ball.location
    np.testing.assert_allclose(back.normalized(), place, atol=1e-3)
    np.testing.assert_allclose(camera.matrix_world.col[2][:3], place, atol=1e-3)  # looks at it
    assert camera.matrix_world.col[1].z > -1e-6  # upright


@pytest.mark.parametrize("azimuth", [0, 32, 145])
def test_the_whole_object_is_in_the_picture_and_fills_it(asset, azimuth):
    obj = import_asset(bpy.context, asset, (5, 0, -2))
    obj.scale = (0.1, 0.1, 0.1)
    bpy.context.view_layer.update()
    camera = scene_render.add_camera(bpy.context.scene, obj, azimuth)
    bpy.context.view_layer.update()
    points = [obj.matrix_world @ v.co for v in obj.data.vertices]
    seen = np.array([world_to_camera_view(bpy.context.scene, camera, p) for p in points])
    assert seen[:, :2].min() > 0.03
    assert seen[:, :2].max() < 0.97
    assert np.ptp(seen[:, 1]) > 0.7


def test_exposure_shows_white_as_just_white(tmp_path):
    ball = add_ball()
    paint_white(ball)
    for strength in (0.01, 100):
        light.set_world(bpy.context.scene, light.STUDIO_FILE, strength)
        bpy.context.view_layer.update()
        scene_render.add_camera(bpy.context.scene, ball)
        bpy.context.view_layer.update()
        scene_render.expose(bpy.context.scene, ball)
        scene_render.set_up_cycles(bpy.context.scene, 64, 16)
        picture = shoot(ball, tmp_path / "white.png")
        middle = linear(picture[28:36, 28:36])
        assert 0.6 < middle.mean() <= 0.95


def test_two_lights_show_it_differently_and_neither_is_black_or_pink(asset, tmp_path):
    obj = import_asset(bpy.context, asset)
    pictures = []
    for direction in ((-1, -0.4, 0.3), (1, -0.4, 0.3)):
        set_light(tmp_path, direction)
        pictures.append(render(obj, tmp_path, azimuth_deg=32, elevation_deg=16, samples=4))
    for picture in pictures:
        front = picture[20:44, 20:44].reshape(-1, 3)
        assert front.mean() > 0.05
        pink = (front[:, 0] > 0.9) & (front[:, 1] < 0.1) & (front[:, 2] > 0.9)
        assert not pink.any()  # a missing picture
    assert np.abs(pictures[0] - pictures[1]).mean() > 0.05


def test_the_backdrop_is_even_and_shadowed_and_removed_afterwards(asset, tmp_path):
    obj = import_asset(bpy.context, asset)
    set_light(tmp_path, (1, 0, 1), strength=0.5)
    world = bpy.context.scene.world
    before = (len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.worlds))
    picture = render(obj, tmp_path, elevation_deg=25, backdrop=True)
    assert (len(bpy.data.objects) - 1, len(bpy.data.meshes), len(bpy.data.worlds)) == before
    assert bpy.context.scene.world == world
    grey = 1.055 * scene_render.BACKDROP ** (1 / 2.4) - 0.055
    np.testing.assert_allclose(picture[:2], grey, atol=0.01)  # far behind it
    assert picture[50, 4].mean() < grey - 0.1  # its shadow falls to the left
    assert picture[50, 60].mean() > grey - 0.03


def test_saved_and_loaded_by_another_process_it_renders_the_same(asset, tmp_path):
    obj = import_asset(bpy.context, asset)
    set_light(tmp_path, (-0.5, -1, 0.5))
    first = render(obj, tmp_path)
    scene_render.save_blend(tmp_path / "scene.blend")
    (tmp_path / "light.hdr").unlink()
    for path in asset.iterdir():
        path.unlink()  # everything is packed
    code = (
        "import bpy, os, sys\n"
        "from pathlib import Path\n"
        f"bpy.ops.wm.open_mainfile(filepath={str(tmp_path / 'scene.blend')!r})\n"
        "from blender_tests.pictures import shoot\n"
        "obj = next(o for o in bpy.data.objects if o.type == 'MESH')\n"
        f"shoot(obj, Path({str(tmp_path / 'again.png')!r}))\n"
        "sys.stdout.flush(); os._exit(0)"
    )
    subprocess.run(blender_command(code), check=True, capture_output=True)
    np.testing.assert_allclose(read(tmp_path / "again.png"), first, atol=1.5 / 255)


def refer_to(folder: Path) -> tuple[Path, Path]:
    """The open file refers to a picture and to a library, which are made in ``folder``."""
    image, library = folder / "textures" / "a.png", folder / "library" / "b.blend"
    for path in (image, library):
        path.parent.mkdir(parents=True)
    made = bpy.data.images.new("made", 4, 4)
    made.filepath_raw, made.file_format = str(image), "PNG"
    made.save()
    bpy.data.images.remove(made)
    bpy.data.libraries.write(str(library), {bpy.data.objects.new("linked", None)}, fake_user=True)
    bpy.data.images.load(str(image)).use_fake_user = True
    with bpy.data.libraries.load(str(library), link=True) as (_, wanted):
        wanted.objects = ["linked"]
    bpy.context.scene.collection.objects.link(wanted.objects[0])
    return image, library


def paths_in_memory() -> list[str]:
    (image,) = (image for image in bpy.data.images if image.source == "FILE")
    (library,) = bpy.data.libraries
    return [image.filepath, library.filepath]


@pytest.mark.parametrize(
    "place", ["beside.blend", "mine.blend", "../out/a.blend", "deep/er/a.blend"]
)
@pytest.mark.parametrize("is_open", [True, False])
def test_what_a_file_refers_to_is_found_from_where_it_is_saved(tmp_path, place, is_open):
    project = tmp_path / "project"
    files = refer_to(project)
    if is_open:
        bpy.ops.wm.save_as_mainfile(filepath=str(project / "mine.blend"))
        bpy.ops.file.make_paths_relative()
        bpy.ops.wm.save_mainfile()
        assert paths_in_memory() == ["//textures/a.png", "//library/b.blend"]
    before = (bpy.data.filepath, *paths_in_memory())
    scene_render.save_blend(project / place)
    assert (bpy.data.filepath, *paths_in_memory()) == before
    assert not list(tmp_path.rglob(".fantasia3d-*"))
    bpy.ops.wm.open_mainfile(filepath=str((project / place).resolve()))
    found = [Path(bpy.path.abspath(path)) for path in paths_in_memory()]
    assert [path.resolve() for path in found] == list(files)
    assert "linked" in bpy.data.objects and not bpy.data.objects["linked"].is_missing


@pytest.mark.parametrize("name", ["x.png", "x.jpg", "x.exr", "x.webp", "x.TIF", "{x} #1.png"])
def test_a_picture_has_the_format_of_its_name(tmp_path, name):
    set_light(tmp_path, (0, -1, 0))
    ball = add_ball()
    render(ball, tmp_path, size=8, samples=1)
    bpy.context.scene.world.cycles.sample_map_resolution = 16
    scene_render.render_still(tmp_path / name, ball, backdrop=False)
    magic = (tmp_path / name).read_bytes()[:4]
    kinds = {b"\x89PNG": "png", b"\xff\xd8\xff\xe0": "jpg", b"v/1\x01": "exr", b"RIFF": "webp"}
    assert kinds.get(magic, "tif") == name.split(".")[1].lower()
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted(["light.hdr", "picture.png", name])


def test_a_picture_of_no_known_kind_is_refused(tmp_path):
    with pytest.raises(OutputError, match=r"is not a picture.*\.png"):
        scene_render.render_still(tmp_path / "x.doc", add_ball())


@pytest.mark.parametrize(
    "save", [scene_render.save_blend, lambda p: scene_render.render_still(p, add_ball())]
)
def test_a_place_that_cannot_be_written_is_a_sentence(tmp_path, save):
    (tmp_path / "file").touch()
    with pytest.raises(OutputError, match="can't be written"):
        save(tmp_path / "file" / "x.png")


def test_a_failed_save_keeps_the_older_file(tmp_path, monkeypatch):
    path = tmp_path / "scene.blend"
    scene_render.save_blend(path)
    old = path.read_bytes()
    monkeypatch.setattr(scene_render, "_save", lambda path: path.write_bytes(b""))
    with pytest.raises(OutputError, match="wrote nothing"):
        scene_render.save_blend(path)
    assert path.read_bytes() == old
    assert [p.name for p in tmp_path.iterdir()] == ["scene.blend"]


def test_without_cycles_there_is_a_sentence(monkeypatch):
    monkeypatch.setattr(compat, "has_cycles", lambda: False)
    with pytest.raises(AddonError, match=r"has no Cycles\. Enable"):
        scene_render.set_up_cycles(bpy.context.scene)


def test_colours_are_shown_as_they_are():
    scene_render.set_up_cycles(bpy.context.scene)
    assert bpy.context.scene.view_settings.view_transform == "Standard"
    assert bpy.context.scene.cycles.use_denoising == compat.has_denoiser()


def test_samples_that_are_asked_for_get_the_better_denoiser():
    if not compat.has_denoiser():
        pytest.skip("this build has no denoiser")
    cycles = bpy.context.scene.cycles
    scene_render.set_up_cycles(bpy.context.scene)
    assert (cycles.samples, cycles.denoising_quality) == (24, "BALANCED")
    scene_render.set_up_cycles(bpy.context.scene, samples=96)
    assert (cycles.samples, cycles.denoising_quality) == (96, "HIGH")
