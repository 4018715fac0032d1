"""A prompt's text as words. Standard library only."""

import re
from dataclasses import dataclass, field

from core.guidance.builtin.words.grammar.lexicon import PARTS, Entry, Vocabulary, look_up
from core.guidance.builtin.words.grammar.measures import Size, set_apart
from core.guidance.builtin.words.tables.colors import OF_MATERIALS, TOWARDS
from core.guidance.builtin.words.tables.words import FILLER, LOOKS, PHRASE_ENDS, SHORT

POSSESSIVE = "'s"
LONGEST = 3  # words of a phrase
DOING = re.compile("[a-z]{3,}ing|doing|going")  # activities
TRADE = re.compile("[a-z]{3,}(?:ist|ian|man|woman|eer)")  # trades
DONE = re.compile("[a-z]{2,}[^e]ed")  # what was done to it
# What it is like; a catfish is a thing.
LIKE = re.compile("[a-z]{3,}(?:ful|ous|(?<!f)ish|less|ical|esque|istic|ural|ly)")
# What was done to it, before how it looks since.
MADE = (
    "made painted done finished covered coated upholstered dyed wrapped carved built woven knitted "
    "cut cast forged crafted constructed fashioned sewn hewn"
).split()
PERSON = "person"
# "Isn't", "does not": a doe is a deer.
NOT = re.compile(
    r"\b(?:(?:do|does|did|can|will) not|cannot|instead of|rather than|never)\b"
    r"|(?:\b(?:do|does|did|ca|wo))?n['\u2019]t\b",
    re.IGNORECASE,
)
# Keys before a colon.
STATED = re.compile(
    r"([,;.(]\s*(?:the )?)([a-z]+)\s*[:=]\s*([^,;:.()=]*[^,;:.()=\s])", re.IGNORECASE
)
KEYS = frozenset(
    """color colour colors colours material materials finish pattern texture style theme look
    made""".split()
)
NUMBER = re.compile("[0-9]+[a-z]{0,2}")  # with its unit: "60", "1950s", "2m"


@dataclass
class Tokens:
    """A prompt's words in lower case; abbreviations are expanded."""

    known: Vocabulary
    words: list[str] = field(default_factory=list)
    breaks: set[int] = field(default_factory=set)  # indices of those that punctuation precedes
    owners: set[int] = field(default_factory=set)  # of possessives, without their s
    sizes: list[Size] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    measures: list[str] = field(
        default_factory=list
    )  # of measurements that are not sizes, as written
    _entries: dict[str, Entry | None] = field(default_factory=dict, repr=False, compare=False)

    @classmethod
    def of(cls, prompt: str, known: Vocabulary) -> "Tokens":
        """The words of a prompt; ``known``: the offered words."""
        found = cls(known)
        prompt = STATED.sub(found._keyed, prompt)
        plain, found.sizes, found.measures = set_apart(NOT.sub(" not", prompt))
        for token in re.findall(r"'s\b|[^\W_]+|[,;:.!?()]", plain):
            if token == POSSESSIVE:
                if found.words:
                    found.owners.add(len(found.words) - 1)
            elif token[0].isalnum():
                found.words.append(SHORT.get(token, token))
            else:
                found.breaks.add(len(found.words))
        found._join_names()
        return found

    @staticmethod
    def _keyed(found: re.Match[str]) -> str:
        """Key-value phrases: "wheels: yellow" means yellow wheels, "material: oak" oak."""
        before, key, value = found.groups()
        if key.lower() in KEYS:
            return f"{before}{value}"
        return f"{before}{value} {key}" if key.lower() in PARTS else found[0]

    def _join_names(self) -> None:
        """Join the halves of a thing's name: "a snow man". "A gold fish" is a fish of gold."""
        for at in reversed(range(len(self.words) - 1)):
            halves = self.words[at : at + 2]
            whole = look_up("".join(halves), self.known)
            apart = look_up(" ".join(halves), self.known) or self._is_quality(at, at + 1, LOOKS)
            first, second = (look_up(half, self.known) for half in halves)
            # "A hammer head", "a box wood and metal"; "a dog that has sock".
            own = first and first.slot == "noun" and second and second.slot in ("part", *LOOKS)
            ends = at in self.owners or at + 1 in self.breaks or halves[0] in FILLER
            if whole and whole.slot == "noun" and not (apart or own or ends or len(halves[1]) < 3):
                self.cut(at, at + 1)
                self.words[at] = "".join(halves)

    def cut(self, begin: int, end: int) -> None:
        """Take out the words from one index up to another."""
        del self.words[begin:end]
        gone = end - begin
        self.breaks = {k if k <= begin else max(k - gone, begin) for k in self.breaks}
        self.owners = {k if k < begin else k - gone for k in self.owners if not begin <= k < end}

    def put(self, begin: int, end: int, words: list[str]) -> None:
        """Replace the words from one index up to another."""
        if (more := len(words) - (end - begin)) > 0:
            self.words[end:end] = [""] * more
            self.breaks = {k + more if k >= end else k for k in self.breaks}
            self.owners = {k + more if k >= end else k for k in self.owners}
        else:
            self.cut(begin + len(words), end)
        self.words[begin : begin + len(words)] = words
        self.owners -= set(range(begin, begin + len(words)))

    def add_clause(self, words: list[str]) -> None:
        """Put words behind the rest, after a comma."""
        self.breaks.add(len(self.words))
        self.words += words

    def phrases(self, at: int) -> list[str]:
        """The phrases at the index, the longest first: "ice cream" is not the colour "cream"."""
        # Not across a comma: "a car, wheels silver" is no car wheel.
        ends = (k for k in range(at + 1, at + LONGEST) if k in self.breaks)
        words = self.words[at : next(ends, at + LONGEST)]
        return [" ".join(words[:count]) for count in range(len(words), 0, -1)]

    def toned(self, at: int) -> tuple[Entry, int] | None:
        """The colour or the material with the tone at the index, and its number of words: "dark
        teal", "light oak". None where the whole is a word by itself."""
        tone = self.words[at] if at < len(self.words) else ""
        if tone not in TOWARDS:
            return None
        slots = ("color", "material") if tone in OF_MATERIALS else ("color",)
        for phrase in self.phrases(at + 1):
            entry = look_up(phrase, self.known)
            if entry is not None:
                own = entry.slot not in slots or look_up(f"{tone} {phrase}", self.known)
                form = f"{tone} {entry.form}"
                return None if own else (entry._replace(form=form), 1 + len(phrase.split()))
        return None

    def qualities_begin(self, end: int, slots: tuple[str, ...] = (*LOOKS, "weather")) -> int:
        """The start of the colours, materials and so on right before the index."""
        begin = end
        while begin and begin not in self.breaks:
            counts = range(min(LONGEST, begin), 0, -1)
            step = next((k for k in counts if self._is_quality(begin - k, begin, slots)), 0)
            if not step:
                break
            begin -= step
        return begin

    def qualities_end(self, begin: int, slots: tuple[str, ...]) -> int:
        """The end of the colours, materials and so on at the index."""
        end = begin
        while end < len(self.words) and (end == begin or end not in self.breaks):
            phrases = (phrase.split() for phrase in self.phrases(end))
            step = next((len(p) for p in phrases if self._is_quality(end, end + len(p), slots)), 0)
            if not step:
                break
            end += step
        return end

    def _is_quality(self, begin: int, end: int, slots: tuple[str, ...]) -> bool:
        if self.breaks.intersection(range(begin + 1, end)):
            return False
        phrase = " ".join(self.words[begin:end])
        entry = look_up(phrase, self.known)
        return phrase in TOWARDS or (entry is not None and entry.slot in slots)

    def entry(self, phrase: str) -> Entry | None:
        """The meaning of the phrase by itself, if any; looked up once."""
        if phrase not in self._entries:
            self._entries[phrase] = look_up(phrase, self.known)
        return self._entries[phrase]

    def thing(self, phrase: str) -> str:
        """The thing that the phrase names, or ""."""
        entry = self.entry(phrase)
        return entry.word if entry is not None and entry.slot == "noun" else ""

    def take_first(self, begin: int, end: int) -> None:
        """Move the words between the indices, a clause, before all others."""
        order = [*range(begin, end), *range(begin), *range(end, len(self.words))]
        place = {old: new for new, old in enumerate([*order, len(order)])}
        # Punctuation precedes now what was first.
        self.breaks = {place[k] for k in self.breaks - {begin} | {0}}
        self.owners = {place[k] for k in self.owners}
        self.words = [self.words[k] for k in order]

    def first_thing(self, at: int) -> str:
        """The thing whose name starts at the index, or ""."""
        return next(filter(None, map(self.thing, self.phrases(at))), "")

    def has_thing(self, at: int) -> bool:
        """Whether a thing's name starts at the index."""
        return at < len(self.words) and bool(self.first_thing(at))

    def ends_phrase(self, end: int) -> bool:
        """Whether a phrase ends before the index, without an "and" behind it."""
        if end in (*self.breaks, len(self.words)):
            return True
        after = self.words[end]
        return after in PHRASE_ENDS - {"and"} or DOING.fullmatch(after) is not None


def describes(word: str) -> bool:
    """Whether an unknown word is only a description, not a name."""
    return any(form.fullmatch(word) for form in (DONE, LIKE, NUMBER))
