"""The prior's network: a small U-Net that predicts v for pictures of 64² in blocks of 2².

Words, the time step and the camera come in by two ways: as an embedding that scales and shifts
every block (FiLM; Perez et al., 2018), and, what makes views obeyed, as a map of the camera plane
next to the picture (``camera_map``).
"""

from dataclasses import dataclass

import torch
import torch.nn.functional as F
from jaxtyping import Float, Int
from torch import Tensor, nn

from core.camera import Cameras

BLOCK = 2  # pixels along an edge that make one position of the U-Net
# A point of the camera plane, then the direction to the camera.
MAP_CHANNELS = 6


@dataclass(frozen=True)
class UNetConfig:
    """Sizes of one network."""

    words: tuple[int, ...]  # number of words in each slot, not counting "not stated"
    widths: tuple[int, ...] = (32, 64, 96, 128)  # channels at 32², 16², 8², 4²
    attention: tuple[bool, ...] = (False, False, True, True)
    code: int = 192  # channels of the embedding of time and words
    picture: int = 4  # channels of the picture
    hint: int = 0  # channels of a picture that is given; 0 is none
    stem: int = 0  # channels of the branch at the picture's full resolution; 0 is none


def camera_map(cameras: Cameras, size: int) -> Float[Tensor, "b 6 s s"]:
    """For each pixel its point on the plane through the origin that faces the camera, in object
    axes, then the direction to the camera. All zeros stand for "no camera given".
    """
    # Pixel centres; row 0 is the top, hence ``up`` with a minus.
    ndc = (torch.arange(size, device=cameras.azimuth.device) + 0.5) / size * 2 - 1
    half = (cameras.distance * (cameras.fovy / 2).tan())[:, None, None, None]
    right, up, back = (row[:, :, None, None] for row in cameras.rotation.unbind(1))
    x, y = ndc[None, None, None, :], -ndc[None, None, :, None]
    if cameras.shift is not None:
        x, y = (
            axis - s[:, None, None, None] for axis, s in zip((x, y), cameras.shift.T, strict=True)
        )
    plane = half * (x * right + y * up)
    return torch.cat([plane, back.expand(-1, -1, size, size)], 1)


def time_features(t: Int[Tensor, " b"], channels: int) -> Float[Tensor, "b c"]:
    """Sines and cosines of the time step (Vaswani et al., 2017, §3.5)."""
    # From 1 to 1e-4 a step: the slowest wave turns by less than a radian over all of the schedule.
    rate = torch.exp(torch.linspace(0, -9.21, channels // 2, device=t.device))
    angle = t[:, None] * rate
    return torch.cat([angle.sin(), angle.cos()], 1)


class Block(nn.Module):
    """Residual block: norm, scale and shift, two convolutions."""

    def __init__(self, inner: int, outer: int, code: int) -> None:
        super().__init__()
        self.norm1 = nn.GroupNorm(8, inner)
        self.conv1 = nn.Conv2d(inner, outer, 3, padding=1)
        self.film = nn.Linear(code, 2 * outer)
        self.norm2 = nn.GroupNorm(8, outer)
        self.conv2 = nn.Conv2d(outer, outer, 3, padding=1)
        self.skip = nn.Conv2d(inner, outer, 1) if inner != outer else nn.Identity()
        for parameter in self.conv2.parameters():  # a block starts as its skip
            nn.init.zeros_(parameter)

    def forward(self, x: Tensor, code: Tensor) -> Tensor:
        """``x`` (B, inner, s, s) and ``code`` (B, code) to (B, outer, s, s)."""
        h = self.conv1(F.silu(self.norm1(x)))
        scale, shift = self.film(code)[:, :, None, None].chunk(2, 1)
        h = self.conv2(F.silu(self.norm2(h) * (1 + scale) + shift))
        return self.skip(x) + h


class Attention(nn.Module):
    """Self-attention over all positions, four heads."""

    def __init__(self, channels: int, heads: int = 4) -> None:
        super().__init__()
        self.heads = heads
        self.norm = nn.GroupNorm(8, channels)
        self.qkv = nn.Linear(channels, 3 * channels)
        self.out = nn.Linear(channels, channels)
        # As a block: it starts as the identity.
        for parameter in self.out.parameters():
            nn.init.zeros_(parameter)

    def forward(self, x: Tensor) -> Tensor:
        """``x`` (B, C, s, s) to the same shape."""
        b, c, height, width = x.shape
        h = self.norm(x).flatten(2).transpose(1, 2)
        heads = self.qkv(h).view(b, -1, 3, self.heads, c // self.heads)
        q, k, v = heads.permute(2, 0, 3, 1, 4).flatten(1, 2)
        # Written out: torch's fused kernel is several times slower backward at these sizes.
        weights = (q @ k.transpose(1, 2) * (c // self.heads) ** -0.5).softmax(-1).to(v.dtype)
        h = (weights @ v).view(b, self.heads, -1, c // self.heads).transpose(1, 2).reshape(b, -1, c)
        return x + self.out(h).transpose(1, 2).reshape(b, c, height, width)


class Stage(nn.Module):
    """A block and, at small sizes, attention."""

    def __init__(self, inner: int, outer: int, code: int, attention: bool) -> None:
        super().__init__()
        self.block = Block(inner, outer, code)
        self.attention = Attention(outer) if attention else nn.Identity()

    def forward(self, x: Tensor, code: Tensor) -> Tensor:
        """As ``Block``."""
        return self.attention(self.block(x, code))


class Stem(nn.Module):
    """A branch at the picture's own resolution, where the U-Net sees blocks of ``BLOCK``².

    It adds to the U-Net's entry and to its exit. Both additions start at zero, so that a network
    trained without the branch is unchanged when it gets one.
    """

    def __init__(self, config: UNetConfig) -> None:
        super().__init__()
        channels, width = config.stem, config.widths[0]
        self.enter = nn.Conv2d(config.picture + config.hint, channels, 3, padding=1)
        self.down = nn.Conv2d(channels * BLOCK**2, width, 1)
        self.up = nn.Conv2d(width, channels * BLOCK**2, 1)
        self.blocks = nn.ModuleList(Block(channels, channels, config.code) for _ in range(2))
        self.norm = nn.GroupNorm(8, channels)
        self.exit = nn.Conv2d(channels, config.picture, 3, padding=1)
        for parameter in (*self.down.parameters(), *self.exit.parameters()):
            nn.init.zeros_(parameter)

    def entry(self, pictures: Tensor) -> tuple[Tensor, Tensor]:
        """Its features (B, stem, s, s), and what it adds to the U-Net's (B, width, s/2, s/2)."""
        fine = self.enter(pictures)
        return fine, self.down(F.pixel_unshuffle(fine, BLOCK))

    def forward(self, fine: Tensor, h: Tensor, code: Tensor) -> Tensor:
        """What it adds to the picture (B, p, s, s); ``h`` is the U-Net's last feature map."""
        fine = fine + F.pixel_shuffle(self.up(h), BLOCK)
        for block in self.blocks:
            fine = block(fine, code)
        return self.exit(F.silu(self.norm(fine)))


class UNet(nn.Module):
    """v of a noisy picture, given words, a camera and, if so built, another picture."""

    def __init__(self, config: UNetConfig) -> None:
        super().__init__()
        self.config = config
        widths, code = config.widths, config.code
        entry = (config.picture + config.hint) * BLOCK**2 + MAP_CHANNELS
        self.words = nn.ModuleList(nn.Embedding(count + 1, code) for count in config.words)
        self.time = nn.Sequential(nn.Linear(code, code), nn.SiLU(), nn.Linear(code, code))
        self.mix = nn.Sequential(nn.SiLU(), nn.Linear(code, code), nn.SiLU())
        self.entry = nn.Conv2d(entry, widths[0], 3, padding=1)
        self.down, self.shrink = nn.ModuleList(), nn.ModuleList()
        inner = widths[0]
        for i, (width, attention) in enumerate(zip(widths, config.attention, strict=True)):
            self.down.append(Stage(inner, width, code, attention))
            last = i == len(widths) - 1
            self.shrink.append(
                nn.Identity() if last else nn.Conv2d(width, width, 3, stride=2, padding=1)
            )
            inner = width
        self.middle = Stage(inner, inner, code, config.attention[-1])
        # Two blocks at each size on the way up, one on the way down.
        self.up, self.refine, self.grow = nn.ModuleList(), nn.ModuleList(), nn.ModuleList()
        for i in reversed(range(len(widths))):
            width, attention = widths[i], config.attention[i]
            self.up.append(Stage(inner + width, width, code, attention))
            self.refine.append(Stage(width, width, code, attention=False))
            below = widths[max(i - 1, 0)]
            self.grow.append(nn.Identity() if i == 0 else nn.Conv2d(width, below, 3, padding=1))
            inner = below
        self.norm = nn.GroupNorm(8, widths[0])
        self.exit = nn.Conv2d(widths[0], config.picture * BLOCK**2, 3, padding=1)
        self.stem = Stem(config) if config.stem else None
        # A quarter faster on a CPU with bfloat16 units. Not in torch's stubs.
        self.to(memory_format=torch.channels_last)  # pyright: ignore[reportCallIssue]

    def code(self, t: Int[Tensor, " b"], words: Int[Tensor, "b n"]) -> Float[Tensor, "b c"]:
        """The embedding of the time step and the words; word 0 of a slot is "not stated"."""
        # Words add up: each slot moves the same embedding, "not stated" with a learnt row of its
        # own.
        code = self.time(time_features(t, self.config.code))
        for slot, embedding in enumerate(self.words):
            code = code + embedding(words[:, slot])
        return self.mix(code)

    def forward(
        self,
        z: Float[Tensor, "b p s s"],
        t: Int[Tensor, " b"],
        words: Int[Tensor, "b n"],
        camera: Float[Tensor, "b 6 m m"],
        hint: Float[Tensor, "b h s s"] | None = None,
    ) -> Float[Tensor, "b p s s"]:
        """``camera`` is ``camera_map`` at half the picture's size."""
        pictures = z if hint is None else torch.cat([z, hint], 1)
        # ENTRY: all pictures in blocks of pixels, next to the map of the camera plane
        code = self.code(t, words)
        h = self.entry(torch.cat([F.pixel_unshuffle(pictures, BLOCK), camera], 1))
        fine = None
        if self.stem is not None:
            fine, more = self.stem.entry(pictures)
            h = h + more
        # DOWN: each size's last features are kept for the way up
        skips = []
        for down, shrink in zip(self.down, self.shrink, strict=True):
            h = down(h, code)
            skips.append(h)
            h = shrink(h)
        # MIDDLE AND UP: the same sizes in reverse, each with what was kept of it
        h = self.middle(h, code)
        for up, refine, grow in zip(self.up, self.refine, self.grow, strict=True):
            h = refine(up(torch.cat([h, skips.pop()], 1), code), code)
            if not isinstance(grow, nn.Identity):
                h = grow(F.interpolate(h, scale_factor=2.0))
        # EXIT: from blocks back to pixels
        h = F.silu(self.norm(h))
        out = F.pixel_shuffle(self.exit(h), BLOCK)
        return out if self.stem is None or fine is None else out + self.stem(fine, h, code)
