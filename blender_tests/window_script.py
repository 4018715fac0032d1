"""Runs inside a real Blender window: types a prompt, clicks Generate, watches, cancels, waits.

``blender --enable-event-simulate --python window_script.py -- OUT ASSET`` with the fake core. It
writes OUT/report.json and takes screenshots with ImageMagick's ``import`` (Blender's own are black
under Xvfb).
"""

import json
import os
import shutil
import subprocess
import sys
import time
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path

import bpy

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import fantasia3d_addon  # noqa: E402
from fantasia3d_addon import environment, live_preview, preferences  # noqa: E402
from fantasia3d_addon.layout import TAB  # noqa: E402
from fantasia3d_addon.session import session  # noqa: E402

OUT, ASSET = (Path(word) for word in sys.argv[sys.argv.index("--") + 1 :])
TYPED, PROMPT = "show", "show a red wooden chair"
ROW = 8  # pixels between two tries of a click
report: dict[str, object] = {"lines": [], "ticks": [], "shapes": []}


def screenshot(name: str) -> None:
    tools = ("import", "import-im7.q16", "import-im6.q16")  # Debian's, without its alternatives
    tool = next(filter(None, map(shutil.which, tools)))
    subprocess.run([tool, "-window", "root", str(OUT / f"{name}.png")], check=True)


class Screen:
    """The 3D view's sidebar, as a user has it before her eyes."""

    def __init__(self) -> None:
        self.window = bpy.context.window_manager.windows[0]
        self.area = next(a for a in self.window.screen.areas if a.type == "VIEW_3D")

    def region(self, kind: str) -> bpy.types.Region:
        return next(r for r in self.area.regions if r.type == kind)

    def open_tab(self) -> Iterator[float]:
        self.area.spaces.active.show_region_ui = True
        yield 0.5
        self.region("UI").active_panel_category = TAB
        yield 0.7
        with bpy.context.temp_override(
            window=self.window, area=self.area, region=self.region("UI")
        ):
            bpy.context.region.tag_redraw()
        yield 1.0

    def click(self, x: int, y: int) -> Iterator[float]:
        for kind, value in (
            ("MOUSEMOVE", "NOTHING"),
            ("LEFTMOUSE", "PRESS"),
            ("LEFTMOUSE", "RELEASE"),
        ):
            self.window.event_simulate(type=kind, value=value, x=x, y=y)
            yield 0.12

    def key(self, kind: str, letter: str = "") -> Iterator[float]:
        x, y = self.area.x + 5, self.area.y + 5
        more = {"unicode": letter} if letter else {}
        self.window.event_simulate(type=kind, value="PRESS", x=x, y=y, **more)
        yield 0.02
        self.window.event_simulate(type=kind, value="RELEASE", x=x, y=y)
        yield 0.02

    def find(self, first: int, last: int, hit: Callable[[], bool]) -> Iterator[float]:
        """Click ``first`` to ``last`` pixels below the sidebar's top, until ``hit``."""
        region = self.region("UI")
        x = region.x + region.width // 2 - 10
        for below in range(first, last, ROW):
            yield from self.click(x, region.y + region.height - below)
            if hit():
                report.setdefault("found", []).append(below)
                return


def type_prompt(screen: Screen) -> Iterator[float]:
    """Click into the prompt's field and write; a field that is no text field takes nothing."""
    settings = bpy.context.scene.fantasia3d
    region = screen.region("UI")
    x = region.x + region.width // 2 - 10
    for below in range(68, 110, 8):
        yield from screen.click(x, region.y + region.height - below)
        for letter in TYPED:
            yield from screen.key(letter.upper(), letter)
        yield from screen.key("RET")
        yield 0.1
        if settings.prompt == TYPED:
            report["typed"] = below
            return
        yield from screen.key("ESC")


def steps() -> Iterator[float]:
    """What a user does; each yield is a wait in seconds, so that Blender draws in between."""
    screen = Screen()
    yield from screen.open_tab()
    settings = bpy.context.scene.fantasia3d
    screenshot("empty")
    yield from type_prompt(screen)
    report["prompt"] = settings.prompt
    settings.prompt, settings.negative_prompt = PROMPT, str(ASSET)
    yield 1.0
    screenshot("before")
    yield from screen.find(290, 330, lambda: bool(session.running))
    report["clicked"] = bool(session.running)
    if not session.running:
        bpy.ops.fantasia3d.generate()
    for _ in range(10):
        yield 0.5
        report["lines"].append(session.running[0].progress.line)
        shape = live_preview.find(session.running[0].name)
        co = shape.data.vertices[0].co if shape else ()
        report["shapes"].append([round(x, 4) for x in co])
    screenshot("running")
    asked = time.time()
    session.cancel()
    report["waits_for"] = session.running[0].progress.detail
    while session.running:
        yield 0.05
    report["cancel_seconds"] = session.last.end.time - asked
    report["last"] = session.last.end.type
    report["left"] = [o.name for o in bpy.data.objects if live_preview.RUN in o]
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
    report["objects"] = [o.name for o in bpy.data.objects if o.type == "MESH"]
    yield from look_at(screen, bpy.data.objects[session.asset])
    screenshot("done")
    bpy.ops.ed.undo()
    report["after_undo"] = [o.name for o in bpy.data.objects if o.type == "MESH"]
    bpy.ops.ed.redo()
    report["after_redo"] = [o.name for o in bpy.data.objects if o.type == "MESH"]


def look_at(screen: Screen, obj: bpy.types.Object) -> Iterator[float]:
    with bpy.context.temp_override(window=screen.window, area=screen.area):
        bpy.context.view_layer.objects.active = obj
        obj.select_set(True)
        screen.area.spaces.active.shading.color_type = "TEXTURE"
        with bpy.context.temp_override(region=screen.region("WINDOW")):
            bpy.ops.view3d.view_selected()
    yield 3.0


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
        busy, begin, cpu = bool(session.running), time.perf_counter(), time.thread_time()
        try:
            return tick()
        finally:
            seconds = time.perf_counter() - begin, time.thread_time() - cpu
            report["ticks"].append((busy, *seconds))

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
