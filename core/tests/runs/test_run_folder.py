"""The run folder: checkpoints that bring a training back exactly, and the request to cancel."""

import json

import pytest
import torch

from core.errors import Cancelled, NoSurfaceError, UserError
from core.io.job import Job, read_events
from core.io.progress import Progress, TimeLeft
from core.io.run_folder import RunFolder
from core.stages.guard import MAX_RECOVERIES, WINDOW, Guard, healthy_gradients
from core.stages.state import Training


def make_run(path):
    return RunFolder.create(path / "Läufe" / "ein Stuhl", Job(prompt="a chair"))


def toy(run, steps, stop=None):
    """A small noisy training; its final weights."""
    generator = torch.Generator().manual_seed(0)
    net = torch.nn.Linear(3, 1)
    with torch.no_grad():
        net.weight.fill_(0.5)
        net.bias.zero_()
    training = Training("toy", net, generator, run)
    training.set_learning_rate(0.1)
    training.resume()
    for step in Progress(run).steps("toy", training.step, [steps]):
        training.optimizer.zero_grad()
        net(torch.randn(5, 3, generator=generator)).square().mean().backward()
        training.optimizer.step()
        training.step = step.at + 1
        if training.step == stop:
            training.save()
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
    for step in Progress(run).steps("toy", 3, [5]):
        step.loss = 2.0
    last = [e for e in read_events(run.path) if e["type"] == "progress"][-1]
    assert (last["stage"], last["step"], last["steps"], last["loss"]) == ("toy", 5, 5, 2.0)
    assert last["seconds_left"] == 0


def test_phases_follow_one_another_and_empty_ones_are_left_out(tmp_path):
    steps = list(Progress(make_run(tmp_path)).steps("toy", 1, [2, 0, 3]))
    assert [(step.phase, step.index, step.at) for step in steps] == [
        (0, 1, 1),
        (2, 0, 2),
        (2, 1, 3),
        (2, 2, 4),
    ]
    assert [step.last for step in steps] == [False] * 3 + [True]


def test_what_compiles_does_not_count_for_the_time_left():
    """7 s for the first step of 350 were once "2,354 s left" of a stage of 74."""
    clock = TimeLeft([3, 10])
    clock.add(0, 7.0)
    assert clock.after(0, 0) is None
    clock.add(0, 0.5)
    assert clock.after(0, 1) == pytest.approx(11 * 0.5)
    clock.add(0, 0.5)
    clock.add(1, 4.0)  # the next phase compiles, too
    assert clock.after(1, 0) == pytest.approx(9 * 0.5)
    clock.add(1, 2.0)  # and is slower
    assert clock.after(1, 1) == pytest.approx(8 * 2.0)
    assert clock.after(1, 9) == 0


def test_a_resumed_stage_measures_again():
    clock = TimeLeft([3, 10])
    clock.add(1, 5.0)
    assert clock.after(1, 4) is None
    clock.add(1, 1.0)
    assert clock.after(1, 5) == pytest.approx(4.0)


def test_a_long_run_reports_less_and_less_often(tmp_path, monkeypatch):
    """An hour of steps of a second: every fifth of a second would be all of them."""
    now = iter(range(10_000))
    monkeypatch.setattr("core.io.progress.time.perf_counter", lambda: float(next(now)))
    run = make_run(tmp_path)
    progress = Progress(run)
    for step in range(3600):
        progress.advance("fit", step + 1, 3600)
    events = read_events(run.path)
    assert 1000 < len(events) < 2400
    assert (events[0]["step"], events[-1]["step"]) == (1, 3600)


def test_cancel_by_file_and_by_signal(tmp_path):
    run = make_run(tmp_path)
    progress = Progress(run)
    progress.check_cancelled()
    progress.interrupt()
    with pytest.raises(Cancelled, match="resume"):
        progress.check_cancelled()
    other = Progress(RunFolder.open(run.path))
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
    with pytest.raises(UserError, match="is not a run folder"):
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


def guarded(tmp_path):
    training = Training("geometry", torch.nn.Linear(2, 1), torch.Generator(), make_run(tmp_path))
    return training, Guard(training, Progress(training.run))


def test_the_guard_goes_back_to_health_and_gives_up_in_the_end(tmp_path):
    training, guard = guarded(tmp_path)
    net = training.module
    good = net.weight.detach().clone()
    for _ in range(MAX_RECOVERIES):
        with torch.no_grad():
            net.weight.fill_(torch.nan)
        guard.recover("The surface had nearly vanished", 0, "coarse")
        assert torch.equal(net.weight, good)
    assert guard.rate(0) == 0.5**MAX_RECOVERIES
    with pytest.raises(NoSurfaceError, match=r"geometry\.coarse\.guidance_scale") as caught:
        guard.recover("The surface had nearly vanished", 0, "coarse")
    assert caught.value.status == 5
    warnings = [e for e in read_events(training.run.path) if e["type"] == "warning"]
    assert len(warnings) == MAX_RECOVERIES
    assert "went back to step 0" in warnings[0]["text"]


def test_a_resumed_run_goes_back_to_the_same_state(tmp_path):
    """A state of the resumed step's instead once made another asset, or none."""
    training, guard = guarded(tmp_path)
    good = training.module.weight.detach().clone()
    with torch.no_grad():
        training.module.weight.fill_(7.0)
    guard.remember(3)  # no snapshot
    training.step = 4
    training.save()
    other = Training("geometry", torch.nn.Linear(2, 1), torch.Generator(), training.run)
    other.resume()
    assert torch.equal(other.module.weight, training.module.weight)
    Guard(other, Progress(other.run)).recover("The surface had nearly vanished", 4, "coarse")
    assert torch.equal(other.module.weight, good)
    assert "went back to step 0" in read_events(training.run.path)[-1]["text"]


def test_recoveries_long_ago_are_over_and_the_rate_comes_back(tmp_path):
    """Six hiccups in 3,000 steps are no reason to end a run, nor to learn at a 32nd for good."""
    training, guard = guarded(tmp_path)
    for step in range(0, 3000, 500):
        guard.recover("The gradient was not finite", step, "coarse")
        assert guard.rate(step + 1) == 0.5
    assert guard.rate(2500 + WINDOW - 1) == 0.5
    assert guard.rate(2500 + WINDOW) == 1
    training.save()
    other = Training("geometry", torch.nn.Linear(2, 1), torch.Generator(), training.run)
    other.resume()  # a resumed run counts on
    assert Guard(other, Progress(other.run)).rate(2501) == 0.5


def test_what_is_kept_for_one_round_is_not_anothers(tmp_path):
    """Going back may put an earlier round's pictures back: the present one then makes its own."""
    training, _ = guarded(tmp_path)
    training.keep("grow 1", {"z": torch.ones(2)})
    state = training.state()
    training.keep("refine 0", {"z": torch.zeros(2), "sdf": torch.zeros(3)})
    assert set(training.kept("refine 0")) == {"z", "sdf"}
    training.set_state(state)
    assert training.kept("refine 0") == {}
    assert torch.equal(training.kept("grow 1")["z"], torch.ones(2))


def test_a_gradient_that_is_not_finite_is_seen():
    net = torch.nn.Linear(2, 1)
    assert healthy_gradients(net)
    net.weight.grad = torch.tensor([[1.0, torch.inf]])
    assert not healthy_gradients(net)
