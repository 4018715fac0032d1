"""Dogs, the wolf and the fox."""

from collections.abc import Callable

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import aside, spine, with_legs
from core.guidance.builtin.constructed.carnivore import Build, Carnivore, carnivore, pricked
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import Parts, ball, both_sides, smooth_union


def _hanging(dog: Carnivore, long: float = 1.0) -> list[Primitive]:
    """Ears that hang."""
    z = 1.255
    ear = aside(
        (0.092, -0.55, z, 0.032, 0.8),
        (0.148, -0.57, z - 0.045 * long, 0.046, 0.55),
        (0.165, -0.585, z - 0.145 * long, 0.055, 0.42),
        (0.152, -0.6, z - 0.225 * long, 0.022, 0.5),
    )
    return both_sides([smooth_union(dog.on_head(ear), 0.02)])


def _hound(draw: Draw) -> Parts:
    dog = carnivore(Build(head=1.06, eye=0.029), draw)
    up = draw(0.0, 0.3)
    tail = spine(
        (0.5, 0.86, 0.042, 1),
        (0.63, 0.88 + 0.2 * up, 0.036, 1),
        (0.74, 0.88 + 0.6 * up, 0.03, 1),
        (0.8 - 0.2 * up, 0.87 + 1.1 * up, 0.014, 1),
    )
    whole = dog.whole(tail)
    ears = _hanging(dog, draw(0.85, 1.15))
    return {"body": [whole, *dog.paws], "ears": ears, "muzzle": dog.muzzle(), **dog.face(whole)}


def _corgi(draw: Draw) -> Parts:
    dog = carnivore(Build(head=1.14, thick=1.05, stout=1.06, carry=24, nod=-18), draw)
    tail = spine((0.5, 0.86, 0.06, 1), (0.57, 0.9, 0.045, 1))
    whole = dog.whole(tail, sides=(pricked(dog, 0.19, 0.068),))
    bib = spine((-0.37, 0.68, 0.188, 0.84), (-0.42, 0.78, 0.165, 0.86))
    return {
        "body": [whole, *dog.paws],
        "chest": [smooth_union([bib], 0.02)],
        "muzzle": dog.muzzle(),
        **dog.face(whole),
    }


def _pug(draw: Draw) -> Parts:
    dog = carnivore(
        Build(head=1.16, muzzle=0.2, snub=1.12, thick=1.12, stout=1.14, eye=0.036), draw
    )
    curl = [
        (0, 0.5, 0.86),
        (0, 0.57, 0.95),
        (0.02, 0.52, 1.03),
        (0.05, 0.45, 0.99),
        (0.06, 0.47, 0.93),
    ]
    tail = aside(
        *[(*at, r) for at, r in zip(curl, (0.045, 0.045, 0.042, 0.038, 0.025), strict=True)]
    )
    folds = [
        spine((-0.745, 1.21, 0.028, 2.2), (-0.75, 1.205, 0.028, 2.2)),
        spine((-0.72, 1.262, 0.026, 2.4), (-0.725, 1.258, 0.026, 2.4)),
    ]
    whole = dog.whole(tail)
    ear = aside(
        (0.1, -0.57, 1.262, 0.03, 0.8),
        (0.135, -0.6, 1.235, 0.045, 0.6),
        (0.145, -0.635, 1.16, 0.012, 0.6),
    )
    return {
        "body": [whole, *dog.paws],
        "mask": dog.muzzle(),
        "ears": both_sides([smooth_union(dog.on_head(ear), 0.02)]),
        "folds": [smooth_union(dog.on_head(*folds), 0.015)],
        **dog.face(whole),
    }


def _poodle(draw: Draw) -> Parts:
    build = Build(head=0.98, muzzle=1.25, snub=0.85, thick=0.85, stout=0.9, nod=6)
    dog = carnivore(build, draw)
    whole = dog.whole(spine((0.46, 0.86, 0.026, 1), (0.56, 1.0, 0.022, 1)))
    ear = aside(
        (0.1, -0.55, 1.235, 0.05, 0.8),
        (0.15, -0.56, 1.13, 0.07, 0.7),
        (0.155, -0.57, 1.03, 0.05, 0.7),
    )
    sides = [
        ball(0.085, (0.106, -0.285, 0.18)),
        ball(0.082, (0.105, 0.465, 0.19)),
        ball((0.1, 0.11, 0.11), (0.095, 0.39, 0.81)),
        smooth_union(dog.on_head(ear), 0.02),
    ]
    collar = spine((-0.44, 0.985, 0.136, 0.86), (-0.455, 1.005, 0.134, 0.86))
    wool = [
        ball((0.235, 0.31, 0.27), (0, -0.24, 0.77)),
        ball((0.13, 0.15, 0.125), dog.place(-0.58, 1.31)),
        ball(0.085, (0, 0.58, 1.04)),
        *both_sides(sides),
    ]
    body = [whole, *dog.paws]
    return {
        "pompoms": wool,
        "body": body,
        "collar": [smooth_union([collar], 0.01)],
        **dog.face(whole),
    }


def _wolf(draw: Draw) -> Parts:
    dog = carnivore(Build(head=1.02, muzzle=1.3, stout=1.03, eye=0.023), draw)
    ruff = spine((-0.36, 0.86, 0.17, 0.85), (-0.47, 1.0, 0.15, 0.95))
    tufts = [
        aside((0.1, -0.4, 0.98, 0.07), (0.135, -0.43, 0.88, 0.03)),
        *dog.on_head(aside((0.1, -0.55, 1.14, 0.055), (0.15, -0.52, 1.08, 0.012))),
    ]
    whole = dog.whole(ruff, sides=(pricked(dog), *tufts))
    tail = spine(
        (0.48, 0.85, 0.05, 1),
        (0.6, 0.81, 0.075, 1),
        (0.72, 0.7, 0.085, 1),
        (0.84, 0.6, 0.055, 1),
        (0.92, 0.55, 0.012, 1),
    )
    return {
        "body": [whole, *dog.paws],
        "muzzle": dog.muzzle(),
        **dog.face(whole),
        "tail": [smooth_union([tail], 0.02)],
    }


def _fox(draw: Draw) -> Parts:
    dog = carnivore(
        Build(head=1.08, muzzle=1.35, snub=0.88, thick=0.86, stout=0.86, eye=0.026), draw
    )
    tuft = dog.on_head(aside((0.09, -0.57, 1.13, 0.055), (0.16, -0.54, 1.08, 0.012)))
    tail = spine(
        (0.46, 0.84, 0.04, 1),
        (0.6, 0.8, 0.075, 1),
        (0.76, 0.72, 0.1, 1),
        (0.93, 0.66, 0.085, 1),
        (1.06, 0.64, 0.012, 1),
    )
    whole = dog.whole(tail, sides=(pricked(dog, 0.2, 0.062), *tuft))
    tip = spine((0.9, 0.668, 0.086, 1), (0.97, 0.652, 0.079, 1), (1.07, 0.64, 0.018, 1))
    return {
        "body": [whole, *dog.paws],
        "tail tip": [smooth_union([tip], 0.02)],
        "muzzle": dog.muzzle(),
        **dog.face(whole),
    }


DOGS: dict[str, Callable[[Draw], Parts]] = {
    "dog": with_legs(_hound, 0.86, 1.05),
    "dalmatian": with_legs(_hound),
    "corgi": with_legs(_corgi, 0.4, 0.46),
    "pug": with_legs(_pug, 0.66, 0.74),
    "poodle": with_legs(_poodle),
    "wolf": with_legs(_wolf),
    "fox": with_legs(_fox, 0.82, 0.92),
}
