"""The things that the built-in prior knows, as data: one file a group, one row a thing.

The solids that they are made of are in ``core/prior/things``, for training alone.
"""

from core.guidance.builtin.nouns.aircraft import AIRCRAFT
from core.guidance.builtin.nouns.animals import ANIMALS
from core.guidance.builtin.nouns.arms import ARMS
from core.guidance.builtin.nouns.brood import (
    BROOD,
    LARDER_FOOD,
    LARDER_PLANTS,
    LARDER_VEGETABLES,
    ODDITIES,
)
from core.guidance.builtin.nouns.buildings import BUILDINGS
from core.guidance.builtin.nouns.characters import CHARACTERS
from core.guidance.builtin.nouns.clothes import CLOTHES
from core.guidance.builtin.nouns.curios import (
    CURIO_CLOTHES,
    CURIO_LAMPS,
    CURIO_PROPS,
    CURIO_VEHICLES,
)
from core.guidance.builtin.nouns.devices import DEVICES
from core.guidance.builtin.nouns.equipment import (
    EQUIPMENT_BUILDINGS,
    EQUIPMENT_CLOTHES,
    EQUIPMENT_DEVICES,
    EQUIPMENT_DOLLS,
    EQUIPMENT_FOOD,
    EQUIPMENT_PROPS,
    EQUIPMENT_SMALL,
    EQUIPMENT_TOOLS,
)
from core.guidance.builtin.nouns.everyday import (
    EVERYDAY_CLOTHES,
    EVERYDAY_FOOD,
    EVERYDAY_PLANTS,
    EVERYDAY_RELICS,
    EVERYDAY_THINGS,
)
from core.guidance.builtin.nouns.fare import FARE_FOOD, FARE_FRUIT, FARE_PLANTS
from core.guidance.builtin.nouns.fixtures import FIXTURES
from core.guidance.builtin.nouns.folk import FOLK
from core.guidance.builtin.nouns.food import FOOD
from core.guidance.builtin.nouns.fruit import FRUIT
from core.guidance.builtin.nouns.furniture import FURNITURE
from core.guidance.builtin.nouns.harbour import CIVIC, HARBOUR, HARBOUR_SPACE
from core.guidance.builtin.nouns.haulage import HAULAGE, ROADSIDE_MARKS
from core.guidance.builtin.nouns.household import HOUSEHOLD
from core.guidance.builtin.nouns.instruments import INSTRUMENTS
from core.guidance.builtin.nouns.kitchen import KITCHEN_FOOD, KITCHEN_WARE
from core.guidance.builtin.nouns.leisure import GADGETS, GAMES, RIDES, SHOTS
from core.guidance.builtin.nouns.marked import (
    MARKED_ANIMALS,
    MARKED_CLOTHES,
    MARKED_FLAGS,
    MARKED_FOOD,
    MARKED_HOUSEHOLD,
    MARKED_PROPS,
    MARKED_SIGNS,
    MARKED_SPACE,
    MARKED_SPORT,
    MARKED_VEHICLES,
)
from core.guidance.builtin.nouns.menagerie import MENAGERIE
from core.guidance.builtin.nouns.noun import Noun
from core.guidance.builtin.nouns.novel import (
    NOVEL_ANIMALS,
    NOVEL_CLOCKS,
    NOVEL_HOMES,
    NOVEL_INSTRUMENTS,
    NOVEL_SMALL,
)
from core.guidance.builtin.nouns.novelties import (
    NOVELTY_ANIMALS,
    NOVELTY_ARMS,
    NOVELTY_CLOTHES,
    NOVELTY_TOYS,
)
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.nouns.outfit import (
    OUTFIT_ARMS,
    OUTFIT_PROPS,
    OUTFIT_SPORT,
    WORKSHOP_DEVICES,
    WORKSHOP_FURNITURE,
    WORKSHOP_SMALL,
)
from core.guidance.builtin.nouns.parlour import PARLOUR_PLANTS, PARLOUR_THINGS
from core.guidance.builtin.nouns.pastimes import (
    PASTIME_ARMS,
    PASTIME_FEASTS,
    PASTIME_PROPS,
    PASTIME_SPORT,
    PASTIME_TOOLS,
)
from core.guidance.builtin.nouns.people import JEWELLERY, PEOPLE
from core.guidance.builtin.nouns.plants import PLANTS
from core.guidance.builtin.nouns.props import PROPS
from core.guidance.builtin.nouns.residence import RESIDENCE_BUILDINGS, RESIDENCE_FURNITURE
from core.guidance.builtin.nouns.roadside import HARDWARE, MACHINES, PARTS_OF_CARS, ROADSIDE
from core.guidance.builtin.nouns.showpieces import (
    SHOWPIECE_DEVICES,
    SHOWPIECE_FURNITURE,
    SHOWPIECE_HOUSEHOLD,
    SHOWPIECE_PROPS,
)
from core.guidance.builtin.nouns.small_things import SMALL_THINGS
from core.guidance.builtin.nouns.solids import SOLIDS
from core.guidance.builtin.nouns.sport import SPORT
from core.guidance.builtin.nouns.street import STREET
from core.guidance.builtin.nouns.study import STUDY_SMALL, STUDY_SPACE
from core.guidance.builtin.nouns.sundries import (
    SUNDRY_ARMS,
    SUNDRY_MONSTERS,
    SUNDRY_SMALL,
    SUNDRY_WARE,
)
from core.guidance.builtin.nouns.tools_toys import TOOLS_AND_TOYS
from core.guidance.builtin.nouns.travel import (
    TRAVEL_CLOTHES,
    TRAVEL_PROPS,
    TRAVEL_SMALL,
)
from core.guidance.builtin.nouns.tribe import CHILDREN_AND_TROLLS, DINOSAURS, ROOSTERS
from core.guidance.builtin.nouns.vehicles import VEHICLES
from core.guidance.builtin.nouns.wild_animals import WILD_ANIMALS
from core.guidance.builtin.nouns.wildlife import LEGENDS, WILDLIFE

GROUPS: dict[str, dict[str, Noun]] = {  # as a menu shows them
    "Solids": SOLIDS,
    "Furniture": FURNITURE | RESIDENCE_FURNITURE | SHOWPIECE_FURNITURE | WORKSHOP_FURNITURE,
    "Household": HOUSEHOLD
    | KITCHEN_WARE
    | PARLOUR_THINGS
    | NOVEL_CLOCKS
    | CURIO_LAMPS
    | SHOWPIECE_HOUSEHOLD
    | MARKED_HOUSEHOLD
    | SUNDRY_WARE,
    "Fixtures and Utensils": FIXTURES,
    "Small Things": SMALL_THINGS
    | EVERYDAY_THINGS
    | EQUIPMENT_SMALL
    | NOVEL_SMALL
    | STUDY_SMALL
    | TRAVEL_SMALL
    | SUNDRY_SMALL
    | WORKSHOP_SMALL,
    "Props": PROPS
    | HARDWARE
    | EQUIPMENT_PROPS
    | PASTIME_PROPS
    | PASTIME_FEASTS
    | CURIO_PROPS
    | SHOWPIECE_PROPS
    | TRAVEL_PROPS
    | MARKED_PROPS
    | OUTFIT_PROPS,
    "Flags and Signs": MARKED_FLAGS | MARKED_SIGNS,
    "Arms and Fantasy": ARMS
    | SHOTS
    | EVERYDAY_RELICS
    | NOVELTY_ARMS
    | PASTIME_ARMS
    | SUNDRY_ARMS
    | OUTFIT_ARMS,
    "Food": FOOD
    | EVERYDAY_FOOD
    | KITCHEN_FOOD
    | EQUIPMENT_FOOD
    | MARKED_FOOD
    | FARE_FOOD
    | LARDER_FOOD,
    "Fruit and Vegetables": FRUIT | FARE_FRUIT | LARDER_VEGETABLES,
    "Plants": PLANTS | EVERYDAY_PLANTS | PARLOUR_PLANTS | FARE_PLANTS | LARDER_PLANTS,
    "Characters": CHARACTERS
    | PEOPLE
    | LEGENDS
    | EQUIPMENT_DOLLS
    | SUNDRY_MONSTERS
    | FOLK
    | CHILDREN_AND_TROLLS,
    "Animals": ANIMALS | BROOD | ROOSTERS,
    "Wild Animals": WILD_ANIMALS
    | WILDLIFE
    | NOVELTY_ANIMALS
    | NOVEL_ANIMALS
    | MARKED_ANIMALS
    | MENAGERIE
    | DINOSAURS
    | ODDITIES,
    "Vehicles": VEHICLES
    | RIDES
    | PARTS_OF_CARS
    | HAULAGE
    | CURIO_VEHICLES
    | MARKED_VEHICLES
    | HARBOUR,
    "Aircraft and Space": AIRCRAFT | STUDY_SPACE | MARKED_SPACE | HARBOUR_SPACE,
    "Buildings": BUILDINGS
    | STREET
    | ROADSIDE
    | EQUIPMENT_BUILDINGS
    | ROADSIDE_MARKS
    | NOVEL_HOMES
    | RESIDENCE_BUILDINGS
    | CIVIC,
    "Electronics": DEVICES
    | GADGETS
    | MACHINES
    | EQUIPMENT_DEVICES
    | SHOWPIECE_DEVICES
    | WORKSHOP_DEVICES,
    "Clothes": CLOTHES
    | JEWELLERY
    | EVERYDAY_CLOTHES
    | NOVELTY_CLOTHES
    | EQUIPMENT_CLOTHES
    | CURIO_CLOTHES
    | TRAVEL_CLOTHES
    | MARKED_CLOTHES,
    "Sport": SPORT | GAMES | PASTIME_SPORT | MARKED_SPORT | OUTFIT_SPORT,
    "Tools and Toys": TOOLS_AND_TOYS | NOVELTY_TOYS | EQUIPMENT_TOOLS,
    "Instruments": INSTRUMENTS | PASTIME_TOOLS | NOVEL_INSTRUMENTS,
}
_ALL = {noun: row for group in GROUPS.values() for noun, row in group.items()}
# The networks' rows; then what is another thing's solid.
NOUNS: dict[str, Noun] = {noun: _ALL[noun] for noun in ORDER}
NOUNS |= {noun: row for noun, row in _ALL.items() if row.solid}
# The names of all parts; those of a new noun that are new come last.
PART_NAMES = tuple(dict.fromkeys(part for noun in NOUNS.values() for part in noun.looks))


def solid_of(noun: str) -> str:
    """The thing whose solid the noun is, and whose rows the networks have: mostly itself."""
    return (NOUNS[noun].solid if noun in NOUNS else "") or noun
