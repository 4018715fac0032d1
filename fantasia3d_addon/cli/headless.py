"""The add-on without a window: what ``run.py`` does inside Blender or with the bpy module."""

from __future__ import annotations

import argparse
import contextlib
import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

import bpy

from ..asset.asset_folder import read_info
from ..asset.import_asset import import_asset
from ..environment import piped_environ
from ..environment.files import expanded
from ..errors import AddonError, LightError
from ..scene import light as lights
from ..scene import render as scene_render
from . import commands
from .interrupt import ends_at_ctrl_c

USER_ERROR = 2  # the exit code for what the user can fix


def run_job(
    command: Sequence[str | Path],
    asset: Path,
    blend: Path | None = None,
    render: Path | None = None,
    environ: dict[str, str] | None = None,
) -> int:
    """Run the core's ``command``, then import its ``asset`` into this Blender: the exit code.

    The core's progress, messages and exit code reach this terminal unchanged.
    """
    code = _run_core(command, environ or {})
    if code or not (blend or render):
        return code
    return finish(asset, blend, render)


def finish(
    asset: Path,
    blend: str | Path | None = None,
    render: str | Path | None = None,
    light: str | None = None,
) -> int:
    """Import ``asset`` into this Blender, save the scene and render it: the exit code.

    ``light`` is a name or a file; None is the light that the asset was made under. The asset goes
    into the open file, or into an empty one where none is open. No file is left half-written.
    """
    try:
        with ends_at_ctrl_c(), _quiet():
            _finish(asset, blend, render, light)
    except AddonError as error:
        return _report(error)
    return _tell([Path(path) for path in (blend, render) if path])


def command(args: argparse.Namespace) -> int:
    """Run one of :mod:`commands` in this Blender: the exit code."""
    try:
        with ends_at_ctrl_c(), _quiet():
            written = commands.run(args)
    except AddonError as error:
        return _report(error)
    return _tell(written)


def _tell(written: Sequence[Path]) -> int:
    """Print the files that were written: the exit code."""
    try:
        for path in written:
            print(expanded(path, AddonError).absolute(), flush=True)
    except BrokenPipeError:  # the reader of a pipe had enough
        pass
    except OSError as error:
        fix = "Send the output to a file on a disk with space, or to no file."
        text = f"What was written cannot be printed: {error.strerror}."
        return _report(AddonError(text, fix))
    return 0


def _report(error: AddonError) -> int:
    print(f"error: {error}", file=sys.stderr, flush=True)
    return USER_ERROR


def _finish(
    asset: Path, blend: str | Path | None, render: str | Path | None, light: str | None
) -> None:
    is_empty = not bpy.data.filepath
    if is_empty:
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    obj = import_asset(scene, asset, scene.cursor.location)
    bpy.context.view_layer.update()
    # The user's own camera, world and render settings are kept where there are any.
    if is_empty or not scene.camera:
        scene_render.add_camera(scene, obj)
    if is_empty or light or not scene.world:
        lights.set_world(scene, _light_file(light or read_info(asset).get("light")))
        bpy.context.view_layer.update()
        scene_render.expose(scene, obj)
    if is_empty:
        scene_render.set_up_cycles(scene)
    if blend:
        scene_render.save_blend(Path(blend))
    if render:
        scene_render.render_still(Path(render), obj, backdrop=is_empty)


def _light_file(name: str | None) -> Path:
    """The light's file; a light that was deleted does not stop a job of an hour."""
    try:
        return lights.light_file(name or lights.STUDIO)
    except LightError as error:
        print(f"warning: {error.text} The studio light is used instead.", file=sys.stderr)
        return lights.light_file(lights.STUDIO)


def _run_core(command: Sequence[str | Path], environ: dict[str, str]) -> int:
    """Run ``command``; its exit code.

    Ctrl-C reaches the core through the terminal; it stops cleanly and exits with its own code.
    """
    with subprocess.Popen(
        [str(word) for word in command],
        env=piped_environ() | {"PYTHONUNBUFFERED": "1"} | environ,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,  # Blender may have no terminal of its own to pass on
        encoding="utf-8",
        errors="replace",
    ) as process:
        assert process.stdout
        with _ignore_ctrl_c():  # after the start, or the core would inherit it
            for line in process.stdout:
                # Nobody reads it, or the terminal has no such letter: the job continues.
                with contextlib.suppress(OSError, UnicodeEncodeError):
                    print(line, end="", flush=True)
            process.wait()
    code = process.returncode
    return code if code >= 0 else 128 - code  # as a shell reports signals


@contextlib.contextmanager
def _ignore_ctrl_c() -> Iterator[None]:
    """Leave Ctrl-C to the child process."""
    handler = signal.getsignal(signal.SIGINT)
    if handler is None:  # Blender's own handler, which Python could not restore
        yield
        return
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler)


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Keep Blender's own output, a line for each sample, off the terminal."""
    # Blender prints from C: only the file descriptor itself can be redirected.
    sys.stdout.flush()
    stdout = os.dup(1)
    with open(os.devnull, "wb") as nowhere:  # noqa: PTH123
        os.dup2(nowhere.fileno(), 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(stdout, 1)
        os.close(stdout)
