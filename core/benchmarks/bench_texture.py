"""Simplification, unwrap and bake of a marching-tets sphere."""

import torch

from core.appearance.material import MaterialNet
from core.benchmarks import least_ms, row
from core.config import DRAFT
from core.geometry.marching_tets import marching_tets
from core.geometry.tet_grid import tet_grid
from core.texture.bake import bake
from core.texture.simplify import simplify
from core.texture.unwrap import unwrap


def rows() -> list[dict]:
    """The unwrap runs in a process of its own, so its row is in wall seconds."""
    import time

    grid = tet_grid(64)
    verts, faces = marching_tets(grid.tet_verts, grid.tet_verts.norm(dim=1) - 0.8, grid)
    lines = [
        row(
            f"simplify {len(faces):,} faces to 20,000",
            least_ms(lambda: simplify(verts, faces, 20_000), 1) / 1e3,
            "s",
        )
    ]
    verts, faces = simplify(verts, faces, 20_000)
    start = time.perf_counter()
    atlas = unwrap(verts, faces, 1024)
    lines.append(row(f"unwrap {len(faces):,} faces (wall)", time.perf_counter() - start, "s", 10.0))
    p, q, r = atlas.uv[atlas.face_uvs].unbind(1)
    e, f = q - p, r - p
    filled = float((e[:, 0] * f[:, 1] - e[:, 1] * f[:, 0]).abs().sum() / 2)
    lines.append(row("share of the atlas filled (0.5 or more is wanted)", filled, ""))
    net = MaterialNet(DRAFT.appearance, torch.Generator().manual_seed(0))
    for size, target in ((1024, None), (2048, 15.0)):
        seconds = least_ms(lambda s=size: bake(verts, faces, *atlas, net, s), 1) / 1e3
        lines.append(row(f"bake {size}² with padding", seconds, "s", target))
    return lines
