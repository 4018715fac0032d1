"""Electronic devices."""

from core.guidance.builtin.nouns.noun import GLASS, PLASTIC, STEEL, WOOD, Noun, Usual

DEVICES = {
    "laptop": Noun(
        "notebook computer, laptop computer; macbook, chromebook, notebook pc",
        {
            "body": "*a3a8ae . metal",
            "screen": "-2b5f9e",
            "keys": "+26282c keys",
            "touchpad": "-7f858c",
            "icons": "-cfe0f2",
            "badge": "-e9edf1 . metal",
        },
        Usual(0.35, PLASTIC, 0.25),
    ),
    "phone": Noun(
        "smartphone, mobile phone, cell phone, cellphone; tablet, iphone, ipad, kindle, e "
        "reader, walkman, mp3 player, router, modem",
        {
            "body": "*2a2c31",
            "screen": "-3f86c8",
            "camera": "-4b5058",
            "buttons": "+8b9096",
            "icons": "-e6eef6",
            "lenses": "-0b0c0f . glass",
        },
        Usual(0.15, 2200.0, 0.45),
    ),
    "monitor": Noun(
        "computer monitor, computer screen, screen; computer display",
        {
            "body": "*26282c",
            "screen": "-3a78b8",
            "stand": "&3a3d42",
            "button": "-49d06a",
            "icons": "-cfe2f5",
            "slots": "-121316",
        },
        Usual(0.55, PLASTIC, 0.3),
    ),
    "keyboard": Noun(
        "computer keyboard, mechanical keyboard, gaming keyboard",
        {"body": "*33363c", "keys": "+d9dbde", "accents": "-d8562a", "letters": "-33363c"},
        Usual(0.44, PLASTIC, 0.17),
    ),
    "camera": Noun(
        "photo camera, film camera; vintage camera, polaroid, camcorder",
        {
            "body": "*b4b7bb . metal",
            "grip": "+2a2624",
            "lens": "-1f2023",
            "glass": "-3f5f8a . glass",
            "button": "&8c9095 . metal",
            "flash": "-f4f1e2",
            "rings": "-c9ced3 . metal",
            "screen": "-2c5a86 . glass",
        },
        Usual(0.14, PLASTIC, 0.8),
    ),
    "speaker": Noun(
        "loudspeaker, speakers; subwoofer, amplifier, guitar amp, amp, bluetooth speaker, smart "
        "speaker",
        {
            "body": "*4a2f1d grain",
            "cones": "-2b2c2f",
            "rims": "+9a9fa5 . metal",
            "caps": "+8d9299 . metal",
            "rings": "-53565c . rubber",
        },
        Usual(0.5, WOOD, 0.5),
    ),
    "microphone": Noun(
        "mic, mike",
        {
            "head": "+a9aeb4 . metal",
            "handle": "*232428",
            "ring": "&7b8087 . metal",
            "switch": "-d2412b",
            "stand": "-2f3135 . metal",
            "mesh": "-3b3d41 . metal",
        },
        Usual(0.2, STEEL, 0.087),
    ),
    "radio": Noun(
        "transistor radio, portable radio; walkie talkie",
        {
            "body": "*b23a2a",
            "speaker": "+e6dcc3",
            "dial": "-f2ead2",
            "knobs": "-3a2f28",
            "handle": "&8a2b20",
            "aerial": "-b9bdc2 . metal",
            "slots": "-4a3c30",
            "marks": "-6e3b2a",
        },
        Usual(0.3, PLASTIC, 0.4),
    ),
    "game controller": Noun(
        "gamepad, game pad, controller; joystick, playstation, xbox",
        {
            "body": "*e4e6e9",
            "pad": "-2b2d31",
            "buttons": "+d8342c",
            "sticks": "-2b2d31 . rubber",
            "triggers": "&5b6068",
        },
        Usual(0.16, PLASTIC, 0.7),
    ),
    "light bulb": Noun(
        "lightbulb, bulb",
        {"bulb": "*f7e08a . glass", "cap": "+a6abb1 . metal", "tip": "-2a2a2c"},
        Usual(0.11, GLASS, 0.08),
    ),
    "telephone": Noun(
        "rotary phone, old phone, rotary telephone, vintage phone; landline, desk phone",
        {
            "body": "*b52a24",
            "dial": "+efe8d8",
            "hub": "-2a2a2c",
            "receiver": "&9c231e",
            "holes": "-3a2f28",
        },
        Usual(0.25, PLASTIC, 0.5),
    ),
    "headphones": Noun(
        "headphone, headset, earphones; earbuds, earmuffs, ear muffs, airpods",
        {
            "band": "+2c2e33",
            "cups": "*d2382c",
            "cushions": "-1d1e20",
            "badges": "-f2efe8",
        },
        Usual(0.2, PLASTIC, 0.3),
    ),
    "drone": Noun(
        "quadcopter, quadrocopter; quad copter, uav",
        {
            "body": "*e6e8ea",
            "arms": "*c9cdd2",
            "rotors": "+2d2f33",
            "camera": "-17181a . glass",
            "legs": "-4a4d52",
            "lamps": "-49d06a",
            "seams": "~9aa0a6",
        },
        Usual(0.4, PLASTIC, 0.15),
    ),
    "printer": Noun(
        "inkjet printer; laser printer, copier, fax machine, photocopier, scanner",
        {
            "body": "*d4d7da",
            "paper": "-fbfbf8",
            "tray": "+5a5e64",
            "panel": "-2d5f8f",
            "buttons": "-3fae5a",
            "lines": "-5a5e64",
        },
        Usual(0.45, PLASTIC, 0.2),
    ),
    "arcade machine": Noun(
        "arcade cabinet, arcade game; arcade, pinball machine",
        {
            "body": "*2f3f9e . paint",
            "screen": "-17202c",
            "marquee": "+f4b81e",
            "joystick": "-c9261f",
            "buttons": "-f2d12a",
            "door": "-3b3d42 . metal",
            "pixels": "-6fe07a",
            "stripes": "+f4b81e",
        },
        Usual(1.8, WOOD, 0.2),
    ),
    "television": Noun(
        "tv, tv set, television set; flatscreen, retro tv, crt",
        {
            "body": "*3a2c24",
            "screen": "-16222c . glass",
            "stand": "&55504c",
            "buttons": "+d0b878",
            "glare": "-3f5665 . glass",
            "slots": "-17120f",
        },
        Usual(1.1, PLASTIC, 0.041),
    ),
    "typewriter": Noun(
        "type writer",
        {
            "body": "*2f5f5c . paint",
            "keys": "+f0e8d6",
            "roller": "-1f2022 . rubber",
            "knobs": "-a3a9b0 . metal",
            "paper": "-faf8f0",
        },
        Usual(0.42, STEEL, 0.08),
    ),
    "jukebox": Noun(
        "juke box",
        {
            "body": "*8a4526 grain",
            "lights": "+ffb52e",
            "window": "-7fd0d8 . glass",
            "grille": "&b3242c",
            "bars": "-e8c35a . golden",
            "buttons": "-f4efe2",
        },
        Usual(1.5, WOOD, 0.22),
    ),
    "desktop computer": Noun(
        "computer, pc, personal computer, home computer, desktop pc, retro computer, "
        "old computer; workstation",
        {
            "body": "*ddd3b8",
            "screen": "-2f6f8f . glass",
            "keyboard": "&cfc4a6 keys",
            "keys": "+6d665a",
            "slot": "-2c2b29",
            "button": "-58b368",
            "letters": "-a8f0b4",
            "vents": "-5e584a",
        },
        Usual(0.5, PLASTIC, 0.26),
    ),
    "coffee machine": Noun(
        "coffee maker, coffeemaker, coffee brewer, filter coffee machine, drip coffee maker; "
        "espresso machine, espresso maker",
        {
            "body": "*b8322c",
            "jug": "-4a2414 . glass",
            "collar": "+24252a",
            "handle": "+24252a",
            "plate": "-b9bec4 . metal",
            "panel": "-d7dade . metal",
            "digits": "-1d1f22",
            "buttons": "-e4a02c",
        },
        Usual(0.35, PLASTIC, 0.11),
    ),
    "vacuum cleaner": Noun(
        "vacuum, hoover, vacuum machine, upright vacuum; dust buster, carpet cleaner, robot "
        "vacuum, roomba, shop vac",
        {
            "body": "*6b3fa0",
            "cup": "-a9d6dc . glass",
            "base": "+f0b429",
            "pole": "-b7bbc1 . metal",
            "grip": "+2b2c31",
            "wheels": "-2b2c31 . rubber",
        },
        Usual(1.1, PLASTIC, 0.077),
    ),
    "lawn mower": Noun(
        "lawnmower, mower, grass mower, grass cutter",
        {
            "deck": "*c8281f . paint",
            "engine": "+2d2f33",
            "wheels": "-222326 . rubber",
            "hubs": "-e6c22f",
            "handle": "-3c3f45 . metal",
            "bag": "-4d5157 . fabric",
        },
        Usual(1.5, STEEL, 0.013),
    ),
    "power drill": Noun(
        "drill, electric drill, cordless drill, hand drill, drill machine, drilling machine; "
        "screwdriver drill, power tool, impact driver",
        {
            "body": "*f2b01e",
            "chuck": "-3a3c41 . metal",
            "bit": "-b4b9bf . metal",
            "grip": "+26272b . rubber",
            "battery": "&2f3136",
            "trigger": "-c7281f",
        },
        Usual(0.25, 2500.0, 0.6),
    ),
    "sewing machine": Noun(
        "; embroidery machine, overlocker",
        {
            "body": "*1f2b33 . paint",
            "base": "+8a5128 grain",
            "wheel": "-c9ced4 . metal",
            "needle": "-d4d8dc . metal",
            "spool": "-d23a4e",
            "band": "-e3bb4c . golden",
        },
        Usual(0.42, STEEL, 0.23),
    ),
    "record player": Noun(
        "gramophone, phonograph, grammophone, victrola, vinyl record player, gramophone record "
        "player; turntable, vinyl player, record deck, vinyl record deck, lp player, "
        "lp record player",
        {
            "horn": "*e0ac3c . golden",
            "pipe": "-c79734 . golden",
            "case": "+7a3d1c grain",
            "record": "-18181b",
            "label": "-c3262b",
            "crank": "-b08a3a . golden",
            "grooves": "-4c4c55",
            "panels": "~4c230e grain",
        },
        Usual(0.7, WOOD, 0.37),
    ),
    "projector": Noun(
        "film projector, movie projector, cinema projector, cine projector; "
        "video projector, slide projector, beamer",
        {
            "body": "*5f7f86 . paint",
            "lens": "-26272b",
            "reels": "+3a3c42 . metal",
            "hubs": "-d9b24a . golden",
            "base": "&3f555b . paint",
            "door": "-c6cace . metal",
        },
        Usual(0.6, STEEL, 0.047),
    ),
    "clothes iron": Noun(
        "steam iron, flat iron, flatiron, clothing iron, electric iron, ironing iron, laundry iron",
        {
            "body": "*2f7fc4",
            "sole": "-c9ced4 . metal",
            "handle": "+eef0f2",
            "dial": "-e4572e",
            "button": "-e4572e",
        },
        Usual(0.28, PLASTIC, 0.57),
    ),
    "cash register": Noun(
        "till, cashregister, shop till; checkout register",
        {
            "body": "*8f2a24 . paint",
            "keys": "-f3ead4",
            "display": "-efe9d6",
            "frame": "+e0b24a . golden",
            "drawer": "&6e1f1b . paint",
            "knob": "-e0b24a . golden",
            "digits": "-1c1c1e",
            "border": "-e0b24a . golden",
        },
        Usual(0.45, STEEL, 0.053),
    ),
    "calculator": Noun(
        "pocket calculator, desk calculator, electronic calculator; adding machine",
        {
            "body": "*34373d",
            "display": "-a9c3a0",
            "keys": "+e7e9ec",
            "accents": "-e8832a",
            "digits": "-1f2a1e",
            "numbers": "-2b2e33",
            "symbols": "-fff4e6",
        },
        Usual(0.15, PLASTIC, 0.23),
    ),
    "hair dryer": Noun(
        "hairdryer, hair drier, hairdrier, blow dryer, blowdryer; heat gun, hair straightener, "
        "curling iron",
        {
            "body": "*e0527f",
            "nozzle": "+2b2c31",
            "grip": "*e0527f",
            "grille": "-b9bec4 . metal",
            "buttons": "-f4f1ea",
            "ring": "-c9ced3 . metal",
        },
        Usual(0.27, PLASTIC, 0.27),
    ),
    "security camera": Noun(
        "cctv camera, cctv, surveillance camera, spy camera; webcam, web cam, ip camera",
        {
            "body": "*e6e8ea",
            "hood": "&c4c9ce",
            "lens": "-232428",
            "glass": "-3f6fa8 . glass",
            "stand": "+8d939a . metal",
            "light": "-e0241c",
        },
        Usual(0.25, PLASTIC, 0.18),
    ),
}
