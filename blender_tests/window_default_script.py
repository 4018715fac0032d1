"""Runs inside a real Blender window, in the default scene with its cube: an artist's first minutes.

``blender --enable-event-simulate --python window_default_script.py -- OUT ASSET``, the fake core.
"""

import os
import sys
from collections.abc import Iterator
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from blender_tests.screen import OUT, ROOT, Screen, play, report, screenshot
from fantasia3d_addon import environment
from fantasia3d_addon.blender.mesh_arrays import world_verts
from fantasia3d_addon.jobs import live_preview, paths, submit
from fantasia3d_addon.jobs.session import session
from fantasia3d_addon.scene import view

ASSET = sys.argv[-1]


def steps(screen: Screen) -> Iterator[float]:
    """What a user does."""
    yield from screen.open_tab()
    settings = bpy.context.scene.fantasia3d
    settings.negative_prompt = ASSET  # which the fake core hands out
    screenshot("default")
    yield from words(settings)
    yield from preview(screen, settings)
    yield from arrivals(screen, settings)
    yield from search(screen)
    yield from german(screen)


def words(settings) -> Iterator[float]:
    """An unknown word, its nearest meaning, and what is understood."""
    settings.prompt = "a red samovar"  # no thing of the prior, but near to one
    while submit.report_of(settings) is None or not session.word_groups():
        yield 0.1
    report["unknown"] = submit.reason_against_generate(bpy.context)
    yield 0.6
    screenshot("unknown_word")
    nearest = submit.unknown(submit.report_of(settings))["samovar"][0]
    bpy.ops.fantasia3d.replace_word(old="samovar", new=nearest)
    while submit.report_of(settings) is None:
        yield 0.1
    report["replaced"] = [settings.prompt, submit.reason_against_generate(bpy.context)]
    yield 0.6
    screenshot("understood")


def preview(screen: Screen, settings) -> Iterator[float]:
    """The growing shape next to the cube, and alone."""
    settings.ignore_unknown, settings.prompt = True, "show a red wooden chair"
    yield 0.6
    bpy.ops.fantasia3d.generate()
    while not (session.running and live_preview.find(session.running[0].name)):
        yield 0.1
    obj = live_preview.find(session.running[0].name)
    yield 2.0
    report["preview_overlaps"] = overlaps(obj, bpy.data.objects["Cube"])
    screenshot("preview")
    space = screen.area.spaces.active
    place = {"window": screen.window, "area": screen.area, "region": screen.region("WINDOW")}
    with bpy.context.temp_override(**place):
        bpy.ops.fantasia3d.local_view()
    yield 1.0
    cube = bpy.data.objects["Cube"]
    report["alone"] = [view.is_shown(shown, space) for shown in (obj, cube)]
    screenshot("alone")
    session.cancel()
    while session.running:
        yield 0.05
    yield 0.5
    report["left_local_view"] = space.local_view is None


def arrivals(screen: Screen, settings) -> Iterator[float]:
    """Two assets, next to the cube and to each other."""
    settings.prompt = "a red wooden chair"
    for _ in range(2):
        yield 0.5
        bpy.ops.fantasia3d.generate()
        yield 0.5
        while session.busy or not session.asset:
            yield 0.1
    yield 1.0
    meshes = [obj for obj in bpy.data.objects if obj.type == "MESH"]
    report["meshes"] = len(meshes)
    report["asset_overlaps"] = any(
        overlaps(obj, other) for i, obj in enumerate(meshes) for other in meshes[:i]
    )
    screenshot("arrived")
    with bpy.context.temp_override(window=screen.window, area=screen.area):
        bpy.ops.fantasia3d.show_colors(shading="TEXTURE")  # EEVEE would compile for minutes here
    yield 2.0
    screenshot("colors")


def search(screen: Screen) -> Iterator[float]:
    """F3, and the Add menu."""
    x, y = screen.area.x + screen.area.width // 3, screen.area.y + screen.area.height // 2
    place = {"window": screen.window, "area": screen.area, "region": screen.region("WINDOW")}
    screen.window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)
    yield 0.3
    with bpy.context.temp_override(**place):
        bpy.ops.wm.search_menu("INVOKE_DEFAULT")
    yield 1.0
    yield from screen.type("fantasia")
    yield 1.0
    screenshot("search")
    yield from screen.key("ESC")
    yield from screen.key("ESC")
    with bpy.context.temp_override(**place):
        bpy.ops.wm.call_menu(name="FANTASIA3D_MT_object")
    yield 1.0
    screenshot("object_menu")
    yield from screen.key("ESC")


def german(screen: Screen) -> Iterator[float]:
    settings = bpy.context.preferences.view
    codes = [code for code in ("de_DE", "de") if code in bpy.app.translations.locales]
    report["german"] = bool(codes)
    if not codes:
        return
    settings.language = codes[0]
    settings.use_translate_interface = settings.use_translate_tooltips = True
    screen.region("UI").tag_redraw()
    yield 1.5
    screenshot("german")


def overlaps(obj: bpy.types.Object, other: bpy.types.Object) -> bool:
    (low, high), (lower, upper) = ((p.min(0), p.max(0)) for p in map(world_verts, (obj, other)))
    return bool((low < upper).all() and (lower < high).all())


os.environ["FANTASIA3D_PYTHON"] = sys.executable
environment.project_root = lambda: ROOT / "blender_tests" / "fake_core"
paths.Paths.runs = OUT / "runs"
play(steps, is_empty=False)
