"""The solid that words mean, from a short code: each part's signed distance, of any point.

A latent vector, the code, selects one of all objects of the words. A decoder turns both into
features on the three coordinate planes (triplanes: Chan et al. 2022, "EG3D", §4), and a small MLP
reads a point's distances from its three projections. It is the decoder of a conditional
variational autoencoder (``core.prior.solid_training``), whose codes are normal. Unlike the
pictures' networks it knows the whole object at once, so that no two views can disagree.

Each part is a solid of its own and the object their union, as in the families: a robot's eye, which
stands out of its head by a hundredth, is a ball and no dent, and where parts meet there is an edge.
"""

from dataclasses import dataclass
from typing import NamedTuple

import torch
import torch.nn.functional as F
from jaxtyping import Bool, Float, Int
from torch import Tensor, nn

PLANES = ((0, 1), (0, 2), (1, 2))  # the coordinate axes of each: its rows, its columns
BASE = 8  # side of the first features
OWN_SCALE = 5.0  # of a noun's own features: how much faster than the rest they are learnt
SCALE = 10.0  # what the network calls 1 is 0.1 training units: about what it was trained to know
PARTS = 8  # of one noun, at most
FOLD = 0.015  # in [-1, 1]: how near to a plane of symmetry the two sides are drawn together


@dataclass(frozen=True)
class SolidNetConfig:
    """Sizes of the decoder."""

    # Number of words in the slots noun, shape and part, not counting "not stated", then of kinds.
    words: tuple[int, int, int, int]
    latent: int = 32  # numbers of a code
    embedding: int = 256  # channels of words and code together
    # Channels of the planes: of the base at 8², after the first block at 16², the second and the
    # last at 32². A finer plane is dear, and the MLP reads the values between its features.
    widths: tuple[int, int, int, int] = (64, 48, 32, 24)
    # Channels of the planes of 64², a sub-pixel convolution (Shi et al. 2016) of the last: a
    # robot's eye is one and a half cells of 32² wide.
    fine: int = 12
    hidden: int = 96  # units of the MLP


KINDS = 4  # of a noun
KIND_WIDTH = 16  # channels of a kind's own features, which are added to the first of the noun's


class Triplane(NamedTuple):
    """Features of one batch of objects."""

    planes: list[Float[Tensor, "b c s s"]]  # of PLANES
    fine: list[Float[Tensor, "b d t t"]]  # the same, twice as fine
    embedding: Float[Tensor, "b e"]
    mirrored: Bool[Tensor, "b 2"]


class PlaneBlock(nn.Module):
    """Two convolutions, scaled and shifted by the embedding between them."""

    def __init__(self, inner: int, outer: int, embedding: int, reach: int = 3) -> None:
        """``reach``: of the second convolution, 1 or 3."""
        super().__init__()
        self.conv = nn.Conv2d(inner, outer, 3, padding=1)
        self.norm = nn.GroupNorm(8, outer)
        self.film = nn.Linear(embedding, 2 * outer)
        self.conv2 = nn.Conv2d(outer, outer, reach, padding=reach // 2)
        self.skip = nn.Conv2d(inner, outer, 1) if inner != outer else nn.Identity()
        for parameter in self.film.parameters():
            nn.init.zeros_(parameter)

    def forward(self, x: Tensor, embedding: Tensor) -> Tensor:
        """``x`` (B, inner, s, s) to (B, outer, s, s)."""
        scale, shift = self.film(embedding)[:, :, None, None].chunk(2, 1)
        h = self.norm(self.conv(x)) * (1 + scale) + shift
        return self.skip(x) + self.conv2(F.silu(h))


class SolidNet(nn.Module):
    """Words and a code to a solid.

    A noun has KINDS kinds, such as tables of one leg and of four: a mean of both is no table. The
    last of the words is the kind, ``KINDS * (noun's row - 1) + 1`` and the following.
    """

    counts: Tensor
    mirrored: Tensor

    def __init__(self, config: SolidNetConfig) -> None:
        super().__init__()
        self.config = config
        size, widths, hidden = config.embedding, config.widths, config.hidden
        self.words = nn.ModuleList(nn.Embedding(count + 1, size) for count in config.words)
        self.entry = nn.Linear(config.latent, size)
        self.mix = nn.Sequential(
            nn.SiLU(), nn.Linear(size, size), nn.SiLU(), nn.Linear(size, size), nn.SiLU()
        )
        self.base = nn.Linear(size, len(PLANES) * widths[0] * BASE**2)
        # A noun's own features at 16², next to what all nouns share: the form of a thing is learnt
        # where it is, and what varies by the code.
        pixels = len(PLANES) * (2 * BASE) ** 2
        self.own = nn.Embedding(config.words[0] + 1, pixels * widths[1])
        self.kind = nn.Embedding(config.words[3] + 1, pixels * KIND_WIDTH)
        for table in (self.own, self.kind, self.words[3]):  # pyright: ignore[reportGeneralTypeIssues]
            nn.init.zeros_(table.weight)
        # How many of the training's objects are of each kind, by the shape's and the part's words.
        self.register_buffer("counts", torch.zeros([count + 1 for count in config.words[1:]]))
        # Which kinds are the same on both sides of the planes x = 0 and y = 0.
        self.register_buffer("mirrored", torch.zeros(config.words[3] + 1, 2, dtype=torch.bool))
        # A block for each plane; the first ones see the two other planes too.
        inner, reach = (3 * widths[0], widths[1], widths[2]), (3, 3, 1)
        self.blocks = nn.ModuleList(
            nn.ModuleList(PlaneBlock(a, b, size, r) for _ in PLANES)
            for a, b, r in zip(inner, widths[1:], reach, strict=True)
        )
        self.fine = nn.ModuleList(
            nn.Conv2d(widths[-1], 4 * config.fine, 3, padding=1) for _ in PLANES
        )
        self.point = nn.Linear(len(PLANES) * (widths[-1] + config.fine) + 3, hidden)
        self.point_code = nn.Linear(size, hidden)
        self.layers = nn.ModuleList(nn.Linear(hidden, hidden) for _ in range(2))
        self.exit = nn.Linear(hidden, PARTS)
        # A quarter faster on a CPU with bfloat16 units. Not in torch's stubs.
        self.to(memory_format=torch.channels_last)  # pyright: ignore[reportCallIssue]

    def embedding(self, words: Int[Tensor, "b n"]) -> Float[Tensor, "b e"]:
        """The sum of the words' embeddings; word 0 of a slot is "not stated"."""
        rows = [table(words[:, slot]) for slot, table in enumerate(self.words)]
        return torch.stack(rows).sum(0)

    def triplane(self, words: Int[Tensor, "b n"], code: Float[Tensor, "b l"]) -> Triplane:
        """The features of the objects, to be read at any number of points."""
        embedding = self.mix(self.embedding(words) + self.entry(code))
        base = self.base(embedding).view(len(words), len(PLANES), -1, BASE, BASE)
        planes = list(base.unbind(1))
        first, second, last = self.blocks
        # 16²: with the other planes, and the noun's own features
        given = with_others([F.interpolate(plane, scale_factor=2.0) for plane in planes])
        own = self._own(words)
        planes = [
            block(x, embedding) + OWN_SCALE * more
            for block, x, more in zip(first, given, own.unbind(1), strict=True)
        ]
        # 32²: each plane by itself
        planes = [F.interpolate(plane, scale_factor=2.0) for plane in planes]
        for row in (second, last):
            planes = [block(x, embedding) for block, x in zip(row, planes, strict=True)]
        fine = [F.pixel_shuffle(F.silu(c(p)), 2) for c, p in zip(self.fine, planes, strict=True)]
        return Triplane(planes, fine, embedding, self.mirrored[words[:, 3]])

    def _own(self, words: Int[Tensor, "b n"]) -> Float[Tensor, "b 3 c m m"]:
        """The features of the nouns and of their kinds."""
        noun, kind = (
            table(words[:, slot]).view(len(words), len(PLANES), -1, 2 * BASE, 2 * BASE)
            for table, slot in ((self.own, 0), (self.kind, 3))
        )
        return torch.cat([noun[:, :, :KIND_WIDTH] + kind, noun[:, :, KIND_WIDTH:]], 2)

    def at(self, triplane: Triplane, points: Float[Tensor, "b n 3"]) -> Float[Tensor, "b n 8"]:
        """The parts' signed distances (times SCALE) at points in [-1, 1]³; the whole has the least.

        One side of a mirrored object is used for both.
        """
        points = folded(points, triplane.mirrored)
        features = [_read(triplane.planes, points), points, _read(triplane.fine, points)]
        h = self.point(torch.cat(features, -1))
        h = F.silu(h + self.point_code(triplane.embedding)[:, None])
        for layer in self.layers:
            h = h + F.silu(layer(h))
        return self.exit(h).float()


def folded(points: Float[Tensor, "b n 3"], mirrored: Bool[Tensor, "b 2"]) -> Float[Tensor, "b n 3"]:
    """The points on the positive side of the planes that mirror their object, x = 0 and y = 0;
    smoothly, so that there is no crease where the sides meet."""
    side = (points[..., :2].square() + FOLD**2).sqrt() - FOLD
    across = torch.where(mirrored[:, None], side, points[..., :2])
    return torch.cat([across, points[..., 2:]], -1)


def _read(
    planes: list[Float[Tensor, "b c s s"]], points: Float[Tensor, "b n 3"]
) -> Float[Tensor, "b n _"]:
    """The planes' features at the points' projections, side by side."""
    features = []
    for plane, (row, column) in zip(planes, PLANES, strict=True):
        # grid_sample's first coordinate runs along the columns.
        at = points[:, None, :, [column, row]].float()
        found = F.grid_sample(plane.float(), at, align_corners=False, padding_mode="border")
        features.append(found[:, :, 0].transpose(1, 2))
    return torch.cat(features, -1)


def with_others(planes: list[Float[Tensor, "b c s s"]]) -> list[Float[Tensor, "b _ s s"]]:
    """Each plane next to the others' means along the axis that it lacks (rolled out: Wang et al.
    2023, "Rodin", §3.2): a row of one is the same row of another."""
    xy, xz, yz = planes
    rows, columns = (lambda m: m[..., None].expand_as(xy)), (lambda m: m[:, :, None].expand_as(xy))
    return [
        torch.cat([xy, rows(xz.mean(3)), columns(yz.mean(3))], 1),
        torch.cat([xz, rows(xy.mean(3)), columns(yz.mean(2))], 1),
        torch.cat([yz, rows(xy.mean(2)), columns(xz.mean(2))], 1),
    ]
