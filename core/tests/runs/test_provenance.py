"""What made an asset."""

from pathlib import Path
from typing import Any

import pytest

from core.errors import UserError
from core.geometry.mesh import signed_volume
from core.guidance.builtin.offered import WEIGHTS
from core.io.job import Job
from core.provenance import info_of, made_by, recorded
from core.tests.drawn_things import shipped_prior
from core.verify import _job as job_to_verify


def test_every_network_that_ships_is_named_by_its_hash() -> None:
    weights = made_by(Job(prompt="a chair", guidance="builtin"))["weights"]
    assert sorted(weights) == sorted(path.name for path in WEIGHTS.glob("*.safetensors"))
    assert all(len(value) == 64 for value in weights.values())


def test_of_another_model_the_shipped_networks_are_not_named() -> None:
    assert made_by(Job(prompt="a chair", guidance="/models/dream.safetensors"))["weights"] == {}


def test_the_density_is_larger_by_what_the_volume_lost() -> None:
    job = Job(prompt="a ladder", seed=1)
    parts = shipped_prior().prompted(job.prompt, "").of_object(job.seed).parts()
    assert parts is not None
    drawn = sum(signed_volume(*parts.surface_of(k, False)) for k in range(len(parts.components)))
    made = sum(signed_volume(*parts.surface_of(k)) for k in range(len(parts.components)))
    plain, thin = (info_of(job, {"bake": 1.234}, one) for one in (None, parts))
    assert drawn > 1.3 * made
    assert thin["density"] * made == pytest.approx(plain["density"] * drawn, rel=1e-3)
    assert thin["timings"] == {"bake": 1.23}


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
