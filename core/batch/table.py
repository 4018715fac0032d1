"""The table of a batch: a CSV file with a header, or a text file with a prompt on each line."""

import csv
import difflib
import io
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from core.errors import UserError, shown
from core.io.input_file import check_file, check_size

# A column is an option of ``generate`` or ``texture``, with "_" or "-"; or a key of --set.
FILES = ("mesh", "guide", "base_color", "light", "guidance")  # relative to the table's folder
OPTIONS = (
    "seed", "preset", "guide", "guide_strength", "size", "guidance", "light", "negative",
    "texture_size", "max_faces", "device", "uv", "base_color", "strength",
)  # fmt: skip
FLAGS = ("ignore_unknown_words",)
COLUMNS = ("prompt", "name", "mesh", *OPTIONS, *FLAGS)
YES, NO = ("1", "yes", "true"), ("0", "no", "false")
MAX_BYTES = 256 << 20  # a million rows with long prompts


@dataclass(frozen=True)
class Row:
    """One row, as it was written; a cell that is empty is left out."""

    line: int  # in the file, from 1
    prompt: str
    name: str = ""
    options: dict[str, str] = field(default_factory=dict)  # by column
    settings: dict[str, str] = field(default_factory=dict)  # of --set

    def arguments(self, defaults: Sequence[str]) -> list[str]:
        """The command line that makes this row's asset; ``defaults`` come first, so that it wins.

        Raises:
            UserError: a flag that is neither yes nor no.
        """
        named = {key: value for key, value in self.options.items() if key in OPTIONS}
        words = [f"--{key.replace('_', '-')}={value}" for key, value in named.items()]
        words += [f"--{key.replace('_', '-')}" for key in FLAGS if self._flag(key)]
        words += [f"--set={key}={value}" for key, value in self.settings.items()]
        mesh = self.options.get("mesh")
        command, place = ("texture", [mesh]) if mesh else ("generate", [])
        return [command, *defaults, *words, "--", *place, self.prompt]

    def _flag(self, key: str) -> bool:
        value = self.options.get(key, "no").lower()
        if value not in (*YES, *NO):
            raise UserError(f"{key} is {shown(value)}.", "Write yes or no.")
        return value in YES


def slug(text: str) -> str:
    """The letters and digits of ``text`` as a part of a folder's name."""
    words = "".join(c if c.isalnum() else " " for c in text.lower()).split()
    return "-".join(words)[:40].strip("-") or "asset"


def read_table(path: Path) -> list[Row]:
    """The rows of ``path``, blank ones left out.

    Raises:
        UserError: a file that cannot be read or is not text, holds no row, or has an unknown column
            or a row with more cells than columns.
    """
    text = _text(path)
    is_table = path.suffix.lower() in (".csv", ".tsv")
    rows = _csv_rows(text, path) if is_table else _lines(text)
    if not rows:
        raise UserError(
            f"{path} holds no prompt.", "Write one per line, or a CSV file with a header."
        )
    return rows


def _text(path: Path) -> str:
    check_file(path, "table")
    try:
        check_size(path, MAX_BYTES, "Split it.")
        return path.read_text(encoding="utf-8-sig")  # spreadsheets write the mark
    except UnicodeDecodeError:
        raise UserError(f"{path} is not UTF-8 text.", "Save it as CSV in UTF-8.") from None
    except OSError as error:
        raise UserError(f"{path} cannot be read ({error.strerror}).", "Name a file.") from None


def _lines(text: str) -> list[Row]:
    # Not splitlines: a spreadsheet's line break within a cell is no end of a row.
    lines = [(number, line.strip()) for number, line in enumerate(text.split("\n"), 1)]
    return [Row(number, line) for number, line in lines if line and not line.startswith("#")]


def _csv_rows(text: str, path: Path) -> list[Row]:
    first = text.partition("\n")[0]
    # Some countries' spreadsheets write semicolons; where there is none of them, the name decides.
    delimiter = max("\t,;" if path.suffix.lower() == ".tsv" else ",;\t", key=first.count)
    reader = csv.reader(io.StringIO(text), delimiter=delimiter, strict=True)
    try:
        header = [_column(cell, path) for cell in next(reader, [])]
        _check_header(header, path)
        rows = [
            _row(reader.line_num, dict(_cells(header, cells, reader.line_num, path)), path)
            for cells in reader
            if any(cell.strip() for cell in cells)
        ]
    except csv.Error as error:
        line = f"line {reader.line_num} of {path}"
        raise UserError(f"{line} is not CSV ({error}).", "Check its quotes.") from None
    return rows


def _column(cell: str, path: Path) -> str:
    name = cell.strip()
    if "." in name or not name:
        return name
    name = name.lower().replace("-", "_").replace(" ", "_")
    if name not in COLUMNS:
        near = difflib.get_close_matches(name, COLUMNS, n=1)
        known = f"Use {', '.join(COLUMNS)}, and keys of --set such as geometry.fine.steps."
        fix = f"Did you mean {near[0]}?" if near else known
        raise UserError(f"{path} has a column {shown(cell.strip())}.", fix)
    return name


def _check_header(header: list[str], path: Path) -> None:
    if "prompt" not in header:
        raise UserError(f"{path} has no column prompt.", "Name it in the first line.")
    twice = sorted({name for name in header if name and header.count(name) > 1})
    if twice:
        raise UserError(f"{path} has two columns {twice[0]}.", "Remove one.")


def _cells(header: list[str], cells: list[str], line: int, path: Path) -> list[tuple[str, str]]:
    if any(cell.strip() for cell in cells[len(header) :]):
        raise UserError(
            f"Line {line} of {path} has {len(cells)} cells, its header {len(header)}.",
            "Put a prompt that contains the separator in double quotes.",
        )
    pairs = [(name, cell.strip()) for name, cell in zip(header, cells, strict=False)]
    if any(cell and not name for name, cell in pairs):
        raise UserError(f"Line {line} of {path} has a cell without a column's name.", "Name it.")
    return [(name, cell) for name, cell in pairs if cell]


def _row(line: int, cells: dict[str, str], path: Path) -> Row:
    for name in (name for name in FILES if name in cells):
        here = path.parent / cells[name]
        # A folder is a checkpoint at most: one named mesh may be next to a base colour of "mesh".
        if here.is_file() or (name == "guidance" and here.is_dir()):
            cells[name] = str(here)
    settings = {name: cell for name, cell in cells.items() if "." in name}
    options = {name: cell for name, cell in cells.items() if name not in settings}
    return Row(line, options.pop("prompt", ""), options.pop("name", ""), options, settings)
