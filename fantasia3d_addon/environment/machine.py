"""What this machine provides for the set-up: a Python, a GPU, disk space, locks."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import IO, Any

PYTHON = "3.11"  # bpy 4.5's wheel is for this one alone
LONGEST, DEEPEST = 259, 190  # characters: of a path under Windows; of torch's files in the folder
CLEAN = (
    "PYTHONHOME", "PYTHONPATH", "PYTHONSTARTUP", "__PYVENV_LAUNCHER__", "VIRTUAL_ENV",
    "PIP_TARGET", "PIP_PREFIX", "PIP_USER",
)  # fmt: skip  # variables that change what another Python imports


# Of every child interpreter of the set-up: neither the current folder nor PYTHON variables may
# provide a module; -X utf8, because PYTHONIOENCODING is one of those variables.
ISOLATED = ("-I", "-X", "utf8")
# Where -I is too much, since packages of the user's site count too; -P is not in Python 3.10.
NOT_FROM_HERE = "import sys; sys.path[:] = [path for path in sys.path if path]\n"


class SetupError(Exception):
    """What the user can fix: ``text`` states what is missing, ``fix`` what to do."""

    status = 3  # the process's exit code: something is not installed or not found

    def __init__(self, text: str, fix: str = "") -> None:
        super().__init__(f"{text} {fix}".strip())
        self.text = text
        self.fix = fix


def clean_environ() -> dict[str, str]:
    """The process's variables without those that change what another Python imports."""
    return {key: value for key, value in os.environ.items() if key not in CLEAN}


def output(command: Sequence[str], timeout: float = 20) -> str:
    """What ``command`` prints; empty if it fails, hangs or does not exist."""
    try:
        done = subprocess.run(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            env=clean_environ(), timeout=timeout, check=True,
        )  # fmt: skip
    except (OSError, subprocess.SubprocessError):
        return ""
    return done.stdout.decode("utf-8", "replace").strip()


def which(name: str) -> str | None:
    """The program ``name`` on the path, which is never one in the current folder."""
    if sys.platform != "win32":
        return shutil.which(name)
    # Windows, and shutil with it, would look into the current folder first.
    for folder in filter(None, os.environ.get("PATH", "").split(os.pathsep)):
        if Path(folder, f"{name}.exe").is_file():
            return str(Path(folder, f"{name}.exe"))
    return None


def has_nvidia() -> bool:
    """Whether there is an NVIDIA GPU with its driver."""
    if Path("/proc/driver/nvidia/version").exists():
        return True
    tool = which("nvidia-smi")
    return tool is not None and "GPU " in output([tool, "-L"])


PROBE = """import sys, importlib.util as u
print("%d.%d" % sys.version_info[:2], sys.maxsize > 2**32,
      all(u.find_spec(name) for name in ("venv", "ensurepip")),
      getattr(sys, "_base_executable", None) or sys.executable, sep="|")"""


def python_candidates() -> Iterator[str]:
    """Interpreters that may have the right version, the likeliest first; some may not exist."""
    version, name = PYTHON, f"python{PYTHON}"
    home, in_blender = Path.home(), "bpy" in sys.modules
    if not in_blender and sys.executable:
        yield sys.executable
    for word in (name, "python3", "python"):
        yield which(word) or ""
    pyenv = Path(os.environ.get("PYENV_ROOT") or home / ".pyenv")
    uv_folder = Path(os.environ.get("UV_PYTHON_INSTALL_DIR") or home / ".local/share/uv/python")
    for folder, pattern in (
        (pyenv / "versions", f"{version}*"),
        (pyenv / "pyenv-win/versions", f"{version}*"),
        (uv_folder, f"cpython-{version}*"),
    ):
        for found in sorted(folder.glob(pattern), reverse=True):
            yield str(found / "bin" / name)
            yield str(found / "python.exe")
    local = os.environ.get("LOCALAPPDATA")
    if local:
        yield str(
            Path(local, "Programs", "Python", "Python" + version.replace(".", ""), "python.exe")
        )
    for place in (
        "/usr/bin", "/usr/local/bin", "/opt/homebrew/bin", f"/opt/{name}/bin",
        f"/Library/Frameworks/Python.framework/Versions/{version}/bin",
    ):  # fmt: skip
        yield f"{place}/{name}"
    if sys.platform == "win32":
        code = "import sys; print(sys.executable)"
        launcher = which("py")
        if launcher:
            yield output([launcher, f"-{version}", *ISOLATED, "-c", code])
    uv = which("uv")
    if uv:  # --no-config: a uv.toml in the current folder names no interpreter
        yield output([uv, "--no-config", "python", "find", "--no-python-downloads", version])
    if in_blender:  # the last resort: the environment stops working with this Blender
        yield sys.executable


def find_python(given: Path | None = None) -> Path:
    """A Python of the required version that can create environments: ``given``, or the first found.

    Raises:
        SetupError: there is none.
    """
    version, without_venv = PYTHON, ""
    # The first of the right version that can create environments; each is asked itself.
    for candidate in [str(given)] if given else dict.fromkeys(python_candidates()):
        answer = output([candidate, *ISOLATED, "-c", PROBE]) if candidate else ""
        found, wide, makes_envs, base = (answer.split("|", 3) + [""] * 3)[:4]
        if found == version and wide == "True":
            if makes_envs == "True":
                return Path(base)
            without_venv = candidate
    if without_venv:
        raise SetupError(
            f"{without_venv} cannot make environments: its venv or ensurepip module is missing.",
            f"Install it (on Debian and Ubuntu: apt install python{version}-venv).",
        )
    if given:
        raise SetupError(
            f"{given} is no Python {version} of 64 bits.",
            f"Choose the program python{version} itself, or leave the field empty.",
        )
    raise SetupError(
        f"Python {version} is not on this machine (this one is {sys.version.split()[0]}), "
        "and Blender's Python module is made for that version alone.",
        f"Install it next to the Python you have: from python.org, from your system's packages, or "
        f"with `uv python install {version}`.",
    )


def try_lock(file: IO[bytes]) -> bool:
    """Acquire the lock of an open file if it is free; closing the file releases it."""
    try:
        if sys.platform == "win32":
            import msvcrt

            # Windows locks bytes: always the first one, or two processes would lock different ones.
            file.seek(0)
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            # flock belongs to the open file, and is released by the system when its process dies.
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True


def check_length(folder: Path) -> None:
    """Refuse a folder whose deepest files Windows could not name.

    Raises:
        SetupError: its path is too long.
    """
    if sys.platform == "win32" and len(str(folder)) > LONGEST - DEEPEST and not _long_paths():
        raise SetupError(
            f"{folder} has {len(str(folder))} characters; Windows takes {LONGEST - DEEPEST} here.",
            "Choose a shorter folder for the environment, such as C:\\f3d, or allow long paths.",
        )


def _long_paths() -> bool:
    """Whether this Windows takes paths of more than 260 characters."""
    import winreg

    registry: Any = winreg  # its types exist on Windows alone
    place = r"SYSTEM\CurrentControlSet\Control\FileSystem"
    try:
        with registry.OpenKey(registry.HKEY_LOCAL_MACHINE, place) as key:
            return bool(registry.QueryValueEx(key, "LongPathsEnabled")[0])
    except OSError:
        return False


def check_disk(folder: Path, need: float) -> None:
    """Refuse a set-up of ``need`` bytes for which the disk of ``folder`` has no space.

    Raises:
        SetupError: there is too little free space.
    """
    # The folder itself may not exist yet.
    there = next(path for path in (folder, *folder.parents) if path.exists())
    free = shutil.disk_usage(there).free
    if free < need:
        raise SetupError(
            f"The set-up needs {need / 1e9:.1f} GB; the disk of {there} has {free / 1e9:.1f} GB.",
            "Free some space, or set FANTASIA3D_ENV to a folder on another disk.",
        )
