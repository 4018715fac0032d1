"""How long the kinds of a thing are that are made as it and are not of its size.

Of each thing the usual sizes of such kinds: the longest side of an ordinary specimen in metres,
then who has it. A kind that is not here has the thing's own size. Standard library only.
"""

_ROWS = {
    # solids
    "ball": "0.08: snowball",
    "torus": "0.07: bracelet; 0.38: steering wheel; 0.75: lifebuoy, life preserver, life buoy, "
    "life ring; 0.9: inner tube, swim ring, swimming ring, pool ring, inflatable ring, "
    "rubber ring, rubber tube; 1.1: pool float",
    "star": "0.08: sheriff star, sheriff badge; 0.1: shuriken",
    # furniture
    "table": "1.8: altar",
    "sofa": "1.5: loveseat; 2.8: sectional",
    "bench": "3: pew, church pew",
    "lamp": "0.12: night light; 0.35: lampshade",
    "desk": "0.7: school desk",
    "dresser": "1.4: tallboy",
    "coffee table": "0.55: side table",
    "cabinet": "0.8: kitchen cabinet, shoe rack; 1.8: locker, school locker, display case, "
    "display cabinet, vitrine",
    "piano": "1: synthesizer",
    "grand piano": "1.5: baby grand piano, baby grand; 2.7: concert grand",
    "crib": "0.8: bassinet; 0.9: cradle",
    "grandfather clock": "0.4: cuckoo clock",
    "shelf": "0.4: spice rack; 1.8: shelving unit, shelving",
    # in the house
    "mug": "0.15: beer mug, beer, pint of beer, glass of beer; 0.16: tankard; 0.18: stein",
    "vase": "0.6: amphora",
    "bottle": "0.1: medicine bottle; 0.17: hot sauce; 0.18: soap dispenser, mustard bottle; "
    "0.2: ketchup, shampoo, shampoo bottle, lotion bottle; "
    "0.22: water bottle, syrup; 0.23: beer bottle, milk bottle",
    "bowl": "0.11: ashtray; 0.26: fishbowl, fish bowl, goldfish bowl, salad bowl, mixing bowl; "
    "0.3: fruit bowl",
    "goblet": "0.07: shot glass; 0.1: tumbler, whiskey glass, whisky glass; 0.13: drinking glass, "
    "glass of water, glass of milk, glass of juice, glass of lemonade; "
    "0.23: champagne flute, champagne glass",
    "candle": "0.04: tea light, tealight; 0.28: candlestick",
    "crown": "0.15: tiara",
    "bell": "0.18: cowbell; 0.22: handbell",
    "bust": "0.25: statuette; 0.3: idol; 0.35: mannequin head",
    "door": "3: castle door, barn door, church door; 4: castle gate, portcullis",
    "refrigerator": "0.85: minifridge",
    "stove": "0.35: hot plate",
    "microwave": "0.4: toaster oven",
    "safe": "0.28: cash box; 2.2: vault, bank vault",
    "toilet": "0.45: toilet seat; 0.55: bidet",
    "bathtub": "2.2: jacuzzi",
    "sink": "0.55: bathroom sink",
    "fan": "0.35: exhaust fan; 0.4: desk fan",
    "picture frame": "0.77: mona lisa; 0.85: poster; 1.5: whiteboard, chalkboard, blackboard",
    "teacup": "0.11: espresso cup",
    "flower pot": "0.45: planter, plant tub; 0.7: window box",
    "cardboard box": "0.24: tissue box, box of chocolates, chocolate box; 0.3: cereal box; "
    "0.33: shoe box, shoebox, pizza box",
    "birdhouse": "1.4: bird table",
    "faucet": "0.15: spigot, garden tap; 0.2: shower tap",
    "radiator": "0.4: space heater; 0.6: heater, electric heater, oil heater; 0.7: convector",
    "high chair": "0.4: booster seat; 0.6: baby seat",
    "aquarium": "0.4: goldfish tank; 0.6: terrarium",
    "birdcage": "2.5: aviary",
    "remote control": "0.07: garage remote",
    "air conditioner": "0.5: window air conditioner; 0.55: air purifier",
    "whisk": "0.22: milk frother",
    "spatula": "0.25: scraper, cake server, pie server",
    "grater": "0.14: nutmeg grater; 0.38: mandoline",
    "jug": "0.18: measuring jug; 0.2: gravy boat",
    "moka pot": "0.26: percolator, coffee percolator",
    "perfume": "0.07: nail polish",
    # small things
    "plate": "0.15: saucer; 0.18: side plate; 0.2: dessert plate; 0.35: platter, serving dish; "
    "0.42: tray",
    "salt shaker": "0.12: spice jar, sugar shaker; 0.18: pepper mill, pepper grinder",
    "flask": "0.12: beaker",
    "rug": "0.7: doormat, mat, floor mat",
    "curtain": "1.8: shower curtain; 8: stage curtain, theater curtain, theatre curtain",
    "hairbrush": "0.17: comb, hair comb",
    "toothbrush": "0.24: electric toothbrush",
    "lipstick": "0.12: mascara",
    "envelope": "0.15: postcard",
    "rake": "1.1: gardening fork, garden fork",
    "maracas": "0.15: rattle",
    "gong": "0.4: cymbal, cymbals",
    "paper cup": "0.07: espresso; 0.1: yogurt, yoghurt",
    "towel": "0.12: handkerchief; 0.18: napkin; 0.6: quilt; 0.7: duvet",
    "toilet paper": "0.25: kitchen roll, paper towel, paper towels",
    "binoculars": "0.11: opera glasses",
    "rope": "0.05: thread; 0.12: ball of yarn; 0.6: garden hose, fire hose, hose",
    "notice board": "0.6: memo board; 1.6: quest board, job board, evidence board",
    "map pin": "0.012: thumbtack; 0.025: push pin, pushpin",
    "cassette": "0.19: vhs, vhs tape, vhs cassette, video tape, videotape",
    "vinyl record": "0.12: cd, dvd, cd rom, compact disc, compact disk, blu ray",
    "ruler": "0.91: yardstick; 1: meter stick, metre stick",
    # props
    "chest": "0.15: music box, trinket box; 0.25: jewelry box, jewellery box, keepsake box, "
    "memory box; 0.5: coffer; 1.1: blanket box",
    "sword": "0.6: machete; 0.8: cutlass; 1.4: claymore, greatsword",
    "dagger": "0.22: letter opener; 0.25: throwing knife, kunai; 0.45: kris, bayonet",
    "shield": "0.35: buckler",
    "barrel": "2: vat",
    "crate": "0.3: ammo box; 0.9: lobster trap, lobster pot",
    "potion": "0.1: vial",
    "staff": "0.35: wand, magic wand; 0.92: walking stick, walking cane, cane; 1: sceptre, "
    "scepter; 1.3: crutch",
    "book": "0.125: passport; 0.15: notepad; 0.18: paperback; 0.2: novel, diary; "
    "0.35: tome, grimoire; 0.38: newspaper",
    "cauldron": "0.2: crucible",
    "cannon": "1.5: mortar; 5: artillery, artillery gun; 6: howitzer",
    "bomb": "0.15: cannonball, cannon ball; 1.2: sea mine, naval mine",
    "hourglass": "0.1: egg timer",
    "tent": "4: wigwam; 5: teepee, tipi; 6: yurt; 9: marquee; 35: big top",
    "signpost": "8: billboard",
    "ladder": "1.6: stepladder",
    "arrow": "0.05: arrowhead; 0.15: dart; 0.4: crossbow bolt",
    "flag": "0.9: pennant",
    "traffic light": "6: railway signal, train signal",
    "pistol": "0.27: desert eagle; 0.3: water gun, ray gun, raygun; 0.4: flintlock; 0.47: uzi",
    "wreath": "0.25: laurel wreath, flower wreath",
    "nest": "0.12: robin nest; 1.8: eagle nest, eyrie; 4: dragon nest",
    "spear": "2.5: javelin; 3: lance; 4.5: pike",
    "scythe": "0.5: sickle",
    "mace": "1: warhammer, war hammer",
    "crossbow": "3: ballista",
    "rifle": "0.65: submachine gun; 1.4: musket",
    "catapult": "5: mangonel, onager; 10: trebuchet",
    "lightsaber": "0.15: glow stick, glowstick",
    "crystal": "0.15: geode, ore, mineral, minerals, crystal shard, crystal shards",
    "necklace": "0.15: choker",
    "sack": "0.15: pouch, coin pouch, coin bag; 0.22: crisp packet; 0.28: bag of chips, chip bag; "
    "0.3: money bag, moneybag, bag of money, bag of gold; 0.35: paper bag; 0.45: plastic bag; "
    "0.6: sandbag; 1.1: punching bag, boxing bag; 1.9: sleeping bag",
    "anchor": "0.4: grapnel",
    "hay bale": "3: haystack, hay stack",
    "beehive": "0.3: wasp nest",
    "bow": "1: compound bow; 1.1: short bow, shortbow",
    "drinking horn": "0.45: war horn, hunting horn, battle horn",
    # what is eaten
    "hamburger": "0.07: slider",
    "bread": "0.1: bun, bread roll; 0.12: toast; 0.65: baguette",
    "croissant": "0.11: danish",
    "pizza": "0.2: pizza slice",
    "sandwich": "0.18: wrap",
    "cake": "0.08: brownie; 0.13: slice of cake, cheesecake slice; 0.15: pudding; "
    "0.6: wedding cake",
    "cookie": "0.045: macaron, oreo; 0.06: cracker",
    "cheese": "0.35: cheese wheel, wheel of cheese",
    "lollipop": "0.05: candy; 0.11: chupa chup",
    "can": "0.18: paint can; 0.2: spray can, aerosol can",
    "jar": "0.2: canister; 0.25: cookie jar",
    "milk carton": "0.12: juice box",
    "steak": "0.14: lamb chop; 0.18: pork chop; 0.35: ribs, ham",
    "chicken drumstick": "0.4: leg of ham",
    "fried egg": "0.2: omelette, omelet",
    "apple": "0.1: pomegranate",
    "pumpkin": "0.25: gourd, squash",
    "banana": "0.25: plantain",
    "pear": "0.2: papaya",
    "strawberry": "0.02: berry, raspberry; 0.025: blackberry",
    "lemon": "0.06: lime fruit; 0.17: citron",
    "watermelon": "0.17: cantaloupe; 0.2: melon, honeydew",
    "grapes": "0.015: blueberry; 0.1: blueberries",
    "onion": "0.04: radish; 0.05: shallot; 0.06: garlic, garlic bulb; 0.12: turnip",
    "peach": "0.035: lychee; 0.05: apricot; 0.055: plum; 0.13: mango",
    "tomato": "0.03: cherry tomato",
    "orange fruit": "0.09: clementine; 0.1: tangerine, mandarin, satsuma; 0.18: grapefruit",
    # plants and stones
    "mushroom": "0.06: truffle; 0.15: fly agaric, amanita",
    "tree": "12: cypress; 15: spruce tree, cedar tree, spruce, cedar",
    "cactus": "6: saguaro",
    "palm": "12: coconut tree",
    "bush": "2: hedge",
    "potted plant": "0.15: succulent; 0.35: pot of flowers; 0.4: aloe, aloe vera, spider plant; "
    "1: monstera; 1.2: rubber plant; 1.5: ficus, fiddle leaf fig, fig tree",
    "tulip": "0.12: crocus; 0.7: lily",
    "log": "0.35: firewood; 2.4: lumber",
    "boulder": "0.03: pebble; 0.12: river stone, cobblestone; 0.15: moon rock; 0.3: meteorite",
    "acorn": "0.018: hazelnut; 0.024: almond; 0.04: peanut",
    "oak tree": "4: lemon tree; 5: fruit tree, orange tree; 6: cherry tree, cherry blossom tree, "
    "blossom tree, olive tree; 20: elm, beech tree, beech, chestnut tree, ash tree",
    "coral": "0.2: anemone, sea anemone; 0.6: seaweed; 5: coral reef",
    "seashell": "0.07: mussel; 0.18: nautilus; 0.2: conch",
    "potato": "0.05: new potato; 0.17: sweet potato; 0.25: yam",
    "cucumber": "0.08: gherkin; 0.1: pickle, pickled cucumber; 0.2: zucchini, courgette",
    "lettuce": "0.04: brussels sprout; 0.12: artichoke; 0.35: kale; 0.4: celery",
    "bamboo plant": "0.3: bamboo shoot; 0.5: lucky bamboo; 8: bamboo forest, bamboo grove",
    # people, and what is like them
    "goblin": "0.6: gremlin; 0.85: kobold; 1.6: hobgoblin; 1.9: orc, ork; 2.1: bugbear; "
    "2.8: ogre; 3: troll",
    "golem": "5: stone giant",
    "gnome": "1.3: dwarf, dwarves",
    "angel": "0.8: cherub",
    "demon": "0.7: imp",
    "nutcracker": "0.08: toy soldier, tin soldier",
    "mech": "2.4: exosuit; 15: giant robot; 18: gundam",
    "totem pole": "1.8: tiki, tiki statue",
    "moai": "1.2: tiki head",
    "obelisk": "4: monolith; 169: washington monument",
    "mask": "0.22: face mask, venetian mask; 0.25: carnival mask; 0.3: theatre mask, theater mask",
    "bone": "0.08: dog treat, dog biscuit; 0.45: femur",
    "fairy": "0.15: tinkerbell, tinker bell; 1.65: fairy godmother",
    "elf": "0.7: leprechaun; 1.75: wood elf",
    "griffin": "0.8: baby griffin",
    "doll": "0.18: action figure; 0.2: voodoo doll; 0.29: barbie",
    "person": "0.6: baby; 0.85: toddler; 1.2: child, children, kid; 1.35: boy, girl",
    "robot": "1.1: droid; 1.75: android, cyborg, automaton; 1.9: terminator",
    # animals
    "pig": "0.35: piglet",
    "fish": "0.06: betta fish; 0.15: goldfish, angelfish; 0.4: trout; "
    "0.6: carp; 0.7: catfish; 0.75: salmon; 0.8: cod; 1.2: barracuda; 1.8: tuna; "
    "3: swordfish",
    "rabbit": "0.55: hare",
    "duck": "0.12: duckling; 0.55: mallard",
    "cat": "0.2: kitten; 0.6: maine coon; 0.8: bobcat; 1: lynx; 1.5: cougar",
    "dog": "0.25: chihuahua; 0.28: pomeranian; 0.3: maltese; 0.35: puppy; 0.45: pug, "
    "jack russell; 0.5: terrier; 0.6: beagle, shiba inu, shiba, cocker spaniel; "
    "1: akita, rottweiler; 1.05: german shepherd, doberman, greyhound; 1.2: saint bernard; "
    "1.3: great dane",
    "wolf": "0.9: coyote, jackal; 1: husky; 2: werewolf",
    "fox": "0.4: fox cub",
    "bear": "0.8: bear cub",
    "lion": "0.7: lion cub",
    "cow": "1.2: calf; 3: bison",
    "sheep": "0.6: lamb",
    "elephant": "1.5: baby elephant",
    "horse": "1.3: foal; 1.6: pony, donkey; 1.8: colt",
    "unicorn": "1.3: baby unicorn",
    "dragon": "1.2: baby dragon, baby drake, dragonling",
    "dinosaur": "2: raptor, velociraptor; 8.5: allosaurus; 100: godzilla",
    "monkey": "0.6: gibbon; 0.7: lemur; 1.2: orangutan",
    "bird": "0.1: hummingbird, origami crane, paper crane; 0.13: canary; 0.15: sparrow, robin, "
    "finch, nightingale; 0.25: blackbird; 0.28: blue jay, puffin; 0.3: dove; "
    "0.33: pigeon, cuckoo; 0.46: magpie, crow; 0.55: seagull; 0.63: raven; 1: albatross; "
    "1.2: phoenix; 1.6: pelican",
    "owl": "0.2: owlet; 0.35: barn owl",
    "penguin": "0.4: baby penguin; 1.15: emperor penguin",
    "chicken": "0.08: chick, baby chick; 0.12: seagull chick; 0.2: quail; 0.3: partridge; "
    "0.6: rooster, cockerel; 0.8: pheasant; 1.1: turkey",
    "whale": "4.5: beluga; 5: narwhal; 7: orca, killer whale; 16: sperm whale; "
    "25: blue whale, blue whales",
    "shark": "3: hammerhead, hammerhead shark; 15: megalodon",
    "dolphin": "1.7: porpoise",
    "octopus": "0.35: cuttlefish; 0.5: squid; 15: kraken",
    # A snake is coiled: a fifth of its length.
    "snake": "0.04: worm, earthworm; 0.2: adder, eel; 0.25: viper; 0.35: rattlesnake; "
    "0.9: python; 1.2: anaconda",
    "frog": "0.03: tadpole; 0.05: tree frog; 0.15: bullfrog",
    "butterfly": "0.06: moth",
    "spider": "0.004: tick; 0.035: black widow; 0.16: tarantula",
    "bee": "0.008: fly, housefly, mosquito; 0.015: honeybee, honey bee, firefly; 0.03: hornet",
    "crab": "0.08: hermit crab, shrimp; 0.15: prawn; 1.2: king crab",
    "deer": "0.8: fawn, bambi; 1.2: gazelle; 1.5: impala; 1.6: antelope; 2.8: moose",
    "mouse": "0.1: shrew; 0.22: gerbil; 0.25: guinea pig; 0.4: rat, chinchilla; 0.5: ferret",
    # wild animals
    "tiger": "0.7: tiger cub",
    "panda": "0.5: panda cub, baby panda",
    "zebra": "1.3: zebra foal",
    "goat": "0.5: goat kid, baby goat",
    "rhino": "1.4: baby rhino",
    "hippo": "1.2: baby hippo; 1.6: pygmy hippo",
    "kangaroo": "0.5: joey, baby kangaroo; 0.85: wallaby, wallabies",
    "koala": "0.25: baby koala",
    "squirrel": "0.2: chipmunk",
    "crocodile": "0.4: baby crocodile; 1.8: caiman",
    "jellyfish": "0.3: moon jelly",
    "flamingo": "0.65: ibis; 0.9: egret, spoonbill; 0.95: heron",
    "hedgehog": "0.1: baby hedgehog; 0.4: echidna; 0.7: porcupine",
    "seal": "0.9: seal pup, baby seal; 2.2: sea lion; 3: walrus, walruses, manatee",
    "lizard": "0.1: newt; 0.15: gecko, geckos; 0.2: salamander, skink; 0.23: axolotl; "
    "0.5: bearded dragon; 1.3: iguana; 1.5: monitor lizard; 2.6: komodo dragon",
    "scorpion": "0.2: emperor scorpion",
    "ant": "0.005: fire ant; 0.008: termite; 0.013: queen ant",
    "ladybug": "0.03: scarab",
    "dragonfly": "0.05: damselfly, damselflies",
    "stingray": "2: eagle ray; 4.5: manta ray, manta",
    "peacock": "0.95: peahen",
    "swan": "0.2: gosling; 0.25: cygnet; 0.85: goose, geese; 1: canada goose",
    "triceratops": "2: protoceratops, baby triceratops; 5.5: styracosaurus",
    "stegosaurus": "2: baby stegosaurus; 4.5: kentrosaurus",
    "raccoon": "0.3: baby raccoon; 1: red panda; 1.1: coati",
    "leopard": "0.6: leopard cub, cheetah cub; 1.2: ocelot",
    "bat": "0.15: baby bat; 1: fruit bat; 1.2: flying fox",
    "ostrich": "0.5: baby ostrich; 1.5: rhea; 1.7: cassowary; 1.75: emu",
    "beaver": "0.4: baby beaver; 0.5: platypus, muskrat; 0.6: groundhog; 1.2: capybara, sea otter",
    "seahorse": "0.03: baby seahorse; 0.2: pipefish; 0.35: sea dragon",
    "parrot": "0.15: lovebird; 0.18: budgie, budgerigar; 0.3: parakeet; 0.45: cockatoo; "
    "0.55: toucan",
    # An eagle's wings are half spread.
    "eagle": "0.6: falcon; 0.75: hawk, osprey; 1.6: condor",
    "gorilla": "8: king kong",
    "llama": "0.8: baby llama; 1.4: vicuna",
    "sloth": "0.25: baby sloth",
    "starfish": "0.08: sand dollar",
    "lobster": "0.15: crayfish, crawfish, crawdad; 0.2: langoustine",
    "caterpillar": "0.012: maggot; 0.025: inchworm; 0.035: larva, grub; 0.07: silkworm; "
    "0.1: millipede",
    # vehicles
    "car": "5.8: hearse; 8: limousine, limo",
    "truck": "16: semi",
    "boat": "14: houseboat",
    "sailboat": "4: dinghy; 12: yacht, sailing yacht, catamaran",
    "tram": "19: subway, subway car, metro train, railcar",
    "jeep": "4.7: suv, land rover, humvee, hummer; 5: range rover",
    "canoe": "11: gondola",
    "pirate ship": "45: galleon, frigate; 60: sailing ship, sail ship, tall ship, tallship",
    "wagon": "0.95: stroller, pushchair, baby stroller; 1.1: pram, baby carriage, buggy pram; "
    "1.6: hand cart, handcart; 2.5: chariot",
    "skateboard": "1.05: longboard",
    "sled": "2: sleigh; 3.5: bobsled",
    "longship": "12: dragon boat",
    "forklift": "1.6: pallet truck",
    "go-kart": "1.1: pedal car",
    "jet ski": "0.6: sea scooter",
    "parachute": "9: paraglider",
    "wheel": "0.45: wheel rim, alloy wheel; 0.9: train wheel; 1: truck wheel; 1.1: wagon "
    "wheel, cart wheel; 1.7: monster truck wheel",
    "dump truck": "13: mining truck, haul truck",
    "race car": "4.1: rally car; 7.5: drag racer",
    "double decker bus": "8.4: routemaster",
    "cargo ship": "30: tugboat; 60: steamboat; 100: ferry; 200: bulk carrier; "
    "250: oil tanker, tanker ship, battleship; 270: ocean liner, titanic; 300: cruise ship; "
    "330: aircraft carrier",
    "rowboat": "5: dory; 6: motorboat, speedboat; 7: punt; 8: lifeboat",
    "airplane": "18: private jet; 30: bomber; 40: airliner; 52: stealth bomber; 70: jumbo jet",
    "rocket": "0.5: firework; 6: missile, torpedo",
    "spaceship": "7.2: tie fighter",
    "satellite": "0.6: sputnik; 13: space telescope, hubble; 109: space station",
    "biplane": "15: glider",
    # buildings
    "house": "1: dollhouse, doll house; 1.1: kennel, doghouse; 1.3: hutch; "
    "2: chicken coop, coop, hen house, henhouse; 2.2: outhouse; 3: shed, garden shed; "
    "6: garage, tiny house; 12: farmhouse, bungalow; 25: mansion, police station, "
    "fire station; 40: school; 60: hospital",
    "cottage": "0.25: gingerbread house; 4: hut, shack; 10: chalet; 12: tavern, saloon; 15: inn",
    "tower": "8: turret",
    "church": "12: chapel; 40: mosque; 60: abbey, monastery; 80: basilica; 100: cathedral",
    "arch": "2.5: moon gate; 3: portal, portal gate; 50: arc de triomphe",
    "bridge": "8: boat dock, wooden dock, fishing dock; 10: footbridge, drawbridge, boardwalk; "
    "50: wharf; 80: pier; 100: viaduct, aqueduct",
    "castle": "12: gatehouse; 60: fort, stronghold; 100: fortress, citadel, palace",
    "fountain": "0.9: bird bath, birdbath",
    "pyramid": "55: mayan temple, aztec temple; 64: ziggurat; 230: pyramid of giza",
    "pagoda": "4: shrine; 10: japanese house, shinto shrine",
    "staircase": "1.2: doorstep, doorsteps",
    "temple": "15: mausoleum; 40: courthouse; 58: pantheon; 60: museum",
    "wall": "10: castle wall, city wall",
    "market stall": "1.8: lemonade stand",
    "dumpster": "3.6: skip, rubbish skip, waste skip",
    "greenhouse": "10: polytunnel",
    "gazebo": "2.4: arbor; 7: bandstand; 8: rotunda",
    "silo": "8: granary; 40: grain elevator",
    "ferris wheel": "135: london eye",
    "swing": "1.6: porch swing",
    "log cabin": "5: log hut, woodcutters hut; 12: hunting lodge",
    "skyscraper": "30: apartment building, apartment; 40: office building, apartment block, "
    "hotel; 60: tower block; 100: office tower; 443: empire state building",
    "bus stop": "5: tram stop",
    "solar panel": "6: solar array",
    "factory": "15: workshop; 25: sawmill, mill building; 60: warehouse, factory hall; "
    "100: power plant, power station, oil rig; 150: nuclear plant, steel mill; 200: refinery",
    "shop": "12: restaurant, diner, convenience store, post office; 15: grocery store; "
    "30: market building; 40: supermarket",
    "gas station": "25: truck stop",
    "column": "0.6: mooring bollard; 0.9: bollard; 1: plinth",
    "water tower": "3: water tank",
    "modern house": "25: modern mansion",
    "gate": "5: mansion gate",
    # electronics
    "phone": "0.09: mp3 player; 0.11: walkman; 0.2: router, modem; 0.25: tablet, ipad",
    "camera": "0.18: camcorder",
    "speaker": "0.15: smart speaker; 0.18: bluetooth speaker",
    "radio": "0.2: walkie talkie; 0.6: boombox",
    "headphones": "0.05: earbuds, airpods",
    "printer": "1.1: copier, photocopier",
    "television": "0.6: retro tv, crt",
    "vacuum cleaner": "0.34: robot vacuum, roomba; 0.4: dust buster; 0.6: shop vac",
    "tractor": "1.8: lawn tractor",
    "record player": "0.45: turntable, vinyl player, record deck, vinyl record deck, lp player, "
    "lp record player",
    "projector": "0.3: slide projector; 0.35: video projector, beamer",
    "calculator": "0.3: adding machine",
    "security camera": "0.09: webcam, web cam; 0.15: ip camera",
    "flashlight": "0.08: headlamp",
    "game console": "0.35: video game console",
    "robot arm": "0.25: robot hand, robot gripper",
    "battery": "0.14: power bank; 0.25: car battery",
    "satellite dish": "4: radar antenna; 8: radar station; 25: radio telescope",
    # what is worn
    "glove": "0.33: oven mitt; 0.36: gauntlet",
    "handbag": "0.11: wallet; 0.25: clutch; 0.42: tote bag, satchel, messenger bag",
    "suitcase": "0.55: carry on, travel bag; 0.9: travel trunk",
    "shirt": "1.4: kimono",
    "trousers": "0.5: shorts; 1.4: overalls, dungarees",
    "dress": "0.65: skirt",
    "wizard hat": "0.2: party hat",
    "cowboy hat": "0.3: bucket hat; 0.6: sombrero",
    "medal": "0.07: badge",
    "sock": "0.25: ankle sock",
    "scarf": "0.3: bandana, bandanna, neckerchief",
    "jacket": "1: suit, tuxedo, overcoat, lab coat, winter coat; 1.15: trench coat; "
    "1.3: robe, bathrobe, cape",
    "gas mask": "0.16: dust mask",
    # sport and tools
    "hockey stick": "0.95: field hockey stick; 1.05: lacrosse stick",
    "surfboard": "1.05: bodyboard, boogie board; 1.4: wakeboard; 1.55: snowboard; "
    "3.2: paddle board, paddleboard, sup board",
    "soccer goal": "1.8: hockey goal; 3: handball goal",
    "oar": "2.9: scull",
    "pool table": "3.7: snooker",
    "hammer": "0.9: sledgehammer",
    "axe": "0.38: hatchet; 0.45: tomahawk",
    "shovel": "0.32: trowel",
    "pickaxe": "0.65: ice axe",
    "saw": "0.25: jigsaw; 0.4: hacksaw",
    "pencil": "0.08: chalk; 0.09: crayon; 0.14: pen, marker, highlighter, felt tip",
    "scissors": "0.3: shears",
    "broom": "0.32: dustpan; 0.35: squeegee",
    "toolbox": "0.25: lunch box, lunchbox",
    "fire extinguisher": "0.65: scuba tank, air tank, diving bottle; 0.75: oxygen tank, "
    "oxygen bottle; 1.4: gas cylinder",
    "knife": "0.045: razor blade; 0.16: scalpel, box cutter; 0.18: pocketknife, pocket knife, "
    "pen knife, penknife; 0.2: butter knife",
    "spoon": "0.24: chopsticks; 0.3: ladle",
    "lego brick": "0.05: building block",
    "slide": "10: water slide",
    "chess king": "0.07: chess bishop",
    "chainsaw": "0.35: circular saw",
    "magnifying glass": "0.04: monocle; 0.05: loupe",
    "tennis racket": "0.26: ping pong paddle, table tennis paddle, table tennis bat",
    "pliers": "0.25: tin snips; 0.3: tongs",
    # instruments
    "drum": "0.25: tambourine; 0.6: bass drum, djembe, taiko; 0.75: timpani, conga",
    "violin": "1.2: cello; 1.8: double bass",
    "trumpet": "0.35: cornet; 1: tuba; 1.2: trombone",
    "xylophone": "2.2: marimba",
    "banjo": "0.7: mandolin",
    "saxophone": "1.35: bassoon",
    "harp": "0.5: lyre; 0.65: zither",
    "accordion": "0.2: concertina",
    "flute": "0.12: kazoo; 0.15: ocarina; 0.25: pan flute; 0.3: tin whistle, penny whistle; "
    "0.32: piccolo, recorder; 0.4: fife; 1.4: didgeridoo",
    "harmonica": "0.14: chromatic harmonica; 0.45: melodica",
}


def _sizes(row: str) -> dict[str, float]:
    sizes: dict[str, float] = {}
    for size, forms in (kinds.split(": ") for kinds in row.split("; ")):
        sizes |= dict.fromkeys(forms.split(", "), float(size))
    return sizes


# Metres, by the thing and the kind's name as it is read.
KIND_SIZES = {thing: _sizes(row) for thing, row in _ROWS.items()}

# Before the name of somebody alive, or right behind it: "a baby turtle", "a wolf cub".
YOUNG = frozenset("baby cub pup puppy calf chick foal hatchling kitten".split())
YOUNG_SCALE = 0.4  # of the size of who is grown
# Kinds that are young by themselves: "a baby lamb" is a lamb.
YOUNG_KINDS = YOUNG | frozenset(
    """lamb fawn bambi colt piglet duckling gosling cygnet owlet joey kid child children boy girl
    toddler tadpole dragonling larva grub maggot""".split()
)
