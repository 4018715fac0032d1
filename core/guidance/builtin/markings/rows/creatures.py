"""Creatures, and people of tales."""

from functools import partial

from core.guidance.builtin.markings import creatures, figures, outlines
from core.guidance.builtin.markings.creatures import SIDE
from core.guidance.builtin.markings.margins import blobs
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.outlines import Emblem, Line, Plate, Poly

SNAKE_PUPIL = (Plate((-1.14, 1.09), (0.12, 0.18), 1.0),)  # their middle is not the body's
BEE_VEINS = tuple(((-0.9, 0.0), end) for end in ((0.8, 0.1), (0.4, -0.7), (0.2, 0.6)))
DRAGON_BONES = (
    ((-1.0, -0.4), (-0.42, 0.93), (0.36, 0.97), (1.0, 0.06)),
    *(((-0.42, 0.93), end) for end in ((0.32, -0.58), (-0.44, -1.0))),
)
DEMON_BONES = (
    ((-0.95, 0.0), (-0.2, 0.4), (0.5, 0.95)),
    *(((0.5, 0.95), end) for end in ((0.98, 0.0), (0.58, -0.58), (0.0, -0.95))),
)
EAGLE_QUILLS = (
    ((-1.0, -0.2), (-0.5, -0.02), (0.0, 0.28), (0.5, 0.62), (0.95, 0.8)),
    *((root, end) for root, end in (((0.3, 0.48), (0.6, -0.14)), ((-0.1, 0.22), (0.1, -0.57)))),
    *((root, end) for root, end in (((-0.5, -0.02), (-0.42, -0.72)), ((0.62, 0.7), (0.9, 0.2)))),
)
GRIFFIN_QUILLS = (
    ((-1.0, -0.4), (-0.55, 0.2), (-0.1, 0.5), (0.5, 0.64)),
    ((-0.2, 0.44), (0.4, 0.3)),
    ((-0.5, 0.24), (-0.04, -0.27)),
    ((0.3, 0.6), (0.9, 0.42)),
)
PHOENIX_QUILLS = (
    ((-1.0, -0.1), (-0.4, 0.1), (0.1, 0.5), (0.4, 0.95)),
    ((-0.4, 0.1), (-0.1, -0.7)),
    ((-0.1, 0.34), (0.4, -0.4)),
    ((0.2, 0.62), (0.9, 0.1)),
)
QUARTERS = tuple(
    Poly(((0, 0), (0.85 * k, 0), (0.85 * k, 0.85 * k), (0, 0.85 * k))) for k in (1, -1)
)
SKULL_TEETH = tuple(Line(((0.14 * k, -0.82), (0.14 * k, -0.44))) for k in range(-2, 3))
SKULL_CRACKS = (
    Line(((0.3, 0.95), (0.42, 0.74), (0.3, 0.62), (0.4, 0.44)), 0.016),
    Line(((0.42, 0.74), (0.56, 0.66)), 0.013),
)
GLINTS = {"glints": Marking("eyes", creatures.glints, paired=True)}
MUZZLED = {"mouth": Marking("muzzle", figures.muzzle_mouth)}


def _lines(
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


def _spots(on: str, *middles: creatures.Way, sizes: creatures.Way) -> Marking:
    """Nostrils, cheeks and the like, by the eyes."""
    marks = partial(creatures.about_eyes, middles=middles, sizes=sizes)
    return Marking(on, marks, by="eyes", paired=True)


def _pupils(
    wide: float = 0.45, high: float = 0.45, way: creatures.Way = (0.1, -1.0, 0.05)
) -> dict[str, Marking]:
    """Of eyes that have none."""
    spots = ((way, (wide, high)),)
    return {"pupils": Marking("eyes", partial(creatures.on_eye, spots=spots), paired=True)}


def _feathers(**others: object) -> dict[str, Marking]:
    """Of wings that are folded at both sides."""
    return {"feathers": Marking("wings", partial(creatures.plumage, **others), paired=True)}


def _bars(on: str, **others: object) -> Marking:
    return Marking(on, partial(creatures.bars, **others))


def _drawn(
    on: str,
    *curves: creatures.Curve,
    wide: float = 0.013,
    axes: tuple[int, int] = creatures.FRONT,
) -> Marking:
    """On wings, alike on both sides."""
    return Marking(on, partial(creatures.drawn, curves=curves, wide=wide, axes=axes), paired=True)


def _blobs(on: str, pitch: float, low: float, high: float, share: float) -> Marking:
    return Marking(on, partial(blobs, pitch=pitch, sizes=(low, high), share=share))


CREATURES: Rows = {
    "dragon": {
        "ribs": _drawn("wings", *DRAGON_BONES, wide=0.024),
        "grooves": _bars("belly", way=(0.0, -1.0, 1.0), pitch=0.085),
    },
    "wolf": {
        **GLINTS,
        **MUZZLED,
        "ears": _spots("body", (0.85, 3.2, 4.2), sizes=(0.8, 1.6, 1.9)),
    },
    "bird": _feathers() | GLINTS,
    "chicken": _feathers(),
    "horse": {
        **GLINTS,
        "nostrils": _spots("body", (-1.9, -5.6, -4.5), sizes=(0.55, 1.2, 0.5)),
        "mouth": _lines("body", ((-9.0, -5.8), (-4.6, -5.8), (-3.2, -5.2)), side=True, wide=0.2),
        "blaze": _spots("body", (-3.0, -3.5, -0.4), sizes=(0.8, 3.0, 2.4)),
    },
    "monster": {"spots": _blobs("fur", 0.26, 0.05, 0.08, 0.75)},
    "alien": GLINTS,
    "ghost": {**GLINTS, "cheeks": _spots("body", (0.9, 0.0, -1.7), sizes=(0.55, 2.5, 0.38))},
    "superhero": {
        "mouth": _lines("skin", ((-0.55, -2.2), (-1.0, -2.5), (-1.5, -2.55), (-9.0, -2.55))),
        "star": Marking(
            "trim", partial(outlines.laid, front=(Emblem((0, 0.55), 0.15, "star"),)), by="suit"
        ),
    },
    "cowboy": {
        "mouth": Marking("skin", partial(figures.smile, at=-0.36, wide=0.2)),
        "star": Marking(
            "vest", partial(outlines.laid, front=(Emblem((0.6, 0.3), 0.24, "star"),), deep=0.1)
        ),
    },
    "viking": {
        "quarters": Marking(
            "tunic", partial(outlines.laid, front=QUARTERS, deep=-4.0), by="helmet"
        ),
    },
    "skeleton": {
        "teeth": _lines(
            "bone",
            ((-9.0, -3.3), (0.2, -3.3)),
            *(((x, -2.8), (x, -3.8)) for x in (-1.7, -1.05, -0.4)),
            wide=0.13,
            until=2.0,
        ),
    },
    "samurai": {"laces": _bars("armour", pitch=0.09, wide=0.013)},
    "zombie": {
        **_pupils(0.4, 0.4),
        "stitches": _lines(
            "skin",
            ((0.1, -1.65), (1.4, -1.25)),
            *(
                ((0.3 + 0.5 * k, -1.25 + 0.15 * k), (0.4 + 0.5 * k, -1.95 + 0.15 * k))
                for k in range(3)
            ),
            wide=0.12,
        ),
    },
    "vampire": {
        **_pupils(0.4, 0.4),
        "buttons": Marking(
            "vest", partial(figures.dots, places=[(0.0, 0.5), (0.0, 0.2), (0.0, -0.1)], size=0.1)
        ),
    },
    "mermaid": {
        "scales": Marking("tail", creatures.tail_scales),
        "mouth": _lines(
            "skin", ((-0.9, -2.7), (-1.5, -3.2), (-2.2, -3.3), (-9.0, -3.3)), wide=0.25
        ),
    },
    "troll": _pupils(0.42, 0.42),
    "demon": {
        **_pupils(0.3, 0.75),
        "ribs": _drawn("wings", *DEMON_BONES, wide=0.024),
    },
    "baby": {
        **GLINTS,
        "cheeks": _spots("skin", (0.9, 0.0, -2.2), sizes=(0.9, 2.0, 0.65)),
        "brows": _lines("skin", ((-0.6, 2.3), (0.1, 2.5), (0.8, 2.2)), wide=0.2),
    },
    "bear": {**GLINTS, **MUZZLED, "ears": _spots("body", (1.4, 2.4, 2.5), sizes=(1.2, 1.6, 1.2))},
    "monkey": {
        **GLINTS,
        "nostrils": _spots("face", (-1.4, 0.0, -2.4), sizes=(0.35, 2.5, 0.3)),
        "mouth": _lines("face", ((0.6, -3.4), (-0.4, -4.1), (-2.0, -4.4), (-9.0, -4.4)), wide=0.24),
    },
    "pig": {
        **GLINTS,
        "ears": _spots("body", (1.4, 3.0, 3.4), sizes=(0.9, 1.5, 1.7)),
        "nostrils": Marking(
            "snout", partial(figures.dots, places=[(0.36, 0.0)], size=0.2, both=True)
        ),
    },
    "sheep": {**_pupils(0.5, 0.5, (0.2, -1.0, 0.0)), "curls": Marking("wool", creatures.curls)},
    "goat": {
        **GLINTS,
        "mouth": _lines("body", ((-9.0, -5.0), (-4.4, -5.0), (-3.4, -4.6)), side=True, wide=0.2),
    },
    "deer": {"spots": Marking("body", creatures.dapples)},
    "owl": {
        "feathers": Marking(
            "wings", partial(creatures.plumage, way=(0.0, 0.35, -1.0)), paired=True
        ),
        "bars": Marking("belly", creatures.chest),
    },
    "eagle": {**GLINTS, "feathers": _drawn("wings", *EAGLE_QUILLS)},
    "duck": _feathers() | GLINTS,
    "penguin": {**GLINTS},
    "parrot": _feathers(way=(0.0, 0.4, -1.0)) | GLINTS,
    "swan": _feathers() | GLINTS,
    "goose": _feathers() | GLINTS,
    "peacock": GLINTS,
    "snake": {
        "pupils": Marking("eyes", partial(outlines.laid, sides=SNAKE_PUPIL, aside=0.3), by="belly"),
        "grooves": _bars("belly", way=(0.0, 0.0, 1.0), pitch=0.08),
        "bands": Marking("body", creatures.coils),
    },
    "crocodile": {
        **_pupils(0.32, 0.74, (0.9, -0.6, 0.2)),
        "grooves": Marking("body", creatures.hide),
    },
    "lizard": {
        "spots": _blobs("body", 0.13, 0.026, 0.045, 0.9),
        "glints": Marking("pupils", creatures.glints, paired=True),
    },
    "dinosaur": {
        **GLINTS,
        "stripes": Marking("body", creatures.stripes),
        "nostrils": _spots("body", (-1.0, -5.0, 1.0), sizes=(0.5, 1.0, 0.4)),
    },
    "turtle": {
        **GLINTS,
        "mouth": _lines("body", ((-9.0, -2.4), (-0.6, -2.2), (0.8, -1.6)), side=True, wide=0.2),
        "spots": _blobs("body", 0.15, 0.02, 0.035, 0.7),
    },
    "frog": {
        "glints": Marking("pupils", creatures.glints, paired=True),
        "spots": _blobs("body", 0.2, 0.04, 0.065, 0.7),
        "nostrils": _spots("body", (-1.6, -0.8, -1.6), sizes=(0.28, 0.9, 0.22)),
    },
    "shark": {
        **GLINTS,
        "gills": _lines(
            "body",
            *(
                ((4.2 + 1.2 * k, 0.4), (4.6 + 1.2 * k, -1.0), (4.2 + 1.2 * k, -2.6))
                for k in range(3)
            ),
            side=True,
            wide=0.24,
        ),
    },
    "whale": {
        **GLINTS,
        "grooves": Marking("belly", partial(creatures.throat, count=9)),
    },
    "dolphin": {
        **GLINTS,
        "mouth": _lines(
            "body", ((-6.5, -6.2), (-3.4, -3.6), (-1.2, -2.7), (-0.4, -2.0)), side=True, wide=0.16
        ),
    },
    "octopus": {
        "mouth": _lines("body", ((-0.9, -1.2), (-1.3, -1.5), (-9.0, -1.6)), wide=0.17, until=1.5),
        "spots": _blobs("body", 0.22, 0.04, 0.07, 0.7),
    },
    "crab": {**GLINTS, "spots": _blobs("body", 0.2, 0.03, 0.05, 0.8)},
    "lobster": {**GLINTS, "bands": _bars("tail", way=(0.0, 1.0, 0.0), pitch=0.13, wide=0.016)},
    "spider": {**_pupils(0.4, 0.4), "cross": Marking("body", creatures.spider_mark)},
    "bee": {
        **_pupils(0.45, 0.55, (0.5, -0.9, 0.1)),
        "veins": _drawn("wings", *BEE_VEINS, axes=(0, 1)),
    },
    "ant": {**GLINTS, "bands": _bars("body", way=(0.0, 1.0, 0.0), pitch=0.11, span=(0.25, 9.0))},
    "squirrel": {**GLINTS, "ears": _spots("body", (0.0, 2.4, 3.7), sizes=(0.8, 1.3, 1.6))},
    "panda": _pupils() | MUZZLED,
    "gorilla": {
        **GLINTS,
        "mouth": _lines("face", ((0.4, -3.7), (-0.6, -3.3), (-9.0, -3.25)), wide=0.25),
    },
    "rhino": {
        **GLINTS,
        "nostrils": _spots("body", (-2.3, -6.9, -3.4), sizes=(0.5, 1.4, 0.5)),
        "mouth": _lines("body", ((-12.0, -5.4), (-5.4, -5.6), (-4.0, -5.0)), side=True, wide=0.22),
    },
    "camel": {
        **GLINTS,
        **MUZZLED,
        "nostrils": Marking(
            "muzzle", partial(figures.dots, places=[(0.4, 0.25)], size=0.14, both=True)
        ),
    },
    "donkey": {
        **GLINTS,
        "ears": _spots("body", (0.3, 1.8, 5.6), sizes=(0.9, 1.2, 2.6)),
    },
    "unicorn": {
        **GLINTS,
        "nostrils": _spots("body", (-1.9, -5.6, -4.5), sizes=(0.55, 1.2, 0.5)),
        "twist": Marking("horn", partial(creatures.twist, way=(0.0, -0.35, 1.0))),
    },
    "griffin": {**GLINTS, "quills": _drawn("wings", *GRIFFIN_QUILLS, axes=SIDE)},
    "phoenix": {**GLINTS, "feathers": _drawn("wings", *PHOENIX_QUILLS)},
    "snail": {**GLINTS, "whorl": Marking("shell", creatures.whorl)},
    "skull": {
        "teeth": Marking("bone", partial(outlines.laid, front=SKULL_TEETH, deep=0.5)),
        "cracks": Marking("bone", partial(outlines.laid, front=SKULL_CRACKS, deep=0.2)),
    },
    "bat": _pupils(0.3, 0.7),
    "mouse": {
        **GLINTS,
        "whiskers": _lines(
            "body",
            *(((-3.2, -4.1 + 0.5 * k), (-1.2, -4.2 + 1.1 * k)) for k in (-1, 0, 1)),
            side=True,
            wide=0.13,
        ),
    },
    "rocking horse": {
        **GLINTS,
        "mouth": _lines("body", ((-9.0, -4.8), (-4.6, -4.8), (-3.4, -4.3)), side=True, wide=0.2),
    },
    "rubber duck": {
        **_feathers(way=(0.0, 1.0, 0.4), short=(-0.4, 0.1), rows=1),
        "glints": Marking("pupils", partial(creatures.glints, way=(0.1, -0.95, 0.35)), paired=True),
    },
}
