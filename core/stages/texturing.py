"""The paper's last step: the shape is unwrapped, and the material becomes maps (§4.3)."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.spatial.transform import Rotation
from torch import Tensor

from core.appearance.material import Material, MaterialNet
from core.appearance.shaded import UvMesh
from core.config import Config, TextureConfig
from core.errors import UserError
from core.geometry.mesh import Mesh
from core.guidance.guidance import Areas, Surface
from core.io.maps import Maps
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.ranks import Ranks
from core.texture.bake import bake
from core.texture.even import evened
from core.texture.fine_surface import FineSurface
from core.texture.finish import Finish, detail_of
from core.texture.remesh import even_in_charts
from core.texture.simplify import simplify
from core.texture.texels import OVERLAP, uv_faults
from core.texture.unwrap import unwrap

PARTS = ("verts", "faces", "uv", "face_uvs")  # of the mesh, in a checkpoint; the rest is derived
FLAT = "flat"  # there too, one number; not in those of older versions
FINE = ("fine_verts", "fine_faces")  # of the shape before it was simplified, if it was
ASTRAY = 1e-3  # training units; a file's and float32's rounding far from the origin are below it


class Unwrapped(NamedTuple):
    """The mesh of the asset, and the shape that it was simplified from; None where it was not."""

    mesh: UvMesh
    fine: Mesh | None = None

    def to(self, device: "torch.device | str") -> "Unwrapped":
        """The mesh on ``device``; the fine shape is only ever looked at on the CPU."""
        return self._replace(mesh=self.mesh.to(device))


def unwrap_shape(
    shape: Mesh,
    config: TextureConfig,
    progress: Progress,
    *,
    keep_uv: bool = False,
    keep_faces: bool = False,
) -> Unwrapped:
    """The shape within its face budget and with a uv; a mesh that has a sound uv stays as it is.

    With ``keep_uv`` its own uv is used even where faces share texels; with ``keep_faces`` a mesh
    within the budget keeps its faces.
    """
    if keep_uv:
        return Unwrapped(_with_own_uv(shape, progress))
    if shape.uv is not None and shape.face_uvs is not None:
        faults = uv_faults(shape.uv, shape.face_uvs)
        if not faults:
            return Unwrapped(UvMesh.of(shape))
        progress.warn(
            f"The mesh's own UV map cannot be used for a texture. {' '.join(faults)}",
            "A new one is made. To keep yours, unwrap it without overlaps inside the square.",
            stage="unwrap",
        )
    with progress.timed("unwrap"):
        # Before the unwrap, whose charts would not survive it.
        verts, faces, chart = _within_budget(shape, config, keep_faces, progress.check_cancelled)
        atlas = unwrap(verts, faces, config.size, _hundredths("unwrap", progress), chart)
        progress.complete("unwrap")  # a small mesh is done before it reports anything
    fine = None if faces is shape.faces else shape
    return Unwrapped(UvMesh.of(Mesh(verts, faces, *atlas, flat=shape.flat)), fine)


def _within_budget(
    shape: Mesh, config: TextureConfig, keep_faces: bool, check: Callable[[], None]
) -> tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"], Int[np.ndarray, " f"] | None]:
    """Even triangles in charts at small budgets; at large ones fewer of the shape's own."""
    kept = keep_faces and len(shape.faces) <= config.max_faces
    if kept or config.max_faces > config.even_faces:
        return *simplify(shape.verts, shape.faces, config.max_faces, check), None
    return even_in_charts(shape, config.max_faces, check)


def _with_own_uv(shape: Mesh, progress: Progress) -> UvMesh:
    if shape.uv is None or shape.face_uvs is None:
        raise UserError("The mesh has no UV map to keep.", "Unwrap it, or have a new one made.")
    faults = uv_faults(shape.uv, shape.face_uvs)
    if OVERLAP in faults:
        faults.remove(OVERLAP)
        progress.warn(OVERLAP, "That is right for mirrored parts.", stage="unwrap")
    if faults:
        raise UserError(
            f"The mesh's own UV map cannot be used for a texture. {' '.join(faults)}",
            "Fix the UV map, or have a new one made.",
        )
    return UvMesh.of(shape)


def load_unwrapped(run: RunFolder) -> Unwrapped | None:
    """The unwrapped mesh of an earlier session of this run."""
    found = run.load("mesh")
    if found is None:
        return None
    with run.whole_checkpoint("mesh"):
        return _of_tensors(found[0])


def save_unwrapped(run: RunFolder, unwrapped: Unwrapped) -> None:
    """Keep the unwrapped mesh: from here on the geometry is not trained again."""
    run.save("mesh", _tensors(unwrapped), {})


def fine_over(made: Unwrapped, verts: Float[Tensor, "v 3"]) -> Mesh | None:
    """The fine shape of ``made``, moved, turned and scaled as its mesh's vertices are in ``verts``,
    which is in training units.

    None where there is no fine shape, and where ``verts`` are not the mesh's in that sense.
    """
    own, fine = made.mesh.verts.double().numpy(), made.fine
    there = verts.double().numpy()
    if fine is None or own.shape != there.shape:
        return None
    from_center, to_center = own - own.mean(0), there - there.mean(0)
    turn = Rotation.align_vectors(to_center, from_center)[0]
    scale = np.linalg.norm(to_center) / np.linalg.norm(from_center)

    def moved(points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        return scale * turn.apply(points - own.mean(0)) + there.mean(0)

    if np.abs(moved(own) - there).max() > ASTRAY:
        return None
    return Mesh(torch.from_numpy(moved(fine.verts.double().numpy())).to(fine.verts), fine.faces)


def shared_unwrapped(unwrapped: Unwrapped | None, ranks: Ranks) -> Unwrapped:
    """The first process's mesh, in each of those that make the asset together."""
    if ranks.world == 1 and unwrapped is not None:
        return unwrapped
    return _of_tensors(ranks.from_first(_tensors(unwrapped) if unwrapped else {}))


def _tensors(unwrapped: Unwrapped) -> dict[str, Tensor]:
    mesh, fine = unwrapped
    tensors = {name: getattr(mesh, name) for name in PARTS}
    if fine is not None:
        tensors |= dict(zip(FINE, (fine.verts, fine.faces), strict=True))
    return tensors | {FLAT: torch.tensor([int(mesh.flat)])}


def _of_tensors(tensors: dict[str, Tensor]) -> Unwrapped:
    fine = Mesh(*(tensors[name] for name in FINE)) if FINE[0] in tensors else None
    flat = FLAT in tensors and bool(tensors[FLAT])
    return Unwrapped(UvMesh.of(Mesh(*(tensors[name] for name in PARTS), flat=flat)), fine)


def bake_maps(
    shape: Unwrapped,
    net: MaterialNet,
    config: Config,
    progress: Progress,
    *,
    surfaces: tuple[Surface, ...] = (),
    areas: Areas | None = None,
    seed: int = 0,
    rounded: bool = False,
) -> Maps:
    """Γ on every texel, even within each of the ``areas``, with the detail of ``surfaces`` and the
    relief of the fine shape; ``rounded``: and its edges."""
    device, size = next(net.parameters()).device, config.texture.size

    @torch.no_grad()
    def learnt(points: Float[Tensor, "n 3"], area: Int[Tensor, " n"] | None = None) -> Material:
        area = None if area is None else area.to(device)
        return Material(*(x.cpu() for x in net(points.to(device), area=area)))

    with progress.timed("bake"):
        mesh = shape.mesh.to("cpu")
        evenness, strength = config.appearance.evenness, config.appearance.detail
        material = evened(learnt, areas, mesh, evenness) if areas else learnt
        options = {"strength": strength, "size": size, "seed": seed}
        detail = detail_of(mesh, material, surfaces, areas, **options)
        radius = config.texture.edge_radius if rounded else 0.0
        fine = FineSurface(shape.fine or mesh.mesh, radius) if shape.fine or radius else None
        return bake(
            mesh.mesh,
            material,
            size,
            _hundredths("bake", progress),
            config.texture.samples,
            # Without either the maps are Γ's own, to the last bit.
            Finish(mesh, fine, detail, areas) if fine or detail else None,
            areas,
        )


def _hundredths(stage: str, progress: Progress) -> Callable[[float], None]:
    """Reports the fraction of a stage that is done, and stops it where the user asks for it."""
    return lambda done: progress.advance(stage, round(100 * done), 100)
