"""The ``verify`` command: makes an asset again from what it records, and compares the files."""

import tempfile
from pathlib import Path
from typing import Any

from core.errors import UserError, shown
from core.generate import prepare
from core.io.asset import data_files, inspect
from core.io.job import Job
from core.io.maps import REMAKE
from core.io.provenance import file_hash
from core.io.run_folder import RunFolder
from core.provenance import FILES, made_by


def verify(folder: Path, make: Any) -> dict[str, Any]:
    """Whether the asset in ``folder`` (or its run folder) comes out again, file by file.

    ``make(run, inputs)`` carries a run out and returns its asset. ``files`` has for each file
    "same", "differs", or "changed" where the file is not the one that was made; ``versions`` what
    is another one now than when it was made, as [then, now].

    Raises UserError for an asset that does not record its job, or a job whose files are gone.
    """
    info = inspect(folder)
    path = folder / "asset" if (folder / "asset" / "asset.json").is_file() else folder
    job = _job(path, info)
    hashes, then = (_object(path, info, name) for name in ("hashes", "made_by"))
    with tempfile.TemporaryDirectory() as temporary:
        run = RunFolder.create(Path(temporary) / "run", job)
        again = make(run, prepare(job))
        files = {}
        for name in dict.fromkeys([*data_files(path), *data_files(again)]):
            old, new = (
                file_hash(here / name) if (here / name).is_file() else None
                for here in (path, again)
            )
            is_own, is_same = hashes.get(name) in (None, old), old == new
            files[name] = "same" if is_same else "differs" if is_own else "changed"
    now = made_by(job)
    versions = {key: [then.get(key), now[key]] for key in now if then.get(key) != now[key]}
    return {"same": set(files.values()) == {"same"}, "files": files, "versions": versions}


def _job(path: Path, info: dict[str, Any]) -> Job:
    """The job of the run around the asset; or else the one that asset.json records."""
    run = path.parent / "job.json"
    if path.name == "asset" and run.is_file():
        return RunFolder.open(run.parent).job
    if not isinstance(info.get("job"), dict):
        raise UserError(
            f"{path} does not record how it was made.", "Name an asset of this release."
        )
    job = Job.from_object(info["job"])
    for name in FILES:
        value = getattr(job, name)
        if value and _is_gone(name, value):
            raise UserError(
                f"The asset was made from {shown(value)}, which is missing.",
                "Name its run folder, or run it from the folder that holds this file.",
            )
    return job


def _is_gone(field: str, value: str) -> bool:
    """Whether ``value`` was a file, and is not here: the light and the model have names, too."""
    try:
        if Path(value).exists():
            return False
    except OSError:  # a name that is too long
        return True
    if field == "light":  # such as one of Blender's
        return bool(Path(value).suffix) and not value.startswith("blender:")
    is_hub_id = field == "guidance" and "/" in value  # of a file its last name alone is recorded
    return value not in ("builtin", "mesh") and not is_hub_id


def _object(path: Path, info: dict[str, Any], name: str) -> dict[str, Any]:
    found = info.get(name, {})
    if not isinstance(found, dict):
        raise UserError(f"asset.json of {path} has a {name} entry that is not an object.", REMAKE)
    return found
