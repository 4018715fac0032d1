"""Crates, drums and other props with another thing's solid."""

from core.guidance.builtin.nouns.noun import STEEL, WOOD, Noun, Usual

CRATES_AND_DRUMS = {
    "sci-fi crate": Noun(
        "scifi crate, futuristic crate, space crate, sci-fi box, sci-fi "
        "container, futuristic box, sci-fi chest; cyberpunk crate",
        {
            "panels": "*3d444d . metal",
            "frame": "+69727d . metal",
            "lights": "-35dcec",
            "vents": "-15181c . metal",
            "stripes": "-e9b02c . paint",
            "bolts": "-23282e . metal",
        },
        Usual(0.8, STEEL, 0.02),
        "crate",
    ),
    "ammo crate": Noun(
        "ammo box, ammunition crate, ammunition box, military crate, weapon crate, ammo chest, "
        "weapons crate, army crate, military box",
        {
            "planks": "*686b3c grain",
            "frame": "&4f5230 grain",
            "letters": "-e9e4cf . paint",
            "clasps": "-8c9094 . metal",
            "star": "-e9e4cf . paint",
            "seams": "~3c3f22 grain",
            "bolts": "-8c9094 . metal",
        },
        Usual(0.6, WOOD, 0.15),
        "crate",
    ),
    "oil drum": Noun(
        "oil barrel, steel drum, fuel drum, metal barrel, steel barrel, metal drum, fuel barrel, "
        "iron barrel, petrol barrel, gasoline barrel; industrial drum",
        {
            "body": "*2c5c93 . paint",
            "bands": "~21456f . paint",
            "letters": "-f1ede0 . paint",
            "bung": "-c9cdd1 . metal",
            "rims": "-8f969c . metal",
        },
        Usual(0.88, STEEL, 0.013),
        "cylinder",
    ),
    "toxic barrel": Noun(
        "toxic waste barrel, radioactive barrel, toxic drum, nuclear barrel, radioactive waste "
        "barrel, hazardous barrel, hazmat barrel, nuclear waste barrel, biohazard barrel, "
        "chemical barrel, toxic waste drum; explosive barrel, exploding barrel",
        {
            "body": "*e8b820 . paint",
            "sign": "-1b1b1d . paint",
            "stripes": "-1b1b1d . paint",
            "bung": "-c9cdd1 . metal",
            "rims": "-4b5056 . metal",
            "goo": "-7be02f",
            "bands": "~b98f14 . paint",
        },
        Usual(0.88, STEEL, 0.013),
        "cylinder",
    ),
    "manhole cover": Noun(
        "manhole, man hole cover, sewer cover, sewer lid, manhole lid, drain cover",
        {
            "body": "*565a5f . metal",
            "studs": "~7b8085 . metal",
            "rings": "~6c7176 . metal",
            "holes": "-141518",
        },
        Usual(0.65, STEEL, 0.3),
        "desk lamp",
    ),
    "landmine": Noun(
        "land mine, anti-tank mine, anti-personnel mine, mine bomb, proximity mine, landmines",
        {
            "body": "*5c6138 . paint",
            "light": "-ff3b2f",
            "plate": "+7a7f52 . metal",
            "bolts": "-a9aeb2 . metal",
            "ribs": "~474b2a . paint",
            "stripes": "-e6b42c . paint",
        },
        Usual(0.3, STEEL, 0.3),
        "desk lamp",
    ),
}
