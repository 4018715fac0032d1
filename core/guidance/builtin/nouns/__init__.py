"""The things that the built-in prior knows, as data: a file a theme, a row a thing.

The solids that they are made of are in ``core/prior/things``, for training alone.
"""

from core.guidance.builtin.nouns.adventure_props import ADVENTURE_PROPS
from core.guidance.builtin.nouns.aircraft_and_space import AIRCRAFT_AND_SPACE
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.nouns.birds import BIRDS
from core.guidance.builtin.nouns.boats_and_ships import BOATS_AND_SHIPS
from core.guidance.builtin.nouns.bread_and_sweets import BREAD_AND_SWEETS
from core.guidance.builtin.nouns.built_charms_and_games import BUILT_CHARMS_AND_GAMES
from core.guidance.builtin.nouns.built_desk_and_workshop import BUILT_DESK_AND_WORKSHOP
from core.guidance.builtin.nouns.cars import CARS
from core.guidance.builtin.nouns.clothes_and_shoes import CLOTHES_AND_SHOES
from core.guidance.builtin.nouns.common_wild_animals import COMMON_WILD_ANIMALS
from core.guidance.builtin.nouns.computers_and_game_machines import COMPUTERS_AND_GAME_MACHINES
from core.guidance.builtin.nouns.cooking_and_bath import COOKING_AND_BATH
from core.guidance.builtin.nouns.crates_and_drums import CRATES_AND_DRUMS
from core.guidance.builtin.nouns.dinosaurs_and_mythical_beasts import DINOSAURS_AND_MYTHICAL_BEASTS
from core.guidance.builtin.nouns.dishes_and_groceries import DISHES_AND_GROCERIES
from core.guidance.builtin.nouns.doors_and_bathroom import DOORS_AND_BATHROOM
from core.guidance.builtin.nouns.electric_machines import ELECTRIC_MACHINES
from core.guidance.builtin.nouns.engines_of_war import ENGINES_OF_WAR
from core.guidance.builtin.nouns.fairy_tale_folk import FAIRY_TALE_FOLK
from core.guidance.builtin.nouns.farm_animals_and_pets import FARM_ANIMALS_AND_PETS
from core.guidance.builtin.nouns.figures import FIGURES
from core.guidance.builtin.nouns.fixtures_and_utensils import FIXTURES_AND_UTENSILS
from core.guidance.builtin.nouns.flags_and_signs import FLAGS_AND_SIGNS
from core.guidance.builtin.nouns.fruit_and_vegetables import FRUIT_AND_VEGETABLES
from core.guidance.builtin.nouns.garden_and_leisure import GARDEN_AND_LEISURE
from core.guidance.builtin.nouns.gifts_and_decorations import GIFTS_AND_DECORATIONS
from core.guidance.builtin.nouns.hand_tools import HAND_TOOLS
from core.guidance.builtin.nouns.hats_bags_and_jewellery import HATS_BAGS_AND_JEWELLERY
from core.guidance.builtin.nouns.houses import HOUSES
from core.guidance.builtin.nouns.instruments import INSTRUMENTS
from core.guidance.builtin.nouns.kitchen import KITCHEN
from core.guidance.builtin.nouns.laboratory_and_workshop import LABORATORY_AND_WORKSHOP
from core.guidance.builtin.nouns.lamps_clocks_and_ornaments import LAMPS_CLOCKS_AND_ORNAMENTS
from core.guidance.builtin.nouns.landmarks import LANDMARKS
from core.guidance.builtin.nouns.mammals import MAMMALS
from core.guidance.builtin.nouns.monsters import MONSTERS
from core.guidance.builtin.nouns.monuments import MONUMENTS
from core.guidance.builtin.nouns.noun import Noun
from core.guidance.builtin.nouns.odd_vehicles_and_games import ODD_VEHICLES_AND_GAMES
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.nouns.people import PEOPLE
from core.guidance.builtin.nouns.phones_cameras_and_audio import PHONES_CAMERAS_AND_AUDIO
from core.guidance.builtin.nouns.plants import PLANTS
from core.guidance.builtin.nouns.printed_things import PRINTED_THINGS
from core.guidance.builtin.nouns.relics_and_nature import RELICS_AND_NATURE
from core.guidance.builtin.nouns.reptiles_and_insects import REPTILES_AND_INSECTS
from core.guidance.builtin.nouns.road_and_yard import ROAD_AND_YARD
from core.guidance.builtin.nouns.school_and_laboratory import SCHOOL_AND_LABORATORY
from core.guidance.builtin.nouns.sea_animals import SEA_ANIMALS
from core.guidance.builtin.nouns.seats_and_beds import SEATS_AND_BEDS
from core.guidance.builtin.nouns.sights import SIGHTS
from core.guidance.builtin.nouns.solids import SOLIDS
from core.guidance.builtin.nouns.sound_and_hardware import SOUND_AND_HARDWARE
from core.guidance.builtin.nouns.sport import SPORT
from core.guidance.builtin.nouns.stage_and_studio import STAGE_AND_STUDIO
from core.guidance.builtin.nouns.statues_and_body_parts import STATUES_AND_BODY_PARTS
from core.guidance.builtin.nouns.street_and_playground import STREET_AND_PLAYGROUND
from core.guidance.builtin.nouns.tables_cabinets_and_lamps import TABLES_CABINETS_AND_LAMPS
from core.guidance.builtin.nouns.tableware_and_textiles import TABLEWARE_AND_TEXTILES
from core.guidance.builtin.nouns.tools_and_care import TOOLS_AND_CARE
from core.guidance.builtin.nouns.toys_and_games import TOYS_AND_GAMES
from core.guidance.builtin.nouns.trains_cycles_and_carts import TRAINS_CYCLES_AND_CARTS
from core.guidance.builtin.nouns.trucks_buses_and_tractors import TRUCKS_BUSES_AND_TRACTORS
from core.guidance.builtin.nouns.weapons import WEAPONS

GROUPS: dict[str, dict[str, Noun]] = {  # as a menu shows them
    "Solids": SOLIDS,
    "Furniture": SEATS_AND_BEDS | TABLES_CABINETS_AND_LAMPS,
    "Household": KITCHEN | DOORS_AND_BATHROOM | LAMPS_CLOCKS_AND_ORNAMENTS,
    "Fixtures and Utensils": FIXTURES_AND_UTENSILS,
    "Small Things": TABLEWARE_AND_TEXTILES
    | SCHOOL_AND_LABORATORY
    | SOUND_AND_HARDWARE
    | BUILT_DESK_AND_WORKSHOP,
    "Props": ADVENTURE_PROPS | CRATES_AND_DRUMS | ROAD_AND_YARD | GIFTS_AND_DECORATIONS,
    "Flags and Signs": FLAGS_AND_SIGNS | PRINTED_THINGS,
    "Arms and Fantasy": WEAPONS | RELICS_AND_NATURE | BUILT_CHARMS_AND_GAMES,
    "Food": DISHES_AND_GROCERIES | BREAD_AND_SWEETS,
    "Fruit and Vegetables": FRUIT_AND_VEGETABLES,
    "Plants": PLANTS,
    "Characters": PEOPLE | FAIRY_TALE_FOLK | MONSTERS | STATUES_AND_BODY_PARTS,
    "Animals": FARM_ANIMALS_AND_PETS | COMMON_WILD_ANIMALS | FIGURES,
    "Wild Animals": SEA_ANIMALS
    | MAMMALS
    | BIRDS
    | REPTILES_AND_INSECTS
    | DINOSAURS_AND_MYTHICAL_BEASTS,
    "Vehicles": TRUCKS_BUSES_AND_TRACTORS | CARS | BOATS_AND_SHIPS | TRAINS_CYCLES_AND_CARTS,
    "Aircraft and Space": AIRCRAFT_AND_SPACE,
    "Buildings": HOUSES | LANDMARKS | STREET_AND_PLAYGROUND | SIGHTS,
    "Electronics": COMPUTERS_AND_GAME_MACHINES | PHONES_CAMERAS_AND_AUDIO | ELECTRIC_MACHINES,
    "Clothes": CLOTHES_AND_SHOES | HATS_BAGS_AND_JEWELLERY | APPENDAGES,
    "Sport": SPORT,
    "Tools and Toys": HAND_TOOLS | TOYS_AND_GAMES,
    "Instruments": INSTRUMENTS,
    "House and Garden": COOKING_AND_BATH | GARDEN_AND_LEISURE | TOOLS_AND_CARE,
    "Workshop and Studio": LABORATORY_AND_WORKSHOP | STAGE_AND_STUDIO,
    "Monuments and Machines": MONUMENTS | ENGINES_OF_WAR | ODD_VEHICLES_AND_GAMES,
}
_ALL = {noun: row for group in GROUPS.values() for noun, row in group.items()}
# The networks' rows; then what is another thing's solid, and what no network draws.
NOUNS: dict[str, Noun] = {noun: _ALL[noun] for noun in ORDER}
NOUNS |= {noun: row for noun, row in _ALL.items() if row.solid}
CONSTRUCTED: dict[str, Noun] = {noun: row for noun, row in _ALL.items() if row.constructed}
NOUNS |= CONSTRUCTED
# The names of all parts; those of a new noun that are new come last.
PART_NAMES = tuple(dict.fromkeys(part for noun in NOUNS.values() for part in noun.looks))


def solid_of(noun: str) -> str:
    """The thing whose solid the noun is, and whose rows the networks have: mostly itself."""
    return (NOUNS[noun].solid if noun in NOUNS else "") or noun


def row_of(noun: str) -> str:
    """The thing whose rows the networks have; "" where they have none."""
    return "" if noun in CONSTRUCTED and solid_of(noun) not in ORDER else solid_of(noun)
