"""Output files that replace the old ones only when they are complete."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterator
from pathlib import Path

from ..errors import OutputError


@contextlib.contextmanager
def temporary_output(path: Path) -> Iterator[Path]:
    """A path in a temporary folder next to ``path``; at the end the file takes its place.

    What was written next to it (folders of textures, .mtl) moves along, before the file that
    refers to it.

    Raises:
        OutputError: the place can't be written, or nothing was written.
    """
    path = path.expanduser().absolute()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        # On the same disk as ``path``: only then is a rename one step.
        with tempfile.TemporaryDirectory(prefix=".fantasia3d-", dir=path.parent) as folder:
            temporary = Path(folder) / path.name
            yield temporary
            if not temporary.is_file() or not temporary.stat().st_size:
                raise OSError(0, "Blender wrote nothing")
            _move_siblings(temporary, path)
            temporary.replace(path)
    except (OSError, RuntimeError) as error:  # RuntimeError: what Blender's operators report
        raise OutputError(
            f"{path} can't be written ({reason_of(error)}).", "Choose another place."
        ) from None


def reason_of(error: OSError | RuntimeError) -> str:
    """The cause in a system's or an operator's error."""
    return getattr(error, "strerror", None) or str(error).strip()


def _move_siblings(temporary: Path, path: Path) -> None:
    for sibling in temporary.parent.iterdir():
        if sibling == temporary:
            continue
        place = path.with_name(sibling.name)
        if sibling.is_dir():
            # File by file: the folder may hold other pictures of the user's.
            place.mkdir(exist_ok=True)
            for file in sibling.iterdir():
                file.replace(place / file.name)
        else:
            sibling.replace(place)
