"""What is magic, found or ancient; feathers, leaves, and what is in the sky."""

from core.guidance.builtin.nouns.noun import (
    COPPER,
    FABRIC,
    GLASS,
    GOLD,
    LEATHER,
    PLANT,
    PLASTIC,
    SNOW,
    STEEL,
    STONE,
    WOOD,
    Noun,
    Usual,
)

RELICS_AND_NATURE = {
    "magic wand": Noun(
        "magic wands, wand, wands, fairy wand, star wand, wizard wand, witch wand, magician wand, "
        "crystal wand, magical wand, enchanted wand, princess wand",
        {
            "shaft": "*4a2a6a . paint",
            "grip": "&37204f . leather",
            "bands": "+e8b93c . golden",
            "tip": "+ffd54a . plastic",
        },
        Usual(0.35, WOOD, 0.5),
    ),
    "crystal ball": Noun(
        "crystal balls, fortune teller ball, fortune teller's ball, magic crystal ball, fortune "
        "ball, scrying ball, seer's ball, magic orb, crystal orb, glowing orb, palantir, fortune "
        "telling ball; magic ball, scrying orb",
        {
            "ball": "*8a6be8 . glass",
            "stand": "+5b3420 grain",
            "claws": "+e0b03a . golden",
            "bands": "+e0b03a . golden",
            "glints": "-ffffff . plastic",
        },
        Usual(0.25, GLASS, 0.9),
    ),
    "crystal": Noun(
        "crystals, crystal cluster, cluster of crystals, crystal formation; amethyst, mana "
        "crystal, magic crystal, geode, mineral, minerals, ore, crystal shard, crystal shards",
        {"crystals": "*8a5ae0 . glass", "shards": "&a884f0 . glass", "rock": "-5e5a5c . stone"},
        Usual(0.3, STONE),
    ),
    "compass": Noun(
        "compasses, magnetic compass, pocket compass; compass rose",
        {
            "case": "*c9983a . golden",
            "dial": "-f0e6cc",
            "needle": "-d0241f",
            "tail": "-2b3440",
            "marks": "-3a3026",
            "loop": "&c9983a . golden",
        },
        Usual(0.08, COPPER, 0.2),
    ),
    "ingot": Noun(
        "ingots, gold bar, gold bars, bar of gold, bullion, gold bullion; silver bar, metal bar",
        {"bar": "*f0bf3e . golden", "stamp": "&d8a230 . golden"},
        Usual(0.2, GOLD, 0.53),
    ),
    "necklace": Noun(
        "necklaces, jewelled necklace; amulet, pendant, talisman, locket, choker, pearl necklace",
        {
            "chain": "*c9983a . golden",
            "beads": "*e8b93c . golden",
            "setting": "&e8b93c . golden",
            "stone": "+b0182c . glass",
            "bail": "&c9983a . golden",
        },
        Usual(0.25, GOLD, 0.02),
    ),
    "brazier": Noun(
        "braziers, fire bowl, firebowl, fire basket; fire pot, fire cauldron, sacrificial fire",
        {
            "bowl": "*3a3c40 . metal",
            "rim": "&4a4d52 . metal",
            "legs": "&3a3c40 . metal",
            "embers": "-c8341a",
            "flame": "-ff8c1a",
            "tongues": "-ffc23a",
        },
        Usual(1.1, STEEL, 0.02),
    ),
    "drinking horn": Noun(
        "viking horn, ale horn, mead horn, viking drinking horn; horn, war horn, powder horn,"
        " blowing horn, battle horn",
        {
            "horn": "*cdb48a",
            "rim": "+d8a83c . golden",
            "foam": "-f8f0dc",
            "tip": "+d8a83c . golden",
            "strap": "&6b4528 . leather",
            "stand": "-5f3c22 grain",
        },
        Usual(0.35, LEATHER, 0.15),
    ),
    "coffin": Noun(
        "coffins, casket; vampire coffin",
        {
            "body": "*5a3a20 grain",
            "lid": "*6b4424 grain",
            "panel": "&7a4f2a grain",
            "cross": "+d8a83c . golden",
            "handles": "+c79a3e . golden",
            "edge": "&5a3a20 grain",
            "nails": "-d8a83c . golden",
            "seams": "~2c1b0e grain",
        },
        Usual(2.1, WOOD, 0.04),
    ),
    "sack": Noun(
        "sacks, burlap sack; flour sack, money bag, moneybag, burlap bag, bag of money, bag "
        "of gold, coin bag, sack of flour, sack of potatoes, grain sack, sandbag, pouch, coin"
        " pouch, loot bag, sleeping bag, bag of chips, crisp packet, chip bag, potato bag, "
        "trash bag, garbage bag, bin bag, rubbish bag, plastic bag, paper bag",
        {
            "body": "*b99563 . fabric",
            "mouth": "&b99563 . fabric",
            "rope": "-6b4a28",
            "patch": "+8a6238 . fabric",
        },
        Usual(0.8, FABRIC, 0.5),
    ),
    "anchor": Noun(
        "anchors, ship anchor, boat anchor; ship's anchor",
        {
            "shank": "*3f474f . metal",
            "arms": "*3f474f . metal",
            "flukes": "&4c555e . metal",
            "stock": "&4c555e . metal",
            "ring": "+6a737c . metal",
        },
        Usual(1.2, STEEL, 0.1),
    ),
    "jetpack": Noun(
        "jet pack, jetpacks, jet packs, rocket pack; rocket backpack",
        {
            "tanks": "*c8ccd0 . metal",
            "noses": "+d0302a . paint",
            "pack": "+45494f . metal",
            "nozzles": "-5a5e64 . metal",
            "flames": "-ff9a1e",
            "straps": "-5a3a20 . leather",
        },
        Usual(1.1, STEEL, 0.018),
    ),
    "feather": Noun(
        "feathers, bird feather; quill, quill pen, plume, eagle feather",
        {"vane": "*eceae2", "tip": "+4a3a30", "shaft": "-d8c49c", "barbs": "~c9c6b8"},
        Usual(0.25, PLANT, 0.02),
    ),
    "leaf": Noun(
        "leaves, maple leaf, maple leaves; autumn leaf, autumn leaves, fall leaf, oak leaf",
        {"blade": "*cf4a1e", "veins": "&f0a03c", "stalk": "-8a4a22", "side veins": "~8f2d0e"},
        Usual(0.15, PLANT, 0.02),
    ),
    "beehive": Noun(
        "bee hive, beehives, bee hives, skep, hive; wasp nest, apiary, honey hive",
        {
            "coils": "*d8a03a",
            "bands": "&e8b850",
            "knob": "&d8a03a",
            "rim": "&a86f24",
            "entrance": "-2a1a0e",
            "board": "+7a4f2a grain",
        },
        Usual(0.55, PLANT, 0.1),
    ),
    "hay bale": Noun(
        "hay bales, haybale, haybales, bale of hay, straw bale, bale of straw, hay; haystack, "
        "hay stack, bale",
        {"straw": "*d8b04a thatch", "twine": "-8a4a2e", "stalks": "&e6c468", "lines": "~b08c36"},
        Usual(1.0, PLANT, 0.08),
    ),
    "cloud": Noun(
        "clouds, fluffy cloud; rain cloud, raincloud, storm cloud, thundercloud, whipped cream",
        {"middle": "*f4f6f8", "puffs": "*eef1f5", "ends": "*e6ebf1"},
        Usual(2.0, SNOW, 0.01),
    ),
    "sun": Noun(
        "suns, sunshine, sun symbol; sun rays, summer sun",
        {"disc": "*ffc91f", "rays": "*f79a1a", "glints": "*ffb52a"},
        Usual(1.0, PLASTIC, 0.2),
    ),
    "snowflake": Noun(
        "snowflakes, snow flake, snow flakes, ice crystal; snow crystal",
        {"arms": "*bfe4f7 . glass", "branches": "*d6effb . glass", "middle": "&9fd4f0 . glass"},
        Usual(0.3, PLASTIC, 0.3),
    ),
}
