"""Permissions of files, for tests that root may run. Standard library only."""

import ctypes
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

VERSION = 0x20080522  # of the call: 64 capabilities in two words
ROOTS = 1 << 1 | 1 << 2  # CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH (capability.h)


@contextmanager
def permissions_count() -> Iterator[bool]:
    """Whether files that may not be read cannot be, within; root does without its right to."""
    if not hasattr(os, "geteuid") or os.geteuid():
        yield os.name == "posix"
        return
    if sys.platform != "linux":
        yield False
        return
    libc = ctypes.CDLL(None)
    head, data = (ctypes.c_uint32 * 2)(VERSION, 0), (ctypes.c_uint32 * 6)()
    assert libc.capget(head, data) == 0
    before = data[0]  # the effective ones; they stay permitted, and can be taken back
    data[0] = before & ~ROOTS
    assert libc.capset(head, data) == 0
    try:
        yield True
    finally:
        data[0] = before
        assert libc.capset(head, data) == 0
