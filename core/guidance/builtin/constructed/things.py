"""All constructed things by noun, and one of them."""

from collections.abc import Callable

from core.guidance.builtin.constructed.bath_and_household import BATH_AND_HOUSEHOLD
from core.guidance.builtin.constructed.charms_and_games import CHARMS_AND_GAMES
from core.guidance.builtin.constructed.cooking import COOKING
from core.guidance.builtin.constructed.desk_and_workshop import DESK_AND_WORKSHOP
from core.guidance.builtin.constructed.desk_tools import DESK_TOOLS
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.engines_of_war import ENGINES_OF_WAR
from core.guidance.builtin.constructed.garden_and_leisure import GARDEN_AND_LEISURE
from core.guidance.builtin.constructed.gym_and_crafts import GYM_AND_CRAFTS
from core.guidance.builtin.constructed.laboratory import LABORATORY
from core.guidance.builtin.constructed.monuments import MONUMENTS
from core.guidance.builtin.constructed.odd_vehicles import ODD_VEHICLES
from core.guidance.builtin.constructed.pets_and_smoking import PETS_AND_SMOKING
from core.guidance.builtin.constructed.redrawn import REDRAWN
from core.guidance.builtin.constructed.redrawn_arms import REDRAWN_ARMS
from core.guidance.builtin.constructed.redrawn_buildings import REDRAWN_BUILDINGS
from core.guidance.builtin.constructed.redrawn_rails_and_roads import REDRAWN_RAILS_AND_ROADS
from core.guidance.builtin.constructed.redrawn_studio import REDRAWN_STUDIO
from core.guidance.builtin.constructed.redrawn_vehicles import REDRAWN_VEHICLES
from core.guidance.builtin.constructed.sewing_and_music import SEWING_AND_MUSIC
from core.guidance.builtin.constructed.shapes import Parts, of_training_size
from core.guidance.builtin.constructed.sights import SIGHTS
from core.guidance.builtin.constructed.solid import ConstructedSolid, solid_of_parts
from core.guidance.builtin.constructed.stage import STAGE
from core.guidance.builtin.constructed.workshop import WORKSHOP
from core.guidance.builtin.solid_net import SolidNet
from core.guidance.builtin.words.phrases.slots import Words

THINGS: dict[str, Callable[[Draw], Parts]] = {
    **REDRAWN,
    **REDRAWN_BUILDINGS,
    **REDRAWN_STUDIO,
    **REDRAWN_RAILS_AND_ROADS,
    **REDRAWN_ARMS,
    **REDRAWN_VEHICLES,
    **SIGHTS,
    **DESK_AND_WORKSHOP,
    **CHARMS_AND_GAMES,
    **COOKING,
    **BATH_AND_HOUSEHOLD,
    **GARDEN_AND_LEISURE,
    **PETS_AND_SMOKING,
    **LABORATORY,
    **DESK_TOOLS,
    **WORKSHOP,
    **STAGE,
    **ODD_VEHICLES,
    **GYM_AND_CRAFTS,
    **SEWING_AND_MUSIC,
    **MONUMENTS,
    **ENGINES_OF_WAR,
}


def constructed(words: Words, net: SolidNet, seed: int) -> ConstructedSolid:
    """An object of the noun, without its absent parts."""
    return solid_of_parts(words, net, of_training_size(THINGS[words.noun](Draw(seed))))
