"""What is freed is used again, without a page fault."""

import platform
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
FAULTS = """
import resource
import numpy as np
from core.prior.allocator import keep_freed_memory
if {kept}:
    keep_freed_memory()
def faults():
    np.ones(10_000_000)  # 80 MB
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt
before = faults()
print([faults() for _ in range(50)][-1] - before)
"""


def _faults(kept: bool) -> int:
    script = FAULTS.format(kept=kept)
    return int(subprocess.check_output([sys.executable, "-c", script], cwd=ROOT, text=True))


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="another C library")
def test_large_blocks_are_not_given_back_between_two_uses():
    assert _faults(True) < _faults(False) / 10


@pytest.mark.parametrize("loaded", [AttributeError, OSError, TypeError])
def test_another_c_library_is_left_as_it_is(monkeypatch, loaded):
    from core.prior import allocator

    class Library:
        def __init__(self, name: None) -> None:
            if loaded is not AttributeError:
                raise loaded(name)

    monkeypatch.setattr(allocator.ctypes, "CDLL", Library)
    allocator.keep_freed_memory()
