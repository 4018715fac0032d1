"""Markings of flags and of signs of the road."""

from functools import partial

from core.guidance.builtin.markings import flags, fronts
from core.guidance.builtin.markings.marking import Marking, Rows

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
}
