"""The machine's resources for the set-up: a Python, a GPU, disk space, locks."""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import IO, Any

# The best tested first: bpy 4.5's wheel is for 3.11 alone, 5.2's for 3.13 alone; 3.12 has none.
PYTHONS = ("3.11", "3.13", "3.12")
ANY_PYTHON = "3.11, 3.12 or 3.13"  # the same in a sentence
HELD = (errno.EWOULDBLOCK, errno.EAGAIN, errno.EACCES, errno.EDEADLK)  # by another, of a lock
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
    """An error that the user can fix: ``text`` states what is missing, ``fix`` what to do."""

    status = 3  # the process's exit code: something is not installed or not found

    def __init__(self, text: str, fix: str = "") -> None:
        super().__init__(f"{text} {fix}".strip())
        self.text = text
        self.fix = fix


def clean_environ() -> dict[str, str]:
    """The process's variables without those that change what another Python imports; OpenMP's
    threads sleep while they wait, unless the user sets another policy."""
    # Of two drafts at once on two threads a step took ten times as long: waiting threads had both.
    kept = {key: value for key, value in os.environ.items() if key not in CLEAN}
    return {"OMP_WAIT_POLICY": "PASSIVE"} | kept


def piped_environ() -> dict[str, str]:
    """:func:`clean_environ` for a Python whose output is read here: UTF-8 on any system."""
    # What the user's terminal takes would come before UTF-8.
    kept = {key: value for key, value in clean_environ().items() if key != "PYTHONIOENCODING"}
    return kept | {"PYTHONUTF8": "1"}


def output(command: Sequence[str], timeout: float = 20) -> str:
    """The output of ``command``; empty if it fails, hangs or does not exist."""
    try:
        done = subprocess.run(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            env=piped_environ(), timeout=timeout, check=True,
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
    """Interpreters that may have a right version, the best first; some may not exist."""
    if not _in_blender() and sys.executable:
        yield sys.executable
    for version in PYTHONS:
        yield from _pythons_of_version(version)
    for word in ("python3", "python"):
        yield which(word) or ""
    if _in_blender():  # the last resort: the environment stops working with this Blender
        yield sys.executable


def _pythons_of_version(version: str) -> Iterator[str]:
    """Where interpreters of ``version`` are by their name or their folder's."""
    home, name = Path.home(), f"python{version}"
    yield which(name) or ""
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


def _in_blender() -> bool:
    return "bpy" in sys.modules


def find_python(given: Path | None = None) -> Path:
    """A Python of PYTHONS that can create environments: ``given``, or the best on this machine.

    Raises:
        SetupError: there is none.
    """
    found: dict[str, Path] = {}  # by version
    without_venv: dict[str, str] = {}
    # Each is asked itself: a name promises no version.
    for candidate in [str(given)] if given else dict.fromkeys(python_candidates()):
        if found and _in_blender() and candidate == sys.executable:
            continue
        answer = output([candidate, *ISOLATED, "-c", PROBE]) if candidate else ""
        version, wide, makes_envs, base = (answer.split("|", 3) + [""] * 3)[:4]
        if version not in PYTHONS or wide != "True":
            continue
        if makes_envs != "True":
            without_venv.setdefault(version, candidate)
            continue
        found.setdefault(version, Path(base))
        if version == PYTHONS[0]:
            break
    for version in PYTHONS:
        if version in found:
            return found[version]
    raise _no_python(given, without_venv)


def _no_python(given: Path | None, without_venv: dict[str, str]) -> SetupError:
    """Why no interpreter can create an environment; ``without_venv`` are those that almost can."""
    for version, candidate in without_venv.items():
        return SetupError(
            f"{candidate} cannot make environments: its venv or ensurepip module is missing.",
            f"Install it (on Debian and Ubuntu it is the package python{version}-venv).",
        )
    if given:
        return SetupError(
            f"{given} is not a 64-bit Python {ANY_PYTHON}.",
            f"Choose the program python{PYTHONS[0]} itself, or leave the field empty.",
        )
    fix = "Install one next to the Python you have: from python.org or from your system's packages"
    fix += "." if _in_blender() else f", or with `uv python install {PYTHONS[0]}`."
    return SetupError(
        f"Python {ANY_PYTHON} is not on this machine (this one is {sys.version.split()[0]}), "
        "and the method's packages exist only for these versions.",
        fix,
    )


def version_of(python: Path) -> str:
    """The version of an interpreter, as ``3.11``; empty if it is none."""
    code = NOT_FROM_HERE + 'print("%d.%d" % sys.version_info[:2])'
    answer = output([str(python), "-c", code])
    return answer if answer.count(".") == 1 else ""


def try_lock(file: IO[bytes], unlockable: bool = True) -> bool:
    """Acquire the lock of an open file if it is free; closing the file releases it.

    ``unlockable`` is the answer on a file system without locks, such as some network folders: as in
    core/io/lock.py nothing is refused for that.
    """
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
    except OSError as error:
        return unlockable and error.errno not in HELD
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
