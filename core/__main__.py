"""The core's command line: ``python -m core COMMAND …`` (see ``--help``).

Exit status: 0 done; 2 the user's input; 3 something is missing; 4 out of memory; 5 no surface
could be kept; 130 cancelled.
"""

import argparse
import difflib
import json
import os
import signal
import sys
import time
import traceback
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from core.errors import MemoryShortError, UserError

if TYPE_CHECKING:  # torch takes seconds to load: a wrong option must not wait for it
    from core.generate import Inputs
    from core.io.job import Job
    from core.io.run_folder import RunFolder


BEGIN = time.time()  # a wish to cancel that is older than this was meant for an earlier session


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one sentence, with the nearest word that is right."""

    def error(self, message: str) -> NoReturn:
        raise UserError(f"{message[:1].upper()}{message[1:]}.", f"See: run.py {self.prog} --help")


def parser() -> Parser:
    """All commands and their options."""
    top = Parser(prog="", usage="run.py COMMAND …", description=__doc__, allow_abbrev=False)
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def add(name: str, text: str) -> Parser:
        return commands.add_parser(name, help=text, description=text, allow_abbrev=False)

    generate = add("generate", "Text in, a textured mesh out.")
    generate.add_argument("prompt")
    generate.add_argument("--guide", metavar="MESH", help="start from this shape")
    generate.add_argument(
        "--guide-strength", type=float, metavar="0..1", help="0: a start only; 1: keep the shape"
    )
    texture = add("texture", "A material for your own mesh; its uv is kept if it has one.")
    texture.add_argument("mesh")
    texture.add_argument("prompt")
    texture.add_argument(
        "--uv", metavar="auto|keep", help="keep: take the mesh's own, even where faces share texels"
    )
    texture.add_argument(
        "--base-color", metavar="FILE|mesh", help="start from this picture, or the mesh's own"
    )
    texture.add_argument(
        "--strength", type=float, metavar="0..1", help="0: a start only; 1: keep the base colour"
    )
    for command in (generate, texture):
        _add_job_options(command)

    resume = add("resume", "Go on with a run that was cancelled or died.")
    resume.add_argument("run", type=Path)

    render = add("render", "A picture of an asset under a light.")
    render.add_argument("asset", type=Path)
    render.add_argument("--light", default="studio", metavar="FILE|NAME")
    render.add_argument("--azimuth-deg", type=float, default=30.0, help="0 is the front")
    render.add_argument("--elevation-deg", type=float, default=20.0)
    render.add_argument("--fovy-deg", type=float, default=40.0)
    render.add_argument("--distance", type=float, metavar="METRES", help="default: see all of it")
    render.add_argument("--size", type=int, default=512, help="pixels")
    render.add_argument("--map", default="shaded", help="shaded, normal, base_color, roughness, …")
    render.add_argument("--out", type=Path, required=True, metavar="FILE.png|FILE.exr")

    inspect = add("inspect", "The health of an asset or a mesh, as JSON.")
    inspect.add_argument("path", type=Path, metavar="ASSET|MESH")

    export = add("export", "An asset as one file for another program.")
    export.add_argument("asset", type=Path)
    export.add_argument("--format", required=True, help="glb or obj; run.py also blend, usd, fbx")
    export.add_argument("--out", type=Path, required=True, metavar="FILE")

    bench = add("bench", "Measure this machine.")
    bench.add_argument("names", nargs="*", metavar="NAME")
    bench.add_argument("--json", type=Path, metavar="FILE")
    bench.add_argument("--nouns", nargs="*", default=[], metavar="NOUN", help="of prior: which")
    bench.add_argument("--seeds", type=int, default=2, help="of prior: runs of each noun")
    bench.add_argument("--out", type=Path, metavar="FOLDER", help="of prior: where the runs go")
    return top


def _add_job_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("--out", type=Path, metavar="RUN", help="the run folder")
    command.add_argument("--seed", type=int)
    command.add_argument("--preset", help="draft, standard or paper")
    command.add_argument(
        "--negative", dest="negative_prompt", metavar="TEXT", help='"": none, not the default text'
    )
    command.add_argument("--guidance", metavar="builtin|FOLDER|HUB-ID")
    command.add_argument(
        "--ignore-unknown-words",
        action="store_true",
        help="leave out what the built-in prior does not know, instead of refusing it",
    )
    command.add_argument("--light", metavar="FILE|NAME")
    command.add_argument("--texture-size", type=int, metavar="N")
    command.add_argument("--max-faces", type=int, metavar="N")
    command.add_argument("--device", metavar="auto|cpu|cuda|mps")
    command.add_argument("--set", action="append", default=[], metavar="stage.field=value")


def parse(argv: list[str]) -> argparse.Namespace:
    """The options of ``argv``; a misspelt one is named, with the nearest that there is."""
    top = parser()
    args, unknown = top.parse_known_args(argv)
    if unknown:
        command = next(a for a in top._actions if isinstance(a, argparse._SubParsersAction))
        known = [o for a in command.choices[args.command]._actions for o in a.option_strings]
        near = difflib.get_close_matches(unknown[0].split("=")[0], known, n=1)
        hint = f"Did you mean {near[0]}?" if near else f"See: run.py {args.command} --help"
        raise UserError(f"{args.command} has no option {unknown[0]!r}.", hint)
    return args


def job_of(args: argparse.Namespace) -> "Job":
    """The Job that ``generate`` or ``texture`` asks for; its paths are made absolute."""
    from core.io.job import Job

    given = {
        "command": args.command,
        "prompt": args.prompt,
        "mesh": _absolute(getattr(args, "mesh", "")),
        "guide_mesh": _absolute(getattr(args, "guide", None) or ""),
        "guide_strength": getattr(args, "guide_strength", getattr(args, "strength", None)),
        "uv": getattr(args, "uv", None),
        "ignore_unknown_words": args.ignore_unknown_words,
        "settings": dict(_setting(text) for text in args.set),
    }
    for name in ("seed", "preset", "negative_prompt", "texture_size", "max_faces", "device"):
        given[name] = getattr(args, name)
    if args.negative_prompt == "":  # given, and empty: no negative prompt, not the default text
        given["settings"] = {"guidance.default_negative": "false"} | given["settings"]
    for name in ("guidance", "light", "base_color"):
        value = getattr(args, name, None)
        given[name] = _absolute(value) if value and Path(value).exists() else value
    return Job(**{key: value for key, value in given.items() if value is not None})


def _absolute(path: str) -> str:
    return str(Path(path).expanduser().resolve()) if path else ""


def _setting(text: str) -> tuple[str, str]:
    key, equals, value = text.partition("=")
    if not equals:
        raise UserError(f"--set {text!r} has no value.", "Write --set geometry.fine.steps=100.")
    return key.strip(), value.strip()


def run_job(run: "RunFolder", inputs: "Inputs | None") -> None:
    """Carry out ``run`` from where it stands; its events end with one last word.

    ``inputs`` are loaded here where they are None, so that what is wrong with them is an event.
    """
    from core.generate import generate, prepare

    path, wish = run.path, run.path / "cancel"
    signal.signal(signal.SIGINT, lambda *_: run.interrupt())
    signal.signal(signal.SIGTERM, lambda *_: run.interrupt())
    if wish.exists() and wish.stat().st_mtime < BEGIN:
        wish.unlink()
    run.say("started", pid=os.getpid())
    try:
        asset = generate(run, inputs or prepare(run.job))
    except UserError as error:
        kind = "cancelled" if error.status == 130 else "error"
        with suppress(OSError):  # a full disk takes no last word
            run.say(kind, text=error.text, fix=error.fix or None)
        raise
    except BaseException as error:
        known = _known(error)
        text, fix = (known.text, known.fix) if known else (f"{type(error).__name__}: {error}", "")
        with suppress(OSError):
            run.say("error", text=text, fix=fix or f"This is a bug. Read {path / 'log.txt'}.")
        if known:
            raise known from error
        with (path / "log.txt").open("a", encoding="utf-8") as log:
            traceback.print_exc(file=log)
        raise
    run.say("done", path="asset", text=f"{asset} is complete.")
    print(asset, flush=True)


def _known(error: BaseException) -> UserError | None:
    """An error of the machine as a sentence: memory and disk."""
    told = "allocate memory" in str(error) or type(error).__name__ == "OutOfMemoryError"
    if told or isinstance(error, MemoryError):
        return MemoryShortError(
            "There is not enough memory for this job.",
            "Lower geometry.views_at_once and appearance.views_at_once with --set, "
            "or take the draft preset; then resume.",
        )
    if isinstance(error, OSError) and error.errno is not None:
        place = f" {error.filename}" if error.filename else ""
        return UserError(
            f"The disk refused{place}: {error.strerror}.", "Free some space or take another --out."
        )
    return None


def main(argv: list[str]) -> int:
    """Carry out one command; the exit status."""
    try:
        args = parse(argv)
        _COMMANDS[args.command](args)
    except UserError as error:
        print(f"{'' if error.status == 130 else 'error: '}{error}", file=sys.stderr)
        return error.status
    except KeyboardInterrupt:
        print("Cancelled.", file=sys.stderr)
        return 130
    except BrokenPipeError:
        return 0
    return 0


def _job(args: argparse.Namespace) -> None:
    from core.generate import prepare
    from core.io.run_folder import RunFolder

    job = job_of(args)
    inputs = prepare(job)  # what is wrong is said before anything is written
    run_job(RunFolder.create(args.out or Path("out") / _slug(job.prompt), job), inputs)


def _slug(prompt: str) -> str:
    """A folder name for a prompt: its letters and digits, of any script; numbered if taken."""
    words = "".join(c if c.isalnum() else " " for c in prompt.lower()).split()
    name = "-".join(words)[:40].strip("-") or "asset"
    number = 1
    while (Path("out") / (name if number == 1 else f"{name}-{number}")).exists():
        number += 1
    return name if number == 1 else f"{name}-{number}"


def _resume(args: argparse.Namespace) -> None:
    from core.io.run_folder import RunFolder

    run_job(RunFolder.open(args.run), None)


def _render(args: argparse.Namespace) -> None:
    from core.picture import render_asset

    options = {key: value for key, value in vars(args).items() if key != "command"}
    render_asset(options.pop("asset"), options.pop("out"), **options)


def _inspect(args: argparse.Namespace) -> None:
    from core.io.asset import inspect

    print(json.dumps(inspect(args.path), indent=1, ensure_ascii=False))


def _export(args: argparse.Namespace) -> None:
    from core.io.asset import export

    export(args.asset, args.format, args.out)


def _bench(args: argparse.Namespace) -> None:
    from core.benchmarks import bench

    if args.names == ["prior"]:  # hours, and folders of runs: never one of several
        from core.benchmarks.bench_prior import bench_prior

        bench_prior(args.nouns, args.seeds, args.out, args.json)
    else:
        bench(args.names, args.json)


_COMMANDS = {
    "generate": _job,
    "texture": _job,
    "resume": _resume,
    "render": _render,
    "inspect": _inspect,
    "export": _export,
    "bench": _bench,
}

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
