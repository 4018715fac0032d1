"""Stands for the core in tests: it does what the job's prompt says.

``resume RUN`` reads RUN/job.json, as the add-on's jobs do; ``generate PROMPT --out RUN`` writes
it first, as the command line does. The job's negative prompt names the asset that comes out.
"""

import json
import os
import shutil
import signal
import sys
import time
from pathlib import Path

if sys.argv[1] == "generate":
    run = Path(sys.argv[sys.argv.index("--out") + 1])
    run.mkdir(parents=True)
    job = {"prompt": sys.argv[2], "negative_prompt": os.environ.get("FAKE_ASSET", "")}
    (run / "job.json").write_text(json.dumps(job), encoding="utf-8")
run = Path(sys.argv[-1])
job = json.loads((run / "job.json").read_text(encoding="utf-8"))
events = run / "events.jsonl"
signal.signal(signal.SIGINT, lambda *_: (run / "cancel").touch())


def say(kind: str, **fields: object) -> None:
    with events.open("a", encoding="utf-8") as file:
        file.write(json.dumps({"type": kind, "time": time.time(), **fields}) + "\n")


def train(steps: int) -> None:
    for step in range(steps):
        if (run / "cancel").exists():
            say("cancelled", text="Cancelled.", fix="Resume it.")
            sys.exit(130)
        say("progress", stage="geometry", step=step + 1, steps=steps, loss=0.5, seconds_left=1.0)
        time.sleep(0.01)


print("the fake core", sorted(key for key in os.environ if key.startswith("PYTHON")), flush=True)
if job["prompt"] == "say nothing":
    time.sleep(30)
say("started", pid=os.getpid())
if job["prompt"] == "die":
    os.abort()
if job["prompt"] == "fail":
    say("error", text="There is no noun 'blorb'.", fix="Say chair.", future_key=1)
    print("error: There is no noun 'blorb'. Say chair.", file=sys.stderr)
    sys.exit(2)
if job["prompt"] == "half a line":
    with events.open("ab") as file:
        line = '{"type": "progress", "stage": "gré", "step": 1, "steps": 2}\n'.encode()
        middle = line.index("é".encode()) + 1  # not even the letter is whole
        file.write(line[:middle])
        file.flush()
        time.sleep(0.3)
        file.write(line[middle:])
train(10_000 if job["prompt"] == "long" else 5)
if job["prompt"] == "nonsense":
    with events.open("a", encoding="utf-8") as file:
        file.write("not json\n[1]\n")
if job.get("negative_prompt"):
    shutil.copytree(job["negative_prompt"], run / "asset")
say("done", path="asset", text="complete")
print(run / "asset")
