"""USD Physics as text: a rigid body with mass, convex colliders, a mesh and its material.

UsdPhysics as of OpenUSD 21.11. Z up, metres, kilograms. Isaac Sim and Omniverse read it; other USD
viewers show the mesh, since the colliders are guides.
"""

import json

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.spatial.transform import Rotation
from torch import Tensor

from core.geometry.tangents import smooth_normals
from core.io.maps import EMISSION_STRENGTH, IOR
from core.simulation.body import Body

MAPS = {  # role: the shader's input, its type, the picture's output and colour space
    "base_color": ("diffuseColor", "color3f", "rgb", "sRGB"),
    "roughness": ("roughness", "float", "g", "raw"),
    "metallic": ("metallic", "float", "b", "raw"),
    "normal": ("normal", "normal3f", "rgb", "raw"),
    "emission": ("emissiveColor", "color3f", "rgb", "sRGB"),
    "transmission": ("opacity", "float", "r", "raw"),
}
LIGHT = f"({EMISSION_STRENGTH}, {EMISSION_STRENGTH}, {EMISSION_STRENGTH}, 1)"
# The change of a picture's values for the input, as (bias, scale). A normal map's 0 to 1 means -1
# to 1 (UsdPreviewSurface Specification, "normal"); opacity is what does not go through.
SHIFTS = {
    "normal": ("(-1, -1, -1, 0)", "(2, 2, 2, 1)"),
    "emission": ("(0, 0, 0, 0)", LIGHT),
    "transmission": ("(1, 1, 1, 0)", "(-1, -1, -1, 1)"),
}


def usd_text(body: Body, folder: str) -> str:
    """The .usda file; ``folder`` holds the pictures."""
    moments, axes = body.mass.principal
    x, y, z, w = Rotation.from_matrix(axes.numpy()).as_quat()
    head = (
        f'#usda 1.0\n(\n    defaultPrim = "{body.name}"\n    doc = {_quoted(body.title)}\n'
        '    kilogramsPerUnit = 1\n    metersPerUnit = 1\n    upAxis = "Z"\n)\n\n'
    )
    physics = (
        f"    float physics:mass = {body.mass.mass:.9g}\n"
        f"    point3f physics:centerOfMass = {_tuple(body.mass.center)}\n"
        f"    float3 physics:diagonalInertia = {_tuple(moments)}\n"
        f"    quatf physics:principalAxes = {_tuple(torch.tensor([w, x, y, z]))}\n\n"
    )
    apis = '"PhysicsRigidBodyAPI", "PhysicsMassAPI"'
    return (
        f'{head}def Xform "{body.name}" (\n    kind = "component"\n'
        f"    prepend apiSchemas = [{apis}]\n)\n{{\n{physics}"
        f"{_visual(body)}{_colliders(body)}{_material(body, folder)}}}\n"
    )


def _visual(body: Body) -> str:
    mesh, path = body.asset.mesh, f"/{body.name}/Looks/Material"
    uv, face_uvs = mesh.atlas
    normals = smooth_normals(mesh.verts, mesh.faces)
    return (
        '    def Mesh "visual" (\n        prepend apiSchemas = ["MaterialBindingAPI"]\n    )\n'
        "    {\n"
        f"        rel material:binding = <{path}>\n{_geometry(mesh.verts, mesh.faces)}"
        f'        normal3f[] normals = {_tuples(normals)} (interpolation = "vertex")\n'
        f'        texCoord2f[] primvars:st = {_tuples(uv)} (interpolation = "faceVarying")\n'
        f"        int[] primvars:st:indices = {_numbers(face_uvs)}\n    }}\n\n"
    )


def _colliders(body: Body) -> str:
    apis = '"PhysicsCollisionAPI", "PhysicsMeshCollisionAPI"'
    hulls = "".join(
        f'        def Mesh "hull_{i:02}" (\n            prepend apiSchemas = [{apis}]\n        )\n'
        '        {\n            uniform token physics:approximation = "convexHull"\n'
        f'            uniform token purpose = "guide"\n{_geometry(verts, faces)}        }}\n'
        for i, (verts, faces) in enumerate(body.hulls)
    )
    return f'    def Scope "Colliders"\n    {{\n{hulls}    }}\n\n'


def _geometry(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> str:
    extent = torch.stack([verts.amin(0), verts.amax(0)])
    return (
        f"        float3[] extent = {_tuples(extent)}\n"
        f"        int[] faceVertexCounts = [{', '.join(['3'] * len(faces))}]\n"
        f"        int[] faceVertexIndices = {_numbers(faces)}\n"
        f"        point3f[] points = {_tuples(verts)}\n"
        '        uniform token subdivisionScheme = "none"\n'
    )


def _material(body: Body, folder: str) -> str:
    path, maps = f"/{body.name}/Looks/Material", body.asset.maps
    roles = [role for role in MAPS if getattr(maps, role, True) is not None]
    inputs = "".join(
        f"                {kind} inputs:{socket}.connect = <{path}/{role}.outputs:{output}>\n"
        for role, (socket, kind, output, _) in ((role, MAPS[role]) for role in roles)
    )
    if maps.transmission is not None:
        inputs += f"                float inputs:ior = {IOR}\n"
    return (
        '    def Scope "Looks"\n    {\n        def Material "Material"\n        {\n'
        f"            token outputs:surface.connect = <{path}/surface.outputs:surface>\n"
        '            def Shader "surface"\n            {\n'
        f'                uniform token info:id = "UsdPreviewSurface"\n{inputs}'
        "                token outputs:surface\n            }\n"
        '            def Shader "st"\n            {\n'
        '                uniform token info:id = "UsdPrimvarReader_float2"\n'
        '                string inputs:varname = "st"\n                float2 outputs:result\n'
        f"            }}\n{''.join(_picture(path, folder, role) for role in roles)}"
        "        }\n    }\n"
    )


def _picture(path: str, folder: str, role: str) -> str:
    _, _, output, space = MAPS[role]
    file = "orm" if role in ("roughness", "metallic") else role
    shift = ""
    if role in SHIFTS:
        bias, scale = SHIFTS[role]
        shift = f"                float4 inputs:bias = {bias}\n"
        shift += f"                float4 inputs:scale = {scale}\n"
    kind = "float3" if output == "rgb" else "float"
    return (
        f'            def Shader "{role}"\n            {{\n'
        '                uniform token info:id = "UsdUVTexture"\n'
        f"                asset inputs:file = {_asset_path(f'./{folder}/{file}.png')}\n"
        f'                token inputs:sourceColorSpace = "{space}"\n'
        f"                float2 inputs:st.connect = <{path}/st.outputs:result>\n{shift}"
        f"                {kind} outputs:{output}\n            }}\n"
    )


def _tuples(rows: Float[Tensor, "n c"]) -> str:
    line = "(" + ", ".join(["%.9g"] * rows.shape[1]) + "), "
    values: np.ndarray = rows.detach().cpu().double().numpy()
    return "[" + (line * len(rows) % tuple(values.ravel().tolist()))[:-2] + "]"


def _tuple(row: Float[Tensor, " c"]) -> str:
    return _tuples(row[None])[1:-1]


def _numbers(indices: Int[Tensor, "f 3"]) -> str:
    return str(indices.cpu().reshape(-1).tolist())


def _asset_path(path: str) -> str:
    """Between three @ where the path has one itself (OpenUSD, "usda" format, asset values)."""
    mark = "@@@" if "@" in path else "@"
    return f"{mark}{path}{mark}"


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)
