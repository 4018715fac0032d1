"""Drawing and shading, forward and backward, at the sizes that the training uses."""

import torch

from core.appearance.environment import Environment, load_light
from core.appearance.occlusion import VertexVisibility
from core.appearance.shade import shade
from core.benchmarks import ball, least_ms, row
from core.camera import Cameras
from core.ops import normalize
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.render.rasterizer import to_clip
from core.render.visibility import visibility


def rows() -> list[dict]:
    """Targets: what a prototype reached on one idle core."""
    return [*draw_rows(), *shade_rows()]


def draw_rows() -> list[dict]:
    """Visibility alone, and normals with mask and antialias."""
    lines = []
    for n, targets in ((20_000, (60.0, 130.0)), (80_000, (200.0, 200.0))):
        verts, faces = ball(n)
        verts.requires_grad_()
        edges = edge_table(faces)
        for (views, size), target in zip(((24, 64), (4, 512)), targets, strict=True):
            azimuth = torch.arange(views) * (360 / views)
            cameras = Cameras.orbit(azimuth, torch.full((views,), 20.0))
            clip = to_clip(verts.detach(), cameras.mvp)
            name = f"{len(faces):,} faces, {views} views of {size}²"

            def see(clip=clip, faces=faces, size=size) -> None:
                visibility(clip, faces, size, size)

            def draw(verts=verts, faces=faces, cameras=cameras, size=size, edges=edges) -> None:
                n, o = render_normals(verts, faces, cameras, size, edges=edges)
                (n.sum() + o.sum()).backward()

            lines.append(row(f"visibility, {name}", least_ms(see), "ms"))
            lines.append(row(f"normals with gradient, {name}", least_ms(draw), "ms", target))
    return lines


def shade_rows() -> list[dict]:
    """A light's tables, and 100,000 points under it."""
    light = load_light("studio")
    generator = torch.Generator().manual_seed(0)
    normal = normalize(torch.randn(100_000, 3, generator=generator))
    view = normalize(normal + 0.7 * torch.randn(100_000, 3, generator=generator))
    kd, roughness, metallic = (
        torch.rand(100_000, n, generator=generator, requires_grad=True) for n in (3, 1, 1)
    )
    lines = []
    for model, target in (("lobes", 273.0), ("split_sum", 50.0)):

        def prepare(model=model) -> Environment:
            return Environment.of(light, model)

        lines.append(row(f"a light's tables, {model}", least_ms(prepare, 1) / 1e3, "s", 5.0))
        environment = prepare()

        def points(environment=environment) -> None:
            shade(normal, view, kd, roughness, metallic, environment).sum().backward()

        name = f"shade 100,000 points with gradient, {model}"
        lines.append(row(name, least_ms(points), "ms", target))
    return [*lines, *occlusion_rows(environment)]


def occlusion_rows(environment: Environment) -> list[dict]:
    """Self-shadowing: once for a shape, and once for each turn of the light."""
    mesh = ball(20_000)
    seconds = least_ms(lambda: VertexVisibility.of(*mesh), 1) / 1e3
    visibility = VertexVisibility.of(*mesh)
    name = f"what a ball of {len(mesh[1]):,} faces hides from itself"
    table = row(
        f"{name}, under a turned light", least_ms(lambda: visibility.occlusion(environment)), "ms"
    )
    return [row(name, seconds, "s"), table]
