"""Names and descriptions of parts, as data.

The order within a table is that of the networks' embeddings; new words go to the end.
"""

# The names of the parts that a caption may state (``CHOICES`` and ``LEGS``).
PART_WORDS = {
    "armrests": "armrest, arm, arm rest, arm rests",
    "backrest": "back, back rest",
    "handle": "ear",
    "cap": "lid, cork, stopper, screw cap, screw lid, screw top",
    "hat": "top hat",
    "chimney": "",
    "one leg": "single leg, pedestal, one foot",
    "three legs": "3 legs, three legged, 3 legged",
    "four legs": "4 legs, four legged, 4 legged",
}
# Words for the parts that a noun always has: they only give a colour its place.
PART_SYNONYMS = {
    "marks": "numerals, hour marks",
    "legs": "leg, feet, foot, paws, paw",
    "wheels": "wheel, tyres, tyre, tires, tire",
    "windows": "window",
    "cushion": "seat, cushions",
    "top": "countertop, tabletop, table top, worktop",
    "scoop": "scoops",
    "cone": "waffle cone, sugar cone, wafer cone",
    "shade": "lampshade, lamp shade, drum shade, drum lampshade",
    "leaves": "leaf, foliage",
    "sails": "sail",
    "awning": "canopy",
    "icing": "frosting",
    "syrup": "maple syrup, chocolate syrup",
    "wings": "wing",
    "fins": "fin, flippers, flipper",
    "stem": "stalk",
    "tray": "pot",
    "grip": "hilt",
    "guard": "crossguard",
    "lamps": "headlights, headlight",
    "body": "scales, scale, plumage",
    "handles": "handle, ears",
    "gem": "gems, jewel, jewels, stone, gemstone, gemstones, rubies",
    "bill": "beak",
    "claws": "claw, pincers, pincer",
    "antlers": "antler",
    "cups": "ear cups",
    "pads": "ear cushions, ear pads",
    "flame": "flames",
    "frames": "window frames, window frame, window trim",
    "tail lamps": "taillights, tail lights, rear lights, brake lights, tail lamp",
    "number plates": "license plate, license plates, licence plate, number plate",
}
# Other names of a part in a thing, the likeliest first: a fan's base is its stand.
PART_ALSO = {
    "backrest": "back",
    "armrests": "arms, limbs",
    "cap": "lid, cork, rim",
    "roof": "cap",
    "handle": "grip, hilt, stick, shaft",
    "grip": "handle",
    "blade": "head",
    "blades": "blade, sails, rotor",
    "propeller": "rotor, blades",
    "propellers": "rotors, blades",
    "legs": "limbs, base, stand, foot, tripod, posts",
    "stand": "base, foot, stem, pole, post, tripod, mount, holder",
    "base": "stand, foot, holder, mount, legs, feet",
    "pedestal": "base, stand, stem, foot",
    "plinth": "base, stand",
    "stick": "handle, shaft, pole",
    "shaft": "pole, stick, handle, stem",
    "pole": "shaft, stick, stem, post, mast, staff, handle",
    "post": "pole, posts, stem",
    "rod": "shaft, pole, stick, handle",
    "stem": "pole, stand, shaft",
    "barrel": "tube",
    "tube": "barrel, hull",
    "deck": "board, hull",
    "globe": "shade, bulb",
    "dome": "shade, roof",
    "backplate": "plate",
    "top": "cap, lid, roof, seat, deck, board",
    "fretboard": "neck",
    "fingerboard": "neck",
    "lips": "mouth",
    "headstock": "neck",
    "cabinets": "body, doors",
    "cabinet": "body",
    "backboard": "board",
    "saddle": "seat",
    "upholstery": "cushion, seat, back",
    "padding": "cushion, seat",
    "pad": "cushion, seat",
    "headboard": "backrest, back, frame",
    "dial": "face, plate",
    "face": "dial, skin, muzzle, mouth",
    "lens": "glass, glasses",
    "lenses": "glasses, glass, lens",
    "glass": "glasses, windows, window, lens, screen, dome",
    "windshield": "windows, window, cockpit",
    "display": "screen",
    "flame": "fire, glass, embers",
    "fire": "flame, flames, embers, glass",
    "glow": "flame, flames, lights, light, lamp, lamps, glass, bulb, shade, crystal, embers",
    "skin": "body, fur, peel, rind",
    "fur": "coat, wool, body",
    "hide": "body, skin",
    "feathers": "plumes, body",
    "wool": "fur, body",
    "hair": "mane, fur",
    "bedding": "blanket, mattress",
    "sheets": "blanket, mattress",
    "duvet": "blanket",
    "drawers": "drawer",
    "shelves": "shelf, boards",
    "cover": "lid, canopy, cap",
    "tub": "tray",
    "scroll wheel": "wheel",
    "rims": "hubs, wheels, frame",
    "plume": "crest, plumes",
    "center": "heart, core",
    "centre": "heart, core",
    "pit": "stone, seed",
    "thrusters": "engines",
    "trailer": "cargo, bed",
    "feather": "plume, crest",
    "planter": "pot, tray",
    "pump": "cap",
    "bumper": "trim",
    "bumpers": "trim",
    "grille": "trim, bars",
    "grill": "trim, bars",
    "smile": "mouth",
    "shingles": "roof",
    "tiles": "roof",
    "roof tiles": "roof",
    "hubcaps": "hubs",
    "engine": "boiler",
    "locomotive": "boiler",
    "sides": "walls",
    "walls": "glass",
    "railing": "rails, rail",
    "continents": "land",
    "toast": "bread",
    "pillar": "piers, posts, columns",
    "spikes": "tips",
    "knobs": "handles, knob, buttons",
    "keyboard": "keys",
    "switch": "button, buttons, knob",
    "panes": "glass, windows, window",
    "orb": "crystal, gem, globe",
    "gem": "crystal, stone",
    "crystal": "gem, gems, orb",
    "supports": "legs, posts, frame, base, stand",
    "ends": "sides, caps, tips",
    "pegs": "knobs",
    "knob": "knobs, handle, handles",
    "pulls": "handles, knobs, handle, knob",
    "solar panel": "panels",
    "slats": "boards, planks, seat",
    "flask": "body",
    "brew": "water, flask",
    "string": "strings, rope, chain",
    "cord": "rope, string",
    "lights": "lamps, lamp",
    "strap": "band, belt, handle",
    "headband": "band, strap",
    "earcups": "cups",
    "pads": "cushions, cushion",
    "earpads": "cushions",
    "band": "strap, belt, ribbon, bands",
    "bands": "hoops, rings, straps",
    "boss": "emblem",
    "tines": "head",
    "prongs": "head",
    "head": "bowl",
    "rings": "hoops, bands",
    "ribbon": "bow, band, sash",
    "liquid": "brew, water, flask, body, bottle",
    "bark": "trunk, wood",
    "trousers": "legs",
    "pants": "trousers",
    "shoes": "boots, feet",
    "cape": "robe, coat",
    "cloak": "cape, robe, coat",
    "dress": "robe, skirt, coat, shirt, tunic",
    "robe": "coat, cape, tunic, dress, shirt",
    "robes": "coat, cape, tunic, dress, shirt",
    "shirt": "tunic, suit, coat, vest, top, uniform",
    "jacket": "coat, suit, tunic, uniform, vest, shirt",
    "suit": "coat, uniform, armour, robe, tunic, shirt",
    "coat": "uniform, robe, suit, tunic, dress, shirt",
    "crown": "gold",
    "armor": "armour, suit, body, plates",
    "armour": "suit, body, plates",
    "outfit": "suit, coat, robe, tunic, dress, shirt, armour",
    "clothes": "suit, coat, robe, tunic, dress, shirt, armour",
    "costume": "suit, coat, robe, tunic, dress, shirt, armour",
    "uniform": "suit, coat, tunic, shirt",
}
# Names of a part in some things alone.
_PAWS = dict.fromkeys("feet foot socks boots mittens toes".split(), "paws")
_SOCKS = dict.fromkeys("feet legs boots stockings paws fetlocks".split(), "socks")
CALLED = {
    "bench": dict.fromkeys("ends sides frame supports base".split(), "legs"),
    "castle": {"gate": "door", "gates": "door"},
    "arcade machine": dict.fromkeys(("sides", "panels"), "body"),
    "four-poster bed": dict.fromkeys(("posts", "post", "poles", "columns", "headboard"), "frame"),
    "hot air balloon": {"gondola": "basket"},
    "bubble tea": dict.fromkeys(("cup", "drink", "liquid"), "tea")
    | dict.fromkeys(("boba", "tapioca"), "pearls"),
    "briefcase": dict.fromkeys("clasp clasps lock locks buckle buckles".split(), "latches"),
    "pirate": dict.fromkeys(("pirate hat", "tricorn", "tricorn hat"), "hat"),
    "rifle": dict.fromkeys(("panels", "frame", "casing"), "body"),
    "dice": dict.fromkeys("numbers number numerals".split(), "pips"),
    "toxic barrel": dict.fromkeys("slime sludge ooze waste liquid".split(), "goo"),
    "playing card": {"hearts": "pips", "heart": "pips"},
    "treasure map": {"islands": "land", "island": "land", "compass": "rose", "mountains": "hills"},
    "jupiter": {"spot": "storm"},
    "cauldron": dict.fromkeys(
        "potion stew soup slime goo ooze liquid acid poison water oil broth".split(), "brew"
    ),
    "viking": dict.fromkeys(("viking helmet", "horned helmet"), "helmet"),
    "chef": {"chef hat": "hat"},
    "santa claus": {"santa hat": "coat"},
    "wine glass": dict.fromkeys(("wine", "drink"), "liquid"),
    "girl": {"ribbons": "bows", "ribbon": "bows", "skirt": "dress", "pigtails": "hair"},
    "boy": {"trousers": "shorts", "pants": "shorts", "t-shirt": "shirt", "hat": "cap"},
    "baby": dict.fromkeys(("nappy", "diapers", "pants"), "diaper"),
    "dwarf": {"axe": "handle", "shirt": "tunic", "hat": "helmet", "moustache": "beard"},
    "troll": {"loincloth": "cloth", "belt": "cloth"},
    "cyclops": {"loincloth": "cloth", "belt": "cloth", "eye": "iris"},
    "monster": {"body": "fur", "feet": "paws", "hands": "paws"},
    "mammoth": {"body": "fur", "trunk": "fur"},
    "velociraptor": {"feathers": "stripes"},
    "rooster": {"feathers": "body", "wattle": "comb", "feet": "legs"},
    "turkey": {"feathers": "tail", "fan": "tail"},
    "beetle": {"wings": "shell", "mandibles": "jaws", "horns": "jaws"},
    "muffin": {"blueberries": "berries", "chips": "berries", "wrapper": "cup", "paper": "cup"},
    "fern": {"leaves": "fronds"},
    "willow tree": {"branches": "strands", "foliage": "leaves"},
    "cruise ship": {"chimney": "funnel", "smokestack": "funnel"},
    "sleigh": {"presents": "sack", "bag": "sack", "skids": "runners"},
    "torii gate": {"posts": "pillars", "columns": "pillars", "roof": "lintel"},
    "quiver": {"arrows": "feathers", "fletching": "feathers"},
    "engine": {
        "air filter": "filter",
        "exhaust": "ribs",
        "pipes": "ribs",
        "valve covers": "covers",
    },
    "boombox": {"antenna": "handle", "aerial": "handle", "cassette": "deck", "tape": "deck"},
    "pen": {"tip": "nib"},
    "hourglass": {"sand": "glass"},
    "hamburger": {"sesame": "seeds", "sesame seeds": "seeds"},
    "cactus": dict.fromkeys("spikes thorns needles prickles".split(), "spines"),
    "tennis racket": {"net": "strings", "netting": "strings"},
    "microphone": {"grille": "mesh", "grill": "mesh"},
    **dict.fromkeys(
        "dog cat fox bear rabbit lion tiger leopard corgi dalmatian raccoon skunk".split(), _PAWS
    ),
    **dict.fromkeys("cow bull zebra pegasus".split(), _SOCKS),
    "horse": _SOCKS | {"nostrils": "mouth", "nostril": "mouth"},
    "phone": {"apps": "icons"},
    "scroll": {"writing": "letters", "text": "letters", "words": "letters"},
    "stump": {"growth rings": "rings", "tree rings": "rings"},
    "magic wand": dict.fromkeys("star crystal gem stone orb".split(), "tip"),
    "slime": dict.fromkeys(("jelly", "slime", "goo"), "body"),
    "lily pad": dict.fromkeys(("lotus", "flower", "bloom", "blossom"), "petals"),
    "queen": {"gown": "dress", "sceptre": "gold", "scepter": "gold", "collar": "trim"},
    "king": {"sceptre": "gold", "scepter": "gold"},
    "witch": dict.fromkeys(("hatband", "belt"), "hair"),
    "firefighter": dict.fromkeys("stripes reflectors badge".split(), "bands")
    | {"fire helmet": "helmet", "firefighter helmet": "helmet"},
    "orc": dict.fromkeys("loincloth belt strap bracers".split(), "leather"),
    "mummy": {"wrappings": "bandages", "cloth": "bandages", "wraps": "bandages"},
    "grim reaper": dict.fromkeys(("skull", "face", "hands"), "bone") | {"scythe": "blade"},
    "phoenix": dict.fromkeys(("flames", "crest"), "tips"),
    "otter": {"belly": "chest", "tummy": "chest", "paws": "feet"},
    "walrus": {"flippers": "fins", "whiskers": "muzzle"},
    "pug": _PAWS | {"face": "mask", "muzzle": "mask", "wrinkles": "folds"},
    "poodle": {"fur": "pompoms", "tufts": "pompoms"},
    "drum kit": dict.fromkeys(
        ("drum", "drums", "bass drum", "kick drum", "snare drum", "snare", "toms"), "shells"
    ),
}
# Parts of some things' shapes that are not separate ones; and those of living things.
NO_PARTS = {
    "bookshelf": "shelf shelves",
    "desk": "leg legs feet",
    "castle": "tower towers turret turrets battlements",
    **dict.fromkeys(
        "car taxi van bus jeep truck ambulance limousine".split(),
        "roof hood bonnet trunk boot door doors",
    ),
    **dict.fromkeys(("sports car", "race car", "pickup truck"), "roof hood bonnet door doors"),
}
OF_BODIES = frozenset(
    """head face neck chest torso belly shoulders shoulder arms arm legs leg hands hand feet foot
    nose mouth ears ear tail paws claws""".split()
)
# Descriptions of a part, where the thing has it: a colour, a material or a thing elsewhere.
SAID_OF_PARTS = {
    "cream": "icing",
    "vinyl": "record",
    "jeans": "denim trousers",
    "clothes": "outfit",
    "clothing": "outfit",
    "dots": "pips",
    "spots": "pips",
}
# Things with cloth, straw or similar, and a frame: the parts that get a hard material of the whole.
# "A wooden lamp" has a shade of cloth.
FRAMES = {
    noun: frozenset(parts.split())
    for noun, parts in {
        "aquarium": "frame lid",
        "armchair": "arms legs",
        "bow": "limbs",
        "broom": "handle",
        "candle": "holder",
        "carousel": "floor column trim horses poles",
        "curtain": "rod knobs",
        "flag": "pole knob",
        "floor lamp": "pole foot",
        "hammock": "bars posts base",
        "high chair": "seat tray legs footrest",
        "ironing board": "frame legs rest",
        "island": "rock",
        "kite": "spars",
        "lamp": "pole foot",
        "market stall": "counter posts shelf",
        "mop": "handle",
        "mountain": "rock peaks",
        "office chair": "base arms",
        "ottoman": "base feet",
        "scarecrow": "post",
        "scroll": "rods",
        "slingshot": "fork",
        "sofa": "arms base feet",
        "solar panel": "frame post base",
        "tent": "poles",
        "throne": "frame knobs step",
        "trampoline": "legs rail",
        "umbrella": "stick handle",
        "wall sconce": "plate arm cup",
        "wheelchair": "frame spokes",
    }.items()
}
# Other names of a thing with a part that it lacks: "a horse with a horn".
WITH_PARTS = {
    "pot": {"cooking pot": "handle handles lid"},
    "pumpkin": {"jackolantern": "face faces eyes mouth nose smile grin teeth"},
    **{name: {"unicorn": "horn", "pegasus": "wings"} for name in ("horse", "pony")},
    "chair": {"office chair": "wheels casters castors", "rocking chair": "rockers"},
    "bed": {"canopy bed": "canopy posts"},
    "bus": {"double decker bus": "decks decker floors levels"},
}
# Visible contents of a thing, by their colours.
CONTENTS = {
    **dict.fromkeys(("honey", "whiskey", "whisky", "rum", "cider", "beer", "tea"), "amber"),
    **dict.fromkeys(("jam", "ketchup"), "crimson"),
    **dict.fromkeys(("milk", "mayonnaise", "soap", "lotion", "slush"), "ivory"),
    **dict.fromkeys(("oil", "mustard", "lemonade"), "mustard"),
    **dict.fromkeys(("slime", "poison", "acid", "pickles"), "lime"),
    **dict.fromkeys(("coffee", "cola", "syrup", "soup"), "brown"),
    **dict.fromkeys(("water", "mana"), "azure"),
    "juice": "orange",
    "blood": "maroon",
    "ink": "black",
    "wine": "",  # its bottle's own green
}
# Parts on another part alone, removed with it.
BORNE = {
    "wheels": "hubs",
    "roof": "chimney",
    "icing": "sprinkles, strands, drops",
    "candles": "flames",
    "head": "eyes, bill, aerial",
}
# Words for most of a thing, whatever its name for that; and for the rest.
WHOLE = frozenset(
    """body case casing housing shell frame chassis bodywork exterior surface paint paintwork
    glaze varnish coating finish outside planks boards""".split()
)
# Words that are no separate thing: "a guitar finish".
SURFACE = frozenset("exterior surface paint paintwork glaze varnish coating finish outside".split())
TRIM = frozenset(
    """trim accent accents detail details detailing edging hardware fittings piping reinforcement
    reinforcements plating inlay inlays filigree banding bracing strapping embellishments ornaments
    highlights elements touches corners decoration decorations ornamentation""".split()
)
# Metal ones of these come first.
HARDWARE = frozenset(
    """hardware fittings reinforcement reinforcements plating bracing strapping banding
    corners""".split()
)
# Parts that are not trim if there are others.
SEATS = ("seat", "cushion")
FEET = ("legs", "feet", "base")
# Parts that a thing may have or lack, as a caption may state them; "no hat" is a word like "hat".
# Of the legs a caption states how many.
CHOICES = ("armrests", "backrest", "handle", "cap", "hat", "chimney")
MANY_LEGS = "four legs"  # where several are meant without a count
LEGS = {"one leg": 1, "three legs": 3, "four legs": 4}
PARTS = (*(state for part in CHOICES for state in (part, f"no {part}")), *LEGS)
# Parts whose components are not counted: of a living thing all but these, of others these.
COUNTED_OF_LIVING = frozenset(("eyes", "horns", "antlers", "spots"))
NEVER_COUNTED = frozenset(
    """wheels hubs tires tyres tracks limbs glasses arms laces strings seeds sprinkles strands
    twigs sails bubbles needles spines leaves ribs sides walls""".split()
)
# What a caption may state of each noun's parts.
OPTIONS: dict[str, tuple[str, ...]] = {
    "chair": ("armrests", "no armrests"),
    "table": ("one leg", "four legs"),
    "stool": ("one leg", "three legs", "four legs"),
    "bench": ("backrest", "no backrest"),
    "mug": ("handle", "no handle"),
    "teacup": ("handle", "no handle"),
    "bucket": ("handle", "no handle"),
    "candle": ("handle", "no handle"),
    "bottle": ("cap", "no cap"),
    "snowman": ("hat", "no hat"),
    "house": ("chimney", "no chimney"),
    "cottage": ("chimney", "no chimney"),
}
