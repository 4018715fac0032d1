"""Costumes: what pirates, chefs and farmers wear or hold.

Standard library only.
"""

# Visible signs of a role, by its names.
_COSTUMES = {
    "pirate, pirate captain": "wearing a pirate hat",
    "witch, sorceress": "wearing a black wizard hat and a black cape",
    "wizard, magician, sorcerer, mage, alchemist": "wearing a blue wizard hat and a blue cape",
    "king, emperor, pharaoh": "wearing a golden crown and a red cape",
    "queen, princess": "wearing a golden crown and a pink dress",
    "prince": "wearing a golden crown and a blue cape",
    "knight, medieval knight, paladin": "wearing a helmet and a chestplate",
    "viking, barbarian": "wearing a viking helmet and holding an axe",
    "samurai, gladiator, roman soldier, guard": "wearing a helmet and a chestplate",
    "warrior, soldier": "wearing a helmet and holding a sword",
    "ninja": "wearing a black scarf and holding a katana",
    "archer, ranger": "wearing a quiver and holding a bow",
    "cowboy, cowgirl, sheriff": "wearing a cowboy hat and a brown leather jacket",
    "santa, santa claus, father christmas, christmas": "wearing a santa hat and a red coat",
    "superhero, superman, super hero, supergirl, hero": "wearing a red cape",
    "batman, vampire, dracula": "wearing a black cape",
    "astronaut, spaceman, cosmonaut": "wearing a white jacket and a jetpack",
    "firefighter, fireman": "wearing a yellow jacket and holding an axe",
    "police officer, policeman, police, cop": "wearing a navy baseball cap and a navy shirt",
    "doctor, nurse, scientist": "wearing a lab coat",
    "chef, cook, baker": "wearing a chef hat and a white shirt",
    "butcher": "wearing a white shirt and holding a knife",
    "ballerina": "wearing a pink tutu",
    "cheerleader": "wearing a red dress",
    "plague doctor": "wearing a black hat and a black cape",
    "dentist, surgeon": "wearing a lab coat",
    "racer, racing driver, biker, motorcyclist": "wearing a motorcycle helmet and a red jacket",
    "businessman, spy, secret agent, groom, gentleman, james bond, bartender, waiter, butler": (
        "wearing a black suit and a necktie"
    ),
    "lawyer": "wearing a black suit and holding a briefcase",
    "judge, priest, nun, cleric": "wearing a black dress",
    "bride": "wearing a white dress and holding a rose",
    "detective": "wearing a trench coat and a hat",
    "captain, pilot": "wearing a navy baseball cap and a navy jacket",
    "sailor": "wearing a white shirt",
    "diver, scuba diver": "wearing goggles",
    "explorer, adventurer, safari": "wearing a backpack and a cowboy hat",
    "hiker, tourist, student": "wearing a backpack",
    "merchant, trader": "wearing a backpack and holding a lantern",
    "farmer, peasant, villager": "wearing a cowboy hat and holding a rake",
    "shepherd": "wearing a brown cape and holding a staff",
    "gardener": "wearing a cowboy hat and holding a shovel",
    "fisherman": "wearing a yellow coat and holding a fishing rod",
    "lumberjack": "wearing a red beanie and holding an axe",
    "hunter": "wearing a brown jacket and holding a rifle",
    "miner": "wearing a hard hat and holding a pickaxe",
    "worker, construction worker, builder": "wearing a hard hat and holding a hammer",
    "engineer, electrician": "wearing a hard hat and holding a wrench",
    "plumber, mechanic": "wearing a red baseball cap and holding a wrench",
    "carpenter": "holding a saw",
    "blacksmith": "holding a hammer",
    "janitor": "holding a broom",
    "teacher, librarian": "holding a book",
    "mailman, postman": "wearing a blue baseball cap and holding an envelope",
    "painter, artist": "wearing a black beanie and holding a paintbrush",
    "photographer": "holding a camera",
    "singer": "holding a microphone",
    "guitarist, musician": "holding a guitar",
    "rockstar, rock star, punk rocker, rocker": (
        "wearing sunglasses and holding an electric guitar"
    ),
    "bard": "holding a guitar",
    "surfer": "holding a surfboard",
    "skater, skateboarder": "riding a skateboard",
    "cyclist": "riding a bicycle",
    "golfer": "holding a golf club",
    "barista": "holding a mug",
    "dj, gamer": "wearing headphones",
    "basketball player": "holding a basketball",
    "soccer player, footballer, goalkeeper": "holding a soccer ball",
    "baseball player": "wearing a baseball cap and holding a baseball bat",
    "bandit, robber": "wearing a black beanie and holding a sack",
    "healer": "wearing a white dress",
}


def _each(worn: str) -> tuple[str, ...]:
    """Worn and held things, one by one, each with its verb."""
    verb, _, rest = worn.partition(" ")
    items = rest.split(" and ")
    return tuple(one if one.startswith("holding") else f"{verb} {one}" for one in items)


ROLES = {name: _each(worn) for names, worn in _COSTUMES.items() for name in names.split(", ")}
# These are also kinds of animals: a soldier ant, a nurse shark, a queen bee.
OF_KINDS = frozenset(
    """soldier worker king queen emperor carpenter pilot archer nurse doctor surgeon vampire sailor
    captain hunter miner farmer painter""".split()
)
KINDS = frozenset(
    """ant bee beetle butterfly caterpillar dragonfly ladybug spider scorpion fish clownfish koi
    pufferfish whale orca shark crab lobster octopus bat penguin snake stingray seahorse""".split()
)
# Roles related to the word before: a sushi chef, an apple farmer, a bear hunter.
MAKERS = frozenset(
    """farmer hunter gardener merchant trader baker cook chef butcher surgeon fisherman""".split()
)
HUNTERS = frozenset(("farmer", "hunter", "trader"))  # of animals; a goblin hunter is a goblin
