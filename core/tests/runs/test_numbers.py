"""Meshes of any size and any fault, as a guide and to texture: an asset, or one sentence."""

import json
import resource
from pathlib import Path

import numpy as np
import pytest
import trimesh

from core.command_line import main
from core.io.asset import inspect
from core.tests.runs.test_generate import SHORT

FEW = SHORT | {
    "geometry.coarse.steps": 1, "geometry.grow.rounds": 0, "geometry.fine.steps": 0,
    "geometry.refine.rounds": 0, "geometry.fit_steps": 30, "appearance.early.steps": 1,
    "appearance.late.steps": 1, "appearance.refine.rounds": 0,
}  # fmt: skip
OPTIONS = [f"--set={key}={value}" for key, value in FEW.items()]
OPTIONS += ["--texture-size=64", "--max-faces=500"]


def shapes() -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Vertices and faces, by what is odd about them."""
    ball, box = trimesh.creation.icosphere(2), trimesh.creation.box()
    v, f = np.array(ball.vertices), np.array(ball.faces)
    two = np.concatenate([v, np.add(v, (0.7, 0, 0))]), np.concatenate([f, f + len(v)])
    edge = np.concatenate([box.vertices, np.add(box.vertices, (1, 1, 0))])
    every_other = np.arange(len(f))[:, None] % 2
    return {
        "1e-9 large": (v * 1e-9, f),
        "1e9 large": (v * 1e9, f),
        "1e30 large": (v * 1e30, f),
        "far away": (v * 1e-3 + [1e6, 0, 0], f),
        "nan": (np.where(np.arange(len(v))[:, None] == 3, np.nan, v), f),
        "one triangle": (v[f[0]], np.array([[0, 1, 2]])),
        "no faces": (v, f[:0]),
        "a line": (np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), np.array([[0, 1, 2]])),
        "flat": (v * [1, 1, 0], f),
        "a needle": (v * [1e-6, 1e-6, 1], f),
        "duplicated faces": (v, np.concatenate([f, f])),
        "duplicated vertices": (v[f].reshape(-1, 3), np.arange(f.size).reshape(-1, 3)),
        "degenerate faces": (v, np.concatenate([f, [[0, 0, 1], [2, 2, 2]]])),
        "open": (v, f[: len(f) // 2]),
        "inward": (v, f[:, ::-1]),
        "mixed": (v, np.where(every_other, f, f[:, ::-1])),
        "four faces at an edge": (edge, np.concatenate([box.faces, box.faces + 8])),
        "a fin": (np.concatenate([v, [[3, 0, 0]]]), np.concatenate([f, [[0, 1, len(v)]]])),
        "self-intersecting": two,
    }


def write_obj(path: Path, verts: np.ndarray, faces: np.ndarray) -> Path:
    lines = ["v {!r} {!r} {!r}".format(*map(float, vert)) for vert in verts]
    lines += ["f {} {} {}".format(*face) for face in faces + 1]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


@pytest.mark.slow
@pytest.mark.parametrize("use", ["texture", "guide", "kept guide"])
@pytest.mark.parametrize("name", shapes())
def test_any_mesh_becomes_an_asset_or_a_sentence(name, use, tmp_path, capsys):
    mesh = write_obj(tmp_path / "mesh.obj", *shapes()[name])
    code = main([*command(use, mesh), "--out", str(tmp_path / "run"), *OPTIONS])
    check(code, use, tmp_path / "run", capsys.readouterr().err)


def command(use: str, mesh: Path) -> list[str]:
    """The words of a command line before its options."""
    return {
        "texture": ["texture", str(mesh), "a red ball"],
        "guide": ["generate", "a red ball", "--guide", str(mesh)],
        "kept guide": ["generate", "a red ball", "--guide", str(mesh), "--guide-strength", "1"],
    }[use]


def check(code: int, use: str, run: Path, output: str) -> None:
    """A sentence and no asset, or an asset that can be printed where a guide is followed."""
    if code:
        assert code == 2 and output.splitlines()[-1].startswith("error: "), output
        assert not (run / "asset").exists()
        return
    report = inspect(run)
    json.dumps(report, allow_nan=False)
    assert report["mesh"]["faces"] > 0
    if use == "guide":
        assert report["mesh"]["closed"] and report["mesh"]["volume"] > 0


def write_large_stl(path: Path, rows: int) -> Path:
    """A ball of 4 rows² faces, its poles left open by a degenerate row."""
    up, round_ = np.linspace(0, np.pi, rows + 1), np.linspace(0, 2 * np.pi, 2 * rows + 1)
    u, w = np.meshgrid(up, round_, indexing="ij")
    p = np.stack([np.sin(u) * np.cos(w), np.sin(u) * np.sin(w), np.cos(u)], -1).astype("<f4")
    corners = p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]
    faces = np.zeros((2, rows, 2 * rows), dtype=[("n", "<3f4"), ("v", "<f4", (3, 3)), ("a", "<u2")])
    for at, order in enumerate(((0, 1, 2), (0, 2, 3))):
        for corner, index in enumerate(order):
            faces["v"][at, ..., corner, :] = corners[index]
    count = np.array(faces.size, "<u4").tobytes()
    path.write_bytes(bytes(80) + count + faces.tobytes())
    return path


@pytest.mark.slow
@pytest.mark.parametrize("use", ["texture", "guide", "kept guide"])
def test_five_million_faces_become_an_asset_or_a_sentence(use, tmp_path, capsys):
    """In 8 GB, which is what the largest mesh of a scan takes elsewhere too."""
    mesh = write_large_stl(tmp_path / "large.stl", 1119)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    code = main([*command(use, mesh), "--out", str(tmp_path / "run"), *OPTIONS])
    check(code, use, tmp_path / "run", capsys.readouterr().err)
    taken = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    print(f"{use}: {taken >> 10} MB beyond {before >> 10} MB")
    assert taken < 8 << 20
