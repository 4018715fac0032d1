"""Every command of Blender's answers every bad input of ``bad_inputs.txt`` by one sentence."""

import json
import os
import re
import shlex
import shutil
import struct
import zlib
from pathlib import Path

import pytest

pytest.importorskip("bpy")

import run
from blender_tests.asset_fixture import block, write_asset
from core.tests.permissions import permissions_count

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
TABLE = Path(__file__).with_name("bad_inputs.txt")
CORNERS = "vt 0 0\nvt 1 0\nvt 0 1\n"


def rows() -> list[tuple[int, str, str]]:
    """Exit code, a part of the sentence, command line."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    cells = [line.split(" |", 2) for line in lines if line and not line.startswith("#")]
    return [(int(code), part.strip(), line.strip()) for code, part, line in cells]


def words(line: str) -> list[str]:
    """A command line with its placeholders filled in."""
    found = [word.replace("<byte>", "\udcff") for word in shlex.split(line)]
    return [re.sub(r"<(\d+)>", lambda number: "x" * int(number[1]), word) for word in found]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("bad")
    good = write_asset(made / "asset", block(1), size=8)
    (made / "secret.png").write_bytes((good / "orm.png").read_bytes())
    for name in ("folder", "folder.png", "folder.blend", "folder.fbx", "folder.hdr"):
        (made / name).mkdir()
        (made / name / "mine.txt").write_text("the user's")
    for name in ("loop", "loop.hdr"):
        (made / name).symlink_to(name)
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"
    for name, data in (
        ("empty.hdr", b""),
        ("text.hdr", b"hello"),
        ("text.exr", b"hello"),
        ("huge.hdr", head + b"-Y 60000 +X 60000\n"),
        ("light.hdr", head + b"-Y 8 +X 16\n" + b"\x80" * 512),
    ):
        (made / name).write_bytes(data)
    for name, text in jsons(json.loads((good / "asset.json").read_text("utf-8"))).items():
        copy = Path(shutil.copytree(good, made / f"asset-{name}"))
        (copy / "asset.json").write_bytes(text)
    for name, (file, data) in files((good / "base_color.png").read_bytes()).items():
        copy = Path(shutil.copytree(good, made / f"asset-{name}"))
        (copy / file).unlink()
        if data is not None:
            (copy / file).write_bytes(data)
    (made / "asset-obj-folder" / "mesh.obj").mkdir()
    (made / "asset-obj-loop" / "mesh.obj").symlink_to("mesh.obj")
    (made / "asset-link" / "orm.png").symlink_to(made / "secret.png")
    (made / "asset-json-folder" / "asset.json").mkdir()
    pipes_and_permissions(made)
    return made


def pipes_and_permissions(made: Path) -> None:
    """Pipes that nobody writes into, files that may not be read, a folder not to be written."""
    shutil.copy(made / "light.hdr", made / "locked.hdr").chmod(0)
    (made / "locked").mkdir()
    (made / "locked").chmod(0o555)
    for name in ("asset.json", "mesh.obj", "orm.png"):
        (shutil.copytree(made / "asset", made / f"asset-locked-{name}") / name).chmod(0)
        if hasattr(os, "mkfifo"):
            path = shutil.copytree(made / "asset", made / f"asset-pipe-{name}") / name
            path.unlink()
            os.mkfifo(path)
    if hasattr(os, "mkfifo"):
        os.mkfifo(made / "pipe.hdr")


def jsons(info: dict) -> dict[str, bytes]:
    """asset.json of assets that are none."""

    def with_(**more: object) -> bytes:
        return json.dumps(info | more).encode()

    def orm_at(name: str) -> bytes:
        others = {key: entry for key, entry in info["files"].items() if key != "orm.png"}
        return with_(files=others | {name: {"role": "orm"}})

    normal = info["files"]["normal.png"]
    return {
        "latin1": b'{"version": 1, "prompt": "K\xf6rper"}',
        "nested": b"[" * 99999 + b"]" * 99999,
        "cut-json": with_()[:99],
        "large-json": b" " * (9 << 20),
        "list": b"[]",
        "no-files": with_(files=3),
        "version": with_(version=99),
        "light-number": with_(light=3),
        "half": with_(prompt="a \ud800 cube"),
        "whole-number": with_(size_m=10**400),
        "infinite": with_()[:-1] + b', "density": 1e999}',
        "prompt-list": with_(prompt=["a"]),
        "outside": orm_at("../secret.png"),
        "absolute": orm_at("/etc/passwd"),
        "count": with_(mesh={"verts": 7}),
        "directx": with_(files=info["files"] | {"normal.png": normal | {"convention": "DirectX"}}),
        "distribution": with_(distribution="BECKMANN"),
        "color-space": with_(files=info["files"] | {"normal.png": normal | {"color_space": "x"}}),
    }


def files(png: bytes) -> dict[str, tuple[str, bytes | None]]:
    """Another content of a file of an asset, by the asset's name; None where it is removed."""
    face = "f 1/1 2/2 3/3\n"
    header = png[12:16] + struct.pack(">II", 60000, 60000) + png[24:29]
    huge = png[:12] + header + struct.pack(">I", zlib.crc32(header)) + png[33:]
    meshes = {
        "empty-obj": "",
        "nan-obj": "v nan 0 0\n" * 3 + CORNERS + face,
        "huge-obj": "v 1e39 0 0\n" * 3 + CORNERS + face,
        "index-obj": "v 0 0 0\n" + CORNERS + face,
        "index64-obj": "v 0 0 0\n" + CORNERS + f"f 1/1 1/1 {'9' * 30}/1\n",
    }
    pictures = {"empty-png": b"", "cut-png": png[:60], "text-png": b"hello", "huge-png": huge}
    gone = {"no-obj": "mesh.obj", "obj-folder": "mesh.obj", "obj-loop": "mesh.obj"}
    gone |= {"no-png": "orm.png", "link": "orm.png", "json-folder": "asset.json"}
    return (
        {name: ("mesh.obj", text.encode()) for name, text in meshes.items()}
        | {name: ("base_color.png", data) for name, data in pictures.items()}
        | {name: (file, None) for name, file in gone.items()}
    )


def listed(folder: Path) -> dict[str, tuple[int, int]]:
    """Every file below ``folder``, its size and the time of its last change."""
    paths = (Path(above, name) for above, _, names in os.walk(folder) for name in names)
    return {str(p): (p.lstat().st_size, p.lstat().st_mtime_ns) for p in paths}


def test_each_input_is_in_the_table_once() -> None:
    lines = [line for _, _, line in rows()]
    assert len(lines) >= 90
    assert len(set(lines)) == len(lines)


@pytest.mark.parametrize(("code", "part", "line"), rows(), ids=lambda value: str(value)[:60])
def test_a_bad_input_is_one_sentence_and_its_exit_code(
    code: int,
    part: str,
    line: str,
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(folder)

    def never(*_: object, **__: object) -> None:
        raise AssertionError("the input was taken")

    monkeypatch.setattr("fantasia3d_addon.scene.render.render_still", never)
    before = listed(folder)
    with permissions_count() as counts:
        if not counts and "locked" in line:
            pytest.skip("permissions do not count here")
        assert run.main(words(line)) == code
    output = capfd.readouterr().err
    assert "Traceback" not in output, output
    sentence = output.splitlines()[-1]  # what Blender itself prints of a picture comes before
    assert sentence.startswith("error: ") and output.count("error: ") == 1 and part in sentence, (
        output
    )
    assert ". " in sentence, "what was got, and what to do"
    assert listed(folder) == before
