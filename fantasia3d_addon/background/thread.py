"""What takes seconds and never touches bpy runs in a thread of its own. No bpy."""

from __future__ import annotations

import threading
from collections.abc import Callable

from ..environment import SetupError
from ..errors import AddonError

Say = Callable[[str, float], None]  # a line for the user, and the share that is done


def silent(_text: str, _share: float) -> None:
    """Nobody listens."""


class Work:
    """A function in a thread: how far it is, what came of it, or the sentence of its error."""

    def __init__(self, title: str, function: Callable[[Say], object]) -> None:
        self.title = title
        self.text, self.share = "Starting", 0.0
        self.error: tuple[str, str] | None = None  # a sentence and its fix
        self.result: object = None
        self.cancelled = False
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

    def cancel(self) -> None:
        """Ask it to stop; it looks at ``cancelled``."""
        self.cancelled = True

    def _say(self, text: str, share: float) -> None:
        self.text, self.share = text, share

    def _run(self) -> None:
        try:
            self.result = self._function(self._say)
        except (SetupError, AddonError) as error:
            self.error = (error.text, error.fix)
        except Exception as error:
            self.error = (f"{type(error).__name__}: {error}", "This is a bug. Report it.")
            raise
