"""Computers and what goes with them, machines of games, money and offices."""

from core.guidance.builtin.nouns.noun import PLASTIC, STEEL, WOOD, Noun, Usual

COMPUTERS_AND_GAME_MACHINES = {
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
    "computer tower": Noun(
        "computer towers, pc tower, gaming pc tower, tower pc, tower computer, desktop tower, "
        "gaming tower, gaming pc, gaming computer, gaming rig, gaming desktop, pc case, computer "
        "case, custom pc, rgb "
        "pc, pc build; gaming desktop computer, tower server, water cooled pc",
        {
            "body": "*26282c . paint",
            "window": "-33506b . glass",
            "fans": "-17181a . plastic",
            "lights": "+35d6f0 . plastic",
            "buttons": "&45494f . plastic",
            "feet": "-151617 . rubber",
            "ports": "-8a9096 . metal",
        },
        Usual(0.48, STEEL, 0.025),
    ),
    "server rack": Noun(
        "server, data rack, servers, rack of servers, computer server, server cabinet; "
        "data center, data centre, mainframe, supercomputer, network rack",
        {
            "cabinet": "*2b2f36 . metal",
            "units": "&6a717b . metal",
            "drives": "-1c1f24 . plastic",
            "lights": "+45e07a . plastic",
            "lamps": "+36a8ff . plastic",
            "vents": "&484e57 . metal",
        },
        Usual(2.0, STEEL, 0.06),
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
    "computer mouse": Noun(
        "pc mouse, optical mouse, wired mouse, desktop mouse, computer mice; gaming mouse, "
        "wireless mouse",
        {
            "body": "*e9ebee . plastic",
            "buttons": "&bcc4d0 . plastic",
            "wheel": "-26292e . rubber",
            "base": "-5a626e . plastic",
            "cable": "-2d3036 . rubber",
            "logo": "+3a6fd0 . plastic",
            "grips": "-5a626e . rubber",
        },
        Usual(0.2, PLASTIC, 0.25),
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
        constructed=True,
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
    "atm": Noun(
        "cash machine, cashpoint, cash point, atm machine, automated teller machine, "
        "cash dispenser; bank machine",
        {
            "body": "*d9dde2 . metal",
            "screen": "-1f6fb2 . glass",
            "keys": "-3a3f47 . plastic",
            "panels": "+1d4f9c . plastic",
            "letters": "-ffffff . plastic",
            "notes": "-6fae6a",
        },
        Usual(1.8, STEEL, 0.07),
    ),
    "game controller": Noun(
        "gamepad, game pad, controller; joystick, playstation, xbox",
        {
            "body": "*e4e6e9",
            "pad": "-2b2d31",
            "buttons": "+d8342c",
            "sticks": "-2b2d31 . rubber",
            "triggers": "&5b6068",
            "logo": "+4a8fe0",
            "grips": "-33363c . rubber",
        },
        Usual(0.16, PLASTIC, 0.7),
    ),
    "game console": Noun(
        "handheld console, handheld game console, handheld game, gameboy, game boy, gaming console,"
        " portable console; retro handheld, nintendo, video game console, handheld",
        {
            "body": "*cfcdc4 . plastic",
            "bezel": "&5b5c68 . plastic",
            "screen": "-9bb02c . glass",
            "cross": "-26262b . plastic",
            "buttons": "+a3244e . plastic",
            "keys": "-7d7d84 . rubber",
            "pixels": "-33401a",
            "seams": "~8c8a82",
        },
        Usual(0.15, PLASTIC, 0.35),
    ),
    "vr headset": Noun(
        "vr goggles, virtual reality headset, virtual reality goggles, vr glasses, vr, "
        "vr helmet, virtual reality glasses; ar headset, mixed reality headset, "
        "augmented reality headset",
        {
            "visor": "*eceef1 . plastic",
            "foam": "-26282c . fabric",
            "straps": "&c3c8d0 . fabric",
            "plate": "-1b1f28 . glass",
            "cameras": "+2f8fe0 . glass",
            "pads": "-33373d . rubber",
        },
        Usual(0.3, PLASTIC, 0.12),
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
    "slot machine": Noun(
        "one armed bandit, fruit machine, gambling machine, casino machine; pokie, pachinko, "
        "lottery machine",
        {
            "cabinet": "*b81f2a . paint",
            "sign": "&7d1420 . paint",
            "trim": "+e2b23e . golden",
            "reels": "-f6f3ea",
            "sevens": "-d01f26 . paint",
            "knob": "-e8402e . plastic",
            "badges": "+e2b23e . golden",
        },
        Usual(1.6, STEEL, 0.02),
    ),
}
