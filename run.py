#!/usr/bin/env python3
"""Fantasia3D for Blender from the command line: text in, a textured mesh in a Blender scene out.

    python3 run.py COMMAND ...
    blender -b --python-exit-code 1 --python run.py -- COMMAND ...
    blender --python run.py            a window, with the panel in the sidebar (tab Fantasia3D)

Commands:
    generate "PROMPT"          make an asset; --out RUN, --blend FILE, --render FILE, --seed N, ...
    texture MESH "PROMPT"      a material for your own mesh; the same options
    resume RUN                 continue a run that was cancelled or interrupted; --blend, --render;
                               --ray-jobs http://HOST:8265: on a Ray cluster
    explore "PROMPT" --out DIR quick shapes from several seeds; resume finishes one
    recolor RUN --out DIR      quick materials for the shape of a run; resume finishes one
    edit ASSET "WORDS" --faces FILE     another material on some faces; the rest stays
                                        (--shape: another shape, within the same triangles)
    batch TABLE --out DIR      an asset for each row of a CSV or text file; repeat it to complete it
    node --head | --join HOST:PORT      this machine as part of a Ray cluster, for batch --ray
                                        (--jobs: also for Blender and resume --ray-jobs)
    render ASSET --out FILE    a picture of an asset under a light
    inspect ASSET|MESH         the mesh's health as JSON
    verify ASSET               make it again from its own record, and compare the files
    export ASSET --format blend|glb|usd|fbx|obj|stl|3mf --out FILE
    export ASSET --format urdf|mjcf|usd-physics --out FILE      for simulators, with its mass
    export ASSET --format godot|unity|unreal --out FOLDER       for an engine, with colliders
    lod ASSET --max-faces N --out FILE     fewer triangles, the UVs kept; or --levels and --ratio
    remesh ASSET --max-faces N --out FILE  quads, with maps of their own
    relight ASSET --light NAME|FILE --render FILE [--turntable FILE.mp4] [--material gold]
    physics ASSET --physics rigid|soft|cloth|drape --frames N --render FILE [--blend FILE]
    cornell ASSET... --render FILE
    report RUN --out FILE      a run as one HTML file that needs no network
    reproduce [--figure NAME]  the paper's figures, on a page; --list, --quick, --page FILE
    words "PROMPT"             what the built-in model understands, as JSON; makes nothing
    models [FOLDER...]         the Stable Diffusion models in folders, and which can be used
    bench [NAME...]            measure this machine
    doctor                     what is installed, what is missing, how to fix it; --report FILE
    setup [blender] [test] [ray]        make the Python environment now; --renew, --allow-cuda
    package [--out FOLDER]     the extension for Blender, as a zip
    test [PYTEST ARGUMENTS]    run the tests
    python [ARGUMENTS]         the environment's Python

COMMAND --help lists a command's options. The first run makes an environment for the method's
Python packages in your data folder (about 3 GB; `doctor` shows where).

Exit codes: 0 done; 2 invalid input; 3 something is not installed or not found; 4 out of memory;
5 no surface could be kept; 6 some assets of a batch failed; 7 another process of the same asset
ended; 130 cancelled.
"""

# ruff: noqa: E402 - Ctrl-C is handled before all the rest is loaded

from __future__ import annotations

import os
import signal
import sys


def handle_ctrl_c() -> None:
    """End at Ctrl-C from now on with one line, while there is nothing to clean up.

    A process that this file became (``hand_over``) starts with the signal held back.
    """
    if signal.getsignal(signal.SIGINT) == signal.default_int_handler:
        signal.signal(signal.SIGINT, _end)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])


def _end(*_: object) -> None:
    os.write(2, b"Cancelled.\n")
    os._exit(130)


if __name__ == "__main__" and "bpy" not in sys.modules:  # Blender has a handler of its own
    handle_ctrl_c()

import difflib
import json
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

ROOT = Path(__file__).resolve().parent
if str(ROOT) not in sys.path:  # Blender runs this file without its folder
    sys.path.insert(0, str(ROOT))

# Standard library only, no bpy:
from core import terminal
from core.errors import UserError
from fantasia3d_addon import environment
from fantasia3d_addon.blender.output import is_of_asset

if TYPE_CHECKING:
    from argparse import Namespace

    from core.options import Commands

OWN = ("doctor", "setup", "package")
IN_BLENDER = ("-b", "--python-exit-code", "1", "--python")  # then this file, --, a command line
GROUPS = ("blender", "test", "ray")  # of packages beyond the core's
PASS_ON = ("test", "python")  # whose arguments belong to another program
PICTURES = (".png", ".jpg", ".jpeg", ".exr", ".tif", ".tiff", ".webp")


# The command line


def parser() -> Commands:
    """Every command and its options: the core's, Blender's and this file's, each declared once."""
    from core.options import Commands, add_core_commands
    from fantasia3d_addon.cli.parser import add_blender_commands

    commands = Commands((__doc__ or "").partition("\n")[0])
    add_core_commands(commands)
    add_blender_commands(commands)
    doctor = commands.add("doctor", "What is installed, what is missing, how to fix it.")
    doctor.add_argument(
        "--report",
        type=Path,
        metavar="FILE",
        help="write it all to a file, without anything private",
    )
    setup = commands.add("setup", "Make the Python environment now.")
    setup.add_argument(
        "groups", nargs="*", metavar="|".join(GROUPS), help="packages beyond the core's"
    )
    setup.add_argument("--renew", action="store_true", help="make it again from nothing")
    setup.add_argument("--allow-cuda", action="store_true", help="use torch's CUDA build")
    package = commands.add("package", "The extension for Blender, as a zip.")
    package.add_argument("--out", type=Path, default=ROOT / "out", metavar="FOLDER")
    return commands


def parse(argv: Sequence[str]) -> Namespace:
    """The options of ``argv``.

    Raises:
        UserError: a command or an option that does not exist, with the nearest that does; a path in
            the home of nobody; a file that could not be written after an hour's work.
    """
    from fantasia3d_addon.cli import parser as route

    commands = parser()
    names = (*commands.names, *PASS_ON)
    if argv[0] not in names:
        near = difflib.get_close_matches(argv[0], names, n=1)
        hint = f"Did you mean {near[0]}?" if near else f"Use one of {', '.join(names)}."
        raise UserError(f"There is no command {argv[0]!r}.", hint)
    args = commands.parse(argv)
    if homeless := route.unknown_home(args):
        raise UserError(*homeless)
    for name, endings in (("blend", (".blend",)), ("render", PICTURES)):
        path = getattr(args, name, None)
        if path:
            check_target(f"--{name}", path, endings)
    if getattr(args, "until", None) and route.imports_asset(args):
        raise UserError(
            "--until pauses before there is an asset for --blend or --render.",
            "Use them with the run.py resume that finishes it.",
        )
    if route.saves_blend(args):
        check_target("--out", args.out, (".blend",))
    return args


def check_target(option: str, path: Path, endings: Sequence[str]) -> None:
    """Raise UserError for a wrong ending, a folder, or a place that cannot be written."""
    if path.suffix.lower() not in endings:
        raise UserError(f"{option} is {str(path)!r}.", f"Its name ends in {endings[0]}.")
    full = path.absolute()
    fix = "Name a file in a folder of yours."
    try:
        place = next(p for p in full.parents if p.exists())
        as_it_is = os.access in os.supports_effective_ids
        may = os.access(str(place), os.W_OK, effective_ids=as_it_is)
        if full.is_dir() or not place.is_dir() or not may:
            raise UserError(f"{full} cannot be written.", fix)
        if is_of_asset(full):
            raise UserError(f"{full} is a file of the asset itself.", "Name another file.")
    except OSError as error:  # a name that is too long
        raise UserError(f"{full} cannot be written: {error.strerror}.", fix) from None


# Handing over


def hand_over(command: Sequence[str | Path], folder: Path | None = None) -> int:
    """Become ``command`` where the system can; else run it and return its exit code."""
    ours = str(Path(__file__).resolve()) in map(str, command[1:2])
    words = [str(word) for word in command]
    code = terminal.close_output()
    if code:
        return code
    if os.name == "posix" and "bpy" not in sys.modules:  # signals then reach the right process
        os.chdir(folder or Path.cwd())
        if ours:  # Python's own start would answer Ctrl-C by a traceback: handle_ctrl_c lets it in
            signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
        os.execve(words[0], words, environment.clean_environ())
    with subprocess.Popen(words, env=environment.clean_environ(), cwd=folder) as child:
        # The child gets Ctrl-C too and answers by itself. Only now, or it would inherit this.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    code = child.returncode
    return code if code >= 0 else 128 - code


def show_progress(text: str, fraction: float) -> None:
    """Print a line of the set-up's progress."""
    terminal.complain(f"set-up {fraction:4.0%}  {text}")


def launch(argv: list[str]) -> int:
    """Carry out a command line under plain Python: the exit code."""
    if not argv or argv[0] in ("-h", "--help", "help"):
        terminal.put((__doc__ or "").strip())
        return 0 if argv else 2
    if sys.version_info < (3, 11):  # no tomllib: go on under the Python that is needed anyway
        return hand_over([environment.find_python(), Path(__file__).resolve(), *argv])
    if argv[0] in PASS_ON:
        return {"test": test, "python": python}[argv[0]](argv[1:])
    from fantasia3d_addon.cli import parser as route

    args = parse(argv)
    if args.command in OWN:
        return {"doctor": doctor, "setup": setup, "package": package}[args.command](args)
    blender = route.runs_in_blender(args) or route.imports_asset(args)
    core = not route.runs_in_blender(args)
    clustered = args.command == "node" or getattr(args, "ray", None)
    if blender and (version := environment.module_version(ROOT)):
        command = [*environment.find_blender(version), *IN_BLENDER, Path(__file__).resolve()]
        return hand_over([*command, "--", *argv])
    groups = ("blender",) if blender else ("ray",) if clustered else ()
    python_path = environment.ensure(ROOT, groups, show_progress, runs_core=core)
    return hand_over([python_path, Path(__file__).resolve(), "--inside", *argv])


def setup(args: Namespace) -> int:
    """Make the environment, with the groups that are named."""
    wrong = [name for name in args.groups if name not in GROUPS]
    if wrong:
        fix = f"Use {', '.join(GROUPS)}, --renew, --allow-cuda."
        raise UserError(f"setup has no {wrong[0]!r}.", fix)
    terminal.put(
        environment.ensure(
            ROOT, args.groups, show_progress, allow_cuda=args.allow_cuda, renew=args.renew
        )
    )
    return 0


def test(arguments: list[str]) -> int:
    """Run pytest over the core's and the add-on's tests."""
    # Without a bpy module Blender's tests are left out.
    groups = ("test",) if environment.module_version(ROOT) else ("blender", "test")
    python_path = environment.ensure(ROOT, groups, show_progress)
    # The whole suite runs in several processes; the tests of a file share their fixtures.
    spread = () if arguments else ("-n", str(test_processes()), "--dist", "loadfile")
    return hand_over([python_path, "-m", "pytest", *spread, *arguments], ROOT)


def test_processes() -> int:
    """One more than the usable cores, as tests also wait for processes and clocks; at most one per
    3 GB of memory, as each loads torch and Blender."""
    cores = len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1
    memory = 4e9 * cores
    if hasattr(os, "sysconf"):
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return max(1, min(cores + 1, int(memory / 3e9)))


def package(args: Namespace) -> int:
    """Build the extension's zip with Blender's own builder, and validate it."""
    from core.io.atomic import atomic_file, check_folder, disk_errors

    folder = args.out.absolute()
    if not next(path for path in (folder, *folder.parents) if path.exists()).is_dir():
        raise UserError(
            f"--out is {folder}, which is not a folder.", "Name a folder, or a new one."
        )
    check_folder(folder)
    builder = environment.find_builder(
        environment.ensure(ROOT, ("blender",), show_progress, runs_core=False)
    )
    with tempfile.TemporaryDirectory() as temporary:
        source = Path(temporary) / "fantasia3d"
        fill_package(source)
        use_builder([*builder, "build", f"--source-dir={source}"], temporary)
        (made,) = Path(temporary).glob("*.zip")
        use_builder([*builder, "validate", made], temporary)
        with disk_errors(folder):
            folder.mkdir(parents=True, exist_ok=True)
        with atomic_file(folder / made.name) as new:
            shutil.copy(made, new)
    terminal.put(folder / made.name)
    return 0


def use_builder(command: Sequence[str | Path], folder: str) -> None:
    """Run Blender's builder in ``folder``, where it writes its output."""
    environ = environment.clean_environ()
    done = subprocess.run(command, env=environ, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise UserError(f"Blender's builder failed: {(done.stdout + done.stderr).strip()}")


def fill_package(folder: Path) -> None:
    """Fill the zip's folder: the add-on, with the manifest's name for Blender, and the core."""
    junk = shutil.ignore_patterns("__pycache__", "*.pyc", "tests")
    # The training of the built-in prior: a run uses nothing of it.
    training = shutil.ignore_patterns("__pycache__", "*.pyc", "tests", "prior")
    shutil.copytree(ROOT / "fantasia3d_addon", folder, ignore=junk)
    # In a folder of its own: Python would import a module next to the core as a library.
    shutil.copytree(ROOT / "core", folder / "method" / "core", ignore=training)
    for name in ("pyproject.toml", "requirements.lock"):
        shutil.copy(ROOT / name, folder / "method")
    for name, to in (("manifest.toml", "blender_manifest.toml"), ("LICENSE", "LICENSE")):
        shutil.copy(ROOT / name, folder / to)


def python(arguments: list[str]) -> int:
    """Run the environment's Python."""
    return hand_over([environment.ensure(ROOT, (), show_progress), *arguments])


# Inside the environment


def inside(argv: list[str], only_core: bool = False) -> int:
    """Carry out a command in this process, then pass its asset to Blender's part."""
    from core.command_line import carry_out
    from fantasia3d_addon.cli import parser as route

    args = parse(argv)
    if route.runs_in_blender(args):
        leave(in_blender(args))
    made: list[Path | None] = []
    code = terminal.exit_code(lambda: made.append(carry_out(args)))
    if code or only_core or not route.imports_asset(args):
        return code
    # In a process of its own: Blender's should not contain torch and the training's memory.
    request = {"asset": str(made[0]), "blend": args.blend, "render": args.render}
    order = json.dumps({key: str(value) for key, value in request.items() if value})
    return hand_over([sys.executable, Path(__file__).resolve(), "--finish", order])


def in_blender(args: Namespace) -> int:
    """Carry out a command of Blender's, in this process: the exit code."""
    from fantasia3d_addon.cli import headless, parser

    if parser.saves_blend(args):
        return headless.finish(args.asset, blend=args.out)
    return headless.command(args)


def finish(order: str) -> NoReturn:
    """Import an asset with the bpy module, save the scene and render it, as ``order`` states."""
    from fantasia3d_addon.cli import headless

    request = json.loads(order)
    leave(headless.finish(Path(request["asset"]), request.get("blend"), request.get("render")))


def leave(code: int) -> NoReturn:
    """End the process at once: bpy may hang or crash at an ordinary exit."""
    blender = sys.modules.get("bpy")
    if blender:  # which would have done this itself
        from fantasia3d_addon.cli.session_folder import remove_session_folder

        remove_session_folder(blender)
    unwritten = terminal.close_output()
    os._exit(code or unwritten)


# Under Blender


def under_blender(argv: list[str]) -> int:
    """Carry out a command line inside Blender, whose own scene takes the asset."""
    if not argv or argv[0] in (*OWN, *PASS_ON, "-h", "--help", "help"):
        return launch(argv)
    from core.command_line import JOBS, default_run_folder
    from fantasia3d_addon.cli import headless
    from fantasia3d_addon.cli import parser as route

    args = parse(argv)
    if route.runs_in_blender(args):
        return in_blender(args)
    python_path = environment.ensure(ROOT, (), show_progress)
    core = [python_path, Path(__file__).resolve()]
    if args.command not in JOBS:
        return hand_over([*core, "--inside", *argv])
    # The run's folder is chosen here, so that its asset is known without asking the core.
    more: list[str] = []
    folder = args.run if args.command == "resume" else args.out
    if folder is None:
        folder = default_run_folder(args.prompt)
        more = ["--out", str(folder)]
    # Blender's own handler is not a Python function, and could not be put back after the job.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    command = [*core, "--core", *argv, *more]
    return headless.run_job(command, folder / "asset", args.blend, args.render)


def doctor(args: Namespace) -> int:
    """Print what is installed and what is missing; 0 when ``generate`` can run at once, else 3."""
    lines = environment.examine(ROOT)
    if args.report:
        file = environment.write_report(args.report, ROOT, lines)
        terminal.put(f"The report is {file}. It contains no names, paths, prompts or secrets.\n")
    for line in lines:
        terminal.put(f"{line.name:<17} {line.state:<8} {line.text}")
    missing = [line.name for line in lines if line.state == "MISSING"]
    terminal.put(f"\nMissing: {', '.join(missing)}." if missing else "\nEverything is installed.")
    return 3 if missing else 0


def main(argv: list[str]) -> int:
    """Carry out a command line wherever this runs: the exit code."""
    if "bpy" not in sys.modules and signal.getsignal(signal.SIGINT) == _end:
        # From here on there is something to clean up: an incomplete environment.
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        code = answer(argv)
    except (UserError, environment.SetupError) as error:
        terminal.complain(f"error: {error}")
        code = error.status
    except KeyboardInterrupt:
        terminal.complain("Cancelled.")
        code = 130
    except BrokenPipeError:  # the reader of a pipe had enough
        code = 0
    unwritten = terminal.close_output()
    return code or unwritten


def answer(argv: list[str]) -> int:
    """Carry out a command line, in this process or by another: the exit code."""
    if argv[:1] in (["--inside"], ["--core"]):
        return inside(argv[1:], only_core=argv[0] == "--core")
    if argv[:1] == ["--finish"]:
        finish(argv[1])
    return under_blender(argv) if "bpy" in sys.modules else launch(argv)


def show_panel() -> None:
    """Enable the add-on of this tree in the Blender window that this runs in, for its session."""
    import fantasia3d_addon

    fantasia3d_addon.register()


if __name__ == "__main__":
    terminal.open_streams()
    blender = sys.modules.get("bpy")
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if blender and not words and not blender.app.background:
        show_panel()
    elif blender:
        leave(main(words))
    else:
        terminal.end(lambda: main(sys.argv[1:]))
