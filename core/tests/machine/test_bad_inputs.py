"""Every command answers every bad input of ``bad_inputs.txt`` by one sentence and its exit code."""

import os
import re
import shlex
import stat
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import run
from core.command_line import carry_out
from core.errors import UserError
from core.terminal import exit_code, sentence_of
from core.tests.bad_files import make
from core.tests.permissions import permissions_count

TABLE = Path(__file__).parents[1].joinpath("bad_inputs.txt")
parser = cache(run.parser)  # to declare all commands takes longer than most lines


def rows(table: Path) -> list[tuple[int, str, str]]:
    """Exit code, a part of the sentence, command line."""
    lines = table.read_text(encoding="utf-8").splitlines()
    cells = [line.split(" |", 2) for line in lines if line and not line.startswith("#")]
    return [(int(code), part.strip(), line.strip()) for code, part, line in cells]


def words(line: str) -> list[str]:
    """A command line with its placeholders filled in."""

    def filled(word: str) -> str:
        word = word.replace("<byte>", "\udcff").replace("<400>", "9" * 400)
        return re.sub(r"<(\d+)>", lambda found: "x" * int(found[1]), word)

    return [filled(word) for word in shlex.split(line)]


def listed(folder: Path) -> dict[str, tuple[int, int]]:
    """Every file below ``folder``, its size and the time of its last change."""
    found = {}
    for above, _, names in os.walk(folder):
        for path in (above, *(os.path.join(above, name) for name in names)):  # noqa: PTH118
            found[path] = os.lstat(path)
    return {
        path: (status.st_size if stat.S_ISREG(status.st_mode) else 0, status.st_mtime_ns)
        for path, status in found.items()
    }


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("bad")
    make(made)
    return made


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is trained or measured, nothing is installed, and Apple's GPU is none of ours."""

    def never(*_: object, **__: object) -> None:
        raise AssertionError("the input was taken")

    monkeypatch.setattr(run, "parser", parser)
    monkeypatch.setattr("core.generate.generate", never)
    monkeypatch.setattr("fantasia3d_addon.environment.ensure", never)
    monkeypatch.setattr("torch.backends.mps.is_available", lambda: False)
    monkeypatch.setenv("HF_HUB_OFFLINE", "1")


def test_the_table_is_long_enough_and_names_each_input_once() -> None:
    lines = [line for _, _, line in rows(TABLE)]
    assert len(lines) >= 150
    assert len(set(lines)) == len(lines)


@pytest.fixture
def ordinary_user(line: str) -> Iterator[None]:
    """Nobody has root's right to every file; where that cannot be, some lines are left out."""
    with permissions_count() as counts:
        if not counts and "locked" in line:
            pytest.skip("permissions do not count here")
        yield


@pytest.fixture(scope="module")
def seen() -> dict[Path, dict[str, tuple[int, int]]]:
    """The folder's contents after the last line, and so before the next."""
    return {}


@pytest.mark.usefixtures("quick", "once", "ordinary_user")
@pytest.mark.parametrize(("code", "part", "line"), rows(TABLE), ids=lambda value: str(value)[:60])
def test_a_bad_input_is_one_sentence_and_its_exit_code(
    code: int,
    part: str,
    line: str,
    folder: Path,
    seen: dict[Path, dict[str, tuple[int, int]]],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(folder)
    before, caught = seen.pop(folder, None) or listed(folder), []

    def work() -> None:
        try:
            argv = words(line)
            args = run.parse(argv) if argv else run.parser().parse(argv)
            if args.command in run.OWN:
                run.launch(argv)
            else:
                carry_out(args)
        except Exception as error:
            caught.append(error if isinstance(error, UserError) else sentence_of(error))
            raise

    assert exit_code(work) == code
    (error,) = caught
    assert part in str(error)
    assert error.text and error.fix, "what was got, and what to do"
    assert len(str(error)) < 2000
    output = capsys.readouterr().err
    assert output.startswith("error: ") and output.count("\n") == 1, output
    # A run that exists reports in its own folder: its lock, its events, its log.
    own = re.compile(re.escape(str(folder)) + r"/run-[\w-]+(/(lock|events.jsonl))?")
    after = seen[folder] = listed(folder)
    changed = {path for path in before | after if before.get(path) != after.get(path)}
    assert {path for path in changed if not own.fullmatch(path)} == set()
