"""``python -m core COMMAND …``: the core's own commands (:mod:`core.command_line`)."""

import sys

from core.command_line import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
