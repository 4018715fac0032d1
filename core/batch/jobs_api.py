"""Ray's Jobs interface over HTTP, which a cluster's head offers (its ``ray[default]``).

Standard library only: who submits a job needs no Ray. The paths, the JSON and the header are those
of Ray's documentation ("Ray Jobs REST API", "Ray token authentication").
"""

import json
import time
import urllib.error
import urllib.request
from http.client import HTTPException
from typing import Any
from urllib.parse import quote, urlsplit

from core.errors import MissingError, UserError

TOKEN = "RAY_AUTH_TOKEN"  # the variable, as Ray's own
ALIVE = ("PENDING", "RUNNING")
ANSWER_SECONDS = 30.0  # of one request; a parcel of some megabytes goes with it
PATIENCE = 60.0  # seconds without an answer until a cluster counts as gone
PAUSE = 2.0  # seconds between two tries


class ClusterGoneError(UserError):
    """The cluster does not answer; its job may go on."""

    status = 3


class _NoRedirect(urllib.request.HTTPRedirectHandler):
    """A redirection would hand the token to another address."""

    def redirect_request(self, *_: Any) -> None:
        return None


class Jobs:
    """The jobs of one cluster."""

    def __init__(self, url: str, token: str = "") -> None:
        self.url = checked(url)
        self._token = token.strip()
        self._open = urllib.request.build_opener(_NoRedirect()).open

    def version(self) -> str:
        """Ray's, of the cluster; raises where there is none, or the token is not right."""
        return str(self._json("GET", "/api/version", patience=0.0).get("ray_version"))

    def upload(self, name: str, content: bytes) -> str:
        """Hand the zip ``content`` to the cluster: its URI there."""
        self._ask("PUT", f"/api/packages/gcs/{name}", content, "application/octet-stream")
        return f"gcs://{name}"

    def submit(self, request: dict[str, Any]) -> str:
        """Start a job: its id."""
        found = self._json("POST", "/api/jobs/", json.dumps(request).encode())
        return str(found["submission_id"])

    def state(self, job: str) -> tuple[str, str]:
        """A job's status and what Ray adds to it; ("", "") where the cluster knows no such job."""
        try:
            found = self._json("GET", f"/api/jobs/{quote(job)}")
        except MissingError:
            return "", ""
        return str(found.get("status")), str(found.get("message") or "")

    def log(self, job: str) -> str:
        """A job's output from its start."""
        return str(self._json("GET", f"/api/jobs/{quote(job)}/logs").get("logs") or "")

    def stop(self, job: str) -> None:
        """Ask a job to end."""
        self._ask("POST", f"/api/jobs/{quote(job)}/stop")

    def _json(self, method: str, path: str, body: bytes | None = None, **how: Any) -> dict:
        text = self._ask(method, path, body, **how)
        try:
            found = json.loads(text)
        except ValueError:
            found = None
        if not isinstance(found, dict):
            raise UserError(
                f"{self.url} answers, but not as a Ray cluster does.",
                "Give the address of its dashboard, such as http://192.0.2.10:8265.",
            )
        return found

    def _ask(
        self,
        method: str,
        path: str,
        body: bytes | None = None,
        kind: str = "application/json",
        patience: float | None = None,
    ) -> bytes:
        end = time.monotonic() + (PATIENCE if patience is None else patience)
        while True:
            try:
                return self._once(method, path, body, kind)
            except urllib.error.HTTPError as error:
                with error:  # it holds the connection
                    raise self._refusal(error) from None
            except (OSError, HTTPException) as error:
                if time.monotonic() >= end:
                    reason = getattr(error, "reason", None) or error
                    raise ClusterGoneError(
                        f"No Ray cluster answers at {self.url} ({reason}).",
                        "Check the address and that its head runs with --jobs; "
                        "the run can be resumed.",
                    ) from None
            time.sleep(PAUSE)

    def _once(self, method: str, path: str, body: bytes | None, kind: str) -> bytes:
        request = urllib.request.Request(self.url + path, data=body, method=method)
        if body is not None:
            request.add_header("Content-Type", kind)
        if self._token:
            request.add_unredirected_header("Authorization", f"Bearer {self._token}")
        with self._open(request, timeout=ANSWER_SECONDS) as answer:
            return answer.read()

    def _refusal(self, error: urllib.error.HTTPError) -> UserError:
        if error.code in (401, 403):
            what = "asks for a token" if error.code == 401 else "does not accept this token"
            return UserError(
                f"The Ray cluster at {self.url} {what}.",
                f"Give the cluster's token in the preferences, or in the variable {TOKEN}.",
            )
        if error.code == 404:
            return MissingError(
                f"{self.url} has no Ray Jobs interface, or no such job.",
                "Start its head with run.py node --head --jobs, and ray[default] installed there.",
            )
        lines = error.read(4000).decode("utf-8", "replace").strip().splitlines()
        return UserError(
            f"The Ray cluster at {self.url} refuses ({error.code}: {lines[-1] if lines else ''}).",
            "Read the log of its head.",
        )


def checked(url: str) -> str:
    """The address without a last slash; UserError for one that is none."""
    try:
        parts = urlsplit(url.strip())
        whole = parts.scheme in ("http", "https") and bool(parts.hostname) and parts.port != 0
        has_more = parts.username or parts.query or parts.fragment
    except ValueError:
        whole = has_more = False
    if not whole or has_more:
        # It may hold a password: it is not repeated.
        raise UserError(
            "The address of the Ray cluster is not valid.",
            "Give http://HOST:8265, without a name, a password or a token in it.",
        )
    return url.strip().rstrip("/")
