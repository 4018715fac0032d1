"""Candidates in Blender, with a fake core: explored, shown, chosen, discarded."""

import dataclasses

import pytest

bpy = pytest.importorskip("bpy")

from mathutils import Vector  # noqa: E402

from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.jobs import candidates, history, live_preview, submit  # noqa: E402
from fantasia3d_addon.jobs.paths import Paths  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.ui import candidates as panel  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


class Layout:
    """A layout that keeps what is drawn on it."""

    def __init__(self, drawn: list) -> None:
        self.drawn = drawn

    def operator(self, name: str, text: str = "", **_more: object) -> "Layout":
        self.drawn.append((name, text))
        return self

    def label(self, text: str = "", **_more: object) -> None:
        self.drawn.append(("label", text))

    def template_icon(self, icon: int, **_more: object) -> None:
        self.drawn.append(("picture", icon))

    def inner(self, *_args: object, **_more: object) -> "Layout":
        return self

    row = column = box = grid_flow = inner


def drawn() -> list:
    found: list = []
    panel.draw_candidates(Layout(found))
    return found


def explored(wait, count: int = 3) -> list[history.Entry]:
    """The candidates after Explore, in their order."""
    bpy.context.scene.fantasia3d.candidates = count
    assert bpy.ops.fantasia3d.explore() == {"FINISHED"}
    wait()
    return session.history and history.open_candidates(session.history)


def test_candidates_are_next_to_each_other_and_in_the_panel(ready, wait):
    ready.seed = 7
    entries = explored(wait)
    assert [entry.job["seed"] for entry in entries] == [7, 8, 9]
    assert {entry.state for entry in entries} == {history.PAUSED}
    assert session.error is None
    boxes = []  # x and y, lowest and highest
    for entry in entries:
        obj = live_preview.find(entry.folder.name)
        bpy.context.view_layer.update()
        corners = [obj.matrix_world @ Vector(corner) for corner in obj.bound_box]
        low, high = corners[0], corners[6]
        boxes.append((low.x, high.x, low.y, high.y))
    for i, a in enumerate(boxes):
        for b in boxes[:i]:
            apart = a[1] <= b[0] or b[1] <= a[0] or a[3] <= b[2] or b[3] <= a[2]
            assert apart, boxes
    there = [[path.name for path in entry.pictures if path.is_file()] for entry in entries]
    assert there == [["normals.png"]] * 3
    shown = drawn()
    assert shown.count(("fantasia3d.finish_candidate", "Finish This One")) == 3
    assert ("fantasia3d.discard_candidates", "Discard All") in shown


def test_the_chosen_one_is_finished_in_its_place_and_the_others_go(ready, wait):
    entries = explored(wait)
    chosen = entries[1]
    place = tuple(live_preview.find(chosen.folder.name).location)
    assert bpy.ops.fantasia3d.finish_candidate(folder=str(chosen.folder)) == {"FINISHED"}
    wait()
    assert (chosen.folder / "asset").is_dir()
    finished = bpy.data.objects[session.asset]
    assert tuple(finished.location)[2] == place[2]
    others = [entry for entry in entries if entry.folder != chosen.folder]
    assert all(live_preview.find(entry.folder.name) for entry in others)
    assert ("fantasia3d.discard_candidates", "Discard Others") in drawn()
    assert bpy.ops.fantasia3d.discard_candidates() == {"FINISHED"}
    wait(until=lambda: len(session.history) == 1 and not drawn())
    assert chosen.folder.is_dir()
    assert not any(entry.folder.exists() for entry in others)
    assert list(bpy.data.objects) == [finished]
    assert drawn() == []


def test_previews_of_candidates_are_not_saved_and_come_back(ready, wait, tmp_path):
    entries = explored(wait, count=2)
    places = [tuple(live_preview.find(e.folder.name).location) for e in entries]
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"), copy=True)
    assert [tuple(live_preview.find(e.folder.name).location) for e in entries] == places
    with bpy.data.libraries.load(str(tmp_path / "scene.blend")) as (saved, _):
        assert saved.objects == []


def test_undo_does_not_remove_the_previews_of_candidates(ready, wait):
    bpy.ops.ed.undo_push(message="before")
    entries = explored(wait, count=2)
    places = [tuple(live_preview.find(e.folder.name).location) for e in entries]
    bpy.data.objects.new("the user's", None)
    bpy.ops.ed.undo_push(message="something of the user's")
    for step in (bpy.ops.ed.undo, bpy.ops.ed.redo):
        step()
        assert [tuple(live_preview.find(e.folder.name).location) for e in entries] == places
    assert "the user's" in bpy.data.objects


def test_a_waiting_candidate_that_is_discarded_never_runs(ready, wait):
    ready.prompt = "long"
    ready.candidates = 3
    bpy.ops.fantasia3d.explore()
    wait(until=lambda: session.running and session.running[0].progress.fraction > 0)
    submit.discard([e for e in history.scan(Paths(bpy.context).runs) if e.candidate.is_open])
    assert session.waiting == []
    wait()
    (entry,) = history.scan(Paths(bpy.context).runs)
    assert (entry.state, entry.candidate) == (history.CANCELLED, candidates.Candidate())


def test_materials_are_explored_on_a_finished_shape(ready, wait):
    bpy.ops.fantasia3d.generate()
    wait()
    (entry,) = history.scan(Paths(bpy.context).runs)
    cancelled = dataclasses.replace(entry, state=history.CANCELLED)
    assert submit.reason_against_recolor(cancelled).startswith("Its shape is not")
    # As after a batch: to resume it would train it all again.
    with pytest.raises(AddonError, match=r"Its shape was not kept\. Repeat it"):
        submit.recolor(bpy.context, entry)
    (entry.folder / "checkpoint").mkdir()
    (entry.folder / "checkpoint" / "mesh.safetensors").write_bytes(b"the shape")
    ready.candidates = 2
    assert bpy.ops.fantasia3d.recolor(folder=str(entry.folder)) == {"FINISHED"}
    wait()
    found = history.open_candidates(history.scan(Paths(bpy.context).runs))
    assert [e.job["color_seed"] for e in found] == [2, 3]
    assert {e.job["seed"] for e in found} == {entry.job["seed"]}
    for e in found:
        assert e.candidate.until == candidates.COLOR
        assert (e.folder / "checkpoint" / "mesh.safetensors").read_bytes() == b"the shape"


def test_there_is_nothing_to_discard_without_candidates(ready):
    assert not bpy.ops.fantasia3d.discard_candidates.poll()
    assert drawn() == []


def test_a_broken_file_is_no_candidate(tmp_path):
    for text in ("", "[]", '{"group": 3}', '{"group": "a", "until": "night"}'):
        (tmp_path / candidates.NAME).write_text(text)
        assert candidates.read(tmp_path) == candidates.Candidate()
