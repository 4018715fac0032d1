"""The folder of each asset of a batch, named by a hash of all that decides the result."""

import dataclasses
import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from core import __version__
from core.batch.table import Row, slug
from core.config import Config
from core.errors import UserError
from core.io.job import Job
from core.io.provenance import file_hash
from core.job_config import config_of
from core.provenance import FILES, made_by

# They set the size of the parts in which a step is computed, not the result.
PARTS = ("views_at_once",)
DIGITS = 16  # of the hash in a folder's name: two of a million assets share one by a chance of 3e-8
SMALL = 1 << 20  # bytes: larger files of a checkpoint count by name and size


@dataclass(frozen=True)
class Task:
    """One row: the run that makes its asset, or why there is none."""

    row: Row
    folder: Path | None = None
    job: Job | None = None
    error: str = ""

    @property
    def name(self) -> str:
        """The user's name for it; else its folder, or its prompt where it has none."""
        return self.row.name or (self.folder.name if self.folder else slug(self.row.prompt))


def plan(rows: Sequence[Row], out: Path, job_of: Callable[[Row], Job]) -> list[Task]:
    """A task for each row, in order; rows that request the same asset share its folder."""
    folders = {path.name.rpartition("-")[2]: path for path in _run_folders(out)}
    return [_task(row, out, job_of, folders) for row in rows]


def _run_folders(out: Path) -> list[Path]:
    return sorted(path.parent for path in out.glob("*/job.json")) if out.is_dir() else []


def _task(row: Row, out: Path, job_of: Callable[[Row], Job], folders: dict[str, Path]) -> Task:
    try:
        job = job_of(row)
        number = digest(job)
    except UserError as error:
        return Task(row, error=f"Line {row.line}: {error}")
    name = f"{slug(row.name or job.prompt)}-{number}"
    return Task(row, folders.setdefault(number, out / name), job)


def digest(job: Job) -> str:
    """A hash of everything that decides the asset of ``job``, as hexadecimal digits.

    Its fields and all settings in force, the contents of the files that it names, the weights and
    this project's version. The device, the libraries and the machine change its last bits alone.

    Raises:
        UserError: a setting that does not exist or is out of its range.
    """
    fields = dataclasses.asdict(job)
    del fields["device"], fields["settings"]
    fields |= {key: _content(fields[key]) for key in FILES}
    fields["loras"] = {_content(path): value for path, value in job.loras.items()}
    fields["embeddings"] = [_content(path) for path in job.embeddings]
    weights = _builtin_weights() if job.guidance == "builtin" else {}
    decides = [fields, _settings(config_of(job)), weights, __version__]
    text = json.dumps(decides, sort_keys=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]


def _settings(config: Config) -> dict[str, Any]:
    def kept(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        return {key: value for key, value in pairs if key not in PARTS}

    return dataclasses.asdict(config, dict_factory=kept)


@cache
def _builtin_weights() -> dict[str, str]:
    return made_by(Job(prompt="a cube"))["weights"]


def _content(value: str) -> str:
    """A file's hash, a folder's (a checkpoint's), or the ``value`` that names neither."""
    path = Path(value)
    if not path.is_absolute() or not path.exists():  # a name: a folder of it may be anywhere
        return value
    if path.is_file():
        return _hashed(path)
    files = sorted(x for x in path.rglob("*") if x.is_file())
    found = [(x.relative_to(path).as_posix(), x.stat().st_size, _small(x)) for x in files]
    return hashlib.sha256(json.dumps(found).encode()).hexdigest()


def _small(path: Path) -> str:
    return _hashed(path) if path.stat().st_size <= SMALL else ""


def _hashed(path: Path) -> str:
    known = path.stat()
    return _hash_of(path, known.st_size, known.st_mtime_ns)


@cache
def _hash_of(path: Path, size: int, time_ns: int) -> str:
    """Read once for the rows that share a file, and again where it was rewritten."""
    del size, time_ns
    return file_hash(path)
