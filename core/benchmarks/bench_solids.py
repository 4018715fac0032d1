"""``run.py bench solids``: the shapes of plain drafts, drawn and put together, before any budget.

It measures in seconds per noun what ``bench prior`` does in minutes: likeness to the noun's objects
(``likeness``), whether these are the nearest of all nouns' (``core.prior.retrieval``), and variety:
how far eight drawn solids are from one another, over how far the noun's own objects are.
"""

import itertools
import json
import time
from pathlib import Path
from typing import Any

import numpy as np
import torch
from scipy.spatial import KDTree

from core.benchmarks import machine, row, table_line
from core.benchmarks.bench_prior import known_nouns
from core.benchmarks.likeness import Points, Surface, likeness, objects
from core.config import DRAFT
from core.geometry.parts.assembly import KnownParts, assembled
from core.guidance.builtin.guidance import BuiltinGuidance, load_builtin
from core.guidance.builtin.offered import drawn_nouns
from core.io.job import write_text
from core.prior.retrieval import Cloud, kept_clouds, mesh_cloud, ranking

CREASE = (0.85, 1.15)  # over the family's own: edges are neither rounded nor ragged
MORE_MISSING = 0.03  # than a noun's objects lack of one another
COMPONENTS = 0.85  # fraction of the slices with as many components as the noun's have there
VARIETY = 0.6  # of the family's own
VARIED = 8  # objects, drawn and own, for the variety: two may be similar by chance


def bench_solids(nouns: list[str], seeds: int, out: Path | None = None) -> None:
    """Score ``seeds`` shapes of each noun (all, if empty), print a table; JSON to ``out``."""
    torch.set_num_threads(1)
    nouns = known_nouns(nouns)
    references = kept_clouds(drawn_nouns())
    guidance, scores = load_builtin("cpu"), {}
    for noun in nouns:
        scores[noun] = solid_scores(guidance, noun, seeds, references)
        print(line(noun, scores[noun]), flush=True)
    rows = [{"part": "solids"} | line for line in summary(scores)]
    print("\n".join(table_line(line) for line in rows), flush=True)
    if out:
        facts = {"machine": machine(), "rows": rows, "nouns": scores}
        write_text(out, json.dumps(facts, indent=1) + "\n")


def solid_scores(
    guidance: BuiltinGuidance, noun: str, seeds: int, references: dict[str, list[Cloud]]
) -> dict[str, Any]:
    """The likeness in the mean over the seeds, the fraction of them whose nearest references are
    the noun's, which others were nearer, the variety, and the CPU time of making one."""
    prompted, ones, drawn = guidance.prompted(noun, ""), [], []
    start = time.process_time()
    for seed in range(seeds):
        ones.append(prompted.of_object(seed))
        parts = ones[-1].parts()
        assert parts is not None  # each of them has
        # The families' own objects are as stout as they are drawn.
        parts = KnownParts(parts.distances, parts.forms._replace(slender=()), parts.wider)
        made = assembled(parts, True, DRAFT.geometry.floaters, lambda _: None)
        assert made is not None  # of some size
        drawn.append(made)
    cpu_s = (time.process_time() - start) / seeds
    surfaces = [Surface.of_mesh(*mesh) for mesh in drawn]
    each = [likeness(surface, noun) for surface in surfaces]
    mean = {name: float(np.mean([one[name] for one in each])) for name in each[0]}
    ones += [prompted.of_object(seed) for seed in range(seeds, VARIED)]
    generator = torch.Generator().manual_seed(0)
    ranks = [[name for name, _ in ranking(mesh_cloud(*m, generator), references)] for m in drawn]
    behind = [names[: names.index(noun)] for names in ranks]
    return mean | {
        "first": sum(not nearer for nearer in behind) / seeds,
        "first_five": sum(len(nearer) < 5 for nearer in behind) / seeds,
        "nearer": sorted({name for nearer in behind for name in nearer[:5]}),
        "variety": variety(
            [Surface.of_mesh(*one.solid.mesh) for one in ones if one.solid], objects(noun, VARIED)
        ),
        "cpu_s": cpu_s,
    }


def line(noun: str, score: dict[str, Any]) -> str:
    """A score as text."""
    numbers = "".join(f" {k} {v:<6.3g}" for k, v in score.items() if k != "nearer")
    return (
        f"{noun:<18}{numbers}{' nearer: ' if score['nearer'] else ''}{', '.join(score['nearer'])}"
    )


def variety(drawn: "list[Surface]", own: "tuple[Surface, ...]") -> float:
    """Mean distance of the drawn from one another over that of the noun's own objects; 1 where
    all of its own are the same (balls)."""
    spread = _spread(list(own))
    return _spread(list(drawn)) / spread if spread else 1.0


def _spread(surfaces: list[Surface]) -> float:
    pairs = itertools.combinations([surface.points for surface in surfaces], 2)
    return float(np.mean([_apart(one, other) for one, other in pairs]))


def _apart(one: Points, other: Points) -> float:
    """The symmetric Chamfer distance."""
    ways = (KDTree(one).query(other)[0].mean(), KDTree(other).query(one)[0].mean())
    return float(np.mean(ways))


def summary(scores: dict[str, dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows for all nouns: how many pass each measure."""

    def fraction(holds: Any) -> float:
        return float(np.mean([holds(one) for one in scores.values()]))

    def mean(name: str) -> float:
        return float(np.mean([one[name] for one in scores.values()]))

    return [
        row("shape, top 1", mean("first"), "of shapes", 0.97, True),
        row("shape, top 5", mean("first_five"), "of shapes"),
        row("crease", mean("crease"), "of the family's"),
        row(
            "edges",
            fraction(lambda s: CREASE[0] <= s["crease"] <= CREASE[1]),
            "of nouns",
            0.9,
            True,
        ),
        row(
            "nothing missing",
            fraction(lambda s: s["missing"] <= s["usual_missing"] + MORE_MISSING),
            "of nouns",
            0.97,
            True,
        ),
        row("pieces", fraction(lambda s: s["pieces"] >= COMPONENTS), "of nouns", 0.97, True),
        row("various", fraction(lambda s: s["variety"] >= VARIETY), "of nouns", 0.97, True),
        row("making, CPU", mean("cpu_s"), "s"),
    ]
