"""Clothes, gloves and shoes."""

from core.guidance.builtin.nouns.noun import FABRIC, LEATHER, RUBBER, Noun, Usual

CLOTHES_AND_SHOES = {
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
    "jacket": Noun(
        "coat, hoodie, jackets, zip hoodie, bomber jacket, biker jacket, winter jacket, hooded "
        "jacket; jean jacket, parka, raincoat, blazer, cardigan, anorak, overcoat, trench coat, "
        "winter coat, tracksuit top, varsity jacket, suit, tuxedo, suit jacket, lab coat, robe, "
        "bathrobe, life jacket",
        {
            "body": "*8a4f2d . leather",
            "shirt": "+ece6d8 . fabric",
            "collar": "&4f2b19 . leather",
            "cuffs": "&4f2b19 . leather",
            "pockets": "&6b3a22 . leather",
            "zip": "-d3b25a . golden",
            "seams": "~5f361f . leather",
        },
        Usual(0.75, FABRIC, 0.06),
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
    "scarf": Noun(
        "scarves, winter scarf, wool scarf, woolen scarf, knitted scarf; shawl, neckerchief, "
        "bandana, bandanna, headscarf",
        {
            "wool": "*bd2a2e . fabric",
            "stripes": "+f4efe4 . fabric",
            "fringes": "+f4efe4 . fabric",
            "knot": "&a82428 . fabric",
            "lines": "~8f2226 . fabric",
        },
        Usual(0.6, FABRIC, 0.03),
    ),
    "necktie": Noun(
        "tie, neck tie, neckties, business tie; cravat, school tie",
        {
            "blade": "*1f3f86 . fabric",
            "knot": "&18326c . fabric",
            "stripes": "+d8b04a . fabric",
            "tail": "&16305f . fabric",
            "loop": "&1a3874 . fabric",
        },
        Usual(0.6, FABRIC, 0.3),
    ),
    "bow tie": Noun(
        "bowtie; hair bow",
        {"body": "*b01f2c . fabric", "knot": "&8a1620 . fabric", "folds": "-6e1019"},
        Usual(0.12, FABRIC, 0.6),
    ),
    "belt": Noun(
        "belts, leather belt, waist belt; utility belt, champion belt, gun belt, buckle belt",
        {
            "strap": "*6b4226 . leather",
            "buckle": "+d9ab48 . golden",
            "keeper": "&5a3620 . leather",
            "holes": "-1c120c",
        },
        Usual(0.35, LEATHER, 0.15),
    ),
    "dog collar": Noun(
        "dog collars, collar, pet collar, cat collar",
        {
            "strap": "*a5252c . leather",
            "buckle": "+d9ab48 . golden",
            "keeper": "&8a1e24 . leather",
            "holes": "-1c120c",
        },
        Usual(0.14, LEATHER, 0.15),
        "belt",
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
    "sock": Noun(
        "socks, pair of socks, stocking; christmas stocking, stockings, christmas sock, "
        "ankle sock, football sock",
        {
            "body": "*c4262c . fabric",
            "cuff": "+f4efe4 . fabric",
            "heel": "+f4efe4 . fabric",
            "toe": "+f4efe4 . fabric",
            "stripes": "+f4efe4 . fabric",
        },
        Usual(0.4, FABRIC, 0.025),
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
    "sandal": Noun(
        "flip flop, slipper, sandals, flip flops, slippers, thong sandal, beach sandal, "
        "flipflop, flipflops; slide sandal, birkenstock, beach slipper",
        {
            "sole": "&7a5230 . rubber",
            "footbed": "*d9b07a . leather",
            "straps": "+b8432e . leather",
            "edges": "-f0e4cc . rubber",
            "buckles": "-e0b84a . golden",
        },
        Usual(0.28, RUBBER, 0.2),
    ),
}
