"""Errors that a user can fix. Anything else keeps its traceback."""

MAX_SHOWN = 80  # characters of a value from outside in a sentence


def shown(value: object) -> str:
    """``value`` as Python writes it, short enough for a sentence."""
    try:
        text = repr(value)
    except ValueError:  # an integer of more digits than Python converts
        return f"a number of {type(value).__name__}"
    return text if len(text) <= MAX_SHOWN else f"{text[:MAX_SHOWN]}…"


class UserError(Exception):
    """A sentence for the user: what was got and expected (``text``), and what to do (``fix``)."""

    status = 2  # the process's exit status: the user's input
    window_fix = ""  # instead of ``fix`` where there is no command line; "": the same

    def __init__(self, text: str, fix: str = "") -> None:
        super().__init__(f"{text} {fix}".strip())
        self.text = text
        self.fix = fix


class MissingError(UserError):
    """Something is not installed or not there."""

    status = 3


class MemoryShortError(UserError):
    """The machine's or the GPU's memory does not hold the job."""

    status = 4


class NoSurfaceError(UserError):
    """The surface vanished and could not be brought back."""

    status = 5


class SomeFailedError(UserError):
    """A batch ended, and some of its assets could not be made."""

    status = 6


class RankLostError(UserError):
    """One of the processes that make an asset together has ended; the run's folder resumes."""

    status = 7


class Paused(UserError):  # noqa: N818 - as the user asked
    """The run has come as far as it was to; its folder resumes."""

    status = 0


class Cancelled(UserError):  # noqa: N818 - a request, not a fault
    """The user stopped the run; its folder resumes."""

    status = 130
