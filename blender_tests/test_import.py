"""The asset folder in Blender: one welded object that looks as it was made."""

import json

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import (  # noqa: E402
    SIDES,
    block,
    bump_normals,
    plane,
    write_asset,
    write_png,
)
from blender_tests.pictures import render, set_light  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.errors import AssetError  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def mesh_arrays(mesh):
    """co (V,3), the vertex of each corner (3F,), uv of each corner (3F,2)."""
    co = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", co)
    vertex = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", vertex)
    uv = np.empty(len(mesh.loops) * 2, np.float32)
    mesh.uv_layers.active.uv.foreach_get("vector", uv)
    return co.reshape(-1, 3), vertex, uv.reshape(-1, 2)


def everything() -> dict[str, list[str]]:
    """The names of all datablocks that an import could leave."""
    kinds = ("objects", "meshes", "materials", "images", "textures", "node_groups", "worlds")
    return {kind: sorted(getattr(bpy.data, kind).keys()) for kind in kinds}


def test_one_object_with_the_files_own_corners(asset):
    verts, faces, uv, face_uvs = block()
    obj = import_asset(bpy.context, asset)
    assert list(bpy.data.objects) == [obj]
    co, vertex, corner_uv = mesh_arrays(obj.data)
    np.testing.assert_allclose(co, verts, atol=1e-6)
    np.testing.assert_array_equal(vertex, faces.ravel())
    np.testing.assert_allclose(corner_uv, uv[face_uvs.ravel()], atol=1e-6)
    assert [layer.name for layer in obj.data.uv_layers] == ["UVMap"]


def test_the_mesh_is_welded_and_closed_though_its_uv_has_seams(asset):
    obj = import_asset(bpy.context, asset)
    co, vertex, uv = mesh_arrays(obj.data)
    assert len(np.unique(co.round(6), axis=0)) == len(co)
    corners = vertex.reshape(-1, 3)
    edges = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), 1)
    _, count = np.unique(edges, axis=0, return_counts=True)
    assert set(count) == {2}
    a, b, c = (co[corners[:, i]] for i in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() > 0  # outward
    pairs = np.unique(np.concatenate([vertex[:, None], uv.round(6)], 1), axis=0)
    assert len(pairs) > len(co)  # there are seams, and no vertex was doubled for them


def test_the_edges_between_islands_are_seams_and_no_others(asset):
    _, faces, _, face_uvs = block()
    mesh = import_asset(bpy.context, asset).data
    uvs_of = {}
    for face, uvs in zip(faces, face_uvs, strict=True):
        for i in range(3):
            a, b = (face[i], uvs[i]), (face[i - 2], uvs[i - 2])
            uvs_of.setdefault(frozenset((a[0], b[0])), set()).add(frozenset((a, b)))
    expected = {edge for edge, uvs in uvs_of.items() if len(uvs) > 1}
    assert len(expected) == 12 * 8  # the edges of a cube, 8 long each
    assert {frozenset(edge.vertices) for edge in mesh.edges if edge.use_seam} == expected


def test_it_is_upright_in_metres_with_its_nose_to_the_front(asset):
    obj = import_asset(bpy.context, asset, (1.0, 2.0, 3.0))
    assert tuple(obj.location) == (1.0, 2.0, 3.0)
    assert tuple(obj.rotation_euler) == (0.0, 0.0, 0.0)
    assert tuple(obj.scale) == (1.0, 1.0, 1.0)
    co, _, _ = mesh_arrays(obj.data)
    np.testing.assert_allclose(co.max(0) - co.min(0), [0.4865, 0.675, 1.0], atol=5e-4)
    assert co[:, 2].min() == pytest.approx(0.0, abs=1e-6)
    nose = co[co[:, 1].argmin()]
    assert nose[1] < -0.3
    assert abs(nose[0]) < 0.05
    top, base = co[co[:, 2] > 0.9], co[co[:, 2] < 0.1]
    assert np.ptp(top[:, 0]) < np.ptp(base[:, 0])


def test_blenders_own_importer_makes_the_same_mesh(asset):
    """mesh.obj by Blender's own importer has the same place as by ours."""
    ours = import_asset(bpy.context, asset)
    bpy.ops.wm.obj_import(filepath=str(asset / "mesh.obj"))
    other = next(obj for obj in bpy.data.objects if obj != ours)
    matrix = np.array(other.matrix_world)
    co, vertex, uv = mesh_arrays(other.data)
    ours_co, ours_vertex, ours_uv = mesh_arrays(ours.data)
    np.testing.assert_allclose(co @ matrix[:3, :3].T, ours_co, atol=1e-6)
    np.testing.assert_array_equal(vertex, ours_vertex)
    np.testing.assert_allclose(uv, ours_uv, atol=1e-6)


def test_shading_is_smooth(asset):
    mesh = import_asset(bpy.context, asset).data
    assert all(polygon.use_smooth for polygon in mesh.polygons)
    assert not mesh.has_custom_normals


def test_a_flat_asset_is_shaded_flat(asset):
    path = asset / "mesh.obj"
    path.write_text(path.read_text() + "s off\n")
    mesh = import_asset(bpy.context, asset).data
    assert not any(polygon.use_smooth for polygon in mesh.polygons)


@pytest.mark.parametrize("distribution", ["GGX", "MULTI_GGX"])
def test_the_material_reads_each_map_where_it_belongs(tmp_path, distribution):
    obj = import_asset(bpy.context, write_asset(tmp_path / "a", distribution=distribution))
    assert [slot.material for slot in obj.material_slots] == [bpy.data.materials[0]]
    (bsdf,) = (n for n in nodes() if n.bl_idname == "ShaderNodeBsdfPrincipled")
    assert bsdf.distribution == distribution
    assert source(bsdf, "Base Color")[0].image.filepath.endswith("base_color.png")
    for name, channel in (("Roughness", "Green"), ("Metallic", "Blue")):
        split, socket = source(bsdf, name)
        assert (split.bl_idname, socket) == ("ShaderNodeSeparateColor", channel)
        assert source(split, "Color")[0].image.filepath.endswith("orm.png")
    bump, _ = source(bsdf, "Normal")
    assert (bump.bl_idname, bump.space, bump.uv_map) == ("ShaderNodeNormalMap", "TANGENT", "UVMap")
    assert source(bump, "Color")[0].image.filepath.endswith("normal.png")
    (output,) = (n for n in nodes() if n.bl_idname == "ShaderNodeOutputMaterial")
    assert source(output, "Surface")[0] == bsdf


def nodes():
    return bpy.data.materials[0].node_tree.nodes


def source(node, name):
    """The node and the socket's name that feed an input."""
    (link,) = node.inputs[name].links
    return link.from_node, link.from_socket.name


def test_color_spaces_follow_asset_json_and_images_are_packed(asset):
    import_asset(bpy.context, asset)
    spaces = {image.filepath.rsplit("/")[-1]: image for image in bpy.data.images}
    assert {k: v.colorspace_settings.name for k, v in spaces.items()} == {
        "base_color.png": "sRGB",
        "orm.png": "Non-Color",
        "normal.png": "Non-Color",
    }
    assert all(image.packed_file for image in bpy.data.images)
    normal = np.empty(64 * 64 * 4, np.float32)
    spaces["normal.png"].pixels.foreach_get(normal)
    assert normal[0] == pytest.approx(32768 / 65535, abs=1e-6)  # its 16 bits are kept


@pytest.mark.parametrize(
    ("prompt", "name"),
    [
        ("椅子 ünïcode\nsecond line", "椅子 ünïcode second line"),
        ("  ", "Asset"),
        ("é" * 80, "é" * 29),
        ("a" * 5000, "a" * 59),
    ],
)
def test_it_is_named_by_its_prompt(tmp_path, prompt, name):
    obj = import_asset(bpy.context, write_asset(tmp_path / "a", prompt=prompt))
    assert obj.name == obj.data.name == obj.active_material.name == name
    again = import_asset(bpy.context, tmp_path / "a")
    assert again.name == f"{name}.001"
    assert all(len(image.name.encode()) < 64 for image in bpy.data.images)


def test_the_users_selection_and_mode_are_left_alone(asset):
    mesh = bpy.data.meshes.new("mine")
    mine = bpy.data.objects.new("mine", mesh)
    bpy.context.scene.collection.objects.link(mine)
    bpy.context.view_layer.objects.active = mine
    mine.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    obj = import_asset(bpy.context, asset)
    assert bpy.context.mode == "EDIT_MESH"
    assert bpy.context.view_layer.objects.active == mine
    assert not obj.select_get()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_a_run_folder_is_accepted_for_its_asset(tmp_path):
    write_asset(tmp_path / "run" / "asset")
    assert import_asset(bpy.context.scene, tmp_path / "run").name == "a red wooden chair"


def break_json(folder, **changes):
    path = folder / "asset.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | changes))


def cut(path, fraction):
    path.write_bytes(path.read_bytes()[: int(path.stat().st_size * fraction)])


def link_outside(folder):
    (folder / "base_color.png").rename(folder.parent / "secret.png")
    (folder / "base_color.png").symlink_to(folder.parent / "secret.png")


def doubled_face(folder):
    path = folder / "mesh.obj"
    lines = path.read_text().splitlines()
    path.write_text("\n".join([*lines, lines[-1]]))
    break_json(folder, mesh={})


BREAKS = {
    "an empty folder": (lambda f: [p.unlink() for p in f.iterdir()], "it has no asset.json"),
    "no JSON": (lambda f: (f / "asset.json").write_text("{"), "can't be read"),
    "JSON of another kind": (lambda f: (f / "asset.json").write_text("[]"), "names no files"),
    "another version": (lambda f: break_json(f, version=2), "has version 2; this add-on reads 1"),
    "no mesh": (lambda f: (f / "mesh.obj").unlink(), "mesh.obj is missing"),
    "no map": (lambda f: (f / "orm.png").unlink(), "orm.png is missing"),
    "a role that is not named": (
        lambda f: break_json(f, files={"mesh.obj": {"role": "mesh"}}),
        "names no base color",
    ),
    "half a mesh": (lambda f: cut(f / "mesh.obj", 0.7), "mesh"),
    "an empty mesh": (lambda f: (f / "mesh.obj").write_text(""), "is not a triangle mesh"),
    "no uv": (
        lambda f: (f / "mesh.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        "is not a triangle mesh",
    ),
    "an index too high": (
        lambda f: (f / "mesh.obj").write_text("v 0 0 0\nvt 0 0\nf 1/1 2/1 3/1\n"),
        "is not a triangle mesh",
    ),
    "an index beyond 64 bits": (
        lambda f: (f / "mesh.obj").write_text(f"v 0 0 0\nvt 0 0\nf {9**30}/1 1/1 1/1\n"),
        "is not a triangle mesh",
    ),
    "a face without corners": (
        lambda f: (f / "mesh.obj").write_text("v 0 0 0\nvt 0 0\nf  \n"),
        "is not a triangle mesh",
    ),
    "a name that is too long": (
        lambda f: break_json(
            f,
            files=json.loads((f / "asset.json").read_text())["files"]
            | {"x" * 300: {"role": "mesh"}},
        ),
        "xxx is missing",
    ),
    "a number that is none": (
        lambda f: (f / "mesh.obj").write_text("v 0 0 nan\nvt 0 0\nf 1/1 1/1 1/1\n"),
        "is not a triangle mesh",
    ),
    "a face twice": (doubled_face, "repeat a vertex or another face"),
    "a map that is not a picture": (
        lambda f: (f / "normal.png").write_text("no picture"),
        "normal.png is not a picture",
    ),
    "a DirectX normal map": (
        lambda f: break_json(
            f,
            files=json.loads((f / "asset.json").read_text())["files"]
            | {"normal.png": {"role": "normal", "convention": "DirectX"}},
        ),
        "is a DirectX normal map",
    ),
    **{
        f"a file outside the folder: {name}": (
            lambda f, name=name: break_json(
                f,
                files=json.loads((f / "asset.json").read_text())["files"]
                | {name: {"role": "base_color"}},
            ),
            "is not a file name",
        )
        for name in ("../../secret.png", "/etc/secret.png", "C:\\secret.png", "..", "a/b.png")
    },
    "a link to a file outside the folder": (link_outside, "is a link to another folder"),
    "deeply nested": (lambda f: (f / "asset.json").write_text("[" * 100_000), "can't be read"),
    "no counts": (lambda f: break_json(f, mesh=[]), "no counts of the mesh"),
    "another distribution": (lambda f: break_json(f, distribution="BECKMANN"), "BECKMANN"),
    "another color space": (
        lambda f: break_json(
            f,
            files=json.loads((f / "asset.json").read_text())["files"]
            | {"base_color.png": {"role": "base_color", "color_space": "Nonsense"}},
        ),
        "Nonsense",
    ),
}


@pytest.mark.parametrize("what", BREAKS)
def test_half_an_asset_is_refused_and_leaves_nothing(asset, what):
    before = everything()
    harm, message = BREAKS[what]
    harm(asset)
    with pytest.raises(AssetError, match=message) as caught:
        import_asset(bpy.context, asset)
    assert caught.value.fix
    assert everything() == before


def test_a_folder_that_is_not_there(tmp_path):
    with pytest.raises(AssetError, match="it has no asset.json"):
        import_asset(bpy.context, tmp_path / "nowhere")


def test_a_run_that_has_not_finished(tmp_path):
    (tmp_path / "job.json").write_text("{}")
    with pytest.raises(AssetError, match="has not finished: it has no asset yet") as caught:
        import_asset(bpy.context, tmp_path)
    assert caught.value.fix.startswith("Resume it")


@pytest.mark.parametrize(
    ("side", "azimuth", "elevation"),
    [("front", 0, 0), ("right", 90, 0), ("back", 180, 0), ("left", 270, 0), ("top", 0, 89)],
)
def test_each_side_shows_its_own_color(asset, tmp_path, side, azimuth, elevation):
    """Emission, so that what is rendered is the map: sRGB bytes as they were painted."""
    obj = import_asset(bpy.context, asset)
    set_light(tmp_path, (0, 0, 1))
    tree = obj.active_material.node_tree
    (bsdf,) = (n for n in nodes() if n.bl_idname == "ShaderNodeBsdfPrincipled")
    glow = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(source(bsdf, "Base Color")[0].outputs["Color"], glow.inputs["Color"])
    (output,) = (n for n in nodes() if n.bl_idname == "ShaderNodeOutputMaterial")
    tree.links.new(glow.outputs["Emission"], output.inputs["Surface"])
    picture = render(obj, tmp_path, azimuth, elevation, size=32, samples=1)
    color = np.array(SIDES[side][2])
    np.testing.assert_allclose(
        picture[14:18, 14:18] * 255, np.broadcast_to(color, (4, 4, 3)), atol=1
    )


@pytest.mark.parametrize(
    ("towards", "bright", "dark"),
    [
        ((1, -0.3, 0), np.s_[24:40, 40:48], np.s_[24:40, 16:24]),  # right against left
        ((0, -0.3, 1), np.s_[16:24, 24:40], np.s_[40:48, 24:40]),  # top against bottom
    ],
)
def test_a_bump_is_lit_from_the_side_of_the_light(tmp_path, towards, bright, dark):
    folder = write_asset(
        tmp_path / "a", plane(), size=128, normal=bump_normals(128), roughness=0.9,
        base_color=np.full((128, 128, 3), 200, np.uint8),
    )  # fmt: skip
    obj = import_asset(bpy.context, folder)
    set_light(tmp_path, towards)
    picture = render(obj, tmp_path)
    assert picture[bright].mean() > 2 * picture[dark].mean()


def test_roughness_is_read_from_green_and_metallic_from_blue(tmp_path):
    """A smooth metal shows the mirrored light, where a diffuse plane is black."""
    lights = {}
    for name, orm in {"metal": (0.05, 1.0), "matt": (1.0, 0.0), "swapped": (1.0, 0.05)}.items():
        bpy.ops.wm.read_factory_settings(use_empty=True)
        folder = write_asset(
            tmp_path / name, plane(), size=16, roughness=orm[0], metallic=orm[1],
            base_color=np.full((16, 16, 3), 200, np.uint8),
        )  # fmt: skip
        obj = import_asset(bpy.context, folder)
        set_light(tmp_path, (0, -1, 0))
        lights[name] = render(obj, tmp_path, size=32)[14:18, 14:18].mean()
    assert lights["metal"] > 0.99
    assert lights["matt"] < 0.99
    assert abs(lights["matt"] - lights["swapped"]) < 0.1


def test_an_unreadable_file_is_no_asset(asset):
    write_png(asset / "orm.png", np.zeros((1, 1, 3), np.uint8))
    cut(asset / "orm.png", 0.5)
    with pytest.raises(AssetError, match=r"orm\.png"):
        import_asset(bpy.context, asset)


def test_an_entry_of_an_odd_role_is_not_its_business(asset):
    files = json.loads((asset / "asset.json").read_text())["files"]
    break_json(asset, files=files | {"odd": {"role": ["mesh"]}}, prompt=None)
    assert import_asset(bpy.context, asset).name == "Asset"


def test_a_collection_of_another_file_gives_way_to_the_scenes(asset, tmp_path):
    library = tmp_path / "set.blend"
    bpy.data.libraries.write(str(library), {bpy.data.collections.new("set")})
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(library), link=True) as (_, wanted):
        wanted.collections = ["set"]
    bpy.context.scene.collection.children.link(wanted.collections[0])
    layer = bpy.context.view_layer
    layer.active_layer_collection = layer.layer_collection.children["set"]
    obj = import_asset(bpy.context, asset)
    assert obj.users_collection == (bpy.context.scene.collection,)
    other = bpy.data.scenes.new("other")  # as of a job whose scene is not the present one
    other.collection.children.link(wanted.collections[0])
    obj = import_asset(other.view_layers[0].layer_collection.children["set"], asset)
    assert obj.users_collection == (other.collection,)
