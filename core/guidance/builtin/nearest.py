"""Words that the built-in prior does not know, for its hints, as data."""

# For each known word those that it is nearest to in meaning, or in shape where nothing is near in
# meaning: a safe is a cabinet.
NEAREST = {
    "chair": "wheelchair, swing",
    "cabinet": "safe, locker",
    "shelf": "rack",
    "chest": "treasure, coffin",
    "laptop": "computer, computer mouse",
    "monitor": "display",
    "table": "counter, altar",
    "bed": "hammock",
    "sofa": "futon, divan, chaise",
    "bench": "pew",
    "vase": "pot, amphora",
    "teapot": "coffeepot, samovar",
    "goblet": "tumbler, grail",
    "mug": "tankard, beaker, stein",
    "bowl": "dish, plate",
    "bottle": "perfume, thermos",
    "cylinder": "pipe, battery",
    "candle": "match, lighter",
    "lamp": "streetlight, flashlight",
    "house": "building, hotel, shop, store, mosque",
    "church": "cathedral, monastery",
    "tower": "obelisk, minaret, silo",
    "cottage": "igloo, bungalow, treehouse",
    "pagoda": "temple",
    "windmill": "turbine",
    "telescope": "binoculars, periscope",
    "pistol": "rifle, shotgun, musket",
    "baseball bat": "club",
    "blender": "coffee machine",
    "castle": "dungeon, kingdom",
    "arch": "portal, tunnel",
    "flower": "orchid, bouquet",
    "cactus": "succulent",
    "mushroom": "fungus",
    "car": "limousine",
    "bus": "caravan, camper",
    "excavator": "forklift, crane",
    "airplane": "jet, glider",
    "boat": "raft, ferry, gondola",
    "pirate ship": "warship",
    "train": "subway",
    "rocket": "missile, star wars, star trek",
    "ball": "earth, beach, bubble, coconut",
    "robot": "android, mech, cyborg, droid",
    "bust": "head, face, mask, mannequin",
    "cone": "tornado",
    "torus": "bracelet",
    "horse": "seahorse, sea horse",
    "deer": "llama, alpaca",
    "lion": "leopard, cheetah, panther",
    "chicken": "turkey",
    "bird": "ostrich, bat",
    "fish": "trout",
    "rabbit": "hare",
    "mouse": "guinea pig",
    "snake": "worm, eel",
    "snail": "slug",
    "crab": "shrimp",
    "ant": "insect",
    "bee": "mosquito",
    "alien": "monster",
    "hammer": "mallet, drill",
    "axe": "spear, scythe",
    "guitar": "harp",
    "drum": "tambourine, bongo",
    "bell": "gong",
    "dumbbell": "kettlebell",
    "apple": "orange fruit, tomato",
    "pumpkin": "squash, gourd",
    "carrot": "cucumber, radish",
    "ice cream": "sundae",
    "hat": "bonnet, beret",
    "trophy": "prize, award",
    "orange": "tangerine",
    "yellow": "mustard",
    "grey": "charcoal, slate",
    "beige": "sand, khaki, taupe",
    "light blue": "azure, aqua",
    "lime": "chartreuse",
    "purple": "mauve",
    "pink": "salmon",
    "green": "mint",
    "glass": "transparent, translucent",
    "plastic": "vinyl, nylon, acrylic",
    "metal": "titanium, tin, zinc",
    "wooden": "wicker",
    "stone": "cement, sandstone",
    "ceramic": "earthenware, enamel",
    "rubber": "silicone, latex",
    "fabric": "fur, fluffy, linen, canvas, knitted, plush",
}
# Words of everyday English that are one slip away from a known word: no misspellings.
REAL = frozenset(
    """able abroad alden align allen alone along andy ants applies arose around arrest arrests
    asher badger badgers bain baird banged banker bankers banned banter barlow barred barren barron
    basing basis bass batch batches bathe battle bead beale beard beat beatles bella belle bender
    berger biker bikers bile bladder blank blasted blended bloc blunder blush bluster boar boast
    boasts boko bonded boom boost boosts booth booths booty borrow bots bottled bowel bowie bracket
    brackets brad branded bras bred bride brides bridget bridle bridles bring brings brock brook
    brooks brow browne brownies brows bruh buckley bucky buick bulge bulk bullies bully burgess
    burn burner burrows burst bursts busch cable cain calif calm candies cane cannot canon canton
    canyon cape caramel carat carb carbs card cars carte caste cell cells chai chanel char chart
    charts cheesy chess chet chic chico chill chills chilly chin chip chopped choral chuck chunk
    chunks claim claims clamp cleaner cleaners clearer clever click clicks clone clones close
    closed closer closes closest clot coal coat coffee colin colton comb comin confer conte
    controlled cooke cooked cookery cooler cooper copied copies cora core corner corners corny cram
    crater craven creamy create creates creek crook crooks crouch crowd crowds crowe crusade dairy
    danger dangers darth defer denies denis deter dicey dion dogg dolly dolores done donor donors
    dont dover drawer dressed drove dustin dwell dyer each earle ebook ebooks eddy edge edges elon
    extinguished fair fallon fenced fishy fitch flakes flattered float floats flock floor flow
    flowed flute flutes focal food forte forth forty freeze freezes fringe fringes gaelic gallon
    gallons gary gated giggles girly glaze glock gloss glover golf gould grades grady grain grange
    graphs grasses grassy grate graves gravy greek greene grizzlies ground grounded grounds groves
    grown hades hair hale hall handled handler handlers harper hart hatched hawke health hear hears
    hearty heat heath heats heck helix hell herts hicks hips holmes homer homie hone hopper horne
    horned horner hose host hosts housed hubby humane iggy inch inches irony jacked jean juice
    juiced juices jumped lack lacks laid lame lander lane lanes ledge leigh lender lenders leon
    licking lien lilly live lives lobe lobes locke locking loft lopes love loves lower lowers lump
    lumps macau maggie magnified magnifies maker makers makin march marches marian marie marion
    marked market markets marlon marrow martial martin martina martins math maze meal meals medial
    mellon melo mental meta metallica microscopy mikey milky milla mille milly mince mixes money
    mono month months moore moron morons morse moses mouth mouths muse muses nail nails night
    nights odor offer offers olaf oliver oman option options oral ouch pacing packaged paddock paid
    paine painter painters pair palate palin pant pantry parsons pats paving paying pearl pearson
    pendant pendants persona phoned phony piazza pickle pickles picky piers piling pinky pistil
    piston pistons place places plain plan plans play pointer pointers pointing pools port portion
    portions potty preach prevent prevents printed printing prose psalm psalms pure pursue quid
    rabbi rage rail rain ramen rang ranged ranger rangers rapper rappers rate rave read reads
    resent rested retrieve retrieved revolved revolves rick ridge ridges ringo road roads robber
    robbers robbins robyn rocked rockies rocky rookies room rooms root rosen rosie ross roster
    rosters rounder rubbed rubin rush rushed rushes sail sake sauce sauces scandal scandals scanner
    scanners scar scarlett scorn scotty scream screams sears self sell sells selves sender settle
    settles shack shaded shake shakes shank shapes shard shards share shares sharp shear shelly
    shes shine shines shone shooter shooters shoots shopper shoppers shore shorty shot shots shouts
    shove shoved shrink side silky sing sings sitar skilled skit slander slid slider slime sludge
    snare snowden sofia soon sort sorts soup spark sparks spawn spectacle spicer spine spinner
    sport sprinter squad squads stable stage stair stake stakes stale stall stalls stamp stare
    stark starr start starts starz steal steals steam steele steroid steroids stink stinks stoned
    stoner stopped strain strains stride strides strife strike strikes strip strips strive strives
    stroll struck swallow swallows swears sweeter swell tail tale tally tara tarot tarzan tastes
    tenth thank thanks thine thing things think thinks thorne three tick ticks time timer timers
    toasted tone tones tool tools tore tote tours tout towel towels trailer trailers trained
    trainee trainees traitor traitors tramp trans trent truss trust trusted trusts tsar tuck tyrone
    valentin valentina valentino vidal violates violent viral vital waffle wail wales wall wanda
    washed washes while whit whole widen wider widow widows wilde wolfe wolff wooded woody woolf
    word words woven""".split()
)
