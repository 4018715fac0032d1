"""``resume RUN --ray-jobs URL``: the run continues on a Ray cluster, and its folder here as if
here.

This process holds the run's lock, hands the run folder with its inputs to the cluster as a job, and
writes into the folder what comes back: events, previews, checkpoints, the asset. So whoever looks
at the folder sees a run like any other, and cancels it as any other. Standard library only.
"""

import hashlib
import io
import json
import os
import time
import uuid
import zipfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from core.batch.attempt import COMMAND
from core.batch.job_node import messages, unpacked
from core.batch.jobs_api import ALIVE, TOKEN, Jobs
from core.batch.node import source_version
from core.batch.parcel import outward, unpack
from core.errors import Cancelled, Paused, UserError
from core.interrupt import asks_to_stop
from core.io.job import EVENTS, LAST, EventWriter, Job, write_text
from core.io.json_file import read_object
from core.io.lock import run_lock

RECORD = "cluster.json"  # in the run folder: which job has it; never a token
BACK = ("preview", "checkpoint", "asset")  # folders of the run that the cluster may write
WAITS_SECONDS = 30.0  # for room on the cluster, before the user is informed
SECONDS = 30.0  # between two checkpoints that come back
PAUSE = 1.0  # seconds between two looks at the cluster
REST = 10.0  # a pause is this many times as long as reading the log took
STOP_SECONDS = 20  # for the core to end after its present step; then Ray ends it
OWN = ("type", "time", "pid", "self")  # of an event: this machine's
BUILTIN = "builtin"
# The node's own interpreter: `run.py node` names it, an image has it on its path.
ENTRY = '"${FANTASIA3D_NODE_PYTHON:-python}" -P -m core.batch.job_node'


class Relay:
    """One run whose work is done on a cluster."""

    def __init__(self, folder: Path, jobs: Jobs, until: str) -> None:
        self._folder, self._jobs, self._until = folder, jobs, until
        self._events = EventWriter(folder)
        self._job, self._seen = "", 0
        self._stop = self._stopped = False
        self._end: dict[str, Any] | None = None
        self._warn_at: float | None = time.monotonic() + WAITS_SECONDS

    def ask_to_stop(self) -> None:
        """Cancel at the next look; a signal handler."""
        self._stop = True

    def run(self) -> dict[str, Any]:
        """Go on until the job's end: its last message."""
        self._jobs.version()  # what is wrong with address or token is found before any upload
        if not self._found():
            self._check_cancelled()
            self._submit()
        while True:
            started = time.monotonic()
            # Its state first: what it printed before its end is then in the log.
            state, more = self._jobs.state(self._job)
            self._take(self._jobs.log(self._job) if state else "")
            if self._end is not None:
                (self._folder / RECORD).unlink(missing_ok=True)
                return self._end
            if state not in ALIVE:
                (self._folder / RECORD).unlink(missing_ok=True)
                raise self._lost(state, more)
            self._warn(state)
            if self._cancelled() and not self._stopped:
                self._jobs.stop(self._job)
                self._stopped = True
            time.sleep(max(PAUSE, REST * (time.monotonic() - started)))

    def _warn(self, state: str) -> None:
        if state != "PENDING":
            self._warn_at = None
        elif self._warn_at is not None and time.monotonic() > self._warn_at:
            self._warn_at = None
            text = "The cluster has no room for this run yet; it waits there."
            self._events.write("warning", text=text)

    def _lost(self, state: str, more: str) -> UserError:
        if self._cancelled() or state == "STOPPED":
            return Cancelled("Cancelled.", f"Continue it: run.py resume {self._folder}")
        lines = more.strip().splitlines()
        how = f" ({lines[0][:200]})" if lines else ""
        return UserError(
            f"The cluster's job ended without a result{how}." if state
            else "The cluster no longer knows this run's job.",
            "Resume the run: it continues from the last checkpoint that came back.",
        )  # fmt: skip

    def _cancelled(self) -> bool:
        return self._stop or (self._folder / "cancel").exists()

    def _check_cancelled(self) -> None:
        if self._cancelled():
            raise Cancelled("Cancelled.", f"Continue it: run.py resume {self._folder}")

    def _found(self) -> bool:
        """Whether an earlier session's job is still there, to be followed."""
        with suppress(OSError, ValueError, KeyError, TypeError):
            record = json.loads((self._folder / RECORD).read_text(encoding="utf-8"))
            same = record["url"] == self._jobs.url and record["until"] == self._until
            if not same:
                return False
            self._job, self._seen = str(record["job"]), int(record["seen"])
            return self._jobs.state(self._job)[0] in (*ALIVE, "SUCCEEDED")
        return False

    def _submit(self) -> None:
        options = ["--until", self._until] if self._until else []
        order = {"name": self._folder.name, "options": options, "seconds": SECONDS,
                 "version": source_version(), "command": COMMAND[1:]}  # fmt: skip
        package = zipped({"order.json": json.dumps(order).encode(),
                          "parcel.tar": outward(self._folder)})  # fmt: skip
        name = f"_ray_pkg_{hashlib.sha256(package).hexdigest()[:32]}.zip"
        uri = self._jobs.upload(name, package)
        self._job, self._seen = f"fantasia3d-{uuid.uuid4().hex[:12]}", 0
        self._remember()  # before: a relay that dies meanwhile finds its job again
        self._jobs.submit(request_of(self._job, uri, read_job(self._folder)))

    def _remember(self) -> None:
        record = {"url": self._jobs.url, "job": self._job, "seen": self._seen}
        write_text(self._folder / RECORD, json.dumps(record | {"until": self._until}) + "\n")

    def _take(self, log: str) -> None:
        for message in messages(log, self._seen):
            if parcel := message.get("parcel"):
                unpack(unpacked(parcel), self._folder, BACK)
            if message.get("end") is not None:
                self._end = message
            elif event := message.get("event"):
                mirror(self._events, event)
            self._seen += 1
            self._remember()  # after each: what has come is not taken twice


def mirror(events: EventWriter, event: Mapping[str, Any]) -> None:
    """Write an event of the cluster's, with this machine's time."""
    if event.get("type") in EVENTS and event.get("type") not in ("started", *LAST):
        fields = {key: value for key, value in event.items() if key not in OWN}
        events.write(event["type"], **fields)


def zipped(files: Mapping[str, bytes]) -> bytes:
    """A zip whose bytes depend on its contents alone."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        for name, content in files.items():  # a ZipInfo is packed as its own call requests
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED, 1)
    return out.getvalue()


def request_of(job_id: str, uri: str, job: Job) -> dict[str, Any]:
    """The resources to request from Ray: a core, and a GPU for a checkpoint that runs on one."""
    on_gpu = job.device.split(":")[0] == "cuda" or (
        job.device == "auto" and job.guidance != BUILTIN
    )
    return {
        "entrypoint": ENTRY,
        "submission_id": job_id,
        "runtime_env": {
            "working_dir": uri,
            "env_vars": {"RAY_JOB_STOP_WAIT_TIME_S": str(STOP_SECONDS)},
        },
        "entrypoint_num_cpus": 1,
        "entrypoint_num_gpus": 1 if on_gpu else 0,
    }


def read_job(folder: Path) -> Job:
    """The job of a run folder."""
    return Job.from_object(read_object(folder / "job.json", "Start a new run."))


def relay(folder: Path, url: str, until: str, since: float) -> Path | None:
    """Carry out the run in ``folder`` on the cluster at ``url``; its asset, None where it paused.

    ``since``: a request to cancel that is older was meant for an earlier session.

    Raises:
        UserError: the address, the token or the cluster is not right, or the job failed.
    """
    if not (folder / "job.json").is_file():
        raise UserError(f"{folder} is not a run folder: it has no job.json.", "Start a new run.")
    one = Relay(folder, Jobs(url, os.environ.get(TOKEN, "")), until)
    with run_lock(folder), asks_to_stop(one.ask_to_stop):
        cancel, events = folder / "cancel", EventWriter(folder)
        if cancel.exists() and cancel.stat().st_mtime < since:
            cancel.unlink()
        events.write("started", pid=os.getpid())
        try:
            return _ended(folder, events, one.run())
        except Paused:
            return None
        except UserError as error:
            cancel.unlink(missing_ok=True)
            kind = "cancelled" if error.status == Cancelled.status else "error"
            events.write(kind, text=error.text, fix=error.window_fix or error.fix or None)
            raise
        except Exception as error:
            events.write("error", text=f"{type(error).__name__}: {error}", fix="Resume the run.")
            raise


def _ended(folder: Path, events: EventWriter, message: Mapping[str, Any]) -> Path:
    """The asset; raises the error of the job's last event."""
    end, last = message["end"], message.get("event") or {}
    text, fix = str(last.get("text") or end["text"]), str(last.get("fix") or "")
    if end["code"] == 0 and last.get("type") == "done" and (folder / "asset").is_dir():
        events.write("done", path="asset", text=f"{folder / 'asset'} is complete.")
        return folder / "asset"
    if last.get("type") == "paused":
        fix = f"Finish it: run.py resume {folder}"
        events.write("paused", text=text, fix=fix)
        raise Paused(text, fix)
    if last.get("type") == "cancelled":
        raise Cancelled("Cancelled.", f"Continue it: run.py resume {folder}")
    error = UserError(text or "The cluster's job ended without a result.", fix)
    error.status = end["code"] if 2 <= end["code"] <= 7 else UserError.status
    raise error
