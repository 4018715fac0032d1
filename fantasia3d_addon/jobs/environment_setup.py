"""Installation, check and removal of the core's environment, as background tasks."""

from __future__ import annotations

import bpy

from .. import environment
from ..background.thread import ReportProgress, Task
from .paths import Paths
from .session import session

RUNNING = "The installation is running."


def set_up(context: bpy.types.Context, renew: bool = False) -> Task:
    """Create the environment in the background; ``renew`` creates it again from nothing."""
    paths = Paths(context)
    root, place = paths.root, paths.place

    def create(progress: ReportProgress) -> object:
        python = environment.ensure(
            root, (), progress, renew=renew, place=place, stopped=lambda: task.cancelled
        )
        progress(f"Ready: {python}", 1.0)
        return python

    task = Task("Reinstall" if renew else "Install", create)
    return session.start_task(task)


def check(context: bpy.types.Context) -> Task:
    """Find out in the background what is installed and what is missing; its result are Lines."""
    paths = Paths(context)
    root, folder, python = paths.root, paths.environment, paths.own_python

    def examine(progress: ReportProgress) -> object:
        lines = environment.examine(root, folder, python)
        missing = [line.name for line in lines if line.state == "MISSING"]
        progress(f"Missing: {', '.join(missing)}." if missing else "Everything is installed.", 1.0)
        return lines

    return session.start_task(Task("Check", examine))


def remove(context: bpy.types.Context) -> Task:
    """Remove the environment that Install created, in the background."""
    folder = Paths(context).environment

    def clear(progress: ReportProgress) -> object:
        environment.remove(folder)
        environment.tidy(folder)
        progress("The environment was removed. Runs and assets are still there.", 1.0)
        return None

    return session.start_task(Task("Uninstall", clear))


def reason_against(needs_network: bool = True) -> str:
    """Why the environment can't be created now; empty if it can."""
    if session.task and session.task.running:
        return RUNNING
    try:
        wheels = Paths(bpy.context).place.wheels
    except environment.SetupError as error:
        return str(error)
    if wheels and not wheels.is_dir():
        return f"The wheels folder {wheels} does not exist."
    if needs_network and not wheels and not bpy.app.online_access:
        return "The installation needs online access, or a folder of wheels."
    return ""


def is_installed() -> bool:
    """Whether the method's Python exists."""
    try:
        return Paths(bpy.context).python.exists()
    except environment.SetupError:
        return False


def reason_against_removal() -> str:
    """Why the environment can't be removed now; empty if it can."""
    if session.task and session.task.running:
        return RUNNING
    if session.running:
        return "A job is using it."
    try:
        exists = Paths(bpy.context).environment.exists()
    except environment.SetupError as error:
        return str(error)
    return "" if exists else "It is not installed."
