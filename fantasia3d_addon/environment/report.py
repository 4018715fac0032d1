"""``run.py doctor --report FILE``: what a maintainer needs to know, and nothing private.

The text is put together from facts that are chosen here, and then redacted: prompts are never read
into it, and names, paths, addresses and secrets that are in a log or a message are replaced.
"""

from __future__ import annotations

import getpass
import json
import os
import platform
import re
import sys
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, cast

from . import machine, paths
from .doctor import Line
from .files import expanded
from .given import named_python
from .lock_file import digest, locked, package_of, read_lock
from .machine import SetupError

KEY, VERSION = "fantasia3d_report", 1
LOG_LINES, RUNS = 40, 5  # of the set-up's log; the latest runs
NUMBERS = ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS", "CUDA_VISIBLE_DEVICES")  # values that matter
NAMES = ("FANTASIA3D_", "PIP_", "UV_", "HF_", "PYTHON", "TORCH_", "CUDA_", "XDG_", "BLENDER_")
SECRET = re.compile(r"TOKEN|SECRET|PASS|KEY|CREDENTIAL|AUTH|COOKIE|PRIVATE|SESSION", re.IGNORECASE)
FIELDS = (
    "command", "preset", "seed", "device", "guide_strength", "uv", "texture_size", "max_faces",
    "ignore_unknown_words", "settings", "version",
)  # fmt: skip  # of job.json
FILE_FIELDS = ("guidance", "guide_mesh", "mesh", "base_color", "light")  # or a name
# Where jobs/paths.py has the panel's runs, of an extension and of a plain module.
PANEL_RUNS = ("*/extensions/.user/*/fantasia3d/runs", "*/datafiles/fantasia3d/runs")
PRIVATE_FIELDS = ("prompt", "negative_prompt")
MAX_BYTES = 256 << 20  # of a log or a run's events
SYSTEM = ("/usr/", "/bin/", "/lib", "/opt/", "/etc/ssl", "/proc/", "/dev/null")
ADDRESS = re.compile(r"\b[a-z][a-z0-9+.-]*://\S+", re.IGNORECASE)
MAIL = re.compile(r"[\w.+-]+@[\w-]+\.[\w.-]+")
IP = re.compile(r"(?<![\w.=-])\d{1,3}(?:\.\d{1,3}){3}(?![\w.])")  # or a version of four parts
# To the end of the phrase: a name in a path may have spaces.
PATH = re.compile(
    r"(?<![\w<>./-])(?:[A-Za-z]:[\\/]|\\\\|/)[^'\"`<>|;,()\[\]\n]*?(?=\. |: |['\"`<>|;,()\[\]\n]|$)"
)
PACKAGES = """import importlib.metadata as m
print("\\n".join(sorted(f"{d.metadata['Name']}=={d.version}" for d in m.distributions())))"""


def write_report(file: Path, root: Path, lines: Sequence[Line]) -> Path:
    """Write the report with the findings ``lines`` to ``file``, whole or not at all.

    Raises:
        SetupError: ``file`` is something else than an earlier report, or cannot be written.
    """
    file = expanded(file, SetupError).absolute()
    if os.path.exists(file) and not _is_report(file):  # noqa: PTH110 - a name may be too long
        raise SetupError(
            f"{file} exists and is not a report of this project.", "Name another file."
        )
    text = json.dumps(facts(root, lines), indent=1, ensure_ascii=False) + "\n"
    # Half a surrogate pair, as of a job.json or of a path that is not text, as JSON has it.
    text = text.encode(errors="backslashreplace").decode()
    name = None
    try:
        # A name of its own: nothing of the user's has it.
        with tempfile.NamedTemporaryFile(
            "w", encoding="utf-8", dir=str(file.parent), prefix=".fantasia3d-", delete=False
        ) as temporary:
            name = Path(temporary.name)
            temporary.write(text)
        name.replace(file)
    except OSError as error:
        if name:
            name.unlink(missing_ok=True)
        raise SetupError(
            f"{file} cannot be written ({error.strerror}).", "Name a file in a folder of yours."
        ) from None
    return file


def _is_report(file: Path) -> bool:
    if not file.is_file():  # to read a pipe would wait for its writer forever
        return False
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(found, dict) and KEY in found


def facts(root: Path, lines: Sequence[Line]) -> dict[str, Any]:
    """The report, redacted."""
    folder = paths.env_folder(root)
    python = named_python() or str(paths.env_python(folder))
    found = {
        KEY: VERSION,
        "project": {
            "version": _version(root),
            "lock": digest(locked(root, "core", "blender", "test")),
        },
        "system": {
            "platform": platform.platform(),
            "machine": platform.machine(),
            "python": sys.version.replace("\n", " "),
            "cores": os.cpu_count(),
            "memory_gb": _memory(),
            "encoding": sys.getfilesystemencoding(),
            "blender": "bpy" in sys.modules,
        },
        "variables": _variables(),
        "environment": {
            "groups": paths.read_marker(folder).get("groups", {}),
            "packages": _packages(root, python),
        },
        "checks": [line._asdict() for line in lines if line.name != "Stable Diffusion"],
        "setup_log": _last_lines(paths.log_file(folder)),
        "runs": [_run(path) for path in _latest_runs()],
    }
    return Redaction(root, folder).of(found)


def _packages(root: Path, python: str) -> list[str]:
    """The installed packages of the lock file; others are private."""
    names = {package_of(line) for lines in read_lock(root).values() for line in lines}
    found = machine.output([python, *machine.ISOLATED, "-c", PACKAGES]).splitlines()
    return [line for line in found if re.sub(r"[-_.]+", "-", package_of(line)).lower() in names]


def _version(root: Path) -> str:
    found = re.search(r'^version = "(.+)"', (root / "pyproject.toml").read_text("utf-8"), re.M)
    return found.group(1) if found else ""


def _memory() -> float | None:
    try:
        return round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1e9, 1)
    except (AttributeError, ValueError, OSError):  # Windows
        return None


def _variables() -> dict[str, str]:
    """The variables that matter: that they are set, and numbers themselves."""
    named = [name for name in sorted(os.environ) if name.startswith(NAMES) or name in NUMBERS]
    return {
        name: os.environ[name] if name in NUMBERS else "set"
        for name in named
        if not SECRET.search(name)
    }


def _last_lines(log: Path) -> list[str]:
    try:
        if log.stat().st_size > MAX_BYTES:
            return []
        return log.read_text(encoding="utf-8", errors="replace").splitlines()[-LOG_LINES:]
    except OSError:
        return []


def _latest_runs() -> list[Path]:
    """The run folders of the add-on, and those in the current folder's ``out``."""
    blender = _blender_folder()
    panels = [runs for form in PANEL_RUNS for runs in blender.glob(form)]
    places = (paths.data_folder() / "runs", *panels, Path("out"))
    found = [file for place in places for file in place.glob("*/job.json")]
    return [file.parent for file in sorted(found, key=_time, reverse=True)[:RUNS]]


def _blender_folder() -> Path:
    """Where Blender keeps what is a user's own, in a folder for each version."""
    if sys.platform == "win32":
        return Path(os.environ.get("APPDATA") or Path.home(), "Blender Foundation", "Blender")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "Blender"
    return Path(os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config") / "blender"


def _time(file: Path) -> float:
    try:
        return file.stat().st_mtime
    except OSError:  # removed meanwhile
        return 0.0


def _run(folder: Path) -> dict[str, Any]:
    """A run's settings and how it ended; not its name, which is the prompt's."""
    jobs = _objects(folder / "job.json", whole=True)
    job = jobs[0] if jobs else {}
    private = [str(job.get(key) or "") for key in (*PRIVATE_FIELDS, *FILE_FIELDS)]
    private += [str(path) for key in ("loras", "embeddings") for path in _each(job.get(key))]
    events = [event for event in _objects(folder / "events.jsonl") if "type" in event]
    failures = [event for event in events if event["type"] in ("warning", "error")]
    return {
        "job": {
            **{key: job[key] for key in FIELDS if key in job},
            **{key: _kind_of_file(str(job.get(key) or "")) for key in FILE_FIELDS},
        },
        "failures": [_without(event, private) for event in failures[-3:]],
        "ended": next((e["type"] for e in reversed(events) if e["type"] != "progress"), ""),
        "log": [_without(line, private) for line in _errors(_last_lines(folder / "log.txt"))],
    }


def _each(value: object) -> list[object]:
    if isinstance(value, dict):
        value = list(cast("dict[object, object]", value))
    return list(cast("list[object]", value)) if isinstance(value, list) else []


def _kind_of_file(text: str) -> str:
    """A name of ours as it is, a file's or a model's as its ending alone."""
    return text if text.isidentifier() or not text else f"<file>{Path(text).suffix}"


def _objects(file: Path, whole: bool = False) -> list[dict[str, Any]]:
    """The JSON objects of a file: one, or one in each line; what is none is left out."""
    try:
        if file.stat().st_size > MAX_BYTES:
            return []
        text = file.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return []
    found: list[dict[str, Any]] = []
    for part in [text] if whole else text.splitlines():
        try:
            data = json.loads(part)
        except (ValueError, RecursionError):
            continue
        if isinstance(data, dict):
            found.append(cast("dict[str, Any]", data))
    return found


def _errors(lines: Iterable[str]) -> list[str]:
    """The lines of a traceback, and those that name an error."""
    form = re.compile(r'^(Traceback|\s+File "|\w*(Error|Exception)\b|error:|Fatal|Current thread)')
    return [line for line in lines if form.match(line)][-20:]


def _without(value: Any, texts: Iterable[str]) -> Any:
    """``value`` without what it quotes, and without the longer words of ``texts``."""
    if isinstance(value, dict):
        entries = cast("dict[str, Any]", value)
        return {key: _without(item, texts) for key, item in entries.items()}
    if not isinstance(value, str):
        return value
    value = re.sub(r"'[^']*'|\"(?!/)[^\"/\\]*\"|“[^”]*”", "'…'", value)
    words = {word for text in texts for word in re.findall(r"[^\W_]{3,}", text)}
    for word in sorted(words, key=len, reverse=True):
        value = re.sub(rf"\b{re.escape(word)}", "…", value, flags=re.IGNORECASE)
    return value


class Redaction:
    """Replaces text that identifies the user or the machine."""

    def __init__(self, root: Path, folder: Path) -> None:
        home = Path.home()
        # Of these two the rest of a path may stay: it is ours.
        self.ours = _forms({root: "<project>", folder: "<environment>"})
        self.places = _forms({paths.data_folder(): "<data>", home: "<home>"})
        host = platform.node()
        self.names = {_user(), home.name, host, host.partition(".")[0]}
        self.secrets = {
            value for name, value in os.environ.items() if SECRET.search(name) and len(value) > 3
        }

    def of(self, value: Any) -> Any:
        """``value`` with every text in it redacted."""
        if isinstance(value, dict):
            entries = cast("dict[str, Any]", value)
            return {key: self.of(item) for key, item in entries.items()}
        if isinstance(value, list):
            return [self.of(item) for item in cast("list[Any]", value)]
        return self.text(value) if isinstance(value, str) else value

    def text(self, text: str) -> str:
        """``text`` without secrets, addresses, paths and names."""
        for secret in self.secrets:
            text = text.replace(secret, "<secret>")
        for form, name in ((ADDRESS, "<address>"), (MAIL, "<mail>"), (IP, "<address>")):
            text = form.sub(name, text)
        for path, name in self.ours:
            text = text.replace(path, name)
        text = PATH.sub(_path, text)
        for path, name in self.places:  # where the form above was not seen, as in -I/home/...
            text = text.replace(path, name)
        for name in self.names:
            if len(name) > 1:
                text = re.sub(rf"(?<!\w){re.escape(name)}(?!\w)", "<name>", text, flags=re.I)
        return text


def _forms(places: dict[Path, str]) -> list[tuple[str, str]]:
    """Each path in each way it may be written, the longest first, with its name."""
    found = {
        form: name
        for path, name in places.items()
        for form in (str(path), os.path.realpath(str(path)), path.as_posix())
        if len(form) > 1  # the home of a container may be /
    }
    return sorted(found.items(), key=lambda item: -len(item[0]))


def _path(found: re.Match[str]) -> str:
    """The system's own programs stay; another path goes, and what follows it in the phrase."""
    first, space, rest = found.group().partition(" ")
    if first.startswith(SYSTEM):
        return first + space + PATH.sub(_path, rest)
    return "<path>"


def _user() -> str:
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):  # no such user on this system
        return ""
