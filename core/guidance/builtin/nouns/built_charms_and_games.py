"""Books, charms, weapons and things of games, put together from simple solids."""

from core.guidance.builtin.nouns.noun import PAPER, STEEL, WOOD, Noun, Usual

BUILT_CHARMS_AND_GAMES: dict[str, Noun] = {
    "open book": Noun(
        "opened book, open spellbook, open bible, open journal, open storybook, open diary; open "
        "grimoire, open magazine",
        {
            "cover": "*7a2a22 . leather",
            "pages": "-efe6d0",
            "text": "-4a4038",
            "corners": "+c9963f . golden",
            "ribbon": "+b3202e . fabric",
        },
        Usual(0.4, PAPER, 0.7),
        constructed=True,
    ),
    "shuriken": Noun(
        "throwing star, ninja star, ninja throwing star, shurikens",
        {
            "blade": "*9aa1a8 . metal",
            "edge": "&3a3d42 . metal",
            "ring": "-c9963f . golden",
        },
        Usual(0.12, STEEL),
        constructed=True,
    ),
    "dreamcatcher": Noun(
        "dream catcher, dreamcatchers",
        {
            "hoop": "*8a5a34 . leather",
            "net": "-efe6d2",
            "beads": "+2fa3a0",
            "feathers": "+f2efe8",
        },
        Usual(0.6, WOOD, 0.3),
        constructed=True,
    ),
}
