"""The files of deploy/: what they run exists, and Ray accepts its cluster files."""

import json
import re
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from core.batch.node import ROOT, source_version

sys.path.insert(0, str(ROOT))
import run

DEPLOY = ROOT / "deploy"
CLUSTERS = sorted(DEPLOY.glob("*.yaml"))


def ray_schema():
    """Ray's own, without loading Ray."""
    spec = find_spec("ray")
    if spec is None or not spec.submodule_search_locations:
        pytest.skip("Ray is not installed")
    path = Path(next(iter(spec.submodule_search_locations)), "autoscaler", "ray-schema.json")
    return json.loads(path.read_text())


@pytest.mark.parametrize("path", CLUSTERS, ids=lambda path: path.stem)
def test_ray_accepts_the_cluster_file(path):
    validate = pytest.importorskip("jsonschema").validate
    yaml = pytest.importorskip("yaml")
    schema, cluster = ray_schema(), yaml.safe_load(path.read_text())
    validate(cluster, schema)
    with pytest.raises(Exception, match="Additional properties"):  # it does look at the keys
        validate(cluster | {"head_node_typ": "head"}, schema)


@pytest.mark.parametrize("path", CLUSTERS, ids=lambda path: path.stem)
def test_every_node_asks_for_the_token_and_reports_nothing_home(path):
    text = path.read_text()
    starts = re.findall(r"RAY_AUTH_MODE=token(?:(?!start).)*start --(?:head|address)", text, re.S)
    assert len(starts) == len(re.findall(r"start --", text)) == 2
    image = (DEPLOY / "Dockerfile").read_text()
    assert "RAY_USAGE_STATS_ENABLED=0" in (path.read_text() if "rack" in path.name else image)


@pytest.mark.parametrize("path", [*CLUSTERS, DEPLOY / "Dockerfile"], ids=lambda path: path.name)
def test_every_command_that_is_named_exists(path):
    text = path.read_text()
    named = re.findall(r"run\.py ([a-z]+)", text) + re.findall(r" fantasia3d ([a-z]+)", text)
    assert named and set(named) <= {*run.parser().names, *run.PASS_ON}


def test_the_clouds_commands_need_no_path():
    """Ray's launcher runs them in a login shell, whose profile (Debian's) sets PATH again."""
    text = (DEPLOY / "cluster-cloud.yaml").read_text()
    commands = re.findall(r"(\S*)\bray (?:stop|start)", text)
    (env,) = re.findall(r"FANTASIA3D_ENV=(\S+)", (DEPLOY / "Dockerfile").read_text())
    assert commands == [f"{env}/bin/"] * 4


def test_the_image_installs_the_groups_that_setup_has():
    (groups,) = re.findall(r'^ARG SETUP="(.*)"', (DEPLOY / "Dockerfile").read_text(), re.M)
    assert run.parse(["setup", *groups.split()]).groups == ["ray"]
    assert set(groups.split()) <= set(run.GROUPS)


def test_the_image_leaves_out_nothing_that_the_version_counts():
    """Else no node made from it would take a task from a desk."""
    left_out = (DEPLOY / "Dockerfile.dockerignore").read_text().split()
    assert not {"core", "core/prior", "fantasia3d_addon", "run.py"} & set(left_out)


def test_the_extensions_zip_has_the_version_of_the_project_and_no_deploy_folder(
    tmp_path, monkeypatch
):
    from core.batch import node

    run.fill_package(tmp_path / "zip")
    assert not list((tmp_path / "zip").rglob("deploy"))
    whole = source_version()
    monkeypatch.setattr(node, "ROOT", tmp_path / "zip" / "method")
    assert source_version.__wrapped__() == whole
