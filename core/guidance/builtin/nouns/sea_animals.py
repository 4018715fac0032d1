"""Animals of the sea and of ponds."""

from core.guidance.builtin.nouns.noun import EYES_LOOK, FLESH, Noun, Usual

SEA_ANIMALS = {
    "clownfish": Noun(
        "clown fish, nemo, anemonefish",
        {
            "body": "*ef7a1c",
            "fins": "&ef8a2c",
            "eyes": "-111114",
            "whites": "-f4f2ec",
            "lips": "&d8601a",
            "bands": "+f7f5f0",
            "edges": "-1b1a1c",
        },
        Usual(0.1, FLESH),
        "fish",
    ),
    "koi": Noun(
        "koi fish, koi carp, nishikigoi",
        {
            "body": "*f3efe8",
            "fins": "&efe6da",
            "eyes": "-111114",
            "whites": "-f4f2ec",
            "lips": "&efd9c8",
            "patches": "+e0561c",
        },
        Usual(0.6, FLESH),
        "fish",
    ),
    "pufferfish": Noun(
        "puffer fish, blowfish, blow fish, puffer, fugu, balloonfish; porcupinefish, porcupine "
        "fish",
        {
            "body": "*e9b23a",
            "belly": "&f5ead0",
            "spikes": "+9a5a24",
            "fins": "&e07a28",
            "mouth": "+e58674",
            "whites": "-f4f0e8",
            "eyes": EYES_LOOK,
        },
        Usual(0.3, FLESH, 0.3),
    ),
    "seahorse": Noun(
        "sea horse; pipefish, sea dragon, baby seahorse",
        {
            "body": "*f0a02e",
            "belly": "+fbdc8c",
            "bands": "&d8741e",
            "crest": "&d8741e",
            "fins": "+f8d27a",
            "eyes": "-16120e",
        },
        Usual(0.15, FLESH, 0.2),
    ),
    "stingray": Noun(
        "sting ray; manta ray, manta, eagle ray, ray fish",
        {
            "body": "*a08a5c",
            "belly": "+f0ebdd",
            "patches": "+3f8fd0",
            "horn": "-f0e6c8",
            "eyes": "-111111",
        },
        Usual(1.5, FLESH, 0.15),
    ),
    "jellyfish": Noun(
        "jelly fish; moon jelly",
        {
            "body": "*d98ac8",
            "rim": "&b763b0",
            "tentacles": "&c77fd0",
            "arms": "+f3d3ea",
            "patches": "+f6dcef",
        },
        Usual(0.6, FLESH, 0.1),
    ),
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
    "axolotl": Noun(
        "axolotls, mexican axolotl, baby axolotl; mudpuppy",
        {
            "body": "*f6b4c0",
            "fin": "&f9d3d6",
            "gills": "+e0466e",
            "mouth": "-a03a54",
            "cheeks": "-ef7f98",
            "eyes": EYES_LOOK,
        },
        Usual(0.25, FLESH, 0.5),
    ),
    "seal": Noun(
        "; sea lion, seal pup, baby seal, harbor seal, harp seal, manatee",
        {
            "body": "*6f7a86",
            "belly": "+cfd4d6",
            "fins": "&566270",
            "muzzle": "+e6e6e2",
            "eyes": "-111111",
            "nose": "-1c1a1c",
        },
        Usual(1.7, FLESH, 0.3),
    ),
    "walrus": Noun(
        "walruses; walrus calf, baby walrus",
        {
            "body": "*8c6048",
            "muzzle": "+d8b090",
            "tusks": "-f4eedc",
            "fins": "&6b4636",
            "eyes": EYES_LOOK,
            "nose": "-2a1c1a",
        },
        Usual(3.0, FLESH, 0.3),
    ),
    "orca": Noun(
        "orcas, killer whale, killer whales, orca whale; baby orca",
        {
            "body": "*292a32",
            "belly": "+f4f0e8",
            "patches": "+f4f0e8",
            "eyes": "-14100e",
        },
        Usual(6.0, FLESH),
        constructed=True,
    ),
}
