"""The batch's places on this machine: a process of the core in each."""

import os
import time
from collections.abc import Sequence

from core.batch.attempt import COMMAND, THREADS, Attempt, End
from core.batch.needs import Needs, card_of, cores, gpus, places
from core.batch.plan import Task

PAUSE = 0.1  # seconds between two looks at the processes


class LocalPool:
    """Makes assets on this machine, as many at once as fit (:func:`core.batch.needs.places`)."""

    stopping = "Stopping after the present step; Ctrl-C again stops at once."

    def __init__(
        self,
        needs: Needs,
        at_once: int | None = None,
        timeout: float | None = None,
        command: Sequence[str] = COMMAND,
    ) -> None:
        self.needs, self.places = needs, places(needs, at_once)
        self._command, self._timeout = command, timeout
        self._running: list[tuple[Task, Attempt, int]] = []
        self._gpus = gpus() if needs.gpus else 0
        # A core that another place does not use makes one asset faster, not the batch.
        self._threads = THREADS if self.places > 1 or cores() == 1 else {}

    def start(self, task: Task) -> None:
        """Start or continue ``task``, whose run folder has its job."""
        assert task.folder
        used = [gpu for _, _, gpu in self._running]
        named = card_of(task.job.device) if task.job else None
        gpu = min(range(self._gpus), key=used.count, default=-1) if named is None else named
        # A card that the job names it finds itself, among all.
        chosen = {"CUDA_VISIBLE_DEVICES": visible_name(gpu)} if gpu >= 0 and named is None else {}
        environ = {**self._threads, **chosen}
        attempt = Attempt(task.folder, self._command, self._timeout, environ)
        self._running.append((task, attempt, gpu))

    def wait(self, seconds: float) -> list[tuple[Task, End]]:
        """The ended attempts, after ``seconds`` at the latest."""
        until = time.monotonic() + seconds
        while True:
            found = [(entry, entry[1].poll()) for entry in self._running]
            ended = [(entry, end) for entry, end in found if end is not None]
            if ended or time.monotonic() > until:
                self._running = [entry for entry, end in found if end is None]
                return [(task, end) for (task, _, _), end in ended]
            time.sleep(PAUSE)

    def stop(self) -> None:
        """Ask all to stop after their present step, and wait for it; a Ctrl-C ends them at once."""
        try:
            for _, attempt, _ in self._running:
                attempt.stop()
            while self._running:
                self.wait(1.0)
        except KeyboardInterrupt:
            for _, attempt, _ in self._running:
                attempt.close()


def visible_name(gpu: int) -> str:
    """The name in CUDA_VISIBLE_DEVICES of GPU number ``gpu`` among those this process sees.

    Where the variable is set already, as a job scheduler does, that is one of its own entries: an
    index of the machine's, a UUID or a MIG part's name.
    """
    entries = os.environ.get("CUDA_VISIBLE_DEVICES", "").split(",")
    names = [entry.strip() for entry in entries if entry.strip()]
    return names[gpu] if gpu < len(names) else str(gpu)
