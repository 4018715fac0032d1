"""Markings of animals, and of the figures of their group."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import (
    badges,
    bands,
    faces,
    lines,
    rings,
    scales,
    spots,
    stripes,
    studs,
    wings,
)
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.outlines import Plate
from core.guidance.builtin.markings.rows.creature_parts import (
    GLINTS,
    MUZZLED,
    PAWS,
    SOCKS,
    bars,
    face_lines,
    face_spots,
    feathers,
    joined,
    mottled,
    mouth,
    pupils,
    wing_lines,
)
from core.guidance.builtin.markings.rows.outlines import animals as own

SNAKE_PUPIL = (Plate((-1.14, 1.09), (0.12, 0.18), 1.0),)  # their middle is not the body's
BEE_VEINS = tuple(((-0.9, 0.0), end) for end in ((0.8, 0.1), (0.4, -0.7), (0.2, 0.6)))
DRAGON_BONES = (
    ((-1.0, -0.4), (-0.42, 0.93), (0.36, 0.97), (1.0, 0.06)),
    *(((-0.42, 0.93), end) for end in ((0.32, -0.58), (-0.44, -1.0))),
)
EAGLE_QUILLS = (
    ((-1.0, -0.2), (-0.5, -0.02), (0.0, 0.28), (0.5, 0.62), (0.95, 0.8)),
    *((root, end) for root, end in (((0.3, 0.48), (0.6, -0.14)), ((-0.1, 0.22), (0.1, -0.57)))),
    *((root, end) for root, end in (((-0.5, -0.02), (-0.42, -0.72)), ((0.62, 0.7), (0.9, 0.2)))),
)
PHOENIX_QUILLS = (
    ((-1.0, -0.1), (-0.4, 0.1), (0.1, 0.5), (0.4, 0.95)),
    ((-0.4, 0.1), (-0.1, -0.7)),
    ((-0.1, 0.34), (0.4, -0.4)),
    ((0.2, 0.62), (0.9, 0.1)),
)
BREATHS = [(0.1 + 0.07 * k, up) for k in range(2) for up in (0.44, 0.4)]
WHISKERS = [(0.5, 0.2), (0.66, -0.2), (0.42, -0.35)]
NAILS = [(0.36, -0.92), (0.56, -0.95), (0.76, -0.92)]
SNOWMAN = faces.Face(fraction=0.535)
ANIMALS: Rows = {
    **dict.fromkeys(("dog", "fox", "lion"), PAWS | MUZZLED),
    **dict.fromkeys(("corgi", "pug"), PAWS),
    "raccoon": PAWS | GLINTS,
    **dict.fromkeys(("bull", "pegasus"), SOCKS),
    "cat": {
        **PAWS,
        "whiskers": Marking("muzzle", partial(studs.dots, places=WHISKERS, size=0.075, both=True)),
    },
    "rabbit": {
        **PAWS,
        "ears": Marking("body", partial(spots.ovals, at=(0.35, 0.62), size=(0.1, 0.24))),
        "belly": Marking(
            "body", partial(spots.ovals, at=(0.0, -0.42), size=(0.46, 0.3), both=False)
        ),
    },
    "mouse": {
        **GLINTS,
        "whiskers": face_lines(
            "body",
            *(((-3.2, -4.1 + 0.5 * k), (-1.2, -4.2 + 1.1 * k)) for k in (-1, 0, 1)),
            side=True,
            wide=0.13,
        ),
    },
    "horse": {
        **SOCKS,
        **GLINTS,
        "mouth": joined(
            face_lines("body", ((-13.0, -11.3), (-7.0, -10.9), (-4.8, -10.2)), side=True, wide=0.3),
            face_spots("body", (-2.1, -8.8, -9.0), sizes=(0.6, 1.2, 0.8)),
        ),
        "blaze": face_spots("body", (-3.4, -3.2, -0.2), (-3.4, -4.8, -3.2), sizes=(1.1, 1.8, 2.4)),
    },
    "donkey": {
        **GLINTS,
        "ears": face_spots("body", (-0.9, 3.4, 11.8), sizes=(0.8, 1.0, 3.4)),
    },
    "cow": {
        **SOCKS,
        "patches": Marking(
            "body", partial(spots.blobs, pitch=0.42, sizes=(0.1, 0.24), fraction=0.55)
        ),
        "nostrils": Marking(
            "muzzle", partial(studs.dots, places=[(0.4, 0.05)], size=0.12, both=True)
        ),
    },
    "sheep": {**pupils(0.5, 0.5, (0.2, -1.0, 0.0)), "curls": Marking("wool", scales.curls)},
    "pig": {
        **GLINTS,
        "ears": face_spots("body", (1.4, 3.0, 3.4), sizes=(0.9, 1.5, 1.7)),
        "nostrils": Marking(
            "snout", partial(studs.dots, places=[(0.36, 0.0)], size=0.2, both=True)
        ),
    },
    "chicken": feathers(),
    # A solid has at most seven drawn parts; this is the eighth.
    "rooster": {
        "eyes": Marking("neck", partial(faces.round_eyes, at=(0.11, 0.2, 0.12), radius=0.06))
    },
    "duck": feathers() | GLINTS,
    "goose": feathers() | GLINTS,
    # A solid has at most seven drawn parts; this is the eighth.
    "turkey": {
        "eyes": Marking("head", partial(faces.round_eyes, at=(0.12, 0.12, 0.15), radius=0.06))
    },
    "wolf": {
        **GLINTS,
        **MUZZLED,
        "ears": face_spots("body", (0.4, 7.0, 6.6), sizes=(0.8, 1.6, 2.0)),
    },
    "bear": {
        **PAWS,
        **GLINTS,
        **MUZZLED,
        "ears": face_spots("body", (1.2, 6.2, 5.9), sizes=(1.0, 1.4, 1.0)),
    },
    "deer": {"spots": Marking("body", spots.dapples)},
    "elephant": {
        "nails": Marking("body", partial(studs.dots, places=NAILS, size=0.085, both=True))
    },
    "giraffe": {"patches": Marking("body", partial(spots.cells, pitch=0.17, line=0.034))},
    "monkey": {
        **GLINTS,
        "nostrils": face_spots("face", (-1.4, 0.0, -2.4), sizes=(0.35, 2.5, 0.3)),
        "mouth": face_lines(
            "face", ((0.6, -3.4), (-0.4, -4.1), (-2.0, -4.4), (-9.0, -4.4)), wide=0.24
        ),
    },
    "bird": feathers() | GLINTS,
    "owl": {
        "feathers": Marking("wings", partial(scales.plumage, way=(0.0, 0.35, -1.0)), paired=True),
        "bars": Marking("belly", scales.chest_marks),
    },
    "penguin": {**GLINTS},
    "whale": {
        **GLINTS,
        "grooves": Marking("belly", partial(lines.throat, count=9)),
    },
    "dolphin": {
        **GLINTS,
        "mouth": face_lines(
            "body", ((-6.5, -6.2), (-3.4, -3.6), (-1.2, -2.7), (-0.4, -2.0)), side=True, wide=0.16
        ),
    },
    "shark": {
        **GLINTS,
        "gills": face_lines(
            "body",
            *(
                ((4.2 + 1.2 * k, 0.4), (4.6 + 1.2 * k, -1.0), (4.2 + 1.2 * k, -2.6))
                for k in range(3)
            ),
            side=True,
            wide=0.24,
        ),
    },
    "fish": {"scales": Marking("body", scales.fish_scales)},
    "octopus": {
        "mouth": face_lines(
            "body", ((-0.9, -1.2), (-1.3, -1.5), (-9.0, -1.6)), wide=0.17, until=1.5
        ),
        "spots": mottled("body", 0.22, 0.04, 0.07, 0.7),
    },
    "crab": {**GLINTS, "spots": mottled("body", 0.2, 0.03, 0.05, 0.8)},
    "turtle": {
        **GLINTS,
        "mouth": face_lines("body", ((-9.0, -2.4), (-0.6, -2.2), (0.8, -1.6)), side=True, wide=0.2),
        "spots": mottled("body", 0.15, 0.02, 0.035, 0.7),
    },
    "frog": {
        "glints": Marking("pupils", faces.eye_glints, paired=True),
        "spots": mottled("body", 0.2, 0.04, 0.065, 0.7),
        "nostrils": face_spots("body", (-1.6, -0.8, -1.6), sizes=(0.28, 0.9, 0.22)),
    },
    "snake": {
        "pupils": Marking("eyes", partial(outlines.laid, sides=SNAKE_PUPIL, aside=0.3), by="belly"),
        "grooves": bars("belly", way=(0.0, 0.0, 1.0), pitch=0.08),
        "bands": Marking("body", stripes.snake_bands),
    },
    "snail": {**GLINTS, "whorl": Marking("shell", rings.whorl)},
    "spider": {**pupils(0.4, 0.4), "cross": Marking("body", badges.spider_mark)},
    "bee": {
        **pupils(0.45, 0.55, (0.5, -0.9, 0.1)),
        "veins": wing_lines("wings", *BEE_VEINS, axes=(0, 1)),
    },
    "butterfly": {
        "dots": Marking("edges", wings.wing_dots, paired=True),
        "wings": Marking("edges", wings.wing_cells, paired=True),
    },
    "person": mouth(-0.7, 0.22),
    "knight": {
        "belt": Marking("armour", partial(bands.hoop, at=-0.2, wide=0.035, within=0.42)),
        "breaths": Marking("armour", partial(studs.dots, places=BREATHS, size=0.02, both=True)),
    },
    "teddy bear": {
        "mouth": Marking("muzzle", partial(outlines.laid, **own.TEDDY_MOUTH), by="body"),
        "paws": Marking("muzzle", partial(outlines.laid, **own.TEDDY_PAWS), by="body"),
        "stitches": Marking("muzzle", partial(outlines.laid, **own.TEDDY_STITCHES), by="body"),
        "inner ears": Marking("body", partial(outlines.laid, **own.TEDDY_EARS)),
    },
    "snowman": {
        "cheeks": Marking(
            "body", partial(faces.ovals, at=(0.6, -0.08), size=(0.17, 0.13), face=SNOWMAN)
        ),
        "ribbon": Marking("hat", partial(bands.hoop, at=-0.45, wide=0.2, within=0.72)),
    },
    "ghost": {**GLINTS, "cheeks": face_spots("body", (0.9, 0.0, -1.7), sizes=(0.55, 2.5, 0.38))},
    "alien": GLINTS,
    "unicorn": {
        **GLINTS,
        "nostrils": face_spots("body", (-2.1, -8.8, -9.0), sizes=(0.6, 1.2, 0.8)),
        "twist": Marking("horn", partial(scales.twist, way=(0.0, -0.35, 1.0))),
    },
    "dragon": {
        "ribs": wing_lines("wings", *DRAGON_BONES, wide=0.024),
        "grooves": bars("belly", way=(0.0, -1.0, 1.0), pitch=0.085),
    },
    "dinosaur": {
        **GLINTS,
        "stripes": Marking("body", stripes.back_stripes),
        "nostrils": face_spots("body", (-1.0, -5.0, 1.0), sizes=(0.5, 1.0, 0.4)),
    },
    "clownfish": {
        "bands": Marking("body", partial(stripes.fish_bands, wide=0.08)),
        "edges": Marking("body", partial(stripes.fish_bands, wide=0.115)),
    },
    "koi": {
        "patches": Marking(
            "body", partial(spots.blobs, pitch=0.36, sizes=(0.1, 0.22), fraction=0.75)
        )
    },
    "stingray": {
        "patches": Marking(
            "body", partial(spots.blobs, pitch=0.17, sizes=(0.025, 0.055), fraction=0.8)
        )
    },
    "lobster": {**GLINTS, "bands": bars("tail", way=(0.0, 1.0, 0.0), pitch=0.13, wide=0.016)},
    "tiger": PAWS | {"stripes": Marking("body", partial(stripes.tiger_stripes, pitch=0.13))},
    "leopard": {
        **PAWS,
        "spots": Marking(
            "body", partial(spots.blobs, pitch=0.1, sizes=(0.018, 0.034), fraction=0.95)
        ),
    },
    "zebra": SOCKS | {"stripes": Marking("body", partial(stripes.zebra_stripes, pitch=0.14))},
    "rhino": {
        **GLINTS,
        "nostrils": face_spots("body", (-1.5, -12.0, -8.5), sizes=(0.7, 1.4, 0.6)),
        "mouth": face_lines(
            "body", ((-15.0, -12.7), (-9.0, -12.4), (-7.0, -11.6)), side=True, wide=0.3
        ),
    },
    "camel": {
        **GLINTS,
        **MUZZLED,
        "nostrils": Marking(
            "muzzle", partial(studs.dots, places=[(0.4, 0.25)], size=0.14, both=True)
        ),
    },
    "goat": {
        **GLINTS,
        "mouth": face_lines(
            "body", ((-10.0, -7.8), (-6.0, -7.6), (-4.8, -6.8)), side=True, wide=0.22
        ),
    },
    "panda": pupils() | MUZZLED,
    "gorilla": {
        **GLINTS,
        "mouth": face_lines("face", ((0.4, -3.7), (-0.6, -3.3), (-9.0, -3.25)), wide=0.25),
    },
    "dalmatian": {
        **PAWS,
        "spots": Marking(
            "body", partial(spots.blobs, pitch=0.15, sizes=(0.018, 0.05), fraction=0.85)
        ),
    },
    "skunk": PAWS | {"stripe": Marking("body", partial(bands.ridge, wide=0.2))},
    "squirrel": {**GLINTS, "ears": face_spots("body", (0.0, 2.4, 3.7), sizes=(0.8, 1.3, 1.6))},
    "bat": pupils(0.3, 0.7),
    "swan": feathers() | GLINTS,
    "peacock": GLINTS,
    "parrot": feathers(way=(0.0, 0.4, -1.0)) | GLINTS,
    "eagle": {**GLINTS, "feathers": wing_lines("wings", *EAGLE_QUILLS)},
    "crocodile": {
        **pupils(0.32, 0.74, (0.9, -0.6, 0.2)),
        "grooves": Marking("body", scales.hide),
    },
    "lizard": {
        "spots": mottled("body", 0.13, 0.026, 0.045, 0.9),
        "glints": Marking("pupils", faces.eye_glints, paired=True),
    },
    "ant": {**GLINTS, "bands": bars("body", way=(0.0, 1.0, 0.0), pitch=0.11, span=(0.25, 9.0))},
    "ladybug": {"patches": Marking("shell", wings.wing_cases)},
    "phoenix": {**GLINTS, "feathers": wing_lines("wings", *PHOENIX_QUILLS)},
}
