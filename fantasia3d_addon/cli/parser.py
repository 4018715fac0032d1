"""The options of what runs in Blender, declared once for ``run.py``. Standard library only, no bpy.

The option's types, ranges and help texts are those of :mod:`fantasia3d_addon.options`.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

from .. import options
from ..environment.files import no_home
from ..options import Option

ASSET = "an asset or run folder; or the name of a mesh object of the open file"
JOBS = ("generate", "texture", "resume")  # the core's commands whose asset Blender may import
ENGINES = ("godot", "unity", "unreal")  # into a folder
# The formats that only Blender writes.
EXPORTS = ("usd", "usdc", "usda", "usdz", "fbx", *ENGINES)
NAMES_OR_PATHS = ("light", "guidance")  # options that are one or the other
AS_WRITTEN = ("asset", "run", "path", "table")  # arguments whose ~ the core does not expand


class Commands(Protocol):
    """A parser with commands, such as ``core.options.Commands``."""

    def add(self, name: str, text: str) -> argparse.ArgumentParser:
        """A new command."""
        ...

    def __getitem__(self, name: str) -> argparse.ArgumentParser:
        """An existing command."""
        ...


def add_blender_commands(commands: Commands) -> None:
    """Add Blender's own commands, and its options of the core's commands."""
    for name in JOBS:
        _add_file(commands[name], "--blend", "FILE.blend", "import the asset and save the scene")
        _add_file(commands[name], "--render", "FILE.png", "render the asset in Cycles")
    _add(commands["export"], options.FLIP_NORMAL_Y)
    _add(commands["export"], options.MATERIAL, default=None)
    lod = commands.add("lod", "An asset with fewer triangles; its UVs and maps are kept.")
    remesh = commands.add("remesh", "An asset as quads, with new UVs and maps.")
    for command in (lod, remesh):
        command.add_argument("asset", metavar="ASSET", help=ASSET)
        command.add_argument(
            "--out", type=Path, required=True, metavar="FILE", help=".glb, .fbx, .obj, .usdc, …"
        )
        _add(command, options.MATERIAL, default=None)
    _add(lod, options.MAX_FACES)
    _add(lod, options.LEVELS)
    _add(lod, options.RATIO)
    _add(remesh, options.QUADS, flag="--max-faces")
    _add(remesh, options.BAKE_SIZE)
    relight = commands.add(
        "relight", "An asset in another light: a picture, a turntable, a Blender file."
    )
    physics = commands.add("physics", "An asset simulated and baked; --render shows one frame.")
    cornell = commands.add("cornell", "Assets side by side in a Cornell box.")
    for command in (relight, physics):
        command.add_argument("asset", metavar="ASSET", help=ASSET)
    cornell.add_argument("asset", metavar="ASSET", nargs="+", help=ASSET)
    cornell.add_argument(
        "--same-size",
        action="store_true",
        help="scale each to the size of the largest: a ring next to a tiger is hard to see",
    )
    _add_relight(relight)
    _add_physics(physics)
    _add_picture_options(cornell)


def runs_in_blender(args: argparse.Namespace) -> bool:
    """Whether only Blender can carry the command out."""
    if args.command == "export":
        changed = bool(args.material) or args.flip_normal_y
        return changed or args.format.lower() in (*EXPORTS, "blend")
    return args.command in ("relight", "physics", "cornell", "lod", "remesh")


def saves_blend(args: argparse.Namespace) -> bool:
    """Whether an asset only has to be saved as a Blender file."""
    return args.command == "export" and args.format.lower() == "blend"


def imports_asset(args: argparse.Namespace) -> bool:
    """Whether Blender imports the asset that the core makes."""
    return args.command in JOBS and bool(args.blend or args.render)


def unknown_home(args: argparse.Namespace) -> tuple[str, str] | None:
    """The fault and the fix of a path in a home folder that does not exist; None: no such path.

    The path of an asset, a run, a mesh or a table is used as it is written, and may have such a
    name.
    """
    for name, value in vars(args).items():
        for path in value if isinstance(value, list) else [value]:
            named = name in NAMES_OR_PATHS and isinstance(path, str)
            if (named or isinstance(path, Path)) and name not in AS_WRITTEN:
                try:
                    Path(path).expanduser()
                except RuntimeError:
                    return no_home(path)
    return None


class _Once(argparse.Action):
    """A file that may be given only once: of two, one would be lost silently."""

    def __call__(self, parser: Any, namespace: Any, values: Any, option: Any = None) -> None:
        if getattr(namespace, self.dest) is not None:
            parser.error(f"{option} was given twice")
        setattr(namespace, self.dest, values)


def _add_file(command: argparse.ArgumentParser, flag: str, metavar: str, text: str) -> None:
    command.add_argument(flag, type=Path, metavar=metavar, action=_Once, help=text)


def _add_relight(command: argparse.ArgumentParser) -> None:
    command.add_argument("--turntable", type=Path, metavar="FILE.mp4|FOLDER")
    _add(command, options.TURN)
    _add(command, options.TURN_FRAMES)
    _add_picture_options(command)
    _add_light_options(command)


def _add_physics(command: argparse.ArgumentParser) -> None:
    _add(command, options.KIND, flag="--physics", required=True, default=None)
    for option in options.SIMULATION:
        _add(command, option)
    command.add_argument("--at", type=int, metavar="FRAME", help="rendered; default: the last")
    _add_picture_options(command)
    _add_light_options(command)


def _add_picture_options(command: argparse.ArgumentParser) -> None:
    _add(command, options.MATERIAL, default=None)
    _add_file(command, "--blend", "FILE.blend", "save the scene")
    _add_file(command, "--render", "FILE.png", "render it in Cycles")
    _add(command, options.SIZE)
    _add(command, options.SAMPLES)


def _add_light_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("--light", metavar="FILE|NAME", help="default: the asset's own")
    # No default: without it the exposure is set so that white is just not clipped.
    _add(command, options.STRENGTH, default=None)
    # No default: without it a low sun is to the side of the camera, and shadows are long.
    _add(command, options.ROTATION, flag="--rotation-deg", default=None)


def _add(command: argparse.ArgumentParser, option: Option, flag: str = "", **more: Any) -> None:
    """Add ``option`` as ``--its-name``; ``more`` overrides parts of it."""
    flag = flag or f"--{option.name.replace('_', '-')}"
    settings: dict[str, Any] = {"dest": option.name, "help": option.tip.replace("%", "%%")}
    if isinstance(option.default, bool):
        settings |= {"action": "store_true"}
    elif option.items:  # in lower case, as a command line has it
        choices = [name.lower() for name in option.names]
        settings |= {"choices": choices, "default": str(option.default).lower()}
    else:
        settings |= {"type": _checked(option), "default": option.default}
        settings |= {"metavar": "NAME" if isinstance(option.default, str) else "NUMBER"}
    command.add_argument(flag, **(settings | more))


def _checked(option: Option) -> Callable[[str], Any]:
    """A reader of the option's value that refuses what is not in its range."""

    def read(text: str) -> Any:
        if isinstance(option.default, str):
            return text
        try:
            value = type(option.default)(text)
        except ValueError:
            value = float("nan")
        if not option.allows(value):
            raise argparse.ArgumentTypeError(f"{text!r} is not allowed; use {option.range}")
        return value

    return read
