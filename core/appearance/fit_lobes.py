"""Fits the lobes of :mod:`core.appearance.lobes`; run once, its result is ``lobes.safetensors``.

    python -m core.appearance.fit_lobes

What matters is not the reflectance itself but the light that it averages, so that is what is
fitted: random surface points under Blender's eight studio lights (found next to an installed
Blender), each integrated over 384 visible normals, against the same points read through the lobes.
Places and widths of the lobes are common to three Fresnel terms, weights are not.
"""

import math
from typing import NamedTuple

import torch
from jaxtyping import Float
from safetensors.torch import save_file
from torch import Tensor

from core.appearance.brdf import (
    MIN_ALPHA,
    fresnel_dielectric,
    ggx_d,
    hammersley,
    schlick_weight,
    smith_g2,
    smith_lambda,
    visible_normals,
)
from core.appearance.environment import Environment
from core.appearance.lights import load_light
from core.appearance.lobes import FILE, FINEST, LOBES, ROOT_COS, ROUGHNESS, FittedLobes
from core.ops import dot, normalize

LIGHTS = ("city", "courtyard", "forest", "interior", "night", "studio", "sunrise", "sunset")
POINTS = 24_576  # under each light
SAMPLES = 384  # visible normals of a point
BATCH = 4096
STEPS = 2400
RATES = (0.03, 0.03, 0.05)  # of offsets, log widths, and weights before the softmax
# Of the three Fresnel terms: what counts most in a picture.
KIND_WEIGHT = (1.0, 0.1, 0.3)
# Of the differences between the table's neighbours: it is read bilinearly, so they must agree on
# which lobe is which, although the lobes are interchangeable.
SMOOTHNESS = 1e-4


class Points(NamedTuple):
    """Surface points under one light, and what they reflect."""

    normal: Float[Tensor, "p 3"]
    view: Float[Tensor, "p 3"]
    roughness: Float[Tensor, "p 1"]
    diffuse: Float[Tensor, "p 3"]  # the light averaged over the cosine lobe
    specular: Float[Tensor, "3 p 3"]  # averaged over the reflectance, for each Fresnel term


def random_points(environment: Environment, generator: torch.Generator) -> Points:
    """Smooth and grazing ones somewhat more often."""

    def uniform(n: int) -> Tensor:
        return torch.rand(POINTS, n, generator=generator)

    def direction() -> Tensor:
        return normalize(torch.randn(POINTS, 3, generator=generator))

    # DIRECTIONS: a normal anywhere on the sphere, and a view at any azimuth about it
    normal = direction()
    side = normalize(torch.linalg.cross(normal, direction()))
    first, last, _ = ROUGHNESS
    roughness = first + (last - first) * uniform(1) ** 1.5
    cos_v = (uniform(1) ** 0.7).clamp(min=0.02)
    view = cos_v * normal + (1 - cos_v.square()).sqrt() * side
    # AVERAGES: in parts, since each point has SAMPLES directions
    parts = zip(*(x.split(1024) for x in (normal, view, roughness)), strict=True)
    exact = torch.cat([averages(environment, *part) for part in parts], 1)
    return Points(normal, view, roughness, environment.irradiance_map.read(normal), exact)


def averages(
    environment: Environment, normal: Tensor, view: Tensor, roughness: Tensor
) -> Float[Tensor, "3 p 3"]:
    """The map's light averaged over the specular reflectance with each Fresnel term.

    A sample reads the map as blurred as its fraction of the sphere is wide.
    """
    alpha = roughness.square().clamp(min=MIN_ALPHA)
    cos_v = dot(normal, view).clamp(1e-3, 1)
    along = normalize(view - cos_v * normal)
    bitangent = torch.linalg.cross(normal, along)
    h = visible_normals(cos_v, alpha, hammersley(SAMPLES))
    # DIRECTIONS: the view mirrored about visible normals, in the point's own frame
    sin_v = (1 - cos_v.square()).sqrt()
    cos_d = sin_v * h[..., 0] + cos_v * h[..., 2]
    x, y, z = 2 * cos_d * h[..., 0] - sin_v, 2 * cos_d * h[..., 1], 2 * cos_d * h[..., 2] - cos_v
    # WEIGHTS: sampling visible normals leaves G2 / G1; below the horizon nothing is reflected
    masked = 1 + smith_lambda(cos_v, alpha)
    weight = masked * smith_g2(cos_v, z.clamp(min=1e-5), alpha) * (z > 0)
    # D G1 (v·h) / (n·v), over the Jacobian of the reflection, 4 (v·h).
    density = ggx_d(h[..., 2], alpha) / (4 * masked * cos_v)
    axes = (
        x[..., None] * along[:, None]
        + y[..., None] * bitangent[:, None]
        + z[..., None] * normal[:, None]
    )
    # Half of the radius of a round sample area: the lobes' tails are long.
    width = (1 / (SAMPLES * density * math.pi)).sqrt() / 2
    level = (width / FINEST).log2().clamp(min=0)
    maps = environment.specular.maps
    light = maps.read(axes.reshape(-1, 3), level.reshape(-1)).view_as(axes)
    schlick = schlick_weight(cos_d.clamp(0, 1))
    kinds = torch.stack([1 - schlick, schlick, fresnel_dielectric(cos_d.clamp(0, 1))]) * weight
    return torch.einsum("kps,psc->kpc", kinds, light) / kinds.sum(-1, keepdim=True)


def start() -> list[Tensor]:
    """Lobes side by side, of mixed widths, narrower towards grazing: offsets, widths, logits."""
    rows, columns = ROUGHNESS[2], ROOT_COS[2]
    spread = torch.linspace(-1.5, 1.5, LOBES)[:, None, None].expand(-1, rows, columns)
    widths = torch.linspace(-0.5, 0.5, LOBES)
    widths = widths[torch.randperm(LOBES, generator=torch.Generator().manual_seed(3))]
    narrow = torch.log(0.25 + 0.75 * torch.linspace(*ROOT_COS).square())
    widths = widths[:, None, None] + narrow.expand(LOBES, rows, columns)
    logits = torch.zeros(3, LOBES + 1, rows, columns)
    # The cosine lobe begins nearly without weight: e^-3 against the others' 1.
    logits[:, LOBES] = -3
    return [x.clone().requires_grad_() for x in (spread, widths, logits)]


def table_of(parts: list[Tensor]) -> Float[Tensor, "channels rows columns"]:
    """As the file has it: offsets, log widths, weights (kind slowest)."""
    offset, log_width, logits = parts
    return torch.cat([offset, log_width, logits.softmax(1).flatten(0, 1)])


def shown(x: Float[Tensor, "*b"]) -> Float[Tensor, "*b"]:
    """Roughly what a screen makes of ``x``, without an end."""
    return (x / (1 + x)).clamp(min=1e-6) ** (1 / 2.2)


def fit(steps: int = STEPS) -> Float[Tensor, "channels rows columns"]:
    """The table over roughness (rows) and sqrt(n·v) (columns)."""
    generator = torch.Generator().manual_seed(1)
    environments = [Environment.of(load_light(f"blender:{name}")) for name in LIGHTS]
    points = [random_points(e, generator) for e in environments]
    parts = start()
    optimizer = torch.optim.Adam(
        [{"params": [x], "lr": rate} for x, rate in zip(parts, RATES, strict=True)],
        betas=(0.9, 0.99),
    )
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, steps, eta_min=1e-4)
    for step in range(steps):
        here, there = environments[step % len(LIGHTS)], points[step % len(LIGHTS)]
        some = torch.randint(0, POINTS, (BATCH,), generator=generator)
        # At random about the light's own mean: all eight lights count equally, and the curve of
        # ``shown`` is met at more than one brightness.
        exposure = math.exp(0.5 * float(torch.randn(1, generator=generator)))
        exposure = exposure / float(there.diffuse.mean())
        lobes = FittedLobes(here.specular.maps, table_of(parts))
        found = lobes.average(*(x[some] for x in there[:4]))
        error = (shown(found * exposure) - shown(there.specular[:, some] * exposure)).square()
        loss = (error.mean((1, 2)) * torch.tensor(KIND_WEIGHT)).sum().sqrt()
        grid = torch.cat([parts[0], parts[1], 0.3 * parts[2].flatten(0, 1)])
        rough = grid.diff(dim=1).square().mean() + grid.diff(dim=2).square().mean()
        optimizer.zero_grad()
        (loss + SMOOTHNESS * rough).backward()
        optimizer.step()
        schedule.step()
        if step % 100 < len(LIGHTS):
            print(
                f"step {step}, {LIGHTS[step % len(LIGHTS)]}: {float(loss.detach()):.4f}", flush=True
            )
    return table_of(parts).detach().contiguous()


def main() -> None:
    """Fits and writes the file next to this one."""
    save_file({"lobes": fit()}, FILE)


if __name__ == "__main__":
    main()
