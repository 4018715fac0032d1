"""Electronic devices."""

from core.guidance.builtin.nouns.noun import GLASS, PLASTIC, STEEL, WOOD, Noun, Usual

DEVICES = {
    "laptop": Noun(
        "notebook computer, laptop computer",
        {"body": "*a3a8ae . metal", "screen": "-2b5f9e", "keys": "+26282c", "touchpad": "-7f858c"},
        Usual(0.35, PLASTIC, 0.25),
    ),
    "phone": Noun(
        "smartphone, mobile phone, cell phone, cellphone; tablet, iphone",
        {"body": "*2a2c31", "screen": "-3f86c8", "camera": "-131416", "buttons": "+8b9096"},
        Usual(0.15, 2200.0, 0.45),
    ),
    "monitor": Noun(
        "computer monitor, computer screen, screen",
        {"body": "*26282c", "screen": "-3a78b8", "stand": "&3a3d42", "button": "-49d06a"},
        Usual(0.55, PLASTIC, 0.3),
    ),
    "keyboard": Noun(
        "computer keyboard",
        {"body": "*33363c", "keys": "+d9dbde", "accents": "-d8562a"},
        Usual(0.44, PLASTIC, 0.17),
    ),
    "camera": Noun(
        "photo camera, film camera; vintage camera",
        {
            "body": "*b4b7bb . metal",
            "grip": "+2a2624",
            "lens": "-1f2023",
            "glass": "-3f5f8a . glass",
            "button": "&8c9095 . metal",
            "flash": "-f4f1e2",
        },
        Usual(0.14, PLASTIC, 0.8),
    ),
    "speaker": Noun(
        "loudspeaker, speakers; subwoofer",
        {"body": "*4a2f1d grain", "cones": "-2b2c2f", "rims": "+9a9fa5 . metal"},
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
        },
        Usual(0.2, STEEL, 0.087),
    ),
    "radio": Noun(
        "transistor radio, portable radio; boombox",
        {
            "body": "*b23a2a",
            "speaker": "+e6dcc3",
            "dial": "-f2ead2",
            "knobs": "-3a2f28",
            "handle": "&8a2b20",
            "aerial": "-b9bdc2 . metal",
        },
        Usual(0.3, PLASTIC, 0.4),
    ),
    "game controller": Noun(
        "gamepad, game pad, controller; joystick",
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
        "rotary phone, old phone, rotary telephone, vintage phone; landline",
        {"body": "*b52a24", "dial": "+efe8d8", "hub": "-2a2a2c", "receiver": "&9c231e"},
        Usual(0.25, PLASTIC, 0.5),
    ),
    "headphones": Noun(
        "headphone, headset, earphones",
        {"band": "+2c2e33", "cups": "*d2382c", "cushions": "-1d1e20"},
        Usual(0.2, PLASTIC, 0.3),
    ),
    "drone": Noun(
        "quadcopter, quadrocopter",
        {
            "body": "*e6e8ea",
            "arms": "*c9cdd2",
            "rotors": "+2d2f33",
            "camera": "-17181a . glass",
            "legs": "-4a4d52",
        },
        Usual(0.4, PLASTIC, 0.15),
    ),
    "printer": Noun(
        "inkjet printer; laser printer, copier, fax machine",
        {
            "body": "*d4d7da",
            "paper": "-fbfbf8",
            "tray": "+5a5e64",
            "panel": "-2d5f8f",
            "buttons": "-3fae5a",
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
        },
        Usual(1.8, WOOD, 0.2),
    ),
    "television": Noun(
        "tv, tv set, television set; flatscreen, retro tv",
        {"body": "*3a2c24", "screen": "-16222c . glass", "stand": "&55504c", "buttons": "+d0b878"},
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
}
