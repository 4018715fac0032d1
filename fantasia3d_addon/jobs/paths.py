"""Where the core's Python, the runs and the models are on this machine, by the preferences."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import bpy

from .. import PACKAGE, environment
from ..environment.files import expanded
from ..environment.given import named_python
from ..errors import JobError
from .process import Core


class Paths:
    """The add-on's preferences as paths; the defaults where it is used as a plain module.

    Each raises SetupError where it is in a home folder that is not here.
    """

    def __init__(self, context: bpy.types.Context) -> None:
        addon = context.preferences.addons.get(PACKAGE)
        self._preferences = addon.preferences if addon else None

    def _path(self, name: str) -> Path | None:
        text = getattr(self._preferences, name, "").strip()
        return expanded(bpy.path.abspath(text), environment.SetupError) if text else None

    @property
    def root(self) -> Path:
        """The folder that holds the core; SetupError where there is none."""
        return environment.project_root()

    @property
    def environment(self) -> Path:
        """The folder of the core's Python environment."""
        return self._path("environment_folder") or environment.env_folder(self.root)

    @property
    def place(self) -> environment.Place:
        """Where the environment is created, and from what."""
        return environment.Place(
            self.environment, self._path("base_python"), self._path("wheels_folder")
        )

    @property
    def own_python(self) -> Path | None:
        """The interpreter that the user chose instead of the environment's."""
        given = named_python()
        named = self._path("python") or (given and expanded(given, environment.SetupError))
        return Path(shutil.which(str(named)) or named) if named else None

    @property
    def python(self) -> Path:
        """The interpreter that runs the core; it may not exist yet."""
        return self.own_python or environment.env_python(self.environment)

    @property
    def core(self) -> Core:
        """How the core is started; SetupError where it is missing."""
        return Core(self.python, self.root, self.core_environ)

    @property
    def job_core(self) -> Core:
        """How a job is started: here, or by a relay to the cluster of the preferences.

        Raises:
            SetupError: the core is missing.
            JobError: a cluster is chosen, and its address or Blender's permission is not right.
        """
        preferences = self._preferences
        if preferences is None or preferences.jobs_place == "LOCAL":
            return self.core
        address = cluster_address(preferences.ray_address)
        # In a variable: a command line can be read by everyone on this machine.
        environ = self.core_environ | {"RAY_AUTH_TOKEN": preferences.ray_token.strip()}
        return Core(self.python, self.root, environ, ("--ray-jobs", address))

    @property
    def runs(self) -> Path:
        """The folder of all run folders."""
        return self._path("runs_folder") or _user_folder() / "runs"

    @property
    def tool(self) -> Path | None:
        """The folder of another tool, whose models are offered too."""
        return self._path("tool_folder")

    @property
    def core_environ(self) -> dict[str, str]:
        """Variables for the core's process: its models, and whether it may use the network."""
        # Blender's own switch and the user's must both allow it.
        online = bpy.app.online_access and getattr(self._preferences, "download_models", False)
        models = self._path("models_folder")
        return {"HF_HUB_OFFLINE": "0" if online else "1"} | (
            {"HF_HUB_CACHE": str(models)} if models else {}
        )


def cluster_address(text: str) -> str:
    """The address of a cluster, as the core takes it; JobError where it is none."""
    if not bpy.app.online_access:
        raise JobError(
            "Blender's online access is off, and jobs are to run on a Ray cluster.",
            "Allow it in Preferences, System, or choose This Machine in the add-on's preferences.",
        )
    text = text.strip().rstrip("/")
    # Nothing before an @: a password would be readable in the command line.
    if not re.fullmatch(r"https?://(\[[0-9A-Fa-f:.]+\]|[\w.-]+)(:\d+)?(/[\w./-]*)?", text):
        raise JobError(
            "The address of the Ray cluster is not valid.",
            "Enter http://HOST:8265 in the add-on's preferences.",
        )
    return text


def _user_folder() -> Path:
    """A folder of the user's own that survives an update of the add-on."""
    try:
        return Path(bpy.utils.extension_path_user(PACKAGE))
    except ValueError:  # used as a plain module, not installed as an extension
        return Path(bpy.utils.user_resource("DATAFILES", path="fantasia3d"))
