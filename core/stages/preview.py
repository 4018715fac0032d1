"""Small pictures and a light mesh of what a training has so far, for whoever watches the run."""

import time

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.asset import write_plain_obj
from core.camera import Cameras
from core.render.normals import render_normals
from core.run_folder import PREVIEW_SECONDS, RunFolder
from core.texture.images import write_png

SIZE = 256  # pixels
VIEW = {"azimuth_deg": [30.0], "elevation_deg": [20.0]}


class ShapePreview:
    """Shows the geometry training's shape as normals, and as a mesh in training units."""

    def __init__(self, run: RunFolder) -> None:
        self._run = run
        self._shown = -PREVIEW_SECONDS

    def show(self, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> None:
        """Write the two previews if the last ones are old enough."""
        if time.perf_counter() - self._shown < PREVIEW_SECONDS:
            return
        cameras = Cameras.orbit(**VIEW).to(verts.device)
        n, o = render_normals(verts, faces, cameras, SIZE, "camera")
        write_png(self._run.preview_path("normals.png"), over_grey((n[0] + o[0]) / 2, o[0]))
        write_plain_obj(self._run.preview_path("shape.obj"), verts, faces)
        self._run.say("preview", stage="geometry", path="preview/normals.png")
        self._run.say("preview", stage="geometry", path="preview/shape.obj")
        self._shown = time.perf_counter()


class ColorPreview:
    """Shows the appearance training's asset as it is lit."""

    def __init__(self, run: RunFolder) -> None:
        self._run = run
        self._shown = -PREVIEW_SECONDS

    @property
    def due(self) -> bool:
        """Whether the last picture is old enough."""
        return time.perf_counter() - self._shown >= PREVIEW_SECONDS

    def show(self, srgb: Float[Tensor, "h w 3"], o: Float[Tensor, "h w 1"]) -> None:
        """Write a picture over black, ``srgb`` weighted by its coverage ``o``."""
        write_png(self._run.preview_path("color.png"), over_grey(srgb, o))
        self._run.say("preview", stage="appearance", path="preview/color.png")
        self._shown = time.perf_counter()


def over_grey(picture: Float[Tensor, "h w 3"], o: Float[Tensor, "h w 1"]) -> Tensor:
    """A picture over black, put over a light grey instead; in [0, 1]."""
    return (picture + (1 - o) * 0.9).detach().clamp(0, 1).cpu()
