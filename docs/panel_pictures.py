"""Takes the README's pictures of the panel in a real Blender's window.

    python3 run.py generate "a wooden treasure chest" --out CHEST
    python3 run.py explore "a red wooden chair" --count 4 --seed 1 --out CHAIRS
    FANTASIA3D_PYTHON=PYTHON xvfb-run -a -s "-screen 0 1280x960x24" blender --factory-startup \\
        --enable-event-simulate --window-geometry 0 0 1280 960 \\
        --python docs/panel_pictures.py -- OUT chest CHEST    # or: OUT chairs CHAIRS

PYTHON has the core's packages. OUT gets the whole window, for docs/images to be cut from: panel and
edit_panel, or candidates. Without a GPU, EEVEE compiles for minutes: COMPILING=SECONDS.
"""

import os
import shutil
import sys
from collections.abc import Iterator, Sequence
from math import radians
from pathlib import Path

import bpy
import numpy as np
from mathutils import Euler, Vector

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from blender_tests.screen import OUT, Screen, play, screenshot
from fantasia3d_addon.asset.import_asset import import_asset
from fantasia3d_addon.jobs import candidates, paths, submit
from fantasia3d_addon.jobs.candidates import Candidate
from fantasia3d_addon.jobs.process import Run
from fantasia3d_addon.jobs.progress import FollowedRun
from fantasia3d_addon.jobs.session import session
from fantasia3d_addon.scene import view
from fantasia3d_addon.ui.edit_region import FANTASIA3D_PT_edit_region

KIND, RUN = sys.argv[sys.argv.index("--") + 2 :][:2]
COMPILING = float(os.environ.get("COMPILING", "20"))  # seconds that EEVEE gets
LID, LOCK = 0.533, 0.62  # of the chest's height: its lid is above, its lock up to there


def steps(screen: Screen) -> Iterator[float]:
    """One picture after the other."""
    yield from screen.open_tab()
    overlay = screen.area.spaces.active.overlay
    overlay.show_cursor = overlay.show_object_origins = False
    yield from {"chest": chest, "chairs": chairs}[KIND](screen)


def chest(screen: Screen) -> Iterator[float]:
    """The asset in Material Preview, then its lid in Edit Mode."""
    yield from understood("a wooden treasure chest")
    obj = import_asset(bpy.context, Path(RUN, "asset"))
    bpy.context.view_layer.objects.active = obj
    view.show_colors(screen.area.spaces.active)
    look(screen, (0, 0, 0.24), 1.75, (66, 33))
    yield COMPILING
    screenshot("panel")
    for parts in (obj.data.vertices, obj.data.edges):
        parts.foreach_set("select", np.zeros(len(parts), bool))
    x, y, z = np.array([face.center[:] for face in obj.data.polygons]).T
    z /= obj.dimensions.z
    lock = (z < LOCK) & (abs(x) < 0.08) & (y < 0)
    obj.data.polygons.foreach_set("select", (z > LID) & ~lock)
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.scene.fantasia3d_tools.region_words = "red velvet"
    yield COMPILING / 4
    screenshot("edit_panel")


def chairs(screen: Screen) -> Iterator[float]:
    """Four shapes, and the panel's lower part with their pictures."""
    screen.area.spaces.active.shading.type = "SOLID"
    yield from understood("a red wooden chair")
    bpy.context.scene.fantasia3d.seed = 1
    for run in sorted(Path(RUN).glob("candidate-*")):
        copy = Path(shutil.copytree(run, paths.Paths.runs / run.name))
        candidates.write(copy / candidates.NAME, Candidate(group="explored", until="shape"))
        target = session.target_here(bpy.context)
        target.write(copy)
        session.candidates[copy.name] = FollowedRun(Run.attach(copy), target, None, 0)
    session.show_candidates()
    session.refresh()
    yield 5.0
    shown = [obj for obj in bpy.data.objects if obj.type == "MESH"]
    middle = sum((obj.location for obj in shown), Vector()) / len(shown)
    look(screen, middle + Vector((0, 0, 0.3)), 3.7, (44, 40))
    screen.region("UI").tag_redraw()
    yield 5.0
    screenshot("candidates")


def understood(prompt: str) -> Iterator[float]:
    """The prompt in the panel, with what the core understands of it."""
    settings = bpy.context.scene.fantasia3d
    settings.prompt = prompt
    while submit.report_of(settings) is None:
        yield 0.2
    yield 0.5


def look(screen: Screen, at: Sequence[float], far: float, turned_deg: tuple[float, float]) -> None:
    """From the front: up from straight down, then to the right."""
    up, right = turned_deg
    region = screen.area.spaces.active.region_3d
    region.view_rotation = Euler((radians(up), 0, radians(right))).to_quaternion()
    region.view_location, region.view_distance = at, far


if KIND == "chest":
    FANTASIA3D_PT_edit_region.bl_options = set()  # it is open
paths.Paths.runs = OUT / "runs"
paths.Paths.runs.mkdir(parents=True, exist_ok=True)
play(steps)
