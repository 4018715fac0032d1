"""Tasks that take seconds and never touch bpy, each in a thread of its own. No bpy."""

from __future__ import annotations

import threading
from collections.abc import Callable

from ..environment import SetupError
from ..errors import AddonError

ReportProgress = Callable[[str, float], None]  # a line for the user, and the fraction done


def ignore_progress(_text: str, _fraction: float) -> None:
    """A :data:`ReportProgress` that does nothing."""


class Task:
    """A function in a thread: its progress, then its result or its error."""

    def __init__(self, title: str, function: Callable[[ReportProgress], object]) -> None:
        self.title = title
        self.text, self.fraction = "Starting", 0.0
        self.error: tuple[str, str] | None = None  # its text and its fix
        self.result: object = None
        self.cancelled = False
        self._function = function
        self._thread = threading.Thread(target=self._run, daemon=True)  # Blender may be closed
        self._thread.start()

    @property
    def running(self) -> bool:
        """Whether it has not ended yet."""
        return self._thread.is_alive()

    def join(self, seconds: float) -> None:
        """Wait until it has ended; for scripts."""
        self._thread.join(seconds)

    def cancel(self) -> None:
        """Ask it to stop; its function looks at ``cancelled``."""
        self.cancelled = True

    def _report(self, text: str, fraction: float) -> None:
        self.text, self.fraction = text, fraction

    def _run(self) -> None:
        try:
            self.result = self._function(self._report)
        # What the user can fix is shown; a bug is shown too, and its traceback printed.
        except (SetupError, AddonError) as error:
            self.error = (error.text, error.fix)
        except Exception as error:
            self.error = (f"{type(error).__name__}: {error}", "This is a bug. Report it.")
            raise  # for the terminal, with its traceback
