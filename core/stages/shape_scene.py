"""Ψ's surface as the cameras of one step see it: normals and a mask (Eq. 4), or lit."""

from collections.abc import Iterator

import torch
from jaxtyping import Float
from torch import Tensor

from core.camera import Cameras
from core.errors import NoSurfaceError
from core.geometry.marching_tets import marching_tets
from core.geometry.sdf_net import Band, SdfNet, extract, sdf_on_grid
from core.geometry.tet_grid import TetGrid
from core.guidance.guidance import PromptedGuidance, Views
from core.io.run_folder import RunFolder
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.stages.lit_scene import surface_picture
from core.stages.lit_shape import LitShape
from core.stages.preview import show_shape
from core.stages.scene import Scene, gather


def use_lattice(net: SdfNet, grid: TetGrid) -> None:
    """Let Ψ's offsets stay within half a cell of ``grid``.

    To be called before each extraction: which cell it is depends on the lattice of the phase, is no
    parameter, and is in no checkpoint.
    """
    net.cell = grid.cell


class ShapeScene(Scene):
    """The surface of one step.

    The views' gradient gathers in the vertices (and the lattice's SDF), which are detached from Ψ;
    one pass then carries it into Ψ. So memory grows with ``views_at_once`` only.
    """

    def __init__(
        self,
        net: SdfNet,
        grid: TetGrid,
        guidance: PromptedGuidance,
        *,
        lattice: bool = False,
        band: Band | None = None,
        lit: LitShape | None = None,
    ) -> None:
        """
        Args:
            lattice: the gradient reaches the SDF of all nodes, as rays and ``eikonal`` need it;
                otherwise that of the nodes at the surface, at a fraction of the time.
            band: of the lattice, to keep to.
            lit: the pictures are shaded; None: they are normals.
        """
        self.net, self.grid, self.guidance, self.band = net, grid, guidance, band
        self.lit = lit
        self.device = grid.tet_verts.device
        use_lattice(net, grid)
        if lattice:
            self._sdf, positions = sdf_on_grid(net, grid)
            self._verts, self.faces = marching_tets(positions, self._sdf, grid)
            self.sdf = self._sdf.detach().requires_grad_()
        else:
            surface = extract(net, grid, band)
            self._verts, self.faces = surface.verts, surface.faces
            self._sdf = self.sdf = None
        # Leaves: the views' backward ends here, and Ψ's graph is walked once for all of them.
        self.verts = self._verts.detach().requires_grad_()
        self.edges = edge_table(self.faces)
        self._covered: list[Tensor] = []  # of each part of the views

    @property
    def coverage(self) -> Float[Tensor, ""]:
        """The largest of any part of the views."""
        return torch.stack(self._covered).amax() if self._covered else torch.zeros(())

    def render(
        self, cameras: Cameras, size: int
    ) -> tuple[Float[Tensor, "b h w 3"], Float[Tensor, "b h w 1"]]:
        """n and o of the views (Eq. 4)."""
        frame = self.guidance.normal_frame
        n, o = render_normals(self.verts, self.faces, cameras, size, frame, self.edges)
        self._covered.append(o.detach().mean())
        return n, o

    def latents(self, cameras: Cameras, size: int) -> tuple[Float[Tensor, "b 4 s s"], Views]:
        """The normals, encoded; or the shaded picture, and the surface that it is painted on."""
        if self.lit is None:
            return self.guidance.encode_normals(*self.render(cameras, size)), Views(cameras)
        seen = self.lit.render(self.verts, self.faces, cameras, size, self.edges)
        self._covered.append(seen.o.detach().mean())
        surface = surface_picture(seen, self.guidance.latent_size).detach()
        return self.guidance.encode_color(seen.srgb, seen.o), Views(cameras, surface)

    def backward(self, losses: Iterator[Tensor]) -> Float[Tensor, ""]:
        """Gather the gradient at the surface, then carry it into Ψ."""
        # Without faces nothing depends on Ψ, and there is no gradient to gather.
        if len(self.faces) == 0:
            raise NoSurfaceError("The surface had nearly vanished")
        total = gather(losses)
        leaves = [(self._verts, self.verts), (self._sdf, self.sdf)]
        # A product's gradient is its factor; where it is given as such, torch loads sympy first.
        carried = [
            (out * at.grad).sum() for out, at in leaves if at is not None and at.grad is not None
        ]
        # SDF and vertices together, since both come from one pass of Ψ.
        if carried:
            torch.stack(carried).sum().backward()
        return total

    def show(self, run: RunFolder) -> None:
        """Its normals from a fixed side, and its mesh."""
        show_shape(run, self.verts.detach(), self.faces)
