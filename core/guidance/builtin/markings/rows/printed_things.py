"""Markings of boards, cards, signs and packs."""

from functools import partial

from core.guidance.builtin.markings import outlines
from core.guidance.builtin.markings.forms import bands, frames, papers
from core.guidance.builtin.markings.margins import Marks
from core.guidance.builtin.markings.marking import Marking, Rows
from core.guidance.builtin.markings.outlines import Outline
from core.guidance.builtin.markings.rows.outlines import printed_things as own


def _both_faces(*print_: Outline) -> Marks:
    """The same in front and behind."""
    return partial(outlines.laid, front=print_, back=print_)


PRINTED_THINGS: Rows = {
    "blackboard": {
        "writing": Marking("board", partial(outlines.laid, **own.BLACKBOARD_WRITING)),
        "drawing": Marking("board", partial(outlines.laid, **own.BLACKBOARD_DRAWING)),
        "smears": Marking("board", partial(outlines.laid, **own.BLACKBOARD_SMEARS)),
    },
    "whiteboard": {
        "writing": Marking("board", partial(outlines.laid, **own.WHITEBOARD_WRITING)),
        "graph": Marking("board", partial(outlines.laid, **own.WHITEBOARD_GRAPH)),
        "notes": Marking("board", partial(outlines.laid, **own.WHITEBOARD_NOTES)),
    },
    "billboard": {
        "letters": Marking("board", partial(outlines.laid, **own.BILLBOARD_LETTERS)),
        "sun": Marking("board", partial(outlines.laid, **own.BILLBOARD_SUN)),
        "border": Marking("board", partial(outlines.laid, **own.BILLBOARD_BORDER)),
        "middle": Marking("post", own.ON_BOARD, by="board"),
    },
    "street sign": {
        "letters": Marking("board", partial(outlines.laid, **own.STREET_LETTERS)),
        "border": Marking("board", partial(outlines.laid, **own.STREET_BORDER)),
        "middle": Marking("post", own.ON_BOARD, by="board"),
    },
    "wanted poster": {
        "letters": Marking("paper", partial(outlines.laid, **own.POSTER_LETTERS)),
        "hat": Marking("picture", partial(outlines.laid, **own.POSTER_HAT)),
        "face": Marking("picture", partial(outlines.laid, **own.POSTER_FACE)),
        "picture": Marking("paper", partial(outlines.laid, **own.POSTER_PICTURE)),
        "border": Marking("paper", partial(outlines.laid, **own.POSTER_BORDER)),
    },
    "newspaper": {
        "letters": Marking("paper", partial(outlines.laid, **own.NEWS_LETTERS)),
        "hills": Marking("picture", partial(outlines.laid, **own.NEWS_HILLS)),
        "picture": Marking("paper", partial(outlines.laid, **own.NEWS_PICTURE)),
        "lines": Marking("paper", partial(outlines.laid, **own.NEWS_LINES)),
    },
    "treasure map": {
        "cross": Marking("land", partial(outlines.laid, **own.MAP_CROSS)),
        "path": Marking("land", partial(outlines.laid, **own.MAP_PATH)),
        "hills": Marking("land", partial(outlines.laid, **own.MAP_MOUNTAINS)),
        "land": Marking("coast", partial(outlines.laid, **own.MAP_ISLANDS)),
        "coast": Marking("paper", partial(outlines.laid, **own.MAP_SHORES)),
        "rose": Marking("paper", partial(outlines.laid, **own.MAP_COMPASS)),
        "edges": Marking("paper", papers.burnt_edges),
    },
    "playing card": {
        "pips": Marking(
            "paper", partial(papers.both_ways, front=own.CARD_CORNER, once=own.CARD_HEART)
        ),
        "lattice": Marking("back", partial(outlines.laid, **own.CARD_LATTICE)),
        "back": Marking("paper", partial(outlines.laid, **own.CARD_BACK)),
    },
    "tarot card": {
        "letters": Marking("label", partial(outlines.laid, **own.TAROT_LETTERS)),
        "label": Marking("paper", partial(outlines.laid, **own.TAROT_BANNER)),
        "stars": Marking("paper", partial(outlines.laid, **own.TAROT_STARS)),
        "sun": Marking("paper", partial(outlines.laid, **own.TAROT_SUN)),
        "border": Marking("paper", partial(outlines.laid, **own.TAROT_BORDER)),
    },
    "passport": {
        "emblem": Marking("cover", partial(outlines.laid, **own.PASSPORT_EMBLEM)),
        "letters": Marking("cover", partial(outlines.laid, **own.PASSPORT_LETTERS)),
        "pages": Marking("cover", papers.page_edges),
    },
    "credit card": {
        "lines": Marking("chip", partial(outlines.laid, **own.CREDIT_LINES)),
        "chip": Marking("body", partial(outlines.laid, **own.CREDIT_CHIP)),
        "digits": Marking("body", partial(outlines.laid, **own.CREDIT_DIGITS)),
        "reds": Marking("body", partial(outlines.laid, **own.CREDIT_REDS)),
        "oranges": Marking("body", partial(outlines.laid, **own.CREDIT_ORANGES)),
        "band": Marking("body", partial(outlines.laid, **own.CREDIT_BAND)),
        "waves": Marking("body", partial(outlines.laid, **own.CREDIT_WAVES)),
    },
    "license plate": {
        "letters": Marking("plate", partial(outlines.laid, **own.PLATE_LETTERS)),
        "border": Marking("plate", partial(outlines.laid, **own.PLATE_BORDER)),
        "bolts": Marking("plate", partial(outlines.laid, **own.PLATE_BOLTS)),
        "star": Marking("plate", partial(outlines.laid, **own.PLATE_SUN)),
    },
    "circuit board": {
        "chips": Marking("board", partial(outlines.laid, **own.CIRCUIT_CHIPS)),
        "capacitors": Marking("board", partial(outlines.laid, **own.CIRCUIT_CAPACITORS)),
        "pins": Marking("board", partial(outlines.laid, **own.CIRCUIT_PINS)),
        "contacts": Marking("board", partial(outlines.laid, **own.CIRCUIT_CONTACTS)),
        "lines": Marking("board", partial(outlines.laid, **own.CIRCUIT_LINES)),
    },
    "domino": {
        "pips": Marking("body", partial(outlines.laid, **own.DOMINO_PIPS)),
        "line": Marking("body", partial(outlines.laid, **own.DOMINO_LINE)),
    },
    "mahjong tile": {
        "reds": Marking("body", partial(outlines.laid, **own.MAHJONG_REDS)),
        "greens": Marking("body", partial(outlines.laid, **own.MAHJONG_GREENS)),
        "back": Marking("body", partial(bands.belt, low=0.35, high=9.0, axis=1)),
    },
    "stone tablet": {
        "runes": Marking("slab", partial(outlines.laid, **own.TABLET_RUNES)),
        "cracks": Marking("slab", partial(outlines.laid, **own.TABLET_CRACKS)),
        "border": Marking("slab", frames.arch),
    },
    "floppy disk": {
        "slots": Marking("shutter", partial(outlines.laid, **own.FLOPPY_SLOTS)),
        "shutter": Marking("case", partial(outlines.laid, **own.FLOPPY_SHUTTER)),
        "stripe": Marking("label", partial(outlines.laid, **own.FLOPPY_STRIPE)),
        "lines": Marking("label", partial(outlines.laid, **own.FLOPPY_LINES)),
        "label": Marking("case", partial(outlines.laid, **own.FLOPPY_LABEL)),
    },
    "pizza box": {
        "salami": Marking("cheese", partial(outlines.laid, **own.PIZZA_SALAMI)),
        "cheese": Marking("crust", partial(outlines.laid, **own.PIZZA_CHEESE)),
        "crust": Marking("box", partial(outlines.laid, **own.PIZZA_CRUST)),
        "letters": Marking("box", partial(outlines.laid, **own.PIZZA_LETTERS)),
        "border": Marking("box", partial(outlines.laid, **own.PIZZA_BORDER)),
        "seams": Marking("box", partial(outlines.laid, **own.PIZZA_SEAMS)),
    },
    "cereal box": {
        "letters": Marking("burst", _both_faces(*own.CEREAL_LETTERS)),
        "rings": Marking("box", _both_faces(*own.CEREAL_RINGS)),
        "whites": Marking("box", _both_faces(*own.CEREAL_MILK)),
        "bowl": Marking("box", _both_faces(*own.CEREAL_BOWL)),
        "burst": Marking("box", _both_faces(*own.CEREAL_BURST)),
        "strip": Marking("box", _both_faces(*own.CEREAL_TABLE)),
    },
}
