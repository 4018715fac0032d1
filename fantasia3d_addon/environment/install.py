"""The set-up of the environment: a venv, torch for this machine, the pinned packages."""

from __future__ import annotations

import contextlib
import json
import os
import queue
import re
import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator, Sequence
from pathlib import Path
from typing import IO, Any, Protocol

from . import machine, paths
from .blender_program import FIX, NO_MODULE, has_module
from .given import given_python, named_python
from .lock_file import digest, locked, package_of
from .machine import SetupError
from .pip_output import explain, offers_cuda, pip_sources, pip_version, step_of
from .removal import check_folder, check_log, remove


class Progress(Protocol):
    """Receives the set-up's steps."""

    def __call__(self, text: str, fraction: float, /) -> None:
        """``text`` is a line for the user; ``fraction`` is done, from 0 to 1."""


SIZES = {"core": 1.2e9, "blender": 0.85e9, "test": 0.35e9, "ray": 0.27e9}  # bytes on disk, measured
CUDA_SIZE = 6e9  # what torch's CUDA build adds
LEAN_PIP = (23, 2)  # older ones download a whole wheel (torch: 0.5 GB) to read its requirements
SILENCE = 15.0  # seconds without output after which a long step is reported again
LAST_LINES = 1000  # of a command's output, for the cause of its failure; pip lists all hashes
POLL_SECONDS = 0.5  # between two checks for a cancel
CHECKS = {  # what must load before a group counts as installed
    "core": "import torch, numpy, safetensors, PIL; print('torch', torch.__version__)",
    "blender": "import bpy, os, sys; print('bpy', bpy.app.version_string); sys.stdout.flush(); "
    "os._exit(0)",  # an ordinary exit may hang with bpy 4.5
}
LIBRARIES = "libx11-6 libxi6 libxxf86vm1 libxfixes3 libxrender1 libxkbcommon0 libsm6 libgl1 libegl1"


def ensure(
    root: Path,
    groups: Sequence[str],
    progress: Progress,
    *,
    allow_cuda: bool = False,
    renew: bool = False,
    place: paths.Place | None = None,
    stopped: Callable[[], bool] = lambda: False,
    runs_core: bool = True,
) -> Path:
    """The interpreter of an environment with the core and ``groups``; created if necessary.

    An interpreter in FANTASIA3D_PYTHON is used as it is, unless ``place`` names the environment;
    it may lack the core's packages where ``runs_core`` is false.
    ``allow_cuda`` allows torch's CUDA build on a machine without a GPU too; ``renew`` creates the
    environment again; ``stopped`` is called twice a second: true cancels.

    Raises:
        SetupError: something is missing that the user can fix; nothing incomplete is left.
    """
    # The panel passes a place: a choice in the preferences comes before the variable.
    given = named_python()
    if given and place is None:
        return given_python(given, ("core", *groups) if runs_core else groups)
    place = place or paths.Place()
    folder = place.folder or paths.env_folder(root)
    # Without the lock first: the usual case is a complete environment.
    if renew or paths.lacking(folder, root, groups):
        machine.check_length(folder)
        with _locked(folder, progress, stopped) as lock:
            todo = ["core", *groups] if renew else paths.lacking(folder, root, groups)
            if todo:  # no other process has done it meanwhile
                set_up = _SetUp(place._replace(folder=folder), root, progress, lock, stopped)
                try:
                    set_up.carry_out(todo, allow_cuda)
                except OSError as error:  # of our own small files; pip's output reports its own
                    raise SetupError(
                        f"{error.filename or folder} cannot be written "
                        f"({error.strerror or error}).",
                        "Free some space, or change its permissions; then start again.",
                    ) from None
    return paths.env_python(folder)


@contextlib.contextmanager
def _locked(
    folder: Path, progress: Progress, stopped: Callable[[], bool] = lambda: False
) -> Generator[IO[bytes], None, None]:
    """Hold the set-up's lock, which the system releases when its last holder dies."""
    path = folder.with_name(folder.name + ".lock")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        file = path.open("ab")
    except OSError as error:
        raise SetupError(
            f"{path.parent} cannot be written ({error.strerror}).",
            "Change its permissions, or set FANTASIA3D_ENV to another folder.",
        ) from None
    with file:
        reported = False
        while not machine.try_lock(file):
            if not reported:
                progress("Another set-up of the same environment is running; waiting for it.", 0.0)
                reported = True
            time.sleep(POLL_SECONDS)
            _check_stopped(stopped)
        yield file


def _check_stopped(stopped: Callable[[], bool]) -> None:
    if stopped():
        raise SetupError(
            "The set-up was cancelled.", "Nothing of it is left on the disk. Start it again."
        )


class _SetUp:
    """One set-up of ``folder``; ``lock`` is held, and handed on to the children that write."""

    def __init__(
        self,
        place: paths.Place,
        root: Path,
        progress: Progress,
        lock: IO[bytes],
        stopped: Callable[[], bool],
    ) -> None:
        assert place.folder is not None
        self.folder, self.root, self.progress, self.lock = place.folder, root, progress, lock
        self.base, self.stopped = place.python, stopped
        self.wheels = str(place.wheels or os.environ.get("FANTASIA3D_WHEELS") or "")
        if self.wheels and not Path(self.wheels).is_dir():
            raise SetupError(
                f"The wheel folder {self.wheels} does not exist.",
                "Choose another (FANTASIA3D_WHEELS, or the add-on's preferences), or none.",
            )
        self.python = str(paths.env_python(self.folder))
        self.start = time.monotonic()
        self.torch = self._pin_of_torch()  # without the local version until a build is chosen
        self.takes_cuda = False  # whether that is a CUDA build of the registry's
        self.expected = 1.0  # bytes to be written
        self.step, self.fraction = "", 0.0  # the present step, and the fraction done of all

    def carry_out(self, todo: Sequence[str], allow_cuda: bool) -> None:
        """Install the groups ``todo``; all from nothing if ``core`` is among them."""
        fresh, base, gpu = "core" in todo, machine.find_python(self.base), machine.has_nvidia()
        version = machine.version_of(base) if fresh else paths.env_version(self.folder)
        if "blender" in todo and not has_module(self.root, version):
            raise SetupError(f"{NO_MODULE.format(version=version)}.", FIX)
        self.expected = sum(SIZES.get(group, 1e8) for group in todo)
        self.expected += CUDA_SIZE if fresh and (gpu or allow_cuda) else 0
        # Before anything is written; 1.5: until they are unpacked, the downloads need space too.
        machine.check_disk(self.folder, 1.5 * self.expected)
        log = paths.log_file(self.folder)
        check_folder(self.folder)  # before the log is opened, which empties it
        check_log(log)
        self.progress(f"Setting up {' + '.join(todo)} in {self.folder} (log: {log})", 0.0)
        with log.open("w", encoding="utf-8", errors="replace") as self.log:
            try:
                if fresh:
                    self._make_folder(base)
                    self._choose_torch(gpu, allow_cuda)
                self._install(todo)
            except BaseException:
                if fresh and not paths.read_marker(self.folder):
                    remove(self.folder)
                raise
        self.progress(f"The environment is ready ({self._seconds()} s).", 1.0)

    def _make_folder(self, base: Path) -> None:
        remove(self.folder)
        self.folder.mkdir(parents=True)
        (self.folder / paths.BUILDING).touch()
        self._start_step(f"creating a virtual environment from {base}")
        self._run([str(base), *machine.ISOLATED, "-m", "venv", str(self.folder)])
        version = machine.output([*self._isolated(), "-m", "pip", "--version"])
        if pip_version(version) < LEAN_PIP and not self.wheels:
            self._pip_locked(self._tool("pip"))

    def _tool(self, name: str) -> list[str]:
        """The locked requirement of one of the set-up's own tools."""
        return [line for line in locked(self.root, "setup") if package_of(line) == name]

    def _pin_of_torch(self) -> str:
        core = locked(self.root, "core")
        return next((line.split()[0] for line in core if package_of(line) == "torch"), "")

    def _install(self, todo: Sequence[str]) -> None:
        """Install, check and mark the groups; always with the core's pins, so that they stay."""
        extra = ("cuda",) if self.takes_cuda else ()
        self._start_step("collecting packages")
        wanted = locked(self.root, "core", *extra, *todo)
        # Among the builds of one version pip prefers those whose hash its index states: the CUDA
        # build, even if the CPU build is there. So the chosen one is named by its local version.
        wanted = [re.sub(r"^torch==\S+", self.torch, line) for line in wanted]
        # --no-compile: Python compiles what is imported; the rest would be compiled in vain.
        self._pip_locked(wanted, "--no-compile")
        for group in todo:
            self._check(group)
            marker = paths.read_marker(self.folder) or {"python": sys.version, "groups": {}}
            marker["groups"][group] = digest(locked(self.root, group))
            paths.write_marker(self.folder, marker)

    def _check(self, group: str) -> None:
        """Import the packages of ``group`` once."""
        if group not in CHECKS:
            return
        self._start_step(f"checking {group}")
        try:
            self._run([*self._isolated(), "-c", CHECKS[group]])
        except SetupError as error:
            fix = f"On Debian and Ubuntu: apt install {LIBRARIES}." if group == "blender" else ""
            raise SetupError(
                f"The packages of {group} are installed, but do not load: {error.text}",
                f"{fix} {error.fix}".strip(),
            ) from None

    def _choose_torch(self, gpu: bool, allow_cuda: bool) -> None:
        """Install torch's CPU build where pip alone would download gigabytes of unused CUDA.

        On a machine with a GPU for which pip finds a CPU build only, the CUDA build is tried.
        """
        pin = self.torch
        self._start_step("asking pip for torch")
        found = self._resolved(pin)
        self.torch = f"torch=={found['install'][0]['metadata']['version']}"
        cuda = offers_cuda(found, sys.platform)
        self.takes_cuda = cuda and (gpu or allow_cuda)
        if cuda and not self.takes_cuda:
            try:
                self._uv("cpu", self._build("+cpu"))
            except SetupError as error:
                fix = "Set PIP_FIND_LINKS to a folder with the CPU build's wheel, or use the CUDA "
                fix += "build anyway: python3 run.py setup --allow-cuda."
                if "bpy" in sys.modules:
                    fix = "Choose a Wheels Folder that has the CPU build and all other packages."
                raise SetupError(
                    f"This machine has no NVIDIA GPU, pip finds only the CUDA build of {pin} (3 GB "
                    f"to download, 6 GB on disk), and uv cannot fetch the CPU build: {error.text}",
                    f"{fix} The log is {paths.log_file(self.folder)}.",
                ) from None
        elif gpu and not cuda and sys.platform != "darwin":
            try:
                self._fetch_cuda(pin)
            except SetupError as error:
                self._report(f"taking torch's CPU build; no CUDA build: {error}")

    def _resolved(self, pin: str) -> dict[str, Any]:
        """pip's report of the build that it would download for ``pin``."""
        report = self.folder / "report.json"
        # Without the hashes: with them pip downloads the whole build to check it.
        self._pip("install", "--dry-run", "--no-deps", "--quiet", "--report", str(report), pin)
        return json.loads(report.read_text(encoding="utf-8"))

    def _build(self, label: str) -> str:
        """The locked requirement of one of torch's own builds, such as ``+cpu``.

        Raises:
            SetupError: the lock file does not name it.
        """
        found = [line for line in locked(self.root, "torch") if label in line]
        if not found:
            raise SetupError(
                f"the lock file has no hash for a {label} build, and without one none is taken",
                "For your own build of torch make an environment of your own, and name its "
                "interpreter in FANTASIA3D_PYTHON.",
            )
        return found[0]

    def _fetch_cuda(self, pin: str) -> None:
        """Take the CUDA build of the registry, which has one for Linux; or torch's own, by uv."""
        exact = pin.replace("==", "===")  # which +cpu, a later version to pip, does not match
        with contextlib.suppress(SetupError):  # as of a wheel folder with one build alone
            self.takes_cuda = offers_cuda(self._resolved(exact), sys.platform)
        if self.takes_cuda:
            self.torch = exact
            return
        build = self._build("+cu")
        found = re.search(r"\+(cu\d+)", build)
        assert found
        self._uv(found.group(1), build)
        self.takes_cuda = True

    def _uv(self, backend: str, requirement: str) -> None:
        """Install torch through uv, which knows where torch's own builds are."""
        tool = self.folder / "uv"
        self._pip_locked(self._tool("uv"), "--no-deps", "--target", str(tool))
        sources = pip_sources(machine.output([*self._isolated(), "-m", "pip", "config", "list"]))
        if self.wheels:  # instead of the registry, and of torch's index
            sources = {"UV_FIND_LINKS": self.wheels, "UV_OFFLINE": "1"}
        uv = tool / "bin" / ("uv.exe" if sys.platform == "win32" else "uv")
        command = [str(uv), "pip", "install", "--python", self.python, "--torch-backend", backend]
        # uv checks no hash of torch==2.13.0 where it installs 2.13.0+cpu: the lock names the build.
        hashed = ["--require-hashes", "--no-deps"]
        wanted = self._list([requirement])
        # In its own folder: a uv.toml in the user's current one is not for it.
        self._run([*command, *hashed, "-r", wanted], sources, tool)
        self.torch = requirement.split()[0]
        shutil.rmtree(tool)

    def _isolated(self) -> list[str]:
        return [self.python, *machine.ISOLATED]

    def _list(self, requirements: Sequence[str]) -> str:
        """A requirements file with these lines."""
        path = self.folder / "requirements.txt"
        path.write_text("".join(f"{line}\n" for line in requirements), encoding="utf-8")
        return str(path)

    def _pip_locked(self, requirements: Sequence[str], *options: str) -> None:
        """Install these and nothing else: a wheel whose hash is not the lock file's is refused.

        Wheels only: to build a package, pip would fetch build tools that the lock does not name.
        """
        strict = ["--require-hashes", "--only-binary", ":all:"]
        self._pip("install", *strict, *options, "-r", self._list(requirements))

    def _pip(self, verb: str, *args: str) -> None:
        offline = ["--no-index", "--find-links", self.wheels] if self.wheels else []
        head = ["-m", "pip", "--no-input", "--no-color", "--disable-pip-version-check", verb]
        self._run([*self._isolated(), *head, "--progress-bar", "off", *offline, *args])

    def _run(
        self,
        command: Sequence[str],
        environ: dict[str, str] | None = None,
        cwd: Path | None = None,
    ) -> None:
        """Run ``command``: its output goes into the log, its long steps to ``progress``.

        Raises:
            SetupError: it failed; the text names the cause, if its output does.
        """
        self.log.write(f"$ {' '.join(command)}\n")
        keep = () if sys.platform == "win32" else (self.lock.fileno(),)  # if it outlives this one
        try:
            child = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, pass_fds=keep,
                env={**machine.clean_environ(), **(environ or {})}, cwd=cwd,
            )  # fmt: skip
        except OSError as error:
            raise SetupError(
                f"{command[0]} does not run ({error.strerror}).", "Start again."
            ) from None
        with child:
            try:
                last_lines = self._follow(child)
            except BaseException:  # Ctrl-C among them
                child.terminate()
                raise
        if child.returncode:
            raise explain(last_lines, paths.log_file(self.folder))

    def _follow(self, child: subprocess.Popen[bytes]) -> str:
        """The child's last lines; without output, the progress on the disk is reported."""
        lines: queue.Queue[bytes | None] = queue.Queue()

        def read() -> None:
            assert child.stdout
            for line in child.stdout:
                lines.put(line)
            lines.put(None)

        # A thread, because reading a pipe blocks, and a cancel must be noticed meanwhile.
        threading.Thread(target=read, daemon=True).start()
        kept: list[str] = []
        last_output = time.monotonic()
        while True:
            _check_stopped(self.stopped)
            try:
                raw = lines.get(timeout=POLL_SECONDS)
            except queue.Empty:
                if time.monotonic() - last_output > SILENCE:
                    last_output = time.monotonic()
                    self._report(f"{self.step}: {self._seconds()} s so far")
                continue
            last_output = time.monotonic()
            if raw is None:
                return "".join(kept[-LAST_LINES:])
            line = raw.decode("utf-8", "replace")
            self.log.write(line)
            self.log.flush()
            kept.append(line)
            step = step_of(line)
            if step:
                self._start_step(step)

    def _report(self, text: str) -> None:
        """Report a step; the fraction is by the bytes on disk: downloads count once unpacked."""
        written = _size_of(self.folder)
        self.fraction = max(self.fraction, min(0.95, written / self.expected))
        self.progress(text, self.fraction)

    def _start_step(self, step: str) -> None:
        self.step = step
        self._report(step)

    def _seconds(self) -> int:
        return round(time.monotonic() - self.start)


def _size_of(folder: Path) -> int:
    """Bytes in ``folder``, into which pip writes meanwhile: what has gone again counts nothing."""
    size = 0
    for place, _, names in os.walk(folder):
        for name in names:
            with contextlib.suppress(OSError):
                # A link to the base Python is not written here.
                size += Path(place, name).lstat().st_size
    return size
