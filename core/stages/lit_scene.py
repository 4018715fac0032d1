"""The finished shape with Γ's material, as the cameras of one step see it in the light (§4.3)."""

from collections.abc import Iterator

import numpy as np
import torch
from jaxtyping import Float, Int, UInt8
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.seen_through import TransmissionSource, render_clear
from core.appearance.shaded import EmissionSource, MaterialSource, Shaded, UvMesh, render_shaded
from core.camera import Cameras
from core.device import sent
from core.guidance.guidance import PromptedGuidance, Views, coarse_latent
from core.io.maps import Maps
from core.io.run_folder import RunFolder
from core.ranks import ALONE, Ranks
from core.stages.preview import SIZE, VIEW, over_grey, show_color
from core.stages.scene import Scene, gather
from core.texture.look_up import emission_source, maps_source, transmission_source

SMOOTH_REACH = 0.01  # training units: how far apart "neighbouring points" are


class LitScene(Scene):
    """The object under the light of one step; the gradient goes straight into Γ."""

    def __init__(
        self,
        net: MaterialNet,
        mesh: UvMesh,
        lit: Environment,
        guidance: PromptedGuidance,
        *,
        still: Environment,
        occlusion: Float[Tensor, "v s"] | None = None,
    ) -> None:
        """
        Args:
            lit: the light of this step.
            still: the light before its turn, in which the preview shows the object.
            occlusion: of the light, that the object does not hide from itself.
        """
        self.net, self.mesh, self.lit, self.guidance = net, mesh, lit, guidance
        self.still, self.occlusion = still, occlusion
        self.device = mesh.verts.device
        # Seen with gradient, part by part; and the view of each, counted through all parts.
        self.points: list[Float[Tensor, "_p 3"]] = []
        self.views: list[Int[Tensor, " _p"]] = []
        self._seen = 0

    def latents(self, cameras: Cameras, size: int) -> tuple[Float[Tensor, "b 4 s s"], Views]:
        """The colours, encoded; and the geometry, for a guidance that can use it."""
        shaded = render_shaded(self.mesh, self.net, cameras, size, self.lit, self.occlusion)
        # A round's targets are rendered without gradient; their points are no part of the step.
        if torch.is_grad_enabled():
            self.points.append(shaded.points)
            self.views.append(shaded.view + self._seen)
            self._seen += len(cameras)
        z = self.guidance.encode_color(shaded.srgb, shaded.o)
        return z, Views(cameras, surface_picture(shaded, self.guidance.latent_size))

    def backward(self, losses: Iterator[Tensor]) -> Float[Tensor, ""]:
        """Gather the gradient in Γ."""
        return gather(losses)

    def show(self, run: RunFolder) -> None:
        """The asset from a fixed side."""
        show_color(run, picture_of(self.net, self.mesh, self.still))


def surface_picture(shaded: Shaded, size: int) -> Float[Tensor, "b 7 {size} {size}"]:
    """[n, 2o - 1, p], area-downsampled: the geometry, for a guidance that can use it."""
    normals = coarse_latent(shaded.n, shaded.o, size)
    points = torch.nn.functional.adaptive_avg_pool2d(shaded.p.permute(0, 3, 1, 2), size)
    return torch.cat([normals, points], 1)


def roughening(
    scene: LitScene, generator: torch.Generator, views: int, ranks: Ranks = ALONE
) -> Iterator[Float[Tensor, ""]]:
    """Mean change of the material over a short way from the points seen, part by part.

    The ways are drawn for the points of all ``views`` at once, so that they do not depend on how
    many are rendered together, or in which process.
    """
    weight, net = scene.net.config.smooth, scene.net
    if weight == 0:
        return
    ways, count = _ways(scene, generator, views, ranks)
    for here, way in zip(
        scene.points, ways.split([len(points) for points in scene.points]), strict=True
    ):
        pairs = zip(net(here), net(here + way), strict=True)
        change = sum((a - b).abs().mean() for a, b in pairs)
        # Weighed by the number of points: a part with few pixels counts for less.
        yield weight * change * len(here) / count


def _ways(
    scene: LitScene, generator: torch.Generator, views: int, ranks: Ranks
) -> tuple[Float[Tensor, "p 3"], int]:
    """A way for each of this process's points, and the number of all processes' points."""
    counts = torch.zeros(views, dtype=torch.long)
    mine = counts[ranks.own]  # a view of it; fewer are filled where a picture was not finite
    for view in scene.views:
        mine += torch.bincount(view.cpu(), minlength=len(mine))
    sizes = ranks.sum(counts).tolist()
    ways = torch.randn(sum(sizes), 3, generator=generator).split(sizes)
    return sent(torch.cat(ways[ranks.own]), scene.device) * SMOOTH_REACH, sum(sizes)


@torch.no_grad()
def picture_of(
    source: MaterialSource,
    mesh: UvMesh,
    environment: Environment,
    size: int = SIZE,
    emission: EmissionSource | None = None,
    transmission: TransmissionSource | None = None,
) -> UInt8[np.ndarray, "{size} {size} 3"]:
    """The asset from a fixed side, as it is lit."""
    cameras = Cameras.orbit(**VIEW).to(mesh.verts.device)
    seen = render_clear(mesh, source, transmission, cameras, size, environment, emission)
    return over_grey(seen.srgb[0], seen.o[0])


def picture_of_maps(
    maps: Maps, mesh: UvMesh, environment: Environment, size: int
) -> UInt8[np.ndarray, "{size} {size} 3"]:
    """The finished asset from the same side: what glows does, and one looks through glass."""
    glows, clear = emission_source(maps), transmission_source(maps)
    return picture_of(maps_source(maps), mesh, environment, size, glows, clear)
