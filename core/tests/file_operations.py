"""Counts what a program does to the files below a folder, and lets one operation of it fail.

Standard library only: the tests of the core and those under Blender use it.
"""

from __future__ import annotations

import builtins
import errno
import io
import os
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

CHANGES = ("mkdir", "rmdir", "unlink", "remove", "rename", "replace", "utime", "truncate")
LISTS = ("listdir", "scandir")
READS = ("r", "rb", "rt")
UNIQUE = re.compile(r"^\.fantasia3d-[0-9a-f]{16}-")  # another one each time, hence not in the log


@dataclass
class Operations:
    """The operations below ``root``, in order, as "kind name"; number ``fails`` does."""

    root: Path
    fails: int | None = None  # from 0; None: none
    number: int = errno.ENOSPC  # of the error
    log: list[str] = field(default_factory=list)
    last: Callable[[str], None] | None = None  # called with each, before it is done

    def __call__(self, kind: str, path: object) -> None:
        """Log an operation; raise the OSError where its turn has come."""
        if not self._is_ours(path):
            return
        name = UNIQUE.sub("", Path(os.fsdecode(path)).name)  # type: ignore[arg-type]
        self.log.append(f"{kind} {name}")
        if self.last:
            self.last(self.log[-1])
        if len(self.log) - 1 == self.fails:
            raise OSError(self.number, os.strerror(self.number), os.fsdecode(path))  # type: ignore[arg-type]

    def _is_ours(self, path: object) -> bool:
        if not isinstance(path, str | bytes | os.PathLike):
            return False
        return Path(os.fsdecode(path)).absolute().is_relative_to(self.root)

    @contextmanager
    def watched(self) -> Iterator[Operations]:
        """Count, and fail, what happens within."""
        kept = self.watch()
        try:
            yield self
        finally:
            for module, name, old in reversed(kept):
                setattr(module, name, old)

    def watch(self) -> list[tuple[Any, str, Any]]:
        """Count, and fail, what happens from now on; the functions that were replaced for it."""
        kept: list[tuple[Any, str, Any]] = []

        def put(module: Any, name: str, new: Any) -> None:
            kept.append((module, name, getattr(module, name)))
            setattr(module, name, new)

        for name in (*CHANGES, *LISTS):
            put(os, name, self._counted(name, getattr(os, name)))
        put(os, "fsync", self._fsync(os.fsync))
        put(os, "open", self._os_open(os.open))
        opened = self._open(io.open)
        put(io, "open", opened)
        put(builtins, "open", opened)
        return kept

    def _counted(self, kind: str, real: Callable) -> Callable:
        def operation(path: Any = ".", *rest: Any, **named: Any) -> Any:
            self(kind, _full(path, named.get("dir_fd")))
            return real(path, *rest, **named)

        return operation

    def _fsync(self, real: Callable) -> Callable:
        def fsync(file: Any) -> None:
            number = file if isinstance(file, int) else file.fileno()
            self("fsync", _path_of(number))
            real(number)

        return fsync

    def _os_open(self, real: Callable) -> Callable:
        def os_open(path: Any, flags: int, *rest: Any, **named: Any) -> int:
            if flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
                self("open", _full(path, named.get("dir_fd")))
            return real(path, flags, *rest, **named)

        return os_open

    def _open(self, real: Callable) -> Callable:
        operations = self

        class Raw(io.FileIO):
            """The file below all buffers, where a full disk is met."""

            def write(self, data: Any) -> int:
                try:
                    operations("write", self.name)
                except OSError:
                    super().write(bytes(data)[: len(data) // 2])  # as a disk that fills up
                    raise
                return super().write(data) or 0

        def opened(
            file: Any, mode: str = "r", buffering: int = -1, encoding: Any = None, *rest: Any,
            **named: Any,
        ) -> Any:  # fmt: skip
            if mode in READS or "opener" in named or not self._is_ours(file):
                return real(file, mode, buffering, encoding, *rest, **named)
            self("open", file)
            raw = Raw(os.fspath(file), mode.replace("b", "").replace("t", ""))
            if buffering == 0:
                return raw
            buffer = io.BufferedRandom(raw) if raw.readable() else io.BufferedWriter(raw)
            if "b" in mode:
                return buffer
            return io.TextIOWrapper(buffer, encoding, *rest, **named)

        return opened


def _path_of(number: int) -> str:
    """The path of an open file (Linux)."""
    return str(Path(f"/proc/self/fd/{number}").readlink())


def _full(path: Any, folder: int | None) -> Any:
    """``path`` relative to an open folder, in full."""
    if isinstance(path, int):
        return _path_of(path)
    return path if folder is None else Path(_path_of(folder)) / os.fsdecode(path)
