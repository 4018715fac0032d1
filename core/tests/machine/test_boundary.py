"""The core never imports Blender, the add-on never imports torch, neither imports the other."""

import ast
import graphlib
import importlib.metadata
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from core.tests.import_graph import PAGE, drawn, folder, folder_graph, module_graph

ROOT = Path(__file__).parents[3]
BANNED = {
    "core": {"bpy", "bmesh", "mathutils", "fantasia3d_addon", "run"},
    "fantasia3d_addon": {"torch", "core", "jaxtyping", "diffusers", "transformers", "run"},
}
# One file of the core each.
ONE_FILE = ("diffusers", "transformers", "xatlas", "OpenEXR", "OpenImageIO", "ray")


@cache
def imported(source: str) -> frozenset[str]:
    """Top-level names of all imports in ``source``, at any depth, also by ``import_module``."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            names.add(node.module)
        elif isinstance(node, ast.Call) and node.args:
            called = ast.unparse(node.func).rpartition(".")[2]
            name = node.args[0]
            if called in ("import_module", "__import__") and isinstance(name, ast.Constant):
                names.add(str(name.value))
    return frozenset(name.partition(".")[0] for name in names)


def files(package: str) -> Iterator[tuple[str, frozenset[str]]]:
    """Each file of ``package`` but its tests, and what it imports."""
    found = [path for path in (ROOT / package).rglob("*.py") if "tests" not in path.parts]
    assert found, f"{package}/ holds no Python file: was it renamed?"
    for path in found:
        yield path.relative_to(ROOT).as_posix(), imported(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("package", BANNED)
def test_a_package_imports_nothing_of_the_other_side(package):
    bad = {name: sorted(names & BANNED[package]) for name, names in files(package)}
    bad = {name: names for name, names in bad.items() if names}
    assert not bad, f"{bad}: pass it through the run folder (docs/architecture.md) instead"


@pytest.mark.parametrize("library", ONE_FILE)
def test_a_heavy_library_has_one_file(library):
    users = [name for name, names in files("core") if library in names]
    assert len(users) == 1, f"{library} is imported in {users}"


@pytest.mark.parametrize(
    "line",
    [
        "import bpy",
        "import torch.nn as nn, bpy.types",
        "from bpy.types import Object",
        "def f():\n    try:\n        from bpy import ops\n    except ImportError:\n        pass",
        "import importlib\nm = importlib.import_module('bpy.utils')",
        "m = __import__('bpy')",
    ],
)
def test_the_scan_sees_an_import_wherever_it_hides(line):
    assert "bpy" in imported(line)


def test_the_scan_takes_no_word_for_an_import():
    source = '"""import bpy"""\nbpy = "from bpy import ops"  # import bpy\nfrom .bpy import x\n'
    assert imported(source) == set()


def test_the_boundary_test_fails_on_a_trespass(tmp_path, monkeypatch):
    (tmp_path / "core").mkdir()
    (tmp_path / "core" / "good.py").write_text("import torch\n")
    monkeypatch.setattr(f"{__name__}.ROOT", tmp_path)
    test_a_package_imports_nothing_of_the_other_side("core")
    (tmp_path / "core" / "bad.py").write_text("def f():\n    import fantasia3d_addon.jobs\n")
    with pytest.raises(AssertionError, match=r"core/bad\.py"):
        test_a_package_imports_nothing_of_the_other_side("core")


@pytest.mark.parametrize("package", ["run.py", "fantasia3d_addon/environment"])
def test_the_launcher_needs_the_standard_library_alone(package):
    path = ROOT / package
    found = [path] if path.is_file() else list(path.glob("*.py"))
    names = frozenset().union(*(imported(file.read_text(encoding="utf-8")) for file in found))
    own = {"fantasia3d_addon", "core", "bpy"} if package == "run.py" else set()
    assert names - set(sys.stdlib_module_names) <= own | {"tomllib"}


def test_the_protocol_and_the_command_line_load_no_library():
    code = (
        "import sys, core.io.job, core.command_line\n"
        "print(sorted({'torch', 'numpy', 'bpy', 'diffusers'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert done.stdout.strip() == "[]", done.stderr


def plain(name: str) -> str:
    """A distribution's name as registries compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()


# The core's folders and files, lowest first: each imports only from those before it.
ORDER = (
    "errors", "interrupt", "terminal", "ranges", "device", "camera", "ranks", "kernels", "ops",
    "adam", "hash_grid", "geometry", "config", "settings", "io", "render", "appearance", "guidance",
    "texture",
    "simulation", "job_config", "stages", "provenance", "generate", "explore", "verify", "picture",
    "report", "batch", "together", "prior", "benchmarks", "reproduce", "options",
    "command_line", "__main__",
)  # fmt: skip


def upward_imports() -> list[str]:
    """Imports from a folder to one that comes later in ORDER."""
    wrong = []
    for module, imports in module_graph("core", ROOT).items():
        for name in imports - {"core"}:
            if ORDER.index(folder(name)) > ORDER.index(folder(module)):
                wrong.append(f"{module} imports {name}")
    return sorted(wrong)


def test_the_cores_folders_import_only_what_is_below_them():
    assert set(folder_graph("core", ROOT)) == set(ORDER)
    assert not upward_imports(), "move what both need into the lower folder"


@pytest.mark.parametrize("package", ["core", "fantasia3d_addon"])
def test_no_module_imports_itself_round_a_corner(package):
    graph = module_graph(package, ROOT)
    graph.pop(package)  # its __init__, which registers all the rest
    graphlib.TopologicalSorter(graph).prepare()  # raises CycleError, which names the circle


@pytest.mark.parametrize(
    "line", ["from core.stages import geometry", "def f():\n    import core.stages.geometry"]
)
def test_the_order_and_the_circle_are_seen_when_broken(tmp_path, monkeypatch, line):
    for name in (
        "__init__",
        "render/__init__",
        "render/normals",
        "stages/__init__",
        "stages/geometry",
    ):
        path = tmp_path / "core" / f"{name}.py"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("from core.render import normals\n" if name == "stages/geometry" else "")
    monkeypatch.setattr(f"{__name__}.ROOT", tmp_path)
    assert upward_imports() == []
    test_no_module_imports_itself_round_a_corner("core")
    (tmp_path / "core" / "render" / "normals.py").write_text(line + "\n")
    assert "core.render.normals imports core.stages.geometry" in upward_imports()
    with pytest.raises(graphlib.CycleError):
        test_no_module_imports_itself_round_a_corner("core")


def test_the_drawing_in_the_docs_is_of_today():
    page = (ROOT / PAGE).read_text(encoding="utf-8")
    assert page == drawn(page), "run: python3 run.py python -m core.tests.import_graph"


def test_everything_that_is_imported_is_declared_and_pinned():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    pins = [*project["dependencies"], *project["optional-dependencies"]["ray"]]
    declared = {plain(re.split(r"==|\[", pin)[0]) for pin in pins}
    distributions = importlib.metadata.packages_distributions()
    unknown = {
        (file, name)
        for file, names in files("core")
        for name in names - set(sys.stdlib_module_names) - {"core"}
        if not declared & {plain(d) for d in [*distributions.get(name, []), name]}
    }
    assert not unknown, "add it to [project] dependencies in pyproject.toml"
    groups = project["optional-dependencies"].values()
    pins = [*project["dependencies"], *(pin for group in groups for pin in group)]
    assert [pin for pin in pins if "==" not in pin] == []


def test_shapes_are_checked_while_tests_run():
    import torch
    from jaxtyping import TypeCheckError

    from core.render.rasterizer import interpolate

    with pytest.raises(TypeCheckError):
        interpolate(torch.zeros(3), "no fragments")  # type: ignore[arg-type]
