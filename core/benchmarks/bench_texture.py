"""Simplification, unwrap and bake of what generation makes, and of a large mesh."""

import tempfile
import time
from pathlib import Path

import torch
from torch import Tensor

from core.appearance.material import MaterialNet
from core.benchmarks import ball, least_ms, row
from core.config import DRAFT
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import Mesh
from core.geometry.tet_grid import tet_grid
from core.geometry.uv_health import uv_health
from core.io.png import srgb_bytes, write_png
from core.texture.bake import bake
from core.texture.simplify import simplify
from core.texture.unwrap import Unwrapped, unwrap

BUDGET = 20_000


def rows() -> list[dict]:
    """Process CPU seconds."""
    lines = []
    shapes = {name: shape(name) for name in ("chair", "blob")}
    for name, (verts, faces) in shapes.items():
        text = f"simplify a {name} of {len(faces):,} faces to {BUDGET:,}"
        lines.append(
            row(text, least_ms(lambda m=(verts, faces): simplify(*m, BUDGET), 1) / 1e3, "s")
        )
        verts, faces = simplify(verts, faces, BUDGET)
        atlas, unwrapped = unwrap_rows(name, verts, faces, 10.0)
        lines += unwrapped
    for name, large in shapes.items():
        lines += unwrap_rows(name, *simplify(*large, 100_000), 60.0)[1]
    lines += unwrap_rows("ball", *ball(200_000), 120.0)[1]
    net = MaterialNet(DRAFT.appearance, torch.Generator().manual_seed(0))
    for size, target in ((1024, None), (2048, 15.0)):
        seconds = least_ms(lambda s=size: bake(Mesh(verts, faces, *atlas), net, s), 1) / 1e3
        lines.append(row(f"bake {size}² with padding", seconds, "s", target))
    maps = bake(Mesh(verts, faces, *atlas), net, 1024)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "map.png"
        seconds = least_ms(lambda: write_png(path, srgb_bytes(maps.base_color)), 1) / 1e3
    lines.append(row("write a map of 1024² as PNG", seconds, "s"))
    return lines


def shape(name: str) -> tuple[Tensor, Tensor]:
    """Marching tets of a chair with thin legs, or of a bumpy ball; 100,000 faces and more."""
    grid = tet_grid(96)
    points = grid.tet_verts
    sdf = chair(points) if name == "chair" else blob(points)
    return marching_tets(points, torch.where(grid.boundary, torch.ones_like(sdf), sdf), grid)


def chair(points: Tensor) -> Tensor:
    """Boxes: a seat, a back, four legs, their stretchers; a little wavy, as what is learnt."""
    parts = [((0, 0, 0), (0.5, 0.5, 0.06)), ((0, 0.42, 0.75), (0.5, 0.05, 0.1))]
    for x in (-0.42, 0.42):
        parts += [((x, y, -0.4), (0.07, 0.07, 0.42)) for y in (-0.42, 0.42)]
        parts += [((x, 0.42, 0.4), (0.07, 0.07, 0.42)), ((x, 0, -0.6), (0.06, 0.42, 0.06))]
    boxes = [((points - torch.tensor(c)).abs() - torch.tensor(h)).amax(1) for c, h in parts]
    return torch.stack(boxes).amin(0) + 0.004 * torch.sin(21 * points).prod(1)


def blob(points: Tensor) -> Tensor:
    """A ball with large and small bumps."""
    radius = points.norm(dim=1)
    d = points / radius.clamp(min=1e-6)[:, None]
    bumps = 0.08 * torch.sin(7 * d).prod(1) + 0.02 * torch.sin(25 * d[:, :2]).prod(1)
    return radius - 0.75 * (1 + bumps)


def unwrap_rows(
    name: str, verts: Tensor, faces: Tensor, target: float
) -> tuple[Unwrapped, list[dict]]:
    """The atlas; and its time, what it fills and how it stretches."""
    start = time.process_time()
    atlas = unwrap(verts, faces, 1024)
    seconds = time.process_time() - start
    report, mesh = uv_health(Mesh(verts, faces, *atlas)), f"{name} of {len(faces):,} faces"
    return atlas, [
        row(f"unwrap a {mesh}", seconds, "s", target),
        row(
            f"fill of the {mesh}'s atlas",
            report["uv_fill"],
            "",
            0.5,
            at_least=True,
        ),
        row(f"stretch of the {mesh} (1 is none)", report["uv_stretch"], ""),
    ]
