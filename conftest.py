"""While the tests run, the core's signatures are checked: shapes (jaxtyping), types (beartype).

In production the checks are off and cost nothing. And whatever ran before, in this process or
another, each test starts from the same random numbers: any order gives the same results.
"""

import gc
import os
import random
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jaxtyping
import pytest

from core.tests import checked

# With a process for each core and more (pytest-xdist) more threads would only wait for each other.
# Before torch and numba are imported.
if "PYTEST_XDIST_WORKER" in os.environ:
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    os.environ.setdefault("NUMBA_NUM_THREADS", "1")

CHECKER = f"{checked.__name__}.once"  # by name, of a module that is loaded
UNCHECKED = {
    "core/kernels",  # numba compiles what it is given, and checks types itself
    "core/tests",  # pytest rewrites their asserts instead
    "core/io/job.py",  # it refuses wrong types itself, in words for the user
}


def checked_modules() -> list[str]:
    """The core's modules whose signatures are checked."""
    root = Path(__file__).parent
    files = [path.relative_to(root) for path in (root / "core").rglob("*.py")]
    return sorted(
        ".".join(path.with_suffix("").parts)
        for path in files
        if path.stem != "__init__"  # the hook takes a package's name for all that is in it
        and not {path.as_posix(), *(above.as_posix() for above in path.parents)} & UNCHECKED
    )


jaxtyping.jaxtyped = checked.jaxtyped
jaxtyping.install_import_hook(checked_modules(), CHECKER)


def pytest_configure(config: pytest.Config) -> None:
    """pytest-randomly shuffles the tests; their numbers stay those of pytest_runtest_setup.

    Processes that the tests start react to Ctrl-C, in a background job too.
    """
    config.option.randomly_reset_seed = False
    # pytest-xdist would begin with the files of the most tests; the longest have few.
    config.option.loadscopereorder = False
    if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:  # as a shell starts what is to go on
        signal.signal(signal.SIGINT, signal.default_int_handler)  # the tests' children inherit it


# The files that take longest, by their CPU seconds: the processes end together if they come first.
LONGEST = (
    "test_posing.py", "test_generate.py", "test_composition.py", "test_animal_poses.py",
    "test_clothing.py", "test_figure_poses.py", "test_emblems.py", "test_composed.py",
    "test_families.py", "test_areas.py", "test_reproduce.py", "test_moods.py", "test_filling.py",
    "test_bend.py", "test_scattered.py", "test_stable_diffusion.py", "test_exports.py",
    "test_stages.py", "test_asset_matches_cycles.py", "test_solid.py", "test_guide.py",
    "test_fit.py", "test_edit_region.py", "test_facing.py", "test_assembly.py", "test_remesh.py",
    "test_unwrap.py", "test_guidance.py", "test_packing.py", "test_shading_matches_cycles.py",
    "test_bench_solids.py", "test_launcher.py", "test_environment_setup.py", "test_restorer.py",
    "test_offline.py", "test_bad_inputs.py", "test_explore.py", "test_region.py",
)  # fmt: skip


# What such files have in common is loaded by the one process that carries them all out: the server
# of forks takes 5 CPU seconds, diffusers 4.
TOGETHER = (
    ("test_generate.py", "test_faults.py"),
    (
        "test_stable_diffusion.py", "test_gpu_ready.py", "test_detail.py", "test_lora.py",
        "test_room.py", "test_checkpoint.py", "test_single_file.py", "test_multi_view.py",
        "test_sdxl.py", "test_workload.py", "test_benchmarks.py",
    ),
)  # fmt: skip


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """As ``--dist loadfile`` has it, but for the files that go together."""
    if config.getvalue("dist") != "loadfile":
        return None
    from xdist.scheduler import LoadFileScheduling

    class Scheduling(LoadFileScheduling):
        def _split_scope(self, nodeid: str) -> str:
            file = super()._split_scope(nodeid)
            name = file.rpartition("/")[2]
            return next((names[0] for names in TOGETHER if name in names), file)

    return Scheduling(config, log)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[object]:
    """What is imported and collected stays: it is not searched for garbage again and again."""
    gc.disable()
    result = yield
    gc.freeze()
    gc.enable()
    return result


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """The longest files first, unless the order is to be a random one."""
    if not config.pluginmanager.hasplugin("randomly"):
        rank = {name: number for number, name in enumerate(LONGEST)}
        items.sort(key=lambda item: rank.get(item.path.name, len(rank)))


# By their ids: the states of the modules' own generators after the import.
_first: dict[int, object] = {}


def _start_numbers() -> None:
    """Start the generators that a process has once, as far as they are loaded."""
    random.seed(0)
    if "numpy" in sys.modules:
        sys.modules["numpy"].random.seed(0)
    if "torch" in sys.modules:
        sys.modules["torch"].default_generator.manual_seed(0)


def pytest_collectstart() -> None:
    """A module may draw numbers for its parameters while it is imported."""
    _start_numbers()


@pytest.hookimpl(tryfirst=True)  # before fixtures of a wider scope too
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Start every generator of random numbers that a test may use from its beginning."""
    checked.forget_calls()
    _start_numbers()
    for value in vars(item.module).values():  # pyright: ignore[reportAttributeAccessIssue]
        kind = type(value).__module__, type(value).__name__
        if kind == ("numpy.random._generator", "Generator"):
            bits = value.bit_generator
            bits.state = _first.setdefault(id(value), bits.state)
        elif kind == ("torch._C", "Generator"):
            value.set_state(_first.setdefault(id(value), value.get_state()))
