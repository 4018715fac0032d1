"""The extension's zip: built and validated by Blender's own tool, installed, used, taken away."""

import os
import shlex
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

from blender_tests.asset_fixture import write_asset
from blender_tests.processes import ROOT

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.asset.asset_folder import read_asset  # noqa: E402

pytestmark = pytest.mark.blender
MODULE = "bl_ext.user_default.fantasia3d"
USE = """
import json, sys
from pathlib import Path
import bpy
import importlib
module = importlib.import_module({module!r})
environment = importlib.import_module({module!r} + ".environment")
bpy.ops.wm.read_homefile(use_empty=True)
assert bpy.ops.fantasia3d.import_asset(directory={asset!r}) == {{"FINISHED"}}
assert bpy.ops.fantasia3d.replace_material(material="gold") == {{"FINISHED"}}
assert bpy.ops.fantasia3d.check_mesh() == {{"FINISHED"}}
assert bpy.ops.fantasia3d.export(filepath={glb!r}) == {{"FINISHED"}}
root = environment.project_root()
has_core = (root / "core" / "__main__.py").is_file()
facts = {{"file": module.__file__, "root": str(root), "core": has_core}}
Path({out!r}).write_text(json.dumps(facts))
"""


@pytest.fixture(scope="module")
def package(tmp_path_factory) -> Path:
    """The zip, as ``run.py package`` builds it."""
    folder = tmp_path_factory.mktemp("package")
    environ = os.environ | {"FANTASIA3D_PYTHON": sys.executable}
    command = [sys.executable, str(ROOT / "run.py"), "package", "--out", str(folder)]
    done = subprocess.run(command, env=environ, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    return Path(done.stdout.strip())


def test_the_zip_holds_the_add_on_and_the_core_and_nothing_else(package):
    with zipfile.ZipFile(package) as archive:
        names = set(archive.namelist())
        manifest = tomllib.loads(archive.read("blender_manifest.toml").decode())
    assert manifest == tomllib.loads((ROOT / "manifest.toml").read_text("utf-8"))
    assert {"__init__.py", "scene/studio.exr", "LICENSE", "method/pyproject.toml"} <= names
    assert "method/core/guidance/builtin/geometry.safetensors" in names
    mine = {f"method/{p.relative_to(ROOT).as_posix()}" for p in (ROOT / "core").rglob("*.py")}
    training = {n for n in mine if "/core/prior/" in n}
    assert {n for n in mine - training if "/tests/" not in n} <= names
    assert training
    assert not training & names  # how the built-in prior was made: no run uses it
    assert not [n for n in names if "tests/" in n or "__pycache__" in n or n.endswith(".pyc")]
    assert package.stat().st_size < 80e6


def test_nothing_is_next_to_the_core_that_could_hide_a_library(package):
    """It runs from its own folder, where the add-on's png.py was once taken for the package."""
    with zipfile.ZipFile(package) as archive:
        names = [name.split("/") for name in archive.namelist()]
    there = {name[1] for name in names if name[0] == "method"} - {""}
    assert there == {"core", "pyproject.toml", "requirements.lock"}


def test_bench_prior_of_the_zip_ends_with_a_sentence(package, tmp_path):
    pytest.importorskip("torch")
    with zipfile.ZipFile(package) as archive:
        archive.extractall(tmp_path)
    command = [sys.executable, "-m", "core", "bench", "prior"]
    done = subprocess.run(command, cwd=tmp_path / "method", capture_output=True, text=True)
    assert done.returncode == 3, done.stderr
    assert done.stderr.startswith("error: This copy of the project has no core/prior")
    assert "Traceback" not in done.stderr


@pytest.mark.slow
def test_the_core_of_the_zip_makes_an_asset(package, tmp_path):
    """The real one, from a folder where nothing of this tree is; a minute."""
    pytest.importorskip("torch")
    with zipfile.ZipFile(package) as archive:
        archive.extractall(tmp_path / "add-on")
    settings = (
        "geometry.fit_steps=40 geometry.coarse.steps=2 geometry.fine.steps=1 "
        "geometry.grow.rounds=0 geometry.refine.rounds=0 "
        "appearance.early.steps=1 appearance.late.steps=1 "
        "appearance.refine.rounds=0 texture.size=64 texture.max_faces=500"
    )
    command = [sys.executable, "-m", "core", "generate", "a ball", "--out", str(tmp_path / "run")]
    command += [word for pair in settings.split() for word in ("--set", pair)]
    done = subprocess.run(
        command, cwd=tmp_path / "add-on" / "method", capture_output=True, text=True, timeout=900
    )
    assert done.returncode == 0, done.stderr[-2000:]
    assert read_asset(tmp_path / "run").pictures["normal"].path.is_file()


def test_package_accepts_no_other_arguments():
    command = [sys.executable, str(ROOT / "run.py"), "package", "now"]
    environ = os.environ | {"FANTASIA3D_PYTHON": sys.executable}
    done = subprocess.run(command, env=environ, capture_output=True, text=True)
    assert done.returncode == 2
    assert "package has no option 'now'" in done.stderr


@pytest.mark.slow
def test_installed_in_a_blender_of_its_own_it_works_and_goes_without_a_trace(package, tmp_path):
    """Under the bpy module, in a process whose user folder is new."""
    user, asset = tmp_path / "user ü", write_asset(tmp_path / "asset")
    use = USE.format(
        module=MODULE, asset=str(asset), glb=str(tmp_path / "x.glb"), out=str(tmp_path / "facts")
    )
    code = (
        "import bpy, os, sys\n"
        f"bpy.ops.extensions.package_install_files(filepath={str(package)!r}, "
        "repo='user_default', enable_on_install=True)\n"
        f"assert {MODULE!r} in bpy.context.preferences.addons\n"
        f"exec({use!r})\n"
        f"bpy.ops.extensions.package_uninstall(repo_index=next(i for i, r in enumerate("
        "bpy.context.preferences.extensions.repos) if r.module == 'user_default'), "
        "pkg_id='fantasia3d')\n"
        f"assert {MODULE!r} not in bpy.context.preferences.addons\n"
        "assert not hasattr(bpy.types.Scene, 'fantasia3d')\n"
        "print('fine'); sys.stdout.flush(); os._exit(0)\n"
    )
    environ = os.environ | {"BLENDER_USER_RESOURCES": str(user)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=environ, capture_output=True, text=True, timeout=600,
        cwd=tmp_path,
    )  # fmt: skip
    assert done.stdout.strip().endswith("fine"), done.stdout[-1500:] + done.stderr[-3000:]
    assert '"core": true' in (tmp_path / "facts").read_text()
    assert str(user) in (tmp_path / "facts").read_text().encode().decode("unicode_escape")
    assert (tmp_path / "x.glb").stat().st_size > 1000
    assert not list((user / "extensions" / "user_default").glob("fantasia3d*"))


def blender() -> list[str]:
    """A real Blender's command, or the reason to skip."""
    given = os.environ.get("FANTASIA3D_BLENDER") or shutil.which("blender")
    if not given:
        pytest.skip("there is no Blender on PATH or in FANTASIA3D_BLENDER")
    return shlex.split(given)


@pytest.mark.slow
def test_blenders_own_command_line_installs_it_and_takes_it_away(package, tmp_path):
    command = blender()
    asset = write_asset(tmp_path / "asset")
    environ = os.environ | {"BLENDER_USER_RESOURCES": str(tmp_path / "user")}

    def call(*words: str) -> str:
        done = subprocess.run(
            [*command, *words], env=environ, capture_output=True, text=True, timeout=600,
            cwd=tmp_path,
        )  # fmt: skip
        assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
        return done.stdout

    call("--command", "extension", "install-file", "-r", "user_default", "-e", str(package))
    (tmp_path / "use.py").write_text(
        USE.format(
            module=MODULE,
            asset=str(asset),
            glb=str(tmp_path / "x.glb"),
            out=str(tmp_path / "facts"),
        )
    )
    call("-b", "--python-exit-code", "1", "--python", str(tmp_path / "use.py"))
    assert '"core": true' in (tmp_path / "facts").read_text()
    assert (tmp_path / "x.glb").is_file()
    assert "fantasia3d" in call("--command", "extension", "list")
    call("--command", "extension", "remove", "fantasia3d")
    assert not list((tmp_path / "user").rglob("fantasia3d/blender_manifest.toml"))
    leftovers = "import bpy; assert not hasattr(bpy.types.Scene, 'fantasia3d')"
    call("-b", "--python-exit-code", "1", "--python-expr", leftovers)
