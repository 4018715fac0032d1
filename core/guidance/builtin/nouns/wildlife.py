"""Animals with spots, wings, long necks or flat tails, and two figures of tales."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

_EYES = "-14100e"

WILDLIFE = {
    "leopard": Noun(
        "; cheetah, jaguar, panther, snow leopard, ocelot, leopard cub, cheetah cub, black panther",
        {
            "body": "*e6b25a",
            "spots": "-3a2516",
            "muzzle": "+f6ecd6",
            "eyes": "-14140f",
            "nose": "-8a4a44",
        },
        Usual(1.9, FLESH, 0.25),
    ),
    "bat": Noun(
        "vampire bat; fruit bat, flying fox, halloween bat, baby bat",
        {
            "body": "*4a3e52",
            "wings": "&6b5578",
            "arms": "*3a3042",
            "ears": "+c98aa0",
            "eyes": "-e8b52a",
            "teeth": "-f6f2e6",
            "pupils": "-111111",
        },
        Usual(0.4, FLESH, 0.04),
    ),
    "ostrich": Noun(
        "ostriches; emu, rhea, cassowary, baby ostrich",
        {
            "body": "*2b2729",
            "plumes": "+f2eee4",
            "skin": "-dba58e",
            "bill": "-e09a4c",
            "hair": "&3a3234",
            "eyes": "-120f0e",
        },
        Usual(2.4, FLESH, 0.2),
    ),
    "beaver": Noun(
        "; platypus, muskrat, groundhog, baby beaver, capybara",
        {
            "body": "*7a4c2a",
            "belly": "+b98a5c",
            "tail": "-4a3a34",
            "lines": "-2f2724",
            "teeth": "-f4ecc8",
            "eyes": "-14100e",
        },
        Usual(0.9, FLESH, 0.2),
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
    "parrot": Noun(
        "parrots, macaw; parakeet, cockatoo, budgie, budgerigar, lovebird, ara",
        {
            "body": "*d1261f",
            "wings": "+2459b5",
            "coverts": "+f0bf2a",
            "face": "-f6f2ea",
            "bill": "-34302e",
            "eyes": _EYES,
            "feathers": "~143a78",
            "glints": "-ffffff",
        },
        Usual(0.8, FLESH, 0.02),
    ),
    "eagle": Noun(
        "bald eagle, eagles; hawk, falcon, vulture, condor, osprey, bird of prey, golden eagle",
        {
            "body": "*4a3020",
            "wings": "&3d281b",
            "head": "-f4f1ea",
            "bill": "-f2b526",
            "legs": "-e8a626",
            "eyes": _EYES,
            "glints": "-ffffff",
            "feathers": "~21150d",
        },
        Usual(1.2, FLESH, 0.03),
    ),
    "gorilla": Noun(
        "gorillas, silverback; ape, king kong, mountain gorilla, silverback gorilla",
        {
            "body": "*2f2c30",
            "face": "+7d7276",
            "back": "+9a9a9c",
            "eyes": "-100b09",
            "nostrils": "-19171a",
            "glints": "-ffffff",
            "mouth": "-2a2426",
        },
        Usual(1.6, FLESH, 0.22),
    ),
    "llama": Noun(
        "llamas; alpaca, vicuna, guanaco, baby llama",
        {
            "wool": "*efe3c8",
            "face": "+c9a67a",
            "blanket": "+c42a3c . fabric",
            "fringe": "+f0b62e . fabric",
            "hooves": "-3a2c26",
            "eyes": _EYES,
        },
        Usual(1.8, FLESH, 0.25),
    ),
    "sloth": Noun(
        "sloths, three toed sloth; baby sloth, two toed sloth",
        {
            "body": "*8f7a5e",
            "face": "+e9dab8",
            "marks": "-4a3527",
            "claws": "-f0e6cc",
            "branch": "-6b472c",
            "eyes": _EYES,
        },
        Usual(0.8, FLESH, 0.1),
    ),
}
LEGENDS = {
    "centaur": Noun(
        "; centaur warrior, centaur archer, female centaur",
        {
            "coat": "*7a4a2a",
            "skin": "-d9a47c",
            "hair": "+3a241a",
            "belt": "+b8862e . golden",
            "hooves": "-2e2622",
            "eyes": "-14100e",
        },
        Usual(2.3, FLESH, 0.5),
    ),
    "king": Noun(
        "monarch, emperor; old king, sultan, pharaoh",
        {
            "robe": "*a31f2a . fabric",
            "fur": "-f4f0e6 . fabric",
            "gold": "+e0b03a . golden",
            "skin": "-e2b08c",
            "beard": "-8a5a34",
            "eyes": "-16120e",
            "glints": "-ffffff",
            "spots": "-1c1a1c . fabric",
        },
        Usual(1.9, FLESH, 0.09),
    ),
    "griffin": Noun(
        "gryphon, griffon, griffins; hippogriff, baby griffin",
        {
            "body": "*c8963e",
            "feathers": "+f3ede0",
            "wings": "+8a5c30",
            "bill": "-f0b428",
            "tuft": "-6b4222",
            "eyes": _EYES,
            "glints": "-ffffff",
            "quills": "~5c3a1c",
        },
        Usual(2.4, FLESH, 0.3),
    ),
    "minotaur": Noun(
        "minotaurs, bull man; bull demon, minotaur warrior",
        {
            "body": "*c78a5c",
            "fur": "&5f3a24",
            "horns": "-ece0c4",
            "loincloth": "+8a2f1e . leather",
            "axe": "-b4b9bf . metal",
            "eyes": "-ffc93a",
        },
        Usual(2.5, FLESH, 0.21),
    ),
}
