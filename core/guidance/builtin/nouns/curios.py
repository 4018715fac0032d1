"""A truck on huge wheels, a nest, lamps that hang and stand out, and a gas mask."""

from core.guidance.builtin.nouns.noun import PLANT, RUBBER, STEEL, Noun, Usual
from core.guidance.builtin.nouns.vehicles import GLASS_LOOK, TYRES_LOOK

CURIO_VEHICLES = {
    "monster truck": Noun(
        "monster trucks, monstertruck, bigfoot truck, big wheel truck; stunt truck, mud truck, "
        "lifted truck, off road truck",
        {
            "body": "*7a2bb5 . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "trim": "-d3d6d9 . metal",
            "chassis": "+8fd62a . paint",
            "lamps": "-fbf0b8",
            "flames": "+f6b21c . paint",
            "doors": "~471590 . paint",
        },
        Usual(5.5, STEEL, 0.02),
    ),
}
CURIO_PROPS = {
    "nest": Noun(
        "bird nest, bird's nest, birds nest, birdnest, nests, nest with eggs, nest of eggs, "
        "bird's nest with eggs, bird nest with eggs, songbird nest; robin nest, eagle nest, "
        "dragon nest, eyrie",
        {
            "bowl": "*7a5530",
            "twigs": "&9c7443",
            "straw": "&c9a765",
            "eggs": "-9ed3d6",
        },
        Usual(0.25, PLANT, 0.08),
    ),
    "paper lantern": Noun(
        "paper lanterns, chinese lantern, japanese lantern, red lantern, asian lantern, chochin, "
        "paper lamp, silk lantern; sky lantern, lunar new year lantern, festival lantern, "
        "floating lantern, rice paper lamp",
        {
            "globe": "*d8281f",
            "ribs": "&b01a16",
            "caps": "+2a2226 . paint",
            "loop": "-e0ab3a . golden",
            "tassels": "+f0b63c",
        },
        Usual(0.6, PLANT, 0.01),
    ),
}
CURIO_LAMPS = {
    "wall sconce": Noun(
        "sconce, wall lamp, wall light, sconces, wall lantern, wall mounted lamp; wall fixture, "
        "wall candle holder, candle sconce, gas light",
        {
            "plate": "*b58a3c . golden",
            "arm": "*b58a3c . golden",
            "cup": "&8f6a2a . golden",
            "shade": "+f3e6c8",
            "bulb": "-ffe9a8 . glass",
        },
        Usual(0.4, STEEL, 0.03),
    ),
    "pendant lamp": Noun(
        "pendant light, hanging lamp, hanging light, pendant lamps, ceiling pendant, suspension "
        "lamp, ceiling lamp, ceiling light; industrial lamp, billiard lamp, kitchen lamp",
        {
            "rose": "&2b2c2f . metal",
            "cable": "-1f2022 . rubber",
            "cap": "+c9963f . golden",
            "shade": "*1f6b66 . paint",
            "bulb": "-ffe39a . glass",
        },
        Usual(0.8, STEEL, 0.008),
    ),
}
CURIO_CLOTHES = {
    "gas mask": Noun(
        "gasmask, respirator, gas masks, respirator mask; dust mask, hazmat mask, military gas "
        "mask, breathing mask",
        {
            "mask": "*3f4636 . rubber",
            "lenses": "-8fb8bd . glass",
            "rims": "+9a9c98 . metal",
            "filters": "&59624a . paint",
            "caps": "-2a2c2b . metal",
            "straps": "-6b5a3c . fabric",
        },
        Usual(0.35, RUBBER, 0.055),
    ),
}
