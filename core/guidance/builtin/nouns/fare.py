"""Fare and plants: a burrito, a cinnamon roll, garlic, a kiwi, a lily pad in flower."""

from core.guidance.builtin.nouns.noun import FLESH, PLANT, Noun, Usual

FARE_FOOD = {
    "burrito": Noun(
        "burritos, bean burrito, breakfast burrito, beef burrito, chicken burrito, tortilla "
        "wrap, mexican burrito; chicken wrap, doner kebab, kebab, gyro, gyros, shawarma, falafel "
        "wrap, durum, chimichanga, enchilada",
        {
            "foil": "+c9ced3 . metal",
            "tortilla": "*ecd3a0",
            "toast": "-b5742f",
            "meat": "-6f3a1e",
            "lettuce": "-5fae35",
            "tomato": "-d83a28",
        },
        Usual(0.2, FLESH, 0.9),
    ),
    "cinnamon roll": Noun(
        "cinnamon rolls, cinnamon bun, cinnamon buns, cinnabon, cinnamon swirl, iced bun, sticky "
        "bun, glazed cinnamon roll; danish pastry, raisin swirl, swirl bun",
        {"bun": "*d7974a", "cinnamon": "-6e3314", "icing": "+fbf6ea"},
        Usual(0.11, FLESH, 0.4),
    ),
}
FARE_FRUIT = {
    "garlic": Noun(
        "garlics, garlic bulb, bulb of garlic, head of garlic, garlic head, garlic bulbs, garlic "
        "clove, clove of garlic, garlic cloves; fennel bulb",
        {
            "cloves": "*f3ecdc",
            "grooves": "&a98aa6",
            "neck": "&e6d9b8",
            "roots": "-b89a6a",
        },
        Usual(0.065, PLANT),
    ),
    "kiwi": Noun(
        "kiwis, kiwi fruit, kiwifruit, kiwi fruits, half kiwi, halved kiwi, sliced kiwi, kiwi "
        "half, cut kiwi, green kiwi, kiwi slice; golden kiwi",
        {
            "skin": "*7c5a34",
            "flesh": "-86bf2e",
            "middle": "-eef0c4",
            "seeds": "-1c1a17",
            "tips": "&4e371f",
        },
        Usual(0.09, PLANT),
    ),
}
FARE_PLANTS = {
    "lily pad": Noun(
        "lily pads, lilypad, lilypads, water lily, water lilies, waterlily, waterlilies, lotus "
        "pad, lotus leaf, lily pad with flower, water lily pad, lotus, lotus flower, pink lotus, "
        "lotus blossom, lotuses; victoria lily",
        {
            "leaf": "*3f8f3a",
            "veins": "&6fb553",
            "petals": "+f08bb4",
            "heart": "-f5c93a",
        },
        Usual(0.35, PLANT, 0.5),
    ),
}
