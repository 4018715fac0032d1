"""The lock file: it fits pyproject.toml, names everything with hashes."""

import importlib.metadata
import re
import sys
import tomllib
from pathlib import Path

import pytest

import run
from run import environment

lock_file = sys.modules[environment.locked.__module__]
ROOT = Path(run.__file__).parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
GROUPS = {"core": PROJECT["dependencies"], **PROJECT["optional-dependencies"]}
TEXT = (ROOT / lock_file.NAME).read_text(encoding="utf-8")
SECTIONS = environment.read_lock(ROOT)
EVERY = [line for lines in SECTIONS.values() for line in lines]
FIX = "run: python3 .ci/lock.py"


def canonical(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def names(*sections: str) -> set[str]:
    return {lock_file.package_of(line) for section in sections for line in SECTIONS[section]}


def test_it_was_made_from_these_pins():
    pins = [pin for group in GROUPS.values() for pin in group]
    assert f"\n# pins: {lock_file.digest(pins)}\n" in TEXT, FIX


@pytest.mark.parametrize("group", GROUPS)
def test_it_names_every_pin_of_a_group_at_its_version(group):
    locked = {line.split()[0] for name in {"core", group} for line in SECTIONS[name]}
    for pin in GROUPS[group]:
        name, _, version = pin.partition(";")[0].strip().partition("==")
        assert f"{canonical(name.partition('[')[0])}=={version}" in locked, FIX


@pytest.mark.parametrize("python", environment.PYTHONS)
def test_each_python_has_each_package_once_and_blenders_module_where_there_is_a_wheel(python):
    """What pip is given for this one, by packaging's reading of the lock file's markers."""
    from packaging.requirements import Requirement

    system = {"python_version": python, "python_full_version": f"{python}.9"}
    found = {}
    for group in ("core", "blender", "test"):
        for line in SECTIONS[group]:
            need = Requirement(line.partition(" --hash")[0])
            if need.marker is None or need.marker.evaluate(system):
                assert found.setdefault(need.name, str(need.specifier)) == str(need.specifier)
    pins = [pin for group in ("core", "blender", "test") for pin in GROUPS[group]]
    for pin in pins:
        name, _, version = pin.partition(";")[0].partition("==")
        name = canonical(name.partition("[")[0])
        same = found.get(name) == f"=={version.strip()}"
        assert same == lock_file.applies(pin, python), pin
    modules = {"3.11": "==4.5.15", "3.13": "==5.2.3"}
    assert found.get("bpy") == modules.get(python)


def test_the_pythons_are_those_that_the_project_names():
    from packaging.specifiers import SpecifierSet

    allowed = SpecifierSet(PROJECT["requires-python"])
    near = [f"3.{minor}" for minor in range(8, 20)]
    assert {version for version in near if f"{version}.5" in allowed} == set(environment.PYTHONS)
    assert all(version in environment.ANY_PYTHON for version in environment.PYTHONS)


@pytest.mark.parametrize(
    ("pin", "version", "truth"),
    [
        ("numpy==1", "3.12", True),
        ("numpy==1; python_version < '3.13'", "3.12", True),
        ("numpy==1; python_version < '3.13'", "3.13", False),
        ("numpy==1; python_version < '3.9'", "3.13", False),
        ("numpy==1 ; python_version >= '3.9'", "3.13", True),
        ("bpy==4.5.15; python_version == '3.11'", "3.11", True),
        ("bpy==4.5.15; python_version == '3.11'", "3.12", False),
    ],
)
def test_a_pin_applies_to_the_pythons_of_its_marker(pin, version, truth):
    assert lock_file.applies(pin, version) is truth


def test_a_marker_of_another_form_is_refused():
    with pytest.raises(ValueError, match="marker of"):
        lock_file.applies("pywin32==1; sys_platform == 'win32'", "3.11")


def test_every_requirement_is_pinned_and_has_hashes_and_nothing_else():
    form = re.compile(
        r"[a-z0-9.-]+==[\w.+]+( ; [\w.<>=!'()* ]+?)?( --hash=sha256:[0-9a-f]{64})+", re.ASCII
    )
    assert [line for line in EVERY if not form.fullmatch(line)] == []


def test_it_names_no_address():
    assert "://" not in TEXT and "@" not in TEXT and "--index" not in TEXT


def test_torch_accepts_the_hashes_of_its_own_builds():
    (torch,) = [line for line in SECTIONS["core"] if line.startswith("torch==")]
    for build in SECTIONS["torch"]:
        assert build.startswith(f"{torch.split()[0]}+")
        assert set(build.split()[1:]) <= set(torch.split())


def test_only_torchs_cuda_build_brings_nvidias_packages():
    assert not [name for name in names("core", "blender", "test") if name.startswith("nvidia")]
    assert "nvidia-cudnn-cu13" in names("cuda")


def required(name: str, extra: str = "") -> set[str]:
    """What an installed package requires on this machine, its requirements' own included."""
    from packaging.requirements import Requirement

    found: set[str] = set()
    for text in importlib.metadata.requires(name) or []:
        need = Requirement(text)
        if need.marker is None or need.marker.evaluate({"extra": extra}):
            found.add(canonical(need.name))
            found |= {other for more in need.extras for other in required(need.name, more)}
    return found


@pytest.mark.parametrize("group", ["core", "blender", "test"])
def test_nothing_that_is_required_here_is_missing_from_it(group):
    """A second resolution: from what the installed packages themselves require."""
    done: set[str] = set()
    todo = {lock_file.package_of(line) for line in SECTIONS[group]} & {
        canonical(found.metadata["Name"]) for found in importlib.metadata.distributions()
    }
    assert todo or group == "blender"
    while todo:
        name = todo.pop()
        done.add(name)
        todo |= required(name) - done
    cuda = names("cuda") if "+" not in importlib.metadata.version("torch") else set()
    assert done <= names("core", group) | cuda, FIX


def test_what_is_installed_here_is_what_it_names():
    locked = {line.split()[0] for name in ("core", "test") for line in SECTIONS[name]}
    for found in importlib.metadata.distributions():
        name = canonical(found.metadata["Name"])
        if name in names("core", "test"):
            assert f"{name}=={found.version.partition('+')[0]}" in locked
