"""One line for the whole batch: done, running, failed, time left."""

import sys
import time
from collections.abc import Sequence

FILE_SECONDS = 60.0  # between two lines where the output is no terminal


class ProgressLine:
    """The line; on a terminal it stays in its place, in a file one is added now and then."""

    def __init__(self, total: int) -> None:
        self._total, self._width, self._shown, self._text = total, 0, 0.0, ""

    def show(self, done: int, running: int, failed: int, left: float | None) -> None:
        """Show the numbers; ``left``: seconds, None while nothing was measured."""
        text = f"{done} of {self._total} done, {running} running, {failed} failed"
        if running:
            text += f", about {duration(left)} left" if left is not None else ", time left unknown"
        now = time.monotonic()
        if sys.stderr.isatty():
            sys.stderr.write(f"\r{text.ljust(self._width)}")
            self._width = len(text)
        elif text.partition(", about")[0] != self._text.partition(", about")[0] or (
            now - self._shown > FILE_SECONDS
        ):
            sys.stderr.write(f"{text}\n")
            self._shown, self._text = now, text
        sys.stderr.flush()

    def add(self, text: str) -> None:
        """A line of its own above the progress."""
        clear = f"\r{' ' * self._width}\r" if sys.stderr.isatty() else ""
        sys.stderr.write(f"{clear}{text}\n")
        sys.stderr.flush()

    def close(self) -> None:
        """Go on below the line."""
        if sys.stderr.isatty() and self._width:
            sys.stderr.write("\n")


def duration(seconds: float) -> str:
    """``seconds`` in the largest unit that fits."""
    for unit, size in (("d", 86400), ("h", 3600), ("min", 60)):
        if seconds >= 2 * size:
            return f"{seconds / size:.0f} {unit}"
    return f"{seconds:.0f} s"


def seconds_left(
    took: Sequence[float], waiting: int, running: Sequence[float], places: int
) -> float | None:
    """How long the rest takes, where each asset takes the mean of those that are made.

    Args:
        took: seconds of the assets that this call has made.
        waiting: assets that are not started.
        running: seconds that each of the others has run.
        places: how many are made at once.
    """
    if not took:
        return None
    mean = sum(took) / len(took)
    rest = [max(mean - seconds, 0.0) for seconds in running]
    # The last ones can't be spread over more places than there are assets.
    return max([*rest, (waiting * mean + sum(rest)) / max(places, 1)])
