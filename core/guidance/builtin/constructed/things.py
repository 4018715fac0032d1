"""All constructed things by noun, and one of them."""

from collections.abc import Callable

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts, of_training_size
from core.guidance.builtin.constructed.solid import ConstructedSolid, solid_of_parts
from core.guidance.builtin.constructed.themes.aircraft_and_motorcycle import AIRCRAFT_AND_MOTORCYCLE
from core.guidance.builtin.constructed.themes.arms import ARMS
from core.guidance.builtin.constructed.themes.bath import BATH
from core.guidance.builtin.constructed.themes.boats_and_cabins import BOATS_AND_CABINS
from core.guidance.builtin.constructed.themes.brass import BRASS
from core.guidance.builtin.constructed.themes.bridges_and_structures import BRIDGES_AND_STRUCTURES
from core.guidance.builtin.constructed.themes.buildings import BUILDINGS
from core.guidance.builtin.constructed.themes.carts_and_cannons import CARTS_AND_CANNONS
from core.guidance.builtin.constructed.themes.cats import CATS
from core.guidance.builtin.constructed.themes.cattle import CATTLE
from core.guidance.builtin.constructed.themes.charms_and_games import CHARMS_AND_GAMES
from core.guidance.builtin.constructed.themes.cooking import COOKING
from core.guidance.builtin.constructed.themes.desk_and_workshop import DESK_AND_WORKSHOP
from core.guidance.builtin.constructed.themes.desk_machines import DESK_MACHINES
from core.guidance.builtin.constructed.themes.desk_tools import DESK_TOOLS
from core.guidance.builtin.constructed.themes.dinosaurs import DINOSAURS
from core.guidance.builtin.constructed.themes.dogs import DOGS
from core.guidance.builtin.constructed.themes.engines_of_war import ENGINES_OF_WAR
from core.guidance.builtin.constructed.themes.fair import FAIR
from core.guidance.builtin.constructed.themes.fasteners import FASTENERS
from core.guidance.builtin.constructed.themes.film import FILM
from core.guidance.builtin.constructed.themes.games_hall import GAMES_HALL
from core.guidance.builtin.constructed.themes.garden import GARDEN
from core.guidance.builtin.constructed.themes.guitars import GUITARS
from core.guidance.builtin.constructed.themes.gymnasium import GYMNASIUM
from core.guidance.builtin.constructed.themes.heavy_beasts import HEAVY_BEASTS
from core.guidance.builtin.constructed.themes.horses import HORSES
from core.guidance.builtin.constructed.themes.household import HOUSEHOLD
from core.guidance.builtin.constructed.themes.kitchen_tools import KITCHEN_TOOLS
from core.guidance.builtin.constructed.themes.laboratory import LABORATORY
from core.guidance.builtin.constructed.themes.large_ships import LARGE_SHIPS
from core.guidance.builtin.constructed.themes.long_necks import LONG_NECKS
from core.guidance.builtin.constructed.themes.missiles import MISSILES
from core.guidance.builtin.constructed.themes.monuments import MONUMENTS
from core.guidance.builtin.constructed.themes.monuments_of_stone import MONUMENTS_OF_STONE
from core.guidance.builtin.constructed.themes.music import MUSIC
from core.guidance.builtin.constructed.themes.mythical_beasts import MYTHICAL_BEASTS
from core.guidance.builtin.constructed.themes.ninja_and_ropes import NINJA_AND_ROPES
from core.guidance.builtin.constructed.themes.old_crafts import OLD_CRAFTS
from core.guidance.builtin.constructed.themes.one_wheel_and_more import ONE_WHEEL_AND_MORE
from core.guidance.builtin.constructed.themes.paint_and_wood import PAINT_AND_WOOD
from core.guidance.builtin.constructed.themes.pets_and_terrace import PETS_AND_TERRACE
from core.guidance.builtin.constructed.themes.playgrounds import PLAYGROUNDS
from core.guidance.builtin.constructed.themes.rails_and_roads import RAILS_AND_ROADS
from core.guidance.builtin.constructed.themes.redrawn import REDRAWN
from core.guidance.builtin.constructed.themes.sailboat_and_excavator import SAILBOAT_AND_EXCAVATOR
from core.guidance.builtin.constructed.themes.sea_animals import SEA_ANIMALS
from core.guidance.builtin.constructed.themes.sewing import SEWING
from core.guidance.builtin.constructed.themes.ships import SHIPS
from core.guidance.builtin.constructed.themes.siege import SIEGE
from core.guidance.builtin.constructed.themes.sights import SIGHTS
from core.guidance.builtin.constructed.themes.smoking import SMOKING
from core.guidance.builtin.constructed.themes.spacecraft import SPACECRAFT
from core.guidance.builtin.constructed.themes.stage import STAGE
from core.guidance.builtin.constructed.themes.structures import STRUCTURES
from core.guidance.builtin.constructed.themes.theropods import THEROPODS
from core.guidance.builtin.constructed.themes.tools_and_care import TOOLS_AND_CARE
from core.guidance.builtin.constructed.themes.towers_and_flight import TOWERS_AND_FLIGHT
from core.guidance.builtin.constructed.themes.treehouse_and_tank import TREEHOUSE_AND_TANK
from core.guidance.builtin.constructed.themes.workshop import WORKSHOP
from core.guidance.builtin.solid_net import SolidNet
from core.guidance.builtin.words.phrases.slots import Words

THINGS: dict[str, Callable[[Draw], Parts]] = {
    **BATH,
    **HOUSEHOLD,
    **CHARMS_AND_GAMES,
    **COOKING,
    **KITCHEN_TOOLS,
    **DESK_AND_WORKSHOP,
    **DESK_TOOLS,
    **SIEGE,
    **ENGINES_OF_WAR,
    **PLAYGROUNDS,
    **GARDEN,
    **OLD_CRAFTS,
    **NINJA_AND_ROPES,
    **GYMNASIUM,
    **GAMES_HALL,
    **LABORATORY,
    **MONUMENTS,
    **MONUMENTS_OF_STONE,
    **BRIDGES_AND_STRUCTURES,
    **STRUCTURES,
    **ONE_WHEEL_AND_MORE,
    **BOATS_AND_CABINS,
    **SPACECRAFT,
    **MISSILES,
    **PETS_AND_TERRACE,
    **SMOKING,
    **REDRAWN,
    **ARMS,
    **BRASS,
    **BUILDINGS,
    **RAILS_AND_ROADS,
    **TOOLS_AND_CARE,
    **PAINT_AND_WOOD,
    **TREEHOUSE_AND_TANK,
    **GUITARS,
    **DESK_MACHINES,
    **SHIPS,
    **CARTS_AND_CANNONS,
    **AIRCRAFT_AND_MOTORCYCLE,
    **MUSIC,
    **SEWING,
    **SIGHTS,
    **FILM,
    **TOWERS_AND_FLIGHT,
    **FAIR,
    **LARGE_SHIPS,
    **SAILBOAT_AND_EXCAVATOR,
    **STAGE,
    **WORKSHOP,
    **FASTENERS,
    **SEA_ANIMALS,
    **DINOSAURS,
    **THEROPODS,
    **MYTHICAL_BEASTS,
    **HEAVY_BEASTS,
    **LONG_NECKS,
    **CATTLE,
    **CATS,
    **DOGS,
    **HORSES,
}


def constructed(words: Words, net: SolidNet, seed: int) -> ConstructedSolid:
    """An object of the noun, without its absent parts."""
    return solid_of_parts(words, net, of_training_size(THINGS[words.noun](Draw(seed))))
