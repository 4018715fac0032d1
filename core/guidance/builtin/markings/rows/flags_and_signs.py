"""Markings of flags and of signs of the road."""

from functools import partial

from core.guidance.builtin.markings.forms import badges, bands, flags, frames, lettering, rings
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.rows.outlines import flags_and_signs as own

FLAGS_AND_SIGNS: Rows = {
    "american flag": {
        "stars": Marking("canton", flags.stars),
        "canton": Marking("cloth", flags.canton),
        "stripes": Marking("cloth", flags.stripes),
    },
    "british flag": {
        "reds": Marking("cloth", partial(flags.crosses, upright=0.2, saltire=0.07)),
        "whites": Marking("cloth", partial(flags.crosses, upright=0.34, saltire=0.2)),
    },
    "french flag": {"blues": Marking("cloth", own.LEFT), "reds": Marking("cloth", own.RIGHT)},
    "italian flag": {"greens": Marking("cloth", own.LEFT), "reds": Marking("cloth", own.RIGHT)},
    "german flag": {"blacks": Marking("cloth", own.TOP), "golds": Marking("cloth", own.BOTTOM)},
    "japanese flag": {"disc": Marking("cloth", partial(badges.emblem, shape="circle", size=0.66))},
    "brazilian flag": {
        "disc": Marking("lozenge", partial(badges.emblem, shape="circle", size=0.45)),
        "lozenge": Marking("cloth", flags.lozenge),
    },
    "swedish flag": {"cross": Marking("cloth", partial(flags.nordic, wide=0.2))},
    "swiss flag": {"cross": Marking("cloth", partial(badges.emblem, shape="cross", size=0.6))},
    "canadian flag": {
        "leaf": Marking("cloth", partial(badges.emblem, shape="maple leaf", size=0.75)),
        "reds": Marking("cloth", flags.outer),
    },
    "irish flag": {
        "greens": Marking("cloth", own.LEFT),
        "oranges": Marking("cloth", own.RIGHT),
    },
    "belgian flag": {"blacks": Marking("cloth", own.LEFT), "reds": Marking("cloth", own.RIGHT)},
    "dutch flag": {"reds": Marking("cloth", own.TOP), "blues": Marking("cloth", own.BOTTOM)},
    "spanish flag": {"yellows": Marking("cloth", partial(bands.bands, axis=2, low=-0.5, high=0.5))},
    "indian flag": {
        "wheel": Marking("cloth", partial(badges.emblem, shape="ring", size=0.28)),
        "oranges": Marking("cloth", own.TOP),
        "greens": Marking("cloth", own.BOTTOM),
    },
    "chinese flag": {
        "star": Marking("cloth", partial(badges.emblem, shape="star", size=0.4, at=(-0.6, 0.4)))
    },
    "turkish flag": {
        "star": Marking("cloth", partial(badges.emblem, shape="star", size=0.22, at=(0.2, 0.0))),
        "moon": Marking("cloth", partial(badges.emblem, shape="moon", size=0.5, at=(-0.25, 0.0))),
    },
    "danish flag": {"cross": Marking("cloth", partial(flags.nordic, wide=0.2))},
    "finnish flag": {"cross": Marking("cloth", partial(flags.nordic, wide=0.26))},
    "ukrainian flag": {"yellows": Marking("cloth", own.LOWER)},
    "polish flag": {"reds": Marking("cloth", own.LOWER)},
    "pirate flag": {
        "skull": Marking("cloth", partial(badges.emblem, shape="skull and crossbones", size=0.85))
    },
    "speed limit sign": {
        "number": Marking("plate", partial(lettering.lettered, text="50", high=0.66, bold=0.04)),
        "ring": Marking("plate", partial(rings.rim, low=0.72, high=0.94)),
    },
    "no entry sign": {"bar": Marking("plate", partial(frames.bar, size=(0.66, 0.17)))},
}
