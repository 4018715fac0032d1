"""The Ray job for one asset, on the cluster: ``python -m core.batch.job_node``.

Its folder holds ``order.json`` and ``parcel.tar``. All that comes back is what it prints: each line
that starts with ``MARK`` is JSON with an event, or a parcel of files in Base64. Standard library
only.
"""

import base64
import json
import signal
import sys
import tempfile
import time
import zlib
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from core.batch.attempt import Attempt, End
from core.batch.node import at_home, source_version, times
from core.batch.parcel import found, homeward, settle, unpack
from core.errors import UserError
from core.io.job import LAST, read_events

MARK = "fantasia3d "
PREVIEWS = ("preview/*.png", "preview/*.npz")
CHECKPOINTS = ("checkpoint/*.safetensors",)
WHOLE = (*PREVIEWS, *CHECKPOINTS, "asset/*")
PAUSE = 0.5  # seconds between two looks at the process
# A log is read as a whole each time: checkpoints stop to come back before it is too long for that.
LONGEST = 300_000_000  # bytes


class Sender:
    """Prints what is new in a run folder."""

    def __init__(self, folder: Path, seconds: float) -> None:
        self._folder, self._seconds = folder, seconds
        self._events, self._printed = 0, 0
        self._previews = stamps(folder, PREVIEWS)
        self._checkpoints, self._at = times(folder), time.monotonic()

    def news(self) -> None:
        """Events, after the previews that they name; checkpoints now and then."""
        events = read_events(self._folder)[self._events :]
        now = stamps(self._folder, PREVIEWS)
        if changed := [name for name in now if now[name] != self._previews.get(name)]:
            self._put(parcel=packed(self._folder, changed))
        self._previews, self._events = now, self._events + len(events)
        for event in events:
            if event.get("type") not in ("started", *LAST):
                self._put(event=at_home(event, self._folder))
        self._save()

    def _save(self) -> None:
        now = times(self._folder)
        late = time.monotonic() - self._at >= self._seconds
        if late and now != self._checkpoints and self._printed < LONGEST:
            self._put(parcel=packed(self._folder, CHECKPOINTS))
            self._checkpoints, self._at = now, time.monotonic()

    def end(self, end: End) -> None:
        """All that there is, then how it ended."""
        self.news()
        self._put(parcel=packed(self._folder, WHOLE))
        ends = [e for e in read_events(self._folder) if e.get("type") in ("started", *LAST)]
        last = at_home(ends[-1], self._folder) if ends and ends[-1]["type"] in LAST else None
        self._put(end=at_home(asdict(end), self._folder), event=last)

    def _put(self, **fields: Any) -> None:
        line = MARK + json.dumps(fields)
        self._printed += len(line)
        print(line, flush=True)


def stamps(folder: Path, patterns: tuple[str, ...]) -> dict[str, int]:
    """When each file was written."""
    return {name: path.stat().st_mtime_ns for name, path in found(folder, patterns).items()}


def packed(folder: Path, patterns: Any) -> str:
    """The files of ``folder`` that match, as text."""
    return base64.b64encode(zlib.compress(homeward(folder, patterns), 1)).decode()


def unpacked(text: str) -> bytes:
    """The parcel in what :func:`packed` gave."""
    return zlib.decompress(base64.b64decode(text))


def messages(log: str, seen: int) -> Iterator[dict[str, Any]]:
    """A job's messages after its first ``seen``; an incomplete line waits."""
    whole = log[: log.rfind("\n") + 1].splitlines()
    lines = [line for line in whole if line.startswith(MARK)]
    for line in lines[seen:]:
        message = json.loads(line.removeprefix(MARK))
        if not isinstance(message, dict):
            raise UserError("The cluster's job sent an invalid message.", "Read its log there.")
        yield message


def main(here: Path) -> None:
    """Carry out the order in the folder ``here``."""
    order = json.loads((here / "order.json").read_text(encoding="utf-8"))
    if order["version"] != source_version():
        text = "The cluster has another version of this project. Install the same on its nodes."
        print(MARK + json.dumps({"end": asdict(End(3, text, 0.0)), "event": None}), flush=True)
        return
    with tempfile.TemporaryDirectory(prefix="fantasia3d-") as temporary:
        folder = Path(temporary) / order["name"]
        unpack((here / "parcel.tar").read_bytes(), folder)
        settle(folder)
        # The events of earlier sessions are at home.
        (folder / "events.jsonl").unlink(missing_ok=True)
        _carry_out(folder, order)


def _carry_out(folder: Path, order: dict[str, Any]) -> None:
    sender = Sender(folder, order["seconds"])
    attempt = Attempt(folder, (*_command(order), *order["options"]))
    # Ray's request to stop: the core ends after its present step, and its checkpoint comes back.
    signal.signal(signal.SIGTERM, lambda *_: attempt.stop())
    try:
        while (end := attempt.poll()) is None:
            time.sleep(PAUSE)
            sender.news()
    finally:
        attempt.close()
    sender.end(end)


def _command(order: dict[str, Any]) -> tuple[str, ...]:
    """The interpreter is the node's own."""
    return (sys.executable, *order["command"])


if __name__ == "__main__":
    main(Path.cwd())
