"""Many jobs in a row from one Blender, each with a fake core: this process's resources.

    python -m blender_tests.long_session 100

One JSON object a line, each tenth job. Of ten jobs seven end in an asset, which the user then
deletes; one fails, one dies, and one shows its shape and is cancelled.
"""

from __future__ import annotations

import gc
import json
import os
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import bpy

import fantasia3d_addon
from blender_tests.asset_fixture import write_asset
from blender_tests.conftest import FAKE_CORE
from fantasia3d_addon import environment
from fantasia3d_addon.jobs import paths, submit
from fantasia3d_addon.jobs.session import session

PROMPTS = ("chair",) * 7 + ("fail", "die", "show")
PATIENCE = 120.0  # seconds for one job


def jobs(count: int, folder: Path) -> Iterator[dict]:
    """Do ``count`` jobs; what is held after each tenth."""
    os.environ["FANTASIA3D_PYTHON"] = sys.executable
    environment.project_root = lambda: FAKE_CORE
    paths.Paths.runs = folder / "runs"
    bpy.ops.wm.read_factory_settings(use_empty=True)
    timers = counted_timers()
    fantasia3d_addon.register()
    settings = bpy.context.scene.fantasia3d
    settings.negative_prompt = str(write_asset(folder / "made"))
    for i in range(count):
        settings.prompt = PROMPTS[i % len(PROMPTS)]
        one_job()
        if i % 10 == 9:
            yield {"jobs": i + 1, **held(), "timers": len(timers)}
    fantasia3d_addon.unregister()


def one_job() -> None:
    """Request the settings' job, and delete its result."""
    submit.generate(bpy.context)
    deadline = time.monotonic() + PATIENCE
    while session.tick() is not None:
        assert time.monotonic() < deadline
        if session.running and session.running[0].progress.step > 0 and is_endless():
            session.cancel()
        time.sleep(0.02)
    made = [*bpy.data.objects, *bpy.data.meshes, *bpy.data.materials, *bpy.data.images]
    bpy.data.batch_remove(made)


def is_endless() -> bool:
    """Whether the running job ends by a cancel alone."""
    return session.running[0].prompt == "show" and not session.running[0].progress.cancelling


def counted_timers() -> set[Callable]:
    """The functions that are registered as timers, from now on."""
    timers: set[Callable] = set()
    register, unregister = bpy.app.timers.register, bpy.app.timers.unregister

    class Timers:
        is_registered = staticmethod(lambda function: function in timers)

        @staticmethod
        def register(function: Callable, **options: object) -> None:
            timers.add(function)
            register(function, **options)

        @staticmethod
        def unregister(function: Callable) -> None:
            timers.discard(function)
            unregister(function)

    bpy.app = type("App", (), {"timers": Timers, "__getattr__": getattr_of(bpy.app)})()
    return timers


def getattr_of(owner: object) -> Callable:
    """``__getattr__`` for a fake of ``owner``."""
    return lambda _self, name: getattr(owner, name)


def held() -> dict[str, int]:
    """Memory in kB, open files, threads, child processes, datablocks of this process (Linux)."""
    gc.collect()
    status = Path("/proc/self/status").read_text().split("VmRSS:")[1].split()[0]
    kinds = ("objects", "meshes", "materials", "images", "node_groups", "collections", "worlds")
    children = Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children").read_text().split()
    return {
        "memory_kb": int(status),
        "files": len(list(Path("/proc/self/fd").iterdir())),
        "threads": threading.active_count(),
        "processes": len(children),
        "datablocks": sum(len(getattr(bpy.data, kind)) for kind in kinds),
    }


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        for row in jobs(int(sys.argv[1]), Path(place)):
            print(json.dumps(row), flush=True)
    os._exit(0)  # bpy may hang at an ordinary exit
