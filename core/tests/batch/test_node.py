"""What goes to a cluster's node and comes back, and what the node does; without a cluster."""

import dataclasses
import io
import json
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

from core.batch import node, parcel
from core.batch.node import Order, make, source_version
from core.errors import UserError
from core.io import atomic
from core.io.job import Job, read_events
from core.tests.batch.test_batch import FAKE, sessions


def run_folder(path, **fields):
    path.mkdir()
    (path / "job.json").write_text(Job(prompt="a chair", **fields).to_json())
    return path


def order(**changes):
    given = Order("a-run", FAKE, None, 0.0, source_version())
    return dataclasses.asdict(dataclasses.replace(given, **changes))


def files(folder):
    return {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}


def test_a_job_goes_with_the_files_that_it_names(tmp_path):
    (tmp_path / "my mesh.obj").write_text("v 0 0 0\n")
    mesh = str(tmp_path / "my mesh.obj")
    here = run_folder(tmp_path / "here", command="texture", mesh=mesh, light="sky")
    there = tmp_path / "there"
    parcel.unpack(parcel.outward(here), there)
    (tmp_path / "my mesh.obj").unlink()
    parcel.settle(there)
    job = Job.from_json((there / "job.json").read_text())
    assert Path(job.mesh).read_text() == "v 0 0 0\n"
    assert Path(job.mesh).name == "my mesh.obj"  # which asset.json records
    assert job.light == "sky" and Path(job.mesh).is_absolute()


def test_loras_embeddings_and_regions_travel_with_their_settings(tmp_path):
    for name in ("a/style.safetensors", "b/style.safetensors", "owl.safetensors", "faces.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(name.encode())
    (tmp_path / "kept").mkdir()
    (tmp_path / "kept" / "mesh.obj").write_text("v 1 2 3\n")
    loras = {str(tmp_path / "a/style.safetensors"): 0.5, str(tmp_path / "b/style.safetensors"): 2.0}
    here = run_folder(
        tmp_path / "here", command="texture", mesh="mesh of the node", uv="keep",
        loras=loras, embeddings=[str(tmp_path / "owl.safetensors")],
        region=str(tmp_path / "faces.txt"), kept_asset=str(tmp_path / "kept"),
    )  # fmt: skip
    before = (here / "job.json").read_bytes()
    there = tmp_path / "there"
    parcel.unpack(parcel.outward(here), there)
    sent = Job.from_json((there / "job.json").read_text())
    assert list(sent.loras) == [f"inputs/loras/{n}/style.safetensors" for n in (0, 1)]
    assert sent.embeddings == ["inputs/embeddings/0/owl.safetensors"]
    assert str(tmp_path) not in (there / "job.json").read_text()
    parcel.settle(there)
    job = Job.from_json((there / "job.json").read_text())
    assert list(job.loras.values()) == [0.5, 2.0]
    assert [Path(x).read_bytes() for x in job.loras] == [Path(x).read_bytes() for x in loras]
    assert [Path(x).name for x in job.embeddings] == ["owl.safetensors"]  # its word in the prompt
    assert Path(job.embeddings[0]).read_bytes() == b"owl.safetensors"
    assert Path(job.region).read_bytes() == b"faces.txt" and job.mesh == "mesh of the node"
    assert (Path(job.kept_asset) / "mesh.obj").read_text() == "v 1 2 3\n"
    assert all(Path(x).is_relative_to(there) for x in (*job.loras, *job.embeddings, job.region))
    assert (here / "job.json").read_bytes() == before


def test_an_asset_comes_back_whole_and_the_job_stays(tmp_path):
    here, there = run_folder(tmp_path / "here"), run_folder(tmp_path / "there", seed=7)
    (there / "asset").mkdir()
    (there / "asset" / "asset.json").write_text("{}")
    parcel.unpack(parcel.homeward(there, parcel.ASSET), here)
    assert (here / "asset" / "asset.json").read_text() == "{}"
    assert json.loads((here / "job.json").read_text())["seed"] == 0
    assert files(here) == {"job.json", "asset/asset.json"}


def asset(run, **files):
    """An asset in ``run`` with these files, each a text by its stem."""
    (run / "asset").mkdir()
    for stem, text in files.items():
        (run / "asset" / f"{stem}.json").write_text(text)
    return run


def test_an_asset_replaces_an_older_one(tmp_path):
    stated = json.dumps({"files": {"gone.json": {}}})
    here = asset(run_folder(tmp_path / "here"), asset=stated, gone="old", kept="old")
    there = asset(run_folder(tmp_path / "there"), asset="{}", kept="new")
    for _ in range(2):  # a relay that dies before it remembers gets the same again
        parcel.unpack(parcel.homeward(there, parcel.ASSET), here)
        assert files(here) == {"job.json", "asset/asset.json", "asset/kept.json"}
        assert (here / "asset" / "kept.json").read_text() == "new"


@pytest.mark.parametrize("killed_at", [1, 2, 3])
def test_a_kill_while_an_asset_is_replaced_loses_none(tmp_path, monkeypatch, killed_at):
    """Before the first rename, between the two, and after the second."""
    here = asset(run_folder(tmp_path / "here"), asset="{}", kept="old")
    there = asset(run_folder(tmp_path / "there"), asset="{}", kept="new")
    home, renames = parcel.homeward(there, parcel.ASSET), iter(range(1, 9))

    class Killed(BaseException):
        pass

    def rename(path, to, real=Path.rename):
        if next(renames) == killed_at:
            raise Killed
        return real(path, to)

    def killed(*_, **__):
        raise Killed

    with monkeypatch.context() as patch:
        patch.setattr(Path, "rename", rename)
        patch.setattr(atomic, "restore", killed)  # a kill runs nothing more
        with pytest.raises(Killed):
            parcel.unpack(home, here)
    # A parcel without an asset is enough to get the older one back.
    parcel.unpack(parcel.homeward(there, ("log.txt",)), here)
    now = (here / "asset" / "kept.json").read_text()
    assert now == ("new" if killed_at == 3 else "old")
    parcel.unpack(home, here)
    assert files(here) == {"job.json", "asset/asset.json", "asset/kept.json"}
    assert (here / "asset" / "kept.json").read_text() == "new"
    assert {path.name for path in here.iterdir()} == {"job.json", "asset"}


def test_a_failed_rename_leaves_the_older_asset(tmp_path, monkeypatch):
    here = asset(run_folder(tmp_path / "here"), asset="{}", kept="old")
    there = asset(run_folder(tmp_path / "there"), asset="{}", kept="new")

    def rename(path, to, real=Path.rename):
        if path.name == parcel.RECEIVED:
            raise PermissionError(13, "Permission denied")
        return real(path, to)

    monkeypatch.setattr(Path, "rename", rename)
    with pytest.raises(UserError, match="cannot be written: permission denied"):
        parcel.unpack(parcel.homeward(there, parcel.ASSET), here)
    assert (here / "asset" / "kept.json").read_text() == "old"


def test_a_file_of_the_users_in_an_asset_is_not_replaced(tmp_path):
    here = asset(run_folder(tmp_path / "here"), asset="{}", notes="mine")
    there = asset(run_folder(tmp_path / "there"), asset="{}")
    home = parcel.homeward(there, parcel.ASSET)
    with pytest.raises(UserError, match=r"notes.json is not a file of an asset"):
        parcel.unpack(home, here)
    assert (here / "asset" / "notes.json").read_text() == "mine"
    (here / "asset" / "notes.json").rename(tmp_path / "notes.json")
    parcel.unpack(home, here)
    assert files(here) == {"job.json", "asset/asset.json"}


def test_a_card_s_number_does_not_travel(tmp_path):
    for device, there in (("cuda:1", "cuda"), ("cuda", "cuda"), ("cpu", "cpu")):
        here = run_folder(tmp_path / device)
        (here / "job.json").write_text(Job(prompt="a chair", device=device).to_json())
        parcel.unpack(parcel.outward(here), tmp_path / f"{device} there")
        assert Job.from_json((tmp_path / f"{device} there/job.json").read_text()).device == there


@pytest.mark.parametrize("name", ["../evil", "/evil", "a/../../evil"])
def test_a_parcel_leads_nowhere_else(tmp_path, name):
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w") as tar:
        tar.addfile(tarfile.TarInfo(name), io.BytesIO(b""))
    with pytest.raises(UserError, match="leads out"):
        parcel.unpack(packed.getvalue(), tmp_path / "run")
    assert not list(tmp_path.rglob("evil"))


def test_checkpoints_come_back_and_another_node_goes_on_from_them(tmp_path, monkeypatch):
    monkeypatch.setattr(node, "PAUSE", 0.01)
    monkeypatch.setenv("FAKE_STEPS", "40")
    monkeypatch.setenv("FAKE_PAUSE", "0.03")
    here = run_folder(tmp_path / "here")
    first = make(order(), parcel.outward(here))
    for news in first:  # its node dies with the second checkpoint on its way
        assert news["end"] is None
        parcel.unpack(news["parcel"], here)
        break
    first.close()
    assert "checkpoint/steps.safetensors" in files(here)
    *_, last = make(order(), parcel.outward(here))
    parcel.unpack(last["parcel"], here)
    assert last["end"]["code"] == 0 and last["end"]["node"]
    assert (here / "asset" / "asset.json").is_file()
    start, again = sessions(here)
    assert start == 0 < again
    assert read_events(here)[-1]["type"] == "done"


def test_a_failure_comes_back_with_its_sentence(tmp_path):
    here = run_folder(tmp_path / "here")
    job = dataclasses.replace(Job(prompt="unknown"))
    (here / "job.json").write_text(job.to_json())
    *_, last = make(order(), parcel.outward(here))
    assert last["end"]["code"] == 2
    assert last["end"]["text"] == "There is no noun 'unknown'. Say chair."


def test_a_failure_names_its_log_as_at_home(tmp_path):
    """The node's folder is a temporary one, and gone when somebody reads the sentence."""
    here = run_folder(tmp_path / "here")
    silent = (sys.executable, "-c", "raise SystemExit(9)")
    *_, last = make(order(command=silent), parcel.outward(here))
    assert last["end"]["text"].endswith("reported nothing. Read a-run/log.txt.")


def test_another_version_makes_nothing(tmp_path):
    here = run_folder(tmp_path / "here")
    (last,) = make(order(version="other"), parcel.outward(here))
    assert last["end"]["code"] == 3 and "another version" in last["end"]["text"]


def test_a_node_loads_no_torch():
    code = "import sys, core.batch.node; print({'torch', 'numpy', 'ray'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], cwd=node.ROOT, capture_output=True)
    assert done.stdout.strip() == b"set()", done.stderr
