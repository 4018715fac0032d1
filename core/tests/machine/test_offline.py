"""Nothing goes online unasked: without a network all is as with one, and nothing is tried.

The short real run of test_generate.py is made the same way.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from core.tests.offline import ONLINE, attempts, cut_off, recorder

ROOT = Path(__file__).parents[3]
# The core's modules in one process, and the add-on in Blender, where there is one.
ALL = """
import importlib.util, os, pkgutil, sys
import core, run
from core.command_line import main
codes = [main(["words", "a red wooden chair"]), main(["inspect", sys.argv[1]])]
codes.append(run.main(["doctor"]))
for module in pkgutil.walk_packages(core.__path__, "core."):
    # Ray is an extra, and imported in this module alone.
    extra = module.name == "core.batch.cluster" and not importlib.util.find_spec("ray")
    if ".tests" not in module.name and not module.name.endswith("__main__") and not extra:
        __import__(module.name)
from core.guidance.stable_diffusion import libraries
libraries.UNet2DConditionModel, libraries.AutoencoderKL, libraries.CLIPTextModel
if importlib.util.find_spec("bpy"):
    import bpy, fantasia3d_addon
    fantasia3d_addon.register()
    fantasia3d_addon.unregister()
print(codes, "core.guidance.stable_diffusion.guidance" in sys.modules, flush=True)
os._exit(0)
"""


def alone(folder: Path, code: str, *arguments: str) -> tuple[str, list[str]]:
    """The output of ``code`` without a network, and what it tried to reach.

    Where no namespace may be made, it runs with the network and the attempts alone count.
    """
    place = recorder(folder / "recorder")
    done = subprocess.run(
        [*cut_off(), sys.executable, "-c", code, *arguments],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(place), "FANTASIA3D_PYTHON": sys.executable},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout, attempts(place)


@pytest.mark.skipif(not cut_off(), reason="no network namespace may be made here")
def test_an_attempt_fails_and_is_recorded(tmp_path):
    """Without this the other tests would prove nothing."""
    output, tried = alone(tmp_path, ONLINE)
    assert output.split() == ["OSError", "gaierror"]
    assert {line.split()[0] for line in tried} == {"socket.connect", "socket.getaddrinfo"}


def test_commands_and_imports_stay_offline(tmp_path):
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    (tmp_path / "solid.obj").write_text(corners + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    output, tried = alone(tmp_path, ALL, str(tmp_path / "solid.obj"))
    assert tried == []
    assert output.splitlines()[-1] == "[0, 0, 0] True", output
    assert "chair" in output and "torch" in output
