"""Ctrl-C: it ends a command wherever it comes, though a library swallows what it raises.

Standard library only: torch takes seconds to load, and Ctrl-C must not wait for it.
"""

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

CANCELLED = 130  # the exit code
AGAIN_SECONDS = 1.0  # cleaning up, which may follow the first, takes less


class Interrupts:
    """What one piece of work was interrupted by."""

    def __init__(self) -> None:
        self.came = False
        self._timer: threading.Timer | None = None

    def handle(self, number: int, _: FrameType | None) -> None:
        """Raise KeyboardInterrupt, and once more while the work goes on in spite of it.

        trimesh takes whatever its imports and parsers raise for a missing library or a bad file,
        and numpy's import within torch's drops it.
        """
        self.came = True
        self.stop()
        # The signal itself comes again: a job that has begun meanwhile has a handler of its own.
        self._timer = threading.Timer(AGAIN_SECONDS, signal.raise_signal, (number,))
        self._timer.daemon = True
        self._timer.start()
        raise KeyboardInterrupt

    def stop(self) -> None:
        """Let it not come again."""
        if self._timer:
            self._timer.cancel()


@contextmanager
def interruptible() -> Iterator[Interrupts]:
    """KeyboardInterrupt at SIGINT, within; ``came`` says whether there was one.

    A command that the user's shell has told to ignore SIGINT goes on ignoring it.
    """
    interrupts = Interrupts()
    before = signal.getsignal(signal.SIGINT)
    if before == signal.SIG_IGN or threading.current_thread() is not threading.main_thread():
        yield interrupts
        return
    hook = sys.unraisablehook
    sys.unraisablehook = lambda what: (
        # Where nothing can be raised: it comes again, and is no news to print.
        None if issubclass(what.exc_type, KeyboardInterrupt) else hook(what)
    )
    signal.signal(signal.SIGINT, interrupts.handle)
    try:
        yield interrupts
    finally:
        interrupts.stop()
        sys.unraisablehook = hook
        # None is a handler in C, which Python cannot put back.
        signal.signal(signal.SIGINT, before or signal.default_int_handler)
