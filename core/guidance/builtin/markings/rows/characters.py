"""Markings of characters (eyes, mouths, what is sewn on clothes), of statues, and of an eyeball."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    balls,
    bands,
    faces,
    lettering,
    planks,
    scales,
    seams,
    spots,
    studs,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.outlines import Disc, Emblem, Poly
from core.guidance.builtin.markings.rows.creature_parts import (
    GLINTS,
    bars,
    eyes,
    face_lines,
    face_spots,
    mottled,
    mouth,
    pupils,
    wing_lines,
)

DEMON_BONES = (
    ((-0.95, 0.0), (-0.2, 0.4), (0.5, 0.95)),
    *(((0.5, 0.95), end) for end in ((0.98, 0.0), (0.58, -0.58), (0.0, -0.95))),
)
GRIFFIN_QUILLS = (
    ((-1.0, -0.4), (-0.55, 0.2), (-0.1, 0.5), (0.5, 0.64)),
    ((-0.2, 0.44), (0.4, 0.3)),
    ((-0.5, 0.24), (-0.04, -0.27)),
    ((0.3, 0.6), (0.9, 0.42)),
)
QUARTERS = tuple(
    Poly(((0, 0), (0.85 * k, 0), (0.85 * k, 0.85 * k), (0, 0.85 * k))) for k in (1, -1)
)
ROBE_STARS = [(-28, 0.12, 0.11), (30, -0.28, 0.13), (-12, -0.66, 0.1), (85, -0.55, 0.12)]
ROBE_STARS += [(-80, -0.4, 0.13), (150, -0.1, 0.12), (-140, -0.6, 0.13), (180, 0.3, 0.09)]
COAT_BUTTONS = [(side * 0.13, up) for side in (-1, 1) for up in (0.44, 0.2, -0.6)]
PANEL_BUTTONS = [(-0.45, 0.25), (0.0, 0.25), (0.45, 0.25)]
EARED = faces.Face(axis=2)
GIRL = faces.Face(radius=0.33)
MOUSTACHE = Poly(((0.0, -0.1), (0.3, -0.08), (0.66, 0.08), (0.56, -0.18), (0.24, -0.34),
                  (0.0, -0.26)), twice=True)  # fmt: skip
CHARACTERS: Rows = {
    "girl": mouth(-0.42, face=GIRL),
    # A solid has at most seven drawn parts; this is the eighth.
    "boy": {
        "eyes": Marking("skin", partial(faces.round_eyes, at=(0.147, 0.3, 0.31), radius=0.075)),
        "stripe": Marking("shirt", partial(bands.hoop, at=-0.22, wide=0.26, within=0.72)),
    },
    "baby": {
        **GLINTS,
        "cheeks": face_spots("skin", (0.9, 0.0, -2.2), sizes=(0.9, 2.0, 0.65)),
        "brows": face_lines("skin", ((-0.6, 2.3), (0.1, 2.5), (0.8, 2.2)), wide=0.2),
    },
    "doll": {
        "mouth": Marking("skin", partial(faces.smile, at=-0.5, wide=0.17)),
        "cheeks": Marking("skin", partial(faces.ovals, at=(0.55, -0.3), size=(0.18, 0.14))),
    },
    "king": eyes((0.42, 0.2), (0.17, 0.24))
    | {
        "spots": Marking(
            "fur", partial(spots.blobs, pitch=0.12, sizes=(0.024, 0.034), fraction=0.8)
        )
    },
    **{
        noun: eyes((0.41, 0.04), (0.175, 0.245)) | mouth()
        for noun in ("princess", "queen", "fairy", "angel")
    },
    "viking": {
        "quarters": Marking(
            "tunic", partial(outlines.laid, front=QUARTERS, deep=-4.0), by="helmet"
        ),
    },
    "samurai": {"laces": bars("armour", pitch=0.09, wide=0.013)},
    "ninja": eyes((0.5, 0.64), (0.2, 0.22))
    | {"folds": Marking("suit", partial(seams.wrapped, at=(-0.1, 0.22), wide=0.36))},
    "cowboy": {
        "mouth": Marking("skin", partial(faces.smile, at=-0.36, wide=0.2)),
        "star": Marking(
            "vest", partial(outlines.laid, front=(Emblem((0.6, 0.3), 0.24, "star"),), deep=0.1)
        ),
    },
    "pirate": {
        "skull": Marking(
            "hat", partial(badges.stamp, shape="skull and crossbones", size=0.3, at=(0.0, 0.32))
        ),
        "buttons": Marking("coat", partial(studs.dots, places=COAT_BUTTONS, size=0.055)),
    },
    "soldier": {
        **mouth(),
        "patches": Marking(
            "uniform", partial(spots.blobs, pitch=0.2, sizes=(0.05, 0.11), fraction=0.65)
        ),
    },
    "police officer": {
        **mouth(),
        "pockets": Marking("uniform", partial(seams.pockets, at=(0.3, 0.34), size=(0.14, 0.11))),
    },
    "chef": {
        "pocket": Marking(
            "apron", partial(seams.pockets, at=(0.0, -0.42), size=(0.5, 0.26), both=False)
        ),
        "pleats": Marking("hat", partial(planks.staves, count=16, wide=0.012)),
    },
    "nutcracker": {
        "eyes": Marking(
            "skin", partial(outlines.laid, front=(Disc((0.4, 0.34), 0.16, twice=True),))
        ),
        "moustache": Marking("skin", partial(outlines.laid, front=(MOUSTACHE,))),
    },
    "clown": {
        "mouth": Marking("skin", partial(faces.smile, at=-0.5, wide=0.56, deep=0.5, line=0.09)),
        "dots": Marking("suit", partial(spots.blobs, pitch=0.2, sizes=(0.055, 0.07), fraction=0.9)),
    },
    "astronaut": {
        "glare": Marking(
            "visor", partial(faces.ovals, at=(-0.42, 0.3), size=(0.13, 0.26), both=False)
        ),
        "buttons": Marking("panel", partial(studs.dots, places=PANEL_BUTTONS, size=0.16)),
    },
    "superhero": {
        "mouth": face_lines("skin", ((-0.55, -2.2), (-1.0, -2.5), (-1.5, -2.55), (-9.0, -2.55))),
        "star": Marking(
            "trim", partial(outlines.laid, front=(Emblem((0, 0.55), 0.15, "star"),)), by="suit"
        ),
    },
    "wizard": eyes((0.44, 0.16), (0.18, 0.26))
    | {
        "stars": Marking(
            "robe", partial(badges.scattered, shape="star", places=ROBE_STARS, steep=1.05)
        )
    },
    "witch": eyes((0.44, 0.26), (0.2, 0.22)) | mouth(-0.5, 0.34),
    "elf": eyes((0.41, 0.08), (0.175, 0.245), EARED) | mouth(-0.4, 0.18, EARED),
    # A solid has at most seven drawn parts; this is the eighth.
    "dwarf": {
        "eyes": Marking("skin", partial(faces.round_eyes, at=(0.12, 0.2, 0.24), radius=0.075))
    },
    "mermaid": {
        "scales": Marking("tail", scales.tail_scales),
        "mouth": face_lines(
            "skin", ((-0.9, -2.7), (-1.5, -3.2), (-2.2, -3.3), (-9.0, -3.3)), wide=0.25
        ),
    },
    "santa claus": eyes((0.43, 0.1), (0.2, 0.24))
    | {
        "buckle": Marking(
            "boots", partial(seams.buckle, below=0.125, wide=0.115, hole=(0.065, 0.032))
        ),
    },
    "troll": pupils(0.42, 0.42),
    "griffin": {**GLINTS, "quills": wing_lines("wings", *GRIFFIN_QUILLS, axes=faces.SIDE)},
    "demon": {
        **pupils(0.3, 0.75),
        "ribs": wing_lines("wings", *DEMON_BONES, wide=0.024),
    },
    "vampire": {
        **pupils(0.4, 0.4),
        "buttons": Marking(
            "vest", partial(studs.dots, places=[(0.0, 0.5), (0.0, 0.2), (0.0, -0.1)], size=0.1)
        ),
    },
    "zombie": {
        **pupils(0.4, 0.4),
        "stitches": face_lines(
            "skin",
            ((0.1, -1.65), (1.4, -1.25)),
            *(
                ((0.3 + 0.5 * k, -1.25 + 0.15 * k), (0.4 + 0.5 * k, -1.95 + 0.15 * k))
                for k in range(3)
            ),
            wide=0.12,
        ),
    },
    "mummy": {"folds": Marking("bandages", partial(planks.planks, count=17))},
    "skeleton": {
        "teeth": face_lines(
            "bone",
            ((-9.0, -3.3), (0.2, -3.3)),
            *(((x, -2.8), (x, -3.8)) for x in (-1.7, -1.05, -0.4)),
            wide=0.13,
            until=2.0,
        ),
    },
    "monster": {"spots": mottled("fur", 0.26, 0.05, 0.08, 0.75)},
    "obelisk": {"signs": Marking("body", lettering.glyphs)},
    "eyeball": {
        "iris": Marking("white", partial(balls.cap, wide=0.56)),
        "pupil": Marking("iris", partial(balls.cap, wide=0.27)),
        "glint": Marking("pupil", partial(balls.cap, wide=0.09, way=(0.13, -1.0, 0.15))),
    },
}
