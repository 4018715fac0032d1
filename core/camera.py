"""Cameras on a sphere about the origin.

World: right-handed, +Z up, the object's front faces -Y. Camera: x right, y up, looks along -z
(OpenGL). Azimuth 0 is at -Y and grows counter-clockwise seen from above (90 degrees at +X).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Annotated, Literal

import torch
from jaxtyping import Float
from torch import Tensor

from core.device import sent
from core.ranges import Range

NEAR, FAR = 0.1, 10.0


@dataclass(frozen=True)
class Cameras:
    """A batch of perspective cameras that look at the origin; angles in radians."""

    azimuth: Float[Tensor, " b"]
    elevation: Float[Tensor, " b"]
    distance: Float[Tensor, " b"]
    fovy: Float[Tensor, " b"]
    # Where the origin is in a square picture, x right and y up, its edges at -1 and 1 (a lens
    # shift). None: in the middle.
    shift: Float[Tensor, "b 2"] | None = None

    @classmethod
    def orbit(
        cls,
        azimuth_deg: "list[float] | Tensor",
        elevation_deg: "list[float] | Tensor",
        distance: float = 3.0,
        fovy_deg: float = 40.0,
    ) -> "Cameras":
        """Cameras from degrees; one distance and one vertical field of view for all."""
        azimuth = torch.as_tensor(azimuth_deg, dtype=torch.float32).deg2rad()
        elevation = torch.as_tensor(elevation_deg, dtype=torch.float32).deg2rad()
        azimuth, elevation = torch.broadcast_tensors(azimuth, elevation)
        full = torch.full_like(azimuth, math.radians(fovy_deg))
        return cls(azimuth, elevation, torch.full_like(azimuth, distance), full)

    def __len__(self) -> int:
        return len(self.azimuth)

    def __getitem__(self, index: "slice | Tensor") -> "Cameras":
        return self._each(lambda tensor: tensor[index])

    def to(self, device: "torch.device | str") -> "Cameras":
        """The same cameras on ``device``."""
        return self._each(lambda tensor: sent(tensor, device))

    def _each(self, change: Callable[[Tensor], Tensor]) -> "Cameras":
        return Cameras(**{name: change(tensor) for name, tensor in self.tensors().items()})

    def tensors(self) -> dict[str, Tensor]:
        """The fields that are set, by name."""
        return {name: tensor for name, tensor in vars(self).items() if tensor is not None}

    def close_up(self, center: Float[Tensor, "b 2"], zoom: Float[Tensor, " b"]) -> "Cameras":
        """The part of each picture about ``center`` (as ``shift``), ``zoom`` times as large: from
        the same place, so in the same perspective."""
        fovy = 2 * ((self.fovy / 2).tan() / zoom).atan()
        before = 0 if self.shift is None else self.shift
        return replace(self, fovy=fovy, shift=(before - center) * zoom[:, None])

    @property
    def back(self) -> Float[Tensor, "b 3"]:
        """Unit vector from the origin to the camera: its +z axis."""
        a, e = self.azimuth, self.elevation
        return torch.stack([a.sin() * e.cos(), -a.cos() * e.cos(), e.sin()], -1)

    @property
    def eye(self) -> Float[Tensor, "b 3"]:
        """Position in the world."""
        return self.distance[:, None] * self.back

    @property
    def rotation(self) -> Float[Tensor, "b 3 3"]:
        """World to camera; rows are right, up, back. Defined at the poles too."""
        a, e = self.azimuth, self.elevation
        right = torch.stack([a.cos(), a.sin(), torch.zeros_like(a)], -1)
        up = torch.stack([-a.sin() * e.sin(), a.cos() * e.sin(), e.cos()], -1)
        return torch.stack([right, up, self.back], 1)

    @property
    def w2c(self) -> Float[Tensor, "b 4 4"]:
        """World to camera, homogeneous."""
        matrix = torch.zeros(len(self), 4, 4, dtype=self.azimuth.dtype, device=self.azimuth.device)
        matrix[:, :3, :3] = self.rotation
        matrix[:, 2, 3] = -self.distance
        matrix[:, 3, 3] = 1
        return matrix

    def projection(self, aspect: float = 1.0) -> Float[Tensor, "b 4 4"]:
        """OpenGL perspective matrix; ``aspect`` is width over height."""
        focal = 1 / (self.fovy / 2).tan()
        matrix = torch.zeros(len(self), 4, 4, dtype=self.azimuth.dtype, device=self.azimuth.device)
        matrix[:, 0, 0] = focal / aspect
        matrix[:, 1, 1] = focal
        matrix[:, 2, 2] = -(FAR + NEAR) / (FAR - NEAR)
        matrix[:, 2, 3] = -2 * FAR * NEAR / (FAR - NEAR)
        matrix[:, 3, 2] = -1
        if self.shift is not None:  # times z, which the division by w = -z turns round
            matrix[:, :2, 2] = -self.shift
        return matrix

    @property
    def mvp(self) -> Float[Tensor, "b 4 4"]:
        """World to clip space of a square picture."""
        return self.projection() @ self.w2c


@dataclass(frozen=True, kw_only=True)
class CameraConfig:
    """The distribution that a training draws its cameras from."""

    # Uniform, training units; nearer than the object's cube the camera would be in it.
    distance: Annotated[tuple[float, float], Range(1.5, 9.0, rising=True)] = (3.0, 3.0)
    fovy_deg: Annotated[tuple[float, float], Range(1, 170, rising=True)] = (40.0, 40.0)  # uniform
    elevation_deg: Annotated[tuple[float, float], Range(-90, 90, rising=True)] = (-20.0, 78.0)
    elevation: Literal["sphere", "angle"] = "sphere"  # what is uniform: the sine, or the angle
    azimuth_jitter: Annotated[float, Range(0, 1)] = (
        1.0  # fraction of a stratum; the strata fill the circle
    )


def sample_cameras(n: int, config: CameraConfig, generator: torch.Generator) -> Cameras:
    """``n`` cameras, their azimuth stratified over the batch, so that all sides are seen.

    Source: paper, "Implementation Details" (uniform on the sphere); the released code's strata.
    """

    def uniform(low: float, high: float) -> Tensor:
        return low + (high - low) * torch.rand(n, generator=generator)

    start = torch.rand(1, generator=generator)
    jitter = 0.5 + (torch.rand(n, generator=generator) - 0.5) * config.azimuth_jitter
    azimuth = 2 * math.pi * ((torch.arange(n) + jitter) / n + start)
    low, high = (math.radians(x) for x in config.elevation_deg)
    if config.elevation == "sphere":
        elevation = uniform(math.sin(low), math.sin(high)).asin()
    else:
        elevation = uniform(low, high)
    elevation = elevation[torch.randperm(n, generator=generator)]
    return Cameras(
        azimuth, elevation, uniform(*config.distance), torch.deg2rad(uniform(*config.fovy_deg))
    )


def sample_groups(
    n: int, together: int, config: CameraConfig, generator: torch.Generator
) -> Cameras:
    """``n`` cameras in groups of ``together``, one after another: the same but for the azimuth,
    whose steps fill the circle. Groups of one are :func:`sample_cameras`."""
    first = sample_cameras(n // together, config, generator)
    index = torch.arange(n // together).repeat_interleave(together)
    turn = 2 * math.pi / together * (torch.arange(n) % together)
    group = first[index]
    return Cameras(group.azimuth + turn, group.elevation, group.distance, group.fovy)


ZOOM = (1.4, 3.5)  # of close-ups; a whole object fills about half of a picture's side


def aimed(
    cameras: Cameras, coverage: Float[Tensor, "b s s"], generator: torch.Generator
) -> Cameras:
    """Close-ups of what the ``coverage`` of whole pictures shows, each about a random place."""
    count, size, _ = coverage.shape
    zoom = ZOOM[0] * (ZOOM[1] / ZOOM[0]) ** torch.rand(count, generator=generator)
    # Antialiasing may leave a coverage a hair below 0. Nothing in sight: anywhere.
    weight = coverage.flatten(1).cpu().clamp_min(0) + 1e-9
    place = torch.multinomial(weight, 1, generator=generator)[:, 0]
    column, row = place % size, place // size
    center = torch.stack([column + 0.5, size - row - 0.5], 1) / size * 2 - 1
    return cameras.close_up(center.to(cameras.azimuth), zoom.to(cameras.azimuth))
