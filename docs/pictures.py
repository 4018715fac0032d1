"""Renders the pictures of docs/recipes.md from three asset folders.

    python3 run.py setup blender
    python3 run.py python docs/pictures.py CHAIR TORUS MUG [NAME...]

NAME is relighting, materials, cornell or physics. All take about a quarter of an hour of one core,
and are saved in docs/images.
"""

import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import bpy
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.cli import commands  # noqa: E402
from fantasia3d_addon.material import edit as material_edit  # noqa: E402
from fantasia3d_addon.physics import simulation  # noqa: E402
from fantasia3d_addon.scene import cornell_box, light, relight, render  # noqa: E402

IMAGES = ROOT / "docs" / "images"
GAP = 6
SAMPLES = 16  # of a pixel, then the denoiser


def empty() -> bpy.types.Scene:
    """A file with nothing in it."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return bpy.context.scene


def looked_at(folder: Path, size: int, azimuth_deg: float = 32.0) -> bpy.types.Object:
    """The asset under the studio light, before a camera that sees all of it."""
    target = empty()
    obj = import_asset(target, folder)
    bpy.context.view_layer.update()
    render.add_camera(target, obj, azimuth_deg)
    render.set_up_cycles(target, size, SAMPLES)
    return obj


def lit(obj: bpy.types.Object, name: str, rotation_deg: float = 0.0) -> None:
    """Light it so that white is just white."""
    relight.relight(bpy.context.scene, name, rotation_deg=rotation_deg)
    bpy.context.view_layer.update()
    render.expose(bpy.context.scene, obj)


def shot(obj: bpy.types.Object, backdrop: bool = True) -> Image.Image:
    """A picture through the scene's camera."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "shot.png"
        render.render_still(path, obj, backdrop)
        return Image.open(path).convert("RGB")


def relighting(chair: Path, torus: Path, _mug: Path) -> list[list[Image.Image]]:
    """Two assets, each under three of Blender's own lights."""
    rows = []
    for folder in (torus, chair):
        obj = looked_at(folder, 230)
        row = []
        for name, turn in (("city", 0), ("sunset", 60), ("forest", 0)):
            lit(obj, name, turn)
            row.append(shot(obj))
        rows.append(row)
    return rows


def materials(chair: Path, _torus: Path, _mug: Path) -> list[list[Image.Image]]:
    """The chair as it was made, and in other materials."""
    obj = looked_at(chair, 250)
    lit(obj, light.STUDIO)
    row = [shot(obj)]
    for name in ("wood", "gold", "marble"):
        material_edit.replace_material(obj, name)
        row.append(shot(obj))
    return [row]


def cornell(chair: Path, torus: Path, mug: Path) -> list[list[Image.Image]]:
    """All three in the box, about as large as one another, the mug on the torus's other side."""
    target = empty()
    objs = [import_asset(target, folder) for folder in (torus, chair, mug)]
    for obj, size in zip(objs, (0.8, 1.0, 0.62), strict=True):
        obj.scale = (size / max(obj.dimensions),) * 3
    objs[1].rotation_euler.z = -0.35
    cornell_box.build(target, objs)
    render.set_up_cycles(target, 420, 3 * SAMPLES)
    target.cycles.max_bounces, target.cycles.adaptive_threshold = 10, 0.02
    target.view_settings.exposure = cornell_box.EXPOSURE
    return [[shot(objs[0], backdrop=False)]]


def frames(
    folder: Path, kind: str, options: simulation.Options, at: tuple[int, ...]
) -> Iterator[Image.Image]:
    """Some frames of a simulation."""
    target = empty()
    obj = import_asset(target, folder)
    obj.rotation_euler.z = 0.2
    bpy.context.view_layer.update()
    simulation.simulate(obj, kind, options)
    points = commands._points_of_fall(obj, at[0], at[-1])
    render.add_camera_about(target, *render.sphere_about(points))
    target.frame_set(1)
    lit(obj, light.STUDIO)
    render.set_up_cycles(target, 200, SAMPLES)
    if ground := bpy.data.objects.get(simulation.GROUND):
        ground.is_shadow_catcher = True
        render.hide_world(target)
    for frame in at:
        target.frame_set(frame)
        yield shot(obj, backdrop=False)


def physics_rows(chair: Path, _torus: Path, _mug: Path) -> list[list[Image.Image]]:
    """A soft body, a cloth, and a sheet over the chair."""
    soft = simulation.Options(frames=40, height=0.6, softness=0.45)
    cloth = simulation.Options(frames=40, height=0.4)
    drape = simulation.Options(frames=60)
    return [
        list(frames(chair, "SOFT", soft, (1, 14, 20, 28))),
        list(frames(chair, "CLOTH", cloth, (1, 12, 20, 36))),
        list(frames(chair, "DRAPE", drape, (1, 16, 28, 60))),
    ]


def save(name: str, rows: list[list[Image.Image]]) -> None:
    """All pictures as one JPEG, with white between them."""
    size = rows[0][0].width
    width, height = len(rows[0]) * (size + GAP) - GAP, len(rows) * (size + GAP) - GAP
    sheet = Image.new("RGB", (width, height), "white")
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            sheet.paste(picture, (x * (size + GAP), y * (size + GAP)))
    sheet.save(IMAGES / f"{name}.jpg", quality=90, optimize=True)


PICTURES = {
    "relighting": relighting,
    "materials": materials,
    "cornell": cornell,
    "physics": physics_rows,
}

if __name__ == "__main__":
    assets = [Path(word) for word in sys.argv[1:4]]
    for name in sys.argv[4:] or PICTURES:
        save(name, PICTURES[name](*assets))
        print(IMAGES / f"{name}.jpg", flush=True)
    sys.stdout.flush()
    os._exit(0)
