"""The paper's figures as plain lists: what is made, how it is shown, what is measured.

A command is run.py's, in which ``{file}`` is the picture that it writes, ``{asset}`` the row's own
run folder and ``{NAME}`` that of the asset ``NAME``.
"""

from dataclasses import dataclass

CYCLES = "relight {asset} --render {file}"
FRONT = "render {asset} --map normal --azimuth-deg 30 --out {file}"
BACK = "render {asset} --map normal --azimuth-deg 210 --out {file}"
SHAPE = (("normals", FRONT), ("normals from behind", BACK))
SHOWN = (*SHAPE, ("Cycles", CYCLES))
GUIDED = (("the guide's normals", "guide"), ("our normals", FRONT), ("Cycles", CYCLES))
TURNED = tuple(
    (f"from {angle}°", f"render {{asset}} --azimuth-deg {angle} --out {{file}}")
    for angle in (-20, 50, 120)
)
# Of the measures in ``numbers``; those about a word need the built-in prior.
HEALTH = ("components", "genus")


@dataclass(frozen=True)
class Asset:
    """One run: what ``generate`` is given."""

    prompt: str  # in the built-in prior's words
    options: tuple[str, ...] = ()
    guide: str = ""  # of ``guides.GUIDES``
    noun: str = ""  # what it should look like, for the retrieval
    color: str = ""  # the colour word that it should have
    paper: str = ""  # the prompt where a checkpoint knows any words; "": the same


@dataclass(frozen=True)
class Row:
    """One line of a figure's table."""

    name: str
    asset: str  # of ASSETS
    shots: tuple[tuple[str, str], ...]  # label and command of each picture
    numbers: tuple[str, ...] = HEALTH
    others: tuple[str, ...] = ()  # further assets that its commands name


@dataclass(frozen=True)
class Figure:
    """One figure of the paper."""

    name: str
    title: str
    paper: str  # what the paper shows
    note: str  # what differs here, and why
    rows: tuple[Row, ...]
    builtin_only: bool = False


ELLIPSOID = "--set=geometry.start=ellipsoid"  # the paper's own start
BUST = "a highly detailed stone bust of Theodoros Kolokotronis"
ASSETS = {
    "bust": Asset("a stone bust", noun="bust", paper=BUST),
    "crown": Asset("a golden crown", noun="crown", paper="a golden crown with jewels"),
    "chair": Asset("a red wooden chair", noun="chair", color="red"),
    "ice-cream": Asset("an ice cream", noun="ice cream", paper="an ice cream sundae"),
    "tiger": Asset("a tiger", noun="tiger"),
    "guided-bus": Asset("a red bus", ("--guide-strength=0.5",), "bus", "bus", "red"),
    "guided-teddy": Asset(
        "a brown teddy bear", ("--guide-strength=0.5",), "person", "teddy bear", "brown"
    ),
    "guided-chair": Asset("a wooden chair", ("--guide-strength=0.7",), "seat", "chair"),
    "guided-house": Asset("a stone cottage", ("--guide-strength=0.7",), "hut", "cottage"),
    "distilled": Asset("a stone bust", (ELLIPSOID,), noun="bust", paper=BUST),
    "entangled": Asset(
        "a stone bust", ("--set=geometry.pictures=entangled",), "", "bust", "", BUST
    ),
    "shaded": Asset("a stone bust", ("--set=geometry.pictures=shaded",), "", "bust", "", BUST),
    "crown-diffuse": Asset(
        "a golden crown",
        ("--set=appearance.shading=diffuse",),
        noun="crown",
        paper="a golden crown with jewels",
    ),
    "torus": Asset("a blue ceramic torus", noun="torus", color="blue"),
    "trophy": Asset("a golden trophy", noun="trophy"),
    "ladder": Asset("a wooden ladder", noun="ladder"),
    "sds-mug": Asset("a blue ceramic mug", ("--preset=sds",), noun="mug", color="blue"),
    "sds-chair": Asset("a red wooden chair", ("--preset=sds",), noun="chair", color="red"),
    "sds-torus": Asset("a blue ceramic torus", ("--preset=sds",), noun="torus", color="blue"),
    "sds-house": Asset("a brown house", ("--preset=sds",), noun="house", color="brown"),
}  # fmt: skip


def _lit(name: str, light: str, turn: int) -> tuple[str, str]:
    return name, f"relight {{asset}} --light {light} --rotation-deg {turn} --render {{file}}"


def _made_of(name: str, material: str) -> tuple[str, str]:
    return name, f"relight {{asset}} --material {material} --render {{file}}"


def _moved(kind: str, *frames: int, more: str = "") -> tuple[tuple[str, str], ...]:
    command = f"physics {{asset}} --physics {kind} --frames 40 {more}--render {{file}}"
    return tuple((f"frame {at}", f"{command} --at {at}") for at in frames)


LIGHTS = (_lit("city", "city", 0), _lit("sunset", "sunset", 60), _lit("forest", "forest", 0))
MATERIALS = (
    ("as generated", CYCLES),
    _made_of("wood", "wood"),
    _made_of("gold", "gold"),
    _made_of("marble", "marble"),
)
TERMS = tuple(
    (name, f"render {{asset}} --map {name} --out {{file}}")
    for name in ("shaded", "base_color", "roughness", "metallic")
)
WORD = ("rank", "color", *HEALTH)

FIGURES = (
    Figure(
        "text",
        "Text to 3D",
        "Figs. 1, 2 and 7: assets from words alone, their normals and their renders.",
        "The bust is the paper's own subject, the crown and the ice cream are two of its three in "
        "the Cornell box; of the words only the noun, its colour and its material are known here. "
        "The default preset puts a solid that the prior draws together from its parts; the "
        "paper's start, an ellipsoid, is that of the ablations and of the last figure.",
        tuple(Row(name, name, SHOWN, WORD) for name in ("bust", "crown", "chair", "ice-cream")),
    ),
    Figure(
        "guided",
        "User-guided generation",
        "Figs. 2 and 10: a user's coarse mesh in place of the ellipsoid, and words for the rest.",
        "The paper's meshes come from other projects and are not in this one; these are blocked "
        "out in code (`core/reproduce/guides.py`). The default preset brings a solid that the "
        "prior draws to the guide's proportions ([guides](guides.md)). The distance to the guide "
        "is the mean of the way to the other surface, both ways, in hundredths of the guide's "
        "longest side.",
        tuple(
            Row(name, f"guided-{name}", GUIDED, ("guide_distance", *WORD))
            for name in ("bus", "teddy", "chair", "house")
        ),
    ),
    Figure(
        "geometry",
        "Ablations of the geometry",
        "Fig. 6: geometry and appearance learned together from shaded pictures fails; shaded "
        "pictures in place of normals give twisted shapes.",
        "The settings are those of [ablations](ablations.md). All three start from the ellipsoid.",
        (
            Row("full method", "distilled", SHOWN, WORD),
            Row("entangled", "entangled", SHOWN, WORD),
            Row("shaded pictures instead of normals", "shaded", SHOWN, WORD),
        ),
    ),
    Figure(
        "appearance",
        "Ablation of the appearance",
        "Fig. 6: with a diffuse colour alone the result is less realistic and has no reflections.",
        "Gold in place of the paper's stone, whose reflections are weak. The pictures are the "
        "training's own shading, since an asset with a Principled material reflects anyway.",
        (
            Row("full BRDF", "crown", TURNED, ("roughness", "metallic")),
            Row("diffuse only", "crown-diffuse", TURNED, ("roughness", "metallic")),
        ),
    ),
    Figure(
        "terms",
        "The material's terms",
        "Fig. 4: kd, roughness and metallic, normal variation.",
        "The normal variation is off with the built-in prior (`appearance.bump`), whose pictures "
        "are too coarse for it. PSNR is that of the core's picture to Cycles' under the same light "
        "and camera, one bounce (`blender_tests/likeness.py`).",
        (
            Row("crown", "crown", TERMS, ("roughness", "metallic", "psnr")),
            Row("chair", "chair", TERMS, ("roughness", "metallic", "color", "psnr")),
        ),
    ),
    Figure(
        "genus",
        "Genus 0, 1, 2 and 5",
        "Fig. 8: shapes of higher genus, as marching tetrahedra allow.",
        "A bust, a torus, a trophy with two handles, a ladder of six rungs.",
        (
            Row("genus 0 wanted", "bust", SHAPE),
            Row("genus 1 wanted", "torus", SHAPE),
            Row("genus 2 wanted", "trophy", SHAPE),
            Row("genus 5 wanted", "ladder", SHAPE),
        ),
    ),
    Figure(
        "relighting",
        "Relighting",
        "Fig. 12: one asset under several environment maps in Blender.",
        "The lights are three of Blender's own.",
        tuple(Row(name, name, LIGHTS, ()) for name in ("crown", "bust", "chair")),
    ),
    Figure(
        "material",
        "The material replaced",
        "Fig. 1: the stone bust with a material of wood.",
        "The materials are the add-on's own, made of Blender's nodes.",
        (Row("bust", "bust", MATERIALS, ()), Row("chair", "chair", MATERIALS, ())),
    ),
    Figure(
        "cornell",
        "A scene in the Cornell box",
        "Fig. 11: crown, tiger and ice cream in the Cornell box, rendered in Cycles.",
        "The same three, by the built-in prior, shown as large as each other.",
        (
            Row(
                "crown, tiger, ice cream",
                "crown",
                (("Cycles", "cornell {crown} {tiger} {ice-cream} --same-size --render {file}"),),
                (),
                ("tiger", "ice-cream"),
            ),
        ),
    ),
    Figure(
        "physics",
        "Soft body, cloth, rigid body",
        "Fig. 1: the bust as a soft body and as cloth.",
        "A rigid body is added.",
        (
            Row("soft body", "bust", _moved("soft", 1, 14, 20, 36, more="--softness 0.75 "), ()),
            Row("cloth", "bust", _moved("cloth", 1, 12, 20, 36), ()),
            Row("rigid body", "bust", _moved("rigid", 1, 12, 20, 36), ()),
        ),
    ),
    Figure(
        "sds",
        "Score distillation alone",
        "The method itself: Eqs. 5 and 9, nothing else.",
        "`--preset sds` leaves out what the default preset has beyond the paper (growing, refining "
        "and sharpening from denoised pictures).",
        tuple(Row(name, f"sds-{name}", SHOWN, WORD) for name in ("mug", "chair", "torus", "house")),
        builtin_only=True,
    ),
)
