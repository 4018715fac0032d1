"""Cars, vans, and a wheel."""

from core.guidance.builtin.nouns.noun import GLASS_LOOK, RUBBER, STEEL, TYRES_LOOK, Noun, Usual

CARS = {
    "police car": Noun(
        "cop car, police cruiser, squad car, patrol car; sheriff car, police vehicle",
        {
            "body": "*17181c . paint",
            "windows": "-6d8aa0 . glass",
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "hubs": "-d8dadd . metal",
            "siren": "-1f5fd0 . plastic",
            "doors": "+f4f5f6 . paint",
            "letters": "-16264f . paint",
        },
        Usual(4.8, STEEL, 0.017),
        "taxi",
    ),
    "car": Noun(
        "automobile; sedan, hatchback, convertible, station wagon, hearse, tesla, bmw, audi, "
        "mercedes, volkswagen, mini cooper",
        {
            "body": "*c9211e . paint",
            "windows": "-26323c . glass",
            "wheels": "-1c1c1e . rubber",
            "lamps": "+f7eec2",
            "hubs": "+d8dadd . metal",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
            "number plates": "-f2f1ea . paint",
        },
        Usual(4.2, STEEL, 0.0215),
    ),
    "taxi": Noun(
        "cab, taxicab, taxi cab",
        {
            "body": "*f2bd12 . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "hubs": "+d8dadd . metal",
            "sign": "+f4f2ea",
            "letters": "-17171a",
            "trim": "-26282c . plastic",
        },
        Usual(4.5, STEEL, 0.017),
    ),
    "sports car": Noun(
        "sportscar, supercar, super car, coupe, coupé, sports cars; hypercar, ferrari, porsche, "
        "lamborghini, muscle car, roadster, lambo, bugatti, mclaren, corvette, mustang",
        {
            "body": "*f2b20f . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "hubs": "-c3c8cd . metal",
            "lamps": "-fbf4d6",
            "spoiler": "+202225",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
        },
        Usual(4.5, STEEL, 0.0205),
    ),
    "race car": Noun(
        "racing car, racecar, formula one car, formula 1 car, f1 car, formula one, formula 1, "
        "f1 racing car, race cars; indy car, drag racer, rally car",
        {
            "body": "*c81f1c . paint",
            "wings": "+f3f4f4 . paint",
            "wheels": TYRES_LOOK,
            "hubs": "-a4aab0 . metal",
            "cockpit": "-1d1e20",
            "helmet": "+f2c52a . paint",
            "visor": "-1b1d22 . glass",
            "number": "-f4f3ee . paint",
        },
        Usual(5.2, STEEL, 0.012),
    ),
    "limousine": Noun(
        "limousines, limo, limos, stretch limousine, stretch limo, stretched limousine; "
        "presidential car, wedding car",
        {
            "body": "*26262c . paint",
            "windows": "-86abc4 . glass",
            "wheels": "-3a3a3e . rubber",
            "hubs": "-d8dadd . metal",
            "trim": "-c3c8cd . metal",
            "lamps": "+f7eec2",
        },
        Usual(8.5, STEEL, 0.02),
    ),
    "jeep": Noun(
        "; off road car, off roader, suv, army car, land rover, range rover, humvee, "
        "hummer, off road vehicle, dune buggy, buggy",
        {
            "body": "*5d6b3e . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "trim": "-26282c . plastic",
            "roof": "+3f4a2c . paint",
            "grille": "-20241c",
            "hubs": "-c3c8cd . metal",
        },
        Usual(3.6, STEEL, 0.025),
    ),
    "van": Noun(
        "minivan, delivery van; minibus, ice cream truck",
        {
            "body": "*e8eaec . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "+f7eec2",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
            "number plates": "-f2f1ea . paint",
            "hubs": "-c3c8cd . metal",
        },
        Usual(5.2, STEEL, 0.0082),
    ),
    "ambulance": Noun(
        "ambulance car; emergency vehicle",
        {
            "body": "*f2f2ef . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "lamps": "-f7eec2",
            "cross": "+cf1f1f",
            "light": "-2a5fd0",
            "trim": "-26282c . plastic",
            "tail lamps": "-a30d14 . plastic",
        },
        Usual(6.0, STEEL, 0.0093),
    ),
    "camper": Noun(
        "camper van, campervan, motorhome, motor home, mobile home, rv, recreational vehicle, "
        "camping van, motor caravan; winnebago",
        {
            "body": "*f3efe4 . paint",
            "windows": GLASS_LOOK,
            "wheels": TYRES_LOOK,
            "stripe": "+e0762a . paint",
            "door": "-c9ccc8 . paint",
            "lamps": "-f7eec2",
            "hubs": "-c3c8cd . metal",
        },
        Usual(6.5, STEEL, 0.012),
    ),
    "golf cart": Noun(
        "golf buggy, golfcart, golf car, golf carts; buggy cart, electric cart",
        {
            "body": "*f0f0ea . paint",
            "roof": "+2c7a4b . paint",
            "seat": "-c9a173 . leather",
            "posts": "-4b5056 . metal",
            "wheels": TYRES_LOOK,
            "bags": "+2c7a4b . fabric",
            "lamps": "-f7eec2",
            "trim": "-33363b",
        },
        Usual(2.4, STEEL, 0.028),
    ),
    "go-kart": Noun(
        "gokart, go cart, kart, racing kart, race kart; quad, quad bike, quadbike, atv, "
        "all terrain vehicle, soapbox, soapbox car, pedal car, go kart racer",
        {
            "body": "*d42823 . paint",
            "frame": "&3d4147 . metal",
            "wheels": "-1c1c1e . rubber",
            "hubs": "+d8dadd . metal",
            "seat": "-232428 . leather",
            "engine": "-6b7076 . metal",
        },
        Usual(1.9, STEEL, 0.03),
    ),
    "wheel": Noun(
        "car wheel, wheel with tire; truck wheel, cart wheel, wagon wheel, wheel rim, alloy "
        "wheel, spare wheel, bicycle wheel, bike wheel, tractor wheel, train wheel, monster truck "
        "wheel",
        {
            "tyre": "+1f1f22 . rubber",
            "treads": "+161618 . rubber",
            "rim": "*c9ced3 . metal",
            "spokes": "*b4bac0 . metal",
            "hub": "&8d949b . metal",
            "nuts": "-4a4e53 . metal",
            "stripe": "+f2efe6",
        },
        Usual(0.65, RUBBER, 0.4),
    ),
}
