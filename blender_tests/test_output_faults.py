"""Every file operation around an output of Blender fails once: the older file or the newer one."""

import errno
import sys
from pathlib import Path

import pytest

from core.tests.file_operations import Operations
from fantasia3d_addon.blender.output import PREFIX, temporary_output
from fantasia3d_addon.errors import OutputError

OLD, NEW = b"the older file", b"the newer file"


def write(path: Path) -> None:
    """A file and its textures, as an exporter writes them."""
    with temporary_output(path) as temporary:
        (temporary.parent / "textures").mkdir()
        (temporary.parent / "textures" / "a.png").write_bytes(NEW)
        temporary.write_bytes(NEW)


def contents(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file())
    found = {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}
    # What cannot be removed now is removed by a later output.
    return {name: content for name, content in found.items() if not name.startswith(PREFIX)}


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_each_operation_of_an_output_fails_once(tmp_path):
    with Operations(tmp_path / "in peace").watched() as operations:
        write(tmp_path / "in peace" / "chair.obj")
    # No longer there when the rest runs: the folder, which is made again only once.
    assert {"replace chair.obj", "open fantasia3d.lock", "mkdir textures"} <= {*operations.log}
    for i, name in enumerate(operations.log):
        folder = tmp_path / f"{i}"
        path = folder / "chair.obj"
        folder.mkdir()
        path.write_bytes(OLD)
        (folder / "precious.txt").write_bytes(OLD)
        try:
            with Operations(folder, i, (errno.ENOSPC, errno.EACCES)[i % 2]).watched():
                write(path)
        except OutputError as error:
            message = str(error)
        else:
            message = ""
        found = contents(folder)
        assert found["chair.obj"] == (OLD if message else NEW), name
        assert found["precious.txt"] == OLD and "\n" not in message, name
        write(path)
        assert contents(folder)["chair.obj"] == NEW, name
