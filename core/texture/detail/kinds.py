"""The detail of each kind of material, by the name under which a guidance asks for it."""

from collections.abc import Callable

from core.texture.detail import cast, cloth, metal, rust, stone, wood
from core.texture.detail.place import Layer, Place

KINDS: dict[str, Callable[[Place], Layer]] = {
    "plain": cast.plain,
    "paint": cast.paint,
    "wooden": wood.wooden,
    "thatch": wood.thatch,
    "metal": metal.metal,
    "brushed metal": metal.brushed,
    "polished metal": metal.polished,
    "cast iron": metal.cast,
    "golden": metal.golden,
    "gold leaf": metal.leaf,
    "copper": metal.hammered,
    "rusty": rust.rusty,
    "rusted paint": rust.rusted_paint,
    "plastic": cast.plastic,
    "rubber": cast.rubber,
    "ceramic": cast.ceramic,
    "clay": cast.clay,
    "glass": cast.glass,
    "stone": stone.stone,
    "granite": stone.granite,
    "marble": stone.marble,
    "concrete": stone.concrete,
    "masonry": stone.masonry,
    "brick": stone.brick,
    "leather": cloth.leather,
    "fabric": cloth.fabric,
    "denim": cloth.denim,
    "felt": cloth.felt,
    "velvet": cloth.velvet,
}
