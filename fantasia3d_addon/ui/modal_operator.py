"""Operators that take a while: in a window they go on a step at a time, Escape stops them."""

from __future__ import annotations

from collections.abc import Iterator

import bpy

from ..background.thread import Work
from ..errors import AddonError


class Stepwise:
    """``steps`` does the work; ``word`` names it in the status bar.

    ``shares_window`` leaves the window to the user meanwhile, for what another process does.
    """

    word = ""
    pause = 0.01  # seconds between two steps
    shares_window = False

    def steps(self, context: bpy.types.Context) -> Iterator[tuple[str, float]]:
        """Yields what is being done and the share that is done."""
        raise NotImplementedError

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        self._steps = self.steps(context)
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self._timer = manager.event_timer_add(self.pause, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        """One step for each tick of the timer."""
        if event.type == "ESC":
            self._end(context)
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if self.shares_window else {"RUNNING_MODAL"}
        try:
            word, share = next(self._steps)
        except StopIteration:
            self._end(context)
            return {"FINISHED"}
        except AddonError as error:
            self.report({"ERROR"}, str(error))
            self._end(context)
            return {"CANCELLED"}
        context.window_manager.progress_update(100 * share)
        context.workspace.status_text_set(f"{self.word}: {word} {share:.0%}    Esc: stop")
        return {"PASS_THROUGH"} if self.shares_window else {"RUNNING_MODAL"}

    def cancel(self, context: bpy.types.Context) -> None:
        """Another file is opened, or the window is closed."""
        self._steps.close()

    def _end(self, context: bpy.types.Context) -> None:
        self._steps.close()
        context.workspace.status_text_set(None)
        context.window_manager.progress_end()
        context.window_manager.event_timer_remove(self._timer)


def until_done(work: Work) -> Iterator[tuple[str, float]]:
    """Steps that wait for ``work``; given up, it is stopped.

    Raises:
        AddonError: it failed.
    """
    try:
        while work.running:
            yield work.text, work.share
    finally:
        work.cancel()
    if work.error:
        raise AddonError(*work.error)
