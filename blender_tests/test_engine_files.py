"""Exports for game engines, read back by other programs' readers: trimesh, Blender's FBX importer.

What each engine's importer documents:

- Godot 4, "Node type customization using name suffixes": a mesh "NAME-convcolonly" becomes a static
  body with a convex shape, and is not drawn. glTF: metres, +Y up, the front along +Z; roughness in
  green and metallic in blue.
- Unity, "Importing LOD meshes": "NAME_LOD0", "NAME_LOD1", ...; "Mesh Collider": a convex one has
  255 triangles at most; a unit is a metre. Mask map: metallic, occlusion, detail, smoothness.
- Unreal, "FBX Static Mesh Pipeline": "UCX_" and the mesh's name and a number, closed and convex;
  centimetres; the parent of the LODs is of the type LodGroup.
"""

from itertools import pairwise

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")
spatial = pytest.importorskip("scipy.spatial")
trimesh = pytest.importorskip("trimesh")

from blender_tests.asset_fixture import PROMPT, bump_normals, write_asset  # noqa: E402
from blender_tests.pictures import read  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import corner_uv, triangles, world_verts  # noqa: E402
from fantasia3d_addon.mesh import engines  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty"),
    # Blender 5.2's own FBX exporter under NumPy 2.5
    pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning"),
]
NAME = PROMPT.replace(" ", "_")
MOST_TRIANGLES = 255  # of a convex collider: Unity's limit, and PhysX's


@pytest.fixture
def exported(tmp_path):
    """A function: the file for an engine, and the asset's triangles as it is in the scene (T,3,3).

    The asset is 2 m high, mirrored, turned by a quarter, and away from where the file has it.
    """
    folder = write_asset(tmp_path / "asset", normal=bump_normals(64), metallic=0.25, roughness=0.5)
    obj = import_asset(bpy.context, folder)
    obj.scale, obj.rotation_euler[2] = (-2, 2, 2), np.pi / 2
    bpy.context.view_layer.update()
    corners = world_verts(obj)[triangles(obj.data)[0]][:, ::-1]  # mirrored
    obj.location = (3, -2, 1)
    bpy.context.view_layer.update()

    def export(engine: str):
        path = engines.export_for(obj, tmp_path / "out", engine)
        bpy.ops.wm.read_factory_settings(use_empty=True)
        return path, corners

    return export


def assert_same_place(found: np.ndarray, expected: np.ndarray) -> None:
    """Both (T,3,3): the same triangles in the same places, and so the same side outward."""
    found, expected = (x[np.lexsort(x.mean(1).round(4).T)] for x in (found, expected))
    np.testing.assert_allclose(found.mean(1), expected.mean(1), atol=1e-4)
    sides = [np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]) for x in (found, expected)]
    np.testing.assert_allclose(sides[0], sides[1], atol=1e-4)


def assert_colliders(hulls: "list[trimesh.Trimesh]", corners: np.ndarray) -> None:
    """Closed, convex, few triangles, and together around the mesh."""
    assert hulls
    outside = np.full(corners.size // 3, np.inf)
    for hull in hulls:
        hull.merge_vertices(merge_tex=True, merge_norm=True)
        around = spatial.ConvexHull(hull.vertices)
        assert hull.is_watertight
        assert hull.volume == pytest.approx(around.volume, rel=1e-3)
        assert len(hull.faces) <= MOST_TRIANGLES
        away = corners.reshape(-1, 3) @ around.equations[:, :3].T + around.equations[:, 3]
        outside = np.minimum(outside, away.max(1))
    # A round body sticks out of the 252 triangles by a fortieth.
    assert outside.max() < 0.03 * np.ptp(corners.reshape(-1, 3), axis=0).max()


def test_godot_s_file_in_trimesh(exported):
    path, corners = exported("godot")
    scene = trimesh.load(path, process=False)
    # +Y up and the front, -Y in Blender, along +Z
    expected = corners[..., [0, 2, 1]] * (1, 1, -1)
    mesh = scene.geometry[NAME]
    assert all(np.allclose(scene.graph[node][0], np.eye(4)) for node in scene.graph.nodes_geometry)
    assert_same_place(mesh.triangles, expected)
    material = mesh.visual.material
    assert [round(float(np.asarray(material.metallicRoughnessTexture)[..., i].mean()) / 255, 2)
            for i in (1, 2)] == [0.5, 0.25]  # fmt: skip
    assert material.baseColorTexture is not None and material.normalTexture is not None
    names = set(scene.geometry) - {NAME}
    assert names == {f"{NAME}_{i:02}-convcolonly" for i in range(len(names))}
    assert_colliders([scene.geometry[name] for name in names], expected)


def brought_back(path) -> "dict[str, bpy.types.Object]":
    bpy.ops.import_scene.fbx(filepath=str(path))
    return {obj.name: obj for obj in bpy.data.objects}


def corners_of(obj) -> np.ndarray:
    return world_verts(obj)[triangles(obj.data)[0]]


def assert_lods(found: "dict[str, bpy.types.Object]") -> None:
    """Each has half of the triangles of the one before, UVs, and the one material."""
    lods = [found[f"{NAME}_LOD{i}"] for i in range(4)]
    assert f"{NAME}_LOD4" not in found
    for fine, coarse in pairwise(lods):
        assert len(triangles(coarse.data)[0]) <= 0.51 * len(triangles(fine.data)[0])
    assert all(corner_uv(lod.data) is not None for lod in lods)
    assert {slot.material.name for lod in lods for slot in lod.material_slots} == {NAME}


@pytest.mark.parametrize("engine", ["unity", "unreal"])
def test_an_fbx_in_blender(exported, engine):
    path, corners = exported(engine)
    found = brought_back(path)
    if engine == "unreal":  # the front along +X
        corners = corners @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    assert_same_place(corners_of(found[f"{NAME}_LOD0"]), corners)
    assert_lods(found)
    title = {"unity": f"{NAME}_Collider_", "unreal": f"UCX_{NAME}_LOD0_"}[engine]
    hulls = [obj for name, obj in found.items() if name.startswith(title)]
    assert sorted(hull.name for hull in hulls) == [f"{title}{i:02}" for i in range(len(hulls))]
    meshes = [corners_of(hull).reshape(-1, 3) for hull in hulls]
    faces = [np.arange(len(each)).reshape(-1, 3) for each in meshes]
    pairs = zip(meshes, faces, strict=True)
    assert_colliders([trimesh.Trimesh(v, f, process=False) for v, f in pairs], corners)
    groups = {lod.parent.name if lod.parent else "" for n, lod in found.items() if "_LOD" in n[-5:]}
    assert groups == {NAME if engine == "unreal" else ""}


def test_the_pictures_have_the_channels_of_their_engine(exported):
    path, _ = exported("unreal")
    np.testing.assert_allclose(read(path.with_name(f"T_{NAME}_ORM.png"))[32, 32], [1, 0.5, 0.25],
                               atol=0.01)  # fmt: skip
    assert sorted(p.name for p in path.parent.iterdir()) == [
        f"T_{NAME}_BC.png", f"T_{NAME}_N.png", f"T_{NAME}_ORM.png", f"{NAME}.fbx"
    ]  # fmt: skip
