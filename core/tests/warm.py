"""Imported by the server of forks (``forked.py``): what every session loads first, kept for it."""

from core.generate import prepare
from core.io.job import Job
from core.tests.tiny_runs import loaded_once

for patch in loaded_once():
    patch.start()
prepare(Job(prompt="a red torus"))
