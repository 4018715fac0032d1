"""What more than one file of tests starts from."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from filelock import FileLock

from core.tests.fake_machine import Machine


@pytest.fixture
def box(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Machine:
    return Machine(tmp_path, monkeypatch)


@pytest.fixture(scope="session")
def shared(tmp_path_factory) -> Path:
    """A folder of this run's processes together (pytest-xdist); what is made there is locked."""
    root = tmp_path_factory.getbasetemp()
    folder = (root.parent if "PYTEST_XDIST_WORKER" in os.environ else root) / "shared"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture(scope="module")
def once() -> Iterator[None]:
    """For tests of whole runs: their weights, light and packing are made once."""
    # Imported here: it brings the whole method.
    from core.tests import tiny_runs

    with tiny_runs.once():
        yield


@pytest.fixture(scope="module")
def coarse(once: None) -> Iterator[None]:
    """``once``, for tests that do not look at how fine the drawn solid is."""
    from core.tests import tiny_runs

    with contextlib.ExitStack() as stack:
        for patch in tiny_runs.coarsely_drawn():
            stack.enter_context(patch)
        yield


@pytest.fixture(scope="session")
def checkpoints(shared):
    """Read only: both processes use the same ones."""
    names = {"1.x": "one", "2.x": "two", "xl": "xl"}
    done = shared / "checkpoints" / "done"
    with FileLock(shared / "checkpoints.lock"):  # the first one makes them, the others wait
        if not done.exists():
            # Imported here: diffusers takes seconds.
            from core.tests.tiny_checkpoints import write_checkpoint, write_xl_checkpoint

            kinds = {"1.x": ("epsilon", False), "2.x": ("v_prediction", True)}
            for name, (kind, two) in kinds.items():
                folder = done.parent / names[name]
                write_checkpoint(folder, prediction_type=kind, two=two)
            write_xl_checkpoint(done.parent / names["xl"])
            done.touch()
    return {name: done.parent / folder for name, folder in names.items()}
