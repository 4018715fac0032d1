"""Landmarks, pools and webs, put together from simple solids."""

from core.guidance.builtin.nouns.noun import SNOW, STEEL, STONE, Noun, Usual

SIGHTS = {
    "swimming pool": Noun(
        "pool, swim pool, outdoor pool; paddling pool, lap pool",
        {
            "rim": "*e8e2d4 . stone",
            "water": "-3fb3dc . glass",
            "ladder": "-c9ced2 . metal",
            "board": "&f4f2ec",
        },
        Usual(8.0, STONE, 0.4),
        constructed=True,
    ),
    "spider web": Noun(
        "cobweb, spiderweb, spider's web, web, spiders web",
        {"web": "*eef0f2", "spider": "-1d1b1c"},
        Usual(0.6, SNOW, 0.1),
        constructed=True,
    ),
    "eiffel tower": Noun(
        "the eiffel tower, paris tower; radio tower, lattice tower, transmission tower",
        {"iron": "*7a6650 . metal", "decks": "&5f4f3f . metal", "feet": "-b9b2a5 . stone"},
        Usual(300.0, STEEL, 0.05),
        constructed=True,
    ),
    "stonehenge": Noun(
        "stone henge; henge, megalith, standing stones, dolmen",
        {"stones": "*9a968d . stone", "grass": "-6f9a45"},
        Usual(30.0, STONE),
        constructed=True,
    ),
}
