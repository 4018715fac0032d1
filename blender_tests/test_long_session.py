"""100 jobs in a row from one Blender leave nothing behind (docs/reliability.md)."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("bpy")

pytestmark = [
    pytest.mark.blender,
    pytest.mark.skipif(sys.platform != "linux", reason="reads /proc"),
]
ROOT = Path(__file__).parents[1]
FLAT = 1.05  # how much more than after the warm-up


@pytest.mark.parametrize("count", [20, pytest.param(100, marks=pytest.mark.slow)])
def test_many_jobs_from_one_blender_are_flat(count):
    command = [sys.executable, "-m", "blender_tests.long_session", str(count)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=3000)
    rows = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    assert len(rows) == count // 10, done.stderr
    first = rows[max(0, count // 50 - 1)]
    for row in rows[1:]:
        for name in ("files", "threads", "processes", "datablocks", "timers"):
            assert row[name] <= first[name], (name, first, row)
        if row["jobs"] > first["jobs"] and count == 100:
            assert row["memory_kb"] <= FLAT * first["memory_kb"], (first, row)
