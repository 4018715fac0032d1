"""The options of ``batch``. Standard library only."""

import argparse
from pathlib import Path

from core.errors import UserError

RETRIES = 3
MAX_PARTS = 100_000  # of a table; their numbers are in the names of files
MAX_PORT = 65535
OUT_OF_TIME = 124  # instead of an exit code: the attempt was ended by --timeout


def add_batch_options(command: argparse.ArgumentParser) -> None:
    """Everything but the options of a single job, which are the defaults of all rows."""
    command.add_argument(
        "table",
        type=Path,
        metavar="TABLE",
        help="prompts.csv, or a text file with one prompt per line",
    )
    command.add_argument(
        "--out", type=Path, required=True, metavar="DIR", help="a run folder for each"
    )
    command.add_argument(
        "--at-once", type=int, metavar="N", help="default: as many as cores and memory allow"
    )
    command.add_argument(
        "--shard", type=shard, default=(1, 1), metavar="I/N", help="only this part, such as 2/8"
    )
    command.add_argument(
        "--retries", type=int, default=RETRIES, metavar="N", help="of an interrupted run; default 3"
    )
    command.add_argument(
        "--timeout", type=float, metavar="SECONDS", help="per asset; it resumes in a later call"
    )
    command.add_argument(
        "--ray",
        metavar="auto|local|ADDRESS",
        help="use a Ray cluster: this machine's, or HOST:PORT",
    )


def add_node_options(command: argparse.ArgumentParser) -> None:
    """The options of ``node``."""
    command.add_argument("--head", action="store_true", help="the cluster's first (the default)")
    command.add_argument("--join", metavar="HOST:PORT", help="the address of the head")
    command.add_argument("--port", type=int, default=6379, help="of the head; default 6379")
    command.add_argument(
        "--jobs",
        action="store_true",
        help="of the head: accept runs by HTTP (from Blender, --ray-jobs)",
    )
    command.add_argument("--jobs-port", type=int, default=8265, metavar="PORT", help="default 8265")
    command.add_argument("--cpus", type=int, metavar="N", help="to offer; default: all")


def check_node(args: argparse.Namespace) -> None:
    """Refuse errors that Ray would report unclearly, or only after its start.

    Raises:
        UserError: --head or --jobs with --join, or an invalid address, port or number of cores.
    """
    if args.join is not None and args.head:
        raise UserError("A node is either --head or --join HOST:PORT.", "Use one of them.")
    if args.join is not None and args.jobs:
        raise UserError("--jobs belongs to the head.", "Leave it out with --join.")
    host, _, port = (args.join or "").rpartition(":")
    if args.join is not None and not (host and _is_port(port)):
        raise UserError(f"--join is {args.join!r}.", "Use HOST:PORT, the head's address.")
    for name, given in (("port", args.port), ("jobs-port", args.jobs_port)):
        if not _is_port(str(given)):
            raise UserError(f"--{name} is {given}.", f"Use 1 to {MAX_PORT}.")
    if args.cpus is not None and args.cpus < 1:
        raise UserError(f"--cpus is {args.cpus}.", "Use 1 or more.")


def _is_port(text: str) -> bool:
    return text.isdecimal() and len(text) <= 5 and 1 <= int(text) <= MAX_PORT


def shard(text: str) -> tuple[int, int]:
    """``2/8``: the second of eight parts."""
    part, slash, of = text.partition("/")
    numbers = slash and part.isdecimal() and of.isdecimal() and len(part + of) < 20
    if not (numbers and 1 <= int(part) <= int(of) <= MAX_PARTS):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a part; write 1/8 to 8/8 for eight parts"
        )
    return int(part), int(of)
