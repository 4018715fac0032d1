"""Networks of solids that know a few nouns: the tables of all are large."""

from collections.abc import Iterator
from contextlib import contextmanager
from unittest import mock

from core.guidance.builtin.solid_net import KINDS
from core.prior import solid_kinds, solid_training
from core.prior.data import NOUNS
from core.prior.solid_training import WORDS


def words_of(few: int) -> tuple[int, ...]:
    """The sizes of the tables of the first nouns."""
    return (few, *WORDS[1:3], KINDS * few)


@contextmanager
def knowing(few: int) -> Iterator[None]:
    """A training of the first nouns knows no others."""
    with (
        mock.patch.object(solid_training, "WORDS", words_of(few)),
        mock.patch.object(solid_training, "NOUNS", NOUNS[:few]),
        mock.patch.object(solid_kinds, "NOUNS", NOUNS[:few]),
    ):
        yield
