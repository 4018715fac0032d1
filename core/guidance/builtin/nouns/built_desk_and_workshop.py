"""Things of a desk, a laboratory and a workshop, put together from simple solids."""

from core.guidance.builtin.nouns.noun import COPPER, GLASS, PLASTIC, RUBBER, Noun, Usual

BUILT_DESK_AND_WORKSHOP: dict[str, Noun] = {
    "dna helix": Noun(
        "dna, double helix, dna strand, dna molecule, dna double helix",
        {
            "strands": "*3a6fd0 . plastic",
            "bases": "+e0453c . plastic",
            "pairs": "+f2c93a . plastic",
        },
        Usual(0.4, PLASTIC, 0.6),
        constructed=True,
    ),
    "steering wheel": Noun(
        "steering wheels, car steering wheel, racing wheel",
        {
            "rim": "*26272a . leather",
            "spokes": "&8e959c . metal",
            "hub": "-303236 . plastic",
            "badge": "-c3c9cf . metal",
        },
        Usual(0.38, PLASTIC),
        constructed=True,
    ),
    "test tubes": Noun(
        "test tube, test tube rack, rack of test tubes, vials",
        {
            "rack": "*b98246 . wooden",
            "tubes": "-dfeef2 . glass",
            "liquid": "+5ac23a",
        },
        Usual(0.2, GLASS, 0.4),
        constructed=True,
    ),
    "propeller": Noun(
        "propellers, ship propeller, boat propeller, airplane propeller; screw propeller",
        {
            "blades": "*c9963f . copper",
            "hub": "&a87a30 . copper",
            "bolts": "-4a4e53 . metal",
        },
        Usual(1.5, COPPER),
        constructed=True,
    ),
    "life ring": Noun(
        "lifebuoy, life buoy, life preserver, lifesaver ring, lifering, rescue ring",
        {
            "ring": "*f4f2ec . plastic",
            "bands": "+e0392f . plastic",
            "rope": "-d9c9a0",
        },
        Usual(0.75, PLASTIC, 0.15),
        constructed=True,
    ),
    "plunger": Noun(
        "toilet plunger, plungers, sink plunger",
        {"cup": "*b8392f . rubber", "handle": "-c99a5c . wooden"},
        Usual(0.5, RUBBER, 0.5),
        constructed=True,
    ),
}
