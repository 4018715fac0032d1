"""Trees, flowers and other plants; logs, cones and seashells."""

from core.guidance.builtin.nouns.noun import CERAMIC, PLANT, STONE, WOOD, Noun, Usual

PLANTS = {
    "tree": Noun(
        "fir, conifer, fir tree, pine tree; cypress, evergreen, spruce tree, cedar tree",
        {"leaves": "*216b29", "trunk": "+613d21"},
        Usual(6.0, PLANT, 0.011),
    ),
    "oak tree": Noun(
        "deciduous tree, leafy tree, broadleaf tree, apple tree; maple tree, elm, birch tree, "
        "beech tree, cherry tree, cherry blossom tree, blossom tree, fruit tree, orange tree, "
        "lemon tree, olive tree, autumn tree, chestnut tree, magic tree, ash tree, tree of life",
        {"leaves": "*3f8a2f", "trunk": "+6a4728"},
        Usual(12.0, PLANT, 0.0076),
    ),
    "palm": Noun(
        "palm tree; coconut tree",
        {"leaves": "*3f9038", "trunk": "+94683c", "nuts": "-5a3820"},
        Usual(8.0, PLANT, 0.039),
    ),
    "christmas tree": Noun(
        "xmas tree, decorated tree, decorated christmas tree, xmas fir, christmas fir, "
        "holiday tree; new year tree, yule tree",
        {
            "leaves": "*1f6b30",
            "trunk": "-5f3d21",
            "baubles": "+cf1f2b . glass",
            "beads": "+e8b93c . golden",
            "star": "-ffd23f . golden",
            "tub": "-8a2a24 . paint",
            "snow": "-f6fafc",
            "bands": "-e8b93c . golden",
        },
        Usual(2.0, PLANT, 0.02),
    ),
    "willow tree": Noun(
        "willow, willows, weeping willow, willow trees, weeping willow tree",
        {"leaves": "*7fa83e", "strands": "&a4c455", "trunk": "+6a4a30"},
        Usual(9.0, WOOD, 0.01),
    ),
    "bonsai": Noun(
        "bonsai tree; miniature tree",
        {"leaves": "*2f7030", "trunk": "+6b4528", "tray": "+35506e", "moss": "-6f8a3a"},
        Usual(0.4, PLANT, 0.4),
    ),
    "bush": Noun(
        "shrub, bushes; hedge, berry bush, bramble, rosebush, topiary, boxwood",
        {"leaves": "*37802f", "stems": "+5e4026"},
        Usual(1.2, PLANT, 0.05),
    ),
    "bamboo plant": Noun(
        "bamboo stalk, bamboo stem, bamboo tree, bamboo cane; bamboo shoot, bamboo forest, "
        "bamboo grove, lucky bamboo, sugar cane, sugarcane",
        {
            "stalks": "*6fa83c",
            "rings": "+b9cc6c",
            "leaves": "&3f8a35",
            "ground": "-6a4a2e",
        },
        Usual(3.0, PLANT, 0.012),
    ),
    "fern": Noun(
        "ferns, fern plant, forest fern, bracken, fern fronds; fern leaf, maidenhair fern",
        {"fronds": "*3f9a38", "ribs": "&8fc24e", "soil": "-4a3222"},
        Usual(0.8, PLANT, 0.1),
    ),
    "cactus": Noun(
        "cacti; saguaro, cactus plant",
        {"body": "*3f8a45", "pot": "+b8623b", "spines": "-efe9c8"},
        Usual(0.4, PLANT),
    ),
    "potted plant": Noun(
        "house plant, houseplant, plant in a pot, pot plant, plant; aloe, monstera, succulent, "
        "pot of flowers, aloe vera, ficus, fiddle leaf fig, fig tree, rubber plant, snake plant, "
        "peace lily, spider plant",
        {"leaves": "*3c8f3a", "pot": "+b8623b", "soil": "-3c281a"},
        Usual(0.6, PLANT, 0.4),
    ),
    "flower": Noun(
        "daisy; potted flower, blossom, wildflower, daffodil, poppy, orchid, "
        "geranium, hydrangea, marigold, petunia, dahlia, chrysanthemum, "
        "primrose, pansy, begonia, magnolia, hibiscus, buttercup, gerbera",
        {"petals": "*f2f0e6", "heart": "+f2b81d", "stalk": "-3e8a36", "streaks": "~e6a6bd"},
        Usual(0.4, PLANT, 0.036),
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
    "lily pad": Noun(
        "lily pads, lilypad, lilypads, water lily, water lilies, waterlily, waterlilies, lotus "
        "pad, lotus leaf, lily pad with flower, water lily pad, lotus, lotus flower, pink lotus, "
        "lotus blossom, lotuses; victoria lily",
        {
            "leaf": "*3f8f3a",
            "veins": "&6fb553",
            "petals": "+f08bb4",
            "heart": "-f5c93a",
        },
        Usual(0.35, PLANT, 0.5),
    ),
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
    "pinecone": Noun(
        "pine cone, fir cone; cedar cone, spruce cone, conifer cone, larch cone",
        {"core": "*5a3820", "scales": "*7a4c2a", "tips": "+b98a58", "stem": "-4a2f1c"},
        Usual(0.1, WOOD, 0.2),
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
    "potato": Noun(
        "spud, raw potato; sweet potato, yam, baked potato, new potato, ginger root",
        {"body": "*c69a5c", "spots": "-7a5530"},
        Usual(0.11, PLANT, 0.6),
    ),
    "cucumber": Noun(
        "; pickle, gherkin, zucchini, courgette, pickled cucumber",
        {
            "rind": "*2f7a35",
            "stripes": "&6fae4c",
            "flesh": "-c3e08e",
            "seeds": "-faf6da",
            "stem": "-5f8f3c",
        },
        Usual(0.26, PLANT, 0.3),
    ),
    "lettuce": Noun(
        "head of lettuce, lettuce head; cabbage, salad head, iceberg lettuce, head of cabbage, "
        "kale, bok choy, brussels sprout, artichoke, spinach, celery",
        {
            "head": "&a6d268",
            "leaves": "*58a83a",
            "frills": "&86c650",
            "ribs": "-dcebb4",
            "stalk": "-eef0cc",
        },
        Usual(0.25, PLANT, 0.2),
    ),
}
