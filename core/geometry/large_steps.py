"""Descent on a mesh's vertices that keeps it smooth (Nicolet, Jacobson and Jakob 2021, "Large Steps
in Inverse Rendering of Geometry").

The vertices v are not moved themselves but u = (I + λ L) v (their Eq. 10), L the combinatorial
Laplacian: a step of u is a step of v that its neighbours share, so pictures pull whole regions,
and not single vertices out of the surface.
"""

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array, csc_array, diags_array, eye_array
from scipy.sparse.linalg import splu
from torch import Tensor
from torch.autograd.function import FunctionCtx

BETAS = (0.9, 0.99)


class SmoothVertices:
    """Vertices v that are trained as u = (I + λ L) v, by their ``AdamUniform`` (§4.2 there)."""

    def __init__(
        self,
        verts: Float[Tensor, "v 3"],
        faces: Int[Tensor, "f 3"],
        stiffness: float,
        free: Bool[Tensor, " v"] | None = None,
    ) -> None:
        """``stiffness``: λ; how far a pull spreads, in edges, grows as its square root.

        ``free``: the vertices that move; all others stay to the last bit. None: all move.
        """
        matrix = _matrix(faces.cpu().numpy(), len(verts), stiffness)
        self._all, self._free = verts.detach(), None if free is None else free.nonzero()[:, 0]
        moving = self._all
        if self._free is not None:
            # A fixed neighbour adds a constant to u, which no gradient sees: it is left out.
            rows = self._free.cpu().numpy()
            matrix, moving = csc_array(matrix[rows][:, rows]), self._all[self._free]
        self._factors = splu(matrix)
        u = matrix @ moving.cpu().double().numpy()
        self._u = torch.from_numpy(u).to(verts)
        self._mean, self._square, self._count = torch.zeros_like(self._u), 0.0, 0

    def solve(self, u: Float[Tensor, "v 3"]) -> Float[Tensor, "v 3"]:
        """(I + λ L)⁻¹ u."""
        return torch.from_numpy(self._factors.solve(u.detach().cpu().double().numpy())).to(u)

    def verts(self) -> Float[Tensor, "v 3"]:
        """The vertices of now, with gradient to what is trained."""
        self._leaf = self._u.clone().requires_grad_()
        moved: Tensor = _Solve.apply(self._leaf, self)  # pyright: ignore[reportAssignmentType]
        return moved if self._free is None else self._all.index_copy(0, self._free, moved)

    def step(self, loss: Float[Tensor, ""], rate: float) -> None:
        """One step of Adam with one scale for all values, so that directions are kept."""
        (grad,) = torch.autograd.grad(loss, self._leaf)
        first, second = BETAS
        self._count += 1
        self._mean = first * self._mean + (1 - first) * grad
        self._square = second * self._square + (1 - second) * float(grad.abs().max()) ** 2
        mean = self._mean / (1 - first**self._count)
        scale = (self._square / (1 - second**self._count)) ** 0.5
        self._u = self._u - rate * mean / max(scale, 1e-20)


class _Solve(torch.autograd.Function):
    @staticmethod
    def forward(ctx: FunctionCtx, u: Tensor, system: SmoothVertices) -> Tensor:
        ctx.system = system  # pyright: ignore[reportAttributeAccessIssue]
        return system.solve(u)

    @staticmethod
    def backward(ctx: FunctionCtx, grad: Tensor) -> tuple[Tensor, None]:  # pyright: ignore
        # The matrix is symmetric: its inverse's transpose is the inverse.
        return ctx.system.solve(grad), None  # pyright: ignore[reportAttributeAccessIssue]


def _matrix(faces: Int[np.ndarray, "f 3"], count: int, stiffness: float) -> csc_array:
    """I + λ L, sparse and symmetric."""
    one, other = faces[:, [0, 1, 2]].ravel(), faces[:, [1, 2, 0]].ravel()
    rows, columns = np.concatenate([one, other]), np.concatenate([other, one])
    touch = coo_array((np.ones(len(rows)), (rows, columns)), (count, count)).tocsr()
    touch.data[:] = 1.0  # an edge of two faces came twice
    degree = diags_array(np.asarray(touch.sum(1)).ravel())
    return csc_array(eye_array(count) + stiffness * (degree - touch))
