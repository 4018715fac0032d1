"""STL and 3MF for 3D printing: a closed mesh in millimetres, +Z up, without its colours."""

import io
import zipfile

import numpy as np
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.mesh import health

MILLIMETRES = 1000.0
# The parts of a 3MF package besides its model (3MF Core Specification, 2: "3MF Documents").
TYPES = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
    '<Default Extension="rels" '
    'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    '<Default Extension="model" '
    'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'
)
RELATIONS = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
    '<Relationship Target="/3D/3dmodel.model" Id="rel0" '
    'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
)


def check_printable(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> None:
    """Raises UserError for a mesh that encloses no volume: a slicer would guess."""
    report = health(verts, faces)
    if not (report["closed"] and report["manifold"] and report["oriented"]):
        turned = "" if report["oriented"] else ", and not all faces look outwards"
        raise UserError(
            f"The mesh is not watertight: {report['open_edges']} open and "
            f"{report['nonmanifold_edges']} non-manifold edges{turned}.",
            "Repair it in Blender (Mesh Health), or generate the asset again.",
        )


def stl_bytes(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> bytes:
    """Binary STL: an 80-byte header, the count, and for each face its normal and corners."""
    corners = verts.detach().cpu().double().numpy()[faces.cpu().numpy()] * MILLIMETRES
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True).clip(1e-30)
    kind = np.dtype([("numbers", "<f4", (4, 3)), ("attribute", "<u2")])
    rows = np.zeros(len(corners), kind)
    rows["numbers"] = np.concatenate([normals[:, None], corners], 1)
    # Not "solid": readers take a file that starts with that word for the text format.
    head = b"Binary STL in millimetres, Fantasia3D for Blender".ljust(80)
    return head + np.uint32(len(rows)).astype("<u4").tobytes() + rows.tobytes()


def three_mf_bytes(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> bytes:
    """A 3MF package with one object, its vertices welded."""
    points = tuple((verts.detach().cpu().double() * MILLIMETRES).reshape(-1).tolist())
    corners = tuple(faces.cpu().reshape(-1).tolist())
    model = (
        '<?xml version="1.0" encoding="UTF-8"?>\n<model unit="millimeter" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
        '<resources><object id="1" type="model"><mesh><vertices>'
        + '<vertex x="%.7g" y="%.7g" z="%.7g"/>' * len(verts) % points
        + "</vertices><triangles>"
        + '<triangle v1="%d" v2="%d" v3="%d"/>' * len(faces) % corners
        + '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>'
    )
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as file:
        parts = (("[Content_Types].xml", TYPES), ("_rels/.rels", RELATIONS))
        for name, text in (*parts, ("3D/3dmodel.model", model)):
            # A fixed time: the same asset gives the same file. Such an entry has its own packing.
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            file.writestr(entry, text, zipfile.ZIP_DEFLATED)
    return packed.getvalue()
