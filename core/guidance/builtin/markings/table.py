"""The markings of all things (:mod:`core.guidance.builtin.markings.markings`)."""

from core.guidance.builtin.markings.marking import Rows
from core.guidance.builtin.markings.rows.aircraft_and_space import AIRCRAFT_AND_SPACE
from core.guidance.builtin.markings.rows.animals import ANIMALS
from core.guidance.builtin.markings.rows.buildings import BUILDINGS
from core.guidance.builtin.markings.rows.characters import CHARACTERS
from core.guidance.builtin.markings.rows.clothes import CLOTHES
from core.guidance.builtin.markings.rows.crates_and_drums import CRATES_AND_DRUMS
from core.guidance.builtin.markings.rows.electronics import ELECTRONICS
from core.guidance.builtin.markings.rows.flags_and_signs import FLAGS_AND_SIGNS
from core.guidance.builtin.markings.rows.food_and_plants import FOOD_AND_PLANTS
from core.guidance.builtin.markings.rows.furniture import FURNITURE
from core.guidance.builtin.markings.rows.household import HOUSEHOLD
from core.guidance.builtin.markings.rows.printed_things import PRINTED_THINGS
from core.guidance.builtin.markings.rows.props_and_arms import PROPS_AND_ARMS
from core.guidance.builtin.markings.rows.sport import SPORT
from core.guidance.builtin.markings.rows.tools_toys_and_instruments import (
    TOOLS_TOYS_AND_INSTRUMENTS,
)
from core.guidance.builtin.markings.rows.vehicles import VEHICLES

MARKINGS: Rows = (
    FURNITURE
    | HOUSEHOLD
    | PROPS_AND_ARMS
    | CRATES_AND_DRUMS
    | FLAGS_AND_SIGNS
    | PRINTED_THINGS
    | FOOD_AND_PLANTS
    | CHARACTERS
    | ANIMALS
    | VEHICLES
    | AIRCRAFT_AND_SPACE
    | BUILDINGS
    | ELECTRONICS
    | CLOTHES
    | SPORT
    | TOOLS_TOYS_AND_INSTRUMENTS
)
