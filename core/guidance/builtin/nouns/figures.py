"""A person, a knight, an alien, a ghost, plain toys, and three creatures of tales."""

from core.guidance.builtin.nouns.noun import FABRIC, FLESH, SNOW, STEEL, Noun, Usual

FIGURES = {
    "person": Noun(
        "human, man, woman; guy, lady, character, figure, prince, human being, businessman, "
        "doctor, nurse, teacher, farmer, gladiator, monk, athlete, dancer, ballerina, robber, "
        "detective, worker, construction worker, basketball player, soccer player, football "
        "player, sailor, student, mannequin, mannikin, villager, peasant, archer, bard, cleric, "
        "priest, nun, geisha, grandma, grandpa, npc, character model, waiter, scientist, diver, "
        "scuba diver, merchant, ranger, blacksmith, butler, healer, mechanic, pilot, librarian, "
        "shepherd, shepherdess, "
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
    "teddy bear": Noun(
        "teddy; stuffed bear, plush bear, plushie, stuffed animal, plush toy, stuffed toy, "
        "soft toy, cuddly toy; gummy bear, gummi bear, gummybear",
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
        Usual(2.4, FLESH, 0.97),
        constructed=True,
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
        Usual(6.0, FLESH, 0.57),
        constructed=True,
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
        Usual(12.0, FLESH, 0.29),
        constructed=True,
    ),
}
