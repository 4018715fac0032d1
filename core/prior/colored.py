"""Training pictures of the appearance network: the data's objects, painted and lit on the fly.

The light and the shading are the renderer's, so that the material which score distillation finds
under them is the one that the words mean.
"""

import torch
from jaxtyping import Float
from torch import Tensor
from torch.nn.functional import avg_pool2d, interpolate, normalize

from core.appearance.environment import Environment, load_light
from core.appearance.shade import shade
from core.guidance.builtin.nouns import NOUNS as KNOWN
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.ops import linear_to_srgb
from core.prior.data import NOUNS, Samples
from core.prior.draw import Draw
from core.prior.paint import Caption, coat, paint

NO_COLOR = 0.35  # fraction of captions without a colour
NO_MATERIAL = 0.55
NO_PATTERN = 0.55
NO_SECOND = 0.35  # of the captions with a pattern
DENTS = 0.35  # the deepest, as the normal's offset
NO_TARGET = 0.6  # of the captions without a pattern
CAPTION_SLOTS = ("color", "material", "pattern", "second", "target")


class Painter:
    """Colours for samples, under the default light from any side."""

    def __init__(self) -> None:
        self.environment = Environment.of(load_light("studio"))
        self.tables = [["", *SLOTS[slot]] for slot in CAPTION_SLOTS]
        names = self.tables[-1]
        own = [list(KNOWN[noun].looks) for noun in NOUNS]
        self.parts = [[names.index(p) for p in parts] if len(parts) > 1 else [0] for parts in own]

    def words(self, nouns: Tensor, generator: torch.Generator) -> Tensor:
        """Random captions (N, 5) for objects of ``nouns`` (N,), indices: rows of the embeddings of
        ``CAPTION_SLOTS``."""
        count = len(nouns)
        rows = [torch.randint(1, len(t), (count,), generator=generator) for t in self.tables[:-1]]
        color, _, _, second = rows
        chance = torch.rand(6, count, generator=generator)
        patterned = chance[2] >= NO_PATTERN
        chosen = (chance[0] >= NO_COLOR, chance[1] >= NO_MATERIAL, patterned)
        target = self._targets(nouns, chance[5]) * (~patterned & (chance[4] >= NO_TARGET))
        # A second colour shows in a pattern or on one part, and only where it is another one.
        with_second = (patterned & (chance[3] >= NO_SECOND) | (target > 0)) & (second != color)
        rows.append(target)
        return torch.stack(rows, 1) * torch.stack([*chosen, with_second, with_second], 1)

    def _targets(self, nouns: Tensor, chance: Tensor) -> Tensor:
        """The row of a random part for each noun; 0 (none) where the noun has one part."""
        rows = [self.parts[noun] for noun in nouns.tolist()]
        return torch.tensor([own[int(c * len(own))] for own, c in zip(rows, chance, strict=True)])

    def pictures(
        self,
        samples: Samples,
        index: Tensor,
        words: Tensor,
        draw: Draw,
        normals: Tensor | None = None,
    ) -> Tensor:
        """[(2 srgb - 1) * o, 2o - 1] (N, 4, s, s) of the samples ``index`` in these words.

        ``normals`` (N, 3, s, s) are lit in place of the samples' own.
        """
        coverage = samples.coverage[index].float() / 255
        seen = (coverage[:, 0] > 0).flatten().nonzero().squeeze(1)
        normal = _pixels(samples.normal[index].float() if normals is None else normals, seen)
        point = _pixels(samples.point[index].float() / 120, seen)
        part = samples.part[index].flatten()[seen].long().clamp_min(0)
        which = seen // coverage[0].numel()
        normal = normalize(normal, dim=1)
        view = normalize(samples.cameras(index).eye[which] - point, dim=1)
        view = _above_horizon(normal, view)

        surface = []
        for k, row in enumerate(index.tolist()):
            caption = [table[i] for table, i in zip(self.tables, words[k].tolist(), strict=True)]
            paints = coat(NOUNS[int(samples.noun[row])], Caption(*caption), draw)
            mine = which == k
            surface.append(paint(paints, part[mine], point[mine], normal[mine]))
        kd, roughness, metallic = (torch.cat(column) for column in zip(*surface, strict=True))

        # Turning the object against the light is turning the light against the object.
        turn = torch.rand(len(index), generator=draw.generator)[which] * (2 * torch.pi)
        light = shade(
            _turned(normal, turn), _turned(view, turn), kd, roughness, metallic, self.environment
        )
        rgb = torch.zeros(coverage.numel(), 3)
        rgb[seen] = 2 * linear_to_srgb(light.clamp(0, 1)) - 1
        rgb = rgb.view(len(index), *coverage.shape[2:], 3).permute(0, 3, 1, 2)
        return torch.cat([rgb * coverage, 2 * coverage - 1], 1)


def lumpy(
    normals: Float[Tensor, "n 3 s s"], generator: torch.Generator
) -> Float[Tensor, "n 3 s s"]:
    """Normals weighted by coverage, half of the pictures with soft dents.

    Distilled meshes have them, and the colours must not depend on them.
    """
    count, _, size, _ = normals.shape
    depth = DENTS * torch.rand(count, 1, 1, 1, generator=generator)
    depth = depth * (torch.rand(count, 1, 1, 1, generator=generator) < 0.5)
    dents = torch.randn(count, 3, size // 8, size // 8, generator=generator)
    dents = interpolate(dents, (size, size), mode="bicubic", align_corners=False)
    weight = normals.norm(dim=1, keepdim=True)
    return normalize(normals + depth * dents * weight, dim=1) * weight


def blurred(parts: Float[Tensor, "n k s s"], generator: torch.Generator) -> Tensor:
    """Part maps, in half of which the borders between parts are two pixels wide or more: a trained
    shape's borders are not known exactly."""
    inside = parts.sum(1, keepdim=True)
    soft = parts
    for _ in range(2):
        soft = avg_pool2d(soft, 3, stride=1, padding=1, count_include_pad=False) * inside
    soft = soft / soft.sum(1, keepdim=True).clamp_min(1e-6)
    amount = torch.rand(len(parts), 1, 1, 1, generator=generator)
    amount = amount * (torch.rand(len(parts), 1, 1, 1, generator=generator) < 0.5)
    return torch.lerp(parts, soft, amount)


def _pixels(pictures: Tensor, seen: Tensor) -> Tensor:
    return pictures.permute(0, 2, 3, 1).reshape(-1, pictures.shape[1])[seen]


def _turned(vectors: Tensor, angle: Tensor) -> Tensor:
    x, y, z = vectors.unbind(1)
    c, s = angle.cos(), angle.sin()
    return torch.stack([c * x - s * y, s * x + c * y, z], 1)


def _above_horizon(normal: Tensor, view: Tensor) -> Tensor:
    """The view, bent up where a pixel's mean normal at an edge looks away from it."""
    below = (0.05 - (normal * view).sum(1, keepdim=True)).clamp_min(0)
    return normalize(view + below * normal, dim=1)
