"""Food that is made."""

from core.guidance.builtin.nouns.noun import FLESH, GLASS, SNOW, STEEL, Noun, Usual

FOOD = {
    "hamburger": Noun(
        "burger, cheeseburger; big mac, slider, veggie burger",
        {
            "bun": "*cf8a3c",
            "lettuce": "+5fae34",
            "patty": "-5a3019",
            "cheese": "-f5b52a",
            "seeds": "-f4e3b8",
        },
        Usual(0.12, 500.0),
    ),
    "ice cream": Noun(
        "icecream, ice cream cone; gelato, gelato cone, soft serve, snow cone, sorbet, "
        "waffle cone, sugar cone",
        {
            "scoop": "*f6c6cc",
            "cone": "+c98a45 waffle",
            "cherry": "-b8121f",
            "sauce": "-5a2f1c",
            "sprinkles": "-fff3d6",
        },
        Usual(0.18, 600.0, 0.63),
    ),
    "cupcake": Noun(
        "cup cake; fairy cake",
        {"icing": "*f3a9c4", "cup": "+8a5a3a", "cherry": "-b8121f"},
        Usual(0.08, 400.0),
    ),
    "bread": Noun(
        "loaf, loaf of bread, bread loaf; toast, baguette, sourdough, bun, bread roll, brioche",
        {"crust": "*b8742e", "crumb": "+f1dcae", "scores": "~e9bb78"},
        Usual(0.28, 300.0, 0.39),
    ),
    "croissant": Noun(
        "; pastry, danish",
        {"crust": "*d1913f", "folds": "&a8662a"},
        Usual(0.16, 300.0),
    ),
    "pizza": Noun(
        "; pizza slice, pizza pie",
        {
            "crust": "+c98a42",
            "cheese": "*f4c64f",
            "salami": "-b5301f",
            "olives": "-26231c",
            "specks": "-e9a08a",
            "basil": "-3f8f3a",
            "spots": "-d99a34",
        },
        Usual(0.3, 700.0, 0.6),
    ),
    "hot dog": Noun(
        "hotdog; sausage, frankfurter, corn dog, bratwurst",
        {"bun": "*d79a4c", "sausage": "+b0452a", "mustard": "-f4c820"},
        Usual(0.18, 600.0, 0.55),
    ),
    "sandwich": Noun(
        "club sandwich; toastie, blt, grilled cheese, panini, wrap, pita",
        {
            "bread": "*dba765",
            "lettuce": "+5fae34",
            "ham": "-e58d8f",
            "tomato": "-c92a1e",
            "cheese": "-f5c244",
            "grill marks": "~8a5226",
        },
        Usual(0.14, 500.0),
    ),
    "cake": Noun(
        "birthday cake; torte, wedding cake, cheesecake, pudding, brownie, cheesecake slice, "
        "slice of cake, lasagna",
        {
            "icing": "*f6b7c8",
            "body": "+8a5430",
            "topping": "-c2182b",
            "plate": "-ece9e2",
            "candles": "+fbf3e0",
            "flames": "-ff9a1e",
            "sprinkles": "-ffd84a",
            "cream": "-f6e6c8",
        },
        Usual(0.28, 450.0),
    ),
    "cookie": Noun(
        "chocolate chip cookie; biscuit, oreo, macaron, cracker",
        {"body": "*cc9248", "chips": "+43230f", "dimples": "~a06c2e"},
        Usual(0.08, 500.0),
    ),
    "cheese": Noun(
        "swiss cheese, cheese wedge; cheddar, parmesan, brie, cheese wheel, wheel of cheese",
        {"body": "*f6c63a", "rind": "+d98e22", "label": "-b3261e . paint"},
        Usual(0.15, FLESH),
    ),
    "egg": Noun(
        "",
        {"shell": "*ead2b4"},
        Usual(0.06, FLESH, 0.9),
    ),
    "fries": Noun(
        "french fries; chips",
        {"carton": "*cf1f1c", "fries": "+f3c64a"},
        Usual(0.16, 350.0, 0.54),
    ),
    "pancakes": Noun(
        "pancake, stack of pancakes; crepe, crepes, tortilla",
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
        {
            "crust": "*d49a4e",
            "filling": "+a8222a",
            "dish": "-d8d4cc",
            "bands": "-3f6fa8 . paint",
            "flutes": "~b3ada0",
        },
        Usual(0.28, 700.0),
    ),
    "can": Noun(
        "soda can, tin can, beverage can; beer can, soup can, energy drink, can of soda, can of "
        "beans, can of soup, canned food, canned beans, canned soup, canned fish, soda, cola, "
        "coke, pepsi, spray can, aerosol can, paint can",
        {
            "label": "*c91f25 . paint",
            "can": "+b9bdc2 . metal",
            "tab": "-9a9ea4 . metal",
            "badge": "-c91f25 . paint",
            "wave": "-f4f1ea . paint",
        },
        Usual(0.12, STEEL, 0.071),
    ),
    "jar": Noun(
        "jam jar; honey jar, cookie jar, mason jar, jar of jam, peanut butter, "
        "honey pot, honey, jam, canister, tin can lantern",
        {"body": "*b8324a . glass", "lid": "+d9b04a . metal", "label": "-f2ead6"},
        Usual(0.14, GLASS, 0.16),
    ),
    "taco": Noun(
        "tacos",
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
    "steak": Noun(
        "beef steak, beefsteak, t bone steak, meat steak, t bone; meat, raw meat, beef, pork "
        "chop, cooked meat, grilled steak, ham steak, ham, lamb chop, ribs",
        {"fat": "&f0d9bc", "meat": "*a63a2c", "bone": "+f3ead6", "marks": "-4a1a14"},
        Usual(0.25, FLESH, 0.27),
    ),
    "chicken drumstick": Noun(
        "drumstick, chicken leg, turkey leg, meat on bone; fried chicken leg, fried chicken, "
        "roast chicken leg, "
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
