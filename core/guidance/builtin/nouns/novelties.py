"""Novelties: toys, a cap, a revolver, and two animals of the sea."""

from core.guidance.builtin.nouns.noun import CERAMIC, FABRIC, FLESH, RUBBER, STEEL, Noun, Usual

NOVELTY_TOYS = {
    "piggy bank": Noun(
        "piggybank, money box, moneybox, pig bank, coin bank, piggy money box; savings box, "
        "penny bank",
        {
            "body": "*ee9aae . ceramic",
            "snout": "&f3b3c2 . ceramic",
            "ears": "&e5839b . ceramic",
            "eyes": "-241a1c . ceramic",
            "slot": "-3a1f28",
            "coin": "+f0bd3a . golden",
        },
        Usual(0.2, CERAMIC, 0.15),
    ),
    "rubber duck": Noun(
        "bath duck, rubber ducky, rubber duckie, toy duck, bath toy, plastic duck, squeaky duck; "
        "bathtub duck, pool duck",
        {
            "body": "*f8cf1d . plastic",
            "wings": "*f2c112 . plastic",
            "bill": "+f07a16 . plastic",
            "eyes": "-fbfaf5 . plastic",
            "pupils": "-16130f",
            "feathers": "~c98f0a",
            "glints": "-ffffff",
        },
        Usual(0.1, RUBBER, 0.25),
    ),
}
NOVELTY_CLOTHES = {
    "beanie": Noun(
        "beanie hat, knitted hat, knit hat, knitted cap, bobble hat, wool hat, woolly hat, "
        "winter hat, woollen hat, woolen hat, pom pom hat, wool cap, winter cap, knit cap; "
        "toque, ski hat, watch cap, stocking cap, beret, santa hat, santa claus hat, "
        "christmas hat, chef hat, chef cap, nightcap, night cap, sleeping cap, sailor hat, sailor "
        "cap, ushanka, skullcap, skull cap",
        {
            "cap": "*24607e . fabric",
            "ribs": "*2f7496 . fabric",
            "brim": "&1d4f69 . fabric",
            "ridges": "&2a6a89 . fabric",
            "pompom": "+f7f0e2 . fabric",
        },
        Usual(0.26, FABRIC, 0.15),
    ),
}
NOVELTY_ARMS = {
    "revolver": Noun(
        "six shooter, sixshooter, magnum, cowboy gun, western revolver, cowboy revolver, "
        "revolvers; peacemaker, western gun, cap gun",
        {
            "barrel": "*6d737b . metal",
            "frame": "*484d54 . metal",
            "cylinder": "*868c94 . metal",
            "grip": "+6b3c1f grain",
            "trigger": "-c9a24a . golden",
            "hammer": "&474b51 . metal",
        },
        Usual(0.28, STEEL, 0.25),
    ),
}
NOVELTY_ANIMALS = {
    "starfish": Noun(
        "star fish, sea star, seastar, starfishes; brittle star, sand dollar",
        {
            "body": "*e8743a",
            "knobs": "+f9c79a",
            "dots": "+f3a873",
            "center": "+fbd9b5",
        },
        Usual(0.2, FLESH, 0.5),
    ),
    "lobster": Noun(
        "lobsters, red lobster, cooked lobster; crayfish, crawfish, langoustine, crawdad, "
        "spiny lobster",
        {
            "body": "*cc2f22",
            "claws": "*d63a28",
            "tail": "*c42a1f",
            "legs": "&a8241b",
            "eyes": "-17110f",
            "feelers": "&e2674a",
            "glints": "-ffffff",
            "bands": "~7c1a12",
        },
        Usual(0.4, FLESH, 0.3),
    ),
}
