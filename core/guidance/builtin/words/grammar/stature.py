"""The size, the roundness and the age of a prompt's thing. Standard library only."""

from core.guidance.builtin.nouns import CONSTRUCTED
from core.guidance.builtin.part_forms import is_round
from core.guidance.builtin.words.grammar.findings import with_article
from core.guidance.builtin.words.grammar.likeness import Likeness
from core.guidance.builtin.words.tables.kind_sizes import YOUNG, YOUNG_KINDS, YOUNG_SCALE
from core.guidance.builtin.words.tables.living import is_animal, is_creature, is_somebody
from core.guidance.builtin.words.tables.sorts import sort_of
from core.guidance.builtin.words.tables.words import PLUMP, SIZE_WORDS


class Stature(Likeness):
    """The parsed size and form of the whole thing."""

    def _set_size(self) -> None:
        """Apply "small" and similar words."""
        for more in self.got.size_words[1:]:
            self.got.leave_aside([more], "one size is taken")
        for word in self.got.size_words[:1]:
            if self.got.sizes or self.got.is_toy:
                self.got.leave_aside([word], "another size is stated")
            else:
                self.got.scale = SIZE_WORDS[word]
                self.got.notes.append(f"{word}: made {self.got.scale:g} times its usual size.")

    def _set_roundness(self) -> None:
        """A round table is another table, not a swollen one; a round cat is a plump one."""
        thing, shapes = self.got.thing, self.got.found["shape"]
        rigid = thing in CONSTRUCTED
        stated = [one for one in shapes if one.word == "round" and (rigid or one.form not in PLUMP)]
        if not thing or thing == "table" or is_creature(thing):  # the network knows a round table
            return
        for one in stated:
            shapes.remove(one)
            if sort := sort_of(thing, one.word):
                self.got.sort = sort
            elif rigid or not is_round(thing):
                why = f"{with_article('noun', thing)} keeps its own form here"
                self.got.leave_aside([one.form], why)

    def _set_age(self) -> None:
        """A cub is smaller than an adult."""
        thing, young = self.got.thing, [one for one in self.got.qualifiers if one in YOUNG]
        alive = is_animal(thing) or is_somebody(thing)
        forms = {word for one in self.got.found["noun"] for word in one.form.split()}
        if not alive or self.got.sizes or self.got.is_toy or forms & YOUNG_KINDS:
            return
        for word in [*young, *self.got.young][:1]:
            self.got.left_out = [one for one in self.got.left_out if one not in young]
            self.got.scale = round(YOUNG_SCALE * self.got.scale, 4)
            self.got.notes.append(f"{word}: made {YOUNG_SCALE:g} times the size of a grown one.")
