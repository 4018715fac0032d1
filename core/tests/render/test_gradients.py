"""The gradient of each formula of the renderer and of the shading, against finite differences.

In float64, formula by formula; those of Functions with a backward of their own, of marching
tetrahedra and of the hash grid are in their tests. The outline's gradient is not that of its
own picture but of one of infinite resolution: see test_antialias.
"""

from collections.abc import Callable

import pytest
import torch
from torch import Tensor
from torch.autograd import gradcheck

from core.appearance import brdf
from core.appearance.environment import Environment
from core.appearance.lamps import Lamps
from core.appearance.latlong import directions, to_uv
from core.appearance.lobes import lobe_axes
from core.appearance.shade import lifted, perturb, shade
from core.camera import Cameras
from core.ops import dot, linear_to_srgb, normalize, srgb_to_linear
from core.render.normals import face_normals, render_normals, vertex_normals
from core.render.rasterizer import interpolate, rasterize, to_clip
from core.tests.meshes import sphere

N = 5


def rows(seed: int, *shape: int) -> Tensor:
    """Standard normal numbers with gradient."""
    generator = torch.Generator().manual_seed(seed)
    return torch.randn(*shape, generator=generator, dtype=torch.float64).requires_grad_()


def fractions(seed: int, *shape: int) -> Tensor:
    """Numbers in [0.2, 0.9]."""
    return (0.2 + 0.7 * torch.sigmoid(rows(seed, *shape))).detach().requires_grad_()


FACES = sphere(0)[1]
NORMAL, VIEW = normalize(rows(1, N, 3)), normalize(normalize(rows(1, N, 3)) + 0.3 * rows(2, N, 3))
STEEP = normalize(VIEW + 1.2 * normalize(rows(5, N, 3)))
FORMULAS: dict[str, tuple[Callable, tuple[Tensor, ...]]] = {
    "dot": (dot, (rows(1, N, 3), rows(2, N, 3))),
    "normalize": (normalize, (rows(1, N, 3),)),
    "linear_to_srgb": (linear_to_srgb, (fractions(1, N, 3),)),
    "linear_to_srgb, dark": (linear_to_srgb, (1e-3 * fractions(1, N, 3),)),
    "srgb_to_linear": (srgb_to_linear, (fractions(1, N, 3),)),
    "to_clip": (lambda v: to_clip(v, Cameras.orbit([9.0], [5.0]).mvp.double()), (rows(1, N, 3),)),
    "face_normals": (lambda v: face_normals(v, FACES), (rows(1, 6, 3),)),
    "vertex_normals": (lambda v: vertex_normals(v, FACES), (rows(1, 6, 3),)),
    "perturb": (perturb, (rows(1, N, 3), rows(2, N, 4), rows(3, N, 3))),
    "lifted": (lambda n, v, f: lifted(*map(normalize, (n, v, f))), (STEEP, VIEW, NORMAL)),
    "ggx_d": (brdf.ggx_d, (fractions(1, N), fractions(2, N))),
    "smith_lambda": (brdf.smith_lambda, (fractions(1, N), fractions(2, N))),
    "smith_g2": (brdf.smith_g2, (fractions(1, N), fractions(2, N), fractions(3, N))),
    "schlick_weight": (brdf.schlick_weight, (fractions(1, N),)),
    "fresnel_dielectric": (brdf.fresnel_dielectric, (fractions(1, N),)),
    "brdf": (brdf.brdf, tuple(fractions(i, N) for i in range(4))),
    "to_uv": (to_uv, (rows(1, N, 3),)),
    "lobe_axes": (lobe_axes, (NORMAL, VIEW, rows(3, N, 6))),
    "lamps' irradiance": (
        Lamps(normalize(torch.randn(2, 3)), torch.rand(2, 3), torch.zeros(2)).irradiance,
        (NORMAL,),
    ),
}


@pytest.mark.parametrize("name", FORMULAS)
def test_gradient_is_that_of_the_formula(name: str) -> None:
    formula, given = FORMULAS[name]
    assert gradcheck(formula, tuple(x.detach().clone().requires_grad_() for x in given))


def test_a_lifted_and_an_untouched_normal_are_both_among_the_tested() -> None:
    moved = (lifted(STEEP, VIEW, NORMAL) != STEEP).any(1)
    assert moved.any()
    assert not moved.all()


def test_an_interior_pixels_normal_has_the_gradient_of_its_picture() -> None:
    verts, faces = sphere(1)
    cameras = Cameras.orbit([25.0], [35.0], distance=1.6)  # fills the picture
    cameras = cameras.__class__(**{n: x.double() for n, x in cameras.tensors().items()})

    def seen(v: Tensor) -> Tensor:
        return render_normals(v, faces, cameras, 6, cull=False)[0]

    assert gradcheck(seen, verts.double().requires_grad_(), eps=1e-7, atol=1e-5)


def test_interpolated_normals_follow_the_vertices() -> None:
    verts, faces = sphere(1)
    fragments = rasterize(verts.double(), faces, Cameras.orbit([9.0], [5.0]).mvp.double(), 8, 8)

    def seen(v: Tensor) -> Tensor:
        return normalize(interpolate(vertex_normals(v, faces), fragments))

    assert gradcheck(seen, verts.double().requires_grad_())


@pytest.mark.parametrize("model", ["lobes", "split_sum"])
def test_both_models_of_the_shading_have_their_own_gradient(model: str) -> None:
    x, y, z = directions(64, 128).unbind(-1)
    sky = Environment.of(torch.stack([1 + z, 1 + 0.5 * x, 1 + 0.5 * y], -1), model)
    # At roughnesses between the tables' nodes, where they have a kink.
    rough = torch.tensor([[0.234], [0.433], [0.567], [0.871], [0.311]], dtype=torch.float64)
    given = (NORMAL, VIEW, fractions(3, N, 3), rough, fractions(4, N, 1))
    given = tuple(x.detach().clone().requires_grad_() for x in given)
    assert gradcheck(lambda *x: shade(*x, sky), given, eps=1e-7, atol=1e-4, rtol=1e-3)
