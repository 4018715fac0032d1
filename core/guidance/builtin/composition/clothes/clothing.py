"""Clothes cut to the surface of their wearer."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.clothes.cuts import CUTS, SHOES, cut
from core.guidance.builtin.composition.clothes.measurements import Measurements
from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.palette import looks
from core.guidance.builtin.solid import FAR, Solid
from core.guidance.builtin.solid_net import PARTS
from core.guidance.builtin.words.grammar.openers import Relation
from core.guidance.builtin.words.phrases.slots import Words


@dataclass(frozen=True)
class Garment(Solid):
    """A garment as one solid, in the wearer's own place."""

    noun: str = field(kw_only=True)
    wearer: Measurements = field(kw_only=True)
    names: tuple[str, ...] = field(kw_only=True)  # of the noun's parts; "": left out

    @torch.no_grad()
    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
        """Each part's signed distance."""
        found = cut(self.noun, self.wearer, points)
        far = torch.full_like(points[:, 0], FAR)
        columns = [found.get(name, far) for name in self.names]
        return torch.stack([*columns, *[far] * (PARTS - len(columns))], 1)


def garment(words: Words, drawn: Solid, wearer: Measurements) -> Garment | None:
    """The garment as it is worn; None where it does not fit, such as shoes on a fish."""
    noun = words.noun
    if noun in SHOES and not wearer.has_legs:
        return None
    zipped = words.material in ("", "leather")  # a cloth one is buttoned, as a suit is
    names = tuple("" if name == "zip" and not zipped else name for name in looks(noun))
    own = Garment(drawn.net, drawn.triplane, noun=noun, wearer=wearer, names=names)
    return own if len(own.mesh[1]) else None


def dressed(
    things: Sequence[Thing], bodies: Sequence[Body], relations: Sequence[Relation]
) -> tuple[list[Thing], list[Body], list[bool]]:
    """The drawn things with clothes cut to the first one, and whether each of the others fits."""
    first, parts = bodies[0], things[0].parts()
    found, forms, fits = list(things), list(bodies), []
    wearer: Measurements | None = None
    for k, how in enumerate(relations, 1):
        words, solid = things[k].words, things[k].solid
        fits.append(True)
        if how != "wears" or words.noun not in CUTS or parts is None or solid is None:
            continue
        wearer = wearer or Measurements.of(first, parts)
        own = garment(words, solid, wearer)
        fits[-1] = own is not None
        if own:
            found[k], forms[k] = things[k].with_solid(own), Body.of(words, own)
    return found, forms, fits
