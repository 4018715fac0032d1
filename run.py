#!/usr/bin/env python3
"""Fantasia3D for Blender from the command line: text in, a textured mesh in a Blender scene out.

    python3 run.py COMMAND ...
    blender -b --python-exit-code 1 --python run.py -- COMMAND ...
    blender --python run.py            a window, with the panel in the sidebar (tab Fantasia3D)

Commands:
    generate "PROMPT"          make an asset; --out RUN, --blend FILE, --render FILE, --seed N, ...
    texture MESH "PROMPT"      a material for your own mesh; the same options
    resume RUN                 go on with a run that was cancelled or died; --blend, --render
    render ASSET --out FILE    a picture of an asset under a light
    inspect ASSET|MESH         the mesh's health as JSON
    export ASSET --format blend|glb|usd|fbx|obj --out FILE
    relight ASSET --light NAME|FILE --render FILE [--turntable FILE.mp4] [--material gold]
    physics ASSET --physics rigid|soft|cloth|drape --frames N --render FILE [--blend FILE]
    cornell ASSET... --render FILE
    bench [NAME...]            measure this machine
    doctor                     what is here, what is missing, how to mend it
    setup [blender] [test]     make the Python environment now; --renew, --allow-cuda
    package [--out FOLDER]     the extension for Blender, as a zip
    test [PYTEST ARGUMENTS]    run the tests
    python [ARGUMENTS]         the environment's Python

COMMAND --help tells a command's options. The first run makes an environment for the method's
Python packages in your data folder (about 3 GB; `doctor` tells where).

Exit status: 0 done; 2 the input; 3 something is not installed or not there; 4 out of memory;
5 no surface could be kept; 130 cancelled.
"""

from __future__ import annotations

import contextlib
import difflib
import io
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn, TextIO

ROOT = Path(__file__).resolve().parent
if str(ROOT) not in sys.path:  # Blender runs this file without its folder
    sys.path.insert(0, str(ROOT))

from fantasia3d_addon import environment  # noqa: E402 -- standard library only, no bpy

JOBS = ("generate", "texture", "resume")  # these end in an asset that Blender may take
CORE = (*JOBS, "render", "inspect", "export", "bench")
SCENE = ("relight", "physics", "cornell")  # Blender's alone
SCENE_FORMATS = ("usd", "usdc", "usda", "usdz", "fbx")  # which the core does not write
OWN = ("doctor", "setup", "package", "test", "python")
PICTURES = (".png", ".jpg", ".jpeg", ".exr", ".tif", ".tiff", ".webp")


class InputError(Exception):
    """What the user asked for cannot be: a sentence and its cure."""

    status = 2


# The command line


def take(arguments: Sequence[str], option: str) -> tuple[str | None, list[str]]:
    """The value of ``option`` (``--name VALUE`` or ``--name=VALUE``), and the other arguments.

    Raises:
        InputError: the value is missing, or there are two.
    """
    value: str | None = None
    rest: list[str] = []
    words = iter(arguments)
    for word in words:
        name, equals, given = word.partition("=")
        if name != option:
            rest.append(word)
            continue
        if value is not None:
            raise InputError(f"{option} stands there twice. Name one file.")
        value = given if equals else next(words, "")
        if not value or (not equals and value.startswith("--")):
            raise InputError(f"{option} has no value. Write {option} FILE.")
    return value, rest


def split(argv: Sequence[str]) -> tuple[list[str], dict[str, str]]:
    """The core's part of a command line, and Blender's: the files for ``blend`` and ``render``.

    The core's part is empty where Blender alone has something to do (``export --format blend``).
    """
    arguments = list(argv)
    blender: dict[str, str] = {}
    if argv[0] in JOBS:
        for name in ("blend", "render"):
            value, arguments = take(arguments, f"--{name}")
            if value is not None:
                blender[name] = value
    elif argv[0] == "export" and take(argv, "--format")[0] == "blend":
        out, rest = take(take(argv, "--format")[1], "--out")
        if out is None:
            raise InputError("export has no --out. Write --out FILE.blend.")
        if len(rest) != 2:
            raise InputError(f"export takes one asset, and got {rest[1:]}. Name its folder.")
        return [], {"asset": rest[1], "blend": out}
    return arguments, blender


def is_blenders(argv: Sequence[str]) -> bool:
    """Whether a command is for Blender alone, by one of the add-on's own commands."""
    if argv[0] in SCENE:
        return True
    return argv[0] == "export" and (take(argv, "--format")[0] or "").lower() in SCENE_FORMATS


def check_targets(blender: dict[str, str]) -> None:
    """Refuse files that could not be written after an hour's work.

    Raises:
        InputError: a wrong ending, a folder, or a place that cannot be written.
    """
    for name, endings in (("blend", (".blend",)), ("render", PICTURES)):
        if name not in blender:
            continue
        path = Path(blender[name]).expanduser().absolute()
        if path.suffix.lower() not in endings:
            raise InputError(f"--{name} is {blender[name]!r}. Its name ends in {endings[0]}.")
        place = next(p for p in path.parents if p.exists())
        if path.is_dir() or not place.is_dir() or not os.access(str(place), os.W_OK):
            raise InputError(f"{path} cannot be written. Name a file in a folder of yours.")


def check_command(argv: Sequence[str]) -> None:
    """Refuse a command that is not there, by name."""
    known = (*CORE, *SCENE, *OWN)
    if argv[0] in known:
        return
    near = difflib.get_close_matches(argv[0], known, n=1)
    hint = f"Did you mean {near[0]}?" if near else f"It takes {', '.join(known)}."
    raise InputError(f"There is no command {argv[0]!r}. {hint}")


# Handing over


def hand_over(command: Sequence[str | Path], folder: Path | None = None) -> int:
    """Become ``command`` where the system can; else run it and return its exit status."""
    words = [str(word) for word in command]
    sys.stdout.flush()
    sys.stderr.flush()
    if os.name == "posix" and "bpy" not in sys.modules:  # signals then reach the right process
        os.chdir(folder or Path.cwd())
        os.execve(words[0], words, environment.clean_environ())
    with subprocess.Popen(words, env=environment.clean_environ(), cwd=folder) as child:
        # The child gets Ctrl-C too and answers by itself. Only now, or it would inherit this.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    status = child.returncode
    return status if status >= 0 else 128 - status


def say(text: str, share: float) -> None:
    """A line of the set-up's progress."""
    print(f"set-up {share:4.0%}  {text}", file=sys.stderr, flush=True)


def launch(argv: list[str]) -> int:
    """Carry out a command line under plain Python: the exit status."""
    if not argv or argv[0] in ("-h", "--help", "help"):
        print((__doc__ or "").strip())
        return 0 if argv else 2
    check_command(argv)
    if sys.version_info < (3, 11):  # no tomllib: go on under the Python that is needed anyway
        return hand_over([environment.find_python(), Path(__file__).resolve(), *argv])
    if argv[0] in OWN:
        own = {"doctor": doctor, "setup": setup, "package": package, "test": test, "python": python}
        return own[argv[0]](argv[1:])
    if is_blenders(argv):
        python_path = environment.ensure(ROOT, ("blender",), say)
        return hand_over([python_path, Path(__file__).resolve(), "--scene", *argv])
    core, blender = split(argv)
    check_targets(blender)
    python_path = environment.ensure(ROOT, ("blender",) if blender else (), say)
    if core:
        return hand_over([python_path, Path(__file__).resolve(), "--inside", *argv])
    return hand_over([python_path, Path(__file__).resolve(), "--finish", json.dumps(blender)])


def setup(arguments: list[str]) -> int:
    """Make the environment, with the groups that are named."""
    flags = {word for word in arguments if word in ("--renew", "--allow-cuda")}
    groups = [word for word in arguments if word not in flags]
    wrong = [word for word in groups if word not in ("blender", "test")]
    if wrong:
        raise InputError(f"setup has no {wrong[0]!r}, but blender, test, --renew, --allow-cuda.")
    cuda, renew = "--allow-cuda" in flags, "--renew" in flags
    print(environment.ensure(ROOT, groups, say, allow_cuda=cuda, renew=renew))
    return 0


def test(arguments: list[str]) -> int:
    """Run pytest over the core's and the add-on's tests."""
    python_path = environment.ensure(ROOT, ("blender", "test"), say)
    return hand_over([python_path, "-m", "pytest", *arguments], ROOT)


def package(arguments: list[str]) -> int:
    """Build the extension's zip with Blender's own builder, and validate it."""
    out, rest = take(arguments, "--out")
    if rest:
        raise InputError(f"package takes --out FOLDER alone, and got {rest[0]!r}.")
    folder = Path(out or ROOT / "out").expanduser().absolute()
    if not next(path for path in (folder, *folder.parents) if path.exists()).is_dir():
        raise InputError(f"--out is {folder}, which is no folder. Name one, or a new one.")
    builder = environment.find_builder(environment.ensure(ROOT, ("blender",), say))
    with tempfile.TemporaryDirectory() as temporary:
        source = Path(temporary) / "fantasia3d"
        fill_package(source)
        use_builder([*builder, "build", f"--source-dir={source}"], temporary)
        (made,) = Path(temporary).glob("*.zip")
        use_builder([*builder, "validate", made], temporary)
        folder.mkdir(parents=True, exist_ok=True)
        print(shutil.copy(made, folder))
    return 0


def use_builder(command: Sequence[str | Path], folder: str) -> None:
    """Run Blender's builder in ``folder``, where what it builds comes to lie."""
    environ = environment.clean_environ()
    done = subprocess.run(command, env=environ, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise InputError(f"Blender's builder refuses: {(done.stdout + done.stderr).strip()}")


def fill_package(folder: Path) -> None:
    """What the zip holds: the add-on, with the manifest's name for Blender, and the core inside."""
    junk = shutil.ignore_patterns("__pycache__", "*.pyc", "tests")
    # How the built-in prior was trained: a run uses nothing of it.
    training = shutil.ignore_patterns("__pycache__", "*.pyc", "tests", "prior")
    shutil.copytree(ROOT / "fantasia3d_addon", folder, ignore=junk)
    # In a folder of its own: Python would take a module beside the core for a library of its name.
    shutil.copytree(ROOT / "core", folder / "method" / "core", ignore=training)
    shutil.copy(ROOT / "pyproject.toml", folder / "method")
    for name, to in (("manifest.toml", "blender_manifest.toml"), ("LICENSE", "LICENSE")):
        shutil.copy(ROOT / name, folder / to)


def python(arguments: list[str]) -> int:
    """Run the environment's Python."""
    return hand_over([environment.ensure(ROOT, (), say), *arguments])


# Inside the environment


class Heard(io.StringIO):
    """Standard output that is remembered too: the core's last line is the asset's folder."""

    def __init__(self, stream: TextIO) -> None:
        super().__init__()
        self.stream = stream

    def write(self, text: str) -> int:
        self.stream.write(text)
        return super().write(text)

    def flush(self) -> None:
        self.stream.flush()

    def isatty(self) -> bool:
        return self.stream.isatty()

    def fileno(self) -> int:
        return self.stream.fileno()


def inside(argv: list[str]) -> int:
    """Carry out a command of the core's in this process; become Blender's part afterwards."""
    from core.command_line import main

    core, blender = split(argv)
    if not blender:
        return main(core)
    heard = Heard(sys.stdout)
    with contextlib.redirect_stdout(heard):
        status = main(core)
    if status:
        return status
    asset = Path(heard.getvalue().strip().splitlines()[-1])
    job = json.loads((asset.parent / "job.json").read_text(encoding="utf-8"))
    order = json.dumps({**blender, "asset": str(asset), "light": job.get("light")})
    return hand_over([sys.executable, Path(__file__).resolve(), "--finish", order])


def finish(order: str) -> NoReturn:
    """Import an asset with the bpy module, save the scene and render it, as ``order`` says."""
    from fantasia3d_addon.cli import headless

    wishes = json.loads(order)
    asset = Path(wishes.pop("asset"))
    leave(headless.finish(asset, **wishes) or 0)


def leave(status: int) -> NoReturn:
    """End the process at once: bpy may hang or crash at an ordinary exit."""
    blender = sys.modules.get("bpy")
    if blender:  # which would have done this itself
        shutil.rmtree(blender.app.tempdir, ignore_errors=True)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


# Under Blender


def under_blender(argv: list[str]) -> int:
    """Carry out a command line inside Blender, whose own scene takes the asset."""
    if not argv or argv[0] in (*OWN, "-h", "--help", "help"):
        return launch(argv)
    check_command(argv)
    if is_blenders(argv):
        from fantasia3d_addon.cli import headless

        return headless.command(argv)
    core, blender = split(argv)
    check_targets(blender)
    python_path = environment.ensure(ROOT, (), say)
    if core and argv[0] not in JOBS:
        return hand_over([python_path, Path(__file__).resolve(), "--inside", *argv])
    from fantasia3d_addon.cli import headless

    if core:
        # Blender's own handler is no Python function, and could not be put back after the job.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        return headless.main(argv, python_path, ROOT)
    return headless.finish(Path(blender["asset"]), blend=blender["blend"]) or 0


def doctor(arguments: list[str]) -> int:
    """Print what is here and what is missing; 0 when ``generate`` can run at once, else 3."""
    if arguments:
        raise InputError(f"doctor takes no arguments, and got {arguments[0]!r}.")
    lines = environment.examine(ROOT)
    for line in lines:
        print(f"{line.name:<17} {line.state:<8} {line.text}")
    missing = [line.name for line in lines if line.state == "MISSING"]
    print(f"\nMissing: {', '.join(missing)}." if missing else "\nEverything is here.")
    return 3 if missing else 0


def main(argv: list[str]) -> int:
    """Carry out a command line wherever this runs: the exit status."""
    try:
        if argv[:1] == ["--inside"]:
            return inside(argv[1:])
        if argv[:1] == ["--finish"]:
            finish(argv[1])
        if argv[:1] == ["--scene"]:
            from fantasia3d_addon.cli import headless

            leave(headless.command(argv[1:]) or 0)
        return under_blender(argv) if "bpy" in sys.modules else launch(argv)
    except (InputError, environment.SetupError) as error:
        print(f"error: {error}", file=sys.stderr)
        return error.status
    except KeyboardInterrupt:
        print("Cancelled.", file=sys.stderr)
        return 130


def show_panel() -> None:
    """Enable the add-on of this tree in the Blender window that this runs in, for its session."""
    import fantasia3d_addon

    fantasia3d_addon.register()


if __name__ == "__main__":
    blender = sys.modules.get("bpy")
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if blender and not words and not blender.app.background:
        show_panel()
    elif blender:
        leave(main(words))
    else:
        sys.exit(main(sys.argv[1:]))
