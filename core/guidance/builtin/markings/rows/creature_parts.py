"""Markings that several people, animals and toys share: eyes, mouths, feathers, bars, spots."""

from collections.abc import Sequence
from functools import partial

from core.guidance.builtin.markings.forms import bands, faces, lines, scales, spots
from core.guidance.builtin.markings.margins import Half, Margin, Marks, Pair, Points, Way, any_of
from core.guidance.builtin.markings.marking import Marking

GLINTS = {"glints": Marking("eyes", faces.eye_glints, paired=True)}
MUZZLED = {"mouth": Marking("muzzle", faces.muzzle_mouth)}
PAWS = {"paws": Marking("body", partial(bands.belt, low=-2.0, high=-0.7))}
SOCKS = {"socks": Marking("body", partial(bands.belt, low=-2.0, high=-0.66))}


def eyes(at: Pair, size: Pair, face: faces.Face = faces.HEAD) -> dict[str, Marking]:
    """A pair of eyes with reflections on a round head; in head radii."""
    return {
        "glints": Marking("eyes", partial(faces.face_glints, at=at, size=size, face=face)),
        "eyes": Marking("skin", partial(faces.ovals, at=at, size=size, face=face)),
    }


def mouth(
    at: float = -0.46, wide: float = 0.2, face: faces.Face = faces.HEAD
) -> dict[str, Marking]:
    """A small smile on a round head."""
    return {"mouth": Marking("skin", partial(faces.smile, at=at, wide=wide, face=face))}


def face_lines(
    on: str,
    *curves: faces.Curve,
    wide: float = 0.28,
    side: bool = False,
    until: float = 6.0,
) -> Marking:
    """Lines on a face, placed by its eyes."""
    axes = faces.SIDE if side else faces.FRONT
    marks = partial(faces.by_eyes, curves=curves, wide=wide, axes=axes, until=until)
    return Marking(on, marks, by="eyes", paired=True)


def face_spots(on: str, *middles: Way, sizes: Way) -> Marking:
    """Nostrils, cheeks and similar spots, placed by the eyes."""
    marks = partial(faces.about_eyes, middles=middles, sizes=sizes)
    return Marking(on, marks, by="eyes", paired=True)


def joined(one: Marking, *others: Marking) -> Marking:
    """Several as one part; all are placed as the first is."""
    each = (one.marks, *(other.marks for other in others))
    return one._replace(marks=partial(_any_marks, each=each))


def _any_marks(points: Points, half: Half, each: Sequence[Marks]) -> Margin:
    return any_of(*(marks(points, half) for marks in each))


def pupils(
    wide: float = 0.45, high: float = 0.45, way: Way = (0.1, -1.0, 0.05)
) -> dict[str, Marking]:
    """Pupils of eyes."""
    spots = ((way, (wide, high)),)
    return {"pupils": Marking("eyes", partial(faces.on_eye, spots=spots), paired=True)}


def feathers(**others: object) -> dict[str, Marking]:
    """Feathers of wings folded at both sides."""
    return {"feathers": Marking("wings", partial(scales.plumage, **others), paired=True)}


def bars(on: str, **others: object) -> Marking:
    """Lines across a direction, such as between the plates of a belly."""
    return Marking(on, partial(lines.bars, **others))


def wing_lines(
    on: str,
    *curves: faces.Curve,
    wide: float = 0.013,
    axes: tuple[int, int] = faces.FRONT,
) -> Marking:
    """Lines on wings, mirrored."""
    return Marking(on, partial(lines.drawn_lines, curves=curves, wide=wide, axes=axes), paired=True)


def mottled(on: str, pitch: float, low: float, high: float, fraction: float) -> Marking:
    """Scattered round spots of sizes from ``low`` to ``high``."""
    return Marking(on, partial(spots.blobs, pitch=pitch, sizes=(low, high), fraction=fraction))
