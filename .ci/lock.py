"""Make requirements.lock from pyproject.toml: every package, transitive ones too, with its hashes.

    python3 .ci/lock.py [--upgrade]

Python 3.11 or newer with pip, and the registry. Versions that the present lock file names are kept
unless --upgrade is given. uv resolves for all systems at once; only metadata is downloaded, and uv
itself. The builds that torch has in an index of its own (BUILDS) are asked for there; where it
cannot be reached, wheels in pip's find-links folders are hashed, and hashes that the present lock
file has for the same version are kept.
"""

from __future__ import annotations

import hashlib
import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from fantasia3d_addon.environment import lock_file, machine  # noqa: E402
from fantasia3d_addon.environment.files import write_text  # noqa: E402
from fantasia3d_addon.environment.pip_output import pip_sources  # noqa: E402

BUILDS = ("cpu", "cu130")  # cu130: the CUDA that the registry's own Linux build of 2.13 is for
OLDEST = min(machine.PYTHONS)  # uv then resolves for this one and all newer ones
CUDA = ("nvidia-", "cuda-", "triton")  # what torch requires for CUDA alone
HASH = re.compile(r"--hash=(sha256:[0-9a-f]{64})")
HEAD = """# Every package that the set-up may install, with the hashes of its files on every system.
# Made by: python3 .ci/lock.py   Do not edit. Sections: fantasia3d_addon/environment/lock_file.py
# pins: {pins}
"""


def main() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    groups = {"core": project["dependencies"], **project["optional-dependencies"]}
    with tempfile.TemporaryDirectory() as temporary:
        uv = install_uv(Path(temporary), groups["setup"])
        text = resolve(uv, Path(temporary))
        sections = split(text, groups)
        sections["torch"] = add_builds(uv, Path(temporary), sections["core"])
    write(sections, [pin for pins in groups.values() for pin in pins])


def install_uv(folder: Path, pins: Iterable[str]) -> Path:
    """The pinned uv, installed into ``folder``."""
    pin = next(pin for pin in pins if pin.startswith("uv=="))
    head = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*head, "--no-deps", "--target", str(folder / "uv"), pin], check=True)
    return folder / "uv" / "bin" / "uv"


def resolve(uv: Path, folder: Path) -> str:
    """uv's resolution of all groups together, so that their versions agree."""
    out = folder / "all.txt"
    if (ROOT / lock_file.NAME).exists():  # whose versions uv then prefers
        present = lock_file.read_lock(ROOT)
        lines = [line for name in present if name != "torch" for line in present[name]]
        out.write_text("\n".join(dict.fromkeys(lines)) + "\n", encoding="utf-8")
    command = [uv, "pip", "compile", "pyproject.toml", "--all-extras", "--universal"]
    command += ["--python-version", OLDEST, "--generate-hashes", "--no-header"]
    command += ["--only-binary", ":all:", "--annotation-style", "line", "-o", out, *sys.argv[1:]]
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    return out.read_text(encoding="utf-8")


def split(text: str, groups: dict[str, list[str]]) -> dict[str, list[str]]:
    """The requirements of each section, from uv's notes of what requires what."""
    entries: dict[str, list[str]] = {}
    required: dict[str, set[str]] = {}  # by each package
    for block in re.split(r"^(?=[a-z])", text, flags=re.MULTILINE)[1:]:
        requirement, _, parents = block.partition("    # via ")
        if "sys_platform == 'emscripten'" in requirement:  # torch does not run there
            continue
        name = lock_file.package_of(requirement)
        entries.setdefault(name, []).append(requirement)
        for parent in parents.strip().split(", "):
            required.setdefault(parent, set()).add(name)
    cuda = {name for name in required["torch"] if name.startswith(CUDA)}
    required["torch"] -= cuda
    names = {
        group: closure(map(lock_file.package_of, pins), required) for group, pins in groups.items()
    }
    names["cuda"] = closure(cuda, required)
    # Every group is installed on top of the core.
    parts = {part: found - names["core"] for part, found in names.items() if part != "core"}
    parts = {"core": names["core"], **parts}
    return {part: [e for n in sorted(found) for e in entries[n]] for part, found in parts.items()}


def closure(roots: Iterable[str], required: dict[str, set[str]]) -> set[str]:
    """All that ``roots`` require, themselves included."""
    found: set[str] = set()
    todo = [re.sub(r"[-_.]+", "-", name).lower() for name in roots]
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo += required.get(name, ())
    return found


def add_builds(uv: Path, folder: Path, core: list[str]) -> list[str]:
    """The requirements of torch's own builds, whose hashes ``core``'s torch then accepts too."""
    at, torch = next((i, e) for i, e in enumerate(core) if e.startswith("torch=="))
    pin = torch.split()[0]
    sources = pip_sources(machine.output([sys.executable, "-m", "pip", "config", "list"]))
    wheels = [Path(place) for place in sources.get("UV_FIND_LINKS", "").split(",") if place]
    present = lock_file.locked(ROOT, "torch") if (ROOT / lock_file.NAME).exists() else []
    builds = {}
    for label in BUILDS:
        found = {
            hash
            for line in present
            if line.startswith(f"{pin}+{label} ")
            for hash in HASH.findall(line)
        }
        found |= indexed(uv, folder, f"{pin}+{label}", label)
        for path in (
            path
            for place in wheels
            for path in place.glob(f"{pin.replace('==', '-')}+{label}-*.whl")
        ):
            found.add("sha256:" + hashlib.sha256(path.read_bytes()).hexdigest())
        if found:
            builds[label] = found
    every = set(HASH.findall(torch)).union(*builds.values())
    core[at] = entry(torch.partition(" \\\n")[0], every)
    return [entry(f"{pin}+{label}", found) for label, found in builds.items()]


def indexed(uv: Path, folder: Path, pin: str, backend: str) -> set[str]:
    """The hashes that torch's own index has for a build; none where it cannot be reached."""
    (folder / "torch.in").write_text(pin + "\n", encoding="utf-8")
    command = [uv, "pip", "compile", "torch.in", "--no-deps", "--universal", "--generate-hashes"]
    command += ["--python-version", OLDEST, "--torch-backend", backend, "--quiet"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        print(f"{pin}: torch's own index has no answer; hashes that are here are kept.")
    return set(HASH.findall(done.stdout))


def entry(requirement: str, hashes: Iterable[str]) -> str:
    """A requirement with its hashes, as uv writes one."""
    return " \\\n".join([requirement, *(f"    --hash={hash}" for hash in sorted(hashes))]) + "\n"


def write(sections: dict[str, list[str]], pins: Iterable[str]) -> None:
    """Write the lock file, in one step."""
    text = HEAD.format(pins=lock_file.digest(list(pins)))
    for name, entries in sections.items():
        text += f"\n# [{name}]\n" + "".join(entries)
    write_text(ROOT / lock_file.NAME, text)
    print(f"{lock_file.NAME}: {', '.join(f'{len(e)} {name}' for name, e in sections.items())}")


if __name__ == "__main__":
    main()
