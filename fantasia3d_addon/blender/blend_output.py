"""Blender files that replace the old ones only when they are complete, their paths right."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

from .output import PREFIX, removed_at_the_end, temporary_output

ENDING = ".blend"
HALF = f"{ENDING}@"  # what Blender calls a file until it is whole
ANY = "?" * 8  # the characters of a temporary folder's own name


@contextlib.contextmanager
def temporary_blend(path: Path) -> Iterator[Path]:
    """A path in the folder of ``path`` to write; at the end the file takes its place.

    Blender writes paths that are relative to the folder it writes into: that of a
    ``temporary_output`` would be one too deep.

    Raises:
        OutputError: the place can't be written, or nothing was written.
    """
    with temporary_output(path) as temporary:
        folder = temporary.parent
        _remove_stale(folder.parent)
        new, half = (folder.with_name(f"{folder.name}{end}") for end in (ENDING, HALF))
        with removed_at_the_end(half), removed_at_the_end(new):
            yield new
            if new.exists():
                new.replace(temporary)


def _remove_stale(parent: Path) -> None:
    """Remove what killed processes left in ``parent``: files whose folder is gone already."""
    for ending in (ENDING, HALF):
        for file in parent.glob(f"{PREFIX}{ANY}{ending}"):
            if not file.with_name(file.name.removesuffix(ending)).exists():
                with contextlib.suppress(OSError):
                    file.unlink()
