"""A jerrycan, goggles, a spyglass, a tricorn, a briefcase, a bubble tea."""

from core.guidance.builtin.nouns.noun import COPPER, FABRIC, LEATHER, PLASTIC, STEEL, Noun, Usual

TRAVEL_PROPS = {
    "jerrycan": Noun(
        "jerrycans, jerry can, jerry cans, jerican, fuel can, gas can, petrol can, gasoline can, "
        "fuel canister, gas canister, can of gas, can of petrol; oil can, water canister, "
        "oil canister, gasoline canister",
        {
            "body": "*4b5a34 . paint",
            "cross": "&4b5a34 . paint",
            "handles": "&4b5a34 . paint",
            "cap": "+33373b . metal",
            "seam": "&3f4c2c . paint",
        },
        Usual(0.47, STEEL, 0.02),
    ),
}
TRAVEL_SMALL = {
    "spyglass": Noun(
        "spyglasses, spy glass, hand telescope, handheld telescope, pocket telescope, pirate "
        "telescope, captain telescope, ship telescope, nautical telescope, naval telescope, "
        "sailor telescope; monocular, kaleidoscope",
        {
            "barrel": "*6a4124 . leather",
            "tubes": "&d9a94a . golden",
            "bands": "+d9a94a . golden",
            "lens": "-7fb0c8 . glass",
            "eyepiece": "-2a211c",
        },
        Usual(0.5, COPPER, 0.024),
    ),
    "bubble tea": Noun(
        "bubble teas, boba, boba tea, pearl milk tea, milk tea, boba milk tea, bubble milk tea, "
        "tapioca tea, cup of bubble tea, cup of boba, cup of milk tea; cup of iced coffee, cup of "
        "iced tea, iced coffee, iced tea, ice tea, smoothie, frappuccino, soft drink, lemonade, "
        "iced latte, juice, slushie",
        {
            "tea": "*cf9f6e . plastic",
            "pearls": "-2b1a14 . plastic",
            "lid": "-eef1f2 . plastic",
            "straw": "+e0527a . plastic",
            "rim": "-eef1f2 . plastic",
        },
        Usual(0.22, PLASTIC, 0.5),
    ),
}
TRAVEL_CLOTHES = {
    "goggles": Noun(
        "goggle, aviator goggles, flight goggles, flying goggles, pilot goggles, steampunk "
        "goggles, welding goggles; safety goggles, swimming goggles, swim goggles, lab goggles, "
        "ski goggles, snow goggles, motorcycle goggles, night vision goggles",
        {
            "cups": "*6b3f22 . leather",
            "rims": "+c79a3e . golden",
            "lenses": "-3f6f6a . glass",
            "strap": "&5a3820 . leather",
            "bridge": "&c79a3e . golden",
        },
        Usual(0.19, LEATHER, 0.2),
    ),
    "pirate hat": Noun(
        "pirate hats, tricorn, tricorne, captain hat, tricorn hat, tricorne hat, three cornered "
        "hat, pirate captain hat, captain hook hat, tricorns; bicorne, bicorn, musketeer hat, "
        "admiral hat, colonial hat",
        {
            "crown": "*211f22 . fabric",
            "brim": "*211f22 . fabric",
            "trim": "+d9b25a . golden",
            "feather": "-f0ebe0 . fabric",
        },
        Usual(0.42, FABRIC, 0.12),
    ),
    "briefcase": Noun(
        "briefcases, brief case, attache case, attaché case, attache, business briefcase; "
        "lawyer briefcase, document case, laptop case",
        {
            "body": "*6b3f22 . leather",
            "seam": "&4a2a17 . leather",
            "handle": "&4a2a17 . leather",
            "latches": "-e0b84a . golden",
            "corners": "+4a2a17 . leather",
            "stitches": "-d9a55c . fabric",
        },
        Usual(0.45, LEATHER, 0.15),
    ),
}
