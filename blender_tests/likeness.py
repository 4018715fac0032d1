"""How near the core's picture of an asset comes to Cycles', as JSON.

``python3 run.py python -m blender_tests.likeness ASSET [LIGHT]``: one light, one camera, one
bounce, pixels as points; LIGHT is one of Blender's, such as courtyard.
"""

import json
import os
import sys
import tempfile
from pathlib import Path

from blender_tests.compare_cycles import (
    add_asset,
    asset_pixels,
    cycles_pixels,
    empty_scene,
    inner,
    psnr,
)
from core.appearance.environment import Environment
from core.appearance.lights import blender_light, load_light
from core.camera import Cameras
from core.io.asset import read_asset

SIZE, SAMPLES = 96, 96


def likeness(folder: Path, light: str = "courtyard", samples: int = SAMPLES) -> float:
    """PSNR of linear colours as the Standard view shows them, without the outline, dB."""
    extent = read_asset(folder).mesh.verts
    extent = float((extent.amax(0) - extent.amin(0)).norm())
    camera = Cameras.orbit([35.0], [25.0], 1.7 * extent)  # the whole asset, whatever its size
    empty_scene(blender_light(light), SIZE, samples, seen_by=camera)
    add_asset(folder)
    with tempfile.TemporaryDirectory() as temporary:
        theirs, cover = cycles_pixels(Path(temporary) / "cycles.exr")
    environment = Environment.of(load_light(f"blender:{light}"))
    ours, seen = asset_pixels(folder, SIZE, environment, seen_by=camera)
    where = inner(cover & seen)
    return psnr(ours[where], theirs[where])


if __name__ == "__main__":
    print(json.dumps({"psnr_db": round(likeness(Path(sys.argv[1]), *sys.argv[2:3]), 1)}))
    sys.stdout.flush()
    os._exit(0)  # bpy may hang at an ordinary exit
