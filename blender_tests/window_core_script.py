"""Runs inside a real Blender window, with the real core: from a typed prompt to the asset.

``blender --enable-event-simulate --python window_core_script.py -- OUT [STAGE.FIELD=VALUE…]``;
FANTASIA3D_PYTHON names a Python that has the core's packages. The values shorten the draft.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from blender_tests.screen import OUT, Screen, beat, play, report, screenshot
from fantasia3d_addon.jobs import live_preview, paths
from fantasia3d_addon.jobs.progress import FollowedRun
from fantasia3d_addon.jobs.session import session

OVERRIDES = " ".join(sys.argv[sys.argv.index("--") + 2 :])
PROMPT = "a red wooden chair"
CURSOR = (0.5, -0.25, 0.125)
report["cursor"] = CURSOR


def steps(screen: Screen) -> Iterator[float]:
    """What a user does."""
    yield from screen.open_tab()
    screen.area.spaces.active.overlay.show_cursor = False
    bpy.context.scene.cursor.location = CURSOR
    look_from(screen)
    yield from screen.type_prompt(PROMPT)
    settings = bpy.context.scene.fantasia3d
    report["prompt"] = settings.prompt
    settings.overrides = OVERRIDES
    beat()
    yield 1.0
    screenshot("before")
    yield from screen.press_generate(364)
    yield from watch(session.running[0])
    while session.busy:
        yield 0.1
    report["error"], report["end"] = session.error, session.last.end.text
    yield 1.0
    report_on(bpy.data.objects[session.asset])
    bpy.ops.ed.undo()
    report["after_undo"] = meshes()
    bpy.ops.ed.redo()
    report["after_redo"] = meshes()
    yield from screen.look_at(bpy.data.objects[PROMPT])
    screenshot("done")


def look_from(screen: Screen) -> None:
    """At the place where the asset will be, from its front and above."""
    from mathutils import Euler, Vector

    view = screen.area.spaces.active.region_3d
    view.view_rotation = Euler((1.25, 0, 0.5)).to_quaternion()
    view.view_location, view.view_distance = Vector(CURSOR) + Vector((0, 0, 0.45)), 3.2


def watch(followed: FollowedRun) -> Iterator[float]:
    """The bar, the shape in the viewport and the picture, once for each that is new."""
    report["lines"], report["shapes"], report["pictures"], taken = [], [], [], 0
    while session.running:
        yield 0.2
        line = followed.progress.line
        if line not in report["lines"]:
            report["lines"].append(line)
        shape = live_preview.find(followed.name)
        size = [round(x, 3) for x in shape.dimensions] if shape else []
        if size and size not in report["shapes"]:
            report["shapes"].append(size)
        picture = followed.picture.name if followed.picture else ""
        if picture and picture not in report["pictures"]:
            report["pictures"].append(picture)
        if shape and len(report["lines"]) >= 8 * (taken + 1):
            taken += 1
            screenshot(f"running_{taken:02}")


def report_on(obj: bpy.types.Object) -> None:
    """What is in the scene."""
    material = obj.active_material
    images = [n.image for n in material.node_tree.nodes if n.type == "TEX_IMAGE"]
    report["asset"] = {
        "objects": meshes(),
        "location": list(obj.location),
        "dimensions": list(obj.dimensions),
        "faces": len(obj.data.polygons),
        "uvs": len(obj.data.uv_layers),
        "materials": [slot.material.name for slot in obj.material_slots],
        "packed": [bool(image.packed_file) for image in images],
        "previews": [o.name for o in bpy.data.objects if live_preview.RUN in o],
    }


def meshes() -> list[str]:
    return [o.name for o in bpy.data.objects if o.type == "MESH"]


paths.Paths.runs = OUT / "runs"
play(steps)
