"""``doctor --report``: what a maintainer needs, and nothing of the user's."""

import json
import platform
import re
import sys
from pathlib import Path

import pytest

import run
from run import environment

report = sys.modules[environment.write_report.__module__]
LINES = [
    environment.Line("launcher", "-", "Python 3.11.7, /home/x"),
    environment.Line("GPU", "ok", ""),
]
PLANTED = (
    "annabel", "zeta-station", "corp.example", "tok-123456", "hunter2", "unicorn", "zanzibar",
    "my film", "film", "hero", "192.0.2.77", "secretlab", "einhorn",
)  # fmt: skip


@pytest.fixture
def private(tmp_path, monkeypatch):
    """A home, a host, variables, a set-up's log and a run, all with private names in them."""
    home = tmp_path / "home" / "annabel"
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.setenv("LOGNAME", "annabel")
    monkeypatch.setenv("XDG_DATA_HOME", str(home / "My Data"))
    monkeypatch.setenv("SERVICE_TOKEN", "tok-123456")
    monkeypatch.setenv("PIP_INDEX_URL", "https://annabel:hunter2@pypi.corp.example/simple")
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    monkeypatch.delenv("FANTASIA3D_ENV", raising=False)
    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    monkeypatch.setattr(platform, "node", lambda: "zeta-station.corp.example")
    log = environment.log_file(environment.env_folder(run.ROOT))
    log.parent.mkdir(parents=True)
    log.write_text(
        f"$ {home}/My Data/env/bin/python -m pip install -r {home}/My Film/list.txt\n"
        "Looking in indexes: https://annabel:hunter2@pypi.corp.example/simple\n"
        "ERROR: token tok-123456 refused for annabel@corp.example on Zeta-Station (192.0.2.77)\n"
        "ERROR: No matching distribution found for torch==2.13.0\n"
    )
    folder = home / "My Data" / "fantasia3d" / "runs" / "a golden unicorn"
    folder.mkdir(parents=True)
    job = {
        "prompt": "a golden unicorn for Zanzibar", "negative_prompt": "einhorn", "seed": 7,
        "preset": "draft", "guide_mesh": "/mnt/My Film/hero.obj", "guidance": "secretlab/model",
        "light": "studio", "settings": {"geometry.fine.steps": 3},
    }  # fmt: skip
    (folder / "job.json").write_text(json.dumps(job))
    error = {
        "type": "error",
        "text": "There is no noun 'zanzibar'; the unicorn stays.",
        "fix": "Say chair.",
    }
    (folder / "events.jsonl").write_text(
        '{"type": "started"}\nno json\n' + json.dumps(error) + "\n"
    )
    (folder / "log.txt").write_text(
        "a golden unicorn\nTraceback (most recent call last):\n"
        f'  File "{run.ROOT}/core/generate.py", line 3, in generate\n'
        '  File "/home/annabel/My Film/hero.py", line 3, in film\n'
        "ZeroDivisionError: the unicorn in /mnt/My Film/hero.obj is flat\n"
    )
    monkeypatch.chdir(home)  # the project's own folder may have runs in its out
    return tmp_path / "report.json"


def test_it_has_what_a_maintainer_needs(private):
    text = environment.write_report(private, run.ROOT, LINES).read_text(encoding="utf-8")
    found = json.loads(text)
    assert found["system"]["platform"] == platform.platform()
    assert [line for line in found["environment"]["packages"] if line.startswith("torch==2")]
    assert found["variables"]["OMP_NUM_THREADS"] == "3"
    assert found["variables"]["PIP_INDEX_URL"] == "set"
    assert "SERVICE_TOKEN" not in found["variables"]
    assert [line["name"] for line in found["checks"]] == ["launcher", "GPU"]
    assert "ERROR: No matching distribution found for torch==2.13.0" in found["setup_log"]
    (ran,) = found["runs"]
    assert ran["job"]["settings"] == {"geometry.fine.steps": 3}
    assert (ran["job"]["guide_mesh"], ran["job"]["light"]) == ("<file>.obj", "studio")
    assert ran["ended"] == "error"
    assert ran["failures"][0]["fix"] == "Say chair."
    assert '  File "<project>/core/generate.py", line 3, in generate' in ran["log"]
    assert [line for line in ran["log"] if line.startswith("ZeroDivisionError")]


def test_it_has_nothing_private(private):
    text = environment.write_report(private, run.ROOT, LINES).read_text(encoding="utf-8")
    assert [word for word in PLANTED if word in text.lower()] == []
    assert str(private.parent) not in text


def test_a_report_of_this_machine_names_neither_home_nor_host(tmp_path):
    text = environment.write_report(tmp_path / "r.json", run.ROOT, LINES).read_text(
        encoding="utf-8"
    )
    for name in {str(Path.home()), platform.node()} - {"/", ""}:
        # As a word of its own: a host called "vm" is also a part of llvmlite.
        assert not re.search(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", text)


def test_another_file_is_not_overwritten_and_a_report_is(private):
    for content in ('{"my": "data"}', "thesis", "[1]", ""):
        private.write_text(content)
        with pytest.raises(environment.SetupError, match="is not a report of this project"):
            environment.write_report(private, run.ROOT, LINES)
        assert private.read_text() == content
    private.unlink()
    environment.write_report(private, run.ROOT, LINES)
    environment.write_report(private, run.ROOT, LINES[:1])
    assert len(json.loads(private.read_text(encoding="utf-8"))["checks"]) == 1
    assert sorted(path.name for path in private.parent.iterdir()) == ["home", "report.json"]


def test_a_place_that_cannot_be_written_is_a_sentence(private):
    with pytest.raises(environment.SetupError, match="cannot be written"):
        environment.write_report(private / "none" / "r.json", run.ROOT, LINES)


def test_the_command_writes_it_and_states_so(private, monkeypatch, capsys):
    monkeypatch.setattr(environment, "examine", lambda root: LINES)
    assert run.main(["doctor", "--report", str(private)]) == 0
    assert str(private) in capsys.readouterr().out
    private.write_text("mine")
    assert run.main(["doctor", "--report", str(private)]) == 3
    assert "is not a report" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("error in C:\\Users\\ann b\\x.py, line 3", "error in <path>, line 3"),
        ("/usr/bin/python3 /mnt/x y/z", "/usr/bin/python3 <path>"),
        ("no file /mnt/My Film. Name another.", "no file <path>. Name another."),
        ("and/or 3/4 of it", "and/or 3/4 of it"),
    ],
)
def test_paths_go_with_their_spaces_and_the_rest_stays(tmp_path, text, kept):
    assert report.Redaction(run.ROOT, tmp_path).text(text) == kept
