"""The order in which the test files are carried out."""

import ast

import run

ROOT = run.ROOT


def test_the_files_that_come_first_or_together_are_there():
    folders = (ROOT / "core", ROOT / "blender_tests")
    names = {path.name for folder in folders for path in folder.rglob("test_*.py")}
    tables = {}
    for node in ast.parse((ROOT / "conftest.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            tables[node.targets[0].id] = node.value
    first = ast.literal_eval(tables["LONGEST"])
    together = [name for group in ast.literal_eval(tables["TOGETHER"]) for name in group]
    assert set(first) | set(together) <= names, "a file was renamed: so is its name there"
