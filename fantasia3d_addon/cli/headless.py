"""The add-on without a window: what ``run.py`` does inside Blender or beside the bpy module."""

from __future__ import annotations

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
from ..environment import clean_environ
from ..errors import AddonError, LightError
from ..scene import light as lights
from . import commands

INPUT = 2  # the exit status of what the user can mend


def main(argv: Sequence[str], core_python: Path, core_root: Path) -> int:
    """Carry out a job of the command line, and take its asset into this Blender: the exit status.

    ``argv`` is that of ``run.py``, with ``--blend FILE`` and ``--render FILE``. The core reads the
    rest itself, so that both worlds have one command line; its progress, sentences and exit
    statuses reach this terminal as they are.
    """
    rest, blend = _take(argv, "--blend")
    rest, render = _take(rest, "--render")
    status, last = _run_core(rest, core_python, core_root)
    if status or not last or not (blend or render):
        return status
    return finish(Path(last), blend, render)


def finish(
    asset: Path,
    blend: str | Path | None = None,
    render: str | Path | None = None,
    light: str | None = None,
) -> int:
    """Import ``asset`` into this Blender, save the scene and render it: the exit status.

    ``light`` is a name or a file; None is the light that the asset was made under. The asset goes
    into the file that is open; where none is, into an empty one. Nothing is half-written.
    """
    try:
        with _quiet():
            _finish(asset, blend, render, light)
    except AddonError as error:
        print(f"error: {error}", file=sys.stderr, flush=True)
        return INPUT
    for path in (blend, render):
        if path:
            print(Path(path).expanduser().absolute(), flush=True)
    return 0


def command(argv: Sequence[str]) -> int:
    """Carry out one of :mod:`commands` in this Blender: the exit status."""
    if {"-h", "--help"} & set(argv):
        commands.parser().parse_args(list(argv))
    try:
        with _quiet():
            made = commands.carry_out(argv)
    except AddonError as error:
        print(f"error: {error}", file=sys.stderr, flush=True)
        return INPUT
    for path in made:
        print(path.expanduser().absolute(), flush=True)
    return 0


def _finish(
    asset: Path, blend: str | Path | None, render: str | Path | None, light: str | None
) -> None:
    fresh = not bpy.data.filepath
    if fresh:
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    target = bpy.context.scene
    obj = import_asset(target, asset, target.cursor.location)
    bpy.context.view_layer.update()
    if fresh or not target.camera:
        render.add_camera(target, obj)
    if fresh or light or not target.world:
        lights.set_world(target, _light_file(light or read_info(asset).get("light")))
        bpy.context.view_layer.update()
        render.expose(target, obj)
    if fresh:
        render.set_up_cycles(target)
    if blend:
        render.save_blend(Path(blend))
    if render:
        render.render_still(Path(render), obj, backdrop=fresh)


def _light_file(name: str | None) -> Path:
    """The light's file; after an hour's work, one that has gone is no reason to stop."""
    try:
        return lights.light_file(name or lights.STUDIO)
    except LightError as error:
        print(f"warning: {error.text} The scene has the studio light instead.", file=sys.stderr)
        return lights.light_file(lights.STUDIO)


def _run_core(argv: Sequence[str], python: Path, root: Path) -> tuple[int, str]:
    """Run ``python -m core``; its exit status, and the last line it printed: the asset's folder.

    Ctrl-C reaches the core through the terminal; it stops cleanly and says so by its status.
    """
    environ = clean_environ() | {"PYTHONPATH": str(root), "PYTHONUNBUFFERED": "1"}
    last = ""
    with subprocess.Popen(
        [str(python), "-P", "-m", "core", *argv],  # -P: the user's folder may hold a "core" too
        env=environ,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        encoding="utf-8",
        errors="replace",
    ) as process:
        assert process.stdout
        with _deaf_to_ctrl_c():  # only now, or the core would inherit it
            for line in process.stdout:
                print(line, end="", flush=True)
                last = line.strip() or last
            process.wait()
    status = process.returncode
    return (status if status >= 0 else 128 - status), last


@contextlib.contextmanager
def _deaf_to_ctrl_c() -> Iterator[None]:
    """Leave Ctrl-C to the child. Blender's own handler, which Python can't put back, may stay."""
    handler = signal.getsignal(signal.SIGINT)
    if handler is None:
        yield
        return
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler)


def _take(argv: Sequence[str], option: str) -> tuple[list[str], str | None]:
    """``argv`` without ``option``, and its value."""
    rest, value, words = [], None, iter(argv)
    for word in words:
        name, equals, given = word.partition("=")
        if name == option:
            value = given if equals else next(words, None)
        else:
            rest.append(word)
    return rest, value


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Keep what Blender's own code prints, a line for each sample, off the terminal."""
    sys.stdout.flush()
    kept = os.dup(1)
    with open(os.devnull, "wb") as nowhere:  # noqa: PTH123
        os.dup2(nowhere.fileno(), 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)
