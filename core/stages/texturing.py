"""The paper's last step: the shape is unwrapped, and the material becomes maps (§4.3)."""

from collections.abc import Callable

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.material import Material, MaterialNet
from core.appearance.shaded import UvMesh
from core.config import TextureConfig
from core.errors import UserError
from core.geometry.mesh import Mesh
from core.io.asset import Maps
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.texture.bake import bake
from core.texture.simplify import simplify
from core.texture.texels import OVERLAP, uv_faults
from core.texture.unwrap import unwrap

PARTS = ("verts", "faces", "uv", "face_uvs")  # of the mesh, in a checkpoint; the rest is derived


def unwrap_shape(
    shape: Mesh, config: TextureConfig, progress: Progress, keep_uv: bool = False
) -> UvMesh:
    """The shape within its face budget and with a uv; a mesh that has a sound uv stays as it is.

    With ``keep_uv`` its own uv is used even where faces share texels.
    """
    if keep_uv:
        return _with_own_uv(shape, progress)
    if shape.uv is not None and shape.face_uvs is not None:
        faults = uv_faults(shape.uv, shape.face_uvs)
        if not faults:
            return UvMesh.of(shape)
        progress.warn(
            f"The mesh's own UV map can't take a texture. {' '.join(faults)}",
            "A new one is made. To keep yours, unwrap it without overlaps inside the square.",
            stage="unwrap",
        )
    with progress.timed("unwrap"):
        # Before the unwrap, whose charts would not survive it.
        verts, faces = simplify(shape.verts, shape.faces, config.max_faces)
        atlas = unwrap(verts, faces, config.size, _hundredths("unwrap", progress))
        progress.complete("unwrap")  # a small mesh is done before it reports anything
    return UvMesh.of(Mesh(verts, faces, *atlas))


def _with_own_uv(shape: Mesh, progress: Progress) -> UvMesh:
    if shape.uv is None or shape.face_uvs is None:
        raise UserError("The mesh has no UV map to keep.", "Unwrap it, or have a new one made.")
    faults = uv_faults(shape.uv, shape.face_uvs)
    if OVERLAP in faults:
        faults.remove(OVERLAP)
        progress.warn(OVERLAP, "That is right for mirrored parts.", stage="unwrap")
    if faults:
        raise UserError(
            f"The mesh's own UV map can't take a texture. {' '.join(faults)}",
            "Fix the UV map, or have a new one made.",
        )
    return UvMesh.of(shape)


def load_unwrapped(run: RunFolder) -> UvMesh | None:
    """The unwrapped mesh of an earlier session of this run."""
    found = run.load("mesh")
    if found is None:
        return None
    with run.whole_checkpoint("mesh"):
        return UvMesh.of(Mesh(*(found[0][name] for name in PARTS)))


def save_unwrapped(run: RunFolder, mesh: UvMesh) -> None:
    """Keep the unwrapped mesh: from here on the geometry is not trained again."""
    run.save("mesh", {name: getattr(mesh, name) for name in PARTS}, {})


def bake_maps(mesh: UvMesh, net: MaterialNet, config: TextureConfig, progress: Progress) -> Maps:
    """Γ on every texel."""
    device = next(net.parameters()).device

    @torch.no_grad()
    def material(points: Float[Tensor, "n 3"]) -> Material:
        return Material(*(x.cpu() for x in net(points.to(device))))

    with progress.timed("bake"):
        return bake(
            Mesh(mesh.verts.cpu(), mesh.faces.cpu(), mesh.uv.cpu(), mesh.face_uvs.cpu()),
            material,
            config.size,
            _hundredths("bake", progress),
            config.samples,
        )


def _hundredths(stage: str, progress: Progress) -> Callable[[float], None]:
    """Reports the fraction of a stage that is done, and stops it where the user asks for it."""
    return lambda done: progress.advance(stage, round(100 * done), 100)
