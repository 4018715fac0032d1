"""What a thing's parts are of by nature where its row states no finish.

Looked for in this order: the part of the thing, the part of any thing, the thing, its group. Each
is a kind of detail (``core.texture.detail.kinds``). Standard library only.
"""

from functools import cache

from core.guidance.builtin.nouns import GROUPS

# How rough each kind is that is no material word.
ROUGHNESS = {
    "eye": 0.06,
    "wet skin": 0.25,
    "chitin": 0.3,
    "scales": 0.4,
    "skin": 0.5,
    "hide": 0.7,
    "hair": 0.5,
    "feathers": 0.75,
    "fur": 0.9,
    "bone": 0.4,
    "liquid": 0.05,
    "cream": 0.3,
    "leaf": 0.5,
    "foliage": 0.7,
    "petal": 0.6,
    "bark": 0.95,
    "peel": 0.3,
    "flesh": 0.35,
    "crust": 0.7,
    "crumb": 0.9,
    "paper": 0.85,
    "soil": 0.95,
    "wicker": 0.8,
    "flame": 0.5,
    "felt": 0.95,
    "velvet": 0.8,
    "clay": 0.85,
    "concrete": 0.9,
    "brick": 0.9,
    "masonry": 0.9,
    "thatch": 0.95,
}

# By the pattern of a part's look.
BY_PATTERN = {"grain": "wooden", "bricks": "masonry", "thatch": "thatch"}
# A part of one thing.
OF_A_THING = {
    "bark": "acorn cap",
    "bone": "egg shell, unicorn horn, drinking horn horn, feather shaft",
    "cast iron": "bench legs, bomb body",
    "ceramic": (
        "shelf vase, toilet seat, toilet tank, toilet lid, sink basin, sink column, cake plate, "
        "pancakes plate, plate rim, crown pearls, bonsai tray"
    ),
    "chitin": (
        "crab claws, scorpion claws, spider legs, ant legs, crab legs, ladybug head, bee stripes, "
        "ladybug patches, snail shell, turtle shell"
    ),
    "clay": "snowman buttons",
    "cream": (
        "hamburger cheese, pizza cheese, sandwich cheese, snowman body, sushi fish, popsicle top, "
        "ramen whites"
    ),
    "crumb": "bread crumb",
    "crust": (
        "ice cream cone, hamburger bun, sandwich bread, taco shell, hot dog bun, croissant folds"
    ),
    "fabric": (
        "glove band, canoe seats, jeep seats, baseball cap badge, pirate ship flag, hot air "
        "balloon balloon, umbrella canopy"
    ),
    "feathers": "arrow feathers, peacock eyes, angel wings, feather vane, feather tip",
    "felt": "sheep wool, teddy bear body, wizard hat stars",
    "flame": "volcano lava",
    "flesh": "grill food",
    "foliage": (
        "tree leaves, oak tree leaves, bush leaves, bonsai leaves, mountain firs, treehouse "
        "leaves, greenhouse plants"
    ),
    "fur": "raccoon mask",
    "glass": (
        "traffic light reds, jukebox lights, traffic light greens, traffic light yellows, lantern "
        "glass, satellite panels, rover panels"
    ),
    "hide": (
        "drum skin, banjo skin, pig snout, cow udder, elephant ears, turtle body, chicken legs, "
        "bird legs, flamingo legs, rhino plates, bat wings, dragon wings, demon wings, swan face, "
        "camel humps, sheep head, beaver tail, beaver lines, bat arms"
    ),
    "leaf": (
        "hamburger lettuce, sandwich lettuce, taco lettuce, palm nuts, island grass, eggplant cap"
    ),
    "leather": (
        "boot cuff, handbag handle, sneaker stripes, cowboy hat band, book cover, accordion "
        "folds, chestplate lining"
    ),
    "liquid": "cauldron brew",
    "metal": (
        "watch hands, clock hands, grandfather clock hands, compass needle, fan cage, parking "
        "meter needle, screwdriver collar, blender collar, coffee machine collar, ninja sword, "
        "harp strings, magnet bands, stove plates, compass tail"
    ),
    "paint": (
        "fence pickets, sword pommel, mailbox flag, space shuttle wings, biplane wings, "
        "helicopter rotor, submarine fins, rocket fins, tower windows, castle windows, pencil "
        "body, knight shield, mask paint, mask mouth, shield plate"
    ),
    "paper": (
        "watch face, clock face, grandfather clock face, compass dial, picture frame hills, "
        "picture frame sun, record player label, paper cup rim, paper cup badge, popcorn badge, "
        "fries carton, cupcake cup, popcorn box, easel hills, easel sun, milk carton top, "
        "chocolate bar wrapper, paper cup sleeve"
    ),
    "peel": "snowman nose, avocado skin, avocado stone, mushroom cap",
    "petal": "fairy wings",
    "plain": "guitar hole, ukulele hole, violin holes, pencil lead",
    "plastic": (
        "duck body, duck wings, duck bill, fan blades, headphones band, robot aerial, toothbrush "
        "grip, vacuum cleaner grip, washing machine panel, security camera hood, sunglasses arms, "
        "office chair arms"
    ),
    "rubber": (
        "pistol grip, sneaker sole, boxing glove band, camera grip, binoculars rims, traffic cone "
        "body, saxophone mouthpiece"
    ),
    "skin": "monkey face, demon mouth, zombie mouth, yeti face, mouse tail, mouse ears, bat ears",
    "wet skin": "brain folds, yeti mouth",
    "wicker": "crossbow string, bow string",
    "wooden": (
        "pickaxe grip, cannon wheels, fence rails, wagon wheels, broom handle, shovel handle, "
        "rake handle, axe handle, rolling pin handles, window sill, rolling pin collars, potion "
        "cork, well roof"
    ),
}
# A part, whatever it is of.
OF_A_PART = {
    "bark": "trunk, bark, branches",
    "bone": "horns, horn, antlers, tusks, teeth, fangs, bone, hooves, claws",
    "brick": "chimney",
    "chitin": "bill, antennae, jaws, spikes",
    "clay": "pot",
    "cream": (
        "icing, scoop, scoops, syrup, sauce, butter, topping, mustard, chocolate, squares, chips, "
        "foam, wax, noodles, yolks, swirl, cheese, candy, broth, candles, ice"
    ),
    "crumb": "crumb, patty, filling, rice, popcorn",
    "crust": "crust, bun, bread, cone, pancakes, dough, wafer, ridges, fries",
    "eye": "eyes, pupils",
    "fabric": (
        "bow, coat, suit, laces, flag, cushions, robe, dress, folds, canopy, patch, mask, cape, "
        "hood, boots, sleeve, cloth, hat, trim, seat, top, sails, ribbon, shade, cushion, "
        "blanket, mattress, pillow, collar"
    ),
    "feathers": "feathers, plumes, plume",
    "flame": "flame, flames, fire, tongues, spark, embers, lava, rays",
    "flesh": "flesh, meat, ham, sausage, salami, fish, fat, pith",
    "foliage": "florets, plants, firs",
    "glass": (
        "screen, lens, lenses, display, lamp, lamps, lights, light, visor, window, windows, "
        "glass, gems, reels, glints, flash, camera, bulb, dome, crystals"
    ),
    "hair": "hair, beard, mane, fringes",
    "leaf": "leaf, leaves, stem, stems, stalk, stalks, husk, lettuce, seaweed, frills",
    "leather": (
        "strap, straps, grip, belt, saddle, flap, tomes, books, volumes, seats, hilt, bellows, "
        "badge"
    ),
    "liquid": "water, brew",
    "paint": "cross, sign, stripe, stripes, chassis, cargo, hull, turret, gun, engines",
    "paper": "paper, pages, label, sheet, carton, picture, canvas, marks, roll, dots",
    "peel": (
        "rind, peel, fruit, fruits, grapes, cherry, olives, coconuts, nuts, nut, seeds, kernels, "
        "tomato"
    ),
    "petal": "petals, heart",
    "plastic": (
        "buttons, button, knobs, knob, triggers, trigger, pad, joystick, switch, receiver, "
        "console, dial, accents, hub, hubs, keys, black keys, cap, caps, touchpad, slot, speaker, "
        "keyboard, tray, lever, panel, panels, nozzle, mouthpiece, cover, studs, whites, blues, "
        "reds, greens, yellows"
    ),
    "rubber": "eraser, tracks, sole, suckers, treads, shoes, foot, wheels",
    "skin": "skin, nails, comb, snout",
    "soil": "moss, soil, ground, grass, ash, hills, snow",
    "stone": "step, base",
    "wet skin": "nose, tongue, nostrils",
    "wicker": "basket, rope, ropes, twine, coil, strands, coils, ties, binding, fuse, bristles",
    "wooden": (
        "pegs, chinrest, sticks, board, rails, posts, beam, logs, stick, shutters, wood, struts, "
        "frame, stand, handle, handles, mallet, box, feet, door, mast, neck, bridge"
    ),
}
# What is left of a thing.
OF_THE_REST = {
    "bark": "log, stump, pinecone, treehouse",
    "bone": "skull, skeleton, seashell, bone",
    "cast iron": "dumbbell, kettlebell, barbell, anvil",
    "ceramic": "bathtub, sink, toilet, bowl, mug, teapot, plate, jar, salt shaker, bell",
    "chitin": "ant, ladybug, scorpion, crab, dragonfly",
    "clay": "vase",
    "cream": (
        "ice cream, sundae, cheese, chocolate bar, lollipop, candy cane, popsicle, snowman, "
        "candle, cloud, egg"
    ),
    "crumb": "cake, cupcake, sandwich, popcorn",
    "crust": (
        "bread, croissant, cookie, pie, waffle, pretzel, pizza, hamburger, taco, pancakes, torus, "
        "fries"
    ),
    "fabric": "armchair, rug, curtain, tent, parachute, sofa",
    "feathers": "bird, owl, penguin, chicken, flamingo, ostrich, swan, peacock",
    "felt": (
        "teddy bear, bee, spider, butterfly, baseball cap, wizard hat, cowboy hat, sheep, ghost, "
        "hat"
    ),
    "flesh": "steak, chicken drumstick, sushi, hot dog",
    "fur": "bat, centaur, yeti, hedgehog",
    "glass": "gem, crystal, flask, syringe",
    "hide": "pig, elephant, rhino, hippo, turtle",
    "leaf": "cactus, cucumber, corn, broccoli, lettuce, leaf, tulip, rose, sunflower, flower",
    "leather": "suitcase, handbag, boot, glove, boxing glove, high heel, drinking horn",
    "paint": (
        "bowling pin, rocket, train, fire extinguisher, slide, trampoline, mailbox, ufo, "
        "submarine, basketball hoop, carousel"
    ),
    "paper": (
        "scroll, envelope, book, stack of books, paper cup, milk carton, kite, toilet paper, gift"
    ),
    "peel": (
        "apple, pear, strawberry, cherry, lemon, watermelon, grapes, eggplant, pepper, peach, "
        "tomato, orange fruit, banana, pumpkin, carrot, potato, avocado, onion, coconut, "
        "pineapple, mushroom, acorn"
    ),
    "plastic": "ball, puzzle cube, lego brick, yo-yo, maracas, balloon",
    "rubber": "wheel",
    "scales": (
        "fish, snake, crocodile, lizard, dragon, dinosaur, triceratops, stegosaurus, seahorse, "
        "mermaid"
    ),
    "skin": "hand, eyeball, brain, tooth, goblin",
    "soil": "island, volcano, mountain, igloo",
    "stone": (
        "boulder, golem, pyramid, moai, obelisk, tombstone, chess knight, chess rook, chess king, "
        "coral, fountain"
    ),
    "wet skin": "frog, whale, shark, dolphin, octopus, seal, stingray, jellyfish, snail, alien",
    "wicker": "basket, rope, hay bale, beehive, hammock, sack, scarecrow",
    "wooden": (
        "boat, crib, rocking horse, piano, signpost, easel, pawn, spinning top, totem pole, "
        "nutcracker, catapult, staircase, gazebo, swing, seesaw, market stall, boomerang, "
        "slingshot, chessboard, canoe, barrel"
    ),
}
# What is left of the things of a group.
OF_A_GROUP = {
    "Animals": "fur",
    "Wild Animals": "fur",
    "Characters": "fabric",
    "Vehicles": "paint",
    "Buildings": "concrete",
    "Electronics": "plastic",
    "Clothes": "fabric",
    "Sport": "plastic",
    "Tools and Toys": "plastic",
    "Household": "plastic",
    "Small Things": "plastic",
    "Plants": "leaf",
}

# What is not worn as things are: what lives, grows, or is eaten, and what has no shape of its own.
UNWORN = frozenset(
    """eye hair fur feathers scales hide skin chitin leaf foliage petal peel flesh crust crumb cream
    soil flame liquid bark""".split()
) | {"wet skin"}


def substance(noun: str, part: str) -> str:
    """The kind of the noun's ``part``; "" where nothing is known of it."""
    of_things, of_parts, of_rest, of_groups = _by_name()
    found = (of_things.get(f"{noun} {part}"), of_parts.get(part), of_rest.get(noun))
    return next(filter(None, found), of_groups.get(noun, ""))


@cache
def _by_name() -> tuple[dict[str, str], ...]:
    tables = (OF_A_THING, OF_A_PART, OF_THE_REST)
    kinds = [
        {name: k for k, text in table.items() for name in text.split(", ")} for table in tables
    ]
    groups = {noun: OF_A_GROUP.get(group, "") for group, nouns in GROUPS.items() for noun in nouns}
    return *kinds, groups
