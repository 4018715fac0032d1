"""A run folder with all that its job needs, before anything is started. No bpy."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..errors import AddonError
from .job_file import new_run_folder, with_own_paths, write_job
from .target import Target


def write_run(
    runs: Path, job: Mapping[str, Any], target: Target, files: Mapping[str, Path]
) -> Path:
    """A new folder in ``runs`` with ``job``, ``target``, and copies of ``files`` by name.

    Raises:
        AddonError: it can't be written; nothing is left of it then.
    """
    folder = new_run_folder(runs, str(job.get("prompt", "")))
    try:
        for name, path in files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, folder / name)
        target.write(folder)
        # job.json is last: a folder without it is no run, whatever else is in it.
        write_job(folder, with_own_paths(job, folder))
    except BaseException as error:
        shutil.rmtree(folder, ignore_errors=True)  # we created it a moment ago
        if isinstance(error, OSError):
            raise AddonError(
                f"{folder} can't be written ({error.strerror}).",
                "Choose another folder for runs in the add-on's preferences.",
            ) from None
        raise
    return folder
