"""A run that is killed, or whose files fail, ends in the bytes of one that nobody disturbed.

The short form of ``fault_runs``; ``-m slow`` is the long one (docs/reliability.md).
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"), "1")
SHORT = {"kills": "2", "kills-at-files": "1", "failures": "1"}
LONG = {"kills": "50", "kills-at-files": "all", "failures": "all", "places": "all"}

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="forks, and reads /proc")


def walked(**counts: str) -> list[dict]:
    """The report of ``fault_runs``."""
    options = [word for name, count in counts.items() for word in (f"--{name}", count)]
    done = subprocess.run(
        [sys.executable, "-m", "core.tests.fault_runs", *options, "--seed", "1"],
        cwd=ROOT,
        env=os.environ | ONE_THREAD,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


@pytest.mark.parametrize("counts", [SHORT, pytest.param(LONG, marks=pytest.mark.slow)])
def test_a_disturbed_run_ends_in_the_same_bytes(counts):
    results = walked(**counts)
    assert not [result for result in results if result["wrong"]]
    for name, count in counts.items():
        mounts = name == "places"  # which not every user may
        done = sum(result["walk"] == name for result in results)
        assert mounts or done == int(count) if count != "all" else done > 10


@pytest.mark.parametrize("count", [500, pytest.param(10_000, marks=pytest.mark.slow)])
def test_many_steps_are_flat(count):
    """Memory, files, processes and the run folder, within 5 % of what they are after a tenth."""
    command = [sys.executable, "-m", "core.tests.long_training", str(count)]
    environ = os.environ | ONE_THREAD
    done = subprocess.run(command, cwd=ROOT, env=environ, capture_output=True, text=True)
    rows = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    assert len(rows) == 20, done.stderr
    warm = rows[1]
    for row in rows[2:]:
        for name in ("files", "processes", "folder_files"):
            assert row[name] <= warm[name], (warm, row)
        for name in ("memory_kb", "folder_bytes"):
            assert row[name] <= 1.05 * warm[name], (warm, row)
        assert row["events_bytes"] < 1 << 20
