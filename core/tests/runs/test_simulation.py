"""Assets for simulators: mass and inertia, convex parts, and a fall in MuJoCo."""

import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from unittest import mock
from xml.etree import ElementTree

import numpy as np
import pytest
import torch
import trimesh

from core.errors import UserError
from core.geometry.mesh import Mesh
from core.io.asset import place, read_asset, write_asset
from core.io.maps import IOR, Maps
from core.simulation import body
from core.simulation.body import identifier
from core.simulation.export import ENDINGS, export_body
from core.simulation.hulls import MAX_HULLS, Hull, convex_hulls
from core.simulation.mass import WALL, mass_of
from core.simulation.usd_physics import _asset_path
from core.tests.meshes import sphere, torus

SIZE, DENSITY = 0.4, 650.0  # a wooden ring


@pytest.fixture(scope="module")
def ring(tmp_path_factory: pytest.TempPathFactory) -> Path:
    verts, faces = torus(24, 12)
    generator = torch.Generator().manual_seed(0)
    uv = torch.rand(len(verts), 2, generator=generator)
    mesh = Mesh(place(verts, SIZE), faces, uv, faces)
    flat = torch.full((4, 4, 3), 0.5)
    maps = Maps(flat, flat, torch.tensor([0.0, 0, 1]).expand(4, 4, 3))
    info = {"prompt": "a wooden ring, größer", "density": DENSITY}
    return write_asset(tmp_path_factory.mktemp("ring") / "asset", mesh, maps, info)


@pytest.fixture(scope="module")
def parts_once() -> Iterator[None]:
    """The same mesh's convex parts are found once, which takes most of an export's time."""
    found: dict[tuple, list[Hull]] = {}

    def again(verts: torch.Tensor, faces: torch.Tensor, most: int = MAX_HULLS) -> list[Hull]:
        key = verts.numpy().tobytes(), faces.numpy().tobytes(), most
        if key not in found:
            found[key] = convex_hulls(verts, faces, most)
        return [(v.clone(), f.clone()) for v, f in found[key]]

    with mock.patch.object(body, "convex_hulls", again):
        yield


@pytest.fixture(scope="module")
def exported(
    ring: Path, parts_once: None, tmp_path_factory: pytest.TempPathFactory
) -> dict[str, Path]:
    """The ring in each format, in a folder whose name has a space."""
    out = tmp_path_factory.mktemp("out") / "a b"
    out.mkdir()
    return {kind: export_body(ring, kind, out / f"ring{end}") for kind, end in ENDINGS.items()}


def box(x: float, y: float, z: float, at: tuple[float, float, float] = (0, 0, 0)):
    made = trimesh.creation.box((x, y, z))
    verts = torch.tensor(made.vertices + at, dtype=torch.float64)
    return verts, torch.tensor(made.faces, dtype=torch.long)


def test_a_boxs_mass_and_inertia_are_the_closed_form_wherever_it_lies() -> None:
    found = mass_of(*box(1, 2, 3, at=(50, -20, 7)), density=10)
    assert found.mass == pytest.approx(60)
    torch.testing.assert_close(found.center, torch.tensor([50.0, -20, 7], dtype=torch.float64))
    expected = 60 / 12 * torch.tensor([4 + 9, 1 + 9, 1 + 4], dtype=torch.float64).diag()
    torch.testing.assert_close(found.inertia, expected, atol=1e-8, rtol=1e-8)


def test_a_lopsided_solid_agrees_with_trimesh() -> None:
    verts, faces = sphere(3, bump=0.4)
    verts = (verts * torch.tensor([1.0, 0.6, 0.3]) + verts[:, :1] * 0.2).double()
    found = mass_of(verts, faces, density=3)
    reference = trimesh.Trimesh(verts.numpy(), faces.numpy(), process=False)
    reference.density = 3
    assert found.mass == pytest.approx(reference.mass)
    np.testing.assert_allclose(found.center, reference.center_mass, atol=1e-9)
    np.testing.assert_allclose(found.inertia, reference.moment_inertia, atol=1e-9)
    moments, axes = found.principal
    torch.testing.assert_close(axes @ moments.diag() @ axes.T, found.inertia)
    assert torch.linalg.det(axes) == pytest.approx(1)


def test_faces_that_all_look_inward_weigh_the_same() -> None:
    verts, faces = box(1, 2, 3)
    inward = mass_of(verts, faces.flip(1), density=10)
    assert inward.mass == pytest.approx(60)
    assert (torch.linalg.eigvalsh(inward.inertia) > 0).all()


def test_an_open_mesh_is_a_shell() -> None:
    """A sphere's shell has 2/3 m r^2, a solid ball 2/5; one face less makes it open."""
    verts, faces = sphere(5, radius=0.5)
    found = mass_of(verts, faces[1:], density=100)
    assert found.mass == pytest.approx(100 * WALL * 1.0 * np.pi, rel=0.01)
    expected = 2 / 3 * found.mass * 0.25
    np.testing.assert_allclose(found.inertia.diag(), expected, rtol=0.01)


def test_the_parts_are_convex_and_fill_the_ring_but_not_its_hole() -> None:
    verts, faces = torus(24, 12)
    hulls = convex_hulls(verts, faces)
    solid = trimesh.Trimesh(verts.numpy(), faces.numpy(), process=False)
    parts = [trimesh.Trimesh(v.numpy(), f.numpy(), process=False) for v, f in hulls]
    for part in parts:
        gaps = (part.triangles_center[:, None] - part.vertices[None]) * part.face_normals[:, None]
        assert gaps.sum(-1).min() > -1e-6  # every corner is behind every face
    assert 1 < len(parts) <= 32
    assert sum(part.volume for part in parts) == pytest.approx(solid.volume, rel=0.2)
    assert not any(part.contains([[0.0, 0, 0]]).any() for part in parts)
    again = convex_hulls(verts, faces)
    assert all(torch.equal(a[0], b[0]) for a, b in zip(hulls, again, strict=True))


def falling(kind: str, path: Path, height: float):
    """The ring above a floor, with a joint that lets it fall, whatever its file gives it."""
    mujoco = pytest.importorskip("mujoco")
    spec = mujoco.MjSpec.from_file(str(path))
    plane = mujoco.mjtGeom.mjGEOM_PLANE
    spec.worldbody.add_geom(name="floor", type=plane, size=[2, 2, 0.1])
    (ring,) = spec.worldbody.bodies
    if kind == "urdf":  # which has no free joints
        ring.add_freejoint()
    ring.pos, ring.quat = [0, 0, height], [0.9, 0.3, 0.2, 0.1]
    model = spec.compile()
    return mujoco, model, mujoco.MjData(model)


def lowest(mujoco, model, data) -> float:
    """The lowest corner of all the parts, metres above the floor."""
    low = np.inf
    for geom in range(model.ngeom):
        mesh = model.geom_dataid[geom]
        if model.geom_type[geom] != mujoco.mjtGeom.mjGEOM_MESH or not model.geom_contype[geom]:
            continue
        start, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        points = model.mesh_vert[start : start + count] @ data.geom_xmat[geom].reshape(3, 3).T
        low = min(low, float((points + data.geom_xpos[geom])[:, 2].min()))
    return low


@pytest.mark.parametrize("kind", ["urdf", "mjcf"])
def test_in_mujoco_it_falls_rests_and_neither_sinks_nor_explodes(exported, kind) -> None:
    height, gravity = 0.5, 9.81
    mujoco, model, data = falling(kind, exported[kind], height)
    mujoco.mj_forward(model, data)
    start, fastest = lowest(mujoco, model, data), 0.0
    assert start > 0.2
    for _ in range(int(4 / model.opt.timestep)):
        mujoco.mj_step(model, data)
        fastest = max(fastest, float(np.linalg.norm(data.qvel[:3])))
    assert 0.8 * np.sqrt(2 * gravity * start) < fastest < 1.2 * np.sqrt(2 * gravity * height)
    assert np.linalg.norm(data.qvel[:3]) < 1e-3 and np.linalg.norm(data.qvel[3:]) < 1e-2
    mujoco.mj_forward(model, data)
    assert abs(lowest(mujoco, model, data)) < 0.002
    assert data.qpos[2] < 0.2 and abs(data.qpos[:2]).max() < 0.5


@pytest.mark.parametrize("kind", ["urdf", "mjcf"])
def test_mujoco_reads_the_mass_and_inertia_that_were_written(exported, ring, kind) -> None:
    _, model, _ = falling(kind, exported[kind], 1.0)
    verts, faces = torus(24, 12)
    expected = mass_of(place(verts, SIZE).float(), faces, DENSITY)
    assert model.body_mass[1] == pytest.approx(expected.mass, rel=1e-4)
    np.testing.assert_allclose(model.body_ipos[1], expected.center, atol=1e-6)
    moments, _ = expected.principal
    np.testing.assert_allclose(sorted(model.body_inertia[1]), moments, rtol=1e-4)


def test_a_pin_goes_through_the_hole(exported) -> None:
    """One hull around all of it would hold the pin."""
    mujoco, model, data = falling("mjcf", exported["mjcf"], 0.0)
    spec = mujoco.MjSpec.from_file(str(exported["mjcf"]))
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[2, 2, 0.1])
    pin = spec.worldbody.add_body(pos=[0, 0, 0.4])
    pin.add_freejoint()
    pin.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.04, 0, 0], density=7000)
    model = spec.compile()
    data = mujoco.MjData(model)
    for _ in range(int(1.5 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert data.xpos[2][2] == pytest.approx(0.04, abs=0.005)


def test_usd_holds_a_body_that_openusd_reads(exported) -> None:
    """usd-core is not among the tests' packages: its wheels are large."""
    pytest.importorskip("pxr")
    from pxr import Usd, UsdGeom, UsdPhysics, UsdShade

    stage = Usd.Stage.Open(str(exported["usd-physics"]))
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1
    root = stage.GetDefaultPrim()
    assert root.HasAPI(UsdPhysics.RigidBodyAPI) and UsdPhysics.MassAPI(root).GetMassAttr().Get() > 1
    hulls = [p for p in stage.Traverse() if p.HasAPI(UsdPhysics.CollisionAPI)]
    assert len(hulls) > 1
    assert {UsdPhysics.MeshCollisionAPI(h).GetApproximationAttr().Get() for h in hulls} == {
        "convexHull"
    }
    visual = stage.GetPrimAtPath(f"{root.GetPath()}/visual")
    material, _ = UsdShade.MaterialBindingAPI(visual).ComputeBoundMaterial()
    assert material.ComputeSurfaceSource()[0].GetShaderId() == "UsdPreviewSurface"
    box = UsdGeom.BBoxCache(0, ["default"]).ComputeWorldBound(root).ComputeAlignedRange()
    assert max(box.GetSize()) == pytest.approx(SIZE, rel=1e-3)


def test_what_usd_names_is_there(exported) -> None:
    path = exported["usd-physics"]
    text = path.read_text("utf-8")
    named = {word.partition("@")[0] for word in text.split("@./")[1:]}
    assert {Path(name).name for name in named} == {"base_color.png", "orm.png", "normal.png"}
    assert all((path.parent / name).is_file() for name in named)
    assert text.count('"PhysicsCollisionAPI"') > 1


def test_usd_takes_a_name_with_its_own_mark_of_a_path() -> None:
    """OpenUSD: an asset path that contains an @ is between three of them."""
    assert _asset_path("./a@2x_parts/orm.png") == "@@@./a@2x_parts/orm.png@@@"
    assert _asset_path("./a_parts/orm.png") == "@./a_parts/orm.png@"


def test_what_glows_and_what_is_clear_goes_along_where_the_format_knows_it(ring, tmp_path) -> None:
    """UsdPreviewSurface has no transmission: what is clear is not opaque."""
    asset = read_asset(ring)
    half = torch.full((4, 4, 1), 0.5)
    maps = asset.maps._replace(emission=half.expand(4, 4, 3), transmission=half)
    folder = write_asset(tmp_path / "lit", asset.mesh, maps, asset.info)
    usd = export_body(folder, "usd-physics", tmp_path / "x.usda", most=4)
    text = usd.read_text("utf-8")
    for role in ("emission", "transmission"):
        assert f"@./x_parts/{role}.png@" in text
        assert (tmp_path / "x_parts" / f"{role}.png").is_file()
    assert "color3f inputs:emissiveColor.connect" in text and f"inputs:ior = {IOR}" in text
    opacity = text[text.index('def Shader "transmission"') :]
    assert "inputs:bias = (1, 1, 1, 0)" in opacity and "inputs:scale = (-1, -1, -1, 1)" in opacity
    urdf = export_body(folder, "urdf", tmp_path / "y.urdf", most=4)
    assert "map_Ke emission.png" in (tmp_path / "y_parts" / "visual.mtl").read_text()
    names = {path.name for path in urdf.with_name("y_parts").glob("*.png")}
    assert names == {"base_color.png", "normal.png", "emission.png"}


def test_a_title_that_no_xml_takes_is_left_out_of_it(ring, parts_once, tmp_path) -> None:
    folder = shutil.copytree(ring, tmp_path / "ring")
    info = json.loads((folder / "asset.json").read_text("utf-8")) | {"prompt": "a \0 <ring>\n"}
    (folder / "asset.json").write_text(json.dumps(info), encoding="utf-8")
    path = export_body(folder, "mjcf", tmp_path / "x.xml")
    assert ElementTree.parse(path).getroot().get("model") == "a   <ring> "


def test_a_mass_of_ones_own_scales_the_inertia(ring: Path, tmp_path: Path) -> None:
    export_body(ring, "mjcf", tmp_path / "a.xml", mass=2.0, most=4)
    text = (tmp_path / "a.xml").read_text()
    assert 'mass="2"' in text and "hull_03" in text and "hull_04" not in text


@pytest.mark.parametrize(
    ("more", "name", "message"),
    [
        ({"mass": -1.0}, "a.urdf", "Use kilograms"),
        ({"mass": float("nan")}, "a.urdf", "Use kilograms"),
        ({"most": 0}, "a.urdf", "Use 1 or more"),
        ({}, "a.xml", "does not end in .urdf"),
        ({}, "none/a.urdf", "cannot be written"),
    ],
)
def test_what_cannot_be_exported_is_a_sentence(ring, tmp_path, more, name, message) -> None:
    with pytest.raises(UserError, match=message):
        export_body(ring, "urdf", tmp_path / name, **more)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("title", "name"),
    [("a red chair", "a_red_chair"), ("größer 1", "gr_er_1"), ("3 balls", "_3_balls"),
     ("猫", "asset")],
)  # fmt: skip
def test_a_prompt_becomes_a_name_that_every_format_takes(title: str, name: str) -> None:
    assert identifier(title) == name
