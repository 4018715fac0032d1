"""Meshes: the health report against hand-made shapes, normalising, floaters, and files."""

import math

import numpy as np
import pytest
import torch
import trimesh
from PIL import Image

from core.errors import UserError
from core.geometry.mesh import (
    NORMAL_RADIUS,
    compact,
    drop_floaters,
    health,
    normalise,
    signed_volume,
)
from core.io.mesh_file import load_mesh


def tetrahedron(size=1.0, shift=0.0):
    verts = torch.tensor([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) * size + shift
    return verts, torch.tensor([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


def torus(around=12, across=8):
    """A torus of quads cut in two, built by index arithmetic: genus 1 by construction."""
    i, j = torch.meshgrid(torch.arange(around), torch.arange(across), indexing="ij")
    a, b = i * (2 * math.pi / around), j * (2 * math.pi / across)
    ring = 1 + 0.4 * b.cos()
    verts = torch.stack([ring * a.cos(), ring * a.sin(), 0.4 * b.sin()], -1).view(-1, 3)

    def node(di, dj):
        return ((i + di) % around * across + (j + dj) % across).view(-1)

    lower = torch.stack([node(0, 0), node(1, 0), node(1, 1)], 1)
    upper = torch.stack([node(0, 0), node(1, 1), node(0, 1)], 1)
    return verts, torch.cat([lower, upper])


def join(*meshes):
    start, verts, faces = 0, [], []
    for v, f in meshes:
        verts.append(v)
        faces.append(f + start)
        start += len(v)
    return torch.cat(verts), torch.cat(faces)


def test_health_of_a_tetrahedron():
    report = health(*tetrahedron())
    assert report["closed"]
    assert report["manifold"]
    assert report["oriented"]
    assert report["volume"] == pytest.approx(1 / 6)
    assert report["area"] == pytest.approx(1.5 + 3**0.5 / 2)
    assert (report["verts"], report["faces"]) == (4, 4)
    assert (report["euler"], report["genus"], report["components"]) == (2, 0, 1)
    assert report["bounds"] == [[0, 0, 0], [1, 1, 1]]


def test_health_counts_handles_over_all_components():
    report = health(*join(torus(), torus(9, 5), tetrahedron(shift=5.0)))
    assert (report["genus"], report["components"], report["euler"]) == (2, 3, 2)
    assert report["closed"]
    assert report["manifold"]
    assert report["oriented"]


def test_health_sees_inward_faces_as_negative_volume():
    verts, faces = torus()
    outward, inward = health(verts, faces), health(verts, faces.flip(1))
    assert outward["volume"] == pytest.approx(-inward["volume"])
    assert outward["volume"] > 0


def test_health_sees_a_hole():
    verts, faces = tetrahedron()
    report = health(verts, faces[1:])
    assert not report["closed"]
    assert report["open_edges"] == 3
    assert report["genus"] is None
    assert report["volume"] is None
    assert report["manifold"]
    assert report["oriented"]


def test_health_sees_one_flipped_face():
    verts, faces = tetrahedron()
    faces[0] = faces[0].flip(0)
    report = health(verts, faces)
    assert report["closed"]
    assert report["manifold"]
    assert not report["oriented"]


def test_health_sees_an_edge_of_three_faces():
    verts, faces = tetrahedron()
    verts = torch.cat([verts, torch.tensor([[2.0, 2, 2]])])
    report = health(verts, torch.cat([faces, torch.tensor([[0, 1, 4]])]))
    assert report["nonmanifold_edges"] == 1
    assert not report["manifold"]


def test_health_sees_two_components_that_share_one_vertex():
    verts, faces = join(tetrahedron(), tetrahedron(-1.0))
    faces[faces == 4] = 0
    report = health(verts, faces)
    assert report["closed"]
    assert report["nonmanifold_edges"] == 0
    assert report["nonmanifold_verts"] == 1
    assert not report["manifold"]
    assert report["loose_verts"] == 1


def test_health_sees_degenerate_faces():
    verts, faces = tetrahedron()
    verts = torch.cat([verts, torch.tensor([[0.5, 0, 0]])])
    faces = torch.cat([faces, torch.tensor([[0, 0, 1], [0, 4, 1]])])
    assert health(verts, faces)["degenerate_faces"] == 2


def test_health_of_nothing():
    report = health(torch.zeros(0, 3), torch.zeros(0, 3, dtype=torch.int64))
    assert report["faces"] == 0
    assert not report["closed"]
    assert report["components"] == 0
    assert report["bounds"] is None


def test_health_is_plain_python():
    for value in health(*torus()).values():
        assert type(value) in (int, float, bool, list)


def test_normalise_centres_the_box_and_fits_the_sphere():
    verts = torus()[0] * 37 + torch.tensor([100.0, -3, 8])
    unit, center, scale = normalise(verts)
    torch.testing.assert_close(unit.amax(0) + unit.amin(0), torch.zeros(3), atol=1e-5, rtol=0)
    assert float(unit.norm(dim=1).max()) == pytest.approx(NORMAL_RADIUS, rel=1e-5)
    torch.testing.assert_close(unit / scale + center, verts)


def test_normalise_refuses_a_point():
    with pytest.raises(UserError, match="one point"):
        normalise(torch.ones(5, 3))


def test_drop_floaters_keeps_the_large_outward_components():
    void = tetrahedron(0.9, 0.03)
    parts = torus(), tetrahedron(0.05, 3.0), tetrahedron(1.5, 5.0), (void[0], void[1].flip(1))
    verts, faces = drop_floaters(*join(*parts), keep_ratio=0.05)
    expected = join(parts[0], parts[2])
    torch.testing.assert_close(verts, expected[0])
    assert torch.equal(faces, expected[1])


def test_drop_floaters_keeps_a_mesh_that_is_inside_out():
    verts, faces = torus()
    assert torch.equal(drop_floaters(*join((verts, faces.flip(1)), tetrahedron(0.01)))[0], verts)


def test_compact_keeps_the_order():
    verts, faces = compact(torch.arange(15.0).view(5, 3), torch.tensor([[4, 1, 3]]))
    assert verts[:, 0].tolist() == [3, 9, 12]
    assert faces.tolist() == [[2, 0, 1]]


CUBE_OBJ = """# a quad with a seam, then a triangle
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 2 0 -3
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vt 0.25 0.5
f 1/1 2/2 3/3 4/4
f 2/5 5/2 3/3
"""


def write(folder, name, text):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_obj_is_turned_as_blender_turns_it(tmp_path):
    mesh = load_mesh(write(tmp_path, "a.obj", CUBE_OBJ))
    assert mesh.verts.tolist() == [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1], [2, 3, 0]]
    a, b, c = mesh.verts[mesh.faces[0]]
    normal = torch.linalg.cross(b - a, c - a)
    assert normal[1] < 0  # +Z of the file looks to the front, -Y


def test_obj_keeps_a_uv_for_each_corner(tmp_path):
    mesh = load_mesh(write(tmp_path, "a.obj", CUBE_OBJ))
    assert len(mesh.verts) == 5
    given = {
        (0, 0): [(0, 0)],
        (1, 0): [(1, 0), (0.25, 0.5)],
        (1, 1): [(1, 1)],
        (0, 1): [(0, 1)],
        (2, 0): [(1, 0)],
    }
    found = {}
    for face, face_uv in zip(mesh.faces.tolist(), mesh.face_uvs.tolist(), strict=True):
        for vert, uv in zip(face, face_uv, strict=True):
            x, _, z = mesh.verts[vert].tolist()
            found.setdefault((x, z), set()).add(tuple(mesh.uv[uv].tolist()))
    assert found == {key: set(value) for key, value in given.items()}
    assert mesh.base_color is None


def test_a_face_that_welds_to_a_line_goes_with_its_uv(tmp_path):
    flat = "v 1 0 0\nvt 0.7 0.7\nf 2/6 6/6 3/3\n"  # its first two corners are in one place
    text = CUBE_OBJ.replace("f 1/1", flat + "f 1/1")
    mesh, plain = (
        load_mesh(write(tmp_path, name, t)) for name, t in (("a.obj", text), ("b.obj", CUBE_OBJ))
    )
    assert len(mesh.faces) == len(mesh.face_uvs) == len(plain.faces)
    found, expected = (
        {tuple(map(tuple, torch.cat([m.verts[f], m.uv[u]], 1).tolist())) for f, u in pairs}
        for m, pairs in ((m, zip(m.faces, m.face_uvs, strict=True)) for m in (mesh, plain))
    )
    assert found == expected


def test_obj_from_the_wild(tmp_path):
    triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    pentagon = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n"
    wild = {
        "negative.obj": (triangle + "f -3 -2 -1\n", 1),
        "pentagon.obj": (pentagon, 3),
        "crlf.obj": ((triangle + "f 1//1 2//1 3//1\n").replace("\n", "\r\n"), 1),
        "lost_material.obj": ("mtllib gone.mtl\nusemtl x\n" + triangle + "f 1 2 3", 1),
        "coloured.obj": (triangle.replace("0\n", "0 0.5 1 1\n") + "f 1 2 3", 1),
        "some_uv.obj": (triangle + "v 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 2 4 3", 2),
        "Körper 体.obj": (triangle + "f 1 2 3", 1),
    }
    for name, (text, count) in wild.items():
        mesh = load_mesh(write(tmp_path, name, text))
        assert len(mesh.faces) == count, name


@pytest.mark.parametrize("ending", ["obj", "ply", "stl", "glb"])
def test_a_mesh_survives_a_file_of_each_format(tmp_path, ending):
    verts, faces = (x.numpy() for x in torus())
    path = tmp_path / f"torus.{ending}"
    trimesh.Trimesh(verts, faces, process=False).export(path)
    mesh = load_mesh(path)
    report = health(mesh.verts, mesh.faces)
    assert report["genus"] == 1
    assert report["volume"] == pytest.approx(signed_volume(*torus()), rel=1e-4)
    thin = 1 if ending in ("obj", "glb") else 2  # the axis of the ring: y up becomes z, z stays
    reach = mesh.verts.abs().amax(0)
    assert int(reach.argmin()) == thin


def test_parts_of_a_scene_stand_in_their_places(tmp_path):
    verts, faces = (x.numpy() for x in tetrahedron())
    scene = trimesh.Scene()
    part = trimesh.Trimesh(verts, faces, process=False)
    moved, mirrored = np.eye(4), np.diag([-1.0, 1, 1, 1])
    moved[:3, 3] = [0, 5, 0]
    scene.add_geometry(part, node_name="moved", geom_name="t", transform=moved)
    scene.graph.update("mirrored", geometry="t", matrix=mirrored)
    scene.export(tmp_path / "two.glb")
    mesh = load_mesh(tmp_path / "two.glb")
    report = health(mesh.verts, mesh.faces)
    assert report["components"] == 2
    assert report["volume"] == pytest.approx(2 / 6, rel=1e-5)
    assert report["bounds"] == [[-1, -1, 0], [1, 0, 6]]


def textured(image, shift=0.0, factor=None):
    verts, faces = (x.numpy() for x in tetrahedron(shift=shift))
    uv = np.array([[0.0, 0], [1, 0], [0, 1], [0.5, 0.25]])
    material = trimesh.visual.material.PBRMaterial(baseColorTexture=image, baseColorFactor=factor)
    visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    return trimesh.Trimesh(verts, faces, visual=visual, process=False)


def test_texture_and_uv_of_a_glb(tmp_path):
    pixels = np.zeros((2, 4, 3), np.uint8)
    pixels[0] = 188  # the top row: half of the light
    textured(Image.fromarray(pixels), factor=[255, 255, 0, 255]).export(tmp_path / "a.glb")
    mesh = load_mesh(tmp_path / "a.glb")
    assert sorted(mesh.uv.tolist()) == [[0, 0], [0, 1], [0.5, 0.25], [1, 0]]
    assert mesh.base_color.shape == (2, 4, 3)
    torch.testing.assert_close(
        mesh.base_color[0, 0], torch.tensor([0.5029, 0.5029, 0]), atol=1e-3, rtol=0
    )
    assert mesh.base_color[1].max() == 0


def test_texture_of_an_obj(tmp_path):
    Image.new("RGB", (3, 2), (255, 0, 0)).save(tmp_path / "red.png")
    write(tmp_path, "a.mtl", "newmtl skin\nKd 0.5 0.5 0.5\nmap_Kd red.png\n")
    text = "mtllib a.mtl\n" + CUBE_OBJ.replace("f 1/1", "usemtl skin\nf 1/1")
    mesh = load_mesh(write(tmp_path, "a.obj", text))
    torch.testing.assert_close(mesh.base_color, torch.tensor([1.0, 0, 0]).expand(2, 3, 3))


def test_uv_is_dropped_where_parts_have_textures_of_their_own(tmp_path):
    images = [Image.new("RGB", (4, 4), color) for color in ("red", "blue")]
    scene = trimesh.Scene([textured(images[0]), textured(images[1], shift=3.0)])
    scene.export(tmp_path / "a.glb")
    mesh = load_mesh(tmp_path / "a.glb")
    assert len(mesh.faces) == 8
    assert mesh.uv is None
    assert mesh.base_color is None


@pytest.mark.parametrize(
    ("name", "content", "output"),
    [
        ("a.blend", b"BLENDER", "by its ending"),
        ("empty.obj", b"", "no faces"),
        ("points.obj", b"v 0 0 0\nv 1 0 0\n", "no faces"),
        ("line.obj", b"v 0 0 0\nv 1 0 0\nl 1 2\n", "no faces"),
        ("range.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "cannot be read"),
        ("nan.obj", b"v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not finite"),
        ("flat.obj", b"v 0 0 0\nv 1 0 0\nv 0 0 0\nf 1 2 3\n", "no face with an area"),
        ("noise.glb", bytes(range(256)) * 9, "cannot be read"),
        ("noise.ply", bytes(range(256)) * 9, "cannot be read"),
        ("noise.stl", bytes(range(256)) * 9, "cannot be read|no faces"),
        ("noise.gltf", b"{}", "cannot be read|no faces"),
        ("short.glb", b"glTF\x02\x00\x00\x00\xff\x00\x00\x00", "cannot be read"),
    ],
)
def test_a_bad_file_is_a_sentence_with_a_fix(tmp_path, name, content, output):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(UserError, match=output) as caught:
        load_mesh(tmp_path / name)
    assert caught.value.fix
    assert name in caught.value.text


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(UserError, match=r"no file .*gone\.obj"):
        load_mesh(tmp_path / "gone.obj")
    (tmp_path / "folder.obj").mkdir()
    with pytest.raises(UserError, match=r"folder\.obj is a folder"):
        load_mesh(tmp_path / "folder.obj")
