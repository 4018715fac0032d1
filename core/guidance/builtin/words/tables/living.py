"""Living things: animals and people. Standard library only."""

from core.guidance.builtin.nouns import GROUPS

PEOPLE, ANIMALS = "Characters", ("Animals", "Wild Animals")
# Things of these groups that are made, or dead.
LIFELESS = frozenset(
    """moai obelisk mask eyeball doll nutcracker mech golem skeleton scarecrow snowman bone
    tooth gargoyle""".split()
) | {"totem pole", "teddy bear"}
# Roles of living things: "a goblin archer" is a goblin.
ROLES = frozenset(
    """person knight wizard pirate king ninja astronaut superhero samurai viking princess chef
    soldier cowboy witch queen firefighter girl boy baby""".split()
) | {"police officer"}


def is_creature(noun: str) -> bool:
    """Whether it is an animal or a person, or the likeness of one: a doll, a skeleton."""
    return any(noun in GROUPS[group] for group in (PEOPLE, *ANIMALS))


def is_animal(noun: str) -> bool:
    """Whether it is a living animal."""
    apart = ROLES | LIFELESS
    return noun not in apart and any(noun in GROUPS[group] for group in ANIMALS)


def is_somebody(noun: str) -> bool:
    """Whether it is a living person, including fabulous ones."""
    return noun not in LIFELESS and (noun in ROLES or noun in GROUPS[PEOPLE])
