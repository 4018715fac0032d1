"""How every loop here is compiled."""

import os
import time
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

from numba import njit
from numba.core.caching import FunctionCache, IndexDataCacheFile

WAIT_SECONDS = 60.0  # for another process's compiler; then this one compiles too


class Cache(FunctionCache):
    """One of the processes that start together compiles a loop; the others load its result.

    From a load that finds nothing to the save the loop's lock is held; the system releases it if
    this process dies. What is kept is used only while all loops here are as they were then.
    """

    _held: int | None = None  # the open file that is locked

    def __init__(self, function: Callable) -> None:
        super().__init__(function)
        # Numba's own stamp is that of the loop's file; but what a loop calls from another file, and
        # that file's numbers, are compiled into it.
        stamp = self._impl.locator.get_source_stamp(), _all_loops()
        self._cache_file = IndexDataCacheFile(self.cache_path, self._impl.filename_base, stamp)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        found = self._kept(sig, target_context)
        if found is None and self._lock():
            found = self._kept(sig, target_context)
            if found is not None:
                self._release()
        return found

    def save_overload(self, sig: Any, data: Any) -> None:
        try:
            with suppress(OSError):  # a full disk: it is compiled all the same
                super().save_overload(sig, data)
        finally:
            self._release()

    def _kept(self, sig: Any, target_context: Any) -> Any:
        """The content on disk; None where there is none, or where a power cut damaged it."""
        try:
            return super().load_overload(sig, target_context)
        except Exception:  # of a damaged pickle any may come
            with suppress(OSError):
                self.flush()
            return None

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


@cache
def _all_loops() -> str:
    """A hash of all files of loops."""
    files = sorted(Path(__file__).parent.glob("*.py"))
    return sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def compiled(function: Callable) -> Any:
    """The loop, compiled at its first call and kept on disk, where a folder can be written."""
    # Other threads run meanwhile; division by zero gives infinity, as in torch.
    loop = njit(nogil=True, error_model="numpy")(function)
    with suppress(RuntimeError):  # numba's, where there is no such folder
        loop._cache = Cache(function)  # pyright: ignore[reportAttributeAccessIssue]
    return loop
