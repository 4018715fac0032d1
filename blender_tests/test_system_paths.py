"""Paths and free memory under Windows and macOS.

Their paths and the output of their tools are simulated: the tests run on other systems.
"""

import os
import sys
from pathlib import Path, PureWindowsPath

import pytest

from fantasia3d_addon import environment
from fantasia3d_addon.environment import machine, paths
from fantasia3d_addon.jobs import memory

HOMES = (
    r"C:\Users\Ann",
    r"C:\Users\Zoë Ångström\AppData\Local",
    r"D:\文档\my stuff (old) & new",
    r"\\server\share\home",
    r"\\?\C:\Users\Ann",
)


@pytest.fixture
def windows(monkeypatch):
    monkeypatch.setattr(sys, "platform", "win32")


@pytest.mark.parametrize("home", HOMES)
def test_the_environment_of_windows_has_its_python_in_scripts(windows, home):
    folder = PureWindowsPath(home) / "fantasia3d" / "env-0123"
    assert str(paths.env_python(folder)) == home + r"\fantasia3d\env-0123\Scripts\python.exe"
    assert str(paths.log_file(folder)) == home + r"\fantasia3d\env-0123.log"


def test_elsewhere_it_is_in_bin(monkeypatch):
    monkeypatch.setattr(sys, "platform", "darwin")
    folder = Path("/Users/Zoë/Library/Application Support/fantasia3d/env-0123")
    assert paths.env_python(folder) == folder / "bin" / "python"


def test_a_version_in_the_folders_name_stays_in_its_logs(windows):
    """``with_suffix`` would cut it off."""
    folder = PureWindowsPath(r"C:\f3d\env-1.2")
    assert paths.log_file(folder).name == "env-1.2.log"


@pytest.mark.parametrize(
    ("length", "long_paths", "fits"), [(69, False, True), (70, False, False), (200, True, True)]
)
def test_torchs_deepest_file_must_have_a_name_under_windows(
    windows, monkeypatch, length, long_paths, fits
):
    """190 characters below the environment's folder, of the 259 that Windows allows."""
    monkeypatch.setattr(machine, "_long_paths", lambda: long_paths)
    folder = PureWindowsPath("C:\\" + (length - 3) * "x")
    assert len(str(folder)) == length
    if fits:
        machine.check_length(folder)
        return
    with pytest.raises(environment.SetupError, match="or allow long paths"):
        machine.check_length(folder)


def test_pythons_are_searched_where_windows_installs_them(windows, monkeypatch, tmp_path):
    monkeypatch.setenv("LOCALAPPDATA", "/local ü")
    monkeypatch.setenv("PATH", str(tmp_path))
    (tmp_path / "py.exe").touch()
    asked = []
    monkeypatch.setattr(machine, "output", lambda words, timeout=20: asked.append(words) or "")
    found = [Path(word).as_posix() for word in machine.python_candidates() if word]
    assert "/local ü/Programs/Python/Python311/python.exe" in found
    assert [str(tmp_path / "py.exe"), "-3.11"] in [list(words[:2]) for words in asked]


def test_macos_counts_what_it_gives_without_swapping():
    output = (
        "Mach Virtual Memory Statistics: (page size of 16384 bytes)\n"
        "Pages free:                               5000.\n"
        "Pages active:                           300000.\n"
        "Pages inactive:                         200000.\n"
        "Pages speculative:                        1000.\n"
        '"Translation faults":                 999999999.\n'
    )
    assert memory._available_on_macos(output) == 16384 * 206000


def test_windows_writes_its_answer_into_64_bytes():
    """MEMORYSTATUSEX: two numbers of 4 bytes and seven of 8; what is free is the fourth."""
    import ctypes

    assert ctypes.sizeof(memory._MemoryStatus) == 64
    assert memory._MemoryStatus.free.offset == 16


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="asks this machine")
def test_this_machine_has_some_memory():
    total = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    assert 1e7 < memory.available() <= total


def test_the_panel_shows_the_memory_of_a_job_and_when_it_is_too_much():
    need = f"{memory.TRAINING['draft'] / 1e9:.1f}"
    text, enough = memory.line("draft", 0, 16e9)
    assert enough
    assert text == f"It needs about {need} GB of memory; 16 GB are free."
    text, enough = memory.line("draft", 8192, 2e9)
    assert not enough and "2.0 GB are free. Use a smaller texture, or close" in text
    assert memory.line("draft", 0, None)[1]


def test_more_texels_take_more_memory_and_never_less_than_the_training():
    needs = [memory.needed("draft", 2**n) for n in range(9, 14)]
    assert needs == sorted(needs)
    assert needs[0] == memory.TRAINING["draft"] < needs[-1]
