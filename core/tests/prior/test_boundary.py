"""Making an asset needs neither the built-in prior's training nor torch's compiler nor trimesh."""

import ast
import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
USERS = ("core/prior/", "core/benchmarks/", "core/reproduce/", "core/tests/")
PREPARE = """
import json, sys
import torch
from core.adam import Adam
from core.generate import generate, prepare
from core.io.job import Job
prepare(Job(prompt="a red wooden chair"))
parameter = torch.ones(1, requires_grad=True)
parameter.sum().backward()
Adam([parameter]).step()
print(json.dumps(sorted(sys.modules)))
"""


def imports_of_the_training(source: str) -> list[str]:
    """Modules of ``core.prior`` that ``source`` imports, at any depth."""
    names = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names += [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
    return [name for name in names if f"{name}.".startswith("core.prior.")]


def test_only_the_training_and_the_benches_import_the_training():
    found = {}
    for path in (ROOT / "core").rglob("*.py"):
        name = path.relative_to(ROOT).as_posix()
        if not name.startswith(USERS):
            found[name] = imports_of_the_training(path.read_text(encoding="utf-8"))
    assert len(found) > 50
    assert {name: names for name, names in found.items() if names} == {}


@pytest.mark.parametrize(
    "line",
    [
        "import core.prior.data",
        "from core import prior",
        "def f():\n    from core.prior.families import NOUNS",
    ],
)
def test_the_scan_sees_an_import_wherever_it_hides(line):
    assert imports_of_the_training(line)
    assert not imports_of_the_training("from core.guidance.builtin import words")


def test_a_generate_imports_nothing_of_the_training_nor_torchs_compiler_nor_trimesh():
    done = subprocess.run(
        [sys.executable, "-c", PREPARE], cwd=ROOT, capture_output=True, text=True, check=True
    )
    modules = json.loads(done.stdout.splitlines()[-1])
    assert "core.guidance.builtin.network" in modules
    assert [name for name in modules if name.startswith("core.prior")] == []
    assert "torch._dynamo" not in modules  # 2 CPU-seconds
    assert "trimesh" not in modules  # 0.4: it reads the meshes of users
