"""Ctrl-C: it ends a command wherever it comes, though a library swallows what it raises.

Standard library only: torch takes seconds to load, and Ctrl-C must not wait for it.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

CANCELLED = 130  # the exit code
AGAIN_SECONDS = 1.0  # cleaning up, which may follow the first, takes less


def process_began() -> float:
    """When this process started, seconds since 1970; soon after, where the system does not report
    it.

    A busy machine takes seconds to load Python, and a request that comes meanwhile counts.
    """
    try:
        fields = Path("/proc/self/stat").read_bytes().rpartition(b")")[2].split()
        ticks = int(fields[19]) / os.sysconf("SC_CLK_TCK")  # after the boot, proc(5)
        # A pause between the two clocks makes the boot earlier than it was.
        booted = max(time.time() - time.clock_gettime(time.CLOCK_BOOTTIME) for _ in range(3))
        return booted + ticks
    except (OSError, AttributeError):  # not Linux
        return time.time() - time.process_time()


class Interrupts:
    """The interrupts of one task."""

    def __init__(self) -> None:
        self.came = False
        self._timer: threading.Timer | None = None

    def raise_one(self, number: int, _: object) -> None:
        """Raise KeyboardInterrupt, and once more while the work continues in spite of it.

        trimesh takes whatever its imports and parsers raise for a missing library or a bad file,
        and an import in C drops it.
        """
        self.came = True
        self.stop()
        # The signal itself comes again: a job that has started meanwhile handles it in its own way.
        self._timer = threading.Timer(AGAIN_SECONDS, _send, (number,))
        self._timer.daemon = True
        self._timer.start()
        raise KeyboardInterrupt

    def stop(self) -> None:
        """Let it not come again."""
        if self._timer:
            self._timer.cancel()


def _send(number: int) -> None:
    """Send a signal to the main thread, which may be waiting for something."""
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident or 0, number)
    else:
        signal.raise_signal(number)


@contextmanager
def interruptible() -> Iterator[Interrupts]:
    """KeyboardInterrupt at SIGINT, within; ``came``: whether there was one."""
    interrupts, hook = Interrupts(), sys.unraisablehook

    def unraisable(what: Any) -> None:
        # Where nothing can be raised: it comes again, and is no news to print.
        if not issubclass(what.exc_type, KeyboardInterrupt):
            hook(what)

    sys.unraisablehook = unraisable
    try:
        with _handled(signal.SIGINT, interrupts.raise_one):
            yield interrupts
    finally:
        interrupts.stop()
        sys.unraisablehook = hook


@contextmanager
def interruptible_once() -> Iterator[None]:
    """KeyboardInterrupt at Ctrl-C and at a request to terminate, within, and only when they come.

    For work that ends in an order of its own, which may take longer than ``AGAIN_SECONDS``.
    """

    def interrupt() -> None:
        raise KeyboardInterrupt

    with asks_to_stop(interrupt):
        yield


@contextmanager
def asks_to_stop(ask: Callable[[], None]) -> Iterator[None]:
    """``ask`` at Ctrl-C and at a request to terminate, within."""
    with ExitStack() as stack:
        for number in (signal.SIGINT, signal.SIGTERM):
            stack.enter_context(_handled(number, lambda *_: ask()))
        yield


@contextmanager
def _handled(number: int, handler: Callable[[int, Any], None]) -> Iterator[None]:
    """``handler`` for a signal, within; a signal that the user's shell ignores stays ignored."""
    before = signal.getsignal(number)
    if before == signal.SIG_IGN or threading.current_thread() is not threading.main_thread():
        yield
        return
    signal.signal(number, handler)
    try:
        yield
    finally:
        # None is a handler in C, which Python cannot put back.
        signal.signal(number, before or signal.SIG_DFL)
