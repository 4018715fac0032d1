"""``python -m core COMMAND …``: the core's own commands (:mod:`core.command_line`)."""

import os
import signal
import sys

if __name__ == "__main__":
    # Nothing is open yet that would be left half-written.
    if signal.getsignal(signal.SIGINT) == signal.default_int_handler:
        signal.signal(signal.SIGINT, lambda *_: os._exit(130))

    from core.command_line import main
    from core.terminal import end, open_streams

    open_streams()
    end(lambda: main(sys.argv[1:]))
