"""How much memory a job needs, by measurement, and how much this machine has free. No bpy.

The peaks are those of the core's process with the built-in prior on a CPU. A Stable Diffusion model
comes on top: the core compares its size with what is free before it loads it.
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
import time
from pathlib import Path

from ..background.thread import Task

# Bytes at the peak of the training. The paper's 24 views at once were not run: 4 needed 3.4 GB and
# 8 needed 5.3 GB, which is 0.49 GB for each view.
TRAINING = {"draft": 1.3e9, "sds": 1.3e9, "standard": 3.4e9, "paper": 13.1e9}
SIZES = {"draft": 1024, "sds": 1024, "standard": 2048, "paper": 2048}  # texels along a side
# Bytes while the maps are baked: a constant part, and a part per texel (from 1024² and 4096²).
KEPT = {"draft": 1.0e9, "sds": 1.0e9, "standard": 2.5e9, "paper": 8.3e9}
TEXEL = 71.0
SPARE = 0.5e9  # bytes to leave for the rest of the machine
PERIOD = 5.0  # seconds between two measurements: a panel is drawn many times a second


def needed(preset: str, texture_size: int = 0) -> float:
    """Bytes at the peak; ``texture_size`` 0 is the preset's own."""
    size = texture_size or SIZES[preset]
    # Training and baking do not run at the same time: the larger counts.
    return max(TRAINING[preset], KEPT[preset] + TEXEL * size**2)


def available() -> float | None:
    """Bytes that a process of this machine may still take; None where it is unknown."""
    try:
        if sys.platform == "win32":
            return _available_on_windows()
        if sys.platform == "darwin":
            return _available_on_macos(subprocess.check_output(["vm_stat"], text=True, timeout=2))
        return _available_on_linux(Path("/proc/meminfo").read_text("utf-8"))
    # LookupError: a system that does not report it, such as Windows' first Linux.
    except (OSError, ValueError, LookupError, AttributeError, subprocess.SubprocessError):
        return None


class FreeMemory:
    """:func:`available`, measured every PERIOD seconds in a thread: macOS runs a program for it."""

    def __init__(self) -> None:
        self._measured, self._bytes = -PERIOD, None
        self._task: Task | None = None

    def __call__(self) -> float | None:
        """Bytes; None where it is unknown, or not yet known."""
        if self._task and not self._task.running:
            found, self._task = self._task.result, None
            self._bytes = found if isinstance(found, float) else None
        if self._task is None and time.monotonic() - self._measured >= PERIOD:
            self._measured = time.monotonic()
            self._task = Task("Memory", lambda _progress: available())
        return self._bytes


def line(preset: str, texture_size: int, free: float | None) -> tuple[str, bool]:
    """The text for the panel, and whether there is enough."""
    need = needed(preset, texture_size)
    needs = f"It needs about {need / 1e9:.1f} GB of memory"
    if free is None:
        return f"{needs}.", True
    if need + SPARE <= free:
        return f"{needs}; {free / 1e9:.0f} GB are free.", True
    smaller = "" if preset == "draft" else " or the quality Draft"
    return (
        f"{needs}; {free / 1e9:.1f} GB are free. Use a smaller texture{smaller}, or close other "
        "programs.",
        False,
    )


def _available_on_linux(meminfo: str) -> float:
    # MemAvailable: what can be used without swapping, caches included; in kB.
    rows = dict(row.split(":", 1) for row in meminfo.splitlines() if ":" in row)
    return 1024.0 * int(rows["MemAvailable"].split()[0])


def _available_on_macos(vm_stat: str) -> float:
    """Free, inactive and speculative pages: what the system gives without swapping."""
    head, *rows = vm_stat.splitlines()
    page = int(head.rpartition("page size of ")[2].split()[0])
    pages = dict(row.split(":", 1) for row in rows if ":" in row)
    names = ("Pages free", "Pages inactive", "Pages speculative")
    return float(page * sum(int(pages[name].strip(" .")) for name in names))


class _MemoryStatus(ctypes.Structure):
    """MEMORYSTATUSEX of the Windows API."""

    _fields_ = [
        ("length", ctypes.c_uint32),
        ("load", ctypes.c_uint32),
        ("total", ctypes.c_uint64),
        ("free", ctypes.c_uint64),
        ("rest", ctypes.c_uint64 * 5),
    ]


def _available_on_windows() -> float:
    status = _MemoryStatus(length=ctypes.sizeof(_MemoryStatus))
    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
    if not kernel.GlobalMemoryStatusEx(ctypes.byref(status)):
        raise OSError("GlobalMemoryStatusEx")
    return float(status.free)
