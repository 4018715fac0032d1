"""Mutated files of every format: each reader returns its signature's type, or raises a UserError.

    pytest core/tests/runs/test_fuzz.py                                a few seconds
    FUZZ_COUNT=20000 pytest core/tests/runs/test_fuzz.py -m slow -s    so many files of each format

Every file follows from its format and its number alone. ``FUZZ_FIRST`` starts at another number.
"""

import contextlib
import json
import os
import random
import resource
import struct
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
import torch
from PIL import Image

from core.errors import UserError
from core.geometry.mesh import Mesh, health
from core.geometry.tangents import shading_normals
from core.io.exr import read_exr, write_exr
from core.io.hdr import read_hdr
from core.io.job import Job, read_events
from core.io.mesh_file import load_mesh
from core.io.obj import obj_text, read_obj
from core.io.png import read_png
from core.io.run_folder import RunFolder
from core.job_config import config_of
from core.stages.state import Training
from core.tests.bad_files import CORNERS, FACES, OBJ, glb, hdr, png
from core.tests.mutate import mutate, mutate_glb, mutate_png

SHORT = 60  # files of each format in the suite
COUNT, FIRST = int(os.environ.get("FUZZ_COUNT", "2000")), int(os.environ.get("FUZZ_FIRST", "0"))
BATCH = 250  # files in one process of the long form
MEMORY = 400 << 20  # bytes that one small file may take
SECONDS = 20.0  # that one small file may take, on a busy machine

Mutate = Callable[[bytes, random.Random], bytes]


@dataclass(frozen=True)
class Format:
    """Whole files of a format, how they are changed, and what reads them."""

    suffix: str
    seeds: tuple[bytes, ...]
    read: Callable[[Path], None]
    mutate: Mutate = mutate


def read_user_mesh(path: Path) -> None:
    """As ``texture`` and ``inspect`` read it."""
    mesh = load_mesh(path)
    assert torch.isfinite(mesh.verts).all() and len(mesh.faces)
    assert int(mesh.faces.min()) >= 0 and int(mesh.faces.max()) < len(mesh.verts)
    if mesh.uv is not None:
        assert mesh.face_uvs is not None and torch.isfinite(mesh.uv).all()
        assert int(mesh.face_uvs.min()) >= 0 and int(mesh.face_uvs.max()) < len(mesh.uv)
    json.dumps(health(mesh.verts, mesh.faces), allow_nan=False)


def read_asset_mesh(path: Path) -> None:
    """As mesh.obj of an asset is read."""
    mesh = read_obj(path)
    uv, face_uvs = mesh.atlas
    assert torch.isfinite(mesh.verts).all() and torch.isfinite(uv).all()
    assert int(mesh.faces.max()) < len(mesh.verts) and int(face_uvs.max()) < len(uv)


def read_picture(read: Callable[[Path], object]) -> Callable[[Path], None]:
    """A picture of rows and columns."""

    def check(path: Path) -> None:
        assert len(np.asarray(read(path)).shape) == 3

    return check


def read_checkpoint(path: Path) -> None:
    """As ``resume`` reads it."""
    run = RunFolder(path.parent)
    (path.parent / "checkpoint").mkdir(exist_ok=True)
    path.replace(path.parent / "checkpoint" / "toy.safetensors")
    training(run).resume()


def training(run: RunFolder) -> Training:
    return Training("toy", torch.nn.Linear(3, 1), torch.Generator(), run)


def read_stream(path: Path) -> None:
    """As a run's events are read."""
    path.replace(path.with_name("events.jsonl"))
    for event in read_events(path.parent):
        assert isinstance(event, dict)


def read_job(path: Path) -> None:
    """As ``resume`` reads it, up to the settings of the run."""
    path.replace(path.with_name("job.json"))
    config_of(RunFolder.open(path.parent).job)


@pytest.fixture(scope="module")
def formats(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Format]:
    made = tmp_path_factory.mktemp("seeds")
    light = torch.rand(8, 16, 3, generator=torch.Generator().manual_seed(0))
    write_exr(made / "a.exr", light)
    write_exr(made / "b.exr", light[..., :1])
    Image.new("RGBA", (9, 7), (200, 100, 50, 128)).save(made / "a.png")
    run = RunFolder.create(made / "run", Job(prompt="a red cube"))
    toy = training(run)
    toy.module(torch.ones(2, 3)).sum().backward()
    toy.optimizer.step()
    toy.save()
    run.report("started", pid=7)
    run.report("progress", stage="geometry", step=1, steps=9, loss=0.5, seconds_left=3.0)
    run.report("error", text="It was cold.", fix="Wait for June.")
    job = Job(prompt="a red cube", loras={"a.safetensors": 0.5}, settings={"geometry.views": 2})
    plain = OBJ + b"vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\ng a\ns 1\n"
    corners = Mesh(
        torch.from_numpy(CORNERS), torch.from_numpy(FACES.astype(np.int64)),
        torch.rand(3, 2, generator=torch.Generator().manual_seed(0)),
        torch.tensor([[0, 1, 2]] * 4),
    )  # fmt: skip
    asset = obj_text(corners, shading_normals(corners), "mesh").encode()
    files = {suffix: meshes(suffix) for suffix in (".ply", ".stl", ".glb")}
    return {
        "obj": Format(
            ".obj",
            (plain + b"f 1/1/1 2/2/1 3/3/1\nf 1//1 2//1 3//1 4//1\nf -1 -2 -3\nl 1 2\n", asset),
            read_user_mesh,
        ),
        "asset obj": Format(".obj", (asset,), read_asset_mesh),
        "ply": Format(".ply", files[".ply"], read_user_mesh),
        "stl": Format(".stl", files[".stl"], read_user_mesh),
        "glb": Format(".glb", (*files[".glb"], glb()), read_user_mesh, mutate_glb),
        "png": Format(
            ".png",
            (png(7, 5), png(5, 7, 16), png(8, 8, 8, 1), (made / "a.png").read_bytes()),
            read_picture(read_png),
            mutate_png,
        ),
        "hdr": Format(".hdr", (hdr(16, 8), rle_hdr()), read_picture(read_hdr)),
        "exr": Format(
            ".exr",
            ((made / "a.exr").read_bytes(), (made / "b.exr").read_bytes()),
            read_picture(read_exr),
        ),
        "safetensors": Format(
            ".safetensors",
            ((made / "run" / "checkpoint" / "toy.safetensors").read_bytes(),),
            read_checkpoint,
        ),
        "events": Format(".jsonl", ((made / "run" / "events.jsonl").read_bytes(),), read_stream),
        "job": Format(".json", (job.to_json().encode(),), read_job),
    }


def meshes(suffix: str) -> tuple[bytes, ...]:
    """A tetrahedron in the forms of a format, with uv and a texture where it holds them."""
    import trimesh

    mesh = trimesh.Trimesh(CORNERS, FACES, process=False)
    if suffix == ".stl":
        return mesh.export(file_type="stl"), str(mesh.export(file_type="stl_ascii")).encode()
    if suffix == ".ply":
        forms = ("binary", "ascii")
        return tuple(mesh.export(file_type="ply", encoding=form) for form in forms)
    picture = Image.new("RGB", (4, 4), (200, 100, 50))
    mesh.visual = trimesh.visual.TextureVisuals(
        np.array([[0, 0], [1, 0], [0, 1], [1, 1]]),
        material=trimesh.visual.material.PBRMaterial(baseColorTexture=picture),
    )
    return (trimesh.Scene(mesh).export(file_type="glb"),)


def rle_hdr() -> bytes:
    """A Radiance picture of packed rows."""
    row = b"\2\2\0\x10" + (b"\x90\x80") * 3 + b"\x04\x80\x81\x82\x83\x8c\x80"
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y 8 +X 16\n" + row * 8


def execute(format: str, form: Format, number: int, folder: Path) -> str:
    """Read one changed file: what went wrong, or ""."""
    rng = random.Random(f"{format} {number}")
    path = folder / f"{number}{form.suffix}"
    path.write_bytes(form.mutate(rng.choice(form.seeds), rng))
    before, start = peak(), time.monotonic()
    try:
        form.read(path)
    except UserError as error:
        if not error.fix:
            return f"{format} {number}: no fix in {error}"
    except Exception as error:
        return f"{format} {number}: {type(error).__name__}: {error}"
    finally:
        path.unlink(missing_ok=True)
    if peak() - before > MEMORY:
        return f"{format} {number}: {(peak() - before) >> 20} MB"
    if time.monotonic() - start > SECONDS:
        return f"{format} {number}: {time.monotonic() - start:.0f} s"
    return ""


def peak() -> int:
    """The most memory that this process had so far, bytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss << 10


NAMES = (
    "obj", "asset obj", "ply", "stl", "glb", "png", "hdr", "exr", "safetensors", "events",
    "job",
)  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_a_changed_file_is_read_or_refused(name, formats, tmp_path):
    failed = [execute(name, formats[name], number, tmp_path) for number in range(SHORT)]
    assert not any(failed), [text for text in failed if text][:5]


@pytest.mark.skipif(not hasattr(os, "truncate"), reason="no file of holes")
@pytest.mark.parametrize("name", NAMES)
def test_a_file_of_40_gb_takes_no_memory(name, formats, tmp_path):
    """It is refused by its size, or no more of it is read than its header declares."""
    path, before = tmp_path / f"large{formats[name].suffix}", peak()
    path.write_bytes(formats[name].seeds[0])
    os.truncate(path, 40 << 30)  # a hole, which needs no room
    with contextlib.suppress(UserError):
        formats[name].read(path)
    assert peak() - before < MEMORY


def test_an_exr_too_small_for_what_it_declares_is_refused(tmp_path):
    path = tmp_path / "a.exr"
    write_exr(path, torch.zeros(8, 16, 3))
    window = struct.pack("<4i", 0, 0, 15, 7)
    assert path.read_bytes().count(window) == 2  # of the data, and of the display
    path.write_bytes(path.read_bytes().replace(window, struct.pack("<4i", 0, 0, 8191, 8191)))
    with pytest.raises(UserError, match="which cannot be in"):
        read_exr(path)


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="a crash is only seen from another process")
@pytest.mark.parametrize("name", NAMES)
def test_many_changed_files_are_read_or_refused(name, formats, tmp_path):
    failed: list[str] = []
    for first in range(FIRST, FIRST + COUNT, BATCH):
        numbers = range(first, min(first + BATCH, FIRST + COUNT))
        failed += in_child(lambda n=numbers: [execute(name, formats[name], i, tmp_path) for i in n])
        if failed and failed[-1].startswith("crash"):
            failed[-1] = f"{name}, one of {numbers}: {failed[-1]}"
    print(f"\n{name}: {COUNT} files, {len(failed)} failures")
    assert not failed, "\n".join(failed[:20])


def in_child(work: Callable[[], list[str]]) -> list[str]:
    """The failures of ``work`` in a process of its own, whose crash is one too."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(read)
        try:
            with os.fdopen(write, "w") as pipe:
                pipe.write(json.dumps([text for text in work() if text]))
            os._exit(0)
        finally:  # an error, which must not go on as a second pytest
            traceback.print_exc()
            os._exit(1)
    os.close(write)
    with os.fdopen(read) as pipe:
        text = pipe.read()
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return json.loads(text) if status == 0 else [f"crash: exit code {status}"]
