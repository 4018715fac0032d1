"""``run.py bench prior``: how good the built-in prior is, measured on the meshes that it makes.

Every noun is generated with each seed, in words that also name a colour and a material, and scored:
shape by retrieval among held-out shapes of all nouns (``core.prior.retrieval``) and by what that
does not see (``likeness``: creases, planes, missing parts, components of slices), colour, material,
closedness, components and holes. A run is one folder and its score one file in it: a bench that was
stopped continues where it was, and an existing run is not made again.
"""

import json
import time
from pathlib import Path
from typing import Any

import torch
from jaxtyping import Float
from torch import Tensor

from core.benchmarks import machine, row, table_line
from core.benchmarks.likeness import Surface, likeness
from core.errors import UserError
from core.generate import generate, prepare
from core.geometry.mesh import health
from core.guidance.builtin.offered import drawn_nouns, offered_words
from core.guidance.builtin.palette import FINISHES, looks
from core.guidance.builtin.words.grammar.prompt_errors import known_things
from core.guidance.builtin.words.tables.colors import COLOR_VALUES
from core.io.asset import read_asset
from core.io.job import Job, write_text
from core.io.maps import Maps
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.ops import lab, srgb_to_linear
from core.prior.retrieval import kept_clouds, mesh_cloud, ranking
from core.stages.start_color import surface_colors
from core.texture.detail.detail import THIN

FOLDER = Path("out/bench_prior")
# Holes that define a thing, and things that must not have any: those on separate legs, and those
# that something is poured into.
GENUS = {"torus": 1, "mug": 1, "teapot": 1, "bucket": 1, "trophy": 2, "crown": 1}
GENUS |= dict.fromkeys(("table", "stool", "armchair", "sofa", "bed"), 0)
GENUS |= dict.fromkeys(("vase", "bottle", "bowl", "pan", "goblet"), 0)
ADDED = dict.fromkeys(("mug", "bucket"), " with a handle")  # which they have not always
MAX_DELTA_E = 20.0
CREASE = 0.85  # of the family's own, at the least; less is clay
MORE_MISSING = 0.03  # than a noun's objects lack of one another
SLICES = 0.85  # fraction of the slices with as many components as the noun's have there
ROUGHNESS_REACH = 0.2  # around the word's own
POINTS = 4000


def bench_prior(
    nouns: list[str], seeds: int, folder: Path | None = None, out: Path | None = None
) -> None:
    """Make what ``folder`` lacks, score it, print the scores and a table; JSON to ``out``.

    ``nouns`` empty: all that the shipped weights offer. One thread: two benches, each with half
    of the nouns, use two cores.
    """
    nouns, known = known_nouns(nouns), offered_words()
    torch.set_num_threads(1)
    references = kept_clouds(drawn_nouns())
    scores = []
    for noun in nouns:
        for seed in range(seeds):
            scores.append(_scored(noun, seed, known, folder or FOLDER, references))
            print(line(scores[-1]), flush=True)
    rows = [{"part": "prior"} | found for found in summary(scores)]
    print(*map(table_line, rows), sep="\n")
    if out:
        facts = {"machine": machine(), "rows": rows, "runs": scores}
        write_text(out, json.dumps(facts, indent=1) + "\n")


def known_nouns(nouns: list[str]) -> list[str]:
    """The nouns, if the shipped weights offer them; all that they do, if there are none. Not what
    is another thing's solid."""
    known = drawn_nouns()
    for noun in nouns:
        if noun not in known:
            own = f"The built-in prior has no noun {noun!r} with a solid of its own."
            raise UserError(own, known_things(offered_words()))
    return nouns or known


def _scored(
    noun: str, seed: int, known: dict[str, list[str]], folder: Path, references: dict
) -> dict[str, Any]:
    run = folder / f"{noun.replace(' ', '-')}-{seed}"
    path = run / "score.json"
    if path.exists():
        return json.loads(path.read_text(encoding="utf-8"))
    color, material = words_for(noun, seed, known)
    start = time.monotonic()
    failure = _make(run, f"{color} {material} {noun}{ADDED.get(noun, '')}", seed)
    facts = {"noun": noun, "seed": seed, "color": color, "material": material}
    facts |= {"seconds": round(time.monotonic() - start, 1), "failure": failure}
    facts |= {} if failure else score(run, facts, references)
    write_text(path, json.dumps(facts, indent=1) + "\n")
    return facts


def words_for(noun: str, seed: int, known: dict[str, list[str]]) -> tuple[str, str]:
    """A colour and a material; strides make all of them come about equally often."""
    index = known["noun"].index(noun)
    colors, materials = known["color"], known["material"]
    return colors[(5 * index + 7 * seed) % len(colors)], materials[
        (index + 5 * seed) % len(materials)
    ]


def _make(run: Path, prompt: str, seed: int) -> str:
    """Carry the run out, or continue it; the error text, or ""."""
    if (run / "job.json").exists():
        here = RunFolder.open(run)
    else:
        here = RunFolder.create(run, Job(prompt=prompt, seed=seed))
    if here.asset.exists():
        return ""
    try:
        generate(here, prepare(here.job), Progress(here))
    except UserError as error:
        if error.status == 130:
            raise
        return error.text
    return ""


def score(run: Path, facts: dict[str, Any], references: dict) -> dict[str, Any]:
    """The measures of a finished run (see the module's head)."""
    asset = read_asset(run)
    generator = torch.Generator().manual_seed(0)
    ranks = ranking(mesh_cloud(asset.mesh.verts, asset.mesh.faces, generator), references)
    names = [name for name, _ in ranks]
    noun, report = facts["noun"], health(asset.mesh.verts, asset.mesh.faces)
    shape = {
        "rank": names.index(noun) + 1,
        "nearest": names[:5],
        "chamfer": round(dict(ranks)[noun], 4),
        "closed": report["closed"],
        "components": report["components"],
        "genus": report["genus"],
    }
    mesh = asset.mesh
    shape |= likeness(Surface.of_mesh(mesh.verts, mesh.faces), noun)
    _, kd = surface_colors(mesh, one_wall(asset.maps), POINTS, generator)
    _, orm = surface_colors(mesh, asset.maps.orm, POINTS, generator)
    finish = FINISHES[facts["material"]]
    roughness, metallic = orm[:, 1].median().item(), orm[:, 2].median().item()
    right = abs(roughness - finish.roughness) < ROUGHNESS_REACH
    # Of rust the texture decides: rust and paint are not metallic, the bare metal in between is.
    right &= facts["material"] == "rusty" or (metallic > 0.5) == (finish.metallic > 0.5)
    return shape | {
        "delta_e": round(main_delta_e(kd, noun, facts["color"]), 1),
        "roughness": round(roughness, 3),
        "metallic": round(metallic, 3),
        "material_right": right,
    }


def one_wall(maps: Maps) -> Float[Tensor, "s s 3"]:
    """The base colour, which of what is clear is a lighter one, as light goes through two walls."""
    if maps.transmission is None:
        return maps.base_color
    return maps.base_color ** (1 / (1 - THIN * maps.transmission))


def main_delta_e(kd: Tensor, noun: str, color: str) -> float:
    """Median CIE76 difference to the word's colour over the main parts' fraction of the surface.

    Which points belong to main parts is not known: they are taken to be those that come nearest,
    as many as the fraction of the noun's parts that a colour word is about.
    """
    roles = [look.role in "*&" for look in looks(noun).values()]
    target = lab(srgb_to_linear(torch.tensor([COLOR_VALUES[color]])))
    away = (lab(kd) - target).norm(dim=1).sort().values
    return away[int(len(away) * sum(roles) / len(roles) / 2)].item()


def line(score: dict[str, Any]) -> str:
    """A score as text."""
    head = f"{score['noun']:13} {score['seed']}  "
    if score["failure"]:
        return f"{head}FAILED: {score['failure']}"
    marks = "" if score["rank"] == 1 else f" (nearest {score['nearest'][0]})"
    return (
        f"{head}rank {score['rank']:2}{marks}  dE {score['delta_e']:5.1f}  "
        f"rough {score['roughness']:.2f} metal {score['metallic']:.2f} "
        f"{'' if score['material_right'] else 'WRONG '}({score['color']} {score['material']})  "
        f"crease {score['crease']:.2f} flat {score['flat']:.2f} missing {score['missing']:.3f} "
        f"slices {score['pieces']:.2f}  "
        f"pieces {score['components']} genus {score['genus']}  {score['seconds']:.0f} s"
    )


def summary(scores: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rates over all runs; a run that failed counts as wrong in every one."""

    def rate(name: str, right: list[bool], target: float) -> dict[str, Any]:
        fraction = sum(right) / max(len(right), 1)
        return row(f"{name}, of {len(right)} runs", fraction, "", target, at_least=True)

    made = [s for s in scores if not s["failure"]]
    lost = [False] * (len(scores) - len(made))
    holed = [s for s in made if s["noun"] in GENUS]
    rows = [
        rate("shape, top 1", [s["rank"] == 1 for s in made] + lost, 0.85),
        rate("shape, top 5", [s["rank"] <= 5 for s in made] + lost, 0.97),
        rate("colour within 20", [s["delta_e"] <= MAX_DELTA_E for s in made] + lost, 0.95),
        rate("material", [s["material_right"] for s in made] + lost, 0.9),
        rate(
            "closed, one piece", [s["closed"] and s["components"] == 1 for s in made] + lost, 0.98
        ),
        rate("nothing vanished", [True] * len(made) + lost, 1.0),
        rate("edges sharp", [s["crease"] >= CREASE for s in made] + lost, 0.9),
        rate(
            "nothing missing",
            [s["missing"] <= s["usual_missing"] + MORE_MISSING for s in made] + lost,
            0.95,
        ),
        rate("parts in number", [s["pieces"] >= SLICES for s in made] + lost, 0.95),
    ]
    if made:
        creases = sorted(s["crease"] for s in made)
        rows.append(row("crease, median", creases[len(creases) // 2], "", 0.9, at_least=True))
    if holed:
        rows.append(rate("holes", [s["genus"] == GENUS[s["noun"]] for s in holed], 1.0))
    return rows
