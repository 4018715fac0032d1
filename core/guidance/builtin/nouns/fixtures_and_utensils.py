"""What is fixed or stands in a house, cages and carts, and a kitchen's utensils."""

from core.guidance.builtin.nouns.noun import CERAMIC, GLASS, PLASTIC, STEEL, WOOD, Noun, Usual

FIXTURES_AND_UTENSILS = {
    "faucet": Noun(
        "tap, kitchen tap, mixer tap, bathroom tap, water tap, kitchen faucet, bathroom faucet, "
        "faucets, water faucet, basin tap, bath tap, sink tap, sink faucet; spigot, shower tap, "
        "garden tap",
        {
            "body": "*cdd2d7 . metal",
            "spout": "*d9dde1 . metal",
            "handles": "&c3c9ce . metal",
            "nozzle": "&9aa1a8 . metal",
            "hot mark": "-d8342c . plastic",
            "cold mark": "-2f6fd0 . plastic",
        },
        Usual(0.35, STEEL, 0.145),
    ),
    "radiator": Noun(
        "column radiator, house radiator, room radiator, radiators, home radiator, central "
        "heating radiator; heater, electric heater, oil heater, space heater, convector, "
        "heating",
        {
            "columns": "*efe9da . paint",
            "pipes": "&d8cfbb . paint",
            "feet": "&c2b8a2 . paint",
            "valve": "-c79a45 . golden",
            "knob": "+2f3338 . plastic",
        },
        Usual(1.0, STEEL, 0.05),
    ),
    "air conditioner": Noun(
        "air conditioning, aircon, air con, ac unit, air conditioning unit, air conditioners, "
        "split air conditioner, air conditioner unit, aircon unit, wall air conditioner, "
        "split unit; air cooler, heat pump, window air conditioner, air purifier",
        {
            "body": "*f1f3f4 . plastic",
            "ends": "&dfe3e6 . plastic",
            "vent": "-33383d . plastic",
            "flap": "&fafbfc . plastic",
            "display": "-3fd07a . glass",
            "slits": "-5a6067 . plastic",
        },
        Usual(0.9, PLASTIC, 0.12),
    ),
    "ironing board": Noun(
        "ironing table, iron board, ironing boards, folding ironing board; ironing stand",
        {
            "cover": "*4f93bd . fabric",
            "frame": "+e9edf0 . metal",
            "legs": "+c3c9ce . metal",
            "feet": "-2a2c30 . rubber",
            "rest": "+9aa1a8 . metal",
        },
        Usual(1.4, STEEL, 0.02),
    ),
    "clothes hanger": Noun(
        "coat hanger, hanger, coathanger, clotheshanger, cloth hanger, hangers, dress hanger; "
        "shirt hanger, trouser hanger, wire hanger, suit hanger",
        {
            "body": "*b9783f grain",
            "bar": "&8f5a2c grain",
            "hook": "-c9ced3 . metal",
            "collar": "-d1a848 . golden",
            "ends": "&7d4b23 grain",
        },
        Usual(0.44, WOOD, 0.35),
    ),
    "high chair": Noun(
        "highchair, baby chair, baby high chair, baby highchair, feeding chair, infant chair, "
        "high chairs, toddler chair, child chair; booster seat, baby seat",
        {
            "seat": "*f3efe6 . plastic",
            "cushion": "+58b0a0 . fabric",
            "tray": "*fbf8f1 . plastic",
            "legs": "&c2894f grain",
            "footrest": "&b87f46 grain",
            "feet": "-4a4d52 . rubber",
        },
        Usual(1.0, WOOD, 0.2),
    ),
    "shopping cart": Noun(
        "shopping trolley, supermarket trolley, supermarket cart, grocery cart, shopping carts, "
        "store cart, shoppingcart, grocery trolley, market cart; luggage cart, luggage trolley, "
        "airport trolley",
        {
            "basket": "*c3c9cf . metal",
            "frame": "&8e969e . metal",
            "handle": "+d5322c . plastic",
            "wheels": "-25272a . rubber",
            "flap": "+e0453c . plastic",
        },
        Usual(1.1, STEEL, 0.19),
        constructed=True,
    ),
    "aquarium": Noun(
        "fish tank, fishtank, aquariums, fish aquarium, tropical aquarium, "
        "aquarium tank; terrarium, vivarium, goldfish tank",
        {
            "water": "*5fb8d8 . glass",
            "frame": "+26292e . plastic",
            "gravel": "-d9b87c . stone",
            "fish": "-f5801f . plastic",
            "plants": "-3f9d4a . plastic",
            "lid": "+3a3f46 . plastic",
        },
        Usual(0.8, 1000.0, 1.0),
    ),
    "birdcage": Noun(
        "bird cage, parrot cage, canary cage, birdcages, cage for birds, cage; animal cage, "
        "hamster cage, budgie cage, aviary",
        {
            "bars": "*d6aa4b . golden",
            "hoops": "&bf923a . golden",
            "tray": "&8d6a2c . golden",
            "ring": "&bf923a . golden",
            "perch": "-7a4d29 grain",
            "bird": "-3fa7d6",
        },
        Usual(0.6, STEEL, 0.06),
    ),
    "remote control": Noun(
        "remote, tv remote, tv remote control, television remote, remote controller, "
        "remote controls, remotes, television remote control, tv controller; garage remote, "
        "air conditioner remote, universal remote",
        {
            "body": "*2b2e34 . plastic",
            "power": "-e23a30 . rubber",
            "pad": "+7d858e . rubber",
            "button": "&3f464f . rubber",
            "keys": "-d9dde1 . rubber",
            "bars": "+5b9bd0 . rubber",
            "seams": "~4c525a . plastic",
        },
        Usual(0.2, PLASTIC, 0.35),
    ),
    "perfume": Noun(
        "perfume bottle, bottle of perfume, cologne, fragrance, scent bottle, perfume flask, "
        "perfumes; perfume atomizer, atomizer, aftershave, eau de toilette, eau de parfum, "
        "nail polish",
        {
            "bottle": "*e69ab0 . glass",
            "label": "-f6efe2",
            "collar": "+d9ab4a . golden",
            "cap": "+f2e3c4 . glass",
            "bulb": "+7a2740 . fabric",
            "monogram": "-b0567a",
            "border": "-d9ab4a . golden",
            "grooves": "~9a742c",
        },
        Usual(0.12, GLASS, 0.7),
    ),
    "colander": Noun(
        "strainer, sieve, pasta strainer, colanders, kitchen sieve, kitchen strainer, "
        "vegetable strainer; salad spinner, steamer basket, rice strainer",
        {
            "bowl": "*d9483b . paint",
            "lining": "+f6f2e8 . paint",
            "rim": "&f1ece0 . paint",
            "handles": "+f1ece0 . paint",
            "foot": "&b93a2f . paint",
        },
        Usual(0.32, STEEL, 0.06),
    ),
    "whisk": Noun(
        "balloon whisk, egg whisk, hand whisk, kitchen whisk, wire whisk, whisker; egg beater, "
        "eggbeater, milk frother, cream whisk",
        {
            "wires": "*c9ced3 . metal",
            "collar": "&9aa1a8 . metal",
            "handle": "+c63f2e . plastic",
            "grips": "+8f2a1e . rubber",
            "ring": "&aab0b6 . metal",
        },
        Usual(0.3, STEEL, 0.08),
    ),
    "spatula": Noun(
        "turner, fish slice, kitchen spatula, slotted spatula, slotted turner, flipper, pancake "
        "turner, spatulas; scraper, cake server, pie server",
        {
            "blade": "*b9bfc5 . metal",
            "neck": "&989fa6 . metal",
            "handle": "+7a4423 grain",
            "collar": "&d3b35c . golden",
        },
        Usual(0.33, STEEL, 0.12),
    ),
    "grater": Noun(
        "cheese grater, box grater, kitchen grater, vegetable grater; zester, lemon zester, "
        "nutmeg grater, mandoline",
        {
            "body": "*c3c8cd . metal",
            "teeth": "&dfe3e6 . metal",
            "holes": "-2b2e32",
            "slits": "-3a3e43",
            "handle": "+c8352a . plastic",
            "rims": "+c8352a . plastic",
        },
        Usual(0.24, STEEL, 0.05),
    ),
    "jug": Noun(
        "pitcher, water jug, water pitcher, milk jug, jugs, ewer, creamer, milk pitcher; "
        "carafe, wine jug, lemonade pitcher, jug of milk, jug of water, gravy boat",
        {
            "body": "*ece6d8 . ceramic",
            "handle": "&ece6d8 . ceramic",
            "band": "+2f62a8 . ceramic",
            "foot": "+2f62a8 . ceramic",
            "collar": "+4f83c6 . ceramic",
        },
        Usual(0.25, CERAMIC, 0.2),
    ),
    "moka pot": Noun(
        "mokapot, moka, stovetop espresso maker, macchinetta, "
        "mocha pot, espresso pot, italian coffee maker, stovetop coffee maker, moka coffee pot; "
        "coffee pot, percolator, coffee percolator",
        {
            "boiler": "*b7bcc2 . metal",
            "pot": "*c9ced3 . metal",
            "handle": "+1f1e20 . plastic",
            "lid": "&b7bcc2 . metal",
            "knob": "+1f1e20 . plastic",
            "collar": "+c79a45 . golden",
        },
        Usual(0.2, STEEL, 0.08),
    ),
}
