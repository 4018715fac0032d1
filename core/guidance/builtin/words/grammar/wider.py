"""Words for a class, possible right behind a thing's name: "a corgi dog", "a lion cub".

Standard library only.
"""

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.grammar.lexicon import singulars
from core.guidance.builtin.words.tables.living import ANIMALS

_OF_GROUPS: dict[str, tuple[str, ...]] = {  # the groups of the things that may be called so
    "animal creature beast pet critter cub pup calf chick foal hatchling baby": ANIMALS,
    "monster": (*ANIMALS, "Characters"),
    "hero warrior": (*ANIMALS, "Characters"),
    "man woman boy girl guy lady person human kid child": ("Characters",),
    "fruit vegetable veg veggie berry": ("Fruit and Vegetables",),
    "food snack dish meal dessert treat": ("Food",),
    "vehicle": ("Vehicles", "Aircraft and Space"),
    "aircraft spacecraft": ("Aircraft and Space",),
    "building structure monument landmark": ("Buildings",),
    "weapon": ("Arms and Fantasy", "Props", "Tools and Toys", "Sport"),
    "instrument": ("Instruments",),
    "tool utensil": ("Tools and Toys", "Fixtures and Utensils", "Household", "Small Things"),
    "device gadget appliance machine": ("Electronics", "Household", "Fixtures and Utensils"),
    "furniture": ("Furniture", "Household"),
    "plant": ("Plants",),
    "garment clothing clothes outfit accessory": ("Clothes",),
    "prop item object asset": tuple(GROUPS),
}
_OF_THINGS = {  # the things that may be called so
    "dog puppy doggy doggie hound": "corgi, wolf, pug, poodle",
    "kitten cat": "tiger, lion, leopard",
    "bird": (
        "owl, penguin, chicken, parrot, eagle, duck, swan, flamingo, peacock, ostrich, "
        "rubber duck, phoenix, toucan, goose, turkey, rooster"
    ),
    "fish": "shark, dolphin, whale, seahorse, stingray, jellyfish, starfish",
    "insect bug": "ant, bee, beetle, butterfly, caterpillar, dragonfly, ladybug, spider, scorpion",
    "reptile": "snake, lizard, crocodile, turtle, dinosaur",
    "bear": "panda, koala, teddy bear",
    "monkey ape": "gorilla, monkey",
    "dinosaur dino": "triceratops, stegosaurus, dinosaur",
    "horse": "unicorn, zebra, rocking horse, centaur, pegasus, donkey",
    "car automobile": (
        "taxi, race car, sports car, jeep, van, go-kart, ambulance, golf cart, pickup truck"
    ),
    "truck lorry": (
        "fire truck, pickup truck, dump truck, cement mixer, forklift, bulldozer, jeep"
    ),
    "bike": "motorcycle, scooter, tricycle, bicycle",
    "boat ship vessel": (
        "sailboat, canoe, rowboat, pirate ship, raft, longship, cargo ship, submarine, spaceship, "
        "speedboat"
    ),
    "plane airplane aeroplane jet": "biplane, fighter jet, airplane, space shuttle",
    "flower": "sunflower, rose, tulip",
    "tree": "palm, bonsai, christmas tree, oak tree, bamboo plant",
    "hat": (
        "beanie, baseball cap, crown, wizard hat, cowboy hat, helmet, santa hat, chef hat, hard hat"
    ),
    "helmet": "viking helmet, motorcycle helmet, hard hat",
    "cap": "beanie, baseball cap",
    "house home": "modern house, cottage, log cabin, barn, igloo, treehouse",
    "building": "house, cottage, log cabin, barn, lighthouse",
    "tower": "lighthouse, water tower, windmill, skyscraper, pagoda",
    "sword blade": "dagger, lightsaber, katana",
    "guitar": "ukulele, banjo, electric guitar",
    "chair seat": (
        "armchair, office chair, rocking chair, throne, stool, bench, high chair, beanbag"
    ),
    "sofa couch": "armchair, bench",
    "table": "desk, coffee table, nightstand, counter, pool table",
    "bed": "four-poster bed, bunk bed, crib, hammock",
    "cabinet cupboard closet": "wardrobe, dresser, bookshelf, nightstand",
    "shelf": "bookshelf",
    "lamp light": (
        "lantern, floor lamp, desk lamp, chandelier, street lamp, candle, torch, lamp, light bulb, "
        "traffic light, flashlight, paper lantern, wall sconce, pendant lamp"
    ),
    "cake": "cupcake, pancakes",
    "shoe": "sneaker, sandal, high heel, boot, roller skate",
    "bag": "backpack, handbag, sack, suitcase",
    "robot": "mech, drone, robot arm",
    "gun firearm": "revolver, rifle, pistol",
    "cup": "mug, teacup, goblet, paper cup",
    "glass": "goblet, wine glass",
    "pot": "cooking pot, cauldron, kettle, teapot",
    "bottle": "flask, potion, perfume",
    "box": "chest, open chest, crate, gift, cardboard box, toolbox, beehive, mailbox",
    "computer pc": "laptop, desktop computer, monitor, computer tower",
    "piano": "grand piano",
    "sign": "stop sign, signpost",
    "chest": "open chest",
    "phone": "telephone",
    "tv": "television, monitor",
    "console": "arcade machine, game console, game controller",
    "clock": "grandfather clock",
    "wheel": "ferris wheel",
    "jewelry jewellery": "ring, necklace, crown, watch",
    "man woman boy girl": "knight, robot, snowman, skeleton, ghost, alien, golem",
}


def _wider() -> dict[str, frozenset[str]]:
    things: dict[str, set[str]] = {}
    for words, groups in _OF_GROUPS.items():
        for word in words.split():
            things.setdefault(word, set()).update(*(GROUPS[group] for group in groups))
    for words, names in _OF_THINGS.items():
        for word in words.split():
            things.setdefault(word, set()).update(names.split(", "))
    return {word: frozenset(names) for word, names in things.items()}


WIDER = _wider()


def is_wider(form: str, noun: str) -> bool:
    """Whether a word right behind the noun only names its class."""
    return any(noun in WIDER.get(one, ()) for one in singulars(form))
