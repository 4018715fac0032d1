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
from core.io.run_folder import RunFolder
from core.texture.bake import bake
from core.texture.simplify import simplify
from core.texture.texels import OVERLAP, uv_faults
from core.texture.unwrap import unwrap


def unwrap_shape(
    shape: Mesh, config: TextureConfig, run: RunFolder, keep_uv: bool = False
) -> UvMesh:
    """The shape within its face budget and with a uv; a mesh that has a sound uv stays as it is.

    With ``keep_uv`` its own uv is taken even where faces share texels.
    """
    if keep_uv:
        return _with_own_uv(shape, run)
    if shape.uv is not None and shape.face_uvs is not None:
        faults = uv_faults(shape.uv, shape.face_uvs)
        if not faults:
            return UvMesh.of(shape)
        run.say(
            "warning",
            stage="unwrap",
            text=f"The mesh's own UV map can't take a texture. {' '.join(faults)}",
            fix="A new one is made. To keep yours, unwrap it without overlaps inside the square.",
        )
    with run.timed("unwrap"):
        verts, faces = simplify(shape.verts, shape.faces, config.max_faces)
        atlas = unwrap(verts, faces, config.size, _progress("unwrap", run))
        run.tell("unwrap", 100, 100)  # a small mesh is done before it ever told its progress
    return UvMesh.of(Mesh(verts, faces, *atlas))


def _with_own_uv(shape: Mesh, run: RunFolder) -> UvMesh:
    if shape.uv is None or shape.face_uvs is None:
        raise UserError("The mesh has no UV map to keep.", "Unwrap it, or have a new one made.")
    faults = uv_faults(shape.uv, shape.face_uvs)
    if OVERLAP in faults:
        faults.remove(OVERLAP)
        run.say("warning", stage="unwrap", text=OVERLAP, fix="That is right for mirrored parts.")
    if faults:
        raise UserError(
            f"The mesh's own UV map can't take a texture. {' '.join(faults)}",
            "Mend the UV map, or have a new one made.",
        )
    return UvMesh.of(shape)


def bake_maps(mesh: UvMesh, net: MaterialNet, config: TextureConfig, run: RunFolder) -> Maps:
    """Γ on every texel."""
    device = next(net.parameters()).device

    @torch.no_grad()
    def material(points: Float[Tensor, "n 3"]) -> Material:
        return Material(*(x.cpu() for x in net(points.to(device))))

    with run.timed("bake"):
        return bake(
            Mesh(mesh.verts.cpu(), mesh.faces.cpu(), mesh.uv.cpu(), mesh.face_uvs.cpu()),
            material,
            config.size,
            _progress("bake", run),
            config.samples,
        )


def _progress(stage: str, run: RunFolder) -> Callable[[float], None]:
    """Tells the run how far a stage is, in hundredths, and stops it where the user asks for it."""
    return lambda share: run.advance(stage, round(100 * share), 100)
