"""Make the built-in prior: ``python -m core.prior data | train | evaluate | ship``.

From nothing, on two CPU cores: ``data`` for some minutes, then ``train geometry`` and
``train appearance`` at the same time, then ``evaluate``. The shipped weights were made this way;
docs/model_card.md states how long each step ran.
"""

import argparse
import math
import sys
from dataclasses import replace
from functools import partial
from pathlib import Path

import torch

from core.errors import UserError
from core.guidance.builtin.network import UNet
from core.guidance.builtin.offered import SOLID, WEIGHTS
from core.guidance.builtin.solid import save_solid_net
from core.guidance.builtin.weights import load_weights, ship_weights
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.io.atomic import disk_errors
from core.io.input_file import check_file
from core.prior.allocator import keep_freed_memory
from core.prior.data import MODEL_VIEWS, NOUNS, SHARDS, write_samples, write_shards
from core.prior.evaluate import (
    CHANCE,
    PaintScore,
    Score,
    score_noun,
    score_paint,
    score_pattern,
)
from core.prior.models import CATALOGUE, INSTALL, make_models
from core.prior.part_forms import write_forms
from core.prior.part_score import report_parts
from core.prior.part_training import FINDING_PARTS, PART_NETWORK, PartMaps, part_loss
from core.prior.restorer import RESTORER, RESTORING, Restoring, restoring_loss
from core.prior.restorer_score import report
from core.prior.soft_pairs import write_pair_files
from core.prior.solid_data import SOLIDS, write_solid_files
from core.prior.solid_training import (
    FITTING,
    Autoencoder,
    SolidSource,
    SolidTraining,
    solid_loss,
    trained_solid_net,
)
from core.prior.sources import Appearance, Geometry
from core.prior.train import (
    APPEARANCE,
    GEOMETRY,
    TrainConfig,
    Training,
    denoising_loss,
    run,
)

DEFAULT_FOLDER = Path("out/prior")
# Each network, its source of batches, its schedule and its loss.
TRAININGS = {
    "solid": (Autoencoder, SolidSource, FITTING, solid_loss),
    "geometry": (partial(UNet, GEOMETRY), Geometry, TrainConfig(), denoising_loss),
    "appearance": (partial(UNet, APPEARANCE), Appearance, TrainConfig(), denoising_loss),
    "parts": (partial(UNet, PART_NETWORK), PartMaps, FINDING_PARTS, part_loss),
    "restorer": (partial(UNet, RESTORER), Restoring, RESTORING, restoring_loss),
}
MOST = 10_000_000  # the largest number that an option takes
PATTERNED = 32  # objects of each pattern


def count(text: str) -> int:
    """A whole number of files or views, 0 or more."""
    if not text.isdecimal() or int(text) > MOST:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 0 to {MOST}")
    return int(text)


def some(text: str) -> int:
    """A whole number, 1 or more."""
    if not count(text):
        raise argparse.ArgumentTypeError("0 is too few; use 1 or more")
    return count(text)


def positive(text: str) -> float:
    """A finite number above 0."""
    try:
        given = float(text)
    except ValueError:
        given = math.nan
    if not 0 < given < MOST:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number between 0 and {MOST}")
    return given


def parser() -> argparse.ArgumentParser:
    """The parser of the five commands."""
    top = argparse.ArgumentParser("core.prior", description=__doc__)
    commands = top.add_subparsers(dest="command", required=True)

    data = commands.add_parser("data", help="render shards of the families")
    data.add_argument("--shards", type=count, default=24, help="of 1024 views each")
    data.add_argument("--pairs", type=count, default=0, help="files of 256 soft and crisp views")
    data.add_argument("--close-pairs", type=count, default=0, help="the same, of close-ups")
    data.add_argument("--solids", type=count, default=0, help="files of two solids of each noun")
    data.add_argument("--workers", type=some, default=2)
    data.add_argument(
        "--catalogue", type=Path, default=CATALOGUE, metavar="FILE", help="of real models, .sh3f"
    )

    train = commands.add_parser(
        "train", help="train one network; continues from the checkpoint in --out if there is one"
    )
    train.add_argument("network", choices=tuple(TRAININGS))
    train.add_argument("--minutes", type=positive, help="the whole budget of this training")
    train.add_argument(
        "--start", type=Path, metavar="FILE", help="weights of an older vocabulary to start from"
    )
    train.add_argument(
        "--hold", action="store_true", help="train only the nouns that the data contains"
    )
    train.add_argument(
        "--new-kinds",
        action="store_true",
        help="solids only: start the kinds of the data's nouns again; their families changed",
    )
    train.add_argument(
        "--encoder",
        type=Path,
        metavar="FILE",
        help="solids only: start from the encoder of this older checkpoint",
    )
    train.add_argument("--learning-rate", type=positive, help="the highest learning rate")
    train.add_argument("--batch", type=some, help="pictures in one step; more on a GPU")
    train.add_argument("--seed", type=count, default=0)
    train.add_argument("--device", default="cpu", choices=("cpu", "cuda"), help="cpu or cuda")

    evaluate = commands.add_parser("evaluate", help="nouns, azimuths, colours, on fresh renders")
    evaluate.add_argument("network", choices=tuple(TRAININGS))
    evaluate.add_argument("--weights", type=Path, help="weights other than the shipped ones")
    evaluate.add_argument("--views", type=some, default=16, help="views of each noun")
    evaluate.add_argument("--nouns", nargs="*", default=NOUNS, choices=NOUNS)
    evaluate.add_argument("--close", action="store_true", help="the restorer on close-ups")
    evaluate.add_argument(
        "--seed", type=count, default=1_000_000, help="the data's seeds end at 100,000"
    )

    ship = commands.add_parser("ship", help="copy the trained weights into the project")
    ship.add_argument("--without", nargs="*", default=[], metavar="WORD", help="words to leave out")

    forms = commands.add_parser("forms", help="measure how flat and round the families' parts are")

    for command in (data, forms):
        command.add_argument("--nouns", nargs="+", default=NOUNS, choices=NOUNS, metavar="NOUN")
    for command in (data, train, ship):
        command.add_argument("--out", type=Path, default=DEFAULT_FOLDER, metavar="FOLDER")
    return top


def main(arguments: list[str]) -> None:
    """Run one command."""
    options = parser().parse_args(arguments)
    torch.set_num_threads(1)
    known = {"data": data, "train": train, "evaluate": evaluate, "ship": ship, "forms": forms}
    known[options.command](options)


def data(options: argparse.Namespace) -> None:
    """Create the files that the folder lacks: shards, and the real models' views if installed."""
    with disk_errors(options.out):
        options.out.mkdir(parents=True, exist_ok=True)
    models = options.out / MODEL_VIEWS
    if not models.exists() and options.catalogue.exists():
        of_nouns = make_models(options.catalogue, nouns=options.nouns)
        if of_nouns is not None:
            write_samples(models, of_nouns)
    if models.exists():
        print(models, flush=True)
    elif not options.catalogue.exists():
        print(f"No real models: {options.catalogue} does not exist. {INSTALL}", file=sys.stderr)
    workers, nouns = options.workers, options.nouns
    for path in write_shards(options.out, range(options.shards), workers, nouns):
        print(path, flush=True)
    for path in write_solid_files(options.out, range(options.solids), workers, nouns):
        print(path, flush=True)
    for count, close in ((options.pairs, False), (options.close_pairs, True)):
        for path in write_pair_files(options.out, range(count), workers, nouns, close=close):
            print(path, flush=True)


def train(options: argparse.Namespace) -> None:
    """Train one network."""
    if (options.new_kinds or options.encoder) and options.network != SOLID:
        raise UserError(
            f"--new-kinds and --encoder are for solids; this training is for {options.network}.",
            "Leave them out.",
        )
    if options.encoder:
        check_file(options.encoder, "checkpoint")
    needed = SOLIDS if options.network == SOLID else SHARDS
    if not any(options.out.glob(needed)):
        raise UserError(
            f"There are no files {needed} in {options.out}.",
            f"Make them first: python -m core.prior data --out {options.out}",
        )
    make, source, config, objective = TRAININGS[options.network]
    config = replace(config, seed=options.seed)
    if options.minutes is not None:
        config = replace(config, minutes=options.minutes)
    if options.learning_rate is not None:
        config = replace(config, learning_rate=options.learning_rate)
    if options.batch is not None:
        config = replace(config, batch=options.batch)
    kind = SolidTraining if options.network == SOLID else Training
    training = kind(make, config, options.device, objective)
    checkpoint = options.out / f"{options.network}.safetensors"
    samples = source(options.out)
    if checkpoint.exists():
        training.resume(checkpoint, samples)
    elif options.start:
        training.start_from(options.start)
    if isinstance(training, SolidTraining) and not checkpoint.exists():
        if options.encoder:
            training.encode_as(options.encoder)
        if options.new_kinds:
            training.forget_kinds(samples)
        elif options.start:
            samples.order_kinds(training.net.decoder)
    if options.hold and not training.held:
        training.hold(samples)
    run(training, samples, checkpoint)


def ship(options: argparse.Namespace) -> None:
    """Copy the trained networks into the project, with the words that a prompt may use."""
    missing = [word for word in options.without if all(word not in SLOTS[s] for s in SLOTS)]
    if missing:
        raise UserError(
            f"There is no word {missing[0]!r}.", "See core/guidance/builtin/words/tables/words.py."
        )
    words = SLOTS | {"noun": NOUNS}  # without nouns that have another noun's solid
    known = {s: [word for word in words[s] if word not in options.without] for s in words}
    for name in TRAININGS.keys() - {SOLID}:
        trained = options.out / f"{name}_ema.safetensors"
        if not trained.exists():  # this network stays, the others are replaced
            continue
        path = WEIGHTS / f"{name}.safetensors"
        ship_weights(path, load_weights(trained), known)
        print(path)
    if (options.out / f"{SOLID}_ema.safetensors").exists():
        path = WEIGHTS / f"{SOLID}.safetensors"
        save_solid_net(path, trained_solid_net(options.out, path))
        print(path)


def evaluate(options: argparse.Namespace) -> None:
    """Print each noun's scores and their means."""
    if options.weights:
        check_file(options.weights, "weights")
    net = load_weights(options.weights or WEIGHTS / f"{options.network}.safetensors")
    if options.network == "restorer":
        report(net, options.nouns, options.views, options.seed, close=options.close)
        return
    if options.network == "parts":
        report_parts(net, options.nouns, options.views, options.seed)
        return
    generator = torch.Generator().manual_seed(options.seed)
    score = score_noun if options.network == "geometry" else score_paint
    scores = []
    for noun in options.nouns:
        scores.append(score(net, noun, options.views, generator))
        print(scores[-1], flush=True)
    if options.network == "geometry":
        summary(scores)
        return
    paint_summary(scores)
    for pattern in SLOTS["pattern"]:
        fraction = score_pattern(net, pattern, PATTERNED, generator)
        print(f"{pattern}: {fraction:.2f} of the colours' variance explained, {PATTERNED} objects")


def forms(options: argparse.Namespace) -> None:
    """Write the project's table of part forms; about 10 minutes of one core for all nouns."""
    write_forms(nouns=options.nouns)


def summary(scores: list[Score]) -> None:
    """Print the means over the nouns."""
    views = sum(score.views for score in scores)
    right = sum(score.noun_right for score in scores) / views
    print(f"nouns {right:.3f} of {views} views (chance {CHANCE:.3f})")
    front = [score for score in scores if score.has_front]
    if front:
        exact = sum(s.azimuth_right for s in front) / sum(s.views for s in front)
        near = sum(s.azimuth_near for s in front) / sum(s.views for s in front)
        print(f"azimuth of those with a front: {exact:.3f} exact, {near:.3f} within a sector")


def paint_summary(scores: list[PaintScore]) -> None:
    """Print the median and the fraction of near colours over all views."""
    away = sorted(value for score in scores for value in score.delta_e)
    near = sum(value <= 20 for value in away) / len(away)
    print(f"dE median {away[len(away) // 2]:.1f}, within 20 in {near:.3f} of {len(away)} views")


if __name__ == "__main__":
    keep_freed_memory()
    try:
        main(sys.argv[1:])
    except UserError as error:
        print(error, file=sys.stderr)
        sys.exit(error.status)
