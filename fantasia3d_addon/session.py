"""What goes on in this Blender: the run that it follows, and the set-up of the core's Python.

One :class:`Session` lives from register to unregister. Its :meth:`tick` is called by a timer in a
window (timers never fire in the background) or by a loop in a script; it never blocks.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable
from pathlib import Path

import bpy

from . import environment
from .errors import AddonError
from .export_shape import export_shape
from .import_asset import data_name, import_asset
from .jobs import Event, Run
from .preferences import Machine
from .properties import job_of

TICK_SECONDS = 0.25


class Progress:
    """How far the run is, as the panel shows it."""

    def __init__(self) -> None:
        self.text = "Starting"
        self.share = 0.0  # of the present stage
        self.seconds_left: float | None = None
        self.cancelling = False

    def take(self, event: Event) -> None:
        """Show a ``progress`` event."""
        self.text = event.stage.capitalize() or self.text
        self.share = event.step / event.steps if event.steps else 0.0
        self.seconds_left = event.seconds_left

    @property
    def line(self) -> str:
        """One line: the stage, its share, the time that it will take."""
        if self.cancelling:
            return f"{self.text}: stops after this step"
        left = self.seconds_left
        time_left = f", {left // 60:.0f}:{left % 60:02.0f} left" if left is not None else ""
        return f"{self.text} {self.share:.0%}{time_left}"


class Work:
    """A function that runs in a thread of its own and never touches bpy: a set-up or a check."""

    def __init__(self, function: Callable[[Callable[[str, float], None]], str]) -> None:
        self.text, self.share = "Starting", 0.0
        self.error: tuple[str, str] | None = None  # a sentence and its fix
        self._function = function
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    @property
    def running(self) -> bool:
        """Whether it has not ended yet."""
        return self._thread.is_alive()

    def join(self, seconds: float) -> None:
        """Wait for its end; for scripts."""
        self._thread.join(seconds)

    def _say(self, text: str, share: float) -> None:
        self.text, self.share = text, share

    def _run(self) -> None:
        try:
            self.text = self._function(self._say)
        except environment.SetupError as error:
            self.error = (error.text, error.fix)


class Session:
    """The state of this Blender that is no part of the file."""

    def __init__(self) -> None:
        self.run: Run | None = None
        self.progress = Progress()
        self.error: tuple[str, str] | None = None  # the last one: a sentence and its fix
        self.warning: tuple[str, str] | None = None
        self.asset = ""  # the name of the last object that was made
        self.work: Work | None = None
        self._scene = ""
        self._location = (0.0, 0.0, 0.0)
        self._timer = self.tick  # one object: Blender knows a timer by its identity

    @property
    def busy(self) -> bool:
        """Whether a run is being followed."""
        return self.run is not None and not self.run.finished

    def generate(self, context: bpy.types.Context) -> Run:
        """Start the job that the scene's settings ask for, and follow it.

        Raises:
            AddonError: it can't be started; nothing runs then.
            SetupError: the core is not there.
        """
        settings, machine = context.scene.fantasia3d, Machine(context)
        job_of(settings)  # what is wrong with it is said before a folder is made
        folder = new_run_folder(machine.runs, settings.prompt)
        guide = folder / "guide.obj" if settings.guide else None
        if guide:
            export_shape(settings.guide, guide, context.evaluated_depsgraph_get())
        run = Run.start(
            folder, job_of(settings, guide), machine.python, machine.root, machine.core_environ
        )
        return self.follow(context, run)

    def follow(self, context: bpy.types.Context, run: Run) -> Run:
        """Follow ``run``; its asset will stand at the 3D cursor of the present scene."""
        self.run, self.progress = run, Progress()
        self.error, self.warning, self.asset = None, None, ""
        self._scene = context.scene.name
        self._location = tuple(context.scene.cursor.location)
        self.watch()
        return run

    def cancel(self) -> None:
        """Ask the run to stop after its present step."""
        if self.run:
            self.run.cancel()
            self.progress.cancelling = True

    def set_up(self, context: bpy.types.Context) -> Work:
        """Make the core's Python environment, in the background."""
        machine = Machine(context)
        root = machine.root
        os.environ["FANTASIA3D_ENV"] = str(machine.environment)  # environment's own interface
        return self._begin(lambda say: f"Ready: {environment.ensure(root, (), say)}")

    def check(self, context: bpy.types.Context) -> Work:
        """Look at what is here and what is missing, in the background."""
        machine = Machine(context)
        root = machine.root
        os.environ["FANTASIA3D_ENV"] = str(machine.environment)

        def look(_say: Callable[[str, float], None]) -> str:
            missing = [line for line in environment.examine(root) if line.state == "MISSING"]
            if missing:
                raise environment.SetupError(
                    f"Missing: {', '.join(line.name for line in missing)}.", missing[0].text
                )
            return "Everything is here."

        return self._begin(look)

    def _begin(self, function: Callable[[Callable[[str, float], None]], str]) -> Work:
        self.work = Work(function)
        self.watch()
        return self.work

    def watch(self) -> None:
        """Have :meth:`tick` called while there is something to follow."""
        if not bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.register(self._timer, first_interval=TICK_SECONDS, persistent=True)

    def close(self) -> None:
        """Stop following and forget; what runs goes on by itself."""
        if bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.unregister(self._timer)
        self.__init__()

    def tick(self) -> float | None:
        """Take in what has happened; the seconds to the next call, None when all has ended."""
        if self.run and self.busy:
            for event in self.run.poll():
                self._take(event)
        _redraw()
        return TICK_SECONDS if self.busy or (self.work and self.work.running) else None

    def _take(self, event: Event) -> None:
        if event.type == "progress":
            self.progress.take(event)
        elif event.type == "warning":
            self.warning = (event.text, event.fix)
        elif event.type == "error":
            self.error = (event.text, event.fix)
        elif event.type == "done":
            self._import()

    def _import(self) -> None:
        assert self.run
        scene = bpy.data.scenes.get(self._scene) or bpy.context.scene  # another file may be open
        where = scene.view_layers[0].active_layer_collection  # a timer's context has no window
        try:
            self.asset = import_asset(where, self.run.asset, self._location).name
        except AddonError as error:
            self.error = (error.text, error.fix)
            return
        if not bpy.app.background:
            with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
                bpy.ops.ed.undo_push(message=f"Generate {self.asset}")


def new_run_folder(runs: Path, prompt: str) -> Path:
    """A new, empty folder for a run, named by the time and the prompt's letters.

    Raises:
        AddonError: the place can't be written.
    """
    words = "".join(c if c.isalnum() else " " for c in data_name(prompt).lower()).split()
    name = "-".join([time.strftime("%Y%m%d-%H%M%S"), *words])
    number = 1
    while True:
        folder = runs / (name if number == 1 else f"{name}-{number}")
        try:
            folder.mkdir(parents=True)
        except FileExistsError:
            number += 1
        except OSError as error:
            raise AddonError(
                f"{folder} can't be made ({error.strerror}).",
                "Choose another folder for runs in the add-on's preferences.",
            ) from None
        else:
            return folder


def _redraw() -> None:
    """Draw the sidebars and the preferences anew."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in ("VIEW_3D", "PREFERENCES"):
                area.tag_redraw()


session = Session()  # the one of this Blender; unregistration empties it
