"""People, animals and what they wear."""

from functools import partial

from core.guidance.builtin.markings import (
    boards,
    figures,
    prints,
)
from core.guidance.builtin.markings.margins import blobs
from core.guidance.builtin.markings.marking import Marking, Rows

ROBE_STARS = [(-28, 0.12, 0.11), (30, -0.28, 0.13), (-12, -0.66, 0.1), (85, -0.55, 0.12)]
ROBE_STARS += [(-80, -0.4, 0.13), (150, -0.1, 0.12), (-140, -0.6, 0.13), (180, 0.3, 0.09)]
COAT_BUTTONS = [(side * 0.13, up) for side in (-1, 1) for up in (0.44, 0.2, -0.6)]
PANEL_BUTTONS = [(-0.45, 0.25), (0.0, 0.25), (0.45, 0.25)]
BREATHS = [(0.1 + 0.07 * k, up) for k in range(2) for up in (0.44, 0.4)]
WHISKERS = [(0.5, 0.2), (0.66, -0.2), (0.42, -0.35)]
MUZZLED = Marking("muzzle", figures.muzzle_mouth)
NAILS = [(0.36, -0.92), (0.56, -0.95), (0.76, -0.92)]
EARED = figures.Face(axis=2)
GIRL = figures.Face(radius=0.33)
SNOWMAN = figures.Face(share=0.535)


def _eyes(
    at: figures.At, size: figures.At, face: figures.Face = figures.HEAD
) -> dict[str, Marking]:
    """A pair that has a light in it, on a round head; in head radii."""
    return {
        "glints": Marking("eyes", partial(figures.glints, at=at, size=size, face=face)),
        "eyes": Marking("skin", partial(figures.ovals, at=at, size=size, face=face)),
    }


def _mouth(
    at: float = -0.46, wide: float = 0.2, face: figures.Face = figures.HEAD
) -> dict[str, Marking]:
    """A small smile on a round head."""
    return {"mouth": Marking("skin", partial(figures.smile, at=at, wide=wide, face=face))}


LIVING: Rows = {
    # People: eyes with a light in them, mouths, what is sewn on their clothes.
    **{
        noun: _eyes((0.41, 0.04), (0.175, 0.245)) | _mouth()
        for noun in ("princess", "queen", "fairy", "angel")
    },
    "elf": _eyes((0.41, 0.08), (0.175, 0.245), EARED) | _mouth(-0.4, 0.18, EARED),
    "girl": _mouth(-0.42, face=GIRL),
    "person": _mouth(-0.7, 0.22),
    "king": _eyes((0.42, 0.2), (0.17, 0.24))
    | {"spots": Marking("fur", partial(blobs, pitch=0.12, sizes=(0.024, 0.034), share=0.8))},
    "wizard": _eyes((0.44, 0.16), (0.18, 0.26))
    | {
        "stars": Marking(
            "robe", partial(prints.scattered, shape="star", places=ROBE_STARS, steep=1.05)
        )
    },
    "witch": _eyes((0.44, 0.26), (0.2, 0.22)) | _mouth(-0.5, 0.34),
    "ninja": _eyes((0.5, 0.64), (0.2, 0.22))
    | {"folds": Marking("suit", partial(figures.wrapped, at=(-0.1, 0.22), wide=0.36))},
    "police officer": {
        **_mouth(),
        "pockets": Marking("uniform", partial(figures.pockets, at=(0.3, 0.34), size=(0.14, 0.11))),
    },
    "soldier": {
        **_mouth(),
        "patches": Marking("uniform", partial(blobs, pitch=0.2, sizes=(0.05, 0.11), share=0.65)),
    },
    "pirate": {
        "skull": Marking(
            "hat", partial(prints.stamp, shape="skull and crossbones", size=0.3, at=(0.0, 0.32))
        ),
        "buttons": Marking("coat", partial(figures.dots, places=COAT_BUTTONS, size=0.055)),
    },
    "astronaut": {
        "glare": Marking(
            "visor", partial(figures.ovals, at=(-0.42, 0.3), size=(0.13, 0.26), both=False)
        ),
        "buttons": Marking("panel", partial(figures.dots, places=PANEL_BUTTONS, size=0.16)),
    },
    "doll": {
        "mouth": Marking("skin", partial(figures.smile, at=-0.5, wide=0.17)),
        "cheeks": Marking("skin", partial(figures.ovals, at=(0.55, -0.3), size=(0.18, 0.14))),
    },
    "chef": {
        "pocket": Marking(
            "apron", partial(figures.pockets, at=(0.0, -0.42), size=(0.5, 0.26), both=False)
        ),
        "pleats": Marking("hat", partial(boards.staves, count=16, wide=0.012)),
    },
    "clown": {
        "mouth": Marking("skin", partial(figures.smile, at=-0.5, wide=0.56, deep=0.5, line=0.09)),
        "dots": Marking("suit", partial(blobs, pitch=0.2, sizes=(0.055, 0.07), share=0.9)),
    },
    "santa claus": _eyes((0.43, 0.1), (0.2, 0.24))
    | {
        "buckle": Marking(
            "boots", partial(figures.buckle, below=0.125, wide=0.115, hole=(0.065, 0.032))
        ),
    },
    "snowman": {
        "cheeks": Marking(
            "body", partial(figures.ovals, at=(0.6, -0.08), size=(0.17, 0.13), face=SNOWMAN)
        ),
        "ribbon": Marking("hat", partial(figures.hoop, at=-0.45, wide=0.2, within=0.72)),
    },
    "knight": {
        "belt": Marking("armour", partial(figures.hoop, at=-0.2, wide=0.035, within=0.42)),
        "breaths": Marking("armour", partial(figures.dots, places=BREATHS, size=0.02, both=True)),
    },
    # Animals.
    **{noun: {"mouth": MUZZLED} for noun in ("dog", "fox", "lion")},
    "cat": {
        "whiskers": Marking("muzzle", partial(figures.dots, places=WHISKERS, size=0.075, both=True))
    },
    "rabbit": {
        "ears": Marking("body", partial(figures.patches, at=(0.35, 0.62), size=(0.1, 0.24))),
        "belly": Marking(
            "body", partial(figures.patches, at=(0.0, -0.42), size=(0.46, 0.3), both=False)
        ),
    },
    "fish": {"scales": Marking("body", figures.scales)},
    # Clothes.
    "shirt": {
        "seams": Marking("body", figures.shirt_seams),
        "pocket": Marking(
            "body", partial(figures.pockets, at=(0.36, 0.16), size=(0.15, 0.17), both=False)
        ),
    },
    "dress": {"pleats": Marking("skirt", figures.folds)},
    "trousers": {"seams": Marking("body", figures.trouser_seams)},
    "baseball cap": {
        "star": Marking("badge", partial(prints.stamp, shape="star", size=0.6, at=(0.0, 0.06))),
        "seams": Marking("cap", figures.panels),
    },
    "sneaker": {"lines": Marking("sole", partial(figures.hoop, at=0.2, wide=0.16))},
    "boot": {"stitches": Marking("sole", partial(figures.dashed, at=0.5, wide=0.09))},
    "jacket": {"seams": Marking("body", figures.jacket_seams)},
    "elephant": {
        "nails": Marking("body", partial(figures.dots, places=NAILS, size=0.085, both=True))
    },
}
