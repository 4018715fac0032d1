"""The run folder: checkpoints that bring a training back exactly, and the wish to cancel."""

import json

import pytest
import torch

from core.errors import Cancelled, NoSurfaceError, UserError
from core.io.job import Job, read_events
from core.io.run_folder import RunFolder, Training
from core.stages.guard import MAX_RECOVERIES, Guard, healthy_gradients


def make_run(path):
    return RunFolder.create(path / "Läufe" / "ein Stuhl", Job(prompt="a chair"))


def toy(run, steps, stop=None):
    """A small noisy training; its final weights."""
    generator = torch.Generator().manual_seed(0)
    net = torch.nn.Linear(3, 1)
    with torch.no_grad():
        net.weight.fill_(0.5)
        net.bias.zero_()
    optimizer = torch.optim.AdamW(net.parameters(), lr=0.1)
    training = Training(run, "toy", net, optimizer, generator)
    training.resume()
    for step in run.steps("toy", training.step, steps):
        optimizer.zero_grad()
        net(torch.randn(5, 3, generator=generator)).square().mean().backward()
        optimizer.step()
        training.checkpoint(step.index + 1, force=step.index + 1 == stop)
        if step.index + 1 == stop:
            return None
    return net.weight.detach().clone()


def test_a_resumed_training_ends_where_an_unbroken_one_does(tmp_path):
    whole = toy(make_run(tmp_path / "a"), 20)
    run = make_run(tmp_path / "b")
    toy(run, 20, stop=7)
    again = RunFolder.open(run.path)
    assert torch.equal(toy(again, 20), whole)
    assert again.timings["toy"] > 0


def test_progress_names_step_and_loss(tmp_path):
    run = make_run(tmp_path)
    for step in run.steps("toy", 3, 5):
        step.loss = 2.0
    last = [e for e in read_events(run.path) if e["type"] == "progress"][-1]
    assert (last["stage"], last["step"], last["steps"], last["loss"]) == ("toy", 5, 5, 2.0)
    assert last["seconds_left"] == 0


def test_cancel_by_file_and_by_signal(tmp_path):
    run = make_run(tmp_path)
    run.check_cancelled()
    run.interrupt()
    with pytest.raises(Cancelled, match="resume"):
        run.check_cancelled()
    other = RunFolder.open(run.path)
    other.check_cancelled()
    (run.path / "cancel").touch()
    with pytest.raises(Cancelled) as caught:
        other.check_cancelled()
    assert caught.value.status == 130


def test_a_folder_with_a_run_is_not_overwritten(tmp_path):
    run = make_run(tmp_path)
    with pytest.raises(UserError, match="holds a run already.*resume"):
        RunFolder.create(run.path, Job(prompt="a cup"))
    assert run.job.prompt == "a chair"


def test_a_run_starts_in_no_folder_of_the_users(tmp_path):
    (tmp_path / "asset").mkdir()
    (tmp_path / "asset" / "precious.txt").write_text("mine")
    with pytest.raises(UserError, match="not empty: it holds asset"):
        RunFolder.create(tmp_path, Job(prompt="a chair"))
    assert [path.name for path in tmp_path.rglob("*")] == ["asset", "precious.txt"]


def test_a_run_starts_in_an_empty_folder(tmp_path):
    (tmp_path / ".DS_Store").touch()
    assert RunFolder.create(tmp_path, Job(prompt="a chair")).job.prompt == "a chair"


def test_a_folder_below_a_file_is_a_sentence(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(UserError, match="can't be written"):
        RunFolder.create(tmp_path / "file" / "run", Job(prompt="a chair"))


def test_a_folder_without_a_job_is_no_run(tmp_path):
    with pytest.raises(UserError, match="no run folder"):
        RunFolder.open(tmp_path)


def test_a_broken_checkpoint_names_its_file(tmp_path):
    run = make_run(tmp_path)
    run.save("toy", {"x": torch.ones(3)}, {"step": 1})
    path = run.path / "checkpoint" / "toy.safetensors"
    path.write_bytes(path.read_bytes()[:-4])
    with pytest.raises(UserError, match=r"toy\.safetensors is broken"):
        run.load("toy")


def test_no_file_of_a_save_is_left_aside(tmp_path):
    run = make_run(tmp_path)
    run.save("toy", {"x": torch.ones(3)}, {})
    assert [p.name for p in (run.path / "checkpoint").iterdir()] == ["toy.safetensors"]
    json.loads((run.path / "job.json").read_text(encoding="utf-8"))


def test_the_guard_goes_back_to_health_and_gives_up_in_the_end(tmp_path):
    net = torch.nn.Linear(2, 1)
    good = net.weight.detach().clone()
    optimizer = torch.optim.AdamW(net.parameters())
    training = Training(make_run(tmp_path), "geometry", net, optimizer, torch.Generator())
    guard = Guard(training)
    for _ in range(MAX_RECOVERIES):
        with torch.no_grad():
            net.weight.fill_(torch.nan)
        guard.recover("The surface had nearly vanished")
        assert torch.equal(net.weight, good)
    assert guard.rate == 0.5**MAX_RECOVERIES
    with pytest.raises(NoSurfaceError) as caught:
        guard.recover("The surface had nearly vanished")
    assert caught.value.status == 5
    warnings = [e for e in read_events(training.run.path) if e["type"] == "warning"]
    assert len(warnings) == MAX_RECOVERIES
    assert "went back to step 0" in warnings[0]["text"]


def test_a_gradient_that_is_not_finite_is_seen():
    net = torch.nn.Linear(2, 1)
    assert healthy_gradients(net)
    net.weight.grad = torch.tensor([[1.0, torch.inf]])
    assert not healthy_gradients(net)
