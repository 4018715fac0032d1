"""Parts of what is put together, in the sizes that the prompt states."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from scipy.sparse.csgraph import connected_components
from torch import Tensor

from core.geometry.parts.components import Mesh
from core.geometry.parts.primitives import Primitive
from core.geometry.parts.resized import Resized, resized


class Changed(NamedTuple):
    """A solid of another size."""

    of: Primitive
    size: Resized

    def distance(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """At most the signed distance."""
        return self.of.distance(self.size.before(points)) * self.size.least

    def mesh(self, edge: float) -> Mesh:
        """Its closed surface."""
        verts, faces = self.of.mesh(edge)
        return self.size.moved(verts), faces


def changed(
    parts: Mapping[str, Sequence[Primitive]], name: str, scale: float, length: float, edge: float
) -> list[Changed]:
    """A part's solids in another size: those that hang together grow together, from where they are
    attached to other parts."""
    others = [one for other, own in parts.items() if other != name for one in own]
    meshes = [one.mesh(edge)[0] for one in parts[name]]
    found: list[Changed] = []
    for group in _groups(meshes):
        verts = torch.cat([meshes[k] for k in group])
        away = torch.stack([one.distance(verts) for one in others]).amin(0)
        size = resized(verts, away, scale, length)
        found += [Changed(parts[name][k], size) for k in group]
    return found


def groups(boxes: Sequence[Float[Tensor, "2 3"]]) -> Int[Tensor, " n"]:
    """The number of each box's group, from 0: boxes that meet are in one."""
    low, high = torch.stack(list(boxes)).unbind(1)
    meet = (low[:, None] <= high).all(2) & (low <= high[:, None]).all(2)
    return torch.as_tensor(connected_components(meet.numpy(), directed=False)[1])


def _groups(meshes: Sequence[Float[Tensor, "_ 3"]]) -> Iterator[list[int]]:
    """The indices of those whose boxes meet."""
    of = groups([torch.stack([verts.amin(0), verts.amax(0)]) for verts in meshes])
    for k in range(int(of.max()) + 1):
        yield (of == k).nonzero().squeeze(1).tolist()
