"""Things that are worn or carried."""

from core.guidance.builtin.nouns.noun import (
    FABRIC,
    GOLD,
    LEATHER,
    PLASTIC,
    RUBBER,
    STEEL,
    Noun,
    Usual,
)

CLOTHES = {
    "watch": Noun(
        "wristwatch, wrist watch; smartwatch, rolex",
        {
            "strap": "*5a3520",
            "case": "+d8b04a . golden",
            "face": "-f2efe6",
            "hands": "-1c1c20",
            "marks": "-1c1c20",
        },
        Usual(0.08, STEEL, 0.21),
    ),
    "sneaker": Noun(
        "shoe, trainer, running shoe, sneakers, shoes, gym shoe; loafer, trainers, clog, moccasin",
        {
            "body": "*c9302a . fabric",
            "sole": "+f0eee8 . rubber",
            "laces": "-f7f5f0",
            "stripes": "-f7f5f0",
            "toe": "&f0eee8 . rubber",
            "lines": "~c9302a . rubber",
        },
        Usual(0.3, RUBBER, 0.14),
    ),
    "boot": Noun(
        "boots; rain boot, wellington, cowboy boot, wellies, wellington boots, gumboots",
        {
            "body": "*6b4226",
            "sole": "-2a211b . rubber",
            "cuff": "+8a5a34",
            "strap": "-3a2617",
            "stitches": "-d2b684",
        },
        Usual(0.32, LEATHER, 0.12),
    ),
    "high heel": Noun(
        "high heels, high heeled shoe, high heeled shoes, high heel shoe, high heel shoes, "
        "stiletto, pump, lady's shoe",
        {
            "body": "*c2182c . paint",
            "heel": "&8f1020 . paint",
            "sole": "-2a1c1a",
            "bow": "+d8b04a . golden",
        },
        Usual(0.24, LEATHER, 0.65),
    ),
    "helmet": Noun(
        "motorcycle helmet, knight helmet, knight's helmet; hard hat, viking helmet, "
        "bike helmet, bicycle helmet, army helmet, military helmet, space helmet, football helmet, "
        "construction helmet, safety helmet, racing helmet, crash helmet, firefighter helmet, "
        "fireman helmet, fire helmet, roman helmet, spartan helmet, samurai helmet, diving helmet",
        {
            "shell": "*9aa1a9 . metal",
            "visor": "-17191d . glass",
            "crest": "+b8231f",
            "rim": "&6e747b . metal",
            "breaths": "-2a2d31",
        },
        Usual(0.33, PLASTIC, 0.087),
    ),
    "baseball cap": Noun(
        "cap, ball cap; visor, trucker hat, trucker cap, snapback, flat cap, newsboy cap, "
        "peaked cap, police cap, police hat, deerstalker",
        {
            "cap": "*2a56a8 . fabric",
            "brim": "+c9302a . fabric",
            "button": "-c9302a",
            "badge": "-f4f2ec",
            "seams": "~1c3c7c . fabric",
            "star": "-c9302a",
        },
        Usual(0.28, FABRIC, 0.3),
    ),
    "glove": Noun(
        "gloves, mitten, mittens; gauntlet, oven mitt",
        {
            "body": "*b5342c . fabric",
            "cuff": "+ece6da . fabric",
            "band": "-7a211c",
            "motif": "-fbf7ee",
            "ribs": "~cfc8b8",
        },
        Usual(0.25, FABRIC, 0.21),
    ),
    "backpack": Noun(
        "rucksack, school bag, schoolbag, knapsack, back pack; schoolbag bag",
        {
            "body": "*2f6f9e . fabric",
            "pocket": "&265a82 . fabric",
            "flap": "+e0a52e . fabric",
            "straps": "-33363c . fabric",
            "handle": "-33363c . fabric",
            "buckles": "-c7cacf . metal",
            "badge": "-f4f1e8 . fabric",
            "zips": "-c7cacf . metal",
        },
        Usual(0.5, FABRIC, 0.12),
    ),
    "handbag": Noun(
        "purse, hand bag, bag; tote bag, clutch, wallet, satchel, messenger bag, shoulder bag",
        {
            "body": "*a8452e",
            "flap": "&8c3725",
            "handle": "+5a2a1c",
            "clasp": "-e0b84a . golden",
            "piping": "-e0b84a . golden",
            "quilting": "~7a2e1c",
        },
        Usual(0.32, LEATHER, 0.2),
    ),
    "suitcase": Noun(
        "travel case, luggage, trolley case; carry on, travel bag, travel trunk",
        {
            "body": "*a5683a",
            "bands": "+4a2c18",
            "handle": "-2c2420",
            "feet": "-26221f",
            "locks": "-d8b04a . golden",
            "stickers": "-e8d9a8",
            "seam": "-3a2213 . leather",
        },
        Usual(0.7, LEATHER, 0.081),
    ),
    "shirt": Noun(
        "t-shirt, tshirt, tee shirt, t shirt, tee; sweater, jumper, blouse, tank top, vest, "
        "sweatshirt, kimono, jersey, turtleneck, pajamas, pyjamas, polo shirt, t shirt dress, "
        "swimsuit, waistcoat, onesie, bikini",
        {
            "body": "*3f7fc0 . fabric",
            "cuffs": "&336ba5 . fabric",
            "collar": "+f0eee8 . fabric",
            "buttons": "-f7f5f0",
            "seams": "~2c5c90 . fabric",
            "pocket": "~2c5c90 . fabric",
        },
        Usual(0.75, FABRIC, 0.019),
    ),
    "trousers": Noun(
        "pants, jeans, pair of trousers, pair of pants, jean; shorts, leggings, chinos, "
        "sweatpants, overalls, dungarees, tights",
        {
            "body": "*35588c . fabric",
            "belt": "+5a3a20",
            "buckle": "-d8b04a . golden",
            "cuffs": "&4a70a8 . fabric",
            "pockets": "-2b4872 . fabric",
            "seams": "~233c62 . fabric",
        },
        Usual(1.0, FABRIC, 0.017),
    ),
    "dress": Noun(
        "gown, frock, wedding dress, evening gown; skirt, ballgown, sundress, tutu, toga, kilt",
        {
            "skirt": "*c23a78 . fabric",
            "body": "*c23a78 . fabric",
            "belt": "+f0d9e4",
            "hem": "&e58fb4 . fabric",
            "bow": "-f0d9e4",
            "sleeves": "*c23a78 . fabric",
            "pleats": "~9c2860 . fabric",
        },
        Usual(1.2, FABRIC, 0.0052),
    ),
    "wizard hat": Noun(
        "witch hat, wizard's hat, witch's hat, magic hat; party hat, birthday hat, "
        "sorcerer hat, mage hat, halloween hat, dunce cap",
        {
            "body": "*3a2f86 . fabric",
            "ribbon": "+1f1a4a",
            "stars": "-f4cf3a",
            "buckle": "-e0b84a . golden",
        },
        Usual(0.45, FABRIC, 0.053),
    ),
    "cowboy hat": Noun(
        "stetson; sombrero, fedora, straw hat, sun hat, panama hat, sheriff hat, bucket "
        "hat, sunhat, fedora hat, trilby, safari hat, pith helmet",
        {
            "body": "*9a6a3c . fabric",
            "band": "+4a2a16",
            "buckle": "-d5d8dc . metal",
            "star": "-e8b93c . golden",
            "stitches": "~5c3a1c",
            "studs": "-d5d8dc . metal",
        },
        Usual(0.4, FABRIC, 0.2),
    ),
    "bow tie": Noun(
        "bowtie; ribbon bow, hair bow, gift bow",
        {"body": "*b01f2c . fabric", "knot": "&8a1620 . fabric", "folds": "-6e1019"},
        Usual(0.12, FABRIC, 0.6),
    ),
    "medal": Noun(
        "medallion; badge, rosette",
        {
            "medal": "*e8b93c . golden",
            "ribbon": "+2450a0 . fabric",
            "stripe": "-f2f0ea . fabric",
            "star": "&c8922a . golden",
            "rim": "&c8922a . golden",
            "beads": "&c8922a . golden",
            "edges": "-f2f0ea . fabric",
        },
        Usual(0.14, GOLD, 0.043),
    ),
    "sunglasses": Noun(
        "shades, sun glasses; glasses, spectacles, eyeglasses, eye glasses, aviators, reading "
        "glasses, 3d glasses",
        {"frame": "*1f1f22", "glasses": "-2d3b46 . glass", "arms": "&1f1f22"},
        Usual(0.16, PLASTIC, 0.16),
    ),
    "cape": Noun(
        "capes, cloak, cloaks, superhero cape, super hero cape, superman cape, batman cape, "
        "vampire cape, hooded cloak; mantle, poncho, cowl",
        {
            "cloth": "*b01f2c . fabric",
            "collar": "&8a1620 . fabric",
            "clasp": "-d8b04a . golden",
        },
        Usual(1.3, FABRIC, 0.1),
    ),
}
