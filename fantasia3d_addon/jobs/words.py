"""The built-in model's reading of a prompt, requested from the core in the background. No bpy.

The core answers in about 0.1 s (``python -m core words``, which needs no package), for each prompt
once, and again some seconds after it could not be asked. It is asked when the prompt has not
changed for a moment.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from typing import Any

from ..background.thread import Task
from ..environment import piped_environ
from .process import Core

DEBOUNCE = 0.25  # seconds without a key until the core is asked
TIMEOUT = 20.0
RETRY = 10.0  # seconds after the core could not be asked
MAX_ANSWERS = 500  # kept; then all are forgotten
GROUPS = None  # in place of a prompt: all known words

Question = tuple[str | None, bool]  # a prompt or GROUPS, and whether unknown words are left out
Report = Mapping[str, Any]


class Words:
    """Reports of prompts, and the known words by group."""

    def __init__(self) -> None:
        self._answers: dict[Question, Any] = {}
        self._wanted: Question | None = None
        self._since = 0.0  # when it was wanted first
        self._failed = 0.0  # when the core could not be asked last
        self._task: tuple[Question, Task] | None = None

    @property
    def pending(self) -> bool:
        """Whether a question waits or is being answered."""
        return self._wanted is not None or self._task is not None

    def report(self, prompt: str, ignore_unknown: bool = False) -> Report | None:
        """The reading of ``prompt``, as ``run.py words`` reports it; None: not yet known.

        An empty report: the core could not be asked.
        """
        return self._answer((prompt.strip(), ignore_unknown)) if prompt.strip() else None

    def groups(self) -> Sequence[Report]:
        """The known words by group; empty while they are not known."""
        return self._answer((GROUPS, False)) or ()

    def _answer(self, question: Question) -> Any:
        answer = self._answers.get(question)
        failed_now = answer is not None and time.monotonic() - self._failed < RETRY
        if answer or failed_now:
            return answer
        if self._wanted != question and not (self._task and self._task[0] == question):
            self._wanted, self._since = question, time.monotonic()
        return answer

    def tick(self, core: Core | None) -> None:
        """Take an answer, and ask what is wanted; never blocks. ``core`` None: it is missing."""
        if self._task and not self._task[1].running:
            question, task = self._task
            if len(self._answers) >= MAX_ANSWERS:
                self._answers.clear()
            self._task = None
            self._keep(question, task.result or {})
        is_quiet = time.monotonic() - self._since > DEBOUNCE
        if self._wanted and self._task is None and (is_quiet or self._wanted[0] is GROUPS):
            question, self._wanted = self._wanted, None
            if core is None:
                self._keep(question, {})
                return
            self._task = question, Task("Words", lambda _progress: ask(core, question))

    def _keep(self, question: Question, answer: Any) -> None:
        self._answers[question] = answer
        self._failed = self._failed if answer else time.monotonic()


def ask(core: Core, question: Question) -> Any:
    """The core's answer; empty where it gives none."""
    prompt, ignore_unknown = question
    options = ["--ignore-unknown-words"] if ignore_unknown else []
    # Any Python will do, also before the installation: Blender's own.
    python = core.python if core.python.exists() else sys.executable
    words = [] if prompt is None else ["--", prompt]
    try:
        done = subprocess.run(
            [str(python), "-m", "core", "words", *options, *words],
            cwd=core.root,
            env=piped_environ(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=TIMEOUT,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),  # Windows: no console opens
        )
        return json.loads(done.stdout)
    except (OSError, ValueError, subprocess.TimeoutExpired):
        return {}


def unknown(report: Report | None) -> Mapping[str, Sequence[str]]:
    """The unknown words of a refused prompt, each with the nearest known ones."""
    return (report or {}).get("nearest") or {}


PART_LOOKS = "sizes", "sheens", "colours", "materials"  # in the order in which people name them


def summary(report: Report) -> str:
    """The reading in the order of the prompt's grammar: "chair, red, wooden", "3 × apple";
    last what goes with it: "rabbit, white, on: red pillow"."""
    words = [
        _several(report, report["thing"]),
        report.get("mood"),
        report.get("pose"),
        report.get("cut"),
        (report.get("style") or "").replace("_", " "),
        report["shape"],
        report["pattern"],
        *report["colours"],
    ]
    looks, own = _of_parts(report)
    parts = [part for part in report["parts"] if part not in own]
    late = [*report.get("sheen", []), *report.get("weather", [])]
    words += [*report["materials"], *late, *parts, *looks, *report.get("emblems", [])]
    words += map(_beside, report.get("companions", []))
    return ", ".join(filter(None, words))


def _of_parts(report: Report) -> tuple[list[str], list[str]]:
    """The numbers and looks of parts that have their own, and these parts."""
    looks = [report.get(f"part_{look}", {}) for look in PART_LOOKS]
    counts = {part: str(count) for part, count in report.get("part_counts", {}).items()}
    looks = [counts, *looks]
    own = list(dict.fromkeys(part for of_parts in looks for part in of_parts))
    return [" ".join([*(of[part] for of in looks if part in of), part]) for part in own], own


def _beside(other: Report) -> str:
    """Another thing, and how the first has it: "wears: red beanie (white brim)"."""
    looks = [*other["colours"], other["pattern"], *other["materials"]]
    does = (other.get(key) for key in ("mood", "pose", "cut"))
    words = [*does, *looks, other["thing"]]
    name = _several(other, " ".join(filter(None, words)))
    more = [*_of_parts(other)[0], *other["emblems"]]
    behind = f" ({', '.join(more)})" if more else ""
    return f"{other['relation']}: {name}{behind}"


def _several(report: Report, name: str) -> str:
    """A thing, and how many there are of it, where there are several."""
    count = report.get("count", 1)
    return f"{count} × {name}" if count > 1 else name


def replaced(prompt: str, old: str, new: str) -> str:
    """``prompt`` with the word ``old``, in whatever case, replaced by ``new``."""
    return re.sub(rf"(?<!\w){re.escape(old)}(?!\w)", new, prompt, count=1, flags=re.IGNORECASE)


def with_word(prompt: str, kind: str, word: str, thing: str = "") -> str:
    """``prompt`` with a word of a group of ``kind`` added: an adjective before ``thing``.

    A thing replaces ``thing``, the one that the prompt has.
    """
    prompt = prompt.strip()
    if kind == "part":
        part = word.removeprefix("no ")
        return f"{prompt} {'without' if part != word else 'with'} {_with_article(part)}".strip()
    if not prompt:
        return _with_article(word)
    if thing and re.search(rf"(?<!\w){re.escape(thing)}(?!\w)", prompt, re.IGNORECASE):
        return replaced(prompt, thing, word if kind == "thing" else f"{word} {thing}")
    return f"{prompt} {word}"


def _with_article(word: str) -> str:
    if word.endswith("s") or word.split()[0] in ("one", "three", "four"):
        return word
    return f"{'an' if word[0] in 'aeiou' else 'a'} {word}"
