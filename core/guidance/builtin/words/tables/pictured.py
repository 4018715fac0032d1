"""Things with pictures on them. Standard library only."""

from core.guidance.builtin.nouns import GROUPS

PICTURED = frozenset(
    (
        "mug, teacup, teapot, jug, kettle, shield, rug, poster, book, plate, bottle, jar, potion, "
        "can, crate, barrel, sack, pillow, clipboard, notice board, curtain, envelope, coin, "
        "cardboard box, vase, bowl, goblet, skateboard, surfboard, snowboard, vinyl record, "
        "scroll, phone, towel, paper cup, gift, lantern, signpost, stop sign, traffic light, "
        "mirror, picture frame, clock, easel, door, window, wall, milk carton, chocolate bar, "
        "map pin, poker chip, toilet paper, ring, tombstone, notebook"
    ).split(", ")
)
_PICTURED_GROUPS = ("Flags and Signs", "Clothes", "Electronics")


def is_pictured(noun: str) -> bool:
    """Whether a thing stated to be on it is a picture, a print or a sticker."""
    return noun in PICTURED or any(noun in GROUPS[group] for group in _PICTURED_GROUPS)
