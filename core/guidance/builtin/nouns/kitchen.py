"""What is baked, fried, cooked and served, and the ware for it."""

from core.guidance.builtin.nouns.noun import CERAMIC, FLESH, PLANT, STEEL, Noun, Usual

KITCHEN_FOOD = {
    "donut": Noun(
        "doughnut, iced donut, frosted donut, glazed donut, iced doughnut, glazed doughnut, "
        "frosted doughnut, ring doughnut, sprinkled donut, pink donut; bagel, donut ring",
        {
            "dough": "-d89a4c",
            "icing": "*f27fae",
            "sprinkles": "+ffd84a",
            "strands": "-4fc3e0",
            "drops": "-fbf6ee",
        },
        Usual(0.1, 450.0, 0.7),
    ),
    "gingerbread man": Noun(
        "gingerbread, gingerbread cookie, gingerbread boy, ginger bread man; gingerbread woman, "
        "gingerbread figure, christmas cookie",
        {
            "body": "*a5622a",
            "icing": "+fbf4e8",
            "eyes": "-fbf4e8",
            "buttons": "-cf2430",
            "bow": "+2f8f46",
        },
        Usual(0.15, 650.0, 0.4),
    ),
    "watermelon slice": Noun(
        "slice of watermelon, water melon slice, sliced watermelon, piece of watermelon, "
        "watermelon wedge; melon slice, slice of melon",
        {"flesh": "*e5383c", "pith": "-e6f0c2", "rind": "-2f7d36", "seeds": "-231712"},
        Usual(0.25, PLANT),
    ),
    "fried egg": Noun(
        "sunny side up, fried eggs; omelette, omelet, poached egg",
        {"whites": "-fbf8f0", "yolk": "*f8ad1c", "edge": "-d9a560"},
        Usual(0.12, FLESH, 0.5),
    ),
}
KITCHEN_WARE = {
    "teacup": Noun(
        "tea cup, cup and saucer, cup of tea, cup with saucer, teacup and saucer, tea cups; "
        "espresso cup, cup of coffee, hot chocolate",
        {
            "cup": "*f3efe6 . ceramic",
            "saucer": "*f3efe6 . ceramic",
            "tea": "-9c4f1c",
            "rim": "+d8a83c . golden",
            "handle": "&f3efe6 . ceramic",
        },
        Usual(0.15, CERAMIC, 0.4),
    ),
    "cooking pot": Noun(
        "saucepot, stockpot, stock pot, soup pot, casserole, casserole dish; "
        "stew pot, pressure cooker, dutch oven, crock pot, saucepan with lid",
        {
            "body": "*c43a2c . paint",
            "rim": "-c3c8cd . metal",
            "handles": "+26272a . plastic",
            "lid": "*c43a2c . paint",
            "knob": "+26272a . plastic",
        },
        Usual(0.34, STEEL, 0.04),
    ),
}
