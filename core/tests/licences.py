"""The licences of everything in the lock file: ``run.py python -m core.tests.licences``.

Writes docs/licences.md. A licence is what the installed package itself declares; BY_HAND holds
those of packages that declare none in a readable form, are for other systems, or belong to ``ray``,
which need not be installed where this runs (as their wheels declare them).
"""

import importlib.metadata
import re
from pathlib import Path
from typing import NamedTuple

from core.io.atomic import atomic_file
from fantasia3d_addon.environment.lock_file import read_lock

ROOT = Path(__file__).parents[2]
TABLE = ROOT / "docs" / "licences.md"
# Each may be used together with GPL-3.0-or-later, this project's own licence.
ALLOWED = {
    "Apache-2.0", "Apache-2.0 WITH LLVM-exception", "BSD", "BSD-2-Clause", "BSD-3-Clause",
    "BSL-1.0", "CNRI-Python", "GPL-3.0", "ISC", "MIT", "MIT-CMU", "MPL-2.0", "PSF-2.0",
}  # fmt: skip
# Not free, and not part of this project: the drivers' libraries, which torch's CUDA build requires.
# They are fetched by the user, on a machine with an NVIDIA GPU or at their request.
ALLOWED_FOR_CUDA = {"NVIDIA"}
SPDX = {  # other names of the same licences
    "Apache": "Apache-2.0",
    "Apache 2.0": "Apache-2.0",
    "Apache 2.0 License": "Apache-2.0",
    "Apache Software License": "Apache-2.0",
    "BSD License": "BSD",
    "ISC License": "ISC",
    "MIT License": "MIT",
    "Mozilla Public License 2.0 (MPL 2.0)": "MPL-2.0",
}
BY_HAND = {
    "attrs": "MIT",
    "cattrs": "MIT",  # bpy 5.2's, for Python 3.13
    "colorama": "BSD-3-Clause",
    "cuda-bindings": "NVIDIA",
    "cuda-pathfinder": "Apache-2.0",
    "cuda-toolkit": "NVIDIA",
    "embreex": "BSD-2-Clause",  # its licence file; Embree itself, in its wheel, is Apache-2.0
    "jsonschema": "MIT",
    "jsonschema-specifications": "MIT",
    "msgpack": "Apache-2.0",
    "openexr": "BSD-3-Clause",
    "protobuf": "BSD-3-Clause",
    "ray": "Apache-2.0",
    "referencing": "MIT",
    "rpds-py": "MIT",
    "triton": "MIT",
    "uv": "Apache-2.0 OR MIT",
    "xatlas": "MIT",
}
HEAD = """# Licences of what is installed

Made by `run.py python -m core.tests.licences` from the lock file and what the packages declare. A
test compares it, and every licence with a list of those that go together with this project's
GPL-3.0-or-later. None of these packages is in the extension's zip: the set-up fetches them.
`cuda` is installed with torch's CUDA build alone; NVIDIA's libraries are not free software.

| package | version | licence | installed for |
|---|---|---|---|
"""


def licence(name: str) -> str:
    """The licence of a package; empty where nothing is known of it."""
    if name in BY_HAND:
        return BY_HAND[name]
    if name.startswith("nvidia-"):
        return "NVIDIA"
    try:
        declared = importlib.metadata.metadata(name)
    except importlib.metadata.PackageNotFoundError:
        return ""
    fields = [declared["License-Expression"], declared["License"]]
    # A field may hold the whole text of the licence.
    named = [text for text in fields if text and "\n" not in text and len(text) < 120]
    for classifier in declared.get_all("Classifier", []):
        if classifier.startswith("License :: OSI Approved :: "):
            named.append(classifier.rpartition(" :: ")[2])
    return SPDX.get(named[0], named[0]) if named else ""


def refused(expression: str, section: str) -> set[str]:
    """The parts of a licence expression that are not allowed in a section of the lock file."""
    allowed = ALLOWED | (ALLOWED_FOR_CUDA if section == "cuda" else set())
    parts = re.split(r" AND | OR ", re.sub(r"[()]", "", expression))
    return {part for part in parts if part not in allowed}


class Row(NamedTuple):
    """A line of the table; no ``licence`` where it is not known."""

    name: str
    version: str
    licence: str
    section: str


def rows() -> list[Row]:
    """Each package in each section of the lock file."""
    found = []
    for section, lines in read_lock(ROOT).items():
        if section != "torch":  # builds of what is in "core"
            for line in lines:
                name, _, version = line.split()[0].partition("==")
                found.append(Row(name, version, licence(name), section))
    return sorted(found)


def text() -> str:
    """The page."""
    return HEAD + "".join(f"| {' | '.join(row)} |\n" for row in rows())


if __name__ == "__main__":
    with atomic_file(TABLE) as path:
        path.write_text(text(), encoding="utf-8")
