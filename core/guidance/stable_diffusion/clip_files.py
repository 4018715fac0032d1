"""CLIP's vocabulary, which comes with the project: a one-file checkpoint holds none.

``configurations/tokenizer/merges.txt`` is OpenAI's byte-pair table (CLIP, MIT licence); the tokens'
numbers follow from it.
"""

from pathlib import Path
from typing import Final

CONFIGURATIONS: Final = Path(__file__).parent / "configurations"
START, END = "<|startoftext|>", "<|endoftext|>"


def merges(path: Path) -> list[tuple[str, str]]:
    """The pairs of a merges.txt in their order; its first line is a version."""
    lines = path.read_text(encoding="utf-8").split("\n")[1:]
    return [(a, b) for a, b in (line.split() for line in lines if line)]


def vocabulary(pairs: list[tuple[str, str]]) -> dict[str, int]:
    """Each token's number: bytes, bytes that end a word, merged pairs, start and end."""
    printable = [*range(33, 127), *range(161, 173), *range(174, 256)]
    # GPT-2's alphabet: a byte that does not print is a character from 256 on.
    alphabet = [chr(b) for b in printable] + [chr(256 + i) for i in range(256 - len(printable))]
    tokens = [*alphabet, *(c + "</w>" for c in alphabet), *(a + b for a, b in pairs), START, END]
    return {token: number for number, token in enumerate(tokens)}
