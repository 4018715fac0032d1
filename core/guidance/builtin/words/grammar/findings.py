"""The words of a parsed prompt, and the notes on it. Standard library only."""

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any

from core.guidance.builtin.part_forms import is_solid
from core.guidance.builtin.words.grammar.accents import StatedPart, accents_of
from core.guidance.builtin.words.grammar.counts import Counted
from core.guidance.builtin.words.grammar.lexicon import SLOTS, Entry, Vocabulary, look_up
from core.guidance.builtin.words.grammar.measures import Size
from core.guidance.builtin.words.grammar.part_names import (
    always_has,
    borne,
    can_lack,
    counted_name,
    lacked,
    may_state,
    own_names,
)
from core.guidance.builtin.words.grammar.prompt_errors import (
    near_words,
    part_error,
    two_error,
    with_hint,
)
from core.guidance.builtin.words.tables.colors import shade
from core.guidance.builtin.words.tables.count_words import number_of
from core.guidance.builtin.words.tables.kind_sizes import KIND_SIZES
from core.guidance.builtin.words.tables.part_tables import LEGS, MANY_LEGS, OPTIONS, WHOLE
from core.guidance.builtin.words.tables.sorts import Sort
from core.guidance.builtin.words.tables.words import COUNTS, LOOKS

FOUND = (*SLOTS, "weather", "sheen")
NOT_APART = "that is not a separate part here"
MADE_AS = {"pattern": "drawn as", "shape": "made"}  # else "made as"


@dataclass
class Findings:
    """A prompt's words by slot, the descriptions of parts, and words without effect."""

    known: Vocabulary
    found: dict[str, list[Entry]] = field(default_factory=lambda: {slot: [] for slot in FOUND})
    parts: list[StatedPart] = field(default_factory=list)
    left_out: list[str] = field(default_factory=list)  # all words without effect, in order
    aside: list[str] = field(default_factory=list)  # accessories, also without effect
    qualifiers: list[str] = field(default_factory=list)  # of ``left_out``, before a noun
    refused: list[str] = field(default_factory=list)  # essential to the prompt
    notes: list[str] = field(default_factory=list)
    is_statue: bool = False
    is_toy: bool = False
    size_words: list[str] = field(default_factory=list)  # "small" and the like, of the whole
    young: list[str] = field(default_factory=list)  # "cub" and the like, behind the noun
    scale: float = 1.0  # factor on the thing's usual size
    figure: Entry | None = None  # the colour of stripes or dots on the thing's own
    sizes: list[Size] = field(default_factory=list)
    sort: Sort = field(default_factory=Sort)  # named by a shape that is a sort of the thing
    counted: Counted = field(default_factory=Counted)  # number of the thing

    @property
    def thing(self) -> str:
        """The first noun, or ""."""
        return self.found["noun"][0].word if self.found["noun"] else ""

    def counts(self) -> dict[str, int]:
        """The number of words in each slot."""
        return {slot: len(found) for slot, found in self.found.items()}

    def taken_back(self, before: dict[str, int]) -> list[str]:
        """Take back the words found since the slots had as many words as ``before``; their
        forms."""
        taken = []
        for slot, count in before.items():
            taken += [entry.form for entry in self.found[slot][count:]]
            del self.found[slot][count:]
        return taken

    def words(self, slot: str) -> list[str]:
        """The slot's words, each once."""
        return list(dict.fromkeys(entry.word for entry in self.found[slot]))

    def only(self, slot: str) -> str:
        """The slot's one word, or ""; the first of several: "a wooden and metal chair"."""
        words = self.words(slot)
        if slot == "noun" and len(words) > 1:
            raise two_error("thing", words)
        for entry in self.found[slot]:
            if entry.word != words[0]:
                self.leave_aside([entry.form], f"one {slot} is taken")
        return words[0] if words else ""

    def size(self) -> Size | None:
        """The stated size; the first of several, as the others would stretch the thing."""
        for more in self.sizes[1:]:
            self.leave_aside([f"{more.metres:g} m"], "one size is taken")
        return self.sizes[0] if self.sizes else None

    def kind_size(self) -> float:
        """The length of the kind as written, in metres; 0: as the thing itself. The smallest of
        several: "a labrador puppy"."""
        own = []
        for entry in self.found["noun"]:
            size = KIND_SIZES.get(entry.word, {}).get(entry.form)
            if size is None and not entry.is_narrower:  # "a house and a shed" is a house
                break
            own += [size] if size else []
        return min(own, default=0.0)

    def leave_aside(self, forms: list[str], why: str) -> None:
        """Leave out forms that belong together, with a reason of their own."""
        self.aside += forms
        self.notes.append(f"{' '.join(forms)}: left out, as {why}.")

    def take_as_sort(self, given: Collection[str]) -> None:
        """Keep words for a sort of the thing, which is not a shape of its own."""
        forms = [one for form in given for one in (form, f"{form}s")]
        words = {word for form in forms for word in (form, *form.split())}
        self.left_out = [one for one in self.left_out if not words.issuperset(one.split())]
        self.aside = [one for one in self.aside if one not in words]
        self.notes = [note for note in self.notes if note.partition(": left out")[0] not in words]
        self.found["shape"] = [one for one in self.found["shape"] if one.form not in words]

    def strange_parts(self) -> list[StatedPart]:
        """Take out parts that the thing never has, such as icing on a torus; a part that may be
        stated is refused where it is unknown."""
        strange = [
            part
            for part in self.parts
            if self.thing
            and part.there
            and not may_state(self.thing, part.name)
            and not always_has(self.thing, part.name)
        ]
        self.parts = [part for part in self.parts if part not in strange]
        return strange

    def narrower(self) -> list[str]:
        """A note for each word that is made as a wider one."""
        of_parts = [part.material for part in self.parts if part.material]
        return [
            f"{entry.form}: {MADE_AS.get(entry.slot, 'made as')} "
            f"{with_article(entry.slot, entry.word)}."
            for entry in [*(x for entries in self.found.values() for x in entries), *of_parts]
            if entry.is_narrower
        ]

    def omissions(self) -> list[str]:
        """Notes for all words left out. A qualifier comes with the colour or similar that it may
        mean; the others have no suggestions."""
        left = dict.fromkeys(self.left_out)
        entries = {token: look_up(token, self.known) for token in left}
        looks = [token for token, entry in entries.items() if entry and entry.slot in LOOKS]
        nouns = [token for token, entry in entries.items() if entry and entry.slot == "noun"]
        things, given = (
            [token for token in nouns if (token in self.qualifiers) == only]
            for only in (False, True)
        )
        counts = [token for token in left if token in COUNTS]
        unknown = [
            with_hint(token, near_words(token, self.qualifiers, self.known))
            if token in self.qualifiers
            else repr(token)
            for token in left
            if token not in (*looks, *nouns, *counts)
        ]
        notes = {
            f"{', '.join(map(repr, looks))}: left out with the unknown words next to it.": looks,
            f"{', '.join(map(repr, things))}: left out, as one thing is made at a time.": things,
            f"{', '.join(map(repr, given))}: left out, as it is not drawn.": given,
            f"{', '.join(map(repr, counts))}: left out, as parts are not counted.": counts,
            f"The built-in model does not know {', '.join(unknown)}: left out.": unknown,
        }
        return [note for note, tokens in notes.items() if tokens]

    def colors(self) -> dict[str, Any]:
        """The first colour, the second, the pattern that a second one implies, the part of the
        second, and the colours of other parts."""
        entries = self.found["color"]
        colors = list(dict.fromkeys((entry.word, shade(*entry[1:])) for entry in entries))
        for one in colors[2:]:
            self.leave_aside([one[1] or one[0]], "two colours are taken")
        if self.figure:
            drawn = (self.figure.word, shade(*self.figure[1:]))
            rest = [one for one in colors if one != drawn] or self._ground()
            colors = [*(rest[:1] or [("", "")]), drawn, *rest[1:]]
        # In the order of the prompt: the first is the thing's, the next the pattern's.
        (color, form), (second, other) = (*colors, ("", ""), ("", ""))[:2]
        # A second colour needs a place: without a pattern it goes to the accent parts.
        pattern = self.only("pattern") or ("two-tone" if second else "")
        accents, again = accents_of(self.parts, self.thing)
        for more in again:
            self.leave_aside([more], "a part has one colour, material, sheen and pattern")
        target = ""
        plain = (accent for accent in accents if accent.color and not accent.pattern)
        first = next(plain, None)
        if first and not pattern:
            second, other, target = first.color, first.color_form, first.part
            accents[accents.index(first)] = first._replace(color="", color_form="")
        stated = tuple(accent for accent in accents if any(accent[1:]))
        found = {"color": color, "second": second, "pattern": pattern, "target": target}
        return found | {"color_form": form, "second_form": other, "accents": stated}

    def part_sizes(self, noun: str) -> tuple[tuple[str, str], ...]:
        """Each part that has a size of its own, and the words for it."""
        found: dict[str, str] = {}
        for part in self.parts:
            if not (part.sizes and part.there and noun):
                continue
            names = own_names(noun, part.name) or own_names(noun, part.form)
            solid = [name for name in names if is_solid(noun, name)]
            if not solid:
                self.leave_aside(list(part.sizes), NOT_APART)
            for name in solid:
                found.setdefault(name, " ".join(part.sizes))
        return tuple(found.items())

    def part_counts(self, noun: str) -> tuple[tuple[str, int], ...]:
        """Each part with a stated number of components, which is then no word without effect."""
        found: dict[str, int] = {}
        for part in self.parts:
            count = LEGS.get(part.name, 0) or number_of(part.number)
            name = counted_name(noun, part.name) or counted_name(noun, part.form)
            if not (count and part.there and name) or part.name in OPTIONS.get(noun, ()):
                continue
            found.setdefault(name, count)
            if part.number in self.left_out:
                self.left_out.remove(part.number)
        return tuple(found.items())

    def _ground(self) -> list[tuple[str, str]]:
        """The colour of the whole below stripes, taken from its description as a part: "red paint,
        white stripes"."""
        for at, part in enumerate(self.parts):
            if part.form in WHOLE and part.color and not part.pattern:
                self.parts[at] = part._replace(color="", color_form="")
                return [(part.color, part.color_form)]
        return []

    def options(self, noun: str) -> list[str]:
        """The words that may be stated for the noun's parts."""
        return [state for state in OPTIONS.get(noun, ()) if state in self.known["part"]]

    def part(self, noun: str) -> str:
        """The stated word of ``PARTS`` for the noun, or ""."""
        states = []
        for part, there, form, *_ in self.parts:
            state = part if there else f"no {part}"
            if state in self.options(noun):
                states.append(state)
            elif there and part in LEGS and counted_name(noun, part):
                states.append(MANY_LEGS)
            elif noun and there and not always_has(noun, part):
                raise part_error(noun, form, there, self.options(noun))
        if not states and MANY_LEGS in self.options(noun):  # "a table with white legs"
            states += [MANY_LEGS for part in self.parts if part.there and part.form == "legs"]
        if len(set(states)) > 1:
            raise two_error("part", states)
        return states[0] if states else ""

    def absent(self, noun: str) -> tuple[str, ...]:
        """The noun's parts that are left out on request."""
        names = []
        for part, there, form, *_ in self.parts:
            if there or not noun:
                continue
            if name := lacked(noun, part, form):
                names += [name, *borne(noun, name)]
                if not can_lack(noun, names):
                    raise part_error(noun, form, there, self.options(noun))
            elif f"no {part}" not in self.options(noun):
                self.aside.append(f"without {form}")
                self.notes.append(f"without {form}: left out, as {NOT_APART}.")
        return tuple(dict.fromkeys(names))


PLURAL = frozenset(
    """headphones trousers sunglasses scissors grapes fries pancakes maracas binoculars pliers
    goggles""".split()
)


def with_article(slot: str, word: str) -> str:
    """A noun with its article; any other word, a pair or a plural unchanged."""
    if slot != "noun" or word in PLURAL:
        return word
    voiced = word[0] in "aeiou" and not word.startswith(("uni", "uku", "ufo"))
    return f"{'an' if voiced else 'a'} {word}"
