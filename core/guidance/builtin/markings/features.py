"""Markings that rows of people, animals and toys share: eyes, mouths, feathers, bars, spots."""

from functools import partial

from core.guidance.builtin.markings import creatures, figures
from core.guidance.builtin.markings.creatures import SIDE
from core.guidance.builtin.markings.margins import blobs
from core.guidance.builtin.markings.marking import Marking

GLINTS = {"glints": Marking("eyes", creatures.glints, paired=True)}
MUZZLED = {"mouth": Marking("muzzle", figures.muzzle_mouth)}


def eyes(at: figures.At, size: figures.At, face: figures.Face = figures.HEAD) -> dict[str, Marking]:
    """A pair that has a light in it, on a round head; in head radii."""
    return {
        "glints": Marking("eyes", partial(figures.glints, at=at, size=size, face=face)),
        "eyes": Marking("skin", partial(figures.ovals, at=at, size=size, face=face)),
    }


def mouth(
    at: float = -0.46, wide: float = 0.2, face: figures.Face = figures.HEAD
) -> dict[str, Marking]:
    """A small smile on a round head."""
    return {"mouth": Marking("skin", partial(figures.smile, at=at, wide=wide, face=face))}


def lines(
    on: str,
    *curves: creatures.Curve,
    wide: float = 0.28,
    side: bool = False,
    until: float = 6.0,
) -> Marking:
    """On a face, by its eyes."""
    axes = SIDE if side else creatures.FRONT
    marks = partial(creatures.by_eyes, curves=curves, wide=wide, axes=axes, until=until)
    return Marking(on, marks, by="eyes", paired=True)


def spots(on: str, *middles: creatures.Way, sizes: creatures.Way) -> Marking:
    """Nostrils, cheeks and the like, by the eyes."""
    marks = partial(creatures.about_eyes, middles=middles, sizes=sizes)
    return Marking(on, marks, by="eyes", paired=True)


def pupils(
    wide: float = 0.45, high: float = 0.45, way: creatures.Way = (0.1, -1.0, 0.05)
) -> dict[str, Marking]:
    """Of eyes that have none."""
    spots = ((way, (wide, high)),)
    return {"pupils": Marking("eyes", partial(creatures.on_eye, spots=spots), paired=True)}


def feathers(**others: object) -> dict[str, Marking]:
    """Of wings that are folded at both sides."""
    return {"feathers": Marking("wings", partial(creatures.plumage, **others), paired=True)}


def bars(on: str, **others: object) -> Marking:
    """Lines across a way, as between the plates of a belly."""
    return Marking(on, partial(creatures.bars, **others))


def wing_lines(
    on: str,
    *curves: creatures.Curve,
    wide: float = 0.013,
    axes: tuple[int, int] = creatures.FRONT,
) -> Marking:
    """On wings, alike on both sides."""
    return Marking(on, partial(creatures.drawn, curves=curves, wide=wide, axes=axes), paired=True)


def mottled(on: str, pitch: float, low: float, high: float, share: float) -> Marking:
    """Round spots of sizes from ``low`` to ``high``, scattered about."""
    return Marking(on, partial(blobs, pitch=pitch, sizes=(low, high), share=share))
