"""What goes on in this Blender: the runs that it follows, its queue, its history, the set-up.

One :class:`Session` lives from register to unregister. Its :meth:`tick` is called by a timer in a
window (timers never fire in the background) or by a loop in a script; it never blocks.
"""

from __future__ import annotations

import shutil
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import bpy

from ..asset.asset_folder import AssetFolder, read_asset
from ..background.thread import Work
from ..blender.names import data_name
from ..environment import SetupError
from ..errors import AddonError
from . import history, live_preview
from .history import Entry
from .import_result import mark_taken, obstacle, take_in
from .lock import Claim
from .memory import Free
from .paths import Paths
from .process import Run, prepare
from .progress import Follow
from .target import Target

TICK_SECONDS = 0.25
ADOPT_SECONDS = 1.0  # after the start of Blender, when its file is open


class Session:
    """The state of this Blender that is no part of the file."""

    def __init__(self) -> None:
        self.running: list[Follow] = []  # one, and those that earlier Blenders left behind
        self.waiting: list[tuple[Path, Claim | None]] = []
        self.paused = False  # the queue waits for the user
        self.arriving: list[tuple[Follow, Work]] = []  # done, being read, not yet in the scene
        self.missed: list[Entry] = []  # done while no Blender, or another file, was open
        self.last: Follow | None = None  # the last run that ended
        self.error: tuple[str, str] | None = None  # the last one: a sentence and its fix
        self.asset = ""  # the name of the last object that was made
        self.work: Work | None = None  # a set-up or a check
        self.history: list[Entry] = []
        self.free_memory = Free()
        self._scan: Work | None = None
        self._file_number = 0
        self._timer = self.tick  # one object: Blender knows a timer by its identity
        self._adopter = self._adopt_later

    @property
    def busy(self) -> bool:
        """Whether something of a job is still to be done."""
        return bool(self.running or self.arriving or (self.waiting and not self.paused))

    @property
    def run(self) -> Follow | None:
        """The run that is shown first: one that goes on, or else the last."""
        return self.running[0] if self.running else self.last

    @property
    def names(self) -> list[str]:
        """The run folders' names of the runs that go on."""
        return [follow.name for follow in self.running]

    @property
    def log(self) -> Path | None:
        """What the run that is shown printed."""
        return self.run.run.log if self.run and self.run.run.log.exists() else None

    def here(self, context: bpy.types.Context, **more: Any) -> Target:
        """The place where an asset that is asked for now shall stand."""
        return Target(
            file=bpy.data.filepath,
            scene=context.scene.name,
            location=tuple(context.scene.cursor.location),
            **more,
        )

    def submit(
        self,
        context: bpy.types.Context,
        job: Mapping[str, Any],
        target: Target,
        files: Mapping[str, Path] | None = None,
    ) -> Path:
        """Put ``job`` into the queue, with copies of its ``files`` by name; its run folder.

        Raises:
            AddonError: the place can't be written; nothing is left of it then.
        """
        folder = new_run_folder(Paths(context).runs, str(job.get("prompt", "")))
        try:
            for name, path in (files or {}).items():
                shutil.copyfile(path, folder / name)
            target.write(folder)
            prepare(folder, history.settle(job, folder))
        except BaseException as error:
            shutil.rmtree(folder, ignore_errors=True)
            if isinstance(error, OSError):
                raise AddonError(
                    f"{folder} can't be written ({error.strerror}).",
                    "Choose another folder for runs in the add-on's preferences.",
                ) from None
            raise
        self.enqueue(context, folder)
        return folder

    def enqueue(self, context: bpy.types.Context, folder: Path) -> None:
        """Have the run in ``folder`` begun or resumed when its turn comes.

        Raises:
            AddonError: another Blender follows it, or it can't be started.
        """
        claim = Claim.take(folder)
        if claim is None:
            raise AddonError(
                "Another Blender follows this run.", "Cancel it there, or wait for its end."
            )
        self.error, self.paused = None, False
        self.waiting.append((folder, claim))
        self._start_next(raise_error=True)
        self.refresh()
        self.watch()

    def follow(self, run: Run, claim: Claim | None) -> Follow:
        """Follow ``run`` from here on."""
        follow = Follow(run, Target.read(run.folder), claim, self._file_number)
        self.running.append(follow)
        self.asset = ""
        self.watch()
        return follow

    def adopt(self, context: bpy.types.Context) -> None:
        """Take up what an earlier Blender left behind: runs that go on, a queue, finished assets.

        A run that another living Blender follows is left to it.
        """
        self.history = history.scan(Paths(context).runs)
        ours = {*(f.run.folder for f in self.running), *(folder for folder, _ in self.waiting)}
        for entry in reversed(self.history):  # the oldest first
            if entry.folder in ours or entry.state not in (
                history.RUNNING, history.WAITING, history.DONE
            ):  # fmt: skip
                continue
            claim = Claim.take(entry.folder)
            if claim is None:
                continue
            if entry.state == history.RUNNING:
                self.follow(Run.attach(entry.folder), claim)
            elif entry.state == history.WAITING:
                self.waiting.append((entry.folder, claim))
                self.paused = True
            else:
                claim.release()
                if is_missed(entry):
                    self.missed.append(entry)
        self.watch()

    def cancel(self, name: str = "") -> None:
        """Ask the run of that name, or the first, to stop after its present step."""
        for follow in [f for f in self.running if name in ("", f.name)][:1]:
            follow.cancel()
        self.watch()

    def kill(self) -> None:
        """End the processes whose cancel waits too long; they resume from their checkpoints."""
        for follow in self.running:
            if follow.progress.cancelling:
                follow.run.kill()

    def drop(self, folder: Path) -> None:
        """Take a waiting job out of the queue, and its folder off the disk."""
        for item in [item for item in self.waiting if item[0] == folder]:
            self.waiting.remove(item)
            if item[1]:
                item[1].release()
            entry = history.read_entry(folder)
            if entry and entry.state == history.WAITING:
                history.remove(entry)
        self.refresh()

    def mark_imported(self, folder: Path) -> None:
        """The asset of the run in ``folder`` is in a scene now: it is not offered again."""
        mark_taken(folder)
        self.missed = [entry for entry in self.missed if entry.folder != folder]

    def refresh(self) -> None:
        """Read the history anew, in the background."""
        if self._scan is None or not self._scan.running:
            runs, known = Paths(bpy.context).runs, {e.folder: e for e in self.history}
            self._scan = Work("History", lambda _say: history.scan(runs, known))
            self.watch()

    def begin(self, work: Work) -> Work:
        """Show a set-up or a check until its end."""
        self.work = work
        self.watch()
        return work

    def file_opened(self) -> None:
        """Another file is open now: what was asked for in the last one does not belong here."""
        self._file_number += 1

    def open(self) -> None:
        """Begin: look for what an earlier Blender left, once there is a window."""
        if not bpy.app.background:
            bpy.app.timers.register(self._adopter, first_interval=ADOPT_SECONDS)

    def watch(self) -> None:
        """Have :meth:`tick` called while there is something to follow."""
        if not bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.register(self._timer, first_interval=0.05, persistent=True)

    def close(self) -> None:
        """Stop following and forget; what runs goes on by itself."""
        for timer in (self._timer, self._adopter):
            if bpy.app.timers.is_registered(timer):
                bpy.app.timers.unregister(timer)
        for follow in [*self.running, *(follow for follow, _ in self.arriving)]:
            follow.release()
        for _, claim in self.waiting:
            if claim:
                claim.release()
        live_preview.remove()
        self.__init__()

    def tick(self) -> float | None:
        """Take in what has happened; the seconds to the next call, None when all has ended."""
        for follow in list(self.running):
            follow.poll()
            if follow.run.finished:
                self._end(follow)
            elif follow.shape:
                self._show(follow)
        self._arrive()
        self._start_next()
        if self._scan and not self._scan.running:
            if isinstance(self._scan.result, list):
                self.history = self._scan.result
            self._scan = None
            _list_history(self.history)
        _redraw()
        working = (self.work and self.work.running) or self._scan
        return TICK_SECONDS if self.busy or working else None

    def _adopt_later(self) -> None:
        self.adopt(bpy.context)
        self.refresh()

    def _start_next(self, raise_error: bool = False) -> None:
        """Start the first that waits, if nothing runs."""
        if self.running or self.paused or not self.waiting:
            return
        folder, claim = self.waiting.pop(0)
        machine = Paths(bpy.context)
        try:
            run = Run.resume(folder, machine.python, machine.root, machine.core_environ)
        except (AddonError, SetupError) as error:
            if claim:
                claim.release()
            self.error = (error.text, error.fix)
            if raise_error:
                raise
            return
        self.follow(run, claim)

    def _end(self, follow: Follow) -> None:
        self.running.remove(follow)
        self.last = follow
        live_preview.remove(keep=self.names)
        if follow.end and follow.end.type == "done":
            folder = follow.run.folder  # to read it takes longer than a tick may
            self.arriving.append((follow, Work("Asset", lambda _say: read_asset(folder))))
        else:
            follow.release()
            if follow.end and follow.end.type == "error":
                self.error = (follow.end.text, follow.end.fix)
        self.refresh()

    def _show(self, follow: Follow) -> None:
        """Show the shape that ``follow`` has so far, in the file that it belongs to."""
        path, follow.shape = follow.shape, None
        if path and self._belongs(follow) and not follow.target.object:
            scene = scene_of(follow.target)
            live_preview.show(
                scene.collection, path, follow.name, follow.prompt, follow.target.location
            )

    def _belongs(self, follow: Follow) -> bool:
        """Whether the file that ``follow`` was asked for in is open."""
        return follow.file_number == self._file_number or follow.target.file == bpy.data.filepath

    def _arrive(self) -> None:
        """Take the assets that are done into the scene, unless the user is in the middle of
        something."""
        ready = [item for item in self.arriving if not item[1].running]
        for follow, work in [] if obstacle() else ready:
            self.arriving.remove((follow, work))
            if not self._belongs(follow):
                entry = history.read_entry(follow.run.folder)
                self.missed += [entry] if entry else []
            elif work.error:
                self.error = work.error
            else:
                try:
                    scene = scene_of(follow.target)
                    asset = work.result if isinstance(work.result, AssetFolder) else None
                    self.asset = take_in(follow.run.folder, follow.target, scene, asset)
                except AddonError as error:
                    self.error = (error.text, error.fix)
            follow.release()


def scene_of(target: Target) -> bpy.types.Scene:
    """The scene that the asset was asked for in; the present one where it has gone."""
    return bpy.data.scenes.get(target.scene) or bpy.context.scene


def is_missed(entry: Entry) -> bool:
    """Whether a finished asset was asked for in Blender and never came into a scene."""
    asked = (entry.folder / "target.json").exists()
    return asked and not (entry.folder / "taken").exists()


def new_run_folder(runs: Path, prompt: str) -> Path:
    """A new, empty folder for a run, named by the time and the prompt's letters.

    Raises:
        AddonError: the place can't be written.
    """
    words = "".join(c if c.isalnum() else " " for c in data_name(prompt).lower()).split()
    name = "-".join([time.strftime("%Y%m%d-%H%M%S"), *words])
    number = 1
    while True:
        folder = runs / (name if number == 1 else f"{name}-{number}")
        try:
            folder.mkdir(parents=True)
        except FileExistsError:
            number += 1
        except OSError as error:
            raise AddonError(
                f"{folder} can't be made ({error.strerror}).",
                "Choose another folder for runs in the add-on's preferences.",
            ) from None
        else:
            return folder


def _list_history(entries: list[Entry]) -> None:
    """Have the panel's list hold what the history holds."""
    listed = bpy.context.window_manager.fantasia3d.entries
    if [item.name for item in listed] != [str(entry.folder) for entry in entries]:
        listed.clear()
        for entry in entries:
            listed.add().name = str(entry.folder)


def _redraw() -> None:
    """Draw the sidebars and the preferences anew."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "PREFERENCES":
                area.tag_redraw()
            for region in area.regions if area.type == "VIEW_3D" else ():
                if region.type == "UI":
                    region.tag_redraw()


session = Session()  # the one of this Blender; unregistration empties it
