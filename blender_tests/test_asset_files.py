"""What the core writes, seen by Blender: its own importers, its own tangents and normals."""

from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
torch = pytest.importorskip("torch")

from core.geometry.mesh import Mesh  # noqa: E402
from core.geometry.tangents import corner_tangents, shading_normals, smooth_normals  # noqa: E402
from core.io.asset import export, place, write_asset  # noqa: E402
from core.tests.texture_shapes import smooth_material, torus, torus_uv  # noqa: E402
from core.texture.bake import bake  # noqa: E402
from core.texture.unwrap import unwrap  # noqa: E402

N, M = 48, 24


def standing() -> tuple:
    """An upright torus, with a nose at the front (-Y), 1 m high."""
    verts, faces = torus(N, M)
    x, y, z = verts.unbind(1)
    verts = torch.stack([x, -z, y * 1.2], 1)  # a quarter turn about x: the ring is upright
    nose = torch.exp(-20 * (verts - verts[verts[:, 1].argmin()]).pow(2).sum(1))
    verts[:, 1] -= 0.3 * nose
    return place(verts), faces


@pytest.fixture(scope="module")
def asset(tmp_path_factory) -> Path:
    verts, faces = standing()
    uv, face_uvs = torus_uv(N, M)
    maps = bake(Mesh(verts, faces, uv, face_uvs), smooth_material, 64)
    return write_asset(
        tmp_path_factory.mktemp("run") / "asset", Mesh(verts, faces, uv, face_uvs), maps, {}
    )


@pytest.fixture(autouse=True)
def empty_scene() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)


def imported() -> "bpy.types.Object":
    (found,) = [o for o in bpy.context.scene.objects if o.type == "MESH"]
    return found


def world_points(obj: "bpy.types.Object") -> np.ndarray:
    return np.array([obj.matrix_world @ v.co for v in obj.data.vertices])


def blender_mesh(verts, faces, uv, face_uvs) -> "bpy.types.Mesh":
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(verts.tolist(), [], faces.tolist())
    mesh.shade_smooth()
    corners = uv[face_uvs].reshape(-1).numpy().astype(np.float32)
    mesh.uv_layers.new(name="uv").uv.foreach_set("vector", corners)
    return mesh


def got(items, name: str, width: int) -> np.ndarray:
    out = np.empty(len(items) * width, np.float32)
    items.foreach_get(name, out)
    return out.reshape(-1, width)


def degrees(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Angle between unit vectors; by the chord, exact for small ones."""
    return np.degrees(2 * np.arcsin((np.linalg.norm(a - b, axis=-1) / 2).clip(0, 1)))


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("by", ["island", "unwrap", "folded"])
def test_tangents_are_blenders(by: str, mirrored: bool) -> None:
    verts, faces = standing()
    uv, face_uvs = torus_uv(N, M) if by != "unwrap" else unwrap(verts, faces, 512)
    if by == "folded":  # one half mirrored onto the other without a cut
        uv = torch.stack([(uv[:, 0] - 0.5).abs(), uv[:, 1]], -1)
    if mirrored:
        uv = uv * torch.tensor([-1.0, 1]) + torch.tensor([1.0, 0])
    mesh = blender_mesh(verts, faces, uv, face_uvs)
    mesh.calc_tangents(uvmap="uv")
    want, sign = got(mesh.loops, "tangent", 3), got(mesh.loops, "bitangent_sign", 1)
    own = Mesh(verts, faces, uv, face_uvs)
    ours = corner_tangents(own, shading_normals(own).corners)
    flat = ours.reshape(-1, 4).numpy()
    assert np.quantile(degrees(flat[:, :3], want), 0.999) < 0.5
    assert np.mean(flat[:, 3:] != sign) < 0.001
    assert (sign < 0).any() == (mirrored or by == "folded")  # the unwrap mirrors no island


def test_a_flat_meshs_tangents_are_blenders() -> None:
    verts, faces = standing()
    uv, face_uvs = torus_uv(N, M)
    mesh = blender_mesh(verts, faces, uv, face_uvs)
    mesh.shade_flat()
    mesh.calc_tangents(uvmap="uv")
    own = Mesh(verts, faces, uv, face_uvs, flat=True)
    normals = shading_normals(own).corners
    ours = corner_tangents(own, normals).reshape(-1, 4).numpy()
    assert degrees(normals.reshape(-1, 3).numpy(), got(mesh.loops, "normal", 3)).max() < 0.2
    assert np.quantile(degrees(ours[:, :3], got(mesh.loops, "tangent", 3)), 0.999) < 0.5
    assert np.mean(ours[:, 3:] != got(mesh.loops, "bitangent_sign", 1)) < 0.001


def test_normals_are_blenders() -> None:
    verts, faces = standing()
    mesh = blender_mesh(verts, faces, *torus_uv(N, M))
    want = got(mesh.vertex_normals, "vector", 3)
    assert degrees(smooth_normals(verts, faces).numpy(), want).max() < 0.2


def test_obj_imports_upright(asset: Path) -> None:
    """By hand, with the importer's defaults: up +Z, front -Y, welded, a uv for each corner."""
    verts, faces = standing()
    bpy.ops.wm.obj_import(filepath=str(asset / "mesh.obj"))
    obj = imported()
    points = world_points(obj)
    assert np.abs(points - verts.numpy()).max() < 1e-5
    assert points[:, 2].min() == pytest.approx(0, abs=1e-5)
    assert points[points[:, 1].argmin()] == pytest.approx(
        verts[verts[:, 1].argmin()].numpy(), abs=1e-5
    )  # the nose is at the front
    assert len(obj.data.polygons) == len(faces)
    assert len(obj.data.uv_layers.active.uv) == 3 * len(faces)
    used = got(obj.data.uv_layers.active.uv, "vector", 2)
    uv, face_uvs = torus_uv(N, M)
    assert np.abs(used - uv[face_uvs].reshape(-1, 2).numpy()).max() < 1e-6
    edges, count = np.unique(
        np.sort([key for face in obj.data.polygons for key in face.edge_keys]), axis=0,
        return_counts=True,
    )  # fmt: skip
    assert len(edges)
    assert (count == 2).all()  # closed as it comes
    names = {Path(image.filepath).name for image in bpy.data.images}
    assert {"base_color.png", "normal.png"} <= names


def test_glb_imports_upright(asset: Path) -> None:
    verts, faces = standing()
    bpy.ops.import_scene.gltf(filepath=str(asset / "asset.glb"), merge_vertices=True)
    obj = imported()
    points = world_points(obj)
    welded = np.unique(points.round(5), axis=0)
    want = np.unique(verts.numpy().round(5), axis=0)
    assert points.min(0) == pytest.approx(verts.amin(0).numpy(), abs=1e-4)
    assert points.max(0) == pytest.approx(verts.amax(0).numpy(), abs=1e-4)
    front = points[points[:, 1].argmin()]
    assert front == pytest.approx(verts[verts[:, 1].argmin()].numpy(), abs=1e-4)
    assert len(obj.data.polygons) == len(faces)
    assert len(welded) == pytest.approx(len(want), abs=3)  # rounding may part a few
    images = {image.name: image for image in bpy.data.images if image.size[0]}
    assert {"base_color", "orm", "normal"} <= set(images)
    assert images["base_color"].colorspace_settings.name == "sRGB"
    assert images["orm"].colorspace_settings.name == "Non-Color"
    assert images["normal"].colorspace_settings.name == "Non-Color"
    assert tuple(images["normal"].size) == (64, 64)
    nodes = obj.data.materials[0].node_tree.nodes
    principled = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    for socket in ("Base Color", "Roughness", "Metallic", "Normal"):
        assert principled.inputs[socket].is_linked, socket


def test_maps_read_as_they_were_meant(asset: Path) -> None:
    """Blender's own decoding of the three files gives the maps back, row 0 at its bottom."""
    verts, faces = standing()
    maps = bake(Mesh(verts, faces, *torus_uv(N, M)), smooth_material, 64)
    want = {
        "base_color.png": ("sRGB", maps.base_color),
        "orm.png": ("Non-Color", maps.orm),
        "normal.png": ("Non-Color", maps.normal * 0.5 + 0.5),
    }
    for name, (space, image) in want.items():
        loaded = bpy.data.images.load(str(asset / name))
        loaded.colorspace_settings.name = space
        pixels = np.empty(64 * 64 * 4, np.float32)
        loaded.pixels.foreach_get(pixels)
        shown = pixels.reshape(64, 64, 4)[::-1, :, :3]
        if name == "base_color.png":  # byte images are kept in their own space
            image = torch.from_numpy(np.round(encode(image.numpy()) * 255) / 255)
        tolerance = 3 / 65535 if name == "normal.png" else 1.1 / 255  # ties round either way
        assert np.abs(shown - image.numpy()).max() < tolerance, name


def encode(x: np.ndarray) -> np.ndarray:
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)


def test_exported_obj_finds_its_pictures(asset: Path, tmp_path: Path) -> None:
    export(asset, "obj", tmp_path / "chair.obj")
    bpy.ops.wm.obj_import(filepath=str(tmp_path / "chair.obj"))
    names = {Path(image.filepath).name for image in bpy.data.images}
    assert {"chair_base_color.png", "chair_normal.png"} <= names
