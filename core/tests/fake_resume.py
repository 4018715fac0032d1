"""A fake core for the batch's tests: ``fake_resume.py RUN`` does what the job's prompt asks for.

A step is counted in ``checkpoint/steps.safetensors``, so that a second session continues from
there.
"""

import json
import os
import shutil
import signal
import sys
import time
from pathlib import Path

run = Path(sys.argv[-1])
job = json.loads((run / "job.json").read_text(encoding="utf-8"))
prompt, steps = job["prompt"], run / "checkpoint" / "steps.safetensors"
if "--end-with-stdin" in sys.argv:  # as the real one, from the folder that it is started in
    sys.path.insert(0, str(Path.cwd()))
    from core.batch.orphan import end_with_stdin

    end_with_stdin()


def report(kind: str, **fields: object) -> None:
    with (run / "events.jsonl").open("a", encoding="utf-8") as file:
        file.write(json.dumps({"type": kind, "time": time.time(), **fields}) + "\n")


def fail(code: int, text: str) -> None:
    report("error", text=text)
    print(f"error: {text}", flush=True)
    sys.exit(code)


steps.parent.mkdir(exist_ok=True)
done = int(steps.read_text()) if steps.exists() else 0
report("started", pid=os.getpid(), step=done)
if "unknown" in prompt:
    fail(2, "There is no noun 'unknown'. Say chair.")
if "large" in prompt and job["settings"].get("geometry.views_at_once", 24) > 1:
    fail(4, "There is not enough memory.")
while done < (10_000 if "endless" in prompt else int(os.environ.get("FAKE_STEPS", "3"))):
    time.sleep(float(os.environ.get("FAKE_PAUSE", "0.01")))
    done += 1
    steps.with_suffix(".tmp").write_text(str(done))
    steps.with_suffix(".tmp").replace(steps)
    if "dies" in prompt and done == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    if (run / "cancel").exists() and "deaf" not in prompt:
        (run / "cancel").unlink()
        report("cancelled", text="Cancelled.")
        sys.exit(130)
asset = run / "asset.tmp"
asset.mkdir(exist_ok=True)
for name in ("asset.glb", "preview.png"):
    if "FAKE_ASSET" in os.environ:
        shutil.copy(Path(os.environ["FAKE_ASSET"]) / name, asset)
info = {"mesh": {"closed": True, "components": 1, "faces": 100}, "timings": {"geometry": 1.5}}
(asset / "asset.json").write_text(json.dumps(info), encoding="utf-8")
asset.rename(run / "asset")
report("done", path="asset", text="complete")
