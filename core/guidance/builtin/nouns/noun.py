"""What is known of a thing besides its shape: its names, its looks, its size and weight.

Standard library only.
"""

from typing import NamedTuple

# Handbook densities, kg/m³.
WOOD, STEEL, GOLD, PLASTIC, RUBBER, STONE = 650.0, 7850.0, 19300.0, 1000.0, 1150.0, 2600.0
CERAMIC, GLASS, COPPER, FABRIC, LEATHER = 2400.0, 2500.0, 8900.0, 250.0, 900.0
FLESH, PLANT, WAX, SNOW = 1000.0, 900.0, 900.0, 450.0
PAPER, CARDBOARD = 750.0, 700.0

# Looks that many things share.
GLASS_LOOK, TYRES_LOOK, EYES_LOOK = "-26323c . glass", "-1c1c1e . rubber", "-14100e"


class Usual(NamedTuple):
    """Of an ordinary specimen. Most things are not solid, and the prior's are plumper than real
    ones: ``filled`` is the part of the volume that is material, so that the mass is usual too
    (a car of 4.2 m weighs 1.4 t, not 90).
    """

    size_m: float  # the longest side
    kg_m3: float  # of what it is made of where the prompt names no material
    filled: float = 1.0  # the part of its volume, as the prior makes it, that is material


class Noun(NamedTuple):
    """One thing.

    ``names`` has two parts. Before the semicolon: other names of the same thing, of which nothing
    is reported. After it: narrower or neighbouring things, which are made as this one; a note
    states that.

    ``looks`` says what its parts look like by nature, in the order of the family's solids and of
    the pictures' part index. A part's text is its role, its sRGB colour, and what may follow: a
    pattern ("." is none) and a finish, both by name in ``palette``. Roles: ``*`` is what a colour
    word is about; ``+`` is an accent and keeps its colour until a second one is stated; ``&`` is an
    accent that goes with the first colour until then; ``~`` is a marking in a shade of what it lies
    on; ``-`` keeps its nature; ``?`` is a marking that is drawn only where the prompt states
    something of it. Material words are about all but the last two.
    """

    names: str
    looks: dict[str, str]
    usual: Usual
    # The thing whose solid it is, and whose rows the networks have; "": its own. Its parts are that
    # one's, in the same order, by whatever name, but for what is a marking or left out at the end.
    solid: str = ""
    # Whether it is put together from simple solids (``constructed/``); no network has a row of it.
    constructed: bool = False
