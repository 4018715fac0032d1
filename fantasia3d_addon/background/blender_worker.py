"""The program of the Blender process that :mod:`blender_process` starts.

``blender -b --factory-startup --python blender_worker.py -- FOLDER``; FOLDER holds request.json
and in.blend, and receives the answer.
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


def module(name: str):
    """A module of the add-on, which is not enabled in this Blender."""
    if str(PACKAGE.parent) not in sys.path:
        sys.path.insert(0, str(PACKAGE.parent))
    return importlib.import_module(f"{PACKAGE.name}.{name}")


def answer(folder: Path) -> None:
    """Run the task of request.json with the object of in.blend."""
    request = json.loads((folder / "request.json").read_text("utf-8"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(folder / "in.blend")) as (_, wanted):
        wanted.objects = [request["object"]]
    obj = wanted.objects[0]
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.update()
    write_text = module("environment.files").write_text

    def progress(text: str, fraction: float) -> None:
        write_text(folder / "progress.json", json.dumps([text, fraction]))

    if request["task"] == "quads":
        quads = module("mesh.remesh").quad_remesh(obj, progress=progress, **request["options"])
        bpy.data.libraries.write(str(folder / "out.blend"), {quads}, fake_user=True)
    else:
        import numpy as np

        np.save(folder / "out.npy", module("mesh.asset_browser").render_thumbnail(obj))


def main(folder: Path) -> int:
    """:func:`answer`; an AddonError becomes error.json and exit code 2."""
    try:
        answer(folder)
        return 0
    except module("errors").AddonError as error:
        (folder / "error.json").write_text(json.dumps([error.text, error.fix]), "utf-8")
        return 2
    except Exception:
        traceback.print_exc()
        return 1


if __name__ == "__main__":
    code = main(Path(sys.argv[-1]))
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)  # the bpy module may hang in an ordinary exit
