"""A region's new material: outside of it no bit changes, inside it is the new one."""

import shutil
from pathlib import Path

import igl
import numpy as np
import pytest
import torch

from core.command_line import carry_out, main, parse
from core.errors import UserError
from core.geometry.mesh import NORMAL_RADIUS, Mesh, turned
from core.geometry.tangents import smooth_normals
from core.io.asset import read_asset, write_asset
from core.io.maps import Maps
from core.io.obj import write_plain_obj
from core.io.run_folder import RunFolder
from core.ops import normalize
from core.stages.reshape import free_verts
from core.stages.texturing import Unwrapped, fine_over, load_unwrapped
from core.tests import meshes
from core.tests.tiny_runs import OPTIONS
from core.texture.fine_surface import FineSurface
from core.texture.region import Region, edited, read_faces, region_weight
from core.texture.texels import texel_points

SIZE = 64


def grid(n: int = 8) -> Mesh:
    """A square of the plane, x and y from 0 to 1, whose uv is (x, y) within a margin of 1/8."""
    at = torch.linspace(0, 1, n + 1)
    xy = torch.stack(torch.meshgrid(at, at, indexing="ij"), -1).reshape(-1, 2)
    index = torch.arange((n + 1) ** 2).view(n + 1, n + 1)
    a, b, c, d = (
        index[i : n + i, j : n + j].reshape(-1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))
    )
    faces = torch.cat([torch.stack([a, b, c], 1), torch.stack([a, c, d], 1)])
    verts = torch.cat([xy, torch.zeros(len(xy), 1)], 1)
    return Mesh(verts, faces, 0.125 + 0.75 * xy, faces)


def left_half(mesh: Mesh) -> torch.Tensor:
    return mesh.verts[mesh.faces].mean(1)[:, 0] < 0.5


def some_maps(seed: int) -> Maps:
    generator = torch.Generator().manual_seed(seed)
    a, b, c = (torch.rand(SIZE, SIZE, 3, generator=generator) for _ in range(3))
    return Maps(a, b, normalize(c - 0.5), b.flip(0), a[..., :1])


def test_the_weight_is_the_smooth_step_of_the_distance_to_the_border():
    mesh = grid()
    weight = region_weight(mesh, left_half(mesh), SIZE, feather=0.25)
    # A texel's middle in x, by its column.
    x = ((torch.arange(SIZE) + 0.5) / SIZE - 0.125) / 0.75
    t = ((0.5 - x) / 0.25).clamp(0, 1)
    row = weight[SIZE // 2]
    on = (x > 0.02) & (x < 0.98)
    torch.testing.assert_close(row[on], (t * t * (3 - 2 * t))[on], atol=0.01, rtol=0)
    assert (row[x > 0.5] == 0).all()


@pytest.mark.parametrize("glows", ["kept", "new"])
def test_what_glows_on_one_side_alone_is_dark_on_the_other(glows):
    mesh, kept, new = grid(), some_maps(0), some_maps(1)
    dark = {"emission": None, "transmission": None}
    if glows == "kept":
        new = new._replace(**dark)
    else:
        kept = kept._replace(**dark)
    got = edited(mesh, Region(kept, left_half(mesh)), new, feather=0.05)
    right = got.emission[:, SIZE - 20 :].any(), got.transmission[:, SIZE - 20 :].any()
    left = got.emission[:, 12:20].any(), got.transmission[:, 12:20].any()
    assert all(left) == (glows == "new") and any(left) == all(left)
    assert all(right) == (glows == "kept") and any(right) == all(right)
    plain = edited(mesh, Region(kept._replace(**dark), left_half(mesh)), new._replace(**dark), 0.05)
    assert plain.emission is plain.transmission is None


def test_all_other_texels_stay_bit_for_bit_and_their_padding_too():
    mesh, kept, new = grid(), some_maps(0), some_maps(1)
    faces = left_half(mesh)
    got = edited(mesh, Region(kept, faces), new, feather=0.1)
    texels = texel_points(*mesh.atlas, SIZE)
    outside = torch.zeros(SIZE * SIZE, dtype=torch.bool)
    outside[texels.index[~faces[texels.face]]] = True  # any point of it is of another face
    outside = outside.view(SIZE, SIZE)
    outside[:, SIZE - 7 :] = True  # the margin at the right is padding of the right half
    for g, k, n in zip(got, kept, new, strict=True):
        assert torch.equal(g[outside], k[outside])
        deep = slice(8, 24)  # columns: past the margin, and more than a feather from the border
        assert torch.equal(g[8:-8, deep], n[8:-8, deep])
        assert torch.equal(g[8:-8, :8], n[8:-8, :8])  # the margin at the left is the region's
    torch.testing.assert_close(got.normal.norm(dim=-1), torch.ones(SIZE, SIZE))


def test_without_a_border_the_whole_component_is_new():
    mesh = grid()
    every = torch.ones(len(mesh.faces), dtype=torch.bool)
    assert (region_weight(mesh, every, SIZE, feather=0.3) == 1).all()


@pytest.mark.parametrize("text", ["", "3 x", "-1", "8", "1.5", "\xff"])
def test_a_wrong_file_of_faces_is_refused(tmp_path: Path, text: str):
    (tmp_path / "faces.txt").write_text(text, "latin-1")
    with pytest.raises(UserError, match="one face number per line"):
        read_faces(tmp_path / "faces.txt", 8)


def test_the_faces_of_a_file(tmp_path: Path):
    (tmp_path / "faces.txt").write_text("2\n0\n2\n")
    assert read_faces(tmp_path / "faces.txt", 4).tolist() == [True, False, True, False]


def test_what_may_move_is_no_neighbour_of_the_border():
    """So the normals at the border, and with them the shading outside, stay too."""
    mesh = grid(8)
    free = free_verts(mesh, left_half(mesh))
    x, y = mesh.verts[:, 0], mesh.verts[:, 1]
    assert free[(x < 0.3) & (y > 0)].all()
    assert not free[x > 0.3].any()


@pytest.fixture(scope="module")
def whole(tmp_path_factory, coarse) -> Path:
    """The run folder of a red torus; only read."""
    run = tmp_path_factory.mktemp("torus") / "whole"
    assert main(["generate", "a red torus", f"--out={run}", *OPTIONS]) == 0
    return run


def edited_torus(whole: Path, tmp_path: Path, prompt: str, *options: str):
    """A torus, which of its faces the region has, and the torus after ``edit``."""
    out, faces = tmp_path / "edited", tmp_path / "faces.txt"
    before = read_asset(whole)
    chosen = before.mesh.verts[before.mesh.faces].mean(1)[:, 0] > 0
    faces.write_text("\n".join(map(str, chosen.nonzero()[:, 0].tolist())))
    short = [f"--set=geometry.reshape.{key}" for key in ("rounds=2", "steps=2", "views=2")]
    more = [f"--faces={faces}", f"--out={out}", *options, *OPTIONS, *short]
    assert main(["edit", str(whole), prompt, *more]) == 0
    return before, chosen, read_asset(out)


def test_a_reshaped_region_moves_and_all_the_rest_stays_bit_for_bit(whole: Path, tmp_path: Path):
    before, chosen, after = edited_torus(whole, tmp_path, "a torus", "--shape")
    free = free_verts(before.mesh, chosen)
    fixed = torch.ones(len(before.mesh.verts), dtype=torch.bool)
    fixed[before.mesh.faces[chosen].reshape(-1)] = False
    fixed[before.mesh.faces[~chosen].reshape(-1)] = True
    assert torch.equal(before.mesh.verts[fixed], after.mesh.verts[fixed])
    moved = (before.mesh.verts != after.mesh.verts).any(1)
    assert moved.any() and not (moved & ~free).any()
    for name in ("faces", "uv", "face_uvs"):
        assert torch.equal(getattr(before.mesh, name), getattr(after.mesh, name))
    for old, new in zip(before.maps[:3], after.maps[:3], strict=True):
        assert torch.equal(old, new)
    outside = before.mesh.faces[~chosen]
    normals = [smooth_normals(a.mesh.verts, a.mesh.faces)[outside] for a in (before, after)]
    assert torch.equal(*normals)
    assert after.info["mesh"]["closed"] == before.info["mesh"]["closed"]


def test_shape_and_material_of_a_region_change_together_and_all_the_rest_stays(
    whole: Path, tmp_path: Path
):
    what = ("a blue metal torus", "--shape", "--material")
    before, chosen, after = edited_torus(whole, tmp_path, *what)
    out = tmp_path / "edited"
    moved = (before.mesh.verts != after.mesh.verts).any(1)
    assert moved.any() and not (moved & ~free_verts(before.mesh, chosen)).any()
    for name in ("faces", "uv", "face_uvs"):
        assert torch.equal(getattr(before.mesh, name), getattr(after.mesh, name))
    texels = texel_points(*before.mesh.atlas, SIZE)
    outside = torch.zeros(SIZE * SIZE, dtype=torch.bool)
    outside[texels.index[~chosen[texels.face]]] = True
    for old, new in zip(before.maps[:3], after.maps[:3], strict=True):
        same = (old == new).all(-1).reshape(-1)
        assert same[outside].all() and not same.all()
    # A resumed run makes no other shape than the one that it has the maps of.
    shutil.rmtree(out / "asset")
    (out / "checkpoint" / "mesh.safetensors").unlink()
    assert main(["resume", str(out)]) == 0
    assert torch.equal(read_asset(out).mesh.verts, after.mesh.verts)


def test_which_command_was_parsed_is_known_after_it(tmp_path: Path, monkeypatch):
    """The launcher asks then whether Blender takes what was made."""
    folder, jobs = tmp_path / "asset", []
    write_asset(folder, grid(), some_maps(0), {"prompt": "a torus"})
    monkeypatch.setattr("core.command_line._run_new", lambda _out, job, _until: jobs.append(job))
    for options in (["--shape"], ["--shape", "--material"], ["--material"]):
        args = parse(["edit", str(folder), "a blue torus", "--faces=faces.txt", *options])
        carry_out(args)
        assert (args.command, jobs[-1].command) == ("edit", "texture")
    found = [(job.reshape, job.retexture) for job in jobs]
    assert found == [(True, False), (True, True), (False, False)]


def test_a_region_without_an_inside_is_refused(whole: Path, tmp_path: Path):
    faces = tmp_path / "faces.txt"
    faces.write_text("0\n")
    more = [f"--faces={faces}", f"--out={tmp_path / 'out'}", "--shape", *OPTIONS]
    assert main(["edit", str(whole), "a torus", *more]) == 2


def test_an_edited_asset_keeps_its_mesh_and_every_other_texel(whole: Path, tmp_path: Path):
    out, faces = tmp_path / "edited", tmp_path / "faces.txt"
    faces.write_text("\n".join(map(str, range(50))))
    more = [f"--faces={faces}", f"--out={out}", *OPTIONS[:-2], "--set=texture.feather=0.0"]
    assert main(["edit", str(whole), "a blue metal torus", *more]) == 0
    before, after = read_asset(whole), read_asset(out)
    text = [(run / "asset" / "mesh.obj").read_text().splitlines() for run in (whole, out)]
    # All lines but the remarks and the material's name: positions, UVs, normals, faces.
    lines = [[x for x in t if x.split()[:1] in (["v"], ["vt"], ["vn"], ["f"])] for t in text]
    assert lines[0] == lines[1]
    texels = texel_points(*before.mesh.atlas, SIZE)
    outside = torch.zeros(SIZE * SIZE, dtype=torch.bool)
    outside[texels.index[texels.face >= 50]] = True
    outside = outside.view(SIZE, SIZE)
    for old, new in zip(before.maps[:3], after.maps[:3], strict=True):
        assert torch.equal(old[outside], new[outside])
    assert (before.maps.base_color != after.maps.base_color).any()


def edit(run: Path, out: Path) -> Path:
    """Another material on the first 50 faces of an asset; the run folder."""
    faces = out.with_suffix(".txt")
    faces.write_text("\n".join(map(str, range(50))))
    argv = ["edit", str(run), "a blue metal torus", f"--faces={faces}", f"--out={out}"]
    assert main([*argv, *OPTIONS[:-2]]) == 0
    return out


def relief(run: Path) -> tuple[float, float, float]:
    """How far a run's mesh is from the shape before it was simplified: at most, in the shape's own
    radius; the mean of its normals' angles, degrees. And that radius, training units."""
    found = load_unwrapped(RunFolder(run))
    assert found is not None and found.fine is not None
    mesh, fine = found
    radius = float((fine.verts - fine.verts.mean(0)).norm(dim=1).max())
    verts = (x.double().numpy() for x in (mesh.verts, fine.verts))
    squared = igl.point_mesh_squared_distance(*verts, fine.faces.numpy().astype(np.int64))[0]
    normals = smooth_normals(mesh.verts, mesh.faces)
    n = FineSurface(fine).normals(mesh.verts, normals)
    angles = (n * normals).sum(1).clamp(-1, 1).acos().rad2deg()
    return float(np.sqrt(squared).max()) / radius, float(angles.mean()), radius


def same_relief(first: Path, later: Path) -> None:
    distance, angle, _ = relief(first)
    assert relief(later)[:2] == pytest.approx((distance, angle), rel=0.01, abs=1e-3)
    fine = load_unwrapped(RunFolder(later)).fine
    assert fine.verts.norm(dim=1).max() == pytest.approx(NORMAL_RADIUS, rel=0.05)


def test_an_edit_and_an_edit_of_it_keep_the_relief_where_it_was(whole: Path, tmp_path: Path):
    """What was drawn is in the cube as it was drawn; what is edited is normalised."""
    once = edit(whole, tmp_path / "once")
    first, later = (load_unwrapped(RunFolder(run)).mesh.verts for run in (whole, once))
    assert (first - later).norm(dim=1).max() > 0.01
    same_relief(whole, once)
    same_relief(whole, edit(once, tmp_path / "twice"))


def test_an_edit_keeps_the_relief_of_a_turned_guide(tmp_path: Path, coarse, monkeypatch):
    guide, run = tmp_path / "guide.obj", tmp_path / "run"
    write_plain_obj(guide, *meshes.torus())
    monkeypatch.setattr("core.generate.front_turn", lambda *_: 0.7)
    argv = ["generate", "a red torus", f"--guide={guide}", "--guide-strength=1", f"--out={run}"]
    assert main([*argv, *OPTIONS]) == 0
    same_relief(run, edit(run, tmp_path / "edited"))


def test_a_fine_shape_follows_its_mesh_and_no_other():
    # No mirror image of itself: of that no turn is the best one.
    fine, coarse = (
        Mesh(verts * torch.tensor([1, 0.8, 0.6]), faces)
        for verts, faces in (meshes.sphere(4), meshes.sphere(2))
    )
    made = Unwrapped(coarse, fine)  # type: ignore[arg-type]  # of a UvMesh the vertices alone
    moved, there = (
        turned(x.verts[:, [1, 2, 0]], 0.4) * 1.7 + torch.tensor([3.0, -2, 5])
        for x in (coarse, fine)
    )
    found = fine_over(made, moved)
    torch.testing.assert_close(found.verts, there, atol=1e-5, rtol=0)
    assert found.verts.dtype == fine.verts.dtype and torch.equal(found.faces, fine.faces)
    for stretch in ([1.0, 1, 1.1], [-1.0, 1, 1]):
        assert fine_over(made, moved * torch.tensor(stretch)) is None
    assert fine_over(made, fine.verts) is None
    assert fine_over(Unwrapped(coarse), moved) is None  # type: ignore[arg-type]
