"""Parses the output of pip and uv: their steps, their reports, and why they failed."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from .machine import SetupError

LARGE = 5.0  # MB; smaller downloads are not reported

# What pip, urllib3 and uv print when the registry cannot be reached.
NETWORK = re.compile(
    r"NewConnectionError|NameResolutionError|Temporary failure in name resolution|"
    r"Failed to establish a new connection|getaddrinfo failed|Name or service not known|"
    r"ConnectTimeoutError|ReadTimeoutError|Read timed out|ProxyError|SSLError|"
    r"Connection refused|Connection reset|Connection broken|Network is unreachable|"
    r"IncompleteRead|error sending request|dns error"
)
DISK = re.compile(r"No space left on device|Errno 28|not enough space on the disk|Disk quota")
# A folder of wheels that is not there; pip only warns of it, and does not find the package then.
NO_FOLDER = re.compile(r"Location '([^']+)' is ignored: it is either a non-existing path")
# pip's and uv's words for a file that is not the locked one; the file's address or name follows.
MISMATCH = re.compile(
    r"DO NOT MATCH THE HASHES.*?\n +(?:\S+ from )?(?P<pip>\S+)|Hash mismatch for `(?P<uv>[^`]+)`",
    re.DOTALL,
)
# pip's words for a package that the lock file does not name at all.
UNLOCKED = re.compile(
    r"(?:versions pinned with ==\. These do not|Hashes are required.*?):?\n +(\S+)"
)
NO_MATCH = re.compile(r"No matching distribution found for (\S+)")


def step_of(line: str) -> str:
    """The step to report for a line of pip's output; empty for most lines."""
    fetched = re.match(r"\s*Downloading (?:\S*/)?(\S+) \(([\d.]+) ([MG])B\)", line)
    if fetched:
        file, size, unit = fetched.groups()
        large = float(size) * (1000 if unit == "G" else 1) >= LARGE
        return f"downloading {' '.join(file.split('-')[:2])} ({size} {unit}B)" if large else ""
    if line.startswith("Installing collected packages:"):
        return f"unpacking {line.count(',') + 1} packages"
    return ""


def offers_cuda(report: dict[str, Any], platform: str) -> bool:
    """Whether the torch of a pip report is a CUDA build on ``platform`` (sys.platform)."""
    found = report["install"][0]["metadata"]
    if "+cu" in found["version"]:
        return True
    needs = [need for need in found.get("requires_dist", []) if "extra ==" not in need]
    # Only the CUDA builds require NVIDIA's packages; the registry does not mark them otherwise.
    brings = any(need.startswith(("nvidia-", "cuda-")) for need in needs)
    return brings and platform.startswith("linux")


def pip_version(text: str) -> tuple[int, ...]:
    """The version in the output of ``pip --version``: (23, 2)."""
    found = re.match(r"pip (\d+)\.(\d+)", text)
    return tuple(int(n) for n in found.groups()) if found else (0, 0)


def pip_sources(config: str) -> dict[str, str]:
    """uv's variables for the indexes and wheel folders in the output of ``pip config list``."""
    names = {
        "find-links": "UV_FIND_LINKS",
        "index-url": "UV_DEFAULT_INDEX",
        "extra-index-url": "UV_INDEX",
    }
    found: dict[str, str] = {}
    for line in config.splitlines():
        key, equals, value = line.partition("=")
        name = names.get(key.rpartition(".")[2])
        if equals and name:
            # pip prints the value as a Python string, with several sources on lines of their own.
            words = str(ast.literal_eval(value)).split()
            found[name] = (" " if name == "UV_INDEX" else ",").join(words)
    return found


def explain(text: str, log: Path) -> SetupError:
    """The failure of a command as a sentence with its fix; ``text`` is its last output."""
    if DISK.search(text):
        return SetupError(
            "The disk filled up during the set-up.",
            "Free some space, or set FANTASIA3D_ENV to a folder on another disk (and for "
            f"temporary files TMPDIR); then start again. The log is {log}.",
        )
    if NETWORK.search(text):
        return SetupError(
            "The package registry cannot be reached.",
            "Check the network and pip's configuration (pip config list), or set "
            f"FANTASIA3D_WHEELS to a folder of wheels; then start again. The log is {log}.",
        )
    folder = NO_FOLDER.search(text)
    if folder:
        return SetupError(
            f"The wheel folder {folder.group(1)} does not exist.",
            f"Correct pip's find-links or FANTASIA3D_WHEELS; then start again. The log is {log}.",
        )
    refused = _refusal(text, log)
    if refused:
        return refused
    missing = NO_MATCH.search(text)
    if missing:
        return SetupError(
            f"There is no package {missing.group(1)} for this system and Python, in the folder of "
            "wheels where one is set, else in the registry.",
            "Add its wheel to the folder (FANTASIA3D_WHEELS, or pip's find-links), or use another "
            f"Python. The log is {log}.",
        )
    lines = [line.strip() for line in text.splitlines() if line.strip()] or ["no output"]
    # The last line that reads as an error, or else the last line.
    errors = [line for line in lines if re.match(r"(ERROR|\w*Error)\b", line)]
    return SetupError(
        f"A step of the set-up failed ({(errors or lines)[-1]}).", f"The log is {log}."
    )


def _refusal(text: str, log: Path) -> SetupError | None:
    """The sentence for a package that is not the lock file's, if ``text`` reports one."""
    own = (
        "If it is from a folder of wheels or an index of yours, put the publisher's file there, or "
        "use an environment of your own (FANTASIA3D_PYTHON)"
    )
    other = MISMATCH.search(text)
    if other:
        name = unquote((other.group("pip") or other.group("uv")).partition("#")[0])
        return SetupError(
            f"{name.rpartition('/')[2]} is not the file that the lock file names (another hash).",
            f"{own}; if it is from the registry, it was damaged or changed on its way: try again, "
            f"and report it if that happens twice. The log is {log}.",
        )
    unknown = UNLOCKED.search(text)
    if unknown:
        return SetupError(
            f"{unknown.group(1)} is required, and the lock file does not name it: another build of "
            "a package was found than those that it was made from.",
            f"{own}. The log is {log}.",
        )
    return None
