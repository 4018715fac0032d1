"""The usual size of each thing and the density of each material, as data.

Sizes are of ordinary specimens, along the longest side. Densities are handbook values. Most things
are not solid: ``filled`` is the part of the outer volume that is material, chosen so that the mass
is that of an ordinary specimen (a car of 4.2 m weighs 1.4 t, not 60).
"""

from typing import NamedTuple


class Usual(NamedTuple):
    """What is usual of a thing."""

    size_m: float  # the longest side
    kg_m3: float  # of what it is made of where the prompt names no material
    filled: float = 1.0  # the part of its volume that is material


WOOD, STEEL, GOLD, PLASTIC, RUBBER, STONE = 650.0, 7850.0, 19300.0, 1000.0, 1150.0, 2600.0
CERAMIC, GLASS, COPPER, FABRIC = 2400.0, 2500.0, 8900.0, 250.0
FLESH, PLANT, WAX, SNOW = 1000.0, 900.0, 900.0, 450.0
DENSITIES = {  # kg/m³, of the prior's materials
    "wooden": WOOD,
    "metal": STEEL,
    "golden": GOLD,
    "plastic": PLASTIC,
    "rubber": RUBBER,
    "stone": STONE,
    "rusty": STEEL,
    "ceramic": CERAMIC,
    "leather": 900.0,
    "glass": GLASS,
    "copper": COPPER,
    "fabric": FABRIC,  # with its padding
}
# By group, as a menu shows them.
THINGS: dict[str, dict[str, Usual]] = {
    "Solids": {
        "ball": Usual(0.22, RUBBER, 0.07),
        "cube": Usual(0.3, WOOD),
        "torus": Usual(0.3, RUBBER, 0.3),
        "cylinder": Usual(0.4, WOOD),
        "cone": Usual(0.5, PLASTIC, 0.15),
    },
    "Furniture": {
        "table": Usual(1.4, WOOD),
        "chair": Usual(0.9, WOOD),
        "armchair": Usual(1.0, FABRIC, 0.4),
        "sofa": Usual(2.0, FABRIC, 0.3),
        "stool": Usual(0.6, WOOD),
        "bench": Usual(1.5, WOOD),
        "bed": Usual(2.1, FABRIC, 0.3),
        "bookshelf": Usual(1.9, WOOD, 0.5),
        "lamp": Usual(0.5, STEEL, 0.02),
    },
    "Household": {
        "mug": Usual(0.1, CERAMIC, 0.4),
        "vase": Usual(0.3, CERAMIC, 0.3),
        "bottle": Usual(0.3, GLASS, 0.25),
        "teapot": Usual(0.25, CERAMIC, 0.2),
        "bowl": Usual(0.16, CERAMIC, 0.5),
        "pan": Usual(0.45, STEEL, 0.3),
        "goblet": Usual(0.18, STEEL, 0.15),
        "bucket": Usual(0.3, STEEL, 0.01),
        "candle": Usual(0.2, WAX),
        "crown": Usual(0.2, GOLD, 0.05),
        "hat": Usual(0.3, FABRIC, 0.15),
        "bell": Usual(0.4, COPPER, 0.25),
        "bust": Usual(0.5, STONE),
        "trophy": Usual(0.4, STEEL, 0.1),
        "bowling pin": Usual(0.38, WOOD),
    },
    "Food": {
        "hamburger": Usual(0.12, 500.0),
        "ice cream": Usual(0.18, 600.0),
        "pineapple": Usual(0.3, PLANT),
        "apple": Usual(0.08, 800.0),
        "carrot": Usual(0.2, 1000.0),
        "cupcake": Usual(0.08, 400.0),
        "pumpkin": Usual(0.35, PLANT, 0.6),
    },
    "Plants": {
        "mushroom": Usual(0.1, PLANT, 0.7),
        "tree": Usual(6.0, PLANT, 0.05),
        "cactus": Usual(0.4, PLANT),
        "flower": Usual(0.4, PLANT, 0.3),
        "palm": Usual(8.0, PLANT, 0.3),
    },
    "Animals": {
        "pig": Usual(1.2, FLESH),
        "fish": Usual(0.3, FLESH),
        "rabbit": Usual(0.35, FLESH),
        "turtle": Usual(0.4, FLESH),
        "duck": Usual(0.4, FLESH, 0.6),
        "teddy bear": Usual(0.4, FABRIC, 0.3),
        "snowman": Usual(1.6, SNOW),
    },
    "Vehicles": {
        "car": Usual(4.2, STEEL, 0.022),
        "bus": Usual(12.0, STEEL, 0.019),
        "truck": Usual(7.0, STEEL, 0.03),
        "airplane": Usual(12.0, STEEL, 0.015),
        "boat": Usual(8.0, WOOD, 0.3),
        "train": Usual(12.0, STEEL, 0.1),
        "rocket": Usual(20.0, STEEL, 0.03),
    },
    "Buildings": {
        "house": Usual(8.0, STONE, 0.15),
        "cottage": Usual(7.0, STONE, 0.15),
        "tower": Usual(20.0, STONE, 0.3),
        "lighthouse": Usual(25.0, STONE, 0.3),
        "church": Usual(25.0, STONE, 0.1),
        "arch": Usual(4.0, STONE),
    },
    "Tools and Toys": {
        "hammer": Usual(0.33, 2500.0),  # a wooden handle and a steel head
        "axe": Usual(0.8, 1500.0),
        "anvil": Usual(0.5, STEEL),
        "dumbbell": Usual(0.4, STEEL),
        "guitar": Usual(1.0, WOOD, 0.2),
        "drum": Usual(0.4, WOOD, 0.2),
        "robot": Usual(0.3, STEEL, 0.15),  # a toy, as the prior makes it
    },
}
USUAL = {noun: usual for group in THINGS.values() for noun, usual in group.items()}
UNKNOWN = Usual(1.0, 400.0)  # where the prompt names no known thing: 1 m, light wood


def usual(noun: str, material: str = "") -> tuple[float, float]:
    """The size in metres and the density in kg/m³, averaged over the volume, of a thing of
    ``material``; "" is the usual one."""
    size, own, filled = USUAL.get(noun, UNKNOWN)
    return size, round(DENSITIES.get(material, own) * filled, 3)
