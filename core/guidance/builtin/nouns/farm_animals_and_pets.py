"""Animals of the farm and of the house."""

from core.guidance.builtin.nouns.noun import EYES_LOOK, FLESH, Noun, Usual

FARM_ANIMALS_AND_PETS = {
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
            "paws": "?f3efe8",
        },
        Usual(0.8, FLESH, 0.76),
    ),
    "corgi": Noun(
        "welsh corgi; dachshund, sausage dog",
        {
            "body": "*d08a44",
            "chest": "+f2ece2",
            "muzzle": "+f2ece2",
            "eyes": "-111111",
            "nose": "-1a1818",
            "paws": "?f3efe8",
        },
        Usual(0.6, FLESH, 0.67),
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
            "paws": "?f3efe8",
        },
        Usual(0.45, FLESH, 0.56),
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
            "paws": "?f3efe8",
        },
        Usual(0.35, FLESH, 0.6),
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
    "horse": Noun(
        "; pony, stallion, mare, foal, warhorse, racehorse, colt, clydesdale",
        {
            "body": "*8a5a34",
            "mane": "+2e211a",
            "hooves": "-3a322c",
            "eyes": "-111111",
            "glints": "-ffffff",
            "mouth": "-3a2416",
            "blaze": "-f2ece0",
            "socks": "?f3efe8",
        },
        Usual(2.4, FLESH, 0.6),
    ),
    "donkey": Noun(
        "donkeys, burro, gray donkey; mule, mules, baby donkey, foal donkey",
        {
            "body": "*8b8a90",
            "mane": "+38343a",
            "muzzle": "+ebe3d6",
            "hooves": "-2f2b2c",
            "nostrils": "-4a4044",
            "eyes": EYES_LOOK,
            "glints": "-ffffff",
            "ears": "-d8b0a6",
        },
        Usual(1.6, FLESH, 0.6),
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
            "socks": "?f3efe8",
        },
        Usual(2.3, FLESH, 0.54),
    ),
    "bull": Noun(
        "bulls, angry bull, raging bull, spanish bull; ox, oxen, bullock, longhorn, buffalo, "
        "bison, yak",
        {
            "body": "*74401f",
            "muzzle": "+d8a888",
            "horns": "-f0e4c8",
            "ring": "-e8b23a . golden",
            "hair": "&3a2118",
            "hooves": "-2b2320",
            "eyes": EYES_LOOK,
            "socks": "?f3efe8",
        },
        Usual(2.4, FLESH, 0.75),
    ),
    "sheep": Noun(
        "; lamb, ewe",
        {
            "wool": "*ece7da",
            "head": "+3a3431",
            "legs": "+3a3431",
            "eyes": "-f0f0f0",
            "pupils": "-121212",
            "curls": "~c9c2b0",
        },
        Usual(1.2, FLESH, 0.28),
    ),
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
    "rooster": Noun(
        "roosters, cockerel, gamecock; bantam",
        {
            "body": "*8e3a1e",
            "neck": "+e8982c",
            "wings": "&6a2a1a",
            "tail": "+1f5a58",
            "comb": "-d8281f",
            "bill": "-f0bc3c",
            "legs": "-eaa832",
            "eyes": "-1c1718",
        },
        Usual(0.6, FLESH, 0.2),
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
    "goose": Noun(
        "geese, farm goose, domestic goose; gander, gosling, canada goose, snow goose",
        {
            "body": "*f4f0e8",
            "wings": "&d9d6cc",
            "bill": "+f08a1e",
            "feet": "+e87a18",
            "eyes": EYES_LOOK,
            "feathers": "~a29e90",
            "glints": "-ffffff",
        },
        Usual(0.9, FLESH, 0.08),
    ),
    "turkey": Noun(
        "turkeys, turkey bird, wild turkey, live turkey, tom turkey; gobbler, grouse",
        {
            "body": "*4f3222",
            "wings": "&7a4e2e",
            "tail": "&a4572a",
            "tips": "+f0dcb2",
            "head": "-8fb0c8",
            "wattle": "-d2261e",
            "bill": "-eaa83a",
            "eyes": EYES_LOOK,
        },
        Usual(1.0, FLESH, 0.07),
    ),
}
