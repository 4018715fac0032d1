"""Plants."""

from core.guidance.builtin.nouns.noun import CERAMIC, PLANT, STONE, WOOD, Noun, Usual

PLANTS = {
    "mushroom": Noun(
        "toadstool; fly agaric, amanita, fungus, truffle",
        {
            "cap": "*cc1a12 dots",
            "stem": "+e6d9bd",
            "underside": "-f3e6cc",
            "gills": "~cdb894",
        },
        Usual(0.1, PLANT, 0.4),
    ),
    "tree": Noun(
        "fir, conifer, fir tree, pine tree; cypress, evergreen, spruce tree, cedar tree",
        {"leaves": "*216b29", "trunk": "+613d21"},
        Usual(6.0, PLANT, 0.011),
    ),
    "cactus": Noun(
        "cacti; saguaro, cactus plant",
        {"body": "*3f8a45", "pot": "+b8623b", "spines": "-efe9c8"},
        Usual(0.4, PLANT),
    ),
    "flower": Noun(
        "daisy; potted flower, blossom, wildflower, daffodil, poppy, orchid, "
        "geranium, hydrangea, marigold, petunia, dahlia, chrysanthemum, "
        "primrose, pansy, begonia, magnolia, hibiscus, buttercup, gerbera",
        {"petals": "*f2f0e6", "heart": "+f2b81d", "stalk": "-3e8a36", "streaks": "~e6a6bd"},
        Usual(0.4, PLANT, 0.036),
    ),
    "palm": Noun(
        "palm tree; coconut tree",
        {"leaves": "*3f9038", "trunk": "+94683c", "nuts": "-5a3820"},
        Usual(8.0, PLANT, 0.039),
    ),
    "bush": Noun(
        "shrub, bushes; hedge, berry bush, bramble, rosebush, topiary, boxwood",
        {"leaves": "*37802f", "stems": "+5e4026"},
        Usual(1.2, PLANT, 0.05),
    ),
    "potted plant": Noun(
        "house plant, houseplant, plant in a pot, pot plant, plant; aloe, monstera, succulent, "
        "pot of flowers, aloe vera, ficus, fiddle leaf fig, fig tree, rubber plant, snake plant, "
        "peace lily, spider plant",
        {"leaves": "*3c8f3a", "pot": "+b8623b", "soil": "-3c281a"},
        Usual(0.6, PLANT, 0.4),
    ),
    "sunflower": Noun(
        "sunflowers",
        {"petals": "*f6c11c", "heart": "+4f2d14", "stalk": "-3e8a36", "seeds": "-2a1708"},
        Usual(1.6, PLANT, 0.025),
    ),
    "rose": Noun(
        "roses; peony, carnation, bouquet, peony flower",
        {"petals": "*c4122c", "stalk": "+35752f"},
        Usual(0.4, PLANT, 0.021),
    ),
    "tulip": Noun(
        "tulips; lily, crocus",
        {"petals": "*e5324a", "stalk": "+4f9a3c"},
        Usual(0.4, PLANT, 0.023),
    ),
    "bonsai": Noun(
        "bonsai tree; miniature tree",
        {"leaves": "*2f7030", "trunk": "+6b4528", "tray": "+35506e", "moss": "-6f8a3a"},
        Usual(0.4, PLANT, 0.4),
    ),
    "stump": Noun(
        "tree stump",
        {"bark": "*6a4a2e", "wood": "+d9b27a", "rings": "-a87c46"},
        Usual(0.7, WOOD),
    ),
    "log": Noun(
        "tree log, tree trunk; firewood, wooden branch, lumber",
        {"bark": "*6a4a2e", "wood": "+d9b27a", "furrows": "~432c1a"},
        Usual(1.2, WOOD),
    ),
    "boulder": Noun(
        "rocks; meteorite, asteroid, pebble, river stone, big rock, space rock, moon rock, "
        "rock formation, rocks pile, ore rock",
        {"rock": "*86827a . stone", "moss": "+6d8a3c"},
        Usual(1.2, STONE),
    ),
    "acorn": Noun(
        "acorns; hazelnut, nut, peanut, almond",
        {"nut": "*b5762f", "cap": "+6b4a28"},
        Usual(0.03, PLANT),
    ),
    "oak tree": Noun(
        "deciduous tree, leafy tree, broadleaf tree, apple tree; maple tree, elm, birch tree, "
        "beech tree, cherry tree, cherry blossom tree, blossom tree, fruit tree, orange tree, "
        "lemon tree, olive tree, autumn tree, chestnut tree, magic tree, ash tree, tree of life",
        {"leaves": "*3f8a2f", "trunk": "+6a4728"},
        Usual(12.0, PLANT, 0.0076),
    ),
    "coral": Noun(
        "corals; coral reef, anemone, sea anemone, seaweed",
        {"branches": "*ee6a5e", "stone": "+8d877c . stone"},
        Usual(0.3, STONE, 0.6),
    ),
    "seashell": Noun(
        "sea shell, shell, scallop, clam; conch, nautilus, oyster, mussel, pearl oyster",
        {"ribs": "*f0cdb0", "grooves": "&d99a7c", "hinge": "+e2b08e"},
        Usual(0.1, CERAMIC, 0.47),
    ),
}
