"""The add-on's folders import one another in one direction, lazy imports included. No bpy."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ADDON = Path(__file__).parents[1] / "fantasia3d_addon"
# Each may import those of the lines below it. Folders of one line do not import each other.
ORDER = (
    ("api", "ui", "cli"),
    ("jobs",),
    ("physics",),
    ("mesh",),
    ("asset", "material", "scene"),
    ("background",),
    ("blender",),
    ("environment",),
    ("options", "errors"),
)
LEVEL = {name: level for level, names in enumerate(reversed(ORDER)) for name in names}
ROOT_NAMES = {"PACKAGE"}  # of __init__.py, which imports nothing before it registers
STANDARD_LIBRARY_ALONE = ("environment", "options", "errors")
WITHOUT_BPY = ("background.thread", "jobs.process", "jobs.history", "jobs.progress", "jobs.events")


def imports(addon: Path) -> Iterator[tuple[str, str]]:
    """(module, imported module) for each relative import of the add-on, at any depth."""
    for path in addon.rglob("*.py"):
        parts = path.relative_to(addon).with_suffix("").parts
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if not isinstance(node, ast.ImportFrom) or not node.level:
                continue
            folder = parts[:-1]
            base = [*folder[: len(folder) - node.level + 1]]
            base += node.module.split(".") if node.module else []
            for alias in node.names:
                found = addon.joinpath(*base, alias.name)
                is_module = found.is_dir() or found.with_suffix(".py").is_file()
                name = ".".join([*base, alias.name] if is_module else base)
                yield ".".join(parts), name or alias.name


def trespasses(addon: Path) -> list[str]:
    """Imports against ORDER."""
    found = []
    for module, imported in imports(addon):
        room, other = module.split(".")[0], imported.split(".")[0]
        if room in (other, "__init__") or other in ROOT_NAMES:
            continue
        if room not in LEVEL or other not in LEVEL or LEVEL[room] <= LEVEL[other]:
            found.append(f"{module} imports {imported}")
    return found


def circles(addon: Path) -> list[str]:
    """Modules that import themselves by way of others."""
    edges: dict[str, set[str]] = {}
    for module, imported in imports(addon):
        edges.setdefault(module.removesuffix(".__init__"), set()).add(imported)

    def reached(start: str) -> set[str]:
        seen, front = set(), [start]
        while front:
            new = edges.get(front.pop(), set()) - seen
            seen |= new
            front.extend(new)
        return seen

    return sorted(module for module in edges if module in reached(module))


def test_folders_import_in_one_direction():
    assert trespasses(ADDON) == []


def test_every_folder_has_its_place_in_the_order():
    names = {path.stem for path in ADDON.iterdir() if path.suffix in ("", ".py")}
    assert names - {"__init__", "__pycache__"} == set(LEVEL)


def test_no_module_imports_itself_by_way_of_others():
    assert circles(ADDON) == []


def test_imports_are_relative_or_of_libraries():
    """An absolute import of the add-on would load it twice in an installed extension."""
    bad = [
        path.name
        for path in ADDON.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if (isinstance(node, ast.ImportFrom) and not node.level and (node.module or "")
            .startswith("fantasia3d_addon"))
    ]  # fmt: skip
    assert bad == []


def write(folder: Path, **sources: str) -> Path:
    for name, source in sources.items():
        path = folder.joinpath(*name.split("__")).with_suffix(".py")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source)
    return folder


@pytest.mark.parametrize(
    ("source", "imported"),
    [
        ("from ..jobs import session", "jobs.session"),
        ("def f():\n    from ..jobs.session import session", "jobs.session"),
        ("from .. import jobs", "jobs"),
        ("from ..scene import light", "scene.light"),  # of the same line
        ("from ..attic import chest", "attic.chest"),  # a folder without a place
    ],
)
def test_the_order_test_fails_on_a_trespass(tmp_path, source, imported):
    addon = write(
        tmp_path,
        jobs__session="",
        scene__light="",
        attic__chest="",
        asset__good="",
        asset__bad=source,
    )
    assert trespasses(addon) == [f"asset.bad imports {imported}"]


def test_the_circle_test_fails_on_a_circle(tmp_path):
    addon = write(
        tmp_path,
        jobs__a="from .b import x",
        jobs__b="def f():\n    from . import c",
        jobs__c="from .a import y",
        jobs__d="from . import a",
    )
    assert circles(addon) == ["jobs.a", "jobs.b", "jobs.c"]
