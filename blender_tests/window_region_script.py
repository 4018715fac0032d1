"""Runs inside a real Blender window: a region is edited in Edit Mode, and candidates are chosen.

``blender --enable-event-simulate --python THIS -- OUT ASSET EDITED RESHAPED FACES [RUNS]``
with the fake core, which hands out EDITED, then RESHAPED. FACES is a text file of face numbers;
RUNS is a folder of candidates that ``run.py explore`` made, to be looked at; without it the fake
core makes some.
"""

import math
import os
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from blender_tests.screen import OUT, ROOT, Screen, play, report, screenshot
from fantasia3d_addon import environment
from fantasia3d_addon.asset.import_asset import import_asset
from fantasia3d_addon.jobs import candidates, history, live_preview, paths
from fantasia3d_addon.jobs.candidates import Candidate
from fantasia3d_addon.jobs.process import Run
from fantasia3d_addon.jobs.progress import FollowedRun
from fantasia3d_addon.jobs.session import session
from fantasia3d_addon.mesh import region
from fantasia3d_addon.ui.edit_region import FANTASIA3D_PT_edit_region

ASSET, EDITED, RESHAPED, FACES = sys.argv[sys.argv.index("--") + 2 :][:4]
RUNS = [Path(word) for word in sys.argv[sys.argv.index("--") + 6 :]]


def steps(screen: Screen) -> Iterator[float]:
    """What a user does."""
    yield from screen.open_tab()
    screen.area.spaces.active.overlay.show_cursor = False
    yield from edit(screen)
    yield from explore(screen)


def edit(screen: Screen) -> Iterator[float]:
    """Faces, words, the job, the new maps, and back."""
    obj = import_asset(bpy.context, Path(ASSET))
    bpy.ops.ed.undo_push(message="Import")
    yield from screen.look_at(obj)
    front(screen)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="FACE")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    for face in Path(FACES).read_text().split():
        obj.data.polygons[int(face)].select = True
    bpy.ops.object.mode_set(mode="EDIT")
    settings, tools = bpy.context.scene.fantasia3d, bpy.context.scene.fantasia3d_tools
    tools.region_words, settings.negative_prompt = "blue velvet", EDITED
    yield 2.0
    screenshot("faces")
    yield from menu(screen)
    bpy.ops.fantasia3d.edit_region(words=tools.region_words)
    bpy.ops.object.mode_set(mode="OBJECT")
    yield 0.5
    while session.busy:
        yield 0.1
    yield 3.0
    report["edit_error"], name = session.error, obj.name
    report["maps"] = [maps(name)]
    screenshot("edited")
    bpy.ops.ed.undo()
    report["maps"].append(maps(name))
    bpy.ops.ed.redo()
    report["maps"].append(maps(name))
    bpy.ops.fantasia3d.restore_material()
    report["maps"].append(maps(name))
    yield from shape(bpy.data.objects[name])


def shape(obj: bpy.types.Object) -> Iterator[float]:
    """The same faces' shape: the panel's text, the job, undo and the way back."""
    tools, name = bpy.context.scene.fantasia3d_tools, obj.name
    tools.region_change, tools.region_words = "shape", "a cube"
    bpy.context.scene.fantasia3d.negative_prompt = RESHAPED
    bpy.ops.object.mode_set(mode="EDIT")
    yield 1.5
    screenshot("shape_panel")
    report["shapes"] = [corners(name)]
    bpy.ops.fantasia3d.edit_region(words=tools.region_words, change=tools.region_change)
    bpy.ops.object.mode_set(mode="OBJECT")
    yield 0.5
    while session.busy:
        yield 0.1
    yield 2.0
    report["shape_error"] = session.error
    report["shapes"].append(corners(name))
    screenshot("reshaped")
    for act in (bpy.ops.ed.undo, bpy.ops.ed.redo, bpy.ops.fantasia3d.restore_shape):
        act()
        report["shapes"].append(corners(name))
    # Not ``tools``: undo has made the scene again.
    bpy.context.scene.fantasia3d_tools.region_change = "maps"


def corners(name: str) -> float:
    """The sum of all positions' lengths."""
    return round(math.fsum(v.co.length for v in bpy.data.objects[name].data.vertices), 5)


def menu(screen: Screen) -> Iterator[float]:
    """The context menu of Edit Mode, and F3 there."""
    x, y = screen.area.x + screen.area.width // 3, screen.area.y + screen.area.height // 2
    place = {"window": screen.window, "area": screen.area, "region": screen.region("WINDOW")}
    screen.window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)
    yield 0.3
    with bpy.context.temp_override(**place):
        bpy.ops.wm.search_menu("INVOKE_DEFAULT")
    yield 1.0
    yield from screen.type("edit region")
    yield 1.0
    screenshot("search")
    yield from screen.key("ESC")
    yield from screen.key("ESC")


def explore(screen: Screen) -> Iterator[float]:
    """The candidates in the panel and in the view."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.candidates = "a red wooden chair", 4
    if RUNS:
        take_candidates(RUNS[0])
        session.refresh()
    else:
        bpy.ops.fantasia3d.explore()
    yield 0.5
    while session.busy or len(history.open_candidates(session.history)) < 4:
        yield 0.1
    report["candidates"] = len(history.open_candidates(session.history))
    report["previews"] = len([o for o in bpy.data.objects if live_preview.RUN in o])
    front(screen, distance=4.2)
    for _ in range(40):  # to the panel's lower part, where the candidates are
        screen.window.event_simulate(type="MOUSEMOVE", value="NOTHING", **in_sidebar(screen))
        screen.window.event_simulate(type="WHEELDOWNMOUSE", value="PRESS", **in_sidebar(screen))
        yield 0.03
    yield 3.0
    screenshot("candidates")


def take_candidates(folder: Path) -> None:
    """Copies of the runs that the command line made, as candidates of this Blender."""
    for run in sorted(folder.glob("candidate-*")):
        copy = Path(shutil.copytree(run, paths.Paths.runs / run.name))
        candidates.write(copy / candidates.NAME, Candidate(group="explored", until="shape"))
        target = session.target_here(bpy.context)
        target.write(copy)
        session.candidates[copy.name] = FollowedRun(Run.attach(copy), target, None, 0)
    session.show_candidates()


def maps(name: str) -> list[str]:
    """The names of the images that the object shows, and the sum of their base colour."""
    images = region.look_of(bpy.data.objects[name]).images
    total = math.fsum(images["base_color"].pixels[:])
    return [images["base_color"].name, f"{total:.4f}"]


def front(screen: Screen, distance: float = 2.2) -> None:
    """From the front and above."""
    from mathutils import Euler

    view = screen.area.spaces.active.region_3d
    view.view_rotation = Euler((1.1, 0, 0.5)).to_quaternion()
    view.view_distance = distance


def in_sidebar(screen: Screen) -> dict[str, int]:
    sidebar = screen.region("UI")
    return {"x": sidebar.x + sidebar.width // 2, "y": sidebar.y + sidebar.height // 2}


FANTASIA3D_PT_edit_region.bl_options = set()  # it is open
os.environ["FANTASIA3D_PYTHON"] = sys.executable
environment.project_root = lambda: ROOT / "blender_tests" / "fake_core"
paths.Paths.runs = OUT / "runs"
paths.Paths.runs.mkdir(parents=True, exist_ok=True)
play(steps)
