"""The lock file: every package that the set-up may install, with its version and its hashes.

``requirements.lock`` is next to pyproject.toml and is made from it by ``.ci/lock.py``. It is a
requirements file of pip's with sections; a section holds what its group needs beyond the core's,
transitive requirements included:

* ``core``, ``blender``, ``ray``, ``test``, ``setup``: the groups of pyproject.toml;
* ``cuda``: what torch's CUDA build alone requires;
* ``torch``: builds of torch that the registry does not have, under their local versions.

The requirement of torch in ``core`` carries the hashes of all its builds. pip ignores the hashes of
a constraints file for what is named without one, so pip is given whole sections as requirements.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

from .machine import SetupError

NAME = "requirements.lock"
SECTION = re.compile(r"# \[(\w+)\]")
MARKER = re.compile(r" *python_version (<|==|>=) '(\d+)\.(\d+)' *")  # of pyproject.toml's pins


def read_lock(root: Path) -> dict[str, list[str]]:
    """The requirements of each section, each on one line: ``name==1.0 ; marker --hash=...``.

    Raises:
        SetupError: there is no lock file.
    """
    try:
        text = (root / NAME).read_text(encoding="utf-8")
    except OSError:
        raise SetupError(
            f"There is no {NAME} in {root}.", "Install the whole package again."
        ) from None
    sections: dict[str, list[str]] = {}
    lines: list[str] = []
    for line in text.replace("\\\n", " ").splitlines():
        head = SECTION.match(line)
        if head:
            lines = sections.setdefault(head.group(1), [])
        elif line and not line.startswith("#"):
            lines.append(" ".join(line.split()))
    return sections


def locked(root: Path, *names: str) -> list[str]:
    """The requirements of these sections, each once; a section that is not there is empty."""
    sections = read_lock(root)
    return list(dict.fromkeys(line for name in names for line in sections.get(name, [])))


def locked_digest(root: Path, *names: str) -> str:
    """The :func:`digest` of these sections, read again only where the file was written again.

    A panel asks for it at each drawing.

    Raises:
        SetupError: there is no lock file.
    """
    try:
        written = (root / NAME).stat()
    except OSError:
        return digest(locked(root, *names))  # which reports it
    return _digest_at(root, names, (written.st_mtime_ns, written.st_size))


@lru_cache(maxsize=16)
def _digest_at(root: Path, names: tuple[str, ...], _written: tuple[int, int]) -> str:
    return digest(locked(root, *names))


def package_of(requirement: str) -> str:
    """The package's name in a requirement: ``torch`` of ``torch==2.13.0 --hash=...``."""
    found = re.match(r"[\w.-]*\w", requirement)
    return found.group() if found else ""


def applies(pin: str, version: str) -> bool:
    """Whether a pin of pyproject.toml is for the Python of ``version``, such as ``3.11``.

    Raises:
        ValueError: its marker is of another form than MARKER.
    """
    _, semicolon, marker = pin.partition(";")
    if not semicolon:
        return True
    found = MARKER.fullmatch(marker)
    if not found:
        raise ValueError(f"The marker of {pin!r} is not python_version <, == or >= 'X.Y'.")
    sign, limit = found[1], (int(found[2]), int(found[3]))
    ours = tuple(map(int, version.split(".")))
    return {"<": ours < limit, "==": ours == limit, ">=": ours >= limit}[sign]


def digest(lines: Sequence[str]) -> str:
    """A short hash of requirements, for the folder's name and the marker."""
    return hashlib.sha256("\n".join(sorted(lines)).encode()).hexdigest()[:12]
