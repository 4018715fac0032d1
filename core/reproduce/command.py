"""``run.py reproduce``: which figures are made, in what order, and when the page is written."""

from argparse import Namespace
from pathlib import Path

from core.batch.needs import check_at_once
from core.errors import Cancelled, UserError
from core.guidance.stable_diffusion.checkpoint import find_checkpoint
from core.io.atomic import check_target, disk_errors
from core.io.lock import run_lock
from core.job_config import BUILTIN
from core.reproduce.figures import FIGURES, Figure
from core.reproduce.make import JobOf, Order, make, plan
from core.reproduce.page import figures_for, write_page
from core.terminal import put


def run_reproduce(args: Namespace, job_of: JobOf) -> None:
    """Make what is missing of the figures that are named, and write the page.

    Raises:
        UserError: a figure that does not exist; a page that is no Markdown file.
        Cancelled: by Ctrl-C; the next call continues.
    """
    order = Order(args.out.absolute(), job_of, args.guidance or BUILTIN, args.quick, args.at_once)
    figures = chosen(args.figure, order)
    check_rows(args.row, figures)
    page = args.page or args.out / "reproduction.md"
    if page.suffix != ".md":
        raise UserError(f"--page is {page}.", "Its name ends in .md.")
    if args.list:
        put("\n".join(state_of(figure, order) for figure in figures))
        return
    check_at_once(args.at_once)
    if order.guidance != BUILTIN:
        find_checkpoint(order.guidance)
    if page.parent.absolute() != args.out.absolute():
        check_target(page)  # what comes before it takes hours
    with disk_errors(args.out):
        args.out.mkdir(parents=True, exist_ok=True)
    with run_lock(args.out, "reproduce.lock"):
        _make(figures, args.row, order, page)
    put(page)


def chosen(names: list[str], order: Order) -> list[Figure]:
    """The figures of these names; all where there are none.

    Raises UserError for a name that does not exist.
    """
    known = {figure.name: figure for figure in figures_for(order)}
    for name in names:
        if name not in known:
            raise UserError(f"There is no figure {name!r}.", f"Use one of {', '.join(known)}.")
    return [figure for figure in FIGURES if figure.name in (names or known)]


def check_rows(names: list[str], figures: list[Figure]) -> None:
    """Raise UserError for a row that none of ``figures`` has."""
    known = [row.name for figure in figures for row in figure.rows]
    for name in names:
        if name not in known:
            raise UserError(f"There is no row {name!r}.", f"Use one of {', '.join(known)}.")


def state_of(figure: Figure, order: Order) -> str:
    """A line of ``--list``."""
    made = sum(each.is_made for each in plan(figure, order))
    return f"{figure.name:<12} {made} of {len(figure.rows)} made   {figure.title}"


def _make(figures: list[Figure], rows: list[str], order: Order, page: Path) -> None:
    try:
        for figure in figures:
            make(figure, order, rows)
            write_page(page, order)
    except KeyboardInterrupt:
        write_page(page, order)
        raise Cancelled("Stopped.", "The same command continues.") from None
