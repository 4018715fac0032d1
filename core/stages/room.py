"""How many views of a step are rendered together: as many as a GPU's free memory holds."""

import math
from typing import NamedTuple

import torch

from core.camera import CameraConfig
from core.guidance.stable_diffusion.memory import available_bytes

RESERVE = 1.25  # fragments of the allocator, the kernels' work space
HOLDS = 0.9  # training units: the radius of the sphere around the object


class Render(NamedTuple):
    """Bytes that views and the way of their gradient back take, in plain torch.

    Fitted to the tensors that are alive at once with 1 to 6 views of 256² and 512² of balls of
    8,192 to 131,072 faces.
    """

    base: float  # however many views there are
    pixel: float
    covered: float  # for each pixel that shows the object, on top


# 170 bytes a face: of 100,000.
NORMALS = Render(base=17e6, pixel=64, covered=149)
# The hash grid's gradient, and one part of the points computed again (core.appearance.shade.CHUNK).
LIT = Render(base=250e6, pixel=60, covered=272)


def covered_fraction(cameras: CameraConfig) -> float:
    """The most of a picture that the sphere around the object covers: from the nearest camera with
    the longest lens."""
    half_picture = math.tan(math.radians(cameras.fovy_deg[0]) / 2)
    half_sphere = math.tan(math.asin(min(HOLDS / cameras.distance[0], 1 - 1e-6)))
    return min(math.pi / 4 * (half_sphere / half_picture) ** 2, 1.0)


def render_bytes(kind: Render, views: int, size: int, cameras: CameraConfig) -> float:
    """Bytes of ``views`` pictures of ``size`` pixels, rendered together with their gradient."""
    pixel = kind.pixel + kind.covered * covered_fraction(cameras)
    return kind.base + views * size**2 * pixel


def views_that_fit(
    kind: Render,
    most: int,
    size: int,
    cameras: CameraConfig,
    device: torch.device,
    *,
    busy: int = 0,
    together: int = 1,
) -> int:
    """The most views of ``size`` pixels that a GPU holds at a time, no more than ``most``.

    Elsewhere ``most``: what a run makes does not depend on what else a computer does.

    Args:
        busy: bytes that the guidance takes while the views are there.
        together: views that stay together; there is always room for these.
    """
    if device.type != "cuda":
        return most
    room = available_bytes(device) / RESERVE - busy
    one = render_bytes(kind, 1, size, cameras) - kind.base
    fit = max(math.floor((room - kind.base) / one), 0) // together * together
    return min(max(fit, together), most)
