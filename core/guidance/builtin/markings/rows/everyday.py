"""What has had its markings always: balls, flags, dials, boards, coats, labels."""

from functools import partial

from core.guidance.builtin.markings import (
    balls,
    boards,
    bodywork,
    coats,
    craft,
    figures,
    fittings,
    flags,
    fronts,
    outlines,
    prints,
)
from core.guidance.builtin.markings.margins import blobs
from core.guidance.builtin.markings.marking import Marking, Rows

ZONES = ((-58, -46), (-30, -12), (4, 9), (18, 34), (52, 61))  # a ringed planet's, degrees
STICKERS = ("reds", "blues", "greens", "whites", "yellows", "oranges")
EIGHT = (0.25, -1.0, 0.45)  # where a billiard ball's number is
HOLES = ((-0.1, -0.75, 0.75), (0.14, -0.75, 0.8), (0.03, -0.95, 0.5))  # a bowling ball's
BOARD_BANDS = ((0.26, 0.42), (0.45, 0.475), (-0.42, -0.26), (-0.475, -0.45))  # a surfboard's
SARCOPHAGUS_BANDS = ((-0.86, -0.68), (-0.5, -0.34), (-0.16, -0.02))
AWNING = tuple((k / 3 - 1.15, k / 3 - 0.98) for k in range(7))
JUG_BANDS = ((-0.5, -0.06), (-0.02, 0.01), (-0.57, -0.54))
GROOVES = tuple((0.4 + 0.065 * k, 0.43 + 0.065 * k) for k in range(9))  # a record's
SCRIPT = [0.52 - 0.115 * k for k in range(7)]  # of a scroll
YEARS = tuple((k / 6 - 0.018, k / 6 + 0.018) for k in range(1, 6))  # of a stump
BAUBLE_BAND = partial(fronts.belt, low=-0.17, high=0.17)
BAUBLE_EDGES = partial(fronts.belts, spans=((0.17, 0.23), (-0.23, -0.17)))
BAUBLE_STARS = partial(
    prints.scattered, shape="star", steep=1.3, places=[(45 * k, 0.6, 0.2) for k in range(8)]
)
BAUBLE_DOTS = partial(
    prints.scattered,
    shape="circle",
    steep=1.2,
    places=[(22.5 * k + 11, -0.38 - 0.24 * (k % 2), 0.075) for k in range(16)]
    + [(45 * k + 22.5, 0.45, 0.06) for k in range(8)],
)
STARS = [(0, 0.0, 0.16), (48, -0.3, 0.09), (-42, 0.22, 0.08), (95, 0.05, 0.13), (-85, -0.2, 0.13)]
STARS += [(145, -0.25, 0.1), (-150, 0.1, 0.11), (180, 0.45, 0.06), (25, 0.48, 0.055)]  # a wizard's

EVERYDAY: Rows = {
    "soccer ball": {
        "patches": Marking("ball", balls.pentagons),
        "seams": Marking("ball", balls.football_seams),
    },
    "beach ball": {
        name: Marking("body", partial(balls.gores, number=2 * k))
        for k, name in enumerate(("reds", "yellows", "blues"))
    },
    "tennis ball": {"seam": Marking("body", balls.tennis_seam)},
    "baseball": {"stitches": Marking("body", balls.stitches)},
    "volleyball": {
        "seams": Marking("body", balls.volleyball_seams),
        "bands": Marking("body", balls.volleyball_bands),
    },
    "golf ball": {"dimples": Marking("body", balls.dimples)},
    "bowling ball": {"holes": Marking("body", partial(balls.caps, wide=0.1, ways=HOLES))},
    "billiard ball": {
        "disc": Marking("body", partial(balls.cap, wide=0.46, way=EIGHT)),
        "number": Marking("disc", partial(balls.number_on, text="8", way=EIGHT, high=0.48)),
    },
    "disco ball": {"gaps": Marking("body", balls.mirror_gaps)},
    "earth": {"ice": Marking("body", balls.poles), "land": Marking("body", balls.lands)},
    "globe": {
        "ice": Marking("ocean", partial(balls.poles, lean=23)),
        "land": Marking("ocean", partial(balls.lands, lean=23)),
    },
    "planet": {"bands": Marking("globe", partial(balls.zones, lean=23, spans=ZONES))},
    "full moon": {"craters": Marking("body", balls.craters)},
    "eyeball": {
        "iris": Marking("white", partial(balls.cap, wide=0.56)),
        "pupil": Marking("iris", partial(balls.cap, wide=0.27)),
        "glint": Marking("pupil", partial(balls.cap, wide=0.09, way=(0.13, -1.0, 0.15))),
    },
    "easter egg": {
        "stripes": Marking("shell", balls.egg_bands),
        "dots": Marking("shell", balls.egg_dots),
    },
    "dice": {"pips": Marking("body", balls.pips)},
    "puzzle cube": {
        name: Marking("body", partial(balls.stickers, color=k)) for k, name in enumerate(STICKERS)
    },
    # A solid has seven parts at most that are drawn; these are the eighth.
    "boy": {
        "eyes": Marking("skin", partial(fronts.spots, at=(0.147, 0.3, 0.31), radius=0.075)),
        "stripe": Marking("shirt", partial(figures.hoop, at=-0.22, wide=0.26, within=0.72)),
    },
    "dwarf": {"eyes": Marking("skin", partial(fronts.spots, at=(0.12, 0.2, 0.24), radius=0.075))},
    "rooster": {"eyes": Marking("neck", partial(fronts.spots, at=(0.11, 0.2, 0.12), radius=0.06))},
    "turkey": {"eyes": Marking("head", partial(fronts.spots, at=(0.12, 0.12, 0.15), radius=0.06))},
    "garbage truck": {
        "windows": Marking("cab", partial(outlines.laid, **craft.GARBAGE_WINDOWS)),
        "lamps": Marking("cab", partial(fronts.spots, at=(0.18, 0.2, 0.37), radius=0.075)),
    },
    "ray gun": {
        "window": Marking("body", partial(balls.caps, wide=0.4, ways=((0, -1, 0.1), (0, 1, 0.1))))
    },
    "sarcophagus": {
        "bands": Marking("body", partial(fronts.belts, spans=SARCOPHAGUS_BANDS)),
    },
    "trailer": {"stripes": Marking("awning", partial(fronts.belts, spans=AWNING, axis=1))},
    "clock": {
        "face": Marking("body", partial(fronts.disc, radius=0.79)),
        "marks": Marking("face", partial(fronts.hours, radius=0.79)),
    },
    "alarm clock": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "grandfather clock": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "pocket watch": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "watch": {"marks": Marking("face", partial(fronts.hours, radius=1.0))},
    "dartboard": {
        "reds": Marking("board", fronts.dart_reds),
        "greens": Marking("board", fronts.dart_greens),
        "sectors": Marking("board", fronts.pale_sectors),
    },
    "target": {
        name: Marking("board", partial(fronts.disc, radius=radius))
        for name, radius in (("golds", 0.19), ("reds", 0.39), ("blues", 0.59), ("blacks", 0.79))
    },
    "chessboard": {"checks": Marking("squares", fronts.checks)},
    "lollipop": {"swirl": Marking("candy", fronts.spiral)},
    "stop sign": {"letters": Marking("plate", partial(fronts.lettered, text="STOP", high=0.4))},
    "basketball hoop": {
        "square": Marking("board", partial(fronts.frame, at=-0.1, size=(0.62, 0.45), wide=0.07))
    },
    "tennis racket": {"gaps": Marking("strings", prints.net_gaps)},
    "microphone": {"mesh": Marking("head", balls.mesh_gaps)},
    "radio": {
        "slots": Marking("speaker", prints.slots),
        "marks": Marking("dial", partial(outlines.laid, **fittings.DIAL_MARKS)),
    },
    "barrel": {"seams": Marking("body", boards.staves, "wooden")},
    "chest": {
        "keyhole": Marking("lock", partial(outlines.laid, **craft.KEYHOLE)),
        "rivets": Marking("bands", partial(outlines.laid, **craft.RIVETS)),
        "seams": Marking("body", partial(boards.planks, count=4), "wooden"),
    },
    "open chest": {
        "keyhole": Marking("lock", partial(outlines.laid, **craft.KEYHOLE)),
        "seams": Marking("body", partial(boards.planks, count=4), "wooden"),
    },
    "crate": {
        "nails": Marking("frame", partial(outlines.laid, **craft.CRATE_NAILS)),
        "seams": Marking("planks", partial(boards.planks, count=6), "wooden"),
    },
    "rowboat": {"seams": Marking("hull", partial(boards.planks, count=5), "wooden")},
    "pirate ship": {"seams": Marking("hull", partial(boards.planks, count=10), "wooden")},
    "basket": {"weave": Marking("body", boards.weave)},
    "hamburger": {"seeds": Marking("bun", coats.seeds)},
    "phone": {
        "icons": Marking("screen", prints.icons),
        "lenses": Marking("camera", partial(outlines.laid, **fittings.PHONE_LENSES)),
        "camera": Marking("body", partial(outlines.laid, **fittings.PHONE_CAMERA)),
    },
    "scroll": {"letters": Marking("paper", partial(prints.ruled, lines=SCRIPT, ends=(-0.52, 0.5)))},
    **{
        noun: {"frets": Marking("neck", boards.frets)}
        for noun in ("ukulele", "banjo", "electric guitar")
    },
    "guitar": {
        "frets": Marking("neck", boards.frets),
        "rosette": Marking("neck", craft.rosette),
        "pickguard": Marking("body", partial(outlines.laid, **craft.GUITAR_GUARD)),
    },
    "bunk bed": {"rungs": Marking("ladder", partial(boards.planks, count=6, wide=0.022))},
    "wagon": {"seams": Marking("body", partial(boards.planks, count=4), "wooden")},
    "stump": {"rings": Marking("wood", partial(fronts.rings, spans=YEARS, axis=2))},
    "broom": {"lines": Marking("bristles", partial(boards.staves, count=22, wide=0.006))},
    "hay bale": {"lines": Marking("straw", partial(boards.planks, count=18))},
    "mummy": {"folds": Marking("bandages", partial(boards.planks, count=17))},
    "cactus": {
        "spines": Marking("body", partial(blobs, pitch=0.09, sizes=(0.012, 0.015), share=0.95))
    },
    "sunflower": {"seeds": Marking("heart", partial(coats.seeds, count=60, up=1, size=0.045))},
    "feather": {"barbs": Marking("vane", partial(fronts.slanted, pitch=0.09))},
    "grand piano": {"black keys": Marking("keys", fronts.black_keys)},
    "jar": {"label": Marking("body", partial(fronts.belt, low=-0.55, high=0.3))},
    "necktie": {"stripes": Marking("blade", partial(fronts.slanted, pitch=0.3))},
    "poker chip": {"spots": Marking("rim", fronts.edge_spots)},
    "taxi": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.CAR_WINDOWS)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.TAXI_TRIM)),
        "letters": Marking("sign", partial(fronts.lettered, text="TAXI", high=0.5, bold=0.06)),
    },
    "atm": {
        "letters": Marking("panels", partial(fronts.lettered, text="ATM", high=0.5, bold=0.06))
    },
    "police car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.CAR_WINDOWS)),
        "letters": Marking(
            "doors", partial(fronts.on_sides, text="POLICE", high=0.12, at=(0.08, -0.12))
        ),
        "doors": Marking("body", fronts.doors),
    },
    "school bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.SCHOOL_BUS_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.BUS_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.SCHOOL_BUS_TRIM)),
        "letters": Marking(
            "body", partial(fronts.on_sides, text="SCHOOL BUS", high=0.1, at=(0, 0.78))
        ),
        "stripe": Marking("body", partial(fronts.belt, low=-0.32, high=-0.2)),
    },
    "ambulance": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.AMBULANCE_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.VAN_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.AMBULANCE_TRIM)),
        "cross": Marking("body", prints.kit_on_sides),
    },
    "fire truck": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.FIRE_WINDOWS)),
        "lockers": Marking("body", partial(outlines.laid, **bodywork.FIRE_LOCKERS)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.FIRE_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.6, high=-0.44)),
    },
    "double decker bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.DOUBLE_DECKER_WINDOWS)),
        "tail lamps": Marking("body", partial(outlines.laid, **bodywork.DOUBLE_DECKER_TAIL)),
        "trim": Marking("body", partial(outlines.laid, **bodywork.DOUBLE_DECKER_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=0.13, high=0.25)),
    },
    "first aid kit": {
        "cross": Marking("body", partial(prints.stamp, shape="cross", size=0.42, at=(0.0, -0.1)))
    },
    "popcorn": {
        "badge": Marking("box", partial(prints.badge, radius=0.42, shape="star")),
        "stripes": Marking("box", partial(prints.popcorn_stripes, clear=0.48)),
    },
    "rug": {
        "middle": Marking("border", prints.rug_middle),
        "lozenge": Marking("border", prints.rug_lozenge),
        "field": Marking("border", prints.rug_field),
    },
    "surfboard": {
        "stripe": Marking("board", partial(flags.bands, axis=0, low=-0.16, high=0.16)),
        "bands": Marking("board", partial(fronts.belts, spans=BOARD_BANDS)),
    },
    "compass": {"marks": Marking("dial", partial(prints.rose, radius=0.9))},
    "ruler": {"marks": Marking("body", prints.inches)},
    "plate": {"rim": Marking("body", fronts.plate_rings)},
    "jug": {
        "band": Marking("body", partial(fronts.belts, spans=JUG_BANDS)),
        "collar": Marking("body", partial(fronts.belts, spans=((0.44, 0.53), (0.57, 0.59)))),
    },
    "christmas bauble": {
        "band": Marking("ball", partial(balls.at_top, marks=BAUBLE_BAND)),
        "edges": Marking("ball", partial(balls.at_top, marks=BAUBLE_EDGES)),
        "stars": Marking("ball", partial(balls.at_top, marks=BAUBLE_STARS)),
        "dots": Marking("ball", partial(balls.at_top, marks=BAUBLE_DOTS)),
    },
    "kettlebell": {
        "badge": Marking(
            "body", partial(balls.at_top, marks=partial(prints.badge, radius=0.42, shape="star"))
        )
    },
    "paper cup": {"badge": Marking("sleeve", partial(prints.badge, radius=0.38, shape="leaf"))},
    "yo-yo": {
        "stars": Marking("faces", partial(flags.emblem, shape="star", size=0.54)),
        "faces": Marking("discs", partial(flags.emblem, shape="circle", size=0.74)),
    },
    "vinyl record": {
        "hole": Marking("label", partial(fronts.rings, spans=((-1, 0.045),))),
        "label": Marking("disc", partial(fronts.rings, spans=((-1, 0.33),))),
        "grooves": Marking("disc", partial(fronts.rings, spans=GROOVES)),
    },
    "obelisk": {"signs": Marking("body", prints.glyphs)},
    "clipboard": {
        "boxes": Marking("paper", prints.ticked),
        "lines": Marking("paper", prints.ruled),
    },
    "solar panel": {"cells": Marking("lines", prints.solar_cells)},
    "battery": {
        "plus": Marking("top", partial(prints.stamp, shape="cross", size=0.4, at=(0, 0.2))),
        "bolt": Marking("body", partial(prints.stamp, shape="lightning bolt", size=0.7)),
    },
    "sock": {
        "toe": Marking("body", fronts.sock_toe),
        "heel": Marking("body", fronts.sock_heel),
        "stripes": Marking("body", partial(fronts.belts, spans=((0.1, 0.26), (0.42, 0.58)))),
    },
    "cassette": {
        "reels": Marking("window", prints.reels),
        "window": Marking("label", partial(prints.oblong, at=0.1, size=(0.62, 0.24))),
        "stripe": Marking("label", partial(prints.oblong, at=0.6, size=(2.0, 0.07))),
        "label": Marking("body", partial(prints.oblong, at=0.2, size=(0.86, 0.6))),
    },
    **{
        noun: {"sun": Marking("picture", prints.sun), "hills": Marking("picture", prints.hills)}
        for noun in ("picture frame", "easel")
    },
    "wizard hat": {"stars": Marking("body", partial(prints.scattered, shape="star", places=STARS))},
    "parachute": {"gores": Marking("canopy", partial(balls.sectors, count=6))},
    "flask": {"marks": Marking("glass", prints.scale_marks)},
    "violin": {"holes": Marking("body", prints.f_holes)},
    "butterfly": {
        "dots": Marking("edges", coats.wing_dots),
        "wings": Marking("edges", coats.wing_cells),
    },
    "stingray": {
        "patches": Marking("body", partial(blobs, pitch=0.17, sizes=(0.025, 0.055), share=0.8))
    },
    "american flag": {
        "stars": Marking("canton", flags.stars),
        "canton": Marking("cloth", flags.canton),
        "stripes": Marking("cloth", flags.stripes),
    },
    "british flag": {
        "reds": Marking("cloth", partial(flags.crosses, upright=0.2, saltire=0.07)),
        "whites": Marking("cloth", partial(flags.crosses, upright=0.34, saltire=0.2)),
    },
    "french flag": {"blues": Marking("cloth", flags.LEFT), "reds": Marking("cloth", flags.RIGHT)},
    "italian flag": {"greens": Marking("cloth", flags.LEFT), "reds": Marking("cloth", flags.RIGHT)},
    "german flag": {"blacks": Marking("cloth", flags.TOP), "golds": Marking("cloth", flags.BOTTOM)},
    "japanese flag": {"disc": Marking("cloth", partial(flags.emblem, shape="circle", size=0.66))},
    "brazilian flag": {
        "disc": Marking("lozenge", partial(flags.emblem, shape="circle", size=0.45)),
        "lozenge": Marking("cloth", flags.lozenge),
    },
    "swedish flag": {"cross": Marking("cloth", partial(flags.nordic, wide=0.2))},
    "swiss flag": {"cross": Marking("cloth", partial(flags.emblem, shape="cross", size=0.6))},
    "canadian flag": {
        "leaf": Marking("cloth", partial(flags.emblem, shape="maple leaf", size=0.75)),
        "reds": Marking("cloth", flags.outer),
    },
    "irish flag": {
        "greens": Marking("cloth", flags.LEFT),
        "oranges": Marking("cloth", flags.RIGHT),
    },
    "belgian flag": {"blacks": Marking("cloth", flags.LEFT), "reds": Marking("cloth", flags.RIGHT)},
    "dutch flag": {"reds": Marking("cloth", flags.TOP), "blues": Marking("cloth", flags.BOTTOM)},
    "spanish flag": {"yellows": Marking("cloth", partial(flags.bands, axis=2, low=-0.5, high=0.5))},
    "indian flag": {
        "wheel": Marking("cloth", partial(flags.emblem, shape="ring", size=0.28)),
        "oranges": Marking("cloth", flags.TOP),
        "greens": Marking("cloth", flags.BOTTOM),
    },
    "chinese flag": {
        "star": Marking("cloth", partial(flags.emblem, shape="star", size=0.4, at=(-0.6, 0.4)))
    },
    "turkish flag": {
        "star": Marking("cloth", partial(flags.emblem, shape="star", size=0.22, at=(0.2, 0.0))),
        "moon": Marking("cloth", partial(flags.emblem, shape="moon", size=0.5, at=(-0.25, 0.0))),
    },
    "danish flag": {"cross": Marking("cloth", partial(flags.nordic, wide=0.2))},
    "finnish flag": {"cross": Marking("cloth", partial(flags.nordic, wide=0.26))},
    "ukrainian flag": {"yellows": Marking("cloth", flags.LOWER)},
    "polish flag": {"reds": Marking("cloth", flags.LOWER)},
    "pirate flag": {
        "skull": Marking("cloth", partial(flags.emblem, shape="skull and crossbones", size=0.85))
    },
    "speed limit sign": {
        "number": Marking("plate", partial(fronts.lettered, text="50", high=0.66, bold=0.04)),
        "ring": Marking("plate", partial(fronts.rim, low=0.72, high=0.94)),
    },
    "no entry sign": {"bar": Marking("plate", partial(fronts.bar, size=(0.66, 0.17)))},
    "strawberry": {"seeds": Marking("body", coats.strawberry_seeds)},
    "watermelon": {"stripes": Marking("rind", coats.melon)},
    "ladybug": {"patches": Marking("shell", coats.wing_cases)},
    "zebra": {"stripes": Marking("body", partial(coats.hoops, pitch=0.2))},
    "tiger": {"stripes": Marking("body", partial(coats.flames, pitch=0.2))},
    "giraffe": {"patches": Marking("body", partial(coats.patches, pitch=0.26, line=0.05))},
    "cow": {
        "patches": Marking("body", partial(blobs, pitch=0.42, sizes=(0.1, 0.24), share=0.55)),
        "nostrils": Marking(
            "muzzle", partial(figures.dots, places=[(0.4, 0.05)], size=0.12, both=True)
        ),
    },
    "leopard": {
        "spots": Marking("body", partial(blobs, pitch=0.15, sizes=(0.03, 0.055), share=0.9))
    },
    "clownfish": {
        "bands": Marking("body", partial(coats.fish_bands, wide=0.08)),
        "edges": Marking("body", partial(coats.fish_bands, wide=0.115)),
    },
    "koi": {"patches": Marking("body", partial(blobs, pitch=0.36, sizes=(0.1, 0.22), share=0.75))},
    "dalmatian": {
        "spots": Marking("body", partial(blobs, pitch=0.2, sizes=(0.025, 0.075), share=0.85))
    },
    "skunk": {"stripe": Marking("body", partial(coats.ridge, wide=0.2))},
}
