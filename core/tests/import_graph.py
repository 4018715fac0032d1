"""Who imports whom, by module and by folder, and the drawing of it in docs/architecture.md.

``python3 run.py python -m core.tests.import_graph`` draws it again.
"""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = Path("docs/architecture.md")
BEGIN, END = "<!-- imports: begin -->\n", "<!-- imports: end -->\n"

Graph = dict[str, set[str]]


def module_graph(package: str, root: Path = ROOT) -> Graph:
    """Each module of ``package`` but its tests, and the package's modules that it imports, at any
    depth: lazy imports count."""
    modules = {_name(path, root): path for path in (root / package).rglob("*.py")}
    modules = {name: path for name, path in modules.items() if ".tests" not in name}
    graph: Graph = {}
    for name, path in modules.items():
        graph[name] = set()
        for base, names in _imports(path, name):
            parts = {f"{base}.{part}" for part in names} & modules.keys()
            # "from package import module" needs the module alone, whose package has none of it.
            graph[name] |= parts if len(parts) == len(names) > 0 else parts | {base}
        graph[name] &= modules.keys() - {name}
    return graph


def folder(module: str) -> str:
    """The folder, or the file, of a package that a module belongs to; "" is the package itself."""
    return module.partition(".")[2].partition(".")[0]


def folder_graph(package: str, root: Path = ROOT) -> Graph:
    """Each folder of ``package`` and the folders that it imports from."""
    graph: Graph = {}
    for module, imports in module_graph(package, root).items():
        mine = graph.setdefault(folder(module), set())
        mine |= {folder(name) for name in imports} - {folder(module)}
    graph.pop("", None)
    return {name: imports - {""} for name, imports in graph.items()}


def mermaid(package: str, root: Path = ROOT) -> str:
    """The folders' imports as a Mermaid flowchart, without those that follow from others."""
    graph = folder_graph(package, root)
    lines = [f"flowchart TD\n  subgraph {package}"]
    for name in sorted(graph):
        direct = graph[name] - _reached(graph, graph[name])
        lines += [f"    {name} --> {other}" for other in sorted(direct)]
        lines += [f"    {name}"] if not graph[name] else []
    return "\n".join([*lines, "  end"]).replace("__main__", "main") + "\n"


def drawing(root: Path = ROOT) -> str:
    """The part of the page between the two marks."""
    parts = [f"```mermaid\n{mermaid(name, root)}```\n" for name in ("core", "fantasia3d_addon")]
    return "\n".join(parts)


def drawn(page: str, root: Path = ROOT) -> str:
    """``page`` with today's drawing."""
    before, rest = page.split(BEGIN)
    return before + BEGIN + drawing(root) + END + rest.split(END)[1]


def _name(path: Path, root: Path) -> str:
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _imports(path: Path, module: str) -> Iterator[tuple[str, list[str]]]:
    """Each import: a module, and the names that are taken from it."""
    package = module if path.stem == "__init__" else module.rpartition(".")[0]
    for node in _statements(path.read_text(encoding="utf-8")):
        if isinstance(node, ast.Import):
            yield from ((alias.name, []) for alias in node.names)
        else:
            base = node.module or ""
            if node.level:  # relative: so many packages up, less the one that "." names
                above = ".".join(package.split(".")[: len(package.split(".")) - node.level + 1])
                base = f"{above}.{base}".rstrip(".")
            yield base, [alias.name for alias in node.names]


@cache
def _statements(source: str) -> tuple[ast.Import | ast.ImportFrom, ...]:
    """A file's imports, read once for all who ask."""
    found = ast.walk(ast.parse(source))
    return tuple(node for node in found if isinstance(node, ast.Import | ast.ImportFrom))


def _reached(graph: Graph, starts: set[str]) -> set[str]:
    """What can be reached from ``starts`` by one import and more."""
    found: set[str] = set()
    todo = [name for start in starts for name in graph.get(start, ())]
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo += graph.get(name, ())
    return found


if __name__ == "__main__":
    file = ROOT / PAGE
    file.write_text(drawn(file.read_text(encoding="utf-8")), encoding="utf-8")
    print(file)
