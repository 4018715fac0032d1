"""Animals, and what is shaped like them."""

from core.guidance.builtin.nouns.noun import FABRIC, FLESH, SNOW, STEEL, Noun, Usual

ANIMALS = {
    "pig": Noun(
        "piggy; piglet, boar, wild boar, hog, warthog",
        {
            "body": "*eda3a6",
            "snout": "+d97f86",
            "eyes": "-151212",
            "nostrils": "-8f4a52",
            "glints": "-ffffff",
            "ears": "-d97f86",
        },
        Usual(1.2, FLESH, 0.68),
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
    "rabbit": Noun(
        "bunny, bunnies; hare",
        {
            "body": "*a58a70",
            "tail": "+f0ece4",
            "eyes": "-161212",
            "nose": "-d98a8f",
            "ears": "-e0a8a4",
            "belly": "+e6d8c6",
        },
        Usual(0.35, FLESH, 0.6),
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
    "duck": Noun(
        "; duckling, mallard",
        {
            "body": "*f7cf1f",
            "wings": "&f2bd14",
            "bill": "-ee7a14",
            "eyes": "-131313",
            "feathers": "~c98f0a",
            "glints": "-ffffff",
        },
        Usual(0.4, FLESH, 0.15),
    ),
    "teddy bear": Noun(
        "teddy; stuffed bear, plush bear, plushie, stuffed animal, plush toy, stuffed toy, "
        "soft toy, cuddly toy",
        {
            "body": "*96612f . fabric",
            "muzzle": "+d9b382 . fabric",
            "eyes": "-140f0c",
            "bow tie": "-c4161a . fabric",
            "mouth": "-3a2212",
            "paws": "&96612f . fabric",
            "stitches": "~a67f4e",
            "inner ears": "+d9b382 . fabric",
        },
        Usual(0.4, FABRIC, 0.3),
    ),
    "snowman": Noun(
        "snowmen",
        {
            "body": "*edf0f5",
            "nose": "-f27314",
            "buttons": "-0f0f0f",
            "arms": "-5a3a22 . wooden",
            "scarf": "-c02a2a . fabric",
            "hat": "+141417",
            "cheeks": "-f0a8a4",
            "ribbon": "+b02428 . fabric",
        },
        Usual(1.6, SNOW),
    ),
    "cat": Noun(
        "kitty, house cat; kitten, tomcat, lynx, bobcat, cougar, sphynx, calico cat, "
        "tuxedo cat, siamese cat, siamese, ginger cat, maine coon",
        {
            "body": "*8a7a68",
            "muzzle": "+e8e0d4",
            "eyes": "-111111",
            "nose": "-d98a8f",
            "whiskers": "-5a4a40",
        },
        Usual(0.45, FLESH, 0.56),
    ),
    "dog": Noun(
        "doggy, hound; puppy, labrador, beagle, retriever, golden retriever, "
        "shiba inu, shiba, german shepherd, chihuahua, terrier, "
        "rottweiler, doberman, pitbull, great dane, greyhound, sheepdog, collie, border "
        "collie, saint bernard, spaniel, cocker spaniel, dingo, jack russell, akita, "
        "pomeranian, maltese",
        {
            "body": "*b98a55",
            "ears": "&7a5632",
            "muzzle": "+e6d3b5",
            "eyes": "-111111",
            "nose": "-1a1818",
            "mouth": "-2a1c18",
        },
        Usual(0.8, FLESH, 0.76),
    ),
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
    "cow": Noun(
        "holstein, holstein cow, dairy cow; calf, cattle",
        {
            "body": "*ece8e0",
            "muzzle": "+e0a8a0",
            "horns": "-d8cba8",
            "eyes": "-111111",
            "udder": "-e0a8a0",
            "patches": "+2e2926",
            "nostrils": "-96605c",
        },
        Usual(2.3, FLESH, 0.54),
    ),
    "sheep": Noun(
        "; lamb, ewe",
        {
            "wool": "*ece7da",
            "head": "+3a3431",
            "legs": "+3a3431",
            "eyes": "-f0f0f0",
            "curls": "~c9c2b0",
        }
        | {"pupils": "-121212"},
        Usual(1.2, FLESH, 0.28),
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
    "horse": Noun(
        "; pony, stallion, mare, foal, warhorse, racehorse, colt, clydesdale",
        {
            "body": "*8a5a34",
            "mane": "+2e211a",
            "hooves": "-3a322c",
            "eyes": "-111111",
            "glints": "-ffffff",
            "nostrils": "-3a2416",
            "mouth": "-3a2416",
            "blaze": "-f2ece0",
        },
        Usual(2.4, FLESH, 0.6),
    ),
    "unicorn": Noun(
        "; baby unicorn, alicorn",
        {
            "body": "*f2eef2",
            "mane": "+e58fc4",
            "hooves": "-c9a24a",
            "eyes": "-1a1418",
            "horn": "-e8b93c",
            "glints": "-ffffff",
            "nostrils": "-b89ab0",
            "twist": "~b8862a",
        },
        Usual(2.4, FLESH, 0.66),
    ),
    "corgi": Noun(
        "welsh corgi; dachshund, sausage dog",
        {
            "body": "*d08a44",
            "chest": "+f2ece2",
            "muzzle": "+f2ece2",
            "eyes": "-111111",
            "nose": "-1a1818",
        },
        Usual(0.6, FLESH, 0.67),
    ),
    "dragon": Noun(
        "; wyvern, baby dragon, fire dragon, drake, baby drake, hydra, dragonling",
        {
            "body": "*3f8a3c",
            "belly": "+d9c878",
            "wings": "&2c6a34",
            "horns": "-e6dcc0",
            "eyes": "-f2c21c",
            "pupils": "-15120f",
            "ribs": "&3f8a3c",
            "grooves": "~bfa95c",
        },
        Usual(6.0, FLESH, 0.23),
    ),
    "dinosaur": Noun(
        "t-rex, t rex, trex, tyrannosaurus, dino; godzilla, allosaurus, tyrannosaurus rex, "
        "spinosaurus, iguanodon, theropod",
        {
            "body": "*6a8a3a",
            "belly": "+cfc48a",
            "teeth": "-f0ead8",
            "eyes": "-16140f",
            "glints": "-ffffff",
            "stripes": "~44601e",
            "nostrils": "-2e3a18",
        },
        Usual(12.0, FLESH, 0.11),
    ),
    "person": Noun(
        "human, man, woman; guy, lady, character, figure, prince, human being, businessman, "
        "doctor, nurse, teacher, farmer, gladiator, monk, athlete, dancer, ballerina, robber, "
        "detective, worker, construction worker, basketball player, soccer player, football "
        "player, sailor, student, mannequin, mannikin, villager, peasant, archer, bard, cleric, "
        "priest, nun, geisha, grandma, grandpa, npc, character model, waiter, scientist, diver, "
        "scuba diver, merchant, ranger, blacksmith, butler, healer, mechanic, pilot, librarian, "
        "engineer, painter, artist, photographer, rockstar, rock star, gamer, explorer, "
        "adventurer, builder, baseball player, racing driver, plague doctor, dentist, surgeon, "
        "cheerleader, mom, dad, bartender, butcher, musician, dj, miner, wrestler, boxer, surfer, "
        "skater, alchemist, captain, hiker, tourist, mailman, postman, plumber, carpenter, "
        "electrician, lumberjack, fisherman, gardener, janitor, cashier, barista, judge, lawyer, "
        "spy, hacker, singer, guitarist, drummer, hunter, bandit, guardian, trader, innkeeper, "
        "shopkeeper, lighthouse keeper, beekeeper, zookeeper, goalkeeper, beggar, bride, groom, "
        "swimmer, runner, footballer, cyclist, skateboarder, golfer, punk rocker, old man, old "
        "woman, young man, young woman",
        {
            "shirt": "*c23b34 . fabric",
            "skin": "-e0ac86",
            "hair": "-4a2f1e",
            "trousers": "+2f4a7a . fabric",
            "shoes": "-2a2422",
            "eyes": "-141414",
            "mouth": "-a8524a",
            "belt": "-3a2618",
        },
        Usual(1.75, FLESH, 0.38),
    ),
    "knight": Noun(
        "; paladin, crusader, suit of armor, suit of armour, warrior, templar, guard, royal "
        "guard, spartan, centurion, hoplite, sentinel",
        {
            "armour": "*a8adb4 . metal",
            "visor": "-141416",
            "plume": "+b82a28",
            "shield": "+b82a28",
            "sword": "-cfd3d8 . metal",
            "belt": "-4a3222 . leather",
            "breaths": "-141416",
        },
        Usual(1.9, STEEL, 0.03),
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
    "chicken": Noun(
        "; hen, chick, baby chick, quail, pheasant, partridge, chicken bird, seagull chick",
        {
            "body": "*f0e8d8",
            "wings": "&dccbab",
            "tail": "&c9b48c",
            "comb": "-d02a22",
            "bill": "-eda028",
            "legs": "-eda028",
            "eyes": "-111111",
            "feathers": "~b89f74",
        },
        Usual(0.45, FLESH, 0.2),
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
    "mouse": Noun(
        "mice; rat, chinchilla, ferret, shrew, mole, rodent",
        {
            "body": "*8f8a86",
            "ears": "+e3a9a4",
            "tail": "+d79c96",
            "feet": "+e3b4ac",
            "eyes": "-111111",
            "nose": "-d77f83",
            "glints": "-ffffff",
            "whiskers": "-3a3432",
        },
        Usual(0.15, FLESH, 0.15),
    ),
    "ghost": Noun(
        "; phantom, poltergeist, spectre, specter, wraith",
        {
            "body": "*eef0f4",
            "eyes": "-15151a",
            "mouth": "-15151a",
            "glints": "-ffffff",
            "cheeks": "-f0a8b4",
        },
        Usual(1.5, FABRIC, 0.017),
    ),
    "alien": Noun(
        "; martian, extraterrestrial, alien creature, little green man, extra terrestrial",
        {
            "skin": "*7fb24a",
            "suit": "+8d95a3",
            "shoes": "+3c414c",
            "eyes": "-0e0e12",
            "mouth": "-2f4a1e",
            "glints": "-ffffff",
        },
        Usual(1.4, FLESH, 0.19),
    ),
}
