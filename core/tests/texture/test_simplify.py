"""Simplification keeps a closed surface closed, its topology, and its place."""

import subprocess
import sys
from textwrap import dedent

import numpy as np
import pytest
import torch
import trimesh

import core.texture.simplify as module
from core.errors import Cancelled, UserError
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import Mesh, health
from core.geometry.tet_grid import tet_grid
from core.tests.meshes import sphere
from core.tests.texture_shapes import torus
from core.texture.remesh import even
from core.texture.simplify import simplify, unfolded


def chair_sdf(points: torch.Tensor) -> torch.Tensor:
    """A thin-legged chair: hard on collapses, of genus above 0."""
    parts = [((0, 0, 0), (0.5, 0.5, 0.06)), ((0, 0.42, 0.75), (0.5, 0.05, 0.1))]
    for x in (-0.42, 0.42):
        parts += [((x, y, -0.4), (0.07, 0.07, 0.42)) for y in (-0.42, 0.42)]
        parts += [((x, 0.42, 0.4), (0.07, 0.07, 0.42)), ((x, 0, -0.6), (0.06, 0.42, 0.06))]
    distance = [((points - torch.tensor(c)).abs() - torch.tensor(h)).amax(1) for c, h in parts]
    return torch.stack(distance).amin(0)


@pytest.fixture(scope="module")
def chair() -> tuple[torch.Tensor, torch.Tensor]:
    grid = tet_grid(36)
    generator = torch.Generator().manual_seed(0)
    jitter = (torch.rand(grid.tet_verts.shape, generator=generator) - 0.5) * grid.cell * 0.4
    points = grid.tet_verts + jitter
    sdf = torch.where(grid.boundary, torch.ones(()), chair_sdf(points))
    return marching_tets(points, sdf, grid)


@pytest.mark.parametrize("budget", [6000, 1500])
def test_topology_stays(chair, budget: int) -> None:
    before = health(*chair)
    assert before["closed"]
    assert before["genus"] > 0
    verts, faces = simplify(*chair, budget)
    after = health(verts, faces)
    assert len(faces) <= budget
    for key in ("closed", "manifold", "oriented", "genus", "components", "loose_verts"):
        assert after[key] == before[key], key
    assert after["volume"] == pytest.approx(before["volume"], rel=0.01)


def test_silhouette_stays(chair) -> None:
    """The extent in 50 directions changes by less than a tenth of the lattice's cell."""
    verts, _ = simplify(*chair, 1500)
    along = torch.nn.functional.normalize(
        torch.randn(50, 3, generator=torch.Generator().manual_seed(1)), dim=1
    )
    moved = (chair[0] @ along.T).amax(0) - (verts @ along.T).amax(0)
    assert moved.abs().max() < 0.1 * 2.1 / 36 * 2


def test_within_budget_is_untouched() -> None:
    verts, faces = torus()
    new_verts, new_faces = simplify(verts, faces, len(faces))
    assert new_verts is verts
    assert new_faces is faces


def test_loose_verts_do_not_matter() -> None:
    verts, faces = torus()
    far = torch.cat([torch.full((5, 3), 9.0), verts])
    new_verts, new_faces = simplify(far, faces + 5, 200)
    assert new_verts.amax() < 2
    assert health(new_verts, new_faces)["genus"] == 1


def test_same_twice(chair) -> None:
    first, second = simplify(*chair, 2000), simplify(*chair, 2000)
    assert torch.equal(first[0], second[0])
    assert torch.equal(first[1], second[1])


def test_a_mesh_of_many_faces_is_halved_first_and_stays_closed(chair, monkeypatch) -> None:
    monkeypatch.setattr(module, "MANY", 2000)
    monkeypatch.setattr(module, "MANY_TIMES", 2)
    calls: list[int] = []
    verts, faces = simplify(*chair, 600, lambda: calls.append(1))
    assert len(calls) > 3
    before, after = health(*chair), health(verts, faces)
    for key in ("closed", "manifold", "oriented", "genus", "components", "loose_verts"):
        assert after[key] == before[key], key
    assert after["volume"] == pytest.approx(before["volume"], rel=0.02)


def test_it_stops_where_it_is_told_to(chair, monkeypatch) -> None:
    monkeypatch.setattr(module, "MANY", 2000)

    def cancel() -> None:
        raise Cancelled("Stopped.")

    with pytest.raises(Cancelled):
        simplify(*chair, 100, cancel)


def test_three_faces_on_an_edge_are_refused() -> None:
    verts, faces = torus()
    fin = torch.cat([faces, torch.tensor([[0, 12, 30]])])
    with pytest.raises(UserError, match="three faces share an edge"):
        simplify(verts, fin, 100)


def test_holes_that_meet_in_a_vertex_are_no_hindrance() -> None:
    verts, faces = sphere(4)
    here = (faces == faces[0, 0]).any(1).nonzero()[:, 0]
    # Of the faces about a corner of the first the one that has only that corner in common with it.
    (across, *_) = (
        k for k in here.tolist() if len({*faces[k].tolist()} - {*faces[0].tolist()}) == 2
    )
    kept = torch.ones(len(faces), dtype=torch.bool)
    kept[[0, across]] = False
    faces = faces[kept]
    assert (
        health(verts, faces)["nonmanifold_edges"],
        health(verts, faces)["nonmanifold_verts"],
    ) == (0, 1)
    for made in (simplify(verts, faces, 200), even(Mesh(verts, faces), 200)):
        assert 150 < len(made[1]) <= 200
        assert health(*made)["manifold"]
        assert health(*made)["components"] == 1
        assert float((made[0].norm(dim=1) - 0.8).abs().max()) < 0.03


@pytest.mark.parametrize("flips", ["one", "first", "half", "strip"])
def test_faces_that_disagree_are_turned_first(flips: str) -> None:
    """In a process of its own, with little memory: collapses of such a mesh never end."""
    code = f"""
        import resource
        import torch
        from core.geometry.mesh import Mesh, health
        from core.tests.meshes import sphere
        from core.tests.texture_shapes import moebius
        from core.texture.remesh import even
        from core.texture.simplify import simplify

        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
        torch.set_num_threads(1)
        verts, faces = moebius(200, 6) if "{flips}" == "strip" else sphere(4)
        flip = torch.zeros(len(faces), dtype=torch.bool)
        flip[0], flip[7] = "{flips}" == "first", "{flips}" == "one"
        if "{flips}" == "half":
            flip = verts[faces].mean(1)[:, 0] > 0
        mixed = torch.where(flip[:, None], faces.flip(1), faces)
        before = health(verts, faces)
        for found in (simplify(verts, mixed, 700), even(Mesh(verts, mixed), 700)):
            after = health(*found)
            assert 600 < after["faces"] <= 700 and after["manifold"] and after["oriented"]
            assert abs(after["area"] / before["area"] - 1) < 0.02, after["area"]
            if "{flips}" != "strip":
                assert abs(after["volume"] / before["volume"] - 1) < 0.02, after["volume"]
    """
    done = subprocess.run(
        [sys.executable, "-c", dedent(code)], capture_output=True, text=True, timeout=300
    )
    assert not done.returncode, done.stderr


def test_a_fold_is_spread_out_over_the_surface() -> None:
    ball = trimesh.creation.icosphere(4)
    verts, faces = np.array(ball.vertices), np.array(ball.faces)
    pushed = verts.copy()
    ring = ball.vertex_neighbors[100]
    pushed[100] = 3 * verts[ring[0]] - 2 * verts[100]  # across two neighbours, along the surface
    assert looking_inward(pushed, faces) > 0
    spread = unfolded(pushed, faces, verts, faces)
    assert looking_inward(spread, faces) == 0
    assert np.abs(np.linalg.norm(spread, axis=1) - 1).max() < 2e-3
    assert (spread != pushed).any(1).sum() < 40


def test_a_fold_of_the_collapse_is_not_passed_on(monkeypatch) -> None:
    fine, coarse = trimesh.creation.icosphere(5), trimesh.creation.icosphere(4)
    verts, faces = np.array(coarse.vertices), np.array(coarse.faces)
    ring = coarse.vertex_neighbors[100]
    verts[100] = 3 * verts[ring[0]] - 2 * verts[100]
    monkeypatch.setattr("igl.qslim", lambda *_, **__: (verts, faces))
    surface = torch.tensor(fine.vertices).float(), torch.tensor(fine.faces)
    simple = simplify(*surface, len(faces))
    assert looking_inward(verts, faces) > 0
    assert looking_inward(*(part.numpy() for part in simple)) == 0


def test_sharp_edges_are_no_folds() -> None:
    blade = trimesh.creation.box((1.0, 1.0, 0.05)).subdivide().subdivide()
    verts, faces = np.array(blade.vertices), np.array(blade.faces)
    assert unfolded(verts, faces, verts, faces) is verts


def looking_inward(verts: np.ndarray, faces: np.ndarray) -> int:
    """Faces of a ball about the origin whose normals point to it."""
    a, b, c = (verts[faces[:, k]] for k in range(3))
    return int(((np.cross(b - a, c - a) * (a + b + c)).sum(1) < 0).sum())


def test_unfolding_that_wears_the_shape_away_is_not_taken(monkeypatch) -> None:
    """Neither is a vertex moved where the folds' repair would leave the surface."""
    verts, faces = sphere(4)
    kept = simplify(verts, faces, 600)[0]
    monkeypatch.setattr(module, "unfolded", lambda v, *_: 0.9 * v)
    assert torch.equal(simplify(verts, faces, 600)[0], kept)
