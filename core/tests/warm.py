"""Imported by the server of forks (``forked.py``): what every session loads first, kept for it."""

from core.generate import prepare
from core.io.job import Job
from core.tests.tiny_runs import coarsely_drawn, loaded_once, loosely_packed

for patch in (*loaded_once(), *coarsely_drawn(), loosely_packed()):
    patch.start()
job = Job(prompt="a red torus")
prepare(job).guidance.of_object(job.seed).areas()
