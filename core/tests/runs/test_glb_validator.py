"""Khronos' own validator reads the GLB files: the core's, and those that Blender exports.

    npm install --prefix FOLDER gltf-validator
    export FANTASIA3D_GLTF_VALIDATOR=FOLDER
    python3 run.py test -m slow core/tests/runs/test_glb_validator.py

Skipped where the variable is not set, or there is no node.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import torch

from core.geometry.mesh import Mesh
from core.io.asset import place, write_asset
from core.io.maps import Maps
from core.tests.meshes import torus

VARIABLE = "FANTASIA3D_GLTF_VALIDATOR"
SCRIPT = """
const [module, file] = process.argv.slice(1);
const bytes = new Uint8Array(require("fs").readFileSync(file));
require(module).validateBytes(bytes).then((report) => console.log(JSON.stringify(report)));
"""
pytestmark = pytest.mark.slow


def report_of(path: Path) -> dict:
    """The validator's report of a file."""
    folder, node = os.environ.get(VARIABLE), shutil.which("node")
    if not (folder and node):
        pytest.skip(f"needs node, and gltf-validator in the folder that {VARIABLE} names")
    module = Path(folder).absolute() / "node_modules" / "gltf-validator"
    done = subprocess.run([node, "-e", SCRIPT, module, path], capture_output=True, text=True)
    assert not done.returncode, done.stderr
    return json.loads(done.stdout)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    verts, faces = torus()
    uv = torch.rand(len(verts), 2, generator=torch.Generator().manual_seed(0))
    mesh = Mesh(place(verts, 0.3), faces, uv, faces)
    flat = torch.full((8, 8, 3), 0.5)
    up = torch.tensor([0.0, 0, 1]).expand(8, 8, 3)
    maps = Maps(flat, flat, up, emission=flat, transmission=flat[..., :1])
    info = {"prompt": "a red ring, größer", "seed": 1, "density": 650.0}
    return write_asset(tmp_path_factory.mktemp("ring") / "asset", mesh, maps, info)


def check(path: Path) -> None:
    report = report_of(path)
    assert report["issues"]["numErrors"] == report["issues"]["numWarnings"] == 0, report["issues"]
    assert report["info"]["totalTriangleCount"] > 0


def test_the_cores_glb_has_no_fault(folder: Path) -> None:
    check(folder / "asset.glb")


def test_the_validator_sees_a_fault(folder: Path, tmp_path: Path) -> None:
    """A normal that is no unit vector: or the tests above could not fail."""
    data = bytearray((folder / "asset.glb").read_bytes())
    length = int.from_bytes(data[12:16], "little")
    described = json.loads(data[20 : 20 + length])
    (primitive,) = described["meshes"][0]["primitives"]
    view = described["bufferViews"][
        described["accessors"][primitive["attributes"]["NORMAL"]]["bufferView"]
    ]
    start = 28 + length + view["byteOffset"]
    data[start : start + 12] = torch.tensor([3.0, 0, 0]).numpy().tobytes()
    broken = tmp_path / "broken.glb"
    broken.write_bytes(data)
    assert report_of(broken)["issues"]["numErrors"] > 0


def test_blenders_glb_has_no_fault(folder: Path, tmp_path: Path) -> None:
    pytest.importorskip("bpy")
    out = tmp_path / "ring.glb"
    root = Path(__file__).parents[3]
    # A material of the library: or the core would copy its own file.
    command = [sys.executable, "run.py", "--inside", "export", str(folder)]
    command += ["--format", "glb", "--out", str(out), "--material", "gold"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True)
    assert not done.returncode, done.stderr
    check(out)
