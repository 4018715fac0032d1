"""Ctrl-C while Blender works: the process ends within a second, with exit code 130."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
from collections.abc import Iterator

import bpy

from ..blender.output import remove_temporaries
from .session_folder import remove_session_folder

CANCELLED = 130


@contextlib.contextmanager
def ends_at_ctrl_c() -> Iterator[None]:
    """End this process at SIGINT, whatever the main thread does; no file is left half-written.

    A render or a bake is one call into C. Python's handler would run after it, and Blender's own
    ends the render and lets its unfinished picture be written.
    """
    if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:  # as nohup asks for
        yield
        return
    # C's part of Python's handler writes the signal's number at once, and operators leave the
    # interpreter to other threads: a thread that waits for that byte acts during a render.
    read, write = os.pipe()
    if os.name == "posix":  # which asks for it; Windows has no such pipes
        os.set_blocking(write, False)
    before = signal.signal(signal.SIGINT, lambda *_: None)
    wakeup = signal.set_wakeup_fd(write)
    threading.Thread(target=_wait, args=(read,), daemon=True).start()
    try:
        yield
    finally:
        signal.set_wakeup_fd(wakeup)
        os.close(write)  # the thread reads the end of the pipe, and ends
        # None is Blender's own handler, which Python cannot restore.
        signal.signal(signal.SIGINT, before or signal.default_int_handler)


def _wait(read: int) -> None:
    """Wait in a thread for SIGINT, or for the end of the pipe."""
    with os.fdopen(read, "rb", buffering=0) as pipe:
        while number := pipe.read(1):
            if number[0] == signal.SIGINT:
                _end()


def _end() -> None:
    remove_temporaries()
    try:
        remove_session_folder(bpy)  # which Blender would have done itself
        print("Cancelled.", file=sys.stderr, flush=True)
    finally:
        os._exit(CANCELLED)  # whatever else fails
