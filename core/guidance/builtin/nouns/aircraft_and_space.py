"""What flies in the air or in space, and planets."""

from core.guidance.builtin.nouns.noun import (
    FABRIC,
    GLASS_LOOK,
    PLASTIC,
    STEEL,
    STONE,
    TYRES_LOOK,
    Noun,
    Usual,
)

AIRCRAFT_AND_SPACE = {
    "airplane": Noun(
        "plane, aeroplane, aircraft; airliner, jumbo jet, bomber, private jet, stealth bomber",
        {
            "body": "*e8eaed . paint",
            "wings": "&c7ccd2 . paint",
            "windows": "-25303a . glass",
            "engines": "-3d6fb3",
            "tail": "&c7ccd2 . paint",
            "intakes": "~26292d . paint",
            "stripe": "-3d6fb3 . paint",
            "bands": "-3d6fb3 . paint",
        },
        Usual(12.0, STEEL, 0.035),
        constructed=True,
    ),
    "biplane": Noun(
        "bi plane, double decker plane; propeller plane, prop plane, propeller airplane, "
        "propeller aircraft, stunt plane, crop duster, old plane, seaplane, glider",
        {
            "body": "*c4201c . paint",
            "wings": "&f0c22a . paint",
            "struts": "-6b4526",
            "engine": "-5a5f65 . metal",
            "propeller": "-8a5a30",
            "wheels": TYRES_LOOK,
        },
        Usual(8.0, STEEL, 0.01),
    ),
    "fighter jet": Noun(
        "jet fighter, fighter plane, jet, jet plane, fighter aircraft, jet aircraft, fighter jets, "
        "jets; stealth fighter, stealth jet",
        {
            "body": "*8b97a3 . paint",
            "wings": "&74818e . paint",
            "canopy": "-d9a13c . glass",
            "tails": "&5f6c79 . paint",
            "nozzles": "-3b3d40 . metal",
            "missiles": "+e8e9e6 . paint",
            "stars": "+e8e9e6 . paint",
            "nose": "~46525e . paint",
        },
        Usual(17.0, STEEL, 0.0081),
        constructed=True,
    ),
    "helicopter": Noun(
        "chopper helicopter, heli",
        {
            "body": "*c9241e . paint",
            "windows": GLASS_LOOK,
            "rotor": "+3a3d40",
            "skids": "-55595e . metal",
            "tail rotor": "-3a3d40",
            "panes": GLASS_LOOK,
            "doors": "~7d120e . paint",
            "bands": "+f4f1e6 . paint",
        },
        Usual(11.0, STEEL, 0.0042),
        constructed=True,
    ),
    "hot air balloon": Noun(
        "hot-air balloon, air balloon; montgolfier",
        {
            "balloon": "*d8432f . fabric",
            "basket": "+9a6a38",
            "ropes": "-6b5334",
            "belts": "+f0b429 . fabric",
            "panels": "+f1e3c2 . fabric",
            "weave": "~6e4522",
        },
        Usual(25.0, FABRIC, 0.00069),
    ),
    "blimp": Noun(
        "airship, air ship, zeppelin, dirigible",
        {
            "balloon": "*d9dde2 . paint",
            "band": "+c4281f . paint",
            "fins": "+c4281f . paint",
            "cabin": "-4a5058 . paint",
            "windows": "-8fd0ee . glass",
            "engines": "-3a3d42 . metal",
        },
        Usual(40, FABRIC, 0.005),
    ),
    "rocket": Noun(
        "rocket ship, space rocket; firework, rocketship",
        {
            "hull": "*e6e6e8",
            "nose": "+cc1a14",
            "fins": "+cc1a14",
            "nozzle": "-4d4d52 . metal",
            "window": "-6fb4e6 . glass",
            "rim": "-8f959c . metal",
            "bands": "+cc1a14",
            "hatch": "-8f959c . metal",
        },
        Usual(20.0, STEEL, 0.0029),
    ),
    "space shuttle": Noun(
        "shuttle, orbiter; space plane",
        {
            "body": "*eceef0",
            "wings": "&e2e4e7",
            "nose": "+2b2b2e",
            "windows": "-1e262d . glass",
            "engines": "-6d7278 . metal",
            "edges": "-2b2b2e",
            "doors": "~a9aeb4",
            "tiles": "-2b2b2e",
        },
        Usual(37.0, STEEL, 0.0028),
    ),
    "spaceship": Noun(
        "space ship, spacecraft, starship; star fighter, starfighter, x wing, "
        "spacefighter, alien fighter, space fighter, tie fighter",
        {
            "hull": "*d5d9de . paint",
            "wings": "*d5d9de . paint",
            "cockpit": "-22303c . glass",
            "guns": "+b3231f",
            "engines": "-55595f . metal",
            "flames": "-4fc3f0",
            "nose": "+b3231f . paint",
            "stripes": "+b3231f . paint",
        },
        Usual(12.0, STEEL, 0.02),
        constructed=True,
    ),
    "ufo": Noun(
        "flying saucer; alien ship, alien spaceship, mothership",
        {
            "body": "*a5adb5 . metal",
            "dome": "+6fd0c8 . glass",
            "lights": "-f5d63a",
            "legs": "-70777e . metal",
            "band": "~5f6a75 . metal",
            "seams": "~78828c . metal",
            "frames": "-70777e . metal",
        },
        Usual(12.0, STEEL, 0.0064),
    ),
    "satellite": Noun(
        "space satellite, communications satellite; space probe, sputnik, space telescope, hubble",
        {
            "body": "*d8a83c . golden",
            "panels": "+24408c",
            "arms": "-a0a5ab . metal",
            "dish": "-e4e6e8",
            "aerial": "-b0b5ba . metal",
            "lines": "-cfd8e0",
            "seams": "~9a6f1c . golden",
        },
        Usual(6.0, PLASTIC, 0.2),
    ),
    "space station": Noun(
        "space stations, orbital station, international space station, iss, space base, "
        "orbital space station; space colony, space habitat, starbase, skylab",
        {
            "core": "*eeebe4 . paint",
            "bands": "&8d949b . metal",
            "panels": "+2a55ad . glass",
            "arms": "-b98f3f . golden",
            "windows": "-ffd25e . glass",
            "dish": "-d5d8db . paint",
            "lines": "-cfd8e0",
        },
        Usual(100.0, STEEL, 0.004),
    ),
    "planet": Noun(
        "saturn, ringed planet, gas giant, planets, planet saturn, alien planet; uranus, "
        "exoplanet, "
        "fantasy planet",
        {
            "globe": "*d9b27a",
            "bands": "~b98a52",
            "rings": "+e6d3a6",
        },
        Usual(0.5, STONE, 0.3),
    ),
    "earth": Noun(
        "planet earth, blue marble, earth planet",
        {"body": "*2766b5 . plastic", "land": "+4d8f45 . plastic", "ice": "-f4f7f9 . plastic"},
        Usual(0.4, STONE, 0.03),
        "ball",
    ),
    "jupiter": Noun(
        "planet jupiter, jupiter planet",
        {
            "body": "*d9bd95 . plastic",
            "whorl": "-cc7a50 . plastic",
            "storm": "+b5512f . plastic",
            "bands": "&a9764c . plastic",
            "zones": "-f1e4cc . plastic",
        },
        Usual(0.4, STONE, 0.03),
        "ball",
    ),
    "mars": Noun(
        "planet mars, red planet, mars planet",
        {
            "body": "*c0623a . stone",
            "ice": "-f3efe9 . plastic",
            "craters": "~99472a . stone",
            "plains": "+a5512f . stone",
        },
        Usual(0.4, STONE, 0.03),
        "ball",
    ),
    "full moon": Noun(
        "moon globe, lunar globe, moon ball",
        {"body": "*d2d0c9 . stone", "craters": "-a6a49f . stone"},
        Usual(0.4, STONE, 0.03),
        "ball",
    ),
}
