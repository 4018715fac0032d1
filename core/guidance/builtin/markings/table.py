"""Which thing has which markings (:mod:`core.guidance.builtin.markings.markings`)."""

from functools import partial
from typing import NamedTuple

from core.guidance.builtin.markings import (
    balls,
    boards,
    bodywork,
    coats,
    craft,
    decor,
    facades,
    figures,
    flags,
    fronts,
    prints,
)
from core.guidance.builtin.markings.facades import Opening
from core.guidance.builtin.markings.margins import Marks, blobs


class Marking(NamedTuple):
    """Where a part lies."""

    on: str  # the part that bears it, or another marking that lies on that
    marks: Marks
    of: str = ""  # the only material that is so marked, where a prompt names one: a plank's seams
    by: str = ""  # the part by whose box it is placed; "": what bears it
    paired: bool = False  # what bears it is alike on both sides of x = 0, and so is it


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


MARKINGS: dict[str, dict[str, Marking]] = {  # by noun and part; what lies on top comes first
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
        "windows": Marking("cab", partial(bodywork.laid, **craft.GARBAGE_WINDOWS)),
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
        "marks": Marking("dial", partial(bodywork.laid, **bodywork.DIAL_MARKS)),
    },
    "barrel": {"seams": Marking("body", boards.staves, "wooden")},
    "chest": {
        "keyhole": Marking("lock", partial(bodywork.laid, **craft.KEYHOLE)),
        "rivets": Marking("bands", partial(bodywork.laid, **craft.RIVETS)),
        "seams": Marking("body", partial(boards.planks, count=4), "wooden"),
    },
    "open chest": {
        "keyhole": Marking("lock", partial(bodywork.laid, **craft.KEYHOLE)),
        "seams": Marking("body", partial(boards.planks, count=4), "wooden"),
    },
    "crate": {
        "nails": Marking("frame", partial(bodywork.laid, **craft.CRATE_NAILS)),
        "seams": Marking("planks", partial(boards.planks, count=6), "wooden"),
    },
    "rowboat": {"seams": Marking("hull", partial(boards.planks, count=5), "wooden")},
    "pirate ship": {"seams": Marking("hull", partial(boards.planks, count=10), "wooden")},
    "basket": {"weave": Marking("body", boards.weave)},
    "hamburger": {"seeds": Marking("bun", coats.seeds)},
    "phone": {
        "icons": Marking("screen", prints.icons),
        "lenses": Marking("camera", partial(bodywork.laid, **bodywork.PHONE_LENSES)),
        "camera": Marking("body", partial(bodywork.laid, **bodywork.PHONE_CAMERA)),
    },
    "scroll": {"letters": Marking("paper", partial(prints.ruled, lines=SCRIPT, ends=(-0.52, 0.5)))},
    **{
        noun: {"frets": Marking("neck", boards.frets)}
        for noun in ("ukulele", "banjo", "electric guitar")
    },
    "guitar": {
        "frets": Marking("neck", boards.frets),
        "rosette": Marking("neck", craft.rosette),
        "pickguard": Marking("body", partial(bodywork.laid, **craft.GUITAR_GUARD)),
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
        "trim": Marking("body", partial(bodywork.laid, **bodywork.TAXI_TRIM)),
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
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.BUS_TAIL)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.SCHOOL_BUS_TRIM)),
        "letters": Marking(
            "body", partial(fronts.on_sides, text="SCHOOL BUS", high=0.1, at=(0, 0.78))
        ),
        "stripe": Marking("body", partial(fronts.belt, low=-0.32, high=-0.2)),
    },
    "ambulance": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.AMBULANCE_WINDOWS)),
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.VAN_TAIL)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.AMBULANCE_TRIM)),
        "cross": Marking("body", prints.kit_on_sides),
    },
    "fire truck": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.FIRE_WINDOWS)),
        "lockers": Marking("body", partial(bodywork.laid, **bodywork.FIRE_LOCKERS)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.FIRE_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.6, high=-0.44)),
    },
    "double decker bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.DOUBLE_DECKER_WINDOWS)),
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.DOUBLE_DECKER_TAIL)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.DOUBLE_DECKER_TRIM)),
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
    # What is built.
    "car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.CAR_WINDOWS)),
        "number plates": Marking("body", partial(bodywork.laid, **bodywork.CAR_PLATES)),
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.CAR_TAIL)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.CAR_TRIM)),
    },
    "van": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.VAN_WINDOWS)),
        "number plates": Marking("body", partial(bodywork.laid, **bodywork.VAN_PLATES)),
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.VAN_TAIL)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.VAN_TRIM)),
    },
    "bus": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.BUS_WINDOWS)),
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.BUS_TAIL)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.BUS_TRIM)),
        "stripe": Marking("body", partial(fronts.belt, low=-0.27, high=-0.13)),
    },
    "truck": {
        "windows": Marking("cab", partial(bodywork.windows, **bodywork.TRUCK_WINDOWS)),
        "lamps": Marking("cab", partial(bodywork.laid, **bodywork.TRUCK_LAMPS)),
        "trim": Marking("cab", partial(bodywork.laid, **bodywork.TRUCK_TRIM)),
        "seams": Marking("cargo", partial(bodywork.laid, **bodywork.CARGO_SEAMS)),
    },
    "sports car": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.SPORTS_WINDOWS)),
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.SPORTS_TAIL)),
        "trim": Marking("body", partial(bodywork.laid, **bodywork.SPORTS_TRIM)),
    },
    "pickup truck": {
        "windows": Marking("body", partial(bodywork.windows, **bodywork.PICKUP_WINDOWS)),
        "tail lamps": Marking("body", partial(bodywork.laid, **bodywork.PICKUP_TAIL)),
        "seams": Marking("body", partial(bodywork.laid, **bodywork.PICKUP_SEAMS)),
    },
    "robot": {
        "mouth": Marking("head", partial(bodywork.laid, **bodywork.MOUTH)),
        "buttons": Marking("body", partial(bodywork.laid, **bodywork.ROBOT_BUTTONS)),
    },
    "race car": {
        "number": Marking("body", partial(bodywork.laid, **bodywork.RACE_NUMBER)),
        "visor": Marking("helmet", partial(bodywork.laid, **bodywork.VISOR)),
    },
    "train": {
        "windows": Marking("cab", partial(bodywork.windows, **bodywork.TRAIN_WINDOWS)),
        "bands": Marking("boiler", partial(fronts.belts, spans=bodywork.BOILER_BANDS, axis=1)),
    },
    "tank": {
        "star": Marking("turret", partial(bodywork.laid, **bodywork.TANK_STAR)),
        "links": Marking("tracks", bodywork.links),
        "vents": Marking("hull", partial(bodywork.laid, **bodywork.TANK_VENTS)),
    },
    "book": {
        "badge": Marking("cover", partial(bodywork.laid, **bodywork.BOOK_BADGE), by="pages"),
        "border": Marking("cover", partial(bodywork.laid, **bodywork.BOOK_BORDER), by="pages"),
        "lines": Marking("pages", partial(boards.planks, count=7, axis=1)),
    },
    "television": {
        "glare": Marking("screen", bodywork.glare),
        "slots": Marking("body", partial(bodywork.laid, **bodywork.TV_SLOTS)),
    },
    "laptop": {
        "icons": Marking("screen", partial(bodywork.laid, **bodywork.LAPTOP_ICONS)),
        "badge": Marking("body", partial(bodywork.laid, **bodywork.LAPTOP_BADGE)),
    },
    "monitor": {
        "icons": Marking("screen", partial(bodywork.laid, **bodywork.LAPTOP_ICONS)),
        "slots": Marking("body", partial(bodywork.laid, **bodywork.TV_SLOTS)),
    },
    "speaker": {
        "caps": Marking("cones", partial(bodywork.cone_rings, spans=((-1.0, 0.3),)), by="body"),
        "rings": Marking(
            "cones", partial(bodywork.cone_rings, spans=((0.45, 0.53), (0.68, 0.76))), by="body"
        ),
    },
    "camera": {
        "rings": Marking("lens", partial(fronts.belts, spans=bodywork.LENS_RINGS, axis=1)),
        "screen": Marking("grip", partial(bodywork.laid, **bodywork.CAMERA_SCREEN)),
    },
    "refrigerator": {
        "magnets": Marking("doors", partial(bodywork.laid, **bodywork.FRIDGE_MAGNETS), by="body"),
        "note": Marking("doors", partial(bodywork.laid, **bodywork.FRIDGE_NOTE), by="body"),
        "coils": Marking("body", partial(bodywork.laid, **bodywork.FRIDGE_COILS)),
    },
    "washing machine": {
        "lights": Marking("panel", partial(bodywork.laid, **bodywork.PANEL_LIGHTS)),
        "seams": Marking("body", partial(bodywork.laid, **bodywork.WASHER_SEAMS)),
    },
    "stove": {
        "racks": Marking("window", partial(bodywork.laid, **bodywork.OVEN_RACKS)),
        "coils": Marking("plates", partial(bodywork.laid, **bodywork.OVEN_COILS), by="body"),
        "seams": Marking("body", partial(bodywork.laid, **bodywork.OVEN_SEAMS)),
    },
    "microwave": {
        "digits": Marking("display", partial(bodywork.laid, **bodywork.MICROWAVE_DIGITS)),
        "display": Marking("body", partial(bodywork.laid, **bodywork.MICROWAVE_DISPLAY)),
        "buttons": Marking("body", partial(bodywork.laid, **bodywork.MICROWAVE_BUTTONS)),
        "mesh": Marking("window", partial(bodywork.laid, **bodywork.MICROWAVE_MESH)),
        "seams": Marking("body", partial(bodywork.laid, **bodywork.MICROWAVE_SEAMS)),
    },
    "vending machine": {
        "letters": Marking("body", partial(fronts.on_sides, text="DRINKS", high=0.34, at=(0, 0.5))),
        "stripes": Marking("body", partial(bodywork.laid, **bodywork.VENDING_STRIPES)),
    },
    "safe": {
        "marks": Marking("dial", partial(fronts.hours, radius=1.0)),
        "rivets": Marking("body", partial(bodywork.laid, **bodywork.SAFE_RIVETS)),
    },
    "cabinet": {
        "panels": Marking("doors", bodywork.door_panels, paired=True),
    },
    "wardrobe": {
        "panels": Marking("doors", partial(bodywork.laid, **bodywork.WARDROBE_PANELS), by="body"),
    },
    "bookshelf": {
        "bands": Marking("books", partial(fronts.belts, spans=bodywork.BOOK_BANDS), by="frame"),
        "labels": Marking("volumes", partial(fronts.belts, spans=bodywork.BOOK_LABELS), by="frame"),
        "stripes": Marking("tomes", partial(fronts.belts, spans=bodywork.BOOK_STRIPES), by="frame"),
    },
    "bed": {
        "stripes": Marking(
            "blanket", partial(fronts.belts, spans=bodywork.BLANKET_STRIPES, axis=1)
        ),
        "panels": Marking("frame", partial(bodywork.laid, **bodywork.BED_PANELS)),
    },
    "sofa": {
        "buttons": Marking("back", partial(bodywork.laid, **bodywork.SOFA_BUTTONS)),
        "piping": Marking("arms", partial(bodywork.laid, **bodywork.ARM_PIPING), paired=True),
    },
    "armchair": {
        "buttons": Marking("back", partial(bodywork.laid, **bodywork.CHAIR_BUTTONS)),
        "piping": Marking("arms", partial(bodywork.laid, **bodywork.ARM_PIPING), paired=True),
    },
    "can": {
        "badge": Marking("label", partial(bodywork.laid, **bodywork.CAN_BADGE)),
        "wave": Marking("label", partial(bodywork.wave, high=0.16, wide=0.5)),
    },
    "bottle": {
        "badge": Marking("label", partial(bodywork.laid, **bodywork.LABEL_BADGE)),
        "bands": Marking("label", partial(fronts.belts, spans=bodywork.BOTTLE_BANDS)),
        "label": Marking("body", partial(fronts.belt, low=-0.75, high=-0.12)),
    },
    "suitcase": {
        "stickers": Marking("body", partial(bodywork.laid, **bodywork.STICKERS)),
        "seam": Marking("body", partial(fronts.belt, low=-0.05, high=0.05, axis=1)),
    },
    "backpack": {
        "badge": Marking("pocket", partial(bodywork.laid, **bodywork.POCKET_BADGE)),
        "zips": Marking("pocket", partial(bodywork.laid, **bodywork.POCKET_ZIPS)),
    },
    "traffic light": {
        "border": Marking("body", partial(bodywork.laid, **bodywork.LIGHT_BORDER)),
    },
    "mailbox": {
        "letters": Marking(
            "box", partial(fronts.on_sides, text="MAIL", high=0.3, at=(0.36, -0.12))
        ),
        "slots": Marking("door", partial(bodywork.laid, **bodywork.MAIL_SEAMS)),
    },
    "notice board": {
        "lines": Marking("paper", partial(bodywork.hoops, pitch=0.058, wide=0.009)),
        "words": Marking("notes", partial(bodywork.hoops, pitch=0.058, wide=0.009)),
    },
    "gift": {
        "dots": Marking("box", partial(bodywork.laid, **bodywork.GIFT_DOTS)),
    },
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
    **{noun: {"mouth": MUZZLED} for noun in ("dog", "fox", "bear", "lion")},
    "cat": {
        "whiskers": Marking("muzzle", partial(figures.dots, places=WHISKERS, size=0.075, both=True))
    },
    "rabbit": {
        "ears": Marking("body", partial(figures.patches, at=(0.35, 0.62), size=(0.1, 0.24))),
        "belly": Marking(
            "body", partial(figures.patches, at=(0.0, -0.42), size=(0.46, 0.3), both=False)
        ),
    },
    "pig": {
        "nostrils": Marking(
            "snout", partial(figures.dots, places=[(0.36, 0.0)], size=0.2, both=True)
        )
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


# Buildings.


def _glazed(
    openings: tuple[Opening, ...],
    grid: tuple[int, int] = (2, 2),
    on: str = "walls",
    name: str = "windows",
    frame: float = facades.FRAME,
    sill: float = facades.SILL,
) -> dict[str, Marking]:
    """Windows in frames."""
    return {
        "frames": Marking(name, partial(facades.frames, openings=openings, grid=grid)),
        name: Marking(on, partial(facades.windows, openings=openings, frame=frame, sill=sill)),
    }


def _openings(
    face: str,
    us: tuple[float, ...],
    vs: tuple[float, ...],
    size: tuple[float, float],
    head: str = "",
    depth: float = 0.7,
) -> tuple[Opening, ...]:
    """Rows of windows that are alike."""
    return tuple(Opening(face, (u, v), size, head, depth) for v in vs for u in us)


HOUSE_WINDOWS = (
    *_openings("front", (-0.61, 0.61), (0.14,), (0.19, 0.38)),
    *_openings("back", (-0.5, 0.5), (0.14,), (0.19, 0.38)),
    *_openings("sides", (-0.42, 0.42), (0.14,), (0.22, 0.38)),
)
COTTAGE_FRONT = _openings("front", (-0.63, 0.63), (-0.44,), (0.17, 0.25))
COTTAGE_WINDOWS = (
    *COTTAGE_FRONT,
    *_openings("front", (0.0,), (0.2,), (0.15, 0.17), "arched"),
    *_openings("back", (-0.4, 0.4), (-0.44,), (0.17, 0.25)),
    *_openings("back", (0.0,), (0.2,), (0.15, 0.17), "arched"),
    *_openings("sides", (-0.42, 0.42), (-0.56,), (0.17, 0.2)),
)
CHURCH_WINDOWS = (
    *_openings("front", (0.0,), (0.13,), (0.25, 0.25), "round"),
    *_openings("sides", (-0.45, 0.12, 0.68), (-0.42,), (0.1, 0.27), "arched"),
    *_openings("back", (0.0,), (-0.22,), (0.26, 0.45), "arched"),
)
TOWER_WINDOWS = tuple(
    one
    for face in ("front", "back", "sides")
    for one in _openings(face, (0.0,), (0.28,), (0.12, 0.2), "arched", 0.5)
)
LIGHT_WINDOWS = tuple(
    one
    for face in ("front", "back", "sides")
    for one in _openings(face, (0.0,), (0.0, 0.55), (0.16, 0.09), "arched", 0.3)
)
CASTLE_WINDOWS = tuple(
    one
    for face in ("front", "back", "sides")
    for one in (
        *_openings(face, (-0.71, 0.71), (-0.24,), (0.07, 0.14), "arched"),
        *_openings(face, (0.0,), (0.52,), (0.08, 0.12), "arched", 0.2),
    )
)
MILL_WINDOWS = (
    *_openings("sides", (0.0,), (0.2,), (0.19, 0.15), "", 0.4),
    *_openings("front", (0.0,), (0.2,), (0.19, 0.15), "", 0.4),
    *_openings("back", (0.0,), (-0.35, 0.2), (0.19, 0.15), "", 0.4),
)
FACTORY_WINDOWS = (
    *_openings("front", (-0.667, 0.0, 0.667), (0.16,), (0.23, 0.27)),
    *_openings("sides", (-0.58, 0.1), (0.0,), (0.25, 0.27)),
)
FACTORY_GATES = (
    Opening("front", (0.0, -0.68), (0.22, 0.36)),
    Opening("front", (0.667, -0.72), (0.11, 0.32)),
)
SHOP_WINDOWS = (
    *_openings("front", (0.0,), (-0.43,), (0.86, 0.33)),
    *_openings("sides", (0.0,), (-0.4,), (0.62, 0.26)),
    *_openings("sides", (-0.4, 0.4), (0.42,), (0.2, 0.2)),
    *_openings("back", (-0.45, 0.45), (0.42, -0.4), (0.2, 0.2)),
)
SCHOOL_WINDOWS = (
    *_openings("front", (-0.81, -0.51, 0.51, 0.81), (-0.54, -0.06), (0.1, 0.15), "", 0.5),
    *_openings("back", (-0.81, -0.51, -0.17, 0.17, 0.51, 0.81), (-0.54, -0.06), (0.1, 0.15)),
    *_openings("sides", (-0.45, 0.1, 0.62), (-0.54, -0.06), (0.15, 0.15)),
)
HOSPITAL_WINDOWS = (
    *_openings("front", (-0.77, 0.77), (-0.62, -0.24), (0.13, 0.12), "", 0.5),
    *_openings("front", (-0.36, 0.0, 0.36), (-0.05,), (0.11, 0.1)),
    *_openings("front", (-0.38, 0.38), (-0.62,), (0.1, 0.13)),
    *_openings("back", (-0.77, 0.77), (-0.62, -0.24), (0.13, 0.12), "", 0.5),
    *_openings("back", (-0.33, 0.0, 0.33), (-0.62, -0.24), (0.11, 0.12)),
    *_openings("sides", (-0.28, 0.38), (-0.62, -0.24), (0.22, 0.12)),
    *_openings("sides", (-0.44, 0.44), (0.34, 0.7), (0.27, 0.11), "", 0.3),
)
TREE_WINDOWS = (
    *_openings("front", (0.44,), (0.1,), (0.26, 0.42)),
    *_openings("sides", (0.0,), (0.1,), (0.36, 0.42)),
    *_openings("back", (-0.45,), (0.1,), (0.26, 0.42)),
)
MODERN_DOOR = _openings("front", (0.0,), (-0.22,), (0.115, 0.78))
WHOLE_FRONT = _openings("front", (0.0,), (0.0,), (1.0, 1.0), "", 0.0)
MARKINGS |= {
    "house": {
        "panels": Marking("door", facades.panels),
        **_glazed(HOUSE_WINDOWS),
        "seams": Marking("roof", facades.tiles),
    },
    "cottage": {
        "panels": Marking("door", facades.panels),
        **_glazed(COTTAGE_WINDOWS),
        "shutters": Marking("walls", partial(facades.shutters, openings=COTTAGE_FRONT, wide=0.5)),
    },
    "church": {
        "panels": Marking("door", partial(facades.panels, rows=((-0.84, 0.84),))),
        "cross": Marking("walls", partial(prints.stamp, shape="cross", size=0.24, at=(0.0, 0.62))),
        **_glazed(CHURCH_WINDOWS),
        "seams": Marking("roof", partial(facades.tiles, axis=1)),
    },
    "tower": {
        "seams": Marking("door", partial(boards.planks, count=5, axis=0, wide=0.012)),
        **_glazed(TOWER_WINDOWS, (1, 1), frame=0.035),
    },
    "lighthouse": {
        "bars": Marking("lantern", partial(boards.staves, count=8, wide=0.016)),
        **_glazed(LIGHT_WINDOWS, (1, 2), "tower"),
    },
    "castle": {
        "seams": Marking("door", partial(boards.planks, count=5, axis=0, wide=0.012)),
        **_glazed(CASTLE_WINDOWS, (1, 1)),
    },
    "windmill": {
        "windows": Marking("walls", partial(facades.panes, openings=MILL_WINDOWS)),
        "lattice": Marking("sails", facades.lattice),
    },
    "factory": {
        "slats": Marking("gate", partial(boards.planks, count=9, wide=0.01)),
        "gate": Marking("hall", partial(facades.windows, openings=FACTORY_GATES, sill=0.0)),
        **_glazed(FACTORY_WINDOWS, (4, 2), "hall"),
    },
    "shop": {
        "letters": Marking("sign", partial(fronts.lettered, text="OPEN", high=0.3)),
        "frames": Marking("window", partial(facades.frames, openings=SHOP_WINDOWS)),
        "window": Marking("walls", partial(facades.windows, openings=SHOP_WINDOWS)),
    },
    "school": _glazed(SCHOOL_WINDOWS, (1, 2), frame=0.016, sill=0.014),
    "hospital": _glazed(HOSPITAL_WINDOWS, (2, 1), frame=0.018, sill=0.014),
    "treehouse": _glazed(TREE_WINDOWS),
    "barn": {
        "trim": Marking("walls", facades.barn_trim),
        "door": Marking("walls", facades.barn_door),
        "hay": Marking("walls", partial(facades.panes, openings=(facades.LOFT,), grid=(1, 1))),
        "windows": Marking("walls", partial(facades.panes, openings=facades.BARN_WINDOWS)),
        "seams": Marking("walls", boards.boarding, "wooden"),
    },
    "log cabin": {"mullions": Marking("window", partial(facades.frames, openings=WHOLE_FRONT))},
    "skyscraper": {
        "mullions": Marking("windows", partial(boards.boarding, pitch=0.11, wide=0.014))
    },
    "modern house": {
        "mullions": Marking("windows", partial(boards.boarding, pitch=0.28, wide=0.014)),
        "slats": Marking("garage", partial(boards.planks, count=5, wide=0.012)),
        "door": Marking("walls", partial(facades.panes, openings=MODERN_DOOR, grid=(1, 1))),
    },
    "gas station": {
        "letters": Marking("band", partial(fronts.lettered, text="GAS", high=0.085, bold=0.06))
    },
    "bus stop": {
        "letters": Marking("sign", partial(fronts.lettered, text="BUS", high=0.5, bold=0.06))
    },
    "fireplace": {"mortar": Marking("body", facades.courses)},
    # Craft, machines, instruments, boxes.
    "airplane": {
        "windows": Marking("body", partial(craft.girt, **craft.PLANE_WINDOWS)),
        "doors": Marking("body", partial(bodywork.laid, **craft.PLANE_DOORS)),
        "stripe": Marking("body", partial(craft.girt, **craft.PLANE_STRIPE)),
        "bands": Marking("tail", partial(fronts.belts, spans=craft.TAIL_BANDS)),
    },
    "helicopter": {
        "panes": Marking("body", partial(bodywork.laid, **craft.HELICOPTER_PANES)),
        "doors": Marking("body", partial(bodywork.laid, **craft.HELICOPTER_DOORS)),
        "bands": Marking("body", partial(fronts.belts, spans=craft.HELICOPTER_BANDS, axis=1)),
    },
    "fighter jet": {
        "stars": Marking("wings", partial(bodywork.laid, **craft.JET_STARS)),
        "nose": Marking("body", partial(fronts.belts, spans=craft.JET_NOSE, axis=1)),
    },
    "rocket": {
        "bands": Marking("hull", partial(fronts.belts, spans=craft.ROCKET_BANDS)),
        "hatch": Marking("hull", partial(bodywork.laid, **craft.ROCKET_HATCH)),
    },
    "spaceship": {
        "nose": Marking("hull", partial(fronts.belts, spans=craft.SHIP_NOSE, axis=1)),
        "stripes": Marking("wings", partial(bodywork.laid, **craft.SHIP_STRIPES)),
    },
    "ufo": {
        "band": Marking("body", partial(fronts.belt, low=-0.2, high=0.08)),
        "seams": Marking("body", partial(craft.spokes, count=12, wide=0.011, reach=(0.3, 2.0))),
        "frames": Marking("dome", partial(craft.spokes, count=6, wide=0.014, reach=(-1.0, 2.0))),
    },
    "submarine": {
        "windows": Marking("hull", partial(bodywork.laid, **craft.SUB_PORTS)),
        "rims": Marking("hull", partial(bodywork.laid, **craft.SUB_RIMS)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.3)),
    },
    "satellite": {
        "lines": Marking(
            "panels",
            partial(craft.lattice, count=(2, 4), room=0.02, wide=0.009),
            paired=True,
        ),
        "seams": Marking("body", partial(bodywork.laid, **craft.FOIL)),
    },
    "space station": {
        "lines": Marking(
            "panels",
            partial(craft.lattice, count=(2, 5), room=0.02, wide=0.008),
            paired=True,
        ),
    },
    "monster truck": {
        "doors": Marking("body", partial(bodywork.laid, **craft.MONSTER_DOORS)),
        "flames": Marking("body", partial(bodywork.laid, **craft.FLAMES)),
    },
    "boat": {
        "anchor": Marking("sails", partial(bodywork.laid, **craft.ANCHOR)),
        "stripe": Marking("hull", partial(craft.flank, low=0.4, high=0.66, out=0.84)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.3)),
    },
    "sailboat": {
        "anchor": Marking("sails", partial(bodywork.laid, **craft.ANCHOR)),
        "keel": Marking("hull", partial(fronts.belt, low=-2.0, high=-0.4)),
    },
    "cruise ship": {
        "portholes": Marking("hull", partial(bodywork.laid, **craft.PORTHOLES)),
    },
    "yacht": {
        "portholes": Marking("hull", partial(bodywork.laid, **craft.YACHT_PORTS)),
    },
    "cargo ship": {
        "ribs": Marking("containers", craft.container_ribs, by="hull"),
        "ridges": Marking("boxes", craft.container_ribs, by="hull"),
    },
    "tractor": {
        "grille": Marking("body", partial(bodywork.laid, **craft.TRACTOR_GRILLE)),
        "lamps": Marking("body", partial(bodywork.laid, **craft.TRACTOR_LAMPS)),
    },
    "excavator": {
        "stripes": Marking("body", partial(bodywork.laid, **craft.DIGGER_STRIPES)),
        "vents": Marking("body", partial(bodywork.laid, **craft.DIGGER_VENTS)),
        "links": Marking("tracks", bodywork.links),
    },
    "trash can": {
        "flutes": Marking("body", partial(craft.flutes, count=14, share=0.34, high=0.84)),
    },
    "record player": {
        "grooves": Marking("record", partial(fronts.rings, spans=GROOVES, axis=2)),
        "panels": Marking("case", partial(bodywork.laid, **craft.CASE_PANELS)),
    },
    "cash register": {
        "digits": Marking("display", partial(bodywork.laid, **craft.DISPLAY_DIGITS)),
        "border": Marking("body", partial(bodywork.laid, **craft.TILL_BORDER)),
    },
    "printer": {
        "lines": Marking("paper", partial(bodywork.laid, **craft.PRINTED)),
    },
    "drone": {
        "lamps": Marking("body", partial(bodywork.laid, **craft.DRONE_LAMPS)),
        "seams": Marking("body", partial(bodywork.laid, **craft.DRONE_SEAMS)),
    },
    "lamp": {
        "bands": Marking("shade", partial(fronts.belts, spans=craft.SHADE_BANDS)),
        "pleats": Marking("shade", partial(craft.flutes, count=24, share=0.15, high=0.9)),
    },
    "headphones": {
        "badges": Marking("cups", partial(bodywork.laid, **craft.CUP_BADGES), paired=True),
    },
    "drum": {
        "badge": Marking("shell", partial(bodywork.laid, **craft.DRUM_BADGE)),
        "cords": Marking("shell", partial(craft.zigzag, count=8, high=0.8, wide=0.016)),
    },
    "piano": {
        "panels": Marking("body", partial(bodywork.laid, **craft.PIANO_PANELS)),
    },
    "trophy": {
        "plaque": Marking("base", partial(bodywork.laid, **craft.PLAQUE)),
        "star": Marking("cup", partial(bodywork.laid, **craft.CUP_STAR)),
    },
    "toolbox": {
        "letters": Marking("body", partial(fronts.lettered, **craft.TOOLS)),
    },
    "briefcase": {
        "stitches": Marking("body", partial(bodywork.laid, **craft.STITCHED)),
    },
    "cannon": {
        "bands": Marking("barrel", partial(fronts.belts, spans=craft.CANNON_BANDS, axis=1)),
    },
    "gas pump": {
        "marks": Marking("face", partial(bodywork.laid, **craft.PUMP_MARKS), by="body"),
        "star": Marking("globe", partial(bodywork.laid, **craft.GLOBE_STAR)),
    },
    "coffee machine": {
        "digits": Marking("panel", partial(bodywork.laid, **craft.COFFEE_DIGITS)),
        "buttons": Marking("panel", partial(bodywork.laid, **craft.COFFEE_BUTTONS)),
    },
    "telephone": {
        "holes": Marking("dial", craft.dial_holes),
    },
    "space shuttle": {
        "edges": Marking("wings", partial(bodywork.laid, **craft.SHUTTLE_EDGES)),
        "doors": Marking("body", partial(bodywork.laid, **craft.SHUTTLE_DOORS)),
        "tiles": Marking("body", partial(fronts.belt, low=-2.0, high=-0.42)),
    },
    "computer tower": {
        "ports": Marking("body", partial(bodywork.laid, **craft.TOWER_PORTS)),
    },
    "motorcycle": {
        "fins": Marking("engine", partial(bodywork.laid, **craft.ENGINE_FINS)),
    },
    "remote control": {
        "seams": Marking("body", partial(bodywork.laid, **craft.REMOTE_SEAMS)),
    },
    # Furniture, ware, arms, food.
    "table": {"seams": Marking("top", partial(decor.laid, **decor.TABLE_SEAMS), "wooden")},
    "desk": {
        "border": Marking("blotter", partial(decor.laid, **decor.BLOTTER_EDGE)),
        "blotter": Marking("top", partial(decor.laid, **decor.BLOTTER)),
    },
    "dresser": {"panels": Marking("drawers", decor.each_drawer)},
    "nightstand": {"panels": Marking("drawers", decor.each_drawer)},
    "bench": {
        "bolts": Marking("seat", partial(decor.laid, **decor.BENCH_BOLTS)),
        "seams": Marking("seat", partial(decor.laid, **decor.BENCH_SEAMS), "wooden"),
    },
    "office chair": {"seams": Marking("back", partial(decor.laid, **decor.BACK_SEAMS))},
    "pillow": {"border": Marking("body", partial(decor.laid, **decor.PILLOW_BORDER))},
    "window": {
        "slats": Marking("shutters", partial(decor.laid, **decor.SLATS), paired=True),
    },
    "mug": {"bands": Marking("body", partial(fronts.belts, spans=decor.MUG_BANDS))},
    "bowl": {"bands": Marking("body", partial(fronts.belts, spans=decor.BOWL_BANDS))},
    "teapot": {
        "bands": Marking("body", partial(fronts.belts, spans=decor.TEAPOT_BANDS)),
    },
    "sword": {
        "fuller": Marking("blade", partial(decor.laid, **decor.FULLER)),
        "wraps": Marking("grip", partial(fronts.belts, spans=decor.GRIP_WRAPS)),
    },
    "shield": {"quarters": Marking("plate", partial(decor.laid, **decor.QUARTERS))},
    "helmet": {"breaths": Marking("shell", partial(decor.laid, **decor.BREATHS))},
    "tombstone": {"letters": Marking("slab", decor.epitaph)},
    "umbrella": {"panels": Marking("canopy", partial(balls.sectors, count=8))},
    "tent": {"trim": Marking("canvas", decor.gable)},
    "bell": {"bands": Marking("body", partial(fronts.belts, spans=decor.BELL_BANDS))},
    "crown": {"borders": Marking("band", partial(fronts.belts, spans=decor.CROWN_BANDS))},
    "coin": {"beads": Marking("face", partial(decor.beads, radius=0.72, size=0.035, count=28))},
    "log": {"furrows": Marking("bark", decor.bark_lines)},
    "bread": {"scores": Marking("crust", partial(decor.laid, **decor.LOAF_SCORES))},
    "flower": {
        "streaks": Marking("petals", partial(decor.rays, span=(0.3, 0.74), count=24, wide=0.03))
    },
    "chess rook": {"joints": Marking("body", decor.bricks)},
    "axe": {
        "edge": Marking("head", decor.cutting_edge),
        "wraps": Marking("handle", partial(fronts.belts, spans=decor.HANDLE_WRAPS)),
    },
    "curtain": {"hems": Marking("curtain", partial(fronts.belts, spans=decor.HEMS))},
    "gaming chair": {"badge": Marking("seat", partial(decor.laid, **decor.CHAIR_BADGE))},
    "arrow": {"bands": Marking("shaft", partial(fronts.belts, spans=decor.ARROW_BANDS))},
    "counter": {"panels": Marking("body", partial(decor.laid, **decor.COUNTER_PANELS))},
    "envelope": {
        "stamp": Marking("body", partial(decor.laid, **decor.STAMP)),
        "address": Marking("body", partial(decor.laid, **decor.ADDRESS)),
    },
}
