"""Ctrl-C, and outputs that cannot be written: one sentence, the right exit code, no traceback."""

import io
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import core.interrupt as interrupt
from core.command_line import main
from core.io.job import Job
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.terminal import exit_code, put, sentence_of, show
from core.tests.bad_files import meshes

ROOT = Path(__file__).parents[3]
POSIX = pytest.mark.skipif(os.name != "posix", reason="signals")
LINUX = pytest.mark.skipif(sys.platform != "linux", reason="/dev/full")


@pytest.fixture(autouse=True)
def soon(monkeypatch):
    """The second Ctrl-C comes after a moment, and the test process keeps its handler."""
    monkeypatch.setattr(interrupt, "AGAIN_SECONDS", 0.05)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    assert signal.signal(signal.SIGINT, before) == signal.default_int_handler


def ctrl_c() -> None:
    os.kill(os.getpid(), signal.SIGINT)


def swallowed() -> None:
    """As trimesh takes it: for a library that is not installed."""
    try:
        ctrl_c()
        time.sleep(10)
    except BaseException:
        pass


# Ctrl-C


@POSIX
def test_ctrl_c_that_a_library_swallows_comes_again(capsys):
    start = time.monotonic()

    def work():
        swallowed()
        time.sleep(10)

    assert exit_code(work) == 130
    assert time.monotonic() - start < 5
    assert capsys.readouterr() == ("", "Cancelled.\n")


@POSIX
def test_ctrl_c_of_which_a_library_makes_another_error_is_one(capsys):
    def work():
        try:
            ctrl_c()
        except KeyboardInterrupt:
            raise ImportError("numpy.core.multiarray failed to import") from None

    assert exit_code(work) == 130
    assert capsys.readouterr().err == "Cancelled.\n"


@POSIX
def test_ctrl_c_where_nothing_can_be_raised_is_not_printed_and_comes_again(capsys):
    class Silent:
        def __del__(self):
            ctrl_c()
            time.sleep(0)

    def work():
        Silent()
        time.sleep(10)

    assert exit_code(work) == 130
    assert capsys.readouterr().err == "Cancelled.\n"


@POSIX
def test_ctrl_c_before_a_job_stops_the_job():
    """The job that begins meanwhile has its own way to stop, which the second one takes."""
    asked = []

    def work():
        swallowed()
        with interrupt.asks_to_stop(lambda: asked.append(True)):
            end = time.monotonic() + 10
            while not asked and time.monotonic() < end:
                time.sleep(0.01)

    assert exit_code(work) == 0
    assert asked == [True]


@POSIX
def test_what_the_shell_ignores_stays_ignored():
    """As nohup and a background job of a script ask for it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    asked = []
    try:

        def work():
            ctrl_c()
            with interrupt.asks_to_stop(lambda: asked.append(True)):
                ctrl_c()

        assert exit_code(work) == 0
        assert not asked
        assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@POSIX
@pytest.mark.parametrize("times", [1, 2])
def test_ctrl_c_while_a_mesh_is_read_is_130(tmp_path, monkeypatch, capsys, times):
    (tmp_path / "ok.obj").write_bytes(meshes()["ok.obj"])

    def load(*_, **__):
        for _ in range(times):
            swallowed()
        time.sleep(10)

    monkeypatch.setattr("trimesh.load_scene", load)
    assert main(["inspect", str(tmp_path / "ok.obj")]) == 130
    assert capsys.readouterr() == ("", "Cancelled.\n")


def pending() -> None:
    """Ctrl-C that comes while Python starts; hand_over holds it back for us."""
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    ctrl_c()


def launched(*argv: str, **more: object) -> "subprocess.Popen[str]":
    """run.py as a process of its own, under this interpreter as the environment's."""
    return subprocess.Popen(
        [sys.executable, str(ROOT / "run.py"), *argv],
        env=os.environ | {"FANTASIA3D_PYTHON": sys.executable},
        stderr=subprocess.PIPE,
        text=True,
        **more,
    )  # fmt: skip


@LINUX
def test_a_process_knows_when_it_began_however_late_it_asks():
    """Before the loading of its modules: a cancel that comes meanwhile is of this session."""
    code = (
        "import time; time.sleep(0.5); loaded = time.time()\n"
        "from core.interrupt import process_began; print(process_began(), loaded)"
    )
    before = time.time()
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    began, loaded = map(float, done.stdout.split())
    assert before - 0.02 <= began <= loaded - 0.5  # the system counts in hundredths


@POSIX
def test_ctrl_c_while_python_starts_is_one_line_and_130():
    process = launched("--inside", "words", preexec_fn=pending)
    _, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (130, "Cancelled.\n")


@pytest.mark.parametrize(
    "output",
    [
        "CUDA error: out of memory\nCUDA kernel errors might be asynchronously reported",
        "MPS backend out of memory (MPS allocated: 6.00 GB, other allocations: 3.0 GB)",
        "CUDA error: CUBLAS_STATUS_ALLOC_FAILED when calling `cublasCreate(handle)`",
        "[enforce fail at alloc_cpu.cpp:117] DefaultCPUAllocator: can't allocate memory",
    ],
)
def test_a_lack_of_memory_is_known_by_torchs_message(output):
    """These have no type of their own; a batch goes on with smaller parts by the exit code."""
    known = sentence_of(RuntimeError(output))
    assert known and known.status == 4
    assert sentence_of(RuntimeError("CUDA error: an illegal memory access")) is None


# Outputs


@LINUX
@pytest.mark.parametrize("line", [["words", "a red cube"], ["--help"]])
def test_an_output_that_is_full_is_a_sentence_and_2(line):
    with Path("/dev/full").open("w") as full:
        process = launched(*line, stdout=full)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 2
    assert err.startswith("error: The output cannot be printed: No space left"), err
    assert err.count("\n") == 1


@POSIX
@pytest.mark.parametrize("line", [["words"], ["words", "--help"], ["--help"]])
def test_a_reader_that_has_gone_is_no_error(line):
    """As of ``| head -1``."""
    read, write = os.pipe()
    os.close(read)
    process = launched(*line, stdout=write)
    os.close(write)
    _, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (0, "")


def test_a_help_text_is_printed_in_any_code_page(monkeypatch):
    """Windows' and older ones have no ellipsis."""
    monkeypatch.setenv("PYTHONIOENCODING", "latin-1")
    process = launched("render", "--help", stdout=subprocess.PIPE)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (0, "")
    assert "roughness, \\u2026" in out


@POSIX
def test_a_file_never_takes_the_place_of_a_missing_output(tmp_path):
    """Else what a library prints would be written into it."""
    made = tmp_path / "made"
    code = (
        "import os, sys; from core.terminal import open_streams; open_streams()\n"
        f"file = open({str(made)!r}, 'wb'); os.write(1, b'printed'); os.write(2, b'printed')\n"
        "print('lost'); sys.exit(file.fileno())"
    )
    closed = 'exec "$@" >&- 2>&- <&-'
    done = subprocess.run(["sh", "-c", closed, "sh", sys.executable, "-c", code], cwd=ROOT)
    assert done.returncode == 3
    assert made.read_bytes() == b""


class Gone(io.StringIO):
    """An output whose reader has gone."""

    def write(self, text: str) -> int:
        raise BrokenPipeError(32, "Broken pipe")


def test_a_job_whose_reader_has_gone_works_on(tmp_path, monkeypatch):
    progress = Progress(RunFolder.create(tmp_path / "run", Job(prompt="a red cube")))
    monkeypatch.setattr(sys, "stdout", Gone())
    with progress.timed("fit"):
        assert [step.at for step in progress.steps("fit", 0, [20])] == list(range(20))
    progress.warn("It was cold.", "Wait for June.")
    show("nothing")
    with pytest.raises(BrokenPipeError):
        put("the answer")
