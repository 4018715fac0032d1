"""A prompt's clauses while it is parsed: of the thing, of its accessories, of another thing.

Standard library only.
"""

from core.guidance.builtin.words.grammar.accents import StatedPart
from core.guidance.builtin.words.grammar.findings import Findings
from core.guidance.builtin.words.grammar.lexicon import LEXICON, SLOTS, Entry, Vocabulary, look_up
from core.guidance.builtin.words.grammar.part_names import is_own, may_state, own_name, owns
from core.guidance.builtin.words.grammar.tokens import MADE, Tokens, describes
from core.guidance.builtin.words.grammar.wider import is_wider
from core.guidance.builtin.words.tables.colors import RAINBOW
from core.guidance.builtin.words.tables.living import ROLES, is_creature
from core.guidance.builtin.words.tables.part_tables import LEGS, SURFACE, WHOLE
from core.guidance.builtin.words.tables.words import (
    ALONE,
    ARTICLES,
    COUNTED,
    COUNTS,
    DEPICTIONS,
    FILLER,
    IGNORED_ADJECTIVES,
    LOOKS,
    PHRASE_ENDS,
    WITHOUT,
)

EITHER = ("or", "nor")
VERY = "is really very so super quite just".split()
# Behind these and "not" the negation continues: "does not have wheels", "not made of wood".
HAVING = (*"have has made of from in it make want".split(), *MADE)
NOT_GIVEN = "nothing else is given in its place"
# Parts that a size before them applies to: "a big eyed owl".
OF_PARTS = "eyed eared nosed headed footed legged handed tailed toothed bellied".split()
STONES = ("stone", "rock")
MADE_OF = ("of", "from", "in", "out")


def _says_little(word: str) -> bool:
    """Whether it is filler, or an adjective without effect."""
    return word in (FILLER | IGNORED_ADJECTIVES) - PHRASE_ENDS or describes(word)


class Clauses:
    """The state of a parse: the words found, and their meaning in the current clause."""

    def __init__(self, prompt: str, known: Vocabulary, alone: bool) -> None:
        self.known = known
        self._alone = alone
        self.got = Findings(known)
        self._pending: list[str] = []  # unknown words since the start of the noun phrase
        self._before: list[StatedPart] = []  # parts in a phrase without a noun so far
        self._without = False
        self._part_sizes: list[str] = []  # sizes of the phrase's part, so far
        self._number = ""  # of the phrase's part, as it is written
        self._looks: list[str] = []  # slots of the colours and materials right before
        # Each slot's number of words at the start of an accessory's phrase; else None
        self._accessory: dict[str, int] | None = None
        self._strange = False  # whether the phrase's last parsed word is unknown
        self._depicted = ""  # the thing is a statue, a figure or similar: as written
        self._block: Entry | None = None  # the stated material of the whole thing
        self._made_of = False  # whether it is "made of" that
        self._made_as: list[str] = []  # words before the thing for its material
        self._of_another = False  # whether all of the phrase is about another thing
        self._started: dict[str, int] = {}  # each slot's number of words at the start of the phrase
        self._late = False  # whether a comma has ended the clause that has the thing
        self._clause: dict[str, int] = {}  # each slot's number of words at the start of the clause
        self._ended_by = ""  # the phrase's first word
        self._has_article = False
        self._aside_end = -1  # the index behind the last accessory's noun
        self._noun_end = -1  # the index behind the last noun, if nothing ended its phrase
        self._tokens = Tokens.of(prompt, known)

    def _end_clause(self) -> None:
        """End the clause, at a comma or similar."""
        self._end_phrase()
        self._without, self._ended_by = False, ""
        self._accessory, self._of_another = None, False
        self._late, self._clause = bool(self.got.found["noun"]), self.got.counts()

    def _is_wider(self, token: str, at: int) -> bool:
        """Whether a word right behind the thing only names its class, and starts no other thing's
        name: "a bird bath"."""
        if self._noun_end != at:
            return False
        longer = self._tokens.phrases(at)[:-1]
        other = any(look_up(phrase, self.known) for phrase in longer)
        return not other and is_wider(token, self.got.found["noun"][-1].word)

    def _is_part_of_look(self, entry: Entry, tokens: list[str]) -> bool:
        """Whether another thing's name, or its part's, is a part of the thing with its look or
        number: "a cactus in a terracotta pot", "a typewriter with black keys", although a piano has
        keys, "a cake with three candles"."""
        *looks, last = tokens
        thing = self.got.thing
        is_anothers = entry.slot == "noun" or (
            entry.slot == "part" and not own_name(thing, entry.word)
        )
        if not looks or not is_anothers or not is_own(thing, last):
            return False
        if entry.slot == "noun":
            looks = [word for word in looks if word not in COUNTS]
        known = [look_up(word, self.known) for word in looks]
        return all(one is not None and one.slot in LOOKS for one in known)

    def _is_look_of_thing(self, entry: Entry, at: int, count: int) -> bool:
        """Whether a thing's name is a material and another thing's first word: "a metal bar
        stool"."""
        if entry.slot != "noun" or count == 1 or at + count in self._tokens.breaks:
            return False
        words = self._tokens.words
        first = look_up(words[at], self.known)
        behind = " ".join(words[at + count - 1 : at + count + 1])
        is_look = first is not None and first.slot in LOOKS
        return (
            is_look and count == 2 and behind != words[at + 1] and bool(self._tokens.thing(behind))
        )

    def _is_before_name(self, entry: Entry, at: int, count: int) -> bool:
        """Whether the last word of a material starts a thing's name: "two scoops of ice cream"."""
        begins = entry.slot == "material" and count > 1 and self._tokens.words[at] in MADE_OF
        last = at + count - 1
        name = " ".join(self._tokens.words[last : last + 2])
        return begins and last + 1 not in self._tokens.breaks and bool(self._tokens.thing(name))

    def _is_thing_and_color(self, entry: Entry, at: int, count: int) -> bool:
        """Whether a shade that starts with a thing's name is that thing: "a pumpkin orange with a
        stem"; or its last word starts another name: "a periwinkle blue jay"."""
        if entry.slot != "color" or count == 1 or self.got.found["noun"]:
            return False
        words = self._tokens.words
        other = " ".join(words[at + count - 1 : at + count + 1])
        if at + count not in self._tokens.breaks and self._tokens.thing(other):
            return True
        named = self._tokens.thing(" ".join(words[at : at + count - 1]))
        return bool(named) and self._is_phrase_end(at + count) and self._is_first(at)

    def _are_things(self, entry: Entry, phrase: str) -> bool:
        """Whether a material's plural is not a material, "a campfire with stones"; or a word for
        most of the thing belongs to another: "a mug full of paint"."""
        if self._of_another and entry.word in WHOLE:
            return True
        of = self._ended_by in MADE_OF
        return entry.slot == "material" and phrase not in LEXICON and not of

    def _end_phrase(self) -> None:
        """End a noun phrase: its unknown words qualified no known noun. The last of them is the
        phrase's own noun."""
        # The accessory is unknown, or all is of another thing: its colours are not the thing's.
        if self._strange or self._of_another:
            self.got.left_out += self._of_accessory()
        self._leave_what_it_is_not()
        for size in self._part_sizes:
            self.got.leave_aside([size], "only the whole thing and its parts have a size")
        self._part_sizes, self._number = [], ""
        self.got.parts += self._before
        # "A chair and an okapi" are two things; "a vase of blue china and gold cracks" is one.
        looked = not self._has_article and self._started != self.got.counts()
        beside = self._late or self._ended_by != "and" or looked
        if self.got.found["noun"] and self._noun_end < 0 and beside:
            # "a car, exposed copper pipes": of an accessory.
            if self._strange:
                self.got.left_out += self._taken_back(self._started)
        else:
            self.got.refused += self._unknown_things()
        self.got.qualifiers += self._pending[:-1]
        self._pending, self._before, self._noun_end, self._looks = [], [], -1, []
        self._started, self._strange, self._has_article = self.got.counts(), False, False

    def _unknown_things(self) -> list[str]:
        """The unknown words of a phrase; the last may be named like a part: the scale of "a kitchen
        scale"."""
        *others, last = self._pending or [""]
        called = self._before[-1].form if self._before and not self._strange else ""
        if not last or not called or called in SURFACE or self.got.found["noun"]:
            return self._pending
        return [*others, f"{last} {called}"]

    def _leave_what_it_is_not(self) -> None:
        """ "A chair, not wooden", "a not red apple"."""
        if self._without and (forms := self._looks_before()):
            self.got.leave_aside(["not", *forms], NOT_GIVEN)

    def _go_with(self, word: str) -> None:
        """Start a phrase about an accessory with ``word``."""
        self._end_phrase()
        made_of, self._ended_by = self._ended_by in ("of", "from", "out"), word
        # "between the blue and emerald pieces" is one phrase.
        if word != "and" or self._accessory is None or made_of:  # "of scrap and car springs"
            self._accessory = self.got.counts()

    def _leave_out(self, unknown: str, count: int) -> int:
        """Leave out an unknown word, or a phrase of ``count``."""
        self.got.left_out.append(unknown)
        self._strange = True
        # An accessory may be unknown, the thing itself may not.
        if self._accessory is None and not self._without:
            self._pending.append(unknown)
        return count

    def _color_before(self) -> Entry | None:
        """Take back the one colour at the start of the accessory's phrase or of the clause: ", red
        and white striped sails"."""
        started = self._accessory or (self._clause if self._late else {})
        colors = self.got.found["color"]
        return colors.pop() if started and len(colors) == started.get("color", 0) + 1 else None

    def _is_phrase_end(self, end: int) -> bool:
        """Whether a phrase ends before the token ``end`` and is not a quality of another: "a rock
        with moss", but not "orange and blue", "in orange"."""
        return self._ended_by not in ("and", "in", "with") and self._tokens.ends_phrase(end)

    def _is_first(self, at: int) -> bool:
        """Whether only an article or similar is before the index."""
        return all(word in FILLER for word in self._tokens.words[:at])

    def _is_next_to(self, entry: Entry, start: int, end: int) -> bool:
        """Whether a material or a colour is another thing that accompanies the thing."""
        stands = (
            entry.slot in ("material", "color") and entry.form in ALONE and self._is_phrase_end(end)
        )
        own = own_name(self.got.thing, entry.form)  # a lantern's glass
        one = entry.form in COUNTED and self._ended_by not in MADE_OF and not own
        stands |= (one or entry.form == RAINBOW) and self._tokens.ends_phrase(end)
        if not stands or self._accessory is None:
            return False
        begin = self._tokens.qualities_begin(start)
        while begin and self._tokens.words[begin - 1] == "and":  # "with a red and white cloth"
            begin = self._tokens.qualities_begin(begin - 1)
        before = self._tokens.words[:begin]
        while before and _says_little(before[-1]):  # "on a small rock", "on a flat-topped rock"
            before.pop()
        return bool(before) and before[-1] in ARTICLES

    def _lacks_more(self, tokens: list[str]) -> bool:
        """Whether a list of missing parts continues: "without wheels or windows", "without wheels
        and windows", but not "without wheels and a red roof"."""
        before, after = self.got.parts[-1:], tokens[1] if tokens[1:] else ""
        if not before or before[0].there or tokens[0] not in (*EITHER, "and"):
            return False
        entry = look_up(after, self.known)
        return (
            tokens[0] in EITHER
            or self._is_own(after)
            or (entry is not None and entry.slot == "part")
        )

    def _is_own(self, form: str) -> bool:
        """Whether the thing has a part of this name, whatever it means elsewhere: "a printer with
        white paper", "a tiger with blue stripes", "a hot dog with mustard"."""
        if self._ended_by in MADE_OF or form in SLOTS["color"]:
            return False
        return is_own(self.got.thing, form)

    def _is_its_size(self, at: int) -> bool:
        """Whether a size applies to the whole thing, as before its name, and not to a part: "a
        small robot with big eyes"."""
        words, ends = self._tokens.words, self._tokens.ends_phrase(at + 1)
        entry = None if ends else look_up(words[at + 1], self.known)
        if not self.got.found["noun"]:
            if words[at] == "little" and not ends:  # "a little bit", "a little rusty"
                how = entry is not None and (entry.slot == "weather" or entry.word == "rusty")
                return not (how or words[at + 1] == "bit")
            of_part = entry is not None and entry.slot == "part"
            return not (of_part or (not ends and words[at + 1] in OF_PARTS))
        begins = at in self._tokens.breaks or words[at - 1] in VERY or self._noun_end == at
        # "A car, small and red", but not "big and red wheels".
        end = next(k for k in range(at + 1, len(words) + 1) if self._tokens.ends_phrase(k))
        rest = words[at + 1 : end]
        more = rest and (rest[0] != "and" or own_name(self.got.thing, rest[-1]))
        return begins and not more and self._accessory is None

    def _goes_on(self, token: str, at: int) -> bool:
        """Whether a negation continues behind a word that ends a phrase."""
        if token in ARTICLES:
            return True
        before = self._tokens.words[at - 1] if at else ""
        return token in HAVING and before in (*WITHOUT, *HAVING, *ARTICLES)

    def _is_manner(self, token: str, at: int) -> bool:
        """Whether a word only states how the look behind it was made."""
        if token not in MADE or at + 1 in self._tokens.breaks:
            return False
        looked = (look_up(phrase, self.known) for phrase in self._tokens.phrases(at + 1))
        return bool(self._tokens.toned(at + 1)) or any(one and one.slot in LOOKS for one in looked)

    def _is_stone(self, entry: Entry, end: int) -> bool:
        """Whether a stone is a gem of a thing with gems: "a ring with a blue stone"."""
        own = entry.form in STONES and self._has_gems() and self._ended_by not in MADE_OF
        ended = self._tokens.ends_phrase(end) or self._tokens.words[end] == "and"
        return own and ended

    def _names_a_part(self, entry: Entry, start: int, end: int) -> bool:
        """Whether another thing, or a word for the whole, describes the part right behind it: "a
        lamp with a dolphin base", "a dresser with shell knobs"."""
        if not self.got.found["noun"] or self._noun_end == start or end in self._tokens.breaks:
            return False
        thing, behind = self.got.thing, next(iter(self._tokens.words[end : end + 1]), "")
        strange = entry.slot == "part" and not own_name(thing, entry.word)
        other = entry.slot == "noun" or strange or entry.word in WHOLE
        return other and owns(thing, behind) and not is_own(thing, entry.form)

    def _is_another(self, end: int) -> bool:
        """Whether an excluded thing is named before the requested one."""
        if self.got.found["noun"] or self._looks:
            return False
        return any(map(self._tokens.has_thing, range(end, len(self._tokens.words))))

    def _has_gems(self) -> bool:
        return any(own_name(noun.word, "gem") for noun in self.got.found["noun"])

    def _is_owner(self, entry: Entry, end: int) -> bool:
        """Whether the noun owns the words behind it: "a knight's shield", "a knights shield"."""
        living = is_creature(entry.word)
        plural = self._tokens.words[end - 1] == f"{entry.form}s"
        return (living and plural) or end - 1 in self._tokens.owners

    def _owns_what_follows(self, end: int) -> bool:
        """Whether a thing's name follows, or its look and that: "women's red shoes"."""
        return self._tokens.has_thing(self._tokens.qualities_end(end, (*LOOKS, "weather")))

    def _is_of_material(self, entry: Entry, end: int) -> bool:
        """Whether a shape describes the material behind it: "a bottle of thick clear glass"."""
        if entry.word not in ("thick", "thin"):
            return False
        looked = ((look_up(phrase, self.known), phrase) for phrase in self._tokens.phrases(end))
        found = next(((one, phrase) for one, phrase in looked if one), None)
        if found is None or found[0].slot != "material":
            return False
        return self._tokens.ends_phrase(end + len(found[1].split()))

    def _is_description(self, entry: Entry, start: int) -> bool:
        """Whether a noun only describes the thing: "a goblin archer", "a goblin, character"."""
        role = is_creature(self.got.thing) and self._noun_end == start and entry.word in ROLES
        return role or (self._late and self._accessory is None and entry.form in DEPICTIONS)

    def _is_another_such(self, entry: Entry) -> bool:
        """Whether another thing that is made like the first is named next to it: "a salt shaker and
        a pepper mill"."""
        first = self.got.found["noun"][0]
        listed = self._ended_by == "and" and self._has_article and self._noun_end < 0
        return listed and entry.word == first.word and entry.form != first.form

    def _is_its_name(self, entry: Entry) -> bool:
        """Whether a material only ends the thing's own name: "a lego style red brick"."""
        own = self.got.thing.split()[1:]
        named = entry.slot == "material" and own[-1:] == [entry.form]
        return named and self._ended_by not in MADE_OF

    def _is_head(self, part: str, start: int) -> bool:
        """Whether a part that the thing right before it lacks is the thing that is meant: "a guitar
        case"."""
        if self._noun_end != start or self._without or part in SURFACE:
            return False
        noun = self.got.found["noun"][-1].word
        return not (may_state(noun, part) or owns(noun, part) or part in LEGS)

    def _leave_aside(self, form: str, why: str = "one thing is made at a time") -> None:
        self.got.leave_aside([*self._of_accessory(), form], why)

    def _of_accessory(self) -> list[str]:
        """Take back the colours and similar words of an accessory's phrase; their forms."""
        return self._taken_back(self._accessory or {})

    def _taken_back(self, before: dict[str, int]) -> list[str]:
        self._looks = []
        return self.got.taken_back(before)

    def _looks_before(self) -> list[str]:
        """Take back the colours and similar words right before; their forms."""
        slots, self._looks = self._looks, []
        return [self.got.found[slot].pop().form for slot in reversed(slots)][::-1]
