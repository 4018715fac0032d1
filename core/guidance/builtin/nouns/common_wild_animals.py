"""The best known wild animals, of the forest, the savanna, the sea and the garden."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

COMMON_WILD_ANIMALS = {
    "wolf": Noun(
        "; coyote, husky, hyena, jackal, wolfdog",
        {
            "body": "*77787a",
            "muzzle": "+d0cfca",
            "eyes": "-111111",
            "nose": "-1a1818",
            "tail": "&5c5d60",
            "glints": "-ffffff",
            "mouth": "-2a2422",
            "ears": "-d9a8a0",
        },
        Usual(1.3, FLESH, 0.38),
    ),
    "fox": Noun(
        "red fox; fox cub, kitsune",
        {
            "body": "*cf6a24",
            "tail tip": "+f0ece4",
            "muzzle": "+f0ece4",
            "eyes": "-111111",
            "nose": "-1a1818",
            "mouth": "-2a1c18",
        },
        Usual(0.9, FLESH, 0.3),
    ),
    "bear": Noun(
        "brown bear; grizzly, grizzly bear, polar bear, bear cub",
        {
            "body": "*6b4526",
            "muzzle": "+b08a5e",
            "eyes": "-111111",
            "nose": "-1a1818",
            "mouth": "-22160f",
            "glints": "-ffffff",
            "ears": "-b08a5e",
        },
        Usual(2.0, FLESH, 0.3),
    ),
    "deer": Noun(
        "; reindeer, stag, buck, doe, fawn, elk, antelope, gazelle, bambi, impala, caribou",
        {
            "body": "*a5703e",
            "antlers": "-d8c4a0",
            "muzzle": "+e6d6bc",
            "belly": "+efe6d6",
            "hooves": "-3a2c22",
            "eyes": "-111111",
            "nose": "-1a1818",
            "spots": "-f2e6d0",
        },
        Usual(2.0, FLESH, 0.4),
    ),
    "lion": Noun(
        "; lion king, lioness, lion cub",
        {
            "body": "*d0a052",
            "mane": "+7d4a1e",
            "muzzle": "&ecd9ae",
            "eyes": "-111111",
            "nose": "-4a2c22",
            "mouth": "-4a2c22",
        },
        Usual(2.2, FLESH, 0.32),
    ),
    "elephant": Noun(
        "; baby elephant",
        {
            "body": "*85868a",
            "ears": "&95919a",
            "tusks": "-efe6d0",
            "eyes": "-111111",
            "nails": "-e6dcc8",
        },
        Usual(5.0, FLESH, 0.26),
    ),
    "giraffe": Noun(
        "",
        {
            "body": "*d9a84e",
            "muzzle": "+ead6a8",
            "horns": "-6b4526",
            "eyes": "-111111",
            "patches": "-9a5a26",
        },
        Usual(4.8, FLESH, 0.37),
    ),
    "monkey": Noun(
        "; chimp, chimpanzee, orangutan, baboon, gibbon, lemur",
        {
            "body": "*6b452a",
            "face": "+dcb58c",
            "eyes": "-111111",
            "glints": "-ffffff",
            "nostrils": "-6b452a",
            "mouth": "-5a3420",
        },
        Usual(0.9, FLESH, 0.32),
    ),
    "bird": Noun(
        "songbird, birdie; origami crane, paper crane, sparrow, crow, raven, pigeon, dove, "
        "seagull, robin, bluebird, "
        "blackbird, canary, finch, woodpecker, hummingbird, magpie, kingfisher, cardinal, blue "
        "jay, cuckoo, swallow, starling, puffin, pelican, nightingale, "
        "albatross",
        {
            "body": "*4f83bd",
            "belly": "+e0a066",
            "wings": "&345f98",
            "bill": "-e8a02a",
            "legs": "-8a5a34",
            "eyes": "-111111",
            "feathers": "~22466f",
            "glints": "-ffffff",
        },
        Usual(0.2, FLESH, 0.17),
    ),
    "owl": Noun(
        "; barn owl, snowy owl, owlet",
        {
            "body": "*8a6642",
            "belly": "+e2cea8",
            "wings": "&6b4a2c",
            "eyes": "-f2b41c",
            "pupils": "-111111",
            "bill": "-d99a2c",
            "feathers": "~442e18",
            "bars": "-8a6642",
        },
        Usual(0.5, FLESH, 0.069),
    ),
    "penguin": Noun(
        "; emperor penguin, baby penguin",
        {
            "body": "*26282e",
            "belly": "+f2f0ea",
            "wings": "&26282e",
            "bill": "-f09a1e",
            "feet": "-f09a1e",
            "eyes": "-111111",
            "glints": "-ffffff",
        },
        Usual(0.8, FLESH, 0.19),
    ),
    "whale": Noun(
        "; blue whale, humpback, humpback whale, sperm whale, beluga, narwhal, blue whales, "
        "humpback whales",
        {
            "body": "*3f6488",
            "belly": "+dfe6ea",
            "fins": "&33547a",
            "eyes": "-111111",
            "glints": "-ffffff",
            "grooves": "~7f9bb0",
        },
        Usual(12.0, FLESH, 0.24),
    ),
    "dolphin": Noun(
        "; porpoise",
        {
            "body": "*6f93ad",
            "belly": "+e4ecef",
            "eyes": "-111111",
            "glints": "-ffffff",
            "mouth": "-3a4a58",
        },
        Usual(2.4, FLESH, 0.26),
    ),
    "shark": Noun(
        "; great white shark, hammerhead, hammerhead shark, megalodon, shark fish",
        {
            "body": "*5f7180",
            "belly": "+e8ebea",
            "mouth": "-7a1f24",
            "teeth": "-f4f2ec",
            "eyes": "-111111",
            "glints": "-ffffff",
            "gills": "~36444f",
        },
        Usual(4.0, FLESH, 0.22),
    ),
    "fish": Noun(
        "; goldfish, salmon, trout, tuna, piranha, carp, cod, anglerfish, swordfish, lionfish, "
        "catfish, angelfish, betta fish, barracuda",
        {
            "body": "*ef7d1a",
            "fins": "+f5b03c",
            "eyes": "-111114",
            "whites": "-f4f2ec",
            "lips": "-d8601a",
            "scales": "~d0641a",
        },
        Usual(0.3, FLESH, 0.31),
    ),
    "octopus": Noun(
        "octopi; squid, kraken, cuttlefish, cthulhu",
        {
            "body": "*c2513f",
            "suckers": "+f0c4a8",
            "eyes": "-f4f2ec",
            "pupils": "-111111",
            "spots": "~93352a",
            "mouth": "-4a1812",
        },
        Usual(1.0, FLESH, 0.072),
    ),
    "crab": Noun(
        "; king crab, hermit crab, prawn, shrimp",
        {
            "body": "*d2432a",
            "claws": "&d2432a",
            "legs": "&b53722",
            "belly": "+efc79a",
            "eyes": "-111111",
            "glints": "-ffffff",
            "spots": "~9a2418",
        },
        Usual(0.25, FLESH, 0.59),
    ),
    "turtle": Noun(
        "; tortoise",
        {
            "shell": "*6b5a2c plates",
            "body": "+6da84a",
            "eyes": "-111111",
            "glints": "-ffffff",
            "mouth": "-3a5a22",
            "spots": "~4a8a2e",
        },
        Usual(0.4, FLESH),
    ),
    "frog": Noun(
        "; toad, tree frog, bullfrog, tadpole",
        {
            "body": "*5a9c2e",
            "belly": "+e0dfa0",
            "mouth": "-3a5a1e",
            "eyes": "-f0b428",
            "pupils": "-111111",
            "spots": "~3c7418",
            "nostrils": "-2a4212",
            "glints": "-ffffff",
        },
        Usual(0.1, FLESH, 0.43),
    ),
    "snake": Noun(
        "serpent; cobra, rattlesnake, viper, python, anaconda, boa, boa constrictor, "
        "adder, eel, worm, earthworm",
        {
            "body": "*5c8a34",
            "belly": "+d8cf8a",
            "eyes": "-e8b41c",
            "tongue": "-c2222c",
            "pupils": "-16120e",
            "grooves": "~a89f5c",
            "bands": "~35561c",
        },
        Usual(0.5, FLESH, 0.26),
    ),
    "snail": Noun(
        "",
        {
            "body": "+c9a878",
            "shell": "*8f5a2e",
            "eyes": "-1a1512",
            "glints": "-ffffff",
            "whorl": "~5a3417",
        },
        Usual(0.08, FLESH),
    ),
    "spider": Noun(
        "; tarantula, black widow, tick",
        {
            "body": "*3b2f2a",
            "legs": "&4f3e34",
            "eyes": "-c22a22",
            "fangs": "-1a1412",
            "pupils": "-140c0a",
            "cross": "-c22a22",
        },
        Usual(0.1, FLESH, 0.33),
    ),
    "bee": Noun(
        "; honeybee, honey bee, bumblebee, bumble bee, wasp, hornet, fly, housefly, "
        "mosquito, firefly",
        {
            "body": "*f2b81c",
            "stripes": "+221c18",
            "head": "+2a221c",
            "wings": "+cfe2ea",
            "eyes": "-e8e4dc",
            "pupils": "-14100e",
            "veins": "~7fa3b3",
        },
        Usual(0.02, FLESH, 0.24),
    ),
    "butterfly": Noun(
        "butterflies; moth, monarch butterfly, butterfly wings",
        {
            "wings": "*ee7d1a",
            "edges": "+1f1a17",
            "body": "-2b221c",
            "eyes": "-6b4a2c",
            "dots": "-f6f2e8",
        },
        Usual(0.1, FLESH, 0.011),
    ),
}
