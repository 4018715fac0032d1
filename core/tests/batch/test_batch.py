"""A batch: what is missing is made, once; what dies is tried again; a stop loses nothing."""

import csv
import dataclasses
import json
import os
import signal
import subprocess
import sys
import threading
import time
from functools import partial
from pathlib import Path

import pytest
from PIL import Image

from core.batch import attempt, batch, plan
from core.batch.attempt import Attempt
from core.batch.local import LocalPool
from core.batch.needs import Needs, card_of, checkpoint_memory, needs_of, places
from core.batch.options import OUT_OF_TIME
from core.batch.plan import Task, digest
from core.batch.progress_line import duration, seconds_left
from core.batch.schedule import use_smaller_parts
from core.batch.table import Row, read_table, slug
from core.command_line import main
from core.errors import UserError
from core.io.job import Job, read_events
from core.tests.runs.test_run_report import made

FAKE = (sys.executable, str(Path(__file__).parents[1].joinpath("fake_resume.py")))


@pytest.fixture
def table(tmp_path, monkeypatch):
    """Writes a table; its batch is made by the fake core."""
    monkeypatch.setattr(batch, "LocalPool", partial(LocalPool, command=FAKE))

    def write(text, name="prompts.csv"):
        (tmp_path / name).write_text(text, encoding="utf-8")
        return [str(tmp_path / name), "--out", str(tmp_path / "out")]

    return write


def report(tmp_path, name="report.csv"):
    text = (tmp_path / "out" / name).read_text(encoding="utf-8")
    return list(csv.DictReader(text.splitlines()))


def sessions(folder):
    """The step from which each session of a run went on."""
    return [event["step"] for event in read_events(folder) if event["type"] == "started"]


# The table


def test_a_row_becomes_the_command_line_that_makes_it(tmp_path):
    (tmp_path / "shape.obj").write_text("")
    (tmp_path / "t.csv").write_text(
        "\ufeffPrompt;name;seed;guide-strength;guide;geometry.fine.steps;Ignore unknown words\n"
        "a red chair;Nice one;3;0.5;shape.obj;7;yes\n"
        ";;;;;;\n"
        '"a ""tall"" mug; blue";;;;;;\n',
        encoding="utf-8",
    )
    first, second = read_table(tmp_path / "t.csv")
    assert (first.line, first.name, second.line) == (2, "Nice one", 4)
    assert first.arguments(["--seed=1"]) == [
        "generate", "--seed=1", "--seed=3", "--guide-strength=0.5",
        f"--guide={tmp_path / 'shape.obj'}", "--ignore-unknown-words",
        "--set=geometry.fine.steps=7",
        "--", "a red chair",
    ]  # fmt: skip
    assert second.arguments([]) == ["generate", "--", 'a "tall" mug; blue']


def test_a_row_with_a_mesh_is_textured(tmp_path):
    (tmp_path / "t.tsv").write_text("mesh\tprompt\nm.obj\t-rusty\n")
    (row,) = read_table(tmp_path / "t.tsv")
    assert row.arguments([]) == ["texture", "--", "m.obj", "-rusty"]


def test_a_comma_separates_nothing_in_a_table_of_tabs(tmp_path):
    (tmp_path / "t.tsv").write_text("prompt\na red, wooden chair\n")
    (row,) = read_table(tmp_path / "t.tsv")
    assert row.prompt == "a red, wooden chair"


def test_a_folder_next_to_the_table_is_no_picture_and_no_light(tmp_path):
    """``mesh`` is the mesh's own colours, also where the meshes are in a folder of that name."""
    for name in ("mesh", "studio", "model"):
        (tmp_path / name).mkdir()
    (tmp_path / "mesh" / "m.obj").write_text("")
    (tmp_path / "t.csv").write_text(
        "mesh,prompt,base_color,light,guidance\nmesh/m.obj,a chair,mesh,studio,model\n"
    )
    (row,) = read_table(tmp_path / "t.csv")
    assert row.options == {
        "mesh": str(tmp_path / "mesh" / "m.obj"), "base_color": "mesh", "light": "studio",
        "guidance": str(tmp_path / "model"),
    }  # fmt: skip


def test_a_text_file_has_a_prompt_on_each_line(tmp_path):
    (tmp_path / "t.txt").write_text("# mine\na chair, red\n\n a mug \n")
    assert [(r.line, r.prompt) for r in read_table(tmp_path / "t.txt")] == [
        (2, "a chair, red"),
        (4, "a mug"),
    ]


@pytest.mark.parametrize("mark", ["\u2028", "\v", "\x85"])
def test_a_line_break_within_a_cell_ends_no_row(tmp_path, mark):
    """Word processors write these; Python's splitlines takes them for the end of a line."""
    (tmp_path / "t.csv").write_text(f"prompt,seed\na red{mark}chair,3\n", encoding="utf-8")
    (tmp_path / "t.txt").write_text(f"a red{mark}chair\n", encoding="utf-8")
    (row,), (line,) = read_table(tmp_path / "t.csv"), read_table(tmp_path / "t.txt")
    assert (row.line, row.prompt, row.options) == (2, f"a red{mark}chair", {"seed": "3"})
    assert (line.line, line.prompt) == (1, f"a red{mark}chair")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no column prompt"),
        ("prompt\n", "holds no prompt"),
        ("prompt,sede\na,3\n", "Did you mean seed?"),
        ("prompt,seed,seed\na,3,4\n", "two columns seed"),
        ("seed\n3\n", "no column prompt"),
        ("prompt,seed\na chair, red,3\n", "Line 2 of .* has 3 cells, its header 2"),
        ("prompt,\na,b\n", "without a column's name"),
        ('prompt\n"a\n', "line 2 of .* is not CSV"),
    ],
)
def test_a_wrong_table_is_refused_with_its_line(tmp_path, text, words):
    (tmp_path / "t.csv").write_text(text)
    with pytest.raises(UserError, match=words):
        read_table(tmp_path / "t.csv")


def test_a_table_that_is_no_text_is_refused(tmp_path):
    (tmp_path / "t.csv").write_bytes(b"prompt\n\xff\xfe\n")
    with pytest.raises(UserError, match="is not UTF-8"):
        read_table(tmp_path / "t.csv")
    with pytest.raises(UserError, match="is a folder"):
        read_table(tmp_path)


def test_a_slug_is_letters_and_digits():
    assert slug("A red/../chair  Ä!") == "a-red-chair-ä"
    assert slug("!") == "asset"


# The hash


@pytest.mark.parametrize(
    "change",
    [
        {"prompt": "a mug"}, {"seed": 1}, {"light": "sky"}, {"size_m": 2.0}, {"max_faces": 500},
        {"settings": {"geometry.fine.steps": 3}}, {"ignore_unknown_words": True},
    ],
)  # fmt: skip
def test_what_decides_the_asset_is_in_its_hash(change):
    job = Job(prompt="a chair")
    assert digest(dataclasses.replace(job, **change)) != digest(job)


def test_what_does_not_decide_it_is_not():
    job = Job(prompt="a chair")
    same = {"device": "cpu", "settings": {"geometry.views_at_once": 1}}
    assert digest(dataclasses.replace(job, **same)) == digest(job)
    steps = {"settings": {"geometry.fine.steps": "3"}}
    numbers = {"settings": {"geometry.fine.steps": 3}}
    assert digest(dataclasses.replace(job, **steps)) == digest(dataclasses.replace(job, **numbers))


def test_a_file_counts_by_what_it_holds(tmp_path):
    files = [tmp_path / name for name in ("a.obj", "b.obj", "c.obj")]
    jobs = [Job(prompt="x", command="texture", mesh=str(file)) for file in files]
    missing = digest(jobs[0])
    for file, text in zip(files, ("v 0 0 0", "v 0 0 0", "v 1 0 0"), strict=True):
        file.write_text(text)
    a, b, c = map(digest, jobs)
    assert missing != a == b != c
    files[0].write_text("v 2 0 0 # written again while this process runs")
    assert digest(jobs[0]) not in (missing, a, c)


def test_a_folder_with_the_name_of_a_light_counts_not(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    before = digest(Job(prompt="a chair"))
    (tmp_path / "studio").mkdir()
    assert digest(Job(prompt="a chair")) == before


def test_new_weights_are_another_asset(monkeypatch):
    before = digest(Job(prompt="a chair"))
    monkeypatch.setattr(plan, "_builtin_weights", lambda: {"shape.safetensors": "other"})
    assert digest(Job(prompt="a chair")) != before


# The batch


def test_a_second_call_makes_only_what_is_missing(table, tmp_path, capsys):
    argv = table("prompt,name\na chair,one\na chair,two\na mug,\n")
    assert main(["batch", *argv]) == 0
    rows = report(tmp_path)
    assert [(r["name"], r["state"], r["attempts"]) for r in rows[:2]] == [
        ("one", "done", "1"),
        ("two", "done", "1"),
    ]
    assert rows[0]["folder"] == rows[1]["folder"] and rows[0]["folder"].startswith("one-")
    runs = [path.parent for path in (tmp_path / "out").glob("*/job.json")]
    assert len(runs) == 2
    assert not list((tmp_path / "out").glob("*/checkpoint/*.safetensors"))
    before = {run: sessions(run) for run in runs}
    # Another name, another order: the folders are found by the hash.
    argv = table("prompt,name\na mug,\na chair,three\na table,\n")
    assert main(["batch", *argv]) == 0
    assert {run: sessions(run) for run in runs} == before
    assert [r["attempts"] for r in report(tmp_path)] == ["0", "0", "1"]
    assert "3 of 3 done, 0 running, 0 failed" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["report.csv", "contact_sheet.html"])
def test_a_file_of_the_users_in_its_folder_is_never_replaced(table, tmp_path, capsys, name):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / name).write_text("precious")
    assert main(["batch", *table("a chair\n", "t.txt")]) == 2
    assert f"{name} that does not belong to a batch" in capsys.readouterr().err
    assert [path.name for path in (tmp_path / "out").iterdir()] == [name]
    assert (tmp_path / "out" / name).read_text() == "precious"


def test_what_fails_has_a_code_of_its_own_and_the_rest_is_made(table, tmp_path, capsys):
    argv = table("prompt,seed\nan unknown,\na chair,x\na mug,\n,\n")
    assert main(["batch", *argv, "--at-once", "2"]) == 6
    unknown, chair, mug = report(tmp_path)
    assert (unknown["state"], unknown["attempts"]) == ("failed", "1")  # not tried again
    assert unknown["text"] == "There is no noun 'unknown'. Say chair."
    assert chair["state"] == "failed" and "Line 3" in chair["text"] and "'x'" in chair["text"]
    assert mug["state"] == "done"
    output = capsys.readouterr().err
    assert "error: 2 of 3 assets were not made." in output and "Traceback" not in output
    assert "1 of 3 done, 0 running, 2 failed" in output


def test_what_dies_goes_on_from_its_checkpoint(table, tmp_path):
    assert main(["batch", *table("a chair that dies\n", "t.txt")]) == 0
    (row,) = report(tmp_path)
    assert (row["state"], row["attempts"]) == ("done", "2")
    assert sessions(tmp_path / "out" / row["folder"]) == [0, 2]


def test_no_room_is_reported_once_and_waited_for(table, tmp_path, monkeypatch, capsys):
    """A cluster's nodes may all be too small, until one joins."""

    class Small(LocalPool):
        waits = 0
        places = property(lambda self: int(self.waits > 1), lambda self, _: None)

        def wait(self, seconds):
            self.waits += 1
            return super().wait(0.01)

    monkeypatch.setattr(batch, "LocalPool", partial(Small, command=FAKE))
    assert main(["batch", *table("a chair\n", "t.txt")]) == 0
    output = capsys.readouterr().err
    assert output.count("No node has room for an asset (1 core, 1.5 GB of memory); waiting") == 1


def test_retries_end(table, tmp_path):
    argv = table("a chair that dies\n", "t.txt")
    assert main(["batch", *argv, "--retries", "0"]) == 6
    (row,) = report(tmp_path)
    assert row["state"] == "failed" and "signal 9" in row["text"]


def test_out_of_memory_is_tried_again_with_smaller_parts(table, tmp_path):
    argv = table("prompt\na large chair\n")
    assert main(["batch", *argv, "--retries", "9"]) == 0
    (row,) = report(tmp_path)
    job = json.loads((tmp_path / "out" / row["folder"] / "job.json").read_text())
    assert job["settings"]["geometry.views_at_once"] == 1
    assert int(row["attempts"]) > 2
    # Its name is still that of the row: a second call finds it.
    assert main(["batch", *argv]) == 0
    assert report(tmp_path)[0]["attempts"] == "0"


def test_a_later_call_states_with_how_much_memory_and_where(table, tmp_path):
    """The names of the folders do not show it, as the result is the same."""
    argv = table("a chair that dies\n", "t.txt")
    assert main(["batch", *argv, "--retries", "0"]) == 6
    (row,) = report(tmp_path)
    smaller = ["--set", "geometry.views_at_once=1", "--device", "cpu"]
    assert main(["batch", *argv, "--retries", "0", *smaller]) == 0
    job = Job.from_json((tmp_path / "out" / row["folder"] / "job.json").read_text())
    assert job.device == "cpu" and job.settings["geometry.views_at_once"] == 1
    more = ["--set", "geometry.views_at_once=8"]  # as a call from before the parts were halved
    (tmp_path / "out" / row["folder"] / "asset" / "asset.json").unlink()
    assert main(["batch", *argv, *more]) == 0
    job = Job.from_json((tmp_path / "out" / row["folder"] / "job.json").read_text())
    assert job.device == "auto" and job.settings["geometry.views_at_once"] == 1


MVDREAM = Path(__file__).parents[2] / "guidance/stable_diffusion/configurations/mvdream"


def test_smaller_parts_keep_views_together_that_a_checkpoint_predicts_together(tmp_path):
    job = Job(prompt="a chair", preset="paper", guidance=str(MVDREAM), settings=parts(24))
    (tmp_path / "job.json").write_text(job.to_json())
    for fewer in (12, 4):
        assert use_smaller_parts(tmp_path)
        assert Job.from_json((tmp_path / "job.json").read_text()).settings == parts(fewer)
    before = (tmp_path / "job.json").read_bytes()
    assert not use_smaller_parts(tmp_path)
    assert (tmp_path / "job.json").read_bytes() == before


def test_smaller_parts_of_a_checkpoint_that_is_elsewhere_are_groups_as_long_as_they_can(tmp_path):
    job = Job(prompt="a chair", preset="paper", guidance="/nowhere/x", settings=parts(24))
    (tmp_path / "job.json").write_text(job.to_json())
    seen = []
    while use_smaller_parts(tmp_path):
        settings = Job.from_json((tmp_path / "job.json").read_text()).settings
        seen.append(settings["geometry.views_at_once"])
    assert seen == [12, 4, 2, 1]


def test_a_batch_has_the_places_of_the_cards_that_its_rows_name():
    named = [needs_of(Job(prompt="x", device=f"cuda:{k}"), True) for k in (0, 1, 1)]
    assert batch._most(named).cards == {0, 1}
    anywhere = needs_of(Job(prompt="x", device="cuda"), True)
    assert batch._most([*named, anywhere]).cards == frozenset()


def test_single_views_are_the_smallest_parts(tmp_path):
    (tmp_path / "job.json").write_text(Job(prompt="a chair", settings=parts(3)).to_json())
    assert [use_smaller_parts(tmp_path) for _ in range(2)] == [True, False]
    assert Job.from_json((tmp_path / "job.json").read_text()).settings == parts(1)


def parts(count):
    stages = ("geometry", "appearance")
    views = {f"{stage}.views": 24 for stage in stages} if count >= 4 else {}
    return views | {f"{stage}.views_at_once": count for stage in stages}


def test_a_timeout_leaves_the_run_resumable(table, tmp_path, monkeypatch):
    argv = table("an endless chair\n", "t.txt")
    assert main(["batch", *argv, "--timeout", "0.6"]) == 6
    (row,) = report(tmp_path)
    assert (row["state"], row["attempts"]) == ("unfinished", "1")
    assert "--timeout 0.6" in row["text"]
    main(["batch", *argv, "--timeout", "0.3"])
    first, second = sessions(tmp_path / "out" / row["folder"])
    assert first == 0 < second


def test_one_that_does_not_answer_is_ended_by_force(tmp_path, monkeypatch):
    monkeypatch.setattr(attempt, "GRACE", 0.1)
    (tmp_path / "job.json").write_text(Job(prompt="an endless deaf chair").to_json())
    running = Attempt(tmp_path, FAKE, timeout=0.5)
    end = wait_for(running.poll)
    assert end.code == OUT_OF_TIME


def test_the_log_is_utf_8_whatever_the_terminal_takes(tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONIOENCODING", "latin-1")
    running = Attempt(tmp_path, [sys.executable, "-c", "print('a chair of 木')"])
    assert wait_for(running.poll).code == 0
    assert (tmp_path / "log.txt").read_text(encoding="utf-8").strip() == "a chair of 木"


def wait_for(found, seconds=60):
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if result := found():
            return result
        time.sleep(0.02)
    raise AssertionError("it did not happen")


def test_ctrl_c_leaves_all_resumable(table, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("FAKE_STEPS", "60")
    argv = table("a chair\na mug\na table\n", "t.txt")

    def interrupt():
        wait_for(lambda: len(list((tmp_path / "out").glob("*/checkpoint/*"))) >= 2)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    assert main(["batch", *argv, "--at-once", "2"]) == 130
    output = capsys.readouterr().err
    assert output.count("Stopping after the present step") == 1
    assert "0 of 3 are done. The same command continues it" in output
    assert [r["state"] for r in report(tmp_path)] == ["unfinished", "unfinished", "missing"]
    assert main(["batch", *argv, "--at-once", "2"]) == 0
    starts = [sessions(tmp_path / "out" / r["folder"]) for r in report(tmp_path)]
    assert [s[0] for s in starts] == [0, 0, 0] and all(s[1] > 0 for s in starts[:2])


def test_one_ctrl_c_waits_for_a_step_longer_than_a_second(table, tmp_path, monkeypatch, capsys):
    """Other commands are interrupted again after a second; a user's own alone ends this at once."""
    monkeypatch.setenv("FAKE_STEPS", "60")
    monkeypatch.setenv("FAKE_PAUSE", "2")
    argv = table("a chair\n", "t.txt")

    def interrupt():
        wait_for(lambda: list((tmp_path / "out").glob("*/events.jsonl")))
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    assert main(["batch", *argv]) == 130
    assert "0 of 1 are done. The same command continues it" in capsys.readouterr().err
    (row,) = report(tmp_path)
    assert read_events(tmp_path / "out" / row["folder"])[-1]["type"] == "cancelled"
    assert (tmp_path / "out" / "contact_sheet.html").exists()


def test_a_process_ends_with_the_one_that_started_it(tmp_path):
    """A survivor of a killed batch, or of a cluster's dead node, would go on writing."""
    (tmp_path / "job.json").write_text(Job(prompt="an endless chair").to_json())
    code = (
        "import sys, time; from pathlib import Path; from core.batch.attempt import Attempt\n"
        f"Attempt(Path(sys.argv[1]), [*{FAKE!r}, '--end-with-stdin']); time.sleep(60)"
    )
    starter = subprocess.Popen([sys.executable, "-c", code, str(tmp_path)], cwd=attempt.ROOT)
    events = wait_for(lambda: (tmp_path / "events.jsonl").exists() and read_events(tmp_path))
    pid = events[0]["pid"]
    starter.kill()
    starter.wait()
    wait_for(lambda: not Path(f"/proc/{pid}/cmdline").exists() or _is_gone(pid))


def _is_gone(pid):
    state = Path(f"/proc/{pid}/stat")
    return not state.exists() or state.read_text().rpartition(")")[2].split()[0] == "Z"


def test_parts_of_a_table_are_made_apart_and_reported_together(table, tmp_path):
    argv = table("a chair\na mug\na table\n", "t.txt")
    for part, rows in (("1/2", 2), ("2/2", 1)):
        assert main(["batch", *argv, "--shard", part]) == 0
        assert len(report(tmp_path, f"report-{part.replace('/', '-of-')}.csv")) == rows
    assert main(["batch", *argv]) == 0
    assert [r["attempts"] for r in report(tmp_path)] == ["0", "0", "0"]


def test_two_calls_at_once_do_not_mix(table, tmp_path, capsys):
    argv = table("a chair\n", "t.txt")
    (tmp_path / "out").mkdir()
    with batch.run_lock(tmp_path / "out", "batch.lock"):
        assert main(["batch", *argv]) == 2
    assert "Another process works on" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (["--shard", "9/8"], "is not a part"),
        (["--shard", "x"], "is not a part"),
        (["--retries", "-1"], "0 or more"),
        (["--timeout", "0"], "more than 0"),
        (["--timeout", "nan"], "more than 0"),
        (["--at-once", "0"], "1 or more"),
        (["--sede", "3"], "--seed"),
    ],
)
def test_a_wrong_option_is_one_sentence(table, more, words, capsys):
    assert main(["batch", *table("a chair\n", "t.txt"), *more]) == 2
    output = capsys.readouterr().err
    assert words in output and output.count("\n") == 1


# The page


def test_the_sheet_shows_each_asset_and_its_viewer(table, tmp_path, monkeypatch):
    asset = made(tmp_path / "real").asset
    Image.new("RGB", (32, 32), "red").save(asset / "preview.png")
    monkeypatch.setenv("FAKE_ASSET", str(asset))
    argv = table("prompt,name\na <b>chair</b>,@end@\na mug,\nan unknown,\na mug,again\n")
    assert main(["batch", *argv]) == 6
    out = tmp_path / "out"
    page = (out / "contact_sheet.html").read_text(encoding="utf-8")
    assert "a &lt;b&gt;chair&lt;/b&gt;" in page and "<b>chair</b>" not in page
    assert "<b>@end@</b>" in page and "3 done, 1 failed" in page
    assert page.count("<figure>") == 3 and page.count('src="data:image/jpeg') == 2
    assert "closed, 1 component, 100 faces, 1.5 s" in page
    assert "There is no noun &#x27;unknown&#x27;" in page
    folders = {r["folder"] for r in report(tmp_path) if r["state"] == "done"}
    assert {path.stem for path in (out / "contact_sheet").iterdir()} == folders


def test_a_broken_asset_does_not_hide_the_others(table, tmp_path):
    assert main(["batch", *table("a chair\n", "t.txt")]) == 0  # the fake's has no picture
    assert "is not a picture" in (tmp_path / "out" / "contact_sheet.html").read_text()


def test_an_asset_that_cannot_be_read_stops_no_other(table, tmp_path):
    argv = table("a chair\n", "t.txt")
    assert main(["batch", *argv]) == 0
    (row,) = report(tmp_path)
    (tmp_path / "out" / row["folder"] / "asset" / "asset.json").write_text("")
    assert main(["batch", *table("a chair\na mug\n", "t.txt")]) == 6
    broken, made_now = report(tmp_path)
    assert (broken["state"], made_now["state"]) == ("failed", "done")
    assert "asset.json is not JSON" in broken["text"] and "Remove its folder" in broken["text"]


def test_a_job_that_cannot_be_read_stops_no_other(table, tmp_path):
    argv = table("a chair that dies\n", "t.txt")
    assert main(["batch", *argv, "--retries", "0"]) == 6
    (row,) = report(tmp_path)
    (tmp_path / "out" / row["folder"] / "job.json").write_text("")
    more = table("a chair that dies\na mug\n", "t.txt")
    assert main(["batch", *more, "--retries", "0"]) == 6
    assert [row["state"] for row in report(tmp_path)] == ["failed", "done"]


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have no such names")
def test_a_table_whose_name_is_no_text_has_a_sheet(table, tmp_path):
    argv = table("a chair\n", "t.txt")
    odd = tmp_path / os.fsdecode(b"caf\xe9.txt")
    Path(argv[0]).rename(odd)
    assert main(["batch", str(odd), *argv[1:]]) == 0
    assert "caf?: 1 assets" in (tmp_path / "out" / "contact_sheet.html").read_text("utf-8")


# The numbers


def test_the_time_left_is_the_mean_of_what_was_made():
    assert seconds_left([], 5, [1.0], 2) is None
    assert seconds_left([10.0, 20.0], 4, [5.0, 15.0], 2) == (4 * 15 + 10) / 2
    assert seconds_left([10.0], 0, [4.0], 8) == 6.0  # one is left: more places are no help
    assert seconds_left([10.0], 0, [30.0], 1) == 0.0


def test_durations_are_short():
    assert [duration(s) for s in (5, 150, 7200, 200_000)] == ["5 s", "2 min", "2 h", "2 d"]


def test_places_follow_cores_and_memory(monkeypatch):
    monkeypatch.setattr("core.batch.needs.cores", lambda: 8)
    memory = type("M", (), {"available": 10 << 30})
    monkeypatch.setattr("core.batch.needs.psutil.virtual_memory", lambda: memory)
    assert places(Needs(1, 1 << 30, 0.0), None) == 8
    assert places(Needs(1, 4 << 30, 0.0), None) == 2
    assert places(Needs(1, 1 << 40, 0.0), None) == 1
    assert places(Needs(1, 1 << 40, 0.0), 3) == 3
    monkeypatch.setattr("core.batch.needs.gpus", lambda: 1)
    assert places(Needs(1, 1 << 30, 0.25), None) == 4


def test_a_checkpoint_takes_its_weights_and_more(tmp_path):
    (tmp_path / "unet").mkdir()
    (tmp_path / "unet" / "x.safetensors").write_bytes(bytes(1000))
    assert checkpoint_memory(tmp_path) - checkpoint_memory(tmp_path / "unet") == 2000
    job = Job(prompt="x", guidance=str(tmp_path))
    assert needs_of(job, has_gpu=True).gpus == 1 and needs_of(job, has_gpu=False).gpus == 0


def test_a_card_that_is_named_is_a_gpu_and_no_more_than_one(monkeypatch):
    monkeypatch.setattr("core.batch.needs.cores", lambda: 8)
    memory = type("M", (), {"available": 100 << 30})
    monkeypatch.setattr("core.batch.needs.psutil.virtual_memory", lambda: memory)
    monkeypatch.setattr("core.batch.needs.gpus", lambda: 2)
    named, any_card = (needs_of(Job(prompt="x", device=d), True) for d in ("cuda:1", "cuda"))
    assert named.gpus == any_card.gpus == 0.25
    assert (places(named, None), places(any_card, None)) == (4, 8)
    tasks = [Task(Row(1, "x"), job=Job(prompt="x", device=d)) for d in ("cuda", "cuda:1", "cpu")]
    assert batch._needs(tasks[1:], True) == named
    assert batch._needs(tasks, True) == batch._needs(tasks[:1], True) == any_card
    found = [card_of(d) for d in ("cuda:1", "cuda:0", "cuda", "auto", "cpu", "cuda:", "cuda:x")]
    assert found == [1, 0, None, None, None, None, None]


@pytest.mark.parametrize(
    ("inherited", "devices", "seen"),
    [
        (None, ["cuda"] * 3, ["0", "1", "0"]),
        ("2,3", ["cuda"] * 3, ["2", "3", "2"]),
        (" GPU-5e, MIG-7f ", ["auto", "auto"], ["GPU-5e", "MIG-7f"]),
        ("2,3", ["cuda:0", "cuda", "cuda:1"], ["2,3", "3", "2,3"]),  # the process counts by itself
    ],
)
def test_a_process_gets_one_of_the_gpus_that_the_batch_was_given(
    inherited, devices, seen, monkeypatch
):
    found = []
    monkeypatch.setattr("core.batch.local.gpus", lambda: 2)
    monkeypatch.setattr("core.batch.local.Attempt", lambda *given: found.append(given[-1]))
    monkeypatch.delenv("CUDA_VISIBLE_DEVICES", raising=False)
    if inherited:
        monkeypatch.setenv("CUDA_VISIBLE_DEVICES", inherited)
    pool = LocalPool(Needs(1, 1 << 30, 0.25), at_once=4)
    for device in devices:
        pool.start(Task(Row(1, "x"), Path("run"), Job(prompt="x", device=device)))
    key = "CUDA_VISIBLE_DEVICES"
    assert [environ.get(key, os.environ.get(key)) for environ in found] == seen
