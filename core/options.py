"""The commands' options, declared once for ``python -m core`` and ``run.py``, and a Job of them.

Standard library only: a wrong option must not wait for torch, which takes seconds to load.
"""

import argparse
import difflib
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from core.batch.options import add_batch_options, add_node_options
from core.errors import UserError
from core.io.input_file import expanded

if TYPE_CHECKING:
    from core.io.job import Job


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
        self._expand_home(args)
        return args

    def _expand_home(self, args: argparse.Namespace) -> None:
        """A shell does not expand the ~ of --out=~/a. Other arguments are left as written."""
        for action in self[args.command]._actions:
            value = getattr(args, action.dest, None)
            if action.option_strings and isinstance(value, Path):
                setattr(args, action.dest, expanded(value))


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
        "--size", type=float, metavar="METRES", help="the longest side; default: the prompt's"
    )
    texture = add("texture", "A material for your own mesh; its uv is kept if it has one.")
    texture.add_argument("mesh")
    texture.add_argument("prompt")
    texture.add_argument(
        "--uv", metavar="auto|keep", help="keep: use the mesh's own, even where faces share texels"
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
            "--color-seed", type=int, metavar="N", help="a different material on the same shape"
        )
        _add_job_options(command)
        _add_gpus(command)

    edit = add("edit", "Another material, or shape, of a part of an asset; the rest stays.")
    edit.add_argument("asset", type=Path, metavar="ASSET")
    edit.add_argument("prompt", help="the whole thing in the new material, or a part of it")
    edit.add_argument(
        "--faces",
        required=True,
        metavar="FILE",
        help="faces of mesh.obj: one number per line, from 0",
    )
    edit.add_argument(
        "--shape",
        action="store_true",
        help="change their shape instead: vertices move, texels stay",
    )
    edit.add_argument(
        "--material", action="store_true", help="with --shape: change their material too"
    )
    edit.add_argument("--out", type=Path, metavar="RUN", help="the run folder")
    _add_job_options(edit)

    explore = add("explore", "Quick shapes from several seeds side by side; resume finishes one.")
    explore.add_argument("prompt")
    explore.add_argument("--count", type=int, default=4, metavar="N", help="shapes; default 4")
    explore.add_argument(
        "--out", type=Path, metavar="DIR", help="a run folder for each, and a picture"
    )
    explore.add_argument(
        "--size", type=float, metavar="METRES", help="the longest side; default: the prompt's"
    )
    _add_job_options(explore)
    recolor = add("recolor", "Quick materials from several seeds for the shape of a run.")
    recolor.add_argument("run", type=Path, metavar="RUN", help="a run whose shape is finished")
    recolor.add_argument("--count", type=int, default=4, metavar="N", help="materials; default 4")
    recolor.add_argument(
        "--out",
        type=Path,
        required=True,
        metavar="DIR",
        help="a run folder for each, and a picture",
    )

    batch = add("batch", "An asset for each row of a table; as many at once as the machine allows.")
    add_batch_options(batch)
    _add_job_options(batch)
    add_node_options(add("node", "This machine as a node of a Ray cluster, for batch --ray."))

    resume = add("resume", "Continue a run that was cancelled or interrupted.")
    resume.add_argument("run", type=Path)
    _add_gpus(resume)
    resume.add_argument(
        "--ray-jobs",
        metavar="http://HOST:8265",
        help="run on a Ray cluster, through its Jobs API; its token in RAY_AUTH_TOKEN",
    )
    resume.add_argument(
        "--end-with-stdin", action="store_true", help="stop when the program that started it ends"
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
    render.add_argument(
        "--distance", type=float, metavar="METRES", help="default: all of it is visible"
    )
    render.add_argument("--size", type=int, default=512, help="pixels")
    render.add_argument("--map", default="shaded", help="shaded, normal, base_color, roughness, …")
    render.add_argument("--out", type=Path, required=True, metavar="FILE.png|FILE.exr")

    inspect = add("inspect", "The health of an asset or a mesh, as JSON.")
    inspect.add_argument("path", type=Path, metavar="ASSET|MESH")

    verify = add("verify", "Make an asset again from its own record, and compare the files.")
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

    report = add("report", "A run as one HTML file that needs no network.")
    report.add_argument("run", type=Path)
    report.add_argument("--out", type=Path, metavar="FILE.html", help="default: RUN/report.html")

    words = add("words", "What the built-in model understands of a prompt, as JSON.")
    words.add_argument("prompt", nargs="?", help="without it: all known words by group")
    words.add_argument("--ignore-unknown-words", action="store_true", help="as with generate")

    models = add("models", "The Stable Diffusion models in folders, and which can be used.")
    models.add_argument(
        "folders",
        nargs="*",
        type=Path,
        metavar="FOLDER",
        help="also a ComfyUI or A1111 folder; default: the hub's cache",
    )
    models.add_argument("--json", action="store_true", help="for programs")

    reproduce = add("reproduce", "The paper's figures, reproduced on a page; continues if stopped.")
    reproduce.add_argument("--out", type=Path, default=Path("out/reproduction"), metavar="FOLDER")
    reproduce.add_argument("--page", type=Path, metavar="FILE.md", help="default: in --out")
    reproduce.add_argument(
        "--figure", action="append", default=[], metavar="NAME", help="only this one"
    )
    reproduce.add_argument(
        "--row", action="append", default=[], metavar="NAME", help="only this row of a figure"
    )
    reproduce.add_argument("--list", action="store_true", help="list the figures and what is made")
    reproduce.add_argument("--quick", action="store_true", help="shortest settings, as a trial")
    reproduce.add_argument("--guidance", metavar="builtin|FOLDER|HUB-ID")
    reproduce.add_argument("--at-once", type=int, metavar="N", help="runs; default: as many as fit")

    bench = add("bench", "Measure this machine.")
    bench.add_argument("names", nargs="*", metavar="NAME")
    bench.add_argument("--json", type=Path, metavar="FILE")
    folders = "prior, fit, distillation"  # the benches that make something of each noun
    which = f"{folders}, solids: which"
    bench.add_argument("--nouns", nargs="*", default=[], metavar="NOUN", help=which)
    bench.add_argument(
        "--seeds", type=int, default=2, help="of prior and solids: seeds for each noun"
    )
    bench.add_argument(
        "--calls", type=int, default=60, help="of distillation: network calls per view"
    )
    bench.add_argument("--out", type=Path, metavar="FOLDER", help=f"{folders}: where the runs go")
    _add_rehearsal_options(bench)
    bench.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="stage.field=value",
        help="of fit, distillation: changes to the draft preset",
    )


def _add_job_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("--seed", type=int)
    command.add_argument("--preset", help="draft, sds, standard or paper")
    command.add_argument(
        "--negative", dest="negative_prompt", metavar="TEXT", help='"": none, not the default text'
    )
    command.add_argument("--guidance", metavar="builtin|FOLDER|FILE|HUB-ID")
    command.add_argument(
        "--lora",
        action="append",
        default=[],
        metavar="FILE[:STRENGTH]",
        help="added to a Stable Diffusion checkpoint; strength 1: as trained",
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
        help="leave out words that the built-in model does not know; default: refuse them",
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
        metavar="sd15|sd21|sdxl|mvdream",
        help="of guidance: with random weights",
    )
    bench.add_argument("--scale", default="full", metavar="full|tiny", help=f"{of}: its widths")
    bench.add_argument("--batch", type=int, default=24, metavar="N", help=f"{of}: views of a step")
    bench.add_argument("--chunk", type=int, default=4, metavar="N", help=f"{of}: views at a time")
    bench.add_argument("--device", default="auto", metavar="auto|cpu|cuda", help=of)


def _add_gpus(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--gpus", type=int, default=1, metavar="N", help="divide each step's views among N GPUs"
    )


def job_of(args: argparse.Namespace) -> "Job":
    """The Job that ``generate`` or ``texture`` requests, with absolute paths."""
    from core.io.job import Job

    for name in ("guide", "light", "base_color", "faces"):
        if getattr(args, name, None) == "":  # a script's variable that was never set
            raise UserError(
                f"--{name.replace('_', '-')} is empty.", "Name a file, or leave it out."
            )
    given = {
        "command": "generate" if args.command == "explore" else args.command,
        "prompt": args.prompt,
        "mesh": absolute(getattr(args, "mesh", "")),
        "guide_mesh": absolute(getattr(args, "guide", None) or ""),
        "guide_strength": getattr(args, "guide_strength", getattr(args, "strength", None)),
        "uv": getattr(args, "uv", None),
        "size_m": getattr(args, "size", None),
        "ignore_unknown_words": args.ignore_unknown_words,
        "settings": dict(setting_of(text) for text in args.set),
        "loras": dict(lora_of(text) for text in args.lora),
        "embeddings": [absolute(path) for path in args.embedding],
    }
    given["color_seed"] = getattr(args, "color_seed", None)
    for name in ("seed", "preset", "negative_prompt", "texture_size", "max_faces", "device"):
        given[name] = getattr(args, name)
    for name, takes in (("texture_size", "64 to 8192 texels"), ("max_faces", "100 or more")):
        if given[name] == 0:  # which means the preset's own in job.json
            raise UserError(f"--{name.replace('_', '-')} is 0.", f"Use {takes}.")
    if given["size_m"] == 0:
        raise UserError("--size is 0.", "Use metres, such as 0.9.")
    if args.negative_prompt == "":  # given, and empty: no negative prompt, not the default text
        given["settings"] = {"guidance.default_negative": "false"} | given["settings"]
    for name in ("guidance", "light", "base_color"):
        value = getattr(args, name, None)
        given[name] = named(value, folders=name == "guidance") if value else value
    return Job(**{key: value for key, value in given.items() if value is not None})


def absolute(path: str) -> str:
    """The full path; "" stays."""
    # Links are kept as they are: one that leads to itself has no target to name.
    return os.path.abspath(expanded(path)) if path else ""  # noqa: PTH100


def named(text: str, folders: bool = False) -> str:
    """The full path of a file (or one of ``folders``) that is there; else ``text``, a name."""
    path = Path(absolute(text))
    return str(path) if path.is_file() or (folders and path.is_dir()) else text


def lora_of(text: str) -> tuple[str, float]:
    """A LoRA's file and its strength; the colon after a drive's letter is no strength's."""
    path, colon, strength = text.rpartition(":")
    try:
        return (absolute(path), float(strength)) if colon else (absolute(text), 1.0)
    except ValueError:
        return absolute(text), 1.0


def setting_of(text: str) -> tuple[str, str]:
    """The key and the value of ``--set``."""
    key, equals, value = text.partition("=")
    if not equals:
        raise UserError(f"--set {text!r} has no value.", "Write --set geometry.fine.steps=100.")
    return key.strip(), value.strip()
