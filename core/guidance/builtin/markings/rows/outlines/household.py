"""Outlines and spans of the markings of household."""

from core.guidance.builtin.markings.outlines import Cells, Disc, Emblem, Line, Plate, hazard

MUG_BANDS = ((0.86, 1.3), (-0.74, -0.5), (-0.42, -0.37))
LABEL_BADGE = {"front": (Emblem((0, -0.435), 0.42, "leaf"),), "deep": 0.1}
BOTTLE_BANDS = ((-0.7, -0.665), (-0.205, -0.17))
BOWL_BANDS = ((0.8, 1.3), (0.58, 0.66))
TEAPOT_BANDS = ((0.5, 0.56), (-0.42, -0.36), (-0.5, -0.47))
KETTLE_BANDS = ((-2.0, -0.84), (0.62, 0.72))
OVEN_RACKS = {
    "front": (
        Plate((0, 0), (0.84, 0.72), 0.2, 0.013),
        Cells((0, -0.05), (0.78, 0.5), (1, 2), (1, 0.13)),
    ),
    "deep": 0.3,
}
OVEN_COILS = {
    "top": tuple(
        Disc((0.48, at), r, 0.014, twice=True) for at in (-0.44, 0.4) for r in (0.1, 0.22)
    ),
    "deep": 0.3,
}
OVEN_SEAMS = {
    "front": (
        Plate((0, -0.28), (0.9, 0.42), 0.08, 0.013),
        Plate((0, -0.85), (0.9, 0.12), 0.2, 0.013),
        Plate((0, -0.81), (0.3, 0.03), 0.9),
    ),
    "back": (Cells((0, -0.5), (0.6, 0.16), (1, 3), (1, 0.4), 0.9),),
}
FRIDGE_MAGNETS = {
    "front": (
        Disc((0.55, 0.63), 0.09),
        Emblem((0.34, 0.8), 0.13, "heart"),
        Emblem((-0.5, 0.78), 0.14, "star"),
    ),
    "deep": 0.4,
}
FRIDGE_NOTE = {
    "front": (
        Plate((0.55, 0.5), (0.25, 0.14)),
        Cells((0.55, 0.48), (0.18, 0.08), (1, 3), (1, 0.28), gap=True),
    ),
    "deep": 0.4,
}
FRIDGE_COILS = {
    "back": (Cells((0, 0.2), (0.72, 0.6), (1, 10), (1, 0.3)), Plate((0, -0.76), (0.8, 0.16), 0.1)),
    "deep": 0.8,
}
MICROWAVE_DIGITS = {"front": (Emblem((0.8, 0.55), 0.06, text="12:00"),)}
MICROWAVE_DISPLAY = {"front": (Plate((0.8, 0.55), (0.14, 0.16), 0.3),)}
MICROWAVE_BUTTONS = {
    "front": (Cells((0.8, -0.1), (0.15, 0.4), (3, 4), (0.7, 0.68), 0.4),
              Plate((0.8, -0.72), (0.14, 0.11), 0.4)),
}  # fmt: skip
MICROWAVE_MESH = {"front": (Plate((0, 0), (0.86, 0.78), 0.2, 0.013),), "deep": 0.3}
MICROWAVE_SEAMS = {
    "front": (Line(((0.6, -1), (0.6, 1)), 0.012), Plate((-0.24, 0), (0.56, 0.64), 0.1, 0.011)),
    "back": (Cells((0, 0.2), (0.6, 0.4), (9, 1), (0.35, 1), 0.9),),
    "sides": (Cells((0.1, 0.3), (0.5, 0.3), (6, 1), (0.35, 1), 0.9),),
    "deep": 0.92,
}
JUG_MARKS = {
    "front": tuple(
        Line(((-0.34, at), (-0.02 + 0.16 * (k % 2), at)), 0.013)
        for k, at in enumerate((-0.6, -0.36, -0.12, 0.12, 0.36, 0.6))
    ),
    "deep": 0.1,
}
BLENDER_TRIM = ((-2.0, -0.76),)
DOOR_TRIM = {
    "front": (Plate((0, 0), (0.74, 0.72), 0.08, 0.018),),
    "back": (Plate((0, 0), (0.74, 0.72), 0.08, 0.018),),
    "deep": 0.0,
}
DOOR_KEYHOLE = {
    "front": (Disc((0.8, -0.21), 0.05), Line(((0.8, -0.21), (0.8, -0.25)), 0.009)),
    "back": (Disc((-0.8, -0.21), 0.05), Line(((-0.8, -0.21), (-0.8, -0.25)), 0.009)),
}
DOOR_LOCK = {
    "front": (Plate((0.8, -0.15), (0.12, 0.15), 0.4),),
    "back": (Plate((-0.8, -0.15), (0.12, 0.15), 0.4),),
}
DOOR_HINGES = {
    "front": tuple(Plate((-0.8, at), (0.22, 0.03), 0.9) for at in (-0.72, 0.74)),
    "back": tuple(Plate((0.8, at), (0.22, 0.03), 0.9) for at in (-0.72, 0.74)),
    "deep": 0.3,
}
_SHUTTER = (Plate((0, 0), (0.72, 0.86), 0.1, 0.014), Cells((0, 0), (0.5, 0.76), (1, 9), (1, 0.4)))
SLATS = {"front": _SHUTTER, "back": _SHUTTER, "deep": 0.2}
TOILET_SEAMS = {
    side: (Line(((-1.2, 0.5), (1.2, 0.5)), 0.01), Plate((0, -0.26), (0.76, 0.52), 0.2, 0.011))
    for side in ("front", "back", "sides")
}
TOILET_HINGES = {"top": (Plate((0.42, 0.86), (0.14, 0.06), 0.6, twice=True),), "deep": 0.0}
BATH_BANDS = ((0.16, 0.24), (-0.02, 0.02))
SINK_PANEL = {
    side: (Plate((0, 0.02), (0.84, 0.6), 0.3, 0.012),) for side in ("front", "back", "sides")
}
SINK_BANDS = ((-0.84, -0.78), (0.62, 0.68))
PANEL_LIGHTS = {
    "front": (
        Plate((-0.4, 0.0), (0.4, 0.5), 0.2),
        Cells((0.5, 0), (0.38, 0.4), (3, 1), (0.6, 1), 0.9),
    ),
    "deep": 0.3,
}
WASHER_SEAMS = {
    "front": (
        Line(((-0.95, 0.6), (0.95, 0.6)), 0.012),
        Plate((0.62, -0.86), (0.22, 0.07), 0.3, 0.012),
    ),
    "back": (
        Plate((0, 0.05), (0.7, 0.68), 0.12, 0.014),
        Cells((0, 0.5), (0.4, 0.12), (7, 1), (0.4, 1), 0.9),
        Disc((0.4, -0.82), 0.09, twice=True),
    ),
    "deep": 0.5,
}
BUCKET_BANDS = ((0.44, 0.6), (-0.62, -0.46))
FAN_BUTTONS = {
    "top": (Disc((-0.36, -0.62), 0.1), Disc((0, -0.72), 0.1), Disc((0.36, -0.62), 0.1)),
    "deep": -9.0,
    "until": -0.5,
}
FAN_BADGE = {"front": (Disc((0, 0), 0.6),), "deep": 0.3}
SAFE_RIVETS = {
    "front": tuple(
        Disc(at, 0.045, twice=True)
        for at in ((0.9, 0.9), (0.9, 0.3), (0.9, -0.3), (0.9, -0.9), (0.32, 0.9), (0.32, -0.9))
    ),
    "sides": (Plate((0, 0), (0.8, 0.8), 0.1, 0.016),),
    "back": (Plate((0, 0), (0.8, 0.8), 0.1, 0.016),),
    "deep": 0.2,
}
PLAQUE = {
    "front": (Plate((0, -0.1), (0.6, 0.36), 0.3), Emblem((0, -0.1), 0.26, text="No 1", gap=True)),
    "deep": 0.2,
}
CUP_STAR = {"front": (Emblem((0, 0.36), 0.4, "star"),), "deep": 0.2}
BELL_BANDS = ((-0.9, -0.76), (-0.68, -0.64), (0.34, 0.44), (0.5, 0.54))
CROWN_BANDS = ((-1.2, -0.86), (-0.3, -0.2))
HAT_BUCKLE = {"front": (Plate((0, 0), (0.24, 0.74), 0.2, 0.022),), "deep": 0.3}
REMOTE_SEAMS = {
    "back": (
        Plate((0, -0.4), (0.74, 0.44), 0.2, 0.011),
        Cells((0, -0.06), (0.3, 0.05), (1, 3), (1, 0.4), 0.9),
    ),
    "deep": 0.2,
}
LABEL_FLOWER = {"front": (Emblem((0, 0), 0.56, "flower"),), "deep": -0.2}
LABEL_EDGE = {"front": (Plate((0, 0), (0.84, 0.84), 0.9, 0.01),), "deep": -0.2}
COLLAR_GROOVES = ((-0.4, -0.3), (0.0, 0.1), (0.4, 0.5))
_COUNTER = (
    Cells((0, 0.12), (0.94, 0.62), (4, 1), (0.84, 1.0), 0.05),
    Cells((0, 0.12), (0.94, 0.62), (4, 1), (0.7, 0.84), 0.05, gap=True),
    Cells((0, 0.12), (0.94, 0.62), (4, 1), (0.62, 0.75), 0.05),
)
_COUNTER_END = (
    Plate((0, 0.12), (0.76, 0.62), 0.05),
    Plate((0, 0.12), (0.64, 0.52), 0.05, gap=True),
    Plate((0, 0.12), (0.56, 0.47), 0.05),
)
COUNTER_PANELS = {"front": _COUNTER, "back": _COUNTER, "sides": _COUNTER_END, "deep": 0.7}
HEMS = ((-1.2, -0.84), (-0.78, -0.74))
MONOGRAM = {"front": (Emblem((0, 0), 0.4, "heart"),), "deep": 0.0}
CASE_LINES = ((-0.9, -0.8), (-0.74, -0.7))
TUBE_GROOVES = ((0.0, 0.06), (0.5, 0.56), (0.68, 0.72))
STAMP = {
    "back": (Plate((0.76, 0.56), (0.14, 0.27), 0.1), Emblem((0.76, 0.56), 0.17, "heart", gap=True)),
    "deep": 0.2,
}
ADDRESS = {
    "back": (Plate((-0.02, 0.1), (0.4, 0.03)), Plate((-0.08, -0.16), (0.34, 0.03)),
             Plate((-0.16, -0.42), (0.26, 0.03)), Plate((-0.76, 0.74), (0.14, 0.03)),
             Plate((-0.78, 0.58), (0.12, 0.03))),
    "deep": 0.2,
}  # fmt: skip
PIN_RING = {
    side: (Disc((0, 0), 0.72, 0.02), Emblem((0, 0), 0.44, "star")) for side in ("front", "back")
}
SCIFI_LIGHTS = {
    side: (Plate((0.89, 0), (0.028, 0.62), 1.0, twice=True), Plate((0, 0.84), (0.5, 0.012), 1.0))
    for side in ("front", "back")
}
SCIFI_STRIPES = {side: (*hazard((0, 0.93), (0.6, 0.05), 7),) for side in ("front", "back")} | {
    "deep": 0.0
}
SCIFI_SEAM = {side: (Line(((0, -1.1), (0, 1.1)), 0.014),) for side in ("front", "back")} | {
    "deep": 0.0
}
SCIFI_LINES = {
    side: (Line(((0, -1.1), (0, 1.1)), 0.014), Plate((0.5, -0.7), (0.3, 0.14), 0.2, 0.012, True))
    for side in ("front", "back")
}
