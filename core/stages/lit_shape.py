"""The shape as shaded pictures while it is learned: the paper's ablations of its geometry.

"Entangled": one network is responsible for both, and the shape is learned with its material from
shaded pictures (§"Ablation studies"). "Shaded": the same with grey clay instead of a material.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.appearance.environment import Environment
from core.appearance.material import Material, MaterialNet
from core.appearance.shade import shade
from core.appearance.shaded import Shaded, saturate
from core.camera import Cameras
from core.config import AppearanceConfig, GeometryConfig
from core.geometry.sdf_net import SdfNet
from core.io.run_folder import RunFolder
from core.ops import linear_to_srgb, normalize
from core.render.antialias import EdgeTable, antialias
from core.render.normals import vertex_normals
from core.render.rasterizer import Fragments, Points, interpolate, rasterize, scatter

CLAY = 0.6  # its kd, linear
MATERIAL = "module.material."  # Γ's tensors in the geometry's checkpoint


@dataclass(frozen=True)
class LitShape:
    """A light, and what the shape in it is made of."""

    light: Environment
    material: Callable[[Tensor], Material]  # at points (P,3) of the surface
    rotate: bool  # the light turns from step to step

    def turned(self, generator: torch.Generator) -> "LitShape":
        """In the light of one step."""
        turn = 2 * math.pi * float(torch.rand(1, generator=generator))
        return replace(self, light=self.light.rotated(turn)) if self.rotate else self

    def render(
        self,
        verts: Float[Tensor, "v 3"],
        faces: Int[Tensor, "f 3"],
        cameras: Cameras,
        size: int,
        edges: EdgeTable,
    ) -> Shaded:
        """Pictures of a closed mesh without a uv, with gradient into its vertices and material.

        No kn: before the unwrap there is no tangent space.
        """
        smooth = vertex_normals(verts, faces)
        fragments = rasterize(verts, faces, cameras.mvp, size, size)

        def values(at: Fragments | Points) -> Float[Tensor, "p 10"]:
            points, normal = interpolate(verts, at), normalize(interpolate(smooth, at))
            to_eye = normalize(cameras.eye[at.view] - points)
            color = shade(normal, to_eye, *self.material(points)[:3], self.light)
            srgb = linear_to_srgb(saturate(color))
            return torch.cat([srgb, normal, points, torch.ones_like(srgb[:, :1])], 1)

        picture = scatter(values(fragments), fragments)
        picture = antialias(picture, fragments, faces, edges, rim=values)
        srgb, n, p, o = picture.split([3, 3, 3, 1], -1)
        seen = interpolate(verts, fragments).detach()
        return Shaded(srgb, o, n, p, seen, self.material(seen), fragments.view)


def clay(points: Float[Tensor, "p 3"]) -> Material:
    """Grey, matte and smooth, everywhere the same."""
    one, up = torch.ones_like(points[:, :1]), points.new_tensor([0.0, 0.0, 1.0])
    return Material(CLAY * torch.ones_like(points), one, 0 * one, up.expand_as(points))


def lit_shape(
    net: SdfNet,
    geometry: GeometryConfig,
    appearance: AppearanceConfig,
    light: Float[Tensor, "h w 3"],
    generator: torch.Generator,
) -> LitShape | None:
    """How the shape is shown to the guidance; None: by its normals.

    Where it is entangled, ``net`` gets a Γ of its own.
    """
    if geometry.pictures == "normals":
        return None
    material: Callable[[Tensor], Material] = clay
    if geometry.pictures == "entangled":
        device = next(net.parameters()).device
        material = net.material = MaterialNet(appearance, generator).to(device)
    environment = Environment.of(light, appearance.shading)
    return LitShape(environment, material, appearance.rotate_light)


def take_material(net: MaterialNet, run: RunFolder) -> None:
    """Put the Γ that was learned with the shape into ``net``; nothing where none was."""
    found = run.load("geometry")
    tensors = found[0] if found else {}
    own = {k.removeprefix(MATERIAL): v for k, v in tensors.items() if k.startswith(MATERIAL)}
    if own:
        net.load_state_dict(own)
