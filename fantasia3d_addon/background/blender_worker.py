"""The Blender without a window that :mod:`blender_process` sends out: FOLDER holds its order.

``blender -b --factory-startup --python blender_worker.py -- FOLDER``
"""

from __future__ import annotations

import importlib
import json
import os
import sys
import traceback
from pathlib import Path

import bpy

PACKAGE = Path(__file__).resolve().parents[1]


def part(name: str):
    """A module of the add-on, which is not enabled in this Blender."""
    if str(PACKAGE.parent) not in sys.path:
        sys.path.insert(0, str(PACKAGE.parent))
    return importlib.import_module(f"{PACKAGE.name}.{name}")


def answer(folder: Path) -> None:
    """Do what order.json says with the object of in.blend."""
    order = json.loads((folder / "order.json").read_text("utf-8"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(folder / "in.blend")) as (_, wanted):
        wanted.objects = [order["object"]]
    obj = wanted.objects[0]
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.update()

    def say(text: str, share: float) -> None:
        aside = folder / "progress.tmp"
        aside.write_text(json.dumps([text, share]), "utf-8")
        aside.replace(folder / "progress.json")

    if order["task"] == "quads":
        quads = part("mesh.remesh").quad_remesh(obj, say=say, **order["options"])
        bpy.data.libraries.write(str(folder / "out.blend"), {quads}, fake_user=True)
    else:
        import numpy as np

        np.save(folder / "out.npy", part("mesh.asset_browser").render_thumbnail(obj))


def main(folder: Path) -> int:
    """:func:`answer`; what the user can mend becomes error.json and status 2."""
    try:
        answer(folder)
        return 0
    except part("errors").AddonError as error:
        (folder / "error.json").write_text(json.dumps([error.text, error.fix]), "utf-8")
        return 2
    except Exception:
        traceback.print_exc()
        return 1


if __name__ == "__main__":
    status = main(Path(sys.argv[-1]))
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
