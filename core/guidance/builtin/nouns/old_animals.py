"""Animals."""

from core.guidance.builtin.nouns.noun import FABRIC, FLESH, SNOW, Noun, Usual

ANIMALS = {
    "pig": Noun(
        "piggy; piglet, piggy bank",
        {"body": "*eda3a6", "snout": "+d97f86", "eyes": "-151212"},
        Usual(1.2, FLESH),
    ),
    "fish": Noun(
        "; goldfish, clownfish",
        {"body": "*ef7d1a", "fins": "+f5b03c", "eyes": "-111114"},
        Usual(0.3, FLESH),
    ),
    "rabbit": Noun(
        "bunny, bunnies",
        {"body": "*a58a70", "tail": "+f0ece4", "eyes": "-161212", "nose": "-d98a8f"},
        Usual(0.35, FLESH),
    ),
    "turtle": Noun(
        "; tortoise",
        {"shell": "*6b5a2c plates", "body": "+6da84a", "eyes": "-111111"},
        Usual(0.4, FLESH),
    ),
    "duck": Noun(
        "rubber duck, bath duck",
        {"body": "*f7cf1f", "wings": "&f2bd14", "bill": "-ee7a14", "eyes": "-131313"},
        Usual(0.4, FLESH, 0.6),
    ),
    "teddy bear": Noun(
        "teddy",
        {"body": "*96612f . fabric", "muzzle": "+d9b382 . fabric", "eyes": "-140f0c"},
        Usual(0.4, FABRIC, 0.3),
    ),
    "snowman": Noun(
        "snowmen",
        {"body": "*edf0f5", "nose": "-f27314", "buttons": "-0f0f0f", "hat": "+141417"},
        Usual(1.6, SNOW),
    ),
}
