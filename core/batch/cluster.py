"""The batch's places on a Ray cluster: one asset is one task; nodes have no common disk.

A task gets the run folder's job and checkpoints through Ray's object store, runs the core as a
process of this machine does, and sends checkpoints back now and then. Ray itself tries nothing
again: the batch does, with the newest checkpoint that came back, wherever there is room then.
"""

import inspect
import os
import socket
import sys
import time
from argparse import Namespace
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict
from importlib.util import find_spec
from typing import Any, NoReturn

from core.batch.attempt import COMMAND, ROOT, End
from core.batch.needs import Needs
from core.batch.node import Order, make, source_version
from core.batch.parcel import outward, unpack
from core.batch.plan import Task
from core.errors import MissingError, UserError

# Ray sends usage reports unless this is set; its own notices of a death are pages long.
# The last one skips all that it prints of others, at any level of its log.
QUIET = {
    "RAY_USAGE_STATS_ENABLED": "0",
    "RAY_DISABLE_IMPORT_WARNING": "1",
    "RAY_DEDUP_LOGS_SKIP_REGEX": ".",
}
for _name, _value in QUIET.items():
    os.environ.setdefault(_name, _value)

try:
    import ray  # pyright: ignore[reportMissingImports]
    from ray.exceptions import RayError, RayTaskError  # pyright: ignore[reportMissingImports]
except ModuleNotFoundError as error:
    raise MissingError("Ray is not installed.", "Install it: python3 run.py setup ray") from error

NODE_PYTHON = "FANTASIA3D_NODE_PYTHON"  # of a job: the interpreter that has the core's packages
NODE_DIED = 125  # instead of an exit code

ANSWER_SECONDS = 10.0  # a cluster's head has to answer within


class RayPool:
    """Makes assets on a cluster, as many at once as its nodes have room for."""

    stopping = "Stopping; what runs resumes from the last checkpoints that came back."

    def __init__(
        self,
        needs: Needs,
        at_once: int | None = None,
        timeout: float | None = None,
        command: Sequence[str] = COMMAND,
        seconds: float = 30.0,
    ) -> None:
        self.needs, self._at_once = needs, at_once
        self._order = {"timeout": timeout, "command": tuple(command), "seconds": seconds}
        self._running: dict[Any, tuple[Task, float]] = {}
        options = {"num_cpus": needs.cpus, "memory": needs.memory, "num_gpus": needs.gpus}
        # Unwrapped: the tests' check of types hides that it is a generator, which Ray asks for.
        self._make = ray.remote(inspect.unwrap(make)).options(
            num_returns="streaming", max_retries=0, **options
        )

    @property
    def places(self) -> int:
        """How many assets the nodes that are alive have room for."""
        nodes = [node["Resources"] for node in ray.nodes() if node["Alive"]]
        places = sum(room(resources, self.needs) for resources in nodes)
        return places if self._at_once is None else min(places, self._at_once)

    def start(self, task: Task) -> None:
        """Hand ``task`` to the cluster, with what its run folder has come to."""
        assert task.folder
        order = Order(name=task.folder.name, version=source_version(), **self._order)
        made = self._make.remote(asdict(order), outward(task.folder))
        self._running[made] = (task, time.monotonic())

    def wait(self, seconds: float) -> list[tuple[Task, End]]:
        """The ended tasks, after ``seconds`` at the latest; received checkpoints are written."""
        until, ended = time.monotonic() + seconds, []
        while not ended and (left := until - time.monotonic()) > 0:
            if not self._running:
                time.sleep(left)
                break
            ready, _ = ray.wait(list(self._running), timeout=left, fetch_local=False)
            ended = [found for made in ready if (found := self._take(made))]
        return ended

    def _take(self, made: Any) -> tuple[Task, End] | None:
        """The next news of a task: a checkpoint, or how it ended."""
        task, started = self._running[made]
        assert task.folder
        try:
            news = ray.get(next(made))
        except StopIteration:  # without its last word
            news = _lost("Its task ended without a result.", started)
        except RayTaskError as error:
            text = str(error.cause or error).strip().splitlines()[-1]
            news = _lost(f"Its task failed on its node: {text}", started)
        except RayError as error:
            news = _lost(f"Its node or its worker died ({type(error).__name__}).", started)
        if news["parcel"]:
            unpack(news["parcel"], task.folder)
        if news["end"] is None:
            return None
        del self._running[made]
        return task, End(**news["end"])

    def stop(self) -> None:
        """Cancel what runs; it resumes from the checkpoints that have come back."""
        for made in self._running:
            with suppress(RayError):
                ray.cancel(made, force=True)
        self._running.clear()


def _lost(text: str, started: float) -> dict[str, Any]:
    end = End(NODE_DIED, text, time.monotonic() - started)
    return {"parcel": b"", "end": asdict(end)}


def room(resources: dict[str, float], needs: Needs) -> int:
    """How many assets with ``needs`` a node with ``resources`` holds."""
    by = [(resources.get("CPU", 0.0), needs.cpus), (resources.get("memory", 0.0), needs.memory)]
    by += [(resources.get("GPU", 0.0), needs.gpus)] if needs.gpus else []
    return min(int(has / takes + 1e-9) for has, takes in by)


def connect(address: str) -> bool:
    """Join the cluster at ``address`` (or "auto", or "local" for one of this machine's own).

    Returns whether it has a GPU. Raises UserError where there is none to join.
    """
    os.environ["PYTHONPATH"] = _path()  # of the workers that "local" starts
    where: dict[str, Any] = {"address": address}
    if address == "local":
        where |= {"include_dashboard": False}
    try:
        _check_answer(address)
        ray.init(**where, log_to_driver=False, logging_level="ERROR")
    except (ConnectionError, ValueError, RuntimeError, OSError) as error:
        raise UserError(
            f"There is no Ray cluster at {address!r} ({str(error).splitlines()[0]}).",
            "Start one: python3 run.py node --head; let this machine join it: node --join "
            "HOST:PORT; or use --ray local.",
        ) from error
    return ray.cluster_resources().get("GPU", 0.0) > 0


def _check_answer(address: str) -> None:
    """Raise ``OSError`` where nobody answers at HOST:PORT: Ray itself tries for minutes."""
    host, _, port = address.removeprefix("ray://").rpartition(":")
    if host and port.isdecimal():
        socket.create_connection((host, int(port)), timeout=ANSWER_SECONDS).close()


def _path() -> str:
    """Where a worker finds this project, then whatever this process was given."""
    return os.pathsep.join(filter(None, (str(ROOT), os.environ.get("PYTHONPATH"))))


def _jobs_options(args: Namespace) -> list[str]:
    """A head's options for its Jobs interface, open beyond this machine only with Ray's token."""
    if not args.jobs:
        return ["--include-dashboard=false"]
    if find_spec("aiohttp_cors") is None:  # of ray[default] alone
        raise MissingError(
            "Ray's Jobs interface needs ray[default] on the head.",
            f"Install it: {sys.executable} -m pip install 'ray[default]=={ray.__version__}'",
        )
    host = "0.0.0.0" if os.environ.get("RAY_AUTH_MODE") == "token" else "127.0.0.1"
    port = f"--dashboard-port={args.jobs_port}"
    return ["--include-dashboard=true", f"--dashboard-host={host}", port]


def be_node(args: Namespace) -> NoReturn:
    """``run.py node``: make this machine a node of a cluster, until Ctrl-C."""
    where = ["--head", f"--port={args.port}"] if not args.join else [f"--address={args.join}"]
    more = _jobs_options(args) if not args.join else []
    limits = [f"--num-cpus={args.cpus}"] if args.cpus is not None else []
    # -P: no module comes from the current folder.
    command = [sys.executable, "-P", "-m", "ray.scripts.scripts", "start", "--block"]
    environ = {**os.environ, **QUIET, "PYTHONPATH": _path(), NODE_PYTHON: sys.executable}
    sys.stdout.flush()
    os.execve(command[0], [*command, *where, *more, *limits], environ)
