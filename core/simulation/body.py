"""A rigid body for a simulator: what is seen, what is collided with, mass and inertia."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core.errors import UserError
from core.guidance.builtin.physical import usual_of
from core.io.asset import Asset
from core.simulation.hulls import MAX_HULLS, Hull, convex_hulls
from core.simulation.mass import Mass, mass_of

MASS = 1e-9, 1e12  # kg; an inertia beyond them is none in single precision


@dataclass(frozen=True, eq=False)
class Body:
    """+Z up, metres, the origin at the asset's base."""

    name: str  # letters, digits and underscores
    title: str  # the prompt
    asset: Asset
    mass: Mass
    hulls: list[Hull]


def body_of(asset: Asset, mass: float | None = None, most: int = MAX_HULLS) -> Body:
    """The body of ``asset``; ``mass`` in kg, or None for its volume times its density.

    Raises UserError for a mass that is no positive number, or a number of hulls that is none.
    """
    check_body(mass, most)
    mesh = asset.mesh
    found = mass_of(mesh.verts, mesh.faces, density_of(asset.info))
    found = found if mass is None else found.scaled_to(mass)
    title = printable(str(asset.info.get("prompt") or "asset"))
    hulls = convex_hulls(mesh.verts, mesh.faces, most)
    return Body(identifier(title), title, asset, found, hulls)


def check_body(mass: float | None, most: int) -> None:
    """Refuse what ``body_of`` refuses, before anything is made."""
    low, high = MASS
    if mass is not None and not low <= mass <= high:
        raise UserError(f"--mass is {mass:g}.", f"Use kilograms, such as 4.5: {low:g} to {high:g}.")
    if most < 1:
        raise UserError(f"--hulls is {most}.", "Use 1 or more.")


def density_of(info: dict[str, Any]) -> float:
    """Kg/m³ as asset.json has it; of an asset without, the usual one of its prompt."""
    density = info.get("density")
    if isinstance(density, int | float) and 0 < density < math.inf:
        return float(density)
    return usual_of(str(info.get("prompt") or ""))[1]


def printable(title: str) -> str:
    """``title`` without what no XML file takes, such as a NUL."""
    return "".join(c if c.isprintable() else " " for c in title)


def identifier(title: str) -> str:
    """``title`` as a name that USD and URDF allow: ASCII letters, digits and underscores."""
    text = "".join(c if c.isascii() and c.isalnum() else " " for c in title)
    name = "_".join(text.split())[:60] or "asset"
    return name if not name[0].isdigit() else f"_{name}"


def parts_folder(out: Path) -> str:
    """The folder of meshes and pictures next to ``out``."""
    return f"{out.stem}_parts"
