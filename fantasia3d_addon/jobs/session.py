"""The jobs of this Blender: the runs that it follows, its queue, its history, its set-up task.

One :class:`Session` lives from register to unregister. Its :meth:`tick` is called by a timer in a
window (timers never fire in the background) or by a loop in a script; it never blocks.
"""

from __future__ import annotations

import shutil
import traceback
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import bpy

from ..asset.asset_folder import AssetFolder, read_asset
from ..background.thread import Task
from ..environment import SetupError
from ..errors import AddonError
from . import history, live_preview
from .history import Entry
from .import_result import import_result, mark_imported, reason_to_wait
from .job_file import IMPORTED
from .lock import RunLock
from .memory import FreeMemory
from .models import Model, Models
from .new_run import write_run
from .panels import redraw, update_list
from .paths import Paths
from .place import requested, scene_of
from .process import Run
from .progress import FollowedRun
from .target import Target
from .words import Report, Words

TICK_SECONDS = 0.25
ADOPT_SECONDS = 1.0  # after the start of Blender, when its file is open
BUG = "This is a bug. Report it."


class Session:
    """The state of this Blender that is not part of the file."""

    def __init__(self) -> None:
        self.running: list[FollowedRun] = []  # one, and those that earlier Blenders left running
        self.waiting: list[tuple[Path, RunLock | None]] = []  # the queue, first in first out
        self.paused = False  # the queue waits for the user
        self.candidates: dict[str, FollowedRun] = {}  # paused runs whose previews stay, by name
        self.importing: list[tuple[FollowedRun, Task]] = []  # done, being read, not in the scene
        self.missed: list[Entry] = []  # done while no Blender, or another file, was open
        self.last: FollowedRun | None = None  # the last run that ended
        self.error: tuple[str, str] | None = None  # the last one: its text and its fix
        self.asset = ""  # the name of the last object that was imported
        self.task: Task | None = None  # a set-up, check or removal of the environment
        self.history: list[Entry] = []
        self.free_memory = FreeMemory()
        self.words = Words()
        self.models = Models()
        self._scan: Task | None = None  # reads the history
        self._outdated = False  # something has changed since it began to
        self._file_number = 0  # counts the files that were opened
        self._requested: dict[Path, int] = {}  # the file's number at the request, by run folder
        # Blender knows a timer by its identity, and a bound method is a new object each time.
        self._timer = self.tick
        self._adopter = self._adopt_later

    @property
    def busy(self) -> bool:
        """Whether a job is running, waiting to start, or being imported."""
        return bool(self.running or self.importing or (self.waiting and not self.paused))

    @property
    def run(self) -> FollowedRun | None:
        """The run that is shown first: one that is running, or else the last."""
        return self.running[0] if self.running else self.last

    @property
    def names(self) -> list[str]:
        """The run folders' names of the running jobs."""
        return [followed.name for followed in self.running]

    @property
    def shown(self) -> list[str]:
        """The run folders' names of the runs whose previews stay."""
        return [*self.names, *self.candidates]

    @property
    def log(self) -> Path | None:
        """The log of the run that is shown first."""
        return self.run.run.log if self.run and self.run.run.log.exists() else None

    def target_here(self, context: bpy.types.Context, **more: Any) -> Target:
        """The target of an asset that is requested now: this file, this scene, this place."""
        here = {"file": bpy.data.filepath, "scene": context.scene.name} | requested(context)
        return Target(**here | more)

    # The queue

    def submit(
        self,
        context: bpy.types.Context,
        job: Mapping[str, Any],
        target: Target,
        files: Mapping[str, Path] | None = None,
    ) -> Path:
        """Put ``job`` into the queue, with copies of its ``files`` by name; its run folder.

        Raises:
            AddonError: the folder for runs can't be written, or the core can't be started;
                nothing is left in it then.
        """
        folder = write_run(Paths(context).runs, job, target, files or {})
        self._requested[folder] = self._file_number
        try:
            self.enqueue(context, folder)
        except (AddonError, SetupError):
            if all(folder != other for other, _ in self.waiting):  # it was this one that failed
                shutil.rmtree(folder, ignore_errors=True)
                del self._requested[folder]
            raise
        return folder

    def enqueue(self, context: bpy.types.Context, folder: Path) -> None:
        """Start or resume the run in ``folder`` when its turn comes.

        Raises:
            AddonError: another Blender follows it, its folder can't be written, or it can't be
                started.
        """
        lock = RunLock.acquire(folder)
        if lock is None:
            raise AddonError(
                "Another Blender follows this run.", "Cancel it there, or wait until it ends."
            )
        self.error, self.paused = None, False
        if not Target.read(folder).object:  # a new object comes where its run is resumed
            self._requested[folder] = self._file_number
        self.waiting.append((folder, lock))
        self.start_timer()  # first: where the head of the queue fails, the others go on
        self._start_next(raise_error=True)
        self.refresh()

    def remove_from_queue(self, folder: Path) -> None:
        """Remove a waiting job from the queue, and its folder from the disk."""
        for item in [item for item in self.waiting if item[0] == folder]:
            self.waiting.remove(item)
            if item[1]:
                item[1].release()
            entry = history.read_entry(folder)
            # A run that was started before holds work: only one that never ran is removed.
            if entry and entry.state == history.WAITING:
                history.remove(entry)
        self.refresh()

    def _start_next(self, raise_error: bool = False) -> None:
        """Start the first job of the queue, if none is running."""
        if self.running or self.paused or not self.waiting:
            return
        folder, lock = self.waiting.pop(0)
        try:
            run = Run.resume(folder, Paths(bpy.context).job_core)
        except (AddonError, SetupError) as error:
            if lock:
                lock.release()
            self.error = (error.text, error.fix)
            if raise_error:
                raise
            return
        self.follow(run, lock)

    # The runs

    def follow(self, run: Run, lock: RunLock | None) -> FollowedRun:
        """Follow ``run`` from now on."""
        number = self._requested.get(run.folder)  # None: an earlier Blender's
        followed = FollowedRun(run, Target.read(run.folder), lock, number)
        self.running.append(followed)
        self.asset = ""
        self.start_timer()
        return followed

    def adopt(self, context: bpy.types.Context) -> None:
        """Take over what an earlier Blender left: running jobs, its queue, finished assets.

        A run that another living Blender follows is left to it.
        """
        runs = self._runs(context)
        self.history = history.scan(runs) if runs else []
        ours = {*(f.run.folder for f in self.running), *(folder for folder, _ in self.waiting)}
        ours |= {entry.folder for entry in self.missed}  # they are offered already
        for entry in reversed(self.history):  # the oldest first, as they were queued
            if entry.folder not in ours and entry.state in history.ADOPTABLE:
                self._adopt(entry)
        self.start_timer()

    def _adopt(self, entry: Entry) -> None:
        try:
            lock = RunLock.acquire(entry.folder)
        except AddonError:  # a folder that can't be written: nobody follows its run
            return
        if lock is None:
            return
        if entry.state == history.RUNNING:
            self.follow(Run.attach(entry.folder), lock)
        elif entry.state == history.WAITING:
            self.waiting.append((entry.folder, lock))
            self.paused = True  # minutes of work do not start without the user
        else:
            lock.release()
            if history.awaits_import(entry):
                self.missed.append(entry)

    def _adopt_later(self) -> None:
        self.adopt(bpy.context)
        self.refresh()

    def cancel(self, name: str = "") -> None:
        """Ask the run of that name, or the first, to stop after its present step."""
        for followed in [f for f in self.running if name in ("", f.name)][:1]:
            try:
                followed.cancel()
            except AddonError as error:
                self.error = (error.text, error.fix)
        self.start_timer()

    def kill(self) -> None:
        """End the processes whose cancel takes long; they resume from their checkpoints."""
        for followed in self.running:
            if followed.progress.cancelling:
                followed.run.kill()

    def mark_imported(self, folder: Path) -> None:
        """The asset of the run in ``folder`` is in a scene now: do not offer it again."""
        mark_imported(folder)
        self.missed = [entry for entry in self.missed if entry.folder != folder]

    def refresh(self) -> None:
        """Read the history again, in the background; once more where it is being read: what that
        has seen may be older than what this is called for."""
        self._outdated = self._scan is not None
        if self._scan is None:
            runs, known = self._runs(bpy.context), {e.folder: e for e in self.history}
            if runs is None:
                return
            self._scan = Task("History", lambda _progress: history.scan(runs, known))
            self.start_timer()

    def _runs(self, context: bpy.types.Context) -> Path | None:
        """The folder of all run folders; None where the preferences' can't be, which is shown."""
        try:
            return Paths(context).runs
        except SetupError as error:
            self.error = (error.text, error.fix)
            return None

    def start_task(self, task: Task) -> Task:
        """Show a set-up, check or removal of the environment until it ends."""
        self.task = task
        self.start_timer()
        return task

    # What the built-in model understands: asked in the background, since drawing must not wait

    def report(self, prompt: str, ignore_unknown: bool) -> Report | None:
        """See :meth:`Words.report`."""
        report = self.words.report(prompt, ignore_unknown)
        self._follow_words()
        return report

    def word_groups(self) -> Sequence[Report]:
        """See :meth:`Words.groups`."""
        groups = self.words.groups()
        self._follow_words()
        return groups

    def _follow_words(self) -> None:
        # A script has no timers, and nobody looks at the answer.
        if self.words.pending and not bpy.app.background:
            self.start_timer()

    # The models on this machine: asked in the background, too

    def found_models(self) -> Sequence[Model] | None:
        """The found models; None: not yet known. The first call starts the core's search."""
        if self.models.found is None and not self.models.pending:
            self.find_models()
        return self.models.found

    def find_models(self) -> None:
        """Have the core look at the models' folders; SetupError where there is no core."""
        paths = Paths(bpy.context)
        self.models.look(paths.core, paths.tool)
        self.start_timer()

    # From register to unregister

    def file_opened(self) -> None:
        """Another file is open now: what was requested in the last one does not belong in it."""
        self._file_number += 1

    def open(self) -> None:
        """Look for what an earlier Blender left, once there is a window."""
        if not bpy.app.background:
            bpy.app.timers.register(self._adopter, first_interval=ADOPT_SECONDS)

    def start_timer(self) -> None:
        """Have :meth:`tick` called as long as there is something to follow."""
        if not bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.register(self._timer, first_interval=0.05, persistent=True)

    def close(self) -> None:
        """Stop following and forget everything; running processes continue by themselves."""
        for timer in (self._timer, self._adopter):
            if bpy.app.timers.is_registered(timer):
                bpy.app.timers.unregister(timer)
        for followed in [*self.running, *(followed for followed, _ in self.importing)]:
            followed.release()
        for _, lock in self.waiting:
            if lock:
                lock.release()
        live_preview.remove()
        self.__init__()

    # The timer

    def tick(self) -> float | None:
        """Handle what has happened; the seconds until the next call, None when all has ended.

        It never raises: Blender would not call it again.
        """
        try:
            self._handle()
        except Exception as error:
            self._report_bug("The jobs can't be followed.", error)
        redraw()
        return TICK_SECONDS if self.busy or self._is_working() else None

    def _is_working(self) -> bool:
        """Whether the background still works on something, or has found what is not yet shown."""
        sets_up = self.task is not None and self.task.running
        words = self.words.pending and not bpy.app.background
        # A history that was read since it was looked at is taken by the next tick.
        return bool(sets_up or self._scan is not None or self.models.pending or words)

    def _report_bug(self, what: str, error: Exception) -> None:
        """Show the sentence ``what`` went wrong, and print its traceback once."""
        text = f"{what} {type(error).__name__}: {str(error).strip().rstrip('.')}."
        if self.error != (text, BUG):
            traceback.print_exception(error)
        self.error = (text, BUG)

    def _handle(self) -> None:
        for followed in list(self.running):
            try:
                followed.poll()
                if followed.run.finished:
                    self._end(followed)
                elif followed.shape:
                    self._show_shape(followed)
            except Exception as error:  # the other runs go on
                self._report_bug(f"“{followed.prompt}” can't be followed.", error)
        self._import_finished()
        self._start_next()
        if self._scan and not self._scan.running:
            found, self._scan = self._scan.result, None
            if self._outdated:
                self.refresh()
            elif isinstance(found, list):
                self.history = found
            update_list(self.history)
        self._ask_words()
        self.models.tick()

    def _ask_words(self) -> None:
        # A script would wait for what nobody looks at.
        if not self.words.pending or bpy.app.background:
            return
        try:
            core = Paths(bpy.context).core
        except SetupError:
            core = None
        self.words.tick(core)

    def _end(self, followed: FollowedRun) -> None:
        self.running.remove(followed)
        self.last = followed
        self.candidates.pop(followed.name, None)
        if followed.end and followed.end.type == "done":
            folder = followed.run.folder
            # In a thread: reading a mesh of 200,000 faces takes longer than a tick may.
            task = Task("Asset", lambda _progress: read_asset(folder))
            self.importing.append((followed, task))
        else:
            followed.release()
            if followed.end and followed.end.type == "error":
                self.error = (followed.end.text, followed.end.fix)
        self.refresh()
        if followed.end and followed.end.type == "paused":
            self.candidates[followed.name] = followed
            self.show_candidates()  # its last shape may not have been shown
        live_preview.remove(keep=self.shown)

    def show_candidates(self) -> None:
        """Show the shapes of the candidates that can be looked at, each in its place."""
        for followed in self.candidates.values():
            followed.shape = followed.run.folder / "preview" / "shape.npz"
            self._show_shape(followed)

    def forget_candidate(self, folder: Path) -> None:
        """Remove the preview of a run that was deleted, and the offer of its asset."""
        self.candidates.pop(folder.name, None)
        self.missed = [entry for entry in self.missed if entry.folder != folder]
        live_preview.remove(keep=self.shown)

    def _show_shape(self, followed: FollowedRun) -> None:
        """Show the newest preview mesh of ``followed``, in the file that requested it."""
        path, followed.shape = followed.shape, None
        # On the user's own object nothing changes before its job is done.
        if path and self._is_open(followed) and not followed.target.object:
            live_preview.show(scene_of(followed.target), path, followed)

    def is_requested_here(self, folder: Path, target: Target) -> bool:
        """Whether the file that requested the run in ``folder``, for ``target``, is open."""
        return self._is_file(self._requested.get(folder), target)

    def _is_open(self, followed: FollowedRun) -> bool:
        return self._is_file(followed.file_number, followed.target)

    def _is_file(self, number: int | None, target: Target) -> bool:
        """Whether the open file is that of ``target``, which had ``number`` at the request."""
        if number == self._file_number:  # also after it was saved as another
            return True
        # Unsaved files cannot be distinguished: a new object may come into another of them, but
        # an object there is another one, even with the same name.
        named = target.file or not target.object
        return bool(named) and target.file == bpy.data.filepath

    def _import_finished(self) -> None:
        """Import the finished assets, unless the user is in the middle of an operation."""
        ready = [item for item in self.importing if not item[1].running]
        for followed, task in [] if reason_to_wait() else ready:
            self.importing.remove((followed, task))
            try:
                if not self._is_open(followed):
                    self._offer(followed)
                elif task.error:
                    self.error = task.error
                else:
                    self._import(followed, task)
            except Exception as error:
                self._report_bug(f"The asset “{followed.prompt}” can't be imported.", error)
                self._offer(followed)
            finally:
                followed.release()

    def _offer(self, followed: FollowedRun) -> None:
        """Offer an asset that did not come into the scene."""
        entry = history.read_entry(followed.run.folder)
        if entry and not (entry.folder / IMPORTED).exists():
            self.missed.append(entry)

    def _import(self, followed: FollowedRun, task: Task) -> None:
        target, scene = followed.target, scene_of(followed.target)
        asset = task.result if isinstance(task.result, AssetFolder) else None
        folder, near = followed.run.folder, followed.place
        try:
            self.asset = import_result(folder, target, scene, asset, near=near)
        except AddonError as error:
            self.error = (error.text, error.fix)


session = Session()  # the one of this Blender; unregistration empties it
