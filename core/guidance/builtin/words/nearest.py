"""Words that the built-in prior does not know, for its hints, as data."""

# For each known word those that it is nearest to in meaning, or in shape where nothing is near in
# meaning: a safe is a cabinet.
NEAREST = {
    "cutting board": "knife block",
    "curtain": "folding screen, room divider",
    "saw": "hand plane, block plane, bench plane, jack plane, wood plane",
    "stool": "cat tree, cat scratcher, scratching post",
    "can": "toothpaste tube, paint tube",
    "mug": "pen holder, pencil holder, pencil cup",
    "bottle": "cocktail shaker",
    "shelf": "rack",
    "chest": "treasure",
    "monitor": "display",
    "teapot": "samovar",
    "goblet": "grail",
    "candle": "match, lighter",
    "tower": "minaret",
    "telescope": "periscope",
    "castle": "dungeon, kingdom",
    "arch": "tunnel",
    "rocket": "star wars, star trek",
    "ball": "beach, bubble, pokeball, poke ball",
    "shop": "train station, railway station",
    "toaster": "air fryer",
    "doll": "minifigure, minifig",
    "bust": "head, face",
    "cone": "tornado",
    "snail": "slug",
    "spider": "insect",
    "trophy": "prize, award",
    "beige": "sand",
    "stone": "cement",
}
# What is often written for a word; much of it is more than one slip away, or short.
MISSPELLED = {
    "bicycle": "bycicle bycycle bicylce byke bicicle",
    "elephant": "elefant elaphant",
    "rhino": "rhinocerous rhinosaurus rinocerous rino",
    "hippo": "hippopotomus hipopotomus hippotamus",
    "giraffe": "jiraffe girrafe",
    "crocodile": "krokodil crocadile crocadil",
    "squirrel": "squirell squirl skwirl",
    "gorilla": "gorrila",
    "dinosaur": "dinosor dinosour",
    "peacock": "peecock",
    "scissors": "sizzors sissors scizzors",
    "sandwich": "samwich sammich sandwitch",
    "hamburger": "hambuger hamburguer hamberger",
    "chandelier": "chandaleer shandelier chandeleer",
    "telephone": "telefone telefon",
    "microphone": "microfone mikrophone mikrofon",
    "headphones": "headfones hedphones",
    "phone": "fone fon",
    "chair": "cheir chare chiar",
    "sofa": "sofe soffa",
    "vase": "vaze vaise",
    "axe": "axt acks",
    "robot": "roboter robott robbo",
    "castle": "casle castel kastle",
    "bridge": "brige brigde",
    "sunflower": "sunflour",
    "apple": "apel appel",
    "astronaut": "astronot astranaut",
    "mermaid": "mermade",
    "accordion": "acordian accordian",
    "piano": "piono pianno",
    "guitar": "gitar gitarre guitarr",
    "knight": "knigt",
    "motorcycle": "motobike motercycle",
    "airplane": "airoplane aeroplain",
    "boat": "bote",
    "bottle": "botel",
    "wheelbarrow": "wheelbarrel wheelbarow",
    "wooden": "woodn",
    "yellow": "yelow yello",
    "purple": "purpel perple",
    "grey": "gery graey",
    "white": "wite",
    "green": "gren grene",
    "leather": "lether",
    "marble": "marbel",
    "shiny": "shinny",
}
# Words of everyday English that are one slip away from a known word: no misspellings.
REAL = frozenset(
    """aback abby able abroad aces acne agate ailing airline airlines airy alden align
    allen alone along alta amen amer amor amores amour ample amplified anders andy ange
    angela angelo anger angle angles anil ants applies aquarius arcane arched archery
    armory arose around arrest arrests artisan artisans asher astray atrophy audio audit
    audits automation babes backboard backer backers bain baird bake bakers banged
    banger banked banker bankers banned bans banter barker barlow baron barons barre
    barred barren barrie barron basal basing basis bass batch batches bateman bathe
    batsman batter batters battle beacon beacons bead beale beamed beard bearer bearers
    beat beater beatles becker beefy bella belle bello bender bennet berger bernie bert
    beset bets biker bikers bile billion billions bladder blank blasted blatter blaze
    bleaker blended blip blister blisters bloc blocker blockers blokes blot blunder
    bluster boast boasts boer boko bolder bollocks bombed bonded boned boner bong bono
    bony boom boone boos boost boosts booth booths booty bora borne borrow both bots
    bottled bowel bowie bracket brackets brad brainy brake brakes bran branded bras
    breaker bred bret brian bribe bribes brice brides bridget bridle bridles brief
    briefs brine bring brings brock brom brook brooks brow browne brownies brows bruh
    buckeyes buckley bucky buddies budge buffer buffers buffett bugger buick bulge bulk
    bullies bully burgess burglary burn burner burr burrow burrows burst bursts busch
    bushel businessmen busty buttery cable caged cain caine calif callie calm came
    camped candies cannes cannot canon canton canyon carat carb carbide carbon carbs
    card carlton carmel carmen carmine cars carson carte cartoons casper caste cate
    cayman cell cells certain chai chan chanel changer char charley chart charts cheater
    cheaters cheating checker cheery cheesy chess chet chia chic chico chief chiefs
    chill chills chilly chimes chin chino chip chive chives choke choked chopped choral
    chose chuck chunk chunks claim claims clamp cleaner cleaners clearer cleave clever
    click clicks clone clones close closed closer closes closest clot cloudy coal coast
    coasts cocks colin collage collide collier collin collins colton combo comin command
    commands commuter commuters compute computed condo condom condoms condos coney
    confer confines cong connector connectors connor connors conor contained conte
    controlled cooke cooked cookery cooks cooler cooper cope copied copies cora core
    cornea corner corners corny coroner corral corset coulter counted countess coup
    couple couples coven cowell craft crafts cram crap crater craven creamy create
    creates cree creek creep creeps crew crews crock crocker crooks crotch crouch crowd
    crowds crowe crunch crusade crusty crutches curate curtail cyclones dairy dance
    danced dances danger dangers darth defective defer demo demos denies denis deter
    deterrent devi diced dicey dictionaries dill dine ding dinner dinners dion dirt
    dishy diva divas dive divert dives dogg dolly dolores done donor donors dont
    doorstop doorstops dover dowry draft drafts draped draper drawer dressed driver
    drivers droughts drove ducking duet dumber dumped duress dust dustin duties duty
    dwell dyer each earle ease eater eaters eating eaves ebook ebooks eddy edge edges
    ellington elon email emails enchanted enveloped ester everett evils express
    extinguished facet facets factor factors fail fails fair fairly fallon famer farmed
    father fathers feces fenced fend ferrer fewer figured filth find finds fined fishy
    fitch flak flakes flaming flattered flipped float floats flock floor flow flowed
    flowery flue fluff flurry flutes focal food forearm former forte forth forties forty
    freeze freezes friend friends fringe fringes frost fulton fury gaelic gallon gallons
    garbage gardiner gardner gary gated gave gender genders genome genomes gibson
    giggles gill gilles gills girly gladys glance glaze glide glover gmail going golf
    gomes gore gould graces grader graders grades grady graft grain grange granger
    graphs grasses grassy grate grated gravel graves gravy greater greaves greek greene
    grenada grim grizzlies grocer ground grounded grounds grover groves growing grown
    hack hacked hacks hades hadley hailey haines hair hale haley hall handled handler
    handlers handy hanged hanley harbor harbors harem harlem harmonic harper harrow hart
    hartley harvey hatch hatched hatches hater haters hating hawke hawley hayley header
    headers heading healed healing health hear hearing hearings hears hearst hearty heat
    heated heath heather heats hebron heck helix hell heller heroin herts hester hicks
    highlighted hike hikes hilly hips holmes homer homey homie hone hooker hookers
    hooper hopper horne horned horner horny host hostel hosts hotter housed hover hubby
    humane humble hunger hunted hunts hurley hurts icloud iggy ills images inch inches
    infection inland irony itch ivan jacked jens jest jeter joke jokes jude judged
    juiced juices jumped kate kernel kindly kinds kink kinks knotted kraft laced lacey
    lack lacks laid lama lame lancer lancers lancet lancs lander lane lanes laps lass
    late latter layer layers leafy leases leave ledge leigh lender lenders leon leonard
    lester licking lien lila lilly limbo limp linden linn litter live lives loader lobe
    lobes locke locked locking loft loin lopes loss losses lots loud love loves lower
    lowers lumbar lump lumps lush macaroni macau macs maggie magneto magnified magnifies
    magnus maine majors maker makers makin male males mali mana mange manson mantra
    manuel march marches marge marian marie marin marina mariner mariners marino marion
    marked market markets marlin marlon marquez marrow martial martin martina martins
    mata mate math matteo matter matters matty maxine mayors maze meal meals meant meaty
    medial mellon melo melodic mental merch meta metallica microscopy mikey milky milla
    mille millet milly milner mince mine mines minors minster minutes mixes mode modes
    monarchy monasteries money mono month months moor moore moors moron morons morse
    mortal mortals moses moto mousse mouth mouths munster muse muses nail nails newer
    night nights nina noel number numbers odor offer offers olaf oliver ollie oman opens
    option options oral ouch outer over overall overs pacing packaged paddock paid paine
    painters pair palate palin pane pant panting pantry para parameter
    parameters park parks parsons past pastries pasty pats patter paving paying peachy
    pearl pearson pellet pellets pendants penis penises persona peter peters phase
    phased phases phoned phony photographs piazza pickled pickles picky piers pierson
    pilates piling pinky piped piper pistil piston pistons pitched pitches place places
    placid plain plan planned planners plans planted plat plated play pleasant plot
    plots plotter plumbers plumping pointer pointers pointing poke poole pools port
    porter portion portions portman postal posted potted potter potty prattle preach
    prevent prevents price prices prick pricks printed printing prison prisons probe
    probes prose protector protectors psalm psalms puddle punter pure pursue push pushes
    quart quid quit quits rabbi racked rage raiding rail rain raining raising raked
    raker rang ranged rangers rape rapes rapper rappers rate rather rattled rattler rave
    rayon read reads recorded regret regrets rein reins remove removes resent resign
    resigns rested retrieve retrieved reuters revolve revolved revolves rick ride rides
    ridge ridges rife ringer ringo road roads robbed robberies robbers robbery robbins
    robo robyn rocked rockies rocky role roles roll rolls rookies room rooms root roped
    roper rosen rosetta rosie ross roster rosters rouge rounder rouse rout route routed
    routes rubbed rubin rugby rush rushed rushes sable safer sail sake salim salman
    salon salons sana sata sauce sauces saucier saudi saudis scandal scandals scanned
    scanners scar scarlett scholes schoolers scissor scones scooby scorn scorpio scotty
    scrape scraped scream screams screwy scully seaman sean sears seater seek seeks self
    sell sells selves sender serve served serves setter settle settles sever sewer
    sewers sewing shaded shake shaken shakes shakier shank shapes shard shards share
    sharer shares sharp shaver shaw shear shelling shelly shelved shes shia shin shine
    shines shipper shippers shit shits shock shocking shocks shone shooter shooters
    shoots shopper shoppers shore shorty shot shots shouts shove shoved shred shreds
    shrewd shrink shuts sickly side simmer sing sings sinner sinners sire sitar skaters
    skies skilled skipper skit slack slander slated slater slaves slid slimy slipped
    slippery sliver slotted sludge slumber smack smitten snack snacks snipe snowden
    snowfall sofia solder soon sore sores sort sorts sowing spanned spar spares spark
    sparks sparta spawn speaks spectacle spectra sphinx spicer spike spine spinner spite
    spock sport sporty sprinter squad squads stack stacked stacking stacks stage stain
    stains stake stakes stale stalker stalling stalls stamp stan staple staples stare
    staring stark starr starring start starting startling starts starving starz state
    states stature status statute statutes steal steals steam steele stent sterling
    steroid steroids sticker stickers sticking still stills stings stink stinks stir
    stirling stokes stoned stoner stopped stored storey storeys stories strain strained
    strains stray streak stride strides strife strike strikes strip strips strive
    strives strokes stroll struck stuns styles sued suffer suffers suite sunday swain
    swallows swann swatch swatches swears sweeter swell sworn synthesized tail tale
    tally tara tarot tarzan tastes teaches teenage teethe tempe templates tenet tenets
    tenth thank thanks thatcher theater theaters thermo thine thing things think thinks
    thorn thorne thorns those threat threats three throng ticks tier tiers tight time
    timer timers tipped tired toasted toll tolls tone tones tons tool tools toot toothy
    topper tore tori tories torque tort tote tourism tours tout towels tracer tracy
    trade traded trades trailed trailing trained trainee trainees traitor traitors tramp
    tran trans transformed trap traps travers tread trent tres trick tricks tries trifle
    trope tropes trot truss trust trusted trusts trusty tsar tubed tuck turned tweak
    tweaks twitch tyrone uber urban usage utter vail valentin valentina valentino
    vanished venues vets vidal village villages violates violent viral vital vulcan
    waffled wail waited waiver waivers wales walled waller wallis wally walter walters
    wanda warp washed washes weed weeds wellness while whisper whispers whistler whit
    whole wicked wicket wickets widen wider widow widows wilde wolfe wolff wooded woody
    woolf word words worked worship wrath wrestle wrestled writer writers""".split()
)
