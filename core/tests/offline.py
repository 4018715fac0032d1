"""A process without a network, whose attempts to reach one are recorded."""

import functools
import subprocess
import sys
from pathlib import Path

# Runs before anything else in each Python that the process starts. The hook sees every attempt to
# look up a name or to open a connection, whatever library makes it and whether or not it succeeds.
RECORD = """
import os, sys
def record(event, args):
    if event in ("socket.connect", "socket.sendto", "socket.sendmsg"):
        args = args[1:]
    elif event not in ("socket.getaddrinfo", "socket.gethostbyname", "urllib.Request"):
        return
    place = args[0][0] if isinstance(args[0], tuple) else args[0]
    # A path is a socket of this machine's own, and so are these.
    if event == "urllib.Request" or not str(place).startswith(("/", "127.", "::1", "localhost")):
        with open({file!r}, "a") as file:
            print(event, repr(args), file=file)
sys.addaudithook(record)
"""
# Two attempts, whose errors it prints.
ONLINE = """
import socket
for reach in (lambda: socket.create_connection(("192.0.2.1", 80), 1),
              lambda: socket.getaddrinfo("example.invalid", 80)):
    try:
        reach()
    except OSError as error:
        print(type(error).__name__)
"""


@functools.cache
def cut_off() -> tuple[str, ...]:
    """The start of a command that runs in a network namespace of its own; empty if not permitted.

    Not even the loopback is up in it. ``-r``: in a user namespace too, where users may make one.
    """
    for command in (("unshare", "-n"), ("unshare", "-r", "-n")):
        if sys.platform == "linux":
            try:
                if not subprocess.run([*command, "true"], capture_output=True).returncode:
                    return command
            except OSError:
                break
    return ()


def recorder(folder: Path) -> Path:
    """A folder for PYTHONPATH, which makes a process record its attempts in ``folder``."""
    folder.mkdir()
    code = RECORD.format(file=str(folder / "attempts"))
    (folder / "sitecustomize.py").write_text(code, encoding="utf-8")
    return folder


# As ``unshare`` does, in this process; its user stays who it is.
LEAVE = """
import ctypes, os
user, group = os.geteuid(), os.getegid()
if ctypes.CDLL(None, use_errno=True).unshare({flags}):
    raise OSError(ctypes.get_errno(), "no namespace of its own")
if {flags} & 0x10000000:
    for name, text in (("setgroups", "deny"), ("uid_map", f"{{user}} {{user}} 1"),
                       ("gid_map", f"{{group}} {{group}} 1")):
        with open("/proc/self/" + name, "w") as file:
            file.write(text)
"""


def alone_here(place: Path) -> str:
    """Python that cuts the process off that runs it, and has its attempts recorded from there on.

    ``place``: of ``recorder``; what it starts is recorded too.
    """
    flags = {(): 0, ("unshare", "-n"): 0x40000000}.get(cut_off(), 0x50000000)
    path = f"import os\nos.environ['PYTHONPATH'] = {str(place)!r}\n"
    leave = LEAVE.format(flags=flags) if flags else ""
    return path + leave + (place / "sitecustomize.py").read_text(encoding="utf-8")


def attempts(folder: Path) -> list[str]:
    """What the processes under ``recorder(folder)`` tried to reach."""
    file = folder / "attempts"
    return file.read_text(encoding="utf-8").splitlines() if file.exists() else []
