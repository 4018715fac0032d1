"""Dishes, meat, cheese and eggs, and food that is bought in cans and cartons."""

from core.guidance.builtin.nouns.noun import CERAMIC, FLESH, GLASS, PLANT, STEEL, Noun, Usual

DISHES_AND_GROCERIES = {
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
    "taco": Noun(
        "tacos",
        {"shell": "*e5b04a", "meat": "-6a3a1c", "lettuce": "+5fae34", "tomato": "-cc2a1e"},
        Usual(0.16, 600.0, 0.55),
    ),
    "burrito": Noun(
        "burritos, bean burrito, breakfast burrito, beef burrito, chicken burrito, tortilla "
        "wrap, mexican burrito; chicken wrap, doner kebab, kebab, gyro, gyros, shawarma, falafel "
        "wrap, durum, chimichanga, enchilada",
        {
            "foil": "+c9ced3 . metal",
            "tortilla": "*ecd3a0",
            "toast": "-b5742f",
            "meat": "-6f3a1e",
            "lettuce": "-5fae35",
            "tomato": "-d83a28",
        },
        Usual(0.2, FLESH, 0.9),
    ),
    "pizza": Noun(
        "pepperoni pizza; pizza slice, pizza pie",
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
    "fries": Noun(
        "french fries; chips",
        {"carton": "*cf1f1c", "fries": "+f3c64a"},
        Usual(0.16, 350.0, 0.54),
    ),
    "sushi": Noun(
        "sushi roll; maki, nigiri",
        {"rice": "*f4f1ea", "fish": "+f0804a", "seaweed": "-1f2e24"},
        Usual(0.06, FLESH),
    ),
    "ramen": Noun(
        "noodles, noodle, ramen bowl, bowl of ramen, ramen noodles, bowl of noodles, noodle "
        "bowl; noodle soup, chicken noodle soup, udon, pho, instant noodles, "
        "spaghetti, soup, stew, pasta, pad thai, curry, chili con carne",
        {
            "bowl": "*b3231f . ceramic",
            "broth": "-b9702c",
            "noodles": "-f0d488",
            "whites": "-f7f3e8",
            "yolks": "-f2a21e",
            "chopsticks": "+3a211a grain",
        },
        Usual(0.22, CERAMIC, 0.2),
    ),
    "salad": Noun(
        "bowl of salad, green salad, mixed salad, garden salad, side salad; "
        "greek salad, caesar salad, vegetable bowl",
        {
            "bowl": "+f1ece2 . ceramic",
            "leaves": "*6fae3a",
            "tomato": "-d9362a",
            "cucumber": "-d8ebb0",
            "rind": "-2f6b33",
            "onion": "-a5468a",
        },
        Usual(0.26, PLANT, 0.4),
    ),
    "steak": Noun(
        "beef steak, beefsteak, t bone steak, meat steak, t bone; meat, raw meat, beef, pork "
        "chop, cooked meat, grilled steak, ham steak, ham, lamb chop, ribs",
        {"fat": "&f0d9bc", "meat": "*a63a2c", "bone": "+f3ead6", "marks": "-4a1a14"},
        Usual(0.25, FLESH, 0.27),
    ),
    "bacon": Noun(
        "bacon strip, bacon strips, strip of bacon, strips of bacon, rasher, rashers, bacon "
        "rasher, bacon rashers, slice of bacon, bacon slice, crispy bacon; pancetta, turkey bacon",
        {"meat": "*a83224", "fat": "+f3d0a6"},
        Usual(0.22, FLESH, 0.4),
    ),
    "chicken drumstick": Noun(
        "drumstick, chicken leg, turkey leg, meat on bone; fried chicken leg, fried chicken, "
        "roast chicken leg, "
        "turkey drumstick, grilled chicken, leg of ham",
        {"meat": "*b5651f", "bone": "+f3ead6", "cuff": "&8f4a17"},
        Usual(0.15, FLESH, 0.29),
    ),
    "roast chicken": Noun(
        "roast turkey, roasted turkey, roasted chicken, cooked turkey, cooked chicken, whole "
        "roast chicken, thanksgiving turkey, baked chicken; christmas turkey, roast duck, "
        "rotisserie chicken, roast goose",
        {
            "meat": "*b9662a",
            "drumsticks": "&a35222",
            "bones": "-f4ead6",
            "platter": "+eef0f2 . ceramic",
            "leaves": "-5f9a36",
            "tomatoes": "-d5362a",
        },
        Usual(0.4, FLESH, 0.7),
    ),
    "egg": Noun(
        "",
        {"shell": "*ead2b4"},
        Usual(0.06, FLESH, 0.9),
    ),
    "fried egg": Noun(
        "sunny side up, fried eggs; omelette, omelet, poached egg",
        {"whites": "-fbf8f0", "yolk": "*f8ad1c", "edge": "-d9a560"},
        Usual(0.12, FLESH, 0.5),
    ),
    "easter egg": Noun(
        "painted egg, decorated egg",
        {"shell": "*8cc7ea . paint", "stripes": "+f6d348 . paint", "dots": "-ee7fb0 . paint"},
        Usual(0.06, FLESH, 0.9),
        "egg",
    ),
    "cheese": Noun(
        "swiss cheese, cheese wedge; cheddar, parmesan, brie, cheese wheel, wheel of cheese",
        {"body": "*f6c63a", "rind": "+d98e22", "label": "-b3261e . paint"},
        Usual(0.15, FLESH),
    ),
    "can": Noun(
        "soda can, tin can, beverage can; beer can, soup can, energy drink, can of soda, can "
        "of beans, can of soup, canned food, canned beans, canned soup, canned fish, soda, "
        "cola, coke, pepsi, spray can, aerosol can",
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
    "milk carton": Noun(
        "carton of milk; milk, juice carton, juice box, carton, carton of juice, orange juice",
        {"carton": "*f2f3f4", "top": "+2f6fc2", "cap": "-d8352a"},
        Usual(0.24, FLESH, 0.32),
    ),
}
