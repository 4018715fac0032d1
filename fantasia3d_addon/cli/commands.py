"""The commands of ``run.py`` that are Blender's: relight, physics, cornell, and some exports."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

import bpy
import numpy as np

from ..asset.asset_folder import read_info
from ..asset.import_asset import import_asset
from ..blender.mesh_arrays import mesh_object, world_verts
from ..errors import AddonError, LightError
from ..material import edit as material_edit
from ..mesh import export
from ..physics import simulation
from ..scene import cornell_box, light, relight, render


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one sentence."""

    def error(self, message: str) -> NoReturn:
        raise AddonError(f"{message[:1].upper()}{message[1:]}.", f"See: run.py {self.prog} --help")


def parser() -> Parser:
    """All commands and their options."""
    top = Parser(prog="", usage="run.py COMMAND …", description=__doc__, allow_abbrev=False)
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    asset_help = "an asset or run folder; or the name of a mesh object of the open file"

    def add(name: str, text: str, many: bool = False) -> Parser:
        command = commands.add_parser(name, help=text, description=text, allow_abbrev=False)
        nargs = {"nargs": "+"} if many else {}
        command.add_argument("asset", metavar="ASSET", help=asset_help, **nargs)
        return command

    turn = add("relight", "An asset under another light: a picture, a turntable, a Blender file.")
    turn.add_argument("--turntable", type=Path, metavar="FILE.mp4|FOLDER")
    turn.add_argument("--turn", default="camera", choices=[t.lower() for t in relight.TURNS])
    turn.add_argument("--frames", type=int, default=48, help="of the turntable")
    fall = add("physics", "An asset simulated and baked; --render shows one frame.")
    kinds = [kind.lower() for kind in simulation.KINDS]
    fall.add_argument("--physics", dest="kind", required=True, choices=kinds)
    fall.add_argument("--frames", type=int, default=60)
    fall.add_argument("--height", type=float, default=0.5, metavar="METRES")
    fall.add_argument("--convex", action="store_true", help="rigid: one hull")
    fall.add_argument("--softness", type=float, default=0.5, metavar="0..1")
    fall.add_argument("--self-collision", action="store_true", help="cloth")
    fall.add_argument("--at", type=int, metavar="FRAME", help="rendered; default: the last")
    box = add("cornell", "Assets side by side in a Cornell box.", many=True)
    for command in (turn, fall, box):
        _add_picture_options(command)
    for command in (turn, fall):
        command.add_argument("--light", metavar="FILE|NAME", help="default: the asset's own")
        command.add_argument("--strength", type=float, help="default: white is just white")
        command.add_argument("--rotation-deg", type=float, default=0.0)
    out = add("export", "An asset as one file for another program.")
    out.add_argument("--format", required=True)
    out.add_argument("--out", type=Path, required=True, metavar="FILE")
    out.add_argument("--flip-normal-y", action="store_true", help="DirectX normals: FBX, OBJ")
    out.add_argument("--material", metavar="NAME", help="wood, gold, … instead of its own")
    return top


def _add_picture_options(command: Parser) -> None:
    command.add_argument("--material", metavar="NAME", help="wood, gold, … instead of its own")
    command.add_argument("--blend", type=Path, metavar="FILE.blend")
    command.add_argument("--render", type=Path, metavar="FILE.png")
    command.add_argument("--size", type=int, default=640, help="pixels")
    command.add_argument("--samples", type=int, help="default: as many as a clean picture takes")


def carry_out(argv: Sequence[str]) -> list[Path]:
    """Do what ``argv`` asks for; the files that were made.

    Raises:
        AddonError: what the user can mend.
    """
    args = parser().parse_args(argv)
    _check(args)
    fresh = not bpy.data.filepath
    if fresh:
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    names = [args.asset] if isinstance(args.asset, str) else args.asset
    objs = [_object(name) for name in names]
    for obj in objs if args.material else ():
        material_edit.replace_material(obj, args.material)
    bpy.context.view_layer.update()
    if args.command == "export":
        return [export.export_object(objs[0], args.out, args.flip_normal_y)]
    act = {"relight": _relight, "physics": _physics, "cornell": _cornell}[args.command]
    return act(args, objs, fresh)


def _check(args: argparse.Namespace) -> None:
    if args.command == "export":
        ending = f".{args.format.lower()}"
        known = ending in export.ENDINGS
        if not known or args.out.suffix.lower() not in (ending, *_USD.get(ending, ())):
            raise AddonError(
                f"--out is {str(args.out)!r}, --format {args.format!r}.",
                f"The format is one of {', '.join(e[1:] for e in export.ENDINGS)}, and the "
                "file's name ends in it.",
            )
        return
    if not (args.blend or args.render or getattr(args, "turntable", None)):
        more = ", --turntable" if args.command == "relight" else ""
        raise AddonError("There is nothing to make.", f"Name --render{more} or --blend.")
    if args.render and args.render.suffix.lower() not in render.FORMATS:
        raise AddonError(
            f"--render is {str(args.render)!r}.", f"Its name ends in {', '.join(render.FORMATS)}."
        )


_USD = {".usd": (".usdc", ".usda", ".usdz")}


def _object(name: str) -> bpy.types.Object:
    """The asset of a folder, imported; or an object of the open file."""
    if not Path(name).exists() and name in bpy.data.objects:
        return mesh_object(bpy.data.objects[name])
    target = bpy.context.scene
    obj = import_asset(target, Path(name).expanduser(), target.cursor.location)
    obj["fantasia3d_light"] = str(read_info(Path(name).expanduser()).get("light") or light.STUDIO)
    return obj


def _relight(args: argparse.Namespace, objs: list[bpy.types.Object], fresh: bool) -> list[Path]:
    target, obj = bpy.context.scene, objs[0]
    if fresh or not target.camera:
        render.add_camera(target, obj)
    _light(args, obj)
    render.set_up_cycles(target, args.size, args.samples)
    made = _files(args, obj, backdrop=fresh)
    if args.turntable:
        made.append(
            relight.turntable(
                obj, args.turntable, frames=args.frames, turn=args.turn.upper(), size=args.size,
                samples=args.samples,
            )
        )  # fmt: skip
    return made


def _physics(args: argparse.Namespace, objs: list[bpy.types.Object], fresh: bool) -> list[Path]:
    target, obj = bpy.context.scene, objs[0]
    options = simulation.Options(
        frames=args.frames, height=args.height, convex=args.convex, softness=args.softness,
        self_collision=args.self_collision,
    )  # fmt: skip
    simulation.simulate(obj, args.kind.upper(), options)
    first = target.frame_start
    last = first + args.frames - 1
    target.frame_end = last
    if fresh or not target.camera:
        render.add_camera_about(target, *render.sphere_about(_reach(obj, first, last)))
    target.frame_set(first)
    _light(args, obj)
    render.set_up_cycles(target, args.size, args.samples)
    ground = bpy.data.objects.get(simulation.GROUND)
    if ground and fresh:
        ground.is_shadow_catcher = True
        render.hide_world(target)
    target.frame_set(min(max(args.at or last, first), last))
    return _files(args, obj, backdrop=False)


def _cornell(args: argparse.Namespace, objs: list[bpy.types.Object], _fresh: bool) -> list[Path]:
    target = bpy.context.scene
    cornell_box.build(target, objs)
    render.set_up_cycles(target, args.size, args.samples or 128)
    target.cycles.max_bounces = 10
    target.cycles.adaptive_threshold = 0.02  # nothing there is lit evenly
    target.view_settings.exposure = cornell_box.EXPOSURE
    return _files(args, objs[0], backdrop=False)


def _reach(obj: bpy.types.Object, first: int, last: int) -> np.ndarray:
    """The points (N,3) of the asset and of its sheet at the first and at the last frame."""
    shown = [obj, *(o for o in bpy.data.objects if o.name == f"{obj.name} sheet")]
    points = []
    for frame in (first, last):
        bpy.context.scene.frame_set(frame)
        points += [world_verts(each) for each in shown]
    return np.concatenate(points)


def _light(args: argparse.Namespace, obj: bpy.types.Object) -> None:
    target = bpy.context.scene
    name = args.light or obj.get("fantasia3d_light", light.STUDIO)
    try:
        relight.relight(target, name, args.strength or 1.0, args.rotation_deg)
    except LightError as error:
        if args.light:
            raise
        print(f"warning: {error.text} The studio light stands in.", file=sys.stderr)
        relight.relight(target, light.STUDIO, args.strength or 1.0, args.rotation_deg)
    bpy.context.view_layer.update()
    if args.strength is None:
        render.expose(target, obj)


def _files(args: argparse.Namespace, obj: bpy.types.Object, backdrop: bool) -> list[Path]:
    made = []
    if args.blend:
        render.save_blend(args.blend)
        made.append(args.blend)
    if args.render:
        render.render_still(args.render, obj, backdrop=backdrop)
        made.append(args.render)
    return made
