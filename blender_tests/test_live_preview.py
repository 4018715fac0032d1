"""The shape that grows in the viewport, and the pictures of the panel."""

from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import block, write_png  # noqa: E402
from fantasia3d_addon.jobs import live_preview  # noqa: E402
from fantasia3d_addon.jobs.process import Run  # noqa: E402
from fantasia3d_addon.jobs.progress import FollowedRun  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.jobs.target import Target  # noqa: E402
from fantasia3d_addon.ui import icons  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def write_shape(path: Path, scale: float = 1.0, n: int = 8) -> np.ndarray:
    """In training units: about the origin."""
    verts, faces, _, _ = block(n)
    verts = (verts - verts.mean(0)) * (1, 1, scale)
    np.savez(path, verts=verts.astype(np.float32), faces=faces.astype(np.int32))
    return verts


def show(path: Path, location=(1, 2, 3)) -> bpy.types.Object | None:
    """As the session shows it for a run whose folder's name is "run"."""
    folder = path.parent / "run"
    folder.mkdir(exist_ok=True)
    (folder / "job.json").write_text('{"prompt": "a red chair"}')
    followed = FollowedRun(Run.attach(folder), Target(location=location), None, 0)
    return live_preview.show(bpy.context.scene, path, followed)


def test_it_is_where_the_asset_will_be_and_is_updated_in_place(addon, tmp_path):
    path = tmp_path / "shape.npz"
    write_shape(path)
    obj = show(path)
    mesh = obj.data
    for scale in (0.5, 2.0):
        verts = write_shape(path, scale, n=6)
        assert show(path) == obj
        assert (obj.data, len(bpy.data.meshes), len(bpy.data.objects)) == (mesh, 1, 1)
        co = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", co)
        low, high = co.reshape(-1, 3).min(0), co.reshape(-1, 3).max(0)
        assert low[2] == pytest.approx(0, abs=1e-6)
        np.testing.assert_allclose((low + high)[:2], 0, atol=1e-6)
        assert (high - low).max() == pytest.approx(1, abs=1e-6)
        extent = verts.max(0) - verts.min(0)
        np.testing.assert_allclose(high - low, extent / extent.max(), atol=1e-5)
    assert tuple(obj.location) == (1, 2, 3)
    assert obj.name == "a red chair (preview)"
    assert obj.hide_select
    assert obj.hide_render
    assert not mesh.validate()


def test_a_box_has_sharp_edges_and_a_bent_surface_is_smooth(addon, tmp_path):
    """The normals that run over a box's edges make it look inflated."""
    path = tmp_path / "shape.npz"
    verts = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    faces = np.array(quads, np.int32)[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    for _ in range(2):  # when it is filled again, too
        np.savez(path, verts=verts, faces=faces)
        assert corners_off_their_faces(show(path).data) == pytest.approx(0, abs=1e-5)
    write_shape(path)
    assert corners_off_their_faces(show(path).data) > 0.1


def corners_off_their_faces(mesh: bpy.types.Mesh) -> float:
    """The largest distance between a corner's normal and its face's."""
    corners = np.array([corner.vector[:] for corner in mesh.corner_normals])
    faces = np.repeat([face.normal[:] for face in mesh.polygons], 3, 0)
    return float(np.linalg.norm(corners - faces, axis=1).max())


def test_a_file_that_is_being_replaced_is_passed_over(addon, tmp_path):
    path = tmp_path / "shape.npz"
    assert show(path) is None
    path.write_bytes(b"PK\x03\x04 half a file")
    assert show(path) is None
    np.savez(path, verts=np.zeros((0, 3), np.float32), faces=np.zeros((0, 3), np.int32))
    assert show(path) is None
    write_shape(path)
    with np.load(path) as parts:
        whole = dict(parts)
    for size in (np.nan, np.inf, -1.0):
        np.savez(path, size_m=size, **whole)
        assert show(path) is None
    assert not bpy.data.objects


def test_it_is_not_in_a_saved_file_and_is_shown_again(addon, tmp_path):
    write_shape(tmp_path / "shape.npz")
    show(tmp_path / "shape.npz")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "a.blend"))
    assert not bpy.data.objects
    assert not bpy.data.meshes
    assert show(tmp_path / "shape.npz")


def test_undo_restores_no_preview_of_an_ended_run(addon, tmp_path):
    bpy.ops.ed.undo_push(message="before")
    write_shape(tmp_path / "shape.npz")
    show(tmp_path / "shape.npz")
    bpy.data.objects.new("the user's", None)
    bpy.ops.ed.undo_push(message="something of the user's")
    live_preview.remove()
    bpy.ops.ed.undo_push(message="the asset")
    bpy.ops.ed.undo()
    assert "the user's" in bpy.data.objects
    assert live_preview.find("run") is None


def test_a_run_shows_its_shape_until_its_end(ready, wait):
    ready.prompt = "show"
    bpy.context.scene.cursor.location = (0, 0, 1)
    bpy.ops.fantasia3d.generate()
    name = session.running[0].name
    wait(until=lambda: live_preview.find(name) is not None)
    obj = live_preview.find(name)
    assert tuple(obj.location) == (0, 0, 1)
    first = [tuple(v.co) for v in obj.data.vertices]
    wait(until=lambda: [tuple(v.co) for v in obj.data.vertices] != first)
    assert session.running[0].picture.name == "normals.png"
    session.cancel()
    wait()
    assert not bpy.data.objects
    assert not bpy.data.meshes


def test_twenty_thousand_faces_are_taken_in_within_a_tick(addon, tmp_path):
    import time

    write_shape(tmp_path / "shape.npz", n=40)  # 19,200 faces
    show(tmp_path / "shape.npz")
    seconds = []
    for _ in range(5):
        begin = time.thread_time()
        show(tmp_path / "shape.npz")
        seconds.append(time.thread_time() - begin)
    assert min(seconds) < 0.05


def test_a_picture_is_read_again_when_it_changes(addon, tmp_path):
    import os

    path, pictures = tmp_path / "a.png", icons._collections[0]

    def looked() -> list[str]:
        icons.icon((path,))
        icons.look()
        return list(pictures)

    assert looked() == []
    write_png(path, np.zeros((8, 8, 3), np.uint8))
    os.utime(path, (1, 1))
    (first,) = looked()
    assert looked() == [first]
    os.utime(path, (2, 2))
    (second,) = looked()
    assert first != second


def test_every_light_has_its_picture(addon):
    from fantasia3d_addon.scene import light

    for name in ("neutral", *light.blender_lights()):
        path = icons.LIGHTS / f"{name}.png"
        assert path.is_file(), "run python -m blender_tests.light_icons"
