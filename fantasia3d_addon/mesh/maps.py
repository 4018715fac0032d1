"""The maps of an object's material as arrays: read from its pictures, or else baked."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy
import numpy as np

from ..asset.asset_folder import OPTIONAL, USUAL, Light
from ..background.thread import ReportProgress, ignore_progress
from ..blender import compat
from ..blender.mesh_arrays import acting, baked_mesh, enabled, evaluated_object, use_uv_map
from ..blender.png import to_bytes, write_png
from ..errors import AddonError
from ..material.edit import EDITS, edit_nodes, factor, picture_of, principled

SOCKETS = {
    "base_color": "Base Color",
    "roughness": "Roughness",
    "metallic": "Metallic",
    "emission": "Emission Color",
    "transmission": "Transmission Weight",
}
COLORS = ("base_color", "emission")
EXTRUSION = 0.002  # of the object's size, for a bake of an object onto itself
FLAT = (0.5, 0.5, 1.0)  # the normal map of a smooth surface


@dataclass(frozen=True)
class Maps:
    """Row 0 at the top; values from 0 to 1."""

    base_color: np.ndarray  # (H,W,3) sRGB
    roughness: np.ndarray  # (H,W) linear
    metallic: np.ndarray  # (H,W) linear
    normal: np.ndarray  # (H,W,3) tangent space, OpenGL
    emission: np.ndarray | None = None  # (H,W,3) sRGB; None: nothing glows
    transmission: np.ndarray | None = None  # (H,W) linear; None: nothing is clear
    light: Light = USUAL  # what these two are taken with

    @property
    def orm(self) -> np.ndarray:
        """(H,W,3): occlusion 1, roughness, metallic."""
        return np.stack([np.ones_like(self.roughness), self.roughness, self.metallic], -1)


def maps_of(obj: bpy.types.Object, size: int = 0) -> Maps:
    """The maps of ``obj`` over :func:`uv_map_of`, with the tint and the scales in them.

    ``size``: texels along a side of the result; 0 is the size of its pictures, or 1024.

    Raises:
        AddonError: it has no UVs, its material has no Principled BSDF, or a picture is lost.
    """
    if obj.data.uv_layers.active is None:
        raise AddonError(f"{obj.name} has no UVs.", "Press Create UVs under Mesh Health.")
    bsdfs = _bsdfs(obj)
    if not bsdfs or None in bsdfs:
        raise AddonError(
            f"{obj.name} has a material without a Principled BSDF.", "Use one that has it."
        )
    images = [node.image for node in _pictures(bsdfs)]
    for image in images:
        if not all(image.size):
            raise AddonError(
                f"The picture “{image.name}” can't be read.",
                "Find its file: File, External Data, Find Missing Files.",
            )
    # The largest picture decides: no map loses detail.
    size = size or max((max(image.size) for image in images), default=1024)
    if len(bsdfs) > 1:  # each face shows one of them: only a bake joins them
        return bake_maps(obj, obj, size, EXTRUSION)
    uv_map = uv_map_of(obj)
    given = {name: _read(obj, bsdfs[0], name, size, uv_map) for name in channels_of(bsdfs)}
    wanted = [name for name, value in given.items() if value is None]
    baked = bake_channels(obj, obj, size, EXTRUSION, wanted, uv_map=uv_map) if wanted else {}
    found = {name: _resized(v, size) for name, v in (given | baked).items()}
    return Maps(**found, light=light_of(bsdfs))


def uv_map_of(obj: bpy.types.Object) -> str:
    """The UV map of the pictures of its only material, where none is over the active one.

    Else the active one.
    """
    active = obj.data.uv_layers.active.name
    bsdfs = _bsdfs(obj)
    pictures = _pictures(bsdfs) if len(bsdfs) == 1 and bsdfs[0] else ()
    used = [_uv_map_of(node, obj.data) for node in pictures]
    known = [name for name in used if name and name in obj.data.uv_layers]
    return active if active in known or not known else known[0]


def channels_of(bsdfs: list[bpy.types.Node]) -> list[str]:
    """The fields of :class:`Maps` that these nodes have."""
    absent = {role for role in OPTIONAL if not any(_has(bsdf, role) for bsdf in bsdfs)}
    return [name for name in (*SOCKETS, "normal") if name not in absent]


def _has(bsdf: bpy.types.Node, role: str) -> bool:
    """Whether any of the node's surface may glow, or be clear."""
    socket = bsdf.inputs[SOCKETS[role]]
    if role == "emission":
        strength = bsdf.inputs["Emission Strength"]
        on = bool(strength.links) or strength.default_value > 0
        return on and (bool(socket.links) or any(socket.default_value[:3]))
    return bool(socket.links) or socket.default_value > 0


def light_of(bsdfs: list[bpy.types.Node]) -> Light:
    """The greatest strength of the nodes that glow, and the IOR of the first that is clear."""
    glowing = [bsdf.inputs["Emission Strength"] for bsdf in bsdfs if _has(bsdf, "emission")]
    clear = [bsdf.inputs["IOR"].default_value for bsdf in bsdfs if _has(bsdf, "transmission")]
    # What feeds a strength is baked into the map.
    strengths = [1.0 if socket.links else socket.default_value for socket in glowing]
    given = {"strength": max(strengths, default=None), "ior": next(iter(clear), None)}
    return Light(**{name: value for name, value in given.items() if value is not None})


def bake_maps(
    source: bpy.types.Object,
    target: bpy.types.Object,
    size: int,
    extrusion: float,
    progress: ReportProgress = ignore_progress,
) -> Maps:
    """The maps of ``source`` over the UVs of ``target``, which may be the same object.

    ``extrusion``: the greatest distance of the two surfaces, as a fraction of the object's size.
    ``progress`` is called before each map.
    """
    bsdfs = [principled(slot.material) for slot in source.material_slots]
    found, channels = {}, channels_of(bsdfs)
    for number, channel in enumerate(channels):
        progress(channel, number / len(channels))
        found |= bake_channels(source, target, size, extrusion, [channel])
    return Maps(**found, light=light_of(bsdfs))


def bake_channels(
    source: bpy.types.Object,
    target: bpy.types.Object,
    size: int,
    extrusion: float,
    channels: list[str],
    *,
    uv_map: str = "",
) -> dict[str, np.ndarray]:
    """Some of the fields of :class:`Maps`, baked by Cycles; ``uv_map``: by default the active one.

    Values are baked as emission: a bake of diffuse colour is black where the material is metal.
    """
    with (
        enabled(source) as source,  # Blender bakes from what the view layer has alone
        _receiver(target, size, uv_map) as (receiver, image),
        _bake_settings(),
    ):
        reach = extrusion * max(source.dimensions)
        found = {}
        for channel in channels:
            if channel == "normal":
                _bake(source, receiver, "NORMAL", reach)
                found[channel] = _pixels(image)
                continue
            # Emission passes the value through Cycles unchanged.
            with _emitting(source, SOCKETS[channel]):
                _bake(source, receiver, "EMIT", reach)
            values = _pixels(image)
            found[channel] = to_srgb(values) if channel in COLORS else values[..., 0]
        return found


def save_images(
    maps: Maps, folder: Path, name: str, flip_normal_y: bool = False, split: bool = False
) -> dict[str, Path]:
    """Write the maps as PNG files into ``folder``: role to file.

    ``split``: roughness and metallic in files of their own, for formats without channels; else
    together as ``orm``. ``flip_normal_y``: DirectX's green.
    """
    # 1 - y turns the green channel around.
    normal = maps.normal * (1, -1, 1) + (0, 1, 0) if flip_normal_y else maps.normal
    pictures = {"base_color": to_bytes(maps.base_color), "normal": to_bytes(normal, 16)}
    if not split:
        pictures["orm"] = to_bytes(maps.orm)
    if maps.emission is not None:
        pictures["emission"] = to_bytes(maps.emission)
    for role in ("roughness", "metallic", "transmission"):
        values = getattr(maps, role)
        if values is not None and (split or role in OPTIONAL):
            pictures[role] = to_bytes(np.repeat(values[..., None], 3, -1))
    paths = {role: folder / f"{name}_{role}.png" for role in pictures}
    for role, picture in pictures.items():
        write_png(paths[role], picture)
    return paths


def load_images(paths: Mapping[str, Path], pack: bool) -> dict[str, bpy.types.Image]:
    """The files of :func:`save_images` as images, each in its colour space."""
    images = {}
    for role, path in paths.items():
        image = bpy.data.images.load(str(path), check_existing=False)
        if role in COLORS:
            image.colorspace_settings.name = "sRGB"
        else:
            image.colorspace_settings.is_data = True
        if pack:
            image.pack()
        images[role] = image
    return images


def to_srgb(linear: np.ndarray) -> np.ndarray:
    """Linear light from 0 to 1 as sRGB."""
    x = np.clip(linear, 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-9) ** (1 / 2.4) - 0.055)


def to_linear(srgb: np.ndarray) -> np.ndarray:
    """sRGB from 0 to 1 as linear light."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def _bsdfs(obj: bpy.types.Object) -> list[bpy.types.Node | None]:
    """The Principled node of each material of ``obj``; once of one that several slots show."""
    return [principled(m) for m in dict.fromkeys(slot.material for slot in obj.material_slots)]


def _pictures(bsdfs: list[bpy.types.Node]) -> Iterator[bpy.types.Node]:
    """The nodes of the pictures that feed these nodes."""
    for bsdf in bsdfs:
        names = [SOCKETS.get(name, "Normal") for name in channels_of(bsdfs)]
        for name in names:
            found = picture_of(bsdf.inputs[name])
            if found:
                yield found[0]


def _uv_map_of(picture: bpy.types.Node, mesh: bpy.types.Mesh) -> str | None:
    """The UV map that a picture's node is over; None where it is over something else."""
    shown = next((layer.name for layer in mesh.uv_layers if layer.active_render), "")
    links = picture.inputs["Vector"].links
    node = links[0].from_node if links else None
    if picture.projection != "FLAT":
        return None
    if node and node.bl_idname == "ShaderNodeUVMap":
        return node.uv_map or shown
    is_default = node is None or (
        node.bl_idname == "ShaderNodeTexCoord" and links[0].from_socket.name == "UV"
    )
    return shown if is_default else None


def _read(
    obj: bpy.types.Object, bsdf: bpy.types.Node, name: str, size: int, uv_map: str
) -> np.ndarray | None:
    """A field of :class:`Maps` from a picture or a constant; None where it must be baked."""
    found = picture_of(bsdf.inputs[SOCKETS.get(name, "Normal")])
    if found and (_uv_map_of(found[0], obj.data) != uv_map or found[1] == "Alpha"):
        return None
    if name == "normal":
        return _read_normal(bsdf.inputs["Normal"], found, size)
    socket, scale = bsdf.inputs[SOCKETS[name]], _scale(obj, name)
    if name == "emission" and bsdf.inputs["Emission Strength"].links:
        return None
    if found:
        return _read_picture((found[0].image, found[1]), name, scale)
    constant = _constant(socket)
    if constant is None:
        return None
    if name in COLORS:
        color = to_srgb(np.array(constant[:3]) * scale)
        return np.full((size, size, 3), color, np.float32)
    return np.full((size, size), np.clip(constant * scale, 0, 1), np.float32)


def _read_normal(
    socket: bpy.types.NodeSocket, found: tuple[bpy.types.Node, str] | None, size: int
) -> np.ndarray | None:
    if not socket.links:
        return np.full((size, size, 3), FLAT, np.float32)
    if not found or not _plain_normal_map(socket.links[0].from_node):
        return None
    return _pixels(found[0].image)


def _read_picture(found: tuple[bpy.types.Image, str], name: str, scale: np.ndarray) -> np.ndarray:
    image, channel = found
    values = _pixels(image)
    if name in COLORS:
        is_linear = image.is_float or image.colorspace_settings.is_data
        linear = values if is_linear else to_linear(values)
        # Without a tint, an 8 bit picture is copied exactly: no rounding through linear light.
        return values if np.all(scale == 1) and not is_linear else to_srgb(linear * scale)
    # "Color": a grey picture that is connected to the socket directly.
    index = {"Red": 0, "Green": 1, "Blue": 2}.get(channel, 0)
    return np.clip(values[..., index] * scale, 0, 1)


def _constant(socket: bpy.types.NodeSocket) -> Any:
    """The value of a socket without a map, also below our adjustment; None where it has nodes."""
    if not socket.links:
        return socket.default_value
    node = socket.links[0].from_node
    if not _is_edit(node):
        return None
    first = node.inputs[6] if node.type == "MIX" else node.inputs[0]  # 6: A of a colour mix
    return None if first.links else first.default_value


def _is_edit(node: bpy.types.Node) -> bool:
    return node.name.startswith("Fantasia3D ")


def _plain_normal_map(node: bpy.types.Node) -> bool:
    """Whether ``node`` is a normal map at its full strength and nothing else."""
    strength = node.inputs.get("Strength")
    return (
        node.type == "NORMAL_MAP"
        and node.space == "TANGENT"
        and strength is not None
        and abs(strength.default_value - 1) < 1e-6
        and getattr(node, "convention", "OPENGL") == "OPENGL"
    )


def _scale(obj: bpy.types.Object, name: str) -> np.ndarray:
    nodes = edit_nodes(obj.material_slots[0].material)
    node = next((node for node in nodes if EDITS[node.name] == SOCKETS[name]), None)
    if node is None:
        return np.float64(1.0)
    value = factor(node).default_value
    return np.array(value[:3]) if name == "base_color" else np.float64(value)


def _pixels(image: bpy.types.Image) -> np.ndarray:
    """(H,W,3) as in the file, row 0 at the top."""
    width, height = image.size
    flat = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(flat)
    picture = flat.reshape(height, width, image.channels)[::-1]
    return picture[..., :3] if image.channels >= 3 else np.repeat(picture[..., :1], 3, -1)


def _resized(values: np.ndarray, size: int) -> np.ndarray:
    """``values`` at ``size``: the nearest texel, so that nothing is blurred across islands."""
    if values.shape[:2] == (size, size):
        return values
    rows = (np.arange(size) + 0.5) * values.shape[0] / size
    columns = (np.arange(size) + 0.5) * values.shape[1] / size
    return values[rows.astype(int)[:, None], columns.astype(int)]


@contextlib.contextmanager
def _receiver(
    target: bpy.types.Object, size: int, uv_map: str = ""
) -> Iterator[tuple[bpy.types.Object, bpy.types.Image]]:
    """A copy of ``target`` with a material of its own, whose picture receives the bake."""
    # As it looks: without its modifiers it would be elsewhere than what is baked.
    mesh = baked_mesh(target)
    # Float: 8 bits would round the normals.
    image = bpy.data.images.new("Fantasia3D bake", size, size, alpha=False, float_buffer=True)
    image.colorspace_settings.is_data = True
    material = bpy.data.materials.new("Fantasia3D bake")
    tree = compat.empty_nodes(material)
    tree.nodes.active = tree.nodes.new("ShaderNodeTexImage")
    tree.nodes.active.image = image
    mesh.materials.clear()
    mesh.materials.append(material)
    # All faces use the one material that has the bake's picture.
    mesh.polygons.foreach_set("material_index", np.zeros(len(mesh.polygons), np.int32))
    receiver = bpy.data.objects.new("Fantasia3D bake", mesh)
    try:
        with evaluated_object(target) as evaluated:
            receiver.matrix_world = evaluated.matrix_world
        bpy.context.scene.collection.objects.link(receiver)
        use_uv_map(mesh, uv_map or target.data.uv_layers.active.name)
        bpy.context.view_layer.update()
        yield receiver, image
    finally:
        bpy.data.batch_remove([receiver, mesh, material, image])


@contextlib.contextmanager
def _emitting(obj: bpy.types.Object, socket: str) -> Iterator[None]:
    """Let ``obj`` emit what feeds ``socket`` of its Principled nodes."""
    own = [slot.material for slot in obj.material_slots]
    strongest = light_of([principled(material) for material in own]).strength
    # Copies, so that an error leaves the user's materials as they were.
    copies = [material.copy() for material in own]
    for slot, material in zip(obj.material_slots, copies, strict=True):
        slot.material = material
        bsdf, tree = principled(material), material.node_tree
        emission = tree.nodes.new("ShaderNodeEmission")
        source = bsdf.inputs[socket]
        if source.links:
            tree.links.new(source.links[0].from_socket, emission.inputs["Color"])
        else:
            value = source.default_value
            grey = not hasattr(value, "__len__")
            emission.inputs["Color"].default_value = (value, value, value, 1) if grey else value
        if socket == SOCKETS["emission"]:
            given, factor = bsdf.inputs["Emission Strength"], emission.inputs["Strength"]
            factor.default_value = given.default_value / strongest
            if given.links:
                part = tree.nodes.new("ShaderNodeMath")
                part.operation, part.inputs[1].default_value = "DIVIDE", strongest
                tree.links.new(given.links[0].from_socket, part.inputs[0])
                tree.links.new(part.outputs[0], factor)
        for link in list(bsdf.outputs["BSDF"].links):
            tree.links.new(emission.outputs["Emission"], link.to_socket)
    try:
        yield
    finally:
        for slot, material in zip(obj.material_slots, own, strict=True):
            slot.material = material
        bpy.data.batch_remove(copies)


@contextlib.contextmanager
def _bake_settings() -> Iterator[None]:
    """Cycles on the CPU, few samples, no denoiser (a bake without an installed one is empty)."""
    if not compat.has_cycles():
        raise AddonError("This Blender has no Cycles.", "Enable its add-on Cycles Render Engine.")
    scene = bpy.context.scene
    wanted = {
        scene.render: {"engine": "CYCLES"},
        scene.cycles: {"device": "CPU", "samples": 4, "use_denoising": False},
        scene.render.bake: {"use_clear": True, "margin": 16, "margin_type": "EXTEND",
                            "normal_space": "TANGENT", "normal_g": "POS_Y"},
    }  # fmt: skip
    # The user's own settings are restored, also after an error.
    before = [(owner, {name: getattr(owner, name) for name in of}) for owner, of in wanted.items()]
    try:
        for owner, names in wanted.items():
            for name, value in names.items():
                setattr(owner, name, value)
        yield
    finally:
        for owner, names in before:
            for name, value in names.items():
                setattr(owner, name, value)


def _bake(source: bpy.types.Object, receiver: bpy.types.Object, kind: str, reach: float) -> None:
    hidden = source.hide_render
    source.hide_render = False
    try:
        with acting(receiver):
            # Cycles bakes from the selected objects to the active one.
            source.select_set(True)
            with bpy.context.temp_override(selected_objects=[source, receiver]):
                bpy.ops.object.bake(
                    type=kind, use_selected_to_active=True, cage_extrusion=reach,
                    max_ray_distance=2 * reach, target="IMAGE_TEXTURES",
                )  # fmt: skip
    finally:
        source.hide_render = hidden
