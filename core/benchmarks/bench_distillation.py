"""``run.py bench distillation``: sds, csd and sdi at the same number of network calls.

Of each noun the geometry is distilled from an ellipsoid by each method of ``METHODS``, and scored
by its distance to held-out shapes; then its colours, over a known solid, so that the two trainings
are judged apart. No rounds of fitting: the draft's scores, noise and caps, and nothing beyond them.
A training is one run folder in its noun's folder, and its score one file in it: a bench that was
stopped continues where it was, and what is there is not made again.
"""

import json
import time
from dataclasses import replace
from pathlib import Path
from statistics import median
from typing import Any

import torch
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.lights import studio
from core.appearance.material import MaterialNet
from core.benchmarks import keep_settings, machine, row, table_line
from core.benchmarks.bench_prior import main_delta_e, words_for
from core.config import DRAFT, Config, PhaseConfig, RefineConfig, TextureConfig
from core.errors import UserError
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import Mesh, face_areas, health
from core.geometry.tet_grid import tet_grid
from core.guidance.builtin.guidance import load_builtin
from core.guidance.builtin.offered import offered_words
from core.guidance.guidance import PromptedGuidance
from core.io.job import Job, write_text
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.job_config import within
from core.prior.draw import Draw
from core.prior.families import build
from core.prior.retrieval import mesh_cloud, ranking, reference_clouds
from core.settings import with_settings
from core.stages.appearance import learn_appearance
from core.stages.geometry import learn_geometry
from core.stages.start_shape import fit_start_shape, sdf_net
from core.stages.state import Training
from core.stages.texturing import unwrap_shape
from core.stages.training import Setup

FOLDER = Path("out/bench_distillation")
NOUNS = (
    "chair", "table", "mug", "torus", "house", "car",
    "fish", "tree", "lamp", "bottle", "airplane", "snowman",
)  # fmt: skip
# sdi is for the appearance: with normals its authors' setting has no counterpart.
METHODS = (
    ("geometry", "sds"),
    ("geometry", "csd"),
    ("appearance", "sds"),
    ("appearance", "csd"),
    ("appearance", "sdi"),
)
CALLS = 60  # guided predictions of each view
VIEWS = 4
INVERSION_STEPS = 3  # of sdi; ten, its authors' number, would leave five steps of sixty calls
SOLID = 32  # lattice of the solid that is coloured
POINTS = 4000


def bench_distillation(
    nouns: list[str],
    settings: list[str],
    calls: int = CALLS,
    folder: Path | None = None,
    out: Path | None = None,
) -> None:
    """Train and score what ``folder`` lacks, print a line each and a table; JSON to ``out``.

    ``nouns`` empty: ``NOUNS``. ``settings``: as for ``--set``, over the comparison's own.
    """
    unknown = [noun for noun in nouns if noun not in offered_words()["noun"]]
    if unknown:
        raise UserError(
            f"The built-in prior has no noun {unknown[0]!r}.",
            f"Use one of: {', '.join(offered_words()['noun'])}.",
        )
    torch.set_num_threads(1)
    config_of("sds", calls, settings)  # their errors are reported before anything is made
    keep_settings(folder or FOLDER, {"calls": calls, "settings": settings})
    chosen = list(nouns or NOUNS)
    references, scores = reference_clouds(chosen), []
    for noun in chosen:
        for stage, method in METHODS:
            config = config_of(method, calls, settings)
            place = (folder or FOLDER) / noun.replace(" ", "-") / f"{stage}-{method}"
            scores.append(_scored(noun, stage, method, config, place, references))
            print(line(scores[-1]), flush=True)
    rows = [{"part": "distill"} | found for found in summary(scores)]
    print(*map(table_line, rows), sep="\n")
    if out:
        facts = {"machine": machine(), "calls": calls, "settings": settings, "rows": rows}
        write_text(out, json.dumps(facts | {"runs": scores}, indent=1) + "\n")


def config_of(method: str, calls: int, settings: list[str]) -> Config:
    """The draft as distillation alone, of so many network calls, all by ``method``."""

    def phase(of: PhaseConfig) -> PhaseConfig:
        steps = max(1, calls // (1 + INVERSION_STEPS if method == "sdi" else 1))
        own = replace(of, distillation=method, inversion_steps=INVERSION_STEPS)
        return replace(own, steps=steps, size=64)

    g, a, none = DRAFT.geometry, DRAFT.appearance, RefineConfig()
    shape = replace(g, coarse=phase(g.coarse), grow=none, refine=none, views=VIEWS)
    color = replace(phase(a.early), t_high=(a.early.t_high[0], a.late.t_high[1]))
    look = replace(a, early=color, late=replace(a.late, steps=0), refine=none, views=VIEWS)
    config = Config(geometry=shape, appearance=look, texture=TextureConfig(size=256))
    return with_settings(config, dict(text.split("=", 1) for text in settings))


def _scored(
    noun: str, stage: str, method: str, config: Config, place: Path, references: dict
) -> dict[str, Any]:
    path = place / "score.json"
    if path.exists():
        return json.loads(path.read_text(encoding="utf-8"))
    color, material = words_for(noun, 0, offered_words())
    job = Job(prompt=f"{color} {material} {noun}")
    run = RunFolder.open(place) if (place / "job.json").exists() else RunFolder.create(place, job)
    guidance, cpu = load_builtin("cpu").prompted(job.prompt, ""), time.process_time()
    facts: dict[str, Any] = {"noun": noun, "stage": stage, "method": method, "failure": ""}
    try:
        if stage == "geometry":
            facts |= shape_score(learned_mesh(run, guidance, config), noun, references)
        else:
            kd = learned_kd(run, guidance, config, noun)
            facts["delta_e"] = round(main_delta_e(kd, noun, color), 1)
    except UserError as error:
        if error.status == 130:
            raise
        facts["failure"] = error.text
    facts["cpu_s"] = round(time.process_time() - cpu, 1)
    write_text(path, json.dumps(facts, indent=1) + "\n")
    return facts


def learned_mesh(run: RunFolder, guidance: PromptedGuidance, config: Config) -> Mesh:
    """The shape that distillation makes of an ellipsoid."""
    generator, progress = torch.Generator().manual_seed(0), Progress(run)
    net = sdf_net(config.geometry, generator)
    training = Training("geometry", net, generator, run)
    if not run.has(training.name):
        fit_start_shape(training, config.geometry, progress)
    mesh = learn_geometry(Setup(training, guidance, config.geometry), progress)
    assert mesh is not None  # one process alone
    return Mesh(*mesh)


def shape_score(mesh: Mesh, noun: str, references: dict) -> dict[str, Any]:
    """Rank and distance among the held-out shapes of the bench's nouns."""
    ranks = ranking(mesh_cloud(mesh.verts, mesh.faces, _seeded()), references)
    report = health(mesh.verts, mesh.faces)
    return {
        "rank": [name for name, _ in ranks].index(noun) + 1,
        "chamfer": round(dict(ranks)[noun], 4),
        "components": report["components"],
        "genus": report["genus"],
    }


def learned_kd(run: RunFolder, guidance: PromptedGuidance, config: Config, noun: str) -> Tensor:
    """kd (N, 3), linear, that distillation puts on points of the noun's known solid."""
    solid = build(noun, "", Draw(torch.Generator().manual_seed(7)), jitter=0.0)
    grid, progress = tet_grid(SOLID), Progress(run)
    verts, faces = marching_tets(grid.tet_verts, solid.sdf(grid.tet_verts), grid)
    mesh = unwrap_shape(Mesh(verts, faces), config.texture, progress).mesh
    look, generator = within(config.appearance, guidance.ranges()), _seeded()
    net = MaterialNet(look, generator)
    training = Training("appearance", net, generator, run)
    light = Environment.of(studio(), look.shading)
    learn_appearance(Setup(training, guidance, look), mesh, light, progress)
    # Faces by their area: the lattice's are small, so their middles represent the surface.
    face = torch.multinomial(face_areas(verts, faces), POINTS, True, generator=_seeded())
    with torch.no_grad():
        return net(verts[faces[face]].mean(1)).kd


def _seeded() -> torch.Generator:
    return torch.Generator().manual_seed(0)


def line(score: dict[str, Any]) -> str:
    """A score as text."""
    head = f"{score['noun']:10} {score['stage']:10} {score['method']}  "
    if score["failure"]:
        return f"{head}FAILED: {score['failure']}"
    if score["stage"] == "appearance":
        return f"{head}dE {score['delta_e']:5.1f}  {score['cpu_s']:.0f} s"
    return (
        f"{head}rank {score['rank']:2}  chamfer {score['chamfer']:.4f}  "
        f"components {score['components']} genus {score['genus']}  {score['cpu_s']:.0f} s"
    )


def summary(scores: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """For each method: how often the shape is nearest to its own noun, distances, colours."""
    rows = []
    for stage, method in METHODS:
        tried = [s for s in scores if (s["stage"], s["method"]) == (stage, method)]
        made = [s for s in tried if not s["failure"]]
        if not made:
            continue
        name = f"{stage} {method}, of {len(tried)} nouns"
        if stage == "geometry":
            rows.append(row(f"{name}: nearest to their own", sum(s["rank"] == 1 for s in made), ""))
            rows.append(row(f"{name}: Chamfer, mean", _mean(made, "chamfer"), ""))
        else:
            rows.append(row(f"{name}: dE, mean", _mean(made, "delta_e"), ""))
            rows.append(row(f"{name}: dE, median", median(s["delta_e"] for s in made), ""))
        rows.append(row(f"{name}: CPU", _mean(made, "cpu_s"), "s"))
    return rows


def _mean(scores: list[dict[str, Any]], key: str) -> float:
    return sum(s[key] for s in scores) / len(scores)
