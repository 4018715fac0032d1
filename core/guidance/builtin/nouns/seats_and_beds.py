"""Chairs, sofas and other seats; beds, and a pillow."""

from core.guidance.builtin.nouns.noun import FABRIC, PLASTIC, WOOD, Noun, Usual

SEATS_AND_BEDS = {
    "chair": Noun(
        "dining chair",
        {
            "seat": "&8f5c30 grain",
            "back": "*8f5c30 grain",
            "legs": "*754a26 grain",
            "arms": "*754a26 grain",
            "seams": "~5f3a1c grain",
        },
        Usual(0.9, WOOD, 0.27),
    ),
    "armchair": Noun(
        "; recliner, easy chair, club chair, wing chair, wingback chair, lounge chair, egg "
        "chair, accent chair, reading chair",
        {
            "cushion": "&9e523d",
            "back": "*8a4230",
            "arms": "*8a4230",
            "legs": "-4a2f1c grain",
            "buttons": "~5f2a1d . fabric",
            "piping": "~5f2a1d . fabric",
        },
        Usual(1.0, FABRIC, 0.4),
    ),
    "office chair": Noun(
        "swivel chair, desk chair, computer chair",
        {
            "seat": "*2f3b4a . fabric",
            "back": "*2f3b4a . fabric",
            "base": "+8a9096 . metal",
            "wheels": "-1c1c1e . rubber",
            "arms": "-26282b",
            "seams": "~6d8096 . fabric",
        },
        Usual(1.1, PLASTIC, 0.15),
    ),
    "rocking chair": Noun(
        "rocker",
        {
            "seat": "*9a6534 grain",
            "back": "*8a582c grain",
            "legs": "*754a26 grain",
            "rockers": "&6a4222 grain",
            "arms": "*754a26 grain",
        },
        Usual(1.1, WOOD, 0.3),
    ),
    "gaming chair": Noun(
        "gaming chairs, gamer chair, gamers chair, racing chair, gamer's chair, streamer chair, "
        "esports chair, gaming seat; racing seat, bucket seat",
        {
            "seat": "*2e3038 . leather",
            "stripes": "+e0342c . leather",
            "pillows": "+e0342c . leather",
            "arms": "-4a4d55 . plastic",
            "base": "-5c6068 . metal",
            "wheels": "-26262c . rubber",
            "badge": "+e0342c . leather",
        },
        Usual(1.3, PLASTIC, 0.1),
    ),
    "throne": Noun(
        "royal chair, king's chair",
        {
            "cushion": "*a5161f . fabric",
            "frame": "+d9a93c . golden",
            "knobs": "-f0c95a . golden",
            "step": "-7a1620",
            "buttons": "-f0c95a . golden",
            "panels": "&b07f24 . golden",
            "gems": "-2f6fd0 . glass",
            "border": "-f0c95a . golden",
        },
        Usual(1.8, WOOD, 0.21),
    ),
    "sofa": Noun(
        "couch, settee; loveseat, sectional, futon, divan, chaise longue, chaise lounge, day "
        "bed, daybed",
        {
            "cushion": "&7a8fa3 . fabric",
            "back": "*5f7891 . fabric",
            "arms": "*5f7891 . fabric",
            "base": "*54697f . fabric",
            "feet": "-4a2f1c",
            "buttons": "~44586c . fabric",
            "piping": "~44586c . fabric",
        },
        Usual(2.0, FABRIC, 0.3),
    ),
    "stool": Noun(
        "; bar stool, barstool",
        {
            "seat": "&a06a38 grain",
            "legs": "*70472a grain",
            "band": "-c9a24a . golden",
            "seams": "~6f4622 grain",
        },
        Usual(0.6, WOOD, 0.21),
    ),
    "bench": Noun(
        "park bench; pew, church pew",
        {
            "seat": "*8f5c30 grain",
            "legs": "+3a3d40",
            "back": "*8f5c30 grain",
            "bolts": "-3a3d40 . metal",
            "seams": "~5a371a grain",
        },
        Usual(1.5, WOOD, 0.33),
    ),
    "ottoman": Noun(
        "footstool, pouf, pouffe; hassock",
        {
            "cushion": "*2f7f7a . fabric",
            "base": "*2a716d . fabric",
            "feet": "-4a2f1c grain",
            "button": "+e0b84a . golden",
            "nails": "+e0b84a . golden",
            "piping": "+e0b84a . fabric",
        },
        Usual(0.6, FABRIC, 0.5),
    ),
    "beanbag": Noun(
        "bean bag, beanbag chair, bean bag chair",
        {"body": "*d0542f . fabric", "loop": "&b34425 . fabric"},
        Usual(0.9, FABRIC, 0.1),
    ),
    "bed": Noun(
        "; mattress",
        {
            "blanket": "+3f6ea8",
            "mattress": "-ebe6dc",
            "pillow": "+f2efe8",
            "frame": "*7c4f2b grain",
            "stripes": "-eef0f2 . fabric",
            "panels": "~633d1f grain",
        },
        Usual(2.1, FABRIC, 0.3),
    ),
    "bunk bed": Noun(
        "bunk beds, bunkbed; loft bed",
        {
            "blanket": "+c23b34",
            "mattress": "-ebe6dc",
            "pillow": "+f2efe8",
            "frame": "*a8733e grain",
            "ladder": "&dcae6a grain",
            "rungs": "~7d5428 grain",
        },
        Usual(2.0, WOOD, 0.065),
    ),
    "four-poster bed": Noun(
        "four poster bed, fourposter bed, canopy bed, poster bed, 4 poster bed, princess bed; "
        "royal bed",
        {
            "frame": "*5f3a20 grain",
            "mattress": "-efe9de . fabric",
            "blanket": "+7a2436 . fabric",
            "pillow": "-f4f0e6 . fabric",
            "canopy": "+8a2c40 . fabric",
            "curtains": "+8a2c40 . fabric",
            "trim": "-d9ad45 . golden",
            "quilting": "~5a1a2a . fabric",
        },
        Usual(2.2, FABRIC, 0.2),
    ),
    "crib": Noun(
        "cot, baby bed; cradle, playpen, bassinet",
        {
            "frame": "*efe9dc",
            "mattress": "-dfe6ea",
            "pillow": "+f6f3ec",
            "blanket": "+8fb7d8",
            "hearts": "-e98fa8 . paint",
            "stars": "-fbf6e6 . fabric",
        },
        Usual(1.3, WOOD, 0.15),
    ),
    "pillow": Noun(
        "cushion, throw pillow; sofa cushion",
        {
            "body": "*c9545e . fabric",
            "button": "+e8c24a . fabric",
            "tassels": "+e8c24a . fabric",
            "border": "+e8c24a . fabric",
        },
        Usual(0.5, FABRIC, 0.19),
    ),
}
