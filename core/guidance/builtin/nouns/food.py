"""Food; fruit and vegetables are among it."""

from core.guidance.builtin.nouns.noun import FLESH, GLASS, PLANT, SNOW, STEEL, Noun, Usual

FOOD = {
    "hamburger": Noun(
        "burger, cheeseburger; big mac, slider",
        {"bun": "*cf8a3c", "lettuce": "+5fae34", "patty": "-5a3019", "cheese": "-f5b52a"},
        Usual(0.12, 500.0),
    ),
    "ice cream": Noun(
        "icecream, ice cream cone; gelato, gelato cone, soft serve, snow cone",
        {"scoop": "*f6c6cc", "cone": "+c98a45 waffle", "cherry": "-b8121f"},
        Usual(0.18, 600.0, 0.63),
    ),
    "pineapple": Noun(
        "",
        {"body": "*dd9a26 scales", "leaves": "+3c7d33"},
        Usual(0.3, PLANT, 0.46),
    ),
    "apple": Noun(
        "",
        {"body": "*c4201f", "stalk": "-523219", "leaf": "+4d9a35"},
        Usual(0.08, 800.0),
    ),
    "carrot": Noun(
        "",
        {"body": "*ee7415", "leaves": "+3f9433"},
        Usual(0.2, 1000.0, 0.5),
    ),
    "cupcake": Noun(
        "cup cake; muffin, fairy cake",
        {"icing": "*f3a9c4", "cup": "+8a5a3a", "cherry": "-b8121f"},
        Usual(0.08, 400.0),
    ),
    "pumpkin": Noun(
        "; jack o lantern, gourd, squash",
        {"body": "*e27414", "stalk": "+5c6b2c"},
        Usual(0.35, PLANT, 0.6),
    ),
    "banana": Noun(
        "bananas; plantain",
        {"peel": "*f4cf2e", "ends": "+5a4422"},
        Usual(0.19, PLANT, 0.72),
    ),
    "pear": Noun(
        "",
        {"body": "*b7c23a", "stalk": "-523219", "leaf": "+4d9a35"},
        Usual(0.12, PLANT, 0.75),
    ),
    "strawberry": Noun(
        "strawberries; raspberry, berry, blackberry",
        {"body": "*d3182a", "leaves": "+4a9636", "seeds": "-f0d27a"},
        Usual(0.05, PLANT),
    ),
    "cherry": Noun(
        "cherries",
        {"fruits": "*b40f22", "stalks": "-6d7a2e", "leaf": "+4d9a35"},
        Usual(0.08, PLANT, 0.31),
    ),
    "lemon": Noun(
        "; lime fruit, citrus, citron",
        {"body": "*f4d92b", "leaf": "+4a9636"},
        Usual(0.1, PLANT),
    ),
    "watermelon": Noun(
        "water melon; melon, cantaloupe, honeydew",
        {"rind": "+2f7d36", "flesh": "*e2343f", "seeds": "-1f1512"},
        Usual(0.3, PLANT),
    ),
    "grapes": Noun(
        "grape, bunch of grapes",
        {"grapes": "*5f2a78", "stalk": "-6a4a28", "leaf": "+4f9238"},
        Usual(0.18, PLANT, 0.8),
    ),
    "avocado": Noun(
        "; guacamole",
        {"skin": "+2f4a24", "flesh": "*c9d46a", "stone": "-7a4a22"},
        Usual(0.11, PLANT),
    ),
    "corn": Noun(
        "maize, corn cob, corncob, corn on the cob",
        {"kernels": "*f2c52e", "husk": "+6fa23c"},
        Usual(0.25, PLANT, 0.19),
    ),
    "broccoli": Noun(
        "; cauliflower",
        {"florets": "*2f7a30", "stem": "+8fb860"},
        Usual(0.18, PLANT, 0.6),
    ),
    "eggplant": Noun(
        "aubergine",
        {"body": "*3f1d4f", "cap": "+5a8a3a"},
        Usual(0.22, PLANT, 0.57),
    ),
    "pepper": Noun(
        "bell pepper, paprika, capsicum; chili, chilli, jalapeno",
        {"body": "*cf1f1a", "stalk": "+4f8a32"},
        Usual(0.12, PLANT, 0.4),
    ),
    "onion": Noun(
        "; garlic, shallot, garlic bulb, turnip, radish, beet, beetroot",
        {"body": "*c98a45", "roots": "-e3d3b0"},
        Usual(0.09, PLANT),
    ),
    "peach": Noun(
        "; nectarine, apricot, plum, mango",
        {"body": "*f2a065", "stalk": "-5c3a1e", "leaf": "+4d9a35"},
        Usual(0.08, PLANT, 0.75),
    ),
    "bread": Noun(
        "loaf, loaf of bread, bread loaf; toast, baguette, sourdough, bun, bread roll, brioche",
        {"crust": "*b8742e", "crumb": "+f1dcae"},
        Usual(0.28, 300.0, 0.39),
    ),
    "croissant": Noun(
        "; pastry, danish",
        {"crust": "*d1913f", "folds": "&a8662a"},
        Usual(0.16, 300.0),
    ),
    "pizza": Noun(
        "; pizza slice, pizza pie",
        {"crust": "+c98a42", "cheese": "*f4c64f", "salami": "-b5301f", "olives": "-26231c"},
        Usual(0.3, 700.0, 0.6),
    ),
    "hot dog": Noun(
        "hotdog; sausage, frankfurter, corn dog, bratwurst",
        {"bun": "*d79a4c", "sausage": "+b0452a", "mustard": "-f4c820"},
        Usual(0.18, 600.0, 0.55),
    ),
    "sandwich": Noun(
        "club sandwich; toastie, blt, grilled cheese, panini",
        {
            "bread": "*dba765",
            "lettuce": "+5fae34",
            "ham": "-e58d8f",
            "tomato": "-c92a1e",
            "cheese": "-f5c244",
        },
        Usual(0.14, 500.0),
    ),
    "cake": Noun(
        "birthday cake; torte, wedding cake, cheesecake",
        {"icing": "*f6b7c8", "body": "+8a5430", "topping": "-c2182b", "plate": "-ece9e2"},
        Usual(0.28, 450.0),
    ),
    "cookie": Noun(
        "chocolate chip cookie; biscuit, oreo, macaron, cracker",
        {"body": "*cc9248", "chips": "+43230f"},
        Usual(0.08, 500.0),
    ),
    "cheese": Noun(
        "swiss cheese, cheese wedge; cheddar, parmesan, brie, cheese wheel, wheel of cheese",
        {"body": "*f6c63a", "rind": "+d98e22"},
        Usual(0.15, FLESH),
    ),
    "egg": Noun(
        "; easter egg",
        {"shell": "*ead2b4"},
        Usual(0.06, FLESH, 0.9),
    ),
    "fries": Noun(
        "french fries; chips",
        {"carton": "*cf1f1c", "fries": "+f3c64a"},
        Usual(0.16, 350.0, 0.54),
    ),
    "pancakes": Noun(
        "pancake, stack of pancakes",
        {"pancakes": "*d99a48", "syrup": "+7a3c12", "butter": "-f8e58a", "plate": "-eceae4"},
        Usual(0.22, 600.0, 0.45),
    ),
    "lollipop": Noun(
        "lolly, lollypop; candy, candy pop, chupa chup",
        {"candy": "*e23a5e", "swirl": "+f8f2ee", "stick": "-f1ece2"},
        Usual(0.18, 1200.0, 0.2),
    ),
    "popsicle": Noun(
        "ice lolly, ice pop, ice cream bar; popsicle stick, creamsicle",
        {"ice": "*e8364a", "top": "+f6b02f", "stick": "-d9b382 grain"},
        Usual(0.18, SNOW, 0.54),
    ),
    "pretzel": Noun(
        "; bretzel",
        {"dough": "*9a5322", "salt": "+f4efe4"},
        Usual(0.16, 400.0),
    ),
    "pie": Noun(
        "apple pie, cherry pie; tart, quiche",
        {"crust": "*d49a4e", "filling": "+a8222a", "dish": "-d8d4cc"},
        Usual(0.28, 700.0),
    ),
    "can": Noun(
        "soda can, tin can, beverage can; beer can, soup can, energy drink, can of soda, "
        "can of beans, can of soup, soda, cola, coke, pepsi",
        {"label": "*c91f25 . paint", "can": "+b9bdc2 . metal", "tab": "-9a9ea4 . metal"},
        Usual(0.12, STEEL, 0.071),
    ),
    "jar": Noun(
        "jam jar; honey jar, cookie jar, mason jar, jar of honey, jar of jam, peanut "
        "butter, honey pot",
        {"body": "*b8324a . glass", "lid": "+d9b04a . metal", "label": "-f2ead6"},
        Usual(0.14, GLASS, 0.16),
    ),
    "taco": Noun(
        "tacos; burrito",
        {"shell": "*e5b04a", "meat": "-6a3a1c", "lettuce": "+5fae34", "tomato": "-cc2a1e"},
        Usual(0.16, 600.0, 0.55),
    ),
    "sushi": Noun(
        "sushi roll; maki, nigiri",
        {"rice": "*f4f1ea", "fish": "+f0804a", "seaweed": "-1f2e24"},
        Usual(0.06, FLESH),
    ),
    "milk carton": Noun(
        "carton of milk; milk, juice carton, juice box, carton, carton of juice, orange juice",
        {"carton": "*f2f3f4", "top": "+2f6fc2", "cap": "-d8352a"},
        Usual(0.24, FLESH, 0.32),
    ),
    "candy cane": Noun(
        "candycane, christmas candy cane, candy stick",
        {"candy": "*f6f2ee", "stripes": "+d01c28"},
        Usual(0.15, 1300.0, 0.2),
    ),
    "sundae": Noun(
        "ice cream sundae, ice cream cup; parfait, milkshake, knickerbocker glory, "
        "banana split, frozen yogurt, ice cream bowl",
        {
            "glass": "&c4e2e8 . glass",
            "scoops": "*f7e3c4",
            "sauce": "+4a2413",
            "cherry": "-c4142a",
            "wafer": "-d19a50 waffle",
        },
        Usual(0.2, FLESH, 0.43),
    ),
    "tomato": Noun(
        "; cherry tomato, persimmon",
        {"body": "*d4261c", "leaves": "+3f8a32", "stalk": "-4f7a34"},
        Usual(0.08, PLANT, 0.69),
    ),
    "orange fruit": Noun(
        "oranges, orange slice, sliced orange, fresh orange, ripe orange; tangerine, mandarin, "
        "clementine, grapefruit, citrus fruit, satsuma",
        {
            "body": "*f0861a",
            "pith": "-f8ecd0",
            "flesh": "+f59a22",
            "stalk": "-5c6b2c",
            "leaf": "-4d9a35",
        },
        Usual(0.14, PLANT, 0.69),
    ),
    "coconut": Noun(
        "coco nut; coconut shell, half coconut",
        {"shell": "*6b4526", "flesh": "+f7f4ec", "water": "-b9d9e4 . glass", "eyes": "-2a1a10"},
        Usual(0.22, PLANT, 0.8),
    ),
    "steak": Noun(
        "beef steak, beefsteak, t bone steak, meat steak, t bone; meat, raw meat, beef, "
        "pork chop, cooked meat, grilled steak, ham steak, ham, bacon",
        {"fat": "&f0d9bc", "meat": "*a63a2c", "bone": "+f3ead6", "marks": "-4a1a14"},
        Usual(0.25, FLESH, 0.27),
    ),
    "chicken drumstick": Noun(
        "drumstick, chicken leg, turkey leg, meat on bone; fried chicken, roast chicken leg, "
        "turkey drumstick, grilled chicken, leg of ham",
        {"meat": "*b5651f", "bone": "+f3ead6", "cuff": "&8f4a17"},
        Usual(0.15, FLESH, 0.29),
    ),
    "waffle": Noun(
        "belgian waffle",
        {"body": "&c07a2c", "ridges": "*dd9e48", "syrup": "+7a3c12", "butter": "-f8e58a"},
        Usual(0.15, 500.0, 0.32),
    ),
}
