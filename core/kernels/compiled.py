"""How every loop here is compiled."""

import os
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from numba import njit
from numba.core.caching import FunctionCache

WAIT_SECONDS = 60.0  # for another process's compiler; then this one compiles too


class Cache(FunctionCache):
    """Of the processes that start together, one compiles a loop; the others take what it kept.

    From a load that finds nothing to the save the loop's lock is held; the system releases it if
    this process dies.
    """

    _held: int | None = None  # the open file that is locked

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        found = super().load_overload(sig, target_context)
        if found is None and self._lock():
            found = super().load_overload(sig, target_context)
            if found is not None:
                self._release()
        return found

    def save_overload(self, sig: Any, data: Any) -> None:
        try:
            super().save_overload(sig, data)
        finally:
            self._release()

    def _lock(self) -> bool:
        """Whether another process may have compiled it meanwhile."""
        if os.name == "nt" or self._held is not None:
            return False
        import fcntl

        with suppress(OSError):  # the folder may be no place for locks
            self._impl.locator.ensure_cache_path()
            path = Path(self.cache_path, f"{self._impl.filename_base}.lock")
            self._held = os.open(path, os.O_WRONLY | os.O_CREAT, 0o666)
            end = time.monotonic() + WAIT_SECONDS
            while time.monotonic() < end:
                with suppress(BlockingIOError):
                    fcntl.flock(self._held, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    break
                time.sleep(0.02)
            return True
        return False

    def _release(self) -> None:
        if self._held is not None:
            os.close(self._held)
            self._held = None


def compiled(function: Callable) -> Any:
    """The loop, compiled at its first call and kept on disk."""
    # Other threads run meanwhile; division by zero gives infinity, as in torch.
    loop = njit(nogil=True, error_model="numpy")(function)
    loop._cache = Cache(function)  # pyright: ignore[reportAttributeAccessIssue]
    return loop
