"""The page docs/sizes.md: the usual size and mass of everything that the built-in prior knows.

``python -m core.prior.masses`` writes it.
"""

from pathlib import Path

import torch

from core.geometry.mesh import signed_volume
from core.geometry.union import union
from core.guidance.builtin.composition.appendages.appendage import solids_of
from core.guidance.builtin.constructed.draw import Draw as SeedDraw
from core.guidance.builtin.constructed.shapes import of_training_size
from core.guidance.builtin.constructed.solid import EDGE
from core.guidance.builtin.constructed.things import THINGS
from core.guidance.builtin.nouns import CONSTRUCTED, GROUPS
from core.guidance.builtin.stretch import known_wider
from core.guidance.builtin.words.tables.sizes import usual
from core.prior.draw import Draw
from core.prior.families import build

PAGE = Path(__file__).resolve().parents[2] / "docs" / "sizes.md"
ACROSS = 3  # things in a row
HEAD = """# Usual sizes and masses

What `generate` makes is as large and as heavy as an ordinary specimen: the longest side, and the
mass of the prior's own solid (one of each, seed 1) in the material that the thing is of where the
prompt names none. A size in the prompt ("2 m tall") or `--size METRES` sets another. What is made
as one of these things and is not of its size has its own: a kennel, made as a house, has 1.1 m. The
data is in `core/guidance/builtin/nouns/` and, of such kinds, in `words/tables/kind_sizes.py`;
`python -m core.prior.masses` writes this page, a test compares it.
"""


def usual_mass(noun: str, side: int = 40) -> float:
    """The mass in kilograms of the prior's own solid at the noun's usual size."""
    if noun in CONSTRUCTED:
        return _constructed_mass(noun)
    axis = ((torch.arange(side) + 0.5) / side * 2 - 1) * 1.05
    cells = torch.stack(torch.meshgrid(axis, axis, axis, indexing="ij"), -1).view(-1, 3)
    wider = known_wider(noun)  # or its walls would be between the cells
    shape = build(noun, "", Draw(torch.Generator().manual_seed(1)), 0, wider)
    inside = cells[shape.sdf(cells) < 0]
    step, by = 2.1 / side, torch.tensor(wider)
    longest = float(((inside.amax(0) - inside.amin(0) + step) / by).max())
    size, density = usual(noun)
    return len(inside) * (step * size / longest) ** 3 * density / float(by.prod())


def _constructed_mass(noun: str) -> float:
    """That of what no network draws; it may be too thin for cells."""
    parts = of_training_size(THINGS[noun](SeedDraw(1))) if noun in THINGS else solids_of(noun)
    meshes = [one.mesh(EDGE) for own in parts.values() for one in own]
    verts, faces = union(meshes, 0.0)
    size, density = usual(noun)
    longest = float((verts.amax(0) - verts.amin(0)).max())
    return float(signed_volume(verts, faces)) * (size / longest) ** 3 * density


def cell(noun: str) -> str:
    """A noun's cells of the table: its name, its size, its mass in two figures."""
    return f"{noun} | {usual(noun)[0]:g} m | {_mass(usual_mass(noun))}"


def _mass(kilograms: float) -> str:
    rounded = float(f"{kilograms:.2g}")
    unit, factor = ("t", 1e-3) if rounded >= 1e3 else ("kg", 1.0) if rounded >= 1 else ("g", 1e3)
    return f"{rounded * factor:,.10g} {unit}"


def page() -> str:
    """The whole page, in Markdown."""
    lines = [HEAD]
    for group, nouns in GROUPS.items():
        cells = [cell(noun) for noun in nouns]
        cells += [" |  | "] * (-len(cells) % ACROSS)
        lines += [
            f"## {group}",
            "",
            "| thing | size | mass " * ACROSS + "|",
            "|---|---|---" * ACROSS + "|",
        ]
        lines += [
            "| " + " | ".join(cells[at : at + ACROSS]) + " |" for at in range(0, len(cells), ACROSS)
        ]
        lines.append("")
    return "\n".join(lines)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
