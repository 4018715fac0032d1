"""Output files that replace the old ones only when they are complete."""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from ..environment import try_lock
from ..environment.files import expanded
from ..errors import OutputError

PREFIX = ".fantasia3d-"  # of every temporary file and folder next to an output
LOCK = "fantasia3d.lock"  # in a temporary folder; held while its process lives
FULL = (errno.ENOSPC, errno.EDQUOT)
ROOM = 1 << 16  # bytes: a disk with less is full
NEW = 60.0  # seconds: a folder that was just made may not be locked yet

ASSET_FILES = (  # of an asset folder
    "asset.json", "mesh.obj", "mesh.mtl", "base_color.png", "orm.png", "normal.png", "emission.png",
    "transmission.png", "asset.glb", "preview.png",
)  # fmt: skip

_in_use: set[Path] = set()  # the temporary files and folders of this process


@contextlib.contextmanager
def temporary_output(path: Path) -> Iterator[Path]:
    """A path in a temporary folder next to ``path``; at the end the file takes its place.

    What was written next to it (folders of textures, .mtl) moves along, before the file that
    refers to it.

    Raises:
        OutputError: the place can't be written, or nothing was written.
    """
    path = expanded(path, OutputError).absolute()
    try:
        if path.is_dir():
            raise OutputError(f"{path} is a folder.", "Name a file.")
        if is_of_asset(path):
            raise OutputError(f"{path} is a file of the asset itself.", "Name another file.")
        path.parent.mkdir(parents=True, exist_ok=True)
        # On the same disk as ``path``: only then is a rename one step.
        with temporary_folder(path.parent) as folder:
            temporary = folder / path.name
            yield temporary
            if not temporary.is_file() or not temporary.stat().st_size:
                raise OSError(0, "Blender wrote nothing")
            raise_if_full(folder)
            _move_siblings(temporary, path)
            temporary.replace(path)
    except (OSError, RuntimeError) as error:  # RuntimeError: what Blender's operators report
        raise unwritten(path, error) from None


def is_of_asset(path: Path) -> bool:
    """Whether ``path`` is one of the files that an asset consists of, which would be lost."""
    # Windows and macOS take Mesh.OBJ for the same file.
    return path.name.lower() in ASSET_FILES and (path.parent / "asset.json").exists()


def unwritten(path: Path, error: OSError | RuntimeError) -> OutputError:
    """The error for an output that could not be written."""
    try:
        raise_if_full(path.parent)
    except OSError as full:  # Blender's own reason may be another then, such as no such file
        error = full if full.errno in FULL else error
    fix = "Free some space." if getattr(error, "errno", None) in FULL else "Choose another place."
    return OutputError(f"{path} can't be written ({reason_of(error)}).", fix)


def raise_if_full(folder: Path) -> None:
    """OSError where the disk of ``folder`` has no room left.

    On a full disk Blender's writers of pictures and libraries leave half a file and report success.
    """
    with tempfile.TemporaryFile(prefix=PREFIX, dir=folder) as file:
        file.write(bytes(ROOM))
        file.flush()
        os.fsync(file.fileno())


@contextlib.contextmanager
def temporary_folder(parent: Path) -> Iterator[Path]:
    """A new folder in ``parent``; those that killed processes left there are removed."""
    _remove_stale(parent)
    folder = Path(tempfile.mkdtemp(prefix=PREFIX, dir=parent))
    with removed_at_the_end(folder), (folder / LOCK).open("ab") as lock:
        try_lock(lock)  # it is new, hence free; released when this process dies
        yield folder


@contextlib.contextmanager
def removed_at_the_end(path: Path) -> Iterator[None]:
    """Remove the temporary ``path`` at the end, and where :func:`remove_temporaries` is called."""
    _in_use.add(path)
    try:
        yield
    finally:
        remove(path)
        _in_use.discard(path)


def remove_temporaries() -> None:
    """Remove the temporary files of this process, which ends at once."""
    for path in list(_in_use):
        remove(path)


def remove(path: Path) -> None:
    """Remove a temporary file or folder, if it is there and the system lets it go."""
    shutil.rmtree(path, ignore_errors=True)
    with contextlib.suppress(OSError):
        path.unlink(missing_ok=True)


def _remove_stale(parent: Path) -> None:
    """Remove our temporary folders in ``parent`` whose process is dead; nothing else."""
    for folder in parent.glob(f"{PREFIX}*"):
        try:
            with (folder / LOCK).open("rb+") as lock:  # without a lock it is none of ours
                old = time.time() - folder.stat().st_mtime > NEW
                stale = old and try_lock(lock, unlockable=False)
        except OSError:
            continue
        if stale:
            remove(folder)


def reason_of(error: OSError | RuntimeError) -> str:
    """The cause in a system's or an operator's error, on one line."""
    text = getattr(error, "strerror", None) or str(error)
    lines = [line.strip() for line in text.splitlines() if line.strip()] or ["no reason was given"]
    # Blender's exporters in Python report a traceback; the exception is its last line except for
    # the location in Blender.
    causes = [line for line in lines if not line.startswith("Location:")]
    return causes[-1] if "Traceback" in text and causes else lines[0]


def _move_siblings(temporary: Path, path: Path) -> None:
    for sibling in temporary.parent.iterdir():
        if sibling == temporary or sibling.name == LOCK:
            continue
        place = path.with_name(sibling.name)
        if sibling.is_dir():
            # File by file: the folder may hold other pictures of the user's.
            place.mkdir(exist_ok=True)
            for file in sibling.iterdir():
                file.replace(place / file.name)
        else:
            sibling.replace(place)
