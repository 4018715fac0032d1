"""Words that the built-in prior does not know, for its hints, as data."""

# For each known word those with the nearest meaning, or shape where no meaning is near: a safe is a
# cabinet.
NEAREST = {
    "cutting board": "knife block",
    "curtain": "folding screen, room divider",
    "can": "paint tube",
    "mug": "pen holder, pencil holder, pencil cup",
    "bottle": "cocktail shaker",
    "shelf": "rack",
    "chest": "treasure",
    "monitor": "display",
    "goblet": "grail",
    "candle": "match",
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
    "ship wheel": "roulette wheel, roulette, potter wheel, potters wheel, pottery "
    "wheel, wheel of fortune, fortune wheel, prayer wheel, "
    "color wheel, colour wheel",
    "dragonfly": "grasshopper, cricket insect, mantis, praying mantis, locust",
    "snail": "slug",
    "spider": "insect",
    "trophy": "prize, award",
    "beige": "sand",
    "stone": "cement",
}
# Frequent misspellings; many are more than one slip away, or short.
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
    """aback abby able abroad accept accepts aces acne adding adventure adventures agate
    ahead ailing airline airlines airy alden align allen alone along alta amen amer amor
    amores amour ample amplified anders andy ange angela angelo anger angle angles anil
    ants applies aquarius arcane arched archery armory arose around arrest arrests artisan
    artisans ascent asher astray atrophy attach attached audio audit audits automation
    babes backboard backer backers bain baird bake bakers ballard ballet banged banger
    banging banked banker bankers banking banned banning bans banter barker barlow barnes
    baron barons barre barred barren barrie barron basal based basel basing basis bass
    batch batches bateman bathe batsman batter batters battle beacon beacons bead beale
    beamed beard bearer bearers beat beater beatles becker beefy bella belle bello bender
    bending bends bennet berger bernie bert beset bets biases bidding biker bikers biking
    bile billion billions bladder blames bland blank blasted blatter blaze bleak bleaker
    blended blip blister blisters bloc blocker blockers blokes blot blunder bluster boast
    boasts boer boko bolder bollocks bombed bond bonded bonding boned boner bono bony
    boom boone boos boost boosts booth booths booty booze bora borne borrow both bots
    bottled bowel bowie bowled bracket brackets brad brainy brake brakes braking bran
    brand branded branding brands bras break breaker breaks bred bret brian bribe bribes
    brice brides bridget bridle bridles brief briefs brine bring brings brock brody brom
    brook brooks brow browne brownies brows bruh buckeyes buckley bucky buddies budding
    budge buffer buffers buffett bugger buick bulge bulk bullies bully bummer bumped
    burgess burglary burn burner burr burrow burrows burst bursts busch bushel businessmen
    busty buttery cable caged cain caine calif callie calm came camped candies cannes
    cannot canon canton canyon carat carb carbide carbon carbs card caring carlton carmel
    carmen carmine cars carson carte cartoons casey casino casinos casper caste casting
    cate cause causes causing cayman cease ceases cell cellar cells centred certain chai
    chan chanel changer char charley chart charts chase chases chasing cheater cheaters
    cheating checker cheery cheesy chess chet chia chic chico chief chiefs chill chills
    chilly chin chino chip chive chives choke choked chopped chops choral chord
    chords chose chuck chunk chunks claim claims clap clare class classes cleaner
    cleaners clearer cleave clever click clicks clipped clone clones close closed closer
    closes closest clot clothed cloudy clover coal coast coasts cocks colin collage
    collide collier collin collins colton combo comin command commands commuter commuters
    compute computed condo condom condoms condos coney confer confines cong connector
    connectors connor connors conor contained conte continent controlled cooke cooked
    cookery cooks cooper cope copied copies cora core cornea corner corners corny
    coroner corps corpses corral corset costing coulter counted countess coup couple
    couples cove coven covert cowell craft crafts cram crap crater craven creamy create
    creates cree creek creep creeps crew crews crises crock crocker crooks crops crotch
    crouch crowd crowds crowe crunch crusade crusty curate curtail cyclones dairy
    dance danced dances danger dangers darth defective defer demo demos denied denies
    denis detain deter deterrent devi diced dicey dictionaries dill dine ding dinner
    dinners dion dirt dishy diva divas dive divert dives dogg dolly dolores done donor
    donors dont doorstop doorstops dover dowry draft drafts draped draper drawer dressed
    driver drivers droughts drove ducking duet dumber dumped duress dust dustin duties
    duty dwell dyer each earle earns ease eater eaters eating eaves ebook ebooks eddy edge
    edges element ellington elon email emails enchanted enter enters enveloped eras erie
    ester everett evils explore explored explores explosive express extinguished faced
    facet facets factor factors fade fades fail fails fair fairly fallon fame famer farce
    farmed father fathers fears feces fenced fend ferrer fewer figured filth find finds
    fined finnish fired fishy fitch fitting flak flakes flaming flares flattered fleet
    fleets flipped flips float floats flock floor flow flowed flowery flue fluff flurry
    flutes focal food forearm foreman former forte forth forties forty framed freeze
    freezes friend friends fringe fringes frost fulton fury fused gaelic gallon gallons
    games garbage gardiner gardner gary gated gave gaze gender genders genome genomes
    germs gibson giggle giggles gill gilles gills girly gladys glance glaze glide glover
    gmail going golf gomes gore gould graces grader graders grades grady graft grain
    grange granger graphs grasses grassy grate grated gravel graves gravy greater greaves
    greek greene grenada grilled grim grizzlies grocer gross ground grounded grounds
    grover groves growing grown hack hacked hacks hades hadley hailey haines hair hairy
    hale haley hall handled handler handlers handy hangar hanged hanley hans harbor
    harbors harem harlem harmonic harper harrow hart hartley harvey hatch hatched hatches
    hater haters hating hawke hawley hayley haze header headers heading healed healing
    health hear heard hearing hearings hears hearst hearty heat heated heath heather heats
    hebron heck helix hell heller heroin herts hester hicks highlight highlighted hike
    hikes hilly hips holmes homer homey homie hone hooker hookers hooper hopper horne
    horned horner horny host hostel hosts hotter housed hover hubby humane humble hunger
    hunted hunts hurley hurts icloud iggy ills illuminate images inch inches infection
    inland irony itch ivan jackass jacked jens jest jeter joke jokes jude judged juiced
    juices jumped kate kernel kindly kinds kink kinks knotted kraft laced lacey lack lacks
    laid lama lame lancer lancers lancet lancs lander lane lanes laps lara larvae lass
    late latter layer layers leafy leans leases leave ledge leigh lender lenders lends
    leon leonard lester licking lien lila lilly limbo limp linden linn litter live lives
    loader lobe lobes locke locked locking loft loin lopes loss losses lots
    loud love loves lower lowers lumbar lump lumps lush macaroni macau macs maggie magneto
    magnified magnifies magnus maine majors maker makers makin male males mali mana mange
    manson mantra manuel march marches marge margot marian marie marin marina mariner
    mariners marino marion marked market markets marlin marlon marquez marrow martial
    martin martina martins mata mate math matteo matter matters matty maxine mayors
    meal meals meant meaty medial mellon melo melodic mental merch meta metallica
    microscopy mikey milky milla mille millet milly milner mimi mince mine mines minors
    minster minutes mixes mode modes monarchy monasteries money mono month months moor
    moore moors moron morons morse mortal mortals moses moto mousse mouth mouths munster
    muse muses ness nesting newer night nights nina noel number numbers odor
    offer offers olaf oliver ollie oman opens option options oral others ouch outer
    outsider outsiders over overall overs owing pacing packaged paddock paid pain paine
    pains painted painters pair palate palin pane pant panting pantry para parameter
    parameters park parks parsons past pastries pasty pats patter paving paying peachy
    pearl pearson peeing pellet pellets pendants penis penises persona peter peters phase
    phased phases phoned phony photographed photographs piazza pickled pickles picky piers
    pierson pilates piling pinky pint pints piped piper pistil pitched
    pitches place places placid placing plain plan planned planners plans planted planting
    plat plated play playing pleasant plot plots plotter plugs plumbers plumping pointer
    pointers pointing poke poole pools port porter portion portions portman postal posted
    potted potter potty prattle preach prevent prevents price priceless prices prick
    pricks printed printing prison prisons probe probes proof proofs propelled prose
    protector protectors psalm psalms puddle pull pulses punter pure pursue push pushes
    quart quid quit quits rabbi rabies racers racked rage raiding rail rain raining
    raising raked raker rang ranged rangers rape rapes rapper rappers rate rather rattled
    rattler rave rayon read reader readers reads recorded regret regrets rein reins remove
    removes resent resign resigns respiratory rested retrieve retrieved reuters revolve
    revolved revolves rick ride rides ridge ridges rife rigs ringer ringo rink road roads
    robbed robberies robbers robbery robbins robo robyn rocked rockies rocky role roles
    roll rolls rookies room rooms root roped roper rosen rosetta rosie ross roster rosters
    rouge rounder rouse rout route routed routes rubbed rubin rugby rule rules rush rushed
    rushes sable safer sail sake sale sales salim salman salon salons sana sata sauce
    sauces saucier saudi saudis scaled scandal scandals scanned scanners scar scares
    scarlett scholes schoolers scissor scones scooby scorn scorpio scotty scrape scraped
    scratches scream screams screwy scully seaman sean sears seater seek seeks self sell
    sells selves sender sends serve served serves setter settle settles sever sewer sewers
    sewing shaded shake shaken shakes shakier shank shapes shard shards share sharer
    shares sharp shaw shear shelling shelly shelved shes shia shin shine shines
    shipper shippers shit shits shock shocking shocks shone shooter shooters shoots
    shopper shoppers shore shorty shot shots shouts shove shoved shred shreds shrewd
    shrink shuts sickly side silicon simmer sing sings sinner sinners sire sitar skaters
    skid skies skilled skipper skit slack slander slated slater slaves slices slid slimy
    slipped slippery slips sliver slotted sludge slumber smack smitten snack snacks snipe
    snowden snowfall sofia solder soon sore sores sort sorts sowing spanned spar spares
    spark sparks sparta spawn speaks spectacle spectra spicer spices spiked
    spine spinner spite spock sport sporty spring springs sprinter squad squads stack
    stacked stacking stacks stain stains stake stakes stale stalker stalling stalls
    stamp stan staple staples stare staring stark starr starring start starting startling
    starts starving starz state states stature status statute statutes steal steals steam
    steele stent sterling steroid steroids sticker stickers sticking sticky still stills
    sting stings stink stinks stir stirling stitch stokes stoned stoner stopped stored
    storey storeys stories storing strain strained strains strand stray streak stretched
    stretches stride strides strife strike strikes strip stripping strips strive strives
    strokes stroll strong struck strung stuns sturgeon styles sued suffer suffers suite
    sunday sunk surfaced swain swallows swann swatch swatches swears sweat sweeter swell
    swine sworn synthesized tail tale talk talks tally taped taper tara tarzan
    tastes teaches tears teenage teethe tempe templates tends tenet tenets tenth thank
    thanks thatcher theaters thermo thine thing things think thinks thorn thorne
    thorns those threat threats three throng ticks tier tiers tight time timer timers
    tipped tired toasted toll tolls tomas tombs tone tones tong tons tool tools toot
    toothy topper tore tori tories torque tort tote touched tourism tours tout towels
    tracer tracy trade traded trades trailed trailing trained trainee trainees traitor
    traitors tramp tran trans transformed trap trapping traps travers tread trent tres
    trick tricks tries trifle trope tropes trot truss trust trusted trusts trusty tsar
    tubed tuck tumble turned tweak tweaks twitch tyrone uber urban usage utter vail
    valentin valentina valentino vanish vanished venues vets vidal village villages
    violates violent viral vital vulcan waffled waged wail waited waiting waiver waivers
    wales walled waller wallis wally walter walters wanda warp washed washes wears weed
    weeds wellness while whine whisper whispers whistler whit whole wicked wicket wickets
    widen wider widow widows wigs wilde wins wolfe wolff wooded woody woolf word words
    worked works worlds worship wrapped wrapping wrath wrestle wrestled writer writers
    years""".split()
)
