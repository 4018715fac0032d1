"""Outlines of the markings of crates and drums."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Plate, hazard, on_all_sides

CRATE_LIGHTS = on_all_sides(
    Plate((0, 0.46), (0.5, 0.055), 1.0), Plate((0.56, -0.12), (0.05, 0.34), 1.0, twice=True)
) | {"top": (Plate((0, 0), (0.46, 0.46), 0.5, 0.03),)}
CRATE_VENTS = on_all_sides(Cells((0, -0.12), (0.36, 0.32), (1, 4), (1, 0.5), 0.5)) | {
    "top": (Cells((0, 0), (0.26, 0.26), (1, 4), (1, 0.5), 0.5),)
}
CRATE_STRIPES = on_all_sides(
    *hazard((0, 0.84), (0.36, 0.09), 5), *hazard((0, -0.84), (0.36, 0.09), 5)
)
_CORNERS = ((0.84, 0.84), (0.84, 0.0), (0.84, -0.84))
CRATE_BOLTS = (
    on_all_sides(*(Disc(at, 0.075, twice=True) for at in _CORNERS))
    | {"top": tuple(Disc(at, 0.075, twice=True) for at in _CORNERS)}
    | {"deep": 0.3}
)
AMMO_LETTERS = on_all_sides(
    Emblem((0, 0.22), 0.136, text="AMMO"), Emblem((0, -0.3), 0.136, text="7.62")
)
AMMO_STAR = {"top": (Emblem((0, 0), 0.46, "star"),)}
AMMO_CLASPS = {
    "front": (Plate((0.5, 0.84), (0.08, 0.13), 0.2, twice=True),),
    "sides": (Plate((0, 0.82), (0.24, 0.05), 0.9, 0.02),),
}
AMMO_BOLTS = on_all_sides(
    *(Disc(at, 0.05, twice=True) for at in ((0.86, 0.86), (0.86, 0.0), (0.86, -0.86)))
) | {"deep": 0.3}
DRUM_LETTERS = {side: (Emblem((0, 0.0), 0.22, text="OIL"),) for side in ("front", "back")} | {
    "deep": 0.2
}
DRUM_BANDS = ((-0.4, -0.32), (0.32, 0.4))
DRUM_BUNG = {"top": (Disc((0.5, -0.25), 0.15), Disc((-0.5, 0.3), 0.09)), "deep": 0.9}
TOXIC_SIGN = {side: (Emblem((0, -0.06), 0.4, "radiation sign"),) for side in ("front", "back")} | {
    "deep": 0.2
}
MANHOLE_HOLES = {"top": (Plate((0.62, 0.0), (0.035, 0.09), 0.9, twice=True),), "deep": 0.3}
PUCK_BADGE = {"top": (Disc((0, 0), 0.62, 0.03), Emblem((0, 0), 0.42, "star")), "deep": 0.4}
MINE_PLATE = {"top": (Disc((0, 0), 0.52),), "deep": 0.2}
MINE_LIGHT = {"top": (Disc((0, 0), 0.14),), "deep": 0.2}
