"""A finished shape in a style: low poly, or voxels. Not of the paper.

A style is stated by the prompt, as far as the guidance reads it, or set (``geometry.style``). Its
faces are shaded flat, and its colours are plain: no grain, no rounded edges.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import get_args

import torch
from jaxtyping import Bool, Float, Int
from scipy.spatial import KDTree
from torch import Tensor

from core.config import Config, GeometryConfig, Style
from core.geometry.mesh import Mesh
from core.geometry.voxels import squares_of, voxelised
from core.guidance.guidance import Areas
from core.texture.low_poly import low_poly

TEXELS = 4  # along the place of a square in the texture, at least
SAMPLES = 3  # along a square, to find its area
DEPTHS = (0.0, 0.4)  # cubes below it
NO_STYLE = "{style}: left out, as the mesh is yours; a style changes shapes that are made here."


def style_of(config: GeometryConfig, stated: str) -> Style:
    """The style of a shape whose prompt states ``stated``."""
    known = {style: style for style in get_args(Style)}
    return config.style if config.style != "stated" else known.get(stated, "none")


def in_style(config: Config, style: Style) -> Config:
    """``config`` with the style decided, and what goes with it."""
    config = replace(config, geometry=replace(config.geometry, style=style))
    return config if style == "none" else plain(config)


def plain(config: Config) -> Config:
    """``config`` for a flat mesh: plain colours and sharp edges."""
    appearance = replace(config.appearance, detail=0.0, evenness=1.0)
    return replace(config, appearance=appearance, texture=replace(config.texture, edge_radius=0.0))


def styled(shape: Mesh, config: Config, check: Callable[[], None]) -> Mesh:
    """``shape`` in its style; itself without one. ``check`` as that of :func:`low_poly`."""
    wanted, most_faces = config.geometry, config.texture.max_faces
    if wanted.style == "low_poly":
        return low_poly(shape, wanted.facet_error, most_faces, check)
    if wanted.style == "voxels":
        with_texels = 2 * (config.texture.size // TEXELS) ** 2
        return voxelised(shape, wanted.voxels, min(most_faces, with_texels))
    return shape


class SquareAreas(Areas):
    """The areas of a voxelised mesh: each of its squares is of one, and takes its material from one
    place."""

    def __init__(self, areas: Areas, mesh: Mesh) -> None:
        """``areas``: of the solid before."""
        self.areas = areas
        self.each = tuple(one._replace(level=True) for one in areas.each)
        self.middles, outward = (x.cpu() for x in squares_of(mesh))
        a, b, c = mesh.verts[mesh.faces[::2]].cpu().unbind(1)
        steps = (torch.arange(SAMPLES) + 0.5) / SAMPLES
        found = [
            areas.of(a + i * (b - a) + j * (c - b) - depth * outward)
            for i in steps.tolist()
            for j in steps.tolist()
            for depth in DEPTHS
        ]
        self.own = torch.stack(found).mode(0).values
        self._tree = KDTree(self.middles.numpy())

    def _square(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        return torch.from_numpy(self._tree.query(points.detach().cpu().numpy())[1])

    def of(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """That of the square that each place is on."""
        return self.own[self._square(points)]

    def certain(
        self, points: Float[Tensor, "n 3"], reach: float
    ) -> tuple[Int[Tensor, " n"], Bool[Tensor, " n"]]:
        """A texel is within its square."""
        del reach
        return self.of(points), torch.ones(len(points), dtype=torch.bool)

    def inside(self, points: Float[Tensor, "n 3"], area: Int[Tensor, " n"]) -> Float[Tensor, "n 3"]:
        """The square's middle, or the place from which that takes its material."""
        return self.areas.inside(self.middles[self._square(points)].to(points), area)

    def slope(
        self,
        points: Float[Tensor, "n 3"],
        normals: Float[Tensor, "n 3"],
        area: Int[Tensor, " n"],
        step: float,
    ) -> Float[Tensor, "n 3"]:
        """None: squares are flat."""
        del normals, area, step
        return torch.zeros_like(points)

    def nearest(self) -> Int[Tensor, "k k k"]:
        """The solid's."""
        return self.areas.nearest()


def styled_areas(areas: Areas | None, mesh: Mesh, config: GeometryConfig) -> Areas | None:
    """The areas of the shape in its style."""
    return SquareAreas(areas, mesh) if areas and config.style == "voxels" else areas
