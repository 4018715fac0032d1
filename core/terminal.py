"""A command's output and exit code.

Standard library only, and read by any Python that run.py starts under.
"""

from __future__ import annotations

import errno
import io
import os
import signal
import sys
from collections.abc import Callable
from contextlib import suppress
from typing import NoReturn

from core.errors import MemoryShortError, UserError
from core.interrupt import CANCELLED, interruptible

# Of torch's errors, also of those that have no type of their own: the driver's, cuBLAS', Apple's.
OUT_OF_MEMORY = ("allocate memory", "out of memory", "STATUS_ALLOC_FAILED")
FULL = "Free some space or use another --out."
FIXES = {
    errno.ENOSPC: FULL,
    errno.EDQUOT: FULL,
    errno.EFBIG: FULL,
    errno.ENAMETOOLONG: "Use a shorter name.",
    errno.ELOOP: "Name the file itself: a link leads back to itself.",
}


def exit_code(work: Callable[[], object]) -> int:
    """Do ``work``; an error that a user can fix is one sentence on the terminal, and its code."""
    take_all_letters()
    try:
        with interruptible() as interrupts:
            try:
                work()
            except UserError:
                raise
            except Exception:
                if interrupts.came:  # whatever a library raised for it
                    raise KeyboardInterrupt from None
                raise
    except KeyboardInterrupt:
        complain("Cancelled.")
        return CANCELLED
    except BrokenPipeError:  # the reader of a pipe had enough
        close_output()
        return 0
    except Exception as error:
        known = error if isinstance(error, UserError) else sentence_of(error)
        if known is None:
            raise
        complain(f"{'' if known.status == CANCELLED else 'error: '}{known}")
        close_output()
        return known.status
    return close_output()


def sentence_of(error: BaseException) -> UserError | None:
    """An error of the machine as a sentence: memory and disk."""
    out_of_memory = type(error).__name__ == "OutOfMemoryError" or isinstance(error, MemoryError)
    if out_of_memory or any(words in str(error) for words in OUT_OF_MEMORY):
        return MemoryShortError(
            "There is not enough memory for this job.",
            "Lower geometry.views_at_once and appearance.views_at_once: to resume the run in the "
            "settings of its job.json, in a new one with --set. Or use the draft preset.",
        )
    if isinstance(error, OSError) and error.errno is not None:
        place = f" {error.filename}" if error.filename else ""
        return UserError(
            f"The disk refused{place}: {error.strerror}.",
            FIXES.get(error.errno, "Check that the path is right and may be read and written."),
        )
    return None


def put(text: object) -> None:
    """Print what was asked for.

    Raises:
        BrokenPipeError: its reader has gone.
        UserError: it cannot be written, as to a file on a full disk.
    """
    try:
        print(text, flush=True)
    except BrokenPipeError:
        raise
    except OSError as error:
        raise _unwritten(error) from error


def show(text: str) -> None:
    """Print a job's progress; the job continues if nobody reads it."""
    with suppress(OSError):
        print(text, flush=True)


def complain(text: str) -> None:
    """Print an error, if there is still somebody to read it."""
    with suppress(OSError):
        print(text, file=sys.stderr, flush=True)


def close_output() -> int:
    """Write what is left of the output at the end of a command: the exit code, 0 where it can be.

    Python would try it once more after the last line, for a traceback and exit code 120.
    """
    try:
        if sys.stdout:  # None where the process was started without one
            sys.stdout.flush()
    except OSError as error:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        os.close(nowhere)
        if not isinstance(error, BrokenPipeError):
            complain(f"error: {_unwritten(error)}")
            return UserError.status
    return 0


def end(work: Callable[[], int]) -> NoReturn:
    """End this process with the exit code of ``work``."""
    try:
        code = work()
    except SystemExit as ended:  # of --help
        code = int(ended.code or 0)
    unwritten = close_output()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # all is done, but torch takes time to end
    sys.exit(code or unwritten)


def _unwritten(error: OSError) -> UserError:
    return UserError(
        f"The output cannot be printed: {error.strerror}.",
        "Send the output to a file on a disk with space, or to no file.",
    )


def take_all_letters() -> None:
    """Print a letter that the output's code page lacks, as of a name or a help text, as \\u...."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def open_streams() -> None:
    """Open the null device in place of an input or output that the process was started without.

    The next file to be opened would get its number, and with it what a library prints.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # the lowest free number
    take_all_letters()
