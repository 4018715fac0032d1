"""The natural substances of a thing's parts where its row states no finish.

Searched in this order: the part of the thing, the part of any thing, the thing, its group. Each
is a kind of detail (``core.texture.detail.kinds``). Standard library only.
"""

from functools import cache

from core.guidance.builtin.nouns import GROUPS, NOUNS, solid_of

# Roughness of the kinds that are not material words.
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
    "snow": 0.85,
    "sand": 0.95,
    "wicker": 0.8,
    "flame": 0.5,
    "embers": 0.5,
    "felt": 0.95,
    "clay": 0.85,
    "concrete": 0.9,
    "brick": 0.9,
    "masonry": 0.9,
    "thatch": 0.95,
}

METAL, WOOD, GLASS, CLOTH = "metal", "wood", "glass", "cloth"
STONE, PLASTIC, RUBBER = "stone", "plastic", "rubber"
# The classes of the materials' words and of the kinds of substances.
_CLASS_OF = {
    METAL: "metal, golden, copper, rusty, cast iron, brushed metal, polished metal, gold leaf",
    WOOD: "wooden",
    GLASS: "glass",
    CLOTH: "fabric, leather, felt, wicker, velvet, paper",
    STONE: "stone, ceramic, masonry, brick, concrete, marble, granite, clay",
    PLASTIC: "plastic",
    RUBBER: "rubber",
}
CLASS_OF = {form: name for name, forms in _CLASS_OF.items() for form in forms.split(", ")}

# By the pattern of a part's look.
BY_PATTERN = {"grain": "wooden", "bricks": "masonry", "thatch": "thatch"}
# A part of one thing.
OF_A_THING = {
    "bark": "chameleon branch, acorn cap, sloth branch, fireplace logs",
    "bone": (
        "egg shell, nest eggs, feather shaft, sloth claws, roast chicken bones, werewolf "
        "claws, velociraptor claws, brachiosaurus nails, mammoth nails, egg cup egg"
    ),
    "cast iron": "bench legs, bomb body, steamroller chimney",
    "ceramic": (
        "shelf vase, toilet seat, cake plate, pancakes plate, crown pearls, bonsai tray, mug "
        "handle, teapot handle, bowl foot"
    ),
    "chitin": (
        "crab claws, scorpion claws, spider legs, bee stripes, snail shell, turtle shell, "
        "dragonfly stripes, toucan tip, bird feeder beak, bird bath beak, fly swatter fly"
    ),
    "brick": "brick block brick, brick block holes",
    "clay": ("hut walls, snowman buttons, greenhouse pots, space capsule heat shield"),
    "cream": (
        "sushi fish, popsicle top, ramen whites, gingerbread man buttons, gingerbread man "
        "eyes, gingerbread man bow, donut sprinkles, donut strands, donut drops, snow globe "
        "snow, snow globe flakes, candy cane stripes, scroll seal, envelope seal, soap bar, "
        "soap stamp"
    ),
    "crumb": ("notice board cork, cake stand cake"),
    "crust": (
        "croissant folds, muffin top, burrito toast, fried egg edge, roast chicken meat, "
        "roast chicken drumsticks, waffle maker waffle"
    ),
    "eye": "fish whites, pufferfish whites, cyclops whites, cyclops iris",
    "fabric": (
        "glove band, baseball cap badge, hot air balloon balloon, paper lantern tassels, director "
        "chair star, ping pong table tape"
    ),
    "feathers": (
        "rooster neck, peacock eyes, angel wings, feather vane, feather tip, griffin wings, "
        "birdcage bird, pegasus wings, feather duster plumes, bird feeder bird, bird bath "
        "bird"
    ),
    "felt": (
        "cowboy hat, dartboard reds, dartboard greens, elf shoes, snowman hat, cat tree toys,"
        " cat tree opening, boxing ring logo"
    ),
    "flame": (
        "jack-o-lantern eyes, jack-o-lantern nose, jack-o-lantern mouth, comet tail, bunsen "
        "burner core"
    ),
    "flesh": (
        "kiwi middle, grill food, salad onion, salad cucumber, mushroom stem, mushroom house stem"
    ),
    "foliage": (
        "willow tree leaves, willow tree strands, tree leaves, oak tree leaves, bush leaves, "
        "bonsai leaves, treehouse leaves, christmas tree leaves, hedge maze hedges"
    ),
    "fur": (
        "monster fur, monster paws, raccoon mask, viking fur, griffin body, griffin tuft, "
        "minotaur fur, sloth marks, tiger stripes, zebra stripes, raccoon stripes, skunk "
        "stripe, werewolf fur, werewolf muzzle, otter feet, hamster wheel hamster, hamster "
        "wheel belly"
    ),
    "glass": (
        "traffic light reds, traffic light greens, traffic light yellows, satellite panels, rover "
        "panels"
    ),
    "hair": "paintbrush bristles",
    "hide": (
        "drum skin, banjo skin, pig snout, cow udder, chicken legs, bird legs, flamingo legs,"
        " bat wings, goose feet, rooster legs, pterodactyl wings, pterodactyl crest, mammoth "
        "ears, dragon wings, demon wings, swan face, camel humps, sheep head, beaver tail, "
        "beaver lines, bat arms, eagle legs, gorilla face, drum kit skins, penguin feet, "
        "bongos skins"
    ),
    "leaf": (
        "chili pepper cap, palm nuts, island grass, stonehenge grass, eggplant cap, wreath "
        "leaves, wreath tips, mortar and pestle herbs, stadium pitch"
    ),
    "leather": (
        "handbag handle, sneaker stripes, cowboy hat band, book cover, accordion folds, "
        "chestplate lining, belt holes, suitcase handle"
    ),
    "liquid": (
        "teacup tea, wine glass liquid, toxic barrel goo, french press coffee, hot tub bubbles"
    ),
    "masonry": "igloo arch",
    "metal": (
        "watch hands, clock hands, grandfather clock hands, compass needle, fan cage, parking"
        " meter needle, screwdriver collar, blender collar, coffee machine collar, ninja "
        "sword, harp strings, magnet bands, stove plates, compass tail, alarm clock hands, "
        "pocket watch hands, radio handle, toolbox handle, wagon handle, suitcase feet, clock"
        " feet, safe feet, floor lamp foot, golf club neck, rover mast, vending machine cans,"
        " vending machine flap, solar panel lines, trumpet buttons, parking meter slot, "
        "microscope stage, train wheels, tank wheels, cello strings, big ben hands, kitchen "
        "scale pointer"
    ),
    "paint": (
        "sarcophagus eyes, fence pickets, mailbox flag, tower windows, castle windows, pencil"
        " body, knight shield, mask paint, mask mouth, shield plate, train frame, kettlebell "
        "badge, rocket nose, space shuttle nose, carousel trim, suspension bridge lines, "
        "stadium lines, oil rig pad, oil rig markings, ping pong table lines, foosball table "
        "lines, spirit level lines"
    ),
    "paper": (
        "notebook cover, notebook pages, engine filter, muffin cup, dynamite sticks, dynamite"
        " ends, garlic neck, watch face, clock face, grandfather clock face, compass dial, "
        "picture frame hills, picture frame sun, paper cup badge, popcorn badge, cupcake cup,"
        " popcorn box, easel hills, easel sun, milk carton top, chocolate bar wrapper, paper "
        "cup sleeve, clipboard lines, clipboard boxes, notice board notes, notice board "
        "cards, atm notes, alarm clock face, pocket watch face, gift box, envelope flap, "
        "popcorn stripes, target board, target blacks, target blues, target reds, target "
        "golds, whiteboard notes, floppy disk stripe, pizza box box, pizza box salami, pizza "
        "box cheese, cereal box box, wanted poster hat, ashtray cigarettes, ashtray filters, "
        "matchbox striker, matchbox emblem, matchbox tray, cigar band, kitchen scale face, "
        "lectern papers, metronome scale, time machine dials, film reel frames"
    ),
    "peel": (
        "kiwi skin, muffin berries, snowman nose, avocado skin, mushroom cap, roast chicken "
        "tomatoes, wreath berries, jack-o-lantern body, mushroom house cap, mushroom house "
        "dots, cucumber stripes, watermelon stripes, hamster seed, cake stand berries"
    ),
    "petal": ("fairy wings, pergola flowers"),
    "plain": (
        "hut windows, pen hole, guitar hole, ukulele hole, violin holes, pencil lead, "
        "birdhouse hole, grater holes, grater slits, flute hole, harmonica holes, lighter "
        "holes, power outlet slots, smoke detector slots, bunsen burner holes, pencil "
        "sharpener hole, usb stick holes, spool of thread hole, cello sound holes, leaning "
        "tower openings, taj mahal openings"
    ),
    "plastic": (
        "duck body, duck wings, duck bill, toothbrush grip, vacuum cleaner grip, security camera "
        "hood, sunglasses arms, office chair arms, microphone handle, screwdriver handle, blender "
        "handle, coffee machine handle, clothes iron handle, toothbrush handle, scissors handles, "
        "refrigerator feet, sunglasses frame, binoculars bridge, basketball hoop board, monitor "
        "stand, television stand, fan stand, toothbrush bristles, hairbrush bristles, toaster "
        "base, vacuum cleaner base, stapler base, hair dryer grip, dumpster lid, clown nose, "
        "cassette reels, cassette window"
    ),
    "rubber": (
        "pistol grip, boxing glove band, camera grip, binoculars rims, traffic cone body, "
        "saxophone mouthpiece"
    ),
    "scales": "lizard feet, chameleon eyes, chameleon stripes, velociraptor stripes",
    "skin": (
        "turkey head, turkey wattle, troll nose, monkey face, demon mouth, zombie mouth, "
        "person mouth, yeti face, mouse tail, mouse ears, bat ears, minotaur body, "
        "caterpillar feet, mouse feet, hedgehog feet, hamster feet, hamster wheel paws, "
        "jackbox face"
    ),
    "soil": "dump truck load",
    "wet skin": (
        "cyclops mouth, monster mouth, axolotl mouth, axolotl cheeks, mimic mouth, slime mouth, "
        "brain folds, yeti mouth, brain stem"
    ),
    "wicker": (
        "crossbow string, bow string, barn hay, hay bale stalks, beehive knob, clothesline "
        "lines, wind chime strings"
    ),
    "wooden": (
        "pickaxe grip, window sill, rolling pin collars, potion cork, well roof, barn walls, "
        "barn trim, log cabin roof, whistle pea, raft ends, treehouse roof, spinning top "
        "stem, pirate ship masts, pawn base, pawn collar, ball of yarn knobs"
    ),
    "embers": (
        "hookah coals, cigar ember, solar system sun, galaxy core, galaxy stars, portal "
        "swirl, portal glow, time machine glow, forge coals, theatre stage footlights"
    ),
    "sand": ("colosseum arena, hedge maze path"),
    "concrete": ("suspension bridge road, tower bridge deck"),
}
# A part of any thing.
OF_A_PART = {
    "bark": "trunk, branches",
    "bone": "horns, horn, antlers, tusks, teeth, fangs, bone, hooves",
    "brick": "chimney",
    "chitin": "bill, spikes",
    "clay": "pot",
    "cream": (
        "icing, syrup, butter, topping, mustard, chips, foam, noodles, yolks, cheese, broth, "
        "candles"
    ),
    "crumb": "crumb, patty, filling, rice",
    "crust": "bun, bread, cone, wafer",
    "eye": "eyes, pupils",
    "fabric": (
        "bow, coat, suit, laces, flag, cushions, hat, trim, top, sails, ribbon, shade, cushion, "
        "blanket, mattress, pillow, collar"
    ),
    "feathers": "feathers, plume",
    "flame": "flame, flames, fire, tongues",
    "embers": "spark, embers, lava, rays",
    "flesh": "flesh, meat, ham, salami, pith",
    "foliage": "florets, plants, firs",
    "glass": (
        "screen, lens, display, lamp, lamps, lights, light, visor, window, windows, glass, gems, "
        "reels, glints, flash, camera"
    ),
    "hair": "hair, beard, mane, fringes",
    "leaf": "leaf, leaves, stem, stalk, stalks, lettuce, seaweed",
    "leather": "strap, grip, belt, saddle, flap, tomes, books, volumes, hilt, bellows, badge",
    "liquid": "water, brew",
    "paint": "sign, stripe, stripes, hull",
    "paper": "paper, label, carton, picture, canvas, marks",
    "peel": "rind, fruit, cherry, olives, coconuts, nut, seeds, kernels, tomato",
    "petal": "petals, heart",
    "plastic": "buttons, button, knob, keys, black keys, cap, slot, panel, nozzle",
    "rubber": "eraser, tracks, sole, suckers, shoes, wheels",
    "skin": "skin, comb",
    "soil": "moss, soil, ground, ash",
    "stone": "step, base",
    "wet skin": "nose, tongue, nostrils",
    "wicker": "basket, ropes, ties, binding, fuse, bristles",
    "wooden": (
        "pegs, chinrest, sticks, board, rails, logs, stick, shutters, wood, struts, frame, stand, "
        "handle, handles, mallet, box, feet, foot, door, mast, neck, bridge"
    ),
}
# The other parts of a thing.
OF_THE_REST = {
    "bark": "log, stump, pinecone, treehouse",
    "bone": "skeleton, seashell, bone, unicorn horn",
    "cast iron": "dumbbell, kettlebell",
    "ceramic": "bathtub, sink, toilet, bowl, mug, teapot, plate, salt shaker",
    "chitin": "beetle, ant, ladybug, scorpion, crab, dragonfly, lobster",
    "clay": "vase, flower pot, planet",
    "cream": (
        "ice cream, sundae, cheese, chocolate bar, lollipop, candy cane, popsicle, "
        "candle, cloud, fried egg"
    ),
    "crumb": "cake, popcorn",
    "crust": (
        "bread, croissant, cookie, pie, waffle, pretzel, pizza, taco, pancakes, fries, "
        "donut, gingerbread man, burrito, cinnamon roll"
    ),
    "fabric": "armchair, rug, parachute",
    "feathers": (
        "goose, turkey, rooster, bird, owl, penguin, chicken, flamingo, ostrich, swan, peacock, "
        "parrot, eagle, phoenix, toucan, wings"
    ),
    "felt": "bee, spider, butterfly, wizard hat, sheep, ghost, hat, spider web",
    "fur": "cat ears, fox ears, bunny ears, cat tail, fox tail",
    "flesh": "steak, bacon, chicken drumstick, hot dog",
    "hide": "pig, elephant, rhino, hippo, turtle, starfish, walrus",
    "leaf": "corn, leaf",
    "leather": "suitcase, handbag, boot",
    "paint": "bowling pin, slide, basketball hoop, carousel",
    "paper": (
        "scroll, envelope, book, open book, stack of books, paper cup, toilet paper, gift, "
        "cardboard box, paper lantern, wanted poster, newspaper, treasure map, playing card, "
        "tarot card, "
        "pizza box, cereal box, passport"
    ),
    "peel": (
        "chili pepper, apple, pear, strawberry, cherry, lemon, grapes, eggplant, pepper, peach, "
        "tomato, orange fruit, kiwi, garlic, banana, pumpkin, carrot, potato, avocado, onion, "
        "coconut, pineapple, watermelon slice"
    ),
    "plastic": (
        "butterfly wings, fairy wings, ball, balloon, torus, credit card, floppy disk, domino, "
        "mahjong tile"
    ),
    "scales": (
        "pufferfish, chameleon, velociraptor, pterodactyl, brachiosaurus, fish, snake, crocodile, "
        "lizard, dragon, dinosaur, triceratops, stegosaurus, seahorse, mermaid"
    ),
    "skin": "devil tail, hand, eyeball, brain, tooth, goblin, caterpillar",
    "snow": "snowman",
    "sand": "sandcastle",
    "soil": "volcano, mountain",
    "wet skin": (
        "orca, axolotl, frog, whale, shark, dolphin, octopus, seal, stingray, jellyfish, snail, "
        "alien"
    ),
    "wicker": "dreamcatcher, nest, basket, rope, hay bale, beehive, sack, scarecrow",
    "wooden": "rocking horse, pawn, totem pole, staircase, gazebo, chessboard",
}
# The other parts of the things of a group.
OF_A_GROUP = {
    "Animals": "fur",
    "Wild Animals": "fur",
    "Characters": "fabric",
    "Vehicles": "paint",
    "Aircraft and Space": "paint",
    "Buildings": "concrete",
    "Electronics": "plastic",
    "Clothes": "fabric",
    "Sport": "plastic",
    "Tools and Toys": "plastic",
    "Instruments": "plastic",
    "Household": "plastic",
    "Fixtures and Utensils": "plastic",
    "Small Things": "plastic",
    "Flags and Signs": "paint",
    "Plants": "leaf",
    "House and Garden": "plastic",
    "Workshop and Studio": "plastic",
    "Monuments and Machines": "paint",
}

# Transmitted fraction of the light for parts of glass by nature that one looks through. All other
# glass (a car's windows, a screen, a camera's lens) has nothing visible behind it, as a mesh is a
# closed hull; it mirrors and stays opaque.
CLEAR = {
    0.95: (
        "flask glass, flask rim, magnifying glass glass, salt shaker body, salt shaker base, "
        "beaker glass, petri dish dish, chandelier drops, sundae glass, bottle body, potion flask, "
        "potion rim, wine glass bowl, "
        "wine glass stem, wine glass foot, blender jug, gem stone, ring gem, necklace stone, "
        "perfume bottle"
    ),
    0.85: (
        "window glass, bus stop glass, flask liquid, vacuum cleaner cup, crystal crystals, crystal "
        "shards, snowflake arms, snowflake branches, snowflake middle, jar body, perfume cap"
    ),
    0.6: (
        "crystal ball ball, wine glass liquid, hourglass glass, staff crystal, crown gems, ufo "
        "dome, coffee machine jug, snowmobile windshield, prism glass"
    ),
    0.4: "fountain water, bathtub water, well water, sunglasses glasses",
    0.2: "light bulb bulb, lantern glass, street lamp lamp",
}
# Emitted fraction of a part's colour; all of it for flames. A lamp's colour is light already, and
# more of it would burn out to white.
GLOW = {
    1.0: "lightsaber blade, sun disc, sun glints",
    0.6: (
        "ray gun tip, brazier embers, ufo lights, jack-o-lantern eyes, jack-o-lantern nose, "
        "jack-o-lantern mouth, computer tower lights, sci-fi crate lights, sci-fi door lights, "
        "landmine light, forge embers, portal glow, time machine glow, atom electrons, lava lamp "
        "lava"
    ),
    0.4: (
        "space station windows, light bulb bulb, lantern glass, street lamp lamp, flashlight lens, "
        "lighthouse lantern, jukebox lights, mech visor, golem eyes, staff crystal, server rack "
        "lights, spotlight lens, theatre stage footlights, portal swirl, segway lamps, "
        "hoverboard lamps, gun turret lamps, server rack lamps, wall sconce bulb, pendant lamp "
        "bulb, toxic barrel goo"
    ),
    0.15: (
        "traffic light reds, traffic light yellows, traffic light greens, lamp shade, floor lamp "
        "shade, gas pump globe, wall sconce shade, paper lantern globe, paper lantern ribs"
    ),
}

# Kinds that do not wear as things do: living, growing, edible, or without a shape of their own.
UNWORN = frozenset(
    """eye hair fur feathers scales hide skin chitin leaf foliage petal peel flesh crust crumb cream
    soil snow sand flame embers liquid bark""".split()
) | {"wet skin"}
BURNING = ("flame", "embers")


def natural_kind(noun: str, part: str) -> str:
    """The kind of the noun's ``part`` by its look, which may state it, or else by its name."""
    _, pattern, stated = (*NOUNS[noun].looks[part].split(), ".", ".")[:3]
    return BY_PATTERN.get(pattern) or stated.strip(".") or substance(noun, part)


def substance(noun: str, part: str) -> str:
    """The kind of the noun's ``part``; "" if unknown."""
    of_things, of_parts, of_rest, of_groups = _by_name()
    rest = of_rest.get(noun, of_rest.get(solid_of(noun)))
    found = (of_things.get(f"{noun} {part}"), of_parts.get(part), rest)
    return next(filter(None, found), of_groups.get(noun, ""))


def lights(noun: str, part: str, kind: str) -> tuple[float, float]:
    """How much the noun's ``part``, of its natural ``kind``, glows and is clear."""
    glow, clear = (table.get(f"{noun} {part}", 0.0) for table in _lights())
    return 1.0 if kind in BURNING and not glow else glow, clear


@cache
def _lights() -> tuple[dict[str, float], ...]:
    return tuple(
        {name: much for much, text in table.items() for name in text.split(", ")}
        for table in (GLOW, CLEAR)
    )


@cache
def _by_name() -> tuple[dict[str, str], ...]:
    tables = (OF_A_THING, OF_A_PART, OF_THE_REST)
    kinds = [
        {name: k for k, text in table.items() for name in text.split(", ")} for table in tables
    ]
    groups = {noun: OF_A_GROUP.get(group, "") for group, nouns in GROUPS.items() for noun in nouns}
    return *kinds, groups
