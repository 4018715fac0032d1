"""A batch on a Ray cluster of two nodes on loopback; one of them is killed.

Needs ``run.py setup ray``; run it with ``-m slow``.
"""

import os
import socket
import subprocess
import threading
from argparse import Namespace
from functools import partial

import pytest

from core.batch.attempt import ROOT
from core.command_line import main
from core.tests.batch.test_batch import FAKE, report, sessions, wait_for

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore")]  # Ray's own
pytest.importorskip("ray")
ASSETS = 8
PORTS = ("metrics_agent_port", "metrics_export_port", "dashboard_agent_listen_port",
         "runtime_env_agent_port")  # fmt: skip


def free_ports():
    """Named, as Ray gives up after 15 s where it has to find them on a busy machine."""
    sockets = [socket.socket() for _ in PORTS]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    numbers = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return dict(zip(PORTS, numbers, strict=True))


@pytest.fixture
def cluster(monkeypatch):
    from ray.cluster_utils import Cluster

    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    monkeypatch.setenv("RAY_USAGE_STATS_ENABLED", "0")
    monkeypatch.setenv("FAKE_STEPS", "8")
    monkeypatch.setenv("FAKE_PAUSE", "0.4")
    options = {"object_store_memory": 80 << 20, "include_dashboard": False}
    made = Cluster(initialize_head=True, head_node_args={"num_cpus": 0, **options, **free_ports()})
    yield made
    import ray

    ray.shutdown()
    made.shutdown()


def add(cluster):
    return cluster.add_node(
        num_cpus=1, memory=4 << 30, object_store_memory=80 << 20, **free_ports()
    )


def test_a_killed_nodes_assets_go_on_elsewhere(cluster, tmp_path, monkeypatch, capsys):
    from core.batch.cluster import RayPool

    node, _ = add(cluster), add(cluster)
    command = (*FAKE, "--end-with-stdin")
    monkeypatch.setattr(
        "core.batch.cluster.RayPool", partial(RayPool, command=command, seconds=0.3)
    )
    (tmp_path / "t.txt").write_text("".join(f"a chair {n}\n" for n in range(ASSETS)))
    out = tmp_path / "out"
    argv = ["batch", str(tmp_path / "t.txt"), "--out", str(out), "--ray", cluster.address]

    def kill():
        wait_for(lambda: len(list(out.glob("*/asset"))) >= 3, 300)
        before = set(out.glob("*/checkpoint/*.safetensors"))  # of those that run
        wait_for(lambda: len(set(out.glob("*/checkpoint/*.safetensors")) - before) >= 2, 300)
        cluster.remove_node(node, allow_graceful=False)

    killer = threading.Thread(target=kill)
    killer.start()
    assert main(argv) == 0, capsys.readouterr().err
    killer.join()
    rows = report(tmp_path)
    assert [row["state"] for row in rows] == ["done"] * ASSETS
    again = [row for row in rows if int(row["attempts"]) > 1]
    assert len(again) == 1  # what the dead node had
    first, second = sessions(out / again[0]["folder"])
    assert first == 0 < second  # from the checkpoint that had come back
    others = [sessions(out / row["folder"]) for row in rows if row not in again]
    assert others == [[0]] * (ASSETS - 1)  # nothing was made twice
    assert "Traceback" not in capsys.readouterr().err
    assert main(argv) == 0
    assert {row["attempts"] for row in report(tmp_path)} == {"0"}


def test_a_node_with_another_version_is_refused(cluster, tmp_path, monkeypatch):
    add(cluster)
    monkeypatch.setattr("core.batch.cluster.source_version", lambda: "other")
    (tmp_path / "t.txt").write_text("a chair\n")
    argv = ["batch", str(tmp_path / "t.txt"), "--out", str(tmp_path / "out")]
    assert main([*argv, "--ray", cluster.address]) == 6
    (row,) = report(tmp_path)
    assert "another version of this project" in row["text"]


def test_no_cluster_is_one_sentence(tmp_path, capsys):
    (tmp_path / "t.txt").write_text("a chair\n")
    argv = ["batch", str(tmp_path / "t.txt"), "--out", str(tmp_path / "out")]
    assert main([*argv, "--ray", "127.0.0.1:1"]) == 2
    assert "There is no Ray cluster at '127.0.0.1:1'" in capsys.readouterr().err


def test_a_node_takes_no_module_from_the_current_folder(tmp_path, monkeypatch):
    from core.batch.cluster import be_node

    started = []

    def become(*given):
        started.append(given)
        raise SystemExit

    monkeypatch.setattr(os, "execve", become)
    with pytest.raises(SystemExit):
        be_node(Namespace(join="", head=True, port=6379, cpus=None))
    mark = tmp_path / "mark"
    (tmp_path / "ray.py").write_text(f"open({str(mark)!r}, 'w')\n")
    _, words, environ = started[0]
    ray = words[: words.index("start")]
    subprocess.run([*ray, "--version"], env=environ, cwd=tmp_path, check=True)
    assert not mark.exists()
