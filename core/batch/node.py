"""A cluster node's work on one asset: unpack, run the core, send its files back.

Standard library only: a worker that waits for a process needs no torch.
"""

import hashlib
import socket
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from typing import Any

from core.batch.attempt import ROOT, Attempt, End
from core.batch.parcel import ASSET, STATE, found, homeward, settle, unpack

PAUSE = 0.5  # seconds between two looks at the process


@dataclass(frozen=True)
class Order:
    """A node's order for a parcel."""

    name: str
    command: Sequence[str]
    timeout: float | None
    seconds: float  # between two checkpoints that are sent back
    version: str  # of the project's source


def make(order: dict[str, Any], parcel: bytes) -> Iterator[dict[str, Any]]:
    """On a node: continue the run in ``parcel``; its checkpoints now and then, then its end."""
    asked, node = Order(**order), socket.gethostname()
    if asked.version != source_version():
        text = f"The node {node} has another version of this project; copy this one there."
        yield {"parcel": b"", "end": asdict(End(3, text, 0.0, node))}
        return
    with tempfile.TemporaryDirectory(prefix="fantasia3d-") as temporary:
        folder = Path(temporary) / asked.name
        unpack(parcel, folder)
        settle(folder)
        attempt, sent, at = Attempt(folder, asked.command, asked.timeout), {}, time.monotonic()
        try:
            while (end := attempt.poll()) is None:
                time.sleep(PAUSE)
                now = times(folder)
                if now != sent and time.monotonic() - at >= asked.seconds:
                    sent, at = now, time.monotonic()
                    yield {"parcel": homeward(folder, STATE), "end": None}
        finally:
            attempt.close()
        files = homeward(folder, ASSET if end.code == 0 else STATE)
        yield {"parcel": files, "end": at_home(asdict(end), folder) | {"node": node}}


def at_home(event: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """An event of the run in ``folder``, a temporary folder here, with the folder's name for it."""

    def named(value: Any) -> Any:
        for place in (folder.resolve(), folder) if isinstance(value, str) else ():
            value = value.replace(str(place), folder.name)
        return value

    return {key: named(value) for key, value in event.items()}


def times(folder: Path) -> dict[str, int]:
    """When each checkpoint was written."""
    files = found(folder, ("checkpoint/*.safetensors",))
    return {name: path.stat().st_mtime_ns for name, path in files.items()}


@cache
def source_version() -> str:
    """A hash of the core's source: two machines of a batch must have the same.

    Of what the extension's zip holds as well, which is without the tests and the prior's training.
    """
    digest = hashlib.sha256()
    for path in sorted((ROOT / "core").rglob("*.py")):
        name = path.relative_to(ROOT)
        if not {"tests", "prior"} & set(name.parts):
            digest.update(name.as_posix().encode() + path.read_bytes())
    return digest.hexdigest()[:16]
