"""Operators that take seconds: in a window they run in steps, and Escape cancels them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import bpy

from ..background.thread import Task
from ..errors import AddonError
from ..jobs.panels import redraw
from .text import in_language


@dataclass
class Running:
    """The tool that is working now, for the panels."""

    title: str
    step: str = ""
    fraction: float = 0.0


running: list[Running] = []  # one at most


def reason_to_wait() -> str:
    """Why no other tool can start now; empty if one can."""
    return f"“{running[0].title}” is running." if running else ""


class ModalTask:
    """Mixin of such operators: ``steps`` does the work, ``title`` names it in the status bar.

    ``shares_window`` leaves the window to the user meanwhile, for work of another process.
    """

    title = ""
    pause = 0.01  # seconds between two steps
    shares_window = False

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        """Yields the present step and the fraction done; closing the iterator cancels the work."""
        raise NotImplementedError

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if running:  # a shortcut does not ask poll()
            self.report({"ERROR"}, in_language(reason_to_wait()))
            return {"CANCELLED"}
        self._steps = self.steps(context)
        running[:] = [Running(self.title)]
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self._timer = manager.event_timer_add(self.pause, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        """One step for each event of the timer."""
        if event.type == "ESC":
            self._end(context)
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if self.shares_window else {"RUNNING_MODAL"}
        try:
            step, fraction = next(self._steps)
        except StopIteration:
            self._end(context)
            return {"FINISHED"}
        except AddonError as error:
            self.report({"ERROR"}, in_language(str(error)))
            self._end(context)
            return {"CANCELLED"}
        except Exception:  # a bug; or it would count as running for ever, and no other tool start
            self._end(context)
            raise
        now = Running(self.title, step, round(fraction, 2))
        if running != [now]:  # drawing takes longer than most steps
            running[:] = [now]
            redraw()
        context.window_manager.progress_update(100 * fraction)
        title, now_at, escape = map(in_language, (self.title, step, "Esc: Cancel"))
        context.workspace.status_text_set(f"{title}: {now_at} {fraction:.0%}    {escape}")
        return {"PASS_THROUGH"} if self.shares_window else {"RUNNING_MODAL"}

    def cancel(self, context: bpy.types.Context) -> None:
        """Blender calls this when another file is opened or the window is closed."""
        running.clear()
        self._steps.close()  # the window's timer and status bar go with the window

    def _end(self, context: bpy.types.Context) -> None:
        running.clear()
        redraw()
        self._steps.close()
        context.workspace.status_text_set(None)
        context.window_manager.progress_end()
        context.window_manager.event_timer_remove(self._timer)


def wait_for(task: Task) -> Iterator[tuple[str, float]]:
    """Steps that wait for ``task``, and cancel it when they are closed.

    Raises:
        AddonError: it failed.
    """
    try:
        while task.running:
            yield task.text, task.fraction
    finally:
        task.cancel()
    if task.error:
        raise AddonError(*task.error)
