"""Telephones, cameras, television, and what plays or records sound."""

from core.guidance.builtin.nouns.noun import PLASTIC, STEEL, WOOD, Noun, Usual

PHONES_CAMERAS_AND_AUDIO = {
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
    "security camera": Noun(
        "cctv camera, cctv, surveillance camera, spy camera; webcam, web cam, ip camera",
        {
            "body": "*e6e8ea",
            "hood": "&c4c9ce",
            "lens": "-232428",
            "glass": "-3f6fa8 . glass",
            "stand": "+8d939a . metal",
            "light": "-e0241c",
            "letters": "-2b2f36",
            "vents": "-3a3f46",
        },
        Usual(0.25, PLASTIC, 0.18),
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
            "vents": "-263238",
        },
        Usual(0.6, STEEL, 0.047),
    ),
    "satellite dish": Noun(
        "radar dish, dish antenna, radar, parabolic antenna, satellite antenna, sat dish, "
        "tv dish; antenna, aerial, radar station, radar antenna, tv antenna, radio telescope",
        {
            "dish": "*d3d9de . paint",
            "rim": "&f1f3f4 . paint",
            "receiver": "+c8372d . plastic",
            "arms": "-4d545d . metal",
            "mast": "-7b828b . metal",
            "foot": "-5c636c . metal",
            "seams": "~8f979f",
        },
        Usual(1.4, STEEL, 0.08),
        constructed=True,
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
    "boombox": Noun(
        "boomboxes, boom box, boom boxes, ghetto blaster, ghettoblaster, cassette player, tape "
        "player, radio cassette player, radio cassette, cassette recorder, tape recorder, retro "
        "stereo, portable stereo; stereo, cd player, music box player",
        {
            "body": "*d8434e . plastic",
            "rims": "+d4d8dc . metal",
            "speakers": "-2c2e34 . rubber",
            "deck": "-40444f . plastic",
            "reels": "-f4f0e8 . plastic",
            "buttons": "+f6c63c . plastic",
            "handle": "+d4d8dc . metal",
        },
        Usual(0.6, PLASTIC, 0.25),
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
}
