"""Measurements of a row's asset, where the paper has no numbers."""

import json
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import torch
from scipy.spatial import KDTree

from core.benchmarks.fit_scores import sampled
from core.errors import UserError
from core.geometry.mesh import Mesh, health
from core.io.asset import read_asset
from core.io.mesh_file import load_mesh
from core.reproduce.figures import Asset
from core.stages.start_color import surface_colors

ROOT = Path(__file__).parents[2]
POINTS = 4000
LABELS = {
    "rank": "retrieval",
    "color": "colour error ΔE",
    "guide_distance": "distance to the guide, %",
    "components": "components",
    "genus": "genus",
    "roughness": "roughness",
    "metallic": "metallic",
    "psnr": "PSNR to Cycles, dB",
}


def measured(name: str, run: Path, asset: Asset, guide: Path | None) -> object:
    """The number ``name`` of LABELS of a finished run; None where it has no meaning."""
    measures: dict[str, Callable[[], object]] = {
        "rank": lambda: rank(run, asset.noun),
        "color": lambda: color_error(run, asset.noun, asset.color) if asset.color else None,
        "guide_distance": lambda: guide_distance(read_asset(run).mesh, load_mesh(guide or "")),
        "components": lambda: _health(run)["components"],
        "genus": lambda: _health(run)["genus"],
        "roughness": lambda: _median(run, 1),
        "metallic": lambda: _median(run, 2),
        "psnr": lambda: likeness(run),
    }
    return measures[name]()


def guide_distance(mesh: Mesh, guide: Mesh) -> float:
    """Mean way between the surfaces, both ways, in hundredths of the guide's longest side.

    The mesh is scaled and moved so that the middles and longest sides of both boxes agree.
    """
    ours, theirs = (sampled(_unit(each), each.faces)[0] for each in (mesh, guide))
    there, back = KDTree(theirs).query(ours)[0], KDTree(ours).query(theirs)[0]
    return round(50 * float(there.mean() + back.mean()), 2)


def _unit(mesh: Mesh) -> torch.Tensor:
    low, high = mesh.verts.amin(0), mesh.verts.amax(0)
    return (mesh.verts - (low + high) / 2) / (high - low).max()


def rank(run: Path, noun: str) -> str:
    """The place of ``noun`` among all nouns by the distance to their held-out shapes."""
    from core.prior.retrieval import mesh_cloud, ranking

    mesh, clouds = read_asset(run).mesh, _references()
    generator = torch.Generator().manual_seed(0)
    names = [name for name, _ in ranking(mesh_cloud(mesh.verts, mesh.faces, generator), clouds)]
    place = names.index(noun) + 1
    return f"{place} of {len(names)}" + ("" if place == 1 else f" ({names[0]})")


@cache
def _references() -> dict[str, list[torch.Tensor]]:
    from core.guidance.builtin.offered import drawn_nouns
    from core.prior.retrieval import kept_clouds

    return kept_clouds(drawn_nouns())


def color_error(run: Path, noun: str, color: str) -> float:
    """CIE76 difference to the word's colour over the parts that it is about."""
    from core.benchmarks.bench_prior import main_delta_e

    asset, generator = read_asset(run), torch.Generator().manual_seed(0)
    _, kd = surface_colors(asset.mesh, asset.maps.base_color, POINTS, generator)
    return round(main_delta_e(kd, noun, color), 1)


def _health(run: Path) -> dict[str, object]:
    mesh = read_asset(run).mesh
    return health(mesh.verts, mesh.faces)


def _median(run: Path, channel: int) -> float:
    asset, generator = read_asset(run), torch.Generator().manual_seed(0)
    _, orm = surface_colors(asset.mesh, asset.maps.orm, POINTS, generator)
    return round(float(orm[:, channel].median()), 2)


def likeness(run: Path) -> float:
    """PSNR of the core's picture of the asset to Cycles', dB.

    Measured by a process of its own: it needs Blender, which the core never imports.
    """
    command = [sys.executable, "-m", "blender_tests.likeness", str(run.resolve() / "asset")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        raise UserError(f"Cycles made no picture of {run}: {done.stderr[-300:]}")
    return json.loads(done.stdout.splitlines()[-1])["psnr_db"]
