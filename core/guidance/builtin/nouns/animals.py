"""What is known of four-legged animals."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

ANIMALS = {
    "cat": Noun(
        "kitty, house cat; kitten, tabby cat, tomcat",
        {"body": "*8a7a68", "muzzle": "+e8e0d4", "eyes": "-111111", "nose": "-d98a8f"},
        Usual(0.45, FLESH),
    ),
    "dog": Noun(
        "doggy, hound; puppy, labrador, beagle, retriever",
        {
            "body": "*b98a55",
            "ears": "&7a5632",
            "muzzle": "+e6d3b5",
            "eyes": "-111111",
            "nose": "-1a1818",
        },
        Usual(0.8, FLESH),
    ),
    "wolf": Noun(
        "grey wolf, gray wolf; coyote, husky",
        {
            "body": "*77787a",
            "muzzle": "+d0cfca",
            "eyes": "-111111",
            "nose": "-1a1818",
            "tail": "&5c5d60",
        },
        Usual(1.3, FLESH),
    ),
    "fox": Noun(
        "red fox; fox cub",
        {
            "body": "*cf6a24",
            "tail tip": "+f0ece4",
            "muzzle": "+f0ece4",
            "eyes": "-111111",
            "nose": "-1a1818",
        },
        Usual(0.9, FLESH),
    ),
    "bear": Noun(
        "brown bear; grizzly, grizzly bear, polar bear, black bear",
        {"body": "*6b4526", "muzzle": "+b08a5e", "eyes": "-111111", "nose": "-1a1818"},
        Usual(2.0, FLESH),
    ),
    "lion": Noun(
        "; lion king",
        {
            "body": "*d0a052",
            "mane": "+7d4a1e",
            "muzzle": "&ecd9ae",
            "eyes": "-111111",
            "nose": "-4a2c22",
        },
        Usual(2.2, FLESH),
    ),
    "cow": Noun(
        "; bull, ox, calf, cattle, dairy cow",
        {
            "body": "*ece8e0",
            "muzzle": "+e0a8a0",
            "horns": "-d8cba8",
            "eyes": "-111111",
            "udder": "-e0a8a0",
        },
        Usual(2.3, FLESH),
    ),
    "sheep": Noun(
        "; lamb, ewe",
        {"wool": "*ece7da", "head": "+3a3431", "legs": "+3a3431", "eyes": "-f0f0f0"},
        Usual(1.2, FLESH, 0.7),
    ),
    "elephant": Noun(
        "; mammoth, baby elephant",
        {"body": "*85868a", "ears": "&95919a", "tusks": "-efe6d0", "eyes": "-111111"},
        Usual(5.0, FLESH),
    ),
    "giraffe": Noun(
        "",
        {"body": "*d9a84e", "muzzle": "+ead6a8", "horns": "-6b4526", "eyes": "-111111"},
        Usual(4.8, FLESH),
    ),
}
