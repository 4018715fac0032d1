"""Runs inside a real Blender window: opens the panel, presses Generate, waits for the asset.

``blender --python window_script.py -- OUT ASSET`` with the fake core. It writes OUT/report.json and
takes screenshots with ImageMagick's ``import`` (Blender's own are black under Xvfb).
"""

import json
import os
import shutil
import subprocess
import sys
import time
import traceback
from collections.abc import Iterator
from pathlib import Path

import bpy

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import fantasia3d_addon  # noqa: E402
from fantasia3d_addon import environment, preferences  # noqa: E402
from fantasia3d_addon.panel import TAB  # noqa: E402
from fantasia3d_addon.session import session  # noqa: E402

OUT, ASSET = (Path(word) for word in sys.argv[sys.argv.index("--") + 1 :])
report: dict[str, object] = {"lines": [], "ticks": []}


def screenshot(name: str) -> None:
    tools = ("import", "import-im7.q16", "import-im6.q16")  # Debian's, without its alternatives
    tool = next(filter(None, map(shutil.which, tools)))
    subprocess.run([tool, "-window", "root", str(OUT / f"{name}.png")], check=True)


def steps() -> Iterator[float]:
    """What a user does; each yield is a wait in seconds, so that Blender draws in between."""
    window = bpy.context.window_manager.windows[0]
    area = next(a for a in window.screen.areas if a.type == "VIEW_3D")
    area.spaces.active.show_region_ui = True
    yield 0.5
    region = next(r for r in area.regions if r.type == "UI")
    region.active_panel_category = TAB
    yield 0.7
    region.tag_redraw()
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.negative_prompt = "long", str(ASSET)
    yield 2.0
    screenshot("before")
    with bpy.context.temp_override(window=window, area=area, region=region):
        report["generate"] = list(bpy.ops.fantasia3d.generate())
    for _ in range(6):
        yield 0.3
        report["lines"].append(session.progress.line)
    screenshot("running")
    with bpy.context.temp_override(window=window, area=area, region=region):
        report["cancel"] = list(bpy.ops.fantasia3d.cancel())
    while session.busy:
        yield 0.1
    report["last"] = session.run.last.type
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
    report["objects"] = [o.name for o in bpy.data.objects if o.type == "MESH"]
    with bpy.context.temp_override(window=window, area=area):
        bpy.context.view_layer.objects.active = bpy.data.objects[session.asset]
        bpy.data.objects[session.asset].select_set(True)
        area.spaces.active.shading.color_type = "TEXTURE"
        region = next(r for r in area.regions if r.type == "WINDOW")
        with bpy.context.temp_override(region=region):
            bpy.ops.view3d.view_selected()
    yield 3.0
    screenshot("done")
    bpy.ops.ed.undo()
    report["after_undo"] = [o.name for o in bpy.data.objects if o.type == "MESH"]


def main() -> None:
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.view.show_tooltips = False
    os.environ["FANTASIA3D_PYTHON"] = sys.executable
    environment.project_root = lambda: ROOT / "blender_tests" / "fake_core"
    preferences.Machine.runs = OUT / "runs"
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    bpy.ops.ed.undo_push(message="Empty")
    fantasia3d_addon.register()
    tick = session._timer

    def timed() -> float | None:
        begin = time.thread_time()  # another process's turn is not ours
        try:
            return tick()
        finally:
            report["ticks"].append((session.run.last is None, time.thread_time() - begin))

    session._timer = timed
    todo = steps()

    def walk() -> float | None:
        try:
            return next(todo)
        except StopIteration:
            leave()
        except BaseException:
            report["traceback"] = traceback.format_exc()
            leave()

    def leave() -> None:
        (OUT / "report.json").write_text(json.dumps(report), encoding="utf-8")
        os._exit(0)

    bpy.app.timers.register(walk, first_interval=2.0)


main()
