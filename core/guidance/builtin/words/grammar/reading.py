"""A prompt's words, sorted into slots: the grammar of the built-in prior. Standard library only."""

import re

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.variants import has_own_look
from core.guidance.builtin.words.grammar.accents import StatedPart
from core.guidance.builtin.words.grammar.clauses import EITHER, NOT_GIVEN
from core.guidance.builtin.words.grammar.compounds import set_parts_apart
from core.guidance.builtin.words.grammar.contents import set_contents_first
from core.guidance.builtin.words.grammar.counts import set_counts_apart
from core.guidance.builtin.words.grammar.findings import NOT_APART, with_article
from core.guidance.builtin.words.grammar.lexicon import (
    LEXICON,
    MEANT,
    Entry,
    Vocabulary,
    corrected,
    corrected_phrase,
    look_up,
    singulars,
)
from core.guidance.builtin.words.grammar.look_order import set_looks_in_order
from core.guidance.builtin.words.grammar.mixture import distribute_materials, make_steampunk
from core.guidance.builtin.words.grammar.name_order import set_names_in_order
from core.guidance.builtin.words.grammar.part_names import (
    as_part,
    has_legs,
    is_own,
    is_within,
    looks_of,
    may_state,
    owns,
)
from core.guidance.builtin.words.grammar.stature import Stature
from core.guidance.builtin.words.grammar.tokens import DOING, TRADE, describes
from core.guidance.builtin.words.tables.colors import CALLED_SHADES, shade
from core.guidance.builtin.words.tables.count_words import number_of
from core.guidance.builtin.words.tables.kind_sizes import YOUNG
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.part_tables import LEGS
from core.guidance.builtin.words.tables.words import (
    ALONE,
    ARTICLES,
    AS_MATERIAL,
    COUNTS,
    FIGURES,
    FILLER,
    GEMS,
    GOES_WITH,
    HOW_MADE,
    IGNORED_ADJECTIVES,
    LOOKS,
    OF_ANOTHER,
    OF_PICTURES,
    PART_SIZES,
    PHRASE_ENDS,
    PLAIN,
    PLUSHIES,
    SIZE_WORDS,
    SURROUNDINGS,
    TOYS,
    WITHOUT,
)

# Things that describe a part behind them.
AS_LOOKS = CALLED_SHADES | {name: AS_MATERIAL[name] for name in ("bone", "crystal")}
ALSO_ACTIONS = ("playing cards",)  # after a thing's name: "a robot playing cards"
AHEAD = 6  # words in which a thing may still come


class Reading(Stature):
    """A prompt's words, sorted into slots.

    ``alone``: a phrase ends in a thing if it can be one: "a grey rock" is a boulder.
    """

    def __init__(self, prompt: str, known: Vocabulary, alone: bool = False) -> None:
        super().__init__(prompt, known, alone)
        self.got.sizes = self._tokens.sizes
        self.got.left_out += self._tokens.measures
        set_contents_first(self._tokens)
        self.got.counted = set_counts_apart(self._tokens)
        set_names_in_order(self._tokens)
        set_looks_in_order(self._tokens)
        self.got.notes += self._tokens.notes
        set_parts_apart(self._tokens)
        at = 0
        while at < len(self._tokens.words):
            if at in self._tokens.breaks:
                self._end_clause()
            at += self._take(at)
        self._end_phrase()
        self._leave_strange_parts_aside()
        self._set_its_gem()
        self._make_as_qualified()
        self._leave_its_film()
        self._shade_as_qualified()
        self._leave_as_woven()
        self._leave_its_fire()
        self._spare_the_living()
        distribute_materials(self.got, self._tokens)
        make_steampunk(self.got, self._tokens)
        self._set_depicted()
        self._darken_its_stripes()
        self._look_like_its_kind()
        self._set_size()
        self._set_roundness()
        self._set_age()

    def _take(self, at: int) -> int:
        """Parse from the token ``at`` on; the number of parsed tokens."""
        tokens = self._tokens.words[at:]
        token = tokens[0]
        if self._is_wider(token, at):  # "a corgi puppy", "a fox animal"
            self._noun_end = at + 1
            self.got.young += [form for form in singulars(token) if form in YOUNG]
            return 1
        if toned := self._tokens.toned(at):
            self._put(toned[0], at, at + toned[1])
            return toned[1]
        for phrase in self._tokens.phrases(at):
            entry, count = look_up(phrase, self.known), len(phrase.split())
            if entry is not None and self._is_part_of_look(entry, tokens[:count]):
                continue
            if entry is not None and self._is_thing_and_color(entry, at, count):
                continue
            if entry is not None and self._is_look_of_thing(entry, at, count):
                continue
            if entry is not None and self._is_before_name(entry, at, count):
                continue
            if (entry is None or entry.slot not in ("noun", "part")) and self._is_own(phrase):
                entry = Entry("part", phrase, phrase)
            if entry is not None and self._is_stone(entry, at + count):
                entry = Entry("part", "gem", entry.form)
            if phrase in ALSO_ACTIONS and self.got.found["noun"]:
                entry = None
            if entry is not None and self._are_things(entry, phrase):
                return self._leave_out(phrase, count)
            if entry is not None:
                self._put(entry, at, at + count)
                return count
            if phrase in TOYS and self._accessory is None:  # not "a child with a toy"
                self._take_toy(phrase)
                return count
            if count > 1 and (phrase in HOW_MADE or phrase in OF_PICTURES):
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
            self._end_phrase()
            self._without = True
        elif token in SIZE_WORDS and at in self._tokens.owners:  # "a giant's club"
            self.got.left_out.append(token)
        elif token in SIZE_WORDS and self._without:
            self.got.leave_aside(["not", token], NOT_GIVEN)
            self._without = bool(self.got.found["noun"])  # "a not too big red car"
        elif token in SIZE_WORDS and self._is_its_size(at):
            self.got.size_words.append(token)
        elif token in SIZE_WORDS:
            if token != "little":  # "a little rusty"
                self._part_sizes.append(token)
        elif self._is_manner(token, at) or token in HOW_MADE:  # "painted white"
            pass
        elif token in IGNORED_ADJECTIVES and not corrected_phrase(tokens):
            self.got.left_out.append(token)
            if token in AS_MATERIAL and not (self.got.found["noun"] or self._without):
                self.got.qualifiers.append(token)
        elif token in COUNTS and not self.got.found["noun"]:
            self.got.notes.append(f"{token}: one thing is made at a time.")
        elif token in COUNTS or number_of(token) > 1:
            self.got.left_out.append(token)
            self._number = token
        elif number_of(token) and self.got.found["noun"]:
            self._number = token
        elif token in PHRASE_ENDS:
            negated = self._without and bool(self._looks) and token in EITHER  # "not red or blue"
            if not self._goes_on(token, at):
                self._leave_what_it_is_not()
                self._without = False
            self._without |= self._lacks_more(tokens)
            if token in EITHER and not (self._without or negated):  # "red or blue": it is both
                self.got.left_out.append(token)
            # "a statue of a lion": the article has no meaning.
            word = self._ended_by if token in ARTICLES else token
            if self.got.found["noun"] and (token in GOES_WITH or self._accessory is not None):
                self._go_with(word)
            else:
                self._end_phrase()
                self._ended_by = word
            self._has_article = token in ARTICLES
            self._without |= negated
        elif token in SURROUNDINGS:  # "a candle, soft pink lighting"
            self.got.left_out += [*self._looks_before(), token]
        elif self.got.found["noun"] and DOING.fullmatch(token):
            self.got.left_out.append(token)
            if self._is_of_part(at):  # "with green flickering eyes"
                return 1
            # "a robot playing guitar"
            self._go_with(token)
            self._of_another = True
        elif self._is_trade(token, at):
            self.got.left_out.append(token)
        elif token == "shaped" and self._noun_end == at:
            # "a heart shaped box": as if the two nouns were next to each other.
            self._noun_end += 1
        elif token not in FILLER and describes(token) and not corrected(token):
            # "a raccoon dressed up", "a rolled up mat", "1950s"; "a wall mounted radiator"
            self.got.left_out.append(token)
            self._noun_end += self._noun_end == at
        elif token not in FILLER:
            return self._correct(token, at)
        return 1

    def _is_of_part(self, at: int) -> bool:
        """Whether the word only describes the following part of the thing."""
        end = self._tokens.qualities_end(at + 1, LOOKS)
        part = "".join(self._tokens.words[end : end + 1])
        return self._tokens.qualities_begin(at, LOOKS) < at and owns(self.got.thing, part)

    def _is_trade(self, token: str, at: int) -> bool:
        """Whether an unknown word only names a figure's trade: "a crocodile podiatrist"."""
        behind = self._noun_end == at and is_creature(self.got.thing)
        return behind and TRADE.fullmatch(token) is not None

    def _correct(self, token: str, at: int) -> int:
        """Parse an unknown token as the word that it misspells; the number of parsed tokens."""
        # Only for surely one known word; otherwise it is a hint in the error.
        own = looks_of(self.got.thing)
        close = corrected_phrase(self._tokens.words[at:])
        end = at + max(len(close.split()), 1)
        things = any(map(self._tokens.has_thing, range(at + 1, at + 1 + AHEAD)))
        close = close or corrected(token, own, bool(self.got.thing) or things)
        is_known = close in (*WITHOUT, *own) or look_up(close, self.known) is not None
        if not close or not is_known:
            return self._leave_out(token, 1)
        self.got.notes.append(f"{' '.join(self._tokens.words[at:end])!r} is read as {close!r}.")
        self._tokens.words[at:end] = close.split()
        return self._take(at)  # it may begin a phrase: "a wizzard hat"

    def _put(self, entry: Entry, start: int, end: int) -> None:
        self._strange = False  # what was unknown before it described it
        if (
            self._alone
            and entry.form in ALONE
            and not self.got.found["noun"]
            and self._is_phrase_end(end)
        ):
            entry = Entry("noun", ALONE[entry.form], entry.form)
        if entry.form in GEMS and self._has_gems():  # "a ring with an emerald"
            self._put(Entry("color", GEMS[entry.form], GEMS[entry.form]), start, end)
            entry = Entry("part", "gem", entry.form)
        behind = next(iter(self._tokens.words[end : end + 1]), "")
        goes_on = self.got.thing and end not in self._tokens.breaks
        is_look = entry.slot == "noun" and goes_on and owns(self.got.thing, behind)
        called = AS_LOOKS.get(entry.form, "") if is_look else ""
        if called:  # "with coral cushions", "with a bone handle"
            entry = look_up(called, self.known) or entry
        if entry.form in GEMS and goes_on and is_own(self.got.thing, behind):  # "ruby eyes"
            entry = Entry("color", GEMS[entry.form], GEMS[entry.form])
        owner = entry.slot == "noun" and self._is_owner(entry, end)
        if owner and self._owns_what_follows(end):  # "a knight's shield"
            self._leave_out(entry.form, end - start)
            return
        if self._is_next_to(entry, start, end):  # "a mermaid on a rock"
            self._leave_aside(entry.form)
            return
        if self._is_its_name(entry):
            return
        if self._names_a_part(entry, start, end):  # "with a dolphin base"
            self.got.left_out.append(entry.form)
            return
        slot, word = entry.slot, entry.word
        if slot == "noun" and self._is_depicted(entry):
            if self._tokens.has_thing(end) and end not in self._tokens.breaks:
                self._noun_end = end  # "a statue of a robot dog"
            return
        if word == "glowing" and start == self._aside_end:  # "with a candle glowing inside"
            self.got.left_out.append(entry.form)
            return
        if slot == "shape" and self._is_of_material(entry, end):
            self.got.leave_aside([entry.form], "only the whole thing has a shape")
            return
        if slot == "weather" and self._without:  # "without scratches"
            self.got.left_out.append(entry.form)
            self._without = bool(self.got.found["noun"])  # "a not so old wooden chest"
            return
        if slot == "noun" and self._without and self._is_another(end):  # "not a car but a truck"
            self.got.leave_aside(["not", entry.form], NOT_GIVEN)
            self._without = False
            return
        if slot in LOOKS and self._without and self._looks and not self.got.found["noun"]:
            self._leave_what_it_is_not()  # "a not shiny red car"
            self._without = False
        # "with a hat" after the noun is a part; "a hat" is a thing
        if slot == "noun" and self.got.found["noun"]:
            noun = self.got.thing
            # "pirate boots" are not a pirate: a worn thing is a thing by itself.
            worn = self._noun_end == start and noun in GROUPS["Characters"]
            part = "" if worn else as_part(entry, noun)
            if not part and self._is_description(entry, start):
                if not self._depict(entry.form):
                    self.got.left_out.append(entry.form)
                self._noun_end = end if self._noun_end == start else -1
                return
            slot, word = ("part", part) if part else (slot, word)
            if slot == "noun" and self._late and self._noun_end < 0 and self._accessory is None:
                self._accessory = self._started  # ", green silk curtains"
            if slot == "noun" and self._without:  # "a cake without candles"
                slot = "part"
            if slot == "noun" and (self._accessory is not None or self._is_another_such(entry)):
                within = is_within(noun, entry.form)
                self._leave_aside(entry.form, *([NOT_APART] if within else []))
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
                self._leave_what_it_is_not()
                self._head(entry, start, end)
            self.got.found[slot].append(entry)
            if slot == "material":
                self._take_block(entry, end)
            if slot == "weather" and entry.form.startswith("with ") and self.got.found["noun"]:
                self._accessory = self.got.counts()  # "with moss and a crystal"
        started = self._started if self._late and self._accessory is None else self._accessory
        if slot == "pattern" and entry.form in FIGURES and started is not None:
            # "with orange stripes and a lid": it is complete, and the part below is not orange.
            colors = self.got.found["color"]
            if started["color"] == 0 and len(colors) == 1:
                self.got.figure = colors[0]
            self._accessory = self._accessory and self.got.counts()
        if slot in LOOKS and (self.got.found["noun"] or self._without):
            self._looks.append(slot)
        elif slot != "weather":
            self._looks = []
        if slot in ("noun", "part"):
            self._without = False

    def _state(self, part: str, form: str) -> None:
        """ "With a blue leather handle": the look right before a part is the part's, not the
        thing's."""
        sizes, self._part_sizes = self._part_sizes, []
        number, self._number = self._number, ""
        for _ in range(self._looks.count("shape")):
            shape = self.got.found["shape"].pop().form
            if shape in PART_SIZES:
                sizes.insert(0, shape)
            else:
                self.got.leave_aside([shape], "only the whole thing has a shape")
        self._looks = [look for look in self._looks if look != "shape"]
        own = {look: self.got.found[look].pop() for look in dict.fromkeys(self._looks)}
        own |= self._clearest(own)
        started = (self._accessory or {}).get("weather", len(self.got.found["weather"]))
        for one in self.got.found["weather"][started:]:  # "with a mossy roof"
            self.got.found["weather"].remove(one)
            self.got.leave_aside([one.form], f"only the whole thing can be {one.word}")
        # "with a red and white striped sail": the first of two is the ground of the other.
        color, second = own.get("color"), None
        if "pattern" in own and color and self._ended_by == "and" and (red := self._color_before()):
            color, second = red, color
        self.got.left_out += self._of_accessory()
        if self._without:  # "without a red chimney"
            self.got.parts.append(StatedPart(part, False, form))
            return
        colors = [(one.word, shade(*one[1:])) if one else ("", "") for one in (color, second)]
        sheen, pattern = (own[look].word if look in own else "" for look in ("sheen", "pattern"))
        stated = (form, *colors[0], own.get("material"), sheen, pattern, *colors[1])
        stated += (tuple(sizes), number)
        self.got.parts.append(StatedPart(part, True, *stated))

    def _clearest(self, own: dict[str, Entry]) -> dict[str, Entry]:
        """The most specific of several looks of a slot right before a part, in the place of the
        last: "with gold metal legs", "a tortoiseshell acetate frame"."""
        clearest = {}
        for look, last in own.items():
            more = [self.got.found[look].pop() for _ in range(self._looks.count(look) - 1)]
            each = [last, *more]
            clearest[look] = max(each, key=_says)
            plain = (one.form for one in each if one.form not in PLAIN)
            self.got.left_out += [form for form in plain if form != clearest[look].form]
        return clearest

    def _note_whole(self, part: str, form: str, start: int) -> None:
        """ "A sword handle" is made as the whole sword."""
        if self._noun_end == start and not self._without:
            noun = self.got.found["noun"][-1]
            if not may_state(noun.word, part):
                whole = with_article("noun", noun.word)
                self.got.notes.append(f"{noun.form} {form}: made as {whole}, whole.")

    def _leave_strange_parts_aside(self) -> None:
        for part in self.got.strange_parts():
            why = self._why_strange(part)
            of = part.material.form if part.material else ""
            words = (*part.sizes, part.color_form or part.color, of, part.pattern, part.form)
            self.got.leave_aside([" ".join(filter(None, words))], why)

    def _why_strange(self, part: StatedPart) -> str:
        """The reason why a part that is not a separate part of the thing is left out."""
        whole = with_article("noun", self.got.thing)
        if part.name in LEGS and has_legs(self.got.thing):
            return f"the legs of {whole} are not counted"
        within = is_within(self.got.thing, part.form) or is_within(self.got.thing, part.name)
        return NOT_APART if within else f"{whole} has none here"

    def _head(self, noun: Entry, start: int, end: int) -> None:
        """End a compound with ``noun``: unknown words before it qualify it, and so does another
        noun right before it ("desk lamp")."""
        # Also of "a train station clock".
        behind = self._noun_end + len(self._pending)
        # Also of "a viking round shield".
        follows = self._noun_end >= 0 and behind in (start, self._tokens.qualities_begin(start))
        if follows and self.got.found["noun"][-1].word != noun.word:
            former = self.got.found["noun"].pop()
            form = former.form
            if self._depicted:  # "a statue of a robot dog"
                self._depicts_not(former.word, noun.word)
            if form in GEMS:  # "a ruby heart"; of "a ruby ring" the gem is
                self.got.found["color"].append(Entry("color", GEMS[form], form))
            elif form in PLUSHIES and is_creature(noun.word):
                self._depict(form)  # "a soft toy elephant"
                self.got.notes.append(f"{form}: made as {with_article('noun', noun.word)}.")
            else:
                self.got.left_out.append(form)
                self.got.qualifiers.append(form)
        parts = [part.name for part in self._before]
        self.got.left_out += parts
        self.got.qualifiers += [*parts, *self._pending]
        self._pending, self._before, self._noun_end = [], [], end


def _says(look: Entry) -> tuple[bool, bool, bool]:
    """How specific a look is among several of one part: "a rusted corrugated metal roof"."""
    return look.form not in PLAIN, look.word == "rusty", has_own_look(look.form)
