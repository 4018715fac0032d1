"""The set-up, check and removal of the core's environment, as background tasks."""

from __future__ import annotations

import bpy

from .. import environment
from ..background.thread import Say, Work
from .paths import Paths
from .session import session

RUNNING = "The set-up is running."


def set_up(context: bpy.types.Context, renew: bool = False) -> Work:
    """Make the environment in the background; ``renew`` makes it anew."""
    machine = Paths(context)
    root, place = machine.root, machine.place

    def make(say: Say) -> object:
        python = environment.ensure(
            root, (), say, renew=renew, place=place, stopped=lambda: work.cancelled
        )
        say(f"Ready: {python}", 1.0)
        return python

    work = Work("Repair" if renew else "Set-up", make)
    return session.begin(work)


def check(context: bpy.types.Context) -> Work:
    """Look at what is here and what is missing, in the background; its result are Lines."""
    machine = Paths(context)
    root, folder, python = machine.root, machine.environment, machine.own_python

    def look(say: Say) -> object:
        lines = environment.examine(root, folder, python)
        missing = [line.name for line in lines if line.state == "MISSING"]
        say(f"Missing: {', '.join(missing)}." if missing else "Everything is here.", 1.0)
        return lines

    return session.begin(Work("Check", look))


def remove(context: bpy.types.Context) -> Work:
    """Remove the environment that Set Up made, in the background."""
    folder = Paths(context).environment

    def clear(say: Say) -> object:
        environment.remove(folder)
        environment.tidy(folder)
        say("The environment is gone. Runs and assets are still there.", 1.0)
        return None

    return session.begin(Work("Removal", clear))


def reason_against(needs_network: bool = True) -> str:
    """Why the environment can't be made now; empty if it can."""
    if session.work and session.work.running:
        return RUNNING
    offline = Paths(bpy.context).place.wheels
    if offline and not offline.is_dir():
        return f"The wheel folder {offline} is not there."
    if needs_network and not offline and not bpy.app.online_access:
        return "Allow online access (Preferences, System, Network), or name a folder of wheels."
    return ""


def reason_against_removal() -> str:
    """Why the environment can't be removed now; empty if it can."""
    if session.work and session.work.running:
        return RUNNING
    if session.running:
        return "A job is running in it."
    try:
        there = Paths(bpy.context).environment.exists()
    except environment.SetupError as error:
        return error.text
    return "" if there else "There is none."
