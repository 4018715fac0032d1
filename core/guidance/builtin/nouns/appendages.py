"""Wings, horns, ears and tails by themselves, as a costume has them; most of them are made on the
body of another thing."""

from core.guidance.builtin.nouns.noun import FABRIC, LEATHER, PLASTIC, STEEL, WOOD, Noun, Usual

_WINGS = Usual(1.3, FABRIC, 0.3)
_EARS = Usual(0.25, FABRIC, 0.3)

APPENDAGES = {
    "wings": Noun(
        "angel wings, feathered wings, feather wings, angelic wings, bird wings; swan wings, "
        "eagle wings, pegasus wings, cupid wings",
        {"wings": "*f4f1ea", "coverts": "&e3dccd"},
        _WINGS,
        constructed=True,
    ),
    "bat wings": Noun(
        "dragon wings, demon wings, devil wings, leathery wings, demonic wings; gargoyle wings, "
        "vampire wings, pterodactyl wings",
        {"wings": "*6a2f35 . leather", "arms": "&3a2229 . leather"},
        Usual(1.3, LEATHER, 0.3),
        constructed=True,
    ),
    "butterfly wings": Noun(
        "monarch wings; insect wings, moth wings, bug wings",
        {"wings": "*ee7d1a", "edges": "+1f1a17"},
        _WINGS,
        constructed=True,
    ),
    "fairy wings": Noun(
        "pixie wings, gossamer wings; dragonfly wings, bee wings",
        {"wings": "*c4e6f6", "edges": "&7fb4dc"},
        _WINGS,
        constructed=True,
    ),
    "horns": Noun(
        "bull horns, ox horns, cow horns; buffalo horns, bison horns, viking horns",
        {"horns": "*d9cdb4"},
        Usual(0.5, WOOD, 0.5),
        constructed=True,
    ),
    "devil horns": Noun(
        "demon horns, demonic horns, devil's horns, satan horns; dragon horns, goat horns",
        {"horns": "*8f1616"},
        Usual(0.3, PLASTIC, 0.3),
        constructed=True,
    ),
    "ram horns": Noun(
        "ram's horns, rams horns, curled horns, curly horns, spiral horns; sheep horns, ibex horns",
        {"horns": "*b0956a"},
        Usual(0.5, WOOD, 0.5),
        constructed=True,
    ),
    "antlers": Noun(
        "deer antlers, reindeer antlers, stag antlers; moose antlers, elk antlers, deer horns",
        {"antlers": "*a07a4e"},
        Usual(0.8, WOOD, 0.5),
        constructed=True,
    ),
    "unicorn horn": Noun(
        "unicorn's horn, unicorn horns, spiral horn; narwhal horn, narwhal tusk",
        {"horn": "*f3e2b0", "twist": "&d9b65c"},
        Usual(0.3, PLASTIC, 0.3),
        constructed=True,
    ),
    "halo": Noun(
        "halos, angel halo, angel's halo, golden halo",
        {"halo": "*f2c23a . golden"},
        Usual(0.3, STEEL),
        constructed=True,
    ),
    "cat ears": Noun(
        "cat's ears, kitty ears, kitten ears; dog ears, wolf ears, bear ears, animal ears",
        {"ears": "*2f2a27", "inner": "-e6a9a4"},
        _EARS,
        constructed=True,
    ),
    "fox ears": Noun(
        "fox's ears; kitsune ears",
        {"ears": "*d9702a", "inner": "-f6f0e6"},
        _EARS,
        constructed=True,
    ),
    "bunny ears": Noun(
        "rabbit ears, bunny's ears, rabbit's ears, hare ears; donkey ears",
        {"ears": "*f3efe9", "inner": "-f0b3b3"},
        _EARS,
        constructed=True,
    ),
    "cat tail": Noun(
        "cat's tail; monkey tail", {"tail": "*2f2a27"}, Usual(0.5, FABRIC), constructed=True
    ),
    "fox tail": Noun(
        "fox's tail, bushy tail; squirrel tail, wolf tail",
        {"tail": "*d9702a", "tip": "-f6f0e6"},
        Usual(0.6, FABRIC, 0.3),
        constructed=True,
    ),
    "devil tail": Noun(
        "devil's tail, demon tail, demon's tail; dragon tail",
        {"tail": "*8f1616"},
        Usual(0.6, PLASTIC, 0.3),
        constructed=True,
    ),
}
