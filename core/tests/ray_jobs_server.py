"""A small HTTP server that speaks Ray's Jobs interface, and runs the jobs here."""

import io
import json
import os
import subprocess
import sys
import zipfile
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

from core.batch.attempt import ROOT


class Handler(BaseHTTPRequestHandler):
    """The paths and answers of Ray's documentation."""

    def answer(self, code, body=b""):
        content = body if isinstance(body, bytes) else json.dumps(body).encode()
        self.send_response(code)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def handle_any(self):
        cluster = self.server.cluster
        body = self.rfile.read(int(self.headers.get("Content-Length") or 0))
        cluster.requests.append((self.command, self.path))
        given = self.headers.get("Authorization")
        if cluster.token and given != f"Bearer {cluster.token}":
            return self.answer(403 if given else 401, b"Forbidden: Invalid authentication token")
        if cluster.redirect:
            self.send_response(302)
            self.send_header("Location", cluster.redirect)
            return self.end_headers()
        name = f"{self.command} {self.path}"
        if name == "GET /api/version":
            return self.answer(200, {"version": "4", "ray_version": "2.60.0"})
        if name.startswith("PUT /api/packages/gcs/"):
            cluster.packages[self.path.rpartition("/")[2]] = body
            return self.answer(200)
        if name == "POST /api/jobs/":
            request = json.loads(body)
            cluster.start(request)
            return self.answer(200, {"submission_id": request["submission_id"]})
        job, _, what = self.path.removeprefix("/api/jobs/").partition("/")
        if job not in cluster.jobs:
            return self.answer(404, b"Job does not exist")
        found = {"logs": cluster.log, "stop": cluster.stop, "": cluster.state}
        return self.answer(200, found[what](job))

    do_GET = do_PUT = do_POST = handle_any  # noqa: N815

    def log_message(self, *_):
        pass


class Cluster:
    """The server; its jobs are processes of this machine."""

    def __init__(self, folder: Path, token="", environ=None, command=None):
        self.folder, self.token, self.redirect = folder, token, ""
        self.command = command  # instead of the core's
        self.environ = environ or {}
        self.packages, self.jobs, self.requests, self.stopped = {}, {}, [], set()
        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.cluster = self
        self.url = f"http://127.0.0.1:{self.server.server_address[1]}"
        Thread(target=self.server.serve_forever, args=(0.05,), daemon=True).start()

    def start(self, request):
        job = request["submission_id"]
        uri = request["runtime_env"]["working_dir"]
        place = self.folder / job
        with zipfile.ZipFile(io.BytesIO(self.packages[uri.removeprefix("gcs://")])) as archive:
            archive.extractall(place)
        if self.command:
            order = json.loads((place / "order.json").read_text())
            (place / "order.json").write_text(json.dumps(order | {"command": self.command}))
        more = {"PYTHONPATH": str(ROOT), "FANTASIA3D_NODE_PYTHON": sys.executable}
        with (self.folder / f"{job}.log").open("wb") as log:
            self.jobs[job] = subprocess.Popen(
                ["/bin/bash", "-c", f"exec {request['entrypoint']}"], cwd=place,
                env={**os.environ, **more, **self.environ}, stdout=log, stderr=log,
            )  # fmt: skip

    def state(self, job):
        code = self.jobs[job].poll()
        state = "RUNNING" if code is None else "FAILED" if code else "SUCCEEDED"
        stopped = code is not None and job in self.stopped
        return {"status": "STOPPED" if stopped else state, "message": ""}

    def log(self, job):
        return {"logs": (self.folder / f"{job}.log").read_text()}

    def stop(self, job):
        self.stopped.add(job)
        self.jobs[job].terminate()
        return {"stopped": True}

    def close(self):
        self.server.shutdown()
        self.server.server_close()
        for process in self.jobs.values():
            process.kill()
            process.wait()
