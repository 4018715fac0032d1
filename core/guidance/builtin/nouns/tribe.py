"""Children, the folk of caves and tales, beasts of the past, and the cock of the yard."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

_SKIN, _EYES = "-e9b48f", "-1c1718"

CHILDREN_AND_TROLLS = {
    "girl": Noun(
        "girls, little girl, young girl; schoolgirl, school girl, daughter, teenage girl",
        {
            "dress": "*e0527e . fabric",
            "trim": "+f4ead8 . fabric",
            "skin": _SKIN,
            "hair": "-7a4526",
            "bows": "+f2c230 . fabric",
            "shoes": "&a8304e . leather",
            "eyes": _EYES,
            "mouth": "-b5524e",
        },
        Usual(1.2, FLESH, 0.13),
    ),
    "boy": Noun(
        "boys, little boy, young boy, child, children, kid, kids; schoolboy, school boy, son, "
        "teenager, teen",
        {
            "shirt": "*f0b62c . fabric",
            "stripe": "+f4ead8 . fabric",
            "shorts": "+3a62a8 . fabric",
            "cap": "&d0382c . fabric",
            "skin": _SKIN,
            "hair": "-5c3520",
            "shoes": "-b03228 . rubber",
            "eyes": _EYES,
        },
        Usual(1.2, FLESH, 0.2),
    ),
    "baby": Noun(
        "babies, infant, newborn, baby boy, baby girl; toddler, human baby",
        {
            "skin": "-f0bf9c",
            "diaper": "*f2f0ea . fabric",
            "hair": "-a8662e",
            "pacifier": "+4a9ad8 . plastic",
            "eyes": _EYES,
            "glints": "-ffffff",
            "cheeks": "-ee9a88",
            "brows": "-a8662e",
        },
        Usual(0.6, FLESH, 0.22),
    ),
    "troll": Noun(
        "trolls, cave troll; mountain troll, bridge troll, forest troll, swamp troll",
        {
            "skin": "*6f98a0",
            "nose": "+b0788a",
            "hair": "+43352b",
            "tusks": "-f0e6c8",
            "cloth": "+7a4c2c . leather",
            "club": "-a07444 . wooden",
            "eyes": "-f2c63a",
            "pupils": "-1a1512",
        },
        Usual(2.6, FLESH, 0.25),
    ),
    "cyclops": Noun(
        "cyclopes, cyclop, one eyed giant; polyphemus, one eyed monster",
        {
            "skin": "*c98658",
            "cloth": "+5e3a26 . leather",
            "horn": "-efe2c2",
            "mouth": "-4a1c1c",
            "whites": "-f4f0e8",
            "iris": "-3f8fc4",
            "pupils": "-1c1718",
        },
        Usual(3.5, FLESH, 0.25),
    ),
    "dwarf": Noun(
        "dwarves, dwarfs, fantasy dwarf, dwarf warrior; dwarven warrior, dwarf miner, dwarf king, "
        "dwarf smith, duergar",
        {
            "tunic": "*8e2f2a . fabric",
            "beard": "-d97a28",
            "helmet": "-9aa2aa . metal",
            "gold": "+e0b040 . golden",
            "skin": "-e3a680",
            "boots": "&4a3222 . leather",
            "handle": "-9a6c3e . wooden",
            "eyes": _EYES,
        },
        Usual(1.3, FLESH, 0.25),
    ),
    "monster": Noun(
        "monsters, furry monster, cute monster, cartoon monster, fluffy monster, friendly monster; "
        "fuzzy monster, creature, beast, toy monster, little monster, monster toy",
        {
            "fur": "*2fa8a4",
            "paws": "&7fd8c8",
            "horns": "-f2c65a",
            "mouth": "-5a1830",
            "teeth": "-f4f0e8",
            "eyes": "-f4f0e8",
            "pupils": "-1c1718",
            "spots": "~1f7f7c",
        },
        Usual(1.2, FLESH, 0.3),
    ),
}
DINOSAURS = {
    "velociraptor": Noun(
        "velociraptors, raptor, raptors; deinonychus, utahraptor, dromaeosaur, baby velociraptor, "
        "baby raptor",
        {
            "body": "*b8823e",
            "belly": "+ecd6a2",
            "stripes": "+a83a22",
            "claws": "-f0e4c4",
            "eyes": "-1c1718",
        },
        Usual(2.0, FLESH, 0.15),
    ),
    "pterodactyl": Noun(
        "pterodactyls, pterosaur, pterosaurs; pteranodon, quetzalcoatlus, baby pterodactyl",
        {
            "body": "*9a5a3c",
            "wings": "&e2a564",
            "belly": "+ecd2a0",
            "bill": "-f0b83c",
            "crest": "+c8342a",
            "eyes": "-1c1718",
        },
        Usual(3.0, FLESH, 0.02),
    ),
    "brachiosaurus": Noun(
        "brachiosaur, sauropod, long neck dinosaur, long necked dinosaur; brontosaurus, "
        "diplodocus, apatosaurus, argentinosaurus, long neck, baby brachiosaurus",
        {
            "body": "*5f9a8c",
            "belly": "+d8dcaa",
            "spots": "&3a7470",
            "nails": "-efe4c4",
            "eyes": "-1c1718",
        },
        Usual(22.0, FLESH, 0.1),
    ),
    "mammoth": Noun(
        "mammoths, woolly mammoth, wooly mammoth; mastodon, baby mammoth, mammoth calf",
        {
            "fur": "*9a6238",
            "hair": "&5a3620",
            "ears": "&7c4c2c",
            "tusks": "-f2e8d0",
            "nails": "-e0cba4",
            "eyes": "-1c1718",
        },
        Usual(4.2, FLESH, 0.8),
    ),
}
ROOSTERS = {
    "rooster": Noun(
        "roosters, cockerel, gamecock; bantam",
        {
            "body": "*8e3a1e",
            "neck": "+e8982c",
            "wings": "&6a2a1a",
            "tail": "+1f5a58",
            "comb": "-d8281f",
            "bill": "-f0bc3c",
            "legs": "-eaa832",
            "eyes": "-1c1718",
        },
        Usual(0.6, FLESH, 0.2),
    ),
}
