"""What more than one file of tests starts from."""

from pathlib import Path

import pytest

from core.tests.fake_machine import Machine


@pytest.fixture
def box(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Machine:
    return Machine(tmp_path, monkeypatch)


@pytest.fixture(scope="session")
def checkpoints(tmp_path_factory):
    from core.tests.tiny_checkpoints import write_checkpoint  # diffusers takes seconds to import

    root = tmp_path_factory.mktemp("checkpoints")
    return {
        "1.x": write_checkpoint(root / "one", prediction_type="epsilon", two=False),
        "2.x": write_checkpoint(root / "two", prediction_type="v_prediction", two=True),
    }
