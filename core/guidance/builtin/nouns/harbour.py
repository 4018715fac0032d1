"""From the harbour to the town and to space: ships, cars, great houses and gates."""

from core.guidance.builtin.nouns.noun import STEEL, STONE, WOOD, Noun, Usual
from core.guidance.builtin.nouns.vehicles import GLASS_LOOK, TYRES_LOOK

HARBOUR = {
    "yacht": Noun(
        "yachts, motor yacht, motor yachts, luxury yacht, super yacht, superyacht, mega yacht, "
        "megayacht, motoryacht, private yacht; cabin cruiser, motor cruiser, pleasure boat",
        {
            "hull": "*f1eee6 . paint",
            "keel": "+1f5fa8 . paint",
            "deck": "+b97a42 . wooden",
            "cabin": "&e9e6dd . paint",
            "windows": GLASS_LOOK,
            "mast": "+c3c8cd . paint",
            "portholes": "-25303a . glass",
        },
        Usual(35.0, STEEL, 0.006),
    ),
    "cruise ship": Noun(
        "cruise ships, cruise liner, cruise liners, ocean liner, ocean liners, cruiseship, "
        "passenger ship, passenger liner; titanic, passenger ferry, steamship, cruise boat",
        {
            "hull": "*1f3f78 . paint",
            "keel": "+b3302a . paint",
            "decks": "+f3f0e8 . paint",
            "windows": "-3f7fae . glass",
            "funnel": "+d8392b . paint",
            "rim": "-2a2b30 . paint",
            "lifeboats": "+f08a24 . plastic",
            "portholes": "-ffe6a3 . glass",
        },
        Usual(300.0, STEEL, 0.004),
    ),
    "garbage truck": Noun(
        "garbage trucks, trash truck, rubbish truck, refuse truck, bin lorry, garbage lorry, "
        "rubbish lorry, refuse lorry, waste truck, dustcart, bin truck, waste collection truck; "
        "recycling truck, garbage collector",
        {
            "cargo": "*3f9b48 . paint",
            "cab": "+efece4 . paint",
            "hopper": "+8b9298 . metal",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "hubs": "-c9cdd1 . metal",
            "bags": "-2a2b30 . plastic",
            "lamps": "-f5a623 . plastic",
        },
        Usual(8.5, STEEL, 0.015),
    ),
    "trailer": Noun(
        "trailers, caravan, caravans, camper trailer, camping trailer, travel trailer, "
        "camping caravan, travel trailers, touring caravan, holiday caravan; airstream, "
        "teardrop trailer, static caravan, trailer home",
        {
            "body": "*f2ecdc . paint",
            "stripe": "+35a89c . paint",
            "windows": "-34495a . glass",
            "door": "&d97b3a . paint",
            "wheels": TYRES_LOOK,
            "hubs": "-b9bfc4 . metal",
            "awning": "+d8392f . fabric",
            "stripes": "+f4f0e8 . fabric",
        },
        Usual(5.5, STEEL, 0.009),
    ),
    "limousine": Noun(
        "limousines, limo, limos, stretch limousine, stretch limo, stretched limousine; "
        "presidential car, wedding car",
        {
            "body": "*26262c . paint",
            "windows": "-86abc4 . glass",
            "wheels": "-3a3a3e . rubber",
            "hubs": "-d8dadd . metal",
            "trim": "-c3c8cd . metal",
            "lamps": "+f7eec2",
        },
        Usual(8.5, STEEL, 0.02),
    ),
    "sleigh": Noun(
        "sleighs, santa sleigh, santa's sleigh, santas sleigh, christmas sleigh, santa claus "
        "sleigh, santa sled, santa's sled, horse sleigh, reindeer sleigh, one horse open sleigh; "
        "horse drawn sleigh, winter sleigh",
        {
            "body": "*c4231f . paint",
            "trim": "+e6b53a . golden",
            "seat": "+2f6b3c . fabric",
            "runners": "+d9a233 . golden",
            "sack": "+9a6a3c . fabric",
        },
        Usual(2.6, WOOD, 0.3),
    ),
}
HARBOUR_SPACE = {
    "space station": Noun(
        "space stations, orbital station, international space station, iss, space base, "
        "orbital space station; space colony, space habitat, starbase, skylab",
        {
            "core": "*eeebe4 . paint",
            "bands": "&8d949b . metal",
            "panels": "+2a55ad . glass",
            "arms": "-b98f3f . golden",
            "windows": "-ffd25e . glass",
            "dish": "-d5d8db . paint",
            "lines": "-cfd8e0",
        },
        Usual(100.0, STEEL, 0.004),
    ),
}
CIVIC = {
    "mansion": Noun(
        "mansions, manor, manor house, manors, country house, stately home, grand house, "
        "estate house, luxury mansion, victorian mansion, plantation house; "
        "chateau, embassy, town hall",
        {
            "walls": "*e6c887",
            "roof": "+4f6276",
            "columns": "+f4f0e8 . stone",
            "windows": "-6fa3cc . glass",
            "door": "-6b3a22",
            "chimney": "-9c5440",
        },
        Usual(30.0, STONE, 0.12),
    ),
    "hut": Noun(
        "huts, mud hut, mud huts, straw hut, thatched hut, african hut, round hut, grass hut, "
        "tribal hut, village hut, roundhouse; tiki hut, jungle hut, beach hut, "
        "native hut",
        {
            "walls": "*dfae7a",
            "roof": "+d8b04c thatch",
            "door": "-4a2e1c",
            "frame": "+6e4222 grain",
            "windows": "-33241a",
            "base": "&9a6a48 . stone",
            "band": "+7d4f2a . fabric",
            "zigzags": "-f3e4c4 . paint",
        },
        Usual(5.0, STONE, 0.15),
    ),
    "school": Noun(
        "schools, school house, schoolhouse, school building, elementary school, high school, "
        "primary school, schoolhouses; college, university, academy, kindergarten",
        {
            "walls": "*b5482f bricks",
            "roof": "+51606f",
            "trim": "+f1ebdc . paint",
            "windows": "-8cc4e6 . glass",
            "door": "-2f6fc4 . paint",
            "bell": "-e3b23c . golden",
            "hands": "-2a2b30 . metal",
            "frames": "-f6f2e6 . paint",
        },
        Usual(30.0, STONE, 0.12),
    ),
    "hospital": Noun(
        "hospitals, hospital building, infirmary; clinic, medical center, medical centre, "
        "health center, doctor's office, emergency room",
        {
            "walls": "*f2efe8 . paint",
            "roof": "+7fa6b8",
            "windows": "-4a90c4 . glass",
            "cross": "+d8261f . plastic",
            "canopy": "+c8453a . paint",
            "door": "-2f5f80 . glass",
            "frames": "-7fa6b8 . paint",
        },
        Usual(40.0, STONE, 0.12),
    ),
    "torii gate": Noun(
        "torii, torii gates, torii arch, japanese gate, japanese torii, japanese torii gate, "
        "shinto gate, shrine gate, japanese arch, japanese gates; japanese shrine gate, "
        "temple gate",
        {
            "pillars": "*d23a24 . paint",
            "lintel": "+2a2a30 . paint",
            "feet": "+8d8f8c . stone",
            "plaque": "+d9a83e . golden",
        },
        Usual(6.0, WOOD, 0.9),
    ),
}
