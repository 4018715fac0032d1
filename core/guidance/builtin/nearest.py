"""Words that the built-in prior does not know, for its hints, as data."""

# For each known word those that it is nearest to in meaning, or in shape where nothing is near in
# meaning: a safe is a cabinet.
NEAREST = {
    "cabinet": "locker",
    "shelf": "rack",
    "chest": "treasure",
    "laptop": "computer mouse",
    "monitor": "display",
    "sofa": "chaise",
    "vase": "pot",
    "teapot": "coffeepot, samovar",
    "goblet": "tumbler, grail",
    "bottle": "perfume",
    "cylinder": "battery",
    "candle": "match, lighter",
    "lamp": "streetlight, flashlight",
    "house": "building, shop, store",
    "tower": "minaret",
    "cottage": "bungalow",
    "windmill": "turbine",
    "telescope": "binoculars, periscope",
    "baseball bat": "club",
    "castle": "dungeon, kingdom",
    "arch": "tunnel",
    "rocket": "star wars, star trek",
    "ball": "earth, beach, bubble",
    "bust": "head, face",
    "cone": "tornado",
    "horse": "seahorse, sea horse",
    "lion": "leopard, cheetah, panther",
    "bird": "ostrich, bat",
    "snail": "slug",
    "spider": "insect",
    "carrot": "cucumber",
    "hat": "bonnet",
    "trophy": "prize, award",
    "yellow": "mustard",
    "grey": "charcoal, slate",
    "beige": "sand, khaki, taupe",
    "light blue": "azure, aqua",
    "lime": "chartreuse",
    "purple": "mauve",
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
    """able abroad aces alden align allen alone along amor amores amour andy angela angelo angle
    angles ants applies armory arose around arrest arrests artisan artisans asher badger
    badgers bain baird bakers banged banker bankers banned banter barlow barred barren barron
    basing basis bass batch batches bathe battle bead beale beard beat beatles beaver beefy
    bella belle bender berger biker bikers bile billion billions bladder blank blasted blatter
    bleaker blended bloc blunder blush bluster boast boasts boko bonded boned boner boom boost
    boosts booth booths booty borne borrow bots bottled bowel bowie bracket brackets brad
    brainy brake brakes bran branded bras breaker bred brian bride brides bridget bridle
    bridles bring brings brock brook brooks brow browne brownies brows bruh buckley bucky
    buick bulge bulk bullies bully burgess burn burner burrows burst bursts busch cable cain
    calif calm candies cannot canon canton canyon cape caramel carat carb carbs card cars
    carte caste cell cells certain chai chanel char chart charts cheesy chess chet chic chico
    chill chills chilly chin chip chive chives choke choked chopped choral chuck chunk chunks
    claim claims clamp cleaner cleaners clearer clever click clicks clone clones close closed
    closer closes closest clot cloudy coal coffee colin colton combo comin confer conte
    controlled cooke cooked cookery cooler cooper copied copies cora core corner corners corny
    counted cram crater craven creamy create creates creek crew crews crooks crouch crowd
    crowds crowe crusade curtail dairy danger dangers darth defer demo demos denies denis
    deter dicey dion dishy dogg dolly dolores done donor donors dont dover draped draper
    drawer dressed drove dustin dwell dyer each earle ebook ebooks eddy edge edges elon
    enchanted enveloped extinguished fail fails fair fallon father fathers fenced fend find
    finds fishy fitch flak flakes flattered float floats flock floor flow flowed flutes focal
    food forte forth forty freeze freezes friend friends fringe fringes gaelic gallon gallons
    gary gated genome genomes giggles girly glance glaze gloss glover going golf gore gould
    grades grady grain grange graphs grasses grassy grate graves gravy greek greene grizzlies
    ground grounded grounds groves grown hades hair hale hall handled handler handlers handy
    harper hart hatched hawke health hear hears hearty heat heath heats heck helix hell herts
    hicks hips holmes homer homie hone hopper horne horned horner hose host hosts housed hubby
    humane iggy inch inches infection irony jacked jean juice juiced juices jumped lace lack
    lacks laid lame lancer lancers lancs lander lane lanes late latter leafy leave ledge leigh
    lender lenders leon licking lien lilly litter live lives lobe lobes locke locked locking
    loft lopes loud love loves lower lowers lump lumps macau macs maggie magnified magnifies
    maker makers makin mali mange march marches marian marie marion marked market markets
    marlin marlon marrow martial martin martina martins math maze meal meals meant medial
    mellon melo mental merch meta metallica microscopy mikey milky milla mille milly mince
    mixes money mono month months moore moron morons morse moses mouth mouths muse muses nail
    nails night nights odor offer offers olaf oliver oman option options oral ouch pacing
    packaged paddock paid paine painter painters pair palate palin pant pantry parsons pats
    patter paving paying pearl pearson pendants persona phoned phony piazza pickle pickles
    picky piers piling pinky piped piper pistil piston pistons place places plain plan plans
    plated play plotter plumping pointer pointers pointing pools port portion portions potty
    prattle preach prevent prevents printed printing prose psalm psalms pure pursue quid rabbi
    rage rail rain raked raker ramen rang ranged ranger rangers rapper rappers rate rattled
    rattler rave read reads resent rested retrieve retrieved revolved revolves rick ridge
    ridges ringo road roads robbers robbins robyn rocked rockies rocky rookies room rooms root
    rosen rosie ross roster rosters rounder rubbed rubin rush rushed rushes sail sake sauce
    sauces saucier scandal scandals scanners scar scarlett scorn scotty scream screams screwy
    sears self sell sells selves sender settle settles shaded shake shaken shakes shakier
    shank shapes shard shards share sharer shares sharp shaver shear shelly shes shine shines
    shone shooter shooters shoots shopper shoppers shore shorty shot shots shouts shove shoved
    shrink side silky sing sings sitar skilled skit slack slander slid slime sludge smack
    snack snacks snare snowden sofia soon sort sorts soup spar spares spark sparks spawn
    speaks spectacle spicer spike spine spinner sport sprinter squad squads stack stacks stage
    stake stakes stale stalls stamp stan stare stark starr start starts starz steal steals
    steam steele steroid steroids stink stinks stoned stoner stopped strain strains streak
    stride strides strife strike strikes strip strips strive strives stroll struck stuns
    sunday swallows swears sweeter swell tail tale tally tara tarot tarzan tastes teak teethe
    tenth thank thanks thine thing things think thinks thorne three ticks time timer timers
    toasted toll tolls tone tones tool tools toot toothy tore tote tours tout towel towels
    trailer trailers trained trainee trainees traitor traitors tramp trans transformed trent
    truss trust trusted trusts tsar tubed tuck twitch tyrone valentin valentina valentino
    vidal violates violent viral vital waffled wail wales wanda washed washes weasel while
    whit whole widen wider widow widows wilde wolfe wolff wooded woody woolf word words woven
    """.split()
)
