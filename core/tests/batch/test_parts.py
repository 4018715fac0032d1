"""What a batch does to job.json after an attempt: what a node refuses does not stay in it."""

import shutil

from core.batch.attempt import End
from core.batch.needs import Needs
from core.batch.plan import Task
from core.batch.schedule import Batch
from core.batch.table import Row
from core.io.job import Job


class Node:
    """A pool of one place, whose checkpoint takes four views at a time or more."""

    needs, stopping, places = Needs(cpus=1, memory=0, gpus=0.0), "", 1

    def __init__(self) -> None:
        self.views: list[int] = []

    def start(self, task: Task) -> None:
        self.task = task

    def wait(self, _seconds: float) -> list[tuple[Task, End]]:
        assert self.task.folder
        job = Job.from_json((self.task.folder / "job.json").read_text("utf-8"))
        self.views.append(job.settings["appearance.views_at_once"])
        end = End(4, "Out of memory.", 1.0) if self.views[-1] >= 4 else End(2, "In fours.", 1.0)
        return [(self.task, end)]

    def stop(self) -> None:
        pass


def test_parts_that_a_node_refuses_do_not_stay_in_the_job(tmp_path):
    """Of MVDream's, which only the node can read: every later call was refused as well."""
    parts = {f"{stage}.views_at_once": 4 for stage in ("geometry", "appearance")}
    job = Job(prompt="a chair", preset="paper", guidance="/nowhere/mvdream", settings=parts)
    task, node = Task(Row(1, "a chair", "", {}, {}), tmp_path / "run", job), Node()
    batch = Batch([task], node, 5, lambda _states: None)
    batch.run()
    assert node.views == [4, 2]
    assert Job.from_json((tmp_path / "run" / "job.json").read_text("utf-8")) == job
    end = batch.states[tmp_path / "run"].end
    assert end and end.text == "Out of memory."  # the cause; nobody has asked for parts of two


def test_a_run_folder_that_goes_meanwhile_is_made_again(tmp_path):
    """As a user may remove one; the batch ended with it."""

    class Removed(Node):
        def wait(self, _seconds: float) -> list[tuple[Task, End]]:
            self.views.append(0)
            shutil.rmtree(tmp_path / "run")
            return [(self.task, End(2 - len(self.views), "", 1.0))]

    job, node = Job(prompt="a chair"), Removed()
    task = Task(Row(1, "a chair", "", {}, {}), tmp_path / "run", job)
    Batch([task], node, 1, lambda _states: None).run()
    assert len(node.views) == 2
