"""job.json and events.jsonl: what is written is read back, what is wrong is named."""

import json

import pytest

from core.errors import UserError
from core.io.job import MAX_PROMPT, EventWriter, Job, read_events


def test_a_job_survives_its_file():
    job = Job(prompt="ein Stuhl – 椅子 🪑", seed=2**62, settings={"geometry.views": 4})
    assert Job.from_json(job.to_json()) == job


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"sede": 1}, "Did you mean 'seed'"),
        ({"version": 99}, "version 99"),
        ({"prompt": "  "}, "prompt is empty"),
        ({"prompt": "x" * (MAX_PROMPT + 1)}, f"{MAX_PROMPT + 1} characters"),
        ({"negative_prompt": "x" * 5000}, "negative prompt has 5000"),
        ({"command": "paint"}, "generate or texture"),
        ({"command": "texture"}, "no mesh to texture"),
        ({"seed": -1}, "seed is -1"),
        ({"seed": "1"}, "seed is '1'"),
        ({"seed": True}, "seed is True"),
        ({"guide_strength": 2.0}, "0 to 1"),
        ({"texture_size": 1 << 20}, "64 to 8192"),
        ({"max_faces": 3}, "100 faces"),
        ({"settings": []}, "settings is"),
    ],
)
def test_a_wrong_job_is_named(change, words):
    data = json.loads(Job(prompt="a chair").to_json()) | change
    with pytest.raises(UserError, match=words):
        Job.from_json(json.dumps(data))


@pytest.mark.parametrize("text", ["", "{", "[]", "null"])
def test_a_broken_job_file_is_a_sentence(text):
    with pytest.raises(UserError, match="job.json"):
        Job.from_json(text)


def test_a_whole_number_is_a_strength_too():
    assert Job(prompt="a", guide_strength=1).guide_strength == 1


def test_a_half_written_event_waits(tmp_path):
    writer = EventWriter(tmp_path)
    writer.write("started", pid=1, text=None)
    with (tmp_path / "events.jsonl").open("a") as file:
        file.write('{"type": "progr')
    events = read_events(tmp_path)
    assert [(e["type"], e["pid"]) for e in events] == [("started", 1)]
    assert "text" not in events[0]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[" * 100_000 + "]" * 100_000, "nested too deeply"),
        ('{"version": 1, "prompt": "a chair", "seed": ' + "9" * 5000 + "}", "is not JSON"),
        ('{"version": 1, "prompt": "a chair", "guide_strength": NaN}', "NaN is not a number"),
        (
            '{"version": 1, "prompt": "a chair", "seed": 1' + "0" * 400 + "}",
            "a number of 401 digits",
        ),
        ('{"version": 1, "prompt": "a \\ud800"}', "half of a character"),
        ('["prompt"]', "holds no object"),
    ],
)
def test_a_strange_job_is_one_sentence(text, words):
    with pytest.raises(UserError, match=words) as error:
        Job.from_json(text)
    assert error.value.fix
