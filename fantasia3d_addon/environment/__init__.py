"""The core's own Python environment: found, created, repaired and checked.

Standard library only, and no bpy. ``run.py`` and the panel's "Install" button both use this
package; it loads under Python 3.8 or newer. The dependencies are in ``pyproject.toml`` alone,
and what is installed for them, with hashes, in ``requirements.lock``.

The environment is in the user's data folder as ``fantasia3d/env-HASH``, where HASH is that of the
core's section of the lock file. It is complete when its marker exists, which is written last: what
a killed set-up leaves is created again by the next one. Nothing is installed into Blender.

Variables: FANTASIA3D_ENV (another folder), FANTASIA3D_PYTHON (an interpreter to use as it is),
FANTASIA3D_WHEELS (a folder of wheels instead of the registry), FANTASIA3D_BLENDER (an installed
Blender, used where the environment's Python can have no bpy module).
"""

from .blender_program import find_blender, module_version
from .builder import find_builder
from .doctor import Line, examine
from .install import Progress, ensure
from .lock_file import locked, read_lock
from .machine import (
    ANY_PYTHON,
    PYTHONS,
    SetupError,
    clean_environ,
    find_python,
    has_nvidia,
    piped_environ,
    try_lock,
)
from .paths import (
    Place,
    data_folder,
    env_folder,
    env_python,
    lacking,
    log_file,
    project_root,
    requirements,
)
from .removal import remove, tidy
from .report import write_report

__all__ = [
    "ANY_PYTHON",
    "PYTHONS",
    "Line",
    "Place",
    "Progress",
    "SetupError",
    "clean_environ",
    "data_folder",
    "ensure",
    "env_folder",
    "env_python",
    "examine",
    "find_blender",
    "find_builder",
    "find_python",
    "has_nvidia",
    "lacking",
    "locked",
    "log_file",
    "module_version",
    "piped_environ",
    "project_root",
    "read_lock",
    "remove",
    "requirements",
    "tidy",
    "try_lock",
    "write_report",
]
