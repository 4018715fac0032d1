"""Scores of the networks on fresh renders.

Geometry: a diffusion classifier (Li et al., 2023) finds the condition under which the network
removes the noise best. Nouns are distinguished at the true camera. Azimuths are distinguished by a
paired test: for each hypothesis the picture's normals, and the noise with them, are turned about
the vertical so that they belong to the hypothesised camera. Without that turn the colours alone
would give the camera away and even a ball would score full marks; with it a ball must score chance.

Appearance: the distance between the mean picture that the network predicts from much noise and the
painted one, in the mean colour of a plain object, and pixel by pixel on a patterned one.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import torch
from torch import Tensor

from core.camera import Cameras
from core.device import has_fast_bfloat16
from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.builtin.hint import hint
from core.guidance.builtin.network import BLOCK, UNet, camera_map
from core.guidance.builtin.palette import looks
from core.guidance.builtin.part_map import PARTS
from core.guidance.builtin.words.grammar.lexicon import SLOTS as WORDS
from core.guidance.builtin.words.tables.colors import COLOR_VALUES
from core.guidance.sds import add_noise, eps_from_v
from core.ops import lab, srgb_to_linear
from core.prior.colored import Painter
from core.prior.data import NOUNS, SIZE, VIEWS, Samples, make
from core.prior.draw import Draw
from core.prior.families import build
from core.prior.tracer import render
from core.prior.velocity import x_from_v

TIMES = (300, 500, 650, 800, 900)
SECTORS = 8
SLOTS = 3  # the geometry network's words: noun, shape, part
CHANCE = 1 / len(NOUNS)
SCREENED = 8  # nouns that are left after the first time step
# All other nouns are turned solids, or look the same or nearly the same after a turn.
WITH_FRONT = frozenset(
    """chair armchair mug house snowman sofa bed bookshelf teapot pan bust flower pig fish rabbit
    turtle duck teddy-bear car bus truck airplane boat train cottage church hammer axe anvil guitar
    robot""".split()
)


@dataclass(frozen=True)
class Score:
    """The geometry network's score for one noun."""

    noun: str
    views: int
    noun_right: int
    azimuth_right: int  # the sector exactly
    azimuth_near: int  # within one sector

    @property
    def has_front(self) -> bool:
        """Whether the azimuth can be known at all."""
        return self.noun.replace(" ", "-") in WITH_FRONT

    def __str__(self) -> str:
        azimuth = f"azimuth {self.azimuth_right / self.views:.2f}, "
        azimuth += f"within a sector {self.azimuth_near / self.views:.2f}"
        note = "" if self.has_front else " (no front: chance is 0.12 and 0.38 or a symmetry's)"
        return f"{self.noun:12} noun {self.noun_right / self.views:.2f}, {azimuth}{note}"


def turn_normals(pictures: Tensor, angle: Tensor) -> Tensor:
    """The vectors of (B, 4, s, s) pictures turned about +Z by ``angle`` (B,) radians."""
    c, s = angle.cos()[:, None, None], angle.sin()[:, None, None]
    x, y, z, o = pictures.unbind(1)
    return torch.stack([c * x - s * y, s * x + c * y, z, o], 1)


def error(net: UNet, x: Tensor, words: Tensor, cameras: Cameras, eps: Tensor, t: int) -> Tensor:
    """Mean squared error (B,) of the noise that the network predicts."""
    alpha_bar = alpha_bar_schedule()[torch.full((len(x),), t)]
    z_t = add_noise(x, eps, alpha_bar)
    half = has_fast_bfloat16(x.device)
    with torch.no_grad(), torch.autocast("cpu", torch.bfloat16, enabled=half):
        v = net(z_t, torch.full((len(x),), t), words, camera_map(cameras, SIZE // BLOCK))
    return (eps_from_v(v.float(), z_t, alpha_bar) - eps).square().mean((1, 2, 3))


def score_noun(net: UNet, noun: str, views: int, generator: torch.Generator) -> Score:
    """The score on ``views`` fresh objects, one view each, stratified over the azimuth."""
    draw = Draw(generator)
    index = NOUNS.index(noun)
    right = exact = near = 0
    for view in range(views):
        sector = 3 * view % SECTORS  # any number of views is spread around
        azimuth = 360 / SECTORS * sector + draw(-10, 10)
        cameras = Cameras.orbit([azimuth], [draw(5, 40)], draw(2.9, 3.1))
        seen = render(build(noun, "", draw), cameras, SIZE)
        x = torch.cat([seen.normal, 2 * seen.coverage - 1], 1)
        right += _best_noun(net, x, cameras, generator) == index
        steps = _best_turn(net, x, index, cameras, generator)
        exact += steps == 0
        near += steps in (0, 1, SECTORS - 1)
    return Score(noun, views, right, exact, near)


def _best_noun(net: UNet, x: Tensor, cameras: Cameras, generator: torch.Generator) -> int:
    """The index of the noun with the least error: the best few at one time step, then the best of
    these at all time steps."""
    left = torch.arange(len(NOUNS))
    total = torch.zeros(len(NOUNS))
    for i, t in enumerate(reversed(TIMES)):
        words = torch.nn.functional.pad(left[:, None] + 1, (0, SLOTS - 1))
        same = cameras[torch.zeros(len(left), dtype=torch.long)]
        eps = torch.randn(x.shape, generator=generator).expand(len(left), -1, -1, -1)
        total = total + error(net, x.expand_as(eps), words, same, eps, t)
        if i == 0:
            best = total.argsort()[:SCREENED]
            left, total = left[best], total[best]
    return int(left[total.argmin()])


def _best_turn(
    net: UNet, x: Tensor, noun: int, cameras: Cameras, generator: torch.Generator
) -> int:
    turns = torch.arange(SECTORS) * (2 * torch.pi / SECTORS)
    words = torch.tensor([[noun + 1, *[0] * (SLOTS - 1)]]).expand(SECTORS, -1)
    zero = torch.zeros(SECTORS, dtype=torch.long)
    same = cameras[zero]
    turned = Cameras(same.azimuth + turns, same.elevation, same.distance, same.fovy)
    total = torch.zeros(SECTORS)
    for t in TIMES:
        eps = turn_normals(torch.randn(x.shape, generator=generator)[zero], turns)
        total += error(net, turn_normals(x[zero], turns), words, turned, eps, t)
    return int(total.argmin())


@dataclass(frozen=True)
class PaintScore:
    """CIE76 differences, for one noun, of the mean colour of the parts that a colour word sets."""

    noun: str
    delta_e: list[float]  # one a view

    def __str__(self) -> str:
        values = sorted(self.delta_e)
        return f"{self.noun:12} dE median {values[len(values) // 2]:.1f}, worst {values[-1]:.1f}"


PAINT_TIME = 900


def score_paint(net: UNet, noun: str, views: int, generator: torch.Generator) -> PaintScore:
    """The score on ``views`` fresh objects of the noun, with a colour word, from random sides.

    The network gets nearly pure noise, and predicts the picture in one step.
    """
    samples = fresh(views, generator, (noun,))
    index = torch.arange(0, len(samples), VIEWS)  # one view of each object
    captions = Painter().words(samples.noun[index], generator)
    captions[:, 0] = torch.randint(1, 1 + len(COLOR_VALUES), (len(index),), generator=generator)
    captions[:, 2:] = 0  # no pattern
    true, guess = guessed(net, samples, index, captions, generator)
    main = torch.tensor([look.role in "*&" for look in looks(noun).values()])
    painted = (samples.coverage[index, 0] == 255) & main[samples.part[index].long().clamp_min(0)]
    away = [
        (lab_of(guess[k], painted[k]) - lab_of(true[k], painted[k])).norm().item()
        for k in range(len(index))
        if painted[k].any()
    ]
    return PaintScore(noun, away)


def score_pattern(net: UNet, pattern: str, views: int, generator: torch.Generator) -> float:
    """The fraction of the painted colours' variance that the mean picture explains, 1 at best, 0
    for an even colour: the median over ``views`` fresh objects in two very different colours."""
    samples = fresh(views, generator)
    index = torch.arange(0, len(samples), VIEWS)
    row = lambda slot, word: 1 + list(WORDS[slot]).index(word)  # noqa: E731
    words = (row("color", "red"), 0, row("pattern", pattern), row("second", "white"), 0)
    captions = torch.tensor([words]).expand(len(index), -1)
    true, guess = guessed(net, samples, index, captions, generator)
    fractions = []
    for k, sure in enumerate(samples.coverage[index, 0] == 255):
        x = true[k, :3, sure]
        rest = (guess[k, :3, sure] - x).square().sum()
        fractions.append(1 - (rest / (x - x.mean(1, keepdim=True)).square().sum()).item())
    return sorted(fractions)[len(fractions) // 2]


def fresh(objects: int, generator: torch.Generator, nouns: Sequence[str] = NOUNS) -> Samples:
    """Samples of new objects, from a seed that ``generator`` draws."""
    return make(int(torch.randint(2**40, (1,), generator=generator)), objects, nouns)


def guessed(
    net: UNet, samples: Samples, index: Tensor, captions: Tensor, generator: torch.Generator
) -> tuple[Tensor, Tensor]:
    """The painted pictures (N, 4, s, s), and the pictures predicted in one step from nearly pure
    noise."""
    true = Painter().pictures(samples, index, captions, Draw(generator))
    words = torch.cat([samples.noun[index][:, None] + 1, captions], 1)
    surface = torch.cat([samples.pictures(index), samples.points(index)], 1)
    alpha_bar = alpha_bar_schedule()[torch.full((len(index),), PAINT_TIME)]
    z_t = add_noise(true, torch.randn(true.shape, generator=generator), alpha_bar)
    t = torch.full((len(index),), PAINT_TIME)
    with torch.no_grad():
        given = hint(surface, samples.part_maps(index, PARTS), words)
        camera = camera_map(samples.cameras(index), SIZE // BLOCK)
        v = net(z_t, t, words[:, : len(net.config.words)], camera, given)
    return true, x_from_v(v, z_t, alpha_bar)


def lab_of(picture: Tensor, mask: Tensor) -> Tensor:
    """CIE L*a*b* of the mean colour of a painted picture (4, s, s) under the mask."""
    srgb = (picture[:3, mask].mean(1) + 1) / 2
    return lab(srgb_to_linear(srgb.clamp(0, 1))[None])[0]
