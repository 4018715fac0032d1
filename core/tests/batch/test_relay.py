"""A run on a Ray cluster by its Jobs interface: the folder here looks as if it ran here."""

import json
import os
import subprocess
import sys
import threading
import time

import pytest

from core.batch import jobs_api, relay
from core.batch.attempt import ROOT
from core.batch.job_node import MARK, messages
from core.batch.jobs_api import Jobs, checked
from core.batch.relay import RECORD
from core.batch.relay import relay as carry_out
from core.command_line import main
from core.errors import Cancelled, Paused, UserError
from core.io.job import EventWriter, Job, read_events
from core.tests.batch.test_batch import FAKE
from core.tests.ray_jobs_server import Cluster

SECRET = "s3cret-of-the-cluster"


@pytest.fixture(autouse=True)
def quick(monkeypatch):
    monkeypatch.setattr(relay, "PAUSE", 0.05)
    monkeypatch.setattr(relay, "SECONDS", 0.2)
    # As the real one: it does not outlive a node that is killed.
    monkeypatch.setattr(relay, "COMMAND", (*FAKE, "--end-with-stdin"))
    monkeypatch.setattr(jobs_api, "PATIENCE", 0.5)
    monkeypatch.setattr(jobs_api, "PAUSE", 0.05)
    monkeypatch.setenv("RAY_AUTH_TOKEN", SECRET)


@pytest.fixture
def cluster(tmp_path):
    (tmp_path / "cluster").mkdir()
    made = Cluster(tmp_path / "cluster", SECRET, {"FAKE_STEPS": "10", "FAKE_PAUSE": "0.2"})
    yield made
    made.close()


@pytest.fixture
def run(tmp_path):
    (tmp_path / "a run").mkdir()
    (tmp_path / "a run" / "job.json").write_text(Job(prompt="a chair").to_json())
    return tmp_path / "a run"


def kinds(run):
    return [event["type"] for event in read_events(run)]


def when(path, do):
    """``do`` once ``path`` is there, in a thread."""

    def wait():
        deadline = time.monotonic() + 60
        while not path.exists() and time.monotonic() < deadline:
            time.sleep(0.02)
        do()

    thread = threading.Thread(target=wait)
    thread.start()
    return thread


def test_the_asset_comes_home_and_the_folder_looks_as_if_it_ran_here(run, cluster):
    assert carry_out(run, cluster.url, "", time.time()) == run / "asset"
    assert (run / "asset" / "asset.json").is_file()
    assert (run / "checkpoint" / "steps.safetensors").read_text() == "10"
    assert kinds(run) == ["started", "done"]
    assert read_events(run)[0]["pid"] == os.getpid()
    assert not (run / RECORD).exists()


def test_the_token_is_nowhere_on_a_disk(run, cluster, tmp_path):
    carry_out(run, cluster.url, "", time.time())
    files = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert len(files) > 5
    assert not [path for path in files if SECRET.encode() in path.read_bytes()]
    for content in cluster.packages.values():
        assert SECRET.encode() not in content


@pytest.mark.parametrize(("token", "words"), [("wrong", "does not accept"), ("", "asks for a tok")])
def test_a_wrong_token_is_a_sentence_and_nothing_is_sent(token, words, run, cluster, monkeypatch):
    monkeypatch.setenv("RAY_AUTH_TOKEN", token)
    with pytest.raises(UserError, match=words) as caught:
        carry_out(run, cluster.url, "", time.time())
    assert kinds(run) == ["started", "error"] and not cluster.packages
    assert not token or token not in str(caught.value)


def test_a_wrong_address_is_a_sentence(run, cluster):
    cluster.server.shutdown()
    cluster.server.server_close()
    with pytest.raises(UserError, match="No Ray cluster answers"):
        carry_out(run, cluster.url, "", time.time())
    assert kinds(run) == ["started", "error"]


@pytest.mark.parametrize(
    "url", ["", "192.0.2.1:8265", "ftp://a", "http://", "http://me:pw@host", "http://h?t=1", "http://["]
)  # fmt: skip
def test_what_is_no_address_is_refused_and_not_repeated(url):
    with pytest.raises(UserError, match="is not valid") as caught:
        checked(url)
    assert "pw" not in str(caught.value)


def test_a_redirection_does_not_get_the_token(run, cluster, tmp_path):
    (tmp_path / "other").mkdir()
    other = Cluster(tmp_path / "other")
    cluster.redirect = other.url + "/api/version"
    try:
        with pytest.raises(UserError, match="302"):
            Jobs(cluster.url, SECRET).version()
        assert not other.requests
    finally:
        other.close()


def test_a_cancel_reaches_the_cluster_and_the_run_resumes_from_what_came_back(run, cluster):
    cluster.environ["FAKE_STEPS"] = "9999"
    when(run / "checkpoint" / "steps.safetensors", (run / "cancel").touch)
    with pytest.raises(Cancelled):
        carry_out(run, cluster.url, "", time.time())
    assert kinds(run) == ["started", "cancelled"]
    assert not (run / "cancel").exists() and not (run / RECORD).exists()
    done = int((run / "checkpoint" / "steps.safetensors").read_text())
    assert done > 0
    cluster.environ["FAKE_STEPS"] = str(done + 1)
    assert carry_out(run, cluster.url, "", time.time()) == run / "asset"
    # Had it started again, it would have been at 1.
    assert (run / "checkpoint" / "steps.safetensors").read_text() == str(done + 1)
    assert len(cluster.jobs) == 2


def test_a_cluster_that_goes_is_a_sentence_and_its_job_is_followed_again(run, cluster):
    """Nothing is made twice: the job went on while nobody could ask for it."""

    def go():
        cluster.server.shutdown()
        cluster.server.server_close()

    cluster.environ["FAKE_STEPS"] = "30"
    when(run / "checkpoint" / "steps.safetensors", go)
    with pytest.raises(UserError, match=r"No Ray cluster answers.*can be resumed"):
        carry_out(run, cluster.url, "", time.time())
    assert kinds(run) == ["started", "error"] and (run / RECORD).is_file()
    again = Cluster(cluster.folder, SECRET)  # the network is back, at the same address
    again.jobs = cluster.jobs
    try:
        record = json.loads((run / RECORD).read_text())
        (run / RECORD).write_text(json.dumps(record | {"url": again.url}))
        assert carry_out(run, again.url, "", time.time()) == run / "asset"
        assert len(again.jobs) == 1
    finally:
        again.server.shutdown()
        again.server.server_close()


def test_a_job_that_dies_is_a_sentence_and_the_run_goes_on_from_its_checkpoint(run, cluster):
    def kill():
        for process in cluster.jobs.values():
            process.kill()

    cluster.environ["FAKE_STEPS"] = "9999"
    when(run / "checkpoint" / "steps.safetensors", kill)
    with pytest.raises(UserError, match="ended without a result"):
        carry_out(run, cluster.url, "", time.time())
    assert kinds(run)[-1] == "error"
    done = int((run / "checkpoint" / "steps.safetensors").read_text())
    cluster.environ["FAKE_STEPS"] = str(done + 1)
    assert carry_out(run, cluster.url, "", time.time()) == run / "asset"


def test_a_finished_run_is_made_again_and_its_asset_replaced(run, cluster):
    (run / "asset").mkdir()
    (run / "asset" / "asset.json").write_text("older")
    assert carry_out(run, cluster.url, "", time.time()) == run / "asset"
    assert (run / "asset" / "asset.json").read_text() != "older"
    assert kinds(run)[-1] == "done"
    assert not [path for path in run.iterdir() if path.name.startswith(".")]


def test_what_has_come_is_remembered_message_by_message(run, cluster, monkeypatch):
    one = relay.Relay(run, Jobs(cluster.url, SECRET), "")
    lines = [MARK + json.dumps({"event": {"type": "warning", "text": str(i)}}) for i in range(2)]
    lines.append(MARK + json.dumps({"parcel": "a kill while it is unpacked"}))

    def killed(_):
        raise KeyboardInterrupt

    monkeypatch.setattr(relay, "unpacked", killed)
    with pytest.raises(KeyboardInterrupt):
        one._take("\n".join([*lines, ""]))
    assert json.loads((run / RECORD).read_text())["seen"] == 2


@pytest.mark.parametrize(
    ("device", "guidance", "cards"),
    [
        ("cuda:1", "builtin", 1),
        ("cuda", "builtin", 1),
        ("auto", "builtin", 0),
        ("auto", "x", 1),
        ("cpu", "x", 0),
    ],
)
def test_ray_is_asked_for_a_gpu_where_the_job_takes_one(device, guidance, cards):
    job = Job(prompt="a chair", device=device, guidance=guidance)
    assert relay.request_of("a", "b", job)["entrypoint_num_gpus"] == cards


def test_a_failure_comes_home_with_its_sentence_and_its_exit_code(run, cluster, capfd):
    (run / "job.json").write_text(Job(prompt="unknown").to_json())
    assert main(["resume", str(run), "--ray-jobs", cluster.url]) == 2
    assert "There is no noun 'unknown'" in capfd.readouterr().err
    assert read_events(run)[-1]["text"] == "There is no noun 'unknown'. Say chair."


def test_a_cluster_writes_into_the_folders_of_the_run_alone(run, cluster, monkeypatch):
    from core.batch.job_node import packed

    evil = run.parent / "evil"
    evil.mkdir()
    (evil / "job.json").write_text("{}")
    line = MARK + json.dumps({"parcel": packed(evil, ("*",))}) + "\n"
    monkeypatch.setattr(Jobs, "log", lambda *_: line)
    with pytest.raises(UserError, match="does not belong there"):
        carry_out(run, cluster.url, "", time.time())
    assert json.loads((run / "job.json").read_text())["prompt"] == "a chair"


def test_what_goes_to_the_cluster_is_packed():
    made = relay.zipped({"parcel.tar": bytes(100_000)})
    assert len(made) < 1000 and made == relay.zipped({"parcel.tar": bytes(100_000)})


def test_a_pause_names_the_folder_that_is_here(run):
    """The cluster's own is a temporary one, and gone."""
    last = {"type": "paused", "text": "Look.", "fix": "Finish it: run.py resume /tmp/there"}
    message = {"end": {"code": 0, "text": ""}, "event": last}
    with pytest.raises(Paused):
        relay._ended(run, EventWriter(run), message)
    (event,) = read_events(run)
    assert event["fix"] == f"Finish it: run.py resume {run}"


def test_two_relays_do_not_work_on_one_run(run, cluster):
    cluster.environ["FAKE_STEPS"] = "30"
    first = threading.Thread(target=carry_out, args=(run, cluster.url, "", time.time()))
    first.start()
    tried = when(run / RECORD, lambda: None)
    tried.join()
    with pytest.raises(UserError, match="Another process works on"):
        carry_out(run, cluster.url, "", time.time())
    first.join()
    assert len(cluster.jobs) == 1


def test_a_line_that_is_not_whole_waits():
    log = f"Ray's own line\n{MARK}" + '{"event": 1}\n' + MARK + '{"eve'
    assert list(messages(log, 0)) == [{"event": 1}]
    assert list(messages(log, 1)) == []


def test_a_relay_loads_no_torch():
    code = "import sys, core.batch.relay, core.batch.job_node; "
    code += "print({'torch', 'numpy', 'ray'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True)
    assert done.stdout.strip() == b"set()", done.stderr
