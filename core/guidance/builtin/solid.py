"""A solid drawn for words: the start of the geometry, known everywhere."""

import json
from collections.abc import Collection
from dataclasses import asdict, dataclass, replace
from functools import cache, cached_property
from pathlib import Path

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.init_shape import Shape, sample_surface
from core.geometry.mesh import component_labels
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import EXTENT, TetGrid, tet_grid
from core.guidance.builtin.offered import read_metadata
from core.guidance.builtin.solid_net import BASE, KINDS, SCALE, SolidNet, SolidNetConfig, Triplane
from core.guidance.builtin.stretch import (
    AS_IT_IS,
    IN_PLACE,
    NOT_STRETCHED,
    STRETCH,
    Frame,
    Vector,
    frame_of,
)
from core.guidance.builtin.weights import filled, in_bytes, load_tensors, write_tensors

CHUNK = 1 << 16  # points at a time
PER_THREAD = 1 << 14  # on a CPU: the features of more points leave its cache
LATTICE = 64  # cubes along an edge, of the mesh that surface points are drawn from
# Tables of features, in six bits a number, which move a surface by 2e-4 of the object's radius.
TABLES = ("own.weight", "kind.weight")
ROWS = ("base.weight", "words.3.weight")
DRAWINGS = 3  # at most, of one object
SIMPLE = 3  # components and handles of a surely intact shape
FAR = 2 * EXTENT  # beyond every point of the cube: the distance of absent parts
LEAST_SWELL = 0.01  # training units
RARE = 0.05  # fraction of a noun's objects below which a kind is too little known
# Adjectives with a form of their own that the network knows, not a stretched one.
FORMS = {("table", "round")}


@dataclass(frozen=True)
class Solid:
    """One object: its features in a network, and its frame."""

    net: SolidNet
    triplane: Triplane
    frame: Frame = IN_PLACE
    swell: float = 0.0  # how far the surface is moved outwards, training units
    absent: tuple[int, ...] = ()  # indices of missing parts among the noun's

    @classmethod
    def drawn(
        cls,
        net: SolidNet,
        words: Int[Tensor, "1 3"],
        generator: torch.Generator,
        absent: tuple[int, ...] = (),
        kinds: Collection[int] = (),
    ) -> "Solid":
        """A random object: of one of the noun's kinds, and of a code, which are normal.

        A thin wall may come out torn, which shows as handles and components; a shape with many of
        them is drawn again, and the simplest is taken. ``kinds``: allowed kinds of the noun; ():
        all.
        """
        kind = torch.tensor([[drawn_kind(net, words, generator, kinds)]], device=words.device)
        row, found = torch.cat([words, kind], 1), []
        for _ in range(DRAWINGS):
            code = torch.randn(1, net.config.latent, generator=generator).to(words.device)
            with torch.no_grad():
                found.append(cls(net, net.triplane(row, code), absent=absent))
            if found[-1].complexity <= SIMPLE:
                break
        return min(found, key=lambda solid: solid.complexity)

    def placed(self, adjective: str = "", wider: Vector = AS_IT_IS) -> "Solid":
        """The solid stretched for the adjective, at the origin and of the training's size.

        ``wider``: how much wider than the real thing it is drawn.

        It is moved outwards by less where that would create components: far from the surface the
        network's distance may dip.
        """
        stretch, swell = STRETCH.get(adjective, NOT_STRETCHED)
        x, y, z = (factor / by for factor, by in zip(stretch, wider, strict=True))
        while True:
            frame = frame_of(self.mesh[0], (x, y, z), swell, adjective == "round")
            solid = self._reframed(frame, swell)
            if not swell or solid.components <= self.components:
                return solid
            swell = swell / 2 if swell > LEAST_SWELL else 0.0

    def framing(self, verts: Float[Tensor, "v 3"]) -> "Solid":
        """The solid in the frame in which such vertices, in its own frame, have the training's
        place and size."""
        (x, y, z), scale = frame_of(verts)
        k, (a, b, c), (u, v, w) = scale[0], self.frame.center, self.frame.scale
        frame = Frame((a + x / u, b + y / v, c + z / w), (k * u, k * v, k * w))
        return self._reframed(frame, k * self.swell)

    def _reframed(self, frame: Frame, swell: float) -> "Solid":
        """The solid in another frame."""
        solid = replace(self, frame=frame, swell=swell)
        if swell == self.swell == 0:  # the surface moves with the frame
            verts, faces = self.mesh
            scale, center = (verts.new_tensor(of) for of in (self.frame.scale, self.frame.center))
            vars(solid)["mesh"] = solid._placed(verts / scale + center), faces
        return solid

    def sdf(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Signed distance, negative inside, training units; less than the true one farther off than
        a tenth, and where the frame's scale is uneven."""
        return self.distances(points).amin(1)

    def part(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """The index of the part of each point among the noun's."""
        return self.distances(points).argmin(1)

    @cached_property
    def mesh(self) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]:
        """The solid's surface on the network's lattice, as it may be slender."""
        grid = _grid()
        verts, faces, *_ = surface(self._at_nodes(grid), grid.tet_verts, grid)
        return self._placed(verts), faces

    def _at_nodes(self, grid: TetGrid) -> Float[Tensor, " n"]:
        """The signed distance at the lattice's nodes. A mirrored object is asked for one side only;
        what else may be made of the network need not be mirrored."""
        half = grid.resolution // 2
        if type(self) is not Solid or not self.triplane.mirrored[0, 0]:
            return self.sdf(self._placed(grid.tet_verts))
        nodes = grid.tet_verts.view(*grid.shape, 3)[half:].reshape(-1, 3)
        side = self.sdf(self._placed(nodes)).view(half + 1, *grid.shape[1:])
        return torch.cat([side[1:].flip(0), side]).view(-1)

    def _placed(self, local: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """The network's own points in the frame."""
        scale, center = (local.new_tensor(of) for of in (self.frame.scale, self.frame.center))
        return (local - center) * scale

    @cached_property
    def components(self) -> int:
        """The number of connected components of the surface."""
        verts, faces = self.mesh
        return component_labels(faces, len(verts))[0]

    @property
    def complexity(self) -> int:
        """Components and handles, by the surface's Euler characteristic: V - E + F, with 2 E = 3
        F."""
        verts, faces = self.mesh
        return 2 * self.components - (len(verts) - len(faces) // 2) // 2

    def shape(self) -> Shape:
        """The shape that Ψ is fitted to."""
        verts, faces = self.mesh
        return Shape(
            self.sdf, lambda count, generator: sample_surface(verts, faces, count, generator)
        )

    @torch.no_grad()
    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 8"]:
        """Each part's signed distance."""
        device = self.triplane.embedding.device
        local = points / points.new_tensor(self.frame.scale) + points.new_tensor(self.frame.center)
        most = CHUNK if device.type != "cpu" else PER_THREAD * torch.get_num_threads()
        chunks = (local.to(device) / EXTENT).split(min(CHUNK, most))
        found = [self.net.at(self.triplane, chunk[None]) for chunk in chunks]
        distances = torch.cat(found, 1)[0] * (min(self.frame.scale) / SCALE) - self.swell
        distances[:, list(self.absent)] = FAR
        return distances.to(points.device)


def drawn_kind(
    net: SolidNet,
    words: Int[Tensor, "1 3"],
    generator: torch.Generator,
    kinds: Collection[int] = (),
) -> int:
    """One of the noun's kinds, or of the given ones, as often as the training had it with the
    words."""
    noun, shape, part = words[0].tolist()
    rows = slice(KINDS * (noun - 1) + 1, KINDS * noun + 1)
    among = torch.tensor([not kinds or kind in kinds for kind in range(KINDS)])
    counts = net.counts[shape, part, rows].cpu() * among
    if not counts.any():  # never seen together
        counts = net.counts[..., rows].sum((0, 1)).cpu() * among
    likely = counts * (counts >= RARE * counts.sum())
    return rows.start + int(torch.multinomial(likely, 1, generator=generator))


@cache
def _grid() -> TetGrid:
    return tet_grid(LATTICE)


def save_solid_net(path: Path, net: SolidNet) -> None:
    """The shipped form: half precision, and six bits or bytes for its bulk."""
    tensors = {}
    for name, tensor in net.state_dict().items():
        if name in TABLES:  # a group is a channel of a plane
            groups = tensor.numel() // (2 * BASE) ** 2
            tensors |= in_bytes(name, tensor, groups, bits=6)
        elif name in ROWS:
            tensors |= in_bytes(name, tensor, len(tensor))
        else:
            tensors[name] = tensor if tensor.dtype == torch.bool else tensor.half()
    write_tensors(path, tensors, {"config": json.dumps(asdict(net.config))})


def load_solid_net(path: Path) -> SolidNet:
    """The network from its file, in single precision, ready for use."""
    facts = read_metadata(path)["config"]
    for name in ("words", "widths"):  # JSON has no tuples
        facts[name] = tuple(facts[name])
    return filled(lambda: SolidNet(SolidNetConfig(**facts)), load_tensors(path))
