"""Runs inside a real Blender window: types a prompt, clicks Generate, watches, cancels, waits.

``blender --enable-event-simulate --python window_script.py -- OUT ASSET`` with the fake core.
"""

import itertools
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from blender_tests.screen import OUT, ROOT, Screen, play, report, screenshot
from fantasia3d_addon import environment
from fantasia3d_addon.jobs import live_preview, paths
from fantasia3d_addon.jobs.session import session

ASSET = sys.argv[-1]
TYPED, PROMPT = "show", "show a red wooden chair"


def steps(screen: Screen) -> Iterator[float]:
    """What a user does."""
    yield from screen.open_tab()
    settings = bpy.context.scene.fantasia3d
    screenshot("empty")
    yield from screen.type_prompt(TYPED)
    report["prompt"] = settings.prompt
    settings.prompt, settings.negative_prompt = PROMPT, ASSET
    settings.ignore_unknown = True  # of the words that direct the fake core
    yield 1.0
    screenshot("before")
    yield from screen.press_generate(390)
    yield from watch()
    screenshot("running")
    yield from cancel()
    yield 0.5
    screenshot("cancelled")
    settings.prompt = "fail"
    bpy.ops.fantasia3d.generate()
    while session.busy:
        yield 0.1
    report["error"] = session.error
    yield 0.5
    screenshot("error")
    settings.prompt = "a red wooden chair"
    bpy.ops.fantasia3d.generate()
    while session.busy or not session.asset:
        yield 0.1
    report["objects"] = meshes()
    yield from screen.look_at(bpy.data.objects[session.asset])
    screenshot("done")
    bpy.ops.ed.undo()
    report["after_undo"] = meshes()
    bpy.ops.ed.redo()
    report["after_redo"] = meshes()
    yield from quads(screen)


def watch() -> Iterator[float]:
    """Five seconds of the bar and of the shape in the viewport."""
    report["lines"], report["shapes"] = [], []
    for _ in range(10):
        yield 0.5
        report["lines"].append(session.running[0].progress.line)
        shape = live_preview.find(session.running[0].name)
        co = shape.data.vertices[0].co if shape else ()
        report["shapes"].append([round(x, 4) for x in co])


def cancel() -> Iterator[float]:
    """Until the core has answered."""
    asked = time.time()
    session.cancel()
    report["waits_for"] = session.running[0].progress.detail
    while session.running:
        yield 0.05
    report["cancel_seconds"] = session.last.end.time - asked
    report["last"] = session.last.end.type
    report["left"] = [o.name for o in bpy.data.objects if live_preview.RUN in o]


def quads(screen: Screen) -> Iterator[float]:
    """Quads and a thumbnail, each by another Blender, while this one stays responsive."""
    yield from screen.look_at(bpy.data.objects[meshes()[0]])
    beats: list[float] = []
    bpy.app.timers.register(lambda: beats.append(time.thread_time()) or 0.01)
    for _ in range(10):  # what one drawing of the window takes, in software
        for area in screen.window.screen.areas:
            area.tag_redraw()
        yield 0.1
    report["drawing"] = longest(beats)
    beats.clear()
    place = {"window": screen.window, "area": screen.area, "region": screen.region("WINDOW")}
    with bpy.context.temp_override(**place):
        bpy.ops.fantasia3d.quad_remesh("INVOKE_DEFAULT", faces=300, texture_size=64)
    report["quads_at_once"] = meshes()
    while len(meshes()) < 2:
        yield 0.1
    yield 0.5
    screenshot("quads")
    with bpy.context.temp_override(**place):
        made = bpy.context.view_layer.objects.active.name
        bpy.ops.fantasia3d.mark_asset("INVOKE_DEFAULT", tags="chair")
    while not (bpy.data.objects[made].preview and bpy.data.objects[made].preview.image_size[0]):
        yield 0.1
    obj = bpy.data.objects[made]
    sides = sorted({len(polygon.vertices) for polygon in obj.data.polygons})
    report["quads"] = {"name": made, "sides": sides, "tags": len(obj.asset_data.tags)}
    report["quads_hold_up"] = longest(beats)


def longest(beats: list[float]) -> float:
    """The longest time between two beats, CPU seconds."""
    return max(b - a for a, b in itertools.pairwise(beats))


def meshes() -> list[str]:
    return [o.name for o in bpy.data.objects if o.type == "MESH"]


os.environ["FANTASIA3D_PYTHON"] = sys.executable
environment.project_root = lambda: ROOT / "blender_tests" / "fake_core"
paths.Paths.runs = OUT / "runs"
play(steps)
