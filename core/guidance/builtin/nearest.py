"""Words that the built-in prior does not know, for its hints, as data."""

# For each known word those that it is nearest to in meaning, or in shape where nothing is near in
# meaning: a safe is a cabinet.
NEAREST = {
    "cabinet": "locker",
    "shelf": "rack",
    "chest": "treasure",
    "monitor": "display",
    "teapot": "samovar",
    "goblet": "tumbler, grail",
    "candle": "match, lighter",
    "tower": "minaret",
    "telescope": "periscope",
    "castle": "dungeon, kingdom",
    "arch": "tunnel",
    "rocket": "star wars, star trek",
    "ball": "earth, beach, bubble",
    "bust": "head, face",
    "cone": "tornado",
    "snail": "slug",
    "spider": "insect",
    "trophy": "prize, award",
    "beige": "sand",
    "glass": "transparent, translucent",
    "stone": "cement",
    "fabric": "canvas",
}
# Words of everyday English that are one slip away from a known word: no misspellings.
REAL = frozenset(
    """abby able abroad aces acne agate ailing airline airlines airy alden align allen alone along
    alta amen amer amor amores amour ample amplified andy angela angelo angle angles anil ants
    applies arched archery armory arose around arrest arrests artisan artisans asher automation
    babies backboard backer backers badger badgers bain baird bake bakers banged banger
    banked banker bankers banned banter barker barlow baron barons barre barred barren barrie
    barron basing basis bass batch batches bateman bathe batsman batter batters battle beacon
    beacons bead beale beamed beard bearer bearers beat beater beatles becker beefy bella belle
    bello bender berger bernie bert beset biker bikers bile billion billions bladder blank
    blasted blatter blaze bleaker blended blister blisters bloc blokes blot blunder bluster
    boast boasts boko bolder bollocks bombed bonded boned boner bong bono boom boone boos boost
    boosts booth booths booty bora borne borrow both bots bottled bowel bowie bracket brackets
    brad brainy brake brakes bran branded bras breaker bred bret brian bribe bribes brides
    bridget bridle bridles brief briefs brine bring brings brock brook brooks brow browne
    brownies brows bruh buckeyes buckley bucky buddies budge buffer buffers buffett bugger buick
    bulge bulk bullies bully burgess burglary burn burner burrow burrows burst bursts busch
    bushel businessmen busty buttery cable cain caine calif calm came camped candies cannes
    cannot canon canton canyon carat carb carbon carbs card carlton carmel cars carson
    carte cartoons casper caste cate cayman cell cells certain chai chan chanel char charley
    chart charts checker cheery cheesy chess chet chia chic chico chief chiefs chill chills
    chilly chimes chin chino chip chive chives choke choked chopped choral chuck chunk chunks
    claim claims clamp cleaner cleaners clearer cleave clever click clicks clone clones close
    closed closer closes closest clot cloudy coal coast coasts cock cocks colin collide collier
    collin collins colton combo comin commuter commuters compute computed condo condom condoms
    condos coney confer confines cong connor connors conor contained conte controlled cooke
    cooked cookery cooks cooler cooper cope copied copies cora core cornea corner corners corny
    coroner corral corset coulter counted countess coup couple couples coven cowell cracked
    craft crafts cram crap crater craven creamy create creates creek crew crews crock crocker
    crooks crouch crowd crowds crowe crusade crusty crutches curate curtail dairy dance
    danced dances danger dangers darth defective defer demo demos denies denis deter diced dicey
    dictionaries dill ding dinner dinners dion dishy diva divas dive divert dives dogg dolly
    dolores done donor donors dont dover draft drafts draped draper drawer dressed driver
    drivers drove ducking duress dustin duties duty dwell dyer each earle ease eaves ebook
    ebooks eddy edge edges ellington elon email emails enchanted enveloped ester evils express
    extinguished fail fails fair fairly fallon famer farmed father fathers feces fenced fend
    ferrer fewer figured find finds fined fishy fitch flak flakes flaming flattered float floats
    flock floor flow flowed flowery flue fluff flutes focal food forearm former forte forth
    forties forty freeze freezes friend friends fringe fringes fulton fury gaelic gallon gallons
    garbage gary gated gave genome genomes gibson giggles gill gilles gills girly gladys glance
    glaze glide glover gmail going golf gomes gore gould graces grades grady graft grain grange
    graphs grasses grassy grate gravel graves gravy greaves greek greene grenada grim grizzlies
    ground grounded grounds grover groves grown hack hacks hades hadley hailey hair hale haley
    hall handball handled handler handlers handy hanley harbor harbors harem harlem harper
    harrow hart hartley harvey hatched hatches hawke hayley health hear hears hearst hearty heat
    heath heats hebron heck helix hell heroin herts hicks highlighted hilly hips holmes homer
    homey homie hone hooker hookers hooper hopper horne horned horner horny host hostel
    hosts hotter housed hover hubby humane humble hurley icloud iggy images inch inches
    infection inland irony itch ivan jackass jacked jens jeter joke jokes juiced
    juices jumped kate kernel kindly kink kinks knotted kraft lack lacks laid lama lame lancer
    lancers lancet lancs lander lane lanes lass late latter leafy leases leave ledge leigh
    lender lenders leon leonard lester licking lien lila lilly limbo limp litter live lives
    loader lobe lobes locke locked locking loft loin lopes lots loud love loves lower lowers
    lumbar lump lumps lush macaroni macau macs maggie magneto magnified magnifies maker makers
    makin male males mali mana mange manson mantra march marches marge marian marie marion
    marked market markets marlin marlon marquez marrow martial martin martina martins mata math
    maze meal meals meant meaty medial mellon melo mental merch meta metallica microscopy mikey
    milky milla mille milly mince minster mixes monarchy monasteries money mono month months
    moore moron morons morse mortal mortals moses mousse mouth mouths munster muse muses nail
    nails newer night nights nina noel odor offer offers olaf oliver ollie oman option options
    oral ouch over overall overs pacing packaged paddock paid paine painter painters pair palate
    palin pane pant panting pantry para parameter parameters park parks parsons pastries pasty
    pats patter paving paying peachy pearl pearson pellet pellets pendants persona phase phased
    phases phoned phony photographs piazza pickled pickles picky piers pierson pilates piling
    pinky piped piper pistil piston pistons pitched pitches place places placid plain plan
    planner planners plans planted plat plated play pleasant plotter plumbers plumping
    pointer pointers pointing policemen poole pools port porter portion portions postal posted
    potted potter potty prattle preach prevent prevents price prices prick pricks printed
    printing prison prisons prose protector protectors psalm psalms punter pure pursue push
    pushes quart quid rabbi racked rage raiding rail rain raining raising raked raker rang
    ranged rangers rape rapes rapper rappers rate rattled rattler rave rayon read reads
    regret regrets resent rested retrieve retrieved revolve revolved revolves rick ridge ridges
    rife ringo road roads robbed robberies robbers robbery robbins robo robyn rocked rockies
    rocky role roles roll rolls rookies room rooms root roped roper rosen rosetta rosie ross
    roster rosters rouge rounder rouse rout routes rubbed rubin rugby rush rushed rushes sable
    safer sail sake salim salman salon salons sana sata sauce sauces saucier scandal scandals
    scanned scanners scar scarlett scholes schoolers scissor scones scorn scorpio scotty scream
    screams screwy sean sears seater self sell sells selves sender serve served serves settle
    settles sever sewer sewers sewing shaded shake shaken shakes shakier shank shapes shard
    shards share sharer shares sharp shaver shear shelling shelly shelved shes shia shine shines
    shipper shippers shit shits shock shocking shocks shone shooter shooters shoots shopper
    shoppers shore shorty shot shots shouts shove shoved shred shreds shrewd shrink sickly side
    sing sings sire sitar skaters skilled skipper skit slack slander slaves slid slime
    slimy slipped slippery sliver slotted sludge slumber smack smitten snack snacks snipe
    snowden snowfall sofia solder soon sort sorts sowing spanned spar spares spark sparks
    sparta spawn speaks spectacle spectra sphinx spicer spike spine spinner spite spock sport
    sporty sprinter squad squads stack stacked stacking stacks stage stains stake stakes stale
    stalker stalling stalls stamp stan staple staples stare staring stark starr starring start
    starting startling starts starving starz state states stature status statute statutes steal
    steals steam steele stent sterling steroid steroids sticker stickers sticking still stills
    stings stink stinks stir stirling stokes stoned stoner stopped stored storey storeys strain
    strains streak stride strides strife strike strikes strip strips strive strives strokes
    stroll struck stuns sunday swain swallows swann swatch swatches swears sweeter swell
    synthesized tail tale tally tara tarot tarzan tastes teaches teethe tempe templates tenet
    tenets tenth thank thanks thermo thine thing things think thinks thorn thorne thorns three
    throng ticks tier tiers time timer timers tired toasted toll tolls tone tones tool tools
    toot toothy topper tore tori tories tort tote tours tout towels trailer trailers trailing
    trained trainee trainees traitor traitors tramp tran trans transformed trent trick tricks
    tries trifle trope tropes trot truss trust trusted trusts trusty tsar tubed tuck twitch
    tyrone utter vail valentin valentina valentino vets vidal village villages violates violent
    viral vital vulcan waffled wail waited waiver waivers wales walled waller wallis wally
    walter walters wanda washed washes weasel while whit whole wicked wicket wickets widen wider
    widow widows wilde wolfe wolff wooded woody woolf word words worked worship wrath writer
    writers""".split()
)
