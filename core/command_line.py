"""The core's commands; their options are in ``core.options``.

Standard library only until a command is carried out: torch takes seconds to load, and a wrong
option must not wait for it.

Exit codes: 0 done; 2 the user's input; 3 something is missing; 4 out of memory; 5 no surface could
be kept; 6 some assets of a batch failed; 7 another process of the same run ended; 130 cancelled.
"""

import argparse
import json
import os
import sys
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, redirect_stdout, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from core.errors import MissingError, Paused, UserError
from core.interrupt import asks_to_stop, process_began
from core.options import Commands, absolute, add_core_commands, job_of, named, setting_of
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


def parse(argv: Sequence[str]) -> argparse.Namespace:
    """The options of one of the core's commands."""
    commands = Commands(__doc__ or "")
    add_core_commands(commands)
    return commands.parse(argv)


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

    if args.until is not None and args.until not in UNTIL:
        raise UserError(f"--until is {args.until!r}.", f"Use one of {', '.join(UNTIL)}.")
    return args.until or ""


def _resume(args: argparse.Namespace) -> Path | None:
    from core.batch.orphan import end_with_stdin

    if args.end_with_stdin:
        end_with_stdin()
    if args.ray_jobs is not None:  # which needs no torch here
        return _resume_elsewhere(args)
    from core.io.run_folder import RunFolder

    return run_job(RunFolder.open(args.run), None, _until(args), args.gpus)


def _resume_elsewhere(args: argparse.Namespace) -> Path | None:
    from core.batch.relay import relay

    if args.gpus != 1:
        raise UserError("--gpus applies to this machine.", "Leave it out with --ray-jobs.")
    asset = relay(args.run, args.ray_jobs, _until(args), START)
    put(asset or args.run)
    return asset


def _follow() -> None:
    """Of torchrun's processes, all but the first take part and write nothing."""
    from core.together import follow, place

    if place():
        sys.exit(follow())


def _edit(args: argparse.Namespace) -> None:
    from dataclasses import replace

    from core.generate import prompt_of
    from core.io.asset import read_asset

    asset = read_asset(args.asset)
    mesh = str(asset.folder / "mesh.obj")
    # A copy: who has parsed the options asks them afterwards which command it was.
    args = argparse.Namespace(**vars(args) | {"command": "texture", "mesh": mesh, "uv": "keep"})
    kept = {"kept_asset": absolute(str(asset.folder)), "region": absolute(args.faces)}
    size = args.texture_size or len(asset.maps.base_color)
    # Without --shape the material is edited anyway: --material adds nothing.
    what = {"reshape": args.shape, "retexture": args.shape and args.material}
    job = replace(job_of(args), texture_size=size, **what, **kept)
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

    # The command line's own options apply to each row; a row's cells override them.
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
    from core.batch.options import check_node

    check_node(args)  # before Ray is missed
    from core.batch.cluster import be_node

    be_node(args)


def _render(args: argparse.Namespace) -> None:
    from core.picture import render_asset

    names = ("light", "azimuth_deg", "elevation_deg", "fovy_deg", "distance", "size", "map")
    options = {name: getattr(args, name) for name in names}
    options["light"] = named(args.light)
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
            "The new asset is not the same.",
            "Its files were changed since it was made." if changed
            else "Compare the versions above: another machine or library rounds differently.",
        )  # fmt: skip


def _export(args: argparse.Namespace) -> None:
    from core.io.asset import check_format, export
    from core.simulation.body import check_body
    from core.simulation.export import ENDINGS, export_body, file_for

    kind = args.format.lower()
    check_body(args.mass, args.hulls)
    if kind not in ENDINGS:
        check_format(kind)  # before a folder is made for it
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
    from core.guidance.builtin.words.groups import word_groups
    from core.guidance.builtin.words.vocabulary import understood, words_report
    from core.io.job import check_prompt

    if args.prompt is None:
        put(json.dumps(word_groups(), indent=1, ensure_ascii=False))
        return
    check_prompt("prompt", args.prompt)
    report, code = words_report(args.prompt, args.ignore_unknown_words)
    put(json.dumps(report, indent=1, ensure_ascii=False))
    if code:
        understood(
            args.prompt, ignore_unknown=args.ignore_unknown_words
        )  # raises the report's error


def _models(args: argparse.Namespace) -> None:
    from core.guidance.stable_diffusion.models import models_in, table

    found = models_in(args.folders)
    put(json.dumps([m.as_json() for m in found], indent=1) if args.json else table(found))


def _reproduce(args: argparse.Namespace) -> None:
    with _whole_project("reproduce"):
        from core.reproduce.command import run_reproduce

        args.guidance = args.guidance and named(args.guidance, folders=True)
        run_reproduce(args, lambda words: job_of(parse(words)))


def _rehearse(args: argparse.Namespace) -> None:
    from core.benchmarks.bench_rehearsal import Rehearsal, bench_rehearsal

    if args.names != ["guidance"]:
        raise UserError(
            "--architecture belongs to bench guidance alone.", "Use no other bench with it."
        )
    names = ("architecture", "scale", "batch", "chunk", "device")
    bench_rehearsal(Rehearsal(**{name: getattr(args, name) for name in names}), args.json)


def _bench(args: argparse.Namespace) -> None:
    from core.benchmarks import bench
    from core.io.atomic import check_folder, check_target

    if args.json:
        check_target(args.json)
    if args.out:
        check_folder(args.out)
    for name in ("seeds", "calls"):
        if getattr(args, name) < 1:
            raise UserError(f"--{name} is {getattr(args, name)}.", "Use 1 or more.")
    settings = dict(setting_of(text) for text in args.set)
    with _whole_project(f"bench {args.names[0] if args.names else ''}"):
        if args.names == ["prior"]:  # hours, and folders of runs: never one of several
            from core.benchmarks.bench_prior import bench_prior

            bench_prior(args.nouns, args.seeds, args.out, args.json)
        elif args.names == ["solids"]:  # seconds a noun
            from core.benchmarks.bench_solids import bench_solids

            bench_solids(args.nouns, args.seeds, args.json)
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
