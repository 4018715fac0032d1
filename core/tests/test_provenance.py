"""What made an asset."""

from core.guidance.builtin.offered import WEIGHTS
from core.io.job import Job
from core.provenance import made_by


def test_every_network_that_ships_is_named_by_its_hash() -> None:
    weights = made_by(Job(prompt="a chair", guidance="builtin"))["weights"]
    assert sorted(weights) == sorted(path.name for path in WEIGHTS.glob("*.safetensors"))
    assert all(len(value) == 64 for value in weights.values())


def test_of_another_model_the_shipped_networks_are_not_named() -> None:
    assert made_by(Job(prompt="a chair", guidance="/models/dream.safetensors"))["weights"] == {}
