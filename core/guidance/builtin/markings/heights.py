"""How far markings stand out of the part below, or are sunk in it: a pane is sunk in its wall, a
frame is raised, a print is flat."""

from typing import NamedTuple

from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.markings.margins import Margin


class Height(NamedTuple):
    """The height of a marking in its middle; at its border it is 0."""

    high: float  # training units; negative: sunk
    slope: float = 0.012  # width of the slope inside the border, training units

    def at(self, margin: Margin) -> Float[Tensor, " p"]:
        """The height that far inside the border: a smooth curve."""
        part = (margin / self.slope).clamp(0, 1)
        return self.high * part.square() * (3 - 2 * part)


FLAT = Height(0.0)
RAISED, LOW = Height(0.01, 0.015), Height(0.006)
OF_PANE = Height(0.015, 0.01)  # of parts in a sunk pane, or around it
SUNK, GROOVE = Height(-0.014, 0.018), Height(-0.008, 0.01)
BOWL = Height(-0.014, 0.05)

BY_NAME = {
    RAISED: "badges bars basil belt bolster bolts buckle camera caps cells collar cords frets gems"
    " hinges lamps lattice lenses lights links magnets marquee nails pickguard piping plaque"
    " ribs ridges rims rivets rope rungs sauce shutters slats snow spines stones studs"
    " tail_lamps trim wraps zips",
    OF_PANE: "frames mullions",
    LOW: "beads blotter boards brows buttons carpet coils foam frieze grip hems land lock_plate"
    " number_plates panels pocket pockets runner sprinkles stitches",
    SUNK: "breaths display drain fins gaps grille hole holes hubs keyhole mesh nostrils panes port"
    " portholes ports racks reels screen slots vents window windows",
    GROOVE: "cracks curls door doors feathers flutes folds fuller furrows gills grill_marks grooves"
    " hatch joints laces lockers mortar pleats quills quilting runes scales scores seam"
    " seams signs twist whorl",
    BOWL: "craters dimples pips",
}
BY_THING = {
    "ant": {"bands": GROOVE},
    "arrow": {"bands": RAISED},
    "bell": {"bands": RAISED},
    "book": {"lines": GROOVE},
    "bookshelf": {"bands": LOW, "labels": LOW},
    "boxing glove": {"star": LOW},
    "bridge": {"bands": GROOVE},
    "broom": {"lines": GROOVE},
    "bucket": {"bands": RAISED},
    "camera": {"rings": GROOVE},
    "cannon": {"bands": RAISED},
    "cheese": {"label": LOW},
    "chocolate bar": {"letters": LOW, "border": LOW},
    "christmas tree": {"bands": RAISED},
    "church": {"cross": RAISED},
    "circuit board": {"chips": RAISED, "capacitors": RAISED, "pins": LOW, "lines": LOW},
    "compact disc": {"hub": GROOVE},
    "cowboy": {"star": RAISED},
    "credit card": {"digits": LOW, "chip": LOW},
    "cowboy hat": {"star": RAISED},
    "domino": {"line": GROOVE},
    "drum kit": {"star": LOW},
    "floppy disk": {"shutter": RAISED},
    "fountain": {"tiles": LOW, "lines": GROOVE, "bands": GROOVE},
    "hammer": {"bands": GROOVE},
    "hay bale": {"lines": GROOVE},
    "hockey puck": {"grip": GROOVE},
    "jupiter": {"whorl": FLAT},
    "lamp": {"bands": LOW},
    "landmine": {"plate": RAISED, "light": RAISED},
    "license plate": {"letters": LOW, "border": LOW},
    "lipstick": {"lines": LOW},
    "lobster": {"bands": GROOVE},
    "mahjong tile": {"greens": GROOVE, "reds": GROOVE},
    "manhole cover": {"rings": RAISED},
    "oil drum": {"bands": RAISED, "bung": RAISED},
    "passport": {"emblem": LOW, "letters": LOW, "pages": GROOVE},
    "pencil": {"bands": LOW},
    "playing card": {"pips": FLAT},
    "phone booth": {"sign": RAISED},
    "saddle": {"flowers": LOW},
    "school locker": {"plate": LOW},
    "sci-fi door": {"lines": GROOVE},
    "sarcophagus": {"bands": RAISED},
    "satellite": {"lines": GROOVE},
    "saw": {"letters": GROOVE},
    "shelf": {"bands": LOW},
    "skeleton": {"teeth": GROOVE},
    "skull": {"teeth": GROOVE},
    "sneaker": {"lines": GROOVE},
    "space station": {"lines": GROOVE},
    "speaker": {"rings": LOW},
    "stone tablet": {"border": GROOVE},
    "stool": {"band": LOW},
    "teddy bear": {"mouth": GROOVE},
    "throne": {"border": LOW},
    "tombstone": {"letters": GROOVE},
    "toxic barrel": {"bands": RAISED, "bung": RAISED, "goo": RAISED, "sign": FLAT},
    "train": {"bands": RAISED},
    "tram": {"sign": RAISED},
    "trophy": {"star": RAISED},
    "umbrella": {"panels": FLAT},
}
_NAMED = {name.replace("_", " "): height for height, of in BY_NAME.items() for name in of.split()}


def height_of(noun: str, part: str) -> Height:
    """The height of a marking; without an entry in a table it is flat."""
    return BY_THING.get(noun, {}).get(part) or _NAMED.get(part, FLAT)
