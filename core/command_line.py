"""The core's commands: their options, declared once for ``python -m core`` and ``run.py``.

Standard library only until a command is carried out: torch takes seconds to load, and a wrong
option must not wait for it.

Exit codes: 0 done; 2 the user's input; 3 something is missing; 4 out of memory; 5 no surface could
be kept; 6 some assets of a batch failed; 7 another process of the same run ended; 130 cancelled.
"""

import argparse
import difflib
import json
import os
import sys
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, redirect_stdout, suppress
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from core.batch.options import add_batch_options, add_node_options
from core.errors import MissingError, Paused, UserError
from core.interrupt import asks_to_stop, process_began
from core.terminal import exit_code, put, sentence_of

if TYPE_CHECKING:
    from core.batch.table import Row
    from core.generate import Inputs
    from core.io.job import Job
    from core.io.progress import Progress
    from core.io.run_folder import RunFolder


# A request to cancel that is older than this was meant for an earlier session.
START = process_began()
JOBS = ("generate", "texture", "resume")  # these end in an asset


class Parser(argparse.ArgumentParser):
    """Reports what is wrong in one sentence, as a UserError."""

    def error(self, message: str) -> NoReturn:
        raise UserError(f"{message[:1].upper()}{message[1:]}.", f"See: {self.prog} --help")


class Commands:
    """A parser to which each side adds its commands."""

    def __init__(self, description: str) -> None:
        self.parser = Parser(
            prog="run.py", usage="run.py COMMAND …", description=description, allow_abbrev=False
        )
        self._parsers = self.parser.add_subparsers(
            dest="command", required=True, metavar="COMMAND", prog="run.py"
        )

    def add(self, name: str, text: str) -> Parser:
        """A new command."""
        return self._parsers.add_parser(name, help=text, description=text, allow_abbrev=False)

    def __getitem__(self, name: str) -> Parser:
        return self._parsers.choices[name]

    @property
    def names(self) -> tuple[str, ...]:
        """All commands."""
        return tuple(self._parsers.choices)

    def parse(self, argv: Sequence[str]) -> argparse.Namespace:
        """The options of ``argv``; a misspelt one is named, with the nearest that there is."""
        args, unknown = self.parser.parse_known_args(argv)
        if unknown:
            known = [o for a in self[args.command]._actions for o in a.option_strings]
            near = difflib.get_close_matches(unknown[0].split("=")[0], known, n=1)
            fix = f"Did you mean {near[0]}?" if near else f"See: run.py {args.command} --help"
            raise UserError(f"{args.command} has no option {unknown[0]!r}.", fix)
        return args


def add_core_commands(commands: Commands) -> None:
    """The commands that the core carries out, and their options."""
    add = commands.add

    generate = add("generate", "Text in, a textured mesh out.")
    generate.add_argument("prompt")
    generate.add_argument("--guide", metavar="MESH", help="start from this shape")
    generate.add_argument(
        "--guide-strength", type=float, metavar="0..1", help="0: a start only; 1: keep the shape"
    )
    generate.add_argument(
        "--size", type=float, metavar="METRES", help="the longest side; default: the usual size"
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
        command.add_argument("--out", type=Path, metavar="RUN", help="the run folder")
        command.add_argument(
            "--color-seed", type=int, metavar="N", help="another material on the same shape"
        )
        _add_job_options(command)
        _add_gpus(command)

    edit = add("edit", "Another material on a part of an asset; all the rest stays bit for bit.")
    edit.add_argument("asset", type=Path, metavar="ASSET")
    edit.add_argument("prompt", help="the whole thing in the new material, or a part of it")
    edit.add_argument(
        "--faces", required=True, metavar="FILE", help="of mesh.obj: a number a line, from 0 on"
    )
    edit.add_argument("--out", type=Path, metavar="RUN", help="the run folder")
    _add_job_options(edit)

    explore = add(
        "explore", "Quick shapes of several seeds next to each other; resume finishes one."
    )
    explore.add_argument("prompt")
    explore.add_argument("--count", type=int, default=4, metavar="N", help="shapes; default 4")
    explore.add_argument("--out", type=Path, metavar="DIR", help="a run folder each, and a picture")
    explore.add_argument(
        "--size", type=float, metavar="METRES", help="the longest side; default: the usual size"
    )
    _add_job_options(explore)
    recolor = add("recolor", "Quick materials of several seeds for the shape of a run.")
    recolor.add_argument("run", type=Path, metavar="RUN", help="its shape is finished")
    recolor.add_argument("--count", type=int, default=4, metavar="N", help="materials; default 4")
    recolor.add_argument(
        "--out", type=Path, required=True, metavar="DIR", help="a run folder each, and a picture"
    )

    batch = add("batch", "An asset for each row of a table, as many at once as the machine allows.")
    add_batch_options(batch)
    _add_job_options(batch)
    add_node_options(add("node", "This machine as a node of a Ray cluster, for batch --ray."))

    resume = add("resume", "Go on with a run that was cancelled or died.")
    resume.add_argument("run", type=Path)
    _add_gpus(resume)
    resume.add_argument(
        "--end-with-stdin", action="store_true", help="end when the program that started it does"
    )
    for command in (generate, texture, resume):
        command.add_argument(
            "--until", metavar="shape|color", help="pause at a first look at it; resume finishes it"
        )

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

    verify = add("verify", "Make an asset again from what it records, and compare the files.")
    verify.add_argument("asset", type=Path)

    export = add("export", "An asset as one file for another program.")
    export.add_argument("asset", type=Path)
    export.add_argument(
        "--format",
        required=True,
        help="glb, obj, stl, 3mf, urdf, mjcf, usd-physics; run.py also blend, usd, fbx, and for an "
        "engine, into a folder, godot, unity, unreal",
    )
    export.add_argument("--out", type=Path, required=True, metavar="FILE|FOLDER")
    simulators = "urdf, mjcf, usd-physics"
    export.add_argument(
        "--mass", type=float, metavar="KG", help=f"{simulators}: default: volume times density"
    )
    export.add_argument(
        "--hulls", type=int, default=32, metavar="N", help=f"{simulators}: convex parts at most"
    )

    report = add("report", "A run as one HTML file, to read anywhere and without a network.")
    report.add_argument("run", type=Path)
    report.add_argument("--out", type=Path, metavar="FILE.html", help="default: RUN/report.html")

    words = add("words", "What the built-in prior understands of a prompt, as JSON.")
    words.add_argument("prompt", nargs="?", help="without one: all known words by group")
    words.add_argument(
        "--ignore-unknown-words", action="store_true", help="as generate with this option"
    )

    models = add("models", "The Stable Diffusion models in folders, and which can be used.")
    models.add_argument(
        "folders",
        nargs="*",
        type=Path,
        metavar="FOLDER",
        help="also a ComfyUI or A1111 folder; default: the hub's cache",
    )
    models.add_argument("--json", action="store_true", help="for programs")

    reproduce = add("reproduce", "The paper's figures again, on a page; continues if stopped.")
    reproduce.add_argument("--out", type=Path, default=Path("out/reproduction"), metavar="FOLDER")
    reproduce.add_argument("--page", type=Path, metavar="FILE.md", help="default: in --out")
    reproduce.add_argument("--figure", action="append", default=[], metavar="NAME", help="only it")
    reproduce.add_argument("--row", action="append", default=[], metavar="NAME", help="of a figure")
    reproduce.add_argument("--list", action="store_true", help="the figures and what is made")
    reproduce.add_argument("--quick", action="store_true", help="shortest settings, to try it")
    reproduce.add_argument("--guidance", metavar="builtin|FOLDER|HUB-ID")
    reproduce.add_argument("--at-once", type=int, metavar="N", help="runs; default: as many as fit")

    bench = add("bench", "Measure this machine.")
    bench.add_argument("names", nargs="*", metavar="NAME")
    bench.add_argument("--json", type=Path, metavar="FILE")
    folders = "prior, fit, distillation"  # the benches that make something of each noun
    bench.add_argument("--nouns", nargs="*", default=[], metavar="NOUN", help=f"{folders}: which")
    bench.add_argument("--seeds", type=int, default=2, help="of prior: runs of each noun")
    bench.add_argument(
        "--calls", type=int, default=60, help="of distillation: network calls of each view"
    )
    bench.add_argument("--out", type=Path, metavar="FOLDER", help=f"{folders}: where the runs go")
    _add_rehearsal_options(bench)
    bench.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="stage.field=value",
        help="of fit, distillation: over draft",
    )


def _add_job_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("--seed", type=int)
    command.add_argument("--preset", help="draft, standard or paper")
    command.add_argument(
        "--negative", dest="negative_prompt", metavar="TEXT", help='"": none, not the default text'
    )
    command.add_argument("--guidance", metavar="builtin|FOLDER|FILE|HUB-ID")
    command.add_argument(
        "--lora",
        action="append",
        default=[],
        metavar="FILE[:STRENGTH]",
        help="over a Stable Diffusion checkpoint; strength 1 is as it was trained",
    )
    command.add_argument(
        "--embedding",
        action="append",
        default=[],
        metavar="FILE",
        help="a textual inversion; write its file's name in the prompt",
    )
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


def _add_rehearsal_options(bench: argparse.ArgumentParser) -> None:
    of = "of guidance --architecture"
    bench.add_argument(
        "--architecture",
        metavar="sd15|sd21|sdxl",
        help="of guidance: with random weights",
    )
    bench.add_argument("--scale", default="full", metavar="full|tiny", help=f"{of}: its widths")
    bench.add_argument("--batch", type=int, default=24, metavar="N", help=f"{of}: views of a step")
    bench.add_argument("--chunk", type=int, default=4, metavar="N", help=f"{of}: views at a time")
    bench.add_argument("--device", default="auto", metavar="auto|cpu|cuda", help=of)


def _add_gpus(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--gpus", type=int, default=1, metavar="N", help="share each step's views among N GPUs"
    )


def parse(argv: Sequence[str]) -> argparse.Namespace:
    """The options of one of the core's commands."""
    commands = Commands(__doc__ or "")
    add_core_commands(commands)
    return commands.parse(argv)


def job_of(args: argparse.Namespace) -> "Job":
    """The Job that ``generate`` or ``texture`` asks for; its paths are made absolute."""
    from core.io.job import Job

    given = {
        "command": "generate" if args.command == "explore" else args.command,
        "prompt": args.prompt,
        "mesh": _absolute(getattr(args, "mesh", "")),
        "guide_mesh": _absolute(getattr(args, "guide", None) or ""),
        "guide_strength": getattr(args, "guide_strength", getattr(args, "strength", None)),
        "uv": getattr(args, "uv", None),
        "size_m": getattr(args, "size", None),
        "ignore_unknown_words": args.ignore_unknown_words,
        "settings": dict(_setting(text) for text in args.set),
        "loras": dict(_lora(text) for text in args.lora),
        "embeddings": [_absolute(path) for path in args.embedding],
    }
    given["color_seed"] = getattr(args, "color_seed", None)
    for name in ("seed", "preset", "negative_prompt", "texture_size", "max_faces", "device"):
        given[name] = getattr(args, name)
    for name, takes in (("texture_size", "64 to 8192 texels"), ("max_faces", "100 or more")):
        if given[name] == 0:  # which stands for the preset's own in job.json
            raise UserError(f"--{name.replace('_', '-')} is 0.", f"It takes {takes}.")
    if given["size_m"] == 0:
        raise UserError("--size is 0.", "It takes metres, such as 0.9.")
    if args.negative_prompt == "":  # given, and empty: no negative prompt, not the default text
        given["settings"] = {"guidance.default_negative": "false"} | given["settings"]
    for name in ("guidance", "light", "base_color"):
        value = getattr(args, name, None)
        given[name] = _absolute(value) if value and Path(value).exists() else value
    return Job(**{key: value for key, value in given.items() if value is not None})


def _absolute(path: str) -> str:
    # Links are kept as they are: one that leads to itself has no target to name.
    return os.path.abspath(os.path.expanduser(path)) if path else ""  # noqa: PTH100, PTH111


def _lora(text: str) -> tuple[str, float]:
    """A LoRA's file and its strength; the colon after a drive's letter is no strength's."""
    path, colon, strength = text.rpartition(":")
    try:
        return (_absolute(path), float(strength)) if colon else (_absolute(text), 1.0)
    except ValueError:
        return _absolute(text), 1.0


def _setting(text: str) -> tuple[str, str]:
    key, equals, value = text.partition("=")
    if not equals:
        raise UserError(f"--set {text!r} has no value.", "Write --set geometry.fine.steps=100.")
    return key.strip(), value.strip()


def run_job(
    run: "RunFolder", inputs: "Inputs | None", until: str = "", gpus: int = 1
) -> Path | None:
    """:func:`_run_job` under the run's lock, taken before anything is written to its folder."""
    from core.io.lock import run_lock
    from core.io.progress import Progress

    progress = Progress(run)
    with run_lock(run.path), asks_to_stop(progress.interrupt):
        return _run_job(run, inputs, progress, until, gpus)


def _run_job(
    run: "RunFolder", inputs: "Inputs | None", progress: "Progress", until: str, gpus: int
) -> Path | None:
    """Carry out ``run`` from where it stopped, until its events end; the folder of its asset.

    None where it paused, as ``until`` has it: a first look at the "shape" or at the "color".
    ``inputs`` are loaded here where they are None, so that what is wrong with them is an event.
    """
    from core.generate import generate, prepare
    from core.together import place, together

    path, request = run.path, run.path / "cancel"
    run.remove_half_written()
    if request.exists() and request.stat().st_mtime < START:
        request.unlink()
    run.report("started", pid=os.getpid())
    try:
        inputs = inputs or prepare(run.job, place(gpus, run.job.device))
        with together(inputs, run.job, gpus, until) as shared:
            asset = generate(run, shared, progress, until)
    except Paused as pause:
        run.report("paused", text=pause.text, fix=pause.fix)
        put(run.path)
        return None
    except UserError as error:
        kind = "cancelled" if error.status == 130 else "error"
        with suppress(OSError):  # a full disk takes no last word
            # Carried out. Its time may be in a later session's future: a clock can be set back.
            request.unlink(missing_ok=True)
            run.report(kind, text=error.text, fix=error.window_fix or error.fix or None)
        raise
    except BaseException as error:
        known = sentence_of(error)
        text, fix = (known.text, known.fix) if known else (f"{type(error).__name__}: {error}", "")
        with suppress(OSError):
            run.report("error", text=text, fix=fix or f"This is a bug. Read {path / 'log.txt'}.")
        if known:
            raise known from error
        with suppress(OSError), (path / "log.txt").open("a", encoding="utf-8") as log:
            traceback.print_exc(file=log)
        raise
    run.report("done", path="asset", text=f"{asset} is complete.")
    put(asset)
    return asset


def main(argv: Sequence[str]) -> int:
    """Carry out one of the core's commands: the exit code."""
    return exit_code(lambda: carry_out(parse(argv)))


def carry_out(args: argparse.Namespace) -> Path | None:
    """Carry out a parsed command; the folder of the asset that it made, if it made one."""
    if args.command in JOBS:
        if int(os.environ.get("RANK") or 0) > 0:
            _follow()
        return _resume(args) if args.command == "resume" else _job(args)
    other = {"render": _render, "inspect": _inspect, "export": _export, "bench": _bench}
    other |= {"words": _words, "verify": _verify, "report": _report}
    other |= {"batch": _batch, "node": _node, "explore": _explore, "recolor": _recolor}
    other |= {"models": _models, "reproduce": _reproduce, "edit": _edit}
    other[args.command](args)
    return None


def default_run_folder(prompt: str) -> Path:
    """Where a run goes that names no --out: its prompt's letters and digits, numbered if taken."""
    from core.batch.table import slug

    name = slug(prompt)
    number, folder = 1, Path("out") / name
    while folder.exists():
        number += 1
        folder = Path("out") / f"{name}-{number}"
    return folder


def _job(args: argparse.Namespace) -> Path | None:
    until = _until(args)
    return _run_new(args.out, job_of(args), until, args.gpus)


def _run_new(out: Path | None, job: "Job", until: str, gpus: int = 1) -> Path | None:
    from core.generate import prepare
    from core.io.run_folder import RunFolder
    from core.together import place

    # What is wrong is reported before anything is written.
    inputs = prepare(job, place(gpus, job.device))
    run = RunFolder.create(out or default_run_folder(job.prompt), job)
    return run_job(run, inputs, until, gpus)


def _until(args: argparse.Namespace) -> str:
    from core.io.job import UNTIL

    if args.until and args.until not in UNTIL:
        raise UserError(f"--until is {args.until!r}.", f"Use one of {', '.join(UNTIL)}.")
    return args.until or ""


def _resume(args: argparse.Namespace) -> Path | None:
    from core.batch.orphan import end_with_stdin
    from core.io.run_folder import RunFolder

    if args.end_with_stdin:
        end_with_stdin()
    return run_job(RunFolder.open(args.run), None, _until(args), args.gpus)


def _follow() -> None:
    """Of the processes that torchrun has started, all but the first take part and write nothing."""
    from core.together import follow, place

    if place():
        sys.exit(follow())


def _edit(args: argparse.Namespace) -> None:
    from dataclasses import replace

    from core.generate import prompt_of
    from core.io.asset import read_asset

    asset = read_asset(args.asset)
    args.command, args.mesh, args.uv = "texture", str(asset.folder / "mesh.obj"), "keep"
    kept = {"kept_asset": _absolute(str(asset.folder)), "region": _absolute(args.faces)}
    size = args.texture_size or len(asset.maps.base_color)
    job = replace(job_of(args), texture_size=size, **kept)
    # Recorded as it is seen: a later edit of the result has to know what the whole is.
    _run_new(args.out, replace(job, prompt=prompt_of(job, asset)), "")


def _explore(args: argparse.Namespace) -> None:
    from core.explore import explore

    job = job_of(args)
    put(explore(args.out or default_run_folder(job.prompt), job, args.count, run_job))


def _recolor(args: argparse.Namespace) -> None:
    from core.explore import recolor

    put(recolor(args.out, args.run, args.count, run_job))


def _batch(args: argparse.Namespace) -> None:
    from core.batch.batch import run_batch

    # The command line's own options stand for each row; a row's cells come after them.
    names = ("seed", "preset", "guidance", "light", "texture_size", "max_faces", "device")
    given = {name.replace("_", "-"): getattr(args, name) for name in names}
    given["negative"] = args.negative_prompt
    defaults = [f"--{name}={value}" for name, value in given.items() if value is not None]
    defaults += ["--ignore-unknown-words"] * args.ignore_unknown_words
    defaults += [f"--set={text}" for text in args.set]
    defaults += [f"--lora={text}" for text in args.lora]
    defaults += [f"--embedding={path}" for path in args.embedding]

    def row_job(row: "Row") -> "Job":
        return job_of(parse(row.arguments(defaults)))

    print(run_batch(args, row_job))


def _node(args: argparse.Namespace) -> None:
    from core.batch.cluster import be_node

    be_node(args)


def _render(args: argparse.Namespace) -> None:
    from core.picture import render_asset

    names = ("light", "azimuth_deg", "elevation_deg", "fovy_deg", "distance", "size", "map")
    options = {name: getattr(args, name) for name in names}
    render_asset(args.asset, args.out, **options)


def _inspect(args: argparse.Namespace) -> None:
    from core.io.asset import inspect

    put(json.dumps(inspect(args.path), indent=1, ensure_ascii=False))


def _verify(args: argparse.Namespace) -> None:
    from core.verify import verify

    with redirect_stdout(sys.stderr):  # the report alone goes to the output
        report = verify(args.asset, run_job)
    put(json.dumps(report, indent=1))
    if not report["same"]:
        changed = "changed" in report["files"].values()
        raise UserError(
            "It did not come out the same.",
            "Its files were changed since it was made." if changed
            else "Compare the versions above: another machine or library rounds otherwise.",
        )  # fmt: skip


def _export(args: argparse.Namespace) -> None:
    from core.io.asset import export
    from core.simulation.export import ENDINGS, export_body, file_for

    kind = args.format.lower()
    out = file_for(args.asset, args.out, ENDINGS.get(kind, f".{kind}"))
    if kind in ENDINGS:
        export_body(args.asset, kind, out, args.mass, args.hulls)
    else:
        export(args.asset, kind, out)
    print(out)


def _report(args: argparse.Namespace) -> None:
    from core.report.page import write_report

    put(write_report(args.run, args.out))


def _words(args: argparse.Namespace) -> None:
    from core.guidance.builtin.groups import word_groups
    from core.guidance.builtin.vocabulary import understood, words_report
    from core.io.job import check_prompt

    if args.prompt is None:
        put(json.dumps(word_groups(), indent=1, ensure_ascii=False))
        return
    check_prompt("prompt", args.prompt)
    report, code = words_report(args.prompt, args.ignore_unknown_words)
    put(json.dumps(report, indent=1, ensure_ascii=False))
    if code:
        understood(args.prompt, ignore_unknown=args.ignore_unknown_words)  # raises what it says


def _models(args: argparse.Namespace) -> None:
    from core.guidance.stable_diffusion.models import models_in, table

    found = models_in(args.folders)
    put(json.dumps([m.as_json() for m in found], indent=1) if args.json else table(found))


def _reproduce(args: argparse.Namespace) -> None:
    with _whole_project("reproduce"):
        from core.reproduce.command import run_reproduce

        if args.guidance and Path(args.guidance).exists():
            args.guidance = _absolute(args.guidance)
        run_reproduce(args, lambda words: job_of(parse(words)))


def _rehearse(args: argparse.Namespace) -> None:
    from core.benchmarks.bench_rehearsal import Rehearsal, bench_rehearsal

    if args.names != ["guidance"]:
        raise UserError("--architecture belongs to bench guidance alone.", "Name no other bench.")
    names = ("architecture", "scale", "batch", "chunk", "device")
    bench_rehearsal(Rehearsal(**{name: getattr(args, name) for name in names}), args.json)


def _bench(args: argparse.Namespace) -> None:
    from core.benchmarks import bench
    from core.io.atomic import check_target

    if args.json:
        check_target(args.json)
    if args.seeds < 1:
        raise UserError(f"--seeds is {args.seeds}.", "It takes 1 or more.")
    settings = dict(_setting(text) for text in args.set)
    with _whole_project(f"bench {args.names[0] if args.names else ''}"):
        if args.names == ["prior"]:  # hours, and folders of runs: never one of several
            from core.benchmarks.bench_prior import bench_prior

            bench_prior(args.nouns, args.seeds, args.out, args.json)
        elif args.names == ["fit"]:  # a minute or two a noun, and a folder
            from core.benchmarks.bench_fit import bench_fit

            bench_fit(args.nouns, settings, args.out, args.json)
        elif args.names == ["distillation"]:  # five trainings a noun, and a folder
            from core.benchmarks.bench_distillation import bench_distillation

            bench_distillation(args.nouns, args.set, args.calls, args.out, args.json)
        elif args.architecture:
            _rehearse(args)
        else:
            bench(args.names, args.json)


@contextmanager
def _whole_project(command: str) -> Iterator[None]:
    """For commands that need core/prior, which the extension's zip is without."""
    try:
        yield
    except ModuleNotFoundError as error:
        if not str(error.name).startswith("core.prior"):
            raise
        raise MissingError(
            f"This copy of the project has no core/prior, which {command} needs.",
            "Run it from the project's own folder.",
        ) from error
