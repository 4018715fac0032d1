"""Wild animals, and those of the farm and the sea that came after the first ones."""

from core.guidance.builtin.nouns.noun import FLESH, Noun, Usual

WILD_ANIMALS = {
    "tiger": Noun(
        "tigers, bengal tiger, siberian tiger; tiger cub, tigress, sabertooth, saber tooth tiger",
        {
            "body": "*e0822a",
            "stripes": "+241a16",
            "muzzle": "+f4ecdc",
            "eyes": "-111111",
            "nose": "-c9757a",
        },
        Usual(2.4, FLESH, 0.3),
    ),
    "panda": Noun(
        "pandas, panda bear, giant panda; panda cub, baby panda",
        {
            "body": "*f1efe8",
            "limbs": "+25252a",
            "patches": "+25252a",
            "eyes": "-f4f2ec",
            "muzzle": "&e6e2d8",
            "nose": "-16161a",
        },
        Usual(1.3, FLESH, 0.4),
    ),
    "zebra": Noun(
        "zebras; zebra foal",
        {
            "body": "*f0ede6",
            "stripes": "+211f1f",
            "mane": "+211f1f",
            "muzzle": "-3c3634",
            "hooves": "-2a2624",
            "eyes": "-111111",
        },
        Usual(2.3, FLESH, 0.5),
    ),
    "goat": Noun(
        "goats, billy goat; nanny goat, mountain goat, ibex, ram, goat kid, baby goat",
        {
            "body": "*e6dfd0",
            "horns": "-8a7252",
            "beard": "+b7a98f",
            "hooves": "-3a322c",
            "eyes": "-16120e",
            "nose": "-b98780",
        },
        Usual(1.3, FLESH, 0.4),
    ),
    "camel": Noun(
        "camels; bactrian camel, dromedary",
        {
            "body": "*c9995c",
            "humps": "&8f6232",
            "muzzle": "+e3c796",
            "hooves": "-5a4432",
            "eyes": "-14100c",
        },
        Usual(2.8, FLESH, 0.4),
    ),
    "rhino": Noun(
        "rhinos, rhinoceros, rhinoceroses; white rhino, black rhino, baby rhino",
        {
            "body": "*8b8d90",
            "horns": "-e4dcc8",
            "plates": "&707276",
            "hooves": "-d0c8b6",
            "eyes": "-111111",
        },
        Usual(3.6, FLESH, 0.4),
    ),
    "hippo": Noun(
        "hippos, hippopotamus, hippopotami, hippopotamuses; pygmy hippo, baby hippo",
        {
            "body": "*85768a",
            "muzzle": "&b092a2",
            "nostrils": "-3a2c34",
            "teeth": "-f4efdf",
            "hooves": "-d9cfc4",
            "eyes": "-111111",
        },
        Usual(3.5, FLESH, 0.4),
    ),
    "kangaroo": Noun(
        "kangaroos; wallaby, wallabies, joey, baby kangaroo",
        {"body": "*b5763f", "belly": "+ecd6b0", "eyes": "-111111", "nose": "-2a1c18"},
        Usual(1.7, FLESH, 0.3),
    ),
    "koala": Noun(
        "koalas, koala bear; baby koala",
        {
            "body": "*8f959d",
            "ears": "+f0ebe6",
            "belly": "+e6e4e0",
            "eyes": "-111111",
            "nose": "-1c1b1f",
        },
        Usual(0.75, FLESH, 0.3),
    ),
    "squirrel": Noun(
        "squirrels; red squirrel, grey squirrel, gray squirrel, chipmunk",
        {
            "body": "*b8602a",
            "tail": "&96481c",
            "belly": "+f2e2c8",
            "nut": "-7a4e22",
            "eyes": "-111111",
            "nose": "-2a1a16",
        },
        Usual(0.3, FLESH, 0.2),
    ),
    "crocodile": Noun(
        "crocodiles, croc, alligator, alligators, gator; caiman, baby crocodile",
        {
            "body": "*5c7d34",
            "belly": "+d8cf94",
            "crest": "&3f5a24",
            "teeth": "-f6f2e2",
            "eyes": "-f0c42c",
        },
        Usual(4.0, FLESH, 0.25),
    ),
    "jellyfish": Noun(
        "jellyfishes, jelly fish, jellies; medusa, man of war, moon jelly",
        {
            "body": "*d98ac8",
            "rim": "&b763b0",
            "tentacles": "&c77fd0",
            "arms": "+f3d3ea",
            "dots": "+f6dcef",
        },
        Usual(0.6, FLESH, 0.1),
    ),
    "flamingo": Noun(
        "flamingos, flamingoes; heron, herons, stork, storks, crane bird, egret, ibis, spoonbill",
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
}
