"""The families: for each noun a function that builds the solids of a random object.

A family is in the file that is named like its noun's theme in ``core/guidance/builtin/nouns``, or,
where that theme is split in two or three, in one of the files that are named like its parts.
Helpers that several themes use are in ``shared``.

Front is -Y, up is +Z. Everything that a picture of 64² must show is at least about 4 pixels wide:
legs, handles and walls are thicker than in reality. The units are arbitrary;
``families.normalised`` scales. A family's solid is within ±1.6 along x and y, and within z from
-1.6 to 3.2.
"""

from core.prior.things.adventure_props_arms_and_magic import ADVENTURE_PROPS_ARMS_AND_MAGIC
from core.prior.things.adventure_props_treasure import ADVENTURE_PROPS_TREASURE
from core.prior.things.aircraft_and_space import AIRCRAFT_AND_SPACE
from core.prior.things.bags_jewellery_and_glasses import BAGS_JEWELLERY_AND_GLASSES
from core.prior.things.beds import BEDS
from core.prior.things.birds import BIRDS
from core.prior.things.boats import BOATS
from core.prior.things.bread_and_cakes import BREAD_AND_CAKES
from core.prior.things.cabinets import CABINETS
from core.prior.things.cars import CARS
from core.prior.things.clothes import CLOTHES
from core.prior.things.common_wild_animals_land import COMMON_WILD_ANIMALS_LAND
from core.prior.things.common_wild_animals_sea_and_air import COMMON_WILD_ANIMALS_SEA_AND_AIR
from core.prior.things.computers_and_office_machines import COMPUTERS_AND_OFFICE_MACHINES
from core.prior.things.cycles_and_sleds import CYCLES_AND_SLEDS
from core.prior.things.dinosaurs_and_mythical_beasts import DINOSAURS_AND_MYTHICAL_BEASTS
from core.prior.things.dishes import DISHES
from core.prior.things.doors_and_bathroom import DOORS_AND_BATHROOM
from core.prior.things.electric_machines import ELECTRIC_MACHINES
from core.prior.things.fairy_tale_folk_gnomes_and_puppets import FAIRY_TALE_FOLK_GNOMES_AND_PUPPETS
from core.prior.things.fairy_tale_folk_magic import FAIRY_TALE_FOLK_MAGIC
from core.prior.things.farm_animals import FARM_ANIMALS
from core.prior.things.figures import FIGURES
from core.prior.things.fixtures import FIXTURES
from core.prior.things.fruit import FRUIT
from core.prior.things.game_and_cash_machines import GAME_AND_CASH_MACHINES
from core.prior.things.games import GAMES
from core.prior.things.gifts_and_decorations import GIFTS_AND_DECORATIONS
from core.prior.things.groceries import GROCERIES
from core.prior.things.hand_tools_household_and_optical import HAND_TOOLS_HOUSEHOLD_AND_OPTICAL
from core.prior.things.hand_tools_workshop import HAND_TOOLS_WORKSHOP
from core.prior.things.hats import HATS
from core.prior.things.houses_to_live_in import HOUSES_TO_LIVE_IN
from core.prior.things.houses_to_work_in import HOUSES_TO_WORK_IN
from core.prior.things.instruments_wind_and_percussion import INSTRUMENTS_WIND_AND_PERCUSSION
from core.prior.things.instruments_with_strings import INSTRUMENTS_WITH_STRINGS
from core.prior.things.kitchen import KITCHEN
from core.prior.things.laboratory import LABORATORY
from core.prior.things.lamps_and_clocks import LAMPS_AND_CLOCKS
from core.prior.things.landmarks_buildings import LANDMARKS_BUILDINGS
from core.prior.things.landmarks_nature import LANDMARKS_NATURE
from core.prior.things.landmarks_structures import LANDMARKS_STRUCTURES
from core.prior.things.mammals_cats_dogs_and_bears import MAMMALS_CATS_DOGS_AND_BEARS
from core.prior.things.mammals_rodents_and_climbers import MAMMALS_RODENTS_AND_CLIMBERS
from core.prior.things.mammals_with_hooves import MAMMALS_WITH_HOOVES
from core.prior.things.monsters_beasts import MONSTERS_BEASTS
from core.prior.things.monsters_goblins_and_giants import MONSTERS_GOBLINS_AND_GIANTS
from core.prior.things.monsters_undead import MONSTERS_UNDEAD
from core.prior.things.nature import NATURE
from core.prior.things.ornaments import ORNAMENTS
from core.prior.things.people_children import PEOPLE_CHILDREN
from core.prior.things.people_fighters import PEOPLE_FIGHTERS
from core.prior.things.people_ranks_and_trades import PEOPLE_RANKS_AND_TRADES
from core.prior.things.pets import PETS
from core.prior.things.phones_cameras_and_audio import PHONES_CAMERAS_AND_AUDIO
from core.prior.things.plants_flowers_and_vegetables import PLANTS_FLOWERS_AND_VEGETABLES
from core.prior.things.plants_forest_floor_and_shore import PLANTS_FOREST_FLOOR_AND_SHORE
from core.prior.things.plants_trees import PLANTS_TREES
from core.prior.things.playground import PLAYGROUND
from core.prior.things.relics import RELICS
from core.prior.things.reptiles_and_insects import REPTILES_AND_INSECTS
from core.prior.things.road import ROAD
from core.prior.things.school import SCHOOL
from core.prior.things.sea_animals import SEA_ANIMALS
from core.prior.things.seats import SEATS
from core.prior.things.ships import SHIPS
from core.prior.things.shoes import SHOES
from core.prior.things.solids import SOLIDS
from core.prior.things.sound_and_hardware import SOUND_AND_HARDWARE
from core.prior.things.sport_balls_and_games import SPORT_BALLS_AND_GAMES
from core.prior.things.sport_fitness_and_outdoor import SPORT_FITNESS_AND_OUTDOOR
from core.prior.things.statues_and_body_parts import STATUES_AND_BODY_PARTS
from core.prior.things.street_furniture import STREET_FURNITURE
from core.prior.things.street_industry import STREET_INDUSTRY
from core.prior.things.sweets import SWEETS
from core.prior.things.tables_lamps_and_pianos import TABLES_LAMPS_AND_PIANOS
from core.prior.things.tableware import TABLEWARE
from core.prior.things.textiles_and_toiletries import TEXTILES_AND_TOILETRIES
from core.prior.things.toys import TOYS
from core.prior.things.tractors_and_diggers import TRACTORS_AND_DIGGERS
from core.prior.things.trains_and_carts import TRAINS_AND_CARTS
from core.prior.things.trucks_and_buses import TRUCKS_AND_BUSES
from core.prior.things.utensils import UTENSILS
from core.prior.things.vegetables import VEGETABLES
from core.prior.things.weapons_bows_and_catapults import WEAPONS_BOWS_AND_CATAPULTS
from core.prior.things.weapons_guns_and_explosives import WEAPONS_GUNS_AND_EXPLOSIVES
from core.prior.things.weapons_melee_and_armour import WEAPONS_MELEE_AND_ARMOUR
from core.prior.things.yard import YARD

THEMES = (
    ADVENTURE_PROPS_ARMS_AND_MAGIC,
    ADVENTURE_PROPS_TREASURE,
    AIRCRAFT_AND_SPACE,
    BAGS_JEWELLERY_AND_GLASSES,
    BEDS,
    BIRDS,
    BOATS,
    BREAD_AND_CAKES,
    CABINETS,
    CARS,
    CLOTHES,
    COMMON_WILD_ANIMALS_LAND,
    COMMON_WILD_ANIMALS_SEA_AND_AIR,
    COMPUTERS_AND_OFFICE_MACHINES,
    CYCLES_AND_SLEDS,
    DINOSAURS_AND_MYTHICAL_BEASTS,
    DISHES,
    DOORS_AND_BATHROOM,
    ELECTRIC_MACHINES,
    FAIRY_TALE_FOLK_GNOMES_AND_PUPPETS,
    FAIRY_TALE_FOLK_MAGIC,
    FARM_ANIMALS,
    FIGURES,
    FIXTURES,
    FRUIT,
    GAME_AND_CASH_MACHINES,
    GAMES,
    GIFTS_AND_DECORATIONS,
    GROCERIES,
    HAND_TOOLS_HOUSEHOLD_AND_OPTICAL,
    HAND_TOOLS_WORKSHOP,
    HATS,
    HOUSES_TO_LIVE_IN,
    HOUSES_TO_WORK_IN,
    INSTRUMENTS_WIND_AND_PERCUSSION,
    INSTRUMENTS_WITH_STRINGS,
    KITCHEN,
    LABORATORY,
    LAMPS_AND_CLOCKS,
    LANDMARKS_BUILDINGS,
    LANDMARKS_NATURE,
    LANDMARKS_STRUCTURES,
    MAMMALS_CATS_DOGS_AND_BEARS,
    MAMMALS_RODENTS_AND_CLIMBERS,
    MAMMALS_WITH_HOOVES,
    MONSTERS_BEASTS,
    MONSTERS_GOBLINS_AND_GIANTS,
    MONSTERS_UNDEAD,
    NATURE,
    ORNAMENTS,
    PEOPLE_CHILDREN,
    PEOPLE_FIGHTERS,
    PEOPLE_RANKS_AND_TRADES,
    PETS,
    PHONES_CAMERAS_AND_AUDIO,
    PLANTS_FLOWERS_AND_VEGETABLES,
    PLANTS_FOREST_FLOOR_AND_SHORE,
    PLANTS_TREES,
    PLAYGROUND,
    RELICS,
    REPTILES_AND_INSECTS,
    ROAD,
    SCHOOL,
    SEA_ANIMALS,
    SEATS,
    SHIPS,
    SHOES,
    SOLIDS,
    SOUND_AND_HARDWARE,
    SPORT_BALLS_AND_GAMES,
    SPORT_FITNESS_AND_OUTDOOR,
    STATUES_AND_BODY_PARTS,
    STREET_FURNITURE,
    STREET_INDUSTRY,
    SWEETS,
    TABLES_LAMPS_AND_PIANOS,
    TABLEWARE,
    TEXTILES_AND_TOILETRIES,
    TOYS,
    TRACTORS_AND_DIGGERS,
    TRAINS_AND_CARTS,
    TRUCKS_AND_BUSES,
    UTENSILS,
    VEGETABLES,
    WEAPONS_BOWS_AND_CATAPULTS,
    WEAPONS_GUNS_AND_EXPLOSIVES,
    WEAPONS_MELEE_AND_ARMOUR,
    YARD,
)
