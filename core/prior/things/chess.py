"""Chess: its pieces."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    both,
    box,
    cut,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    tube,
)


def pawn(draw: Draw) -> Parts:
    """A pawn of chess."""
    r, high = draw(0.6, 0.7), draw(1.4, 1.65)
    side = smooth_curve([(r * 0.85, 0.25), (r * 0.5, 0.55), (0.24, 1.0), (0.3, high - 0.05)])
    return {
        "body": join(lathe(side, 0.01), ball((0, 0, high + 0.3), draw(0.38, 0.44))),
        "base": lathe([(r, 0.0), (r, 0.16), (r * 0.82, 0.3)], 0.03),
        "collar": tube((0, 0, high - 0.1), (0, 0, high + 0.05), r * 0.7, 0.05),
    }


def _piece(wide: float, waist: float, neck: float) -> list[tuple[float, float]]:
    """The turned body of a chess piece, from its base to its neck."""
    return [(wide, 0.2), (wide * 0.94, 0.36), (waist * 1.2, 0.56), (waist, neck)]


def chess_knight(draw: Draw) -> Parts:
    """A horse's head that looks to the front, on a turned base."""
    wide, low, thick = draw(0.56, 0.68), draw(0.4, 0.55), draw(0.2, 0.27)
    side = [(-0.38, 0), (-0.44, 0.26), (-0.18, 0.66), (-0.34, 0.7), (-0.62, 0.52), (-0.8, 0.64)]
    side += [(-0.78, 0.84), (-0.42, 1.2), (-0.22, 1.34), (0.06, 1.34), (0.3, 1.12), (0.44, 0.74)]
    side += [(0.46, 0.3), (0.4, 0)]
    crest = [(-0.36, 1.16), (-0.1, 1.46), (0.1, 1.48), (0.42, 1.22), (0.6, 0.78), (0.6, 0.26)]
    crest += [(0.3, 0.26), (0.1, 1.1)]
    ear = prism([(-0.22, 1.2), (0.06, 1.2), (-0.12, 1.66)], 0, 0.09, thick - 0.06)
    return {
        "body": moved(join(prism(side, 0, thick), both(ear)), (0, 0, low)),
        "mane": moved(prism(crest, 0, 0.1), (0, 0, low)),
        "base": lathe([(wide, 0), (wide, 0.22), (wide * 0.82, 0.22), (wide * 0.82, low + 0.06)]),
        "eyes": both(ball((thick - 0.02, -0.34, low + 0.98), 0.1)),
    }


def chess_rook(draw: Draw) -> Parts:
    """A small tower with battlements on a turned base."""
    wide, waist, neck, count = (
        draw(0.55, 0.65),
        draw(0.32, 0.4),
        draw(1.2, 1.5),
        4 + 2 * draw.chance(0.5),
    )
    rim, top = waist + 0.14, neck + draw(0.4, 0.5)
    gaps = around(count, box((rim, 0, top + 0.05), (0.3, 0.1, 0.22)))
    cup = cut(
        lathe([(waist, neck), (rim, neck + 0.1), (rim, top)], 0.02),
        tube((0, 0, top - 0.2), (0, 0, top + 1), rim - 0.18),
        gaps,
    )
    return {
        "body": lathe(_piece(wide * 0.9, waist, neck + 0.05), 0.02),
        "top": cup,
        "base": tube((0, 0, 0), (0, 0, 0.24), wide, 0.06),
        "ring": ring((0, 0, neck), waist, 0.1),
    }


def chess_king(draw: Draw) -> Parts:
    """A tall piece with a crown and a cross."""
    wide, waist, neck, crown = draw(0.54, 0.62), draw(0.23, 0.28), draw(1.35, 1.55), draw(0.4, 0.48)
    top, arm = neck + draw(0.42, 0.5), draw(0.22, 0.28)
    cap = [(waist, neck), (crown, top), (crown * 0.4, top + 0.16)]
    return {
        "body": join(lathe(_piece(wide * 0.9, waist, neck + 0.05)), lathe(cap)),
        "cross": join(
            box((0, 0, top + 0.34), (0.1, 0.1, 0.34)), box((0, 0, top + 0.42), (arm, 0.1, 0.1))
        ),
        "base": tube((0, 0, 0), (0, 0, 0.24), wide),
        "rings": join(
            tube((0, 0, neck - 0.06), (0, 0, neck + 0.12), waist + 0.14),
            tube((0, 0, neck - 0.4), (0, 0, neck - 0.24), waist + 0.1),
        ),
    }


CHESS = {
    "pawn": pawn,
    "chess knight": chess_knight,
    "chess rook": chess_rook,
    "chess king": chess_king,
}
