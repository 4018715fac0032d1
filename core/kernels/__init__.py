"""The CPU's hot loops, compiled by numba: compiled versions of plain torch formulas.

Torch stays the definition, runs on every device, and is what these are tested against; callers ask
``supports`` of their tensors. Numba compiles at the first use and keeps the result on disk.

The arithmetic is float32 step by step, as torch's is (numba takes a bare 0.5 for float64), so that
both draw the same picture.
"""

import numpy as np
import torch
from torch import Tensor
from torch.autograd.function import once_differentiable

from core.kernels import hash_grid as _hash_grid
from core.kernels import rasterizer as _rasterizer
from core.kernels import rays as _rays
from core.kernels import visibility as _visibility


def supports(*tensors: Tensor) -> bool:
    """Whether the compiled version takes these: on a CPU, floats in single precision."""
    return all(
        t.device.type == "cpu" and (t.dtype == torch.float32 or not t.dtype.is_floating_point)
        for t in tensors
    )


def _arrays(*tensors: Tensor) -> list:
    """The tensors' memory as numpy arrays."""
    return [t.detach().contiguous().numpy() for t in tensors]


def visibility(clip: Tensor, faces: Tensor, height: int, width: int, cull: bool) -> Tensor:
    """See :func:`core.render.visibility.visibility`."""
    face_id = torch.empty(len(clip), height, width, dtype=torch.int64)
    views, faces, pictures = _arrays(clip, faces, face_id)
    for view, picture in zip(views, pictures, strict=True):
        _visibility.see(view, faces, cull, picture)
    return face_id


def lowest_along(volume: Tensor, rays: tuple[Tensor, ...], extent: float, samples: int) -> Tensor:
    """See :func:`core.geometry.ray_sdf.lowest_along`."""
    found = _rays.lowest(*_arrays(volume, *rays), np.float32(extent), samples)
    return torch.from_numpy(found)


def covered(face_id: Tensor, faces: Tensor) -> tuple[Tensor, ...]:
    """See :func:`core.render.rasterizer.covered`."""
    found = _rasterizer.covered(*_arrays(face_id.flatten(1), faces))
    return tuple(torch.from_numpy(x) for x in found)


class Barycentrics(torch.autograd.Function):
    """See :func:`core.render.rasterizer.barycentrics`."""

    @staticmethod
    def forward(ctx, clip, view, corners, pixel, height, width):
        arrays = _arrays(clip, view, corners, pixel)
        bary, sound = _rasterizer.barycentrics(*arrays, height, width)
        bary, sound = torch.from_numpy(bary), torch.from_numpy(sound)
        ctx.save_for_backward(clip, view, corners, pixel, bary, sound)
        ctx.size = (height, width)
        return bary

    @staticmethod
    @once_differentiable
    def backward(ctx, g):
        *arrays, bary, sound = _arrays(*ctx.saved_tensors)
        grad = _rasterizer.barycentrics_backward(*_arrays(g), *arrays, *ctx.size, bary, sound)
        return torch.from_numpy(grad), None, None, None, None, None


def depths(clip: Tensor, view: Tensor, corners: Tensor, bary: Tensor) -> Tensor:
    """See :func:`core.render.rasterizer.depths`."""
    return torch.from_numpy(_rasterizer.depths(*_arrays(clip, view, corners, bary)))


class Normalize(torch.autograd.Function):
    """See :func:`core.ops.normalize`."""

    @staticmethod
    def forward(ctx, x, eps):
        ctx.eps = np.float32(eps)
        rows = _arrays(x)[0].reshape(-1, x.shape[-1])
        out, scale = (torch.from_numpy(part) for part in _rasterizer.normalize(rows, ctx.eps))
        out = out.view(x.shape)
        ctx.save_for_backward(out, scale)
        return out

    @staticmethod
    @once_differentiable
    def backward(ctx, g):
        # Read once: a recomputed forward (torch.utils.checkpoint) hands its tensors out but once.
        arrays = _arrays(g, *ctx.saved_tensors)
        rows = (-1, g.shape[-1])
        slope, out, scale = arrays[0].reshape(rows), arrays[1].reshape(rows), arrays[2]
        grad = _rasterizer.normalize_backward(slope, out, scale, ctx.eps)
        return torch.from_numpy(grad).view(g.shape), None


def weighted_sum(table: Tensor, index: Tensor, weight: Tensor) -> Tensor:
    """See :class:`core.render.rasterizer.WeightedSum`."""
    return torch.from_numpy(_rasterizer.weighted_sum(*_arrays(table, index, weight)))


def weighted_sum_backward(
    g: Tensor, table: Tensor, index: Tensor, weight: Tensor
) -> tuple[Tensor, None, Tensor]:
    """Its gradients to the table and to the weights."""
    found = _rasterizer.weighted_sum_backward(*_arrays(g, table, index, weight))
    return torch.from_numpy(found[0]), None, torch.from_numpy(found[1])


def silhouette_edges(
    screen: Tensor, in_front: Tensor, faces: Tensor, edges: tuple[Tensor, Tensor], cull: bool
) -> tuple[Tensor, Tensor, Tensor]:
    """See :func:`core.render.antialias.silhouette_edges`; ``edges``: their vertices and faces."""
    arrays = _arrays(screen, in_front, faces, *edges)
    front = _rasterizer.facing(arrays[0], arrays[2])
    found = _rasterizer.silhouette_edges(front, arrays[1], *arrays[3:], cull)
    view, edge = (torch.from_numpy(x) for x in found)
    return view, edge, torch.from_numpy(front)[view, edges[1][edge, 0]]


class SampleHashGrid(torch.autograd.Function):
    """See :class:`core.hash_grid.HashGrid`; ``unit`` (N, 3) in [0, 1]."""

    @staticmethod
    def forward(ctx, table, unit, resolutions, sizes):
        ctx.levels = np.array(resolutions), np.array(sizes)
        ctx.save_for_backward(table, unit)
        return torch.from_numpy(_hash_grid.sample(*_arrays(table, unit), *ctx.levels))

    @staticmethod
    @once_differentiable
    def backward(ctx, g):
        arrays = _arrays(g, *ctx.saved_tensors)
        found = _hash_grid.sample_backward(*arrays, *ctx.levels, ctx.needs_input_grad[1])
        return torch.from_numpy(found[0]), torch.from_numpy(found[1]), None, None
