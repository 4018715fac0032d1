"""What made an asset."""

from pathlib import Path
from typing import Any

import pytest

from core.errors import UserError
from core.guidance.builtin.offered import WEIGHTS
from core.io.job import Job
from core.provenance import made_by, recorded
from core.verify import _job as job_to_verify


def test_every_network_that_ships_is_named_by_its_hash() -> None:
    weights = made_by(Job(prompt="a chair", guidance="builtin"))["weights"]
    assert sorted(weights) == sorted(path.name for path in WEIGHTS.glob("*.safetensors"))
    assert all(len(value) == 64 for value in weights.values())


def test_of_another_model_the_shipped_networks_are_not_named() -> None:
    assert made_by(Job(prompt="a chair", guidance="/models/dream.safetensors"))["weights"] == {}


def asset_of(job: Job, folder: Path) -> tuple[Path, dict[str, Any]]:
    folder.mkdir()
    return folder, {"job": recorded(job)}


@pytest.mark.parametrize(
    "names", [{"light": "blender:city"}, {"light": "city"}, {"guidance": "a/b"}]
)
def test_an_asset_elsewhere_is_made_again_with_what_has_a_name(names, tmp_path) -> None:
    """A light of Blender's and a model of the hub are no files next to it."""
    job = Job(prompt="a chair", **names)
    assert job_to_verify(*asset_of(job, tmp_path / "copy")) == job


@pytest.mark.parametrize("field", ["light", "guidance", "guide_mesh"])
def test_an_asset_whose_files_are_not_here_states_which(field, tmp_path) -> None:
    job = Job(prompt="a chair", **{field: "/files/none.hdr"})
    with pytest.raises(UserError, match="made from 'none.hdr', which is missing"):
        job_to_verify(*asset_of(job, tmp_path / "copy"))
