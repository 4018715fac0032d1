"""Small pictures and a light mesh of what a training has so far, for whoever watches the run."""

import time
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int, UInt8
from torch import Tensor

from core.camera import Cameras
from core.render.normals import render_normals
from core.run_folder import PREVIEW_SECONDS, RunFolder
from core.texture.files import whole_file
from core.texture.images import unit_bytes, write_png

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
        write_shape(self._run.preview_path("shape.obj"), verts, faces)
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

    def show(self, picture: UInt8[np.ndarray, "h w 3"]) -> None:
        """Write it for whoever watches."""
        write_png(self._run.preview_path("color.png"), picture)
        self._run.say("preview", stage="appearance", path="preview/color.png")
        self._shown = time.perf_counter()


def over_grey(
    picture: Float[Tensor, "h w 3"], o: Float[Tensor, "h w 1"]
) -> UInt8[np.ndarray, "h w 3"]:
    """A picture over black, in [0, 1], put over a light grey instead."""
    return unit_bytes((picture + (1 - o) * 0.9).detach().cpu())


def write_shape(path: Path, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> None:
    """A mesh without uv as OBJ, in the axes of Blender's import defaults (Y up, -Z forward)."""
    v, f = verts.detach().cpu().numpy(), faces.cpu().numpy() + 1
    turned = np.stack([v[:, 0], v[:, 2], -v[:, 1]], 1)
    with whole_file(path) as aside, aside.open("wb") as file:
        np.savetxt(file, turned, "v %.5f %.5f %.5f")
        np.savetxt(file, f, "f %d %d %d")
