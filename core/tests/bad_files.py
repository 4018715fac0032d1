"""The files that the table of bad inputs (``bad_inputs.txt``) names, made in one folder."""

import json
import os
import shutil
import struct
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import torch

from core.geometry.mesh import Mesh
from core.io.asset import write_asset
from core.io.exr import write_exr
from core.io.maps import Maps

SOME_FILES = ("asset.json", "mesh.obj", "orm.png", "asset.glb")  # of an asset, one of each kind
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], np.uint32)
JOB = {"version": 1, "prompt": "a red cube"}  # the least that a job.json holds
OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
PLY = (
    "ply\nformat %s 1.0\nelement vertex %s\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list %s int vertex_indices\nend_header\n"
)


def make(folder: Path) -> None:
    """Every file, folder and link of the table; fewer than 200, a few kilobytes each."""
    for name, data in (meshes() | pictures()).items():
        (folder / name).write_bytes(data)
    light = torch.ones(8, 16, 3)
    write_exr(folder / "ok.exr", light)
    write_exr(folder / "black.exr", 0 * light)
    write_exr(folder / "square.exr", light[:, :8])
    bad = light.clone()
    bad[2, 3] = torch.nan
    write_exr(folder / "nan.exr", bad)
    whole = (folder / "ok.exr").read_bytes()
    (folder / "cut.exr").write_bytes(whole[: len(whole) // 2])
    (folder / "huge.exr").write_bytes(huge_exr(whole))
    for name in ("folder", "folder.obj", "folder.exr", "folder.png", "folder.glb"):
        (folder / name).mkdir()
        (folder / name / "mine.txt").write_text("the user's")
    (folder / "loop").symlink_to("loop")
    for suffix in ("obj", "exr", "png"):
        (folder / f"loop.{suffix}").symlink_to(f"loop.{suffix}")
        (folder / f"dangling.{suffix}").symlink_to(f"nowhere.{suffix}")
        (folder / f"zero.{suffix}").symlink_to("/dev/zero")
    if hasattr(os, "mkfifo"):
        for suffix in ("obj", "exr", "hdr", "png"):
            os.mkfifo(folder / f"pipe.{suffix}")
    make_assets(folder)
    for name, text in jobs().items():
        (folder / f"run-{name}").mkdir()
        (folder / f"run-{name}" / "job.json").write_bytes(text)
    faces = {
        "": "0\n1\n",
        "-none": " \n",
        "-word": "0\nx\n",
        "-beyond": "99999\n",
        "-minus": "-1\n",
    }
    for name, text in faces.items():
        (folder / f"faces{name}.txt").write_text(text)
    lock(folder)


def lock(folder: Path) -> None:
    """Files that may not be read, and a folder that may not be written."""
    (folder / "locked").mkdir()
    for suffix in ("obj", "exr", "png"):
        path = shutil.copy(folder / f"ok.{suffix}", folder / f"locked.{suffix}")
        path.chmod(0)
    (folder / "run-locked" / "job.json").chmod(0)
    for name in SOME_FILES:
        (folder / f"asset-locked-{name}" / name).chmod(0)
    (folder / "locked").chmod(0o555)


def meshes() -> dict[str, bytes]:
    """Meshes that are none, each with its name."""
    face = b"f 1 2 3\n"
    whole = glb()
    return {
        "ok.obj": OBJ + b"f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
        "uv.obj": OBJ + b"vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n",
        "empty.obj": b"", "empty.ply": b"", "empty.stl": b"", "empty.glb": b"", "empty.gltf": b"",
        "text.obj": b"hello\n", "text.ply": b"hello\n", "text.stl": b"hello\n",
        "text.glb": b"hello, no glTF\n", "text.gltf": b"hello\n", "zip.obj": b"PK\3\4" + bytes(99),
        "png.obj": png(4, 4), "mesh.txt": OBJ + face, "mesh": OBJ + face, "mesh.fbx": OBJ + face,
        "points.obj": OBJ, "lines.obj": OBJ + b"l 1 2\n", "corners.obj": OBJ + b"f 1 2\n",
        "nan.obj": b"v 0 0 0\nv nan 0 0\nv 0 1 0\n" + face,
        "huge.obj": b"v 0 0 0\nv 1e39 0 0\nv 0 1 0\n" + face,
        "word.obj": b"v 0 0 0\nv one 0 0\nv 0 1 0\n" + face,
        "index.obj": OBJ + b"f 1 2 9\n", "zero.index.obj": OBJ + b"f 0 0 0\n",
        "index64.obj": OBJ + b"f 1 2 99999999999999999999999\n",
        "negative.obj": OBJ + b"f 1 2 -9\n", "point.obj": b"v 1 1 1\n" * 3 + face,
        "line.obj": b"v 0 0 0\nv 1 1 1\nv 0 0 0\n" + face,
        "header.ply": (PLY % ("ascii", 3, "uchar")).encode(),
        "count.ply": (PLY % ("binary_little_endian", 10**12, "uchar")).encode() + bytes(99),
        "ascii-count.ply": (PLY % ("ascii", 10**12, "uchar")).encode() + b"0 0 0\n",
        "negative-count.ply": (PLY % ("binary_little_endian", -7, "uchar")).encode() + bytes(99),
        "list.ply": (PLY % ("binary_little_endian", 3, "uint")).encode() + b"\xff" * 99,
        "format.ply": (PLY % ("morse", 3, "uchar")).encode(),
        "index.ply": (PLY % ("ascii", 3, "uchar")).encode() + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n",
        "count.stl": bytes(80) + struct.pack("<I", 4 * 10**9) + bytes(50),
        "none.stl": bytes(80) + struct.pack("<I", 0),
        "cut.stl": bytes(80) + struct.pack("<I", 2) + bytes(60),
        "ascii.stl": b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
        "cut.glb": whole[:60], "magic.glb": b"gLTF" + whole[4:],
        "version.glb": whole[:4] + struct.pack("<I", 1) + whole[8:],
        "length.glb": whole[:8] + struct.pack("<I", 2**32 - 1) + whole[12:],
        "chunk.glb": whole[:12] + struct.pack("<I", 2**32 - 1) + whole[16:],
        "index.glb": glb(indices=[0, 1, 9]), "count.glb": glb(count=10**12),
        "zeros.glb": glb(zeros=10**10), "stride.glb": glb(stride=10**9),
        "view.glb": glb(view=7), "type.glb": glb(type="VEC99"), "list.glb": packed(b"[]"),
        "nested.glb": packed(b"[" * 99999 + b"]" * 99999), "latin1.glb": packed(b'{"\xff": 1}'),
        "draco.glb": glb(extensionsRequired=["KHR_draco_mesh_compression"], count=None),
        "outside.gltf": json.dumps(tree(uri="../../../etc/passwd")).encode(),
        "device.gltf": json.dumps(tree(uri="/dev/zero")).encode(),
        "missing.gltf": json.dumps(tree(uri="nowhere.bin")).encode(),
        "online.gltf": json.dumps(tree(uri="https://example.org/a.bin")).encode(),
    }  # fmt: skip


def tree(
    count: int | None = 3,
    view: int = 0,
    type: str = "VEC3",
    zeros: int = 0,
    stride: int = 0,
    uri: str = "",
    **more: Any,
) -> dict[str, Any]:
    """The JSON of a glTF triangle; each argument breaks one part of it."""
    position: dict[str, Any] = {"componentType": 5126, "count": count, "type": type}
    position |= {"count": zeros} if zeros else {"bufferView": view}
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            position,
            {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36} | ({"byteStride": stride} if stride else {}),
            {"buffer": 0, "byteOffset": 36, "byteLength": 12},
        ],
        "buffers": [{"byteLength": 48} | ({"uri": uri} if uri else {})],
    } | more


def glb(indices: list[int] | None = None, **broken: Any) -> bytes:
    """A binary glTF of one triangle."""
    data = CORNERS[:3].tobytes() + np.array(indices or [0, 1, 2], np.uint32).tobytes()
    return packed(json.dumps(tree(**broken)).encode(), data)


def packed(text: bytes, data: bytes = bytes(48)) -> bytes:
    """The two chunks of a binary glTF."""
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def png(width: int, height: int, bits: int = 8, channels: int = 3, rows: bytes = b"") -> bytes:
    """A PNG of zeros; ``rows`` instead of them where the size is only declared."""
    kind = {1: 0, 3: 2, 4: 6}[channels]
    rows = rows or (b"\0" * (1 + width * channels * bits // 8)) * height
    chunks = [
        (b"IHDR", struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)),
        (b"IDAT", zlib.compress(rows)),
        (b"IEND", b""),
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in chunks
    )


def hdr(width: int, height: int, rows: int | None = None) -> bytes:
    """A flat Radiance picture of ``rows`` rows."""
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode()
    return head + b"\x80\x80\x80\x80" * width * (height if rows is None else rows)


def huge_exr(whole: bytes) -> bytes:
    """A small EXR that declares 60000 x 60000 pixels."""
    place = whole.index(b"dataWindow\0box2i\0") + len(b"dataWindow\0box2i\0") + 4
    return whole[:place] + struct.pack("<4i", 0, 0, 59999, 59999) + whole[place + 16 :]


def pictures() -> dict[str, bytes]:
    """Pictures that are no light, or none at all."""
    return {
        "empty.exr": b"", "empty.hdr": b"", "empty.png": b"", "text.exr": b"hello\n",
        "text.hdr": b"hello\n", "text.png": b"hello\n", "png.exr": png(4, 4), "png.hdr": png(4, 4),
        "light.png": png(16, 8), "light.jpg": b"\xff\xd8\xff\xe0" + bytes(99), "light": b"light",
        "cut.hdr": hdr(16, 8, rows=3), "huge.hdr": hdr(60000, 60000, rows=0),
        "bomb.hdr": hdr(32768, 16384, rows=0), "flat.hdr": hdr(16, 0), "ok.hdr": hdr(16, 8),
        "square.hdr": hdr(16, 16), "cut.png": png(16, 16)[:60],
        "huge.png": png(60000, 60000, rows=bytes(99)),
        "bomb.png": png(20000, 20000, rows=bytes(99)), "ok.png": png(4, 4),
    }  # fmt: skip


def make_assets(folder: Path) -> None:
    """``asset``, a whole one, and one for each way in which it may be broken."""
    verts, faces = torch.from_numpy(CORNERS), torch.from_numpy(FACES.astype(np.int64))
    uv = torch.tensor([[0.1, 0.1], [0.9, 0.1], [0.1, 0.9]])
    mesh = Mesh(verts, faces, uv, torch.tensor([[0, 2, 1]] * 4))

    def write(name: str, size: int) -> Path:
        flat = torch.tensor([0.0, 0.0, 1.0]).expand(size, size, 3)
        grey = torch.full((size, size, 3), 0.5)
        maps = Maps(grey, grey, flat)
        return write_asset(folder / name, mesh, maps, {"prompt": "a red cube", "timings": {}})

    good = write("asset", 16)
    write("whole", 64)  # of a size that a material can be made for
    for name, change in broken_assets().items():
        copy = Path(shutil.copytree(good, folder / f"asset-{name}"))
        change(copy)


Change = Callable[[Path], object]


def with_info(**info: Any) -> Change:
    """asset.json with other values."""

    def change(asset: Path) -> None:
        text = (asset / "asset.json").read_text(encoding="utf-8")
        (asset / "asset.json").write_text(json.dumps(json.loads(text) | info), encoding="utf-8")

    return change


def with_file(name: str, data: bytes | None) -> Change:
    """Another content of a file; None removes it."""

    def change(asset: Path) -> None:
        (asset / name).unlink()
        if data is not None:
            (asset / name).write_bytes(data)

    return change


def with_folder(name: str) -> Change:
    """A folder in place of a file."""

    def change(asset: Path) -> None:
        (asset / name).unlink()
        (asset / name).mkdir()

    return change


def with_pipe(name: str) -> Change:
    """A pipe in place of a file."""

    def change(asset: Path) -> None:
        (asset / name).unlink()
        os.mkfifo(asset / name)

    return change


def with_link(name: str, to: str) -> Change:
    """A link in place of a file."""

    def change(asset: Path) -> None:
        (asset / name).unlink()
        (asset / name).symlink_to(to)

    return change


def cut(name: str) -> Change:
    """The first half of a file."""

    def change(asset: Path) -> None:
        data = (asset / name).read_bytes()
        (asset / name).write_bytes(data[: len(data) // 2])

    return change


def broken_assets() -> dict[str, Change]:
    """How each of the broken assets differs from the whole one."""
    corner = b"vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n"
    return {
        "no-json": with_file("asset.json", None), "empty-json": with_file("asset.json", b""),
        "cut-json": cut("asset.json"), "list": with_file("asset.json", b"[1, 2]"),
        "nested": with_file("asset.json", b"[" * 99999 + b"]" * 99999),
        "latin1": with_file("asset.json", b'{"version": 1, "prompt": "K\xf6rper"}'),
        "nan": with_file("asset.json", b'{"version": NaN}'),
        "digits": with_file("asset.json", b'{"version": 1' + b"0" * 5000 + b"}"),
        "large-json": with_file("asset.json", b" " * (9 << 20)),
        "json-folder": with_folder("asset.json"),
        "json-loop": with_link("asset.json", "asset.json"),
        "version": with_info(version=99), "version-text": with_info(version="1"),
        "mesh-number": with_info(mesh=3), "count": with_info(mesh={"verts": 7}),
        "count-text": with_info(mesh={"faces": "four"}),
        "no-obj": with_file("mesh.obj", None), "empty-obj": with_file("mesh.obj", b""),
        "cut-obj": cut("mesh.obj"), "obj-folder": with_folder("mesh.obj"),
        "obj-loop": with_link("mesh.obj", "mesh.obj"),
        "nan-obj": with_file("mesh.obj", b"v nan 0 0\n" * 3 + corner + b"f 1/1/1 2/2/2 3/3/3\n"),
        "huge-obj": with_file("mesh.obj", b"v 1e39 0 0\n" * 3 + corner + b"f 1/1/1 2/2/1 3/3/1\n"),
        "index-obj": with_file("mesh.obj", OBJ + corner + b"f 1/1/1 2/2/1 9/3/1\n"),
        "index64-obj": with_file(
            "mesh.obj", OBJ + corner + b"f 1/1/1 2/2/1 3/9%s/1\n" % (b"9" * 30)
        ),
        "no-png": with_file("orm.png", None), "empty-png": with_file("orm.png", b""),
        "cut-png": cut("base_color.png"), "text-png": with_file("orm.png", b"hello"),
        "huge-png": with_file("base_color.png", png(60000, 60000, rows=bytes(99))),
        "bomb-png": with_file("base_color.png", png(20000, 20000, rows=bytes(99))),
        "grey-png": with_file("orm.png", png(16, 16, channels=1)),
        "small-png": with_file("normal.png", png(8, 8)),
        "png-folder": with_folder("normal.png"), "png-loop": with_link("orm.png", "orm.png"),
        **{f"locked-{name}": lambda _: None for name in SOME_FILES},
        **{f"pipe-{name}": with_pipe(name) for name in SOME_FILES if hasattr(os, "mkfifo")},
        "half": with_info(prompt="a red \ud800 cube"), "whole-number": with_info(density=10**400),
        "infinite": with_file("asset.json", b'{"version": 1, "density": 1e999}'),
        "job-key": with_info(job={"version": 1, "prompt": "a red cube", "evil": 1}),
        "job-empty": with_info(job={}), "job-long": with_info(job=JOB | {"light": "x" * 5000}),
        "hashes": with_info(job=JOB, hashes=[1]), "made-by": with_info(job=JOB, made_by="x"),
        "link-orm.png": with_link("orm.png", "../ok.png"),
        "link-asset.glb": with_link("asset.glb", "../folder/mine.txt"),
        "no-glb": with_file("asset.glb", None), "glb-folder": with_folder("asset.glb"),
    }  # fmt: skip


def jobs() -> dict[str, bytes]:
    """job.json of runs that cannot be resumed."""

    def job(**given: Any) -> bytes:
        return json.dumps({"version": 1, "prompt": "a red cube"} | given).encode()

    def set_(**values: Any) -> bytes:
        return job(settings={key.replace("__", "."): value for key, value in values.items()})

    return {
        "ok": job(), "locked": job(), "empty": b"", "text": b"hello", "list": b"[]",
        "cut": job()[:20],
        "latin1": b'{"version": 1, "prompt": "K\xf6rper"}', "nan": b'{"version": NaN}',
        "nested": b"[" * 99999 + b"]" * 99999, "large": b" " * (9 << 20),
        "version": job(version=2), "version-none": b'{"prompt": "a red cube"}',
        "key": job(sede=3), "no-prompt": b'{"version": 1}', "prompt-list": job(prompt=[]),
        "prompt-empty": job(prompt=" "), "prompt-long": job(prompt="a" * 3000),
        "surrogate": job(prompt="a red cube \udcff"), "command": job(command="destroy"),
        "seed-text": job(seed="1"), "seed-true": job(seed=True), "seed-half": job(seed=0.5),
        "seed-large": job(seed=10**200), "preset": job(preset="fast"),
        "preset-list": job(preset=[]),
        "strength": job(guide_strength=7), "strength-large": job(guide_strength=10**200),
        "texture-size": job(texture_size=7), "max-faces": job(max_faces=7),
        "device": job(device="abacus"), "device-number": job(device="cpu:x"),
        "light-nul": job(light="a\0b.exr"), "mesh-nul": job(command="texture", mesh="a\0b.obj"),
        "light-long": job(light="x" * 300 + ".exr"),
        "guide-long": job(guide_mesh="x" * 300 + ".obj"),
        "guidance-long": job(guidance="x" * 300), "guidance-nul": job(guidance="a\0b"),
        "base-color": job(base_color="mesh"), "uv": job(uv="maybe"),
        "settings-list": job(settings=[]), "set-name": set_(geometry=3),
        "set-bool": set_(geometry__views=True), "set-half": set_(geometry__views=2.5),
        "set-none": set_(geometry__views=None), "set-large": set_(geometry__views=10**200),
        "set-list": set_(geometry__radii=[1, 2]), "set-object": set_(geometry__radii={"a": 1}),
        "set-nested": set_(geometry__radii=[[1], 1, 1]),
        "set-word": set_(geometry__coarse__weighting=["sigma2"]),
        "digits": job(seed=10**400), "infinite": job()[:-1] + b', "guide_strength": 1e999}',
    }  # fmt: skip
