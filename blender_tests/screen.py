"""A real Blender window as a user has it: the sidebar, the mouse, the keyboard, and a clock.

For scripts that Blender runs (``blender --enable-event-simulate --python SCRIPT -- OUT …``). A
script is a generator of what a user does; each yield is a wait in seconds, in which Blender draws.
Screenshots are ImageMagick's: Blender's own are black under Xvfb.
"""

import contextlib
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
from fantasia3d_addon.jobs import submit  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.ui.registration import CLASSES  # noqa: E402
from fantasia3d_addon.ui.text import TAB  # noqa: E402

ROW = 8  # pixels between two tries of a click
BEAT = 0.005  # seconds between two beats of the clock that sees the main loop held up
report: dict = {"ticks": [], "draws": [], "gaps": []}
OUT = Path(sys.argv[sys.argv.index("--") + 1])


def screenshot(name: str) -> None:
    """The whole screen as OUT/name.png."""
    tools = ("import", "import-im7.q16", "import-im6.q16")  # Debian's, without its alternatives
    tool = next(filter(None, map(shutil.which, tools)))
    subprocess.run([tool, "-window", "root", str(OUT / f"{name}.png")], check=True)


class Screen:
    """The first window's 3D view and its sidebar."""

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
        self.region("UI").tag_redraw()
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

    def type(self, text: str) -> Iterator[float]:
        for letter in text:
            kind = "SPACE" if letter == " " else letter.upper()
            yield from self.key(kind, letter)

    def find(self, first: int, last: int, hit: Callable[[], bool]) -> Iterator[float]:
        """Click ``first`` to ``last`` pixels below the sidebar's top, until ``hit``."""
        region = self.region("UI")
        x = region.x + region.width // 2 - 10
        for below in range(first, last, ROW):
            yield from self.click(x, region.y + region.height - below)
            if hit():
                report.setdefault("found", []).append(below)
                return

    def type_prompt(self, text: str) -> Iterator[float]:
        """Click into the prompt's field and write; other fields ignore the text."""
        settings = bpy.context.scene.fantasia3d
        region = self.region("UI")
        x = region.x + region.width // 2 - 10
        for below in range(68, 110, ROW):
            yield from self.click(x, region.y + region.height - below)
            yield from self.type(text)
            yield from self.key("RET")
            yield 0.1
            if settings.prompt == text:
                report["typed"] = below
                return
            yield from self.key("ESC")

    def press_generate(self, below: int) -> Iterator[float]:
        """Click where the button is, ``below`` pixels from the sidebar's top; call the operator
        where none was hit."""
        while submit.report_of(bpy.context.scene.fantasia3d) is None:  # which takes a row above
            yield 0.1
        yield 0.6
        yield from self.find(below, below + 40, lambda: bool(session.running))
        report["clicked"] = bool(session.running)
        if not session.running:
            bpy.ops.fantasia3d.generate()

    def look_at(self, obj: bpy.types.Object) -> Iterator[float]:
        with bpy.context.temp_override(window=self.window, area=self.area):
            bpy.context.view_layer.objects.active = obj
            obj.select_set(True)
            self.area.spaces.active.shading.color_type = "TEXTURE"
            with bpy.context.temp_override(region=self.region("WINDOW")):
                bpy.ops.view3d.view_selected()
        yield 3.0


@contextlib.contextmanager
def clock(into: list, *labels: object) -> Iterator[None]:
    """Append the labels and the seconds that the block takes: wall time, and this thread's."""
    wall, cpu = time.perf_counter(), time.thread_time()
    try:
        yield
    finally:
        into.append([*labels, time.perf_counter() - wall, time.thread_time() - cpu])


def time_ticks_and_draws() -> None:
    """Have every tick of the session and every drawing of its panels timed."""
    tick = session._timer

    def timed_tick() -> float | None:
        with clock(report["ticks"], bool(session.running), bool(session.importing)):
            return tick()

    session._timer = timed_tick
    for cls in CLASSES:
        if issubclass(cls, bpy.types.Panel) and "draw" in vars(cls):
            cls.draw = timed_draw(cls.__name__, cls.draw)


def timed_draw(name: str, draw: Callable) -> Callable:
    def timed(panel: bpy.types.Panel, context: bpy.types.Context) -> None:
        with clock(report["draws"], name):
            draw(panel, context)

    return timed


def beat() -> None:
    """See how long the main loop's thread works from one beat to the next, its drawing included."""
    wall, cpu = time.perf_counter(), time.thread_time()

    def pulse() -> float:
        nonlocal wall, cpu
        now = time.perf_counter(), time.thread_time()
        state = bool(session.running), bool(session.importing)
        report["gaps"].append([*state, now[0] - wall, now[1] - cpu])
        wall, cpu = now
        return BEAT

    bpy.app.timers.register(pulse, persistent=True)


def play(steps: Callable[[Screen], Iterator[float]], is_empty: bool = True) -> None:
    """Register the add-on, do the ``steps``, write OUT/report.json, and leave.

    ``is_empty`` removes what is in Blender's default scene first.
    """
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.view.show_tooltips = False
    for obj in list(bpy.data.objects) if is_empty else ():
        bpy.data.objects.remove(obj)
    bpy.ops.ed.undo_push(message="Empty")
    time_ticks_and_draws()
    fantasia3d_addon.register()
    todo = None

    def walk() -> float | None:
        nonlocal todo
        try:
            todo = todo or steps(Screen())
            return next(todo)
        except StopIteration:
            leave()
        except BaseException:
            report["traceback"] = traceback.format_exc()
            leave()

    def leave() -> None:
        (OUT / "report.json").write_text(json.dumps(report), encoding="utf-8")
        os._exit(0)

    bpy.app.timers.register(walk, first_interval=2.0, persistent=True)
