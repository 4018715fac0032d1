"""A fake core for tests: it does what the job's prompt requests, and shows a growing ball.

``resume RUN`` reads RUN/job.json, as the add-on's jobs do; ``generate PROMPT --out RUN`` writes
it first, as the command line does. The job's negative prompt names the asset that comes out.
"""

import contextlib
import json
import os
import shutil
import signal
import sys
import time
from pathlib import Path

if sys.argv[1] == "words":  # which the real one reports as fast
    root = Path(__file__).parents[3]
    os.chdir(root)
    os.execv(sys.executable, [sys.executable, "-m", "core", *sys.argv[1:]])
if sys.argv[1] == "generate":
    run = Path(sys.argv[sys.argv.index("--out") + 1])
    run.mkdir(parents=True)
    job = {"prompt": sys.argv[2], "negative_prompt": os.environ.get("FAKE_ASSET", "")}
    (run / "job.json").write_text(json.dumps(job), encoding="utf-8")
run = Path(sys.argv[-1])
lock = (run / "lock").open("wb", buffering=0)  # held until the end, as the real one holds it
with contextlib.suppress(ImportError):  # Windows
    import fcntl

    fcntl.flock(lock, fcntl.LOCK_EX)
    lock.write(f" {os.getpid()}\n".encode())
job = json.loads((run / "job.json").read_text(encoding="utf-8"))
prompt = job["prompt"]
events = run / "events.jsonl"
signal.signal(signal.SIGINT, lambda *_: (run / "cancel").touch())


def report(kind: str, **fields: object) -> None:
    with events.open("a", encoding="utf-8") as file:
        file.write(json.dumps({"type": kind, "time": time.time(), **fields}) + "\n")


def preview(fraction: float) -> None:
    """A ball that grows a nose, as a mesh and as a picture of its normals."""
    import numpy as np

    sys.path.insert(0, str(Path(__file__).parents[3]))
    from blender_tests.asset_fixture import block, write_png

    verts, faces, _, _ = block(24)
    ball = verts - verts.mean(0)
    ball = 0.45 * ball / np.linalg.norm(ball, axis=1, keepdims=True)
    verts = (1 - fraction) * ball + fraction * (verts - (0, 0, 0.5))
    folder = run / "preview"
    folder.mkdir(exist_ok=True)
    with (folder / "shape.tmp").open("wb") as file:
        np.savez(file, verts=verts.astype(np.float32), faces=faces.astype(np.int32))
    (folder / "shape.tmp").replace(folder / "shape.npz")
    y, x = np.mgrid[1:-1:128j, -1:1:128j]
    inside = x**2 + y**2 < (0.4 + 0.4 * fraction) ** 2
    normal = np.stack([x, y, np.sqrt(np.maximum(0, 1 - x**2 - y**2))], -1) / 2 + 0.5
    picture = np.where(inside[..., None], normal, 0.9)
    write_png(folder / "normals.tmp", (picture * 255).astype(np.uint8))
    (folder / "normals.tmp").replace(folder / "normals.png")
    report("preview", stage="geometry", path="preview/normals.png")
    report("preview", stage="geometry", path="preview/shape.npz")


def train(stage: str, steps: int, pause: float, shows: bool) -> None:
    for step in range(steps):
        if (run / "cancel").exists() and prompt != "deaf":
            report("cancelled", text="Cancelled.", fix="Resume it.")
            sys.exit(130)
        if shows and step % 10 == 0:
            preview(min(1.0, step / 60))
        left = round((steps - step) * pause + 1, 1)
        report("progress", stage=stage, step=step + 1, steps=steps, loss=0.5, seconds_left=left)
        time.sleep(pause)


print("the fake core", sorted(key for key in os.environ if key.startswith("PYTHON")), flush=True)
if prompt == "say nothing":
    time.sleep(30)
report("started", pid=os.getpid())
if prompt == "die":
    os.abort()
if prompt == "fail":
    report("error", text="There is no noun 'blorb'.", fix="Say chair.", future_key=1)
    print("error: There is no noun 'blorb'. Say chair.", file=sys.stderr)
    sys.exit(2)
if prompt == "half a line":
    with events.open("ab") as file:
        line = '{"type": "progress", "stage": "gré", "step": 1, "steps": 2}\n'.encode()
        middle = line.index("é".encode()) + 1  # not even the letter is whole
        file.write(line[:middle])
        file.flush()
        time.sleep(0.3)
        file.write(line[middle:])
if prompt.startswith("show"):  # as long as a user looks at it
    train("geometry", 600, 0.1, shows=True)
elif prompt == "brief":  # as long as another Blender needs to find it
    train("geometry", 60, 0.05, shows=False)
else:
    train("geometry", 10_000 if prompt in ("long", "deaf") else 5, 0.01, shows=False)
if "--until" in sys.argv:
    preview(0.5)
    report("paused", text="The shape is ready to look at.", fix="Finish it.")
    sys.exit(0)
if prompt == "nonsense":
    with events.open("a", encoding="utf-8") as file:
        file.write("not json\n[1]\n")
if job.get("negative_prompt"):
    shutil.copytree(job["negative_prompt"], run / "asset")
report("done", path="asset", text="complete")
print(run / "asset")
