"""The commands of ``run.py`` that run in Blender: relight, physics, cornell, and some exports."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

import bpy
import numpy as np

from .. import options
from ..asset.asset_folder import read_info
from ..asset.import_asset import import_asset
from ..blender.mesh_arrays import mesh_object, world_verts
from ..environment.files import expanded
from ..errors import AddonError, LightError
from ..material import edit as material_edit
from ..mesh import engines, export, remesh
from ..physics import simulation
from ..scene import cornell_box, light, relight
from ..scene import render as scene_render

LIGHT = "fantasia3d_light"  # custom property: the light that an imported asset was made under
DEFAULT_USD = ".usdc"  # of --format usd into a folder
SEVERAL_USD = {".usd": (".usdc", ".usda", ".usdz")}  # --format usd allows each of these


def run(args: argparse.Namespace) -> list[Path]:
    """Run a parsed command; the files that were written.

    Raises:
        AddonError: what the user can fix.
    """
    _check(args)
    is_empty = not bpy.data.filepath
    if is_empty:
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    names = args.asset if isinstance(args.asset, list) else [args.asset]
    objs = [_object(str(name)) for name in names]
    for obj in objs if args.material else ():
        material_edit.replace_material(obj, args.material)
    bpy.context.view_layer.update()
    if args.command == "export":
        return [_export(args, objs[0])]
    if args.command in ("lod", "remesh"):
        return {"lod": _lod, "remesh": _remesh}[args.command](args, objs[0])
    act = {"relight": _relight, "physics": _physics, "cornell": _cornell}[args.command]
    return act(args, objs, is_empty)


def _check(args: argparse.Namespace) -> None:
    """Refuse before the work what could not be written after it."""
    if args.command == "export":
        if args.format.lower() in engines.ENGINES:
            if args.flip_normal_y or args.out.suffix:
                raise AddonError(
                    f"--format {args.format} writes a folder, with the normal map of its engine.",
                    "Name a folder with --out, and leave --flip-normal-y out.",
                )
            return
        if not args.out.suffix:
            return  # a folder
        ending = f".{args.format.lower()}"
        known = ending in export.ENDINGS
        if not known or args.out.suffix.lower() not in (ending, *SEVERAL_USD.get(ending, ())):
            raise AddonError(
                f"--out is {str(args.out)!r}, --format {args.format!r}.",
                f"The format is one of {', '.join(e[1:] for e in export.ENDINGS)}, and the "
                "file's name ends in it.",
            )
        return
    if args.command in ("lod", "remesh"):
        export.check_format(args.out, False)
        return
    if not (args.blend or args.render or getattr(args, "turntable", None)):
        more = ", --turntable" if args.command == "relight" else ""
        raise AddonError("There is nothing to write.", f"Add --render{more} or --blend.")
    if args.render and args.render.suffix.lower() not in scene_render.FORMATS:
        endings = ", ".join(scene_render.FORMATS)
        raise AddonError(f"--render is {str(args.render)!r}.", f"Its name ends in {endings}.")


def _export(args: argparse.Namespace, obj: bpy.types.Object) -> Path:
    """Into the file that --out names; into a folder where it has no ending."""
    kind = args.format.lower()
    if kind in engines.ENGINES:
        return engines.export_for(obj, args.out, kind)
    out = args.out
    if not out.suffix:
        out = out / f"{engines.plain_name(obj.name)}{DEFAULT_USD if kind == 'usd' else f'.{kind}'}"
    return export.export_object(obj, out, args.flip_normal_y)


def _lod(args: argparse.Namespace, obj: bpy.types.Object) -> list[Path]:
    """One file with --max-faces; else FILE_LOD1 and so on next to the file that --out names."""
    lods = remesh.make_lods(obj, args.levels, args.ratio, args.max_faces)
    out, several = args.out, not args.max_faces
    names = [f"{out.stem}_LOD{i}{out.suffix}" if several else out.name for i in range(1, 99)]
    for lod in lods:  # the exporters leave hidden objects out
        lod.hide_set(False)
    pairs = zip(lods, names, strict=False)
    return [export.export_object(lod, out.with_name(name)) for lod, name in pairs]


def _remesh(args: argparse.Namespace, obj: bpy.types.Object) -> list[Path]:
    quads = remesh.quad_remesh(obj, args.faces, args.texture_size)
    return [export.export_object(quads, args.out)]


def _object(name: str) -> bpy.types.Object:
    """The asset of a folder, imported; or an object of the open file."""
    # Not Path.exists, which raises for a name that is too long; bytes that are no text name none.
    if not os.path.exists(name) and name in {obj.name for obj in bpy.data.objects}:  # noqa: PTH110
        return mesh_object(bpy.data.objects[name])
    scene = bpy.context.scene
    folder = expanded(name, AddonError)
    obj = import_asset(scene, folder, scene.cursor.location)
    obj[LIGHT] = str(read_info(folder).get("light") or light.STUDIO)
    return obj


def _relight(args: argparse.Namespace, objs: list[bpy.types.Object], is_empty: bool) -> list[Path]:
    scene, obj = bpy.context.scene, objs[0]
    if is_empty or not scene.camera:
        scene_render.add_camera(scene, obj)
    _set_light(args, obj)
    scene_render.set_up_cycles(scene, args.size, args.samples)
    written = _write(args, obj, backdrop=is_empty)
    if args.turntable:
        settings = {"frames": args.frames, "size": args.size, "samples": args.samples}
        written.append(relight.turntable(obj, args.turntable, turn=args.turn.upper(), **settings))
    return written


def _physics(args: argparse.Namespace, objs: list[bpy.types.Object], is_empty: bool) -> list[Path]:
    scene, obj = bpy.context.scene, objs[0]
    settings = {option.name: getattr(args, option.name) for option in options.SIMULATION}
    first = scene.frame_start
    # The picture is of the last frame unless --at names one.
    last = first + args.frames - 1
    at = last if args.at is None else args.at
    if not first <= at <= last:
        raise AddonError(f"--at is {at}.", f"Use a frame from {first} to {last}.")
    kind, chosen = args.kind.upper(), simulation.Options(**settings)
    simulation.simulate(obj, kind, chosen)
    note = simulation.note_of(obj, kind, chosen)
    if note:
        print(f"note: {note}", file=sys.stderr)
    scene.frame_end = last
    if is_empty or not scene.camera:
        # The camera sees the whole fall, not only the place where it starts.
        center, radius = scene_render.sphere_about(_points_of_fall(obj, first, last))
        scene_render.add_camera_about(scene, center, radius)
    scene.frame_set(first)
    _set_light(args, obj)
    scene_render.set_up_cycles(scene, args.size, args.samples)
    ground = bpy.data.objects.get(simulation.GROUND)
    if ground and is_empty:  # the simulation's own ground serves as the backdrop
        ground.is_shadow_catcher = True
        scene_render.hide_world(scene)
    scene.frame_set(at)
    return _write(args, obj, backdrop=False)


def _cornell(args: argparse.Namespace, objs: list[bpy.types.Object], _is_empty: bool) -> list[Path]:
    scene = bpy.context.scene
    if args.same_size:
        _make_same_size(objs)
    cornell_box.build(scene, objs)
    scene_render.set_up_cycles(scene, args.size, args.samples or 128)
    scene.cycles.max_bounces = 10  # most of the light in the box is indirect
    scene.cycles.adaptive_threshold = 0.02  # no part of the picture is evenly lit
    scene.view_settings.exposure = cornell_box.EXPOSURE
    return _write(args, objs[0], backdrop=False)


def _make_same_size(objs: list[bpy.types.Object]) -> None:
    """Scale each object so that it is as wide or high, as the box's camera sees it, as the most."""
    sides = [float(np.ptp(world_verts(obj), axis=0)[[0, 2]].max()) for obj in objs]
    for obj, side in zip(objs, sides, strict=True):
        obj.scale *= max(sides) / side
    bpy.context.view_layer.update()


def _points_of_fall(obj: bpy.types.Object, first: int, last: int) -> np.ndarray:
    """The vertices (N,3) of the asset and of its sheet at the first and at the last frame."""
    shown = [obj, *(o for o in bpy.data.objects if o.name == f"{obj.name} sheet")]
    points = []
    for frame in (first, last):
        bpy.context.scene.frame_set(frame)
        points += [world_verts(each) for each in shown]
    return np.concatenate(points)


def _set_light(args: argparse.Namespace, obj: bpy.types.Object) -> None:
    scene, strength = bpy.context.scene, 1.0 if args.strength is None else args.strength
    name = obj.get(LIGHT, light.STUDIO) if args.light is None else args.light
    try:
        relight.relight(scene, name, strength, args.rotation or 0.0)
    except LightError as error:
        if args.light is not None:
            raise
        # The asset's own light was deleted since: that does not stop the command.
        print(f"warning: {error.text} The studio light is used instead.", file=sys.stderr)
        relight.relight(scene, light.STUDIO, strength, args.rotation or 0.0)
    if args.rotation is None:
        scene_render.turn_low_sun(scene)
    bpy.context.view_layer.update()
    if args.strength is None:
        scene_render.expose(scene, obj)


def _write(args: argparse.Namespace, obj: bpy.types.Object, backdrop: bool) -> list[Path]:
    written = []
    if args.blend:
        scene_render.save_blend(args.blend)
        written.append(args.blend)
    if args.render:
        scene_render.render_still(args.render, obj, backdrop=backdrop)
        written.append(args.render)
    return written
