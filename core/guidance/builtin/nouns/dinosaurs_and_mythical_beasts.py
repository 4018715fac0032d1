"""Dinosaurs, a mammoth, a phoenix and a pegasus."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

DINOSAURS_AND_MYTHICAL_BEASTS = {
    "triceratops": Noun(
        "; styracosaurus, protoceratops, baby triceratops",
        {
            "body": "*6d8f6a",
            "frill": "+d08a4a",
            "horns": "-efe6cc",
            "bill": "-d2b87c",
            "hooves": "-e4d8ba",
            "eyes": "-111111",
        },
        Usual(8.5, FLESH, 0.42),
        constructed=True,
    ),
    "stegosaurus": Noun(
        "stegosaur; kentrosaurus, baby stegosaurus",
        {
            "body": "*5f8f8a",
            "belly": "+dccf9c",
            "plates": "+d9792c",
            "spikes": "-efe6cc",
            "hooves": "-e4d8ba",
            "eyes": "-111111",
        },
        Usual(8.0, FLESH, 0.42),
        constructed=True,
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
        Usual(22.0, FLESH, 0.17),
        constructed=True,
    ),
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
        Usual(2.0, FLESH, 0.26),
        constructed=True,
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
        Usual(4.2, FLESH),
        constructed=True,
    ),
    "phoenix": Noun(
        "phoenixes, fire bird, firebird; baby phoenix",
        {
            "body": "*c92a1c",
            "wings": "&e2581e",
            "tail": "&d83a1c",
            "tips": "+f8b62c",
            "bill": "-8a4a1c",
            "eyes": "-1a120c",
            "glints": "-ffffff",
            "feathers": "~a3341a",
        },
        Usual(1.2, FLESH, 0.04),
    ),
    "pegasus": Noun(
        "winged horse, flying horse, pegasi; baby pegasus",
        {
            "body": "*f4f1ec",
            "wings": "&dfe3ec",
            "feathers": "&f3f1ee",
            "mane": "+e6c46a",
            "hooves": "-a8803c",
            "eyes": "-1c2c4a",
            "socks": "?f3efe8",
        },
        Usual(2.6, FLESH, 0.9),
        constructed=True,
    ),
}
