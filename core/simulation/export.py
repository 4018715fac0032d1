"""Writes an asset for a simulator: one file, and a folder of meshes and pictures next to it."""

import shutil
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

from core.errors import UserError
from core.geometry.tangents import shading_normals
from core.io.asset import Asset, check_output, read_asset
from core.io.atomic import atomic_file, disk_errors
from core.io.input_file import check_name
from core.io.maps import Maps
from core.io.obj import from_y_up, mtl_text, obj_text, plain_obj_text
from core.simulation.body import Body, body_of, identifier, parts_folder
from core.simulation.hulls import MAX_HULLS, Hull
from core.simulation.mjcf import mjcf_text
from core.simulation.urdf import urdf_text
from core.simulation.usd_physics import usd_text

ENDINGS = {"urdf": ".urdf", "mjcf": ".xml", "usd-physics": ".usda"}
PICTURES = ("base_color", "normal", "emission")  # roles, for an OBJ's material


def export_body(
    folder: Path, format: str, out: Path, mass: float | None = None, most: int = MAX_HULLS
) -> Path:
    """Write the asset of ``folder`` as "urdf", "mjcf" or "usd-physics" to ``out``.

    Raises UserError for another ending, no asset, or a place that cannot be written.
    """
    out = Path(out)
    if out.suffix.lower() != ENDINGS[format]:
        raise UserError(
            f"{out} does not end in {ENDINGS[format]}.", f"Name a {ENDINGS[format]} file."
        )
    check_output(out)
    check_name(Path(out.name))  # which is in the text
    body, parts = body_of(read_asset(folder), mass, most), parts_folder(out)
    text = {"urdf": urdf_text, "mjcf": mjcf_text, "usd-physics": usd_text}[format](body, parts)
    with disk_errors(out):
        out.with_name(parts).mkdir(exist_ok=True)
    with ExitStack() as files:  # the file itself gets its name last: what it names is there then
        main = files.enter_context(atomic_file(out))
        main.write_text(text, encoding="utf-8")
        _write_parts(files, out.with_name(parts), body, with_meshes=format != "usd-physics")
    return out


def file_for(asset: Path, out: Path, ending: str) -> Path:
    """``out``; where it has no ending it is a folder, made, and the file is named by the prompt."""
    if out.suffix:
        return out
    prompt = "" if asset.is_file() else str(read_asset(asset).info.get("prompt") or "")
    title = identifier(prompt or asset.stem)
    with disk_errors(out):
        out.mkdir(parents=True, exist_ok=True)
    return out / f"{title}{ending}"


def _write_parts(files: ExitStack, folder: Path, body: Body, with_meshes: bool) -> None:
    roles = PICTURES if with_meshes else Maps._fields
    for name in (f"{role}.png" for role in roles if getattr(body.asset.maps, role) is not None):
        shutil.copyfile(body.asset.folder / name, files.enter_context(atomic_file(folder / name)))
    for name, text in _meshes(body).items() if with_meshes else ():
        path = files.enter_context(atomic_file(folder / name))
        path.write_text(text, encoding="utf-8")


def _meshes(body: Body) -> dict[str, str]:
    """The texts of the visible mesh, its material, and the hulls. Simulators keep an OBJ's axes."""
    texts = {f"hull_{i:02}.obj": _upright(hull) for i, hull in enumerate(body.hulls)}
    texts["visual.obj"] = _visual(body.asset)
    emission = "" if body.asset.maps.emission is None else "emission.png"
    texts["visual.mtl"] = mtl_text("visual", "base_color.png", "normal.png", emission=emission)
    return texts


def _visual(asset: Asset) -> str:
    mesh = asset.mesh
    normals = shading_normals(mesh)
    upright = replace(mesh, verts=from_y_up(mesh.verts))
    return obj_text(upright, normals._replace(each=from_y_up(normals.each)), "visual")


def _upright(hull: Hull) -> str:
    return plain_obj_text(from_y_up(hull[0]), hull[1])
