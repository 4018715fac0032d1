"""A run folder, or the part of it that is needed elsewhere, as bytes for another machine."""

import io
import json
import shutil
import tarfile
from collections.abc import Callable, Collection, Iterable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path, PurePosixPath

from core.errors import UserError
from core.io.atomic import (
    atomic_file,
    disk_errors,
    left_over,
    refuse_foreign_files,
    restore,
    take_place,
)
from core.io.job import Job, write_text
from core.io.json_file import read_object

INPUTS = ("mesh", "guide_mesh", "base_color", "light", "region")  # of a job: files that go along
STATE = ("events.jsonl", "log.txt", "checkpoint/*.safetensors", "preview/*.png", "preview/*.npz")
ASSET = ("events.jsonl", "log.txt", "preview/*.png", "asset/*")  # of a run that is done
RECEIVED = ".fantasia3d-received"  # an asset appears by rename, here as well


def outward(folder: Path) -> bytes:
    """The files that another machine needs to continue the run ``folder``, with its job's files."""
    job, files = with_inputs(_job(folder))
    # The number of a GPU is this machine's; the cluster gives each asset one of its own.
    if job.device.startswith("cuda:"):
        job = replace(job, device="cuda")
    return _pack({"job.json": job.to_json().encode()}, files | found(folder, STATE))


def with_inputs(job: Job) -> tuple[Job, dict[str, Path]]:
    """``job`` with its files named as they travel, and these files by their new names."""
    files: dict[str, Path] = {}

    def travels(text: str, place: str) -> str:
        path = Path(text)
        if not text or not path.is_file():
            return text
        name = f"inputs/{place}/{path.name}"
        files[name] = path
        return name

    if (kept := Path(job.kept_asset)).is_dir() and job.kept_asset:
        parts = found(kept, ("*",))
        files |= {f"inputs/kept_asset/{name}": path for name, path in parts.items()}
        job = replace(job, kept_asset="inputs/kept_asset")
    return _renamed(job, travels), files


def _renamed(job: Job, rename: Callable[[str, str], str]) -> Job:
    """``job`` with each name of an input file as ``rename(name, place)`` has it.

    A LoRA or an embedding has a place with its number: two of them may share a name, and an
    embedding's name is its word in the prompt.
    """
    loras = {rename(x, f"loras/{n}"): value for n, (x, value) in enumerate(job.loras.items())}
    words = [rename(path, f"embeddings/{n}") for n, path in enumerate(job.embeddings)]
    plain = {key: rename(getattr(job, key), key) for key in INPUTS}
    return replace(job, loras=loras, embeddings=words, **plain)


def homeward(folder: Path, patterns: Iterable[str]) -> bytes:
    """The files of ``folder`` that match ``patterns``."""
    return _pack({}, found(folder, patterns))


def found(folder: Path, patterns: Iterable[str]) -> dict[str, Path]:
    """The files of ``folder`` by their names in it."""
    files = sorted(path for pattern in patterns for path in folder.glob(pattern))
    return {path.relative_to(folder).as_posix(): path for path in files if path.is_file()}


def _pack(texts: dict[str, bytes], files: dict[str, Path]) -> bytes:
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w") as tar:
        contents = texts | {name: path.read_bytes() for name, path in files.items()}
        for name, content in contents.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(content)
            tar.addfile(entry, io.BytesIO(content))
    return packed.getvalue()


def unpack(parcel: bytes, folder: Path, only: Collection[str] = ()) -> None:
    """Write what is in ``parcel`` into ``folder``: each file whole, an asset whole by rename.

    An older asset is removed only then. ``only``: the folders within it that may be written; all
    where none is named.

    Raises:
        UserError: a name that leads out of the folder, or out of those; an older asset that holds
            a file of somebody else's; a disk that is full or may not be written.
    """
    shutil.rmtree(folder / RECEIVED, ignore_errors=True)
    for old in left_over(folder, "old", "asset"):
        restore(folder / "asset", old)
    with tarfile.open(fileobj=io.BytesIO(parcel)) as tar:
        for entry in tar:
            if only and entry.name.partition("/")[0] not in only:
                raise UserError(f"A parcel holds {entry.name!r}, which does not belong there.")
            content = tar.extractfile(entry)
            if content is not None:
                _write(folder / _inside(entry.name), content.read())
    new, asset = folder / RECEIVED, folder / "asset"
    if new.is_dir():
        with disk_errors(asset):
            refuse_foreign_files(asset, _files_of(new, asset), "Move it elsewhere, and resume.")
            take_place(new, asset)


def _files_of(*assets: Path) -> set[str]:
    """The names of the files that are in the newest of the assets or listed by the others."""
    ours = {"asset.json", *(path.name for path in assets[0].iterdir())}
    for asset in assets:
        with suppress(OSError, ValueError, KeyError, TypeError, RecursionError):  # broken
            ours |= {*json.loads((asset / "asset.json").read_text(encoding="utf-8"))["files"]}
    return ours


def _inside(name: str) -> PurePosixPath:
    path = PurePosixPath(name)
    if path.is_absolute() or ".." in path.parts:
        raise UserError(f"A parcel holds {name!r}, which leads out of its folder.")
    return PurePosixPath(RECEIVED, *path.parts[1:]) if path.parts[0] == "asset" else path


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_file(path) as temporary:
        temporary.write_bytes(content)


def settle(folder: Path) -> None:
    """Name in an unpacked job.json the files that came along by where they are now."""

    def here(text: str, _: str = "") -> str:
        return str((folder / text).resolve()) if text.startswith("inputs/") else text

    job = _renamed(_job(folder), here)
    job = replace(job, kept_asset=here(job.kept_asset))
    write_text(folder / "job.json", job.to_json())


def _job(folder: Path) -> Job:
    return Job.from_object(read_object(folder / "job.json", "Start a new run."))
