"""Less common birds."""

from core.guidance.builtin.nouns.noun import EYES_LOOK, FLESH, Noun, Usual

BIRDS = {
    "swan": Noun(
        "; cygnet",
        {
            "body": "*f4f3ef",
            "wings": "&e2e4e6",
            "face": "-1c1a1c",
            "bill": "-ee7f1c",
            "eyes": "-111111",
            "feathers": "~a9adb2",
            "glints": "-ffffff",
        },
        Usual(1.4, FLESH, 0.05),
    ),
    "flamingo": Noun(
        "flamingoes; heron, stork, crane bird, egret, ibis, spoonbill",
        {
            "body": "*f08aa0",
            "wings": "&e0607f",
            "legs": "-e88a92",
            "bill": "-f4dcc8",
            "tip": "-232024",
            "eyes": "-16141a",
        },
        Usual(1.3, FLESH, 0.1),
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
    "peacock": Noun(
        "peafowl; peahen",
        {
            "body": "*1f54b0",
            "tail": "+2a8a4a",
            "patches": "+d9a83c",
            "pupils": "+1c3f9a",
            "bill": "-cdb48a",
            "eyes": "-111111",
            "glints": "-ffffff",
        },
        Usual(1.5, FLESH, 0.02),
    ),
    "parrot": Noun(
        "parrots, macaw; parakeet, cockatoo, budgie, budgerigar, lovebird, ara",
        {
            "body": "*d1261f",
            "wings": "+2459b5",
            "coverts": "+f0bf2a",
            "face": "-f6f2ea",
            "bill": "-34302e",
            "eyes": EYES_LOOK,
            "feathers": "~143a78",
            "glints": "-ffffff",
        },
        Usual(0.8, FLESH, 0.02),
    ),
    "toucan": Noun(
        "toucans, toco toucan; hornbill, toucanet",
        {
            "body": "*1f1e23",
            "throat": "+f6f1e2",
            "bill": "+f2861c",
            "tip": "-17151a",
            "skin": "-3f86c8",
            "eyes": "-0e0b0c",
        },
        Usual(0.55, FLESH, 0.05),
    ),
    "eagle": Noun(
        "bald eagle, eagles; hawk, falcon, vulture, condor, osprey, bird of prey, golden eagle",
        {
            "body": "*4a3020",
            "wings": "&3d281b",
            "head": "-f4f1ea",
            "bill": "-f2b526",
            "legs": "-e8a626",
            "eyes": EYES_LOOK,
            "glints": "-ffffff",
            "feathers": "~21150d",
        },
        Usual(1.2, FLESH, 0.03),
    ),
}
