"""A prompt's words, sorted into slots: the grammar of the built-in prior. Standard library only."""

import re

from core.guidance.builtin.accents import StatedPart
from core.guidance.builtin.colors import RAINBOW, shade
from core.guidance.builtin.compounds import set_parts_apart
from core.guidance.builtin.findings import Findings, with_article
from core.guidance.builtin.lexicon import (
    LEXICON,
    MEANT,
    SLOTS,
    Entry,
    Vocabulary,
    corrected,
    corrected_phrase,
    look_up,
    singulars,
)
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.part_names import (
    as_part,
    is_own,
    is_wide,
    looks_of,
    may_state,
    own_name,
)
from core.guidance.builtin.tokens import DOING, Tokens, describes
from core.guidance.builtin.variants import has_own_look
from core.guidance.builtin.wider import is_wider
from core.guidance.builtin.word_order import set_in_order
from core.guidance.builtin.words import (
    ALIVE,
    ALONE,
    ARTICLES,
    AS_MATERIAL,
    COUNTS,
    DEPICTIONS,
    FIGURES,
    FILLER,
    GEMS,
    GOES_WITH,
    IGNORED_ADJECTIVES,
    LEGS,
    LOOKS,
    OF_ANOTHER,
    PHRASE_ENDS,
    PLAIN,
    ROLES,
    SURFACE,
    SURROUNDINGS,
    TOYS,
    WHOLE,
    WITHOUT,
)

EITHER = ("or", "nor")
MADE_OF = ("of", "from", "in", "out")


class Reading:
    """A prompt's words, sorted into slots.

    ``alone``: what ends a phrase is a thing if it can be one: "a grey rock" is a boulder.
    """

    def __init__(self, prompt: str, known: Vocabulary, alone: bool = False) -> None:
        self.known = known
        self._alone = alone
        self.got = Findings(known)
        self._pending: list[str] = []  # unknown words since the noun phrase began
        self._before: list[StatedPart] = []  # parts in a phrase that has no noun yet
        self._without = False
        self._looks: list[str] = []  # slots of the colours and materials right before
        # How many words each slot had when a phrase about what goes with the thing began; else None
        self._accessory: dict[str, int] | None = None
        self._strange = False  # whether the last word that was read in the phrase is unknown
        self._of_another = False  # whether all of it is about another thing
        self._begun: dict[str, int] = {}  # how many words each slot had when the phrase began
        self._late = False  # whether a comma has ended the clause that has the thing
        self._ended_by = ""  # the word that began the phrase
        self._aside_end = -1  # the index behind the last noun that goes with the thing
        self._noun_end = -1  # the index behind the last noun, if nothing ended its phrase
        self._tokens = Tokens.of(prompt, known)
        self.got.sizes = self._tokens.sizes
        self.got.left_out += self._tokens.measures
        set_in_order(self._tokens)
        set_parts_apart(self._tokens)
        at = 0
        while at < len(self._tokens.words):
            if at in self._tokens.breaks:
                self._end_phrase()
                self._without = False
                self._accessory, self._of_another = None, False
                self._late = bool(self.got.found["noun"])
            at += self._take(at)
        self._end_phrase()
        self._leave_strange_parts_aside()
        self._make_as_qualified()

    def _take(self, at: int) -> int:
        """Read from the token ``at`` on; how many tokens that were."""
        tokens = self._tokens.words[at:]
        token = tokens[0]
        if self._is_wider(token, at):  # "a corgi puppy", "a fox animal"
            self._noun_end = at + 1
            return 1
        if toned := self._tokens.toned(at):
            self._put(toned[0], at, at + toned[1])
            return toned[1]
        for phrase in self._tokens.phrases(at):
            entry, count = look_up(phrase, self.known), len(phrase.split())
            if entry is not None and self._is_part_of_look(entry, tokens[:count]):
                continue
            if (entry is None or entry.slot not in ("noun", "part")) and self._is_own(phrase):
                entry = Entry("part", phrase, phrase)
            if entry is not None and self._are_things(entry, phrase):
                return self._leave_out(phrase, count)
            if entry is not None:
                self._put(entry, at, at + count)
                return count
            if count > 1 and phrase in IGNORED_ADJECTIVES:
                self.got.left_out.append(phrase)
                return count
            if phrase in OF_ANOTHER and self.got.found["noun"]:
                self._go_with(phrase)
                self._of_another = True
                return count
            if re.fullmatch("letter [a-z0-9]", phrase):  # which is no envelope
                return self._leave_out(phrase, count)
            # "a computer mouse" is no mouse.
            if count > 1 and any(form in MEANT for form in singulars(phrase)):
                return self._leave_out(phrase, count)
        if token in WITHOUT:
            self._without = True
            self._end_phrase()
        elif token in IGNORED_ADJECTIVES:
            self.got.left_out.append(token)
            # Of the thing itself: not "a child with a toy".
            self.got.is_toy |= token in TOYS and self._accessory is None
        elif token in COUNTS and not self.got.found["noun"]:
            self.got.notes.append(f"{token}: one thing is made at a time.")
        elif token in COUNTS:
            self.got.left_out.append(token)
        elif token in PHRASE_ENDS:
            self._without &= token in ARTICLES
            self._without |= self._lacks_more(tokens)
            if token in EITHER and not self._without:  # "red or blue": it is both
                self.got.left_out.append(token)
            # "a statue of a lion": the article says nothing new.
            word = self._ended_by if token in ARTICLES else token
            if self.got.found["noun"] and (token in GOES_WITH or self._accessory is not None):
                self._go_with(word)
            else:
                self._end_phrase()
                self._ended_by = word
        elif token in SURROUNDINGS:  # "a candle, soft pink lighting"
            self.got.left_out += [*self._looks_before(), token]
        elif self.got.found["noun"] and DOING.fullmatch(token):
            # "a robot playing guitar"
            self.got.left_out.append(token)
            self._go_with(token)
            self._of_another = True
        elif token == "shaped" and self._noun_end == at:
            # "a heart shaped box": as if the two nouns were next to each other.
            self._noun_end += 1
        elif token not in FILLER and describes(token):
            # "a raccoon dressed up", "a rolled up mat", "1950s"; "a wall mounted radiator"
            self.got.left_out.append(token)
            self._noun_end += self._noun_end == at
        elif token not in FILLER:
            return self._correct(token, at)
        return 1

    def _is_wider(self, token: str, at: int) -> bool:
        """Whether a word right behind the thing only says what it is a sort of, and begins no
        other thing's name: "a bird bath"."""
        if self._noun_end != at:
            return False
        longer = self._tokens.phrases(at)[:-1]
        other = any(look_up(phrase, self.known) for phrase in longer)
        return not other and is_wider(token, self.got.found["noun"][-1].word)

    def _is_part_of_look(self, entry: Entry, tokens: list[str]) -> bool:
        """Whether another thing's name is a part of the thing and how it looks: "a cactus in a
        terracotta pot"."""
        *looks, last = tokens
        if not looks or entry.slot != "noun" or not is_own(self.got.thing, last):
            return False
        known = [look_up(word, self.known) for word in looks]
        return all(one is not None and one.slot in LOOKS for one in known)

    def _are_things(self, entry: Entry, phrase: str) -> bool:
        """Whether a material's plural is no material, "a campfire with stones"; or a word for most
        of the thing is about another: "a mug full of paint"."""
        if self._of_another and entry.word in WHOLE:
            return True
        of = self._ended_by in MADE_OF
        return entry.slot == "material" and phrase not in LEXICON and not of

    def _end_phrase(self) -> None:
        """A noun phrase is over: what is unknown in it qualified no known noun. The last of it is
        the phrase's own noun."""
        # The accessory is unknown, or all is of another thing: its colours are not the thing's.
        if self._strange or self._of_another:
            self.got.left_out += self._of_accessory()
        self.got.parts += self._before
        beside = self._late or self._ended_by != "and"  # "a chair and an okapi" are two things
        if self.got.found["noun"] and self._noun_end < 0 and beside:
            # "a car, exposed copper pipes": of something else, which goes with the thing.
            if self._strange:
                self.got.left_out += self._taken_back(self._begun)
        else:
            self.got.refused += self._pending
        self.got.qualifiers += self._pending[:-1]
        self._pending, self._before, self._noun_end, self._looks = [], [], -1, []
        self._begun, self._strange = self.got.counts(), False

    def _go_with(self, word: str) -> None:
        """``word`` begins a phrase about what goes with the thing."""
        self._end_phrase()
        made_of, self._ended_by = self._ended_by in ("of", "from", "out"), word
        # "between the blue and emerald pieces" is one phrase.
        if word != "and" or self._accessory is None or made_of:  # "of scrap and car springs"
            self._accessory = self.got.counts()

    def _correct(self, token: str, at: int) -> int:
        """Read an unknown token as the word that it is a slip of; how many tokens that were."""
        # Only where it is surely one known word; anything less is a hint in the error.
        own = looks_of(self.got.thing)
        close = corrected_phrase(self._tokens.words[at:])
        end = at + max(len(close.split()), 1)
        close = close or corrected(token, own, bool(self.got.thing))
        is_known = close in (*WITHOUT, *own) or look_up(close, self.known) is not None
        if not close or not is_known:
            return self._leave_out(token, 1)
        self.got.notes.append(f"{' '.join(self._tokens.words[at:end])!r} is read as {close!r}.")
        self._tokens.words[at:end] = close.split()
        return self._take(at)  # it may begin a phrase: "a wizzard hat"

    def _leave_out(self, unknown: str, count: int) -> int:
        """Leave an unknown word, or a phrase of ``count``, out."""
        self.got.left_out.append(unknown)
        self._strange = True
        # What goes with the thing may be unknown, the thing itself may not.
        if self._accessory is None:
            self._pending.append(unknown)
        return count

    def _put(self, entry: Entry, start: int, end: int) -> None:
        self._strange = False  # what was unknown before it described it
        if self._alone and entry.form in ALONE and not self.got.found["noun"] and self._stands(end):
            entry = Entry("noun", ALONE[entry.form], entry.form)
        if entry.form in GEMS and self._has_gems():  # "a ring with an emerald"
            self._put(Entry("color", GEMS[entry.form], GEMS[entry.form]), start, end)
            entry = Entry("part", "gem", entry.form)
        owner = entry.slot == "noun" and self._is_owner(entry, end)
        if owner and self._tokens.has_thing(end):  # "a knight's shield"
            self._leave_out(entry.form, end - start)
            return
        if self._is_beside(entry, start, end):  # "a mermaid on a rock"
            self._leave_aside(entry.form)
            return
        slot, word = entry.slot, entry.word
        if slot == "noun" and self._is_depicted(entry):
            return
        if word == "glowing" and start == self._aside_end:  # "with a candle glowing inside"
            self.got.left_out.append(entry.form)
            return
        if slot == "shape" and self._is_of_material(entry, end):
            self.got.leave_aside([entry.form], "only the whole thing has a shape")
            return
        if slot == "weather" and self._without:  # "without scratches"
            self.got.left_out.append(entry.form)
            return
        # "with a hat" after the noun is a part; "a hat" is a thing
        if slot == "noun" and self.got.found["noun"]:
            noun = self.got.thing
            # "pirate boots" are no pirate: what somebody wears is a thing by itself.
            worn = self._noun_end == start and noun in GROUPS["Characters"]
            part = "" if worn else as_part(entry, noun)
            if not part and self._is_said_of(entry, start):
                self.got.left_out.append(entry.form)
                self._noun_end = end if self._noun_end == start else -1
                return
            slot, word = ("part", part) if part else (slot, word)
            if slot == "noun" and self._late and self._noun_end < 0 and self._accessory is None:
                self._accessory = self._begun  # ", green silk curtains"
            if slot == "noun" and self._without:  # "a cake without candles"
                slot = "part"
            if slot == "noun" and self._accessory is not None:
                self._leave_aside(entry.form)
                self._aside_end = end
                return
        if slot == "part" and not self.got.found["noun"] and entry.form not in LEXICON:
            # Until the phrase ends: before a noun ("a fin whale") it only qualifies that.
            self._before.append(StatedPart(word, not self._without, entry.form))
        elif slot == "part" and self._is_head(word, start):
            self.got.refused.append(f"{self.got.found['noun'][-1].form} {entry.form}")
        elif slot == "part":
            self._note_whole(word, entry.form, start)
            self._state(word, entry.form)
            self._end_phrase()
        else:
            if slot == "noun":
                self._head(entry, start, end)
            self.got.found[slot].append(entry)
        begun = self._begun if self._late and self._accessory is None else self._accessory
        if slot == "pattern" and entry.form in FIGURES and begun is not None:
            # "with orange stripes and a lid": it is complete, and what it lies on is not orange.
            colors = self.got.found["color"]
            if begun["color"] == 0 and len(colors) == 1:
                self.got.figure = colors[0]
            self._accessory = self._accessory and self.got.counts()
        if slot in LOOKS and self.got.found["noun"]:
            self._looks.append(slot)
        elif slot != "weather":
            self._looks = []
        if slot in ("noun", "part"):
            self._without = False

    def _state(self, part: str, form: str) -> None:
        """ "with a blue leather handle": what is right before a part is the part's, not the
        thing's."""
        own = {look: self.got.found[look].pop() for look in dict.fromkeys(self._looks)}
        own |= self._clearest(own)
        if "shape" in own:
            self.got.leave_aside([own["shape"].form], "only the whole thing has a shape")
        begun = (self._accessory or {}).get("weather", len(self.got.found["weather"]))
        for one in self.got.found["weather"][begun:]:  # "with a mossy roof"
            self.got.found["weather"].remove(one)
            self.got.leave_aside([one.form], f"only the whole thing can be {one.word}")
        # "with a red and white striped sail": the first of two is what the other is drawn on.
        color, second = own.get("color"), None
        if "pattern" in own and color and self._ended_by == "and" and (red := self._color_before()):
            color, second = red, color
        self.got.left_out += self._of_accessory()
        if self._without:  # "without a red chimney"
            self.got.parts.append(StatedPart(part, False, form))
            return
        colors = [(one.word, shade(*one[1:])) if one else ("", "") for one in (color, second)]
        sheen, pattern = (own[look].word if look in own else "" for look in ("sheen", "pattern"))
        said = (form, *colors[0], own.get("material"), sheen, pattern, *colors[1])
        self.got.parts.append(StatedPart(part, True, *said))

    def _clearest(self, own: dict[str, Entry]) -> dict[str, Entry]:
        """Of several looks of a slot right before a part the one that says most, in the place of
        the last: "with gold metal legs", "a tortoiseshell acetate frame"."""
        clearest = {}
        for look, last in own.items():
            more = [self.got.found[look].pop() for _ in range(self._looks.count(look) - 1)]
            each = [last, *more]
            clearest[look] = max(each, key=lambda x: (x.form not in PLAIN, has_own_look(x.form)))
            plain = (one.form for one in each if one.form not in PLAIN)
            self.got.left_out += [form for form in plain if form != clearest[look].form]
        return clearest

    def _color_before(self) -> Entry | None:
        """Take back the one colour that the phrase about what goes with the thing began with."""
        begun = (self._accessory or {}).get("color", 0)
        colors = self.got.found["color"]
        return colors.pop() if self._accessory and len(colors) == begun + 1 else None

    def _stands(self, end: int) -> bool:
        """Whether a phrase ends before the token ``end`` and is no quality of another: "a rock with
        moss", but "orange and blue", "in orange"."""
        return self._ended_by not in ("and", "in", "with") and self._tokens.ends_phrase(end)

    def _is_beside(self, entry: Entry, start: int, end: int) -> bool:
        """Whether a material or a colour is another thing, which goes with the thing."""
        stands = entry.slot in ("material", "color") and entry.form in ALONE and self._stands(end)
        stands |= entry.form == RAINBOW and self._tokens.ends_phrase(end)
        if not stands or self._accessory is None:
            return False
        before = self._tokens.words[: self._tokens.qualities_begin(start)]
        while before and before[-1] in FILLER - PHRASE_ENDS:  # "on a small rock"
            before.pop()
        return bool(before) and before[-1] in ARTICLES

    def _is_depicted(self, entry: Entry) -> bool:
        """Whether ``entry`` and the noun before it are a thing and its depiction: "a statue of a
        lion", "a lion statue". The thing is made then."""
        nouns = self.got.found["noun"]
        if len(nouns) != 1 or nouns[0].word == entry.word:
            return False
        before = nouns[0]
        if before.form in DEPICTIONS and self._accessory is not None and self._ended_by == "of":
            nouns[:] = [entry]
            self._accessory = None
            thing, depiction = entry, before
        elif entry.form in DEPICTIONS and self._noun_end >= 0:
            thing, depiction = before, entry
        else:
            return False
        self.got.notes.append(f"{depiction.form}: made as {with_article('noun', thing.word)}.")
        return True

    def _lacks_more(self, tokens: list[str]) -> bool:
        """Whether a list of what is lacking goes on: "without wheels or windows", "without wheels
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

    def _has_gems(self) -> bool:
        return any(own_name(noun.word, "gem") for noun in self.got.found["noun"])

    def _is_owner(self, entry: Entry, end: int) -> bool:
        """Whether what follows is the noun's: "a knight's shield", "a knights shield"."""
        living = any(entry.word in GROUPS[group] for group in ALIVE)
        plural = self._tokens.words[end - 1] == f"{entry.form}s"
        return (living and plural) or end - 1 in self._tokens.owners

    def _is_of_material(self, entry: Entry, end: int) -> bool:
        """Whether a shape is that of the material behind it: "a bottle of thick clear glass"."""
        if entry.word not in ("thick", "thin"):
            return False
        looked = ((look_up(phrase, self.known), phrase) for phrase in self._tokens.phrases(end))
        found = next(((one, phrase) for one, phrase in looked if one), None)
        if found is None or found[0].slot != "material":
            return False
        return self._tokens.ends_phrase(end + len(found[1].split()))

    def _is_said_of(self, entry: Entry, start: int) -> bool:
        """Whether a noun only says more of the thing: "a goblin archer", "a goblin, character"."""
        living = any(self.got.thing in GROUPS[group] for group in ALIVE)
        role = living and self._noun_end == start and entry.word in ROLES
        return role or (self._late and self._accessory is None and entry.form in DEPICTIONS)

    def _note_whole(self, part: str, form: str, start: int) -> None:
        """Of "a sword handle" the whole sword is made."""
        if self._noun_end == start and not self._without:
            noun = self.got.found["noun"][-1]
            if not may_state(noun.word, part):
                whole = with_article("noun", noun.word)
                self.got.notes.append(f"{noun.form} {form}: made as {whole}, whole.")

    def _is_head(self, part: str, start: int) -> bool:
        """Whether a part that the thing right before it has not is the thing that is meant: "a
        guitar case"."""
        if self._noun_end != start or self._without or part in SURFACE:
            return False
        noun = self.got.found["noun"][-1].word
        has = own_name(noun, part) and not is_wide(noun, part)
        return not (may_state(noun, part) or has or part in LEGS)

    def _leave_strange_parts_aside(self) -> None:
        why = f"{with_article('noun', self.got.thing)} has none here" if self.got.thing else ""
        for part in self.got.strange_parts():
            of = part.material.form if part.material else ""
            words = (part.color_form or part.color, of, part.pattern, part.form)
            self.got.leave_aside([" ".join(filter(None, words))], why)

    def _make_as_qualified(self) -> None:
        """ "A robot dog" is of metal, where nothing else is said."""
        for form in AS_MATERIAL.keys() & set(self.got.qualifiers):
            if not self.got.found["material"]:
                self.got.left_out.remove(form)
                self.got.notes.append(f"{form}: made as {AS_MATERIAL[form]}.")
                self.got.found["material"].append(Entry("material", AS_MATERIAL[form], form))

    def _leave_aside(self, form: str, why: str = "one thing is made at a time") -> None:
        self.got.leave_aside([*self._of_accessory(), form], why)

    def _of_accessory(self) -> list[str]:
        """Take back the colours and the like that were read in a phrase about an accessory, since
        they are not the thing's; their forms."""
        return self._taken_back(self._accessory or {})

    def _taken_back(self, before: dict[str, int]) -> list[str]:
        self._looks = []
        return self.got.taken_back(before)

    def _looks_before(self) -> list[str]:
        """Take back the colours and the like right before; their forms."""
        slots, self._looks = self._looks, []
        return [self.got.found[slot].pop().form for slot in reversed(slots)][::-1]

    def _head(self, noun: Entry, start: int, end: int) -> None:
        """``noun`` ends a compound: what is unknown before it qualifies it, and so does another
        noun right before it ("desk lamp")."""
        # Also of "a train station clock".
        between = len(self._pending)
        follows = self._noun_end >= 0 and self._noun_end + between == start
        if follows and self.got.found["noun"][-1].word != noun.word:
            form = self.got.found["noun"].pop().form
            self.got.left_out.append(form)
            self.got.qualifiers.append(form)
        parts = [part.name for part in self._before]
        self.got.left_out += parts
        self.got.qualifiers += [*parts, *self._pending]
        self._pending, self._before, self._noun_end = [], [], end
