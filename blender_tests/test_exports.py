"""What leaves the file: exports that come back the same, LODs, quads, the Asset Browser."""

import json
import shutil
import struct
import sys
from contextlib import contextmanager, nullcontext
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")
bmesh = pytest.importorskip("bmesh")

from blender_tests.asset_fixture import bump_normals, write_asset  # noqa: E402
from blender_tests.pictures import read, render, set_light  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.background import blender_process  # noqa: E402
from fantasia3d_addon.blender import compat, mesh_arrays, png  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import (  # noqa: E402
    corner_uv,
    triangles,
    values,
    verts_of,
    world_verts,
)
from fantasia3d_addon.errors import AddonError, OutputError  # noqa: E402
from fantasia3d_addon.jobs import print_export  # noqa: E402
from fantasia3d_addon.material import edit as material_edit  # noqa: E402
from fantasia3d_addon.mesh import asset_browser, export, health, maps, quads, remesh  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty"),
    # Blender 5.2's own FBX exporter under NumPy 2.5
    pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning"),
]
FORMATS = ("glb", "usdc", "usdz", "fbx", "obj")


@pytest.fixture
def obj(tmp_path):
    """The block, half metallic, with bumps, its material edited."""
    folder = write_asset(tmp_path / "asset", normal=bump_normals(64), metallic=0.5, roughness=0.5)
    made = import_asset(bpy.context, folder)
    material_edit.adjust_material(made.active_material, (1, 0.6, 1), 0.8, 0.5)
    bpy.context.view_layer.update()
    return made


def bring_back(path) -> "bpy.types.Object":
    """The object that Blender's own importer makes of a file."""
    kind = export.ENDINGS[path.suffix]
    if kind == "GLB":
        bpy.ops.import_scene.gltf(filepath=str(path))
    elif kind == "USD":
        bpy.ops.wm.usd_import(filepath=str(path))
    elif kind == "FBX":
        bpy.ops.import_scene.fbx(filepath=str(path))
    else:
        bpy.ops.wm.obj_import(filepath=str(path))
        for image in bpy.data.images:  # Blender's OBJ importer assumes sRGB for all
            if "base_color" not in image.name and image.source == "FILE":
                image.colorspace_settings.is_data = True
    return next(o for o in bpy.data.objects if o.type == "MESH")


@pytest.mark.parametrize("ending", FORMATS)
def test_what_comes_back_looks_the_same_from_another_folder(obj, tmp_path, ending):
    if ending.startswith("usd") and not compat.has_usd():
        pytest.skip("this build writes no USD")
    set_light(tmp_path, (0.4, -1, 0.4), strength=0.4)
    before = {kind: len(getattr(bpy.data, kind)) for kind in ("objects", "meshes", "materials")}
    out = tmp_path / "out"
    path = export.export_object(obj, out / f"a b.{ending}")
    assert {k: len(getattr(bpy.data, k)) for k in before} == before
    assert obj.name == obj.active_material.name == "a red wooden chair"
    first = render(obj, tmp_path, azimuth_deg=20, elevation_deg=15, samples=16)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    shutil.move(out, tmp_path / "elsewhere")
    again = bring_back(tmp_path / "elsewhere" / path.name)
    set_light(tmp_path, (0.4, -1, 0.4), strength=0.4)
    picture = render(again, tmp_path, azimuth_deg=20, elevation_deg=15, samples=16)
    assert np.abs(first - picture).mean() < 0.02
    assert np.abs(first - picture).mean() < 0.2 * np.abs(first - first.mean((0, 1))).mean()
    assert health.examine(again).uv_fill == pytest.approx(0.846, abs=0.02)


def test_a_glb_holds_its_pictures_and_tangents(obj, tmp_path):
    path = export.export_object(obj, tmp_path / "x.glb")
    data = path.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    header = json.loads(data[20 : 20 + length])
    (material,) = header["materials"]
    shading = material["pbrMetallicRoughness"]
    assert {"baseColorTexture", "metallicRoughnessTexture"} <= shading.keys()
    assert "normalTexture" in material
    assert all("bufferView" in image for image in header["images"])
    assert "TANGENT" in header["meshes"][0]["primitives"][0]["attributes"]
    assert sorted(p.name for p in tmp_path.iterdir()) == ["asset", "x.glb"]


def test_an_mtl_names_every_map_by_a_relative_path(obj, tmp_path):
    export.export_object(obj, tmp_path / "x.obj")
    text = (tmp_path / "x.mtl").read_text()
    named = {line.split()[0]: line.split()[-1] for line in text.splitlines() if ".png" in line}
    assert named.keys() == {"map_Kd", "map_Pr", "map_Pm", "map_Bump", "norm"}
    assert named["norm"] == named["map_Bump"]
    assert all((tmp_path / name).is_file() for name in named.values())


def test_a_usdz_leaves_the_process_in_its_folder(obj, tmp_path, monkeypatch):
    if not compat.has_usd():
        pytest.skip("this build writes no USD")
    monkeypatch.chdir(tmp_path)
    assert export.export_object(obj, tmp_path / "x.usdz").is_file()
    assert Path.cwd() == tmp_path


def test_directx_flips_green_alone(obj, tmp_path):
    export.export_object(obj, tmp_path / "gl.obj")
    export.export_object(obj, tmp_path / "dx.obj", flip_normal_y=True)
    gl = read(tmp_path / "gl_textures" / "gl_normal.png")
    dx = read(tmp_path / "dx_textures" / "dx_normal.png")
    np.testing.assert_allclose(dx[..., 1], 1 - gl[..., 1], atol=1e-4)
    np.testing.assert_allclose(dx[..., ::2], gl[..., ::2], atol=1e-6)
    with pytest.raises(OutputError, match="allows OpenGL's normal maps alone"):
        export.export_object(obj, tmp_path / "x.glb", flip_normal_y=True)


def test_an_object_disabled_in_viewports_is_exported_as_it_looks(obj, tmp_path):
    obj.modifiers.new("finer", "SUBSURF")
    obj.parent = parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    obj.hide_viewport, parent.location = True, (5, 0, 0)
    still = mesh_arrays.shown_copy(obj, "still")
    assert still.matrix_world.translation.x == 5
    count = len(still.data.vertices)
    assert count > 2 * len(obj.data.vertices)
    path = export.export_object(obj, tmp_path / "x.obj")
    assert obj.hide_viewport
    bpy.ops.wm.read_factory_settings(use_empty=True)
    made = bring_back(path)
    assert len(made.data.vertices) == count
    assert world_verts(made).mean(0)[0] == pytest.approx(5, abs=0.1)


def test_a_still_copy_stays_where_animation_and_constraints_have_the_object(obj):
    target = bpy.data.objects.new("target", None)
    bpy.context.scene.collection.objects.link(target)
    target.location = (0, 7, 0)
    follow = obj.constraints.new("COPY_LOCATION")
    follow.target, follow.use_x, follow.use_z = target, False, False
    for frame, x in ((1, 0.0), (10, 9.0)):
        obj.location.x = x
        obj.keyframe_insert("location", frame=frame)
    bpy.context.scene.frame_set(10)
    still = mesh_arrays.shown_copy(obj, "still")
    bpy.context.scene.collection.objects.link(still)
    target.location.y = 0
    bpy.context.scene.frame_set(1)
    assert tuple(still.matrix_world.translation) == (9, 7, 0)


def test_a_solid_wood_is_baked_for_the_export(obj, tmp_path):
    material_edit.replace_material(obj, "wood")
    export.export_object(obj, tmp_path / "x.obj", size=64)
    color = read(tmp_path / "x_textures" / "x_base_color.png")
    inside = color[8:24, 4:16].reshape(-1, 3)
    assert (inside[:, 0] > inside[:, 1]).all() and (inside[:, 1] > inside[:, 2]).all()
    assert inside.std() > 0.01  # it has rings


@pytest.mark.parametrize("hidden", ["object", "excluded"])
def test_a_solid_wood_is_baked_where_the_object_is_disabled(obj, tmp_path, hidden):
    material_edit.replace_material(obj, "wood")
    if hidden == "excluded":
        collection = bpy.data.collections.new("parts")
        bpy.context.scene.collection.children.link(collection)
        collection.objects.link(obj)
        bpy.context.scene.collection.objects.unlink(obj)
        bpy.context.view_layer.layer_collection.children["parts"].exclude = True
    else:
        obj.hide_viewport = True
    obj.parent = parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.location = (5, 0, 0)
    before = set(bpy.data.objects), set(bpy.data.materials)
    export.export_object(obj, tmp_path / "x.obj", size=64)
    assert (set(bpy.data.objects), set(bpy.data.materials)) == before
    color = read(tmp_path / "x_textures" / "x_base_color.png")
    inside = color[8:24, 4:16].reshape(-1, 3)
    assert (inside[:, 0] > inside[:, 1]).all() and (inside[:, 1] > inside[:, 2]).all()


@pytest.mark.parametrize(
    ("name", "message"),
    [("x.stl", "has no known format"), ("file/x.glb", "can't be written")],
)
def test_a_file_that_cannot_be_is_a_sentence(obj, tmp_path, name, message):
    (tmp_path / "file").touch()
    with pytest.raises(OutputError, match=message):
        export.export_object(obj, tmp_path / name)


def test_png_is_read_back_to_the_bit(tmp_path):
    values = np.linspace(0, 1, 7 * 5 * 3).reshape(7, 5, 3)
    for bits in (8, 16):
        png.write_png(tmp_path / "x.png", png.to_bytes(values, bits))
        np.testing.assert_allclose(read(tmp_path / "x.png"), values, atol=0.51 / (2**bits - 1))


def test_lods_have_fewer_faces_and_the_same_uvs(obj, tmp_path):
    """The colour that each triangle's middle has in the atlas is that of its side."""
    lods = remesh.make_lods(obj, levels=2, ratio=0.5)
    faces = len(obj.data.polygons)
    assert [lod.name for lod in lods] == [f"{obj.name} LOD{i}" for i in (1, 2)]
    color = maps.maps_of(obj).base_color
    for level, lod in enumerate(lods, 1):
        assert len(lod.data.polygons) == pytest.approx(faces * 0.5**level, rel=0.03)
        assert lod.active_material == obj.active_material
        assert health.examine(lod).closed
        uv = corner_uv(lod.data)[triangles(lod.data)[1]].mean(1)
        rows = ((1 - uv[:, 1]) * 64).astype(int)
        found = color[rows, (uv[:, 0] * 64).astype(int)]
        normals = np.array([tuple(p.normal) for p in lod.data.polygons])
        front = normals[:, 1] < -0.9
        assert front.sum() > 3
        assert (found[front].argmax(1) == 0).mean() > 0.95  # the front is red
    with pytest.raises(AddonError, match="can't be made"):
        remesh.make_lods(obj, levels=0)


def test_a_budget_of_faces_is_kept_from_few_to_nearly_all(obj):
    present = len(obj.data.polygons)
    for budget in (100, 300, present - 10):
        (lod,) = remesh.make_lods(obj, max_faces=budget)
        assert 0.9 * budget <= len(lod.data.polygons) <= budget
        assert health.examine(lod).closed
        assert lod.data.uv_layers.active
    for wrong in (10, present):
        with pytest.raises(AddonError, match="faces can't be made"):
            remesh.make_lods(obj, max_faces=wrong)


@contextmanager
def core_in_this_process(monkeypatch):
    """The core's command lines are carried out here: a process that loads torch takes 3 s."""
    from core.command_line import main

    def carried_out(command, **_):
        assert command[1:3] == ["-m", "core"]
        return SimpleNamespace(returncode=main(command[3:]), stderr="")

    with monkeypatch.context() as patches:
        patches.setattr(print_export.subprocess, "run", carried_out)
        yield


def test_the_operator_prints_what_is_watertight(addon, obj, tmp_path, monkeypatch):
    """In millimetres, at its place; an open mesh is refused by the core's own sentence."""
    pytest.importorskip("torch")
    trimesh = pytest.importorskip("trimesh")
    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    obj.location = (0.5, 0, 0)
    bpy.context.view_layer.objects.active = obj
    with core_in_this_process(monkeypatch):
        for ending in ("stl", "3mf"):
            path = tmp_path / f"x.{ending}"
            assert bpy.ops.fantasia3d.export(filepath=str(path)) == {"FINISHED"}
            assert path.stat().st_size > 1000
    printed = trimesh.load(tmp_path / "x.stl")
    assert printed.is_watertight
    points = world_verts(obj) * 1000
    np.testing.assert_allclose(printed.bounds, [points.min(0), points.max(0)], atol=0.01)
    mesh = bmesh.new()
    mesh.from_mesh(obj.data)
    bmesh.ops.delete(mesh, geom=list(mesh.faces)[:1], context="FACES")
    mesh.to_mesh(obj.data)
    mesh.free()
    with pytest.raises(RuntimeError, match="not watertight: 3 open"):
        bpy.ops.fantasia3d.export(filepath=str(tmp_path / "open.3mf"))
    assert not (tmp_path / "open.3mf").exists()


@pytest.mark.parametrize(
    ("chosen", "ending"), [("urdf", ".urdf"), ("mjcf", ".xml"), ("usd-physics", ".usda")]
)
def test_the_operator_writes_a_simulators_body(addon, obj, tmp_path, monkeypatch, chosen, ending):
    """Turned and enlarged as it is in the scene, about its own origin, with its maps; of the mass
    of its rigid body where it is one."""
    pytest.importorskip("torch")
    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    obj.location, obj.scale = (3, 0, 1), (2, 2, 2)
    bpy.context.view_layer.objects.active = obj
    if chosen == "urdf":
        bpy.ops.rigidbody.object_add()
        obj.rigid_body.mass = 3.25
    bpy.context.view_layer.update()
    with nullcontext() if chosen == "urdf" else core_in_this_process(monkeypatch):
        made = bpy.ops.fantasia3d.export(filepath=str(tmp_path / "x"), format=chosen)
    assert made == {"FINISHED"}
    text, parts = (tmp_path / f"x{ending}").read_text(), tmp_path / "x_parts"
    assert "a_red_wooden_chair" in text
    assert (parts / "base_color.png").stat().st_size > 100
    if chosen == "usd-physics":
        assert "PhysicsRigidBodyAPI" in text
        return
    if chosen == "urdf":
        assert 'value="3.25' in text
    lines = (parts / "visual.obj").read_text().splitlines()
    points = np.array([line.split()[1:4] for line in lines if line.startswith("v ")], float)
    expected = world_verts(obj) - (3, 0, 1)
    np.testing.assert_allclose(points.min(0), expected.min(0), atol=1e-4)
    np.testing.assert_allclose(points.max(0), expected.max(0), atol=1e-4)
    if chosen == "mjcf":
        mujoco = pytest.importorskip("mujoco")
        model = mujoco.MjModel.from_xml_path(str(tmp_path / "x.xml"))
        assert model.body_mass.sum() > 1
        assert model.ngeom > 1


def test_the_operator_writes_an_engines_folder(addon, obj, tmp_path):
    bpy.context.view_layer.objects.active = obj
    out = tmp_path / "chair"
    assert bpy.ops.fantasia3d.export(filepath=str(out), format="godot") == {"FINISHED"}
    (out / "note.txt").touch()  # again, into the folder that is there now
    assert bpy.ops.fantasia3d.export(filepath=str(out), format="godot") == {"FINISHED"}
    assert sorted(path.suffix for path in out.iterdir()) == [".glb", ".txt"]


def test_quads_look_as_the_triangles_did(obj, tmp_path):
    set_light(tmp_path, (0.4, -1, 0.4), strength=0.4)
    first = render(obj, tmp_path, 20, 15, samples=16)
    made = remesh.quad_remesh(obj, faces=500, size=128)
    sizes = [len(p.vertices) for p in made.data.polygons]
    assert sizes.count(4) == len(sizes)
    assert 400 < len(sizes) <= 500
    report = health.examine(made)
    assert report.closed and report.manifold and report.uv_fill > 0.6
    assert all(image.packed_file for image in bpy.data.images if "quads" in image.name)
    assert obj.hide_render
    picture = render(made, tmp_path, 20, 15, samples=16)
    assert np.abs(first - picture).mean() < 0.03


def thin_bowl(obj) -> None:
    """Make the mesh of ``obj`` a tapered tube with a wall of a hundredth and a sharp rim."""
    bm = bmesh.new()
    angle = np.linspace(0, 2 * np.pi, 49)[:-1]
    profile = [(0.3, 0.0), (0.5, 0.4), (0.49, 0.4), (0.29, 0.0)]
    rings = [[bm.verts.new((r * np.cos(a), r * np.sin(a), z)) for a in angle] for r, z in profile]
    for one, other in zip(rings, rings[1:] + rings[:1], strict=True):
        for i in range(len(angle)):
            bm.faces.new((one[i - 1], one[i], other[i], other[i - 1]))
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces[:])
    bm.to_mesh(obj.data)
    bm.free()


@pytest.mark.parametrize("faces", [600, 2000])
def test_quads_keep_a_thin_wall(obj, faces):
    """QuadriFlow's alone are a tenth of the size away."""
    thin_bowl(obj)
    former = obj.data.copy()
    surface = quads.Surface(former)
    away = quads.to_quads(obj, faces)
    mesh = obj.data
    assert away == pytest.approx(surface.distance(mesh)) and away < 0.02
    assert {len(polygon.vertices) for polygon in mesh.polygons} == {4}
    assert 0.25 * faces < len(mesh.polygons) <= faces  # the tube has 384 triangles
    report = health.examine(obj)
    assert report.closed and report.manifold
    volume = [abs(bmesh_volume(each)) for each in (mesh, former)]
    assert volume[0] == pytest.approx(volume[1], rel=0.15)


def bmesh_volume(mesh) -> float:
    bm = bmesh.new()
    bm.from_mesh(mesh)
    volume = bm.calc_volume()
    bm.free()
    return volume


def test_a_smooth_body_has_quads_in_rows(obj):
    """QuadriFlow's: nearly all corners have four quads. Of pairs of triangles half have."""
    bm = bmesh.new()
    bmesh.ops.create_icosphere(bm, subdivisions=5, radius=0.5)
    bm.to_mesh(obj.data)
    bm.free()
    assert quads.to_quads(obj, 1000) < 0.01
    degree = np.bincount([v for edge in obj.data.edges for v in edge.vertices])
    assert (degree == 4).mean() > 0.9


def test_a_level_of_detail_shades_flat_sides_flat(obj):
    """Its corners have the normals of the sides, which all round them would tilt by 50 degrees."""
    bm = bmesh.new()
    bmesh.ops.create_cube(bm, size=1.0)
    bmesh.ops.subdivide_edges(bm, edges=bm.edges[:], cuts=15, use_grid_fill=True)
    bm.to_mesh(obj.data)
    bm.free()
    obj.data.shade_smooth()
    (lod,) = remesh.make_lods(obj, max_faces=60)
    normals = values(lod.data.corner_normals, "vector", 3)
    sides = np.repeat(values(lod.data.polygons, "normal", 3), 3, axis=0)
    assert (normals * sides).sum(1).min() > 0.99


def test_a_level_of_detail_shades_a_round_body_round(obj):
    bm = bmesh.new()
    bmesh.ops.create_icosphere(bm, subdivisions=5, radius=0.5)
    bm.to_mesh(obj.data)
    bm.free()
    obj.data.shade_smooth()
    (lod,) = remesh.make_lods(obj, max_faces=300)
    normals = values(lod.data.corner_normals, "vector", 3)
    at = verts_of(lod.data)[values(lod.data.loops, "vertex_index", 1, np.int32)[:, 0]]
    assert (normals * at).sum(1).min() > 0.98 * 0.5


def test_an_open_mesh_is_not_remeshed(tmp_path):
    from blender_tests.asset_fixture import block

    verts, faces, uv, face_uvs = block()
    folder = write_asset(tmp_path / "open", (verts, faces[3:], uv, face_uvs[3:]))
    obj = import_asset(bpy.context, folder)
    with pytest.raises(AddonError, match=r"is not closed and manifold.*Press Repair All"):
        remesh.quad_remesh(obj)
    assert list(bpy.data.objects) == [obj]


def test_a_small_thing_has_quads_at_its_own_size(obj):
    """QuadriFlow refuses edges of less than 0.1 mm."""
    for vertex in obj.data.vertices:
        vertex.co *= 0.002
    bpy.context.view_layer.update()
    made = remesh.quad_remesh(obj, faces=300, size=32)
    assert max(made.dimensions) == pytest.approx(max(obj.dimensions), rel=0.05)


def test_a_blender_without_a_window_makes_the_same_quads(obj):
    here = remesh.quad_remesh(obj, faces=300, size=32)
    obj.hide_render = False
    task = blender_process.start(obj, "quads", faces=300, size=32)
    task.join(120)
    assert task.error is None
    (there,) = blender_process.load_objects(task.result)
    assert not task.result.exists()
    assert np.allclose(verts_of(there.data), verts_of(here.data), atol=1e-5)
    assert len(there.data.polygons) == len(here.data.polygons)
    (slot,) = there.material_slots
    images = [n.image for n in slot.material.node_tree.nodes if n.type == "TEX_IMAGE"]
    assert [(tuple(i.size), bool(i.packed_file)) for i in images] == 3 * [((32, 32), True)]
    assert not bpy.data.libraries


def own_picture(obj, folder) -> Path:
    """Give ``obj`` a green picture of the user's in ``folder``, relative to the file there."""
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "mine.blend"))
    path = folder / "textures" / "green.png"
    path.parent.mkdir()
    made = bpy.data.images.new("made", 4, 4)
    made.pixels = 16 * [0.0, 1.0, 0.0, 1.0]
    made.filepath_raw, made.file_format = str(path), "PNG"
    made.save()
    bpy.data.images.remove(made)
    material = bpy.data.materials.new("own")
    material.use_nodes = True
    tree = material.node_tree
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.load("//textures/green.png")
    shader = next(n for n in tree.nodes if n.type == "BSDF_PRINCIPLED")
    tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    obj.data.materials.clear()
    obj.data.materials.append(material)
    return path


def test_a_blender_without_a_window_finds_the_users_pictures(obj, tmp_path, monkeypatch):
    own_picture(obj, tmp_path)
    monkeypatch.setattr(blender_process, "POLL_SECONDS", 0.5)
    task = blender_process.start(obj, "quads", faces=300, size=32)
    task.join(120)
    assert task.error is None
    (quads,) = blender_process.load_objects(task.result)
    nodes = quads.active_material.node_tree.nodes
    colors = next(n.image for n in nodes if n.type == "TEX_IMAGE" and "color" in n.image.name)
    pixels = np.array(colors.pixels[:]).reshape(-1, 4)
    assert np.median(pixels[:, :3], axis=0) == pytest.approx((0, 1, 0), abs=0.05)
    assert "//textures/green.png" in [image.filepath for image in bpy.data.images]


@pytest.mark.parametrize("place", ["library", "../library", "."])
def test_a_librarys_file_finds_the_users_pictures(obj, tmp_path, place):
    project = tmp_path / "project"
    project.mkdir()
    picture = own_picture(obj, project)
    library = project / place
    library.mkdir(exist_ok=True)
    asset_browser.mark_asset(obj, thumbnail=False)
    path = asset_browser.save_to_library(obj, library)
    assert "//textures/green.png" in [image.filepath for image in bpy.data.images]
    bpy.ops.wm.open_mainfile(filepath=str(path.resolve()))
    (image,) = bpy.data.images
    assert Path(bpy.path.abspath(image.filepath)).resolve() == picture
    assert not list(tmp_path.rglob(".fantasia3d-*"))


def test_a_library_in_the_home_of_nobody_is_a_sentence(obj):
    asset_browser.mark_asset(obj, thumbnail=False)
    with pytest.raises(OutputError, match="no home folder .~no-one"):
        asset_browser.save_to_library(obj, "~no-one/library")


def test_what_a_blender_without_a_window_refuses_is_a_sentence(tmp_path):
    from blender_tests.asset_fixture import block

    verts, faces, uv, face_uvs = block()
    folder = write_asset(tmp_path / "open", (verts, faces[3:], uv, face_uvs[3:]))
    task = blender_process.start(import_asset(bpy.context, folder), "quads", faces=300)
    task.join(120)
    assert "is not closed and manifold" in task.error[0]
    assert task.error[1] == "Press Repair All under Mesh Health first."


def test_cancelled_it_ends_and_leaves_nothing(obj, monkeypatch, tmp_path):
    monkeypatch.setattr(blender_process.tempfile, "tempdir", str(tmp_path))
    task = blender_process.start(obj, "quads", faces=300)
    task.cancel()
    task.join(20)
    assert task.error == ("Cancelled.", "")
    assert list(tmp_path.glob("fantasia3d-*")) == []


def test_an_asset_browser_entry_has_a_thumbnail_and_tags(obj, tmp_path, monkeypatch):
    monkeypatch.setattr(asset_browser, "SIZE", 32)
    monkeypatch.setattr(asset_browser, "SAMPLES", 2)
    monkeypatch.setattr(compat, "has_denoiser", lambda: False)
    before = {kind: len(getattr(bpy.data, kind)) for kind in ("scenes", "worlds", "cameras")}
    asset_browser.mark_asset(obj, ["chair", " red ", "chair", ""], "a chair")
    assert {k: len(getattr(bpy.data, k)) for k in before} == before
    assert sorted(tag.name for tag in obj.asset_data.tags) == ["chair", "red"]
    assert obj.asset_data.description == "a chair"
    pixels = np.array(obj.preview.image_pixels_float[:]).reshape(32, 32, 4)
    assert pixels[16, 16, 3] > 0.99 > 0.01 > pixels[0, 0, 3]  # the asset, and nothing about it
    assert pixels[12:20, 12:20, 0].mean() > 2 * pixels[12:20, 12:20, 1].mean()
    path = asset_browser.save_to_library(obj, tmp_path)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(path), assets_only=True) as (there, here):
        assert there.objects == ["a red wooden chair"]
        here.objects = there.objects
    assert all(image.packed_file for image in bpy.data.images if image.source == "FILE")


def test_the_operators_are_the_functions(addon, obj, tmp_path):
    bpy.context.view_layer.objects.active = obj
    export.export_object(obj, tmp_path / "f" / "x.obj")
    assert bpy.ops.fantasia3d.export(filepath=str(tmp_path / "o" / "x"), format="obj") == {
        "FINISHED"
    }
    for name in ("x.obj", "x_textures/x_normal.png", "x_textures/x_roughness.png"):
        assert (tmp_path / "f" / name).read_bytes() == (tmp_path / "o" / name).read_bytes()
    assert bpy.ops.fantasia3d.make_lods(levels=1) == {"FINISHED"}
    assert f"{obj.name} LOD1" in bpy.data.objects
    assert bpy.ops.fantasia3d.mark_asset(tags="a,b", thumbnail=False) == {"FINISHED"}
    assert len(obj.asset_data.tags) == 2
    assert bpy.ops.fantasia3d.quad_remesh(faces=300, texture_size=32) == {"FINISHED"}
    assert bpy.context.object.name.endswith("quads")
    with pytest.raises(RuntimeError, match="no known format"):
        bpy.ops.fantasia3d.export(filepath=str(tmp_path / "x.ply"))
