"""The C library's allocator: freed memory is kept for later allocations. Standard library only.

glibc gives a large block back to the system when it is freed, and gets its pages again, each by a
fault and filled with zeros, for the next tensor of the same size. In a training of the solids that
was a third of the time. A run that makes an asset has a sixtieth as many faults: it does not use
this.
"""

import ctypes

# mallopt(3).
M_TRIM_THRESHOLD, M_TOP_PAD, M_MMAP_MAX = -1, -2, -4
MOST = 2**31 - 1  # bytes
PAD = 64 << 20  # bytes that the heap grows by, at least


def keep_freed_memory() -> None:
    """Set these options of glibc; do nothing with another C library.

    To be called before the first large tensor.
    """
    try:
        mallopt = ctypes.CDLL(None).mallopt
    except (AttributeError, OSError, TypeError):  # musl, macOS; Windows, which has no main program
        return
    for option, value in ((M_MMAP_MAX, 0), (M_TRIM_THRESHOLD, MOST), (M_TOP_PAD, PAD)):
        mallopt(option, value)
